/*
 * test/joints/joint_rows_test.c - rods, ties, welds, slides and wheels in lanes (joints/joint_rows.c, joint_rows_kernel.h).
 *
 * Lanes are held to rows: a joint with a break threshold that is never reached is solved by joints/joint_solve.c. Where no
 * two joints share a body the order does not matter, and both must give the same bits; in nets, as small errors. If only
 * the widths disagree look in base/wide.h and joint_rows_kernel.h; if a form disagrees with its rows, in rows_make and in
 * its file in model/.
 */
#include "base/cpu.h"
#include "joints/joint_pass.h"
#include "world/nets.h"

#define BODIES (2 * CNI_LANES + 1)

/* ---- kernels ---- */

typedef struct bench {
	cni_row_block block;
	cni_motion motions[BODIES];
	cni_velocity_start starts[BODIES];
} bench;

static CNI_ALIGNED(64) bench drawn, plain, wide; /* as the kernels expect blocks and motions */

static void draw_row(float *row, uint32_t *random, float lower, float upper)
{
	int32_t l;
	for (l = 0; l < drawn.block.lanes; ++l)
		row[l] = fixture_random(random, lower, upper);
}

static void bodies_draw(uint32_t *random)
{
	int32_t k;
	for (k = 1; k < BODIES; ++k) {
		cni_motion *m = drawn.motions + k;
		m->vx = fixture_random(random, -5.0f, 5.0f);
		m->vy = fixture_random(random, -5.0f, 5.0f);
		m->w = fixture_random(random, -20.0f, 20.0f);
		m->inv_mass = fixture_random(random, -0.3f, 2.0f) > 0.0f ? fixture_random(random, 0.01f, 10.0f) : 0.0f;
		m->inv_inertia = fixture_random(random, -0.3f, 2.0f) > 0.0f ? fixture_random(random, 0.01f, 100.0f) : 0.0f;
		m->dpx = fixture_random(random, -0.1f, 0.1f);
		m->dpy = fixture_random(random, -0.1f, 0.1f);
		m->theta = fixture_random(random, -2.0f, 2.0f);
		drawn.starts[k].w = fixture_random(random, -20.0f, 20.0f);
	}
}

static void numbers_draw(uint32_t *random)
{
	cni_row_block *k = &drawn.block;
	int32_t r;
	draw_row(k->ax0, random, -1.0f, 1.0f), draw_row(k->ay0, random, -1.0f, 1.0f), draw_row(k->bx0, random, -1.0f, 1.0f), draw_row(k->by0, random, -1.0f, 1.0f);
	draw_row(k->dx0, random, -0.3f, 0.3f), draw_row(k->dy0, random, -0.3f, 0.3f), draw_row(k->angle0, random, -1.0f, 1.0f);
	draw_row(k->qc0, random, 0.6f, 0.8f), draw_row(k->qs0, random, 0.6f, 0.8f), draw_row(k->axis_x, random, 0.6f, 0.8f), draw_row(k->axis_y, random, 0.6f, 0.8f);
	draw_row(k->rest, random, 0.1f, 0.5f), draw_row(k->lower, random, -0.2f, 0.1f), draw_row(k->upper, random, 0.1f, 0.3f);
	draw_row(k->spring_mass, random, 0.0f, 1.0f), draw_row(k->spring_bias, random, 0.0f, 20.0f), draw_row(k->spring_impulse_scale, random, 0.0f, 0.5f);
	draw_row(k->speed, random, -5.0f, 5.0f), draw_row(k->most, random, 0.0f, 50.0f);
	draw_row(k->spring_j, random, -1.0f, 1.0f), draw_row(k->motor_j, random, -0.2f, 0.2f), draw_row(k->limit_j, random, 0.0f, 1.0f);
	for (r = 0; r < CNI_JOINT_RIGID_ROWS; ++r)
		draw_row(k->j[r], random, -3.0f, 3.0f);
}

static void bench_draw(uint32_t seed)
{
	uint32_t random = seed * 2654435761u + 1u;
	cni_row_block *k = &drawn.block;
	int32_t l;
	memset(&drawn, 0, sizeof drawn);
	k->form = 1 + (int32_t)(seed % (CNI_FORMS - 1));
	k->lanes = 1 + (int32_t)(seed % CNI_LANES);
	if (k->form == CNI_FORM_SOFT_WELD)
		k->has = CN_JOINT_SPRING;
	else if (k->form != CNI_FORM_ROD && k->form != CNI_FORM_WELD)
		k->has = (seed / 7 % 2 ? CN_JOINT_SPRING : 0) | (seed / 14 % 2 ? CN_JOINT_MOTOR : 0) | (seed / 28 % 2 ? CN_JOINT_LIMIT : 0);
	bodies_draw(&random);
	for (l = 0; l < k->lanes; ++l) {
		k->ia[l] = seed % 3 == 0 && l == 2 ? 0 : 1 + l;
		k->ib[l] = 1 + CNI_LANES + l;
		k->ai[l] = drawn.motions[k->ia[l]].inv_inertia;
		k->bi[l] = drawn.motions[k->ib[l]].inv_inertia;
		k->moves_a |= (uint32_t)cni_motion_can_move(drawn.motions + k->ia[l]) << l;
		k->moves_b |= (uint32_t)cni_motion_can_move(drawn.motions + k->ib[l]) << l;
	}
	numbers_draw(&random);
}

static void bench_run(bench *b, const cni_joint_kernel *kernel)
{
	cni_joint_pass pass = { 1.0f / 240.0f, 240.0f, 0.9f, { 0.9f, 60.0f, 0.1f } };
	int32_t k;
	*b = drawn;
	kernel->rows_begin(b->motions, b->starts, &b->block, &pass);
	kernel->rows_warm(b->motions, b->starts, &b->block, &pass);
	for (k = 0; k < 2; ++k) {
		kernel->rows_solve(b->motions, b->starts, &b->block, &pass);
		b->motions[1].theta += 0.3f;
		b->motions[2 + CNI_LANES].dpx += 0.6f;
		kernel->rows_relax(b->motions, b->starts, &b->block, &pass);
	}
	kernel->rows_finish(b->motions, b->starts, &b->block, &pass);
}

/* Of lanes that are taken; what lies behind them may be anything. */
static int32_t rows_differ(void)
{
	const int32_t rows = (int32_t)(offsetof(cni_row_block, constraint) / sizeof(float[CNI_LANES]));
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
		differ += rows_differ();
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

/* ---- lanes and rows ---- */

static cn_world *soft_world(void)
{
	cn_world *world = fixture_world(-10.0f, 0);
	must(cn_world_set_solver(world, CN_SOLVER_SOFT), world, "cn_world_set_solver");
	return world;
}

/* Of the last step. */
static int32_t joints_by_rows(const cn_world *world)
{
	int32_t k, count = 0;
	for (k = world->joint_plain_first; k != CNI_NONE; k = cni_joint_constraints(world)[k].next_plain)
		++count;
	return count;
}

#define PAIRS 60

/* Pairs of bodies, every third joint to the world, that share nothing; spin makes some turn far in a step. */
static cn_world *pairs(int32_t kind, int32_t how, cn_body *bodies)
{
	cn_world *world = soft_world();
	int32_t k;
	for (k = 0; k < PAIRS; ++k) {
		float x = 4.0f * (float)k, spin = k % 7 == 0 ? 70.0f : 0.3f * (float)k;
		cn_body a = k % 3 == 0 ? 0 : fixture_box(world, CN_BODY_DYNAMIC, x, 0.0f, 0.0f, 0.2f, 0.3f, 0.6f, 0.0f);
		bodies[k] = fixture_box(world, CN_BODY_DYNAMIC, x + 1.0f, 0.0f, 0.1f * (float)(k % 5), 0.3f, 0.2f, 0.6f, 0.0f);
		fixture_set_velocity(world, bodies[k], 0.5f * (float)(k % 4), 1.0f, spin);
		net_link(world, kind, how, k, a, at(a == 0 ? x : 0.0f, 0.0f), bodies[k], 1.0f, 0.0f);
	}
	return world;
}

static void lanes_have_the_bits_of_rows(void)
{
	int32_t kind, k, step;
	for (kind = NET_ROD; kind < NET_KINDS; ++kind) {
		cn_body in_lanes[PAIRS], by_rows[PAIRS];
		cn_world *lanes = pairs(kind, NET_IN_LANES, in_lanes), *rows = pairs(kind, NET_BY_ROWS, by_rows);
		int32_t differ = 0;
		printf("  %s\n", net_name(kind));
		for (step = 0; step < 90; ++step) {
			fixture_step(lanes, 1);
			fixture_step(rows, 1);
			for (k = 0; k < PAIRS; ++k) {
				cn_velocity v = fixture_velocity(lanes, in_lanes[k]), w = fixture_velocity(rows, by_rows[k]);
				differ += memcmp(&v, &w, sizeof v) != 0;
			}
		}
		CHECK(joints_by_rows(lanes) == 0 && joints_by_rows(rows) == PAIRS);
		CHECK_LE("velocities whose bits differ", differ, 0, "of 5400");
		cn_world_destroy(lanes);
		cn_world_destroy(rows);
	}
}

#define SIDE 10

static double largest_gap(int32_t kind, int32_t how, int32_t *by_rows)
{
	cn_world *world = soft_world();
	cn_joint joints[2 * SIDE * SIDE];
	double worst = 0.0;
	int32_t k;
	net_fill(world, kind, how, SIDE, joints);
	for (k = 0; k < 120; ++k)
		fixture_step(world, 1);
	*by_rows = joints_by_rows(world);
	for (k = 0; k < 2 * SIDE * SIDE; ++k)
		worst = greater(worst, joint_error_m(world, joints[k]));
	CHECK(fixture_is_valid(world));
	cn_world_destroy(world);
	return worst;
}

static void nets_hold_as_well_in_lanes(void)
{
	int32_t kind;
	for (kind = NET_ROD; kind < NET_KINDS; ++kind) {
		int32_t few, all;
		double lanes = largest_gap(kind, NET_IN_LANES, &few), rows = largest_gap(kind, NET_BY_ROWS, &all);
		printf("  %s: %g m by rows\n", net_name(kind), rows);
		CHECK_LE("largest gap in lanes", lanes, 1.3 * rows + 1e-4, "m");
		CHECK(few == 0 && all == 2 * SIDE * SIDE);
	}
}

/* ---- memory ---- */

/* After 20 steps; the world is destroyed. */
static uint64_t slides_hash(const cn_world_def *def)
{
	cn_world *world = NULL;
	uint64_t hash;
	must(cn_world_create(def, &world), NULL, "cn_world_create");
	net_fill(world, NET_SLIDE, NET_IN_LANES, SIDE, NULL);
	fixture_step(world, 20);
	CHECK(joints_by_rows(world) == 0);
	hash = fixture_hash(world);
	cn_world_destroy(world);
	return hash;
}

/* A world in a caller's block has room for all its lanes. */
static void fixed_memory_changes_nothing(void)
{
	cn_world_def def;
	uint64_t growing;
	unsigned char *raw;
	cn_world_def_init(&def);
	def.solver = CN_SOLVER_SOFT;
	growing = slides_hash(&def);
	def.body_capacity = def.shape_capacity = SIDE * SIDE + 1;
	def.contact_capacity = 16;
	def.joint_capacity = 2 * SIDE * SIDE;
	must(cn_world_bytes_needed(&def, &def.memory_bytes), NULL, "cn_world_bytes_needed");
	raw = (unsigned char *)malloc((size_t)def.memory_bytes + 64);
	REQUIRE(raw != NULL);
	def.memory = raw + (64 - (uintptr_t)raw % 64) % 64;
	CHECK(slides_hash(&def) == growing);
	free(raw);
}

/* ---- every build ---- */

/* As in test/world/determinism_test.c, whose rules for replacing these hold here. */
static void nets_have_golden_bits(void)
{
	static const uint64_t golden[NET_KINDS] = {
		0x6fd69acb0721a147, 0x2b2515f8c2008c61, 0x1e58133f66334b4a, 0x03f2fb1aa1920542, 0x2c3ca2e44f2d735a, 0xd6d0b97c70393ac3, 0xa5e7f4c3c73a09f0
	};
	int32_t kind, k;
	for (kind = 0; kind < NET_KINDS; ++kind) {
		cn_world *world = soft_world();
		uint64_t digest = 0xCBF29CE484222325u;
		net_fill(world, kind, NET_IN_LANES, SIDE, NULL);
		for (k = 0; k < 30; ++k) {
			fixture_step(world, 1);
			digest = (digest ^ fixture_hash(world)) * 0x100000001B3u;
		}
		printf("  %s: 0x%016llx, golden 0x%016llx\n", net_name(kind), (unsigned long long)digest, (unsigned long long)golden[kind]);
		CHECK(test_golden_holds(digest, golden[kind]));
		cn_world_destroy(world);
	}
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(every_width_has_the_same_bits);
	RUN(lanes_have_the_bits_of_rows);
	RUN(nets_hold_as_well_in_lanes);
	RUN(fixed_memory_changes_nothing);
	RUN(nets_have_golden_bits);
	return test_end();
}
