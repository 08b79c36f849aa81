/*
 * test/world/physics_test.c - motion against closed forms.
 *
 * If a test here fails, look first in: step/integrate.c (flight, spin), contacts/contact_solve.c (inclines,
 * sliding, stacks), contacts/restitution.c (drops, clusters), collision/manifold*.c (stacks, pyramid).
 */
#include "fixture.h"

#define GRAVITY 10.0

/* ---- free motion ---- */

static void flight_is_a_parabola(void)
{
	cn_world *world = fixture_world(-10.0f, 0);
	cn_body body = fixture_box(world, CN_BODY_DYNAMIC, 0.0f, 0.0f, 0.3f, 0.5f, 0.25f, 0.6f, 0.0f);
	double worst = 0.0;
	int32_t k;
	fixture_set_velocity(world, body, 7.0f, 20.0f, 3.0f);
	for (k = 1; k <= 600; ++k) {
		double t = k * (double)FRAME_S, x = 7.0 * t, y = 20.0 * t - 0.5 * GRAVITY * t * t, error;
		cn_pose pose;
		fixture_step(world, 1);
		pose = fixture_pose(world, body);
		error = sqrt(pow((double)pose.position_m.x - x, 2) + pow((double)pose.position_m.y - y, 2));
		worst = error > worst ? error : worst;
	}
	CHECK_LE("position error over 10 s", worst, 1e-3, "m");
	cn_world_destroy(world);
}

static void spin_keeps_its_angle(void)
{
	static const float speeds[] = { 3.0f, 30.0f, 100.0f };
	size_t s;
	for (s = 0; s < sizeof speeds / sizeof *speeds; ++s) {
		cn_world *world = fixture_world(0.0f, 0);
		cn_body body = fixture_box(world, CN_BODY_DYNAMIC, 0.0f, 0.0f, 0.0f, 1.0f, 0.1f, 0.6f, 0.0f);
		double exact = (double)speeds[s] * 600.0 * (double)FRAME_S, error;
		cn_pose pose;
		fixture_set_velocity(world, body, 0.0f, 0.0f, speeds[s]);
		fixture_step(world, 600);
		pose = fixture_pose(world, body);
		error = fabs(remainder(atan2((double)pose.sine, (double)pose.cosine) - exact, 2.0 * 3.14159265358979323846));
		CHECK_LE("angle error after 10 s", error, SOLVED, "rad");
		cn_world_destroy(world);
	}
}

/* ---- friction ---- */

/* Distance a box slides in 5 s down a plane whose slope is ratio times the friction coefficient. */
static double incline_slide(float ratio, float mu)
{
	double angle = atan((double)(ratio * mu));
	cn_world *world = fixture_world(-10.0f, 0);
	float c = (float)cos(angle), s = (float)sin(angle), x0, y0;
	cn_body box;
	cn_pose pose;
	double along;
	fixture_box(world, CN_BODY_STATIC, s, -c, (float)-angle * -1.0f, 50.0f, 1.0f, mu, 0.0f);
	x0 = -0.5f * s;
	y0 = 0.5f * c;
	box = fixture_box(world, CN_BODY_DYNAMIC, x0, y0, (float)angle, 0.5f, 0.5f, mu, 0.0f);
	fixture_step(world, 300);
	pose = fixture_pose(world, box);
	along = -(((double)pose.position_m.x - (double)x0) * (double)c + ((double)pose.position_m.y - (double)y0) * (double)s);
	cn_world_destroy(world);
	return along;
}

static void box_sticks_below_the_critical_angle(void)
{
	CHECK_LE("slip in 5 s at 0.98 of the critical slope", fabs(incline_slide(0.98f, 0.5f)), ROUNDING, "m");
	CHECK_LE("slip in 5 s at 0.98, coefficient 0.8", fabs(incline_slide(0.98f, 0.8f)), ROUNDING, "m");
}

static void box_slides_above_the_critical_angle(void)
{
	double angle = atan(1.02 * 0.5), a = GRAVITY * (sin(angle) - 0.5 * cos(angle)), exact = 0.5 * a * 25.0;
	double slid = incline_slide(1.02f, 0.5f);
	printf("  slid %.6f m, exact %.6f m\n", slid, exact);
	CHECK_LE("error of the slide in 5 s at 1.02", fabs(slid - exact), 2.0 * ROUNDING, "m");
}

static void sliding_box_stops_where_it_should(void)
{
	static const float speeds[] = { 2.0f, 5.0f, 12.0f };
	size_t k;
	for (k = 0; k < sizeof speeds / sizeof *speeds; ++k) {
		cn_world *world = fixture_world(-10.0f, 0);
		double exact = (double)speeds[k] * (double)speeds[k] / (2.0 * 0.4 * GRAVITY), slid;
		cn_body box;
		fixture_floor(world, 0.4f, 0.0f);
		box = fixture_box(world, CN_BODY_DYNAMIC, -20.0f, 0.25f, 0.0f, 0.5f, 0.25f, 0.4f, 0.0f);
		fixture_set_velocity(world, box, speeds[k], 0.0f, 0.0f);
		fixture_step(world, 300);
		slid = (double)fixture_pose(world, box).position_m.x + 20.0;
		CHECK_LE("relative error of the stopping distance", fabs(slid - exact) / exact, 3e-4, "");
		CHECK_LE("speed at the end", fabs((double)fixture_velocity(world, box).linear_mps.x), 2.0 * ROUNDING, "m/s");
		cn_world_destroy(world);
	}
}

/* A push between dynamic and static friction moves a sliding box but not a resting one. */
static void static_and_dynamic_friction_differ(void)
{
	int32_t moving, k;
	for (moving = 0; moving < 2; ++moving) {
		cn_world *world = fixture_world(-10.0f, 0);
		cn_body floor_body = fixture_body(world, CN_BODY_STATIC, 0.0f, -1.0f, 0.0f);
		cn_shape_def def = fixture_shape_def(floor_body, 0.6f, 0.0f);
		cn_body box;
		cn_vec2 push = { 4.5f, 0.0f };
		double x;
		def.material.dynamic_friction = 0.3f;
		fixture_box_shape(world, &def, 100.0f, 1.0f);
		box = fixture_body(world, CN_BODY_DYNAMIC, 0.0f, 0.5f, 0.0f);
		def.body = box;
		fixture_box_shape(world, &def, 0.5f, 0.5f); /* 1 kg: friction holds 6 N, drags 3 N */
		if (moving)
			fixture_set_velocity(world, box, 1.0f, 0.0f, 0.0f);
		for (k = 0; k < 120; ++k) {
			must(cn_body_apply_force(world, box, push.x, push.y), world, "cn_body_apply_force");
			fixture_step(world, 1);
		}
		x = (double)fixture_pose(world, box).position_m.x;
		if (moving) /* x = t + 0.75 t^2 */
			CHECK_LE("error of the pushed slide", fabs(x - 5.0), 3e-4, "m");
		else
			CHECK_LE("slip of the resting box", fabs(x), 1e-4, "m");
		cn_world_destroy(world);
	}
}

/* ---- restitution ---- */

/* Contacts that bear already bounce too, when they are jumped by more than they bear: a ball and a box that lie on the
   floor, and a ball with two more on top, of which the uppermost takes the blow: (1 + e)/2 of the speed goes from each to the next. */
static void what_lies_bounces_when_struck(void)
{
	static const float speeds[] = { -1.5f, -5.0f, -30.0f };
	size_t i;
	for (i = 0; i < 3; ++i) {
		cn_world *world = fixture_world(-10.0f, 0);
		cn_body ball, box, loaded, top;
		double speed = -(double)speeds[i];
		fixture_floor(world, 0.6f, 0.0f);
		ball = fixture_circle(world, CN_BODY_DYNAMIC, 0.0f, 0.5f, 0.5f, 0.6f, 0.8f);
		box = fixture_box(world, CN_BODY_DYNAMIC, 4.0f, 0.5f, 0.0f, 0.5f, 0.5f, 0.6f, 0.8f);
		loaded = fixture_circle(world, CN_BODY_DYNAMIC, 8.0f, 0.5f, 0.5f, 0.6f, 0.8f);
		fixture_circle(world, CN_BODY_DYNAMIC, 8.0f, 1.5f, 0.5f, 0.6f, 0.8f);
		top = fixture_circle(world, CN_BODY_DYNAMIC, 8.0f, 2.5f, 0.5f, 0.6f, 0.8f);
		fixture_step(world, 120);
		fixture_set_velocity(world, ball, 0.0f, speeds[i], 0.0f);
		fixture_set_velocity(world, box, 0.0f, speeds[i], 0.0f);
		fixture_set_velocity(world, loaded, 0.0f, speeds[i], 0.0f);
		fixture_step(world, 1);
		printf("  jumped at %.1f m/s\n", speed);
		CHECK_LE("error of the ball's speed", fabs((double)fixture_velocity(world, ball).linear_mps.y - 0.8 * speed), 2.0 * GRAVITY * (double)FRAME_S, "m/s");
		CHECK_LE("error of the box's speed", fabs((double)fixture_velocity(world, box).linear_mps.y - 0.8 * speed), 2.0 * GRAVITY * (double)FRAME_S, "m/s");
		CHECK_LE("error of the speed of the uppermost of three", fabs((double)fixture_velocity(world, top).linear_mps.y - 0.9 * 0.9 * 0.8 * speed), 2.0 * GRAVITY * (double)FRAME_S, "m/s");
		cn_world_destroy(world);
	}
}

static void drops_return_to_their_height(void)
{
	static const float es[] = { 1.0f, 0.8f, 0.5f };
	static const float heights[] = { 4.0f, 1.3f, 11.7f };
	size_t i, h;
	for (i = 0; i < 3; ++i)
		for (h = 0; h < 3; ++h) {
			cn_world *world = fixture_world(-10.0f, 0);
			double expected = (double)heights[h], apex = 0.0, worst = 0.0, above = 0.0, last_v = 0.0;
			int32_t bounces = 0, k;
			cn_body ball;
			fixture_floor(world, 0.6f, 0.0f);
			ball = fixture_circle(world, CN_BODY_DYNAMIC, 0.0f, 0.5f + heights[h], 0.5f, 0.6f, es[i]);
			for (k = 0; k < 3600 && bounces < 5; ++k) {
				double y, v;
				fixture_step(world, 1);
				y = (double)fixture_pose(world, ball).position_m.y - 0.5;
				v = (double)fixture_velocity(world, ball).linear_mps.y;
				if (last_v <= 0.0 && v > 0.0)
					apex = 0.0;
				apex = y + (v > 0.0 ? 0.0 : v * v / (2.0 * GRAVITY));
				if (last_v > 0.0 && v <= 0.0) {
					++bounces;
					expected *= (double)(es[i] * es[i]);
					if (sqrt(2.0 * GRAVITY * expected / (double)(es[i] * es[i])) < 1.1)
						break; /* below the restitution threshold */
					worst = greater(worst, fabs(apex - expected) / (double)heights[h]);
					above = greater(above, (apex - expected) / (double)heights[h]);
				}
				last_v = v;
			}
			printf("  e %.1f from %.1f m: %d bounces\n", (double)es[i], (double)heights[h], (int)bounces);
			CHECK_LE("apex error / height", worst, 1e-5, "");
			CHECK_LE("apex above the law / height", above, 1e-5, "");
			cn_world_destroy(world);
		}
}

/* Eight balls in a row, seven at rest and touching: each hands on (1 + e) / 2 of its speed, whatever order they were made in. */
static void wave_run(float e, float speed, int32_t backwards)
{
	cn_world *world = fixture_world(0.0f, 0);
	cn_body balls[8];
	double momentum = 0.0, expected = (double)speed * pow(0.5 * (1.0 + (double)e), 7.0);
	int32_t k;
	for (k = 0; k < 8; ++k) {
		int32_t which = backwards ? 7 - k : k;
		balls[which] = fixture_circle(world, CN_BODY_DYNAMIC, (float)which - (which == 0 ? 1.0f : 0.0f), 0.0f, 0.5f, 0.0f, e);
	}
	fixture_set_velocity(world, balls[0], speed, 0.0f, 0.0f);
	fixture_step(world, 120);
	for (k = 0; k < 8; ++k)
		momentum += (double)fixture_velocity(world, balls[k]).linear_mps.x;
	CHECK_LE("wave: speed of the last ball, off the law / speed", fabs((double)fixture_velocity(world, balls[7]).linear_mps.x - expected) / (double)speed, 1e-3, "");
	CHECK_LE("wave: change of momentum / momentum", fabs(momentum - (double)speed) / (double)speed, ROUNDING, "");
	cn_world_destroy(world);
}

/* Restitution takes as many sweeps as that needs: with one, seven balls would swallow it. */
static void a_wave_passes_through_touching_balls(void)
{
	int32_t backwards;
	for (backwards = 0; backwards < 2; ++backwards) {
		wave_run(1.0f, 2.0f, backwards);
		wave_run(1.0f, 12.0f, backwards);
		wave_run(0.8f, 2.0f, backwards);
		wave_run(0.8f, 12.0f, backwards);
	}
}

static double kinetic_energy(const cn_world *world, const cn_body *bodies, int32_t count, double *px, double *py, double *scale)
{
	double energy = 0.0;
	int32_t k;
	*px = *py = *scale = 0.0;
	for (k = 0; k < count; ++k) {
		cn_mass_data m;
		cn_velocity v = fixture_velocity(world, bodies[k]);
		double vx = (double)v.linear_mps.x, vy = (double)v.linear_mps.y, w = (double)v.angular_radps, mass;
		must(cn_body_get_mass_data(world, bodies[k], &m), world, "cn_body_get_mass_data");
		mass = (double)m.mass_kg;
		energy += 0.5 * mass * (vx * vx + vy * vy) + 0.5 * (double)m.inertia_kgm2 * w * w;
		*px += mass * vx;
		*py += mass * vy;
		*scale += mass * sqrt(vx * vx + vy * vy);
	}
	return energy;
}

/* Bodies flying into each other without gravity, in a ring that points inwards. */
static void cluster_run(float e, int32_t boxes, uint32_t seed)
{
	cn_world *world = fixture_world(0.0f, 0);
	cn_body bodies[40];
	double px0, py0, scale0, energy0, most = 0.0, px, py, scale;
	int32_t k;
	for (k = 0; k < 40; ++k) {
		float x = fixture_random(&seed, -5.0f, 5.0f), y = (float)(k - 20) * 0.6f, r = fixture_random(&seed, 0.1f, 0.28f), vx;
		bodies[k] = boxes && k % 2 ? fixture_box(world, CN_BODY_DYNAMIC, x, y, x, r, 0.7f * r, 0.5f, e)
		                           : fixture_circle(world, CN_BODY_DYNAMIC, x, y, r, 0.5f, e);
		vx = fixture_random(&seed, -1.0f, 1.0f) - 2.0f * x;
		fixture_set_velocity(world, bodies[k], vx, -1.5f * y, fixture_random(&seed, -3.0f, 3.0f));
	}
	energy0 = kinetic_energy(world, bodies, 40, &px0, &py0, &scale0);
	for (k = 0; k < 600; ++k) {
		double energy;
		fixture_step(world, 1);
		energy = kinetic_energy(world, bodies, 40, &px, &py, &scale);
		most = greater(most, energy / energy0);
	}
	printf("  e %.1f boxes %d: energy at the end %.4f of the start\n", (double)e, (int)boxes,
	       kinetic_energy(world, bodies, 40, &px, &py, &scale) / energy0);
	CHECK_LE("most energy / start", most, 1.00001, "");
	CHECK_LE("change of momentum / sum of momenta", sqrt(pow(px - px0, 2) + pow(py - py0, 2)) / scale0, 1e-6, "");
	CHECK(fixture_is_valid(world));
	cn_world_destroy(world);
}

static void cluster_keeps_momentum_and_gains_no_energy(void)
{
	uint32_t seed;
	for (seed = 1; seed <= 4; ++seed) {
		cluster_run(0.0f, 0, seed * 2654435761u);
		cluster_run(0.5f, 1, seed * 2654435761u);
		cluster_run(1.0f, 0, seed * 2654435761u);
		cluster_run(1.0f, 1, seed * 2654435761u);
	}
}

/* ---- standing ---- */

static void stack_stands(int32_t count)
{
	cn_world *world = fixture_world(-10.0f, 0);
	cn_body bodies[64];
	double drift = 0.0;
	float penetration;
	int32_t k;
	fixture_floor(world, 0.6f, 0.0f);
	for (k = 0; k < count; ++k)
		bodies[k] = fixture_box(world, CN_BODY_DYNAMIC, 0.0f, 0.5f + (float)k, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f);
	fixture_step(world, 3600);
	for (k = 0; k < count; ++k) {
		cn_pose p = fixture_pose(world, bodies[k]);
		drift = greater(drift, fabs((double)p.position_m.x));
	}
	penetration = fixture_penetration(world, bodies, count);
	printf("  stack of %d after 60 s\n", (int)count);
	CHECK_LE("penetration", (double)penetration, SAG_M, "m");
	CHECK_LE("sideways drift", drift, ROUNDING, "m");
	cn_world_destroy(world);
}

static void stacks_of_boxes_stand_60_s(void)
{
	stack_stands(10);
	stack_stands(20);
}

static void pyramid_of_20_keeps_its_place(void)
{
	cn_world *world = fixture_world(-10.0f, 0);
	cn_body bodies[210];
	double start[210][2], worst = 0.0;
	int32_t i, j, n = 0, k;
	fixture_floor(world, 0.6f, 0.0f);
	for (i = 0; i < 20; ++i)
		for (j = i; j < 20; ++j, ++n) {
			float x = 0.5f * (float)(i + 1) + (float)(j - i) - 10.0f, y = (float)i + 0.5f;
			start[n][0] = (double)x;
			start[n][1] = (double)y;
			bodies[n] = fixture_box(world, CN_BODY_DYNAMIC, x, y, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f);
		}
	fixture_step(world, 600);
	for (k = 0; k < n; ++k) {
		cn_pose p = fixture_pose(world, bodies[k]);
		worst = greater(worst, hypot((double)p.position_m.x - start[k][0], (double)p.position_m.y - start[k][1]));
	}
	CHECK_LE("displacement after 10 s", worst, SOLVED, "m");
	CHECK(fixture_is_valid(world));
	cn_world_destroy(world);
}

static void dominoes_topple_in_order(void)
{
	cn_world *world = fixture_world(-10.0f, 1);
	cn_body bodies[30];
	int32_t fallen_at[30], k, step, ordered = 1;
	fixture_floor(world, 0.6f, 0.0f);
	for (k = 0; k < 30; ++k) {
		bodies[k] = fixture_box(world, CN_BODY_DYNAMIC, (float)k, 1.0f, 0.0f, 0.1f, 1.0f, 0.6f, 0.0f);
		fallen_at[k] = -1;
	}
	fixture_set_velocity(world, bodies[0], 1.5f, 0.0f, -1.5f);
	for (step = 0; step < 900; ++step) {
		fixture_step(world, 1);
		for (k = 0; k < 30; ++k)
			if (fallen_at[k] < 0 && fixture_pose(world, bodies[k]).sine < -0.3f)
				fallen_at[k] = step;
	}
	for (k = 0; k < 30; ++k)
		ordered = ordered && fallen_at[k] >= 0 && (k == 0 || fallen_at[k] > fallen_at[k - 1]);
	CHECK(ordered);
	printf("  the last one fell after %.2f s\n", (double)fallen_at[29] / 60.0);
	cn_world_destroy(world);
}

/* ---- far from the origin ---- */

static void stack_stands_far_from_the_origin(void)
{
	static const float places[] = { 1e3f, 1e4f };
	size_t i;
	for (i = 0; i < 2; ++i) {
		cn_world *world = fixture_world(-10.0f, 0);
		cn_body bodies[10];
		double drift = 0.0;
		int32_t k;
		fixture_box(world, CN_BODY_STATIC, places[i], places[i] - 1.0f, 0.0f, 10.0f, 1.0f, 0.6f, 0.0f);
		for (k = 0; k < 10; ++k)
			bodies[k] = fixture_box(world, CN_BODY_DYNAMIC, places[i], places[i] + 0.5f + (float)k, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f);
		fixture_step(world, 1200);
		for (k = 0; k < 10; ++k) {
			cn_pose p = fixture_pose(world, bodies[k]);
			drift = greater(drift, fabs((double)p.position_m.x - (double)places[i]));
		}
		printf("  at %g m\n", (double)places[i]);
		/* At 10 km a float counts in millimetres. */
		CHECK_LE("sideways drift in 20 s", drift, 1e-3, "m");
		cn_world_destroy(world);
	}
}

/* The farthest way and turn of a step: of bodies set to fly and spin at once, and of two that a joint pulls together from afar. */
static void speed_limits_hold_in_every_step(void)
{
	const double way_most = 1.001 * (double)FRAME_S, turn_most = 2.001 * (double)FRAME_S;
	cn_world *world = fixture_world(0.0f, 0);
	cn_body bodies[4];
	cn_revolute_def pin;
	cn_joint joint;
	double way = 0.0, turn = 0.0;
	int32_t k, step;
	must(cn_world_set_speed_limits(world, 1.0f, 2.0f), world, "cn_world_set_speed_limits");
	for (k = 0; k < 4; ++k)
		bodies[k] = fixture_box(world, CN_BODY_DYNAMIC, 30.0f * (float)k, 0.0f, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f);
	fixture_set_velocity(world, bodies[0], 100.0f, -50.0f, 60.0f);
	fixture_set_velocity(world, bodies[1], -3e20f, 2e30f, -1e30f);
	cn_revolute_def_init(&pin);
	pin.base.body_a = bodies[2];
	pin.base.body_b = bodies[3];
	pin.base.anchor_a_m.y = 0.5f;
	must(cn_joint_create_revolute(world, &pin, &joint), world, "cn_joint_create_revolute");
	for (step = 0; step < 120; ++step) {
		cn_pose before[4];
		for (k = 0; k < 4; ++k)
			before[k] = fixture_pose(world, bodies[k]);
		fixture_step(world, 1);
		for (k = 0; k < 4; ++k) {
			cn_pose now = fixture_pose(world, bodies[k]), was = before[k];
			way = fmax(way, hypot((double)(now.position_m.x - was.position_m.x), (double)(now.position_m.y - was.position_m.y)));
			turn = fmax(turn, fabs((double)was.cosine * (double)now.sine - (double)was.sine * (double)now.cosine));
		}
	}
	CHECK_LE("way in a step at 1 m/s", way, way_most, "m");
	CHECK_LE("turn in a step at 2 rad/s", turn, turn_most, "rad");
	cn_world_destroy(world);
}

/* Rough bouncing bodies in the way of some that are so fast that they meet metres ahead, all within a step. */
static void fast_rough_bodies_gain_no_energy(void)
{
	enum { CROWD = 120, FAST = 4 };
	int32_t seed;
	double most = 0.0;
	for (seed = 1; seed <= 10; ++seed) {
		cn_world *world = fixture_world(0.0f, 0);
		cn_body bodies[CROWD];
		uint32_t random = (uint32_t)seed * 2654435761u;
		double start = 0.0;
		int32_t k, step;
		for (k = 0; k < CROWD; ++k) {
			float x = 1.1f * (float)(k % 12), y = 1.1f * (float)(k / 12), turn = fixture_random(&random, -3.0f, 3.0f), size = fixture_random(&random, 0.1f, 0.4f);
			bodies[k] = fixture_box(world, CN_BODY_DYNAMIC, x, y, turn, size, 0.3f, 1.0f, 0.7f);
			if (k % (CROWD / FAST) == 0)
				fixture_set_velocity(world, bodies[k], 200.0f, fixture_random(&random, -60.0f, 60.0f), 20.0f);
		}
		for (step = 0; step <= 30; ++step) {
			double px, py, scale, energy = kinetic_energy(world, bodies, CROWD, &px, &py, &scale);
			if (step == 0)
				start = energy;
			most = fmax(most, energy / start);
			fixture_step(world, 1);
		}
		cn_world_destroy(world);
	}
	CHECK_LE("kinetic energy / start", most, 1.001, "");
}

/* Deepest overlap of each contact, summed, in metres. */
static double overlaps(const cn_world *world, const cn_body *bodies, int32_t count)
{
	double sum = 0.0;
	int32_t k, c, p, contacts;
	cn_contact_event events[64];
	for (k = 0; k < count; ++k) {
		must(cn_body_get_contacts(world, bodies[k], events, 64, &contacts), world, "cn_body_get_contacts");
		for (c = 0; c < contacts && c < 64; ++c) {
			double deepest = 0.0;
			for (p = 0; p < events[c].manifold.point_count; ++p)
				deepest = fmax(deepest, -(double)events[c].manifold.points[p].separation_m);
			sum += 0.5 * deepest; /* each contact is seen from both sides */
		}
	}
	return sum;
}

/* A heavy box drives through a wall of light ones: velocities jump in every substep, and what is pressed together must be held
   by what held it in the last one. */
static void a_crowd_that_is_struck_is_held_apart(void)
{
	enum { SIDE = 24, CROWD = SIDE * SIDE, STEPS = 20 };
	cn_world *world = fixture_world(0.0f, 0);
	cn_body bodies[CROWD], ram;
	cn_shape_def heavy;
	double sum = 0.0;
	int32_t k;
	for (k = 0; k < CROWD; ++k)
		bodies[k] = fixture_box(world, CN_BODY_DYNAMIC, 0.4f * (float)(k % SIDE), 0.4f * (float)(k / SIDE), 0.0f, 0.2f, 0.2f, 0.6f, 0.0f);
	ram = fixture_body(world, CN_BODY_DYNAMIC, -2.5f, 0.2f * (float)SIDE, 0.0f);
	heavy = fixture_shape_def(ram, 0.6f, 0.0f);
	heavy.density_kgpm2 = 8.0f;
	fixture_box_shape(world, &heavy, 2.0f, 2.0f);
	fixture_set_velocity(world, ram, 40.0f, 0.0f, 0.0f);
	for (k = 0; k < STEPS; ++k) {
		fixture_step(world, 1);
		sum += overlaps(world, bodies, CROWD) / (double)(CROWD * STEPS);
	}
	CHECK_LE("mean overlap a body in the third of a second after", sum, 0.065, "m"); /* 0.089 where every substep begins without */
	cn_world_destroy(world);
}

/* A drum turns with boxes in it, 26 deep. A soft contact sinks by the weight of all above; loads are too slow for a crowd that moves. */
static void a_crowd_that_tumbles_does_not_sink(void)
{
	enum { SIDE = 26, CROWD = SIDE * SIDE, STEPS = 240, FIRST = 120 };
	cn_world *world = fixture_world(-30.0f, 0);
	cn_body bodies[CROWD], drum = fixture_body(world, CN_BODY_KINEMATIC, 0.0f, 0.0f, 0.0f);
	cn_shape_def side = fixture_shape_def(drum, 0.6f, 0.0f);
	double sum = 0.0;
	int32_t k;
	for (k = 0; k < 4; ++k) {
		float along = k < 2 ? 0.0f : 1.0f, off = k % 2 ? 5.5f : -5.5f;
		cn_polygon wall;
		cn_shape shape;
		must(cn_polygon_make_box(0.5f + 5.5f * along, 6.0f - 5.5f * along, off * (1.0f - along), off * along, 0.0f, 0.0f, &wall), NULL, "cn_polygon_make_box");
		must(cn_shape_create_polygon(world, &side, &wall, &shape), world, "cn_shape_create_polygon");
	}
	for (k = 0; k < CROWD; ++k)
		bodies[k] = fixture_box(world, CN_BODY_DYNAMIC, 0.36f * (float)(k % SIDE) - 4.5f, 0.36f * (float)(k / SIDE) - 4.8f, 0.0f, 0.17f, 0.17f, 0.6f, 0.0f);
	for (k = 0; k < STEPS; ++k) {
		fixture_set_velocity(world, drum, 0.0f, 0.0f, 0.8f);
		fixture_step(world, 1);
		sum += k >= FIRST ? overlaps(world, bodies, CROWD) / (double)(CROWD * (STEPS - FIRST)) : 0.0;
	}
	CHECK_LE("mean overlap a body", sum, 0.02, "m");
	cn_world_destroy(world);
}

/* A plate that nothing stops presses a crowd against a wall, farther than it can go: how fast bodies leave, as a multiple of the
   plate's speed, in the mean of many crowds. */
static void a_crowd_that_is_crushed_does_not_burst(void)
{
	enum { CROWD = 60, CROWDS = 24 };
	double mean = 0.0;
	int32_t crowd;
	for (crowd = 1; crowd <= CROWDS; ++crowd) {
		cn_world *world = fixture_world(-10.0f, 0);
		cn_body bodies[CROWD], plate;
		uint32_t random = (uint32_t)crowd * 2654435761u;
		double most = 0.0;
		int32_t k, step;
		for (k = 0; k < 3; ++k) {
			cn_shape_def wall = fixture_shape_def(fixture_body(world, CN_BODY_STATIC, k < 2 ? (k ? 10.0f : -10.0f) : 0.0f, k < 2 ? 0.0f : -2.0f, 0.0f), 0.5f, 0.0f);
			fixture_box_shape(world, &wall, k < 2 ? 2.0f : 12.0f, k < 2 ? 40.0f : 2.0f);
		}
		plate = fixture_box(world, CN_BODY_KINEMATIC, -4.0f, 2.0f, 0.0f, 2.0f, 2.0f, 0.5f, 0.0f);
		for (k = 0; k < CROWD; ++k) {
			float size = fixture_random(&random, 0.2f, 0.45f), x = fixture_random(&random, -0.2f, 0.2f) + (float)(k % 10) - 1.7f;
			bodies[k] = k % 2 ? fixture_circle(world, CN_BODY_DYNAMIC, x, 0.5f + (float)(k / 10), size, 0.5f, 0.0f)
			                  : fixture_box(world, CN_BODY_DYNAMIC, x, 0.5f + (float)(k / 10), 0.3f * (float)k, size, size, 0.5f, 0.0f);
		}
		for (step = 0; step < 150; ++step) {
			fixture_set_velocity(world, plate, step < 90 ? 6.0f : -6.0f, 0.0f, 0.0f);
			fixture_step(world, 1);
			for (k = 0; k < CROWD; ++k) {
				cn_velocity v = fixture_velocity(world, bodies[k]);
				most = fmax(most, hypot((double)v.linear_mps.x, (double)v.linear_mps.y) / 6.0);
			}
		}
		mean += most / (double)CROWDS;
		cn_world_destroy(world);
	}
	CHECK_LE("greatest speed / the plate's, mean", mean, 3.5, "");
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(flight_is_a_parabola);
	RUN(spin_keeps_its_angle);
	RUN(box_sticks_below_the_critical_angle);
	RUN(box_slides_above_the_critical_angle);
	RUN(sliding_box_stops_where_it_should);
	RUN(static_and_dynamic_friction_differ);
	RUN(drops_return_to_their_height);
	RUN(what_lies_bounces_when_struck);
	RUN(a_wave_passes_through_touching_balls);
	RUN(cluster_keeps_momentum_and_gains_no_energy);
	RUN(stacks_of_boxes_stand_60_s);
	RUN(pyramid_of_20_keeps_its_place);
	RUN(dominoes_topple_in_order);
	RUN(stack_stands_far_from_the_origin);
	RUN(speed_limits_hold_in_every_step);
	RUN(fast_rough_bodies_gain_no_energy);
	RUN(a_crowd_that_is_struck_is_held_apart);
	RUN(a_crowd_that_tumbles_does_not_sink);
	RUN(a_crowd_that_is_crushed_does_not_burst);
	return test_end();
}
