/*
 * broadphase/sweep_pass.h - what a running search for new pairs knows: shared by sweep_pairs.c, which
 * says who searches what, and sweep_search.c, which does it.
 */
#ifndef CNI_BROADPHASE_SWEEP_PASS_H
#define CNI_BROADPHASE_SWEEP_PASS_H

#include "broadphase/sweep.h"

typedef struct cni_sweep_pass {
	cni_sweep *sweep;
	cni_pair_filter_fn *filter;
	const void *filter_context;
	cni_broadphase_pairs *out;
	cni_sweep_find_new_fn *find_new;
	int32_t *touched;      /* tiles with moved proxies, the dense ones first; NULL without scratch */
	int32_t touched_count;
	int32_t dense_count;
	int32_t single_count;  /* moved entries of tiles that are not dense */
	int32_t dense_entries; /* room of the dense tiles whose old boxes are gathered */
	int32_t new_entries;   /* of the largest dense tile whose entries are all new */
	int32_t slot_room;     /* of slots */
	int32_t slot_count;    /* pairs found, of which no more are written than there is room for */
	int32_t reserved;
	float *scratch;        /* +inf and -inf for new entries (2 new_entries), then old boxes of the other dense tiles */
	cni_pair *slots;       /* where pairs go; NULL: to the list. A worker has a pass of its own with these */
} cni_sweep_pass;

static inline int32_t cni_sweep_is_moved(const cni_sweep_pass *pass, int32_t id) { return cni_bit_get(cni_sweep_moved(pass->sweep), id); }

static inline float *cni_sweep_old_boxes(const cni_sweep_pass *pass, const cni_sweep_tile *tile)
{
	return pass->scratch + 2 * pass->new_entries + tile->previous;
}

/* The widest that the processor has. */
cni_sweep_find_new_fn *cni_sweep_find_new_choose(void);
/* Lists a pair. One of the two moved: should the pair be lost, that one looks again. */
void cni_sweep_pair_list(const cni_sweep_pass *pass, int32_t a, int32_t b);
/* A dense tile with itself and with others, a moved entry with all tiles, loose proxies with everything. */
void cni_sweep_search_tile(cni_sweep_pass *pass, int32_t tile);
void cni_sweep_search_entry(cni_sweep_pass *pass, int32_t id);
void cni_sweep_search_loose(cni_sweep_pass *pass);

#endif
