/* Promises of base/bitset.h. */
#include "hooks.h"

#include "base/bitset.h"

#include "../test.h"

static void t_count_and_lowest(void)
{
	uint32_t state = 5;
	int32_t i, bit, wrong = 0;

	for (i = 0; i < 20000; ++i) {
		uint64_t x = (uint64_t)random_next(&state) << 32 | random_next(&state);
		int32_t count = 0, lowest = -1;

		x <<= random_next(&state) & 63;
		for (bit = 0; bit < 64; ++bit) {
			if (x >> bit & 1) {
				lowest = lowest < 0 ? bit : lowest;
				++count;
			}
		}
		wrong += cni_bit_count64(x) != count;
		wrong += x != 0 && cni_bit_lowest64(x) != lowest;
		wrong += lowest >= 0 && lowest < 32 && cni_bit_lowest32((uint32_t)x) != lowest;
	}
	for (bit = 0; bit < 64; ++bit)
		wrong += cni_bit_lowest64((uint64_t)1 << bit) != bit;
	CHECK_LE("wrong results", wrong, 0, "");
	CHECK(cni_bit_count64(0) == 0 && cni_bit_count64(UINT64_MAX) == 64);
}

static void t_words(void)
{
	CHECK(cni_bit_words(0) == 0 && cni_bit_words(1) == 1 && cni_bit_words(64) == 1 && cni_bit_words(65) == 2);
}

static void t_single_bits(void)
{
	uint64_t words[6];
	uint8_t plain[384];
	uint32_t state = 8;
	int32_t round, i, bit, wrong = 0;

	for (round = 0; round < 2000; ++round) {
		memset(words, 0, sizeof words);
		memset(plain, 0, sizeof plain);
		for (i = (int32_t)(random_next(&state) % 40); i > 0; --i) {
			bit = (int32_t)(random_next(&state) % 384);
			cni_bit_set(words, bit);
			plain[bit] = 1;
			if (random_next(&state) % 4 == 0) {
				cni_bit_clear(words, bit);
				plain[bit] = 0;
			}
		}
		for (i = 0; i < 384; ++i)
			wrong += cni_bit_get(words, i) != plain[i];
	}
	CHECK_LE("wrong bits", wrong, 0, "bits");
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(t_count_and_lowest);
	RUN(t_words);
	RUN(t_single_bits);
	return test_end();
}
