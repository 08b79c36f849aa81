/*
 * broadphase/sweep_settle.c - brings the tiles up to date with the proxies' boxes, and chooses S0.
 *
 * Reads the fat boxes of loose proxies; writes tiles and proxies' cells. Invariant afterwards: every
 * proxy that is not loose has its present box as an entry of the tile that its cell names.
 *
 * A tile is updated in one of two ways. Where many entries change, migrants are appended to the new tile
 * and the tile is rebuilt once: entries whose proxy has left are dropped, the keys (x0, id), mostly nearly sorted, are
 * sorted, and the rows are gathered from the proxies. Elsewhere each entry is shifted, inserted or removed in place.
 * Without scratch memory all tiles are updated in place, one proxy after the other.
 *
 * Workers may share the lookup of homes, which makes no tile, and the rebuilds, which write only their tile. One thread
 * changes the table, the levels and memory, in between and after, in order.
 *
 * Sizes: S0 is twice the power of two above the 90th percentile of the larger sides of non-static boxes, raised while
 * tiles hold too few entries. It is chosen at the first settle, when the number of added proxies reaches the number at the
 * last choice, when half of the proxies are gone, and, at growing intervals, while tiles are badly filled. The choice
 * depends only on the history of calls, and the pairs do not depend on S0.
 */
#include "broadphase/sweep.h"
#include "base/sort.h"

#include <string.h>

#define BOOST_MOST 3
#define BOOST_LEAST (-1)
#define FILL_LOW 12            /* entries a tile of level 0, on average */
#define FILL_HIGH 192
#define FILL_HIGH_ANEW 64      /* when sizes are chosen anyway */
#define TUNE_FEWEST 64         /* proxies: below, sizes hardly matter */
#define PATIENCE_MOST 256      /* settles */
#define SHARED_LEAST 1024      /* loose proxies for which it pays to wake other workers */
#define RANGE_WORDS 16         /* of the loose set, some ten microseconds of looking for homes */
#define RANGE_TILES 4          /* ... of rebuilding */
#define HOME_STAYS 0x40000000  /* beside a tile: the proxy is there now */

/* ---- choosing sizes ---- */

/* Every proxy is loose afterwards, and there are no tiles; the levels are still those of the old ones. */
static void drop_tiles(cni_sweep *sweep)
{
	for (int32_t tile = 0; tile < sweep->tiles.count; ++tile)
		for (int32_t k = 0; k < cni_sweep_tile_at(sweep, tile)->count; ++k) {
			int32_t id = cni_sweep_rows_of(sweep, cni_sweep_tile_at(sweep, tile)).id[k];
			cni_sweep_proxy(sweep, id)->cell = CNI_NONE;
			cni_sweep_mark(cni_sweep_loose(sweep), id, &sweep->loose_count);
		}
	sweep->tiles.count = sweep->tile_count = 0;
	sweep->tile_free = CNI_NONE;
	sweep->level_mask = 0;
	cni_sweep_slots_fill(sweep);
	cni_blocks_deinit(&sweep->rows); /* pieces of the old sizes would stay unused */
}

/* The power of two above x, as an exponent in [-20, 30]. */
static int32_t exponent_above(float x)
{
	return cni_min_i(cni_max_i((int32_t)(cni_bits_of(x) >> 23 & 255u) - 126, -20), 30);
}

/* By exponent; [1]: static boxes. */
typedef struct extent_counts {
	int32_t of[2][51];
	int32_t sum[2];
} extent_counts;

static void extent_count(extent_counts *counts, const cni_proxy *proxy)
{
	int32_t is_static = (proxy->flags & CNI_PROXY_STATIC) != 0;
	++counts->of[is_static][exponent_above(cni_sweep_extent(&proxy->fat)) + 20];
	++counts->sum[is_static];
}

/* Exponent of the power of two above the extents of 90% of the boxes: of those that move, if there are any. */
static int32_t extent_percentile(const extent_counts *counts)
{
	int32_t e, is_static = counts->sum[0] == 0;
	int64_t below = 0;
	for (e = 0; e < 50; ++e) {
		below += counts->of[is_static][e];
		if (10 * below >= 9 * (int64_t)counts->sum[is_static])
			break;
	}
	return e - 20;
}

static int32_t measure_exponent(const cni_sweep *sweep)
{
	extent_counts counts;
	cni_sweep_walk walk = cni_sweep_walk_bits(sweep, &sweep->loose, sweep->loose_count);
	int32_t id;
	memset(&counts, 0, sizeof(counts));
	for (int32_t tile = 0; tile < sweep->tiles.count; ++tile) {
		const cni_sweep_tile *t = cni_sweep_tile_at(sweep, tile);
		for (int32_t k = 0; k < t->count; ++k)
			extent_count(&counts, cni_sweep_proxy(sweep, cni_sweep_rows_of(sweep, t).id[k]));
	}
	while ((id = cni_sweep_walk_next(&walk)) != CNI_NONE)
		if (cni_sweep_proxy(sweep, id)->cell == CNI_NONE)
			extent_count(&counts, cni_sweep_proxy(sweep, id));
	return extent_percentile(&counts);
}

/* Change of S0 in powers of two (1, 0 or -1) that improves the fill of the tiles. */
static int32_t fill_advice(const cni_sweep *sweep, int32_t fill_high)
{
	int64_t entries = sweep->levels[0].entries;
	int64_t tiles = sweep->levels[0].tiles;
	if (entries < TUNE_FEWEST)
		return 0;
	if (entries < FILL_LOW * tiles && sweep->boost < BOOST_MOST)
		return 1;
	return entries > fill_high * tiles && sweep->boost > BOOST_LEAST ? -1 : 0;
}

static int32_t population_changed(const cni_sweep *sweep)
{
	return sweep->tuned_count == 0 || sweep->adds >= cni_max_i(sweep->tuned_count, TUNE_FEWEST) ||
	       (sweep->tuned_count > TUNE_FEWEST && 2 * sweep->count < sweep->tuned_count);
}

static void tune(cni_sweep *sweep)
{
	int32_t changed = population_changed(sweep);
	int32_t advice = 0;
	if (changed || sweep->settles >= sweep->patience)
		advice = fill_advice(sweep, changed ? FILL_HIGH_ANEW : FILL_HIGH);
	++sweep->settles;
	if (sweep->count == 0 || (!changed && advice == 0))
		return;
	sweep->boost += advice;
	sweep->patience = changed ? 1 : cni_min_i(4 * sweep->patience, PATIENCE_MOST);
	sweep->tuned_count = sweep->count;
	sweep->adds = 0;
	sweep->settles = 0;
	int32_t exponent = measure_exponent(sweep) + 1 + sweep->boost;
	if (exponent == sweep->exponent)
		return;
	drop_tiles(sweep);
	cni_sweep_set_levels(sweep, exponent);
}

/* ---- one proxy ---- */

typedef struct cell {
	int32_t level, tx, ty;
} cell;

/* The home of a proxy: the cell of its box, and the cell's tile. The tile has HOME_STAYS set if the proxy is there now, and
   is CNI_NONE if the cell has no tile. */
static int32_t home_look(const cni_sweep *sweep, const cni_proxy *proxy, cell *out)
{
	const cni_sweep_tile *now = proxy->cell == CNI_NONE ? NULL : cni_sweep_tile_at(sweep, proxy->cell);
	int32_t l = cni_sweep_level_for(sweep, cni_sweep_extent(&proxy->fat), now != NULL ? now->level : 0);
	out->level = l;
	out->tx = cni_sweep_cell_x(&sweep->levels[l], proxy->fat.x0);
	out->ty = cni_sweep_cell_y(&sweep->levels[l], proxy->fat.y0);
	if (now != NULL && now->tx == out->tx && now->ty == out->ty && now->level == l)
		return proxy->cell | HOME_STAYS;
	return cni_sweep_tile_find(sweep, l, out->tx, out->ty);
}

/* The same, but makes a missing tile; CNI_NONE when there is no memory. */
static int32_t home_find(cni_sweep *sweep, const cni_proxy *proxy)
{
	cell at;
	int32_t home = home_look(sweep, proxy, &at);
	return home != CNI_NONE ? home : cni_sweep_tile_make(sweep, at.level, at.tx, at.ty);
}

static inline int32_t home_tile(int32_t home) { return home == CNI_NONE ? CNI_NONE : home & ~HOME_STAYS; }

static void mark_settled(cni_sweep *sweep, int32_t id)
{
	cni_bit_clear(cni_sweep_loose(sweep), id);
	--sweep->loose_count;
}

static void enter(cni_sweep *sweep, cni_proxy *proxy, int32_t id, int32_t home)
{
	cni_sweep_tile *tile = cni_sweep_tile_at(sweep, home);
	int32_t done = tile->dense ? cni_sweep_entry_append(sweep, tile, id)
	                           : cni_sweep_entry_insert(sweep, tile, id, &proxy->fat);
	if (!done)
		return;
	proxy->cell = home;
	mark_settled(sweep, id);
}

static void leave(cni_sweep *sweep, cni_sweep_tile *tile, int32_t id)
{
	if (tile->dense)
		--sweep->levels[tile->level].entries;
	else
		cni_sweep_entry_remove(sweep, tile, id);
}

/* Moves an entry to its home; in dense tiles it only prepares the rebuild. */
static void settle_proxy(cni_sweep *sweep, int32_t id, int32_t home)
{
	cni_proxy *proxy = cni_sweep_proxy(sweep, id);
	if (proxy->cell == home && home != CNI_NONE) {
		cni_sweep_tile *tile = cni_sweep_tile_at(sweep, home);
		if (!tile->dense)
			cni_sweep_entry_shift(sweep, tile, id, &proxy->fat);
		mark_settled(sweep, id);
		return;
	}
	if (proxy->cell != CNI_NONE)
		leave(sweep, cni_sweep_tile_at(sweep, proxy->cell), id);
	proxy->cell = CNI_NONE;
	if (home != CNI_NONE)
		enter(sweep, proxy, id, home);
}

/* ---- one by one, without scratch ---- */

static void settle_singly(cni_sweep *sweep)
{
	cni_sweep_walk walk = cni_sweep_walk_bits(sweep, &sweep->loose, sweep->loose_count);
	int32_t id;
	while ((id = cni_sweep_walk_next(&walk)) != CNI_NONE) {
		int32_t before = cni_sweep_proxy(sweep, id)->cell;
		int32_t home = home_tile(home_find(sweep, cni_sweep_proxy(sweep, id)));
		settle_proxy(sweep, id, home);
		if (before != CNI_NONE && before != home && cni_sweep_tile_at(sweep, before)->count == 0)
			cni_sweep_tile_destroy(sweep, before);
		if (home != CNI_NONE && cni_sweep_tile_at(sweep, home)->count == 0)
			cni_sweep_tile_destroy(sweep, home);
	}
}

/* ---- many at once ---- */

typedef struct settle_pass {
	cni_sweep *sweep;
	cni_team *team;    /* NULL: one thread */
	int32_t *homes;    /* of each loose proxy, with HOME_STAYS */
	int32_t *touched;  /* tiles that change */
	int32_t touched_count;
	float *extents;    /* per touched tile: of the largest entry after a rebuild */
} settle_pass;

static void touch(settle_pass *pass, int32_t tile)
{
	if (tile != CNI_NONE && cni_sweep_tile_at(pass->sweep, tile)->touched++ == 0)
		pass->touched[pass->touched_count++] = tile;
}

/* Looks up the homes of a range of words of the loose set. It makes no tile: a missing one yields CNI_NONE. */
static void homes_range(void *context, int32_t begin, int32_t end)
{
	const settle_pass *pass = (const settle_pass *)context;
	cni_sweep_walk walk = cni_sweep_walk_bits(pass->sweep, &pass->sweep->loose, pass->sweep->loose_count);
	int32_t id, i = 0;
	cell at;
	for (int32_t w = 0; w < begin; ++w)
		i += cni_bit_count64(walk.words[w]);
	walk.word = begin - 1;
	walk.end = end;
	while ((id = cni_sweep_walk_next(&walk)) != CNI_NONE)
		pass->homes[i++] = home_look(pass->sweep, cni_sweep_proxy(pass->sweep, id), &at);
}

/* Finds all homes in the order of the proxies, so that tiles are made in that order. */
static void find_homes(settle_pass *pass)
{
	cni_sweep *sweep = pass->sweep;
	cni_sweep_walk walk = cni_sweep_walk_bits(sweep, &sweep->loose, sweep->loose_count);
	int32_t id, i = 0;
	if (pass->team != NULL)
		cni_team_for(pass->team, walk.end, RANGE_WORDS, homes_range, pass);
	while ((id = cni_sweep_walk_next(&walk)) != CNI_NONE) {
		int32_t home = pass->team != NULL ? pass->homes[i] : CNI_NONE;
		if (home == CNI_NONE)
			home = home_find(sweep, cni_sweep_proxy(sweep, id));
		pass->homes[i++] = home;
		touch(pass, home_tile(home));
		if (home == CNI_NONE || !(home & HOME_STAYS))
			touch(pass, cni_sweep_proxy(sweep, id)->cell);
	}
}

/* Decides which tiles are rebuilt. */
static void choose_dense(const settle_pass *pass)
{
	for (int32_t i = 0; i < pass->touched_count; ++i) {
		cni_sweep_tile *tile = cni_sweep_tile_at(pass->sweep, pass->touched[i]);
		tile->dense = (uint8_t)cni_sweep_many_touched(tile);
	}
}

/* Settles all loose proxies. A proxy that stays in a dense tile needs only its bit cleared, so its proxy is not read. */
static void migrate(const settle_pass *pass)
{
	cni_sweep *sweep = pass->sweep;
	cni_sweep_walk walk = cni_sweep_walk_bits(sweep, &sweep->loose, sweep->loose_count);
	int32_t id, i = 0;
	while ((id = cni_sweep_walk_next(&walk)) != CNI_NONE) {
		int32_t home = pass->homes[i++], tile = home_tile(home);
		if (tile != home && cni_sweep_tile_at(sweep, tile)->dense)
			mark_settled(sweep, id);
		else
			settle_proxy(sweep, id, tile);
	}
}

/* Keys of the entries that still belong here; returns their number. */
static int32_t collect_keys(const cni_sweep *sweep, int32_t tile, const int32_t *ids, uint64_t *keys)
{
	int32_t count = 0;
	for (int32_t k = 0; k < cni_sweep_tile_at(sweep, tile)->count; ++k) {
		const cni_proxy *proxy = cni_sweep_proxy(sweep, ids[k]);
		keys[count] = (uint64_t)cni_sort_float_key(proxy->fat.x0) << 32 | (uint32_t)ids[k];
		count += proxy->cell == tile;
	}
	return count;
}

/* Rebuilds a tile and returns the extent of its largest entry. The keys are in the rows x0 and x1, whose boxes are out of date, and the
   scratch of their sorting is in y0 and y1. */
static float rebuild(const cni_sweep *sweep, int32_t tile)
{
	cni_sweep_tile *t = cni_sweep_tile_at(sweep, tile);
	if (t->count == 0)
		return 0.0f;
	cni_sweep_rows rows = cni_sweep_rows_of(sweep, t);
	uint64_t *keys = (uint64_t *)(void *)rows.x0;
	t->count = collect_keys(sweep, tile, rows.id, keys);
	cni_sort_keys(keys, keys + t->capacity, t->count);
	for (int32_t k = 0; k < t->count; ++k)
		rows.id[k] = (int32_t)(uint32_t)keys[k];
	for (int32_t k = 0; k < t->count; ++k)
		cni_sweep_box_set(&rows, k, &cni_sweep_proxy(sweep, rows.id[k])->fat);
	cni_sweep_tile_pad(sweep, t);
	return cni_sweep_tile_measure(sweep, t);
}

/* Writes only the tiles of the range and their extents. */
static void rebuild_range(void *context, int32_t begin, int32_t end)
{
	const settle_pass *pass = (const settle_pass *)context;
	for (int32_t i = begin; i < end; ++i)
		if (cni_sweep_tile_at(pass->sweep, pass->touched[i])->dense)
			pass->extents[i] = rebuild(pass->sweep, pass->touched[i]);
}

static void finish_tiles(settle_pass *pass)
{
	cni_sweep *sweep = pass->sweep;
	cni_team_for(pass->team, pass->touched_count, RANGE_TILES, rebuild_range, pass);
	for (int32_t i = 0; i < pass->touched_count; ++i) {
		int32_t tile = pass->touched[i];
		cni_sweep_tile *t = cni_sweep_tile_at(sweep, tile);
		if (t->dense) {
			cni_sweep_level_cover(&sweep->levels[t->level], pass->extents[i]);
			if (t->count > 0)
				cni_sweep_tile_shrink(sweep, t);
		}
		t->dense = 0;
		t->touched = 0;
		if (t->count == 0)
			cni_sweep_tile_destroy(sweep, tile);
	}
}

static int32_t settle_together(cni_sweep *sweep, cni_team *team)
{
	/* Bound of the tiles that change: a home for each loose proxy, plus each proxy's present tile, at most all tiles. */
	uint64_t touched = (uint64_t)sweep->loose_count + (uint64_t)cni_min_i(sweep->loose_count, sweep->tile_count);
	int32_t *homes = (int32_t *)cni_arena_push(sweep->context.arena, sizeof(int32_t) * ((uint64_t)sweep->loose_count + 2 * touched));
	settle_pass pass = { sweep, sweep->loose_count < SHARED_LEAST ? NULL : team, homes, NULL, 0, NULL };
	if (homes == NULL)
		return 0;
	pass.touched = homes + sweep->loose_count;
	pass.extents = (float *)(void *)(pass.touched + touched);
	find_homes(&pass);
	choose_dense(&pass);
	migrate(&pass);
	finish_tiles(&pass);
	(void)cni_arena_pop(sweep->context.arena, homes);
	return 1;
}

void cni_sweep_settle(cni_sweep *sweep, cni_team *team)
{
	tune(sweep);
	if (sweep->loose_count > 0 && !settle_together(sweep, team))
		settle_singly(sweep);
}
