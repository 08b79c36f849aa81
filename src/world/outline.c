/*
 * world/outline.c - public functions that make points of shapes: convex hull and box; convex pieces, simplification and outlines of a
 * grid's cells. They need no world.
 */
#include "geometry/outline.h"
#include "world/error.h"

#include <string.h>

static void check_points(cni_call *call, const cn_vec2 *points_m, int32_t count, int32_t count_min, int32_t count_max)
{
	cni_check_pointer(call, "points_m", points_m);
	cni_check_range_int(call, "count", count, count_min, count_max);
	for (int32_t k = 0; k < count && call->result == CN_OK; ++k)
		cni_check_within(call, "points_m", points_m[k], CNI_COORDINATE_MAX);
}

/* ------------------------------------------------------------------ hull and box */

#define HULL_POINTS_MAX 65536

/* Without a world there is no length unit: 5 mm, at most 5% of a small hull's half size and at least 0.5% of a large hull's. Hulls of
   0.1 m or more then pass the checks of a default world. */
static float hull_tolerance(const cn_vec2 *points, int32_t count)
{
	cni_aabb box = cni_aabb_of(points[0], points[0]);
	for (int32_t k = 1; k < count; ++k)
		box = cni_aabb_with_point(box, points[k]);
	float half = 0.5f * cni_max(box.x1 - box.x0, box.y1 - box.y0);
	return cni_max(cni_min(0.05f * half, 0.005f), 0.005f * half);
}

cn_result cn_polygon_make_hull(const cn_vec2 *points_m, int32_t count, float radius_m, cn_polygon *out)
{
	cni_call call = cni_enter_free();
	check_points(&call, points_m, count, 3, HULL_POINTS_MAX);
	cni_check_pointer(&call, "out", out);
	cni_check_range(&call, "radius_m", radius_m, 0.0f, CNI_COORDINATE_MAX);
	if (call.result != CN_OK)
		return call.result;
	if (cni_hull_make(points_m, count, hull_tolerance(points_m, count), out) != NULL)
		return CN_ERROR_ARGUMENT;
	out->radius_m = radius_m;
	return CN_OK;
}

cn_result cn_polygon_make_box(float half_width_m, float half_height_m, float center_x_m, float center_y_m, float angle_rad, float radius_m, cn_polygon *out)
{
	cn_vec2 center_m = { center_x_m, center_y_m };
	static const float sx[4] = { -1.0f, 1.0f, 1.0f, -1.0f };
	static const float sy[4] = { -1.0f, -1.0f, 1.0f, 1.0f };
	cni_call call = cni_enter_free();
	cni_transform x;
	cni_check_positive(&call, "half_width_m", half_width_m);
	cni_check_positive(&call, "half_height_m", half_height_m);
	cni_check_within(&call, "half_width_m, half_height_m", cni_v(half_width_m, half_height_m), CNI_COORDINATE_MAX);
	cni_check_within(&call, "center_m", center_m, CNI_COORDINATE_MAX);
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
	for (int32_t k = 0; k < 4; ++k)
		out->points_m[k] = cni_transform_point(x, cni_v(sx[k] * half_width_m, sy[k] * half_height_m));
	return CN_OK;
}

/* ------------------------------------------------------------------ outlines */

cn_result cn_outline_decompose(const cn_vec2 *points_m, int32_t count, float length_unit_m, cn_polygon *out, int32_t capacity, int32_t *out_count)
{
	cni_call call = cni_enter_free();
	int32_t pieces;
	check_points(&call, points_m, count, 3, CNI_OUTLINE_POINTS_MAX);
	cni_check_range(&call, "length_unit_m", length_unit_m, 1e-6f, 1e6f);
	cni_check_output(&call, out, capacity, out_count);
	if (call.result != CN_OK)
		return call.result;
	if (cni_outline_decompose(points_m, count, CNI_THICKNESS_LEAST * length_unit_m, out, capacity, &pieces) != NULL)
		return CN_ERROR_ARGUMENT;
	*out_count = pieces;
	return CN_OK;
}

cn_result cn_outline_simplify(const cn_vec2 *points_m, int32_t count, int32_t closed, float tolerance_m, cn_vec2 *out, int32_t capacity, int32_t *out_count)
{
	cni_call call = cni_enter_free();
	cni_check_range_int(&call, "closed", closed, 0, 1);
	check_points(&call, points_m, count, closed ? 3 : 2, CNI_SIMPLIFY_POINTS_MAX);
	cni_check_range(&call, "tolerance_m", tolerance_m, 0.0f, CNI_COORDINATE_MAX);
	cni_check_output(&call, out, capacity, out_count);
	if (call.result == CN_OK)
		*out_count = cni_outline_simplify(points_m, count, closed, tolerance_m, out, capacity);
	return call.result;
}

static cni_grid grid_make(int32_t count, int32_t columns, float origin_x_m, float origin_y_m, float spacing)
{
	cni_grid grid = { NULL, NULL, 0.0f, columns, columns > 0 ? count / columns : 0, { origin_x_m, origin_y_m }, spacing };
	return grid;
}

/* Every coordinate of the grid must be one that shapes take. */
static void check_grid(cni_call *call, const cni_grid *grid, int32_t count, int32_t side_min, const char *spacing)
{
	cni_vec2 size = { (float)grid->columns * grid->spacing, (float)grid->rows * grid->spacing };
	cni_check_range_int(call, "columns", grid->columns, side_min, CNI_GRID_SIDE_MAX);
	cni_check_range_int(call, "count / columns", grid->rows, side_min, CNI_GRID_SIDE_MAX);
	if (call->result == CN_OK && grid->columns * grid->rows != count)
		cni_refuse_int(call, "count", count, "must be a multiple of columns");
	cni_check_within(call, "origin_m", grid->origin, CNI_COORDINATE_MAX);
	cni_check_positive(call, spacing, grid->spacing);
	cni_check_within(call, spacing, size, CNI_COORDINATE_MAX);
	cni_check_within(call, "origin_m", cni_add(grid->origin, size), CNI_COORDINATE_MAX);
}

static void check_values(cni_call *call, const float *values, int32_t count)
{
	cni_check_pointer(call, "values", values);
	for (int32_t k = 0; call->result == CN_OK && k < count; ++k)
		cni_check_finite(call, "values", values[k]);
}

static cn_result outline_write(cni_call *call, const cni_grid *grid, int32_t number, cni_outline_out out, int32_t *out_count)
{
	cni_check_range_int(call, "outline", number, 0, INT32_MAX);
	cni_check_output(call, out.points, out.capacity, out_count);
	if (call->result != CN_OK)
		return call->result;
	cni_outline_from_grid(grid, number, &out);
	*out_count = out.count;
	return CN_OK;
}

cn_result cn_outline_from_cells(const uint8_t *cells, int32_t count, int32_t columns, float origin_x_m, float origin_y_m, float cell_m, int32_t outline,
                                cn_vec2 *out, int32_t capacity, int32_t *out_count)
{
	cni_call call = cni_enter_free();
	cni_grid grid = grid_make(count, columns, origin_x_m, origin_y_m, cell_m);
	cni_outline_out points = { out, capacity, 0 };
	grid.solid = cells;
	cni_check_pointer(&call, "cells", cells);
	check_grid(&call, &grid, count, 1, "cell_m");
	return outline_write(&call, &grid, outline, points, out_count);
}

cn_result cn_outline_from_field(const float *values, int32_t count, int32_t columns, float threshold, float origin_x_m, float origin_y_m, float spacing_m,
                                int32_t outline, cn_vec2 *out, int32_t capacity, int32_t *out_count)
{
	cni_call call = cni_enter_free();
	cni_grid grid = grid_make(count, columns, origin_x_m, origin_y_m, spacing_m);
	cni_outline_out points = { out, capacity, 0 };
	grid.values = values;
	grid.threshold = threshold;
	check_grid(&call, &grid, count, 2, "spacing_m");
	cni_check_finite(&call, "threshold", threshold);
	check_values(&call, values, count);
	return outline_write(&call, &grid, outline, points, out_count);
}
