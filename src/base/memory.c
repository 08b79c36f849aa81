/*
 * base/memory.c - owns the hooks and the holes of a fixed block; reads and writes nothing else.
 *
 * Fixed block: first fit over an address-ordered list of holes, neighbours coalesced on free (Knuth, The Art of Computer
 * Programming 1, 1968, section 2.5, algorithms A and B). Every size is a multiple of 64, so that a hole always has room for
 * its node and every piece starts on a cache line.
 *
 * Invariant: holes are in rising address order and no two of them touch.
 */
#include "base/memory.h"

#include <string.h>

#ifndef CN_NO_MALLOC
#include <stdlib.h>
#endif

struct cni_hole {
	cni_hole *next;
	uint64_t bytes;
};

uint64_t cni_memory_rounded(uint64_t bytes)
{
	uint64_t mask = CNI_MEMORY_ALIGN - 1;
	return bytes > UINT64_MAX - mask ? UINT64_MAX - mask : (bytes + mask) & ~mask;
}

#ifndef CN_NO_MALLOC

/* C99 has no aligned allocation: takes more and stores malloc's pointer just below the aligned piece. */
static void *heap_alloc(uint64_t bytes, uint32_t align, void *user)
{
	uint64_t spare = align - 1 + sizeof(void *);
	(void)user;
	if (bytes > SIZE_MAX - spare)
		return NULL;
	uint8_t *raw = (uint8_t *)malloc((size_t)(bytes + spare));
	if (raw == NULL)
		return NULL;
	uint8_t *aligned = raw + sizeof(void *);
	aligned += (align - (uintptr_t)aligned % align) % align;
	((void **)(void *)aligned)[-1] = raw;
	return aligned;
}

static void heap_free(void *memory, uint64_t bytes, void *user)
{
	(void)bytes;
	(void)user;
	free(((void **)memory)[-1]);
}

#endif

void cni_memory_init_hooks(cni_memory *memory, cn_alloc_fn *alloc, cn_free_fn *free_hook, void *user)
{
	CNI_ASSERT((alloc == NULL) == (free_hook == NULL));
	memset(memory, 0, sizeof *memory);
	memory->alloc = alloc;
	memory->free = free_hook;
	memory->user = user;
#ifndef CN_NO_MALLOC
	if (alloc == NULL) {
		memory->alloc = heap_alloc;
		memory->free = heap_free;
	}
#endif
}

void cni_memory_init_block(cni_memory *memory, void *block, uint64_t bytes)
{
	CNI_ASSERT((uintptr_t)block % CNI_MEMORY_ALIGN == 0);
	memset(memory, 0, sizeof *memory);
	memory->fixed = 1;
	if (bytes >= CNI_MEMORY_ALIGN) {
		memory->holes = (cni_hole *)block;
		memory->holes->next = NULL;
		memory->holes->bytes = bytes - bytes % CNI_MEMORY_ALIGN;
	}
}

/* Takes the low end of the first hole that is large enough. */
static void *block_alloc(cni_memory *memory, uint64_t bytes)
{
	cni_hole **link = &memory->holes;
	while (*link != NULL && (*link)->bytes < bytes)
		link = &(*link)->next;
	cni_hole *hole = *link;
	if (hole == NULL)
		return NULL;
	if (hole->bytes == bytes) {
		*link = hole->next;
	} else {
		cni_hole *rest = (cni_hole *)(void *)((uint8_t *)hole + bytes);
		rest->next = hole->next;
		rest->bytes = hole->bytes - bytes;
		*link = rest;
	}
	return hole;
}

static void hole_merge_next(cni_hole *hole)
{
	cni_hole *next = hole->next;
	CNI_ASSERT(next == NULL || (uint8_t *)hole + hole->bytes <= (uint8_t *)next);
	if (next != NULL && (uint8_t *)hole + hole->bytes == (uint8_t *)next) {
		hole->bytes += next->bytes;
		hole->next = next->next;
	}
}

static void block_free(cni_memory *memory, void *pointer, uint64_t bytes)
{
	cni_hole *hole = (cni_hole *)pointer;
	cni_hole *before = NULL;
	cni_hole *after = memory->holes;
	while (after != NULL && (uintptr_t)after < (uintptr_t)hole) {
		before = after;
		after = after->next;
	}
	hole->next = after;
	hole->bytes = bytes;
	hole_merge_next(hole);
	if (before == NULL) {
		memory->holes = hole;
	} else {
		before->next = hole;
		hole_merge_next(before);
	}
}

/* A hook that ignores the alignment would cause faults elsewhere: its piece is freed at once, and the allocation fails. */
static void *hook_alloc(cni_memory *memory, uint64_t bytes)
{
	void *pointer = memory->alloc != NULL ? memory->alloc(bytes, CNI_MEMORY_ALIGN, memory->user) : NULL;
	if (pointer != NULL && (uintptr_t)pointer % CNI_MEMORY_ALIGN != 0) {
		memory->free(pointer, bytes, memory->user);
		pointer = NULL;
	}
	return pointer;
}

void *cni_memory_alloc(cni_memory *memory, uint64_t bytes)
{
	uint64_t taken = memory->fixed ? cni_memory_rounded(bytes) : bytes;
	CNI_ASSERT(bytes > 0);
	memory->calls += 1;
	void *pointer = memory->fixed ? block_alloc(memory, taken) : hook_alloc(memory, taken);
	if (pointer == NULL)
		return NULL;
	memory->bytes_in_use += taken;
	if (memory->bytes_in_use > memory->bytes_peak)
		memory->bytes_peak = memory->bytes_in_use;
	return pointer;
}

void cni_memory_free(cni_memory *memory, void *pointer, uint64_t bytes)
{
	uint64_t taken = memory->fixed ? cni_memory_rounded(bytes) : bytes;
	if (pointer == NULL)
		return;
	CNI_ASSERT(bytes > 0 && memory->bytes_in_use >= taken);
	memory->bytes_in_use -= taken;
	if (memory->fixed)
		block_free(memory, pointer, taken);
	else
		memory->free(pointer, bytes, memory->user);
}
