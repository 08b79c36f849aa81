/*
 * test/world/ropes_test.c - ropes, which are distance joints with a greatest length alone: rows of them under loads, hooks, nets, ropes that go slack
 * and taut.
 *
 * If a test here fails, run world/direct first. Then look at ropes_switch in direct/rattle.c, and at
 * is_open_loop in direct/component_fate.c.
 */
#include "direct.h"

static void place(const scene *s, cn_body body, float x, float y)
{
	must(cn_body_set_pose(s->world, body, x, y, 0.0f), s->world, "cn_body_set_pose");
}

/* As long as `length`, between the centres of the bodies but for the anchor on a. CN_JOINT_LIMIT: a rope, else a rod. */
static void tie(scene *s, cn_body a, cn_vec2 anchor_a, cn_body b, float length, uint32_t flags, float break_force)
{
	cn_distance_def def;
	cn_distance_def_init(&def);
	connect(&def.base, a, anchor_a, b, at(0.0f, 0.0f));
	def.base.flags |= flags;
	if ((flags & CN_JOINT_BREAKS) != 0)
		def.base.break_force_N = break_force;
	def.length_m = def.length_max_m = length;
	def.length_min_m = 0.0f;
	must(cn_joint_create_distance(s->world, &def, &s->joints[s->joint_count++]), s->world, "cn_joint_create_distance");
}

static void rope(scene *s, cn_body a, cn_vec2 anchor_a, cn_body b, float length)
{
	tie(s, a, anchor_a, b, length, CN_JOINT_LIMIT, 0.0f);
}

/* Beads of 1 kg on ropes of 0.5 m, 0.5 m apart but for `slack`, along a direction from the world; the last one weighs `load`. */
static void add_row(scene *s, int32_t beads, float angle, float load, float slack)
{
	float step = 0.5f * (1.0f - slack), x = step * (float)cos((double)angle), y = step * (float)sin((double)angle);
	int32_t k;
	for (k = 1; k <= beads; ++k) {
		cn_body bead = ball(s, x * (float)k, 0.1f, k == beads ? load : 1.0f);
		place(s, bead, x * (float)k, y * (float)k);
		rope(s, k == 1 ? 0 : s->bodies[k - 2], at(0.0f, 0.0f), bead, 0.5f);
	}
}

static watch row_swings(int32_t solver, int32_t beads, float load, float slack, int32_t steps)
{
	scene s = scene_open(10.0, 0, solver);
	watch w;
	add_row(&s, beads, 0.0f, load, slack);
	w = watch_begin(&s);
	watch_steps(&w, &s, steps);
	w.energy_least = energy_in(&s);
	scene_close(&s);
	return w;
}

/* Soft ropes open by 5 to 400 mm. */
static void rows_bear_loads(void)
{
	static const float loads[] = { 1.0f, 30.0f, 300.0f, 2000.0f };
	double apart = 0.0, soft = 1.0, rise = 0.0;
	size_t k;
	for (k = 0; k < sizeof loads / sizeof *loads; ++k) {
		watch w = row_swings(CN_SOLVER_AUTO, 12, loads[k], 0.0f, 240);
		apart = greater(apart, w.apart);
		rise = greater(rise, (w.energy - w.energy_start) / (60.0 * (double)(loads[k] + 11.0f)));
		soft = fmin(soft, row_swings(CN_SOLVER_SOFT, 12, loads[k], 0.0f, 240).apart);
	}
	CHECK_LE("rows of 12 ropes with loads of 1 to 2,000 beads open by", apart, 0.003, "m");
	CHECK_LE("... of which soft ones, the least", 0.003, soft, "m");
	CHECK_LE("... rise of energy, part of their fall", rise, 0.01, "");
}

static void taut_rows_keep_their_energy(void)
{
	watch w = row_swings(CN_SOLVER_AUTO, 1, 1.0f, 0.0f, 600);
	CHECK_LE("energy that a rope loses in 10 s, part", fabs(w.energy_least - w.energy_start) / 5.0, 0.01, "");
}

/* They fall as free bodies do until they are taut. */
static void slack_ropes_pull_nothing(void)
{
	scene s = scene_open(10.0, 0, CN_SOLVER_AUTO);
	cn_body free_one, bead;
	cn_vec2 force;
	float torque;
	watch w;
	add_row(&s, 1, -0.5f * (float)PI, 5.0f, 0.4f);
	bead = last_body(&s);
	free_one = ball(&s, 3.0f, 0.1f, 5.0f);
	place(&s, free_one, 3.0f, -0.3f);
	fixture_step(s.world, 10);
	CHECK_LE("a load on a slack rope differs from a free one by", fabs((double)(fixture_velocity(s.world, bead).linear_mps.y - fixture_velocity(s.world, free_one).linear_mps.y)), 1e-5, "m/s");
	cn_body_destroy(s.world, free_one);
	--s.body_count;
	w = watch_begin(&s);
	watch_steps(&w, &s, 60);
	CHECK_LE("a load that falls into its rope opens it by", w.apart, 0.001, "m");
	CHECK_LE("... and is as fast as it fell", w.speed, 2.1, "m/s");
	must(cn_joint_get_reaction(s.world, s.joints[0], &force, &torque), s.world, "cn_joint_get_reaction");
	CHECK_LE("force of the rope that bears it, off by", fabs(hypot((double)force.x, (double)force.y) - 50.0), 0.5, "N");
	scene_close(&s);
}

/* A load at the end of its rope that moves back is not held. */
static void ropes_do_not_push(void)
{
	scene s = scene_open(0.0, 0, CN_SOLVER_AUTO);
	add_row(&s, 2, 0.0f, 5.0f, 0.0f);
	fixture_set_velocity(s.world, last_body(&s), -3.0f, 0.0f, 0.0f);
	fixture_step(s.world, 6);
	CHECK_LE("speed that a load on a rope loses as it moves back", fabs((double)fixture_velocity(s.world, last_body(&s)).linear_mps.x + 3.0), 1e-5, "m/s");
	CHECK_LE("... that the bead beside it gets", fabs((double)fixture_velocity(s.world, s.bodies[0]).linear_mps.x), 1e-5, "m/s");
	scene_close(&s);
}

/* Swung with 3.8 times its weight's energy at the lowest point, where 5 would bring it over the top, it leaves the circle above the middle. */
static void swung_loads_leave_their_circle(void)
{
	scene s = scene_open(10.0, 0, CN_SOLVER_AUTO);
	double least = 1.0;
	int32_t k;
	add_row(&s, 1, -0.5f * (float)PI, 5.0f, 0.0f);
	fixture_set_velocity(s.world, last_body(&s), (float)sqrt(3.8 * 10.0 * 0.5), 0.0f, 0.0f);
	for (k = 0; k < 60; ++k) {
		cn_pose p;
		fixture_step(s.world, 1);
		p = fixture_pose(s.world, last_body(&s));
		least = fmin(least, hypot((double)p.position_m.x, (double)p.position_m.y));
		CHECK(anchors_apart(&s) <= 0.001);
	}
	CHECK_LE("its least distance from the middle", least, 0.4, "m");
	scene_close(&s);
}

static void slack_rows_are_caught(void)
{
	double apart = 0.0;
	int32_t k;
	for (k = 1; k <= 8; ++k)
		apart = greater(apart, row_swings(CN_SOLVER_AUTO, 6, 10.0f * (float)k, 0.05f * (float)k, 180).apart);
	CHECK_LE("slack rows of 6 ropes, caught, open by", apart, 0.01, "m");
}

/* A hook of 1 kg on a rope, pinned to a load; what it hangs on moves to and fro. */
static double hook_opens(int32_t solver, float load)
{
	scene s = scene_open(10.0, 0, solver);
	cn_body dolly = fixture_body(s.world, CN_BODY_KINEMATIC, 0.0f, 0.0f, 0.0f), hook = ball(&s, 0.0f, 0.3f, 1.0f), box = ball(&s, 0.0f, 1.0f, load);
	double apart = 0.0;
	int32_t k;
	place(&s, hook, 0.0f, -4.0f);
	place(&s, box, 0.0f, -5.5f);
	rope(&s, dolly, at(0.0f, 0.0f), hook, 4.01f);
	pin(&s, hook, at(0.0f, -0.4f), box, at(0.0f, 1.1f));
	for (k = 0; k < 300; ++k) {
		fixture_set_velocity(s.world, dolly, 4.0f * (float)sin(0.03 * (double)k), 0.0f, 0.0f);
		fixture_step(s.world, 1);
		apart = greater(apart, anchors_apart(&s));
	}
	scene_close(&s);
	return apart;
}

static void hooks_bear_loads(void)
{
	CHECK_LE("a hook on a rope with a load of 1,500 kg opens by", hook_opens(CN_SOLVER_AUTO, 1500.0f), 0.01, "m");
	CHECK_LE("... with soft constraints", 0.05, hook_opens(CN_SOLVER_SOFT, 1500.0f), "m");
}

/* Its lowest middle is a load. Soft ropes stretch first: the net is too large to be exact until some of them are slack. */
static void nets_are_not_thrown(void)
{
	scene s = scene_open(10.0, 0, CN_SOLVER_AUTO);
	watch w;
	int32_t row, column;
	for (row = 0; row < 8; ++row)
		for (column = 0; column < 6; ++column) {
			float x = 0.5f * (float)column, y = -0.5f * (float)(row + 1);
			cn_body bead = ball(&s, x, 0.1f, row == 7 && column == 3 ? 300.0f : 1.0f);
			place(&s, bead, x, y);
			rope(&s, row == 0 ? 0 : s.bodies[s.body_count - 7], row == 0 ? at(x, 0.0f) : at(0.0f, 0.0f), bead, 0.5f);
			if (column > 0)
				rope(&s, s.bodies[s.body_count - 2], at(0.0f, 0.0f), bead, 0.5f);
		}
	w = watch_begin(&s);
	watch_steps(&w, &s, 240);
	CHECK_LE("beads of a net of ropes are as fast as", w.speed, 8.0, "m/s");
	CHECK_LE("... and gain energy, of the fall of its load by a rope", (w.energy - w.energy_start) / 1500.0, 0.05, "");
	scene_close(&s);
}

/* Two ropes a bead, which cross as the spokes of a bicycle, to a hub that a motor turns. The beads are the corners of a rim of rods. */
static void add_wheel(scene *s, int32_t beads)
{
	cn_body hub = ball(s, 0.0f, 0.5f, 20.0f);
	cn_revolute_def pin;
	int32_t k;
	place(s, hub, 0.0f, 0.0f);
	cn_revolute_def_init(&pin);
	connect(&pin.base, 0, at(0.0f, 0.0f), hub, at(0.0f, 0.0f));
	pin.base.flags |= CN_JOINT_MOTOR;
	pin.motor_speed_radps = 0.5f;
	pin.motor_torque_max_Nm = 1e6f;
	must(cn_joint_create_revolute(s->world, &pin, &s->joints[s->joint_count++]), s->world, "cn_joint_create_revolute");
	for (k = 0; k < beads; ++k) {
		double angle = 2.0 * PI * (double)k / (double)beads, side;
		float x = (float)(3.0 * cos(angle)), y = (float)(3.0 * sin(angle));
		cn_body bead = ball(s, x, 0.1f, k % 3 == 0 ? 20.0f : 1.0f);
		place(s, bead, x, y);
		for (side = -0.8; side < 1.0; side += 1.6) {
			cn_vec2 end = at((float)(0.5 * cos(angle + side)), (float)(0.5 * sin(angle + side)));
			rope(s, hub, end, bead, (float)hypot((double)(x - end.x), (double)(y - end.y)));
		}
		if (k > 0)
			tie(s, s->bodies[s->body_count - 2], at(0.0f, 0.0f), bead, (float)(6.0 * sin(PI / (double)beads)), 0, 0.0f);
	}
	tie(s, s->bodies[s->body_count - 1], at(0.0f, 0.0f), s->bodies[1], (float)(6.0 * sin(PI / (double)beads)), 0, 0.0f);
}

/* In each half second another bead is held for a quarter, while the motor turns the hub. */
static double wheels_speed(int32_t solver)
{
	double speed = 0.0;
	int32_t beads, act;
	for (beads = 6; beads <= 14; ++beads) {
		scene s = scene_open(10.0, 0, solver);
		watch w;
		add_wheel(&s, beads);
		w = watch_begin(&s);
		for (act = 0; act < 8; ++act) {
			cn_body held = s.bodies[1 + act * 3 % beads];
			watch_steps(&w, &s, 15);
			must(cn_body_set_type(s.world, held, CN_BODY_STATIC), s.world, "cn_body_set_type");
			watch_steps(&w, &s, 15);
			must(cn_body_set_type(s.world, held, CN_BODY_DYNAMIC), s.world, "cn_body_set_type");
		}
		speed = fmax(speed, w.speed);
		scene_close(&s);
	}
	return speed;
}

static void wheels_that_are_held_are_not_thrown(void)
{
	CHECK_LE("beads of wheels with spokes of rope are as fast as", wheels_speed(CN_SOLVER_AUTO), 1.3 * wheels_speed(CN_SOLVER_SOFT), "m/s");
}

static void ropes_rest(void)
{
	scene s = scene_open(10.0, 1, CN_SOLVER_AUTO);
	add_row(&s, 6, -0.5f * (float)PI, 50.0f, 0.01f);
	fixture_step(s.world, 900);
	CHECK(!fixture_is_awake(s.world, last_body(&s)));
	scene_close(&s);
}

/* Of two ropes one below the other, with 100 N at most. */
static void ropes_break_at_their_threshold(void)
{
	static const float loads[] = { 8.8f, 9.2f };
	int32_t k;
	for (k = 0; k < 2; ++k) {
		scene s = scene_open(10.0, 0, CN_SOLVER_AUTO);
		cn_body upper = ball(&s, 0.0f, 0.1f, 1.0f), lower = ball(&s, 0.0f, 0.1f, loads[k]);
		place(&s, upper, 0.0f, -0.5f);
		place(&s, lower, 0.0f, -1.0f);
		tie(&s, 0, at(0.0f, 0.0f), upper, 0.5f, CN_JOINT_LIMIT | CN_JOINT_BREAKS, 100.0f);
		tie(&s, upper, at(0.0f, 0.0f), lower, 0.5f, CN_JOINT_LIMIT | CN_JOINT_BREAKS, 100.0f);
		fixture_step(s.world, 60);
		CHECK(cn_joint_is_valid(s.world, s.joints[0]) == (k == 0));
		CHECK(cn_joint_is_valid(s.world, s.joints[1]));
		scene_close(&s);
	}
}

int main(void)
{
	RUN(rows_bear_loads);
	RUN(taut_rows_keep_their_energy);
	RUN(slack_ropes_pull_nothing);
	RUN(ropes_do_not_push);
	RUN(swung_loads_leave_their_circle);
	RUN(slack_rows_are_caught);
	RUN(hooks_bear_loads);
	RUN(nets_are_not_thrown);
	RUN(wheels_that_are_held_are_not_thrown);
	RUN(ropes_rest);
	RUN(ropes_break_at_their_threshold);
	return test_end();
}
