/*
 * base/handles.c - owns the slots: which index is alive, with which generation, and the queue of free
 * ones.
 *
 *   slot = generation (10 bits) << 22 | alive (1 bit) << 21 | next free index + 1 (21 bits)
 *
 * A free slot already has the generation it will be taken with, so that handing it out is one bit.
 * A retired slot has neither the alive bit nor a place in the queue.
 *
 * Invariant: slots = alive + queued + retired.
 */
#include "base/handles.h"

#define GENERATION_SHIFT 22
#define GENERATION_LAST 1023u
#define KIND_SHIFT 20
#define INDEX_MASK 0xFFFFFu
#define ALIVE_BIT (1u << 21)
#define NEXT_MASK 0x1FFFFFu

static uint32_t *slots_of(const cni_handles *handles)
{
	return handles->slots.data;
}

void cni_handles_init(cni_handles *handles, int32_t kind)
{
	CNI_ASSERT(kind >= 0 && kind <= 3);
	cni_array_init(&handles->slots, (int32_t)sizeof(uint32_t));
	handles->kind = kind;
	handles->count = 0;
	handles->free_first = CNI_NONE;
	handles->free_last = CNI_NONE;
	handles->retired = 0;
}

void cni_handles_deinit(cni_handles *handles, cni_memory *memory)
{
	cni_array_deinit(&handles->slots, memory);
	cni_handles_init(handles, handles->kind);
}

cn_result cni_handles_reserve(cni_handles *handles, cni_memory *memory, int32_t extra)
{
	int32_t used = handles->slots.count;
	int32_t queued = used - handles->count - handles->retired;

	if (extra <= queued)
		return CN_OK;
	if (extra - queued > CN_MAX_HANDLES - used)
		return CN_ERROR_CAPACITY;
	return cni_array_reserve(&handles->slots, memory, used + extra - queued) ? CN_OK : CN_ERROR_MEMORY;
}

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

static void queue_append(cni_handles *handles, int32_t index)
{
	if (handles->free_last == CNI_NONE)
		handles->free_first = index;
	else
		slots_of(handles)[handles->free_last] |= (uint32_t)(index + 1);
	handles->free_last = index;
}

int32_t cni_handles_take(cni_handles *handles)
{
	int32_t index = cni_handles_peek(handles);
	uint32_t *slot = slots_of(handles) + index;

	CNI_ASSERT(index < handles->slots.capacity && index < CN_MAX_HANDLES);
	if (index == handles->slots.count) {
		handles->slots.count += 1;
		*slot = (uint32_t)1 << GENERATION_SHIFT;
	} else {
		queue_remove_first(handles);
	}
	*slot = (*slot & ~NEXT_MASK) | ALIVE_BIT;
	handles->count += 1;
	return index;
}

void cni_handles_release(cni_handles *handles, int32_t index)
{
	uint32_t *slot = slots_of(handles) + index;
	uint32_t generation = *slot >> GENERATION_SHIFT;

	CNI_ASSERT(cni_handles_alive(handles, index));
	handles->count -= 1;
	if (generation == GENERATION_LAST) {
		*slot = generation << GENERATION_SHIFT;
		handles->retired += 1;
	} else {
		*slot = (generation + 1) << GENERATION_SHIFT;
		queue_append(handles, index);
	}
}

int32_t cni_handles_find(const cni_handles *handles, uint32_t handle)
{
	int32_t index = (int32_t)(handle & INDEX_MASK);
	uint32_t kind = (handle >> KIND_SHIFT) & 3u;
	uint32_t slot;

	if (kind != (uint32_t)handles->kind || index >= handles->slots.count)
		return CNI_NONE;
	slot = slots_of(handles)[index];
	return (slot & ALIVE_BIT) && slot >> GENERATION_SHIFT == handle >> GENERATION_SHIFT ? index : CNI_NONE;
}

uint32_t cni_handles_of(const cni_handles *handles, int32_t index)
{
	uint32_t generation;

	CNI_ASSERT(cni_handles_alive(handles, index));
	generation = slots_of(handles)[index] >> GENERATION_SHIFT;
	return generation << GENERATION_SHIFT | (uint32_t)handles->kind << KIND_SHIFT | (uint32_t)index;
}

int32_t cni_handles_alive(const cni_handles *handles, int32_t index)
{
	return index >= 0 && index < handles->slots.count && (slots_of(handles)[index] & ALIVE_BIT) != 0;
}

int32_t cni_handles_used(const cni_handles *handles)
{
	return handles->slots.count;
}
