/*
 * test/arch/build.h - worlds, bodies and shapes of the scenes, with their own random numbers.
 */
#ifndef CAIRN_TEST_ARCH_BUILD_H
#define CAIRN_TEST_ARCH_BUILD_H

#include "digest.h"

static uint32_t arch_random_state;

static float arch_random(float lower, float upper)
{
	arch_random_state = arch_random_state * 1664525u + 1013904223u;
	return lower + (upper - lower) * ((float)(arch_random_state >> 8) * (1.0f / 16777216.0f));
}

static cn_vec2 vec2(float x, float y)
{
	cn_vec2 v;
	v.x = x;
	v.y = y;
	return v;
}

/* One draw a statement: compilers choose the order of arguments. */
static cn_vec2 arch_random_vec2(float lower_x, float upper_x, float lower_y, float upper_y)
{
	cn_vec2 v;
	v.x = arch_random(lower_x, upper_x);
	v.y = arch_random(lower_y, upper_y);
	return v;
}

static cn_world *world_of(int32_t solver, int32_t broadphase)
{
	cn_world_def def;
	cn_world *world = NULL;
	arch_world_def(&def);
	def.solver = solver;
	def.broadphase = broadphase;
	arch_random_state = 1u;
	MUST(cn_world_create(&def, &world));
	return world;
}

static cn_body body_at(cn_world *world, int32_t type, float x, float y, float angle_rad)
{
	cn_body_def def;
	cn_body body = 0;
	cn_body_def_init(&def);
	def.type = type;
	def.position_m = vec2(x, y);
	def.angle_rad = angle_rad;
	MUST(cn_body_create(world, &def, &body));
	return body;
}

static cn_shape_def shape_on(cn_body body)
{
	cn_shape_def def;
	cn_shape_def_init(&def);
	def.body = body;
	return def;
}

static cn_body box_at(cn_world *world, int32_t type, float x, float y, float angle_rad, float half_width, float half_height, float density)
{
	cn_body body = body_at(world, type, x, y, angle_rad);
	cn_shape_def def = shape_on(body);
	def.density_kgpm2 = density;
	MUST(cn_shape_create_box(world, &def, half_width, half_height, 0.0f, NULL));
	return body;
}

static cn_polygon hull_of(int32_t count, float size, float radius)
{
	cn_vec2 points[8];
	cn_polygon hull;
	int32_t k;
	for (k = 0; k < count; ++k)
		points[k] = arch_random_vec2(-size, size, -size, size);
	points[0] = vec2(-size, -size); /* never collinear */
	points[1] = vec2(size, -size);
	points[2] = vec2(0.0f, size);
	memset(&hull, 0, sizeof hull);
	MUST(cn_polygon_make_hull(points, count, radius, &hull));
	return hull;
}

/* A circle, capsule, polygon, rounded box or compound, by number. */
static void add_any_shape(cn_world *world, int32_t k, const cn_shape_def *def)
{
	cn_shape_def offset = *def;
	cn_circle circle;
	cn_capsule capsule;
	cn_polygon hull;
	circle.center_m = vec2(0.0f, 0.05f * (float)(k % 3));
	circle.radius_m = 0.2f + 0.02f * (float)(k % 7);
	capsule.a_m = vec2(-0.2f, 0.0f);
	capsule.b_m = vec2(0.25f, 0.1f);
	capsule.radius_m = 0.15f;
	switch (k % 5) {
	case 0: MUST(cn_shape_create_circle(world, def, &circle, NULL)); break;
	case 1: MUST(cn_shape_create_capsule(world, def, &capsule, NULL)); break;
	case 2:
		hull = hull_of(8, 0.3f, k % 2 ? 0.0f : 0.05f);
		MUST(cn_shape_create_polygon(world, def, &hull, NULL));
		break;
	case 3: MUST(cn_shape_create_box(world, def, 0.3f, 0.2f, 0.05f, NULL)); break;
	default:
		MUST(cn_shape_create_box(world, def, 0.3f, 0.15f, 0.0f, NULL));
		offset.offset_m = vec2(0.25f, 0.2f);
		offset.angle_rad = 0.5f;
		offset.density_kgpm2 = 3.0f;
		MUST(cn_shape_create_circle(world, &offset, &circle, NULL));
		break;
	}
}

/* Hills as a chain, a loop, a two-sided edge and a floor with a conveyor. */
static cn_body add_ground(cn_world *world)
{
	static const float heights[] = { 3.0f, 0.5f, 0.0f, 0.3f, 0.0f, 0.2f, 0.1f, 0.8f, 3.0f };
	cn_body ground = body_at(world, CN_BODY_STATIC, 0.0f, 0.0f, 0.0f);
	cn_shape_def def = shape_on(ground);
	cn_vec2 points[9], loop[4];
	cn_chain chain;
	cn_edge edge;
	int32_t k;
	for (k = 0; k < 9; ++k)
		points[k] = vec2(8.0f - 2.0f * (float)k, heights[k]);
	chain.points_m = points;
	chain.count = 9;
	chain.loop = 0;
	MUST(cn_shape_create_chain(world, &def, &chain, NULL));
	loop[0] = vec2(-5.0f, 1.5f);
	loop[1] = vec2(-4.0f, 1.2f);
	loop[2] = vec2(-3.8f, 2.0f);
	loop[3] = vec2(-4.6f, 2.2f);
	chain.points_m = loop;
	chain.count = 4;
	chain.loop = 1;
	MUST(cn_shape_create_chain(world, &def, &chain, NULL));
	edge.a_m = vec2(3.0f, 1.5f);
	edge.b_m = vec2(5.0f, 2.0f);
	MUST(cn_shape_create_edge(world, &def, &edge, NULL));
	def.material.tangent_speed_mps = 1.0f;
	def.material.friction_mix = CN_MIX_MAXIMUM;
	def.offset_m = vec2(0.0f, -3.0f);
	MUST(cn_shape_create_box(world, &def, 12.0f, 0.5f, 0.0f, NULL));
	def.offset_m = vec2(0.0f, 2.0f);
	def.material.tangent_speed_mps = 0.0f;
	def.flags = CN_SHAPE_ONE_WAY;
	MUST(cn_shape_create_box(world, &def, 1.5f, 0.1f, 0.0f, NULL));
	return ground;
}

static void add_rain(cn_world *world, int32_t count)
{
	int32_t k;
	for (k = 0; k < count; ++k) {
		cn_vec2 place = arch_random_vec2(-6.0f, 6.0f, -3.0f, 3.0f), velocity = arch_random_vec2(-2.0f, 2.0f, -3.0f, 0.0f);
		cn_body body = body_at(world, CN_BODY_DYNAMIC, place.x, 3.0f + 0.4f * (float)k, place.y);
		cn_shape_def def = shape_on(body);
		def.density_kgpm2 = arch_random(0.5f, 4.0f);
		def.material.static_friction = arch_random(0.3f, 0.9f);
		def.material.dynamic_friction = 0.3f;
		def.material.restitution = k % 4 == 0 ? 0.6f : 0.0f;
		def.material.rolling_resistance = k % 3 == 0 ? 0.01f : 0.0f;
		def.material.friction_mix = k % 5;
		add_any_shape(world, k, &def);
		MUST(cn_body_set_velocity(world, body, velocity.x, velocity.y, arch_random(-5.0f, 5.0f)));
		if (k % 6 == 1)
			MUST(cn_body_set_flags(world, body, CN_BODY_ENABLED | CN_BODY_SLEEP | (k % 4 == 1 ? CN_BODY_LOCK_ROTATION : CN_BODY_BULLET)));
		if (k % 6 == 2)
			MUST(cn_body_set_damping(world, body, 0.3f, 0.2f));
	}
}

static void steps(cn_world *world, int32_t count)
{
	int32_t k;
	for (k = 1; k <= count; ++k) {
		MUST(cn_world_step(world, k % 7 == 0 ? 1.0f / 90.0f : 1.0f / 60.0f));
		if (k % 10 == 0)
			mix_world(world);
	}
}

#endif
