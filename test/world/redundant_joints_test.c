/*
 * test/world/redundant_joints_test.c - joints that say the same as others, or contradict them: coupled wheels, straight bridges, welded arches,
 * parts that are held beyond a limit.
 *
 * If a test here fails, run world/direct and world/mechanism first. Then look at rattle_begin and is_contradictory in direct/direct_joints.c, and
 * at cni_sparse_is_redundant in linear/sparse_solve.c.
 */
#include "direct.h"
#include "model/world.h"

static double energy_left(const scene *s, float spin)
{
	double sum = 0.0;
	int32_t k;
	for (k = 0; k < s->body_count; ++k)
		sum += pow((double)(fixture_velocity(s->world, s->bodies[k]).angular_radps / spin), 2.0);
	return sum / (double)s->body_count;
}

/* Wheels on fixed axles, each coupled to the next by two rods a quarter turn apart: from three wheels on, rods say what others say. Returns the
   part of their energy that they have after 10 s. */
static double coupled_wheels_keep(int32_t wheels, float spin)
{
	const cn_vec2 cranks[] = { { 0.15f, 0.0f }, { 0.0f, 0.15f } };
	scene s = scene_open(10.0, 0, CN_SOLVER_AUTO);
	double left;
	int32_t k, rod;
	for (k = 0; k < wheels; ++k) {
		ball(&s, 1.3f * (float)k, 0.5f, 8.0f);
		pin(&s, 0, at(1.3f * (float)k, 0.0f), s.bodies[k], at(0.0f, 0.0f));
		fixture_set_velocity(s.world, s.bodies[k], 0.0f, 0.0f, spin);
		for (rod = 0; rod < 2 && k > 0; ++rod) {
			cn_distance_def def;
			cn_distance_def_init(&def);
			def.base.body_a = s.bodies[k - 1];
			def.base.body_b = s.bodies[k];
			def.base.anchor_a_m = def.base.anchor_b_m = cranks[rod];
			def.length_m = 1.3f;
			must(cn_joint_create_distance(s.world, &def, &s.joints[s.joint_count++]), s.world, "cn_joint_create_distance");
		}
	}
	fixture_step(s.world, 600);
	left = energy_left(&s, spin);
	scene_close(&s);
	return left;
}

static void coupled_wheels_turn_on(void)
{
	CHECK_LE("energy that 4 wheels lose in 10 s at 25 rad/s, part", fabs(1.0 - coupled_wheels_keep(4, 25.0f)), 1e-3, "");
	CHECK_LE("... 5 at 45 rad/s", fabs(1.0 - coupled_wheels_keep(5, 45.0f)), 1e-3, "");
	CHECK_LE("... 12 at 25 rad/s", fabs(1.0 - coupled_wheels_keep(12, 25.0f)), 1e-3, "");
}

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

static void arch_weld(scene *s, int32_t k, int32_t pieces, cn_vec2 place, float turn)
{
	cn_body a = k > 0 ? s->bodies[k - 1] : 0, b = k < pieces ? s->bodies[k] : 0;
	cn_fixed_def def;
	cn_vec2 anchor_a = place, anchor_b = place;
	cn_fixed_def_init(&def);
	if (a != 0)
		must(cn_body_get_local_point(s->world, a, place.x, place.y, &anchor_a), s->world, "cn_body_get_local_point");
	if (b != 0)
		must(cn_body_get_local_point(s->world, b, place.x, place.y, &anchor_b), s->world, "cn_body_get_local_point");
	connect(&def.base, a, anchor_a, b, anchor_b);
	def.reference_angle_rad = turn;
	def.base.flags = CN_JOINT_BREAKS;
	def.base.break_force_N = def.base.break_torque_Nm = 10.0f * 10.0f * (float)pieces;
	s->joints[s->joint_count++] = make_fixed(s->world, &def);
}

/* Pieces of a kilogram, welded to one another and to the world at both ends, 6 m apart; a weld breaks under ten times the weight of all. Returns 1
   if one does so in 5 s. */
static int32_t arch_breaks(int32_t pieces, float rise)
{
	scene s = scene_open(10.0, 0, CN_SOLVER_AUTO);
	cn_vec2 ends[33];
	float angle = 0.0f, before = 0.0f;
	int32_t k, broke;
	for (k = 0; k <= pieces; ++k) {
		float t = (float)k / (float)pieces;
		ends[k] = at(6.0f * t, 4.0f * rise * t * (1.0f - t));
	}
	for (k = 0; k < pieces; ++k) {
		float x = ends[k + 1].x - ends[k].x, y = ends[k + 1].y - ends[k].y;
		keep(&s, fixture_box(s.world, CN_BODY_DYNAMIC, 0.5f * (ends[k].x + ends[k + 1].x), 0.5f * (ends[k].y + ends[k + 1].y), atan2f(y, x), 0.5f * sqrtf(x * x + y * y), 0.08f, 0.5f, 0.0f));
		weigh(&s, s.bodies[k], 1.0f / mass_of(s.world, s.bodies[k]).mass_kg);
	}
	for (k = 0; k <= pieces; ++k) {
		angle = k < pieces ? atan2f(ends[k + 1].y - ends[k].y, ends[k + 1].x - ends[k].x) : 0.0f;
		arch_weld(&s, k, pieces, ends[k], angle - before);
		before = angle;
	}
	fixture_step(s.world, 300);
	broke = fixture_counters(s.world).joints < s.joint_count;
	scene_close(&s);
	return broke;
}

static void welded_arches_bear_themselves(void)
{
	int32_t pieces, rise, broken = 0;
	for (pieces = 3; pieces <= 20; ++pieces)
		for (rise = 0; rise < 8; ++rise)
			broken += arch_breaks(pieces, 0.2f * (float)rise);
	CHECK_LE("arches of 144 that break under ten times their weight", broken, 0, "");
}

/* Two beams; the first is pinned to the ground, beyond its limit by so many radians, and the second, static, holds it there. Returns the greatest
   speed after the second is let go, m/s. */
static double forced_arm_speed(float beyond, int32_t steps, int32_t solver)
{
	scene s = scene_open(0.0, 0, solver);
	cn_body parts[2];
	cn_revolute_def def;
	double fastest = 0.0;
	int32_t k;
	parts[0] = beam(&s, 0.3f, 0.0f, 0.0f, 0.3f, 0.05f);
	parts[1] = beam(&s, 0.9f, 0.0f, 0.0f, 0.3f, 0.05f);
	must(cn_body_set_type(s.world, parts[1], CN_BODY_STATIC), s.world, "cn_body_set_type");
	def = revolute_def(0, at(0.0f, 0.0f), parts[0], at(-0.3f, 0.0f));
	def.base.flags |= CN_JOINT_LIMIT;
	def.lower_angle_rad = beyond;
	def.upper_angle_rad = beyond + 1.0f;
	(void)make_revolute(s.world, &def);
	pin(&s, parts[0], at(0.3f, 0.0f), parts[1], at(-0.3f, 0.0f));
	fixture_step(s.world, steps);
	must(cn_body_set_type(s.world, parts[1], CN_BODY_DYNAMIC), s.world, "cn_body_set_type");
	for (k = 0; k < 3; ++k) {
		fixture_step(s.world, 1);
		fastest = fmax(fastest, fastest_of(&s, parts, 2));
	}
	scene_close(&s);
	return fastest;
}

static void what_is_held_beyond_a_limit_is_let_go_calmly(void)
{
	static const int32_t steps[] = { 1, 2, 30, 300 };
	double worst = 0.0;
	int32_t k, i;
	for (k = 1; k <= 6; ++k)
		for (i = 0; i < 4; ++i)
			worst = fmax(worst, forced_arm_speed(0.1f * (float)k, steps[i], CN_SOLVER_AUTO) / forced_arm_speed(0.1f * (float)k, steps[i], CN_SOLVER_SOFT));
	CHECK_LE("speed of an arm that was held beyond its limit / with soft constraints", worst, 1.1, "");
}

int main(void)
{
	RUN(coupled_wheels_turn_on);
	RUN(straight_bridges_rest);
	RUN(welded_arches_bear_themselves);
	RUN(what_is_held_beyond_a_limit_is_let_go_calmly);
	return test_end();
}
