/*
 * direct/batched_trees_kernel.h - passes over batches of trees (direct/direct_system.h) for one instruction set, with the formulas of
 * joints/joint_kernel.h.
 *
 * A pin's two rows are (-1, 0, ay | 1, 0, -by) and (0, -1, -ax | 0, 1, bx), so multiplications by one or zero of linear/sparse_solve.c are
 * left out here; the rest, and its order, are the same.
 */
#include "direct/direct_system.h"
#include "joints/joint_kernel.h"

/* The bodies of a batch's lanes, in a pass. */
typedef struct tree_bodies {
	side body[CNI_TOPOLOGY_NODES + 2];
} tree_bodies;

CNI_INLINE const int32_t *body_index(const cni_tree_batch *batch, int32_t body, int32_t l)
{
	return (const int32_t *)(const void *)((const char *)batch->nodes + batch->source[body]) + l;
}

/* Bits of the lanes from l on that have a tree. */
CNI_INLINE uint32_t lanes_from(const cni_tree_batch *batch, int32_t l)
{
	return (1u << cni_min_i(batch->lanes - l, CNI_WIDTH)) - 1u;
}

CNI_INLINE void tree_bodies_gather(const cni_motion *motions, const cni_tree_batch *batch, int32_t l, tree_bodies *f)
{
	for (int32_t k = 0; k < batch->bodies; ++k) {
		const int32_t *index = body_index(batch, k, l);
		side_gather(motions, index, (const float *)(const void *)((const char *)index + CNI_SIDE_BYTES), &f->body[k]);
	}
}

CNI_INLINE void tree_bodies_scatter(cni_motion *motions, const cni_tree_batch *batch, int32_t l, const tree_bodies *f)
{
	uint32_t lanes = lanes_from(batch, l);
	for (int32_t k = 0; k < batch->tree.bodies; ++k)
		side_scatter(motions, body_index(batch, k, l), lanes, &f->body[k]);
}

/* ---- the matrix ---- */

CNI_INLINE float *pivot_row(const cni_tree_batch *batch, int32_t node, int32_t l)
{
	return batch->pivots + (size_t)node * (3 * CNI_LANES) + l;
}

CNI_INLINE float *block_row(const cni_tree_batch *batch, int32_t block, int32_t l)
{
	return batch->blocks + (size_t)block * (4 * CNI_LANES) + l;
}

/* 2 x 2, row major; a symmetric one has m01 twice. */
typedef struct matrix {
	cni_wide m00, m01, m10, m11;
} matrix;

CNI_INLINE matrix block_load(const float *p)
{
	const matrix m = { cni_wide_load(p), cni_wide_load(p + CNI_LANES), cni_wide_load(p + 2 * CNI_LANES), cni_wide_load(p + 3 * CNI_LANES) };
	return m;
}

CNI_INLINE void block_store(float *p, const matrix *m)
{
	cni_wide_store(p, m->m00);
	cni_wide_store(p + CNI_LANES, m->m01);
	cni_wide_store(p + 2 * CNI_LANES, m->m10);
	cni_wide_store(p + 3 * CNI_LANES, m->m11);
}

CNI_INLINE matrix pivot_load(const float *p)
{
	const matrix m = { cni_wide_load(p), cni_wide_load(p + CNI_LANES), cni_wide_load(p + CNI_LANES), cni_wide_load(p + 2 * CNI_LANES) };
	return m;
}

CNI_INLINE void pivot_store(float *p, const matrix *m)
{
	cni_wide_store(p, m->m00);
	cni_wide_store(p + CNI_LANES, m->m10);
	cni_wide_store(p + 2 * CNI_LANES, m->m11);
}

CNI_INLINE void diagonal_form(const cni_tree_batch *batch, int32_t node, int32_t l, const tree_bodies *f, matrix *least)
{
	const side *a = &f->body[batch->tree.end[node][0]], *b = &f->body[batch->tree.end[node][1]];
	arms r = arms_load(&batch->nodes[node], l);
	cni_wide ax = a->i * r.ax, ay = a->i * r.ay, bx = b->i * r.bx, by = b->i * r.by;
	matrix d;
	d.m00 = a->m + ay * r.ay + b->m + by * r.by;
	d.m10 = d.m01 = -(ax * r.ay) - bx * r.by;
	d.m11 = a->m + ax * r.ax + b->m + bx * r.bx;
	least->m00 = CNI_PIVOT_LEAST * d.m00;
	least->m11 = CNI_PIVOT_LEAST * d.m11;
	pivot_store(pivot_row(batch, node, l), &d);
}

/* Maps impulses of the low node to speeds of the high one, through the body that they share. */
CNI_INLINE void coupling_form(const cni_tree_batch *batch, const cni_coupling *c, int32_t l, const tree_bodies *f)
{
	int32_t high = c->high - batch->node_first, low = c->low - batch->node_first;
	const cni_joint_block *p = &batch->nodes[high], *q = &batch->nodes[low];
	const side *s = &f->body[batch->tree.end[low][c->low_side]];
	cni_wide px = cni_wide_load((c->high_side ? p->bx : p->ax) + l), py = cni_wide_load((c->high_side ? p->by : p->ay) + l);
	cni_wide qx = cni_wide_load((c->low_side ? q->bx : q->ax) + l), qy = cni_wide_load((c->low_side ? q->by : q->ay) + l);
	cni_wide ix = s->i * px, iy = s->i * py;
	matrix m;
	if (c->high_side == c->low_side) {
		m.m00 = s->m + iy * qy;
		m.m01 = -(iy * qx);
		m.m10 = -(ix * qy);
		m.m11 = s->m + ix * qx;
	} else {
		m.m00 = -s->m - iy * qy;
		m.m01 = iy * qx;
		m.m10 = ix * qy;
		m.m11 = -s->m - ix * qx;
	}
	block_store(block_row(batch, c->block - batch->block_first, l), &m);
}

CNI_INLINE cni_wide pivot_inverse(cni_wide pivot, cni_wide least)
{
	return cni_wide_select(pivot > least, 1.0f / pivot, cni_wide_of(0.0f));
}

CNI_INLINE matrix pivot_invert(float *p, const matrix *least)
{
	matrix d = pivot_load(p), v;
	cni_wide i0 = pivot_inverse(d.m00, least->m00), l10 = d.m10 * i0, i1 = pivot_inverse(d.m11 - l10 * d.m10, least->m11);
	v.m00 = i0 + l10 * l10 * i1;
	v.m01 = v.m10 = -l10 * i1;
	v.m11 = i1;
	pivot_store(p, &v);
	return v;
}

/* left * right */
CNI_INLINE matrix matrix_times(const matrix *a, const matrix *b)
{
	const matrix m = { a->m00 * b->m00 + a->m01 * b->m10, a->m00 * b->m01 + a->m01 * b->m11,
		a->m10 * b->m00 + a->m11 * b->m10, a->m10 * b->m01 + a->m11 * b->m11 };
	return m;
}

/* target -= left * right^T */
CNI_INLINE void matrix_subtract(matrix *t, const matrix *a, const matrix *b)
{
	t->m00 -= a->m00 * b->m00 + a->m01 * b->m01;
	t->m01 -= a->m00 * b->m10 + a->m01 * b->m11;
	t->m10 -= a->m10 * b->m00 + a->m11 * b->m01;
	t->m11 -= a->m10 * b->m10 + a->m11 * b->m11;
}

/* Eliminates a node from all later ones. Its blocks are multiplied by its pivot. */
CNI_INLINE void node_eliminate(const cni_tree_batch *batch, int32_t node, int32_t l, const matrix *pivot)
{
	int32_t e, f, end = batch->first[node + 1];
	for (e = batch->first[node]; e < end; ++e) {
		int32_t to = batch->below[e] - batch->node_first, at = batch->first[to];
		matrix block = block_load(block_row(batch, e - batch->block_first, l)), scaled = matrix_times(&block, pivot);
		matrix d = pivot_load(pivot_row(batch, to, l));
		matrix_subtract(&d, &scaled, &block);
		pivot_store(pivot_row(batch, to, l), &d);
		block_store(block_row(batch, e - batch->block_first, l), &scaled);
		for (f = e + 1; f < end; ++f) {
			matrix left = block_load(block_row(batch, f - batch->block_first, l)), t;
			while (batch->below[at] != batch->below[f])
				++at;
			t = block_load(block_row(batch, at - batch->block_first, l));
			matrix_subtract(&t, &left, &scaled);
			block_store(block_row(batch, at - batch->block_first, l), &t);
		}
	}
}

CNI_INLINE void system_factor(const cni_tree_batch *batch, int32_t l, const tree_bodies *f)
{
	matrix least[CNI_TOPOLOGY_NODES];
	for (int32_t k = 0; k < batch->tree.nodes; ++k)
		diagonal_form(batch, k, l, f, &least[k]);
	for (int32_t k = 0; k < batch->coupling_count; ++k)
		coupling_form(batch, &batch->couplings[k], l, f);
	for (int32_t k = 0; k < batch->tree.nodes; ++k) {
		matrix pivot = pivot_invert(pivot_row(batch, k, l), &least[k]);
		node_eliminate(batch, k, l, &pivot);
	}
}

/* ---- solution ---- */

typedef struct pair {
	cni_wide x, y;
} pair;

CNI_INLINE cni_wide clamped(cni_wide x, float most)
{
	return cni_wide_min(cni_wide_max(x, cni_wide_of(-most)), cni_wide_of(most));
}

/* Right side of a pin: minus its speed, and minus its gap at this rate, no faster than overlaps are pushed apart: trees whose bodies
   are caught behind others, pulled without a limit, throw them (a room of 30 bodies gained 20% of energy). */
CNI_INLINE pair right_side(const cni_joint_block *k, int32_t l, const side *a, const side *b, float rate, float most)
{
	arms r = arms_load(k, l);
	pair x;
	x.x = -(-a->vx + r.ay * a->w + b->vx - r.by * b->w);
	x.y = -(-a->vy - r.ax * a->w + b->vy + r.bx * b->w);
	if (rate > 0.0f) {
		x.x -= clamped(rate * cni_wide_load(k->ex + l), most);
		x.y -= clamped(rate * cni_wide_load(k->ey + l), most);
	}
	return x;
}

/* Solves right sides for impulses. Returns zero in lanes where all is finite. */
CNI_INLINE cni_wide system_solve(const cni_tree_batch *batch, int32_t l, pair *x)
{
	cni_wide finite = cni_wide_of(0.0f); /* 0 times a finite number stays 0 */
	for (int32_t k = 0; k < batch->tree.nodes; ++k) {
		pair z = x[k];
		for (int32_t e = batch->first[k]; e < batch->first[k + 1]; ++e) {
			matrix m = block_load(block_row(batch, e - batch->block_first, l));
			pair *y = &x[batch->below[e] - batch->node_first];
			y->x -= m.m00 * z.x + m.m01 * z.y;
			y->y -= m.m10 * z.x + m.m11 * z.y;
		}
	}
	for (int32_t k = batch->tree.nodes - 1; k >= 0; --k) {
		matrix pivot = pivot_load(pivot_row(batch, k, l));
		pair y = x[k];
		x[k].x = pivot.m00 * y.x + pivot.m01 * y.y;
		x[k].y = pivot.m10 * y.x + pivot.m11 * y.y;
		for (int32_t e = batch->first[k]; e < batch->first[k + 1]; ++e) {
			matrix m = block_load(block_row(batch, e - batch->block_first, l));
			const pair *z = &x[batch->below[e] - batch->node_first];
			x[k].x -= m.m00 * z->x + m.m10 * z->y;
			x[k].y -= m.m01 * z->x + m.m11 * z->y;
		}
		finite += 0.0f * x[k].x;
		finite += 0.0f * x[k].y;
	}
	return finite;
}

CNI_INLINE void pin_push(const arms *r, const pair *x, side *a, side *b)
{
	cni_wide ax = a->i * x->x, ay = a->i * x->y, bx = b->i * x->x, by = b->i * x->y;
	a->vx -= a->m * x->x;
	a->vy -= a->m * x->y;
	a->w += ax * r->ay;
	a->w -= ay * r->ax;
	b->vx += b->m * x->x;
	b->vy += b->m * x->y;
	b->w -= bx * r->by;
	b->w += by * r->bx;
}

CNI_INLINE void right_sides(const cni_tree_batch *batch, int32_t l, const tree_bodies *f, float rate, float most, pair *x)
{
	for (int32_t k = 0; k < batch->tree.nodes; ++k)
		x[k] = right_side(&batch->nodes[k], l, &f->body[batch->tree.end[k][0]], &f->body[batch->tree.end[k][1]], rate, most);
}

/* Solves right sides x and applies the impulses, in the lanes of `selected`, as bits from l on. Lanes whose impulses are not finite get none,
   and their pins are solved one by one from the next pass on. */
CNI_INLINE void pins_solve(cni_tree_batch *batch, int32_t l, tree_bodies *f, pair *x, uint32_t selected)
{
	const cni_wide zero = cni_wide_of(0.0f);
	uint32_t direct = batch->nodes[0].direct >> l & ((1u << CNI_WIDTH) - 1u) & selected, broken;
	cni_mask good = system_solve(batch, l, x) == zero;
	broken = direct & ~cni_mask_bits(good);
	good = cni_mask_of_bits(direct & ~broken);
	for (int32_t k = 0; k < batch->tree.nodes; ++k) {
		cni_joint_block *node = &batch->nodes[k];
		arms r = arms_load(node, l);
		x[k].x = cni_wide_select(good, x[k].x, zero);
		x[k].y = cni_wide_select(good, x[k].y, zero);
		pin_push(&r, &x[k], &f->body[batch->tree.end[k][0]], &f->body[batch->tree.end[k][1]]);
		impulse_add(node->jx + l, x[k].x);
		impulse_add(node->jy + l, x[k].y);
		node->direct &= ~(broken << l);
	}
}

/* ---- passes ---- */

static void batch_begin(cni_tree_batch *batch, const cni_tree_batch_pass *pass)
{
	for (int32_t l = 0; l < batch->lanes; l += CNI_WIDTH) {
		tree_bodies f;
		tree_bodies_gather(pass->motions, batch, l, &f);
		system_factor(batch, l, &f);
	}
}

static void batch_warm(cni_tree_batch *batch, const cni_tree_batch_pass *pass)
{
	float scale = pass->joint.warm_scale;
	for (int32_t l = 0; l < batch->lanes; l += CNI_WIDTH) {
		tree_bodies f;
		tree_bodies_gather(pass->motions, batch, l, &f);
		for (int32_t n = 0; n < batch->tree.nodes; ++n) {
			int32_t node = batch->order[n];
			cni_joint_block *k = &batch->nodes[node];
			arms r = arms_load(k, l);
			cni_wide jx = impulse_warm(k->jx + l, scale), jy = impulse_warm(k->jy + l, scale), t = measure_warm(k, l, scale);
			push(&f.body[batch->tree.end[node][0]], &f.body[batch->tree.end[node][1]], &r, jx, jy, t);
		}
		tree_bodies_scatter(pass->motions, batch, l, &f);
	}
}

/* 1: some of these lanes have pins that are solved one by one. */
CNI_INLINE int32_t has_single(const cni_tree_batch *batch, int32_t l)
{
	uint32_t lanes = lanes_from(batch, l);
	return (batch->nodes[0].direct >> l & lanes) != lanes;
}

/* Springs, motors, limits, and pins that are solved one by one. */
CNI_INLINE void node_solve(cni_tree_batch *batch, int32_t node, int32_t l, tree_bodies *f, const arms *r, const cni_joint_pass *pass, int32_t bias, int32_t single, pair *induced)
{
	cni_joint_block *k = &batch->nodes[node];
	side *a = &f->body[batch->tree.end[node][0]], *b = &f->body[batch->tree.end[node][1]];
	if (single)
		solve_group(k, l, a, b, r, pass, bias, 1, k->direct >> l, &induced->x, &induced->y);
	else if (k->parts)
		solve_group(k, l, a, b, r, pass, bias, 1, ~0u, &induced->x, &induced->y);
	else
		induced->x = induced->y = cni_wide_of(0.0f);
}

/* The pin impulses of springs, motors and limits are kept in `induced` until positions have moved. */
static void batch_solve(cni_tree_batch *batch, const cni_tree_batch_pass *pass)
{
	for (int32_t l = 0; l < batch->lanes; l += CNI_WIDTH) {
		tree_bodies f;
		pair induced, x[CNI_TOPOLOGY_NODES];
		int32_t single = has_single(batch, l);
		tree_bodies_gather(pass->motions, batch, l, &f);
		for (int32_t n = 0; n < batch->tree.nodes; ++n) {
			int32_t node = batch->order[n];
			arms r = arms_load(&batch->nodes[node], l);
			node_solve(batch, node, l, &f, &r, &pass->joint, 1, single, &induced);
			cni_wide_store(batch->nodes[node].induced_x + l, induced.x);
			cni_wide_store(batch->nodes[node].induced_y + l, induced.y);
		}
		right_sides(batch, l, &f, pass->rate, pass->push, x);
		pins_solve(batch, l, &f, x, ~0u);
		tree_bodies_scatter(pass->motions, batch, l, &f);
	}
}

/* ---- hard stops: see direct/joint_projection.c ---- */

CNI_INLINE pair drift(cni_wide rx, cni_wide ry, cni_wide turn)
{
	cni_wide s, c1;
	pair p;
	turn_series(turn, &s, &c1);
	p.x = c1 * rx - (s - turn) * ry;
	p.y = c1 * ry + (s - turn) * rx;
	return p;
}

CNI_INLINE void drift_add(const cni_joint_block *k, int32_t l, const side *a, const side *b, const cni_tree_batch_pass *pass, pair *x)
{
	const cni_wide zero = cni_wide_of(0.0f), least = cni_wide_of(pass->turn_least);
	cni_mask turns = cni_wide_max(cni_wide_abs(a->w), cni_wide_abs(b->w)) > least;
	arms r = arms_load(k, l);
	if (cni_mask_bits(turns) == 0)
		return;
	pair of_a = drift(r.ax, r.ay, pass->joint.h * a->w);
	pair of_b = drift(r.bx, r.by, pass->joint.h * b->w);
	x->x -= cni_wide_select(turns, clamped((of_b.x - of_a.x) * pass->joint.inv_h, pass->push), zero);
	x->y -= cni_wide_select(turns, clamped((of_b.y - of_a.y) * pass->joint.inv_h, pass->push), zero);
}

/* Solves those lanes of batch->selected again whose pins open faster than the pass allows. */
static void batch_project(cni_tree_batch *batch, const cni_tree_batch_pass *pass)
{
	const cni_wide most = cni_wide_of(pass->opening_speed);
	batch->opening = 0;
	for (int32_t l = 0; l < batch->lanes; l += CNI_WIDTH) {
		uint32_t selected = batch->selected & batch->nodes[0].direct, opening = 0;
		pair x[CNI_TOPOLOGY_NODES];
		tree_bodies f;
		selected = selected >> l & ((1u << CNI_WIDTH) - 1u);
		if (selected == 0)
			continue;
		tree_bodies_gather(pass->motions, batch, l, &f);
		right_sides(batch, l, &f, pass->rate, pass->push, x);
		for (int32_t k = 0; k < batch->tree.nodes; ++k) {
			drift_add(&batch->nodes[k], l, &f.body[batch->tree.end[k][0]], &f.body[batch->tree.end[k][1]], pass, &x[k]);
			opening |= cni_mask_bits(cni_wide_max(cni_wide_abs(x[k].x), cni_wide_abs(x[k].y)) > most);
		}
		opening &= selected;
		if (opening == 0)
			continue;
		batch->opening |= opening << l;
		pins_solve(batch, l, &f, x, opening);
		tree_bodies_scatter(pass->motions, batch, l, &f);
	}
}

/* Places of the bodies, and their velocities at the beginning of the substep. */
typedef struct tree_motion {
	place at[CNI_TOPOLOGY_NODES + 2];
	cni_wide vx[CNI_TOPOLOGY_NODES + 2], vy[CNI_TOPOLOGY_NODES + 2], w[CNI_TOPOLOGY_NODES + 2], jumped[CNI_TOPOLOGY_NODES + 2];
} tree_motion;

CNI_INLINE void tree_motion_gather(const cni_motion *motions, const cni_velocity_start *starts, const cni_tree_batch *batch, int32_t l, tree_motion *j)
{
	for (int32_t k = 0; k < batch->bodies; ++k) {
		const int32_t *index = body_index(batch, k, l);
		j->at[k] = place_gather(motions, index);
		cni_wide_gather4((const float *)(const void *)starts, START_FLOATS, index, &j->vx[k], &j->vy[k], &j->w[k], &j->jumped[k]);
	}
}

CNI_INLINE void tree_motion_scatter(cni_velocity_start *starts, const cni_tree_batch *batch, int32_t l, const tree_motion *j)
{
	uint32_t lanes = lanes_from(batch, l);
	for (int32_t k = 0; k < batch->tree.bodies; ++k)
		moving_scatter((float *)(void *)starts, START_FLOATS, body_index(batch, k, l), lanes, j->vx[k], j->vy[k], j->w[k], j->jumped[k]);
}

/* Adds `induced` to the pin's impulse. */
CNI_INLINE cni_wide induced_add(float *impulse, float *induced)
{
	cni_wide sum = cni_wide_load(impulse) + cni_wide_load(induced);
	cni_wide_store(impulse, sum);
	cni_wide_store(induced, cni_wide_of(0.0f));
	return sum;
}

static void batch_relax(cni_tree_batch *batch, const cni_tree_batch_pass *pass)
{
	for (int32_t l = 0; l < batch->lanes; l += CNI_WIDTH) {
		tree_bodies f;
		tree_motion j;
		pair x[CNI_TOPOLOGY_NODES];
		int32_t single = has_single(batch, l);
		tree_bodies_gather(pass->motions, batch, l, &f);
		tree_motion_gather(pass->motions, pass->starts, batch, l, &j);
		for (int32_t n = 0; n < batch->tree.nodes; ++n) {
			int32_t node = batch->order[n], a = batch->tree.end[node][0], b = batch->tree.end[node][1];
			cni_joint_block *k = &batch->nodes[node];
			cni_wide jx = induced_add(k->jx + l, k->induced_x + l), jy = induced_add(k->jy + l, k->induced_y + l);
			arms old = arms_load(k, l), r = arms_renew(&j.at[a], &j.at[b], k, l, k->parts != 0);
			pair induced;
			j.w[a] -= -(f.body[a].i * ((r.ax - old.ax) * jy - (r.ay - old.ay) * jx));
			j.w[b] -= f.body[b].i * ((r.bx - old.bx) * jy - (r.by - old.by) * jx);
			node_solve(batch, node, l, &f, &r, &pass->joint, 0, single, &induced);
			impulse_add(k->jx + l, induced.x);
			impulse_add(k->jy + l, induced.y);
		}
		tree_motion_scatter(pass->starts, batch, l, &j);
		system_factor(batch, l, &f);
		right_sides(batch, l, &f, 0.0f, 0.0f, x);
		pins_solve(batch, l, &f, x, ~0u);
		tree_bodies_scatter(pass->motions, batch, l, &f);
	}
}

const cni_tree_batch_kernel CNI_KERNEL = { batch_begin, batch_warm, batch_solve, batch_relax, batch_project };
