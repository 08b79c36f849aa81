/*
 * base/cpu.h - which instruction sets kernels may use. Compile-time words, and one run-time question on x86.
 */
#ifndef CNI_BASE_CPU_H
#define CNI_BASE_CPU_H

#include "base/config.h"

/* Vectors of four floats are worth having. Old gcc has no __builtin_shufflevector. */
#if !defined(CN_NO_SIMD) && defined(__GNUC__) && (defined(__clang__) || __GNUC__ >= 12) && \
    (defined(__SSE2__) || defined(__ARM_NEON) || defined(__wasm_simd128__))
#define CNI_HAS_WIDE_4 1
#else
#define CNI_HAS_WIDE_4 0
#endif

/* Files of wider kernels may be compiled for them on this architecture. */
#if CNI_HAS_WIDE_4 && defined(__x86_64__)
#define CNI_HAS_WIDE_8 1
#else
#define CNI_HAS_WIDE_8 0
#endif

/* 1 when this processor and operating system run AVX2. */
int32_t cni_cpu_has_avx2(void);

#endif
