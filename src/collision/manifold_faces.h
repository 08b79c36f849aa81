/*
 * collision/manifold_faces.h - the kernel shared by all pairs whose skeletons have faces: polygons, and
 * segments (capsules, edges, chain edges) as polygons of two vertices and two opposite normals.
 *
 * Internal to geometry/. See manifold_faces.c for the method.
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

/* A convex skeleton: points counter-clockwise, normals[i] of the face points[i] -> points[i + 1]. */
typedef struct cni_faces {
	const cni_vec2 *points;
	const cni_vec2 *normals;
	int32_t count;
	float radius;
} cni_faces;

typedef struct cni_faces_storage {
	cni_vec2 points[CN_POLYGON_MAX_VERTICES];
	cni_vec2 normals[CN_POLYGON_MAX_VERTICES];
} cni_faces_storage;

/* One face of one of the two shapes, and how far the other one's skeleton is in front of it. */
typedef struct cni_axis {
	float separation;
	int32_t edge;
	int32_t of_b;
} cni_axis;

/* What lies beyond an end of a chain's edge, and which normals may act at that end. */
enum {
	CNI_CORNER_OPEN = 0,  /* nothing: any normal that does not come from behind */
	CNI_CORNER_FLAT = 1,  /* straight on or rising (concave): the edge's own normal only */
	CNI_CORNER_CONVEX = 2 /* falling away: normals between the two edges' */
};
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

/* Skeleton of a polygon or a segment in its own frame. */
static inline cni_faces cni_faces_of(const cni_geometry *g)
{
	cni_faces f = { cni_geometry_points(g), cni_geometry_normals(g), g->count, g->radius };
	return f;
}
cni_faces cni_faces_moved(cni_faces f, cni_transform transform, cni_faces_storage *storage);

/* The face of reference that other is farthest in front of (greatest separation). */
float cni_faces_best(const cni_faces *reference, const cni_faces *other, int32_t *out_edge);

/* The manifold along an axis, both skeletons in a's frame. chain: NULL, or the chain edge that b is
   (its face 0 is the solid one's surface). */
void cni_faces_manifold(const cni_faces *a, const cni_faces *b, cni_axis axis, const cni_chain_edge *chain,
	const cni_manifold_input *in, cni_manifold *out);

/* Any two skeletons with faces, with the cached axis. */
void cni_faces_collide(const cni_faces *a, const cni_faces *b_local, const cni_manifold_input *in, cni_manifold_cache *cache, cni_manifold *out);

#endif
