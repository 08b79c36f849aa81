/*
 * joints/joint_kernel_4.c - the kernel of joints on vectors of four floats: SSE2, NEON, WASM SIMD.
 */
#include "base/cpu.h"

#if CNI_HAS_WIDE_4
#define CNI_WIDTH 4
#define CNI_KERNEL cni_joint_kernel_4
#include "joints/joint_passes_kernel.h"
#endif
