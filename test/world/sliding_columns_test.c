/*
 * test/world/sliding_columns_test.c - columns of boxes of unlike masses that slide are not thrown: friction stops what slides no faster than Coulomb's
 * law lets it.
 *
 * If it fails, look at is_jammed and set_is_wrong in direct/direct_contacts.c.
 */
#include "direct.h"

enum { COLUMN = 5 };

/* A column of boxes of densities of 1 to 100 slides on the ground at 4 to 20 m/s. Returns the greatest change of its momentum in a step, in that of
   its weight. */
static double sliding_column_run(int32_t solver, int32_t rate, uint32_t seed)
{
	scene s = scene_open(GRAVITY, 0, solver);
	uint32_t random = 2654435761u * seed;
	float friction = fixture_random(&random, 0.4f, 0.8f), speed = fixture_random(&random, 4.0f, 20.0f);
	double mass = 0.0, most = 0.0;
	totals before, after;
	int32_t k;
	fixture_box(s.world, CN_BODY_STATIC, 0.0f, -0.5f, 0.0f, 50.0f, 0.5f, friction, 0.0f);
	for (k = 0; k < COLUMN; ++k) {
		float m = powf(100.0f, fixture_random(&random, 0.0f, 1.0f));
		mass += (double)m;
		weighing(&s, fixture_box(s.world, CN_BODY_DYNAMIC, 0.0f, 0.2f + 0.4f * (float)k, 0.0f, 0.8f, 0.2f, friction, 0.0f), m);
		fixture_set_velocity(s.world, last_body(&s), -speed, 0.0f, 0.0f);
	}
	before = totals_in(&s);
	for (k = 0; k < 3 * rate / 10; ++k, before = after) {
		must(cn_world_step(s.world, 1.0f / (float)rate), s.world, "cn_world_step");
		after = totals_in(&s);
		most = greater(most, hypot(after.px - before.px, after.py - before.py));
	}
	scene_close(&s);
	return most / (mass * GRAVITY / (double)rate);
}

/* Friction that stops the lowest box at once, and presses the others onto it, obeys Coulomb's law: it turned columns about their front edge as one
   block, in a step. */
static void sliding_columns_are_not_thrown(void)
{
	static const int32_t rates[] = { 30, 60, 120 };
	const int32_t seeds = 200;
	int32_t k, seed;
	for (k = 0; k < 3; ++k) {
		double direct = 0.0, soft = 0.0;
		for (seed = 1; seed <= seeds; ++seed) {
			direct = greater(direct, sliding_column_run(CN_SOLVER_AUTO, rates[k], (uint32_t)seed));
			soft = greater(soft, sliding_column_run(CN_SOLVER_SOFT, rates[k], (uint32_t)seed));
		}
		printf("  %d steps a second, with soft constraints %.2f\n", (int)rates[k], soft);
		CHECK_LE("greatest change of momentum in a step", direct, 6.0, "of that of the weight");
	}
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(sliding_columns_are_not_thrown);
	return test_end();
}
