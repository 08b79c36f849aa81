/*
 * test/families/report.c - what is printed of a seed and of a family.
 */
#include "judge.h"

#include <math.h>
#include <stdlib.h>

void print_side(const char *engine, const scene_measures *m)
{
	if (m->refused) {
		printf("    %-7s refused: %s\n", engine, m->refusal);
		return;
	}
	printf("    %-7s joint p99 %.3f max %.3f mean %.3f mm; overlap p99 %.3f max %.3f mm; energy %+.3f %%; speed %.2f m/s (fall %.1f)%s; ", engine, 1e3 * m->joint_p99,
		1e3 * m->joint_max, 1e3 * m->joint_mean, 1e3 * m->overlap_p99, 1e3 * m->overlap_max, m->energy_pct, m->speed_max, m->speed_fall, m->at_limit ? " LIMIT" : "");
	if ((m->flags & SCENE_STANDS) != 0)
		printf("moved %.3f mm; ", 1e3 * m->moved_m);
	printf("step %.4f ms, slowest %.3f; %d steps%s\n", m->step_ms, m->step_max_ms, (int)m->steps, m->broken > 0 ? "; BROKEN" : "");
}

static double median_of(const seed_result *results, int32_t count, int32_t side, int32_t kind)
{
	double *values = malloc((size_t)(count + 1) * sizeof *values), result;
	int32_t k;
	if (values == NULL)
		exit(2);
	for (k = 0; k < count; ++k)
		values[k] = results[k].judged[side].value[kind];
	result = median(values, count);
	free(values);
	return result;
}

static double median_ratio(const seed_result *results, int32_t count, int gain)
{
	double *ratios = malloc((size_t)(count + 1) * sizeof *ratios), result;
	int32_t k;
	if (ratios == NULL)
		exit(2);
	for (k = 0; k < count; ++k)
		ratios[k] = gain ? results[k].gain : results[k].time_ratio;
	result = median(ratios, count);
	free(ratios);
	return result;
}

static void print_times(const seed_result *results, int32_t count)
{
	double worst = 0.0, slow = 0.0;
	int32_t k, at = 0, slow_at = 0;
	for (k = 0; k < count; ++k) {
		const seed_result *r = &results[k];
		if (r->time_ratio > worst)
			worst = r->time_ratio, at = r->seed;
		if (r->measures[0].step_max_ms > slow)
			slow = r->measures[0].step_max_ms, slow_at = r->seed;
	}
	printf(" | time x%.2f, worst x%.1f (seed %d), slowest step %.1f ms (seed %d)\n", median_ratio(results, count, 0), worst, (int)at, slow, (int)slow_at);
}

/* ---- cost that accuracy does not pay for ---- */

static int more_for_less(const void *a, const void *b)
{
	const seed_result *x = a, *y = b;
	double p = x->time_ratio / fmin(x->gain, x->time_ratio), q = y->time_ratio / fmin(y->gain, y->time_ratio);
	return p > q ? -1 : p < q;
}

/* Seeds that are expensive, the worst of them, and the family by its medians. */
static void print_dear(const seed_result *results, int32_t count)
{
	double time = median_ratio(results, count, 0), gain = median_ratio(results, count, 1);
	seed_result *expensive = malloc((size_t)(count + 1) * sizeof *expensive);
	int32_t k, found = 0;
	if (expensive == NULL)
		exit(2);
	for (k = 0; k < count; ++k)
		if (is_expensive(results[k].time_ratio, results[k].gain, EXPENSIVE_TIME))
			expensive[found++] = results[k];
	qsort(expensive, (size_t)found, sizeof *expensive, more_for_less);
	if (is_expensive(time, gain, EXPENSIVE_TIME_MEDIAN))
		printf("    expensive  medians: time x%.2f, error x1/%.2f\n", time, gain);
	if (found > 0)
		printf("    expensive  %d of %d:", (int)found, (int)count);
	for (k = 0; k < found && k < 6; ++k)
		printf("%s seed %d: time x%.1f, error %.3g against %.3g mm", k > 0 ? ";" : "", (int)expensive[k].seed, expensive[k].time_ratio, 1e3 * error_of(&expensive[k].judged[0]),
			1e3 * error_of(&expensive[k].judged[1]));
	if (found > 0)
		printf("\n");
	free(expensive);
}

static const judged *other_of(const seed_result *r, int peer) { return peer ? &r->peer : &r->judged[1]; }

/* The worst seeds of one measure, as many as fit a line. */
static void print_worst(const seed_result *results, int32_t count, int32_t kind, int peer)
{
	int32_t k, shown, last = -1;
	double before = HUGE_VAL;
	printf("    %-8s", kinds[kind].name);
	for (shown = 0; shown < 6; ++shown) {
		int32_t most = -1;
		double at = -1.0;
		for (k = 0; k < count; ++k) {
			const seed_result *r = &results[k];
			double by = excess(&r->judged[0], other_of(r, peer), kind);
			int listed = by > before || (by == before && k <= last);
			if (((peer ? r->worse_than_peer : r->worse) >> kind & 1u) != 0 && !listed && by > at) {
				most = k;
				at = by;
			}
		}
		if (most < 0)
			break;
		last = most;
		before = at;
		printf("%s seed %d: %.3g against %.3g %s", shown > 0 ? ";" : "", (int)results[most].seed, kinds[kind].shown * results[most].judged[0].value[kind],
			kinds[kind].shown * other_of(&results[most], peer)->value[kind], kinds[kind].unit);
	}
	printf("\n");
}

static int32_t count_mask(const seed_result *results, int32_t count, int peer, uint32_t mask)
{
	int32_t k, sum = 0;
	for (k = 0; k < count; ++k)
		sum += ((peer ? results[k].worse_than_peer : results[k].worse) & mask) != 0;
	return sum;
}

static void print_peer(const settings *set, const seed_result *results, int32_t count)
{
	int32_t k, compared = 0;
	for (k = 0; k < count; ++k)
		compared += results[k].has_peer;
	if (set->peer == NULL)
		return;
	if (compared == 0) {
		printf("  %s cannot build it\n", set->peer_name);
		return;
	}
	printf("  worse than %s in %d of %d\n", set->peer_name, (int)count_mask(results, count, 1, UINT32_MAX), (int)compared);
	for (k = 0; k < M_COUNT; ++k)
		if (count_mask(results, count, 1, 1u << k) > 0)
			print_worst(results, count, k, 1);
}

/* How often each side is worse in the first run: where both are as often, the runs differ by chance. */
static void print_both_ways(const settings *set, const seed_result *results, int32_t count)
{
	int32_t kind, side, k;
	printf("    first runs, %s worse : %s worse:", set->names[0], set->names[1]);
	for (kind = 0; kind < M_COUNT; ++kind) {
		int32_t seeds[2] = { 0, 0 };
		for (side = 0; side < 2; ++side)
			for (k = 0; k < count; ++k)
				seeds[side] += (int32_t)(results[k].first_worse[side] >> kind & 1u);
		if (seeds[0] + seeds[1] > 0)
			printf(" %s %d:%d", kinds[kind].name, (int)seeds[0], (int)seeds[1]);
	}
	printf("\n");
}

int32_t report_family(const settings *set, const family *which, const seed_result *results, int32_t count, double cpu_s)
{
	int32_t k, worse = count_mask(results, count, 0, UINT32_MAX);
	printf("%-13s %d seeds, %d worse", which->name, (int)count, (int)worse);
	for (k = 0; k < M_COUNT; ++k)
		if (worse > 0 && count_mask(results, count, 0, 1u << k) > 0)
			printf(", %s %d", kinds[k].name, (int)count_mask(results, count, 0, 1u << k));
	printf(" | medians");
	for (k = 0; k < M_BROKEN; ++k) {
		double a = median_of(results, count, 0, k), b = median_of(results, count, 1, k);
		if (a != 0.0 || b != 0.0)
			printf(" %s %.3g/%.3g %s", kinds[k].name, kinds[k].shown * a, kinds[k].shown * b, kinds[k].unit);
	}
	print_times(results, count);
	for (k = 0; k < M_COUNT; ++k)
		if (count_mask(results, count, 0, 1u << k) > 0)
			print_worst(results, count, k, 0);
	print_both_ways(set, results, count);
	print_dear(results, count);
	print_peer(set, results, count);
	if (getenv("FAMILIES_TIMES") != NULL)
		printf("    took %.1f s\n", cpu_s);
	fflush(stdout);
	return worse;
}
