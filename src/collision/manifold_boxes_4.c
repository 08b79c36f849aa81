/*
 * collision/manifold_boxes_4.c - pairs of boxes on vectors of four floats: SSE2, NEON, WASM SIMD.
 */
#include "base/cpu.h"

#if CNI_HAS_WIDE_4
#define CNI_WIDTH 4
#define CNI_KERNEL cni_box_kernel_4
#include "collision/manifold_boxes_kernel.h"
#else
typedef int cni_no_box_kernel_4;
#endif
