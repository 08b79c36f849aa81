/*
 * geometry/outline_grid.c - the boundary of the solid part of a grid as closed outlines: along the edges of grid, or through samples of
 * a field (marching squares: Lorensen, Cline 1987 in the plane).
 *
 * An outline is walked along edges of cells with the solid side on its left, by the two cells ahead of each corner of the grid. For a
 * field, cells are centred on its samples, so each edge separates a solid sample from an empty one, and the outline's point lies between
 * them. Solid cells that touch at a corner only stay apart. No cell is marked: an outline is written from the first of its edges in +x
 * direction, by row and then column, and a walk from another one ends as soon as it meets an earlier one.
 * O(cells + n log n) for a boundary of n edges.
 */
#include "geometry/outline.h"

#define CROSSING_SHARE_MIN (1.0f / 64.0f)

static const int32_t step_x[4] = { 1, 0, -1, 0 }, step_y[4] = { 0, 1, 0, -1 }; /* counter-clockwise */
static const int32_t left_x[4] = { 0, -1, -1, 0 }, left_y[4] = { 0, 0, -1, -1 }; /* the cell ahead on the left of a corner */

/* A corner of the grid and the direction in which the outline leaves it. */
typedef struct walker { int32_t x, y, direction; } walker;

static int32_t cell_is_inside(const cni_grid *g, int32_t x, int32_t y)
{
	return x >= 0 && y >= 0 && x < g->columns && y < g->rows;
}

static size_t cell_index(const cni_grid *g, int32_t x, int32_t y)
{
	return (size_t)y * (size_t)g->columns + (size_t)x;
}

static int32_t cell_is_solid(const cni_grid *g, int32_t x, int32_t y)
{
	if (!cell_is_inside(g, x, y))
		return 0;
	return g->values != NULL ? g->values[cell_index(g, x, y)] >= g->threshold : g->solid[cell_index(g, x, y)] != 0;
}

static walker walker_move(const cni_grid *g, walker w)
{
	int32_t d = w.direction, right = (d + 3) & 3;
	w.x += step_x[d];
	w.y += step_y[d];
	if (!cell_is_solid(g, w.x + left_x[d], w.y + left_y[d]))
		w.direction = (d + 1) & 3;
	else if (cell_is_solid(g, w.x + left_x[right], w.y + left_y[right]))
		w.direction = right;
	return w;
}

static int32_t walker_is_at(walker w, walker other)
{
	return w.x == other.x && w.y == other.y && w.direction == other.direction;
}

/* The inverse of walker_move, by the two cells behind the corner. */
static walker walker_move_back(const cni_grid *g, walker w)
{
	int32_t d = w.direction, behind_left = (d + 1) & 3, behind_right = (d + 2) & 3;
	if (!cell_is_solid(g, w.x + left_x[behind_left], w.y + left_y[behind_left]))
		w.direction = (d + 3) & 3;
	else if (cell_is_solid(g, w.x + left_x[behind_right], w.y + left_y[behind_right]))
		w.direction = (d + 1) & 3;
	w.x -= step_x[w.direction];
	w.y -= step_y[w.direction];
	return w;
}

static int32_t begins_earlier(walker w, walker first)
{
	return w.direction == 0 && (w.y < first.y || (w.y == first.y && w.x < first.x));
}

/* Walks both ways in turn: the steps to an earlier edge the shorter way, summed over a loop of n edges, are O(n log n). */
static int32_t outline_begins_at(const cni_grid *g, walker first)
{
	walker ahead = first, behind = first;
	for (;;) {
		ahead = walker_move(g, ahead);
		if (walker_is_at(ahead, behind))
			return 1;
		if (begins_earlier(ahead, first))
			return 0;
		behind = walker_move_back(g, behind);
		if (walker_is_at(ahead, behind))
			return 1;
		if (begins_earlier(behind, first))
			return 0;
	}
}

/* Share of the way from a solid sample to the empty one beyond the walker's edge at which the field has the threshold. It keeps off
   the samples, so that points of different edges never coincide. At the border of the grid the outline runs through the samples. */
static float crossing_share(const cni_grid *g, float solid, int32_t empty_x, int32_t empty_y)
{
	if (!cell_is_inside(g, empty_x, empty_y))
		return 0.0f;
	float step = 0.5f * solid - 0.5f * g->values[cell_index(g, empty_x, empty_y)]; /* halves do not overflow */
	float share = step > 0.0f ? (0.5f * solid - 0.5f * g->threshold) / step : 0.5f;
	return cni_clamp(share, CROSSING_SHARE_MIN, 1.0f - CROSSING_SHARE_MIN);
}

/* The point of an outline that belongs to the walker's edge. */
static cni_vec2 walker_point(const cni_grid *g, walker w)
{
	float x = (float)w.x, y = (float)w.y;
	if (g->values != NULL) {
		int32_t right = (w.direction + 3) & 3;
		int32_t solid_x = w.x + left_x[w.direction], solid_y = w.y + left_y[w.direction];
		int32_t empty_x = w.x + left_x[right], empty_y = w.y + left_y[right];
		float share = crossing_share(g, g->values[cell_index(g, solid_x, solid_y)], empty_x, empty_y);
		x = (float)solid_x + share * (float)(empty_x - solid_x);
		y = (float)solid_y + share * (float)(empty_y - solid_y);
	}
	return cni_v(g->origin.x + x * g->spacing, g->origin.y + y * g->spacing);
}

/* 1 if the outline has a point at the edge after w: each corner of cells; in a field all but the second one at a corner of the grid. */
static int32_t point_is_needed(const cni_grid *g, walker w, walker moved)
{
	if (g->values == NULL)
		return moved.direction != w.direction;
	cni_vec2 before = walker_point(g, w), point = walker_point(g, moved);
	return before.x != point.x || before.y != point.y;
}

static void outline_write(const cni_grid *g, walker first, cni_outline_out *out)
{
	walker w = first;
	do {
		walker moved = walker_move(g, w);
		if (point_is_needed(g, w, moved)) {
			if (out->count < out->capacity)
				out->points[out->count] = walker_point(g, moved);
			++out->count;
		}
		w = moved;
	} while (!walker_is_at(w, first));
}

void cni_outline_from_grid(const cni_grid *grid, int32_t outline, cni_outline_out *out)
{
	for (int32_t y = 0; y < grid->rows; ++y)
		for (int32_t x = 0; x < grid->columns; ++x) {
			walker first = { x, y, 0 };
			if (!cell_is_solid(grid, x, y) || cell_is_solid(grid, x, y - 1) || !outline_begins_at(grid, first))
				continue;
			if (outline-- == 0) {
				outline_write(grid, first, out);
				return;
			}
		}
}
