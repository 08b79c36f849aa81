/*
 * narrowphase/begun.h - manifolds of contacts that begin to touch, kept from the narrowphase's first part for its second.
 *
 * Storing one for each contact would take more memory than the contacts. So each group of successive contacts has room for a few, and
 * the manifolds of the others are computed again. Pairs that are new in this step, of which many begin, are at the end of the list:
 * their groups have room for all. Which are kept depends on the list alone: one worker processes a group, in order.
 */
#ifndef CNI_NARROWPHASE_BEGUN_H
#define CNI_NARROWPHASE_BEGUN_H

#include "narrowphase/touch.h"

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
