/*
 * stages/energy.c - passive contacts and joints cannot raise kinetic energy; where a sweep that did not converge says they did,
 * the energy is taken back from the impulses that gave it.
 *
 * A sweep starts from the last substep's impulses. Each update of a row at rest lowers the energy, but one sweep does not
 * always undo a warm start that is wrong for this substep, as among light bodies between heavy ones. The work of a
 * constraint is w = j (J v0 + J v1) / 2, exact whatever else acts, and the sum of w is what the energy has grown by. So in
 * an island whose energy has grown
 *   1. constraints with w > 0 lose a part x of their impulses, the least that takes the excess back: v1 - x D, where D is the
 *      response to their impulses and the energy is quadratic in x;
 *   2. what is still too much is taken by a part of all impulses: v0 + y (v1 - v0). y = 0 is the energy before.
 * Only bodies that an impulse acts on change, scaled impulses stay in their friction cones, and bodies exchange equal
 * impulses, so that momentum stays. Springs, motors and conveyors may give energy: their positive work is allowed, and they
 * are not scaled. So may kinematic bodies: impulse times their velocity.
 *
 * Only islands in which a velocity jumped in this substep (stages/shock.c) are looked at, for that is when sweeps fail; and
 * of these closely only those whose energy may have grown: a sum in the order of memory tells.
 *
 * Reads start (velocities before the impulses of the substep), motion, lanes and joint works; writes start and motion by the
 * same change, so that the response between them, which the next substep starts from, stays.
 */
#include "base/cpu.h"
#include "stages/joint_pass.h"
#if CNI_HAS_WIDE_4
#define CNI_WIDTH 4
#include "base/wide.h"
#endif

#include <string.h>

/* Energies that agree this well are equal. */
#define ENERGY_ROUNDING 1.001f
/* ... and if they agree this well when summed in another order, they surely are. */
#define ENERGY_ROUNDING_SURE 1.0005f
#define SUMMED_MOST 64 /* numbers that are added up one by one: sums of such sums are rounded less */
#define FEW_PART 16    /* bodies of which fewer than this part of all are in question are found island by island */

typedef struct island_sum {
	float before, after;      /* twice the kinetic energy; before: with what springs, motors and movers gave */
	int32_t looked_at, suspect; /* suspect: it may have grown, and then: it has */
	int32_t *members;         /* dense indices */
	int32_t count;            /* ... 0: not yet found */
} island_sum;

/* D of the file comment. */
typedef struct response {
	float x, y, w;
} response;

typedef struct looking {
	cn_world *world;
	island_sum *sums;    /* by an island's number in the step, as all here */
	int32_t *members;    /* room for all awake bodies */
	response *responses; /* by dense index, of members of suspects */
	int32_t found;       /* members so far */
} looking;

static int32_t moves(const cni_motion *m)
{
	return m->inv_mass > 0.0f;
}

static float inverse_or_zero(float x)
{
	return x > 0.0f ? 1.0f / x : 0.0f;
}

static float inertia_of(const cni_motion *m)
{
	return inverse_or_zero(m->inv_inertia);
}

/* Twice the kinetic energies of a body, before and after. */
CNI_INLINE void energy_add(const cni_motion *m, const cni_velocity_start *v, float *before, float *after)
{
	float mass = moves(m) ? 1.0f / m->inv_mass : 0.0f, inertia = moves(m) ? inertia_of(m) : 0.0f;
	*before += mass * (v->vx * v->vx + v->vy * v->vy) + inertia * v->w * v->w;
	*after += mass * (m->vx * m->vx + m->vy * m->vy) + inertia * m->w * m->w;
}

static const cni_island *record_of(const cn_world *world, int32_t island)
{
	return cni_island_at(world, cni_island_of_number(world, island));
}

/* Impulses of this substep act on it: it neither flies freely nor has moved for the whole step. */
static int32_t is_solved(const cn_world *world, int32_t k)
{
	return !(cni_drives(world)[k].flags & (CNI_DRIVE_FREE | CNI_DRIVE_SWUNG));
}

/* An island's list is gone through once: each of its links is waited for. */
static void members_find(looking *q, int32_t island)
{
	island_sum *sum = &q->sums[island];
	int32_t body;
	if (sum->count > 0)
		return;
	sum->members = q->members + q->found;
	for (body = record_of(q->world, island)->first; body != CNI_NONE; body = cni_body_at(q->world, body)->island_next)
		if (is_solved(q->world, cni_body_at(q->world, body)->awake))
			sum->members[sum->count++] = cni_body_at(q->world, body)->awake;
	q->found += sum->count;
}

/* Those of all suspects, where islands are not few, in the order of memory. */
static void members_collect(looking *q)
{
	const cn_world *world = q->world;
	int32_t k;
	for (k = 0; k < world->step_island_count; ++k)
		if (q->sums[k].suspect) {
			q->sums[k].members = q->members + q->found;
			q->found += record_of(world, k)->count;
		}
	for (k = 1; k < world->awake_count; ++k) {
		int32_t island = cni_awake_island_number(world, k);
		if (island == CNI_NONE || !q->sums[island].suspect || !is_solved(world, k))
			continue;
		CNI_ASSERT(q->sums[island].count < record_of(world, island)->count);
		q->sums[island].members[q->sums[island].count++] = k;
	}
}

/* Of an island, in the order of its members. */
static void energies_find(looking *q, int32_t island)
{
	island_sum *sum = &q->sums[island];
	int32_t n;
	members_find(q, island);
	sum->before = sum->after = 0.0f;
	for (n = 0; n < sum->count; ++n) {
		int32_t k = sum->members[n];
		energy_add(cni_motions(q->world) + k, cni_starts(q->world) + k, &sum->before, &sum->after);
	}
}

/* Energies of some bodies: by x, y and angle, which a vector adds at once. */
typedef struct energies {
#if CNI_HAS_WIDE_4
	cni_wide before, after;
#else
	float before[3], after[3];
#endif
} energies;

CNI_INLINE void energies_add(energies *e, const cni_motion *m, const cni_velocity_start *start)
{
#if CNI_HAS_WIDE_4
	cni_wide v = cni_wide_load(&m->vx), s = cni_wide_load_loose(&start->vx), inverse = __builtin_shufflevector(v, cni_wide_load(&m->dpx), 3, 3, 7, 7);
	cni_mask has = (inverse > cni_wide_of(0.0f)) & (__builtin_shufflevector(v, v, 3, 3, 3, 3) > cni_wide_of(0.0f));
	cni_wide mass = (cni_wide)((cni_mask)(cni_wide_of(1.0f) / inverse) & has);
	e->before += mass * (s * s);
	e->after += mass * (v * v);
#else
	float mass = moves(m) ? 1.0f / m->inv_mass : 0.0f, inertia = moves(m) ? inertia_of(m) : 0.0f;
	e->before[0] += mass * (start->vx * start->vx);
	e->before[1] += mass * (start->vy * start->vy);
	e->before[2] += inertia * (start->w * start->w);
	e->after[0] += mass * (m->vx * m->vx);
	e->after[1] += mass * (m->vy * m->vy);
	e->after[2] += inertia * (m->w * m->w);
#endif
}

static void energies_sum(const energies *e, island_sum *sum)
{
	sum->before += e->before[0] + e->before[1] + e->before[2];
	sum->after += e->after[0] + e->after[1] + e->after[2];
}

/* Of all that are looked at, in the order of memory. */
static void energies_stream(const cn_world *world, island_sum *sums)
{
	const cni_motion *motions = cni_motions(world);
	const cni_velocity_start *starts = cni_starts(world);
	const energies none = { { 0 }, { 0 } };
	energies e = none;
	int32_t k, of = CNI_NONE, summed = 0, count = world->awake_count;
	for (k = 1; k < count; ++k) {
		int32_t island = cni_awake_island_number(world, k);
		if (island == CNI_NONE || (island != of && !sums[island].looked_at) || !is_solved(world, k))
			continue;
		if (island != of || ++summed == SUMMED_MOST) {
			if (of != CNI_NONE)
				energies_sum(&e, &sums[of]);
			of = island;
			e = none;
			summed = 0;
		}
		energies_add(&e, &motions[k], &starts[k]);
	}
	energies_sum(&e, &sums[of]);
}

/* ---- what has grown ---- */

/* Marks islands in which a velocity jumped. Returns how many bodies are in them. */
static int32_t shocked_find(const cn_world *world, island_sum *sums)
{
	int32_t k, count = 0;
	for (k = cni_shocked_next(world, 1); k < world->awake_count; k = cni_shocked_next(world, k + 1)) {
		int32_t island = cni_awake_island_number(world, k);
		if (island == CNI_NONE || sums[island].looked_at)
			continue;
		sums[island].looked_at = 1;
		count += record_of(world, island)->count;
	}
	return count;
}

/* Marks islands whose energy may have grown. Returns how many there are. */
static int32_t suspects_find(looking *q)
{
	const cn_world *world = q->world;
	island_sum *sums = q->sums;
	int32_t bodies = shocked_find(world, sums), few = bodies < world->awake_count / FEW_PART, k, count = 0;
	if (bodies > 0 && !few)
		energies_stream(world, sums);
	for (k = 0; k < world->step_island_count && bodies > 0; ++k) {
		if (!sums[k].looked_at)
			continue;
		if (few)
			energies_find(q, k);
		sums[k].suspect = !(sums[k].after <= ENERGY_ROUNDING_SURE * sums[k].before);
		count += sums[k].suspect;
	}
	if (count > 0 && !few)
		members_collect(q);
	return count;
}

/* ---- the work of constraints ---- */

/* Impulses of a constraint on both bodies: along x, along y, around the centre. */
typedef struct wrench {
	float ax, ay, aw, bx, by, bw;
} wrench;

static void wrench_add(wrench *f, const cni_row *r)
{
	f->ax += r->impulse * r->ax;
	f->ay += r->impulse * r->ay;
	f->aw += r->impulse * r->aw;
	f->bx += r->impulse * r->bx;
	f->by += r->impulse * r->by;
	f->bw += r->impulse * r->bw;
}

/* Moves, and impulses do not change that. */
static int32_t pushes(const cn_world *world, int32_t index)
{
	return index != 0 && cni_motions(world)[index].inv_mass == 0.0f;
}

/* Twice the work of an impulse on a body, at the mean of its velocities before and after all impulses. */
static float work_on(const cn_world *world, int32_t index, float x, float y, float w)
{
	const cni_motion *m = cni_motions(world) + index;
	const cni_velocity_start *s = cni_starts(world) + index;
	if (pushes(world, index))
		return 2.0f * (x * m->vx + y * m->vy + w * m->w);
	return index == 0 ? 0.0f : x * (s->vx + m->vx) + y * (s->vy + m->vy) + w * (s->w + m->w);
}

/* Adds the response to an impulse to D of a body. */
static void response_add(const looking *q, int32_t index, float x, float y, float w)
{
	const cni_motion *m = cni_motions(q->world) + index;
	response *d = &q->responses[index];
	d->x += m->inv_mass * x;
	d->y += m->inv_mass * y;
	d->w += m->inv_inertia * w;
}

/* What bodies push with is given. Of what is left positive work of a driven constraint is allowed, of others its impulse is to
   be scaled. */
static void work_take(const looking *q, island_sum *sum, int32_t ia, int32_t ib, const wrench *f, int32_t driven)
{
	float a = work_on(q->world, ia, f->ax, f->ay, f->aw), b = work_on(q->world, ib, f->bx, f->by, f->bw);
	sum->before -= (pushes(q->world, ia) ? a : 0.0f) + (pushes(q->world, ib) ? b : 0.0f);
	if (!(a + b > 0.0f))
		return;
	if (driven) {
		sum->before += a + b;
	} else {
		response_add(q, ia, f->ax, f->ay, f->aw);
		response_add(q, ib, f->bx, f->by, f->bw);
	}
}

/* NULL: its energy has not grown. */
static island_sum *suspect_of(const looking *q, int32_t ia, int32_t ib)
{
	int32_t island = cni_awake_island_number(q->world, ia != 0 && moves(cni_motions(q->world) + ia) ? ia : ib);
	return island != CNI_NONE && q->sums[island].suspect ? &q->sums[island] : NULL;
}

static void lane_take(const looking *q, const cni_listed_block *b, int32_t l)
{
	const cni_contact_block *k = b->rows;
	float j0 = k->p[0].jn[l], j1 = k->p[1].jn[l], jt = k->jt[l], jn = j0 + j1;
	float px = jn * k->nx[l] + jt * k->ny[l], py = jn * k->ny[l] - jt * k->nx[l];
	wrench f = { -px, -py, -(k->p[0].at[l] * j0 + k->p[1].at[l] * j1 - k->fa[l] * jt),
		     px, py, (k->p[0].at[l] - k->dt[l]) * j0 + (k->p[1].at[l] - k->dt[l]) * j1 - k->fb[l] * jt };
	island_sum *sum = jn > 0.0f ? suspect_of(q, k->ia[l], k->ib[l]) : NULL;
	if (sum != NULL)
		work_take(q, sum, k->ia[l], k->ib[l], &f, b->extra != NULL && b->extra->tangent_speed[l] != 0.0f);
}

/* Blocks that rest are not in the lists, and nobody in them jumped. */
static void contacts_take(const looking *q)
{
	int32_t color, k, l;
	for (color = 0; color < CNI_COLORS; ++color)
		for (k = 0; k < q->world->colors[color].listed_count; ++k) {
			const cni_listed_block *b = &cni_listed_blocks(q->world, color)[k];
			for (l = 0; l < b->lanes; ++l)
				lane_take(q, b, l);
		}
}

static void joint_take(const looking *q, const cni_joint_work *w)
{
	island_sum *sum = suspect_of(q, w->ia, w->ib);
	wrench passive = { 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f };
	cni_joint_impulses all;
	int32_t r;
	if (sum == NULL)
		return;
	cni_joint_impulses_read(q->world, w, &all);
	for (r = 0; r < all.count; ++r) {
		wrench driven = { 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f };
		int32_t drives = cni_row_kind_drives(all.rows[r].kind);
		wrench_add(drives ? &driven : &passive, &all.rows[r]);
		if (drives)
			work_take(q, sum, w->ia, w->ib, &driven, 1);
	}
	work_take(q, sum, w->ia, w->ib, &passive, 0);
}

static void joints_take(const looking *q)
{
	int32_t k;
	for (k = 0; k < q->world->awake_joints.count; ++k)
		joint_take(q, cni_joint_works(q->world) + k);
}

/* ---- taking the excess back ---- */

typedef float pair_sum(float mass, float inertia, const cni_motion *m, const cni_velocity_start *v, const response *d);

static float velocity_by_response(float mass, float inertia, const cni_motion *m, const cni_velocity_start *v, const response *d)
{
	(void)v;
	return mass * (m->vx * d->x + m->vy * d->y) + inertia * m->w * d->w;
}

static float response_by_response(float mass, float inertia, const cni_motion *m, const cni_velocity_start *v, const response *d)
{
	(void)m;
	(void)v;
	return mass * (d->x * d->x + d->y * d->y) + inertia * d->w * d->w;
}

static float sum_of(const looking *q, const island_sum *sum, pair_sum *pair)
{
	float total = 0.0f;
	int32_t n;
	for (n = 0; n < sum->count; ++n) {
		int32_t k = sum->members[n];
		const cni_motion *m = cni_motions(q->world) + k;
		if (moves(m) || m->inv_inertia > 0.0f)
			total += pair(inverse_or_zero(m->inv_mass), inverse_or_zero(m->inv_inertia), m, cni_starts(q->world) + k, &q->responses[k]);
	}
	return total;
}

/* v1 - x D, and v0 by the same. */
static void responses_take_out(const looking *q, const island_sum *sum, float x)
{
	int32_t n;
	for (n = 0; n < sum->count; ++n) {
		int32_t k = sum->members[n];
		cni_motion *m = cni_motions(q->world) + k;
		cni_velocity_start *start = cni_starts(q->world) + k;
		const response *d = &q->responses[k];
		m->vx -= x * d->x;
		m->vy -= x * d->y;
		m->w -= x * d->w;
		start->vx -= x * d->x;
		start->vy -= x * d->y;
		start->w -= x * d->w;
	}
}

/* The least x in [0, 1] for which x^2 dd - 2 x vd is at most -excess, or where it is least. */
static float part_of(float vd, float dd, float excess)
{
	float root = vd * vd - dd * excess;
	if (!(vd > 0.0f && dd > 0.0f))
		return 0.0f;
	return cni_min((root > 0.0f ? excess / (vd + cni_sqrt(root)) : vd / dd), 1.0f);
}

/* D of all impulses: motion - v0, where v0 is the velocity before the impulses. */
static void responses_of_all(const looking *q, const island_sum *sum, float taken)
{
	int32_t n;
	for (n = 0; n < sum->count; ++n) {
		int32_t k = sum->members[n];
		const cni_motion *m = cni_motions(q->world) + k;
		const cni_velocity_start *start = cni_starts(q->world) + k;
		response *d = &q->responses[k];
		d->x = (m->vx - start->vx) - taken * d->x;
		d->y = (m->vy - start->vy) - taken * d->y;
		d->w = (m->w - start->w) - taken * d->w;
	}
}

static void excess_take(const looking *q, const island_sum *sum)
{
	float excess = sum->after - sum->before, vd = sum_of(q, sum, velocity_by_response), dd = sum_of(q, sum, response_by_response);
	float part = part_of(vd, dd, excess);
	responses_take_out(q, sum, part);
	excess -= part * (2.0f * vd - part * dd);
	if (excess <= (ENERGY_ROUNDING - 1.0f) * sum->before)
		return;
	responses_of_all(q, sum, part);
	responses_take_out(q, sum, part_of(sum_of(q, sum, velocity_by_response), sum_of(q, sum, response_by_response), excess));
}

/* Speeds whose squares floats do not hold: impulses of the substep do not count. */
static void impulses_drop(const looking *q, const island_sum *sum)
{
	int32_t n;
	for (n = 0; n < sum->count; ++n) {
		cni_motion *m = cni_motions(q->world) + sum->members[n];
		const cni_velocity_start *start = cni_starts(q->world) + sum->members[n];
		m->vx = start->vx;
		m->vy = start->vy;
		m->w = start->w;
	}
}

/* Energies of suspects, one by one, without what was given. Returns how many are suspect still. */
static int32_t suspects_confirm(looking *q)
{
	island_sum *sums = q->sums;
	int32_t k, n, count = 0;
	for (k = 0; k < q->world->step_island_count; ++k) {
		if (!sums[k].suspect)
			continue;
		energies_find(q, k);
		sums[k].suspect = !(sums[k].after <= ENERGY_ROUNDING * sums[k].before);
		count += sums[k].suspect;
		for (n = 0; n < sums[k].count; ++n)
			memset(&q->responses[sums[k].members[n]], 0, sizeof(response));
	}
	return count;
}

static void suspects_hold(const looking *q)
{
	int32_t k;
	for (k = 0; k < q->world->step_island_count; ++k) {
		const island_sum *sum = &q->sums[k];
		if (!sum->suspect)
			continue;
		if (!(sum->after < FLT_MAX))
			impulses_drop(q, sum);
		else if (sum->after > ENERGY_ROUNDING * sum->before)
			excess_take(q, sum);
	}
}

static void look_at_all(looking *q)
{
	memset(q->sums, 0, sizeof(island_sum) * (size_t)q->world->step_island_count);
	if (suspects_find(q) == 0 || suspects_confirm(q) == 0)
		return;
	contacts_take(q);
	joints_take(q);
	suspects_hold(q);
}

uint64_t cni_energy_bytes(int32_t bodies, int32_t islands)
{
	return sizeof(island_sum) * (uint64_t)cni_max_i(islands, 1) + 96u + (sizeof(int32_t) + sizeof(response)) * (uint64_t)bodies;
}

void cni_energy_hold(cn_world *world)
{
	looking q = { world, NULL, NULL, NULL, 0 };
	uint64_t bodies = (uint64_t)world->awake_count;
	q.sums = (island_sum *)cni_arena_push(&world->arena, sizeof(island_sum) * (uint64_t)cni_max_i(world->step_island_count, 1));
	q.members = q.sums == NULL ? NULL : (int32_t *)cni_arena_push(&world->arena, sizeof(int32_t) * bodies);
	q.responses = q.members == NULL ? NULL : (response *)cni_arena_push(&world->arena, sizeof(response) * bodies);
	if (q.responses != NULL)
		look_at_all(&q);
	else
		world->warnings |= CN_WARNING_FRAME_MEMORY;
	(void)cni_arena_pop(&world->arena, q.responses);
	(void)cni_arena_pop(&world->arena, q.members);
	(void)cni_arena_pop(&world->arena, q.sums);
}
