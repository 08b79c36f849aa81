/*
 * test/linear/sparse_test.c - solutions of the direct solver of coupled constraints (linear/sparse.h) against a dense solver.
 *
 * The dense matrix is made from levers and masses in double precision, independently of the plan's blocks. If
 * sparse_plan_test.c fails as well, look in linear/sparse_plan.c; if only the numbers are wrong, in linear/sparse_solve.c.
 */
#include "sparse_systems.h"

/* ---- the same, dense and in double ---- */

typedef struct dense {
	int32_t size;
	double matrix[ROWS_MOST][ROWS_MOST], factor[ROWS_MOST][ROWS_MOST];
	double side[ROWS_MOST], exact[ROWS_MOST], found[ROWS_MOST];
} dense;

static dense full;

/* Change of speed along lever q by a unit impulse along lever p, through one body. */
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

/* |b - A x| over |A| |x| + |b|, the largest over the rows: small for any condition of A. */
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
	worst->backward = greater(worst->backward, backward_error());
	worst->forward = greater(worst->forward, forward_error());
	worst->residual = greater(worst->residual, residual());
}

/* ---- solutions ---- */

static void compare(const char *name, void (*make)(problem *), double decades, double backward_bound, double forward_bound)
{
	errors worst = { 0.0, 0.0, 0.0 };
	uint32_t seed;
	for (seed = 1; seed <= TEST_MANY(8); ++seed) {
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
	compare("soft net of pins", make_soft_net, 0.0, 2e-6, 5e-4);
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

/* `regular` increases the diagonal by a fraction of itself. */
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

/* `cross` adds to the element between the first two rows of a node: friction that both points of a contact share. */
static void t_cross_is_an_entry_of_the_first_two_rows(void)
{
	problem *p = begin(6, 1.0);
	int32_t k, row = 0;
	add_bridge(p, 30, 3);
	for (k = 0; k < p->link_count; ++k)
		soften(p, k, 0.5f);
	REQUIRE(plan(p));
	solve(p, 0.0f);
	for (k = 0; k < p->sparse.node_count; ++k)
		p->sparse.nodes[k].cross = 0.5f * p->compliance[p->sparse.nodes[k].owner - 1000][0];
	for (k = 0; k < p->sparse.component_count; ++k) {
		int32_t n;
		for (n = p->sparse.components[k].begin; n < p->sparse.components[k].end; ++n)
			memcpy(p->sparse.nodes[n].x, p->side[p->sparse.nodes[n].owner - 1000], sizeof p->sparse.nodes[n].x);
		cni_sparse_factor(&p->sparse, &p->sparse.components[k], p->bodies);
		CHECK(cni_sparse_solve(&p->sparse, &p->sparse.components[k]));
	}
	dense_form(p);
	for (k = 0; k < p->link_count; row += p->links[k++].rows) {
		full.matrix[row][row + 1] += (double)(0.5f * p->compliance[k][0]);
		full.matrix[row + 1][row] += (double)(0.5f * p->compliance[k][0]);
	}
	dense_solve();
	CHECK_LE("error of the solution", forward_error(), 1e-5, "");
	end(p);
}

/* cni_sparse_solve reports NaN and overflow. */
static void t_solutions_that_are_no_numbers_are_told(void)
{
	static const float bad[] = { NAN, INFINITY, -INFINITY };
	int32_t k, count;
	for (k = 0; k < 3; ++k) {
		problem *p = begin(7, 1.0);
		add_chain(p, 0, 12, 2);
		REQUIRE(plan(p));
		solve(p, 0.0f);
		CHECK(p->sparse.component_count == 1 && cni_sparse_solve(&p->sparse, &p->sparse.components[0]));
		count = p->sparse.node_count;
		p->sparse.nodes[count / 2].x[1] = bad[k];
		CHECK(!cni_sparse_solve(&p->sparse, &p->sparse.components[0]));
		end(p);
	}
}

/* ---- redundant constraints ---- */

/* Largest impulse. */
static double largest(const problem *p)
{
	double most = 0.0;
	int32_t k, i;
	for (k = 0; k < p->sparse.node_count; ++k)
		for (i = 0; i < p->sparse.nodes[k].rows; ++i)
			most = greater(most, fabs((double)p->sparse.nodes[k].x[i]));
	return most;
}

/* Redundant rows share their impulse, or one takes all of it: rounding makes no large impulses that oppose each other. */
static void t_repeated_constraints_bear_no_more_than_one(void)
{
	double worst = 0.0;
	uint32_t seed;
	for (seed = 1; seed <= 20; ++seed) {
		problem *p = begin(seed, 0.0);
		double once;
		int32_t k, count = 12;
		add_chain(p, 0, count, 2);
		REQUIRE(plan(p));
		solve(p, 0.0f);
		once = largest(p);
		end(p);
		p = begin(seed, 0.0);
		add_chain(p, 0, count, 2);
		for (k = 0; k < count; ++k) {
			int32_t copy = add_link(p, p->links[k].ia, p->links[k].ib, 2);
			memcpy(p->lever[copy], p->lever[k], sizeof p->lever[k]);
			memcpy(p->side[copy], p->side[k], sizeof p->side[k]);
		}
		REQUIRE(plan(p));
		solve(p, 0.0f);
		worst = greater(worst, largest(p) / once);
		end(p);
	}
	CHECK_LE("largest impulse of doubled constraints / of single ones", worst, 1.01, "");
}

/* Largest difference between a row's speed after the impulses and its right hand side. */
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
			worst = greater(worst, unsatisfied(p));
			if (!isfinite(unsatisfied(p)))
				worst = 1e30;
			end(p);
		}
		printf("  diagonal grown by %g\n", (double)regular[r]);
		CHECK_LE("|b - A x| / |b| of doubled constraints", worst, 5e-3, "");
	}
}

/* A row between bodies that cannot move, or without levers, gets no impulse. */
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

/* ---- determinism ---- */

static void t_the_same_twice(void)
{
	static float first[LINKS_MOST * CNI_NODE_LANES];
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
				memcpy(first + k * CNI_NODE_LANES, n->x, sizeof n->x);
				owners[k] = n->owner;
			}
			differs += owners[k] != n->owner || memcmp(first + k * CNI_NODE_LANES, n->x, sizeof n->x) != 0;
		}
		CHECK(differs == 0);
		solve(p, 1e-5f); /* again with the same plan */
		for (differs = k = 0; k < p->sparse.node_count; ++k)
			differs += memcmp(first + k * CNI_NODE_LANES, p->sparse.nodes[k].x, sizeof p->sparse.nodes[k].x) != 0;
		CHECK(differs == 0);
		end(p);
	}
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(t_equal_masses_match_a_dense_solution);
	RUN(t_unequal_masses_match_a_dense_solution);
	RUN(t_regular_is_a_part_of_the_diagonal);
	RUN(t_cross_is_an_entry_of_the_first_two_rows);
	RUN(t_solutions_that_are_no_numbers_are_told);
	RUN(t_repeated_constraints_bear_no_more_than_one);
	RUN(t_repeated_constraints_are_satisfied);
	RUN(t_rows_that_act_on_nothing_get_nothing);
	RUN(t_the_same_twice);
	return test_end();
}
