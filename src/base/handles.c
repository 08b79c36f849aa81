/*
 * base/handles.c - owns the slots: which is alive, with which generation and under which index, and the queue of free ones.
 *
 *   slot = generation (10 bits) << 22 | alive (1 bit) << 21 | next free slot + 1 (21 bits)
 *
 * A free slot already has the generation it will be taken with, so that handing it out is one bit; but one that has worn out its
 * index has 0, and gets an alias when it is taken. That happens once in 1023 lives of a slot, so a sorted list of aliases will do.
 *
 * Invariants: slots = alive + queued. No slot's own index is an alias: a new slot whose index has been given as one gets an
 * alias at once.
 */
#include "base/handles.h"

#include <string.h>

#define GENERATION_SHIFT 22
#define GENERATION_LAST 1023u
#define KIND_SHIFT 20
#define INDEX_COUNT (1 << 20)
#define INDEX_MASK 0xFFFFFu
#define ALIVE_BIT (1u << 21)
#define NEXT_MASK 0x1FFFFFu

static uint32_t *slots_of(const cni_handles *handles) { return handles->slots.data; }
static cni_alias *aliases_of(const cni_handles *handles) { return handles->aliases.data; }
static int32_t *alias_of(const cni_handles *handles) { return handles->alias_of.data; }

void cni_handles_init(cni_handles *handles, int32_t kind)
{
	CNI_ASSERT(kind >= 0 && kind <= 3);
	cni_array_init(&handles->slots, (int32_t)sizeof(uint32_t));
	cni_array_init(&handles->aliases, (int32_t)sizeof(cni_alias));
	cni_array_init(&handles->alias_of, (int32_t)sizeof(int32_t));
	handles->kind = kind;
	handles->count = 0;
	handles->free_first = CNI_NONE;
	handles->free_last = CNI_NONE;
	handles->worn = 0;
	handles->alias_next = INDEX_COUNT;
}

void cni_handles_deinit(cni_handles *handles, cni_memory *memory)
{
	cni_array_deinit(&handles->slots, memory);
	cni_array_deinit(&handles->aliases, memory);
	cni_array_deinit(&handles->alias_of, memory);
	cni_handles_init(handles, handles->kind);
}

/* ---- aliases ---- */

/* The first alias at or behind an index. */
static int32_t alias_from(const cni_handles *handles, int32_t index)
{
	int32_t low = 0, high = handles->aliases.count;

	while (low < high) {
		int32_t middle = low + (high - low) / 2;

		if (aliases_of(handles)[middle].index < index)
			low = middle + 1;
		else
			high = middle;
	}
	return low;
}

static int32_t alias_is_given(const cni_handles *handles, int32_t index)
{
	int32_t k = alias_from(handles, index);

	return k < handles->aliases.count && aliases_of(handles)[k].index == index;
}

/* The index that a live slot goes by. */
static int32_t index_of(const cni_handles *handles, int32_t slot)
{
	int32_t alias = handles->alias_of.count > 0 ? alias_of(handles)[slot] : 0;

	return alias != 0 ? alias : slot;
}

static void alias_remove(cni_handles *handles, int32_t slot)
{
	int32_t k = alias_of(handles)[slot] == 0 ? CNI_NONE : alias_from(handles, alias_of(handles)[slot]);

	if (k == CNI_NONE)
		return;
	handles->aliases.count -= 1;
	memmove(aliases_of(handles) + k, aliases_of(handles) + k + 1, (size_t)(handles->aliases.count - k) * sizeof(cni_alias));
	alias_of(handles)[slot] = 0;
}

/* Behind all slots, downwards, from the end again when they are used up; CNI_NONE: there are none. */
static int32_t alias_behind_slots(cni_handles *handles)
{
	int32_t tries;

	for (tries = handles->aliases.count + 2; tries > 0; --tries) {
		if (handles->alias_next <= handles->slots.count)
			handles->alias_next = INDEX_COUNT;
		if (handles->alias_next <= handles->slots.count)
			return CNI_NONE;
		handles->alias_next -= 1;
		if (!alias_is_given(handles, handles->alias_next))
			return handles->alias_next;
	}
	return CNI_NONE;
}

/* An index that no slot goes by; CNI_NONE: the slot's own. With a million slots it may be another slot's own, of which there is one
   more than slots. */
static int32_t alias_choose(cni_handles *handles, int32_t slot)
{
	int32_t index = alias_behind_slots(handles);

	if (index != CNI_NONE || !alias_is_given(handles, slot))
		return index;
	for (index = INDEX_COUNT - 1; index > 0; --index)
		if (!alias_is_given(handles, index) && (index >= handles->slots.count || alias_of(handles)[index] != 0))
			break;
	return index;
}

/* Another index for a slot that has worn out the one it had. */
static void alias_give(cni_handles *handles, int32_t slot)
{
	cni_alias alias;
	int32_t k;

	while (handles->alias_of.count < handles->slots.count)
		alias_of(handles)[handles->alias_of.count++] = 0;
	alias_remove(handles, slot);
	alias.index = alias_choose(handles, slot);
	alias.slot = slot;
	if (alias.index == CNI_NONE)
		return;
	k = alias_from(handles, alias.index);
	memmove(aliases_of(handles) + k + 1, aliases_of(handles) + k, (size_t)(handles->aliases.count - k) * sizeof(cni_alias));
	aliases_of(handles)[k] = alias;
	handles->aliases.count += 1;
	alias_of(handles)[slot] = alias.index;
}

/* ---- room ---- */

int32_t cni_handles_reserve_aliases(cni_handles *handles, cni_memory *memory, int32_t slots)
{
	return cni_array_reserve(&handles->aliases, memory, slots) && cni_array_reserve(&handles->alias_of, memory, slots);
}

/* Once there are aliases, every slot has room for one. */
static int32_t aliases_wanted(const cni_handles *handles, int32_t slots)
{
	return handles->worn > 0 || handles->alias_of.count > 0 || slots > handles->alias_next;
}

cn_result cni_handles_reserve(cni_handles *handles, cni_memory *memory, int32_t extra)
{
	int32_t used = handles->slots.count;
	int32_t queued = used - handles->count;
	int32_t slots = used;

	if (extra - queued > CN_MAX_HANDLES - used)
		return CN_ERROR_CAPACITY;
	if (extra > queued)
		slots += extra - queued;
	if (!cni_array_reserve(&handles->slots, memory, slots))
		return CN_ERROR_MEMORY;
	return !aliases_wanted(handles, slots) || cni_handles_reserve_aliases(handles, memory, slots) ? CN_OK : CN_ERROR_MEMORY;
}

/* ---- slots ---- */

int32_t cni_handles_peek(const cni_handles *handles)
{
	return handles->free_first != CNI_NONE ? handles->free_first : handles->slots.count;
}

static void queue_remove_first(cni_handles *handles)
{
	handles->free_first = (int32_t)(slots_of(handles)[handles->free_first] & NEXT_MASK) - 1;
	if (handles->free_first == CNI_NONE)
		handles->free_last = CNI_NONE;
}

static void queue_append(cni_handles *handles, int32_t slot)
{
	if (handles->free_last == CNI_NONE)
		handles->free_first = slot;
	else
		slots_of(handles)[handles->free_last] |= (uint32_t)(slot + 1);
	handles->free_last = slot;
}

/* A new slot. Its own index may have been an alias already. */
static uint32_t slot_new(cni_handles *handles, int32_t slot)
{
	handles->slots.count += 1;
	if (handles->alias_of.count > 0)
		alias_of(handles)[handles->alias_of.count++] = 0;
	if (slot < handles->alias_next && !alias_is_given(handles, slot))
		return (uint32_t)1 << GENERATION_SHIFT;
	handles->worn += 1;
	return 0;
}

int32_t cni_handles_take(cni_handles *handles)
{
	int32_t slot = cni_handles_peek(handles);
	uint32_t *word = slots_of(handles) + slot;

	CNI_ASSERT(slot < handles->slots.capacity && slot < CN_MAX_HANDLES);
	if (slot == handles->slots.count)
		*word = slot_new(handles, slot);
	else
		queue_remove_first(handles);
	if (*word >> GENERATION_SHIFT == 0) {
		handles->worn -= 1;
		alias_give(handles, slot);
		*word = (uint32_t)1 << GENERATION_SHIFT;
	}
	*word = (*word & ~NEXT_MASK) | ALIVE_BIT;
	handles->count += 1;
	return slot;
}

void cni_handles_release(cni_handles *handles, int32_t slot)
{
	uint32_t *word = slots_of(handles) + slot;
	uint32_t generation = *word >> GENERATION_SHIFT;

	CNI_ASSERT(cni_handles_alive(handles, slot));
	handles->count -= 1;
	handles->worn += generation == GENERATION_LAST;
	*word = generation == GENERATION_LAST ? 0 : (generation + 1) << GENERATION_SHIFT;
	queue_append(handles, slot);
}

int32_t cni_handles_find(const cni_handles *handles, uint32_t handle)
{
	int32_t slot = (int32_t)(handle & INDEX_MASK);
	uint32_t kind = (handle >> KIND_SHIFT) & 3u;
	uint32_t word;

	if (kind != (uint32_t)handles->kind)
		return CNI_NONE;
	if (slot >= handles->slots.count || index_of(handles, slot) != slot) {
		int32_t k = alias_from(handles, slot);

		if (k == handles->aliases.count || aliases_of(handles)[k].index != slot)
			return CNI_NONE;
		slot = aliases_of(handles)[k].slot;
	}
	word = slots_of(handles)[slot];
	return (word & ALIVE_BIT) && word >> GENERATION_SHIFT == handle >> GENERATION_SHIFT ? slot : CNI_NONE;
}

uint32_t cni_handles_of(const cni_handles *handles, int32_t slot)
{
	uint32_t generation;

	CNI_ASSERT(cni_handles_alive(handles, slot));
	generation = slots_of(handles)[slot] >> GENERATION_SHIFT;
	return generation << GENERATION_SHIFT | (uint32_t)handles->kind << KIND_SHIFT | (uint32_t)index_of(handles, slot);
}

int32_t cni_handles_alive(const cni_handles *handles, int32_t slot)
{
	return slot >= 0 && slot < handles->slots.count && (slots_of(handles)[slot] & ALIVE_BIT) != 0;
}

int32_t cni_handles_used(const cni_handles *handles)
{
	return handles->slots.count;
}
