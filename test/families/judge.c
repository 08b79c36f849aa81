/*
 * test/families/judge.c - when one run counts as worse than another.
 *
 * Heaps and loose joints are chaotic: two runs that start 1e-5 m apart end apart. What a single run finds worse is therefore
 * decided by medians over perturbed starts.
 *
 * A loaded chain whips: its light end is right to be several times as fast as a damped solver lets it be. What is faster than the
 * other solver is therefore also compared with that solver at 64 substeps.
 */
#include "judge.h"
#ifdef CNI_ABLATION
#include "../ablation/off.h" /* the first side without a mechanism, the other with all: make ablation */
#define SIDE_USE(side) cni_ablation_use((side) == 0)
#else
#define SIDE_USE(side) ((void)0)
#endif

#include <math.h>
#include <stdlib.h>

const measure_kind kinds[M_COUNT] = {
	{ "joint", "mm", 1.5, 0.001, 1e3 },
	{ "overlap", "mm", 1.5, 0.001, 1e3 },
	{ "energy", "%", 1.5, 1.0, 1.0 },
	{ "speed", "m/s", 1.5, 1.0, 1.0 },
	{ "moved", "mm", 1.5, 0.001, 1e3 },
	{ "broken", "", 1.0, 0.0, 1.0 },
};

judged to_judged(const scene_measures *m)
{
	judged j;
	j.value[M_JOINT] = m->joint_p99;
	j.value[M_OVERLAP] = m->overlap_p99;
	j.value[M_ENERGY] = (m->flags & SCENE_NO_ENERGY) != 0 ? 0.0 : m->energy_pct;
	j.value[M_SPEED] = m->speed_max;
	j.value[M_MOVED] = (m->flags & SCENE_STANDS) != 0 ? m->moved_m : 0.0;
	j.value[M_BROKEN] = (double)(m->broken > 0 || m->at_limit || m->refused);
	return j;
}

uint32_t worse_mask(const judged *mine, const judged *other)
{
	uint32_t mask = 0;
	int32_t k;
	for (k = 0; k < M_COUNT; ++k)
		if (!(mine->value[k] <= kinds[k].factor * other->value[k] + kinds[k].allowance))
			mask |= 1u << k;
	return mask;
}

double excess(const judged *mine, const judged *other, int32_t kind)
{
	double allowed = kinds[kind].factor * other->value[kind] + kinds[kind].allowance;
	return allowed > 0.0 ? mine->value[kind] / allowed : mine->value[kind];
}

static int ascending(const void *a, const void *b)
{
	double x = *(const double *)a, y = *(const double *)b;
	return x < y ? -1 : x > y;
}

double median(double *values, int32_t count)
{
	if (count == 0)
		return 0.0;
	qsort(values, (size_t)count, sizeof *values, ascending);
	return values[count / 2];
}

/* Fastest body of the other solver with REFERENCE_SUBSTEPS, which damps next to nothing. */
static double reference_speed(const settings *set, const family *which, int32_t seed, int32_t repeat)
{
	run_settings run;
	run.solver = set->solvers[1];
	run.substeps = REFERENCE_SUBSTEPS;
	run.noise = repeat;
	run.meddle = set->meddle;
	run.drift_mps = set->drift_mps;
	run.pace = set->pace;
	run.surface = set->surface;
	SIDE_USE(1);
	return run_scene(which, seed, &run).speed_max;
}

scene_measures run_side(const settings *set, const family *which, int32_t seed, int32_t side, int32_t repeat)
{
	run_settings run;
	run.solver = set->solvers[side];
	run.substeps = set->substeps;
	run.meddle = set->meddle;
	run.drift_mps = set->drift_mps;
	run.pace = set->pace;
	run.surface = set->surface;
	run.noise = repeat + (set->noise && side == 0 ? NOISE_OTHER : 0);
	SIDE_USE(side);
	return run_scene(which, seed, &run);
}

void keep_values(double values[M_COUNT][RUNS_MAX], int32_t at, const judged *j)
{
	int32_t k;
	for (k = 0; k < M_COUNT; ++k)
		values[k][at] = j->value[k];
}

judged median_judged(double values[M_COUNT][RUNS_MAX], int32_t count)
{
	judged j;
	int32_t k;
	for (k = 0; k < M_COUNT; ++k)
		j.value[k] = median(values[k], count);
	return j;
}

uint32_t confirm_seed(const settings *set, const family *which, int32_t seed, judged sides[2])
{
	double values[2][M_COUNT][RUNS_MAX];
	uint32_t worse = worse_mask(&sides[0], &sides[1]);
	int fast = (worse >> M_SPEED & 1u) != 0;
	int32_t side, repeat;
	if (fast && set->confirm > 0) {
		sides[1].value[M_SPEED] = fmax(sides[1].value[M_SPEED], reference_speed(set, which, seed, 0));
		worse = worse_mask(&sides[0], &sides[1]);
	}
	for (side = 0; side < 2; ++side)
		keep_values(values[side], 0, &sides[side]);
	for (repeat = 1; repeat <= set->confirm && worse != 0; ++repeat) {
		for (side = 0; side < 2; ++side) {
			scene_measures m = run_side(set, which, seed, side, repeat);
			judged j = to_judged(&m);
			if (fast && side == 1)
				j.value[M_SPEED] = fmax(j.value[M_SPEED], reference_speed(set, which, seed, repeat));
			keep_values(values[side], repeat, &j);
		}
		if (repeat != 2 && repeat != set->confirm)
			continue;
		for (side = 0; side < 2; ++side)
			sides[side] = median_judged(values[side], repeat + 1);
		worse = worse_mask(&sides[0], &sides[1]);
	}
	return worse;
}

double error_of(const judged *j)
{
	return fmax(fmax(j->value[M_JOINT], j->value[M_OVERLAP]), fmax(j->value[M_MOVED], ERROR_LEAST));
}

int is_expensive(double time_ratio, double gain, double time_most)
{
	return time_ratio > time_most && time_ratio > gain;
}

/* Of a run that was given up or refused nothing is known. */
static void ratios_find(seed_result *r)
{
	const scene_measures *m = r->measures;
	int known = !m[0].refused && !m[1].refused && m[1].step_ms > 0.0;
	r->time_ratio = known ? m[0].step_ms / m[1].step_ms : 1.0;
	r->gain = error_of(&r->judged[1]) / error_of(&r->judged[0]);
}

void confirm_time(const settings *set, const family *which, seed_result *r)
{
	int32_t side, repeat;
	ratios_find(r);
	for (repeat = 0; repeat < EXPENSIVE_RUNS && set->confirm > 0 && is_expensive(r->time_ratio, r->gain, EXPENSIVE_TIME); ++repeat) {
		for (side = 0; side < 2; ++side)
			r->measures[side].step_ms = fmin(r->measures[side].step_ms, run_side(set, which, r->seed, side, 0).step_ms);
		ratios_find(r);
	}
}
