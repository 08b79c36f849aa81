/*
 * broadphase/broadphase.h - the broadphase interface (stage 2 of the step): reports pairs of boxes that began to overlap.
 *
 * A pair is new exactly when its two fat boxes overlap now and did not overlap at the last update (old boxes), or when
 * one of its proxies is new or was passed to touch. All implementations must report the same set. The world owns the
 * proxy table (broadphase/proxy.h). An implementation reads the table, owns the field `cell`, and in update sets `old`
 * and clears CNI_PROXY_MOVED.
 *
 * Failure: no implementation may lose a proxy. reserve fails cleanly (0). add, move and update cannot fail: an
 * implementation without memory for its fast path keeps such proxies in a reserved slow list. When the pair array
 * cannot grow, update keeps the pairs that fit, counts the missing ones in pairs_lost, and marks a moved proxy of each
 * missing pair for a retry (MOVED set, old box empty): the next update reports all pairs of that proxy again.
 *
 * Crowds: n boxes in one spot are n^2 / 2 pairs. If there are more new pairs than CNI_PAIRS_LEAST + CNI_PAIRS_PER_PROXY per
 * proxy, update leaves out pairs of the most crowded proxies, the same ones with any implementation and any number of workers:
 * pair_list.c says which.
 */
#ifndef CNI_BROADPHASE_BROADPHASE_H
#define CNI_BROADPHASE_BROADPHASE_H

#include "base/arena.h"
#include "base/snapshot.h"
#include "base/threads.h"
#include "broadphase/proxy.h"

/* 1 when these two proxies may ever make a contact. Symmetric in a and b, cheap, and callable from several workers at once. */
typedef int32_t cni_pair_filter_fn(const void *context, int32_t proxy_a, int32_t proxy_b);

/* Visitors return the new limit. For rays it is the fraction at which the ray now ends (0 stops); for queries 0 stops and
   any other value continues. */
typedef float cni_query_fn(void *context, int32_t proxy, float limit);

enum {
	CNI_PAIRS_MODE_LIST,    /* all pairs */
	CNI_PAIRS_MODE_STOPPED, /* a crowd: this search need not go on */
	CNI_PAIRS_MODE_COUNT,   /* counts the pairs of each proxy */
	CNI_PAIRS_MODE_THIN     /* lists a share of the pairs of crowded proxies */
};

typedef struct cni_broadphase_pairs {
	cni_array list;        /* cni_pair, sorted by (a, b), each once */
	int32_t pairs_lost;
	int32_t culled;        /* 1: the list has been culled by `wanted`, and only wanted pairs are added */
	int32_t left_out;      /* pairs left out because of a crowd; the filters may refuse some of them */
	int32_t left_out_fixed; /* 1: among them are pairs with a fixed proxy */
	int32_t mode;          /* of the running search: CNI_PAIRS_MODE_ */
	uint32_t seed;         /* set by the caller: another one leaves out other pairs */
	int32_t limit;         /* new pairs beyond which there is a crowd */
	int32_t *degrees;      /* scratch in a crowd: two per proxy id, with other and with fixed proxies: counts, then thresholds */
	/* The caller's filter; NULL wants all pairs. update calls it only when the list is full, so that no memory goes to pairs
	   that the caller would drop; otherwise the caller culls. Called only in the thread that called update. */
	cni_pair_filter_fn *wanted;
	const void *wanted_context;
	/* 1 when nothing moves the proxy's body, as if its mass were infinite; NULL: static proxies. Called only in a crowd, with
	   wanted_context. */
	int32_t (*fixed)(const void *context, int32_t proxy);
} cni_broadphase_pairs;

#define CNI_PAIRS_LEAST 32768
#define CNI_PAIRS_PER_PROXY 16

/* Pairs among n proxies beyond which there is a crowd. */
static inline int32_t cni_pairs_limit(int32_t proxies)
{
	return (int32_t)cni_min_i(proxies, (INT32_MAX - CNI_PAIRS_LEAST) / CNI_PAIRS_PER_PROXY) * CNI_PAIRS_PER_PROXY + CNI_PAIRS_LEAST;
}

/* ---- the list, which every broadphase fills (pair_list.c) */

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
/* Removes unwanted pairs unless that was done before; from then on cni_pairs_add refuses unwanted pairs. */
void cni_pairs_cull(cni_broadphase_pairs *pairs);

/* ---- the interface */

typedef struct cni_broadphase_context {
	cni_memory *memory;    /* for data that lives across steps */
	cni_arena *arena;      /* scratch within update */
	cni_table *proxies;    /* cni_proxy by id */
	cni_team *const *team; /* points to the team that may share update and settle; NULL: the caller works alone */
} cni_broadphase_context;

typedef struct cni_broadphase cni_broadphase; /* each implementation's own state */

typedef struct cni_broadphase_ops {
	/* NULL when there is no memory. capacity: number of proxies to reserve at once, 0 for none. */
	cni_broadphase *(*create)(const cni_broadphase_context *context, int32_t capacity);
	void (*destroy)(cni_broadphase *broadphase);
	/* Guarantees that the next `extra` adds succeed; 0 when there is no memory. The proxy table must have been reserved
	   before: any id below its capacity may then be added. */
	int32_t (*reserve)(cni_broadphase *broadphase, int32_t extra);
	/* The caller has set the proxy's fat box. add empties its old box and sets MOVED. After reserve it cannot fail. */
	void (*add)(cni_broadphase *broadphase, int32_t proxy);
	void (*remove)(cni_broadphase *broadphase, int32_t proxy);
	/* The shape left its fat box, and the caller has set a new one with cni_proxy_set_fat. */
	void (*move)(cni_broadphase *broadphase, int32_t proxy);
	/* All pairs of this proxy count as new at the next update (filter or type changed): sets MOVED and empties old. */
	void (*touch)(cni_broadphase *broadphase, int32_t proxy);
	void (*update)(cni_broadphase *broadphase, cni_pair_filter_fn *filter, const void *filter_context, cni_broadphase_pairs *out);
	/* Brings the structure up to date with moved and added proxies, so that queries need not test those one by one.
	   Optional because update does it anyway; never fails; changes only the order in which queries visit. Worth calling at
	   the end of a step, when all shapes have moved. */
	void (*settle)(cni_broadphase *broadphase);
	/* Every proxy whose fat box overlaps the box, each once. Order is deterministic. */
	void (*query)(const cni_broadphase *broadphase, const cni_aabb *box, cni_query_fn *visit, void *context);
	/* Every proxy whose fat box the segment from origin by translation * fraction crosses, roughly nearest first. */
	void (*ray)(const cni_broadphase *broadphase, cni_vec2 origin, cni_vec2 translation, cni_query_fn *visit, void *context);
	/* Non-empty tiles or nodes, for counters. */
	int32_t (*cells)(const cni_broadphase *broadphase);
	/* Upper bound of the bytes that capacity proxies take, for fixed-memory worlds. */
	uint64_t (*bytes_needed)(int32_t capacity);
	/* Passes the state through a snapshot, after the proxy table. */
	void (*snapshot)(cni_broadphase *broadphase, cni_snapshot *s);
} cni_broadphase_ops;

extern const cni_broadphase_ops cni_broadphase_sweep; /* broadphase/sweep.c */
extern const cni_broadphase_ops cni_broadphase_tree;  /* broadphase/broadphase_tree.c */

/* 1 when the broadphase's own invariants hold. O(n). Not among the operations: programs that do not validate leave it out. */
int32_t cni_broadphase_sweep_holds(const cni_broadphase *broadphase);
int32_t cni_broadphase_tree_holds(const cni_broadphase *broadphase);
static inline int32_t cni_broadphase_holds(const cni_broadphase_ops *ops, const cni_broadphase *broadphase)
{
	if (CNI_HAS_TREE && (!CNI_HAS_SWEEP || ops == &cni_broadphase_tree))
		return cni_broadphase_tree_holds(broadphase);
	return !CNI_HAS_SWEEP || cni_broadphase_sweep_holds(broadphase);
}

#endif
