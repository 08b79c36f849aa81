/*
 * test/arch/joints.h - every joint, and chains and trees of pins.
 */
#ifndef CAIRN_TEST_ARCH_JOINTS_H
#define CAIRN_TEST_ARCH_JOINTS_H

#include "build.h"

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

#undef BASE

#endif
