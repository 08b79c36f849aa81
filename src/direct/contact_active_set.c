/*
 * direct/contact_active_set.c - directly solved contacts: the linear system of a set of rows, and the active-set method that finds which hold.
 *
 * Every row is open (no impulse), held (its speed is what it must be) or, for friction, sliding (its impulse is the
 * coefficient times the normal impulses). Held rows and the island's joints are one linear system (sparse.h). After
 * solving it, a held point that pulls opens, an open one that closes is held, friction beyond the static
 * coefficient slides, a slide that would go back is held; and again, until nothing changes. The sets of the pass
 * before are nearly always right, and arms do not turn within a step, so that a pile costs about one
 * factorization a step.
 *
 * Points that overlap are pushed apart by PUSH_RATE of the overlap in a substep: slowly, since all of a pile is pushed
 * at once. The second pass of a substep takes that speed out again.
 *
 * Reads and writes presses, motion velocities, joint works' impulses.
 */
#include "direct/direct_contact.h"
#include "direct/direct_system.h"

#include <string.h>

#define ROUNDS_ALL 6           /* in which all that does not fit is changed at once */
#define ROUNDS_WARM 4          /* from impulses of the last pass */
#define REFINEMENTS 3          /* solutions with one factorization */
#define PUSH_RATE 0.1f
#define TOUCHING 5e-6f         /* length units: a lesser gap or overlap is rounding of positions. Rows that say the same twice would
                                  answer to what they say of it differently with impulses beyond measure */

/* ---- what a round begins with ---- */

static float normal_sum(const cni_direct_contact *p)
{
	return p->j[0] + p->j[1];
}

/* Friction is there while a point is held. */
static void friction_follow(cni_direct_contact *p)
{
	int32_t held = p->state[0] == CNI_ROW_HELD || p->state[1] == CNI_ROW_HELD;
	if (!held)
		p->state[2] = CNI_ROW_OPEN;
	else if (p->state[2] == CNI_ROW_OPEN)
		p->state[2] = CNI_ROW_HELD;
}

static void press_room(const cni_direct_contact_pass *q, cni_direct_contact *p, const cni_node *n)
{
	const cni_motion *a = q->motions + n->ia, *b = q->motions + n->ib;
	float touch = TOUCHING * q->world->settings.length_unit;
	int32_t i;
	for (i = 0; i < 2; ++i) {
		float s = p->mass[i] > 0.0f ? cni_direct_contact_separation(p, i, a, b) : 0.0f, push;
		s = s > 0.0f ? cni_max(s - touch, 0.0f) : cni_min(s + touch, 0.0f);
		push = PUSH_RATE * q->s->inv_h * s;
		p->room[i] = s > 0.0f ? s * q->s->inv_h : q->bias ? cni_max(push, -q->s->push_speed) : 0.0f;
	}
	friction_follow(p);
}

void cni_direct_contact_rooms_find(const cni_direct_contact_pass *q)
{
	int32_t k;
	for (k = q->c->begin; k < q->c->end; ++k) {
		cni_direct_contact *p = cni_direct_contact_of(q->sparse, &q->sparse->nodes[k]);
		if (p != NULL)
			press_room(q, p, &q->sparse->nodes[k]);
	}
}

/*
 * Before a pushing pass: velocities as the drive makes them, without the response to the last substep's impulses, and no
 * impulses but those of rows that are not part of the system. What is known from the last substep is the set.
 * Carrying impulses over would leave what a system that says things twice does not see to grow from substep to
 * substep.
 */
void cni_direct_contact_impulses_forget(const cni_direct_contact_pass *q)
{
	int32_t k, i;
	for (k = q->c->body_begin; k < q->c->body_end; ++k) {
		cni_motion *m = q->motions + q->sparse->bodies[k];
		const cni_velocity_start *start = cni_starts(q->world) + q->sparse->bodies[k];
		m->vx = start->vx;
		m->vy = start->vy;
		m->w = start->w;
	}
	for (k = q->c->begin; k < q->c->end; ++k) {
		const cni_node *n = &q->sparse->nodes[k];
		cni_direct_contact *p = cni_direct_contact_of(q->sparse, n);
		for (i = 0; p == NULL && i < cni_joint_constraints(q->world)[n->owner].row_count; ++i) {
			cni_row *r = &cni_joint_constraints(q->world)[n->owner].rows[i];
			cni_lever l = cni_row_lever(r);
			if (i < n->rows)
				r->impulse = 0.0f;
			else
				cni_lever_push(&l, r->impulse, q->motions + n->ia, q->motions + n->ib);
		}
	}
}

/* What every round of a pass begins with: no impulses, or those of the last pass. */
void cni_direct_contact_round_begin(const cni_direct_contact_pass *q)
{
	int32_t k, i;
	if (q->bias)
		cni_direct_contact_impulses_forget(q);
	else
		cni_direct_motions_keep(q->world, q->sparse, q->c, 1);
	for (k = q->c->begin; k < q->c->end; ++k) {
		const cni_node *n = &q->sparse->nodes[k];
		cni_direct_contact *p = cni_direct_contact_of(q->sparse, n);
		for (i = 0; p != NULL && i < 3; ++i) {
			p->start[i] = q->bias && !q->warm ? 0.0f : n->carried[i];
			if (q->bias)
				cni_direct_contact_push(p, i, p->start[i], q->motions + n->ia, q->motions + n->ib);
		}
	}
}

void cni_direct_contact_states_keep(const cni_direct_contact_pass *q, int32_t back)
{
	int32_t k, i;
	for (k = q->c->begin; k < q->c->end; ++k) {
		cni_direct_contact *p = cni_direct_contact_of(q->sparse, &q->sparse->nodes[k]);
		for (i = 0; p != NULL && i < 3; ++i)
			*(back ? &p->state[i] : &p->state_kept[i]) = back ? p->state_kept[i] : p->state[i];
	}
}

/* What touches and does not part is held: in a new pile all of it must bear at once. */
static void press_hold(const cni_direct_contact_pass *q, cni_direct_contact *p, const cni_node *n)
{
	int32_t i;
	for (i = 0; i < 2; ++i) {
		cni_lever l = cni_direct_contact_lever(p, i);
		if (p->mass[i] > 0.0f && p->state[i] == CNI_ROW_OPEN && cni_lever_speed(&l, q->motions + n->ia, q->motions + n->ib) + p->room[i] < q->speed_least)
			p->state[i] = CNI_ROW_HELD;
	}
	friction_follow(p);
}

static void touching_hold(const cni_direct_contact_pass *q)
{
	int32_t k;
	for (k = q->c->begin; k < q->c->end; ++k) {
		cni_direct_contact *p = cni_direct_contact_of(q->sparse, &q->sparse->nodes[k]);
		if (p != NULL)
			press_hold(q, p, &q->sparse->nodes[k]);
	}
}

/* ---- the system of a set ---- */

/* Levers of what is held; 1 when they are not those of the last factorization. */
static int32_t press_levers(const cni_direct_contact *p, cni_node *n)
{
	int32_t i, changed = 0;
	for (i = 0; i < 3; ++i) {
		int32_t held = p->state[i] == CNI_ROW_HELD, was = (n->held >> i) & 1;
		if (held == was)
			continue;
		memset(&n->lever[i], 0, sizeof n->lever[i]);
		if (held)
			n->lever[i] = cni_direct_contact_lever(p, i);
		n->held ^= 1 << i;
		changed = 1;
	}
	return changed;
}

/* Known impulses of what is not held, as changes of velocity. */
static int32_t presses_set(const cni_direct_contact_pass *q)
{
	int32_t k, i, changed = 0;
	for (k = q->c->begin; k < q->c->end; ++k) {
		cni_node *n = &q->sparse->nodes[k];
		cni_direct_contact *p = cni_direct_contact_of(q->sparse, n);
		float sum;
		n->total[0] = n->total[1] = n->total[2] = 0.0f;
		if (p == NULL)
			continue;
		sum = normal_sum(p);
		for (i = 0; i < 3; ++i) {
			p->j[i] = p->state[i] == CNI_ROW_HELD ? p->start[i] : p->state[i] == CNI_ROW_SLIDES ? p->way * p->dynamic_friction * cni_max(sum, 0.0f) : 0.0f;
			cni_direct_contact_push(p, i, p->j[i] - p->start[i], q->motions + n->ia, q->motions + n->ib);
		}
		changed |= press_levers(p, n);
	}
	return changed;
}

/* Speed that a row is to have beside what it has. */
static float press_lacks(const cni_direct_contact_pass *q, const cni_direct_contact *p, int32_t row)
{
	if (p->state[row] != CNI_ROW_HELD || p->mass[row] == 0.0f)
		return 0.0f;
	return (row < 2 ? p->room[row] : 0.0f) + (q->warm ? cni_direct_contact_leak(p, row) : 0.0f);
}

/* What the held rows' speeds lack; returns the largest. */
static float right_sides(const cni_direct_contact_pass *q)
{
	float largest = 0.0f;
	const float rate = q->bias ? CNI_JOINT_ERROR_RATE * q->s->inv_h : 0.0f;
	int32_t k, i;
	for (k = q->c->begin; k < q->c->end; ++k) {
		cni_node *n = &q->sparse->nodes[k];
		const cni_direct_contact *p = cni_direct_contact_of(q->sparse, n);
		const cni_row *rows = p == NULL ? cni_joint_constraints(q->world)[n->owner].rows : NULL;
		for (i = 0; i < CNI_NODE_ROWS; ++i) {
			float more = p != NULL ? press_lacks(q, p, i) : i < n->rows ? cni_clamp(rate * rows[i].error, -q->s->push_speed, q->s->push_speed) : 0.0f;
			n->x[i] = -cni_lever_speed(&n->lever[i], q->motions + n->ia, q->motions + n->ib) - more;
			largest = cni_max(largest, cni_abs(n->x[i]));
		}
	}
	return largest;
}

static void velocities_push(const cni_direct_contact_pass *q)
{
	int32_t k, i;
	for (k = q->c->begin; k < q->c->end; ++k) {
		cni_node *n = &q->sparse->nodes[k];
		cni_direct_contact *p = cni_direct_contact_of(q->sparse, n);
		for (i = 0; i < CNI_NODE_ROWS; ++i) {
			n->total[i] += n->x[i];
			cni_lever_push(&n->lever[i], n->x[i], q->motions + n->ia, q->motions + n->ib);
			if (p != NULL && p->state[i] == CNI_ROW_HELD)
				p->j[i] += n->x[i];
		}
	}
}

/* Again with what is left, because the diagonal is not quite the true one. 0: no finite solution. */
static int32_t held_rows_solve(const cni_direct_contact_pass *q)
{
	int32_t k;
	for (k = 0; k < REFINEMENTS && (right_sides(q) > 0.5f * q->speed_least || k == 0); ++k) {
		if (!cni_sparse_solve(q->sparse, q->c))
			return 0;
		velocities_push(q);
	}
	return 1;
}

int32_t cni_direct_contact_system_solve(const cni_direct_contact_pass *q)
{
	if (presses_set(q) || !q->c->factored) {
		cni_sparse_factor(q->sparse, q->c, q->motions);
		q->c->factored = 1;
	}
	return held_rows_solve(q);
}

/* ---- the set ---- */

/* A row whose state does not fit the solution, what it should be, and by how much speed it is wrong. */
typedef struct misfit {
	cni_direct_contact *press;
	int32_t row;
	uint8_t next;
	float by;
} misfit;

static misfit point_misfit(const cni_direct_contact_pass *q, cni_direct_contact *p, const cni_node *n, int32_t i)
{
	misfit m = { p, i, p->state[i], 0.0f };
	cni_lever l = cni_direct_contact_lever(p, i);
	if (p->mass[i] == 0.0f)
		return m;
	if (p->state[i] == CNI_ROW_HELD) {
		m.by = -p->j[i] / p->mass[i];
		m.next = CNI_ROW_OPEN;
	} else {
		m.by = -(cni_lever_speed(&l, q->motions + n->ia, q->motions + n->ib) + p->room[i]);
		m.next = CNI_ROW_HELD;
	}
	return m;
}

static misfit friction_misfit(const cni_direct_contact_pass *q, cni_direct_contact *p, const cni_node *n)
{
	misfit m = { p, 2, p->state[2], 0.0f };
	cni_lever l = cni_direct_contact_lever(p, 2);
	float sum = cni_max(normal_sum(p), 0.0f);
	if (p->state[2] == CNI_ROW_SLIDES) {
		m.by = cni_lever_speed(&l, q->motions + n->ia, q->motions + n->ib) * p->way;
		m.next = CNI_ROW_HELD;
	} else if (p->state[2] == CNI_ROW_HELD && p->mass[2] > 0.0f) {
		m.by = (cni_abs(p->j[2]) - p->static_friction * sum) / p->mass[2];
		m.next = CNI_ROW_SLIDES;
	}
	return m;
}

static void mend(const misfit *m)
{
	cni_direct_contact *p = m->press;
	if (m->next == CNI_ROW_SLIDES)
		p->way = p->j[2] > 0.0f ? 1.0f : -1.0f;
	p->state[m->row] = m->next;
	friction_follow(p);
}

/* Sliding friction that its normal force has moved away from. */
static int32_t slide_is_off(const cni_direct_contact_pass *q, const cni_direct_contact *p)
{
	float most = p->dynamic_friction * cni_max(normal_sum(p), 0.0f), off = cni_abs(cni_abs(p->j[2]) - most);
	return p->state[2] == CNI_ROW_SLIDES && off > CNI_SLIDE_CLOSE * most + q->speed_least * p->mass[2];
}

/* What is not consistent with the solution: rows that do not fit; -1: slides alone are off. The next set has all of them mended at
   once, or the worst alone, which is slow and sure (Murty, 1974). */
static int32_t set_mend(const cni_direct_contact_pass *q, int32_t all)
{
	misfit worst = { NULL, 0, 0, 0.0f };
	int32_t k, i, misfits = 0, off = 0;
	worst.by = q->speed_least;
	for (k = q->c->begin; k < q->c->end; ++k) {
		const cni_node *n = &q->sparse->nodes[k];
		cni_direct_contact *p = cni_direct_contact_of(q->sparse, n);
		misfit m[3];
		if (p == NULL)
			continue;
		off |= slide_is_off(q, p);
		m[0] = point_misfit(q, p, n, 0);
		m[1] = point_misfit(q, p, n, 1);
		m[2] = friction_misfit(q, p, n);
		for (i = 0; i < 3; ++i) {
			if (m[i].by <= q->speed_least)
				continue;
			++misfits;
			if (all)
				mend(&m[i]);
			else if (m[i].by > worst.by)
				worst = m[i];
		}
	}
	if (worst.press != NULL)
		mend(&worst);
	return misfits == 0 && off ? -1 : misfits;
}

/* Is this set the solution? Returns what does not fit in it, which is mended; INT32_MAX: it has none. */
static int32_t set_try(const cni_direct_contact_pass *q, int32_t all)
{
	cni_direct_contact_round_begin(q);
	return cni_direct_contact_system_solve(q) ? set_mend(q, all) : INT32_MAX;
}

int32_t cni_direct_contact_set_follow(const cni_direct_contact_pass *q)
{
	int32_t round, misfits = -1;
	for (round = 0; misfits != 0 && misfits < INT32_MAX && round < ROUNDS_WARM; ++round)
		misfits = set_try(q, 1);
	return misfits == 0;
}

/* Is it time to give up? Misfits of the rounds to come are mended one each. */
static int32_t rounds_are_over(const cni_direct_contact_pass *q, int32_t round, int32_t misfits)
{
	return misfits == INT32_MAX || round >= q->rounds || (round >= ROUNDS_ALL && misfits > q->rounds - round);
}

/* The set of the pass before; if it does not fit, from that and all that touches. Where slides alone are off it stays. */
int32_t cni_direct_contact_set_find(const cni_direct_contact_pass *q)
{
	int32_t round, misfits = set_try(q, 1), fits = 1;
	for (round = 0; misfits != 0 && !rounds_are_over(q, round, misfits); ++round) {
		if (fits && misfits > 0) {
			cni_direct_contact_states_keep(q, 1);
			cni_direct_contact_round_begin(q);
			touching_hold(q);
			fits = 0;
		}
		misfits = set_try(q, round < ROUNDS_ALL);
	}
	return misfits == 0;
}
