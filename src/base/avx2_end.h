/*
 * base/avx2_end.h - ends the effect of base/avx2_begin.h.
 */
#if defined(__clang__)
#pragma clang attribute pop
#else
#pragma GCC pop_options
#endif
