/*
 * contacts/restitution_kernel.h - the restitution kernel, included by each width's contact kernel. restitution.c has the method.
 *
 * An impulse and its opposite must act along one line, or they add angular momentum. A lane's lever arms are those of the step's
 * beginning, or, for bodies that are still apart, those of the predicted contact. So the arms of b are computed from a's arms
 * and the current centres.
 */
#include "base/bitset.h"
#include "contacts/contact_pass.h"

#include <string.h>

enum { START_FLOATS = sizeof(cni_velocity_start) / sizeof(float), EXTERNAL_FLOATS = sizeof(cni_external) / sizeof(float) };

/* The bodies on one side of CNI_WIDTH lanes. */
typedef struct impact_side {
	cni_wide vx, vy, w, jumped;   /* velocities before the impact, from start */
	cni_wide mvx, mvy, mw, m;     /* velocities of motion */
	cni_wide dpx, dpy, theta, i;
	cni_wide mx, my;              /* inverse mass along x and y: 0 for a locked axis */
	cni_wide ax, ay;              /* external acceleration */
} impact_side;

CNI_INLINE void impact_gather(const cni_impact_pass *pass, const int32_t *index, impact_side *out)
{
	const float *motions = (const float *)(const void *)pass->motions, *externals = (const float *)(const void *)pass->externals;
	cni_wide alpha, flags;
	cni_wide_gather4((const float *)(const void *)pass->starts, START_FLOATS, index, &out->vx, &out->vy, &out->w, &out->jumped);
	cni_wide_gather4(motions, MOTION_FLOATS, index, &out->mvx, &out->mvy, &out->mw, &out->m);
	cni_wide_gather4(motions + 4, MOTION_FLOATS, index, &out->dpx, &out->dpy, &out->theta, &out->i);
	cni_wide_gather4(externals, EXTERNAL_FLOATS, index, &out->ax, &out->ay, &alpha, &flags);
	out->mx = out->my = out->m;
}

/*
 * Adds the velocity changes to the hit lanes' bodies, in start and in motion. A whole vector writes the old values back for the
 * other lanes, so that results are deterministic. Unused lanes, which several workers may share, are not written.
 */
CNI_INLINE void impact_write(const cni_impact_pass *pass, const int32_t *index, const impact_side *c, cni_mask hit, int32_t whole, cni_wide dvx, cni_wide dvy, cni_wide dw)
{
	float *starts = (float *)(void *)pass->starts, *motions = (float *)(void *)pass->motions;
	cni_wide vx = cni_wide_select(hit, c->vx + dvx, c->vx), vy = cni_wide_select(hit, c->vy + dvy, c->vy), w = cni_wide_select(hit, c->w + dw, c->w);
	cni_wide mvx = cni_wide_select(hit, c->mvx + dvx, c->mvx), mvy = cni_wide_select(hit, c->mvy + dvy, c->mvy), mw = cni_wide_select(hit, c->mw + dw, c->mw);
	cni_wide jumped = cni_wide_select(hit, cni_wide_of(pass->jumped), c->jumped);
	if (whole) {
		cni_wide_scatter4(starts, START_FLOATS, index, vx, vy, w, jumped);
		cni_wide_scatter4(motions, MOTION_FLOATS, index, mvx, mvy, mw, c->m);
	} else {
		cni_wide_scatter4_where(starts, START_FLOATS, index, cni_mask_bits(hit), vx, vy, w, jumped);
		cni_wide_scatter4_where(motions, MOTION_FLOATS, index, cni_mask_bits(hit), mvx, mvy, mw, c->m);
	}
}

typedef struct impact_lanes {
	impact_side a, b;
	cni_wide nx, ny, fa, tm, dynamic_friction;
	cni_wide step_dn, step_dt; /* rows dn and dt */
	cni_wide mass;        /* sum of inverse masses along n */
	cni_wide dn, dt;      /* current offset from a's centre to b's: both arms end in one point */
	cni_wide closing;     /* relative acceleration along n that closes the gap */
	cni_wide restitution;
} impact_lanes;

/* A row of a block, or of its extra rows, in all lanes. */
#define IMPACT_ROW(k, l, row) cni_wide_gather_from((k)->rows + (l), offsetof(cni_contact_block, row) / sizeof(float))
#define IMPACT_EXTRA(k, l, row) cni_wide_gather_from((k)->extra + (l), offsetof(cni_block_extra, row) / sizeof(float))

CNI_INLINE void impact_centers(impact_lanes *c, const cni_impact_lanes *k, int32_t l)
{
	cni_wide ax, ay, ax_low, ay_low, bx, by, bx_low, by_low, x, y;
	cni_wide_gather4_from(k->a + l, 0, &ax, &ay, &ax_low, &ay_low);
	cni_wide_gather4_from(k->b + l, 0, &bx, &by, &bx_low, &by_low);
	x = (bx - ax) + (bx_low - ax_low) + (c->b.dpx - c->a.dpx);
	y = (by - ay) + (by_low - ay_low) + (c->b.dpy - c->a.dpy);
	c->dn = c->nx * x + c->ny * y;
	c->dt = c->ny * x - c->nx * y;
	if (k->at_world != 0) {
		cni_mask fixed = cni_mask_of_bits(k->at_world >> l);
		c->dn = cni_wide_select(fixed, c->fa - IMPACT_ROW(k, l, fb), c->dn);
		c->dt = cni_wide_select(fixed, c->step_dt, c->dt);
	}
}

CNI_INLINE void impact_lanes_make(impact_lanes *c, const cni_impact_pass *pass, const cni_impact_lanes *k, int32_t l)
{
	c->nx = IMPACT_ROW(k, l, nx);
	c->ny = IMPACT_ROW(k, l, ny);
	c->fa = IMPACT_ROW(k, l, fa);
	c->tm = IMPACT_ROW(k, l, tm);
	c->dynamic_friction = IMPACT_ROW(k, l, dynamic_friction);
	c->step_dn = IMPACT_ROW(k, l, dn);
	c->step_dt = IMPACT_ROW(k, l, dt);
	impact_gather(pass, k->ia + l, &c->a);
	impact_gather(pass, k->ib + l, &c->b);
	if (k->has_extra) {
		c->a.mx = c->a.m * (1.0f - IMPACT_EXTRA(k, l, lock_ax));
		c->a.my = c->a.m * (1.0f - IMPACT_EXTRA(k, l, lock_ay));
		c->b.mx = c->b.m * (1.0f - IMPACT_EXTRA(k, l, lock_bx));
		c->b.my = c->b.m * (1.0f - IMPACT_EXTRA(k, l, lock_by));
	}
	c->mass = c->nx * c->nx * (c->a.mx + c->b.mx) + c->ny * c->ny * (c->a.my + c->b.my);
	impact_centers(c, k, l);
	c->closing = c->nx * (c->a.ax - c->b.ax) + c->ny * (c->a.ay - c->b.ay);
	c->restitution = cni_wide_load_loose(k->restitution + l);
}

/* Current separation, to second order in the turn: turns within a step are small next to the gap at impact speeds. */
CNI_INLINE cni_wide impact_separation(const impact_lanes *c, cni_wide s0, cni_wide an, cni_wide dn, cni_wide at, cni_wide bt)
{
	cni_wide ta = c->a.theta, tb = c->b.theta;
	return s0 + c->nx * (c->b.dpx - c->a.dpx) + c->ny * (c->b.dpy - c->a.dpy) + (tb * bt - 0.5f * tb * tb * (an - dn)) -
	       (ta * at - 0.5f * ta * ta * an);
}

/* Outgoing speed at the end of the substep, >= 0 (restitution.c). before: speed at its start. */
CNI_INLINE cni_wide impact_outgoing(cni_wide before, cni_wide s, cni_wide a, cni_wide e, float h)
{
	const cni_wide zero = cni_wide_of(0.0f);
	cni_wide meet_sq = before * before + 2.0f * a * s;
	cni_wide inside = a * a * h * h - 2.0f * a * s + e * e * cni_wide_max(meet_sq, zero);
	return cni_wide_max(cni_wide_sqrt(cni_wide_max(inside, zero)) - a * h, zero);
}

#define POINT_ROW(k, l, from, row) cni_wide_gather_from((k)->rows + (l), ((from) + offsetof(cni_contact_row, row)) / sizeof(float))

typedef struct impact_point {
	cni_wide at, bt, vn, out, k; /* k = n K n */
	cni_mask hits;
} impact_point;

/* from: byte offset of the point's rows in the block. */
CNI_INLINE impact_point impact_point_make(const impact_lanes *c, const cni_impact_pass *pass, const cni_impact_lanes *k, size_t from, int32_t l)
{
	const cni_wide zero = cni_wide_of(0.0f);
	impact_point q;
	cni_wide separation, nm = POINT_ROW(k, l, from, nm), bears = POINT_ROW(k, l, from, jn), least = cni_wide_of(-pass->speed);
	q.at = POINT_ROW(k, l, from, at);
	q.bt = q.at - c->dt;
	q.vn = c->nx * (c->b.vx - c->a.vx) + c->ny * (c->b.vy - c->a.vy) + c->b.w * q.bt - c->a.w * q.at;
	q.k = c->mass + c->a.i * q.at * q.at + c->b.i * q.bt * q.bt;
	separation = impact_separation(c, POINT_ROW(k, l, from, s0), POINT_ROW(k, l, from, an), c->step_dn, q.at, q.at - c->step_dt);
	q.hits = (nm * -q.vn > bears) & (q.vn < least) & (separation + pass->h * q.vn < zero);
	/* At most the law's speed at this instant plus the gain of the external acceleration: two fast bodies that just took other impacts
	   must not gain energy. */
	q.out = cni_wide_min(impact_outgoing(q.vn + pass->h * c->closing, separation, c->closing, c->restitution, pass->h),
	                     c->restitution * -q.vn + cni_wide_abs(c->closing) * pass->h);
	return q;
}

/* The sum of the normal impulses of a lane's points. */
typedef struct impact_impulse {
	cni_wide jn, moment_a, moment_b;
} impact_impulse;

/* Solves both points together if both hit and both impulses are positive, else only the faster one. */
CNI_INLINE impact_impulse impact_solve(const impact_lanes *c, const impact_point *p, const impact_point *q)
{
	const cni_wide zero = cni_wide_of(0.0f);
	cni_wide k12 = c->mass + c->a.i * p->at * q->at + c->b.i * p->bt * q->bt;
	cni_wide det = p->k * q->k - k12 * k12, dp = p->out - p->vn, dq = q->out - q->vn;
	cni_wide jp = q->k * dp - k12 * dq, jq = p->k * dq - k12 * dp, j;
	cni_mask both = p->hits & q->hits & (det > 1e-4f * p->k * q->k) & (jp >= zero) & (jq >= zero);
	cni_mask second = cni_wide_select(q->hits, q->vn, zero) < cni_wide_select(p->hits, p->vn, zero);
	impact_impulse impulse;
	jp = jp / det;
	jq = jq / det;
	j = cni_wide_select(second, dq, dp) / cni_wide_select(second, q->k, p->k);
	impulse.jn = cni_wide_select(both, jp + jq, j);
	impulse.moment_a = cni_wide_select(both, p->at * jp + q->at * jq, cni_wide_select(second, q->at, p->at) * j);
	impulse.moment_b = cni_wide_select(both, p->bt * jp + q->bt * jq, cni_wide_select(second, q->bt, p->bt) * j);
	return impulse;
}

/* Returns the friction impulse. Applies the normal impulse, and friction against the sliding speed within mu jn. Both use masses at the current arms. The lane's
   tangential mass has other arms when bodies meet metres ahead, and would reverse the sliding many times over. */
CNI_INLINE cni_wide impact_apply(const impact_lanes *c, const cni_impact_pass *pass, const cni_impact_lanes *k, int32_t l, const impact_impulse *impulse, cni_mask hit, int32_t whole)
{
	const impact_side *a = &c->a, *b = &c->b;
	cni_wide tx = c->ny, ty = -c->nx, fa = c->fa, fb = fa - c->dn;
	cni_wide kt = tx * tx * (a->mx + b->mx) + ty * ty * (a->my + b->my) + a->i * fa * fa + b->i * fb * fb;
	cni_wide wa = -a->i * impulse->moment_a, wb = b->i * impulse->moment_b;
	cni_wide vt = tx * (b->vx - a->vx) + ty * (b->vy - a->vy) - (b->w + wb) * fb + (a->w + wa) * fa;
	cni_wide most = c->dynamic_friction * impulse->jn, jt = cni_wide_select(c->tm > cni_wide_of(0.0f), -vt / kt, cni_wide_of(0.0f)), px, py;
	jt = cni_wide_select(jt < -most, -most, cni_wide_min(jt, most));
	px = impulse->jn * c->nx + jt * tx;
	py = impulse->jn * c->ny + jt * ty;
	impact_write(pass, k->ia + l, a, hit, whole, -a->mx * px, -a->my * py, wa + a->i * fa * jt);
	if (!pass->one_sided)
		impact_write(pass, k->ib + l, b, hit, whole, b->mx * px, b->my * py, wb - b->i * fb * jt);
	return jt;
}

/* The record lies on the caller's stack, not aligned to vectors. */
CNI_INLINE void record_row(float *row, int32_t l, cni_mask hits, cni_wide value)
{
	const cni_wide shown = cni_wide_select(hits, value, cni_wide_of(0.0f));
	memcpy(row + l, &shown, sizeof shown);
}

CNI_INLINE void impact_record(const cni_impact_pass *pass, int32_t l, cni_mask hit, const impact_point *p, const impact_point *q, cni_wide jn, cni_wide jt)
{
	record_row(pass->record->jn, l, hit, jn);
	record_row(pass->record->jt, l, hit, jt);
	record_row(pass->record->closing[0], l, p->hits, -p->vn);
	record_row(pass->record->closing[1], l, q->hits, -q->vn);
}

static int32_t kernel_impact(const cni_impact_pass *pass, const cni_impact_lanes *k, int32_t count)
{
	int32_t hits = 0;
	for (int32_t l = 0; l < count; l += CNI_WIDTH) {
		impact_lanes c;
		impact_point p, q;
		impact_lanes_make(&c, pass, k, l);
		p = impact_point_make(&c, pass, k, offsetof(cni_contact_block, p[0]), l);
		q = impact_point_make(&c, pass, k, offsetof(cni_contact_block, p[1]), l);
		uint32_t lanes = cni_mask_bits(p.hits | q.hits) & ((1u << (count - l)) - 1u);
		if (lanes == 0)
			continue;
		impact_impulse impulse = impact_solve(&c, &p, &q);
		cni_wide jt = impact_apply(&c, pass, k, l, &impulse, cni_mask_of_bits(lanes), count - l >= CNI_WIDTH);
		if (pass->record != NULL)
			impact_record(pass, l, cni_mask_of_bits(lanes), &p, &q, impulse.jn, jt);
		hits += cni_bit_count64(lanes);
	}
	return hits;
}
