/*
 * collision/manifold_batch.h - collides many pairs of polygons, capsules and edges at once.
 *
 * Nearly all such pairs take one of two code paths through manifold_faces.c: face on face or corner near corner. So pairs are
 * collected in a batch, and a kernel computes several of them side by side with the same bits as cni_collide_polygons. It leaves
 * pairs on other code paths to cni_collide_polygons. States:
 *
 *   apart          no point within the margin
 *   point          two corners: one point, if it is within the margin
 *   points         clipped faces: two points, of which those within the margin count
 *   fallback       not computed: edges that hardly overlap, closest features that are not at the two faces
 *
 * Without vectors there is no kernel, and cni_collide_polygons computes every pair.
 */
#ifndef CNI_COLLISION_MANIFOLD_BATCH_H
#define CNI_COLLISION_MANIFOLD_BATCH_H

#include "collision/manifold.h"

/* Pairs in a batch: a multiple of every width. */
#ifdef CN_SMALL_BLOCKS /* without vectors one pair at a time: a batch is on the stack */
#define CNI_BATCH_PAIRS 1
#else
#define CNI_BATCH_PAIRS 32
#endif

/* States of a pair, see above. */
enum { CNI_BATCH_APART = 0, CNI_BATCH_POINT = 1, CNI_BATCH_POINTS = 2, CNI_BATCH_FALLBACK = 3 };

typedef struct cni_batch_point {
	float x[CNI_BATCH_PAIRS], y[CNI_BATCH_PAIRS];
	float separation[CNI_BATCH_PAIRS];
	int32_t id[CNI_BATCH_PAIRS];
} cni_batch_point;

/* Input and output of a kernel, one column per pair; letters as in cni_manifold_input. */
typedef struct cni_manifold_batch {
	CNI_ALIGNED(32) float qc[CNI_BATCH_PAIRS];
	float qs[CNI_BATCH_PAIRS], tx[CNI_BATCH_PAIRS], ty[CNI_BATCH_PAIRS]; /* b in a */
	float radius_a[CNI_BATCH_PAIRS], radius_b[CNI_BATCH_PAIRS], margin[CNI_BATCH_PAIRS];
	float axis_nx[CNI_BATCH_PAIRS], axis_ny[CNI_BATCH_PAIRS]; /* the cached face, in its own shape's frame */
	float axis_px[CNI_BATCH_PAIRS], axis_py[CNI_BATCH_PAIRS];
	int32_t axis[CNI_BATCH_PAIRS];                          /* input and output: cni_manifold_cache.axis */
	int32_t count_a[CNI_BATCH_PAIRS], count_b[CNI_BATCH_PAIRS];
	const float *a[CNI_BATCH_PAIRS], *b[CNI_BATCH_PAIRS];     /* count points, then count normals */
	/* output */
	int32_t state[CNI_BATCH_PAIRS];
	float nx[CNI_BATCH_PAIRS], ny[CNI_BATCH_PAIRS];
	cni_batch_point point[2];
	float slop; /* input */
	int32_t count;
} cni_manifold_batch;

/* Computes the first `pairs` columns, rounded up to the kernel's width. */
typedef void cni_batch_kernel_fn(cni_manifold_batch *batch, int32_t pairs);
cni_batch_kernel_fn cni_batch_kernel_4; /* SSE2, NEON, WASM SIMD */
cni_batch_kernel_fn cni_batch_kernel_8; /* AVX2, chosen at run time */

/* The kernel for the widest vectors that this build and this processor support; NULL: none. */
cni_batch_kernel_fn *cni_batch_kernel_choose(void);

/* 1 when the pair may go into a batch. Only b can be a chain. */
static inline int32_t cni_batch_take(const cni_manifold_input *in)
{
	return in->a->count >= 2 && in->b->count >= 2 && !cni_is_chain(in->b->type);
}

/* Adds such a pair to a batch that is not full; returns its column. */
int32_t cni_batch_add(cni_manifold_batch *batch, const cni_manifold_input *in, const cni_manifold_cache *cache);
/* After cni_batch_run: the pair's manifold, the same as that of cni_manifold_function. */
void cni_batch_read(const cni_manifold_batch *batch, int32_t column, const cni_manifold_input *in, cni_manifold_cache *cache, cni_manifold *out);
void cni_batch_run(cni_manifold_batch *batch, cni_batch_kernel_fn *kernel);

#endif
