/* Promises of base/memory.h: hooks, default allocator, fixed block. */
#include "hooks.h"

#include "../test.h"

#define BLOCK_BYTES 65536

static uint8_t room[BLOCK_BYTES + 3 * 64];

/* A 64-byte aligned block with a guard of 64 bytes on both sides. */
static uint8_t *guarded_block(void)
{
	uint8_t *block = room + 64 + (64 - (uintptr_t)room % 64) % 64;

	memset(room, 0xEE, sizeof room);
	return block;
}

static int32_t guards_intact(const uint8_t *block)
{
	int32_t i, good = 1;

	for (i = 0; i < 64; ++i)
		good = good && block[-1 - i] == 0xEE && block[BLOCK_BYTES + i] == 0xEE;
	return good;
}

static int32_t hole_count(const cni_memory *memory, uint64_t *first_bytes)
{
	cni_memory copy = *memory;
	int32_t count = 0;

	/* The holes are opaque: the largest piece that can still be had is found by trying. */
	*first_bytes = 0;
	while (copy.holes != NULL && count < 1000) {
		struct {
			void *next;
			uint64_t bytes;
		} hole;

		memcpy(&hole, (const void *)copy.holes, sizeof hole);
		*first_bytes = *first_bytes > hole.bytes ? *first_bytes : hole.bytes;
		memcpy((void *)&copy.holes, &hole.next, sizeof copy.holes);
		++count;
	}
	return count;
}

static void t_default_is_aligned(void)
{
	cni_memory memory;
	uint64_t sizes[6] = {1, 7, 64, 65, 1000, 100000};
	void *pieces[6];
	int32_t i;

	cni_memory_init_hooks(&memory, NULL, NULL, NULL);
	for (i = 0; i < 6; ++i) {
		pieces[i] = cni_memory_alloc(&memory, sizes[i]);
#ifdef CN_NO_MALLOC
		CHECK(pieces[i] == NULL);
#else
		REQUIRE(pieces[i] != NULL);
		CHECK((uintptr_t)pieces[i] % 64 == 0);
		memset(pieces[i], 1, (size_t)sizes[i]);
#endif
	}
	for (i = 0; i < 6; ++i)
		cni_memory_free(&memory, pieces[i], sizes[i]);
	CHECK(memory.bytes_in_use == 0);
	CHECK(memory.calls == 6);
	CHECK(cni_memory_alloc(&memory, UINT64_MAX) == NULL);
	CHECK(cni_memory_alloc(&memory, UINT64_MAX - 70) == NULL);
	CHECK(memory.bytes_in_use == 0);
}

static void t_hooks_get_what_was_asked(void)
{
	cni_memory memory;
	hooks h;
	void *a, *b;

	hooks_init(&h, &memory);
	a = cni_memory_alloc(&memory, 100);
	b = cni_memory_alloc(&memory, 33);
	CHECK(h.bytes == 133 && memory.bytes_in_use == 133);
	h.fail_at = 3;
	CHECK(cni_memory_alloc(&memory, 5) == NULL);
	CHECK(memory.bytes_in_use == 133 && memory.calls == 3);
	cni_memory_free(&memory, a, 100);
	cni_memory_free(&memory, NULL, 100);
	CHECK(memory.bytes_in_use == 33 && memory.bytes_peak == 133);
	cni_memory_free(&memory, b, 33);
	CHECK(h.pieces == 0 && h.bytes == 0 && h.wrong_frees == 0);
}

static uint64_t misaligned_room[32];
static int32_t misaligned_out;
static void *misaligned_alloc(uint64_t bytes, uint32_t align, void *user)
{
	uint8_t *p = (uint8_t *)misaligned_room;

	(void)bytes;
	(void)align;
	(void)user;
	++misaligned_out;
	return p + (64 - (uintptr_t)p % 64) + 8;
}
static void misaligned_free(void *memory, uint64_t bytes, void *user)
{
	(void)memory;
	(void)bytes;
	(void)user;
	--misaligned_out;
}

static void t_misaligned_hook_is_no_memory(void)
{
	cni_memory memory;

	cni_memory_init_hooks(&memory, misaligned_alloc, misaligned_free, NULL);
	CHECK(cni_memory_alloc(&memory, 16) == NULL);
	CHECK(misaligned_out == 0 && memory.bytes_in_use == 0);
}

static void t_rounded(void)
{
	CHECK(cni_memory_rounded(1) == 64);
	CHECK(cni_memory_rounded(64) == 64);
	CHECK(cni_memory_rounded(65) == 128);
	CHECK(cni_memory_rounded(UINT64_MAX) % 64 == 0 && cni_memory_rounded(UINT64_MAX) > UINT64_MAX / 2);
}

static void t_block_is_first_fit_in_address_order(void)
{
	uint8_t *block = guarded_block();
	cni_memory memory;
	uint8_t *a, *b, *c, *d;
	uint64_t largest;

	cni_memory_init_block(&memory, block, BLOCK_BYTES);
	a = cni_memory_alloc(&memory, 100);
	b = cni_memory_alloc(&memory, 64);
	c = cni_memory_alloc(&memory, 200);
	d = cni_memory_alloc(&memory, 1);
	CHECK(a == block && b == a + 128 && c == b + 64 && d == c + 256);
	CHECK(memory.bytes_in_use == 128 + 64 + 256 + 64);
	cni_memory_free(&memory, c, 200);
	cni_memory_free(&memory, a, 100);
	CHECK(hole_count(&memory, &largest) == 3);
	CHECK(cni_memory_alloc(&memory, 129) == c);
	CHECK(cni_memory_alloc(&memory, 65) == a);
	cni_memory_free(&memory, a, 65);
	cni_memory_free(&memory, c, 129);
	cni_memory_free(&memory, b, 64);
	CHECK(hole_count(&memory, &largest) == 2);
	cni_memory_free(&memory, d, 1);
	CHECK(hole_count(&memory, &largest) == 1 && largest == BLOCK_BYTES);
	CHECK(memory.bytes_in_use == 0);
	CHECK(guards_intact(block));
}

static void t_block_runs_out_and_recovers(void)
{
	uint8_t *block = guarded_block();
	cni_memory memory;
	void *whole;

	cni_memory_init_block(&memory, block, BLOCK_BYTES);
	CHECK(cni_memory_alloc(&memory, BLOCK_BYTES + 1) == NULL);
	CHECK(cni_memory_alloc(&memory, UINT64_MAX) == NULL);
	whole = cni_memory_alloc(&memory, BLOCK_BYTES);
	CHECK(whole == block);
	CHECK(cni_memory_alloc(&memory, 1) == NULL);
	cni_memory_free(&memory, whole, BLOCK_BYTES);
	CHECK(cni_memory_alloc(&memory, BLOCK_BYTES - 63) == block);
	cni_memory_init_block(&memory, block, 63);
	CHECK(cni_memory_alloc(&memory, 1) == NULL);
	cni_memory_init_block(&memory, block, 127);
	CHECK(cni_memory_alloc(&memory, 1) == block);
	CHECK(cni_memory_alloc(&memory, 1) == NULL);
	CHECK(guards_intact(block));
}

/* Random pieces, each filled with its own byte: none may be disturbed, and in the end all is one hole. */
static void t_block_random_life(void)
{
	enum { PIECES = 100, ROUNDS = 20000 };
	static uint8_t *pieces[PIECES];
	static uint32_t sizes[PIECES];
	uint8_t *block = guarded_block();
	cni_memory memory;
	uint32_t state = 12345;
	uint64_t expected = 0, largest;
	int32_t i, round, refused = 0, disturbed = 0;

	memset(pieces, 0, sizeof pieces);
	cni_memory_init_block(&memory, block, BLOCK_BYTES);
	for (round = 0; round < ROUNDS; ++round) {
		i = (int32_t)(random_next(&state) % PIECES);
		if (pieces[i] != NULL) {
			uint32_t k;

			for (k = 0; k < sizes[i]; ++k)
				disturbed += pieces[i][k] != (uint8_t)i;
			cni_memory_free(&memory, pieces[i], sizes[i]);
			expected -= cni_memory_rounded(sizes[i]);
			pieces[i] = NULL;
		} else {
			sizes[i] = 1 + random_next(&state) % 2500;
			pieces[i] = cni_memory_alloc(&memory, sizes[i]);
			refused += pieces[i] == NULL;
			if (pieces[i] != NULL) {
				memset(pieces[i], i, sizes[i]);
				expected += cni_memory_rounded(sizes[i]);
			}
		}
		if (memory.bytes_in_use != expected)
			++disturbed;
	}
	for (i = 0; i < PIECES; ++i)
		cni_memory_free(&memory, pieces[i], sizes[i]);
	CHECK_LE("disturbed bytes", disturbed, 0, "bytes");
	CHECK_GE("requests refused (the test does run out)", refused, 1, "calls");
	CHECK(hole_count(&memory, &largest) == 1 && largest == BLOCK_BYTES);
	CHECK(memory.bytes_in_use == 0);
	CHECK(guards_intact(block));
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(t_default_is_aligned);
	RUN(t_hooks_get_what_was_asked);
	RUN(t_misaligned_hook_is_no_memory);
	RUN(t_rounded);
	RUN(t_block_is_first_fit_in_address_order);
	RUN(t_block_runs_out_and_recovers);
	RUN(t_block_random_life);
	return test_end();
}
