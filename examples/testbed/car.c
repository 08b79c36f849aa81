/* examples/testbed/car.c - the world of examples/car.c as a scene of the testbed. */
#define main car_example_main
#include "../car.c"
#undef main
#include "scenes/build.h"
#include "testbed/entries.h"

static void create(scene_run *run)
{
	car *c = (car *)scene_memory(run, sizeof *c);
	if (c == NULL)
		return;
	add_hills(run->world);
	*c = add_car(run->world, -5.0f, 1.0f);
	run->focus = c->chassis;
}

static void step(scene_run *run, int32_t step_index)
{
	(void)step_index;
	drive(run->world, (const car *)run->memory, 1.0f);
}

const scene entry_car = {"car", "A car over hills", create, step, 600, 0, SCENE_SLEEP, {0.0f, -10.0f},
	{{-12.0f, -5.0f}, {12.0f, 8.0f}}, {{-98.0f, -70.0f}, {248.0f, 82.0f}}};
