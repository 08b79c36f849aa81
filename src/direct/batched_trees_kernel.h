/*
 * direct/batched_trees_kernel.h - passes over herds of trees (direct/batched_trees.h) for one instruction set, with the formulas of
 * joints/joint_kernel.h.
 *
 * A pin's two rows are (-1, 0, ay | 1, 0, -by) and (0, -1, -ax | 0, 1, bx), so that what linear/sparse_solve.c multiplies
 * by one or zero is left out here; the rest, and its order, are the same.
 */
#include "direct/batched_trees.h"
#include "joints/joint_kernel.h"

/* The bodies of a herd's lanes, in a pass. */
typedef struct flock {
	side body[CNI_KIND_NODES + 2];
} flock;

CNI_INLINE const int32_t *body_index(const cni_herd *herd, int32_t body, int32_t l)
{
	return (const int32_t *)(const void *)((const char *)herd->nodes + herd->source[body]) + l;
}

CNI_INLINE const float *body_inertia(const cni_herd *herd, int32_t body, int32_t l)
{
	return (const float *)(const void *)((const char *)herd->nodes + herd->source[body] + CNI_SIDE_BYTES) + l;
}

/* Those that have a tree, as bits from l on. */
CNI_INLINE uint32_t lanes_from(const cni_herd *herd, int32_t l)
{
	return (1u << cni_min_i(herd->lanes - l, CNI_WIDTH)) - 1u;
}

CNI_INLINE void flock_gather(const cni_motion *motions, const cni_herd *herd, int32_t l, flock *f)
{
	int32_t k;
	for (k = 0; k < herd->bodies; ++k)
		side_gather(motions, body_index(herd, k, l), body_inertia(herd, k, l), &f->body[k]);
}

CNI_INLINE void flock_scatter(cni_motion *motions, const cni_herd *herd, int32_t l, const flock *f)
{
	uint32_t lanes = lanes_from(herd, l);
	int32_t k;
	for (k = 0; k < herd->moving; ++k)
		side_scatter(motions, body_index(herd, k, l), lanes, &f->body[k]);
}

/* ---- the matrix ---- */

CNI_INLINE float *pivot_row(const cni_herd *herd, int32_t node, int32_t l)
{
	return herd->pivots + (size_t)node * (3 * CNI_LANES) + l;
}

CNI_INLINE float *block_row(const cni_herd *herd, int32_t block, int32_t l)
{
	return herd->blocks + (size_t)block * (4 * CNI_LANES) + l;
}

/* 2 x 2, row major; a symmetric one has m01 twice. */
typedef struct matrix {
	cni_wide m00, m01, m10, m11;
} matrix;

CNI_INLINE matrix block_load(const float *p)
{
	matrix m;
	m.m00 = cni_wide_load(p);
	m.m01 = cni_wide_load(p + CNI_LANES);
	m.m10 = cni_wide_load(p + 2 * CNI_LANES);
	m.m11 = cni_wide_load(p + 3 * CNI_LANES);
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
	matrix m;
	m.m00 = cni_wide_load(p);
	m.m01 = m.m10 = cni_wide_load(p + CNI_LANES);
	m.m11 = cni_wide_load(p + 2 * CNI_LANES);
	return m;
}

CNI_INLINE void pivot_store(float *p, const matrix *m)
{
	cni_wide_store(p, m->m00);
	cni_wide_store(p + CNI_LANES, m->m10);
	cni_wide_store(p + 2 * CNI_LANES, m->m11);
}

CNI_INLINE void diagonal_form(const cni_herd *herd, int32_t node, int32_t l, const flock *f, matrix *least)
{
	const side *a = &f->body[herd->kind.end[node][0]], *b = &f->body[herd->kind.end[node][1]];
	arms r = arms_load(&herd->nodes[node], l);
	cni_wide ax = a->i * r.ax, ay = a->i * r.ay, bx = b->i * r.bx, by = b->i * r.by;
	matrix d;
	d.m00 = a->m + ay * r.ay + b->m + by * r.by;
	d.m10 = d.m01 = -(ax * r.ay) - bx * r.by;
	d.m11 = a->m + ax * r.ax + b->m + bx * r.bx;
	least->m00 = CNI_PIVOT_LEAST * d.m00;
	least->m11 = CNI_PIVOT_LEAST * d.m11;
	pivot_store(pivot_row(herd, node, l), &d);
}

/* Impulses of the low node to speeds of the high one, through the body that they share. */
CNI_INLINE void coupling_form(const cni_herd *herd, const cni_coupling *c, int32_t l, const flock *f)
{
	int32_t high = c->high - herd->node_first, low = c->low - herd->node_first;
	const cni_joint_block *p = &herd->nodes[high], *q = &herd->nodes[low];
	const side *s = &f->body[herd->kind.end[low][c->low_side]];
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
	block_store(block_row(herd, c->block - herd->block_first, l), &m);
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
	matrix m;
	m.m00 = a->m00 * b->m00 + a->m01 * b->m10;
	m.m01 = a->m00 * b->m01 + a->m01 * b->m11;
	m.m10 = a->m10 * b->m00 + a->m11 * b->m10;
	m.m11 = a->m10 * b->m01 + a->m11 * b->m11;
	return m;
}

/* target -= left * right^T */
CNI_INLINE void matrix_take(matrix *t, const matrix *a, const matrix *b)
{
	t->m00 -= a->m00 * b->m00 + a->m01 * b->m01;
	t->m01 -= a->m00 * b->m10 + a->m01 * b->m11;
	t->m10 -= a->m10 * b->m00 + a->m11 * b->m01;
	t->m11 -= a->m10 * b->m10 + a->m11 * b->m11;
}

/* Takes a node out of all that comes after it. */
CNI_INLINE void node_eliminate(const cni_herd *herd, int32_t node, int32_t l, const matrix *pivot)
{
	int32_t e, f, end = herd->first[node + 1];
	for (e = herd->first[node]; e < end; ++e) {
		int32_t to = herd->below[e] - herd->node_first, at = herd->first[to];
		matrix block = block_load(block_row(herd, e - herd->block_first, l)), scaled = matrix_times(&block, pivot);
		matrix d = pivot_load(pivot_row(herd, to, l));
		matrix_take(&d, &scaled, &block);
		pivot_store(pivot_row(herd, to, l), &d);
		for (f = e + 1; f < end; ++f) {
			matrix left = block_load(block_row(herd, f - herd->block_first, l)), t;
			while (herd->below[at] != herd->below[f])
				++at;
			t = block_load(block_row(herd, at - herd->block_first, l));
			matrix_take(&t, &left, &scaled);
			block_store(block_row(herd, at - herd->block_first, l), &t);
		}
	}
}

CNI_INLINE void system_factor(const cni_herd *herd, int32_t l, const flock *f)
{
	matrix least[CNI_KIND_NODES];
	int32_t k;
	for (k = 0; k < herd->kind.nodes; ++k)
		diagonal_form(herd, k, l, f, &least[k]);
	for (k = 0; k < herd->coupling_count; ++k)
		coupling_form(herd, &herd->couplings[k], l, f);
	for (k = 0; k < herd->kind.nodes; ++k) {
		matrix pivot = pivot_invert(pivot_row(herd, k, l), &least[k]);
		node_eliminate(herd, k, l, &pivot);
	}
}

/* ---- solution ---- */

typedef struct pair {
	cni_wide x, y;
} pair;

CNI_INLINE pair pivot_apply(const matrix *m, const pair *x)
{
	pair z;
	z.x = m->m00 * x->x + m->m01 * x->y;
	z.y = m->m10 * x->x + m->m11 * x->y;
	return z;
}

/* What the pins' speeds, and gaps at this rate, ask for. */
CNI_INLINE pair right_side(const cni_joint_block *k, int32_t l, const side *a, const side *b, float rate, float most)
{
	arms r = arms_load(k, l);
	pair x;
	x.x = -(-a->vx + r.ay * a->w + b->vx - r.by * b->w);
	x.y = -(-a->vy - r.ax * a->w + b->vy + r.bx * b->w);
	if (rate > 0.0f) {
		x.x -= cni_wide_min(cni_wide_max(rate * cni_wide_load(k->ex + l), cni_wide_of(-most)), cni_wide_of(most));
		x.y -= cni_wide_min(cni_wide_max(rate * cni_wide_load(k->ey + l), cni_wide_of(-most)), cni_wide_of(most));
	}
	return x;
}

/* From right hand sides to impulses. Returns zero in lanes where all is finite. */
CNI_INLINE cni_wide system_solve(const cni_herd *herd, int32_t l, pair *x)
{
	cni_wide finite = cni_wide_of(0.0f); /* stays so: 0 times what is finite */
	int32_t k, e;
	for (k = 0; k < herd->kind.nodes; ++k) {
		matrix pivot = pivot_load(pivot_row(herd, k, l));
		pair z = pivot_apply(&pivot, &x[k]);
		for (e = herd->first[k]; e < herd->first[k + 1]; ++e) {
			matrix m = block_load(block_row(herd, e - herd->block_first, l));
			pair *y = &x[herd->below[e] - herd->node_first];
			y->x -= m.m00 * z.x + m.m01 * z.y;
			y->y -= m.m10 * z.x + m.m11 * z.y;
		}
	}
	for (k = herd->kind.nodes - 1; k >= 0; --k) {
		matrix pivot = pivot_load(pivot_row(herd, k, l));
		for (e = herd->first[k]; e < herd->first[k + 1]; ++e) {
			matrix m = block_load(block_row(herd, e - herd->block_first, l));
			const pair *z = &x[herd->below[e] - herd->node_first];
			x[k].x -= m.m00 * z->x + m.m10 * z->y;
			x[k].y -= m.m01 * z->x + m.m11 * z->y;
		}
		x[k] = pivot_apply(&pivot, &x[k]);
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

CNI_INLINE void right_sides(const cni_herd *herd, int32_t l, const flock *f, float rate, float most, pair *x)
{
	int32_t k;
	for (k = 0; k < herd->kind.nodes; ++k)
		x[k] = right_side(&herd->nodes[k], l, &f->body[herd->kind.end[k][0]], &f->body[herd->kind.end[k][1]], rate, most);
}

/* From right hand sides x to impulses, in the lanes that are asked for, as bits from l on; those whose impulses are not finite
   get none, and are single from the next pass on. */
CNI_INLINE void pins_solve(cni_herd *herd, int32_t l, flock *f, pair *x, uint32_t asked)
{
	const cni_wide zero = cni_wide_of(0.0f);
	uint32_t direct = herd->nodes[0].direct >> l & ((1u << CNI_WIDTH) - 1u) & asked, broken;
	cni_mask good = system_solve(herd, l, x) == zero;
	int32_t k;
	broken = direct & ~cni_mask_bits(good);
	good = cni_mask_of_bits(direct & ~broken);
	for (k = 0; k < herd->kind.nodes; ++k) {
		cni_joint_block *node = &herd->nodes[k];
		arms r = arms_load(node, l);
		x[k].x = cni_wide_select(good, x[k].x, zero);
		x[k].y = cni_wide_select(good, x[k].y, zero);
		pin_push(&r, &x[k], &f->body[herd->kind.end[k][0]], &f->body[herd->kind.end[k][1]]);
		impulse_add(node->jx + l, x[k].x);
		impulse_add(node->jy + l, x[k].y);
		node->direct &= ~(broken << l);
	}
}

/* ---- passes ---- */

static void herd_begin(cni_motion *motions, cni_velocity_start *starts, cni_herd *herd, const cni_herd_pass *pass)
{
	int32_t l;
	(void)starts;
	(void)pass;
	for (l = 0; l < herd->lanes; l += CNI_WIDTH) {
		flock f;
		flock_gather(motions, herd, l, &f);
		system_factor(herd, l, &f);
	}
}

static void herd_warm(cni_motion *motions, cni_velocity_start *starts, cni_herd *herd, const cni_herd_pass *pass)
{
	float scale = pass->joint.warm_scale;
	int32_t l, n;
	(void)starts;
	for (l = 0; l < herd->lanes; l += CNI_WIDTH) {
		flock f;
		flock_gather(motions, herd, l, &f);
		for (n = 0; n < herd->kind.nodes; ++n) {
			int32_t node = herd->order[n];
			cni_joint_block *k = &herd->nodes[node];
			arms r = arms_load(k, l);
			cni_wide jx = warmed(k->jx + l, scale), jy = warmed(k->jy + l, scale), t;
			t = warmed(k->spring_j + l, scale) + warmed(k->motor_j + l, scale) + warmed(k->limit_j + l, scale);
			push(&f.body[herd->kind.end[node][0]], &f.body[herd->kind.end[node][1]], &r, jx, jy, t);
		}
		flock_scatter(motions, herd, l, &f);
	}
}

/* Are there lanes among these whose pins are single? */
CNI_INLINE int32_t has_single(const cni_herd *herd, int32_t l)
{
	uint32_t lanes = lanes_from(herd, l);
	return (herd->nodes[0].direct >> l & lanes) != lanes;
}

/* What solve_group does where motors are all there is. */
CNI_INLINE void solve_motors(cni_joint_block *k, int32_t l, side *a, side *b, const arms *r, float h, pair *dealt)
{
	const cni_wide zero = cni_wide_of(0.0f);
	pin p = pin_make(a, b, r);
	hinge g = hinge_make(a, b, r, &p);
	solve_motor(k, l, &g, h);
	dealt->x = zero + g.sx * g.t;
	dealt->y = zero + g.sy * g.t;
	push(a, b, r, dealt->x, dealt->y, g.t);
}

/* Springs, motors, limits, and single pins. */
CNI_INLINE void node_solve(cni_herd *herd, int32_t node, int32_t l, flock *f, const arms *r, const cni_joint_pass *pass, int32_t bias, int32_t single, pair *dealt)
{
	cni_joint_block *k = &herd->nodes[node];
	side *a = &f->body[herd->kind.end[node][0]], *b = &f->body[herd->kind.end[node][1]];
	if (single)
		solve_group(k, l, a, b, r, pass, bias, 1, 1, &dealt->x, &dealt->y);
	else if (k->angular == CN_JOINT_MOTOR)
		solve_motors(k, l, a, b, r, pass->h, dealt);
	else if (k->angular)
		solve_group(k, l, a, b, r, pass, bias, 1, 0, &dealt->x, &dealt->y);
	else
		dealt->x = dealt->y = cni_wide_of(0.0f);
}

/* What springs, motors and limits give the pins is kept in `dealt` until positions have moved. */
static void herd_solve(cni_motion *motions, cni_velocity_start *starts, cni_herd *herd, const cni_herd_pass *pass)
{
	int32_t l, n;
	(void)starts;
	for (l = 0; l < herd->lanes; l += CNI_WIDTH) {
		flock f;
		pair dealt, x[CNI_KIND_NODES];
		int32_t single = has_single(herd, l);
		flock_gather(motions, herd, l, &f);
		for (n = 0; n < herd->kind.nodes; ++n) {
			int32_t node = herd->order[n];
			arms r = arms_load(&herd->nodes[node], l);
			node_solve(herd, node, l, &f, &r, &pass->joint, 1, single, &dealt);
			cni_wide_store(herd->nodes[node].dealt_x + l, dealt.x);
			cni_wide_store(herd->nodes[node].dealt_y + l, dealt.y);
		}
		right_sides(herd, l, &f, pass->rate, pass->push, x);
		pins_solve(herd, l, &f, x, ~0u);
		flock_scatter(motions, herd, l, &f);
	}
}

/* ---- hard stops: direct/joint_projection.c, whose words these are ---- */

CNI_INLINE pair swerve(cni_wide rx, cni_wide ry, cni_wide turn)
{
	cni_wide s, c1;
	pair p;
	turn_series(turn, &s, &c1);
	p.x = c1 * rx - (s - turn) * ry;
	p.y = c1 * ry + (s - turn) * rx;
	return p;
}

CNI_INLINE cni_wide clamped(cni_wide x, float most)
{
	return cni_wide_min(cni_wide_max(x, cni_wide_of(-most)), cni_wide_of(most));
}

CNI_INLINE void swerve_add(const cni_joint_block *k, int32_t l, const side *a, const side *b, const cni_herd_pass *pass, pair *x)
{
	const cni_wide zero = cni_wide_of(0.0f), least = cni_wide_of(pass->turn_least);
	cni_mask turns = cni_wide_max(cni_wide_abs(a->w), cni_wide_abs(b->w)) > least;
	arms r = arms_load(k, l);
	pair of_a, of_b;
	if (cni_mask_bits(turns) == 0)
		return;
	of_a = swerve(r.ax, r.ay, pass->joint.h * a->w);
	of_b = swerve(r.bx, r.by, pass->joint.h * b->w);
	x->x -= cni_wide_select(turns, clamped((of_b.x - of_a.x) * pass->joint.inv_h, pass->push), zero);
	x->y -= cni_wide_select(turns, clamped((of_b.y - of_a.y) * pass->joint.inv_h, pass->push), zero);
}

/* Lanes whose pins lack more than the pass' parting speed, of those that may, are solved once more. */
static void herd_close(cni_motion *motions, cni_velocity_start *starts, cni_herd *herd, const cni_herd_pass *pass)
{
	const cni_wide most = cni_wide_of(pass->parting);
	int32_t l, k;
	(void)starts;
	herd->parting = 0;
	for (l = 0; l < herd->lanes; l += CNI_WIDTH) {
		uint32_t asked = herd->asked & herd->nodes[0].direct, parting = 0;
		pair x[CNI_KIND_NODES];
		flock f;
		asked = asked >> l & ((1u << CNI_WIDTH) - 1u);
		if (asked == 0)
			continue;
		flock_gather(motions, herd, l, &f);
		right_sides(herd, l, &f, pass->rate, pass->push, x);
		for (k = 0; k < herd->kind.nodes; ++k) {
			swerve_add(&herd->nodes[k], l, &f.body[herd->kind.end[k][0]], &f.body[herd->kind.end[k][1]], pass, &x[k]);
			parting |= cni_mask_bits(cni_wide_max(cni_wide_abs(x[k].x), cni_wide_abs(x[k].y)) > most);
		}
		parting &= asked;
		if (parting == 0)
			continue;
		herd->parting |= parting << l;
		pins_solve(herd, l, &f, x, parting);
		flock_scatter(motions, herd, l, &f);
	}
}

/* Where the bodies have gone, and their spin as the substep began. */
typedef struct journey {
	place at[CNI_KIND_NODES + 2];
	cni_wide vx[CNI_KIND_NODES + 2], vy[CNI_KIND_NODES + 2], w[CNI_KIND_NODES + 2], struck[CNI_KIND_NODES + 2];
} journey;

CNI_INLINE void journey_gather(const cni_motion *motions, const cni_velocity_start *starts, const cni_herd *herd, int32_t l, journey *j)
{
	int32_t k;
	for (k = 0; k < herd->bodies; ++k) {
		const int32_t *index = body_index(herd, k, l);
		j->at[k] = place_gather(motions, index);
		cni_wide_gather4((const float *)(const void *)starts, START_FLOATS, index, &j->vx[k], &j->vy[k], &j->w[k], &j->struck[k]);
	}
}

CNI_INLINE void journey_scatter(cni_velocity_start *starts, const cni_herd *herd, int32_t l, const journey *j)
{
	uint32_t lanes = lanes_from(herd, l);
	int32_t k;
	for (k = 0; k < herd->moving; ++k)
		moving_scatter((float *)(void *)starts, START_FLOATS, body_index(herd, k, l), lanes, j->vx[k], j->vy[k], j->w[k], j->struck[k]);
}

/* To the pin's impulse, with the order of sums of joints/joint_blocks.c. */
CNI_INLINE cni_wide dealt_take(float *impulse, float *dealt)
{
	cni_wide sum = cni_wide_load(impulse) + cni_wide_load(dealt);
	cni_wide_store(impulse, sum);
	cni_wide_store(dealt, cni_wide_of(0.0f));
	return sum;
}

static void herd_relax(cni_motion *motions, cni_velocity_start *starts, cni_herd *herd, const cni_herd_pass *pass)
{
	int32_t l, n;
	for (l = 0; l < herd->lanes; l += CNI_WIDTH) {
		flock f;
		journey j;
		pair x[CNI_KIND_NODES];
		int32_t single = has_single(herd, l);
		flock_gather(motions, herd, l, &f);
		journey_gather(motions, starts, herd, l, &j);
		for (n = 0; n < herd->kind.nodes; ++n) {
			int32_t node = herd->order[n], a = herd->kind.end[node][0], b = herd->kind.end[node][1];
			cni_joint_block *k = &herd->nodes[node];
			cni_wide jx = dealt_take(k->jx + l, k->dealt_x + l), jy = dealt_take(k->jy + l, k->dealt_y + l);
			arms old = arms_load(k, l), r = arms_renew(&j.at[a], &j.at[b], k, l, k->angular != 0);
			pair dealt;
			j.w[a] -= -(f.body[a].i * ((r.ax - old.ax) * jy - (r.ay - old.ay) * jx));
			j.w[b] -= f.body[b].i * ((r.bx - old.bx) * jy - (r.by - old.by) * jx);
			node_solve(herd, node, l, &f, &r, &pass->joint, 0, single, &dealt);
			impulse_add(k->jx + l, dealt.x);
			impulse_add(k->jy + l, dealt.y);
		}
		journey_scatter(starts, herd, l, &j);
		system_factor(herd, l, &f);
		right_sides(herd, l, &f, 0.0f, 0.0f, x);
		pins_solve(herd, l, &f, x, ~0u);
		flock_scatter(motions, herd, l, &f);
	}
}

const cni_herd_kernel CNI_KERNEL = { herd_begin, herd_warm, herd_solve, herd_relax, herd_close };
