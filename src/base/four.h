/*
 * base/four.h - vectors of four floats, for rows of small matrices: code that is written once for compilers with and without vectors,
 * with the same bits. base/wide.h is for loops over lanes of any width.
 */
#ifndef CNI_BASE_FOUR_H
#define CNI_BASE_FOUR_H

#include "base/cpu.h"

#include <string.h>

#if CNI_HAS_WIDE_4

typedef float cni_four __attribute__((vector_size(16)));
typedef float cni_four_loose __attribute__((vector_size(16), aligned(4), may_alias));

CNI_INLINE cni_four cni_four_of(float x, float y, float z, float w) { return (cni_four){ x, y, z, w }; }
CNI_INLINE cni_four cni_four_all(float x) { return (cni_four){ x, x, x, x }; }
CNI_INLINE cni_four cni_four_load(const float *p) { return *(const cni_four_loose *)(const void *)p; }
CNI_INLINE void cni_four_store(float *p, cni_four a) { *(cni_four_loose *)(void *)p = a; }
CNI_INLINE cni_four cni_four_add(cni_four a, cni_four b) { return a + b; }
CNI_INLINE cni_four cni_four_subtract(cni_four a, cni_four b) { return a - b; }
CNI_INLINE cni_four cni_four_times(cni_four a, cni_four b) { return a * b; }
CNI_INLINE cni_four cni_four_scale(cni_four a, float x) { return a * x; }
/* Lanes of a (0 to 3) and of b (4 to 7). */
#define CNI_FOUR_PICK(a, b, i, k, l, m) __builtin_shufflevector(a, b, i, k, l, m)

#else

typedef struct cni_four {
	float lane[4];
} cni_four;

#define CNI_FOUR_LANES(expression)                                  \
	cni_four out;                                                   \
	int32_t l;                                                      \
	for (l = 0; l < 4; ++l)                                         \
		out.lane[l] = (expression);                                 \
	return out

CNI_INLINE cni_four cni_four_of(float x, float y, float z, float w) { return (cni_four){ { x, y, z, w } }; }
CNI_INLINE cni_four cni_four_all(float x) { CNI_FOUR_LANES(x); }
CNI_INLINE cni_four cni_four_load(const float *p) { CNI_FOUR_LANES(p[l]); }
CNI_INLINE void cni_four_store(float *p, cni_four a) { memcpy(p, a.lane, sizeof a.lane); }
CNI_INLINE cni_four cni_four_add(cni_four a, cni_four b) { CNI_FOUR_LANES(a.lane[l] + b.lane[l]); }
CNI_INLINE cni_four cni_four_subtract(cni_four a, cni_four b) { CNI_FOUR_LANES(a.lane[l] - b.lane[l]); }
CNI_INLINE cni_four cni_four_times(cni_four a, cni_four b) { CNI_FOUR_LANES(a.lane[l] * b.lane[l]); }
CNI_INLINE cni_four cni_four_scale(cni_four a, float x) { CNI_FOUR_LANES(a.lane[l] * x); }
CNI_INLINE float cni_four_lane(cni_four a, cni_four b, int32_t i) { return i < 4 ? a.lane[i] : b.lane[i & 3]; }
#define CNI_FOUR_PICK(a, b, i, k, l, m) cni_four_of(cni_four_lane(a, b, i), cni_four_lane(a, b, k), cni_four_lane(a, b, l), cni_four_lane(a, b, m))

#endif

CNI_INLINE float cni_four_sum(cni_four a)
{
	float lane[4];
	cni_four_store(lane, a);
	return lane[0] + lane[1] + lane[2] + lane[3];
}

/* The first three columns of the matrix with rows a, b, c, as vectors whose last lane is that of the row c. */
CNI_INLINE void cni_four_columns(cni_four *a, cni_four *b, cni_four *c)
{
	cni_four low = CNI_FOUR_PICK(*a, *b, 0, 4, 1, 5), high = CNI_FOUR_PICK(*a, *b, 2, 6, 3, 7), last = *c;
	*a = CNI_FOUR_PICK(low, last, 0, 1, 4, 7);
	*b = CNI_FOUR_PICK(low, last, 2, 3, 5, 7);
	*c = CNI_FOUR_PICK(high, last, 0, 1, 6, 7);
}

#endif
