/*
 * broadphase/pair_list.c - owns the list of new pairs: appends in any order, sorts at the end, and counts pairs that
 * found no memory (see broadphase/broadphase.h).
 *
 * A search that finds more pairs than the limit has met a crowd and ends early. A second search counts each proxy's pairs, with
 * fixed and with other proxies apart; a third one makes the list. Each pair has a random number in [0, 1), a hash of its proxies
 * and the seed. Each proxy has a threshold 2^-k with the least k by which a right shift of its count gives CROWD_DEGREE at
 * most. A pair is listed when its number is below the threshold of one of its proxies. So bodies outside of the crowd miss no
 * pair, and proxies in the crowd have some eight to sixteen. For a pair with a fixed proxy, the other one's count of fixed
 * proxies decides, and a proxy keeps all of up to CROWD_DEGREE_FIXED: a crowd neither falls through the ground nor through a
 * crusher, and yet a thousand fixed shapes in the same spot take bounded memory.
 * Counts, numbers and so the list do not depend on the order of searching.
 */
#include "broadphase/broadphase.h"
#include "base/sort.h"

#include <string.h>

#define CROWD_DEGREE 16
#define CROWD_DEGREE_FIXED 256

void cni_pairs_begin(cni_broadphase_pairs *pairs, int32_t proxies)
{
	pairs->list.count = 0;
	pairs->pairs_lost = 0;
	pairs->culled = 0;
	pairs->left_out = pairs->left_out_fixed = 0;
	pairs->mode = CNI_PAIRS_MODE_LIST;
	pairs->limit = cni_pairs_limit(proxies);
}

/* ---- crowds ---- */

/* The least k with degree >> k <= most. */
static int32_t degree_shift(int32_t degree, int32_t most)
{
	int32_t k = 0;
	while (degree >> k > most)
		++k;
	return k;
}

static uint32_t is_fixed(const cni_broadphase_pairs *pairs, int32_t id, const cni_proxy *p)
{
	return pairs->fixed != NULL ? (uint32_t)pairs->fixed(pairs->wanted_context, id) : p->flags & CNI_PROXY_STATIC ? 1u : 0u;
}

/* Without scratch memory the list takes what fits. */
int32_t cni_pairs_search_again(cni_broadphase_pairs *pairs, cni_arena *arena, int32_t ids)
{
	uint64_t bytes = 2u * sizeof(int32_t) * (uint64_t)ids;
	if (pairs->mode == CNI_PAIRS_MODE_THIN) {
		(void)cni_arena_pop(arena, pairs->degrees);
		pairs->degrees = NULL;
	}
	if (pairs->mode == CNI_PAIRS_MODE_COUNT) {
		pairs->mode = CNI_PAIRS_MODE_THIN;
		for (int32_t k = 0; k < 2 * ids; ++k)
			pairs->degrees[k] = degree_shift(pairs->degrees[k], k % 2 ? CROWD_DEGREE_FIXED : CROWD_DEGREE);
		return 1;
	}
	if (pairs->mode != CNI_PAIRS_MODE_STOPPED)
		return 0;
	pairs->list.count = 0;
	pairs->limit = INT32_MAX;
	pairs->degrees = (int32_t *)cni_arena_push(arena, bytes);
	pairs->mode = pairs->degrees == NULL ? CNI_PAIRS_MODE_LIST : CNI_PAIRS_MODE_COUNT;
	if (pairs->degrees != NULL)
		memset(pairs->degrees, 0, (size_t)bytes);
	return 1;
}

/* The finalizer of MurmurHash3 (Appleby), which spreads each bit over all. */
static uint64_t pair_number(int32_t a, int32_t b, uint32_t seed)
{
	uint64_t x = (uint64_t)(uint32_t)a << 32 | (uint32_t)b;
	x ^= (uint64_t)seed * 0x9E3779B97F4A7C15u;
	x = (x ^ x >> 33) * 0xFF51AFD7ED558CCDu;
	x = (x ^ x >> 33) * 0xC4CEB9FE1A85EC53u;
	return x ^ x >> 33;
}

int32_t cni_pairs_crowd_takes(cni_broadphase_pairs *pairs, int32_t a, int32_t b, cni_proxy *pa, cni_proxy *pb)
{
	if (pairs->mode == CNI_PAIRS_MODE_STOPPED)
		return 0;
	uint32_t fixed_a = is_fixed(pairs, a, pa);
	uint32_t fixed_b = is_fixed(pairs, b, pb);
	if (fixed_a & fixed_b)
		return 0;
	int32_t *degree_a = &pairs->degrees[2 * a + (int32_t)fixed_b];
	int32_t *degree_b = &pairs->degrees[2 * b + (int32_t)fixed_a];
	if (pairs->mode == CNI_PAIRS_MODE_COUNT) {
		++*degree_a;
		++*degree_b;
		return 0;
	}
	int32_t k = fixed_b ? *degree_a : fixed_a ? *degree_b : cni_min_i(*degree_a, *degree_b);
	if (k == 0 || pair_number(cni_min_i(a, b), cni_max_i(a, b), pairs->seed) >> (64 - k) == 0)
		return 1;
	(a < b ? pa : pb)->flags |= CNI_PROXY_CROWDED;
	pairs->left_out += pairs->left_out < INT32_MAX;
	pairs->left_out_fixed |= (int32_t)(fixed_a | fixed_b);
	return 0;
}

/* ---- the list ---- */

void cni_pairs_cull(cni_broadphase_pairs *pairs)
{
	cni_pair *list = (cni_pair *)pairs->list.data;
	int32_t count = pairs->list.count;
	if (pairs->wanted == NULL || pairs->culled)
		return;
	pairs->list.count = 0;
	for (int32_t k = 0; k < count; ++k)
		if (pairs->wanted(pairs->wanted_context, list[k].a, list[k].b))
			list[pairs->list.count++] = list[k];
	pairs->culled = 1;
}

static int32_t list_is_full(const cni_broadphase_pairs *pairs) { return pairs->list.count == pairs->list.capacity; }
static int32_t list_grow(cni_broadphase_pairs *pairs, cni_memory *memory) { return cni_array_reserve(&pairs->list, memory, pairs->list.count + 1); }

/* A fixed memory block is sized for pairs that become contacts, so there the list is culled before it grows. */
void cni_pairs_add(cni_broadphase_pairs *pairs, cni_memory *memory, int32_t a, int32_t b, cni_proxy *moved)
{
	int32_t may_cull = pairs->wanted != NULL && !pairs->culled;
	if (may_cull && (pairs->list.count == pairs->limit || (list_is_full(pairs) && (memory->fixed || !list_grow(pairs, memory)))))
		cni_pairs_cull(pairs);
	if (pairs->culled && !pairs->wanted(pairs->wanted_context, cni_min_i(a, b), cni_max_i(a, b)))
		return;
	if (pairs->list.count == pairs->limit) {
		pairs->mode = CNI_PAIRS_MODE_STOPPED;
		return;
	}
	/* After one failed allocation the update does not try again. */
	if (list_is_full(pairs) && (pairs->pairs_lost > 0 || !list_grow(pairs, memory))) {
		moved->flags |= CNI_PROXY_AGAIN;
		++pairs->pairs_lost;
		return;
	}
	cni_pair *pair = (cni_pair *)pairs->list.data + pairs->list.count++;
	pair->a = cni_min_i(a, b);
	pair->b = cni_max_i(a, b);
}

/* Converts pairs to 64-bit keys in place (a pair has the size of its key), sorts the keys, converts back. */
void cni_pairs_sort(cni_broadphase_pairs *pairs, cni_arena *arena)
{
	cni_array *list = &pairs->list;
	if (list->count < 2)
		return;
	void *scratch = cni_arena_push(arena, (uint64_t)list->count * sizeof(uint64_t));
	for (int32_t i = 0; i < list->count; ++i) {
		cni_pair pair = ((const cni_pair *)list->data)[i];
		uint64_t key = (uint64_t)(uint32_t)pair.a << 32 | (uint32_t)pair.b;
		memcpy((cni_pair *)list->data + i, &key, sizeof(key));
	}
	cni_sort_keys((uint64_t *)list->data, (uint64_t *)scratch, list->count);
	for (int32_t i = 0; i < list->count; ++i) {
		cni_pair pair;
		uint64_t key;
		memcpy(&key, (const cni_pair *)list->data + i, sizeof(key));
		pair.a = (int32_t)(uint32_t)(key >> 32);
		pair.b = (int32_t)(uint32_t)key;
		memcpy((cni_pair *)list->data + i, &pair, sizeof(pair));
	}
	(void)cni_arena_pop(arena, scratch);
}
