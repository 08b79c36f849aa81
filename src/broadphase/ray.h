/*
 * broadphase/ray.h - a ray that becomes shorter with each hit, against boxes: for the searches of the sweep and of the tree.
 */
#ifndef CNI_BROADPHASE_RAY_H
#define CNI_BROADPHASE_RAY_H

#include "base/maths.h"

typedef struct cni_ray {
	cni_vec2 o, d;     /* o + t d */
	float ax, ay;      /* |d.x|, |d.y| */
	float limit;       /* t in [0, limit] */
	cni_aabb box;      /* of the ray up to limit */
} cni_ray;

static inline void cni_ray_limit(cni_ray *ray, float limit)
{
	ray->limit = limit;
	ray->box = cni_aabb_of_segment(ray->o, cni_madd(ray->o, limit, ray->d));
}

static inline cni_ray cni_ray_make(cni_vec2 origin, cni_vec2 translation)
{
	cni_ray ray = { origin, translation, cni_abs(translation.x), cni_abs(translation.y), 1.0f, cni_no_box() };
	cni_ray_limit(&ray, 1.0f);
	return ray;
}

/* Does the ray's line cross a box that overlaps the ray's? With the normal n = (-d.y, d.x), the box's centre c relative to o and its half
   sides e that is so when |n . c| <= |n| . e. The code uses twice both sides. Rounding errs towards a hit; an overflow is a hit. */
static inline int32_t cni_ray_line_crosses(const cni_ray *ray, const cni_aabb *b)
{
	float cx = (b->x0 - ray->o.x) + (b->x1 - ray->o.x), cy = (b->y0 - ray->o.y) + (b->y1 - ray->o.y);
	float p = ray->d.x * cy, q = ray->d.y * cx, reach = ray->ax * (b->y1 - b->y0) + ray->ay * (b->x1 - b->x0);
	float error = 1e-6f * (cni_abs(p) + cni_abs(q) + reach);
	return !(cni_abs(p - q) > reach + error);
}

static inline int32_t cni_ray_crosses(const cni_ray *ray, const cni_aabb *b)
{
	return cni_aabb_overlap_branchless(&ray->box, b) & cni_ray_line_crosses(ray, b);
}

#endif
