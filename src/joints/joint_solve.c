/*
 * joints/joint_solve.c - joints in the soft step: from rows (joints/joint_constraint.c) to impulses, for every type alike. Joints in lanes
 * are solved by joints/joint_blocks.c.
 *
 * Bounds on force and torque clamp the total impulse of the first rows: the vector of the linear ones and the angular one. When only one of
 * the two is clamped, the other is solved again with that impulse fixed (projected block Gauss-Seidel), so that a weld at its force limit
 * still holds its angle.
 *
 * Reads records and motion; writes motion velocities and the records' turns; breaks joints whose largest reaction within the step was
 * beyond their threshold.
 */
#include "joints/joints.h"
#include "joints/joint_pass.h"

#define JOINTS_A_RANGE 256
#define FEW_JOINTS_PART 8 /* of the awake bodies: the bodies of so few joints are looked up one by one */

/* ---- the beginning of a step ---- */

typedef struct prepare_loop {
	cn_world *world;
	const cni_solve *s;
	uint32_t filled, special; /* lanes filled again; 1: some are special, struct cni_lane_setup */
} prepare_loop;

static void prepare_range(void *context, int32_t begin, int32_t end)
{
	prepare_loop *loop = (prepare_loop *)context;
	cn_world *world = loop->world;
	struct cni_lane_setup setup = { { 0.0f, 0.0f, { 0.0f, 0.0f, 1.0f } }, world->joint_lanes.lanes > 0, 0, 0 };
	for (int32_t k = begin; k < end; ++k)
		if (!cni_joint_constraint_widen(world, loop->s, &setup, k))
			cni_joint_constraint_prepare(world, loop->s, k);
	cni_atomic_add(&loop->filled, (uint32_t)setup.filled);
	if (setup.special)
		cni_atomic_put(&loop->special, 1);
}

void cni_joints_prepare(cn_world *world, const cni_solve *s)
{
	prepare_loop loop = { world, s, 0, 0 };
	cni_joint_blocks_begin(world);
	cni_parallel_for(world, world->awake_joints.count, JOINTS_A_RANGE, prepare_range, &loop);
	world->joint_lanes.filled = (int32_t)loop.filled;
	world->joint_lanes.special = (int32_t)loop.special;
}

void cni_joints_warm_start(cn_world *world, const cni_solve *s)
{
	cni_joint_constraint *w;
	for (int32_t k = world->joint_plain_first; k != CNI_NONE; k = w->next_plain) {
		w = cni_joint_constraints(world) + k;
		for (int32_t r = 0; r < w->row_count; ++r) {
			w->rows[r].impulse *= s->joint_warm_scale;
			cni_lever_push(&w->rows[r].lever, w->rows[r].impulse, cni_motions(world) + w->ia, cni_motions(world) + w->ib);
		}
	}
	cni_joint_blocks_run(world, s, s->joint_kernel->warm, 0);
}

/* ---- impulses ---- */

/* Impulse changes of `count` rows that are solved together. */
CNI_INLINE void block_solve(const cni_row *rows, int32_t count, const float *inverse, const cni_motion *a, const cni_motion *b, const cni_soft *soft, float *dj)
{
	float rhs[CNI_JOINT_RIGID_ROWS];
	for (int32_t i = 0; i < count; ++i)
		rhs[i] = soft->mass_scale * cni_lever_speed(&rows[i].lever, a, b) + soft->bias_scale * rows[i].error;
	for (int32_t i = 0; i < count; ++i) {
		dj[i] = -soft->impulse_scale * rows[i].impulse;
		for (int32_t k = 0; k < count; ++k)
			dj[i] -= inverse[cni_inverse_at(i, k)] * rhs[k];
	}
}

CNI_INLINE void block_push(cni_row *rows, int32_t count, const float *dj, cni_motion *a, cni_motion *b)
{
	for (int32_t i = 0; i < count; ++i) {
		rows[i].impulse += dj[i];
		cni_lever_push(&rows[i].lever, dj[i], a, b);
	}
}

/* Clamps the length of the rows' total impulse to most. Returns 1 when it was clamped. */
static int32_t block_clamp(const cni_row *rows, int32_t count, float most, float *dj)
{
	float sum_sq = 0.0f, scale;
	for (int32_t i = 0; i < count; ++i)
		sum_sq += (rows[i].impulse + dj[i]) * (rows[i].impulse + dj[i]);
	if (sum_sq <= most * most)
		return 0;
	scale = most / cni_sqrt(sum_sq);
	for (int32_t i = 0; i < count; ++i)
		dj[i] = scale * (rows[i].impulse + dj[i]) - rows[i].impulse;
	return 1;
}

/* Solves some of the first rows with the others fixed. */
static void solve_part(cni_joint_constraint *w, int32_t first, int32_t count, float most, cni_motion *a, cni_motion *b, const cni_soft *soft)
{
	float inverse[6], dj[CNI_JOINT_RIGID_ROWS];
	cni_row *rows = w->rows + first;
	cni_rows_invert(rows, count, a, b, cni_mobility_least(w, a, b), inverse);
	block_solve(rows, count, inverse, a, b, soft, dj);
	block_clamp(rows, count, most, dj);
	block_push(rows, count, dj, a, b);
}

static void solve_bounded(cni_joint_constraint *w, cni_motion *a, cni_motion *b, const cni_soft *soft, float h)
{
	float most_linear = w->numbers->force_max * h, most_angular = w->numbers->torque_max * h, dj[CNI_JOINT_RIGID_ROWS];
	int32_t linear = 0, angular, over_linear, over_angular;
	while (linear < w->rigid_count && !w->rows[linear].angular)
		++linear;
	angular = w->rigid_count - linear;
	block_solve(w->rows, w->rigid_count, w->numbers->inverse, a, b, soft, dj);
	over_linear = block_clamp(w->rows, linear, most_linear, dj);
	over_angular = block_clamp(w->rows + linear, angular, most_angular, dj + linear);
	if (over_linear && !over_angular && angular > 0) {
		block_push(w->rows, linear, dj, a, b);
		solve_part(w, linear, angular, most_angular, a, b, soft);
	} else if (over_angular && !over_linear && linear > 0) {
		block_push(w->rows + linear, angular, dj + linear, a, b);
		solve_part(w, 0, linear, most_linear, a, b, soft);
	} else {
		block_push(w->rows, w->rigid_count, dj, a, b);
	}
}

static void solve_rigid(cni_joint_constraint *w, cni_motion *a, cni_motion *b, const cni_soft *soft, float h)
{
	float dj[CNI_JOINT_RIGID_ROWS];
	if (w->flags & CNI_CONSTRAINT_BOUNDED) {
		solve_bounded(w, a, b, soft, h);
	} else if (w->rigid_count == 2) { /* the same with a count known to the compiler */
		block_solve(w->rows, 2, w->numbers->inverse, a, b, soft, dj);
		block_push(w->rows, 2, dj, a, b);
	} else {
		block_solve(w->rows, w->rigid_count, w->numbers->inverse, a, b, soft, dj);
		block_push(w->rows, w->rigid_count, dj, a, b);
	}
}

/* A soft row is clamped to its limit; a spring has none. */
static void solve_spring(cni_row *r, float mass, cni_motion *a, cni_motion *b, const cni_soft *soft, float h)
{
	float dj = -mass * (soft->mass_scale * cni_lever_speed(&r->lever, a, b) + soft->bias_scale * r->error) - soft->impulse_scale * r->impulse;
	if (r->limit > 0.0f)
		dj = cni_clamp(r->impulse + dj, -r->limit * h, r->limit * h) - r->impulse;
	r->impulse += dj;
	cni_lever_push(&r->lever, dj, a, b);
}

static void solve_motor(cni_row *r, float mass, cni_motion *a, cni_motion *b, const cni_solve *s, int32_t bias)
{
	float most = r->limit * s->h, old = r->impulse;
	r->impulse = cni_clamp(old - mass * (cni_lever_speed(&r->lever, a, b) - cni_motor_target(r, s->inv_h, cni_soft_error_rate(&s->joint, bias))), -most, most);
	cni_lever_push(&r->lever, r->impulse - old, a, b);
}

/* A remaining gap bounds the speed (speculative); beyond the limit the row is soft. */
static void solve_limit(const cni_joint_constraint *w, cni_row *r, float mass, cni_motion *a, cni_motion *b, const cni_solve *s, int32_t bias)
{
	const cni_soft *soft = (w->flags & CNI_CONSTRAINT_SPRINGY) ? &w->numbers->soft : &s->joint;
	float speed, old = r->impulse, impulse;
	if (!bias && r->error <= 0.0f && (w->flags & CNI_CONSTRAINT_SPRINGY))
		return;
	speed = cni_lever_speed(&r->lever, a, b);
	if (r->error > 0.0f)
		impulse = old - mass * (speed + r->error * s->inv_h);
	else if (bias)
		impulse = (1.0f - soft->impulse_scale) * old - mass * (soft->mass_scale * speed + soft->bias_scale * r->error);
	else
		impulse = old - mass * speed;
	r->impulse = cni_max(impulse, 0.0f);
	if (w->flags & CNI_CONSTRAINT_BOUNDED)
		r->impulse = cni_min(r->impulse, (r->angular ? w->numbers->torque_max : w->numbers->force_max) * s->h);
	cni_lever_push(&r->lever, r->impulse - old, a, b);
}

static void solve_constraint(cni_joint_constraint *w, cni_motion *motions, const cni_solve *s, int32_t bias)
{
	static const cni_soft rigid = { 1.0f, 0.0f, 0.0f };
	cni_motion *a = motions + w->ia, *b = motions + w->ib;
	for (int32_t k = w->rigid_count; k < w->row_count; ++k) {
		cni_row *r = &w->rows[k];
		if (k == w->active_row || k == w->idle_row)
			continue;
		if (r->kind == CNI_ROW_MOTOR)
			solve_motor(r, w->numbers->single_mass[k], a, b, s, bias);
		else if (r->kind == CNI_ROW_LIMIT)
			solve_limit(w, r, w->numbers->single_mass[k], a, b, s, bias);
		else if (bias)
			solve_spring(r, w->numbers->single_mass[k], a, b, &w->numbers->spring, s->h);
	}
	if (w->flags & CNI_CONSTRAINT_DIRECT)
		return;
	if (!(w->flags & CNI_CONSTRAINT_SPRINGY))
		solve_rigid(w, a, b, bias ? &s->joint : &rigid, s->h);
	else if (bias)
		solve_rigid(w, a, b, &w->numbers->soft, s->h);
}

void cni_joints_solve(cn_world *world, const cni_solve *s)
{
	for (int32_t k = world->joint_plain_first; k != CNI_NONE; k = cni_joint_constraints(world)[k].next_plain)
		solve_constraint(cni_joint_constraints(world) + k, cni_motions(world), s, 1);
	cni_joint_blocks_run(world, s, s->joint_kernel->solve, 0);
}

/* The body at the other end of one of its joints, which are all soft; 0: the world, or an immovable body. CNI_NONE: it has exact joints, which
   would not hold. */
static int32_t soft_partner(const cn_world *world, int32_t index)
{
	const cni_body *b = cni_body_at(world, cni_awake_ids(world)[index]);
	int32_t partner = 0;
	for (int32_t key = b->joint_first; key != CNI_NONE; key = cni_joint_at(world, key >> 1)->next[key & 1]) {
		int32_t at = cni_joint_at(world, key >> 1)->awake;
		if (at == CNI_NONE)
			continue;
		const cni_joint_constraint *w = cni_joint_constraints(world) + at;
		if (w->flags & CNI_CONSTRAINT_DIRECT)
			return CNI_NONE;
		if (partner == 0)
			partner = w->ia == index ? w->ib : w->ia;
	}
	return partner;
}

static void turn_limit(cn_world *world, int32_t index, float most)
{
	cni_motion *m = cni_motions(world) + index, *other;
	float change = m->w - cni_starts(world)[index].w, denied = change - cni_clamp(change, -most, most);
	int32_t partner = denied != 0.0f ? soft_partner(world, index) : CNI_NONE;
	if (partner == CNI_NONE)
		return;
	other = cni_motions(world) + partner;
	m->w -= denied;
	if (m->inv_inertia > 0.0f && other->inv_inertia > 0.0f)
		other->w += denied * other->inv_inertia / m->inv_inertia;
}

/* Only bodies that turn far are looked at. */
CNI_INLINE void turn_check(cn_world *world, int32_t index, float most)
{
	uint32_t jointed = CNI_EXTERNAL_JOINTED, kinds = jointed | CNI_EXTERNAL_FINISHED;
	if (cni_abs(cni_motions(world)[index].w) > most && (cni_externals(world)[index].flags & kinds) == jointed)
		turn_limit(world, index, most);
}

/*
 * Soft joints turn no body by more than CNI_JOINT_TURN_MOST in a substep beyond what it turned before: they would turn light parts among heavy
 * ones so far that their rows, which are linear, put energy into them. What a body is denied its neighbour takes, so that angular momentum
 * stays. (Box2D limits the turn itself.)
 */
void cni_joints_limit_turns(cn_world *world, const cni_solve *s)
{
	const cni_joint_constraint *w = cni_joint_constraints(world);
	float most = CNI_JOINT_TURN_MOST * s->inv_h;
	int32_t joints = world->awake_joints.count, few = joints < world->awake_count / FEW_JOINTS_PART;
	for (int32_t k = 0; few && k < joints; ++k) {
		turn_check(world, w[k].ia, most);
		turn_check(world, w[k].ib, most);
	}
	for (int32_t k = 1; !few && k < world->awake_count; ++k)
		turn_check(world, k, most);
}

void cni_joints_solve_fresh(cn_world *world, const cni_solve *s, int32_t constraints)
{
	for (int32_t k = 0; k < world->awake_joints.count; ++k) {
		cni_joint_constraint *w = cni_joint_constraints(world) + k;
		if (cni_joint_is_constraint(cni_joint_at(world, w->joint)->type) != constraints)
			continue;
		for (int32_t r = 0; r < w->row_count; ++r)
			w->rows[r].impulse = 0.0f;
		solve_constraint(w, cni_motions(world), s, 1);
	}
}

static int32_t changes_by(const cni_motion *before, const cni_motion *after, float speed)
{
	return cni_max(cni_abs(after->vx - before->vx), cni_abs(after->vy - before->vy)) > speed;
}

/* Returns 1 when a joint of a small island changed a velocity by more than restless_speed. again: joints of small islands alone. */
static int32_t plain_relax(cn_world *world, const cni_solve *s, int32_t again)
{
	int32_t restless = 0;
	cni_joint_constraint *w;
	for (int32_t k = world->joint_plain_first; k != CNI_NONE; k = w->next_plain) {
		w = cni_joint_constraints(world) + k;
		if (again && !cni_joint_is_of_small(world, w))
			continue;
		if (!again)
			cni_joint_rows_renew(world, s, w);
		cni_motion a = cni_motions(world)[w->ia];
		cni_motion b = cni_motions(world)[w->ib];
		solve_constraint(w, cni_motions(world), s, 0);
		if (!restless && (changes_by(&a, cni_motions(world) + w->ia, s->restless_speed) || changes_by(&b, cni_motions(world) + w->ib, s->restless_speed)))
			restless = cni_joint_is_of_small(world, w);
	}
	return restless;
}

/*
 * A relax pass that changes velocities much leaves much: one does not take out of a linkage with loops what the soft pass put in, and a strong
 * motor drives its energy up from step to step. So the pass is repeated while it does, for joints of small islands. A large net converges in no
 * number of passes, and more of them take from its tension what holds it.
 */
void cni_joints_relax(cn_world *world, const cni_solve *s)
{
	int32_t restless = 1;
	for (int32_t round = 0; round < CNI_JOINT_RELAX_ROUNDS && restless; ++round)
		restless = plain_relax(world, s, round > 0) | cni_joint_blocks_relax(world, s, round > 0);
}

void cni_joints_stress(cn_world *world, const cni_solve *s)
{
	cni_joint_constraint *w;
	for (int32_t k = world->joint_plain_first; k != CNI_NONE; k = w->next_plain) {
		w = cni_joint_constraints(world) + k;
		if (w->flags & CNI_CONSTRAINT_BREAKABLE)
			cni_joint_constraint_stress(w, cni_motions(world), s->inv_h);
	}
}

/* ---- the end of a step ---- */

static int32_t is_beyond(const cni_joint_constraint *w, const cni_joint *j)
{
	return (j->break_force > 0.0f && w->numbers->force_stress > j->break_force) || (j->break_torque > 0.0f && w->numbers->torque_stress > j->break_torque);
}

void cni_joints_store(cn_world *world, const cni_solve *s)
{
	world->stressed_joints = 0;
	for (int32_t k = 0; k < world->awake_joints.count; ++k) {
		cni_joint_constraint *w = cni_joint_constraints(world) + k;
		if (w->lane != CNI_NONE)
			continue;
		cni_joint *j = cni_joint_at(world, w->joint);
		cni_joint_rows_end(world, w, j);
		j->inv_h = s->inv_h;
		j->trust.direct = (w->flags & CNI_CONSTRAINT_DIRECT) != 0;
		if (cni_joint_type_of(j->type)->uses & CNI_USES_TURNS)
			cni_joint_turns_advance(world, j, cni_motions(world)[w->ia].theta, cni_motions(world)[w->ib].theta);
		if (w->flags & CNI_CONSTRAINT_BREAKABLE) {
			if (!(w->flags & CNI_CONSTRAINT_FINISHED))
				cni_joint_constraint_stress(w, cni_motions(world), s->inv_h);
			world->stressed_joints += is_beyond(w, j);
		}
	}
	cni_joint_blocks_store(world, s);
}

/* ---- breaking ---- */

static void joint_break(cn_world *world, const cni_joint_constraint *w)
{
	uint32_t breaks = (cni_joint_at(world, w->joint)->flags & CN_JOINT_BREAKS) != 0;
	cni_joint_event_log(world, w->joint, w->numbers->force_stress, w->numbers->torque_stress, breaks);
	if (!breaks)
		return;
	cni_joint_let_go(world, w->joint);
	cni_joint_destroy(world, w->joint);
}

/* Backwards, because destroying a joint moves the last one of the awake list to its place. */
void cni_joints_break(cn_world *world)
{
	if (world->stressed_joints == 0)
		return;
	world->stressed_joints = 0;
	for (int32_t k = world->awake_joints.count - 1; k >= 0; --k) {
		const cni_joint_constraint *w = cni_joint_constraints(world) + k;
		if ((w->flags & CNI_CONSTRAINT_BREAKABLE) && is_beyond(w, cni_joint_at(world, w->joint)))
			joint_break(world, w);
	}
}
