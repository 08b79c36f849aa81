/*
 * collision/manifold_faces.h - the kernel shared by all pairs whose skeletons have faces: polygons, and
 * segments (capsules, edges, chain edges) as polygons of two vertices and two opposite normals.
 *
 * Private to collision/. See manifold_faces.c for the method.
 */
#ifndef CNI_COLLISION_MANIFOLD_FACES_H
#define CNI_COLLISION_MANIFOLD_FACES_H

#include "collision/manifold.h"

/* Lengths below this share of the slop are nothing: axes that are so near to each other are equal,
   skeletons so near to each other touch, contact points so near to each other are one. */
#define CNI_TOUCH_PER_SLOP 0.1f

/* Ends of two edges within this share of the slop of each other count as vertex on vertex in ids,
   so that equal boxes on top of each other keep theirs. */
#define CNI_ALIGNED_PER_SLOP 0.5f

/* Feature numbers in ids. */
#define CNI_FEATURE_EDGE 16

typedef struct cni_faces_storage {
	cni_vec2 points[CN_POLYGON_MAX_VERTICES];
	cni_vec2 normals[CN_POLYGON_MAX_VERTICES];
} cni_faces_storage;

/* One face of one of the two shapes, and the separation of the other shape's skeleton from it. */
typedef struct cni_axis {
	float separation;
	int32_t edge;
	int32_t of_b;
} cni_axis;

/* Kinds of corner at an end of a chain's edge, and the normals that may act there. */
enum {
	CNI_CORNER_OPEN = 0,  /* no neighbour: any normal that does not point to the back */
	CNI_CORNER_FLAT = 1,  /* straight or concave: the edge's own normal only */
	CNI_CORNER_CONVEX = 2 /* convex: normals between those of the two edges */
};
/* Largest cosine towards the back at which an open end still pushes. */
#define CNI_OPEN_BACK_MAX 0.02f
typedef struct cni_chain_edge {
	cni_vec2 points[2];
	cni_vec2 normal;
	int32_t corner[2];
	cni_vec2 ghost[2];           /* the neighbours' far points; not for CNI_CORNER_OPEN */
	cni_vec2 neighbour_normal[2];/* CNI_CORNER_CONVEX only */
} cni_chain_edge;

static inline uint32_t cni_manifold_id(int32_t feature_a, int32_t feature_b)
{
	return ((uint32_t)feature_a + 1u) << 8 | ((uint32_t)feature_b + 1u);
}

/* ---- the functions of the table in manifold_table.c */

/* manifold_round.c */
cni_manifold_fn cni_collide_circle_round; /* circles, capsules, edges */
cni_manifold_fn cni_collide_circle_polygon;
/* manifold_faces.c: polygons, capsules, edges */
cni_manifold_fn cni_collide_polygons;
/* manifold_chain.c */
cni_manifold_fn cni_collide_circle_chain;
cni_manifold_fn cni_collide_faces_chain; /* capsules, polygons */

/* ---- parts of them */

/* The manifold along an axis, both skeletons in a's frame. chain: NULL, or b's chain edge (face 0 of b is its front). */
void cni_faces_manifold(const cni_faces *a, const cni_faces *b, cni_axis axis, const cni_chain_edge *chain,
	const cni_manifold_input *in, cni_manifold *out);

/* The manifold of a circle, shape a, along a direction in a's frame out of the other shape. */
void cni_circle_manifold(const cni_manifold_input *in, cni_vec2 outward, float separation, int32_t feature, cni_manifold *out);

#endif
