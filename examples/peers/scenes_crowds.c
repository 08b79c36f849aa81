/*
 * examples/peers/scenes_crowds.c - crowds that nobody tuned for: mixed shapes and bodies of several shapes in a pit, a drum with paddles,
 * bodies that live for five frames, and few that are awake in a large world.
 */
#include "peers/world.h"
#include <math.h>

static const double pi = 3.14159265358979323846;

/* Floor and two walls of boxes; the inside is from -half to half and up to height. */
static void add_pit(peer_world *world, float half, float height)
{
	peer_shape_def surface = peer_surface();
	peer_body ground = peer_add(world, 0, 0.0f, 0.0f);
	surface.friction = 0.5f;
	peer_box(world, ground, &surface, peer_at(0.0f, -0.5f), half + 1.0f, 0.5f, 0.0f);
	peer_box(world, ground, &surface, peer_at(-half - 0.5f, 0.5f * height), 0.5f, 0.5f * height, 0.0f);
	peer_box(world, ground, &surface, peer_at(half + 0.5f, 0.5f * height), 0.5f, 0.5f * height, 0.0f);
}

/* A body of row i / length; every second row is shifted. */
static peer_body add_in_rows(peer_world *world, int32_t i, int32_t length, float spacing)
{
	int32_t row = i / length;
	return peer_add(world, PEER_DYNAMIC, spacing * ((float)(i % length) - 0.5f * (float)length + (row % 2 == 0 ? 0.4f : 0.6f)), spacing * (float)(row + 1));
}

static void add_regular(peer_world *world, peer_body body, const peer_shape_def *surface, int32_t corners, float radius)
{
	peer_vec points[PEER_POLYGON_MAX];
	for (int32_t k = 0; k < corners; ++k) {
		double angle = 2.0 * pi * (double)k / (double)corners;
		points[k] = peer_at((float)((double)radius * cos(angle)), (float)((double)radius * sin(angle)));
	}
	peer_polygon(world, body, surface, points, corners, 0.0f);
}

/* A circle, capsule, box, pentagon or hexagon of one of four sizes, by its number. */
static void add_mixed(peer_world *world, peer_body body, const peer_shape_def *surface, int32_t i)
{
	float size = 0.25f + 0.05f * (float)(i % 4);
	switch (i % 5) {
	case 0: peer_circle(world, body, surface, size); break;
	case 1: peer_capsule(world, body, surface, peer_at(-0.6f * size, 0.0f), peer_at(0.6f * size, 0.0f), 0.6f * size); break;
	case 2: peer_box(world, body, surface, peer_at(0.0f, 0.0f), size, 0.7f * size, 0.0f); break;
	case 3: add_regular(world, body, surface, 5, size); break;
	default: add_regular(world, body, surface, 6, size); break;
	}
}

static peer_shape_def surface_of(float friction, float restitution)
{
	peer_shape_def surface = peer_surface();
	surface.friction = friction;
	surface.restitution = restitution;
	return surface;
}

/* Of 2,000 a pit of 44 m, of fewer in proportion. */
void peer_junkyard(peer_world *world)
{
	peer_shape_def surface = surface_of(0.5f, 0.1f);
	int32_t length = world->scene->size < 1000 ? 10 : 50;
	add_pit(world, 0.44f * (float)length, 60.0f);
	for (int32_t i = 0; i < world->scene->size; ++i)
		add_mixed(world, add_in_rows(world, i, length, 0.85f), &surface, i);
}

/* Squares of half 0.2 side by side: bit 3 * row + column, three rows of three. */
static void add_squares(peer_world *world, peer_body body, const peer_shape_def *surface, uint32_t cells)
{
	for (int32_t k = 0; k < 9; ++k)
		if (cells >> k & 1u)
			peer_box(world, body, surface, peer_at(0.4f * (float)(k % 3 - 1), 0.4f * (float)(k / 3 - 1)), 0.2f, 0.2f, 0.0f);
}

/* Crosses of five squares and cups of seven in turn. */
void peer_compounds(peer_world *world)
{
	peer_shape_def surface = surface_of(0.5f, 0.0f);
	add_pit(world, 22.0f, 60.0f);
	for (int32_t i = 0; i < world->scene->size; ++i)
		add_squares(world, add_in_rows(world, i, 28, 1.5f), &surface, i % 2 == 0 ? 0272u : 0557u);
}

/* A square drum with a paddle on each side, filled with mixed shapes. */
void peer_washer(peer_world *world)
{
	const float inner = 12.0f, wall = 0.5f;
	peer_shape_def surface = peer_surface(), filling = surface_of(0.3f, 0.1f);
	surface.density = 50.0f;
	peer_body drum = peer_add(world, PEER_DYNAMIC, 0.0f, inner);
	for (int32_t k = 0; k < 4; ++k) {
		float x = k == 0 ? 1.0f : k == 1 ? -1.0f : 0.0f, y = k == 2 ? 1.0f : k == 3 ? -1.0f : 0.0f;
		peer_box(world, drum, &surface, peer_at((inner + wall) * x, (inner + wall) * y), x != 0.0f ? wall : inner + 2.0f * wall, x != 0.0f ? inner + 2.0f * wall : wall, 0.0f);
		peer_box(world, drum, &surface, peer_at((inner - 1.5f) * x, (inner - 1.5f) * y), x != 0.0f ? 1.5f : 0.2f, x != 0.0f ? 0.2f : 1.5f, 0.0f);
	}
	peer_pin_motor(world, PEER_GROUND, peer_at(0.0f, inner), drum, peer_at(0.0f, 0.0f), 1.0f, 1.0e8f);
	for (int32_t i = 0; i < world->scene->size; ++i)
		add_mixed(world, peer_add(world, PEER_DYNAMIC, -8.5f + 0.8f * (float)(i % 22), 3.5f + 0.8f * (float)(i / 22)), &filling, i);
}

/* ------------------------------------------------------------------ churn */

#define CHURN_FRAMES 5

typedef struct churn_state {
	peer_body first[CHURN_FRAMES]; /* of the bodies that were made in a frame */
} churn_state;

void peer_churn(peer_world *world)
{
	churn_state *state = (churn_state *)peer_memory(world, sizeof *state);
	add_pit(world, 30.0f, 60.0f);
	for (int32_t k = 0; state != NULL && k < CHURN_FRAMES; ++k)
		state->first[k] = PEER_GROUND;
}

/* In each frame as many as the scene's size are made, and those of five frames ago removed. */
void peer_churn_step(peer_world *world, int32_t step_index)
{
	churn_state *state = (churn_state *)world->memory;
	peer_shape_def surface = surface_of(0.5f, 0.1f);
	peer_body *first = &state->first[step_index % CHURN_FRAMES];
	for (int32_t i = 0; i < world->scene->size && *first != PEER_GROUND; ++i)
		peer_remove(world, *first + i);
	*first = world->count;
	for (int32_t i = 0; i < world->scene->size; ++i) {
		int32_t row = i / 50;
		float x = 1.1f * (float)(i % 50 - 25), y = 0.5f + 0.9f * (float)(row + 10 * (step_index % CHURN_FRAMES));
		add_mixed(world, peer_add(world, PEER_DYNAMIC, x, y), &surface, i);
	}
}

/* ------------------------------------------------------------------ a few of many */

/* Stacks of four sleeping boxes on long ground, a ball that rolls over a floor of its own beside every tenth. */
void peer_few_awake(peer_world *world)
{
	peer_shape_def surface = peer_surface();
	int32_t stacks = world->scene->size / 4;
	float half = 0.6f * (float)stacks;
	peer_body ground = peer_add(world, 0, 0.0f, 0.0f);
	peer_box(world, ground, &surface, peer_at(0.0f, -1.0f), half + 10.0f, 1.0f, 0.0f);
	peer_box(world, ground, &surface, peer_at(0.0f, 9.0f), half + 10.0f, 1.0f, 0.0f);
	for (int32_t i = 0; i < stacks; ++i) {
		float x = 1.2f * (float)i - half;
		for (int32_t k = 0; k < 4; ++k) {
			peer_body body = peer_add(world, PEER_DYNAMIC | PEER_ASLEEP, x, 0.5f + (float)k);
			peer_box(world, body, &surface, peer_at(0.0f, 0.0f), 0.5f, 0.5f, 0.0f);
		}
		if (i % 10 == 0) {
			peer_body_def def = {PEER_DYNAMIC | PEER_NEVER_SLEEPS, {x, 10.5f}, {1.0f + 0.1f * (float)(i % 7), 0.0f}, 0.0f};
			peer_circle(world, peer_add_body(world, &def), &surface, 0.5f);
		}
	}
}
