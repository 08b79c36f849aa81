/*
 * linear/sparse_solve.c - factorization and solution in the order of a plan (method in sparse.h).
 *
 * Reads nodes and inverse masses, writes blocks, pivots and the nodes' x. Blocks have the component's width, two or
 * three: a block of two columns is one vector, of three columns three vectors whose last lane is zero. Functions with a width
 * as their last argument are inlined with a constant one. Unused rows of a node are zero and get no impulse; the number
 * of its leading rows that are used bounds the work of eliminating it.
 */
#include "linear/sparse.h"

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

CNI_INLINE int32_t vectors_of(int32_t w)
{
	return w == 2 ? 1 : 3;
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

/* Vector i of a product of columns, a b^T: element i of a, times `scale`, times b. With two rows vector 0 has both. */
CNI_INLINE cni_four outer(const float *a, float scale, cni_four b, int32_t i, int32_t w)
{
	cni_four x = cni_four_load(a);
	if (w == 2)
		return cni_four_times(CNI_FOUR_PICK(b, b, 0, 1, 0, 1), cni_four_scale(CNI_FOUR_PICK(x, x, 0, 0, 1, 1), scale));
	return cni_four_scale(b, a[i] * scale);
}

CNI_INLINE int32_t diagonal_at(int32_t i, int32_t w)
{
	return w == 2 ? 3 * i : 5 * i;
}

/* Computes a node's own block. */
CNI_INLINE void diagonal_form(cni_node *n, float *d, const cni_motion *motions, float regular, int32_t w)
{
	const cni_motion *a = motions + n->ia, *b = motions + n->ib;
	const cni_levers *l = &n->levers;
	cni_four ax = cni_four_load(l->ax), ay = cni_four_load(l->ay), aw = cni_four_load(l->aw);
	cni_four bx = cni_four_load(l->bx), by = cni_four_load(l->by), bw = cni_four_load(l->bw), rows[CNI_NODE_ROWS];
	for (int32_t i = 0; i < vectors_of(w); ++i) {
		cni_four sum = cni_four_scale(cni_four_add(outer(l->ax, 1.0f, ax, i, w), outer(l->ay, 1.0f, ay, i, w)), a->inv_mass);
		sum = cni_four_add(sum, outer(l->aw, a->inv_inertia, aw, i, w));
		sum = cni_four_add(sum, cni_four_scale(cni_four_add(outer(l->bx, 1.0f, bx, i, w), outer(l->by, 1.0f, by, i, w)), b->inv_mass));
		rows[i] = cni_four_add(sum, outer(l->bw, b->inv_inertia, bw, i, w));
	}
	for (int32_t i = 0; i < vectors_of(w); ++i)
		cni_four_store(d + 4 * i, rows[i]);
	d[w == 2 ? 2 : 4] += n->cross;
	for (int32_t i = 0; i < w; ++i) {
		float *x = &d[diagonal_at(i, w)];
		*x += regular * *x + n->compliance[i];
		n->diagonal[i] = *x;
	}
}

/* Adds a term to a block. first: the block's present content is ignored. */
CNI_INLINE void coupling_add(const cni_sparse *s, const cni_coupling *c, const cni_motion *motions, float *block, int32_t first, int32_t w)
{
	const cni_levers *high = &s->nodes[c->high].levers, *low = &s->nodes[c->low].levers;
	const cni_motion *m = motions + (c->high_side ? s->nodes[c->high].ib : s->nodes[c->high].ia);
	const float *lx = c->low_side ? low->bx : low->ax, *ly = c->low_side ? low->by : low->ay, *lw = c->low_side ? low->bw : low->aw;
	cni_four hx = cni_four_scale(cni_four_load(c->high_side ? high->bx : high->ax), m->inv_mass);
	cni_four hy = cni_four_scale(cni_four_load(c->high_side ? high->by : high->ay), m->inv_mass);
	cni_four hw = cni_four_scale(cni_four_load(c->high_side ? high->bw : high->aw), m->inv_inertia), columns[CNI_NODE_ROWS];
	for (int32_t i = 0; i < vectors_of(w); ++i)
		columns[i] = cni_four_add(cni_four_add(outer(lx, 1.0f, hx, i, w), outer(ly, 1.0f, hy, i, w)), outer(lw, 1.0f, hw, i, w));
	for (int32_t i = 0; i < vectors_of(w); ++i)
		cni_four_store(block + 4 * i, first ? columns[i] : cni_four_add(cni_four_load(block + 4 * i), columns[i]));
}

/* ---- elimination ---- */

CNI_INLINE float pivot_inverse(float pivot, float least)
{
	return pivot > least ? 1.0f / pivot : 0.0f;
}

/*
 * Inverts a symmetric block, given by its lower triangle, in place by LDL^T. A row whose pivot has cancelled to below `least` of the diagonal
 * is zero in the inverse, so that it gets no impulse, and so is one beyond those used.
 */
CNI_INLINE void pivot_invert(float *d, const float *diagonal, float least, int32_t used, int32_t w)
{
	if (w == 2) {
		float i0 = pivot_inverse(d[0], least * diagonal[0]), l10 = d[2] * i0, i1 = pivot_inverse(d[3] - l10 * d[2], least * diagonal[1]);
		float d1 = -l10 * i1;
		cni_four_store(d, cni_four_of(i0 + l10 * l10 * i1, d1, d1, i1));
	} else {
		float i0 = pivot_inverse(d[0], least * diagonal[0]), l10 = d[4] * i0, l20 = d[8] * i0;
		float i1 = used < 2 ? 0.0f : pivot_inverse(d[5] - l10 * d[4], least * diagonal[1]), c21 = d[9] - l20 * d[4], l21 = c21 * i1;
		float i2 = used < 3 ? 0.0f : pivot_inverse(d[10] - l20 * d[8] - l21 * c21, least * diagonal[2]), t20 = l10 * l21 - l20;
		float d1 = -l10 * i1 - t20 * l21 * i2, d2 = t20 * i2, d5 = -l21 * i2;
		cni_four_store(d, cni_four_of(i0 + l10 * l10 * i1 + t20 * t20 * i2, d1, d2, 0.0f));
		cni_four_store(d + 4, cni_four_of(d1, i1 + l21 * l21 * i2, d5, 0.0f));
		cni_four_store(d + 8, cni_four_of(d2, d5, i2, 0.0f));
	}
}

/* The elements of a block's rows and columns, each in all lanes; of two columns: at[0][k] has those of column k, twice each. */
typedef struct factor_elements {
	cni_four at[CNI_NODE_ROWS][CNI_NODE_ROWS];
} factor_elements;

CNI_INLINE factor_elements elements_of(const float *block, int32_t used, int32_t w)
{
	factor_elements f;
	if (w == 2) {
		cni_four b = cni_four_load(block);
		f.at[0][0] = CNI_FOUR_PICK(b, b, 0, 0, 1, 1);
		f.at[0][1] = CNI_FOUR_PICK(b, b, 2, 2, 3, 3);
	}
	for (int32_t i = 0; i < 3 && w == 3; ++i)
		for (int32_t k = 0; k < used; ++k)
			f.at[i][k] = cni_four_all(block[4 * k + i]);
	return f;
}

/* Vector i of left * block^T, by the block's columns: the sum over the first `used` of an element times a column. */
CNI_INLINE cni_four vector_times(const factor_elements *left, int32_t i, const float *block, int32_t used, int32_t w)
{
	cni_four b = cni_four_load(block), sum;
	if (w == 2)
		return cni_four_add(cni_four_times(left->at[0][0], CNI_FOUR_PICK(b, b, 0, 1, 0, 1)), cni_four_times(left->at[0][1], CNI_FOUR_PICK(b, b, 2, 3, 2, 3)));
	sum = cni_four_times(left->at[i][0], b);
	for (int32_t k = 1; k < used; ++k)
		sum = cni_four_add(sum, cni_four_times(left->at[i][k], cni_four_load(block + 4 * k)));
	return sum;
}

/* target -= right * left^T, for `count` consecutive blocks */
CNI_INLINE void blocks_update(float *target, const factor_elements *left, const float *right, int32_t count, int32_t used, int32_t w)
{
	for (int32_t k = 0; k < count; ++k, target += block_floats(w), right += block_floats(w))
		for (int32_t i = 0; i < vectors_of(w); ++i)
			cni_four_store(target + 4 * i, cni_four_subtract(cni_four_load(target + 4 * i), vector_times(left, i, right, used, w)));
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
CNI_INLINE void node_eliminate(const cni_sparse *s, const region *r, int32_t k, float least, int32_t used, int32_t w)
{
	int32_t run, end = s->first[k + 1];
	float *d = pivot_at(r, k, w), scaled[CNI_BLOCK_FLOATS];
	factor_elements pivot, left;
	pivot_invert(d, s->nodes[k].diagonal, least, used, w);
	if (s->first[k] == end)
		return;
	pivot = elements_of(d, used, w);
	for (int32_t e = s->first[k]; e < end; ++e) {
		int32_t m = s->below[e], at = s->first[m];
		float *block = block_at(r, e, w);
		for (int32_t i = 0; i < (w == 2 ? 1 : used); ++i)
			cni_four_store(scaled + 4 * i, vector_times(&pivot, i, block, used, w));
		left = elements_of(scaled, used, w);
		blocks_update(pivot_at(r, m, w), &left, block, 1, used, w);
		for (int32_t i = 0; i < (w == 2 ? 1 : used); ++i)
			cni_four_store(block + 4 * i, cni_four_load(scaled + 4 * i));
		for (int32_t f = e + 1; f < end; f += run, at += run) {
			while (s->below[at] != s->below[f])
				++at;
			run = run_length(s, f, end, at, s->first[m + 1]);
			blocks_update(block_at(r, at, w), &left, block_at(r, f, w), run, used, w);
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

CNI_INLINE void blocks_clear(const region *r, int32_t block, int32_t end, int32_t w)
{
	for (; block < end; ++block)
		for (int32_t i = 0; i < vectors_of(w); ++i)
			cni_four_store(block_at(r, block, w) + 4 * i, cni_four_all(0.0f));
}

CNI_INLINE void factor(cni_sparse *s, const cni_component *c, const cni_motion *motions, int32_t w)
{
	region r = region_of(s, c);
	float least = cni_max(CNI_PIVOT_LEAST, PIVOT_LEAST_REGULAR * c->regular);
	int32_t formed = r.block_first;
	for (int32_t k = c->begin; k < c->end; ++k)
		diagonal_form(&s->nodes[k], pivot_at(&r, k, w), motions, c->regular, w);
	for (int32_t k = c->coupling_begin; k < c->coupling_end; ++k) { /* by block, ascending; between them is fill */
		const int32_t block = s->couplings[k].block, first = block >= formed;
		blocks_clear(&r, formed, block, w);
		coupling_add(s, &s->couplings[k], motions, block_at(&r, block, w), first, w);
		formed = block + 1;
	}
	blocks_clear(&r, formed, s->first[c->end], w);
	for (int32_t k = c->begin; k < c->end; ++k) {
		int32_t used = w == 2 ? 2 : rows_used(&s->nodes[k].levers);
		if (w == 2 || used == 2)
			node_eliminate(s, &r, k, least, 2, w);
		else if (used == 1)
			node_eliminate(s, &r, k, least, 1, w);
		else
			node_eliminate(s, &r, k, least, 3, w);
	}
}

void cni_sparse_factor(cni_sparse *s, const cni_component *c, const cni_motion *motions)
{
	if (c->width == 2)
		factor(s, c, motions, 2);
	else
		factor(s, c, motions, 3);
}

void cni_sparse_take(cni_sparse *s, const cni_component *c, const float *pivots, const float *blocks, int32_t stride)
{
	region r = region_of(s, c);
	for (int32_t k = c->begin; k < c->end; ++k, pivots += 3 * stride)
		cni_four_store(pivot_at(&r, k, 2), cni_four_of(pivots[0], pivots[stride], pivots[stride], pivots[2 * stride]));
	for (int32_t k = r.block_first; k < s->first[c->end]; ++k, blocks += 4 * stride)
		cni_four_store(block_at(&r, k, 2), cni_four_of(blocks[0], blocks[2 * stride], blocks[stride], blocks[3 * stride]));
}

int32_t cni_sparse_is_redundant(const cni_sparse *s, const cni_component *c, float part)
{
	region r = region_of(s, c);
	for (int32_t k = c->begin; k < c->end; ++k)
		for (int32_t i = 0; i < s->nodes[k].rows; ++i) {
			float inverse = pivot_at(&r, k, c->width)[diagonal_at(i, c->width)];
			if (inverse == 0.0f || part * s->nodes[k].diagonal[i] * inverse > 1.0f)
				return 1;
		}
	return 0;
}

/* ---- solution ---- */

/* block^T y: its columns times y. */
CNI_INLINE cni_four columns_apply(const float *block, cni_four y, int32_t w)
{
	cni_four p[CNI_NODE_ROWS];
	for (int32_t i = 0; i < vectors_of(w); ++i)
		p[i] = cni_four_times(cni_four_load(block + 4 * i), w == 2 ? CNI_FOUR_PICK(y, y, 0, 1, 0, 1) : y);
	if (w == 2)
		return cni_four_add(CNI_FOUR_PICK(p[0], p[0], 0, 2, 0, 2), CNI_FOUR_PICK(p[0], p[0], 1, 3, 1, 3));
	cni_four_columns(&p[0], &p[1], &p[2]);
	return cni_four_add(cni_four_add(p[0], p[1]), p[2]);
}

/* x = L^-1 x. */
CNI_INLINE void lower_solve(cni_sparse *s, const cni_component *c, const region *r, int32_t w)
{
	cni_node *nodes = s->nodes;
	for (int32_t k = c->begin; k < c->end; ++k) {
		cni_four x = cni_four_load(nodes[k].x), lanes[CNI_NODE_ROWS];
		if (nodes[k].x[0] == 0.0f && nodes[k].x[1] == 0.0f && (w == 2 || nodes[k].x[2] == 0.0f))
			continue; /* right sides of few nodes: direct/heavy_response.c */
		lanes[0] = w == 2 ? CNI_FOUR_PICK(x, x, 0, 0, 1, 1) : CNI_FOUR_PICK(x, x, 0, 0, 0, 0);
		lanes[1] = CNI_FOUR_PICK(x, x, 1, 1, 1, 1);
		lanes[2] = CNI_FOUR_PICK(x, x, 2, 2, 2, 2);
		for (int32_t e = s->first[k]; e < s->first[k + 1]; ++e) {
			const float *block = block_at(r, e, w);
			float *y = nodes[s->below[e]].x;
			cni_four sum = cni_four_times(cni_four_load(block), lanes[0]);
			for (int32_t i = 1; i < vectors_of(w); ++i)
				sum = cni_four_add(sum, cni_four_times(cni_four_load(block + 4 * i), lanes[i]));
			sum = w == 2 ? cni_four_add(sum, CNI_FOUR_PICK(sum, sum, 2, 3, 2, 3)) : sum;
			cni_four_store(y, cni_four_subtract(cni_four_load(y), sum));
		}
	}
}

/* Solves L D L^T x = b: pivots are the inverse of D. */
CNI_INLINE int32_t solve(cni_sparse *s, const cni_component *c, int32_t w)
{
	region r = region_of(s, c);
	cni_node *nodes = s->nodes;
	const cni_four zero = cni_four_all(0.0f);
	cni_four finite = zero; /* sum of 0 * x: stays 0 while all x are finite */
	lower_solve(s, c, &r, w);
	for (int32_t k = c->end - 1; k >= c->begin; --k) {
		cni_four x = columns_apply(pivot_at(&r, k, w), cni_four_load(nodes[k].x), w);
		for (int32_t e = s->first[k]; e < s->first[k + 1]; ++e)
			x = cni_four_subtract(x, columns_apply(block_at(&r, e, w), cni_four_load(nodes[s->below[e]].x), w));
		x = w == 2 ? CNI_FOUR_PICK(x, zero, 0, 1, 4, 4) : x;
		cni_four_store(nodes[k].x, x);
		finite = cni_four_add(finite, cni_four_times(zero, x));
	}
	return cni_four_sum(finite) == 0.0f;
}

int32_t cni_sparse_solve(cni_sparse *s, const cni_component *c)
{
	return c->width == 2 ? solve(s, c, 2) : solve(s, c, 3);
}

CNI_INLINE int32_t halves(cni_sparse *s, const cni_component *c, float *y, float *z, int32_t *at, int32_t w)
{
	region r = region_of(s, c);
	const cni_four zero = cni_four_all(0.0f);
	int32_t count = 0;
	lower_solve(s, c, &r, w);
	for (int32_t k = c->begin; k < c->end; ++k, y += CNI_NODE_LANES, z += CNI_NODE_LANES) {
		const float *x = s->nodes[k].x;
		cni_four half = cni_four_load(x), scaled = columns_apply(pivot_at(&r, k, w), half, w);
		cni_four_store(y, half);
		cni_four_store(z, w == 2 ? CNI_FOUR_PICK(scaled, zero, 0, 1, 4, 4) : scaled);
		if (x[0] != 0.0f || x[1] != 0.0f || (w == 3 && x[2] != 0.0f))
			at[count++] = CNI_NODE_LANES * (k - c->begin);
	}
	return count;
}

int32_t cni_sparse_halves(cni_sparse *s, const cni_component *c, float *y, float *z, int32_t *at)
{
	return c->width == 2 ? halves(s, c, y, z, at, 2) : halves(s, c, y, z, at, 3);
}
