/*
 * world/mover_plane.c - public functions on the planes that bound a mover: which there are, and where they let it go.
 *
 * A plane is how the mover's shape touches another one, by the pair functions of the narrowphase: so inner vertices of chains
 * and hidden corners of tiles act as they do in a step.
 *
 * The solver looks for the nearest point to the wanted one in an intersection of half planes: Hildreth's method (1957),
 * coordinate ascent in the dual. Each plane in turn moves the point out of itself, less what it had pushed too much before;
 * the pushes stay in [0, push_max]. For one plane or perpendicular ones it is exact in one sweep, for two at an angle the
 * error shrinks by the squared cosine between their normals in each.
 */
#include "world/mover.h"
#include "geometry/manifold.h"

#include <string.h>

#define SWEEPS_MAX 64
/* Of the lengths involved: a sweep that changes less ends it. */
#define SWEEP_TOLERANCE 1e-7f
/* Least cosine between the upper side of a one-way shape and the normal. */
#define ONE_WAY_COSINE 0.7f

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
	if (x->separation_m != y->separation_m)
		return x->separation_m < y->separation_m;
	if (x->shape != y->shape)
		return cni_index_of(x->shape) < cni_index_of(y->shape);
	return x->child < y->child;
}

/* Maps the frame of a target's body to that of the region's origin. */
static cni_transform target_in_region(const cni_query_target *t, const cni_region *region)
{
	cni_transform x;
	x.q = t->body->q;
	x.t = cni_neg(cni_rotate(x.q, cni_query_to_local(t->body, region->origin)));
	return x;
}

/* Seen from the region's origin, the normal towards the mover. The pair functions take the lesser type first. */
static void manifold_make(const plane_query *q, const cni_query_target *t, cni_manifold *out)
{
	cni_transform x = target_in_region(t, q->region);
	cni_manifold_cache cache = { 0, 0, { 0, 0 } };
	cni_manifold_input in = { &q->solid->g, t->geometry, 0, t->child, x, q->margin, q->sight->world->settings.slop };
	int32_t k;
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
	for (k = 0; k < out->count; ++k)
		out->points[k].point = cni_transform_point(x, out->points[k].point);
}

/* How far a one-way shape may have come up into the mover since the last step. */
static float risen(const cn_world *world, const cn_plane *p)
{
	cni_vec2 v = cni_mover_velocity_at(world, p->body, p->point_m);
	return cni_max(cni_dot(v, p->normal), 0.0f) * world->step_dt;
}

static int32_t one_way_lets_pass(const cni_sight *sight, const cni_query_target *t, const cn_plane *p)
{
	if (!cni_sight_hides_one_way(sight, t->shape))
		return 0;
	return !(cni_dot(cni_query_turn_to_world(t->body, cni_v(0.0f, 1.0f)), p->normal) > ONE_WAY_COSINE) ||
	       p->separation_m < -sight->world->settings.slop - risen(sight->world, p);
}

static float plane_visit(void *context, int32_t proxy, float limit)
{
	plane_query *q = (plane_query *)context;
	const cn_world *world = q->sight->world;
	cni_query_target t;
	cni_manifold m;
	cn_plane p;
	const cni_manifold_point *deepest;
	if (!cni_query_target_of(q->sight, proxy, &t))
		return limit;
	manifold_make(q, &t, &m);
	if (m.count == 0)
		return limit;
	deepest = &m.points[m.count == 2 && m.points[1].separation < m.points[0].separation];
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

/* How far the shape of a plane reaches in front of another plane. */
static float height_over(const cn_world *world, const cni_region *region, const cn_plane *of, const cn_plane *over)
{
	cni_query_target t;
	cni_vec2 storage[2];
	cni_proxy_points set;
	cni_transform x;
	float height = -FLT_MAX;
	int32_t k;
	t.shape = cni_shape_at(world, cni_index_of(of->shape));
	t.body = cni_body_at(world, t.shape->body);
	x = target_in_region(&t, region);
	set = cni_geometry_proxy(cni_shape_geometry(&world->blocks, t.shape), of->child, storage);
	for (k = 0; k < set.count; ++k)
		height = cni_max(height, cni_dot(over->normal, cni_sub(cni_transform_point(x, set.points[k]), cni_sub(over->point_m, region->origin))));
	/* The point lies midway between the surfaces. */
	return height + set.radius + 0.5f * over->separation_m;
}

/* Leaves out what is behind another plane that stays. */
static int32_t drop_hidden(const cni_sight *sight, const cni_region *region, cn_plane *planes, int32_t count)
{
	float touch = 0.1f * sight->world->settings.slop;
	int32_t i, j, kept;
	for (i = 0; i < count; ++i) {
		for (j = 0; j < count; ++j) {
			if (j == i || planes[j].push_max_m < 0.0f)
				continue;
			if (height_over(sight->world, region, &planes[i], &planes[j]) <= touch)
				break;
		}
		if (j < count)
			planes[i].push_max_m = -1.0f; /* marked */
	}
	for (i = kept = 0; i < count; ++i)
		if (planes[i].push_max_m >= 0.0f)
			planes[kept++] = planes[i];
	return kept;
}

void cni_planes_find(const cni_sight *sight, const cni_region *region, const cni_solid *solid, float margin, cn_plane *out, int32_t capacity, int32_t *out_count)
{
	plane_query q;
	cni_aabb box = cni_region_box(region, cni_v(0.0f, 0.0f));
	q.sight = sight;
	q.region = region;
	q.solid = solid;
	q.margin = margin;
	cni_first_begin(&q.found, out, (int32_t)sizeof *out, capacity, plane_before);
	box.x0 -= margin;
	box.y0 -= margin;
	box.x1 += margin;
	box.y1 += margin;
	sight->world->broadphase_ops->query(sight->world->broadphase, &box, plane_visit, &q);
	cni_first_end(&q.found);
	*out_count = q.found.total > q.found.held ? q.found.total : drop_hidden(sight, region, out, q.found.held);
}

/* ------------------------------------------------------------------ solving */

/* One sweep; returns the greatest change of a push. *sum: of the point after each push, *pushes: how many. */
static float sweep(cn_plane *planes, int32_t count, cni_vec2 *x, cni_vec2 *sum, int32_t *pushes)
{
	float most = 0.0f;
	int32_t i;
	*sum = cni_v(0.0f, 0.0f);
	*pushes = 0;
	for (i = 0; i < count; ++i) {
		cn_plane *p = planes + i;
		float push = cni_clamp(p->push_m - (p->separation_m + cni_dot(p->normal, *x)), 0.0f, p->push_max_m);
		*x = cni_madd(*x, push - p->push_m, p->normal);
		most = cni_max(most, cni_abs(push - p->push_m));
		p->push_m = push;
		if (push > 0.0f) {
			*sum = cni_add(*sum, *x);
			++*pushes;
		}
	}
	return most;
}

cni_vec2 cni_planes_solve(cn_plane *planes, int32_t count, cni_vec2 wanted, float *out_overlap)
{
	cni_vec2 x = wanted, sum = { 0.0f, 0.0f };
	float size = cni_length(wanted), change = FLT_MAX;
	int32_t i, k, pushes = 0;
	for (i = 0; i < count; ++i) {
		planes[i].push_m = 0.0f;
		size = cni_max(size, cni_abs(planes[i].separation_m));
	}
	for (k = 0; k < SWEEPS_MAX && change > SWEEP_TOLERANCE * size; ++k)
		change = sweep(planes, count, &x, &sum, &pushes);
	/* No room for all of them: each has it its way once a sweep. */
	if (change > SWEEP_TOLERANCE * size && pushes > 0)
		x = cni_mul(1.0f / (float)pushes, sum);
	*out_overlap = 0.0f;
	for (i = 0; i < count; ++i)
		if (planes[i].push_m < planes[i].push_max_m)
			*out_overlap = cni_max(*out_overlap, -(planes[i].separation_m + cni_dot(planes[i].normal, x)));
	return x;
}

cni_vec2 cni_planes_clip(const cn_plane *planes, const float *speeds, int32_t count, cni_vec2 v)
{
	cn_plane rigid[CN_PLANES_MAX];
	float overlap;
	int32_t i;
	for (i = 0; i < count; ++i) {
		rigid[i] = planes[i];
		rigid[i].separation_m = -speeds[i];
		rigid[i].push_max_m = FLT_MAX;
	}
	return cni_planes_solve(rigid, count, v, &overlap);
}

cni_vec2 cni_mover_velocity_at(const cn_world *world, cn_body body, cni_vec2 point)
{
	const cni_body *b = cni_body_at(world, cni_index_of(body));
	cn_velocity v = cni_body_velocity(world, b);
	cni_vec2 arm = cni_sub(cni_sub(point, cni_v(b->cx, b->cy)), cni_v(b->cx_low, b->cy_low));
	return cni_madd(v.linear_mps, v.angular_radps, cni_left_perp(arm));
}

/* ------------------------------------------------------------------ public */

cn_result cn_mover_collide(const cn_world *world, const cn_polygon *shape, float position_x_m, float position_y_m, float margin_m,
	const cn_query_filter *filter, cn_plane *out, int32_t capacity, int32_t *out_count)
{
	cni_call call = cni_enter_const(world);
	cni_sight sight = cni_check_filter(&call, filter);
	cni_region region;
	cni_solid solid;
	cn_polygon from_origin;
	cni_check_region(&call, shape, &region);
	if (call.result == CN_OK)
		cni_check_position(&call, "position_m", cni_v(position_x_m, position_y_m));
	if (call.result == CN_OK)
		cni_check_range(&call, "margin_m", margin_m, 0.0f, CNI_COORDINATE_MAX);
	cni_check_capacity(&call, "out", out, capacity);
	cni_check_pointer(&call, "out_count", out_count);
	if (call.result != CN_OK)
		return call.result;
	from_origin.count = region.count;
	from_origin.radius_m = region.radius;
	memcpy(from_origin.points_m, region.points, sizeof from_origin.points_m);
	cni_solid_make(&from_origin, &solid);
	region.origin = cni_add(region.origin, cni_v(position_x_m, position_y_m));
	sight.without = CNI_SIGHT_WITHOUT_SENSORS;
	cni_planes_find(&sight, &region, &solid, margin_m, out, capacity, out_count);
	return CN_OK;
}

static void check_planes(cni_call *call, const cn_plane *planes, int32_t count)
{
	int32_t i;
	cni_check_array(call, "planes", planes, count);
	cni_check_range_int(call, "count", count, 0, CN_PLANES_MAX);
	for (i = 0; i < count && call->result == CN_OK; ++i) {
		float length_sq = cni_length_sq(planes[i].normal);
		cni_check_range(call, "separation_m", planes[i].separation_m, -1e9f, 1e9f);
		cni_check_at_least(call, "push_max_m", planes[i].push_max_m, 0.0f);
		if (call->result == CN_OK && !(length_sq > 0.98f && length_sq < 1.02f))
			cni_refuse(call, CN_ERROR_ARGUMENT, "normals must be of unit length");
	}
}

cn_result cn_mover_solve(cn_plane *planes, int32_t count, float translation_x_m, float translation_y_m, cn_vec2 *out_translation_m, float *out_overlap_m)
{
	cni_call call = cni_enter_free();
	check_planes(&call, planes, count);
	cni_check_range(&call, "translation_x_m", translation_x_m, -1e9f, 1e9f);
	cni_check_range(&call, "translation_y_m", translation_y_m, -1e9f, 1e9f);
	cni_check_pointer(&call, "out_translation_m", out_translation_m);
	cni_check_pointer(&call, "out_overlap_m", out_overlap_m);
	if (call.result != CN_OK)
		return call.result;
	*out_translation_m = cni_planes_solve(planes, count, cni_v(translation_x_m, translation_y_m), out_overlap_m);
	return CN_OK;
}

cn_result cn_mover_clip(const cn_plane *planes, int32_t count, float velocity_x_mps, float velocity_y_mps, cn_vec2 *out_mps)
{
	static const float still[CN_PLANES_MAX];
	cni_call call = cni_enter_free();
	cn_plane pushed[CN_PLANES_MAX];
	int32_t i, n = 0;
	check_planes(&call, planes, count);
	for (i = 0; i < count && call.result == CN_OK; ++i)
		cni_check_finite(&call, "push_m", planes[i].push_m);
	cni_check_range(&call, "velocity_x_mps", velocity_x_mps, -1e9f, 1e9f);
	cni_check_range(&call, "velocity_y_mps", velocity_y_mps, -1e9f, 1e9f);
	cni_check_pointer(&call, "out_mps", out_mps);
	if (call.result != CN_OK)
		return call.result;
	for (i = 0; i < count; ++i)
		if (planes[i].push_m > 0.0f)
			pushed[n++] = planes[i];
	*out_mps = cni_planes_clip(pushed, still, n, cni_v(velocity_x_mps, velocity_y_mps));
	return CN_OK;
}
