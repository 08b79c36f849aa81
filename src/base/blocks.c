/*
 * base/blocks.c - owns the chunks, their table and the free lists of the size classes.
 *
 * A piece comes from its class's free list, else from the tail (the part of the newest chunk that is not carved yet, shared
 * by all classes), else from a new chunk. Before the new chunk becomes the tail, the old tail is carved into the largest
 * classes that fit, so that every unit of every chunk is in use, on a free list, or in the tail:
 *
 *   bytes_in_chunks = bytes_in_use + sum over classes of free_count * class + tail_units * 16
 *
 * A new chunk has a sixteenth of the bytes of all chunks, at least 4 KiB, or the bytes that a reserve still lacks if that is
 * more, and at most 64 KiB. It is trimmed to a whole number of pieces of the requested class (rounded up to 64 bytes). When
 * there is no memory for it, half of it is tried, down to a single piece. So unused room stays below a sixteenth, and a
 * fixed block is used up to its end.
 *
 * Free pieces are never split for a smaller class: pieces that cni_blocks_reserve set aside for a class stay in that class.
 *
 * Chunk 0 does not exist, so ref 0 names nothing. The table is one piece of memory (chunk_bytes first, then chunks), so that
 * its growth is one allocation that succeeds or changes nothing. The index of a freed large piece is reused; until then
 * chunk_bytes links it to the next such index.
 */
#include "base/blocks.h"

#include <string.h>

#define CHUNK_SMALLEST_BYTES 4096u
#define CHUNK_LARGEST_BYTES 65536u
#define CHUNK_INDEX_COUNT (1 << 20)
#define CHUNK_SLOT_BYTES (sizeof(uint64_t) + sizeof(uint8_t *))

static const uint16_t class_units[CNI_BLOCK_CLASSES] = {1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128, 256};

static int32_t class_fitting(uint64_t bytes)
{
	int32_t class_index = 0;

	while ((uint64_t)class_units[class_index] * CNI_BLOCK_UNIT < bytes)
		++class_index;
	return class_index;
}

static uint64_t class_bytes(int32_t class_index)
{
	return (uint64_t)class_units[class_index] * CNI_BLOCK_UNIT;
}

uint64_t cni_blocks_rounded(uint64_t bytes)
{
	return bytes > CNI_BLOCK_LARGEST ? cni_memory_rounded(bytes) : class_bytes(class_fitting(bytes));
}

void cni_blocks_init(cni_blocks *blocks, cni_memory *memory)
{
	memset(blocks, 0, sizeof *blocks);
	blocks->memory = memory;
}

void cni_blocks_deinit(cni_blocks *blocks)
{
	int32_t i;

	for (i = 0; i < blocks->chunk_count; ++i)
		if (blocks->chunks[i] != NULL)
			cni_memory_free(blocks->memory, blocks->chunks[i], blocks->chunk_bytes[i]);
	cni_memory_free(blocks->memory, blocks->chunk_bytes, (uint64_t)blocks->chunk_capacity * CHUNK_SLOT_BYTES);
	cni_blocks_init(blocks, blocks->memory);
}

/* ------------------------------------------------------------------ chunk table */

static int32_t table_grow(cni_blocks *blocks)
{
	size_t count = (size_t)blocks->chunk_count;
	int32_t capacity = (blocks->chunk_capacity + blocks->chunk_capacity / 2 + 8) & ~7;
	uint64_t *sizes = (uint64_t *)cni_memory_alloc(blocks->memory, (uint64_t)capacity * CHUNK_SLOT_BYTES);
	uint8_t **chunks;

	if (sizes == NULL)
		return 0;
	chunks = (uint8_t **)(void *)(sizes + capacity);
	if (count > 0) {
		memcpy(sizes, blocks->chunk_bytes, count * sizeof *sizes);
		memcpy(chunks, blocks->chunks, count * sizeof *chunks);
	} else {
		sizes[0] = 0;
		chunks[0] = NULL;
		blocks->chunk_count = 1;
	}
	cni_memory_free(blocks->memory, blocks->chunk_bytes, (uint64_t)blocks->chunk_capacity * CHUNK_SLOT_BYTES);
	blocks->chunk_bytes = sizes;
	blocks->chunks = chunks;
	blocks->chunk_capacity = capacity;
	return 1;
}

/* Guarantees that slot_take succeeds; 0 when there is no memory or no index. */
static int32_t slot_reserve(cni_blocks *blocks)
{
	if (blocks->empty_slot != 0)
		return 1;
	if (blocks->chunk_count == CHUNK_INDEX_COUNT)
		return 0;
	return blocks->chunk_count < blocks->chunk_capacity || table_grow(blocks);
}

static int32_t slot_take(cni_blocks *blocks, uint8_t *chunk, uint64_t bytes)
{
	int32_t slot = blocks->empty_slot;

	if (slot != 0)
		blocks->empty_slot = (int32_t)blocks->chunk_bytes[slot];
	else
		slot = blocks->chunk_count++;
	blocks->chunks[slot] = chunk;
	blocks->chunk_bytes[slot] = bytes;
	return slot;
}

/* Cleared, so that a snapshot may copy whole chunks. */
static uint8_t *chunk_alloc(cni_blocks *blocks, uint64_t bytes)
{
	uint8_t *chunk = (uint8_t *)cni_memory_alloc(blocks->memory, bytes);
	if (chunk != NULL)
		memset(chunk, 0, (size_t)bytes);
	return chunk;
}

/* ------------------------------------------------------------------ the next table */

int32_t cni_blocks_next_begin(cni_blocks *blocks, int32_t count)
{
	int32_t capacity = (count + 7) & ~7;

	CNI_ASSERT(!blocks->next_waits);
	if (capacity > 0) {
		blocks->next_bytes = (uint64_t *)cni_memory_alloc(blocks->memory, (uint64_t)capacity * CHUNK_SLOT_BYTES);
		if (blocks->next_bytes == NULL)
			return 0;
		blocks->next_chunks = (uint8_t **)(void *)(blocks->next_bytes + capacity);
		memset(blocks->next_bytes, 0, (size_t)capacity * CHUNK_SLOT_BYTES);
	}
	blocks->next_count = count;
	blocks->next_capacity = capacity;
	blocks->next_waits = 1;
	return 1;
}

static void next_clear(cni_blocks *blocks)
{
	blocks->next_bytes = NULL;
	blocks->next_chunks = NULL;
	blocks->next_count = 0;
	blocks->next_capacity = 0;
	blocks->next_waits = 0;
}

static int32_t chunk_is_shared(const cni_blocks *blocks, int32_t slot)
{
	return slot < blocks->chunk_count && slot < blocks->next_count && blocks->chunks[slot] == blocks->next_chunks[slot];
}

int32_t cni_blocks_next_set(cni_blocks *blocks, int32_t slot, uint64_t bytes)
{
	blocks->next_bytes[slot] = bytes;
	if (bytes == 0)
		return 1;
	if (slot < blocks->chunk_count && blocks->chunks[slot] != NULL && blocks->chunk_bytes[slot] == bytes)
		blocks->next_chunks[slot] = blocks->chunks[slot];
	else
		blocks->next_chunks[slot] = chunk_alloc(blocks, bytes);
	return blocks->next_chunks[slot] != NULL;
}

void cni_blocks_next_take(cni_blocks *blocks)
{
	int32_t k;

	if (!blocks->next_waits)
		return;
	for (k = 0; k < blocks->chunk_count; ++k)
		if (blocks->chunks[k] != NULL && !chunk_is_shared(blocks, k))
			cni_memory_free(blocks->memory, blocks->chunks[k], blocks->chunk_bytes[k]);
	cni_memory_free(blocks->memory, blocks->chunk_bytes, (uint64_t)blocks->chunk_capacity * CHUNK_SLOT_BYTES);
	blocks->chunk_bytes = blocks->next_bytes;
	blocks->chunks = blocks->next_chunks;
	blocks->chunk_count = blocks->next_count;
	blocks->chunk_capacity = blocks->next_capacity;
	next_clear(blocks);
}

void cni_blocks_next_drop(cni_blocks *blocks)
{
	int32_t k;

	if (!blocks->next_waits)
		return;
	for (k = 0; k < blocks->next_count; ++k)
		if (blocks->next_chunks[k] != NULL && !chunk_is_shared(blocks, k))
			cni_memory_free(blocks->memory, blocks->next_chunks[k], blocks->next_bytes[k]);
	cni_memory_free(blocks->memory, blocks->next_bytes, (uint64_t)blocks->next_capacity * CHUNK_SLOT_BYTES);
	next_clear(blocks);
}

/* ------------------------------------------------------------------ large pieces */

static cni_ref large_alloc(cni_blocks *blocks, uint64_t bytes)
{
	uint64_t taken = cni_memory_rounded(bytes);
	uint8_t *chunk;

	if (!slot_reserve(blocks))
		return 0;
	chunk = chunk_alloc(blocks, taken);
	if (chunk == NULL)
		return 0;
	blocks->bytes_large += taken;
	return (cni_ref)slot_take(blocks, chunk, taken) << 12;
}

static void large_free(cni_blocks *blocks, cni_ref ref, uint64_t bytes)
{
	int32_t slot = (int32_t)(ref >> 12);

	CNI_ASSERT((ref & 4095u) == 0 && blocks->chunk_bytes[slot] == cni_memory_rounded(bytes));
	(void)bytes;
	blocks->bytes_large -= blocks->chunk_bytes[slot];
	cni_memory_free(blocks->memory, blocks->chunks[slot], blocks->chunk_bytes[slot]);
	blocks->chunks[slot] = NULL;
	blocks->chunk_bytes[slot] = (uint64_t)blocks->empty_slot;
	blocks->empty_slot = slot;
}

/* ------------------------------------------------------------------ classes */

static void free_push(cni_blocks *blocks, int32_t class_index, cni_ref ref)
{
	memcpy(cni_blocks_at(blocks, ref), &blocks->free_head[class_index], sizeof(cni_ref));
	blocks->free_head[class_index] = ref;
	blocks->free_count[class_index] += 1;
}

static cni_ref free_pop(cni_blocks *blocks, int32_t class_index)
{
	cni_ref ref = blocks->free_head[class_index];

	memcpy(&blocks->free_head[class_index], cni_blocks_at(blocks, ref), sizeof(cni_ref));
	blocks->free_count[class_index] -= 1;
	return ref;
}

/* Carves the rest of the tail into the largest classes that fit. */
static void tail_retire(cni_blocks *blocks)
{
	int32_t class_index;

	for (class_index = CNI_BLOCK_CLASSES - 1; class_index >= 0; --class_index) {
		while (blocks->tail_units >= class_units[class_index]) {
			blocks->tail_units -= class_units[class_index];
			free_push(blocks, class_index, blocks->tail + blocks->tail_units);
		}
	}
}

/* Bytes of the next chunk if count pieces of this class are still needed from it. */
static uint64_t chunk_wanted(const cni_blocks *blocks, int32_t class_index, int32_t count)
{
	uint64_t wanted = blocks->bytes_in_chunks / 16;
	uint64_t lacking = class_bytes(class_index) * (uint64_t)count;

	wanted -= wanted % CHUNK_SMALLEST_BYTES;
	if (wanted < CHUNK_SMALLEST_BYTES)
		wanted = CHUNK_SMALLEST_BYTES;
	if (wanted < lacking)
		wanted = lacking;
	return wanted < CHUNK_LARGEST_BYTES ? wanted : CHUNK_LARGEST_BYTES;
}

/* Makes a new chunk the tail; it has room for at least one piece of this class. */
static int32_t chunk_add(cni_blocks *blocks, int32_t class_index, int32_t count)
{
	uint64_t piece = class_bytes(class_index);
	uint64_t wanted = chunk_wanted(blocks, class_index, count);
	uint64_t taken = 0;
	uint8_t *chunk = NULL;

	if (!slot_reserve(blocks))
		return 0;
	for (; chunk == NULL && wanted >= piece; wanted /= 2) {
		taken = cni_memory_rounded((uint32_t)wanted / (uint32_t)piece * (uint32_t)piece); /* of 32 bits, as the largest chunk */
		chunk = chunk_alloc(blocks, taken);
	}
	if (chunk == NULL)
		return 0;
	tail_retire(blocks);
	blocks->tail = (cni_ref)slot_take(blocks, chunk, taken) << 12;
	blocks->tail_units = (uint32_t)(taken / CNI_BLOCK_UNIT);
	blocks->bytes_in_chunks += taken;
	return 1;
}

static cni_ref class_alloc(cni_blocks *blocks, int32_t class_index)
{
	uint32_t units = class_units[class_index];
	cni_ref ref;

	if (blocks->free_head[class_index] != 0) {
		ref = free_pop(blocks, class_index);
	} else {
		if (blocks->tail_units < units && !chunk_add(blocks, class_index, 1))
			return 0;
		ref = blocks->tail;
		blocks->tail += units;
		blocks->tail_units -= units;
	}
	blocks->bytes_in_use += class_bytes(class_index);
	return ref;
}

cni_ref cni_blocks_alloc(cni_blocks *blocks, uint64_t bytes)
{
	CNI_ASSERT(bytes > 0);
	return bytes > CNI_BLOCK_LARGEST ? large_alloc(blocks, bytes) : class_alloc(blocks, class_fitting(bytes));
}

void cni_blocks_free(cni_blocks *blocks, cni_ref ref, uint64_t bytes)
{
	int32_t class_index;

	if (ref == 0)
		return;
	if (bytes > CNI_BLOCK_LARGEST) {
		large_free(blocks, ref, bytes);
		return;
	}
	class_index = class_fitting(bytes);
	CNI_ASSERT(blocks->bytes_in_use >= class_bytes(class_index));
	blocks->bytes_in_use -= class_bytes(class_index);
	free_push(blocks, class_index, ref);
}

int32_t cni_blocks_reserve(cni_blocks *blocks, uint64_t bytes, int32_t count)
{
	int32_t class_index = class_fitting(bytes);
	uint32_t units = class_units[class_index];

	CNI_ASSERT(bytes > 0 && bytes <= CNI_BLOCK_LARGEST);
	while (blocks->free_count[class_index] < count) {
		int32_t lacking = count - blocks->free_count[class_index];
		uint32_t pieces = blocks->tail_units / units;
		uint32_t i;

		if (pieces == 0) {
			if (!chunk_add(blocks, class_index, lacking))
				return 0;
			continue;
		}
		if (pieces > (uint32_t)lacking)
			pieces = (uint32_t)lacking;
		/* Last piece first, so that they are allocated in address order. */
		for (i = pieces; i-- > 0;)
			free_push(blocks, class_index, blocks->tail + i * units);
		blocks->tail += pieces * units;
		blocks->tail_units -= pieces * units;
	}
	return 1;
}
