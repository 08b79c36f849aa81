/*
 * narrowphase/touch.h - computes how the shapes of one contact touch in this step. In three parts, so that the second one, the
 * manifold, can be computed for many pairs at once:
 *
 *   begin     relative pose, velocities, speculative distance
 *   collide   manifold
 *   finish    drops points that the motion does not reach; moves points that are still ahead to where the shapes will meet
 *
 * Reads bodies, shapes, geometry, proxies; writes the contact's cache only.
 */
#ifndef CNI_NARROWPHASE_TOUCH_H
#define CNI_NARROWPHASE_TOUCH_H

#include "collision/toi.h"
#include "model/solve.h"

typedef struct cni_pair_motion {
	cni_vec2 v;       /* velocity of b's centre relative to a's, in a's frame */
	float wa, wb;
	float reach;      /* bound on how much surface points can approach each other in the step */
	float margin;     /* distance within which the pair touches at any speed */
} cni_pair_motion;

/* A contact with its bodies and proxies. */
typedef struct cni_touch_pair {
	cni_contact *contact;
	cni_body *body[2];
	const cni_proxy *proxy[2];
	int32_t index; /* of the contact */
	int32_t place; /* in the list of contacts to cull */
} cni_touch_pair;

typedef struct cni_touch {
	cni_contact *contact;
	const cni_body *a, *b;
	cni_manifold_input in;
	cni_pair_motion motion;
	int32_t boxes_overlap;   /* the fat ones */
	cni_touch_result result;
} cni_touch;

static inline cni_touch_pair cni_touch_pair_of(const cn_world *world, cni_contact *c, int32_t index)
{
	cni_touch_pair p = { c, { cni_body_at(world, c->body[0]), cni_body_at(world, c->body[1]) },
		{ cni_proxy_at(world, c->proxy[0]), cni_proxy_at(world, c->proxy[1]) }, index, CNI_NONE };
	return p;
}

/* Maps frame b into frame a from the difference of the two centres, which loses no digits far from the origin. */
static inline cni_transform cni_body_b_in_a(const cni_body *a, const cni_body *b, cni_vec2 centers)
{
	cni_vec2 from_a = cni_unrotate(a->q, cni_sub(centers, cni_rotate(b->q, b->local_center)));
	cni_transform x = { cni_rot_between(a->q, b->q), cni_add(from_a, a->local_center) };
	return x;
}

/* The path of a body that moves by `way` and turns; relative to a point near it. */
static inline cni_path cni_body_path(const cni_body *b, cni_vec2 from, cni_vec2 way, float turn)
{
	cni_vec2 start = cni_v((b->cx - from.x) + b->cx_low, (b->cy - from.y) + b->cy_low);
	cni_path p = { start, cni_add(start, way), b->q, turn, b->local_center };
	return p;
}

/* 1: the boxes overlap, and a direction separates the shapes throughout the step: cull.c. */
int32_t cni_pair_stays_apart(const cn_world *world, const cni_touch_pair *p, float dt);
/* Returns 0 where the manifold is empty: the fat boxes are apart. A pair whose boxes are apart ends even if it moves
   fast, or the broadphase would find it twice. */
int32_t cni_touch_begin(const cn_world *world, const cni_touch_pair *p, float dt, cni_touch *out);
void cni_touch_collide(cni_touch *out);
void cni_touch_finish(const cn_world *world, float dt, cni_touch *out);
/* One-way platforms: a shape that first touches from below or from the side passes through until it no longer touches. */
void cni_touch_filter_one_way(const cn_world *world, cni_contact *c, cni_manifold *m);

/* Manifold reuse, the first part of stage 3: updates lanes whose bodies have moved little against each other. Writes the contacts of all
   other lanes to remaining, which has room for every lane, and returns their number. dt 0: updates none. */
int32_t cni_manifolds_reuse(cn_world *world, float dt, int32_t *remaining);

/* ---- manifolds of contacts that begin to touch, kept from the narrowphase's first part for its second (begun.c) */

/* Contacts in a group. */
#define CNI_BEGUN_GROUP 256

typedef struct cni_begun_store {
	cni_touch_result *kept;       /* NULL: no room */
	uint16_t *counts;      /* of each group */
	int32_t first_new;     /* the first group with room for all */
	int32_t room;          /* of each group before it */
	int32_t group, taken;  /* place of the next one to be taken */
} cni_begun_store;

/* For a list of contacts of which `created` at the end are new in this step. Pushes on the frame arena; close pops. */
void cni_begun_open(cni_begun_store *store, cn_world *world, int32_t contacts, int32_t created);
void cni_begun_close(cni_begun_store *store, cn_world *world);
/* Computes the manifold of a contact again. */
cni_touch_result cni_begun_again(const cn_world *world, int32_t contact, float dt);
/* Returns 0 if there is no room. */
int32_t cni_begun_keep(cni_begun_store *store, const cni_touch *t);
/* Manifolds are taken in the order of their contacts. */
const cni_touch_result *cni_begun_take(cni_begun_store *store);

#endif
