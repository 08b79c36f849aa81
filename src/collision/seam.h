/*
 * collision/seam.h - where faces of two fixed shapes lie flush end to end, they are one surface: the corners between them are
 * hidden, and what slides along must not be caught there.
 *
 * Which ends of its faces are hidden is kept in the record of a polygon or an edge (cni_geometry.seams), found once
 * when fixed shapes are made, moved or destroyed (narrowphase/static_seams.c). A contact whose normal belongs to a hidden corner,
 * or to the side face below it, is of the surface instead (as internal edge removal in Jolt and Bullet; for chains see
 * manifold_chain.c).
 */
#ifndef CNI_COLLISION_SEAM_H
#define CNI_COLLISION_SEAM_H

#include "collision/manifold.h"

/* Polygons and edges whose rounding is below the slop. */
int32_t cni_seams_possible(const cni_geometry *g, float slop);

/* Which ends of faces of g are continued by a face of h: bit 2 face + end. Both are possible. */
uint32_t cni_seams_between(const cni_geometry *g, const cni_geometry *h, cni_transform h_in_g, float slop);

/* in->a or in->b is fixed and has seams. A manifold of a hidden corner becomes one of the surface, or empty where the neighbour
   has it. way: by how much b will have moved relative to a, in a's frame; depth: how far behind the surface the other shape may
   reach, metres. */
void cni_seams_mend(const cni_manifold_input *in, cni_vec2 way, float depth, cni_manifold *m);

static inline uint32_t cni_seams_of(const cni_geometry *g)
{
	return g->type == CN_SHAPE_CHAIN ? 0u : g->seams;
}

#endif
