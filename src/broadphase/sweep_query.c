/*
 * broadphase/sweep_query.c - region and ray queries through the tiles of the sweep.
 *
 * Reads only. Queries find every proxy, settled or not: entries that are out of date are skipped in their tiles, and loose
 * proxies are tested one by one, by id, at the end.
 *
 * A ray visits the coarse levels first (their few large boxes shorten it early), in each level row after row of tiles, and
 * in each row tile after tile, in the direction of the ray. It skips entries beyond the fraction that the visitor
 * returned. Grid traversal after Amanatides and Woo (1987), by rows instead of cells because tiles overlap their
 * neighbours.
 */
#include "broadphase/sweep_lanes.h"

/* ---- regions ---- */

static int32_t is_loose(const cni_sweep *sweep, int32_t id)
{
	return sweep->loose_count > 0 && cni_bit_get(cni_sweep_loose(sweep), id);
}

typedef struct region {
	const cni_sweep *sweep;
	cni_aabb box;
	cni_query_fn *visit;
	void *context;
} region;

/* Bits of the entries that overlap the region, in the group that begins at k. */
static uint32_t group_overlaps(const region *r, const cni_sweep_rows *rows, int32_t k)
{
	uint32_t bits = 0;
	for (int32_t l = 0; l < CNI_SWEEP_LANES; l += CNI_WIDTH)
		bits |= cni_mask_bits(lanes_overlap(rows, k + l, &r->box)) << l;
	return bits;
}

/* 0 when the visitor stops the query. */
static int32_t query_entry(const region *r, int32_t id)
{
	return is_loose(r->sweep, id) || r->visit(r->context, id, 1.0f) != 0.0f;
}

/* A tile whose rows are padded to whole groups. */
static int32_t query_groups(const region *r, const cni_sweep_tile *tile, const cni_sweep_rows *rows, int32_t from)
{
	int32_t k = from & ~(CNI_SWEEP_LANES - 1);
	uint32_t wanted = ~0u << (from - k);
	for (; k < tile->count && rows->x0[k] <= r->box.x1; k += CNI_SWEEP_LANES) {
		for (uint32_t bits = group_overlaps(r, rows, k) & wanted; bits != 0; bits &= bits - 1) {
			int32_t i = k + cni_bit_lowest32(bits);
			if (i < tile->count && !query_entry(r, rows->id[i]))
				return 0;
		}
		wanted = ~0u;
	}
	return 1;
}

static int32_t query_tile(const region *r, const cni_sweep_tile *tile)
{
	cni_sweep_rows rows = cni_sweep_rows_of(r->sweep, tile);
	const cni_aabb *box = &r->box;
	int32_t k = cni_sweep_entry_from(rows.x0, tile->count, box->x0 - tile->reach);
	if (tile->capacity >= CNI_SWEEP_LANES)
		return query_groups(r, tile, &rows, k);
	for (; k < tile->count && rows.x0[k] <= box->x1; ++k)
		if ((rows.x1[k] >= box->x0) & (rows.y0[k] <= box->y1) & (rows.y1[k] >= box->y0) && !query_entry(r, rows.id[k]))
			return 0;
	return 1;
}

static void query_loose(const region *r)
{
	cni_sweep_walk walk = cni_sweep_walk_bits(r->sweep, &r->sweep->loose, r->sweep->loose_count);
	int32_t id;
	while ((id = cni_sweep_walk_next(&walk)) != CNI_NONE)
		if (cni_aabb_overlap(&cni_sweep_proxy(r->sweep, id)->fat, &r->box) && r->visit(r->context, id, 1.0f) == 0.0f)
			return;
}

void cni_sweep_query(const cni_broadphase *broadphase, const cni_aabb *box, cni_query_fn *visit, void *context)
{
	const cni_sweep *sweep = cni_sweep_of(broadphase);
	cni_sweep_cursor cursor;
	int32_t tile;
	region r = { sweep, *box, visit, context };
	cni_sweep_cursor_start(sweep, &cursor, box);
	while ((tile = cni_sweep_cursor_next(sweep, &cursor)) != CNI_NONE)
		if (!query_tile(&r, cni_sweep_tile_at(sweep, tile)))
			return;
	query_loose(&r);
}

/* ---- rays ---- */

typedef struct ray_pass {
	const cni_sweep *sweep;
	cni_ray ray;
	cni_query_fn *visit;
	void *context;
} ray_pass;

/* Visits a proxy that the ray crosses; 0 when the visitor stops the ray. */
static int32_t ray_visit(ray_pass *r, int32_t id)
{
	float limit = r->visit(r->context, id, r->ray.limit);
	if (limit < r->ray.limit)
		cni_ray_limit(&r->ray, limit);
	return limit > 0.0f;
}

/* Visits the entries that the ray crosses between x0 and x1, in its direction. */
static int32_t ray_tile(ray_pass *r, const cni_sweep_tile *tile, float x0, float x1)
{
	cni_sweep_rows rows = cni_sweep_rows_of(r->sweep, tile);
	int32_t step = r->ray.d.x < 0.0f ? -1 : 1;
	float from = x0 - tile->reach;
	int32_t k = step > 0 ? cni_sweep_entry_from(rows.x0, tile->count, from) : cni_sweep_entry_bound(&rows, tile->count, x1, INT32_MAX) - 1;
	for (; k >= 0 && k < tile->count && rows.x0[k] >= from && rows.x0[k] <= x1; k += step) {
		cni_aabb box = cni_sweep_box_at(&rows, k);
		if (!cni_aabb_overlap_branchless(&r->ray.box, &box) || !cni_ray_line_crosses(&r->ray, &box) || is_loose(r->sweep, rows.id[k]))
			continue;
		if (!ray_visit(r, rows.id[k]))
			return 0;
	}
	return 1;
}

/* The x range of the ray between two heights, widened for rounding; 0 when it is empty. */
static int32_t ray_stretch(const cni_ray *ray, float y0, float y1, float *x0, float *x1)
{
	float t0 = 0.0f, t1 = ray->limit;
	cni_vec2 o = ray->o, d = ray->d;
	float error = 4e-7f * (1.0f + (cni_abs(y0) + cni_abs(y1) + cni_abs(o.y)) / cni_abs(d.y));
	if (error < 1.0f) { /* else the ray is horizontal, or rounding hides its height */
		float s0 = (y0 - o.y) / d.y, s1 = (y1 - o.y) / d.y;
		t0 = cni_max(t0, cni_min(s0, s1) - error);
		t1 = cni_min(t1, cni_max(s0, s1) + error);
		if (t0 > t1)
			return 0;
	}
	error = 4e-7f * (cni_abs(o.x) + cni_abs(d.x));
	*x0 = cni_min(o.x + t0 * d.x, o.x + t1 * d.x) - error;
	*x1 = cni_max(o.x + t0 * d.x, o.x + t1 * d.x) + error;
	return 1;
}

/* Visits a row of tiles. Entries of the clamped outermost cells may be anywhere, so the ray is not cut for those rows. */
static int32_t ray_row(ray_pass *r, int32_t l, int32_t ty, const cni_sweep_cells *cells)
{
	const cni_sweep_level *level = &r->sweep->levels[l];
	float height = 2.0f * level->size;
	float x0 = r->ray.box.x0, x1 = r->ray.box.x1;
	if (level->per_height > 0.0f && ty > -1000000000 && ty < 1000000000 &&
	    !ray_stretch(&r->ray, (float)ty * height, (float)(ty + 1) * height + level->reach, &x0, &x1))
		return 1;
	int32_t tx0 = cni_max_i(cells->tx0, cni_sweep_cell_x(level, level->per_width > 0.0f ? x0 - level->reach : x0));
	int32_t tx1 = cni_min_i(cells->tx1, cni_sweep_cell_x(level, x1));
	for (int32_t i = 0; i <= tx1 - tx0; ++i) {
		int32_t tile = cni_sweep_tile_find(r->sweep, l, r->ray.d.x < 0.0f ? tx1 - i : tx0 + i, ty);
		if (tile != CNI_NONE && cni_ray_crosses(&r->ray, &cni_sweep_tile_at(r->sweep, tile)->bounds) &&
		    !ray_tile(r, cni_sweep_tile_at(r->sweep, tile), x0, x1))
			return 0;
	}
	return 1;
}

/* Visits all tiles of a level: for rays that would look up more cells than there are tiles. */
static int32_t ray_all_tiles(ray_pass *r, int32_t l)
{
	for (int32_t i = 0; i < r->sweep->tiles.count; ++i) {
		const cni_sweep_tile *tile = cni_sweep_tile_at(r->sweep, i);
		if (tile->level == l && cni_ray_crosses(&r->ray, &tile->bounds) && !ray_tile(r, tile, r->ray.box.x0, r->ray.box.x1))
			return 0;
	}
	return 1;
}

static int32_t ray_level(ray_pass *r, int32_t l)
{
	cni_sweep_cells cells;
	if (!(r->sweep->level_mask >> l & 1u) || !cni_sweep_cells_of(&r->sweep->levels[l], &r->ray.box, &cells))
		return 1;
	if ((int64_t)cells.tx1 - cells.tx0 + 3 * ((int64_t)cells.ty1 - cells.ty0 + 1) > (int64_t)r->sweep->tiles.count + 8)
		return ray_all_tiles(r, l);
	int32_t rows = cells.ty1 - cells.ty0 + 1;
	for (int32_t i = 0; i < rows; ++i)
		if (!ray_row(r, l, r->ray.d.y < 0.0f ? cells.ty1 - i : cells.ty0 + i, &cells))
			return 0;
	return 1;
}

static void ray_loose(ray_pass *r)
{
	cni_sweep_walk walk = cni_sweep_walk_bits(r->sweep, &r->sweep->loose, r->sweep->loose_count);
	int32_t id;
	while ((id = cni_sweep_walk_next(&walk)) != CNI_NONE)
		if (cni_ray_crosses(&r->ray, &cni_sweep_proxy(r->sweep, id)->fat) && !ray_visit(r, id))
			return;
}

void cni_sweep_ray(const cni_broadphase *broadphase, cni_vec2 origin, cni_vec2 translation, cni_query_fn *visit, void *context)
{
	ray_pass r = { cni_sweep_of(broadphase), cni_ray_make(origin, translation), visit, context };
	for (int32_t l = CNI_SWEEP_LEVELS - 1; l >= 0; --l)
		if (!ray_level(&r, l))
			return;
	ray_loose(&r);
}
