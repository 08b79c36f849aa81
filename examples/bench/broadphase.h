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
/* One structure, "sweep" or "tree", with boxes of 0.5 m to 1.5 m, one in 4 m^2, every second of which moves: processor
   time of each of the steps after the warm ones, and new pairs a step. 0 when there is no memory. */
int32_t bench_broadphase_scale(const char *structure, int32_t boxes, int32_t warm_steps, int32_t steps, double *out_ms, double *out_pairs);

#endif
