/*
 * broadphase/broadphase.h - stage 2, the interface: which pairs of boxes began to overlap.
 *
 * A pair is new exactly when the two fat boxes overlap now and did not at the last update (old boxes),
 * or when one of them is new or was asked to look again. All implementations must report the same set.
 * The proxy table belongs to the world (broadphase/proxy.h); an implementation reads it, owns its cells,
 * and sets old and clears CNI_PROXY_MOVED in update.
 *
 * Failure: nothing here may lose a proxy. reserve fails cleanly (0); add, move and update cannot fail: an
 * implementation that has no memory for its fast path keeps such proxies in a reserved slow list. When the
 * pair array cannot grow, update keeps what fits, marks a moved proxy of every missing pair to look
 * again (moved, old empty: all of its pairs are then reported once more) and counts the pairs in
 * pairs_lost.
 */
#ifndef CNI_BROADPHASE_BROADPHASE_H
#define CNI_BROADPHASE_BROADPHASE_H

#include "base/arena.h"
#include "base/snapshot.h"
#include "base/threads.h"
#include "broadphase/proxy.h"

/* May these two proxies ever make a contact? Both directions give the same answer. Must be cheap, and several workers
   may ask at once. */
typedef int32_t cni_pair_filter_fn(const void *context, int32_t proxy_a, int32_t proxy_b);

/* Query and ray visitors return the new limit: for rays the fraction to go on with (0 stops), for
   queries 0 stops and anything else goes on. */
typedef float cni_query_fn(void *context, int32_t proxy, float limit);

typedef struct cni_broadphase_pairs {
	cni_array list;        /* cni_pair, sorted by (a, b), each once */
	int32_t pairs_lost;
	int32_t asked;         /* 1: only wanted ones are listed */
	/* The caller's, NULL: all are wanted. update asks it when the list is full, so that nothing is lost for pairs that the
	   caller would drop; else it leaves that to the caller. Always asked in the thread that called. */
	cni_pair_filter_fn *wanted;
	const void *wanted_context;
} cni_broadphase_pairs;

/* Leaves out what the caller does not want, where it was not asked yet; from then on nothing else is listed. */
void cni_pairs_cull(cni_broadphase_pairs *pairs);

typedef struct cni_broadphase_context {
	cni_memory *memory;    /* for what lives across steps */
	cni_blocks *blocks;    /* for small pieces that live across steps */
	cni_arena *arena;      /* scratch within update */
	cni_table *proxies;    /* cni_proxy by id */
	cni_team *const *team; /* where the team is kept that may share an update or settling; NULL: the caller works alone */
	float length_unit;
	int32_t reserved;
} cni_broadphase_context;

typedef struct cni_broadphase cni_broadphase; /* each implementation's own state */

typedef struct cni_broadphase_ops {
	/* NULL when there is no memory. capacity: proxies to make room for at once, 0 for none. */
	cni_broadphase *(*create)(const cni_broadphase_context *context, int32_t capacity);
	void (*destroy)(cni_broadphase *broadphase);
	/* Make the next extra adds certain to succeed; 0 when there is no memory. The proxy table must have
	   been reserved before: any id below its capacity may then be added. */
	int32_t (*reserve)(cni_broadphase *broadphase, int32_t extra);
	/* The proxy's fat box is set, its old box empty; flags MOVED is set by add. After reserve it cannot fail. */
	void (*add)(cni_broadphase *broadphase, int32_t proxy);
	void (*remove)(cni_broadphase *broadphase, int32_t proxy);
	/* The shape left its fat box, and cni_proxy_set_fat has given the proxy another. */
	void (*move)(cni_broadphase *broadphase, int32_t proxy);
	/* All pairs of this proxy count as new at the next update (filter or type changed): sets MOVED and empties old. */
	void (*touch)(cni_broadphase *broadphase, int32_t proxy);
	void (*update)(cni_broadphase *broadphase, cni_pair_filter_fn *filter, const void *filter_context, cni_broadphase_pairs *out);
	/* Brings the structure up to date with what moved or was added, so that queries need not look at those
	   one by one. Optional, never fails, and changes nothing but the order in which queries visit: update
	   does it anyway. Worth calling at the end of a step, once all shapes have moved. */
	void (*settle)(cni_broadphase *broadphase);
	/* Every proxy whose fat box overlaps the box, each once. Order is deterministic. */
	void (*query)(const cni_broadphase *broadphase, const cni_aabb *box, cni_query_fn *visit, void *context);
	/* Every proxy whose fat box the segment from origin by translation * fraction crosses, about nearest first. */
	void (*ray)(const cni_broadphase *broadphase, cni_vec2 origin, cni_vec2 translation, cni_query_fn *visit, void *context);
	uint64_t (*bytes)(const cni_broadphase *broadphase);
	/* Non-empty tiles or nodes, for counters. */
	int32_t (*cells)(const cni_broadphase *broadphase);
	/* 1 when its own invariants hold. O(n). */
	int32_t (*validate)(const cni_broadphase *broadphase);
	/* Bytes that capacity proxies may take, for fixed-memory worlds. */
	uint64_t (*bytes_needed)(int32_t capacity);
	/* Its state through a snapshot, after that of the proxies' table. */
	void (*snapshot)(cni_broadphase *broadphase, cni_snapshot *s);
} cni_broadphase_ops;

extern const cni_broadphase_ops cni_broadphase_sweep; /* broadphase/sweep.c */
extern const cni_broadphase_ops cni_broadphase_tree;  /* broadphase/broadphase_tree.c */

#endif
