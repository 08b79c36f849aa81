/*
 * broadphase/pair_list.h - the list of new pairs that every broadphase fills: growth, lost pairs, crowds, sorting.
 *
 * A search that finds more pairs than the limit has met a crowd and ends early. A second search counts each proxy's pairs, with
 * fixed and with other proxies apart; a third one makes the list. Each pair has a random number in [0, 1), a hash of its proxies
 * and the seed. Each proxy has a threshold 2^-k with the least k by which a right shift of its count gives CNI_CROWD_DEGREE at
 * most. A pair is listed when its number is below the threshold of one of its proxies. So bodies outside of the crowd miss no
 * pair, and proxies in the crowd have some eight to sixteen. For a pair with a fixed proxy, the other one's count of fixed
 * proxies decides, and a proxy keeps all of up to CNI_CROWD_DEGREE_FIXED: a crowd neither falls through the ground nor through a
 * crusher, and yet a thousand fixed shapes in the same spot take bounded memory.
 * Counts, numbers and so the list do not depend on the order of searching.
 */
#ifndef CNI_BROADPHASE_PAIR_LIST_H
#define CNI_BROADPHASE_PAIR_LIST_H

#include "broadphase/broadphase.h"

enum {
	CNI_PAIRS_MODE_LIST,    /* all pairs */
	CNI_PAIRS_MODE_STOPPED, /* a crowd: this search need not go on */
	CNI_PAIRS_MODE_COUNT,   /* counts the pairs of each proxy */
	CNI_PAIRS_MODE_THIN     /* lists a share of the pairs of crowded proxies */
};

#define CNI_CROWD_DEGREE 16
#define CNI_CROWD_DEGREE_FIXED 256

/* Empties the list and clears its counters. */
void cni_pairs_begin(cni_broadphase_pairs *pairs, int32_t proxies);
/* After a search: 1 when there must be another one, which the new mode says. ids: all proxies' ids are below. */
int32_t cni_pairs_search_again(cni_broadphase_pairs *pairs, cni_arena *arena, int32_t ids);
/* What a search that found a new pair of boxes asks before the filters, unless the mode is _LIST: 1 when the pair is to be filtered and
   added. Marks a proxy of a pair that is left out. */
int32_t cni_pairs_crowd_takes(cni_broadphase_pairs *pairs, int32_t a, int32_t b, cni_proxy *pa, cni_proxy *pb);
/* Appends the pair. Without memory the pair is counted as lost, and `moved` (a moved proxy of the pair) is flagged
   CNI_PROXY_AGAIN. */
void cni_pairs_add(cni_broadphase_pairs *pairs, cni_memory *memory, int32_t a, int32_t b, cni_proxy *moved);
/* Sorts by (a, b). */
void cni_pairs_sort(cni_broadphase_pairs *pairs, cni_arena *arena);

#endif
