/*
 * base/arena.h - the frame arena: the stack allocator of the paper (see step/sequential.c). One block with entries in LIFO
 * order. A full block falls back to cni_memory. The step's end resets the arena and grows the block to the high-water mark,
 * so that the steady state never falls back.
 *
 *   block   [ entry 0 | entry 1 | entry 2 |            free            ]
 *   entries { pointer, bytes, fallback? } in a separate array: fallback entries lie outside the block
 *
 * Stages use it for scratch within a step. The stage that pushed an entry pops it, in reverse order. A pop out of order
 * returns 0, changes nothing, and fails an assertion in debug builds.
 */
#ifndef CNI_BASE_ARENA_H
#define CNI_BASE_ARENA_H

#include "base/memory.h"

#define CNI_ARENA_ENTRIES 64

typedef struct cni_arena_entry {
	void *pointer;
	size_t bytes;
	int32_t fallback;
} cni_arena_entry;

typedef struct cni_arena {
	cni_memory *memory;
	uint8_t *block;
	uint64_t capacity;
	uint64_t used;       /* bytes of the block in use */
	uint64_t in_use;     /* bytes of all entries, fallbacks too */
	uint64_t high_water; /* most in_use since creation */
	uint64_t fallbacks;  /* entries served by the fallback since creation */
	int32_t entry_count;
	cni_arena_entry entries[CNI_ARENA_ENTRIES];
} cni_arena;

/* Takes no memory until the first push or reserve. */
void cni_arena_init(cni_arena *arena, cni_memory *memory);
void cni_arena_deinit(cni_arena *arena);
/* Grows the block to at least bytes; the arena must be empty. 0 if there is no memory: the old block stays. */
int32_t cni_arena_reserve(cni_arena *arena, uint64_t bytes);
/* 64-byte aligned scratch, not cleared; bytes may be 0 (gives a valid non-NULL pointer). NULL when neither the block nor the
   fallback has room or all CNI_ARENA_ENTRIES are in use. */
void *cni_arena_push(cni_arena *arena, uint64_t bytes);
/* Pops the latest entry, which pointer must name: returns 1, else 0 without a change. NULL: 1, nothing to pop. */
int32_t cni_arena_pop(cni_arena *arena, void *pointer);
/* Pops all entries and, if the high-water mark is above the capacity, grows the block to it (rounded up to 4 KiB; on failure
   the block stays as it is). */
void cni_arena_reset(cni_arena *arena);

#endif
