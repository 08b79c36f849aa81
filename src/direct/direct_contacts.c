/*
 * direct/direct_contacts.c - directly solved contacts: a pass over an island, how it is solved and what is done with a solution.
 *
 * Which rows hold is found by an active set (direct/contact_active_set.c). Where no set is found in ROUNDS, or something that was at
 * rest begins to move by it, an interior-point method is asked (direct/friction_cones.c). The passes after that go on from its
 * impulses instead of from none: where many impulses bear the same, those of least energy may pull. A solution that has gained
 * energy is not used at all: impulses of an inconsistent set can put it in without bound. The lanes are then given back to the
 * soft solver with the impulses and loads that they had, so that a pile is not disturbed by the attempt.
 *
 * Reads and writes lanes of contact blocks, motion velocities, joint works' impulses.
 */
#include "direct/direct_contact.h"
#include "direct/direct_system.h"

#include <string.h>

#define ROUNDS 10              /* of the set, until direct/friction_cones.c is asked, which takes about twice as many factorizations */
#define ROUNDS_LARGE 32        /* ... of systems that are too large for that */
#define PARTING 10.0f          /* times speed_least: contacts that part or slide faster give way */
#define ENERGY_CLOSE 1e-3f     /* part of energy that is rounding */
#define STILL_SPEED 0.4f       /* length units a second, root of the mean square by mass: what is slower is at rest, or begins to move */
#define SOFT_STRESS 100.0f     /* own weights */
#define SPEED_LEAST 1e-4f      /* length units a second that are no motion */

/* ---- impulses and velocities: taken, kept, put back ---- */

static void commit(const cni_direct_contact_pass *q)
{
	int32_t k, i;
	for (k = q->c->begin; k < q->c->end; ++k) {
		cni_node *n = &q->sparse->nodes[k];
		cni_direct_contact *p = cni_direct_contact_of(q->sparse, n);
		cni_row *rows = p == NULL ? cni_joint_constraints(q->world)[n->owner].rows : NULL;
		for (i = 0; p == NULL && i < n->rows; ++i)
			rows[i].impulse += n->total[i];
		for (i = 0; p != NULL && i < 2; ++i)
			p->j[i] = cni_max(p->j[i], 0.0f);
		if (p != NULL)
			p->untouched = 0;
	}
}

/* Impulses and velocities as a pass found them, kept or put back. */
static void all_keep(const cni_direct_contact_pass *q, int32_t back)
{
	int32_t k, i;
	cni_direct_motions_keep(q->world, q->sparse, q->c, back);
	for (k = q->c->begin; k < q->c->end; ++k) {
		cni_node *n = &q->sparse->nodes[k];
		cni_direct_contact *p = cni_direct_contact_of(q->sparse, n);
		cni_row *rows = p == NULL ? cni_joint_constraints(q->world)[n->owner].rows : NULL;
		for (i = 0; i < n->rows; ++i) {
			float *impulse = p != NULL ? &p->j[i] : &rows[i].impulse;
			*(back ? impulse : &n->carried[i]) = back ? n->carried[i] : *impulse;
		}
	}
}

/* Of the impulses of a contact: what gives the lighter body as much speed as SOFT_STRESS of its weights. More is crushed by the soft
   solver whatever it begins with, and throws what is light when the contacts on both sides of it do not cancel any more. */
static float part_that_soft_bears(const cni_direct_contact_pass *q, const cni_direct_contact *p, const cni_node *n)
{
	float speed = (p->first[0] + p->first[1]) * cni_max(q->motions[n->ia].inv_mass, q->motions[n->ib].inv_mass);
	float most = SOFT_STRESS * cni_length(q->world->settings.gravity) * q->s->h;
	return speed > most ? most / speed : 1.0f;
}

/*
 * No set was found: the soft solver goes on as if nothing had been, from the velocities that the substep began with and the impulses
 * that the step began with. An exact solution sends a blow, or what pushes apart, through whatever is in its way: a body of a kilogram
 * between two of a ton has the impulses of both, which cancel to a thousandth. A soft solver that began with them would throw it.
 */
static void all_put_back(const cni_direct_contact_pass *q)
{
	int32_t k, i, all = q->c->joints == 0;
	if (all)
		cni_direct_contact_impulses_forget(q);
	else
		all_keep(q, 1);
	for (k = q->c->begin; k < q->c->end; ++k) {
		const cni_node *n = &q->sparse->nodes[k];
		cni_direct_contact *p = cni_direct_contact_of(q->sparse, n);
		float part;
		if (p == NULL || !(all || p->untouched))
			continue;
		p->untouched = 1;
		part = q->s->warm_scale * part_that_soft_bears(q, p, n);
		for (i = 0; i < 3; ++i) {
			p->j[i] = part * p->first[i];
			if (i < 2)
				p->load[i] *= part;
			cni_direct_contact_push(p, i, p->j[i], q->motions + n->ia, q->motions + n->ib);
		}
	}
}

/* Was nothing pushed? The speeds are then closed already, and arms that turn are those of joints alone. */
static int32_t is_calm(const cni_direct_contact_pass *q)
{
	int32_t k;
	for (k = q->c->begin; k < q->c->end; ++k) {
		const cni_direct_contact *p = cni_direct_contact_of(q->sparse, &q->sparse->nodes[k]);
		if (p == NULL || p->room[0] < -q->speed_least || p->room[1] < -q->speed_least)
			return 0;
	}
	return 1;
}

/* ---- energy ---- */

static float energy_at(const cni_motion *m, float vx, float vy, float w)
{
	return (m->inv_mass > 0.0f ? (vx * vx + vy * vy) / m->inv_mass : 0.0f) + (m->inv_inertia > 0.0f ? w * w / m->inv_inertia : 0.0f);
}

/* Twice the kinetic energy of its bodies. */
static float energy_of(const cni_direct_contact_pass *q)
{
	float sum = 0.0f;
	int32_t k;
	for (k = q->c->body_begin; k < q->c->body_end; ++k) {
		const cni_motion *m = q->motions + q->sparse->bodies[k];
		sum += energy_at(m, m->vx, m->vy, m->w);
	}
	return sum;
}

/* ... as the substep began, after the drive and before any impulse. */
static float energy_of_start(const cni_direct_contact_pass *q)
{
	float sum = 0.0f;
	int32_t k;
	for (k = q->c->body_begin; k < q->c->body_end; ++k) {
		const cni_velocity_start *v = cni_starts(q->world) + q->sparse->bodies[k];
		sum += energy_at(q->motions + q->sparse->bodies[k], v->vx, v->vy, v->w);
	}
	return sum;
}

/* Twice the energy beyond which it does not rest: that of all of it at STILL_SPEED. A part may move on what stands. */
static float energy_of_rest(const cni_direct_contact_pass *q)
{
	float mass = 0.0f, speed = STILL_SPEED * q->world->settings.length_unit;
	int32_t k;
	for (k = q->c->body_begin; k < q->c->body_end; ++k) {
		const cni_motion *m = q->motions + q->sparse->bodies[k];
		mass += m->inv_mass > 0.0f ? 1.0f / m->inv_mass : 0.0f;
	}
	return mass * speed * speed;
}

/* Did it move as the step began? */
static int32_t moved(const cni_direct_contact_pass *q)
{
	float sum = 0.0f;
	int32_t k;
	for (k = q->c->body_begin; k < q->c->body_end; ++k) {
		const cni_body *b = cni_body_at(q->world, cni_awake_ids(q->world)[q->sparse->bodies[k]]);
		sum += energy_at(q->motions + q->sparse->bodies[k], b->vx, b->vy, b->w);
	}
	return sum > energy_of_rest(q);
}

/* Twice the work of pushing apart what overlaps. */
static float push_work(const cni_direct_contact_pass *q)
{
	float sum = 0.0f;
	int32_t k, i;
	for (k = q->c->begin; k < q->c->end; ++k) {
		const cni_direct_contact *p = cni_direct_contact_of(q->sparse, &q->sparse->nodes[k]);
		for (i = 0; p != NULL && i < 2; ++i)
			sum += 2.0f * p->j[i] * cni_max(-p->room[i], 0.0f);
	}
	return sum;
}

/*
 * With speeds w after and v before the impulses l, and room that speeds must be beyond -room, the energy grows by
 * l.(w + v) / 2 <= l.w <= -l.room: no more than by pushing apart. The relaxing pass takes the pushing out: with all impulses of
 * the substep, what is left is no more than it began with. Joints and what is carried along may do more.
 */
static int32_t energy_fits(const cni_direct_contact_pass *q)
{
	return q->c->joints > 0 || energy_of(q) <= (1.0f + ENERGY_CLOSE) * q->before + push_work(q);
}

/* Sliding friction is of the impulses that a pass has, not of those of a set that was no solution. */
static void impulses_put_back(const cni_direct_contact_pass *q)
{
	int32_t k;
	for (k = q->c->begin; k < q->c->end; ++k) {
		const cni_node *n = &q->sparse->nodes[k];
		cni_direct_contact *p = cni_direct_contact_of(q->sparse, n);
		if (p != NULL)
			memcpy(p->j, n->carried, sizeof p->j);
	}
}

/* The set that was kept, consistent or not: a projection, which takes energy out and puts none in, unless friction that slides is
   far from what its contact bears. */
static int32_t solve_with_kept_set(const cni_direct_contact_pass *q)
{
	cni_direct_contact_states_keep(q, 1);
	impulses_put_back(q);
	cni_direct_contact_round_begin(q);
	if (!cni_direct_contact_system_solve(q) || !energy_fits(q))
		return 0;
	commit(q);
	return 1;
}

/* ---- does it begin to move? ---- */

/* Does it open where it touches, or slide? */
static int32_t press_gives_way(const cni_direct_contact_pass *q, const cni_direct_contact *p, const cni_node *n)
{
	const cni_motion *a = q->motions + n->ia, *b = q->motions + n->ib;
	float most = PARTING * q->speed_least;
	cni_lever l = cni_direct_contact_lever(p, 2);
	int32_t i;
	if (p->state[2] == CNI_ROW_SLIDES && cni_abs(cni_lever_speed(&l, a, b)) > most)
		return 1;
	for (i = 0; i < 2; ++i) {
		l = cni_direct_contact_lever(p, i);
		if (p->state[i] == CNI_ROW_OPEN && p->mass[i] > 0.0f && p->room[i] < most && cni_lever_speed(&l, a, b) > most)
			return 1;
	}
	return 0;
}

static int32_t gives_way(const cni_direct_contact_pass *q)
{
	int32_t k;
	for (k = q->c->begin; k < q->c->end; ++k) {
		const cni_node *n = &q->sparse->nodes[k];
		const cni_direct_contact *p = cni_direct_contact_of(q->sparse, n);
		if (p != NULL && press_gives_way(q, p, n))
			return 1;
	}
	return 0;
}

static int32_t is_recent(const cni_direct_contact_pass *q, uint32_t step)
{
	return step != 0 && q->world->step_count + 1u - step < 2u;
}

/* ---- how it is solved ---- */

/* What the cones may cost in a pass. */
static int32_t cone_cost(const cni_direct_contact_pass *q)
{
	return CNI_CONE_FACTORS * cni_cone_factor_work(q->c);
}

static int32_t is_large(const cni_direct_contact_pass *q)
{
	return q->world->settings.solver == CN_SOLVER_AUTO && cone_cost(q) > CNI_CONE_WORK;
}

/*
 * Friction may both hold a thing and let it go, as it may a heap of balls: whoever follows the set of the pass before may find
 * either. What was at rest and begins to move is asked once more, for the motion of least energy.
 */
static int32_t set_solve(cni_direct_contact_pass *q)
{
	if (!(q->warm ? cni_direct_contact_set_follow(q) : cni_direct_contact_set_find(q)) || !energy_fits(q))
		return 0;
	if (q->bias && !is_recent(q, q->island->gives_step) && gives_way(q) && !moved(q)) {
		cni_direct_contact_states_keep(q, 0);
		q->kept = 1;
		return 0;
	}
	return 1;
}

/* What the island has spent, a contact, less what has been paid back. */
static int32_t cone_debt(const cni_direct_contact_pass *q)
{
	uint32_t passed = q->world->step_count - q->island->cone_paid_step;
	int32_t spent = q->island->cone_spent;
	return passed <= (uint32_t)(spent / CNI_CONE_REFILL) ? spent - (int32_t)passed * CNI_CONE_REFILL : 0;
}

/* May it be asked? Who is asked once in a step may be in all of its substeps, as long as the island can pay. */
static int32_t cone_may_be_asked(const cni_direct_contact_pass *q)
{
	if (q->world->settings.solver == CN_SOLVER_AUTO) {
		if (moved(q) || cone_debt(q) > CNI_CONE_DEBT)
			return 0;
		if (!q->c->coned && q->world->cone_work + cone_cost(q) > CNI_CONE_WORK)
			return 0;
		q->world->cone_work += q->c->coned ? 0 : cone_cost(q);
	}
	q->c->coned = 1;
	return 1;
}

static void cone_pay(const cni_direct_contact_pass *q, int32_t factors)
{
	q->island->cone_spent = cone_debt(q) + factors * cni_cone_factor_work(q->c) / (q->c->end - q->c->begin);
	q->island->cone_paid_step = q->world->step_count;
}

/* The passes to come go on from its impulses: to begin with none would find others that bear the same, and pull. */
static int32_t cone_solve(cni_direct_contact_pass *q)
{
	int32_t factors, good;
	if (!CNI_ON(CONES) || !cone_may_be_asked(q))
		return 0;
	q->warm = 0;
	cni_direct_contact_round_begin(q);
	good = cni_direct_contacts_cone(q, &factors);
	cone_pay(q, factors);
	if (!good || !energy_fits(q))
		return 0;
	q->warm = 1;
	return 1;
}

static void found(const cni_direct_contact_pass *q)
{
	uint32_t step = q->world->step_count + 1u;
	if (q->warm)
		q->island->cone_step = step;
	if (q->bias && q->island->gives_step != step && gives_way(q)) {
		q->island->falls_steps = energy_of(q) > energy_of_rest(q) && is_recent(q, q->island->gives_step) ? q->island->falls_steps + 1 : 0;
		q->island->gives_step = step;
	}
	commit(q);
	q->c->calm = q->bias && is_calm(q);
}

int32_t cni_direct_contacts_solve(cn_world *world, const cni_solve *s, cni_sparse *sparse, cni_component *c, int32_t bias)
{
	cni_direct_contact_pass q = { world, s, sparse, c, cni_motions(world), NULL, SPEED_LEAST * world->settings.length_unit, bias, 0, ROUNDS, !bias, 0.0f };
	if (!bias && c->calm)
		return 1;
	q.island = cni_island_at(world, cni_awake_island(world, sparse->bodies[c->body_begin]));
	all_keep(&q, 0);
	cni_direct_contact_round_begin(&q);
	q.before = energy_of_start(&q);
	q.warm = is_recent(&q, q.island->cone_step);
	if (is_large(&q) && !moved(&q))
		q.rounds = ROUNDS_LARGE;
	cni_direct_contact_rooms_find(&q);
	cni_direct_contact_states_keep(&q, 0);
	if (set_solve(&q) || cone_solve(&q)) {
		found(&q);
		return 1;
	}
	if (q.kept && solve_with_kept_set(&q))
		return 1;
	all_put_back(&q);
	return 0;
}
