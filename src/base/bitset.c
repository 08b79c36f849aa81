/*
 * base/bitset.c - counts bits by plain integer arithmetic.
 */
#include "base/bitset.h"

/* Sums neighbouring fields of 1, 2 and 4 bits, then all bytes at once by a multiplication (Knuth, The Art of Computer
   Programming 4A, 2011, section 7.1.3). */
int32_t cni_bit_count64(uint64_t x)
{
	x -= (x >> 1) & UINT64_C(0x5555555555555555);
	x = (x & UINT64_C(0x3333333333333333)) + ((x >> 2) & UINT64_C(0x3333333333333333));
	x = (x + (x >> 4)) & UINT64_C(0x0F0F0F0F0F0F0F0F);
	return (int32_t)((x * UINT64_C(0x0101010101010101)) >> 56);
}
