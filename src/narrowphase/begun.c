/*
 * narrowphase/begun.c - manifolds kept for contacts that begin to touch.
 *
 * Storing one for each contact would take more memory than the contacts. So each group of successive contacts has room for a few, and
 * the manifolds of the others are computed again. Pairs that are new in this step, of which many begin, are at the end of the list:
 * their groups have room for all. Which are kept depends on the list alone: one worker processes a group, in order.
 */
#include "narrowphase/touch.h"
#include "model/world.h"

#include <string.h>

/* Room of a group for manifolds, where not all of its contacts are new. */
#define KEPT_A_GROUP 32
/* Where more than this part of the list is new, as in a world's first step, room for all would be too much: each group has less. */
#define NEW_PART 3
#define KEPT_OF_MANY 12

/* Room of the groups before this one. */
static int32_t room_before(const cni_begun_store *store, int32_t group)
{
	int32_t old = cni_min_i(group, store->first_new);
	return old * store->room + (group - old) * CNI_BEGUN_GROUP;
}

void cni_begun_open(cni_begun_store *store, cn_world *world, int32_t contacts, int32_t created)
{
	int32_t groups = contacts / CNI_BEGUN_GROUP + 1, room;
	store->room = created <= contacts / NEW_PART ? KEPT_A_GROUP : KEPT_OF_MANY;
	store->first_new = created > 0 && created <= contacts / NEW_PART ? (contacts - created) / CNI_BEGUN_GROUP : groups;
	store->group = store->taken = 0;
	room = room_before(store, groups);
	store->kept = (cni_touch_result *)cni_arena_push(&world->arena, sizeof(cni_touch_result) * (uint64_t)room + sizeof(uint16_t) * (uint64_t)groups);
	if (store->kept == NULL)
		return;
	store->counts = (uint16_t *)(store->kept + room);
	memset(store->counts, 0, sizeof(uint16_t) * (size_t)groups);
}

void cni_begun_close(cni_begun_store *store, cn_world *world)
{
	cni_arena_pop(&world->arena, store->kept);
}

cni_touch_result cni_begun_again(const cn_world *world, int32_t contact, float dt)
{
	cni_touch_pair pair = cni_touch_pair_of(world, cni_contact_at(world, contact), contact);
	cni_touch t;
	if (cni_touch_begin(world, &pair, dt, &t)) {
		cni_touch_collide(&t);
		cni_touch_finish(world, dt, &t);
	}
	return t.result;
}

/* The slot of a contact that does not touch is its place in the list. */
int32_t cni_begun_keep(cni_begun_store *store, const cni_touch *t)
{
	int32_t group = t->contact->slot / CNI_BEGUN_GROUP;
	if (store->kept == NULL || store->counts[group] == (group < store->first_new ? store->room : CNI_BEGUN_GROUP))
		return 0;
	store->kept[room_before(store, group) + store->counts[group]++] = t->result;
	return 1;
}

const cni_touch_result *cni_begun_take(cni_begun_store *store)
{
	while (store->taken == store->counts[store->group]) {
		++store->group;
		store->taken = 0;
	}
	return &store->kept[room_before(store, store->group) + store->taken++];
}
