/*
 * broadphase/tree.c - owns the nodes and places of an AABB tree: memory, insertion, removal, balance, checks.
 * The picture and the invariants are in broadphase/tree.h.
 *
 * Insertion searches for the sibling that adds the least perimeter to the tree, by branch and bound (Bittner, Hapala and
 * Havran, "Fast insertion-based optimization of bounding volume hierarchies", 2013; as an incremental tree: Catto,
 * "Dynamic bounding volume hierarchies", GDC 2019). The cost of a sibling is the perimeter of the new node plus the
 * growth of all nodes above. Removal moves the sibling to the place of their node. On the way up every node may be
 * rotated: one side swaps with a grandchild of the other side where that shrinks the node between (Kopta et al., "Fast,
 * effective BVH updates for animated scenes", 2012). Rotations also keep the balance: items have no order, so the taller
 * grandchild can always move up, and one rotation repairs the imbalance of one insertion or removal (heights after
 * Adelson-Velsky and Landis, 1962, with a wider tolerance).
 */
#include "broadphase/tree.h"

#include <string.h>

/* Forks that a search for a sibling looks at: more than it needs but where everything overlaps. */
#define SIBLING_TRIES 24
/* An item whose old and new box together are so much larger than the node's it hangs at is FAR. */
#define FAR_WAY 1.25f
/* Others are with a chance of one in so many. */
#define FAR_PERIOD 8

/* ---- memory ---- */

static int32_t *places_of(const cni_tree *tree) { return (int32_t *)tree->places.data; }

void cni_tree_init(cni_tree *tree)
{
	memset(tree, 0, sizeof *tree);
	cni_array_init(&tree->nodes, (int32_t)sizeof(cni_tree_node));
	cni_array_init(&tree->places, (int32_t)sizeof(int32_t));
	tree->node_free = CNI_NONE;
}

void cni_tree_deinit(cni_tree *tree, cni_memory *memory)
{
	cni_array_deinit(&tree->nodes, memory);
	cni_array_deinit(&tree->places, memory);
	cni_tree_init(tree);
}

/* An invalid box, such as NaN from a body that diverged, overlaps nothing and must not spoil the boxes above it. */
static cni_aabb box_or_none(const cni_aabb *box)
{
	return box->x0 <= box->x1 && box->y0 <= box->y1 ? *box : cni_no_box();
}

static void place_clear(cni_tree_node *node, int32_t side)
{
	node->box[side] = cni_no_box();
	node->child[side] = CNI_TREE_EMPTY;
	node->height[side] = 0;
	node->marks[side] = 0;
}

int32_t cni_tree_reserve(cni_tree *tree, cni_memory *memory, int32_t items, int32_t exact)
{
	int32_t (*reserve)(cni_array *, cni_memory *, int32_t) = exact ? cni_array_reserve_exact : cni_array_reserve;
	if (!reserve(&tree->nodes, memory, items) || !reserve(&tree->places, memory, items))
		return 0;
	for (int32_t k = tree->places.count; k < tree->places.capacity; ++k)
		places_of(tree)[k] = CNI_NONE;
	tree->places.count = tree->places.capacity;
	if (tree->nodes.count == 0 && tree->nodes.capacity > 0) {
		cni_tree_node_clear(tree, 0);
		cni_tree_node_at(tree, 0)->parent = CNI_NONE;
		tree->nodes.count = 1;
	}
	return 1;
}

int32_t cni_tree_node_take(cni_tree *tree)
{
	int32_t node = tree->node_free;
	if (node == CNI_NONE) {
		CNI_ASSERT(tree->nodes.count < tree->nodes.capacity);
		return tree->nodes.count++;
	}
	tree->node_free = cni_tree_node_at(tree, node)->parent;
	return node;
}

void cni_tree_node_clear(cni_tree *tree, int32_t node)
{
	place_clear(cni_tree_node_at(tree, node), 0);
	place_clear(cni_tree_node_at(tree, node), 1);
}

static void node_give(cni_tree *tree, int32_t node)
{
	cni_tree_node_clear(tree, node);
	cni_tree_node_at(tree, node)->parent = tree->node_free;
	tree->node_free = node;
}

/* ---- places ---- */

void cni_tree_attach(cni_tree *tree, int32_t place, int32_t child)
{
	cni_tree_node_of(tree, place)->child[place & 1] = child;
	if (cni_tree_is_node(child))
		cni_tree_node_at(tree, child)->parent = place;
	else
		places_of(tree)[~child] = place;
}

void cni_tree_attach_item(cni_tree *tree, int32_t place, int32_t item, const cni_aabb *box, uint32_t marks)
{
	cni_tree_node *f = cni_tree_node_of(tree, place);
	f->box[place & 1] = *box;
	f->height[place & 1] = 0;
	f->marks[place & 1] = (uint8_t)marks;
	cni_tree_attach(tree, place, ~item);
}

/* Moves what is on a side of a node, or of a copy of one, to a place. */
static void place_write(cni_tree *tree, int32_t to, const cni_tree_node *f, int32_t side)
{
	cni_tree_node *t = cni_tree_node_of(tree, to);
	t->box[to & 1] = f->box[side];
	t->height[to & 1] = f->height[side];
	t->marks[to & 1] = f->marks[side];
	cni_tree_attach(tree, to, f->child[side]);
}

static void place_swap(cni_tree *tree, int32_t a, int32_t b)
{
	cni_tree_node before = *cni_tree_node_of(tree, a);
	place_write(tree, a, cni_tree_node_of(tree, b), b & 1);
	place_write(tree, b, &before, a & 1);
}

/* Compares as numbers, not bits: a union may yield either zero. */
static int32_t box_equals(const cni_aabb *a, const cni_aabb *b)
{
	return a->x0 == b->x0 && a->y0 == b->y0 && a->x1 == b->x1 && a->y1 == b->y1;
}

int32_t cni_tree_refresh(cni_tree *tree, int32_t node)
{
	const cni_tree_node *f = cni_tree_node_at(tree, node);
	cni_tree_node *above = cni_tree_node_of(tree, f->parent);
	int32_t side = f->parent & 1;
	cni_aabb box = cni_aabb_union(&f->box[0], &f->box[1]);
	int32_t height = cni_tree_node_height(f), marks = f->marks[0] | f->marks[1];
	int32_t changed = !box_equals(&box, &above->box[side]) || height != above->height[side] || marks != above->marks[side];
	above->box[side] = box;
	above->height[side] = (uint8_t)height;
	above->marks[side] = (uint8_t)marks;
	return changed;
}

/* ---- rotations ---- */

typedef struct tree_rotation {
	int32_t down, up; /* places to swap; down is CNI_NONE when there is no rotation */
	float gain;
	int32_t needed;   /* for balance: the first candidate is taken whatever it gains */
} tree_rotation;

static int32_t height_difference(int32_t a, int32_t b) { return a > b ? a - b : b - a; }

/* 1 when the rotation leaves the node and the node below balanced and changes the height by at most one. */
static int32_t rotation_balances(int32_t down, int32_t beside, int32_t up, int32_t height)
{
	int32_t low = 1 + cni_max_i(down, beside);
	return height_difference(down, beside) <= CNI_TREE_LEAN && height_difference(low, up) <= CNI_TREE_LEAN &&
	       height_difference(1 + cni_max_i(low, up), height) <= 1;
}

/* One side of the node moves down beside one grandchild; the other grandchild moves up. Keeps the rotation if it is the
   best so far and keeps the balance. height: the node's height as stored at its place. */
static void rotation_consider(const cni_tree *tree, int32_t node, int32_t side, int32_t height, tree_rotation *best)
{
	const cni_tree_node *f = cni_tree_node_at(tree, node), *g;
	if (!cni_tree_is_node(f->child[1 - side]))
		return;
	g = cni_tree_node_at(tree, f->child[1 - side]);
	for (int32_t k = 0; k < 2; ++k) {
		float gain = cni_tree_size(&f->box[1 - side]) - cni_tree_size_with(&f->box[side], &g->box[1 - k]);
		int32_t wanted = gain > best->gain || (best->needed && best->down == CNI_NONE);
		if (!wanted || !rotation_balances(f->height[side], g->height[1 - k], g->height[k], height))
			continue;
		best->gain = gain;
		best->down = 2 * node + side;
		best->up = 2 * f->child[1 - side] + k;
	}
}

void cni_tree_rotate(cni_tree *tree, int32_t node)
{
	const cni_tree_node *f = cni_tree_node_at(tree, node);
	int32_t height = cni_tree_node_of(tree, f->parent)->height[f->parent & 1];
	tree_rotation best = { CNI_NONE, CNI_NONE, 0.0f, height_difference(f->height[0], f->height[1]) > CNI_TREE_LEAN };
	if (!best.needed || f->height[0] < f->height[1])
		rotation_consider(tree, node, 0, height, &best);
	if (!best.needed || f->height[1] < f->height[0])
		rotation_consider(tree, node, 1, height, &best);
	CNI_ASSERT(!best.needed || best.down != CNI_NONE);
	if (best.down == CNI_NONE)
		return;
	place_swap(tree, best.down, best.up);
	(void)cni_tree_refresh(tree, best.up >> 1);
}

void cni_tree_repair(cni_tree *tree, int32_t node)
{
	while (node != 0) {
		cni_tree_rotate(tree, node);
		if (!cni_tree_refresh(tree, node))
			return;
		node = cni_tree_node_at(tree, node)->parent >> 1;
	}
}

/* ---- insertion ---- */

typedef struct tree_sibling {
	int32_t place;
	float above;   /* growth of the nodes above if the box is inserted below the place */
	float with;    /* size of the union of the place's box and the new box */
} tree_sibling;

typedef struct tree_choice {
	const cni_aabb *box;
	float size;
	float cost;    /* of the best place */
	int32_t place;
	int32_t top;
	tree_sibling stack[CNI_TREE_STACK];
} tree_choice;

/* A place as a sibling; only low ones, because an item weighs against all of it. */
static void sibling_consider(tree_choice *choice, const cni_tree *tree, const tree_sibling *s)
{
	float cost = s->above + s->with;
	if (cni_tree_node_of(tree, s->place)->height[s->place & 1] > CNI_TREE_LEAN)
		return;
	if (choice->place == CNI_NONE || cost < choice->cost) {
		choice->place = s->place;
		choice->cost = cost;
	}
}

static void siblings_push(tree_choice *choice, const cni_tree *tree, int32_t node, float above)
{
	const cni_tree_node *f = cni_tree_node_at(tree, node);
	tree_sibling s[2];
	float growth[2];
	for (int32_t k = 0; k < 2; ++k) {
		s[k].place = 2 * node + k;
		s[k].above = above;
		s[k].with = cni_tree_size_with(&f->box[k], choice->box);
		growth[k] = s[k].with - cni_tree_size(&f->box[k]);
	}
	/* The side to visit first goes on top. */
	int32_t first = growth[1] < growth[0] || (growth[1] == growth[0] && f->height[1] < f->height[0]);
	choice->stack[choice->top++] = s[1 - first];
	choice->stack[choice->top++] = s[first];
}

/* Depth first, smaller growth first. The growth above a place plus the size of the new box bounds every cost below it. */
static int32_t sibling_find(const cni_tree *tree, const cni_aabb *box)
{
	tree_choice choice;
	choice.box = box;
	choice.size = cni_tree_size(box);
	choice.cost = INFINITY;
	choice.place = CNI_NONE;
	choice.top = 1;
	choice.stack[0].place = CNI_TREE_ROOT;
	choice.stack[0].above = 0.0f;
	choice.stack[0].with = cni_tree_size_with(cni_tree_box(tree, CNI_TREE_ROOT), box);
	for (int32_t tries = 0; choice.top > 0 && (tries < SIBLING_TRIES || choice.place == CNI_NONE); ++tries) {
		tree_sibling s = choice.stack[--choice.top];
		float below = s.above + (s.with - cni_tree_size(cni_tree_box(tree, s.place)));
		if (choice.place != CNI_NONE && s.above + choice.size >= choice.cost)
			continue;
		sibling_consider(&choice, tree, &s);
		if (cni_tree_is_node(cni_tree_child(tree, s.place)) && (choice.place == CNI_NONE || below + choice.size < choice.cost))
			siblings_push(&choice, tree, cni_tree_child(tree, s.place), below);
	}
	return choice.place;
}

void cni_tree_insert_marked(cni_tree *tree, int32_t item, const cni_aabb *box, uint32_t marks)
{
	int32_t place = CNI_TREE_ROOT, node;
	cni_aabb clean = box_or_none(box);
	CNI_ASSERT(item >= 0 && item < tree->places.count && cni_tree_place(tree, item) == CNI_NONE);
	if (tree->count++ > 0) {
		place = sibling_find(tree, &clean);
		node = cni_tree_node_take(tree);
		place_write(tree, 2 * node, cni_tree_node_of(tree, place), place & 1);
		/* The place keeps its old height until repair, which compares with it. */
		cni_tree_attach(tree, place, node);
		place = 2 * node + 1;
	}
	cni_tree_attach_item(tree, place, item, &clean, marks);
	cni_tree_repair(tree, place >> 1);
}

void cni_tree_insert(cni_tree *tree, int32_t item, const cni_aabb *box) { cni_tree_insert_marked(tree, item, box, CNI_TREE_RESTS); }

/* ---- removal ---- */

void cni_tree_remove(cni_tree *tree, int32_t item)
{
	int32_t place = cni_tree_place(tree, item), node = place >> 1, above;
	CNI_ASSERT(place != CNI_NONE && cni_tree_child(tree, place) == ~item);
	tree->stale -= (cni_tree_marks(tree, place) & CNI_TREE_STALE) != 0;
	--tree->count;
	places_of(tree)[item] = CNI_NONE;
	if (place == CNI_TREE_ROOT) {
		place_clear(cni_tree_node_at(tree, 0), 0);
		return;
	}
	above = cni_tree_node_at(tree, node)->parent;
	place_write(tree, above, cni_tree_node_at(tree, node), 1 - (place & 1));
	node_give(tree, node);
	cni_tree_repair(tree, above >> 1);
}

void cni_tree_move(cni_tree *tree, int32_t item, const cni_aabb *box)
{
	uint32_t marks = cni_tree_marks(tree, cni_tree_place(tree, item));
	cni_aabb copy = *box;
	cni_tree_remove(tree, item);
	cni_tree_insert_marked(tree, item, &copy, marks & (CNI_TREE_MOVED | CNI_TREE_RESTS));
}

/* ---- boxes and marks in place ---- */

/* Sets the marks of an item and updates its ancestors up to the first that does not change. */
static void change_marks(cni_tree *tree, int32_t place, uint32_t marks)
{
	while (place != CNI_NONE && cni_tree_marks(tree, place) != marks) {
		cni_tree_node *f = cni_tree_node_of(tree, place);
		f->marks[place & 1] = (uint8_t)marks;
		marks = (uint32_t)(f->marks[0] | f->marks[1]);
		place = f->parent;
	}
}

void cni_tree_mark_moved(cni_tree *tree, int32_t item)
{
	int32_t place = cni_tree_place(tree, item);
	change_marks(tree, place, (cni_tree_marks(tree, place) & ~(uint32_t)CNI_TREE_RESTS) | CNI_TREE_MOVED);
}

/* STALE, and FAR if the item needs a new place: when its motion is large against the box of its node, and at random
   otherwise, because a tree degrades slowly under rotations alone. Random (a linear congruential generator), so that no
   regular motion evades it. */
static uint32_t marks_for_move(cni_tree *tree, float room, float way)
{
	tree->random = tree->random * 1664525u + 1013904223u;
	return way > FAR_WAY * room || (tree->random >> 16) % FAR_PERIOD == 0 ? CNI_TREE_STALE | CNI_TREE_FAR : CNI_TREE_STALE;
}

void cni_tree_set_box(cni_tree *tree, int32_t item, const cni_aabb *box)
{
	int32_t place = cni_tree_place(tree, item);
	cni_tree_node *node = cni_tree_node_of(tree, place);
	cni_aabb clean = box_or_none(box);
	float room = cni_tree_size_with(&node->box[0], &node->box[1]), way = cni_tree_size_with(&node->box[place & 1], &clean);
	node->box[place & 1] = clean;
	tree->stale += (node->marks[place & 1] & CNI_TREE_STALE) == 0;
	change_marks(tree, place, node->marks[place & 1] | marks_for_move(tree, room, way));
	for (place = node->parent; place != CNI_NONE && !cni_aabb_contains(cni_tree_box(tree, place), &clean); place = node->parent) {
		node = cni_tree_node_of(tree, place);
		node->box[place & 1] = cni_aabb_union(&node->box[place & 1], &clean);
	}
}

/* ---- checks ---- */

typedef struct tree_census {
	int32_t items, nodes, stale;
} tree_census;

static int32_t box_is_union(const cni_aabb *box, const cni_tree_node *f, int32_t stale)
{
	cni_aabb u = cni_aabb_union(&f->box[0], &f->box[1]);
	return stale ? cni_aabb_contains(box, &u) : box_equals(&u, box);
}

/* Checks the content of a place against the place and counts it in sum. */
static int32_t place_holds(const cni_tree *tree, int32_t place, tree_census *sum)
{
	const cni_tree_node *above = cni_tree_node_of(tree, place), *f;
	int32_t side = place & 1, child = above->child[side];
	uint32_t marks = above->marks[side];
	if (child == CNI_TREE_EMPTY)
		return 0;
	if (!cni_tree_is_node(child)) {
		++sum->items;
		sum->stale += (marks & CNI_TREE_STALE) != 0;
		return above->height[side] == 0 && ~child < tree->places.count && cni_tree_place(tree, ~child) == place &&
		       !(marks & CNI_TREE_MOVED) == ((marks & CNI_TREE_RESTS) != 0);
	}
	++sum->nodes;
	if (child == 0 || child >= tree->nodes.count)
		return 0;
	f = cni_tree_node_at(tree, child);
	return f->parent == place && above->height[side] == cni_tree_node_height(f) && (uint32_t)(f->marks[0] | f->marks[1]) == marks &&
	       box_is_union(&above->box[side], f, (marks & CNI_TREE_STALE) != 0) && height_difference(f->height[0], f->height[1]) <= CNI_TREE_LEAN;
}

static int32_t free_nodes(const cni_tree *tree)
{
	int32_t count = 0;
	for (int32_t node = tree->node_free; node != CNI_NONE && count < tree->nodes.count; node = cni_tree_node_at(tree, node)->parent)
		++count;
	return count;
}

int32_t cni_tree_validate(const cni_tree *tree)
{
	int32_t stack[CNI_TREE_STACK], top = 0;
	tree_census sum = { 0, 0, 0 };
	if (tree->nodes.count == 0)
		return tree->count == 0;
	if (tree->count > 0)
		stack[top++] = CNI_TREE_ROOT;
	while (top > 0) {
		int32_t place = stack[--top];
		if (!place_holds(tree, place, &sum) || sum.items > tree->count || top + 2 > CNI_TREE_STACK)
			return 0;
		if (cni_tree_is_node(cni_tree_child(tree, place))) {
			stack[top++] = 2 * cni_tree_child(tree, place);
			stack[top++] = 2 * cni_tree_child(tree, place) + 1;
		}
	}
	return sum.items == tree->count && sum.stale == tree->stale && 1 + sum.nodes + free_nodes(tree) == tree->nodes.count;
}
