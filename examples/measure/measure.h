/*
 * examples/measure/measure.h - what is printed beside every time: how exact the step was, how much
 * memory it took, and a clock.
 */
#ifndef CAIRN_MEASURE_H
#define CAIRN_MEASURE_H

#include "cairn.h"

/* Seconds from some fixed moment. */
double measure_clock_s(void);
/* Keeps this thread on the core it is on, where the system offers that. */
void measure_stay_on_core(void);
/* Processor time of this process, and what two readings with nothing between them differ by, at least. */
double measure_cpu_s(void);
double measure_cpu_clock_cost_s(void);
/* cn_world_step, under a name of its own: callgrind counts in it (--toggle-collect=measure_step) and so leaves out
   steps that are taken without it. */
cn_result measure_step(cn_world *world, float dt_s);

/* Largest values seen by measure_errors since the start. */
typedef struct measure_worst {
	float penetration_m;  /* depth of a contact point */
	float joint_m;        /* distance of anchors */
	float joint_rad;      /* angle beyond a limit */
	int32_t failed;       /* no memory for a list: the values are too small */
	int32_t points;       /* contact points seen, those between two dynamic bodies twice */
} measure_worst;
/* O(bodies + contacts + joints). */
void measure_errors(measure_worst *worst, const cn_world *world);

/* Deepest overlap at present of bodies that are slower than a speed; *out_count is the number of contact points between such bodies.
   0 of no points when there is no memory. O(bodies + contacts). */
float measure_rest_overlap(const cn_world *world, float speed_mps, int32_t *out_count);

typedef struct measure_start {
	cn_body *bodies;  /* those that were there at measure_start_open; not owned by the world */
	cn_pose *poses;
	int32_t count;
} measure_start;
/* Remembers where every body is. 0 when there is no memory. */
int32_t measure_start_open(measure_start *start, const cn_world *world);
/* Largest distance of a dynamic body that is still alive from where it was. */
float measure_displacement(const measure_start *start, const cn_world *world);
void measure_start_close(measure_start *start);

/* Dynamic bodies outside of the box; -1 when there is no memory. */
int32_t measure_bodies_left(const cn_world *world, const cn_aabb *box_m);

/* Dynamic bodies that sleep; -1 when there is no memory. */
int32_t measure_bodies_asleep(const cn_world *world);

/* Times of many steps. */
typedef struct measure_times {
	double *ms;
	int32_t count;
	int32_t capacity;
} measure_times;
int32_t measure_times_open(measure_times *times, int32_t capacity);
void measure_times_add(measure_times *times, double seconds);
/* Sorts; after that measure_times_at works. */
void measure_times_sort(measure_times *times);
/* The time below which this share of the steps lies: 0 is the minimum, 0.5 the median. */
double measure_times_at(const measure_times *times, double share);
void measure_times_close(measure_times *times);

#endif
