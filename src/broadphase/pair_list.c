/*
 * broadphase/pair_list.c - owns how new pairs are listed: appended in any order, sorted at the end, and what
 * happens when there is no room for one (see broadphase/broadphase.h).
 */
#include "broadphase/pair_list.h"
#include "base/sort.h"

#include <string.h>

void cni_pairs_begin(cni_broadphase_pairs *pairs)
{
	pairs->list.count = 0;
	pairs->pairs_lost = 0;
	pairs->asked = 0;
}

void cni_pairs_cull(cni_broadphase_pairs *pairs)
{
	cni_pair *list = (cni_pair *)pairs->list.data;
	int32_t k, count = pairs->list.count;
	if (pairs->wanted == NULL || pairs->asked)
		return;
	pairs->list.count = 0;
	for (k = 0; k < count; ++k)
		if (pairs->wanted(pairs->wanted_context, list[k].a, list[k].b))
			list[pairs->list.count++] = list[k];
	pairs->asked = 1;
}

static int32_t list_is_full(const cni_broadphase_pairs *pairs) { return pairs->list.count == pairs->list.capacity; }
static int32_t list_grow(cni_broadphase_pairs *pairs, cni_memory *memory) { return cni_array_reserve(&pairs->list, memory, pairs->list.count + 1); }

/* A fixed block has room for pairs that become contacts and should not spend more on others: there the list is culled before it grows. */
void cni_pairs_add(cni_broadphase_pairs *pairs, cni_memory *memory, int32_t a, int32_t b, cni_proxy *looks)
{
	cni_pair *pair;
	if (list_is_full(pairs) && pairs->wanted != NULL && !pairs->asked && (memory->fixed || !list_grow(pairs, memory)))
		cni_pairs_cull(pairs);
	if (pairs->asked && !pairs->wanted(pairs->wanted_context, cni_min_i(a, b), cni_max_i(a, b)))
		return;
	/* Once refused, memory is not asked for again. */
	if (list_is_full(pairs) && (pairs->pairs_lost > 0 || !list_grow(pairs, memory))) {
		looks->flags |= CNI_PROXY_AGAIN;
		++pairs->pairs_lost;
		return;
	}
	pair = (cni_pair *)pairs->list.data + pairs->list.count++;
	pair->a = cni_min_i(a, b);
	pair->b = cni_max_i(a, b);
}

/* By way of 64-bit keys in the same place: a pair is as large as its key. */
void cni_pairs_sort(cni_broadphase_pairs *pairs, cni_arena *arena)
{
	cni_array *list = &pairs->list;
	void *scratch;
	int32_t i;
	if (list->count < 2)
		return;
	scratch = cni_arena_push(arena, (uint64_t)list->count * sizeof(uint64_t));
	for (i = 0; i < list->count; ++i) {
		cni_pair pair = ((const cni_pair *)list->data)[i];
		uint64_t key = (uint64_t)(uint32_t)pair.a << 32 | (uint32_t)pair.b;
		memcpy((cni_pair *)list->data + i, &key, sizeof(key));
	}
	cni_sort_keys((uint64_t *)list->data, (uint64_t *)scratch, list->count);
	for (i = 0; i < list->count; ++i) {
		cni_pair pair;
		uint64_t key;
		memcpy(&key, (const cni_pair *)list->data + i, sizeof(key));
		pair.a = (int32_t)(uint32_t)(key >> 32);
		pair.b = (int32_t)(uint32_t)key;
		memcpy((cni_pair *)list->data + i, &pair, sizeof(pair));
	}
	(void)cni_arena_pop(arena, scratch);
}
