/*
 * world/polygon.c - public functions that fill a cn_polygon: convex hull and box. They need no world.
 */
#include "world/error.h"

#include <string.h>

#define HULL_POINTS_MAX 65536

/* Without a world there is no length unit: 5 mm, at most 5% of a small hull's half size and at least 0.5% of a large hull's. Hulls of
   0.1 m or more then pass the checks of a default world. */
static float hull_tolerance(const cn_vec2 *points, int32_t count)
{
	cni_vec2 lower = points[0], upper = points[0];
	float half;
	int32_t k;
	for (k = 1; k < count; ++k) {
		lower = cni_v(cni_min(lower.x, points[k].x), cni_min(lower.y, points[k].y));
		upper = cni_v(cni_max(upper.x, points[k].x), cni_max(upper.y, points[k].y));
	}
	half = 0.5f * cni_max(upper.x - lower.x, upper.y - lower.y);
	return cni_max(cni_min(0.05f * half, 0.005f), 0.005f * half);
}

cn_result cn_polygon_make_hull(const cn_vec2 *points_m, int32_t count, float radius_m, cn_polygon *out)
{
	cni_call call = cni_enter_free();
	cn_polygon hull;
	int32_t k;
	cni_check_pointer(&call, "points_m", points_m);
	cni_check_pointer(&call, "out", out);
	cni_check_range_int(&call, "count", count, 3, HULL_POINTS_MAX);
	cni_check_range(&call, "radius_m", radius_m, 0.0f, CNI_COORDINATE_MAX);
	for (k = 0; k < count && call.result == CN_OK; ++k) {
		cni_check_range(&call, "points_m.x", points_m[k].x, -CNI_COORDINATE_MAX, CNI_COORDINATE_MAX);
		cni_check_range(&call, "points_m.y", points_m[k].y, -CNI_COORDINATE_MAX, CNI_COORDINATE_MAX);
	}
	if (call.result != CN_OK)
		return call.result;
	memset(&hull, 0, sizeof hull);
	if (cni_hull_make(points_m, count, hull_tolerance(points_m, count), &hull) != NULL)
		return CN_ERROR_ARGUMENT;
	hull.radius_m = radius_m;
	*out = hull;
	return CN_OK;
}

cn_result cn_polygon_make_box(float half_width_m, float half_height_m, float center_x_m, float center_y_m, float angle_rad, float radius_m, cn_polygon *out)
{
	cn_vec2 center_m = { center_x_m, center_y_m };
	static const float sx[4] = { -1.0f, 1.0f, 1.0f, -1.0f };
	static const float sy[4] = { -1.0f, -1.0f, 1.0f, 1.0f };
	cni_call call = cni_enter_free();
	cni_transform x;
	int32_t k;
	cni_check_positive(&call, "half_width_m", half_width_m);
	cni_check_positive(&call, "half_height_m", half_height_m);
	cni_check_range(&call, "half_width_m", half_width_m, 0.0f, CNI_COORDINATE_MAX);
	cni_check_range(&call, "half_height_m", half_height_m, 0.0f, CNI_COORDINATE_MAX);
	cni_check_range(&call, "center_m.x", center_m.x, -CNI_COORDINATE_MAX, CNI_COORDINATE_MAX);
	cni_check_range(&call, "center_m.y", center_m.y, -CNI_COORDINATE_MAX, CNI_COORDINATE_MAX);
	cni_check_angle(&call, "angle_rad", angle_rad);
	cni_check_range(&call, "radius_m", radius_m, 0.0f, CNI_COORDINATE_MAX);
	cni_check_pointer(&call, "out", out);
	if (call.result != CN_OK)
		return call.result;
	memset(out, 0, sizeof *out);
	out->count = 4;
	out->radius_m = radius_m;
	x.q = cni_sincos(angle_rad);
	x.t = center_m;
	for (k = 0; k < 4; ++k)
		out->points_m[k] = cni_transform_point(x, cni_v(sx[k] * half_width_m, sy[k] * half_height_m));
	return CN_OK;
}
