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

#endif
