/*
 * test/stages/sparse_test.c - the direct solver of coupled constraints (stages/sparse.h) against a dense one.
 *
 * Systems are drawn at random: trees, bridges, stars, grids with loops, several joints between the same two bodies, one
 * to three rows, masses of very different sizes. The dense matrix is made from levers and masses in double
 * precision, without looking at the plan's blocks. If a plan is wrong, look in stages/sparse_plan.c; if only the numbers
 * are, in stages/sparse_solve.c.
 */
#include "stages/sparse.h"
#include "test.h"

#include <math.h>
#include <stdlib.h>

#define LINKS_MOST 200
#define BODIES_MOST 210
#define ROWS_MOST (LINKS_MOST * CNI_NODE_ROWS)

/* A system as a caller knows it; bodies[0] is the world. */
typedef struct problem {
	cni_link links[LINKS_MOST];
	cni_motion bodies[BODIES_MOST];
	cni_lever lever[LINKS_MOST][CNI_NODE_ROWS];
	float compliance[LINKS_MOST][CNI_NODE_ROWS];
	float side[LINKS_MOST][CNI_NODE_ROWS]; /* right hand side */
	uint8_t planned[LINKS_MOST];
	int32_t link_count, body_count;
	uint32_t random;
	double decades; /* masses from 1 to 10^decades */
	cni_memory memory;
	cni_arena arena;
	cni_array *kept; /* NULL: every plan is made anew */
	cni_sparse sparse;
} problem;

static problem shared; /* too large for a stack */

/* xorshift32 (Marsaglia, 2003) */
static float pick(problem *p, float lower, float upper)
{
	p->random ^= p->random << 13;
	p->random ^= p->random >> 17;
	p->random ^= p->random << 5;
	return lower + (upper - lower) * (float)(p->random >> 8) / 16777216.0f;
}

static int32_t pick_int(problem *p, int32_t count)
{
	return cni_min_i((int32_t)pick(p, 0.0f, (float)count), count - 1);
}

static problem *begin(uint32_t seed, double decades)
{
	problem *p = &shared;
	memset(p, 0, sizeof *p);
	p->random = seed * 2654435761u + 1u;
	p->decades = decades;
	p->body_count = 1;
	cni_memory_init_hooks(&p->memory, NULL, NULL, NULL);
	cni_arena_init(&p->arena, &p->memory);
	return p;
}

static void end(problem *p)
{
	cni_arena_deinit(&p->arena);
	CHECK(p->memory.bytes_in_use == 0);
}

/* ---- making systems ---- */

static int32_t add_fixed(problem *p)
{
	return p->body_count++;
}

static int32_t add_body(problem *p)
{
	cni_motion *m = &p->bodies[p->body_count];
	float mass = (float)pow(10.0, p->decades * (double)pick(p, 0.0f, 1.0f));
	m->inv_mass = 1.0f / mass;
	m->inv_inertia = 1.0f / (mass * pick(p, 0.05f, 0.5f));
	return p->body_count++;
}

/* The rows of a rod (1), a hinge (2) or a weld (3), in a frame of its own, with levers of its own. */
static int32_t add_link(problem *p, int32_t a, int32_t b, int32_t rows)
{
	int32_t k = p->link_count++, i;
	float turn = pick(p, 0.0f, 6.28f), ra_x = pick(p, -1.0f, 1.0f), ra_y = pick(p, -1.0f, 1.0f);
	float rb_x = pick(p, -1.0f, 1.0f), rb_y = pick(p, -1.0f, 1.0f);
	p->links[k].ia = a;
	p->links[k].ib = b;
	p->links[k].owner = 1000 + k;
	p->links[k].rows = rows;
	p->links[k].work_most = 1000;
	for (i = 0; i < rows; ++i) {
		float x = (float)cos((double)turn + 1.5707963 * (double)i), y = (float)sin((double)turn + 1.5707963 * (double)i);
		cni_lever linear = { -x, -y, -(ra_x * y - ra_y * x), x, y, rb_x * y - rb_y * x };
		cni_lever angular = { 0.0f, 0.0f, -1.0f, 0.0f, 0.0f, 1.0f };
		p->lever[k][i] = i < 2 ? linear : angular;
		p->side[k][i] = pick(p, -1.0f, 1.0f);
	}
	return k;
}

/* Compliance as a part of the row's own diagonal, 1 where that is zero. */
static void soften(problem *p, int32_t k, float part)
{
	const cni_motion *a = &p->bodies[p->links[k].ia], *b = &p->bodies[p->links[k].ib];
	int32_t i;
	for (i = 0; i < p->links[k].rows; ++i) {
		const cni_lever *l = &p->lever[k][i];
		float whole = a->inv_mass * (l->ax * l->ax + l->ay * l->ay) + a->inv_inertia * l->aw * l->aw +
		              b->inv_mass * (l->bx * l->bx + l->by * l->by) + b->inv_inertia * l->bw * l->bw;
		p->compliance[k][i] = whole > 0.0f ? part * whole : 1.0f;
	}
}

/* Bodies in a row, each linked to the one before; the first to `from`. rows 0: one to three, at random. */
static void add_chain(problem *p, int32_t from, int32_t count, int32_t rows)
{
	int32_t k;
	for (k = 0; k < count; ++k) {
		int32_t body = add_body(p);
		add_link(p, from, body, rows ? rows : 1 + pick_int(p, 3));
		from = body;
	}
}

static void add_tree(problem *p, int32_t count, int32_t rows)
{
	int32_t first = add_body(p), k;
	for (k = 1; k < count; ++k) {
		int32_t to = first + pick_int(p, k), body = add_body(p);
		if (pick_int(p, 2))
			add_link(p, to, body, rows ? rows : 1 + pick_int(p, 3));
		else
			add_link(p, body, to, rows ? rows : 1 + pick_int(p, 3));
	}
}

static void add_bridge(problem *p, int32_t count, int32_t rows)
{
	int32_t last;
	add_chain(p, 0, count, rows);
	last = p->body_count - 1;
	add_link(p, last, add_fixed(p), rows);
}

static int32_t add_star(problem *p, int32_t arms, int32_t rows)
{
	int32_t hub = add_body(p), k;
	for (k = 0; k < arms; ++k)
		add_link(p, hub, add_body(p), rows ? rows : 1 + pick_int(p, 3));
	return hub;
}

static void add_grid(problem *p, int32_t side, int32_t rows)
{
	int32_t first = p->body_count, x, y;
	for (y = 0; y < side * side; ++y)
		add_body(p);
	for (y = 0; y < side; ++y)
		for (x = 0; x < side; ++x) {
			int32_t body = first + y * side + x;
			if (x + 1 < side)
				add_link(p, body, body + 1, rows);
			if (y + 1 < side)
				add_link(p, body, body + side, rows);
		}
}

/* ---- solving them ---- */

static int64_t work_allowed(const problem *p)
{
	int64_t sum = 0;
	int32_t k;
	for (k = 0; k < p->link_count; ++k)
		sum += p->links[k].work_most;
	return sum;
}

static uint64_t bytes_promised(const problem *p)
{
	int64_t work = work_allowed(p);
	return cni_sparse_bytes(p->link_count, p->body_count, work) + cni_sparse_kept_bytes(p->link_count, work);
}

static int32_t plan_within(problem *p, int64_t budget)
{
	cni_system system = { p->links, p->link_count, p->body_count, p->bodies, budget, 0, 0 };
	return cni_sparse_plan(&p->arena, p->kept, &system, &p->sparse, p->planned);
}

static int32_t plan(problem *p)
{
	return plan_within(p, INT64_MAX);
}

static void fill_nodes(problem *p)
{
	int32_t k, i;
	for (k = 0; k < p->sparse.node_count; ++k) {
		cni_node *n = &p->sparse.nodes[k];
		for (i = 0; i < n->rows; ++i) {
			n->lever[i] = p->lever[n->owner - 1000][i];
			n->compliance[i] = p->compliance[n->owner - 1000][i];
			n->x[i] = p->side[n->owner - 1000][i];
		}
	}
}

static void solve(problem *p, float regular)
{
	int32_t k;
	fill_nodes(p);
	for (k = 0; k < p->sparse.component_count; ++k) {
		p->sparse.components[k].regular = regular;
		cni_sparse_factor(&p->sparse, &p->sparse.components[k], p->bodies);
		cni_sparse_solve(&p->sparse, &p->sparse.components[k]);
	}
}

/* ---- the same, dense and in double ---- */

typedef struct dense {
	int32_t size;
	double matrix[ROWS_MOST][ROWS_MOST], factor[ROWS_MOST][ROWS_MOST];
	double side[ROWS_MOST], exact[ROWS_MOST], found[ROWS_MOST];
} dense;

static dense full;

/* What an impulse of 1 along one lever does to the speed along another, through one body. */
static double through(const cni_motion *m, const cni_lever *p, int32_t p_side, const cni_lever *q, int32_t q_side)
{
	double px = (double)(p_side ? p->bx : p->ax), py = (double)(p_side ? p->by : p->ay), pw = (double)(p_side ? p->bw : p->aw);
	double qx = (double)(q_side ? q->bx : q->ax), qy = (double)(q_side ? q->by : q->ay), qw = (double)(q_side ? q->bw : q->aw);
	return (double)m->inv_mass * (px * qx + py * qy) + (double)m->inv_inertia * pw * qw;
}

static double coupling(const problem *p, int32_t k, int32_t i, int32_t l, int32_t j)
{
	double sum = 0.0;
	int32_t s, t;
	for (s = 0; s < 2; ++s)
		for (t = 0; t < 2; ++t) {
			int32_t body = s ? p->links[k].ib : p->links[k].ia;
			if (body == (t ? p->links[l].ib : p->links[l].ia))
				sum += through(&p->bodies[body], &p->lever[k][i], s, &p->lever[l][j], t);
		}
	return sum;
}

static void dense_form(const problem *p)
{
	static int32_t row_at[LINKS_MOST];
	int32_t k, l, i, j, m;
	full.size = 0;
	for (k = 0; k < p->link_count; ++k) {
		row_at[k] = full.size;
		full.size += p->links[k].rows;
	}
	for (k = 0; k < p->link_count; ++k)
		for (i = 0; i < p->links[k].rows; ++i) {
			full.side[row_at[k] + i] = (double)p->side[k][i];
			for (l = 0; l < p->link_count; ++l)
				for (j = 0; j < p->links[l].rows; ++j)
					full.matrix[row_at[k] + i][row_at[l] + j] = coupling(p, k, i, l, j) + (k == l && i == j ? (double)p->compliance[k][i] : 0.0);
		}
	for (m = 0; m < p->sparse.node_count; ++m)
		for (i = 0; i < p->sparse.nodes[m].rows; ++i)
			full.found[row_at[p->sparse.nodes[m].owner - 1000] + i] = (double)p->sparse.nodes[m].x[i];
}

/* Cholesky. */
static void dense_solve(void)
{
	double (*f)[ROWS_MOST] = full.factor;
	int32_t i, j, k, n = full.size;
	for (i = 0; i < n; ++i)
		for (j = 0; j <= i; ++j) {
			double sum = full.matrix[i][j];
			for (k = 0; k < j; ++k)
				sum -= f[i][k] * f[j][k];
			f[i][j] = i == j ? sqrt(sum) : sum / f[j][j];
		}
	for (i = 0; i < n; ++i) {
		full.exact[i] = full.side[i];
		for (k = 0; k < i; ++k)
			full.exact[i] -= f[i][k] * full.exact[k];
		full.exact[i] /= f[i][i];
	}
	for (i = n - 1; i >= 0; --i) {
		for (k = i + 1; k < n; ++k)
			full.exact[i] -= f[k][i] * full.exact[k];
		full.exact[i] /= f[i][i];
	}
}

/* |b - A x| over |A| |x| + |b|, the largest of the rows: small whatever the condition of A. */
static double backward_error(void)
{
	double worst = 0.0;
	int32_t i, j;
	for (i = 0; i < full.size; ++i) {
		double left = full.side[i], scale = fabs(full.side[i]);
		for (j = 0; j < full.size; ++j) {
			left -= full.matrix[i][j] * full.found[j];
			scale += fabs(full.matrix[i][j] * full.found[j]);
		}
		if (!(fabs(left) <= worst * scale))
			worst = fabs(left) / scale;
	}
	return worst;
}

/* |x - exact| / |exact| */
static double forward_error(void)
{
	double off = 0.0, size = 0.0;
	int32_t i;
	for (i = 0; i < full.size; ++i) {
		off += (full.found[i] - full.exact[i]) * (full.found[i] - full.exact[i]);
		size += full.exact[i] * full.exact[i];
	}
	return sqrt(off / size);
}

/* |b - A x| / |b| */
static double residual(void)
{
	double off = 0.0, size = 0.0;
	int32_t i, j;
	for (i = 0; i < full.size; ++i) {
		double left = full.side[i];
		for (j = 0; j < full.size; ++j)
			left -= full.matrix[i][j] * full.found[j];
		off += left * left;
		size += full.side[i] * full.side[i];
	}
	return sqrt(off / size);
}

typedef struct errors {
	double backward, forward, residual;
} errors;

static void judge(problem *p, errors *worst)
{
	REQUIRE(plan(p));
	CHECK(p->sparse.node_count == p->link_count);
	CHECK(p->arena.high_water <= bytes_promised(p));
	solve(p, 0.0f);
	dense_form(p);
	dense_solve();
	CHECK(isfinite(forward_error()));
	worst->backward = fmax(worst->backward, backward_error());
	worst->forward = fmax(worst->forward, forward_error());
	worst->residual = fmax(worst->residual, residual());
}

/* ---- solutions ---- */

static void make_tree(problem *p) { add_tree(p, 60, 0); }
static void make_rooted_tree(problem *p) { add_tree(p, 60, 0); add_link(p, 0, 1, 2); }
static void make_chain(problem *p) { add_chain(p, 0, 100, 2); }
static void make_bridge(problem *p) { add_bridge(p, 40, 2); }
static void make_star(problem *p) { add_star(p, 30, 0); }
static void make_grid(problem *p) { add_grid(p, 7, 1); }

static void make_soft_grid(problem *p)
{
	int32_t k;
	add_grid(p, 6, 3);
	for (k = 0; k < p->link_count; ++k)
		soften(p, k, 0.01f);
}

/* Two or three rods between the same two bodies, in either order. */
static void make_parallel(problem *p)
{
	int32_t from = add_body(p), k;
	for (k = 0; k < 20; ++k) {
		int32_t body = add_body(p);
		add_link(p, from, body, 1);
		add_link(p, body, from, 1);
		if (pick_int(p, 2))
			add_link(p, from, body, 1);
		from = body;
	}
}

/* Static bodies join nothing; bodies that can only turn, or only move, do. */
static void make_hindered(problem *p)
{
	int32_t k, count;
	add_tree(p, 40, 1);
	count = p->body_count;
	for (k = 1; k < count; ++k) {
		if (k % 3 == 0)
			p->bodies[k].inv_inertia = 0.0f;
		if (k % 7 == 1)
			p->bodies[k].inv_mass = 0.0f;
		if (k % 5 == 0)
			add_link(p, k, add_fixed(p), 1);
	}
	for (k = 0; k < p->link_count; ++k)
		soften(p, k, 0.01f); /* a row may act on nothing else */
}

static void compare(const char *name, void (*make)(problem *), double decades, double backward_bound, double forward_bound)
{
	errors worst = { 0.0, 0.0, 0.0 };
	uint32_t seed;
	for (seed = 1; seed <= 8; ++seed) {
		problem *p = begin(seed, decades);
		make(p);
		judge(p, &worst);
		end(p);
	}
	printf("  %s, masses 1:%g: backward %.1e, solution off by %.1e, residual %.1e\n", name, pow(10.0, decades), worst.backward, worst.forward,
	       worst.residual);
	CHECK_LE("residual / (|A| |x| + |b|)", worst.backward, backward_bound, "");
	CHECK_LE("error of the solution", worst.forward, forward_bound, "");
}

static void t_equal_masses_match_a_dense_solution(void)
{
	compare("tree", make_tree, 0.0, 2e-6, 5e-4);
	compare("tree on the world", make_rooted_tree, 0.0, 2e-6, 5e-4);
	compare("chain of 100", make_chain, 0.0, 2e-6, 5e-4);
	compare("bridge", make_bridge, 0.0, 2e-6, 5e-4);
	compare("star", make_star, 0.0, 2e-6, 5e-4);
	compare("grid of rods", make_grid, 0.0, 2e-6, 5e-4);
	compare("soft grid of welds", make_soft_grid, 0.0, 2e-6, 5e-4);
	compare("parallel rods", make_parallel, 0.0, 2e-6, 5e-4);
	compare("turning or moving only", make_hindered, 0.0, 2e-6, 5e-4);
}

static void t_unequal_masses_match_a_dense_solution(void)
{
	compare("tree", make_tree, 4.0, 5e-5, 1e-2);
	compare("tree on the world", make_rooted_tree, 4.0, 5e-5, 1e-2);
	compare("chain of 100", make_chain, 4.0, 5e-5, 1e-2);
	compare("bridge", make_bridge, 4.0, 5e-5, 1e-2);
	compare("star", make_star, 4.0, 5e-5, 1e-2);
	compare("soft grid of welds", make_soft_grid, 4.0, 5e-5, 1e-2);
	compare("turning or moving only", make_hindered, 4.0, 5e-5, 1e-2);
}

/* Diagonals grow by a part of themselves. */
static void t_regular_is_a_part_of_the_diagonal(void)
{
	problem *p = begin(5, 1.0);
	int32_t i;
	add_bridge(p, 30, 2);
	REQUIRE(plan(p));
	solve(p, 0.1f);
	dense_form(p);
	for (i = 0; i < full.size; ++i)
		full.matrix[i][i] += 0.1 * full.matrix[i][i];
	dense_solve();
	CHECK_LE("error of the solution", forward_error(), 1e-5, "");
	end(p);
}

/* ---- constraints that say the same ---- */

/* Speeds after the impulses, against what each row asked for. */
static double unsatisfied(const problem *p)
{
	dense_form(p);
	return residual();
}

/* Every link of a chain twice. */
static void t_repeated_constraints_are_satisfied(void)
{
	static const float regular[] = { 0.0f, 1e-5f };
	int32_t r;
	for (r = 0; r < 2; ++r) {
		double worst = 0.0;
		uint32_t seed;
		for (seed = 1; seed <= 20; ++seed) {
			problem *p = begin(seed, 2.0);
			int32_t k, count = 12;
			add_chain(p, 0, count, 2);
			for (k = 0; k < count; ++k) {
				int32_t copy = add_link(p, p->links[k].ia, p->links[k].ib, 2);
				memcpy(p->lever[copy], p->lever[k], sizeof p->lever[k]);
				memcpy(p->side[copy], p->side[k], sizeof p->side[k]);
			}
			REQUIRE(plan(p));
			solve(p, regular[r]);
			worst = fmax(worst, unsatisfied(p));
			if (!isfinite(unsatisfied(p)))
				worst = 1e30;
			end(p);
		}
		printf("  diagonal grown by %g\n", (double)regular[r]);
		CHECK_LE("|b - A x| / |b| of doubled constraints", worst, 0.02, "");
	}
}

/* A row between bodies that cannot move, or without levers, is left alone. */
static void t_rows_that_act_on_nothing_get_nothing(void)
{
	problem *p = begin(3, 0.0);
	int32_t nothing, empty, k, body;
	add_chain(p, 0, 4, 2);
	body = p->body_count - 1;
	nothing = add_link(p, add_fixed(p), add_fixed(p), 2);
	empty = add_link(p, body, 0, 1);
	memset(&p->lever[empty][0], 0, sizeof p->lever[empty][0]);
	REQUIRE(plan(p));
	solve(p, 0.0f);
	for (k = 0; k < p->sparse.node_count; ++k) {
		const cni_node *n = &p->sparse.nodes[k];
		if (n->owner == 1000 + nothing || n->owner == 1000 + empty)
			CHECK(n->x[0] == 0.0f && n->x[1] == 0.0f && n->x[2] == 0.0f);
		else
			CHECK(isfinite(n->x[0]) && n->x[0] != 0.0f);
		CHECK(n->rows == 3 || n->x[2] == 0.0f);
	}
	end(p);
}

/* ---- plans ---- */

static int32_t are_neighbours(const problem *p, int32_t k, int32_t l)
{
	int32_t s, t;
	for (s = 0; s < 2; ++s)
		for (t = 0; t < 2; ++t) {
			int32_t body = s ? p->links[k].ib : p->links[k].ia;
			if (body == (t ? p->links[l].ib : p->links[l].ia) && (p->bodies[body].inv_mass > 0.0f || p->bodies[body].inv_inertia > 0.0f))
				return 1;
		}
	return 0;
}

static int32_t pairs_of(const problem *p)
{
	int32_t k, l, pairs = 0;
	for (k = 0; k < p->link_count; ++k)
		for (l = 0; l < k; ++l)
			pairs += are_neighbours(p, k, l);
	return pairs;
}

static int32_t fill_of(const char *name, problem *p)
{
	int32_t pairs = pairs_of(p), fill;
	if (!plan(p)) {
		test_fail(__FILE__, __LINE__, "no plan");
		return -1;
	}
	fill = p->sparse.block_count - pairs;
	if (name != NULL)
		printf("  %s: %d neighbouring pairs, %d blocks\n", name, (int)pairs, (int)p->sparse.block_count);
	end(p);
	return fill;
}

static void t_simple_trees_make_no_fill(void)
{
	problem *p = begin(1, 0.0);
	int32_t k, hub;
	add_chain(p, 0, 150, 2);
	CHECK(fill_of("chain", p) == 0);
	p = begin(1, 0.0);
	add_bridge(p, 150, 2);
	CHECK(fill_of("bridge", p) == 0);
	p = begin(1, 0.0);
	add_star(p, 40, 2);
	CHECK(fill_of("star", p) == 0);
	p = begin(1, 0.0);
	hub = add_star(p, 5, 2);
	for (k = 1; k <= 5; ++k)
		add_chain(p, hub + k, 4, 2);
	CHECK(fill_of("hub with arms of five", p) == 0);
}

/* The order of least degree may begin between two hubs: some blocks then come in. */
static void t_random_trees_make_little(void)
{
	int32_t pairs = 0, fill = 0, filled = 0;
	uint32_t seed;
	for (seed = 1; seed <= 200; ++seed) {
		problem *p = begin(seed, 0.0);
		int32_t more;
		add_tree(p, 20 + (int32_t)(seed % 100), 2);
		pairs += pairs_of(p);
		more = fill_of(NULL, p);
		CHECK(more >= 0);
		fill += more;
		filled += more > 0;
	}
	printf("  200 random trees: %d pairs, %d blocks more, in %d trees\n", (int)pairs, (int)fill, (int)filled);
	CHECK_LE("blocks that are fill / pairs", (double)fill / (double)pairs, 0.05, "");
}

/* Positions belong to one component each, blocks lead upwards, every body is listed once. */
static void t_plans_are_well_formed(void)
{
	problem *p = begin(9, 0.0);
	static int32_t seen[BODIES_MOST];
	int32_t c, k, e, movable = 0;
	add_chain(p, 0, 10, 2);
	add_grid(p, 4, 1);
	add_tree(p, 15, 0);
	add_chain(p, 0, 5, 3);
	for (k = 1; k < p->body_count; ++k)
		movable += p->bodies[k].inv_mass > 0.0f;
	REQUIRE(plan(p));
	CHECK(p->sparse.component_count == 4);
	CHECK(p->sparse.body_count == movable);
	memset(seen, 0, sizeof seen);
	for (k = 0; k < p->sparse.body_count; ++k)
		CHECK(++seen[p->sparse.bodies[k]] == 1);
	for (c = 0; c < p->sparse.component_count; ++c) {
		const cni_component *at = &p->sparse.components[c];
		CHECK(at->begin == (c == 0 ? 0 : p->sparse.components[c - 1].end));
		CHECK(at->loops == (c == 1));
		for (k = at->begin; k < at->end; ++k)
			for (e = p->sparse.first[k]; e < p->sparse.first[k + 1]; ++e)
				CHECK(p->sparse.below[e] > k && p->sparse.below[e] < at->end && (e == p->sparse.first[k] || p->sparse.below[e] > p->sparse.below[e - 1]));
	}
	CHECK(p->sparse.components[p->sparse.component_count - 1].end == p->link_count);
	CHECK(p->sparse.components[0].width == 2 && p->sparse.components[3].width == 3);
	end(p);
}

static int32_t planned_in(const problem *p, int32_t begin_at, int32_t end_at)
{
	int32_t k, count = 0;
	for (k = begin_at; k < end_at; ++k)
		count += p->planned[k];
	return count;
}

/* A grid whose own limit is too low, between two chains that are within theirs. */
static void t_beyond_the_limit_is_refused_alone(void)
{
	problem *p = begin(2, 0.0);
	int32_t from, to, k;
	add_chain(p, 0, 10, 2);
	from = p->link_count;
	add_grid(p, 7, 1);
	to = p->link_count;
	add_chain(p, 0, 10, 2);
	for (k = 0; k < p->link_count; ++k)
		p->links[k].work_most = 6;
	REQUIRE(plan(p));
	CHECK(p->sparse.node_count == 20 && p->sparse.component_count == 2);
	CHECK(planned_in(p, 0, from) == 10 && planned_in(p, from, to) == 0 && planned_in(p, to, p->link_count) == 10);
	solve(p, 0.0f);
	for (k = 0; k < p->sparse.node_count; ++k)
		CHECK(isfinite(p->sparse.nodes[k].x[0]) && (p->sparse.nodes[k].owner < 1000 + from || p->sparse.nodes[k].owner >= 1000 + to));
	end(p);
	/* One link that may cost more speaks for its component. */
	p = begin(2, 0.0);
	add_grid(p, 7, 1);
	for (k = 0; k < p->link_count; ++k)
		p->links[k].work_most = 6;
	p->links[17].work_most = 1000;
	REQUIRE(plan(p));
	CHECK(p->sparse.node_count == p->link_count);
	end(p);
}

static void t_beyond_the_budget_is_refused(void)
{
	problem *p = begin(2, 0.0);
	int32_t work_chain, work_star;
	add_chain(p, 0, 10, 2);
	add_star(p, 12, 2);
	add_chain(p, 0, 10, 2);
	REQUIRE(plan(p));
	CHECK(p->sparse.component_count == 3);
	work_chain = p->sparse.components[0].work;
	work_star = p->sparse.components[1].work;
	CHECK(p->sparse.components[2].work == work_chain && work_star > work_chain);
	cni_sparse_discard(&p->arena, &p->sparse);
	CHECK(p->arena.entry_count == 0 && p->sparse.node_count == 0 && p->sparse.component_count == 0);
	REQUIRE(plan_within(p, 2 * work_chain));
	CHECK(planned_in(p, 0, 10) == 10 && planned_in(p, 10, 22) == 0 && planned_in(p, 22, 32) == 10);
	cni_sparse_discard(&p->arena, &p->sparse);
	REQUIRE(plan_within(p, 2 * work_chain + work_star));
	CHECK(planned_in(p, 0, 32) == 32);
	cni_sparse_discard(&p->arena, &p->sparse);
	REQUIRE(plan_within(p, 2 * work_chain + work_star - 1));
	CHECK(planned_in(p, 0, 22) == 22 && planned_in(p, 22, 32) == 0);
	cni_sparse_discard(&p->arena, &p->sparse);
	REQUIRE(plan_within(p, 0));
	CHECK(planned_in(p, 0, 32) == 0 && p->sparse.node_count == 0);
	end(p);
}

/* A body with too many joints: its neighbours would all be one another's. */
static void t_hubs_are_refused(void)
{
	problem *p = begin(4, 0.0);
	add_star(p, 64, 2);
	REQUIRE(plan(p));
	CHECK(p->sparse.node_count == 64);
	end(p);
	p = begin(4, 0.0);
	add_star(p, 65, 2);
	add_chain(p, 0, 3, 2);
	REQUIRE(plan(p));
	CHECK(p->sparse.node_count == 3 && planned_in(p, 0, 65) == 0);
	end(p);
}

/* ---- kept plans ---- */

/* A plan by what is kept, and one that is made anew, over several components with and without loops. */
static int32_t kept_differs(problem *p)
{
	static problem anew;
	const cni_sparse *a = &p->sparse, *b = &anew.sparse;
	int32_t k, e, differs;
	anew = *p;
	cni_memory_init_hooks(&anew.memory, NULL, NULL, NULL);
	cni_arena_init(&anew.arena, &anew.memory);
	anew.kept = NULL;
	memset(&p->sparse, 0, sizeof p->sparse);
	memset(&anew.sparse, 0, sizeof anew.sparse);
	if (!plan(p) || !plan(&anew))
		return 1;
	differs = a->node_count != b->node_count || a->block_count != b->block_count || a->component_count != b->component_count ||
	          a->coupling_count != b->coupling_count || a->body_count != b->body_count || memcmp(p->planned, anew.planned, sizeof p->planned) != 0;
	for (k = 0; k < a->node_count && !differs; ++k) {
		differs |= memcmp(&a->nodes[k], &b->nodes[k], sizeof a->nodes[k]) != 0 || a->first[k + 1] != b->first[k + 1];
		for (e = a->first[k]; e < a->first[k + 1]; ++e)
			differs |= a->below[e] != b->below[e];
	}
	for (k = 0; k < a->component_count && !differs; ++k)
		differs |= memcmp(&a->components[k], &b->components[k], sizeof a->components[k]) != 0;
	for (k = 0; k < a->coupling_count && !differs; ++k)
		differs |= memcmp(&a->couplings[k], &b->couplings[k], sizeof a->couplings[k]) != 0;
	for (k = 0; k < a->body_count && !differs; ++k)
		differs |= a->bodies[k] != b->bodies[k];
	cni_arena_deinit(&anew.arena);
	cni_arena_reset(&p->arena);
	return differs;
}

static void t_a_kept_plan_is_used_again(void)
{
	problem *p = begin(5, 0.0);
	cni_array kept;
	const int32_t *first;
	cni_array_init(&kept, CNI_KEPT_BYTES);
	p->kept = &kept;
	add_grid(p, 5, 1);
	add_tree(p, 40, 0);
	add_bridge(p, 20, 2);
	CHECK(!kept_differs(p));
	first = p->sparse.first;
	memset(&p->sparse, 0, sizeof p->sparse);
	REQUIRE(plan(p));
	p->sparse.components[0].work = 0; /* the step's own */
	cni_arena_reset(&p->arena);
	CHECK(!kept_differs(p) && p->sparse.first == first);
	/* Whatever a plan depends on. */
	p->bodies[p->links[30].ia].inv_mass = p->bodies[p->links[30].ia].inv_inertia = 0.0f;
	CHECK(!kept_differs(p));
	p->links[12].ib = p->links[70].ib;
	CHECK(!kept_differs(p));
	p->links[50].owner = 7;
	CHECK(!kept_differs(p));
	p->links[50].rows = 3;
	CHECK(!kept_differs(p));
	for (p->link_count = 80; p->link_count > 0; p->link_count -= 7)
		CHECK(!kept_differs(p) && !kept_differs(p));
	p->link_count = 60;
	memset(&p->sparse, 0, sizeof p->sparse);
	REQUIRE(plan_within(p, 100));
	CHECK(planned_in(p, 0, 60) < 60);
	cni_arena_reset(&p->arena);
	CHECK(!kept_differs(p));
	cni_array_deinit(&kept, &p->memory);
	end(p);
}

/* ---- memory ---- */

static void *aligned_block(void)
{
	static uint8_t room[4 * 1024 * 1024];
	return room + (64 - (uintptr_t)room % 64) % 64;
}

/* Every size of a block that nothing can be added to, from too small to enough. */
static void t_too_little_memory_is_survived(void)
{
	static problem at;
	uint64_t bytes, needed;
	int32_t refused = 0, done = 0;
	problem *p = begin(6, 0.0);
	add_grid(p, 6, 2);
	needed = bytes_promised(p);
	memcpy(&at, p, sizeof at);
	end(p);
	REQUIRE(needed + 8192 < 4 * 1024 * 1024);
	for (bytes = 64; bytes < needed + 4096; bytes += done > 0 ? needed / 40 / 64 * 64 : 256) {
		int32_t good;
		cni_memory_init_block(&at.memory, aligned_block(), bytes);
		cni_arena_init(&at.arena, &at.memory);
		memset(&at.sparse, 0, sizeof at.sparse);
		memset(at.planned, 7, sizeof at.planned);
		good = plan(&at);
		CHECK(good || (at.arena.entry_count == 0 && at.arena.in_use == 0 && at.memory.bytes_in_use == 0));
		CHECK(good || (planned_in(&at, 0, at.link_count) == 0 && at.sparse.component_count == 0));
		CHECK(!good || (at.sparse.node_count == at.link_count && planned_in(&at, 0, at.link_count) == at.link_count));
		CHECK(good || done == 0);
		refused += !good;
		done += good;
		cni_arena_deinit(&at.arena);
	}
	printf("  %d sizes too small, %d large enough\n", (int)refused, (int)done);
	CHECK(refused > 100 && done > 0);
}

/* In an arena of just as many bytes as promised nothing falls back. */
static void t_scratch_is_what_was_promised(void)
{
	static void (*const make[])(problem *) = { make_tree, make_chain, make_bridge, make_star, make_grid, make_soft_grid, make_parallel, make_hindered };
	double most = 0.0;
	size_t m;
	int32_t each;
	for (m = 0; m < sizeof make / sizeof *make; ++m)
		for (each = 3; each <= 3000; each *= 10) {
			problem *p = begin(7, 0.0);
			uint64_t bytes;
			int32_t k;
			make[m](p);
			for (k = 0; k < p->link_count; ++k)
				p->links[k].work_most = each;
			bytes = bytes_promised(p);
			REQUIRE(cni_arena_reserve(&p->arena, bytes));
			REQUIRE(plan(p));
			CHECK(p->arena.fallbacks == 0);
			most = fmax(most, (double)p->arena.high_water / (double)bytes);
			end(p);
		}
	CHECK_LE("scratch used / cni_sparse_bytes", most, 1.0, "");
}

/* ---- determinism ---- */

static void t_the_same_twice(void)
{
	static float first[ROWS_MOST];
	static int32_t owners[LINKS_MOST];
	problem *p;
	int32_t k, round;
	for (round = 0; round < 2; ++round) {
		int32_t differs = 0;
		p = begin(8, 4.0);
		add_grid(p, 5, 1);
		add_tree(p, 40, 0);
		add_bridge(p, 20, 2);
		REQUIRE(plan(p));
		REQUIRE(p->sparse.node_count == p->link_count);
		solve(p, 1e-5f);
		for (k = 0; k < p->sparse.node_count; ++k) {
			const cni_node *n = &p->sparse.nodes[k];
			if (round == 0) {
				memcpy(first + k * CNI_NODE_ROWS, n->x, sizeof n->x);
				owners[k] = n->owner;
			}
			differs += owners[k] != n->owner || memcmp(first + k * CNI_NODE_ROWS, n->x, sizeof n->x) != 0;
		}
		CHECK(differs == 0);
		solve(p, 1e-5f); /* again with the same plan */
		for (differs = k = 0; k < p->sparse.node_count; ++k)
			differs += memcmp(first + k * CNI_NODE_ROWS, p->sparse.nodes[k].x, sizeof p->sparse.nodes[k].x) != 0;
		CHECK(differs == 0);
		end(p);
	}
}

/* ---- half a solution for many sides ---- */

#define SIDES 8

/* x^T K^-1 x by whole solutions, one for each column, against cni_sparse_reach. */
static double reach_error(problem *p)
{
	const cni_component *c = &p->sparse.components[0];
	uint64_t floats = (uint64_t)(c->end - c->begin) * CNI_NODE_ROWS * SIDES;
	float *x = (float *)cni_arena_push(&p->arena, sizeof(float) * floats), *out = (float *)cni_arena_push(&p->arena, sizeof(float) * SIDES * SIDES);
	double found[SIDES][SIDES], off = 0.0, most = 0.0;
	int32_t k, l, n, i;
	memset(x, 0, sizeof(float) * (size_t)floats);
	memset(out, 0, sizeof(float) * SIDES * SIDES);
	for (k = 0; k < SIDES; ++k)
		for (n = 0; n < 2; ++n) /* few nodes have a side, as few joints feel a contact */
			for (i = 0; i < 2; ++i)
				x[(pick_int(p, c->end - c->begin) * CNI_NODE_ROWS + i) * SIDES + k] = pick(p, -1.0f, 1.0f);
	memset(found, 0, sizeof found);
	for (k = 0; k < SIDES; ++k) {
		for (n = c->begin; n < c->end; ++n)
			for (i = 0; i < CNI_NODE_ROWS; ++i)
				p->sparse.nodes[n].x[i] = x[((n - c->begin) * CNI_NODE_ROWS + i) * SIDES + k];
		CHECK(cni_sparse_solve(&p->sparse, c));
		for (l = 0; l < SIDES; ++l)
			for (n = c->begin; n < c->end; ++n)
				for (i = 0; i < CNI_NODE_ROWS; ++i)
					found[k][l] += (double)p->sparse.nodes[n].x[i] * (double)x[((n - c->begin) * CNI_NODE_ROWS + i) * SIDES + l];
	}
	cni_sparse_reach(&p->sparse, c, x, SIDES, out);
	for (k = 0; k < SIDES; ++k)
		for (l = k; l < SIDES; ++l) {
			off = fmax(off, fabs(found[k][l] + (double)out[k * SIDES + l]));
			most = fmax(most, fabs(found[k][l]));
		}
	return off / most;
}

static void t_reach_is_what_solutions_give(void)
{
	int32_t seed, rows;
	double worst = 0.0;
	for (seed = 1; seed <= 40; ++seed)
		for (rows = 2; rows <= 3; ++rows) {
			problem *p = begin((uint32_t)seed, 1.0);
			add_bridge(p, 20, rows);
			CHECK(plan(p) && p->sparse.component_count == 1);
			p->sparse.components[0].width = rows;
			solve(p, 1e-4f);
			worst = fmax(worst, reach_error(p));
			end(p);
		}
	CHECK_LE("largest error of an entry, by the largest entry", worst, 1e-3, "");
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(t_equal_masses_match_a_dense_solution);
	RUN(t_unequal_masses_match_a_dense_solution);
	RUN(t_regular_is_a_part_of_the_diagonal);
	RUN(t_repeated_constraints_are_satisfied);
	RUN(t_reach_is_what_solutions_give);
	RUN(t_rows_that_act_on_nothing_get_nothing);
	RUN(t_simple_trees_make_no_fill);
	RUN(t_random_trees_make_little);
	RUN(t_plans_are_well_formed);
	RUN(t_beyond_the_limit_is_refused_alone);
	RUN(t_beyond_the_budget_is_refused);
	RUN(t_hubs_are_refused);
	RUN(t_a_kept_plan_is_used_again);
	RUN(t_too_little_memory_is_survived);
	RUN(t_scratch_is_what_was_promised);
	RUN(t_the_same_twice);
	return test_end();
}
