/*
 * broadphase/sweep_lanes_8.c - the inner loop of finding pairs on vectors of eight floats: AVX2, used only where the
 * processor has it.
 */
#include "base/cpu.h"

#if CNI_HAS_WIDE_8
/* Headers with functions of their own come first, so that only this file's code needs AVX2. */
#include "broadphase/sweep.h"
#include <immintrin.h>
#include "base/avx2_begin.h"
#define CNI_WIDTH 8
#define CNI_KERNEL cni_sweep_find_new_8
#include "broadphase/sweep_lanes.h"
#include "base/avx2_end.h"
#else
typedef int cni_no_sweep_lanes_8;
#endif
