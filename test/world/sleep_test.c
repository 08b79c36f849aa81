/*
 * test/world/sleep_test.c - who falls asleep, when and with whom; what sleeps does not change. What wakes them is in wake_test.c.
 *
 * If a test here fails, look first in: step/finalize.c (what counts as rest), step/sleep.c (decisions),
 * model/island_sleep.c (moving between awake and asleep), model/island.c (splitting), world/body_state.c.
 */
#include "sleep.h"

/* ---- falling asleep ---- */

static void box_at_rest_sleeps_after_the_delay(void)
{
	static const float delays[] = { 0.0f, 0.25f, 0.5f, 2.0f };
	size_t d;
	for (d = 0; d < 4; ++d) {
		cn_world *world = fixture_world(-10.0f, 1);
		cn_body box;
		int32_t steps;
		fixture_floor(world, 0.6f, 0.0f);
		must(cn_world_set_sleep(world, 0.05f, delays[d]), world, "cn_world_set_sleep");
		box = unit_box(world, 0.0f, 0.5f);
		steps = steps_to_sleep(world, box, 300);
		CHECK_GE("time to sleep - delay", (double)steps / 60.0 - (double)delays[d], -1e-6, "s");
		CHECK_LE("time to sleep - delay", (double)steps / 60.0 - (double)delays[d], 0.1, "s");
		CHECK(fell_asleep_count(world, box) == 1 && fell_asleep_count(world, 0) == 1);
		CHECK(fixture_velocity(world, box).linear_mps.y == 0.0f);
		fixture_step(world, 1);
		CHECK(fell_asleep_count(world, 0) == 0);
		cn_world_destroy(world);
	}
}

static void island_sleeps_as_one(void)
{
	cn_world *world = fixture_world(-10.0f, 1);
	cn_body bodies[55];
	int32_t n = 0, i, j, k, asleep, partly = 0, all_at = 0;
	fixture_floor(world, 0.6f, 0.0f);
	for (i = 0; i < 10; ++i)
		for (j = i; j < 10; ++j, ++n)
			bodies[n] = unit_box(world, 0.5f * (float)(i + 1) + (float)(j - i) - 5.0f, (float)i + 0.55f);
	for (k = 1; k <= 600 && all_at == 0; ++k) {
		fixture_step(world, 1);
		for (i = 0, asleep = 0; i < n; ++i)
			asleep += !fixture_is_awake(world, bodies[i]);
		partly += asleep > 0 && asleep < n;
		all_at = asleep == n ? k : 0;
	}
	printf("  a pyramid of 55 slept after %.2f s\n", (double)all_at / 60.0);
	CHECK_LE("steps in which only a part slept", partly, 0, "");
	CHECK_GE("step of sleep", all_at, 1, "");
	CHECK_LE("time to sleep", (double)all_at / 60.0, 5.0, "s");
	CHECK(fell_asleep_count(world, 0) == n);
	CHECK(fixture_counters(world).islands == 1 && fixture_counters(world).islands_awake == 0);
	CHECK(fixture_is_valid(world));
	cn_world_destroy(world);
}

static void box_rests_and_sleeps_under_weak_gravity(void)
{
	static const float gravities[] = { 10.0f, 0.1f, 0.01f };
	size_t g;
	for (g = 0; g < 3; ++g) {
		cn_world *world = fixture_world(-gravities[g], 1);
		cn_body box, top;
		fixture_floor(world, 0.6f, 0.0f);
		box = unit_box(world, 0.0f, 0.5f);
		top = unit_box(world, 0.2f, 1.5f);
		printf("  gravity %.2f m/s^2\n", (double)gravities[g]);
		CHECK_LE("time to sleep", (double)steps_to_sleep(world, box, 1200) / 60.0, 2.0, "s");
		CHECK(!fixture_is_awake(world, box) && !fixture_is_awake(world, top));
		cn_world_destroy(world);
	}
}

/* ---- not falling asleep ---- */

enum { THROW_ONE, THROW_TOUCHING, THROW_ROD, THROW_HINGE, THROWS };
static const char *const throw_names[] = { "a box", "two touching boxes", "two boxes on a rod", "two hinged boxes" };

static cn_body throw_up(cn_world *world, int32_t what, float speed)
{
	cn_body a = unit_box(world, 0.0f, 0.0f), b;
	cn_distance_def rod;
	cn_revolute_def hinge;
	cn_joint joint;
	fixture_set_velocity(world, a, 0.0f, speed, 0.0f);
	if (what == THROW_ONE)
		return a;
	b = unit_box(world, what == THROW_ROD ? 2.0f : 1.0f, 0.0f);
	fixture_set_velocity(world, b, 0.0f, speed, 0.0f);
	cn_distance_def_init(&rod);
	cn_revolute_def_init(&hinge);
	rod.base.body_a = hinge.base.body_a = a;
	rod.base.body_b = hinge.base.body_b = b;
	rod.length_m = 2.0f;
	hinge.base.anchor_a_m.x = 0.5f;
	hinge.base.anchor_b_m.x = -0.5f;
	if (what == THROW_ROD)
		must(cn_joint_create_distance(world, &rod, &joint), world, "cn_joint_create_distance");
	if (what == THROW_HINGE)
		must(cn_joint_create_revolute(world, &hinge, &joint), world, "cn_joint_create_revolute");
	return a;
}

/* Steps asleep of 4 s around the apex, which is 2 s after the start. */
static int32_t throw_run(int32_t what, float gravity, float delay, double *worst)
{
	cn_world *world = fixture_world(-gravity, 1);
	cn_body body;
	int32_t k, asleep = 0;
	must(cn_world_set_sleep(world, 0.05f, delay), world, "cn_world_set_sleep");
	fixture_box(world, CN_BODY_STATIC, 50.0f, -1.0f, 0.0f, 5.0f, 1.0f, 0.6f, 0.0f);
	unit_box(world, 50.0f, 0.5f); /* something that rests meanwhile */
	body = throw_up(world, what, 2.0f * gravity);
	for (k = 1; k <= 240; ++k) {
		double t = k / 60.0, y = (double)gravity * (2.0 * t - 0.5 * t * t);
		fixture_step(world, 1);
		asleep += !fixture_is_awake(world, body);
		*worst = greater(*worst, fabs((double)fixture_pose(world, body).position_m.y - y) / (1.0 + 2.0 * (double)gravity));
	}
	cn_world_destroy(world);
	return asleep;
}

static void nothing_sleeps_at_the_apex_of_a_throw(void)
{
	static const float gravities[] = { 10.0f, 0.1f, 0.01f };
	int32_t what, asleep = 0, delayed;
	size_t g;
	double worst[THROWS] = { 0.0, 0.0, 0.0, 0.0 };
	for (what = 0; what < THROWS; ++what)
		for (g = 0; g < 3; ++g)
			for (delayed = 0; delayed < 2; ++delayed) {
				int32_t steps = throw_run(what, gravities[g], delayed ? 0.5f : 0.0f, &worst[what]);
				if (steps > 0)
					printf("  %s, gravity %.2f, delay %.1f: asleep in %d of 240 steps\n", throw_names[what], (double)gravities[g], delayed ? 0.5 : 0.0, (int)steps);
				asleep += steps;
			}
	CHECK_LE("steps asleep in flight", asleep, 0, "");
	CHECK_LE("distance of the free ones from the parabola / (1 m + height)", fmax(worst[THROW_ONE], worst[THROW_TOUCHING]), 2.0 * ROUNDING, "");
	/* What only joints hold moves along its parabola too (direct/rattle.c). */
	CHECK_LE("distance of the jointed ones", fmax(worst[THROW_ROD], worst[THROW_HINGE]), 5.0 * ROUNDING, "");
}

/* A pendulum is at rest for an instant at each end of its swing; so is a ball at the top of a bounce. */
static void nothing_sleeps_at_the_end_of_a_swing(void)
{
	cn_world *world = fixture_world(-10.0f, 1);
	cn_body bob = fixture_circle(world, CN_BODY_DYNAMIC, 2.0f, 0.0f, 0.2f, 0.6f, 0.0f), ball;
	cn_distance_def rod;
	cn_joint joint;
	int32_t k, asleep = 0;
	must(cn_world_set_sleep(world, 0.3f, 0.0f), world, "cn_world_set_sleep");
	cn_distance_def_init(&rod);
	rod.base.body_b = bob;
	rod.length_m = 2.0f;
	must(cn_joint_create_distance(world, &rod, &joint), world, "cn_joint_create_distance");
	fixture_box(world, CN_BODY_STATIC, 10.0f, -1.0f, 0.0f, 5.0f, 1.0f, 0.6f, 0.0f);
	ball = fixture_circle(world, CN_BODY_DYNAMIC, 10.0f, 3.0f, 0.5f, 0.6f, 1.0f);
	for (k = 0; k < 600; ++k) {
		fixture_step(world, 1);
		asleep += !fixture_is_awake(world, bob) || !fixture_is_awake(world, ball);
	}
	CHECK_LE("steps asleep", asleep, 0, "");
	cn_world_destroy(world);
}

/* A ball leaves a box, which then comes to rest against others: what has met since does not wait for what has left. */
static void what_has_left_keeps_nobody_awake(void)
{
	cn_world *world = fixture_world(0.0f, 1);
	cn_body ball = fixture_circle(world, CN_BODY_DYNAMIC, -0.999f, 0.0f, 0.5f, 0.6f, 0.0f), box = unit_box(world, 0.0f, 0.0f), others[3];
	int32_t k;
	for (k = 0; k < 3; ++k)
		others[k] = unit_box(world, 10.0f + 0.999f * (float)k, 0.0f);
	fixture_step(world, 1);
	CHECK(fixture_counters(world).islands_awake == 2);
	must(cn_body_set_pose(world, box, 9.001f, 0.0f, 0.0f), world, "cn_body_set_pose");
	fixture_set_velocity(world, ball, -1.0f, 0.0f, 0.0f);
	fixture_step(world, 1);
	CHECK(fixture_counters(world).islands_awake == 1);
	fixture_step(world, 240);
	CHECK(fixture_is_awake(world, ball) && !fixture_is_awake(world, box));
	for (k = 0; k < 3; ++k)
		CHECK(!fixture_is_awake(world, others[k]));
	CHECK(fixture_is_valid(world));
	cn_world_destroy(world);
}

/* Each waits for its own time, also when something else falls asleep meanwhile. */
static void everybody_waits_for_the_whole_delay(void)
{
	cn_world *world = fixture_world(0.0f, 1);
	cn_body first = unit_box(world, 0.0f, 0.0f), later = unit_box(world, 10.0f, 0.0f);
	int32_t k, at[2] = { 0, 0 };
	must(cn_world_set_sleep(world, 0.05f, 0.5f), world, "cn_world_set_sleep");
	for (k = 1; k <= 60; ++k) {
		fixture_set_velocity(world, later, 0.0f, k <= 12 ? 1.0f : 0.0f, 0.0f);
		fixture_step(world, 1);
		at[0] += fixture_is_awake(world, first);
		at[1] += fixture_is_awake(world, later);
	}
	CHECK_LE("one at rest fell asleep off its delay", abs(at[0] - 30), 1, "steps");
	CHECK_LE("one that came to rest after 12 steps", abs(at[1] - 42), 1, "steps");
	cn_world_destroy(world);
}

/* With no delay, islands that move do not sleep because some other body rests. */
static void moving_islands_do_not_sleep_with_others(void)
{
	cn_world *world = fixture_world(-10.0f, 1);
	cn_body a, b, resting;
	int32_t k, asleep = 0;
	fixture_floor(world, 0.0f, 0.0f);
	must(cn_world_set_sleep(world, 0.05f, 0.0f), world, "cn_world_set_sleep");
	resting = fixture_box(world, CN_BODY_DYNAMIC, -20.0f, 0.5f, 0.0f, 0.5f, 0.5f, 0.0f, 0.0f);
	a = fixture_box(world, CN_BODY_DYNAMIC, 0.0f, 0.5f, 0.0f, 0.5f, 0.5f, 0.0f, 0.0f);
	b = fixture_box(world, CN_BODY_DYNAMIC, 0.0f, 1.5f, 0.0f, 0.5f, 0.5f, 0.0f, 0.0f);
	fixture_set_velocity(world, a, 1.0f, 0.0f, 0.0f);
	fixture_set_velocity(world, b, 1.0f, 0.0f, 0.0f);
	for (k = 0; k < 120; ++k) {
		if (k % 10 == 0)
			must(cn_body_set_awake(world, resting, 1), world, "cn_body_set_awake");
		fixture_step(world, 1);
		asleep += !fixture_is_awake(world, a) || !fixture_is_awake(world, b);
	}
	CHECK_LE("steps asleep of two sliding boxes", asleep, 0, "");
	CHECK_LE("error of the way they slid", fabs((double)fixture_pose(world, b).position_m.x - 2.0), ROUNDING, "m");
	CHECK(!fixture_is_awake(world, resting));
	cn_world_destroy(world);
}

static void damped_bodies_in_zero_gravity_sleep(void)
{
	cn_world *world = fixture_world(0.0f, 1);
	cn_body bodies[3];
	int32_t k;
	bodies[0] = unit_box(world, 0.0f, 0.0f);
	bodies[1] = unit_box(world, 10.0f, 0.0f); /* will be hit by the next */
	bodies[2] = unit_box(world, 8.5f, 0.2f);
	for (k = 0; k < 3; ++k)
		must(cn_body_set_damping(world, bodies[k], 2.0f, 2.0f), world, "cn_body_set_damping");
	fixture_set_velocity(world, bodies[0], 3.0f, 0.0f, 2.0f);
	fixture_set_velocity(world, bodies[2], 3.0f, 0.0f, 0.0f);
	/* 3 m/s falls below 0.05 after ln(60) / 2 = 2.05 s, in steps */
	CHECK_LE("time to sleep of the free one", fabs((double)steps_to_sleep(world, bodies[0], 300) / 60.0 - 2.55), 2.0 * (double)FRAME_S, "s");
	fixture_step(world, 120);
	CHECK(!fixture_is_awake(world, bodies[1]) && !fixture_is_awake(world, bodies[2]));
	CHECK_GE("the other one was pushed to", fixture_pose(world, bodies[1]).position_m.x, 10.1, "m");
	cn_world_destroy(world);
}

/* Without gravity rounding is all that is left, also where a joint passes it on. */
static void damped_joints_in_zero_gravity_sleep(void)
{
	uint32_t seed = 3;
	int32_t run, awake = 0;
	for (run = 0; run < 40; ++run) {
		cn_world *world = fixture_world(0.0f, 1);
		cn_body a = unit_box(world, 0.0f, 0.0f), b = unit_box(world, 1.2f, 0.0f);
		cn_revolute_def pin;
		cn_fixed_def weld;
		cn_joint joint;
		must(cn_body_set_damping(world, a, 1.0f, 1.0f), world, "cn_body_set_damping");
		must(cn_body_set_damping(world, b, 1.0f, 1.0f), world, "cn_body_set_damping");
		fixture_set_velocity(world, b, fixture_random(&seed, -2.0f, 2.0f), fixture_random(&seed, -2.0f, 2.0f), fixture_random(&seed, -2.0f, 2.0f));
		cn_revolute_def_init(&pin);
		cn_fixed_def_init(&weld);
		pin.base.body_a = weld.base.body_a = a;
		pin.base.body_b = weld.base.body_b = b;
		pin.base.anchor_a_m.x = weld.base.anchor_a_m.x = 0.6f;
		pin.base.anchor_b_m.x = weld.base.anchor_b_m.x = -0.6f;
		if (run % 2)
			must(cn_joint_create_revolute(world, &pin, &joint), world, "cn_joint_create_revolute");
		else
			must(cn_joint_create_fixed(world, &weld, &joint), world, "cn_joint_create_fixed");
		fixture_step(world, 900);
		awake += fixture_is_awake(world, a) || fixture_is_awake(world, b);
		cn_world_destroy(world);
	}
	CHECK_LE("awake after 15 s of 40 pairs", (double)awake, 0.0, "");
}

/* ---- islands that come apart ---- */

static void towers_without_their_bridge_sleep_apart(void)
{
	cn_world *world = fixture_world(-10.0f, 1);
	cn_body left[4], right[4], bridge;
	int32_t k, left_at = -1;
	fixture_floor(world, 0.6f, 0.0f);
	for (k = 0; k < 4; ++k) {
		left[k] = unit_box(world, 0.0f, 0.5f + (float)k);
		right[k] = unit_box(world, 3.0f, 0.5f + (float)k);
	}
	bridge = fixture_box(world, CN_BODY_DYNAMIC, 1.5f, 4.2f, 0.0f, 2.0f, 0.2f, 0.6f, 0.0f);
	fixture_step(world, 20);
	CHECK(fixture_counters(world).islands == 1);
	must(cn_body_destroy(world, bridge), world, "cn_body_destroy");
	for (k = 0; k < 150; ++k) {
		must(cn_body_apply_force(world, right[3], 0.01f, 0.0f), world, "cn_body_apply_force"); /* keeps it awake */
		fixture_step(world, 1);
		if (left_at < 0 && !fixture_is_awake(world, left[0]))
			left_at = k;
	}
	CHECK_GE("step in which the left tower slept", left_at, 1, "");
	CHECK(!fixture_is_awake(world, left[3]) && fixture_is_awake(world, right[0]) && fixture_is_awake(world, right[3]));
	CHECK(fixture_counters(world).islands == 2 && fixture_counters(world).islands_awake == 1);
	CHECK(fixture_is_valid(world));
	fixture_step(world, 60);
	CHECK(!fixture_is_awake(world, right[0]) && fixture_counters(world).bodies_awake == 0);
	fixture_set_velocity(world, left[0], 0.1f, 0.0f, 0.0f);
	CHECK(fixture_is_awake(world, left[3]) && !fixture_is_awake(world, right[0]));
	cn_world_destroy(world);
}

static void a_body_that_may_not_sleep_keeps_its_island_awake(void)
{
	cn_world *world = fixture_world(-10.0f, 1);
	cn_body low, high, alone;
	fixture_floor(world, 0.6f, 0.0f);
	low = unit_box(world, 0.0f, 0.5f);
	high = unit_box(world, 0.0f, 1.5f);
	alone = unit_box(world, 5.0f, 0.5f);
	must(cn_body_set_flags(world, high, CN_BODY_ENABLED), world, "cn_body_set_flags");
	fixture_step(world, 200);
	CHECK(fixture_is_awake(world, low) && fixture_is_awake(world, high) && !fixture_is_awake(world, alone));
	must(cn_body_set_flags(world, high, CN_BODY_ENABLED | CN_BODY_SLEEP), world, "cn_body_set_flags");
	fixture_step(world, 60);
	CHECK(!fixture_is_awake(world, low) && !fixture_is_awake(world, high));
	cn_world_destroy(world);
}

static void own_sleep_speed_counts(void)
{
	cn_world *world = fixture_world(0.0f, 1);
	cn_body slow = unit_box(world, 0.0f, 0.0f), fast = unit_box(world, 0.0f, 5.0f), spinner = unit_box(world, 0.0f, 10.0f);
	must(cn_body_set_sleep_speed(world, fast, 1.0f), world, "cn_body_set_sleep_speed");
	fixture_set_velocity(world, slow, 0.2f, 0.0f, 0.0f);
	fixture_set_velocity(world, fast, 0.2f, 0.0f, 0.0f);
	fixture_set_velocity(world, spinner, 0.0f, 0.0f, 0.2f); /* its corners move at 0.14 m/s */
	fixture_step(world, 60);
	CHECK(fixture_is_awake(world, slow) && !fixture_is_awake(world, fast) && fixture_is_awake(world, spinner));
	must(cn_world_set_sleep(world, 0.5f, 0.5f), world, "cn_world_set_sleep");
	fixture_step(world, 60);
	CHECK(!fixture_is_awake(world, slow) && !fixture_is_awake(world, spinner));
	cn_world_destroy(world);
}

/* ---- the world ---- */

static void a_world_without_sleep_wakes_all(void)
{
	cn_world *world = fixture_world(-10.0f, 1);
	cn_body bodies[20];
	int32_t k;
	fixture_floor(world, 0.6f, 0.0f);
	for (k = 0; k < 20; ++k)
		bodies[k] = unit_box(world, 1.2f * (float)k - 12.0f, 0.5f);
	fixture_step(world, 120);
	CHECK(fixture_counters(world).bodies_awake == 0);
	must(cn_world_set_flags(world, CN_WORLD_WARM_START), world, "cn_world_set_flags");
	CHECK(fixture_counters(world).bodies_awake == 20);
	fixture_step(world, 120);
	CHECK(fixture_counters(world).bodies_awake == 20 && fixture_is_awake(world, bodies[7]));
	must(cn_world_set_flags(world, CN_WORLD_WARM_START | CN_WORLD_SLEEP), world, "cn_world_set_flags");
	fixture_step(world, 60);
	CHECK(fixture_counters(world).bodies_awake == 0);
	cn_world_destroy(world);
}

/* ---- lists ---- */

#define LISTED 40

/* Nothing moves in a step of no time, nor by a call; whether poses are read or not. */
static void moved_list_is_of_the_last_step(void)
{
	int32_t reads, k, count = -1;
	for (reads = 0; reads < 2; ++reads) {
		cn_world *world = fixture_world(-10.0f, 1);
		cn_body falling = unit_box(world, 0.0f, 60.0f), resting = (fixture_floor(world, 0.6f, 0.0f), unit_box(world, 5.0f, 0.8f));
		const cn_body_moved *moved;
		for (k = 0; k < 90; ++k) {
			fixture_step(world, 1);
			if (reads)
				must(cn_world_moved(world, &moved, &count), world, "cn_world_moved");
		}
		CHECK(!fixture_is_awake(world, resting) && fixture_is_awake(world, falling));
		must(cn_body_set_awake(world, resting, 1), world, "cn_body_set_awake");
		must(cn_world_moved(world, &moved, &count), world, "cn_world_moved");
		CHECK(count == 1 && moved[0].body == falling);
		must(cn_world_step(world, 0.0f), world, "cn_world_step");
		must(cn_world_moved(world, &moved, &count), world, "cn_world_moved");
		CHECK(count == 0);
		cn_world_destroy(world);
	}
}

static void moved_list_is_what_moved(void)
{
	cn_world *world = fixture_world(-10.0f, 1);
	cn_body bodies[LISTED];
	cn_pose before[LISTED];
	int32_t k, i, step, wrong = 0, listed = 0, slept = 0;
	uint32_t seed = 5;
	fixture_floor(world, 0.6f, 0.0f);
	for (k = 0; k < LISTED; ++k) {
		bodies[k] = fixture_box(world, k % 10 == 0 ? CN_BODY_KINEMATIC : CN_BODY_DYNAMIC, 1.5f * (float)(k % 10) - 7.0f, 1.0f + 1.2f * (float)(k / 10), 0.0f, 0.4f, 0.4f, 0.6f, 0.0f);
		must(cn_body_set_user_data(world, bodies[k], 1000u + (uint64_t)k), world, "cn_body_set_user_data");
	}
	for (step = 0; step < 300; ++step) {
		const cn_body_moved *moved;
		const cn_body *asleep;
		int32_t moved_count, asleep_count, seen[LISTED] = { 0 };
		if (step > 150 && step % 20 == 0)
			fixture_set_velocity(world, bodies[(int32_t)fixture_random(&seed, 0.0f, LISTED - 1.0f)], 0.5f, 1.0f, 0.0f);
		must(cn_world_read_poses(world, bodies, LISTED, before), world, "cn_world_read_poses");
		fixture_step(world, 1);
		must(cn_world_moved(world, &moved, &moved_count), world, "cn_world_moved");
		must(cn_world_fell_asleep(world, &asleep, &asleep_count), world, "cn_world_fell_asleep");
		for (i = 0; i < moved_count; ++i) {
			cn_pose pose = fixture_pose(world, moved[i].body);
			k = (int32_t)(moved[i].user_data - 1000u);
			wrong += k < 0 || k >= LISTED || bodies[k] != moved[i].body || memcmp(&pose, &moved[i].pose, sizeof pose) != 0;
			seen[k] += moved[i].fell_asleep ? 100 : 1;
		}
		for (k = 0; k < LISTED; ++k) {
			cn_pose pose = fixture_pose(world, bodies[k]);
			int32_t did = memcmp(&pose, &before[k], sizeof pose) != 0, fell = 0;
			for (i = 0; i < asleep_count; ++i)
				fell += asleep[i] == bodies[k];
			wrong += fell > 1 || seen[k] != (fell ? 100 : did);
			listed += seen[k] != 0;
			slept += fell;
		}
	}
	printf("  %d entries, %d times a body fell asleep\n", (int)listed, (int)slept);
	CHECK_LE("bodies listed wrongly", wrong, 0, "");
	CHECK_GE("bodies that fell asleep", slept, LISTED, "");
	cn_world_destroy(world);
}

/* ---- what sleeps changes nothing ---- */

#define CROWD 120
#define PILES 1500

typedef struct crowd {
	cn_world *world;
	cn_body bodies[CROWD];
} crowd;

/* The world's first bodies, or none: two boxes each. */
static void crowd_begin(crowd *c, int32_t piles)
{
	int32_t k;
	c->world = fixture_world(-10.0f, 1);
	fixture_box(c->world, CN_BODY_STATIC, 0.0f, -1.0f, 0.0f, 20000.0f, 1.0f, 0.6f, 0.0f);
	for (k = 0; k < 2 * piles; ++k)
		unit_box(c->world, 100.0f + 1.5f * (float)(k / 2), 0.5f + (float)(k % 2));
	fixture_step(c->world, 90);
	CHECK(fixture_counters(c->world).bodies_awake == 0 && fixture_counters(c->world).islands == piles);
	for (k = 0; k < CROWD; ++k) {
		float x = -6.0f + 1.1f * (float)(k % 12), y = 1.0f + 1.2f * (float)(k / 12);
		c->bodies[k] = k % 3 == 0 ? fixture_circle(c->world, CN_BODY_DYNAMIC, x, y, 0.5f, 0.5f, 0.5f) : unit_box(c->world, x, y);
		fixture_set_velocity(c->world, c->bodies[k], (float)(k * 31 % 19 - 9), (float)(k * 53 % 23 - 11), 0.0f);
	}
}

static int32_t crowd_differs(const crowd *a, const crowd *b)
{
	int32_t k, count = 0;
	for (k = 0; k < CROWD; ++k) {
		cn_pose pa = fixture_pose(a->world, a->bodies[k]), pb = fixture_pose(b->world, b->bodies[k]);
		count += memcmp(&pa, &pb, sizeof pa) != 0;
	}
	return count;
}

/* Where many more islands sleep than are awake, a step numbers those that are: the same bits come of it. */
static void sleepers_do_not_change_what_moves(void)
{
	crowd alone, beside;
	int32_t step, different = 0, islands = 0, slept = 0, fewest = CROWD;
	crowd_begin(&alone, 0);
	crowd_begin(&beside, PILES);
	for (step = 0; step < 900; ++step) {
		fixture_step(alone.world, 1);
		fixture_step(beside.world, 1);
		different += crowd_differs(&alone, &beside);
		islands = islands > fixture_counters(beside.world).islands_awake ? islands : fixture_counters(beside.world).islands_awake;
		fewest = fewest < fixture_counters(alone.world).bodies_awake ? fewest : fixture_counters(alone.world).bodies_awake;
		slept += fixture_counters(alone.world).bodies_awake != fixture_counters(beside.world).bodies_awake;
	}
	printf("  at most %d islands awake beside %d asleep; at least %d bodies of the crowd awake\n", (int)islands, PILES, (int)fewest);
	CHECK_LE("poses that differ", different, 0, "");
	CHECK_LE("steps in which not the same number is awake", slept, 0, "");
	CHECK(islands > 3 && fewest < CROWD / 4); /* a ball that rolls by may wake the others again */
	CHECK(fixture_is_valid(beside.world));
	cn_world_destroy(alone.world);
	cn_world_destroy(beside.world);
}

/* Not awake, not in any island that is, and the same bits whatever time passes. What that costs: growth_time_test.c. */
static void sleeping_bodies_are_left_alone(void)
{
	cn_world *full = fixture_world(-10.0f, 1);
	cn_body body = 0;
	cn_counters c;
	uint64_t hash;
	int32_t k;
	fixture_box(full, CN_BODY_STATIC, 0.0f, -1.0f, 0.0f, 10000.0f, 1.0f, 0.6f, 0.0f);
	for (k = 0; k < 10000; ++k)
		body = unit_box(full, 1.2f * (float)(k / 2) - 3000.0f, 0.5f + (float)(k % 2));
	fixture_step(full, 75);
	c = fixture_counters(full);
	CHECK(c.bodies_awake == 0 && c.contacts_awake == 0 && c.islands_awake == 0 && c.colors_used == 0);
	CHECK(c.contacts_touching == 10000 && c.islands == 5000);
	hash = fixture_hash(full);
	fixture_step(full, 200);
	CHECK(fixture_hash(full) == hash);
	CHECK(!fixture_is_awake(full, body));
	cn_world_destroy(full);
}

/* Bodies that come to rest in the same step leave over several, by a share of those that are awake: step/sleep.c. */
static void a_crowd_falls_asleep_in_parts(void)
{
	cn_world *world = fixture_world(0.0f, 1);
	int32_t k, step, before, most = 0;
	for (k = 0; k < 2000; ++k)
		fixture_circle(world, CN_BODY_DYNAMIC, 2.0f * (float)(k % 50), 2.0f * (float)(k / 50), 0.5f, 0.5f, 0.0f);
	for (step = 0; step < 60; ++step) {
		before = fixture_counters(world).bodies_awake;
		fixture_step(world, 1);
		most = before - fixture_counters(world).bodies_awake > most ? before - fixture_counters(world).bodies_awake : most;
	}
	CHECK(fixture_counters(world).bodies_awake == 0);
	CHECK_LE("bodies that fall asleep in a step", most, 1024, "");
	CHECK(fixture_is_valid(world));
	cn_world_destroy(world);
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(box_at_rest_sleeps_after_the_delay);
	RUN(island_sleeps_as_one);
	RUN(box_rests_and_sleeps_under_weak_gravity);
	RUN(nothing_sleeps_at_the_apex_of_a_throw);
	RUN(nothing_sleeps_at_the_end_of_a_swing);
	RUN(what_has_left_keeps_nobody_awake);
	RUN(everybody_waits_for_the_whole_delay);
	RUN(moving_islands_do_not_sleep_with_others);
	RUN(damped_bodies_in_zero_gravity_sleep);
	RUN(damped_joints_in_zero_gravity_sleep);
	RUN(towers_without_their_bridge_sleep_apart);
	RUN(a_body_that_may_not_sleep_keeps_its_island_awake);
	RUN(own_sleep_speed_counts);
	RUN(a_world_without_sleep_wakes_all);
	RUN(moved_list_is_what_moved);
	RUN(moved_list_is_of_the_last_step);
	RUN(sleepers_do_not_change_what_moves);
	RUN(sleeping_bodies_are_left_alone);
	RUN(a_crowd_falls_asleep_in_parts);
	return test_end();
}
