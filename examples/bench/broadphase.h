/*
 * examples/bench/broadphase.h - the benchmarks of the structures that find pairs and answer queries: both of
 * them in worlds of boxes without any physics.
 */
#ifndef CAIRN_BENCH_BROADPHASE_H
#define CAIRN_BENCH_BROADPHASE_H

#include <stdint.h>

/* CSV, a row for each world and structure: time of a step and memory. Returns how many rows failed. */
int32_t bench_broadphase(void);
/* CSV, a row for each world and structure: regions and rays a second. */
int32_t bench_queries(void);

#endif
