/*
 * broadphase/sweep.c - the tiled sweep-and-prune broadphase behind broadphase/broadphase.h: its
 * operations, their bookkeeping and its checks. The picture is in broadphase/sweep.h.
 *
 * Stage 2 of the step. Reads proxies; writes their cell, old box and flags, and its own tiles.
 * Invariants: a proxy that is not moved has old = fat; the tile `cell` of a proxy that is not loose holds its present
 * box; a proxy in no tile is loose.
 *
 * add, move and touch only set bits, so they are cheap to call; settle does the work in bulk, in update or before
 * queries.
 */
#include "broadphase/sweep.h"

#include <string.h>

#define SETTLE_PENDING 64   /* additions that may wait, beside an eighth of the proxies */

static inline cni_sweep *sweep_of(cni_broadphase *broadphase) { return (cni_sweep *)(void *)broadphase; }

/* ---- memory ---- */

static int32_t bits_reserve(cni_sweep *sweep, cni_array *bits, int32_t words)
{
	if (!cni_array_reserve(bits, sweep->context.memory, words))
		return 0;
	if (bits->count < bits->capacity) /* there may be no memory at all yet */
		memset((uint64_t *)bits->data + bits->count, 0, (size_t)(bits->capacity - bits->count) * sizeof(uint64_t));
	bits->count = bits->capacity;
	return 1;
}

static int32_t sweep_reserve(cni_broadphase *broadphase, int32_t extra)
{
	cni_sweep *sweep = sweep_of(broadphase);
	int32_t ids = cni_max_i(cni_table_capacity(sweep->context.proxies), sweep->count + extra);
	int32_t words = cni_bit_words(ids);
	return bits_reserve(sweep, &sweep->moved, words) && bits_reserve(sweep, &sweep->loose, words);
}

static void sweep_destroy(cni_broadphase *broadphase)
{
	cni_sweep *sweep = sweep_of(broadphase);
	cni_memory *memory = sweep->context.memory;
	cni_array_deinit(&sweep->tiles, memory);
	cni_blocks_deinit(&sweep->rows);
	cni_array_deinit(&sweep->moved, memory);
	cni_array_deinit(&sweep->loose, memory);
	cni_memory_free(memory, sweep->slots, (uint64_t)sweep->slot_capacity * sizeof(int32_t));
	cni_memory_free(memory, sweep, sizeof(*sweep));
}

static cni_broadphase *sweep_create(const cni_broadphase_context *context, int32_t capacity)
{
	cni_sweep *sweep = (cni_sweep *)cni_memory_alloc(context->memory, sizeof(cni_sweep));
	if (sweep == NULL)
		return NULL;
	memset(sweep, 0, sizeof(*sweep));
	sweep->context = *context;
	sweep->tile_free = CNI_NONE;
	cni_array_init(&sweep->tiles, (int32_t)sizeof(cni_sweep_tile));
	cni_blocks_init(&sweep->rows, context->memory);
	cni_array_init(&sweep->moved, (int32_t)sizeof(uint64_t));
	cni_array_init(&sweep->loose, (int32_t)sizeof(uint64_t));
	cni_sweep_set_levels(sweep, 0);
	if (capacity > 0 && !sweep_reserve((cni_broadphase *)(void *)sweep, capacity)) {
		sweep_destroy((cni_broadphase *)(void *)sweep);
		return NULL;
	}
	return (cni_broadphase *)(void *)sweep;
}

/* ---- proxies ---- */

static void unmark(uint64_t *words, int32_t id, int32_t *count)
{
	*count -= cni_bit_get(words, id);
	cni_bit_clear(words, id);
}

static void mark_moved(cni_sweep *sweep, int32_t id)
{
	cni_sweep_proxy(sweep, id)->flags |= CNI_PROXY_MOVED;
	cni_sweep_mark(cni_sweep_moved(sweep), id, &sweep->moved_count);
}

static void sweep_add(cni_broadphase *broadphase, int32_t id)
{
	cni_sweep *sweep = sweep_of(broadphase);
	cni_proxy *proxy = cni_sweep_proxy(sweep, id);
	CNI_ASSERT(id >= 0 && cni_bit_words(id + 1) <= sweep->moved.count && cni_bit_words(id + 1) <= sweep->loose.count);
	proxy->cell = CNI_NONE;
	proxy->old = cni_no_box();
	++sweep->count;
	++sweep->adds;
	sweep->id_end = cni_max_i(sweep->id_end, id + 1);
	mark_moved(sweep, id);
	cni_sweep_mark(cni_sweep_loose(sweep), id, &sweep->loose_count);
	/* Queries test loose proxies one by one, so their number between steps is bounded. */
	if (sweep->loose_count > SETTLE_PENDING + sweep->count / 8)
		cni_sweep_settle(sweep, NULL); /* outside a step the user's task system is not used */
}

static void sweep_remove(cni_broadphase *broadphase, int32_t id)
{
	cni_sweep *sweep = sweep_of(broadphase);
	cni_proxy *proxy = cni_sweep_proxy(sweep, id);
	if (proxy->cell != CNI_NONE) {
		cni_sweep_tile *tile = cni_sweep_tile_at(sweep, proxy->cell);
		cni_sweep_entry_remove(sweep, tile, id);
		if (tile->count == 0)
			cni_sweep_tile_destroy(sweep, proxy->cell);
	}
	proxy->cell = CNI_NONE;
	proxy->flags &= ~(uint32_t)CNI_PROXY_MOVED;
	unmark(cni_sweep_moved(sweep), id, &sweep->moved_count);
	unmark(cni_sweep_loose(sweep), id, &sweep->loose_count);
	--sweep->count;
}

static void sweep_move(cni_broadphase *broadphase, int32_t id)
{
	cni_sweep *sweep = sweep_of(broadphase);
	cni_sweep_mark(cni_sweep_moved(sweep), id, &sweep->moved_count);
	cni_sweep_mark(cni_sweep_loose(sweep), id, &sweep->loose_count);
}

static void sweep_touch(cni_broadphase *broadphase, int32_t id)
{
	cni_sweep *sweep = sweep_of(broadphase);
	mark_moved(sweep, id);
	cni_sweep_proxy(sweep, id)->old = cni_no_box();
}

/* ---- update ---- */

/* The present box becomes the old box, except for proxies that lost a pair: they stay moved, and their old box becomes empty. */
static void finish_moved(cni_sweep *sweep, int32_t pairs_lost)
{
	cni_sweep_walk walk = cni_sweep_walk_bits(sweep, &sweep->moved, sweep->moved_count);
	int32_t id, moved = 0;
	while ((id = cni_sweep_walk_next(&walk)) != CNI_NONE) {
		cni_proxy *proxy = cni_sweep_proxy(sweep, id);
		if (proxy->flags & CNI_PROXY_AGAIN) {
			proxy->flags &= ~(uint32_t)CNI_PROXY_AGAIN;
			proxy->old = cni_no_box();
			++moved;
			continue;
		}
		proxy->old = proxy->fat;
		proxy->flags &= ~(uint32_t)CNI_PROXY_MOVED;
		if (pairs_lost > 0)
			cni_bit_clear(cni_sweep_moved(sweep), id);
	}
	if (pairs_lost == 0)
		memset(cni_sweep_moved(sweep), 0, (size_t)cni_bit_words(sweep->id_end) * sizeof(uint64_t));
	sweep->moved_count = moved;
}

static void sweep_update(cni_broadphase *broadphase, cni_pair_filter_fn *filter, const void *filter_context, cni_broadphase_pairs *out)
{
	cni_sweep *sweep = sweep_of(broadphase);
	cni_pairs_begin(out, sweep->count);
	cni_sweep_settle(sweep, cni_sweep_team(sweep));
	if (sweep->moved_count == 0)
		return;
	do {
		cni_sweep_find_pairs(sweep, filter, filter_context, out);
	} while (cni_pairs_search_again(out, sweep->context.arena, sweep->id_end));
	finish_moved(sweep, out->pairs_lost);
	cni_pairs_sort(out, sweep->context.arena);
}

static void sweep_settle(cni_broadphase *broadphase)
{
	cni_sweep *sweep = sweep_of(broadphase);
	cni_sweep_settle(sweep, cni_sweep_team(sweep));
}

/* ---- figures ---- */

static int32_t sweep_cells(const cni_broadphase *broadphase) { return cni_sweep_of(broadphase)->tile_count; }

/* Worst case: each proxy is alone in its tile. It takes a tile, up to four table slots, the smallest piece of rows and two
   bits. The array of tiles and the table are copied when they grow, which takes half as much again. With less memory
   proxies stay loose and updates become slow, but no proxy is lost. */
static uint64_t sweep_bytes_needed(int32_t capacity)
{
	uint64_t growing = sizeof(cni_sweep_tile) + 4 * sizeof(int32_t);
	return 1024 + (uint64_t)capacity * (growing + growing / 2 + cni_blocks_rounded(40) + 1);
}

/* ---- checks ---- */

static int32_t entry_holds(const cni_sweep *sweep, int32_t tile, const cni_sweep_rows *rows, int32_t k)
{
	const cni_sweep_tile *t = cni_sweep_tile_at(sweep, tile);
	const cni_sweep_level *level = &sweep->levels[t->level];
	const cni_proxy *proxy = cni_sweep_proxy(sweep, rows->id[k]);
	cni_aabb box = cni_sweep_box_at(rows, k);
	if (k > 0 && !(rows->x0[k - 1] < rows->x0[k] || (rows->x0[k - 1] == rows->x0[k] && rows->id[k - 1] < rows->id[k])))
		return 0;
	if (!cni_bit_get(cni_sweep_loose(sweep), rows->id[k]) && memcmp(&box, &proxy->fat, sizeof(box)) != 0)
		return 0;
	return proxy->cell == tile && cni_aabb_contains(&t->bounds, &box) && !(box.x1 - box.x0 > t->reach) &&
	       !(cni_sweep_extent(&box) > level->reach) && (t->level == CNI_SWEEP_LEVELS - 1 || cni_sweep_extent(&box) < level->size) &&
	       cni_sweep_cell_x(level, box.x0) == t->tx && cni_sweep_cell_y(level, box.y0) == t->ty;
}

static int32_t tile_holds(const cni_sweep *sweep, int32_t tile)
{
	const cni_sweep_tile *t = cni_sweep_tile_at(sweep, tile);
	const cni_sweep_level *level = &sweep->levels[t->level];
	cni_sweep_rows rows = cni_sweep_rows_of(sweep, t);
	int32_t k;
	if (t->count <= 0 || t->count > t->capacity || t->touched != 0 || t->dense ||
	    cni_sweep_tile_find(sweep, t->level, t->tx, t->ty) != tile || !(sweep->level_mask >> t->level & 1u))
		return 0;
	for (k = 0; k < t->count; ++k)
		if (!entry_holds(sweep, tile, &rows, k))
			return 0;
	for (; k < t->capacity && (k & (CNI_SWEEP_LANES - 1)) != 0; ++k)
		if (!(rows.x0[k] > FLT_MAX))
			return 0;
	return t->tx >= level->tx0 && t->tx <= level->tx1 && t->ty >= level->ty0 && t->ty <= level->ty1;
}

static int32_t tiles_hold(const cni_sweep *sweep, int32_t *entries)
{
	int32_t tiles = 0, level_entries = 0;
	*entries = 0;
	for (int32_t tile = 0; tile < sweep->tiles.count; ++tile) {
		const cni_sweep_tile *t = cni_sweep_tile_at(sweep, tile);
		if (t->level == CNI_SWEEP_FREE)
			continue;
		if (!tile_holds(sweep, tile))
			return 0;
		*entries += t->count;
		++tiles;
	}
	for (int32_t l = 0; l < CNI_SWEEP_LEVELS; ++l)
		level_entries += sweep->levels[l].tiles > 0 ? sweep->levels[l].entries : 0;
	return tiles == sweep->tile_count && level_entries == *entries;
}

/* Moved proxies have their flag; only loose proxies may be in no tile. Walks whatever the counts of the sets are. */
static int32_t marks_hold(const cni_sweep *sweep, int32_t entries)
{
	cni_sweep_walk walk = cni_sweep_walk_bits(sweep, &sweep->moved, 1);
	int32_t id, moved = 0, loose = 0;
	for (; (id = cni_sweep_walk_next(&walk)) != CNI_NONE; ++moved)
		if ((cni_sweep_proxy(sweep, id)->flags & (CNI_PROXY_MOVED | CNI_PROXY_AGAIN)) != CNI_PROXY_MOVED)
			return 0;
	walk = cni_sweep_walk_bits(sweep, &sweep->loose, 1);
	for (; (id = cni_sweep_walk_next(&walk)) != CNI_NONE; ++loose)
		entries += cni_sweep_proxy(sweep, id)->cell == CNI_NONE;
	return moved == sweep->moved_count && loose == sweep->loose_count && entries == sweep->count;
}

int32_t cni_broadphase_sweep_holds(const cni_broadphase *broadphase)
{
	int32_t entries;
	return tiles_hold(cni_sweep_of(broadphase), &entries) && marks_hold(cni_sweep_of(broadphase), entries);
}

/* ---- snapshots ---- */

/* Sets of ids: only the words of ids up to id_end are copied, because the number of words depends on the capacity. */
static void bits_pass(cni_snapshot *s, cni_array *bits, int32_t words)
{
	if (s->mode == CNI_SNAPSHOT_LOAD && bits->count > 0)
		memset(bits->data, 0, (size_t)bits->count * sizeof(uint64_t));
	cni_snapshot_state(s, bits->data, (uint64_t)words * sizeof(uint64_t));
}

/* Loading rebuilds the table from cells to tiles. */
static void sweep_snapshot(cni_broadphase *broadphase, cni_snapshot *s)
{
	cni_sweep *sweep = sweep_of(broadphase);
	int32_t words = cni_snapshot_number(s, cni_bit_words(sweep->id_end)), tiles = cni_snapshot_number(s, sweep->tile_count);
	if (cni_snapshot_reserves(s))
		cni_snapshot_need(s, sweep_reserve(broadphase, 0) && words <= sweep->moved.count && words <= sweep->loose.count &&
		                             cni_sweep_slots_reserve(sweep, tiles));
	bits_pass(s, &sweep->moved, words);
	bits_pass(s, &sweep->loose, words);
	cni_snapshot_array(s, &sweep->tiles);
	cni_snapshot_blocks(s, &sweep->rows);
	cni_snapshot_members(s, sweep, offsetof(cni_sweep, tile_free), sizeof *sweep);
	if (s->mode == CNI_SNAPSHOT_LOAD) {
		sweep->tile_count = tiles;
		cni_sweep_slots_fill(sweep);
	}
}

const cni_broadphase_ops cni_broadphase_sweep = {
	sweep_create, sweep_destroy,   sweep_reserve, sweep_add,   sweep_remove,       sweep_move, sweep_touch, sweep_update,
	sweep_settle, cni_sweep_query, cni_sweep_ray, sweep_cells, sweep_bytes_needed, sweep_snapshot,
};
