/*
 * base/bitset.h - bits in caller-owned 64-bit words, and the scan with which stages visit set bits in index order (so that
 * results do not depend on the order in which they were set).
 */
#ifndef CNI_BASE_BITSET_H
#define CNI_BASE_BITSET_H

#include "base/config.h"

static inline int32_t cni_bit_words(int32_t bits) { return (bits + 63) >> 6; }
static inline void cni_bit_set(uint64_t *words, int32_t bit) { words[bit >> 6] |= (uint64_t)1 << (bit & 63); }
static inline void cni_bit_clear(uint64_t *words, int32_t bit) { words[bit >> 6] &= ~((uint64_t)1 << (bit & 63)); }
static inline int32_t cni_bit_get(const uint64_t *words, int32_t bit) { return (int32_t)(words[bit >> 6] >> (bit & 63)) & 1; }

/* Sums neighbouring fields of 1, 2 and 4 bits, then all bytes at once by a multiplication (Knuth, The Art of Computer
   Programming 4A, 2011, section 7.1.3). */
static inline int32_t cni_bit_count64(uint64_t x)
{
	x -= (x >> 1) & UINT64_C(0x5555555555555555);
	x = (x & UINT64_C(0x3333333333333333)) + ((x >> 2) & UINT64_C(0x3333333333333333));
	x = (x + (x >> 4)) & UINT64_C(0x0F0F0F0F0F0F0F0F);
	return (int32_t)((x * UINT64_C(0x0101010101010101)) >> 56);
}

/* Number of trailing zeros; x != 0. A builtin where the compiler has it, else the count of the bits below the lowest set bit,
   which are (x - 1) & ~x. */
static inline int32_t cni_bit_lowest64(uint64_t x)
{
	CNI_ASSERT(x != 0);
#if defined(__GNUC__) && !defined(CNI_PLAIN_BITS)
	return __builtin_ctzll(x);
#else
	return cni_bit_count64((x - 1) & ~x);
#endif
}

static inline int32_t cni_bit_lowest32(uint32_t x)
{
	CNI_ASSERT(x != 0);
#if defined(__GNUC__) && !defined(CNI_PLAIN_BITS)
	return __builtin_ctz(x);
#else
	return cni_bit_count64((x - 1u) & ~x);
#endif
}

#endif
