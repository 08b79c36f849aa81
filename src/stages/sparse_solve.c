/*
 * stages/sparse_solve.c - factorization and solution in the order of a plan (method in sparse.h).
 *
 * Reads nodes and inverse masses, writes blocks, pivots and the nodes' x. Every loop over rows has three turns, so
 * that the compiler unrolls it; rows that a node lacks are zero with a pivot of one.
 */
#include "stages/sparse.h"

#include <string.h>

#define R CNI_NODE_ROWS
/* A pivot below this part of the diagonal it came from is rounding. */
#define PIVOT_LEAST 2e-6f

static float *block_at(const cni_sparse *s, int32_t block)
{
	return s->blocks + (size_t)block * (R * R);
}

static float *pivot_at(const cni_sparse *s, int32_t node)
{
	return s->pivots + (size_t)node * (R * R);
}

/* A row's end at one of its bodies. */
static void lever_end(const cni_lever *l, int32_t side, float *x, float *y, float *w)
{
	*x = side ? l->bx : l->ax;
	*y = side ? l->by : l->ay;
	*w = side ? l->bw : l->aw;
}

static void diagonal_form(cni_sparse *s, int32_t k, const cni_motion *motions, float regular)
{
	const cni_node *n = &s->nodes[k];
	const cni_motion *a = motions + n->ia, *b = motions + n->ib;
	float *d = pivot_at(s, k);
	int32_t i, l;
	for (i = 0; i < R; ++i)
		for (l = 0; l <= i; ++l) {
			const cni_lever *p = &n->lever[i], *q = &n->lever[l];
			d[i * R + l] = a->inv_mass * (p->ax * q->ax + p->ay * q->ay) + a->inv_inertia * p->aw * q->aw +
			               b->inv_mass * (p->bx * q->bx + p->by * q->by) + b->inv_inertia * p->bw * q->bw;
		}
	for (i = 0; i < R; ++i)
		d[i * R + i] += regular * d[i * R + i] + n->compliance[i];
	/* The untouched diagonal is kept above it until elimination, to tell rounding from pivots. */
	d[1] = d[0];
	d[2] = d[4];
	d[5] = d[8];
}

static void coupling_add(cni_sparse *s, const cni_coupling *c, const cni_motion *motions)
{
	const cni_node *high = &s->nodes[c->high], *low = &s->nodes[c->low];
	const cni_motion *m = motions + (c->high_side ? high->ib : high->ia);
	float *block = block_at(s, c->block);
	int32_t i, l;
	for (i = 0; i < R; ++i) {
		float x, y, w;
		lever_end(&high->lever[i], c->high_side, &x, &y, &w);
		x *= m->inv_mass;
		y *= m->inv_mass;
		w *= m->inv_inertia;
		for (l = 0; l < R; ++l) {
			float lx, ly, lw;
			lever_end(&low->lever[l], c->low_side, &lx, &ly, &lw);
			block[i * R + l] += x * lx + y * ly + w * lw;
		}
	}
}

/*
 * The inverse of a symmetric 3 x 3 whose lower half is given, in place, by LDL^T; a row whose pivot has
 * cancelled is left out: zero in the inverse, so that it gets no impulse.
 */
static void pivot_invert(float *d)
{
	float most0 = d[1], most1 = d[2], most2 = d[5];
	float p0 = d[0], p1, p2, l10, l20, l21, i0, i1, i2, t10, t20, t21;
	i0 = p0 > PIVOT_LEAST * most0 ? 1.0f / p0 : 0.0f;
	l10 = d[3] * i0;
	l20 = d[6] * i0;
	p1 = d[4] - l10 * d[3];
	i1 = p1 > PIVOT_LEAST * most1 ? 1.0f / p1 : 0.0f;
	l21 = (d[7] - l20 * d[3]) * i1;
	p2 = d[8] - l20 * d[6] - l21 * (d[7] - l20 * d[3]);
	i2 = p2 > PIVOT_LEAST * most2 ? 1.0f / p2 : 0.0f;
	/* rows of L^-1 */
	t10 = -l10;
	t21 = -l21;
	t20 = l10 * l21 - l20;
	d[0] = i0 + t10 * t10 * i1 + t20 * t20 * i2;
	d[3] = d[1] = t10 * i1 + t20 * t21 * i2;
	d[6] = d[2] = t20 * i2;
	d[4] = i1 + t21 * t21 * i2;
	d[7] = d[5] = t21 * i2;
	d[8] = i2;
}

/* out = block * pivot */
static void block_times(const float *block, const float *pivot, float *out)
{
	int32_t i, l;
	for (i = 0; i < R; ++i)
		for (l = 0; l < R; ++l)
			out[i * R + l] = block[i * R] * pivot[l] + block[i * R + 1] * pivot[R + l] + block[i * R + 2] * pivot[2 * R + l];
}

/* target -= left * right^T, the lower half alone or all of it */
static void block_update(float *target, const float *left, const float *right, int32_t lower)
{
	int32_t i, l;
	for (i = 0; i < R; ++i)
		for (l = 0; l < R; ++l)
			if (!lower || l <= i)
				target[i * R + l] -= left[i * R] * right[l * R] + left[i * R + 1] * right[l * R + 1] + left[i * R + 2] * right[l * R + 2];
}

/* Takes node k out of all that comes after it. */
static void node_eliminate(cni_sparse *s, int32_t k)
{
	int32_t e, f, end = s->first[k + 1];
	const float *pivot = pivot_at(s, k);
	for (e = s->first[k]; e < end; ++e) {
		int32_t m = s->below[e], at = s->first[m];
		float scaled[R * R];
		block_times(block_at(s, e), pivot, scaled);
		block_update(pivot_at(s, m), scaled, block_at(s, e), 1);
		for (f = e + 1; f < end; ++f) {
			while (s->below[at] != s->below[f])
				++at;
			block_update(block_at(s, at), block_at(s, f), scaled, 0);
		}
	}
}

void cni_sparse_factor(cni_sparse *s, const cni_component *c, const cni_motion *motions)
{
	int32_t k, first = s->first[c->begin];
	memset(block_at(s, first), 0, sizeof(float) * R * R * (size_t)(s->first[c->end] - first));
	for (k = c->begin; k < c->end; ++k)
		diagonal_form(s, k, motions, c->regular);
	for (k = c->coupling_begin; k < c->coupling_end; ++k)
		coupling_add(s, &s->couplings[k], motions);
	for (k = c->begin; k < c->end; ++k) {
		pivot_invert(pivot_at(s, k));
		node_eliminate(s, k);
	}
}

/* out = pivot * x */
static void pivot_apply(const float *pivot, const float *x, float *out)
{
	int32_t i;
	for (i = 0; i < R; ++i)
		out[i] = pivot[i * R] * x[0] + pivot[i * R + 1] * x[1] + pivot[i * R + 2] * x[2];
}

void cni_sparse_solve(cni_sparse *s, const cni_component *c)
{
	int32_t k, e, i;
	for (k = c->begin; k < c->end; ++k) {
		float z[R];
		pivot_apply(pivot_at(s, k), s->nodes[k].x, z);
		for (e = s->first[k]; e < s->first[k + 1]; ++e) {
			const float *block = block_at(s, e);
			float *y = s->nodes[s->below[e]].x;
			for (i = 0; i < R; ++i)
				y[i] -= block[i * R] * z[0] + block[i * R + 1] * z[1] + block[i * R + 2] * z[2];
		}
	}
	for (k = c->end - 1; k >= c->begin; --k) {
		float *y = s->nodes[k].x, out[R];
		for (e = s->first[k]; e < s->first[k + 1]; ++e) {
			const float *block = block_at(s, e), *x = s->nodes[s->below[e]].x;
			for (i = 0; i < R; ++i)
				y[i] -= block[i] * x[0] + block[R + i] * x[1] + block[2 * R + i] * x[2];
		}
		pivot_apply(pivot_at(s, k), y, out);
		for (i = 0; i < R; ++i)
			y[i] = out[i];
	}
}
