/*
 * base/snapshot.c - the cursor of a snapshot, and the passage of arrays, tables and the block allocator through it.
 *
 * Pieces of the block allocator are named by chunk and unit, so a loaded state needs chunks of the same sizes at the same
 * indices. RESERVE builds a second table of chunks that reuses the present chunks of equal size, and LOAD replaces the
 * present table by it. Mostly all chunks match, and no table is built.
 */
#include "base/snapshot.h"

#include <string.h>

cni_snapshot cni_snapshot_begin(int32_t mode, void *bytes, cni_memory *memory)
{
	cni_snapshot s = { (uint8_t *)bytes, 0, memory, mode, 0 };
	return s;
}

static void pass(cni_snapshot *s, uint64_t bytes)
{
	if (s->mode != CNI_SNAPSHOT_MEASURE)
		s->at += bytes;
	s->bytes += bytes;
}

void cni_snapshot_state(cni_snapshot *s, void *state, uint64_t bytes)
{
	if (s->mode == CNI_SNAPSHOT_SAVE && bytes > 0)
		memcpy(s->at, state, (size_t)bytes);
	if (s->mode == CNI_SNAPSHOT_LOAD && bytes > 0)
		memcpy(state, s->at, (size_t)bytes);
	pass(s, bytes);
}

static int32_t copies(const cni_snapshot *s)
{
	return s->mode == CNI_SNAPSHOT_SAVE || s->mode == CNI_SNAPSHOT_LOAD;
}

int32_t cni_snapshot_number(cni_snapshot *s, int32_t number)
{
	if (s->mode == CNI_SNAPSHOT_SAVE)
		memcpy(s->at, &number, sizeof number);
	else if (s->mode != CNI_SNAPSHOT_MEASURE)
		memcpy(&number, s->at, sizeof number);
	pass(s, sizeof number);
	return number;
}

void cni_snapshot_array(cni_snapshot *s, cni_array *array)
{
	int32_t count = cni_snapshot_number(s, array->count);
	if (cni_snapshot_reserves(s))
		cni_snapshot_need(s, cni_array_reserve(array, s->memory, count));
	cni_snapshot_state(s, array->data, (uint64_t)count * (uint64_t)array->item_bytes);
	if (s->mode == CNI_SNAPSHOT_LOAD)
		array->count = count;
}

void cni_snapshot_table(cni_snapshot *s, cni_table *table, int32_t used)
{
	int32_t count = cni_snapshot_number(s, used), page_items = 1 << table->page_shift;
	uint64_t item_bytes = (uint64_t)table->item_bytes;
	if (cni_snapshot_reserves(s))
		cni_snapshot_need(s, cni_table_reserve(table, s->memory, count));
	if (!copies(s)) {
		pass(s, (uint64_t)count * item_bytes);
		return;
	}
	for (int32_t k = 0; k < count; k += page_items) {
		int32_t items = count - k < page_items ? count - k : page_items;
		cni_snapshot_state(s, cni_table_at(table, k), (uint64_t)items * item_bytes);
	}
	for (int32_t k = count; k < used && s->mode == CNI_SNAPSHOT_LOAD; ++k)
		memset(cni_table_at(table, k), 0, (size_t)item_bytes);
}

/* ---- pieces ---- */

/* Bytes of a chunk, 0: there is none. */
static uint64_t chunk_size(const cni_blocks *blocks, int32_t slot)
{
	return slot < blocks->chunks.count && blocks->chunks.at[slot] != NULL ? blocks->chunks.bytes[slot] : 0;
}

/* Carved ones: the part before the tail, or all. */
static uint64_t chunk_used(const cni_blocks *blocks, int32_t slot)
{
	int32_t has_tail = blocks->tail_units > 0 && (int32_t)(blocks->tail >> 12) == slot;
	return has_tail ? (uint64_t)(blocks->tail & 4095u) * CNI_BLOCK_UNIT : chunk_size(blocks, slot);
}

/* Reserves chunks of the sizes that follow in the bytes. */
static void chunks_reserve(cni_snapshot *s, cni_blocks *blocks, int32_t count)
{
	int32_t same = count == blocks->chunks.count;
	uint64_t size;
	for (int32_t k = 0; k < count && same; ++k) {
		memcpy(&size, s->at + (size_t)k * 2 * sizeof size, sizeof size);
		same = size == chunk_size(blocks, k);
	}
	if (same)
		return;
	if (!cni_blocks_next_begin(blocks, count)) {
		s->failed = 1;
		return;
	}
	for (int32_t k = 0; k < count && !s->failed; ++k) {
		memcpy(&size, s->at + (size_t)k * 2 * sizeof size, sizeof size);
		cni_snapshot_need(s, cni_blocks_next_set(blocks, k, size));
	}
}

/* Passes a chunk's size and the number of its bytes that follow; for a free index 0 and the next free index. */
static void chunk_pass(cni_snapshot *s, cni_blocks *blocks, int32_t slot, uint64_t *used)
{
	uint64_t entry[2] = { 0, 0 };
	if (s->mode == CNI_SNAPSHOT_SAVE) {
		entry[0] = chunk_size(blocks, slot);
		entry[1] = entry[0] != 0 ? chunk_used(blocks, slot) : blocks->chunks.bytes[slot];
	} else if (s->mode != CNI_SNAPSHOT_MEASURE) {
		memcpy(entry, s->at, sizeof entry);
	}
	if (s->mode == CNI_SNAPSHOT_LOAD && entry[0] == 0)
		blocks->chunks.bytes[slot] = entry[1];
	*used = s->mode == CNI_SNAPSHOT_MEASURE ? chunk_used(blocks, slot) : entry[0] != 0 ? entry[1] : 0;
	cni_snapshot_state(s, entry, sizeof entry);
}

void cni_snapshot_blocks(cni_snapshot *s, cni_blocks *blocks)
{
	int32_t count = cni_snapshot_number(s, blocks->chunks.count);
	uint8_t *entries = s->at;
	uint64_t used, all = 0;
	if (cni_snapshot_reserves(s))
		chunks_reserve(s, blocks, count);
	if (s->mode == CNI_SNAPSHOT_LOAD)
		cni_blocks_next_take(blocks);
	if (s->mode == CNI_SNAPSHOT_ABANDON)
		cni_blocks_next_drop(blocks);
	for (int32_t k = 0; k < count; ++k) {
		chunk_pass(s, blocks, k, &used);
		all += used;
	}
	if (!copies(s))
		pass(s, all);
	for (int32_t k = 0; k < count && copies(s); ++k) {
		memcpy(&used, entries + (2 * (size_t)k + 1) * sizeof used, sizeof used);
		if (blocks->chunks.at[k] != NULL)
			cni_snapshot_state(s, blocks->chunks.at[k], used);
	}
	cni_snapshot_members(s, blocks, offsetof(cni_blocks, free_head), offsetof(cni_blocks, next));
}
