/*
 * broadphase/sweep_tiles.c - owns the storage of boxes: the levels, the table from cells to tiles, and the sorted rows of
 * entries in a tile.
 *
 * Invariants: a tile's rows are sorted by (x0, id), except between an append and the rebuild at the end of settle; its
 * bounds contain its entries; every entry's box extends less than S to the right of and above its cell. All maps from
 * coordinates to cells are monotone, also after rounding and where distant cells are merged, so that a search by ranges
 * of cells misses no entry.
 *
 * Table: open addressing, linear probing, deletion by shifting back (Knuth, vol. 3, section 6.4).
 */
#include "broadphase/sweep.h"

#include <string.h>

/* ---- levels and cells ---- */

void cni_sweep_set_levels(cni_sweep *sweep, int32_t exponent)
{
	float size = 1.0f;
	for (int32_t i = 0; i < exponent; ++i)
		size *= 2.0f;
	for (int32_t i = 0; i > exponent; --i)
		size *= 0.5f;
	sweep->exponent = exponent;
	for (int32_t i = 0; i < CNI_SWEEP_LEVELS; ++i, size *= 4.0f) {
		cni_sweep_level *level = &sweep->levels[i];
		int32_t last = i == CNI_SWEEP_LEVELS - 1;
		memset(level, 0, sizeof(*level));
		level->size = size;
		level->per_width = last ? 0.0f : 0.125f / size;
		level->per_height = last ? 0.0f : 0.5f / size;
	}
}

int32_t cni_sweep_level_for(const cni_sweep *sweep, float extent, int32_t now)
{
	int32_t level = 0;
	while (level < CNI_SWEEP_LEVELS - 1 && !(extent < sweep->levels[level].size))
		++level;
	if (now > level && !(extent < 0.1f * sweep->levels[now].size))
		level = now;
	return level;
}

/* An entry that overlaps the box begins above x0 - reach; this holds in floats because rounding is monotone. */
int32_t cni_sweep_cells_of(const cni_sweep_level *level, const cni_aabb *box, cni_sweep_cells *out)
{
	float reach = level->per_width > 0.0f ? level->reach : 0.0f;
	out->tx0 = cni_max_i(cni_sweep_cell_x(level, box->x0 - reach), level->tx0);
	out->tx1 = cni_min_i(cni_sweep_cell_x(level, box->x1), level->tx1);
	out->ty0 = cni_max_i(cni_sweep_cell_y(level, box->y0 - reach), level->ty0);
	out->ty1 = cni_min_i(cni_sweep_cell_y(level, box->y1), level->ty1);
	return out->tx0 <= out->tx1 && out->ty0 <= out->ty1;
}

/* ---- the table ---- */

static inline uint32_t cell_hash(int32_t level, int32_t tx, int32_t ty)
{
	uint32_t h = (uint32_t)tx * 0x9E3779B1u ^ (uint32_t)ty * 0x85EBCA77u ^ (uint32_t)level * 0xC2B2AE3Du;
	h ^= h >> 15;
	h *= 0x2C1B3C6Du;
	return h ^ h >> 13;
}

int32_t cni_sweep_tile_find(const cni_sweep *sweep, int32_t level, int32_t tx, int32_t ty)
{
	uint32_t mask = (uint32_t)sweep->slot_capacity - 1u;
	if (sweep->slot_capacity == 0)
		return CNI_NONE;
	for (uint32_t i = cell_hash(level, tx, ty) & mask; sweep->slots[i] != 0; i = (i + 1u) & mask) {
		const cni_sweep_tile *tile = cni_sweep_tile_at(sweep, sweep->slots[i] - 1);
		if (tile->tx == tx && tile->ty == ty && tile->level == level)
			return sweep->slots[i] - 1;
	}
	return CNI_NONE;
}

static void slot_put(cni_sweep *sweep, int32_t tile)
{
	const cni_sweep_tile *t = cni_sweep_tile_at(sweep, tile);
	uint32_t mask = (uint32_t)sweep->slot_capacity - 1u;
	uint32_t i = cell_hash(t->level, t->tx, t->ty) & mask;
	while (sweep->slots[i] != 0)
		i = (i + 1u) & mask;
	sweep->slots[i] = tile + 1;
}

static void slot_take(cni_sweep *sweep, int32_t tile)
{
	const cni_sweep_tile *t = cni_sweep_tile_at(sweep, tile);
	uint32_t mask = (uint32_t)sweep->slot_capacity - 1u;
	uint32_t hole = cell_hash(t->level, t->tx, t->ty) & mask;
	while (sweep->slots[hole] != tile + 1)
		hole = (hole + 1u) & mask;
	for (uint32_t i = (hole + 1u) & mask; sweep->slots[i] != 0; i = (i + 1u) & mask) {
		const cni_sweep_tile *other = cni_sweep_tile_at(sweep, sweep->slots[i] - 1);
		uint32_t home = cell_hash(other->level, other->tx, other->ty) & mask;
		if (((i - home) & mask) >= ((i - hole) & mask)) {
			sweep->slots[hole] = sweep->slots[i];
			hole = i;
		}
	}
	sweep->slots[hole] = 0;
}

/* Keeps the table at most half full; up to seven eighths where memory is short. */
int32_t cni_sweep_slots_reserve(cni_sweep *sweep, int32_t count)
{
	int32_t capacity = cni_max_i(sweep->slot_capacity, 8);
	while (capacity / 2 < count)
		capacity *= 2;
	if (capacity == sweep->slot_capacity)
		return 1;
	int32_t *slots = (int32_t *)cni_memory_alloc(sweep->context.memory, (uint64_t)capacity * sizeof(int32_t));
	if (slots == NULL)
		return count <= sweep->slot_capacity / 8 * 7;
	cni_memory_free(sweep->context.memory, sweep->slots, (uint64_t)sweep->slot_capacity * sizeof(int32_t));
	sweep->slots = slots;
	sweep->slot_capacity = capacity;
	cni_sweep_slots_fill(sweep);
	return 1;
}

void cni_sweep_slots_fill(cni_sweep *sweep)
{
	if (sweep->slot_capacity > 0)
		memset(sweep->slots, 0, (size_t)sweep->slot_capacity * sizeof(int32_t));
	for (int32_t tile = 0; tile < sweep->tiles.count; ++tile)
		if (cni_sweep_tile_at(sweep, tile)->level != CNI_SWEEP_FREE)
			slot_put(sweep, tile);
}

/* ---- tiles ---- */

static void level_add_tile(cni_sweep *sweep, int32_t l, int32_t tx, int32_t ty)
{
	cni_sweep_level *level = &sweep->levels[l];
	int32_t first = level->tiles++ == 0;
	sweep->level_mask |= 1u << l;
	level->tx0 = first ? tx : cni_min_i(level->tx0, tx);
	level->tx1 = first ? tx : cni_max_i(level->tx1, tx);
	level->ty0 = first ? ty : cni_min_i(level->ty0, ty);
	level->ty1 = first ? ty : cni_max_i(level->ty1, ty);
}

/* An unused slot, or CNI_NONE. */
static int32_t tile_take(cni_sweep *sweep)
{
	int32_t tile = sweep->tile_free;
	if (tile != CNI_NONE) {
		sweep->tile_free = cni_sweep_tile_at(sweep, tile)->tx;
		return tile;
	}
	if (!cni_array_reserve(&sweep->tiles, sweep->context.memory, sweep->tiles.count + 1))
		return CNI_NONE;
	return sweep->tiles.count++;
}

int32_t cni_sweep_tile_make(cni_sweep *sweep, int32_t level, int32_t tx, int32_t ty)
{
	int32_t tile;
	CNI_ASSERT(cni_sweep_tile_find(sweep, level, tx, ty) == CNI_NONE);
	if (!cni_sweep_slots_reserve(sweep, sweep->tile_count + 1) || (tile = tile_take(sweep)) == CNI_NONE)
		return CNI_NONE;
	cni_sweep_tile *t = cni_sweep_tile_at(sweep, tile);
	memset(t, 0, sizeof(*t));
	t->tx = tx;
	t->ty = ty;
	t->level = (uint8_t)level;
	t->bounds = cni_no_box();
	slot_put(sweep, tile);
	++sweep->tile_count;
	level_add_tile(sweep, level, tx, ty);
	return tile;
}

static uint64_t rows_bytes(int32_t capacity) { return (uint64_t)capacity * (4 * sizeof(float) + sizeof(int32_t)); }

static void rows_free(cni_sweep *sweep, cni_ref rows, int32_t capacity)
{
	if (capacity > 0)
		cni_blocks_free(&sweep->rows, rows, rows_bytes(capacity));
}

void cni_sweep_tile_destroy(cni_sweep *sweep, int32_t tile)
{
	cni_sweep_tile *t = cni_sweep_tile_at(sweep, tile);
	cni_sweep_level *level = &sweep->levels[t->level];
	slot_take(sweep, tile);
	rows_free(sweep, t->rows, t->capacity);
	level->entries -= t->count;
	if (--level->tiles == 0)
		sweep->level_mask &= ~(1u << t->level);
	t->level = CNI_SWEEP_FREE;
	t->count = 0;
	t->tx = sweep->tile_free;
	sweep->tile_free = tile;
	--sweep->tile_count;
}

/* Capacities that fit the size classes of base/blocks.h; multiples of CNI_SWEEP_LANES from 8 on. */
static int32_t capacity_for(int32_t count)
{
	static const int32_t steps[] = { 2, 4, 8, 16, 24, 32, 48, 72, 96, 200 };
	for (int32_t i = 0; i < (int32_t)(sizeof(steps) / sizeof(steps[0])); ++i)
		if (count <= steps[i])
			return steps[i];
	return (count + count / 4 + 7) & ~7;
}

/* Moves count entries to rows that may be the same. */
static void entries_move(const cni_sweep_rows *to, int32_t at, const cni_sweep_rows *from, int32_t from_at, int32_t count)
{
	size_t bytes = (size_t)count * sizeof(float);
	memmove(to->x0 + at, from->x0 + from_at, bytes);
	memmove(to->x1 + at, from->x1 + from_at, bytes);
	memmove(to->y0 + at, from->y0 + from_at, bytes);
	memmove(to->y1 + at, from->y1 + from_at, bytes);
	memmove(to->id + at, from->id + from_at, bytes);
}

static int32_t tile_resize(cni_sweep *sweep, cni_sweep_tile *tile, int32_t capacity)
{
	cni_sweep_tile old = *tile;
	cni_ref rows = cni_blocks_alloc(&sweep->rows, rows_bytes(capacity));
	if (rows == 0)
		return 0;
	tile->rows = rows;
	tile->capacity = capacity;
	if (old.capacity > 0) {
		cni_sweep_rows from = cni_sweep_rows_of(sweep, &old), to = cni_sweep_rows_of(sweep, tile);
		entries_move(&to, 0, &from, 0, tile->count);
	}
	rows_free(sweep, old.rows, old.capacity);
	cni_sweep_tile_pad(sweep, tile);
	return 1;
}

/* Room for one more entry; 0 when there is no memory. */
static int32_t tile_reserve_one(cni_sweep *sweep, cni_sweep_tile *tile)
{
	return tile->count < tile->capacity || tile_resize(sweep, tile, capacity_for(tile->count + 1));
}

void cni_sweep_tile_shrink(cni_sweep *sweep, cni_sweep_tile *tile)
{
	int32_t capacity = capacity_for(tile->count + tile->count / 4);
	if (2 * capacity <= tile->capacity)
		(void)tile_resize(sweep, tile, capacity);
}

/* Slightly more than the width, which may have been rounded down. */
static inline float entry_reach(float width) { return width * 1.000002f; }

void cni_sweep_level_cover(cni_sweep_level *level, float extent)
{
	level->reach = cni_max(level->reach, entry_reach(extent));
}

float cni_sweep_tile_measure(const cni_sweep *sweep, cni_sweep_tile *tile)
{
	cni_sweep_rows rows = cni_sweep_rows_of(sweep, tile);
	cni_aabb bounds = cni_no_box();
	float width = 0.0f, height = 0.0f;
	if (tile->count > 0)
		bounds.x0 = rows.x0[0];
	for (int32_t k = 0; k < tile->count; ++k) {
		bounds.x1 = cni_max(bounds.x1, rows.x1[k]);
		bounds.y0 = cni_min(bounds.y0, rows.y0[k]);
		bounds.y1 = cni_max(bounds.y1, rows.y1[k]);
		width = cni_max(width, rows.x1[k] - rows.x0[k]);
		height = cni_max(height, rows.y1[k] - rows.y0[k]);
	}
	tile->bounds = bounds;
	tile->reach = entry_reach(width);
	tile->slack = 0;
	return cni_max(width, height);
}

static void tile_cover(cni_sweep *sweep, cni_sweep_tile *tile, const cni_aabb *box)
{
	cni_sweep_level_cover(&sweep->levels[tile->level], cni_sweep_extent(box));
	tile->bounds = cni_aabb_union(&tile->bounds, box);
	tile->reach = cni_max(tile->reach, entry_reach(box->x1 - box->x0));
}

/* Counts a change; recomputes the bounds when the changes since the last time exceed the entries. */
static void tile_changed(cni_sweep *sweep, cni_sweep_tile *tile)
{
	if (++tile->slack > tile->count)
		cni_sweep_level_cover(&sweep->levels[tile->level], cni_sweep_tile_measure(sweep, tile));
}

void cni_sweep_tile_pad(const cni_sweep *sweep, cni_sweep_tile *tile)
{
	float *x0 = cni_sweep_rows_of(sweep, tile).x0;
	int32_t end = cni_min_i((tile->count + CNI_SWEEP_LANES - 1) & ~(CNI_SWEEP_LANES - 1), tile->capacity);
	for (int32_t k = tile->count; k < end; ++k)
		x0[k] = INFINITY;
}

/* ---- entries ---- */

int32_t cni_sweep_entry_bound(const cni_sweep_rows *rows, int32_t count, float x0, int32_t id)
{
	int32_t k = cni_sweep_entry_from(rows->x0, count, x0);
	while (k < count && rows->x0[k] == x0 && rows->id[k] < id)
		++k;
	return k;
}

/* An entry that is out of date still has the x0 of the last settle, which is nearly always that of the old box. */
static int32_t entry_find(const cni_sweep *sweep, const cni_sweep_tile *tile, int32_t id)
{
	cni_sweep_rows rows = cni_sweep_rows_of(sweep, tile);
	const cni_proxy *proxy = cni_sweep_proxy(sweep, id);
	float x0 = cni_bit_get(cni_sweep_loose(sweep), id) ? proxy->old.x0 : proxy->fat.x0;
	int32_t k = cni_sweep_entry_bound(&rows, tile->count, x0, id);
	if (k < tile->count && rows.id[k] == id)
		return k;
	for (k = 0; k < tile->count; ++k)
		if (rows.id[k] == id)
			return k;
	CNI_ASSERT(0);
	return CNI_NONE;
}

int32_t cni_sweep_entry_insert(cni_sweep *sweep, cni_sweep_tile *tile, int32_t id, const cni_aabb *box)
{
	if (!tile_reserve_one(sweep, tile))
		return 0;
	cni_sweep_rows rows = cni_sweep_rows_of(sweep, tile);
	int32_t k = cni_sweep_entry_bound(&rows, tile->count, box->x0, id);
	entries_move(&rows, k + 1, &rows, k, tile->count - k);
	cni_sweep_entry_set(&rows, k, id, box);
	++tile->count;
	++sweep->levels[tile->level].entries;
	tile_cover(sweep, tile, box);
	cni_sweep_tile_pad(sweep, tile);
	return 1;
}

int32_t cni_sweep_entry_append(cni_sweep *sweep, cni_sweep_tile *tile, int32_t id)
{
	if (!tile_reserve_one(sweep, tile))
		return 0;
	cni_sweep_rows_of(sweep, tile).id[tile->count++] = id;
	++sweep->levels[tile->level].entries;
	return 1;
}

void cni_sweep_entry_remove(cni_sweep *sweep, cni_sweep_tile *tile, int32_t id)
{
	cni_sweep_rows rows = cni_sweep_rows_of(sweep, tile);
	int32_t entry = entry_find(sweep, tile, id);
	entries_move(&rows, entry, &rows, entry + 1, tile->count - entry - 1);
	--tile->count;
	--sweep->levels[tile->level].entries;
	cni_sweep_tile_pad(sweep, tile);
	tile_changed(sweep, tile);
}

void cni_sweep_entry_shift(cni_sweep *sweep, cni_sweep_tile *tile, int32_t id, const cni_aabb *box)
{
	cni_sweep_rows rows = cni_sweep_rows_of(sweep, tile);
	int32_t entry = entry_find(sweep, tile, id), k = entry;
	while (k > 0 && (rows.x0[k - 1] > box->x0 || (rows.x0[k - 1] == box->x0 && rows.id[k - 1] > id)))
		--k;
	if (k < entry)
		entries_move(&rows, k + 1, &rows, k, entry - k);
	while (k + 1 < tile->count && (rows.x0[k + 1] < box->x0 || (rows.x0[k + 1] == box->x0 && rows.id[k + 1] < id)))
		++k;
	if (k > entry)
		entries_move(&rows, entry, &rows, entry + 1, k - entry);
	cni_sweep_entry_set(&rows, k, id, box);
	tile_cover(sweep, tile, box);
	tile_changed(sweep, tile);
}

/* ---- iteration over tiles near a box ---- */

/* Sets up the next level in use after cursor->level; CNI_SWEEP_LEVELS: there is none. */
static void cursor_level(const cni_sweep *sweep, cni_sweep_cursor *cursor)
{
	while (++cursor->level < CNI_SWEEP_LEVELS) {
		cni_sweep_cells *cells = &cursor->cells;
		if (!(sweep->level_mask >> cursor->level & 1u) ||
		    !cni_sweep_cells_of(&sweep->levels[cursor->level], &cursor->box, cells))
			continue;
		cursor->tx = cells->tx0;
		cursor->ty = cells->ty0;
		cursor->slot = CNI_NONE;
		if (((int64_t)cells->tx1 - cells->tx0 + 1) * ((int64_t)cells->ty1 - cells->ty0 + 1) > sweep->tiles.count)
			cursor->slot = 0;
		return;
	}
}

void cni_sweep_cursor_start(const cni_sweep *sweep, cni_sweep_cursor *cursor, const cni_aabb *box)
{
	cursor->box = *box;
	cursor->level = -1;
	cursor_level(sweep, cursor);
}

/* The next candidate of the level, CNI_NONE for an empty cell. Where the level has no more, goes on to the next one. */
static int32_t cursor_step(const cni_sweep *sweep, cni_sweep_cursor *cursor)
{
	int32_t tile = cursor->slot;
	if (tile >= 0 && tile < sweep->tiles.count) {
		++cursor->slot;
		return cni_sweep_tile_at(sweep, tile)->level == cursor->level ? tile : CNI_NONE;
	}
	if (tile < 0 && cursor->ty <= cursor->cells.ty1) {
		tile = cni_sweep_tile_find(sweep, cursor->level, cursor->tx, cursor->ty);
		if (++cursor->tx > cursor->cells.tx1) {
			cursor->tx = cursor->cells.tx0;
			++cursor->ty;
		}
		return tile;
	}
	cursor_level(sweep, cursor);
	return CNI_NONE;
}

int32_t cni_sweep_cursor_next(const cni_sweep *sweep, cni_sweep_cursor *cursor)
{
	while (cursor->level < CNI_SWEEP_LEVELS) {
		int32_t tile = cursor_step(sweep, cursor);
		if (tile != CNI_NONE && cni_aabb_overlap(&cni_sweep_tile_at(sweep, tile)->bounds, &cursor->box))
			return tile;
	}
	return CNI_NONE;
}
