/*
 * test/world/sequential_test.c - the sequential solver: the paper's twelve steps, measured against closed forms.
 *
 * Its weaknesses are documented and kept (step/sequential.c): where a bound below is called a weakness, it is about
 * 1.2 times the value that was measured, so that the baseline of the charts cannot drift unnoticed.
 *
 * If a test here fails, look first in: step/sequential.c, then step/step.c (order), joints/joint_solve.c (joints
 * and constraints), step/finalize.c (velocity limit, rest).
 */
#include "joints.h"

static cn_world *world_of(int32_t solver, float gravity_y, int32_t sleep)
{
	cn_world_def def;
	cn_world *world = NULL;
	cn_world_def_init(&def);
	def.solver = solver;
	def.gravity_mps2.y = gravity_y;
	if (!sleep)
		def.flags &= ~(uint32_t)CN_WORLD_SLEEP;
	must(cn_world_create(&def, &world), NULL, "cn_world_create");
	return world;
}

static cn_world *sequential_world(float gravity_y, int32_t sleep)
{
	return world_of(CN_SOLVER_SEQUENTIAL, gravity_y, sleep);
}

static double height_of(const cn_world *world, cn_body body)
{
	return (double)fixture_pose(world, body).position_m.y;
}

/* ---- motion, rest ---- */

static void box_comes_to_rest_and_sleeps(void)
{
	cn_world *world = sequential_world(-10.0f, 1);
	cn_body box;
	int32_t steps = 0;
	fixture_floor(world, 0.6f, 0.0f);
	box = fixture_box(world, CN_BODY_DYNAMIC, 0.0f, 1.0f, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f);
	while (steps < 300 && fixture_is_awake(world, box)) {
		fixture_step(world, 1);
		++steps;
	}
	CHECK(!fixture_is_awake(world, box));
	CHECK_LE("time until asleep", steps / 60.0, 1.5, "s");
	CHECK_LE("height error", fabs(height_of(world, box) - 0.5), ROUNDING, "m");
	CHECK_LE("tilt", fabs((double)fixture_pose(world, box).sine), ROUNDING, "rad");
	CHECK(fixture_is_valid(world));
	cn_world_destroy(world);
}

/* v += g h, then x += h v: after n steps x = g h^2 n (n + 1) / 2, which is g h t / 2 beyond the parabola. */
static void free_fall_errs_as_the_method_does(void)
{
	cn_world *world = sequential_world(-10.0f, 0);
	cn_body ball = fixture_circle(world, CN_BODY_DYNAMIC, 0.0f, 0.0f, 0.5f, 0.6f, 0.0f);
	double error, method = GRAVITY * (double)FRAME_S * 10.0 / 2.0;
	fixture_step(world, 600);
	error = -0.5 * GRAVITY * 100.0 - height_of(world, ball);
	printf("  error after 10 s %.6f m, semi-implicit Euler g h t / 2 = %.6f m\n", error, method);
	CHECK_LE("distance from the method's own error", fabs(error - method), 1e-3, "m");
	CHECK_LE("speed error", fabs((double)fixture_velocity(world, ball).linear_mps.y + 100.0), 1e-3, "m/s");
	cn_world_destroy(world);
}

static void speeds_are_limited(void)
{
	cn_world_def def;
	cn_world *world = NULL;
	cn_body ball;
	double fastest = 0.0, turn = 0.0;
	int32_t k;
	cn_world_def_init(&def);
	def.solver = CN_SOLVER_SEQUENTIAL;
	def.linear_speed_max_mps = 8.0f;
	def.angular_speed_max_radps = 5.0f;
	must(cn_world_create(&def, &world), NULL, "cn_world_create");
	ball = fixture_circle(world, CN_BODY_DYNAMIC, 0.0f, 0.0f, 0.5f, 0.6f, 0.0f);
	fixture_set_velocity(world, ball, 3.0f, 0.0f, -20.0f);
	for (k = 0; k < 120; ++k) {
		cn_velocity v;
		fixture_step(world, 1);
		v = fixture_velocity(world, ball);
		fastest = greater(fastest, hypot((double)v.linear_mps.x, (double)v.linear_mps.y));
		turn = greater(turn, fabs((double)v.angular_radps));
	}
	CHECK_LE("fastest speed", fastest, 8.0 * (1.0 + 1e-6), "m/s");
	CHECK_GE("fastest speed", fastest, 7.99, "m/s");
	CHECK_LE("fastest turn", turn, 5.0, "rad/s");
	cn_world_destroy(world);
}

/* ---- restitution ---- */

/* Height of the first apex after a drop, over the height that the law gives. */
static double apex_ratio(float e, float height)
{
	cn_world *world = sequential_world(-10.0f, 0);
	cn_body ball;
	double apex = 0.0;
	int32_t k, bounced = 0;
	fixture_floor(world, 0.6f, 0.0f);
	ball = fixture_circle(world, CN_BODY_DYNAMIC, 0.0f, 0.5f + height, 0.5f, 0.6f, e);
	for (k = 0; k < 600; ++k) {
		double v;
		fixture_step(world, 1);
		v = (double)fixture_velocity(world, ball).linear_mps.y;
		if (bounced && v <= 0.0)
			break;
		bounced |= v > 0.0;
		if (bounced)
			apex = greater(apex, height_of(world, ball) - 0.5);
	}
	cn_world_destroy(world);
	return apex / ((double)height * (double)e * (double)e);
}

/* An impact is answered at the end of a step with the speed of its end. Up to g h of speed may be too much or too
   little, and up to v h of height: relative to the height h0, v = sqrt(2 g h0), at most 2 v h / h0 in all. */
static void drops_return_roughly_to_their_height(void)
{
	static const float es[] = { 1.0f, 0.8f, 0.5f };
	static const float heights[] = { 1.3f, 4.0f, 11.7f };
	int32_t i, k;
	for (i = 0; i < 3; ++i)
		for (k = 0; k < 3; ++k) {
			double h0 = (double)heights[k], v = sqrt(2.0 * GRAVITY * h0), ratio = apex_ratio(es[i], heights[k]);
			printf("  e %.1f from %.1f m: apex / law %.4f\n", (double)es[i], h0, ratio);
			CHECK_LE("apex error / law", fabs(ratio - 1.0), 2.0 * v * (double)FRAME_S / (h0 * (double)es[i]), "");
		}
}

static void inelastic_drop_stays_down(void)
{
	cn_world *world = sequential_world(-10.0f, 0);
	cn_body ball;
	double highest = 0.0;
	int32_t k;
	fixture_floor(world, 0.6f, 0.0f);
	ball = fixture_circle(world, CN_BODY_DYNAMIC, 0.0f, 4.5f, 0.5f, 0.6f, 0.0f);
	fixture_step(world, 60);
	for (k = 0; k < 120; ++k) {
		fixture_step(world, 1);
		highest = greater(highest, height_of(world, ball) - 0.5);
	}
	CHECK_LE("height after an inelastic drop", highest, ROUNDING, "m");
	cn_world_destroy(world);
}

static double energy_of(const cn_world *world, const cn_body *bodies, int32_t count)
{
	double energy = 0.0;
	int32_t k;
	for (k = 0; k < count; ++k) {
		cn_mass_data m;
		cn_velocity v = fixture_velocity(world, bodies[k]);
		double vx = (double)v.linear_mps.x, vy = (double)v.linear_mps.y, w = (double)v.angular_radps;
		must(cn_body_get_mass_data(world, bodies[k], &m), world, "cn_body_get_mass_data");
		energy += 0.5 * (double)m.mass_kg * (vx * vx + vy * vy) + 0.5 * (double)m.inertia_kgm2 * w * w;
	}
	return energy;
}

/* Balls or boxes flying into each other without gravity; most energy over the start's. */
static double cluster_energy(float e, int32_t boxes, uint32_t seed)
{
	cn_world *world = sequential_world(0.0f, 0);
	cn_body bodies[40];
	double start, most = 0.0;
	int32_t k;
	for (k = 0; k < 40; ++k) {
		float angle = fixture_random(&seed, 0.0f, 6.2831853f), radius = 3.0f + 0.4f * (float)k;
		float x = radius * cosf(angle), y = radius * sinf(angle), speed = fixture_random(&seed, 2.0f, 8.0f);
		bodies[k] = boxes ? fixture_box(world, CN_BODY_DYNAMIC, x, y, angle, 0.5f, 0.3f, 0.3f, e)
				  : fixture_circle(world, CN_BODY_DYNAMIC, x, y, 0.4f, 0.3f, e);
		fixture_set_velocity(world, bodies[k], -speed * x / radius, -speed * y / radius, fixture_random(&seed, -3.0f, 3.0f));
	}
	start = energy_of(world, bodies, 40);
	for (k = 0; k < 300; ++k) {
		fixture_step(world, 1);
		most = greater(most, energy_of(world, bodies, 40) / start);
	}
	cn_world_destroy(world);
	return most;
}

/* Each answer to one contact takes energy out or, at e = 1, keeps it, and the answers follow one another, each with
   the velocities the last one left. Friction after the normal impulse is bounded by what stops the sliding, so it
   cannot add either: friction changes the normal speed, but no second answer is given in the step. What is left is
   rounding. Moving overlap apart changes no velocity. */
static void cluster_energy_never_rises(void)
{
	static const float es[] = { 0.0f, 0.5f, 1.0f };
	uint32_t seed;
	int32_t k, boxes;
	for (boxes = 0; boxes < 2; ++boxes)
		for (k = 0; k < 3; ++k) {
			double most = 0.0;
			for (seed = 1; seed <= 4; ++seed)
				most = greater(most, cluster_energy(es[k], boxes, seed * 2654435761u));
			printf("  %s, e %.1f\n", boxes ? "boxes" : "balls", (double)es[k]);
			CHECK_LE("most energy / energy at the start", most, 1.0 + 1e-5, "");
		}
}

/* ---- friction ---- */

/* Distance a box slides in 5 s down a plane whose slope is ratio times the friction coefficient. */
static double incline_slide(float ratio, float mu)
{
	double angle = atan((double)(ratio * mu)), along;
	cn_world *world = sequential_world(-10.0f, 0);
	float c = (float)cos(angle), s = (float)sin(angle), x0 = -0.5f * s, y0 = 0.5f * c;
	cn_body box;
	cn_pose pose;
	fixture_box(world, CN_BODY_STATIC, s, -c, (float)angle, 50.0f, 1.0f, mu, 0.0f);
	box = fixture_box(world, CN_BODY_DYNAMIC, x0, y0, (float)angle, 0.5f, 0.5f, mu, 0.0f);
	fixture_step(world, 300);
	pose = fixture_pose(world, box);
	along = -(((double)pose.position_m.x - (double)x0) * (double)c + ((double)pose.position_m.y - (double)y0) * (double)s);
	cn_world_destroy(world);
	return along;
}

/* Friction answers after step 2 has moved the box by the g sin h of step 1: it creeps by h^2 g sin a step. And the force
   of a pair acts at the middle of its points, which does not hold against friction's torque: the box rocks
   from corner to corner and walks. Documented weaknesses. */
static void box_sticks_but_creeps_below_the_critical_slope(void)
{
	double creep = 300.0 * (double)FRAME_S * (double)FRAME_S * GRAVITY * sin(atan(0.9 * 0.5)), free = 0.5 * GRAVITY * sin(atan(0.9 * 0.5)) * 25.0;
	double slid = incline_slide(0.9f, 0.5f);
	printf("  slid %.5f m in 5 s; h^2 g sin a step: %.5f m; without friction %.1f m\n", slid, creep, free);
	CHECK_LE("creep in 5 s at 0.9 of the critical slope (weakness)", fabs(slid), 1.27, "m");
	CHECK_GE("creep of a box that does not rock is part of it", fabs(slid), 0.9 * creep, "m");
}

static void box_slides_above_the_critical_slope(void)
{
	double angle = atan(1.5 * 0.5), a = GRAVITY * (sin(angle) - 0.5 * cos(angle)), exact = 0.5 * a * 25.0;
	double slid = incline_slide(1.5f, 0.5f);
	printf("  slid %.5f m, exact %.5f m\n", slid, exact);
	CHECK_LE("relative error of the slide in 5 s at 1.5", fabs(slid - exact) / exact, 0.05, "");
}

/* Step 2 moves by the speed before friction: v h / 2 too far, 3.3% at 2 m/s. What is left rocks on its corners (see
   above) and does not fall asleep. */
static void sliding_box_stops_where_it_should(void)
{
	static const float speeds[] = { 2.0f, 5.0f, 12.0f };
	static const double bounds[] = { 0.066, 0.05, 0.05 };
	size_t k;
	for (k = 0; k < sizeof speeds / sizeof *speeds; ++k) {
		cn_world *world = sequential_world(-10.0f, 0);
		double exact = (double)speeds[k] * (double)speeds[k] / (2.0 * 0.4 * GRAVITY), slid, at_rest;
		cn_body box;
		fixture_floor(world, 0.4f, 0.0f);
		box = fixture_box(world, CN_BODY_DYNAMIC, -20.0f, 0.25f, 0.0f, 0.5f, 0.25f, 0.4f, 0.0f);
		fixture_set_velocity(world, box, speeds[k], 0.0f, 0.0f);
		fixture_step(world, 300);
		slid = (double)fixture_pose(world, box).position_m.x + 20.0;
		CHECK_LE("relative error of the stopping distance", fabs(slid - exact) / exact, bounds[k], "");
		CHECK_LE("speed at the end (weakness)", fabs((double)fixture_velocity(world, box).linear_mps.x), 0.05, "m/s");
		fixture_step(world, 600);
		at_rest = (double)fixture_pose(world, box).position_m.x + 20.0;
		CHECK_LE("way in the 10 s after (weakness)", fabs(at_rest - slid), 0.005, "m");
		cn_world_destroy(world);
	}
}

/* ---- overlap ---- */

static void overlap_is_shared_by_two_dynamic_bodies(void)
{
	cn_world *world = sequential_world(0.0f, 0);
	cn_body a = fixture_box(world, CN_BODY_DYNAMIC, 0.0f, 0.0f, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f);
	cn_body b = fixture_box(world, CN_BODY_DYNAMIC, 0.8f, 0.0f, 0.0f, 0.5f, 2.0f, 0.6f, 0.0f);
	fixture_step(world, 1);
	CHECK_LE("left body: distance from its half", fabs((double)fixture_pose(world, a).position_m.x + 0.1), 1e-5, "m");
	CHECK_LE("right body: distance from its half", fabs((double)fixture_pose(world, b).position_m.x - 0.9), 1e-5, "m");
	CHECK_LE("speed gained", fabs((double)fixture_velocity(world, a).linear_mps.x), 0.0, "m/s");
	cn_world_destroy(world);
}

static void overlap_with_what_cannot_move_is_moved_whole(void)
{
	static const int32_t types[] = { CN_BODY_STATIC, CN_BODY_KINEMATIC };
	int32_t k, swap;
	for (k = 0; k < 2; ++k)
		for (swap = 0; swap < 2; ++swap) {
			cn_world *world = sequential_world(0.0f, 0);
			cn_body a = fixture_box(world, swap ? CN_BODY_DYNAMIC : types[k], 0.0f, 0.0f, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f);
			cn_body b = fixture_box(world, swap ? types[k] : CN_BODY_DYNAMIC, 0.8f, 0.0f, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f);
			double left, right;
			fixture_step(world, 1);
			left = (double)fixture_pose(world, a).position_m.x;
			right = (double)fixture_pose(world, b).position_m.x;
			CHECK_LE("what cannot move", swap ? fabs(right - (double)0.8f) : fabs(left), 0.0, "m");
			CHECK_LE("the dynamic one: distance from the whole", swap ? fabs(left + 0.2) : fabs(right - 1.0), 1e-5, "m");
			cn_world_destroy(world);
		}
}

/* ---- stacks ---- */

/* Each contact is answered once and alone, so a load does not pass through a stack in one step. Documented weakness. */
static void stacks_sink_no_more_than_measured(void)
{
	static const double sink_m[] = { 0.01, 0.027, 0.067, 0.134 };
	static const double drift_m[] = { 0.0067, 0.04, 0.137, 0.35 };
	int32_t count, k, step;
	for (count = 2; count <= 5; ++count) {
		cn_world *world = sequential_world(-10.0f, 0);
		cn_body boxes[5];
		double sink = 0.0, drift = 0.0;
		fixture_floor(world, 0.6f, 0.0f);
		for (k = 0; k < count; ++k)
			boxes[k] = fixture_box(world, CN_BODY_DYNAMIC, 0.0f, 0.5f + (float)k, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f);
		for (step = 0; step < 600; ++step) {
			fixture_step(world, 1);
			sink = greater(sink, (double)fixture_penetration(world, boxes, count));
		}
		for (k = 0; k < count; ++k) {
			cn_pose pose = fixture_pose(world, boxes[k]);
			drift = greater(drift, hypot((double)pose.position_m.x, (double)pose.position_m.y - 0.5 - k));
		}
		printf("  %d boxes, 10 s\n", (int)count);
		CHECK_LE("deepest overlap (weakness)", sink, sink_m[count - 2], "m");
		CHECK_LE("farthest from its place (weakness)", drift, drift_m[count - 2], "m");
		cn_world_destroy(world);
	}
}

/* ---- joints ---- */

static cn_joint rod_between(cn_world *world, cn_body a, cn_body b, float anchor_x, float anchor_y, float length)
{
	cn_distance_def def;
	cn_joint joint = 0;
	cn_distance_def_init(&def);
	def.base.body_a = a;
	def.base.body_b = b;
	def.base.anchor_a_m.x = anchor_x;
	def.base.anchor_a_m.y = anchor_y;
	def.length_m = length;
	must(cn_joint_create_distance(world, &def, &joint), world, "cn_joint_create_distance");
	return joint;
}

static double joint_error(const cn_world *world, cn_joint joint)
{
	float metres = 0.0f, radians = 0.0f;
	must(cn_joint_get_error(world, joint, &metres, &radians), world, "cn_joint_get_error");
	return (double)metres;
}

/* A ball on a rod to its centre is a point pendulum: T = 2 pi sqrt(l / g) (1 + a^2 / 16 + ...). */
static void pendulum_keeps_its_period(void)
{
	static const double amplitudes[] = { 0.1, 0.5 };
	int32_t i;
	for (i = 0; i < 2; ++i) {
		double a = amplitudes[i], exact = 2.0 * PI * sqrt(2.0 / GRAVITY) * (1.0 + a * a / 16.0 + 11.0 * a * a * a * a / 3072.0);
		cn_world *world = sequential_world(-10.0f, 0);
		cn_body ball = fixture_circle(world, CN_BODY_DYNAMIC, (float)(2.0 * sin(a)), (float)(-2.0 * cos(a)), 0.1f, 0.6f, 0.0f);
		cn_joint rod = rod_between(world, 0, ball, 0.0f, 0.0f, 2.0f);
		double last_x = 0.0, first = -1.0, last = 0.0, worst = 0.0;
		int32_t k, crossings = 0;
		for (k = 1; k <= 1200; ++k) {
			double x;
			fixture_step(world, 1);
			x = (double)fixture_pose(world, ball).position_m.x;
			worst = greater(worst, joint_error(world, rod));
			if (k > 1 && last_x < 0.0 && x >= 0.0) {
				last = (k - 1 - last_x / (x - last_x)) * (double)FRAME_S;
				first = first < 0.0 ? last : first;
				++crossings;
			}
			last_x = x;
		}
		REQUIRE(crossings >= 3);
		printf("  amplitude %.1f rad: period %.5f s, exact %.5f s\n", a, (last - first) / (crossings - 1), exact);
		CHECK_LE("relative error of the period", fabs((last - first) / (crossings - 1) / exact - 1.0), 0.01, "");
		CHECK_LE("most change of the rod's length (weakness)", worst, 0.015, "m");
		cn_world_destroy(world);
	}
}

static void chain_of_five_hangs_together(void)
{
	cn_world *world = sequential_world(-10.0f, 0);
	cn_body links[5];
	cn_joint joints[5];
	double worst = 0.0, last = 0.0, energy = 0.0;
	int32_t k, step;
	for (k = 0; k < 5; ++k) {
		links[k] = fixture_box(world, CN_BODY_DYNAMIC, 0.5f + (float)k, 0.0f, 0.0f, 0.5f, 0.1f, 0.6f, 0.0f);
		joints[k] = hinge(world, k > 0 ? links[k - 1] : 0, at(k > 0 ? 0.5f : 0.0f, 0.0f), links[k], at(-0.5f, 0.0f));
	}
	for (step = 0; step < 1200; ++step) {
		double total = energy_of(world, links, 5);
		for (k = 0; k < 5; ++k)
			total += GRAVITY * 0.2 * height_of(world, links[k]);
		energy = greater(energy, total);
		fixture_step(world, 1);
		last = 0.0;
		for (k = 0; k < 5; ++k)
			last = greater(last, joint_error(world, joints[k]));
		worst = greater(worst, last);
	}
	CHECK_LE("most gap in a swinging chain (weakness)", worst, 0.2, "m");
	CHECK_LE("gap after 20 s (weakness)", last, 0.052, "m");
	CHECK_LE("energy above the start / m g l of the chain (weakness)", energy / (GRAVITY * 2.5), 1e-3, "");
	CHECK(fixture_is_valid(world));
	cn_world_destroy(world);
}

/* ---- constraints on one body ---- */

static void angle_constraint_holds(void)
{
	cn_world *world = sequential_world(-10.0f, 0);
	cn_angle_constraint_def def;
	cn_constraint c = 0;
	cn_body box;
	double worst = 0.0;
	int32_t k;
	fixture_floor(world, 0.6f, 0.0f);
	box = fixture_box(world, CN_BODY_DYNAMIC, 0.0f, 2.0f, 0.0f, 1.0f, 0.2f, 0.6f, 0.0f);
	cn_angle_constraint_def_init(&def);
	def.body = box;
	def.lower_rad = -0.3f;
	def.upper_rad = 0.3f;
	must(cn_constraint_create_angle(world, &def, &c), world, "cn_constraint_create_angle");
	fixture_set_velocity(world, box, 1.0f, 0.0f, 4.0f);
	for (k = 0; k < 300; ++k) {
		float metres, radians;
		fixture_step(world, 1);
		must(cn_constraint_get_error(world, c, &metres, &radians), world, "cn_constraint_get_error");
		worst = greater(worst, (double)radians);
	}
	/* Step 2 turns the body by up to h w before step 3 sees it: 4 rad/s / 60 = 0.067 rad. */
	CHECK_LE("most angle beyond the limit", worst, 4.0 * (double)FRAME_S, "rad");
	CHECK(fixture_is_valid(world));
	cn_world_destroy(world);
}

static void line_constraint_holds(void)
{
	cn_world *world = sequential_world(-10.0f, 0);
	cn_line_constraint_def def;
	cn_constraint c = 0;
	cn_body ball = fixture_circle(world, CN_BODY_DYNAMIC, 0.0f, 0.0f, 0.5f, 0.6f, 0.0f);
	double across = 0.0, x, exact = 0.5 * GRAVITY * 0.5;
	int32_t k;
	cn_line_constraint_def_init(&def);
	def.body = ball;
	def.axis.x = 1.0f;
	def.axis.y = -1.0f;
	def.flags = CN_CONSTRAINT_LIMIT;
	def.lower_m = -1.0f;
	def.upper_m = 8.0f;
	must(cn_constraint_create_line(world, &def, &c), world, "cn_constraint_create_line");
	for (k = 1; k <= 300; ++k) {
		cn_pose pose;
		fixture_step(world, 1);
		pose = fixture_pose(world, ball);
		across = greater(across, fabs((double)pose.position_m.x + (double)pose.position_m.y) * sqrt(0.5));
		if (k == 60) { /* g / sqrt 2 along the line, of which x is 1 / sqrt 2 again */
			x = (double)pose.position_m.x;
			CHECK_LE("relative error of the slide in 1 s", fabs(x / exact - 1.0), 0.02, "");
		}
	}
	{
		float position = 0.0f;
		must(cn_constraint_get_position(world, c, &position), world, "cn_constraint_get_position");
		CHECK_LE("distance from the limit it hangs at", fabs((double)position - 8.0), 0.01, "m");
	}
	CHECK_LE("farthest from the line", across, 0.01, "m");
	cn_world_destroy(world);
}

/* ---- events ---- */

typedef struct bounce {
	int32_t count[CN_EVENT_KINDS];
	int32_t wrong; /* events out of their order: created (enter stay* leave)* destroyed */
	int32_t near_, touching;
} bounce;

static void bounce_read(cn_world *world, bounce *b)
{
	static const int32_t order[] = { CN_EVENT_CREATED, CN_EVENT_ENTER, CN_EVENT_STAY, CN_EVENT_HIT, CN_EVENT_LEAVE, CN_EVENT_DESTROYED };
	int32_t k;
	for (k = 0; k < CN_EVENT_KINDS; ++k) {
		const cn_contact_event *events;
		int32_t count = 0;
		must(cn_world_contact_events(world, order[k], &events, &count), world, "cn_world_contact_events");
		if (count == 0)
			continue;
		b->count[order[k]] += count;
		b->wrong += count != 1;
		switch (order[k]) {
		case CN_EVENT_CREATED: b->wrong += b->near_; b->near_ = 1; break;
		case CN_EVENT_ENTER: b->wrong += !b->near_ || b->touching; b->touching = 1; break;
		case CN_EVENT_STAY:
		case CN_EVENT_HIT: b->wrong += !b->touching; break;
		case CN_EVENT_LEAVE: b->wrong += !b->touching; b->touching = 0; break;
		default: b->wrong += b->touching || !b->near_; b->near_ = 0; break;
		}
	}
}

static bounce bounce_run(int32_t solver)
{
	cn_world *world = world_of(solver, -10.0f, 1);
	cn_body ball, ground = fixture_body(world, CN_BODY_STATIC, 0.0f, -1.0f, 0.0f);
	cn_shape_def def = fixture_shape_def(ground, 0.6f, 0.0f);
	bounce b;
	int32_t k;
	memset(&b, 0, sizeof b);
	def.event_mask = (1u << CN_EVENT_KINDS) - 1u;
	fixture_box_shape(world, &def, 10.0f, 1.0f);
	ball = fixture_circle(world, CN_BODY_DYNAMIC, 0.0f, 4.5f, 0.5f, 0.6f, 0.7f);
	for (k = 0; k < 900; ++k) {
		fixture_step(world, 1);
		bounce_read(world, &b);
	}
	CHECK(!fixture_is_awake(world, ball));
	must(cn_body_destroy(world, ball), world, "cn_body_destroy");
	fixture_step(world, 1);
	bounce_read(world, &b);
	b.wrong += b.near_ || b.touching;
	cn_world_destroy(world);
	return b;
}

static void events_are_those_of_the_soft_solver(void)
{
	bounce soft = bounce_run(CN_SOLVER_SOFT), sequential = bounce_run(CN_SOLVER_SEQUENTIAL);
	int32_t k;
	for (k = 0; k < CN_EVENT_KINDS; ++k) {
		printf("  kind %d: soft %d, sequential %d\n", (int)k, (int)soft.count[k], (int)sequential.count[k]);
		CHECK(sequential.count[k] > 0 && soft.count[k] > 0);
	}
	CHECK_LE("events out of order, soft", soft.wrong, 0, "");
	CHECK_LE("events out of order, sequential", sequential.wrong, 0, "");
	CHECK(sequential.count[CN_EVENT_ENTER] == sequential.count[CN_EVENT_LEAVE]);
	CHECK(sequential.count[CN_EVENT_CREATED] == sequential.count[CN_EVENT_DESTROYED]);
	CHECK_LE("bounces more or less than soft", abs((int)(sequential.count[CN_EVENT_ENTER] - soft.count[CN_EVENT_ENTER])), 2, "");
}

/* A step of 0 s updates contacts and events; nothing moves. */
static void a_step_of_no_time_finds_contacts(void)
{
	cn_world *world = sequential_world(-10.0f, 1);
	const cn_contact_event *events;
	cn_body box;
	cn_pose before, after;
	int32_t count = 0;
	fixture_floor(world, 0.6f, 0.0f);
	box = fixture_box(world, CN_BODY_DYNAMIC, 0.0f, 0.499f, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f);
	fixture_set_velocity(world, box, 1.0f, -2.0f, 3.0f);
	before = fixture_pose(world, box);
	must(cn_world_step(world, 0.0f), world, "cn_world_step");
	after = fixture_pose(world, box);
	must(cn_world_contact_events(world, CN_EVENT_ENTER, &events, &count), world, "cn_world_contact_events");
	CHECK(count == 1 && events[0].manifold.point_count == 2 && events[0].normal_impulse_Ns == 0.0f);
	CHECK(memcmp(&before, &after, sizeof before) == 0);
	CHECK(fixture_velocity(world, box).linear_mps.x == 1.0f && fixture_velocity(world, box).linear_mps.y == -2.0f);
	CHECK(fixture_is_valid(world));
	cn_world_destroy(world);
}

/* ---- determinism ---- */

static uint64_t pile_hash(uint32_t seed, int32_t *out_valid)
{
	cn_world *world = sequential_world(-10.0f, 1);
	cn_body last = 0;
	uint64_t hash = 0;
	int32_t k;
	fixture_floor(world, 0.6f, 0.2f);
	for (k = 0; k < 60; ++k) {
		float x = fixture_random(&seed, -4.0f, 4.0f), y = 1.0f + 0.5f * (float)k;
		cn_body body = k % 2 ? fixture_circle(world, CN_BODY_DYNAMIC, x, y, 0.4f, 0.5f, 0.3f)
				     : fixture_box(world, CN_BODY_DYNAMIC, x, y, x, 0.5f, 0.3f, 0.5f, 0.3f);
		if (k % 10 == 9)
			rod_between(world, last, body, 0.0f, 0.0f, 1.5f);
		last = body;
	}
	*out_valid = 1;
	for (k = 0; k < 300; ++k) {
		fixture_step(world, 1);
		hash = hash * 31u + fixture_hash(world);
		*out_valid &= k % 50 != 0 || fixture_is_valid(world);
	}
	cn_world_destroy(world);
	return hash;
}

static void equal_histories_are_equal(void)
{
	int32_t valid_a, valid_b, valid_c;
	uint64_t a = pile_hash(77u, &valid_a), b = pile_hash(77u, &valid_b), c = pile_hash(78u, &valid_c);
	printf("  hash of all steps %08x%08x\n", (unsigned)(a >> 32), (unsigned)(a & 0xFFFFFFFFu));
	CHECK(a == b);
	CHECK(a != c);
	CHECK(valid_a && valid_b && valid_c);
}

/* A step moves nothing farther than the speed limit allows: under such gravity the sum of a few ways overflowed. */
static void falls_of_any_speed_stay_finite(void)
{
	cn_world *world = sequential_world(0.0f, 0);
	cn_body body = fixture_circle(world, CN_BODY_DYNAMIC, 0.0f, 0.0f, 0.5f, 0.6f, 0.0f);
	int32_t k;
	must(cn_world_set_gravity(world, 3.4e38f, 0.0f), world, "cn_world_set_gravity");
	for (k = 0; k < 20; ++k)
		must(cn_world_step(world, 1.0f), world, "cn_world_step");
	CHECK(fixture_is_valid(world));
	CHECK_LE("way in 20 s", (double)fixture_pose(world, body).position_m.x, 20.0 * 400.0 * 1.001, "m");
	cn_world_destroy(world);
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(box_comes_to_rest_and_sleeps);
	RUN(free_fall_errs_as_the_method_does);
	RUN(speeds_are_limited);
	RUN(drops_return_roughly_to_their_height);
	RUN(inelastic_drop_stays_down);
	RUN(cluster_energy_never_rises);
	RUN(box_sticks_but_creeps_below_the_critical_slope);
	RUN(box_slides_above_the_critical_slope);
	RUN(sliding_box_stops_where_it_should);
	RUN(overlap_is_shared_by_two_dynamic_bodies);
	RUN(overlap_with_what_cannot_move_is_moved_whole);
	RUN(stacks_sink_no_more_than_measured);
	RUN(pendulum_keeps_its_period);
	RUN(chain_of_five_hangs_together);
	RUN(angle_constraint_holds);
	RUN(line_constraint_holds);
	RUN(events_are_those_of_the_soft_solver);
	RUN(a_step_of_no_time_finds_contacts);
	RUN(falls_of_any_speed_stay_finite);
	RUN(equal_histories_are_equal);
	return test_end();
}
