/* examples/testbed/areas.c - the world of examples/areas.c as a scene of the testbed, with more to throw into it. */
#define main areas_example_main
#include "../areas.c"
#undef main
#include "scenes/build.h"
#include "testbed/entries.h"

static void create(scene_run *run)
{
	cn_world *world = run->world;
	add_pool(world);
	add_box(world, 0.0f, 0.0f, 2.0f, 0.5f, 200.0f);
	add_box(world, -1.0f, 1.0f, 0.5f, 0.5f, 500.0f);
	add_box(world, 1.0f, 1.0f, 0.5f, 0.5f, 500.0f);
	for (int32_t k = 0; k < 6; ++k) /* from cork to stone */
		add_box(world, -8.5f + 0.9f * (float)k, 4.0f + (float)k, 0.4f, 0.4f, 150.0f + 250.0f * (float)k);
	add_fan(world, 14.0f);
	add_ball(world, 14.0f, 2.0f, 0.4f, 3.0f);
	add_ball(world, 13.2f, 4.0f, 0.3f, 3.0f);
	add_planet(world, 50.0f, 6.0f);
	for (int32_t k = 0; k < 3; ++k) {
		cn_body moon = add_ball(world, 60.0f + 4.0f * (float)k, 6.0f, 0.5f, 1.0f);
		cn_body_set_velocity(world, moon, 0.0f, sqrtf(250.0f / (10.0f + 4.0f * (float)k)), 0.0f);
	}
}

const scene entry_areas = {"areas", "A pool, a fan, a planet with moons", create, NULL, 600, 0, SCENE_SLEEP, {0.0f, -10.0f},
	{{-12.0f, -16.0f}, {80.0f, 38.0f}}, {{-98.0f, -98.0f}, {140.0f, 98.0f}}};
