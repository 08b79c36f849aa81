/*
 * narrowphase/touch.c - the manifold of two shapes from their poses and velocities.
 *
 * Contact margin: slow pairs touch within four slops (speculative contact), thin ones within half the thickness of the thinner
 * shape. Fast pairs touch within the distance that they approach in the step, so that they meet at the surface and not inside each
 * other; points that their motion does not reach are dropped.
 */
#include "narrowphase/touch.h"
#include "collision/manifold.h"

#if defined(CNI_DEBUG)
static int32_t record_is_of_motion(const cn_world *world, const cni_body *b)
{
	const cni_motion *m = cni_motions(world) + b->awake;
	return b->vx == m->vx && b->vy == m->vy && b->w == m->w;
}
#endif

/* Inner radius of the thinner shape; edges and chains have none. */
static float thinner_radius(const cni_manifold_input *in)
{
	float a = in->a->inner_radius, b = in->b->inner_radius;
	return cni_min(a > 0.0f ? a : FLT_MAX, b > 0.0f ? b : FLT_MAX);
}

/*
 * In a pack of thin shapes four slops span several of them, so each would touch many; half a thickness does not span one.
 * With a static body the margin also covers the fall of the step; where both bodies move, gravity moves both alike.
 */
static float pair_margin(const cn_world *world, const cni_body *a, const cni_body *b, const cni_manifold_input *in, float dt)
{
	float most = world->settings.contact_margin, thin;
	if (in->a->inner_radius >= most && in->b->inner_radius >= most)
		return most;
	thin = thinner_radius(in);
	if (a->awake == 0 || b->awake == 0)
		thin += cni_length(world->settings.gravity) * dt * dt;
	return cni_min(thin, most);
}

/* Reads velocities from the records, which equal motion at the beginning of a step. */
static cni_pair_motion motion_make(const cni_body *a, const cni_body *b, float dt)
{
	cni_pair_motion m;
	m.v = cni_unrotate(a->q, cni_v(b->vx - a->vx, b->vy - a->vy));
	m.wa = a->w;
	m.wb = b->w;
	m.reach = dt * (cni_length(m.v) + cni_abs(m.wa) * cni_body_turn_reach(a) + cni_abs(m.wb) * cni_body_turn_reach(b));
	return m;
}

/* Closing speed of the surfaces at a point. */
static float closing_at(const cni_manifold *out, int32_t k, const cni_pair_motion *m, const cni_body *a, cni_vec2 b_center)
{
	cni_vec2 p = out->points[k].point, ra = cni_sub(p, a->local_center), rb = cni_sub(p, b_center);
	cni_vec2 v = cni_add(m->v, cni_sub(cni_mul(m->wb, cni_left_perp(rb)), cni_mul(m->wa, cni_left_perp(ra))));
	return -cni_dot(out->normal, v);
}

/* Keeps points within the margin and points that the motion reaches within the step; for any other point the normal remains a
   separating axis. Returns the least separation kept. */
static float drop_unreached(cni_manifold *out, const cni_pair_motion *m, const cni_body *a, cni_vec2 b_center, float margin, float dt)
{
	int32_t kept = 0;
	float nearest = FLT_MAX;
	for (int32_t k = 0; k < out->count; ++k) {
		float separation = out->points[k].separation;
		if (separation > margin && separation > margin + cni_max(closing_at(out, k, m, a, b_center), 0.0f) * dt)
			continue;
		nearest = cni_min(nearest, separation);
		if (kept < k)
			out->points[kept] = out->points[k];
		++kept;
	}
	out->count = kept;
	return nearest;
}

/* Greatest depth behind the points' planes that the motion reaches in dt; 0 when the separation of some point is least or less. */
static float depth_ahead(const cni_manifold *out, const cni_pair_motion *m, const cni_body *a, cni_vec2 b_center, float least, float dt)
{
	float depth = 0.0f;
	for (int32_t k = 0; k < out->count; ++k) {
		if (out->points[k].separation <= least)
			return 0.0f;
		depth = cni_max(depth, closing_at(out, k, m, a, b_center) * dt - cni_max(out->points[k].separation, 0.0f));
	}
	return depth;
}

/*
 * Do the shapes at most graze each other? Their projections along the relative velocity do not change while they move along it:
 * shapes whose projections overlap by at most the slop never overlap deeper. So the corner of the next piece of flat ground does
 * not stop a body that slides over it. Where the motion passes a plane by a hair only, as in sliding, or passes it in the substep
 * after the step, for which the solver brakes too, the contact is dropped only if the projections are clear of each other.
 */
static int32_t shadows_graze(const cni_manifold_input *in, const cni_pair_motion *m, const cni_body *a, const cni_body *b, float depth, float dt)
{
	float speed = cni_length(m->v), hair = 0.1f * in->slop, most;
	float turn = dt * (cni_abs(m->wa) * (a->extent - in->a->radius) + cni_abs(m->wb) * (b->extent - in->b->radius));
	cni_transform along, b_along;
	if (speed * dt <= hair || turn > in->slop)
		return 0;
	along.q.c = m->v.x / speed; /* turns the motion to +x: the projections are intervals of y */
	along.q.s = -m->v.y / speed;
	along.t = cni_v(0.0f, 0.0f);
	b_along.q = cni_rot_mul(along.q, in->b_in_a.q);
	b_along.t = cni_rotate(along.q, in->b_in_a.t);
	cni_aabb box_a = cni_geometry_aabb(in->a, in->child_a, along);
	cni_aabb box_b = cni_geometry_aabb(in->b, in->child_b, b_along);
	most = depth > hair ? cni_min(in->slop, 0.5f * thinner_radius(in)) : -hair; /* a thin shape that moves end first does not graze */
	return cni_min(box_a.y1, box_b.y1) - cni_max(box_a.y0, box_b.y0) + turn <= most;
}

static cni_path path_ahead(const cni_body *b, cni_vec2 from, const cni_motion *m, float dt)
{
	return cni_body_path(b, from, cni_mul(dt, cni_v(m->vx, m->vy)), dt * m->w);
}

/* A shape deeper than the contact margin behind a surface does not lie on it. */
static void mend_seams(const cn_world *world, const cni_manifold_input *in, cni_vec2 way, cni_manifold *m)
{
	if (m->count > 0 && (cni_seams_of(in->a) | cni_seams_of(in->b)) != 0)
		cni_seams_mend(in, way, world->settings.contact_margin, m);
}

/*
 * For a contact that is still ahead: moves the shapes to their time of impact, computes the manifold there, and traces its points
 * back to the present poses. So a fast body collides with the surface that it will hit, and not with the plane of the nearest
 * feature.
 */
static void meet(const cn_world *world, const cni_body *a, const cni_body *b, const cni_manifold_input *near, float dt, cni_touch *out)
{
	cni_manifold_input in = *near;
	cni_manifold_cache cache = { 0, { 0, 0, 0 } };
	cni_vec2 from = cni_v(a->cx, a->cy);
	const cni_motion *motions = cni_motions(world);
	cni_path path_a = path_ahead(a, from, &motions[a->awake], dt), path_b = path_ahead(b, from, &motions[b->awake], dt);
	float slop = world->settings.slop;
	cni_toi_input toi = { in.a, in.b, in.child_a, in.child_b, path_a, path_b, 0.5f * slop, 0.25f * slop };
	cni_toi_result hit = cni_toi(&toi);
	if (hit.state == CNI_TOI_SEPARATED)
		out->result.manifold.count = 0;
	if (hit.state != CNI_TOI_HIT)
		return;
	cni_transform xa = cni_path_at(&path_a, hit.fraction);
	cni_transform xb = cni_path_at(&path_b, hit.fraction);
	in.b_in_a.q = cni_rot_between(xa.q, xb.q);
	in.b_in_a.t = cni_untransform_point(xa, xb.t);
	in.margin = world->settings.contact_margin;
	cni_manifold_function(in.a->type, in.b->type)(&in, &cache, &out->result.manifold);
	mend_seams(world, &in, cni_mul((1.0f - hit.fraction) * dt, out->motion.v), &out->result.manifold);
	if (out->result.manifold.count == 0)
		return;
	cni_transform a_now = cni_path_at(&path_a, 0.0f);
	cni_transform b_now = cni_path_at(&path_b, 0.0f);
	out->result.manifold.normal = cni_unrotate(a_now.q, cni_rotate(xa.q, out->result.manifold.normal));
	for (int32_t k = out->result.manifold.count - 1; k >= 0; --k) { /* the gap of the first point stays */
		cni_manifold_point *p = &out->result.manifold.points[k];
		cni_vec2 on_b = cni_untransform_point(in.b_in_a, p->point);
		cni_vec2 apart = cni_sub(cni_transform_point(b_now, on_b), cni_transform_point(a_now, p->point));
		out->result.gap = cni_unrotate(a_now.q, apart);
		p->separation += cni_dot(out->result.manifold.normal, out->result.gap);
	}
}

/* A place in the square of side 2 around the origin; places of n successive bodies fill it evenly (Roberts, "The unreasonable
   effectiveness of quasirandom sequences", 2018). */
static cni_vec2 place_of_body(int32_t body)
{
	uint32_t x = (uint32_t)body * 3242174889u, y = (uint32_t)body * 2447445414u;
	return cni_v((float)(int32_t)x * 4.6566129e-10f, (float)(int32_t)y * 4.6566129e-10f);
}

/*
 * The direction between the centres of bodies made in one spot is undefined, and most manifold functions take it from a fixed axis:
 * then n bodies become a column as high as n of them, which leaves its spot upwards at a hundred times the push speed. So centres
 * closer than a ten-thousandth of the slop count as apart by as little, each body at a place of its own.
 */
static cni_vec2 centers_apart(const cn_world *world, const cni_touch_pair *p, cni_vec2 centers)
{
	float least = CNI_COINCIDENT_PER_SLOP * world->settings.slop;
	if (cni_abs(centers.x) > least || cni_abs(centers.y) > least || p->body[0]->type != CN_BODY_DYNAMIC || p->body[1]->type != CN_BODY_DYNAMIC)
		return centers;
	return cni_add(centers, cni_mul(least, cni_sub(place_of_body(p->contact->body[1]), place_of_body(p->contact->body[0]))));
}

int32_t cni_touch_begin(const cn_world *world, const cni_touch_pair *p, float dt, cni_touch *out)
{
	const cni_body *a = p->body[0], *b = p->body[1];
	out->contact = p->contact;
	out->a = a;
	out->b = b;
	CNI_ASSERT(dt == 0.0f || (record_is_of_motion(world, a) && record_is_of_motion(world, b)));
	out->boxes_overlap = cni_aabb_overlap(&p->proxy[0]->fat, &p->proxy[1]->fat);
	out->result.manifold.count = 0;
	if (!out->boxes_overlap)
		return 0;
	cni_vec2 centers = centers_apart(world, p, cni_body_a_to_b(a, b));
	out->motion = motion_make(a, b, dt);
	out->in.a = cni_proxy_geometry(&world->blocks, p->proxy[0]);
	out->in.b = cni_proxy_geometry(&world->blocks, p->proxy[1]);
	out->result.radius[0] = out->in.a->radius;
	out->result.radius[1] = out->in.b->radius;
	out->in.child_a = cni_proxy_child(p->proxy[0]);
	out->in.child_b = cni_proxy_child(p->proxy[1]);
	out->in.b_in_a = cni_body_b_in_a(a, b, centers);
	out->in.slop = world->settings.slop;
	out->motion.margin = pair_margin(world, a, b, &out->in, dt);
	out->in.margin = cni_max(out->motion.margin, out->motion.reach);
	out->result.gap = cni_v(0.0f, 0.0f);
	return 1;
}

void cni_touch_collide(cni_touch *out)
{
	cni_manifold_function(out->in.a->type, out->in.b->type)(&out->in, &out->contact->cache, &out->result.manifold);
}

void cni_touch_finish(const cn_world *world, float dt, cni_touch *out)
{
	const cni_body *a = out->a, *b = out->b;
	const cni_pair_motion *m = &out->motion;
	float margin = m->margin, nearest, least, sooner, later;
	if (out->result.manifold.count == 0)
		return; /* in may be empty */
	if (CNI_ON(SEAMS) && (out->in.a->seams | out->in.b->seams) != 0 && !(out->contact->flags & CNI_CONTACT_SENSOR))
		mend_seams(world, &out->in, cni_mul(dt, m->v), &out->result.manifold);
	if (out->result.manifold.count == 0)
		return;
	cni_vec2 b_center = cni_transform_point(out->in.b_in_a, b->local_center);
	least = out->contact->flags & CNI_CONTACT_TOUCHING ? 0.0f : -out->in.slop;
	later = depth_ahead(&out->result.manifold, m, a, b_center, least, dt + dt / (float)world->settings.substeps);
	if (later > 0.0f && CNI_ON(SPECULATIVE_MISSES)) {
		sooner = depth_ahead(&out->result.manifold, m, a, b_center, least, dt);
		if (shadows_graze(&out->in, m, a, b, sooner, dt))
			out->result.manifold.count = 0;
	}
	if (m->reach <= margin || out->result.manifold.count == 0)
		return;
	nearest = drop_unreached(&out->result.manifold, m, a, b_center, margin, dt);
	if (CNI_ON(MEETING_POSES) && out->result.manifold.count > 0 && nearest > 2.0f * world->settings.contact_margin)
		meet(world, a, b, &out->in, dt, out);
}

/* ---- one-way platforms ---- */

/* Does the other shape touch the platform's local +y side, within the contact margin in depth? */
static int32_t lands_on_platform(const cn_world *world, const cni_contact *c, const cni_manifold *m)
{
	int32_t side = cni_shape_at(world, cni_proxy_at(world, c->proxy[0])->shape)->flags & CN_SHAPE_ONE_WAY ? 0 : 1;
	const cni_body *a = cni_body_at(world, c->body[0]), *platform = cni_body_at(world, c->body[side]);
	cni_vec2 up = cni_rotate(platform->q, cni_v(0.0f, 1.0f)), n = cni_rotate(a->q, m->normal);
	float deepest = m->points[0].separation;
	if (side == 1)
		n = cni_neg(n);
	if (m->count == 2)
		deepest = cni_min(deepest, m->points[1].separation);
	return cni_dot(n, up) > 0.7f && deepest > -world->settings.contact_margin;
}

void cni_touch_filter_one_way(const cn_world *world, cni_contact *c, cni_manifold *m)
{
	if (m->count == 0)
		c->flags &= ~(uint32_t)CNI_CONTACT_PASSING;
	else if (!(c->flags & (CNI_CONTACT_TOUCHING | CNI_CONTACT_PASSING)) && !lands_on_platform(world, c, m))
		c->flags |= CNI_CONTACT_PASSING;
	if (c->flags & CNI_CONTACT_PASSING)
		m->count = 0;
}
