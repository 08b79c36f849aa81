/*
 * test/world/update_test.c - variable time: elapsed seconds in, fixed steps out, poses between the last two.
 *
 * If a test here fails, look first in: world/update.c; for teleports, world/body_state.c.
 */
#include "fixture.h"

static cn_world *falling_world(cn_body *out_ball)
{
	cn_world *world = fixture_world(-10.0f, 0);
	*out_ball = fixture_box(world, CN_BODY_DYNAMIC, 0.0f, 0.0f, 0.2f, 0.5f, 0.25f, 0.6f, 0.0f);
	fixture_set_velocity(world, *out_ball, 3.0f, 8.0f, 5.0f);
	return world;
}

static cn_update_report update(cn_world *world, float elapsed_s)
{
	cn_update_report report;
	memset(&report, 0xA5, sizeof report);
	must(cn_world_update(world, elapsed_s, &report), world, "cn_world_update");
	return report;
}

static cn_pose pose_at(const cn_world *world, cn_body body, float factor)
{
	cn_pose pose;
	must(cn_world_read_poses_interpolated(world, &body, 1, factor, &pose), world, "cn_world_read_poses_interpolated");
	return pose;
}

static int pose_is(cn_pose a, cn_pose b)
{
	return memcmp(&a, &b, sizeof a) == 0;
}

/* ---- time ---- */

/* mode 0 to 2: even frames; 3: random ones up to 50 ms. */
static void long_run(const char *name, int32_t mode, float frame_s)
{
	cn_world *world = fixture_world(-10.0f, 0);
	uint32_t seed = 12345u;
	double elapsed = 0.0, worst = 0.0, worst_leftover = 0.0, worst_factor = 0.0, dropped = 0.0;
	int64_t steps = 0;
	int32_t k, wrong = 0;
	for (k = 0; k < 20000; ++k) {
		float dt = mode == 3 ? fixture_random(&seed, 0.0f, 0.05f) : frame_s;
		cn_update_report r = update(world, dt);
		double owed;
		elapsed += (double)dt;
		steps += r.steps;
		dropped += (double)r.dropped_s;
		owed = elapsed - (double)steps * (double)FRAME_S;
		worst = greater(worst, greater(owed - (double)FRAME_S, -owed));
		worst_leftover = greater(worst_leftover, fabs(owed - (double)r.leftover_s));
		worst_factor = greater(worst_factor, fabs((double)r.interpolation - (double)r.leftover_s / (double)FRAME_S));
		wrong += r.interpolation < 0.0f || r.interpolation >= 1.0f || r.leftover_s < 0.0f;
	}
	printf("  %s: %.1f s, %ld steps\n", name, elapsed, (long)steps);
	CHECK(fixture_counters(world).steps == (uint32_t)steps);
	CHECK_LE("simulated time outside of one step of elapsed", worst, 1e-4, "s");
	CHECK_LE("leftover against the true rest", worst_leftover, 1e-4, "s");
	CHECK_LE("interpolation against leftover / step", worst_factor, 1e-6, "");
	CHECK_LE("interpolation or leftover out of range", wrong, 0, "updates");
	CHECK_LE("time dropped", dropped, 0.0, "s");
	cn_world_destroy(world);
}

static void steps_follow_elapsed_time(void)
{
	long_run("1/144 s", 0, 1.0f / 144.0f);
	long_run("1/60 s", 1, 1.0f / 60.0f);
	long_run("1/30 s", 2, 1.0f / 30.0f);
	long_run("random", 3, 0.0f);
}

static void cap_drops_whole_steps_and_says_so(void)
{
	cn_world *world = fixture_world(-10.0f, 0);
	cn_update_report r;
	must(cn_world_set_fixed_step(world, 0.0625f, 4), world, "cn_world_set_fixed_step");
	r = update(world, 1.0f + 0.03125f); /* 16.5 steps: 4 taken, 12 dropped, a half kept */
	CHECK(r.steps == 4);
	CHECK(r.dropped_s == 0.75f);
	CHECK(r.leftover_s == 0.03125f);
	CHECK(r.interpolation == 0.5f);
	r = update(world, 0.03125f);
	CHECK(r.steps == 1 && r.dropped_s == 0.0f && r.leftover_s == 0.0f && r.interpolation == 0.0f);
	r = update(world, 0.25f);
	CHECK(r.steps == 4 && r.dropped_s == 0.0f);
	r = update(world, 0.0f);
	CHECK(r.steps == 0 && r.leftover_s == 0.0f);
	CHECK(fixture_counters(world).steps == 9u);
	cn_world_destroy(world);
}

static void default_cap_is_eight(void)
{
	cn_world *world = fixture_world(-10.0f, 0);
	cn_update_report r = update(world, 10.0f);
	CHECK(r.steps == 8);
	CHECK_LE("taken + dropped + kept against elapsed", fabs(8.0 * (double)FRAME_S + (double)r.dropped_s + (double)r.leftover_s - 10.0), 1e-5, "s");
	cn_world_destroy(world);
}

/* More steps than an int32 can count are dropped like any others. */
static void tiny_fixed_steps_are_capped(void)
{
	static const float steps[] = { 1e-6f, 1e-9f, 1e-12f, 1e-30f, 1e-38f };
	size_t k;
	for (k = 0; k < sizeof steps / sizeof *steps; ++k) {
		cn_body ball;
		cn_world *world = falling_world(&ball);
		cn_update_report r;
		must(cn_world_set_fixed_step(world, steps[k], 5), world, "cn_world_set_fixed_step");
		r = update(world, 10.0f);
		CHECK(r.steps == 5);
		CHECK(r.leftover_s >= 0.0f && r.leftover_s <= steps[k] && r.interpolation >= 0.0f && r.interpolation < 1.0f);
		CHECK_LE("dropped time against elapsed", fabs((double)r.dropped_s - 10.0), 1e-4, "s");
		CHECK(fixture_is_valid(world));
		cn_world_destroy(world);
	}
}

static void fixed_step_can_change(void)
{
	cn_world *world = fixture_world(-10.0f, 0);
	cn_update_report r;
	must(cn_world_set_fixed_step(world, 0.125f, 8), world, "cn_world_set_fixed_step");
	r = update(world, 0.1875f);
	CHECK(r.steps == 1 && r.leftover_s == 0.0625f);
	must(cn_world_set_fixed_step(world, 0.03125f, 8), world, "cn_world_set_fixed_step");
	r = update(world, 0.0f); /* what is owed is now two steps */
	CHECK(r.steps == 2 && r.leftover_s == 0.0f);
	must(cn_world_set_fixed_step(world, 1.0f, 1), world, "cn_world_set_fixed_step");
	r = update(world, 0.5f);
	CHECK(r.steps == 0 && r.interpolation == 0.5f);
	cn_world_destroy(world);
}

/* ---- the same simulation ---- */

static void pile_make(cn_world *world)
{
	uint32_t seed = 5u;
	int32_t k;
	fixture_floor(world, 0.6f, 0.1f);
	for (k = 0; k < 20; ++k) {
		float x = fixture_random(&seed, -2.0f, 2.0f), angle = fixture_random(&seed, -3.0f, 3.0f);
		fixture_box(world, CN_BODY_DYNAMIC, x, 1.0f + (float)k, angle, 0.5f, 0.3f, 0.6f, 0.1f);
	}
}

static void updating_is_stepping(void)
{
	cn_world *updated = fixture_world(-10.0f, 1), *stepped = fixture_world(-10.0f, 1);
	uint32_t seed = 9u;
	int32_t k, different = 0, steps = 0;
	pile_make(updated);
	pile_make(stepped);
	for (k = 0; k < 400; ++k) {
		cn_update_report r = update(updated, fixture_random(&seed, 0.0f, 0.04f));
		fixture_step(stepped, r.steps);
		steps += r.steps;
		different += fixture_hash(updated) != fixture_hash(stepped);
	}
	printf("  %d steps\n", (int)steps);
	CHECK_LE("updates after which the worlds differ", different, 0, "");
	cn_world_destroy(updated);
	cn_world_destroy(stepped);
}

static void report_may_be_null(void)
{
	cn_body ball;
	cn_world *world = falling_world(&ball);
	CHECK(cn_world_update(world, 0.05f, NULL) == CN_OK);
	CHECK(fixture_counters(world).steps == 3u || fixture_counters(world).steps == 2u);
	cn_world_destroy(world);
}

/* ---- poses between ---- */

/* The reference takes the same steps and so knows both poses. */
static void poses_lie_between_the_last_two(void)
{
	cn_body ball, other;
	cn_world *world = falling_world(&ball), *reference = falling_world(&other);
	uint32_t seed = 3u;
	double off = 0.0, length = 0.0;
	int32_t k, ends_wrong = 0;
	cn_pose before = fixture_pose(reference, other), after = before;
	for (k = 0; k < 200; ++k) {
		float f = fixture_random(&seed, 0.0f, 1.0f);
		cn_update_report r = update(world, fixture_random(&seed, 0.0f, 0.05f));
		cn_pose p;
		int32_t step;
		for (step = 0; step < r.steps; ++step) {
			before = after;
			fixture_step(reference, 1);
			after = fixture_pose(reference, other);
		}
		p = pose_at(world, ball, 0.0f);
		ends_wrong += !pose_is(p, before);
		ends_wrong += !pose_is(pose_at(world, ball, 1.0f), after);
		p = pose_at(world, ball, f);
		length = greater(length, fabs(hypot((double)p.cosine, (double)p.sine) - 1.0));
		off = greater(off, fabs((double)p.position_m.x - ((double)before.position_m.x + (double)f * ((double)after.position_m.x - (double)before.position_m.x))));
		off = greater(off, fabs((double)p.position_m.y - ((double)before.position_m.y + (double)f * ((double)after.position_m.y - (double)before.position_m.y))));
	}
	CHECK_LE("ends that are not the two poses", ends_wrong, 0, "");
	CHECK_LE("distance from the line between", off, 2e-5, "m");
	CHECK_LE("rotation's length against 1", length, 1e-6, "");
	cn_world_destroy(world);
	cn_world_destroy(reference);
}

static void angles_turn_evenly_enough(void)
{
	cn_world *world = fixture_world(0.0f, 0);
	cn_body body = fixture_circle(world, CN_BODY_DYNAMIC, 0.0f, 0.0f, 0.5f, 0.6f, 0.0f);
	double worst = 0.0, start, turn;
	int32_t k;
	cn_pose p;
	fixture_set_velocity(world, body, 0.0f, 0.0f, 20.0f);
	update(world, FRAME_S * 3.5f);
	p = pose_at(world, body, 0.0f);
	start = atan2((double)p.sine, (double)p.cosine);
	turn = 20.0 * (double)FRAME_S;
	for (k = 0; k <= 16; ++k) {
		p = pose_at(world, body, (float)k / 16.0f);
		worst = greater(worst, fabs(remainder(atan2((double)p.sine, (double)p.cosine) - start - turn * k / 16.0, 6.283185307179586)));
	}
	/* A chord instead of the arc: off by at most turn^3 sqrt(3) / 108. */
	CHECK_LE("angle against even turning", worst, turn * turn * turn * sqrt(3.0) / 108.0 * 1.01, "rad");
	cn_world_destroy(world);
}

static void teleports_do_not_glide(void)
{
	cn_body ball;
	cn_world *world = falling_world(&ball);
	int32_t k;
	update(world, 0.1f);
	must(cn_body_set_pose(world, ball, 50.0f, 60.0f, 1.0f), world, "cn_body_set_pose");
	for (k = 0; k <= 4; ++k)
		CHECK(pose_is(pose_at(world, ball, 0.25f * (float)k), fixture_pose(world, ball)));
	update(world, FRAME_S * 1.01f);
	CHECK_LE("distance from the new place after the next update", hypot((double)pose_at(world, ball, 0.0f).position_m.x - 50.0, (double)pose_at(world, ball, 0.0f).position_m.y - 60.0), ROUNDING, "m");
	cn_world_destroy(world);
}

static void present_poses_without_a_previous_one(void)
{
	cn_body ball, fresh, still;
	cn_world *world = falling_world(&ball);
	CHECK(pose_is(pose_at(world, ball, 0.0f), fixture_pose(world, ball))); /* before the first update */
	still = fixture_circle(world, CN_BODY_STATIC, 30.0f, 0.0f, 0.5f, 0.6f, 0.0f);
	update(world, 0.1f);
	CHECK(!pose_is(pose_at(world, ball, 0.0f), fixture_pose(world, ball)));
	CHECK(pose_is(pose_at(world, still, 0.3f), fixture_pose(world, still)));
	fresh = fixture_circle(world, CN_BODY_DYNAMIC, 5.0f, 5.0f, 0.5f, 0.6f, 0.0f);
	CHECK(pose_is(pose_at(world, fresh, 0.0f), fixture_pose(world, fresh)));
	must(cn_body_destroy(world, ball), world, "cn_body_destroy"); /* its slot is used again */
	ball = fixture_circle(world, CN_BODY_DYNAMIC, -9.0f, 5.0f, 0.5f, 0.6f, 0.0f);
	CHECK(pose_is(pose_at(world, ball, 0.5f), fixture_pose(world, ball)));
	update(world, 0.1f);
	CHECK(!pose_is(pose_at(world, ball, 0.0f), fixture_pose(world, ball)));
	fixture_step(world, 1); /* not by an update: what was kept is older than the last two poses */
	CHECK(pose_is(pose_at(world, ball, 0.5f), fixture_pose(world, ball)));
	cn_world_destroy(world);
}

static void sleeping_bodies_have_their_pose(void)
{
	cn_world *world = fixture_world(-10.0f, 1);
	cn_body box;
	int32_t k;
	fixture_floor(world, 0.6f, 0.0f);
	box = fixture_box(world, CN_BODY_DYNAMIC, 0.0f, 0.6f, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f);
	for (k = 0; k < 200; ++k)
		update(world, FRAME_S);
	REQUIRE(!fixture_is_awake(world, box));
	update(world, 0.1f);
	CHECK(pose_is(pose_at(world, box, 0.0f), fixture_pose(world, box)));
	CHECK(pose_is(pose_at(world, box, 0.5f), fixture_pose(world, box)));
	cn_world_destroy(world);
}

static void all_bodies_are_read_in_order(void)
{
	cn_world *world = fixture_world(-10.0f, 0);
	cn_body bodies[21];
	cn_pose all[21], listed[21];
	int32_t count = 0;
	pile_make(world);
	update(world, 0.1f);
	must(cn_world_get_bodies(world, bodies, 21, &count), world, "cn_world_get_bodies");
	must(cn_body_destroy(world, bodies[7]), world, "cn_body_destroy");
	must(cn_world_get_bodies(world, bodies, 21, &count), world, "cn_world_get_bodies");
	REQUIRE(count == 20);
	must(cn_world_read_poses_interpolated(world, NULL, 20, 0.4f, all), world, "all");
	must(cn_world_read_poses_interpolated(world, bodies, 20, 0.4f, listed), world, "listed");
	CHECK(memcmp(all, listed, 20 * sizeof *all) == 0);
	cn_world_destroy(world);
}

/* ---- what is refused ---- */

static cn_result locked_update;
static void update_inside(cn_world *world, const cn_contact_event *event, void *user)
{
	(void)event;
	(void)user;
	locked_update = cn_world_update(world, 0.1f, NULL);
}

static void bad_input_changes_nothing(void)
{
	static const float bad_elapsed[] = { -0.001f, 10.01f, NAN, INFINITY, -INFINITY };
	static const float bad_step[] = { 0.0f, -0.1f, 1.01f, NAN, INFINITY };
	cn_body ball;
	cn_world *world = falling_world(&ball);
	cn_update_report untouched, r;
	cn_pose pose;
	uint64_t hash = fixture_hash(world);
	size_t k;
	memset(&r, 0x5A, sizeof r);
	untouched = r;
	for (k = 0; k < 5; ++k) {
		CHECK(cn_world_update(world, bad_elapsed[k], &r) == CN_ERROR_ARGUMENT);
		CHECK(cn_world_set_fixed_step(world, bad_step[k], 8) == CN_ERROR_ARGUMENT);
	}
	CHECK(cn_world_update(NULL, 0.1f, &r) == CN_ERROR_ARGUMENT);
	CHECK(cn_world_set_fixed_step(NULL, 0.1f, 8) == CN_ERROR_ARGUMENT);
	CHECK(cn_world_set_fixed_step(world, 0.1f, 0) == CN_ERROR_ARGUMENT);
	CHECK(cn_world_set_fixed_step(world, 0.1f, -3) == CN_ERROR_ARGUMENT);
	CHECK(memcmp(&r, &untouched, sizeof r) == 0);
	CHECK(fixture_hash(world) == hash);
	CHECK(cn_world_read_poses_interpolated(world, &ball, 1, 1.01f, &pose) == CN_ERROR_ARGUMENT);
	CHECK(cn_world_read_poses_interpolated(world, &ball, 1, -0.01f, &pose) == CN_ERROR_ARGUMENT);
	CHECK(cn_world_read_poses_interpolated(world, &ball, 1, NAN, &pose) == CN_ERROR_ARGUMENT);
	CHECK(cn_world_read_poses_interpolated(world, &ball, 1, 0.5f, NULL) == CN_ERROR_ARGUMENT);
	CHECK(cn_world_read_poses_interpolated(world, NULL, 2, 0.5f, &pose) == CN_ERROR_ARGUMENT);
	CHECK(cn_world_read_poses_interpolated(NULL, &ball, 1, 0.5f, &pose) == CN_ERROR_ARGUMENT);
	must(cn_body_destroy(world, ball), world, "cn_body_destroy");
	CHECK(cn_world_read_poses_interpolated(world, &ball, 1, 0.5f, &pose) == CN_ERROR_HANDLE);
	r = update(world, FRAME_S); /* the bad calls left no time behind and the fixed step as it was */
	CHECK(r.steps == 1 && r.leftover_s == 0.0f);
	cn_world_destroy(world);
}

static void callbacks_cannot_update(void)
{
	cn_world *world = fixture_world(-10.0f, 0);
	pile_make(world);
	locked_update = CN_OK;
	must(cn_world_set_contact_callback(world, CN_EVENT_ENTER, update_inside, NULL), world, "cn_world_set_contact_callback");
	update(world, 0.13f);
	update(world, 0.13f);
	update(world, 0.13f);
	update(world, 0.13f);
	CHECK(locked_update == CN_ERROR_LOCKED);
	cn_world_destroy(world);
}

/* ---- memory ---- */

static int fail_now;
static void *failing_alloc(uint64_t bytes, uint32_t align, void *user)
{
	void *raw, **aligned;
	(void)user;
	if (fail_now || (raw = malloc((size_t)bytes + align + sizeof raw)) == NULL)
		return NULL;
	aligned = (void **)(((uintptr_t)raw + sizeof raw + align - 1u) / align * align);
	aligned[-1] = raw;
	return aligned;
}

static void failing_free(void *memory, uint64_t bytes, void *user)
{
	(void)bytes;
	(void)user;
	free(((void **)memory)[-1]);
}

static void first_update_without_memory_can_be_tried_again(void)
{
	cn_world_def def;
	cn_world *world = NULL;
	cn_update_report r;
	uint64_t hash;
	cn_world_def_init(&def);
	def.alloc = failing_alloc;
	def.free = failing_free;
	fail_now = 0;
	must(cn_world_create(&def, &world), NULL, "cn_world_create");
	pile_make(world);
	fixture_step(world, 1);
	hash = fixture_hash(world);
	fail_now = 1;
	CHECK(cn_world_update(world, 0.1f, &r) == CN_ERROR_MEMORY);
	CHECK(cn_world_error_text(world)[0] != '\0');
	CHECK(fixture_hash(world) == hash && fixture_is_valid(world));
	fail_now = 0;
	r = update(world, FRAME_S);
	CHECK(r.steps == 1 && r.leftover_s == 0.0f); /* the failed call left no time behind */
	CHECK(fixture_is_valid(world));
	cn_world_destroy(world);
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(steps_follow_elapsed_time);
	RUN(cap_drops_whole_steps_and_says_so);
	RUN(default_cap_is_eight);
	RUN(tiny_fixed_steps_are_capped);
	RUN(fixed_step_can_change);
	RUN(updating_is_stepping);
	RUN(report_may_be_null);
	RUN(poses_lie_between_the_last_two);
	RUN(angles_turn_evenly_enough);
	RUN(teleports_do_not_glide);
	RUN(present_poses_without_a_previous_one);
	RUN(sleeping_bodies_have_their_pose);
	RUN(all_bodies_are_read_in_order);
	RUN(bad_input_changes_nothing);
	RUN(callbacks_cannot_update);
	RUN(first_update_without_memory_can_be_tried_again);
	return test_end();
}
