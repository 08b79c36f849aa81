/* examples/testbed/breakable_wall.c - the world of examples/breakable_wall.c as a scene of the testbed. */
#define main breakable_wall_example_main
#include "../breakable_wall.c"
#undef main
#include "scenes/build.h"
#include "testbed/entries.h"

static void create(scene_run *run)
{
	cn_body bricks[ROWS][COLUMNS];
	add_wall(run->world, add_brick(run->world, CN_BODY_STATIC, 0.0f, -1.0f, 30.0f, 1.0f), bricks);
}

static void step(scene_run *run, int32_t step_index)
{
	if (step_index % 240 == 60)
		shoot(run->world, -4.0f, 2.6f - 0.7f * (float)(step_index / 240 % 3), 30.0f);
}

const scene entry_breakable_wall = {"breakable_wall", "A wall on joints that break", create, step, 600, 0, SCENE_SLEEP, {0.0f, -10.0f},
	{{-6.0f, -1.0f}, {8.0f, 6.0f}}, {{-74.0f, -54.0f}, {232.0f, 74.0f}}};
