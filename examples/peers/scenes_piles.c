/*
 * examples/peers/scenes_piles.c - free bodies at rest or falling: pyramids, a bowl, a ball pit, a wall that
 * is smashed, and a world that is mostly asleep.
 */
#include "peers/world.h"
#include <math.h>

static const double pi = 3.14159265358979323846;

/* ------------------------------------------------------------------ pyramids */

/* Unit boxes on y = floor: row i has its leftmost box at x = (i + 1) / 2 + left. */
static void add_pyramid(peer_world *world, int32_t base, float left, float floor)
{
	for (int32_t i = 0; i < base; ++i) {
		for (int32_t j = i; j < base; ++j)
			peer_simple_box(world, 0.5f * (float)(i + 1) + (float)(j - i) + left, (float)i + 0.5f + floor, 0.5f);
	}
}

void peer_large_pyramid(peer_world *world)
{
	peer_shape_def surface = peer_surface();
	peer_body ground = peer_add(world, 0, 0.0f, -1.0f);
	peer_box(world, ground, &surface, peer_at(0.0f, 0.0f), 100.0f, 1.0f, 0.0f);
	add_pyramid(world, world->scene->size, -50.0f, 0.0f);
}

void peer_many_pyramids(peer_world *world)
{
	int32_t side = world->scene->size;
	peer_shape_def surface = peer_surface();
	peer_body ground = peer_add(world, 0, 0.0f, 0.0f);
	for (int32_t i = 0; i < side; ++i)
		peer_edge(world, ground, &surface, peer_at(-110.0f, 11.0f * (float)i), peer_at(110.0f, 11.0f * (float)i));
	for (int32_t i = 0; i < side; ++i) {
		for (int32_t j = 0; j < side; ++j)
			add_pyramid(world, 10, -110.0f + 11.0f * (float)j + 0.5f, 11.0f * (float)i);
	}
}

/* ------------------------------------------------------------------ smash */

/* A heavy box at 40 m/s into a wall of touching boxes that sleep. */
void peer_smash(peer_world *world)
{
	peer_shape_def surface = peer_surface();
	peer_body_def def = {PEER_DYNAMIC, {-20.0f, 0.0f}, {40.0f, 0.0f}, 0.0f};
	surface.density = 8.0f;
	peer_body brick = peer_add_body(world, &def);
	peer_box(world, brick, &surface, peer_at(0.0f, 0.0f), 4.0f, 4.0f, 0.0f);
	surface.density = 1.0f;
	for (int32_t i = 0; i < world->scene->size; ++i) {
		for (int32_t j = 0; j < 80; ++j) {
			peer_body body = peer_add(world, PEER_DYNAMIC | PEER_ASLEEP, 30.0f + 0.4f * (float)i, 0.4f * (float)(j - 40));
			peer_box(world, body, &surface, peer_at(0.0f, 0.0f), 0.2f, 0.2f, 0.0f);
		}
	}
}

/* ------------------------------------------------------------------ bowl (the small scenes) */

static peer_vec bowl_point(int32_t i)
{
	double angle = pi * (double)i / 12.0;
	return peer_at((float)(-5.0 * cos(angle)), (float)(10.0 - 10.0 * sin(angle)));
}

/* Half an ellipse of 12 edges, 10 m wide and deep; rows of five come down, every second one shifted. */
void peer_bowl(peer_world *world)
{
	peer_shape_def surface = peer_surface();
	peer_body ground = peer_add(world, 0, 0.0f, 0.0f);
	for (int32_t i = 0; i < 12; ++i)
		peer_edge(world, ground, &surface, bowl_point(i), bowl_point(i + 1));
	for (int32_t i = 0; i < world->scene->size; ++i) {
		int32_t row = i / 5;
		float x = 0.8f * (float)(i % 5 - 2) + (row % 2 == 0 ? -0.2f : 0.2f);
		peer_body body = peer_add(world, PEER_DYNAMIC, x, 5.0f + 0.8f * (float)row);
		if (i % 3 == 0)
			peer_circle(world, body, &surface, 0.25f);
		else if (i % 3 == 1)
			peer_box(world, body, &surface, peer_at(0.0f, 0.0f), 0.25f, 0.25f, 0.0f);
		else
			peer_capsule(world, body, &surface, peer_at(-0.15f, 0.0f), peer_at(0.15f, 0.0f), 0.15f);
	}
}

/* ------------------------------------------------------------------ ball pit */

/* Circles of 0.25 fall into a pit 36 m wide: 64 in a row, 0.55 m apart, every second row shifted by 0.2 m. */
void peer_ball_pit(peer_world *world)
{
	peer_shape_def surface = peer_surface();
	peer_body pit = peer_add(world, 0, 0.0f, 0.0f);
	peer_box(world, pit, &surface, peer_at(0.0f, -1.0f), 20.0f, 1.0f, 0.0f);
	peer_box(world, pit, &surface, peer_at(-19.0f, 30.0f), 1.0f, 30.0f, 0.0f);
	peer_box(world, pit, &surface, peer_at(19.0f, 30.0f), 1.0f, 30.0f, 0.0f);
	for (int32_t i = 0; i < world->scene->size; ++i) {
		int32_t row = i / 64;
		float x = 0.55f * ((float)(i % 64) - 31.5f) + (row % 2 == 0 ? -0.1f : 0.1f);
		peer_body ball = peer_add(world, PEER_DYNAMIC, x, 1.0f + 0.55f * (float)row);
		peer_circle(world, ball, &surface, 0.25f);
	}
}

/* ------------------------------------------------------------------ mostly asleep */

/* Shelves of 500 unit boxes, 2 m apart. They stand there asleep, but one in a hundred is dropped from 2 m
   into its place and never sleeps. */
void peer_mostly_asleep(peer_world *world)
{
	peer_shape_def surface = peer_surface();
	peer_body ground = peer_add(world, 0, 0.0f, 0.0f);
	for (int32_t shelf = 0; shelf < world->scene->size / 500; ++shelf) {
		float y = 10.0f * (float)shelf;
		peer_edge(world, ground, &surface, peer_at(-505.0f, y), peer_at(505.0f, y));
		for (int32_t i = 0; i < 500; ++i) {
			int32_t awake = i % 100 == 50;
			uint32_t flags = PEER_DYNAMIC | (uint32_t)(awake ? PEER_NEVER_SLEEPS : PEER_ASLEEP);
			peer_body body = peer_add(world, flags, 2.0f * ((float)i - 249.5f), y + (awake ? 2.5f : 0.5f));
			peer_box(world, body, &surface, peer_at(0.0f, 0.0f), 0.5f, 0.5f, 0.0f);
		}
	}
}
