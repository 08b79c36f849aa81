/*
 * examples/scenes/build.h - words that the scene files share. The first failing call is kept in the
 * run and everything after it does nothing, so that scenes need no error handling of their own.
 */
#ifndef CAIRN_SCENES_BUILD_H
#define CAIRN_SCENES_BUILD_H

#include "scenes/scenes.h"

#define SCENE_PI 3.14159265f

static inline cn_vec2 scene_vec(float x, float y)
{
	cn_vec2 v;
	v.x = x;
	v.y = y;
	return v;
}

/* Keeps the first failure. 1 when all is well so far. */
int32_t scene_check(scene_run *run, cn_result result);
/* Frees itself in scene_close, zeroed; NULL (and a failed run) when there is none. Once a run. */
void *scene_memory(scene_run *run, uint64_t bytes);

/* The same bits everywhere: power series in double, rounded once. |angle| <= 1000. */
float scene_sine(double angle_rad);
float scene_cosine(double angle_rad);

/* A body without shapes, of default flags. */
cn_body scene_body(scene_run *run, int32_t type, float x_m, float y_m);
cn_body scene_body_with(scene_run *run, const cn_body_def *def);
/* Definition of a shape on a body; friction counts for sticking and sliding. */
cn_shape_def scene_surface(cn_body body, float density_kgpm2, float friction, float restitution);
void scene_circle(scene_run *run, const cn_shape_def *def, float radius_m);
void scene_capsule(scene_run *run, const cn_shape_def *def, cn_vec2 a_m, cn_vec2 b_m, float radius_m);
void scene_box(scene_run *run, const cn_shape_def *def, float half_width_m, float half_height_m, float radius_m);
/* Corners on a circle around the body's origin; 3 to CN_POLYGON_MAX_VERTICES of them. */
void scene_regular_polygon(scene_run *run, const cn_shape_def *def, int32_t count, float radius_m);
/* A box away from the body's origin. */
void scene_offset_box(scene_run *run, const cn_shape_def *def, cn_vec2 center_m, float half_width_m, float half_height_m);
void scene_edge(scene_run *run, const cn_shape_def *def, cn_vec2 a_m, cn_vec2 b_m);
void scene_chain(scene_run *run, const cn_shape_def *def, const cn_vec2 *points_m, int32_t count, uint32_t loop);
/* A dynamic box of density 1 and friction 0.6. */
cn_body scene_simple_box(scene_run *run, float x_m, float y_m, float half_width_m, float half_height_m);
/* Definition of a revolute joint without limit or motor. */
cn_revolute_def scene_revolute(cn_body body_a, cn_vec2 anchor_a_m, cn_body body_b, cn_vec2 anchor_b_m);
cn_joint scene_join(scene_run *run, const cn_revolute_def *def);
/* A motor and nothing else. */
void scene_join_motor(scene_run *run, cn_body body_a, cn_vec2 anchor_a_m, cn_body body_b, cn_vec2 anchor_b_m, float speed_radps, float torque_Nm);

#define SCENE_RAGDOLL_BODIES 11
/* Eleven bodies on ten joints, standing at (x, y) (see ragdoll.c). group < 0 keeps its parts from colliding with each
   other. out gets its bodies. */
void scene_ragdoll(scene_run *run, float x_m, float y_m, int32_t group, cn_body out[SCENE_RAGDOLL_BODIES]);

/* create and step functions of the scenes; list.c says what they are for */
void scene_create_large_pyramid(scene_run *run);
void scene_create_many_pyramids(scene_run *run);
void scene_create_pyramid(scene_run *run);
void scene_create_joint_grid(scene_run *run);
void scene_create_tumbler(scene_run *run);
void scene_create_small_tumbler(scene_run *run);
void scene_create_spinner(scene_run *run);
void scene_create_mixer(scene_run *run);
void scene_create_smash(scene_run *run);
void scene_create_rain(scene_run *run);
void scene_step_rain(scene_run *run, int32_t step_index);
void scene_create_ragdolls(scene_run *run);
void scene_step_ragdolls(scene_run *run, int32_t step_index);
void scene_create_junkyard(scene_run *run);
void scene_create_compounds(scene_run *run);
void scene_create_bowl(scene_run *run);
void scene_create_bridge(scene_run *run);
void scene_create_hinges(scene_run *run);
void scene_create_dominoes(scene_run *run);
void scene_create_car(scene_run *run);
void scene_create_machines(scene_run *run);
void scene_step_machines(scene_run *run, int32_t step_index);
void scene_create_constraints(scene_run *run);
void scene_step_constraints(scene_run *run, int32_t step_index);
void scene_create_lone_boxes(scene_run *run);
void scene_create_workshop(scene_run *run);
void scene_create_empty(scene_run *run);

#endif
