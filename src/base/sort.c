/*
 * base/sort.c - stable sorting of keys; touches only the caller's arrays.
 *
 * Insertion sort runs first, until it has shifted more than a few items for each item sorted: it sorts short or nearly
 * sorted input (the common case from one step to the next) in one pass. An interrupted insertion sort is a stable
 * rearrangement, so the radix sort can continue from it.
 *
 * Radix: least significant digit first, one byte at a time (Knuth, The Art of Computer Programming 3,
 * 1973, section 5.2.5). Bytes in which no two keys differ are skipped, so that ids and indices cost
 * only the bytes they use.
 */
#include "base/sort.h"
#include "base/maths.h"

#define SHORT_COUNT 32
#define SHIFTS_PER_ITEM 4

/* 1 when sorted, 0 when the budget of shifts was exceeded. */
static int32_t keys_insert(uint64_t *keys, int32_t count, int64_t budget)
{
	int32_t i, j;
	for (i = 1; i < count && budget >= 0; ++i) {
		uint64_t key = keys[i];
		for (j = i; j > 0 && keys[j - 1] > key; --j)
			keys[j] = keys[j - 1];
		keys[j] = key;
		budget -= i - j;
	}
	return i >= count;
}

static int64_t shift_budget(int32_t count, int32_t has_scratch)
{
	return !has_scratch || count <= SHORT_COUNT ? INT64_MAX : (int64_t)count * SHIFTS_PER_ITEM;
}

/* Bits in which any key differs from the first. */
static uint64_t keys_differing(const uint64_t *keys, int32_t count)
{
	uint64_t differing = 0;
	for (int32_t i = 1; i < count; ++i)
		differing |= keys[i] ^ keys[0];
	return differing;
}

static int32_t key_digit(uint64_t key, int32_t shift)
{
	return (int32_t)(key >> shift & 255u);
}

/* first[d] = destination of the first key with digit d. */
static void digits_locate(const uint64_t *keys, int32_t count, int32_t shift, int32_t first[256])
{
	int32_t sum = 0;
	memset(first, 0, 256 * sizeof *first);
	for (int32_t i = 0; i < count; ++i)
		++first[key_digit(keys[i], shift)];
	for (int32_t i = 0; i < 256; ++i) {
		int32_t digit_count = first[i];
		first[i] = sum;
		sum += digit_count;
	}
}

void cni_sort_keys(uint64_t *keys, uint64_t *scratch, int32_t count)
{
	uint64_t *from = keys, *to = scratch;
	int32_t first[256];
	if (keys_insert(keys, count, shift_budget(count, scratch != NULL)))
		return;
	uint64_t differing = keys_differing(keys, count);
	for (int32_t shift = 0; shift < 64; shift += 8) {
		uint64_t *swap = to;
		if (key_digit(differing, shift) == 0)
			continue;
		digits_locate(from, count, shift, first);
		for (int32_t i = 0; i < count; ++i)
			to[first[key_digit(from[i], shift)]++] = from[i];
		to = from;
		from = swap;
	}
	if (from != keys)
		memcpy(keys, from, (size_t)count * sizeof *keys);
}

/* The IEEE bits of positive floats increase with the float; those of negative floats decrease, so they are inverted. */
uint32_t cni_sort_float_key(float x)
{
	uint32_t bits = cni_bits_of(x == 0.0f ? 0.0f : x);
	return bits >> 31 ? ~bits : bits | UINT32_C(0x80000000);
}
