/*
 * test/schedule/main.c - times of a step with 1 to 64 workers by a simulated schedule (team.c), and what stays serial.
 *
 *     schedule [scene ...] [--steps n] [--line-ns t]
 *
 * For each benchmark scene: n steps (30), evenly spread over the run, under the simulated clock. Prints
 * scene,workers,ms,ratio: milliseconds a step, and by how much that is faster than one worker. Then, for each stage of cn_profile,
 * scene,serial:stage,ms,share: what no worker shares, and its share in the step of one worker.
 *
 * The state after a run must have the same hash with all numbers of workers, whatever the order of chunks.
 */
#include "scenes/scenes.h"
#include "team.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define STEPS 30

static const struct {
	const char *name;
	size_t at;
} stages[] = {
	{ "broadphase", offsetof(cn_profile, broadphase_s) }, { "narrowphase", offsetof(cn_profile, narrowphase_s) },
	{ "prepare", offsetof(cn_profile, prepare_s) },       { "substeps", offsetof(cn_profile, substeps_s) },
	{ "finalize", offsetof(cn_profile, finalize_s) },     { "sleep", offsetof(cn_profile, sleep_s) },
	{ "events", offsetof(cn_profile, events_s) },         { "step", offsetof(cn_profile, step_s) },
};
enum { STAGES = sizeof stages / sizeof stages[0], STEP = STAGES - 1 };

typedef struct times {
	double ms[STAGES];
	uint64_t hash; /* at the end of the run */
} times;

static int32_t fail(const scene_run *run)
{
	fprintf(stderr, "%s: %s\n", run->scene->name, run->error_text);
	return 0;
}

/* Means of as many steps, evenly spread over the run of a scene. */
static int32_t scene_times(const scene *which, int32_t workers, schedule_mode mode, int32_t steps, times *out)
{
	cn_world_def def;
	scene_run run;
	int32_t stride = which->step_count / steps, k, stage;
	memset(out, 0, sizeof *out);
	cn_world_def_init(&def);
	def.flags |= CN_WORLD_PROFILE;
	def.worker_count = workers;
	schedule.mode = SCHEDULE_OFF;
	if (scene_open(&run, which, &def) != CN_OK)
		return fail(&run);
	for (k = 0; k < which->step_count; ++k) {
		cn_profile profile;
		int32_t measured = k % stride == stride - 1 && k / stride < steps;
		schedule.mode = measured ? mode : SCHEDULE_OFF;
		if (scene_step(&run) != CN_OK)
			return fail(&run);
		cn_world_get_profile(run.world, &profile);
		for (stage = 0; stage < STAGES && measured; ++stage)
			out->ms[stage] += 1000.0 / steps * (double)*(const float *)(const void *)((const char *)&profile + stages[stage].at);
	}
	cn_world_hash(run.world, &out->hash);
	scene_close(&run);
	return 1;
}

static int32_t is_same(const scene *which, int32_t workers, const times *one, const times *other)
{
	if (one->hash != other->hash)
		fprintf(stderr, "%s: another hash with %" PRId32 " workers\n", which->name, workers);
	return one->hash == other->hash;
}

static int32_t scene_print(const scene *which, int32_t steps)
{
	times one, shared, serial;
	int32_t workers, stage;
	if (steps > which->step_count)
		steps = which->step_count;
	if (!scene_times(which, 1, SCHEDULE_SHARED, steps, &one))
		return 0;
	printf("%s,1,%.4f,1.00\n", which->name, one.ms[STEP]);
	for (workers = 2; workers <= CN_WORKERS_MAX; workers *= 2) {
		if (!scene_times(which, workers, SCHEDULE_SHARED, steps, &shared) || !is_same(which, workers, &one, &shared))
			return 0;
		printf("%s,%" PRId32 ",%.4f,%.2f\n", which->name, workers, shared.ms[STEP], one.ms[STEP] / shared.ms[STEP]);
	}
	if (!scene_times(which, CN_WORKERS_MAX, SCHEDULE_SERIAL, steps, &serial))
		return 0;
	for (stage = 0; stage < STAGES; ++stage)
		printf("%s,serial:%s,%.4f,%.3f\n", which->name, stages[stage].name, serial.ms[stage], serial.ms[stage] / one.ms[STEP]);
	fflush(stdout);
	return 1;
}

int main(int argc, char **argv)
{
	int32_t steps = STEPS, named = 0, good = 1;
	int k;
	printf("scene,workers,ms,ratio\n");
	for (k = 1; k + 1 < argc; ++k) {
		if (strcmp(argv[k], "--steps") == 0)
			steps = (int32_t)strtol(argv[k + 1], NULL, 10);
		if (strcmp(argv[k], "--line-ns") == 0)
			schedule.line_ns = strtod(argv[k + 1], NULL);
	}
	for (k = 1; k < argc; ++k) {
		const scene *which = scene_find(argv[k]);
		if (strncmp(argv[k], "--", 2) == 0) {
			++k;
			continue;
		}
		named = 1;
		if (which == NULL) {
			fprintf(stderr, "schedule: there is no scene %s\n", argv[k]);
			return 2;
		}
		good &= scene_print(which, steps);
	}
	for (k = 0; !named && k < scene_count(); ++k)
		if (scene_at(k)->flags & SCENE_BENCH)
			good &= scene_print(scene_at(k), steps);
	return good ? 0 : 1;
}
