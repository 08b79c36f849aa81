/*
 * examples/bench/bench.c - times every benchmark scene, on one core, and prints CSV, one row a scene, with
 * how exact the result was beside each time.
 *
 *     bench [scene]        bench broadphase and bench queries: see bench/broadphase.c
 *     WORKERS=2 bench      with so many workers, on as many cores
 *
 * The first step has a time of its own, ms_first; what a scene creates and destroys between steps is not timed. bodies,
 * contacts (touching) and joints are as of the last step. bytes_per_body is all memory of the world by
 * its bodies; in the rows memory_*, which take one step and no time, it is the point, and for the empty
 * world it is the world's bytes. Largest penetration and joint error are over samples taken every
 * 20 steps and at the end. displacement_max_m is given where bodies should stay where they are.
 */
#include "bench/broadphase.h"
#include "measure/measure.h"
#include "scenes/scenes.h"
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define SAMPLE_STEPS 20

typedef struct bench_run {
	scene_run run;
	measure_times times;   /* of all steps but the first */
	double first_ms;
	measure_worst worst;
	measure_start start;
} bench_run;

static cn_result run_steps(bench_run *b)
{
	for (int32_t i = 0; i < b->run.scene->step_count; ++i) {
		if (scene_before_step(&b->run) != CN_OK)
			break;
		double start = measure_clock_s();
		b->run.result = cn_world_step(b->run.world, SCENE_STEP_S);
		double end = measure_clock_s();
		if (b->run.result != CN_OK)
			break;
		++b->run.step_index;
		if (i > 0)
			measure_times_add(&b->times, end - start);
		else
			b->first_ms = 1000.0 * (end - start);
		if (i % SAMPLE_STEPS == 0 || i + 1 == b->run.scene->step_count)
			measure_errors(&b->worst, b->run.world);
	}
	return b->run.result;
}

static void print_row(bench_run *b)
{
	const cn_world *world = b->run.world;
	cn_counters counters;
	cn_memory_stats memory;
	uint64_t hash = 0;
	int32_t workers = 1;
	cn_world_get_worker_count(world, &workers);
	cn_world_get_counters(world, &counters);
	cn_world_get_memory_stats(world, &memory);
	cn_world_hash(world, &hash);
	measure_times_sort(&b->times);
	double bytes_per_body = (double)memory.bytes_in_use / (double)(counters.bodies > 0 ? counters.bodies : 1);
	printf("%s,%" PRId32 ",%" PRId32 ",%" PRId32 ",%" PRId32 ",%.4f,%.4f,%.0f,%016" PRIx64 ",", b->run.scene->name, counters.bodies,
		counters.contacts_touching, counters.joints, workers, measure_times_at(&b->times, 0.0), measure_times_at(&b->times, 0.5), bytes_per_body, hash);
	if (b->run.scene->flags & SCENE_STANDS)
		printf("%.6f", (double)measure_displacement(&b->start, world));
	printf(",%.6f,%.6f,%" PRId32, (double)b->worst.joint_m, (double)b->worst.penetration_m,
		measure_bodies_left(world, &b->run.scene->bounds_m));
	printf(",%.4f,%.4f,%.4f\n", measure_times_at(&b->times, 0.99), measure_times_at(&b->times, 1.0), b->first_ms);
	fflush(stdout);
}

static int32_t worker_count(void)
{
	const char *workers = getenv("WORKERS");
	return workers != NULL ? (int32_t)strtol(workers, NULL, 10) : 1;
}

static int32_t run_scene(const scene *which)
{
	bench_run b;
	cn_world_def def;
	int32_t good = 0;
	memset(&b, 0, sizeof b);
	scene_world_def(which, &def);
	def.worker_count = worker_count();
	if (scene_open(&b.run, which, &def) != CN_OK) {
		fprintf(stderr, "%s: %s\n", which->name, b.run.error_text);
		return 0;
	}
	if (measure_times_open(&b.times, which->step_count) && measure_start_open(&b.start, b.run.world)) {
		good = run_steps(&b) == CN_OK && !b.worst.failed;
		if (good)
			print_row(&b);
		else
			fprintf(stderr, "%s: step %" PRId32 ": %s\n", which->name, b.run.step_index, cn_world_error_text(b.run.world));
	}
	measure_start_close(&b.start);
	measure_times_close(&b.times);
	scene_close(&b.run);
	return good;
}

static int32_t is_bench(const scene *which) { return (which->flags & SCENE_BENCH) || strncmp(which->name, "memory_", 7) == 0; }

int main(int argc, char **argv)
{
	int32_t failed = 0;
	if (worker_count() < 2)
		measure_stay_on_core();
	if (argc > 1 && strcmp(argv[1], "broadphase") == 0)
		return bench_broadphase() != 0;
	if (argc > 1 && strcmp(argv[1], "queries") == 0)
		return bench_queries() != 0;
	if (argc > 1 && scene_find(argv[1]) == NULL) {
		fprintf(stderr, "there is no scene named %s; there are: broadphase queries", argv[1]);
		for (int32_t i = 0; i < scene_count(); ++i)
			fprintf(stderr, " %s", scene_at(i)->name);
		fprintf(stderr, "\n");
		return 2;
	}
	printf("scene,bodies,contacts,joints,threads,ms_min,ms_median,bytes_per_body,hash,"
		   "displacement_max_m,joint_error_max_m,penetration_max_m,bodies_left,ms_p99,ms_max,ms_first\n");
	for (int32_t i = 0; i < scene_count(); ++i) {
		const scene *which = scene_at(i);
		if (argc > 1 ? strcmp(which->name, argv[1]) == 0 : is_bench(which))
			failed += !run_scene(which);
	}
	return failed != 0;
}
