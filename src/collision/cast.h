/*
 * collision/cast.h - casts a ray or a translating convex shape against a shape: the first hit.
 *
 * All data is in the frame of the shape that is hit. Results are exact up to rounding: a shape cast is a ray cast against
 * the Minkowski difference of the two shapes (see cast_shape.c).
 */
#ifndef CNI_COLLISION_CAST_H
#define CNI_COLLISION_CAST_H

#include "collision/distance.h"
#include "geometry/shape.h"

typedef struct cni_cast_hit {
	float fraction;    /* of the translation, [0, 1] */
	cni_vec2 point;    /* on the surface of the shape that is hit */
	cni_vec2 normal;   /* unit, out of that shape */
	float depth;       /* of an overlap at the start: shortest way out, which is along the normal; else 0 */
	int32_t inside;    /* 1: they overlap or touch at the start; fraction is then 0, whatever the translation */
} cni_cast_hit;

/* 1 and a hit, or 0. A chain's edge is hit from its front only (the side of right_perp of its direction), an edge from both
   sides; neither has an inside. A translation of 0 hits shapes that contain the origin. */
int32_t cni_cast_ray(const cni_geometry *g, int32_t child, cni_vec2 origin, cni_vec2 translation, cni_cast_hit *out);

/* moving: 1, 2 or more convex points (counter-clockwise), with a radius unless there are three or more.
   moving_in_g maps their frame into g's. A chain's edge is hit by sets whose centroid (in the frame of the points) is in
   front of it and that move towards it or overlap it at the start; normal and depth of an overlap then lead to its front. */
int32_t cni_cast_points(const cni_geometry *g, int32_t child, cni_proxy_points moving, cni_vec2 centroid, cni_transform moving_in_g,
	cni_vec2 translation, cni_cast_hit *out);

/* 1 for a contact at the start, no deeper than touch, from which the translation does not lead deeper: most callers ignore
   such a hit. */
#define CNI_CAST_ALONG_SINE 1e-6f /* of a way along a surface: what rounding makes of a normal leads neither in nor out */
static inline int32_t cni_cast_leads_out(const cni_cast_hit *hit, float touch, cni_vec2 translation)
{
	float length = cni_length(translation);
	return hit->inside && hit->depth <= touch && length > 0.0f && cni_dot(hit->normal, translation) >= -CNI_CAST_ALONG_SINE * length;
}

/* ---- the kernel of both: a ray against a convex skeleton with a radius */

#define CNI_CAST_POINTS_MAX (2 * CN_POLYGON_MAX_VERTICES)

/* The normals may be NULL; 2 points only with a radius. *out_feature: the vertex hit (0 .. count - 1) or count + the face hit; the
   nearest one when the ray starts inside. */
int32_t cni_cast_hull_ray(const cni_faces *hull, cni_vec2 origin, cni_vec2 translation, cni_cast_hit *out, int32_t *out_feature);

#endif
