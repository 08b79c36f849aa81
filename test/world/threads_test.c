/*
 * test/world/threads_test.c - a step with several workers: the same bits with any number of them and any task system,
 * small worlds alone, worlds side by side, nothing left behind.
 */
#include "workers.h"

#include "base/hooks.h"
#include "nets.h"
#include "scenes/scenes.h"

static int32_t workers_of(const cn_world *world)
{
	int32_t count = 0;
	must(cn_world_get_worker_count(world, &count), world, "cn_world_get_worker_count");
	return count;
}

/* A library without threads makes worlds of one worker, whatever is asked for. */
static int32_t has_workers(void)
{
	cn_world_def def;
	cn_world *world = NULL;
	int32_t count;
	cn_world_def_init(&def);
	def.worker_count = 2;
	must(cn_world_create(&def, &world), NULL, "cn_world_create");
	count = workers_of(world);
	cn_world_destroy(world);
	return count == 2;
}

/* ---- a crowd: everything that a contact or a body can be, enough of it to be shared ---- */

static void crowd_walls(cn_world *world)
{
	cn_body wheel = fixture_box(world, CN_BODY_KINEMATIC, 0.0f, 3.0f, 0.3f, 12.0f, 0.5f, 0.5f, 0.8f);
	fixture_floor(world, 0.6f, 0.4f);
	fixture_box(world, CN_BODY_STATIC, -24.0f, 20.0f, 0.0f, 1.0f, 20.0f, 0.5f, 0.9f);
	fixture_box(world, CN_BODY_STATIC, 24.0f, 20.0f, 0.0f, 1.0f, 20.0f, 0.5f, 0.9f);
	fixture_set_velocity(world, wheel, 0.0f, 0.0f, 1.5f);
}

static cn_body crowd_member(cn_world *world, int32_t k, uint32_t *random)
{
	float x = -21.0f + (float)(k % 43), y = 6.0f + (float)(k / 43), restitution = k % 3 == 0 ? 0.7f : 0.0f;
	float jitter = fixture_random(random, -0.1f, 0.1f);
	cn_body body = k % 2 == 0 ? fixture_circle(world, CN_BODY_DYNAMIC, x + jitter, y, 0.4f, 0.5f, restitution)
	                          : fixture_box(world, CN_BODY_DYNAMIC, x + jitter, y, jitter, 0.4f, 0.35f, 0.5f, restitution);
	uint32_t flags = CN_BODY_SLEEP | CN_BODY_ENABLED;
	must(cn_body_get_flags(world, body, &flags), world, "cn_body_get_flags");
	flags |= k % 50 == 7 ? CN_BODY_LOCK_X : 0;
	flags |= k % 50 == 9 ? CN_BODY_BULLET : 0;
	must(cn_body_set_flags(world, body, flags & ~(uint32_t)CN_BODY_AWAKE), world, "cn_body_set_flags");
	if (k % 20 == 3)
		must(cn_body_set_damping(world, body, 0.3f, 0.2f), world, "cn_body_set_damping");
	fixture_set_velocity(world, body, fixture_random(random, -3.0f, 3.0f), k % 40 == 0 ? -60.0f : -6.0f, 0.0f);
	return body;
}

static void crowd_fill(cn_world *world, int32_t count)
{
	uint32_t random = 4711u;
	int32_t k;
	cn_body last = 0;
	crowd_walls(world);
	for (k = 0; k < count; ++k) {
		cn_body body = crowd_member(world, k, &random);
		if (k % 10 == 1)
			hinge(world, last, at(0.5f, 0.0f), body, at(-0.5f, 0.0f));
		last = body;
	}
}

/* Of the hashes of every step. */
static uint64_t run_digest(cn_world *world, int32_t steps)
{
	uint64_t digest = 0;
	int32_t k;
	for (k = 0; k < steps; ++k) {
		fixture_step(world, 1);
		digest = digest_world(digest, world);
	}
	CHECK(fixture_is_valid(world));
	return digest;
}

#define CROWD 1400
#define STEPS TEST_FORM(40, 16, 12)

static uint64_t crowd_digest(const cn_world_def *def, int32_t steps)
{
	cn_world *world = NULL;
	uint64_t digest;
	must(cn_world_create(def, &world), NULL, "cn_world_create");
	crowd_fill(world, CROWD);
	digest = run_digest(world, steps);
	cn_world_destroy(world);
	return digest;
}

static uint64_t scene_digest(const char *name, const cn_world_def *def, int32_t steps)
{
	scene_run run;
	uint64_t digest = 0;
	memset(&run, 0, sizeof run);
	must(scene_open(&run, scene_find(name), def), NULL, name);
	while (run.step_index < steps) {
		scene_step(&run);
		must(run.result, run.world, name);
		digest = digest_world(digest, run.world);
	}
	CHECK(fixture_is_valid(run.world));
	scene_close(&run);
	return digest;
}

static void check_digest(const char *what, int32_t workers, const char *how, uint64_t digest, uint64_t alone)
{
	printf("  %s, %d workers, %s: %016llx, alone %016llx\n", what, (int)workers, how, (unsigned long long)digest, (unsigned long long)alone);
	CHECK(digest == alone);
}

/* ---- the same bits ---- */

static const struct { int32_t solver, broadphase; const char *name; } crowds[] = {
	{ CN_SOLVER_AUTO, CN_BROADPHASE_SWEEP, "crowd" },
	{ CN_SOLVER_SOFT, CN_BROADPHASE_TREE, "crowd on a tree" },
	{ CN_SOLVER_SEQUENTIAL, CN_BROADPHASE_SWEEP, "sequential crowd" },
};
#define CROWDS ((int32_t)(sizeof crowds / sizeof *crowds))

static cn_world_def crowd_def(int32_t crowd)
{
	cn_world_def def;
	cn_world_def_init(&def);
	def.solver = crowds[crowd].solver;
	def.broadphase = crowds[crowd].broadphase;
	return def;
}

static void any_number_of_workers_gives_the_same_bits(void)
{
	int32_t c, w;
	for (c = 0; c < CROWDS; ++c) {
		cn_world_def def = crowd_def(c);
		uint64_t alone = crowd_digest(&def, STEPS);
		for (w = 0; w < WORKER_COUNTS; ++w) {
			def.worker_count = worker_counts[w];
			check_digest(crowds[c].name, worker_counts[w], "own threads", crowd_digest(&def, STEPS), alone);
		}
	}
}

static void scenes_do_not_know_their_workers(void)
{
	static const struct { const char *name; int32_t steps; } scenes[] = {
		{ "pyramid", STEPS / 3 }, { "tumbler_1000", STEPS }, { "rain", STEPS }, { "mixer", STEPS }, { "small_200", STEPS }, { "workshop", STEPS }
	};
	int32_t k, w;
	for (k = 0; k < (int32_t)(sizeof scenes / sizeof *scenes); ++k) {
		cn_world_def def;
		uint64_t alone;
		scene_world_def(scene_find(scenes[k].name), &def);
		alone = scene_digest(scenes[k].name, &def, scenes[k].steps);
		for (w = 0; w < WORKER_COUNTS; ++w) {
			def.worker_count = worker_counts[w];
			check_digest(scenes[k].name, worker_counts[w], "own threads", scene_digest(scenes[k].name, &def, scenes[k].steps), alone);
		}
	}
}

#define NET_SIDE 36

static uint64_t net_digest(const cn_world_def *def, int32_t kind)
{
	cn_world *world = NULL;
	uint64_t digest;
	must(cn_world_create(def, &world), NULL, "cn_world_create");
	net_fill(world, kind, NET_IN_LANES, NET_SIDE, NULL);
	digest = run_digest(world, TEST_FORM(10, 5, 3));
	cn_world_destroy(world);
	return digest;
}

/* Lanes of joints in colours that are shared, some of them to the world and to one moving bar. */
static void nets_do_not_know_their_workers(void)
{
	int32_t kind, w;
	for (kind = 0; kind < NET_KINDS; ++kind) {
		cn_world_def def;
		uint64_t alone;
		cn_world_def_init(&def);
		def.solver = CN_SOLVER_SOFT;
		alone = net_digest(&def, kind);
		for (w = 0; w < WORKER_COUNTS; ++w) {
			def.worker_count = worker_counts[w];
			check_digest(net_name(kind), worker_counts[w], "own threads", net_digest(&def, kind), alone);
		}
	}
}

static void any_task_system_gives_the_same_bits(void)
{
	cn_world_def def = crowd_def(0);
	uint64_t alone = crowd_digest(&def, STEPS / 2);
	int32_t kind, w;
	if (!has_workers())
		SKIP("no threads");
	for (kind = 0; kind < TASKS_KINDS; ++kind)
		for (w = 0; w < WORKER_COUNTS; ++w) {
			tasks system;
			use_tasks(&def, &system, kind);
			def.worker_count = worker_counts[w];
			check_digest("crowd", worker_counts[w], tasks_name(kind), crowd_digest(&def, STEPS / 2), alone);
			CHECK(system.enqueued > 0 && system.wrong == 0 && !system.open);
			CHECK(system.finished == (kind == TASKS_AT_ONCE ? 0 : system.enqueued));
		}
}

/* ---- who pays ---- */

/* Nothing is enqueued for a world of little work, and much less often than there are loops for one of much. */
static void small_worlds_stay_alone(void)
{
	cn_world_def def;
	cn_world *world = NULL;
	tasks system;
	if (!has_workers())
		SKIP("no threads");
	cn_world_def_init(&def);
	use_tasks(&def, &system, TASKS_AT_ONCE);
	def.worker_count = 4;
	must(cn_world_create(&def, &world), NULL, "cn_world_create");
	fixture_step(world, 10);
	crowd_fill(world, 150);
	fixture_step(world, 120);
	printf("  150 bodies: %d tasks in 130 steps\n", (int)system.enqueued);
	CHECK(system.enqueued == 0);
	cn_world_destroy(world);
	must(cn_world_create(&def, &world), NULL, "cn_world_create");
	crowd_fill(world, CROWD);
	fixture_step(world, 60);
	CHECK_GE("tasks a step of a large world", (float)system.enqueued / 60.0f, 1.0f, "");
	CHECK_LE("tasks a step of a large world", (float)system.enqueued / 60.0f, 10.0f, "");
	cn_world_destroy(world);
	def.worker_count = 1;
	use_tasks(&def, &system, TASKS_AT_ONCE);
	must(cn_world_create(&def, &world), NULL, "cn_world_create");
	crowd_fill(world, CROWD);
	fixture_step(world, 10);
	CHECK(system.enqueued == 0);
	cn_world_destroy(world);
}

/* ---- life ---- */

static void worlds_come_and_go(void)
{
	hooks h;
	cn_world_def def;
	int32_t k;
	memset(&h, 0, sizeof h);
	cn_world_def_init(&def);
	def.alloc = hooks_alloc;
	def.free = hooks_free;
	def.allocator_user = &h;
	for (k = 0; k < 200; ++k) {
		cn_world *world = NULL;
		def.worker_count = 2 + k % 4;
		must(cn_world_create(&def, &world), NULL, "cn_world_create");
		CHECK(workers_of(world) == (has_workers() ? def.worker_count : 1));
		if (k % 50 == 0)
			crowd_fill(world, CROWD);
		if (k % 2 == 0)
			fixture_step(world, 2);
		cn_world_destroy(world);
		CHECK(h.pieces == 0);
	}
	CHECK(h.wrong_frees == 0);
}

/* From whichever allocation on memory is out, the world is not made and nothing is left; threads are joined, or they would wake in freed memory. */
static void creation_without_memory_leaves_nothing(void)
{
	hooks h;
	cn_world_def def;
	cn_world *world = NULL;
	int64_t k;
	memset(&h, 0, sizeof h);
	cn_world_def_init(&def);
	def.alloc = hooks_alloc;
	def.free = hooks_free;
	def.allocator_user = &h;
	def.worker_count = 3;
	h.fail_after = 1;
	for (k = 1; k < 1000; ++k) {
		cn_result result;
		h.calls = 0;
		h.fail_at = k;
		result = cn_world_create(&def, &world);
		if (result == CN_OK)
			break;
		CHECK(result == CN_ERROR_MEMORY);
		CHECK(h.pieces == 0);
	}
	printf("  %d allocations\n", (int)k - 1);
	CHECK(k > 1 && k < 1000);
	cn_world_destroy(world);
	CHECK(h.pieces == 0);
}

static void a_world_in_one_block_has_workers_too(void)
{
	cn_world_def def = crowd_def(0);
	uint64_t alone = crowd_digest(&def, STEPS);
	unsigned char *raw;
	def.body_capacity = CROWD + 10;
	def.shape_capacity = CROWD + 10;
	def.contact_capacity = 8 * CROWD;
	def.joint_capacity = CROWD;
	def.worker_count = 8;
	must(cn_world_bytes_needed(&def, &def.memory_bytes), NULL, "cn_world_bytes_needed");
	raw = malloc((size_t)def.memory_bytes + 64);
	REQUIRE(raw != NULL);
	def.memory = raw + (64 - (uintptr_t)raw % 64) % 64;
	check_digest("crowd", def.worker_count, "in one block", crowd_digest(&def, STEPS), alone);
	free(raw);
}

/* ---- worlds side by side ---- */

#ifndef _WIN32
static void *crowd_thread(void *out)
{
	cn_world_def def = crowd_def(0);
	def.worker_count = 2;
	*(uint64_t *)out = crowd_digest(&def, STEPS);
	return NULL;
}

static void two_worlds_on_two_threads_do_not_meet(void)
{
	cn_world_def def = crowd_def(0);
	uint64_t alone = crowd_digest(&def, STEPS), digests[2] = { 0, 0 };
	pthread_t threads[2];
	int32_t k;
	for (k = 0; k < 2; ++k)
		REQUIRE(pthread_create(&threads[k], NULL, crowd_thread, &digests[k]) == 0);
	for (k = 0; k < 2; ++k)
		pthread_join(threads[k], NULL);
	for (k = 0; k < 2; ++k)
		check_digest("crowd", 2, "beside another", digests[k], alone);
}
#endif

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(any_number_of_workers_gives_the_same_bits);
	RUN(scenes_do_not_know_their_workers);
	RUN(nets_do_not_know_their_workers);
	RUN(any_task_system_gives_the_same_bits);
	RUN(small_worlds_stay_alone);
	RUN(worlds_come_and_go);
	RUN(creation_without_memory_leaves_nothing);
	RUN(a_world_in_one_block_has_workers_too);
#ifndef _WIN32
	RUN(two_worlds_on_two_threads_do_not_meet);
#endif
	return test_end();
}
