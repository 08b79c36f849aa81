/* Promises of base/table.h: pages that never move, arrays that grow in measure. */
#include "hooks.h"

#include "base/table.h"

#include "../test.h"

typedef struct item {
	uint32_t words[3];
} item;

static void t_table_items_stay_and_start_zeroed(void)
{
	enum { COUNT = 5000 };
	static item *addresses[COUNT];
	cni_memory memory;
	cni_table table;
	hooks h;
	int32_t i, moved = 0, dirty = 0;

	hooks_init(&h, &memory);
	cni_table_init(&table, (int32_t)sizeof(item), 4);
	CHECK(cni_table_capacity(&table) == 0 && h.calls == 0);
	CHECK(cni_table_reserve(&table, &memory, 0) == 1 && h.calls == 0);
	for (i = 0; i < COUNT; ++i) {
		REQUIRE(cni_table_reserve(&table, &memory, i + 1));
		addresses[i] = cni_table_at(&table, i);
		dirty += addresses[i]->words[0] != 0 || addresses[i]->words[2] != 0;
		addresses[i]->words[0] = (uint32_t)i;
		addresses[i]->words[2] = ~(uint32_t)i;
	}
	for (i = 0; i < COUNT; ++i) {
		item *now = cni_table_at(&table, i);

		moved += now != addresses[i] || now->words[0] != (uint32_t)i || now->words[2] != ~(uint32_t)i;
	}
	CHECK_LE("items that moved or changed", moved, 0, "items");
	CHECK_LE("new items that were not zero", dirty, 0, "items");
	CHECK(cni_table_capacity(&table) == 5008);
	cni_table_deinit(&table, &memory);
	CHECK(h.pieces == 0 && h.wrong_frees == 0 && cni_table_capacity(&table) == 0);
}

static void t_table_bytes_for_is_what_it_takes(void)
{
	static uint8_t room[400 * 1024];
	uint8_t *block = room + (64 - (uintptr_t)room % 64);
	int32_t counts[5] = {0, 1, 16, 17, 10000};
	int32_t i;

	for (i = 0; i < 5; ++i) {
		cni_memory memory;
		cni_table table;

		cni_memory_init_block(&memory, block, sizeof room - 64);
		cni_table_init(&table, (int32_t)sizeof(item), 4);
		CHECK(cni_table_reserve(&table, &memory, counts[i]));
		CHECK(memory.bytes_in_use == cni_table_bytes_for(&table, counts[i]));
		CHECK(cni_table_capacity(&table) >= counts[i]);
	}
}

static void t_table_refuses_what_int32_cannot_index(void)
{
	cni_memory memory;
	cni_table table;
	hooks h;

	hooks_init(&h, &memory);
	cni_table_init(&table, 8, 8);
	CHECK(cni_table_reserve(&table, &memory, INT32_MAX) == 0);
	CHECK(h.calls == 0);
	cni_table_init(&table, 8, 0);
	CHECK(cni_table_reserve(&table, &memory, INT32_MAX) == 0);
	CHECK(h.calls == 0);
}

static void t_table_out_of_memory_at_every_call(void)
{
	int32_t n, broken = 0;

	for (n = 2; n < 40; ++n) { /* from the first new page on: the array of pages tries again without spare room */
		cni_memory memory;
		cni_table table;
		hooks h;

		hooks_init(&h, &memory);
		cni_table_init(&table, (int32_t)sizeof(item), 2);
		broken += !cni_table_reserve(&table, &memory, 3);
		((item *)cni_table_at(&table, 2))->words[1] = 99;
		h.fail_at = 2 + n;
		broken += cni_table_reserve(&table, &memory, 1000) != 0;
		broken += ((item *)cni_table_at(&table, 2))->words[1] != 99;
		broken += cni_table_capacity(&table) != 4;
		broken += !cni_table_reserve(&table, &memory, 1000);
		broken += ((item *)cni_table_at(&table, 2))->words[1] != 99;
		cni_table_deinit(&table, &memory);
		broken += h.pieces != 0 || h.wrong_frees != 0;
	}
	CHECK_LE("broken promises", broken, 0, "");
}

static void t_array_preserves_and_aligns(void)
{
	cni_memory memory;
	cni_array array;
	hooks h;
	int32_t i, wrong = 0;

	hooks_init(&h, &memory);
	cni_array_init(&array, (int32_t)sizeof(item));
	for (i = 0; i < 20000; ++i) {
		REQUIRE(cni_array_reserve(&array, &memory, i + 1));
		((item *)array.data)[i].words[1] = (uint32_t)i * 7;
		array.count = i + 1;
	}
	CHECK((uintptr_t)array.data % 64 == 0);
	for (i = 0; i < 20000; ++i)
		wrong += ((item *)array.data)[i].words[1] != (uint32_t)i * 7;
	CHECK_LE("items lost in growing", wrong, 0, "items");
	CHECK_LE("allocator calls for 20000 single reserves", h.calls, 50, "calls");
	cni_array_deinit(&array, &memory);
	CHECK(h.pieces == 0 && h.wrong_frees == 0 && array.count == 0 && array.capacity == 0);
}

static void t_array_grows_in_measure(void)
{
	cni_memory memory;
	cni_array array;
	hooks h;
	double small = 0, large = 0;
	int32_t before, i;

	hooks_init(&h, &memory);
	cni_array_init(&array, 4);
	CHECK(cni_array_reserve(&array, &memory, 1) && array.capacity == 16);
	for (i = 0; i < 40; ++i) {
		double grown;

		before = array.capacity;
		REQUIRE(cni_array_reserve(&array, &memory, before + 1));
		grown = (double)array.capacity / before;
		if (before * 4 > 2048)
			large = large > grown ? large : grown;
		else if (before > 256)
			small = small > grown ? small : grown;
	}
	CHECK_LE("growth up to 2 KiB", small, 1.54, "x");
	CHECK_GE("growth up to 2 KiB", small, 1.46, "x");
	CHECK_LE("growth above 2 KiB", large, 1.15, "x");
	CHECK_GE("growth above 2 KiB", large, 1.12, "x");
	cni_array_deinit(&array, &memory);
	REQUIRE(cni_array_reserve_exact(&array, &memory, 1001));
	CHECK(array.capacity == 1001 && h.bytes == 4004);
	CHECK(cni_array_reserve_exact(&array, &memory, 7) && array.capacity == 1001);
	CHECK(cni_array_reserve_exact(&array, &memory, 1002) && array.capacity == 1002);
	cni_array_deinit(&array, &memory);
	CHECK(h.pieces == 0 && h.wrong_frees == 0);
}

static void t_array_out_of_memory_changes_nothing(void)
{
	cni_memory memory;
	cni_array array;
	hooks h;
	void *data;

	hooks_init(&h, &memory);
	cni_array_init(&array, 4);
	h.fail_at = 1;
	h.fail_after = 1;
	CHECK(cni_array_reserve(&array, &memory, 5) == 0 && array.data == NULL && array.capacity == 0);
	h.fail_at = 0;
	REQUIRE(cni_array_reserve(&array, &memory, 100));
	array.count = 100;
	((int32_t *)array.data)[99] = 4711;
	data = array.data;
	h.fail_at = h.calls + 1;
	CHECK(cni_array_reserve(&array, &memory, 1000) == 0);
	CHECK(cni_array_reserve_exact(&array, &memory, 1000) == 0);
	CHECK(array.data == data && array.capacity == 112 && array.count == 100 && ((int32_t *)array.data)[99] == 4711);
	/* Only the generous size fails: the exact one is taken. */
	h.fail_after = 0;
	h.fail_at = h.calls + 1;
	CHECK(cni_array_reserve(&array, &memory, 113) == 1 && array.capacity == 113);
	CHECK(((int32_t *)array.data)[99] == 4711);
	cni_array_deinit(&array, &memory);
	CHECK(h.pieces == 0 && h.wrong_frees == 0);
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(t_table_items_stay_and_start_zeroed);
	RUN(t_table_bytes_for_is_what_it_takes);
	RUN(t_table_refuses_what_int32_cannot_index);
	RUN(t_table_out_of_memory_at_every_call);
	RUN(t_array_preserves_and_aligns);
	RUN(t_array_grows_in_measure);
	RUN(t_array_out_of_memory_changes_nothing);
	return test_end();
}
