/*
 * collision/nearest.c - the closest surface point. Outside the skeleton: the closest point of the nearest edge, moved out by
 * the radius. Inside a polygon: the closest point of the face of least depth.
 */
#include "collision/nearest.h"
#include "collision/distance.h"

static cni_nearest nearest_make(cni_vec2 on_skeleton, cni_vec2 normal, float height, float radius)
{
	cni_nearest n = { height - radius, cni_madd(on_skeleton, radius, normal), normal };
	return n;
}

/* 1 when the point is in the polygon's skeleton. */
static int32_t nearest_inside(const cni_geometry *g, cni_vec2 local, cni_nearest *out)
{
	const cni_vec2 *p = cni_geometry_points(g), *normals = cni_geometry_normals(g);
	int32_t best = 0;
	float most = -FLT_MAX;
	for (int32_t i = 0; i < g->count; ++i) {
		float height = cni_dot(normals[i], cni_sub(local, p[i]));
		if (height > 0.0f)
			return 0;
		if (height > most) {
			most = height;
			best = i;
		}
	}
	*out = nearest_make(cni_madd(local, -most, normals[best]), normals[best], most, g->radius);
	return 1;
}

cni_nearest cni_geometry_nearest(const cni_geometry *g, int32_t child, cni_vec2 local)
{
	cni_vec2 storage[2];
	cni_proxy_points set = cni_geometry_proxy(g, child, storage);
	cni_vec2 best = set.points[0], normal = { 1.0f, 0.0f };
	int32_t edges = set.count > 2 ? set.count : set.count - 1;
	cni_nearest inside;
	float distance;
	if (g->type == CN_SHAPE_POLYGON && nearest_inside(g, local, &inside))
		return inside;
	if (set.count == 2)
		normal = cni_normalize(cni_right_perp(cni_sub(set.points[1], set.points[0])));
	for (int32_t i = 0; i < edges; ++i) {
		cni_vec2 a = set.points[i], on = cni_segment_nearest(local, a, cni_sub(set.points[i + 1 < set.count ? i + 1 : 0], a));
		if (i == 0 || cni_distance_sq(local, on) < cni_distance_sq(local, best))
			best = on;
	}
	distance = cni_length(cni_sub(local, best));
	if (distance > 0.0f)
		normal = cni_normalize(cni_sub(local, best));
	return nearest_make(best, normal, distance, set.radius);
}
