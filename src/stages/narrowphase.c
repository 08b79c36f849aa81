/*
 * stages/narrowphase.c - stages 3 and 4: how the shapes of awake contacts touch.
 *
 * First every awake contact is looked at on its own: one that goes on touching has its lane rewritten in
 * place; one whose state changes is put on a list. Then the list is worked through in contact order: lanes are
 * taken and freed, islands linked, events logged, ended pairs removed. Only the second part
 * changes shared tables.
 *
 * Reads bodies, shapes, geometry, proxies; writes contacts, lanes, and through them islands and events.
 *
 * Contact margin: slow pairs touch when closer than four slops (speculative contact). Fast pairs look as far
 * ahead as they come closer in the step, so that they meet the surface instead of each other's inside; a
 * point that their motion does not reach is dropped.
 */
#include "geometry/toi.h"
#include "stages/solver.h"

/* How a pair touches: the manifold, and where b's point is from a's now when the contact is still ahead. */
typedef struct touch {
	cni_manifold manifold;
	cni_vec2 gap;
} touch;

typedef struct pair_motion {
	cni_vec2 v;       /* velocity of b's centre relative to a's, in a's frame */
	float wa, wb;
	float reach;      /* most that surface points can come closer in the step */
} pair_motion;

static pair_motion motion_make(const cn_world *world, const cni_body *a, const cni_body *b, float dt)
{
	const cni_motion *ma = cni_motions(world) + a->awake, *mb = cni_motions(world) + b->awake;
	pair_motion m;
	m.v = cni_unrotate(a->q, cni_v(mb->vx - ma->vx, mb->vy - ma->vy));
	m.wa = ma->w;
	m.wb = mb->w;
	m.reach = dt * (cni_abs(m.v.x) + cni_abs(m.v.y) + cni_abs(m.wa) * a->extent + cni_abs(m.wb) * b->extent);
	return m;
}

/* Speed at which the surfaces come closer at a point. */
static float closing_at(const cni_manifold *out, int32_t k, const pair_motion *m, const cni_body *a, cni_vec2 b_center)
{
	cni_vec2 p = out->points[k].point, ra = cni_sub(p, a->local_center), rb = cni_sub(p, b_center);
	cni_vec2 v = cni_add(m->v, cni_sub(cni_mul(m->wb, cni_left_perp(rb)), cni_mul(m->wa, cni_left_perp(ra))));
	return -cni_dot(out->normal, v);
}

/* Keeps the points that are within the plain margin or are reached within the step: the normal of one that is not
   stays a separating axis. Returns the largest separation kept. */
static float drop_unreached(cni_manifold *out, const pair_motion *m, const cni_body *a, cni_vec2 b_center, float margin, float dt)
{
	int32_t k, kept = 0;
	float nearest = FLT_MAX;
	for (k = 0; k < out->count; ++k) {
		if (out->points[k].separation > margin + cni_max(closing_at(out, k, m, a, b_center), 0.0f) * dt)
			continue;
		nearest = cni_min(nearest, out->points[k].separation);
		out->points[kept++] = out->points[k];
	}
	out->count = kept;
	return nearest;
}

/* How deep the planes of points that are all ahead would be passed in the step; 0 when some point is nearer than least. */
static float depth_ahead(const cni_manifold *out, const pair_motion *m, const cni_body *a, cni_vec2 b_center, float least, float dt)
{
	float depth = 0.0f;
	int32_t k;
	for (k = 0; k < out->count; ++k) {
		if (out->points[k].separation <= least)
			return 0.0f;
		depth = cni_max(depth, closing_at(out, k, m, a, b_center) * dt - cni_max(out->points[k].separation, 0.0f));
	}
	return depth;
}

/*
 * Do the shapes graze each other at most? While they move along a line, the shadows that they throw along it stay:
 * shadows that overlap by no more than the slop are of shapes that never meet deeper. So the corner of the next
 * piece of flat ground, which is ahead of what slides over it, does not hold it up. A plane that is reached by a
 * hair only, which is how things slide, or in the substep after, for which the solver brakes too, is given up only
 * for shadows that are clear of each other.
 */
static int32_t shadows_graze(const cni_manifold_input *in, const pair_motion *m, const cni_body *a, const cni_body *b, float depth, float dt)
{
	float speed = cni_length(m->v), hair = 0.1f * in->slop;
	float turn = dt * (cni_abs(m->wa) * (a->extent - in->a->radius) + cni_abs(m->wb) * (b->extent - in->b->radius));
	cni_transform along, b_along;
	cni_aabb box_a, box_b;
	if (speed * dt <= hair || turn > in->slop)
		return 0;
	along.q.c = m->v.x / speed; /* turns the motion to +x: shadows are what is left in y */
	along.q.s = -m->v.y / speed;
	along.t = cni_v(0.0f, 0.0f);
	b_along.q = cni_rot_mul(along.q, in->b_in_a.q);
	b_along.t = cni_rotate(along.q, in->b_in_a.t);
	box_a = cni_geometry_aabb(in->a, in->child_a, along);
	box_b = cni_geometry_aabb(in->b, in->child_b, b_along);
	return cni_min(box_a.y1, box_b.y1) - cni_max(box_a.y0, box_b.y0) + turn <= (depth > hair ? in->slop : -hair);
}

static cni_path path_make(const cni_body *b, cni_vec2 from, const cni_motion *m, float dt)
{
	cni_path p;
	p.start = cni_v((b->cx - from.x) + b->cx_low, (b->cy - from.y) + b->cy_low);
	p.end = cni_v(p.start.x + dt * m->vx, p.start.y + dt * m->vy);
	p.q = b->q;
	p.turn = dt * m->w;
	p.local_center = b->local_center;
	return p;
}

/*
 * A contact that is still ahead: the shapes are moved to where they will first meet, the manifold there is
 * taken, and its points are traced back to now. So a fast body meets the surface that it would really hit,
 * and is not held by the plane of what merely happens to be nearest.
 */
static void meet(const cn_world *world, const cni_body *a, const cni_body *b, const cni_manifold_input *near, float dt, touch *out)
{
	cni_manifold_input in = *near;
	cni_manifold_cache cache = { 0, 0, { 0, 0 } };
	cni_vec2 from = cni_v(a->cx, a->cy);
	cni_transform xa, xb, a_now, b_now;
	cni_toi_input toi;
	cni_toi_result hit;
	int32_t k;
	toi.a = in.a;
	toi.b = in.b;
	toi.child_a = in.child_a;
	toi.child_b = in.child_b;
	toi.path_a = path_make(a, from, cni_motions(world) + a->awake, dt);
	toi.path_b = path_make(b, from, cni_motions(world) + b->awake, dt);
	toi.target = 0.5f * world->settings.slop;
	toi.tolerance = 0.25f * world->settings.slop;
	hit = cni_toi(&toi);
	if (hit.state == CNI_TOI_SEPARATED)
		out->manifold.count = 0;
	if (hit.state != CNI_TOI_HIT)
		return;
	xa = cni_path_at(&toi.path_a, hit.fraction);
	xb = cni_path_at(&toi.path_b, hit.fraction);
	in.b_in_a.q = cni_rot_between(xa.q, xb.q);
	in.b_in_a.t = cni_untransform_point(xa, xb.t);
	in.margin = world->settings.contact_margin;
	cni_manifold_function(in.a->type, in.b->type)(&in, &cache, &out->manifold);
	if (out->manifold.count == 0)
		return;
	a_now = cni_path_at(&toi.path_a, 0.0f);
	b_now = cni_path_at(&toi.path_b, 0.0f);
	out->manifold.normal = cni_unrotate(a_now.q, cni_rotate(xa.q, out->manifold.normal));
	for (k = out->manifold.count - 1; k >= 0; --k) { /* the gap of the first point stays */
		cni_manifold_point *p = &out->manifold.points[k];
		cni_vec2 on_b = cni_untransform_point(in.b_in_a, p->point);
		cni_vec2 apart = cni_sub(cni_transform_point(b_now, on_b), cni_transform_point(a_now, p->point));
		out->gap = cni_unrotate(a_now.q, apart);
		p->separation += cni_dot(out->manifold.normal, out->gap);
	}
}

static void contact_collide(const cn_world *world, cni_contact *c, float dt, touch *out)
{
	const cni_proxy *pa = cni_proxy_at(world, c->proxy[0]), *pb = cni_proxy_at(world, c->proxy[1]);
	const cni_shape *sa = cni_shape_at(world, pa->shape), *sb = cni_shape_at(world, pb->shape);
	const cni_body *a = cni_body_at(world, c->body[0]), *b = cni_body_at(world, c->body[1]);
	float margin = world->settings.contact_margin, nearest, least, sooner, later;
	pair_motion m = motion_make(world, a, b, dt);
	cni_manifold_input in;
	cni_vec2 b_center;
	in.a = cni_shape_geometry(&world->blocks, sa);
	in.b = cni_shape_geometry(&world->blocks, sb);
	in.child_a = pa->child;
	in.child_b = pb->child;
	in.b_in_a = cni_body_b_in_a(a, b);
	in.slop = world->settings.slop;
	in.margin = cni_max(margin, m.reach);
	out->manifold.count = 0;
	out->gap = cni_v(0.0f, 0.0f);
	cni_manifold_function(sa->type, sb->type)(&in, &c->cache, &out->manifold);
	if (out->manifold.count == 0)
		return;
	b_center = cni_transform_point(in.b_in_a, b->local_center);
	least = c->flags & CNI_CONTACT_TOUCHING ? 0.0f : -in.slop;
	sooner = depth_ahead(&out->manifold, &m, a, b_center, least, dt);
	later = depth_ahead(&out->manifold, &m, a, b_center, least, dt + dt / (float)world->settings.substeps);
	if (later > 0.0f && shadows_graze(&in, &m, a, b, sooner, dt))
		out->manifold.count = 0;
	if (m.reach <= margin || out->manifold.count == 0)
		return;
	nearest = drop_unreached(&out->manifold, &m, a, b_center, margin, dt);
	if (out->manifold.count > 0 && nearest > 2.0f * margin)
		meet(world, a, b, &in, dt, out);
}

/* What the second part has to do for a contact. */
enum { CHANGE_NONE = 0, CHANGE_BEGIN = 1, CHANGE_END = 2, CHANGE_OWED = 3 };

static int32_t boxes_overlap(const cn_world *world, const cni_contact *c)
{
	return cni_aabb_overlap(&cni_proxy_at(world, c->proxy[0])->fat, &cni_proxy_at(world, c->proxy[1])->fat);
}

/* ---- one-way platforms ---- */

/* Does the other shape come down on the side that the platform's local +y points to? */
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

/* A shape that first touches from below or from the side passes until it is out again. */
static void let_pass(const cn_world *world, cni_contact *c, cni_manifold *m)
{
	if (m->count == 0)
		c->flags &= ~(uint32_t)CNI_CONTACT_PASSING;
	else if (!(c->flags & (CNI_CONTACT_TOUCHING | CNI_CONTACT_PASSING)) && !lands_on_platform(world, c, m))
		c->flags |= CNI_CONTACT_PASSING;
	if (c->flags & CNI_CONTACT_PASSING)
		m->count = 0;
}

/* ---- sensors ---- */

static int32_t sensor_update(cn_world *world, cni_contact *c)
{
	touch t;
	int32_t k, overlaps = 0, sensing = (c->flags & CNI_CONTACT_SENSING) != 0;
	contact_collide(world, c, 0.0f, &t);
	for (k = 0; k < t.manifold.count; ++k)
		overlaps |= t.manifold.points[k].separation <= 0.0f;
	if (overlaps)
		return sensing ? CHANGE_NONE : CHANGE_BEGIN;
	return sensing || !boxes_overlap(world, c) ? CHANGE_END : CHANGE_NONE;
}

/* The user may make a touching pair pass through each other for this step. */
static void ask_user(cn_world *world, int32_t contact)
{
	cn_contact_event event;
	int32_t solve;
	if (world->pre_solve == NULL)
		return;
	cni_contact_describe(world, contact, cni_contact_at(world, contact)->flags & CNI_CONTACT_ENTERED ? CN_EVENT_ENTER : CN_EVENT_STAY, &event);
	++world->locked;
	solve = world->pre_solve(world, &event, world->pre_solve_user);
	--world->locked;
	if (!solve)
		cni_contact_write_empty(world, contact);
}

static void write_and_ask(cn_world *world, int32_t contact, const touch *t)
{
	cni_contact_write(world, contact, &t->manifold, t->gap);
	if (cni_contact_at(world, contact)->flags & CNI_CONTACT_PRE_SOLVE)
		ask_user(world, contact);
}

/* Looks at one contact, and rewrites its lane if it goes on touching. */
static int32_t contact_update(cn_world *world, int32_t contact, float dt)
{
	cni_contact *c = cni_contact_at(world, contact);
	int32_t touching = (c->flags & CNI_CONTACT_TOUCHING) != 0;
	touch t;
	c->flags &= ~(uint32_t)CNI_CONTACT_ENTERED;
	if (c->flags & CNI_CONTACT_ASLEEP)
		return CHANGE_NONE;
	if (c->flags & CNI_CONTACT_SENSOR)
		return sensor_update(world, c);
	contact_collide(world, c, dt, &t);
	if (t.manifold.count > 0 && !boxes_overlap(world, c))
		t.manifold.count = 0; /* the reach of a fast pair: a pair whose boxes are apart ends, or it would be found twice */
	if (c->flags & CNI_CONTACT_ONE_WAY)
		let_pass(world, c, &t.manifold);
	if (t.manifold.count > 0 && !touching)
		return CHANGE_BEGIN;
	if (t.manifold.count > 0)
		write_and_ask(world, contact, &t);
	else if (touching || !boxes_overlap(world, c))
		return CHANGE_END;
	return c->flags & (CNI_CONTACT_CREATED_OWED | CNI_CONTACT_ENTER_OWED) ? CHANGE_OWED : CHANGE_NONE;
}

/* The manifold is computed once more: few contacts begin in a step, and keeping it for all that might
   takes more memory than the contacts themselves. */
static void change_begin(cn_world *world, int32_t contact, float dt)
{
	touch t;
	contact_collide(world, cni_contact_at(world, contact), dt, &t);
	if (t.manifold.count == 0)
		return;
	if (cni_contact_begin(world, contact, &t.manifold, t.gap)) {
		if (cni_contact_at(world, contact)->flags & CNI_CONTACT_PRE_SOLVE)
			ask_user(world, contact);
		return;
	}
	world->warnings |= CN_WARNING_CONTACT_MEMORY;
	++world->pairs_not_added;
}

/* Sensor pairs end and begin by themselves: nothing is solved. */
static void sensor_change(cn_world *world, int32_t contact, int32_t change)
{
	if (cni_contact_sense(world, contact, change == CHANGE_BEGIN) && change == CHANGE_END &&
	    !boxes_overlap(world, cni_contact_at(world, contact)))
		cni_contact_destroy(world, contact);
}

static void change_apply(cn_world *world, int32_t contact, int32_t change, float dt)
{
	const cni_contact *c = cni_contact_at(world, contact);
	if (c->flags & CNI_CONTACT_SENSOR) {
		sensor_change(world, contact, change);
		return;
	}
	if (change != CHANGE_END || boxes_overlap(world, c)) /* else it goes before it was told of */
		cni_contact_pay_owed(world, contact, CNI_CONTACT_CREATED_OWED, CN_EVENT_CREATED);
	if (change == CHANGE_OWED)
		cni_contact_pay_owed(world, contact, CNI_CONTACT_ENTER_OWED, CN_EVENT_ENTER);
	if (change == CHANGE_BEGIN)
		change_begin(world, contact, dt);
	if (change != CHANGE_END || ((c->flags & CNI_CONTACT_TOUCHING) && !cni_contact_end(world, contact)))
		return;
	if (!boxes_overlap(world, c))
		cni_contact_destroy(world, contact);
}

/* world->changes has room for every awake contact. */
void cni_stage_narrowphase(cn_world *world, float dt)
{
	const int32_t *awake = (const int32_t *)world->awake_contacts.data;
	uint32_t *changes = (uint32_t *)world->changes.data;
	int32_t k, count = 0;
	for (k = 0; k < world->awake_contacts.count; ++k) {
		uint32_t change = (uint32_t)contact_update(world, awake[k], dt);
		if (change != CHANGE_NONE)
			changes[count++] = (uint32_t)awake[k] << 2 | change;
	}
	for (k = 0; k < count; ++k)
		change_apply(world, (int32_t)(changes[k] >> 2), (int32_t)(changes[k] & 3u), dt);
}
