/*
 * joints/joint_rows_kernel.h - passes over lanes of rows (joints/joint_rows.h) for one instruction set: a part of joints/joint_kernel.h,
 * included by joints/joint_passes_kernel.h.
 *
 * Every sum has the terms and the order of joints/joint_solve.c and of the types' files in joints/, which explain the formulas; only
 * multiplications by one are left out.
 */
#include "joints/joint_rows.h"

typedef struct wide_row {
	cni_wide nx, ny, aw, bw;
} wide_row;

CNI_INLINE wide_row row_load(const cni_lane_row *r, int32_t l)
{
	wide_row w;
	w.nx = cni_wide_load(r->nx + l);
	w.ny = cni_wide_load(r->ny + l);
	w.aw = cni_wide_load(r->aw + l);
	w.bw = cni_wide_load(r->bw + l);
	return w;
}

CNI_INLINE void row_store(cni_lane_row *r, int32_t l, const wide_row *w)
{
	cni_wide_store(r->nx + l, w->nx);
	cni_wide_store(r->ny + l, w->ny);
	cni_wide_store(r->aw + l, w->aw);
	cni_wide_store(r->bw + l, w->bw);
}

CNI_INLINE wide_row row_of(cni_wide nx, cni_wide ny, cni_wide aw, cni_wide bw)
{
	wide_row w;
	w.nx = nx;
	w.ny = ny;
	w.aw = aw;
	w.bw = bw;
	return w;
}

CNI_INLINE cni_wide row_speed(const wide_row *r, const side *a, const side *b)
{
	return r->aw * a->w - (r->nx * a->vx + r->ny * a->vy) + r->nx * b->vx + r->ny * b->vy + r->bw * b->w;
}

CNI_INLINE void row_push(const wide_row *r, cni_wide impulse, side *a, side *b)
{
	cni_wide ma = a->m * impulse, mb = b->m * impulse;
	a->vx -= ma * r->nx;
	a->vy -= ma * r->ny;
	a->w += a->i * impulse * r->aw;
	b->vx += mb * r->nx;
	b->vy += mb * r->ny;
	b->w += b->i * impulse * r->bw;
}

CNI_INLINE cni_wide row_mass(const wide_row *r, const wide_row *q, const side *a, const side *b)
{
	cni_wide dot = r->nx * q->nx + r->ny * q->ny;
	return a->m * dot + a->i * r->aw * q->aw + b->m * dot + b->i * r->bw * q->bw;
}

CNI_INLINE cni_wide row_dot(const wide_row *r, const wide_row *old)
{
	cni_wide x = r->nx * old->nx, y = r->ny * old->ny;
	return x + y + r->bw * old->bw + x + y + r->aw * old->aw;
}

CNI_INLINE cni_wide inverse_of(cni_wide x)
{
	const cni_wide zero = cni_wide_of(0.0f);
	return cni_wide_select(x > zero, 1.0f / x, zero);
}

/* ---- frames ---- */

/* cni_rot_small: lanes beyond its range are computed one by one, with the same bits. */
CNI_INLINE void rot_small(cni_wide theta, cni_wide *out_c, cni_wide *out_s)
{
	const uint32_t all = (1u << CNI_WIDTH) - 1u;
	cni_wide u = theta * theta, s, c, k;
	uint32_t beyond = all & ~cni_mask_bits(cni_wide_abs(theta) <= cni_wide_of(1.0f));
	s = theta + theta * u * (-0.16665473f + u * 0.0081809414f);
	c = 1.0f + u * (-0.499886758f + u * 0.0404636746f);
	k = 1.5f - 0.5f * (c * c + s * s);
	*out_c = k * c;
	*out_s = k * s;
	if (beyond != 0) {
		CNI_ALIGNED(64) float angle[CNI_WIDTH], cosine[CNI_WIDTH], sine[CNI_WIDTH];
		int32_t l;
		cni_wide_store(angle, theta);
		for (l = 0; l < CNI_WIDTH; ++l) {
			cni_rot q = cni_rot_small(angle[l]);
			cosine[l] = q.c;
			sine[l] = q.s;
		}
		*out_c = cni_wide_load(cosine);
		*out_s = cni_wide_load(sine);
	}
}

typedef struct wide_vec {
	cni_wide x, y;
} wide_vec;

CNI_INLINE wide_vec vec_of(cni_wide x, cni_wide y)
{
	wide_vec v;
	v.x = x;
	v.y = y;
	return v;
}
CNI_INLINE wide_vec vec_rotate(cni_wide c, cni_wide s, wide_vec v) { return vec_of(c * v.x - s * v.y, s * v.x + c * v.y); }
CNI_INLINE cni_wide vec_dot(wide_vec a, wide_vec b) { return a.x * b.x + a.y * b.y; }
CNI_INLINE cni_wide vec_cross(wide_vec a, wide_vec b) { return a.x * b.y - a.y * b.x; }

/* cni_joint_frame of the lanes. */
typedef struct wide_frame {
	wide_vec ra, rb, d;
	cni_wide qc, qs, angle;
} wide_frame;

typedef struct wide_place {
	cni_wide x, y, theta, i;
} wide_place;

CNI_INLINE wide_place at_gather(const cni_motion *motions, const int32_t *index)
{
	wide_place p;
	cni_wide_gather4((const float *)(const void *)motions + 4, MOTION_FLOATS, index, &p.x, &p.y, &p.theta, &p.i);
	return p;
}

CNI_INLINE wide_frame frame_now(const cni_motion *motions, const cni_row_block *k, int32_t l, int32_t form)
{
	wide_place a = at_gather(motions, k->ia + l), b = at_gather(motions, k->ib + l);
	wide_vec ra0 = vec_of(cni_wide_load(k->ax0 + l), cni_wide_load(k->ay0 + l)), rb0 = vec_of(cni_wide_load(k->bx0 + l), cni_wide_load(k->by0 + l));
	cni_wide ac, as, bc, bs;
	wide_frame f;
	rot_small(a.theta, &ac, &as);
	rot_small(b.theta, &bc, &bs);
	f.ra = vec_rotate(ac, as, ra0);
	f.rb = vec_rotate(bc, bs, rb0);
	f.d.x = cni_wide_load(k->dx0 + l) + (b.x - a.x) + (f.rb.x - rb0.x) - (f.ra.x - ra0.x);
	f.d.y = cni_wide_load(k->dy0 + l) + (b.y - a.y) + (f.rb.y - rb0.y) - (f.ra.y - ra0.y);
	f.angle = cni_wide_load(k->angle0 + l) + (b.theta - a.theta);
	f.qc = ac;
	f.qs = as;
	if (form == CNI_FORM_SLIDE || form == CNI_FORM_WHEEL) {
		cni_wide c0 = cni_wide_load(k->qc0 + l), s0 = cni_wide_load(k->qs0 + l);
		f.qc = c0 * ac - s0 * as;
		f.qs = s0 * ac + c0 * as;
	}
	return f;
}

/* ---- rows ---- */

/* The rows of a form, free ones not yet decoupled, and the measure of springs and limits. */
typedef struct wide_rows {
	wide_row rigid[CNI_JOINT_RIGID_ROWS], free[CNI_FREE_ROWS];
	cni_wide error[CNI_JOINT_RIGID_ROWS], measure;
	cni_wide inverse[6];
} wide_rows;

CNI_INLINE wide_row row_along(const wide_frame *f, wide_vec direction, wide_vec reach)
{
	return row_of(direction.x, direction.y, -vec_cross(reach, direction), vec_cross(f->rb, direction));
}

CNI_INLINE wide_row row_angle(void)
{
	return row_of(cni_wide_of(0.0f), cni_wide_of(0.0f), cni_wide_of(-1.0f), cni_wide_of(1.0f));
}

CNI_INLINE void rows_distance(const wide_frame *f, wide_row *row, cni_wide *length)
{
	const cni_wide one = cni_wide_of(1.0f), zero = cni_wide_of(0.0f);
	cni_wide inverse;
	cni_mask apart;
	wide_vec axis;
	*length = cni_wide_sqrt(vec_dot(f->d, f->d));
	inverse = 1.0f / *length;
	apart = *length > cni_wide_of(1e-9f);
	axis = vec_of(cni_wide_select(apart, inverse * f->d.x, one), cni_wide_select(apart, inverse * f->d.y, zero));
	*row = row_along(f, axis, f->ra);
}

CNI_INLINE void rows_point(const wide_frame *f, wide_rows *g)
{
	const cni_wide zero = cni_wide_of(0.0f), one = cni_wide_of(1.0f);
	g->rigid[0] = row_of(one, zero, f->ra.y, -f->rb.y);
	g->rigid[1] = row_of(zero, one, -f->ra.x, f->rb.x);
	g->error[0] = f->d.x;
	g->error[1] = f->d.y;
}

CNI_INLINE void rows_slide(const wide_frame *f, const cni_row_block *k, int32_t l, wide_rows *g)
{
	wide_vec axis = vec_rotate(f->qc, f->qs, vec_of(cni_wide_load(k->axis_x + l), cni_wide_load(k->axis_y + l)));
	wide_vec across = vec_of(-axis.y, axis.x), reach = vec_of(f->ra.x + f->d.x, f->ra.y + f->d.y);
	g->rigid[0] = row_along(f, across, reach);
	g->error[0] = vec_dot(across, f->d);
	g->free[0] = row_along(f, axis, reach);
	g->measure = vec_dot(axis, f->d);
}

CNI_INLINE void rows_invert(wide_rows *g, int32_t rigid, const side *a, const side *b)
{
	const wide_row *r = g->rigid;
	cni_wide *inv = g->inverse;
	if (rigid == 1) {
		inv[0] = inverse_of(row_mass(r, r, a, b));
	} else if (rigid == 2) {
		cni_wide k00 = row_mass(r, r, a, b), k01 = row_mass(r, r + 1, a, b), k11 = row_mass(r + 1, r + 1, a, b);
		cni_wide d = inverse_of(k00 * k11 - k01 * k01);
		inv[0] = k11 * d;
		inv[1] = -k01 * d;
		inv[3] = k00 * d;
	} else if (rigid == 3) {
		cni_wide k00 = row_mass(r, r, a, b), k01 = row_mass(r, r + 1, a, b), k02 = row_mass(r, r + 2, a, b);
		cni_wide k11 = row_mass(r + 1, r + 1, a, b), k12 = row_mass(r + 1, r + 2, a, b), k22 = row_mass(r + 2, r + 2, a, b);
		cni_wide c00 = k11 * k22 - k12 * k12, c01 = k02 * k12 - k01 * k22, c02 = k01 * k12 - k02 * k11;
		cni_wide d = inverse_of(k00 * c00 + k01 * c01 + k02 * c02);
		inv[0] = c00 * d;
		inv[1] = c01 * d;
		inv[2] = c02 * d;
		inv[3] = (k00 * k22 - k02 * k02) * d;
		inv[4] = (k01 * k02 - k00 * k12) * d;
		inv[5] = (k00 * k11 - k01 * k01) * d;
	}
}

CNI_INLINE wide_rows rows_make(const cni_motion *motions, const cni_row_block *k, int32_t l, int32_t form, const side *a, const side *b)
{
	wide_frame f = frame_now(motions, k, l, form);
	wide_rows g;
	switch (form) {
	case CNI_FORM_ROD:
		rows_distance(&f, &g.rigid[0], &g.error[0]);
		g.error[0] -= cni_wide_load(k->rest + l);
		break;
	case CNI_FORM_TIE:
		rows_distance(&f, &g.free[0], &g.measure);
		break;
	case CNI_FORM_WELD:
		rows_point(&f, &g);
		g.rigid[2] = row_angle();
		g.error[2] = f.angle;
		break;
	case CNI_FORM_SOFT_WELD:
		rows_point(&f, &g);
		g.free[0] = row_angle();
		g.measure = f.angle;
		break;
	case CNI_FORM_SLIDE:
		rows_slide(&f, k, l, &g);
		g.rigid[1] = row_angle();
		g.error[1] = f.angle;
		break;
	default:
		rows_slide(&f, k, l, &g);
		g.free[1] = row_angle();
		break;
	}
	rows_invert(&g, cni_form_rigid_rows(form), a, b);
	return g;
}

/* Index of the entry for rows i and n in the inverse. */
static const uint8_t wide_inverse_at[CNI_JOINT_RIGID_ROWS][CNI_JOINT_RIGID_ROWS] = { { 0, 1, 2 }, { 1, 3, 4 }, { 2, 4, 5 } };

/* out[i]: share of rigid row i in a decoupled row. */
CNI_INLINE void row_shares(const wide_rows *g, int32_t rigid, const wide_row *r, const side *a, const side *b, cni_wide *out)
{
	cni_wide mass[CNI_JOINT_RIGID_ROWS];
	int32_t i, n;
	for (i = 0; i < rigid; ++i)
		mass[i] = row_mass(&g->rigid[i], r, a, b);
	for (i = 0; i < rigid; ++i) {
		out[i] = cni_wide_of(0.0f);
		for (n = 0; n < rigid; ++n)
			out[i] -= g->inverse[wide_inverse_at[i][n]] * mass[n];
	}
}

/* Decouples the free rows from the rigid ones; shares: of each. */
CNI_INLINE void rows_decouple(wide_rows *g, int32_t form, const side *a, const side *b, cni_wide shares[CNI_FREE_ROWS][CNI_JOINT_RIGID_ROWS])
{
	int32_t rigid = cni_form_rigid_rows(form), k, i;
	for (k = 0; rigid > 0 && k < cni_form_free_rows(form); ++k) {
		wide_row *r = &g->free[k];
		row_shares(g, rigid, r, a, b, shares[k]);
		for (i = 0; i < rigid; ++i) {
			r->nx += shares[k][i] * g->rigid[i].nx;
			r->ny += shares[k][i] * g->rigid[i].ny;
			r->aw += shares[k][i] * g->rigid[i].aw;
			r->bw += shares[k][i] * g->rigid[i].bw;
		}
	}
}

CNI_INLINE void rows_store(cni_row_block *k, int32_t l, int32_t form, const wide_rows *g, const side *a, const side *b)
{
	int32_t rigid = cni_form_rigid_rows(form), i, n;
	for (i = 0; i < rigid; ++i) {
		row_store(&k->rigid[i], l, &g->rigid[i]);
		cni_wide_store(k->error[i] + l, g->error[i]);
		for (n = i; n < rigid; ++n)
			cni_wide_store(k->inverse[wide_inverse_at[i][n]] + l, g->inverse[wide_inverse_at[i][n]]);
	}
	for (i = 0; k->has != 0 && i < cni_form_free_rows(form); ++i) {
		row_store(&k->free[i], l, &g->free[i]);
		cni_wide_store(k->free_mass[i] + l, inverse_of(row_mass(&g->free[i], &g->free[i], a, b)));
	}
	if (k->has & CN_JOINT_SPRING)
		cni_wide_store(k->stretch + l, g->measure - cni_wide_load(k->rest + l));
	if (k->has & CN_JOINT_LIMIT) {
		cni_wide low = g->measure - cni_wide_load(k->lower + l), high = cni_wide_load(k->upper + l) - g->measure;
		cni_wide_store(k->below + l, low);
		cni_wide_store(k->above + l, high);
		cni_wide_store(k->side + l, cni_wide_select(low <= high, cni_wide_of(1.0f), cni_wide_of(-1.0f)));
	}
}

CNI_INLINE void sides_gather(const cni_motion *motions, const cni_row_block *k, int32_t l, side *a, side *b)
{
	side_gather(motions, k->ia + l, k->ai + l, a);
	side_gather(motions, k->ib + l, k->bi + l, b);
}

CNI_INLINE void sides_scatter(cni_motion *motions, const cni_row_block *k, int32_t l, const side *a, const side *b)
{
	side_scatter(motions, k->ia + l, k->moves_a >> l, a);
	side_scatter(motions, k->ib + l, k->moves_b >> l, b);
}

/* ---- impulses ---- */

CNI_INLINE void spring_solve(cni_row_block *k, int32_t l, side *a, side *b)
{
	wide_row r = row_load(&k->free[0], l);
	cni_wide old = cni_wide_load(k->spring_j + l), mass = cni_wide_load(k->free_mass[0] + l);
	cni_wide want = cni_wide_load(k->spring_mass + l) * row_speed(&r, a, b) + cni_wide_load(k->spring_bias + l) * cni_wide_load(k->stretch + l);
	cni_wide dj = -(mass * want) - cni_wide_load(k->spring_impulse_scale + l) * old;
	cni_wide_store(k->spring_j + l, old + dj);
	row_push(&r, dj, a, b);
}

CNI_INLINE void motor_solve(cni_row_block *k, int32_t l, int32_t row, side *a, side *b, const cni_joint_pass *pass, int32_t bias)
{
	wide_row r = row_load(&k->free[row], l);
	cni_wide old = cni_wide_load(k->motor_j + l), mass = cni_wide_load(k->free_mass[row] + l), most = cni_wide_load(k->most + l) * pass->h;
	cni_wide target = cni_wide_load(k->speed + l), impulse;
	if (row == 0 && (k->has & CN_JOINT_LIMIT))
		target = motor_target(target, cni_wide_load(k->below + l), cni_wide_load(k->above + l), pass, bias);
	impulse = cni_wide_min(cni_wide_max(old - mass * (row_speed(&r, a, b) - target), -most), most);
	cni_wide_store(k->motor_j + l, impulse);
	row_push(&r, impulse - old, a, b);
}

CNI_INLINE void limit_solve(cni_row_block *k, int32_t l, side *a, side *b, const cni_joint_pass *pass, int32_t bias)
{
	wide_row r = row_load(&k->free[0], l);
	cni_wide old = cni_wide_load(k->limit_j + l), mass = cni_wide_load(k->free_mass[0] + l), sign = cni_wide_load(k->side + l);
	cni_wide impulse = limit_impulse(old, cni_wide_min(cni_wide_load(k->below + l), cni_wide_load(k->above + l)), sign * row_speed(&r, a, b), mass, pass, bias);
	cni_wide_store(k->limit_j + l, impulse);
	row_push(&r, sign * (impulse - old), a, b);
}

CNI_INLINE void rigid_solve(cni_row_block *k, int32_t l, int32_t rigid, side *a, side *b, const cni_joint_pass *pass, int32_t bias)
{
	wide_row r[CNI_JOINT_RIGID_ROWS];
	cni_wide want[CNI_JOINT_RIGID_ROWS], dj[CNI_JOINT_RIGID_ROWS];
	int32_t i, n;
	for (i = 0; i < rigid; ++i) {
		r[i] = row_load(&k->rigid[i], l);
		want[i] = row_speed(&r[i], a, b);
		if (bias)
			want[i] = pass->soft.mass_scale * want[i] + pass->soft.bias_scale * cni_wide_load(k->error[i] + l);
	}
	for (i = 0; i < rigid; ++i) {
		dj[i] = bias ? -pass->soft.impulse_scale * cni_wide_load(k->j[i] + l) : cni_wide_of(0.0f);
		for (n = 0; n < rigid; ++n)
			dj[i] -= cni_wide_load(k->inverse[wide_inverse_at[i][n]] + l) * want[n];
	}
	for (i = 0; i < rigid; ++i) {
		impulse_add(k->j[i] + l, dj[i]);
		row_push(&r[i], dj[i], a, b);
	}
}

CNI_INLINE void rows_solve(cni_row_block *k, int32_t l, int32_t form, side *a, side *b, const cni_joint_pass *pass, int32_t bias)
{
	if (bias && (k->has & CN_JOINT_SPRING))
		spring_solve(k, l, a, b);
	if (k->has & CN_JOINT_MOTOR)
		motor_solve(k, l, cni_form_motor_row(form), a, b, pass, bias);
	if (k->has & CN_JOINT_LIMIT)
		limit_solve(k, l, a, b, pass, bias);
	rigid_solve(k, l, cni_form_rigid_rows(form), a, b, pass, bias);
}

CNI_INLINE void solve_form(cni_motion *motions, cni_row_block *k, const cni_joint_pass *pass, int32_t form)
{
	int32_t l;
	for (l = 0; l < k->lanes; l += CNI_WIDTH) {
		side a, b;
		sides_gather(motions, k, l, &a, &b);
		rows_solve(k, l, form, &a, &b, pass, 1);
		sides_scatter(motions, k, l, &a, &b);
	}
}

static void row_lanes_solve(cni_motion *motions, cni_velocity_start *starts, cni_row_block *k, const cni_joint_pass *pass)
{
	(void)starts;
#if CNI_WIDTH == 1
	solve_form(motions, k, pass, k->form); /* compiled once: this path runs few lanes */
#else
	switch (k->form) {
	case CNI_FORM_ROD: solve_form(motions, k, pass, CNI_FORM_ROD); break;
	case CNI_FORM_TIE: solve_form(motions, k, pass, CNI_FORM_TIE); break;
	case CNI_FORM_WELD: solve_form(motions, k, pass, CNI_FORM_WELD); break;
	case CNI_FORM_SOFT_WELD: solve_form(motions, k, pass, CNI_FORM_SOFT_WELD); break;
	case CNI_FORM_SLIDE: solve_form(motions, k, pass, CNI_FORM_SLIDE); break;
	default: solve_form(motions, k, pass, CNI_FORM_WHEEL); break;
	}
#endif
}

/* ---- new positions ---- */

/* Moves an impulse from the old row to the new one and applies the difference. Returns the impulse, which is 0 if the row reversed its
   direction. sign, old_sign: of the rows. */
CNI_INLINE cni_wide impulse_turn(const wide_row *r, cni_wide sign, const wide_row *old, cni_wide old_sign, cni_wide impulse, side *a, side *b)
{
	const cni_wide zero = cni_wide_of(0.0f);
	row_push(old, old_sign * -impulse, a, b);
	impulse = cni_wide_select(sign * old_sign * row_dot(r, old) < zero, zero, impulse);
	row_push(r, sign * impulse, a, b);
	return impulse;
}

CNI_INLINE void impulses_turn(cni_row_block *k, int32_t l, int32_t form, const wide_rows *g, side *a, side *b)
{
	const cni_wide one = cni_wide_of(1.0f);
	int32_t rigid = cni_form_rigid_rows(form), motor = cni_form_motor_row(form), i;
	for (i = 0; i < rigid; ++i) {
		wide_row old = row_load(&k->rigid[i], l);
		cni_wide_store(k->j[i] + l, impulse_turn(&g->rigid[i], one, &old, one, cni_wide_load(k->j[i] + l), a, b));
	}
	if (k->has & CN_JOINT_SPRING) {
		wide_row old = row_load(&k->free[0], l);
		cni_wide_store(k->spring_j + l, impulse_turn(&g->free[0], one, &old, one, cni_wide_load(k->spring_j + l), a, b));
	}
	if (k->has & CN_JOINT_MOTOR) {
		wide_row old = row_load(&k->free[motor], l);
		cni_wide_store(k->motor_j + l, impulse_turn(&g->free[motor], one, &old, one, cni_wide_load(k->motor_j + l), a, b));
	}
	if (k->has & CN_JOINT_LIMIT) {
		wide_row old = row_load(&k->free[0], l);
		cni_wide low = g->measure - cni_wide_load(k->lower + l), high = cni_wide_load(k->upper + l) - g->measure;
		cni_wide sign = cni_wide_select(low <= high, one, cni_wide_of(-1.0f));
		cni_wide_store(k->limit_j + l, impulse_turn(&g->free[0], sign, &old, cni_wide_load(k->side + l), cni_wide_load(k->limit_j + l), a, b));
	}
}

CNI_INLINE void start_change(cni_velocity_start *starts, const int32_t *index, uint32_t moves, const side *change)
{
	cni_wide vx, vy, w, jumped;
	cni_wide_gather4((const float *)(const void *)starts, START_FLOATS, index, &vx, &vy, &w, &jumped);
	moving_scatter((float *)(void *)starts, START_FLOATS, index, moves, vx - change->vx, vy - change->vy, w - change->w, jumped);
}

CNI_INLINE void relax_form(cni_motion *motions, cni_velocity_start *starts, cni_row_block *k, const cni_joint_pass *pass, int32_t form)
{
	const cni_wide zero = cni_wide_of(0.0f);
	int32_t l;
	for (l = 0; l < k->lanes; l += CNI_WIDTH) {
		side a, b, change_a, change_b;
		wide_rows g;
		cni_wide shares[CNI_FREE_ROWS][CNI_JOINT_RIGID_ROWS];
		sides_gather(motions, k, l, &a, &b);
		g = rows_make(motions, k, l, form, &a, &b);
		if (k->has != 0)
			rows_decouple(&g, form, &a, &b, shares);
		change_a = a;
		change_b = b;
		change_a.vx = change_a.vy = change_a.w = change_b.vx = change_b.vy = change_b.w = zero;
		impulses_turn(k, l, form, &g, &change_a, &change_b);
		rows_store(k, l, form, &g, &a, &b);
		start_change(starts, k->ia + l, k->moves_a >> l, &change_a);
		start_change(starts, k->ib + l, k->moves_b >> l, &change_b);
		rows_solve(k, l, form, &a, &b, pass, 0);
		sides_scatter(motions, k, l, &a, &b);
	}
}

static void row_lanes_relax(cni_motion *motions, cni_velocity_start *starts, cni_row_block *k, const cni_joint_pass *pass)
{
#if CNI_WIDTH == 1
	relax_form(motions, starts, k, pass, k->form); /* compiled once: this path runs few lanes */
#else
	switch (k->form) {
	case CNI_FORM_ROD: relax_form(motions, starts, k, pass, CNI_FORM_ROD); break;
	case CNI_FORM_TIE: relax_form(motions, starts, k, pass, CNI_FORM_TIE); break;
	case CNI_FORM_WELD: relax_form(motions, starts, k, pass, CNI_FORM_WELD); break;
	case CNI_FORM_SOFT_WELD: relax_form(motions, starts, k, pass, CNI_FORM_SOFT_WELD); break;
	case CNI_FORM_SLIDE: relax_form(motions, starts, k, pass, CNI_FORM_SLIDE); break;
	default: relax_form(motions, starts, k, pass, CNI_FORM_WHEEL); break;
	}
#endif
}

/* ---- before and after the substeps, for any form ---- */

/* Adds the share of free rows in the rigid rows' impulses (sign 1) or removes it (-1). */
static void impulses_couple(const cni_row_block *k, int32_t l, cni_wide shares[CNI_FREE_ROWS][CNI_JOINT_RIGID_ROWS], cni_wide limit_side, float sign, cni_wide *j)
{
	int32_t rigid = cni_form_rigid_rows(k->form), motor = cni_form_motor_row(k->form), i;
	for (i = 0; k->has != 0 && i < rigid; ++i) {
		j[i] += sign * shares[0][i] * cni_wide_load(k->spring_j + l);
		j[i] += sign * shares[motor][i] * cni_wide_load(k->motor_j + l);
		j[i] += sign * (limit_side * shares[0][i]) * cni_wide_load(k->limit_j + l);
	}
}

static void row_lanes_begin(cni_motion *motions, cni_velocity_start *starts, cni_row_block *k, const cni_joint_pass *pass)
{
	int32_t l, i;
	(void)starts;
	(void)pass;
	for (l = 0; l < k->lanes; l += CNI_WIDTH) {
		side a, b;
		wide_rows g;
		cni_wide shares[CNI_FREE_ROWS][CNI_JOINT_RIGID_ROWS], j[CNI_JOINT_RIGID_ROWS];
		sides_gather(motions, k, l, &a, &b);
		g = rows_make(motions, k, l, k->form, &a, &b);
		if (k->has != 0)
			rows_decouple(&g, k->form, &a, &b, shares);
		rows_store(k, l, k->form, &g, &a, &b);
		for (i = 0; i < CNI_JOINT_RIGID_ROWS; ++i)
			j[i] = cni_wide_load(k->j[i] + l);
		impulses_couple(k, l, shares, cni_wide_load(k->side + l), -1.0f, j);
		for (i = 0; i < CNI_JOINT_RIGID_ROWS; ++i)
			cni_wide_store(k->j[i] + l, j[i]);
	}
}

static void row_lanes_warm(cni_motion *motions, cni_velocity_start *starts, cni_row_block *k, const cni_joint_pass *pass)
{
	int32_t rigid = cni_form_rigid_rows(k->form), motor = cni_form_motor_row(k->form), l, i;
	(void)starts;
	for (l = 0; l < k->lanes; l += CNI_WIDTH) {
		wide_row free = row_load(&k->free[0], l), turned = row_load(&k->free[motor], l);
		side a, b;
		sides_gather(motions, k, l, &a, &b);
		for (i = 0; i < rigid; ++i) {
			wide_row r = row_load(&k->rigid[i], l);
			row_push(&r, impulse_warm(k->j[i] + l, pass->warm_scale), &a, &b);
		}
		if (k->has & CN_JOINT_SPRING)
			row_push(&free, impulse_warm(k->spring_j + l, pass->warm_scale), &a, &b);
		if (k->has & CN_JOINT_MOTOR)
			row_push(&turned, impulse_warm(k->motor_j + l, pass->warm_scale), &a, &b);
		if (k->has & CN_JOINT_LIMIT)
			row_push(&free, cni_wide_load(k->side + l) * impulse_warm(k->limit_j + l, pass->warm_scale), &a, &b);
		sides_scatter(motions, k, l, &a, &b);
	}
}

static void row_lanes_finish(cni_motion *motions, cni_velocity_start *starts, cni_row_block *k, const cni_joint_pass *pass)
{
	int32_t l, i;
	(void)starts;
	(void)pass;
	for (l = 0; l < k->lanes; l += CNI_WIDTH) {
		side a, b;
		wide_rows g;
		cni_wide shares[CNI_FREE_ROWS][CNI_JOINT_RIGID_ROWS], j[CNI_JOINT_RIGID_ROWS];
		for (i = 0; i < CNI_JOINT_RIGID_ROWS; ++i)
			j[i] = cni_wide_load(k->j[i] + l);
		if (k->has != 0) {
			sides_gather(motions, k, l, &a, &b);
			g = rows_make(motions, k, l, k->form, &a, &b);
			rows_decouple(&g, k->form, &a, &b, shares);
			impulses_couple(k, l, shares, cni_wide_load(k->side + l), 1.0f, j);
		}
		for (i = 0; i < CNI_JOINT_RIGID_ROWS; ++i)
			cni_wide_store(k->whole[i] + l, j[i]);
	}
}
