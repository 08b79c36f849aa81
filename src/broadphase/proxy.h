/*
 * broadphase/proxy.h - the boxes that the broadphase works on: one a shape, one an edge of a chain.
 *
 * The table is shared by all broadphases; what each keeps beside it is its own. A proxy's fat box
 * contains its shape's tight box with a margin and changes only when the shape leaves it.
 */
#ifndef CNI_BROADPHASE_PROXY_H
#define CNI_BROADPHASE_PROXY_H

#include "base/blocks.h"
#include "base/maths.h"
#include "base/table.h"

enum {
	CNI_PROXY_MOVED = 1u << 0,  /* the fat box changed (or the proxy was made) since the last update */
	CNI_PROXY_STATIC = 1u << 1, /* never pairs with another static one */
	CNI_PROXY_ALIVE = 1u << 2,
	CNI_PROXY_AGAIN = 1u << 3,  /* within update only: a pair of it was lost, it looks again */
	CNI_PROXY_CHILD_SHIFT = 4   /* bits 4..31: edge of a chain, else 0 */
};

typedef struct cni_proxy {
	cni_aabb fat;     /* now */
	cni_aabb old;     /* at the last update; empty (x0 > x1) for a new one */
	int32_t shape;    /* index of the shape */
	cni_ref geometry; /* the shape's, so that who collides two proxies need not look at shapes */
	int32_t cell;     /* owned by the broadphase: where it keeps the proxy */
	uint32_t flags;   /* CNI_PROXY_, and the child */
} cni_proxy;

/* Another fat box; whoever sets one tells the broadphase: see move in broadphase/broadphase.h. */
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
