/*
 * examples/measure/clock.c - the parts of measuring that differ between systems.
 */
#ifdef __linux__
#define _GNU_SOURCE
#include <sched.h>
#elif !defined(_WIN32)
#define _POSIX_C_SOURCE 200112L
#endif
#include "measure/measure.h"
#include <time.h>

#ifdef CLOCK_MONOTONIC
double measure_clock_s(void)
{
	struct timespec now;
	clock_gettime(CLOCK_MONOTONIC, &now);
	return (double)now.tv_sec + 1.0e-9 * (double)now.tv_nsec;
}
#else
double measure_clock_s(void) { return (double)clock() / (double)CLOCKS_PER_SEC; }
#endif

#ifdef CLOCK_PROCESS_CPUTIME_ID
double measure_cpu_s(void)
{
	struct timespec now;
	clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
	return (double)now.tv_sec + 1.0e-9 * (double)now.tv_nsec;
}
#else
double measure_cpu_s(void) { return (double)clock() / (double)CLOCKS_PER_SEC; }
#endif

double measure_cpu_clock_cost_s(void)
{
	double least = 1.0;
	for (int32_t i = 0; i < 1000; ++i) {
		double start = measure_cpu_s();
		double cost = measure_cpu_s() - start;
		least = cost < least ? cost : least;
	}
	return least;
}

#ifdef __linux__
void measure_stay_on_core(void)
{
	cpu_set_t cores;
	int core = sched_getcpu();
	if (core < 0)
		return;
	CPU_ZERO(&cores);
	CPU_SET((size_t)core, &cores);
	/* A refusal only makes times less steady. */
	(void)sched_setaffinity(0, sizeof cores, &cores);
}
#else
void measure_stay_on_core(void) {}
#endif
