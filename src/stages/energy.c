/*
 * stages/energy.c - contacts and joints that only hold or bounce cannot raise kinetic energy; where a solve that did
 * not converge says they did, the excess is taken out.
 *
 * One sweep over light bodies that are caught among heavy ones may end far from the solution, and then with more energy
 * than the bodies had. What a set of bodies that act on each other has is split into the energy of moving as one rigid
 * body with its momentum and angular momentum, and the rest; the two are orthogonal in the mass metric. The rest is
 * scaled down until the sum is what it was, so momentum stays. Only islands that touch what does not move can have too
 * much in the first part (but for rounding): then all of it is scaled, and what does not move takes the difference.
 *
 * Springs and motors may give energy: each row j (J v0 + J v1) / 2, which is exact whatever else acts. Islands with
 * conveyors or kinematic bodies are left alone: bodies of theirs that jumped are marked, and stages/shock.c sees to them. Only
 * islands in which a velocity jumped in this substep (stages/shock.c) are looked at, for that is when solves fail; and of these
 * closely only those whose energy has grown, whoever gave it. Most have clearly not grown: a sum in the order of memory tells,
 * and no record is read.
 *
 * Reads start (velocities before the impulses of the substep) and motion; writes both by the same change, so that
 * the response between them stays.
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
	float mass, x, y;         /* total, centre (first the moment) */
	float px, py, spin, inertia; /* momentum; angular momentum and inertia around the centre */
	float before, after;      /* twice the kinetic energy; before: with what springs and motors gave */
	float keep_rest, keep_rigid; /* factors; both 1: nothing is wrong */
	int32_t lost;             /* it has speeds whose squares floats do not hold: impulses of the substep do not count */
	int32_t driven;
	int32_t grounded;         /* touches or hangs on what does not move: only then may its momentum change */
	int32_t looked_at, suspect; /* suspect: it may have grown, and then: it has */
	int32_t *members;         /* dense indices */
	int32_t count;            /* ... 0: not yet found */
} island_sum;

typedef struct looking {
	cn_world *world;
	island_sum *sums;  /* by an island's number in the step, as all here */
	int32_t *members;  /* room for all awake bodies */
	int32_t found;     /* of it */
} looking;

static int32_t moves(const cni_motion *m)
{
	return m->inv_mass > 0.0f;
}

static cni_vec2 center_of(const cn_world *world, int32_t k)
{
	const cni_body *b = cni_body_at(world, cni_awake_ids(world)[k]);
	return cni_v(b->cx + cni_motions(world)[k].dpx, b->cy + cni_motions(world)[k].dpy);
}

static float inertia_of(const cni_motion *m)
{
	return m->inv_inertia > 0.0f ? 1.0f / m->inv_inertia : 0.0f;
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

/* An island's list is gone through once: each of its links is waited for. */
static void members_find(looking *q, int32_t island)
{
	island_sum *sum = &q->sums[island];
	int32_t body;
	if (sum->count > 0)
		return;
	sum->members = q->members + q->found;
	for (body = record_of(q->world, island)->first; body != CNI_NONE; body = cni_body_at(q->world, body)->island_next)
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
		if (island == CNI_NONE || !q->sums[island].suspect)
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
		if (island == CNI_NONE || (island != of && !sums[island].looked_at))
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

/* ---- what is driven ---- */

/* The two bodies of what pushes with a motion of its own. One without an island is by itself between what does not give way. */
static void mark_driven(const cn_world *world, island_sum *sums, int32_t ia, int32_t ib)
{
	int32_t bodies[2] = { ia, ib }, k;
	for (k = 0; k < 2; ++k) {
		int32_t island = cni_awake_island_number(world, bodies[k]);
		if (island != CNI_NONE)
			sums[island].driven = 1;
		else if (cni_starts(world)[bodies[k]].struck == CNI_SHOCKED)
			cni_starts(world)[bodies[k]].struck = CNI_UNHELD;
	}
}

static int32_t pushes(const cn_world *world, int32_t index)
{
	return index != 0 && cni_motions(world)[index].inv_mass == 0.0f;
}

static int32_t somebody_pushes(const cn_world *world)
{
	int32_t k;
	for (k = 1; k < world->awake_count; ++k)
		if (pushes(world, k))
			return 1;
	return 0;
}

static void driven_by_bodies(const cn_world *world, island_sum *sums)
{
	int32_t color, k, l;
	for (color = CNI_COLOR_STATIC; color < CNI_COLORS; ++color)
		for (k = 0; k < world->colors[color].listed_count; ++k) {
			const cni_listed_block *b = &cni_listed_blocks(world, color)[k];
			for (l = 0; l < b->lanes; ++l)
				if (pushes(world, b->rows->ib[l]))
					mark_driven(world, sums, b->rows->ia[l], b->rows->ib[l]);
		}
	for (k = 0; k < world->awake_joints.count; ++k) {
		const cni_joint_work *w = cni_joint_works(world) + k;
		if (pushes(world, w->ia) || pushes(world, w->ib))
			mark_driven(world, sums, w->ia, w->ib);
	}
}

static int32_t driven_by_conveyors(const cn_world *world, island_sum *sums)
{
	int32_t color, k, l, found = 0;
	for (color = 0; color < CNI_COLORS; ++color)
		for (k = 0; k < world->colors[color].listed_count; ++k) {
			const cni_listed_block *b = &cni_listed_blocks(world, color)[k];
			for (l = 0; b->extra != NULL && l < b->lanes; ++l)
				if (b->extra->tangent_speed[l] != 0.0f) {
					mark_driven(world, sums, b->rows->ia[l], b->rows->ib[l]);
					found = 1;
				}
		}
	return found;
}

/* 0: nobody is. Blocks that rest are not in the lists, and nobody in them jumped. */
static int32_t driven_find(const cn_world *world, island_sum *sums)
{
	int32_t by_bodies = somebody_pushes(world);
	if (by_bodies)
		driven_by_bodies(world, sums);
	return driven_by_conveyors(world, sums) || by_bodies;
}

/* Marks bodies that jumped and whose energy is not held. Returns how many there are. */
static int32_t unheld_mark(const cn_world *world, const island_sum *sums)
{
	cni_velocity_start *starts = cni_starts(world);
	int32_t k, count = 0;
	for (k = cni_shocked_next(world, 1); k < world->awake_count; k = cni_shocked_next(world, k + 1)) {
		int32_t island = cni_awake_island_number(world, k);
		if (sums == NULL || (island != CNI_NONE && sums[island].driven))
			starts[k].struck = CNI_UNHELD;
		count += starts[k].struck == CNI_UNHELD;
	}
	return count;
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

/* What is driven is left alone, unless it was lost: factors_find. */
static int32_t has_too_much(const island_sum *s, float rounding)
{
	return s->suspect && !(s->after < FLT_MAX && (s->driven || s->after <= rounding * s->before));
}

/* With what was given: whose energy has grown. Its energies are those of its members one by one, and nothing is given yet. */
static int32_t suspects_confirm(looking *q)
{
	island_sum *sums = q->sums;
	int32_t k, count = 0;
	for (k = 0; k < q->world->step_island_count; ++k) {
		sums[k].suspect = has_too_much(&sums[k], ENERGY_ROUNDING_SURE);
		if (!sums[k].suspect)
			continue;
		energies_find(q, k);
		count += sums[k].suspect = has_too_much(&sums[k], ENERGY_ROUNDING);
	}
	return count;
}

/* What else is to be known of a suspect island. */
static void sum_find(const cn_world *world, island_sum *sum)
{
	int32_t n, pass;
	for (pass = 0; pass < 2; ++pass) {
		for (n = 0; n < sum->count; ++n) {
			int32_t k = sum->members[n];
			const cni_motion *m = cni_motions(world) + k;
			float mass, inertia;
			cni_vec2 c;
			if (!moves(m))
				continue;
			mass = 1.0f / m->inv_mass;
			inertia = inertia_of(m);
			c = center_of(world, k);
			if (pass == 0) {
				sum->mass += mass;
				sum->x += mass * c.x;
				sum->y += mass * c.y;
				sum->px += mass * m->vx;
				sum->py += mass * m->vy;
				continue;
			}
			c = cni_v(c.x - sum->x, c.y - sum->y);
			sum->spin += mass * (c.x * m->vy - c.y * m->vx) + inertia * m->w;
			sum->inertia += mass * (c.x * c.x + c.y * c.y) + inertia;
		}
		if (pass == 0 && sum->mass > 0.0f) {
			sum->x /= sum->mass;
			sum->y /= sum->mass;
		}
	}
}

static void grounded_by_contacts(const cn_world *world, island_sum *sums)
{
	int32_t color, k, l;
	for (color = CNI_COLOR_STATIC; color < CNI_COLORS; ++color)
		for (k = 0; k < world->colors[color].listed_count; ++k) {
			const cni_listed_block *b = &cni_listed_blocks(world, color)[k];
			for (l = 0; l < b->lanes; ++l) {
				int32_t island = cni_awake_island_number(world, b->rows->ia[l]);
				if (b->rows->ib[l] == 0 && island != CNI_NONE)
					sums[island].grounded = 1;
			}
		}
}

static float row_speed(const cni_row *r, cni_vec2 va, float wa, cni_vec2 vb, float wb)
{
	return r->ax * va.x + r->ay * va.y + r->aw * wa + r->bx * vb.x + r->by * vb.y + r->bw * wb;
}

/* Twice the energy that a row gave in the substep. */
static float row_work(const cn_world *world, const cni_joint_work *w, const cni_row *r)
{
	const cni_motion *a = cni_motions(world) + w->ia, *b = cni_motions(world) + w->ib;
	const cni_velocity_start *sa = cni_starts(world) + w->ia, *sb = cni_starts(world) + w->ib;
	return r->impulse * (row_speed(r, cni_v(sa->vx, sa->vy), sa->w, cni_v(sb->vx, sb->vy), sb->w) +
	                     row_speed(r, cni_v(a->vx, a->vy), a->w, cni_v(b->vx, b->vy), b->w));
}

/* The same of a joint in a lane: its spring and its motor are torques on body b. */
static float lane_work(const cn_world *world, const cni_joint_work *w)
{
	const cni_joint_block *k = cni_joint_block_of(world, w);
	int32_t l = w->lane % CNI_LANES;
	float torque = k->spring_j[l] + k->motor_j[l];
	return torque * ((cni_starts(world)[w->ib].w - cni_starts(world)[w->ia].w) + (cni_motions(world)[w->ib].w - cni_motions(world)[w->ia].w));
}

/* What springs and motors gave to suspects. */
static void work_of_joints(const cn_world *world, island_sum *sums)
{
	int32_t k, r;
	for (k = 0; k < world->awake_joints.count; ++k) {
		const cni_joint_work *w = cni_joint_works(world) + k;
		int32_t island = cni_awake_island_number(world, w->ia != 0 ? w->ia : w->ib), count;
		const cni_row *rows;
		cni_row in_lane[CNI_JOINT_ROWS];
		if (island == CNI_NONE || !sums[island].suspect)
			continue;
		sums[island].grounded |= w->ia == 0 || w->ib == 0;
		rows = w->row_lane != CNI_NONE ? in_lane : w->rows;
		count = w->row_lane != CNI_NONE ? cni_row_lane_read(world, w, in_lane) : w->row_count;
		for (r = 0; r < count; ++r)
			if ((w->flags & CNI_WORK_SPRINGY) || rows[r].kind == CNI_ROW_SPRING || rows[r].kind == CNI_ROW_DRIVE)
				sums[island].before += cni_max(row_work(world, w, &rows[r]), 0.0f);
		if (w->lane != CNI_NONE)
			sums[island].before += cni_max(lane_work(world, w), 0.0f);
	}
}

/* What of each part stays. Returns 1 when there is too much. */
static int32_t factors_find(island_sum *s)
{
	float rigid, rest;
	s->keep_rest = s->keep_rigid = 1.0f;
	s->lost = s->mass > 0.0f && !(s->after < FLT_MAX);
	if (s->lost)
		return 1;
	if (s->mass == 0.0f || s->driven || s->after <= ENERGY_ROUNDING * s->before)
		return 0;
	rigid = (s->px * s->px + s->py * s->py) / s->mass + (s->inertia > 0.0f ? s->spin * s->spin / s->inertia : 0.0f);
	rest = s->after - rigid;
	if (rigid <= s->before && rest > 0.0f) {
		s->keep_rest = cni_sqrt((s->before - rigid) / rest);
	} else {
		s->keep_rest = 0.0f;
		s->keep_rigid = s->grounded && rigid > s->before ? cni_sqrt(s->before / rigid) : 1.0f;
	}
	return 1;
}

static void factors_apply(const cn_world *world, const island_sum *s)
{
	float w = s->inertia > 0.0f ? s->spin / s->inertia : 0.0f;
	int32_t n;
	for (n = 0; n < s->count; ++n) {
		int32_t k = s->members[n];
		cni_motion *m = cni_motions(world) + k;
		cni_velocity_start *start = cni_starts(world) + k;
		float vx, vy, dvx, dvy, dw;
		cni_vec2 c;
		if (!moves(m))
			continue;
		if (s->lost) {
			m->vx = start->vx;
			m->vy = start->vy;
			m->w = start->w;
			continue;
		}
		c = center_of(world, k);
		vx = s->px / s->mass - w * (c.y - s->y);
		vy = s->py / s->mass + w * (c.x - s->x);
		dvx = s->keep_rigid * vx + s->keep_rest * (m->vx - vx) - m->vx;
		dvy = s->keep_rigid * vy + s->keep_rest * (m->vy - vy) - m->vy;
		dw = m->inv_inertia > 0.0f ? s->keep_rigid * w + s->keep_rest * (m->w - w) - m->w : 0.0f;
		m->vx += dvx;
		m->vy += dvy;
		m->w += dw;
		start->vx += dvx;
		start->vy += dvy;
		start->w += dw;
	}
}

static void excess_take(const looking *q)
{
	int32_t k;
	for (k = 0; k < q->world->step_island_count; ++k) {
		island_sum *sum = &q->sums[k];
		if (!has_too_much(sum, ENERGY_ROUNDING))
			continue;
		sum_find(q->world, sum);
		if (factors_find(sum))
			factors_apply(q->world, sum);
	}
}

/* Returns how many bodies that jumped are not held. */
static int32_t look_at_all(looking *q)
{
	int32_t unheld;
	memset(q->sums, 0, sizeof(island_sum) * (size_t)q->world->step_island_count);
	unheld = driven_find(q->world, q->sums) ? unheld_mark(q->world, q->sums) : 0;
	if (suspects_find(q) == 0)
		return unheld;
	grounded_by_contacts(q->world, q->sums);
	work_of_joints(q->world, q->sums);
	if (suspects_confirm(q) == 0)
		return unheld;
	work_of_joints(q->world, q->sums);
	excess_take(q);
	return unheld;
}

uint64_t cni_energy_bytes(int32_t bodies, int32_t islands)
{
	return sizeof(island_sum) * (uint64_t)cni_max_i(islands, 1) + 64u + sizeof(int32_t) * (uint64_t)bodies;
}

int32_t cni_energy_hold(cn_world *world)
{
	looking q = { world, NULL, NULL, 0 };
	int32_t unheld;
	q.sums = (island_sum *)cni_arena_push(&world->arena, sizeof(island_sum) * (uint64_t)cni_max_i(world->step_island_count, 1));
	if (q.sums != NULL)
		q.members = (int32_t *)cni_arena_push(&world->arena, sizeof(int32_t) * (uint64_t)world->awake_count);
	unheld = q.members != NULL ? look_at_all(&q) : unheld_mark(world, NULL); /* without memory nothing is held */
	(void)cni_arena_pop(&world->arena, q.members);
	(void)cni_arena_pop(&world->arena, q.sums);
	return unheld;
}
