/*
 * examples/peers/world.c - the words that scenes are made of: each is told to the engine and to the judge.
 */
#include "peers/world.h"
#include "peers/judge.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

static int32_t check(peer_world *world, int32_t good)
{
	if (!good)
		world->failed = 1;
	return good;
}

void *peer_memory(peer_world *world, uint64_t bytes)
{
	world->memory = calloc(1, (size_t)bytes);
	check(world, world->memory != NULL);
	return world->memory;
}

/* ------------------------------------------------------------------ bodies */

static int32_t grow(peer_world *world)
{
	if (world->count < world->capacity)
		return 1;
	int32_t capacity = 2 * world->capacity + 256;
	peer_slot *slots = (peer_slot *)realloc(world->slots, (size_t)capacity * sizeof *slots);
	if (slots == NULL)
		return check(world, 0);
	world->slots = slots;
	world->capacity = capacity;
	return 1;
}

peer_body peer_add_body(peer_world *world, const peer_body_def *def)
{
	if (world->failed || !grow(world))
		return PEER_GROUND;
	peer_slot *slot = &world->slots[world->count];
	memset(slot, 0, sizeof *slot);
	slot->start = def->position;
	slot->flags = def->flags;
	slot->alive = 1;
	if (!check(world, world->engine->add_body(world->world, def, &slot->engine)))
		return PEER_GROUND;
	if (world->judge != NULL)
		check(world, peer_engine_cairn.add_body(world->judge, def, &slot->judge));
	return world->count++;
}

peer_body peer_add(peer_world *world, uint32_t flags, float x, float y)
{
	peer_body_def def;
	memset(&def, 0, sizeof def);
	def.flags = flags;
	def.position = peer_at(x, y);
	return peer_add_body(world, &def);
}

void peer_remove(peer_world *world, peer_body body)
{
	if (world->failed)
		return;
	peer_slot *slot = &world->slots[body];
	world->engine->remove_body(world->world, slot->engine);
	if (world->judge != NULL)
		peer_engine_cairn.remove_body(world->judge, slot->judge);
	slot->alive = 0;
}

/* ------------------------------------------------------------------ shapes */

peer_shape_def peer_surface(void)
{
	peer_shape_def def;
	memset(&def, 0, sizeof def);
	def.density = 1.0f;
	def.friction = 0.6f;
	def.category = 1;
	def.mask = UINT32_MAX;
	return def;
}

static void add_shape(peer_world *world, peer_body body, const peer_shape_def *surface, int32_t kind, const peer_vec *points, int32_t count, float radius)
{
	peer_shape_def def = *surface;
	def.kind = kind;
	def.points = points;
	def.count = count;
	def.radius = radius;
	if (world->failed)
		return;
	const peer_slot *slot = &world->slots[body];
	check(world, world->engine->add_shape(world->world, slot->engine, &def));
	if (world->judge != NULL)
		check(world, peer_engine_cairn.add_shape(world->judge, slot->judge, &def));
}

void peer_circle(peer_world *world, peer_body body, const peer_shape_def *surface, float radius)
{
	peer_vec center = {0.0f, 0.0f};
	add_shape(world, body, surface, PEER_CIRCLE, &center, 1, radius);
}

void peer_capsule(peer_world *world, peer_body body, const peer_shape_def *surface, peer_vec a, peer_vec b, float radius)
{
	peer_vec points[2] = {a, b};
	add_shape(world, body, surface, PEER_CAPSULE, points, 2, radius);
}

void peer_polygon(peer_world *world, peer_body body, const peer_shape_def *surface, const peer_vec *points, int32_t count, float radius)
{
	add_shape(world, body, surface, PEER_POLYGON, points, count, radius);
}

void peer_box(peer_world *world, peer_body body, const peer_shape_def *surface, peer_vec center, float half_x, float half_y, float radius)
{
	peer_vec points[4] = {{center.x - half_x, center.y - half_y}, {center.x + half_x, center.y - half_y}, {center.x + half_x, center.y + half_y},
		{center.x - half_x, center.y + half_y}};
	add_shape(world, body, surface, PEER_POLYGON, points, 4, radius);
}

void peer_edge(peer_world *world, peer_body body, const peer_shape_def *surface, peer_vec a, peer_vec b)
{
	peer_vec points[2] = {a, b};
	add_shape(world, body, surface, PEER_EDGE, points, 2, 0.0f);
}

void peer_chain(peer_world *world, peer_body body, const peer_shape_def *surface, const peer_vec *points, int32_t count, int32_t loop)
{
	add_shape(world, body, surface, loop ? PEER_LOOP : PEER_CHAIN, points, count, 0.0f);
}

peer_body peer_simple_box(peer_world *world, float x, float y, float half)
{
	peer_shape_def surface = peer_surface();
	peer_body body = peer_add(world, PEER_DYNAMIC, x, y);
	peer_box(world, body, &surface, peer_at(0.0f, 0.0f), half, half, 0.0f);
	return body;
}

/* ------------------------------------------------------------------ joints */

static peer_handle handle_of(const peer_world *world, peer_body body, int32_t judge)
{
	if (body == PEER_GROUND)
		return 0;
	return judge ? world->slots[body].judge : world->slots[body].engine;
}

void peer_join(peer_world *world, peer_body a, peer_body b, const peer_joint_def *def)
{
	if (world->failed)
		return;
	check(world, world->engine->add_joint(world->world, handle_of(world, a, 0), handle_of(world, b, 0), def));
	if (world->judge != NULL)
		check(world, peer_engine_cairn.add_joint(world->judge, handle_of(world, a, 1), handle_of(world, b, 1), def));
}

void peer_pin(peer_world *world, peer_body a, peer_vec anchor_a, peer_body b, peer_vec anchor_b)
{
	peer_joint_def def;
	memset(&def, 0, sizeof def);
	def.anchor_a = anchor_a;
	def.anchor_b = anchor_b;
	peer_join(world, a, b, &def);
}

void peer_pin_motor(peer_world *world, peer_body a, peer_vec anchor_a, peer_body b, peer_vec anchor_b, float speed, float torque)
{
	peer_joint_def def;
	memset(&def, 0, sizeof def);
	def.flags = PEER_MOTOR;
	def.anchor_a = anchor_a;
	def.anchor_b = anchor_b;
	def.motor_speed = speed;
	def.motor_torque = torque;
	peer_join(world, a, b, &def);
}

/* ------------------------------------------------------------------ opening and closing */

/* Engines that cannot make a body asleep are told when everything is there. */
static void put_to_sleep(peer_world *world)
{
	for (int32_t i = 0; world->engine->fall_asleep != NULL && i < world->count; ++i) {
		if (world->slots[i].flags & PEER_ASLEEP)
			world->engine->fall_asleep(world->world, world->slots[i].engine);
	}
}

int32_t peer_world_open(peer_world *world, const peer_engine *engine, const peer_scene *scene, int32_t workers, int32_t judged)
{
	peer_world_def def;
	memset(world, 0, sizeof *world);
	world->scene = scene;
	world->engine = engine;
	def.gravity = scene->gravity;
	def.sleep = (scene->flags & PEER_SCENE_SLEEP) != 0;
	def.workers = workers;
	world->world = engine->create(&def);
	def.sleep = 0;
	def.workers = 1;
	if (judged)
		world->judge = peer_engine_cairn.create(&def);
	if (check(world, world->world != NULL && (world->judge != NULL || !judged))) {
		scene->create(world);
		put_to_sleep(world);
	}
	if (world->failed)
		peer_world_close(world);
	return !world->failed;
}

void peer_world_close(peer_world *world)
{
	if (world->world != NULL)
		world->engine->destroy(world->world);
	if (world->judge != NULL)
		peer_engine_cairn.destroy(world->judge);
	free(world->slots);
	free(world->memory);
	world->world = world->judge = world->memory = NULL;
	world->slots = NULL;
	world->count = world->capacity = 0;
}

/* ------------------------------------------------------------------ measuring */

static int32_t is_lost(const peer_scene *scene, const peer_pose *pose)
{
	int32_t beside = !(pose->x >= (double)scene->lower.x && pose->x <= (double)scene->upper.x);
	int32_t within = pose->y >= (double)scene->lower.y && pose->y <= (double)scene->upper.y;
	return beside ? !(scene->flags & PEER_SCENE_OPEN) : !within;
}

void peer_world_measure(peer_world *world, int32_t with_surfaces, peer_errors *errors)
{
	measure_worst worst;
	memset(&worst, 0, sizeof worst);
	errors->displacement = 0.0;
	errors->lost = 0;
	for (int32_t i = 0; i < world->count; ++i) {
		const peer_slot *slot = &world->slots[i];
		peer_pose pose;
		if (!slot->alive || !(slot->flags & PEER_DYNAMIC))
			continue;
		world->engine->read_pose(world->world, slot->engine, &pose);
		errors->displacement = fmax(errors->displacement, hypot(pose.x - (double)slot->start.x, pose.y - (double)slot->start.y));
		errors->lost += is_lost(world->scene, &pose);
		if (!peer_judge_place(world->judge, slot->judge, &pose))
			errors->broken = 1;
	}
	if (!with_surfaces || errors->broken)
		return;
	peer_judge_errors(world->judge, &worst);
	errors->broken |= worst.failed;
	errors->penetration = fmax(errors->penetration, (double)worst.penetration_m);
	errors->joint = fmax(errors->joint, (double)worst.joint_m);
}

static uint64_t hash_bytes(uint64_t hash, const void *data, size_t bytes)
{
	const unsigned char *p = (const unsigned char *)data;
	for (size_t i = 0; i < bytes; ++i)
		hash = (hash ^ p[i]) * 1099511628211u;
	return hash;
}

uint64_t peer_world_hash(const peer_world *world)
{
	uint64_t hash = 14695981039346656037u;
	for (int32_t i = 0; i < world->count; ++i) {
		peer_pose pose;
		if (!world->slots[i].alive)
			continue;
		world->engine->read_pose(world->world, world->slots[i].engine, &pose);
		hash = hash_bytes(hash, &pose, sizeof pose);
	}
	return hash;
}
