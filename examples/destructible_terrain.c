/* examples/destructible_terrain.c - ground of square cells that explosions dig away. Each row's neighbouring cells are one box; a change
   replaces the boxes of the rows that it touches. Balls roll over the boxes' seams as over one surface, and fall into the crater. */
#include "cairn.h"
#include <math.h>
#include <stdio.h>

#define COLUMNS 80
#define ROWS 16
#define CELL 0.25f

typedef struct terrain {
	cn_world *world;
	cn_body body;
	int solid[ROWS][COLUMNS];
	cn_shape shapes[ROWS][COLUMNS];
	int counts[ROWS];
} terrain;

/* Replaces the boxes of a row by those of its cells. */
static void terrain_build_row(terrain *t, int row)
{
	for (int i = 0; i < t->counts[row]; ++i)
		cn_shape_destroy(t->world, t->shapes[row][i]);
	t->counts[row] = 0;
	for (int from = 0; from < COLUMNS; ++from) {
		int to = from;
		while (to < COLUMNS && t->solid[row][to])
			++to;
		if (to == from)
			continue;
		cn_shape_def def;
		cn_shape_def_init(&def);
		def.body = t->body;
		def.offset_m = (cn_vec2){ 0.5f * CELL * (float)(from + to), -CELL * ((float)row + 0.5f) };
		cn_shape_create_box(t->world, &def, 0.5f * CELL * (float)(to - from), 0.5f * CELL, 0.0f, &t->shapes[row][t->counts[row]++]);
		from = to;
	}
}

static void terrain_create(terrain *t, cn_world *world)
{
	cn_body_def def;
	cn_body_def_init(&def);
	def.type = CN_BODY_STATIC;
	t->world = world;
	cn_body_create(world, &def, &t->body);
	for (int row = 0; row < ROWS; ++row) {
		t->counts[row] = 0;
		for (int k = 0; k < COLUMNS; ++k)
			t->solid[row][k] = 1;
		terrain_build_row(t, row);
	}
}

/* Removes the cells within a radius and pushes what is near. Returns their number. */
static int terrain_explode(terrain *t, float x, float y, float radius)
{
	int removed = 0;
	for (int row = 0; row < ROWS; ++row) {
		int changed = 0;
		for (int k = 0; k < COLUMNS; ++k) {
			const float dx = CELL * ((float)k + 0.5f) - x, dy = -CELL * ((float)row + 0.5f) - y;
			if (t->solid[row][k] && dx * dx + dy * dy < radius * radius)
				t->solid[row][k] = 0, ++changed;
		}
		removed += changed;
		if (changed > 0)
			terrain_build_row(t, row);
	}
	cn_explosion_def def;
	cn_explosion_def_init(&def);
	def.center_m = (cn_vec2){ x, y };
	def.radius_m = radius;
	def.falloff_m = 2.0f * radius;
	def.impulse_Nspm = 2.0f;
	cn_world_explode(t->world, &def);
	return removed;
}

static cn_body add_ball(cn_world *world, float x, float y, float speed_mps)
{
	const cn_circle circle = { { 0.0f, 0.0f }, 0.3f };
	cn_body_def body_def;
	cn_shape_def shape_def;
	cn_body ball = 0;
	cn_body_def_init(&body_def);
	body_def.position_m = (cn_vec2){ x, y };
	body_def.linear_velocity_mps.x = speed_mps;
	cn_body_create(world, &body_def, &ball);
	cn_shape_def_init(&shape_def);
	shape_def.body = ball;
	cn_shape_create_circle(world, &shape_def, &circle, NULL);
	return ball;
}

int main(void)
{
	static terrain ground;
	cn_world_def world_def;
	cn_world *world;
	cn_vec2 at;
	float bump = 0.0f;
	cn_world_def_init(&world_def);
	if (cn_world_create(&world_def, &world) != CN_OK)
		return 1;
	terrain_create(&ground, world);
	const cn_body roller = add_ball(world, 1.0f, 0.3f, 3.0f), sleeper = add_ball(world, 15.0f, 0.3f, 0.0f);
	const int removed = terrain_explode(&ground, 15.0f, 0.0f, 1.6f);
	for (int step = 0; step < 480; ++step) {
		cn_world_step(world, 1.0f / 60.0f);
		cn_body_get_center(world, roller, &at);
		if (at.x < 12.0f)
			bump = fmaxf(bump, fabsf(at.y - 0.3f));
	}
	cn_vec2 other;
	cn_body_get_center(world, sleeper, &other);
	printf("%d cells removed; the rolling ball was %.2f mm off the level ground and lies at (%.1f, %.1f); the other at (%.1f, %.1f)\n",
		removed, 1000.0 * (double)bump, (double)at.x, (double)at.y, (double)other.x, (double)other.y);
	cn_world_destroy(world);
	return !(removed > 50 && bump < 0.001f && at.y < -0.5f);
}
