/*
 * broadphase/sweep_search.c - searches for new pairs: in a dense tile, around one moved entry, around loose proxies.
 *
 * Reads proxies, settled tiles and the marks and scratch of the pass; writes only the pass's slots or the pair list.
 * So several workers may search at once, each with its own slots; one thread searches the loose proxies.
 * sweep_pairs.c says which search finds which pair.
 *
 * The inner loop tests CNI_SWEEP_LANES entries at a time: broadphase/sweep_lanes.h.
 */
#define CNI_KERNEL cni_sweep_find_new
#include "broadphase/sweep_lanes.h"

cni_sweep_find_new_fn *cni_sweep_find_new_choose(void)
{
	return CNI_WIDEST(cni_sweep_find_new, cni_sweep_find_new, cni_sweep_find_new_8);
}

/* ---- reporting pairs ---- */

void cni_sweep_pair_list(const cni_sweep_pass *pass, int32_t a, int32_t b)
{
	cni_pairs_add(pass->out, pass->sweep->context.memory, a, b, cni_sweep_proxy(pass->sweep, cni_sweep_is_moved(pass, a) ? a : b));
}

/* The rest of a search is not needed: of a job whose slots are full, which one thread runs again, or in a crowd. */
static inline int32_t search_is_void(const cni_sweep_pass *pass)
{
	return pass->slots != NULL ? pass->slot_count > pass->slot_room : pass->out->mode == CNI_PAIRS_MODE_STOPPED;
}

static void pair_found(cni_sweep_pass *pass, int32_t a, int32_t b)
{
	cni_proxy *pa = cni_sweep_proxy(pass->sweep, a), *pb = cni_sweep_proxy(pass->sweep, b);
	if (pass->out->mode != CNI_PAIRS_MODE_LIST && !cni_pairs_crowd_takes(pass->out, a, b, pa, pb))
		return;
	if ((pa->flags & pb->flags & CNI_PROXY_STATIC) || !pass->filter(pass->filter_context, a, b))
		return;
	if (pass->slots == NULL) {
		cni_sweep_pair_list(pass, a, b);
		return;
	}
	if (pass->slot_count < pass->slot_room) {
		pass->slots[pass->slot_count].a = a;
		pass->slots[pass->slot_count].b = b;
	}
	++pass->slot_count;
}

static void entry_found(cni_sweep_pass *pass, const cni_sweep_probe *q, const cni_sweep_view *view, int32_t k)
{
	int32_t id = view->now.id[k];
	if (id == q->id || (view->skip_moved && cni_sweep_is_moved(pass, id)) || (q->skip_moved && cni_sweep_is_moved(pass, q->id)))
		return;
	pair_found(pass, q->id, id);
}

/* ---- the inner loop ---- */

/* 1 when entry k overlaps now and did not before. Its left side must lie left of the probe's right side. */
static inline int32_t entry_is_new(const cni_sweep_probe *q, const cni_sweep_view *v, int32_t k)
{
	int32_t now = (v->now.x1[k] >= q->now.x0) & (v->now.y0[k] <= q->now.y1) & (v->now.y1[k] >= q->now.y0);
	int32_t old = (v->old.x0[k] <= q->old.x1) & (v->old.x1[k] >= q->old.x0) & (v->old.y0[k] <= q->old.y1) & (v->old.y1[k] >= q->old.y0);
	return now & (old ^ 1);
}

static void scan_lanes(cni_sweep_pass *pass, const cni_sweep_probe *q, const cni_sweep_view *v, int32_t from)
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

/* Tests entries from an index on, until one begins beyond the probe. */
static inline void scan(cni_sweep_pass *pass, const cni_sweep_probe *q, const cni_sweep_view *v, int32_t from)
{
	int32_t k = from;
	if (k >= v->count || !(v->now.x0[k] <= q->now.x1) || search_is_void(pass))
		return;
	if (v->wide) {
		scan_lanes(pass, q, v, k);
		return;
	}
	for (; k < v->count && v->now.x0[k] <= q->now.x1; ++k)
		if (entry_is_new(q, v, k))
			entry_found(pass, q, v, k);
}

/* ---- views and probes ---- */

static cni_sweep_view view_of(const cni_sweep_pass *pass, const cni_sweep_tile *tile)
{
	cni_sweep_rows now = cni_sweep_rows_of(pass->sweep, tile), old = tile->dense ? cni_sweep_old_boxes(pass, tile) : now;
	cni_sweep_view v = { now, old, tile->count, tile->capacity >= CNI_SWEEP_LANES, tile->reach, tile->touched > 0 && !tile->dense };
	return v;
}

static inline cni_sweep_probe probe_of(const cni_sweep_view *v, int32_t i)
{
	cni_sweep_probe q = { cni_sweep_box_at(&v->now, i), cni_sweep_box_at(&v->old, i), v->now.id[i], v->skip_moved };
	return q;
}

/* First entry that may extend to x0. */
static int32_t scan_begin(const cni_sweep_view *v, float x0) { return cni_sweep_entry_from(v->now.x0, v->count, x0 - v->reach); }

/* ---- dense tiles ---- */

static void sweep_self(cni_sweep_pass *pass, const cni_sweep_view *v)
{
	for (int32_t i = 0; i + 1 < v->count; ++i) {
		if (v->now.x0[i + 1] > v->now.x1[i])
			continue;
		cni_sweep_probe q = probe_of(v, i);
		scan(pass, &q, v, i + 1);
	}
}

/* Tests each entry of the outer tile against the entries of the inner tile whose x range may overlap it. */
static void sweep_two(cni_sweep_pass *pass, const cni_sweep_view *outer, const cni_sweep_view *inner, const cni_aabb *inner_bounds)
{
	int32_t low = 0;
	for (int32_t i = 0; i < outer->count && outer->now.x0[i] <= inner_bounds->x1; ++i) {
		float from = outer->now.x0[i] - inner->reach;
		if ((outer->now.x1[i] < inner_bounds->x0) | (outer->now.y1[i] < inner_bounds->y0) | (outer->now.y0[i] > inner_bounds->y1))
			continue;
		while (low < inner->count && inner->now.x0[low] < from)
			++low;
		if (low == inner->count)
			return;
		if (inner->now.x0[low] > outer->now.x1[i])
			continue;
		cni_sweep_probe q = probe_of(outer, i);
		scan(pass, &q, inner, low);
	}
}

/* 1 when the sweep of the dense tile `tile` with `other` belongs to `tile`. */
static int32_t owns(const cni_sweep *sweep, int32_t tile, int32_t other)
{
	const cni_sweep_tile *a = cni_sweep_tile_at(sweep, tile);
	const cni_sweep_tile *b = cni_sweep_tile_at(sweep, other);
	if (!b->dense)
		return 1;
	return a->level != b->level ? a->level < b->level : tile < other;
}

void cni_sweep_search_tile(cni_sweep_pass *pass, int32_t tile)
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
		if (other == tile || !owns(sweep, tile, other))
			continue;
		cni_sweep_view other_view = view_of(pass, b);
		if (b->count < a->count)
			sweep_two(pass, &other_view, &view, &a->bounds);
		else
			sweep_two(pass, &view, &other_view, &b->bounds);
	}
}

/* ---- single entries ---- */

/* Tests a moved entry against a tile that holds other single moved entries. */
static void search_touched(cni_sweep_pass *pass, const cni_sweep_probe *q, const cni_sweep_view *v)
{
	const cni_proxy *proxy = cni_sweep_proxy(pass->sweep, q->id);
	for (int32_t k = scan_begin(v, q->now.x0); k < v->count && v->now.x0[k] <= q->now.x1; ++k) {
		int32_t id = v->now.id[k];
		if (!((v->now.x1[k] >= q->now.x0) & (v->now.y0[k] <= q->now.y1) & (v->now.y1[k] >= q->now.y0)) || id == q->id)
			continue;
		if (cni_sweep_is_moved(pass, id) ? id > q->id && !cni_aabb_overlap(&proxy->old, &cni_sweep_proxy(pass->sweep, id)->old) : entry_is_new(q, v, k))
			pair_found(pass, q->id, id);
	}
}

void cni_sweep_search_entry(cni_sweep_pass *pass, int32_t id)
{
	const cni_sweep *sweep = pass->sweep;
	const cni_proxy *proxy = cni_sweep_proxy(sweep, id);
	cni_sweep_probe q = { proxy->fat, proxy->old, id, 0 };
	cni_sweep_cursor cursor;
	int32_t tile;
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

/* ---- loose proxies, left without memory ---- */

static void loose_candidate(cni_sweep_pass *pass, int32_t id, int32_t other)
{
	const cni_proxy *a = cni_sweep_proxy(pass->sweep, id);
	const cni_proxy *b = cni_sweep_proxy(pass->sweep, other);
	if (!cni_sweep_is_moved(pass, id) && !cni_sweep_is_moved(pass, other))
		return;
	if (cni_aabb_overlap(&a->fat, &b->fat) && !cni_aabb_overlap(&a->old, &b->old))
		pair_found(pass, id, other);
}

static void search_one_loose(cni_sweep_pass *pass, int32_t id, cni_sweep_walk others)
{
	const cni_sweep *sweep = pass->sweep;
	cni_sweep_cursor cursor;
	int32_t tile, other;
	cni_sweep_cursor_start(sweep, &cursor, &cni_sweep_proxy(sweep, id)->fat);
	while ((tile = cni_sweep_cursor_next(sweep, &cursor)) != CNI_NONE) {
		const cni_sweep_tile *t = cni_sweep_tile_at(sweep, tile);
		cni_sweep_rows rows = cni_sweep_rows_of(sweep, t);
		for (int32_t k = 0; k < t->count; ++k)
			loose_candidate(pass, id, rows.id[k]);
	}
	while ((other = cni_sweep_walk_next(&others)) != CNI_NONE)
		loose_candidate(pass, id, other);
}

void cni_sweep_search_loose(cni_sweep_pass *pass)
{
	cni_sweep_walk walk = cni_sweep_walk_bits(pass->sweep, &pass->sweep->loose, pass->sweep->loose_count);
	int32_t id;
	while ((id = cni_sweep_walk_next(&walk)) != CNI_NONE)
		search_one_loose(pass, id, walk);
}
