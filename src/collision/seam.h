/*
 * collision/seam.h - seams, flush joints of faces of two shapes that are static or on one kinematic body: the faces form one surface, the
 * corners between them are hidden, and sliding shapes must not catch on them.
 *
 * A polygon or an edge stores which ends of its faces are hidden (cni_geometry.seams). narrowphase/static_seams.c finds
 * them when static shapes are made, moved or destroyed. A manifold whose normal belongs to a hidden corner, or to the side
 * face below it, is replaced by a manifold of the surface (as internal edge removal in Jolt and Bullet; for chains see
 * manifold_chain.c). A face that one neighbour covers leads nowhere: a shape deep inside leaves through another face.
 */
#ifndef CNI_COLLISION_SEAM_H
#define CNI_COLLISION_SEAM_H

#include "collision/manifold.h"

/* 1 for polygons and edges with a radius up to the slop: only these can have seams. */
int32_t cni_seams_possible(const cni_geometry *g, float slop);

/* Bits 2 * face + end of the face ends of g that a face of h continues, and bits of the faces that h covers (seam.c). Seams must be possible for both shapes. */
uint32_t cni_seams_between(const cni_geometry *g, const cni_geometry *h, cni_transform h_in_g, float slop);

/* Replaces a manifold of a hidden corner by one of the surface, or empties it where the neighbour has the contact. One
   of the shapes has seams. motion: displacement of b relative to a in this step, in a's frame. depth: metres that the
   other shape may reach behind the surface. */
void cni_seams_mend(const cni_manifold_input *in, cni_vec2 motion, float depth, cni_manifold *m);

static inline uint32_t cni_seams_of(const cni_geometry *g)
{
	return cni_is_chain(g->type) ? 0u : g->seams;
}

#endif
