/*
 * collision/manifold_boxes.h - many pairs of boxes at once, and of all else that has two to four corners: triangles,
 * capsules, edges.
 *
 * Most polygons are boxes, and nearly all pairs of them take one of two roads through manifold_faces.c: face on
 * face or corner near corner. So pairs are collected in a batch, and a kernel does several of them side by side. It
 * gives the bits of cni_faces_collide; pairs that leave the roads it hands back undone.
 *
 *   apart          nothing within the margin
 *   point          two corners: one point if it is within the margin
 *   points         clipped faces: those of two points that are within the margin
 *   left           edges that hardly overlap, closest features that are not where the faces are
 *
 * Without vectors there is no kernel, and every pair goes the other way.
 */
#ifndef CNI_COLLISION_MANIFOLD_BOXES_H
#define CNI_COLLISION_MANIFOLD_BOXES_H

#include "collision/manifold.h"

/* Pairs in a batch: a multiple of every width. */
#define CNI_BOX_PAIRS 32

/* States of a pair: how many points there are to read, or none. */
enum { CNI_BOXES_APART = 0, CNI_BOXES_POINT = 1, CNI_BOXES_POINTS = 2, CNI_BOXES_LEFT = 3 };

typedef struct cni_box_point {
	float x[CNI_BOX_PAIRS], y[CNI_BOX_PAIRS];
	float separation[CNI_BOX_PAIRS];
	int32_t id[CNI_BOX_PAIRS];
} cni_box_point;

/* What goes in and comes out of a kernel, a column a pair; letters as in cni_manifold_input. */
typedef struct cni_box_batch {
	CNI_ALIGNED(32) float qc[CNI_BOX_PAIRS];
	float qs[CNI_BOX_PAIRS], tx[CNI_BOX_PAIRS], ty[CNI_BOX_PAIRS]; /* b in a */
	float radius_a[CNI_BOX_PAIRS], radius_b[CNI_BOX_PAIRS], margin[CNI_BOX_PAIRS];
	float axis_nx[CNI_BOX_PAIRS], axis_ny[CNI_BOX_PAIRS]; /* the cached face, in its own shape's frame */
	float axis_px[CNI_BOX_PAIRS], axis_py[CNI_BOX_PAIRS];
	int32_t axis[CNI_BOX_PAIRS];                          /* in and out: cni_manifold_cache.axis */
	int32_t count_a[CNI_BOX_PAIRS], count_b[CNI_BOX_PAIRS];
	const float *a[CNI_BOX_PAIRS], *b[CNI_BOX_PAIRS];     /* count points, count normals */
	/* out */
	int32_t state[CNI_BOX_PAIRS];
	float nx[CNI_BOX_PAIRS], ny[CNI_BOX_PAIRS];
	cni_box_point point[2];
	float slop; /* in */
	int32_t count;
} cni_box_batch;

/* Works out the first `pairs` columns, rounded up to the kernel's width. */
typedef void cni_box_kernel_fn(cni_box_batch *batch, int32_t pairs);
cni_box_kernel_fn cni_box_kernel_4; /* SSE2, NEON, WASM SIMD */
cni_box_kernel_fn cni_box_kernel_8; /* AVX2, chosen at run time */

/* The widest that this build and this processor have; NULL: none. */
cni_box_kernel_fn *cni_box_kernel_choose(void);

/* Is it a pair for a batch? Only b can be a chain. */
static inline int32_t cni_boxes_take(const cni_manifold_input *in)
{
	return (uint32_t)in->a->count - 2u <= 2u && (uint32_t)in->b->count - 2u <= 2u && in->b->type != CN_SHAPE_CHAIN;
}

/* Takes such a pair into a batch that is not full; returns its column. */
int32_t cni_boxes_add(cni_box_batch *batch, const cni_manifold_input *in, const cni_manifold_cache *cache);
/* After cni_boxes_run: the pair's manifold, the same as that of cni_manifold_function. */
void cni_boxes_read(const cni_box_batch *batch, int32_t column, const cni_manifold_input *in, cni_manifold_cache *cache, cni_manifold *out);
void cni_boxes_run(cni_box_batch *batch, cni_box_kernel_fn *kernel);

#endif
