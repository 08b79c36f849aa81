/*
 * test/world/broadphase_histories_test.c - promise: both broadphases give the same bits after random histories: bodies of all
 * kinds created and destroyed, fixed bodies moved into sleeping piles, teleports and long flights, bullets, explosions, sleep.
 *
 * The broadphases visit boxes in different orders, so a difference is an order that reached the state: look at the callers of
 * cni_broadphase_ops.query and .update outside of broadphase/, and at the first step that differs. If pairs differ, look as
 * world/broadphase_choice_test.c says. `broadphase_histories_test t_soak` runs 1,000 histories of 2,000 steps (make soak).
 */
#include "fixture.h"

#define BODIES_MAX 96
#define FIXED 10
#define SOLVERS 3
#define STEPS_SHORT 200
#define SEEDS_SHORT TEST_FORM(24, 12, 3)

/* One history, played in a world of each broadphase. */
typedef struct history {
	cn_world *world[2];
	uint32_t random;
	cn_body bodies[2][BODIES_MAX]; /* 0: a free place */
	cn_body fixed[2][FIXED];
} history;

static float pick(history *h, float lower, float upper) { return fixture_random(&h->random, lower, upper); }

static int32_t pick_int(history *h, int32_t count)
{
	int32_t k = (int32_t)pick(h, 0.0f, (float)count);
	return k < count ? k : count - 1;
}

/* ---- making bodies ---- */

/* A strip of three edges. */
static void fixed_chain(history *h, int32_t k)
{
	static const cn_vec2 points[4] = { { 2.0f, 0.0f }, { 0.5f, 0.2f }, { -0.5f, 0.2f }, { -2.0f, 0.0f } };
	int32_t w;
	for (w = 0; w < 2; ++w) {
		cn_chain chain = { points, 4, 0 };
		cn_shape_def def;
		h->fixed[w][k] = fixture_body(h->world[w], CN_BODY_STATIC, -3.0f, 0.1f, 0.0f);
		def = fixture_shape_def(h->fixed[w][k], 0.6f, 0.0f);
		must(cn_shape_create_chain(h->world[w], &def, &chain, NULL), h->world[w], "cn_shape_create_chain");
	}
}

/* Tiles of the floor, whose inner corners are seams, and bodies that the history moves. */
static void make_fixed(history *h)
{
	int32_t k, w;
	for (k = 0; k < FIXED; ++k) {
		float x = -12.0f + 4.0f * (float)k;
		for (w = 0; w < 2 && k < 7; ++w)
			h->fixed[w][k] = fixture_box(h->world[w], CN_BODY_STATIC, x, -1.0f, 0.0f, 2.0f, 1.0f, 0.6f, 0.0f);
		for (w = 0; w < 2 && k >= 7 && k < FIXED - 1; ++w)
			h->fixed[w][k] = fixture_box(h->world[w], k == 7 ? CN_BODY_STATIC : CN_BODY_KINEMATIC, 0.0f, 8.0f, 0.0f, 2.0f, 0.2f, 0.6f, 0.0f);
	}
	fixed_chain(h, FIXED - 1);
}

static void body_make(history *h, int32_t k)
{
	float x = pick(h, -10.0f, 10.0f), y = pick(h, 0.5f, 6.0f), size = pick(h, 0.15f, 0.5f), bounce = pick(h, -1.0f, 0.5f), speed = pick(h, -30.0f, 30.0f);
	int32_t round = pick_int(h, 3) == 0, bullet = pick_int(h, 8) == 0, w;
	for (w = 0; w < 2; ++w) {
		cn_world *world = h->world[w];
		cn_body body = round ? fixture_circle(world, CN_BODY_DYNAMIC, x, y, size, 0.5f, bounce > 0.0f ? bounce : 0.0f)
		                     : fixture_box(world, CN_BODY_DYNAMIC, x, y, bounce, size, 0.6f * size, 0.5f, bounce > 0.0f ? bounce : 0.0f);
		if (bullet) {
			must(cn_body_set_flags(world, body, CN_BODY_BULLET | CN_BODY_ENABLED | CN_BODY_SLEEP), world, "cn_body_set_flags");
			fixture_set_velocity(world, body, 5.0f * speed, -speed, 0.0f);
		}
		h->bodies[w][k] = body;
	}
}

static history *history_open(uint32_t seed)
{
	static const int32_t solvers[SOLVERS] = { CN_SOLVER_SOFT, CN_SOLVER_AUTO, CN_SOLVER_SEQUENTIAL };
	history *h = (history *)calloc(1, sizeof *h);
	int32_t w, k;
	h->random = seed * 2654435761u | 1u;
	for (w = 0; w < 2; ++w) {
		cn_world_def def;
		cn_world_def_init(&def);
		def.broadphase = w == 0 ? CN_BROADPHASE_SWEEP : CN_BROADPHASE_TREE;
		def.solver = solvers[seed % 4 < 2 ? 0 : seed % SOLVERS];
		must(cn_world_create(&def, &h->world[w]), NULL, "cn_world_create");
	}
	make_fixed(h);
	for (k = 0; k < BODIES_MAX / 2; ++k)
		body_make(h, k);
	return h;
}

static void history_close(history *h)
{
	cn_world_destroy(h->world[0]);
	cn_world_destroy(h->world[1]);
	free(h);
}

/* ---- changes ---- */

static void body_change(history *h, int32_t k)
{
	int32_t w;
	if (h->bodies[0][k] == 0) {
		body_make(h, k);
		return;
	}
	for (w = 0; w < 2; ++w) {
		must(cn_body_destroy(h->world[w], h->bodies[w][k]), h->world[w], "cn_body_destroy");
		h->bodies[w][k] = 0;
	}
}

static void body_teleport(history *h, int32_t k)
{
	int32_t far = pick_int(h, 3) == 0, w;
	float x = pick(h, -9.0f, 9.0f) * (far ? 1000.0f : 1.0f), y = pick(h, 0.0f, 8.0f), vx = pick(h, -80.0f, 80.0f);
	for (w = 0; w < 2 && h->bodies[w][k] != 0; ++w) {
		must(cn_body_set_pose(h->world[w], h->bodies[w][k], x, y, vx), h->world[w], "cn_body_set_pose");
		fixture_set_velocity(h->world[w], h->bodies[w][k], far ? 50.0f * vx : vx, 0.0f, 0.0f);
	}
}

/* Moves a fixed body into what sleeps there. */
static void fixed_teleport(history *h)
{
	int32_t k = 7 + pick_int(h, FIXED - 7), w;
	float x = pick(h, -8.0f, 8.0f), y = pick(h, 0.0f, 1.5f), angle = pick(h, -0.3f, 0.3f);
	for (w = 0; w < 2; ++w)
		must(cn_body_set_pose(h->world[w], h->fixed[w][k], x, y, angle), h->world[w], "cn_body_set_pose");
}

static void explode(history *h)
{
	cn_explosion_def def;
	int32_t w;
	cn_explosion_def_init(&def);
	def.center_m.x = pick(h, -8.0f, 8.0f);
	def.center_m.y = pick(h, -0.5f, 2.0f);
	def.radius_m = pick(h, 0.5f, 3.0f);
	def.impulse_Nspm = pick(h, 1.0f, 8.0f);
	for (w = 0; w < 2; ++w)
		must(cn_world_explode(h->world[w], &def), h->world[w], "cn_world_explode");
}

/* Bursts of changes with time to fall asleep between them. */
static void history_change(history *h, int32_t step)
{
	int32_t what = pick_int(h, 16), k = pick_int(h, BODIES_MAX);
	if (step % 160 > 60 && what > 0)
		return;
	if (what < 3)
		fixed_teleport(h);
	else if (what < 7)
		body_change(h, k);
	else if (what < 10)
		body_teleport(h, k);
	else if (what == 10)
		explode(h);
}

/* First step after which the worlds differ, or `steps`. */
static int32_t history_run(uint32_t seed, int32_t steps)
{
	history *h = history_open(seed);
	int32_t step;
	for (step = 0; step < steps; ++step) {
		history_change(h, step);
		fixture_step(h->world[0], 1);
		fixture_step(h->world[1], 1);
		if (fixture_hash(h->world[0]) != fixture_hash(h->world[1]))
			break;
	}
	if (step < steps)
		printf("  seed %u differs after step %d\n", seed, step);
	history_close(h);
	return step;
}

static void histories_run(uint32_t seeds, int32_t steps)
{
	uint32_t seed, different = 0;
	for (seed = 1; seed <= seeds; ++seed)
		different += history_run(seed, steps) < steps;
	printf("  %u histories of %d steps\n", seeds, steps);
	CHECK_LE("histories whose bits depend on the broadphase", different, 0, "");
}

static void t_histories(void) { histories_run(SEEDS_SHORT, STEPS_SHORT); }
static void t_soak_histories(void) { histories_run(1000, 2000); }

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(t_histories);
	RUN_WHEN_NAMED(t_soak_histories);
	return test_end();
}
