/*
 * base/avx2_begin.h - from here to base/avx2_end.h functions may use AVX2, whatever the file is compiled for. Included by
 * the kernels of width 8, after every header that defines functions of its own: only theirs is called where the
 * processor has it (base/cpu.h). No include guard: what it opens, the other closes. Fused multiply-add stays
 * off: it would change the bits.
 */
#if defined(__clang__)
#pragma clang attribute push(__attribute__((target("avx2"))), apply_to = function)
#else
#pragma GCC push_options
#pragma GCC target("avx2")
#endif
