/*
 * linear/sparse_solve.c - factorization and solution in the order of a plan (method in sparse.h).
 *
 * Reads nodes and inverse masses, writes blocks, pivots and the nodes' x. Blocks have the component's width, two or
 * three; each function is written once with the width as its last argument and inlined with it known. Rows that a node
 * lacks are zero and get no impulse.
 */
#include "base/cpu.h"
#include "linear/sparse.h"
#if CNI_HAS_WIDE_4
#define CNI_WIDTH 4
#else
#define CNI_WIDTH 1
#endif
#include "base/wide.h"

#include <stddef.h>
#include <string.h>

#define STRIDE (CNI_NODE_ROWS * CNI_NODE_ROWS)
#define PIVOT_LEAST_REGULAR 0.2f /* so is one below this part of what was added to it: see CNI_PIVOT_LEAST */

/* Where a component's blocks and pivots are: they lie close, in room for the greatest width. */
typedef struct region {
	float *blocks, *pivots;
	int32_t block_first, node_first;
} region;

/* Blocks of two rows are one vector each; their room is that of three. */
static float *aligned(float *blocks, int32_t width)
{
	return width == 2 ? (float *)(((uintptr_t)blocks + 15u) & ~(uintptr_t)15u) : blocks;
}

static region region_of(const cni_sparse *s, const cni_component *c)
{
	region r;
	r.block_first = s->first[c->begin];
	r.node_first = c->begin;
	r.blocks = aligned(s->blocks + (size_t)r.block_first * STRIDE, c->width);
	r.pivots = s->pivots + (size_t)c->begin * STRIDE;
	return r;
}

CNI_INLINE float *block_at(const region *r, int32_t block, int32_t w)
{
	return r->blocks + (size_t)(block - r->block_first) * (size_t)(w * w);
}

CNI_INLINE float *pivot_at(const region *r, int32_t node, int32_t w)
{
	return r->pivots + (size_t)(node - r->node_first) * (size_t)(w * w);
}

/* ---- the matrix ---- */

/* The lower half of a node's own block. */
CNI_INLINE void diagonal_form(const cni_node *n, float *d, const cni_motion *motions, float regular, int32_t w)
{
	const cni_motion *a = motions + n->ia, *b = motions + n->ib;
	int32_t i, l;
	for (i = 0; i < w; ++i)
		for (l = 0; l <= i; ++l) {
			const cni_lever *p = &n->lever[i], *q = &n->lever[l];
			d[i * w + l] = a->inv_mass * (p->ax * q->ax + p->ay * q->ay) + a->inv_inertia * p->aw * q->aw +
			               b->inv_mass * (p->bx * q->bx + p->by * q->by) + b->inv_inertia * p->bw * q->bw;
		}
	for (i = 0; i < w; ++i)
		d[i * w + i] += regular * d[i * w + i] + n->compliance[i];
	d[w] += n->cross;
}

/* A row's end at one of its bodies. */
CNI_INLINE void lever_end(const cni_lever *l, int32_t side, float *x, float *y, float *w)
{
	*x = side ? l->bx : l->ax;
	*y = side ? l->by : l->ay;
	*w = side ? l->bw : l->aw;
}

/* `first`: what was in the block does not count. */
CNI_INLINE void coupling_add(const cni_sparse *s, const cni_coupling *c, const cni_motion *motions, float *block, int32_t first, int32_t w)
{
	const cni_node *high = &s->nodes[c->high], *low = &s->nodes[c->low];
	const cni_motion *m = motions + (c->high_side ? high->ib : high->ia);
	int32_t i, l;
	for (i = 0; i < w; ++i) {
		float x, y, turn;
		lever_end(&high->lever[i], c->high_side, &x, &y, &turn);
		x *= m->inv_mass;
		y *= m->inv_mass;
		turn *= m->inv_inertia;
		for (l = 0; l < w; ++l) {
			float lx, ly, lw;
			lever_end(&low->lever[l], c->low_side, &lx, &ly, &lw);
			block[i * w + l] = (first ? 0.0f : block[i * w + l]) + (x * lx + y * ly + turn * lw);
		}
	}
}

/* ---- elimination ---- */

CNI_INLINE float pivot_inverse(float pivot, float least)
{
	return pivot > least ? 1.0f / pivot : 0.0f;
}

/*
 * The inverse of a symmetric block whose lower half is given, in place, by LDL^T; a row whose pivot has cancelled
 * to below `least` is left out: zero in the inverse, so that it gets no impulse.
 */
CNI_INLINE void pivot_invert(float *d, const float *least, int32_t w)
{
	if (w == 2) {
		float i0 = pivot_inverse(d[0], least[0]), l10 = d[2] * i0, i1 = pivot_inverse(d[3] - l10 * d[2], least[1]);
		d[0] = i0 + l10 * l10 * i1;
		d[1] = d[2] = -l10 * i1;
		d[3] = i1;
	} else {
		float i0 = pivot_inverse(d[0], least[0]), l10 = d[3] * i0, l20 = d[6] * i0;
		float i1 = pivot_inverse(d[4] - l10 * d[3], least[1]), c21 = d[7] - l20 * d[3], l21 = c21 * i1;
		float i2 = pivot_inverse(d[8] - l20 * d[6] - l21 * c21, least[2]), t20 = l10 * l21 - l20;
		d[0] = i0 + l10 * l10 * i1 + t20 * t20 * i2;
		d[3] = d[1] = -l10 * i1 - t20 * l21 * i2;
		d[6] = d[2] = t20 * i2;
		d[4] = i1 + l21 * l21 * i2;
		d[7] = d[5] = -l21 * i2;
		d[8] = i2;
	}
}

/* out = block * pivot */
CNI_INLINE void block_times(const float *block, const float *pivot, float *out, int32_t w)
{
	int32_t i, l, k;
	for (i = 0; i < w; ++i)
		for (l = 0; l < w; ++l) {
			float sum = block[i * w] * pivot[l];
			for (k = 1; k < w; ++k)
				sum += block[i * w + k] * pivot[k * w + l];
			out[i * w + l] = sum;
		}
}

/* target -= left * right^T, the lower half alone or all of it */
CNI_INLINE void block_update(float *target, const float *left, const float *right, int32_t lower, int32_t w)
{
	int32_t i, l, k;
	for (i = 0; i < w; ++i)
		for (l = 0; l < (lower ? i + 1 : w); ++l) {
			float sum = left[i * w] * right[l * w];
			for (k = 1; k < w; ++k)
				sum += left[i * w + k] * right[l * w + k];
			target[i * w + l] -= sum;
		}
}

/* The same with blocks that follow each other, all of each. */
CNI_INLINE void blocks_update(float *target, const float *left, const float *right, int32_t count, int32_t w)
{
	int32_t n;
#if CNI_WIDTH == 4
	if (w == 2) {
		cni_wide first = { right[0], right[2], right[0], right[2] }, second = { right[1], right[3], right[1], right[3] };
		for (n = 0; n < count; ++n) {
			cni_wide b = cni_wide_load(left + n * 4);
			cni_wide sum = __builtin_shufflevector(b, b, 0, 0, 2, 2) * first;
			sum += __builtin_shufflevector(b, b, 1, 1, 3, 3) * second;
			cni_wide_store(target + n * 4, cni_wide_load(target + n * 4) - sum);
		}
		return;
	}
#endif
	for (n = 0; n < count; ++n)
		block_update(target + n * w * w, left + n * w * w, right, 0, w);
}

/* How many of the blocks from e to `end` follow each other from `at` on, as those of one column do in another that holds them
   all. The first is there. */
CNI_INLINE int32_t run_length(const cni_sparse *s, int32_t e, int32_t end, int32_t at, int32_t at_end)
{
	int32_t most = cni_min_i(end - e, at_end - at), count = 1;
	if (s->below[at + most - 1] == s->below[e + most - 1])
		return most;
	while (s->below[at + count] == s->below[e + count])
		++count;
	return count;
}

/* Takes node k out of all that comes after it. */
CNI_INLINE void node_eliminate(const cni_sparse *s, const region *r, int32_t k, int32_t w)
{
	int32_t e, f, run, end = s->first[k + 1];
	const float *pivot = pivot_at(r, k, w);
	for (e = s->first[k]; e < end; ++e) {
		int32_t m = s->below[e], at = s->first[m];
		float scaled[STRIDE];
		block_times(block_at(r, e, w), pivot, scaled, w);
		block_update(pivot_at(r, m, w), scaled, block_at(r, e, w), 1, w);
		for (f = e + 1; f < end; f += run, at += run) {
			while (s->below[at] != s->below[f])
				++at;
			run = run_length(s, f, end, at, s->first[m + 1]);
			blocks_update(block_at(r, at, w), block_at(r, f, w), scaled, run, w);
		}
	}
}

CNI_INLINE void factor(cni_sparse *s, const cni_component *c, const cni_motion *motions, int32_t w)
{
	region r = region_of(s, c);
	float least = cni_max(CNI_PIVOT_LEAST, PIVOT_LEAST_REGULAR * c->regular);
	int32_t k, i;
	if (!c->tree)
		memset(r.blocks, 0, sizeof(float) * (size_t)(w * w) * (size_t)(s->first[c->end] - r.block_first));
	for (k = c->begin; k < c->end; ++k) {
		float *d = pivot_at(&r, k, w);
		diagonal_form(&s->nodes[k], d, motions, c->regular, w);
		for (i = 0; i < w; ++i)
			s->nodes[k].least[i] = least * d[i * w + i];
	}
	for (k = c->coupling_begin; k < c->coupling_end && c->tree; ++k) /* each of a tree is a block by itself */
		coupling_add(s, &s->couplings[k], motions, block_at(&r, s->couplings[k].block, w), 1, w);
	for (k = c->coupling_begin; k < c->coupling_end && !c->tree; ++k)
		coupling_add(s, &s->couplings[k], motions, block_at(&r, s->couplings[k].block, w), 0, w);
	for (k = c->begin; k < c->end; ++k) {
		pivot_invert(pivot_at(&r, k, w), s->nodes[k].least, w);
		node_eliminate(s, &r, k, w);
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

/* y -= block x, or its transpose */
CNI_INLINE void block_take(float *y, const float *block, const float *x, int32_t transposed, int32_t w)
{
	int32_t i, k;
	for (i = 0; i < w; ++i) {
		float sum = block[transposed ? i : i * w] * x[0];
		for (k = 1; k < w; ++k)
			sum += block[transposed ? k * w + i : i * w + k] * x[k];
		y[i] -= sum;
	}
}

/* out = pivot x */
CNI_INLINE void pivot_apply(const float *pivot, const float *x, float *out, int32_t w)
{
	int32_t i, k;
	for (i = 0; i < w; ++i) {
		float sum = pivot[i * w] * x[0];
		for (k = 1; k < w; ++k)
			sum += pivot[i * w + k] * x[k];
		out[i] = sum;
	}
}

/* The numbers of the component's nodes lie `stride` bytes apart. */
CNI_INLINE float *numbers_at(uint8_t *x, const cni_component *c, int32_t node, size_t stride)
{
	return (float *)(void *)(x + (size_t)(node - c->begin) * stride);
}

CNI_INLINE int32_t solve(cni_sparse *s, const cni_component *c, uint8_t *x, size_t stride, int32_t w)
{
	region r = region_of(s, c);
	int32_t k, e, i;
	float finite = 0.0f; /* stays so: 0 times what is finite */
	for (k = c->begin; k < c->end; ++k) {
		float z[CNI_NODE_ROWS];
		pivot_apply(pivot_at(&r, k, w), numbers_at(x, c, k, stride), z, w);
		for (e = s->first[k]; e < s->first[k + 1]; ++e)
			block_take(numbers_at(x, c, s->below[e], stride), block_at(&r, e, w), z, 0, w);
	}
	for (k = c->end - 1; k >= c->begin; --k) {
		float *y = numbers_at(x, c, k, stride), out[CNI_NODE_ROWS];
		for (e = s->first[k]; e < s->first[k + 1]; ++e)
			block_take(y, block_at(&r, e, w), numbers_at(x, c, s->below[e], stride), 1, w);
		pivot_apply(pivot_at(&r, k, w), y, out, w);
		for (i = 0; i < w; ++i) {
			y[i] = out[i];
			finite += 0.0f * out[i];
		}
	}
	return finite == 0.0f;
}

int32_t cni_sparse_solve(cni_sparse *s, const cni_component *c)
{
	uint8_t *x = (uint8_t *)&s->nodes[c->begin] + offsetof(cni_node, x);
	return c->width == 2 ? solve(s, c, x, sizeof(cni_node), 2) : solve(s, c, x, sizeof(cni_node), 3);
}
