/*
 * test/world/joint_types_test.c - every joint type but revolute, distance (joint_test.c) and fixed (joint_force_test.c)
 * against closed forms.
 *
 * If a test here fails, look first in: joints/joint_type.c (rows), joints/joint_turns.c (gear, ratchet,
 * rotary spring), joints/joint_solve.c.
 */
#include "joints.h"

/* Adds the change since the last call (less than half a turn) to *total. */
static void count_turns(const cn_world *world, cn_body body, double *last, double *total)
{
	double now = angle_of(world, body), change = now - *last;
	change -= 2.0 * PI * floor((change + PI) / (2.0 * PI));
	*total += change;
	*last = now;
}

/* Free oscillation from x0 at rest. */
static double oscillation(double x0, double hertz, double zeta, double t)
{
	double w = 2.0 * PI * hertz, wd = w * sqrt(1.0 - zeta * zeta);
	return x0 * exp(-zeta * w * t) * (cos(wd * t) + zeta * w / wd * sin(wd * t));
}

/* Largest difference to the closed form over some seconds, as a share of x0. */
static double oscillation_error(cn_world *world, cn_joint joint, double rest, double x0, double hertz, double zeta, double seconds)
{
	double worst = 0.0;
	int32_t k, steps = (int32_t)(seconds * 60.0);
	for (k = 1; k <= steps; ++k) {
		fixture_step(world, 1);
		worst = greater(worst, fabs(joint_position(world, joint) - rest - oscillation(x0, hertz, zeta, (double)k / 60.0)));
	}
	return worst / fabs(x0);
}

/* ---- prismatic ---- */

static void prismatic_slides_down_an_incline(void)
{
	const double tilt = PI / 6.0;
	cn_world *world = fixture_world(-(float)GRAVITY, 0);
	cn_body box = unit_box(world, 0.0f, 0.0f, 0.3f);
	cn_prismatic_def def;
	cn_joint joint;
	double worst = 0.0, side = 0.0, turn = 0.0;
	int32_t k;
	cn_prismatic_def_init(&def);
	connect(&def.base, 0, at(0.0f, 0.0f), box, at(0.1f, 0.2f));
	def.base.anchor_a_m = at(0.1f * cosf(0.3f) - 0.2f * sinf(0.3f), 0.1f * sinf(0.3f) + 0.2f * cosf(0.3f));
	def.axis = at(-7.0f * (float)cos(tilt), -7.0f * (float)sin(tilt));
	def.reference_angle_rad = 0.3f;
	joint = make_prismatic(world, &def);
	for (k = 1; k <= 120; ++k) {
		double t = (double)k / 60.0, s = 0.5 * GRAVITY * sin(tilt) * t * t;
		fixture_step(world, 1);
		if (k >= 30)
			worst = greater(worst, fabs(joint_position(world, joint) - s) / s);
		side = greater(side, joint_error_m(world, joint));
		turn = greater(turn, joint_error_rad(world, joint));
	}
	CHECK_LE("way against g sin(30) t^2 / 2, 0.5 to 2 s", worst, 2.0 * ROUNDING, "");
	CHECK_LE("speed against g sin(30) t after 2 s", fabs(joint_speed(world, joint) / (GRAVITY * sin(tilt) * 2.0) - 1.0), 2.0 * ROUNDING, "");
	CHECK_LE("off the axis", side, ROUNDING, "m");
	CHECK_LE("turned", turn, ROUNDING, "rad");
	{
		cn_vec2 f = joint_force(world, joint);
		CHECK_LE("reaction against m g cos(30)", fabs(hypot((double)f.x, (double)f.y) - GRAVITY * cos(tilt)), 5.0 * SOLVED, "N");
		CHECK_LE("moment about the centre", fabs(joint_torque(world, joint) + cos(0.3) * (0.1 * (double)f.y - 0.2 * (double)f.x) - sin(0.3) * (0.2 * (double)f.y + 0.1 * (double)f.x)), ROUNDING, "Nm");
	}
	cn_world_destroy(world);
}

static void prismatic_spring_has_its_period_and_decay(void)
{
	static const float zetas[] = { 0.0f, 0.1f, 0.7f };
	int32_t k;
	for (k = 0; k < 3; ++k) {
		cn_world *world = fixture_world(0.0f, 0);
		cn_body box = unit_box(world, 1.3f, 0.0f, 0.0f);
		cn_prismatic_def def;
		cn_joint joint;
		cn_prismatic_def_init(&def);
		/* Off the centre: the mass that moves is still the whole body's, because it cannot turn. */
		connect(&def.base, 0, at(0.0f, 0.4f), box, at(0.0f, 0.4f));
		def.base.flags = CN_JOINT_SPRING;
		def.spring_target_m = 0.3f;
		def.spring_hertz = 1.0f;
		def.spring_damping_ratio = zetas[k];
		joint = make_prismatic(world, &def);
		CHECK_LE("spring against its closed form over 10 s", oscillation_error(world, joint, 0.3, 1.0, 1.0, (double)zetas[k], 10.0), 0.02, "of x0");
		cn_world_destroy(world);
	}
}

static void prismatic_motor_and_limits(void)
{
	cn_world *world = fixture_world(0.0f, 0);
	cn_body box = unit_box(world, 0.0f, 0.0f, 0.0f);
	cn_prismatic_def def;
	cn_joint joint;
	double beyond = 0.0;
	int32_t k;
	cn_prismatic_def_init(&def);
	connect(&def.base, 0, at(0.0f, 0.0f), box, at(0.0f, 0.0f));
	def.base.flags = CN_JOINT_MOTOR | CN_JOINT_LIMIT;
	def.lower_m = -1.0f;
	def.upper_m = 3.0f;
	def.motor_speed_mps = 2.0f;
	def.motor_force_max_N = 4.0f;
	joint = make_prismatic(world, &def);
	fixture_step(world, 15);
	CHECK_LE("speed after 0.25 s against F t / m", fabs(joint_speed(world, joint) - 1.0), ROUNDING, "m/s");
	fixture_step(world, 30);
	CHECK_LE("speed after F t / m > v against v", fabs(joint_speed(world, joint) - 2.0), ROUNDING, "m/s");
	for (k = 0; k < 120; ++k) {
		fixture_step(world, 1);
		beyond = greater(beyond, joint_position(world, joint) - 3.0);
	}
	CHECK_LE("beyond the upper limit", beyond, 2.0 * SOLVED, "m");
	CHECK_LE("force of the motor at the limit", fabs((double)joint_force(world, joint).x), ROUNDING, "N");
	must(cn_joint_set_motor(world, joint, -2.0f, 4.0f), world, "cn_joint_set_motor");
	must(cn_joint_set_limits(world, joint, 1.0f, 3.0f), world, "cn_joint_set_limits");
	fixture_step(world, 180);
	CHECK_LE("rest at the new lower limit", fabs(joint_position(world, joint) - 1.0), 2.0 * SOLVED, "m");
	cn_world_destroy(world);
}

/* How far a motor drives its joint beyond the limits +-1 in 3 s, to one end and then to the other. type: CN_JOINT_REVOLUTE, _PRISMATIC or _DISTANCE.
   links: bodies joined to the one that is driven. */
static double driven_beyond(int32_t solver, int32_t type, float speed, float most, int32_t links)
{
	cn_world *world = fixture_world(-10.0f, 0);
	cn_body box = unit_box(world, type == CN_JOINT_DISTANCE ? 3.0f : 0.0f, 0.0f, 0.0f), link = box;
	double beyond = 0.0, middle = type == CN_JOINT_DISTANCE ? 3.0 : 0.0;
	cn_joint joint;
	int32_t k;
	must(cn_world_set_solver(world, solver), world, "cn_world_set_solver");
	if (type == CN_JOINT_REVOLUTE) {
		cn_revolute_def def = revolute_def(0, at(0.0f, 0.0f), box, at(-0.5f, 0.0f));
		def.base.flags = CN_JOINT_MOTOR | CN_JOINT_LIMIT;
		def.lower_angle_rad = -1.0f;
		def.upper_angle_rad = 1.0f;
		joint = make_revolute(world, &def);
	} else if (type == CN_JOINT_PRISMATIC) {
		cn_prismatic_def def;
		cn_prismatic_def_init(&def);
		connect(&def.base, 0, at(0.0f, 0.0f), box, at(0.0f, 0.0f));
		def.base.flags = CN_JOINT_MOTOR | CN_JOINT_LIMIT;
		def.lower_m = -1.0f;
		def.upper_m = 1.0f;
		joint = make_prismatic(world, &def);
	} else {
		cn_distance_def def = distance_def(0, at(0.0f, 0.0f), box, at(0.0f, 0.0f), 3.0f);
		def.base.flags = CN_JOINT_MOTOR | CN_JOINT_LIMIT;
		def.length_min_m = 2.0f;
		def.length_max_m = 4.0f;
		joint = make_distance(world, &def);
	}
	for (k = 0; k < links; ++k) {
		cn_body next = unit_box(world, (float)middle + 1.5f * (float)(k + 1), 0.0f, 0.0f);
		hinge(world, link, at(0.75f, 0.0f), next, at(-0.75f, 0.0f));
		link = next;
	}
	for (k = 0; k < 180; ++k) {
		if (k % 90 == 0)
			must(cn_joint_set_motor(world, joint, k == 0 ? speed : -speed, most), world, "cn_joint_set_motor");
		fixture_step(world, 1);
		beyond = greater(beyond, fabs(joint_position(world, joint) - middle) - 1.0);
	}
	cn_world_destroy(world);
	return beyond;
}

/* A limit is a soft row, a motor a hard one: however strong, the motor stops at the limit. What is left is the stop itself: less than the
   way of a substep at the motor's speed. At 50 rad/s the ends of two links, which go at 175 m/s, tear at soft hinges: not judged. */
static void strong_motors_stop_at_limits(void)
{
	static const struct { int32_t solver, links; } cases[] = { { CN_SOLVER_SOFT, 0 }, { CN_SOLVER_AUTO, 0 }, { CN_SOLVER_AUTO, 2 }, { CN_SOLVER_SOFT, 2 } };
	static const int32_t types[] = { CN_JOINT_REVOLUTE, CN_JOINT_PRISMATIC, CN_JOINT_DISTANCE };
	static const float speeds[] = { 0.5f, 5.0f, 50.0f };
	int32_t type, k, speed;
	for (type = 0; type < 3; ++type)
		for (k = 0; k < 4; ++k)
			for (speed = 0; speed < (k == 3 ? 2 : 3); ++speed) {
				double beyond = driven_beyond(cases[k].solver, types[type], speeds[speed], 1e6f, cases[k].links);
				CHECK_LE("a motor of 1e6 N or Nm beyond the limit", beyond, 0.01 + (double)speeds[speed] / 240.0, "m or rad");
			}
}

/* ---- wheel ---- */

static void wheel_spring_has_its_period_and_decay(void)
{
	static const float zetas[] = { 0.0f, 0.1f, 0.7f };
	int32_t k;
	for (k = 0; k < 3; ++k) {
		cn_world *world = fixture_world(0.0f, 0);
		cn_body chassis = unit_box(world, 0.0f, 0.0f, 0.0f);
		cn_body wheel = fixture_circle(world, CN_BODY_DYNAMIC, 0.0f, -0.8f, 0.3f, 0.5f, 0.0f);
		cn_wheel_def def;
		cn_joint joint;
		cn_wheel_def_init(&def);
		connect(&def.base, chassis, at(0.0f, -0.5f), wheel, at(0.0f, 0.0f));
		def.base.flags = CN_JOINT_SPRING;
		def.spring_hertz = 1.5f;
		def.spring_damping_ratio = zetas[k];
		joint = make_wheel(world, &def);
		fixture_set_velocity(world, wheel, 0.0f, 0.0f, 20.0f); /* turning is free */
		CHECK_LE("suspension against its closed form over 10 s", oscillation_error(world, joint, 0.0, -0.3, 1.5, (double)zetas[k], 10.0), 0.03, "of x0");
		CHECK_LE("wheel still turns at 20", fabs(joint_speed(world, joint) - 20.0), ROUNDING, "rad/s");
		cn_world_destroy(world);
	}
}

static void wheel_motor_reaches_its_speed_in_time(void)
{
	cn_world *world = fixture_world(-(float)GRAVITY, 0);
	cn_body wheel = fixture_circle(world, CN_BODY_DYNAMIC, 0.0f, 0.0f, 0.5f, 0.5f, 0.0f);
	cn_mass_data mass;
	cn_wheel_def def;
	cn_joint joint;
	double ideal;
	int32_t k = 0;
	mass = mass_of(world, wheel);
	cn_wheel_def_init(&def);
	connect(&def.base, 0, at(0.0f, 0.0f), wheel, at(0.0f, 0.0f));
	def.base.flags = CN_JOINT_MOTOR | CN_JOINT_SPRING | CN_JOINT_LIMIT;
	def.lower_m = -0.1f;
	def.upper_m = 0.1f;
	def.spring_hertz = 5.0f;
	def.motor_speed_radps = 30.0f;
	def.motor_torque_max_Nm = (float)((double)mass.inertia_kgm2 * 30.0 / 2.0);
	joint = make_wheel(world, &def);
	ideal = (double)mass.inertia_kgm2 * 30.0 / (double)def.motor_torque_max_Nm;
	while (joint_speed(world, joint) < 30.0 - 1e-3 && k < 600) {
		fixture_step(world, 1);
		++k;
	}
	CHECK_LE("time to reach the speed against I w / T = 2 s", fabs((double)k / 60.0 - ideal), 1.01 / 60.0, "s");
	/* Static deflection of the suspension: m g / (m w^2). */
	fixture_step(world, 300);
	CHECK_LE("sag against g / w^2", fabs(joint_position(world, joint) + GRAVITY / pow(2.0 * PI * 5.0, 2.0)), ROUNDING, "m");
	cn_world_destroy(world);
}

/* ---- mouse, motor, rotary spring ---- */

static void mouse_drags_like_a_spring(void)
{
	cn_world *world = fixture_world(0.0f, 0);
	cn_body box = unit_box(world, 0.0f, 0.0f, 0.0f);
	cn_mouse_def def;
	cn_joint joint;
	double worst = 0.0;
	int32_t k;
	cn_mouse_def_init(&def);
	connect(&def.base, 0, at(50.0f, 50.0f), box, at(0.0f, 0.0f)); /* anchor a is ignored */
	def.base.force_max_N = 1000.0f;
	def.target_m = at(0.6f, 0.8f);
	def.hertz = 1.0f;
	def.damping_ratio = 0.1f;
	joint = make_mouse(world, &def);
	for (k = 1; k <= 600; ++k) {
		cn_pose p;
		fixture_step(world, 1);
		p = fixture_pose(world, box);
		worst = greater(worst, fabs((double)p.position_m.x * 0.6 + (double)p.position_m.y * 0.8 - 1.0 - oscillation(-1.0, 1.0, 0.1, (double)k / 60.0)));
	}
	CHECK_LE("way against the closed form over 10 s", worst, 0.02, "m");
	must(cn_joint_set_target(world, joint, -3.0f, 2.0f), world, "cn_joint_set_target");
	fixture_step(world, 1200);
	CHECK_LE("from the new target", joint_position(world, joint), SOLVED, "m");
	cn_world_destroy(world);
}

static void mouse_keeps_to_its_force(void)
{
	cn_world *world = fixture_world(0.0f, 0);
	cn_body box = unit_box(world, 0.0f, 0.0f, 0.0f);
	cn_mouse_def def;
	cn_joint joint;
	double most = 0.0;
	int32_t k;
	cn_mouse_def_init(&def);
	connect(&def.base, 0, at(0.0f, 0.0f), box, at(0.0f, 0.0f));
	def.base.force_max_N = 5.0f;
	def.target_m = at(100.0f, 0.0f);
	joint = make_mouse(world, &def);
	for (k = 0; k < 60; ++k) {
		cn_vec2 f;
		fixture_step(world, 1);
		f = joint_force(world, joint);
		most = greater(most, hypot((double)f.x, (double)f.y));
	}
	CHECK_LE("force", most, 5.0001, "N");
	CHECK_LE("speed after 1 s against F t / m", fabs((double)fixture_velocity(world, box).linear_mps.x - 5.0), 2.0 * ROUNDING, "m/s");
	must(cn_joint_destroy(world, joint), world, "cn_joint_destroy");
	def.base.anchor_b_m = at(0.4f, 0.3f);
	def.target_m = at(0.0f, -50.0f);
	joint = make_mouse(world, &def);
	for (k = 0; k < 120; ++k) {
		cn_vec2 f;
		fixture_step(world, 1);
		f = joint_force(world, joint);
		most = greater(most, hypot((double)f.x, (double)f.y));
	}
	CHECK_LE("force on a corner", most, 5.0001, "N");
	cn_world_destroy(world);
}

static void motor_drives_to_an_offset(void)
{
	cn_world *world = fixture_world(0.0f, 0);
	cn_body box = unit_box(world, 2.0f, 0.0f, 0.0f);
	cn_motor_def def;
	cn_joint joint;
	double worst = 0.0, turn = 0.0;
	int32_t k;
	cn_motor_def_init(&def);
	connect(&def.base, 0, at(1.0f, 0.0f), box, at(0.0f, 0.0f));
	def.base.force_max_N = 1e4f;
	def.base.torque_max_Nm = 1e4f;
	def.offset_m = at(0.0f, 1.0f);
	def.angle_rad = 0.5f;
	def.hertz = 1.0f;
	def.damping_ratio = 0.2f;
	joint = make_motor(world, &def);
	for (k = 1; k <= 600; ++k) {
		double left = oscillation(1.0, 1.0, 0.2, (double)k / 60.0);
		cn_pose p;
		fixture_step(world, 1);
		p = fixture_pose(world, box);
		worst = greater(worst, hypot((double)p.position_m.x - 1.0 - left, (double)p.position_m.y - 1.0 + left));
		turn = greater(turn, fabs(joint_position(world, joint) - 0.5 + 0.5 * left));
	}
	CHECK_LE("way against the closed form over 10 s", worst, 5e-3, "m");
	CHECK_LE("angle against the closed form over 10 s", turn, 2e-3, "rad");
	cn_world_destroy(world);
}

/* Too weak for gravity, the motor falls at g - F/m; its torque still holds the angle. */
static void motor_keeps_to_its_force_and_torque(void)
{
	cn_world *world = fixture_world(-(float)GRAVITY, 0);
	cn_body box = unit_box(world, 0.0f, 0.0f, 0.0f);
	cn_motor_def def;
	cn_joint joint;
	double most = 0.0, torque = 0.0;
	int32_t k;
	cn_motor_def_init(&def);
	connect(&def.base, 0, at(0.0f, 0.0f), box, at(0.0f, 0.0f));
	def.base.force_max_N = 4.0f;
	def.base.torque_max_Nm = 0.05f;
	joint = make_motor(world, &def);
	for (k = 0; k < 60; ++k) {
		cn_vec2 f;
		must(cn_body_apply_torque(world, box, 0.04f), world, "cn_body_apply_torque");
		fixture_step(world, 1);
		f = joint_force(world, joint);
		most = greater(most, hypot((double)f.x, (double)f.y));
		torque = greater(torque, fabs(joint_torque(world, joint)));
	}
	CHECK_LE("force", most, 4.0001, "N");
	CHECK_LE("torque", torque, 0.050001, "Nm");
	CHECK_LE("speed after 1 s against (g - F/m) t", fabs((double)fixture_velocity(world, box).linear_mps.y + GRAVITY - 4.0), 0.02, "m/s");
	CHECK_LE("angle against T / (I w^2)", fabs(joint_position(world, joint) - 0.04 / (UNIT_INERTIA * pow(2.0 * PI * 5.0, 2.0))), 1e-5, "rad");
	for (k = 0; k < 60; ++k) {
		must(cn_body_apply_torque(world, box, 0.07f), world, "cn_body_apply_torque");
		fixture_step(world, 1);
	}
	CHECK_LE("spin after 1 s against (T - T max) t / I", fabs((double)fixture_velocity(world, box).angular_radps - 0.02 / UNIT_INERTIA), 10.0 * SOLVED, "rad/s");
	cn_world_destroy(world);
}

static void rotary_spring_has_its_period_and_decay(void)
{
	static const float zetas[] = { 0.0f, 0.1f, 0.7f };
	int32_t k;
	for (k = 0; k < 3; ++k) {
		cn_world *world = fixture_world(0.0f, 0);
		cn_body a = unit_box(world, 0.0f, 0.0f, 0.5f), b = unit_box(world, 5.0f, 0.0f, -0.5f);
		cn_rotary_spring_def def;
		cn_joint joint;
		cn_rotary_spring_def_init(&def);
		connect(&def.base, a, at(0.0f, 0.0f), b, at(0.0f, 0.0f));
		def.rest_angle_rad = 9.0f; /* winds up by more than a turn */
		def.hertz = 0.5f;
		def.damping_ratio = zetas[k];
		joint = make_rotary_spring(world, &def);
		CHECK_LE("spring against its closed form over 20 s", oscillation_error(world, joint, 9.0, -10.0, 0.5, (double)zetas[k], 20.0), 0.02, "of x0");
		CHECK_LE("spin of both together", fabs((double)(fixture_velocity(world, a).angular_radps + fixture_velocity(world, b).angular_radps)), ROUNDING, "rad/s");
		cn_world_destroy(world);
	}
}

/* ---- gear ---- */

static cn_joint axle(cn_world *world, cn_body body, float x, float y)
{
	return hinge(world, 0, at(x, y), body, at(0.0f, 0.0f));
}

/* The load changes its sign every 5 s; a second after that the error is that of a steady load. */
static void gear_run(float ratio, float phase, double *out_ratio_error, double *out_worst, double *out_steady)
{
	cn_world *world = fixture_world(-(float)GRAVITY, 0);
	cn_body a = fixture_circle(world, CN_BODY_DYNAMIC, 0.0f, 0.0f, 0.5f, 0.5f, 0.0f);
	cn_body b = fixture_body(world, CN_BODY_DYNAMIC, 3.0f, 0.0f, phase);
	cn_circle circle = { { 0.0f, 0.0f }, 0.4f };
	cn_shape_def shape = fixture_shape_def(b, 0.5f, 0.0f);
	cn_revolute_def drive = revolute_def(0, at(0.0f, 0.0f), a, at(0.0f, 0.0f));
	cn_gear_def def;
	cn_joint joint;
	double last_a, last_b, total_a = 0.0, total_b, worst = 0.0, steady = 0.0, error;
	int32_t k;
	must(cn_shape_create_circle(world, &shape, &circle, NULL), world, "cn_shape_create_circle");
	drive.base.flags = CN_JOINT_MOTOR;
	drive.motor_speed_radps = 11.0f;
	drive.motor_torque_max_Nm = 50.0f;
	make_revolute(world, &drive);
	axle(world, b, 3.0f, 0.0f);
	cn_gear_def_init(&def);
	connect(&def.base, a, at(0.0f, 0.0f), b, at(0.0f, 0.0f));
	def.ratio = ratio;
	def.phase_rad = phase;
	joint = make_gear(world, &def);
	last_a = angle_of(world, a);
	last_b = total_b = angle_of(world, b);
	for (k = 0; k < 3600; ++k) {
		must(cn_body_apply_torque(world, b, k / 300 % 2 ? 1.0f : -1.0f), world, "cn_body_apply_torque"); /* a load */
		fixture_step(world, 1);
		count_turns(world, a, &last_a, &total_a);
		count_turns(world, b, &last_b, &total_b);
		error = fabs(total_b - (double)ratio * total_a - (double)phase);
		worst = greater(worst, error);
		if (k % 300 >= 60)
			steady = greater(steady, error);
		CHECK(fabs(joint_position(world, joint) - (total_b - (double)ratio * total_a)) < 2e-5);
	}
	CHECK_GE("turns of a", fabs(total_a) / (2.0 * PI), 90.0, "");
	*out_ratio_error = fabs((total_b - (double)phase) / total_a / (double)ratio - 1.0);
	*out_worst = worst;
	*out_steady = steady;
	cn_world_destroy(world);
}

static void gear_ratio_is_exact(void)
{
	static const float ratios[] = { 1.0f, 2.5f, -3.0f, 0.1f };
	int32_t k;
	for (k = 0; k < 4; ++k) {
		double error, worst, steady;
		gear_run(ratios[k], k == 1 ? 0.7f : 0.0f, &error, &worst, &steady);
		CHECK_LE("relative error of the ratio after 60 s", error, ROUNDING / 100.0, "");
		CHECK_LE("error of the angle under a load of 1 Nm", steady, 2.0 * ROUNDING, "rad");
		CHECK_LE("worst error of the angle in 60 s, jumps included", worst, 2.0 * ROUNDING, "rad");
	}
}

static void gear_passes_torque_on(void)
{
	cn_world *world = fixture_world(0.0f, 0);
	cn_body a = fixture_circle(world, CN_BODY_DYNAMIC, 0.0f, 0.0f, 0.5f, 0.5f, 0.0f);
	cn_body b = fixture_circle(world, CN_BODY_DYNAMIC, 3.0f, 0.0f, 0.5f, 0.5f, 0.0f);
	cn_mass_data mass;
	cn_gear_def def;
	cn_joint joint;
	double w, alpha;
	int32_t k;
	mass = mass_of(world, a);
	cn_gear_def_init(&def);
	connect(&def.base, a, at(0.0f, 0.0f), b, at(0.0f, 0.0f));
	def.ratio = 2.0f;
	joint = make_gear(world, &def);
	for (k = 0; k < 60; ++k) {
		must(cn_body_apply_torque(world, a, 1.0f), world, "cn_body_apply_torque");
		fixture_step(world, 1);
	}
	/* I alpha = T - 2 R and I 2 alpha = R. */
	alpha = 1.0 / (5.0 * (double)mass.inertia_kgm2);
	w = (double)fixture_velocity(world, a).angular_radps;
	CHECK_LE("spin of a after 1 s against T t / (I + 4 I)", fabs(w / alpha - 1.0), 2.0 * ROUNDING, "");
	CHECK_LE("torque on b against 2 I alpha", fabs(joint_torque(world, joint) / (2.0 * (double)mass.inertia_kgm2 * alpha) - 1.0), 2.0 * ROUNDING, "");
	cn_world_destroy(world);
}

/* ---- pulley ---- */

static void pulley_is_an_atwood_machine(void)
{
	static const float ratios[] = { 1.0f, 2.0f };
	int32_t r, k;
	for (r = 0; r < 2; ++r) {
		double ratio = (double)ratios[r], ma = 1.0, mb = 3.0 * 1.5, a, tension, worst = 0.0, s;
		cn_world *world = fixture_world(-(float)GRAVITY, 0);
		cn_body left = unit_box(world, -1.0f, 5.0f, 0.0f);
		cn_body right = fixture_box(world, CN_BODY_DYNAMIC, 1.0f, 5.0f, 0.0f, 1.5f, 0.75f, 0.5f, 0.0f);
		cn_pulley_def def;
		cn_joint joint;
		cn_pulley_def_init(&def);
		connect(&def.base, left, at(0.0f, 0.5f), right, at(0.0f, 0.75f));
		def.ground_a_m = at(-1.0f, 20.0f);
		def.ground_b_m = at(1.0f, 20.0f);
		def.ratio = ratios[r];
		def.length_m = 14.5f + ratios[r] * 14.25f;
		joint = make_pulley(world, &def);
		for (k = 0; k < 60; ++k) {
			fixture_step(world, 1);
			worst = greater(worst, fabs(joint_position(world, joint) - (double)def.length_m));
		}
		/* a rises by ratio x b's fall: ma (ratio A) = T - ma g, mb A = mb g - ratio T. */
		a = GRAVITY * (mb - ratio * ma) / (mb + ratio * ratio * ma);
		tension = ma * (GRAVITY + ratio * a);
		s = 5.0 - (double)fixture_pose(world, right).position_m.y;
		CHECK_LE("sum of the lengths, 1 s", worst, 5e-4, "m");
		CHECK_LE("fall against A t^2 / 2", fabs(s / (0.5 * a) - 1.0), 0.01, "");
		CHECK_LE("force on b against ratio T", fabs((double)joint_force(world, joint).y / (ratio * tension) - 1.0), 2.0 * ROUNDING, "");
		CHECK_LE("error read back", joint_error_m(world, joint), 5e-4, "m");
		cn_world_destroy(world);
	}
}

/* Ropes fastened off the centres turn what they pull, and do no work: energy stays as it was. */
static void pulley_turns_what_it_pulls_off_centre(void)
{
	cn_world *world = fixture_world(-(float)GRAVITY, 0);
	cn_body boxes[2];
	cn_pulley_def def;
	cn_joint joint;
	totals before, after;
	double worst = 0.0, turn = 0.0;
	int32_t k;
	boxes[0] = unit_box(world, -2.0f, 5.0f, 0.0f);
	boxes[1] = unit_box(world, 2.0f, 5.0f, 0.0f);
	cn_pulley_def_init(&def);
	connect(&def.base, boxes[0], at(0.3f, 0.5f), boxes[1], at(0.4f, 0.5f));
	def.ground_a_m = at(-1.7f, 10.5f);
	def.ground_b_m = at(2.4f, 10.5f);
	def.length_m = 10.0f;
	joint = make_pulley(world, &def);
	before = totals_of(world, boxes, 2);
	for (k = 0; k < 60; ++k) {
		fixture_step(world, 1);
		after = totals_of(world, boxes, 2);
		worst = greater(worst, fabs(after.kinetic + after.potential - before.kinetic - before.potential));
		turn = greater(turn, fabs(angle_of(world, boxes[1])));
	}
	CHECK_LE("energy gained or lost in 1 s", worst, 0.05, "J");
	CHECK_LE("rope", fabs(joint_position(world, joint) - 10.0), 5e-3, "m");
	CHECK_GE("turn of b", turn, 0.5, "rad");
	cn_world_destroy(world);
}

static void pulley_never_pushes(void)
{
	cn_world *world = fixture_world(-(float)GRAVITY, 0);
	cn_body left = unit_box(world, -1.0f, 5.0f, 0.0f), right = unit_box(world, 1.0f, 5.0f, 0.0f);
	cn_pulley_def def;
	cn_joint joint;
	cn_pulley_def_init(&def);
	connect(&def.base, left, at(0.0f, 0.0f), right, at(0.0f, 0.0f));
	def.ground_a_m = at(-1.0f, 10.0f);
	def.ground_b_m = at(1.0f, 10.0f);
	def.length_m = 15.0f; /* 5 m of slack */
	joint = make_pulley(world, &def);
	fixture_step(world, 30);
	CHECK_LE("force while slack", fabs((double)joint_force(world, joint).y), 0.0, "N");
	CHECK_LE("fall against g t^2 / 2", fabs((double)fixture_pose(world, left).position_m.y - 5.0 + 1.25), 0.02, "m");
	fixture_step(world, 600);
	CHECK_LE("rope when taut", fabs(joint_position(world, joint) - 15.0), 1e-3, "m");
	cn_world_destroy(world);
}

/* ---- ratchet ---- */

static void ratchet_turns_one_way(void)
{
	static const float clicks[] = { 0.3f, -0.5f };
	int32_t r, k;
	for (r = 0; r < 2; ++r) {
		cn_world *world = fixture_world(0.0f, 0);
		cn_body wheel = fixture_circle(world, CN_BODY_DYNAMIC, 0.0f, 0.0f, 0.5f, 0.5f, 0.0f);
		cn_ratchet_def def;
		cn_joint joint;
		double sign = r == 0 ? 1.0 : -1.0, farthest = 0.0, back = 0.0, click = fabs((double)clicks[r]);
		axle(world, wheel, 0.0f, 0.0f);
		cn_ratchet_def_init(&def);
		connect(&def.base, 0, at(0.0f, 0.0f), wheel, at(0.0f, 0.0f));
		def.click_rad = clicks[r];
		joint = make_ratchet(world, &def);
		for (k = 0; k < 1800; ++k) {
			/* Forwards a while, then back for longer. */
			must(cn_body_apply_torque(world, wheel, (float)sign * (k % 90 < 30 ? 2.0f : -1.5f)), world, "cn_body_apply_torque");
			fixture_step(world, 1);
			farthest = greater(farthest, sign * joint_position(world, joint));
			back = greater(back, farthest - sign * joint_position(world, joint));
		}
		CHECK_GE("turns forwards", farthest / (2.0 * PI), 2.0, "");
		CHECK_LE("farthest back, in clicks", back / click, 1.01, "");
		CHECK_LE("error read back", joint_error_rad(world, joint), 2e-3, "rad");
		cn_world_destroy(world);
	}
}

/* The latch is the last click below, also where angles are negative: the wheel is free to fall back to it, and held there. */
static void ratchet_begins_at_the_click_below(void)
{
	static const float angles[] = { 0.8f, 0.2f, -0.2f, -0.8f, -1.3f };
	double worst = 0.0;
	int32_t k;
	for (k = 0; k < 5; ++k) {
		cn_world *world = fixture_world(0.0f, 0);
		cn_body wheel = fixture_body(world, CN_BODY_DYNAMIC, 0.0f, 0.0f, angles[k]);
		cn_shape_def shape = fixture_shape_def(wheel, 0.5f, 0.0f);
		cn_ratchet_def def;
		fixture_box_shape(world, &shape, 0.5f, 0.5f);
		cn_ratchet_def_init(&def);
		connect(&def.base, 0, at(0.0f, 0.0f), wheel, at(0.0f, 0.0f));
		def.click_rad = 0.5f;
		make_ratchet(world, &def);
		fixture_set_velocity(world, wheel, 0.0f, 0.0f, -0.5f);
		fixture_step(world, 120);
		worst = greater(worst, fabs(angle_of(world, wheel) - 0.5 * floor((double)angles[k] / 0.5)));
		cn_world_destroy(world);
	}
	CHECK_LE("off the click below", worst, 2e-3, "rad");
}

static void ratchet_holds_a_load(void)
{
	cn_world *world = fixture_world(-(float)GRAVITY, 0);
	cn_body bar = fixture_box(world, CN_BODY_DYNAMIC, 1.0f, 0.0f, 0.0f, 1.0f, 0.1f, 0.5f, 0.0f);
	cn_ratchet_def def;
	cn_joint joint;
	hinge(world, 0, at(0.0f, 0.0f), bar, at(-1.0f, 0.0f));
	cn_ratchet_def_init(&def);
	connect(&def.base, 0, at(0.0f, 0.0f), bar, at(-1.0f, 0.0f));
	def.click_rad = 0.25f;
	joint = make_ratchet(world, &def);
	fixture_step(world, 600);
	CHECK_LE("sag of the bar", fabs(angle_of(world, bar)), 1e-3, "rad");
	CHECK_LE("torque against m g l", fabs(joint_torque(world, joint) - 0.4 * GRAVITY * 1.0), ROUNDING, "Nm");
	cn_world_destroy(world);
}

/* ---- groove ---- */

static void groove_holds_its_pin(void)
{
	cn_world *world = fixture_world(-(float)GRAVITY, 0);
	cn_body ball = fixture_circle(world, CN_BODY_DYNAMIC, 0.0f, -0.5f, 0.25f, 0.5f, 0.0f);
	cn_groove_def def;
	cn_joint joint;
	double off = 0.0, beyond = 0.0, spin = 0.0;
	int32_t k;
	cn_groove_def_init(&def);
	connect(&def.base, 0, at(0.0f, 0.0f), ball, at(0.0f, 0.5f));
	def.end_m = at(4.0f, -3.0f);
	joint = make_groove(world, &def);
	for (k = 0; k < 1200; ++k) {
		cn_vec2 a, b;
		double across, along;
		fixture_step(world, 1);
		must(cn_joint_get_anchors(world, joint, &a, &b), world, "cn_joint_get_anchors");
		along = 0.8 * (double)b.x - 0.6 * (double)b.y;
		across = 0.6 * (double)b.x + 0.8 * (double)b.y;
		off = greater(off, fabs(across));
		spin = greater(spin, fabs((double)fixture_velocity(world, ball).angular_radps));
		beyond = greater(beyond, greater(along - 5.0, -along));
	}
	CHECK_GE("spin that it hangs on against", spin, 15.0, "rad/s");
	CHECK_LE("off the slot, 20 s", off, 0.01, "m");
	CHECK_LE("beyond its ends", beyond, 0.005, "m");
	CHECK_LE("rest at the lower end", fabs(joint_position(world, joint) - 5.0), 5.0 * SOLVED, "m");
	cn_world_destroy(world);
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(prismatic_slides_down_an_incline);
	RUN(prismatic_spring_has_its_period_and_decay);
	RUN(prismatic_motor_and_limits);
	RUN(strong_motors_stop_at_limits);
	RUN(wheel_spring_has_its_period_and_decay);
	RUN(wheel_motor_reaches_its_speed_in_time);
	RUN(mouse_drags_like_a_spring);
	RUN(mouse_keeps_to_its_force);
	RUN(motor_drives_to_an_offset);
	RUN(motor_keeps_to_its_force_and_torque);
	RUN(rotary_spring_has_its_period_and_decay);
	RUN(gear_ratio_is_exact);
	RUN(gear_passes_torque_on);
	RUN(pulley_is_an_atwood_machine);
	RUN(pulley_turns_what_it_pulls_off_centre);
	RUN(pulley_never_pushes);
	RUN(ratchet_turns_one_way);
	RUN(ratchet_begins_at_the_click_below);
	RUN(ratchet_holds_a_load);
	RUN(groove_holds_its_pin);
	return test_end();
}
