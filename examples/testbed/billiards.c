/* examples/testbed/billiards.c - the world of examples/billiards.c as a scene of the testbed. */
#define main billiards_example_main
#include "../billiards.c"
#undef main
#include "scenes/build.h"
#include "testbed/entries.h"

static void create(scene_run *run)
{
	add_table(run->world);
	for (int row = 0; row < 5; ++row) {
		for (int k = 0; k <= row; ++k)
			add_ball(run->world, 0.6f + 1.7321f * RADIUS * (float)row, RADIUS * (float)(2 * k - row));
	}
	scene_check(run, cn_body_set_velocity(run->world, add_ball(run->world, -0.6f, 0.004f), 9.0f, 0.0f, 0.0f));
}

static void step(scene_run *run, int32_t step_index)
{
	(void)step_index;
	take_potted(run->world);
}

const scene entry_billiards = {"billiards", "A break shot from above", create, step, 600, 0, SCENE_SLEEP, {0.0f, 0.0f},
	{{-1.4f, -0.75f}, {1.4f, 0.75f}}, {{-55.6f, -53.0f}, {205.6f, 53.0f}}};
