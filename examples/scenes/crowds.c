/*
 * examples/scenes/crowds.c - crowds in a pit: bodies of every kind of shape, and bodies of several shapes each.
 */
#include "scenes/build.h"

/* Floor and two walls of boxes; the inside is from -half_m to half_m and up to height_m. */
static void add_pit(scene_run *run, float half_m, float height_m)
{
	cn_shape_def ground = scene_surface(scene_body(run, CN_BODY_STATIC, 0.0f, 0.0f), 1.0f, 0.5f, 0.0f);
	scene_offset_box(run, &ground, scene_vec(0.0f, -0.5f), half_m + 1.0f, 0.5f);
	scene_offset_box(run, &ground, scene_vec(-half_m - 0.5f, 0.5f * height_m), 0.5f, 0.5f * height_m);
	scene_offset_box(run, &ground, scene_vec(half_m + 0.5f, 0.5f * height_m), 0.5f, 0.5f * height_m);
}

/* A body of row i / row_length, turned by its number; every second row is shifted. */
static cn_body add_body(scene_run *run, int32_t i, int32_t row_length, float spacing_m)
{
	cn_body_def def;
	int32_t row = i / row_length;
	cn_body_def_init(&def);
	def.position_m.x = spacing_m * ((float)(i % row_length) - 0.5f * (float)row_length + (row % 2 == 0 ? 0.4f : 0.6f));
	def.position_m.y = spacing_m * ((float)row + 1.0f);
	def.angle_rad = 0.37f * (float)(i % 17);
	return scene_body_with(run, &def);
}

/* Circles, capsules, boxes, pentagons and hexagons in turn, in four sizes. */
void scene_create_junkyard(scene_run *run)
{
	add_pit(run, 22.0f, 60.0f);
	for (int32_t i = 0; i < run->scene->size; ++i) {
		float size = 0.25f + 0.05f * (float)(i % 4);
		cn_shape_def def = scene_surface(add_body(run, i, 50, 0.85f), 1.0f, 0.5f, 0.1f);
		switch (i % 5) {
		case 0: scene_circle(run, &def, size); break;
		case 1: scene_capsule(run, &def, scene_vec(-0.6f * size, 0.0f), scene_vec(0.6f * size, 0.0f), 0.6f * size); break;
		case 2: scene_box(run, &def, size, 0.7f * size, 0.0f); break;
		case 3: scene_regular_polygon(run, &def, 5, size); break;
		default: scene_regular_polygon(run, &def, 6, size); break;
		}
	}
}

/* Squares of half 0.2 m side by side: bit 3 * row + column, three rows of three. */
static void add_squares(scene_run *run, const cn_shape_def *def, uint32_t cells)
{
	for (int32_t k = 0; k < 9; ++k) {
		if (cells >> k & 1u)
			scene_offset_box(run, def, scene_vec(0.4f * (float)(k % 3 - 1), 0.4f * (float)(k / 3 - 1)), 0.2f, 0.2f);
	}
}

/* Crosses of five squares, cups of seven, and dumbbells of a capsule and two circles, in turn. */
void scene_create_compounds(scene_run *run)
{
	add_pit(run, 22.0f, 60.0f);
	for (int32_t i = 0; i < run->scene->size; ++i) {
		cn_shape_def def = scene_surface(add_body(run, i, 28, 1.5f), 1.0f, 0.5f, 0.0f), end = def;
		if (i % 3 == 0) {
			add_squares(run, &def, 0272u);
		} else if (i % 3 == 1) {
			add_squares(run, &def, 0557u);
		} else {
			scene_capsule(run, &def, scene_vec(-0.4f, 0.0f), scene_vec(0.4f, 0.0f), 0.1f);
			end.offset_m = scene_vec(-0.5f, 0.0f);
			scene_circle(run, &end, 0.2f);
			end.offset_m = scene_vec(0.5f, 0.0f);
			scene_circle(run, &end, 0.2f);
		}
	}
}
