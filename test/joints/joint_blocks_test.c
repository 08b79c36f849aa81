/*
 * test/joints/joint_blocks_test.c - joints in lanes (joints/joint_blocks.c, joints/joint_kernel.h).
 *
 * Lanes are held to rows: a joint with a break threshold that is never reached is solved by rows, so the same mechanism
 * with and without one must move alike. If only the widths disagree look in base/wide.h and joints/joint_kernel.h; if a
 * body is twice in a colour, in color_take. If lanes that are kept differ from new ones, in lane_fill_again.
 */
#include "base/cpu.h"
#include "joints/joint_pass.h"
#include "world/joints.h"

#define BODIES (2 * CNI_LANES + 1)

/* ---- kernels ---- */

/* xorshift32 (Marsaglia, 2003) */
static uint32_t random_state;
static float pick(float lower, float upper)
{
	random_state ^= random_state << 13;
	random_state ^= random_state >> 17;
	random_state ^= random_state << 5;
	return lower + (upper - lower) * (float)(random_state >> 8) / 16777216.0f;
}

/* Everything that a kernel reads and writes. */
typedef struct bench {
	cni_joint_block block;
	cni_motion motions[BODIES];
	cni_velocity_start starts[BODIES];
} bench;

static CNI_ALIGNED(64) bench drawn, plain, wide; /* as the kernels expect blocks and motions */

static void pick_row(float *row, float lower, float upper)
{
	int32_t l;
	for (l = 0; l < drawn.block.lanes; ++l)
		row[l] = pick(lower, upper);
}

static void bodies_draw(void)
{
	int32_t k;
	for (k = 1; k < BODIES; ++k) {
		cni_motion *m = drawn.motions + k;
		m->vx = pick(-5.0f, 5.0f);
		m->vy = pick(-5.0f, 5.0f);
		m->w = pick(-20.0f, 20.0f);
		m->inv_mass = pick(-0.3f, 2.0f) > 0.0f ? pick(0.01f, 10.0f) : 0.0f;
		m->inv_inertia = pick(-0.3f, 2.0f) > 0.0f ? pick(0.01f, 100.0f) : 0.0f;
		m->dpx = pick(-0.1f, 0.1f);
		m->dpy = pick(-0.1f, 0.1f);
		m->theta = pick(-2.0f, 2.0f);
		drawn.starts[k].w = pick(-20.0f, 20.0f);
	}
}

static int32_t can_move(int32_t body)
{
	return drawn.motions[body].inv_mass > 0.0f || drawn.motions[body].inv_inertia > 0.0f;
}

/* Points apart, so that axes turn and some reverse. */
static void axes_draw(void)
{
	cni_joint_block *k = &drawn.block;
	int32_t l;
	pick_row(k->dx0, -1.0f, 1.0f), pick_row(k->dy0, -1.0f, 1.0f);
	for (l = 0; l < k->lanes; ++l) {
		float turn = pick(-3.0f, 3.0f);
		k->ex[l] = cosf(turn);
		k->ey[l] = sinf(turn);
	}
}

static void bench_draw(uint32_t seed)
{
	cni_joint_block *k = &drawn.block;
	int32_t l;
	memset(&drawn, 0, sizeof drawn);
	random_state = seed * 2654435761u + 1u;
	k->lanes = 1 + (int32_t)(seed % CNI_LANES);
	k->form = seed % 5 < 2 ? CNI_FORM_DISTANCE : CNI_FORM_PIN;
	bodies_draw();
	for (l = 0; l < k->lanes; ++l) {
		k->ia[l] = seed % 3 == 0 && l == 2 ? 0 : 1 + l;
		k->ib[l] = 1 + CNI_LANES + l;
		k->ai[l] = drawn.motions[k->ia[l]].inv_inertia;
		k->bi[l] = drawn.motions[k->ib[l]].inv_inertia;
		k->moves_a |= (uint32_t)can_move(k->ia[l]) << l;
		k->moves_b |= (uint32_t)can_move(k->ib[l]) << l;
		k->held |= seed % 4 < 2 && pick(0.0f, 1.0f) < 0.3f ? 1u << l : 0;
	}
	pick_row(k->ax0, -1.0f, 1.0f), pick_row(k->ay0, -1.0f, 1.0f), pick_row(k->bx0, -1.0f, 1.0f), pick_row(k->by0, -1.0f, 1.0f);
	pick_row(k->ax, -1.0f, 1.0f), pick_row(k->ay, -1.0f, 1.0f), pick_row(k->bx, -1.0f, 1.0f), pick_row(k->by, -1.0f, 1.0f);
	pick_row(k->dx0, -0.01f, 0.01f), pick_row(k->dy0, -0.01f, 0.01f), pick_row(k->ex, -0.01f, 0.01f), pick_row(k->ey, -0.01f, 0.01f);
	pick_row(k->jx, -3.0f, 3.0f), pick_row(k->jy, -3.0f, 3.0f);
	k->parts = (k->held ? CN_JOINT_SPRING : 0) | (seed / 7 % 2 ? CN_JOINT_SPRING : 0) | (seed / 14 % 2 ? CN_JOINT_MOTOR : 0) | (seed / 28 % 2 ? CN_JOINT_LIMIT : 0);
	if (k->form == CNI_FORM_DISTANCE)
		axes_draw();
	pick_row(k->angle0, -1.0f, 1.0f), pick_row(k->measure, -1.0f, 1.0f), pick_row(k->rest, -1.0f, 1.0f);
	pick_row(k->spring_mass, 0.0f, 1.0f), pick_row(k->spring_bias, 0.0f, 20.0f), pick_row(k->spring_impulse_scale, 0.0f, 0.5f), pick_row(k->spring_j, -1.0f, 1.0f);
	pick_row(k->speed, -5.0f, 5.0f), pick_row(k->most, 0.0f, 50.0f), pick_row(k->motor_j, -0.2f, 0.2f);
	pick_row(k->lower, -1.0f, 0.0f), pick_row(k->upper, 0.0f, 1.0f), pick_row(k->limit_j, -1.0f, 1.0f);
}

static void bench_run(bench *b, const cni_joint_kernel *kernel)
{
	cni_joint_pass pass = { 1.0f / 240.0f, 240.0f, 0.9f, { 0.9f, 60.0f, 0.1f }, 1.0f };
	*b = drawn;
	kernel->warm(b->motions, b->starts, &b->block, &pass);
	kernel->solve(b->motions, b->starts, &b->block, &pass);
	kernel->relax(b->motions, b->starts, &b->block, &pass);
	kernel->solve(b->motions, b->starts, &b->block, &pass);
}

/* Of lanes that are taken; what lies behind them may be anything. */
static int32_t lanes_differ(void)
{
	const int32_t rows = (int32_t)(offsetof(cni_joint_block, form) / sizeof(float[CNI_LANES]));
	int32_t k, differ = memcmp(plain.motions, wide.motions, sizeof plain.motions) != 0 || memcmp(plain.starts, wide.starts, sizeof plain.starts) != 0;
	for (k = 0; k < rows; ++k)
		differ |= memcmp((const float *)(const void *)&plain.block + k * CNI_LANES, (const float *)(const void *)&wide.block + k * CNI_LANES, sizeof(float) * (size_t)drawn.block.lanes) != 0;
	return differ;
}

static void width_has_the_bits_of_one(const cni_joint_kernel *kernel)
{
	uint32_t seed;
	int32_t differ = 0;
	for (seed = 1; seed <= 600; ++seed) {
		bench_draw(seed);
		bench_run(&plain, &cni_joint_kernel_plain);
		bench_run(&wide, kernel);
		differ += lanes_differ();
	}
	CHECK_LE("blocks whose bits differ", differ, 0, "of 600");
}

static void every_width_has_the_same_bits(void)
{
	const cni_joint_kernel *kernel = cni_joint_kernel_choose();
	if (kernel == &cni_joint_kernel_plain)
		SKIP("this build has no vectors");
	width_has_the_bits_of_one(kernel);
#if CNI_HAS_WIDE_4
	width_has_the_bits_of_one(&cni_joint_kernel_4);
#endif
}

/* ---- mechanisms, in lanes and by rows ---- */

enum { IN_LANES = 0, BY_ROWS = 1 };

static cn_world *soft_world(float gravity)
{
	cn_world *world = fixture_world(gravity, 0);
	must(cn_world_set_solver(world, CN_SOLVER_SOFT), world, "cn_world_set_solver");
	return world;
}

static cn_revolute_def pin_def(cn_body a, float ax, float ay, cn_body b, float bx, float by, int32_t how)
{
	cn_revolute_def def = revolute_def(a, at(ax, ay), b, at(bx, by));
	if (how == BY_ROWS)
		def.base.break_force_N = 1e30f;
	return def;
}

static cn_joint pin(cn_world *world, const cn_revolute_def *def)
{
	cn_joint joint = 0;
	must(cn_joint_create_revolute(world, def, &joint), world, "cn_joint_create_revolute");
	return joint;
}

static int32_t joints_in_lanes(const cn_world *world)
{
	int32_t k, lanes = 0;
	for (k = 0; k < world->joint_blocks.count; ++k)
		lanes += cni_joint_blocks(world)[k].lanes;
	return lanes;
}

/* The end of a bar that swings about the world with a spring and a motor between limits, after so many steps. */
static cn_vec2 bar_end(uint32_t flags, int32_t how, int32_t steps)
{
	cn_world *world = soft_world(-10.0f);
	cn_body bar = fixture_box(world, CN_BODY_DYNAMIC, 1.0f, 0.0f, 0.0f, 1.0f, 0.1f, 0.6f, 0.0f);
	cn_revolute_def def = pin_def(0, 0.0f, 0.0f, bar, -1.0f, 0.0f, how);
	cn_vec2 end;
	int32_t k;
	def.base.flags |= flags;
	def.lower_angle_rad = -0.7f;
	def.upper_angle_rad = 0.5f;
	def.motor_speed_radps = 1.0f;
	def.motor_torque_max_Nm = 1.5f;
	def.spring_hertz = 2.0f;
	def.spring_damping_ratio = 0.1f;
	def.spring_target_rad = 0.2f;
	pin(world, &def);
	for (k = 0; k < steps; ++k)
		must(cn_world_step(world, FRAME_S), world, "cn_world_step");
	if (joints_in_lanes(world) != (how == IN_LANES))
		test_fail(__FILE__, __LINE__, "the joint is solved where the test means it to be");
	end = fixture_pose(world, bar).position_m;
	cn_world_destroy(world);
	return end;
}

static void lanes_move_as_rows_do(void)
{
	static const uint32_t flags[] = { 0, CN_JOINT_SPRING, CN_JOINT_MOTOR, CN_JOINT_LIMIT, CN_JOINT_MOTOR | CN_JOINT_LIMIT, CN_JOINT_SPRING | CN_JOINT_MOTOR | CN_JOINT_LIMIT };
	size_t k;
	for (k = 0; k < sizeof flags / sizeof *flags; ++k) {
		cn_vec2 lane = bar_end(flags[k], IN_LANES, 120), row = bar_end(flags[k], BY_ROWS, 120);
		CHECK_LE("distance after 2 s", hypot((double)(lane.x - row.x), (double)(lane.y - row.y)), 2e-5, "m");
	}
}

/* ---- colours ---- */

#define SPOKES 40

/* A hub with more joints than a body has colours. */
static cn_world *wheel(cn_joint *joints, float spin)
{
	cn_world *world = soft_world(0.0f);
	cn_body hub = fixture_circle(world, CN_BODY_DYNAMIC, 0.0f, 0.0f, 3.0f, 0.6f, 0.0f), rim[SPOKES];
	int32_t k;
	for (k = 0; k < SPOKES; ++k) {
		double angle = 6.283185307179586 * k / SPOKES;
		float x = (float)(3.0 * cos(angle)), y = (float)(3.0 * sin(angle));
		cn_revolute_def def;
		rim[k] = fixture_circle(world, CN_BODY_DYNAMIC, x, y, 0.1f, 0.6f, 0.0f);
		must(cn_body_set_velocity(world, rim[k], -spin * y, spin * x, spin), world, "cn_body_set_velocity");
		def = pin_def(hub, x, y, rim[k], 0.0f, 0.0f, IN_LANES);
		joints[k] = pin(world, &def);
	}
	must(cn_body_set_velocity(world, hub, 0.0f, 0.0f, spin), world, "cn_body_set_velocity");
	return world;
}

static void no_body_is_twice_in_a_colour(void)
{
	cn_joint joints[SPOKES];
	cn_world *world = wheel(joints, 1.0f);
	int32_t color, index, l, twice = 0, held = 0, plain_works = 0, k;
	must(cn_world_step(world, FRAME_S), world, "cn_world_step");
	for (color = 0; color < CNI_JOINT_COLORS; ++color) {
		uint8_t seen[SPOKES + 2] = { 0 };
		for (index = 0; index < world->joint_blocks.count; ++index) {
			const cni_joint_block *b = cni_joint_blocks(world) + index;
			for (l = 0; l < b->lanes && b->color == color; ++l) {
				twice += seen[b->ia[l]]++ + seen[b->ib[l]]++;
				++held;
			}
		}
	}
	for (k = world->joint_plain_first; k != CNI_NONE; k = cni_joint_constraints(world)[k].next_plain)
		++plain_works;
	CHECK_LE("bodies that are twice in a colour", twice, 0, "");
	CHECK(held == CNI_JOINT_COLORS);
	CHECK(held + plain_works == SPOKES);
	cn_world_destroy(world);
}

/* At 1 rad/s, in lanes; at 100 rad/s, which is more than lanes turn in a step, by rows. */
static void wheels_stay_together(void)
{
	static const float spins[] = { 1.0f, 100.0f };
	size_t s;
	for (s = 0; s < 2; ++s) {
		cn_joint joints[SPOKES];
		cn_world *world = wheel(joints, spins[s]);
		double worst = 0.0;
		int32_t k, step;
		for (step = 0; step < 60; ++step)
			must(cn_world_step(world, FRAME_S), world, "cn_world_step");
		for (k = 0; k < SPOKES; ++k) {
			float m = 0.0f, rad = 0.0f;
			must(cn_joint_get_error(world, joints[k], &m, &rad), world, "cn_joint_get_error");
			worst = greater(worst, (double)m);
		}
		CHECK(joints_in_lanes(world) == (spins[s] < 90.0f ? CNI_JOINT_COLORS : 0));
		CHECK_LE("largest gap after 1 s / arm", worst / 3.0, spins[s] < 90.0f ? 1e-4 : 0.1, "");
		cn_world_destroy(world);
	}
}

/* Both ends of the limits are the same angle: it holds a bar whichever way it is pulled. */
static void equal_limits_hold_both_ways(void)
{
	int32_t way;
	for (way = -1; way <= 1; way += 2) {
		cn_world *world = soft_world(10.0f * (float)way);
		cn_body bar = fixture_box(world, CN_BODY_DYNAMIC, 1.0f, 0.0f, 0.0f, 1.0f, 0.1f, 0.6f, 0.0f);
		cn_revolute_def def = pin_def(0, 0.0f, 0.0f, bar, -1.0f, 0.0f, IN_LANES);
		double worst = 0.0;
		cn_joint joint;
		int32_t step;
		def.base.flags |= CN_JOINT_LIMIT;
		joint = pin(world, &def);
		for (step = 0; step < 120; ++step) {
			float angle = 0.0f;
			must(cn_world_step(world, FRAME_S), world, "cn_world_step");
			must(cn_joint_get_position(world, joint, &angle), world, "cn_joint_get_position");
			worst = greater(worst, fabs((double)angle));
		}
		CHECK_LE("largest angle", worst, 1e-3, "rad");
		cn_world_destroy(world);
	}
}

/* ---- lanes that are kept ---- */

enum { NET = 6, NET_JOINTS = NET * (NET - 1) };

typedef struct net {
	cn_world *world;
	cn_body bodies[NET * NET];
	cn_joint joints[NET_JOINTS];
	int32_t steps_kept;
} net;

/* Chains side by side. How BY_ROWS: with a joint far away that has no lane, so that lanes are taken anew in every step. */
static void net_open(net *n, int32_t how)
{
	int32_t k;
	n->world = soft_world(-10.0f);
	n->steps_kept = 0;
	for (k = 0; k < NET * NET; ++k) {
		cn_revolute_def def;
		n->bodies[k] = fixture_circle(n->world, k < NET ? CN_BODY_STATIC : CN_BODY_DYNAMIC, 3.0f * (float)(k % NET), -1.0f * (float)(k / NET), 0.3f, 0.6f, 0.0f);
		if (k < NET)
			continue;
		def = pin_def(n->bodies[k - NET], 0.0f, -0.5f, n->bodies[k], 0.1f * (float)(k % NET), 0.5f, IN_LANES);
		n->joints[k - NET] = pin(n->world, &def);
	}
	if (how == BY_ROWS) {
		cn_body far = fixture_circle(n->world, CN_BODY_DYNAMIC, -100.0f, 0.0f, 0.3f, 0.6f, 0.0f);
		cn_revolute_def def = pin_def(0, -100.0f, 1.0f, far, 0.0f, 1.0f, BY_ROWS);
		pin(n->world, &def);
	}
}

/* All that may change which joints are in which lanes, or what is in these. */
static void net_change(net *n, int32_t step)
{
	cn_revolute_def def = pin_def(n->bodies[NET], 0.0f, -0.5f, n->bodies[2 * NET], 0.0f, 0.5f, IN_LANES);
	if (step == 10)
		must(cn_joint_set_flags(n->world, n->joints[7], CN_JOINT_MOTOR), n->world, "cn_joint_set_flags");
	if (step == 20)
		must(cn_joint_set_flags(n->world, n->joints[7], CN_JOINT_SPRING | CN_JOINT_LIMIT), n->world, "cn_joint_set_flags");
	if (step == 30)
		must(cn_joint_set_flags(n->world, n->joints[7], 0), n->world, "cn_joint_set_flags");
	if (step == 40)
		must(cn_body_set_type(n->world, n->bodies[3 * NET], CN_BODY_STATIC), n->world, "cn_body_set_type");
	if (step == 50)
		must(cn_body_set_type(n->world, n->bodies[3 * NET], CN_BODY_DYNAMIC), n->world, "cn_body_set_type");
	if (step == 60)
		must(cn_body_set_velocity(n->world, n->bodies[NET * NET - 1], 0.0f, 0.0f, 200.0f), n->world, "cn_body_set_velocity");
	if (step == 70)
		must(cn_joint_destroy(n->world, n->joints[NET]), n->world, "cn_joint_destroy");
	if (step == 80)
		n->joints[NET] = pin(n->world, &def);
	if (step == 90)
		must(cn_body_set_flags(n->world, n->bodies[2 * NET + 1], 0), n->world, "cn_body_set_flags");
	if (step == 100)
		must(cn_body_set_flags(n->world, n->bodies[2 * NET + 1], CN_BODY_ENABLED), n->world, "cn_body_set_flags");
}

static void net_step(net *n, int32_t step)
{
	net_change(n, step);
	must(cn_world_step(n->world, FRAME_S), n->world, "cn_world_step");
	n->steps_kept += n->world->joint_lanes.lanes > 0 && n->world->joint_lanes.filled == n->world->joint_lanes.lanes;
}

static int32_t nets_differ(const net *a, const net *b)
{
	int32_t k, differ = 0;
	for (k = 0; k < NET * NET; ++k) {
		cn_pose at_a = fixture_pose(a->world, a->bodies[k]), at_b = fixture_pose(b->world, b->bodies[k]);
		differ += memcmp(&at_a, &at_b, sizeof at_a) != 0;
	}
	return differ;
}

static void lanes_that_are_kept_have_the_bits_of_new_ones(void)
{
	net kept, anew;
	int32_t step, differ = 0;
	net_open(&kept, IN_LANES);
	net_open(&anew, BY_ROWS);
	for (step = 0; step < 120; ++step) {
		net_step(&kept, step);
		net_step(&anew, step);
		differ += nets_differ(&kept, &anew);
	}
	CHECK_LE("poses whose bits differ", differ, 0, "");
	CHECK(kept.steps_kept > 90 && kept.steps_kept < 119);
	CHECK(anew.steps_kept == 0);
	cn_world_destroy(kept.world);
	cn_world_destroy(anew.world);
}

/* After a step of a solver without blocks the array holds none, and when it grows nothing of it comes along. */
static void lanes_are_not_kept_past_a_solver_without_blocks(void)
{
	net kept, anew;
	int32_t step, differ = 0;
	net_open(&kept, IN_LANES);
	net_open(&anew, BY_ROWS);
	for (step = 0; step < 9; ++step) {
		if (step == 5 || step == 6) {
			must(cn_world_set_solver(kept.world, step == 5 ? CN_SOLVER_SEQUENTIAL : CN_SOLVER_SOFT), kept.world, "cn_world_set_solver");
			must(cn_world_set_solver(anew.world, step == 5 ? CN_SOLVER_SEQUENTIAL : CN_SOLVER_SOFT), anew.world, "cn_world_set_solver");
		}
		net_step(&kept, step);
		net_step(&anew, step);
		differ += nets_differ(&kept, &anew);
		if (step == 6)
			CHECK(kept.world->joint_lanes.filled == 0);
	}
	CHECK_LE("poses whose bits differ", differ, 0, "");
	CHECK(kept.steps_kept > 2);
	cn_world_destroy(kept.world);
	cn_world_destroy(anew.world);
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(every_width_has_the_same_bits);
	RUN(lanes_move_as_rows_do);
	RUN(no_body_is_twice_in_a_colour);
	RUN(wheels_stay_together);
	RUN(equal_limits_hold_both_ways);
	RUN(lanes_that_are_kept_have_the_bits_of_new_ones);
	RUN(lanes_are_not_kept_past_a_solver_without_blocks);
	return test_end();
}
