/*
 * world/outline.c - public functions on outlines: convex pieces, simplification, outlines of a grid's cells. They need no world.
 */
#include "geometry/outline.h"
#include "world/error.h"

static void check_points(cni_call *call, const cn_vec2 *points_m, int32_t count, int32_t count_min, int32_t count_max)
{
	int32_t k;
	cni_check_pointer(call, "points_m", points_m);
	cni_check_range_int(call, "count", count, count_min, count_max);
	for (k = 0; k < count && call->result == CN_OK; ++k) {
		cni_check_range(call, "points_m.x", points_m[k].x, -CNI_COORDINATE_MAX, CNI_COORDINATE_MAX);
		cni_check_range(call, "points_m.y", points_m[k].y, -CNI_COORDINATE_MAX, CNI_COORDINATE_MAX);
	}
}

cn_result cn_outline_decompose(const cn_vec2 *points_m, int32_t count, float length_unit_m, cn_polygon *out, int32_t capacity, int32_t *out_count)
{
	cni_call call = cni_enter_free();
	int32_t pieces;
	check_points(&call, points_m, count, 3, CNI_OUTLINE_POINTS_MAX);
	cni_check_range(&call, "length_unit_m", length_unit_m, 1e-6f, 1e6f);
	cni_check_capacity(&call, "out", out, capacity);
	cni_check_pointer(&call, "out_count", out_count);
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
	cni_check_capacity(&call, "out", out, capacity);
	cni_check_pointer(&call, "out_count", out_count);
	if (call.result != CN_OK)
		return call.result;
	*out_count = cni_outline_simplify(points_m, count, closed, tolerance_m, out, capacity);
	return CN_OK;
}

static cni_grid grid_make(int32_t count, int32_t columns, float origin_x_m, float origin_y_m, float spacing)
{
	cni_grid grid = { NULL, NULL, 0.0f, columns, columns > 0 ? count / columns : 0, { origin_x_m, origin_y_m }, spacing };
	return grid;
}

/* Every coordinate of the grid must be one that shapes take. */
static void check_grid(cni_call *call, const cni_grid *grid, int32_t count, int32_t side_min, const char *spacing)
{
	cni_check_range_int(call, "columns", grid->columns, side_min, CNI_GRID_SIDE_MAX);
	cni_check_range_int(call, "count / columns", grid->rows, side_min, CNI_GRID_SIDE_MAX);
	if (call->result == CN_OK && grid->columns * grid->rows != count)
		cni_refuse_int(call, "count", count, "must be a multiple of columns");
	cni_check_range(call, "origin_x_m", grid->origin.x, -CNI_COORDINATE_MAX, CNI_COORDINATE_MAX);
	cni_check_range(call, "origin_y_m", grid->origin.y, -CNI_COORDINATE_MAX, CNI_COORDINATE_MAX);
	cni_check_positive(call, spacing, grid->spacing);
	cni_check_range(call, spacing, (float)cni_max_i(grid->columns, grid->rows) * grid->spacing, 0.0f, CNI_COORDINATE_MAX);
	cni_check_range(call, "origin_x_m", grid->origin.x + (float)grid->columns * grid->spacing, -CNI_COORDINATE_MAX, CNI_COORDINATE_MAX);
	cni_check_range(call, "origin_y_m", grid->origin.y + (float)grid->rows * grid->spacing, -CNI_COORDINATE_MAX, CNI_COORDINATE_MAX);
}

static void check_values(cni_call *call, const float *values, int32_t count)
{
	int32_t k;
	cni_check_pointer(call, "values", values);
	for (k = 0; call->result == CN_OK && k < count; ++k)
		cni_check_finite(call, "values", values[k]);
}

static cn_result outline_write(cni_call *call, const cni_grid *grid, int32_t number, cni_outline_out out, int32_t *out_count)
{
	cni_check_range_int(call, "outline", number, 0, INT32_MAX);
	cni_check_capacity(call, "out", out.points, out.capacity);
	cni_check_pointer(call, "out_count", out_count);
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
