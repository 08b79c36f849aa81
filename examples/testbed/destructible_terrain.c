/* examples/testbed/destructible_terrain.c - the world of examples/destructible_terrain.c as a scene of the testbed. */
#define main destructible_terrain_example_main
#include "../destructible_terrain.c"
#undef main
#include "scenes/build.h"
#include "testbed/entries.h"

static void create(scene_run *run)
{
	terrain *ground = (terrain *)scene_memory(run, sizeof *ground);
	if (ground == NULL)
		return;
	terrain_create(ground, run->world);
	for (int i = 0; i < 24; ++i)
		add_ball(run->world, 1.0f + 0.8f * (float)i, 0.4f + 0.7f * (float)(i % 3), 0.0f);
}

static void step(scene_run *run, int32_t step_index)
{
	if (step_index % 90 == 60)
		terrain_explode((terrain *)run->memory, 2.0f + (float)(step_index / 90 * 7 % 17), -0.5f * (float)(step_index / 540), 1.3f);
}

const scene entry_destructible_terrain = {"destructible_terrain", "Ground that explosions dig away", create, step, 600, 0, SCENE_SLEEP, {0.0f, -10.0f},
	{{-2.0f, -5.0f}, {22.0f, 5.0f}}, {{-58.0f, -70.0f}, {288.0f, 70.0f}}};
