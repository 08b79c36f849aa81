/*
 * base/config.h - what every source file needs before anything else: strict float semantics,
 * invariant checks, and a few words for the compiler. Included first by all of src/.
 *
 * Same input, same bits: contraction into fused multiply-add is off, and targets that compute
 * float expressions in a wider type are refused.
 */
#ifndef CNI_BASE_CONFIG_H
#define CNI_BASE_CONFIG_H

#include <float.h>
#include <stddef.h>
#include <stdint.h>

#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
/* gcc 12 makes fused multiply-add/subtract of pairs of products when it vectorises by itself, contraction or not. */
#pragma GCC optimize("fp-contract=off", "no-tree-slp-vectorize", "no-tree-loop-vectorize")
#endif

#if !defined(FLT_EVAL_METHOD) || FLT_EVAL_METHOD != 0
#error "Cairn needs float expressions evaluated in float: use -msse2 -mfpmath=sse on i386, -fexcess-precision=fast on s390x"
#endif
#ifdef __FAST_MATH__
#error "Cairn must not be compiled with -ffast-math: results would depend on the compiler"
#endif

/* Guards our own invariants, never user input. On in debug and test builds only. */
#ifdef CNI_DEBUG
#include <stdio.h>
#include <stdlib.h>
#define CNI_ASSERT(condition) \
	((condition) ? (void)0 : (void)(fprintf(stderr, "%s:%d: invariant broken: %s\n", __FILE__, __LINE__, #condition), abort()))
#else
#define CNI_ASSERT(condition) ((void)0)
#endif

/* For kernels that are written once and specialised by constant arguments. */
#if defined(__GNUC__)
#define CNI_INLINE static inline __attribute__((always_inline))
#elif defined(_MSC_VER)
#define CNI_INLINE static __forceinline
#else
#define CNI_INLINE static inline
#endif

/* Before a member or variable: where vectors are loaded from. Without vectors it says nothing. */
#if defined(__GNUC__)
#define CNI_ALIGNED(bytes) __attribute__((aligned(bytes)))
#else
#define CNI_ALIGNED(bytes)
#endif

/* Memory that is read soon: a hint, which changes no result. */
#if defined(__GNUC__)
#define CNI_PREFETCH(address) __builtin_prefetch(address)
#else
#define CNI_PREFETCH(address) ((void)(address))
#endif

/* Index that names nothing. */
#define CNI_NONE (-1)

#endif
