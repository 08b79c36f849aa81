/*
 * test/world/inconsistent_joints_test.c - joints that cannot all hold: anchors of welded and pinned grids are off by millimetres or more, a part of
 * a grid is put elsewhere, limits of a loop exclude each other, a press comes down on a frame, handles pull a chain too far.
 *
 * If a test here fails, look at closings_bound in direct/component.c, cni_joint_rows_centre in joints/joint_constraint.c, then at is_contradictory
 * and is_squeezed in direct/component_fate.c, at cni_component_is_pulled and, in direct/rattle.c, at pull_fits.
 */
#include "direct.h"

#define SIDE_MOST 4
#define HALF 0.25f

typedef struct grid {
	scene s;
	cn_body boxes[SIDE_MOST][SIDE_MOST];
	uint32_t seed;
	float off; /* by how much anchors and angles are off, at most */
} grid;

static float off_by(grid *g)
{
	return fixture_random(&g->seed, -g->off, g->off);
}

static void join(grid *g, cn_body a, cn_vec2 anchor_a, cn_body b, cn_vec2 anchor_b, int32_t pins)
{
	cn_fixed_def def;
	anchor_b = at(anchor_b.x + off_by(g), anchor_b.y + off_by(g));
	if (pins) {
		(void)pin(&g->s, a, anchor_a, b, anchor_b);
		return;
	}
	cn_fixed_def_init(&def);
	connect(&def.base, a, anchor_a, b, anchor_b);
	def.reference_angle_rad = off_by(g);
	g->s.joints[g->s.joint_count++] = make_fixed(g->s.world, &def);
}

/* Boxes of 0.5 m on the floor, each joined to the next in its row and in its column. */
static grid grid_open(int32_t solver, int32_t columns, int32_t rows, float off, int32_t pins, uint32_t seed)
{
	grid g;
	int32_t k, i;
	memset(&g, 0, sizeof g);
	g.s = scene_open(10.0, 1, solver);
	g.seed = seed;
	g.off = off;
	fixture_floor(g.s.world, 0.6f, 0.0f);
	for (k = 0; k < columns; ++k)
		for (i = 0; i < rows; ++i) {
			g.boxes[k][i] = beam(&g.s, 2.0f * HALF * (float)k, HALF + 2.0f * HALF * (float)i, 0.0f, HALF - 0.01f, HALF);
			if (k > 0)
				join(&g, g.boxes[k - 1][i], at(HALF, 0.0f), g.boxes[k][i], at(-HALF, 0.0f), pins);
			if (i > 0)
				join(&g, g.boxes[k][i - 1], at(0.0f, HALF), g.boxes[k][i], at(0.0f, -HALF), pins);
		}
	return g;
}

static double fastest_in(const scene *s, int32_t steps)
{
	double fastest = 0.0;
	int32_t k;
	for (k = 0; k < steps; ++k) {
		fixture_step(s->world, 1);
		fastest = greater(fastest, fastest_of(s, s->bodies, s->body_count));
	}
	return fastest;
}

static void inexact_grids_come_to_rest(void)
{
	const float off[] = { 0.002f, 0.005f, 0.01f, 0.03f };
	double fastest = 0.0;
	int32_t i, awake = 0;
	for (i = 0; i < TEST_MANY(40); ++i) {
		int32_t k = 13 * i % 40; /* in any number of them all sizes, offsets and kinds */
		grid g = grid_open(CN_SOLVER_AUTO, 3 + k / 4 % 2, 3 + k % 2, off[k % 4], k / 20 % 2, 1000u + (uint32_t)k);
		fastest = greater(fastest, fastest_in(&g.s, 300));
		awake += fixture_counters(g.s.world).bodies_awake > 0;
		scene_close(&g.s);
	}
	CHECK_LE("grids that are awake after 5 s", awake, TEST_FORM(2, 1, 0), "");
	CHECK_LE("their greatest speed", fastest, 5.0, "m/s");
}

/* Of a resting grid of which a box is put up to 0.3 m and 0.3 rad away. */
static double moved_box_speed(uint32_t seed)
{
	grid g = grid_open(CN_SOLVER_AUTO, 3, 3, 0.0f, 0, seed);
	cn_body box = g.boxes[seed % 3][seed / 3 % 3];
	double fastest;
	fixture_step(g.s.world, 60);
	cn_vec2 place = fixture_pose(g.s.world, box).position_m;
	place = at(place.x + fixture_random(&g.seed, -0.3f, 0.3f), place.y + fixture_random(&g.seed, 0.0f, 0.3f));
	must(cn_body_set_pose(g.s.world, box, place.x, place.y, fixture_random(&g.seed, -0.3f, 0.3f)), g.s.world, "cn_body_set_pose");
	fastest = fastest_in(&g.s, 180);
	scene_close(&g.s);
	return fastest;
}

static void grids_of_which_a_box_is_put_elsewhere_stay(void)
{
	double fastest = 0.0;
	uint32_t k;
	for (k = 1; k <= TEST_MANY(40); ++k)
		fastest = greater(fastest, moved_box_speed(97u * k));
	CHECK_LE("greatest speed of grids of which a box is put elsewhere", fastest, 2.0, "m/s");
}

/* A press comes down by 0.3 m and `depth` in a second, and rises again. Returns the overlap a second later. */
static double pressed_overlap(int32_t columns, int32_t rows, float depth, int32_t pins)
{
	grid g = grid_open(CN_SOLVER_AUTO, columns, rows, 0.0f, pins, 1u);
	cn_body press = fixture_box(g.s.world, CN_BODY_KINEMATIC, 0.0f, 2.0f * HALF * (float)rows + 0.6f, 0.0f, 4.0f, 0.3f, 0.6f, 0.0f);
	double overlap;
	int32_t k;
	for (k = 0; k < 180; ++k) {
		float speed = (float)(0.5 * PI * (0.3 + (double)depth) * sin(PI * (double)k / 60.0));
		fixture_set_velocity(g.s.world, press, 0.0f, k < 120 ? -speed : 0.0f, 0.0f);
		fixture_step(g.s.world, 1);
	}
	overlap = (double)fixture_penetration(g.s.world, g.s.bodies, g.s.body_count);
	scene_close(&g.s);
	return overlap;
}

static void frames_come_out_of_a_press(void)
{
	double deepest = 0.0;
	int32_t rows, k;
	for (rows = 2; rows <= 4; ++rows)
		for (k = 0; k < 8; ++k)
			deepest = greater(deepest, pressed_overlap(2 + k % 2, rows, 0.5f * (float)rows * (0.2f + 0.1f * (float)(k / 2)), k % 2));
	CHECK_LE("overlap that a press leaves in 24 frames", deepest, 0.005, "m");
}

/* Bars of a ring whose hinges' limits exclude each other. */
static double impossible_ring_speed(int32_t solver, uint32_t seed)
{
	scene s = scene_open(10.0, 1, solver);
	int32_t k, sides = 3 + (int32_t)(seed % 5u);
	float turn = (float)(2.0 * PI) / (float)sides, half = (float)sin(0.5 * (double)turn), reach = (float)cos(0.5 * (double)turn);
	double fastest;
	fixture_floor(s.world, 0.6f, 0.0f);
	for (k = 0; k < sides; ++k) {
		float angle = turn * ((float)k + 0.5f);
		(void)beam(&s, reach * (float)cos((double)angle), 2.0f + reach * (float)sin((double)angle), angle + (float)(0.5 * PI), half, 0.05f);
	}
	for (k = 0; k < sides; ++k) {
		cn_revolute_def def = revolute_def(s.bodies[k], at(half, 0.0f), s.bodies[(k + 1) % sides], at(-half, 0.0f));
		def.base.flags = CN_JOINT_LIMIT;
		def.reference_angle_rad = turn;
		def.lower_angle_rad = fixture_random(&seed, -0.6f, 0.05f);
		def.upper_angle_rad = def.lower_angle_rad + fixture_random(&seed, 0.01f, 0.5f);
		must(cn_joint_create_revolute(s.world, &def, &s.joints[s.joint_count++]), s.world, "cn_joint_create_revolute");
	}
	fastest = fastest_in(&s, 120);
	scene_close(&s);
	return fastest;
}

static void rings_with_impossible_limits_fall_as_soft_ones(void)
{
	int32_t k, worse = 0;
	for (k = 1; k <= TEST_MANY(100); ++k)
		worse += impossible_ring_speed(CN_SOLVER_AUTO, 31u * (uint32_t)k) > 1.0 + 1.5 * impossible_ring_speed(CN_SOLVER_SOFT, 31u * (uint32_t)k);
	CHECK_LE("rings that are faster than with soft constraints", worse, TEST_FORM(4, 2, 0), "");
}

typedef struct pulled {
	double fastest, gap;
} pulled;

/* Links of 0.3 to 3 times the weight hang between two handles. These part by 2 to 30% more than they are long, stay there for half a second, and return. */
static pulled pulled_chain(int32_t solver, uint32_t seed)
{
	scene s = scene_open(10.0, 1, solver);
	int32_t k, links = 2 + (int32_t)(seed % 5u), steps;
	float angle = fixture_random(&seed, 0.3f, 0.8f), half = 2.0f * LINK * (float)links, low = -half * (float)sin((double)angle);
	float x = half * (float)cos((double)angle), way = half * fixture_random(&seed, 1.02f, 1.3f) - x, speed = fixture_random(&seed, 0.3f, 4.0f);
	cn_body left = fixture_body(s.world, CN_BODY_KINEMATIC, -x, 0.0f, 0.0f), right = fixture_body(s.world, CN_BODY_KINEMATIC, x, 0.0f, 0.0f);
	pulled p = { 0.0, 0.0 };
	add_chain(&s, left, at(0.0f, 0.0f), -x, 0.0f, -angle, links);
	add_chain(&s, last_body(&s), at(LINK, 0.0f), 0.0f, low, angle, links);
	(void)pin(&s, last_body(&s), at(LINK, 0.0f), right, at(0.0f, 0.0f));
	for (k = 0; k < s.body_count; ++k)
		weigh(&s, s.bodies[k], (float)pow(10.0, (double)fixture_random(&seed, -0.5f, 0.5f)));
	steps = (int32_t)(60.0f * way / speed) + 1;
	for (k = 0; k < 2 * steps + 90; ++k) {
		float v = k < steps ? speed : k >= steps + 30 && k < 2 * steps + 30 ? -speed : 0.0f;
		fixture_set_velocity(s.world, left, -v, 0.0f, 0.0f);
		fixture_set_velocity(s.world, right, v, 0.0f, 0.0f);
		p.fastest = greater(p.fastest, fastest_in(&s, 1));
		p.gap = greater(p.gap, anchors_apart(&s));
	}
	scene_close(&s);
	return p;
}

static void chains_that_are_pulled_too_far_stretch_as_soft_ones(void)
{
	int32_t k, fast = 0, wide = 0;
	for (k = 1; k <= TEST_MANY(60); ++k) {
		pulled exact = pulled_chain(CN_SOLVER_AUTO, 71u * (uint32_t)k), soft = pulled_chain(CN_SOLVER_SOFT, 71u * (uint32_t)k);
		fast += exact.fastest > 1.0 + 2.0 * soft.fastest;
		wide += exact.gap > 0.005 + 2.0 * soft.gap;
	}
	CHECK_LE("chains that are twice as fast as with soft constraints", fast, TEST_FORM(2, 1, 0), "");
	CHECK_LE("chains whose gaps are twice as wide", wide, TEST_FORM(1, 0, 0), "");
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(inexact_grids_come_to_rest);
	RUN(grids_of_which_a_box_is_put_elsewhere_stay);
	RUN(frames_come_out_of_a_press);
	RUN(rings_with_impossible_limits_fall_as_soft_ones);
	RUN(chains_that_are_pulled_too_far_stretch_as_soft_ones);
	return test_end();
}
