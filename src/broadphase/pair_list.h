/*
 * broadphase/pair_list.h - the list of new pairs that every broadphase fills: growth, lost pairs, sorting.
 */
#ifndef CNI_BROADPHASE_PAIR_LIST_H
#define CNI_BROADPHASE_PAIR_LIST_H

#include "broadphase/broadphase.h"

/* Empties the list and clears its counters. */
void cni_pairs_begin(cni_broadphase_pairs *pairs);
/* Appends the pair. Without memory the pair is counted as lost, and `moved` (a moved proxy of the pair) is flagged
   CNI_PROXY_AGAIN. */
void cni_pairs_add(cni_broadphase_pairs *pairs, cni_memory *memory, int32_t a, int32_t b, cni_proxy *moved);
/* Sorts by (a, b). */
void cni_pairs_sort(cni_broadphase_pairs *pairs, cni_arena *arena);

/* A box that overlaps nothing, also not itself. */
static inline cni_aabb cni_no_box(void)
{
	cni_aabb box;
	box.x0 = box.y0 = INFINITY;
	box.x1 = box.y1 = -INFINITY;
	return box;
}

#endif
