/* Promises of base/handles.h: stale handles stay refused, oldest slot first, constant memory, atomic reserve. */
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

/* One slot, all the time: it wears out its index, then one alias after the other, with the same memory. */
static void t_many_lives_of_a_slot(void)
{
	enum { LIVES = TEST_FORM(10000000, 2000000, 400000), EACH = 1009 };
	static uint32_t dead[LIVES / EACH + 1];
	uint64_t bytes = 0;
	uint32_t first = 0, last = 0;
	int32_t k, wrong = 0, count = 0, revived = 0;

	begin(CNI_KIND_JOINT);
	for (k = 0; k < LIVES; ++k) {
		uint32_t handle;

		REQUIRE(take() == 0);
		handle = cni_handles_of(&handles, 0);
		wrong += handle == last || cni_handles_find(&handles, handle) != 0 || (handle >> 20 & 3u) != CNI_KIND_JOINT || handle >> 22 == 0;
		if (k == 0)
			first = handle;
		else
			revived += cni_handles_find(&handles, first) != CNI_NONE || cni_handles_find(&handles, last) != CNI_NONE;
		if (k % EACH == 0)
			dead[count++] = handle;
		if (k == 2000)
			bytes = memory.bytes_in_use;
		last = handle;
		cni_handles_release(&handles, 0);
		wrong += cni_handles_find(&handles, handle) != CNI_NONE;
	}
	REQUIRE(take() == 0);
	for (k = 0; k < count; ++k)
		revived += cni_handles_find(&handles, dead[k]) != CNI_NONE;
	CHECK_LE("wrong answers", wrong, 0, "");
	CHECK_LE("handles that came alive again", revived, 0, "handles");
	CHECK_LE("bytes grown after 2,000 lives", memory.bytes_in_use - bytes, 0, "bytes");
	CHECK(cni_handles_used(&handles) == 1 && handles.count == 1);
	end();
}

static uint32_t wear_out(void)
{
	uint32_t handle = 0;
	int32_t k;

	for (k = 0; k < 1023; ++k) {
		int32_t slot = take();

		handle = cni_handles_of(&handles, slot);
		cni_handles_release(&handles, slot);
	}
	return handle;
}

/* Slots grow into indices that have been aliases: those slots get aliases at once. */
static void t_own_indices_are_no_aliases(void)
{
	uint32_t alias, grown[8];
	int32_t k, wrong = 0;

	begin(CNI_KIND_BODY);
	handles.alias_next = 4; /* as if all above had been given */
	wear_out();
	CHECK(take() == 0);
	alias = cni_handles_of(&handles, 0);
	CHECK((alias & 0xFFFFFu) == 3);
	for (k = 0; k < 8; ++k) {
		grown[k] = cni_handles_of(&handles, take());
		wrong += cni_handles_find(&handles, grown[k]) != k + 1 || (grown[k] & 0xFFFFFu) == 3;
	}
	CHECK(cni_handles_find(&handles, alias) == 0 && cni_handles_of(&handles, 0) == alias);
	CHECK_LE("new slots under an index that was given", wrong, 0, "");
	end();
}

/* When all have been given they begin again, passing by those that are alive. */
static void t_aliases_begin_again(void)
{
	uint32_t kept, next;
	int32_t k;

	begin(CNI_KIND_BODY);
	wear_out();
	CHECK(take() == 0);
	kept = cni_handles_of(&handles, 0);
	CHECK((kept & 0xFFFFFu) == 0xFFFFFu);
	for (k = 1; k <= 2; ++k)
		CHECK(take() == k);
	for (k = 1; k <= 2; ++k)
		cni_handles_release(&handles, k);
	handles.alias_next = 3;
	for (k = 0; k < 2; ++k)
		wear_out();
	CHECK(take() == 1 && take() == 2);
	next = cni_handles_of(&handles, 1);
	CHECK((next & 0xFFFFFu) == 0xFFFFEu);
	CHECK(cni_handles_find(&handles, kept) == 0 && cni_handles_find(&handles, next) == 1);
	end();
}

static void t_aliases_need_memory(void)
{
	uint32_t handle;

	begin(CNI_KIND_BODY);
	wear_out();
	h.fail_at = h.calls + 1;
	h.fail_after = 1;
	CHECK(cni_handles_reserve(&handles, &memory, 1) == CN_ERROR_MEMORY);
	h.fail_at = 0;
	CHECK(take() == 0);
	handle = cni_handles_of(&handles, 0);
	CHECK(cni_handles_find(&handles, handle) == 0);
	end();
	begin(CNI_KIND_BODY);
	CHECK(cni_handles_reserve(&handles, &memory, 1) == CN_OK && cni_handles_reserve_aliases(&handles, &memory, 1));
	h.fail_at = h.calls + 1;
	h.fail_after = 1;
	wear_out();
	CHECK(take() == 0);
	h.fail_at = 0;
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
	CHECK_GE("slots with an alias", handles.aliases.count, 20, "slots");
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
	/* Two slots wear out where one index is left, again and again: whatever they get, they are told apart. */
	for (i = 0; i < 4; ++i) {
		cni_handles_release(&handles, 77);
		cni_handles_release(&handles, 78);
		wear_out();
		wear_out();
		CHECK(take() + take() == 77 + 78);
		CHECK(cni_handles_find(&handles, cni_handles_of(&handles, 77)) == 77 && cni_handles_find(&handles, cni_handles_of(&handles, 78)) == 78);
		CHECK(cni_handles_find(&handles, cni_handles_of(&handles, 79)) == 79);
	}
	end();
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(t_layout);
	RUN(t_oldest_first);
	RUN(t_many_lives_of_a_slot);
	RUN(t_own_indices_are_no_aliases);
	RUN(t_aliases_begin_again);
	RUN(t_aliases_need_memory);
	RUN(t_random_life);
	RUN(t_reserve_is_certain_and_atomic);
	RUN(t_indices_run_out);
	return test_end();
}
