/*
 * base/blocks.h - small pieces of variable size that live across steps: the block allocator of the paper (see
 * step/sequential.c). An array of size classes, each with a free list of pieces carved from chunks; the best fitting class
 * serves a request. A piece above the largest class gets its own chunk from cni_memory.
 *
 * Pieces are named by 32-bit references, never by pointers, so that persistent state can be copied:
 *
 *   ref = chunk << 12 | unit      unit = 16 bytes, a chunk of the classes is 4096 units = 64 KiB at
 *                                 most (the first chunks are smaller, see blocks.c)
 *   classes (bytes): 16 32 48 64 96 128 192 256 384 512 768 1024 1536 2048 4096
 *
 * ref 0 is never returned for a piece. A piece's address is fixed while it lives. 16-byte aligned.
 */
#ifndef CNI_BASE_BLOCKS_H
#define CNI_BASE_BLOCKS_H

#include "base/memory.h"

#define CNI_BLOCK_CLASSES 15
#define CNI_BLOCK_UNIT 16u
#define CNI_BLOCK_LARGEST 4096u

typedef uint32_t cni_ref;

typedef struct cni_chunks {
	uint8_t **at;             /* address of each chunk, NULL where a large piece was freed */
	uint64_t *bytes;
	int32_t count;
	int32_t capacity;
} cni_chunks;

typedef struct cni_blocks {
	cni_memory *memory;
	cni_chunks chunks;
	cni_ref free_head[CNI_BLOCK_CLASSES]; /* next ref is stored in the first 4 bytes of a free piece */
	int32_t free_count[CNI_BLOCK_CLASSES];
	int32_t empty_slot;       /* first chunk index of a freed large piece, 0 for none */
	cni_ref tail;             /* begin of the part of the newest class chunk that is not carved yet */
	uint32_t tail_units;
	uint32_t reserved;
	uint64_t bytes_in_chunks; /* class chunks */
	uint64_t bytes_in_use;    /* pieces, rounded up to their class */
	uint64_t bytes_large;
	/* The members from free_head to here are saved. */
	cni_chunks next;          /* of a state that is about to be loaded: base/snapshot.c */
	int32_t next_waits;       /* 1: there is such a table */
} cni_blocks;

void cni_blocks_init(cni_blocks *blocks, cni_memory *memory);
void cni_blocks_deinit(cni_blocks *blocks);
/* Not cleared. 0 when there is no memory. bytes > 0. */
cni_ref cni_blocks_alloc(cni_blocks *blocks, uint64_t bytes);
/* ref 0 is allowed. bytes must equal the bytes of the allocation. */
void cni_blocks_free(cni_blocks *blocks, cni_ref ref, uint64_t bytes);
/* Carves free pieces until at least count pieces of this size are free; 0 if there is no memory.
   bytes <= CNI_BLOCK_LARGEST. */
int32_t cni_blocks_reserve(cni_blocks *blocks, uint64_t bytes, int32_t count);
/* Pieces of one size. */
typedef struct cni_pieces {
	uint64_t bytes;
	int32_t count;
} cni_pieces;

/* Carves these pieces in blocks that are still empty, without spare room. */
int32_t cni_blocks_reserve_exact(cni_blocks *blocks, const cni_pieces *pieces, int32_t kinds);
/* The most memory that it takes, with the table of chunks. */
uint64_t cni_blocks_bytes_for(const cni_pieces *pieces, int32_t kinds);
/* The bytes that a piece of this size takes. */
uint64_t cni_blocks_rounded(uint64_t bytes);

/* Makes a second, empty table of count chunks, the next table; 0: no memory. */
int32_t cni_blocks_next_begin(cni_blocks *blocks, int32_t count);
/* Sets a chunk of the next table: the present chunk of that index if it has this size, else a new one; 0 bytes: no chunk.
   Returns 0: no memory. */
int32_t cni_blocks_next_set(cni_blocks *blocks, int32_t slot, uint64_t bytes);
/* take: the next table, if there is one, replaces the present one, and chunks that are not in it are freed. drop: frees the
   next table. */
void cni_blocks_next_take(cni_blocks *blocks);
void cni_blocks_next_drop(cni_blocks *blocks);

static inline void *cni_blocks_at(const cni_blocks *blocks, cni_ref ref)
{
	return blocks->chunks.at[ref >> 12] + (size_t)(ref & 4095u) * CNI_BLOCK_UNIT;
}

#endif
