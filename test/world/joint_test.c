/*
 * test/world/joint_test.c - revolute and distance joints against closed forms: pendulums, limits, motors, ropes,
 * reactions, and what either side may be attached to. Springs are in joint_spring_test.c.
 *
 * If a test here fails, look first in: joints/joint_solve.c (reactions), direct/rattle.c (periods),
 * joints/joint_type.c (limits, motors).
 */
#include "joints.h"

#define DEGREE (PI / 180.0)

/* ---- pendulums ---- */

/* Complete elliptic integral of the first kind by the arithmetic-geometric mean (Gauss, 1799). */
static double elliptic_k(double k)
{
	double a = 1.0, b = sqrt(1.0 - k * k);
	while (fabs(a - b) > 1e-14) {
		double mean = 0.5 * (a + b);
		b = sqrt(a * b);
		a = mean;
	}
	return PI / (2.0 * a);
}

/* Time of `swings` full periods, from upward zero crossings of the angle of the bob seen from the origin. */
static double pendulum_time(cn_world *world, cn_body bob, int32_t swings, double *worst_drift)
{
	double last = -1.0, first_crossing = -1.0, energy, energy0;
	totals start = totals_of(world, &bob, 1);
	int32_t crossings = 0, k;
	energy0 = start.kinetic + start.potential;
	*worst_drift = 0.0;
	for (k = 1; k < 60 * 200; ++k) {
		cn_vec2 c;
		double angle;
		totals t;
		fixture_step(world, 1);
		must(cn_body_get_center(world, bob, &c), world, "cn_body_get_center");
		angle = atan2((double)c.x, -(double)c.y);
		t = totals_of(world, &bob, 1);
		energy = t.kinetic + t.potential;
		if (fabs(energy - energy0) > fabs(*worst_drift))
			*worst_drift = energy - energy0;
		if (last < 0.0 && angle >= 0.0 && k > 1) {
			double time = ((double)k - angle / (angle - last)) * (double)FRAME_S;
			if (crossings++ == 0)
				first_crossing = time;
			else if (crossings == swings + 1)
				return time - first_crossing;
		}
		last = angle;
	}
	return -1.0;
}

/*
 * Bodies that only joints hold move along their constraints (direct/rattle.c), so a wide swing keeps its energy and
 * its period: what is left is of second order in h.
 */
static void pendulum_run(double amplitude, int32_t rod, double period_bound)
{
	cn_world *world = fixture_world(-10.0f, 0);
	float length = 1.5f, x = (float)(1.5 * sin(amplitude)), y = (float)(-1.5 * cos(amplitude));
	cn_body bob = fixture_circle(world, CN_BODY_DYNAMIC, x, y, 0.2f, 0.6f, 0.0f);
	cn_mass_data m = mass_of(world, bob);
	double reduced = (double)length, exact, time, drift;
	cn_joint joint;
	if (rod) {
		cn_distance_def def = distance_def(0, at(0.0f, 0.0f), bob, at(0.0f, 0.0f), length);
		joint = make_distance(world, &def);
	} else {
		joint = hinge(world, 0, at(0.0f, 0.0f), bob, at(-x, -y));
		reduced += (double)m.inertia_kgm2 / ((double)m.mass_kg * (double)length);
	}
	exact = 20.0 * 4.0 * sqrt(reduced / GRAVITY) * elliptic_k(sin(0.5 * amplitude));
	time = pendulum_time(world, bob, 20, &drift);
	printf("  %s, amplitude %.2f rad: 20 swings take %.5f s, exact %.5f s; energy drift %+.2e of the swing's\n", rod ? "rod" : "hinge",
	       amplitude, time, exact, drift / ((double)m.mass_kg * GRAVITY * (double)length * (1.0 - cos(amplitude))));
	CHECK_LE("relative error of the period", fabs(time - exact) / exact, period_bound, "");
	CHECK_LE("energy gained or lost / energy of the swing", fabs(drift) / ((double)m.mass_kg * GRAVITY * (double)length * (1.0 - cos(amplitude))), 5.0 * SOLVED, "");
	CHECK_LE("error of the joint at the end", joint_error_m(world, joint), ROUNDING, "m");
	cn_world_destroy(world);
}

static void hinge_pendulum_keeps_its_period(void)
{
	pendulum_run(0.2, 0, 1e-4);
	pendulum_run(1.0, 0, 1e-4);
	pendulum_run(2.0, 0, 1e-4);
}

static void rod_pendulum_keeps_its_period(void)
{
	pendulum_run(0.2, 1, 1e-4);
	pendulum_run(1.0, 1, 1e-4);
	pendulum_run(2.0, 1, 1e-4);
}

/* A double pendulum let go above the horizontal, chaotic and fast. */
static void anchors_stay_together_60_s(void)
{
	cn_world *world = fixture_world(-10.0f, 0);
	cn_body bodies[2];
	double worst = 0.0, energy0, most = -1e9, least = 1e9;
	totals t;
	int32_t k;
	bodies[0] = fixture_box(world, CN_BODY_DYNAMIC, 0.5f, 0.0f, 0.0f, 0.5f, 0.05f, 0.6f, 0.0f);
	bodies[1] = fixture_box(world, CN_BODY_DYNAMIC, 1.5f, 0.0f, 0.0f, 0.5f, 0.05f, 0.6f, 0.0f);
	hinge(world, 0, at(0.0f, 0.0f), bodies[0], at(-0.5f, 0.0f));
	hinge(world, bodies[0], at(0.5f, 0.0f), bodies[1], at(-0.5f, 0.0f));
	t = totals_of(world, bodies, 2);
	energy0 = t.kinetic + t.potential;
	for (k = 0; k < 3600; ++k) {
		fixture_step(world, 1);
		worst = greater(worst, worst_joint_error(world));
		t = totals_of(world, bodies, 2);
		most = greater(most, t.kinetic + t.potential - energy0);
		least = fmin(least, t.kinetic + t.potential - energy0);
	}
	/* The lowest state has 2 kg m^2/s^2 less: 0.1 kg x g x (0.5 + 1.5) m. */
	printf("  double pendulum in 60 s: energy %+.2e .. %+.2e of its depth\n", least / 2.0, most / 2.0);
	CHECK_LE("greatest distance between anchors", worst, 2.0 * ROUNDING, "m");
	CHECK_LE("energy lost / depth", -least / 2.0, 5e-3, "");
	CHECK_LE("energy gained / depth", most / 2.0, 1e-3, "");
	cn_world_destroy(world);
}

/* ---- revolute limits ---- */

/* A bar hinged at its end to the world, limits on both sides, jumped against each at speed and held there by load. */
static void limit_run(double torque, double lower_deg, double upper_deg, double reference_deg, float spin)
{
	cn_world *world = fixture_world(-10.0f, 0);
	cn_body bar = fixture_box(world, CN_BODY_DYNAMIC, 0.5f, 0.0f, 0.0f, 0.5f, 0.1f, 0.6f, 0.0f);
	cn_revolute_def def = revolute_def(0, at(0.0f, 0.0f), bar, at(-0.5f, 0.0f));
	double beyond = 0.0, held;
	cn_joint joint;
	int32_t k;
	def.base.flags = CN_JOINT_LIMIT;
	def.reference_angle_rad = (float)(reference_deg * DEGREE);
	def.lower_angle_rad = (float)(lower_deg * DEGREE);
	def.upper_angle_rad = (float)(upper_deg * DEGREE);
	joint = make_revolute(world, &def);
	fixture_set_velocity(world, bar, 0.0f, 0.5f * spin, spin);
	for (k = 0; k < 600; ++k) {
		double angle;
		must(cn_body_apply_torque(world, bar, (float)torque), world, "cn_body_apply_torque");
		fixture_step(world, 1);
		angle = joint_position(world, joint);
		beyond = greater(beyond, greater(angle - upper_deg * DEGREE, lower_deg * DEGREE - angle));
		CHECK(fabs(joint_error_rad(world, joint) - fmax(0.0, fmax(angle - upper_deg * DEGREE, lower_deg * DEGREE - angle))) < 1e-5);
	}
	held = joint_position(world, joint) / DEGREE;
	printf("  limits %.0f .. %.0f degrees, torque %.0f Nm, spin %.0f rad/s: held at %.3f\n", lower_deg, upper_deg, torque, (double)spin, held);
	CHECK_LE("beyond the limit", beyond / DEGREE, 0.5, "degree");
	/* A limit is a spring of 1/(4h) = 60 Hz: torque / (I w^2), for 20 Nm on 0.07 kg m^2 that is 0.12 degrees. */
	CHECK_LE("distance of the loaded bar from its limit", fabs(held - (torque > 1.0 ? upper_deg : lower_deg)), 0.15, "degree");
	cn_world_destroy(world);
}

static void limits_hold_on_both_sides(void)
{
	limit_run(0.0, -30.0, 45.0, 0.0, 0.0f);
	limit_run(0.0, -30.0, 45.0, 0.0, 10.0f);
	limit_run(20.0, -30.0, 45.0, 0.0, -10.0f);
	limit_run(-20.0, -30.0, 45.0, 0.0, 10.0f);
	limit_run(20.0, -90.0, 10.0, 20.0, 0.0f);
	limit_run(0.0, -100.0, -20.0, 20.0, 0.0f);
}

/* Two bars as one: a cantilever under its own weight, then thrown. */
static void equal_limits_weld_the_angle(void)
{
	cn_world *world = fixture_world(-10.0f, 0);
	cn_body arm[2];
	cn_joint joint[2];
	cn_revolute_def def;
	double turn = 0.0, torque;
	int32_t k;
	arm[0] = fixture_box(world, CN_BODY_DYNAMIC, 0.5f, 0.0f, 0.0f, 0.5f, 0.1f, 0.6f, 0.0f);
	arm[1] = fixture_box(world, CN_BODY_DYNAMIC, 1.5f, 0.0f, 0.0f, 0.5f, 0.1f, 0.6f, 0.0f);
	def = revolute_def(0, at(0.0f, 0.0f), arm[0], at(-0.5f, 0.0f));
	def.base.flags = CN_JOINT_LIMIT;
	joint[0] = make_revolute(world, &def);
	def = revolute_def(arm[0], at(0.5f, 0.0f), arm[1], at(-0.5f, 0.0f));
	def.base.flags = CN_JOINT_LIMIT;
	joint[1] = make_revolute(world, &def);
	for (k = 0; k < 600; ++k) {
		fixture_step(world, 1);
		turn = greater(turn, greater(fabs(joint_position(world, joint[0])), fabs(joint_position(world, joint[1]))));
	}
	CHECK_LE("turn of a cantilever of 2 m", turn / DEGREE, 0.5, "degree");
	torque = joint_torque(world, joint[0]); /* 0.4 kg at 1 m */
	CHECK_LE("error of the torque at the wall / exact", fabs(torque - 4.0) / 4.0, ROUNDING, "");
	must(cn_joint_destroy(world, joint[0]), world, "cn_joint_destroy");
	fixture_set_velocity(world, arm[0], 3.0f, 5.0f, 8.0f);
	for (turn = 0.0, k = 0; k < 120; ++k) {
		fixture_step(world, 1);
		turn = greater(turn, fabs(joint_position(world, joint[1])));
	}
	CHECK_LE("turn of the welded pair in flight", turn / DEGREE, 0.5, "degree");
	cn_world_destroy(world);
}

/* ---- revolute motors ---- */

static void motor_reaches_its_speed_in_time(void)
{
	static const float torques[] = { 0.5f, 2.0f, 20.0f };
	size_t k;
	for (k = 0; k < sizeof torques / sizeof *torques; ++k) {
		cn_world *world = fixture_world(0.0f, 0);
		cn_body wheel = fixture_circle(world, CN_BODY_DYNAMIC, 0.0f, 0.0f, 1.0f, 0.6f, 0.0f);
		cn_revolute_def def = revolute_def(0, at(0.0f, 0.0f), wheel, at(0.0f, 0.0f));
		double inertia = (double)mass_of(world, wheel).inertia_kgm2, exact = inertia * 20.0 / (double)torques[k], last = 0.0, speed = 0.0, time = -1.0;
		cn_joint joint;
		int32_t step;
		def.base.flags = CN_JOINT_MOTOR;
		def.motor_speed_radps = 20.0f;
		def.motor_torque_max_Nm = torques[k];
		joint = make_revolute(world, &def);
		for (step = 1; step < 60 * 80; ++step) {
			fixture_step(world, 1);
			last = speed;
			speed = joint_speed(world, joint);
			if (time < 0.0 && speed >= 0.9 * 20.0) /* the ramp is straight: extrapolate from 90% */
				time = ((double)step - (speed - 18.0) / (speed - last)) * (double)FRAME_S / 0.9;
			else if (time < 0.0 && step * (double)FRAME_S < 0.8 * exact)
				CHECK(fabs(joint_torque(world, joint) - (double)torques[k]) < 1e-3 * (double)torques[k]);
		}
		printf("  torque %.1f Nm: %.4f s, exact I w / torque %.4f s\n", (double)torques[k], time, exact);
		CHECK_LE("relative error of the time", fabs(time - exact) / exact, 2.0 * ROUNDING, "");
		CHECK_LE("error of the final speed", fabs(speed - 20.0), ROUNDING, "rad/s");
		cn_world_destroy(world);
	}
}

/* A motor weaker than the weight of its bar stalls; one stronger lifts it with what is left over. */
static void motor_torque_is_limited(void)
{
	cn_world *world = fixture_world(-10.0f, 0);
	cn_body bar = fixture_box(world, CN_BODY_DYNAMIC, 0.5f, 0.0f, 0.0f, 0.5f, 0.1f, 0.6f, 0.0f); /* 0.2 kg: 1 Nm when level */
	cn_revolute_def def = revolute_def(0, at(0.0f, 0.0f), bar, at(-0.5f, 0.0f));
	double lowest = 0.0, exact;
	cn_joint joint;
	int32_t k;
	def.base.flags = CN_JOINT_MOTOR;
	def.motor_speed_radps = 3.0f;
	def.motor_torque_max_Nm = 0.5f;
	joint = make_revolute(world, &def);
	/* Work: torque x angle = m g l sin(angle) where it stops first: 0.5 a = sin a. */
	for (k = 0; k < 300; ++k) {
		fixture_step(world, 1);
		lowest = fmin(lowest, joint_position(world, joint));
		CHECK(fabs(joint_torque(world, joint)) < 0.5 * 1.001);
	}
	exact = -1.895494;
	printf("  a motor of half the torque lets the bar swing to %.5f rad, exact %.5f\n", lowest, exact);
	CHECK_LE("relative error of the swing", fabs(lowest - exact) / -exact, 2.0 * SOLVED, "");
	must(cn_joint_set_motor(world, joint, 3.0f, 50.0f), world, "cn_joint_set_motor");
	fixture_step(world, 30);
	CHECK_LE("speed error of a strong motor", fabs(joint_speed(world, joint) - 3.0), ROUNDING, "rad/s");
	cn_world_destroy(world);
}

static void motor_between_two_bodies_keeps_angular_momentum(void)
{
	cn_world *world = fixture_world(0.0f, 0);
	cn_body bodies[2];
	cn_revolute_def def;
	cn_joint joint;
	totals t;
	bodies[0] = fixture_circle(world, CN_BODY_DYNAMIC, 0.0f, 0.0f, 1.0f, 0.6f, 0.0f);
	bodies[1] = fixture_circle(world, CN_BODY_DYNAMIC, 0.0f, 0.0f, 0.5f, 0.6f, 0.0f);
	def = revolute_def(bodies[0], at(0.0f, 0.0f), bodies[1], at(0.0f, 0.0f));
	def.base.flags = CN_JOINT_MOTOR;
	def.motor_speed_radps = 15.0f;
	def.motor_torque_max_Nm = 1.0f;
	joint = make_revolute(world, &def);
	fixture_step(world, 600);
	t = totals_of(world, bodies, 2);
	CHECK_LE("error of the relative speed", fabs(joint_speed(world, joint) - 15.0), ROUNDING, "rad/s");
	CHECK_LE("angular momentum / its parts", fabs(t.spin) / t.spin_scale, 1e-6, "");
	cn_world_destroy(world);
}

/* ---- distance limits and motor ---- */

static void rope_is_slack_then_holds(void)
{
	cn_world *world = fixture_world(-10.0f, 0);
	cn_body ball = fixture_circle(world, CN_BODY_DYNAMIC, 0.0f, 0.0f, 0.2f, 0.6f, 0.0f);
	cn_distance_def def = distance_def(0, at(0.0f, 0.0f), ball, at(0.0f, 0.0f), 1.0f);
	double longest = 0.0, fall, weight = (double)mass_of(world, ball).mass_kg * GRAVITY;
	cn_joint rope;
	int32_t k;
	def.base.flags = CN_JOINT_LIMIT;
	def.length_min_m = 0.0f;
	def.length_max_m = 2.0f;
	rope = make_distance(world, &def);
	fixture_step(world, 30);
	fall = -(double)fixture_pose(world, ball).position_m.y;
	/* Jointed bodies move by x += h v': ahead by g t h / 2 = 10.4 mm. */
	CHECK_LE("error of the free fall inside the rope", fabs(fall - 1.25), 0.011, "m");
	for (k = 0; k < 600; ++k) {
		fixture_step(world, 1);
		longest = greater(longest, joint_position(world, rope));
	}
	CHECK_LE("length of a rope of 2 m that stopped a fall", longest, 2.005, "m");
	CHECK_LE("error of the force at rest / weight", fabs((double)joint_force(world, rope).y - weight) / weight, ROUNDING, "");
	cn_world_destroy(world);
}

static void least_length_holds_too(void)
{
	cn_world *world = fixture_world(-10.0f, 0);
	cn_body ball = fixture_circle(world, CN_BODY_DYNAMIC, 0.0f, 3.0f, 0.2f, 0.6f, 0.0f);
	cn_distance_def def = distance_def(0, at(0.0f, 0.0f), ball, at(0.0f, 0.0f), 3.0f);
	double shortest = 10.0;
	cn_joint joint;
	int32_t k;
	def.base.flags = CN_JOINT_LIMIT | CN_JOINT_SPRING;
	def.spring_hertz = 0.1f;
	def.length_min_m = 1.0f;
	def.length_max_m = 4.0f;
	joint = make_distance(world, &def);
	must(cn_body_set_flags(world, ball, CN_BODY_ENABLED | CN_BODY_LOCK_X), world, "cn_body_set_flags");
	for (k = 0; k < 180; ++k) {
		fixture_step(world, 1);
		shortest = fmin(shortest, joint_position(world, joint));
	}
	CHECK_GE("shortest length of a spring of least length 1 m", shortest, 0.995, "m");
	CHECK_LE("and it was reached", shortest, 1.001, "m");
	cn_world_destroy(world);
}

static void distance_motor_drives_and_is_limited(void)
{
	cn_world *world = fixture_world(-10.0f, 0);
	cn_body ball = fixture_circle(world, CN_BODY_DYNAMIC, 0.0f, -1.0f, 0.2f, 0.6f, 0.0f);
	cn_distance_def def = distance_def(0, at(0.0f, 0.0f), ball, at(0.0f, 0.0f), 1.0f);
	double mass = (double)mass_of(world, ball).mass_kg, fall;
	cn_joint winch;
	def.base.flags = CN_JOINT_LIMIT | CN_JOINT_MOTOR;
	def.length_min_m = 0.5f;
	def.length_max_m = 20.0f;
	def.motor_speed_mps = 0.25f;
	def.motor_force_max_N = (float)(5.0 * mass * GRAVITY);
	winch = make_distance(world, &def);
	fixture_step(world, 60);
	CHECK_LE("error of the length let out in 1 s", fabs(joint_position(world, winch) - 1.25), ROUNDING, "m");
	CHECK_LE("speed error", fabs(joint_speed(world, winch) - 0.25), ROUNDING, "m/s");
	must(cn_joint_set_motor(world, winch, -0.5f, (float)(5.0 * mass * GRAVITY)), world, "cn_joint_set_motor");
	fixture_step(world, 60);
	CHECK_LE("error of the length pulled in", fabs(joint_position(world, winch) - 0.75), 0.01, "m");
	fixture_step(world, 120);
	CHECK_LE("error of the length at the lower limit", fabs(joint_position(world, winch) - 0.5), 2e-3, "m");
	/* Half the weight: falls with g / 2. */
	must(cn_joint_set_motor(world, winch, 0.0f, (float)(0.5 * mass * GRAVITY)), world, "cn_joint_set_motor");
	fixture_step(world, 60);
	fall = joint_position(world, winch) - 0.5;
	CHECK_LE("error of the braked fall in 1 s", fabs(fall - 2.5), 0.05, "m");
	CHECK_LE("error of the braking force", fabs((double)joint_force(world, winch).y - 0.5 * mass * GRAVITY) / (0.5 * mass * GRAVITY), ROUNDING, "");
	cn_world_destroy(world);
}

/* ---- what a joint may be attached to ---- */

static void world_static_and_kinematic_sides(void)
{
	int32_t side, order;
	for (side = 0; side < 3; ++side)
		for (order = 0; order < 2; ++order) {
			cn_world *world = fixture_world(-10.0f, 0);
			cn_body holder = side == 0 ? 0 : fixture_body(world, side == 1 ? CN_BODY_STATIC : CN_BODY_KINEMATIC, 100.0f, 50.0f, 0.0f);
			cn_body weight = fixture_box(world, CN_BODY_DYNAMIC, 100.0f, 49.0f, 0.0f, 0.2f, 0.2f, 0.6f, 0.0f);
			cn_vec2 hold = side == 0 ? at(100.0f, 50.0f) : at(0.0f, 0.0f);
			cn_joint joint = order ? hinge(world, weight, at(0.0f, 1.0f), holder, hold) : hinge(world, holder, hold, weight, at(0.0f, 1.0f));
			double expected = (double)mass_of(world, weight).mass_kg * GRAVITY * (order ? -1.0 : 1.0), worst = 0.0;
			cn_pose p;
			int32_t k;
			if (side == 2)
				fixture_set_velocity(world, holder, 0.0f, 2.0f, 0.0f);
			for (k = 0; k < 120; ++k) {
				fixture_step(world, 1);
				worst = greater(worst, joint_error_m(world, joint));
			}
			p = fixture_pose(world, weight);
			printf("  weight on %s, as body %s\n", side == 0 ? "the world" : side == 1 ? "a static body" : "a kinematic body", order ? "a" : "b");
			CHECK_LE("distance between anchors", worst, side == 2 ? 5e-3 : ROUNDING, "m");
			CHECK_LE("distance from where it should hang", fabs((double)p.position_m.y - (side == 2 ? 53.0 : 49.0)), side == 2 ? 5.0 * SOLVED : ROUNDING, "m");
			CHECK_LE("error of the reaction / weight", fabs((double)joint_force(world, joint).y - expected) / fabs(expected), 2.0 * ROUNDING, "");
			CHECK(fixture_is_valid(world));
			cn_world_destroy(world);
		}
}

/* A kinematic wheel carries a bar around: the bar's end stays on its rim. */
static void kinematic_body_carries(void)
{
	cn_world *world = fixture_world(0.0f, 0);
	cn_body wheel = fixture_circle(world, CN_BODY_KINEMATIC, 0.0f, 0.0f, 1.0f, 0.6f, 0.0f);
	cn_body bar = fixture_box(world, CN_BODY_DYNAMIC, 1.5f, 0.0f, 0.0f, 0.5f, 0.05f, 0.6f, 0.0f);
	cn_joint joint = hinge(world, wheel, at(1.0f, 0.0f), bar, at(-0.5f, 0.0f));
	double worst = 0.0;
	int32_t k;
	fixture_set_velocity(world, wheel, 0.0f, 0.0f, 5.0f);
	fixture_set_velocity(world, bar, 0.0f, 7.5f, 5.0f);
	for (k = 0; k < 600; ++k) {
		fixture_step(world, 1);
		worst = greater(worst, joint_error_m(world, joint));
	}
	CHECK_LE("distance between anchors on a rim at 5 m/s", worst, 2e-3, "m");
	cn_world_destroy(world);
}

/* ---- reactions ---- */

static void hanging_weight_pulls_with_its_weight(void)
{
	int32_t type;
	for (type = 0; type < 2; ++type) {
		cn_world *world = fixture_world(-10.0f, 0);
		cn_body weight = fixture_box(world, CN_BODY_DYNAMIC, 0.0f, -1.0f, 0.0f, 0.3f, 0.2f, 0.6f, 0.0f);
		cn_distance_def def = distance_def(0, at(0.0f, 0.0f), weight, at(0.0f, 0.0f), 1.0f);
		cn_joint joint = type ? make_distance(world, &def) : hinge(world, 0, at(0.0f, 0.0f), weight, at(0.0f, 1.0f));
		double exact = (double)mass_of(world, weight).mass_kg * GRAVITY;
		cn_vec2 force;
		fixture_step(world, 120);
		force = joint_force(world, joint);
		printf("  %s: %.5f N, exact %.5f N\n", type ? "rod" : "hinge", (double)force.y, exact);
		CHECK_LE("relative error of the reaction", hypot((double)force.x, (double)force.y - exact) / exact, ROUNDING, "");
		cn_world_destroy(world);
	}
}

/* The reaction of a joint to a kinematic body says nothing of a dynamic one, whose joint would begin with it. */
static void joints_begin_anew_when_a_type_changes(void)
{
	cn_world *world = fixture_world(-10.0f, 0);
	cn_body holder = fixture_body(world, CN_BODY_KINEMATIC, 0.0f, 0.0f, 0.0f);
	cn_body weight = fixture_box(world, CN_BODY_DYNAMIC, 0.0f, -1.0f, 0.0f, 0.3f, 0.2f, 0.6f, 0.0f);
	cn_joint joint = hinge(world, holder, at(0.0f, 0.0f), weight, at(0.0f, 1.0f));
	fixture_step(world, 60);
	CHECK_GE("reaction of a kinematic body", (double)joint_force(world, joint).y, 1.0, "N");
	must(cn_body_set_type(world, holder, CN_BODY_DYNAMIC), world, "cn_body_set_type");
	CHECK_LE("... that became dynamic", fabs((double)joint_force(world, joint).y), 0.0, "N");
	cn_world_destroy(world);
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(hinge_pendulum_keeps_its_period);
	RUN(rod_pendulum_keeps_its_period);
	RUN(anchors_stay_together_60_s);
	RUN(limits_hold_on_both_sides);
	RUN(equal_limits_weld_the_angle);
	RUN(motor_reaches_its_speed_in_time);
	RUN(motor_torque_is_limited);
	RUN(motor_between_two_bodies_keeps_angular_momentum);
	RUN(rope_is_slack_then_holds);
	RUN(least_length_holds_too);
	RUN(distance_motor_drives_and_is_limited);
	RUN(world_static_and_kinematic_sides);
	RUN(kinematic_body_carries);
	RUN(hanging_weight_pulls_with_its_weight);
	RUN(joints_begin_anew_when_a_type_changes);
	return test_end();
}
