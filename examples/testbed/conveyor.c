/* examples/testbed/conveyor.c - the world of examples/conveyor.c as a scene of the testbed. */
#define main conveyor_example_main
#include "../conveyor.c"
#undef main
#include "scenes/build.h"
#include "testbed/entries.h"

static void create(scene_run *run)
{
	const float slope_rad = 0.3f, c = scene_cosine(0.3), s = scene_sine(0.3);
	cn_world *world = run->world;
	add_box(world, CN_BODY_STATIC, (cn_vec2){-5.0f, -0.25f}, 0.0f, (cn_vec2){5.0f, 0.25f}, BELT_MPS, 0);
	add_box(world, CN_BODY_STATIC, (cn_vec2){5.0f * c + 0.25f * s, 5.0f * s - 0.25f * c}, slope_rad, (cn_vec2){5.0f, 0.25f}, BELT_MPS, 0);
	add_box(world, CN_BODY_STATIC, (cn_vec2){14.0f, -4.25f}, 0.0f, (cn_vec2){8.0f, 0.25f}, 0.0f, 0);
}

static void step(scene_run *run, int32_t step_index)
{
	if (step_index % 75 == 0 && step_index < 9000)
		add_box(run->world, CN_BODY_DYNAMIC, (cn_vec2){-9.0f, 0.3f}, 0.0f, (cn_vec2){0.3f, 0.3f}, 0.0f, 0);
}

const scene entry_conveyor = {"conveyor", "Crates on two belts", create, step, 600, 0, SCENE_SLEEP, {0.0f, -10.0f},
	{{-12.0f, -5.0f}, {22.0f, 8.0f}}, {{-98.0f, -70.0f}, {288.0f, 82.0f}}};
