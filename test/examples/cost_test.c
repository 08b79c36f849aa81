/*
 * test/examples/cost_test.c - every feature of make feature-cost can be made and stepped in each of its forms, and one that
 * nothing uses changes no bit of what moves. What it costs is not looked at here.
 */
#include "cost/cost.h"
#include "test.h"

#define STEPS 60

static int32_t run(const cost_feature *feature, int32_t form, uint64_t *out_hash)
{
	cost_world w;
	int32_t good = cost_open(&w, feature, form), k;
	for (k = 0; k < STEPS && good; ++k)
		good = cost_step(&w) == CN_OK;
	*out_hash = good ? cost_hash(&w) : 0;
	if (!good)
		printf("  %s, form %d: %s\n", feature->name, (int)form, w.run.error_text);
	cost_close(&w);
	return good;
}

static void check_features(const cost_feature *features, int32_t count)
{
	int32_t k;
	for (k = 0; k < count; ++k) {
		uint64_t without = 0, unused = 0, other = 0;
		CHECK(run(&features[k], COST_WITHOUT, &without));
		if (features[k].has_unused) {
			CHECK(run(&features[k], COST_UNUSED, &unused));
			if (unused != without)
				printf("  %s moves the drum otherwise\n", features[k].name);
			CHECK(unused == without || features[k].has_unused == COST_UNUSED_OTHERWISE);
		}
		if (features[k].used != NULL) {
			CHECK(run(&features[k], COST_PLAIN, &other));
			CHECK(run(&features[k], COST_USED, &other));
		}
	}
}

static void world_features_change_nothing_unused(void) { check_features(cost_world_features, cost_world_feature_count); }
static void surface_features_change_nothing_unused(void) { check_features(cost_surface_features, cost_surface_feature_count); }
static void joint_features_change_nothing_unused(void) { check_features(cost_joint_features, cost_joint_feature_count); }

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(world_features_change_nothing_unused);
	RUN(surface_features_change_nothing_unused);
	RUN(joint_features_change_nothing_unused);
	return test_end();
}
