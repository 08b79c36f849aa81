/* examples/testbed/platformer.c - the world of examples/platformer.c as a scene of the testbed. */
#define main platformer_example_main
#include "../platformer.c"
#undef main
#include "scenes/build.h"
#include "testbed/entries.h"

/* The character has no body: a sensor follows it, so that it is drawn. */
typedef struct game {
	hero hero;
	cn_body lift, crate, figure;
} game;

static void create(scene_run *run)
{
	game *g = (game *)scene_memory(run, sizeof *g);
	cn_shape_def sd;
	cn_body_def bd;
	if (g == NULL)
		return;
	level_make(run->world, &g->lift, &g->crate);
	hero_init(&g->hero, (cn_vec2){0.0f, 1.0f});
	cn_body_def_init(&bd);
	bd.type = CN_BODY_KINEMATIC;
	bd.position_m = g->hero.mover.position_m;
	g->figure = scene_body_with(run, &bd);
	cn_shape_def_init(&sd);
	sd.body = g->figure;
	sd.flags = CN_SHAPE_SENSOR;
	scene_capsule(run, &sd, (cn_vec2){0.0f, -0.5f}, (cn_vec2){0.0f, 0.5f}, 0.3f);
}

static void step(scene_run *run, int32_t step_index)
{
	game *g = (game *)run->memory;
	cn_pose lift;
	cn_body_get_pose(run->world, g->lift, &lift);
	hero_update(run->world, &g->hero, play(&g->hero, lift.position_m.x));
	cn_vec2 at = g->hero.mover.position_m;
	cn_body_set_target_pose(run->world, g->figure, at.x, at.y, 0.0f, DT);
	cn_body_set_velocity(run->world, g->lift, step_index / 264 % 2 ? -2.0f : 2.0f, 0.0f, 0.0f);
}

const scene entry_platformer = {"platformer", "A character plays a level by itself", create, step, 600, 0, SCENE_SLEEP, {0.0f, -10.0f},
	{{-4.0f, -4.0f}, {53.0f, 9.0f}}, {{-66.0f, -66.0f}, {412.0f, 86.0f}}};
