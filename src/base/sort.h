/*
 * base/sort.h - stable sorting of 64-bit keys: by insertion where few items must move, else by radix. No allocation: the caller
 * passes scratch of the same length; without it (NULL) the insertion sort runs to its end.
 */
#ifndef CNI_BASE_SORT_H
#define CNI_BASE_SORT_H

#include "base/config.h"

void cni_sort_keys(uint64_t *keys, uint64_t *scratch, int32_t count);
/* Order-preserving map of a finite float to 32 bits: a < b exactly when key(a) < key(b); -0 and 0 are equal. */
uint32_t cni_sort_float_key(float x);

#endif
