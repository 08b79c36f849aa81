/*
 * collision/nearest.h - the surface point of a shape that is nearest to a given point.
 */
#ifndef CNI_COLLISION_NEAREST_H
#define CNI_COLLISION_NEAREST_H

#include "geometry/shape.h"

typedef struct cni_nearest {
	float distance;    /* negative: depth inside a shape with area; never for edges and chains */
	cni_vec2 point;    /* on the surface */
	cni_vec2 normal;   /* unit, outward; of an edge or chain towards the given point */
} cni_nearest;

/* All in the shape's own frame. Where no direction is distinguished the normal is the x axis (a circle's centre) or points
   to the edge's right side (a point on an edge). */
cni_nearest cni_geometry_nearest(const cni_geometry *g, int32_t child, cni_vec2 local);

#endif
