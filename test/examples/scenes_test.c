/*
 * test/examples/scenes_test.c - every scene can be made, has the numbers of bodies and joints that its
 * description promises, takes steps, and gives the same bits when it is made again.
 */
#include "measure/measure.h"
#include "scenes/scenes.h"
#include "test.h"
#include <math.h>

typedef struct expectation {
	const char *name;
	int32_t bodies; /* static ones too */
	int32_t joints;
	int32_t shapes;
} expectation;

static const expectation expectations[] = {
	{"pyramid", 466, 0, 466},
	{"tumbler_1000", 1001, 1, 1004},
	{"bridge", 214, 201, 214},
	{"falling_hinges", 121, 60, 121},
	{"machines", 55, 30, 56},
	{"constraints", 63, 14, 65}, /* 9 joints and 5 constraints on one body */
	{"large_pyramid", 5051, 0, 5051},
	{"many_pyramids", 22001, 0, 22020},
	{"joint_grid", 10000, 19794, 10000}, /* 19,800 less the six between static circles */
	{"tumbler", 2026, 1, 2029},
	{"spinner", 6078, 1, 6078},
	{"smash", 9601, 0, 9601},
	{"rain", 5, 0, 2505},
	{"workshop", 1277, 977, 1257},
	{"small_200", 201, 0, 212},
	{"memory_empty", 0, 0, 0},
	{"memory_lone_box", 1000, 0, 1000},
};

static void t_scenes_have_what_they_promise(void)
{
	for (size_t i = 0; i < sizeof expectations / sizeof expectations[0]; ++i) {
		const expectation *e = &expectations[i];
		scene_run run;
		cn_counters counters;
		REQUIRE(scene_find(e->name) != NULL);
		if (scene_open(&run, scene_find(e->name), NULL) != CN_OK) {
			printf("  %s: %s\n", e->name, run.error_text);
			test_fail(__FILE__, __LINE__, "the scene can be made");
			continue;
		}
		cn_world_get_counters(run.world, &counters);
		if (counters.bodies != e->bodies || counters.joints != e->joints || counters.shapes != e->shapes)
			printf("  %s: %d bodies, %d joints, %d shapes\n", e->name, counters.bodies, counters.joints, counters.shapes);
		CHECK(counters.bodies == e->bodies && counters.joints == e->joints && counters.shapes == e->shapes);
		scene_close(&run);
	}
}

/* Hash after so many steps, 0 after a failure. */
static uint64_t hash_after(const scene *which, int32_t steps)
{
	scene_run run;
	uint64_t hash = 0;
	char text[200] = "";
	if (scene_open(&run, which, NULL) != CN_OK) {
		printf("  %s: %s\n", which->name, run.error_text);
		return 0;
	}
	while (run.step_index < steps && scene_step(&run) == CN_OK) {
	}
	if (run.result != CN_OK || cn_world_validate(run.world, text, sizeof text) != CN_OK)
		printf("  %s, step %d: %s%s\n", which->name, run.step_index, run.error_text, text);
	else
		cn_world_hash(run.world, &hash);
	scene_close(&run);
	return hash;
}

static void t_demo_scenes_repeat_bit_for_bit(void)
{
	for (int32_t i = 0; i < scene_count(); ++i) {
		const scene *which = scene_at(i);
		if (!(which->flags & SCENE_DEMO))
			continue;
		uint64_t first = hash_after(which, 60), second = hash_after(which, 60);
		printf("  %s: %016llx\n", which->name, (unsigned long long)first);
		CHECK(first != 0 && first == second);
	}
}

/* The rain makes 25 ragdolls of 11 bodies every 8 steps, and never has more than 40 columns. */
static void t_rain_makes_and_destroys(void)
{
	scene_run run;
	cn_counters counters;
	REQUIRE(scene_open(&run, scene_find("rain"), NULL) == CN_OK);
	for (int32_t i = 0; i < 24; ++i)
		scene_step(&run);
	cn_world_get_counters(run.world, &counters);
	CHECK(counters.bodies == 5 + 3 * 275 && counters.joints == 3 * 250);
	if (TEST_FORM(1, 1, 0)) {
		for (int32_t i = 24; i < 340; ++i) {
			scene_before_step(&run); /* no physics needed to count */
			++run.step_index;
		}
		CHECK(run.result == CN_OK);
		cn_world_get_counters(run.world, &counters);
		CHECK(counters.bodies == 5 + 40 * 275 && counters.joints == 40 * 250);
	}
	scene_close(&run);
}

static void t_coordinates_do_not_drift(void)
{
	scene_run run;
	measure_start start;
	REQUIRE(scene_open(&run, scene_find("many_pyramids"), NULL) == CN_OK);
	CHECK(measure_start_open(&start, run.world));
	CHECK(start.count == 22001);
	/* last box: top of the last pyramid: i = 9, centre 100, x = 5 + 100 - 0.5; y = 9.5 + 209 */
	CHECK_LE("x error of the last box", fabs((double)start.poses[22000].position_m.x - 104.5), 0.0, "m");
	CHECK_LE("y error of the last box", fabs((double)start.poses[22000].position_m.y - 218.5), 0.0, "m");
	CHECK_LE("displacement at the start", measure_displacement(&start, run.world), 0.0, "m");
	CHECK(measure_bodies_left(run.world, &run.scene->bounds_m) == 0);
	measure_start_close(&start);
	scene_close(&run);
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(t_scenes_have_what_they_promise);
	RUN(t_coordinates_do_not_drift);
	RUN(t_rain_makes_and_destroys);
	RUN(t_demo_scenes_repeat_bit_for_bit);
	return test_end();
}
