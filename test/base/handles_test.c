/* Promises of base/handles.h: stale handles never come alive, oldest slot first, atomic reserve. */
#include "hooks.h"

#include "base/handles.h"

#include "../test.h"

static cni_memory memory;
static hooks h;
static cni_handles handles;

static void begin(int32_t kind)
{
	hooks_init(&h, &memory);
	cni_handles_init(&handles, kind);
}

static void end(void)
{
	cni_handles_deinit(&handles, &memory);
	CHECK(h.pieces == 0 && h.wrong_frees == 0);
	CHECK(cni_handles_used(&handles) == 0);
}

static int32_t take(void)
{
	int32_t expected, index;

	if (cni_handles_reserve(&handles, &memory, 1) != CN_OK)
		return CNI_NONE;
	expected = cni_handles_peek(&handles);
	index = cni_handles_take(&handles);
	CHECK(index == expected);
	return index;
}

static void t_layout(void)
{
	int32_t kind;

	for (kind = 0; kind < 4; ++kind) {
		begin(kind);
		CHECK(take() == 0 && take() == 1);
		CHECK(cni_handles_of(&handles, 1) == (1u << 22 | (uint32_t)kind << 20 | 1u));
		CHECK(cni_handles_find(&handles, 1u << 22 | (uint32_t)kind << 20 | 1u) == 1);
		CHECK(cni_handles_find(&handles, 1u << 22 | (uint32_t)((kind + 1) & 3) << 20 | 1u) == CNI_NONE);
		CHECK(cni_handles_find(&handles, 2u << 22 | (uint32_t)kind << 20 | 1u) == CNI_NONE);
		CHECK(cni_handles_find(&handles, 1u << 22 | (uint32_t)kind << 20 | 2u) == CNI_NONE);
		CHECK(cni_handles_find(&handles, 0) == CNI_NONE);
		CHECK(cni_handles_find(&handles, UINT32_MAX) == CNI_NONE);
		end();
	}
}

static void t_oldest_first(void)
{
	int32_t i;

	begin(CNI_KIND_SHAPE);
	for (i = 0; i < 10; ++i)
		CHECK(take() == i);
	cni_handles_release(&handles, 7);
	cni_handles_release(&handles, 2);
	cni_handles_release(&handles, 5);
	CHECK(handles.count == 7 && cni_handles_used(&handles) == 10);
	CHECK(!cni_handles_alive(&handles, 7) && cni_handles_alive(&handles, 6));
	CHECK(!cni_handles_alive(&handles, -1) && !cni_handles_alive(&handles, 10));
	CHECK(take() == 7);
	cni_handles_release(&handles, 0);
	CHECK(take() == 2 && take() == 5 && take() == 0 && take() == 10);
	CHECK(cni_handles_of(&handles, 7) >> 22 == 2 && cni_handles_of(&handles, 10) >> 22 == 1);
	end();
}

static void t_slot_retires_after_its_generations(void)
{
	uint32_t seen = 0;
	int32_t i, repeats = 0;

	begin(CNI_KIND_JOINT);
	for (i = 1; i <= 1023; ++i) {
		uint32_t handle;

		REQUIRE(take() == 0);
		handle = cni_handles_of(&handles, 0);
		repeats += handle <= seen || cni_handles_find(&handles, handle) != 0;
		repeats += seen != 0 && cni_handles_find(&handles, seen) != CNI_NONE;
		seen = handle;
		cni_handles_release(&handles, 0);
		repeats += cni_handles_find(&handles, handle) != CNI_NONE;
	}
	CHECK_LE("handles that came alive again", repeats, 0, "handles");
	CHECK(seen >> 22 == 1023 && handles.retired == 1);
	CHECK(take() == 1);
	CHECK(cni_handles_find(&handles, seen) == CNI_NONE && !cni_handles_alive(&handles, 0));
	CHECK(cni_handles_used(&handles) == 2 && handles.count == 1);
	end();
}

/* Against a plain list of all handles ever given out: exactly the live ones are found. */
static void t_random_life(void)
{
	enum { LIVE = 40, ROUNDS = 200000 };
	static uint32_t live[LIVE];
	uint32_t state = 99, dead[64] = {0};
	int32_t i, round, count = 0, wrong = 0;

	begin(CNI_KIND_CONSTRAINT);
	for (round = 0; round < ROUNDS; ++round) {
		if (count < LIVE && (count == 0 || random_next(&state) & 1)) {
			live[count++] = cni_handles_of(&handles, take());
		} else {
			i = (int32_t)(random_next(&state) % (uint32_t)count);
			dead[round & 63] = live[i];
			cni_handles_release(&handles, cni_handles_find(&handles, live[i]));
			live[i] = live[--count];
		}
		i = (int32_t)(random_next(&state) & 63);
		wrong += cni_handles_find(&handles, dead[i]) != CNI_NONE;
		if (count > 0)
			wrong += cni_handles_find(&handles, live[(uint32_t)i % (uint32_t)count]) == CNI_NONE;
		wrong += handles.count != count;
	}
	/* Any 32 bits may come in. */
	for (round = 0; round < ROUNDS; ++round) {
		uint32_t any = random_next(&state);
		int32_t index = cni_handles_find(&handles, any);

		wrong += index != CNI_NONE && cni_handles_of(&handles, index) != any;
	}
	CHECK_LE("wrong answers", wrong, 0, "");
	CHECK_GE("slots retired on the way", handles.retired, 1, "slots");
	end();
}

static void t_reserve_is_certain_and_atomic(void)
{
	cni_handles before;
	int32_t i;

	begin(CNI_KIND_BODY);
	h.fail_at = 1;
	h.fail_after = 1;
	CHECK(cni_handles_reserve(&handles, &memory, 1) == CN_ERROR_MEMORY);
	CHECK(cni_handles_used(&handles) == 0);
	h.fail_at = 0;
	CHECK(cni_handles_reserve(&handles, &memory, 100) == CN_OK);
	h.fail_at = h.calls + 1;
	for (i = 0; i < 100; ++i)
		cni_handles_take(&handles);
	for (i = 10; i < 40; ++i)
		cni_handles_release(&handles, i);
	CHECK(cni_handles_reserve(&handles, &memory, 30) == CN_OK);
	before = handles;
	CHECK(cni_handles_reserve(&handles, &memory, 1000) == CN_ERROR_MEMORY);
	CHECK(memcmp(&before, &handles, sizeof handles) == 0);
	for (i = 10; i < 40; ++i)
		CHECK(cni_handles_take(&handles) == i);
	end();
}

static void t_indices_run_out(void)
{
	cni_handles before;
	int32_t i;

	begin(CNI_KIND_BODY);
	CHECK(cni_handles_reserve(&handles, &memory, CN_MAX_HANDLES + 1) == CN_ERROR_CAPACITY);
	CHECK(cni_handles_reserve(&handles, &memory, INT32_MAX) == CN_ERROR_CAPACITY);
	CHECK(h.calls == 0);
	REQUIRE(cni_handles_reserve(&handles, &memory, CN_MAX_HANDLES) == CN_OK);
	for (i = 0; i < CN_MAX_HANDLES; ++i)
		cni_handles_take(&handles);
	before = handles;
	CHECK(cni_handles_reserve(&handles, &memory, 1) == CN_ERROR_CAPACITY);
	CHECK(memcmp(&before, &handles, sizeof handles) == 0);
	CHECK(cni_handles_find(&handles, cni_handles_of(&handles, CN_MAX_HANDLES - 1)) == CN_MAX_HANDLES - 1);
	cni_handles_release(&handles, 77);
	CHECK(take() == 77);
	end();
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(t_layout);
	RUN(t_oldest_first);
	RUN(t_slot_retires_after_its_generations);
	RUN(t_random_life);
	RUN(t_reserve_is_certain_and_atomic);
	RUN(t_indices_run_out);
	return test_end();
}
