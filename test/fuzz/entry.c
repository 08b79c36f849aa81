/*
 * test/fuzz/entry.c - libFuzzer's entry to the target that FUZZ_TARGET names.
 */
#include "fuzz.h"

#ifndef FUZZ_TARGET
#error "FUZZ_TARGET must name a function of fuzz.h"
#endif

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t count);
int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t count)
{
	FUZZ_TARGET(bytes, count);
	return 0;
}
