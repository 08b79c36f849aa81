/*
 * narrowphase/touch.h - how the shapes of one contact touch in this step. In three parts, so that the middle one, the
 * manifold, can be done for many pairs at once:
 *
 *   begin     poses, velocities, how far ahead the pair looks
 *   collide   the manifold
 *   finish    drops what the motion does not reach, moves what is still ahead to where it will be met
 *
 * Reads bodies, shapes, geometry, proxies; writes the contact's cache only.
 */
#ifndef CNI_NARROWPHASE_TOUCH_H
#define CNI_NARROWPHASE_TOUCH_H

#include "model/solve.h"

typedef struct cni_pair_motion {
	cni_vec2 v;       /* velocity of b's centre relative to a's, in a's frame */
	float wa, wb;
	float reach;      /* most that surface points can come projection in the step */
	float margin;     /* within which the pair touches, however slow it is */
} cni_pair_motion;

/* A contact, and where to look for what is asked of it first. */
typedef struct cni_touch_pair {
	cni_contact *contact;
	cni_body *body[2];
	const cni_proxy *proxy[2];
	int32_t index; /* of the contact */
} cni_touch_pair;

typedef struct cni_touch {
	cni_contact *contact;
	const cni_body *a, *b;
	cni_manifold_input in;
	cni_pair_motion motion;
	int32_t boxes_overlap;   /* the fat ones */
	float radius[2];         /* of the shapes */
	cni_manifold manifold;
	cni_vec2 gap;            /* where b's point is from a's now, when the contact is still ahead; in a's frame */
} cni_touch;

static inline cni_touch_pair cni_touch_pair_of(const cn_world *world, cni_contact *c, int32_t index)
{
	cni_touch_pair p;
	p.contact = c;
	p.body[0] = cni_body_at(world, c->body[0]);
	p.body[1] = cni_body_at(world, c->body[1]);
	p.proxy[0] = cni_proxy_at(world, c->proxy[0]);
	p.proxy[1] = cni_proxy_at(world, c->proxy[1]);
	p.index = index;
	return p;
}

/* 0: there is nothing more to do, the manifold is empty: the bodies are far apart, or their boxes are. Such a pair ends
   however far it reaches, or it would be found twice. */
int32_t cni_touch_begin(const cn_world *world, const cni_touch_pair *p, float dt, cni_touch *out);
void cni_touch_collide(cni_touch *out);
void cni_touch_finish(const cn_world *world, float dt, cni_touch *out);

/* What of stage 3 needs no manifold: lanes whose bodies have hardly moved are brought up to date. The contacts of all
   others go to left, which has room for every lane; returns how many. dt 0: none is followed. */
int32_t cni_manifolds_reuse(cn_world *world, float dt, int32_t *left);

#endif
