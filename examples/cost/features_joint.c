/*
 * examples/cost/features_joint.c - every kind of joint and of constraint on one body, between boxes that float and turn
 * (cost.h); limits, motors, springs, bounds and breaking of one kind.
 */
#include "cost/cost.h"

/* Anchors in the middle between the two boxes, which are 2 m apart. */
static void join(cn_joint_base *base, cn_body a, cn_body b)
{
	base->body_a = a;
	base->body_b = b;
	base->anchor_a_m = scene_vec(0.0f, 1.0f);
	base->anchor_b_m = scene_vec(0.0f, -1.0f);
}

static cn_vec2 where(cost_world *w, cn_body body)
{
	cn_pose pose = {{0.0f, 0.0f}, 1.0f, 0.0f};
	scene_check(&w->run, cn_body_get_pose(w->run.world, body, &pose));
	return pose.position_m;
}

static cn_joint add_revolute(cost_world *w, cn_body a, cn_body b, uint32_t flags)
{
	cn_joint joint = 0;
	cn_revolute_def def;
	cn_revolute_def_init(&def);
	join(&def.base, a, b);
	def.base.flags = flags;
	def.lower_angle_rad = -0.1f;
	def.upper_angle_rad = 0.1f;
	def.motor_speed_radps = 0.1f;
	def.motor_torque_max_Nm = 0.1f;
	def.spring_hertz = 1.0f;
	def.spring_damping_ratio = 0.2f;
	scene_check(&w->run, cn_joint_create_revolute(w->run.world, &def, &joint));
	return joint;
}

static void revolute(cost_world *w, cn_body a, cn_body b) { add_revolute(w, a, b, 0); }
static void revolute_limit(cost_world *w, cn_body a, cn_body b) { add_revolute(w, a, b, CN_JOINT_LIMIT); }
static void revolute_motor(cost_world *w, cn_body a, cn_body b) { add_revolute(w, a, b, CN_JOINT_MOTOR); }
static void revolute_spring(cost_world *w, cn_body a, cn_body b) { add_revolute(w, a, b, CN_JOINT_SPRING); }

static void revolute_soft(cost_world *w, cn_body a, cn_body b)
{
	cn_joint joint = add_revolute(w, a, b, 0);
	scene_check(&w->run, cn_joint_set_solver(w->run.world, joint, CN_SOLVER_SOFT));
}

static void change_base(cost_world *w, cn_joint joint, float break_N, float most_N)
{
	cn_joint_base base;
	scene_check(&w->run, cn_joint_get_base(w->run.world, joint, &base));
	base.break_force_N = break_N;
	base.force_max_N = most_N;
	scene_check(&w->run, cn_joint_set_base(w->run.world, joint, &base));
}

static void revolute_breaking(cost_world *w, cn_body a, cn_body b)
{
	change_base(w, add_revolute(w, a, b, CN_JOINT_BREAKS), 1000.0f, CN_DEFAULT);
}

static void revolute_bounded(cost_world *w, cn_body a, cn_body b)
{
	change_base(w, add_revolute(w, a, b, 0), CN_DEFAULT, 1000.0f);
}

static void distance(cost_world *w, cn_body a, cn_body b)
{
	cn_distance_def def;
	cn_joint made;
	cn_distance_def_init(&def);
	def.base.body_a = a;
	def.base.body_b = b;
	def.length_m = 2.0f;
	scene_check(&w->run, cn_joint_create_distance(w->run.world, &def, &made));
}

static void fixed(cost_world *w, cn_body a, cn_body b)
{
	cn_fixed_def def;
	cn_joint made;
	cn_fixed_def_init(&def);
	join(&def.base, a, b);
	scene_check(&w->run, cn_joint_create_fixed(w->run.world, &def, &made));
}

static void prismatic(cost_world *w, cn_body a, cn_body b)
{
	cn_prismatic_def def;
	cn_joint made;
	cn_prismatic_def_init(&def);
	join(&def.base, a, b);
	scene_check(&w->run, cn_joint_create_prismatic(w->run.world, &def, &made));
}

static void wheel(cost_world *w, cn_body a, cn_body b)
{
	cn_wheel_def def;
	cn_joint made;
	cn_wheel_def_init(&def);
	join(&def.base, a, b);
	def.base.flags = CN_JOINT_SPRING;
	scene_check(&w->run, cn_joint_create_wheel(w->run.world, &def, &made));
}

static void motor(cost_world *w, cn_body a, cn_body b)
{
	cn_motor_def def;
	cn_joint made;
	cn_motor_def_init(&def);
	join(&def.base, a, b);
	def.base.force_max_N = def.base.torque_max_Nm = 10.0f;
	scene_check(&w->run, cn_joint_create_motor(w->run.world, &def, &made));
}

static void mouse(cost_world *w, cn_body a, cn_body b)
{
	cn_mouse_def def;
	cn_joint made;
	cn_mouse_def_init(&def);
	(void)b;
	def.base.body_b = a;
	def.base.force_max_N = 10.0f;
	def.target_m = where(w, a);
	scene_check(&w->run, cn_joint_create_mouse(w->run.world, &def, &made));
}

static void gear(cost_world *w, cn_body a, cn_body b)
{
	cn_gear_def def;
	cn_joint made;
	cn_gear_def_init(&def);
	def.base.body_a = a;
	def.base.body_b = b;
	scene_check(&w->run, cn_joint_create_gear(w->run.world, &def, &made));
}

static void pulley(cost_world *w, cn_body a, cn_body b)
{
	cn_pulley_def def;
	cn_joint made;
	cn_vec2 at = where(w, a);
	cn_pulley_def_init(&def);
	def.base.body_a = a;
	def.base.body_b = b;
	def.ground_a_m = scene_vec(at.x - 3.0f, at.y);
	def.ground_b_m = scene_vec(at.x - 3.0f, at.y + 2.0f);
	def.length_m = 6.0f;
	scene_check(&w->run, cn_joint_create_pulley(w->run.world, &def, &made));
}

static void ratchet(cost_world *w, cn_body a, cn_body b)
{
	cn_ratchet_def def;
	cn_joint made;
	cn_ratchet_def_init(&def);
	def.base.body_a = a;
	def.base.body_b = b;
	def.click_rad = 0.1f;
	scene_check(&w->run, cn_joint_create_ratchet(w->run.world, &def, &made));
}

static void rotary_spring(cost_world *w, cn_body a, cn_body b)
{
	cn_rotary_spring_def def;
	cn_joint made;
	cn_rotary_spring_def_init(&def);
	def.base.body_a = a;
	def.base.body_b = b;
	scene_check(&w->run, cn_joint_create_rotary_spring(w->run.world, &def, &made));
}

static void groove(cost_world *w, cn_body a, cn_body b)
{
	cn_groove_def def;
	cn_joint made;
	cn_groove_def_init(&def);
	join(&def.base, a, b);
	def.base.anchor_a_m = scene_vec(-0.5f, 1.0f);
	def.end_m = scene_vec(0.5f, 1.0f);
	scene_check(&w->run, cn_joint_create_groove(w->run.world, &def, &made));
}

static void filter(cost_world *w, cn_body a, cn_body b)
{
	cn_filter_joint_def def;
	cn_joint made;
	cn_filter_joint_def_init(&def);
	def.base.body_a = a;
	def.base.body_b = b;
	scene_check(&w->run, cn_joint_create_filter(w->run.world, &def, &made));
}

static void angle_limit(cost_world *w, cn_body a, cn_body b)
{
	cn_angle_constraint_def def;
	cn_constraint made;
	cn_angle_constraint_def_init(&def);
	(void)b;
	def.body = a;
	def.lower_rad = -0.1f;
	def.upper_rad = 0.1f;
	scene_check(&w->run, cn_constraint_create_angle(w->run.world, &def, &made));
}

static void line(cost_world *w, cn_body a, cn_body b)
{
	cn_line_constraint_def def;
	cn_constraint made;
	cn_line_constraint_def_init(&def);
	(void)b;
	def.body = a;
	def.origin_m = where(w, a);
	scene_check(&w->run, cn_constraint_create_line(w->run.world, &def, &made));
}

#define TEN COST_PAIRS, 1, 0, NULL, NULL, NULL, NULL
const cost_feature cost_joint_features[] = {
	{"revolute", "10", TEN, revolute},
	{"revolute with limit", "10", TEN, revolute_limit},
	{"revolute with motor", "10", TEN, revolute_motor},
	{"revolute with spring", "10", TEN, revolute_spring},
	{"revolute that may break", "10", TEN, revolute_breaking},
	{"revolute of bounded force", "10", TEN, revolute_bounded},
	{"solver of a joint", "SOFT for 10 revolutes", TEN, revolute_soft},
	{"distance", "10", TEN, distance},
	{"fixed", "10", TEN, fixed},
	{"prismatic", "10", TEN, prismatic},
	{"wheel", "10", TEN, wheel},
	{"motor", "10", TEN, motor},
	{"mouse", "10", TEN, mouse},
	{"gear", "10", TEN, gear},
	{"pulley", "10", TEN, pulley},
	{"ratchet", "10", TEN, ratchet},
	{"rotary spring", "10", TEN, rotary_spring},
	{"groove", "10", TEN, groove},
	{"filter joint", "10", TEN, filter},
	{"angle limit on a body", "10", TEN, angle_limit},
	{"line for a body", "10", TEN, line},
};
const int32_t cost_joint_feature_count = (int32_t)(sizeof cost_joint_features / sizeof cost_joint_features[0]);
