/*
 * stages/joint_swing.c - bodies that nothing but rigid joints holds: their whole step at once, second order
 * and without losing energy.
 *
 * RATTLE (Andersen, 1983; Leimkuhler and Skeel, 1994) with the direct solver, per substep:
 *
 *   v += h/2 a                    half a kick
 *   x += h (v + M^-1 J' mu)       mu such that the joints are closed at the new x (Newton: K mu = -C/h)
 *   v += M^-1 J' mu + h/2 a       the other half
 *   v += M^-1 J' nu               J at the new x; nu such that J v = 0
 *
 * Both start from half of the last substep's impulse, so that Newton rarely needs a second round, but not where
 * dampers are at work, which must see all of the tension;
 * with one factorization a substep: of K at the old x for mu, which is that of the last substep's nu.
 * Gaps that are there already are closed by a part in each substep; nu takes out the speed that this needs.
 *
 * Joints alone bring in no energy. What a step gained beyond the work of its drives is kept in an account, which its joints
 * carry (cni_joint_trust): the method swings about the true energy by the square of the substep, so the account may be
 * that large and no larger; the rest is taken out of the velocities. So energy cannot creep, step by step.
 *
 * Three methods, each for what the one before it cannot do. The joints remember failures, so that a component that fails
 * again and again does not try everything in every step:
 *   RATTLE       a step that does not close its joints, or gains much energy, is taken again with twice the substeps;
 *   projection   x += h (v + h a), x to the nearest point where the joints are closed, v projected to J v = 0 there: such a
 *                projection cannot raise kinetic energy, so it stands whips that no substep resolves, and loses energy
 *                (about (h w)^2 of it a substep);
 *   soft         each joint by itself, as CN_SOLVER_SOFT does, where a system is beyond what floats can hold.
 *
 * Substeps follow the tension's springs as far as they go, dampers do the rest: stages/joint_tension.c.
 *
 * Reads works, drives, motion; writes motion, start, works' rows and flags, drive flags.
 */
#include "stages/joint_work.h"

#define CLOSED 2e-6f           /* length units or radians: a joint that is closed */
#define NEWTON_ROUNDS 5
#define PROJECT_ROUNDS 12
#define SLOWEST 0.9f           /* part of its gap that a round may leave to a loop: some cannot be closed */
#define FAILED 50.0f            /* gaps above this many times CLOSED after all rounds: the substep is too long */
#define GAP_OLD 100.0f          /* times CLOSED: a gap that this step has not made */
#define CLOSING_RATE 0.2f      /* part of an old gap that is closed in a substep */
#define ENERGY_GAIN 0.01f      /* part of the kinetic energy that a step may take out: more is a step that failed */
#define ROUNDING 1e-3f         /* part of the kinetic energy that some minutes of rounding may gain */
#define SUBSTEPS_MOST 8.0f     /* to follow pins, which dampers help beyond that */
#define SUBSTEPS_ROD_MOST 32.0f /* ... and rods, which nothing helps */
#define SUBSTEPS_RETRY 64      /* most that a step is retried with */
#define SUBSTEPS_FIRM 16       /* of the projection */

/* ---- which components ---- */

/* Can no row but the rigid ones have anything to do in this step? */
static int32_t work_is_rigid(const cni_joint_work *w, const cni_motion *motions, float dt)
{
	const cni_motion *a = motions + w->ia, *b = motions + w->ib;
	int32_t k;
	for (k = w->rigid_count; k < w->row_count; ++k) {
		const cni_row *r = &w->rows[k];
		cni_lever l = cni_row_lever(r);
		float speed = cni_lever_speed(&l, a, b);
		if (r->kind != CNI_ROW_LIMIT || r->error < 0.05f + 2.0f * dt * cni_abs(speed))
			return 0;
	}
	return 1;
}

static int32_t end_swings(const cn_world *world, int32_t index)
{
	const cni_motion *m = cni_motions(world) + index;
	return index == 0 || m->inv_mass > 0.0f || m->inv_inertia > 0.0f;
}

/* Only joints of the component hold it, and nothing touches it. */
static int32_t body_swings(const cn_world *world, int32_t index)
{
	const cni_body *b = cni_body_at(world, cni_awake_ids(world)[index]);
	int32_t key;
	if (cni_drives(world)[index].flags & (CNI_DRIVE_TOUCHED | CNI_DRIVE_LOCK_X | CNI_DRIVE_LOCK_Y))
		return 0;
	for (key = b->joint_first; key != CNI_NONE; key = cni_joint_at(world, key >> 1)->next[key & 1]) {
		int32_t at = cni_joint_at(world, key >> 1)->awake;
		if (at != CNI_NONE && !(cni_joint_works(world)[at].flags & CNI_WORK_DIRECT))
			return 0;
	}
	return 1;
}

/* A pin with a spring or a motor, of which it need not be known what it would do. */
static int32_t work_is_driven(const cni_joint_work *w)
{
	return (w->flags & CNI_WORK_WIDE) && (w->record->flags & (CN_JOINT_SPRING | CN_JOINT_MOTOR));
}

int32_t cni_component_swings(const cn_world *world, const cni_solve *s, const cni_sparse *sparse, const cni_component *c)
{
	int32_t k;
	for (k = c->begin; k < c->end; ++k)
		if (work_is_driven(&cni_joint_works(world)[sparse->nodes[k].owner]))
			return 0;
	for (k = c->body_begin; k < c->body_end; ++k)
		if (!body_swings(world, sparse->bodies[k]))
			return 0;
	cni_joint_works_complete(world, sparse, c);
	for (k = c->begin; k < c->end; ++k) {
		const cni_node *n = &sparse->nodes[k];
		if (!end_swings(world, n->ia) || !end_swings(world, n->ib) ||
		    !work_is_rigid(&cni_joint_works(world)[n->owner], cni_motions(world), s->dt))
			return 0;
	}
	return 1;
}

/* ---- one substep ---- */

/* How a substep went: closed, still open after all rounds, or beyond what floats hold. */
enum { CLOSED_WELL = 0, OPEN = 1, BROKEN = 2 };

typedef struct swing {
	cn_world *world;
	cni_sparse *sparse;
	const cni_component *c;
	cni_motion *motions;
	float h;
	float closed;      /* errors below it do not matter */
	float closing;     /* most that is closed of an old gap in a substep */
	float *left;       /* by row: what of an old gap is to be left after the substep */
	float warm;        /* 0.5, or 0: what of the last substep's impulse mu starts from */
	float speeding;    /* h^2 m a^2 / 4 of the last substep: how far the method's energy may be off */
	float base_work;   /* that moving bodies without mass have done at their joints in this step */
	int32_t mends;     /* 1: the step began with gaps that it closes */
} swing;

static cni_joint_work *work_of(const swing *g, int32_t node)
{
	return &cni_joint_works(g->world)[g->sparse->nodes[node].owner];
}

/* Half of what the drive gives in a substep. */
static void kick(const swing *g)
{
	int32_t k;
	for (k = g->c->body_begin; k < g->c->body_end; ++k) {
		int32_t index = g->sparse->bodies[k];
		const cni_drive *d = cni_drives(g->world) + index;
		cni_motion *m = g->motions + index;
		float half = 0.5f * g->h;
		m->vx += half * d->ax;
		m->vy += half * d->ay;
		m->w += half * d->alpha;
		if (d->flags & CNI_DRIVE_DAMPED) {
			const cni_body *b = cni_body_at(g->world, cni_awake_ids(g->world)[index]);
			float linear = cni_damping_factor(b->linear_damping, half);
			m->vx *= linear;
			m->vy *= linear;
			m->w *= cni_damping_factor(b->angular_damping, half);
		}
	}
}

static void drift(const swing *g)
{
	int32_t k;
	for (k = g->c->body_begin; k < g->c->body_end; ++k) {
		cni_motion *m = g->motions + g->sparse->bodies[k];
		m->dpx += g->h * m->vx;
		m->dpy += g->h * m->vy;
		m->theta += g->h * m->w;
	}
}

/* What of an old gap is to be left after the substep. */
static float gap_left(const swing *g, float error)
{
	if (cni_abs(error) <= GAP_OLD * g->closed)
		return 0.0f;
	return error - cni_clamp(CLOSING_RATE * error, -g->closing, g->closing);
}

static void move(cni_motion *m, float h, float part, float vx, float vy, float w)
{
	m->vx += part * vx;
	m->vy += part * vy;
	m->w += part * w;
	m->dpx += h * vx;
	m->dpy += h * vy;
	m->theta += h * w;
}

/* x of every node to positions, and a part of it (1 or 0) to velocities. */
static void push_and_move(const swing *g, float part)
{
	int32_t k, i;
	for (k = g->c->begin; k < g->c->end; ++k) {
		const cni_node *n = &g->sparse->nodes[k];
		cni_motion *a = g->motions + n->ia, *b = g->motions + n->ib;
		for (i = 0; i < CNI_NODE_ROWS; ++i) {
			const cni_lever *l = &n->lever[i];
			float x = n->x[i], pa = a->inv_mass * x, pb = b->inv_mass * x;
			move(a, g->h, part, pa * l->ax, pa * l->ay, a->inv_inertia * x * l->aw);
			move(b, g->h, part, pb * l->bx, pb * l->by, b->inv_inertia * x * l->bw);
		}
	}
}

static void impulses_add(const swing *g)
{
	int32_t k, i;
	for (k = g->c->begin; k < g->c->end; ++k) {
		const cni_node *n = &g->sparse->nodes[k];
		for (i = 0; i < n->rows; ++i)
			work_of(g, k)->rows[i].impulse += n->x[i];
	}
}

/* Rows at the present positions into the works, impulses kept; x: what closes them. Returns the largest gap. */
static float gaps_find(const swing *g)
{
	float largest = 0.0f, inv_h = 1.0f / g->h;
	int32_t k, i;
	cni_direct_turns(g->world, g->sparse, g->c);
	for (k = g->c->begin; k < g->c->end; ++k) {
		cni_node *n = &g->sparse->nodes[k];
		cni_joint_work *w = work_of(g, k);
		float impulse[CNI_NODE_ROWS] = { 0.0f, 0.0f, 0.0f };
		for (i = 0; i < n->rows; ++i)
			impulse[i] = w->rows[i].impulse;
		cni_joint_work_rows(w, g->motions, g->sparse->turn);
		for (i = 0; i < n->rows; ++i) {
			float gap = w->rows[i].error - g->left[(k - g->c->begin) * CNI_NODE_ROWS + i];
			w->rows[i].impulse = impulse[i];
			n->x[i] = -gap * inv_h;
			largest = cni_max(largest, cni_abs(gap));
		}
		for (; i < CNI_NODE_ROWS; ++i)
			n->x[i] = 0.0f;
	}
	return largest;
}

static void gaps_left_find(const swing *g)
{
	int32_t k, i;
	for (k = g->c->begin; k < g->c->end; ++k)
		for (i = 0; i < g->sparse->nodes[k].rows; ++i)
			g->left[(k - g->c->begin) * CNI_NODE_ROWS + i] = gap_left(g, work_of(g, k)->rows[i].error);
}

/* A part of the rows' impulses once more, along the levers as they are; `kept` of them stays in the rows. */
static void impulses_push(const swing *g, float part, float kept)
{
	int32_t k, i;
	for (k = g->c->begin; k < g->c->end; ++k) {
		const cni_node *n = &g->sparse->nodes[k];
		for (i = 0; i < n->rows; ++i) {
			cni_row *r = &work_of(g, k)->rows[i];
			cni_lever_push(&n->lever[i], part * r->impulse, g->motions + n->ia, g->motions + n->ib);
			r->impulse *= kept;
		}
	}
}

/* One round at least: what mu starts from may look good enough, and be wrong to the same side again and again. */
static int32_t positions_close(const swing *g)
{
	float gap = gaps_find(g);
	int32_t round;
	for (round = 0; round < NEWTON_ROUNDS && (round == 0 || gap > g->closed); ++round) {
		if (!cni_sparse_solve(g->sparse, g->c))
			return BROKEN;
		impulses_add(g);
		push_and_move(g, 1.0f);
		gap = gaps_find(g);
	}
	return gap <= FAILED * g->closed ? CLOSED_WELL : OPEN;
}

static int32_t velocities_close(const swing *g)
{
	int32_t k, i;
	for (k = g->c->begin; k < g->c->end; ++k) {
		cni_node *n = &g->sparse->nodes[k];
		for (i = 0; i < CNI_NODE_ROWS; ++i)
			n->x[i] = -cni_lever_speed(&n->lever[i], g->motions + n->ia, g->motions + n->ib);
	}
	if (!cni_sparse_solve(g->sparse, g->c))
		return 0;
	cni_direct_push(g->world, g->sparse, g->c);
	return 1;
}

/* Substeps that follow the fastest of the tension's springs, as far as they go. */
static int32_t substeps_of(const swing *g, const cni_solve *s, float rods)
{
	float fastest = 0.0f, needed;
	int32_t k;
	for (k = g->c->body_begin; k < g->c->body_end; ++k)
		fastest = cni_max(fastest, cni_abs(g->motions[g->sparse->bodies[k]].w));
	needed = cni_max(1.5f * s->dt * cni_sqrt(cni_tension_stiffness(g->world, g->sparse, g->c)), 2.0f * s->dt * fastest);
	needed = cni_max(cni_min(SUBSTEPS_MOST, needed), cni_min(SUBSTEPS_ROD_MOST, 1.5f * s->dt * cni_sqrt(rods)));
	return cni_max_i(s->substeps, (int32_t)needed);
}

static int32_t substep(const swing *g)
{
	int32_t closed;
	gaps_left_find(g);
	impulses_push(g, g->warm, g->warm);
	kick(g);
	drift(g);
	closed = positions_close(g);
	kick(g);
	cni_tension_damp(g->world, g->sparse, g->c, g->h);
	cni_direct_refresh(g->world, g->sparse, g->c);
	impulses_push(g, 2.0f * g->warm, 1.0f + 2.0f * g->warm);
	return velocities_close(g) ? closed : BROKEN;
}

/* ---- one substep of the projection ---- */

static void impulses_clear(const swing *g)
{
	int32_t k, i;
	for (k = g->c->begin; k < g->c->end; ++k)
		for (i = 0; i < work_of(g, k)->row_count; ++i)
			work_of(g, k)->rows[i].impulse = 0.0f;
}

/* Newton's method, for rotations of any size: the levers follow in each round. */
static int32_t positions_project(const swing *g)
{
	float gap = gaps_find(g), last = FLT_MAX;
	int32_t round;
	for (round = 0; round < PROJECT_ROUNDS && gap > g->closed && (!g->c->loops || gap < SLOWEST * last); ++round) {
		last = gap;
		cni_direct_refresh(g->world, g->sparse, g->c);
		(void)gaps_find(g);
		if (!cni_sparse_solve(g->sparse, g->c))
			return BROKEN;
		push_and_move(g, 0.0f);
		gap = gaps_find(g);
	}
	return gap <= 2.0f * g->world->settings.accuracy ? CLOSED_WELL : OPEN;
}

static int32_t substep_project(const swing *g)
{
	int32_t closed;
	gaps_left_find(g);
	impulses_clear(g);
	kick(g);
	kick(g);
	drift(g);
	closed = positions_project(g);
	cni_direct_refresh(g->world, g->sparse, g->c);
	return velocities_close(g) ? closed : BROKEN;
}

/* ---- the step ---- */

/* start is what it would be had the last substep been one of the world's: what tells bodies at rest needs it. */
static void last_substep_begins(const swing *g, const cni_solve *s)
{
	int32_t k;
	for (k = g->c->body_begin; k < g->c->body_end; ++k) {
		int32_t index = g->sparse->bodies[k];
		const cni_motion *m = g->motions + index;
		const cni_drive *d = cni_drives(g->world) + index;
		cni_velocity_start *start = cni_starts(g->world) + index;
		start->vx = m->vx + s->h * d->ax;
		start->vy = m->vy + s->h * d->ay;
		start->w = m->w + s->h * d->alpha;
		start->struck = 0.0f;
	}
}

static void bodies_end(const swing *g)
{
	int32_t k;
	for (k = g->c->body_begin; k < g->c->body_end; ++k)
		cni_drives(g->world)[g->sparse->bodies[k]].flags |= CNI_DRIVE_SWUNG;
}

/* Reactions are read as impulses of the world's substep. */
static void works_end(const swing *g, const cni_solve *s)
{
	float scale = s->h / g->h;
	int32_t k, i;
	for (k = g->c->begin; k < g->c->end; ++k) {
		cni_joint_work *w = work_of(g, k);
		for (i = 0; i < w->rigid_count; ++i)
			w->rows[i].impulse *= scale;
		for (; i < w->row_count; ++i)
			w->rows[i].impulse = 0.0f;
		w->flags |= CNI_WORK_SWUNG;
	}
}

static void works_stress(const swing *g)
{
	int32_t k;
	for (k = g->c->begin; k < g->c->end; ++k) {
		cni_joint_work *w = work_of(g, k);
		if (w->flags & CNI_WORK_BREAKABLE)
			cni_joint_work_stress(w, g->motions + w->ib, 1.0f / g->h);
	}
}

/* Impulses as the step found them. */
static void works_begin(const swing *g, float scale)
{
	int32_t k, i;
	for (k = g->c->begin; k < g->c->end; ++k) {
		cni_joint_work *w = work_of(g, k);
		for (i = 0; i < w->rigid_count; ++i)
			w->rows[i].impulse = scale * w->record->impulse[w->rows[i].slot];
		if (w->flags & CNI_WORK_BREAKABLE)
			w->numbers->force_stress = w->numbers->torque_stress = 0.0f;
	}
}

/* All as the step found it. */
static void step_undo(const swing *g)
{
	int32_t k;
	cni_dummy_stand(g->world);
	cni_direct_motions_keep(g->world, g->sparse, g->c, 1);
	cni_direct_turns(g->world, g->sparse, g->c);
	for (k = g->c->begin; k < g->c->end; ++k)
		cni_joint_work_rows(work_of(g, k), g->motions, g->sparse->turn);
}

/* Are there old gaps, which are closed with some speed? */
static int32_t gaps_are_closing(const swing *g)
{
	int32_t k, i;
	for (k = g->c->begin; k < g->c->end; ++k)
		for (i = 0; i < g->sparse->nodes[k].rows; ++i)
			if (cni_abs(work_of(g, k)->rows[i].error) > GAP_OLD * g->closed)
				return 1;
	return 0;
}

static float inverse_or_zero(float x)
{
	return x > 0.0f ? 1.0f / x : 0.0f;
}

static float kinetic(const swing *g)
{
	float sum = 0.0f;
	int32_t k;
	for (k = g->c->body_begin; k < g->c->body_end; ++k) {
		const cni_motion *m = g->motions + g->sparse->bodies[k];
		sum += inverse_or_zero(m->inv_mass) * (m->vx * m->vx + m->vy * m->vy) + inverse_or_zero(m->inv_inertia) * m->w * m->w;
	}
	return 0.5f * sum;
}

/* Of motion, less the work that drives have done in this step. */
static float energy(const swing *g)
{
	float sum = 0.0f;
	int32_t k;
	for (k = g->c->body_begin; k < g->c->body_end; ++k) {
		const cni_motion *m = g->motions + g->sparse->bodies[k];
		const cni_drive *d = cni_drives(g->world) + g->sparse->bodies[k];
		sum += inverse_or_zero(m->inv_mass) * (0.5f * (m->vx * m->vx + m->vy * m->vy) - (d->ax * m->dpx + d->ay * m->dpy)) +
		       inverse_or_zero(m->inv_inertia) * (0.5f * m->w * m->w - d->alpha * m->theta);
	}
	return sum;
}

/* What a step of free fall, and of closing gaps, may give from rest. */
static float energy_allowed(const swing *g, float dt)
{
	float sum = 0.0f, pull = gaps_are_closing(g) ? g->closing / g->h : 0.0f;
	int32_t k;
	for (k = g->c->body_begin; k < g->c->body_end; ++k) {
		const cni_motion *m = g->motions + g->sparse->bodies[k];
		const cni_drive *d = cni_drives(g->world) + g->sparse->bodies[k];
		sum += 0.5f * inverse_or_zero(m->inv_mass) * (dt * dt * (d->ax * d->ax + d->ay * d->ay) + pull * pull) +
		       0.5f * inverse_or_zero(m->inv_inertia) * dt * dt * d->alpha * d->alpha;
	}
	return sum;
}

/* ---- energy ---- */

/* Twice the kinetic energy of a change of velocity. */
static float change_of(const cni_motion *m, float vx, float vy, float w)
{
	return inverse_or_zero(m->inv_mass) * (vx * vx + vy * vy) + inverse_or_zero(m->inv_inertia) * w * w;
}

/*
 * Velocities and positions of the method are those of a motion that keeps T + V + h^2 (sum m a.a / 24 - sum m g.a / 12), to
 * the fourth order of h (backward analysis of the Stoermer-Verlet scheme: Hairer, Lubich and Wanner, "Geometric Numerical
 * Integration", 2006, IX.3, with the joints' forces among the accelerations a): six times the first term.
 * start: velocities before the last substep, as last_substep_begins left them.
 */
static float speeding_of(const swing *g, const cni_solve *s)
{
	float sum = 0.0f, last = cni_max(1.0f, s->warm_scale > 0.0f ? 1.0f / s->warm_scale : 1.0f); /* the account was filled at the last step's h */
	int32_t k;
	for (k = g->c->body_begin; k < g->c->body_end; ++k) {
		int32_t index = g->sparse->bodies[k];
		const cni_motion *m = g->motions + index;
		const cni_drive *d = cni_drives(g->world) + index;
		const cni_velocity_start *start = cni_starts(g->world) + index;
		sum += change_of(m, m->vx - start->vx + s->h * d->ax, m->vy - start->vy + s->h * d->ay, m->w - start->w + s->h * d->alpha);
	}
	return sum * last * last / 4.0f;
}

/* Of a lever's ends, those that have no mass: how fast the row closes for their motion alone. */
static float base_speed(const cni_lever *l, const cni_motion *a, const cni_motion *b)
{
	float speed = 0.0f;
	if (a->inv_mass == 0.0f)
		speed += l->ax * a->vx + l->ay * a->vy + l->aw * a->w;
	if (b->inv_mass == 0.0f)
		speed += l->bx * b->vx + l->by * b->vy + l->bw * b->w;
	return speed;
}

/* In a substep: J v = 0, so that what acts on the bodies with mass is minus what the others close. */
static float base_work_of(const swing *g)
{
	float work = 0.0f;
	int32_t k, i;
	for (k = g->c->begin; k < g->c->end; ++k) {
		const cni_node *n = &g->sparse->nodes[k];
		for (i = 0; i < n->rows; ++i)
			work -= work_of(g, k)->rows[i].impulse * base_speed(&n->lever[i], g->motions + n->ia, g->motions + n->ib);
	}
	return work;
}

typedef struct rigid_motion {
	float mass, inertia;
	float x, y, vx, vy, w;
	int32_t fixed;     /* some joint is to what has no mass: all that is free is the motion itself */
} rigid_motion;

static cni_vec2 place_of(const swing *g, int32_t index)
{
	const cni_body *b = cni_body_at(g->world, cni_awake_ids(g->world)[index]);
	return cni_v(b->cx + g->motions[index].dpx, b->cy + g->motions[index].dpy);
}

/* Has the component joints to what cannot move? */
static int32_t is_fixed(const swing *g)
{
	int32_t k;
	for (k = g->c->begin; k < g->c->end; ++k)
		if (g->motions[g->sparse->nodes[k].ia].inv_mass == 0.0f || g->motions[g->sparse->nodes[k].ib].inv_mass == 0.0f)
			return 1;
	return 0;
}

/* The motion of one rigid body with the component's momenta. */
static rigid_motion rigid_of(const swing *g)
{
	rigid_motion r = { 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, is_fixed(g) };
	float spin = 0.0f;
	int32_t k;
	for (k = g->c->body_begin; k < g->c->body_end && !r.fixed; ++k) {
		const cni_motion *m = g->motions + g->sparse->bodies[k];
		float mass = inverse_or_zero(m->inv_mass);
		cni_vec2 p = place_of(g, g->sparse->bodies[k]);
		r.mass += mass;
		r.x += mass * p.x;
		r.y += mass * p.y;
		r.vx += mass * m->vx;
		r.vy += mass * m->vy;
	}
	if (r.fixed || r.mass == 0.0f)
		return r;
	r.x /= r.mass;
	r.y /= r.mass;
	r.vx /= r.mass;
	r.vy /= r.mass;
	for (k = g->c->body_begin; k < g->c->body_end; ++k) {
		const cni_motion *m = g->motions + g->sparse->bodies[k];
		float mass = inverse_or_zero(m->inv_mass), inertia = inverse_or_zero(m->inv_inertia);
		cni_vec2 p = place_of(g, g->sparse->bodies[k]);
		float x = p.x - r.x, y = p.y - r.y;
		spin += mass * (x * (m->vy - r.vy) - y * (m->vx - r.vx)) + inertia * m->w;
		r.inertia += mass * (x * x + y * y) + inertia;
	}
	r.w = r.inertia > 0.0f ? spin / r.inertia : 0.0f;
	return r;
}

static cni_velocity_start velocity_in(const swing *g, const rigid_motion *r, int32_t index)
{
	cni_velocity_start v = { 0.0f, 0.0f, 0.0f, 0.0f };
	cni_vec2 p;
	if (r->fixed)
		return v;
	p = place_of(g, index);
	v.vx = r->vx - r->w * (p.y - r->y);
	v.vy = r->vy + r->w * (p.x - r->x);
	v.w = r->w;
	return v;
}

/* Twice the kinetic energy of the motion against the rigid one. */
static float inner_energy(const swing *g, const rigid_motion *r)
{
	float sum = 0.0f;
	int32_t k;
	for (k = g->c->body_begin; k < g->c->body_end; ++k) {
		const cni_motion *m = g->motions + g->sparse->bodies[k];
		cni_velocity_start v = velocity_in(g, r, g->sparse->bodies[k]);
		sum += change_of(m, m->vx - v.vx, m->vy - v.vy, m->w - v.w);
	}
	return 0.5f * sum;
}

/*
 * Takes this much energy out of the component's motion, but no more than ENERGY_GAIN of it: all velocities against the rigid
 * motion that has its momenta by the same factor, which keeps them and J v = 0. Returns what it took.
 */
static float energy_take(const swing *g, float surplus)
{
	rigid_motion r = rigid_of(g);
	float inner = inner_energy(g, &r), part, keep;
	int32_t k;
	if (!(inner > 0.0f && inner < FLT_MAX))
		return 0.0f;
	part = cni_min(surplus / inner, ENERGY_GAIN);
	keep = cni_sqrt(1.0f - part);
	for (k = g->c->body_begin; k < g->c->body_end; ++k) {
		cni_motion *m = g->motions + g->sparse->bodies[k];
		cni_velocity_start v = velocity_in(g, &r, g->sparse->bodies[k]);
		m->vx = v.vx + keep * (m->vx - v.vx);
		m->vy = v.vy + keep * (m->vy - v.vy);
		m->w = v.w + keep * (m->w - v.w);
	}
	return part * inner;
}

/* ---- what joints remember ---- */

static cni_joint_trust *trust_of(const swing *g, int32_t node)
{
	return &cni_joint_at(g->world, work_of(g, node)->joint)->trust;
}

/* Of a component: the sum of their accounts, the longest of their spans, the latest of their ends. */
static cni_joint_trust trust_read(const swing *g)
{
	cni_joint_trust sum = { 0.0f, 0, 0, 0 };
	uint32_t step = g->world->step_count;
	int32_t k;
	for (k = g->c->begin; k < g->c->end; ++k) {
		const cni_joint_trust *t = trust_of(g, k);
		sum.surplus += t->surplus;
		if (t->span > 0 && (sum.span == 0 || (int32_t)(t->until - step) > (int32_t)(sum.until - step)))
			sum.until = t->until;
		sum.span = (uint16_t)cni_max_i(sum.span, t->span);
	}
	return sum;
}

static void trust_write(const swing *g, const cni_joint_trust *trust)
{
	float surplus = trust->surplus / (float)(g->c->end - g->c->begin);
	int32_t k;
	for (k = g->c->begin; k < g->c->end; ++k) {
		cni_joint_trust *t = trust_of(g, k);
		*t = *trust;
		t->surplus = surplus;
	}
}

/* All substeps, or as many as go well. */
static int32_t substeps_run(swing *g, const cni_solve *s, int32_t substeps, int32_t projects)
{
	int32_t k, moving = is_fixed(g);
	g->base_work = 0.0f;
	for (k = 0; k < substeps; ++k) {
		int32_t how;
		if (k == substeps - 1)
			last_substep_begins(g, s);
		how = projects ? substep_project(g) : substep(g);
		if (how == BROKEN || (how == OPEN && !(projects && g->c->loops)))
			return how;
		works_stress(g);
		if (moving)
			g->base_work += base_work_of(g);
	}
	g->speeding = speeding_of(g, s);
	return CLOSED_WELL;
}

/* Work of drives along what positions may be wrong by: joints count as closed within it, and floats round. */
static float rounding_of_positions(const swing *g)
{
	float sum = 0.0f;
	int32_t k;
	for (k = g->c->body_begin; k < g->c->body_end; ++k) {
		const cni_motion *m = g->motions + g->sparse->bodies[k];
		const cni_drive *d = cni_drives(g->world) + g->sparse->bodies[k];
		const cni_body *b = cni_body_at(g->world, cni_awake_ids(g->world)[g->sparse->bodies[k]]);
		float way = 4.0f * g->closed + 4.0f * FLT_EPSILON * (cni_abs(b->cx) + cni_abs(b->cy) + b->extent);
		sum += inverse_or_zero(m->inv_mass) * way * (cni_abs(d->ax) + cni_abs(d->ay));
	}
	return sum;
}

/* What a step gained goes to the account, and what is too much for it out of the motion. Where it closed gaps that were there before,
   bodies were moved by that, and what they gained is not of their motion. */
static void account(const swing *g, cni_joint_trust *t, float gained)
{
	float most = g->speeding + ROUNDING * kinetic(g) + rounding_of_positions(g);
	t->surplus = cni_max(t->surplus + (g->mends ? 0.0f : gained), -most);
	if (!(t->surplus < FLT_MAX)) /* no account can be kept of what floats cannot hold */
		t->surplus = 0.0f;
	if (t->surplus > most)
		t->surplus -= energy_take(g, t->surplus - most);
}

/* A step by RATTLE with so many substeps. */
static int32_t rattle_try(swing *g, const cni_solve *s, cni_component *c, int32_t substeps, cni_joint_trust *t)
{
	float before, allowed, gained;
	int32_t how;
	g->h = s->dt / (float)substeps;
	g->closing = g->h * s->push_speed;
	works_begin(g, s->warm_scale * g->h / s->h);
	g->warm = 0.5f;
	if (cni_tension_needs_dampers(g->world, g->sparse, c, g->h)) {
		g->warm = 0.0f;
		c->width = CNI_NODE_ROWS;
	}
	cni_tension_damp(g->world, g->sparse, c, g->h);
	cni_direct_refresh(g->world, g->sparse, c);
	before = energy(g); /* as a step begins, no work has been done */
	g->mends = gaps_are_closing(g);
	allowed = energy_allowed(g, s->dt);
	how = substeps_run(g, s, substeps, 0);
	if (how != CLOSED_WELL)
		return how;
	gained = energy(g) - before - g->base_work;
	/* Written so that what is not a number fails too. */
	if (!(gained <= ENERGY_GAIN * before + allowed + g->speeding))
		return BROKEN;
	account(g, t, gained);
	return CLOSED_WELL;
}

/* Projections cannot raise kinetic energy: what gives more of it in spite of that is rounding. */
static int32_t project_try(swing *g, const cni_solve *s, cni_component *c, cni_joint_trust *t)
{
	float before, most;
	int32_t how;
	g->h = s->dt / (float)cni_max_i(SUBSTEPS_FIRM, s->substeps);
	g->closing = g->h * s->push_speed;
	works_begin(g, 0.0f);
	if (c->width > 2)
		cni_sparse_clear(g->sparse, c); /* no dampers */
	cni_direct_refresh(g->world, g->sparse, c);
	before = energy(g);
	g->mends = gaps_are_closing(g);
	most = cni_sqrt(before) + cni_sqrt(energy_allowed(g, s->dt)); /* speeds that drives give, by the norm of kinetic energy */
	most *= most;
	how = substeps_run(g, s, cni_max_i(SUBSTEPS_FIRM, s->substeps), 1);
	if (how != CLOSED_WELL)
		return how;
	if (!(kinetic(g) <= (1.0f + ENERGY_GAIN) * most) && g->base_work == 0.0f)
		return BROKEN;
	account(g, t, energy(g) - before - g->base_work);
	return CLOSED_WELL;
}

/* Each joint by itself after all, in this step and for some time. */
static void swing_release(const swing *g, const cni_solve *s, cni_joint_trust *t)
{
	int32_t k, i;
	cni_trust_fail(t, g->world->step_count, 1);
	t->surplus = 0.0f;
	for (k = g->c->begin; k < g->c->end; ++k) {
		cni_joint_work_prepare(g->world, s, g->sparse->nodes[k].owner);
		for (i = 0; i < work_of(g, k)->row_count; ++i)
			work_of(g, k)->rows[i].impulse = 0.0f; /* what could not be held has grown beyond all measure */
	}
	g->world->joints_soft_step = t->until > g->world->joints_soft_step ? t->until : g->world->joints_soft_step;
}

/* Returns 1 when a step by RATTLE went well, with as many substeps as it needs. */
static int32_t rattle_run(swing *g, const cni_solve *s, cni_component *c, int32_t substeps, cni_joint_trust *t)
{
	cni_joint_trust before = *t;
	for (; substeps <= SUBSTEPS_RETRY; substeps *= 2) {
		if (rattle_try(g, s, c, substeps, t) == CLOSED_WELL)
			return 1;
		*t = before;
		step_undo(g);
	}
	return 0;
}

static void swing_run(cn_world *world, const cni_solve *s, cni_component *c, float *left)
{
	swing g = { world, s->direct, c, cni_motions(world), s->h, CLOSED * world->settings.length_unit, 0.0f, left, 0.5f, 0.0f, 0.0f, 0 };
	float rods, last_h = s->warm_scale > 0.0f ? s->h / s->warm_scale : s->h; /* of which the records' impulses are */
	cni_joint_trust trust = trust_read(&g);
	int32_t projects;
	cni_direct_turns(world, g.sparse, c);
	rods = cni_tension_rods(world, g.sparse, c, last_h);
	cni_tension_find(world, g.sparse, c, last_h);
	cni_direct_motions_keep(world, g.sparse, c, 0);
	c->done = 1;
	projects = trust.span > 0 && trust.until > world->step_count;
	if (projects || !rattle_run(&g, s, c, substeps_of(&g, s, rods), &trust)) {
		if (!projects)
			cni_trust_fail(&trust, world->step_count, 0);
		if (project_try(&g, s, c, &trust) != CLOSED_WELL) {
			step_undo(&g);
			swing_release(&g, s, &trust);
			trust_write(&g, &trust);
			return;
		}
	}
	trust_write(&g, &trust);
	bodies_end(&g);
	works_end(&g, s);
}

static int32_t largest_component(const cni_sparse *sparse)
{
	int32_t k, largest = 0;
	for (k = 0; k < sparse->component_count; ++k)
		if (sparse->components[k].swings)
			largest = cni_max_i(largest, sparse->components[k].end - sparse->components[k].begin);
	return largest;
}

void cni_swings_run(cn_world *world, const cni_solve *s)
{
	float *left;
	int32_t k, largest = s->direct == NULL ? 0 : largest_component(s->direct);
	if (largest == 0)
		return;
	left = (float *)cni_arena_push(&world->arena, sizeof(float) * CNI_NODE_ROWS * (uint64_t)largest);
	if (left == NULL)
		world->warnings |= CN_WARNING_FRAME_MEMORY;
	for (k = 0; k < s->direct->component_count; ++k) {
		cni_component *c = &s->direct->components[k];
		if (!c->swings)
			continue;
		if (left != NULL)
			swing_run(world, s, c, left);
		else
			cni_direct_begin(world, s, s->direct, c);
	}
	(void)cni_arena_pop(&world->arena, left);
}
