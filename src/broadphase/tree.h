/*
 * broadphase/tree.h - a dynamic AABB tree: finds the boxes that overlap a box, a ray, or each other.
 *
 * A pure data structure without physics. Items are small integers chosen by the owner; the owner pads the boxes.
 * Two owners: the tree broadphase (broadphase/broadphase_tree.c) and cn_tree_* (query/tree.c).
 *
 * A node has two sides; each side holds an item or another node. The node stores the boxes of both sides, so that a
 * search tests two children with one memory access. A place is one side of one node:
 *
 *   place = 2 * node + side           node 0 is the stem: its side 0 is place 0, the root
 *
 *   node 0  [ box of everything | 2 ]-+       child >= 0: a node, < 0: ~item
 *                                     |
 *   node 2  [ box | ~7 ][ box | 5 ]---+--+    places[item] is the place that holds the item
 *                                        |
 *   node 5  [ box | ~3 ][ box | ~0 ]-----+    n items need n nodes: n - 1 and the stem
 *
 * A place carries the union of the marks of all items below it. The owner marks every item either MOVED or RESTS; pairs
 * are searched for MOVED items. STALE: the item has a new box, and its place has not been reconsidered yet. FAR (with
 * STALE): the item will be removed and inserted again.
 *
 * Invariants: a place's box contains all boxes below it, and is their union where none is STALE. The heights of a node's
 * two sides differ by at most CNI_TREE_LEAN, so that the height for n items is below 2.5 log2(n) + 2. A search that pushes
 * both sides of a node has at most one entry more than the height on its stack: CNI_TREE_STACK is enough for 2^30 nodes,
 * more than places can number.
 *
 * Methods: see tree.c. Only reserve allocates.
 */
#ifndef CNI_BROADPHASE_TREE_H
#define CNI_BROADPHASE_TREE_H

#include "base/maths.h"
#include "base/table.h"

#define CNI_TREE_ROOT 0          /* place */
#define CNI_TREE_EMPTY INT32_MIN /* child of a place where nothing hangs */
#define CNI_TREE_LEAN 4
#define CNI_TREE_STACK 80

enum {
	CNI_TREE_MOVED = 1u << 0,
	CNI_TREE_RESTS = 1u << 1,
	CNI_TREE_STALE = 1u << 2,
	CNI_TREE_FAR = 1u << 3
};

typedef struct cni_tree_node {
	cni_aabb box[2];
	int32_t child[2];
	int32_t parent;    /* the place that holds this node; in a free node the next free node */
	uint8_t height[2]; /* of each child: 0 for an item */
	uint8_t marks[2];
} cni_tree_node;

typedef struct cni_tree {
	cni_array nodes;    /* cni_tree_node; count: ever used */
	cni_array places;   /* int32_t by item, CNI_NONE when the item is not in the tree */
	int32_t node_free;  /* first of the free nodes, or CNI_NONE; the members from here on are saved as one */
	int32_t count;      /* items */
	int32_t stale;      /* items with STALE */
	uint32_t random;    /* state of a linear congruential generator */
	int32_t waited;     /* settles of many items since the last rebuild */
	int32_t patience;   /* ... that must pass before the next rebuild */
	int32_t built;      /* items at the last rebuild */
	float cost;         /* cni_tree_cost after the last rebuild */
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
/* Guarantees that any item below `items` can be inserted; 0 when there is no memory. exact: reserves no spare capacity. */
int32_t cni_tree_reserve(cni_tree *tree, cni_memory *memory, int32_t items, int32_t exact);

/* ---- changes: O(log n), cannot fail. An invalid box (NaN, swapped corners) overlaps nothing. */

void cni_tree_insert(cni_tree *tree, int32_t item, const cni_aabb *box);
void cni_tree_remove(cni_tree *tree, int32_t item);
/* Removes the item and inserts it with the new box. */
void cni_tree_move(cni_tree *tree, int32_t item, const cni_aabb *box);
/* Sets the box at the item's present place: searches are correct at once and fast again after cni_tree_settle. */
void cni_tree_set_box(cni_tree *tree, int32_t item, const cni_aabb *box);
/* Marks the item MOVED. */
void cni_tree_mark_moved(cni_tree *tree, int32_t item);

/* Reconsiders the places of all STALE items. With scratch of cni_tree_scratch_bytes it rebuilds a tree that has doubled in
   size, or whose cost has grown while many items moved; with NULL it never rebuilds. */
void cni_tree_settle(cni_tree *tree, void *scratch);
uint64_t cni_tree_scratch_bytes(const cni_tree *tree);
/* 1 when cni_tree_settle could use scratch. */
int32_t cni_tree_wants_scratch(const cni_tree *tree);
/* Builds the tree from the items and their boxes alone. */
void cni_tree_rebuild(cni_tree *tree, void *scratch);
/* Sum of the nodes' perimeters over the sum of the items' perimeters, a measure of the cost of searches. O(n). */
float cni_tree_cost(const cni_tree *tree);

/* ---- searches */

/* Returns the new limit: for rays a fraction, at most the given one. 0 stops queries and rays. */
typedef float cni_tree_visit_fn(void *context, int32_t item, float limit);
typedef void cni_tree_item_fn(void *context, int32_t item);
typedef void cni_tree_pair_fn(void *context, int32_t item_a, int32_t item_b);

/* Items whose boxes overlap the box, each once. */
void cni_tree_query(const cni_tree *tree, const cni_aabb *box, cni_tree_visit_fn *visit, void *context);
/* Items whose boxes the segment from origin by translation * limit crosses, roughly nearest first; limit starts at 1.
   Rounding errs towards a hit. */
void cni_tree_ray(const cni_tree *tree, cni_vec2 origin, cni_vec2 translation, cni_tree_visit_fn *visit, void *context);
/* Pairs of items with overlapping boxes and at least one MOVED item, each once. */
void cni_tree_pairs(const cni_tree *tree, cni_tree_pair_fn *found, void *context);
/* Marks every MOVED item RESTS and visits it; the visitor may not change the tree. */
void cni_tree_unmark_moved(cni_tree *tree, cni_tree_item_fn *visit, void *context);

/* 1 when every invariant holds. O(n). */
int32_t cni_tree_validate(const cni_tree *tree);

/* ---- parts, for the files of the tree only */

/* An eighth of the perimeter. In two dimensions the chance that a random line crosses a convex shape is proportional to
   its perimeter (Crofton, 1868), as it is to the surface in three. The factor 1/8 keeps the cost of finite boxes finite. */
static inline float cni_tree_size(const cni_aabb *box)
{
	return (0.25f * box->x1 - 0.25f * box->x0) + (0.25f * box->y1 - 0.25f * box->y0);
}

static inline float cni_tree_size_with(const cni_aabb *a, const cni_aabb *b)
{
	cni_aabb u = cni_aabb_union(a, b);
	return cni_tree_size(&u);
}

static inline int32_t cni_tree_is_node(int32_t child) { return child >= 0; }
static inline int32_t cni_tree_node_height(const cni_tree_node *node)
{
	return 1 + (node->height[0] > node->height[1] ? node->height[0] : node->height[1]);
}

/* Stores a child at a place and the place with the child; the caller sets box, height and marks. */
void cni_tree_attach(cni_tree *tree, int32_t place, int32_t child);
/* An item with its box and marks. */
void cni_tree_attach_item(cni_tree *tree, int32_t place, int32_t item, const cni_aabb *box, uint32_t marks);
/* Takes a node from the free list or the reserved capacity; cannot fail after reserve. */
int32_t cni_tree_node_take(cni_tree *tree);
/* Empties both sides. */
void cni_tree_node_clear(cni_tree *tree, int32_t node);
/* Recomputes box, height and marks of the place that holds the node; 1 when any of them changed. */
int32_t cni_tree_refresh(cni_tree *tree, int32_t node);
/* As cni_tree_insert, with MOVED or RESTS. */
void cni_tree_insert_marked(cni_tree *tree, int32_t item, const cni_aabb *box, uint32_t marks);
/* Rotates the children of a node where that shrinks boxes or restores the balance. The node's box does not change; its
   height differs afterwards by at most one from the height stored at its place. */
void cni_tree_rotate(cni_tree *tree, int32_t node);
/* Rotates and refreshes from a node upwards until a refresh changes nothing. */
void cni_tree_repair(cni_tree *tree, int32_t node);

#endif
