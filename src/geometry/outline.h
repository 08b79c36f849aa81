/*
 * geometry/outline.h - outlines: closed or open rows of points that need not be convex. Pure functions; nothing here knows a world.
 */
#ifndef CNI_GEOMETRY_OUTLINE_H
#define CNI_GEOMETRY_OUTLINE_H

#include "geometry/shape.h"

#define CNI_OUTLINE_POINTS_MAX 1024   /* of cni_outline_decompose: squared time, and its stack */
#define CNI_SIMPLIFY_POINTS_MAX 65536 /* of cni_outline_simplify: its stack */
#define CNI_GRID_SIDE_MAX 4096

/* 1: c lies to the left of the line from a to b, -1: to its right, 0: on it. Exact for coordinates that are 0 or 1e-12 to 1e6 in size. */
int32_t cni_orientation(cni_vec2 a, cni_vec2 b, cni_vec2 c);

/* Copies an outline of 3 to CNI_OUTLINE_POINTS_MAX finite points without those nearer than tolerance to the point before and without
   collinear ones, counter-clockwise. Returns NULL, or an error text as the checks of shape.h if fewer than three are left or the outline
   crosses or touches itself. out may not be points. */
const char *cni_outline_clean(const cni_vec2 *points, int32_t count, float tolerance, cni_vec2 *out, int32_t *out_count);

/* Height of a vertex over the line through its neighbours; FLT_MAX where the outline turns by more than a right angle. */
float cni_vertex_height(const cni_vec2 *points, int32_t count, int32_t i);
void cni_points_reverse(cni_vec2 *points, int32_t count);

/* Writes the first capacity convex pieces of a simple outline, each of which cni_check_polygon accepts, and the number of all. Returns
   NULL, or an error text, as cni_outline_clean. */
const char *cni_outline_decompose(const cni_vec2 *points, int32_t count, float tolerance, cn_polygon *out, int32_t capacity,
                                  int32_t *out_count);

/* Writes the first capacity points that the simplified row keeps, in their order, and returns the number of all: 0 for a closed row
   that lies within tolerance of a segment. count: 2 (closed: 3) to CNI_SIMPLIFY_POINTS_MAX. out may be points. */
int32_t cni_outline_simplify(const cni_vec2 *points, int32_t count, int32_t closed, float tolerance, cni_vec2 *out, int32_t capacity);

/* A grid of cells or of samples, row by row. One of solid and values is NULL. */
typedef struct cni_grid {
	const uint8_t *solid; /* not 0: solid */
	const float *values;  /* from threshold: solid */
	float threshold;
	int32_t columns;
	int32_t rows;
	cni_vec2 origin; /* lower left corner of the first cell; the first sample */
	float spacing;
} cni_grid;
typedef struct cni_outline_out {
	cni_vec2 *points;
	int32_t capacity;
	int32_t count; /* of all, written or not */
} cni_outline_out;
/* Adds the points of an outline to out, the solid side on their left. outline: its number, from 0, by the lowest row and then column of
   its edges in +x direction. No points: there are not so many outlines. */
void cni_outline_from_grid(const cni_grid *grid, int32_t outline, cni_outline_out *out);

#endif
