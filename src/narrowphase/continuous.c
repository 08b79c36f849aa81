/*
 * narrowphase/continuous.c - continuous collision: the last guard against tunnelling (part of stage 8).
 *
 * Speculative contacts of the narrowphase stop most fast bodies. Bodies that became fast within the step remain, and bodies that
 * others press deep into static ones. Before such a body
 * moves, or any by more than a quarter of its inner radius, the core of each of its shapes (the shape shrunk by half its inner radius)
 * is swept along the body's path against the static shapes there (for bullets: against all shapes, each on its own path). At the
 * time of impact the body gives up the rest of its path for this step; so does a dynamic body that a bullet hits. At a static shape it gives
 * up only what leads into the shape, and slides along: a link of a rope that stopped as a whole would be held there while the rope moves on.
 * Bodies without static shapes near them, which the narrowphase marked, are skipped. Bodies whose path stays inside their fat
 * boxes can hit only shapes they have contacts with.
 * A shape that rests on or slides along another keeps its core clear of it, so it does not catch. If a shape was pressed in so
 * deep that its core overlaps the other, a smaller core stops it: an edge has no interior, so contacts would let the shape
 * through. If that core overlaps, too, the path leads no deeper along the contact's normal: machines would press the body through a
 * wall by a few millimetres in each step. A body whose core already is at a static shape, where an earlier step stopped it, loses the
 * approach speed of that point, too: otherwise a contact that expects the turn may apply no impulse, and the body would hang there
 * while its speed grows.
 *
 * The workers share the bodies. The path of a body that is no bullet depends on no other body; bullets follow serially, in order.
 *
 * Reads bodies, shapes, the broadphase; writes the position changes of stopped bodies, and the velocities of sliding ones.
 */
#include "narrowphase/narrowphase.h"
#include "narrowphase/touch.h"
#include "base/bitset.h"
#include "contacts/deep_lanes.h"

#include <float.h>
#include <string.h>

#define BODIES_A_RANGE 512 /* ten microseconds: records are read */
#define RECORDS_AHEAD 8     /* bodies whose records are asked for ... */
#define RECORDS_MANY 1024   /* ... where there are so many that they are not near anyway */

enum {
	CLAMP_STATIC, /* static shapes stop the body */
	CLAMP_ALL     /* bullets: every shape does */
};

/* Does the body move far enough in this step to tunnel? */
static int32_t body_is_fast(const cni_body *b, const cni_motion *m)
{
	float most = CNI_CORE_NEAR_PART * b->core, turn = m->theta * cni_body_turn_reach(b);
	return b->type == CN_BODY_DYNAMIC && m->dpx * m->dpx + m->dpy * m->dpy + turn * turn > most * most;
}

/* Room for any shape but a chain. */
typedef struct core_shape {
	cni_geometry geometry;
	cni_vec2 points[2 * CN_POLYGON_MAX_VERTICES];
	float depth; /* below the shape's surface */
} core_shape;

/* Moves each vertex inwards so that the edges move by depth; a vertex moves at most half its distance to the centroid (wedge tips). */
static void polygon_shrink(core_shape *core, float depth)
{
	const int32_t n = core->geometry.count;
	const cni_vec2 *normals = core->points + n;
	for (int32_t k = 0; k < n; ++k) {
		cni_vec2 sum = cni_add(normals[(k + n - 1) % n], normals[k]);
		float length_sq = cni_length_sq(sum); /* twice 1 + cosine of the angle between the normals */
		float most = 0.5f * cni_sqrt(cni_distance_sq(core->points[k], core->geometry.centroid) / cni_max(length_sq, FLT_MIN));
		core->points[k] = cni_sub(core->points[k], cni_mul(cni_min(2.0f * depth / cni_max(length_sq, FLT_MIN), most), sum));
	}
}

/*
 * By how much the core of a shape is smaller: half of its inner radius. A shape rests on a contact that gives way by up to
 * CNI_CORE_SAG_PER_SLOP; the core of a thin one, which would come down to what it rests on and hang there, is smaller by that, too.
 */
static float core_depth(const cni_geometry *g, float slop)
{
	return cni_max(0.5f * g->inner_radius, cni_min(0.9f * g->inner_radius, CNI_CORE_SAG_PER_SLOP * slop));
}

static void core_make(const cni_geometry *g, float depth, core_shape *core)
{
	float from_radius = cni_min(depth, g->radius);
	core->depth = depth;
	memcpy(core, g, (size_t)cni_geometry_bytes(g->type, g->count));
	core->geometry.radius = g->radius - from_radius;
	if (g->type == CN_SHAPE_POLYGON && depth > from_radius)
		polygon_shrink(core, depth - from_radius);
}

typedef struct clamp {
	cn_world *world;
	const cni_body *body;
	int32_t targets;     /* CLAMP_* */
	int32_t proxy;       /* of the moving shape */
	int32_t other_proxy; /* of the shape at hand ... */
	int32_t stopped_by;  /* ... that ends the path at `fraction`, CNI_NONE: none of those met by this moving shape */
	cni_path path;
	core_shape core;
	cni_aabb reach;      /* bounds the swept core and the stopping distance around it; relative to the body's centre */
	float fraction;      /* free part of the path so far */
	int32_t blocking_body; /* awake index of the dynamic body that ends the path, else 0 */
	cni_vec2 normal;     /* there: normal of the blocking shape, 0 if it is not known */
	cni_vec2 arm;        /* ... lever arm from the body's centre to the point of contact */
	core_shape touching_core; /* ... the core that touches it */
} clamp;

/* The rest of the step's motion, relative to a point near the body. */
static cni_path path_of(const cni_body *b, cni_vec2 from, const cni_motion *m)
{
	return cni_body_path(b, from, cni_v(m->dpx, m->dpy), m->theta);
}

/* Computes core and reach. The radius that the core lost shortens the reach at every angle. */
static void core_begin(clamp *c, const cni_geometry *g)
{
	const cni_body *b = c->body;
	const cni_path *p = &c->path;
	cni_aabb path = cni_aabb_of_segment(p->start, p->end);
	float rounding = CNI_BODY_ROUNDING * (cni_abs(b->cx) + cni_abs(b->cy) + b->extent);
	core_make(g, core_depth(g, c->world->settings.slop), &c->core);
	c->stopped_by = CNI_NONE;
	c->reach = cni_box_fatten(path, b->extent - (g->radius - c->core.geometry.radius) + rounding + c->world->settings.slop);
}

/* Most static shapes near a body lie outside the swept core. */
static int32_t core_reaches(const clamp *c, const cni_aabb *box)
{
	cni_aabb near = cni_box_moved(*box, cni_v(-c->body->cx, -c->body->cy));
	return cni_aabb_overlap(&c->reach, &near);
}

/* Did the pre-solve callback let the pair pass in this step? Then its contact touches without a point. */
static int32_t pair_is_refused(const clamp *c, const cni_shape *other, int32_t proxy)
{
	const cn_world *world = c->world;
	uint32_t flags = (uint32_t)(other->flags | cni_shape_at(world, cni_proxy_at(world, c->proxy)->shape)->flags);
	int32_t contact = flags & CN_SHAPE_PRE_SOLVE ? cni_contact_find(world, c->proxy, proxy) : CNI_NONE;
	return contact != CNI_NONE && (cni_contact_at(world, contact)->flags & CNI_CONTACT_TOUCHING) && cni_contact_at(world, contact)->id[0] == 0;
}

static int32_t other_blocks(const clamp *c, int32_t proxy)
{
	const cn_world *world = c->world;
	const cni_proxy *p = cni_proxy_at(world, proxy);
	const cni_shape *other = cni_shape_at(world, p->shape);
	if (c->targets == CLAMP_STATIC && !(p->flags & CNI_PROXY_STATIC))
		return 0;
	if (other->flags & (CN_SHAPE_SENSOR | CN_SHAPE_ONE_WAY))
		return 0;
	return !pair_is_refused(c, other, proxy) && cni_contact_allowed(world, c->proxy, proxy);
}

/* Advance along the normal of the shape's support point in the direction -normal. */
static float path_advance_along(const cni_geometry *g, int32_t child, const cni_path *path, cni_vec2 normal)
{
	cni_vec2 storage[2], from = cni_unrotate(path->q, normal), to;
	cni_proxy_points set = cni_geometry_proxy(g, child, storage);
	cni_transform end = cni_path_at(path, 1.0f);
	float low_from = FLT_MAX, low_to = FLT_MAX;
	to = cni_unrotate(end.q, normal);
	for (int32_t k = 0; k < set.count; ++k) {
		cni_vec2 arm = cni_sub(set.points[k], path->local_center);
		low_from = cni_min(low_from, cni_dot(arm, from));
		low_to = cni_min(low_to, cni_dot(arm, to));
	}
	return cni_dot(cni_sub(path->end, path->start), normal) + (low_to - low_from);
}

/* Growth of the separation along the normal from the beginning to the end of both paths. */
static float paths_separate_by(const cni_toi_input *in, cni_vec2 normal)
{
	return path_advance_along(in->b, in->child_b, &in->path_b, normal) + path_advance_along(in->a, in->child_a, &in->path_a, cni_neg(normal));
}

/*
 * Time of impact of a core that may start closer than the target distance, as after an earlier stop. Such a core may approach to
 * half its distance, down to 0.01 of the tolerance; there it is held until it separates.
 */
static cni_toi_result toi_with_reduced_target(cni_toi_input *in)
{
	float least = 0.01f * in->tolerance;
	cni_toi_result hit = cni_toi(in);
	while (hit.state == CNI_TOI_HIT && !(hit.fraction > 0.0f) && hit.distance > 2.0f * least) {
		in->target = 0.5f * hit.distance;
		in->tolerance = 0.25f * hit.distance;
		hit = cni_toi(in);
		if (!(hit.distance < 2.0f * in->target))
			break;
	}
	return hit;
}

static int32_t starts_overlapping(const cni_toi_result *hit)
{
	return hit->state == CNI_TOI_OVERLAPPED || (hit->state == CNI_TOI_HIT && hit->fraction == 0.0f && hit->distance <= 0.0f);
}

static cni_toi_result core_toi(const clamp *c, const core_shape *core, cni_toi_input *in)
{
	float most = 0.5f * c->world->settings.slop;
	in->b = &core->geometry;
	in->target = core->depth > 0.0f ? cni_min(most, CNI_CORE_CLEAR_PART * core->depth) : most;
	in->tolerance = 0.5f * in->target;
	return toi_with_reduced_target(in);
}

/* Of shapes hit at the same fraction, the lowest proxy counts: broadphases visit in different orders. */
static int32_t ends_path_before(const clamp *c, float fraction)
{
	return fraction < c->fraction || (fraction == c->fraction && c->other_proxy < c->stopped_by);
}

/* Shortens the path to the part that is free for a core. Returns 0 if the core starts inside the other shape. */
static int32_t core_clamp(clamp *c, const core_shape *core, cni_toi_input *in, const cni_body *other)
{
	cni_toi_result hit = core_toi(c, core, in);
	if (starts_overlapping(&hit))
		return 0;
	if ((hit.state != CNI_TOI_HIT && hit.state != CNI_TOI_FAILED) || !ends_path_before(c, hit.fraction))
		return 1;
	if (hit.state == CNI_TOI_HIT && hit.fraction == 0.0f && paths_separate_by(in, hit.normal) > 0.0f)
		return 1;
	c->fraction = hit.fraction;
	c->stopped_by = c->other_proxy;
	c->blocking_body = other->type == CN_BODY_DYNAMIC ? other->awake : 0;
	c->normal = hit.state == CNI_TOI_HIT ? hit.normal : cni_v(0.0f, 0.0f);
	c->arm = hit.state != CNI_TOI_HIT ? cni_v(0.0f, 0.0f) : cni_sub(hit.point, cni_lerp(in->path_b.start, in->path_b.end, hit.fraction));
	c->touching_core = *core;
	return 1;
}

/* Even the inner core starts inside the other shape. Contacts push it out; until then its path may not lead deeper, or a machine would press
   it through step by step. */
static void deeper_end(clamp *c)
{
	int32_t contact = cni_contact_find(c->world, c->proxy, c->other_proxy), l, deepest;
	if (contact == CNI_NONE || !cni_contact_has_lane(cni_contact_at(c->world, contact)))
		return;
	l = cni_contact_at(c->world, contact)->slot % CNI_LANES;
	const cni_contact_block *k = cni_block_at(c->world, cni_contact_at(c->world, contact)->slot / CNI_LANES);
	cni_vec2 n = cni_v(-k->nx[l], -k->ny[l]);
	if (!(path_advance_along(&c->core.geometry, 0, &c->path, n) < 0.0f) || !ends_path_before(c, 0.0f))
		return;
	deepest = k->p[1].s0[l] < k->p[0].s0[l];
	c->fraction = 0.0f;
	c->stopped_by = c->other_proxy;
	c->blocking_body = 0;
	c->normal = n;
	c->arm = cni_madd(cni_mul(-k->p[deepest].at[l], cni_right_perp(n)), -k->p[deepest].an[l], n);
	c->touching_core = c->core;
}

/* Clamps a shape whose outer core overlaps the other. */
static void inner_clamp(clamp *c, cni_toi_input *in, const cni_body *other)
{
	const cni_geometry *g = cni_shape_geometry(&c->world->blocks, cni_shape_at(c->world, cni_proxy_at(c->world, c->proxy)->shape));
	core_shape inner;
	if (c->core.depth < CNI_CORE_INNER_DEPTH_PART * g->inner_radius) {
		core_make(g, CNI_CORE_INNER_DEPTH_PART * g->inner_radius, &inner);
		if (core_clamp(c, &inner, in, other))
			return;
	}
	if (other->type != CN_BODY_DYNAMIC)
		deeper_end(c);
}

static float visit_candidate(void *context, int32_t proxy, float limit)
{
	clamp *c = (clamp *)context;
	const cn_world *world = c->world;
	const cni_proxy *p = cni_proxy_at(world, proxy);
	cni_toi_input in;
	if (!other_blocks(c, proxy) || ((p->flags & CNI_PROXY_STATIC) && !core_reaches(c, &p->fat))) /* rejected by the proxy alone */
		return limit;
	const cni_shape *s = cni_shape_at(world, p->shape);
	const cni_body *other = cni_body_at(world, s->body);
	c->other_proxy = proxy;
	in.a = cni_shape_geometry(&world->blocks, s);
	in.child_a = cni_proxy_child(p);
	in.child_b = 0;
	in.path_a = path_of(other, cni_v(c->body->cx, c->body->cy), cni_motions(world) + other->awake); /* the dummy for static ones */
	in.path_b = c->path;
	if (!core_clamp(c, &c->core, &in, other))
		inner_clamp(c, &in, other);
	return limit;
}

/* Bounds the body's shapes on the whole path at any angle. */
static cni_aabb swept_box(const cni_body *b, const cni_motion *m)
{
	return cni_box_fatten(cni_aabb_of_segment(cni_v(b->cx, b->cy), cni_v(b->cx + m->dpx, b->cy + m->dpy)), b->extent);
}

static void motion_shorten(cni_motion *m, float fraction)
{
	m->dpx *= fraction;
	m->dpy *= fraction;
	m->theta *= fraction;
}

static int32_t shape_can_tunnel(const cni_shape *s, int32_t proxy)
{
	return s->type != CN_SHAPE_CHAIN && !(s->flags & (CN_SHAPE_SENSOR | CN_SHAPE_ONE_WAY)) && proxy != CNI_NONE;
}

/* Against the static shapes that it has contacts with. */
static void shape_clamp_contacts(clamp *c, const cni_shape *s)
{
	const cn_world *world = c->world;
	int32_t next, has_core = 0;
	for (int32_t key = c->body->contact_first; key != CNI_NONE; key = next) {
		const cni_contact *contact = cni_contact_of_key(world, key);
		int32_t side = key & 1, other = contact->proxy[1 - side];
		next = contact->next[side];
		if (!(contact->flags & CNI_CONTACT_STATIC) && !(c->body->flags & CNI_BODY_MIXED))
			return; /* those with static bodies are in front */
		if (contact->proxy[side] != c->proxy || !(contact->flags & CNI_CONTACT_STATIC))
			continue;
		if (!has_core)
			core_begin(c, cni_shape_geometry(&world->blocks, s));
		has_core = 1;
		visit_candidate(c, other, 0.0f);
	}
}

/* Finds the free fraction of the body's path: against every shape that the broadphase reports, or, for a body that can hit only
   static shapes that it has contacts with, against these. */
static void clamp_find(clamp *c, cn_world *world, int32_t body, int32_t targets, int32_t by_contacts)
{
	const cni_body *b = cni_body_at(world, body);
	const cni_motion *m = cni_motions(world) + b->awake;
	cni_aabb box = swept_box(b, m);
	c->world = world;
	c->body = b;
	c->targets = targets;
	c->fraction = 1.0f;
	c->blocking_body = 0;
	c->path = path_of(b, cni_v(b->cx, b->cy), m);
	for (int32_t shape = b->shape_first; shape != CNI_NONE; shape = cni_shape_at(world, shape)->next) {
		const cni_shape *s = cni_shape_at(world, shape);
		c->proxy = cni_shape_proxy(world, s, 0);
		if (!shape_can_tunnel(s, c->proxy))
			continue;
		if (by_contacts) {
			shape_clamp_contacts(c, s);
			continue;
		}
		core_begin(c, cni_shape_geometry(&world->blocks, s));
		world->broadphase_ops->query(world->broadphase, &box, visit_candidate, c);
	}
}

/*
 * Cancels what of the path leads into the shape from the point of contact on, as an impulse there would: the body slides, and turns about the
 * point. A body that is there at once loses its approach speed likewise. The path is then moved outwards by the penetration that its curvature
 * causes plus a bound of the rounding error.
 */
static void motion_slide(cni_motion *m, const clamp *c)
{
	cni_vec2 n = c->normal, from = cni_v(c->body->cx, c->body->cy);
	cni_path path = cni_body_path(c->body, from, cni_mul(c->fraction, cni_v(m->dpx, m->dpy)), c->fraction * m->theta);
	float advance = path_advance_along(&c->touching_core.geometry, 0, &path, n);
	float arm = cni_cross(c->arm, n), mass = cni_max(m->inv_mass + m->inv_inertia * arm * arm, FLT_MIN);
	float speed = c->fraction > 0.0f ? 0.0f : cni_max(-(m->vx * n.x + m->vy * n.y + m->w * arm), 0.0f) / mass;
	float shift = (1.0f - c->fraction) * cni_max(-(m->dpx * n.x + m->dpy * n.y + m->theta * arm), 0.0f) / mass, out;
	m->vx += speed * m->inv_mass * n.x;
	m->vy += speed * m->inv_mass * n.y;
	m->w += speed * m->inv_inertia * arm;
	m->dpx += shift * m->inv_mass * n.x;
	m->dpy += shift * m->inv_mass * n.y;
	m->theta += shift * m->inv_inertia * arm;
	path = path_of(c->body, from, m);
	out = cni_max(advance - path_advance_along(&c->touching_core.geometry, 0, &path, n), 0.0f);
	out += 4.0f * FLT_EPSILON * (cni_abs(m->dpx) + cni_abs(m->dpy) + cni_abs(m->theta) * c->body->extent);
	m->dpx += out * n.x;
	m->dpy += out * n.y;
}

/* Shortens the body's motion. A body that a static shape stops slides, at most once. In a corner, or with a locked axis, it stays. */
static void clamp_body(cn_world *world, int32_t body, int32_t targets, int32_t by_contacts)
{
	cni_motion *m = cni_motions(world) + cni_body_at(world, body)->awake;
	clamp c;
	clamp_find(&c, world, body, targets, by_contacts);
	if (c.fraction < 1.0f && c.blocking_body == 0 && cni_length_sq(c.normal) > 0.0f && !(c.body->flags & (CN_BODY_LOCK_X | CN_BODY_LOCK_Y))) {
		motion_slide(m, &c);
		clamp_find(&c, world, body, targets, 0);
	}
	motion_shorten(m, c.fraction);
	if (c.blocking_body != 0) /* its path was not checked beyond that fraction: it could sweep over the bullet */
		motion_shorten(cni_motions(world) + c.blocking_body, c.fraction);
	if (cni_motion_keep_finite(m)) /* sliding along may overflow where the path is near the limits of float */
		(void)cni_atomic_add(&world->bodies_stopped, 1u);
}

/* ---- which bodies ---- */

static cni_aabb box_at_end(const cni_body *b, const cni_motion *m, const cni_geometry *g)
{
	cni_path path = path_of(b, cni_v(0.0f, 0.0f), m);
	return cni_geometry_aabb(g, 0, cni_path_at(&path, 1.0f));
}

/* Deviation of the path from the predicted one that the fat boxes contain. */
static float deviation_from_predicted(const cn_world *world, const cni_body *b, const cni_motion *m)
{
	return cni_max(cni_abs(m->dpx - world->step_dt * b->vx), cni_abs(m->dpy - world->step_dt * b->vy));
}

/*
 * Does the body stay inside the fat boxes of its shapes on the whole path? Then every static shape that it could hit
 * already has a contact with it. A shape deviates from the line between its two end positions by at most
 * turn_reach theta^2 / 8, and turning moves it by at most turn_reach theta. Most boxes have room for both bounds, so the box
 * at the end need not be computed; nor the present one, if the boxes were made for this path.
 */
static int32_t path_is_inside_boxes(const cn_world *world, const cni_body *b, const cni_motion *m)
{
	float turn_reach = cni_body_turn_reach(b), bend = 0.125f * turn_reach * m->theta * m->theta;
	float turn_bound = bend + cni_body_reach(b, 0.0f, 0.0f, m->theta);
	if (cni_abs(m->theta) > CNI_CORE_TURN_MAX_RAD && turn_reach > 0.0f)
		return 0;
	if ((b->flags & CNI_BODY_AHEAD) && deviation_from_predicted(world, b, m) + turn_bound < cni_body_room(b))
		return 1;
	cni_transform start = cni_body_transform(b);
	for (int32_t shape = b->shape_first; shape != CNI_NONE; shape = cni_shape_at(world, shape)->next) {
		const cni_shape *s = cni_shape_at(world, shape);
		const cni_geometry *g = cni_shape_geometry(&world->blocks, s);
		int32_t proxy = cni_shape_proxy(world, s, 0);
		cni_aabb from, to, box;
		if (!shape_can_tunnel(s, proxy))
			continue;
		const cni_aabb *fat = &cni_proxy_at(world, proxy)->fat;
		cni_geometry_box(g, 0, &start, &from);
		to = cni_box_moved(from, cni_v(m->dpx, m->dpy));
		box = cni_box_fatten(cni_aabb_union(&from, &to), turn_bound);
		if (cni_aabb_contains(fat, &box))
			continue;
		to = box_at_end(b, m, g);
		box = cni_box_fatten(cni_aabb_union(&from, &to), bend);
		if (!cni_aabb_contains(fat, &box))
			return 0;
	}
	return 1;
}

/*
 * Marks slow bodies that are pressed deep into something immovable. Neighbours or a kinematic body can press a body through a wall with
 * many steps of less than a quarter of its inner radius. One that overlaps by at most that much keeps its core clear for one more step;
 * smaller overlaps, which bodies at rest have, are skipped without reading records. Body a of a lane is the movable one.
 */
static void deep_bodies_mark(cn_world *world)
{
	const cni_motion *motions = cni_motions(world);
	for (int32_t color = CNI_COLOR_STATIC; color < CNI_COLORS; ++color)
		for (int32_t block = world->colors[color].first; block != CNI_NONE; block = cni_block_info_at(world, block)->next) {
			const cni_contact_block *k = cni_block_at(world, block);
			for (uint32_t deep = cni_deep_lanes(k, CNI_CORE_NEAR_PART * world->settings.slop); deep != 0; deep &= deep - 1u) {
				int32_t l = cni_bit_lowest32(deep), index = k->ia[l];
				float core = cni_body_at(world, cni_awake_ids(world)[index])->core;
				if (!(motions[k->ib[l]].inv_mass > 0.0f) && -cni_min(k->p[0].s0[l], k->p[1].s0[l]) > CNI_CORE_NEAR_PART * core)
					cni_externals(world)[index].flags |= CNI_EXTERNAL_DEFERRED;
			}
		}
}

typedef struct check_loop {
	cn_world *world;
	int32_t without_boxes; /* the boxes were not made for these paths */
	uint32_t bullets;      /* number of fast, deferred ones */
} check_loop;

/* Checks a fast or deep body. Fast bullets depend on the paths of others, so they are deferred until all other paths are final. */
static void body_check(check_loop *loop, int32_t body, const cni_motion *m, int32_t fast)
{
	cn_world *world = loop->world;
	const cni_body *b = cni_body_at(world, body);
	if (fast && (b->flags & CN_BODY_BULLET)) {
		cni_externals(world)[b->awake].flags |= CNI_EXTERNAL_DEFERRED;
		(void)cni_atomic_add(&loop->bullets, 1);
		return;
	}
	if (world->movable_count == world->body_handles.count)
		return; /* the world has no static body */
	if (loop->without_boxes || (world->pairs_may_repeat & ~CNI_PAIRS_CROWDED) || !path_is_inside_boxes(world, b, m))
		clamp_body(world, body, CLAMP_STATIC, 0);
	else if (b->flags & CNI_BODY_AT_STATIC)
		clamp_body(world, body, CLAMP_STATIC, 1);
}

CNI_INLINE void record_prefetch(const cn_world *world, int32_t body)
{
	const cni_body *b = cni_body_at(world, body);
	CNI_PREFETCH(&b->cx);
	CNI_PREFETCH(&b->core);
}

/* Writes only motions and externals of the range. */
static void check_range(void *context, int32_t begin, int32_t end)
{
	check_loop *loop = (check_loop *)context;
	const cn_world *world = loop->world;
	const int32_t *ids = cni_awake_ids(world);
	const cni_motion *motions = cni_motions(world);
	cni_external *externals = cni_externals(world);
	int32_t fast, many = world->awake_count > RECORDS_MANY;
	for (int32_t k = begin + 1; k <= end; ++k) {
		if (many && k + RECORDS_AHEAD <= end)
			record_prefetch(world, ids[k + RECORDS_AHEAD]);
		fast = body_is_fast(cni_body_at(world, ids[k]), &motions[k]);
		if (fast || (externals[k].flags & CNI_EXTERNAL_DEFERRED)) {
			externals[k].flags &= ~(uint32_t)CNI_EXTERNAL_DEFERRED;
			body_check(loop, ids[k], &motions[k], fast);
		}
	}
}

/* Serial, in order: a bullet may shorten the path of another. */
static void bullets_check(cn_world *world)
{
	cni_external *externals = cni_externals(world);
	for (int32_t k = 1; k < world->awake_count; ++k) {
		int32_t body = cni_awake_ids(world)[k];
		if (!(externals[k].flags & CNI_EXTERNAL_DEFERRED))
			continue;
		externals[k].flags &= ~(uint32_t)CNI_EXTERNAL_DEFERRED;
		if (body_is_fast(cni_body_at(world, body), cni_motions(world) + k)) /* another bullet may have shortened its path */
			clamp_body(world, body, CLAMP_ALL, 0);
	}
}

/* A user's filter runs in the calling thread only. */
void cni_stage_continuous(cn_world *world)
{
	check_loop loop = { world, world->settings.solver == CN_SOLVER_SEQUENTIAL, 0 };
	deep_bodies_mark(world);
	cni_team_for(world->filter != NULL ? NULL : world->team, world->awake_count - 1, BODIES_A_RANGE, check_range, &loop);
	if (loop.bullets > 0)
		bullets_check(world);
}
