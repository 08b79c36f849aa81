/*
 * base/blocks.h - small pieces of variable size that live across steps: the paper's block allocator.
 * An array of size classes, each a free list carved from chunks; the best fitting class serves a
 * request; above the largest class a piece gets a chunk of its own from the memory below.
 *
 * Pieces are named by 32-bit references, never by pointers, so that persistent state can be copied:
 *
 *   ref = chunk << 12 | unit      unit = 16 bytes, a chunk of the classes is 4096 units = 64 KiB at
 *                                 most (the first chunks are smaller, see blocks.c)
 *   classes (bytes): 16 32 48 64 96 128 192 256 384 512 768 1024 1536 2048 4096
 *
 * ref 0 is never handed out. A piece's address is fixed while it lives. 16-byte aligned.
 */
#ifndef CNI_BASE_BLOCKS_H
#define CNI_BASE_BLOCKS_H

#include "base/memory.h"

#define CNI_BLOCK_CLASSES 15
#define CNI_BLOCK_UNIT 16u
#define CNI_BLOCK_LARGEST 4096u

typedef uint32_t cni_ref;

typedef struct cni_blocks {
	cni_memory *memory;
	uint8_t **chunks;         /* address of each chunk, NULL where a large piece was freed */
	uint64_t *chunk_bytes;
	int32_t chunk_count;
	int32_t chunk_capacity;
	cni_ref free_head[CNI_BLOCK_CLASSES]; /* next ref is stored in the first 4 bytes of a free piece */
	int32_t free_count[CNI_BLOCK_CLASSES];
	int32_t empty_slot;       /* first chunk index that a freed large piece left behind, 0 for none */
	cni_ref tail;             /* the part of the newest class chunk that was never carved */
	uint32_t tail_units;
	uint32_t reserved;
	uint64_t bytes_in_chunks; /* class chunks */
	uint64_t bytes_in_use;    /* rounded to the class */
	uint64_t bytes_large;
	/* The chunks of a state that is about to be loaded: base/snapshot.c. */
	uint64_t *next_bytes;
	uint8_t **next_chunks;
	int32_t next_count;
	int32_t next_capacity;    /* 0: there is none, or next_count is 0 too */
	int32_t next_waits;       /* 1: there is one */
	int32_t next_reserved;
} cni_blocks;

void cni_blocks_init(cni_blocks *blocks, cni_memory *memory);
void cni_blocks_deinit(cni_blocks *blocks);
/* Not cleared. 0 when there is no memory. bytes > 0. */
cni_ref cni_blocks_alloc(cni_blocks *blocks, uint64_t bytes);
/* ref 0 is allowed. bytes must be what was asked for. */
void cni_blocks_free(cni_blocks *blocks, cni_ref ref, uint64_t bytes);
/* Carves free pieces until at least count pieces of this size are free; 0 if there is no memory.
   bytes <= CNI_BLOCK_LARGEST. */
int32_t cni_blocks_reserve(cni_blocks *blocks, uint64_t bytes, int32_t count);
/* What a piece of this size really takes. */
uint64_t cni_blocks_rounded(uint64_t bytes);

/* A table of count chunks beside the present one, empty at first; 0: no memory. */
int32_t cni_blocks_next_begin(cni_blocks *blocks, int32_t count);
/* Its chunk of an index: the present one if that has the size, else a new one; 0 bytes: none. Returns 0: no memory. */
int32_t cni_blocks_next_set(cni_blocks *blocks, int32_t slot, uint64_t bytes);
/* It becomes the table, if there is one: chunks that are not in it are given back. Or it is given up. */
void cni_blocks_next_take(cni_blocks *blocks);
void cni_blocks_next_drop(cni_blocks *blocks);

static inline void *cni_blocks_at(const cni_blocks *blocks, cni_ref ref)
{
	return blocks->chunks[ref >> 12] + (size_t)(ref & 4095u) * CNI_BLOCK_UNIT;
}

#endif
