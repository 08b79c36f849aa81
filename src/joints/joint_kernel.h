/*
 * joints/joint_kernel.h - the joint kernel of one instruction set: included by the kernels that use it, which define CNI_WIDTH and
 * CNI_KERNEL (the name of the table they fill). Results do not depend on the width.
 *
 * This file has the formulas of joints. joint_passes_kernel.h has their passes, direct/batched_trees_kernel.h batches of trees of pins.
 *
 * With the letters of joints/joint_pass.h, the pin's velocity is
 *   v = (vb + wb x rb) - (va + wa x ra)         K = sum of m + I^-1 terms, det K without cancellation:
 *   det = M (M + ia ra^2 + ib rb^2) + ia ib (ra x rb)^2,   M = ma + mb
 * A torque impulse t between the bodies is combined with the impulse s t at the pin, s = -K^-1 k, so that it does not change v. It then has
 * the true effective mass 1 / k_s, and the pin is solved at the same time.
 *
 * A distance has one velocity, along its axis; springs, motors, limits and held lanes act on it as on a pin's decoupled rotation.
 *
 * Arms and axes turn once a substep, in the relax pass. Impulses already applied acted along the old ones: the resulting difference of the
 * bodies' velocities goes into start, which adds it to the next warm start.
 *
 * Reads motion and block rows; writes motion velocities, start, and arms, errors and impulses of the block.
 */
#include "base/wide.h"
#include "joints/joint_pass.h"

#define MOTION_FLOATS ((int32_t)(sizeof(cni_motion) / sizeof(float)))
#define START_FLOATS ((int32_t)(sizeof(cni_velocity_start) / sizeof(float)))

/* The bodies on one side of CNI_WIDTH lanes. */
typedef struct side {
	cni_wide vx, vy, w, m, i;
} side;

CNI_INLINE void side_gather(const cni_motion *motions, const int32_t *index, const float *inertia, side *out)
{
	cni_wide_gather4((const float *)(const void *)motions, MOTION_FLOATS, index, &out->vx, &out->vy, &out->w, &out->m);
	out->i = cni_wide_load(inertia);
}

/* Scatters records of four floats to the lanes that move, as bits. An immovable body may be in many lanes of a colour at once: writing it,
   even unchanged, would race with other workers. */
CNI_INLINE void moving_scatter(float *base, int32_t stride, const int32_t *index, uint32_t moves, cni_wide a, cni_wide b, cni_wide c, cni_wide d)
{
	const uint32_t all = (1u << CNI_WIDTH) - 1u;
	if ((moves & all) == all)
		cni_wide_scatter4(base, stride, index, a, b, c, d);
	else
		cni_wide_scatter4_where(base, stride, index, moves, a, b, c, d);
}

CNI_INLINE void side_scatter(cni_motion *motions, const int32_t *index, uint32_t moves, const side *a)
{
	moving_scatter((float *)(void *)motions, MOTION_FLOATS, index, moves, a->vx, a->vy, a->w, a->m);
}

typedef struct arms {
	cni_wide ax, ay, bx, by;
} arms;

CNI_INLINE arms arms_load(const cni_joint_block *k, int32_t l)
{
	arms r = { cni_wide_load(k->ax + l), cni_wide_load(k->ay + l), cni_wide_load(k->bx + l), cni_wide_load(k->by + l) };
	return r;
}

/* Applies impulse q at the pin and torque impulse t between the bodies, both as they act on body b. */
CNI_INLINE void push(side *a, side *b, const arms *r, cni_wide qx, cni_wide qy, cni_wide t)
{
	a->vx -= a->m * qx;
	a->vy -= a->m * qy;
	a->w -= a->i * (r->ax * qy - r->ay * qx + t);
	b->vx += b->m * qx;
	b->vy += b->m * qy;
	b->w += b->i * (r->bx * qy - r->by * qx + t);
}

/* The pin's effective mass and velocity. */
typedef struct pin {
	cni_wide m;             /* M */
	cni_wide vx, vy;
	cni_wide i00, i01, i11; /* K^-1; 0 where nothing moves */
} pin;

CNI_INLINE pin pin_make(const side *a, const side *b, const arms *r)
{
	const cni_wide zero = cni_wide_of(0.0f);
	cni_wide across = r->ax * r->by - r->ay * r->bx, aa = r->ax * r->ax + r->ay * r->ay, bb = r->bx * r->bx + r->by * r->by, det, d;
	pin p;
	p.m = a->m + b->m;
	p.vx = (b->vx - b->w * r->by) - (a->vx - a->w * r->ay);
	p.vy = (b->vy + b->w * r->bx) - (a->vy + a->w * r->ax);
	det = p.m * (p.m + a->i * aa + b->i * bb) + a->i * b->i * (across * across);
	d = cni_wide_select(det > zero, 1.0f / det, zero);
	p.i00 = (p.m + a->i * (r->ax * r->ax) + b->i * (r->bx * r->bx)) * d;
	p.i01 = (a->i * (r->ax * r->ay) + b->i * (r->bx * r->by)) * d;
	p.i11 = (p.m + a->i * (r->ay * r->ay) + b->i * (r->by * r->by)) * d;
	return p;
}

/* What springs, motors and limits act on: rotation of b relative to a, decoupled from the pin, or motion along a distance's axis. */
typedef struct hinge {
	cni_wide sx, sy; /* s; the axis */
	cni_wide k;      /* k_s */
	cni_wide mass;
	cni_wide w;      /* speed, updated with every impulse */
	cni_wide t;      /* sum of impulses in this pass */
} hinge;

CNI_INLINE hinge hinge_make(const side *a, const side *b, const arms *r, const pin *p)
{
	const cni_wide zero = cni_wide_of(0.0f);
	cni_wide kx = a->i * r->ay + b->i * r->by, ky = a->i * r->ax + b->i * r->bx, aw, bw;
	hinge g;
	g.sx = p->i00 * kx - p->i01 * ky;
	g.sy = p->i01 * kx - p->i11 * ky;
	aw = 1.0f + r->ax * g.sy - r->ay * g.sx;
	bw = 1.0f + r->bx * g.sy - r->by * g.sx;
	g.k = p->m * (g.sx * g.sx + g.sy * g.sy) + a->i * (aw * aw) + b->i * (bw * bw);
	g.mass = cni_wide_select(g.k > zero, 1.0f / g.k, zero);
	g.w = (b->w - a->w) + g.sx * p->vx + g.sy * p->vy;
	g.t = zero;
	return g;
}

/* The axis is in e. */
CNI_INLINE hinge axis_make(const cni_joint_block *k, int32_t l, const side *a, const side *b, const arms *r)
{
	const cni_wide zero = cni_wide_of(0.0f);
	hinge g;
	g.sx = cni_wide_load(k->ex + l);
	g.sy = cni_wide_load(k->ey + l);
	cni_wide aw = r->ax * g.sy - r->ay * g.sx;
	cni_wide bw = r->bx * g.sy - r->by * g.sx;
	g.k = a->m + b->m + a->i * (aw * aw) + b->i * (bw * bw);
	g.mass = cni_wide_select(g.k > zero, 1.0f / g.k, zero);
	g.w = g.sx * (b->vx - a->vx) + g.sy * (b->vy - a->vy) + (bw * b->w - aw * a->w);
	g.t = zero;
	return g;
}

CNI_INLINE void hinge_turn(hinge *g, cni_wide dj)
{
	g->w += g->k * dj;
	g->t += dj;
}

/* gap: the pin's share of a decoupled error, for held lanes. */
CNI_INLINE void solve_spring(cni_joint_block *k, int32_t l, hinge *g, cni_wide gap)
{
	cni_wide old = cni_wide_load(k->spring_j + l), error = cni_wide_load(k->measure + l) - cni_wide_load(k->rest + l) + gap;
	cni_wide want = cni_wide_load(k->spring_mass + l) * g->w + cni_wide_load(k->spring_bias + l) * error;
	cni_wide dj = -(g->mass * want) - cni_wide_load(k->spring_impulse_scale + l) * old;
	cni_wide_store(k->spring_j + l, old + dj);
	hinge_turn(g, dj);
}

/* cni_motor_target */
CNI_INLINE cni_wide motor_target(cni_wide speed, cni_wide below, cni_wide above, const cni_joint_pass *pass, int32_t bias)
{
	const cni_wide zero = cni_wide_of(0.0f), inside = cni_wide_of(pass->inv_h), outside = cni_wide_of(cni_soft_error_rate(&pass->soft, bias));
	cni_wide least = below * cni_wide_select(below > zero, inside, outside), most = above * cni_wide_select(above > zero, inside, outside);
	return cni_wide_min(cni_wide_max(speed, -least), most);
}

CNI_INLINE void solve_motor(cni_joint_block *k, int32_t l, hinge *g, const cni_joint_pass *pass, int32_t bias)
{
	cni_wide old = cni_wide_load(k->motor_j + l), most = cni_wide_load(k->most + l) * pass->h, angle = cni_wide_load(k->measure + l);
	cni_wide target = motor_target(cni_wide_load(k->speed + l), angle - cni_wide_load(k->lower + l), cni_wide_load(k->upper + l) - angle, pass, bias);
	cni_wide impulse = cni_wide_min(cni_wide_max(old - g->mass * (g->w - target), -most), most);
	cni_wide_store(k->motor_j + l, impulse);
	hinge_turn(g, impulse - old);
}

/* One end of the limits, whose impulse is >= 0. A remaining gap bounds the speed (speculative); beyond the limit the row is soft. */
CNI_INLINE cni_wide limit_impulse(cni_wide old, cni_wide room, cni_wide speed, cni_wide mass, const cni_joint_pass *pass, int32_t bias)
{
	const cni_wide zero = cni_wide_of(0.0f), one = cni_wide_of(1.0f);
	cni_mask open = room > zero;
	cni_wide scale = bias ? cni_wide_select(open, one, cni_wide_of(pass->soft.mass_scale)) : one;
	cni_wide keep = bias ? cni_wide_select(open, one, cni_wide_of(1.0f - pass->soft.impulse_scale)) : one;
	cni_wide rest = cni_wide_select(open, room * pass->inv_h, bias ? room * pass->soft.bias_scale : zero);
	return cni_wide_max(keep * old - mass * (scale * speed + rest), zero);
}

CNI_INLINE void solve_limits(cni_joint_block *k, int32_t l, hinge *g, const cni_joint_pass *pass, int32_t bias)
{
	const cni_wide zero = cni_wide_of(0.0f);
	cni_wide old = cni_wide_load(k->limit_j + l), angle = cni_wide_load(k->measure + l);
	cni_wide old_lower = cni_wide_max(old, zero), old_upper = cni_wide_max(-old, zero), lower, upper;
	lower = limit_impulse(old_lower, angle - cni_wide_load(k->lower + l), g->w, g->mass, pass, bias);
	hinge_turn(g, lower - old_lower);
	upper = limit_impulse(old_upper, cni_wide_load(k->upper + l) - angle, -g->w, g->mass, pass, bias);
	hinge_turn(g, old_upper - upper);
	cni_wide_store(k->limit_j + l, lower - upper);
}

/* Sum of the impulses of spring, motor and limit. */
CNI_INLINE cni_wide measure_impulse(const cni_joint_block *k, int32_t l)
{
	return cni_wide_load(k->spring_j + l) + cni_wide_load(k->motor_j + l) + cni_wide_load(k->limit_j + l);
}

/* Held lanes in a pass without bias. */
CNI_INLINE void solve_held(cni_joint_block *k, int32_t l, hinge *g)
{
	cni_wide dj = cni_wide_select(cni_mask_of_bits(k->held >> l), -(g->mass * g->w), cni_wide_of(0.0f));
	cni_wide_store(k->spring_j + l, cni_wide_load(k->spring_j + l) + dj);
	hinge_turn(g, dj);
}

CNI_INLINE void solve_parts(cni_joint_block *k, int32_t l, hinge *g, cni_wide gap, const cni_joint_pass *pass, int32_t bias)
{
	if (bias && (k->parts & CN_JOINT_SPRING))
		solve_spring(k, l, g, gap);
	if (!bias && k->held != 0)
		solve_held(k, l, g);
	if (k->parts & CN_JOINT_MOTOR)
		solve_motor(k, l, g, pass, bias);
	if (k->parts & CN_JOINT_LIMIT)
		solve_limits(k, l, g, pass, bias);
}

CNI_INLINE void solve_distance(cni_joint_block *k, int32_t l, side *a, side *b, const arms *r, const cni_joint_pass *pass, int32_t bias)
{
	hinge g = axis_make(k, l, a, b, r);
	solve_parts(k, l, &g, cni_wide_of(0.0f), pass, bias);
	push(a, b, r, g.sx * g.t, g.sy * g.t, cni_wide_of(0.0f));
}

/* Solves one vector of pins: velocities and angular impulses, with arms and errors as they are. Returns the changes of the pins' impulses in
   *dx and *dy. direct: lanes, as bits from l on, whose pins are solved as a system. */
CNI_INLINE void solve_group(cni_joint_block *k, int32_t l, side *a, side *b, const arms *r, const cni_joint_pass *pass, int32_t bias, int32_t angular, uint32_t direct, cni_wide *dx, cni_wide *dy)
{
	const cni_wide zero = cni_wide_of(0.0f);
	const int32_t pins = direct != ~0u;
	cni_wide around_x = zero, around_y = zero, gap = zero, x, y, qx = zero, qy = zero, t = zero;
	pin p = pin_make(a, b, r);
	hinge g;
	if (angular) {
		g = hinge_make(a, b, r, &p);
		if (bias && pins) {
			cni_wide torque = measure_impulse(k, l);
			around_x = g.sx * torque;
			around_y = g.sy * torque;
		}
		if (bias && k->held != 0)
			gap = cni_wide_select(cni_mask_of_bits(k->held >> l), g.sx * cni_wide_load(k->ex + l) + g.sy * cni_wide_load(k->ey + l), zero);
		solve_parts(k, l, &g, gap, pass, bias);
		t = g.t;
	}
	if (pins) {
		if (bias) {
			x = pass->soft.mass_scale * p.vx + pass->soft.bias_scale * cni_wide_load(k->ex + l);
			y = pass->soft.mass_scale * p.vy + pass->soft.bias_scale * cni_wide_load(k->ey + l);
			qx = -(p.i00 * x + p.i01 * y) - pass->soft.impulse_scale * (cni_wide_load(k->jx + l) - around_x);
			qy = -(p.i01 * x + p.i11 * y) - pass->soft.impulse_scale * (cni_wide_load(k->jy + l) - around_y);
		} else {
			qx = -(p.i00 * p.vx + p.i01 * p.vy);
			qy = -(p.i01 * p.vx + p.i11 * p.vy);
		}
		if (direct != 0) {
			qx = cni_wide_select(cni_mask_of_bits(direct), zero, qx);
			qy = cni_wide_select(cni_mask_of_bits(direct), zero, qy);
		}
	}
	if (angular) {
		qx += g.sx * t;
		qy += g.sy * t;
	}
	push(a, b, r, qx, qy, t);
	*dx = qx;
	*dy = qy;
}

CNI_INLINE void impulse_add(float *impulse, cni_wide change)
{
	cni_wide_store(impulse, cni_wide_load(impulse) + change);
}

/* ---- new positions ---- */

/* Displacement of one side's bodies since the step began. */
typedef struct place {
	cni_wide x, y, theta;
	cni_wide s, c1; /* sin and cos - 1 of theta */
} place;

/* Series for half of the angle (to degrees 7 and 6), then doubled: right to 1e-7 up to a radian, to 1e-4 up to two. Joints of faster bodies
   are not in lanes. */
CNI_INLINE void turn_series(cni_wide theta, cni_wide *out_s, cni_wide *out_c1)
{
	cni_wide half = cni_wide_min(cni_wide_max(theta * 0.5f, cni_wide_of(-1.5f)), cni_wide_of(1.5f)), u = half * half, s, c1;
	s = half * (1.0f - u * (1.0f / 6.0f - u * (1.0f / 120.0f - u * (1.0f / 5040.0f))));
	c1 = -u * (0.5f - u * (1.0f / 24.0f - u * (1.0f / 720.0f)));
	*out_s = 2.0f * (s + s * c1);
	*out_c1 = -2.0f * (s * s);
}

CNI_INLINE place place_gather(const cni_motion *motions, const int32_t *index)
{
	cni_wide inertia;
	place p;
	cni_wide_gather4((const float *)(const void *)motions + 4, MOTION_FLOATS, index, &p.x, &p.y, &p.theta, &inertia);
	turn_series(p.theta, &p.s, &p.c1);
	return p;
}

/* Computes the new arms, and the gaps of points and angles at the new positions. */
CNI_INLINE arms arms_renew(const place *at_a, const place *at_b, cni_joint_block *k, int32_t l, int32_t angular)
{
	const place a = *at_a, b = *at_b;
	cni_wide ax0 = cni_wide_load(k->ax0 + l), ay0 = cni_wide_load(k->ay0 + l), bx0 = cni_wide_load(k->bx0 + l), by0 = cni_wide_load(k->by0 + l);
	cni_wide ax = a.c1 * ax0 - a.s * ay0, ay = a.c1 * ay0 + a.s * ax0, bx = b.c1 * bx0 - b.s * by0, by = b.c1 * by0 + b.s * bx0;
	arms r = { ax0 + ax, ay0 + ay, bx0 + bx, by0 + by };
	cni_wide_store(k->ex + l, cni_wide_load(k->dx0 + l) + ((b.x - a.x) + (bx - ax)));
	cni_wide_store(k->ey + l, cni_wide_load(k->dy0 + l) + ((b.y - a.y) + (by - ay)));
	if (angular)
		cni_wide_store(k->measure + l, cni_wide_load(k->angle0 + l) + (b.theta - a.theta));
	cni_wide_store(k->ax + l, r.ax);
	cni_wide_store(k->ay + l, r.ay);
	cni_wide_store(k->bx + l, r.bx);
	cni_wide_store(k->by + l, r.by);
	return r;
}

/* Subtracts these changes of velocities from the bodies' start. */
CNI_INLINE void start_change(cni_velocity_start *starts, const int32_t *index, uint32_t moves, cni_wide x, cni_wide y, cni_wide spin)
{
	cni_wide vx, vy, w, jumped;
	cni_wide_gather4((const float *)(const void *)starts, START_FLOATS, index, &vx, &vy, &w, &jumped);
	moving_scatter((float *)(void *)starts, START_FLOATS, index, moves, vx - x, vy - y, w - spin, jumped);
}

CNI_INLINE cni_wide impulse_warm(float *impulse, float scale)
{
	cni_wide j = cni_wide_load(impulse) * scale;
	cni_wide_store(impulse, j);
	return j;
}

CNI_INLINE cni_wide measure_warm(cni_joint_block *k, int32_t l, float scale)
{
	return impulse_warm(k->spring_j + l, scale) + impulse_warm(k->motor_j + l, scale) + impulse_warm(k->limit_j + l, scale);
}
