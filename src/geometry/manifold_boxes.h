/*
 * geometry/manifold_boxes.h - many pairs of boxes (polygons of four vertices) at once.
 *
 * Most polygons are boxes, and all pairs of them take the same road through manifold_faces.c until the two
 * faces do not lie on each other. So pairs are collected in a batch, and a kernel does several of them side
 * by side. It gives the bits of cni_collide_polygons; pairs that leave the road it hands back undone.
 *
 *   apart          nothing within the margin
 *   manifold       one or two points of clipped faces
 *   left           corners, edges that hardly overlap: for cni_collide_polygons
 *
 * Without vectors there is no kernel, and every pair goes the other way.
 */
#ifndef CNI_GEOMETRY_MANIFOLD_BOXES_H
#define CNI_GEOMETRY_MANIFOLD_BOXES_H

#include "geometry/manifold.h"

/* Pairs in a batch: a multiple of every width. */
#define CNI_BOX_PAIRS 32

enum { CNI_BOXES_APART = 0, CNI_BOXES_MANIFOLD = 1, CNI_BOXES_LEFT = 2 };

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
	const float *a[CNI_BOX_PAIRS], *b[CNI_BOX_PAIRS];     /* four points, four normals */
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

static inline int32_t cni_geometry_is_box(const cni_geometry *g) { return g->type == CN_SHAPE_POLYGON && g->count == 4; }

/* Takes a pair of boxes into a batch that is not full; returns its column. */
int32_t cni_boxes_add(cni_box_batch *batch, const cni_manifold_input *in, const cni_manifold_cache *cache);
/* After cni_boxes_run: the pair's manifold, the same as that of cni_collide_polygons. */
void cni_boxes_read(const cni_box_batch *batch, int32_t column, const cni_manifold_input *in, cni_manifold_cache *cache, cni_manifold *out);
void cni_boxes_run(cni_box_batch *batch, cni_box_kernel_fn *kernel);

#endif
