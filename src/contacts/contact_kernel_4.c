/*
 * contacts/contact_kernel_4.c - the contact kernel with vectors of 4 floats: SSE2, NEON, WASM SIMD.
 */
#include "base/cpu.h"

#if CNI_HAS_WIDE_4
#define CNI_WIDTH 4
#define CNI_KERNEL cni_contact_kernel_4
#include "contacts/contact_kernel.h"
#endif
