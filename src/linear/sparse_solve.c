/*
 * linear/sparse_solve.c - factorization and solution in the order of a plan (method in sparse.h).
 *
 * Reads nodes and inverse masses, writes blocks, pivots and the nodes' x. Blocks have the component's width, two or
 * three: a block of two rows is one vector, of three rows three vectors whose last lane is zero. Functions with a width
 * as their last argument are inlined with a constant one. Unused rows of a node are zero and get no impulse; the number
 * of its leading rows that are used bounds the work of eliminating it.
 */
#include "linear/sparse.h"

#include <string.h>

#define PIVOT_LEAST_REGULAR 0.2f /* so is one below this part of what was added to it: see CNI_PIVOT_LEAST */

/* A component's blocks and pivots: packed at the component's width into memory for the largest width. */
typedef struct region {
	float *blocks, *pivots;
	int32_t block_first, node_first;
} region;

static region region_of(const cni_sparse *s, const cni_component *c)
{
	region r;
	r.block_first = s->first[c->begin];
	r.node_first = c->begin;
	r.blocks = s->blocks + (size_t)r.block_first * CNI_BLOCK_FLOATS;
	r.pivots = s->pivots + (size_t)c->begin * CNI_BLOCK_FLOATS;
	return r;
}

CNI_INLINE size_t block_floats(int32_t w)
{
	return w == 2 ? 4 : CNI_BLOCK_FLOATS;
}

CNI_INLINE float *block_at(const region *r, int32_t block, int32_t w)
{
	return r->blocks + (size_t)(block - r->block_first) * block_floats(w);
}

CNI_INLINE float *pivot_at(const region *r, int32_t node, int32_t w)
{
	return r->pivots + (size_t)(node - r->node_first) * block_floats(w);
}

/* ---- the matrix ---- */

/* Writes rows to a block, or adds them to it. */
CNI_INLINE void block_set(float *block, const cni_four rows[CNI_NODE_ROWS], int32_t add, int32_t w)
{
	int32_t i;
	if (w == 2) {
		cni_four both = CNI_FOUR_PICK(rows[0], rows[1], 0, 1, 4, 5);
		cni_four_store(block, add ? cni_four_add(cni_four_load(block), both) : both);
		return;
	}
	for (i = 0; i < 3; ++i)
		cni_four_store(block + 4 * i, add ? cni_four_add(cni_four_load(block + 4 * i), rows[i]) : rows[i]);
}

CNI_INLINE int32_t diagonal_at(int32_t i, int32_t w)
{
	return w == 2 ? 3 * i : 5 * i;
}

/* Computes a node's own block. */
CNI_INLINE void diagonal_form(cni_node *n, float *d, const cni_motion *motions, float regular, float least, int32_t w)
{
	const cni_motion *a = motions + n->ia, *b = motions + n->ib;
	const cni_levers *l = &n->levers;
	cni_four ax = cni_four_load(l->ax), ay = cni_four_load(l->ay), aw = cni_four_load(l->aw);
	cni_four bx = cni_four_load(l->bx), by = cni_four_load(l->by), bw = cni_four_load(l->bw), rows[CNI_NODE_ROWS];
	int32_t i;
	for (i = 0; i < w; ++i) {
		cni_four sum = cni_four_scale(cni_four_add(cni_four_scale(ax, l->ax[i]), cni_four_scale(ay, l->ay[i])), a->inv_mass);
		sum = cni_four_add(sum, cni_four_scale(aw, a->inv_inertia * l->aw[i]));
		sum = cni_four_add(sum, cni_four_scale(cni_four_add(cni_four_scale(bx, l->bx[i]), cni_four_scale(by, l->by[i])), b->inv_mass));
		rows[i] = cni_four_add(sum, cni_four_scale(bw, b->inv_inertia * l->bw[i]));
	}
	block_set(d, rows, 0, w);
	d[w == 2 ? 2 : 4] += n->cross;
	for (i = 0; i < w; ++i) {
		float *x = &d[diagonal_at(i, w)];
		*x += regular * *x + n->compliance[i];
		n->least[i] = least * *x;
	}
}

/* Adds a term to a block. first: the block's present content is ignored. */
CNI_INLINE void coupling_add(const cni_sparse *s, const cni_coupling *c, const cni_motion *motions, float *block, int32_t first, int32_t w)
{
	const cni_levers *high = &s->nodes[c->high].levers, *low = &s->nodes[c->low].levers;
	const cni_motion *m = motions + (c->high_side ? s->nodes[c->high].ib : s->nodes[c->high].ia);
	const float *x = c->high_side ? high->bx : high->ax, *y = c->high_side ? high->by : high->ay, *turn = c->high_side ? high->bw : high->aw;
	cni_four lx = cni_four_load(c->low_side ? low->bx : low->ax), ly = cni_four_load(c->low_side ? low->by : low->ay);
	cni_four lw = cni_four_load(c->low_side ? low->bw : low->aw), rows[CNI_NODE_ROWS];
	int32_t i;
	for (i = 0; i < w; ++i) {
		cni_four sum = cni_four_add(cni_four_scale(lx, x[i] * m->inv_mass), cni_four_scale(ly, y[i] * m->inv_mass));
		rows[i] = cni_four_add(sum, cni_four_scale(lw, turn[i] * m->inv_inertia));
	}
	block_set(block, rows, !first, w);
}

/* ---- elimination ---- */

CNI_INLINE float pivot_inverse(float pivot, float least)
{
	return pivot > least ? 1.0f / pivot : 0.0f;
}

/* A block by its rows or columns. Those of a block of two rows are repeated in the last two lanes. */
typedef struct factor_rows {
	cni_four row[CNI_NODE_ROWS];
} factor_rows;

/*
 * Inverts a symmetric block, given by its lower triangle, in place by LDL^T, and returns the inverse's rows. A row whose pivot has cancelled
 * to below `least` is zero in the inverse, so that it gets no impulse, and so is one beyond those used.
 */
CNI_INLINE factor_rows pivot_invert(float *d, const float *least, int32_t used, int32_t w)
{
	factor_rows f;
	if (w == 2) {
		float i0 = pivot_inverse(d[0], least[0]), l10 = d[2] * i0, i1 = pivot_inverse(d[3] - l10 * d[2], least[1]);
		float d0 = i0 + l10 * l10 * i1, d1 = -l10 * i1;
		f.row[0] = cni_four_of(d0, d1, d0, d1);
		f.row[1] = f.row[2] = cni_four_of(d1, i1, d1, i1);
		cni_four_store(d, cni_four_of(d0, d1, d1, i1));
	} else {
		float i0 = pivot_inverse(d[0], least[0]), l10 = d[4] * i0, l20 = d[8] * i0;
		float i1 = used < 2 ? 0.0f : pivot_inverse(d[5] - l10 * d[4], least[1]), c21 = d[9] - l20 * d[4], l21 = c21 * i1;
		float i2 = used < 3 ? 0.0f : pivot_inverse(d[10] - l20 * d[8] - l21 * c21, least[2]), t20 = l10 * l21 - l20;
		float d1 = -l10 * i1 - t20 * l21 * i2, d2 = t20 * i2, d5 = -l21 * i2;
		int32_t i;
		f.row[0] = cni_four_of(i0 + l10 * l10 * i1 + t20 * t20 * i2, d1, d2, 0.0f);
		f.row[1] = cni_four_of(d1, i1 + l21 * l21 * i2, d5, 0.0f);
		f.row[2] = cni_four_of(d2, d5, i2, 0.0f);
		for (i = 0; i < 3; ++i)
			cni_four_store(d + 4 * i, f.row[i]);
	}
	return f;
}

/* One row of a product: the sum over its first `used` elements of an element times a row. */
CNI_INLINE cni_four row_times(const float *row, const cni_four *rows, int32_t used)
{
	cni_four sum = cni_four_scale(rows[0], row[0]);
	int32_t k;
	for (k = 1; k < used; ++k)
		sum = cni_four_add(sum, cni_four_scale(rows[k], row[k]));
	return sum;
}

/* Products with a block of two rows on the left: its elements of column 0 and 1, twice each. */
CNI_INLINE cni_four two_times(cni_four left, cni_four row0, cni_four row1)
{
	return cni_four_add(cni_four_times(CNI_FOUR_PICK(left, left, 0, 0, 2, 2), row0), cni_four_times(CNI_FOUR_PICK(left, left, 1, 1, 3, 3), row1));
}

CNI_INLINE factor_rows rows_of(const float *block, int32_t w)
{
	factor_rows f;
	cni_four b = cni_four_load(block);
	if (w == 2) {
		f.row[0] = CNI_FOUR_PICK(b, b, 0, 1, 0, 1);
		f.row[1] = f.row[2] = CNI_FOUR_PICK(b, b, 2, 3, 2, 3);
		return f;
	}
	f.row[0] = b;
	f.row[1] = cni_four_load(block + 4);
	f.row[2] = cni_four_load(block + 8);
	return f;
}

CNI_INLINE factor_rows columns_of(const float *block, int32_t w)
{
	factor_rows f = rows_of(block, w);
	if (w == 2) {
		cni_four b = cni_four_load(block);
		f.row[0] = CNI_FOUR_PICK(b, b, 0, 2, 0, 2);
		f.row[1] = f.row[2] = CNI_FOUR_PICK(b, b, 1, 3, 1, 3);
	} else
		cni_four_columns(&f.row[0], &f.row[1], &f.row[2]);
	return f;
}

/* block *= right */
CNI_INLINE void block_times(float *block, const factor_rows *right, int32_t used, int32_t w)
{
	int32_t i;
	if (w == 2)
		cni_four_store(block, two_times(cni_four_load(block), right->row[0], right->row[1]));
	for (i = 0; i < 3 && w == 3; ++i)
		cni_four_store(block + 4 * i, row_times(block + 4 * i, right->row, used));
}

/* target -= left * right, for `count` consecutive blocks */
CNI_INLINE void blocks_update(float *target, const float *left, const factor_rows *right, int32_t count, int32_t used, int32_t w)
{
	const int32_t vectors = count * (int32_t)(block_floats(w) / 4);
	int32_t i;
	for (i = 0; i < vectors; ++i) {
		float *t = target + 4 * i;
		cni_four product = w == 2 ? two_times(cni_four_load(left + 4 * i), right->row[0], right->row[1]) : row_times(left + 4 * i, right->row, used);
		cni_four_store(t, cni_four_subtract(cni_four_load(t), product));
	}
}

/* Number of blocks from e on (before `end`) that are consecutive in another column from `at` on. That column contains all
   of them, and block `at` is the first. */
CNI_INLINE int32_t run_length(const cni_sparse *s, int32_t e, int32_t end, int32_t at, int32_t at_end)
{
	int32_t most = cni_min_i(end - e, at_end - at), count = 1;
	if (s->below[at + most - 1] == s->below[e + most - 1])
		return most;
	while (s->below[at + count] == s->below[e + count])
		++count;
	return count;
}

/* Eliminates node k, of which `used` rows are not zero, from all later nodes. Its blocks are multiplied by its pivot. */
CNI_INLINE void node_eliminate(const cni_sparse *s, const region *r, int32_t k, int32_t used, int32_t w)
{
	int32_t e, f, run, end = s->first[k + 1];
	const factor_rows pivot = pivot_invert(pivot_at(r, k, w), s->nodes[k].least, used, w);
	for (e = s->first[k]; e < end; ++e) {
		int32_t m = s->below[e], at = s->first[m];
		factor_rows right = columns_of(block_at(r, e, w), w);
		float *scaled = block_at(r, e, w);
		block_times(scaled, &pivot, used, w);
		blocks_update(pivot_at(r, m, w), scaled, &right, 1, used, w);
		if (e + 1 < end)
			right = columns_of(scaled, w);
		for (f = e + 1; f < end; f += run, at += run) {
			while (s->below[at] != s->below[f])
				++at;
			run = run_length(s, f, end, at, s->first[m + 1]);
			blocks_update(block_at(r, at, w), block_at(r, f, w), &right, run, used, w);
		}
	}
}

/* Number of the leading rows that are not zero, at least 1. */
static int32_t rows_used(const cni_levers *l)
{
	int32_t i;
	for (i = CNI_NODE_ROWS - 1; i > 0; --i)
		if (l->aw[i] != 0.0f || l->bw[i] != 0.0f || l->ax[i] != 0.0f || l->ay[i] != 0.0f || l->bx[i] != 0.0f || l->by[i] != 0.0f)
			break;
	return i + 1;
}

CNI_INLINE void factor(cni_sparse *s, const cni_component *c, const cni_motion *motions, int32_t w)
{
	region r = region_of(s, c);
	float least = cni_max(CNI_PIVOT_LEAST, PIVOT_LEAST_REGULAR * c->regular);
	int32_t k;
	if (!c->tree)
		memset(r.blocks, 0, sizeof(float) * block_floats(w) * (size_t)(s->first[c->end] - r.block_first));
	for (k = c->begin; k < c->end; ++k)
		diagonal_form(&s->nodes[k], pivot_at(&r, k, w), motions, c->regular, least, w);
	for (k = c->coupling_begin; k < c->coupling_end && c->tree; ++k) /* in a tree each coupling has its own block */
		coupling_add(s, &s->couplings[k], motions, block_at(&r, s->couplings[k].block, w), 1, w);
	for (k = c->coupling_begin; k < c->coupling_end && !c->tree; ++k)
		coupling_add(s, &s->couplings[k], motions, block_at(&r, s->couplings[k].block, w), 0, w);
	for (k = c->begin; k < c->end; ++k) {
		int32_t used = w == 2 ? 2 : rows_used(&s->nodes[k].levers);
		if (w == 2 || used == 2)
			node_eliminate(s, &r, k, 2, w);
		else if (used == 1)
			node_eliminate(s, &r, k, 1, w);
		else
			node_eliminate(s, &r, k, 3, w);
	}
}

void cni_sparse_factor(cni_sparse *s, const cni_component *c, const cni_motion *motions)
{
	if (c->width == 2)
		factor(s, c, motions, 2);
	else
		factor(s, c, motions, 3);
}

/* ---- solution ---- */

/* The sum of these rows, each times its lane of x. */
CNI_INLINE cni_four rows_apply(const factor_rows *f, cni_four x, int32_t w)
{
	cni_four sum = cni_four_times(f->row[0], CNI_FOUR_PICK(x, x, 0, 0, 0, 0));
	sum = cni_four_add(sum, cni_four_times(f->row[1], CNI_FOUR_PICK(x, x, 1, 1, 1, 1)));
	return w == 2 ? sum : cni_four_add(sum, cni_four_times(f->row[2], CNI_FOUR_PICK(x, x, 2, 2, 2, 2)));
}

/* Solves L D L^T x = b: pivots are the inverse of D. */
CNI_INLINE int32_t solve(cni_sparse *s, const cni_component *c, int32_t w)
{
	region r = region_of(s, c);
	cni_node *nodes = s->nodes;
	const cni_four zero = cni_four_of(0.0f, 0.0f, 0.0f, 0.0f);
	cni_four finite = zero; /* sum of 0 * x: stays 0 while all x are finite */
	int32_t k, e;
	float sums[4];
	for (k = c->begin; k < c->end; ++k) {
		cni_four x = cni_four_load(nodes[k].x);
		if (nodes[k].x[0] == 0.0f && nodes[k].x[1] == 0.0f && nodes[k].x[2] == 0.0f)
			continue; /* right sides of few nodes: direct/heavy_contacts.c */
		for (e = s->first[k]; e < s->first[k + 1]; ++e) {
			factor_rows columns = columns_of(block_at(&r, e, w), w);
			float *y = nodes[s->below[e]].x;
			cni_four_store(y, cni_four_subtract(cni_four_load(y), rows_apply(&columns, x, w)));
		}
	}
	for (k = c->end - 1; k >= c->begin; --k) {
		factor_rows pivot = rows_of(pivot_at(&r, k, w), w);
		cni_four x = rows_apply(&pivot, cni_four_load(nodes[k].x), w);
		for (e = s->first[k]; e < s->first[k + 1]; ++e) {
			factor_rows rows = rows_of(block_at(&r, e, w), w);
			x = cni_four_subtract(x, rows_apply(&rows, cni_four_load(nodes[s->below[e]].x), w));
		}
		x = w == 2 ? CNI_FOUR_PICK(x, zero, 0, 1, 4, 4) : x;
		cni_four_store(nodes[k].x, x);
		finite = cni_four_add(finite, cni_four_times(zero, x));
	}
	cni_four_store(sums, finite);
	return sums[0] + sums[1] + sums[2] == 0.0f;
}

int32_t cni_sparse_solve(cni_sparse *s, const cni_component *c)
{
	return c->width == 2 ? solve(s, c, 2) : solve(s, c, 3);
}
