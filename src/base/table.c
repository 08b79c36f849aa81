/*
 * base/table.c - owns the growth of cni_table (pages that never move) and cni_array (one piece that moves when it grows).
 * The caller passes the cni_memory, so that neither stores a pointer to it.
 *
 * Invariant of both: capacity only grows, and a failed reserve changes no item and no capacity.
 */
#include "base/table.h"

#include <string.h>

#define ARRAY_LARGE_BYTES 2048u
/* Keeps the growth of the page pointers within an int32_t. */
#define TABLE_PAGES_MAX (1 << 30)

/* ------------------------------------------------------------------ table */

void cni_table_init(cni_table *table, int32_t item_bytes, int32_t page_shift)
{
	const cni_table empty = { NULL, 0, 0, item_bytes, page_shift };
	CNI_ASSERT(item_bytes > 0 && page_shift >= 0 && page_shift < 31);
	*table = empty;
}

static uint64_t table_page_bytes(const cni_table *table)
{
	return (uint64_t)table->item_bytes << table->page_shift;
}

/* Frees the pages from this one on. */
static void table_cut(cni_table *table, cni_memory *memory, int32_t page_count)
{
	while (table->page_count > page_count)
		cni_memory_free(memory, table->pages[--table->page_count], table_page_bytes(table));
}

void cni_table_deinit(cni_table *table, cni_memory *memory)
{
	table_cut(table, memory, 0);
	cni_memory_free(memory, table->pages, (uint64_t)table->page_capacity * sizeof *table->pages);
	cni_table_init(table, table->item_bytes, table->page_shift);
}

static int64_t table_pages_for(const cni_table *table, int32_t count)
{
	int64_t page_items = (int64_t)1 << table->page_shift;
	return count > 0 ? ((int64_t)count + page_items - 1) >> table->page_shift : 0;
}

static int32_t table_reserve_pointers(cni_table *table, cni_memory *memory, int32_t page_count)
{
	cni_array pages = { table->pages, table->page_count, table->page_capacity, (int32_t)sizeof *table->pages };
	if (!cni_array_reserve(&pages, memory, page_count))
		return 0;
	table->pages = (uint8_t **)pages.data;
	table->page_capacity = pages.capacity;
	return 1;
}

int32_t cni_table_grow(cni_table *table, cni_memory *memory, int32_t count)
{
	int64_t page_count = table_pages_for(table, count);
	uint64_t page_bytes = table_page_bytes(table);
	int32_t before = table->page_count;
	if (page_count << table->page_shift > INT32_MAX || page_count > TABLE_PAGES_MAX || !table_reserve_pointers(table, memory, (int32_t)page_count))
		return 0;
	while (table->page_count < page_count) {
		uint8_t *page = (uint8_t *)cni_memory_alloc(memory, page_bytes);
		if (page == NULL) {
			table_cut(table, memory, before);
			return 0;
		}
		table->pages[table->page_count++] = page;
	}
	for (int32_t i = before; i < page_count; ++i)
		memset(table->pages[i], 0, (size_t)page_bytes);
	return 1;
}

uint64_t cni_table_bytes_for(const cni_table *table, int32_t count)
{
	uint64_t page_count = (uint64_t)table_pages_for(table, count);
	return page_count * cni_memory_rounded(table_page_bytes(table)) + cni_memory_rounded(page_count * sizeof *table->pages);
}

/* ------------------------------------------------------------------ array */

void cni_array_init(cni_array *array, int32_t item_bytes)
{
	const cni_array empty = { NULL, 0, 0, item_bytes };
	CNI_ASSERT(item_bytes > 0);
	*array = empty;
}

void cni_array_deinit(cni_array *array, cni_memory *memory)
{
	cni_memory_free(memory, array->data, (uint64_t)array->capacity * (uint64_t)array->item_bytes);
	cni_array_init(array, array->item_bytes);
}

/* Grows by half while small, by an eighth when large, rounded up to a whole cache line. */
static int32_t array_grown_capacity(const cni_array *array, int32_t count)
{
	uint64_t item_bytes = (uint64_t)array->item_bytes;
	uint64_t capacity = (uint64_t)array->capacity, bytes;
	capacity += capacity * item_bytes > ARRAY_LARGE_BYTES ? capacity / 8 : capacity / 2;
	if (capacity < (uint64_t)count)
		capacity = (uint64_t)count;
	bytes = cni_memory_rounded(capacity * item_bytes);
	if ((size_t)bytes == bytes) /* so that processors of 32 bits need no division of 64; else there is no such memory */
		capacity = (size_t)bytes / (size_t)item_bytes;
	return capacity < INT32_MAX ? (int32_t)capacity : INT32_MAX;
}

static int32_t array_move(cni_array *array, cni_memory *memory, int32_t capacity)
{
	uint64_t item_bytes = (uint64_t)array->item_bytes;
	void *data = cni_memory_alloc(memory, (uint64_t)capacity * item_bytes);
	if (data == NULL)
		return 0;
	CNI_ASSERT(array->count >= 0 && array->count <= array->capacity);
	if (array->count > 0)
		memcpy(data, array->data, (size_t)((uint64_t)array->count * item_bytes));
	cni_memory_free(memory, array->data, (uint64_t)array->capacity * item_bytes);
	array->data = data;
	array->capacity = capacity;
	return 1;
}

int32_t cni_array_grow(cni_array *array, cni_memory *memory, int32_t count)
{
	int32_t grown = array_grown_capacity(array, count);
	/* When memory is short, tries again without spare capacity. */
	return array_move(array, memory, grown) || (grown > count && array_move(array, memory, count));
}

int32_t cni_array_reserve_exact(cni_array *array, cni_memory *memory, int32_t count)
{
	return count <= array->capacity || array_move(array, memory, count);
}
