/*
 * stages/joint_solve.c - joints in the soft step: rows to impulses, for every type alike.
 *
 * Each awake joint gets a work item in a dense array: body indices, anchors turned with the bodies, rows. A
 * joint's rigid rows are solved together by the inverse of their K = J M^-1 J^T. Every other row is combined
 * with as much of the rigid ones as keeps their speeds out of it (a Schur complement): the rigid rows and
 * it then do not disturb each other, it meets the mass that really moves, a pinned bar's about its pin, and
 * one pass solves both. Springs use exact discrete coefficients and act in the soft pass only.
 *
 * Anchors turn within the step, so rows are built anew once a substep (before relax; the next substep's solve
 * starts from the same positions). Impulses already given acted along the old rows; the difference
 * M^-1 (Jnew - Jold)^T impulse goes into start, which puts it into the next warm start.
 *
 * Reads records and motion, writes motion velocities, start, the records' impulses.
 */
#include "stages/joint_work.h"

static cni_joint_work *works(const cn_world *world)
{
	return (cni_joint_work *)world->joint_work.data;
}

/* ---- rows ---- */

static float row_mass(const cni_row *r, const cni_row *q, const cni_motion *a, const cni_motion *b)
{
	return a->inv_mass * (r->ax * q->ax + r->ay * q->ay) + a->inv_inertia * r->aw * q->aw +
	       b->inv_mass * (r->bx * q->bx + r->by * q->by) + b->inv_inertia * r->bw * q->bw;
}

static float row_speed(const cni_row *r, const cni_motion *a, const cni_motion *b)
{
	return r->ax * a->vx + r->ay * a->vy + r->aw * a->w + r->bx * b->vx + r->by * b->vy + r->bw * b->w;
}

static void row_push(const cni_row *r, float impulse, cni_motion *a, cni_motion *b)
{
	float ma = a->inv_mass * impulse, mb = b->inv_mass * impulse;
	a->vx += ma * r->ax;
	a->vy += ma * r->ay;
	a->w += a->inv_inertia * impulse * r->aw;
	b->vx += mb * r->bx;
	b->vy += mb * r->by;
	b->w += b->inv_inertia * impulse * r->bw;
}

/* Where element (i, k) of the symmetric inverse is. */
static const uint8_t inverse_at[3][3] = { { 0, 1, 2 }, { 1, 3, 4 }, { 2, 4, 5 } };

/* Inverse of the symmetric K of one to three rigid rows; a singular direction gives nothing. */
static void work_invert(cni_joint_work *w, const cni_motion *a, const cni_motion *b)
{
	const cni_row *r = w->rows;
	float *inv = w->inverse;
	if (w->rigid_count == 1) {
		float k = row_mass(r, r, a, b);
		inv[0] = k > 0.0f ? 1.0f / k : 0.0f;
	} else if (w->rigid_count == 2) {
		float k00 = row_mass(r, r, a, b), k01 = row_mass(r, r + 1, a, b), k11 = row_mass(r + 1, r + 1, a, b);
		float det = k00 * k11 - k01 * k01;
		float d = det > 0.0f ? 1.0f / det : 0.0f;
		inv[0] = k11 * d;
		inv[1] = -k01 * d;
		inv[3] = k00 * d;
	} else if (w->rigid_count == 3) {
		float k00 = row_mass(r, r, a, b), k01 = row_mass(r, r + 1, a, b), k02 = row_mass(r, r + 2, a, b);
		float k11 = row_mass(r + 1, r + 1, a, b), k12 = row_mass(r + 1, r + 2, a, b), k22 = row_mass(r + 2, r + 2, a, b);
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
}

/* The frame now: anchors turned, gap moved by the bodies' changes since the step began. */
static cni_joint_frame work_frame(const cni_joint_work *w, const cni_motion *a, const cni_motion *b)
{
	cni_joint_frame f;
	cni_rot turn_a = cni_rot_small(a->theta), turn_b = cni_rot_small(b->theta);
	f.ra = cni_rotate(turn_a, w->start.ra);
	f.rb = cni_rotate(turn_b, w->start.rb);
	f.d.x = w->start.d.x + (b->dpx - a->dpx) + (f.rb.x - w->start.rb.x) - (f.ra.x - w->start.ra.x);
	f.d.y = w->start.d.y + (b->dpy - a->dpy) + (f.rb.y - w->start.rb.y) - (f.ra.y - w->start.ra.y);
	f.qa = cni_rot_mul(w->start.qa, turn_a);
	f.angle = w->start.angle + (b->theta - a->theta);
	return f;
}

static int32_t row_turned_back(const cni_row *r, const cni_row *old)
{
	return r->bx * old->bx + r->by * old->by + r->bw * old->bw + r->ax * old->ax + r->ay * old->ay + r->aw * old->aw < 0.0f;
}

/* out[i] = how much of rigid row i a row contains: -K_pp^-1 K_pr. */
static void row_shares(const cni_joint_work *w, const cni_row *r, const cni_motion *a, const cni_motion *b, float *out)
{
	float k[CNI_JOINT_RIGID_ROWS];
	int32_t i, l;
	for (i = 0; i < w->rigid_count; ++i)
		k[i] = row_mass(&w->rows[i], r, a, b);
	for (i = 0; i < w->rigid_count; ++i) {
		out[i] = 0.0f;
		for (l = 0; l < w->rigid_count; ++l)
			out[i] -= w->inverse[inverse_at[i][l]] * k[l];
	}
}

static void row_add(cni_row *r, float share, const cni_row *rigid)
{
	r->ax += share * rigid->ax;
	r->ay += share * rigid->ay;
	r->aw += share * rigid->aw;
	r->bx += share * rigid->bx;
	r->by += share * rigid->by;
	r->bw += share * rigid->bw;
}

/* Takes the rigid rows out of row k; its error is that of the type's row: joints are nearly closed. */
static void row_decouple(cni_joint_work *w, int32_t k, const cni_motion *a, const cni_motion *b)
{
	cni_row *r = &w->rows[k];
	float share[CNI_JOINT_RIGID_ROWS], mass;
	int32_t i;
	row_shares(w, r, a, b, share);
	for (i = 0; i < w->rigid_count; ++i)
		row_add(r, share[i], &w->rows[i]);
	mass = row_mass(r, r, a, b);
	w->single_mass[k] = mass > 0.0f ? 1.0f / mass : 0.0f;
}

static void work_build(const cn_world *world, cni_joint_work *w, const cni_motion *a, const cni_motion *b)
{
	const cni_joint *j = cni_joint_at(world, w->joint);
	cni_joint_frame f = work_frame(w, a, b);
	int32_t k;
	w->row_count = cni_joint_type_of(j->type)->rows(j, &f, w->rows);
	w->rigid_count = 0;
	for (k = 0; k < w->row_count; ++k)
		w->rigid_count += w->rows[k].kind == CNI_ROW_RIGID;
	work_invert(w, a, b);
	for (k = w->rigid_count; k < w->row_count; ++k)
		row_decouple(w, k, a, b);
}

/* Impulses between the record, by the type's rows, and the work, by decoupled rows: sign +1 stores, -1 loads. */
static void impulses_recouple(const cn_world *world, const cni_joint_work *w, float sign, float *impulse)
{
	const cni_joint *j = cni_joint_at(world, w->joint);
	const cni_motion *a = cni_motions(world) + w->ia, *b = cni_motions(world) + w->ib;
	cni_joint_frame f = work_frame(w, a, b);
	cni_row rows[CNI_JOINT_ROWS];
	float share[CNI_JOINT_RIGID_ROWS];
	int32_t i, k;
	if (w->rigid_count == 0 || w->rigid_count == w->row_count)
		return;
	cni_joint_type_of(j->type)->rows(j, &f, rows);
	for (k = w->rigid_count; k < w->row_count; ++k) {
		row_shares(w, &rows[k], a, b, share);
		for (i = 0; i < w->rigid_count; ++i)
			impulse[i] += sign * share[i] * impulse[k];
	}
}

void cni_joints_prepare(cn_world *world, const cni_solve *s)
{
	const int32_t *list = (const int32_t *)world->awake_joints.data;
	int32_t k, r;
	for (k = 0; k < world->awake_joints.count; ++k) {
		cni_joint_work *w = works(world) + k;
		const cni_joint *j = cni_joint_at(world, list[k]);
		float impulse[CNI_JOINT_ROWS];
		w->joint = list[k];
		w->ia = j->body[0] == CNI_NONE ? 0 : cni_body_at(world, j->body[0])->awake;
		w->ib = j->body[1] == CNI_NONE ? 0 : cni_body_at(world, j->body[1])->awake;
		w->start = cni_joint_frame_make(world, j);
		work_build(world, w, cni_motions(world) + w->ia, cni_motions(world) + w->ib);
		for (r = 0; r < w->row_count; ++r)
			impulse[r] = j->impulse[w->rows[r].slot];
		impulses_recouple(world, w, -1.0f, impulse);
		for (r = 0; r < w->row_count; ++r) {
			w->rows[r].impulse = impulse[r];
			if (w->rows[r].kind == CNI_ROW_SPRING)
				w->spring = cni_soft_exact(w->rows[r].hertz, w->rows[r].damping_ratio, s->h);
		}
	}
}

void cni_joints_warm_start(cn_world *world, const cni_solve *s)
{
	int32_t k, r;
	for (k = 0; k < world->awake_joints.count; ++k) {
		cni_joint_work *w = works(world) + k;
		for (r = 0; r < w->row_count; ++r) {
			w->rows[r].impulse *= s->warm_scale;
			row_push(&w->rows[r], w->rows[r].impulse, cni_motions(world) + w->ia, cni_motions(world) + w->ib);
		}
	}
}

/* ---- impulses ---- */

static void solve_rigid(cni_joint_work *w, cni_motion *a, cni_motion *b, const cni_soft *soft)
{
	float rhs[CNI_JOINT_RIGID_ROWS];
	int32_t i, k;
	for (i = 0; i < w->rigid_count; ++i)
		rhs[i] = soft->mass_scale * row_speed(&w->rows[i], a, b) + soft->bias_scale * w->rows[i].error;
	for (i = 0; i < w->rigid_count; ++i) {
		float dj = -soft->impulse_scale * w->rows[i].impulse;
		for (k = 0; k < w->rigid_count; ++k)
			dj -= w->inverse[inverse_at[i][k]] * rhs[k];
		w->rows[i].impulse += dj;
		row_push(&w->rows[i], dj, a, b);
	}
}

static void solve_spring(cni_row *r, float mass, cni_motion *a, cni_motion *b, const cni_soft *soft)
{
	float dj = -mass * (soft->mass_scale * row_speed(r, a, b) + soft->bias_scale * r->error) - soft->impulse_scale * r->impulse;
	r->impulse += dj;
	row_push(r, dj, a, b);
}

static void solve_motor(cni_row *r, float mass, cni_motion *a, cni_motion *b, const cni_solve *s)
{
	float most = r->limit * s->h, old = r->impulse;
	r->impulse = cni_clamp(old - mass * (row_speed(r, a, b) - r->target), -most, most);
	row_push(r, r->impulse - old, a, b);
}

/* Room that is left bounds the speed (speculative); beyond the limit it is soft. */
static void solve_limit(cni_row *r, float mass, cni_motion *a, cni_motion *b, const cni_solve *s, int32_t bias)
{
	float speed = row_speed(r, a, b), old = r->impulse, impulse;
	if (r->error > 0.0f)
		impulse = old - mass * (speed + r->error * s->inv_h);
	else if (bias)
		impulse = (1.0f - s->joint.impulse_scale) * old - mass * (s->joint.mass_scale * speed + s->joint.bias_scale * r->error);
	else
		impulse = old - mass * speed;
	r->impulse = cni_max(impulse, 0.0f);
	row_push(r, r->impulse - old, a, b);
}

static void solve_work(cni_joint_work *w, cni_motion *motions, const cni_solve *s, int32_t bias)
{
	static const cni_soft rigid = { 1.0f, 0.0f, 0.0f };
	cni_motion *a = motions + w->ia, *b = motions + w->ib;
	int32_t k;
	for (k = w->rigid_count; k < w->row_count; ++k) {
		cni_row *r = &w->rows[k];
		if (r->kind == CNI_ROW_MOTOR)
			solve_motor(r, w->single_mass[k], a, b, s);
		else if (r->kind == CNI_ROW_LIMIT)
			solve_limit(r, w->single_mass[k], a, b, s, bias);
		else if (bias)
			solve_spring(r, w->single_mass[k], a, b, &w->spring);
	}
	solve_rigid(w, a, b, bias ? &s->joint : &rigid);
}

void cni_joints_solve(cn_world *world, const cni_solve *s)
{
	int32_t k;
	for (k = 0; k < world->awake_joints.count; ++k)
		solve_work(works(world) + k, cni_motions(world), s, 1);
}

/* Builds rows at the new positions and puts what that changes in the impulses' response into start. */
static void work_rebuild(cn_world *world, cni_joint_work *w)
{
	cni_motion *a = cni_motions(world) + w->ia, *b = cni_motions(world) + w->ib;
	cni_motion change_a = *a, change_b = *b;
	cni_velocity_start *sa = cni_starts(world) + w->ia, *sb = cni_starts(world) + w->ib;
	cni_row old[CNI_JOINT_ROWS];
	int32_t k;
	for (k = 0; k < w->row_count; ++k)
		old[k] = w->rows[k];
	work_build(world, w, a, b);
	change_a.vx = change_a.vy = change_a.w = 0.0f;
	change_b.vx = change_b.vy = change_b.w = 0.0f;
	for (k = 0; k < w->row_count; ++k) {
		float impulse = old[k].impulse;
		row_push(&old[k], -impulse, &change_a, &change_b);
		if (row_turned_back(&w->rows[k], &old[k]))
			impulse = 0.0f; /* the limit changed sides */
		w->rows[k].impulse = impulse;
		row_push(&w->rows[k], impulse, &change_a, &change_b);
	}
	sa->vx -= change_a.vx;
	sa->vy -= change_a.vy;
	sa->w -= change_a.w;
	sb->vx -= change_b.vx;
	sb->vy -= change_b.vy;
	sb->w -= change_b.w;
}

void cni_joints_relax(cn_world *world, const cni_solve *s)
{
	int32_t k;
	for (k = 0; k < world->awake_joints.count; ++k) {
		work_rebuild(world, works(world) + k);
		solve_work(works(world) + k, cni_motions(world), s, 0);
	}
}

void cni_joints_store(cn_world *world, const cni_solve *s)
{
	int32_t k, r;
	for (k = 0; k < world->awake_joints.count; ++k) {
		const cni_joint_work *w = works(world) + k;
		cni_joint *j = cni_joint_at(world, w->joint);
		float impulse[CNI_JOINT_ROWS];
		for (r = 0; r < w->row_count; ++r)
			impulse[r] = w->rows[r].impulse;
		impulses_recouple(world, w, 1.0f, impulse);
		for (r = 0; r < CNI_JOINT_ROWS; ++r)
			j->impulse[r] = 0.0f;
		for (r = 0; r < w->row_count; ++r)
			j->impulse[w->rows[r].slot] = impulse[r];
		j->inv_h = s->inv_h;
	}
}
