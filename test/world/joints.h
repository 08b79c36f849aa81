/*
 * test/world/joints.h - what tests of joints share: definitions, making and reading joints, sums over bodies.
 * A joint's side 0 is the world. As in fixture.h, a call that fails stops the test program.
 */
#ifndef CAIRN_TEST_JOINTS_H
#define CAIRN_TEST_JOINTS_H

#include "fixture.h"

#define GRAVITY 10.0
#define PI 3.14159265358979323846

static inline cn_vec2 at(float x, float y)
{
	cn_vec2 v;
	v.x = x;
	v.y = y;
	return v;
}

/* A box of half sizes 0.5 that weighs 1 kg and has inertia 1/6 kg m^2. */
static inline cn_body unit_box(cn_world *world, float x, float y, float angle)
{
	return fixture_box(world, CN_BODY_DYNAMIC, x, y, angle, 0.5f, 0.5f, 0.5f, 0.0f);
}

#define UNIT_INERTIA (1.0 / 6.0)

/* ---- definitions ---- */

static inline void connect(cn_joint_base *base, cn_body a, cn_vec2 anchor_a, cn_body b, cn_vec2 anchor_b)
{
	base->body_a = a;
	base->body_b = b;
	base->anchor_a_m = anchor_a;
	base->anchor_b_m = anchor_b;
}

static inline cn_revolute_def revolute_def(cn_body a, cn_vec2 anchor_a, cn_body b, cn_vec2 anchor_b)
{
	cn_revolute_def def;
	cn_revolute_def_init(&def);
	connect(&def.base, a, anchor_a, b, anchor_b);
	return def;
}

static inline cn_distance_def distance_def(cn_body a, cn_vec2 anchor_a, cn_body b, cn_vec2 anchor_b, float length)
{
	cn_distance_def def;
	cn_distance_def_init(&def);
	connect(&def.base, a, anchor_a, b, anchor_b);
	def.length_m = length;
	return def;
}

/* ---- making ---- */

#define MAKER(name, type) \
	static inline cn_joint make_##name(cn_world *world, const cn_##type *def) \
	{ \
		cn_joint joint = 0; \
		must(cn_joint_create_##name(world, def, &joint), world, "cn_joint_create_" #name); \
		return joint; \
	}
MAKER(revolute, revolute_def)
MAKER(distance, distance_def)
MAKER(fixed, fixed_def)
MAKER(prismatic, prismatic_def)
MAKER(wheel, wheel_def)
MAKER(motor, motor_def)
MAKER(mouse, mouse_def)
MAKER(gear, gear_def)
MAKER(pulley, pulley_def)
MAKER(ratchet, ratchet_def)
MAKER(rotary_spring, rotary_spring_def)
MAKER(groove, groove_def)
MAKER(filter, filter_joint_def)
#undef MAKER

static inline cn_joint hinge(cn_world *world, cn_body a, cn_vec2 anchor_a, cn_body b, cn_vec2 anchor_b)
{
	cn_revolute_def def = revolute_def(a, anchor_a, b, anchor_b);
	return make_revolute(world, &def);
}

/* count links of 0.5 m from the origin along (x, y), hinged end to end. */
static inline void make_chain(cn_world *world, int32_t count, float x, float y, cn_body *bodies, cn_joint *joints)
{
	int32_t k;
	for (k = 0; k < count; ++k) {
		float middle = 0.5f * ((float)k + 0.5f);
		bodies[k] = fixture_box(world, CN_BODY_DYNAMIC, x * middle, y * middle, atan2f(y, x), 0.25f, 0.06f, 0.6f, 0.0f);
		joints[k] = hinge(world, k == 0 ? 0 : bodies[k - 1], k == 0 ? at(0.0f, 0.0f) : at(0.25f, 0.0f), bodies[k], at(-0.25f, 0.0f));
	}
}

/* ---- reading ---- */

static inline double joint_position(const cn_world *world, cn_joint joint)
{
	float position = 0.0f;
	must(cn_joint_get_position(world, joint, &position), world, "cn_joint_get_position");
	return (double)position;
}

static inline double joint_speed(const cn_world *world, cn_joint joint)
{
	float speed = 0.0f;
	must(cn_joint_get_speed(world, joint, &speed), world, "cn_joint_get_speed");
	return (double)speed;
}

static inline double joint_error_m(const cn_world *world, cn_joint joint)
{
	float m = 0.0f, rad = 0.0f;
	must(cn_joint_get_error(world, joint, &m, &rad), world, "cn_joint_get_error");
	return (double)m;
}

static inline double joint_error_rad(const cn_world *world, cn_joint joint)
{
	float m = 0.0f, rad = 0.0f;
	must(cn_joint_get_error(world, joint, &m, &rad), world, "cn_joint_get_error");
	return (double)rad;
}

static inline cn_vec2 joint_force(const cn_world *world, cn_joint joint)
{
	cn_vec2 force;
	float torque = 0.0f;
	must(cn_joint_get_reaction(world, joint, &force, &torque), world, "cn_joint_get_reaction");
	return force;
}

static inline double joint_torque(const cn_world *world, cn_joint joint)
{
	cn_vec2 force;
	float torque = 0.0f;
	must(cn_joint_get_reaction(world, joint, &force, &torque), world, "cn_joint_get_reaction");
	return (double)torque;
}

static inline cn_mass_data mass_of(const cn_world *world, cn_body body)
{
	cn_mass_data m;
	must(cn_body_get_mass_data(world, body, &m), world, "cn_body_get_mass_data");
	return m;
}

static inline double angle_of(const cn_world *world, cn_body body)
{
	cn_pose p = fixture_pose(world, body);
	return atan2((double)p.sine, (double)p.cosine);
}

/* The largest distance between the anchors of a joint of the world. */
static inline double worst_joint_error(const cn_world *world)
{
	double worst = 0.0;
	cn_joint *joints;
	int32_t count = 0, k;
	must(cn_world_get_joints(world, NULL, 0, &count), world, "cn_world_get_joints");
	joints = (cn_joint *)malloc((size_t)count * sizeof *joints);
	must(joints != NULL || count == 0 ? CN_OK : CN_ERROR_MEMORY, NULL, "memory for the list of joints");
	must(cn_world_get_joints(world, joints, count, &count), world, "cn_world_get_joints");
	for (k = 0; k < count; ++k)
		worst = greater(worst, joint_error_m(world, joints[k]));
	free(joints);
	return worst;
}

typedef struct totals {
	double kinetic, potential, px, py, spin, momentum_scale, spin_scale, speed_most, turn_most;
} totals;

/* Sums over bodies; spin is the angular momentum about the origin, the scales are sums of the parts' sizes. */
static inline totals totals_of(const cn_world *world, const cn_body *bodies, int32_t count)
{
	totals t = { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 };
	cn_vec2 gravity;
	int32_t k;
	must(cn_world_get_gravity(world, &gravity), world, "cn_world_get_gravity");
	for (k = 0; k < count; ++k) {
		cn_mass_data m = mass_of(world, bodies[k]);
		cn_velocity v = fixture_velocity(world, bodies[k]);
		double mass = (double)m.mass_kg, vx = (double)v.linear_mps.x, vy = (double)v.linear_mps.y, w = (double)v.angular_radps, turn;
		cn_vec2 c;
		must(cn_body_get_center(world, bodies[k], &c), world, "cn_body_get_center");
		turn = mass * ((double)c.x * vy - (double)c.y * vx);
		t.kinetic += 0.5 * mass * (vx * vx + vy * vy) + 0.5 * (double)m.inertia_kgm2 * w * w;
		t.potential -= mass * (double)gravity.y * (double)c.y;
		t.px += mass * vx;
		t.py += mass * vy;
		t.spin += turn + (double)m.inertia_kgm2 * w;
		t.momentum_scale += mass * sqrt(vx * vx + vy * vy);
		t.spin_scale += fabs(turn) + fabs((double)m.inertia_kgm2 * w);
		t.speed_most = greater(t.speed_most, sqrt(vx * vx + vy * vy));
		t.turn_most = greater(t.turn_most, fabs(w));
	}
	return t;
}

#endif
