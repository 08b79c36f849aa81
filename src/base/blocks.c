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
 * Chunk 0 does not exist, so ref 0 names nothing. The table is one piece of memory (bytes first, then addresses), so that
 * its growth is one allocation that succeeds or changes nothing. The index of a freed large piece is reused; until then
 * its bytes link it to the next such index.
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

static uint32_t class_bytes(int32_t class_index)
{
	return class_units[class_index] * CNI_BLOCK_UNIT;
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

/* ------------------------------------------------------------------ chunk tables */

static int32_t table_rounded(int32_t capacity) { return (capacity + 7) & ~7; }

/* An empty table with room for this many chunks; 0: no memory. */
static int32_t table_make(cni_blocks *blocks, cni_chunks *out, int32_t capacity)
{
	memset(out, 0, sizeof *out);
	out->capacity = table_rounded(capacity);
	if (capacity == 0)
		return 1;
	out->bytes = (uint64_t *)cni_memory_alloc(blocks->memory, (uint64_t)out->capacity * CHUNK_SLOT_BYTES);
	if (out->bytes == NULL)
		return 0;
	out->at = (uint8_t **)(void *)(out->bytes + out->capacity);
	memset(out->bytes, 0, (size_t)out->capacity * CHUNK_SLOT_BYTES);
	return 1;
}

static void table_free(cni_blocks *blocks, cni_chunks *table)
{
	cni_memory_free(blocks->memory, table->bytes, (uint64_t)table->capacity * CHUNK_SLOT_BYTES);
	memset(table, 0, sizeof *table);
}

/* Frees a table and the chunks that the other table does not share. */
static void table_drop(cni_blocks *blocks, cni_chunks *table, const cni_chunks *other)
{
	for (int32_t k = 0; k < table->count; ++k)
		if (table->at[k] != NULL && !(k < other->count && table->at[k] == other->at[k]))
			cni_memory_free(blocks->memory, table->at[k], table->bytes[k]);
	table_free(blocks, table);
}

void cni_blocks_deinit(cni_blocks *blocks)
{
	CNI_ASSERT(!blocks->next_waits);
	table_drop(blocks, &blocks->chunks, &blocks->next);
	cni_blocks_init(blocks, blocks->memory);
}

static int32_t table_grow(cni_blocks *blocks, int32_t capacity)
{
	cni_chunks *old = &blocks->chunks, grown;
	size_t count = (size_t)old->count;
	if (!table_make(blocks, &grown, capacity))
		return 0;
	if (count > 0) {
		memcpy(grown.bytes, old->bytes, count * sizeof *grown.bytes);
		memcpy(grown.at, old->at, count * sizeof *grown.at);
	}
	grown.count = count > 0 ? old->count : 1;
	table_free(blocks, old);
	*old = grown;
	return 1;
}

/* Guarantees that slot_take succeeds; 0 when there is no memory or no index. */
static int32_t slot_reserve(cni_blocks *blocks)
{
	if (blocks->empty_slot != 0)
		return 1;
	if (blocks->chunks.count == CHUNK_INDEX_COUNT)
		return 0;
	return blocks->chunks.count < blocks->chunks.capacity || table_grow(blocks, blocks->chunks.capacity + blocks->chunks.capacity / 2 + 1);
}

static int32_t slot_take(cni_blocks *blocks, uint8_t *chunk, uint64_t bytes)
{
	int32_t slot = blocks->empty_slot;
	if (slot != 0)
		blocks->empty_slot = (int32_t)blocks->chunks.bytes[slot];
	else
		slot = blocks->chunks.count++;
	blocks->chunks.at[slot] = chunk;
	blocks->chunks.bytes[slot] = bytes;
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
	CNI_ASSERT(!blocks->next_waits);
	if (!table_make(blocks, &blocks->next, count))
		return 0;
	blocks->next.count = count;
	blocks->next_waits = 1;
	return 1;
}

int32_t cni_blocks_next_set(cni_blocks *blocks, int32_t slot, uint64_t bytes)
{
	const cni_chunks *now = &blocks->chunks;
	int32_t is_shared = slot < now->count && now->at[slot] != NULL && now->bytes[slot] == bytes;
	blocks->next.bytes[slot] = bytes;
	if (bytes == 0)
		return 1;
	blocks->next.at[slot] = is_shared ? now->at[slot] : chunk_alloc(blocks, bytes);
	return blocks->next.at[slot] != NULL;
}

void cni_blocks_next_take(cni_blocks *blocks)
{
	if (!blocks->next_waits)
		return;
	table_drop(blocks, &blocks->chunks, &blocks->next);
	blocks->chunks = blocks->next;
	memset(&blocks->next, 0, sizeof blocks->next);
	blocks->next_waits = 0;
}

void cni_blocks_next_drop(cni_blocks *blocks)
{
	table_drop(blocks, &blocks->next, &blocks->chunks);
	blocks->next_waits = 0;
}

/* ------------------------------------------------------------------ large pieces */

static cni_ref large_alloc(cni_blocks *blocks, uint64_t bytes)
{
	uint64_t taken = cni_memory_rounded(bytes);
	if (!slot_reserve(blocks))
		return 0;
	uint8_t *chunk = chunk_alloc(blocks, taken);
	if (chunk == NULL)
		return 0;
	blocks->bytes_large += taken;
	return (cni_ref)slot_take(blocks, chunk, taken) << 12;
}

static void large_free(cni_blocks *blocks, cni_ref ref, uint64_t bytes)
{
	int32_t slot = (int32_t)(ref >> 12);
	CNI_ASSERT((ref & 4095u) == 0 && blocks->chunks.bytes[slot] == cni_memory_rounded(bytes));
	(void)bytes;
	blocks->bytes_large -= blocks->chunks.bytes[slot];
	cni_memory_free(blocks->memory, blocks->chunks.at[slot], blocks->chunks.bytes[slot]);
	blocks->chunks.at[slot] = NULL;
	blocks->chunks.bytes[slot] = (uint64_t)blocks->empty_slot;
	blocks->empty_slot = slot;
}

/* ------------------------------------------------------------------ classes */

static void free_push(cni_blocks *blocks, int32_t class_index, cni_ref ref)
{
	memcpy(cni_blocks_at(blocks, ref), &blocks->free_head[class_index], sizeof(cni_ref));
	blocks->free_head[class_index] = ref;
	blocks->free_count[class_index] += 1;
}

static void tail_retire(cni_blocks *blocks)
{
	for (int32_t class_index = CNI_BLOCK_CLASSES - 1; class_index >= 0; --class_index) {
		while (blocks->tail_units >= class_units[class_index]) {
			blocks->tail_units -= class_units[class_index];
			free_push(blocks, class_index, blocks->tail + blocks->tail_units);
		}
	}
}

/* Bytes of the next chunk if count pieces of this class are still needed from it. */
static uint32_t chunk_wanted(const cni_blocks *blocks, int32_t class_index, int32_t count)
{
	uint64_t wanted = blocks->bytes_in_chunks / 16;
	uint64_t lacking = (uint64_t)class_bytes(class_index) * (uint64_t)count;
	wanted -= wanted % CHUNK_SMALLEST_BYTES;
	if (wanted < CHUNK_SMALLEST_BYTES)
		wanted = CHUNK_SMALLEST_BYTES;
	if (wanted < lacking)
		wanted = lacking;
	return wanted < CHUNK_LARGEST_BYTES ? (uint32_t)wanted : CHUNK_LARGEST_BYTES;
}

/* Makes a new chunk of the wanted bytes the tail, or a smaller one; it has room for at least one piece of this class. */
static int32_t chunk_add(cni_blocks *blocks, int32_t class_index, uint32_t wanted)
{
	uint32_t piece = class_bytes(class_index), taken = 0;
	uint8_t *chunk = NULL;
	if (!slot_reserve(blocks))
		return 0;
	for (; chunk == NULL && wanted >= piece; wanted /= 2) {
		taken = (uint32_t)cni_memory_rounded(wanted / piece * piece);
		chunk = chunk_alloc(blocks, taken);
	}
	if (chunk == NULL)
		return 0;
	tail_retire(blocks);
	blocks->tail = (cni_ref)slot_take(blocks, chunk, taken) << 12;
	blocks->tail_units = taken / CNI_BLOCK_UNIT;
	blocks->bytes_in_chunks += taken;
	return 1;
}

static cni_ref class_alloc(cni_blocks *blocks, int32_t class_index)
{
	uint32_t units = class_units[class_index];
	cni_ref ref = blocks->free_head[class_index];
	if (ref != 0) {
		memcpy(&blocks->free_head[class_index], cni_blocks_at(blocks, ref), sizeof(cni_ref));
		blocks->free_count[class_index] -= 1;
	} else {
		if (blocks->tail_units < units && !chunk_add(blocks, class_index, chunk_wanted(blocks, class_index, 1)))
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
	if (ref == 0)
		return;
	if (bytes > CNI_BLOCK_LARGEST) {
		large_free(blocks, ref, bytes);
		return;
	}
	int32_t class_index = class_fitting(bytes);
	CNI_ASSERT(blocks->bytes_in_use >= class_bytes(class_index));
	blocks->bytes_in_use -= class_bytes(class_index);
	free_push(blocks, class_index, ref);
}

/* Frees the first pieces of the tail, the last one first, so that they are allocated in address order. */
static void tail_carve(cni_blocks *blocks, int32_t class_index, uint32_t pieces)
{
	uint32_t units = class_units[class_index];
	for (uint32_t i = pieces; i-- > 0;)
		free_push(blocks, class_index, blocks->tail + i * units);
	blocks->tail += pieces * units;
	blocks->tail_units -= pieces * units;
}

int32_t cni_blocks_reserve(cni_blocks *blocks, uint64_t bytes, int32_t count)
{
	int32_t class_index = class_fitting(bytes);
	CNI_ASSERT(bytes > 0 && bytes <= CNI_BLOCK_LARGEST);
	while (blocks->free_count[class_index] < count) {
		int32_t lacking = count - blocks->free_count[class_index];
		uint32_t pieces = blocks->tail_units / class_units[class_index];
		if (pieces == 0 && !chunk_add(blocks, class_index, chunk_wanted(blocks, class_index, lacking)))
			return 0;
		if (pieces > (uint32_t)lacking)
			pieces = (uint32_t)lacking;
		tail_carve(blocks, class_index, pieces);
	}
	return 1;
}

/* ------------------------------------------------------------------ a first reserve of known size */

/* The chunks of these pieces, with chunk 0, which does not exist; makes them unless blocks is NULL. *bytes: the sum, without the table.
   0: no memory. */
static int32_t chunks_of(const cni_pieces *pieces, int32_t kinds, cni_blocks *blocks, uint64_t *bytes)
{
	int32_t slots = 1;
	for (int32_t k = 0; k < kinds; ++k) {
		int32_t class_index = class_fitting(pieces[k].bytes);
		uint32_t piece = class_bytes(class_index), most = CHUNK_LARGEST_BYTES / piece;
		for (int32_t left = pieces[k].count; left > 0; left -= (int32_t)most) {
			uint32_t count = (uint32_t)left < most ? (uint32_t)left : most;
			++slots;
			*bytes += cni_memory_rounded(count * piece);
			if (blocks == NULL)
				continue;
			if (!chunk_add(blocks, class_index, count * piece) || blocks->tail_units < count * class_units[class_index])
				return 0;
			tail_carve(blocks, class_index, count);
		}
	}
	return slots;
}

uint64_t cni_blocks_bytes_for(const cni_pieces *pieces, int32_t kinds)
{
	uint64_t bytes = 0;
	int32_t slots = chunks_of(pieces, kinds, NULL, &bytes);
	return bytes + cni_memory_rounded((uint64_t)table_rounded(slots) * CHUNK_SLOT_BYTES);
}

int32_t cni_blocks_reserve_exact(cni_blocks *blocks, const cni_pieces *pieces, int32_t kinds)
{
	uint64_t bytes = 0;
	CNI_ASSERT(blocks->chunks.count == 0);
	return table_grow(blocks, chunks_of(pieces, kinds, NULL, &bytes)) && chunks_of(pieces, kinds, blocks, &bytes) != 0;
}
