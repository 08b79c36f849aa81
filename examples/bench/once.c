/*
 * examples/bench/once.c - one run of one scene, for those that compare libraries: bench/diff.sh links it with two.
 *
 *     bench_once --list                         names of the benchmark's scenes
 *     bench_once scene [--steps n] [--times file]
 *
 * Prints scene,steps,ms,displacement_m,joint_m,penetration_m,hash. ms is the processor time of all steps but the
 * first; --times gets that of each, a line a step. What a scene creates and destroys between steps, and measuring,
 * is not timed. Errors are the largest of samples as in bench.c.
 */
#include "measure/measure.h"
#include "scenes/scenes.h"
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define SAMPLE_STEPS 20

typedef struct once {
	scene_run run;
	measure_worst worst;
	measure_start start;
	double total_ms;
} once;

static void step_timed(once *o, double clock_s, FILE *times)
{
	double start = measure_cpu_s();
	o->run.result = measure_step(o->run.world, SCENE_STEP_S);
	double ms = 1000.0 * (measure_cpu_s() - start - clock_s);
	ms = ms > 0.0 ? ms : 0.0;
	o->total_ms += ms;
	if (times != NULL)
		fprintf(times, "%.6f\n", ms);
}

static int32_t run_steps(once *o, int32_t steps, FILE *times)
{
	double clock_s = measure_cpu_clock_cost_s();
	for (int32_t i = 0; i < steps; ++i) {
		if (scene_before_step(&o->run) != CN_OK)
			return 0;
		if (i == 0)
			o->run.result = cn_world_step(o->run.world, SCENE_STEP_S);
		else
			step_timed(o, clock_s, times);
		if (o->run.result != CN_OK)
			return 0;
		++o->run.step_index;
		if (i % SAMPLE_STEPS == 0 || i + 1 == steps)
			measure_errors(&o->worst, o->run.world);
	}
	return !o->worst.failed;
}

static void print_row(const once *o, int32_t steps)
{
	uint64_t hash = 0;
	cn_world_hash(o->run.world, &hash);
	printf("%s,%" PRId32 ",%.4f,", o->run.scene->name, steps, o->total_ms);
	if (o->run.scene->flags & SCENE_STANDS)
		printf("%.6f", (double)measure_displacement(&o->start, o->run.world));
	printf(",%.6f,%.6f,%016" PRIx64 "\n", (double)o->worst.joint_m, (double)o->worst.penetration_m, hash);
}

static int32_t run_scene(const scene *which, int32_t steps, FILE *times)
{
	once o;
	int32_t good = 0;
	memset(&o, 0, sizeof o);
	if (scene_open(&o.run, which, NULL) != CN_OK) {
		fprintf(stderr, "%s: %s\n", which->name, o.run.error_text);
		return 0;
	}
	if (measure_start_open(&o.start, o.run.world)) {
		good = run_steps(&o, steps, times);
		if (good)
			print_row(&o, steps);
		else
			fprintf(stderr, "%s: step %" PRId32 ": %s\n", which->name, o.run.step_index, cn_world_error_text(o.run.world));
	}
	measure_start_close(&o.start);
	scene_close(&o.run);
	return good;
}

static void list_scenes(void)
{
	for (int32_t i = 0; i < scene_count(); ++i) {
		if (scene_at(i)->flags & SCENE_BENCH)
			printf("%s %" PRId32 "\n", scene_at(i)->name, scene_at(i)->step_count);
	}
}

static int usage(void)
{
	fprintf(stderr, "usage: bench_once --list | scene [--steps n] [--times file]\n");
	return 2;
}

int main(int argc, char **argv)
{
	const scene *which;
	FILE *times = NULL;
	long steps;
	if (argc == 2 && strcmp(argv[1], "--list") == 0) {
		list_scenes();
		return 0;
	}
	which = argc > 1 ? scene_find(argv[1]) : NULL;
	if (which == NULL)
		return usage();
	steps = which->step_count;
	for (int i = 2; i < argc; i += 2) {
		if (i + 1 < argc && strcmp(argv[i], "--steps") == 0)
			steps = strtol(argv[i + 1], NULL, 10);
		else if (i + 1 < argc && times == NULL && strcmp(argv[i], "--times") == 0)
			times = fopen(argv[i + 1], "w");
		else
			return usage();
	}
	int32_t good = steps > 0 && steps <= INT32_MAX && run_scene(which, (int32_t)steps, times);
	if (times != NULL)
		good &= fclose(times) == 0;
	return good ? 0 : 1;
}
