/*
 * joints/joint_constraint.c - joint constraints of awake joints: body indices, rotated anchors, rows, for every type alike.
 *
 * A joint's rigid rows are solved together by the inverse of their K = J M^-1 J^T. Every other row is decoupled: a combination of the rigid
 * rows is added so that their speeds do not enter it (a Schur complement). The rigid rows and the decoupled one then do not disturb each
 * other, the latter has the true effective mass (of a pinned bar: about its pin), and one pass solves both. Springs use exact discrete
 * coefficients and act in the soft pass only; so do rigid rows and violated limits with a stiffness of their own, by implicit coefficients.
 *
 * Anchors turn within the step, so rows are built anew once a substep (before relax; the next substep's solve starts from the same
 * positions). Impulses already applied acted along the old rows; the difference M^-1 (Jnew - Jold)^T impulse goes into start, which adds it
 * to the next warm start.
 *
 * Reads records and motion; writes joint constraints, start, the records' impulses.
 */
#include "joints/joint_constraint.h"
#include "model/tuning.h"

/* ---- masses ---- */

static float mass_of(const cni_row *r, int32_t i, int32_t k, const cni_motion *a, const cni_motion *b)
{
	return cni_lever_mass(&r[i].lever, &r[k].lever, a, b);
}

cni_mobility cni_mobility_least(const cni_joint_constraint *w, const cni_motion *a, const cni_motion *b)
{
	float turns = a->inv_inertia + b->inv_inertia, moves = a->inv_mass + b->inv_mass;
	int32_t locked = (w->flags & CNI_CONSTRAINT_LOCKS) || turns == 0.0f;
	cni_mobility least = { locked ? CNI_MOBILITY_LEAST_PART * moves : 0.0f, locked ? CNI_MOBILITY_LEAST_PART * (turns > 0.0f ? turns : moves) : 0.0f };
	return least;
}

static float least_of(cni_mobility least, const cni_row *r) { return r->angular ? least.angular : least.linear; }

/* From M = (K + least)^-1 to M K M, which is K^-1 but for directions without mobility, where it is 0. */
static void inverse_filter(const cni_row *r, int32_t count, cni_mobility least, float *inv)
{
	float m[6];
	memcpy(m, inv, sizeof m);
	for (int32_t i = 0; i < count; ++i)
		for (int32_t k = i; k < count; ++k)
			for (int32_t l = 0; l < count; ++l)
				inv[cni_inverse_at(i, k)] -= least_of(least, &r[l]) * m[cni_inverse_at(i, l)] * m[cni_inverse_at(l, k)];
}

void cni_rows_invert(const cni_row *r, int32_t count, const cni_motion *a, const cni_motion *b, cni_mobility least, float *inv)
{
	if (count == 1) {
		float k = mass_of(r, 0, 0, a, b) + least_of(least, &r[0]);
		inv[0] = k > 0.0f ? 1.0f / k : 0.0f;
	} else if (count == 2) {
		float k00 = mass_of(r, 0, 0, a, b) + least_of(least, &r[0]), k01 = mass_of(r, 0, 1, a, b), k11 = mass_of(r, 1, 1, a, b) + least_of(least, &r[1]);
		float det = k00 * k11 - k01 * k01;
		float d = det > 0.0f ? 1.0f / det : 0.0f;
		inv[0] = k11 * d;
		inv[1] = -k01 * d;
		inv[3] = k00 * d;
	} else if (count == 3) {
		float k00 = mass_of(r, 0, 0, a, b) + least_of(least, &r[0]), k01 = mass_of(r, 0, 1, a, b), k02 = mass_of(r, 0, 2, a, b);
		float k11 = mass_of(r, 1, 1, a, b) + least_of(least, &r[1]), k12 = mass_of(r, 1, 2, a, b), k22 = mass_of(r, 2, 2, a, b) + least_of(least, &r[2]);
		float c00 = k11 * k22 - k12 * k12, c01 = k02 * k12 - k01 * k22, c02 = k01 * k12 - k02 * k11;
		float det = k00 * c00 + k01 * c01 + k02 * c02;
		float d = det > 0.0f ? 1.0f / det : 0.0f;
		inv[0] = c00 * d;
		inv[1] = c01 * d;
		inv[2] = c02 * d;
		inv[3] = (k00 * k22 - k02 * k02) * d;
		inv[4] = (k01 * k02 - k00 * k12) * d;
		inv[5] = (k00 * k11 - k01 * k01) * d;
	}
	if (least.linear > 0.0f)
		inverse_filter(r, count, least, inv);
}

/* ---- frames ---- */

/* The gap, moved by the bodies' displacements since the step began, between anchors at ra and rb now. */
CNI_INLINE cni_vec2 constraint_gap(const cni_joint_constraint *w, const cni_motion *a, const cni_motion *b, cni_vec2 ra, cni_vec2 rb)
{
	return cni_v(w->start.d.x + (b->dpx - a->dpx) + (rb.x - w->start.rb.x) - (ra.x - w->start.ra.x),
		w->start.d.y + (b->dpy - a->dpy) + (rb.y - w->start.rb.y) - (ra.y - w->start.ra.y));
}

/* The present frame: rotated anchors, and the gap. */
CNI_INLINE cni_joint_frame constraint_frame_turned(const cni_joint_constraint *w, const cni_motion *a, const cni_motion *b, cni_rot turn_a, cni_rot turn_b)
{
	cni_joint_frame f;
	f.ra = cni_rotate(turn_a, w->start.ra);
	f.rb = cni_rotate(turn_b, w->start.rb);
	f.d = constraint_gap(w, a, b, f.ra, f.rb);
	f.e = cni_v(0.0f, 0.0f);
	if (w->flags & CNI_CONSTRAINT_GROUNDS) {
		f.d = cni_add(w->start.d, cni_add(cni_v(a->dpx, a->dpy), cni_sub(f.ra, w->start.ra)));
		f.e = cni_add(w->start.e, cni_add(cni_v(b->dpx, b->dpy), cni_sub(f.rb, w->start.rb)));
	}
	f.qa = cni_rot_mul(w->start.qa, turn_a);
	f.angle = w->start.angle + (b->theta - w->start.ratio * a->theta);
	f.ratio = w->start.ratio;
	return f;
}

CNI_INLINE cni_joint_frame constraint_frame(const cni_joint_constraint *w, const cni_motion *a, const cni_motion *b)
{
	return constraint_frame_turned(w, a, b, cni_rot_small(a->theta), cni_rot_small(b->theta));
}

/* ---- rows ---- */

/* out[i]: share of rigid row i in a decoupled row: -K_pp^-1 K_pr. */
static void row_shares(const cni_joint_constraint *w, const cni_row *r, const cni_motion *a, const cni_motion *b, float *out)
{
	float k[CNI_JOINT_RIGID_ROWS];
	for (int32_t i = 0; i < w->rigid_count; ++i)
		k[i] = cni_lever_mass(&w->rows[i].lever, &r->lever, a, b);
	for (int32_t i = 0; i < w->rigid_count; ++i) {
		out[i] = 0.0f;
		for (int32_t l = 0; l < w->rigid_count; ++l)
			out[i] -= w->numbers->inverse[cni_inverse_at(i, l)] * k[l];
	}
}

/* Rigid rows that may yield, by their own stiffness or a bound on their force, must stay coupled to the other rows. */
static int32_t constraint_is_decoupled(const cni_joint_constraint *w)
{
	return w->rigid_count > 0 && w->rigid_count < w->row_count && !(w->flags & (CNI_CONSTRAINT_SPRINGY | CNI_CONSTRAINT_BOUNDED));
}

/* Decouples row k from the rigid rows. Its error stays that of the type's row: joints are nearly closed. */
static void row_decouple(cni_joint_constraint *w, int32_t k, const cni_motion *a, const cni_motion *b)
{
	cni_row *r = &w->rows[k];
	float share[CNI_JOINT_RIGID_ROWS];
	row_shares(w, r, a, b, share);
	for (int32_t i = 0; i < w->rigid_count; ++i)
		cni_lever_add(&r->lever, share[i], &w->rows[i].lever);
}

/* No impulse moves a body along a locked axis, and the body has no speed along it. */
static void rows_lock(cni_row *rows, int32_t count, uint32_t flags)
{
	for (int32_t k = 0; k < count; ++k) {
		cni_lever *l = &rows[k].lever;
		l->ax = flags & CNI_CONSTRAINT_LOCK_A * CN_BODY_LOCK_X ? 0.0f : l->ax;
		l->ay = flags & CNI_CONSTRAINT_LOCK_A * CN_BODY_LOCK_Y ? 0.0f : l->ay;
		l->bx = flags & CNI_CONSTRAINT_LOCK_B * CN_BODY_LOCK_X ? 0.0f : l->bx;
		l->by = flags & CNI_CONSTRAINT_LOCK_B * CN_BODY_LOCK_Y ? 0.0f : l->by;
	}
}

/* Gap of a row, in metres or radians: the error of a rigid one, what a limit is beyond. */
static float row_gap(const cni_row *r)
{
	if (r->kind != CNI_ROW_RIGID && r->kind != CNI_ROW_LIMIT)
		return 0.0f;
	return r->kind == CNI_ROW_LIMIT ? cni_min(r->error, 0.0f) : r->error;
}

/* How much of it the row sees. */
static float row_gap_most(const cni_solve *s, const cni_row *r)
{
	return r->angular ? s->joint_turn_most : s->joint_gap_most;
}

static int32_t row_is_apart(const cni_solve *s, const cni_row *r)
{
	return cni_abs(row_gap(r)) > row_gap_most(s, r);
}

static void rows_bound_gaps(const cni_solve *s, cni_row *rows, int32_t count)
{
	for (int32_t k = 0; k < count; ++k)
		if (row_is_apart(s, &rows[k]))
			rows[k].error = rows[k].error > 0.0f ? row_gap_most(s, &rows[k]) : -row_gap_most(s, &rows[k]);
}

static int32_t rows_make(const cni_joint_constraint *w, const cni_joint_frame *f, cni_row *rows)
{
	int32_t count = w->make_rows(w->record, f, rows);
	if (w->flags & CNI_CONSTRAINT_CENTRED)
		cni_rows_point_centre(rows, f->d);
	if (w->flags & CNI_CONSTRAINT_LOCKS)
		rows_lock(rows, count, w->flags);
	return count;
}

/* The rows stay the same in the same order during a step: the first build sets rigid_count. */
static void rows_build(const cni_solve *s, cni_joint_constraint *w, const cni_motion *a, const cni_motion *b)
{
	cni_joint_frame f = constraint_frame(w, a, b);
	w->row_count = rows_make(w, &f, w->rows);
	if (w->flags & CNI_CONSTRAINT_APART)
		rows_bound_gaps(s, w->rows, w->row_count);
	for (int32_t k = 0; w->rigid_count < 0; ++k)
		if (k == w->row_count || (w->rows[k].kind != CNI_ROW_RIGID && w->rows[k].kind != CNI_ROW_DRIVE))
			w->rigid_count = k;
	cni_mobility least = cni_mobility_least(w, a, b);
	cni_rows_invert(w->rows, w->rigid_count, a, b, least, w->numbers->inverse);
	for (int32_t k = w->rigid_count; k < w->row_count; ++k) {
		if (constraint_is_decoupled(w))
			row_decouple(w, k, a, b);
		float mass = mass_of(w->rows, k, k, a, b);
		w->numbers->single_mass[k] = mass > least_of(least, &w->rows[k]) ? 1.0f / mass : 0.0f;
	}
}

void cni_joint_constraint_rows(cni_joint_constraint *w, const cni_motion *motions, const cni_rot *turns)
{
	const cni_motion *a = motions + w->ia, *b = motions + w->ib;
	if (w->make_rows == cni_joint_revolute_rows) {
		cni_vec2 ra = cni_rotate(turns[w->ia], w->start.ra), rb = cni_rotate(turns[w->ib], w->start.rb);
		cni_rows_point_turn(w->rows, ra, rb, constraint_gap(w, a, b, ra, rb));
	} else {
		cni_joint_frame f = constraint_frame_turned(w, a, b, turns[w->ia], turns[w->ib]);
		(void)rows_make(w, &f, w->rows);
	}
}

void cni_joint_constraint_ahead(const cni_joint_constraint *w, const cni_motion *motions, float h, float *errors)
{
	cni_motion end[2] = { motions[w->ia], motions[w->ib] };
	cni_row rows[CNI_JOINT_ROWS];
	for (int32_t k = 0; k < 2; ++k) {
		end[k].dpx += h * end[k].vx;
		end[k].dpy += h * end[k].vy;
		end[k].theta += h * end[k].w;
	}
	cni_joint_frame f = constraint_frame(w, &end[0], &end[1]);
	if (w->flags & CNI_CONSTRAINT_CENTRED) /* seen as its bodies turn */
		f.d = cni_rotate(cni_rot_small(-0.5f * h * (end[0].w + end[1].w)), f.d);
	(void)w->make_rows(w->record, &f, rows);
	for (int32_t k = 0; k < w->rigid_count; ++k)
		errors[k] = rows[k].error;
}

/* ---- from the record and back ---- */

/* Converts impulses between the record, for the type's rows, and decoupled rows: sign +1 stores, -1 loads. */
static void impulses_recouple(const cni_motion *motions, const cni_joint_constraint *w, float sign, float *impulse)
{
	const cni_motion *a = motions + w->ia, *b = motions + w->ib;
	cni_row rows[CNI_JOINT_ROWS];
	float share[CNI_JOINT_RIGID_ROWS];
	if (!constraint_is_decoupled(w))
		return;
	cni_joint_frame f = constraint_frame(w, a, b);
	(void)rows_make(w, &f, rows);
	for (int32_t k = w->rigid_count; k < w->row_count; ++k) {
		row_shares(w, &rows[k], a, b, share);
		for (int32_t i = 0; i < w->rigid_count; ++i)
			impulse[i] += sign * share[i] * impulse[k];
	}
}

static uint32_t locks_of(const cn_world *world, int32_t body, uint32_t first)
{
	return body == CNI_NONE ? 0u : (cni_body_at(world, body)->flags & (CN_BODY_LOCK_X | CN_BODY_LOCK_Y)) * first;
}

static uint32_t constraint_flags(const cn_world *world, const cni_joint *j)
{
	uint32_t uses = cni_joint_type_of(j->type)->uses, flags = 0;
	if (j->force_max > 0.0f || j->torque_max > 0.0f)
		flags |= CNI_CONSTRAINT_BOUNDED;
	if (j->break_force > 0.0f || j->break_torque > 0.0f)
		flags |= CNI_CONSTRAINT_BREAKABLE;
	if (uses & CNI_USES_GROUNDS)
		flags |= CNI_CONSTRAINT_GROUNDS;
	if (j->stiffness_hertz > 0.0f || (uses & CNI_USES_DRIVE))
		flags |= CNI_CONSTRAINT_SPRINGY;
	return flags | locks_of(world, j->body[0], CNI_CONSTRAINT_LOCK_A) | locks_of(world, j->body[1], CNI_CONSTRAINT_LOCK_B);
}

/* Softness of the first rows and limits, and of the spring. */
static void constraint_soften(cni_joint_constraint *w, const cni_joint *j, const cni_solve *s)
{
	if (cni_joint_type_of(j->type)->uses & CNI_USES_DRIVE)
		w->numbers->soft = cni_soft_exact(w->rows[0].hertz, w->rows[0].damping_ratio, s->h);
	else if (j->stiffness_hertz > 0.0f)
		w->numbers->soft = cni_soft_row(j->stiffness_hertz, j->stiffness_damping, s->h);
	for (int32_t r = w->rigid_count; r < w->row_count; ++r) {
		if (w->rows[r].kind == CNI_ROW_SPRING)
			w->numbers->spring = cni_soft_exact(w->rows[r].hertz, w->rows[r].damping_ratio, s->h);
		else if (w->rows[r].kind == CNI_ROW_SOFT)
			w->numbers->spring = cni_soft_row(w->rows[r].hertz, w->rows[r].damping_ratio, s->h);
	}
}

/* A soft joint closes a gap of metres within a step, at hundreds of metres a second, and throws what hangs on it. Motion opens joints too far as
   well, but then their rows must not get weaker: strong motors and nets would part them. */
static void apart_begin(cn_world *world, const cni_solve *s, cni_joint_constraint *w)
{
	cni_row rows[CNI_JOINT_ROWS];
	int32_t count;
	w->start.angle = cni_joint_frame_angle(world, w->record);
	count = w->make_rows(w->record, &w->start, rows);
	for (int32_t k = 0; k < count && !(w->flags & CNI_CONSTRAINT_SPRINGY); ++k)
		if (row_is_apart(s, &rows[k]))
			w->flags |= CNI_CONSTRAINT_APART | (rows[k].kind == CNI_ROW_RIGID ? CNI_CONSTRAINT_TORN : 0u);
	if (!(w->flags & CNI_CONSTRAINT_APART))
		cni_joint_at(world, w->joint)->apart = 0;
}

void cni_joint_constraint_begin(cn_world *world, const cni_solve *s, int32_t k, const cni_joint *j)
{
	cni_joint_constraint *w = cni_joint_constraints(world) + k;
	w->record = j;
	w->make_rows = cni_joint_type_of(j->type)->rows;
	w->numbers = (cni_joint_numbers *)(void *)(cni_joint_constraints(world) + world->joint_work.capacity) + k; /* behind the constraints */
	w->rows = w->numbers->rows;
	w->joint = ((const int32_t *)world->awake_joints.data)[k];
	w->lane = CNI_NONE;
	w->form = CNI_FORM_NONE;
	w->active_row = w->idle_row = CNI_NONE;
	w->ia = j->body[0] == CNI_NONE ? 0 : cni_body_at(world, j->body[0])->awake;
	w->ib = j->body[1] == CNI_NONE ? 0 : cni_body_at(world, j->body[1])->awake;
	w->flags = constraint_flags(world, j);
	w->start = cni_joint_frame_place(world, j);
	if (j->apart)
		apart_begin(world, s, w);
}

static void rows_begin(cn_world *world, const cni_solve *s, cni_joint_constraint *w)
{
	const cni_joint *j = w->record;
	float impulse[CNI_JOINT_ROWS];
	w->rigid_count = -1;
	rows_build(s, w, cni_motions(world) + w->ia, cni_motions(world) + w->ib);
	constraint_soften(w, j, s);
	if (w->flags & CNI_CONSTRAINT_BOUNDED) {
		w->numbers->force_max = j->force_max > 0.0f ? j->force_max : FLT_MAX;
		w->numbers->torque_max = j->torque_max > 0.0f ? j->torque_max : FLT_MAX;
	}
	if (w->flags & CNI_CONSTRAINT_BREAKABLE)
		w->numbers->force_stress = w->numbers->torque_stress = 0.0f;
	for (int32_t r = 0; r < w->row_count; ++r)
		impulse[r] = j->impulse[w->rows[r].slot];
	impulses_recouple(cni_motions(world), w, -1.0f, impulse);
	for (int32_t r = 0; r < w->row_count; ++r)
		w->rows[r].impulse = impulse[r];
}

void cni_joint_rows_need(cn_world *world, const cni_solve *s, cni_joint_constraint *w)
{
	if (w->form != CNI_FORM_NONE && w->row_count == 0)
		rows_begin(world, s, w);
}

void cni_joint_rows_centre(cn_world *world, const cni_solve *s, cni_joint_constraint *w)
{
	if (w->record->type != CN_JOINT_REVOLUTE && w->record->type != CN_JOINT_FIXED)
		return;
	w->flags |= CNI_CONSTRAINT_CENTRED;
	rows_begin(world, s, w);
}

/* Not where both limits are near: the row that acts may be either. */
void cni_joint_rope_mark(const cn_world *world, cni_joint_constraint *w, float dt)
{
	const cni_joint *j = w->record;
	const cni_motion *a = cni_motions(world) + w->ia, *b = cni_motions(world) + w->ib;
	float length, speed, near;
	if (CNI_ON(ACTIVE_ROWS) && cni_joint_is_cylinder(j))
		w->flags |= CNI_CONSTRAINT_TAUT;
	if (!CNI_ON(DIRECT_ROPES) || !cni_joint_is_rope(j))
		return;
	cni_vec2 axis = cni_distance_axis(w->start.d, &length);
	speed = cni_dot(axis, cni_v(b->vx - a->vx, b->vy - a->vy)) + b->w * cni_cross(w->start.rb, axis) - a->w * cni_cross(w->start.ra, axis);
	near = CNI_LIMIT_ROOM * world->settings.length_unit + 2.0f * dt * cni_abs(speed);
	if (j->p[CNI_P_UPPER] - length < near && length - j->p[CNI_P_LOWER] > near)
		w->flags |= CNI_CONSTRAINT_TAUT;
}

void cni_joint_constraint_prepare(cn_world *world, const cni_solve *s, int32_t k)
{
	cni_joint_constraint *w = cni_joint_constraints(world) + k;
	cni_joint_constraint_begin(world, s, k, cni_joint_at(world, ((const int32_t *)world->awake_joints.data)[k]));
	w->start.angle = cni_joint_frame_angle(world, w->record);
	cni_joint_rope_mark(world, w, s->dt);
	rows_begin(world, s, w);
}

void cni_joint_rows_end(const cn_world *world, const cni_joint_constraint *w, cni_joint *j)
{
	float impulse[CNI_JOINT_ROWS];
	for (int32_t r = 0; r < w->row_count; ++r)
		impulse[r] = w->rows[r].impulse;
	impulses_recouple(cni_motions(world), w, 1.0f, impulse);
	for (int32_t r = 0; r < CNI_JOINT_ROWS; ++r)
		j->impulse[r] = 0.0f;
	for (int32_t r = 0; r < w->row_count; ++r)
		j->impulse[w->rows[r].slot] = impulse[r];
	cni_joint_keep_finite(j);
}

/* ---- within the step ---- */

/* A directly solved pin without other rows. Its inverse, which nothing reads while it is, stays that of the step's beginning. */
static void pin_renew(cn_world *world, cni_joint_constraint *w)
{
	const cni_motion *a = cni_motions(world) + w->ia, *b = cni_motions(world) + w->ib;
	cni_vec2 ra = cni_rotate(cni_rot_small(a->theta), w->start.ra), rb = cni_rotate(cni_rot_small(b->theta), w->start.rb);
	const cni_lever *x = &w->rows[0].lever, *y = &w->rows[1].lever;
	float jx = w->rows[0].impulse, jy = w->rows[1].impulse, turn_a = x->aw * jx + y->aw * jy, turn_b = x->bw * jx + y->bw * jy;
	cni_rows_point_turn(w->rows, ra, rb, constraint_gap(w, a, b, ra, rb));
	if (w->flags & CNI_CONSTRAINT_CENTRED)
		cni_rows_point_centre(w->rows, cni_v(w->rows[0].error, w->rows[1].error));
	cni_starts(world)[w->ia].w -= a->inv_inertia * (x->aw * jx + y->aw * jy - turn_a);
	cni_starts(world)[w->ib].w -= b->inv_inertia * (x->bw * jx + y->bw * jy - turn_b);
}

static void rows_renew(cn_world *world, const cni_solve *s, cni_joint_constraint *w)
{
	cni_motion *a = cni_motions(world) + w->ia, *b = cni_motions(world) + w->ib;
	cni_motion change_a = *a, change_b = *b;
	cni_row old[CNI_JOINT_ROWS];
	for (int32_t k = 0; k < w->row_count; ++k)
		old[k] = w->rows[k];
	rows_build(s, w, a, b);
	change_a.vx = change_a.vy = change_a.w = 0.0f;
	change_b.vx = change_b.vy = change_b.w = 0.0f;
	for (int32_t k = 0; k < w->row_count; ++k) {
		const cni_lever *l = &w->rows[k].lever, *was = &old[k].lever;
		float impulse = old[k].impulse;
		cni_lever_push(was, -impulse, &change_a, &change_b);
		if ((w->rows[k].angular ? l->bw * was->bw : l->bx * was->bx + l->by * was->by + l->ax * was->ax + l->ay * was->ay) < 0.0f)
			impulse = 0.0f; /* the limit changed sides */
		w->rows[k].impulse = impulse;
		cni_lever_push(&w->rows[k].lever, impulse, &change_a, &change_b);
	}
	cni_start_add(cni_starts(world) + w->ia, &change_a, -1.0f);
	cni_start_add(cni_starts(world) + w->ib, &change_b, -1.0f);
}

void cni_joint_rows_renew(cn_world *world, const cni_solve *s, cni_joint_constraint *w)
{
	if (w->make_rows == cni_joint_revolute_rows && w->row_count == 2 && (w->flags & CNI_CONSTRAINT_DIRECT))
		pin_renew(world, w);
	else
		rows_renew(world, s, w);
}

/* Locked levers say nothing of the force that a locked axis bears. */
static void rows_unlock(const cni_joint_constraint *w, const cni_motion *motions, cni_row *rows)
{
	cni_joint_frame f = constraint_frame(w, motions + w->ia, motions + w->ib);
	float impulse[CNI_JOINT_ROWS];
	for (int32_t k = 0; k < w->row_count; ++k)
		impulse[k] = w->rows[k].impulse;
	impulses_recouple(motions, w, 1.0f, impulse);
	(void)w->make_rows(w->record, &f, rows);
	for (int32_t k = 0; k < w->row_count; ++k)
		rows[k].impulse = impulse[k];
}

void cni_joint_constraint_stress(cni_joint_constraint *w, const cni_motion *motions, float inv_h)
{
	cni_vec2 rb = cni_rotate(cni_rot_small(motions[w->ib].theta), w->start.rb), linear;
	cni_row unlocked[CNI_JOINT_ROWS];
	float angular;
	if (w->flags & CNI_CONSTRAINT_LOCKS)
		rows_unlock(w, motions, unlocked);
	cni_rows_impulse(w->flags & CNI_CONSTRAINT_LOCKS ? unlocked : w->rows, w->row_count, rb, &linear, &angular);
	w->numbers->force_stress = cni_max(w->numbers->force_stress, cni_length(linear) * inv_h);
	w->numbers->torque_stress = cni_max(w->numbers->torque_stress, cni_abs(angular) * inv_h);
}
