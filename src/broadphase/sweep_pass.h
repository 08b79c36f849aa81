/*
 * broadphase/sweep_pass.h - the state of a running search for new pairs, shared by sweep_pairs.c (plans the searches) and
 * sweep_search.c (runs them).
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
	int32_t dense_entries; /* total capacity of the dense tiles whose old boxes are gathered */
	int32_t new_entries;   /* capacity of the largest dense tile whose entries are all new */
	int32_t slot_room;     /* capacity of slots */
	int32_t slot_count;    /* pairs found; only the first slot_room are written */
	float *scratch;        /* +inf and -inf for new entries (2 new_entries), then old boxes of the other dense tiles */
	cni_pair *slots;       /* destination of pairs, NULL: the list. Each worker uses a copy of the pass with its own slots */
} cni_sweep_pass;

static inline int32_t cni_sweep_is_moved(const cni_sweep_pass *pass, int32_t id) { return cni_bit_get(cni_sweep_moved(pass->sweep), id); }

/* Rows of a dense tile's old boxes: in scratch, or, if all entries are new, empty boxes. */
static inline cni_sweep_rows cni_sweep_old_boxes(const cni_sweep_pass *pass, const cni_sweep_tile *tile)
{
	float *least = pass->scratch, *most = least + pass->new_entries;
	cni_sweep_rows empty = { least, most, least, most, NULL };
	return tile->previous == CNI_NONE ? empty : cni_sweep_rows_at(least + 2 * pass->new_entries + tile->previous, tile->capacity);
}

/* The inner loop for the widest vectors of the processor. */
cni_sweep_find_new_fn *cni_sweep_find_new_choose(void);
/* Adds a pair to the list. If the pair is lost, its moved proxy is flagged CNI_PROXY_AGAIN. */
void cni_sweep_pair_list(const cni_sweep_pass *pass, int32_t a, int32_t b);
/* Searches: a dense tile against itself and other tiles, a moved entry against all tiles, loose proxies against everything. */
void cni_sweep_search_tile(cni_sweep_pass *pass, int32_t tile);
void cni_sweep_search_entry(cni_sweep_pass *pass, int32_t id);
void cni_sweep_search_loose(cni_sweep_pass *pass);

#endif
