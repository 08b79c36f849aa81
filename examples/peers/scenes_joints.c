/*
 * examples/peers/scenes_joints.c - what turns, drives or hangs: a grid of pinned circles, a drum, a ring with
 * an arm, cars on a terrain, ragdolls that rain.
 */
#include "peers/world.h"
#include <math.h>

static const double pi = 3.14159265358979323846;

/* ------------------------------------------------------------------ joint grid */

#define GRID_MAX 100

static int32_t is_fixed(int32_t k, int32_t i, int32_t side) { return i == 0 && k >= side / 2 - 3 && k <= side / 2 + 3; }

/* Column k, row i at (k, -i), pinned to the neighbours above and to the left unless both are static. */
void peer_joint_grid(peer_world *world)
{
	peer_body above = PEER_GROUND, left[GRID_MAX] = {0};
	int32_t side = world->scene->size;
	peer_shape_def surface = peer_surface();
	surface.category = 2;
	surface.mask = ~(uint32_t)2;
	for (int32_t k = 0; k < side; ++k) {
		for (int32_t i = 0; i < side; ++i) {
			int32_t fixed = is_fixed(k, i, side);
			peer_body body = peer_add(world, fixed ? 0u : (uint32_t)PEER_DYNAMIC, (float)k, (float)-i);
			peer_circle(world, body, &surface, 0.4f);
			if (i > 0)
				peer_pin(world, above, peer_at(0.0f, -0.5f), body, peer_at(0.0f, 0.5f));
			if (k > 0 && !(fixed && is_fixed(k - 1, i, side)))
				peer_pin(world, left[i], peer_at(0.5f, 0.0f), body, peer_at(-0.5f, 0.0f));
			above = body;
			left[i] = body;
		}
	}
}

/* ------------------------------------------------------------------ tumbler */

void peer_tumbler(peer_world *world)
{
	const float inner = 10.0f, wall = 0.5f;
	int32_t side = world->scene->size;
	peer_shape_def surface = peer_surface();
	surface.density = 50.0f;
	peer_body drum = peer_add(world, PEER_DYNAMIC, 0.0f, 10.0f);
	peer_box(world, drum, &surface, peer_at(inner + wall, 0.0f), wall, inner, 0.0f);
	peer_box(world, drum, &surface, peer_at(-inner - wall, 0.0f), wall, inner, 0.0f);
	peer_box(world, drum, &surface, peer_at(0.0f, inner + wall), inner, wall, 0.0f);
	peer_box(world, drum, &surface, peer_at(0.0f, -inner - wall), inner, wall, 0.0f);
	peer_pin_motor(world, PEER_GROUND, peer_at(0.0f, 10.0f), drum, peer_at(0.0f, 0.0f), 25.0f * PEER_PI / 180.0f, 1.0e8f);
	for (int32_t i = 0; i < side; ++i) {
		for (int32_t j = 0; j < side; ++j)
			peer_simple_box(world, -9.0f + 0.4f * (float)j, 1.0f + 0.4f * (float)i, 0.125f);
	}
}

/* ------------------------------------------------------------------ spinner */

#define RING_POINTS 360

/* Clockwise: it collides on its inside. */
static void add_ring(peer_world *world)
{
	peer_vec points[RING_POINTS];
	peer_shape_def surface = peer_surface();
	surface.friction = 0.1f;
	for (int32_t i = 0; i < RING_POINTS; ++i) {
		double angle = -2.0 * pi * (double)i / RING_POINTS;
		points[i] = peer_at((float)(40.0 * cos(angle)), (float)(32.0 + 40.0 * sin(angle)));
	}
	peer_chain(world, peer_add(world, 0, 0.0f, 0.0f), &surface, points, RING_POINTS, 1);
}

static void add_arm(peer_world *world)
{
	peer_shape_def surface = peer_surface();
	surface.friction = 0.0f;
	peer_body arm = peer_add(world, PEER_DYNAMIC | PEER_NEVER_SLEEPS, 0.0f, 12.0f);
	peer_box(world, arm, &surface, peer_at(0.0f, 0.0f), 0.4f, 20.0f, 0.2f);
	peer_pin_motor(world, PEER_GROUND, peer_at(0.0f, 12.0f), arm, peer_at(0.0f, 0.0f), 5.0f, 1.0e30f);
}

void peer_spinner(peer_world *world)
{
	float x = -23.0f, y = 2.0f;
	peer_shape_def surface = peer_surface();
	surface.density = 0.25f;
	surface.friction = 0.1f;
	surface.restitution = 0.1f;
	add_ring(world);
	add_arm(world);
	for (int32_t i = 0; i < world->scene->size; ++i) {
		peer_body body = peer_add(world, PEER_DYNAMIC, x, y);
		if (i % 3 == 0)
			peer_capsule(world, body, &surface, peer_at(-0.25f, 0.0f), peer_at(0.25f, 0.0f), 0.25f);
		else if (i % 3 == 1)
			peer_circle(world, body, &surface, 0.35f);
		else
			peer_box(world, body, &surface, peer_at(0.0f, 0.0f), 0.35f, 0.35f, 0.0f);
		x += 0.5f;
		if (x >= 23.0f) {
			x = -23.0f;
			y += 0.5f;
		}
	}
}

/* ------------------------------------------------------------------ cars */

#define TERRAIN_POINTS 2204
#define CAR_SPACING_M 5.0f

/* Hills between two walls. The first and last edges lie outside of the walls: nothing touches them. */
static void add_terrain(peer_world *world)
{
	peer_vec points[TERRAIN_POINTS];
	const int32_t last = TERRAIN_POINTS - 1;
	peer_shape_def surface = peer_surface();
	surface.friction = 0.9f;
	for (int32_t i = 0; i <= last; ++i) {
		float x = 0.5f * (0.5f * (float)last - (float)i);
		points[i] = peer_at(x, (float)(0.9 * sin((double)x * 0.23) + 0.35 * sin((double)x * 0.61) + 0.08 * sin((double)x * 2.1)));
	}
	points[0].y = points[1].y = points[last - 1].y = points[last].y = 20.0f;
	peer_chain(world, peer_add(world, 0, 0.0f, 0.0f), &surface, points, TERRAIN_POINTS, 0);
}

static void add_wheel(peer_world *world, peer_body chassis, float x, float y, peer_vec hub)
{
	peer_shape_def surface = peer_surface();
	surface.density = 2.0f;
	surface.friction = 1.2f;
	peer_body wheel = peer_add(world, PEER_DYNAMIC, x + hub.x, y + hub.y);
	peer_circle(world, wheel, &surface, 0.5f);
	peer_pin_motor(world, chassis, hub, wheel, peer_at(0.0f, 0.0f), -14.0f, 5.0f);
}

static void add_car(peer_world *world, float x, float y)
{
	static const peer_vec hull[6] = {{-1.5f, -0.3f}, {1.5f, -0.3f}, {1.5f, 0.1f}, {0.4f, 0.6f}, {-1.0f, 0.6f}, {-1.5f, 0.2f}};
	peer_shape_def surface = peer_surface();
	surface.friction = 0.3f;
	peer_body chassis = peer_add(world, PEER_DYNAMIC, x, y);
	peer_polygon(world, chassis, &surface, hull, 6, 0.0f);
	add_wheel(world, chassis, x, y, peer_at(-1.0f, -0.4f));
	add_wheel(world, chassis, x, y, peer_at(1.0f, -0.4f));
}

/* They drop onto the hills and drive to the right, where the first ones pile up at the wall. */
void peer_cars(peer_world *world)
{
	int32_t count = world->scene->size;
	add_terrain(world);
	for (int32_t i = 0; i < count; ++i)
		add_car(world, CAR_SPACING_M * ((float)i - 0.5f * (float)(count - 1)), 3.0f);
}

/* ------------------------------------------------------------------ ragdolls */

/* Eleven bodies, ten pins: a bone is a capsule along y, feet are rounded polygons on the lower legs. The
   pins' motors of speed 0 are their friction, springs pull them to rest. */
enum { HIP, TORSO, HEAD, UPPER_LEG_A, LOWER_LEG_A, UPPER_LEG_B, LOWER_LEG_B, UPPER_ARM_A, LOWER_ARM_A, UPPER_ARM_B, LOWER_ARM_B, BONES };

typedef struct bone {
	float y;                  /* of the body above the ragdoll's base */
	float from, to;           /* capsule along y in the body's frame */
	float radius;
	float linear_damping;
	peer_body parent;         /* PEER_GROUND: none */
	float joint_y;            /* above the base */
	float lower_pi, upper_pi; /* limits, in units of pi */
	float reference_pi;
	float friction;           /* of the joint, times 0.05 Nm */
} bone;

static const bone bones[BONES] = {
	{0.95f, -0.02f, 0.02f, 0.095f, 0.0f, PEER_GROUND, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f},
	{1.2f, -0.135f, 0.135f, 0.09f, 0.0f, HIP, 1.0f, -0.25f, 0.0f, 0.0f, 0.5f},
	{1.475f, -0.038f, 0.039f, 0.075f, 0.1f, TORSO, 1.4f, -0.3f, 0.1f, 0.0f, 0.25f},
	{0.775f, -0.125f, 0.125f, 0.06f, 0.0f, HIP, 0.9f, -0.05f, 0.4f, 0.0f, 1.0f},
	{0.475f, -0.155f, 0.125f, 0.045f, 0.0f, UPPER_LEG_A, 0.625f, -0.5f, -0.02f, 0.0f, 0.5f},
	{0.775f, -0.125f, 0.125f, 0.06f, 0.0f, HIP, 0.9f, -0.05f, 0.4f, 0.0f, 1.0f},
	{0.475f, -0.155f, 0.125f, 0.045f, 0.0f, UPPER_LEG_B, 0.625f, -0.5f, -0.02f, 0.0f, 0.5f},
	{1.225f, -0.125f, 0.125f, 0.035f, 0.0f, TORSO, 1.35f, -0.1f, 0.8f, 0.0f, 0.5f},
	{0.975f, -0.125f, 0.125f, 0.03f, 0.1f, UPPER_ARM_A, 1.1f, -0.2f, 0.3f, 0.25f, 0.1f},
	{1.225f, -0.125f, 0.125f, 0.035f, 0.0f, TORSO, 1.35f, -0.1f, 0.8f, 0.0f, 0.5f},
	{0.975f, -0.125f, 0.125f, 0.03f, 0.1f, UPPER_ARM_B, 1.1f, -0.2f, 0.3f, 0.25f, 0.1f},
};

static peer_body add_bone(peer_world *world, const bone *b, float x, float y, int32_t group, int32_t has_foot)
{
	static const peer_vec foot[4] = {{-0.03f, -0.185f}, {0.11f, -0.185f}, {0.11f, -0.16f}, {-0.03f, -0.14f}};
	peer_body_def def = {PEER_DYNAMIC, {x, y + b->y}, {0.0f, 0.0f}, b->linear_damping};
	peer_body body = peer_add_body(world, &def);
	peer_shape_def surface = peer_surface();
	surface.friction = 0.2f;
	surface.category = 2;
	surface.mask = 1 | 2;
	surface.group = group;
	peer_capsule(world, body, &surface, peer_at(0.0f, b->from), peer_at(0.0f, b->to), b->radius);
	surface.friction = 0.05f;
	surface.mask = 1;
	if (has_foot)
		peer_polygon(world, body, &surface, foot, 4, 0.015f);
	return body;
}

static void add_bone_joint(peer_world *world, const bone *b, peer_body parent, peer_body child)
{
	peer_joint_def def;
	def.flags = PEER_LIMIT | PEER_MOTOR | PEER_SPRING;
	def.anchor_a = peer_at(0.0f, b->joint_y - bones[b->parent].y);
	def.anchor_b = peer_at(0.0f, b->joint_y - b->y);
	def.reference = b->reference_pi * PEER_PI;
	def.lower = b->lower_pi * PEER_PI;
	def.upper = b->upper_pi * PEER_PI;
	def.motor_speed = 0.0f;
	def.motor_torque = 0.05f * b->friction;
	def.spring_hertz = 5.0f;
	def.spring_damping_ratio = 0.5f;
	peer_join(world, parent, child, &def);
}

static void add_ragdoll(peer_world *world, float x, float y, int32_t group, peer_body out[BONES])
{
	for (int32_t i = 0; i < BONES; ++i) {
		out[i] = add_bone(world, &bones[i], x, y, group, i == LOWER_LEG_A || i == LOWER_LEG_B);
		if (bones[i].parent != PEER_GROUND)
			add_bone_joint(world, &bones[i], out[bones[i].parent], out[i]);
	}
}

/* Rows of thirty above the middle of the hills: they fall on each other and roll into the valleys. */
void peer_ragdoll_hills(peer_world *world)
{
	peer_body bodies[BONES];
	add_terrain(world);
	for (int32_t i = 0; i < world->scene->size; ++i)
		add_ragdoll(world, 1.1f * (float)(i % 30 - 15), 3.0f + 2.0f * (float)(i / 30), -1 - i, bodies);
}

/* ------------------------------------------------------------------ chains */

/* Chains of twelve links, hung in a row so near that they sweep through each other's place, over a heap of boxes that they stir. */
void peer_flails(peer_world *world)
{
	peer_shape_def surface = peer_surface();
	peer_body ground = peer_add(world, 0, 0.0f, 0.0f);
	float half = 1.5f * (float)world->scene->size;
	peer_box(world, ground, &surface, peer_at(0.0f, -1.0f), half + 20.0f, 1.0f, 0.0f);
	for (int32_t i = 0; i < world->scene->size; ++i) {
		float x = 3.0f * (float)i - half;
		peer_body last = ground;
		for (int32_t k = 0; k < 12; ++k) {
			float r = k == 11 ? 0.5f : 0.1f, at = x + 0.6f * (float)k;
			peer_body link = peer_add(world, PEER_DYNAMIC, at + 0.3f, 9.0f);
			peer_capsule(world, link, &surface, peer_at(-0.3f, 0.0f), peer_at(0.3f, 0.0f), r);
			peer_pin(world, last, k == 0 ? peer_at(at, 9.0f) : peer_at(0.3f, 0.0f), link, peer_at(-0.3f, 0.0f));
			last = link;
		}
		for (int32_t k = 0; k < 10; ++k)
			peer_simple_box(world, x + 0.5f * (float)(k % 5), 0.3f + 0.5f * (float)(k / 5), 0.25f);
	}
}

/* ------------------------------------------------------------------ rain */

#define RAIN_FLOORS 5
#define RAIN_COLUMNS 40
#define RAIN_GROUP 5
#define RAIN_WIDTH_M 250.0f

typedef struct rain_state {
	peer_body bodies[RAIN_COLUMNS][RAIN_FLOORS * RAIN_GROUP][BONES];
	int32_t columns_made;
	int32_t oldest;
} rain_state;

static void make_column(peer_world *world, rain_state *state, int32_t column)
{
	float x = -0.5f * RAIN_WIDTH_M + RAIN_WIDTH_M / (float)RAIN_COLUMNS * ((float)column + 0.5f);
	for (int32_t i = 0; i < RAIN_FLOORS * RAIN_GROUP; ++i) {
		int32_t floor = i / RAIN_GROUP, member = i % RAIN_GROUP;
		int32_t group = -1 - (column * RAIN_FLOORS * RAIN_GROUP + i);
		add_ragdoll(world, x + 0.5f * (float)member, 40.0f + 45.0f * (float)floor, group, state->bodies[column][i]);
	}
}

static void remove_column(peer_world *world, rain_state *state, int32_t column)
{
	for (int32_t i = 0; i < RAIN_FLOORS * RAIN_GROUP; ++i) {
		for (int32_t k = 0; k < BONES; ++k)
			peer_remove(world, state->bodies[column][i][k]);
	}
}

void peer_rain(peer_world *world)
{
	peer_shape_def surface = peer_surface();
	peer_memory(world, sizeof(rain_state));
	for (int32_t floor = 0; floor < RAIN_FLOORS; ++floor) {
		peer_body body = peer_add(world, 0, 0.0f, 45.0f * (float)floor);
		for (int32_t i = 0; i <= 500; ++i)
			peer_box(world, body, &surface, peer_at(-0.5f * RAIN_WIDTH_M + 0.5f * (float)i, 0.0f), 0.25f, 0.25f, 0.0f);
	}
}

/* Every 8 steps one more column; when all are there, the oldest is removed and made again. */
void peer_rain_step(peer_world *world, int32_t step_index)
{
	rain_state *state = (rain_state *)world->memory;
	if (step_index % 8 != 0)
		return;
	if (state->columns_made < RAIN_COLUMNS) {
		make_column(world, state, state->columns_made++);
		return;
	}
	remove_column(world, state, state->oldest);
	make_column(world, state, state->oldest);
	state->oldest = (state->oldest + 1) % RAIN_COLUMNS;
}
