/*
 * examples/scenes/drums.c - bodies that are kept moving: boxes in a turning drum, mixed shapes in a
 * ring with a driven arm, and a brick that smashes into a wall of sleeping boxes.
 */
#include "scenes/build.h"

/* ------------------------------------------------------------------ tumblers */

/* A hollow square, its inner faces inner_m from the centre at (0, 10), turned by a motor. */
static void add_drum(scene_run *run, float inner_m)
{
	const float wall = 0.5f;
	cn_body drum = scene_body(run, CN_BODY_DYNAMIC, 0.0f, 10.0f);
	cn_shape_def def = scene_surface(drum, 50.0f, 0.6f, 0.0f);
	scene_offset_box(run, &def, scene_vec(inner_m + wall, 0.0f), wall, inner_m);
	scene_offset_box(run, &def, scene_vec(-inner_m - wall, 0.0f), wall, inner_m);
	scene_offset_box(run, &def, scene_vec(0.0f, inner_m + wall), inner_m, wall);
	scene_offset_box(run, &def, scene_vec(0.0f, -inner_m - wall), inner_m, wall);
	scene_join_motor(run, 0, scene_vec(0.0f, 10.0f), drum, scene_vec(0.0f, 0.0f), 25.0f * SCENE_PI / 180.0f, 1.0e8f);
}

void scene_create_tumbler(scene_run *run)
{
	int32_t side = run->scene->size;
	add_drum(run, 10.0f);
	for (int32_t i = 0; i < side; ++i) {
		for (int32_t j = 0; j < side; ++j)
			scene_simple_box(run, -9.0f + 0.4f * (float)j, 1.0f + 0.4f * (float)i, 0.125f, 0.125f);
	}
}

/* Fewer and larger boxes, for pictures. */
void scene_create_small_tumbler(scene_run *run)
{
	add_drum(run, 10.0f);
	for (int32_t i = 0; i < run->scene->size; ++i)
		scene_simple_box(run, -8.775f + 0.45f * (float)(i % 40), 1.0f + 0.45f * (float)(i / 40), 0.2f, 0.2f);
}

/* ------------------------------------------------------------------ spinner and mixer */

#define RING_MAX 360

/* A loop that collides on its inside: its points run clockwise. */
static void add_ring(scene_run *run, cn_vec2 center_m, float radius_m, int32_t count)
{
	cn_vec2 points[RING_MAX];
	for (int32_t i = 0; i < count; ++i) {
		double angle = -2.0 * 3.14159265358979323846 * (double)i / (double)count;
		points[i] = scene_vec(center_m.x + radius_m * scene_cosine(angle), center_m.y + radius_m * scene_sine(angle));
	}
	cn_shape_def def = scene_surface(scene_body(run, CN_BODY_STATIC, 0.0f, 0.0f), 1.0f, 0.1f, 0.0f);
	scene_chain(run, &def, points, count, 1);
}

static void add_arm(scene_run *run, cn_vec2 center_m, float half_width_m, float half_length_m, float radius_m, float speed_radps)
{
	cn_body_def body_def;
	cn_body_def_init(&body_def);
	body_def.position_m = center_m;
	body_def.flags &= ~(uint32_t)CN_BODY_SLEEP;
	cn_body arm = scene_body_with(run, &body_def);
	cn_shape_def def = scene_surface(arm, 1.0f, 0.0f, 0.0f);
	scene_box(run, &def, half_width_m, half_length_m, radius_m);
	scene_join_motor(run, 0, center_m, arm, scene_vec(0.0f, 0.0f), speed_radps, 1.0e30f);
}

/* A capsule, a circle and a square in turn. */
static void add_mixed(scene_run *run, int32_t i, float x_m, float y_m, float scale)
{
	cn_body body = scene_body(run, CN_BODY_DYNAMIC, x_m, y_m);
	cn_shape_def def = scene_surface(body, 0.25f, 0.1f, 0.1f);
	if (i % 3 == 0)
		scene_capsule(run, &def, scene_vec(-0.25f * scale, 0.0f), scene_vec(0.25f * scale, 0.0f), 0.25f * scale);
	else if (i % 3 == 1)
		scene_circle(run, &def, 0.35f * scale);
	else
		scene_box(run, &def, 0.35f * scale, 0.35f * scale, 0.0f);
}

void scene_create_spinner(scene_run *run)
{
	float x = -23.0f, y = 2.0f;
	add_ring(run, scene_vec(0.0f, 32.0f), 40.0f, RING_MAX);
	add_arm(run, scene_vec(0.0f, 12.0f), 0.4f, 20.0f, 0.2f, 5.0f);
	for (int32_t i = 0; i < run->scene->size; ++i) {
		add_mixed(run, i, x, y, 1.0f);
		x += 0.5f;
		if (x >= 23.0f) {
			x = -23.0f;
			y += 0.5f;
		}
	}
}

/* The spinner at the size of a picture. */
void scene_create_mixer(scene_run *run)
{
	int32_t made = 0;
	add_ring(run, scene_vec(0.0f, 0.0f), 10.0f, 120);
	add_arm(run, scene_vec(0.0f, -4.5f), 0.2f, 4.7f, 0.1f, 3.0f);
	for (int32_t i = 0; made < run->scene->size && i < 1000; ++i) {
		float x = -8.4f + 0.6f * (float)(i % 29), y = 0.9f + 0.6f * (float)(i / 29);
		if (x * x + y * y < 9.2f * 9.2f)
			add_mixed(run, made++, x, y, 0.8f);
	}
}

/* ------------------------------------------------------------------ smash */

void scene_create_smash(scene_run *run)
{
	cn_body_def body_def;
	cn_body_def_init(&body_def);
	body_def.position_m = scene_vec(-20.0f, 0.0f);
	body_def.linear_velocity_mps = scene_vec(40.0f, 0.0f);
	cn_shape_def brick = scene_surface(scene_body_with(run, &body_def), 8.0f, 0.6f, 0.0f);
	scene_box(run, &brick, 4.0f, 4.0f, 0.0f);
	body_def.linear_velocity_mps = scene_vec(0.0f, 0.0f);
	body_def.flags &= ~(uint32_t)CN_BODY_AWAKE;
	for (int32_t i = 0; i < run->scene->size; ++i) {
		for (int32_t j = 0; j < 80; ++j) {
			body_def.position_m = scene_vec(30.0f + 0.4f * (float)i, 0.4f * (float)(j - 40));
			cn_shape_def def = scene_surface(scene_body_with(run, &body_def), 1.0f, 0.6f, 0.0f);
			scene_box(run, &def, 0.2f, 0.2f, 0.0f);
		}
	}
}
