/*
 * stages/contact_solve.c - the contact kernel: warm start, soft solve and relax over blocks of lanes.
 *
 * Reads motion, block rows; writes motion velocities and block.jn, jt. Colours are solved in order, and
 * within a colour no dynamic body appears twice, so its lanes are independent. In static colours lane
 * body b is read and not written. The overflow colour is solved lane by lane.
 *
 * With the letters of contact.h and body changes dp, th since the step began, a point's separation is
 *   s = s0 + n.(dpb - dpa) + [(cos thb - 1) bn + sin thb bt] - [(cos tha - 1) an + sin tha at]
 * its speed vn = n.(vb - va) + wb bt - wa at, and the friction speed vt = t.(vb - va) - wb fb + wa fa.
 */
#include "stages/solver.h"

typedef struct cni_pass {
	float inv_h;
	float push_speed;
	float impact_speed; /* < 0: faster approaches are impacts */
	cni_soft soft;
	int32_t one_sided;
} cni_pass;

/* Velocities of the lanes' bodies, gathered. */
typedef struct lanes_velocity {
	float vx[CNI_LANES], vy[CNI_LANES], w[CNI_LANES], m[CNI_LANES], i[CNI_LANES];
} lanes_velocity;

/* sin and cos - 1 of the change of angle, and the change of centre. */
typedef struct lanes_change {
	float x[CNI_LANES], y[CNI_LANES], s[CNI_LANES], c1[CNI_LANES];
} lanes_change;

CNI_INLINE void gather_velocity(const cni_motion *motions, const int32_t *index, lanes_velocity *v, int32_t first, int32_t count)
{
	int32_t l;
	for (l = 0; l < count; ++l) {
		const cni_motion *m = motions + index[first + l];
		v->vx[l] = m->vx;
		v->vy[l] = m->vy;
		v->w[l] = m->w;
		v->m[l] = m->inv_mass;
		v->i[l] = m->inv_inertia;
	}
}

CNI_INLINE void scatter_velocity(cni_motion *motions, const int32_t *index, const lanes_velocity *v, int32_t first, int32_t count)
{
	int32_t l;
	for (l = 0; l < count; ++l) {
		cni_motion *m = motions + index[first + l];
		m->vx = v->vx[l];
		m->vy = v->vy[l];
		m->w = v->w[l];
	}
}

CNI_INLINE void gather_change(const cni_motion *motions, const int32_t *index, lanes_change *d, int32_t first, int32_t count)
{
	float theta[CNI_LANES];
	int32_t l;
	for (l = 0; l < count; ++l) {
		const cni_motion *m = motions + index[first + l];
		d->x[l] = m->dpx;
		d->y[l] = m->dpy;
		theta[l] = m->theta;
	}
	for (l = 0; l < count; ++l) {
		/* Turns beyond what the series holds for are cut: a contact's geometry does not last that far. */
		float t = cni_clamp(theta[l], -1.25f, 1.25f), t2 = t * t;
		d->s[l] = t * (1.0f - t2 * (1.0f / 6.0f - t2 * (1.0f / 120.0f)));
		d->c1[l] = -t2 * (0.5f - t2 * (1.0f / 24.0f));
	}
}

/* A point of every lane, ready for the pair solve below. */
typedef struct lanes_point {
	float m[CNI_LANES];    /* mass_scale / (n K n); 0: takes no part */
	float want[CNI_LANES]; /* the impulse it would have if the other point kept its own */
} lanes_point;

/* bias: the soft pass, else the rigid one. */
CNI_INLINE void point_prepare(const cni_contact_block *k, int32_t point, const lanes_velocity *a, const lanes_velocity *b,
                              const lanes_change *da, const lanes_change *db, const cni_pass *pass, int32_t bias,
                              lanes_point *out, int32_t first, int32_t count)
{
	const cni_contact_row *p = &k->p[point];
	int32_t l;
	for (l = 0; l < count; ++l) {
		float nx = k->nx[first + l], ny = k->ny[first + l], at = p->at[first + l], an = p->an[first + l];
		float bt = at - k->dt[first + l], bn = an - k->dn[first + l], nm = p->nm[first + l], old = p->jn[first + l];
		float s = p->s0[first + l] + nx * (db->x[l] - da->x[l]) + ny * (db->y[l] - da->y[l]) +
		          (db->c1[l] * bn + db->s[l] * bt) - (da->c1[l] * an + da->s[l] * at);
		float vn = nx * (b->vx[l] - a->vx[l]) + ny * (b->vy[l] - a->vy[l]) + b->w[l] * bt - a->w[l] * at;
		float soft_push = cni_max(pass->soft.bias_scale * s, -pass->push_speed * pass->soft.mass_scale);
		float push = s > 0.0f ? s * pass->inv_h : (bias ? soft_push : 0.0f);
		float scale = s > 0.0f || !bias ? 1.0f : pass->soft.mass_scale;
		/* Relax does not begin to brake a fast body for a surface that only the next substep can reach: it
		   would take the speed that an impact there should return. */
		float on = !bias && s > 0.0f && old == 0.0f && vn < pass->impact_speed ? 0.0f : 1.0f;
		out->m[l] = on * scale * nm;
		out->want[l] = on * (scale * old - nm * (scale * vn + push));
	}
}

CNI_INLINE void apply_normal(cni_contact_block *k, int32_t point, lanes_velocity *a, lanes_velocity *b, const float *impulse,
                             int32_t first, int32_t count)
{
	cni_contact_row *p = &k->p[point];
	int32_t l;
	for (l = 0; l < count; ++l) {
		float nx = k->nx[first + l], ny = k->ny[first + l], at = p->at[first + l], bt = at - k->dt[first + l];
		float dj = impulse[l] - p->jn[first + l], ma = a->m[l] * dj, mb = b->m[l] * dj;
		p->jn[first + l] = impulse[l];
		a->vx[l] -= ma * nx;
		a->vy[l] -= ma * ny;
		a->w[l] -= a->i[l] * at * dj;
		b->vx[l] += mb * nx;
		b->vy[l] += mb * ny;
		b->w[l] += b->i[l] * bt * dj;
	}
}

/*
 * The normal impulses of both points at once: the 2 x 2 complementarity problem A j >= r, j >= 0, in which
 * A has 1/m on its diagonal and k12 beside it, by trying both, the first alone, the second alone
 * (total enumeration after Catto, "Iterative Dynamics", 2005). k12 is held a little below its true
 * size, which keeps A well conditioned when the points nearly coincide and does not move the fixed point.
 */
CNI_INLINE void solve_normals(cni_contact_block *k, lanes_velocity *a, lanes_velocity *b, const lanes_change *da, const lanes_change *db,
                              const cni_pass *pass, int32_t bias, int32_t first, int32_t count)
{
	lanes_point p, q;
	float jp[CNI_LANES], jq[CNI_LANES];
	int32_t l;
	point_prepare(k, 0, a, b, da, db, pass, bias, &p, first, count);
	point_prepare(k, 1, a, b, da, db, pass, bias, &q, first, count);
	for (l = 0; l < count; ++l) {
		float at = k->p[0].at[first + l], bt = at - k->dt[first + l], at2 = k->p[1].at[first + l], bt2 = at2 - k->dt[first + l];
		float k12 = 0.99f * (a->m[l] + b->m[l] + a->i[l] * at * at2 + b->i[l] * bt * bt2);
		float kp = k12 * p.m[l], kq = k12 * q.m[l];
		float rp = p.want[l] + kp * k->p[1].jn[first + l], rq = q.want[l] + kq * k->p[0].jn[first + l];
		float inv_det = 1.0f / (1.0f - kp * kq);
		float both_p = (rp - kp * rq) * inv_det, both_q = (rq - kq * rp) * inv_det;
		float one_p = cni_max(rp, 0.0f), one_q = cni_max(rq, 0.0f);
		int32_t both = both_p >= 0.0f && both_q >= 0.0f, only_p = kq * one_p >= rq;
		jp[l] = both ? both_p : (only_p ? one_p : 0.0f);
		jq[l] = both ? both_q : (only_p ? 0.0f : one_q);
	}
	apply_normal(k, 0, a, b, jp, first, count);
	apply_normal(k, 1, a, b, jq, first, count);
}

/* Sticks within static friction, slides at dynamic friction. */
CNI_INLINE void solve_friction(cni_contact_block *k, lanes_velocity *a, lanes_velocity *b, int32_t first, int32_t count)
{
	int32_t l;
	for (l = 0; l < count; ++l) {
		float tx = k->ny[first + l], ty = -k->nx[first + l], fa = k->fn[first + l], fb = fa - k->dn[first + l];
		float vt = tx * (b->vx[l] - a->vx[l]) + ty * (b->vy[l] - a->vy[l]) - b->w[l] * fb + a->w[l] * fa;
		float old = k->jt[first + l], want = old - k->tm[first + l] * vt;
		float normal = k->p[0].jn[first + l] + k->p[1].jn[first + l];
		float stick = k->static_friction[first + l] * normal, slide = k->dynamic_friction[first + l] * normal;
		float clamped = cni_max(cni_min(want, slide), -slide);
		float impulse = cni_abs(want) <= stick ? want : clamped;
		float dj = impulse - old, ma = a->m[l] * dj, mb = b->m[l] * dj;
		k->jt[first + l] = impulse;
		a->vx[l] -= ma * tx;
		a->vy[l] -= ma * ty;
		a->w[l] += a->i[l] * fa * dj;
		b->vx[l] += mb * tx;
		b->vy[l] += mb * ty;
		b->w[l] -= b->i[l] * fb * dj;
	}
}

CNI_INLINE void solve_lanes(cni_motion *motions, cni_contact_block *k, const cni_pass *pass, int32_t bias, int32_t rounds, int32_t first, int32_t count)
{
	int32_t round;
	lanes_velocity a, b;
	lanes_change da, db;
	gather_velocity(motions, k->ia, &a, first, count);
	gather_velocity(motions, k->ib, &b, first, count);
	gather_change(motions, k->ia, &da, first, count);
	gather_change(motions, k->ib, &db, first, count);
	for (round = 0; round < rounds; ++round) {
		solve_normals(k, &a, &b, &da, &db, pass, bias, first, count);
		solve_friction(k, &a, &b, first, count);
	}
	scatter_velocity(motions, k->ia, &a, first, count);
	if (!pass->one_sided)
		scatter_velocity(motions, k->ib, &b, first, count);
}

CNI_INLINE void warm_lanes(cni_motion *motions, cni_contact_block *k, float scale, int32_t one_sided, int32_t first, int32_t count)
{
	lanes_velocity a, b;
	int32_t l;
	gather_velocity(motions, k->ia, &a, first, count);
	gather_velocity(motions, k->ib, &b, first, count);
	for (l = 0; l < count; ++l) {
		float j0 = k->p[0].jn[first + l] * scale, j1 = k->p[1].jn[first + l] * scale, jt = k->jt[first + l] * scale, jn = j0 + j1;
		float px = jn * k->nx[first + l] + jt * k->ny[first + l], py = jn * k->ny[first + l] - jt * k->nx[first + l];
		float fa = k->fn[first + l], fb = fa - k->dn[first + l];
		float turn_a = k->p[0].at[first + l] * j0 + k->p[1].at[first + l] * j1 - fa * jt;
		float turn_b = (k->p[0].at[first + l] - k->dt[first + l]) * j0 + (k->p[1].at[first + l] - k->dt[first + l]) * j1 - fb * jt;
		k->p[0].jn[first + l] = j0;
		k->p[1].jn[first + l] = j1;
		k->jt[first + l] = jt;
		a.vx[l] -= a.m[l] * px;
		a.vy[l] -= a.m[l] * py;
		a.w[l] -= a.i[l] * turn_a;
		b.vx[l] += b.m[l] * px;
		b.vy[l] += b.m[l] * py;
		b.w[l] += b.i[l] * turn_b;
	}
	scatter_velocity(motions, k->ia, &a, first, count);
	if (!one_sided)
		scatter_velocity(motions, k->ib, &b, first, count);
}

/* ---- over colours ---- */

/*
 * Blocks in which a contact began to touch this step iterate between normals and friction: with no impulse
 * to start from, one round leaves friction bounded by a normal force that is not there yet, and a body set
 * down on a slope would start with a false speed.
 */
#define FRESH_ROUNDS 4

static int32_t rounds_of(const cn_world *world, const cni_block_info *info)
{
	return info->fresh_step == world->step_count + 1u ? FRESH_ROUNDS : 1;
}

static cni_pass pass_make(const cni_solve *s, int32_t color)
{
	cni_pass pass;
	pass.inv_h = s->inv_h;
	pass.push_speed = s->push_speed;
	pass.impact_speed = -s->restitution_threshold;
	pass.one_sided = color >= CNI_COLOR_STATIC && color != CNI_COLOR_OVERFLOW;
	pass.soft = pass.one_sided ? s->contact_static : s->contact;
	return pass;
}

static void solve_overflow(cn_world *world, const cni_solve *s, int32_t bias)
{
	cni_motion *motions = cni_motions(world);
	int32_t block, l;
	for (block = world->colors[CNI_COLOR_OVERFLOW].first; block != CNI_NONE; block = cni_block_info_at(world, block)->next) {
		cni_contact_block *k = cni_block_at(world, block);
		for (l = 0; l < CNI_LANES; ++l) {
			cni_pass pass = pass_make(s, CNI_COLOR_OVERFLOW);
			if (motions[k->ib[l]].inv_mass == 0.0f) {
				pass.one_sided = 1;
				pass.soft = s->contact_static;
			}
			solve_lanes(motions, k, &pass, bias, 1, l, 1);
		}
	}
}

static void solve_all(cn_world *world, const cni_solve *s, int32_t bias)
{
	cni_motion *motions = cni_motions(world);
	int32_t color, block;
	if (world->colors[CNI_COLOR_OVERFLOW].lanes > 0)
		solve_overflow(world, s, bias);
	for (color = 0; color < CNI_COLOR_OVERFLOW; ++color) {
		cni_pass pass = pass_make(s, color);
		for (block = world->colors[color].first; block != CNI_NONE; block = cni_block_info_at(world, block)->next)
			solve_lanes(motions, cni_block_at(world, block), &pass, bias, rounds_of(world, cni_block_info_at(world, block)), 0, CNI_LANES);
	}
}

void cni_contacts_solve(cn_world *world, const cni_solve *s)
{
	solve_all(world, s, 1);
}

void cni_contacts_relax(cn_world *world, const cni_solve *s)
{
	solve_all(world, s, 0);
}

void cni_contacts_warm_start(cn_world *world, const cni_solve *s)
{
	cni_motion *motions = cni_motions(world);
	int32_t color, block, l;
	for (color = 0; color < CNI_COLORS; ++color) {
		int32_t one_sided = pass_make(s, color).one_sided;
		for (block = world->colors[color].first; block != CNI_NONE; block = cni_block_info_at(world, block)->next) {
			cni_contact_block *k = cni_block_at(world, block);
			if (color != CNI_COLOR_OVERFLOW)
				warm_lanes(motions, k, s->warm_scale, one_sided, 0, CNI_LANES);
			else
				for (l = 0; l < CNI_LANES; ++l)
					warm_lanes(motions, k, s->warm_scale, motions[k->ib[l]].inv_mass == 0.0f, l, 1);
		}
	}
}
