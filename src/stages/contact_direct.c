/*
 * stages/contact_direct.c - directly solved contacts: which rows hold is found by an active set.
 *
 * Every row is open (no impulse), held (its speed is what it must be) or, for friction, sliding (its impulse is the
 * coefficient times the normal impulses). Held rows and the island's joints are one linear system (sparse.h). After
 * solving it, a held point that pulls opens, an open one that closes is held, friction beyond the static
 * coefficient slides, a slide that would go back is held; and again, until nothing changes. The sets of the pass
 * before are nearly always right, and arms do not turn within a step, so that a pile costs about one
 * factorization a step. Where no set is found in ROUNDS, or something that was at rest begins to move by it, an interior-point
 * method is asked (stages/contact_cone.c). The passes after that go on from its impulses instead of from none: where many
 * impulses bear the same, those of least energy may pull. A solution that has gained energy is not used at all: impulses of an
 * inconsistent set can put it in without bound. The lanes are then given back to the soft solver with the impulses and loads
 * that they had, so that a pile is not disturbed by the attempt.
 *
 * Points that overlap are pushed apart by PUSH_RATE of the overlap in a substep: slowly, since all of a pile is pushed
 * at once. The second pass of a substep takes that speed out again.
 *
 * Reads and writes lanes of contact blocks, motion velocities, joint works' impulses.
 */
#include "stages/press.h"
#include "stages/joint_work.h"

#include <string.h>

#define ROUNDS 10              /* of the set, until stages/contact_cone.c is asked, which takes about twice as many factorizations */
#define ROUNDS_LARGE 32        /* ... of systems that are too large for that */
#define ROUNDS_ALL 6           /* ... in which all that does not fit is changed at once */
#define ROUNDS_WARM 4          /* ... from impulses of the last pass */
#define PARTING 10.0f          /* times speed_least: contacts that part or slide faster give way */
#define ENERGY_CLOSE 1e-3f     /* part of energy that is rounding */
#define STILL_SPEED 0.3f       /* length units a second, root of the mean square by mass: what is slower is at rest, or begins to move */
#define SOFT_STRESS 100.0f     /* own weights */
#define REFINEMENTS 3          /* solutions with one factorization */
#define PUSH_RATE 0.1f
#define TOUCHING 5e-6f         /* length units: a lesser gap or overlap is rounding of positions. Rows that say the same twice would
                                  answer to what they say of it differently with impulses beyond measure */
#define SPEED_LEAST 1e-4f      /* length units a second that are no motion */

static float normal_sum(const cni_press *p)
{
	return p->j[0] + p->j[1];
}

static void press_push(const cni_press *p, int32_t row, float impulse, cni_motion *a, cni_motion *b)
{
	cni_lever l = cni_press_lever(p, row);
	if (impulse != 0.0f)
		cni_lever_push(&l, impulse, a, b);
}

/* ---- a pass ---- */

typedef struct pass {
	cn_world *world;
	const cni_solve *s;
	cni_sparse *sparse;
	cni_component *c;
	cni_motion *motions;
	float speed_least;
	int32_t bias;
	int32_t warm;          /* 1: from the impulses of the last pass, not from none */
	int32_t kept;          /* 1: the kept set will do, if nothing better is found */
	float before;          /* twice the kinetic energy before the substep's impulses */
	cni_island *island;
} pass;

/* Friction is there while a point is held. */
static void friction_follow(cni_press *p)
{
	int32_t held = p->state[0] == CNI_ROW_HELD || p->state[1] == CNI_ROW_HELD;
	if (!held)
		p->state[2] = CNI_ROW_OPEN;
	else if (p->state[2] == CNI_ROW_OPEN)
		p->state[2] = CNI_ROW_HELD;
}

static void press_room(const pass *q, cni_press *p, const cni_node *n)
{
	const cni_motion *a = q->motions + n->ia, *b = q->motions + n->ib;
	float touch = TOUCHING * q->world->settings.length_unit;
	int32_t i;
	for (i = 0; i < 2; ++i) {
		float s = p->mass[i] > 0.0f ? cni_press_separation(p, i, a, b) : 0.0f, push;
		s = s > 0.0f ? cni_max(s - touch, 0.0f) : cni_min(s + touch, 0.0f);
		push = PUSH_RATE * q->s->inv_h * s;
		p->room[i] = s > 0.0f ? s * q->s->inv_h : q->bias ? cni_max(push, -q->s->push_speed) : 0.0f;
	}
	friction_follow(p);
}

/* What touches and does not part is held: in a new pile all of it must bear at once. */
static void press_hold(const pass *q, cni_press *p, const cni_node *n)
{
	int32_t i;
	for (i = 0; i < 2; ++i) {
		cni_lever l = cni_press_lever(p, i);
		if (p->mass[i] > 0.0f && p->state[i] == CNI_ROW_OPEN && cni_lever_speed(&l, q->motions + n->ia, q->motions + n->ib) + p->room[i] < q->speed_least)
			p->state[i] = CNI_ROW_HELD;
	}
	friction_follow(p);
}

/* Levers of what is held; 1 when they are not those of the last factorization. */
static int32_t press_levers(const cni_press *p, cni_node *n)
{
	int32_t i, changed = 0;
	for (i = 0; i < 3; ++i) {
		int32_t held = p->state[i] == CNI_ROW_HELD, was = (n->held >> i) & 1;
		if (held == was)
			continue;
		memset(&n->lever[i], 0, sizeof n->lever[i]);
		if (held)
			n->lever[i] = cni_press_lever(p, i);
		n->held ^= 1 << i;
		changed = 1;
	}
	return changed;
}

/* Known impulses of what is not held, as changes of velocity. */
static int32_t presses_set(const pass *q)
{
	int32_t k, i, changed = 0;
	for (k = q->c->begin; k < q->c->end; ++k) {
		cni_node *n = &q->sparse->nodes[k];
		cni_press *p = cni_press_of(q->sparse, n);
		float sum;
		n->total[0] = n->total[1] = n->total[2] = 0.0f;
		if (p == NULL)
			continue;
		sum = normal_sum(p);
		for (i = 0; i < 3; ++i) {
			p->j[i] = p->state[i] == CNI_ROW_HELD ? p->start[i] : p->state[i] == CNI_ROW_SLIDES ? p->way * p->dynamic_friction * cni_max(sum, 0.0f) : 0.0f;
			press_push(p, i, p->j[i] - p->start[i], q->motions + n->ia, q->motions + n->ib);
		}
		changed |= press_levers(p, n);
	}
	return changed;
}

/* Speed that a row is to have beside what it has. */
static float press_lacks(const pass *q, const cni_press *p, int32_t row)
{
	if (p->state[row] != CNI_ROW_HELD || p->mass[row] == 0.0f)
		return 0.0f;
	return (row < 2 ? p->room[row] : 0.0f) + (q->warm ? cni_press_leak(p, row) : 0.0f);
}

/* What the held rows' speeds lack; returns the largest. */
static float right_sides(const pass *q)
{
	float largest = 0.0f;
	const float rate = q->bias ? CNI_JOINT_ERROR_RATE * q->s->inv_h : 0.0f;
	int32_t k, i;
	for (k = q->c->begin; k < q->c->end; ++k) {
		cni_node *n = &q->sparse->nodes[k];
		const cni_press *p = cni_press_of(q->sparse, n);
		const cni_row *rows = p == NULL ? cni_joint_works(q->world)[n->owner].rows : NULL;
		for (i = 0; i < CNI_NODE_ROWS; ++i) {
			float more = p != NULL ? press_lacks(q, p, i) : i < n->rows ? cni_clamp(rate * rows[i].error, -q->s->push_speed, q->s->push_speed) : 0.0f;
			n->x[i] = -cni_lever_speed(&n->lever[i], q->motions + n->ia, q->motions + n->ib) - more;
			largest = cni_max(largest, cni_abs(n->x[i]));
		}
	}
	return largest;
}

static void velocities_push(const pass *q)
{
	int32_t k, i;
	for (k = q->c->begin; k < q->c->end; ++k) {
		cni_node *n = &q->sparse->nodes[k];
		cni_press *p = cni_press_of(q->sparse, n);
		for (i = 0; i < CNI_NODE_ROWS; ++i) {
			n->total[i] += n->x[i];
			cni_lever_push(&n->lever[i], n->x[i], q->motions + n->ia, q->motions + n->ib);
			if (p != NULL && p->state[i] == CNI_ROW_HELD)
				p->j[i] += n->x[i];
		}
	}
}

/* Again with what is left, because the diagonal is not quite the true one. 0: no finite solution. */
static int32_t held_rows_solve(const pass *q)
{
	int32_t k;
	for (k = 0; k < REFINEMENTS && (right_sides(q) > 0.5f * q->speed_least || k == 0); ++k) {
		if (!cni_sparse_solve(q->sparse, q->c))
			return 0;
		velocities_push(q);
	}
	return 1;
}

/* ---- the set ---- */

/* A row whose state does not fit the solution, what it should be, and by how much speed it is wrong. */
typedef struct misfit {
	cni_press *press;
	int32_t row;
	uint8_t next;
	float by;
} misfit;

static misfit point_misfit(const pass *q, cni_press *p, const cni_node *n, int32_t i)
{
	misfit m = { p, i, p->state[i], 0.0f };
	cni_lever l = cni_press_lever(p, i);
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

static misfit friction_misfit(const pass *q, cni_press *p, const cni_node *n)
{
	misfit m = { p, 2, p->state[2], 0.0f };
	cni_lever l = cni_press_lever(p, 2);
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
	cni_press *p = m->press;
	if (m->next == CNI_ROW_SLIDES)
		p->way = p->j[2] > 0.0f ? 1.0f : -1.0f;
	p->state[m->row] = m->next;
	friction_follow(p);
}

/* Sliding friction that its normal force has moved away from. */
static int32_t slide_is_off(const pass *q, const cni_press *p)
{
	float most = p->dynamic_friction * cni_max(normal_sum(p), 0.0f), off = cni_abs(cni_abs(p->j[2]) - most);
	return p->state[2] == CNI_ROW_SLIDES && off > CNI_SLIDE_CLOSE * most + q->speed_least * p->mass[2];
}

/* What is not consistent with the solution: rows that do not fit; -1: slides alone are off. The next set has all of them mended at
   once, or the worst alone, which is slow and sure (Murty, 1974). */
static int32_t set_mend(const pass *q, int32_t all)
{
	misfit worst = { NULL, 0, 0, 0.0f };
	int32_t k, i, misfits = 0, off = 0;
	worst.by = q->speed_least;
	for (k = q->c->begin; k < q->c->end; ++k) {
		const cni_node *n = &q->sparse->nodes[k];
		cni_press *p = cni_press_of(q->sparse, n);
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

static void commit(const pass *q)
{
	int32_t k, i;
	for (k = q->c->begin; k < q->c->end; ++k) {
		cni_node *n = &q->sparse->nodes[k];
		cni_press *p = cni_press_of(q->sparse, n);
		cni_row *rows = p == NULL ? cni_joint_works(q->world)[n->owner].rows : NULL;
		for (i = 0; p == NULL && i < n->rows; ++i)
			rows[i].impulse += n->total[i];
		for (i = 0; p != NULL && i < 2; ++i)
			p->j[i] = cni_max(p->j[i], 0.0f);
		if (p != NULL)
			p->untouched = 0;
	}
}

/*
 * Before a pushing pass: velocities as the drive makes them, without the response to the last substep's impulses, and no
 * impulses but those of rows that are not part of the system. What is known from the last substep is the set.
 * Carrying impulses over would leave what a system that says things twice does not see to grow from substep to
 * substep.
 */
static void forget_impulses(const pass *q)
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
		cni_press *p = cni_press_of(q->sparse, n);
		for (i = 0; p == NULL && i < cni_joint_works(q->world)[n->owner].row_count; ++i) {
			cni_row *r = &cni_joint_works(q->world)[n->owner].rows[i];
			cni_lever l = cni_row_lever(r);
			if (i < n->rows)
				r->impulse = 0.0f;
			else
				cni_lever_push(&l, r->impulse, q->motions + n->ia, q->motions + n->ib);
		}
	}
}

/* Impulses and velocities as a pass found them, kept or put back. */
static void all_keep(const pass *q, int32_t back)
{
	int32_t k, i;
	cni_direct_motions_keep(q->world, q->sparse, q->c, back);
	for (k = q->c->begin; k < q->c->end; ++k) {
		cni_node *n = &q->sparse->nodes[k];
		cni_press *p = cni_press_of(q->sparse, n);
		cni_row *rows = p == NULL ? cni_joint_works(q->world)[n->owner].rows : NULL;
		for (i = 0; i < n->rows; ++i) {
			float *impulse = p != NULL ? &p->j[i] : &rows[i].impulse;
			*(back ? impulse : &n->carried[i]) = back ? n->carried[i] : *impulse;
		}
	}
}

/* What every round of a pass begins with: no impulses, or those of the last pass. */
static void round_begin(const pass *q)
{
	int32_t k, i;
	if (q->bias)
		forget_impulses(q);
	else
		cni_direct_motions_keep(q->world, q->sparse, q->c, 1);
	for (k = q->c->begin; k < q->c->end; ++k) {
		const cni_node *n = &q->sparse->nodes[k];
		cni_press *p = cni_press_of(q->sparse, n);
		for (i = 0; p != NULL && i < 3; ++i) {
			p->start[i] = q->bias && !q->warm ? 0.0f : n->carried[i];
			if (q->bias)
				press_push(p, i, p->start[i], q->motions + n->ia, q->motions + n->ib);
		}
	}
}

/* Of the impulses of a contact: what gives the lighter body as much speed as SOFT_STRESS of its weights. More is crushed by the soft
   solver whatever it begins with, and throws what is light when the contacts on both sides of it do not cancel any more. */
static float part_that_soft_bears(const pass *q, const cni_press *p, const cni_node *n)
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
static void all_put_back(const pass *q)
{
	int32_t k, i, all = q->c->joints == 0;
	if (all)
		forget_impulses(q);
	else
		all_keep(q, 1);
	for (k = q->c->begin; k < q->c->end; ++k) {
		const cni_node *n = &q->sparse->nodes[k];
		cni_press *p = cni_press_of(q->sparse, n);
		float part;
		if (p == NULL || !(all || p->untouched))
			continue;
		p->untouched = 1;
		part = q->s->warm_scale * part_that_soft_bears(q, p, n);
		for (i = 0; i < 3; ++i) {
			p->j[i] = part * p->first[i];
			if (i < 2)
				p->load[i] *= part;
			press_push(p, i, p->j[i], q->motions + n->ia, q->motions + n->ib);
		}
	}
}

/* Was nothing pushed? The speeds are then closed already, and arms that turn are those of joints alone. */
static int32_t is_calm(const pass *q)
{
	int32_t k;
	for (k = q->c->begin; k < q->c->end; ++k) {
		const cni_press *p = cni_press_of(q->sparse, &q->sparse->nodes[k]);
		if (p == NULL || p->room[0] < -q->speed_least || p->room[1] < -q->speed_least)
			return 0;
	}
	return 1;
}

static int32_t system_solve(const pass *q)
{
	if (presses_set(q) || !q->c->factored) {
		cni_sparse_factor(q->sparse, q->c, q->motions);
		q->c->factored = 1;
	}
	return held_rows_solve(q);
}

static void states_keep(const pass *q, int32_t back)
{
	int32_t k, i;
	for (k = q->c->begin; k < q->c->end; ++k) {
		cni_press *p = cni_press_of(q->sparse, &q->sparse->nodes[k]);
		for (i = 0; p != NULL && i < 3; ++i)
			*(back ? &p->state[i] : &p->state_kept[i]) = back ? p->state_kept[i] : p->state[i];
	}
}

/* ---- energy ---- */

static float energy_at(const cni_motion *m, float vx, float vy, float w)
{
	return (m->inv_mass > 0.0f ? (vx * vx + vy * vy) / m->inv_mass : 0.0f) + (m->inv_inertia > 0.0f ? w * w / m->inv_inertia : 0.0f);
}

/* Twice the kinetic energy of its bodies. */
static float energy_of(const pass *q)
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
static float energy_of_start(const pass *q)
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
static float energy_of_rest(const pass *q)
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
static int32_t moved(const pass *q)
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
static float push_work(const pass *q)
{
	float sum = 0.0f;
	int32_t k, i;
	for (k = q->c->begin; k < q->c->end; ++k) {
		const cni_press *p = cni_press_of(q->sparse, &q->sparse->nodes[k]);
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
static int32_t energy_fits(const pass *q)
{
	return q->c->joints > 0 || energy_of(q) <= (1.0f + ENERGY_CLOSE) * q->before + push_work(q);
}

/* Sliding friction is of the impulses that a pass has, not of those of a set that was no solution. */
static void impulses_put_back(const pass *q)
{
	int32_t k;
	for (k = q->c->begin; k < q->c->end; ++k) {
		const cni_node *n = &q->sparse->nodes[k];
		cni_press *p = cni_press_of(q->sparse, n);
		if (p != NULL)
			memcpy(p->j, n->carried, sizeof p->j);
	}
}

/* The set that was kept, consistent or not: a projection, which takes energy out and puts none in, unless friction that slides is
   far from what its contact bears. */
static int32_t solve_with_kept_set(const pass *q)
{
	states_keep(q, 1);
	impulses_put_back(q);
	round_begin(q);
	if (!system_solve(q) || !energy_fits(q))
		return 0;
	commit(q);
	return 1;
}

/* ---- does it begin to move? ---- */

/* Does it open where it touches, or slide? */
static int32_t press_gives_way(const pass *q, const cni_press *p, const cni_node *n)
{
	const cni_motion *a = q->motions + n->ia, *b = q->motions + n->ib;
	float most = PARTING * q->speed_least;
	cni_lever l = cni_press_lever(p, 2);
	int32_t i;
	if (p->state[2] == CNI_ROW_SLIDES && cni_abs(cni_lever_speed(&l, a, b)) > most)
		return 1;
	for (i = 0; i < 2; ++i) {
		l = cni_press_lever(p, i);
		if (p->state[i] == CNI_ROW_OPEN && p->mass[i] > 0.0f && p->room[i] < most && cni_lever_speed(&l, a, b) > most)
			return 1;
	}
	return 0;
}

static int32_t gives_way(const pass *q)
{
	int32_t k;
	for (k = q->c->begin; k < q->c->end; ++k) {
		const cni_node *n = &q->sparse->nodes[k];
		const cni_press *p = cni_press_of(q->sparse, n);
		if (p != NULL && press_gives_way(q, p, n))
			return 1;
	}
	return 0;
}

static int32_t is_recent(const pass *q, uint32_t step)
{
	return step != 0 && q->world->step_count + 1u - step < 2u;
}

/* ---- how it is solved ---- */

static void rooms_find(const pass *q)
{
	int32_t k;
	for (k = q->c->begin; k < q->c->end; ++k) {
		cni_press *p = cni_press_of(q->sparse, &q->sparse->nodes[k]);
		if (p != NULL)
			press_room(q, p, &q->sparse->nodes[k]);
	}
}

static void touching_hold(const pass *q)
{
	int32_t k;
	for (k = q->c->begin; k < q->c->end; ++k) {
		cni_press *p = cni_press_of(q->sparse, &q->sparse->nodes[k]);
		if (p != NULL)
			press_hold(q, p, &q->sparse->nodes[k]);
	}
}

/* Is this set the solution? Returns what does not fit in it, which is mended; INT32_MAX: it has none. */
static int32_t set_try(const pass *q, int32_t all)
{
	round_begin(q);
	return system_solve(q) ? set_mend(q, all) : INT32_MAX;
}

static int32_t set_follow(const pass *q)
{
	int32_t round, misfits = -1;
	for (round = 0; misfits != 0 && misfits < INT32_MAX && round < ROUNDS_WARM; ++round)
		misfits = set_try(q, 1);
	return misfits == 0;
}

/* What the cones may cost in a pass. */
static int32_t cone_cost(const pass *q)
{
	return CNI_CONE_FACTORS * cni_cone_factor_work(q->c);
}

static int32_t is_large(const pass *q)
{
	return q->world->settings.solver == CN_SOLVER_AUTO && cone_cost(q) > CNI_CONE_WORK;
}

/* Is it time to give up? Misfits of the rounds to come are mended one each. */
static int32_t rounds_are_over(const pass *q, int32_t round, int32_t misfits)
{
	int32_t most = is_large(q) && !moved(q) ? ROUNDS_LARGE : ROUNDS;
	return misfits == INT32_MAX || round >= most || (round >= ROUNDS_ALL && misfits > most - round);
}

/* The set of the pass before; if it does not fit, from that and all that touches. Where slides alone are off it stays. */
static int32_t set_find(const pass *q)
{
	int32_t round, misfits = set_try(q, 1), fits = 1;
	for (round = 0; misfits != 0 && !rounds_are_over(q, round, misfits); ++round) {
		if (fits && misfits > 0) {
			states_keep(q, 1);
			round_begin(q);
			touching_hold(q);
			fits = 0;
		}
		misfits = set_try(q, round < ROUNDS_ALL);
	}
	return misfits == 0;
}

/*
 * Friction may both hold a thing and let it go, as it may a heap of balls: whoever follows the set of the pass before may find
 * either. What was at rest and begins to move is asked once more, for the motion of least energy.
 */
static int32_t set_solve(pass *q)
{
	if (!(q->warm ? set_follow(q) : set_find(q)) || !energy_fits(q))
		return 0;
	if (q->bias && !is_recent(q, q->island->gives_step) && gives_way(q) && !moved(q)) {
		states_keep(q, 0);
		q->kept = 1;
		return 0;
	}
	return 1;
}

/* What the island has spent, a contact, less what has been paid back. */
static int32_t cone_debt(const pass *q)
{
	uint32_t passed = q->world->step_count - q->island->cone_paid_step;
	int32_t spent = q->island->cone_spent;
	return passed <= (uint32_t)(spent / CNI_CONE_REFILL) ? spent - (int32_t)passed * CNI_CONE_REFILL : 0;
}

/* May it be asked? Who is asked once in a step may be in all of its substeps, as long as the island can pay. */
static int32_t cone_may_be_asked(const pass *q)
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

static void cone_pay(const pass *q, int32_t factors)
{
	q->island->cone_spent = cone_debt(q) + factors * cni_cone_factor_work(q->c) / (q->c->end - q->c->begin);
	q->island->cone_paid_step = q->world->step_count;
}

/* The passes to come go on from its impulses: to begin with none would find others that bear the same, and pull. */
static int32_t cone_solve(pass *q)
{
	int32_t factors, good;
	if (!CNI_ON(CONES) || !cone_may_be_asked(q))
		return 0;
	q->warm = 0;
	round_begin(q);
	good = cni_presses_cone(q->world, q->s, q->sparse, q->c, q->speed_least, q->bias, &factors);
	cone_pay(q, factors);
	if (!good || !energy_fits(q))
		return 0;
	q->warm = 1;
	return 1;
}

static void found(const pass *q)
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

int32_t cni_presses_solve(cn_world *world, const cni_solve *s, cni_sparse *sparse, cni_component *c, int32_t bias)
{
	pass q = { world, s, sparse, c, cni_motions(world), SPEED_LEAST * world->settings.length_unit, bias, 0, !bias, 0.0f, NULL };
	if (!bias && c->calm)
		return 1;
	q.island = cni_island_at(world, cni_awake_island(world, sparse->bodies[c->body_begin]));
	all_keep(&q, 0);
	round_begin(&q);
	q.before = energy_of_start(&q);
	q.warm = is_recent(&q, q.island->cone_step);
	rooms_find(&q);
	states_keep(&q, 0);
	if (set_solve(&q) || cone_solve(&q)) {
		found(&q);
		return 1;
	}
	if (q.kept && solve_with_kept_set(&q))
		return 1;
	all_put_back(&q);
	return 0;
}
