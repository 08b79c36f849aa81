/*
 * direct/batched_trees_4.c - the kernel of batched trees on vectors of four floats: SSE2, NEON, WASM SIMD.
 */
#include "base/cpu.h"

#if CNI_HAS_WIDE_4
#define CNI_WIDTH 4
#define CNI_KERNEL cni_tree_batch_kernel_4
#include "direct/batched_trees_kernel.h"
#endif
