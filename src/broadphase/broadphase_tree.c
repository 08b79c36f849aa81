/*
 * broadphase/broadphase_tree.c - the tree broadphase behind broadphase/broadphase.h: one dynamic AABB tree
 * (broadphase/tree.h) of the proxies' fat boxes.
 *
 * Stage 2 of the step. Reads proxies; writes their old boxes and flags, and its tree. Invariants: the tree holds the fat
 * box of every proxy; a proxy that is not moved has old = fat and no MOVED mark in the tree.
 *
 * Static and dynamic proxies share the tree: its marks keep unmoved proxies out of the pair search, which is all that a
 * separate static tree would save. reserve takes all memory, so that no proxy ever waits for it.
 */
#include "broadphase/broadphase.h"
#include "broadphase/tree.h"

#include <string.h>

typedef struct tree_broadphase {
	cni_broadphase_context context;
	cni_tree tree;
} tree_broadphase;

static inline tree_broadphase *tree_of(cni_broadphase *broadphase) { return (tree_broadphase *)(void *)broadphase; }
static inline const tree_broadphase *const_tree_of(const cni_broadphase *broadphase) { return (const tree_broadphase *)(const void *)broadphase; }
static inline cni_proxy *proxy_at(const tree_broadphase *b, int32_t id) { return (cni_proxy *)cni_table_at(b->context.proxies, id); }

/* ---- memory ---- */

/* The proxy table grows by pages (model/world.h), so reservations are rounded up to whole ones. */
#ifdef CN_SMALL_BLOCKS
#define PAGE 4
#else
#define PAGE 64
#endif
static int32_t whole_pages(int32_t proxies) { return proxies < INT32_MAX - PAGE + 1 ? (proxies + PAGE - 1) & ~(PAGE - 1) : proxies; }

static int32_t tree_reserve(cni_broadphase *broadphase, int32_t extra)
{
	tree_broadphase *b = tree_of(broadphase);
	int32_t ids = cni_max_i(cni_table_capacity(b->context.proxies), b->tree.count + extra);
	return cni_tree_reserve(&b->tree, b->context.memory, ids, 0);
}

static void tree_destroy(cni_broadphase *broadphase)
{
	tree_broadphase *b = tree_of(broadphase);
	cni_memory *memory = b->context.memory;
	cni_tree_deinit(&b->tree, memory);
	cni_memory_free(memory, b, sizeof *b);
}

static cni_broadphase *tree_create(const cni_broadphase_context *context, int32_t capacity)
{
	tree_broadphase *b = (tree_broadphase *)cni_memory_alloc(context->memory, sizeof *b);
	if (b == NULL)
		return NULL;
	b->context = *context;
	cni_tree_init(&b->tree);
	if (!cni_tree_reserve(&b->tree, context->memory, whole_pages(capacity), 1)) {
		tree_destroy((cni_broadphase *)(void *)b);
		return NULL;
	}
	return (cni_broadphase *)(void *)b;
}

/* ---- proxies ---- */

static void mark_moved(tree_broadphase *b, int32_t id)
{
	proxy_at(b, id)->flags |= CNI_PROXY_MOVED;
	cni_tree_mark_moved(&b->tree, id);
}

static void tree_add(cni_broadphase *broadphase, int32_t id)
{
	tree_broadphase *b = tree_of(broadphase);
	cni_proxy *proxy = proxy_at(b, id);
	proxy->cell = CNI_NONE;
	proxy->old = cni_no_box();
	cni_tree_insert(&b->tree, id, &proxy->fat);
	mark_moved(b, id);
}

static void tree_remove(cni_broadphase *broadphase, int32_t id)
{
	tree_broadphase *b = tree_of(broadphase);
	cni_tree_remove(&b->tree, id);
	proxy_at(b, id)->flags &= ~(uint32_t)CNI_PROXY_MOVED;
}

static void tree_move(cni_broadphase *broadphase, int32_t id)
{
	tree_broadphase *b = tree_of(broadphase);
	cni_tree_set_box(&b->tree, id, &proxy_at(b, id)->fat);
	cni_tree_mark_moved(&b->tree, id);
}

static void tree_touch(cni_broadphase *broadphase, int32_t id)
{
	tree_broadphase *b = tree_of(broadphase);
	mark_moved(b, id);
	proxy_at(b, id)->old = cni_no_box();
}

/* ---- update ---- */

static void tree_settle(cni_broadphase *broadphase)
{
	tree_broadphase *b = tree_of(broadphase);
	void *scratch = NULL;
	int32_t wants_scratch = cni_tree_wants_scratch(&b->tree);
	if (b->tree.stale == 0 && !wants_scratch)
		return;
	if (wants_scratch)
		scratch = cni_arena_push(b->context.arena, cni_tree_scratch_bytes(&b->tree));
	cni_tree_settle(&b->tree, scratch);
	(void)cni_arena_pop(b->context.arena, scratch);
}

typedef struct pair_pass {
	const tree_broadphase *broadphase;
	cni_pair_filter_fn *filter;
	const void *filter_context;
	cni_broadphase_pairs *out;
} pair_pass;

static void pair_found(void *context, int32_t id_a, int32_t id_b)
{
	const pair_pass *pass = (const pair_pass *)context;
	cni_proxy *a = proxy_at(pass->broadphase, id_a), *b = proxy_at(pass->broadphase, id_b);
	if (cni_aabb_overlap(&a->old, &b->old))
		return;
	if (pass->out->mode != CNI_PAIRS_MODE_LIST && !cni_pairs_crowd_takes(pass->out, id_a, id_b, a, b))
		return;
	if ((a->flags & b->flags & CNI_PROXY_STATIC) || !pass->filter(pass->filter_context, id_a, id_b))
		return;
	cni_pairs_add(pass->out, pass->broadphase->context.memory, id_a, id_b, a->flags & CNI_PROXY_MOVED ? a : b);
}

/* The present box becomes the old box. */
static void proxy_finish(void *context, int32_t id)
{
	cni_proxy *proxy = proxy_at((const tree_broadphase *)context, id);
	proxy->old = proxy->fat;
	proxy->flags &= ~(uint32_t)CNI_PROXY_MOVED;
}

/* Marks proxies that lost a pair as moved, with an empty old box. Rare, so a scan over all proxies is acceptable. */
static void retry_lost(tree_broadphase *b)
{
	for (int32_t id = 0; id < b->tree.places.count; ++id) {
		if (cni_tree_place(&b->tree, id) == CNI_NONE || !(proxy_at(b, id)->flags & CNI_PROXY_AGAIN))
			continue;
		proxy_at(b, id)->flags &= ~(uint32_t)CNI_PROXY_AGAIN;
		proxy_at(b, id)->old = cni_no_box();
		mark_moved(b, id);
	}
}

static void tree_update(cni_broadphase *broadphase, cni_pair_filter_fn *filter, const void *filter_context, cni_broadphase_pairs *out)
{
	tree_broadphase *b = tree_of(broadphase);
	pair_pass pass = { b, filter, filter_context, out };
	cni_pairs_begin(out, b->tree.count);
	tree_settle(broadphase);
	do {
		cni_tree_pairs(&b->tree, pair_found, &pass);
	} while (cni_pairs_search_again(out, b->context.arena, b->tree.places.count));
	cni_tree_unmark_moved(&b->tree, proxy_finish, b);
	if (out->pairs_lost > 0)
		retry_lost(b);
	cni_pairs_sort(out, b->context.arena);
}

/* ---- queries ---- */

static void tree_query(const cni_broadphase *broadphase, const cni_aabb *box, cni_query_fn *visit, void *context)
{
	cni_tree_query(&const_tree_of(broadphase)->tree, box, visit, context);
}

static void tree_ray(const cni_broadphase *broadphase, cni_vec2 origin, cni_vec2 translation, cni_query_fn *visit, void *context)
{
	cni_tree_ray(&const_tree_of(broadphase)->tree, origin, translation, visit, context);
}

/* ---- figures and checks ---- */

static int32_t tree_cells(const cni_broadphase *broadphase)
{
	int32_t count = const_tree_of(broadphase)->tree.count;
	return count > 0 ? 2 * count - 1 : 0;
}

static uint64_t tree_bytes_needed(int32_t capacity)
{
	uint64_t proxies = (uint64_t)whole_pages(capacity);
	return cni_memory_rounded(sizeof(tree_broadphase)) + cni_memory_rounded(proxies * sizeof(cni_tree_node)) +
	       cni_memory_rounded(proxies * sizeof(int32_t));
}

int32_t cni_broadphase_tree_holds(const cni_broadphase *broadphase)
{
	const tree_broadphase *b = const_tree_of(broadphase);
	for (int32_t id = 0; id < b->tree.places.count; ++id) {
		int32_t place = cni_tree_place(&b->tree, id);
		if (place == CNI_NONE)
			continue;
		const cni_proxy *proxy = proxy_at(b, id);
		int32_t moved = (proxy->flags & CNI_PROXY_MOVED) != 0;
		if ((proxy->fat.x0 <= proxy->fat.x1 && memcmp(cni_tree_box(&b->tree, place), &proxy->fat, sizeof(cni_aabb)) != 0) || (proxy->flags & CNI_PROXY_AGAIN) ||
		    moved != ((cni_tree_marks(&b->tree, place) & CNI_TREE_MOVED) != 0) ||
		    (!moved && memcmp(&proxy->old, &proxy->fat, sizeof(cni_aabb)) != 0))
			return 0;
	}
	return cni_tree_validate(&b->tree);
}

/* Number of places up to the last item in the tree; the capacity behind it is not saved. */
static int32_t places_used(const cni_tree *tree)
{
	int32_t count = tree->places.count;
	while (count > 0 && cni_tree_place(tree, count - 1) == CNI_NONE)
		--count;
	return count;
}

static void tree_snapshot(cni_broadphase *broadphase, cni_snapshot *s)
{
	cni_tree *tree = &tree_of(broadphase)->tree;
	int32_t places = cni_snapshot_number(s, places_used(tree));
	if (cni_snapshot_reserves(s))
		cni_snapshot_need(s, cni_tree_reserve(tree, s->memory, places, 0));
	cni_snapshot_state(s, tree->places.data, (uint64_t)places * sizeof(int32_t));
	cni_snapshot_array(s, &tree->nodes);
	cni_snapshot_members(s, tree, offsetof(cni_tree, node_free), sizeof *tree);
	for (int32_t k = places; k < tree->places.count && s->mode == CNI_SNAPSHOT_LOAD; ++k)
		((int32_t *)tree->places.data)[k] = CNI_NONE;
}

const cni_broadphase_ops cni_broadphase_tree = {
	tree_create, tree_destroy, tree_reserve, tree_add,   tree_remove,       tree_move, tree_touch, tree_update,
	tree_settle, tree_query,   tree_ray,     tree_cells, tree_bytes_needed, tree_snapshot,
};
