/*
 * direct/batched_trees_8.c - the kernel of batched trees on vectors of eight floats: AVX2, used only where the
 * processor has it. Fused multiply-add stays off: it would change the bits.
 */
#include "base/cpu.h"

#if CNI_HAS_WIDE_8
/* Headers with functions of their own come first, so that only this file's code needs AVX2. */
#include "direct/direct_system.h"
#include <immintrin.h>
#include "base/avx2_begin.h"
#define CNI_WIDTH 8
#define CNI_KERNEL cni_tree_batch_kernel_8
#include "direct/batched_trees_kernel.h"
#include "base/avx2_end.h"
#endif
