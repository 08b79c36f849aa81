/*
 * collision/manifold_batch_8.c - collides pairs with vectors of eight floats (AVX2), chosen at run time where the
 * processor supports it. Fused multiply-add stays off: it would change the bits.
 */
#include "base/cpu.h"

#if CNI_HAS_WIDE_8
/* Headers with inline functions come first, so that only this file's code is compiled for AVX2. */
#include "collision/manifold_batch.h"
#include "collision/manifold_faces.h"
#include <immintrin.h>
#include "base/avx2_begin.h"
#define CNI_WIDTH 8
#define CNI_KERNEL cni_batch_kernel_8
#include "collision/manifold_batch_kernel.h"
#include "base/avx2_end.h"
#endif
