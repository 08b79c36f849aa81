/*
 * stages/broadphase_list.c - owns how new pairs are listed: appended in any order, sorted at the end, and what
 * happens when there is no memory for one (see model/broadphase.h).
 */
#include "stages/broadphase_list.h"
#include "base/sort.h"

#include <string.h>

void cni_pairs_add(cni_broadphase_pairs *pairs, cni_memory *memory, int32_t a, int32_t b, cni_proxy *looks)
{
	cni_pair *pair;
	int32_t room = pairs->list.count < pairs->list.capacity;
	/* Once refused, memory is not asked for again. */
	if (!room && (pairs->pairs_lost > 0 || !cni_array_reserve(&pairs->list, memory, pairs->list.count + 1))) {
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
