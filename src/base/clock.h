/*
 * base/clock.h - a monotonic clock for the profile only: no result depends on it.
 */
#ifndef CNI_BASE_CLOCK_H
#define CNI_BASE_CLOCK_H

#include "base/config.h"

/* Nanoseconds since some fixed moment; 0 where there is no clock (CN_NO_CLOCK). */
uint64_t cni_clock_ns(void);

#endif
