/*
 * broadphase/sweep_lanes_8.c - the inner loop of the pair search for vectors of eight floats (AVX2), chosen at run time
 * where the processor supports it.
 */
#include "base/cpu.h"

#if CNI_HAS_WIDE_8
/* Headers with inline functions come first, so that only this file's code is compiled for AVX2. */
#include <immintrin.h>
#include "base/avx2_begin.h"
#define CNI_WIDTH 8
#define CNI_KERNEL cni_sweep_find_new_8
#include "broadphase/sweep_lanes.h"
#include "base/avx2_end.h"
#endif
