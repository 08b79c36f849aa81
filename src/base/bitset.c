/*
 * base/bitset.c - counting and scanning bits, pure functions. Plain integer arithmetic.
 */
#include "base/bitset.h"

/* Sums neighbouring fields of 1, 2 and 4 bits, then all bytes at once by a multiplication (Knuth, The
   Art of Computer Programming 4A, 2011, section 7.1.3). */
int32_t cni_bit_count64(uint64_t x)
{
	x -= (x >> 1) & UINT64_C(0x5555555555555555);
	x = (x & UINT64_C(0x3333333333333333)) + ((x >> 2) & UINT64_C(0x3333333333333333));
	x = (x + (x >> 4)) & UINT64_C(0x0F0F0F0F0F0F0F0F);
	return (int32_t)((x * UINT64_C(0x0101010101010101)) >> 56);
}

int32_t cni_bit_next(const uint64_t *words, int32_t bits, int32_t from)
{
	int32_t word_count = cni_bit_words(bits);
	int32_t word = from >> 6;
	uint64_t rest;
	int32_t bit;

	CNI_ASSERT(from >= 0);
	if (from >= bits)
		return CNI_NONE;
	rest = words[word] & (~UINT64_C(0) << (from & 63));
	while (rest == 0) {
		if (++word == word_count)
			return CNI_NONE;
		rest = words[word];
	}
	bit = (word << 6) + cni_bit_lowest64(rest);
	/* Bits of the last word beyond the end belong to nobody. */
	return bit < bits ? bit : CNI_NONE;
}
