/*
 * contacts/contact_kernel_8.c - the contact kernel with vectors of 8 floats: AVX2, used only if the processor has it.
 */
#include "base/cpu.h"

#if CNI_HAS_WIDE_8
#include "base/bitset.h"
#include "contacts/contact_pass.h"
#include <immintrin.h>
#include "base/avx2_begin.h"
#define CNI_WIDTH 8
#define CNI_KERNEL cni_contact_kernel_8
#include "contacts/contact_kernel.h"
#include "base/avx2_end.h"
#endif
