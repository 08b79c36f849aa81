/*
 * collision/manifold_batch_4.c - collides pairs with vectors of four floats: SSE2, NEON, WASM SIMD.
 */
#include "base/cpu.h"

#if CNI_HAS_WIDE_4
#define CNI_WIDTH 4
#define CNI_KERNEL cni_batch_kernel_4
#include "collision/manifold_batch_kernel.h"
#endif
