/*
 * test/save/save_test.c - a restored world goes on bit for bit, in the world that was saved and in another one, after every kind of
 * history; what it saves again is the same bytes.
 */
#include "saves.h"

#include "world/joints.h"
#include "world/memory_session.h"
#include "model/world.h"

#define LOCKSTEP TEST_FORM(60, 14, 10)

/* ---- scenes ---- */

typedef struct journey {
	const char *scene;
	int32_t saved_at;
	int32_t elsewhere; /* the scene's steps only read its memory, and know the world by its run alone */
	setting s;
} journey;

#define SWEEP CN_BROADPHASE_SWEEP
#define TREE CN_BROADPHASE_TREE

static const journey journeys[] = {
	/* every history with the default solver: falling, breaking, stacked, asleep, joints of every kind, chains, created on the way */
	{ "falling_hinges", 90, 1, { CN_SOLVER_AUTO, SWEEP, 0, 0 } },
	{ "dominoes", 150, 1, { CN_SOLVER_AUTO, TREE, 0, 0 } },
	{ "ragdolls", 100, 1, { CN_SOLVER_AUTO, SWEEP, 0, 1 } },
	{ "bridge", 120, 1, { CN_SOLVER_AUTO, TREE, 0, 1 } },
	{ "car", 60, 1, { CN_SOLVER_AUTO, SWEEP, 0, 0 } },
	{ "mixer", 60, 1, { CN_SOLVER_AUTO, TREE, 2, 0 } },
	{ "machines", 77, 0, { CN_SOLVER_AUTO, SWEEP, 0, 0 } },
	{ "constraints", 130, 0, { CN_SOLVER_AUTO, TREE, 0, 0 } },
	{ "small_200", 200, 1, { CN_SOLVER_AUTO, SWEEP, 2, 0 } },
	{ "small_50_sleep", 300, 1, { CN_SOLVER_AUTO, SWEEP, 0, 1 } },
	{ "pyramid", 20, 1, { CN_SOLVER_AUTO, SWEEP, 2, 1 } },
	{ "pyramid", 70, 1, { CN_SOLVER_AUTO, TREE, 0, 0 } },
	/* the other solvers */
	{ "falling_hinges", 200, 1, { CN_SOLVER_SOFT, TREE, 2, 0 } },
	{ "small_200", 120, 1, { CN_SOLVER_SOFT, SWEEP, 0, 1 } },
	{ "machines", 110, 0, { CN_SOLVER_SOFT, SWEEP, 0, 0 } },
	{ "falling_hinges", 60, 1, { CN_SOLVER_DIRECT, SWEEP, 0, 0 } },
	{ "dominoes", 200, 1, { CN_SOLVER_DIRECT, TREE, 0, 1 } },
	{ "machines", 60, 0, { CN_SOLVER_DIRECT, TREE, 0, 0 } },
	{ "small_200", 120, 1, { CN_SOLVER_SEQUENTIAL, TREE, 0, 0 } },
	{ "machines", 60, 0, { CN_SOLVER_SEQUENTIAL, SWEEP, 0, 0 } },
	{ "falling_hinges", 60, 1, { CN_SOLVER_SEQUENTIAL, SWEEP, 2, 1 } },
};

static void scene_begin(scene_run *run, const journey *j, void **block)
{
	const scene *which = scene_find(j->scene);
	memset(run, 0, sizeof *run);
	if (which == NULL)
		exit(2);
	run->scene = which;
	run->world = world_of(which, &j->s, block);
	which->create(run);
	scene_must(run);
}

static void scene_end(scene_run *run, void *block)
{
	scene_close(run);
	free(block);
}

/* What is seen of each of the next steps. */
static void watch(scene_run *run, uint64_t digests[LOCKSTEP])
{
	int32_t k;
	for (k = 0; k < LOCKSTEP; ++k) {
		scene_steps(run, 1);
		digests[k] = digest_step(0xCBF29CE484222325u, run->world);
	}
}

/* The first step that differs, or LOCKSTEP. */
static int32_t same_steps(const uint64_t a[LOCKSTEP], const uint64_t b[LOCKSTEP])
{
	int32_t k = 0;
	while (k < LOCKSTEP && a[k] == b[k])
		++k;
	return k;
}

/* Something else happens: bodies go, come and are pushed, so that tables, lists and chunks are others. */
static void go_astray(cn_world *world)
{
	cn_body bodies[64];
	int32_t count, k;
	must(cn_world_get_bodies(world, bodies, 64, &count), world, "cn_world_get_bodies");
	for (k = 0; k < count && k < 64; k += 3)
		must(cn_body_destroy(world, bodies[k]), world, "cn_body_destroy");
	for (k = 1; k < count && k < 64; k += 3)
		must(cn_body_set_pose(world, bodies[k], 0.1f * (float)k, 5.0f, 0.0f), world, "cn_body_set_pose");
	for (k = 0; k < 60; ++k)
		fixture_circle(world, CN_BODY_DYNAMIC, 0.2f * (float)k - 6.0f, 12.0f, 0.3f, 0.5f, 0.5f);
	must(cn_world_set_gravity(world, 1.0f, -3.0f), world, "cn_world_set_gravity");
	must(cn_world_set_substep_count(world, 2), world, "cn_world_set_substep_count");
	fixture_step(world, 40);
}

static int32_t replayed(scene_run *run, const saved *s, const journey *j, const uint64_t straight[LOCKSTEP])
{
	uint64_t again[LOCKSTEP];
	restore_world(run->world, s);
	run->step_index = j->saved_at;
	if (!saves_the_same(run->world, s) || !fixture_is_valid(run->world))
		return -1;
	watch(run, again);
	return same_steps(straight, again);
}

static int32_t replayed_elsewhere(const scene_run *run, const saved *s, const journey *j, const uint64_t straight[LOCKSTEP])
{
	scene_run other = *run;
	void *block;
	int32_t steps;
	if (!j->elsewhere)
		return LOCKSTEP;
	other.world = world_of(run->scene, &j->s, &block);
	steps = replayed(&other, s, j, straight);
	cn_world_destroy(other.world);
	free(block);
	return steps;
}

static void t_a_restored_world_goes_on_bit_for_bit(void)
{
	uint64_t straight[LOCKSTEP];
	size_t i;
	for (i = 0; i < sizeof journeys / sizeof *journeys; ++i) {
		const journey *j = &journeys[i];
		scene_run run;
		saved s;
		void *block;
		int32_t back, astray, elsewhere;
		scene_begin(&run, j, &block);
		scene_steps(&run, j->saved_at);
		s = save_world(run.world);
		watch(&run, straight);
		back = replayed(&run, &s, j, straight);
		elsewhere = replayed_elsewhere(&run, &s, j, straight);
		go_astray(run.world);
		astray = replayed(&run, &s, j, straight);
		printf("  %-15s solver %d broadphase %d workers %d block %d: %7llu bytes, steps alike %d, elsewhere %d, after another history %d\n", j->scene,
			(int)j->s.solver, (int)j->s.broadphase, (int)j->s.workers, (int)j->s.in_block, (unsigned long long)s.bytes, (int)back, (int)elsewhere, (int)astray);
		CHECK(back == LOCKSTEP && elsewhere == LOCKSTEP && astray == LOCKSTEP);
		saved_free(&s);
		scene_end(&run, block);
	}
}

/* ---- every kind of change: a rollback of 8 steps in each step of a scripted life (test/world/memory_session.h) ---- */

#define AHEAD 8

static session straight_life, rolled_life;

static void life_begin(session *s)
{
	memset(s, 0, sizeof *s);
	s->failed_step = s->recovered_step = -1;
	session_world(s);
	session_build(s);
}

static void life_step(session *s)
{
	session_before_step(s);
	session_step(s);
}

/* The world, and what the game knows of it. The hooks are the world's memory, and go on. */
static void life_roll_back(session *s, const session *then, const saved *world)
{
	session_hooks hooks;
	restore_world(s->world, world);
	hooks = s->hooks;
	*s = *then;
	s->hooks = hooks;
}

static void t_rolling_back_in_every_step_changes_nothing(void)
{
	int32_t k;
	life_begin(&straight_life);
	life_begin(&rolled_life);
	while (straight_life.step < SESSION_STEPS) {
		session then = rolled_life;
		saved s = save_world(rolled_life.world);
		for (k = 0; k < AHEAD && rolled_life.step < SESSION_STEPS; ++k)
			life_step(&rolled_life);
		life_roll_back(&rolled_life, &then, &s);
		REQUIRE(fixture_is_valid(rolled_life.world) && saves_the_same(rolled_life.world, &s));
		saved_free(&s);
		life_step(&rolled_life);
		life_step(&straight_life);
		REQUIRE(digest_step(0, rolled_life.world) == digest_step(0, straight_life.world));
		REQUIRE(memcmp(rolled_life.bodies, straight_life.bodies, sizeof straight_life.bodies) == 0);
		REQUIRE(memcmp(rolled_life.joints, straight_life.joints, sizeof straight_life.joints) == 0);
	}
	session_end(&rolled_life);
	session_end(&straight_life);
	CHECK(rolled_life.problem == NULL && straight_life.problem == NULL);
	printf("  %d steps, %d events in each life, problem %s\n", (int)straight_life.step, (int)straight_life.events, rolled_life.problem != NULL ? rolled_life.problem : "none");
}

/* ---- uneven steps, solvers of single bodies and joints, ground that changes ---- */

static cn_world *mixed_world(void)
{
	cn_world *world = fixture_world(-10.0f, 1);
	cn_body chain[8];
	cn_joint joints[8];
	int32_t k;
	for (k = 0; k < 12; ++k)
		fixture_box(world, CN_BODY_STATIC, (float)k - 6.0f, -0.5f, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f);
	for (k = 0; k < 30; ++k)
		must(cn_body_set_solver(world, fixture_box(world, CN_BODY_DYNAMIC, (float)(k % 6) - 3.0f, 0.5f + (float)(k / 6), 0.0f, 0.5f, 0.5f, 0.6f, 0.1f), k == 3 ? CN_SOLVER_DIRECT : CN_SOLVER_AUTO), world,
			"cn_body_set_solver");
	make_chain(world, 8, 1.0f, 0.0f, chain, joints);
	must(cn_joint_set_solver(world, joints[2], CN_SOLVER_SOFT), world, "cn_joint_set_solver");
	must(cn_body_set_velocity(world, chain[7], 0.0f, 9.0f, 0.0f), world, "cn_body_set_velocity");
	must(cn_world_set_user_data(world, 1234), world, "cn_world_set_user_data");
	must(cn_world_set_fixed_step(world, 0.011f, 3), world, "cn_world_set_fixed_step");
	return world;
}

static void mixed_step(cn_world *world, int32_t step)
{
	static const float lengths[] = { 0.016f, 0.01f, 0.03f, 0.0f, 0.005f };
	if (step % 20 == 9)
		fixture_circle(world, CN_BODY_DYNAMIC, -5.0f + 0.1f * (float)step, 9.0f, 0.3f, 0.6f, 0.5f);
	if (step % 7 == 6)
		must(cn_world_update(world, 0.025f, NULL), world, "cn_world_update");
	else
		must(cn_world_step(world, lengths[step % 5]), world, "cn_world_step");
}

static void mixed_watch(cn_world *world, uint64_t digests[LOCKSTEP])
{
	int32_t k;
	for (k = 0; k < LOCKSTEP; ++k) {
		mixed_step(world, 50 + k);
		digests[k] = digest_step(0, world);
	}
}

static void t_uneven_and_mixed_worlds_go_on(void)
{
	cn_world *world = mixed_world(), *other = fixture_world(-10.0f, 1);
	uint64_t straight[LOCKSTEP], back[LOCKSTEP], elsewhere[LOCKSTEP], data = 0;
	saved s;
	int32_t k;
	for (k = 0; k < 50; ++k)
		mixed_step(world, k);
	for (k = 0; k < 4; ++k) /* tiles that are flush with the others, not yet seen by any step */
		fixture_box(world, CN_BODY_STATIC, (float)k + 6.0f, -0.5f, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f);
	s = save_world(world);
	mixed_watch(world, straight);
	restore_world(world, &s);
	mixed_watch(world, back);
	restore_world(other, &s);
	must(cn_world_get_user_data(other, &data), other, "cn_world_get_user_data");
	CHECK(data == 1234 && saves_the_same(other, &s));
	mixed_watch(other, elsewhere);
	printf("  steps alike: %d, elsewhere %d\n", (int)same_steps(straight, back), (int)same_steps(straight, elsewhere));
	CHECK(same_steps(straight, back) == LOCKSTEP && same_steps(straight, elsewhere) == LOCKSTEP);
	saved_free(&s);
	cn_world_destroy(world);
	cn_world_destroy(other);
}

/* A ball on a floor, which rolls freely in the save; then the world gets extra rows, as the floor becomes a conveyor. */
static void t_rows_made_since_are_gone(void)
{
	cn_world *world = fixture_world(-10.0f, 1);
	cn_body floor = fixture_floor(world, 0.6f, 0.0f), ball = fixture_circle(world, CN_BODY_DYNAMIC, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f);
	uint64_t straight[LOCKSTEP], back[LOCKSTEP];
	cn_material belt;
	saved s;
	int32_t k;
	fixture_set_velocity(world, ball, 1.0f, 0.0f, 0.0f);
	fixture_step(world, 20);
	s = save_world(world);
	for (k = 0; k < LOCKSTEP; ++k) {
		fixture_step(world, 1);
		straight[k] = digest_step(0, world);
	}
	restore_world(world, &s);
	must(cn_shape_get_material(world, fixture_first_shape(world, floor), &belt), world, "cn_shape_get_material");
	belt.tangent_speed_mps = 3.0f;
	belt.rolling_resistance = 0.1f;
	must(cn_shape_set_material(world, fixture_first_shape(world, floor), &belt), world, "cn_shape_set_material");
	fixture_step(world, 20);
	CHECK_GE("change of speed by the belt", fabs((double)fixture_velocity(world, ball).linear_mps.x - 1.0), 0.1, "m/s");
	restore_world(world, &s);
	for (k = 0; k < LOCKSTEP; ++k) {
		fixture_step(world, 1);
		back[k] = digest_step(0, world);
	}
	CHECK(same_steps(straight, back) == LOCKSTEP);
	saved_free(&s);
	cn_world_destroy(world);
}

/* ---- between the steps ---- */

/* Forces, kicks, pending events, owed time: all that calls have left for the next step. */
static void t_what_calls_have_left_is_saved(void)
{
	cn_world *world = fixture_world(-10.0f, 1);
	cn_body falling, heap[6];
	cn_update_report first, again;
	uint64_t hashes[2];
	saved s;
	int32_t k;
	fixture_floor(world, 0.6f, 0.0f);
	for (k = 0; k < 6; ++k)
		heap[k] = fixture_box(world, CN_BODY_DYNAMIC, 0.0f, 0.5f + (float)k, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f);
	falling = fixture_circle(world, CN_BODY_DYNAMIC, 5.0f, 9.0f, 0.5f, 0.6f, 0.5f);
	fixture_step(world, 30);
	must(cn_world_update(world, 0.024f, NULL), world, "cn_world_update");
	must(cn_body_apply_force(world, falling, 30.0f, 4.0f), world, "cn_body_apply_force");
	must(cn_body_set_velocity(world, heap[5], 3.0f, 0.0f, 1.0f), world, "cn_body_set_velocity");
	must(cn_body_destroy(world, heap[2]), world, "cn_body_destroy");
	s = save_world(world);
	for (k = 0; k < 2; ++k) {
		must(cn_world_update(world, 0.01f, k == 0 ? &first : &again), world, "cn_world_update");
		hashes[k] = digest_step(0, world);
		restore_world(world, &s);
	}
	CHECK(hashes[0] == hashes[1]);
	CHECK(first.steps == 1 && again.steps == 1 && first.leftover_s == again.leftover_s);
	saved_free(&s);
	cn_world_destroy(world);
}

/* ---- handles ---- */

static void t_handles_of_then_are_valid_and_newer_ones_are_not(void)
{
	cn_world *world = fixture_world(-10.0f, 1);
	cn_body kept = fixture_box(world, CN_BODY_DYNAMIC, 0.0f, 1.0f, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f), gone, newer, other;
	cn_shape shape;
	uint64_t data;
	saved s;
	gone = fixture_box(world, CN_BODY_DYNAMIC, 3.0f, 1.0f, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f);
	must(cn_body_set_user_data(world, gone, 77), world, "cn_body_set_user_data");
	must(cn_body_set_name(world, gone, "gone and back"), world, "cn_body_set_name");
	s = save_world(world);
	must(cn_body_destroy(world, gone), world, "cn_body_destroy");
	newer = fixture_box(world, CN_BODY_DYNAMIC, 6.0f, 1.0f, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f);
	shape = fixture_first_shape(world, newer);
	other = fixture_circle(world, CN_BODY_DYNAMIC, 9.0f, 1.0f, 0.5f, 0.6f, 0.0f);
	restore_world(world, &s);
	CHECK(cn_body_is_valid(world, kept) && cn_body_is_valid(world, gone));
	CHECK(cn_body_get_user_data(world, gone, &data) == CN_OK && data == 77);
	CHECK(!cn_body_is_valid(world, newer) && !cn_body_is_valid(world, other) && !cn_shape_is_valid(world, shape));
	/* The same calls give the same handles. */
	must(cn_body_destroy(world, gone), world, "cn_body_destroy");
	CHECK(fixture_box(world, CN_BODY_DYNAMIC, 6.0f, 1.0f, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f) == newer);
	CHECK(fixture_first_shape(world, newer) == shape);
	CHECK(fixture_circle(world, CN_BODY_DYNAMIC, 9.0f, 1.0f, 0.5f, 0.6f, 0.0f) == other);
	saved_free(&s);
	cn_world_destroy(world);
}

/* ---- refusals ---- */

static cn_world *another_world(int32_t broadphase, float length_unit)
{
	cn_world_def def;
	cn_world *world = NULL;
	cn_world_def_init(&def);
	def.broadphase = broadphase;
	def.length_unit_m = length_unit;
	must(cn_world_create(&def, &world), NULL, "cn_world_create");
	fixture_floor(world, 0.6f, 0.0f);
	return world;
}

static void check_refused(cn_world *world, const void *data, uint64_t bytes, cn_result expected)
{
	saved before = save_world(world);
	cn_result result = cn_world_restore(world, data, bytes);
	if (result != expected)
		printf("  %s instead of %s\n", cn_result_text(result), cn_result_text(expected));
	CHECK(result == expected && strlen(cn_world_error_text(world)) > 0);
	CHECK(saves_the_same(world, &before));
	saved_free(&before);
}

static void t_what_is_no_save_is_refused(void)
{
	cn_world *world = fixture_world(-10.0f, 1), *tree = another_world(TREE, 1.0f), *small = another_world(SWEEP, 0.01f);
	saved s;
	uint64_t k;
	uint8_t *bytes;
	fixture_pyramid(world, 5);
	fixture_step(world, 20);
	s = save_world(world);
	bytes = (uint8_t *)s.data;
	check_refused(world, bytes, 0, CN_ERROR_FORMAT);
	check_refused(world, bytes, 39, CN_ERROR_FORMAT);
	check_refused(world, bytes, s.bytes - 1, CN_ERROR_FORMAT);
	check_refused(world, bytes, s.bytes / 2, CN_ERROR_FORMAT);
	CHECK(cn_world_restore(world, NULL, s.bytes) == CN_ERROR_ARGUMENT);
	for (k = 0; k < s.bytes; k += k < 64 ? 1 : 997) {
		if (k >= 4 && k < 16)
			continue; /* what kind of world: refused with CN_ERROR_STATE */
		bytes[k] ^= 0x10u;
		check_refused(world, bytes, s.bytes, CN_ERROR_FORMAT);
		bytes[k] ^= 0x10u;
	}
	check_refused(tree, bytes, s.bytes, CN_ERROR_STATE);
	check_refused(small, bytes, s.bytes, CN_ERROR_STATE);
	CHECK(cn_world_restore(world, bytes, s.bytes) == CN_OK);
	CHECK(cn_world_save(world, bytes, s.bytes - 1, NULL) == CN_ERROR_CAPACITY);
	CHECK(cn_world_save(world, NULL, s.bytes, NULL) == CN_ERROR_ARGUMENT);
	saved_free(&s);
	cn_world_destroy(world);
	cn_world_destroy(tree);
	cn_world_destroy(small);
}

typedef struct asked {
	saved *s;
	int32_t locked, calls;
} asked;

static void on_enter(cn_world *world, const cn_contact_event *event, void *user)
{
	asked *a = (asked *)user;
	uint64_t bytes;
	(void)event;
	++a->calls;
	a->locked += cn_world_save_size(world, &bytes) == CN_ERROR_LOCKED && cn_world_save(world, a->s->data, a->s->bytes, NULL) == CN_ERROR_LOCKED &&
	             cn_world_restore(world, a->s->data, a->s->bytes) == CN_ERROR_LOCKED;
}

static void t_callbacks_neither_save_nor_restore(void)
{
	cn_world *world = fixture_world(-10.0f, 1);
	saved s;
	asked a = { &s, 0, 0 };
	cn_body ball;
	fixture_floor(world, 0.6f, 0.0f);
	ball = fixture_circle(world, CN_BODY_DYNAMIC, 0.0f, 0.6f, 0.5f, 0.6f, 0.0f);
	must(cn_shape_set_event_mask(world, fixture_first_shape(world, ball), 31u), world, "cn_shape_set_event_mask");
	must(cn_world_set_contact_callback(world, CN_EVENT_ENTER, on_enter, &a), world, "cn_world_set_contact_callback");
	s = save_world(world);
	fixture_step(world, 30);
	printf("  %d callbacks, %d were refused\n", (int)a.calls, (int)a.locked);
	CHECK(a.calls > 0 && a.locked == a.calls);
	/* Callbacks stay the world's. */
	restore_world(world, &s);
	fixture_step(world, 30);
	CHECK(a.calls > 1);
	saved_free(&s);
	cn_world_destroy(world);
}

/* ---- memory ---- */

static cn_world *hooked_world(session_hooks *hooks)
{
	cn_world_def def;
	cn_world *world = NULL;
	cn_world_def_init(&def);
	def.alloc = session_alloc;
	def.free = session_free;
	def.allocator_user = hooks;
	must(cn_world_create(&def, &world), NULL, "cn_world_create");
	return world;
}

static void add_long_chain(cn_world *world)
{
	cn_vec2 points[700];
	cn_chain chain = { points, 700, 0 };
	cn_shape_def def = fixture_shape_def(fixture_body(world, CN_BODY_STATIC, 0.0f, -5.0f, 0.0f), 0.6f, 0.0f);
	int32_t k;
	for (k = 0; k < 700; ++k) {
		points[k].x = 35.0f - 0.1f * (float)k;
		points[k].y = 0.02f * (float)(k % 3);
	}
	must(cn_shape_create_chain(world, &def, &chain, NULL), world, "cn_shape_create_chain");
}

/* A world that has nothing of what is restored asks for memory many times; whichever fails, nothing has changed. */
static void t_without_memory_nothing_changes(void)
{
	session_hooks hooks = { 0, 0, 0, 0, 0, 0, 0 }, small_hooks = { 0, 0, 0, 0, 0, 0, 0 };
	cn_world *world = hooked_world(&hooks), *small = hooked_world(&small_hooks);
	saved s, empty;
	int32_t failed = 0;
	fixture_pyramid(world, 8);
	add_long_chain(world);
	fixture_step(world, 30);
	s = save_world(world);
	add_long_chain(small); /* whose chunk is in the way */
	add_long_chain(small);
	empty = save_world(small);
	for (;;) {
		small_hooks.fail_first = small_hooks.calls + 1 + failed; /* rooms that were made stay, so this is farther each time */
		small_hooks.fail_last = INT64_MAX;
		if (cn_world_restore(small, s.data, s.bytes) == CN_OK)
			break;
		small_hooks.fail_first = small_hooks.fail_last = 0;
		REQUIRE(saves_the_same(small, &empty) && fixture_is_valid(small));
		++failed;
		REQUIRE(failed < 200);
	}
	small_hooks.fail_first = small_hooks.fail_last = 0;
	CHECK_GE("allocations that failed", failed, 3, "");
	CHECK(saves_the_same(small, &s) && fixture_is_valid(small));
	fixture_step(small, 60);
	fixture_step(world, 60);
	CHECK(fixture_hash(small) == fixture_hash(world));
	restore_world(small, &empty);
	CHECK(saves_the_same(small, &empty) && fixture_is_valid(small));
	cn_world_destroy(world);
	cn_world_destroy(small);
	CHECK(hooks.pieces == 0 && small_hooks.pieces == 0 && hooks.wrong == 0 && small_hooks.wrong == 0);
	saved_free(&s);
	saved_free(&empty);
}

/* A thousand rollbacks: a world in a caller's block never asks for more, and no other one grows. */
static void t_rollbacks_take_no_memory(void)
{
	const setting in_block = { CN_SOLVER_AUTO, SWEEP, 0, 1 };
	void *block;
	cn_world *world = world_of(scene_find("pyramid"), &in_block, &block);
	cn_memory_stats before, after;
	saved s;
	int32_t k;
	fixture_pyramid(world, 8);
	fixture_step(world, 30);
	s = save_world(world);
	must(cn_world_get_memory_stats(world, &before), world, "cn_world_get_memory_stats");
	for (k = 0; k < 1000; ++k) {
		fixture_step(world, 2);
		restore_world(world, &s);
	}
	must(cn_world_get_memory_stats(world, &after), world, "cn_world_get_memory_stats");
	printf("  %d bytes before, %d after\n", (int)before.bytes_in_use, (int)after.bytes_in_use);
	CHECK(after.bytes_in_use == before.bytes_in_use && after.allocator_calls == before.allocator_calls);
	saved_free(&s);
	cn_world_destroy(world);
	free(block);
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(t_a_restored_world_goes_on_bit_for_bit);
	RUN(t_rolling_back_in_every_step_changes_nothing);
	RUN(t_uneven_and_mixed_worlds_go_on);
	RUN(t_rows_made_since_are_gone);
	RUN(t_what_calls_have_left_is_saved);
	RUN(t_handles_of_then_are_valid_and_newer_ones_are_not);
	RUN(t_what_is_no_save_is_refused);
	RUN(t_callbacks_neither_save_nor_restore);
	RUN(t_without_memory_nothing_changes);
	RUN(t_rollbacks_take_no_memory);
	return test_end();
}
