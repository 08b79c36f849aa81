/*
 * test/world/calls.h - what tests of single calls share: an allocator that can fail, a small world with one of
 * everything, good definitions to spoil, and the state that a failed call may not change.
 */
#ifndef CAIRN_TEST_CALLS_H
#define CAIRN_TEST_CALLS_H

#include "world/error.h"
#include "test.h"

#include <stdlib.h>

/* ------------------------------------------------------------------ allocator that can fail */

static int alloc_allow = -1;         /* allocations until the next failure; -1: never fail */
static uint32_t alloc_fail_mask;     /* random failures: fail when (random & mask) == 0; 0: off */
static uint32_t alloc_random = 1u;
static int64_t alloc_live;

static inline uint32_t random_next(uint32_t *state)
{
	*state ^= *state << 13;
	*state ^= *state >> 17;
	*state ^= *state << 5;
	return *state;
}

static inline void *test_alloc(uint64_t bytes, uint32_t align, void *user)
{
	unsigned char *raw, *out;
	(void)user;
	if (alloc_allow == 0 || (alloc_fail_mask != 0 && (random_next(&alloc_random) & alloc_fail_mask) == 0))
		return NULL;
	if (alloc_allow > 0)
		--alloc_allow;
	raw = malloc((size_t)bytes + align + sizeof(void *));
	out = (unsigned char *)(((uintptr_t)raw + sizeof(void *) + align - 1) & ~(uintptr_t)(align - 1));
	memcpy(out - sizeof(void *), &raw, sizeof raw);
	alloc_live += (int64_t)bytes;
	return out;
}

static inline void test_free(void *memory, uint64_t bytes, void *user)
{
	void *raw;
	(void)user;
	memcpy(&raw, (unsigned char *)memory - sizeof(void *), sizeof raw);
	alloc_live -= (int64_t)bytes;
	free(raw);
}

/* ------------------------------------------------------------------ the world under test */

#define BAD_HANDLES 16

static struct {
	cn_world *w;
	cn_body ground, box, ball, pill, rail;
	cn_shape ground_shape, chain, edge, box_shape, ball_shape, pill_shape, loose, area, sensor;
	cn_joint pin, rope;
	cn_body bad_bodies[BAD_HANDLES];
	cn_shape bad_shapes[BAD_HANDLES];
	cn_joint bad_joints[BAD_HANDLES];
	int bad_body_count, bad_shape_count, bad_joint_count;
} f;

#define W (f.w)

static cn_world_def wd;
static cn_body_def bd;
static cn_shape_def sd;
static cn_area_def area;
static cn_revolute_def rd;
static cn_distance_def dd;
static cn_circle circle;
static cn_capsule capsule;
static cn_edge edge;
static cn_polygon polygon;
static cn_chain chain;
static cn_vec2 chain_points[4];
static cn_material material;
static cn_mass_data mass;
static cn_filter filter;

static inline cn_vec2 v2(float x, float y)
{
	cn_vec2 v;
	v.x = x;
	v.y = y;
	return v;
}

/* Good values of every struct, before a test spoils one field. */
static inline int reset(void)
{
	cn_world_def_init(&wd);
	cn_body_def_init(&bd);
	bd.position_m = v2(3.0f, 5.0f);
	bd.name = "a body with a name";
	cn_shape_def_init(&sd);
	sd.body = f.ball;
	cn_revolute_def_init(&rd);
	rd.base.body_a = f.box;
	rd.base.body_b = f.pill;
	cn_distance_def_init(&dd);
	dd.base.body_b = f.box;
	circle.center_m = v2(0.1f, 0.0f);
	circle.radius_m = 0.25f;
	capsule.a_m = edge.a_m = v2(-0.5f, 0.0f);
	capsule.b_m = edge.b_m = v2(0.5f, 0.0f);
	capsule.radius_m = 0.2f;
	memset(&polygon, 0, sizeof polygon);
	polygon.count = 4;
	polygon.points_m[0] = v2(-0.5f, -0.5f);
	polygon.points_m[1] = v2(0.5f, -0.5f);
	polygon.points_m[2] = v2(0.5f, 0.5f);
	polygon.points_m[3] = v2(-0.5f, 0.5f);
	chain_points[0] = v2(4.0f, 0.0f);
	chain_points[1] = v2(2.0f, 0.2f);
	chain_points[2] = v2(-2.0f, 0.0f);
	chain_points[3] = v2(-4.0f, 0.5f);
	chain.points_m = chain_points;
	chain.count = 4;
	chain.loop = 0;
	material = sd.material;
	material.static_friction = 0.5f;
	material.dynamic_friction = 0.4f;
	material.restitution = 0.1f;
	mass.mass_kg = 2.0f;
	mass.inertia_kgm2 = 0.5f;
	mass.center_m = v2(0.0f, 0.1f);
	memset(&filter, 0, sizeof filter);
	filter.category = 2;
	filter.mask = 1;
	return 0;
}

/* A good struct with one field spoiled. */
#define WD(field, value) (reset(), wd.field = (value), &wd)
#define BD(field, value) (reset(), bd.field = (value), &bd)
#define SD(field, value) (reset(), sd.field = (value), &sd)
#define RD(field, value) (reset(), rd.field = (value), &rd)
#define DD(field, value) (reset(), dd.field = (value), &dd)
#define CI(field, value) (reset(), circle.field = (value), &circle)
#define CA(field, value) (reset(), capsule.field = (value), &capsule)
#define ED(field, value) (reset(), edge.field = (value), &edge)
#define PO(field, value) (reset(), polygon.field = (value), &polygon)
#define CH(field, value) (reset(), chain.field = (value), &chain)
#define CP(point, value) (reset(), chain_points[point] = (value), &chain)
#define MA(field, value) (reset(), material.field = (value), &material)
#define BASE(def, a, b) (reset(), def.base.body_a = (a), def.base.body_b = (b), &def)
#define MD(field, value) (reset(), mass.field = (value), &mass)

static inline cn_body make_body(int32_t type, float x, float y)
{
	cn_body body = 0;
	reset();
	bd.type = type;
	bd.position_m = v2(x, y);
	CHECK(cn_body_create(W, &bd, &body) == CN_OK);
	return body;
}

static inline cn_shape make_ball(cn_body body)
{
	cn_shape shape = 0;
	reset();
	sd.body = body;
	CHECK(cn_shape_create_circle(W, &sd, &circle, &shape) == CN_OK);
	return shape;
}

static inline int bad_handles(uint32_t *out, uint32_t stale, uint32_t other_a, uint32_t other_b, int32_t (*is_valid)(const cn_world *, uint32_t))
{
	uint32_t state = 12345u;
	int count = 0;
	out[count++] = 0;
	out[count++] = stale;
	out[count++] = other_a;
	out[count++] = other_b;
	out[count++] = 0xFFFFFFFFu;
	while (count < BAD_HANDLES) {
		uint32_t bits = random_next(&state);
		if (count & 1)
			bits &= 0xFFF0000Fu; /* small indices with any generation and kind */
		if (!is_valid(W, bits))
			out[count++] = bits;
	}
	return count;
}

/* Ground with a chain and an edge, a box at rest on it, a ball and a capsule held by joints. */
static inline void fixture_make(int with_hooks)
{
	cn_body stale_body;
	cn_shape stale_shape;
	cn_joint stale_joint = 0;
	int k;
	memset(&f, 0, sizeof f);
	reset();
	if (with_hooks) {
		wd.alloc = test_alloc;
		wd.free = test_free;
	}
	CHECK(cn_world_create(&wd, &f.w) == CN_OK);
	f.ground = make_body(CN_BODY_STATIC, 0.0f, -1.0f);
	f.box = make_body(CN_BODY_DYNAMIC, 0.0f, 0.5f);
	f.ball = make_body(CN_BODY_DYNAMIC, 3.0f, 2.0f);
	f.pill = make_body(CN_BODY_DYNAMIC, 4.0f, 2.0f);
	f.rail = make_body(CN_BODY_KINEMATIC, -6.0f, 3.0f);
	sd.body = f.ground;
	CHECK(cn_shape_create_box(W, &sd, 20.0f, 1.0f, 0.0f, &f.ground_shape) == CN_OK);
	CHECK(cn_shape_create_chain(W, &sd, &chain, &f.chain) == CN_OK);
	CHECK(cn_shape_create_edge(W, &sd, &edge, &f.edge) == CN_OK);
	sd.body = f.box;
	sd.event_mask = (1u << CN_EVENT_KINDS) - 1u;
	CHECK(cn_shape_create_polygon(W, &sd, &polygon, &f.box_shape) == CN_OK);
	f.ball_shape = make_ball(f.ball);
	sd.body = f.pill;
	CHECK(cn_shape_create_capsule(W, &sd, &capsule, &f.pill_shape) == CN_OK);
	f.loose = make_ball(0);
	sd.flags = CN_SHAPE_SENSOR;
	sd.body = 0;
	CHECK(cn_shape_create_circle(W, &sd, &circle, &f.area) == CN_OK);
	CHECK(cn_shape_create_circle(W, &sd, &circle, &f.sensor) == CN_OK);
	cn_area_def_init(&area);
	CHECK(cn_shape_set_area(W, f.area, &area) == CN_OK);
	reset();
	rd.base.body_a = f.ball;
	rd.base.anchor_a_m = v2(1.0f, 0.0f);
	CHECK(cn_joint_create_revolute(W, &rd, &f.pin) == CN_OK);
	dd.base.body_b = f.ball;
	dd.base.anchor_a_m = v2(3.0f, 4.0f);
	dd.length_m = 2.0f;
	CHECK(cn_joint_create_distance(W, &dd, &f.rope) == CN_OK);
	stale_body = make_body(CN_BODY_DYNAMIC, 9.0f, 9.0f);
	stale_shape = make_ball(stale_body);
	reset();
	rd.base.body_a = stale_body;
	CHECK(cn_joint_create_revolute(W, &rd, &stale_joint) == CN_OK);
	CHECK(cn_body_destroy(W, stale_body) == CN_OK);
	f.bad_body_count = bad_handles(f.bad_bodies, stale_body, f.box_shape, f.pin, cn_body_is_valid);
	f.bad_shape_count = bad_handles(f.bad_shapes, stale_shape, f.box, f.pin, cn_shape_is_valid);
	f.bad_joint_count = bad_handles(f.bad_joints, stale_joint, f.box, f.box_shape, cn_joint_is_valid);
	for (k = 0; k < 12; ++k)
		CHECK(cn_world_step(W, 1.0f / 60.0f) == CN_OK);
	reset();
}

static inline void fixture_free(void)
{
	cn_world_destroy(f.w);
	f.w = NULL;
}

/* ------------------------------------------------------------------ what a failed call may not change */

typedef struct state {
	uint64_t hash;
	uint64_t records;
	cn_counters counters;
} state;

static inline uint64_t fnv(uint64_t hash, const void *data, size_t bytes)
{
	const unsigned char *p = data;
	size_t k;
	for (k = 0; k < bytes; ++k)
		hash = (hash ^ p[k]) * 1099511628211u;
	return hash;
}

static inline uint64_t fnv_table(uint64_t hash, const cni_handles *handles, const cni_table *table)
{
	int32_t k;
	hash = fnv(hash, handles->slots.data, (size_t)handles->slots.count * sizeof(uint32_t));
	for (k = 0; k < cni_handles_used(handles); ++k)
		if (cni_handles_alive(handles, k))
			hash = fnv(hash, cni_table_at(table, k), (size_t)table->item_bytes);
	return hash;
}

/* Everything that lasts but for capacities, addresses and the error sentence. */
static inline state state_of(const cn_world *world)
{
	state s;
	uint64_t h = 14695981039346656037u;
	int32_t k;
	CHECK(cn_world_hash(world, &s.hash) == CN_OK);
	CHECK(cn_world_get_counters(world, &s.counters) == CN_OK);
	h = fnv(h, &world->settings, sizeof world->settings);
	h = fnv(h, &world->user_data, sizeof world->user_data);
	h = fnv(h, world->events.callback, sizeof world->events.callback);
	h = fnv(h, world->events.callback_user, sizeof world->events.callback_user);
	for (k = 0; k < CN_EVENT_KINDS; ++k)
		h = fnv(h, &world->events.pending[k].count, sizeof(int32_t));
	h = fnv_table(h, &world->body_handles, &world->bodies);
	h = fnv_table(h, &world->shape_handles, &world->shapes);
	h = fnv_table(h, &world->joint_handles, &world->joints);
	h = fnv(h, world->motion.data, (size_t)world->motion.count * sizeof(cni_motion));
	h = fnv(h, world->apart.data, (size_t)world->apart.count * sizeof(int32_t));
	s.records = h;
	return s;
}

/* By members: a copy of the struct need not keep the padding behind its counters. */
static inline int state_differs(const state *a, const state *b)
{
	return a->hash != b->hash || a->records != b->records || memcmp(&a->counters, &b->counters, sizeof a->counters) != 0;
}

static inline void check_valid(const char *after)
{
	char text[192] = "";
	if (cn_world_validate(W, text, (int32_t)sizeof text) != CN_OK) {
		printf("  after %s: %s\n", after, text);
		test_fail(__FILE__, __LINE__, "world is not valid");
	}
}

static inline const cn_body *three(cn_body a, cn_body b, cn_body c)
{
	static cn_body list[3];
	list[0] = a;
	list[1] = b;
	list[2] = c;
	return list;
}

#endif
