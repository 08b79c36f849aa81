/*
 * broadphase/tree.h - a dynamic tree of boxes: which boxes overlap a box, a ray, or each other.
 *
 * Pure structure without physics: items are small integers that the owner chooses, boxes are whatever the
 * owner pads them to. Two owners: the tree broadphase (broadphase/broadphase_tree.c) and cn_tree_* (world/tree.c).
 *
 * A node has two sides, and on each side hangs an item or another node; the node keeps the boxes of both,
 * so that a search tests two children with one piece of memory. Where something hangs is a place:
 *
 *   place = 2 * node + side           node 0 is the stem: side 0 of it is place 0, the root
 *
 *   node 0  [ box of everything | 2 ]-+       child >= 0: a node, < 0: ~item
 *                                     |
 *   node 2  [ box | ~7 ][ box | 5 ]---+--+    places[item] says where an item hangs
 *                                        |
 *   node 5  [ box | ~3 ][ box | ~0 ]-----+    n items need n nodes: n - 1 and the stem
 *
 * A place has a mark when anything below it has. Every item is either MOVED or RESTS, as its owner says: pairs are
 * searched for what MOVED. STALE: the item's box was set, and its place not reconsidered yet. FAR, with STALE:
 * it will be inserted anew.
 *
 * Invariants: a place's box contains everything below (and is its union where nothing is STALE); of the
 * heights of a node's two sides neither exceeds the other by more than CNI_TREE_LEAN, so that the height of
 * n items is below 2.5 log2(n) + 2 and searches need only small fixed stacks.
 *
 * Methods: see tree.c. Nothing here allocates but reserve.
 */
#ifndef CNI_BROADPHASE_TREE_H
#define CNI_BROADPHASE_TREE_H

#include "base/maths.h"
#include "base/snapshot.h"

#define CNI_TREE_ROOT 0          /* place */
#define CNI_TREE_EMPTY INT32_MIN /* child of a place where nothing hangs */
#define CNI_TREE_LEAN 4
#define CNI_TREE_STACK 256

enum {
	CNI_TREE_MOVED = 1u << 0,
	CNI_TREE_RESTS = 1u << 1,
	CNI_TREE_STALE = 1u << 2,
	CNI_TREE_FAR = 1u << 3
};

typedef struct cni_tree_node {
	cni_aabb box[2];
	int32_t child[2];
	int32_t parent;    /* the place this node hangs at; of a free node the next free one */
	uint8_t height[2]; /* of what hangs there: 0 for an item */
	uint8_t marks[2];
} cni_tree_node;

typedef struct cni_tree {
	cni_array nodes;    /* cni_tree_node; count: ever used */
	cni_array places;   /* int32_t by item, CNI_NONE when the item is not in the tree */
	int32_t node_free;  /* first of the free nodes, or CNI_NONE */
	int32_t count;      /* items */
	int32_t stale;      /* items with STALE */
	uint32_t dice;
	int32_t waited;     /* settles of many items since the last rebuild */
	int32_t patience;   /* ... to wait before the next one */
	int32_t built;      /* items at the last rebuild */
	float cost;         /* after it, see cni_tree_cost */
} cni_tree;

static inline cni_tree_node *cni_tree_node_at(const cni_tree *tree, int32_t node) { return (cni_tree_node *)tree->nodes.data + node; }
static inline cni_tree_node *cni_tree_node_of(const cni_tree *tree, int32_t place) { return cni_tree_node_at(tree, place >> 1); }
static inline const cni_aabb *cni_tree_box(const cni_tree *tree, int32_t place) { return &cni_tree_node_of(tree, place)->box[place & 1]; }
static inline int32_t cni_tree_child(const cni_tree *tree, int32_t place) { return cni_tree_node_of(tree, place)->child[place & 1]; }
static inline uint32_t cni_tree_marks(const cni_tree *tree, int32_t place) { return cni_tree_node_of(tree, place)->marks[place & 1]; }
static inline int32_t cni_tree_place(const cni_tree *tree, int32_t item) { return ((const int32_t *)tree->places.data)[item]; }
static inline int32_t cni_tree_height(const cni_tree *tree) { return tree->count > 0 ? cni_tree_node_at(tree, 0)->height[0] : 0; }

void cni_tree_init(cni_tree *tree);
void cni_tree_deinit(cni_tree *tree, cni_memory *memory);
/* Makes any item below items insertable; 0 when there is no memory. exact: no room to grow into. */
int32_t cni_tree_reserve(cni_tree *tree, cni_memory *memory, int32_t items, int32_t exact);
uint64_t cni_tree_bytes(const cni_tree *tree);

/* ---- changes: O(log n), cannot fail. A box that is not one (NaN, corners swapped) overlaps nothing. */

void cni_tree_insert(cni_tree *tree, int32_t item, const cni_aabb *box);
void cni_tree_remove(cni_tree *tree, int32_t item);
/* A new box at once: removed and inserted. */
void cni_tree_move(cni_tree *tree, int32_t item, const cni_aabb *box);
/* A new box where the item hangs: searches are right at once and become fast again with cni_tree_settle. */
void cni_tree_set_box(cni_tree *tree, int32_t item, const cni_aabb *box);
/* Marks the item MOVED. */
void cni_tree_mark_moved(cni_tree *tree, int32_t item);

/* Reconsiders the places of all STALE items. scratch of cni_tree_scratch_bytes lets it build a tree anew that has
   doubled, or in which many moved and which has become bad; NULL does without. */
void cni_tree_settle(cni_tree *tree, void *scratch);
uint64_t cni_tree_scratch_bytes(const cni_tree *tree);
/* 1 when cni_tree_settle could use scratch. */
int32_t cni_tree_wants_scratch(const cni_tree *tree);
/* From nothing but the items and their boxes. */
void cni_tree_rebuild(cni_tree *tree, void *scratch);
/* Half the perimeters of everything but the items themselves, by those of the items: what searches pay. O(n). */
float cni_tree_cost(const cni_tree *tree);

/* All of it through a snapshot. */
void cni_tree_snapshot(cni_tree *tree, cni_snapshot *s);

/* ---- searches */

/* Returns the limit to go on with: for rays a fraction, the given one or less; 0 stops both. */
typedef float cni_tree_visit_fn(void *context, int32_t item, float limit);
typedef void cni_tree_item_fn(void *context, int32_t item);
typedef void cni_tree_pair_fn(void *context, int32_t item_a, int32_t item_b);

/* Items whose boxes overlap the box, each once. */
void cni_tree_query(const cni_tree *tree, const cni_aabb *box, cni_tree_visit_fn *visit, void *context);
/* Items whose boxes the segment from origin by translation * limit crosses, about nearest first; limit is 1
   at first. Rounding errs towards a hit. */
void cni_tree_ray(const cni_tree *tree, cni_vec2 origin, cni_vec2 translation, cni_tree_visit_fn *visit, void *context);
/* Pairs of items whose boxes overlap and one of which at least is MOVED, each once. */
void cni_tree_pairs(const cni_tree *tree, cni_tree_pair_fn *found, void *context);
/* Every MOVED item RESTS now and is visited; the visit may not change the tree. */
void cni_tree_unmark_moved(cni_tree *tree, cni_tree_item_fn *visit, void *context);

/* 1 when every invariant holds. O(n). */
int32_t cni_tree_validate(const cni_tree *tree);

#endif
