/*
 * stages/contact_kernel_few.c - the contact kernel on vectors of four floats with the instructions of AVX2: for the lanes that
 * cni_contact_kernel_8 leaves, because they would not fill half of one of its vectors.
 */
#include "base/cpu.h"

#if CNI_HAS_WIDE_8
#include "base/bitset.h"
#include "stages/contact_pass.h"
#include <immintrin.h>
#include "base/avx2_begin.h"
#define CNI_WIDTH 4
#define CNI_FEW 1
#define CNI_KERNEL cni_contact_kernel_few
#include "stages/contact_kernel.h"
#include "base/avx2_end.h"
#else
typedef int cni_no_kernel_few;
#endif
