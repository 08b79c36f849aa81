/*
 * broadphase/tree_search.c - searches an AABB tree for regions, rays and pairs of moved items (see broadphase/tree.h).
 * Reads only, except that cni_tree_unmark_moved clears marks.
 *
 * The pair search walks from every moved item's place up to the root and searches each sibling subtree: neighbours are
 * near in the tree. Of two moved items the one in the left subtree finds the pair, so that each pair is found once and no
 * subtree of moved items is searched twice for it.
 */
#include "broadphase/proxy.h"
#include "broadphase/tree.h"

/* ---- regions ---- */

void cni_tree_query(const cni_tree *tree, const cni_aabb *box, cni_tree_visit_fn *visit, void *context)
{
	int32_t stack[CNI_TREE_STACK], top = 0;
	if (tree->count > 0 && cni_aabb_overlap(cni_tree_box(tree, CNI_TREE_ROOT), box))
		stack[top++] = cni_tree_child(tree, CNI_TREE_ROOT);
	while (top > 0) {
		int32_t child = stack[--top];
		if (cni_tree_is_node(child)) {
			const cni_tree_node *f = cni_tree_node_at(tree, child);
			if (top + 2 > CNI_TREE_STACK)
				return;
			stack[top] = f->child[1];
			top += cni_aabb_overlap_branchless(&f->box[1], box);
			stack[top] = f->child[0];
			top += cni_aabb_overlap_branchless(&f->box[0], box);
		} else if (visit(context, ~child, 1.0f) == 0.0f) {
			return;
		}
	}
}

/* ---- rays ---- */

/* Twice the projection of the box's centre on the ray's direction. */
static inline float ray_order(const cni_ray *ray, const cni_aabb *b)
{
	return ray->d.x * (b->x0 + b->x1) + ray->d.y * (b->y0 + b->y1);
}

/* Pushes the sides of a node that the ray crosses, the nearer one on top; returns the new top. */
static int32_t ray_push(const cni_tree *tree, const cni_ray *ray, int32_t node, int32_t *stack, int32_t top)
{
	const cni_tree_node *f = cni_tree_node_at(tree, node);
	int32_t near = ray_order(ray, &f->box[1]) < ray_order(ray, &f->box[0]);
	stack[top] = 2 * node + 1 - near;
	top += cni_ray_crosses(ray, &f->box[1 - near]);
	stack[top] = 2 * node + near;
	return top + cni_ray_crosses(ray, &f->box[near]);
}

void cni_tree_ray(const cni_tree *tree, cni_vec2 origin, cni_vec2 translation, cni_tree_visit_fn *visit, void *context)
{
	int32_t stack[CNI_TREE_STACK], top = 0;
	cni_ray ray = cni_ray_make(origin, translation);
	if (tree->count > 0 && cni_ray_crosses(&ray, cni_tree_box(tree, CNI_TREE_ROOT)))
		stack[top++] = CNI_TREE_ROOT;
	while (top > 0 && top + 2 <= CNI_TREE_STACK) {
		int32_t place = stack[--top], child = cni_tree_child(tree, place);
		float limit = ray.limit;
		/* The ray may have become shorter since the push. */
		if (limit < 1.0f && !cni_ray_crosses(&ray, cni_tree_box(tree, place)))
			continue;
		if (cni_tree_is_node(child))
			top = ray_push(tree, &ray, child, stack, top);
		else if (child != CNI_TREE_EMPTY)
			limit = visit(context, ~child, limit);
		if (!(limit > 0.0f))
			return;
		if (limit < ray.limit)
			cni_ray_limit(&ray, limit);
	}
}

/* ---- pairs ---- */

typedef struct pair_search {
	const cni_tree *tree;
	cni_tree_pair_fn *found;
	void *context;
	cni_aabb box;
	int32_t item;
	uint32_t marks; /* places without any of these are skipped */
} pair_search;

static inline int32_t pair_may_be(const pair_search *s, const cni_tree_node *f, int32_t side)
{
	return (f->marks[side] & s->marks) != 0 && cni_aabb_overlap_branchless(&f->box[side], &s->box);
}

/* Reports the items at or below a place that overlap the item. */
static void pairs_below(const pair_search *s, int32_t place)
{
	int32_t stack[CNI_TREE_STACK], top = 0;
	const cni_tree_node *f = cni_tree_node_of(s->tree, place);
	if (pair_may_be(s, f, place & 1))
		stack[top++] = f->child[place & 1];
	while (top > 0) {
		int32_t child = stack[--top];
		if (!cni_tree_is_node(child)) {
			s->found(s->context, s->item, ~child);
			continue;
		}
		f = cni_tree_node_at(s->tree, child);
		for (int32_t k = 1; k >= 0; --k) {
			stack[top] = f->child[k];
			top += pair_may_be(s, f, k);
		}
	}
}

/* Searches the sibling of the item, of its node, and so on up to the root. Of two moved items the left one finds the
   pair, so an item skips moved items in subtrees to its left. */
static void pairs_of(pair_search *s, int32_t place)
{
	s->box = *cni_tree_box(s->tree, place);
	s->item = ~cni_tree_child(s->tree, place);
	for (; place != CNI_TREE_ROOT; place = cni_tree_node_of(s->tree, place)->parent) {
		s->marks = place & 1 ? CNI_TREE_RESTS : CNI_TREE_MOVED | CNI_TREE_RESTS;
		pairs_below(s, place ^ 1);
	}
}

void cni_tree_pairs(const cni_tree *tree, cni_tree_pair_fn *found, void *context)
{
	int32_t stack[CNI_TREE_STACK], top = 0;
	pair_search search = { tree, found, context, cni_no_box(), CNI_NONE, 0 };
	if (tree->count > 1)
		stack[top++] = CNI_TREE_ROOT;
	while (top > 0) {
		int32_t place = stack[--top], child = cni_tree_child(tree, place);
		if (!(cni_tree_marks(tree, place) & CNI_TREE_MOVED))
			continue;
		if (cni_tree_is_node(child)) {
			stack[top++] = 2 * child + 1;
			stack[top++] = 2 * child;
		} else {
			pairs_of(&search, place);
		}
	}
}

void cni_tree_unmark_moved(cni_tree *tree, cni_tree_item_fn *visit, void *context)
{
	int32_t stack[CNI_TREE_STACK], top = 0;
	if (tree->count > 0)
		stack[top++] = CNI_TREE_ROOT;
	while (top > 0) {
		int32_t place = stack[--top], child = cni_tree_child(tree, place);
		cni_tree_node *f = cni_tree_node_of(tree, place);
		if (!(f->marks[place & 1] & CNI_TREE_MOVED))
			continue;
		f->marks[place & 1] = (uint8_t)((f->marks[place & 1] & ~(uint32_t)CNI_TREE_MOVED) | CNI_TREE_RESTS);
		if (cni_tree_is_node(child)) {
			stack[top++] = 2 * child + 1;
			stack[top++] = 2 * child;
		} else {
			visit(context, ~child);
		}
	}
}
