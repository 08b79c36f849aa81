/*
 * base/avx2_begin.h - compiles the functions between here and base/avx2_end.h for AVX2, whatever the target of the file. The
 * kernels of width 8 include it after every header that defines functions: AVX2 code may run only where the processor
 * supports it (base/cpu.h). No include guard: each file includes the pair once. Fused multiply-add stays off: it would
 * change the bits.
 */
#if defined(__clang__)
#pragma clang attribute push(__attribute__((target("avx2"))), apply_to = function)
#else
#pragma GCC push_options
#pragma GCC target("avx2")
#endif
