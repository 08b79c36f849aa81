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

/* Every coordinate of the grid must be one that shapes take. */
static void check_grid(cni_call *call, const cni_grid *grid, int32_t side_min, const char *spacing)
{
	cni_check_range_int(call, "columns", grid->columns, side_min, CNI_GRID_SIDE_MAX);
	cni_check_range_int(call, "rows", grid->rows, side_min, CNI_GRID_SIDE_MAX);
	cni_check_range(call, "origin_x_m", grid->origin.x, -CNI_COORDINATE_MAX, CNI_COORDINATE_MAX);
	cni_check_range(call, "origin_y_m", grid->origin.y, -CNI_COORDINATE_MAX, CNI_COORDINATE_MAX);
	cni_check_positive(call, spacing, grid->spacing);
	cni_check_range(call, spacing, (float)cni_max_i(grid->columns, grid->rows) * grid->spacing, 0.0f, CNI_COORDINATE_MAX);
	cni_check_range(call, "origin_x_m", grid->origin.x + (float)grid->columns * grid->spacing, -CNI_COORDINATE_MAX, CNI_COORDINATE_MAX);
	cni_check_range(call, "origin_y_m", grid->origin.y + (float)grid->rows * grid->spacing, -CNI_COORDINATE_MAX, CNI_COORDINATE_MAX);
}

static void check_values(cni_call *call, const cni_grid *grid)
{
	size_t k, count = (size_t)grid->columns * (size_t)grid->rows;
	cni_check_finite(call, "threshold", grid->threshold);
	cni_check_pointer(call, "values", grid->values);
	for (k = 0; call->result == CN_OK && k < count; ++k)
		cni_check_finite(call, "values", grid->values[k]);
}

static cn_result outlines_write(cni_call *call, const cni_grid *grid, cni_outlines *out, int32_t *out_point_count, int32_t *out_outline_count)
{
	cni_check_capacity(call, "out_points", out->points, out->point_capacity);
	cni_check_capacity(call, "out_counts", out->counts, out->outline_capacity);
	cni_check_pointer(call, "out_point_count", out_point_count);
	cni_check_pointer(call, "out_outline_count", out_outline_count);
	if (call->result != CN_OK)
		return call->result;
	cni_outline_from_grid(grid, out);
	*out_point_count = out->point_count;
	*out_outline_count = out->outline_count;
	return CN_OK;
}

cn_result cn_outline_from_cells(const uint8_t *cells, int32_t columns, int32_t rows, float origin_x_m, float origin_y_m, float cell_m, cn_vec2 *out_points,
                                int32_t point_capacity, int32_t *out_counts, int32_t outline_capacity, int32_t *out_point_count, int32_t *out_outline_count)
{
	cni_call call = cni_enter_free();
	cni_grid grid = { cells, NULL, 0.0f, columns, rows, { origin_x_m, origin_y_m }, cell_m };
	cni_outlines out = { out_points, out_counts, point_capacity, outline_capacity, 0, 0 };
	cni_check_pointer(&call, "cells", cells);
	check_grid(&call, &grid, 1, "cell_m");
	return outlines_write(&call, &grid, &out, out_point_count, out_outline_count);
}

cn_result cn_outline_from_field(const float *values, int32_t columns, int32_t rows, float threshold, float origin_x_m, float origin_y_m, float spacing_m,
                                cn_vec2 *out_points, int32_t point_capacity, int32_t *out_counts, int32_t outline_capacity, int32_t *out_point_count,
                                int32_t *out_outline_count)
{
	cni_call call = cni_enter_free();
	cni_grid grid = { NULL, values, threshold, columns, rows, { origin_x_m, origin_y_m }, spacing_m };
	cni_outlines out = { out_points, out_counts, point_capacity, outline_capacity, 0, 0 };
	check_grid(&call, &grid, 2, "spacing_m");
	check_values(&call, &grid);
	return outlines_write(&call, &grid, &out, out_point_count, out_outline_count);
}
