/*
 * stages/broadphase_sweep_settle.c - brings the tiles up to date with the proxies' boxes, and chooses S0.
 *
 * Reads the fat boxes of loose proxies; writes tiles and proxies' cells. Invariant afterwards: every
 * proxy that is not loose has its present box as an entry of the tile that its cell names.
 *
 * Two ways, by how much changes in a tile. Where a sixth or more of the entries change, migrants are
 * appended to the new tile and the tile is rebuilt once: entries whose proxy is elsewhere by now drop
 * out, keys (x0, id) are sorted, nearly sorted as they mostly are, and the rows are gathered from
 * the proxies. Elsewhere each entry is shifted, inserted or removed in place. Without scratch memory
 * everything goes the second way, one proxy after the other.
 *
 * Sizes: S0 is twice the power of two above the 90th percentile of the larger sides of non-static boxes,
 * raised while tiles hold too few entries. It is chosen at the first settle, when as many proxies
 * were added as there were, when half of them are gone, and, ever more patiently, while tiles are badly
 * filled. All of that depends only on the history of calls, and pairs do not depend on S0 at all.
 */
#include "stages/broadphase_sweep.h"
#include "base/sort.h"

#include <string.h>

#define DENSE_SHARE 6          /* one in so many entries changed: rebuild */
#define DENSE_CHANGES 3        /* but not for fewer changes */
#define BOOST_MOST 3
#define BOOST_LEAST (-1)
#define FILL_LOW 12            /* entries a tile of level 0, on average */
#define FILL_HIGH 192
#define FILL_HIGH_ANEW 64      /* when sizes are chosen anyway */
#define TUNE_FEWEST 64         /* proxies: below, sizes hardly matter */
#define PATIENCE_MOST 256      /* settles */

/* ---- choosing sizes ---- */

static void drop_entries(cni_sweep *sweep, const cni_sweep_tile *tile)
{
	cni_sweep_rows rows = cni_sweep_rows_of(sweep, tile);
	int32_t k;
	for (k = 0; k < tile->count; ++k) {
		cni_sweep_proxy(sweep, rows.id[k])->cell = CNI_NONE;
		if (!cni_bit_get(cni_sweep_loose(sweep), rows.id[k]))
			++sweep->loose_count;
		cni_bit_set(cni_sweep_loose(sweep), rows.id[k]);
	}
}

/* Every proxy is loose afterwards, and there are no tiles. */
static void drop_tiles(cni_sweep *sweep)
{
	int32_t tile;
	for (tile = 0; tile < sweep->tiles.count; ++tile) {
		cni_sweep_tile *t = cni_sweep_tile_at(sweep, tile);
		if (t->level == CNI_SWEEP_FREE)
			continue;
		if (t->count > 0)
			drop_entries(sweep, t);
		cni_sweep_tile_destroy(sweep, tile);
	}
	sweep->tiles.count = 0;
	sweep->tile_free = CNI_NONE;
	cni_blocks_deinit(&sweep->rows); /* pieces of the old sizes would lie idle */
}

/* The power of two above x, as an exponent in [-20, 30]. */
static int32_t exponent_above(float x)
{
	uint32_t bits;
	memcpy(&bits, &x, sizeof(bits));
	return cni_min_i(cni_max_i((int32_t)(bits >> 23 & 255u) - 126, -20), 30);
}

typedef struct extent_counts {
	int32_t dynamic[51];
	int32_t any[51];
	int32_t dynamic_sum, any_sum;
} extent_counts;

static void extent_count(extent_counts *counts, const cni_proxy *proxy)
{
	int32_t e = exponent_above(cni_sweep_extent(&proxy->fat)) + 20;
	++counts->any[e];
	++counts->any_sum;
	if (proxy->flags & CNI_PROXY_STATIC)
		return;
	++counts->dynamic[e];
	++counts->dynamic_sum;
}

/* Exponent of the power of two above nine in ten of the boxes. */
static int32_t extent_percentile(const extent_counts *counts)
{
	const int32_t *histogram = counts->dynamic_sum > 0 ? counts->dynamic : counts->any;
	int64_t sum = counts->dynamic_sum > 0 ? counts->dynamic_sum : counts->any_sum;
	int64_t below = 0;
	int32_t e;
	for (e = 0; e < 50; ++e) {
		below += histogram[e];
		if (10 * below >= 9 * sum)
			break;
	}
	return e - 20;
}

static int32_t measure_exponent(const cni_sweep *sweep)
{
	extent_counts counts;
	cni_sweep_walk walk = cni_sweep_walk_bits(sweep, &sweep->loose);
	int32_t tile, id, k;
	memset(&counts, 0, sizeof(counts));
	for (tile = 0; tile < sweep->tiles.count; ++tile) {
		const cni_sweep_tile *t = cni_sweep_tile_at(sweep, tile);
		if (t->level == CNI_SWEEP_FREE)
			continue;
		for (k = 0; k < t->count; ++k)
			extent_count(&counts, cni_sweep_proxy(sweep, cni_sweep_rows_of(sweep, t).id[k]));
	}
	while ((id = cni_sweep_walk_next(&walk)) != CNI_NONE)
		if (cni_sweep_proxy(sweep, id)->cell == CNI_NONE)
			extent_count(&counts, cni_sweep_proxy(sweep, id));
	return extent_percentile(&counts);
}

/* How S0 should change for the fill of the tiles: 1, 0 or -1 powers of two. */
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
	int32_t exponent;
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
	exponent = measure_exponent(sweep) + 1 + sweep->boost;
	if (exponent == sweep->exponent)
		return;
	drop_tiles(sweep);
	cni_sweep_set_levels(sweep, exponent);
}

/* ---- one proxy ---- */

/* The tile where a proxy's box belongs; CNI_NONE when it would have to be made and there is no memory. */
static int32_t home_find(cni_sweep *sweep, const cni_proxy *proxy)
{
	const cni_sweep_tile *now = proxy->cell == CNI_NONE ? NULL : cni_sweep_tile_at(sweep, proxy->cell);
	int32_t l = cni_sweep_level_for(sweep, cni_sweep_extent(&proxy->fat), now != NULL ? now->level : 0);
	int32_t tx = cni_sweep_cell_x(&sweep->levels[l], proxy->fat.x0);
	int32_t ty = cni_sweep_cell_y(&sweep->levels[l], proxy->fat.y0);
	if (now != NULL && now->tx == tx && now->ty == ty && now->level == l)
		return proxy->cell;
	return cni_sweep_tile_make(sweep, l, tx, ty);
}

static void mark_settled(cni_sweep *sweep, int32_t id)
{
	cni_bit_clear(cni_sweep_loose(sweep), id);
	--sweep->loose_count;
}

static void leave(cni_sweep *sweep, cni_proxy *proxy, int32_t id)
{
	cni_sweep_tile *tile = cni_sweep_tile_at(sweep, proxy->cell);
	cni_sweep_entry_remove(sweep, tile, cni_sweep_entry_find(sweep, tile, id));
	proxy->cell = CNI_NONE;
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

/* Moves an entry to its home; in dense tiles only marks what the rebuild is to do. */
static void settle_proxy(cni_sweep *sweep, int32_t id, int32_t home)
{
	cni_proxy *proxy = cni_sweep_proxy(sweep, id);
	if (proxy->cell == home && home != CNI_NONE) {
		cni_sweep_tile *tile = cni_sweep_tile_at(sweep, home);
		if (!tile->dense)
			cni_sweep_entry_shift(sweep, tile, cni_sweep_entry_find(sweep, tile, id), &proxy->fat);
		mark_settled(sweep, id);
		return;
	}
	if (proxy->cell != CNI_NONE && !cni_sweep_tile_at(sweep, proxy->cell)->dense)
		leave(sweep, proxy, id);
	proxy->cell = CNI_NONE;
	if (home != CNI_NONE)
		enter(sweep, proxy, id, home);
}

/* ---- one by one, without scratch ---- */

static void settle_singly(cni_sweep *sweep)
{
	cni_sweep_walk walk = cni_sweep_walk_bits(sweep, &sweep->loose);
	int32_t id;
	while ((id = cni_sweep_walk_next(&walk)) != CNI_NONE) {
		int32_t before = cni_sweep_proxy(sweep, id)->cell;
		int32_t home = home_find(sweep, cni_sweep_proxy(sweep, id));
		settle_proxy(sweep, id, home);
		if (before != CNI_NONE && before != home && cni_sweep_tile_at(sweep, before)->count == 0)
			cni_sweep_tile_destroy(sweep, before);
		if (home != CNI_NONE && cni_sweep_tile_at(sweep, home)->count == 0)
			cni_sweep_tile_destroy(sweep, home);
	}
}

/* ---- many at once ---- */

typedef struct settle_pass {
	int32_t *homes;    /* of each loose proxy */
	int32_t *touched;  /* tiles that change */
	int32_t touched_count;
	uint64_t *keys;    /* room for the largest tile, twice */
	int32_t key_count;
} settle_pass;

static void touch(const cni_sweep *sweep, settle_pass *pass, int32_t tile)
{
	if (tile != CNI_NONE && cni_sweep_tile_at(sweep, tile)->touched++ == 0)
		pass->touched[pass->touched_count++] = tile;
}

static void find_homes(cni_sweep *sweep, settle_pass *pass)
{
	cni_sweep_walk walk = cni_sweep_walk_bits(sweep, &sweep->loose);
	int32_t id, i = 0;
	while ((id = cni_sweep_walk_next(&walk)) != CNI_NONE) {
		const cni_proxy *proxy = cni_sweep_proxy(sweep, id);
		int32_t home = home_find(sweep, proxy);
		pass->homes[i++] = home;
		touch(sweep, pass, home);
		if (proxy->cell != home)
			touch(sweep, pass, proxy->cell);
	}
}

/* Decides which tiles are rebuilt, and takes the keys for the largest. */
static void choose_dense(cni_sweep *sweep, settle_pass *pass)
{
	int32_t largest = 0;
	int32_t i;
	for (i = 0; i < pass->touched_count; ++i) {
		const cni_sweep_tile *tile = cni_sweep_tile_at(sweep, pass->touched[i]);
		largest = cni_max_i(largest, tile->count + tile->touched);
	}
	pass->keys = (uint64_t *)cni_arena_push(sweep->context.arena, 2u * sizeof(uint64_t) * (uint64_t)largest);
	pass->key_count = largest;
	for (i = 0; i < pass->touched_count; ++i) {
		cni_sweep_tile *tile = cni_sweep_tile_at(sweep, pass->touched[i]);
		tile->dense = pass->keys != NULL && tile->touched >= DENSE_CHANGES && DENSE_SHARE * tile->touched >= tile->count;
	}
}

static void migrate(cni_sweep *sweep, const settle_pass *pass)
{
	cni_sweep_walk walk = cni_sweep_walk_bits(sweep, &sweep->loose);
	int32_t id, i = 0;
	while ((id = cni_sweep_walk_next(&walk)) != CNI_NONE)
		settle_proxy(sweep, id, pass->homes[i++]);
}

/* Keys of the entries that still belong here; returns their number. */
static int32_t collect_keys(const cni_sweep *sweep, int32_t tile, uint64_t *keys)
{
	const cni_sweep_tile *t = cni_sweep_tile_at(sweep, tile);
	const int32_t *ids = cni_sweep_rows_of(sweep, t).id;
	int32_t count = 0;
	int32_t k;
	for (k = 0; k < t->count; ++k) {
		const cni_proxy *proxy = cni_sweep_proxy(sweep, ids[k]);
		keys[count] = (uint64_t)cni_sort_float_key(proxy->fat.x0) << 32 | (uint32_t)ids[k];
		count += proxy->cell == tile;
	}
	return count;
}

static void gather_rows(const cni_sweep *sweep, const cni_sweep_tile *tile, const uint64_t *keys)
{
	cni_sweep_rows rows = cni_sweep_rows_of(sweep, tile);
	int32_t k;
	for (k = 0; k < tile->count; ++k) {
		int32_t id = (int32_t)(uint32_t)keys[k];
		const cni_aabb *fat = &cni_sweep_proxy(sweep, id)->fat;
		rows.x0[k] = fat->x0;
		rows.x1[k] = fat->x1;
		rows.y0[k] = fat->y0;
		rows.y1[k] = fat->y1;
		rows.id[k] = id;
	}
}

static void rebuild(cni_sweep *sweep, settle_pass *pass, int32_t tile)
{
	cni_sweep_tile *t = cni_sweep_tile_at(sweep, tile);
	int32_t count;
	CNI_ASSERT(t->count <= pass->key_count);
	count = t->count > 0 ? collect_keys(sweep, tile, pass->keys) : 0;
	sweep->levels[t->level].entries += count - t->count;
	t->count = count;
	if (count == 0)
		return;
	cni_sort_keys(pass->keys, pass->keys + pass->key_count, count);
	gather_rows(sweep, t, pass->keys);
	cni_sweep_tile_tighten(sweep, t);
	cni_sweep_tile_shrink(sweep, t);
	cni_sweep_tile_pad(sweep, t);
}

static void finish_tiles(cni_sweep *sweep, settle_pass *pass)
{
	int32_t i;
	for (i = 0; i < pass->touched_count; ++i) {
		int32_t tile = pass->touched[i];
		cni_sweep_tile *t = cni_sweep_tile_at(sweep, tile);
		if (t->dense)
			rebuild(sweep, pass, tile);
		t->dense = 0;
		t->touched = 0;
		if (t->count == 0)
			cni_sweep_tile_destroy(sweep, tile);
	}
}

static int32_t settle_together(cni_sweep *sweep)
{
	settle_pass pass;
	/* Tiles that change: a loose proxy's home and where it is now, or all tiles that there are and a new one each. */
	uint64_t touched = (uint64_t)sweep->loose_count + (uint64_t)cni_min_i(sweep->loose_count, sweep->tile_count);
	void *scratch = cni_arena_push(sweep->context.arena, sizeof(int32_t) * ((uint64_t)sweep->loose_count + touched));
	if (scratch == NULL)
		return 0;
	memset(&pass, 0, sizeof(pass));
	pass.homes = (int32_t *)scratch;
	pass.touched = pass.homes + sweep->loose_count;
	find_homes(sweep, &pass);
	choose_dense(sweep, &pass);
	migrate(sweep, &pass);
	finish_tiles(sweep, &pass);
	(void)cni_arena_pop(sweep->context.arena, pass.keys);
	(void)cni_arena_pop(sweep->context.arena, scratch);
	return 1;
}

void cni_sweep_settle(cni_sweep *sweep)
{
	tune(sweep);
	if (sweep->loose_count > 0 && !settle_together(sweep))
		settle_singly(sweep);
}
