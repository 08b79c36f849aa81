/*
 * test/world/bridges_test.c - straight bridges between fixed ends, whose joints are nearly redundant: they rest, throw no discs, and are not
 * thrown when they are welded, assembled with gaps, or have planks that are pulled or dragged.
 *
 * If a test here fails, run world/redundant_joints first. Then look at loop_is_better_soft and is_open_loop in direct/component_fate.c.
 */
#include "direct.h"

/* Planks in a row, pinned to one another and at both ends to the world. Returns 1 if they are awake after 5 s. */
static int32_t bridge_moves_on(int32_t planks, float span)
{
	scene s = scene_open(10.0, 1, CN_SOLVER_AUTO);
	float length = span / (float)planks, half = 0.5f * length;
	int32_t k, moves;
	for (k = 0; k < planks; ++k) {
		keep(&s, fixture_box(s.world, CN_BODY_DYNAMIC, length * ((float)k + 0.5f), 0.0f, 0.0f, 0.98f * half, 0.06f, 0.5f, 0.0f));
		pin(&s, k > 0 ? s.bodies[k - 1] : 0, at(k > 0 ? half : 0.0f, 0.0f), s.bodies[k], at(-half, 0.0f));
	}
	pin(&s, s.bodies[planks - 1], at(half, 0.0f), 0, at(span, 0.0f));
	fixture_step(s.world, 300);
	moves = fixture_counters(s.world).bodies_awake > 0;
	scene_close(&s);
	return moves;
}

static void straight_bridges_rest(void)
{
	int32_t planks, moving = 0;
	for (planks = 2; planks <= 16; planks *= 2)
		moving += bridge_moves_on(planks, 4.0f) + bridge_moves_on(planks, 12.0f);
	CHECK_LE("straight bridges of 8 that do not come to rest", moving, 0, "");
}

static void bridge_joint_add(scene *s, int32_t k, int32_t planks, float torque, int32_t welds)
{
	cn_body a = k > 0 ? s->bodies[k - 1] : 0, b = k < planks ? s->bodies[k] : 0;
	cn_vec2 anchor_a = k > 0 ? at(0.5f, 0.0f) : at(0.0f, 20.0f), anchor_b = k < planks ? at(-0.5f, 0.0f) : at((float)planks, 20.0f);
	cn_revolute_def pin_def = revolute_def(a, anchor_a, b, anchor_b);
	cn_fixed_def weld;
	cn_fixed_def_init(&weld);
	connect(&weld.base, a, anchor_a, b, anchor_b);
	if (torque > 0.0f)
		pin_def.base.flags |= CN_JOINT_MOTOR;
	pin_def.motor_torque_max_Nm = torque;
	if (welds && k % 3 == 1)
		(void)make_fixed(s->world, &weld);
	else
		(void)make_revolute(s->world, &pin_def);
}

static void bridge_add(scene *s, int32_t planks, float torque, int32_t welds)
{
	int32_t k;
	for (k = 0; k < planks; ++k)
		keep(s, fixture_box(s->world, CN_BODY_DYNAMIC, (float)k + 0.5f, 20.0f, 0.0f, 0.5f, 0.125f, 0.6f, 0.0f));
	for (k = 0; k <= planks; ++k)
		bridge_joint_add(s, k, planks, torque, welds);
}

/* Planks in a row between two walls, whose pins have friction (motors of speed 0 and this torque), or are welds in part; discs fall on it and
   roll off. Returns the speed of its fastest plank in 12 s. */
static double bridge_speed(int32_t planks, float torque, int32_t welds, int32_t discs, int32_t rate, int32_t substeps)
{
	scene s = scene_open(10.0, 1, CN_SOLVER_AUTO);
	double most = 0.0;
	int32_t k;
	must(cn_world_set_substep_count(s.world, substeps), s.world, "cn_world_set_substep_count");
	bridge_add(&s, planks, torque, welds);
	for (k = 0; k < discs; ++k)
		fixture_circle(s.world, CN_BODY_DYNAMIC, (float)planks * (0.2f + 0.6f * (float)k / (float)discs), 22.0f + 2.0f * (float)k, 0.5f, 0.6f, 0.0f);
	for (k = 0; k < TEST_FORM(12, 12, 4) * rate; ++k) {
		must(cn_world_step(s.world, 1.0f / (float)rate), s.world, "cn_world_step");
		most = fmax(most, fastest_of(&s, s.bodies, planks));
	}
	scene_close(&s);
	return most;
}

/* When nothing touches them any more, soft joints have opened by centimetres. Exact ones cannot close them: no force shortens a straight row. */
static void straight_bridges_are_not_thrown(void)
{
	double friction = 0.0, welded = 0.0;
	int32_t k;
	for (k = 0; k < 3; k += TEST_FORM(1, 2, 3)) {
		friction = fmax(friction, bridge_speed(96, powf(7.0f, (float)k), 0, 4, 60, 4));
		welded = fmax(welded, bridge_speed(96, 0.0f, 1, 2 + 2 * k, 60, 4));
	}
	CHECK_LE("fastest plank of bridges with friction", friction, 30.0, "m/s");
	CHECK_LE("... welded in part", welded, 20.0, "m/s");
	CHECK_LE("... at 1,920 substeps a second, whose gaps are small", fmax(bridge_speed(28, 1.0f, 0, 1, 240, 8), bridge_speed(44, 1.0f, 0, 1, 240, 8)), 12.0, "m/s");
	CHECK_LE("... at 30, which begin softly with all of their tension", bridge_speed(44, 0.0f, 0, 1, 30, 1), 25.0, "m/s");
}

/* Short ones are exact. A disc that bounces on their planks must gain no energy from joints that are nearly redundant. */
static void straight_bridges_throw_no_discs(void)
{
	double most = 0.0;
	int32_t planks, discs;
	for (planks = 10; planks <= 32; planks += 4)
		for (discs = TEST_FORM(1, 1 + planks / 4 % 2, 3); discs <= 3; discs += TEST_FORM(1, 2, 3))
			most = fmax(most, bridge_speed(planks, 0.0f, 0, discs, 60, 4));
	CHECK_LE("fastest plank of short bridges under discs", most, 5.0, "m/s");
}

/* A straight bridge of planks of which one after another is kinematic for a step, and moves in a way that the others cannot follow. Returns its
   greatest speed. */
static double pulled_bridge_reaches(int32_t planks, uint32_t seed)
{
	scene s = scene_open(10.0, 1, CN_SOLVER_AUTO);
	double fastest = 0.0;
	int32_t k;
	for (k = 0; k < planks; ++k) {
		(void)beam(&s, 0.5f * (float)k + 0.25f, 0.0f, 0.0f, 0.25f, 0.08f);
		pin(&s, k > 0 ? s.bodies[k - 1] : 0, at(k > 0 ? 0.25f : 0.0f, 0.0f), s.bodies[k], at(-0.25f, 0.0f));
	}
	pin(&s, last_body(&s), at(0.25f, 0.0f), 0, at(0.5f * (float)planks, 0.0f));
	for (k = 0; k < 60; ++k) {
		cn_body pulled = s.bodies[(int32_t)fixture_random(&seed, 1.0f, (float)planks - 1.01f)];
		float turn = fixture_random(&seed, 0.0f, 6.28f);
		must(cn_body_set_type(s.world, pulled, CN_BODY_KINEMATIC), s.world, "cn_body_set_type");
		fixture_set_velocity(s.world, pulled, 5.0f * cosf(turn), 5.0f * fabsf(sinf(turn)), 0.0f);
		fixture_step(s.world, 1);
		must(cn_body_set_type(s.world, pulled, CN_BODY_DYNAMIC), s.world, "cn_body_set_type");
		fixture_step(s.world, k % 3);
		fastest = greater(fastest, fastest_of(&s, s.bodies, s.body_count));
	}
	scene_close(&s);
	return fastest;
}

static void pulled_bridges_are_not_thrown(void)
{
	double fastest = 0.0;
	int32_t planks, thrown = 0;
	for (planks = 6; planks < 26; ++planks) {
		double reached = pulled_bridge_reaches(planks, 77u * (uint32_t)planks);
		fastest = greater(fastest, reached);
		thrown += reached > 40.0;
	}
	CHECK_LE("bridges of 20 that pass 40 m/s when planks are pulled at 5 m/s", thrown, 0, "");
	CHECK_LE("fastest (soft constraints 28)", fastest, 40.0, "m/s");
}

/* A plank in each half second is dragged for 0.3 s, with up to 1,000 times its weight. Returns the greatest speed. */
static double dragged_bridge_reaches(int32_t planks, uint32_t seed)
{
	scene s = scene_open(10.0, 0, CN_SOLVER_AUTO);
	double fastest = 0.0;
	int32_t step;
	cn_joint mouse = 0;
	bridge_add(&s, planks, 0.0f, 0);
	for (step = 0; step < 960; ++step) {
		if (step % 120 == 0) {
			cn_mouse_def def;
			int32_t plank = (int32_t)fixture_random(&seed, 0.0f, (float)planks - 0.01f);
			cn_vec2 p = fixture_pose(s.world, s.bodies[plank]).position_m;
			cn_mouse_def_init(&def);
			def.base.body_b = s.bodies[plank];
			def.target_m = at(p.x + fixture_random(&seed, -3.0f, 3.0f), p.y + fixture_random(&seed, -1.0f, 3.0f));
			def.base.force_max_N = 10.0f * mass_of(s.world, s.bodies[plank]).mass_kg * powf(10.0f, fixture_random(&seed, 1.0f, 3.0f));
			mouse = make_mouse(s.world, &def);
		} else if (step % 120 == 72) {
			must(cn_joint_destroy(s.world, mouse), s.world, "cn_joint_destroy");
		}
		must(cn_world_step(s.world, 1.0f / 240.0f), s.world, "cn_world_step");
		fastest = fmax(fastest, fastest_of(&s, s.bodies, planks));
	}
	scene_close(&s);
	return fastest;
}

static void dragged_bridges_are_not_thrown(void)
{
	double fastest = 0.0;
	uint32_t seed;
	for (seed = 1; seed <= TEST_MANY(10); ++seed)
		fastest = fmax(fastest, dragged_bridge_reaches(80 + 2 * (int32_t)seed, seed * 7919u));
	CHECK_LE("greatest speed of a plank", fastest, 60.0, "m/s");
}

/* A bridge of 12 planks between walls that are 12 planks apart, assembled with this gap in each joint, so that it sags; a box of 5 to 80 times a
   plank's mass falls on it. Returns the greatest speed. */
static double sagging_bridge_reaches(int32_t solver, float gap, float heavy)
{
	scene s = scene_open(10.0, 0, solver);
	double fastest = 0.0;
	int32_t k;
	for (k = 0; k < 12; ++k) {
		keep(&s, fixture_box(s.world, CN_BODY_DYNAMIC, 0.5f + (float)k, 4.0f - gap * (float)(k < 6 ? k : 11 - k), 0.0f, 0.5f, 0.1f, 0.6f, 0.0f));
		pin(&s, k == 0 ? 0 : s.bodies[k - 1], k == 0 ? at(0.0f, 4.0f) : at(0.5f, 0.0f), s.bodies[k], at(-0.5f, 0.0f));
	}
	pin(&s, s.bodies[11], at(0.5f, 0.0f), 0, at(12.0f, 4.0f));
	weigh(&s, keep(&s, fixture_box(s.world, CN_BODY_DYNAMIC, 6.0f, 4.7f, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f)), heavy);
	for (k = 0; k < 120; ++k) {
		fixture_step(s.world, 1);
		fastest = greater(fastest, fastest_of(&s, s.bodies, s.body_count));
	}
	scene_close(&s);
	return fastest;
}

/* Exact joints would close at once what soft ones have left open when the box lands, and throw it. */
static void bridges_assembled_with_gaps_throw_nothing(void)
{
	static const float heavies[] = { 5.0f, 20.0f, 80.0f };
	double most = 0.0, ratio = 0.0;
	int32_t k;
	for (k = 0; k < 30; ++k) {
		float gap = 0.02f + 0.008f * (float)(k % 10), heavy = heavies[k / 10];
		double fastest = sagging_bridge_reaches(CN_SOLVER_AUTO, gap, heavy);
		most = greater(most, fastest);
		ratio = greater(ratio, fastest / sagging_bridge_reaches(CN_SOLVER_SOFT, gap, heavy));
	}
	CHECK_LE("greatest speed", most, 10.0, "m/s");
	CHECK_LE("greatest speed over that with soft constraints", ratio, 2.0, "");
}

/* ---- a loaded bridge at rest ---- */

/* A straight bridge of planks with boxes on it, at rest after ten seconds; its plank 0 is s.bodies[0]. */
static scene loaded_bridge(int32_t planks, int32_t boxes)
{
	scene s = scene_open(10.0, 0, CN_SOLVER_AUTO);
	int32_t k;
	bridge_add(&s, planks, 0.0f, 0);
	for (k = 1; k <= boxes; ++k)
		keep(&s, fixture_box(s.world, CN_BODY_DYNAMIC, (float)(planks * k) / (float)(boxes + 1), 20.7f, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f));
	fixture_step(s.world, 400);
	return s;
}

static double fastest_in_a_second(const scene *s)
{
	double fastest = 0.0;
	int32_t k;
	for (k = 0; k < 60; ++k) {
		fixture_step(s->world, 1);
		fastest = greater(fastest, fastest_of(s, s->bodies, s->body_count));
	}
	return fastest;
}

/* Some steps are short, and then they are as long as before: as slow motion, or one step of a frame that came early. */
static void slow_motion_throws_no_bridges(void)
{
	static const float steps_s[] = { 1.0f / 600.0f, 1.0f / 1200.0f, 1e-4f };
	double fastest = 0.0;
	int32_t length, k, step;
	for (length = 4; length <= 16; length *= 2)
		for (k = 0; k < 3; ++k) {
			scene s = loaded_bridge(length, length / 4);
			for (step = 0; step < 10 << k; ++step)
				must(cn_world_step(s.world, steps_s[k]), s.world, "cn_world_step");
			fastest = greater(fastest, fastest_in_a_second(&s));
			scene_close(&s);
		}
	CHECK_LE("greatest speed on straight bridges after short steps", fastest, 0.8, "m/s");
}

/* Planks at rest are locked where they are, so nothing has to move. */
static void locked_planks_rest(void)
{
	double fastest = 0.0;
	uint32_t locks, locked;
	int32_t k;
	for (locks = 1; locks < 8; ++locks)
		for (locked = TEST_FORM(1u, 2u - locks % 2u, locks); locked < 16; locked += TEST_FORM(1, 3, 8)) {
			scene s = loaded_bridge(4, (int32_t)(locked % 3u));
			for (k = 0; k < 4; ++k)
				if (locked >> k & 1u)
					must(cn_body_set_flags(s.world, s.bodies[k], (uint32_t)CN_BODY_ENABLED | (uint32_t)CN_BODY_SLEEP | locks), s.world, "cn_body_set_flags");
			fastest = greater(fastest, fastest_in_a_second(&s));
			scene_close(&s);
		}
	CHECK_LE("greatest speed on bridges of which planks are locked", fastest, 0.8, "m/s");
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(bridges_assembled_with_gaps_throw_nothing);
	RUN(straight_bridges_are_not_thrown);
	RUN(straight_bridges_throw_no_discs);
	RUN(pulled_bridges_are_not_thrown);
	RUN(dragged_bridges_are_not_thrown);
	RUN(straight_bridges_rest);
	RUN(slow_motion_throws_no_bridges);
	RUN(locked_planks_rest);
	return test_end();
}
