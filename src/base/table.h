/*
 * base/table.h - two containers of equal items by index.
 *
 * cni_table  pages of a fixed number of items: items never move, growth copies no item and wastes at most a page.
 *            For records with stable slots.
 * cni_array  one contiguous piece that moves when it grows (by half while small, by an eighth above 2 KiB).
 *            For dense arrays that loops run over.
 *
 * Both only grow. Callers stay atomic by "reserve, then commit": they first reserve everything a call needs, and only then
 * change state.
 */
#ifndef CNI_BASE_TABLE_H
#define CNI_BASE_TABLE_H

#include "base/memory.h"

typedef struct cni_table {
	uint8_t **pages;
	int32_t page_count;
	int32_t page_capacity; /* of the pages array */
	int32_t item_bytes;
	int32_t page_shift;    /* items in a page = 1 << page_shift */
} cni_table;

void cni_table_init(cni_table *table, int32_t item_bytes, int32_t page_shift);
void cni_table_deinit(cni_table *table, cni_memory *memory);
uint64_t cni_table_bytes_for(const cni_table *table, int32_t count);
/* cni_table_reserve beyond the capacity. */
int32_t cni_table_grow(cni_table *table, cni_memory *memory, int32_t count);

static inline int32_t cni_table_capacity(const cni_table *table)
{
	return table->page_count << table->page_shift;
}

/* Makes room for items 0 .. count-1; 0 if there is no memory, and nothing changes. New items are zeroed. */
static inline int32_t cni_table_reserve(cni_table *table, cni_memory *memory, int32_t count)
{
	return count <= cni_table_capacity(table) || cni_table_grow(table, memory, count);
}

static inline void *cni_table_at(const cni_table *table, int32_t index)
{
	return table->pages[index >> table->page_shift] +
	       (size_t)(index & ((1 << table->page_shift) - 1)) * (size_t)table->item_bytes;
}

/* The same for item and page sizes that are constants. Indices are not negative: as unsigned numbers they need no sign
   extension. */
static inline void *cni_table_at_sized(const cni_table *table, int32_t index, size_t item_bytes, int32_t page_shift)
{
	CNI_ASSERT(table->page_shift == page_shift);
	return table->pages[(uint32_t)index >> page_shift] + (size_t)((uint32_t)index & ((1u << page_shift) - 1u)) * item_bytes;
}

typedef struct cni_array {
	void *data;        /* 64-byte aligned */
	int32_t count;     /* set by the owner: reserve preserves only items below count */
	int32_t capacity;
	int32_t item_bytes;
} cni_array;

void cni_array_init(cni_array *array, int32_t item_bytes);
void cni_array_deinit(cni_array *array, cni_memory *memory);
/* cni_array_reserve beyond the capacity. */
int32_t cni_array_grow(cni_array *array, cni_memory *memory, int32_t count);

/* Makes room for count items in total; 0 if there is no memory, and nothing changes. New items are not cleared. */
static inline int32_t cni_array_reserve(cni_array *array, cni_memory *memory, int32_t count)
{
	return count <= array->capacity || cni_array_grow(array, memory, count);
}

/* The same without spare capacity, for counts that are known beforehand. */
int32_t cni_array_reserve_exact(cni_array *array, cni_memory *memory, int32_t count);

#endif
