/*
 * test/world/soak_test.c - promises under load: years of creation and destruction take no more memory than the first minutes; many small
 * worlds on two threads, 2,000 shapes on a body and 100,000 bodies neither hang nor leave numbers that are none; a body whose forces
 * no float can hold stops, the step says so, and the others go on.
 *
 * Short forms run in make test. `soak_test t_soak` runs an hour of simulated churn and 100,000 bodies (make soak). If it fails: memory in
 * base/handles.c, base/blocks.c, the free lists of model/; validation where cn_world_validate says; numbers in step/integrate.c.
 */
#include "workers.h"

#include "joints.h"

#define BODIES 60
#define JOINTS 40

/* ---- churn ---- */

typedef struct churn {
	cn_world *world;
	cn_body bodies[BODIES];
	cn_joint joints[JOINTS];
	uint32_t random;
	int64_t made, broken;
	int32_t invalid, refused;
} churn;

static float draw(churn *c, float lower, float upper) { return fixture_random(&c->random, lower, upper); }

static int32_t draw_int(churn *c, int32_t count)
{
	int32_t k = (int32_t)draw(c, 0.0f, (float)count);
	return k < count ? k : count - 1;
}

static void churn_body(churn *c, int32_t k)
{
	float x = draw(c, -8.0f, 8.0f), y = draw(c, 0.5f, 12.0f), size = draw(c, 0.1f, 0.5f);
	if (c->bodies[k] != 0)
		must(cn_body_destroy(c->world, c->bodies[k]), c->world, "cn_body_destroy");
	c->bodies[k] = draw_int(c, 2) ? fixture_circle(c->world, CN_BODY_DYNAMIC, x, y, size, 0.5f, 0.2f)
	                              : fixture_box(c->world, CN_BODY_DYNAMIC, x, y, x, size, 0.7f * size, 0.5f, 0.1f);
	++c->made;
}

/* A joint that breaks, with a body of the next place. */
static void churn_joint(churn *c, int32_t k)
{
	int32_t a = draw_int(c, BODIES), b = (a + 1) % BODIES;
	cn_revolute_def def;
	if (c->joints[k] != 0 && cn_joint_is_valid(c->world, c->joints[k]))
		must(cn_joint_destroy(c->world, c->joints[k]), c->world, "cn_joint_destroy");
	c->joints[k] = 0;
	if (c->bodies[a] == 0 || c->bodies[b] == 0)
		return;
	cn_revolute_def_init(&def);
	def.base.body_a = c->bodies[a];
	def.base.body_b = c->bodies[b];
	def.base.anchor_a_m = at(0.6f, 0.0f);
	def.base.anchor_b_m = at(-0.6f, 0.0f);
	def.base.flags |= CN_JOINT_BREAKS;
	def.base.break_force_N = 60.0f;
	must(cn_joint_create_revolute(c->world, &def, &c->joints[k]), c->world, "cn_joint_create_revolute");
}

/* Bursts, with time to fall asleep between them. */
static void churn_change(churn *c, int32_t step)
{
	int32_t k;
	if (step % 240 >= 120)
		return;
	churn_body(c, draw_int(c, BODIES));
	if (step % 3 == 0)
		churn_joint(c, draw_int(c, JOINTS));
	k = draw_int(c, BODIES);
	if (step % 10 == 0 && c->bodies[k] != 0)
		must(cn_body_set_pose(c->world, c->bodies[k], draw(c, -8.0f, 8.0f), 3.0f, 0.0f), c->world, "cn_body_set_pose");
}

static void churn_step(churn *c, int32_t step, int32_t validate_every)
{
	const cn_joint_event *events = NULL;
	int32_t count = 0;
	churn_change(c, step);
	fixture_step(c->world, 1);
	must(cn_world_joint_events(c->world, &events, &count), c->world, "cn_world_joint_events");
	c->broken += count;
	c->invalid += step % validate_every == 0 && !fixture_is_valid(c->world);
}

static cn_memory_stats churn_memory(const churn *c)
{
	cn_memory_stats stats;
	must(cn_world_get_memory_stats(c->world, &stats), c->world, "cn_world_get_memory_stats");
	return stats;
}

/* Destroys everything but the floor, and takes a step in which queues of destroyed objects are emptied. */
static void churn_empty(churn *c)
{
	int32_t k;
	for (k = 0; k < BODIES; ++k)
		if (c->bodies[k] != 0)
			must(cn_body_destroy(c->world, c->bodies[k]), c->world, "cn_body_destroy");
	memset(c->bodies, 0, sizeof c->bodies);
	memset(c->joints, 0, sizeof c->joints);
	fixture_step(c->world, 1);
}

/*
 * Parts of equal length, after each of which the world is emptied. What is handed out in pieces is then the same to the byte. Arrays keep the size
 * of the most that they held: at most twice that of the first part, as they double, and as no part holds more than twice as much. How much a
 * part needs is chance. In part k an array sets a record with probability 1 / k (Renyi, 1962), and any of five with 1 - (1 - 1 / k)^5: on the
 * average 3 of the last 10 of 20 parts, and 8 or more in one of 300 runs; 3 of the last 20 of 40; with a leak each does.
 */
static void churn_run(int32_t solver, int32_t steps, int32_t parts, int32_t validate_every)
{
	static churn c;
	uint64_t peak = 0, most = 0, pieces = 0, used;
	int32_t step, part, records = 0;
	cn_world_def def;
	memset(&c, 0, sizeof c);
	c.random = 7u;
	cn_world_def_init(&def);
	def.solver = solver;
	must(cn_world_create(&def, &c.world), NULL, "cn_world_create");
	fixture_floor(c.world, 0.6f, 0.0f);
	for (part = 0; part < parts; ++part) {
		for (step = 0; step < steps / parts; ++step)
			churn_step(&c, step, validate_every);
		churn_empty(&c);
		used = churn_memory(&c).bytes_in_use;
		if (part == 0) {
			peak = churn_memory(&c).bytes_peak;
			pieces = churn_memory(&c).blocks_in_use;
		}
		CHECK(churn_memory(&c).blocks_in_use == pieces);
		records += 2 * part >= parts && used > most;
		most = used > most ? used : most;
	}
	printf("  %d steps: %lld bodies made, %lld joints broken, %llu bytes\n", (int)steps, (long long)c.made, (long long)c.broken, (unsigned long long)most);
	CHECK_LE("invalid states", c.invalid, 0, "");
	CHECK_LE("parts of the last half that need more than all before", records, 3 * parts / 8, "");
	CHECK_LE("peak of memory over that of the first part", (double)churn_memory(&c).bytes_peak / (double)peak, 2.0, "");
	CHECK(c.broken > 0);
	cn_world_destroy(c.world);
}

static void t_churn(void) { churn_run(CN_SOLVER_AUTO, 2400, 20, 60); }

static void t_soak_an_hour_of_churn(void)
{
	churn_run(CN_SOLVER_AUTO, 216000, 40, 600);
	churn_run(CN_SOLVER_SOFT, 216000, 40, 600);
}

/* ---- many worlds ---- */

#define WORLDS_MOST 1000

typedef struct flock {
	cn_world *worlds[WORLDS_MOST];
	int32_t count, steps;
} flock;

/* One of two threads steps the even worlds, the other the odd ones. */
static void flock_range(int32_t begin, int32_t end, void *context)
{
	const flock *f = (const flock *)context;
	int32_t k;
	for (; begin < end; ++begin)
		for (k = begin; k < f->count; k += 2)
			fixture_step(f->worlds[k], f->steps);
}

static uint64_t flock_run(int32_t count, int32_t steps, tasks *system)
{
	static flock f;
	uint64_t digest = 0;
	int32_t k, i;
	f.count = count;
	f.steps = steps;
	for (k = 0; k < count; ++k) {
		f.worlds[k] = fixture_world(-10.0f, 1);
		fixture_floor(f.worlds[k], 0.5f, 0.0f);
		for (i = 0; i < 8; ++i)
			fixture_box(f.worlds[k], CN_BODY_DYNAMIC, 0.01f * (float)(k % 7), 0.6f + 1.1f * (float)i, 0.1f, 0.5f, 0.5f, 0.5f, 0.0f);
	}
	if (system == NULL)
		flock_range(0, 2, &f);
	else
		tasks_finish(tasks_enqueue(flock_range, &f, 2, 1, system), system);
	for (k = 0; k < count; ++k) {
		digest = digest_world(digest, f.worlds[k]);
		cn_world_destroy(f.worlds[k]);
	}
	return digest;
}

static void worlds_on_threads(int32_t count, int32_t steps)
{
	tasks system;
	memset(&system, 0, sizeof system);
	system.kind = TASKS_ON_THREADS;
	CHECK(flock_run(count, steps, NULL) == flock_run(count, steps, &system));
}

static void t_small_worlds_on_threads(void) { worlds_on_threads(60, 10); }
static void t_soak_small_worlds_on_threads(void) { worlds_on_threads(WORLDS_MOST, 300); }

/* ---- large numbers ---- */

static int32_t is_finite_body(const cn_world *world, cn_body body)
{
	cn_pose p = fixture_pose(world, body);
	cn_velocity v = fixture_velocity(world, body);
	return isfinite(p.position_m.x + p.position_m.y + p.cosine + p.sine + v.linear_mps.x + v.linear_mps.y + v.angular_radps);
}

/* A bar of 2,000 overlapping boxes falls on three balls. */
static void t_many_shapes_on_a_body(void)
{
	cn_world *world = fixture_world(-10.0f, 1);
	cn_body body;
	int32_t k;
	fixture_floor(world, 0.5f, 0.0f);
	body = fixture_body(world, CN_BODY_DYNAMIC, 0.0f, 2.5f, 0.0f);
	for (k = 0; k < 2000; ++k) {
		cn_shape_def def = fixture_shape_def(body, 0.5f, 0.0f);
		must(cn_shape_create_box(world, &def, 0.5f, 0.5f, 0.0f, NULL), world, "cn_shape_create_box");
	}
	for (k = 0; k < 3; ++k)
		fixture_circle(world, CN_BODY_DYNAMIC, (float)k - 1.0f, 0.5f, 0.5f, 0.5f, 0.0f);
	fixture_step(world, 60);
	CHECK(is_finite_body(world, body));
	CHECK(fixture_counters(world).warnings == 0);
	CHECK_GE("height of the body", fixture_pose(world, body).position_m.y, 0.4, "m");
	CHECK(fixture_is_valid(world));
	cn_world_destroy(world);
}

static void t_soak_a_hundred_thousand_bodies(void)
{
	cn_world *world = fixture_world(-10.0f, 1);
	cn_body body = 0;
	int32_t k, finite = 1;
	fixture_box(world, CN_BODY_STATIC, 0.0f, -1.0f, 0.0f, 2000.0f, 1.0f, 0.5f, 0.0f);
	for (k = 0; k < 100000; ++k) {
		body = k % 3 ? fixture_box(world, CN_BODY_DYNAMIC, (float)(k % 1000) - 500.0f, 0.5f + (float)(k / 1000), 0.01f, 0.45f, 0.45f, 0.5f, 0.0f)
		             : fixture_circle(world, CN_BODY_DYNAMIC, (float)(k % 1000) - 500.0f, 0.5f + (float)(k / 1000), 0.45f, 0.5f, 0.0f);
		if (k % 997 == 0)
			fixture_set_velocity(world, body, 50.0f, 10.0f, 5.0f);
	}
	for (k = 0; k < 120 && finite; ++k) {
		fixture_step(world, 1);
		finite = is_finite_body(world, body);
	}
	CHECK(finite && fixture_is_valid(world));
	CHECK((fixture_counters(world).warnings & ~(uint32_t)CN_WARNING_CROWD) == 0);
	cn_world_destroy(world);
}

/* ---- forces that no float can hold ---- */

static void t_a_body_with_absurd_forces_stops_alone(void)
{
	cn_world *world = fixture_world(-10.0f, 1);
	cn_body heavy, ball, light;
	cn_shape_def def;
	cn_circle circle = { { 0.0f, 0.0f }, 0.1f };
	uint32_t warned = 0;
	int32_t k;
	fixture_floor(world, 0.5f, 0.0f);
	light = fixture_body(world, CN_BODY_DYNAMIC, 0.0f, 5.0f, 0.0f);
	def = fixture_shape_def(light, 0.5f, 0.0f);
	def.density_kgpm2 = 1e-6f;
	must(cn_shape_create_circle(world, &def, &circle, NULL), world, "cn_shape_create_circle");
	ball = fixture_circle(world, CN_BODY_DYNAMIC, 20.0f, 5.0f, 0.5f, 0.5f, 0.0f);
	heavy = fixture_box(world, CN_BODY_DYNAMIC, 30.0f, 0.5f, 0.0f, 0.5f, 0.5f, 0.5f, 0.0f);
	for (k = 0; k < 120; ++k) {
		must(cn_body_apply_force(world, light, 3e38f, -1e38f), world, "cn_body_apply_force");
		CHECK(k > 0 || cn_body_apply_force(world, light, 3e38f, 0.0f) == CN_ERROR_ARGUMENT);
		fixture_step(world, 1);
		warned += (fixture_counters(world).warnings & CN_WARNING_NOT_FINITE) != 0;
	}
	CHECK(is_finite_body(world, light) && is_finite_body(world, ball) && is_finite_body(world, heavy));
	CHECK_GE("steps that report it", warned, 120, "");
	CHECK_LE("height of a ball that fell beside it", fabs((double)fixture_pose(world, ball).position_m.y - 0.5), 0.01, "m");
	CHECK(fixture_is_valid(world));
	fixture_step(world, 1);
	CHECK((fixture_counters(world).warnings & CN_WARNING_NOT_FINITE) == 0);
	cn_world_destroy(world);
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(t_churn);
	RUN(t_small_worlds_on_threads);
	RUN(t_many_shapes_on_a_body);
	RUN(t_a_body_with_absurd_forces_stops_alone);
	RUN_WHEN_NAMED(t_soak_an_hour_of_churn);
	RUN_WHEN_NAMED(t_soak_small_worlds_on_threads);
	RUN_WHEN_NAMED(t_soak_a_hundred_thousand_bodies);
	return test_end();
}
