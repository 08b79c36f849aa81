/*
 * base/clock.c - the monotonic clock for each platform.
 */
#if !defined(_WIN32) && !defined(CN_NO_CLOCK)
#define _POSIX_C_SOURCE 199309L
#endif
#include "base/clock.h"

#if defined(CN_NO_CLOCK)
uint64_t cni_clock_ns(void)
{
	return 0;
}
#elif defined(_WIN32)
#define WIN32_LEAN_AND_MEAN
#include <windows.h>
uint64_t cni_clock_ns(void)
{
	LARGE_INTEGER count, rate;
	QueryPerformanceCounter(&count);
	QueryPerformanceFrequency(&rate);
	return (uint64_t)(count.QuadPart / rate.QuadPart) * 1000000000u +
	       (uint64_t)(count.QuadPart % rate.QuadPart) * 1000000000u / (uint64_t)rate.QuadPart;
}
#else
#include <time.h>
uint64_t cni_clock_ns(void)
{
	struct timespec now;
	(void)clock_gettime(CLOCK_MONOTONIC, &now);
	return (uint64_t)now.tv_sec * 1000000000u + (uint64_t)now.tv_nsec;
}
#endif
