/*
 * examples/peers/narrow.c - linked before the library where everything is to run on SSE2: the library asks
 * this function whether the processor has AVX2, and a program that defines it first keeps the library's own
 * out. The kernel of four lanes is taken then, on every processor.
 */
#include <stdint.h>

int32_t cni_cpu_has_avx2(void);
int32_t cni_cpu_has_avx2(void) { return 0; }
