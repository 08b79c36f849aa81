/*
 * test/examples/testbed_test.c - the testbed without a window: the bits of the library's own run, pause, step, reset, drags, camera,
 * settings, and every scene in it runs.
 */
#include "testbed/testbed.h"
#include "test.h"
#include <inttypes.h>

static testbed bed;

static int32_t open_scene(const char *name)
{
	int32_t entry = testbed_find(name);
	if (entry < 0 || !testbed_open(&bed, 640, 400))
		return 0;
	testbed_select(&bed, entry);
	return bed.run.world != NULL && bed.run.result == CN_OK;
}

static void frames(int32_t count)
{
	for (int32_t i = 0; i < count; ++i)
		testbed_frame(&bed, 1.0 / 60.0);
}

static uint64_t own_run(const char *name, int32_t steps)
{
	scene_run run;
	uint64_t hash = 0;
	if (scene_open(&run, scene_find(name), NULL) != CN_OK)
		return 0;
	for (int32_t i = 0; i < steps; ++i)
		scene_step(&run);
	cn_world_hash(run.world, &hash);
	scene_close(&run);
	return hash;
}

/* Presses and releases a widget of the panel, with the frames in between. */
static int32_t click(const char *name)
{
	for (int32_t i = 0; i < bed.widget_count; ++i) {
		const testbed_widget *w = &bed.widgets[i];
		if (strcmp(w->name, name) != 0)
			continue;
		float x = w->x + 0.5f * w->width, y = w->y + 0.5f * w->height;
		testbed_event(&bed, TESTBED_PRESS, x, y, 0);
		testbed_frame(&bed, 0.0);
		testbed_event(&bed, TESTBED_RELEASE, x, y, 0);
		testbed_frame(&bed, 0.0);
		return 1;
	}
	return 0;
}

static canvas_point on_picture(cn_vec2 at)
{
	canvas_point p = {(at.x - bed.view.lower_m.x) * bed.view.scale, (float)bed.canvas.height - (at.y - bed.view.lower_m.y) * bed.view.scale};
	return p;
}

static void t_the_bits_are_those_of_the_library(void)
{
	static const char *const names[3] = {"machines", "dominoes", "ragdolls"};
	for (int32_t i = 0; i < 3; ++i) {
		REQUIRE(open_scene(names[i]));
		bed.show |= DRAW_SHOW_CONTACTS | DRAW_SHOW_BOXES | DRAW_SHOW_TIERS;
		frames(20);
		CHECK(bed.run.step_index == 20);
		CHECK(testbed_hash(&bed) == own_run(names[i], 20));
		testbed_close(&bed);
	}
}

static void t_pause_step_reset(void)
{
	REQUIRE(open_scene("dominoes"));
	frames(30);
	REQUIRE(click("pause"));
	uint64_t paused = testbed_hash(&bed);
	frames(20);
	CHECK(bed.paused && testbed_hash(&bed) == paused && bed.run.step_index == 30);
	REQUIRE(click("step"));
	CHECK(bed.run.step_index == 31 && testbed_hash(&bed) == own_run("dominoes", 31));
	REQUIRE(click("reset"));
	CHECK(bed.run.step_index == 0 && testbed_hash(&bed) == own_run("dominoes", 0));
	testbed_event(&bed, TESTBED_KEY, 0.0f, 0.0f, ' ');
	frames(31);
	CHECK(testbed_hash(&bed) == own_run("dominoes", 31));
	testbed_close(&bed);
}

/* The last ball of the rope follows the pointer, and hangs again when it is let go. */
static void t_drag(void)
{
	REQUIRE(open_scene("mouse"));
	frames(2);
	canvas_point end = on_picture((cn_vec2){5.0f, -3.2f}), aim = on_picture((cn_vec2){6.5f, -2.0f});
	cn_vec2 at;
	cn_body body = 0;
	testbed_event(&bed, TESTBED_PRESS, end.x, end.y, 0);
	REQUIRE(bed.holds == TESTBED_HOLDS_BODY);
	cn_joint_get_bodies(bed.run.world, bed.drag, &(cn_body){0}, &body);
	testbed_event(&bed, TESTBED_MOVE, aim.x, aim.y, 0);
	frames(90);
	cn_body_get_center(bed.run.world, body, &at);
	CHECK_LE("off the pointer", hypotf(at.x - 6.5f, at.y + 2.0f), 0.1, "m");
	testbed_event(&bed, TESTBED_RELEASE, aim.x, aim.y, 0);
	CHECK(bed.drag == 0 && bed.holds == TESTBED_HOLDS_NOTHING);
	frames(30);
	cn_body_get_center(bed.run.world, body, &at);
	CHECK_GE("away from the pointer when let go", hypotf(at.x - 6.5f, at.y + 2.0f), 0.05, "m");
	testbed_close(&bed);
}

static void t_camera(void)
{
	REQUIRE(open_scene("machines"));
	frames(1);
	uint64_t before = testbed_hash(&bed);
	cn_vec2 lower = bed.view.lower_m;
	canvas_point empty = on_picture((cn_vec2){0.0f, 20.0f});
	testbed_event(&bed, TESTBED_PRESS, empty.x, 2.0f, 0);
	CHECK(bed.holds == TESTBED_HOLDS_CAMERA);
	testbed_event(&bed, TESTBED_MOVE, empty.x + 50.0f, 2.0f, 0);
	testbed_event(&bed, TESTBED_RELEASE, empty.x + 50.0f, 2.0f, 0);
	CHECK_LE("the view moved with the pointer", fabsf(lower.x - bed.view.lower_m.x - 50.0f / bed.view.scale), 1e-4, "m");
	canvas_point here = {200.0f, 150.0f};
	float x = bed.view.lower_m.x + here.x / bed.view.scale;
	testbed_event(&bed, TESTBED_WHEEL, here.x, here.y, 3);
	CHECK_LE("the point under the wheel stays", fabsf(x - bed.view.lower_m.x - here.x / bed.view.scale), 1e-4, "m");
	CHECK(testbed_hash(&bed) == before);
	testbed_close(&bed);
}

static void t_settings_reach_the_world(void)
{
	int32_t substeps = 0, solver = 0, budget;
	float accuracy_m = 0.0f;
	cn_vec2 gravity;
	REQUIRE(open_scene("pyramid"));
	frames(1);
	REQUIRE(click("soft") && click("substeps") && click("accuracy") && click("gravity"));
	cn_world_get_solver(bed.run.world, &solver);
	cn_world_get_substep_count(bed.run.world, &substeps);
	cn_world_get_accuracy(bed.run.world, &accuracy_m, &budget);
	cn_world_get_gravity(bed.run.world, &gravity);
	CHECK(solver == CN_SOLVER_SOFT && substeps == 9 && accuracy_m == 5e-3f && gravity.y == -10.0f);
	testbed_event(&bed, TESTBED_KEY, 0.0f, 0.0f, '+');
	cn_world_get_substep_count(bed.run.world, &substeps);
	CHECK(substeps == 10);
	testbed_close(&bed);
}

/* Each scene opens, steps and is drawn in every way: a picture is not all background. */
static void t_every_scene_runs(void)
{
	int32_t drawn = 0;
	REQUIRE(testbed_open(&bed, 700, 420));
	for (int32_t i = 0; i < testbed_count(); ++i) {
		const scene *which = testbed_at(i).scene;
		if (which->flags & SCENE_BENCH && which->size >= 100)
			continue; /* large ones of the benchmark: test/examples/scenes_test.c */
		testbed_select(&bed, i);
		bed.show ^= DRAW_SHOW_ISLANDS | DRAW_SHOW_CONTACTS;
		frames(2);
		if (bed.run.result != CN_OK || bed.run.step_index != 2)
			printf("  %s: %s\n", which->name, bed.run.error_text);
		CHECK(bed.run.result == CN_OK && bed.run.step_index == 2);
		for (int32_t k = 0; k < 450 * 420; ++k) {
			const uint8_t *pixel = bed.canvas.rgb + 3 * (k / 450 * 700 + k % 450);
			drawn += pixel[2] != (draw_colors[DRAW_BACKGROUND] & 255u);
		}
	}
	CHECK_GE("pixels drawn", drawn, 100000, "");
	testbed_close(&bed);
}

/* What testbed_web.js does in a browser, with the hashes that it must get: test/examples/testbed_web.sh. */
static void t_browser(void)
{
	REQUIRE(testbed_open(&bed, 1280, 760));
	testbed_select(&bed, testbed_find("dominoes"));
	frames(60);
	printf("run %016" PRIx64 "\n", testbed_hash(&bed));
	testbed_step(&bed);
	printf("step %016" PRIx64 "\n", testbed_hash(&bed));
	testbed_select(&bed, bed.entry);
	printf("reset %016" PRIx64 "\n", testbed_hash(&bed));
	testbed_select(&bed, testbed_find("mouse"));
	frames(2);
	testbed_event(&bed, TESTBED_PRESS, 786.0f, 572.0f, 0);
	REQUIRE(bed.holds == TESTBED_HOLDS_BODY);
	testbed_event(&bed, TESTBED_MOVE, 900.0f, 400.0f, 0);
	frames(60);
	printf("drag %016" PRIx64 "\n", testbed_hash(&bed));
	testbed_event(&bed, TESTBED_RELEASE, 900.0f, 400.0f, 0);
	frames(20);
	printf("release %016" PRIx64 "\n", testbed_hash(&bed));
	testbed_close(&bed);
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(t_the_bits_are_those_of_the_library);
	RUN(t_pause_step_reset);
	RUN(t_drag);
	RUN(t_camera);
	RUN(t_settings_reach_the_world);
	RUN(t_every_scene_runs);
	RUN_WHEN_NAMED(t_browser);
	return test_end();
}
