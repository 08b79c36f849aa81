/*
 * test/world/joint_types_test.c - every joint type but revolute and distance (joint_test.c) against closed
 * forms, and what all types promise alike: bounded errors, stiffness, bounds on force, breaking, events,
 * setters, sleep, destruction.
 *
 * If a test here fails, look first in: model/joint_<type>.c (its rows), model/joint_turns.c (gear, ratchet,
 * rotary spring), stages/joint_solve.c (bounds, stiffness, breaking), world/joint_kinds.c (definitions).
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
	CHECK_LE("way against g sin(30) t^2 / 2, 0.5 to 2 s", worst, 0.01, "");
	CHECK_LE("speed against g sin(30) t after 2 s", fabs(joint_speed(world, joint) / (GRAVITY * sin(tilt) * 2.0) - 1.0), 1e-4, "");
	CHECK_LE("off the axis", side, 1e-4, "m");
	CHECK_LE("turned", turn, 1e-4, "rad");
	{
		cn_vec2 f = joint_force(world, joint);
		CHECK_LE("reaction against m g cos(30)", fabs(hypot((double)f.x, (double)f.y) - GRAVITY * cos(tilt)), 0.01, "N");
		CHECK_LE("moment about the centre", fabs(joint_torque(world, joint) + cos(0.3) * (0.1 * (double)f.y - 0.2 * (double)f.x) - sin(0.3) * (0.2 * (double)f.y + 0.1 * (double)f.x)), 1e-3, "Nm");
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
	CHECK_LE("speed after 0.25 s against F t / m", fabs(joint_speed(world, joint) - 1.0), 1e-4, "m/s");
	fixture_step(world, 30);
	CHECK_LE("speed after F t / m > v against v", fabs(joint_speed(world, joint) - 2.0), 1e-4, "m/s");
	for (k = 0; k < 120; ++k) {
		fixture_step(world, 1);
		beyond = greater(beyond, joint_position(world, joint) - 3.0);
	}
	CHECK_LE("beyond the upper limit", beyond, 1e-3, "m");
	CHECK_LE("force of the motor at the limit", fabs((double)joint_force(world, joint).x), 1e-3, "N");
	must(cn_joint_set_motor(world, joint, -2.0f, 4.0f), world, "cn_joint_set_motor");
	must(cn_joint_set_limits(world, joint, 1.0f, 3.0f), world, "cn_joint_set_limits");
	fixture_step(world, 180);
	CHECK_LE("rest at the new lower limit", fabs(joint_position(world, joint) - 1.0), 2e-3, "m");
	cn_world_destroy(world);
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
		CHECK_LE("wheel still turns at 20", fabs(joint_speed(world, joint) - 20.0), 1e-3, "rad/s");
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
	CHECK_LE("sag against g / w^2", fabs(joint_position(world, joint) + GRAVITY / pow(2.0 * PI * 5.0, 2.0)), 2e-4, "m");
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
	CHECK_LE("from the new target", joint_position(world, joint), 1e-3, "m");
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
	CHECK_LE("speed after 1 s against F t / m", fabs((double)fixture_velocity(world, box).linear_mps.x - 5.0), 0.01, "m/s");
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
	CHECK_LE("way against the closed form over 10 s", worst, 0.03, "m");
	CHECK_LE("angle against the closed form over 10 s", turn, 0.01, "rad");
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
	CHECK_LE("spin after 1 s against (T - T max) t / I", fabs((double)fixture_velocity(world, box).angular_radps - 0.02 / UNIT_INERTIA), 0.02, "rad/s");
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
		CHECK_LE("spin of both together", fabs((double)(fixture_velocity(world, a).angular_radps + fixture_velocity(world, b).angular_radps)), 1e-3, "rad/s");
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
		CHECK_LE("relative error of the ratio after 60 s", error, 1e-5, "");
		CHECK_LE("error of the angle under a load of 1 Nm", steady, 1e-3, "rad");
		CHECK_LE("worst error of the angle in 60 s, shocks included", worst, 0.02, "rad");
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
	CHECK_LE("spin of a after 1 s against T t / (I + 4 I)", fabs(w / alpha - 1.0), 1e-3, "");
	CHECK_LE("torque on b against 2 I alpha", fabs(joint_torque(world, joint) / (2.0 * (double)mass.inertia_kgm2 * alpha) - 1.0), 1e-3, "");
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
		CHECK_LE("force on b against ratio T", fabs((double)joint_force(world, joint).y / (ratio * tension) - 1.0), 0.002, "");
		CHECK_LE("error read back", joint_error_m(world, joint), 5e-4, "m");
		cn_world_destroy(world);
	}
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
	CHECK_LE("torque against m g l", fabs(joint_torque(world, joint) - 0.4 * GRAVITY * 1.0), 0.02, "Nm");
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
	CHECK_LE("rest at the lower end", fabs(joint_position(world, joint) - 5.0), 2e-3, "m");
	cn_world_destroy(world);
}

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
	CHECK_LE("sag of the tip of 10 m", mean, 2.0, "m");
	CHECK_LE("last sag against its mean over 5 s", fabs(sag - mean), 0.01, "m");
	CHECK_LE("largest gap", m, 0.02, "m");
	CHECK_LE("largest turn in one weld", rad, 0.1, "rad");
	CHECK_LE("force on the wall against the weight", fabs((double)joint_force(world, first).y / (2.5 * GRAVITY) - 1.0), 0.02, "");
	CHECK_LE("torque on the wall against m g l / 2", fabs(joint_torque(world, first) / (2.5 * GRAVITY * 5.0) - 1.0), 0.05, "");
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
	def.base.stiffness_hertz = 0.0f;
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
	CHECK_LE("torque read back", fabs(joint_torque(world, twist) + 1.0), 1e-3, "Nm");
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
	CHECK_LE("turn below the bound", joint_error_rad(world, joint), 1e-2, "rad");
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
	CHECK_LE("speed after 0.5 s against (P - F) t / m", fabs(hypot((double)fixture_velocity(world, box).linear_mps.x, (double)fixture_velocity(world, box).linear_mps.y) - 2.5), 0.02, "m/s");
	CHECK_LE("turn while the point gives way", joint_error_rad(world, joint), 1e-2, "rad");
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
	CHECK_LE("speed after 1 s against (g - F/m) t", fabs(joint_speed(world, joint) + 4.0), 0.02, "m/s");
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
	CHECK_LE(what, hypot((double)f.x, (double)f.y - GRAVITY), 0.01, "N");
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
	CHECK_LE("fixed: torque against m g l", fabs(joint_torque(world, joints[0]) - 2.0 * GRAVITY), 0.05, "Nm");
	CHECK_LE("wheel: sag against g / w^2", fabs(joint_position(world, joints[2]) + GRAVITY / pow(2.0 * PI, 2.0)), 1e-3, "m");
	CHECK_LE("mouse: sag against g / w^2", fabs(joint_position(world, joints[4]) - GRAVITY / pow(10.0 * PI, 2.0)), 1e-4, "m");
	cn_world_destroy(world);
}

/* ---- all types ---- */

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
	CHECK_LE("both rest on the floor", fabs((double)(fixture_pose(world, a).position_m.y - fixture_pose(world, b).position_m.y)), 1e-3, "m");
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
	RUN(prismatic_slides_down_an_incline);
	RUN(prismatic_spring_has_its_period_and_decay);
	RUN(prismatic_motor_and_limits);
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
	RUN(pulley_never_pushes);
	RUN(ratchet_turns_one_way);
	RUN(ratchet_holds_a_load);
	RUN(groove_holds_its_pin);
	RUN(cantilever_of_ten_boxes);
	RUN(weld_has_its_stiffness);
	RUN(rigid_parts_keep_to_their_force);
	RUN(limits_keep_to_their_force);
	RUN(joints_break_at_their_threshold);
	RUN(a_blow_breaks_a_joint);
	RUN(bodies_take_their_joints_along);
	RUN(reactions_agree_with_statics);
	RUN(errors_stay_bounded_for_a_minute);
	RUN(jointed_bodies_sleep_and_wake_together);
	RUN(every_way_to_end_a_joint);
	RUN(a_filter_only_filters);
	RUN(what_is_set_is_read_back);
	RUN(runs_are_equal);
	return test_end();
}
