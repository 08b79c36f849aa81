/*
 * test/world/rolling_test.c - what rolls to and fro keeps its swing: roly-poly toys on the ground and on plates that slide, planks on logs.
 *
 * Each case is a family of random sizes, masses and swings. If one gains or loses energy, look at rolling_advance in model/contact_lane.c and
 * in contacts/manifold_reuse_kernel.h.
 */
#include "fixture.h"

#define TOYS 24
#define TOYS_SKIPPED TEST_FORM(1, 2, 8) /* one in so many runs */
#define FRAMES 1800

enum { ON_GROUND, ON_PLATE, TOY_KINDS };

static cn_world *rolling_world(int32_t solver, int32_t substeps)
{
	cn_world_def def;
	cn_world *world;
	cn_world_def_init(&def);
	def.flags &= ~(uint32_t)CN_WORLD_SLEEP;
	def.solver = solver;
	must(cn_world_create(&def, &world), NULL, "cn_world_create");
	must(cn_world_set_substep_count(world, substeps), world, "cn_world_set_substep_count");
	return world;
}

/* Greatest angle in the last third of so many frames. */
static double late_swing(cn_world *world, cn_body body, int32_t frames)
{
	double most = 0.0;
	int32_t k;
	for (k = 0; k < frames; ++k) {
		fixture_step(world, 1);
		if (k >= frames - frames / 3)
			most = greater(most, fabs(asin((double)fixture_pose(world, body).sine)));
	}
	return most;
}

/* A disc with a weight below its centre. */
static double toy_gain(int32_t kind, int32_t solver, uint32_t *random)
{
	cn_world *world = rolling_world(solver, (int32_t)fixture_random(random, 1.0f, 8.99f));
	float radius = fixture_random(random, 0.2f, 1.0f), angle = fixture_random(random, 0.03f, 0.3f), below = radius * fixture_random(random, 0.2f, 0.7f);
	cn_circle ball = { { 0.0f, 0.0f }, 0.0f }, weight = { { 0.0f, 0.0f }, 0.0f };
	float plate = 0.3f * radius * (float)(kind == ON_PLATE);
	cn_body toy;
	cn_shape_def def;
	double swing;
	fixture_floor(world, kind == ON_PLATE ? 0.0f : 0.9f, 0.0f);
	if (kind == ON_PLATE)
		fixture_box(world, CN_BODY_DYNAMIC, 0.0f, plate, 0.0f, 3.0f, plate, 0.9f, 0.0f);
	toy = fixture_body(world, CN_BODY_DYNAMIC, 0.0f, 2.0f * plate + radius, angle);
	def = fixture_shape_def(toy, 0.9f, 0.0f);
	ball.radius_m = radius;
	weight.center_m.y = -below;
	weight.radius_m = 0.25f * (radius - below);
	must(cn_shape_create_circle(world, &def, &ball, NULL), world, "cn_shape_create_circle");
	def.density_kgpm2 = fixture_random(random, 10.0f, 100.0f);
	must(cn_shape_create_circle(world, &def, &weight, NULL), world, "cn_shape_create_circle");
	swing = late_swing(world, toy, FRAMES);
	cn_world_destroy(world);
	return swing / (double)angle;
}

/* A plank across a fixed log, released with its middle where it would have rolled to. */
static double plank_gain(int32_t solver, uint32_t *random)
{
	cn_world *world = rolling_world(solver, (int32_t)fixture_random(random, 1.0f, 8.99f));
	float radius = fixture_random(random, 0.3f, 1.0f), half = radius * fixture_random(random, 0.03f, 0.15f), angle = fixture_random(random, 0.03f, 0.2f);
	float c = cosf(angle), s = sinf(angle), out = radius + half, along = radius * angle;
	cn_body plank;
	double swing;
	fixture_circle(world, CN_BODY_STATIC, 0.0f, 0.0f, radius, 0.9f, 0.0f);
	plank = fixture_box(world, CN_BODY_DYNAMIC, along * c - out * s, out * c + along * s, angle, 2.0f * radius, half, 0.9f, 0.0f);
	swing = late_swing(world, plank, FRAMES);
	cn_world_destroy(world);
	return swing / (double)angle;
}

/* Draws what toy_gain draws, so that the next toy is the same. */
static void toy_skip(uint32_t *random)
{
	int32_t k;
	for (k = 0; k < 5; ++k)
		(void)fixture_random(random, 0.0f, 1.0f);
}

static void check_gains(const char *what, double least, double most)
{
	printf("  %s\n", what);
	CHECK_GE("late swing / first, the least", least, 0.97, "");
	CHECK_LE("late swing / first, the greatest", most, 1.005, "");
}

static void toys_keep_their_swing(void)
{
	uint32_t random = 1u;
	int32_t kind, k;
	for (kind = 0; kind < TOY_KINDS; ++kind) {
		double least = 1.0, most = 0.0;
		for (k = 0; k < TOYS; ++k) {
			double gain;
			if (k % TOYS_SKIPPED != 0) {
				toy_skip(&random);
				continue;
			}
			gain = toy_gain(kind, k % 3, &random);
			least = gain < least ? gain : least;
			most = greater(most, gain);
		}
		check_gains(kind == ON_PLATE ? "on a plate that slides freely" : "on the ground", least, most);
	}
}

static void planks_on_logs_keep_their_swing(void)
{
	uint32_t random = 1u;
	double least = 1.0, most = 0.0;
	int32_t k;
	for (k = 0; k < TOYS; ++k) {
		double gain = plank_gain(k % 3, &random);
		least = gain < least ? gain : least;
		most = greater(most, gain);
	}
	check_gains("planks on logs", least, most);
}

int main(void)
{
	RUN(toys_keep_their_swing);
	RUN(planks_on_logs_keep_their_swing);
	return test_end();
}
