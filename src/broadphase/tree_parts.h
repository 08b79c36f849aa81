/*
 * broadphase/tree_parts.h - what the files of the tree share, and nobody else: cost, unions, repair.
 *
 *   tree.c          life, insertion by least cost, removal by sibling, rotations, checks
 *   tree_settle.c   many boxes at once: turning, rebuilding
 *   tree_search.c   regions, rays, pairs
 */
#ifndef CNI_BROADPHASE_TREE_PARTS_H
#define CNI_BROADPHASE_TREE_PARTS_H

#include "broadphase/tree.h"

/* An eighth of the perimeter: in two dimensions the chance that a random line crosses a convex shape is as
   its perimeter (Crofton, 1868), as it is the surface in three. An eighth, so that finite boxes have a
   finite cost. */
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

/* Hangs a child at a place and tells it; box, height and marks are the caller's. */
void cni_tree_attach(cni_tree *tree, int32_t place, int32_t child);
/* reserve made sure that there is one. */
int32_t cni_tree_node_take(cni_tree *tree);
/* Nothing hangs on either side. */
void cni_tree_node_clear(cni_tree *tree, int32_t node);
void cni_tree_node_give(cni_tree *tree, int32_t node);
/* Writes box, height and marks of the place that a node hangs at; 1 when any of them changed. */
int32_t cni_tree_refresh(cni_tree *tree, int32_t node);
/* As cni_tree_insert, with MOVED or RESTS. */
void cni_tree_insert_marked(cni_tree *tree, int32_t item, const cni_aabb *box, uint32_t marks);
/* Turns the children of a node if that makes boxes smaller or is needed for balance; its own box does not
   change, its height by one at most from what its place says. */
void cni_tree_turn(cni_tree *tree, int32_t node);
/* Turns and refreshes from a node up to where nothing changes any more. */
void cni_tree_repair(cni_tree *tree, int32_t node);

#endif
