/*
 * stages/broadphase_sweep_pairs.c - finds the pairs whose boxes overlap now and did not at the last
 * update.
 *
 * Reads proxies and settled tiles; writes the pair list and, for the running pass only, the marks
 * `touched`, `dense` and `previous` of tiles. No set of pairs is kept: that a pair existed follows from
 * the boxes of the last update.
 *
 * A tile is dense when a sixth or more of its entries moved: its old boxes are gathered into scratch
 * rows beside the present ones. Other tiles need none: an unmoved entry's old box is its present one.
 * Each pair is found exactly once:
 *
 *   both in dense tiles      by a sweep of the tile with itself, or of the two: the finer tile's, or the
 *                            lower numbered of one level
 *   dense tile, unmoved      by a sweep of the dense tile with the other, moved ones there left out
 *   moved in a tile that     by a search of that one entry among all tiles; of two such entries the one
 *   is not dense             with the lower id
 *   loose (no memory)        by a slow search of the loose one
 *
 * The inner loop tests CNI_SWEEP_LANES entries at a time: stages/broadphase_sweep_lanes.h.
 */
#include "base/cpu.h"
#if CNI_HAS_WIDE_4
#define CNI_WIDTH 4
#else
#define CNI_WIDTH 1
#endif
#define CNI_KERNEL cni_sweep_find_new
#include "stages/broadphase_sweep_lanes.h"

#include <string.h>

#define DENSE_SHARE 6      /* one in so many entries moved: sweep the whole tile */
#define DENSE_CHANGES 3    /* but not for fewer */

typedef struct pair_pass {
	cni_sweep *sweep;
	cni_pair_filter_fn *filter;
	const void *filter_context;
	cni_broadphase_pairs *out;
	cni_sweep_find_new_fn *find_new;
	int32_t *touched;  /* tiles with moved proxies, the dense ones first; NULL without scratch */
	int32_t touched_count;
	int32_t dense_count;
	int32_t dense_entries;
	int32_t new_entries; /* of the largest dense tile whose entries are all new */
	float *scratch;      /* +inf and -inf for those (2 new_entries), then old boxes of the other dense tiles */
} pair_pass;

static inline int32_t is_moved(const pair_pass *pass, int32_t id) { return cni_bit_get(cni_sweep_moved(pass->sweep), id); }

/* ---- what was found ---- */

/* A pair of boxes that is new. One of them moved: should the pair be lost, that one looks again. */
static void pair_found(pair_pass *pass, int32_t a, int32_t b)
{
	cni_proxy *pa = cni_sweep_proxy(pass->sweep, a);
	cni_proxy *pb = cni_sweep_proxy(pass->sweep, b);
	if ((pa->flags & pb->flags & CNI_PROXY_STATIC) || !pass->filter(pass->filter_context, a, b))
		return;
	cni_pairs_add(pass->out, pass->sweep->context.memory, a, b, is_moved(pass, a) ? pa : pb);
}

static void entry_found(pair_pass *pass, const cni_sweep_probe *q, const cni_sweep_view *view, int32_t k)
{
	int32_t id = view->id[k];
	if (id == q->id || (view->skip_moved && is_moved(pass, id)) || (q->skip_moved && is_moved(pass, q->id)))
		return;
	pair_found(pass, q->id, id);
}

/* ---- the inner loop ---- */

/* Does entry k overlap now and did not before? The entry begins left of the probe's right side. */
static inline int32_t entry_is_new(const cni_sweep_probe *q, const cni_sweep_view *v, int32_t k)
{
	int32_t now = (v->x1[k] >= q->now.x0) & (v->y0[k] <= q->now.y1) & (v->y1[k] >= q->now.y0);
	int32_t old = (v->px0[k] <= q->old.x1) & (v->px1[k] >= q->old.x0) & (v->py0[k] <= q->old.y1) & (v->py1[k] >= q->old.y0);
	return now & (old ^ 1);
}

static void scan_lanes(pair_pass *pass, const cni_sweep_probe *q, const cni_sweep_view *v, int32_t from)
{
	int32_t k = from & ~(CNI_SWEEP_LANES - 1);
	uint32_t bits, wanted = ~0u << (from - k);
	for (; (bits = pass->find_new(q, v, &k, wanted)) != 0; k += CNI_SWEEP_LANES) {
		wanted = ~0u;
		for (; bits != 0; bits &= bits - 1) {
			int32_t i = k + cni_bit_lowest32(bits);
			if (i < v->count)
				entry_found(pass, q, v, i);
		}
	}
}

/* Tests the entries from an index on, until they begin beyond the probe. */
static inline void scan(pair_pass *pass, const cni_sweep_probe *q, const cni_sweep_view *v, int32_t from)
{
	int32_t k = from;
	if (k >= v->count || !(v->x0[k] <= q->now.x1))
		return;
	if (v->wide) {
		scan_lanes(pass, q, v, k);
		return;
	}
	for (; k < v->count && v->x0[k] <= q->now.x1; ++k)
		if (entry_is_new(q, v, k))
			entry_found(pass, q, v, k);
}

/* ---- views and probes ---- */

static float *old_boxes(const pair_pass *pass, const cni_sweep_tile *tile)
{
	return pass->scratch + 2 * pass->new_entries + tile->previous;
}

static cni_sweep_view view_of(const pair_pass *pass, const cni_sweep_tile *tile)
{
	cni_sweep_rows rows = cni_sweep_rows_of(pass->sweep, tile);
	cni_sweep_view v;
	v.x0 = v.px0 = rows.x0;
	v.x1 = v.px1 = rows.x1;
	v.y0 = v.py0 = rows.y0;
	v.y1 = v.py1 = rows.y1;
	v.id = rows.id;
	v.count = tile->count;
	v.wide = tile->capacity >= CNI_SWEEP_LANES;
	v.reach = tile->reach;
	v.skip_moved = tile->touched > 0 && !tile->dense;
	if (tile->dense && tile->previous == CNI_NONE) {
		v.px0 = v.py0 = pass->scratch;
		v.px1 = v.py1 = pass->scratch + pass->new_entries;
	} else if (tile->dense) {
		v.px0 = old_boxes(pass, tile);
		v.px1 = v.px0 + tile->capacity;
		v.py0 = v.px1 + tile->capacity;
		v.py1 = v.py0 + tile->capacity;
	}
	return v;
}

static inline cni_sweep_probe probe_of(const cni_sweep_view *v, int32_t i)
{
	cni_sweep_probe q;
	q.now.x0 = v->x0[i];
	q.now.x1 = v->x1[i];
	q.now.y0 = v->y0[i];
	q.now.y1 = v->y1[i];
	q.old.x0 = v->px0[i];
	q.old.x1 = v->px1[i];
	q.old.y0 = v->py0[i];
	q.old.y1 = v->py1[i];
	q.id = v->id[i];
	q.skip_moved = v->skip_moved;
	return q;
}

/* First entry that may reach x0. */
static int32_t scan_begin(const cni_sweep_view *v, float x0)
{
	float from = x0 - v->reach;
	int32_t low = 0, left = v->count;
	while (left > 0) {
		int32_t half = (left + 1) / 2;
		low += half & -(v->x0[low + half - 1] < from);
		left -= half;
	}
	return low;
}

/* ---- dense tiles ---- */

static void sweep_self(pair_pass *pass, const cni_sweep_view *v)
{
	int32_t i;
	for (i = 0; i + 1 < v->count; ++i) {
		cni_sweep_probe q;
		if (v->x0[i + 1] > v->x1[i])
			continue;
		q = probe_of(v, i);
		scan(pass, &q, v, i + 1);
	}
}

/* Each entry of one tile against those of the other that begin where they may reach it. */
static void sweep_two(pair_pass *pass, const cni_sweep_view *outer, const cni_sweep_view *inner, const cni_aabb *inner_bounds)
{
	int32_t i, low = 0;
	for (i = 0; i < outer->count && outer->x0[i] <= inner_bounds->x1; ++i) {
		float from = outer->x0[i] - inner->reach;
		cni_sweep_probe q;
		if ((outer->x1[i] < inner_bounds->x0) | (outer->y1[i] < inner_bounds->y0) | (outer->y0[i] > inner_bounds->y1))
			continue;
		while (low < inner->count && inner->x0[low] < from)
			++low;
		if (low == inner->count)
			return;
		if (inner->x0[low] > outer->x1[i])
			continue;
		q = probe_of(outer, i);
		scan(pass, &q, inner, low);
	}
}

/* Is a dense tile the one to sweep itself with the other? */
static int32_t owns(const cni_sweep *sweep, int32_t tile, int32_t other)
{
	const cni_sweep_tile *a = cni_sweep_tile_at(sweep, tile);
	const cni_sweep_tile *b = cni_sweep_tile_at(sweep, other);
	if (!b->dense)
		return 1;
	return a->level != b->level ? a->level < b->level : tile < other;
}

static void sweep_tile(pair_pass *pass, int32_t tile)
{
	const cni_sweep *sweep = pass->sweep;
	const cni_sweep_tile *a = cni_sweep_tile_at(sweep, tile);
	cni_sweep_view view = view_of(pass, a);
	cni_sweep_cursor cursor;
	int32_t other;
	sweep_self(pass, &view);
	cni_sweep_cursor_start(sweep, &cursor, &a->bounds);
	while ((other = cni_sweep_cursor_next(sweep, &cursor)) != CNI_NONE) {
		const cni_sweep_tile *b = cni_sweep_tile_at(sweep, other);
		cni_sweep_view other_view;
		if (other == tile || !owns(sweep, tile, other))
			continue;
		other_view = view_of(pass, b);
		if (b->count < a->count)
			sweep_two(pass, &other_view, &view, &a->bounds);
		else
			sweep_two(pass, &view, &other_view, &b->bounds);
	}
}

/* ---- single entries ---- */

/* Whether two boxes overlapped at the last update, from the proxies. */
static int32_t overlapped(const cni_proxy *a, const cni_proxy *b)
{
	return a->old.x0 <= a->old.x1 && b->old.x0 <= b->old.x1 && cni_aabb_overlap(&a->old, &b->old);
}

/* A moved entry against a tile with others that search for themselves. */
static void search_touched(pair_pass *pass, const cni_sweep_probe *q, const cni_sweep_view *v)
{
	const cni_proxy *proxy = cni_sweep_proxy(pass->sweep, q->id);
	int32_t k;
	for (k = scan_begin(v, q->now.x0); k < v->count && v->x0[k] <= q->now.x1; ++k) {
		int32_t id = v->id[k];
		if (!((v->x1[k] >= q->now.x0) & (v->y0[k] <= q->now.y1) & (v->y1[k] >= q->now.y0)) || id == q->id)
			continue;
		if (is_moved(pass, id) ? id > q->id && !overlapped(proxy, cni_sweep_proxy(pass->sweep, id)) : entry_is_new(q, v, k))
			pair_found(pass, q->id, id);
	}
}

static void search_entry(pair_pass *pass, int32_t id)
{
	const cni_sweep *sweep = pass->sweep;
	const cni_proxy *proxy = cni_sweep_proxy(sweep, id);
	cni_sweep_cursor cursor;
	int32_t tile;
	cni_sweep_probe q;
	q.now = proxy->fat;
	q.old = cni_sweep_old(proxy);
	q.id = id;
	q.skip_moved = 0;
	cni_sweep_cursor_start(sweep, &cursor, &q.now);
	while ((tile = cni_sweep_cursor_next(sweep, &cursor)) != CNI_NONE) {
		const cni_sweep_tile *t = cni_sweep_tile_at(sweep, tile);
		cni_sweep_view v = view_of(pass, t);
		if (v.skip_moved)
			search_touched(pass, &q, &v);
		else
			scan(pass, &q, &v, scan_begin(&v, q.now.x0));
	}
}

static void search_entries(pair_pass *pass)
{
	cni_sweep_walk walk = cni_sweep_walk_bits(pass->sweep, &pass->sweep->moved);
	int32_t id;
	if (pass->touched != NULL && pass->dense_count == pass->touched_count)
		return; /* every one of them is in a dense tile */
	while ((id = cni_sweep_walk_next(&walk)) != CNI_NONE) {
		int32_t cell = cni_sweep_proxy(pass->sweep, id)->cell;
		if (cell != CNI_NONE && !cni_sweep_tile_at(pass->sweep, cell)->dense)
			search_entry(pass, id);
	}
}

/* ---- loose proxies, for which there was no memory ---- */

static void loose_candidate(pair_pass *pass, int32_t id, int32_t other)
{
	const cni_proxy *a = cni_sweep_proxy(pass->sweep, id);
	const cni_proxy *b = cni_sweep_proxy(pass->sweep, other);
	if (!is_moved(pass, id) && !is_moved(pass, other))
		return;
	if (cni_aabb_overlap(&a->fat, &b->fat) && !overlapped(a, b))
		pair_found(pass, id, other);
}

static void search_loose(pair_pass *pass, int32_t id, cni_sweep_walk others)
{
	const cni_sweep *sweep = pass->sweep;
	cni_sweep_cursor cursor;
	int32_t tile, other, k;
	cni_sweep_cursor_start(sweep, &cursor, &cni_sweep_proxy(sweep, id)->fat);
	while ((tile = cni_sweep_cursor_next(sweep, &cursor)) != CNI_NONE) {
		const cni_sweep_tile *t = cni_sweep_tile_at(sweep, tile);
		cni_sweep_rows rows = cni_sweep_rows_of(sweep, t);
		for (k = 0; k < t->count; ++k)
			loose_candidate(pass, id, rows.id[k]);
	}
	while ((other = cni_sweep_walk_next(&others)) != CNI_NONE)
		loose_candidate(pass, id, other);
}

static void search_all_loose(pair_pass *pass)
{
	cni_sweep_walk walk = cni_sweep_walk_bits(pass->sweep, &pass->sweep->loose);
	int32_t id;
	if (pass->sweep->loose_count == 0)
		return;
	while ((id = cni_sweep_walk_next(&walk)) != CNI_NONE)
		search_loose(pass, id, walk);
}

/* ---- the pass ---- */

static void count_moved(pair_pass *pass)
{
	cni_sweep_walk walk = cni_sweep_walk_bits(pass->sweep, &pass->sweep->moved);
	int32_t id;
	while ((id = cni_sweep_walk_next(&walk)) != CNI_NONE) {
		int32_t cell = cni_sweep_proxy(pass->sweep, id)->cell;
		if (cell != CNI_NONE && cni_sweep_tile_at(pass->sweep, cell)->touched++ == 0 && pass->touched != NULL)
			pass->touched[pass->touched_count++] = cell;
	}
}

/* As in the first step: old boxes that are all empty need not be written out. */
static int32_t all_are_new(const cni_sweep *sweep, const cni_sweep_tile *tile)
{
	const int32_t *ids = cni_sweep_rows_of(sweep, tile).id;
	int32_t k = 0;
	while (k < tile->count && !(cni_sweep_proxy(sweep, ids[k])->old.x0 <= cni_sweep_proxy(sweep, ids[k])->old.x1))
		++k;
	return k == tile->count;
}

/* Marks dense tiles and brings them to the front of the list. */
static void choose_dense(pair_pass *pass)
{
	int32_t i;
	for (i = 0; i < pass->touched_count; ++i) {
		int32_t index = pass->touched[i];
		cni_sweep_tile *tile = cni_sweep_tile_at(pass->sweep, index);
		if (tile->touched < DENSE_CHANGES || DENSE_SHARE * tile->touched < tile->count)
			continue;
		tile->dense = 1;
		tile->previous = CNI_NONE;
		if (all_are_new(pass->sweep, tile)) {
			pass->new_entries = cni_max_i(pass->new_entries, (tile->capacity + CNI_SWEEP_LANES - 1) & ~(CNI_SWEEP_LANES - 1));
		} else {
			tile->previous = 4 * pass->dense_entries;
			pass->dense_entries += tile->capacity;
		}
		pass->touched[i] = pass->touched[pass->dense_count];
		pass->touched[pass->dense_count++] = index;
	}
}

static void forget_dense(pair_pass *pass)
{
	int32_t i;
	for (i = 0; i < pass->dense_count; ++i)
		cni_sweep_tile_at(pass->sweep, pass->touched[i])->dense = 0;
	pass->dense_count = 0;
}

static void gather_previous(const pair_pass *pass, const cni_sweep_tile *tile)
{
	const int32_t *ids = cni_sweep_rows_of(pass->sweep, tile).id;
	float *px0 = old_boxes(pass, tile), *px1 = px0 + tile->capacity, *py0 = px1 + tile->capacity, *py1 = py0 + tile->capacity;
	int32_t k;
	if (tile->previous == CNI_NONE)
		return;
	for (k = 0; k < tile->count; ++k) {
		cni_aabb old = cni_sweep_old(cni_sweep_proxy(pass->sweep, ids[k]));
		px0[k] = old.x0;
		px1[k] = old.x1;
		py0[k] = old.y0;
		py1[k] = old.y1;
	}
}

static void sweep_dense(pair_pass *pass)
{
	cni_arena *arena = pass->sweep->context.arena;
	uint64_t floats = 4 * (uint64_t)pass->dense_entries + 2 * (uint64_t)pass->new_entries;
	int32_t i;
	pass->scratch = (float *)cni_arena_push(arena, sizeof(float) * floats);
	if (pass->scratch == NULL)
		forget_dense(pass);
	for (i = 0; i < pass->new_entries && pass->scratch != NULL; ++i) {
		pass->scratch[i] = INFINITY;
		pass->scratch[pass->new_entries + i] = -INFINITY;
	}
	for (i = 0; i < pass->dense_count; ++i)
		gather_previous(pass, cni_sweep_tile_at(pass->sweep, pass->touched[i]));
	for (i = 0; i < pass->dense_count; ++i)
		sweep_tile(pass, pass->touched[i]);
}

static void tile_clear_marks(cni_sweep *sweep, int32_t tile)
{
	cni_sweep_tile_at(sweep, tile)->touched = 0;
	cni_sweep_tile_at(sweep, tile)->dense = 0;
}

/* Clears the marks of the pass; tiles were settled before and did not change since. */
static void clear_marks(pair_pass *pass)
{
	cni_sweep_walk walk = cni_sweep_walk_bits(pass->sweep, &pass->sweep->moved);
	int32_t id, i;
	for (i = 0; i < pass->touched_count; ++i)
		tile_clear_marks(pass->sweep, pass->touched[i]);
	while (pass->touched == NULL && (id = cni_sweep_walk_next(&walk)) != CNI_NONE) {
		int32_t cell = cni_sweep_proxy(pass->sweep, id)->cell;
		if (cell != CNI_NONE)
			tile_clear_marks(pass->sweep, cell);
	}
}

/* The widest that the processor has. */
static cni_sweep_find_new_fn *find_new_choose(void)
{
#if CNI_HAS_WIDE_8
	if (cni_cpu_has_avx2())
		return cni_sweep_find_new_8;
#endif
	return cni_sweep_find_new;
}

void cni_sweep_find_pairs(cni_sweep *sweep, cni_pair_filter_fn *filter, const void *filter_context, cni_broadphase_pairs *out)
{
	int32_t touched = cni_min_i(sweep->moved_count, sweep->tile_count);
	pair_pass pass;
	memset(&pass, 0, sizeof(pass));
	pass.sweep = sweep;
	pass.filter = filter;
	pass.filter_context = filter_context;
	pass.out = out;
	pass.find_new = find_new_choose();
	pass.touched = (int32_t *)cni_arena_push(sweep->context.arena, sizeof(int32_t) * (uint64_t)touched);
	count_moved(&pass);
	choose_dense(&pass);
	sweep_dense(&pass);
	search_entries(&pass);
	search_all_loose(&pass);
	clear_marks(&pass);
	(void)cni_arena_pop(sweep->context.arena, pass.scratch);
	(void)cni_arena_pop(sweep->context.arena, pass.touched);
}
