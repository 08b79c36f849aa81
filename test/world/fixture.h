/*
 * test/world/fixture.h - what tests of whole worlds share: making worlds and plain bodies, stepping, reading.
 * Everything goes through the public API; a call that fails here stops the test program.
 */
#ifndef CAIRN_TEST_FIXTURE_H
#define CAIRN_TEST_FIXTURE_H

#include "cairn.h"
#include "test.h"

#include <math.h>
#include <stdlib.h>

#define FRAME_S (1.0f / 60.0f)

/*
 * Bounds that many tests share, for lengths, speeds and forces of the order of one, and for relative errors.
 *   ROUNDING  the method is exact: what is left is float's 6e-8, some times in each of hundreds of substeps
 *   SOLVED    what iterated, soft constraints leave over; a bound is a multiple of it, some ten times what is measured
 *   SAG_M     what a body sinks at rest on a contact, which is a spring of 1 / (4 h) = 60 Hz: g / w^2 = 0.07 mm
 */
#define ROUNDING 1e-5
#define SOLVED 1e-4
#define SAG_M 2e-4

static inline void must(cn_result result, const cn_world *world, const char *what)
{
	if (result == CN_OK)
		return;
	printf("  fixture: %s: %s (%s)\n", what, cn_result_text(result), world != NULL ? cn_world_error_text(world) : "");
	exit(2);
}

static inline cn_world *fixture_world(float gravity_y, int32_t sleep)
{
	cn_world_def def;
	cn_world *world = NULL;
	cn_world_def_init(&def);
	def.gravity_mps2.x = 0.0f;
	def.gravity_mps2.y = gravity_y;
	if (!sleep)
		def.flags &= ~(uint32_t)CN_WORLD_SLEEP;
	must(cn_world_create(&def, &world), NULL, "cn_world_create");
	return world;
}

static inline cn_body fixture_body(cn_world *world, int32_t type, float x, float y, float angle)
{
	cn_body_def def;
	cn_body body = 0;
	cn_body_def_init(&def);
	def.type = type;
	def.position_m.x = x;
	def.position_m.y = y;
	def.angle_rad = angle;
	must(cn_body_create(world, &def, &body), world, "cn_body_create");
	return body;
}

static inline cn_shape_def fixture_shape_def(cn_body body, float friction, float restitution)
{
	cn_shape_def def;
	cn_shape_def_init(&def);
	def.body = body;
	def.material.static_friction = def.material.dynamic_friction = friction;
	def.material.restitution = restitution;
	return def;
}

static inline cn_shape fixture_box_shape(cn_world *world, const cn_shape_def *def, float hx, float hy)
{
	cn_shape shape = 0;
	must(cn_shape_create_box(world, def, hx, hy, 0.0f, &shape), world, "cn_shape_create_box");
	return shape;
}

static inline cn_body fixture_box(cn_world *world, int32_t type, float x, float y, float angle, float hx, float hy, float friction, float restitution)
{
	cn_body body = fixture_body(world, type, x, y, angle);
	cn_shape_def def = fixture_shape_def(body, friction, restitution);
	fixture_box_shape(world, &def, hx, hy);
	return body;
}

static inline cn_body fixture_circle(cn_world *world, int32_t type, float x, float y, float radius, float friction, float restitution)
{
	cn_body body = fixture_body(world, type, x, y, 0.0f);
	cn_shape_def def = fixture_shape_def(body, friction, restitution);
	cn_circle circle = { { 0.0f, 0.0f }, 0.0f };
	circle.radius_m = radius;
	must(cn_shape_create_circle(world, &def, &circle, NULL), world, "cn_shape_create_circle");
	return body;
}

/* A wide floor whose top is at y = 0. */
static inline cn_body fixture_floor(cn_world *world, float friction, float restitution)
{
	return fixture_box(world, CN_BODY_STATIC, 0.0f, -1.0f, 0.0f, 100.0f, 1.0f, friction, restitution);
}

/* Boxes of 1 m on a floor, `base` in the lowest row, touching each other. */
static inline void fixture_pyramid(cn_world *world, int32_t base)
{
	int32_t i, k;
	fixture_floor(world, 0.6f, 0.0f);
	for (i = 0; i < base; ++i)
		for (k = i; k < base; ++k)
			fixture_box(world, CN_BODY_DYNAMIC, (float)k - 0.5f * (float)i - 0.5f * (float)base, 0.5f + (float)i, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f);
}

/* In order of attachment. */
static inline cn_shape fixture_first_shape(const cn_world *world, cn_body body)
{
	cn_shape shape = 0;
	int32_t count;
	must(cn_body_get_shapes(world, body, &shape, 1, &count), world, "cn_body_get_shapes");
	return shape;
}

static inline void fixture_step(cn_world *world, int32_t steps)
{
	int32_t k;
	for (k = 0; k < steps; ++k)
		must(cn_world_step(world, FRAME_S), world, "cn_world_step");
}

static inline cn_pose fixture_pose(const cn_world *world, cn_body body)
{
	cn_pose pose;
	must(cn_body_get_pose(world, body, &pose), world, "cn_body_get_pose");
	return pose;
}

static inline cn_velocity fixture_velocity(const cn_world *world, cn_body body)
{
	cn_velocity v;
	must(cn_body_get_velocity(world, body, &v), world, "cn_body_get_velocity");
	return v;
}

static inline void fixture_set_velocity(cn_world *world, cn_body body, float vx, float vy, float w)
{
	cn_vec2 v;
	v.x = vx;
	v.y = vy;
	must(cn_body_set_velocity(world, body, v.x, v.y, w), world, "cn_body_set_velocity");
}

static inline cn_counters fixture_counters(const cn_world *world)
{
	cn_counters counters;
	must(cn_world_get_counters(world, &counters), world, "cn_world_get_counters");
	return counters;
}

static inline uint64_t fixture_hash(const cn_world *world)
{
	uint64_t hash = 0;
	must(cn_world_hash(world, &hash), world, "cn_world_hash");
	return hash;
}

static inline int fixture_is_valid(const cn_world *world)
{
	char text[128] = "";
	if (cn_world_validate(world, text, (int32_t)sizeof text) == CN_OK)
		return 1;
	printf("  %s\n", text);
	return 0;
}

static inline int32_t fixture_is_awake(const cn_world *world, cn_body body)
{
	uint32_t flags = 0;
	must(cn_body_get_flags(world, body, &flags), world, "cn_body_get_flags");
	return (flags & CN_BODY_AWAKE) != 0;
}

/* Deepest overlap of touching shapes, in metres. */
static inline float fixture_penetration(const cn_world *world, const cn_body *bodies, int32_t count)
{
	float deepest = 0.0f;
	int32_t k, c, p, contacts;
	cn_contact_event events[64];
	for (k = 0; k < count; ++k) {
		must(cn_body_get_contacts(world, bodies[k], events, 64, &contacts), world, "cn_body_get_contacts");
		for (c = 0; c < contacts && c < 64; ++c)
			for (p = 0; p < events[c].manifold.point_count; ++p)
				if (-events[c].manifold.points[p].separation_m > deepest)
					deepest = -events[c].manifold.points[p].separation_m;
	}
	return deepest;
}

/* xorshift32 (Marsaglia, 2003): the same numbers everywhere. */
/* Arguments are evaluated in an order that each compiler chooses: take one number in a list of them at most. */
static inline float fixture_random(uint32_t *state, float lower, float upper)
{
	*state ^= *state << 13;
	*state ^= *state >> 17;
	*state ^= *state << 5;
	return lower + (upper - lower) * (float)(*state >> 8) / 16777216.0f;
}

#endif
