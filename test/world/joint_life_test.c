/*
 * test/world/joint_life_test.c - what joints do to the rest of a world, and what is done to them: pairs that do not
 * collide, islands that sleep and wake, definitions that are read and replaced, bodies that are destroyed or disabled.
 *
 * If a test here fails, look first in: model/joint.c (lists, sleep, collide), model/island.c, world/joint*.c (setters).
 */
#include "joints.h"

/* ---- collide flag ---- */

static int32_t touching(const cn_world *world, cn_body body)
{
	cn_contact_event contacts[8];
	int32_t count = 0, k, n = 0;
	must(cn_body_get_contacts(world, body, contacts, 8, &count), world, "cn_body_get_contacts");
	for (k = 0; k < count && k < 8; ++k)
		n += contacts[k].kind == CN_EVENT_STAY;
	return n;
}

static void collide_flag_decides(void)
{
	cn_world *world = fixture_world(0.0f, 0);
	cn_body a = fixture_box(world, CN_BODY_DYNAMIC, 0.0f, 0.0f, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f);
	cn_body b = fixture_box(world, CN_BODY_DYNAMIC, 0.99f, 0.0f, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f);
	cn_joint joint, second;
	uint32_t flags = 99;
	fixture_step(world, 1);
	CHECK(touching(world, a) == 1);
	joint = hinge(world, a, at(0.495f, 0.0f), b, at(-0.495f, 0.0f));
	CHECK(touching(world, a) == 0);
	fixture_step(world, 2);
	CHECK(touching(world, a) == 0);
	must(cn_joint_set_flags(world, joint, CN_JOINT_COLLIDE), world, "cn_joint_set_flags");
	must(cn_joint_get_flags(world, joint, &flags), world, "cn_joint_get_flags");
	CHECK(flags == CN_JOINT_COLLIDE);
	fixture_step(world, 1);
	CHECK(touching(world, a) == 1);
	second = hinge(world, b, at(-0.495f, 0.1f), a, at(0.495f, 0.1f)); /* one joint that forbids is enough */
	CHECK(touching(world, a) == 0);
	fixture_step(world, 1);
	CHECK(touching(world, a) == 0);
	must(cn_joint_destroy(world, second), world, "cn_joint_destroy");
	fixture_step(world, 1);
	CHECK(touching(world, a) == 1);
	must(cn_joint_set_flags(world, joint, 0), world, "cn_joint_set_flags");
	CHECK(touching(world, a) == 0);
	must(cn_joint_destroy(world, joint), world, "cn_joint_destroy");
	fixture_step(world, 1);
	CHECK(touching(world, a) == 1);
	CHECK(fixture_is_valid(world));
	cn_world_destroy(world);
}

/* ---- sleep ---- */

typedef struct sleepers {
	cn_world *world;
	cn_body ground, left, right;
	cn_joint joint; /* 0 at first */
} sleepers;

/* Two boxes at rest, one on each other side of nothing, asleep. */
static sleepers make_sleepers(int32_t type)
{
	sleepers s;
	s.world = fixture_world(-10.0f, 1);
	s.ground = fixture_floor(s.world, 0.6f, 0.0f);
	s.left = fixture_box(s.world, CN_BODY_DYNAMIC, -1.0f, 0.5f, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f);
	s.right = fixture_box(s.world, CN_BODY_DYNAMIC, 1.0f, 0.5f, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f);
	s.joint = 0;
	if (type == 0)
		s.joint = hinge(s.world, s.left, at(1.0f, 0.0f), s.right, at(-1.0f, 0.0f));
	if (type == 1) {
		cn_distance_def def = distance_def(s.left, at(0.0f, 0.0f), s.right, at(0.0f, 0.0f), 2.0f);
		def.base.flags = CN_JOINT_LIMIT | CN_JOINT_SPRING;
		def.length_max_m = 3.0f;
		s.joint = make_distance(s.world, &def);
	}
	fixture_step(s.world, 180);
	return s;
}

static int32_t both_awake(const sleepers *s)
{
	return fixture_is_awake(s->world, s->left) && fixture_is_awake(s->world, s->right);
}

static int32_t both_asleep(const sleepers *s)
{
	return !fixture_is_awake(s->world, s->left) && !fixture_is_awake(s->world, s->right);
}

static void joints_made_and_destroyed_while_asleep_wake(void)
{
	sleepers s = make_sleepers(-1);
	cn_joint joint;
	CHECK(both_asleep(&s));
	joint = hinge(s.world, s.left, at(1.0f, 0.0f), s.right, at(-1.0f, 0.0f));
	CHECK(both_awake(&s));
	CHECK(fixture_is_valid(s.world));
	fixture_step(s.world, 180);
	CHECK(both_asleep(&s));
	CHECK(fixture_counters(s.world).joints_awake == 0);
	must(cn_body_set_awake(s.world, s.left, 1), s.world, "cn_body_set_awake");
	CHECK(both_awake(&s)); /* one island */
	CHECK(fixture_counters(s.world).joints_awake == 1);
	fixture_step(s.world, 180);
	CHECK(both_asleep(&s));
	must(cn_joint_destroy(s.world, joint), s.world, "cn_joint_destroy");
	CHECK(both_awake(&s));
	CHECK(fixture_is_valid(s.world));
	fixture_step(s.world, 180);
	CHECK(both_asleep(&s));
	must(cn_body_set_awake(s.world, s.left, 1), s.world, "cn_body_set_awake");
	CHECK(fixture_is_awake(s.world, s.left) && !fixture_is_awake(s.world, s.right)); /* two islands */
	CHECK(fixture_is_valid(s.world));
	cn_world_destroy(s.world);
}

/* A joint to the world or to a static body does not keep a body awake nor tie islands together. */
static void joints_to_the_world_sleep(void)
{
	cn_world *world = fixture_world(-10.0f, 1);
	cn_body post = fixture_body(world, CN_BODY_STATIC, 0.0f, 5.0f, 0.0f), weights[3];
	int32_t k;
	for (k = 0; k < 3; ++k) {
		weights[k] = fixture_box(world, CN_BODY_DYNAMIC, (float)k * 3.0f, 4.0f, 0.0f, 0.2f, 0.2f, 0.6f, 0.0f);
		hinge(world, k == 2 ? 0 : post, k == 2 ? at(6.0f, 5.0f) : at((float)k * 3.0f, 0.0f), weights[k], at(0.0f, 1.0f));
	}
	fixture_step(world, 240);
	for (k = 0; k < 3; ++k)
		CHECK(!fixture_is_awake(world, weights[k]));
	CHECK(fixture_counters(world).joints_awake == 0);
	must(cn_body_set_awake(world, weights[0], 1), world, "cn_body_set_awake");
	CHECK(fixture_is_awake(world, weights[0]) && !fixture_is_awake(world, weights[1]) && !fixture_is_awake(world, weights[2]));
	CHECK(fixture_counters(world).joints_awake == 1);
	CHECK(fixture_is_valid(world));
	cn_world_destroy(world);
}

/* call: 0 set_flags, 1 set_motor, 2 set_limits, 3 replacing the definition. */
static void call_setter(const sleepers *s, int32_t type, int32_t call)
{
	if (call == 0)
		must(cn_joint_set_flags(s->world, s->joint, CN_JOINT_SPRING), s->world, "cn_joint_set_flags");
	if (call == 1)
		must(cn_joint_set_motor(s->world, s->joint, 1.0f, 1.0f), s->world, "cn_joint_set_motor");
	if (call == 2)
		must(cn_joint_set_limits(s->world, s->joint, 0.0f, 1.0f), s->world, "cn_joint_set_limits");
	if (call == 3 && type == 0) {
		cn_revolute_def def;
		must(cn_joint_get_revolute(s->world, s->joint, &def), s->world, "cn_joint_get_revolute");
		CHECK(both_asleep(s));
		must(cn_joint_set_revolute(s->world, s->joint, &def), s->world, "cn_joint_set_revolute");
	}
	if (call == 3 && type == 1) {
		cn_distance_def def;
		must(cn_joint_get_distance(s->world, s->joint, &def), s->world, "cn_joint_get_distance");
		CHECK(both_asleep(s));
		must(cn_joint_set_distance(s->world, s->joint, &def), s->world, "cn_joint_set_distance");
	}
}

static void setters_wake_and_getters_do_not(void)
{
	int32_t type, call;
	for (type = 0; type < 2; ++type)
		for (call = 0; call < 4; ++call) {
			sleepers s = make_sleepers(type);
			CHECK(both_asleep(&s));
			joint_position(s.world, s.joint);
			joint_speed(s.world, s.joint);
			joint_error_m(s.world, s.joint);
			joint_torque(s.world, s.joint);
			must(cn_joint_set_user_data(s.world, s.joint, 5), s.world, "cn_joint_set_user_data");
			CHECK(both_asleep(&s));
			call_setter(&s, type, call);
			CHECK(both_awake(&s));
			CHECK(fixture_is_valid(s.world));
			fixture_step(s.world, 2);
			CHECK(fixture_is_valid(s.world));
			cn_world_destroy(s.world);
		}
}

/* ---- definitions ---- */

static void revolute_definition_goes_round(void)
{
	cn_world *world = fixture_world(-10.0f, 0);
	cn_body a = fixture_circle(world, CN_BODY_DYNAMIC, 0.0f, 0.0f, 0.5f, 0.6f, 0.0f), b = fixture_circle(world, CN_BODY_DYNAMIC, 2.0f, 0.0f, 0.5f, 0.6f, 0.0f);
	cn_revolute_def in = revolute_def(a, at(1.0f, 0.25f), b, at(-1.0f, 0.125f)), out, other;
	cn_body got_a, got_b;
	cn_joint joint;
	int32_t type = -1;
	uint64_t data = 0;
	in.base.flags = CN_JOINT_COLLIDE | CN_JOINT_LIMIT | CN_JOINT_MOTOR | CN_JOINT_SPRING;
	in.base.user_data = 0x123456789ABCDEFu;
	in.reference_angle_rad = 0.1f;
	in.lower_angle_rad = -0.2f;
	in.upper_angle_rad = 0.3f;
	in.motor_speed_radps = 4.0f;
	in.motor_torque_max_Nm = 5.0f;
	in.spring_target_rad = 0.6f;
	in.spring_hertz = 7.0f;
	in.spring_damping_ratio = 0.8f;
	joint = make_revolute(world, &in);
	must(cn_joint_get_revolute(world, joint, &out), world, "cn_joint_get_revolute");
	CHECK(memcmp(&in, &out, sizeof in) == 0);
	must(cn_joint_get_type(world, joint, &type), world, "cn_joint_get_type");
	must(cn_joint_get_bodies(world, joint, &got_a, &got_b), world, "cn_joint_get_bodies");
	must(cn_joint_get_user_data(world, joint, &data), world, "cn_joint_get_user_data");
	CHECK(type == CN_JOINT_REVOLUTE && got_a == a && got_b == b && data == in.base.user_data);
	other = revolute_def(b, at(9.0f, 9.0f), a, at(9.0f, 9.0f)); /* bodies and anchors are ignored */
	other.base.flags = CN_JOINT_MOTOR;
	other.base.user_data = 3;
	other.lower_angle_rad = -1.0f;
	other.motor_speed_radps = 2.0f;
	must(cn_joint_set_revolute(world, joint, &other), world, "cn_joint_set_revolute");
	must(cn_joint_set_motor(world, joint, 2.5f, 3.5f), world, "cn_joint_set_motor");
	must(cn_joint_set_limits(world, joint, -0.5f, 0.5f), world, "cn_joint_set_limits");
	must(cn_joint_get_revolute(world, joint, &out), world, "cn_joint_get_revolute");
	other.base.body_a = a;
	other.base.body_b = b;
	other.base.anchor_a_m = in.base.anchor_a_m;
	other.base.anchor_b_m = in.base.anchor_b_m;
	other.motor_speed_radps = 2.5f;
	other.motor_torque_max_Nm = 3.5f;
	other.lower_angle_rad = -0.5f;
	other.upper_angle_rad = 0.5f;
	CHECK(memcmp(&other, &out, sizeof out) == 0);
	cn_world_destroy(world);
}

static void distance_definition_goes_round(void)
{
	cn_world *world = fixture_world(-10.0f, 0);
	cn_body a = fixture_circle(world, CN_BODY_DYNAMIC, 0.0f, 0.0f, 0.5f, 0.6f, 0.0f);
	cn_distance_def in = distance_def(a, at(1.0f, 0.25f), 0, at(-1.0f, 0.125f), 2.0f), out, other;
	cn_revolute_def wrong;
	cn_joint joint;
	in.base.flags = CN_JOINT_LIMIT | CN_JOINT_SPRING;
	in.base.user_data = 42;
	in.length_min_m = 0.5f;
	in.length_max_m = 3.0f;
	in.motor_speed_mps = 4.0f;
	in.motor_force_max_N = 5.0f;
	in.spring_hertz = 6.0f;
	in.spring_damping_ratio = 0.7f;
	joint = make_distance(world, &in);
	must(cn_joint_get_distance(world, joint, &out), world, "cn_joint_get_distance");
	CHECK(memcmp(&in, &out, sizeof in) == 0);
	CHECK(cn_joint_get_revolute(world, joint, &wrong) == CN_ERROR_STATE);
	other = in;
	other.length_m = 4.0f;
	other.base.flags = 0;
	must(cn_joint_set_distance(world, joint, &other), world, "cn_joint_set_distance");
	must(cn_joint_get_distance(world, joint, &out), world, "cn_joint_get_distance");
	CHECK(memcmp(&other, &out, sizeof out) == 0);
	cn_world_destroy(world);
}

static void destroying_a_body_destroys_its_joints(void)
{
	cn_world *world = fixture_world(-10.0f, 1);
	cn_body links[6];
	cn_joint joints[6], alive[8];
	int32_t count = 0, k;
	make_chain(world, 6, 0.0f, -1.0f, links, joints);
	fixture_step(world, 10);
	must(cn_body_destroy(world, links[2]), world, "cn_body_destroy");
	for (k = 0; k < 6; ++k)
		CHECK(cn_joint_is_valid(world, joints[k]) == (k != 2 && k != 3));
	must(cn_world_get_joints(world, alive, 8, &count), world, "cn_world_get_joints");
	CHECK(count == 4 && fixture_counters(world).joints == 4);
	must(cn_body_get_joints(world, links[3], alive, 8, &count), world, "cn_body_get_joints");
	CHECK(count == 1 && alive[0] == joints[4]);
	CHECK(cn_joint_destroy(world, joints[2]) == CN_ERROR_HANDLE);
	fixture_step(world, 60);
	CHECK(fixture_is_valid(world));
	CHECK((double)fixture_pose(world, links[3]).position_m.y < -4.0); /* cut off: it falls */
	CHECK((double)fixture_pose(world, links[1]).position_m.y > -1.0);
	cn_world_destroy(world);
}

/* Disabled bodies rest their joints; enabling brings them back. */
static void disabling_a_body_rests_its_joints(void)
{
	cn_world *world = fixture_world(-10.0f, 0);
	cn_body links[2];
	cn_joint joints[2];
	make_chain(world, 2, 0.0f, -1.0f, links, joints);
	must(cn_body_set_flags(world, links[0], 0), world, "cn_body_set_flags");
	CHECK(fixture_counters(world).joints_awake == 0);
	fixture_step(world, 30);
	CHECK((double)fixture_pose(world, links[1]).position_m.y < -1.9); /* falls 1.25 m */
	must(cn_body_set_pose(world, links[1], 0.0f, -0.75f, (float)(-0.5 * PI)), world, "cn_body_set_pose");
	fixture_set_velocity(world, links[1], 0.0f, 0.0f, 0.0f);
	must(cn_body_set_flags(world, links[0], CN_BODY_ENABLED), world, "cn_body_set_flags");
	CHECK(fixture_counters(world).joints_awake == 2);
	fixture_step(world, 60);
	CHECK_LE("distance between anchors", worst_joint_error(world), ROUNDING, "m");
	CHECK(fixture_is_valid(world));
	cn_world_destroy(world);
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(collide_flag_decides);
	RUN(joints_made_and_destroyed_while_asleep_wake);
	RUN(joints_to_the_world_sleep);
	RUN(setters_wake_and_getters_do_not);
	RUN(revolute_definition_goes_round);
	RUN(distance_definition_goes_round);
	RUN(destroying_a_body_destroys_its_joints);
	RUN(disabling_a_body_rests_its_joints);
	return test_end();
}
