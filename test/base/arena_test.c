/* Promises of base/arena.h: LIFO, fallback, growth to the high-water mark. */
#include "hooks.h"

#include "base/arena.h"

#include "../test.h"

static void t_takes_nothing_until_used(void)
{
	cni_memory memory;
	cni_arena arena;
	hooks h;

	hooks_init(&h, &memory);
	cni_arena_init(&arena, &memory);
	cni_arena_reset(&arena);
	CHECK(h.calls == 0);
	cni_arena_deinit(&arena);
	CHECK(h.calls == 0 && h.pieces == 0);
}

static void t_push_is_aligned_and_lifo(void)
{
	cni_memory memory;
	cni_arena arena;
	hooks h;
	uint8_t *a, *b, *c;

	hooks_init(&h, &memory);
	cni_arena_init(&arena, &memory);
	REQUIRE(cni_arena_reserve(&arena, 1024));
	CHECK(arena.capacity == 1024);
	a = cni_arena_push(&arena, 1);
	b = cni_arena_push(&arena, 0);
	c = cni_arena_push(&arena, 130);
	REQUIRE(a != NULL && b != NULL && c != NULL);
	CHECK((uintptr_t)a % 64 == 0 && (uintptr_t)b % 64 == 0 && (uintptr_t)c % 64 == 0);
	CHECK(b >= a + 1 && c >= b && a != b && b != c);
	CHECK(arena.used == 64 + 64 + 192 && arena.in_use == arena.used);
	CHECK(cni_arena_pop(&arena, c) == 1);
	CHECK(cni_arena_push(&arena, 10) == c);
	CHECK(cni_arena_pop(&arena, c) == 1);
	CHECK(cni_arena_pop(&arena, NULL) == 1);
	CHECK(arena.entry_count == 2);
	CHECK(cni_arena_pop(&arena, b) == 1);
	CHECK(cni_arena_pop(&arena, a) == 1);
	CHECK(arena.used == 0 && arena.in_use == 0 && arena.fallbacks == 0);
	cni_arena_deinit(&arena);
	CHECK(h.pieces == 0 && h.wrong_frees == 0);
}

/* Out of order: refused with nothing changed in release builds, an assert in debug builds. */
static void t_pop_out_of_order_is_refused(void)
{
	cni_memory memory;
	cni_arena arena, before;
	hooks h;
	void *a, *b;
	int32_t other;

	hooks_init(&h, &memory);
	cni_arena_init(&arena, &memory);
	a = cni_arena_push(&arena, 10);
	b = cni_arena_push(&arena, 10);
	REQUIRE(a != NULL && b != NULL);
	before = arena;
#ifdef CNI_DEBUG
	CHECK(TRIPS(cni_arena_pop(&arena, a)));
	CHECK(TRIPS(cni_arena_pop(&arena, &other)));
#else
	CHECK(cni_arena_pop(&arena, a) == 0);
	CHECK(cni_arena_pop(&arena, &other) == 0);
#endif
	CHECK(arena.entry_count == 2 && arena.in_use == before.in_use && arena.used == before.used);
	CHECK(arena.entries[0].pointer == a && arena.entries[1].pointer == b);
	CHECK(cni_arena_pop(&arena, b) == 1);
	CHECK(cni_arena_pop(&arena, a) == 1);
#ifdef CNI_DEBUG
	CHECK(TRIPS(cni_arena_pop(&arena, a)));
#else
	CHECK(cni_arena_pop(&arena, a) == 0);
#endif
	cni_arena_deinit(&arena);
	CHECK(h.pieces == 0);
}

static void t_full_block_falls_back(void)
{
	cni_memory memory;
	cni_arena arena;
	hooks h;
	uint8_t *a, *b, *c;

	hooks_init(&h, &memory);
	cni_arena_init(&arena, &memory);
	REQUIRE(cni_arena_reserve(&arena, 256));
	a = cni_arena_push(&arena, 128);
	b = cni_arena_push(&arena, 500);
	c = cni_arena_push(&arena, 128);
	CHECK(arena.fallbacks == 1 && arena.entries[1].fallback && !arena.entries[2].fallback);
	CHECK(c == a + 128);
	CHECK(arena.in_use == 256 + 512 && arena.used == 256 && arena.high_water == 768);
	CHECK(cni_arena_pop(&arena, c) && cni_arena_pop(&arena, b) && cni_arena_pop(&arena, a));
	CHECK(h.pieces == 1);
	cni_arena_deinit(&arena);
	CHECK(h.pieces == 0 && h.wrong_frees == 0);
}

static void push_a_frame(cni_arena *arena)
{
	void *a = cni_arena_push(arena, 3000);
	void *b = cni_arena_push(arena, 70);
	void *c;

	cni_arena_pop(arena, b);
	c = cni_arena_push(arena, 5001);
	cni_arena_pop(arena, c);
	cni_arena_pop(arena, a);
	cni_arena_reset(arena);
}

static void t_steady_state_never_falls_back(void)
{
	cni_memory memory;
	cni_arena arena;
	hooks h;
	uint64_t first;
	int32_t i;

	hooks_init(&h, &memory);
	cni_arena_init(&arena, &memory);
	push_a_frame(&arena);
	first = arena.fallbacks;
	CHECK(first == 3);
	CHECK(arena.high_water == 3008 + 5056 && arena.capacity == 8192);
	h.calls = 0;
	for (i = 0; i < 10; ++i)
		push_a_frame(&arena);
	CHECK_LE("fallbacks after the first frame", arena.fallbacks - first, 0, "entries");
	CHECK_LE("allocator calls after the first frame", h.calls, 0, "calls");
	cni_arena_deinit(&arena);
	CHECK(h.pieces == 0 && h.wrong_frees == 0);
}

static void t_reset_pops_what_is_left(void)
{
	cni_memory memory;
	cni_arena arena;
	hooks h;

	hooks_init(&h, &memory);
	cni_arena_init(&arena, &memory);
	REQUIRE(cni_arena_reserve(&arena, 128));
	cni_arena_push(&arena, 128);
	cni_arena_push(&arena, 1000);
	cni_arena_push(&arena, 10);
	cni_arena_reset(&arena);
	CHECK(arena.entry_count == 0 && arena.used == 0 && arena.in_use == 0 && h.pieces == 1);
	CHECK(arena.capacity == 4096);
	cni_arena_push(&arena, 5000);
	cni_arena_deinit(&arena);
	CHECK(h.pieces == 0);
}

static void t_entries_run_out(void)
{
	cni_memory memory;
	cni_arena arena;
	hooks h;
	int32_t i;

	hooks_init(&h, &memory);
	cni_arena_init(&arena, &memory);
	for (i = 0; i < CNI_ARENA_ENTRIES; ++i)
		CHECK(cni_arena_push(&arena, 8) != NULL);
	h.calls = 0;
	CHECK(cni_arena_push(&arena, 8) == NULL);
	CHECK(arena.entry_count == CNI_ARENA_ENTRIES && h.calls == 0);
	cni_arena_reset(&arena);
	CHECK(cni_arena_push(&arena, 8) != NULL);
	cni_arena_deinit(&arena);
	CHECK(h.pieces == 0);
}

static void t_no_memory_changes_nothing(void)
{
	cni_memory memory;
	cni_arena arena;
	hooks h;
	uint8_t *block;
	void *a;

	hooks_init(&h, &memory);
	cni_arena_init(&arena, &memory);
	REQUIRE(cni_arena_reserve(&arena, 100));
	block = arena.block;
	h.fail_at = h.calls + 1;
	h.fail_after = 1;
	CHECK(cni_arena_reserve(&arena, 5000) == 0);
	CHECK(arena.block == block && arena.capacity == 128);
	CHECK(cni_arena_push(&arena, 129) == NULL);
	CHECK(cni_arena_push(&arena, UINT64_MAX) == NULL);
	CHECK(arena.entry_count == 0 && arena.in_use == 0 && arena.fallbacks == 0 && arena.high_water == 0);
	h.fail_at = 0;
	a = cni_arena_push(&arena, 1000);
	CHECK(a != NULL);
	h.fail_at = h.calls + 1;
	cni_arena_reset(&arena);
	CHECK(arena.block == block && arena.capacity == 128);
	h.fail_at = 0;
	cni_arena_reset(&arena);
	CHECK(arena.capacity == 4096);
	cni_arena_deinit(&arena);
	CHECK(h.pieces == 0 && h.wrong_frees == 0);
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(t_takes_nothing_until_used);
	RUN(t_push_is_aligned_and_lifo);
	RUN(t_pop_out_of_order_is_refused);
	RUN(t_full_block_falls_back);
	RUN(t_steady_state_never_falls_back);
	RUN(t_reset_pops_what_is_left);
	RUN(t_entries_run_out);
	RUN(t_no_memory_changes_nothing);
	return test_end();
}
