/*
 * examples/scenes/piles.c - boxes at rest on each other: pyramids, many pyramids, one box alone many
 * times, and an empty world.
 */
#include "scenes/build.h"

/* A pyramid of unit boxes standing on y = floor_m: row i has its leftmost box at
   x = (i + 1) / 2 + left_m, each next one a metre to the right. */
static void add_pyramid(scene_run *run, int32_t base, float left_m, float floor_m)
{
	for (int32_t i = 0; i < base; ++i) {
		for (int32_t j = i; j < base; ++j) {
			float x = 0.5f * (float)(i + 1) + (float)(j - i) + left_m;
			scene_simple_box(run, x, (float)i + 0.5f + floor_m, 0.5f, 0.5f);
		}
	}
}

static void add_ground_box(scene_run *run, float half_width_m)
{
	cn_shape_def def = scene_surface(scene_body(run, CN_BODY_STATIC, 0.0f, -1.0f), 1.0f, 0.6f, 0.0f);
	scene_box(run, &def, half_width_m, 1.0f, 0.0f);
}

void scene_create_large_pyramid(scene_run *run)
{
	add_ground_box(run, 100.0f);
	add_pyramid(run, run->scene->size, -50.0f, 0.0f);
}

void scene_create_many_pyramids(scene_run *run)
{
	int32_t side = run->scene->size;
	cn_shape_def def = scene_surface(scene_body(run, CN_BODY_STATIC, 0.0f, 0.0f), 1.0f, 0.6f, 0.0f);
	for (int32_t i = 0; i < side; ++i) {
		float y = 11.0f * (float)i;
		scene_edge(run, &def, scene_vec(-110.0f, y), scene_vec(110.0f, y));
	}
	for (int32_t i = 0; i < side; ++i) {
		for (int32_t j = 0; j < side; ++j) {
			float center = -110.0f + 11.0f * (float)j + 1.0f;
			add_pyramid(run, 10, center - 0.5f, 11.0f * (float)i);
		}
	}
}

/* Centred on x = 0. */
void scene_create_pyramid(scene_run *run)
{
	int32_t base = run->scene->size;
	add_ground_box(run, (float)base);
	add_pyramid(run, base, -0.5f * (float)(base + 1), 0.0f);
}

/* Boxes 10 m apart in the air: what a body and its shape cost without contacts. */
void scene_create_lone_boxes(scene_run *run)
{
	for (int32_t i = 0; i < run->scene->size; ++i)
		scene_simple_box(run, 10.0f * (float)(i % 40), 10.0f * (float)(i / 40), 0.5f, 0.5f);
}

void scene_create_empty(scene_run *run) { (void)run; }
