/*
 * broadphase/tree_settle.c - updates the places of many changed boxes at once (see broadphase/tree.h).
 *
 * Most items keep their place: one pass from the bottom up refits the boxes above them and rotates each node, which
 * follows small motion at a fraction of the cost of insertion (Kopta et al., "Fast, effective BVH updates for animated
 * scenes", 2012). A tree degrades over many steps under rotations alone. While few items move, the pass removes and
 * reinserts those marked FAR: that keeps the cost level, and no step is longer than others. When many items move, a
 * rebuild is cheaper once the cost or the size of the tree has grown: top down, splitting the items at the median of
 * their centres along the longer side (Kay and Kajiya, "Ray tracing complex scenes", 1986).
 */
#include "broadphase/tree.h"

#include <string.h>

/* More than one item in so many is many. */
#define MANY_SHARE 4
/* Built anew when cost is so much above what it was after the last time. */
#define COST_WORSE 1.25f
/* Settles of many to wait after a rebuild that gained nothing. */
#define PATIENCE_MOST 64

/* Marks that the owner sets. */
#define OWN_MARKS (CNI_TREE_MOVED | CNI_TREE_RESTS)

typedef struct tree_leaf {
	cni_aabb box;
	int32_t item;
	uint32_t marks;
} tree_leaf;

/* count leaves from first on, to be attached below place. */
typedef struct tree_span {
	int32_t place;
	int32_t first;
	int32_t count;
} tree_span;

/* ---- building ---- */

/* The centre along x or y, finite for finite boxes. */
static inline float leaf_key(const tree_leaf *leaf, int32_t along_y)
{
	return along_y ? 0.5f * leaf->box.y0 + 0.5f * leaf->box.y1 : 0.5f * leaf->box.x0 + 0.5f * leaf->box.x1;
}

static int32_t longer_axis(const tree_leaf *leaves, int32_t count)
{
	float x0 = leaf_key(leaves, 0), y0 = leaf_key(leaves, 1), x1 = x0, y1 = y0;
	for (int32_t k = 1; k < count; ++k) {
		float x = leaf_key(&leaves[k], 0), y = leaf_key(&leaves[k], 1);
		x0 = cni_min(x0, x);
		x1 = cni_max(x1, x);
		y0 = cni_min(y0, y);
		y1 = cni_max(y1, y);
	}
	return 0.5f * y1 - 0.5f * y0 > 0.5f * x1 - 0.5f * x0;
}

static void leaf_swap(tree_leaf *a, tree_leaf *b)
{
	tree_leaf t = *a;
	*a = *b;
	*b = t;
}

/* The median of the first, middle and last key, as pivot. */
static float middle_key(const tree_leaf *leaves, int32_t count, int32_t along_y)
{
	float a = leaf_key(leaves, along_y), b = leaf_key(&leaves[count / 2], along_y), c = leaf_key(&leaves[count - 1], along_y);
	return cni_max(cni_min(a, b), cni_min(cni_max(a, b), c));
}

/* Moves the `half` leaves with the least keys to the front (quickselect: Hoare, "Find", 1961). */
static void split_at(tree_leaf *leaves, int32_t count, int32_t half, int32_t along_y)
{
	int32_t low = 0, high = count - 1;
	while (low < high) {
		float pivot = middle_key(leaves + low, high - low + 1, along_y);
		int32_t i = low, j = high;
		while (i <= j) {
			while (leaf_key(&leaves[i], along_y) < pivot)
				++i;
			while (leaf_key(&leaves[j], along_y) > pivot)
				--j;
			if (i <= j)
				leaf_swap(&leaves[i++], &leaves[j--]);
		}
		if (half <= j)
			high = j;
		else if (half >= i)
			low = i;
		else
			return;
	}
}

static int32_t collect(const cni_tree *tree, tree_leaf *leaves)
{
	const int32_t *places = (const int32_t *)tree->places.data;
	int32_t count = 0;
	for (int32_t item = 0; item < tree->places.count && count < tree->count; ++item) {
		if (places[item] == CNI_NONE)
			continue;
		leaves[count].box = *cni_tree_box(tree, places[item]);
		leaves[count].item = item;
		leaves[count].marks = cni_tree_marks(tree, places[item]) & OWN_MARKS;
		++count;
	}
	return count;
}

/* Takes nodes in depth-first order, so that a search reads memory forwards; ancestors have lower numbers. */
static void build(cni_tree *tree, tree_leaf *leaves, int32_t count)
{
	tree_span stack[64];
	const tree_span whole = { CNI_TREE_ROOT, 0, count };
	int32_t top = 0, node;
	stack[top++] = whole;
	while (top > 0) {
		tree_span span = stack[--top], lower = { 0, span.first, span.count / 2 };
		tree_span upper = { 0, span.first + lower.count, span.count - lower.count };
		if (span.count == 1) {
			cni_tree_attach_item(tree, span.place, leaves[span.first].item, &leaves[span.first].box, leaves[span.first].marks);
			continue;
		}
		split_at(leaves + span.first, span.count, lower.count, longer_axis(leaves + span.first, span.count));
		node = cni_tree_node_take(tree);
		cni_tree_attach(tree, span.place, node);
		lower.place = 2 * node;
		upper.place = 2 * node + 1;
		stack[top++] = upper;
		stack[top++] = lower;
	}
	for (node = tree->nodes.count - 1; node > 0; --node)
		(void)cni_tree_refresh(tree, node);
}

uint64_t cni_tree_scratch_bytes(const cni_tree *tree) { return (uint64_t)tree->count * sizeof(tree_leaf); }

void cni_tree_rebuild(cni_tree *tree, void *scratch)
{
	tree_leaf *leaves = (tree_leaf *)scratch;
	int32_t count = collect(tree, leaves);
	CNI_ASSERT(count == tree->count);
	tree->stale = 0;
	tree->built = count;
	if (count == 0)
		return;
	tree->nodes.count = 1;
	tree->node_free = CNI_NONE;
	build(tree, leaves, count);
}

/* ---- in place ---- */

static void unmark_stale_items(cni_tree *tree, int32_t node)
{
	cni_tree_node *f = cni_tree_node_at(tree, node);
	for (int32_t k = 0; k < 2; ++k)
		if (!cni_tree_is_node(f->child[k]) && (f->marks[k] & CNI_TREE_STALE)) {
			f->marks[k] = (uint8_t)(f->marks[k] & OWN_MARKS);
			--tree->stale;
		}
}

/* Settles a node whose sides are settled. Restores the balance at once, so that one rotation always suffices. */
static void node_settle(cni_tree *tree, int32_t node)
{
	int32_t place = cni_tree_node_at(tree, node)->parent;
	int32_t height = cni_tree_node_of(tree, place)->height[place & 1];
	unmark_stale_items(tree, node);
	cni_tree_rotate(tree, node);
	(void)cni_tree_refresh(tree, node);
	if (cni_tree_node_of(tree, place)->height[place & 1] != height)
		cni_tree_repair(tree, place >> 1);
}

/* Descends to stale items and climbs again, guided by the marks alone because rotations may change the ancestors. */
static void settle_in_place(cni_tree *tree)
{
	int32_t node = 0;
	while (cni_tree_marks(tree, CNI_TREE_ROOT) & CNI_TREE_STALE) {
		const cni_tree_node *f = cni_tree_node_at(tree, node);
		if (cni_tree_is_node(f->child[0]) && (f->marks[0] & CNI_TREE_STALE))
			node = f->child[0];
		else if (cni_tree_is_node(f->child[1]) && (f->marks[1] & CNI_TREE_STALE))
			node = f->child[1];
		else if (node == 0)
			unmark_stale_items(tree, 0);
		else {
			node_settle(tree, node);
			node = cni_tree_node_at(tree, node)->parent >> 1;
		}
	}
}

/* ---- reinsertion ---- */

static int32_t first_far(const cni_tree *tree)
{
	int32_t child = cni_tree_child(tree, CNI_TREE_ROOT);
	while (cni_tree_is_node(child)) {
		const cni_tree_node *f = cni_tree_node_at(tree, child);
		child = f->child[f->marks[0] & CNI_TREE_FAR ? 0 : 1];
	}
	return ~child;
}

/* Removes all FAR items before any is inserted again, because their ancestors' boxes have grown with them and would
   attract other items. The node that a removal frees stores the item until its insertion. */
static int32_t remove_far(cni_tree *tree)
{
	int32_t count = 0;
	while ((cni_tree_marks(tree, CNI_TREE_ROOT) & CNI_TREE_FAR) && tree->count > 1) {
		int32_t item = first_far(tree), place = cni_tree_place(tree, item);
		cni_tree_node leaf = *cni_tree_node_of(tree, place), *freed;
		cni_tree_remove(tree, item);
		freed = cni_tree_node_at(tree, tree->node_free);
		freed->box[0] = leaf.box[place & 1];
		freed->child[0] = ~item;
		freed->marks[0] = (uint8_t)(leaf.marks[place & 1] & OWN_MARKS);
		++count;
	}
	return count;
}

static void insert_removed(cni_tree *tree, int32_t count)
{
	while (count-- > 0) {
		int32_t node = tree->node_free;
		cni_tree_node kept = *cni_tree_node_at(tree, node);
		cni_tree_node_clear(tree, node);
		cni_tree_insert_marked(tree, ~kept.child[0], &kept.box[0], kept.marks[0]);
	}
}

/* ---- refit or rebuild ---- */

float cni_tree_cost(const cni_tree *tree)
{
	float nodes = 0.0f, items = 0.0f;
	for (int32_t place = CNI_TREE_ROOT; place < 2 * tree->nodes.count; ++place) {
		int32_t child = cni_tree_child(tree, place);
		if (cni_tree_is_node(child))
			nodes += cni_tree_size(cni_tree_box(tree, place));
		else if (child != CNI_TREE_EMPTY)
			items += cni_tree_size(cni_tree_box(tree, place));
	}
	return items > 0.0f ? nodes / items : 0.0f;
}

static int32_t many_stale(const cni_tree *tree) { return tree->stale > tree->count / MANY_SHARE; }

/* Insertion one by one gives a good tree scattered over memory: searches are twice as fast after a rebuild. */
static int32_t has_doubled(const cni_tree *tree) { return tree->count > 2 * tree->built; }

int32_t cni_tree_wants_scratch(const cni_tree *tree) { return many_stale(tree) || has_doubled(tree); }

static void rebuild_measured(cni_tree *tree, void *scratch)
{
	cni_tree_rebuild(tree, scratch);
	tree->cost = cni_tree_cost(tree);
	tree->waited = 0;
}

/* Called after many items moved: rebuilds if the cost has grown enough. */
static void rebuild_if_worse(cni_tree *tree, void *scratch)
{
	if (++tree->waited <= tree->patience)
		return;
	float cost = cni_tree_cost(tree);
	if (cost <= COST_WORSE * tree->cost)
		return;
	rebuild_measured(tree, scratch);
	tree->patience = tree->cost < 0.9f * cost ? 0 : cni_min_i(PATIENCE_MOST, 2 * tree->patience + 1);
}

void cni_tree_settle(cni_tree *tree, void *scratch)
{
	int32_t many = scratch != NULL && many_stale(tree), removed;
	if (scratch != NULL && has_doubled(tree)) {
		rebuild_measured(tree, scratch);
		return;
	}
	removed = many ? 0 : remove_far(tree);
	settle_in_place(tree);
	insert_removed(tree, removed);
	if (many)
		rebuild_if_worse(tree, scratch);
}
