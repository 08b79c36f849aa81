/*
 * collision/manifold_boxes.h - collides many pairs of shapes with two to four corners at once: boxes, triangles, capsules,
 * edges.
 *
 * Most polygons are boxes, and nearly all pairs of boxes take one of two code paths through manifold_faces.c: face on face
 * or corner near corner. So pairs are collected in a batch, and a kernel computes several of them side by side with the
 * same bits as cni_faces_collide. It leaves pairs on other code paths to cni_faces_collide. States:
 *
 *   apart          no point within the margin
 *   point          two corners: one point, if it is within the margin
 *   points         clipped faces: two points, of which those within the margin count
 *   fallback       not computed: edges that hardly overlap, closest features that are not at the two faces
 *
 * Without vectors there is no kernel, and cni_faces_collide computes every pair.
 */
#ifndef CNI_COLLISION_MANIFOLD_BOXES_H
#define CNI_COLLISION_MANIFOLD_BOXES_H

#include "collision/manifold.h"

/* Pairs in a batch: a multiple of every width. */
#ifdef CN_SMALL_BLOCKS /* a batch is on the stack */
#define CNI_BOX_PAIRS 8
#else
#define CNI_BOX_PAIRS 32
#endif

/* States of a pair, see above. */
enum { CNI_BOXES_APART = 0, CNI_BOXES_POINT = 1, CNI_BOXES_POINTS = 2, CNI_BOXES_FALLBACK = 3 };

typedef struct cni_box_point {
	float x[CNI_BOX_PAIRS], y[CNI_BOX_PAIRS];
	float separation[CNI_BOX_PAIRS];
	int32_t id[CNI_BOX_PAIRS];
} cni_box_point;

/* Input and output of a kernel, one column per pair; letters as in cni_manifold_input. */
typedef struct cni_box_batch {
	CNI_ALIGNED(32) float qc[CNI_BOX_PAIRS];
	float qs[CNI_BOX_PAIRS], tx[CNI_BOX_PAIRS], ty[CNI_BOX_PAIRS]; /* b in a */
	float radius_a[CNI_BOX_PAIRS], radius_b[CNI_BOX_PAIRS], margin[CNI_BOX_PAIRS];
	float axis_nx[CNI_BOX_PAIRS], axis_ny[CNI_BOX_PAIRS]; /* the cached face, in its own shape's frame */
	float axis_px[CNI_BOX_PAIRS], axis_py[CNI_BOX_PAIRS];
	int32_t axis[CNI_BOX_PAIRS];                          /* input and output: cni_manifold_cache.axis */
	int32_t count_a[CNI_BOX_PAIRS], count_b[CNI_BOX_PAIRS];
	const float *a[CNI_BOX_PAIRS], *b[CNI_BOX_PAIRS];     /* count points, then count normals */
	/* output */
	int32_t state[CNI_BOX_PAIRS];
	float nx[CNI_BOX_PAIRS], ny[CNI_BOX_PAIRS];
	cni_box_point point[2];
	float slop; /* input */
	int32_t count;
} cni_box_batch;

/* Computes the first `pairs` columns, rounded up to the kernel's width. */
typedef void cni_box_kernel_fn(cni_box_batch *batch, int32_t pairs);
cni_box_kernel_fn cni_box_kernel_4; /* SSE2, NEON, WASM SIMD */
cni_box_kernel_fn cni_box_kernel_8; /* AVX2, chosen at run time */

/* The kernel for the widest vectors that this build and this processor support; NULL: none. */
cni_box_kernel_fn *cni_box_kernel_choose(void);

/* 1 when the pair may go into a batch. Only b can be a chain. */
static inline int32_t cni_boxes_take(const cni_manifold_input *in)
{
	return (uint32_t)in->a->count - 2u <= 2u && (uint32_t)in->b->count - 2u <= 2u && in->b->type != CN_SHAPE_CHAIN;
}

/* Adds such a pair to a batch that is not full; returns its column. */
int32_t cni_boxes_add(cni_box_batch *batch, const cni_manifold_input *in, const cni_manifold_cache *cache);
/* After cni_boxes_run: the pair's manifold, the same as that of cni_manifold_function. */
void cni_boxes_read(const cni_box_batch *batch, int32_t column, const cni_manifold_input *in, cni_manifold_cache *cache, cni_manifold *out);
void cni_boxes_run(cni_box_batch *batch, cni_box_kernel_fn *kernel);

#endif
