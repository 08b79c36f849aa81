/*
 * test/world/uneven_step_test.c - what stands goes on standing when no step is as long as the last, and falls asleep.
 *
 * Look at step/solve_make.c: impulses are scaled by the ratio of the steps, softness of contacts is tied to the mean step, that of joints to the
 * longest of late.
 */
#include "joints.h"

#define BODIES_MOST 256
#define STEPS 300

typedef struct built {
	cn_world *world;
	cn_body bodies[BODIES_MOST];
	cn_vec2 at[BODIES_MOST];
	int32_t count;
} built;

static void box_add(built *b, float x, float y, float hx, float hy)
{
	b->bodies[b->count] = fixture_box(b->world, CN_BODY_DYNAMIC, x, y, 0.0f, hx, hy, 0.6f, 0.0f);
	b->at[b->count].x = x;
	b->at[b->count++].y = y;
}

static void pyramid_build(built *b, int32_t size)
{
	int32_t row, k;
	for (row = 0; row < size; ++row)
		for (k = 0; k < size - row; ++k)
			box_add(b, (float)k - 0.5f * (float)(size - 1 - row), 0.5f + (float)row, 0.5f, 0.5f);
}

static void stack_build(built *b, int32_t size)
{
	int32_t k;
	for (k = 0; k < size; ++k)
		box_add(b, 0.0f, 0.5f + (float)k, 0.5f, 0.5f);
}

/* Every other row begins and ends with half a brick. */
static void wall_build(built *b, int32_t size)
{
	int32_t row, k;
	for (row = 0; row < size; ++row) {
		for (k = 0; k < size - (row & 1); ++k)
			box_add(b, (float)k + 0.5f * (float)(row & 1), 0.25f + 0.5f * (float)row, 0.5f, 0.25f);
		if (row & 1) {
			box_add(b, -0.25f, 0.25f + 0.5f * (float)row, 0.25f, 0.25f);
			box_add(b, (float)size - 0.75f, 0.25f + 0.5f * (float)row, 0.25f, 0.25f);
		}
	}
}

static built built_open(int32_t solver)
{
	cn_world_def def;
	built b;
	memset(&b, 0, sizeof b);
	cn_world_def_init(&def);
	def.gravity_mps2.y = -10.0f;
	def.solver = solver;
	must(cn_world_create(&def, &b.world), NULL, "cn_world_create");
	return b;
}

typedef void build_fn(built *b, int32_t size);

/* jitter < 0: one step in 37 takes 1/15 s. */
static float step_of(int32_t step, float jitter, uint32_t *random)
{
	if (jitter < 0.0f)
		return step % 37 == 17 ? 4.0f * FRAME_S : FRAME_S;
	return FRAME_S * (1.0f + fixture_random(random, -jitter, jitter));
}

/* Returns the farthest that a body moved; awake is added up. */
static double run(build_fn *build, int32_t size, int32_t solver, float jitter, uint32_t seed, int32_t *awake)
{
	built b = built_open(solver);
	uint32_t random = seed * 2654435761u + 1u;
	double most = 0.0;
	int32_t k;
	fixture_floor(b.world, 0.6f, 0.0f);
	build(&b, size);
	for (k = 0; k < STEPS; ++k)
		must(cn_world_step(b.world, step_of(k, jitter, &random)), b.world, "cn_world_step");
	for (k = 0; k < b.count; ++k) {
		cn_pose pose = fixture_pose(b.world, b.bodies[k]);
		most = greater(most, hypot((double)(pose.position_m.x - b.at[k].x), (double)(pose.position_m.y - b.at[k].y)));
	}
	*awake += fixture_counters(b.world).bodies_awake;
	cn_world_destroy(b.world);
	return most;
}

static void family(const char *name, build_fn *build, const int32_t *sizes)
{
	static const float jitters[] = { 0.1f, 0.3f, 0.5f, 0.8f, -1.0f };
	double most = 0.0;
	int32_t awake = 0, k, j;
	uint32_t seed;
	for (k = 0; k < 3; ++k)
		for (j = 0; j < 5; ++j)
			for (seed = 1; seed <= 2; ++seed)
				most = greater(most, run(build, sizes[k], CN_SOLVER_AUTO, jitters[j], seed, &awake));
	printf("  %s\n", name);
	CHECK_LE("farthest that a body moved", most, 5e-3, "m");
	CHECK_LE("bodies awake after 5 s", awake, 0, "");
}

static void piles_stand(void)
{
	static const int32_t pyramids[] = { 5, 15, 20 }, stacks[] = { 3, 10, 20 }, walls[] = { 4, 8, 13 };
	family("pyramids", pyramid_build, pyramids);
	family("stacks", stack_build, stacks);
	family("walls", wall_build, walls);
}

/*
 * The soft solver alone, on steps of 0.2 to 1.8 times their mean: piles sway, but stand. With a stiffness of the step that is taken, and
 * not of the mean one, each step pumps the sway (parametric excitation), and they come apart.
 */
static void soft_piles_do_not_come_apart(void)
{
	static build_fn *const builds[] = { pyramid_build, wall_build };
	static const int32_t sizes[2][2] = { { 5, 8 }, { 4, 6 } };
	double most = 0.0;
	int32_t awake = 0, k, j;
	uint32_t seed;
	for (k = 0; k < 2; ++k)
		for (j = 0; j < 2; ++j)
			for (seed = 1; seed <= 3; ++seed)
				most = greater(most, run(builds[k], sizes[k][j], CN_SOLVER_SOFT, 0.8f, seed, &awake));
	CHECK_LE("farthest that a body moved", most, 0.02, "m");
}

/*
 * Ten boxes, the upper one of so many times the density, at rest; then short steps, with a frame after each three, and frames. Returns how far it moves.
 * Overlaps that are pushed apart at once, however short the substep, and tolerances of more speed than gravity gives in it, make each solution
 * gain energy: the tower becomes soft, and sinks into itself by 1.2 m.
 */
static double heavy_tower_moves(float density, float dt, int32_t steps)
{
	built b = built_open(CN_SOLVER_AUTO);
	double from;
	int32_t k;
	cn_body_def def;
	must(cn_world_set_flags(b.world, CN_WORLD_WARM_START), b.world, "cn_world_set_flags");
	fixture_floor(b.world, 0.6f, 0.0f);
	stack_build(&b, 9);
	cn_body_def_init(&def);
	def.type = CN_BODY_DYNAMIC;
	def.position_m.y = 9.5f;
	must(cn_body_create(b.world, &def, &b.bodies[9]), b.world, "cn_body_create");
	cn_shape_def shape = fixture_shape_def(b.bodies[9], 0.6f, 0.0f);
	shape.density_kgpm2 = density;
	fixture_box_shape(b.world, &shape, 0.5f, 0.5f);
	fixture_step(b.world, 300);
	from = (double)fixture_pose(b.world, b.bodies[9]).position_m.y;
	for (k = 0; k < steps; ++k)
		must(cn_world_step(b.world, k % 4 == 3 ? FRAME_S : dt), b.world, "cn_world_step");
	fixture_step(b.world, 120);
	from -= (double)fixture_pose(b.world, b.bodies[9]).position_m.y;
	cn_world_destroy(b.world);
	return fabs(from);
}

static void heavy_towers_stand_slow_motion(void)
{
	static const float densities[] = { 50.0f, 200.0f }, dts[] = { 1.0f / 600.0f, 1.0f / 6000.0f, 1e-4f };
	double most = 0.0;
	int32_t k;
	for (k = 0; k < 12; ++k)
		most = greater(most, heavy_tower_moves(densities[k & 1], dts[k / 4], k & 2 ? 40 : 1));
	CHECK_LE("farthest that a heavy box on a tower moves after short steps", most, 1e-3, "m");
}

/* ---- joints ---- */

enum { ANY_FRAMES, HITCHES, ALTERNATING, SLOW_MOTION, PACES };

static float frame_of(int32_t pace, int32_t step, double now_s, uint32_t *random)
{
	switch (pace) {
	case ANY_FRAMES: return expf(fixture_random(random, -5.48f, -3.0f)); /* 1/240 to 1/20 s */
	case HITCHES: return step % 37 == 17 ? 4.0f * FRAME_S : FRAME_S;
	case ALTERNATING: return step & 1 ? 0.5f * FRAME_S : 2.0f * FRAME_S;
	default: return (int32_t)now_s & 1 ? 0.25f * FRAME_S : FRAME_S;
	}
}

/* Planks pinned to each other and to a wall, from this x on. Returns the last. */
static cn_body planks_build(built *b, int32_t planks, float left)
{
	cn_body last = 0;
	int32_t k;
	for (k = 0; k < planks; ++k) {
		box_add(b, left + (float)k + 0.5f, 20.0f, 0.5f, 0.125f);
		(void)hinge(b->world, last, last != 0 ? at(0.5f, 0.0f) : at(left, 20.0f), b->bodies[k], at(-0.5f, 0.0f));
		last = b->bodies[k];
	}
	return last;
}

/* A taut bridge between two walls, onto which balls fall; or a chain of planks that falls with a ball of 90 times the weight of a plank at its
   end. Returns the speed of the fastest plank in ten seconds. */
static double fastest_plank(int32_t planks, int32_t ball, int32_t solver, int32_t pace)
{
	built b = built_open(solver);
	cn_body last;
	uint32_t random = 12345u;
	double most = 0.0, now_s = 0.0;
	float left = -0.5f * (float)planks;
	int32_t k;
	last = planks_build(&b, planks, left);
	if (ball)
		(void)hinge(b.world, last, at(0.5f, 0.0f), fixture_circle(b.world, CN_BODY_DYNAMIC, 2.7f - left, 20.0f, 2.7f, 0.6f, 0.0f), at(-2.7f, 0.0f));
	else
		(void)hinge(b.world, last, at(0.5f, 0.0f), 0, at(-left, 20.0f));
	for (k = 0; k < 3 && !ball; ++k)
		fixture_circle(b.world, CN_BODY_DYNAMIC, left + (float)planks * (0.2f + 0.2f * (float)k), 22.0f + 2.0f * (float)k, 0.5f, 0.6f, 0.0f);
	for (k = 0; now_s < 10.0; ++k) {
		float dt = frame_of(pace, k, now_s, &random);
		must(cn_world_step(b.world, dt), b.world, "cn_world_step");
		now_s += (double)dt;
		most = greater(most, totals_of(b.world, b.bodies, planks).speed_most);
	}
	cn_world_destroy(b.world);
	return most;
}

/* With a stiffness of joints that follows the step, or the mean step, such bridges reach the speed limit; chains do so with impulses that grow
   with the step. */
static void joints_bear_steps_of_any_length(void)
{
	double bridge = 0.0, chain = 0.0;
	int32_t k;
	for (k = 0; k < 2 * 2 * PACES; ++k) {
		int32_t planks = k & 1 ? 80 : 40, solver = k & 2 ? CN_SOLVER_SOFT : CN_SOLVER_AUTO;
		if (TEST_FORM(0, (k ^ k >> 1 ^ k >> 2) & 1, (k & 3) != k / 4))
			continue; /* each pace with one length by one solver, and with the other by the other; or with one alone */
		bridge = greater(bridge, fastest_plank(planks, 0, solver, k / 4));
		chain = greater(chain, fastest_plank(planks / 2, 1, solver, k / 4));
	}
	CHECK_LE("fastest plank of a bridge", bridge, 26.0, "m/s");
	CHECK_LE("fastest plank of a chain", chain, 45.0, "m/s");
}

int main(void)
{
	RUN(joints_bear_steps_of_any_length);
	RUN(piles_stand);
	RUN(soft_piles_do_not_come_apart);
	RUN(heavy_towers_stand_slow_motion);
	return test_end();
}
