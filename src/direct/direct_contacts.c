/*
 * direct/direct_contacts.c - directly solved contacts: one pass over an island, the choice of method and the checks of its solution.
 *
 * An active-set method finds the active rows (direct/contact_active_set.c). Where it finds no set in CNI_CONTACT_SET_ROUNDS,
 * or where an island at rest begins to move by its solution, an interior-point method takes over (direct/friction_cones.c). The passes
 * after that start from its impulses instead of from none: of several redundant sets of impulses, the one of least energy may have negative ones. A solution that gains energy
 * is discarded: impulses of an inconsistent set can add it without bound. So is one in which friction jams what slides. The contacts then
 * return to the soft solver with the impulses and loads that they had, so that the attempt does not disturb a pile.
 *
 * Reads and writes lanes of contact blocks, motion velocities, impulses of joint constraints.
 */
#include "contacts/contacts.h"
#include "direct/direct_contact.h"
#include "direct/direct_system.h"

/* ---- impulses and velocities: committed, saved, restored ---- */

static void commit(const cni_direct_contact_pass *q)
{
	for (int32_t k = q->c->begin; k < q->c->end; ++k) {
		const cni_node *n = &q->sparse->nodes[k];
		if (n->owner >= 0)
			cni_node_impulses_add(n, cni_joint_constraints(q->world)[n->owner].rows, n->total);
	}
	for (cni_direct_contact *p = q->first; p < q->end; ++p) {
		p->j[0] = cni_max(p->j[0], 0.0f);
		p->j[1] = cni_max(p->j[1], 0.0f);
		p->untouched = 0;
	}
}

/* Saves impulses and velocities at the beginning of a pass (restore 0), or restores them (1). */
static void state_save(const cni_direct_contact_pass *q, int32_t restore)
{
	cni_direct_motions_save(q->world, q->sparse, q->c, restore);
	for (int32_t k = q->c->begin; k < q->c->end; ++k) {
		cni_node *n = &q->sparse->nodes[k];
		cni_direct_contact *p = cni_direct_contact_of(q->sparse, n);
		cni_row *rows = p == NULL ? cni_joint_constraints(q->world)[n->owner].rows : NULL;
		for (int32_t i = 0; i < n->rows; ++i) {
			float *impulse = p != NULL ? &p->j[i] : &rows[i].impulse;
			*(restore ? impulse : &n->carried[i]) = restore ? n->carried[i] : *impulse;
		}
	}
}

/* Before the first pass of a step: impulses of the last step for this one's length of a substep. */
static void impulses_scale(const cni_direct_contact_pass *q)
{
	for (cni_direct_contact *p = q->first; p < q->end; ++p)
		for (int32_t i = 0; p->untouched && i < 3; ++i)
			p->j[i] = q->s->warm_scale * p->first[i];
}

/*
 * No set was found: the soft solver continues from the velocities at the beginning of the substep and the impulses at the beginning of the
 * step. An exact solution sends an impact or a push through everything in its way: a body of a kilogram between two of a ton has the
 * impulses of both, which cancel to a thousandth. A soft solver that started from them would throw it. All are reduced by the same part:
 * where kinematic bodies squeeze a row, those on both sides of a body cancel.
 */
static void soft_state_restore(const cni_direct_contact_pass *q)
{
	int32_t all = q->c->joints == 0;
	float part = 1.0f;
	if (all)
		cni_direct_contact_impulses_clear(q);
	else
		state_save(q, 1);
	for (cni_direct_contact *p = q->first; p < q->end; ++p)
		if (all || p->untouched)
			part = cni_min(part, cni_direct_soft_part(q->world, p->first[0] + p->first[1], p->ia, p->ib));
	for (cni_direct_contact *p = q->first; p < q->end; ++p) {
		if (!all && !p->untouched)
			continue;
		p->untouched = 1;
		for (int32_t i = 0; i < 3; ++i) {
			p->j[i] = part * q->s->warm_scale * p->first[i];
			if (i < 2)
				p->load[i] *= part * q->s->warm_scale;
			cni_direct_contact_push(p, i, p->j[i], q->motions + p->ia, q->motions + p->ib);
		}
	}
}

/* 1: no contact was pushed. The speeds are then closed already, and only the lever arms of joints turn. */
static int32_t nothing_was_pushed(const cni_direct_contact_pass *q)
{
	for (const cni_direct_contact *p = q->first; p < q->end; ++p)
		if (p->gap_speed[0] < -q->speed_least || p->gap_speed[1] < -q->speed_least)
			return 0;
	return q->c->joints == 0;
}

/* ---- energy ---- */

/* Of a body, twice, in the frame of the island: there nothing that carries it does work. */
static float energy_at(const cni_direct_contact_pass *q, const cni_motion *m, float vx, float vy, float w)
{
	return cni_energy_twice(m, vx - q->frame.x, vy - q->frame.y, w);
}

/* NOW; at the beginning of the substep, after external accelerations and before any impulse; at the beginning of the step. */
enum moment { NOW, SUBSTEP_BEGIN, STEP_BEGIN };

/* Twice the kinetic energy of the component's bodies at this moment. */
static float energy_of(const cni_direct_contact_pass *q, enum moment moment)
{
	float sum = 0.0f;
	for (int32_t k = q->c->body_begin; k < q->c->body_end; ++k) {
		const int32_t index = q->sparse->bodies[k];
		const cni_motion *m = q->motions + index;
		const cni_velocity_start *v = cni_starts(q->world) + index;
		const cni_body *b = cni_body_at(q->world, cni_awake_ids(q->world)[index]);
		sum += moment == NOW ? energy_at(q, m, m->vx, m->vy, m->w) : moment == SUBSTEP_BEGIN ? energy_at(q, m, v->vx, v->vy, v->w) :
			energy_at(q, m, b->vx, b->vy, b->w);
	}
	return sum;
}

/* Twice the kinetic energy of all of it at a speed. */
static float energy_at_speed(const cni_direct_contact_pass *q, float speed)
{
	return cni_component_mass(q->world, q->sparse, q->c) * speed * speed;
}

/* ... at CNI_DIRECT_STILL_SPEED: with less it is at rest. A part may move on a standing island. */
static float energy_of_rest(const cni_direct_contact_pass *q)
{
	return energy_at_speed(q, CNI_DIRECT_STILL_SPEED * q->world->settings.length_unit);
}

/* 1: it moved at the beginning of the step. */
static int32_t was_moving(const cni_direct_contact_pass *q)
{
	return energy_of(q, STEP_BEGIN) > energy_of_rest(q);
}

/* Twice the work of pushing overlaps apart. */
static float push_work(const cni_direct_contact_pass *q)
{
	float sum = 0.0f;
	for (const cni_direct_contact *p = q->first; p < q->end; ++p)
		for (int32_t i = 0; i < 2; ++i)
			sum += 2.0f * p->j[i] * cni_max(-p->gap_speed[i], 0.0f);
	return sum;
}

/*
 * Where fixed and kinematic bodies squeeze others no impulses close all points, and the regularization alone bounds those that are found, by thousands
 * of weights. They are known by a point that still closes although it bears more than the momentum of all bodies, and of all pushed at once: a light
 * body under one of ten thousand times its mass closes as slowly, and bears no more than that.
 */
static int32_t points_are_squeezed(const cni_direct_contact_pass *q)
{
	float bears = 0.0f, push = 0.0f;
	for (const cni_direct_contact *p = q->first; p < q->end && q->c->joints == 0; ++p)
		for (int32_t i = 0; i < 2; ++i) {
			float speed = cni_direct_contact_speed(p, i, q->motions + p->ia, q->motions + p->ib) + p->gap_speed[i];
			push = cni_max(push, -p->gap_speed[i]);
			bears = cni_max(bears, speed < -CNI_DIRECT_PARTING * q->speed_least ? p->j[i] : 0.0f);
		}
	float mass = bears > 0.0f ? cni_component_mass(q->world, q->sparse, q->c) : 0.0f;
	return bears > CNI_DIRECT_SQUEEZE_MOST * (cni_sqrt(mass * q->before) + mass * push);
}

/*
 * With speeds w after and v before the impulses l, and speeds bounded below by -g (gap_speed), the energy grows by
 * l.(w + v) / 2 <= l.w <= -l.g: no more than the work of pushing apart. The relax pass removes the push: with all impulses of the
 * substep, the energy is then no more than at its beginning. Joints and bodies carried along may add more.
 * Nor is that work more than what stops all motion and pushes each body at push_speed times the root of the number of bodies: beyond that
 * the impulses push one body out of two overlaps in opposite directions, and would throw it in the next step.
 */
static int32_t energy_fits(const cni_direct_contact_pass *q)
{
	float bodies = (float)(q->c->body_end - q->c->body_begin), work = push_work(q);
	if (q->c->joints > 0)
		return 1;
	return energy_of(q, NOW) <= (1.0f + CNI_DIRECT_ENERGY_ROUNDING) * q->before + work &&
	       work <= 2.0f * (q->before + bodies * energy_at_speed(q, q->s->push_speed));
}

/* ---- jams ---- */

/* Marks contacts that slip. 1: there are any. */
static int32_t slips_mark(const cni_direct_contact_pass *q)
{
	float least = CNI_DIRECT_STILL_SPEED * q->world->settings.length_unit;
	int32_t some = 0;
	for (cni_direct_contact *p = q->first; p < q->end; ++p) {
		if (q->bias)
			p->slips = cni_abs(cni_direct_contact_speed(p, 2, q->motions + p->ia, q->motions + p->ib)) > least;
		some |= p->slips;
	}
	return some;
}

/*
 * Where bodies slide, Coulomb's law has more than one solution, or none without impacts (Painleve's paradox): friction that stops the slide
 * presses points together, whose impulses permit this friction. Such a jam obeys every cone, and takes its energy from the slide: in one step a
 * column of heavy boxes on light ones turned about its front edge as one block. Loads, approach and pushes explain the normal impulses without
 * the friction of what slips, and few more. Where no set is found without it, any are permitted.
 */
static void smooth_sum_find(cni_direct_contact_pass *q)
{
	q->smooth_sum = FLT_MAX;
	if (!slips_mark(q))
		return;
	q->smooth_sum = cni_max(cni_direct_contact_smooth_sum(q), q->speed_least * cni_component_mass(q->world, q->sparse, q->c));
	cni_direct_contact_states_save(q, 1);
	state_save(q, 1);
}

static int32_t is_jammed(const cni_direct_contact_pass *q)
{
	return cni_direct_contact_normal_sum(q) > CNI_CONTACT_SET_JAM * q->smooth_sum;
}

static int32_t is_acceptable(const cni_direct_contact_pass *q)
{
	return energy_fits(q) && !is_jammed(q);
}

/* 1: the impulses are far out of their cones. A relax pass may end with the set of its pass with bias, which is wrong where moving bodies part or
   slide without the pushes. */
static int32_t set_is_wrong(const cni_direct_contact_pass *q)
{
	return was_moving(q) && cni_direct_contact_set_error(q) > CNI_DIRECT_STILL_SPEED * q->world->settings.length_unit;
}

/* Solves with the set in which a body at rest begins to move, or with that of the pass with bias, as the interior-point method has not run or
   found nothing better. It was consistent: errors and energy tell whether it is so with the impulses of the pass. */
static int32_t solve_with_kept_set(const cni_direct_contact_pass *q)
{
	cni_direct_contact_states_save(q, 1);
	state_save(q, 1); /* for sliding friction: the impulses of a set that was no solution do not count */
	cni_direct_contact_round_begin(q);
	if (!cni_direct_contact_system_solve(q) || set_is_wrong(q) || !is_acceptable(q))
		return 0;
	commit(q);
	return 1;
}

/* ---- onset of motion ---- */

/* 1: the contact opens where it touches, or slides. */
static int32_t contact_starts_moving(const cni_direct_contact_pass *q, const cni_direct_contact *p)
{
	const cni_motion *a = q->motions + p->ia, *b = q->motions + p->ib;
	float most = CNI_DIRECT_PARTING * q->speed_least;
	if (p->state[2] == CNI_ROW_SLIDES && cni_abs(cni_direct_contact_speed(p, 2, a, b)) > most)
		return 1;
	for (int32_t i = 0; i < 2; ++i)
		if (p->state[i] == CNI_ROW_OPEN && p->mass[i] > 0.0f && p->gap_speed[i] < most && cni_direct_contact_speed(p, i, a, b) > most)
			return 1;
	return 0;
}

static int32_t starts_moving(const cni_direct_contact_pass *q)
{
	for (const cni_direct_contact *p = q->first; p < q->end; ++p)
		if (contact_starts_moving(q, p))
			return 1;
	return 0;
}

static int32_t is_recent(const cni_direct_contact_pass *q, uint32_t step)
{
	return step != 0 && q->world->step_count + 1u - step < 2u;
}

/* ---- choice of method ---- */

/* 1: too large for the interior-point method. */
static int32_t is_large(const cni_direct_contact_pass *q)
{
	return cni_cone_factor_work(q->c) > cni_attempt_work_most(q->world, q->c) / CNI_CONE_FACTORS;
}

/*
 * Friction may both hold a body and let it go, for example in a heap of balls: following the set of the last pass may find either. When a
 * body at rest begins to move, the interior-point method decides: it finds the motion of least energy.
 */
static int32_t set_solve(cni_direct_contact_pass *q)
{
	if (!(q->warm ? cni_direct_contact_set_follow(q) : cni_direct_contact_set_find(q)))
		return 0;
	if (!energy_fits(q)) {
		q->squeezed = points_are_squeezed(q);
		return 0;
	}
	if (is_jammed(q))
		return 0;
	if (q->bias && !is_recent(q, q->island->gives_step) && starts_moving(q) && !was_moving(q)) {
		cni_direct_contact_states_save(q, 0);
		q->kept = 1;
		return 0;
	}
	return 1;
}

static int32_t work_a_contact(const cni_direct_contact_pass *q)
{
	return cni_cone_factor_work(q->c) / (q->c->end - q->c->begin);
}

/* 1: the work of the step leaves little for it and its relax pass. The first of a step is never denied. */
static int32_t is_denied(const cni_direct_contact_pass *q)
{
	const cn_world *world = q->world;
	return world->cone_work > 0 && world->cone_work + world->set_work + 2 * CNI_CONE_FACTORS_LEAST * cni_cone_factor_work(q->c) > cni_attempt_work_most(world, q->c);
}

/* 1: the interior-point method may run: the island's debt and the work of the step allow it, and it is at rest, or small and struck or bad in this
   step (strike_check). A relax pass takes out the speed of the pushes that the pass before it has made, whatever is owed. */
static int32_t cone_is_admitted(cni_direct_contact_pass *q)
{
	int32_t struck = q->island->good_steps == 0 && q->island->count <= CNI_SELECTION_STRIKE_BODIES;
	if (!q->bias && q->c->cone_pushed)
		return 1;
	if (is_large(q) || (q->world->settings.solver == CN_SOLVER_AUTO &&
	    ((was_moving(q) && !struck) || cni_cone_debt(q->world, q->island) + CNI_CONE_FACTORS_LEAST * work_a_contact(q) > CNI_CONE_DEBT)))
		return 0;
	q->denied = is_denied(q);
	if (q->denied)
		return 0;
	q->c->cone_pushed = q->bias;
	return 1;
}

static void debt_add(const cni_direct_contact_pass *q, int32_t work)
{
	cni_cone_debt_set(q->world, q->island, cni_cone_debt(q->world, q->island) + work);
}

/* The next passes start from its impulses: starting from none would find redundant ones, some of them negative. */
static int32_t cone_solve(cni_direct_contact_pass *q)
{
	int32_t factors, good;
	if (!CNI_ON(CONES) || !cone_is_admitted(q))
		return 0;
	q->warm = 0;
	cni_direct_contact_round_begin(q);
	good = cni_direct_contacts_cone(q, &factors);
	q->world->cone_work += factors * cni_cone_factor_work(q->c);
	debt_add(q, factors * work_a_contact(q));
	if (!good || !is_acceptable(q))
		return 0;
	q->warm = 1;
	return 1;
}

static void solution_accept(const cni_direct_contact_pass *q)
{
	uint32_t step = q->world->step_count + 1u;
	if (q->warm)
		q->island->cone_step = step;
	if (q->bias && q->island->gives_step != step && starts_moving(q)) {
		q->island->falls_steps = energy_of(q, NOW) > energy_of_rest(q) && is_recent(q, q->island->gives_step) ? q->island->falls_steps + 1 : 0;
		q->island->gives_step = step;
	}
	commit(q);
	q->c->nothing_pushed = q->bias && nothing_was_pushed(q);
}

/* In a short step gravity alone gives less speed than counts as none otherwise, and what solutions leave open would be more energy than there is. */
static float speed_least(const cn_world *world, const cni_solve *s)
{
	return CNI_DIRECT_SPEED_LEAST * world->settings.length_unit * cni_min(s->h * (1.0f / CNI_DIRECT_SHORT_S), 1.0f);
}

int32_t cni_direct_contacts_solve(cn_world *world, const cni_solve *s, cni_sparse *sparse, cni_component *c, int32_t bias)
{
	cni_direct_contact_pass q = { world, s, sparse, c, cni_motions(world), sparse->contacts + c->contact_begin, sparse->contacts + c->contact_end, NULL, speed_least(world, s),
		bias, 0, CNI_CONTACT_SET_ROUNDS, 0, !bias, 0, 0, 0.0f, FLT_MAX, { 0.0f, 0.0f } };
	int32_t shared = world->cone_work + world->set_work > 0;
	if (!bias && c->nothing_pushed)
		return 1;
	c->cone_pushed &= !bias;
	q.island = cni_island_at(world, cni_awake_island(world, sparse->bodies[c->body_begin]));
	q.frame = cni_island_frame(world, q.island);
	impulses_scale(&q);
	state_save(&q, 0);
	cni_direct_contact_round_begin(&q);
	q.before = energy_of(&q, SUBSTEP_BEGIN);
	q.warm = is_recent(&q, q.island->cone_step);
	if (is_large(&q) && !was_moving(&q))
		q.rounds = CNI_CONTACT_SET_ROUNDS_LARGE;
	cni_direct_contact_gap_speeds_find(&q);
	cni_direct_contact_states_save(&q, 0);
	smooth_sum_find(&q);
	if (set_solve(&q) || (!q.squeezed && cone_solve(&q))) {
		solution_accept(&q);
		return 1;
	}
	c->denied = q.denied || (shared && cni_attempt_work_is_spent(world, c));
	if (q.kept && solve_with_kept_set(&q))
		return 1;
	if (!c->denied && !q.squeezed)
		debt_add(&q, CNI_CONE_FAILED);
	soft_state_restore(&q);
	return 0;
}
