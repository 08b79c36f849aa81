/*
 * test/world/threads_pairs_test.c - pairs found by several workers: bodies that are thrown about, made and destroyed give the
 * same bits, the same contacts in the same order and the same questions to the user's filter, asked in the calling thread,
 * with any number of workers and any task system, on both broadphases.
 */
#include "workers.h"

#include "nets.h"
#include "scenes/scenes.h"

#define MEMBERS 1800
#define STEPS TEST_FORM(24, 12, 6)
#define SPINNER_STEPS TEST_FORM(4, 2, 2)
#define SIDE_M 34.0f

typedef struct witness {
	uint64_t digest;   /* of what the filter is asked */
	int32_t asked;
	own_thread thread;
} witness;

static int32_t decide(cn_world *world, cn_shape a, cn_shape b, void *user)
{
	witness *w = user;
	cn_shape pair[2] = { a, b };
	(void)world;
	++w->asked;
	own_thread_check(&w->thread);
	w->digest = digest_bytes(w->digest, pair, sizeof pair);
	return (a ^ b) % 5u != 0;
}

/* ---- bodies that are thrown about ---- */

typedef struct swarm {
	cn_world *world;
	cn_body bodies[MEMBERS];
	uint32_t random;
	uint64_t digest;   /* of hashes and of contacts that were made */
	int32_t created;
	witness seen;
} swarm;

static cn_body swarm_member(swarm *s, int32_t k)
{
	float x = fixture_random(&s->random, -SIDE_M, SIDE_M), y = fixture_random(&s->random, 0.5f, SIDE_M);
	cn_body body = fixture_body(s->world, CN_BODY_DYNAMIC, x, y, 0.0f);
	cn_shape_def def = fixture_shape_def(body, 0.4f, 0.1f);
	cn_circle circle = { { 0.0f, 0.0f }, 0.4f };
	cn_shape shape;
	def.event_mask = 1u << CN_EVENT_CREATED;
	def.filter.group = k % 30 < 2 ? -1 : 0; /* some never collide with each other */
	if (k % 3 == 0)
		must(cn_shape_create_circle(s->world, &def, &circle, &shape), s->world, "cn_shape_create_circle");
	else
		fixture_box_shape(s->world, &def, 0.45f, k % 40 == 7 ? 3.0f : 0.35f);
	if (k % 25 == 3) /* two shapes on a body */
		fixture_box_shape(s->world, &def, 0.1f, 0.9f);
	return body;
}

static void swarm_fill(swarm *s)
{
	int32_t k;
	fixture_floor(s->world, 0.6f, 0.2f);
	for (k = 0; k < MEMBERS; ++k) {
		s->bodies[k] = swarm_member(s, k);
		if (k % 10 == 1) /* what a joint holds does not collide */
			hinge(s->world, s->bodies[k - 1], at(0.3f, 0.0f), s->bodies[k], at(-0.3f, 0.0f));
	}
}

static void swarm_throw(swarm *s, int32_t step)
{
	int32_t k;
	for (k = step % 3; k < MEMBERS; k += 3) {
		float x = fixture_random(&s->random, -SIDE_M, SIDE_M), y = fixture_random(&s->random, 0.5f, SIDE_M);
		if (k % 90 == 2) {
			must(cn_body_destroy(s->world, s->bodies[k]), s->world, "cn_body_destroy");
			s->bodies[k] = swarm_member(s, k);
		} else if (k % 10 > 1) {
			must(cn_body_set_pose(s->world, s->bodies[k], x, y, x), s->world, "cn_body_set_pose");
		} else {
			fixture_set_velocity(s->world, s->bodies[k], 10.0f - 20.0f * (float)(k % 2), 5.0f, 1.0f);
		}
	}
}

static void swarm_step(swarm *s)
{
	const cn_contact_event *events = NULL;
	int32_t count = 0;
	fixture_step(s->world, 1);
	must(cn_world_contact_events(s->world, CN_EVENT_CREATED, &events, &count), s->world, "cn_world_contact_events");
	s->created += count;
	s->digest = digest_bytes(digest_world(s->digest, s->world), events, sizeof *events * (size_t)count);
}

static void swarm_run(swarm *s, const cn_world_def *def)
{
	int32_t step;
	memset(s, 0, sizeof *s);
	s->random = 31u;
	own_thread_begin(&s->seen.thread);
	must(cn_world_create(def, &s->world), NULL, "cn_world_create");
	must(cn_world_set_filter_callback(s->world, decide, &s->seen), s->world, "cn_world_set_filter_callback");
	swarm_fill(s);
	for (step = 0; step < STEPS; ++step) {
		swarm_step(s);
		swarm_throw(s, step);
	}
	CHECK(fixture_is_valid(s->world));
	cn_world_destroy(s->world);
}

static void check_swarm(const char *what, const cn_world_def *def, const swarm *alone)
{
	static swarm s;
	swarm_run(&s, def);
	printf("  %s, %d workers: %016llx, %d contacts made, %d asked; alone %016llx\n", what, (int)def->worker_count, (unsigned long long)s.digest, (int)s.created,
	       (int)s.seen.asked, (unsigned long long)alone->digest);
	CHECK(s.digest == alone->digest && s.created == alone->created);
	CHECK(s.seen.digest == alone->seen.digest && s.seen.asked == alone->seen.asked && s.seen.thread.elsewhere == 0);
}

/* With one worker: what all others are compared with. */
static const swarm *swarm_alone(int32_t broadphase)
{
	static swarm sweep, tree;
	swarm *s = broadphase == CN_BROADPHASE_TREE ? &tree : &sweep;
	cn_world_def def;
	cn_world_def_init(&def);
	def.broadphase = broadphase;
	if (s->created == 0)
		swarm_run(s, &def);
	CHECK(s->created > 400 * STEPS && s->seen.asked > s->created && s->seen.thread.elsewhere == 0);
	return s;
}

static void swarm_is_the_same_with_any_workers(int32_t broadphase, const char *what)
{
	cn_world_def def;
	int32_t w;
	cn_world_def_init(&def);
	def.broadphase = broadphase;
	for (w = 0; w < WORKER_COUNTS; ++w) {
		def.worker_count = worker_counts[w];
		check_swarm(what, &def, swarm_alone(broadphase));
	}
}

static void pairs_do_not_know_their_workers(void) { swarm_is_the_same_with_any_workers(CN_BROADPHASE_SWEEP, "sweep"); }
static void nor_those_of_a_tree(void) { swarm_is_the_same_with_any_workers(CN_BROADPHASE_TREE, "tree"); }

static void filters_are_asked_in_their_own_thread(void)
{
	cn_world_def def;
	int32_t kind;
	cn_world_def_init(&def);
	for (kind = 0; kind < TASKS_KINDS; ++kind) {
		tasks system;
		use_tasks(&def, &system, kind);
		def.worker_count = 3;
		check_swarm(tasks_name(kind), &def, swarm_alone(def.broadphase));
		CHECK(system.wrong == 0 && !system.open);
	}
}

/* Both broadphases ask the same questions in the same order. */
static void filters_do_not_know_the_broadphase(void)
{
	const swarm *sweep = swarm_alone(CN_BROADPHASE_SWEEP), *tree = swarm_alone(CN_BROADPHASE_TREE);
	CHECK(sweep->digest == tree->digest && sweep->seen.digest == tree->seen.digest && sweep->seen.asked == tree->seen.asked);
}

/* ---- a drum with an arm: thousands of pairs in every step ---- */

static uint64_t spinner_digest(const cn_world_def *def, int32_t steps)
{
	scene_run run;
	uint64_t digest = 0;
	memset(&run, 0, sizeof run);
	must(scene_open(&run, scene_find("spinner"), def), NULL, "spinner");
	while (run.step_index < steps) {
		scene_step(&run);
		must(run.result, run.world, "spinner");
		digest = digest_world(digest, run.world);
	}
	scene_close(&run);
	return digest;
}

static void spinner_does_not_know_its_workers(void)
{
	cn_world_def def;
	uint64_t alone, digest;
	int32_t w, tree;
	for (tree = 0; tree < 2; ++tree) {
		scene_world_def(scene_find("spinner"), &def);
		def.broadphase = tree ? CN_BROADPHASE_TREE : CN_BROADPHASE_SWEEP;
		alone = spinner_digest(&def, SPINNER_STEPS);
		for (w = TEST_FORM(0, tree, 2); w < WORKER_COUNTS; w += TEST_FORM(1, 2, 2)) {
			def.worker_count = worker_counts[w];
			digest = spinner_digest(&def, SPINNER_STEPS);
			printf("  spinner, %s, %d workers: %016llx, alone %016llx\n", tree ? "tree" : "sweep", (int)def.worker_count, (unsigned long long)digest, (unsigned long long)alone);
			CHECK(digest == alone);
		}
	}
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(pairs_do_not_know_their_workers);
	RUN(nor_those_of_a_tree);
	RUN(filters_are_asked_in_their_own_thread);
	RUN(filters_do_not_know_the_broadphase);
	RUN(spinner_does_not_know_its_workers);
	return test_end();
}
