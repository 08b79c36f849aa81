/*
 * base/arena.c - owns one block and the entries pushed on it: the stack allocator of the frame.
 *
 * Every entry takes a multiple of 64 bytes, so that entries stay aligned and a block of the high-water mark's size fits the
 * same pushes without a fallback.
 *
 * Invariant: used is the sum of the entries in the block, in_use the sum of all entries; entries lie in the block in push
 * order without gaps.
 */
#include "base/arena.h"

#include <string.h>

#define ARENA_GROWTH_BYTES 4096u

void cni_arena_init(cni_arena *arena, cni_memory *memory)
{
	memset(arena, 0, sizeof *arena);
	arena->memory = memory;
}

static void arena_pop_last(cni_arena *arena)
{
	cni_arena_entry *entry = &arena->entries[arena->entry_count - 1];
	if (entry->fallback)
		cni_memory_free(arena->memory, entry->pointer, entry->bytes);
	else
		arena->used -= entry->bytes;
	arena->in_use -= entry->bytes;
	arena->entry_count -= 1;
}

static void arena_pop_all(cni_arena *arena)
{
	while (arena->entry_count > 0)
		arena_pop_last(arena);
	CNI_ASSERT(arena->used == 0 && arena->in_use == 0);
}

void cni_arena_deinit(cni_arena *arena)
{
	arena_pop_all(arena);
	cni_memory_free(arena->memory, arena->block, arena->capacity);
	cni_arena_init(arena, arena->memory);
}

int32_t cni_arena_reserve(cni_arena *arena, uint64_t bytes)
{
	uint64_t capacity = cni_memory_rounded(bytes);
	if (capacity <= arena->capacity)
		return 1;
	CNI_ASSERT(arena->entry_count == 0);
	void *block = cni_memory_alloc(arena->memory, capacity);
	if (block == NULL)
		return 0;
	cni_memory_free(arena->memory, arena->block, arena->capacity);
	arena->block = (uint8_t *)block;
	arena->capacity = capacity;
	return 1;
}

void *cni_arena_push(cni_arena *arena, uint64_t bytes)
{
	/* An empty entry takes 64 bytes too: its pointer must differ from the entry below. */
	uint64_t taken = cni_memory_rounded(bytes > 0 ? bytes : 1);
	int32_t fallback = taken > arena->capacity - arena->used;
	if (arena->entry_count == CNI_ARENA_ENTRIES)
		return NULL;
	void *pointer = fallback ? cni_memory_alloc(arena->memory, taken) : arena->block + arena->used;
	if (pointer == NULL)
		return NULL;
	cni_arena_entry *entry = &arena->entries[arena->entry_count++];
	entry->pointer = pointer;
	entry->bytes = (size_t)taken;
	entry->fallback = fallback;
	if (fallback)
		arena->fallbacks += 1;
	else
		arena->used += taken;
	arena->in_use += taken;
	if (arena->in_use > arena->high_water)
		arena->high_water = arena->in_use;
	return pointer;
}

int32_t cni_arena_pop(cni_arena *arena, void *pointer)
{
	if (pointer == NULL)
		return 1;
	int32_t is_last = arena->entry_count > 0 && arena->entries[arena->entry_count - 1].pointer == pointer;
	CNI_ASSERT(is_last);
	if (is_last)
		arena_pop_last(arena);
	return is_last;
}

void cni_arena_reset(cni_arena *arena)
{
	uint64_t growth = ARENA_GROWTH_BYTES;
	arena_pop_all(arena);
	if (arena->high_water > arena->capacity)
		(void)cni_arena_reserve(arena, (arena->high_water + growth - 1) / growth * growth);
}
