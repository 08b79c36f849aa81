/*
 * broadphase/pair_list.h - the list of new pairs that every broadphase fills: room, losses, order.
 */
#ifndef CNI_BROADPHASE_PAIR_LIST_H
#define CNI_BROADPHASE_PAIR_LIST_H

#include "broadphase/broadphase.h"

/* An empty list, of which nothing was asked. */
void cni_pairs_begin(cni_broadphase_pairs *pairs);
/* Appends the pair. Without memory it is counted as lost, and looks (a moved proxy of it) is flagged to look again. */
void cni_pairs_add(cni_broadphase_pairs *pairs, cni_memory *memory, int32_t a, int32_t b, cni_proxy *looks);
/* By (a, b). */
void cni_pairs_sort(cni_broadphase_pairs *pairs, cni_arena *arena);

/* A box that overlaps nothing, whatever the order of its tests. */
static inline cni_aabb cni_no_box(void)
{
	cni_aabb box;
	box.x0 = box.y0 = INFINITY;
	box.x1 = box.y1 = -INFINITY;
	return box;
}

#endif
