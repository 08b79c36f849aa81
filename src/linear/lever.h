/*
 * linear/lever.h - the rows of J of a node: single ones, and three side by side.
 */
#ifndef CNI_LINEAR_LEVER_H
#define CNI_LINEAR_LEVER_H

#include "base/four.h"
#include "linear/motion.h"

#define CNI_NODE_ROWS 3
#define CNI_NODE_LANES 4 /* rows, and one that is zero */

/* One row of J: speed = a . (va, wa) + b . (vb, wb). */
typedef struct cni_lever {
	float ax, ay, aw, bx, by, bw;
} cni_lever;

/* The rows of a node side by side. Rows beyond its own are zero. */
typedef struct cni_levers {
	float ax[CNI_NODE_LANES], ay[CNI_NODE_LANES], aw[CNI_NODE_LANES];
	float bx[CNI_NODE_LANES], by[CNI_NODE_LANES], bw[CNI_NODE_LANES];
} cni_levers;

static inline cni_lever cni_levers_row(const cni_levers *l, int32_t row)
{
	cni_lever one = { l->ax[row], l->ay[row], l->aw[row], l->bx[row], l->by[row], l->bw[row] };
	return one;
}

static inline void cni_levers_set(cni_levers *l, int32_t row, cni_lever one)
{
	l->ax[row] = one.ax;
	l->ay[row] = one.ay;
	l->aw[row] = one.aw;
	l->bx[row] = one.bx;
	l->by[row] = one.by;
	l->bw[row] = one.bw;
}

static inline void cni_levers_clear(cni_levers *l, int32_t row)
{
	const cni_lever none = { 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f };
	cni_levers_set(l, row, none);
}

static inline float cni_lever_speed(const cni_lever *l, const cni_motion *a, const cni_motion *b)
{
	return l->ax * a->vx + l->ay * a->vy + l->aw * a->w + l->bx * b->vx + l->by * b->vy + l->bw * b->w;
}

/* Inverse effective mass of a row: the speed change per unit impulse. */
static inline float cni_lever_inverse_mass(const cni_lever *l, const cni_motion *a, const cni_motion *b)
{
	return a->inv_mass * (l->ax * l->ax + l->ay * l->ay) + a->inv_inertia * l->aw * l->aw +
	       b->inv_mass * (l->bx * l->bx + l->by * l->by) + b->inv_inertia * l->bw * l->bw;
}

static inline void cni_lever_push(const cni_lever *l, float impulse, cni_motion *a, cni_motion *b)
{
	float ma = a->inv_mass * impulse, mb = b->inv_mass * impulse;
	a->vx += ma * l->ax;
	a->vy += ma * l->ay;
	a->w += a->inv_inertia * impulse * l->aw;
	b->vx += mb * l->bx;
	b->vy += mb * l->by;
	b->w += b->inv_inertia * impulse * l->bw;
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

/* Pushes a body at these lever ends. */
CNI_INLINE void cni_lever_ends_push(const float *x, const float *y, const float *w, cni_four impulses, cni_motion *m, int32_t rows)
{
	cni_four by_mass = cni_four_scale(impulses, m->inv_mass), before = cni_four_load(&m->vx), after, last;
	cni_four vx = cni_four_times(by_mass, cni_four_load(x)), vy = cni_four_times(by_mass, cni_four_load(y));
	cni_four turn = cni_four_times(cni_four_scale(impulses, m->inv_inertia), cni_four_load(w));
	cni_four_columns(&vx, &vy, &turn);
	after = cni_four_add(cni_four_add(before, vx), vy);
	after = rows > 2 ? cni_four_add(after, turn) : after;
	last = CNI_FOUR_PICK(after, before, 2, 2, 7, 7);
	cni_four_store(&m->vx, CNI_FOUR_PICK(after, last, 0, 1, 4, 6)); /* inv_mass stays */
}

/* cni_lever_push of the first 2 or all rows; x has CNI_NODE_LANES numbers. */
CNI_INLINE void cni_levers_push(const cni_levers *l, const float *x, cni_motion *a, cni_motion *b, int32_t rows)
{
	cni_four impulses = cni_four_load(x);
	cni_lever_ends_push(l->ax, l->ay, l->aw, impulses, a, rows);
	cni_lever_ends_push(l->bx, l->by, l->bw, impulses, b, rows);
}

#endif
