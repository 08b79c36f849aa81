/*
 * collision/manifold.h - contact manifolds of two shapes: one pure function per pair of shape types.
 *
 * All computation is in shape a's body frame: b comes with its transform relative to a, so results do not lose digits far
 * from the world's origin. The normal points from a to b. A manifold has one or two points; each lies midway between the
 * two surfaces. Points with a separation above margin are dropped; margin >= 0 is the speculative distance. Two points are
 * ordered and share the normal. Point ids name the features (vertex or edge numbers of both shapes), are nonzero, and stay
 * the same while the same features touch, so that impulses can be matched across steps.
 *
 *   id = (feature of a + 1) << 8 | (feature of b + 1), each feature 0..31: vertex k = k, edge k = 16 + k
 *
 * Rules that keep motion smooth:
 *  - parallel faces give two points; the choice of the reference face prefers the cached one (hysteresis),
 *    so that it does not flip between nearly equal axes;
 *  - exact distance (GJK-like closest features) whenever the skeletons (shapes without radius) are apart
 *    and radius or margin matter: vertex-vertex contact has one point with the true direction;
 *  - rounded shapes: skeleton distance minus radii; deep overlap falls back to the separating-axis result;
 *  - chain edges are one-sided, and their neighbours decide which normals may act, so that shapes never catch
 *    on inner vertices: manifold_chain.c;
 *  - two edges collide as two capsules of radius 0; chains do not collide with chains or edges.
 */
#ifndef CNI_COLLISION_MANIFOLD_H
#define CNI_COLLISION_MANIFOLD_H

#include "geometry/shape.h"

typedef struct cni_manifold_point {
	cni_vec2 point;     /* in a's body frame */
	float separation;   /* along the normal, radii included */
	uint32_t id;
} cni_manifold_point;

typedef struct cni_manifold {
	cni_vec2 normal;    /* unit, in a's body frame, from a to b */
	int32_t count;      /* 0: not touching within margin */
	int32_t reserved;
	cni_manifold_point points[2];
} cni_manifold;

/* Kept by the caller from step to step, initially zero; saves work and adds hysteresis. */
typedef struct cni_manifold_cache {
	uint8_t axis;       /* 0: none; 1..16: edge of a; 17..32: edge of b, the last reference/separating axis */
	uint8_t reserved[3];
} cni_manifold_cache;

typedef struct cni_manifold_input {
	const cni_geometry *a;
	const cni_geometry *b;
	int32_t child_a;
	int32_t child_b;
	cni_transform b_in_a;  /* maps b's body frame into a's */
	float margin;          /* metres */
	float slop;            /* metres: shorter lengths are negligible (0.5% of a length unit) */
} cni_manifold_input;

typedef void cni_manifold_fn(const cni_manifold_input *in, cni_manifold_cache *cache, cni_manifold *out);

/* The function for a pair of CN_SHAPE_ types with type_a <= type_b, NULL when the pair never collides. */
cni_manifold_fn *cni_manifold_function(int32_t type_a, int32_t type_b);

/* ---- seams: flush joints of faces of two static shapes (seam.c) */

/* 1 for polygons and edges with a radius up to the slop: only these can have seams. */
int32_t cni_seams_possible(const cni_geometry *g, float slop);

/* Bits 2 * face + end of the face ends of g that a face of h continues, and bits of the faces that h covers (seam.c). Seams must be possible for both shapes. */
uint32_t cni_seams_between(const cni_geometry *g, const cni_geometry *h, cni_transform h_in_g, float slop);

/* Replaces a manifold of a hidden corner by one of the surface, or empties it where the neighbour has the contact. in->a or
   one of the two has seams. motion: displacement of b relative to a in this step, in a's frame. depth: metres that the
   other shape may reach behind the surface. */
void cni_seams_mend(const cni_manifold_input *in, cni_vec2 motion, float depth, cni_manifold *m);

static inline uint32_t cni_seams_of(const cni_geometry *g)
{
	return cni_is_chain(g->type) ? 0u : g->seams;
}

#endif
