/*
 * examples/cost/cost.c - runs one feature in one form (cost.h), under callgrind or by itself: run.sh makes the table.
 *
 *     feature_cost --list                 name|has unused|used form|units|without|plain, a line a feature; the last two
 *                                         name the worlds of these forms: features that share one have the same there
 *     feature_cost name form [steps]      form: 0 without, 1 unused, 2 plain, 3 used
 *
 * Prints the processor time of a step in microseconds, the least of three runs, and the hash of the drum's bodies. The
 * first 120 steps are not counted: the drum fills. Under callgrind (steps given) there is one run.
 */
#include "cost/cost.h"
#include "measure/measure.h"
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define WARM_STEPS 120
#define STEPS 60
#define RUNS 3

static const cost_feature *find(const char *name, const cost_feature *features, int32_t count)
{
	for (int32_t i = 0; i < count; ++i) {
		if (strcmp(features[i].name, name) == 0)
			return &features[i];
	}
	return NULL;
}

static const cost_feature *find_anywhere(const char *name)
{
	const cost_feature *found = find(name, cost_world_features, cost_world_feature_count);
	found = found != NULL ? found : find(name, cost_surface_features, cost_surface_feature_count);
	return found != NULL ? found : find(name, cost_joint_features, cost_joint_feature_count);
}

static void list(const cost_feature *features, int32_t count)
{
	for (int32_t i = 0; i < count; ++i) {
		const cost_feature *f = &features[i];
		const char *without = f->define != NULL || f->build != NULL ? f->name : "base";
		const char *plain = f->on_pair != NULL ? "pairs" : without;
		printf("%s|%" PRId32 "|%s|%" PRId32 "|%s|%s\n", f->name, (int32_t)(f->has_unused != COST_UNUSED_NONE), f->used != NULL ? f->used : "", f->units, without, plain);
	}
}

/* Microseconds a step; below 0 when something failed. */
static double run_once(const cost_feature *feature, int32_t form, int32_t steps, uint64_t *out_hash)
{
	cost_world w;
	double start = 0.0, taken = -1.0;
	if (cost_open(&w, feature, form)) {
		for (int32_t i = 0; i < WARM_STEPS && w.run.result == CN_OK; ++i)
			w.run.result = cn_world_step(w.run.world, SCENE_STEP_S);
		start = measure_cpu_s();
		for (int32_t i = 0; i < steps && w.run.result == CN_OK; ++i)
			w.run.result = cost_step(&w);
		taken = 1.0e6 * (measure_cpu_s() - start) / (double)steps;
	}
	*out_hash = w.run.result == CN_OK ? cost_hash(&w) : 0;
	if (w.run.result != CN_OK) {
		fprintf(stderr, "%s: %s\n", feature->name, w.run.error_text[0] != '\0' ? w.run.error_text : cn_world_error_text(w.run.world));
		taken = -1.0;
	}
	cost_close(&w);
	return taken;
}

static int usage(void)
{
	fprintf(stderr, "usage: feature_cost --list | name form [steps]\n");
	return 2;
}

int main(int argc, char **argv)
{
	uint64_t hash = 0;
	double least = -1.0;
	if (argc == 2 && strcmp(argv[1], "--list") == 0) {
		list(cost_world_features, cost_world_feature_count);
		list(cost_surface_features, cost_surface_feature_count);
		list(cost_joint_features, cost_joint_feature_count);
		return 0;
	}
	const cost_feature *feature = argc > 2 ? find_anywhere(argv[1]) : NULL;
	long form = argc > 2 ? strtol(argv[2], NULL, 10) : -1, steps = argc > 3 ? strtol(argv[3], NULL, 10) : STEPS;
	if (feature == NULL || form < 0 || form >= COST_FORMS || steps < 1 || steps > 100000)
		return usage();
	for (int32_t run = 0; run < (argc > 3 ? 1 : RUNS); ++run) {
		double us = run_once(feature, (int32_t)form, (int32_t)steps, &hash);
		if (us < 0.0)
			return 1;
		least = run == 0 || us < least ? us : least;
	}
	printf("%.3f %016" PRIx64 "\n", least, hash);
	return 0;
}
