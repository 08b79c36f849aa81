/*
 * test/world/joint_test.c - joints against closed forms, and what the API promises of them.
 *
 * If a test here fails, look first in: stages/joint_solve.c (periods, stretch, reactions, momentum),
 * stages/solve_make.c (springs), model/joint_revolute.c and joint_distance.c (limits, motors),
 * model/joint.c (lists, sleep, collide), world/joint*.c (setters).
 */
#include "joints.h"
#include "scenes/build.h"

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
 * Bodies that only joints hold move along their constraints (stages/joint_swing.c), so a wide swing keeps its energy and
 * its period: what is left is of second order in h.
 */
static void pendulum_run(double amplitude, int32_t rod, double period_bound, double error_bound_m)
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
	CHECK_LE("energy gained / energy of the swing", drift / ((double)m.mass_kg * GRAVITY * (double)length * (1.0 - cos(amplitude))), 1e-3, "");
	CHECK_LE("error of the joint at the end", joint_error_m(world, joint), error_bound_m, "m");
	cn_world_destroy(world);
}

static void hinge_pendulum_keeps_its_period(void)
{
	pendulum_run(0.2, 0, 1e-4, 1e-4);
	pendulum_run(1.0, 0, 1e-4, 1e-4);
	pendulum_run(2.0, 0, 1e-4, 1e-4);
}

static void rod_pendulum_keeps_its_period(void)
{
	pendulum_run(0.2, 1, 1e-4, 1e-4);
	pendulum_run(1.0, 1, 1e-4, 1e-4);
	pendulum_run(2.0, 1, 1e-4, 1e-4);
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
		worst = fmax(worst, worst_joint_error(world));
		t = totals_of(world, bodies, 2);
		most = fmax(most, t.kinetic + t.potential - energy0);
		least = fmin(least, t.kinetic + t.potential - energy0);
	}
	/* The lowest state has 2 kg m^2/s^2 less: 0.1 kg x g x (0.5 + 1.5) m. */
	printf("  double pendulum in 60 s: energy %+.2e .. %+.2e of its depth\n", least / 2.0, most / 2.0);
	CHECK_LE("greatest distance between anchors", worst, 1e-4, "m");
	CHECK_LE("energy gained / depth", most / 2.0, 1e-3, "");
	cn_world_destroy(world);
}

/* ---- revolute limits ---- */

/* A bar hinged at its end to the world, limits on both sides, struck against each at speed and held there by load. */
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
		beyond = fmax(beyond, fmax(angle - upper_deg * DEGREE, lower_deg * DEGREE - angle));
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
		turn = fmax(turn, fmax(fabs(joint_position(world, joint[0])), fabs(joint_position(world, joint[1]))));
	}
	CHECK_LE("turn of a cantilever of 2 m", turn / DEGREE, 0.5, "degree");
	torque = joint_torque(world, joint[0]); /* 0.4 kg at 1 m */
	CHECK_LE("error of the torque at the wall / exact", fabs(torque - 4.0) / 4.0, 0.02, "");
	must(cn_joint_destroy(world, joint[0]), world, "cn_joint_destroy");
	fixture_set_velocity(world, arm[0], 3.0f, 5.0f, 8.0f);
	for (turn = 0.0, k = 0; k < 120; ++k) {
		fixture_step(world, 1);
		turn = fmax(turn, fabs(joint_position(world, joint[1])));
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
		CHECK_LE("relative error of the time", fabs(time - exact) / exact, 0.02, "");
		CHECK_LE("error of the final speed", fabs(speed - 20.0), 1e-4, "rad/s");
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
	CHECK_LE("relative error of the swing", fabs(lowest - exact) / -exact, 0.01, "");
	must(cn_joint_set_motor(world, joint, 3.0f, 50.0f), world, "cn_joint_set_motor");
	fixture_step(world, 30);
	CHECK_LE("speed error of a strong motor", fabs(joint_speed(world, joint) - 3.0), 1e-3, "rad/s");
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
	CHECK_LE("error of the relative speed", fabs(joint_speed(world, joint) - 15.0), 1e-4, "rad/s");
	CHECK_LE("angular momentum / its parts", fabs(t.spin) / t.spin_scale, 1e-6, "");
	cn_world_destroy(world);
}

/* ---- springs ---- */

/*
 * Free motion on a spring, sampled once a frame, obeys x2 = T x1 - D x0 with D = e^(-2 zeta w H) and
 * T = 2 e^(-zeta w H) cos(wd H). T and D by least squares over the samples give frequency and decay rate.
 */
typedef struct spring_fit {
	double yy, yz, zz, yx, zx; /* y = x1, z = -x0 */
	double eg, gg;             /* of critical_add */
} spring_fit;

static void fit_add(spring_fit *f, double x0, double x1, double x2)
{
	f->yy += x1 * x1;
	f->yz -= x1 * x0;
	f->zz += x0 * x0;
	f->yx += x1 * x2;
	f->zx -= x0 * x2;
}

static void fit_solve(const spring_fit *f, double *trace, double *det)
{
	double d = f->yy * f->zz - f->yz * f->yz;
	*trace = (f->yx * f->zz - f->zx * f->yz) / d;
	*det = (f->yy * f->zx - f->yz * f->yx) / d;
}

/* T = 2 z, D = z^2 with the double eigenvalue z: one unknown, near its exact value. */
static void critical_add(spring_fit *f, double z, double x0, double x1, double x2)
{
	double e = x2 - 2.0 * z * x1 + z * z * x0, g = 2.0 * z * x0 - 2.0 * x1;
	f->eg += e * g;
	f->gg += g * g;
}

/* Steps a joint whose spring was pulled by 1 and let go, and compares frequency and decay with the law. */
static void spring_check(cn_world *world, cn_joint joint, double rest, double hertz, double zeta, const char *what)
{
	int32_t critical = zeta == 1.0; /* gone in a few frames: one substep a step, and every one is a sample */
	double w = 2.0 * PI * hertz, frame = critical ? 0.25 * (double)FRAME_S : (double)FRAME_S, x[3] = { 0.0, 0.0, 0.0 }, trace, det, first = 0.0, last = 0.0;
	double slow = w * (zeta - sqrt(fmax(zeta * zeta - 1.0, 0.0))), settle = 0.1 / hertz;
	spring_fit fit = { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 };
	int32_t skipped = critical ? 14 : 4; /* the spring's force comes up in the first substeps */
	int32_t samples = 0, first_at = 0, last_at = 0, k, steps = (int32_t)(20.0 / hertz / frame) + 8;
	if (critical)
		must(cn_world_set_substep_count(world, 1), world, "cn_world_set_substep_count");
	for (k = 0; k < steps; ++k) {
		x[0] = x[1];
		x[1] = x[2];
		x[2] = joint_position(world, joint) - rest;
		if (zeta > 0.0 && fabs(x[2]) < (critical ? 1e-5 : 1e-3))
			break;
		if (k >= skipped) {
			++samples;
			fit_add(&fit, x[0], x[1], x[2]);
			critical_add(&fit, exp(-w * frame), x[0], x[1], x[2]);
		}
		if (zeta > 1.0 && (double)k * frame >= settle) {
			if (first_at == 0) {
				first_at = k;
				first = x[2];
			}
			last_at = k;
			last = x[2];
		}
		must(cn_world_step(world, (float)frame), world, "cn_world_step");
	}
	if (zeta > 1.0) { /* the quick root is gone after a moment: what is left decays by the slow one */
		double rate = log(first / last) / ((double)(last_at - first_at) * frame);
		printf("  %s %4.1f Hz, damping ratio %.1f: decay %.5f /s, exact %.5f /s\n", what, hertz, zeta, rate, slow);
		CHECK_LE("relative error of the decay", fabs(rate - slow) / slow, 1e-3, "");
		return;
	}
	fit_solve(&fit, &trace, &det);
	if (critical) {
		double rate = w - log(1.0 - fit.eg / fit.gg / exp(-w * frame)) / frame;
		printf("  %s %4.1f Hz, damping ratio %.1f: decay %.5f /s, exact %.5f /s, from %d samples\n", what, hertz, zeta, rate, w, (int)samples);
		CHECK_LE("relative error of the decay", fabs(rate - w) / w, 1e-3, "");
	} else {
		double turn = acos(fmin(fmax(0.5 * trace / sqrt(det), -1.0), 1.0)) / frame, turn_exact = w * sqrt(1.0 - zeta * zeta), rate = -0.5 * log(det) / frame;
		printf("  %s %4.1f Hz, damping ratio %.1f: period %.6f s, exact %.6f s; decay %.5f /s, exact %.5f /s\n", what, hertz, zeta,
		       2.0 * PI / turn, 2.0 * PI / turn_exact, rate, zeta * w);
		CHECK_LE("relative error of the period", fabs(turn - turn_exact) / turn_exact, 1e-3, "");
		CHECK_LE("error of the decay / frequency", fabs(rate - zeta * w) / w, 1e-3, "");
	}
}

static const double spring_hertz[] = { 1.0, 2.0, 5.0, 10.0, 20.0 };
static const double spring_zeta[] = { 0.0, 0.1, 1.0, 3.0 };

static void revolute_spring_follows_the_law(void)
{
	size_t f, z;
	for (f = 0; f < 5; ++f)
		for (z = 0; z < 4; ++z) {
			cn_world *world = fixture_world(0.0f, 0);
			cn_body wheel = fixture_circle(world, CN_BODY_DYNAMIC, 0.0f, 0.0f, 0.7f, 0.6f, 0.0f);
			cn_revolute_def def = revolute_def(0, at(0.0f, 0.0f), wheel, at(0.0f, 0.0f));
			def.base.flags = CN_JOINT_SPRING;
			def.spring_target_rad = 1.0f;
			def.spring_hertz = (float)spring_hertz[f];
			def.spring_damping_ratio = (float)spring_zeta[z];
			spring_check(world, make_revolute(world, &def), 1.0, spring_hertz[f], spring_zeta[z], "angle");
			cn_world_destroy(world);
		}
}

/* A bar pinned at its end: the spring's frequency is that of the bar about its pin. */
static void spring_moves_a_pinned_bar_at_its_frequency(void)
{
	size_t f;
	for (f = 0; f < 5; ++f) {
		cn_world *world = fixture_world(0.0f, 0);
		cn_body bar = fixture_box(world, CN_BODY_DYNAMIC, 1.0f, 0.0f, 0.0f, 1.0f, 0.1f, 0.6f, 0.0f);
		cn_revolute_def def = revolute_def(0, at(0.0f, 0.0f), bar, at(-1.0f, 0.0f));
		def.base.flags = CN_JOINT_SPRING;
		def.spring_target_rad = 0.1f;
		def.spring_hertz = (float)spring_hertz[f];
		def.spring_damping_ratio = 0.1f;
		spring_check(world, make_revolute(world, &def), 0.1, spring_hertz[f], 0.1, "bar");
		cn_world_destroy(world);
	}
}

static void distance_spring_follows_the_law(void)
{
	size_t f, z;
	for (f = 0; f < 5; ++f)
		for (z = 0; z < 4; ++z) {
			cn_world *world = fixture_world(0.0f, 0);
			cn_body a = fixture_circle(world, CN_BODY_DYNAMIC, 0.0f, 0.0f, 0.2f, 0.6f, 0.0f);
			cn_body b = fixture_circle(world, CN_BODY_DYNAMIC, 3.0f, 0.0f, 0.4f, 0.6f, 0.0f);
			cn_distance_def def = distance_def(a, at(0.0f, 0.0f), b, at(0.0f, 0.0f), 2.0f);
			def.base.flags = CN_JOINT_SPRING;
			def.spring_hertz = (float)spring_hertz[f];
			def.spring_damping_ratio = (float)spring_zeta[z];
			spring_check(world, make_distance(world, &def), 2.0, spring_hertz[f], spring_zeta[z], "length");
			cn_world_destroy(world);
		}
}

/* A weight on a spring comes to rest at g / w^2 below the spring's length. */
static void loaded_spring_sags_as_hooke_says(void)
{
	static const double hertz[] = { 1.0, 2.0, 5.0, 10.0, 20.0 }, zeta[] = { 0.1, 0.7, 1.0, 3.0 };
	size_t f, z;
	for (f = 0; f < 5; ++f)
		for (z = 0; z < 4; ++z) {
			cn_world *world = fixture_world(-10.0f, 0);
			double w = 2.0 * PI * hertz[f], exact = GRAVITY / (w * w), sag;
			cn_body weight = fixture_circle(world, CN_BODY_DYNAMIC, 0.0f, (float)(-1.0 - exact), 0.3f, 0.6f, 0.0f);
			cn_distance_def def = distance_def(0, at(0.0f, 0.0f), weight, at(0.0f, 0.0f), 1.0f);
			cn_joint joint;
			def.base.flags = CN_JOINT_SPRING;
			def.spring_hertz = (float)hertz[f];
			def.spring_damping_ratio = (float)zeta[z];
			joint = make_distance(world, &def);
			fixture_step(world, 1200);
			sag = joint_position(world, joint) - 1.0;
			printf("  %4.1f Hz, damping ratio %.1f: sag %.6f m, exact %.6f m\n", hertz[f], zeta[z], sag, exact);
			/* Light damping at 10 Hz and more keeps its motion exact and gives up a little of this. */
			CHECK_LE("relative error of the sag", fabs(sag - exact) / exact, zeta[z] < 0.5 && hertz[f] > 5.0 ? 0.03 : 1e-3, "");
			cn_world_destroy(world);
		}
}

/* Whatever the substep: a spring that is stiffer than it can follow must still hold. */
static void stiff_springs_hold(void)
{
	static const float hertz[] = { 60.0f, 120.0f, 240.0f, 480.0f, 1e4f, 1e6f };
	static const float zeta[] = { 0.0f, 0.1f, 1.0f, 10.0f };
	size_t f, z;
	double worst = 0.0;
	for (f = 0; f < 6; ++f)
		for (z = 0; z < 4; ++z) {
			cn_world *world = fixture_world(-10.0f, 0);
			cn_body weight = fixture_circle(world, CN_BODY_DYNAMIC, 0.0f, -1.0f, 0.3f, 0.6f, 0.0f);
			cn_distance_def def = distance_def(0, at(0.0f, 0.0f), weight, at(0.0f, 0.0f), 1.0f);
			double most = 0.0;
			cn_joint joint;
			int32_t k;
			def.base.flags = CN_JOINT_SPRING;
			def.spring_hertz = hertz[f];
			def.spring_damping_ratio = zeta[z];
			joint = make_distance(world, &def);
			for (k = 0; k < 600; ++k) {
				fixture_step(world, 1);
				most = fmax(most, fabs(joint_position(world, joint) - 1.0));
			}
			if (most > 1e-3)
				printf("  %g Hz, damping ratio %g: %.6f m\n", (double)hertz[f], (double)zeta[z], most);
			worst = fmax(worst, most);
			cn_world_destroy(world);
		}
	/* 2 g / w^2 at 60 Hz is 0.14 mm, one substep's fall g h^2 = 0.17 mm. */
	CHECK_LE("most stretch of a stiff spring under a weight", worst, 1e-3, "m");
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
		longest = fmax(longest, joint_position(world, rope));
	}
	CHECK_LE("length of a rope of 2 m that stopped a fall", longest, 2.005, "m");
	CHECK_LE("error of the force at rest / weight", fabs((double)joint_force(world, rope).y - weight) / weight, 0.01, "");
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
	CHECK_LE("error of the length let out in 1 s", fabs(joint_position(world, winch) - 1.25), 2e-3, "m");
	CHECK_LE("speed error", fabs(joint_speed(world, winch) - 0.25), 1e-3, "m/s");
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
	CHECK_LE("error of the braking force", fabs((double)joint_force(world, winch).y - 0.5 * mass * GRAVITY) / (0.5 * mass * GRAVITY), 1e-3, "");
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
				worst = fmax(worst, joint_error_m(world, joint));
			}
			p = fixture_pose(world, weight);
			printf("  weight on %s, as body %s\n", side == 0 ? "the world" : side == 1 ? "a static body" : "a kinematic body", order ? "a" : "b");
			CHECK_LE("distance between anchors", worst, side == 2 ? 0.01 : 1e-3, "m");
			CHECK_LE("distance from where it should hang", fabs((double)p.position_m.y - (side == 2 ? 53.0 : 49.0)), side == 2 ? 5e-3 : 1e-3, "m");
			CHECK_LE("error of the reaction / weight", fabs((double)joint_force(world, joint).y - expected) / fabs(expected), 0.01, "");
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
		worst = fmax(worst, joint_error_m(world, joint));
	}
	CHECK_LE("distance between anchors on a rim at 5 m/s", worst, 2e-3, "m");
	cn_world_destroy(world);
}

/* ---- reactions, chains ---- */

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
		CHECK_LE("relative error of the reaction", hypot((double)force.x, (double)force.y - exact) / exact, 0.01, "");
		cn_world_destroy(world);
	}
}

/* count links of 0.5 m from the origin along (x, y), hinged or by rods between their ends. */
static void make_chain(cn_world *world, int32_t count, float x, float y, cn_body *bodies, cn_joint *joints)
{
	int32_t k;
	for (k = 0; k < count; ++k) {
		float middle = 0.5f * ((float)k + 0.5f);
		bodies[k] = fixture_box(world, CN_BODY_DYNAMIC, x * middle, y * middle, atan2f(y, x), 0.25f, 0.06f, 0.6f, 0.0f);
		joints[k] = hinge(world, k == 0 ? 0 : bodies[k - 1], k == 0 ? at(0.0f, 0.0f) : at(0.25f, 0.0f), bodies[k], at(-0.25f, 0.0f));
	}
}

static void chain_of_10_carries_what_hangs_below(void)
{
	cn_world *world = fixture_world(-10.0f, 0);
	cn_body links[10];
	cn_joint joints[10];
	double worst = 0.0, link_weight;
	int32_t k;
	make_chain(world, 10, 0.0f, -1.0f, links, joints);
	link_weight = (double)mass_of(world, links[0]).mass_kg * GRAVITY;
	fixture_step(world, 300);
	for (k = 0; k < 10; ++k) {
		double exact = link_weight * (double)(10 - k), force = (double)joint_force(world, joints[k]).y;
		printf("  link %d: %.5f N, exact %.5f N\n", (int)k, force, exact);
		worst = fmax(worst, fabs(force - exact) / exact);
	}
	CHECK_LE("relative error of the reactions", worst, 0.01, "");
	cn_world_destroy(world);
}

static void hanging_chain_of_20_does_not_stretch(void)
{
	cn_world *world = fixture_world(-10.0f, 0);
	cn_body links[20];
	cn_joint joints[20];
	double worst = 0.0, stretch = 0.0;
	cn_vec2 end;
	int32_t k;
	make_chain(world, 20, 0.0f, -1.0f, links, joints);
	for (k = 0; k < 3600; ++k) {
		fixture_step(world, 1);
		must(cn_body_get_world_point(world, links[19], 0.25f, 0.0f, &end), world, "cn_body_get_world_point");
		stretch = hypot((double)end.x, (double)end.y) - 10.0;
		worst = fmax(worst, stretch);
	}
	CHECK_LE("stretch of 10 m after 60 s", stretch, 1e-3, "m");
	CHECK_LE("most stretch since the chain was let go", worst, 1e-3, "m");
	CHECK_LE("sideways drift", fabs((double)end.x), 1e-3, "m");
	cn_world_destroy(world);
}

static void swinging_chain_of_20_stays_together(void)
{
	cn_world *world = fixture_world(-10.0f, 0);
	cn_body links[20];
	cn_joint joints[20];
	double worst = 0.0, late = 0.0, most = -1e9, energy0;
	totals t;
	int32_t k;
	make_chain(world, 20, 1.0f, 0.0f, links, joints);
	t = totals_of(world, links, 20);
	energy0 = t.kinetic + t.potential;
	for (k = 0; k < 3600; ++k) {
		double error;
		fixture_step(world, 1);
		error = worst_joint_error(world);
		worst = fmax(worst, error);
		late = k >= 3000 ? fmax(late, error) : late;
		t = totals_of(world, links, 20);
		most = fmax(most, t.kinetic + t.potential - energy0);
	}
	/* Depth: 20 links of 0.06 kg... falling 5 m on average. */
	printf("  energy %+.2e of its depth at most above the start; error in the last 10 s %.6f m\n", most / (20.0 * 0.06 * GRAVITY * 5.0), late);
	CHECK_LE("greatest distance between anchors", worst, 0.035, "m");
	CHECK_LE("energy gained / depth", most / (20.0 * 0.06 * GRAVITY * 5.0), 1e-3, "");
	cn_world_destroy(world);
}

/* The benchmark's joint_grid: 10,000 balls on 19,794 pins, seven of them held. As stiff as 16 substeps make it. */
static void grid_of_10000_bodies_keeps_its_anchors(void)
{
#ifdef TEST_SLOW
	const int32_t steps = 2;
#else
	const int32_t steps = 120;
#endif
	enum { SIDE = 100 };
	static cn_body balls[SIDE][SIDE];
	cn_world *world = fixture_world(-10.0f, 0);
	double worst = 0.0;
	int32_t i, k;
	must(cn_world_set_substep_count(world, 16), world, "cn_world_set_substep_count");
	for (k = 0; k < SIDE; ++k)
		for (i = 0; i < SIDE; ++i) {
			int32_t held = i == 0 && k >= SIDE / 2 - 3 && k <= SIDE / 2 + 3;
			balls[k][i] = fixture_circle(world, held ? CN_BODY_STATIC : CN_BODY_DYNAMIC, (float)k, -(float)i, 0.4f, 0.6f, 0.0f);
			if (i > 0)
				hinge(world, balls[k][i - 1], at(0.0f, -0.5f), balls[k][i], at(0.0f, 0.5f));
			if (k > 0 && !(held && k > SIDE / 2 - 3))
				hinge(world, balls[k - 1][i], at(0.5f, 0.0f), balls[k][i], at(-0.5f, 0.0f));
		}
	for (k = 0; k < steps; ++k) {
		fixture_step(world, 1);
		worst = fmax(worst, worst_joint_error(world));
	}
	CHECK_LE("greatest distance between anchors", worst, 0.01, "m");
	cn_world_destroy(world);
}

static void bridge_of_50_links_carries(void)
{
	cn_world *world = fixture_world(-10.0f, 0);
	cn_body links[50], loads[6];
	double worst = 0.0, late = 0.0;
	int32_t k, on = 0;
	for (k = 0; k < 50; ++k) {
		cn_shape_def shape;
		links[k] = fixture_body(world, CN_BODY_DYNAMIC, -12.25f + 0.5f * (float)k, 0.0f, 0.0f);
		shape = fixture_shape_def(links[k], 0.6f, 0.0f);
		shape.density_kgpm2 = 20.0f;
		fixture_box_shape(world, &shape, 0.25f, 0.125f);
		hinge(world, k == 0 ? 0 : links[k - 1], k == 0 ? at(-12.5f, 0.0f) : at(0.25f, 0.0f), links[k], at(-0.25f, 0.0f));
	}
	hinge(world, links[49], at(0.25f, 0.0f), 0, at(12.5f, 0.0f));
	for (k = 0; k < 6; ++k)
		loads[k] = fixture_box(world, CN_BODY_DYNAMIC, -5.0f + 2.0f * (float)k, 2.0f, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f);
	for (k = 0; k < 1200; ++k) {
		double error;
		fixture_step(world, 1);
		error = worst_joint_error(world);
		worst = fmax(worst, error);
		late = k >= 600 ? fmax(late, error) : late;
	}
	for (k = 0; k < 6; ++k)
		on += (double)fixture_pose(world, loads[k]).position_m.y > -6.0;
	printf("  %d of 6 loads are on the bridge\n", (int)on);
	CHECK(on == 6);
	/* 131 kg on a nearly straight bridge: links pull with tens of times their weight at first. */
	CHECK_LE("greatest distance between anchors", worst, 0.1, "m");
	CHECK_LE("greatest distance between anchors in the last 10 s", late, 0.02, "m");
	CHECK(fixture_is_valid(world));
	cn_world_destroy(world);
}

static double worst_error_over(scene_run *run, int32_t from, int32_t to)
{
	double worst = 0.0;
	for (; run->step_index < from; )
		must(scene_step(run), run->world, "scene_step");
	for (; run->step_index < to; ) {
		must(scene_step(run), run->world, "scene_step");
		worst = fmax(worst, worst_joint_error(run->world));
	}
	return worst;
}

static void ragdoll_run(float height, double bound)
{
	scene_run run;
	cn_body bones[SCENE_RAGDOLL_BODIES];
	must(scene_open(&run, scene_find("memory_empty"), NULL), NULL, "scene_open");
	fixture_floor(run.world, 0.6f, 0.0f);
	scene_ragdoll(&run, 0.0f, height, -1, bones);
	printf("  dropped from %.1f m\n", (double)height);
	CHECK_LE("greatest distance between anchors in the fall", worst_error_over(&run, 0, 240), bound, "m");
	CHECK_LE("lying on the ground", worst_error_over(&run, 240, 480), 2e-3, "m");
	CHECK(fixture_is_valid(run.world));
	scene_close(&run);
}

/* A stop travels one joint a substep through the bones, so it tears them by up to 2 v h: 53 mm from 2 m. */
static void ragdoll_on_the_ground_stays_together(void)
{
	ragdoll_run(0.0f, 0.02);
	ragdoll_run(0.2f, 0.02);
	ragdoll_run(2.0f, 0.053);
}

/* Limbs of 60 g under several ragdolls that come down at 10 m/s and more: joints give way and close again. */
static void ragdolls_in_a_heap_come_together_again(void)
{
	scene_run run;
	must(scene_open(&run, scene_find("ragdolls"), NULL), NULL, "scene_open");
	CHECK_LE("greatest distance between anchors while they fall", worst_error_over(&run, 0, 360), 0.15, "m");
	CHECK_LE("in the last 2 s", worst_error_over(&run, 360, 480), 0.01, "m");
	scene_close(&run);
}

/* ---- free assemblies ---- */

/* A chain, a ring and a spring-loaded tree of bodies in free flight. */
static int32_t make_assembly(cn_world *world, int32_t kind, cn_body *bodies, uint32_t seed)
{
	int32_t k, count = kind == 0 ? 2 : 8;
	for (k = 0; k < count; ++k) {
		float r = kind == 0 ? 0.3f : fixture_random(&seed, 0.1f, 0.3f);
		cn_shape_def shape;
		bodies[k] = fixture_body(world, CN_BODY_DYNAMIC, kind == 2 ? (float)cos(PI * k / 4.0) * 2.0f : (float)k, kind == 2 ? (float)sin(PI * k / 4.0) * 2.0f : 0.0f, 0.0f);
		shape = fixture_shape_def(bodies[k], 0.6f, 0.0f);
		shape.filter.group = -1;
		fixture_box_shape(world, &shape, r, 0.7f * r);
	}
	for (k = 0; k + 1 < count + (kind == 2); ++k) {
		cn_pose a = fixture_pose(world, bodies[k]), b = fixture_pose(world, bodies[(k + 1) % count]);
		float hx = 0.5f * (b.position_m.x - a.position_m.x), hy = 0.5f * (b.position_m.y - a.position_m.y);
		if (kind == 3) {
			cn_distance_def def = distance_def(bodies[k / 2], at(0.0f, 0.0f), bodies[k + 1], at(0.0f, 0.0f), (float)(k + 1 - k / 2));
			make_distance(world, &def);
		} else {
			hinge(world, bodies[k], at(hx, hy), bodies[(k + 1) % count], at(-hx, -hy));
		}
	}
	return count;
}

/*
 * Momentum changes by rounding only: velocities are summed up some 7,000 times in 10 s, a random walk of
 * half units in the last place that comes to a few 1e-6. Energy is compared with that after one second: at first
 * the joints are torn open by velocities that do not fit, and close again.
 */
static void assembly_run(int32_t kind, const char *name)
{
	cn_world *world = fixture_world(0.0f, 0);
	cn_body bodies[8];
	uint32_t seed = 77u + (uint32_t)kind;
	int32_t count = make_assembly(world, kind, bodies, 2463534242u), k;
	totals start, now;
	double most = 0.0, drift_1 = 0.0, drift = 0.0, spin_drift = 0.0, settled = 0.0;
	for (k = 0; k < count; ++k) {
		float vx = fixture_random(&seed, -3.0f, 3.0f), vy = fixture_random(&seed, -3.0f, 3.0f), w = fixture_random(&seed, -5.0f, 5.0f);
		fixture_set_velocity(world, bodies[k], vx, vy, w);
	}
	start = now = totals_of(world, bodies, count);
	for (k = 1; k <= 600; ++k) {
		fixture_step(world, 1);
		now = totals_of(world, bodies, count);
		drift = fmax(drift, hypot(now.px - start.px, now.py - start.py) / start.momentum_scale);
		spin_drift = fmax(spin_drift, fabs(now.spin - start.spin) / start.spin_scale);
		if (k <= 60) {
			settled = now.kinetic;
			drift_1 = drift;
			CHECK(now.kinetic <= start.kinetic);
		}
		most = fmax(most, k < 60 ? 0.0 : now.kinetic / settled);
	}
	printf("  %s: energy %.4f J, %.4f after 1 s, %.4f after 10 s\n", name, start.kinetic, settled, now.kinetic);
	CHECK_LE("most energy / that after 1 s", most, 1.002, "");
	CHECK_LE("change of momentum in 1 s / sum of momenta", drift_1, 2e-6, "");
	CHECK_LE("change of momentum in 10 s / sum of momenta", drift, 1e-5, "");
	CHECK_LE("change of angular momentum in 10 s / its parts", spin_drift, 1e-2, "");
	CHECK_LE("distance between anchors at the end", worst_joint_error(world), 5e-3, "m");
	cn_world_destroy(world);
}

static void free_assemblies_keep_momentum_and_gain_no_energy(void)
{
	assembly_run(0, "two bars");
	assembly_run(1, "chain of 8");
	assembly_run(2, "ring of 8");
	assembly_run(3, "tree of rods");
}

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
	CHECK_LE("distance between anchors", worst_joint_error(world), 1e-3, "m");
	CHECK(fixture_is_valid(world));
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
	RUN(revolute_spring_follows_the_law);
	RUN(spring_moves_a_pinned_bar_at_its_frequency);
	RUN(distance_spring_follows_the_law);
	RUN(loaded_spring_sags_as_hooke_says);
	RUN(stiff_springs_hold);
	RUN(rope_is_slack_then_holds);
	RUN(least_length_holds_too);
	RUN(distance_motor_drives_and_is_limited);
	RUN(world_static_and_kinematic_sides);
	RUN(kinematic_body_carries);
	RUN(hanging_weight_pulls_with_its_weight);
	RUN(chain_of_10_carries_what_hangs_below);
	RUN(hanging_chain_of_20_does_not_stretch);
	RUN(swinging_chain_of_20_stays_together);
	RUN(grid_of_10000_bodies_keeps_its_anchors);
	RUN(bridge_of_50_links_carries);
	RUN(ragdoll_on_the_ground_stays_together);
	RUN(ragdolls_in_a_heap_come_together_again);
	RUN(free_assemblies_keep_momentum_and_gain_no_energy);
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
