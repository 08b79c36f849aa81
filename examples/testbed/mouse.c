/* examples/testbed/mouse.c - the world of examples/mouse.c as a scene of the testbed. */
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
