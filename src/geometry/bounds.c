/*
 * geometry/bounds.c - where a shape is: its tight box, and whether a point is inside of it.
 */
#include "geometry/shape.h"
#include "geometry/distance.h"

cni_aabb cni_geometry_aabb(const cni_geometry *g, int32_t child, cni_transform transform)
{
	cni_vec2 storage[2];
	cni_proxy_points set = cni_geometry_proxy(g, child, storage);
	cni_vec2 p = cni_transform_point(transform, set.points[0]);
	cni_aabb box = { p.x, p.y, p.x, p.y };
	for (int32_t i = 1; i < set.count; ++i) {
		p = cni_transform_point(transform, set.points[i]);
		box.x0 = cni_min(p.x, box.x0);
		box.y0 = cni_min(p.y, box.y0);
		box.x1 = cni_max(p.x, box.x1);
		box.y1 = cni_max(p.y, box.y1);
	}
	box.x0 -= set.radius;
	box.y0 -= set.radius;
	box.x1 += set.radius;
	box.y1 += set.radius;
	return box;
}

static float point_to_segment_sq(cni_vec2 point, cni_vec2 a, cni_vec2 b)
{
	cni_vec2 edge = cni_sub(b, a);
	float t = cni_clamp(cni_dot(cni_sub(point, a), edge) / cni_length_sq(edge), 0.0f, 1.0f);
	return cni_distance_sq(point, cni_madd(a, t, edge));
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
		return cni_distance_sq(local, p[0]) <= g->radius * g->radius;
	case CN_SHAPE_CAPSULE:
		return point_to_segment_sq(local, p[0], p[1]) <= g->radius * g->radius;
	case CN_SHAPE_POLYGON:
		return polygon_contains(g, local);
	default:
		return 0;
	}
}
