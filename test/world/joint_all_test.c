/*
 * test/world/joint_all_test.c - what all types of joints promise alike: errors that stay bounded, sleep, every way to end,
 * definitions that are read back, equal runs.
 *
 * If a test here fails, look first in: joints/joint_type.c, world/joint_kinds.c (definitions),
 * model/joint.c (sleep, destruction).
 */
#include "joints.h"

/* One of each type between two bodies whose distance and angle agree with it. */
static cn_joint make_any(cn_world *world, int32_t type, cn_body a, cn_vec2 anchor_a, cn_body b, cn_vec2 anchor_b)
{
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
		return hinge(world, a, anchor_a, b, anchor_b);
	case CN_JOINT_DISTANCE:
		cn_distance_def_init(&distance);
		connect(&distance.base, a, at(anchor_a.x, anchor_a.y + 1.0f), b, anchor_b);
		return make_distance(world, &distance);
	case CN_JOINT_FIXED:
		cn_fixed_def_init(&fixed);
		connect(&fixed.base, a, anchor_a, b, anchor_b);
		return make_fixed(world, &fixed);
	case CN_JOINT_PRISMATIC:
		cn_prismatic_def_init(&prismatic);
		connect(&prismatic.base, a, anchor_a, b, anchor_b);
		prismatic.base.flags = CN_JOINT_LIMIT;
		prismatic.lower_m = -0.5f;
		prismatic.upper_m = 0.5f;
		return make_prismatic(world, &prismatic);
	case CN_JOINT_WHEEL:
		cn_wheel_def_init(&wheel);
		connect(&wheel.base, a, anchor_a, b, anchor_b);
		wheel.base.flags = CN_JOINT_LIMIT | CN_JOINT_SPRING;
		wheel.lower_m = -0.3f;
		wheel.upper_m = 0.3f;
		return make_wheel(world, &wheel);
	case CN_JOINT_MOTOR_TO:
		cn_motor_def_init(&motor);
		connect(&motor.base, a, anchor_a, b, anchor_b);
		motor.base.force_max_N = motor.base.torque_max_Nm = 1000.0f;
		return make_motor(world, &motor);
	case CN_JOINT_MOUSE:
		cn_mouse_def_init(&mouse);
		connect(&mouse.base, 0, anchor_a, b, anchor_b);
		mouse.base.force_max_N = 1000.0f;
		mouse.target_m = at(fixture_pose(world, b).position_m.x, fixture_pose(world, b).position_m.y);
		return make_mouse(world, &mouse);
	case CN_JOINT_GEAR:
		cn_gear_def_init(&gear);
		connect(&gear.base, a, anchor_a, b, anchor_b);
		gear.ratio = -1.5f;
		return make_gear(world, &gear);
	case CN_JOINT_PULLEY:
		cn_pulley_def_init(&pulley);
		connect(&pulley.base, a, anchor_a, b, anchor_b);
		pulley.ground_a_m = at(fixture_pose(world, b).position_m.x - 2.0f, 6.0f);
		pulley.ground_b_m = at(fixture_pose(world, b).position_m.x + 2.0f, 6.0f);
		pulley.length_m = 14.0f;
		return make_pulley(world, &pulley);
	case CN_JOINT_RATCHET:
		cn_ratchet_def_init(&ratchet);
		connect(&ratchet.base, a, anchor_a, b, anchor_b);
		ratchet.click_rad = 0.4f;
		return make_ratchet(world, &ratchet);
	case CN_JOINT_ROTARY_SPRING:
		cn_rotary_spring_def_init(&spring);
		connect(&spring.base, a, anchor_a, b, anchor_b);
		return make_rotary_spring(world, &spring);
	case CN_JOINT_GROOVE:
		cn_groove_def_init(&groove);
		connect(&groove.base, a, at(anchor_a.x - 0.5f, anchor_a.y), b, anchor_b);
		groove.end_m = at(anchor_a.x + 0.5f, anchor_a.y);
		return make_groove(world, &groove);
	default:
		cn_filter_joint_def_init(&filter);
		connect(&filter.base, a, anchor_a, b, anchor_b);
		return make_filter(world, &filter);
	}
}

#define TYPES (CN_JOINT_FILTER + 1)

static const char *const type_names[TYPES] = { "revolute", "distance", "fixed", "prismatic", "wheel", "motor", "mouse", "gear", "pulley", "ratchet",
	"rotary spring", "groove", "filter" };

/* Thrown about by changing forces over a floor for a minute: joint to the world, to another body, to a kinematic one. */
static void errors_stay_bounded_for_a_minute(void)
{
	int32_t type, other;
	for (other = 0; other < 3; ++other) {
		cn_world *world = fixture_world(-(float)GRAVITY, 0);
		cn_body a[TYPES], b[TYPES];
		cn_joint joints[TYPES];
		double m[TYPES], rad[TYPES];
		uint32_t seed = 12345u;
		int32_t k;
		/* Out of reach of the kinematic ones, which would press a box into it without limit. */
		fixture_box(world, CN_BODY_STATIC, 0.0f, other == 2 ? -8.0f : -4.0f, 0.0f, 1000.0f, 1.0f, 0.5f, 0.0f);
		for (type = 0; type < TYPES; ++type) {
			float x = 20.0f * (float)type;
			b[type] = unit_box(world, x, 0.0f, 0.0f);
			a[type] = other == 0 ? 0 : other == 1 ? unit_box(world, x - 1.0f, 0.0f, 0.0f) : fixture_body(world, CN_BODY_KINEMATIC, x - 1.0f, 0.0f, 0.0f);
			if (other == 2)
				fixture_set_velocity(world, a[type], 0.0f, 0.0f, 0.5f);
			joints[type] = make_any(world, type, a[type], other == 0 ? at(x - 0.5f, 0.0f) : at(0.5f, 0.0f), b[type], at(-0.5f, 0.0f));
			m[type] = rad[type] = 0.0;
		}
		for (k = 0; k < 3600; ++k) {
			for (type = 0; type < TYPES; ++type) {
				float fx = fixture_random(&seed, -20.0f, 20.0f), fy = fixture_random(&seed, -20.0f, 20.0f), t = fixture_random(&seed, -5.0f, 5.0f);
				must(cn_body_apply_force(world, b[type], fx, fy), world, "cn_body_apply_force");
				must(cn_body_apply_torque(world, b[type], t), world, "cn_body_apply_torque");
			}
			fixture_step(world, 1);
			for (type = 0; type < TYPES; ++type) {
				m[type] = greater(m[type], joint_error_m(world, joints[type]));
				rad[type] = greater(rad[type], joint_error_rad(world, joints[type]));
			}
		}
		printf("    to %s:\n", other == 0 ? "the world" : other == 1 ? "a dynamic body" : "a turning kinematic body");
		for (type = 0; type < TYPES; ++type) {
			printf("    %s\n", type_names[type]);
			CHECK_LE("largest error", m[type], 0.02, "m");
			CHECK_LE("largest error", rad[type], 0.02, "rad");
		}
		CHECK(fixture_is_valid(world));
		cn_world_destroy(world);
	}
}

/* Two jointed boxes resting on a floor fall asleep as one, and wake as one. */
static void jointed_bodies_sleep_and_wake_together(void)
{
	int32_t type;
	for (type = 0; type < TYPES; ++type) {
		cn_world *world = fixture_world(-(float)GRAVITY, 1);
		cn_body a, b;
		cn_pose before, after;
		int32_t k, together = type != CN_JOINT_FILTER && type != CN_JOINT_MOUSE;
		fixture_floor(world, 0.5f, 0.0f);
		a = unit_box(world, -0.5f, 0.5f, 0.0f);
		b = unit_box(world, 0.5f, 0.5f, 0.0f);
		make_any(world, type, a, at(0.5f, 0.0f), b, at(-0.5f, 0.0f));
		for (k = 0; k < 900 && (fixture_is_awake(world, a) || fixture_is_awake(world, b)); ++k)
			fixture_step(world, 1);
		if (fixture_is_awake(world, a) || fixture_is_awake(world, b)) {
			printf("  %s does not sleep\n", type_names[type]);
			test_fail(__FILE__, __LINE__, "jointed bodies at rest must sleep");
		}
		before = fixture_pose(world, b);
		fixture_step(world, 60);
		after = fixture_pose(world, b);
		CHECK(memcmp(&before, &after, sizeof before) == 0);
		CHECK(fixture_counters(world).joints_awake == 0);
		must(cn_body_apply_impulse(world, a, 0.0f, 0.01f), world, "cn_body_apply_impulse");
		if (type != CN_JOINT_MOUSE)
			CHECK(fixture_is_awake(world, b) == together);
		CHECK(fixture_is_valid(world));
		cn_world_destroy(world);
	}
}

/* Creating and destroying in every order, asleep and awake, by joint, body, type, disabling. */
static void every_way_to_end_a_joint(void)
{
	int32_t type, way;
	for (type = 0; type < TYPES; ++type)
		for (way = 0; way < 6; ++way) {
			cn_world *world = fixture_world(-(float)GRAVITY, 1);
			cn_body a, b;
			cn_joint joint;
			fixture_floor(world, 0.5f, 0.0f);
			a = unit_box(world, -0.5f, 0.5f, 0.0f);
			b = unit_box(world, 0.5f, 0.5f, 0.0f);
			joint = make_any(world, type, a, at(0.5f, 0.0f), b, at(-0.5f, 0.0f));
			fixture_step(world, way & 1 ? 200 : 3);
			if (way < 2)
				must(cn_joint_destroy(world, joint), world, "cn_joint_destroy");
			else if (way == 2)
				must(cn_body_destroy(world, b), world, "cn_body_destroy");
			else if (way == 3)
				must(cn_body_set_flags(world, b, CN_BODY_SLEEP), world, "cn_body_set_flags");
			else if (way == 4 && type != CN_JOINT_MOUSE)
				must(cn_body_set_type(world, b, CN_BODY_KINEMATIC), world, "cn_body_set_type");
			else if (way == 4)
				CHECK(cn_body_set_type(world, b, CN_BODY_STATIC) == CN_ERROR_STATE);
			else
				must(cn_body_set_awake(world, a, 0), world, "cn_body_set_awake");
			CHECK(fixture_is_valid(world));
			fixture_step(world, 60);
			CHECK(fixture_is_valid(world));
			cn_world_destroy(world);
		}
}

static void a_filter_only_filters(void)
{
	cn_world *world = fixture_world(-(float)GRAVITY, 1);
	cn_body a, b, alone;
	cn_joint joint;
	int32_t count = 0;
	fixture_floor(world, 0.5f, 0.0f);
	a = unit_box(world, 0.0f, 3.0f, 0.0f);
	b = unit_box(world, 0.2f, 3.4f, 0.0f);
	alone = unit_box(world, 50.0f, 3.0f, 0.0f);
	joint = make_any(world, CN_JOINT_FILTER, a, at(0.0f, 0.0f), b, at(0.0f, 0.0f));
	fixture_step(world, 20);
	CHECK_LE("fall of a against that of a free body", fabs((double)(fixture_pose(world, a).position_m.y - fixture_pose(world, alone).position_m.y)), 0.0, "m");
	CHECK_LE("spin of b", fabs((double)fixture_velocity(world, b).angular_radps), 0.0, "rad/s");
	fixture_step(world, 200);
	CHECK(!fixture_is_awake(world, a) && !fixture_is_awake(world, b));
	CHECK_LE("both rest on the floor", fabs((double)(fixture_pose(world, a).position_m.y - fixture_pose(world, b).position_m.y)), SAG_M, "m");
	must(cn_body_get_joints(world, a, NULL, 0, &count), world, "cn_body_get_joints");
	CHECK(count == 1);
	must(cn_joint_destroy(world, joint), world, "cn_joint_destroy");
	fixture_step(world, 120);
	CHECK_GE("pushed apart without it", fabs((double)(fixture_pose(world, a).position_m.x - fixture_pose(world, b).position_m.x)) +
	         fabs((double)(fixture_pose(world, a).position_m.y - fixture_pose(world, b).position_m.y)), 0.9, "m");
	cn_world_destroy(world);
}

/* ---- setters ---- */

#define ROUND_TRIP(T, get, set, type, change) do { \
	cn_##T first, second; \
	joint = make_any(world, type, a, at(0.5f, 0.0f), b, at(-0.5f, 0.0f)); \
	must(get(world, joint, &first), world, #get); \
	change; \
	first.base.break_force_N = 3e6f; \
	first.base.stiffness_hertz = 30.0f; \
	first.base.user_data = 9; \
	first.base.flags |= CN_JOINT_COLLIDE; \
	must(set(world, joint, &first), world, #set); \
	must(get(world, joint, &second), world, #get); \
	CHECK(memcmp(&first, &second, sizeof first) == 0); \
	fixture_step(world, 5); \
	must(cn_joint_destroy(world, joint), world, "cn_joint_destroy"); \
} while (0)

static void what_is_set_is_read_back(void)
{
	cn_world *world = fixture_world(0.0f, 0);
	cn_body a = unit_box(world, -0.5f, 0.5f, 0.0f), b = unit_box(world, 0.5f, 0.5f, 0.0f);
	cn_joint_base base, again;
	cn_joint joint;
	ROUND_TRIP(fixed_def, cn_joint_get_fixed, cn_joint_set_fixed, CN_JOINT_FIXED, first.angular_hertz = 2.0f);
	ROUND_TRIP(prismatic_def, cn_joint_get_prismatic, cn_joint_set_prismatic, CN_JOINT_PRISMATIC, first.spring_target_m = 0.2f);
	ROUND_TRIP(wheel_def, cn_joint_get_wheel, cn_joint_set_wheel, CN_JOINT_WHEEL, first.motor_speed_radps = 2.0f);
	ROUND_TRIP(motor_def, cn_joint_get_motor_to, cn_joint_set_motor_to, CN_JOINT_MOTOR_TO, first.angle_rad = 0.1f);
	ROUND_TRIP(mouse_def, cn_joint_get_mouse, cn_joint_set_mouse, CN_JOINT_MOUSE, first.hertz = 2.0f);
	ROUND_TRIP(gear_def, cn_joint_get_gear, cn_joint_set_gear, CN_JOINT_GEAR, first.phase_rad = 0.1f);
	ROUND_TRIP(pulley_def, cn_joint_get_pulley, cn_joint_set_pulley, CN_JOINT_PULLEY, first.ratio = 0.5f);
	ROUND_TRIP(ratchet_def, cn_joint_get_ratchet, cn_joint_set_ratchet, CN_JOINT_RATCHET, first.click_rad = -0.2f);
	ROUND_TRIP(rotary_spring_def, cn_joint_get_rotary_spring, cn_joint_set_rotary_spring, CN_JOINT_ROTARY_SPRING, first.rest_angle_rad = 1.0f);
	ROUND_TRIP(groove_def, cn_joint_get_groove, cn_joint_set_groove, CN_JOINT_GROOVE, first.end_m.x = 2.0f);
	joint = make_any(world, CN_JOINT_FILTER, a, at(0.0f, 0.0f), b, at(0.0f, 0.0f));
	must(cn_joint_get_base(world, joint, &base), world, "cn_joint_get_base");
	base.break_torque_Nm = 4.0f;
	must(cn_joint_set_base(world, joint, &base), world, "cn_joint_set_base");
	must(cn_joint_get_base(world, joint, &again), world, "cn_joint_get_base");
	CHECK(memcmp(&base, &again, sizeof base) == 0);
	CHECK(base.body_a == a && base.struct_size == sizeof(cn_filter_joint_def));
	cn_world_destroy(world);
}

/* ---- reading ---- */

#define SHORT_S (1.0f / 3840.0f)

/* The speed between two short steps is the difference of the positions before and after, over the time 2 h. That errs by h^2 / 6 times
   the third derivative, at angular speeds of 5/s by 1e-6, and by the rounding of positions (1e-6 m of the pulley's 14 m) over 2 h: 2e-3. */
static void speed_is_the_rate_of_the_position(void)
{
	double worst[TYPES] = { 0.0 };
	uint32_t seed = 7u;
	int32_t round, type;
	for (round = 0; round < 20; ++round)
		for (type = 0; type < TYPES; ++type) {
			cn_world *world = fixture_world(0.0f, 0);
			cn_body a = unit_box(world, -0.5f, 0.0f, 0.0f), b = unit_box(world, 0.5f, 0.0f, 0.0f);
			cn_joint joint = make_any(world, type, a, at(0.5f, 0.0f), b, at(-0.5f, 0.0f));
			double before, rate, speed;
			float vx = fixture_random(&seed, -0.5f, 0.5f), vy = fixture_random(&seed, -0.5f, 0.5f), w = fixture_random(&seed, -3.0f, 3.0f);
			if (type == CN_JOINT_RATCHET) /* the way that it does not block */
				w = fabsf(w);
			if (type == CN_JOINT_MOUSE)
				must(cn_joint_set_target(world, joint, 3.0f, 2.0f), world, "cn_joint_set_target");
			fixture_set_velocity(world, b, vx, vy, w);
			fixture_step(world, 3);
			must(cn_world_step(world, SHORT_S), world, "cn_world_step");
			before = joint_position(world, joint);
			must(cn_world_step(world, SHORT_S), world, "cn_world_step");
			speed = joint_speed(world, joint);
			must(cn_world_step(world, SHORT_S), world, "cn_world_step");
			rate = (joint_position(world, joint) - before) / (2.0 * (double)SHORT_S);
			if (type == CN_JOINT_WHEEL) /* the translation, and the rate of the angle */
				rate = (double)fixture_velocity(world, b).angular_radps - (double)fixture_velocity(world, a).angular_radps;
			worst[type] = greater(worst[type], fabs(rate - speed) / (1.0 + fabs(speed)));
			cn_world_destroy(world);
		}
	for (type = 0; type < TYPES; ++type) {
		printf("    %s\n", type_names[type]);
		CHECK_LE("rate of the position against the speed, relative", worst[type], 0.005, "");
	}
}

/* ---- the same on every run ---- */

static uint64_t busy_hash(void)
{
	cn_world *world = fixture_world(-(float)GRAVITY, 1);
	uint64_t hash;
	int32_t type;
	fixture_box(world, CN_BODY_STATIC, 0.0f, -4.0f, 0.0f, 1000.0f, 1.0f, 0.5f, 0.0f);
	for (type = 0; type < TYPES; ++type) {
		cn_body a = unit_box(world, 3.0f * (float)type, 0.0f, 0.0f), b = unit_box(world, 3.0f * (float)type + 1.0f, 0.0f, 0.0f);
		make_any(world, type, a, at(0.5f, 0.0f), b, at(-0.5f, 0.0f));
		fixture_set_velocity(world, b, 0.0f, 3.0f, 2.0f);
	}
	fixture_step(world, 300);
	hash = fixture_hash(world);
	cn_world_destroy(world);
	return hash;
}

static void runs_are_equal(void)
{
	uint64_t first = busy_hash();
	printf("    hash %016llx\n", (unsigned long long)first);
	CHECK(first == busy_hash());
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(errors_stay_bounded_for_a_minute);
	RUN(jointed_bodies_sleep_and_wake_together);
	RUN(every_way_to_end_a_joint);
	RUN(a_filter_only_filters);
	RUN(what_is_set_is_read_back);
	RUN(speed_is_the_rate_of_the_position);
	RUN(runs_are_equal);
	return test_end();
}
