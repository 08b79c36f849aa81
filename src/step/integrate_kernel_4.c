/*
 * step/integrate_kernel_4.c - the body kernel with vectors of 4 floats: SSE2, NEON, WASM SIMD.
 */
#include "base/cpu.h"

#if CNI_HAS_WIDE_4
#define CNI_WIDTH 4
#define CNI_KERNEL cni_body_kernel_4
#include "step/integrate_kernel.h"
#endif
