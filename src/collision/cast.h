/*
 * collision/cast.h - where a ray, or a convex shape that is moved without turning, first meets a shape.
 *
 * Everything is in the frame of the shape that is cast against. Answers are exact up to rounding: a
 * moved shape is a ray against the Minkowski difference of the two (see cast_shape.c).
 */
#ifndef CNI_COLLISION_CAST_H
#define CNI_COLLISION_CAST_H

#include "collision/distance.h"
#include "geometry/shape.h"

typedef struct cni_cast_hit {
	float fraction;    /* of the translation, [0, 1] */
	cni_vec2 point;    /* on the surface of the shape that was met */
	cni_vec2 normal;   /* unit, out of that shape */
	float depth;       /* started inside: the way out along the normal, the shortest there is; else 0 */
	int32_t inside;    /* 1: they overlap or touch at the start; fraction is 0 then, whatever the translation */
} cni_cast_hit;

/* 1 and a hit, or 0. A chain's edge is met from its front only (the side of right_perp of its direction),
   an edge from both sides; neither has an inside. A translation of 0 meets what is around the origin. */
int32_t cni_cast_ray(const cni_geometry *g, int32_t child, cni_vec2 origin, cni_vec2 translation, cni_cast_hit *out);

/* moving: 1, 2 or more convex points (counter-clockwise), with a radius unless there are three or more.
   moving_in_g maps their frame into g's. A chain's edge is met by what has its centroid (in the frame of
   its points) in front of it and moves towards it or overlaps it at the start; the way out is to its front then. */
int32_t cni_cast_points(const cni_geometry *g, int32_t child, cni_proxy_points moving, cni_vec2 centroid, cni_transform moving_in_g,
	cni_vec2 translation, cni_cast_hit *out);

/* In contact at the start, no deeper than touch, and not on the way farther in: such a hit is none for most who ask. */
#define CNI_CAST_ALONG_SINE 1e-6f /* of a way along a surface: what rounding makes of a normal leads neither in nor out */
static inline int32_t cni_cast_leads_out(const cni_cast_hit *hit, float touch, cni_vec2 translation)
{
	float length = cni_length(translation);
	return hit->inside && hit->depth <= touch && length > 0.0f && cni_dot(hit->normal, translation) >= -CNI_CAST_ALONG_SINE * length;
}

/* ---- the kernel of both: a ray against a convex skeleton with a radius */

#define CNI_CAST_POINTS_MAX (2 * CN_POLYGON_MAX_VERTICES)

typedef struct cni_cast_hull {
	const cni_vec2 *points;   /* counter-clockwise; 2 points only with a radius */
	const cni_vec2 *normals;  /* of the faces points[i] -> points[i + 1], or NULL */
	int32_t count;
	float radius;
} cni_cast_hull;

/* *out_feature: the vertex met (0 .. count - 1) or count + the face met; started inside, the nearest one. */
int32_t cni_cast_hull_ray(const cni_cast_hull *hull, cni_vec2 origin, cni_vec2 translation, cni_cast_hit *out, int32_t *out_feature);

#endif
