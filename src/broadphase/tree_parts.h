/*
 * broadphase/tree_parts.h - private to the files of the tree: cost, unions, rotations, repair.
 */
#ifndef CNI_BROADPHASE_TREE_PARTS_H
#define CNI_BROADPHASE_TREE_PARTS_H

#include "broadphase/tree.h"

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
