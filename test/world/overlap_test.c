/*
 * overlap_test - promises: heaps that were poured between two walls come to rest without overlaps, and fall asleep; what is too long to lie
 * between two walls is not pushed through one of them; heaps of short chains fall asleep.
 *
 * If a test here fails, look in step/overlap_projection.c; if the last one fails, at body_accelerates in step/finalize.c.
 */
#include "fixture.h"
#include "joints.h"

#define BODIES 100
#define HALF_WIDTH 2.4f
#define KINDS 4
#define SEEDS TEST_FORM(3, 2, 1)

static void walls(cn_world *world, float half_width)
{
	fixture_floor(world, 0.7f, 0.0f);
	fixture_box(world, CN_BODY_STATIC, -half_width - 0.5f, 40.0f, 0.0f, 0.5f, 40.0f, 0.7f, 0.0f);
	fixture_box(world, CN_BODY_STATIC, half_width + 0.5f, 40.0f, 0.0f, 0.5f, 40.0f, 0.7f, 0.0f);
}

/* kind 0: a ball, 1: a capsule, 2: a box, 3: one of these. */
static cn_body thing(cn_world *world, int32_t kind, float x, float y, float size, float angle, float friction)
{
	cn_body body;
	cn_shape_def def;
	cn_capsule capsule = { { 0.0f, 0.0f }, { 0.0f, 0.0f }, 0.0f };
	if (kind % 3 == 0)
		return fixture_circle(world, CN_BODY_DYNAMIC, x, y, size, friction, 0.0f);
	if (kind % 3 == 2)
		return fixture_box(world, CN_BODY_DYNAMIC, x, y, angle, size, 0.7f * size, friction, 0.0f);
	body = fixture_body(world, CN_BODY_DYNAMIC, x, y, angle);
	def = fixture_shape_def(body, friction, 0.0f);
	capsule.a_m.x = -1.3f * size;
	capsule.b_m.x = 1.3f * size;
	capsule.radius_m = 0.35f * size;
	must(cn_shape_create_capsule(world, &def, &capsule, NULL), world, "cn_shape_create_capsule");
	return body;
}

/* Bodies that are to fall from rows of so many. */
static cn_world *heap(int32_t kind, uint32_t seed, int32_t count, int32_t columns, cn_body *bodies)
{
	cn_world *world = fixture_world(-10.0f, 1);
	uint32_t random = seed * 2654435761u + 1u;
	float half_width = 0.6f * (float)columns;
	int32_t k;
	walls(world, half_width);
	for (k = 0; k < count; ++k) {
		float x = 0.6f - half_width + 1.2f * (float)(k % columns) + fixture_random(&random, -0.15f, 0.15f), size = fixture_random(&random, 0.2f, 0.3f);
		bodies[k] = thing(world, kind < 3 ? kind : k, x, 0.6f + (float)(k / columns), size, fixture_random(&random, 0.0f, 3.0f), 0.7f);
	}
	return world;
}

/* Bodies fall from up to 25 m and squeeze those below. Returns the deepest overlap after a while. */
static float pour(int32_t kind, uint32_t seed, int32_t *asleep)
{
	cn_body bodies[BODIES];
	cn_world *world = heap(kind, seed, BODIES, 4, bodies);
	float deepest;
	fixture_step(world, 1200);
	deepest = fixture_penetration(world, bodies, BODIES);
	*asleep += fixture_counters(world).bodies_awake == 0;
	cn_world_destroy(world);
	return deepest;
}

static void t_heaps_rest_without_overlaps(void)
{
	float sum = 0.0f, most = 0.0f;
	int32_t kind, seed, asleep = 0;
	for (kind = 0; kind < KINDS; ++kind)
		for (seed = 1; seed <= SEEDS; ++seed) {
			float deepest = pour(kind, (uint32_t)seed, &asleep);
			sum += deepest;
			most = fmaxf(most, deepest);
		}
	CHECK_LE("deepest overlaps, their mean", (double)sum / (KINDS * SEEDS), 0.003, "m");
	CHECK_LE("deepest of all", (double)most, 0.006, "m");
	CHECK_GE("heaps that sleep", asleep, KINDS * SEEDS - 1, "");
}

/* Their overlaps are projected while parts of them still move: at last, all at once, they would begin to move again. */
static void t_wide_heaps_fall_asleep_soon(void)
{
	static cn_body bodies[4 * BODIES];
	int32_t kind, sum = 0;
	for (kind = 0; kind < KINDS; ++kind) {
		cn_world *world = heap(kind, 1, 4 * BODIES, 24, bodies);
		int32_t steps = 0;
		while (steps < 1200 && (steps < 60 || fixture_counters(world).bodies_awake > 0)) {
			fixture_step(world, 1);
			++steps;
		}
		printf("  kind %d: %d steps, deepest overlap %.2f mm\n", (int)kind, (int)steps, 1e3 * (double)fixture_penetration(world, bodies, 4 * BODIES));
		sum += steps;
		cn_world_destroy(world);
	}
	CHECK_LE("steps until they sleep, their mean", sum / KINDS, 380, "");
}

/* A block that bears a ball sticks between two walls that are 40 mm too near for it. */
static void t_nothing_is_pushed_through_walls(void)
{
	cn_world_def def;
	cn_world *world = NULL;
	cn_body block;
	float out = 0.0f;
	int32_t k;
	cn_world_def_init(&def);
	def.solver = CN_SOLVER_SOFT;
	must(cn_world_create(&def, &world), NULL, "cn_world_create");
	walls(world, 1.0f);
	block = fixture_box(world, CN_BODY_DYNAMIC, 0.0f, 5.0f, 0.0f, 1.02f, 0.5f, 0.7f, 0.0f);
	fixture_circle(world, CN_BODY_DYNAMIC, 0.0f, 5.6f, 0.1f, 0.7f, 0.0f);
	for (k = 0; k < 600; ++k) {
		fixture_step(world, 1);
		out = k < 30 ? 0.0f : fmaxf(out, fabsf(fixture_pose(world, block).position_m.x));
	}
	CHECK_LE("how far it is pushed into a wall", (double)out, 0.001, "m");
	CHECK_GE("height", (double)fixture_pose(world, block).position_m.y, 4.9, "m");
	CHECK_LE("awake", fixture_counters(world).bodies_awake, 0, "");
	cn_world_destroy(world);
}

static void chain(cn_world *world, uint32_t *random, float x, float y)
{
	int32_t k, links = 2 + (int32_t)fixture_random(random, 0.0f, 2.999f);
	float size = fixture_random(random, 0.1f, 0.15f);
	cn_body last = 0;
	for (k = 0; k < links; ++k) {
		cn_body body = thing(world, 1 + k % 2, x + 3.3f * size * (float)k, y, size, 0.0f, 0.4f);
		if (k > 0) {
			cn_revolute_def def = revolute_def(last, at(1.65f * size, 0.0f), body, at(-1.65f * size, 0.0f));
			def.base.flags |= CN_JOINT_LIMIT;
			def.lower_angle_rad = -1.0f;
			def.upper_angle_rad = 1.0f;
			(void)make_revolute(world, &def);
		}
		last = body;
	}
}

static int32_t chains_sleep(uint32_t seed)
{
	cn_world *world = fixture_world(-10.0f, 1);
	uint32_t random = seed * 2654435761u + 1u;
	int32_t k, asleep;
	walls(world, HALF_WIDTH);
	for (k = 0; k < 60; ++k)
		chain(world, &random, -1.8f + 1.2f * (float)(k % 3), 0.6f + 0.6f * (float)(k / 3));
	fixture_step(world, 1200);
	asleep = fixture_counters(world).bodies_awake == 0;
	cn_world_destroy(world);
	return asleep;
}

static void t_heaps_of_chains_fall_asleep(void)
{
	uint32_t seed;
	int32_t asleep = 0;
	for (seed = 1; seed <= TEST_MANY(10); ++seed)
		asleep += chains_sleep(seed);
	CHECK_GE("share of heaps that sleep after 20 s", asleep / (double)TEST_MANY(10), 0.6, "");
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(t_heaps_rest_without_overlaps);
	RUN(t_wide_heaps_fall_asleep_soon);
	RUN(t_nothing_is_pushed_through_walls);
	RUN(t_heaps_of_chains_fall_asleep);
	return test_end();
}
