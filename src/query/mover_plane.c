/*
 * query/mover_plane.c - the planes that bound a mover: finding them, the nearest position that they permit, and sliding along them.
 *
 * The pair functions of collision/ give the planes, so inner vertices of chains and hidden corners of tiles act as in a step.
 *
 * The solver finds the point of an intersection of half planes nearest to the wanted point. In two dimensions that is the wanted
 * point itself, its projection on one line, or the crossing of two lines (the active sets of a quadratic program in two
 * variables). The nearest candidate that all planes permit is exact at any angle. A plane that would push by more than
 * push_max_m is saturated: it pushes by push_max_m, and the others find the nearest point to the wanted point so moved.
 *
 * If the planes leave no room, there is no such point. Then all planes pull at once, each by an equal share of its overlap
 * (Cimmino 1938), which converges to the least sum of squared overlaps.
 */
#include "query/mover.h"
#include "collision/manifold.h"

#include <string.h>

/* Of the lengths involved: what counts as allowed beyond a plane. */
#define ROUNDING 1e-6f
/* Sine of the angle between two planes below which they do not cross. */
#define PARALLEL_SINE 1e-6f
/* Sweeps that tell which bounded planes push their most. */
#define SWEEPS_MAX 64
/* Corrections of that. */
#define CHANGES_MAX 32
/* Rounds of pulling where there is no room. */
#define SHARES_MAX 64
/* A round of sliding that moves by less, in slops, is the last one. */
#define MOVED_PER_SLOP 0.002f

/* ------------------------------------------------------------------ finding */

typedef struct plane_query {
	const cni_sight *sight;
	const cni_region *region;
	const cni_solid *solid;
	float margin;
	cni_first found;
} plane_query;

static int32_t plane_before(const void *a, const void *b)
{
	const cn_plane *x = (const cn_plane *)a, *y = (const cn_plane *)b;
	return x->separation_m != y->separation_m ? x->separation_m < y->separation_m : cni_part_before(x->shape, x->child, y->shape, y->child);
}

/* Maps the frame of a target's body to that of the region's origin. */
static cni_transform target_in_region(const cni_query_target *t, const cni_region *region)
{
	cni_transform x = { t->body->q, cni_neg(cni_rotate(t->body->q, cni_body_to_local(t->body, region->origin))) };
	return x;
}

/* Manifold relative to the region's origin, with the normal towards the mover. The pair functions take the smaller type first. */
static void manifold_make(const plane_query *q, const cni_query_target *t, cni_manifold *out)
{
	cni_transform x = target_in_region(t, q->region);
	cni_manifold_cache cache = { 0, { 0, 0, 0 } };
	cni_manifold_input in = { &q->solid->g, t->geometry, 0, t->child, x, q->margin, q->sight->world->settings.slop };
	memset(out, 0, sizeof *out);
	if (q->solid->g.type <= t->geometry->type) {
		cni_manifold_function(in.a->type, in.b->type)(&in, &cache, out);
		out->normal = cni_neg(out->normal);
		return;
	}
	in.a = t->geometry;
	in.b = &q->solid->g;
	in.child_a = t->child;
	in.child_b = 0;
	in.b_in_a = cni_region_in(q->region, t->body);
	cni_manifold_function(in.a->type, in.b->type)(&in, &cache, out);
	out->normal = cni_rotate(x.q, out->normal);
	for (int32_t k = 0; k < out->count; ++k)
		out->points[k].point = cni_transform_point(x, out->points[k].point);
}

/* Greatest distance by which a one-way shape can have risen into the mover in the last step. */
static float risen(const cn_world *world, const cn_plane *p)
{
	cni_vec2 v = cni_mover_velocity_at(world, p->body, p->point_m);
	return cni_max(cni_dot(v, p->normal), 0.0f) * world->step_dt;
}

static int32_t one_way_lets_pass(const cni_sight *sight, const cni_query_target *t, const cn_plane *p)
{
	if (!cni_sight_hides_one_way(sight, t->shape))
		return 0;
	return !(cni_dot(cni_rotate(t->body->q, cni_v(0.0f, 1.0f)), p->normal) > CNI_ONE_WAY_COSINE) ||
	       p->separation_m < -sight->world->settings.slop - risen(sight->world, p);
}

static float plane_visit(void *context, int32_t proxy, float limit)
{
	plane_query *q = (plane_query *)context;
	const cn_world *world = q->sight->world;
	cni_query_target t;
	cni_manifold m;
	cn_plane p;
	if (!cni_query_target_of(q->sight, proxy, &t))
		return limit;
	manifold_make(q, &t, &m);
	if (m.count == 0)
		return limit;
	const cni_manifold_point *deepest = &m.points[m.count == 2 && m.points[1].separation < m.points[0].separation];
	memset(&p, 0, sizeof p);
	p.normal = m.normal;
	p.point_m = cni_add(q->region->origin, deepest->point);
	p.separation_m = deepest->separation;
	p.push_max_m = FLT_MAX;
	p.shape = cni_handles_of(&world->shape_handles, t.index);
	p.body = cni_handle_or_zero(&world->body_handles, t.shape->body);
	p.child = t.child;
	if (one_way_lets_pass(q->sight, &t, &p) || cni_sight_ask_target(q->sight, &t) == CN_QUERY_SKIP)
		return limit;
	cni_first_add(&q->found, &p);
	return limit;
}

/* Greatest height of the shape of one plane in front of another plane. */
static float height_over(const cn_world *world, const cni_region *region, const cn_plane *of, const cn_plane *over)
{
	cni_query_target t;
	cni_vec2 storage[2];
	cni_vec2 origin = cni_sub(over->point_m, region->origin);
	float height = -FLT_MAX;
	t.shape = cni_shape_at(world, cni_shape_index(world, of->shape));
	t.body = cni_body_at(world, t.shape->body);
	cni_transform x = target_in_region(&t, region);
	cni_proxy_points set = cni_geometry_proxy(cni_shape_geometry(&world->blocks, t.shape), of->child, storage);
	for (int32_t k = 0; k < set.count; ++k)
		height = cni_max(height, cni_dot(over->normal, cni_sub(cni_transform_point(x, set.points[k]), origin)));
	/* The point is midway between the surfaces. */
	return height + set.radius + 0.5f * over->separation_m;
}

/* Removes planes whose shape is wholly behind another plane that remains. */
static int32_t drop_hidden(const cni_sight *sight, const cni_region *region, cn_plane *planes, int32_t count)
{
	float touch = 0.1f * sight->world->settings.slop;
	int32_t j, kept;
	for (int32_t i = 0; i < count; ++i) {
		for (j = 0; j < count; ++j) {
			if (j == i || planes[j].push_max_m < 0.0f)
				continue;
			if (height_over(sight->world, region, &planes[i], &planes[j]) <= touch)
				break;
		}
		if (j < count)
			planes[i].push_max_m = -1.0f; /* marked */
	}
	for (int32_t i = kept = 0; i < count; ++i)
		if (planes[i].push_max_m >= 0.0f)
			planes[kept++] = planes[i];
	return kept;
}

/* Finds the planes of a shape: region is its place, solid the same points relative to the region's origin. */
static void planes_find(const cni_sight *sight, const cni_region *region, const cni_solid *solid, float margin, cn_plane *out, int32_t capacity,
	int32_t *out_count)
{
	plane_query q = { sight, region, solid, margin, { NULL, 0, 0, 0, 0, NULL } };
	cni_aabb box = cni_box_fatten(cni_region_box(region, cni_v(0.0f, 0.0f)), margin);
	cni_first_begin(&q.found, out, (int32_t)sizeof *out, capacity, plane_before);
	sight->world->broadphase_ops->query(sight->world->broadphase, &box, plane_visit, &q);
	cni_first_end(&q.found);
	*out_count = q.found.total > q.found.held ? q.found.total : drop_hidden(sight, region, out, q.found.held);
}

/* ------------------------------------------------------------------ solving */

static float height_at(const cn_plane *p, cni_vec2 x)
{
	return p->separation_m + cni_dot(p->normal, x);
}

/* The wanted point, moved by all pushes. */
static cni_vec2 pushed(const cn_plane *planes, int32_t count, cni_vec2 wanted)
{
	for (int32_t i = 0; i < count; ++i)
		wanted = cni_madd(wanted, planes[i].push_m, planes[i].normal);
	return wanted;
}

/* Depth of a point in planes that are not saturated. */
static float overlap_at(const cn_plane *planes, int32_t count, cni_vec2 x)
{
	float overlap = 0.0f;
	for (int32_t i = 0; i < count; ++i)
		if (planes[i].push_m < planes[i].push_max_m)
			overlap = cni_max(overlap, -height_at(planes + i, x));
	return overlap;
}

/* No room: each plane pulls by its share of its remaining overlap. */
static cni_vec2 compromise(cn_plane *planes, int32_t count, cni_vec2 wanted)
{
	float share = 1.0f / (float)count;
	cni_vec2 x = wanted;
	for (int32_t i = 0; i < count; ++i)
		planes[i].push_m = 0.0f;
	for (int32_t k = 0; k < SHARES_MAX; ++k) {
		cni_vec2 from = x;
		for (int32_t i = 0; i < count; ++i)
			planes[i].push_m = cni_min(planes[i].push_m + share * cni_max(-height_at(planes + i, from), 0.0f), planes[i].push_max_m);
		x = pushed(planes, count, wanted);
	}
	return x;
}

/* The nearest point found so far and the planes that hold it. */
typedef struct held {
	cni_vec2 x;
	int32_t i, j;           /* CNI_NONE for fewer than two or one */
	float push_i, push_j;
	float distance_sq;      /* from the wanted point; FLT_MAX: no permitted point */
} held;

/* Takes a candidate that is nearer, if no unsaturated plane forbids it. */
static void held_try(held *best, const cn_plane *planes, int32_t count, cni_vec2 wanted, float size, held candidate)
{
	candidate.distance_sq = cni_distance_sq(candidate.x, wanted);
	if (!(candidate.push_i >= 0.0f && candidate.push_j >= 0.0f && candidate.distance_sq < best->distance_sq))
		return;
	float tolerance = ROUNDING * (size + cni_sqrt(candidate.distance_sq));
	for (int32_t k = 0; k < count; ++k)
		if (!(planes[k].push_m > 0.0f) && height_at(planes + k, candidate.x) < -tolerance)
			return;
	*best = candidate;
}

/* Tries the crossing of two planes. It is computed along the first one and lies on both up to rounding, at any angle. */
static void held_try_pair(held *best, const cn_plane *planes, int32_t count, cni_vec2 wanted, float size, int32_t i, int32_t j)
{
	const cn_plane *p = planes + i, *q = planes + j;
	cni_vec2 along = cni_left_perp(p->normal);
	float sine = cni_dot(q->normal, along);
	cni_vec2 on_p = cni_madd(wanted, -height_at(p, wanted), p->normal), on_q = cni_madd(wanted, -height_at(q, wanted), q->normal);
	held candidate = { { 0.0f, 0.0f }, i, j, 0.0f, 0.0f, 0.0f };
	if (q->push_m > 0.0f || !(cni_abs(sine) > PARALLEL_SINE))
		return;
	candidate.x = cni_madd(on_p, -height_at(q, on_p) / sine, along);
	candidate.push_i = -height_at(p, on_q) / (sine * sine);
	candidate.push_j = -height_at(q, on_p) / (sine * sine);
	held_try(best, planes, count, wanted, size, candidate);
}

/* Nearest point permitted by the unsaturated planes; saturated planes (push_m > 0) have moved wanted and are no bounds. */
static held held_find(const cn_plane *planes, int32_t count, cni_vec2 wanted, float size)
{
	held best = { wanted, CNI_NONE, CNI_NONE, 0.0f, 0.0f, FLT_MAX };
	held candidate = { wanted, CNI_NONE, CNI_NONE, 0.0f, 0.0f, 0.0f };
	held_try(&best, planes, count, wanted, size, candidate);
	for (int32_t i = 0; i < count && best.distance_sq > 0.0f; ++i) {
		if (planes[i].push_m > 0.0f)
			continue;
		candidate.i = i;
		candidate.push_i = -height_at(planes + i, wanted);
		candidate.x = cni_madd(wanted, candidate.push_i, planes[i].normal);
		held_try(&best, planes, count, wanted, size, candidate);
		for (int32_t j = 0; j < i; ++j)
			held_try_pair(&best, planes, count, wanted, size, i, j);
	}
	return best;
}

/* Estimates the saturated planes by sweeps of coordinate ascent in the dual (Hildreth 1957): each plane in turn moves the point out of
   itself, minus its earlier excess. Sets push_m of the saturated planes, and 0 for all others. */
static void saturate(cn_plane *planes, int32_t count, cni_vec2 x)
{
	int32_t bounded = 0;
	for (int32_t i = 0; i < count; ++i)
		bounded |= planes[i].push_max_m < FLT_MAX;
	for (int32_t k = 0; k < SWEEPS_MAX && bounded; ++k)
		for (int32_t i = 0; i < count; ++i) {
			float push = cni_clamp(planes[i].push_m - height_at(planes + i, x), 0.0f, planes[i].push_max_m);
			x = cni_madd(x, push - planes[i].push_m, planes[i].normal);
			planes[i].push_m = push;
		}
	for (int32_t i = 0; i < count; ++i)
		planes[i].push_m = bounded && planes[i].push_m >= planes[i].push_max_m ? cni_max(planes[i].push_max_m, FLT_MIN) : 0.0f;
}

/* Saturates a plane that would have to push farther than push_max_m. */
static int32_t saturate_held(cn_plane *planes, int32_t i, float push)
{
	if (i == CNI_NONE || push <= planes[i].push_max_m)
		return 0;
	planes[i].push_m = cni_max(planes[i].push_max_m, FLT_MIN);
	return 1;
}

/* A saturated plane with the point in front of it pushes too far: releases the one with the point farthest in front. */
static int32_t release(cn_plane *planes, int32_t count, cni_vec2 x, float tolerance)
{
	cn_plane *most = NULL;
	for (int32_t i = 0; i < count; ++i)
		if (planes[i].push_m > 0.0f && height_at(planes + i, x) > (most == NULL ? tolerance : height_at(most, x)))
			most = planes + i;
	if (most != NULL)
		most->push_m = 0.0f;
	return most != NULL;
}

/* As cn_mover_solve. */
static cni_vec2 planes_solve(cn_plane *planes, int32_t count, cni_vec2 wanted, float *out_overlap)
{
	float size = cni_length(wanted);
	cni_vec2 x;
	held found;
	int32_t changes = 0;
	for (int32_t i = 0; i < count; ++i) {
		planes[i].push_m = 0.0f;
		size = cni_max(size, cni_abs(planes[i].separation_m));
	}
	saturate(planes, count, wanted);
	do {
		x = pushed(planes, count, wanted);
		found = held_find(planes, count, x, size);
	} while (++changes < CHANGES_MAX && (saturate_held(planes, found.i, found.push_i) || saturate_held(planes, found.j, found.push_j) ||
		(found.distance_sq < FLT_MAX && release(planes, count, found.x, ROUNDING * size))));
	if (found.distance_sq == FLT_MAX) {
		x = compromise(planes, count, wanted);
	} else {
		if (found.i != CNI_NONE)
			planes[found.i].push_m = found.push_i;
		if (found.j != CNI_NONE)
			planes[found.j].push_m = found.push_j;
		x = found.x;
	}
	*out_overlap = overlap_at(planes, count, x);
	return x;
}

cni_vec2 cni_planes_clip(const cn_plane *planes, const float *speeds, int32_t count, cni_vec2 v)
{
	cn_plane rigid[CN_PLANES_MAX];
	float overlap;
	for (int32_t i = 0; i < count; ++i) {
		rigid[i] = planes[i];
		rigid[i].separation_m = -speeds[i];
		rigid[i].push_max_m = FLT_MAX;
	}
	return planes_solve(rigid, count, v, &overlap);
}

cni_vec2 cni_mover_velocity_at(const cn_world *world, cn_body body, cni_vec2 point)
{
	return cni_body_velocity_at(world, cni_body_at(world, cni_body_index(world, body)), point);
}

/* ------------------------------------------------------------------ sliding */

void cni_move_place(cni_move *m, cni_vec2 position)
{
	m->mover->position_m = position;
	m->full.origin = m->core.origin = cni_add(position, m->offset);
}

/* Finds the planes that it touches. */
static void touch(cni_move *m)
{
	int32_t found;
	planes_find(&m->sight, &m->full, &m->solid, m->margin, m->planes.at, CNI_MOVER_PLANES_MAX, &found);
	m->planes.count = cni_min_i(found, CNI_MOVER_PLANES_MAX);
}

cni_vec2 cni_move_block_steep(const cni_move *m, cni_vec2 v)
{
	for (int32_t k = 0; k < m->planes.count; ++k) {
		cni_vec2 normal = m->planes.at[k].normal;
		float height = cni_dot(normal, m->up), into;
		cni_vec2 level = cni_normalize(cni_madd(normal, -height, m->up));
		if (!(height > 0.0f && height < m->walkable))
			continue;
		into = cni_dot(level, v);
		if (into < 0.0f)
			v = cni_madd(v, -into, level);
	}
	return v;
}

void cni_move_slide(cni_move *m, cni_vec2 translation)
{
	cni_vec2 target = cni_add(m->mover->position_m, translation);
	float least = MOVED_PER_SLOP * m->world->settings.slop;
	for (int32_t k = 0; k <= m->def->iterations_max; ++k) {
		cni_vec2 wanted = cni_sub(target, m->mover->position_m);
		if (k == m->def->iterations_max) /* only out of the surfaces that the last round hit */
			wanted = cni_v(0.0f, 0.0f);
		touch(m);
		wanted = planes_solve(m->planes.at, m->planes.count, cni_move_block_steep(m, wanted), &m->mover->squeezed_m);
		if (cni_length(wanted) <= least) {
			cni_move_place(m, cni_add(m->mover->position_m, wanted));
			return;
		}
		cn_ray_hit hit = cni_region_cast(&m->sight, &m->core, wanted);
		cni_move_place(m, cni_madd(m->mover->position_m, hit.fraction, wanted));
	}
	touch(m);
}

/* ------------------------------------------------------------------ public functions */

cn_result cn_mover_collide(const cn_world *world, const cn_polygon *shape, float position_x_m, float position_y_m, float margin_m,
	const cn_query_filter *filter, cn_plane *out, int32_t capacity, int32_t *out_count)
{
	cni_call call = cni_enter_const(world);
	cni_vec2 position = { position_x_m, position_y_m };
	cni_sight sight = cni_check_filter(&call, filter);
	cni_region region;
	cni_solid solid;
	cni_check_region(&call, shape, &region);
	cni_check_position(&call, "position_m", position);
	cni_check_range(&call, "margin_m", margin_m, 0.0f, CNI_COORDINATE_MAX);
	cni_check_output(&call, out, capacity, out_count);
	if (call.result != CN_OK)
		return call.result;
	cn_polygon from_origin = cni_region_polygon(&region);
	cni_solid_make(&from_origin, &solid);
	region.origin = cni_add(region.origin, position);
	sight.without = CN_SHAPE_SENSOR;
	planes_find(&sight, &region, &solid, margin_m, out, capacity, out_count);
	return CN_OK;
}

static void check_planes(cni_call *call, const cn_plane *planes, int32_t count)
{
	cni_check_array(call, "planes", planes, count);
	cni_check_range_int(call, "count", count, 0, CN_PLANES_MAX);
	for (int32_t i = 0; i < count && call->result == CN_OK; ++i) {
		float length_sq = cni_length_sq(planes[i].normal);
		cni_check_range(call, "separation_m", planes[i].separation_m, -1e9f, 1e9f);
		cni_check_at_least(call, "push_max_m", planes[i].push_max_m, 0.0f);
		cni_check(call, length_sq > 0.98f && length_sq < 1.02f, CN_ERROR_ARGUMENT, "normals must be of unit length");
	}
}

cn_result cn_mover_solve(cn_plane *planes, int32_t count, float translation_x_m, float translation_y_m, cn_vec2 *out_translation_m,
	float *out_overlap_m)
{
	cni_call call = cni_enter_free();
	check_planes(&call, planes, count);
	cni_check_within(&call, "translation_m", cni_v(translation_x_m, translation_y_m), 1e9f);
	cni_check_pointer(&call, "out_translation_m", out_translation_m);
	cni_check_pointer(&call, "out_overlap_m", out_overlap_m);
	if (call.result == CN_OK)
		*out_translation_m = planes_solve(planes, count, cni_v(translation_x_m, translation_y_m), out_overlap_m);
	return call.result;
}

cn_result cn_mover_clip(const cn_plane *planes, int32_t count, float velocity_x_mps, float velocity_y_mps, cn_vec2 *out_mps)
{
	static const float still[CN_PLANES_MAX] = { 0 };
	cni_call call = cni_enter_free();
	cn_plane pushed[CN_PLANES_MAX];
	int32_t n = 0;
	check_planes(&call, planes, count);
	for (int32_t i = 0; i < count && call.result == CN_OK; ++i)
		cni_check_finite(&call, "push_m", planes[i].push_m);
	cni_check_within(&call, "velocity_mps", cni_v(velocity_x_mps, velocity_y_mps), 1e9f);
	cni_check_pointer(&call, "out_mps", out_mps);
	if (call.result != CN_OK)
		return call.result;
	for (int32_t i = 0; i < count; ++i)
		if (planes[i].push_m > 0.0f)
			pushed[n++] = planes[i];
	*out_mps = cni_planes_clip(pushed, still, n, cni_v(velocity_x_mps, velocity_y_mps));
	return CN_OK;
}
