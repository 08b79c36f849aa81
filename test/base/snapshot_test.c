/*
 * test/base/snapshot_test.c - promises of base/snapshot.h: what is loaded is what was saved, whatever is there by then; saving it again
 * gives the same bytes; without memory nothing has changed.
 */
#include "hooks.h"

#include "base/snapshot.h"

#include "../test.h"

typedef struct owner {
	hooks h;
	cni_memory memory;
	cni_array array;
	cni_table table;
	int32_t used; /* of the table */
	cni_blocks blocks;
	cni_ref refs[64];
	uint32_t bytes[64];
} owner;

static void owner_begin(owner *o)
{
	memset(o, 0, sizeof *o);
	hooks_init(&o->h, &o->memory);
	cni_array_init(&o->array, 12);
	cni_table_init(&o->table, 24, 3);
	cni_blocks_init(&o->blocks, &o->memory);
}

static void owner_end(owner *o)
{
	cni_array_deinit(&o->array, &o->memory);
	cni_table_deinit(&o->table, &o->memory);
	cni_blocks_deinit(&o->blocks);
	CHECK(o->h.pieces == 0 && o->h.wrong_frees == 0);
}

static void fill(void *at, size_t bytes, uint32_t value)
{
	memset(at, (int)(value & 0xFFu), bytes);
}

/* So many items and pieces, among them some above the largest class; what was there goes. */
static void owner_become(owner *o, uint32_t *random, int32_t items, int32_t pieces)
{
	int32_t k;
	for (k = 0; k < 64; ++k) {
		cni_blocks_free(&o->blocks, o->refs[k], o->bytes[k]);
		o->refs[k] = 0;
	}
	for (k = 0; k < pieces; ++k) {
		o->bytes[k] = 1u + random_next(random) % (k % 7 == 0 ? 9000u : 600u);
		o->refs[k] = cni_blocks_alloc(&o->blocks, o->bytes[k]);
		fill(cni_blocks_at(&o->blocks, o->refs[k]), o->bytes[k], random_next(random));
	}
	CHECK(cni_array_reserve(&o->array, &o->memory, items) && cni_table_reserve(&o->table, &o->memory, items));
	o->array.count = items;
	if (items > 0)
		fill(o->array.data, (size_t)items * 12, random_next(random));
	for (k = 0; k < items; ++k)
		fill(cni_table_at(&o->table, k), 24, random_next(random));
	o->used = items > o->used ? items : o->used;
}

/* The owner's numbers come last: the table's used items are those that are there. */
static void owner_pass(owner *o, cni_snapshot *s)
{
	cni_snapshot_array(s, &o->array);
	cni_snapshot_table(s, &o->table, o->used);
	cni_snapshot_blocks(s, &o->blocks);
	cni_snapshot_state(s, &o->used, sizeof o->used);
	cni_snapshot_state(s, o->refs, sizeof o->refs);
	cni_snapshot_state(s, o->bytes, sizeof o->bytes);
}

static uint8_t bytes_a[1 << 20], bytes_b[1 << 20];

static uint64_t owner_save(owner *o, uint8_t *out)
{
	cni_snapshot s = cni_snapshot_begin(CNI_SNAPSHOT_MEASURE, NULL, NULL);
	uint64_t bytes;
	owner_pass(o, &s);
	bytes = s.bytes;
	if (bytes > sizeof bytes_a / 2)
		exit(2);
	s = cni_snapshot_begin(CNI_SNAPSHOT_SAVE, out, NULL);
	owner_pass(o, &s);
	CHECK(s.bytes == bytes && s.at == out + bytes);
	return bytes;
}

static int32_t owner_load(owner *o, uint8_t *bytes)
{
	cni_snapshot s = cni_snapshot_begin(CNI_SNAPSHOT_RESERVE, bytes, &o->memory);
	int32_t good;
	owner_pass(o, &s);
	good = !s.failed;
	s = cni_snapshot_begin(good ? CNI_SNAPSHOT_LOAD : CNI_SNAPSHOT_ABANDON, bytes, &o->memory);
	owner_pass(o, &s);
	return good;
}

/* Between random states of one owner, and of another one that has seen none of them. */
static void t_loaded_is_what_was_saved(void)
{
	owner o, other;
	uint32_t random = 7;
	int32_t round, k, wrong = 0;
	owner_begin(&o);
	owner_begin(&other);
	for (round = 0; round < 300; ++round) {
		uint64_t bytes;
		owner_become(&o, &random, (int32_t)(random_next(&random) % 100u), (int32_t)(random_next(&random) % 64u));
		bytes = owner_save(&o, bytes_a);
		owner_become(&o, &random, (int32_t)(random_next(&random) % 200u), (int32_t)(random_next(&random) % 64u));
		wrong += !owner_load(&o, bytes_a) || owner_save(&o, bytes_b) != bytes || memcmp(bytes_a, bytes_b, (size_t)bytes) != 0;
		for (k = o.used; k < cni_table_capacity(&o.table); ++k)
			wrong += *(const uint8_t *)cni_table_at(&o.table, k) != 0;
		wrong += !owner_load(&other, bytes_a) || owner_save(&other, bytes_b) != bytes || memcmp(bytes_a, bytes_b, (size_t)bytes) != 0;
	}
	CHECK_LE("states that came back otherwise", wrong, 0, "");
	owner_end(&o);
	owner_end(&other);
}

static void t_without_memory_nothing_changes(void)
{
	owner o, small;
	uint32_t random = 5;
	uint64_t bytes;
	int32_t failed = 0;
	owner_begin(&o);
	owner_become(&o, &random, 90, 60);
	bytes = owner_save(&o, bytes_a);
	for (;; ++failed) {
		uint64_t before;
		owner_begin(&small);
		owner_become(&small, &random, 3, 9);
		before = owner_save(&small, bytes_b);
		small.h.fail_at = small.h.calls + 1 + failed;
		small.h.fail_after = 1;
		if (owner_load(&small, bytes_a))
			break;
		CHECK(owner_save(&small, bytes_b + before) == before && memcmp(bytes_b, bytes_b + before, (size_t)before) == 0);
		small.h.fail_at = 0;
		CHECK(owner_load(&small, bytes_a) && owner_save(&small, bytes_b) == bytes);
		owner_end(&small);
	}
	CHECK_GE("allocations that failed", failed, 5, "");
	owner_end(&small);
	owner_end(&o);
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(t_loaded_is_what_was_saved);
	RUN(t_without_memory_nothing_changes);
	return test_end();
}
