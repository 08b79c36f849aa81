/*
 * test/world/threads_contacts_test.c - the narrowphase shared among workers: a tub in which every kind of contact begins,
 * ends and changes in each step gives the same bits, the same events in the same order and the same questions to the
 * user, asked in the calling thread, with any number of workers.
 */
#include "workers.h"

#define MEMBERS 1100
#define COLUMNS 50
#define STEPS TEST_FORM(50, 21, 18)
#define FIRST_CONVEYOR_STEP 15 /* contacts have no extra rows before */

/* What the user is asked, and what it sees then. */
typedef struct witness {
	uint64_t digest;
	int32_t asked, mixed;
	own_thread thread;
} witness;

/* Lets some pass, and looks at the other contacts of a body, which may have been looked at before or not. */
static int32_t ask(cn_world *world, const cn_contact_event *event, void *user)
{
	witness *w = user;
	cn_contact_event others[8];
	int32_t count = 0;
	++w->asked;
	own_thread_check(&w->thread);
	must(cn_body_get_contacts(world, event->body_a, others, 8, &count), world, "cn_body_get_contacts");
	w->digest = digest_bytes(w->digest, event, sizeof *event);
	w->digest = digest_bytes(w->digest, others, sizeof *others * (size_t)(count < 8 ? count : 8));
	return event->contact_id % 5u != 0;
}

static void mix(cn_world *world, cn_shape a, cn_shape b, cn_material *mixed, void *user)
{
	witness *w = user;
	(void)world;
	++w->mixed;
	own_thread_check(&w->thread);
	w->digest = digest_bytes(digest_bytes(w->digest, &a, sizeof a), &b, sizeof b);
	mixed->restitution *= 0.9f;
}

/* ---- the tub ---- */

static void tub_walls(cn_world *world)
{
	cn_body wheel = fixture_box(world, CN_BODY_KINEMATIC, 0.0f, 4.0f, 0.3f, 14.0f, 0.4f, 0.5f, 0.3f);
	int32_t k;
	fixture_floor(world, 0.6f, 0.2f);
	fixture_box(world, CN_BODY_STATIC, -28.0f, 20.0f, 0.0f, 1.0f, 20.0f, 0.5f, 0.4f);
	fixture_box(world, CN_BODY_STATIC, 28.0f, 20.0f, 0.0f, 1.0f, 20.0f, 0.5f, 0.4f);
	fixture_set_velocity(world, wheel, 0.0f, 0.0f, 1.5f);
	for (k = 0; k < 6; ++k) {
		cn_body platform = fixture_body(world, CN_BODY_STATIC, -20.0f + 8.0f * (float)k, 10.0f, 0.0f);
		cn_shape_def def = fixture_shape_def(platform, 0.3f, 0.0f);
		def.flags = CN_SHAPE_ONE_WAY;
		fixture_box_shape(world, &def, 2.0f, 0.1f);
	}
}

static cn_shape tub_member(cn_world *world, int32_t k, uint32_t *random)
{
	float jitter = fixture_random(random, -0.1f, 0.1f);
	cn_body body = fixture_body(world, CN_BODY_DYNAMIC, -24.5f + (float)(k % COLUMNS) + jitter, 6.0f + 0.95f * (float)(k / COLUMNS), jitter);
	cn_shape_def def = fixture_shape_def(body, 0.4f, k % 4 == 0 ? 0.5f : 0.0f);
	cn_circle circle = { { 0.0f, 0.0f }, 0.4f };
	float vx, vy;
	uint32_t flags = 0;
	cn_shape shape = 0;
	def.event_mask = (1u << CN_EVENT_KINDS) - 1u;
	def.flags = (k % 7 == 3 ? CN_SHAPE_PRE_SOLVE : 0u) | (k % 31 == 5 ? (uint32_t)CN_SHAPE_SENSOR : 0u);
	if (k % 3 == 0)
		must(cn_shape_create_circle(world, &def, &circle, &shape), world, "cn_shape_create_circle");
	else
		shape = fixture_box_shape(world, &def, 0.42f, 0.3f);
	must(cn_body_get_flags(world, body, &flags), world, "cn_body_get_flags");
	flags |= (k % 40 == 9 ? (uint32_t)CN_BODY_LOCK_X : 0u) | (k % 60 == 11 ? (uint32_t)CN_BODY_LOCK_Y : 0u);
	must(cn_body_set_flags(world, body, flags), world, "cn_body_set_flags");
	vx = fixture_random(random, -4.0f, 4.0f);
	vy = fixture_random(random, -30.0f, 0.0f);
	fixture_set_velocity(world, body, vx, vy, fixture_random(random, -5.0f, 5.0f));
	return shape;
}

/* Materials of some change in each step; later some become conveyors, and the first extra rows are needed. */
static void materials_change(cn_world *world, const cn_shape *shapes, int32_t step)
{
	int32_t k;
	for (k = step % 37; k < MEMBERS; k += 37) {
		cn_material m;
		must(cn_shape_get_material(world, shapes[k], &m), world, "cn_shape_get_material");
		m.dynamic_friction = 0.1f * (float)(step % 5);
		m.tangent_speed_mps = step >= FIRST_CONVEYOR_STEP && k % 2 == 0 ? 1.0f : 0.0f;
		must(cn_shape_set_material(world, shapes[k], &m), world, "cn_shape_set_material");
	}
}

/* Order, contacts and manifolds of all events of the step. */
static uint64_t digest_events(cn_world *world, uint64_t digest, int32_t *total)
{
	const cn_sensor_event *seen = NULL;
	int32_t kind, count = 0;
	for (kind = 0; kind < CN_EVENT_KINDS; ++kind) {
		const cn_contact_event *events = NULL;
		must(cn_world_contact_events(world, kind, &events, &count), world, "cn_world_contact_events");
		digest = digest_bytes(digest, events, sizeof *events * (size_t)count);
		*total += count;
	}
	must(cn_world_sensor_events(world, &seen, &count), world, "cn_world_sensor_events");
	*total += count;
	return digest_bytes(digest, seen, sizeof *seen * (size_t)count);
}

typedef struct outcome {
	uint64_t digest;  /* of hashes and events */
	int32_t events;
	witness seen;
} outcome;

static outcome tub_run(const cn_world_def *def)
{
	static cn_shape shapes[MEMBERS];
	cn_world *world = NULL;
	uint32_t random = 20u;
	int32_t k;
	outcome o;
	memset(&o, 0, sizeof o);
	own_thread_begin(&o.seen.thread);
	must(cn_world_create(def, &world), NULL, "cn_world_create");
	must(cn_world_set_pre_solve_callback(world, ask, &o.seen), world, "cn_world_set_pre_solve_callback");
	must(cn_world_set_material_mix_callback(world, mix, &o.seen), world, "cn_world_set_material_mix_callback");
	tub_walls(world);
	for (k = 0; k < MEMBERS; ++k)
		shapes[k] = tub_member(world, k, &random);
	for (k = 0; k < STEPS; ++k) {
		materials_change(world, shapes, k);
		fixture_step(world, 1);
		o.digest = digest_events(world, digest_world(o.digest, world), &o.events);
	}
	CHECK(fixture_is_valid(world));
	cn_world_destroy(world);
	return o;
}

static void check_outcome(const char *what, int32_t workers, const outcome *o, const outcome *alone)
{
	printf("  %s, %d workers: %016llx, %d events, %d asked, %d mixed; alone %016llx\n", what, (int)workers, (unsigned long long)o->digest, (int)o->events,
	       (int)o->seen.asked, (int)o->seen.mixed, (unsigned long long)alone->digest);
	CHECK(o->digest == alone->digest && o->events == alone->events);
	CHECK(o->seen.digest == alone->seen.digest && o->seen.asked == alone->seen.asked && o->seen.mixed == alone->seen.mixed);
	CHECK(o->seen.thread.elsewhere == 0);
}

/* With one worker: what all others are compared with. */
static outcome tub_alone(int32_t solver)
{
	static outcome known[2];
	outcome *o = &known[solver == CN_SOLVER_SEQUENTIAL];
	cn_world_def def;
	cn_world_def_init(&def);
	def.solver = solver;
	if (o->events == 0)
		*o = tub_run(&def);
	CHECK(o->events > 200 * STEPS && o->seen.asked > 20 * STEPS && o->seen.mixed > 20 * STEPS);
	return *o;
}

static void tub_is_the_same_with_any_workers(int32_t solver, const char *what)
{
	cn_world_def def;
	outcome alone = tub_alone(solver), shared;
	int32_t w;
	cn_world_def_init(&def);
	def.solver = solver;
	for (w = 0; w < WORKER_COUNTS; ++w) {
		def.worker_count = worker_counts[w];
		shared = tub_run(&def);
		check_outcome(what, worker_counts[w], &shared, &alone);
	}
}

static void contacts_do_not_know_their_workers(void) { tub_is_the_same_with_any_workers(CN_SOLVER_AUTO, "tub"); }
static void nor_with_the_sequential_solver(void) { tub_is_the_same_with_any_workers(CN_SOLVER_SEQUENTIAL, "sequential tub"); }

static void users_are_asked_in_their_own_thread(void)
{
	cn_world_def def;
	outcome alone, shared;
	int32_t kind;
	cn_world_def_init(&def);
	alone = tub_alone(def.solver);
	for (kind = 0; kind < TASKS_KINDS; ++kind) {
		tasks system;
		use_tasks(&def, &system, kind);
		def.worker_count = 3;
		shared = tub_run(&def);
		check_outcome(tasks_name(kind), 3, &shared, &alone);
		CHECK(system.wrong == 0 && !system.open);
	}
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(contacts_do_not_know_their_workers);
	RUN(nor_with_the_sequential_solver);
	RUN(users_are_asked_in_their_own_thread);
	return test_end();
}
