/*
 * test/world/joint_force_test.c - what joints bear: welds under load and their stiffness, bounds on force and torque,
 * thresholds at which they break and the events that tell, and reactions of all types against statics.
 *
 * If a test here fails, look first in: joints/joint_solve.c (bounds, stiffness, breaking), model/event.c,
 * then joints/joint_type.c.
 */
#include "joints.h"

/* ---- fixed ---- */

static void cantilever_of_ten_boxes(void)
{
	cn_world *world = fixture_world(-(float)GRAVITY, 0);
	cn_body last = 0, box = 0;
	cn_joint first = 0;
	double sag, mean = 0.0, m = 0.0, rad = 0.0;
	cn_joint joints[10];
	int32_t k;
	for (k = 0; k < 10; ++k) {
		cn_fixed_def def;
		box = fixture_box(world, CN_BODY_DYNAMIC, 0.5f + (float)k, 0.0f, 0.0f, 0.5f, 0.125f, 0.5f, 0.0f);
		cn_fixed_def_init(&def);
		connect(&def.base, last, last == 0 ? at(0.0f, 0.0f) : at(0.5f, 0.0f), box, at(-0.5f, 0.0f));
		joints[k] = make_fixed(world, &def);
		if (k == 0)
			first = joints[k];
		last = box;
		must(cn_body_set_damping(world, box, 2.0f, 2.0f), world, "cn_body_set_damping"); /* it would swing for minutes */
	}
	for (k = 0; k < 900; ++k) {
		fixture_step(world, 1);
		if (k >= 600)
			mean += -(double)fixture_pose(world, box).position_m.y / 300.0;
	}
	sag = -(double)fixture_pose(world, box).position_m.y;
	for (k = 0; k < 10; ++k) {
		m = greater(m, joint_error_m(world, joints[k]));
		rad = greater(rad, joint_error_rad(world, joints[k]));
	}
	CHECK_LE("sag of the tip of 10 m", mean, ROUNDING, "m");
	CHECK_LE("last sag against its mean over 5 s", fabs(sag - mean), ROUNDING, "m");
	CHECK_LE("largest gap", m, ROUNDING, "m");
	CHECK_LE("largest turn in one weld", rad, ROUNDING, "rad");
	CHECK_LE("force on the wall against the weight", fabs((double)joint_force(world, first).y / (2.5 * GRAVITY) - 1.0), 0.02, "");
	CHECK_LE("torque on the wall against m g l / 2", fabs(joint_torque(world, first) / (2.5 * GRAVITY * 5.0) - 1.0), 5e-3, "");
	cn_world_destroy(world);
}

static void weld_has_its_stiffness(void)
{
	cn_world *world = fixture_world(-(float)GRAVITY, 0);
	cn_body box = unit_box(world, 0.0f, 0.0f, 0.0f), arm = unit_box(world, 5.0f, 0.0f, 0.0f);
	cn_fixed_def def;
	cn_joint soft, twist;
	double w2 = pow(2.0 * PI * 3.0, 2.0);
	int32_t k;
	cn_fixed_def_init(&def);
	connect(&def.base, 0, at(0.0f, 0.0f), box, at(0.0f, 0.0f));
	def.base.stiffness_hertz = 3.0f;
	def.base.stiffness_damping_ratio = 0.5f;
	soft = make_fixed(world, &def);
	connect(&def.base, 0, at(5.0f, 0.0f), arm, at(0.0f, 0.0f));
	def.base.stiffness_hertz = CN_DEFAULT;
	def.angular_hertz = 3.0f;
	def.angular_damping_ratio = 0.5f;
	twist = make_fixed(world, &def);
	for (k = 0; k < 600; ++k) {
		must(cn_body_apply_torque(world, box, 1.0f), world, "cn_body_apply_torque");
		must(cn_body_apply_torque(world, arm, 1.0f), world, "cn_body_apply_torque");
		fixture_step(world, 1);
	}
	CHECK_LE("sag against g / w^2", fabs((double)fixture_pose(world, box).position_m.y + GRAVITY / w2), 1e-5, "m");
	CHECK_LE("twist against T / (I w^2)", fabs(angle_of(world, box) - 1.0 / (UNIT_INERTIA * w2)), 1e-5, "rad");
	CHECK_LE("the same with a rigid point", fabs(angle_of(world, arm) - 1.0 / (UNIT_INERTIA * w2)), 1e-5, "rad");
	CHECK_LE("error of the soft weld read back", fabs(joint_error_m(world, soft) - GRAVITY / w2), 1e-5, "m");
	CHECK_LE("gap of the rigid point", joint_error_m(world, twist), 1e-4, "m");
	CHECK_LE("torque read back", fabs(joint_torque(world, twist) + 1.0), ROUNDING, "Nm");
	cn_world_destroy(world);
}

/* ---- bounds on force ---- */

static void rigid_parts_keep_to_their_force(void)
{
	cn_world *world = fixture_world(0.0f, 0);
	cn_body box = unit_box(world, 0.0f, 0.0f, 0.0f);
	cn_fixed_def def;
	cn_joint joint;
	double most = 0.0, torque = 0.0;
	int32_t k;
	cn_fixed_def_init(&def);
	connect(&def.base, 0, at(0.0f, 0.0f), box, at(0.0f, 0.0f));
	def.base.force_max_N = 10.0f;
	def.base.torque_max_Nm = 2.0f;
	joint = make_fixed(world, &def);
	for (k = 0; k < 120; ++k) {
		must(cn_body_apply_force(world, box, 5.9f, 7.8f), world, "cn_body_apply_force"); /* 9.78 N */
		must(cn_body_apply_torque(world, box, 1.9f), world, "cn_body_apply_torque");
		fixture_step(world, 1);
	}
	CHECK_LE("gap below the bound", joint_error_m(world, joint), 1e-3, "m");
	CHECK_LE("turn below the bound", joint_error_rad(world, joint), 5.0 * SOLVED, "rad");
	for (k = 0; k < 30; ++k) {
		cn_vec2 f;
		must(cn_body_apply_force(world, box, 9.0f, 12.0f), world, "cn_body_apply_force"); /* 15 N */
		must(cn_body_apply_torque(world, box, 1.9f), world, "cn_body_apply_torque");
		fixture_step(world, 1);
		f = joint_force(world, joint);
		most = greater(most, hypot((double)f.x, (double)f.y));
		torque = greater(torque, fabs(joint_torque(world, joint)));
	}
	CHECK_LE("force", most, 10.001, "N");
	CHECK_LE("torque", torque, 2.0001, "Nm");
	CHECK_LE("speed after 0.5 s against (P - F) t / m", fabs(hypot((double)fixture_velocity(world, box).linear_mps.x, (double)fixture_velocity(world, box).linear_mps.y) - 2.5), ROUNDING, "m/s");
	CHECK_LE("turn while the point gives way", joint_error_rad(world, joint), 5.0 * SOLVED, "rad");
	cn_world_destroy(world);
}

static void limits_keep_to_their_force(void)
{
	cn_world *world = fixture_world(-(float)GRAVITY, 0);
	cn_body box = unit_box(world, 0.0f, 0.0f, 0.0f);
	cn_prismatic_def def;
	cn_joint joint;
	cn_joint_base base;
	cn_prismatic_def_init(&def);
	connect(&def.base, 0, at(0.0f, 0.0f), box, at(0.0f, 0.0f));
	def.base.flags = CN_JOINT_LIMIT;
	def.base.force_max_N = 12.0f;
	def.axis = at(0.0f, 1.0f);
	joint = make_prismatic(world, &def);
	fixture_step(world, 120);
	CHECK_LE("sag at 10 of 12 N", fabs(joint_position(world, joint)), 1e-3, "m");
	must(cn_joint_get_base(world, joint, &base), world, "cn_joint_get_base");
	base.force_max_N = 6.0f;
	must(cn_joint_set_base(world, joint, &base), world, "cn_joint_set_base");
	fixture_step(world, 60);
	CHECK_LE("speed after 1 s against (g - F/m) t", fabs(joint_speed(world, joint) + 4.0), 2.0 * ROUNDING, "m/s");
	CHECK_LE("force", fabs((double)joint_force(world, joint).y), 6.001, "N");
	cn_world_destroy(world);
}

/* ---- breaking ---- */

static int32_t joint_events(const cn_world *world, const cn_joint_event **out)
{
	int32_t count = 0;
	must(cn_world_joint_events(world, out, &count), world, "cn_world_joint_events");
	return count;
}

static void joints_break_at_their_threshold(void)
{
	int32_t breaks;
	for (breaks = 0; breaks < 2; ++breaks) {
		cn_world *world = fixture_world(0.0f, 0);
		cn_body box = unit_box(world, 0.0f, 0.0f, 0.0f);
		const cn_joint_event *events = NULL;
		cn_fixed_def def;
		cn_joint joint;
		double pull = 0.0;
		int32_t k, count = 0;
		cn_fixed_def_init(&def);
		connect(&def.base, 0, at(0.0f, 0.0f), box, at(0.0f, 0.0f));
		def.base.flags = breaks ? (uint32_t)CN_JOINT_BREAKS : 0u;
		def.base.break_force_N = 20.0f;
		def.base.user_data = 77;
		joint = make_fixed(world, &def);
		for (k = 0; k < 600 && count == 0; ++k) {
			pull = 0.05 * (double)k;
			must(cn_body_apply_force(world, box, 0.0f, (float)pull), world, "cn_body_apply_force");
			fixture_step(world, 1);
			count = joint_events(world, &events);
		}
		CHECK_LE("pull at which it breaks against 20 N", fabs(pull - 20.0), 0.15, "N");
		REQUIRE(count == 1);
		CHECK(events[0].joint == joint && events[0].constraint == 0 && events[0].body_a == 0 && events[0].body_b == box);
		CHECK(events[0].user_data == 77 && events[0].destroyed == (uint32_t)breaks && (double)events[0].force_N > 20.0);
		CHECK(cn_joint_is_valid(world, joint) == !breaks);
		must(cn_body_apply_force(world, box, 0.0f, 21.0f), world, "cn_body_apply_force");
		fixture_step(world, 1);
		CHECK(joint_events(world, &events) == !breaks);
		fixture_step(world, 3);
		CHECK(joint_events(world, &events) == 0);
		CHECK((fixture_velocity(world, box).linear_mps.y > 0.1f) == breaks);
		CHECK(fixture_is_valid(world));
		cn_world_destroy(world);
	}
}

/* A chain of which one link is weak, torn apart by a falling weight; and a torque threshold. */
static void a_blow_breaks_a_joint(void)
{
	cn_world *world = fixture_world(-(float)GRAVITY, 1);
	cn_body links[6], bar;
	cn_joint weak = 0, weld;
	const cn_joint_event *events = NULL;
	cn_fixed_def def;
	int32_t k, broken = 0;
	for (k = 0; k < 6; ++k) {
		cn_revolute_def pin;
		cn_joint joint;
		links[k] = fixture_box(world, CN_BODY_DYNAMIC, 0.5f + (float)k, 0.0f, 0.0f, 0.5f, 0.1f, 0.5f, 0.0f);
		pin = revolute_def(k == 0 ? 0 : links[k - 1], k == 0 ? at(0.0f, 0.0f) : at(0.5f, 0.0f), links[k], at(-0.5f, 0.0f));
		if (k == 3) {
			pin.base.break_force_N = 12.0f; /* hanging still it bears 6 N */
			pin.base.flags = CN_JOINT_BREAKS;
		}
		joint = make_revolute(world, &pin);
		weak = k == 3 ? joint : weak;
	}
	bar = fixture_box(world, CN_BODY_DYNAMIC, -5.0f, 10.0f, 0.0f, 1.0f, 0.1f, 0.5f, 0.0f);
	cn_fixed_def_init(&def);
	connect(&def.base, 0, at(-6.0f, 10.0f), bar, at(-1.0f, 0.0f));
	def.base.break_torque_Nm = 3.0f; /* its weight gives 4 Nm */
	def.base.flags = CN_JOINT_BREAKS;
	weld = make_fixed(world, &def);
	for (k = 0; k < 300; ++k) {
		fixture_step(world, 1);
		broken += joint_events(world, &events);
		CHECK(fixture_is_valid(world));
	}
	CHECK(broken == 2);
	CHECK(!cn_joint_is_valid(world, weak) && !cn_joint_is_valid(world, weld));
	CHECK(fixture_pose(world, bar).position_m.y < 0.0f && fixture_pose(world, links[5]).position_m.y < -10.0f);
	CHECK(fixture_pose(world, links[2]).position_m.y > -4.0f);
	cn_world_destroy(world);
}

static void bodies_take_their_joints_along(void)
{
	cn_world *world = fixture_world(-(float)GRAVITY, 1);
	cn_body a = unit_box(world, 0.0f, 0.0f, 0.0f), b = unit_box(world, 2.0f, 0.0f, 0.0f), c = unit_box(world, 4.0f, 0.0f, 0.0f), pair[2];
	const cn_joint_event *events = NULL;
	cn_gear_def gear;
	cn_fixed_def weld;
	cn_angle_constraint_def angle;
	cn_constraint lock = 0;
	cn_joint ab, bc, cw;
	int32_t count = 0;
	cn_gear_def_init(&gear);
	connect(&gear.base, a, at(0.0f, 0.0f), b, at(0.0f, 0.0f));
	gear.base.user_data = 5;
	ab = make_gear(world, &gear);
	cn_fixed_def_init(&weld);
	connect(&weld.base, b, at(1.0f, 0.0f), c, at(-1.0f, 0.0f));
	bc = make_fixed(world, &weld);
	connect(&weld.base, 0, at(4.0f, 0.0f), c, at(0.0f, 0.0f));
	cw = make_fixed(world, &weld);
	cn_angle_constraint_def_init(&angle);
	angle.body = a;
	must(cn_constraint_create_angle(world, &angle, &lock), world, "cn_constraint_create_angle");
	fixture_step(world, 10);
	must(cn_body_destroy(world, a), world, "cn_body_destroy");
	CHECK(!cn_joint_is_valid(world, ab) && !cn_constraint_is_valid(world, lock) && cn_joint_is_valid(world, bc));
	CHECK(joint_events(world, &events) == 0); /* of the last step: not yet */
	fixture_step(world, 1);
	count = joint_events(world, &events);
	REQUIRE(count == 2);
	CHECK((events[0].joint == ab && events[1].constraint == lock) || (events[1].joint == ab && events[0].constraint == lock));
	CHECK(events[0].destroyed == 1 && events[1].destroyed == 1 && events[0].force_N == 0.0f);
	CHECK((events[0].joint == ab ? events[0] : events[1]).user_data == 5 && (events[0].joint == ab ? events[0] : events[1]).body_b == b);
	fixture_step(world, 1);
	CHECK(joint_events(world, &events) == 0);
	pair[0] = b;
	pair[1] = c;
	must(cn_body_destroy_many(world, pair, 2), world, "cn_body_destroy_many");
	fixture_step(world, 1);
	CHECK(joint_events(world, &events) == 2); /* bc once, cw once */
	CHECK(!cn_joint_is_valid(world, cw) && fixture_is_valid(world));
	CHECK(fixture_counters(world).joints == 0);
	cn_world_destroy(world);
}

/* ---- statics ---- */

/* A joint that must carry a box of 1 kg at rest: force (0, 10) N on it. */
static void check_carries(cn_world *world, cn_joint joint, const char *what)
{
	cn_vec2 f;
	fixture_step(world, 600);
	f = joint_force(world, joint);
	CHECK_LE(what, hypot((double)f.x, (double)f.y - GRAVITY), 2.0 * ROUNDING, "N");
}

static void reactions_agree_with_statics(void)
{
	cn_world *world = fixture_world(-(float)GRAVITY, 0);
	cn_fixed_def fixed;
	cn_prismatic_def prismatic;
	cn_wheel_def wheel;
	cn_motor_def motor;
	cn_mouse_def mouse;
	cn_pulley_def pulley;
	cn_groove_def groove;
	cn_joint joints[7];
	int32_t k;
	cn_fixed_def_init(&fixed);
	connect(&fixed.base, 0, at(0.0f, 0.0f), unit_box(world, 2.0f, 0.0f, 0.0f), at(-2.0f, 0.0f));
	joints[0] = make_fixed(world, &fixed);
	cn_prismatic_def_init(&prismatic);
	connect(&prismatic.base, 0, at(10.0f, 0.0f), unit_box(world, 10.0f, 0.0f, 0.0f), at(0.0f, 0.0f));
	joints[1] = make_prismatic(world, &prismatic);
	cn_wheel_def_init(&wheel);
	connect(&wheel.base, 0, at(20.0f, 0.0f), unit_box(world, 20.0f, 0.0f, 0.0f), at(0.0f, 0.0f));
	wheel.base.flags = CN_JOINT_SPRING;
	joints[2] = make_wheel(world, &wheel);
	cn_motor_def_init(&motor);
	connect(&motor.base, 0, at(30.0f, 0.0f), unit_box(world, 30.0f, 0.0f, 0.0f), at(0.0f, 0.0f));
	motor.base.force_max_N = motor.base.torque_max_Nm = 100.0f;
	joints[3] = make_motor(world, &motor);
	cn_mouse_def_init(&mouse);
	connect(&mouse.base, 0, at(0.0f, 0.0f), unit_box(world, 40.0f, 0.0f, 0.0f), at(0.0f, 0.0f));
	mouse.target_m = at(40.0f, 0.0f);
	mouse.base.force_max_N = 100.0f;
	joints[4] = make_mouse(world, &mouse);
	cn_pulley_def_init(&pulley);
	connect(&pulley.base, unit_box(world, 50.0f, 0.0f, 0.0f), at(0.0f, 0.0f), unit_box(world, 55.0f, 0.0f, 0.0f), at(0.0f, 0.0f));
	pulley.ground_a_m = at(50.0f, 5.0f);
	pulley.ground_b_m = at(55.0f, 5.0f);
	pulley.length_m = 10.0f;
	joints[5] = make_pulley(world, &pulley);
	cn_groove_def_init(&groove);
	connect(&groove.base, 0, at(60.0f, 0.0f), unit_box(world, 61.0f, 0.0f, 0.0f), at(0.0f, 0.0f));
	groove.end_m = at(62.0f, 0.0f);
	joints[6] = make_groove(world, &groove);
	for (k = 0; k < 7; ++k) {
		static const char *const names[] = { "fixed: force from the weight", "prismatic", "wheel", "motor", "mouse", "pulley", "groove" };
		check_carries(world, joints[k], names[k]);
	}
	CHECK_LE("fixed: torque against m g l", fabs(joint_torque(world, joints[0]) - 2.0 * GRAVITY), 2.0 * ROUNDING, "Nm");
	CHECK_LE("wheel: sag against g / w^2", fabs(joint_position(world, joints[2]) + GRAVITY / pow(2.0 * PI, 2.0)), ROUNDING, "m");
	CHECK_LE("mouse: sag against g / w^2", fabs(joint_position(world, joints[4]) - GRAVITY / pow(10.0 * PI, 2.0)), ROUNDING, "m");
	cn_world_destroy(world);
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(cantilever_of_ten_boxes);
	RUN(weld_has_its_stiffness);
	RUN(rigid_parts_keep_to_their_force);
	RUN(limits_keep_to_their_force);
	RUN(joints_break_at_their_threshold);
	RUN(a_blow_breaks_a_joint);
	RUN(bodies_take_their_joints_along);
	RUN(reactions_agree_with_statics);
	return test_end();
}
