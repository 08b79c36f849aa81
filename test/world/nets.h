/*
 * test/world/nets.h - square nets of bodies joined to their neighbours by joints of one kind, hung from the world along
 * the top and from a moving bar along one side: many joints of a kind, in many colours, some of them to what cannot move.
 */
#ifndef CAIRN_TEST_NETS_H
#define CAIRN_TEST_NETS_H

#include "joints.h"

enum { NET_PIN, NET_ROD, NET_TIE, NET_WELD, NET_SOFT_WELD, NET_SLIDE, NET_WHEEL, NET_KINDS };

/* Joints with a break threshold, which these never reach, are solved by rows. */
enum { NET_IN_LANES = 0, NET_BY_ROWS = 1 };

static inline const char *net_name(int32_t kind)
{
	static const char *const names[NET_KINDS] = { "pins", "rods", "ties", "welds", "soft welds", "slides", "wheels" };
	return names[kind];
}

static inline cn_joint net_distance(cn_world *world, const cn_joint_base *base, int32_t k, int32_t springy)
{
	cn_distance_def def;
	cn_distance_def_init(&def);
	connect(&def.base, base->body_a, base->anchor_a_m, base->body_b, base->anchor_b_m);
	def.base.flags = base->flags;
	def.base.break_force_N = base->break_force_N;
	if (springy) {
		def.base.flags |= k % 3 == 0 ? CN_JOINT_SPRING | CN_JOINT_LIMIT : k % 3 == 1 ? CN_JOINT_SPRING : CN_JOINT_LIMIT | CN_JOINT_MOTOR;
		def.spring_hertz = 8.0f;
		def.spring_damping_ratio = 0.2f;
		def.motor_speed_mps = -0.1f;
		def.motor_force_max_N = 2.0f;
		def.length_min_m = 0.1f;
		def.length_max_m = k % 2 == 0 ? 0.45f : 0.6f;
	}
	def.length_m = 0.4f;
	return make_distance(world, &def);
}

static inline cn_joint net_weld(cn_world *world, const cn_joint_base *base, int32_t soft)
{
	cn_fixed_def def;
	cn_fixed_def_init(&def);
	connect(&def.base, base->body_a, base->anchor_a_m, base->body_b, base->anchor_b_m);
	def.base.flags = base->flags;
	def.base.break_force_N = base->break_force_N;
	def.angular_hertz = soft ? 6.0f : (float)CN_DEFAULT;
	def.angular_damping_ratio = soft ? 0.3f : 0.0f;
	return make_fixed(world, &def);
}

static inline cn_joint net_slide(cn_world *world, const cn_joint_base *base, cn_vec2 axis, int32_t k)
{
	cn_prismatic_def def;
	cn_prismatic_def_init(&def);
	connect(&def.base, base->body_a, base->anchor_a_m, base->body_b, base->anchor_b_m);
	def.axis = axis;
	def.base.flags = base->flags | CN_JOINT_LIMIT | (k % 2 == 0 ? CN_JOINT_SPRING : 0) | (k % 3 == 0 ? CN_JOINT_MOTOR : 0);
	def.base.break_force_N = base->break_force_N;
	def.lower_m = -0.02f;
	def.upper_m = 0.03f;
	def.spring_hertz = 5.0f;
	def.spring_damping_ratio = 0.3f;
	def.spring_target_m = 0.01f;
	def.motor_speed_mps = 0.2f;
	def.motor_force_max_N = 3.0f;
	return make_prismatic(world, &def);
}

static inline cn_joint net_wheel(cn_world *world, const cn_joint_base *base, cn_vec2 axis, int32_t k)
{
	cn_wheel_def def;
	cn_wheel_def_init(&def);
	connect(&def.base, base->body_a, base->anchor_a_m, base->body_b, base->anchor_b_m);
	def.axis = axis;
	def.base.flags = base->flags | CN_JOINT_SPRING | (k % 2 == 0 ? CN_JOINT_LIMIT : 0) | (k % 3 == 0 ? CN_JOINT_MOTOR : 0);
	def.base.break_force_N = base->break_force_N;
	def.lower_m = -0.05f;
	def.upper_m = 0.05f;
	def.spring_hertz = 6.0f;
	def.spring_damping_ratio = 0.4f;
	def.motor_speed_radps = 2.0f;
	def.motor_torque_max_Nm = 0.5f;
	return make_wheel(world, &def);
}

/* Joint k between anchors that are dx and dy apart, (0, 0) or such that they have the length of rods. */
static inline cn_joint net_joint(cn_world *world, int32_t kind, int32_t k, const cn_joint_base *base, cn_vec2 axis)
{
	cn_revolute_def pin;
	switch (kind) {
	case NET_ROD: return net_distance(world, base, k, 0);
	case NET_TIE: return net_distance(world, base, k, 1);
	case NET_WELD: return net_weld(world, base, 0);
	case NET_SOFT_WELD: return net_weld(world, base, 1);
	case NET_SLIDE: return net_slide(world, base, axis, k);
	case NET_WHEEL: return net_wheel(world, base, axis, k);
	default:
		pin = revolute_def(base->body_a, base->anchor_a_m, base->body_b, base->anchor_b_m);
		pin.base.flags = base->flags;
		pin.base.break_force_N = base->break_force_N;
		return make_revolute(world, &pin);
	}
}

/* From body a at (ax, ay), 0 being the world, to body b which is one metre away along (x, y). */
static inline cn_joint net_link(cn_world *world, int32_t kind, int32_t how, int32_t k, cn_body a, cn_vec2 place_a, cn_body b, float x, float y)
{
	float reach = kind == NET_ROD || kind == NET_TIE ? 0.3f : 0.5f;
	cn_joint_base base;
	memset(&base, 0, sizeof base);
	connect(&base, a, at(place_a.x + reach * x, place_a.y + reach * y), b, at(-reach * x, -reach * y));
	base.break_force_N = how == NET_BY_ROWS ? 1e30f : (float)CN_DEFAULT;
	return net_joint(world, kind, k, &base, kind == NET_SLIDE ? at(x, y) : at(y, -x));
}

/* Joints' handles to joints, unless NULL; 2 * side * side of them. */
static inline void net_fill(cn_world *world, int32_t kind, int32_t how, int32_t side, cn_joint *joints)
{
	cn_body *bodies = (cn_body *)malloc(sizeof(cn_body) * (size_t)(side * side));
	cn_body bar = fixture_box(world, CN_BODY_KINEMATIC, -1.0f, -0.5f * (float)side, 0.0f, 0.1f, 0.5f * (float)side, 0.5f, 0.0f);
	cn_joint made[2];
	int32_t i, k, count = 0;
	REQUIRE(bodies != NULL);
	fixture_set_velocity(world, bar, 0.2f, 0.1f, 0.0f);
	for (k = 0; k < side; ++k)
		for (i = 0; i < side; ++i) {
			cn_body body = bodies[k * side + i] = fixture_box(world, CN_BODY_DYNAMIC, (float)i, (float)-k, 0.0f, 0.2f, 0.2f, 0.5f, 0.0f);
			cn_body left = i == 0 ? bar : bodies[k * side + i - 1], above = k == 0 ? 0 : bodies[(k - 1) * side + i];
			fixture_set_velocity(world, body, 0.3f * (float)(i % 5 - 2), 0.2f * (float)(k % 3 - 1), 0.1f * (float)((i + k) % 3 - 1));
			made[0] = net_link(world, kind, how, count, left, at(0.0f, i == 0 ? 0.5f * (float)side - (float)k : 0.0f), body, 1.0f, 0.0f);
			made[1] = net_link(world, kind, how, count + 1, above, at(k == 0 ? (float)i : 0.0f, k == 0 ? 1.0f : 0.0f), body, 0.0f, -1.0f);
			if (joints != NULL)
				memcpy(joints + count, made, sizeof made);
			count += 2;
		}
	free(bodies);
}

#endif
