/*
 * base/handles.c - owns the slots: which is alive, with which generation and under which index, and the queue of free ones.
 *
 *   alive   generation (10 bits) << 22 | 1 (1 bit) << 21 | alias (21 bits), 0: it goes by its own index
 *   free    generation (10 bits) << 22 | 0 (1 bit) << 21 | next free slot + 1 (21 bits)
 *
 * A free slot already has the generation it will be taken with; but one that has worn out its index has 0, and gets
 * an alias when it is taken. That happens once in 1023 lives of a slot, so two sorted lists of aliases will do.
 *
 * Invariants: slots = alive + queued. No slot's own index is an alias: a new slot whose index has been given as one gets an
 * alias at once.
 */
#include "base/handles.h"
#include "base/maths.h"

#include <string.h>

#define GENERATION_LAST 1023u
#define INDEX_COUNT (1 << 20)
#define NEXT_MASK 0x1FFFFFu

static uint32_t *slots_of(const cni_handles *handles) { return (uint32_t *)handles->slots.data; }

void cni_handles_init(cni_handles *handles, int32_t kind)
{
	CNI_ASSERT(kind >= 0 && kind <= 3);
	memset(handles, 0, sizeof *handles);
	cni_array_init(&handles->slots, (int32_t)sizeof(uint32_t));
	cni_array_init(&handles->aliases, (int32_t)sizeof(cni_alias));
	cni_array_init(&handles->by_slot, (int32_t)sizeof(cni_alias));
	handles->kind = kind;
	handles->free_first = handles->free_last = CNI_NONE;
	handles->alias_next = INDEX_COUNT;
}

void cni_handles_deinit(cni_handles *handles, cni_memory *memory)
{
	cni_array_deinit(&handles->slots, memory);
	cni_array_deinit(&handles->aliases, memory);
	cni_array_deinit(&handles->by_slot, memory);
	cni_handles_init(handles, handles->kind);
}

/* ---- aliases ---- */

static int32_t key_of(const cni_alias *alias, int32_t by_slot) { return by_slot ? alias->slot : alias->index; }

/* The first of a list at or behind an index or a slot. */
static int32_t list_from(const cni_array *list, int32_t by_slot, int32_t key)
{
	int32_t low = 0, high = list->count;
	while (low < high) {
		int32_t middle = low + (high - low) / 2;
		if (key_of((const cni_alias *)list->data + middle, by_slot) < key)
			low = middle + 1;
		else
			high = middle;
	}
	return low;
}

static void list_insert(cni_array *list, int32_t by_slot, const cni_alias *alias)
{
	int32_t k = list_from(list, by_slot, key_of(alias, by_slot));
	cni_alias *at = (cni_alias *)list->data + k;
	CNI_ASSERT(list->count < list->capacity);
	memmove(at + 1, at, (size_t)(list->count - k) * sizeof *at);
	*at = *alias;
	list->count += 1;
}

static void list_remove(cni_array *list, int32_t by_slot, int32_t key)
{
	int32_t k = list_from(list, by_slot, key);
	cni_alias *at = (cni_alias *)list->data + k;
	list->count -= 1;
	memmove(at, at + 1, (size_t)(list->count - k) * sizeof *at);
}

/* Who goes by an index, if it is an alias, or the alias of a slot; NULL: none. */
static const cni_alias *alias_find(const cni_array *list, int32_t by_slot, int32_t key)
{
	int32_t k = list_from(list, by_slot, key);
	const cni_alias *at = (const cni_alias *)list->data;
	return k < list->count && key_of(at + k, by_slot) == key ? at + k : NULL;
}

static int32_t alias_is_given(const cni_handles *handles, int32_t index) { return alias_find(&handles->aliases, 0, index) != NULL; }

int32_t cni_handles_alias_of(const cni_handles *handles, int32_t slot)
{
	const cni_alias *alias = alias_find(&handles->by_slot, 1, slot);
	return alias != NULL ? alias->index : 0;
}

/* The index that a live slot goes by. */
static int32_t index_of(const cni_handles *handles, int32_t slot)
{
	int32_t alias = (int32_t)(slots_of(handles)[slot] & NEXT_MASK);
	return alias != 0 ? alias : slot;
}

/* Behind all slots, downwards, from the end again when they are used up; CNI_NONE: there are none. */
static int32_t alias_behind_slots(cni_handles *handles)
{
	for (int32_t tries = handles->aliases.count + 2; tries > 0; --tries) {
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
		if (!alias_is_given(handles, index) && (index >= handles->slots.count || cni_handles_alias_of(handles, index) != 0))
			break;
	return index;
}

/* Another index for a slot that has worn out the one it had. */
static void alias_give(cni_handles *handles, int32_t slot)
{
	int32_t old = cni_handles_alias_of(handles, slot);
	cni_alias alias;
	if (old != 0) {
		list_remove(&handles->aliases, 0, old);
		list_remove(&handles->by_slot, 1, slot);
	}
	alias.index = alias_choose(handles, slot);
	alias.slot = slot;
	if (alias.index == CNI_NONE)
		return;
	list_insert(&handles->aliases, 0, &alias);
	list_insert(&handles->by_slot, 1, &alias);
}

/* ---- room ---- */

int32_t cni_handles_reserve_aliases(cni_handles *handles, cni_memory *memory, int32_t slots)
{
	return cni_array_reserve(&handles->aliases, memory, slots) && cni_array_reserve(&handles->by_slot, memory, slots);
}

/* Of the slots that there are and those that wait for one; new slots need one where their index may have been given. */
static int32_t aliases_wanted(const cni_handles *handles, int32_t slots)
{
	int32_t there = handles->aliases.count + handles->worn;
	return there > 0 || slots > handles->alias_next ? there + slots - handles->slots.count : 0;
}

cn_result cni_handles_reserve(cni_handles *handles, cni_memory *memory, int32_t extra)
{
	int32_t used = handles->slots.count, lacking = cni_max_i(extra - (used - handles->count), 0), good;
	if (lacking > CN_MAX_HANDLES - used)
		return CN_ERROR_CAPACITY;
	good = cni_array_reserve(&handles->slots, memory, used + lacking) && cni_handles_reserve_aliases(handles, memory, aliases_wanted(handles, used + lacking));
	return good ? CN_OK : CN_ERROR_MEMORY;
}

/* ---- slots ---- */

int32_t cni_handles_peek(const cni_handles *handles)
{
	return handles->free_first != CNI_NONE ? handles->free_first : handles->slots.count;
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
	if (slot < handles->alias_next && !alias_is_given(handles, slot))
		return (uint32_t)1 << CNI_HANDLE_GENERATION_SHIFT;
	handles->worn += 1;
	return 0;
}

int32_t cni_handles_take(cni_handles *handles)
{
	int32_t slot = cni_handles_peek(handles);
	uint32_t *word = slots_of(handles) + slot;
	CNI_ASSERT(slot < handles->slots.capacity && slot < CN_MAX_HANDLES);
	if (slot == handles->slots.count) {
		*word = slot_new(handles, slot);
	} else {
		handles->free_first = (int32_t)(*word & NEXT_MASK) - 1;
		handles->free_last = handles->free_first != CNI_NONE ? handles->free_last : CNI_NONE;
	}
	if (*word >> CNI_HANDLE_GENERATION_SHIFT == 0) {
		handles->worn -= 1;
		alias_give(handles, slot);
		*word = (uint32_t)1 << CNI_HANDLE_GENERATION_SHIFT;
	}
	*word = (*word & ~NEXT_MASK) | CNI_HANDLE_ALIVE_BIT | (uint32_t)cni_handles_alias_of(handles, slot);
	handles->count += 1;
	return slot;
}

void cni_handles_release(cni_handles *handles, int32_t slot)
{
	uint32_t *word = slots_of(handles) + slot;
	uint32_t generation = *word >> CNI_HANDLE_GENERATION_SHIFT;
	CNI_ASSERT(cni_handles_alive(handles, slot));
	handles->count -= 1;
	handles->worn += generation == GENERATION_LAST;
	*word = generation == GENERATION_LAST ? 0 : (generation + 1) << CNI_HANDLE_GENERATION_SHIFT;
	queue_append(handles, slot);
}

int32_t cni_handles_find_alias(const cni_handles *handles, uint32_t handle)
{
	int32_t slot = (int32_t)(handle & CNI_HANDLE_INDEX_MASK);
	uint32_t kind = (handle >> CNI_HANDLE_KIND_SHIFT) & 3u;
	const cni_alias *alias = alias_find(&handles->aliases, 0, slot);
	if (kind != (uint32_t)handles->kind)
		return CNI_NONE;
	if (alias == NULL && slot < handles->slots.count && cni_handles_alive(handles, slot) && index_of(handles, slot) != slot)
		return CNI_NONE;
	slot = alias != NULL ? alias->slot : slot;
	if (slot >= handles->slots.count)
		return CNI_NONE;
	uint32_t word = slots_of(handles)[slot];
	return (word & CNI_HANDLE_ALIVE_BIT) && word >> CNI_HANDLE_GENERATION_SHIFT == handle >> CNI_HANDLE_GENERATION_SHIFT ? slot : CNI_NONE;
}

/* Without a branch per handle, so that the reads overlap. Slot 0 stands for indices behind the end. */
static int32_t own_find_all(const cni_handles *handles, const uint32_t *list, int32_t count)
{
	const uint32_t *slots = slots_of(handles);
	uint32_t used = (uint32_t)handles->slots.count, kind = (uint32_t)handles->kind << CNI_HANDLE_KIND_SHIFT, wrong = 0;
	for (int32_t k = 0; k < count; ++k) {
		uint32_t handle = list[k], index = handle & CNI_HANDLE_INDEX_MASK, within = index < used;
		wrong |= (slots[within ? index : 0] ^ cni_handles_word(handle)) | ((handle ^ kind) & 3u << CNI_HANDLE_KIND_SHIFT) | !within;
	}
	return wrong == 0;
}

int32_t cni_handles_find_all(const cni_handles *handles, const uint32_t *list, int32_t count)
{
	if (handles->aliases.count == 0 && handles->slots.count > 0)
		return own_find_all(handles, list, count);
	for (int32_t k = 0; k < count; ++k)
		if (cni_handles_find(handles, list[k]) == CNI_NONE)
			return 0;
	return 1;
}

uint32_t cni_handles_of(const cni_handles *handles, int32_t slot)
{
	CNI_ASSERT(cni_handles_alive(handles, slot));
	uint32_t generation = slots_of(handles)[slot] >> CNI_HANDLE_GENERATION_SHIFT;
	return generation << CNI_HANDLE_GENERATION_SHIFT | (uint32_t)handles->kind << CNI_HANDLE_KIND_SHIFT | (uint32_t)index_of(handles, slot);
}

int32_t cni_handles_alive(const cni_handles *handles, int32_t slot)
{
	return slot >= 0 && slot < handles->slots.count && (slots_of(handles)[slot] & CNI_HANDLE_ALIVE_BIT) != 0;
}
