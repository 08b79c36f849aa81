/*
 * test/world/drape_test.c - nets of rods that fall over a fixed disc onto a floor, or that moving ends drag over discs, gain no energy: loops of rods
 * that touch something, fold, turn fast and become straight, at 30 and 60 Hz.
 *
 * If one is thrown, look at gains_energy and cni_component_start in direct/component.c, and at is_overstretched in direct/component_fate.c.
 */
#include "joints.h"

#define COLUMNS_MOST 13
#define ROWS_MOST 4
#define SECONDS 4

typedef struct net {
	cn_world *world;
	cn_body nodes[ROWS_MOST][COLUMNS_MOST];
	cn_joint joints[2 * ROWS_MOST * COLUMNS_MOST];
	int32_t columns, rows, joint_count;
	float spacing, height, friction;
} net;

static void node_make(net *n, int32_t row, int32_t column, int32_t type)
{
	float x = n->spacing * ((float)column - 0.5f * (float)(n->columns - 1)), y = n->height - n->spacing * (float)row;
	cn_body node = fixture_body(n->world, type, x, y, 0.0f);
	cn_shape_def def = fixture_shape_def(node, n->friction, 0.0f);
	cn_circle circle = { { 0.0f, 0.0f }, 0.0f };
	circle.radius_m = 0.2f * n->spacing;
	def.filter.group = -1;
	must(cn_shape_create_circle(n->world, &def, &circle, NULL), n->world, "cn_shape_create_circle");
	n->nodes[row][column] = node;
}

static void rod_make(net *n, cn_body a, cn_body b)
{
	cn_distance_def def;
	cn_distance_def_init(&def);
	connect(&def.base, a, at(0.0f, 0.0f), b, at(0.0f, 0.0f));
	def.length_m = n->spacing;
	n->joints[n->joint_count++] = make_distance(n->world, &def);
}

static void net_make(net *n, int32_t solver, uint32_t *random)
{
	cn_world_def def;
	int32_t i, k;
	float radius;
	cn_world_def_init(&def);
	def.solver = solver;
	must(cn_world_create(&def, &n->world), NULL, "cn_world_create");
	n->friction = fixture_random(random, 0.0f, 1.0f);
	n->columns = 8 + (int32_t)fixture_random(random, 0.0f, 4.99f);
	n->rows = 2 + (int32_t)fixture_random(random, 0.0f, 2.99f);
	n->spacing = fixture_random(random, 0.25f, 1.0f);
	radius = fixture_random(random, 1.0f, 3.0f);
	n->height = 2.0f * radius + n->spacing * (float)n->rows + fixture_random(random, 0.0f, 2.0f);
	n->joint_count = 0;
	fixture_floor(n->world, n->friction, 0.0f);
	fixture_circle(n->world, CN_BODY_STATIC, fixture_random(random, -1.0f, 1.0f), radius, radius, n->friction, 0.0f);
	for (i = 0; i < n->rows; ++i)
		for (k = 0; k < n->columns; ++k) {
			node_make(n, i, k, CN_BODY_DYNAMIC);
			if (k > 0)
				rod_make(n, n->nodes[i][k - 1], n->nodes[i][k]);
			if (i > 0)
				rod_make(n, n->nodes[i - 1][k], n->nodes[i][k]);
		}
}

/* Greatest speed of a node, over that of a free fall from the net's height; gap: greatest gap of a rod so far. */
static double fall_speed(net *n, float dt, double *gap)
{
	double fastest_sq = 0.0;
	int32_t step, i, k;
	for (step = 0; (float)step * dt < (float)SECONDS; ++step) {
		must(cn_world_step(n->world, dt), n->world, "cn_world_step");
		for (i = 0; i < n->rows; ++i)
			for (k = 0; k < n->columns; ++k) {
				cn_velocity v;
				must(cn_body_get_velocity(n->world, n->nodes[i][k], &v), n->world, "cn_body_get_velocity");
				fastest_sq = greater(fastest_sq, (double)v.linear_mps.x * (double)v.linear_mps.x + (double)v.linear_mps.y * (double)v.linear_mps.y);
			}
		for (k = 0; k < n->joint_count; ++k) {
			float metres, radians;
			must(cn_joint_get_error(n->world, n->joints[k], &metres, &radians), n->world, "cn_joint_get_error");
			*gap = greater(*gap, (double)metres);
		}
	}
	return sqrt(fastest_sq / (2.0 * 10.0 * (double)n->height));
}

/* Number of nets that get faster than 1.8 times a free fall: a whip of their last rods reaches 1.6. */
static int32_t nets_thrown(int32_t solver, float dt, int32_t nets, double *gap)
{
	int32_t k, thrown = 0;
	for (k = 0; k < nets; ++k) {
		net n;
		uint32_t random = (uint32_t)k + 1u;
		net_make(&n, solver, &random);
		thrown += fall_speed(&n, dt, gap) > 1.8;
		cn_world_destroy(n.world);
	}
	return thrown;
}

static void draped_nets_are_not_thrown(void)
{
	int32_t coarse = TEST_FORM(240, 90, 20), fine = TEST_FORM(40, 16, 4);
	double gap = 0.0, fine_gap = 0.0;
	CHECK_LE("nets at 30 Hz that are thrown", nets_thrown(CN_SOLVER_AUTO, 1.0f / 30.0f, coarse, &gap), 0, "");
	CHECK_LE("widest gap of a rod (soft constraints 0.095)", gap, 0.12, "m");
	CHECK_LE("nets at 60 Hz that are thrown", nets_thrown(CN_SOLVER_AUTO, 1.0f / 60.0f, fine, &fine_gap), 0, "");
	CHECK_LE("widest gap of a rod (soft constraints 0.039)", fine_gap, 0.045, "m");
}

/* A net whose upper corners are moved over discs. */
static void dragged_net_make(net *n, int32_t substeps, uint32_t *random)
{
	cn_world_def def;
	int32_t i, k, discs;
	cn_world_def_init(&def);
	must(cn_world_create(&def, &n->world), NULL, "cn_world_create");
	must(cn_world_set_substep_count(n->world, substeps), n->world, "cn_world_set_substep_count");
	n->friction = 0.6f;
	n->columns = 5 + (int32_t)fixture_random(random, 0.0f, 4.99f);
	n->rows = 3 + (int32_t)fixture_random(random, 0.0f, 1.99f);
	n->spacing = fixture_random(random, 0.25f, 0.5f);
	n->height = 6.0f;
	n->joint_count = 0;
	discs = 2 + (int32_t)fixture_random(random, 0.0f, 4.99f);
	for (i = 0; i < discs; ++i)
		fixture_circle(n->world, CN_BODY_STATIC, fixture_random(random, 3.0f, 15.0f), fixture_random(random, 2.0f, 6.0f),
		               fixture_random(random, 0.2f, 0.6f), n->friction, 0.0f);
	for (i = 0; i < n->rows; ++i)
		for (k = 0; k < n->columns; ++k) {
			int32_t held = i == 0 && (k == 0 || k == n->columns - 1);
			node_make(n, i, k, held ? CN_BODY_KINEMATIC : CN_BODY_DYNAMIC);
			if (k > 0)
				rod_make(n, n->nodes[i][k - 1], n->nodes[i][k]);
			if (i > 0)
				rod_make(n, n->nodes[i - 1][k], n->nodes[i][k]);
		}
}

/* Greatest speed of a node within 5 s, and greatest gap of a rod so far. */
static double drag_speed(net *n, float dt, uint32_t *random, double *gap)
{
	float along = fixture_random(random, 1.0f, 5.0f), to_and_fro = fixture_random(random, 0.0f, 6.0f), up = fixture_random(random, 0.0f, 4.0f), rate = fixture_random(random, 0.5f, 4.0f);
	double fastest = 0.0;
	int32_t step, i, k;
	for (step = 0; (float)step * dt < 5.0f; ++step) {
		float t = (float)step * dt;
		for (k = 0; k < n->columns; k += n->columns - 1)
			must(cn_body_set_velocity(n->world, n->nodes[0][k], along + to_and_fro * cosf(rate * t), up * sinf(1.3f * rate * t), 0.0f), n->world, "cn_body_set_velocity");
		must(cn_world_step(n->world, dt), n->world, "cn_world_step");
		for (i = 0; i < n->rows; ++i)
			for (k = 0; k < n->columns; ++k) {
				cn_velocity v;
				must(cn_body_get_velocity(n->world, n->nodes[i][k], &v), n->world, "cn_body_get_velocity");
				fastest = greater(fastest, hypot((double)v.linear_mps.x, (double)v.linear_mps.y));
			}
		for (k = 0; k < n->joint_count; ++k) {
			float metres, radians;
			must(cn_joint_get_error(n->world, n->joints[k], &metres, &radians), n->world, "cn_joint_get_error");
			*gap = greater(*gap, (double)metres);
		}
	}
	return fastest;
}

/* Greatest speed of all nodes, and greatest gap. */
static double nets_drag(int32_t first, int32_t nets, float dt, int32_t substeps, double *gap)
{
	double fastest = 0.0;
	for (int32_t k = 0; k < nets; ++k) {
		net n;
		uint32_t random = (uint32_t)(first + k) + 1u;
		dragged_net_make(&n, substeps, &random);
		fastest = greater(fastest, drag_speed(&n, dt, &random, gap));
		cn_world_destroy(n.world);
	}
	return fastest;
}

static void dragged_nets_are_not_thrown(void)
{
	double gap = 0.0, coarse_gap = 0.0;
	CHECK_LE("greatest speed of a node (soft constraints 22.8)", nets_drag(0, TEST_MANY(60), 1.0f / 60.0f, 4, &gap), 30.0, "m/s");
	CHECK_LE("widest gap of a rod (soft constraints 0.33)", gap, 0.4, "m");
	CHECK_LE("... with 2 substeps at 30 Hz", nets_drag(136, TEST_MANY(40), 1.0f / 30.0f, 2, &coarse_gap), 34.2, "m/s");
	CHECK_LE("widest gap of a rod then", coarse_gap, 0.8, "m");
}

int main(void)
{
	RUN(draped_nets_are_not_thrown);
	RUN(dragged_nets_are_not_thrown);
	return test_end();
}
