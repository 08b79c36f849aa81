/*
 * broadphase/proxy.h - proxies, the boxes that the broadphase works on: one per shape, or one per edge of a chain.
 *
 * All broadphases share this table. A proxy's fat box contains its shape's tight box plus a margin and changes only
 * when the shape leaves it.
 */
#ifndef CNI_BROADPHASE_PROXY_H
#define CNI_BROADPHASE_PROXY_H

#include "base/blocks.h"
#include "base/maths.h"
#include "base/table.h"

enum {
	CNI_PROXY_MOVED = 1u << 0,  /* the fat box changed (or the proxy was made) since the last update */
	CNI_PROXY_STATIC = 1u << 1, /* never pairs with another static proxy */
	CNI_PROXY_ALIVE = 1u << 2,
	CNI_PROXY_AGAIN = 1u << 3,  /* within update only: a pair of this proxy was lost, its pairs are searched again */
	CNI_PROXY_CROWDED = 1u << 4, /* a pair of this proxy was left out because of a crowd: the world has to touch it in some later step */
	CNI_PROXY_CHILD_SHIFT = 5   /* bits 5..31: edge of a chain, else 0 */
};

typedef struct cni_proxy {
	cni_aabb fat;     /* now */
	cni_aabb old;     /* at the last update; empty (x0 > x1) for a new proxy */
	int32_t shape;    /* index of the shape */
	cni_ref geometry; /* of the shape, so that colliding two proxies reads no shape */
	int32_t cell;     /* owned by the broadphase: the tile that holds the proxy */
	uint32_t flags;   /* CNI_PROXY_ bits and the child index */
} cni_proxy;

/* Sets the fat box. The caller must then call the broadphase's move. */
static inline void cni_proxy_set_fat(cni_proxy *p, const cni_aabb *fat)
{
	p->fat = *fat;
	p->flags |= CNI_PROXY_MOVED;
}

static inline int32_t cni_proxy_child(const cni_proxy *p) { return (int32_t)(p->flags >> CNI_PROXY_CHILD_SHIFT); }

/* A new pair of overlapping boxes, a < b. */
typedef struct cni_pair {
	int32_t a;
	int32_t b;
} cni_pair;

/* ---- a ray that becomes shorter with each hit, against boxes */

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
