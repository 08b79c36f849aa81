/*
 * direct/component.c - a component of directly solved joints: levers, system, right sides, checked solutions, impulses.
 *
 * Reads joint constraints, motion and inverse masses; writes nodes, their rigid rows' impulses, motion velocities.
 */
#include "contacts/contacts.h"
#include "direct/direct_system.h"

static void motions_copy(const cn_world *world, const cni_sparse *sparse, const cni_component *c, cni_motion *to, int32_t restore)
{
	for (int32_t k = c->body_begin; k < c->body_end; ++k) {
		cni_motion *m = cni_motions(world) + sparse->bodies[k], *saved = to + k;
		*(restore ? m : saved) = *(restore ? saved : m);
	}
}

void cni_direct_motions_save(const cn_world *world, const cni_sparse *sparse, const cni_component *c, int32_t restore)
{
	motions_copy(world, sparse, c, sparse->saved, restore);
}

void cni_direct_rotations(const cn_world *world, cni_sparse *sparse, const cni_component *c)
{
	for (int32_t k = c->begin; c->meets_kinematic && k < c->end; ++k) { /* these are not in the component's body list */
		const cni_node *n = &sparse->nodes[k];
		sparse->turn[n->ia] = cni_rot_small(cni_motions(world)[n->ia].theta);
		sparse->turn[n->ib] = cni_rot_small(cni_motions(world)[n->ib].theta);
	}
	for (int32_t k = c->body_begin; k < c->body_end; ++k)
		sparse->turn[sparse->bodies[k]] = cni_rot_small(cni_motions(world)[sparse->bodies[k]].theta);
}

int32_t cni_component_held(const cn_world *world, const cni_sparse *sparse, const cni_component *c)
{
	const cni_motion *motions = cni_motions(world);
	int32_t k, count = 0;
	for (k = c->begin; k < c->end; ++k)
		count += motions[sparse->nodes[k].ia].inv_mass == 0.0f || motions[sparse->nodes[k].ib].inv_mass == 0.0f;
	return count;
}

int32_t cni_component_is_braced(const cni_component *c, int32_t held)
{
	int32_t bodies = c->body_end - c->body_begin;
	return held > 1 && bodies <= CNI_LOOP_BODIES * (c->end - c->begin - bodies);
}

void cni_component_release(cn_world *world, cni_sparse *sparse, cni_component *c)
{
	for (int32_t k = c->begin; k < c->end; ++k)
		if (sparse->nodes[k].owner >= 0) {
			cni_joint_constraint *w = &cni_joint_constraints(world)[sparse->nodes[k].owner];
			w->flags &= ~(uint32_t)CNI_CONSTRAINT_DIRECT;
			w->active_row = w->idle_row = CNI_NONE;
		}
	c->uses_rattle = 0;
	c->done = 1;
}

float cni_direct_soft_part(const cn_world *world, float impulse, int32_t ia, int32_t ib)
{
	float speed = impulse * cni_max(cni_motions(world)[ia].inv_mass, cni_motions(world)[ib].inv_mass);
	float most = cni_soft_speed_most(world);
	return speed > most ? most / speed : 1.0f;
}

int32_t cni_component_is_slow(const cn_world *world, const cni_sparse *sparse, const cni_component *c)
{
	float most = CNI_HEAVY_SLOW_SPEED * world->settings.length_unit;
	int32_t island = cni_awake_island(world, sparse->bodies[c->body_begin]);
	cni_vec2 frame = { 0.0f, 0.0f };
	if (island != CNI_NONE)
		frame = cni_island_frame(world, cni_island_at(world, island));
	for (int32_t k = c->body_begin; k < c->body_end; ++k) {
		const cni_motion *m = cni_motions(world) + sparse->bodies[k];
		if (cni_sq(m->vx - frame.x) + cni_sq(m->vy - frame.y) > most * most)
			return 0;
	}
	return 1;
}

void cni_component_suspend(cn_world *world, cni_sparse *sparse, cni_component *c, int32_t span)
{
	for (int32_t k = c->begin; k < c->end; ++k) {
		if (sparse->nodes[k].owner < 0)
			continue;
		cni_joint_trust *t = &cni_joint_at(world, cni_joint_constraints(world)[sparse->nodes[k].owner].joint)->trust;
		if (span == 0)
			cni_trust_fail(world, t, 1);
		else
			cni_trust_suspend(world, t, span, 1);
	}
	cni_component_release(world, sparse, c);
}

/*
 * Adds so much of a joint's angle, its last row, to the others that their speeds do not move it: they then act at the point about which the two
 * bodies turn. At the anchor of a long slide they would turn the light body by all that the angle takes back, and the mass of what hangs on the
 * arm would be lost in rounding. The solution is that of the rows as they were, which get its impulses (cni_node_impulses_add).
 */
static void angle_decouple(cni_node *n, const cni_motion *a, const cni_motion *b)
{
	cni_levers *l = &n->levers;
	int32_t i, last = n->rows - 1;
	float ma = l->aw[last] * a->inv_inertia, mb = l->bw[last] * b->inv_inertia, mass = cni_inverse_or_zero(l->aw[last] * ma + l->bw[last] * mb);
	for (i = 0; i < last; ++i) {
		n->share[i] = -mass * (l->aw[i] * ma + l->bw[i] * mb);
		l->aw[i] += n->share[i] * l->aw[last];
		l->bw[i] += n->share[i] * l->bw[last];
		n->closing[i] += n->share[i] * n->closing[last];
	}
}

/* Reads the joints' levers from their rows, and the speeds that correct their errors at this rate, but no faster than overlaps are pushed
   apart: what a gap's closing gives to light parts they keep. Returns the sum of these speeds. */
static float levers_read(const cn_world *world, cni_sparse *sparse, const cni_component *c, float rate)
{
	float sum = 0.0f;
	for (int32_t k = c->begin; k < c->end; ++k) {
		cni_node *n = &sparse->nodes[k];
		if (n->owner < 0)
			continue;
		const cni_joint_constraint *w = cni_joint_constraints(world) + n->owner;
		const cni_row *rows = w->rows;
		cni_mobility least = cni_mobility_least(w, cni_motions(world) + n->ia, cni_motions(world) + n->ib);
		for (int32_t i = 0; i < n->rows; ++i) {
			float most = cni_row_push_speed(world, &rows[i]);
			n->compliance[i] = rows[i].angular ? least.angular : least.linear;
			cni_levers_set(&n->levers, i, rows[i].lever);
			n->closing[i] = cni_clamp(rate * rows[i].error, -most, most);
			sum += cni_abs(n->closing[i]) * cni_row_length(world, &rows[i]);
		}
		if (rate > 0.0f && n->rows > 1 && rows[n->rows - 1].angular)
			angle_decouple(n, cni_motions(world) + n->ia, cni_motions(world) + n->ib);
	}
	return sum;
}

/* Applies x of every node to body velocities. */
static void velocities_push(cn_world *world, const cni_sparse *sparse, const cni_component *c)
{
	cni_motion *motions = cni_motions(world);
	const int32_t end = c->end, width = c->width;
	for (int32_t k = c->begin; k < end; ++k) {
		const cni_node *n = &sparse->nodes[k];
		if (n->owner >= 0)
			cni_levers_push(&n->levers, n->x, motions + n->ia, motions + n->ib, width);
	}
}

/* Greatest change of a body's speed, at its centre and its farthest point, since motions were saved. */
static float change_most(const cn_world *world, const cni_sparse *sparse, const cni_component *c)
{
	float most = 0.0f;
	for (int32_t k = c->body_begin; k < c->body_end; ++k) {
		const cni_motion *m = cni_motions(world) + sparse->bodies[k], *saved = sparse->saved + k;
		float reach = cni_body_at(world, cni_awake_ids(world)[sparse->bodies[k]])->extent;
		most = cni_max(most, cni_length(cni_v(m->vx - saved->vx, m->vy - saved->vy)) + reach * cni_abs(m->w - saved->w));
	}
	return most;
}

/* Adds the speeds of the rows, times `part`, to their closing speeds. */
static void closings_add_speeds(const cn_world *world, cni_sparse *sparse, const cni_component *c, float part)
{
	const cni_motion *motions = cni_motions(world);
	for (int32_t k = c->begin; k < c->end; ++k) {
		cni_node *n = &sparse->nodes[k];
		cni_four speed = cni_levers_speed(&n->levers, motions + n->ia, motions + n->ib);
		cni_four_store(n->closing, cni_four_add(cni_four_load(n->closing), cni_four_scale(speed, part)));
	}
}

static void closings_scale(cni_sparse *sparse, const cni_component *c, float part)
{
	for (int32_t k = c->begin; k < c->end; ++k)
		cni_four_store(sparse->nodes[k].closing, cni_four_scale(cni_four_load(sparse->nodes[k].closing), part));
}

/*
 * Gaps that all close at the speed at which overlaps are pushed apart would throw the end of a chain, or a light body between heavy ones. So the
 * closing of all gaps of a component moves none of its bodies faster than that: one factor for all, from one more solution where their speeds
 * add to more (levers_read).
 *
 * Redundant rows of loops contradict each other where anchors do not quite agree. No motion closes their gaps, and a system that is asked to
 * answers with tension, of 1 / CNI_REGULARIZATION_LOOPS times the speed in every pass. So the rows of a loop close no faster than they do in the
 * motion that this solution finds, the best by least squares: what is left of their gaps stays. Not those of a row between two fixed ends, which
 * contradict each other where it is straight alone: tension closes them as soon as it sags.
 */
static void closings_bound(cn_world *world, cni_sparse *sparse, cni_component *c, float sum)
{
	const int32_t contradicts = c->loops && !cni_component_is_row(c, cni_component_held(world, sparse, c));
	const float most = world->settings.push_speed_max;
	float fastest;
	if (sum <= (contradicts ? CNI_DIRECT_SPEED_LEAST * world->settings.length_unit : most))
		return;
	for (int32_t k = c->begin; k < c->end; ++k)
		cni_four_store(sparse->nodes[k].x, cni_four_subtract(cni_four_all(0.0f), cni_four_load(sparse->nodes[k].closing)));
	if (!cni_sparse_solve(sparse, c))
		return;
	cni_direct_motions_save(world, sparse, c, 0);
	velocities_push(world, sparse, c);
	fastest = change_most(world, sparse, c);
	if (contradicts) {
		closings_scale(sparse, c, 0.0f);
		closings_add_speeds(world, sparse, c, -1.0f);
	}
	cni_direct_motions_save(world, sparse, c, 1);
	if (contradicts)
		closings_add_speeds(world, sparse, c, 1.0f);
	if (fastest > most)
		closings_scale(sparse, c, most / fastest);
}

void cni_direct_refresh(cn_world *world, cni_sparse *sparse, const cni_component *c)
{
	(void)levers_read(world, sparse, c, 0.0f);
	cni_sparse_factor(sparse, c, cni_motions(world));
}

/* ---- loops between moving ends ---- */

float cni_component_bases_ask(const cn_world *world, cni_sparse *sparse, const cni_component *c)
{
	float most = 0.0f;
	for (int32_t k = c->begin; k < c->end; ++k) {
		cni_node *n = &sparse->nodes[k];
		cni_four_store(n->x, cni_four_subtract(cni_four_all(0.0f), cni_node_base_speed(n, cni_motions(world))));
		for (int32_t i = 0; i < n->rows; ++i)
			most = cni_max(most, cni_abs(n->x[i]) * cni_row_length(world, &cni_joint_constraints(world)[n->owner].rows[i]));
	}
	return most;
}

/* A taut rope has the row of a rod (1), or none (0). */
static void ropes_tighten(const cn_world *world, cni_sparse *sparse, const cni_component *c, int32_t rows)
{
	for (int32_t k = c->begin; k < c->end && c->has_ropes; ++k) {
		const cni_joint_constraint *w = cni_joint_constraints(world) + sparse->nodes[k].owner;
		if (cni_joint_is_rope(w->record))
			sparse->nodes[k].rows = rows && w->rows[0].error <= 0.0f;
	}
}

/* The greatest speed of a body in the least motion that follows the ends: right sides are those of cni_component_bases_ask. FLT_MAX: there is none. */
static float speed_that_follows(cn_world *world, cni_sparse *sparse, const cni_component *c)
{
	float speed;
	cni_sparse_factor(sparse, c, cni_motions(world));
	if (!cni_sparse_solve(sparse, c))
		return FLT_MAX;
	cni_direct_motions_save(world, sparse, c, 0);
	velocities_push(world, sparse, c);
	speed = change_most(world, sparse, c);
	cni_direct_motions_save(world, sparse, c, 1);
	return speed;
}

int32_t cni_component_is_pulled(cn_world *world, const cni_solve *s, cni_sparse *sparse, const cni_component *c)
{
	float pull, speed;
	if (!c->loops || !c->meets_kinematic || c->has_contacts)
		return 0;
	cni_component_rows_need(world, s, sparse, c);
	cni_sparse_clear(sparse, c);
	cni_direct_rotations(world, sparse, c);
	ropes_tighten(world, sparse, c, 1);
	(void)levers_read(world, sparse, c, 0.0f);
	pull = cni_component_bases_ask(world, sparse, c);
	speed = pull > 0.0f ? speed_that_follows(world, sparse, c) : 0.0f;
	ropes_tighten(world, sparse, c, 0);
	return speed > cni_max(CNI_LOOP_PULLED * pull, CNI_LOOP_PULLED_SPEED * world->settings.length_unit);
}

void cni_component_rows_need(cn_world *world, const cni_solve *s, const cni_sparse *sparse, const cni_component *c)
{
	for (int32_t k = c->begin; k < c->end; ++k)
		if (sparse->nodes[k].owner >= 0)
			cni_joint_rows_need(world, s, cni_joint_constraints(world) + sparse->nodes[k].owner);
}

void cni_direct_begin(cn_world *world, const cni_solve *s, cni_sparse *sparse, cni_component *c)
{
	cni_component_rows_need(world, s, sparse, c);
	cni_sparse_clear(sparse, c);
	cni_direct_rotations(world, sparse, c);
	c->active = c->has_contacts || c->kind != CNI_NONE || !CNI_ON(ACTIVE_ROWS) ? 0 : cni_active_begin(world, s, sparse, c);
	if (c->active)
		c->width = CNI_NODE_ROWS;
	cni_geometric_stiffness_begin(world, sparse, c, s->h);
	cni_direct_system(world, s, sparse, c);
	c->checked = c->loops || (!c->has_contacts && cni_sparse_is_redundant(sparse, c, CNI_CHECKED_PIVOT));
}

void cni_direct_system(cn_world *world, const cni_solve *s, cni_sparse *sparse, cni_component *c)
{
	if (c->damps)
		cni_direct_rotations(world, sparse, c);
	if (c->active)
		cni_active_clear(sparse, c);
	cni_geometric_stiffness_damp(world, sparse, c, s->h);
	float closing = levers_read(world, sparse, c, s->joint_error_rate);
	if (c->active)
		cni_active_levers(world, s, sparse, c);
	if (c->has_contacts) {
		c->factored = 0;
		return;
	}
	cni_sparse_factor(sparse, c, cni_motions(world));
	closings_bound(world, sparse, c, closing);
}

/*
 * Rows of loops yield a little in proportion to their impulse. The internal tension of a straight bridge between two walls has no effect on
 * its bodies, so the system does not see it. Without this leak the tension would grow until a small rotation of a joint turned it into
 * motion of everything near.
 */
static void leaks_add(const cn_world *world, cni_sparse *sparse, const cni_component *c)
{
	const cni_joint_constraint *constraints = cni_joint_constraints(world);
	for (int32_t k = c->begin; k < c->end; ++k) {
		cni_node *n = &sparse->nodes[k];
		for (int32_t i = 0; i < n->rows && n->owner >= 0; ++i) {
			const cni_row *rows = constraints[n->owner].rows;
			float impulse = rows[i].impulse;
			if (i > 0 && i == n->rows - 1)
				impulse -= n->share[0] * rows[0].impulse + n->share[1] * rows[1].impulse;
			n->x[i] -= CNI_DIRECT_LEAK * n->diagonal[i] * impulse;
		}
	}
}

static void sides_save(cni_sparse *sparse, const cni_component *c, int32_t restore)
{
	for (int32_t k = c->begin; k < c->end; ++k) {
		cni_node *n = &sparse->nodes[k];
		memcpy(restore ? n->x : n->carried, restore ? n->carried : n->x, sizeof n->x);
	}
}

/* Greatest speed of a body in the motion that closes the gaps. A moving body without mass that holds it may do any work: that of all its bodies
   at the speed of pushing is allowed. */
static float closing_most(const cn_world *world, const cni_sparse *sparse, const cni_component *c)
{
	float most = world->settings.push_speed_max, sum = 0.0f;
	for (int32_t k = c->begin; k < c->end && !c->meets_kinematic; ++k) {
		const cni_node *n = &sparse->nodes[k];
		for (int32_t i = 0; i < n->rows && n->owner >= 0; ++i)
			sum += cni_abs(n->closing[i]) * cni_row_length(world, &cni_joint_constraints(world)[n->owner].rows[i]);
	}
	for (int32_t k = c->active ? c->active_first : CNI_NONE; k != CNI_NONE; k = sparse->nodes[k].next_active)
		sum += cni_max(sparse->nodes[k].target, 0.0f);
	return c->meets_kinematic ? most : cni_clamp(sum, CNI_WARM_PUSH_PART * most, most);
}

/*
 * A motion v that joints stop is P v, with a projection P in the norm of kinetic energy, and one u that closes gaps is orthogonal to all of those. So
 * kinetic energy grows by no more than that of u. Of a straight row between what holds it nothing is left of v, and rounding, or the second order of
 * the substep, is answered with any speed across it. 1: it grew by more since these motions were saved.
 */
static int32_t gains_energy(const cn_world *world, const cni_sparse *sparse, const cni_component *c, const cni_motion *saved)
{
	float closing = closing_most(world, sparse, c), allowed = 0.0f, after = 0.0f;
	for (int32_t k = c->body_begin; k < c->body_end; ++k) {
		const cni_motion *m = cni_motions(world) + sparse->bodies[k], *old = saved + k;
		allowed += (1.0f + CNI_LOOP_ENERGY_PART) * cni_energy_twice(m, old->vx, old->vy, old->w) + cni_inverse_or_zero(m->inv_mass) * closing * closing;
		after += cni_energy_twice(m, m->vx, m->vy, m->w);
	}
	return !(after <= allowed); /* so does NaN */
}

/*
 * With A = K + C, right sides b and A x = b, the velocity change M^-1 J^T x has twice the kinetic energy x K x <= x A x = x b: no solution
 * exceeds the work of its right sides. A solution that exceeds it was made by pivots that are rounding. Where J u = b, x b <= u M u: no work
 * exceeds that of a stop of all motion, of motors and of all bodies at the greatest closing speed. More closes gaps of contradictory rows.
 */
static int32_t is_bounded(const cn_world *world, const cni_sparse *sparse, const cni_component *c)
{
	cni_four work = cni_four_all(0.0f), change = work, before = work;
	float fastest = world->settings.push_speed_max, push = 0.0f, all;
	for (int32_t k = c->begin; k < c->end; ++k) {
		const cni_node *n = &sparse->nodes[k];
		work = cni_four_add(work, cni_four_times(cni_four_load(n->carried), cni_four_load(n->x)));
		for (int32_t i = 0; i < n->rows && n->owner >= 0; ++i)
			fastest = cni_max(fastest, cni_abs(n->closing[i]) * cni_row_length(world, &cni_joint_constraints(world)[n->owner].rows[i]));
		if (n->active & CNI_ROW_IN_SET)
			push += cni_abs(n->target * n->x[2]);
	}
	for (int32_t k = c->body_begin; k < c->body_end; ++k) {
		const cni_motion *m = cni_motions(world) + sparse->bodies[k];
		float mass = cni_inverse_or_zero(m->inv_mass);
		cni_four masses = cni_four_of(mass, mass, cni_inverse_or_zero(m->inv_inertia), 0.0f), old = cni_four_load(&sparse->saved[k].vx);
		cni_four v = cni_four_subtract(cni_four_load(&m->vx), old);
		change = cni_four_add(change, cni_four_times(cni_four_times(v, v), masses));
		before = cni_four_add(before, cni_four_times(cni_four_times(old, old), masses));
		push += mass * fastest * fastest;
	}
	all = cni_four_sum(before);
	if (!c->active && gains_energy(world, sparse, c, sparse->saved))
		return 0;
	return cni_four_sum(work) <= 2.0f * (all + push) && cni_four_sum(change) <= 1.1f * cni_four_sum(work) + 1e-6f * all; /* false for NaN */
}

/* The next substep begins without the impulses of dampers and locks: they act against the motion of one substep and are no loads. */
static void dampers_forget(cn_world *world, const cni_sparse *sparse, const cni_component *c)
{
	const cni_motion *motions = cni_motions(world);
	cni_velocity_start *starts = cni_starts(world);
	for (int32_t k = c->begin; k < c->end && c->damps; ++k) {
		const cni_node *n = &sparse->nodes[k];
		if (n->x[2] == 0.0f || n->rows != 2 || n->owner < 0 || (n->active & CNI_ROW_IN_SET))
			continue;
		starts[n->ia].w += motions[n->ia].inv_inertia * n->levers.aw[2] * n->x[2];
		starts[n->ib].w += motions[n->ib].inv_inertia * n->levers.bw[2] * n->x[2];
	}
}

/* Adds x of every node to its rows' impulses. */
static void impulses_store(cn_world *world, const cni_sparse *sparse, const cni_component *c)
{
	cni_joint_constraint *constraints = cni_joint_constraints(world);
	for (int32_t k = c->begin; k < c->end; ++k)
		if (sparse->nodes[k].owner >= 0)
			cni_node_impulses_add(&sparse->nodes[k], constraints[sparse->nodes[k].owner].rows, sparse->nodes[k].x);
}

/* Rows of loops may be redundant, so their system may be nearly singular. When a solution exceeds its bound, it is solved again with a
   larger diagonal, which the component keeps for this step. */
int32_t cni_direct_apply(cn_world *world, cni_sparse *sparse, cni_component *c)
{
	if (c->checked || c->active)
		sides_save(sparse, c, 0);
	if (c->checked)
		cni_direct_motions_save(world, sparse, c, 0);
	for (;;) {
		if (cni_sparse_solve(sparse, c)) {
			velocities_push(world, sparse, c);
			if (!c->checked || is_bounded(world, sparse, c)) {
				impulses_store(world, sparse, c);
				dampers_forget(world, sparse, c);
				if (c->active)
					cni_active_impulses_add(world, sparse, c);
				return 1;
			}
			cni_direct_motions_save(world, sparse, c, 1);
		}
		if (!c->loops || c->regular > CNI_REGULARIZATION_MAX)
			return 0;
		c->regular *= CNI_REGULARIZATION_STEP;
		cni_sparse_factor(sparse, c, cni_motions(world));
		sides_save(sparse, c, 1);
	}
}

void cni_direct_right_sides(cn_world *world, const cni_solve *s, const cni_component *c, int32_t bias)
{
	const cni_motion *motions = cni_motions(world);
	const float part = bias ? 1.0f : 0.0f;
	cni_node *nodes = s->direct->nodes;
	for (int32_t k = c->begin; k < c->end; ++k) {
		cni_node *n = &nodes[k];
		cni_four speed = cni_levers_speed(&n->levers, motions + n->ia, motions + n->ib);
		cni_four_store(n->total, speed);
		cni_four_store(n->x, cni_four_subtract(cni_four_subtract(cni_four_all(0.0f), speed), cni_four_scale(cni_four_load(n->closing), part)));
	}
	if (bias && c->loops && !c->has_contacts)
		leaks_add(world, s->direct, c);
	if (c->active)
		cni_active_right_sides(world, s, s->direct, c, bias);
}

/* ---- with motors and limits: the active set of direct/active_rows.c ---- */

/* Right sides of the changed set, from those of the last (carried) and the speeds of then (total; first 1) or the target speeds. */
static void sides_renew(const cn_world *world, cni_sparse *sparse, const cni_component *c, int32_t first)
{
	const cni_motion *motions = cni_motions(world);
	for (int32_t k = c->begin; k < c->end; ++k) {
		cni_node *n = &sparse->nodes[k];
		float speed[CNI_NODE_LANES];
		cni_four_store(speed, cni_levers_speed(&n->levers, motions + n->ia, motions + n->ib));
		for (int32_t i = 0; i < CNI_NODE_ROWS; ++i) {
			n->total[i] = i >= n->rows ? 0.0f : first ? n->carried[i] + n->total[i] : n->total[i];
			n->x[i] = n->total[i] - speed[i];
		}
		if (n->active & CNI_ROW_IN_SET)
			n->x[2] += n->target;
	}
}

/* Saves the motions of its bodies and the impulses of its rows, or restores them (1). */
static void set_save(cn_world *world, const cni_sparse *sparse, const cni_component *c, int32_t restore)
{
	motions_copy(world, sparse, c, sparse->begun, restore);
	for (int32_t k = c->begin; k < c->end; ++k) {
		cni_node *n = &sparse->nodes[k];
		cni_joint_constraint *w = cni_joint_constraints(world) + n->owner;
		for (int32_t i = 0; i < CNI_NODE_ROWS; ++i) {
			int32_t row = i < n->rows ? i : i == 2 ? w->active_row : CNI_NONE;
			if (row != CNI_NONE)
				*(restore ? &w->rows[row].impulse : &n->begun[i]) = *(restore ? &n->begun[i] : &w->rows[row].impulse);
		}
	}
}

/* Solves the right sides for impulses with the active set. Sets of limits alone add no energy, although one of their rounds may: a slack rope in the
   set is pushed until the next. 0: the solution is not finite, or adds energy, of a checked system without motors nothing is changed then. */
static int32_t set_solve(cn_world *world, const cni_solve *s, cni_sparse *sparse, cni_component *c, int32_t bias)
{
	int32_t checked = c->checked && c->active == 1, solved;
	if (checked)
		set_save(world, sparse, c, 0);
	for (int32_t round = 0;; ++round) {
		solved = cni_direct_apply(world, sparse, c);
		if (!solved || round == CNI_JOINT_SET_ROUNDS || !cni_active_change(world, s, sparse, c, bias))
			break;
		++c->set_changes;
		cni_direct_system(world, s, sparse, c);
		sides_renew(world, sparse, c, round == 0);
	}
	solved = solved && !(checked && gains_energy(world, sparse, c, sparse->begun));
	if (checked && !solved)
		set_save(world, sparse, c, 1);
	return solved;
}

/* The impulse of a row is no part of the next substep's warm start any more. */
static void row_forget(const cn_world *world, cni_row *r, int32_t ia, int32_t ib)
{
	cni_motion change_a = cni_motions(world)[ia], change_b = cni_motions(world)[ib];
	change_a.vx = change_a.vy = change_a.w = change_b.vx = change_b.vy = change_b.w = 0.0f;
	cni_lever_push(&r->lever, r->impulse, &change_a, &change_b);
	cni_start_add(cni_starts(world) + ia, &change_a, 1.0f);
	cni_start_add(cni_starts(world) + ib, &change_b, 1.0f);
	r->impulse = 0.0f;
}

float cni_component_mass(const cn_world *world, const cni_sparse *sparse, const cni_component *c)
{
	float mass = 0.0f;
	for (int32_t k = c->body_begin; k < c->body_end; ++k)
		mass += cni_inverse_or_zero(cni_motions(world)[sparse->bodies[k]].inv_mass);
	return mass;
}

/* Twice the kinetic energy of its bodies: of their motion, or of the start of the substep, before impulses. */
static float energy_twice(const cn_world *world, const cni_sparse *sparse, const cni_component *c, int32_t at_start)
{
	float sum = 0.0f;
	for (int32_t k = c->body_begin; k < c->body_end; ++k) {
		const cni_motion *m = cni_motions(world) + sparse->bodies[k];
		const cni_velocity_start *v = cni_starts(world) + sparse->bodies[k];
		sum += at_start ? cni_energy_twice(m, v->vx, v->vy, v->w) : cni_energy_twice(m, m->vx, m->vy, m->w);
	}
	return sum;
}

static void warm_start_remove(cn_world *world, const cni_sparse *sparse, const cni_component *c)
{
	for (int32_t k = c->begin; k < c->end; ++k) {
		const cni_joint_constraint *w = cni_joint_constraints(world) + sparse->nodes[k].owner;
		for (int32_t i = 0; sparse->nodes[k].owner >= 0 && i < w->row_count; ++i)
			cni_lever_push(&w->rows[i].lever, -w->rows[i].impulse, cni_motions(world) + w->ia, cni_motions(world) + w->ib);
	}
}

static void impulses_clear(const cn_world *world, const cni_sparse *sparse, const cni_component *c)
{
	for (int32_t k = c->begin; k < c->end; ++k) {
		cni_joint_constraint *w = cni_joint_constraints(world) + sparse->nodes[k].owner;
		for (int32_t i = 0; sparse->nodes[k].owner >= 0 && i < w->row_count; ++i)
			w->rows[i].impulse = 0.0f;
	}
}

/*
 * The impulses of the last substep belong to its levers. Where a net turns fast or is nearly straight they are large, and those of turned
 * levers bring energy that a solution with yielding rows does not take out again.
 */
void cni_component_start(cn_world *world, cni_sparse *sparse, const cni_component *c)
{
	float warm, allowed;
	if (!c->loops || c->active)
		return;
	warm = energy_twice(world, sparse, c, 0);
	allowed = cni_component_mass(world, sparse, c) * cni_sq(CNI_WARM_PUSH_PART * world->settings.push_speed_max);
	if (warm <= CNI_WARM_ENERGY_MOST * energy_twice(world, sparse, c, 1) + allowed)
		return;
	cni_direct_motions_save(world, sparse, c, 0);
	warm_start_remove(world, sparse, c);
	if (warm > CNI_WARM_ENERGY_MOST * energy_twice(world, sparse, c, 0) + allowed)
		impulses_clear(world, sparse, c);
	else
		cni_direct_motions_save(world, sparse, c, 1);
}

/* Its joints are soft from now on, without the impulses of the solution that failed: they cancel each other in light bodies, and soft joints,
   which yield one by one, would throw those. */
void cni_component_give_up(cn_world *world, cni_sparse *sparse, cni_component *c)
{
	for (int32_t k = c->begin; c->pending == CNI_FAILED_JOINTS && k < c->end; ++k) {
		cni_joint_constraint *w = cni_joint_constraints(world) + sparse->nodes[k].owner;
		for (int32_t i = 0; sparse->nodes[k].owner >= 0 && i < w->row_count; ++i)
			row_forget(world, &w->rows[i], w->ia, w->ib);
	}
	if (c->pending)
		cni_component_suspend(world, sparse, c, 0);
	c->pending = 0;
}

void cni_component_solve(cn_world *world, const cni_solve *s, cni_component *c, int32_t bias)
{
	if (!(c->active ? set_solve(world, s, s->direct, c, bias) : cni_direct_apply(world, s->direct, c)))
		c->pending = CNI_FAILED_JOINTS;
}

int32_t cni_component_lock(cn_world *world, const cni_solve *s, cni_component *c, float turn)
{
	if (c->has_contacts || c->done || c->pending || !cni_geometric_stiffness_lock(world, s->direct, c, turn * s->inv_h))
		return 0;
	cni_sparse_factor(s->direct, c, cni_motions(world));
	cni_direct_right_sides(world, s, c, 1);
	if (!cni_direct_apply(world, s->direct, c))
		c->pending = CNI_FAILED_JOINTS;
	else if (c->active)
		(void)cni_active_change(world, s, s->direct, c, 1); /* bounds alone: the system of another set has no locks */
	return 1;
}
