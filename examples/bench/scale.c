/*
 * examples/bench/scale.c - how the cost of a step grows with the number of bodies at fixed density: `make bench-scale`,
 * by scale.sh, which fits the exponents and draws.
 *
 *     bench_scale [kind [bodies]]     all of them, one kind, or one kind and number
 *
 * Prints kind,bodies,ms,ns_per_body,contacts. A run repeats to the bit, so the least processor time of each step over
 * some rounds is taken, and the mean of the same steps is printed for every number of bodies: the least of all would be
 * less the more a scene varies, and small scenes vary more. In a round all numbers take turns, so that a slow minute of
 * the machine is everybody's. contacts are those that touch after the last step; of a broadphase, new pairs a step.
 */
#include "bench/broadphase.h"
#include "bench/scale_scenes.h"
#include "measure/measure.h"
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { STEPS = 20, SIZES = 7, ROUNDS_MAX = 20 };

static const int32_t sizes[SIZES] = {1000, 3000, 10000, 30000, 100000, 300000, 1000000};

typedef struct kind {
	const char *name;
	void (*describe)(scene *out, int32_t bodies); /* NULL: the broadphase of this name, alone */
	int32_t bodies_max;
	int32_t warm_steps; /* until it is as it stays */
} kind;

static const kind kinds[] = {
	{"field", scale_field, 100000, 90},
	{"piles", scale_piles, 100000, 20},
	{"sweep", NULL, 1000000, 40},
	{"tree", NULL, 1000000, 40},
};
enum { KINDS = sizeof kinds / sizeof kinds[0] };

typedef struct sample {
	double ms[STEPS];
	double contacts;
} sample;

/* ------------------------------------------------------------------ one run */

static int32_t time_steps(scene_run *run, const kind *k, sample *out)
{
	cn_counters counters;
	double clock_s = measure_cpu_clock_cost_s();
	for (int32_t i = -k->warm_steps; i < STEPS; ++i) {
		double start = measure_cpu_s();
		run->result = measure_step(run->world, SCENE_STEP_S);
		if (run->result != CN_OK) {
			fprintf(stderr, "%s: step %" PRId32 ": %s\n", k->name, i, cn_world_error_text(run->world));
			return 0;
		}
		if (i >= 0)
			out->ms[i] = 1000.0 * (measure_cpu_s() - start - clock_s);
	}
	cn_world_get_counters(run->world, &counters);
	out->contacts = (double)counters.contacts_touching;
	return 1;
}

static int32_t run_world(const kind *k, int32_t bodies, sample *out)
{
	scene which;
	scene_run run;
	k->describe(&which, bodies);
	if (scene_open(&run, &which, NULL) != CN_OK) {
		fprintf(stderr, "%s: %s\n", k->name, run.error_text);
		return 0;
	}
	int32_t good = time_steps(&run, k, out);
	scene_close(&run);
	return good;
}

static int32_t run_broadphase(const kind *k, int32_t bodies, sample *out)
{
	if (bench_broadphase_scale(k->name, bodies, k->warm_steps, STEPS, out->ms, &out->contacts))
		return 1;
	fprintf(stderr, "%s: no memory\n", k->name);
	return 0;
}

/* ------------------------------------------------------------------ rounds */

/* Small worlds, whose steps are easily disturbed and cost little, have more. */
static int32_t round_count(int32_t bodies)
{
	int32_t rounds = 200000 / bodies;
	return rounds > ROUNDS_MAX ? ROUNDS_MAX : rounds < 2 ? 2 : rounds;
}

static int32_t run_round(const kind *k, int32_t bodies, int32_t round, sample *least)
{
	sample now;
	if (!(k->describe != NULL ? run_world(k, bodies, &now) : run_broadphase(k, bodies, &now)))
		return 0;
	least->contacts = now.contacts;
	for (int32_t i = 0; i < STEPS; ++i)
		least->ms[i] = round == 0 || now.ms[i] < least->ms[i] ? now.ms[i] : least->ms[i];
	return 1;
}

static void print_row(const kind *k, int32_t bodies, const sample *least)
{
	double ms = 0.0;
	for (int32_t i = 0; i < STEPS; ++i)
		ms += least->ms[i] / (double)STEPS;
	printf("%s,%" PRId32 ",%.5f,%.2f,%.0f\n", k->name, bodies, ms, 1.0e6 * ms / bodies, least->contacts);
	fflush(stdout);
}

/* only: 0, or the one number to run. */
static int32_t run_kind(const kind *k, int32_t only)
{
	sample least[SIZES];
	for (int32_t round = 0; round < ROUNDS_MAX; ++round) {
		for (int32_t i = 0; i < SIZES && sizes[i] <= k->bodies_max; ++i) {
			if ((only == 0 || only == sizes[i]) && round < round_count(sizes[i]) && !run_round(k, sizes[i], round, &least[i]))
				return 0;
		}
	}
	for (int32_t i = 0; i < SIZES && sizes[i] <= k->bodies_max; ++i) {
		if (only == 0 || only == sizes[i])
			print_row(k, sizes[i], &least[i]);
	}
	return 1;
}

static int32_t is_size(int32_t bodies)
{
	for (int32_t i = 0; i < SIZES; ++i) {
		if (bodies == sizes[i])
			return 1;
	}
	return 0;
}

int main(int argc, char **argv)
{
	int32_t only = argc > 2 ? (int32_t)strtol(argv[2], NULL, 10) : 0;
	int32_t found = 0, failed = 0;
	measure_stay_on_core();
	for (int32_t i = 0; i < KINDS; ++i)
		found |= argc < 2 || strcmp(argv[1], kinds[i].name) == 0;
	if (!found || (argc > 2 && !is_size(only))) {
		fprintf(stderr, "usage: bench_scale [field | piles | sweep | tree [1000 | 3000 | ...]]\n");
		return 2;
	}
	printf("kind,bodies,ms,ns_per_body,contacts\n");
	for (int32_t i = 0; i < KINDS; ++i) {
		if (argc < 2 || strcmp(argv[1], kinds[i].name) == 0)
			failed += !run_kind(&kinds[i], only);
	}
	return failed != 0;
}
