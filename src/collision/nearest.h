/*
 * collision/nearest.h - the point of a shape's surface that is nearest to a given point.
 */
#ifndef CNI_COLLISION_NEAREST_H
#define CNI_COLLISION_NEAREST_H

#include "geometry/shape.h"

typedef struct cni_nearest {
	float distance;    /* negative: depth inside a shape with area; never for edges and chains */
	cni_vec2 point;    /* on the surface */
	cni_vec2 normal;   /* unit; outward there, from an edge or chain towards the given point */
} cni_nearest;

/* All in the shape's own frame. Where every direction is as good (a circle's centre, a point on an edge) the
   normal is the x axis or the edge's right side. */
cni_nearest cni_geometry_nearest(const cni_geometry *g, int32_t child, cni_vec2 local);

#endif
