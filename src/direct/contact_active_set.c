/*
 * direct/contact_active_set.c - directly solved contacts: the linear system of a set of rows, and the active-set method that finds the set.
 *
 * Every row is open (no impulse), active (its speed is prescribed) or, for friction, sliding (its impulse is the coefficient times the normal
 * impulses). Active rows and the island's joints are one linear system (sparse.h). After a solution an active point with a negative impulse
 * opens, an open point that closes becomes active, friction beyond the static coefficient slides, and a slide against its direction becomes
 * active. This repeats until nothing changes. The sets of the last pass are nearly always right, and lever arms are fixed during a step, so a
 * pile costs about one factorization a step.
 *
 * Overlapping points are pushed apart by CNI_CONTACT_SET_PUSH_RATE of the overlap in a substep: slowly, since all of a pile is pushed at
 * once. The second pass of a substep removes that speed. An island that swayed with soft contacts leans on edges that they let yield: pushed
 * at that rate where it turns, it would be lifted onto these edges, and fall back further each time. So its first steps push more slowly.
 *
 * Reads and writes direct contacts, motion velocities, impulses of joint constraints.
 */
#include "direct/direct_contact.h"
#include "direct/direct_system.h"

#include <string.h>

/* ---- the beginning of a round ---- */

static float normal_sum(const cni_direct_contact *p)
{
	return p->j[0] + p->j[1];
}

static float speed_of(const cni_direct_contact_pass *q, const cni_direct_contact *p, int32_t row)
{
	return cni_direct_contact_speed(p, row, q->motions + p->ia, q->motions + p->ib);
}

/* Friction acts only while a point is active. */
static void friction_follow(const cni_direct_contact_pass *q, cni_direct_contact *p)
{
	int32_t active = p->state[0] == CNI_ROW_ACTIVE || p->state[1] == CNI_ROW_ACTIVE;
	if (!active || (q->smooth && p->slips))
		p->state[2] = CNI_ROW_OPEN;
	else if (p->state[2] == CNI_ROW_OPEN)
		p->state[2] = CNI_ROW_ACTIVE;
}

/* 1: the island has just been selected, and it owes for motion, or for attempts at its solution. */
static int32_t may_sway(const cni_direct_contact_pass *q)
{
	return q->world->settings.solver == CN_SOLVER_AUTO && q->island->asked_step != 0 &&
	       q->world->step_count + 1u - q->island->asked_step < CNI_CONTACT_SET_SWAY_STEPS && cni_cone_debt(q->world, q->island) > 0;
}

void cni_direct_contact_gap_speeds_find(const cni_direct_contact_pass *q)
{
	float touch = CNI_CONTACT_SET_TOUCHING * q->world->settings.length_unit;
	float left = may_sway(q) ? 1.0f - CNI_CONTACT_SET_SWAY_PART : 0.0f, slop = q->world->settings.slop;
	float rate = CNI_CONTACT_SET_PUSH_RATE * cni_min(q->s->inv_h, q->s->soft_rate);
	for (cni_direct_contact *p = q->first; p < q->end; ++p) {
		for (int32_t i = 0; i < 2; ++i) {
			float s = p->mass[i] > 0.0f ? cni_direct_contact_separation(p, i, q->motions + p->ia, q->motions + p->ib) : 0.0f, push;
			s = s > 0.0f ? cni_max(s - touch, 0.0f) : cni_min(s + touch, 0.0f);
			push = rate * (s - left * cni_max(s, -slop));
			p->gap_speed[i] = s > 0.0f ? s * q->s->inv_h : q->bias ? cni_max(push, -q->s->push_speed) : 0.0f;
		}
		friction_follow(q, p);
	}
}

/*
 * Before a pass with bias: resets velocities to those after external accelerations, without the response to the last substep's impulses,
 * and clears all impulses but those of rows outside the system. Only the set is known from the last substep. Impulses carried over would
 * let components that a redundant system does not see grow from substep to substep.
 */
void cni_direct_contact_impulses_clear(const cni_direct_contact_pass *q)
{
	for (int32_t k = q->c->body_begin; k < q->c->body_end; ++k) {
		cni_motion *m = q->motions + q->sparse->bodies[k];
		const cni_velocity_start *start = cni_starts(q->world) + q->sparse->bodies[k];
		m->vx = start->vx;
		m->vy = start->vy;
		m->w = start->w;
	}
	for (int32_t k = q->c->begin; k < q->c->end; ++k) {
		const cni_node *n = &q->sparse->nodes[k];
		for (int32_t i = 0; n->owner >= 0 && i < cni_joint_constraints(q->world)[n->owner].row_count; ++i) {
			cni_row *r = &cni_joint_constraints(q->world)[n->owner].rows[i];
			if (i < n->rows)
				r->impulse = 0.0f;
			else
				cni_lever_push(&r->lever, r->impulse, q->motions + n->ia, q->motions + n->ib);
		}
	}
}

/* Initial state of every round of a pass: no impulses, or those of the last pass. */
void cni_direct_contact_round_begin(const cni_direct_contact_pass *q)
{
	if (q->bias)
		cni_direct_contact_impulses_clear(q);
	else
		cni_direct_motions_save(q->world, q->sparse, q->c, 1);
	for (cni_direct_contact *p = q->first; p < q->end; ++p)
		for (int32_t i = 0; i < 3; ++i) {
			p->start[i] = q->bias && !q->warm ? 0.0f : q->sparse->nodes[p->node].carried[i];
			if (q->bias)
				cni_direct_contact_push(p, i, p->start[i], q->motions + p->ia, q->motions + p->ib);
		}
}

void cni_direct_contact_states_save(const cni_direct_contact_pass *q, int32_t restore)
{
	for (cni_direct_contact *p = q->first; p < q->end; ++p)
		memcpy(restore ? p->state : p->state_kept, restore ? p->state_kept : p->state, sizeof p->state);
}

/* Activates touching points that do not separate: in a new pile all of them must carry at once. */
static void touching_activate(const cni_direct_contact_pass *q)
{
	for (cni_direct_contact *p = q->first; p < q->end; ++p) {
		for (int32_t i = 0; i < 2; ++i)
			if (p->mass[i] > 0.0f && p->state[i] == CNI_ROW_OPEN && speed_of(q, p, i) + p->gap_speed[i] < q->speed_least)
				p->state[i] = CNI_ROW_ACTIVE;
		friction_follow(q, p);
	}
}

/* ---- the system of a set ---- */

/* Sets the levers of active rows. Returns 1 when they differ from those of the last factorization. */
static int32_t contact_levers_set(const cni_direct_contact *p, cni_node *n)
{
	int32_t i, changed = 0;
	for (i = 0; i < 3; ++i) {
		int32_t active = p->state[i] == CNI_ROW_ACTIVE, was = (n->active >> i) & 1;
		if (active == was)
			continue;
		if (active)
			cni_levers_set(&n->levers, i, cni_direct_contact_lever(p, i));
		else
			cni_levers_clear(&n->levers, i);
		n->active ^= 1 << i;
		changed = 1;
	}
	return changed;
}

/* Applies the known impulses of rows that are not active. */
static int32_t set_apply(const cni_direct_contact_pass *q)
{
	int32_t k, i, changed = 0;
	for (k = q->c->begin; k < q->c->end; ++k) {
		cni_node *n = &q->sparse->nodes[k];
		cni_direct_contact *p = cni_direct_contact_of(q->sparse, n);
		n->total[0] = n->total[1] = n->total[2] = 0.0f;
		if (p == NULL)
			continue;
		float sum = normal_sum(p);
		for (i = 0; i < 3; ++i) {
			p->j[i] = p->state[i] == CNI_ROW_ACTIVE ? p->start[i] : p->state[i] == CNI_ROW_SLIDES ? p->slide_sign * p->dynamic_friction * cni_max(sum, 0.0f) : 0.0f;
			cni_direct_contact_push(p, i, p->j[i] - p->start[i], q->motions + n->ia, q->motions + n->ib);
		}
		changed |= contact_levers_set(p, n);
	}
	return changed;
}

/* Prescribed part of the row's right side. */
static float prescribed_speed(const cni_direct_contact_pass *q, const cni_direct_contact *p, int32_t row)
{
	if (p->state[row] != CNI_ROW_ACTIVE || p->mass[row] == 0.0f)
		return 0.0f;
	return (row < 2 ? p->gap_speed[row] : 0.0f) + (q->warm ? cni_direct_contact_leak(p, row) : 0.0f);
}

/* Missing speeds of the active rows; returns the largest. */
static float right_sides(const cni_direct_contact_pass *q)
{
	float largest = 0.0f;
	for (int32_t k = q->c->begin; k < q->c->end; ++k) {
		cni_node *n = &q->sparse->nodes[k];
		const cni_direct_contact *p = cni_direct_contact_of(q->sparse, n);
		float speed[CNI_NODE_LANES];
		cni_four_store(speed, cni_levers_speed(&n->levers, q->motions + n->ia, q->motions + n->ib));
		for (int32_t i = 0; i < CNI_NODE_ROWS; ++i) {
			float more = p != NULL ? prescribed_speed(q, p, i) : q->bias ? n->closing[i] : 0.0f;
			n->x[i] = -speed[i] - more;
			largest = cni_max(largest, cni_abs(n->x[i]));
		}
	}
	return largest;
}

static void velocities_push(const cni_direct_contact_pass *q)
{
	for (int32_t k = q->c->begin; k < q->c->end; ++k) {
		cni_node *n = &q->sparse->nodes[k];
		cni_direct_contact *p = cni_direct_contact_of(q->sparse, n);
		cni_levers_push(&n->levers, n->x, q->motions + n->ia, q->motions + n->ib, CNI_NODE_ROWS);
		for (int32_t i = 0; i < CNI_NODE_ROWS; ++i) {
			n->total[i] += n->x[i];
			if (p != NULL && p->state[i] == CNI_ROW_ACTIVE)
				p->j[i] += n->x[i];
		}
	}
}

/* Iterative refinement, because the diagonal is larger than the true one. The impulses of the last pass may leave nothing to solve. 0: no
   finite solution. */
int32_t cni_direct_contact_system_solve(const cni_direct_contact_pass *q)
{
	float regular = q->warm ? CNI_REGULARIZATION_WARM : CNI_REGULARIZATION_CONTACTS;
	int32_t many = q->warm && !cni_attempt_work_is_spent(q->world, q->c), k;
	int32_t rounds = many ? (int32_t)CNI_CONTACT_SET_REFINEMENTS_WARM : (int32_t)CNI_CONTACT_SET_REFINEMENTS;
	if (set_apply(q) || q->c->regular != regular)
		q->c->factored = 0;
	q->c->regular = regular;
	for (k = 0; k < rounds && (right_sides(q) > 0.5f * q->speed_least || (k == 0 && !q->warm)); ++k) {
		q->world->set_work += CNI_CONE_SOLUTION * (q->c->end - q->c->begin);
		if (!q->c->factored) {
			q->world->set_work += cni_cone_factor_work(q->c);
			cni_sparse_factor(q->sparse, q->c, q->motions);
		}
		q->c->factored = 1;
		if (!cni_sparse_solve(q->sparse, q->c))
			return 0;
		velocities_push(q);
	}
	return 1;
}

/* ---- the set ---- */

/* A row whose state contradicts the solution, the state it should have, and the speed by which it is violated. */
typedef struct violation {
	cni_direct_contact *contact;
	int32_t row;
	uint8_t next;
	float by;
} violation;

static violation point_violation(const cni_direct_contact_pass *q, cni_direct_contact *p, int32_t i)
{
	violation m = { p, i, p->state[i], 0.0f };
	if (p->mass[i] == 0.0f)
		return m;
	if (p->state[i] == CNI_ROW_ACTIVE) {
		m.by = -p->j[i] / p->mass[i];
		m.next = CNI_ROW_OPEN;
	} else {
		m.by = -(speed_of(q, p, i) + p->gap_speed[i]);
		m.next = CNI_ROW_ACTIVE;
	}
	return m;
}

static violation friction_violation(const cni_direct_contact_pass *q, cni_direct_contact *p)
{
	violation m = { p, 2, p->state[2], 0.0f };
	float sum = cni_max(normal_sum(p), 0.0f);
	if (p->state[2] == CNI_ROW_SLIDES) {
		m.by = speed_of(q, p, 2) * p->slide_sign;
		m.next = CNI_ROW_ACTIVE;
	} else if (p->state[2] == CNI_ROW_ACTIVE && p->mass[2] > 0.0f) {
		m.by = (cni_abs(p->j[2]) - p->static_friction * sum) / p->mass[2];
		m.next = CNI_ROW_SLIDES;
	}
	return m;
}

static void violation_fix(const cni_direct_contact_pass *q, const violation *m)
{
	cni_direct_contact *p = m->contact;
	if (m->next == CNI_ROW_SLIDES)
		p->slide_sign = p->j[2] > 0.0f ? 1.0f : -1.0f;
	p->state[m->row] = m->next;
	friction_follow(q, p);
}

/* Updates the set: all violated rows at once, or the worst alone, which is slow and sure (Murty, 1974). Returns the number of violated
   rows; -1: only sliding impulses do not match. */
static int32_t set_update(const cni_direct_contact_pass *q, int32_t all)
{
	violation worst = { NULL, 0, 0, 0.0f };
	int32_t i, violations = 0, off = 0;
	worst.by = q->speed_least;
	for (cni_direct_contact *p = q->first; p < q->end; ++p) {
		float most = p->dynamic_friction * cni_max(normal_sum(p), 0.0f);
		violation m[3];
		off |= p->state[2] == CNI_ROW_SLIDES && cni_abs(cni_abs(p->j[2]) - most) > CNI_SLIDE_CLOSE * most + q->speed_least * p->mass[2];
		m[0] = point_violation(q, p, 0);
		m[1] = point_violation(q, p, 1);
		m[2] = friction_violation(q, p);
		for (i = 0; i < 3; ++i) {
			if (m[i].by <= q->speed_least)
				continue;
			++violations;
			if (all)
				violation_fix(q, &m[i]);
			else if (m[i].by > worst.by)
				worst = m[i];
		}
	}
	if (worst.contact != NULL)
		violation_fix(q, &worst);
	return violations == 0 && off ? -1 : violations;
}

float cni_direct_contact_set_error(const cni_direct_contact_pass *q)
{
	float most = 0.0f;
	for (cni_direct_contact *p = q->first; p < q->end; ++p)
		most = cni_max(most, cni_max(friction_violation(q, p).by, cni_max(point_violation(q, p, 0).by, point_violation(q, p, 1).by)));
	return most;
}

/* Solves with the present set and updates it. Returns the number of violated rows; INT32_MAX: no solution. */
static int32_t set_try(const cni_direct_contact_pass *q, int32_t all)
{
	cni_direct_contact_round_begin(q);
	return cni_direct_contact_system_solve(q) ? set_update(q, all) : INT32_MAX;
}

/* Where only sliding impulses do not match, the set stays, so that a round costs a solution and no factorization. Returns the last result of
   set_try. */
static int32_t slides_match(const cni_direct_contact_pass *q, int32_t all, int32_t violations)
{
	for (int32_t k = 0; violations < 0 && k < CNI_CONTACT_SET_SLIDES; ++k)
		violations = set_try(q, all);
	return violations;
}

int32_t cni_direct_contact_set_follow(const cni_direct_contact_pass *q)
{
	int32_t round = 0, violations;
	do {
		violations = slides_match(q, 1, set_try(q, 1));
		++round;
	} while (violations != 0 && violations < INT32_MAX && round < CNI_CONTACT_SET_ROUNDS_WARM && !cni_attempt_work_is_spent(q->world, q->c));
	return violations == 0;
}

/* Structures that have a set violate few rows from the third try on, heaps that have none as many as they have contacts in each. */
static int32_t is_in_vain(const cni_direct_contact_pass *q, int32_t round, int32_t violations)
{
	return q->world->settings.solver == CN_SOLVER_AUTO && q->island->solver == CN_SOLVER_AUTO && round > 1 &&
		2 * violations > q->c->end - q->c->begin;
}

/* 1: the search gives up. In later rounds one violated row is fixed a round. */
static int32_t rounds_are_over(const cni_direct_contact_pass *q, int32_t round, int32_t violations)
{
	return violations == INT32_MAX || round >= q->rounds || (round >= CNI_CONTACT_SET_ROUNDS_ALL && violations > q->rounds - round) ||
		is_in_vain(q, round, violations) || cni_attempt_work_is_spent(q->world, q->c);
}

/* Starts from the set of the last pass; if more than one of its rows is violated, or one is again, from it and all touching points. */
int32_t cni_direct_contact_set_find(const cni_direct_contact_pass *q)
{
	int32_t round, violations = slides_match(q, 1, set_try(q, 1)), fits = 1;
	for (round = 0; violations != 0 && !rounds_are_over(q, round, violations); ++round) {
		int32_t all = round < CNI_CONTACT_SET_ROUNDS_ALL;
		if (fits && violations > (round == 0)) {
			cni_direct_contact_states_save(q, 1);
			cni_direct_contact_round_begin(q);
			touching_activate(q);
			fits = 0;
		}
		violations = slides_match(q, all, set_try(q, all));
	}
	return violations == 0;
}

float cni_direct_contact_normal_sum(const cni_direct_contact_pass *q)
{
	float sum = 0.0f;
	for (const cni_direct_contact *p = q->first; p < q->end; ++p)
		sum += p->j[0] + p->j[1];
	return sum;
}

float cni_direct_contact_smooth_sum(const cni_direct_contact_pass *q)
{
	cni_direct_contact_pass smooth = *q;
	smooth.smooth = 1;
	smooth.warm = 0;
	for (cni_direct_contact *p = q->first; p < q->end; ++p)
		friction_follow(&smooth, p);
	if (!cni_direct_contact_set_find(&smooth))
		return FLT_MAX;
	return cni_direct_contact_normal_sum(q);
}
