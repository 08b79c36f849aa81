/*
 * test/arch/scenes.h - eight small worlds with everything that computes: every shape, joint, solver, tier, query, event, and the bytes of a
 * file; a number for each. They need cairn.h only, so that they also run without an operating system (board.c).
 *
 * A number is the FNV-1a digest of 32-bit words, which are the same whatever the byte order: state hashes, floats as bits, and
 * counts. arch_expected holds the numbers that every processor, compiler and option must give.
 */
#ifndef CAIRN_TEST_ARCH_SCENES_H
#define CAIRN_TEST_ARCH_SCENES_H

#include "cairn.h"

#include <string.h>

/* Definitions of worlds come from the program: it chooses the memory. */
static void arch_world_def(cn_world_def *def);

static int32_t arch_failed_line; /* of the first call that failed; 0: none */

#define MUST(call) arch_must(call, __LINE__)
static void arch_must(cn_result result, int32_t line)
{
	if (result != CN_OK && arch_failed_line == 0)
		arch_failed_line = line;
}

/* ---- digests ---- */

static uint64_t arch_digest;

/* What must occur in some scene, else the numbers say less than they promise: tiers, contact events, then the rest. */
enum {
	SEEN_TIER = 0,
	SEEN_EVENT = 3,
	SEEN_SENSOR = 9,
	SEEN_BROKEN,
	SEEN_YIELDED,
	SEEN_ASLEEP,
	SEEN_REFUSED,
	SEEN_COUNT
};
#define ARCH_SEEN_ALL ((1u << SEEN_COUNT) - 1u)
static uint32_t arch_seen;

static void see(int32_t what) { arch_seen |= 1u << what; }

static void mix(uint32_t word)
{
	int32_t byte;
	for (byte = 0; byte < 4; ++byte)
		arch_digest = (arch_digest ^ (word >> 8 * byte & 0xFFu)) * 0x100000001B3u;
}

static void mix_float(float x)
{
	uint32_t bits;
	memcpy(&bits, &x, sizeof bits);
	mix(bits);
}

static void mix_vec2(cn_vec2 v)
{
	mix_float(v.x);
	mix_float(v.y);
}

static void mix_world(const cn_world *world)
{
	uint64_t hash = 0;
	MUST(cn_world_hash(world, &hash));
	mix((uint32_t)hash);
	mix((uint32_t)(hash >> 32));
}

/* ---- building ---- */

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

/* ---- joints ---- */

#define BASE(def) ((def).base.body_a = a, (def).base.body_b = b, (def).base.anchor_a_m = vec2(0.3f, 0.0f), (def).base.anchor_b_m = vec2(-0.3f, 0.0f))

static cn_joint joint_any(cn_world *world, int32_t type, cn_body a, cn_body b, float x)
{
	cn_joint joint = 0;
	cn_revolute_def revolute;
	cn_distance_def distance;
	cn_fixed_def fixed;
	cn_prismatic_def prismatic;
	cn_wheel_def wheel;
	cn_motor_def motor;
	cn_mouse_def mouse;
	cn_gear_def gear;
	cn_pulley_def pulley;
	cn_ratchet_def ratchet;
	cn_rotary_spring_def spring;
	cn_groove_def groove;
	cn_filter_joint_def filter;
	switch (type) {
	case CN_JOINT_REVOLUTE:
		cn_revolute_def_init(&revolute);
		BASE(revolute);
		revolute.base.flags = CN_JOINT_LIMIT | CN_JOINT_MOTOR;
		revolute.lower_angle_rad = -1.0f;
		revolute.upper_angle_rad = 1.0f;
		revolute.motor_speed_radps = 2.0f;
		revolute.motor_torque_max_Nm = 1.0f;
		MUST(cn_joint_create_revolute(world, &revolute, &joint));
		break;
	case CN_JOINT_DISTANCE:
		cn_distance_def_init(&distance);
		BASE(distance);
		distance.base.anchor_a_m.y = 1.0f;
		distance.length_m = 1.2f;
		distance.length_max_m = 1.4f;
		distance.spring_hertz = 3.0f;
		distance.spring_damping_ratio = 0.3f;
		distance.base.flags = CN_JOINT_SPRING | CN_JOINT_LIMIT;
		MUST(cn_joint_create_distance(world, &distance, &joint));
		break;
	case CN_JOINT_FIXED:
		cn_fixed_def_init(&fixed);
		BASE(fixed);
		fixed.angular_hertz = 5.0f;
		fixed.angular_damping_ratio = 0.5f;
		MUST(cn_joint_create_fixed(world, &fixed, &joint));
		break;
	case CN_JOINT_PRISMATIC:
		cn_prismatic_def_init(&prismatic);
		BASE(prismatic);
		prismatic.axis = vec2(1.0f, -0.5f);
		prismatic.base.flags = CN_JOINT_LIMIT | CN_JOINT_SPRING;
		prismatic.lower_m = -0.5f;
		prismatic.upper_m = 0.7f;
		prismatic.spring_hertz = 1.0f;
		MUST(cn_joint_create_prismatic(world, &prismatic, &joint));
		break;
	case CN_JOINT_WHEEL:
		cn_wheel_def_init(&wheel);
		BASE(wheel);
		wheel.base.flags = CN_JOINT_LIMIT | CN_JOINT_SPRING | CN_JOINT_MOTOR;
		wheel.lower_m = -0.3f;
		wheel.upper_m = 0.3f;
		wheel.motor_speed_radps = -4.0f;
		wheel.motor_torque_max_Nm = 0.5f;
		MUST(cn_joint_create_wheel(world, &wheel, &joint));
		break;
	case CN_JOINT_MOTOR_TO:
		cn_motor_def_init(&motor);
		BASE(motor);
		motor.base.force_max_N = motor.base.torque_max_Nm = 30.0f;
		motor.offset_m = vec2(0.2f, 0.1f);
		motor.angle_rad = 0.5f;
		MUST(cn_joint_create_motor(world, &motor, &joint));
		break;
	case CN_JOINT_MOUSE:
		cn_mouse_def_init(&mouse);
		BASE(mouse);
		mouse.base.body_a = 0;
		mouse.base.force_max_N = 50.0f;
		mouse.target_m = vec2(x, 5.0f);
		MUST(cn_joint_create_mouse(world, &mouse, &joint));
		break;
	case CN_JOINT_GEAR:
		cn_gear_def_init(&gear);
		BASE(gear);
		gear.ratio = -1.5f;
		MUST(cn_joint_create_gear(world, &gear, &joint));
		break;
	case CN_JOINT_PULLEY:
		cn_pulley_def_init(&pulley);
		BASE(pulley);
		pulley.ground_a_m = vec2(x - 0.5f, 6.0f);
		pulley.ground_b_m = vec2(x + 0.5f, 6.0f);
		pulley.length_m = 6.0f;
		MUST(cn_joint_create_pulley(world, &pulley, &joint));
		break;
	case CN_JOINT_RATCHET:
		cn_ratchet_def_init(&ratchet);
		BASE(ratchet);
		ratchet.click_rad = 0.2f;
		MUST(cn_joint_create_ratchet(world, &ratchet, &joint));
		break;
	case CN_JOINT_ROTARY_SPRING:
		cn_rotary_spring_def_init(&spring);
		BASE(spring);
		spring.rest_angle_rad = 1.0f;
		MUST(cn_joint_create_rotary_spring(world, &spring, &joint));
		break;
	case CN_JOINT_GROOVE:
		cn_groove_def_init(&groove);
		BASE(groove);
		groove.end_m = vec2(1.0f, 0.2f);
		MUST(cn_joint_create_groove(world, &groove, &joint));
		break;
	default:
		cn_filter_joint_def_init(&filter);
		BASE(filter);
		MUST(cn_joint_create_filter(world, &filter, &joint));
		break;
	}
	return joint;
}

static cn_joint hinge(cn_world *world, cn_body a, float ax, float ay, cn_body b, float bx, float by)
{
	cn_revolute_def def;
	cn_joint joint = 0;
	cn_revolute_def_init(&def);
	def.base.body_a = a;
	def.base.body_b = b;
	def.base.anchor_a_m = vec2(ax, ay);
	def.base.anchor_b_m = vec2(bx, by);
	MUST(cn_joint_create_revolute(world, &def, &joint));
	return joint;
}

static cn_joint arch_joints[CN_JOINT_FILTER + 1];

/* Two boxes a type, every second pair hung up, and the constraints on one body. */
static void add_every_joint(cn_world *world)
{
	cn_angle_constraint_def angle;
	cn_line_constraint_def line;
	cn_constraint constraint;
	int32_t type;
	for (type = 0; type <= CN_JOINT_FILTER; ++type) {
		float x = 1.6f * (float)type - 10.0f;
		cn_body a = box_at(world, CN_BODY_DYNAMIC, x - 0.3f, 3.0f, 0.0f, 0.25f, 0.15f, 2.0f);
		cn_body b = box_at(world, CN_BODY_DYNAMIC, x + 0.3f, 3.0f, 0.0f, 0.25f, 0.15f, 1.0f);
		arch_joints[type] = joint_any(world, type, a, b, x);
		if (type % 2 == 0)
			hinge(world, 0, x - 0.6f, 3.0f, a, -0.3f, 0.0f);
		MUST(cn_body_set_velocity(world, b, 0.3f, 0.0f, 1.0f + (float)type));
	}
	cn_angle_constraint_def_init(&angle);
	angle.body = box_at(world, CN_BODY_DYNAMIC, -8.0f, 5.0f, 0.1f, 0.4f, 0.2f, 1.0f);
	angle.lower_rad = -0.2f;
	angle.upper_rad = 0.3f;
	MUST(cn_constraint_create_angle(world, &angle, &constraint));
	cn_line_constraint_def_init(&line);
	line.body = box_at(world, CN_BODY_DYNAMIC, 8.0f, 5.0f, 0.1f, 0.4f, 0.2f, 1.0f);
	line.anchor_m = vec2(0.3f, 0.0f);
	line.origin_m = vec2(8.0f, 5.0f);
	line.axis = vec2(1.0f, 1.0f);
	line.tolerance_m = 0.05f;
	line.hertz = 4.0f;
	MUST(cn_constraint_create_line(world, &line, &constraint));
}

/* A chain with a heavy end, and equal trees of nine bodies each, which are solved side by side. */
static void add_chain_and_trees(cn_world *world)
{
	cn_body last = 0;
	int32_t k, tree;
	for (k = 0; k < 12; ++k) {
		cn_body link = box_at(world, CN_BODY_DYNAMIC, 0.4f * (float)k + 0.2f, 9.0f, 0.0f, 0.2f, 0.05f, k == 11 ? 200.0f : 2.0f);
		hinge(world, last, last == 0 ? 0.0f : 0.2f, last == 0 ? 9.0f : 0.0f, link, -0.2f, 0.0f);
		last = link;
	}
	for (tree = 0; tree < 5; ++tree) {
		float x = 2.0f * (float)tree - 5.0f;
		cn_body trunk = box_at(world, CN_BODY_DYNAMIC, x, 7.0f, 0.0f, 0.1f, 0.4f, 2.0f);
		for (k = 0; k < 4; ++k) {
			float side = k % 2 ? 1.0f : -1.0f, y = k < 2 ? 0.4f : -0.4f;
			cn_body arm = box_at(world, CN_BODY_DYNAMIC, x + side * 0.3f, 7.0f + y, 0.0f, 0.2f, 0.05f, 2.0f);
			cn_body hand = box_at(world, CN_BODY_DYNAMIC, x + side * 0.7f, 7.0f + y, 0.0f, 0.2f, 0.05f, 2.0f);
			hinge(world, trunk, side * 0.1f, y, arm, -side * 0.2f, 0.0f);
			hinge(world, arm, side * 0.2f, 0.0f, hand, -side * 0.2f, 0.0f);
		}
	}
}

/* ---- the scenes ---- */

static void scene_shapes(void)
{
	cn_world *world = world_of(CN_SOLVER_SOFT, CN_BROADPHASE_TREE);
	cn_body mill;
	add_ground(world);
	mill = box_at(world, CN_BODY_KINEMATIC, 1.0f, 0.8f, 0.0f, 0.8f, 0.1f, 1.0f);
	MUST(cn_body_set_velocity(world, mill, 0.0f, 0.0f, 3.0f));
	add_rain(world, 40);
	steps(world, 150);
	cn_world_destroy(world);
}

static void scene_joints(void)
{
	cn_world *world = world_of(CN_SOLVER_SOFT, CN_BROADPHASE_SWEEP);
	int32_t type;
	add_ground(world);
	add_every_joint(world);
	steps(world, 120);
	for (type = 0; type <= CN_JOINT_FILTER; ++type) {
		cn_vec2 force;
		float torque, position;
		MUST(cn_joint_get_reaction(world, arch_joints[type], &force, &torque));
		mix_vec2(force);
		mix_float(torque);
		if (type != CN_JOINT_FILTER) {
			MUST(cn_joint_get_position(world, arch_joints[type], &position));
			mix_float(position);
		}
	}
	cn_world_destroy(world);
}

static void scene_direct(void)
{
	cn_world *world = world_of(CN_SOLVER_DIRECT, CN_BROADPHASE_SWEEP);
	add_ground(world);
	add_every_joint(world);
	add_chain_and_trees(world);
	steps(world, 60);
	cn_world_destroy(world);
}

static void mix_islands(const cn_world *world)
{
	cn_island_report reports[64];
	int32_t count = 0, k;
	MUST(cn_world_get_islands(world, reports, 64, &count));
	mix((uint32_t)count);
	for (k = 0; k < count && k < 64; ++k) {
		see(SEEN_TIER + reports[k].tier);
		mix((uint32_t)reports[k].tier);
		mix((uint32_t)reports[k].reason);
		mix((uint32_t)reports[k].substeps);
		mix_float(reports[k].residual_m);
	}
}

/* A leaning stack, a loaded pile, an arch of stones, a loaded bridge, figures in the air. */
static void scene_tiers(void)
{
	cn_world *world = world_of(CN_SOLVER_AUTO, CN_BROADPHASE_SWEEP);
	cn_body last = 0;
	int32_t k;
	box_at(world, CN_BODY_STATIC, 0.0f, -0.5f, 0.0f, 30.0f, 0.5f, 1.0f);
	for (k = 0; k < 8; ++k)
		box_at(world, CN_BODY_DYNAMIC, -10.0f + 0.06f * (float)k, 0.25f + 0.5f * (float)k, 0.0f, 0.25f, 0.25f, 1.0f);
	for (k = 0; k < 4; ++k)
		box_at(world, CN_BODY_DYNAMIC, -7.0f, 0.25f + 0.5f * (float)k, 0.0f, 0.25f, 0.25f, 1.0f);
	box_at(world, CN_BODY_DYNAMIC, -7.0f, 2.6f, 0.0f, 0.6f, 0.6f, 100.0f);
	for (k = 0; k < 12; ++k) {
		cn_body plank = box_at(world, CN_BODY_DYNAMIC, 0.5f * (float)k - 2.75f, 4.0f, 0.0f, 0.25f, 0.08f, 2.0f);
		hinge(world, last, last == 0 ? -3.0f : 0.25f, last == 0 ? 4.0f : 0.0f, plank, -0.25f, 0.0f);
		last = plank;
	}
	hinge(world, 0, 3.0f, 4.0f, last, 0.25f, 0.0f);
	for (k = 0; k < 6; ++k)
		box_at(world, CN_BODY_DYNAMIC, 0.7f * (float)k - 1.75f, 4.5f, 0.0f, 0.25f, 0.25f, 3.0f);
	add_chain_and_trees(world);
	for (k = 0; k < 12; ++k) {
		steps(world, 10);
		mix_islands(world);
	}
	cn_world_destroy(world);
}

static void scene_sequential(void)
{
	cn_world *world = world_of(CN_SOLVER_SEQUENTIAL, CN_BROADPHASE_SWEEP);
	add_ground(world);
	add_every_joint(world);
	add_rain(world, 20);
	steps(world, 100);
	cn_world_destroy(world);
}

static void mix_hit(const cn_ray_hit *hit)
{
	mix(hit->shape);
	mix(hit->body);
	mix((uint32_t)hit->child);
	mix_float(hit->fraction);
	mix_vec2(hit->point_m);
	mix_vec2(hit->normal);
	mix_float(hit->depth_m);
}

static void mix_shapes(const cn_shape *shapes, int32_t count)
{
	int32_t k;
	mix((uint32_t)count);
	for (k = 0; k < count && k < 32; ++k)
		mix(shapes[k]);
}

static void query_world(const cn_world *world, int32_t k)
{
	cn_ray_hit hit, hits[32];
	cn_shape shapes[32];
	cn_closest closest;
	cn_polygon moving = hull_of(5, 0.3f, 0.1f);
	cn_circle circle;
	cn_aabb box;
	cn_ray ray;
	int32_t any, count, h;
	ray.origin_m = arch_random_vec2(-8.0f, 8.0f, 0.0f, 6.0f);
	ray.translation_m = arch_random_vec2(-9.0f, 9.0f, -9.0f, 2.0f);
	MUST(cn_world_cast_ray(world, &ray, NULL, &hit));
	mix_hit(&hit);
	MUST(cn_world_cast_ray_any(world, &ray, NULL, &any));
	mix((uint32_t)any);
	MUST(cn_world_cast_ray_all(world, &ray, NULL, hits, 32, &count));
	mix((uint32_t)count);
	for (h = 0; h < count && h < 32; ++h)
		mix_hit(&hits[h]);
	if (k % 3 == 0)
		moving.count = 1 + k % 2; /* a circle, a capsule */
	for (h = 0; h < moving.count; ++h)
		moving.points_m[h] = vec2(moving.points_m[h].x + ray.origin_m.x, moving.points_m[h].y + ray.origin_m.y);
	MUST(cn_world_cast_shape(world, &moving, ray.translation_m.x, ray.translation_m.y, NULL, &hit));
	mix_hit(&hit);
	MUST(cn_world_overlap_polygon(world, &moving, NULL, shapes, 32, &count));
	mix_shapes(shapes, count);
	circle.center_m = ray.origin_m;
	circle.radius_m = 1.0f;
	MUST(cn_world_overlap_circle(world, &circle, NULL, shapes, 32, &count));
	mix_shapes(shapes, count);
	box.lower_m = vec2(ray.origin_m.x - 1.0f, ray.origin_m.y - 0.5f);
	box.upper_m = vec2(ray.origin_m.x + 1.0f, ray.origin_m.y + 0.5f);
	MUST(cn_world_overlap_aabb(world, &box, NULL, shapes, 32, &count));
	mix_shapes(shapes, count);
	MUST(cn_world_overlap_point(world, ray.origin_m.x, ray.origin_m.y, NULL, shapes, 32, &count));
	mix_shapes(shapes, count);
	MUST(cn_world_closest_point(world, ray.origin_m.x, ray.origin_m.y, 10.0f, NULL, &closest));
	mix(closest.shape);
	mix_float(closest.distance_m);
	mix_vec2(closest.point_m);
	mix_vec2(closest.normal);
}

static cn_pose pose_of(int32_t k, float x, float y)
{
	static const cn_vec2 rotations[] = { { 1.0f, 0.0f }, { 0.8f, 0.6f }, { 0.0f, -1.0f }, { -0.6f, 0.8f } };
	cn_pose pose;
	pose.position_m = vec2(x, y);
	pose.cosine = rotations[k % 4].x;
	pose.sine = rotations[k % 4].y;
	return pose;
}

static void query_pair(int32_t k)
{
	cn_polygon a = hull_of(7, 0.5f, 0.0f), b = hull_of(6, 0.4f, k % 2 ? 0.1f : 0.0f);
	cn_vec2 place = arch_random_vec2(-1.5f, 1.5f, -1.5f, 1.5f);
	cn_pose pose_a = pose_of(k, 0.0f, 0.0f), pose_b = pose_of(k + 1, place.x, place.y);
	cn_distance distance;
	cn_manifold manifold;
	cn_ray_hit hit;
	cn_sweep sweep_a, sweep_b;
	cn_impact impact;
	int32_t any, p;
	MUST(cn_polygon_distance(&a, &pose_a, &b, &pose_b, &distance));
	mix_vec2(distance.point_a_m);
	mix_vec2(distance.point_b_m);
	mix_vec2(distance.normal);
	mix_float(distance.distance_m);
	MUST(cn_polygon_collide(&a, &pose_a, &b, &pose_b, 0.5f, &manifold));
	mix_vec2(manifold.normal);
	for (p = 0; p < manifold.point_count; ++p) {
		mix_vec2(manifold.points[p].point_m);
		mix_float(manifold.points[p].separation_m);
		mix(manifold.points[p].feature_id);
	}
	MUST(cn_polygon_cast(&a, &pose_a, &b, &pose_b, -3.0f * pose_b.position_m.x, -3.0f * pose_b.position_m.y, &hit, &any));
	mix((uint32_t)any);
	mix_float(hit.fraction);
	mix_vec2(hit.normal);
	memset(&sweep_a, 0, sizeof sweep_a);
	sweep_a.start = pose_a;
	sweep_b = sweep_a;
	sweep_b.start = pose_of(k + 1, 3.0f, arch_random(-0.5f, 0.5f));
	sweep_b.translation_m = vec2(-5.0f, 0.0f);
	sweep_b.turn_rad = arch_random(-3.0f, 3.0f);
	MUST(cn_polygon_time_of_impact(&a, &sweep_a, &b, &sweep_b, 0.01f, &impact));
	mix((uint32_t)impact.state);
	mix_float(impact.fraction);
	mix_vec2(impact.normal);
}

static void walk(cn_world *world)
{
	cn_mover_def def;
	cn_mover mover;
	int32_t k;
	cn_mover_def_init(&def);
	memset(&mover, 0, sizeof mover);
	mover.position_m = vec2(-7.0f, 4.0f);
	for (k = 0; k < 90; ++k) {
		MUST(cn_world_step(world, 1.0f / 60.0f));
		mover.velocity_mps.x = 4.0f;
		if (k % 30 == 29 && (mover.flags & CN_MOVER_ON_GROUND))
			mover.velocity_mps.y = 6.0f;
		MUST(cn_mover_move(world, &def, 1.0f / 60.0f, &mover));
		mix_vec2(mover.position_m);
		mix_vec2(mover.velocity_mps);
		mix(mover.flags);
		mix_float(mover.squeezed_m);
	}
}

static void mix_outlines(void)
{
	static const cn_vec2 outline[] = { { 0.0f, 0.0f }, { 4.0f, 0.0f }, { 4.0f, 3.0f }, { 2.1f, 1.0f }, { 2.0f, 3.5f }, { 1.0f, 1.5f }, { 0.0f, 3.0f } };
	cn_polygon pieces[5];
	cn_vec2 points[64];
	float values[64];
	int32_t count, k, p;
	MUST(cn_outline_decompose(outline, 7, 1.0f, pieces, 5, &count));
	for (k = 0; k < count; ++k)
		for (p = 0; p < pieces[k].count; ++p)
			mix_vec2(pieces[k].points_m[p]);
	for (k = 0; k < 64; ++k)
		values[k] = arch_random(-1.0f, 1.0f);
	MUST(cn_outline_from_field(values, 64, 8, 0.0f, 0.0f, 0.0f, 0.5f, 0, points, 64, &count));
	MUST(cn_outline_simplify(points, count, 1, 0.1f, points, 64, &count));
	for (k = 0; k < count; ++k)
		mix_vec2(points[k]);
}

static void scene_queries(void)
{
	cn_world *world = world_of(CN_SOLVER_AUTO, CN_BROADPHASE_TREE);
	int32_t k;
	add_ground(world);
	add_rain(world, 30);
	steps(world, 60);
	for (k = 0; k < 60; ++k)
		query_world(world, k);
	for (k = 0; k < 60; ++k)
		query_pair(k);
	walk(world);
	mix_outlines();
	mix_world(world);
	cn_world_destroy(world);
}

static void mix_contact(cn_world *world, const cn_contact_event *event, void *user)
{
	int32_t k;
	(void)world;
	(void)user;
	see(SEEN_EVENT + event->kind);
	mix(event->shape_a);
	mix(event->shape_b);
	mix(event->contact_id);
	mix((uint32_t)event->child_a);
	mix((uint32_t)event->kind);
	mix_float(event->approach_speed_mps);
	mix_float(event->normal_impulse_Ns);
	mix_float(event->friction_impulse_Ns);
	mix_vec2(event->hit_point_m);
	mix_vec2(event->manifold.normal);
	for (k = 0; k < event->manifold.point_count; ++k) {
		mix_vec2(event->manifold.points[k].point_m);
		mix_float(event->manifold.points[k].separation_m);
		mix_float(event->manifold.points[k].normal_impulse_Ns);
	}
}

static int32_t every_third_passes(cn_world *world, const cn_contact_event *contact, void *user)
{
	mix_contact(world, contact, user);
	if (contact->contact_id % 3u == 0u)
		see(SEEN_REFUSED);
	return contact->contact_id % 3u != 0u;
}

static int32_t not_both_of_seven(cn_world *world, cn_shape a, cn_shape b, void *user)
{
	(void)world;
	(void)user;
	mix(a ^ b);
	return (a ^ b) % 7u != 0u;
}

static void mix_events(cn_world *world)
{
	const cn_contact_event *contacts;
	const cn_sensor_event *sensors;
	const cn_joint_event *joints;
	const cn_body_moved *moved;
	const cn_body *asleep;
	int32_t kind, count, k;
	for (kind = 0; kind < CN_EVENT_KINDS; ++kind) {
		MUST(cn_world_contact_events(world, kind, &contacts, &count));
		for (k = 0; k < count; ++k)
			mix_contact(world, &contacts[k], NULL);
	}
	MUST(cn_world_sensor_events(world, &sensors, &count));
	for (k = 0; k < count; ++k) {
		see(SEEN_SENSOR);
		mix(sensors[k].visitor);
		mix((uint32_t)sensors[k].kind);
	}
	MUST(cn_world_joint_events(world, &joints, &count));
	for (k = 0; k < count; ++k) {
		see(joints[k].destroyed ? SEEN_BROKEN : SEEN_YIELDED);
		mix(joints[k].joint);
		mix_float(joints[k].force_N);
		mix_float(joints[k].torque_Nm);
	}
	MUST(cn_world_moved(world, &moved, &count));
	for (k = 0; k < count; ++k) {
		mix(moved[k].body);
		mix_vec2(moved[k].pose.position_m);
		mix_float(moved[k].pose.sine);
	}
	MUST(cn_world_fell_asleep(world, &asleep, &count));
	for (k = 0; k < count; ++k) {
		see(SEEN_ASLEEP);
		mix(asleep[k]);
	}
}

static void add_loud(cn_world *world)
{
	int32_t k;
	for (k = 0; k < 24; ++k) {
		cn_shape_def def = shape_on(body_at(world, CN_BODY_DYNAMIC, arch_random(-6.0f, 6.0f), 2.5f + 0.4f * (float)k, 0.3f * (float)k));
		def.event_mask = (1u << CN_EVENT_KINDS) - 1u;
		def.flags = k % 4 == 0 ? CN_SHAPE_PRE_SOLVE : 0u;
		def.material.restitution = 0.2f;
		add_any_shape(world, k, &def);
	}
}

static void scene_events(void)
{
	cn_world *world = world_of(CN_SOLVER_AUTO, CN_BROADPHASE_SWEEP);
	cn_shape_def sensor = shape_on(add_ground(world));
	cn_explosion_def blast;
	int32_t k;
	sensor.flags = CN_SHAPE_SENSOR;
	sensor.offset_m = vec2(0.0f, 1.0f);
	MUST(cn_shape_create_box(world, &sensor, 3.0f, 1.0f, 0.0f, NULL));
	add_every_joint(world);
	for (k = 0; k < 6; ++k) {
		cn_joint_base base;
		MUST(cn_joint_get_base(world, arch_joints[k], &base));
		base.break_force_N = 6.0f + (float)k;
		MUST(cn_joint_set_base(world, arch_joints[k], &base));
		if (k % 2 == 0)
			MUST(cn_joint_set_flags(world, arch_joints[k], CN_JOINT_BREAKS));
	}
	add_loud(world);
	MUST(cn_world_set_sleep(world, 0.3f, 0.2f));
	MUST(cn_world_set_contact_callback(world, CN_EVENT_ENTER, mix_contact, NULL));
	MUST(cn_world_set_pre_solve_callback(world, every_third_passes, NULL));
	MUST(cn_world_set_filter_callback(world, not_both_of_seven, NULL));
	cn_explosion_def_init(&blast);
	blast.radius_m = 2.0f;
	blast.falloff_m = 3.0f;
	blast.impulse_Nspm = 3.0f;
	for (k = 0; k < 120; ++k) {
		if (k % 40 == 35)
			MUST(cn_world_explode(world, &blast));
		MUST(cn_world_step(world, 1.0f / 60.0f));
		mix_events(world);
	}
	mix_world(world);
	cn_world_destroy(world);
}

#define ARCH_FILE_BYTES (512 * 1024)
static unsigned char arch_file[ARCH_FILE_BYTES];

/* The bytes of a file with everything in it; the world that is read goes on like the one that was written. */
static void scene_file(void)
{
	cn_world *world = world_of(CN_SOLVER_AUTO, CN_BROADPHASE_TREE), *read = NULL;
	cn_world_def def;
	uint64_t bytes = 0, k, hashes[2];
	add_ground(world);
	add_every_joint(world);
	add_loud(world);
	steps(world, 50);
	MUST(cn_world_shift_origin(world, 3.5f, -0.25f));
	MUST(cn_world_write(world, arch_file, sizeof arch_file, &bytes));
	for (k = 0; k < bytes; ++k)
		arch_digest = (arch_digest ^ arch_file[k]) * 0x100000001B3u;
	arch_world_def(&def);
	MUST(cn_world_read(&def, arch_file, bytes, &read));
	steps(world, 30);
	for (k = 1; k <= 30; ++k)
		MUST(cn_world_step(read, k % 7 == 0 ? 1.0f / 90.0f : 1.0f / 60.0f));
	MUST(cn_world_hash(world, &hashes[0]));
	MUST(cn_world_hash(read, &hashes[1]));
	MUST(hashes[0] == hashes[1] ? CN_OK : CN_ERROR_INTERNAL);
	cn_world_destroy(read);
	cn_world_destroy(world);
}

#undef BASE

typedef struct arch_scene {
	const char *name;
	void (*run)(void);
	uint64_t expected;
} arch_scene;

#define ARCH_SCENES 8
static const arch_scene arch_scenes[ARCH_SCENES] = {
	{ "shapes", scene_shapes, 0x8dcef6ef56fd76e0 },
	{ "joints", scene_joints, 0x2dbc28ffab5549af },
	{ "direct", scene_direct, 0xcb1eb9674c812141 },
	{ "tiers", scene_tiers, 0x4eb563300105c5fd },
	{ "sequential", scene_sequential, 0x746ccf2319ea4fb2 },
	{ "queries", scene_queries, 0x8f88edf789c0a19f },
	{ "events", scene_events, 0x0e5f511f50955281 },
	{ "file", scene_file, 0xf5a49594443d183c },
};

/* The number of a scene; 0 if a call failed: arch_failed_line. */
static uint64_t arch_number(const arch_scene *scene)
{
	arch_failed_line = 0;
	arch_digest = 0xCBF29CE484222325u;
	scene->run();
	return arch_failed_line == 0 ? arch_digest : 0;
}

#endif
