/*
 * collision/distance.h - closest points between two convex point sets (GJK), between two segments in closed form, and of a shape to a
 * point.
 */
#ifndef CNI_COLLISION_DISTANCE_H
#define CNI_COLLISION_DISTANCE_H

#include "geometry/shape.h"

/* Distance of the skeletons, with the closest features; points in a's frame. */
typedef struct cni_closest {
	cni_vec2 point_a;
	cni_vec2 point_b;
	cni_vec2 normal;     /* unit, from a to b; (0, 0) when they overlap */
	float distance;      /* 0 when they overlap */
	int32_t index_a[2];  /* point numbers: two of an edge, or the same twice for a vertex */
	int32_t index_b[2];
} cni_closest;
/* b_in_a maps b's frame into a's. */
cni_closest cni_closest_find(const cni_vec2 *points_a, int32_t count_a, const cni_vec2 *points_b, int32_t count_b, cni_transform b_in_a);
/* The same of the surfaces, radii included: the distance is negative when only the radii overlap. */
cni_closest cni_distance(cni_proxy_points a, cni_proxy_points b, cni_transform b_in_a);

typedef struct cni_segment_distance {
	cni_vec2 point_a;   /* closest points on p1-q1 and p2-q2 */
	cni_vec2 point_b;
	float fraction_a;   /* 0 at p1, 1 at q1 */
	float fraction_b;
	float distance_sq;
} cni_segment_distance;
cni_segment_distance cni_segment_to_segment(cni_vec2 p1, cni_vec2 q1, cni_vec2 p2, cni_vec2 q2);

typedef struct cni_nearest {
	float distance;    /* negative: depth inside a shape with area; never for edges and chains */
	cni_vec2 point;    /* on the surface */
	cni_vec2 normal;   /* unit, outward; of an edge or chain towards the given point */
} cni_nearest;

/* All in the shape's own frame. Where no direction is distinguished the normal is the x axis (a circle's centre) or points
   to the edge's right side (a point on an edge). */
cni_nearest cni_geometry_nearest(const cni_geometry *g, int32_t child, cni_vec2 local);

#endif
