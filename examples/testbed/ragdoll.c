/* examples/testbed/ragdoll.c - the world of examples/ragdoll.c as a scene of the testbed. */
#define main ragdoll_example_main
#include "../ragdoll.c"
#undef main
#include "scenes/build.h"
#include "testbed/entries.h"

static void create(scene_run *run)
{
	cn_body body[BONES];
	cn_joint joint[BONES] = {0};
	add_stair(run->world);
	add_ragdoll(run->world, -0.6f, 0.02f, body, joint);
	for (int i = 0; i < BONES; ++i)
		scene_check(run, cn_body_set_velocity(run->world, body[i], 2.5f * bones[i].top_y, 0.0f, 0.0f));
}

const scene entry_ragdoll = {"ragdoll", "A ragdoll on a stair", create, NULL, 600, 0, SCENE_SLEEP, {0.0f, -10.0f},
	{{-4.0f, -4.0f}, {9.0f, 4.0f}}, {{-66.0f, -66.0f}, {236.0f, 66.0f}}};
