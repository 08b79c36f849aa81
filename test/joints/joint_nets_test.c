/*
 * test/joints/joint_nets_test.c - distance and fixed joints in lanes (joints/joint_blocks.c, joint_kernel.h), and nets of every kind.
 *
 * Lanes are held to rows: a joint with a break threshold that is never reached is solved by joints/joint_solve.c. Where no
 * two joints share a body both must move alike; in nets, errors must be as small. Slides and wheels have rows only.
 */
#include "joints/joint_pass.h"
#include "world/nets.h"

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

/* Pairs of bodies, every third joint to the world, that share nothing. */
static cn_world *pairs(int32_t kind, int32_t how, cn_body *bodies)
{
	cn_world *world = soft_world();
	int32_t k;
	for (k = 0; k < PAIRS; ++k) {
		float x = 4.0f * (float)k, spin = 0.3f * (float)k;
		cn_body a = k % 3 == 0 ? 0 : fixture_box(world, CN_BODY_DYNAMIC, x, 0.0f, 0.0f, 0.2f, 0.3f, 0.6f, 0.0f);
		bodies[k] = fixture_box(world, CN_BODY_DYNAMIC, x + 1.0f, 0.0f, 0.1f * (float)(k % 5), 0.3f, 0.2f, 0.6f, 0.0f);
		fixture_set_velocity(world, bodies[k], 0.5f * (float)(k % 4), 1.0f, spin);
		net_link(world, kind, how, k, a, at(a == 0 ? x : 0.0f, 0.0f), bodies[k], 1.0f, 0.0f);
	}
	return world;
}

/* 1: these have lanes. */
static int32_t has_lanes(int32_t kind)
{
	return kind != NET_SLIDE && kind != NET_WHEEL;
}

static void lanes_move_as_rows_do(void)
{
	int32_t kind, k, step;
	for (kind = NET_PIN; kind < NET_KINDS; ++kind) {
		cn_body in_lanes[PAIRS], by_rows[PAIRS];
		cn_world *lanes = pairs(kind, NET_IN_LANES, in_lanes), *rows = pairs(kind, NET_BY_ROWS, by_rows);
		double worst = 0.0;
		printf("  %s\n", net_name(kind));
		for (step = 0; step < 60; ++step) {
			fixture_step(lanes, 1);
			fixture_step(rows, 1);
			for (k = 0; k < PAIRS; ++k) {
				cn_vec2 p = fixture_pose(lanes, in_lanes[k]).position_m, q = fixture_pose(rows, by_rows[k]).position_m;
				worst = greater(worst, hypot((double)(p.x - q.x), (double)(p.y - q.y)));
			}
		}
		CHECK(joints_by_rows(lanes) == (has_lanes(kind) ? 0 : PAIRS) && joints_by_rows(rows) == PAIRS);
		CHECK_LE("largest distance in 1 s", worst, 1e-3, "m");
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
		CHECK(few == (has_lanes(kind) ? 0 : all) && all == 2 * SIDE * SIDE);
	}
}

/* ---- memory ---- */

/* After 20 steps; the world is destroyed. */
static uint64_t ties_hash(const cn_world_def *def)
{
	cn_world *world = NULL;
	uint64_t hash;
	must(cn_world_create(def, &world), NULL, "cn_world_create");
	net_fill(world, NET_TIE, NET_IN_LANES, SIDE, NULL);
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
	growing = ties_hash(&def);
	def.body_capacity = def.shape_capacity = SIDE * SIDE + 1;
	def.contact_capacity = 16;
	def.joint_capacity = 2 * SIDE * SIDE;
	must(cn_world_bytes_needed(&def, &def.memory_bytes), NULL, "cn_world_bytes_needed");
	raw = (unsigned char *)malloc((size_t)def.memory_bytes + 64);
	REQUIRE(raw != NULL);
	def.memory = raw + (64 - (uintptr_t)raw % 64) % 64;
	CHECK(ties_hash(&def) == growing);
	free(raw);
}

/* ---- every build ---- */

/* As in test/world/determinism_test.c, whose rules for replacing these hold here. */
static void nets_have_golden_bits(void)
{
	static const uint64_t golden[NET_KINDS] = {
		0x6fd69acb0721a147, 0xe0d7c7383001ea1f, 0x31147c7590309ba7, 0x8bd5c77bf66839ad, 0xee44727c946d6097, 0xbe7db6aecf658b46, 0x75606bfded73ba3a
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
	RUN(lanes_move_as_rows_do);
	RUN(nets_hold_as_well_in_lanes);
	RUN(fixed_memory_changes_nothing);
	RUN(nets_have_golden_bits);
	return test_end();
}
