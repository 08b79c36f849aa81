/*
 * geometry/bounds.c - tight boxes of shapes, the point test, and a child's convex point set.
 */
#include "base/cpu.h"
#include "geometry/shape.h"
#if CNI_HAS_WIDE_4
#define CNI_WIDTH 4
#include "base/wide.h"
#endif

static void points_box(const cni_vec2 *points, int32_t count, float radius, const cni_transform *x, cni_aabb *out)
{
	cni_vec2 p = cni_transform_point(*x, points[0]);
	cni_aabb box = { p.x, p.y, p.x, p.y };
	for (int32_t i = 1; i < count; ++i)
		box = cni_aabb_with_point(box, cni_transform_point(*x, points[i]));
	*out = cni_box_fatten(box, radius);
}

#if CNI_HAS_WIDE_4

/* Two points at once, with the bits of points_box. If count is odd, the last pair repeats a point. */
static void pairs_box(const cni_vec2 *points, int32_t count, float radius, const cni_transform *x, cni_aabb *out)
{
	const cni_wide c = cni_wide_of(x->q.c), s = { -x->q.s, x->q.s, -x->q.s, x->q.s }, t = { x->t.x, x->t.y, x->t.x, x->t.y };
	cni_wide low, high, p;
	p = cni_wide_load_loose(&points[0].x);
	low = high = c * p + s * __builtin_shufflevector(p, p, 1, 0, 3, 2) + t;
	for (int32_t i = 2; i < count; i += 2) {
		p = cni_wide_load_loose(&points[cni_min_i(i, count - 2)].x);
		p = c * p + s * __builtin_shufflevector(p, p, 1, 0, 3, 2) + t;
		low = cni_wide_min(p, low);
		high = cni_wide_max(p, high);
	}
	low = cni_wide_min(__builtin_shufflevector(low, low, 2, 3, 0, 1), low) - cni_wide_of(radius);
	high = cni_wide_max(__builtin_shufflevector(high, high, 2, 3, 0, 1), high) + cni_wide_of(radius);
	*(cni_wide_loose *)(void *)out = __builtin_shufflevector(low, high, 0, 1, 4, 5);
}

#endif

void cni_geometry_box(const cni_geometry *g, int32_t child, const cni_transform *transform, cni_aabb *out)
{
	cni_vec2 storage[2];
	cni_proxy_points set = cni_geometry_proxy(g, child, storage);
#if CNI_HAS_WIDE_4
	if (set.count > 1) {
		pairs_box(set.points, set.count, set.radius, transform, out);
		return;
	}
#endif
	points_box(set.points, set.count, set.radius, transform, out);
}

cni_aabb cni_geometry_bounds(const cni_geometry *g, cni_transform x)
{
	cni_aabb box = cni_geometry_aabb(g, 0, x);
	for (int32_t child = 1; child < cni_geometry_children(g); ++child) {
		cni_aabb one = cni_geometry_aabb(g, child, x);
		box = cni_aabb_union(&box, &one);
	}
	return box;
}

static float point_to_segment_sq(cni_vec2 point, cni_vec2 a, cni_vec2 b)
{
	return cni_distance_sq(point, cni_segment_nearest(point, a, cni_sub(b, a)));
}

static int32_t polygon_contains(const cni_geometry *g, cni_vec2 point)
{
	const cni_vec2 *p = cni_geometry_points(g);
	const cni_vec2 *normals = cni_geometry_normals(g);
	int32_t inside = 1;
	float least_sq = FLT_MAX;
	for (int32_t i = 0; i < g->count; ++i) {
		inside &= cni_dot(normals[i], cni_sub(point, p[i])) <= 0.0f;
		least_sq = cni_min(least_sq, point_to_segment_sq(point, p[i], p[i + 1 < g->count ? i + 1 : 0]));
	}
	return inside || least_sq <= g->radius * g->radius;
}

int32_t cni_geometry_contains(const cni_geometry *g, cni_vec2 local)
{
	const cni_vec2 *p = cni_geometry_points(g);
	switch (g->type) {
	case CN_SHAPE_CIRCLE:
	case CN_SHAPE_CAPSULE:
		return point_to_segment_sq(local, p[0], p[g->count - 1]) <= g->radius * g->radius;
	case CN_SHAPE_POLYGON:
		return polygon_contains(g, local);
	default:
		return 0;
	}
}

cni_proxy_points cni_geometry_proxy(const cni_geometry *g, int32_t child, cni_vec2 edge_storage[2])
{
	const cni_vec2 *p = cni_geometry_points(g);
	cni_proxy_points set = { p, g->count, g->radius };
	if (!cni_is_chain(g->type))
		return set;
	edge_storage[0] = p[child];
	edge_storage[1] = p[child + 1 < g->count ? child + 1 : 0];
	set.points = edge_storage;
	set.count = 2;
	return set;
}
