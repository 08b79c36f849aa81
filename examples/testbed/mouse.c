/* examples/testbed/mouse.c - the world of examples/mouse.c as a scene of the testbed, calm and in gusts of wind. */
#define main mouse_example_main
#include "../mouse.c"
#undef main
#include "scenes/build.h"
#include "testbed/entries.h"

static void create(scene_run *run)
{
	cn_body cloth[ROWS][COLUMNS], end = 0;
	add_cloth(run->world, cloth);
	add_rope(run->world, &end);
}

const scene entry_mouse = {"mouse", "A cloth and a rope to drag", create, NULL, 600, 0, SCENE_SLEEP, {0.0f, -10.0f},
	{{-1.0f, -4.5f}, {7.0f, 1.0f}}, {{-54.0f, -68.0f}, {228.0f, 54.0f}}};

#define SHAPES_MAX 256

/* In gusts of 3 s; at 1.5 m/s a thread hangs at 45 degrees. */
static void blow(scene_run *run, int32_t step_index)
{
	cn_shape shapes[SHAPES_MAX];
	int32_t count = 0;
	float gust_mps = 1.1f + 0.9f * scene_sine(6.2831853 * step_index / 180.0);
	cn_world_get_shapes(run->world, shapes, SHAPES_MAX, &count);
	for (int32_t k = 0; k < count && k < SHAPES_MAX; ++k)
		cn_shape_apply_wind(run->world, shapes[k], gust_mps, 0.0f, 1.2f, 0.0f, SCENE_STEP_S, 1);
}

const scene entry_wind = {"wind", "The cloth and the rope in gusts of wind", create, blow, 600, 0, SCENE_SLEEP, {0.0f, -10.0f},
	{{-1.0f, -4.5f}, {7.0f, 1.0f}}, {{-54.0f, -68.0f}, {228.0f, 54.0f}}};
