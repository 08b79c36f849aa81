/*
 * test/world/continuous_test.c - fast bodies stop at what they would pass through, and at nothing else.
 *
 * Shares of bodies that passed are measured over random starts, directions and spins. Every kind of run has a
 * control in which passing is allowed: it shows that the measure sees what passes.
 *
 * If a test here fails, look first in: narrowphase/narrowphase.c (contacts ahead), narrowphase/continuous.c (the last
 * guard), collision/toi.c.
 */
#include "fixture.h"

enum { MOVER_CIRCLE, MOVER_BOX, MOVER_CAPSULE, MOVER_POLYGON, MOVER_ROD, MOVER_KINDS };
enum { WALL_EDGE, WALL_CHAIN, WALL_BOX, WALL_SENSOR, WALL_KINDS };
static const char *const mover_names[] = { "circle", "box", "capsule", "polygon", "rod" };
static const char *const wall_names[] = { "edge", "chain", "1 cm box", "sensor (control)" };
static const float speeds_mps[] = { 10.0f, 30.0f, 60.0f, 120.0f, 240.0f, 400.0f };
#define SPEEDS (sizeof speeds_mps / sizeof *speeds_mps)
#define STARTS TEST_FORM(200, 70, 20)

/* Adds a shape of about 0.2 m, the rod 2 m long and 4 cm thick. */
static void mover_shape(cn_world *world, const cn_shape_def *def, int32_t kind)
{
	static const cn_circle circle = { { 0.0f, 0.0f }, 0.1f };
	static const cn_capsule capsule = { { -0.15f, 0.0f }, { 0.15f, 0.0f }, 0.06f };
	static const cn_polygon polygon = { 5, 0.0f, { { 0.15f, 0.0f }, { 0.05f, 0.14f }, { -0.12f, 0.09f }, { -0.12f, -0.09f }, { 0.05f, -0.14f } } };
	cn_result result;
	switch (kind) {
	case MOVER_CIRCLE: result = cn_shape_create_circle(world, def, &circle, NULL); break;
	case MOVER_BOX: result = cn_shape_create_box(world, def, 0.1f, 0.1f, 0.0f, NULL); break;
	case MOVER_CAPSULE: result = cn_shape_create_capsule(world, def, &capsule, NULL); break;
	case MOVER_POLYGON: result = cn_shape_create_polygon(world, def, &polygon, NULL); break;
	default: result = cn_shape_create_box(world, def, 1.0f, 0.02f, 0.0f, NULL); break;
	}
	must(result, world, "mover_shape");
}

/* Farthest point of the mover from its centre. */
static float mover_extent(int32_t kind)
{
	return kind == MOVER_ROD ? 1.01f : kind == MOVER_CAPSULE ? 0.21f : 0.16f;
}

/* A wall along x = 0; its front is the side of negative x. */
static void wall_make(cn_world *world, int32_t kind)
{
	cn_shape_def def = fixture_shape_def(fixture_body(world, CN_BODY_STATIC, 0.0f, 0.0f, 0.0f), 0.6f, 0.0f);
	cn_edge edge = { { 0.0f, 500.0f }, { 0.0f, -500.0f } };
	cn_vec2 points[101];
	cn_chain chain;
	int32_t k;
	if (kind == WALL_SENSOR)
		def.flags |= CN_SHAPE_SENSOR;
	if (kind == WALL_EDGE) {
		must(cn_shape_create_edge(world, &def, &edge, NULL), world, "edge");
	} else if (kind == WALL_CHAIN) {
		for (k = 0; k <= 100; ++k) {
			points[k].x = 0.0f;
			points[k].y = 500.0f - 10.0f * (float)k;
		}
		chain.points_m = points;
		chain.count = 101;
		chain.loop = 0;
		must(cn_shape_create_chain(world, &def, &chain, NULL), world, "chain");
	} else {
		fixture_box_shape(world, &def, 0.005f, 500.0f);
	}
}

enum { LAUNCH_DEFINED, LAUNCH_CREATED_LATE, LAUNCH_IMPULSE };

/* A body that flies towards the wall within 60 degrees of its normal. Movers do not meet each other. */
static cn_body mover_make(cn_world *world, int32_t kind, float speed, float spin_max, int32_t launch, uint32_t *random)
{
	float angle = fixture_random(random, -1.0472f, 1.0472f), ahead = speed * FRAME_S * 1.5f;
	float gap = fixture_random(random, 0.02f, ahead > 1.0f ? ahead : 1.0f);
	float vx = speed * (float)cos((double)angle), vy = speed * (float)sin((double)angle);
	float spin = fixture_random(random, -spin_max, spin_max), y = fixture_random(random, -50.0f, 50.0f), turn = fixture_random(random, -3.0f, 3.0f);
	cn_body body = fixture_body(world, CN_BODY_DYNAMIC, -mover_extent(kind) - gap, y, turn);
	cn_shape_def def = fixture_shape_def(body, 0.6f, 0.0f);
	cn_mass_data mass;
	def.filter.group = -1;
	mover_shape(world, &def, kind);
	if (launch != LAUNCH_IMPULSE) {
		fixture_set_velocity(world, body, vx, vy, spin);
		return body;
	}
	must(cn_body_get_mass_data(world, body, &mass), world, "mass");
	must(cn_body_apply_impulse(world, body, mass.mass_kg * vx, mass.mass_kg * vy), world, "impulse");
	must(cn_body_apply_angular_impulse(world, body, mass.inertia_kgm2 * spin), world, "impulse");
	return body;
}

typedef struct run {
	int32_t passed;
	int32_t met;    /* lost speed at the wall */
} run;

static run fly(int32_t mover, int32_t wall, float speed, float spin, int32_t launch, uint32_t *random)
{
	cn_world *world = fixture_world(0.0f, 1);
	cn_body bodies[STARTS];
	int32_t through[STARTS] = { 0 }, k, step;
	run r = { 0, 0 };
	wall_make(world, wall);
	if (launch != LAUNCH_DEFINED)
		fixture_step(world, 3);
	for (k = 0; k < STARTS; ++k)
		bodies[k] = mover_make(world, mover, speed, spin, launch, random);
	for (step = 0; step < 30; ++step) {
		fixture_step(world, 1);
		for (k = 0; k < STARTS; ++k)
			through[k] |= fixture_pose(world, bodies[k]).position_m.x > 0.0f;
	}
	for (k = 0; k < STARTS; ++k) {
		r.passed += through[k];
		r.met += fixture_velocity(world, bodies[k]).linear_mps.x < 0.25f * speed;
	}
	CHECK(fixture_is_valid(world));
	cn_world_destroy(world);
	return r;
}

static void walls_hold(int32_t wall, float spin, int32_t launch)
{
	uint32_t random = 2463534242u;
	int32_t mover, all = 0, met = 0, runs = 0;
	size_t s;
	for (mover = 0; mover < MOVER_KINDS; ++mover)
		for (s = 0; s < SPEEDS; ++s) {
			run r = fly(mover, wall, speeds_mps[s], spin, launch, &random);
			if (r.passed > 0 && wall != WALL_SENSOR)
				printf("  %s, %s at %g m/s, spin %g: %d of %d passed\n", wall_names[wall], mover_names[mover], (double)speeds_mps[s], (double)spin, (int)r.passed, STARTS);
			all += r.passed;
			met += r.met;
			runs += STARTS;
		}
	if (wall == WALL_SENSOR) {
		CHECK_GE("share that passed a wall that is a sensor", (double)all / runs, 0.97, "");
		return;
	}
	printf("  %s, spin up to %g rad/s, %d starts\n", wall_names[wall], (double)spin, (int)runs);
	CHECK_LE("share that passed", (double)all / runs, 0.0, "");
	CHECK_GE("share that met the wall", (double)met / runs, 0.9, "");
}

static void nothing_passes_an_edge(void) { walls_hold(WALL_EDGE, 0.0f, LAUNCH_DEFINED); walls_hold(WALL_EDGE, 100.0f, LAUNCH_DEFINED); }
static void nothing_passes_a_chain(void) { walls_hold(WALL_CHAIN, 0.0f, LAUNCH_DEFINED); walls_hold(WALL_CHAIN, 100.0f, LAUNCH_DEFINED); }
static void nothing_passes_a_thin_box(void) { walls_hold(WALL_BOX, 0.0f, LAUNCH_DEFINED); walls_hold(WALL_BOX, 100.0f, LAUNCH_DEFINED); }
static void control_passes(void) { walls_hold(WALL_SENSOR, 100.0f, LAUNCH_DEFINED); }
static void newly_created_bodies_do_not_pass(void) { walls_hold(WALL_EDGE, 50.0f, LAUNCH_CREATED_LATE); walls_hold(WALL_BOX, 50.0f, LAUNCH_CREATED_LATE); }
static void bodies_given_an_impulse_do_not_pass(void) { walls_hold(WALL_EDGE, 50.0f, LAUNCH_IMPULSE); walls_hold(WALL_CHAIN, 50.0f, LAUNCH_IMPULSE); }

/* ---- bullets and dynamic walls ---- */

#define PAIRS TEST_FORM(50, 30, 10)

/* Each mover with a wall of its own, 1 cm thick and 40 m high, all at one place: filters keep the pairs apart. */
static double share_through_dynamic_walls(int32_t mover, float speed, float wall_density, uint32_t flags, uint32_t *random)
{
	cn_world *world = fixture_world(0.0f, 0);
	cn_body movers[PAIRS], walls[PAIRS];
	float before[PAIRS];
	int32_t through[PAIRS] = { 0 }, k, step, passed = 0;
	for (k = 0; k < PAIRS; ++k) {
		float gap = fixture_random(random, 0.02f, 8.0f), y = fixture_random(random, -0.8f, 0.8f), turn = fixture_random(random, -3.0f, 3.0f);
		cn_shape_def def = fixture_shape_def(walls[k] = fixture_body(world, CN_BODY_DYNAMIC, 0.0f, 0.0f, 0.0f), 0.6f, 0.0f);
		def.density_kgpm2 = wall_density;
		def.filter.category = def.filter.mask = (uint64_t)1 << k;
		fixture_box_shape(world, &def, 0.005f, 20.0f);
		movers[k] = fixture_body(world, CN_BODY_DYNAMIC, -mover_extent(mover) - gap, y, turn);
		def.body = movers[k];
		def.density_kgpm2 = 1.0f;
		mover_shape(world, &def, mover);
		must(cn_body_set_flags(world, movers[k], CN_BODY_ENABLED | CN_BODY_SLEEP | flags), world, "flags");
		fixture_set_velocity(world, movers[k], speed, 0.0f, fixture_random(random, -20.0f, 20.0f));
		before[k] = -1.0f;
	}
	for (step = 0; step < 60; ++step) {
		fixture_step(world, 1);
		for (k = 0; k < PAIRS; ++k) {
			cn_pose m = fixture_pose(world, movers[k]);
			cn_vec2 local;
			must(cn_body_get_local_point(world, walls[k], m.position_m.x, m.position_m.y, &local), world, "local point");
			through[k] |= before[k] < 0.0f && local.x > 0.0f && fabsf(local.y) < 13.0f; /* at most 7 m a step: not round the end */
			before[k] = local.x;
		}
	}
	for (k = 0; k < PAIRS; ++k)
		passed += through[k];
	cn_world_destroy(world);
	return (double)passed / PAIRS;
}

static void bullets_do_not_pass_dynamic_walls(void)
{
	static const float densities[] = { 0.1f, 1000.0f }; /* a wall as heavy as a mover, and 10000 times that */
	uint32_t random = 88675123u;
	double with = 0.0, without = 0.0;
	int32_t mover, runs = 0;
	size_t s, d;
	for (mover = 0; mover < MOVER_KINDS; ++mover)
		for (s = 0; s < SPEEDS; ++s)
			for (d = 0; d < 2; ++d) {
				double share = share_through_dynamic_walls(mover, speeds_mps[s], densities[d], CN_BODY_BULLET, &random);
				if (share > 0.0)
					printf("  %s at %g m/s, wall density %g: share %.3f\n", mover_names[mover], (double)speeds_mps[s], (double)densities[d], share);
				with += share;
				if (TEST_FORM(1, 0, 0))
					without += share_through_dynamic_walls(mover, speeds_mps[s], densities[d], 0u, &random);
				++runs;
			}
	if (TEST_FORM(1, 0, 0))
		printf("  share of bodies without the flag that passed: %.4f (not promised)\n", without / runs);
	CHECK_LE("share of bullets that passed", with / runs, 0.0, "");
}

/* ---- hit within the step ---- */

/* A light ball next to a wall is jumped by a heavy fast one: neither may pass. */
static void struck_body_does_not_pass_the_wall(void)
{
	int32_t wall, k, step, passed[2] = { 0, 0 }, jumped = 0, runs = 0;
	uint32_t random = 521288629u;
	size_t s;
	for (wall = WALL_EDGE; wall <= WALL_BOX; ++wall)
		for (s = 0; s < SPEEDS; ++s)
			for (k = 0; k < TEST_FORM(50, 16, 5); ++k) {
				cn_world *world = fixture_world(0.0f, 1);
				cn_body light, heavy;
				cn_shape_def def;
				cn_circle circle = { { 0.0f, 0.0f }, 0.3f };
				int32_t through[2] = { 0, 0 };
				float x;
				wall_make(world, wall);
				light = fixture_circle(world, CN_BODY_DYNAMIC, -0.106f - fixture_random(&random, 0.0f, 0.5f), 0.0f, 0.1f, 0.6f, 0.0f);
				x = -1.1f - fixture_random(&random, 0.0f, 6.0f);
				heavy = fixture_body(world, CN_BODY_DYNAMIC, x, fixture_random(&random, -0.1f, 0.1f), 0.0f);
				def = fixture_shape_def(heavy, 0.6f, 0.0f);
				def.density_kgpm2 = 100.0f;
				must(cn_shape_create_circle(world, &def, &circle, NULL), world, "circle");
				fixture_set_velocity(world, heavy, speeds_mps[s], 0.0f, 0.0f);
				for (step = 0; step < 60; ++step) {
					fixture_step(world, 1);
					through[0] |= fixture_pose(world, light).position_m.x > 0.0f;
					through[1] |= fixture_pose(world, heavy).position_m.x > 0.0f;
				}
				jumped += fabsf(fixture_velocity(world, light).linear_mps.y) > 0.0f || fixture_pose(world, light).position_m.x > -0.15f;
				passed[0] += through[0];
				passed[1] += through[1];
				++runs;
				cn_world_destroy(world);
			}
	CHECK_GE("share of light balls that were jumped", (double)jumped / runs, 0.9, "");
	CHECK_LE("share of light balls that passed", (double)passed[0] / runs, 0.0, "");
	CHECK_LE("share of heavy balls that passed", (double)passed[1] / runs, 0.0, "");
}

/* ---- ghosts ---- */

/* Passes the corner of a big box (the quadrant x < 0, y < 0) along the direction angle, gap away from it. */
static double deflection(int32_t mover, float speed, float angle, float gap, float phase)
{
	cn_world *world = fixture_world(0.0f, 0);
	float dx = (float)cos((double)angle), dy = (float)sin((double)angle);
	float half = mover == MOVER_CIRCLE || mover == MOVER_BOX ? 0.1f : mover == MOVER_CAPSULE ? 0.06f : 0.02f; /* across the path */
	float off = half + gap, back = phase * speed * FRAME_S + 1.1f, x, y;
	double change, turn;
	cn_body body;
	cn_shape_def def;
	cn_velocity v;
	cn_vec2 b;
	fixture_box(world, CN_BODY_STATIC, -50.0f, -50.0f, 0.0f, 50.0f, 50.0f, 0.6f, 0.5f);
	x = -dy * off - back * dx; /* to the left of the path is the open side */
	y = dx * off - back * dy;
	body = fixture_body(world, CN_BODY_DYNAMIC, x, y, angle);
	def = fixture_shape_def(body, 0.6f, 0.5f);
	mover_shape(world, &def, mover);
	fixture_set_velocity(world, body, speed * dx, speed * dy, 0.0f);
	fixture_step(world, 30);
	v = fixture_velocity(world, body);
	b = fixture_pose(world, body).position_m;
	change = sqrt(pow((double)v.linear_mps.x - (double)(speed * dx), 2) + pow((double)v.linear_mps.y - (double)(speed * dy), 2)) / (double)speed;
	turn = fabs((double)v.angular_radps);
	x += 0.5f * speed * dx;
	y += 0.5f * speed * dy;
	change = greater(change, greater(turn, sqrt(pow((double)b.x - (double)x, 2) + pow((double)b.y - (double)y, 2)) / (0.5 * (double)speed)));
	cn_world_destroy(world);
	return change;
}

static void near_miss_is_not_deflected(void)
{
	static const float gaps[] = { 0.0075f, 0.02f, 0.1f };
	/* across the corner downwards, and along its top */
	static const float angles[] = { -0.7854f, -0.3f, -1.2f, -0.05f };
	static const int32_t movers[] = { MOVER_CIRCLE, MOVER_BOX, MOVER_CAPSULE, MOVER_ROD };
	double worst = 0.0;
	size_t m, s, a, g;
	int32_t phase;
	for (m = 0; m < 4; ++m)
		for (s = 0; s < SPEEDS; ++s)
			for (a = 0; a < 4; ++a)
				for (g = 0; g < 3; ++g)
					for (phase = 0; phase < 8; ++phase) {
						double d = deflection(movers[m], speeds_mps[s], angles[a], gaps[g], (float)phase / 8.0f);
						if (d > 1e-5 && d > worst)
							printf("  %s at %g m/s, direction %g, gap %g, phase %d/8: %.3g\n", mover_names[movers[m]], (double)speeds_mps[s], (double)angles[a], (double)gaps[g], (int)phase, d);
						worst = d > worst ? d : worst;
					}
	CHECK_LE("relative change of velocity and path, 2304 near misses", worst, 1e-5, "");
	CHECK_GE("change at a hit 5 cm deep (control)", deflection(MOVER_CIRCLE, 60.0f, -0.7854f, -0.05f, 0.5f), 0.05, "");
}

/* ---- rotation ---- */

/* A rod turning about its pinned centre meets a post: seen from the rod, the post never changes sides. */
static int32_t rod_passes_post(float spin, int32_t pinned, float post_angle, uint32_t post_flags)
{
	cn_world *world = fixture_world(0.0f, 0);
	cn_body rod = fixture_body(world, CN_BODY_DYNAMIC, 0.0f, 0.0f, 0.0f), post;
	cn_shape_def def = fixture_shape_def(rod, 0.6f, 0.0f);
	cn_vec2 at, before, local;
	cn_circle circle = { { 0.0f, 0.0f }, 0.05f };
	int32_t step, passed = 0;
	mover_shape(world, &def, MOVER_ROD);
	at.x = 0.8f * (float)cos((double)post_angle);
	at.y = 0.8f * (float)sin((double)post_angle);
	post = fixture_body(world, CN_BODY_STATIC, at.x, at.y, 0.0f);
	def.body = post;
	def.flags = post_flags;
	must(cn_shape_create_circle(world, &def, &circle, NULL), world, "post");
	if (pinned) {
		cn_revolute_def pin;
		cn_joint joint;
		cn_revolute_def_init(&pin);
		pin.base.body_b = rod;
		must(cn_joint_create_revolute(world, &pin, &joint), world, "pin");
	}
	fixture_set_velocity(world, rod, 0.0f, 0.0f, spin);
	must(cn_body_get_local_point(world, rod, at.x, at.y, &before), world, "local point");
	for (step = 0; step < 60; ++step) {
		fixture_step(world, 1);
		must(cn_body_get_local_point(world, rod, at.x, at.y, &local), world, "local point");
		if (local.y * before.y < 0.0f && local.x * local.x + local.y * local.y < 0.98f && before.x * before.x + before.y * before.y < 0.98f)
			passed = 1;
		before = local;
	}
	cn_world_destroy(world);
	return passed;
}

static void turning_rod_does_not_pass_a_post(void)
{
	static const float spins[] = { 10.0f, 30.0f, 60.0f, 100.0f };
	uint32_t random = 362436069u;
	int32_t k, passed[3] = { 0, 0, 0 }, runs = 0;
	size_t s;
	for (s = 0; s < 4; ++s)
		for (k = 0; k < TEST_MANY(100); ++k) {
			float angle = fixture_random(&random, 0.12f, 3.02f), sign = k & 1 ? -1.0f : 1.0f;
			passed[0] += rod_passes_post(sign * spins[s], 0, angle, 0u);
			passed[1] += rod_passes_post(sign * spins[s], 1, angle, 0u);
			passed[2] += rod_passes_post(sign * spins[s], 1, angle, CN_SHAPE_SENSOR);
			++runs;
		}
	CHECK_LE("share of free rods that passed", (double)passed[0] / runs, 0.0, "");
	CHECK_LE("share of pinned rods that passed", (double)passed[1] / runs, 0.0, "");
	CHECK_GE("share of rods that passed a sensor (control)", (double)passed[2] / runs, 0.95, "");
}

/* ---- what is held does not hang ---- */

/*
 * A thin plate that stands almost upright, its upper corner so far in a wall that its core is at it. It goes into the
 * wall and turns the corner out of it: nothing closes, so its contact has nothing to do.
 */
static cn_body plate_at_wall(cn_world *world, float spin, float gap, uint32_t locks)
{
	const float half = 0.5f, thin = 0.004f, angle = 1.4f, core = 0.5f * thin;
	float reach = (half - core) * cosf(angle) + (thin - core) * sinf(angle);
	cn_shape_def wall = fixture_shape_def(fixture_body(world, CN_BODY_STATIC, 1.0f, 0.0f, 0.0f), 0.0f, 0.0f);
	cn_body plate;
	uint32_t flags;
	fixture_box_shape(world, &wall, 1.0f, 50.0f);
	plate = fixture_box(world, CN_BODY_DYNAMIC, -reach - gap, 0.0f, angle, half, thin, 0.0f, 0.0f);
	must(cn_body_get_flags(world, plate, &flags), world, "flags");
	must(cn_body_set_flags(world, plate, flags | locks), world, "flags");
	fixture_set_velocity(world, plate, locks ? 0.0f : 0.4f * spin, -5.0f, spin);
	return plate;
}

/* Kinetic, and potential under 10 m/s^2, of a unit of mass. */
static double energy_per_mass(const cn_world *world, cn_body body)
{
	cn_velocity v = fixture_velocity(world, body);
	cn_mass_data m;
	must(cn_body_get_mass_data(world, body, &m), world, "mass");
	return 0.5 * (double)(v.linear_mps.x * v.linear_mps.x + v.linear_mps.y * v.linear_mps.y) +
	       0.5 * (double)(m.inertia_kgm2 / m.mass_kg * v.angular_radps * v.angular_radps) + 10.0 * (double)fixture_pose(world, body).position_m.y;
}

static void what_turns_out_of_a_wall_falls_on(void)
{
	static const float spins[] = { 3.0f, 4.0f, 6.0f, 10.0f }, gaps[] = { 1e-5f, 2e-5f, 1e-4f, 1e-3f };
	double least = (double)INFINITY, gain = -(double)INFINITY, strays = 0.0, x, y, before;
	size_t i;
	for (i = 0; i < 16; ++i) {
		cn_world *world = fixture_world(-10.0f, 0), *second = fixture_world(-10.0f, 0);
		cn_body plate = plate_at_wall(world, spins[i / 4], gaps[i % 4], 0), locked = plate_at_wall(second, spins[i / 4], gaps[i % 4], CN_BODY_LOCK_X);
		before = energy_per_mass(world, plate);
		fixture_step(world, 30);
		y = (double)fixture_pose(world, plate).position_m.y;
		least = fmin(least, -y);
		gain = fmax(gain, energy_per_mass(world, plate) - before);
		x = (double)fixture_pose(second, locked).position_m.x;
		fixture_step(second, 30);
		strays = fmax(strays, fabs((double)fixture_pose(second, locked).position_m.x - x));
		cn_world_destroy(world);
		cn_world_destroy(second);
	}
	CHECK_GE("least fall in half a second, 3.75 when free", least, 3.0, "m");
	CHECK_LE("energy gained / mass", gain, 0.05, "J/kg");
	CHECK_LE("way along a locked axis", strays, 0.0, "m");
}

/* ---- pairs that do not collide ---- */

static int32_t refuse(cn_world *world, const cn_contact_event *contact, void *user)
{
	(void)world;
	(void)contact;
	(void)user;
	return 0;
}

/* Movers with these flags, one-way ones with their upper side away from the wall: how many lose speed or stay in front of the wall? */
static int32_t held_by_wall(int32_t mover, int32_t wall, float speed, uint32_t flags, uint32_t *random)
{
	cn_world *world = fixture_world(0.0f, 1);
	cn_body bodies[STARTS];
	int32_t held = 0, k;
	wall_make(world, wall);
	must(cn_world_set_pre_solve_callback(world, refuse, NULL), world, "callback");
	for (k = 0; k < STARTS; ++k) {
		bodies[k] = mover_make(world, mover, speed, 0.0f, LAUNCH_DEFINED, random);
		must(cn_shape_set_flags(world, fixture_first_shape(world, bodies[k]), flags), world, "flags");
		if (flags & CN_SHAPE_ONE_WAY)
			must(cn_body_set_pose(world, bodies[k], -0.5f - (float)k / (float)STARTS, (float)(k % 50), 1.5707963f), world, "pose");
	}
	fixture_step(world, 40);
	for (k = 0; k < STARTS; ++k) {
		cn_vec2 v = fixture_velocity(world, bodies[k]).linear_mps;
		held += fixture_pose(world, bodies[k]).position_m.x < 0.5f || fabs(hypot((double)v.x, (double)v.y) - (double)speed) > SOLVED * (double)speed;
	}
	cn_world_destroy(world);
	return held;
}

static void pairs_that_do_not_collide_pass(void)
{
	static const uint32_t flags[] = { CN_SHAPE_PRE_SOLVE, CN_SHAPE_ONE_WAY };
	static const char *const names[] = { "pre-solve returns 0", "one-way, from below" };
	uint32_t random = 29;
	int32_t f, wall, mover;
	size_t s;
	for (f = 0; f < 2; ++f) {
		int32_t held = 0, flown = 0;
		for (wall = WALL_EDGE; wall <= WALL_BOX; ++wall)
			for (mover = 0; mover < MOVER_ROD; ++mover)
				for (s = 0; s < SPEEDS; ++s) {
					held += held_by_wall(mover, wall, speeds_mps[s], flags[f], &random);
					flown += STARTS;
				}
		printf("  %s: %d of %d held by the wall\n", names[f], held, flown);
		CHECK(held == 0);
	}
}

/* ---- what is slow is left alone ---- */

static uint64_t resting_scene_hash(int32_t continuous)
{
	cn_world *world = fixture_world(-10.0f, 0);
	uint32_t flags;
	uint64_t hash;
	int32_t row, k;
	must(cn_world_get_flags(world, &flags), world, "flags");
	flags = continuous ? flags | CN_WORLD_CONTINUOUS : flags & ~(uint32_t)CN_WORLD_CONTINUOUS;
	must(cn_world_set_flags(world, flags), world, "flags");
	fixture_floor(world, 0.6f, 0.0f);
	for (row = 0; row < 20; ++row)
		for (k = 0; k < 20 - row; ++k)
			fixture_box(world, CN_BODY_DYNAMIC, (float)k - 0.5f * (float)(19 - row), 0.45f + 0.9f * (float)row, 0.0f, 0.45f, 0.45f, 0.6f, 0.0f);
	for (k = 0; k < 60; ++k)
		fixture_circle(world, CN_BODY_DYNAMIC, 20.0f + 0.7f * (float)(k % 20), 0.3f + 0.6f * (float)(k / 20), 0.3f, 0.6f, 0.0f);
	fixture_step(world, 120);
	hash = fixture_hash(world);
	cn_world_destroy(world);
	return hash;
}

/* Speed, after one step, of a ball that is shot at 300 m/s at a dynamic board 2 m away: no contact exists unless the ball's box covers its
   way. Before that, the user sets the velocity of other balls `calls` times, or creates and destroys as many moving ones. */
static float speed_after_board(int32_t calls, int32_t destroy)
{
	cn_world *world = fixture_world(0.0f, 1);
	cn_body ball[3];
	float speed;
	int32_t k;
	for (k = 0; k < 3; ++k)
		ball[k] = fixture_circle(world, CN_BODY_DYNAMIC, 0.0f, 5.0f * (float)k, 0.1f, 0.0f, 0.0f);
	fixture_box(world, CN_BODY_DYNAMIC, 2.0f, 10.0f, 0.0f, 0.05f, 2.0f, 0.0f, 0.0f);
	fixture_step(world, 3);
	for (k = 0; k < calls; ++k) {
		cn_body other = destroy ? fixture_circle(world, CN_BODY_DYNAMIC, 0.0f, -9.0f, 0.1f, 0.0f, 0.0f) : ball[k % 2];
		must(cn_body_set_velocity(world, other, 0.1f * (float)(k + 1), 0.0f, 0.0f), world, "cn_body_set_velocity");
		if (destroy)
			must(cn_body_destroy(world, other), world, "cn_body_destroy");
	}
	must(cn_body_set_velocity(world, ball[2], 300.0f, 0.0f, 0.0f), world, "cn_body_set_velocity");
	CHECK(fixture_is_valid(world));
	fixture_step(world, 1);
	CHECK(fixture_is_valid(world));
	speed = fixture_velocity(world, ball[2]).linear_mps.x;
	cn_world_destroy(world);
	return speed;
}

static void other_calls_do_not_let_a_body_pass(void)
{
	static const int32_t calls[] = { 0, 8, 9, 16, 300 };
	float fastest = 0.0f;
	int32_t k;
	for (k = 0; k < 10; ++k)
		fastest = fmaxf(fastest, speed_after_board(calls[k % 5], k >= 5));
	CHECK_LE("fastest ball behind the board", (double)fastest, 30.0, "m/s");
}

static void resting_scene_is_the_same_without(void)
{
	uint64_t on = resting_scene_hash(1), off = resting_scene_hash(0);
	printf("  %016llx on, %016llx off\n", (unsigned long long)on, (unsigned long long)off);
	CHECK(on == off);
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(control_passes);
	RUN(nothing_passes_an_edge);
	RUN(nothing_passes_a_chain);
	RUN(nothing_passes_a_thin_box);
	RUN(newly_created_bodies_do_not_pass);
	RUN(bodies_given_an_impulse_do_not_pass);
	RUN(bullets_do_not_pass_dynamic_walls);
	RUN(struck_body_does_not_pass_the_wall);
	RUN(near_miss_is_not_deflected);
	RUN(turning_rod_does_not_pass_a_post);
	RUN(what_turns_out_of_a_wall_falls_on);
	RUN(pairs_that_do_not_collide_pass);
	RUN(other_calls_do_not_let_a_body_pass);
	RUN(resting_scene_is_the_same_without);
	return test_end();
}
