/*
 * base/memory.h - the source of all memory of a world: the user's hooks (malloc by default) or one fixed block. Everything
 * else in base/ allocates here. A failed allocation returns NULL and has no other effect.
 *
 * Nothing is read or written outside of a fixed block, and freed memory of it can be used again.
 *
 *   block:  [ free node | free bytes ... ][ allocation ... ][ free node | ... ]
 *           the free list links the holes in address order; allocations have no header because every free
 *           states its size
 */
#ifndef CNI_BASE_MEMORY_H
#define CNI_BASE_MEMORY_H

#include "base/config.h"
#include "cairn.h"

#define CNI_MEMORY_ALIGN 64u

typedef struct cni_hole cni_hole;

typedef struct cni_memory {
	cn_alloc_fn *alloc;
	cn_free_fn *free;
	void *user;
	cni_hole *holes;    /* fixed block only: first hole in address order */
	int32_t fixed;
	uint64_t bytes_in_use;
	uint64_t bytes_peak;
	uint64_t calls;     /* allocations, successful or not */
} cni_memory;

/* alloc and free NULL: aligned malloc; with CN_NO_MALLOC there is then no memory. */
void cni_memory_init_hooks(cni_memory *memory, cn_alloc_fn *alloc, cn_free_fn *free, void *user);
/* block aligned to CNI_MEMORY_ALIGN. */
void cni_memory_init_block(cni_memory *memory, void *block, uint64_t bytes);

/* 64-byte aligned, not cleared, NULL when there is no memory. bytes > 0. In a fixed block every allocation takes
   cni_memory_rounded bytes. */
void *cni_memory_alloc(cni_memory *memory, uint64_t bytes);
/* NULL is allowed. bytes must equal the bytes of the allocation. */
void cni_memory_free(cni_memory *memory, void *pointer, uint64_t bytes);
/* Rounds up to a multiple of 64. */
uint64_t cni_memory_rounded(uint64_t bytes);

#endif
