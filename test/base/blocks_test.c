/* Promises of base/blocks.h: best fit, stable addresses, no waste, atomic failure. */
#include "hooks.h"

#include "base/blocks.h"

#include "../test.h"

static const uint64_t classes[CNI_BLOCK_CLASSES] = {16,  32,  48,  64,  96,   128,  192, 256,
                                                    384, 512, 768, 1024, 1536, 2048, 4096};

/* Every unit of the class chunks is in use, free or in the tail. */
static int64_t bytes_lost(const cni_blocks *blocks)
{
	uint64_t known = blocks->bytes_in_use + (uint64_t)blocks->tail_units * CNI_BLOCK_UNIT;
	int32_t i;

	for (i = 0; i < CNI_BLOCK_CLASSES; ++i)
		known += (uint64_t)blocks->free_count[i] * classes[i];
	return (int64_t)(blocks->bytes_in_chunks - known);
}

static int32_t free_lists_match_counts(const cni_blocks *blocks)
{
	int32_t i;

	for (i = 0; i < CNI_BLOCK_CLASSES; ++i) {
		cni_ref ref = blocks->free_head[i];
		int32_t count = 0;

		while (ref != 0 && count <= blocks->free_count[i]) {
			memcpy(&ref, cni_blocks_at(blocks, ref), sizeof ref);
			++count;
		}
		if (count != blocks->free_count[i])
			return 0;
	}
	return 1;
}

static void t_best_fit(void)
{
	cni_memory memory;
	cni_blocks blocks;
	hooks h;
	uint64_t bytes;
	int32_t wrong = 0, i = 0;

	for (bytes = 1; bytes <= 4096; ++bytes) {
		if (bytes > classes[i])
			++i;
		wrong += cni_blocks_rounded(bytes) != classes[i];
	}
	CHECK_LE("sizes with another class than the best", wrong, 0, "sizes");
	CHECK(cni_blocks_rounded(4097) == 4160);
	hooks_init(&h, &memory);
	cni_blocks_init(&blocks, &memory);
	for (i = 0; i < CNI_BLOCK_CLASSES; ++i) {
		uint64_t before = blocks.bytes_in_use;
		cni_ref ref = cni_blocks_alloc(&blocks, classes[i] - 15);

		CHECK(ref != 0 && (uintptr_t)cni_blocks_at(&blocks, ref) % 16 == 0);
		CHECK(blocks.bytes_in_use - before == classes[i]);
		cni_blocks_free(&blocks, ref, classes[i] - 15);
		CHECK(cni_blocks_alloc(&blocks, classes[i]) == ref);
	}
	CHECK(bytes_lost(&blocks) == 0);
	cni_blocks_deinit(&blocks);
	CHECK(h.pieces == 0 && h.wrong_frees == 0);
}

static void t_first_chunk_is_small(void)
{
	cni_memory memory;
	cni_blocks blocks;
	hooks h;
	uint64_t largest = 0, unused = 0;
	int32_t i;

	hooks_init(&h, &memory);
	cni_blocks_init(&blocks, &memory);
	CHECK(h.calls == 0);
	cni_blocks_alloc(&blocks, 1);
	CHECK_LE("memory after the first piece", memory.bytes_in_use, 4096 + 128, "bytes");
	for (i = 0; i < 20000; ++i) {
		uint64_t spare;

		CHECK(cni_blocks_alloc(&blocks, 100) != 0);
		spare = blocks.bytes_in_chunks - blocks.bytes_in_use;
		if (blocks.bytes_in_use > 65536 && spare * 1000 / blocks.bytes_in_chunks > unused)
			unused = spare * 1000 / blocks.bytes_in_chunks;
	}
	for (i = 1; i < blocks.chunks.count; ++i)
		largest = largest > blocks.chunks.bytes[i] ? largest : blocks.chunks.bytes[i];
	CHECK_LE("largest class chunk", largest, 65536, "bytes");
	CHECK_GE("largest class chunk", largest, 65536 - 128, "bytes");
	CHECK_LE("room unused while growing", (double)unused / 10, 7, "%");
	CHECK(bytes_lost(&blocks) == 0);
	cni_blocks_deinit(&blocks);
	CHECK(h.pieces == 0);
}

static void t_large_pieces(void)
{
	cni_memory memory;
	cni_blocks blocks;
	hooks h;
	cni_ref a, b, c;

	hooks_init(&h, &memory);
	cni_blocks_init(&blocks, &memory);
	a = cni_blocks_alloc(&blocks, 4097);
	b = cni_blocks_alloc(&blocks, 300000);
	CHECK(a != 0 && b != 0 && (a & 4095) == 0 && (b & 4095) == 0);
	CHECK(blocks.bytes_large == 4160 + 300032 && blocks.bytes_in_use == 0 && blocks.bytes_in_chunks == 0);
	memset(cni_blocks_at(&blocks, b), 7, 300000);
	cni_blocks_free(&blocks, a, 4097);
	CHECK(blocks.chunks.at[a >> 12] == NULL);
	CHECK(h.bytes == cni_memory_rounded(300000) + 8u * (sizeof(uint64_t) + sizeof(void *)));
	c = cni_blocks_alloc(&blocks, 16);
	CHECK(c >> 12 == a >> 12);
	a = cni_blocks_alloc(&blocks, 5000);
	cni_blocks_free(&blocks, b, 300000);
	cni_blocks_free(&blocks, a, 5000);
	cni_blocks_free(&blocks, 0, 5000);
	cni_blocks_free(&blocks, c, 16);
	CHECK(blocks.bytes_large == 0 && blocks.bytes_in_use == 0 && bytes_lost(&blocks) == 0);
	cni_blocks_deinit(&blocks);
	CHECK(h.pieces == 0 && h.wrong_frees == 0);
}

static void t_tail_is_carved_not_lost(void)
{
	cni_memory memory;
	cni_blocks blocks;
	hooks h;
	int32_t i;

	hooks_init(&h, &memory);
	cni_blocks_init(&blocks, &memory);
	for (i = 0; i < 5; ++i)
		CHECK(cni_blocks_alloc(&blocks, 16) != 0);
	CHECK(blocks.tail_units == 251);
	CHECK(cni_blocks_alloc(&blocks, 4096) != 0);
	/* 251 units: 128 + 96 + 24 + 3 */
	CHECK(blocks.free_count[13] == 1 && blocks.free_count[12] == 1 && blocks.free_count[8] == 1 && blocks.free_count[2] == 1);
	CHECK(bytes_lost(&blocks) == 0 && blocks.tail_units == 0);
	cni_blocks_deinit(&blocks);
	CHECK(h.pieces == 0);
}

static void t_reserve_makes_allocs_certain(void)
{
	cni_memory memory;
	cni_blocks blocks;
	hooks h;
	cni_ref previous = 0;
	int32_t i, failed = 0, unordered = 0;

	hooks_init(&h, &memory);
	cni_blocks_init(&blocks, &memory);
	CHECK(cni_blocks_reserve(&blocks, 200, 0) == 1 && h.calls == 0);
	REQUIRE(cni_blocks_reserve(&blocks, 384, 1000));
	REQUIRE(cni_blocks_reserve(&blocks, 40, 77));
	CHECK_LE("memory for 1000 x 384 and 77 x 48", h.bytes, 1000 * 384 + 90000, "bytes");
	h.fail_at = h.calls + 1;
	h.fail_after = 1;
	for (i = 0; i < 77; ++i)
		failed += cni_blocks_alloc(&blocks, 33) == 0;
	for (i = 0; i < 1000; ++i) {
		cni_ref ref = cni_blocks_alloc(&blocks, 300);

		failed += ref == 0;
		unordered += previous >> 12 == ref >> 12 && ref < previous;
		previous = ref;
	}
	CHECK_LE("reserved pieces that could not be had", failed, 0, "pieces");
	CHECK_LE("pieces out of address order within a chunk", unordered, 0, "pieces");
	CHECK(bytes_lost(&blocks) == 0 && free_lists_match_counts(&blocks));
	CHECK(cni_blocks_reserve(&blocks, 4096, 100) == 0);
	CHECK(bytes_lost(&blocks) == 0);
	h.fail_at = 0;
	cni_blocks_deinit(&blocks);
	CHECK(h.pieces == 0 && h.wrong_frees == 0);
}

/* In a block of exactly those bytes, and with none left over but the ends of chunks. */
static void t_exact_reserves_fit_in_their_bytes(void)
{
	enum { MOST = 1 << 20 };
	static uint8_t room[MOST + 64];
	uint8_t *block = room + (64 - (uintptr_t)room % 64);
	int32_t i, k, failed = 0, small = 0;
	uint32_t random = 7;

	for (i = 0; i < 500; ++i) {
		cni_pieces pieces[3];
		cni_memory memory;
		cni_blocks blocks;
		uint64_t bytes;

		for (k = 0; k < 3; ++k) {
			pieces[k].bytes = 16u + random_next(&random) % 300u;
			pieces[k].count = (int32_t)(random_next(&random) % (i % 2 ? 600u : 20u));
		}
		bytes = cni_blocks_bytes_for(pieces, 3);
		cni_memory_init_block(&memory, block, bytes);
		cni_blocks_init(&blocks, &memory);
		failed += bytes > MOST || !cni_blocks_reserve_exact(&blocks, pieces, 3);
		small += memory.bytes_in_use + 256 < bytes;
		for (k = 0; k < 3; ++k)
			for (; pieces[k].count > 0; --pieces[k].count)
				failed += cni_blocks_alloc(&blocks, pieces[k].bytes) == 0;
		CHECK(bytes_lost(&blocks) == 0);
		cni_blocks_deinit(&blocks);
	}
	CHECK_LE("reserves and pieces that failed", failed, 0, "");
	CHECK_LE("reserves that left more than 256 bytes", small, 0, "");
}

/* Pieces that are free already count: only what is lacking is taken out of the tail, which all classes share. */
static void t_reserve_takes_only_what_is_lacking(void)
{
	cni_memory memory;
	cni_blocks blocks;
	hooks h;
	int32_t i, count, wrong = 0, class_64 = 3;
	cni_ref refs[6];

	for (count = 6; count <= 80; ++count) {
		hooks_init(&h, &memory);
		cni_blocks_init(&blocks, &memory);
		for (i = 0; i < 6; ++i)
			refs[i] = cni_blocks_alloc(&blocks, 64);
		for (i = 0; i < 6; ++i)
			cni_blocks_free(&blocks, refs[i], 64);
		REQUIRE(cni_blocks_reserve(&blocks, 64, count));
		wrong += blocks.free_count[class_64] != count || bytes_lost(&blocks) != 0;
		cni_blocks_deinit(&blocks);
	}
	CHECK_LE("reserves that took more or less", wrong, 0, "");
}

static void t_fixed_block_is_used_to_its_end(void)
{
	enum { BYTES = 100000 };
	static uint8_t room[BYTES + 64];
	cni_memory memory;
	cni_blocks blocks;
	int32_t count = 0;

	cni_memory_init_block(&memory, room + (64 - (uintptr_t)room % 64), BYTES);
	cni_blocks_init(&blocks, &memory);
	while (cni_blocks_alloc(&blocks, 384) != 0)
		++count;
	CHECK_GE("pieces of 384 bytes from 100000 bytes", count, 254, "pieces");
	CHECK(bytes_lost(&blocks) == 0);
}

/* Pieces filled with their own pattern keep it through growth of everything around them; every 7th
   call of the allocator fails. */
static void t_random_life_with_failures(void)
{
	enum { PIECES = 2000, ROUNDS = 60000 };
	static cni_ref refs[PIECES];
	static uint32_t sizes[PIECES];
	static uint8_t *addresses[PIECES];
	cni_memory memory;
	cni_blocks blocks;
	hooks h;
	uint32_t state = 777, k;
	uint64_t in_use = 0, large = 0;
	int32_t round, refused = 0, disturbed = 0;

	hooks_init(&h, &memory);
	cni_blocks_init(&blocks, &memory);
	memset(refs, 0, sizeof refs);
	for (round = 0; round < ROUNDS; ++round) {
		int32_t i = (int32_t)(random_next(&state) % PIECES);
		uint32_t rounded;

		h.fail_at = (h.calls / 7 + 1) * 7;
		if (refs[i] != 0) {
			uint8_t *piece = cni_blocks_at(&blocks, refs[i]);

			disturbed += piece != addresses[i];
			for (k = 0; k < sizes[i]; ++k)
				disturbed += piece[k] != (uint8_t)(i * 31 + 1);
			cni_blocks_free(&blocks, refs[i], sizes[i]);
			rounded = (uint32_t)cni_blocks_rounded(sizes[i]);
			if (sizes[i] > 4096)
				large -= rounded;
			else
				in_use -= rounded;
			refs[i] = 0;
			continue;
		}
		sizes[i] = 1 + (random_next(&state) & ((16u << random_next(&state) % 10) - 1));
		refs[i] = cni_blocks_alloc(&blocks, sizes[i]);
		refused += refs[i] == 0;
		if (refs[i] != 0) {
			addresses[i] = cni_blocks_at(&blocks, refs[i]);
			memset(addresses[i], i * 31 + 1, sizes[i]);
			rounded = (uint32_t)cni_blocks_rounded(sizes[i]);
			if (sizes[i] > 4096)
				large += rounded;
			else
				in_use += rounded;
		}
		disturbed += blocks.bytes_in_use != in_use || blocks.bytes_large != large || bytes_lost(&blocks) != 0;
	}
	CHECK_LE("disturbed bytes or counters", disturbed, 0, "");
	CHECK_GE("requests refused", refused, 10, "calls");
	CHECK(free_lists_match_counts(&blocks));
	cni_blocks_deinit(&blocks);
	CHECK(h.pieces == 0 && h.bytes == 0 && h.wrong_frees == 0);
}

/* A mixed run with everything failing from the n-th allocator call on, for every n. */
static void t_out_of_memory_at_every_call(void)
{
	int32_t n, i, broken = 0, reached = 0;

	for (n = 1; n < 60; ++n) {
		cni_memory memory;
		cni_blocks blocks;
		hooks h;

		hooks_init(&h, &memory);
		h.fail_at = n;
		h.fail_after = 1;
		cni_blocks_init(&blocks, &memory);
		for (i = 0; i < 300; ++i) {
			uint64_t bytes = (uint64_t)(i * 37 % 6000 + 1);
			cni_blocks before = blocks;
			cni_ref ref = cni_blocks_alloc(&blocks, bytes);

			reached += ref == 0;
			broken += ref == 0 && (before.bytes_in_use != blocks.bytes_in_use || before.bytes_large != blocks.bytes_large ||
			                       before.bytes_in_chunks != blocks.bytes_in_chunks || before.tail != blocks.tail ||
			                       before.tail_units != blocks.tail_units || before.empty_slot != blocks.empty_slot ||
			                       memcmp(before.free_count, blocks.free_count, sizeof before.free_count) != 0);
			broken += bytes_lost(&blocks) != 0;
		}
		broken += cni_blocks_reserve(&blocks, 4096, 100) != 0;
		broken += bytes_lost(&blocks) != 0 || !free_lists_match_counts(&blocks);
		h.fail_at = 0;
		broken += cni_blocks_alloc(&blocks, 5000) == 0;
		cni_blocks_deinit(&blocks);
		broken += h.pieces != 0 || h.wrong_frees != 0;
	}
	CHECK_LE("changes made by failed calls", broken, 0, "");
	CHECK_GE("failed calls", reached, 60, "calls");
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(t_best_fit);
	RUN(t_first_chunk_is_small);
	RUN(t_large_pieces);
	RUN(t_tail_is_carved_not_lost);
	RUN(t_reserve_makes_allocs_certain);
	RUN(t_reserve_takes_only_what_is_lacking);
	RUN(t_exact_reserves_fit_in_their_bytes);
	RUN(t_fixed_block_is_used_to_its_end);
	RUN(t_random_life_with_failures);
	RUN(t_out_of_memory_at_every_call);
	return test_end();
}
