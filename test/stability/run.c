/*
 * test/stability/run.c - one run of one case: makes the world, builds, steps, observes, finishes.
 *
 * Timed is cn_world_step and nothing else: processor time over all frames, less what reading the clock costs.
 */
#ifndef _WIN32
#define _POSIX_C_SOURCE 200112L
#endif
#include "scene.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#ifdef CLOCK_PROCESS_CPUTIME_ID
static double cpu_clock_s(void)
{
	struct timespec now;
	clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
	return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}
#else
static double cpu_clock_s(void) { return (double)clock() / (double)CLOCKS_PER_SEC; }
#endif

/* A case that takes longer is given up between two frames: the direct solver may be asked for what it is not made for. */
#define CPU_MAX_S 60.0

static double clock_cost_s(void)
{
	static double cost_s = -1.0;
	int32_t k;
	if (cost_s >= 0.0)
		return cost_s;
	cost_s = 1.0;
	for (k = 0; k < 200; ++k) {
		double start = cpu_clock_s(), end = cpu_clock_s();
		if (end - start < cost_s)
			cost_s = end - start;
	}
	return cost_s;
}

int scene_check(scene_run *run, cn_result result)
{
	if (result != CN_OK && run->refusal[0] == '\0') {
		const char *why = cn_world_error_text(run->world);
		snprintf(run->refusal, sizeof run->refusal, "%s", why[0] != '\0' ? why : cn_result_text(result));
	}
	return run->refusal[0] == '\0';
}

void scene_report(scene_run *run, const char *metric, double value)
{
	if (run->metric_count == SCENE_METRICS_MAX) {
		fprintf(stderr, "stability: family %s reports too many metrics\n", run->family->name);
		exit(2);
	}
	run->metrics[run->metric_count].name = metric;
	run->metrics[run->metric_count].value = value;
	++run->metric_count;
}

static void make_world(scene_run *run, const scene_settings *settings)
{
	cn_world_def def;
	cn_world_def_init(&def);
	def.solver = settings->solver;
	if (settings->substeps > 0)
		def.substep_count = settings->substeps;
	def.gravity_mps2.y = (float)-scene_value(run, "gravity");
	def.length_unit_m = (float)scene_value(run, "unit");
	if (scene_value(run, "sleep") == 0.0)
		def.flags &= ~(uint32_t)CN_WORLD_SLEEP;
	if (cn_world_def_check(&def, run->refusal, (int32_t)sizeof run->refusal) != CN_OK)
		return;
	run->refusal[0] = '\0';
	scene_check(run, cn_world_create(&def, &run->world));
}

/* Frames of 0.5 to 1.5 times the mean, by a multiplicative generator (Park and Miller, 1988). */
static double frame_time(const scene_run *run, uint64_t *random)
{
	if (scene_value(run, "vary") == 0.0)
		return run->dt_s;
	*random = *random * 48271u % 2147483647u;
	return run->dt_s * (0.5 + (double)*random / 2147483647.0);
}

static void step_frames(scene_run *run)
{
	uint64_t random = 12345;
	double cost_s = clock_cost_s();
	while (run->frame < run->frame_count && run->refusal[0] == '\0') {
		float dt_s = (float)frame_time(run, &random);
		double start = cpu_clock_s(), spent;
		cn_result result = cn_world_step(run->world, dt_s);
		spent = cpu_clock_s() - start - cost_s;
		run->cpu_s += spent > 0.0 ? spent : 0.0;
		if (!scene_check(run, result))
			return;
		if (run->cpu_s > CPU_MAX_S)
			snprintf(run->refusal, sizeof run->refusal, "given up at frame %d after %.0f s of processor time", (int)run->frame, CPU_MAX_S);
		++run->frame;
		run->time_s += (double)dt_s;
		scene_film_frame(run);
		if (run->family->observe != NULL)
			run->family->observe(run);
	}
}

int scene_execute(scene_run *run, const scene_family *family, const scene_case *which, const scene_settings *settings)
{
	memset(run, 0, sizeof *run);
	run->family = family;
	run->parameters[0] = family->parameters;
	run->parameters[1] = which->parameters;
	run->parameters[2] = settings->parameters;
	run->density = 1.0;
	run->friction = 0.6;
	run->far_m = scene_value(run, "far");
	run->film = settings->film;
	run->state = calloc(1, (size_t)family->state_bytes + 1);
	if (run->state == NULL)
		return 0;
	run->dt_s = settings->dt_s > 0.0 ? settings->dt_s : 1.0 / scene_value(run, "hertz");
	run->frame_count = (int32_t)lround((settings->seconds > 0.0 ? settings->seconds : scene_value(run, "seconds")) / run->dt_s);
	make_world(run, settings);
	if (run->refusal[0] == '\0')
		family->build(run);
	if (run->refusal[0] == '\0')
		step_frames(run);
	if (run->refusal[0] == '\0')
		family->finish(run);
	scene_film_metrics(run);
	return run->refusal[0] == '\0';
}

void scene_dispose(scene_run *run)
{
	cn_world_destroy(run->world);
	free(run->state);
	free(run->items);
	free(run->joints);
	memset(run, 0, sizeof *run);
}
