/*
 * joints/joint_kernel_8.c - the kernel of joints on vectors of eight floats: AVX2, used only where the processor has it.
 */
#include "base/cpu.h"

#if CNI_HAS_WIDE_8
#include "joints/joint_pass.h"
#include <immintrin.h>
#include "base/avx2_begin.h"
#define CNI_WIDTH 8
#define CNI_KERNEL cni_joint_kernel_8
#include "joints/joint_passes_kernel.h"
#include "base/avx2_end.h"
#endif
