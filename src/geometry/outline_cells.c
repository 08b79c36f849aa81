/*
 * geometry/outline_cells.c - the boundary of the solid cells of a grid as closed outlines along the edges of cells.
 *
 * An outline is walked with the solid side on its left, by the two cells ahead of each corner of the grid (marching squares with cells
 * as samples: Lorensen, Cline 1987 in the plane). Solid cells that touch at a corner only stay apart. No cell is marked: an outline is
 * written from the first of its edges in +x direction, by row and then column, and a walk from another one ends as soon as it meets an
 * earlier one.
 * O(cells + length of the boundary * length between an edge and an earlier one).
 */
#include "geometry/outline.h"

static const int32_t step_x[4] = { 1, 0, -1, 0 }, step_y[4] = { 0, 1, 0, -1 }; /* counter-clockwise */
static const int32_t left_x[4] = { 0, -1, -1, 0 }, left_y[4] = { 0, 0, -1, -1 }; /* the cell ahead on the left of a corner */

/* A corner of the grid and the direction in which the outline leaves it. */
typedef struct walker { int32_t x, y, direction; } walker;

static int32_t cell_is_solid(const cni_cells *c, int32_t x, int32_t y)
{
	return x >= 0 && y >= 0 && x < c->columns && y < c->rows && c->solid[(size_t)y * (size_t)c->columns + (size_t)x] != 0;
}

static walker walker_move(const cni_cells *c, walker w)
{
	int32_t d = w.direction, right = (d + 3) & 3;
	w.x += step_x[d];
	w.y += step_y[d];
	if (!cell_is_solid(c, w.x + left_x[d], w.y + left_y[d]))
		w.direction = (d + 1) & 3;
	else if (cell_is_solid(c, w.x + left_x[right], w.y + left_y[right]))
		w.direction = right;
	return w;
}

static int32_t walker_is_at(walker w, walker other)
{
	return w.x == other.x && w.y == other.y && w.direction == other.direction;
}

static int32_t outline_begins_at(const cni_cells *c, walker first)
{
	walker w = first;
	do {
		if (w.direction == 0 && (w.y < first.y || (w.y == first.y && w.x < first.x)))
			return 0;
		w = walker_move(c, w);
	} while (!walker_is_at(w, first));
	return 1;
}

static void point_write(const cni_cells *c, walker w, cni_outlines *out)
{
	if (out->point_count < out->point_capacity)
		out->points[out->point_count] = cni_v(c->origin.x + (float)w.x * c->side, c->origin.y + (float)w.y * c->side);
	++out->point_count;
}

static void outline_write(const cni_cells *c, walker first, cni_outlines *out)
{
	int32_t before = out->point_count;
	walker w = first;
	do {
		walker moved = walker_move(c, w);
		if (moved.direction != w.direction)
			point_write(c, moved, out);
		w = moved;
	} while (!walker_is_at(w, first));
	if (out->outline_count < out->outline_capacity)
		out->counts[out->outline_count] = out->point_count - before;
	++out->outline_count;
}

void cni_outline_from_cells(const cni_cells *cells, cni_outlines *out)
{
	for (int32_t y = 0; y < cells->rows; ++y)
		for (int32_t x = 0; x < cells->columns; ++x) {
			walker first = { x, y, 0 };
			if (cell_is_solid(cells, x, y) && !cell_is_solid(cells, x, y - 1) && outline_begins_at(cells, first))
				outline_write(cells, first, out);
		}
}
