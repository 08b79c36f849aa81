/*
 * base/wide.h - arithmetic on several floats at once, for kernels that are written once and compiled for
 * each width: the file that includes this defines CNI_WIDTH as 1, 4 or 8 first.
 *
 *   cni_wide   CNI_WIDTH floats; + - * / work lane by lane
 *   cni_mask   the result of comparing two of them, for cni_wide_select
 *
 * Every operation rounds like its scalar form, so results do not depend on the width. Width 1 is plain C;
 * the others use the vector extensions of gcc and clang.
 */
#ifndef CNI_BASE_WIDE_H
#define CNI_BASE_WIDE_H

#include "base/maths.h"

#if !defined(CNI_WIDTH)
#error "define CNI_WIDTH before including base/wide.h"
#endif

#if CNI_WIDTH == 1

typedef float cni_wide;
typedef int32_t cni_mask;
CNI_INLINE cni_wide cni_wide_load(const float *p) { return *p; }
CNI_INLINE cni_wide cni_wide_load_loose(const float *p) { return *p; }
CNI_INLINE void cni_wide_store(float *p, cni_wide a) { *p = a; }
CNI_INLINE cni_wide cni_wide_of(float x) { return x; }
CNI_INLINE cni_wide cni_wide_select(cni_mask mask, cni_wide a, cni_wide b) { return mask ? a : b; }
CNI_INLINE cni_wide cni_wide_max(cni_wide a, cni_wide b) { return a > b ? a : b; }
CNI_INLINE cni_wide cni_wide_min(cni_wide a, cni_wide b) { return a < b ? a : b; }
CNI_INLINE cni_wide cni_wide_sqrt(cni_wide a) { return cni_sqrt(a); }
CNI_INLINE uint32_t cni_mask_bits(cni_mask mask) { return mask ? 1u : 0u; }
CNI_INLINE cni_mask cni_mask_of_bits(uint32_t bits) { return (cni_mask)(bits & 1u); }
CNI_INLINE cni_mask cni_mask_of_zero(const int32_t *p) { return *p == 0; }

#else

#if defined(__SSE2__)
#include <immintrin.h>
#endif

typedef float cni_wide __attribute__((vector_size(CNI_WIDTH * 4)));
typedef float cni_wide_loose __attribute__((vector_size(CNI_WIDTH * 4), aligned(4), may_alias)); /* rows end in flags or counts */
typedef int32_t cni_mask __attribute__((vector_size(CNI_WIDTH * 4)));
typedef float cni_wide4 __attribute__((vector_size(16)));
typedef float cni_wide4_loose __attribute__((vector_size(16), aligned(4), may_alias));

CNI_INLINE cni_wide cni_wide_load(const float *p) { return *(const cni_wide *)(const void *)p; }
/* Unaligned load. */
CNI_INLINE cni_wide cni_wide_load_loose(const float *p) { return *(const cni_wide_loose *)(const void *)p; }
CNI_INLINE void cni_wide_store(float *p, cni_wide a) { *(cni_wide *)(void *)p = a; }
CNI_INLINE cni_wide cni_wide_of(float x) { return x - (cni_wide){ 0 }; }
CNI_INLINE cni_wide cni_wide_select(cni_mask mask, cni_wide a, cni_wide b)
{
	return (cni_wide)((mask & (cni_mask)a) | (~mask & (cni_mask)b));
}
/* Returns the second operand where the first is not greater (less), as the x86 instruction does. */
CNI_INLINE cni_wide cni_wide_max(cni_wide a, cni_wide b)
{
#if CNI_WIDTH == 4 && defined(__SSE2__)
	return (cni_wide)_mm_max_ps((__m128)a, (__m128)b);
#elif CNI_WIDTH == 8 && defined(__AVX__)
	return (cni_wide)_mm256_max_ps((__m256)a, (__m256)b);
#else
	return cni_wide_select(a > b, a, b);
#endif
}
CNI_INLINE cni_wide cni_wide_min(cni_wide a, cni_wide b)
{
#if CNI_WIDTH == 4 && defined(__SSE2__)
	return (cni_wide)_mm_min_ps((__m128)a, (__m128)b);
#elif CNI_WIDTH == 8 && defined(__AVX__)
	return (cni_wide)_mm256_min_ps((__m256)a, (__m256)b);
#else
	return cni_wide_select(a < b, a, b);
#endif
}
CNI_INLINE cni_wide cni_wide_sqrt(cni_wide a)
{
#if CNI_WIDTH == 4 && defined(__SSE2__)
	return (cni_wide)_mm_sqrt_ps((__m128)a);
#elif CNI_WIDTH == 8 && defined(__AVX__)
	return (cni_wide)_mm256_sqrt_ps((__m256)a);
#else
	for (int32_t l = 0; l < CNI_WIDTH; ++l)
		a[l] = cni_sqrt(a[l]);
	return a;
#endif
}
/* Bit l: lane l compared true. */
CNI_INLINE uint32_t cni_mask_bits(cni_mask mask)
{
#if CNI_WIDTH == 4 && defined(__SSE2__)
	return (uint32_t)_mm_movemask_ps((__m128)mask);
#elif CNI_WIDTH == 8 && defined(__AVX__)
	return (uint32_t)_mm256_movemask_ps((__m256)mask);
#else
	uint32_t bits = 0;
	for (int32_t l = 0; l < CNI_WIDTH; ++l)
		bits |= ((uint32_t)mask[l] & 1u) << l;
	return bits;
#endif
}
/* Lane l is true where bit l is set. */
CNI_INLINE cni_mask cni_mask_of_bits(uint32_t bits)
{
#if CNI_WIDTH == 4
	const cni_mask lane = { 1, 2, 4, 8 };
#elif CNI_WIDTH == 8
	const cni_mask lane = { 1, 2, 4, 8, 16, 32, 64, 128 };
#endif
	return (((int32_t)bits - (cni_mask){ 0 }) & lane) == lane;
}
/* Lane l is true where the l-th number is 0. */
CNI_INLINE cni_mask cni_mask_of_zero(const int32_t *p) { return *(const cni_mask *)(const void *)p == (cni_mask){ 0 }; }

#endif

CNI_INLINE void cni_wide_store_where(float *p, cni_mask where, cni_wide a) { cni_wide_store(p, cni_wide_select(where, a, cni_wide_load(p))); }

/* Clears the sign bit. */
CNI_INLINE cni_wide cni_wide_abs(cni_wide a) { return cni_wide_max(a, -a); }

/* Same bits as cni_sincos, for |angle| <= CNI_NEAR_RAD. */
CNI_INLINE void cni_wide_sincos_near(cni_wide angle, cni_wide *c, cni_wide *s)
{
	cni_mask tiny = cni_wide_abs(angle) <= cni_wide_of(CNI_TINY_RAD);
	cni_wide one = cni_wide_of(1.0f), r = cni_wide_select(tiny, cni_wide_of(CNI_TINY_RAD), angle), u = r * r;
	cni_wide sine = r + r * u * (cni_wide_of(CNI_SINE_3) + u * (cni_wide_of(CNI_SINE_5) + u * cni_wide_of(CNI_SINE_7)));
	cni_wide cosine = one + (u * u * (cni_wide_of(CNI_COSINE_4) + u * (cni_wide_of(CNI_COSINE_6) + u * cni_wide_of(CNI_COSINE_8))) - cni_wide_of(0.5f) * u);
	*s = cni_wide_select(tiny, angle, sine);
	*c = cni_wide_select(tiny, one, cosine);
}

/* ---- one float of each record: lane l is records[l][offset] ---- */

CNI_INLINE cni_wide cni_wide_gather_from(const float *const *records, size_t offset)
{
#if CNI_WIDTH == 1
	return records[0][offset];
#elif CNI_WIDTH == 4
	return (cni_wide){ records[0][offset], records[1][offset], records[2][offset], records[3][offset] };
#elif CNI_WIDTH == 8
	return (cni_wide){ records[0][offset], records[1][offset], records[2][offset], records[3][offset],
	                   records[4][offset], records[5][offset], records[6][offset], records[7][offset] };
#endif
}

/* ---- records of four floats: lane l of the outputs is record index[l], floats 0..3 ---- */

#if CNI_WIDTH == 1

CNI_INLINE void cni_wide_gather4_from(const float *const *records, int32_t offset, cni_wide *a, cni_wide *b, cni_wide *c, cni_wide *d)
{
	const float *r = records[0] + offset;
	*a = r[0];
	*b = r[1];
	*c = r[2];
	*d = r[3];
}
CNI_INLINE void cni_wide_gather4(const float *base, int32_t stride, const int32_t *index, cni_wide *a, cni_wide *b, cni_wide *c, cni_wide *d)
{
	cni_wide_gather4_from(&base, index[0] * stride, a, b, c, d);
}
CNI_INLINE void cni_wide_scatter4_to(float *const *records, int32_t offset, cni_wide a, cni_wide b, cni_wide c, cni_wide d)
{
	float *r = records[0] + offset;
	r[0] = a;
	r[1] = b;
	r[2] = c;
	r[3] = d;
}
CNI_INLINE void cni_wide_scatter4(float *base, int32_t stride, const int32_t *index, cni_wide a, cni_wide b, cni_wide c, cni_wide d)
{
	cni_wide_scatter4_to(&base, index[0] * stride, a, b, c, d);
}
CNI_INLINE void cni_wide_scatter4_where(float *base, int32_t stride, const int32_t *index, uint32_t lanes, cni_wide a, cni_wide b, cni_wide c, cni_wide d)
{
	if (lanes & 1u)
		cni_wide_scatter4(base, stride, index, a, b, c, d);
}

#else

/* Rows become columns: a 4 x 4 transpose in place. */
CNI_INLINE void cni_wide_transpose(cni_wide4 *a, cni_wide4 *b, cni_wide4 *c, cni_wide4 *d)
{
	cni_wide4 ab_low = __builtin_shufflevector(*a, *b, 0, 4, 1, 5), ab_high = __builtin_shufflevector(*a, *b, 2, 6, 3, 7);
	cni_wide4 cd_low = __builtin_shufflevector(*c, *d, 0, 4, 1, 5), cd_high = __builtin_shufflevector(*c, *d, 2, 6, 3, 7);
	*a = __builtin_shufflevector(ab_low, cd_low, 0, 1, 4, 5);
	*b = __builtin_shufflevector(ab_low, cd_low, 2, 3, 6, 7);
	*c = __builtin_shufflevector(ab_high, cd_high, 0, 1, 4, 5);
	*d = __builtin_shufflevector(ab_high, cd_high, 2, 3, 6, 7);
}

#if CNI_WIDTH == 8

/* Joins two rows of four: those of lanes l and l + 4. The instruction can take the second one from memory; gcc does not
   choose it by itself. */
CNI_INLINE cni_wide cni_wide_pair(cni_wide4 low, cni_wide4 high)
{
#if defined(__AVX__)
	return (cni_wide)_mm256_insertf128_ps(_mm256_castps128_ps256((__m128)low), (__m128)high, 1);
#else
	return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
#endif
}

/* Lanes 4 to 7. The instruction can write them to memory. */
CNI_INLINE cni_wide4 cni_wide_high(cni_wide a)
{
#if defined(__AVX__)
	return (cni_wide4)_mm256_extractf128_ps((__m256)a, 1);
#else
	return __builtin_shufflevector(a, a, 4, 5, 6, 7);
#endif
}

/* The same 4 x 4 transpose in both halves. */
CNI_INLINE void cni_wide_transpose8(cni_wide *a, cni_wide *b, cni_wide *c, cni_wide *d)
{
	cni_wide ab_low = __builtin_shufflevector(*a, *b, 0, 8, 1, 9, 4, 12, 5, 13), ab_high = __builtin_shufflevector(*a, *b, 2, 10, 3, 11, 6, 14, 7, 15);
	cni_wide cd_low = __builtin_shufflevector(*c, *d, 0, 8, 1, 9, 4, 12, 5, 13), cd_high = __builtin_shufflevector(*c, *d, 2, 10, 3, 11, 6, 14, 7, 15);
	*a = __builtin_shufflevector(ab_low, cd_low, 0, 1, 8, 9, 4, 5, 12, 13);
	*b = __builtin_shufflevector(ab_low, cd_low, 2, 3, 10, 11, 6, 7, 14, 15);
	*c = __builtin_shufflevector(ab_high, cd_high, 0, 1, 8, 9, 4, 5, 12, 13);
	*d = __builtin_shufflevector(ab_high, cd_high, 2, 3, 10, 11, 6, 7, 14, 15);
}

#endif

/* CNI_WIDTH rows of four become four columns. */
CNI_INLINE void cni_wide_columns(cni_wide4 r[CNI_WIDTH], cni_wide *a, cni_wide *b, cni_wide *c, cni_wide *d)
{
#if CNI_WIDTH == 4
	*a = r[0];
	*b = r[1];
	*c = r[2];
	*d = r[3];
	cni_wide_transpose(a, b, c, d);
#elif CNI_WIDTH == 8
	*a = cni_wide_pair(r[0], r[4]);
	*b = cni_wide_pair(r[1], r[5]);
	*c = cni_wide_pair(r[2], r[6]);
	*d = cni_wide_pair(r[3], r[7]);
	cni_wide_transpose8(a, b, c, d);
#endif
}

CNI_INLINE void cni_wide_gather4(const float *base, int32_t stride, const int32_t *index, cni_wide *a, cni_wide *b, cni_wide *c, cni_wide *d)
{
	cni_wide4 r[CNI_WIDTH];
	for (int32_t l = 0; l < CNI_WIDTH; ++l)
		r[l] = *(const cni_wide4 *)(const void *)(base + (size_t)index[l] * (size_t)stride);
	cni_wide_columns(r, a, b, c, d);
}

/* The same from records at any address: floats offset .. offset + 3 of each. */
CNI_INLINE void cni_wide_gather4_from(const float *const *records, int32_t offset, cni_wide *a, cni_wide *b, cni_wide *c, cni_wide *d)
{
	cni_wide4 r[CNI_WIDTH];
	for (int32_t l = 0; l < CNI_WIDTH; ++l)
		r[l] = *(const cni_wide4_loose *)(const void *)(records[l] + offset);
	cni_wide_columns(r, a, b, c, d);
}

/* Four columns become CNI_WIDTH rows of four. */
CNI_INLINE void cni_wide_rows(cni_wide4 r[CNI_WIDTH], cni_wide a, cni_wide b, cni_wide c, cni_wide d)
{
#if CNI_WIDTH == 4
	cni_wide_transpose(&a, &b, &c, &d);
	r[0] = a;
	r[1] = b;
	r[2] = c;
	r[3] = d;
#elif CNI_WIDTH == 8
	cni_wide_transpose8(&a, &b, &c, &d);
	r[0] = __builtin_shufflevector(a, a, 0, 1, 2, 3);
	r[1] = __builtin_shufflevector(b, b, 0, 1, 2, 3);
	r[2] = __builtin_shufflevector(c, c, 0, 1, 2, 3);
	r[3] = __builtin_shufflevector(d, d, 0, 1, 2, 3);
	r[4] = cni_wide_high(a);
	r[5] = cni_wide_high(b);
	r[6] = cni_wide_high(c);
	r[7] = cni_wide_high(d);
#endif
}

/* Only for the lanes whose bits are set; the other records are not written. */
CNI_INLINE void cni_wide_scatter4_where(float *base, int32_t stride, const int32_t *index, uint32_t lanes, cni_wide a, cni_wide b, cni_wide c, cni_wide d)
{
	cni_wide4 r[CNI_WIDTH];
	cni_wide_rows(r, a, b, c, d);
	for (int32_t l = 0; l < CNI_WIDTH; ++l)
		if (lanes >> l & 1u)
			*(cni_wide4 *)(void *)(base + (size_t)index[l] * (size_t)stride) = r[l];
}

CNI_INLINE void cni_wide_scatter4(float *base, int32_t stride, const int32_t *index, cni_wide a, cni_wide b, cni_wide c, cni_wide d)
{
	cni_wide_scatter4_where(base, stride, index, (1u << CNI_WIDTH) - 1u, a, b, c, d);
}

/* The same to records at any address: floats offset .. offset + 3 of each. */
CNI_INLINE void cni_wide_scatter4_to(float *const *records, int32_t offset, cni_wide a, cni_wide b, cni_wide c, cni_wide d)
{
	cni_wide4 r[CNI_WIDTH];
	cni_wide_rows(r, a, b, c, d);
	for (int32_t l = 0; l < CNI_WIDTH; ++l)
		*(cni_wide4_loose *)(void *)(records[l] + offset) = r[l];
}

/* Writes floats 0 and 1 of a to the first record, floats 2 and 3 to the second. */
CNI_INLINE void cni_wide_pair_to(float *first, float *second, cni_wide4 a)
{
#if defined(__SSE2__)
	_mm_storel_pi((__m64 *)(void *)first, (__m128)a);
	_mm_storeh_pi((__m64 *)(void *)second, (__m128)a);
#else
	first[0] = a[0];
	first[1] = a[1];
	second[0] = a[2];
	second[1] = a[3];
#endif
}

/* Writes floats offset and offset + 1 of each record. */
CNI_INLINE void cni_wide_scatter2_to(float *const *records, int32_t offset, cni_wide a, cni_wide b)
{
#if CNI_WIDTH == 4
	cni_wide_pair_to(records[0] + offset, records[1] + offset, __builtin_shufflevector(a, b, 0, 4, 1, 5));
	cni_wide_pair_to(records[2] + offset, records[3] + offset, __builtin_shufflevector(a, b, 2, 6, 3, 7));
#elif CNI_WIDTH == 8
	cni_wide low = __builtin_shufflevector(a, b, 0, 8, 1, 9, 4, 12, 5, 13), high = __builtin_shufflevector(a, b, 2, 10, 3, 11, 6, 14, 7, 15);
	cni_wide_pair_to(records[0] + offset, records[1] + offset, __builtin_shufflevector(low, low, 0, 1, 2, 3));
	cni_wide_pair_to(records[2] + offset, records[3] + offset, __builtin_shufflevector(high, high, 0, 1, 2, 3));
	cni_wide_pair_to(records[4] + offset, records[5] + offset, cni_wide_high(low));
	cni_wide_pair_to(records[6] + offset, records[7] + offset, cni_wide_high(high));
#endif
}

#endif

#endif
