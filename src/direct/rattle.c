/*
 * direct/rattle.c - bodies that only rigid joints constrain: integrates their whole step with second order and without energy loss.
 *
 * RATTLE (Andersen, 1983; Leimkuhler and Skeel, 1994) with the direct solver, per substep:
 *
 *   v += h/2 a                    half a kick
 *   x += h (v + M^-1 J' mu)       mu such that the joints are closed at the new x (Newton: K mu = -C/h)
 *   v += M^-1 J' mu + h/2 a       the other half
 *   v += M^-1 J' nu               J at the new x; nu such that J v = 0
 *
 * Both start from half of the last substep's impulse, so Newton rarely needs a second round. With dampers they start from zero: dampers
 * need the whole tension. A substep has one factorization: K at the old x, for mu, is that of the last substep's nu. A substep closes a
 * part of old gaps; nu removes the closing speed.
 *
 * Joints alone add no energy. An account holds the energy gain of a step beyond the work of external accelerations; the joints carry it
 * (cni_joint_trust). The method's energy oscillates about the true one by the square of the substep, so the account may be that large and
 * no larger; the excess is taken out of the velocities. So energy cannot creep, step by step.
 *
 * A step that does not close its joints, or gains much energy, is repeated with twice the substeps, as far as the work of the step allows
 * (CNI_RATTLE_WORK), and then by projections: x += h (v + h a), x to the nearest point where the joints are closed, v projected to
 * J v = 0 there. Such a projection cannot raise kinetic energy, so it survives whips that no substep resolves, and loses energy (about
 * (h w)^2 of it a substep). Last, each joint is soft, where a system is beyond the range of floats. The joints remember failures, so that a
 * component that fails again and again does not try everything in every step.
 *
 * The number of substeps follows the geometric stiffness up to a limit; dampers do the rest: direct/geometric_stiffness.c.
 *
 * A taut rope is a rod until it pushes. A loose one becomes taut before the substep that would make it too long.
 *
 * Loops with redundant joints are not for RATTLE: rattle_begin in direct/component_fate.c.
 *
 * Reads joint constraints, externals, motion; writes motion, start, rows and flags of joint constraints, flags of externals.
 */
#include "direct/direct.h"
#include "direct/direct_contact.h"
#include "direct/rattle.h"

#include <string.h>

/* ---- which components ---- */

/* 1: no row but the rigid ones, or that of a rope, can act in this step. */
static int32_t constraint_is_rigid(const cn_world *world, const cni_joint_constraint *w, float dt)
{
	for (int32_t k = w->rigid_count; k < w->row_count; ++k) {
		if (w->rows[k].kind != CNI_ROW_LIMIT || cni_limit_is_near(world, w, k, dt))
			return cni_joint_is_rope(w->record);
	}
	return 1;
}

/* 1: nothing touches the body and only joints of the component constrain it. */
static int32_t only_component_holds(const cn_world *world, int32_t index)
{
	const cni_body *b = cni_body_at(world, cni_awake_ids(world)[index]);
	if (cni_externals(world)[index].flags & CNI_EXTERNAL_TOUCHED)
		return 0;
	for (int32_t key = b->joint_first; key != CNI_NONE; key = cni_joint_at(world, key >> 1)->next[key & 1]) {
		int32_t at = cni_joint_at(world, key >> 1)->awake;
		if (at != CNI_NONE && !(cni_joint_constraints(world)[at].flags & CNI_CONSTRAINT_DIRECT))
			return 0;
	}
	return 1;
}

int32_t cni_component_uses_rattle(cn_world *world, const cni_solve *s, const cni_sparse *sparse, const cni_component *c)
{
	for (int32_t k = c->begin; k < c->end; ++k) {
		const cni_joint *j = cni_joint_constraints(world)[sparse->nodes[k].owner].record;
		if (j->type == CN_JOINT_REVOLUTE && (j->flags & (CN_JOINT_SPRING | CN_JOINT_MOTOR)))
			return 0; /* without building its rows */
	}
	for (int32_t k = c->body_begin; k < c->body_end; ++k)
		if (!only_component_holds(world, sparse->bodies[k]))
			return 0;
	cni_component_rows_need(world, s, sparse, c);
	for (int32_t k = c->begin; k < c->end; ++k)
		if (!constraint_is_rigid(world, &cni_joint_constraints(world)[sparse->nodes[k].owner], s->dt))
			return 0;
	return 1;
}

/* ---- kinematic ends: at constant velocity ---- */

static void base_place(const rattle_step *g, int32_t index)
{
	cni_motion *m = g->motions + index;
	if (index == 0 || m->inv_mass != 0.0f || m->inv_inertia != 0.0f)
		return;
	m->dpx = g->elapsed * m->vx;
	m->dpy = g->elapsed * m->vy;
	m->theta = g->elapsed * m->w;
	g->sparse->turn[index] = cni_rot_small(m->theta);
}

static void bases_place(rattle_step *g, float elapsed)
{
	g->elapsed = elapsed;
	for (int32_t k = g->c->begin; k < g->c->end && g->held; ++k) {
		base_place(g, g->sparse->nodes[k].ia);
		base_place(g, g->sparse->nodes[k].ib);
	}
}

/* ---- one substep ---- */

/* Outcome of a substep: closed, still open after all rounds, or not finite. */
enum { CLOSED_WELL = 0, OPEN = 1, BROKEN = 2 };

/* Applies half of a substep's external acceleration and damping. */
static void kick(const rattle_step *g)
{
	for (int32_t k = g->c->body_begin; k < g->c->body_end; ++k) {
		int32_t index = g->sparse->bodies[k];
		const cni_external *d = cni_externals(g->world) + index;
		cni_motion *m = g->motions + index;
		float half = 0.5f * g->h;
		m->vx += half * d->ax;
		m->vy += half * d->ay;
		m->w += half * d->alpha;
		if (d->flags & CNI_EXTERNAL_DAMPED) {
			const cni_body *b = cni_body_at(g->world, cni_awake_ids(g->world)[index]);
			float linear = cni_damping_factor(b->linear_damping, half);
			m->vx *= linear;
			m->vy *= linear;
			m->w *= cni_damping_factor(b->angular_damping, half);
		}
	}
}

static void drift(rattle_step *g)
{
	bases_place(g, g->elapsed + g->h);
	for (int32_t k = g->c->body_begin; k < g->c->body_end; ++k) {
		cni_motion *m = g->motions + g->sparse->bodies[k];
		m->dpx += g->h * m->vx;
		m->dpy += g->h * m->vy;
		m->theta += g->h * m->w;
	}
}

/* Remainder of an old gap after the substep. A taut rope has no room. */
static float gap_left(const rattle_step *g, const cni_joint_constraint *w, int32_t row)
{
	float error = w->rows[row].error;
	if (cni_abs(error) * cni_row_length(g->world, &w->rows[row]) <= CNI_RATTLE_OLD_GAP * g->closed || (error > 0.0f && cni_joint_is_rope(w->record)))
		return 0.0f;
	return (1.0f - CNI_RATTLE_CLOSING_RATE) * error;
}

static void move(cni_motion *m, const cni_changes *c, float h, float part)
{
	if (!cni_motion_can_move(m))
		return;
	cni_changes_add(c, part, &m->vx, CNI_NODE_ROWS);
	cni_changes_add(c, h, &m->dpx, CNI_NODE_ROWS);
}

/* Applies x of every node to positions, and a part of it (1 or 0) to velocities and impulses. */
static void push_and_move(const rattle_step *g, float part)
{
	for (int32_t k = g->c->begin; k < g->c->end; ++k) {
		cni_node *n = &g->sparse->nodes[k];
		const cni_levers *l = &n->levers;
		cni_motion *a = g->motions + n->ia, *b = g->motions + n->ib;
		cni_four x = cni_four_load(n->x);
		const cni_changes of_a = cni_lever_ends_changes(l->ax, l->ay, l->aw, x, a), of_b = cni_lever_ends_changes(l->bx, l->by, l->bw, x, b);
		move(a, &of_a, g->h, part);
		move(b, &of_b, g->h, part);
		cni_four_store(n->total, cni_four_add(cni_four_load(n->total), cni_four_scale(x, part)));
	}
}

/* Builds the rows at the present positions and sets x to the right sides that close the gaps. Returns the largest gap. */
static float gaps_find(const rattle_step *g)
{
	float largest = 0.0f, inv_h = 1.0f / g->h;
	int32_t i;
	for (int32_t k = g->c->body_begin; k < g->c->body_end; ++k)
		g->sparse->turn[g->sparse->bodies[k]] = cni_rot_small(g->motions[g->sparse->bodies[k]].theta);
	for (int32_t k = g->c->begin; k < g->c->end; ++k) {
		cni_node *n = &g->sparse->nodes[k];
		cni_joint_constraint *w = constraint_of(g, k);
		cni_joint_constraint_rows(w, g->motions, g->sparse->turn);
		for (i = 0; i < n->rows; ++i) {
			float gap = w->rows[i].error - n->carried[i];
			n->x[i] = -gap * inv_h;
			largest = cni_max(largest, cni_abs(gap) * cni_row_length(g->world, &w->rows[i]));
		}
		for (; i < CNI_NODE_ROWS; ++i)
			n->x[i] = 0.0f;
	}
	return largest;
}

static void gaps_left_find(const rattle_step *g)
{
	for (int32_t k = g->c->begin; k < g->c->end; ++k)
		for (int32_t i = 0; i < g->sparse->nodes[k].rows; ++i)
			g->sparse->nodes[k].carried[i] = gap_left(g, constraint_of(g, k), i);
}

static void push(const rattle_step *g, cni_node *n)
{
	cni_four_store(n->total, cni_four_add(cni_four_load(n->total), cni_four_load(n->x)));
	cni_levers_push(&n->levers, n->x, g->motions + n->ia, g->motions + n->ib, CNI_NODE_ROWS);
}

/* Keeps this part of the impulses (1 or 0) and adds another along the present levers. */
static void impulses_push(const rattle_step *g, float kept, float added)
{
	for (int32_t k = g->c->begin; k < g->c->end; ++k) {
		cni_node *n = &g->sparse->nodes[k];
		cni_four_store(n->x, cni_four_scale(cni_four_load(n->total), added));
		cni_four_store(n->total, cni_four_scale(cni_four_load(n->total), kept));
		push(g, n);
	}
}

/* At least one round: the first guess of mu may look good enough and have the same sign of error each time. */
static int32_t positions_close(const rattle_step *g)
{
	float gap = gaps_find(g);
	for (int32_t round = 0; round < CNI_RATTLE_NEWTON_ROUNDS && (round == 0 || gap > g->closed); ++round) {
		if (!cni_sparse_solve(g->sparse, g->c))
			return BROKEN;
		push_and_move(g, 1.0f);
		gap = gaps_find(g);
	}
	return gap <= CNI_RATTLE_FAILED_GAP * g->closed ? CLOSED_WELL : OPEN;
}

static int32_t velocities_close(const rattle_step *g)
{
	const cni_four zero = cni_four_all(0.0f);
	for (int32_t k = g->c->begin; k < g->c->end; ++k) {
		cni_node *n = &g->sparse->nodes[k];
		cni_four_store(n->x, cni_four_subtract(zero, cni_levers_speed(&n->levers, g->motions + n->ia, g->motions + n->ib)));
	}
	if (!cni_sparse_solve(g->sparse, g->c))
		return 0;
	for (int32_t k = g->c->begin; k < g->c->end; ++k)
		push(g, &g->sparse->nodes[k]);
	return 1;
}

/* Writes the impulses, times `scale`, to the rigid rows. */
static void impulses_store(const rattle_step *g, int32_t node, float scale)
{
	for (int32_t i = 0; i < g->sparse->nodes[node].rows; ++i)
		constraint_of(g, node)->rows[i].impulse = scale * g->sparse->nodes[node].total[i];
}

static void dampers_set(const rattle_step *g)
{
	if (!g->c->damps)
		return;
	for (int32_t k = g->c->begin; k < g->c->end; ++k)
		impulses_store(g, k, 1.0f);
	cni_geometric_stiffness_damp(g->world, g->sparse, g->c, g->h);
}

/* Number of substeps that follows the fastest spring of the geometric stiffness, up to a limit. */
static int32_t substeps_of(const rattle_step *g, const cni_solve *s, float rods)
{
	float fastest = 0.0f, needed;
	for (int32_t k = g->c->body_begin; k < g->c->body_end; ++k)
		fastest = cni_max(fastest, cni_abs(g->motions[g->sparse->bodies[k]].w));
	needed = cni_max(1.5f * s->dt * cni_sqrt(cni_geometric_stiffness_largest(g->world, g->sparse, g->c)), 2.0f * s->dt * fastest);
	needed = cni_max(cni_min(CNI_RATTLE_SUBSTEPS_PIN, needed), cni_min(CNI_RATTLE_SUBSTEPS_ROD, 1.5f * s->dt * cni_sqrt(rods)));
	return cni_max_i(s->substeps, (int32_t)needed);
}

static int32_t substep(rattle_step *g)
{
	gaps_left_find(g);
	impulses_push(g, 0.0f, g->warm);
	kick(g);
	drift(g);
	int32_t closed = positions_close(g);
	kick(g);
	dampers_set(g);
	cni_direct_refresh(g->world, g->sparse, g->c);
	impulses_push(g, 1.0f, 2.0f * g->warm);
	return velocities_close(g) ? closed : BROKEN;
}

/* ---- ropes ---- */

static float rope_speed(const rattle_step *g, const cni_joint_constraint *w)
{
	return cni_lever_speed(&w->rows[0].lever, g->motions + w->ia, g->motions + w->ib);
}

/* A loose rope that would be too long after the next substep. */
static int32_t becomes_taut(const rattle_step *g, const cni_joint_constraint *w)
{
	return w->rows[0].error + g->h * rope_speed(g, w) < 0.0f;
}

/* Ropes without room whose ends do not approach each other are taut: rods until they push. */
static void ropes_begin(const rattle_step *g)
{
	float room = CNI_RATTLE_OLD_GAP * g->closed;
	for (int32_t k = g->c->begin; k < g->c->end && g->c->has_ropes; ++k) {
		const cni_joint_constraint *w = constraint_of(g, k);
		if (cni_joint_is_rope(w->record))
			g->sparse->nodes[k].rows = becomes_taut(g, w) || (w->rows[0].error <= room && g->h * rope_speed(g, w) <= room);
	}
}

/* After a substep: ropes that push become loose, those that are too long become taut. Returns 1 if there are any. */
static int32_t ropes_switch(const rattle_step *g)
{
	int32_t changed = 0;
	for (int32_t k = g->c->begin; k < g->c->end && g->c->has_ropes; ++k) {
		cni_node *n = &g->sparse->nodes[k];
		const cni_joint_constraint *w = constraint_of(g, k);
		if (!cni_joint_is_rope(w->record) || (n->rows > 0 ? n->total[0] >= 0.0f : !becomes_taut(g, w)))
			continue;
		n->rows = !n->rows;
		n->total[0] = 0.0f;
		cni_levers_clear(&n->levers, 0);
		changed = 1;
	}
	return changed;
}

/* ---- one substep of the projection ---- */

/* Moves by a part of the solution that `closing` holds. Returns the largest gap then. */
static float solution_move(const rattle_step *g, float part)
{
	for (int32_t k = g->c->begin; k < g->c->end; ++k)
		cni_four_store(g->sparse->nodes[k].x, cni_four_scale(cni_four_load(g->sparse->nodes[k].closing), part));
	push_and_move(g, 0.0f);
	return gaps_find(g);
}

/* Moves by the solution, or by half of it, a quarter and so on while that opens the gaps: near a straight chain a whole step of Newton's
   method may turn light links too far. Returns the largest gap then. */
static float solution_follow(const rattle_step *g, float last)
{
	for (int32_t k = g->c->begin; k < g->c->end; ++k)
		memcpy(g->sparse->nodes[k].closing, g->sparse->nodes[k].x, sizeof g->sparse->nodes[k].x);
	float gap = solution_move(g, 1.0f);
	for (float part = 0.5f; gap > last && part >= CNI_RATTLE_STEP_LEAST; part *= 0.5f)
		gap = solution_move(g, -part);
	return gap;
}

/* Newton's method for rotations of any size: the levers are computed anew in each round. */
static int32_t positions_project(const rattle_step *g)
{
	float gap = gaps_find(g), last = FLT_MAX;
	for (int32_t round = 0; round < CNI_RATTLE_PROJECT_ROUNDS && gap > g->closed &&
		(!g->c->loops || gap < CNI_RATTLE_SLOWEST_PART * last); ++round) {
		last = gap;
		cni_direct_refresh(g->world, g->sparse, g->c);
		(void)gaps_find(g);
		if (!cni_sparse_solve(g->sparse, g->c))
			return BROKEN;
		gap = solution_follow(g, last);
	}
	return gap <= 2.0f * g->world->settings.accuracy ? CLOSED_WELL : OPEN;
}

static int32_t substep_project(rattle_step *g)
{
	gaps_left_find(g);
	impulses_push(g, 0.0f, 0.0f);
	kick(g);
	kick(g);
	drift(g);
	int32_t closed = positions_project(g);
	cni_direct_refresh(g->world, g->sparse, g->c);
	return velocities_close(g) ? closed : BROKEN;
}

/* ---- the step ---- */

/* Sets `start` as if the last substep had the world's length: the test for bodies at rest reads it. */
static void last_substep_begins(const rattle_step *g, const cni_solve *s)
{
	for (int32_t k = g->c->body_begin; k < g->c->body_end; ++k) {
		int32_t index = g->sparse->bodies[k];
		const cni_motion *m = g->motions + index;
		const cni_external *d = cni_externals(g->world) + index;
		cni_velocity_start *start = cni_starts(g->world) + index;
		start->vx = m->vx + s->h * d->ax;
		start->vy = m->vy + s->h * d->ay;
		start->w = m->w + s->h * d->alpha;
		start->jumped = 0.0f;
	}
}

/* Scales impulses to the world's substep, for which reactions are read. */
static void step_finish(const rattle_step *g, const cni_solve *s)
{
	float scale = s->h / g->h;
	for (int32_t k = g->c->body_begin; k < g->c->body_end; ++k)
		cni_externals(g->world)[g->sparse->bodies[k]].flags |= CNI_EXTERNAL_FINISHED;
	for (int32_t k = g->c->begin; k < g->c->end; ++k) {
		cni_joint_constraint *w = constraint_of(g, k);
		impulses_store(g, k, scale);
		for (int32_t i = g->sparse->nodes[k].rows; i < w->row_count; ++i)
			w->rows[i].impulse = 0.0f;
		w->flags |= CNI_CONSTRAINT_FINISHED;
	}
}

static void constraints_stress(const rattle_step *g)
{
	for (int32_t k = g->c->begin; k < g->c->end; ++k) {
		cni_joint_constraint *w = constraint_of(g, k);
		if ((w->flags & CNI_CONSTRAINT_BREAKABLE) && g->sparse->nodes[k].rows > 0) {
			impulses_store(g, k, 1.0f);
			cni_joint_constraint_stress(w, g->motions, 1.0f / g->h);
		}
	}
}

/* Resets impulses to those of the joint records. */
static void impulses_reset(const rattle_step *g, float scale)
{
	ropes_begin(g);
	for (int32_t k = g->c->begin; k < g->c->end; ++k) {
		cni_joint_constraint *w = constraint_of(g, k);
		for (int32_t i = 0; i < g->sparse->nodes[k].rows; ++i)
			w->rows[i].impulse = g->sparse->nodes[k].total[i] = scale * w->record->impulse[w->rows[i].slot];
		if (w->flags & CNI_CONSTRAINT_BREAKABLE)
			w->numbers->force_stress = w->numbers->torque_stress = 0.0f;
	}
}

/* Restores the state at the beginning of the step. */
static void step_undo(rattle_step *g)
{
	bases_place(g, 0.0f);
	if (g->c->damps)
		cni_sparse_clear(g->sparse, g->c);
	cni_direct_motions_save(g->world, g->sparse, g->c, 1);
	cni_direct_rotations(g->world, g->sparse, g->c);
	for (int32_t k = g->c->begin; k < g->c->end; ++k)
		cni_joint_constraint_rows(constraint_of(g, k), g->motions, g->sparse->turn);
}

/* ---- trust of joints ---- */

static cni_joint_trust *trust_of(const rattle_step *g, int32_t node)
{
	return &cni_joint_at(g->world, constraint_of(g, node)->joint)->trust;
}

/* Of a component: the sum of its joints' accounts, the longest span, the latest end. */
static cni_joint_trust trust_read(const rattle_step *g)
{
	cni_joint_trust sum = { 0.0f, 0, 0, 0, 0 };
	uint32_t step = g->world->step_count;
	for (int32_t k = g->c->begin; k < g->c->end; ++k) {
		const cni_joint_trust *t = trust_of(g, k);
		sum.surplus += t->surplus;
		if (t->span > 0 && (sum.span == 0 || (int32_t)(t->until - step) > (int32_t)(sum.until - step)))
			sum.until = t->until;
		sum.span = (uint16_t)cni_max_i(sum.span, t->span);
	}
	return sum;
}

static void trust_write(const rattle_step *g, const cni_joint_trust *trust)
{
	float surplus = trust->surplus / (float)(g->c->end - g->c->begin);
	for (int32_t k = g->c->begin; k < g->c->end; ++k) {
		cni_joint_trust *t = trust_of(g, k);
		*t = *trust;
		t->surplus = surplus;
	}
}

/* Runs all substeps, or stops at the first that fails. Returns 1 when none did. */
static int32_t substeps_run(rattle_step *g, const cni_solve *s, int32_t substeps, int32_t projects)
{
	g->base_work = 0.0f;
	for (int32_t k = 0; k < substeps; ++k) {
		if (k == substeps - 1)
			last_substep_begins(g, s);
		int32_t how = projects ? substep_project(g) : substep(g);
		if (how == BROKEN || (how == OPEN && !(projects && g->c->loops)))
			return 0;
		constraints_stress(g);
		if (g->held)
			g->base_work += cni_rattle_base_work(g);
		if (ropes_switch(g) && k < substeps - 1)
			cni_direct_refresh(g->world, g->sparse, g->c);
	}
	g->energy_error = cni_rattle_energy_error(g, s);
	return 1;
}

/* Projections cannot raise kinetic energy: any gain is rounding. Moving bases may do any work, but not on loops: what RATTLE cannot follow there is being
   pulled straight, and the nearest motion that follows it is of any speed. */
static int32_t projection_fits(const rattle_step *g, const rattle_energies *before, const rattle_energies *after)
{
	float most = cni_sq(cni_sqrt(before->total) + cni_sqrt(before->allowed)); /* in the norm of kinetic energy */
	return after->kinetic <= (1.0f + CNI_RATTLE_ENERGY_PART) * most || (g->base_work != 0.0f && !g->c->loops);
}

/* Moving bases give a loop no more energy in a step than all its bodies have at the speed of the fastest: before it is straight they throw it. */
static int32_t pull_fits(const rattle_step *g, const rattle_energies *before, const rattle_energies *after)
{
	if (!g->c->loops || g->base_work == 0.0f)
		return 1;
	float speed = cni_component_bases_ask(g->world, g->sparse, g->c);
	float most = cni_sqrt(before->total) + cni_sqrt(before->allowed) + speed * cni_sqrt(0.5f * cni_component_mass(g->world, g->sparse, g->c));
	return after->kinetic <= (1.0f + CNI_RATTLE_ENERGY_PART) * cni_sq(most);
}

/* Tries a step by RATTLE, or by projections, with this number of substeps. */
static int32_t step_try(rattle_step *g, const cni_solve *s, cni_component *c, int32_t substeps, int32_t projects, cni_joint_trust *t)
{
	g->h = s->dt / (float)substeps;
	impulses_reset(g, projects ? 0.0f : s->warm_scale * g->h / s->h);
	if (!projects) {
		cni_geometric_stiffness_begin(g->world, g->sparse, c, g->h);
		g->warm = c->damps ? 0.0f : 0.5f;
		cni_geometric_stiffness_damp(g->world, g->sparse, c, g->h);
	}
	cni_direct_refresh(g->world, g->sparse, c);
	g->closing = cni_rattle_closing_speed(g);
	rattle_energies before = cni_rattle_energies(g, s->dt); /* no work has been done at the beginning of a step */
	if (!substeps_run(g, s, substeps, projects))
		return 0;
	rattle_energies after = cni_rattle_energies(g, s->dt);
	float gained = after.total - before.total - g->base_work;
	int32_t conserves = gained <= CNI_RATTLE_ENERGY_PART * before.total + before.allowed; /* 0 for NaN */
	if (!(projects ? projection_fits(g, &before, &after) : conserves && pull_fits(g, &before, &after)))
		return 0;
	cni_rattle_account(g, &after, t, gained);
	return 1;
}

/* Returns the joints to the soft solver for this step and for some time. */
static void joints_release(const rattle_step *g, const cni_solve *s, cni_joint_trust *t)
{
	cni_trust_fail(g->world, t, 1);
	t->surplus = 0.0f;
	for (int32_t k = g->c->begin; k < g->c->end; ++k) {
		cni_joint_constraint_prepare(g->world, s, g->sparse->nodes[k].owner);
		for (int32_t i = 0; i < constraint_of(g, k)->row_count; ++i)
			constraint_of(g, k)->rows[i].impulse = 0.0f; /* impulses of a failed solution may be huge */
	}
}

static int32_t attempt_work(const cni_component *c, int32_t substeps)
{
	int64_t work = (int64_t)substeps * cni_cone_factor_work(c);
	return work < CNI_ATTEMPT_WORK ? (int32_t)work : CNI_ATTEMPT_WORK;
}

/* Tries a step by RATTLE. 0: it failed, and all is as before. */
static int32_t rattle_try(rattle_step *g, const cni_solve *s, cni_component *c, int32_t substeps, cni_joint_trust *t)
{
	cni_joint_trust before = *t;
	if (step_try(g, s, c, substeps, 0, t))
		return 1;
	*t = before;
	step_undo(g);
	return 0;
}

/* After a failure with this number of substeps: doubles it after each, as the work of the step allows. Returns 1 when a step succeeded. */
static int32_t rattle_retry(rattle_step *g, const cni_solve *s, cni_component *c, int32_t substeps, cni_joint_trust *t)
{
	for (;;) {
		g->world->set_work += attempt_work(c, substeps);
		substeps *= 2;
		if (substeps > CNI_RATTLE_SUBSTEPS_RETRY || (g->world->settings.solver == CN_SOLVER_AUTO && g->world->set_work + attempt_work(c, substeps) > CNI_RATTLE_WORK))
			return 0;
		if (rattle_try(g, s, c, substeps, t))
			return 1;
	}
}

/* Substeps of projections: of a large system as few as half of the work allows. */
static int32_t projection_substeps(const cn_world *world, const cni_solve *s, const cni_component *c)
{
	int32_t substeps = CNI_RATTLE_SUBSTEPS_FIRM;
	while (substeps > s->substeps && world->settings.solver == CN_SOLVER_AUTO && attempt_work(c, substeps) > CNI_RATTLE_WORK / 2)
		substeps /= 2;
	return cni_max_i(substeps, s->substeps);
}

static rattle_step step_open(cn_world *world, const cni_solve *s, cni_component *c)
{
	rattle_step g = { world, s->direct, c, cni_motions(world), s->h,
		CNI_RATTLE_CLOSED * world->settings.length_unit, 0.0f, 0.5f, 0.0f, 0.0f, 0.0f, 0 };
	g.held = cni_component_held(world, g.sparse, c) > 0;
	return g;
}

static void step_accept(rattle_step *g, const cni_solve *s, const cni_joint_trust *trust)
{
	trust_write(g, trust);
	bases_place(g, 0.0f); /* the substeps move them */
	step_finish(g, s);
}

/* What is pending of a component after its first attempt: retries from this number of substeps on; or projections alone. */
#define PENDING_PROJECTION (-1)

static void component_begin(cn_world *world, const cni_solve *s, cni_component *c, int32_t argument)
{
	(void)argument;
	if (!c->uses_rattle)
		return;
	rattle_step g = step_open(world, s, c);
	float rods, last_h = s->warm_scale > 0.0f ? s->h / s->warm_scale : s->h; /* substep of the records' impulses */
	cni_joint_trust trust = trust_read(&g);
	cni_direct_rotations(world, g.sparse, c);
	rods = cni_geometric_stiffness_rods(world, g.sparse, c, last_h);
	cni_geometric_stiffness_find(world, g.sparse, c, last_h);
	cni_direct_motions_save(world, g.sparse, c, 0);
	c->done = 1;
	c->pending = trust.span > 0 && trust.until > world->step_count ? PENDING_PROJECTION : substeps_of(&g, s, rods);
	if (c->pending != PENDING_PROJECTION && rattle_try(&g, s, c, c->pending, &trust)) {
		c->pending = 0;
		step_accept(&g, s, &trust);
	}
}

static void component_end(cn_world *world, const cni_solve *s, cni_component *c)
{
	rattle_step g = step_open(world, s, c);
	cni_joint_trust trust = trust_read(&g);
	int32_t solved = c->pending != PENDING_PROJECTION && rattle_retry(&g, s, c, c->pending, &trust);
	if (!solved && c->pending != PENDING_PROJECTION)
		cni_trust_fail(world, &trust, 0);
	c->pending = 0;
	if (solved || step_try(&g, s, c, projection_substeps(world, s, c), 1, &trust)) {
		step_accept(&g, s, &trust);
		return;
	}
	step_undo(&g);
	joints_release(&g, s, &trust);
	trust_write(&g, &trust);
}

/* Workers share the first attempts; retries share the work of the step, in order. */
void cni_rattle_run(cn_world *world, const cni_solve *s)
{
	cni_components_run(world, s, cni_components_team(world, s->direct, s->substeps), component_begin, 0);
	for (int32_t k = 0; k < s->direct->component_count; ++k)
		if (s->direct->components[k].uses_rattle && s->direct->components[k].pending)
			component_end(world, s, &s->direct->components[k]);
}
