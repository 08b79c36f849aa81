/*
 * base/cpu.h - the instruction sets that kernels may use: compile-time macros, and one run-time test on x86.
 */
#ifndef CNI_BASE_CPU_H
#define CNI_BASE_CPU_H

#include "base/config.h"

/* 1 when kernels use vectors of four floats. gcc before 12 has no __builtin_shufflevector. */
#if !defined(CN_NO_SIMD) && !defined(CN_SMALL_BLOCKS) && defined(__GNUC__) && (defined(__clang__) || __GNUC__ >= 12) && \
    (defined(__SSE2__) || defined(__ARM_NEON) || defined(__wasm_simd128__))
#define CNI_HAS_WIDE_4 1
#else
#define CNI_HAS_WIDE_4 0
#endif

/* 1 when kernels for vectors of eight floats can be compiled on this architecture. */
#if CNI_HAS_WIDE_4 && defined(__x86_64__)
#define CNI_HAS_WIDE_8 1
#else
#define CNI_HAS_WIDE_8 0
#endif

/* 1 when this processor and operating system run AVX2. */
int32_t cni_cpu_has_avx2(void);

/* The widest of the kernels name_plain, name_4 and name_8 that this build and this processor have. */
#if CNI_HAS_WIDE_8
#define CNI_WIDEST(name) (cni_cpu_has_avx2() ? &name##_8 : &name##_4)
#elif CNI_HAS_WIDE_4
#define CNI_WIDEST(name) (&name##_4)
#else
#define CNI_WIDEST(name) (&name##_plain)
#endif

#endif
