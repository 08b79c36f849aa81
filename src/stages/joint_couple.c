/*
 * stages/joint_couple.c - how much the joints of a tree feel each other.
 *
 * A pass over two pins that share a body leaves at most the part
 *   trace(K1^-1 K12 K2^-1 K21)
 * of what was open before it: K of each pin, K12 what an impulse of one does to the other. Where a heavy body carries light
 * ones, as a car does its wheels, that is a third or less: the passes of a step, two a substep, then do what a system
 * would, at a fraction of its cost. Light bodies between heavy ones come close to 1, and more joints add up.
 *
 * Reads works' rows and inverse masses of a component; writes nothing.
 */
#include "stages/joint_work.h"

#define LEFT_MOST 0.5f /* part that a pass may leave */

typedef struct matrix {
	float m00, m01, m10, m11;
} matrix;

/* The two rows of a pin; those of a wide work are not written yet. */
typedef struct pin {
	cni_lever row[2];
} pin;

static pin pin_of(const cni_joint_work *w)
{
	pin p;
	if (w->flags & CNI_WORK_WIDE) {
		cni_lever x = { -1.0f, 0.0f, w->start.ra.y, 1.0f, 0.0f, -w->start.rb.y }, y = { 0.0f, -1.0f, -w->start.ra.x, 0.0f, 1.0f, w->start.rb.x };
		p.row[0] = x;
		p.row[1] = y;
	} else {
		p.row[0] = cni_row_lever(&w->rows[0]);
		p.row[1] = cni_row_lever(&w->rows[1]);
	}
	return p;
}

static float row_couple(const cni_lever *p, int32_t p_side, const cni_lever *q, int32_t q_side, const cni_motion *m)
{
	float px = p_side ? p->bx : p->ax, py = p_side ? p->by : p->ay, pw = p_side ? p->bw : p->aw;
	float qx = q_side ? q->bx : q->ax, qy = q_side ? q->by : q->ay, qw = q_side ? q->bw : q->aw;
	return m->inv_mass * (px * qx + py * qy) + m->inv_inertia * pw * qw;
}

static matrix couple(const cni_lever *p, int32_t p_side, const cni_lever *q, int32_t q_side, const cni_motion *m)
{
	matrix k;
	k.m00 = row_couple(p, p_side, q, q_side, m);
	k.m01 = row_couple(p, p_side, q + 1, q_side, m);
	k.m10 = row_couple(p + 1, p_side, q, q_side, m);
	k.m11 = row_couple(p + 1, p_side, q + 1, q_side, m);
	return k;
}

/* trace of k^-1 x l^-1 x' with symmetric k and l; 1: one of them has no inverse. */
static float trace_of(const matrix *k, const matrix *l, const matrix *x)
{
	float det = (k->m00 * k->m11 - k->m01 * k->m01) * (l->m00 * l->m11 - l->m01 * l->m01);
	float u00 = k->m11 * x->m00 - k->m01 * x->m10, u01 = k->m11 * x->m01 - k->m01 * x->m11;
	float u10 = k->m00 * x->m10 - k->m01 * x->m00, u11 = k->m00 * x->m11 - k->m01 * x->m01;
	float v00 = l->m11 * x->m00 - l->m01 * x->m01, v01 = l->m11 * x->m10 - l->m01 * x->m11;
	float v10 = l->m00 * x->m01 - l->m01 * x->m00, v11 = l->m00 * x->m11 - l->m01 * x->m10;
	return det > 0.0f ? (u00 * v00 + u01 * v10 + u10 * v01 + u11 * v11) / det : 1.0f;
}

static matrix own(const cn_world *world, const cni_node *n, const cni_lever *rows)
{
	matrix a = couple(rows, 0, rows, 0, cni_motions(world) + n->ia), b = couple(rows, 1, rows, 1, cni_motions(world) + n->ib);
	a.m00 += b.m00;
	a.m01 += b.m01;
	a.m10 += b.m10;
	a.m11 += b.m11;
	return a;
}

static float coupling_part(const cn_world *world, const cni_sparse *sparse, const cni_coupling *c)
{
	const cni_node *p = &sparse->nodes[c->low], *q = &sparse->nodes[c->high];
	const cni_motion *shared = cni_motions(world) + (c->low_side ? p->ib : p->ia);
	pin a, b;
	matrix k, l, x;
	if (p->rows != 2 || q->rows != 2)
		return 1.0f;
	a = pin_of(&cni_joint_works(world)[p->owner]);
	b = pin_of(&cni_joint_works(world)[q->owner]);
	k = own(world, p, a.row);
	l = own(world, q, b.row);
	x = couple(a.row, c->low_side, b.row, c->high_side, shared);
	return trace_of(&k, &l, &x);
}

int32_t cni_component_is_loose(const cn_world *world, const cni_sparse *sparse, const cni_component *c)
{
	float left = 0.0f;
	int32_t k;
	for (k = c->coupling_begin; k < c->coupling_end && left <= LEFT_MOST; ++k)
		left += coupling_part(world, sparse, &sparse->couplings[k]);
	return left <= LEFT_MOST;
}
