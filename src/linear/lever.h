/*
 * linear/lever.h - the state of a body that constraint rows read and write; the rows of J of a node: single ones, and three side by side.
 */
#ifndef CNI_LINEAR_LEVER_H
#define CNI_LINEAR_LEVER_H

#include "base/four.h"
#include "base/maths.h"

#define CNI_NODE_ROWS 3
#define CNI_NODE_LANES 4 /* rows, and one that is zero */

/* Colours of joint lanes: no body that can move appears twice in one. */
#define CNI_JOINT_COLORS 23

/* 32 bytes, aligned: the solver gathers and scatters these. */
typedef struct cni_motion {
	float vx, vy, w, inv_mass;
	float dpx, dpy, theta, inv_inertia; /* change of centre and angle since the step began */
} cni_motion;

static inline int32_t cni_motion_can_move(const cni_motion *m) { return m->inv_mass > 0.0f || m->inv_inertia > 0.0f; }

/* One row of J: speed = a . (va, wa) + b . (vb, wb). */
typedef struct cni_lever {
	float ax, ay, aw, bx, by, bw;
} cni_lever;

/* The rows of a node side by side. Rows beyond its own are zero. */
typedef struct cni_levers {
	float ax[CNI_NODE_LANES], ay[CNI_NODE_LANES], aw[CNI_NODE_LANES];
	float bx[CNI_NODE_LANES], by[CNI_NODE_LANES], bw[CNI_NODE_LANES];
} cni_levers;

static inline void cni_levers_set(cni_levers *l, int32_t i, cni_lever one)
{
	l->ax[i] = one.ax;
	l->ay[i] = one.ay;
	l->aw[i] = one.aw;
	l->bx[i] = one.bx;
	l->by[i] = one.by;
	l->bw[i] = one.bw;
}

static inline void cni_levers_clear(cni_levers *l, int32_t i)
{
	const cni_lever none = { 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f };
	cni_levers_set(l, i, none);
}

static inline float cni_lever_speed(const cni_lever *l, const cni_motion *a, const cni_motion *b)
{
	return l->ax * a->vx + l->ay * a->vy + l->aw * a->w + l->bx * b->vx + l->by * b->vy + l->bw * b->w;
}

/* What cannot move is not written: workers share it. */
static inline void cni_lever_push(const cni_lever *l, float impulse, cni_motion *a, cni_motion *b)
{
	float ma = a->inv_mass * impulse, mb = b->inv_mass * impulse;
	if (cni_motion_can_move(a)) {
		a->vx += ma * l->ax;
		a->vy += ma * l->ay;
		a->w += a->inv_inertia * impulse * l->aw;
	}
	if (cni_motion_can_move(b)) {
		b->vx += mb * l->bx;
		b->vy += mb * l->by;
		b->w += b->inv_inertia * impulse * l->bw;
	}
}

/* to += part * l */
static inline void cni_lever_add(cni_lever *to, float part, const cni_lever *l)
{
	to->ax += part * l->ax;
	to->ay += part * l->ay;
	to->aw += part * l->aw;
	to->bx += part * l->bx;
	to->by += part * l->by;
	to->bw += part * l->bw;
}

/* l M^-1 k^T: the element of K for two rows. */
static inline float cni_lever_mass(const cni_lever *l, const cni_lever *k, const cni_motion *a, const cni_motion *b)
{
	return a->inv_mass * (l->ax * k->ax + l->ay * k->ay) + a->inv_inertia * l->aw * k->aw +
	       b->inv_mass * (l->bx * k->bx + l->by * k->by) + b->inv_inertia * l->bw * k->bw;
}

/* cni_lever_speed of all rows. */
CNI_INLINE cni_four cni_levers_speed(const cni_levers *l, const cni_motion *a, const cni_motion *b)
{
	cni_four sum = cni_four_scale(cni_four_load(l->ax), a->vx);
	sum = cni_four_add(sum, cni_four_scale(cni_four_load(l->ay), a->vy));
	sum = cni_four_add(sum, cni_four_scale(cni_four_load(l->aw), a->w));
	sum = cni_four_add(sum, cni_four_scale(cni_four_load(l->bx), b->vx));
	sum = cni_four_add(sum, cni_four_scale(cni_four_load(l->by), b->vy));
	return cni_four_add(sum, cni_four_scale(cni_four_load(l->bw), b->w));
}

/* What each row's impulse changes in the velocity of a body at these lever ends; the last lanes are zero. */
typedef struct cni_changes {
	cni_four row[CNI_NODE_ROWS];
} cni_changes;

CNI_INLINE cni_changes cni_lever_ends_changes(const float *x, const float *y, const float *w, cni_four impulses, const cni_motion *m)
{
	cni_four by_mass = cni_four_scale(impulses, m->inv_mass);
	cni_changes c = { { cni_four_times(by_mass, cni_four_load(x)), cni_four_times(by_mass, cni_four_load(y)),
		cni_four_times(cni_four_scale(impulses, m->inv_inertia), cni_four_load(w)) } };
	cni_four_columns(&c.row[0], &c.row[1], &c.row[2]);
	return c;
}

/* Adds the changes, times `part`, of the first 2 or all rows to a body's velocity (&m->vx) or pose (&m->dpx). */
CNI_INLINE void cni_changes_add(const cni_changes *c, float part, float *to, int32_t rows)
{
	cni_four sum = cni_four_add(cni_four_add(cni_four_load(to), cni_four_scale(c->row[0], part)), cni_four_scale(c->row[1], part));
	cni_four_store(to, rows > 2 ? cni_four_add(sum, cni_four_scale(c->row[2], part)) : sum);
}

/* cni_lever_push of the first 2 or all rows to two different bodies; x has CNI_NODE_LANES numbers, the last zero. */
CNI_INLINE void cni_levers_push(const cni_levers *l, const float *x, cni_motion *a, cni_motion *b, int32_t rows)
{
	cni_four impulses = cni_four_load(x);
	const cni_changes of_a = cni_lever_ends_changes(l->ax, l->ay, l->aw, impulses, a), of_b = cni_lever_ends_changes(l->bx, l->by, l->bw, impulses, b);
	if (cni_motion_can_move(a))
		cni_changes_add(&of_a, 1.0f, &a->vx, rows); /* inv_mass stays */
	if (cni_motion_can_move(b))
		cni_changes_add(&of_b, 1.0f, &b->vx, rows);
}

#endif
