/*
 * base/cpu.c - detects the processor's instruction sets at run time.
 */
#include "base/cpu.h"

int32_t cni_cpu_has_avx2(void)
{
#if CNI_HAS_WIDE_8
	__builtin_cpu_init();
	return __builtin_cpu_supports("avx2") != 0;
#else
	return 0;
#endif
}
