/*
 * contacts/contact_kernel.h - the contact kernel of one instruction set, included by contact_kernel_*.c, which define CNI_WIDTH
 * and CNI_KERNEL (the name of the kernel table). Results do not depend on the width. The setup of a pass costs time per call, so
 * one call processes as many blocks as it can.
 *
 * With the letters of model/contact.h and body changes dp, th since the step began, a point's separation is
 *   s = s0 + n.(dpb - dpa) + [(cos thb - 1) bn + sin thb bt] - [(cos tha - 1) an + sin tha at]
 * its speed vn = n.(vb - va) + wb bt - wa at, and the friction speed vt = t.(vb - va) - wb fb + wa fa.
 *
 * A soft constraint subtracts a part of its impulse. This damps the contact, but a stack under its weight would sink into
 * itself. So the pass subtracts a part of impulse - load, where load is the slow mean of the contact's impulse: a body at rest
 * keeps no overlap whatever it carries, and sudden impulses stay soft. The mean must be slower than impulses travel through the
 * largest pile; see CNI_LOAD_RATE in model/solve.h. Of a load that exceeds the impulse only the impulse counts, so that no contact pulls. The
 * load itself falls as slowly as it rises: one that fell at once, where a swaying tower rests on its other edge, would be missing when
 * the tower swings back, and drive its sway. Between settled bodies the load does not rise: rising loads would press wedged bodies ever harder,
 * until one slips.
 *
 * Contacts harden with depth, as the loads of a moving crowd change faster than a mean can follow; see step/solve_make.c.
 *
 * Reads motion, start and block rows; writes motion velocities and block.jn, jt, load.
 */
#include "base/wide.h"
#include "contacts/contact_pass.h"

#define MOTION_FLOATS ((int32_t)(sizeof(cni_motion) / sizeof(float)))

/* The bodies on one side of CNI_WIDTH lanes. */
typedef struct side {
	cni_wide vx, vy, w, m, i;
	cni_wide mx, my;      /* inverse mass along x and y: m but for locked axes */
	cni_wide x, y, s, c1; /* change of centre; sin and cos - 1 of the change of angle */
} side;

/* Clamps the turn to the range of the series: a contact's geometry does not last that far. A speed of -0 becomes 0, so that a zero
   impulse leaves it unchanged. */
CNI_INLINE void side_gather(const cni_motion *motions, const int32_t *index, side *out)
{
	const float *base = (const float *)(const void *)motions;
	const cni_wide zero = cni_wide_of(0.0f);
	cni_wide t, t2;
	cni_wide_gather4(base, MOTION_FLOATS, index, &out->vx, &out->vy, &out->w, &out->m);
	out->vx += zero;
	out->vy += zero;
	out->w += zero;
	cni_wide_gather4(base + 4, MOTION_FLOATS, index, &out->x, &out->y, &t, &out->i);
	t = cni_wide_min(cni_wide_max(t, cni_wide_of(-1.25f)), cni_wide_of(1.25f));
	t2 = t * t;
	out->s = t * (1.0f - t2 * (1.0f / 6.0f - t2 * (1.0f / 120.0f)));
	out->c1 = -t2 * (0.5f - t2 * (1.0f / 24.0f));
	out->mx = out->my = out->m;
}

CNI_INLINE void side_scatter(cni_motion *motions, const int32_t *index, const side *a)
{
	cni_wide_scatter4((float *)(void *)motions, MOTION_FLOATS, index, a->vx, a->vy, a->w, a->m);
}

CNI_INLINE void sides_lock(const cni_block_extra *extra, int32_t l, side *a, side *b)
{
	a->mx = a->m * (1.0f - cni_wide_load(extra->lock_ax + l));
	a->my = a->m * (1.0f - cni_wide_load(extra->lock_ay + l));
	b->mx = b->m * (1.0f - cni_wide_load(extra->lock_bx + l));
	b->my = b->m * (1.0f - cni_wide_load(extra->lock_by + l));
}

/* Restores the velocities of lanes that are not live. */
CNI_INLINE void side_keep(side *a, const side *old, cni_mask live)
{
	a->vx = cni_wide_select(live, a->vx, old->vx);
	a->vy = cni_wide_select(live, a->vy, old->vy);
	a->w = cni_wide_select(live, a->w, old->w);
}

/* One contact point of every lane, prepared for the solve of both points. */
typedef struct point {
	cni_wide at, bt;
	cni_wide m;      /* mass_scale / (n K n); 0: inactive */
	cni_wide target; /* its impulse if the other point kept its own */
	cni_wide old;
} point;

/* Separation of a point at the current poses. */
CNI_INLINE cni_wide point_separation(const cni_contact_block *k, const cni_contact_row *p, int32_t l, const side *a, const side *b)
{
	cni_wide nx = cni_wide_load(k->nx + l), ny = cni_wide_load(k->ny + l);
	cni_wide an = cni_wide_load(p->an + l), bn = an - cni_wide_load(k->dn + l), at = cni_wide_load(p->at + l), bt = at - cni_wide_load(k->dt + l);
	return cni_wide_load(p->s0 + l) + nx * (b->x - a->x) + ny * (b->y - a->y) + (b->c1 * bn + b->s * bt) - (a->c1 * an + a->s * at);
}

/* 0 to 1: how far the point hardens. Contacts of a crushed crowd stay soft: the stiffer they are, the faster it bursts apart. m: the larger
   inverse mass. */
CNI_INLINE cni_wide hardness(const cni_contact_pass *pass, cni_wide s, cni_wide jn, cni_wide m)
{
	cni_wide deep = cni_wide_min(cni_wide_max(pass->deep_from - pass->deep_rate * s, cni_wide_of(0.0f)), cni_wide_of(1.0f));
	cni_wide crush = pass->crush_rate * jn * m;
	return deep / (1.0f + crush * crush);
}

/* bias: 1 the soft pass, 0 the rigid relax pass. bounces: restitution of the block's lanes, NULL: none is above
   CNI_BOUNCE_DELAY_RESTITUTION. */
CNI_INLINE point point_prepare(const cni_contact_block *k, const cni_contact_row *p, int32_t l, const side *a, const side *b, const cni_contact_pass *pass, int32_t bias, const float *bounces)
{
	point q;
	cni_wide nx = cni_wide_load(k->nx + l), ny = cni_wide_load(k->ny + l), nm = cni_wide_load(p->nm + l), s = point_separation(k, p, l, a, b);
	cni_wide vn, deep, mass_scale, bias_scale, soft_push, push, scale, part;
	const cni_wide zero = cni_wide_of(0.0f), one = cni_wide_of(1.0f);
	q.at = cni_wide_load(p->at + l);
	q.bt = q.at - cni_wide_load(k->dt + l);
	q.old = cni_wide_load(p->jn + l);
	vn = nx * (b->vx - a->vx) + ny * (b->vy - a->vy) + b->w * q.bt - a->w * q.at;
	deep = bias ? hardness(pass, s, q.old, cni_wide_max(a->m, b->m)) : zero;
	mass_scale = pass->soft.mass_scale + (pass->deep.mass_scale - pass->soft.mass_scale) * deep;
	bias_scale = pass->soft.bias_scale + (pass->deep.bias_scale - pass->soft.bias_scale) * deep;
	soft_push = bias ? cni_wide_max(bias_scale * s, -pass->push_speed * mass_scale) : zero;
	push = cni_wide_select(s > zero, s * pass->inv_h, soft_push);
	scale = bias ? cni_wide_select(s > zero, one, mass_scale) : one;
	q.m = scale * nm;
	q.target = scale * q.old - nm * (scale * vn + push);
	if (bias && CNI_ON(COMPLIANCE_OFFSETS))
		q.target += (1.0f - scale) * cni_wide_min(cni_wide_load(p->load + l), q.old);
	if (!bias || bounces != NULL) {
		/* Impacts belong to restitution.c. If its sweeps find that bodies do not meet in this substep, they meet in the next, and
		   braking would take the speed that the impact there should return. At low restitution only the relax pass skips the contact,
		   and only while the bodies are apart: the next substep reaches the surface. A contact that overlaps by more than it closes in
		   CNI_BOUNCE_MISSED_SUBSTEPS substeps is braked: another constraint of its bodies, such as a joint, undoes its impacts. */
		cni_mask left = (vn < cni_wide_of(pass->impact_speed)) & (q.old <= zero), apart = s > zero;
		if (bounces != NULL && bias)
			left &= (cni_wide_load_loose(bounces + l) > cni_wide_of(CNI_BOUNCE_DELAY_RESTITUTION)) &
				(s * pass->inv_h > CNI_BOUNCE_MISSED_SUBSTEPS * vn);
		else if (bounces != NULL)
			left &= apart | (cni_wide_load_loose(bounces + l) > cni_wide_of(CNI_BOUNCE_DELAY_RESTITUTION));
		else
			left &= apart;
		part = cni_wide_select(left, zero, one);
		q.m = part * q.m;
		q.target = part * q.target + zero; /* not -0 */
	}
	return q;
}

CNI_INLINE void apply_normal(side *a, side *b, cni_wide nx, cni_wide ny, const point *q, cni_wide impulse)
{
	cni_wide dj = impulse - q->old;
	a->vx -= a->mx * dj * nx;
	a->vy -= a->my * dj * ny;
	a->w -= a->i * q->at * dj;
	b->vx += b->mx * dj * nx;
	b->vy += b->my * dj * ny;
	b->w += b->i * q->bt * dj;
}

/* Returns 1 if no lane of the group has a second point. Rows of missing points are zero, and so are their impulses. */
CNI_INLINE int32_t has_one_point(const cni_contact_block *k, int32_t l)
{
	return cni_mask_bits(cni_wide_load(k->p[1].nm + l) != cni_wide_of(0.0f)) == 0;
}

/* The points of every lane: both, or only the first if no lane has a second. */
typedef struct normals {
	point p, q;
	cni_wide jp, jq;
} normals;

CNI_INLINE void normals_prepare(normals *out, const cni_contact_block *k, int32_t l, const side *a, const side *b, const cni_contact_pass *pass, int32_t bias, const float *bounces, int32_t points)
{
	out->p = point_prepare(k, &k->p[0], l, a, b, pass, bias, bounces);
	if (points == 2)
		out->q = point_prepare(k, &k->p[1], l, a, b, pass, bias, bounces);
}

/*
 * Solves the normal impulses of both points together: the 2 x 2 complementarity problem A j >= r, j >= 0, where A has 1/m on its
 * diagonal and k12 beside it. It tries both points, the first alone, the second alone (total enumeration after Catto, "Iterative
 * Dynamics", 2005). k12 is slightly below its true size, which keeps A well conditioned when the points nearly coincide and does
 * not move the fixed point.
 */
CNI_INLINE void normals_solve_both(normals *c, const cni_contact_block *k, const cni_block_extra *extra, int32_t l, const side *a, const side *b)
{
	const cni_wide zero = cni_wide_of(0.0f);
	const point *p = &c->p, *q = &c->q;
	cni_wide nx = cni_wide_load(k->nx + l), ny = cni_wide_load(k->ny + l);
	cni_wide mass = extra != NULL ? nx * nx * (a->mx + b->mx) + ny * ny * (a->my + b->my) : a->m + b->m;
	cni_wide k12 = 0.99f * (mass + a->i * p->at * q->at + b->i * p->bt * q->bt);
	cni_wide kp = k12 * p->m, kq = k12 * q->m, rp = p->target + kp * q->old, rq = q->target + kq * p->old;
	cni_wide inv_det = 1.0f / (1.0f - kp * kq);
	cni_wide both_p = (rp - kp * rq) * inv_det, both_q = (rq - kq * rp) * inv_det;
	cni_wide one_p = cni_wide_max(rp, zero), one_q = cni_wide_max(rq, zero);
	cni_mask only_p = kq * one_p >= rq, both = (both_p >= zero) & (both_q >= zero);
	c->jp = cni_wide_select(both, both_p, cni_wide_select(only_p, one_p, zero));
	c->jq = cni_wide_select(both, both_q, cni_wide_select(only_p, zero, one_q));
}

CNI_INLINE void normals_solve(normals *c, const cni_contact_block *k, const cni_block_extra *extra, int32_t l, const side *a, const side *b, int32_t points)
{
	const cni_wide zero = cni_wide_of(0.0f);
	if (points == 2)
		normals_solve_both(c, k, extra, l, a, b);
	else
		c->jp = cni_wide_select(c->p.target >= zero, c->p.target, zero); /* as normals_solve_both with a zero row */
}

CNI_INLINE void normals_apply(const normals *c, cni_contact_block *k, int32_t l, side *a, side *b, int32_t points)
{
	cni_wide nx = cni_wide_load(k->nx + l), ny = cni_wide_load(k->ny + l);
	cni_wide_store(k->p[0].jn + l, c->jp);
	apply_normal(a, b, nx, ny, &c->p, c->jp);
	if (points == 2) {
		cni_wide_store(k->p[1].jn + l, c->jq);
		apply_normal(a, b, nx, ny, &c->q, c->jq);
	}
}

CNI_INLINE void solve_normals(cni_contact_block *k, const cni_block_extra *extra, int32_t l, side *a, side *b, const cni_contact_pass *pass, int32_t bias, const float *bounces, int32_t points)
{
	normals c;
	normals_prepare(&c, k, l, a, b, pass, bias, bounces, points);
	normals_solve(&c, k, extra, l, a, b, points);
	normals_apply(&c, k, l, a, b, points);
}

/* Impulse along t = (ny, -nx) on body b. */
CNI_INLINE void apply_friction(side *a, side *b, cni_wide nx, cni_wide ny, cni_wide fa, cni_wide fb, cni_wide dj)
{
	a->vx -= a->mx * dj * ny;
	a->vy += a->my * dj * nx;
	a->w += a->i * fa * dj;
	b->vx += b->mx * dj * ny;
	b->vy -= b->my * dj * nx;
	b->w -= b->i * fb * dj;
}

/* Sticks within static friction, slides at dynamic friction. It begins to slide where it needs CNI_STICK_MARGIN times static friction: a pass
   with a normal impulse that has yet to follow a push needs a little more than the contact bears, and leaves a little slip to the next. */
CNI_INLINE void solve_friction(cni_contact_block *k, const cni_block_extra *extra, int32_t l, side *a, side *b)
{
	cni_wide nx = cni_wide_load(k->nx + l), ny = cni_wide_load(k->ny + l);
	cni_wide fa = cni_wide_load(k->fa + l), fb = cni_wide_load(k->fb + l);
	cni_wide vt = ny * (b->vx - a->vx) - nx * (b->vy - a->vy) - b->w * fb + a->w * fa;
	cni_wide slip = extra != NULL ? vt - cni_wide_load(extra->tangent_speed + l) : vt;
	cni_wide old = cni_wide_load(k->jt + l), target = old - cni_wide_load(k->tm + l) * slip;
	cni_wide normal = cni_wide_load(k->p[0].jn + l) + cni_wide_load(k->p[1].jn + l);
	cni_wide stick = cni_wide_load(k->static_friction + l) * normal, slide = cni_wide_load(k->dynamic_friction + l) * normal;
	cni_wide most = cni_wide_select(cni_wide_abs(target) <= cni_wide_of(CNI_STICK_MARGIN) * stick, stick, slide);
	cni_wide impulse = cni_wide_max(cni_wide_min(target, most), -most);
	cni_wide_store(k->jt + l, impulse);
	apply_friction(a, b, nx, ny, fa, fb, impulse - old);
}

/* A torque against relative turning, bounded by the normal impulse times a lever arm. */
CNI_INLINE void solve_rolling(const cni_contact_block *k, cni_block_extra *extra, int32_t l, side *a, side *b)
{
	cni_wide most = cni_wide_load(extra->rolling + l) * (cni_wide_load(k->p[0].jn + l) + cni_wide_load(k->p[1].jn + l));
	cni_wide old = cni_wide_load(extra->rolling_impulse + l);
	cni_wide target = old - cni_wide_load(extra->rolling_mass + l) * (b->w - a->w);
	cni_wide impulse = cni_wide_max(cni_wide_min(target, most), -most), dj = impulse - old;
	cni_wide_store(extra->rolling_impulse + l, impulse);
	a->w -= a->i * dj;
	b->w += b->i * dj;
}

/* Solves all rows of a group once and restores lanes that are not live. */
CNI_INLINE void solve_live(cni_contact_block *k, cni_block_extra *extra, int32_t l, side *a, side *b, const cni_contact_pass *pass, int32_t bias, const float *bounces, cni_mask live)
{
	cni_wide p = cni_wide_load(k->p[0].jn + l), q = cni_wide_load(k->p[1].jn + l), t = cni_wide_load(k->jt + l), roll;
	side a_old = *a, b_old = *b;
	solve_normals(k, extra, l, a, b, pass, bias, bounces, 2);
	solve_friction(k, extra, l, a, b);
	if (extra != NULL) {
		roll = cni_wide_load(extra->rolling_impulse + l);
		solve_rolling(k, extra, l, a, b);
		cni_wide_store(extra->rolling_impulse + l, cni_wide_select(live, cni_wide_load(extra->rolling_impulse + l), roll));
	}
	cni_wide_store(k->p[0].jn + l, cni_wide_select(live, cni_wide_load(k->p[0].jn + l), p));
	cni_wide_store(k->p[1].jn + l, cni_wide_select(live, cni_wide_load(k->p[1].jn + l), q));
	cni_wide_store(k->jt + l, cni_wide_select(live, cni_wide_load(k->jt + l), t));
	side_keep(a, &a_old, live);
	side_keep(b, &b_old, live);
}

/*
 * Lanes whose contact began to touch this step iterate between normals and friction in the substep in which they begin to
 * bear: with no impulse to start from, one round leaves friction bounded by a normal force that is not there yet, and a
 * body set down on a slope would start with a false speed.
 */

/* The rounds after the first. A separate function that takes copies: groups without fresh lanes keep their registers. */
static void solve_again(cni_contact_block *k, cni_block_extra *extra, int32_t l, side *a, side *b, const cni_contact_pass *pass, int32_t bias, const float *bounces, uint32_t live)
{
	for (int32_t round = 1; round < CNI_NEW_CONTACT_ROUNDS; ++round)
		solve_live(k, extra, l, a, b, pass, bias, bounces, cni_mask_of_bits(live));
}

/* Bits of a group's lanes with a normal impulse. */
CNI_INLINE uint32_t group_loaded(const cni_contact_block *k, int32_t l)
{
	return cni_mask_bits(cni_wide_load(k->p[0].jn + l) + cni_wide_load(k->p[1].jn + l) > cni_wide_of(0.0f));
}

/* Bits of a group's lanes with coupled normal and friction impulses. A single point straight ahead of the centres of all bodies that
   turn does not couple them, as between balls and the ground. */
CNI_INLINE uint32_t group_couples(const cni_contact_block *k, int32_t l, const side *a, const side *b)
{
	cni_wide at = cni_wide_load(k->p[0].at + l), bt = at - cni_wide_load(k->dt + l);
	cni_wide across = a->i * cni_wide_abs(at * cni_wide_load(k->fa + l)) + b->i * cni_wide_abs(bt * cni_wide_load(k->fb + l));
	cni_mask two = cni_wide_load(k->p[1].nm + l) > cni_wide_of(0.0f);
	return cni_mask_bits(two | (across > 1e-3f * (a->m + b->m)));
}

CNI_INLINE void solve_fresh(cni_contact_block *k, cni_block_extra *extra, int32_t l, side *a, side *b, const cni_contact_pass *pass, int32_t bias, const float *bounces, uint32_t fresh)
{
	uint32_t live = fresh >> l & ((1u << CNI_WIDTH) - 1u);
	if (live == 0 || !CNI_ON(FRESH_ROUNDS))
		return;
	live &= group_loaded(k, l) & (extra != NULL ? live : group_couples(k, l, a, b));
	if (live == 0)
		return;
	side a_copy = *a;
	side b_copy = *b;
	solve_again(k, extra, l, &a_copy, &b_copy, pass, bias, bounces, live);
	*a = a_copy;
	*b = b_copy;
}

CNI_INLINE void sides_scatter(cni_motion *motions, const cni_contact_block *k, int32_t l, const side *a, const side *b, const cni_contact_pass *pass)
{
	side_scatter(motions, k->ia + l, a);
	if (!pass->one_sided)
		side_scatter(motions, k->ib + l, b);
}

CNI_INLINE void solve_group(cni_motion *motions, cni_contact_block *k, cni_block_extra *extra, int32_t l, const cni_contact_pass *pass, uint32_t fresh, int32_t bias, const float *bounces)
{
	side a, b;
	side_gather(motions, k->ia + l, &a);
	side_gather(motions, k->ib + l, &b);
	if (extra != NULL)
		sides_lock(extra, l, &a, &b);
	if (has_one_point(k, l))
		solve_normals(k, extra, l, &a, &b, pass, bias, bounces, 1);
	else
		solve_normals(k, extra, l, &a, &b, pass, bias, bounces, 2);
	solve_friction(k, extra, l, &a, &b);
	if (extra != NULL)
		solve_rolling(k, extra, l, &a, &b);
	solve_fresh(k, extra, l, &a, &b, pass, bias, bounces, fresh);
	sides_scatter(motions, k, l, &a, &b, pass);
}

/*
 * Solves two groups of one colour without extra rows interleaved. Each is a long chain of dependent operations, and the
 * processor's reordering window is too short to start the next group in the meantime.
 */
CNI_INLINE void solve_pair(cni_motion *motions, cni_contact_block *k, int32_t l, const cni_contact_pass *pass, uint32_t fresh, int32_t bias, const float *bounces, int32_t points)
{
	int32_t m = l + CNI_WIDTH;
	side al, bl, am, bm;
	normals cl, cm;
	side_gather(motions, k->ia + l, &al);
	side_gather(motions, k->ib + l, &bl);
	side_gather(motions, k->ia + m, &am);
	side_gather(motions, k->ib + m, &bm);
	normals_prepare(&cl, k, l, &al, &bl, pass, bias, bounces, points);
	normals_prepare(&cm, k, m, &am, &bm, pass, bias, bounces, points);
	normals_solve(&cl, k, NULL, l, &al, &bl, points);
	normals_solve(&cm, k, NULL, m, &am, &bm, points);
	normals_apply(&cl, k, l, &al, &bl, points);
	normals_apply(&cm, k, m, &am, &bm, points);
	solve_friction(k, NULL, l, &al, &bl);
	solve_friction(k, NULL, m, &am, &bm);
	solve_fresh(k, NULL, l, &al, &bl, pass, bias, bounces, fresh);
	solve_fresh(k, NULL, m, &am, &bm, pass, bias, bounces, fresh);
	sides_scatter(motions, k, l, &al, &bl, pass);
	sides_scatter(motions, k, m, &am, &bm, pass);
}

/* Bits of the lanes that began to touch in this step and had no normal impulse in earlier substeps. */
CNI_INLINE uint32_t block_fresh(const cni_listed_block *b)
{
	return b->fresh != 0 ? b->fresh & b->info->fresh : 0;
}

/* At the end of a substep: lanes with a normal impulse are no longer fresh. */
static void block_age(const cni_listed_block *b, uint32_t fresh)
{
	for (int32_t l = b->begin; l < b->lanes; l += CNI_WIDTH)
		b->info->fresh = (uint16_t)(b->info->fresh & ~(fresh & group_loaded(b->rows, l) << l));
}

/* The groups of a block without extra rows. */
CNI_INLINE void solve_plain(cni_motion *motions, const cni_listed_block *b, const cni_contact_pass *pass, uint32_t fresh, int32_t bias, const float *bounces)
{
	int32_t l = b->begin, end = b->lanes;
#if CNI_WIDTH > 1
	for (; l + CNI_WIDTH < end; l += 2 * CNI_WIDTH)
		if (has_one_point(b->rows, l) && has_one_point(b->rows, l + CNI_WIDTH))
			solve_pair(motions, b->rows, l, pass, fresh, bias, bounces, 1);
		else
			solve_pair(motions, b->rows, l, pass, fresh, bias, bounces, 2);
#endif
	for (; l < end; l += CNI_WIDTH)
		solve_group(motions, b->rows, NULL, l, pass, fresh, bias, bounces);
}

/* The groups of a block with extra rows or high restitution. Outlined variants, as such blocks are few. */
static void solve_rare(cni_motion *motions, const cni_listed_block *b, const cni_contact_pass *pass, uint32_t fresh, int32_t bias)
{
	const float *bounces = b->info->restitution;
	if (b->extra != NULL && bias)
		for (int32_t l = b->begin; l < b->lanes; l += CNI_WIDTH)
			solve_group(motions, b->rows, b->extra, l, pass, fresh, 1, bounces);
	else if (b->extra != NULL)
		for (int32_t l = b->begin; l < b->lanes; l += CNI_WIDTH)
			solve_group(motions, b->rows, b->extra, l, pass, fresh, 0, bounces);
	else if (bias)
		solve_plain(motions, b, pass, fresh, 1, bounces);
	else
		solve_plain(motions, b, pass, fresh, 0, bounces);
}

/* Blocks without extra rows and high restitution get code without them. */
CNI_INLINE void solve_blocks(const cni_color_pass *c, int32_t begin, int32_t end, int32_t bias)
{
	for (int32_t k = begin; k < end; ++k) {
		const cni_listed_block *b = &c->blocks[k];
		const cni_contact_pass *pass = &c->kinds[b->kind];
		uint32_t fresh = block_fresh(b);
		if (c->prefetches)
			cni_blocks_prefetch(c, k, end);
		if (b->extra == NULL && !(b->info->flags & CNI_BLOCK_BOUNCES))
			solve_plain(c->motions, b, pass, fresh, bias, NULL);
		else
			solve_rare(c->motions, b, pass, fresh, bias);
		if (fresh != 0 && !bias)
			block_age(b, fresh);
	}
}

static void kernel_solve(const cni_color_pass *c, int32_t begin, int32_t end)
{
	solve_blocks(c, begin, end, 1);
}

static void kernel_relax(const cni_color_pass *c, int32_t begin, int32_t end)
{
	solve_blocks(c, begin, end, 0);
}

/* Solves the lanes of a block once more that are bits of `again`. */
CNI_INLINE void solve_marked(const cni_color_pass *c, const cni_listed_block *b, cni_block_extra *extra, uint32_t again, const float *bounces)
{
	for (int32_t l = b->begin; again >> l != 0; l += CNI_WIDTH) {
		uint32_t bits = again >> l & ((1u << CNI_WIDTH) - 1u);
		side a, other;
		if (bits == 0)
			continue;
		side_gather(c->motions, b->rows->ia + l, &a);
		side_gather(c->motions, b->rows->ib + l, &other);
		if (extra != NULL)
			sides_lock(extra, l, &a, &other);
		solve_live(b->rows, extra, l, &a, &other, &c->kinds[b->kind], 1, bounces, cni_mask_of_bits(bits));
		sides_scatter(c->motions, b->rows, l, &a, &other, &c->kinds[b->kind]);
	}
}

/* Solves the lanes that are marked once more, and clears the marks. */
static void kernel_again(const cni_color_pass *c, int32_t begin, int32_t end)
{
	for (int32_t k = begin; k < end; ++k) {
		const cni_listed_block *b = &c->blocks[k];
		uint32_t again = b->info->again;
		b->info->again = 0;
		if (b->extra == NULL && !(b->info->flags & CNI_BLOCK_BOUNCES))
			solve_marked(c, b, NULL, again, NULL);
		else
			solve_marked(c, b, b->extra, again, b->info->flags & CNI_BLOCK_BOUNCES ? b->info->restitution : NULL);
	}
}

/* Lanes in which every movable body has settled. */
CNI_INLINE cni_mask lanes_settled(const cni_external *externals, const cni_contact_block *k, int32_t l, const side *b)
{
#if CNI_WIDTH == 1
	if (externals == NULL || !(externals[k->ia[l]].flags & CNI_EXTERNAL_SETTLED))
		return 0;
	return (externals[k->ib[l]].flags & CNI_EXTERNAL_SETTLED) || b->m == 0.0f;
#else
	const float *base = (const float *)(const void *)externals;
	const int32_t stride = (int32_t)(sizeof(cni_external) / sizeof(float));
	const cni_mask none = { 0 }, bit = (int32_t)CNI_EXTERNAL_SETTLED - none;
	cni_wide ax, ay, alpha, flags_a, flags_b;
	if (externals == NULL)
		return none;
	cni_wide_gather4(base, stride, k->ia + l, &ax, &ay, &alpha, &flags_a);
	cni_wide_gather4(base, stride, k->ib + l, &ax, &ay, &alpha, &flags_b);
	return (((cni_mask)flags_a & bit) != none) & ((((cni_mask)flags_b & bit) != none) | (b->m == cni_wide_of(0.0f)));
#endif
}

/* Moves a load slowly towards the impulse, more slowly for large impulses. Between settled bodies it does not rise, and a point that bears
   nothing has none. m: the larger inverse mass. */
CNI_INLINE cni_wide load_update(cni_wide load, cni_wide jn, cni_wide m, cni_mask settled, const cni_contact_pass *pass)
{
	cni_wide speed = jn * m, part = cni_wide_min(cni_wide_of(pass->load_part), pass->load_heavy / (speed * speed + FLT_MIN));
	load += cni_wide_select(settled & (jn >= load), cni_wide_of(0.0f), part) * (jn - load);
	return cni_wide_select(jn > cni_wide_of(0.0f), load, cni_wide_of(0.0f));
}

CNI_INLINE void warm_group(cni_motion *motions, const cni_external *externals, cni_contact_block *k, cni_block_extra *extra, int32_t l, const cni_contact_pass *pass)
{
	const cni_wide zero = cni_wide_of(0.0f);
	cni_wide nx = cni_wide_load(k->nx + l), ny = cni_wide_load(k->ny + l), scale = cni_wide_of(pass->warm_scale);
	cni_wide jt = cni_wide_load(k->jt + l) * scale;
	side a, b;
	int32_t p, points = has_one_point(k, l) ? 1 : 2;
	side_gather(motions, k->ia + l, &a);
	side_gather(motions, k->ib + l, &b);
	cni_mask settled = lanes_settled(externals, k, l, &b);
	if (extra != NULL)
		sides_lock(extra, l, &a, &b);
	for (p = 0; p < points; ++p) {
		point q;
		cni_wide jn = cni_wide_load(k->p[p].jn + l) * scale;
		q.at = cni_wide_load(k->p[p].at + l);
		q.bt = q.at - cni_wide_load(k->dt + l);
		q.old = zero;
		cni_wide_store(k->p[p].jn + l, jn);
		cni_wide_store(k->p[p].load + l, load_update(cni_wide_load(k->p[p].load + l) * scale, jn, cni_wide_max(a.m, b.m), settled, pass));
		apply_normal(&a, &b, nx, ny, &q, jn);
	}
	cni_wide_store(k->jt + l, jt);
	apply_friction(&a, &b, nx, ny, cni_wide_load(k->fa + l), cni_wide_load(k->fb + l), jt);
	if (extra != NULL) {
		cni_wide roll = cni_wide_load(extra->rolling_impulse + l) * scale;
		cni_wide_store(extra->rolling_impulse + l, roll);
		a.w -= a.i * roll;
		b.w += b.i * roll;
	}
	sides_scatter(motions, k, l, &a, &b, pass);
}

static void kernel_warm(const cni_color_pass *c, int32_t begin, int32_t end)
{
	for (int32_t k = begin; k < end; ++k) {
		const cni_listed_block *b = &c->blocks[k];
		if (c->prefetches)
			cni_blocks_prefetch(c, k, end);
		for (int32_t l = b->begin; l < b->lanes; l += CNI_WIDTH)
			warm_group(c->motions, c->externals, b->rows, b->extra, l, &c->kinds[b->kind]);
	}
}

/* Does the point close faster than speed, and with more momentum than its last impulse (restitution.c)? a and b hold velocities only. */
CNI_INLINE cni_mask point_closes(const cni_contact_block *k, const cni_contact_row *p, int32_t l, const side *a, const side *b, float speed)
{
	cni_wide nx = cni_wide_load(k->nx + l), ny = cni_wide_load(k->ny + l), at = cni_wide_load(p->at + l), bt = at - cni_wide_load(k->dt + l);
	cni_wide vn = nx * (b->vx - a->vx) + ny * (b->vy - a->vy) + b->w * bt - a->w * at;
	cni_wide takes = cni_wide_load(p->nm + l) * -vn, bears = cni_wide_load(p->jn + l), least = cni_wide_of(-speed);
	return (vn < least) & (takes > bears);
}

CNI_INLINE uint32_t group_closing(const float *starts, const cni_contact_block *k, const cni_block_info *info, float speed, float since, int32_t l)
{
	side a, b;
	cni_wide jumped_a, jumped_b;
	cni_wide_gather4(starts, 4, k->ia + l, &a.vx, &a.vy, &a.w, &jumped_a);
	cni_wide_gather4(starts, 4, k->ib + l, &b.vx, &b.vy, &b.w, &jumped_b);
	cni_mask hit = cni_wide_max(jumped_a, jumped_b) >= cni_wide_of(since);
	if (cni_mask_bits(hit) == 0)
		return 0;
	cni_mask closes = point_closes(k, &k->p[0], l, &a, &b, speed) | point_closes(k, &k->p[1], l, &a, &b, speed);
	cni_mask bounces = cni_wide_load_loose(info->restitution + l) > cni_wide_of(0.0f);
	return cni_mask_bits(hit & closes & bounces) << l;
}

static void kernel_closing(const cni_velocity_start *starts, const cni_listed_block *blocks, int32_t count, float speed, float since, uint32_t *closing)
{
	for (int32_t k = 0; k < count; ++k) {
		const cni_listed_block *b = &blocks[k];
		closing[k] = 0;
		if (b->info->flags & CNI_BLOCK_RESTITUTION)
			for (int32_t l = b->begin; l < b->lanes; l += CNI_WIDTH)
				closing[k] |= group_closing((const float *)(const void *)starts, b->rows, b->info, speed, since, l);
	}
}

#include "contacts/restitution_kernel.h"
#include "contacts/manifold_reuse_kernel.h"

const cni_contact_kernel CNI_KERNEL = { { kernel_warm, kernel_solve, kernel_relax, CNI_HAS_DIRECT ? kernel_again : NULL },
	CNI_HAS_RESTITUTION ? kernel_closing : NULL, CNI_HAS_RESTITUTION ? kernel_impact : NULL, kernel_reuse };
