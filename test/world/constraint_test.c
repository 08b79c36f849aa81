/*
 * test/world/constraint_test.c - constraints on one body: angle and line, alone and against contacts.
 *
 * If a test here fails, look first in: joints/joint_type.c (rows), joints/joint_turns.c (whole
 * turns), joints/joint_solve.c (solving, breaking), world/joint_create.c (definitions, handles).
 */
#include "joints.h"

static cn_angle_constraint_def angle_def(cn_body body, float lower, float upper)
{
	cn_angle_constraint_def def;
	cn_angle_constraint_def_init(&def);
	def.body = body;
	def.lower_rad = lower;
	def.upper_rad = upper;
	return def;
}

static cn_line_constraint_def line_def(cn_body body, cn_vec2 origin, cn_vec2 axis)
{
	cn_line_constraint_def def;
	cn_line_constraint_def_init(&def);
	def.body = body;
	def.origin_m = origin;
	def.axis = axis;
	return def;
}

static cn_constraint make_angle(cn_world *world, const cn_angle_constraint_def *def)
{
	cn_constraint constraint = 0;
	must(cn_constraint_create_angle(world, def, &constraint), world, "cn_constraint_create_angle");
	return constraint;
}

static cn_constraint make_line(cn_world *world, const cn_line_constraint_def *def)
{
	cn_constraint constraint = 0;
	must(cn_constraint_create_line(world, def, &constraint), world, "cn_constraint_create_line");
	return constraint;
}

static cn_constraint hold_angle(cn_world *world, cn_body body, float lower, float upper)
{
	cn_angle_constraint_def def = angle_def(body, lower, upper);
	return make_angle(world, &def);
}

static double position_of(const cn_world *world, cn_constraint constraint)
{
	float x = 0.0f;
	must(cn_constraint_get_position(world, constraint, &x), world, "cn_constraint_get_position");
	return (double)x;
}

static double error_of(const cn_world *world, cn_constraint constraint)
{
	float m = 0.0f, rad = 0.0f;
	must(cn_constraint_get_error(world, constraint, &m, &rad), world, "cn_constraint_get_error");
	return (double)m + (double)rad;
}

static double torque_of(const cn_world *world, cn_constraint constraint)
{
	cn_vec2 force;
	float torque = 0.0f;
	must(cn_constraint_get_reaction(world, constraint, &force, &torque), world, "cn_constraint_get_reaction");
	return (double)torque;
}

static cn_vec2 force_of(const cn_world *world, cn_constraint constraint)
{
	cn_vec2 force;
	float torque = 0.0f;
	must(cn_constraint_get_reaction(world, constraint, &force, &torque), world, "cn_constraint_get_reaction");
	return force;
}

static double x_of(const cn_world *world, cn_body body) { return (double)fixture_pose(world, body).position_m.x; }
static double y_of(const cn_world *world, cn_body body) { return (double)fixture_pose(world, body).position_m.y; }

/* ---- angle ---- */

static void angle_limits_cancel_spin(void)
{
	cn_world *world = fixture_world(0.0f, 0);
	cn_body box = unit_box(world, 0.0f, 0.0f, 0.0f);
	cn_constraint limit = hold_angle(world, box, -0.4f, 0.5f);
	double most = 0.0, least = 0.0;
	int32_t k, reached = 0;
	fixture_set_velocity(world, box, 1.0f, 2.0f, 3.0f);
	for (k = 0; k < 60; ++k) {
		fixture_step(world, 1);
		most = greater(most, position_of(world, limit));
		if (!reached && position_of(world, limit) > 0.499) {
			fixture_step(world, 2);
			reached = 1;
			CHECK_LE("spin at the limit", fabs((double)fixture_velocity(world, box).angular_radps), ROUNDING, "rad/s");
		}
	}
	CHECK(reached);
	CHECK_LE("beyond the upper limit", most - 0.5, ROUNDING, "rad");
	CHECK_LE("speed along the way", fabs((double)fixture_velocity(world, box).linear_mps.y - 2.0), 0.0, "m/s");
	fixture_set_velocity(world, box, 0.0f, 0.0f, -20.0f);
	for (k = 0; k < 60; ++k) {
		fixture_step(world, 1);
		least = greater(least, -position_of(world, limit));
	}
	CHECK_LE("beyond the lower limit at 20 rad/s", least - 0.4, ROUNDING, "rad");
	CHECK_LE("rest there", fabs((double)fixture_velocity(world, box).angular_radps), ROUNDING, "rad/s");
	CHECK_LE("error read back", error_of(world, limit), ROUNDING, "rad");
	cn_world_destroy(world);
}

static void angle_counts_whole_turns(void)
{
	cn_world *world = fixture_world(0.0f, 0);
	cn_body box = unit_box(world, 0.0f, 0.0f, 2.0f);
	cn_constraint limit = hold_angle(world, box, -1.0f, 100.0f);
	double most = 0.0;
	int32_t k;
	fixture_set_velocity(world, box, 0.0f, 0.0f, 20.0f);
	fixture_step(world, 60);
	CHECK_LE("angle after 1 s at 20 rad/s from 2", fabs(position_of(world, limit) - 22.0), 2.0 * ROUNDING, "rad");
	for (k = 0; k < 600; ++k) {
		fixture_step(world, 1);
		most = greater(most, position_of(world, limit));
	}
	CHECK_LE("beyond 100 rad", most - 100.0, 100.0 * ROUNDING, "rad");
	CHECK_LE("rest there", fabs((double)fixture_velocity(world, box).angular_radps), ROUNDING, "rad/s");
	cn_world_destroy(world);
}

static void angle_reaction_is_the_torque(void)
{
	cn_world *world = fixture_world(-(float)GRAVITY, 0);
	cn_body box = unit_box(world, 0.0f, 0.0f, 0.0f);
	cn_constraint lock = hold_angle(world, box, 0.25f, 0.25f); /* from 0: turned there */
	int32_t k;
	fixture_step(world, 60);
	CHECK_LE("angle against 0.25", fabs(position_of(world, lock) - 0.25), ROUNDING, "rad");
	for (k = 0; k < 120; ++k) {
		must(cn_body_apply_torque(world, box, 3.0f), world, "cn_body_apply_torque");
		fixture_step(world, 1);
	}
	CHECK_LE("reaction against -3 Nm", fabs(torque_of(world, lock) + 3.0), ROUNDING, "Nm");
	CHECK_LE("turned under 3 Nm", fabs(position_of(world, lock) - 0.25), ROUNDING, "rad");
	CHECK_LE("fall against g t", fabs((double)fixture_velocity(world, box).linear_mps.y + GRAVITY * 3.0), 10.0 * SOLVED, "m/s");
	cn_world_destroy(world);
}

static void soft_angle_gives_way_by_its_stiffness(void)
{
	cn_world *world = fixture_world(0.0f, 0);
	cn_body box = unit_box(world, 0.0f, 0.0f, 0.0f), free_box = unit_box(world, 5.0f, 0.0f, 0.0f);
	cn_angle_constraint_def def = angle_def(box, 0.0f, 0.0f);
	cn_constraint lock, limit;
	double w2 = pow(2.0 * PI * 2.0, 2.0);
	int32_t k;
	def.hertz = 2.0f;
	def.damping_ratio = 0.7f;
	lock = make_angle(world, &def);
	def = angle_def(free_box, -1.0f, 0.0f);
	def.hertz = 2.0f;
	def.damping_ratio = 0.7f;
	limit = make_angle(world, &def);
	for (k = 0; k < 600; ++k) {
		must(cn_body_apply_torque(world, box, 1.0f), world, "cn_body_apply_torque");
		must(cn_body_apply_torque(world, free_box, 1.0f), world, "cn_body_apply_torque");
		fixture_step(world, 1);
	}
	CHECK_LE("lock: angle against T / (I w^2)", fabs(position_of(world, lock) - 1.0 / (UNIT_INERTIA * w2)), 1e-5, "rad");
	CHECK_LE("limit: angle against T / (I w^2)", fabs(position_of(world, limit) - 1.0 / (UNIT_INERTIA * w2)), 1e-5, "rad");
	CHECK_LE("limit: reaction against -1 Nm", fabs(torque_of(world, limit) + 1.0), ROUNDING, "Nm");
	cn_world_destroy(world);
}

/* ---- angle and contacts ---- */

/* Slope of 30 degrees (tan = 0.577) and friction 0.6: held by friction at the contact and the lock's torque. */
static double creep(int32_t how, float *out_torque, double *out_start)
{
	const float tilt = 30.0f * (float)PI / 180.0f;
	cn_world *world = fixture_world(-(float)GRAVITY, 0);
	cn_body ball;
	cn_constraint lock = 0;
	double x0, y0, way;
	fixture_box(world, CN_BODY_STATIC, 0.0f, 0.0f, tilt, 50.0f, 1.0f, 0.6f, 0.0f);
	ball = fixture_circle(world, CN_BODY_DYNAMIC, -sinf(tilt) * 1.5f, cosf(tilt) * 1.5f, 0.5f, 0.6f, 0.0f);
	if (how == 0)
		lock = hold_angle(world, ball, 0.0f, 0.0f);
	else if (how == 1)
		lock = hold_angle(world, ball, -1.0f, 0.0f); /* it wants to roll to the left, towards larger angles */
	else
		must(cn_body_set_flags(world, ball, CN_BODY_LOCK_ROTATION | CN_BODY_ENABLED), world, "cn_body_set_flags");
	x0 = x_of(world, ball);
	y0 = y_of(world, ball);
	fixture_step(world, 60);
	*out_start = hypot(x_of(world, ball) - x0, y_of(world, ball) - y0);
	x0 = x_of(world, ball);
	y0 = y_of(world, ball);
	fixture_step(world, 3600);
	/* Along the slope: across it the contact settles for some seconds, while its load becomes known. */
	way = fabs((x_of(world, ball) - x0) * (double)cosf(tilt) + (y_of(world, ball) - y0) * (double)sinf(tilt));
	*out_torque = lock != 0 ? (float)torque_of(world, lock) : 0.0f;
	cn_world_destroy(world);
	return way;
}

static void a_locked_circle_does_not_creep_on_a_rough_slope(void)
{
	static const char *const names[] = { "locked: way in 60 s", "at its upper limit: way in 60 s", "by CN_BODY_LOCK_ROTATION: way in 60 s" };
	int32_t how;
	for (how = 0; how < 3; ++how) {
		float torque;
		double start, way = creep(how, &torque, &start);
		CHECK_LE("way in the first second", start, 5e-3, "m");
		CHECK_LE(names[how], way, 1e-5, "m");
		/* Friction m g sin(30) at the lever 0.5 m. */
		if (how < 2)
			CHECK_LE("reaction against m g sin(30) r", fabs((double)torque + PI * 0.25 * GRAVITY * sin(30.0 * PI / 180.0) * 0.5), 1e-3, "Nm");
	}
}

/* The same on a moving slope: nothing rests, friction carries it along. */
static void a_locked_circle_rides_along(void)
{
	cn_world *world = fixture_world(-(float)GRAVITY, 0);
	cn_body belt = fixture_box(world, CN_BODY_KINEMATIC, 0.0f, -1.0f, 0.0f, 100.0f, 1.0f, 0.8f, 0.0f);
	cn_body ball = fixture_circle(world, CN_BODY_DYNAMIC, 0.0f, 0.5f, 0.5f, 0.8f, 0.0f);
	cn_constraint lock = hold_angle(world, ball, 0.0f, 0.0f);
	double offset;
	fixture_set_velocity(world, belt, 2.0f, 0.0f, 0.0f);
	fixture_step(world, 120);
	offset = x_of(world, ball) - x_of(world, belt);
	fixture_step(world, 1200);
	CHECK_LE("slip in 20 s", fabs(x_of(world, ball) - x_of(world, belt) - offset), SOLVED, "m");
	CHECK_LE("turned", error_of(world, lock), ROUNDING, "rad");
	cn_world_destroy(world);
}

static void a_locked_tower_stands(void)
{
	cn_world *world = fixture_world(-(float)GRAVITY, 1);
	cn_body balls[8];
	int32_t k;
	fixture_floor(world, 0.6f, 0.0f);
	for (k = 0; k < 8; ++k) {
		balls[k] = fixture_circle(world, CN_BODY_DYNAMIC, 0.02f * (float)(k % 2), 0.5f + (float)k, 0.5f, 0.6f, 0.0f);
		hold_angle(world, balls[k], 0.0f, 0.0f);
	}
	fixture_step(world, 600);
	CHECK_LE("top of eight locked circles, from its place", fabs(x_of(world, balls[7]) - 0.02) + fabs(y_of(world, balls[7]) - 7.5), 0.05, "m");
	cn_world_destroy(world);
}

/* ---- line ---- */

static void line_keeps_a_bead_on_a_wire(void)
{
	const double tilt = -30.0 * PI / 180.0;
	cn_world *world = fixture_world(-(float)GRAVITY, 0);
	cn_body bead = fixture_circle(world, CN_BODY_DYNAMIC, 0.0f, 0.0f, 0.25f, 0.5f, 0.0f);
	cn_line_constraint_def def = line_def(bead, at(0.0f, 0.0f), at(3.0f * (float)cos(tilt), 3.0f * (float)sin(tilt)));
	cn_constraint line;
	double off = 0.0, worst = 0.0;
	cn_vec2 f;
	int32_t k;
	line = make_line(world, &def);
	for (k = 1; k <= 120; ++k) {
		double t = (double)k / 60.0, s = 0.5 * GRAVITY * 0.5 * t * t;
		fixture_step(world, 1);
		off = greater(off, error_of(world, line));
		if (k >= 30)
			worst = greater(worst, fabs(position_of(world, line) / s - 1.0));
	}
	CHECK_LE("off the line", off, ROUNDING, "m");
	CHECK_LE("way against g sin(30) t^2 / 2, 0.5 to 2 s", worst, 2.0 * ROUNDING, "");
	f = force_of(world, line);
	CHECK_LE("reaction against m g cos(30)", fabs(hypot((double)f.x, (double)f.y) - PI * 0.0625 * GRAVITY * cos(tilt)), 1e-4, "N");
	cn_world_destroy(world);
}

/* Hung by a point off its centre the body also swings. */
static void line_holds_a_point_of_the_body(void)
{
	cn_world *world = fixture_world(-(float)GRAVITY, 0);
	cn_body box = unit_box(world, 0.0f, -2.0f, 0.0f);
	cn_line_constraint_def def = line_def(box, at(0.0f, 0.0f), at(1.0f, 0.0f));
	cn_constraint line;
	double off = 0.0, momentum = 0.0;
	int32_t k;
	def.anchor_m = at(0.0f, 2.0f);
	line = make_line(world, &def);
	fixture_set_velocity(world, box, 3.0f, 0.0f, 3.0f);
	for (k = 0; k < 3600; ++k) {
		fixture_step(world, 1);
		off = greater(off, error_of(world, line));
		momentum = greater(momentum, fabs((double)fixture_velocity(world, box).linear_mps.x - 3.0));
	}
	CHECK_LE("off the line, 60 s", off, ROUNDING, "m");
	CHECK_LE("speed along it (nothing pushes that way)", momentum, ROUNDING, "m/s");
	cn_world_destroy(world);
}

static void line_has_tolerance_and_limits(void)
{
	cn_world *world = fixture_world(0.0f, 0);
	cn_body box = unit_box(world, 0.0f, 0.0f, 0.0f);
	cn_line_constraint_def def = line_def(box, at(0.0f, 0.0f), at(0.0f, 2.0f)); /* up */
	cn_constraint line;
	double aside = 0.0, up = 0.0, down = 0.0;
	int32_t k;
	def.flags = CN_CONSTRAINT_LIMIT;
	def.tolerance_m = 0.3f;
	def.lower_m = -1.0f;
	def.upper_m = 2.0f;
	line = make_line(world, &def);
	fixture_set_velocity(world, box, 0.5f, 0.0f, 0.0f);
	fixture_step(world, 30);
	CHECK_LE("free within the tolerance", fabs(x_of(world, box) - 0.25), 1e-5, "m");
	fixture_step(world, 60);
	CHECK_LE("stopped at it", fabs(x_of(world, box) - 0.3), ROUNDING, "m");
	for (k = 0; k < 600; ++k) {
		float fx = k / 60 % 2 ? 8.0f : -8.0f, fy = k / 90 % 2 ? -6.0f : 6.0f;
		must(cn_body_apply_force(world, box, fx, fy), world, "cn_body_apply_force");
		fixture_step(world, 1);
		aside = greater(aside, fabs(x_of(world, box)));
		up = greater(up, position_of(world, line));
		down = greater(down, -position_of(world, line));
	}
	CHECK_LE("beyond the tolerance", aside - 0.3, 1e-3, "m");
	CHECK_LE("beyond the upper limit", up - 2.0, 4.0 * SOLVED, "m");
	CHECK_LE("beyond the lower limit", down - 1.0, 4.0 * SOLVED, "m");
	CHECK_GE("way used", up + down, 2.9, "m");
	def.flags = 0; /* without limits it flies on */
	must(cn_constraint_set_line(world, line, &def), world, "cn_constraint_set_line");
	fixture_set_velocity(world, box, 0.0f, 5.0f, 0.0f);
	fixture_step(world, 60);
	CHECK_GE("way without limits", position_of(world, line), 3.9, "m");
	cn_world_destroy(world);
}

static void soft_line_is_a_spring(void)
{
	cn_world *world = fixture_world(-(float)GRAVITY, 0);
	cn_body box = unit_box(world, 0.0f, 0.0f, 0.0f);
	cn_line_constraint_def def = line_def(box, at(0.0f, 0.0f), at(1.0f, 0.0f));
	cn_constraint line;
	def.hertz = 2.0f;
	def.damping_ratio = 0.7f;
	line = make_line(world, &def);
	fixture_step(world, 600);
	CHECK_LE("sag against g / w^2", fabs(y_of(world, box) + GRAVITY / pow(4.0 * PI, 2.0)), 1e-5, "m");
	CHECK_LE("error read back", fabs(error_of(world, line) - GRAVITY / pow(4.0 * PI, 2.0)), 1e-5, "m");
	cn_world_destroy(world);
}

/* A lift: a platform on a vertical line, its angle locked, a heavy box standing on one end of it. */
static void a_platform_carries_its_load(void)
{
	cn_world *world = fixture_world(-(float)GRAVITY, 0);
	cn_body platform = fixture_box(world, CN_BODY_DYNAMIC, 0.0f, 3.0f, 0.0f, 2.0f, 0.1f, 0.6f, 0.0f);
	cn_body load = fixture_box(world, CN_BODY_DYNAMIC, 1.5f, 3.6f, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f);
	cn_line_constraint_def def = line_def(platform, at(0.0f, 0.0f), at(0.0f, 1.0f));
	cn_constraint line, lock;
	double x, y;
	def.flags = CN_CONSTRAINT_LIMIT;
	def.lower_m = 3.0f;
	def.upper_m = 10.0f;
	line = make_line(world, &def);
	lock = hold_angle(world, platform, 0.0f, 0.0f);
	fixture_step(world, 300);
	x = x_of(world, load);
	y = y_of(world, load);
	CHECK_LE("force against the weight of both", fabs((double)force_of(world, line).y - 1.8 * GRAVITY), 5e-3, "N");
	CHECK_LE("torque against the load's", fabs(torque_of(world, lock) - 1.5 * GRAVITY), 5e-3, "Nm");
	CHECK_LE("platform off its line, angle and lower limit", error_of(world, line) + error_of(world, lock), 1e-3, "");
	fixture_step(world, 1800);
	CHECK_LE("load creeps in 30 s", hypot(x_of(world, load) - x, y_of(world, load) - y), 1e-4, "m");
	cn_world_destroy(world);
}

/* A box pressed against a wall by a line constraint's limits keeps still. */
static void line_against_a_contact(void)
{
	cn_world *world = fixture_world(-(float)GRAVITY, 0);
	cn_body box;
	cn_line_constraint_def def;
	cn_constraint line;
	double y;
	fixture_floor(world, 0.6f, 0.0f);
	box = unit_box(world, 0.0f, 0.5f, 0.0f);
	def = line_def(box, at(0.0f, 0.0f), at(0.0f, 1.0f));
	line = make_line(world, &def);
	fixture_step(world, 60);
	y = y_of(world, box);
	{
		int32_t k;
		for (k = 0; k < 600; ++k) { /* 8 N sideways: more than friction holds, the line takes the rest */
			must(cn_body_apply_force_at(world, box, 8.0f, 0.0f, (float)x_of(world, box), (float)y_of(world, box)), world, "cn_body_apply_force_at");
			fixture_step(world, 1);
		}
	}
	CHECK_LE("sideways", fabs(x_of(world, box)), 2.0 * SOLVED, "m");
	CHECK_LE("sunk or lifted", fabs(y_of(world, box) - y), SAG_M, "m");
	CHECK_LE("force of line and friction", fabs((double)force_of(world, line).x), 8.01, "N");
	cn_world_destroy(world);
}

/* ---- breaking, life, handles ---- */

static void constraints_break(void)
{
	cn_world *world = fixture_world(0.0f, 0);
	cn_body box = unit_box(world, 0.0f, 0.0f, 0.0f), other = unit_box(world, 5.0f, 0.0f, 0.0f);
	cn_angle_constraint_def angle = angle_def(box, 0.0f, 0.0f);
	cn_line_constraint_def wire = line_def(other, at(5.0f, 0.0f), at(1.0f, 0.0f));
	const cn_joint_event *events = NULL;
	cn_constraint lock, line;
	double torque = 0.0, force = 0.0;
	int32_t k, count = 0;
	angle.flags = CN_CONSTRAINT_BREAKS;
	angle.break_torque_Nm = 5.0f;
	angle.user_data = 42;
	wire.break_force_N = 20.0f;
	lock = make_angle(world, &angle);
	line = make_line(world, &wire);
	for (k = 0; k < 600 && cn_constraint_is_valid(world, lock); ++k) {
		torque = 0.02 * (double)k;
		must(cn_body_apply_torque(world, box, (float)torque), world, "cn_body_apply_torque");
		fixture_step(world, 1);
	}
	CHECK_LE("torque at which it breaks against 5 Nm", fabs(torque - 5.0), 0.05, "Nm");
	must(cn_world_joint_events(world, &events, &count), world, "cn_world_joint_events");
	REQUIRE(count == 1);
	CHECK(events[0].constraint == lock && events[0].joint == 0 && events[0].destroyed == 1 && events[0].body_b == box && events[0].user_data == 42);
	for (k = 0, count = 0; k < 600 && count == 0; ++k) {
		force = 0.1 * (double)k;
		must(cn_body_apply_force(world, other, 0.0f, (float)force), world, "cn_body_apply_force");
		fixture_step(world, 1);
		must(cn_world_joint_events(world, &events, &count), world, "cn_world_joint_events");
	}
	CHECK_LE("force at which it is reported against 20 N", fabs(force - 20.0), 0.15, "N");
	CHECK(count == 1 && events[0].constraint == line && events[0].destroyed == 0 && cn_constraint_is_valid(world, line));
	CHECK(fixture_is_valid(world));
	cn_world_destroy(world);
}

static void handles_are_of_their_own_kind(void)
{
	cn_world *world = fixture_world(0.0f, 0);
	cn_body box = unit_box(world, 0.0f, 0.0f, 0.0f);
	cn_fixed_def weld;
	cn_joint joint = 0, joints[4];
	cn_constraint lock, line, list[4];
	cn_line_constraint_def wire = line_def(box, at(0.0f, 0.0f), at(1.0f, 1.0f));
	cn_angle_constraint_def angle;
	cn_vec2 force;
	float x;
	int32_t count = 0, type = -1;
	cn_body body = 0;
	cn_fixed_def_init(&weld);
	weld.base.body_b = box;
	must(cn_joint_create_fixed(world, &weld, &joint), world, "cn_joint_create_fixed");
	lock = hold_angle(world, box, 0.0f, 0.0f);
	line = make_line(world, &wire);
	CHECK(cn_joint_is_valid(world, joint) && !cn_joint_is_valid(world, lock) && !cn_joint_is_valid(world, line));
	CHECK(!cn_constraint_is_valid(world, joint) && cn_constraint_is_valid(world, lock) && cn_constraint_is_valid(world, line));
	/* The other kind's bits on a live index: not a handle either. */
	CHECK(!cn_constraint_is_valid(world, joint ^ (1u << 20)) && !cn_joint_is_valid(world, lock ^ (1u << 20)));
	CHECK(cn_joint_destroy(world, lock) == CN_ERROR_HANDLE && cn_joint_destroy(world, lock ^ (1u << 20)) == CN_ERROR_HANDLE);
	CHECK(cn_constraint_destroy(world, joint) == CN_ERROR_HANDLE && cn_constraint_destroy(world, joint ^ (1u << 20)) == CN_ERROR_HANDLE);
	CHECK(cn_joint_get_position(world, lock, &x) == CN_ERROR_HANDLE && cn_constraint_get_reaction(world, joint, &force, &x) == CN_ERROR_HANDLE);
	CHECK(cn_constraint_get_angle(world, line, &angle) == CN_ERROR_STATE);
	must(cn_world_get_joints(world, joints, 4, &count), world, "cn_world_get_joints");
	CHECK(count == 1 && joints[0] == joint);
	must(cn_body_get_joints(world, box, joints, 4, &count), world, "cn_body_get_joints");
	CHECK(count == 1 && joints[0] == joint);
	must(cn_world_get_constraints(world, list, 4, &count), world, "cn_world_get_constraints");
	CHECK(count == 2 && list[0] == lock && list[1] == line);
	must(cn_body_get_constraints(world, box, list, 4, &count), world, "cn_body_get_constraints");
	CHECK(count == 2);
	must(cn_constraint_get_type(world, line, &type), world, "cn_constraint_get_type");
	must(cn_constraint_get_body(world, line, &body), world, "cn_constraint_get_body");
	CHECK(type == CN_CONSTRAINT_LINE && body == box);
	CHECK(fixture_counters(world).joints == 3);
	must(cn_constraint_destroy(world, lock), world, "cn_constraint_destroy");
	CHECK(!cn_constraint_is_valid(world, lock) && cn_constraint_is_valid(world, line) && fixture_is_valid(world));
	CHECK(cn_body_set_type(world, box, CN_BODY_KINEMATIC) == CN_ERROR_STATE);
	cn_world_destroy(world);
}

static void what_is_set_is_read_back(void)
{
	cn_world *world = fixture_world(0.0f, 0);
	cn_body box = unit_box(world, 0.0f, 0.0f, 0.0f);
	cn_angle_constraint_def a = angle_def(box, -1.0f, 1.0f), a2;
	cn_line_constraint_def l = line_def(box, at(0.0f, 0.0f), at(1.0f, 0.0f)), l2;
	cn_constraint angle = make_angle(world, &a), line = make_line(world, &l);
	a.flags = CN_CONSTRAINT_BREAKS;
	a.lower_rad = -2.0f;
	a.hertz = 3.0f;
	a.damping_ratio = 0.5f;
	a.break_torque_Nm = 4.0f;
	a.user_data = 6;
	must(cn_constraint_set_angle(world, angle, &a), world, "cn_constraint_set_angle");
	must(cn_constraint_get_angle(world, angle, &a2), world, "cn_constraint_get_angle");
	CHECK(memcmp(&a, &a2, sizeof a) == 0);
	l.flags = CN_CONSTRAINT_LIMIT | CN_CONSTRAINT_BREAKS;
	l.anchor_m = at(0.5f, 0.0f);
	l.origin_m = at(0.0f, 0.25f);
	l.axis = at(0.0f, -1.0f);
	l.tolerance_m = 0.1f;
	l.lower_m = -3.0f;
	l.upper_m = 3.0f;
	l.hertz = 10.0f;
	l.break_force_N = 100.0f;
	l.user_data = 7;
	must(cn_constraint_set_line(world, line, &l), world, "cn_constraint_set_line");
	must(cn_constraint_get_line(world, line, &l2), world, "cn_constraint_get_line");
	CHECK(memcmp(&l, &l2, sizeof l) == 0);
	fixture_step(world, 10);
	cn_world_destroy(world);
}

/* Rest, disable, enable, destroy, with a constraint: lists stay whole. */
static void constraints_sleep_with_their_body(void)
{
	cn_world *world = fixture_world(-(float)GRAVITY, 1);
	cn_body box;
	cn_constraint lock;
	cn_pose before, after;
	fixture_floor(world, 0.6f, 0.0f);
	box = unit_box(world, 0.0f, 0.5f, 0.0f);
	lock = hold_angle(world, box, 0.0f, 0.0f);
	fixture_step(world, 120);
	CHECK(!fixture_is_awake(world, box) && fixture_counters(world).joints_awake == 0);
	before = fixture_pose(world, box);
	fixture_step(world, 60);
	after = fixture_pose(world, box);
	CHECK(memcmp(&before, &after, sizeof before) == 0);
	must(cn_body_set_flags(world, box, CN_BODY_SLEEP), world, "cn_body_set_flags");
	fixture_step(world, 5);
	CHECK(fixture_is_valid(world) && fixture_counters(world).joints_awake == 0);
	must(cn_body_set_flags(world, box, CN_BODY_SLEEP | CN_BODY_ENABLED), world, "cn_body_set_flags");
	fixture_step(world, 5);
	CHECK(fixture_is_valid(world) && fixture_counters(world).joints_awake == 1);
	must(cn_body_apply_angular_impulse(world, box, 0.5f), world, "cn_body_apply_angular_impulse");
	fixture_step(world, 60);
	CHECK_LE("turned by a kick", error_of(world, lock), SOLVED, "rad");
	must(cn_constraint_destroy(world, lock), world, "cn_constraint_destroy");
	CHECK(fixture_is_valid(world) && fixture_is_awake(world, box));
	cn_world_destroy(world);
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(angle_limits_cancel_spin);
	RUN(angle_counts_whole_turns);
	RUN(angle_reaction_is_the_torque);
	RUN(soft_angle_gives_way_by_its_stiffness);
	RUN(a_locked_circle_does_not_creep_on_a_rough_slope);
	RUN(a_locked_circle_rides_along);
	RUN(a_locked_tower_stands);
	RUN(line_keeps_a_bead_on_a_wire);
	RUN(line_holds_a_point_of_the_body);
	RUN(line_has_tolerance_and_limits);
	RUN(soft_line_is_a_spring);
	RUN(a_platform_carries_its_load);
	RUN(line_against_a_contact);
	RUN(constraints_break);
	RUN(handles_are_of_their_own_kind);
	RUN(what_is_set_is_read_back);
	RUN(constraints_sleep_with_their_body);
	return test_end();
}
