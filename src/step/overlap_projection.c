/*
 * step/overlap_projection.c - moves heaps that come to rest out of their overlaps.
 *
 * Soft contacts push shapes apart by forces, and friction bears forces: a heap that its fall has squeezed stays squeezed, under pushes of a
 * hundred weights. Nor do the loads of contacts (contacts/contact_kernel.h) reach what tall heaps bear before these fall asleep. So overlaps of
 * bodies that are still are projected: poses alone are changed, without velocities and friction (nonlinear Gauss-Seidel; Catto, "Modeling
 * and Solving Constraints", GDC 2009). What a contact's spring loses in force goes to its load: the island stays in balance. Parts of a heap
 * come to rest long before all of it does, and are projected from then on: projected at last, all at once, they would start to move again.
 *
 * Every point of a still body has a row n.(dpb - dpa) + thb bt - tha at >= goal with a push that is never negative. The goal of an overlap is a
 * part of it; other points may close up to the overlap that is left. Overlaps with what nothing moves never grow beyond a slop: a solution
 * that would make one grow is discarded. Without that, bodies between two walls that are too near would be pushed through one of them.
 *
 * An island is projected in so many steps only: not all overlaps can be taken away, and heaps are to come to rest.
 * Left to their solvers are islands with joints or locked axes, those that are solved directly, and piles that are held from below: their
 * loads take the overlaps away, and loads that follow fast would let a stack sway until it falls.
 *
 * Reads lanes, islands, velocities; writes displacements of bodies, and loads. Where nothing overlaps it costs a scan of the separations in each
 * fourth step.
 */
#include "step/stages.h"
#include "base/bitset.h"
#include "contacts/contacts.h"
#include "contacts/deep_lanes.h"
#include "step/step.h"

#include <string.h>

#define SWEEPS 16       /* over all points */
#define SWEEPS_LEAST 2
#define SWEEPS_OF_FIXED 4
#define WORK_MOST 65536 /* points that sweeps solve in a step, but for the least sweeps: some half a millisecond */
#define STEPS_MOST 180  /* in which an island is projected */
#define STEPS_FORGET 3600u /* so long after the last one they do not count */
#define STEPS_A_LOOK 4  /* between looks for overlaps while nothing is projected; less than the sleep delay */

/* A contact point of an island, of whose bodies one or both are still. */
typedef struct point {
	cni_contact_row *row;
	int32_t l;
	int32_t kind;            /* CNI_CONTACTS_ of the block */
	int32_t island;
	int32_t ia, ib;
	float nx, ny, at, bt;    /* see model/contact.h */
	float m;                 /* effective mass */
	float s, goal;           /* separation, and by how much it is to grow */
	float push;
} point;

typedef struct still_island {
	int32_t state;
	float before, after;     /* its deepest overlap with what nothing moves */
} still_island;

enum { ISLAND_UNSEEN, ISLAND_MOVES, ISLAND_LEFT, ISLAND_PROJECTED };

typedef struct projection {
	cn_world *world;
	const cni_solve *s;
	still_island *islands;   /* NULL: no deep lane so far */
	int32_t found;           /* 1: some island is projected */
	int32_t blocks;          /* listed */
	point *points;           /* NULL: they are counted */
	int32_t count;
} projection;

/* ---- which islands ---- */

static int32_t island_is_projected(const projection *p, int32_t island)
{
	cn_world *world = p->world;
	cni_island *i = cni_island_at(world, island);
	if (i->tier == CNI_TIER_DIRECT)
		return 0;
	if (world->step_count + 1u - i->projected_step > STEPS_FORGET)
		i->projected_steps = 0;
	if (i->projected_steps >= STEPS_MOST)
		return 0;
	for (int32_t body = i->first; body != CNI_NONE; body = cni_body_at(world, body)->island_next) {
		const cni_body *b = cni_body_at(world, body);
		if (cni_body_is_jointed(world, b) || (b->flags & (CN_BODY_LOCK_X | CN_BODY_LOCK_Y)))
			return 0;
	}
	if (cni_pile_is_supported(world, island, p->s->h))
		return 0;
	i->projected_step = world->step_count + 1u;
	++i->projected_steps;
	return 1;
}

/* The state of an island that has a deep lane. Where parts of it move, only deeper ones count, each STEPS_A_LOOK steps. */
static int32_t state_find(const projection *p, int32_t island, int32_t state, float deep)
{
	cn_world *world = p->world;
	if (state == ISLAND_UNSEEN && !cni_island_is_slower(world, cni_island_at(world, island), world->settings.sleep_speed))
		state = world->step_count % STEPS_A_LOOK == 0 ? ISLAND_MOVES : ISLAND_LEFT;
	if (state == ISLAND_UNSEEN || (state == ISLAND_MOVES && deep > CNI_OVERLAP_FROM_MOVING * world->settings.slop))
		return island_is_projected(p, island) ? ISLAND_PROJECTED : ISLAND_LEFT;
	return state;
}

static int32_t islands_make(projection *p)
{
	uint64_t bytes = sizeof(still_island) * (uint64_t)p->world->island_used;
	p->islands = (still_island *)cni_scratch_push(p->world, bytes);
	if (p->islands != NULL)
		memset(p->islands, 0, (size_t)bytes);
	return p->islands != NULL;
}

/* Marks the islands that are projected. */
static void islands_find(projection *p, float most)
{
	const cni_listed_block *list = cni_listed_blocks(p->world, 0);
	for (int32_t k = 0; k < p->blocks; ++k)
		for (uint32_t deep = cni_deep_lanes(list[k].rows, most); deep != 0; deep &= deep - 1u) {
			int32_t l = cni_bit_lowest32(deep), island = cni_awake_island(p->world, list[k].rows->ia[l]);
			if (island == CNI_NONE || (p->islands == NULL && !islands_make(p)))
				continue;
			still_island *i = &p->islands[island];
			if (i->state >= ISLAND_LEFT)
				continue;
			i->state = state_find(p, island, i->state, cni_lane_overlap(list[k].rows, l));
			p->found |= i->state == ISLAND_PROJECTED;
		}
}

/* ---- their points ---- */

/* With a body that nothing moves? */
static int32_t is_fixed(const cn_world *world, const point *q)
{
	return cni_motions(world)[q->ib].inv_mass == 0.0f;
}

/* slow: number of its bodies that are. A moving one is not pushed out, but what is pushed into it. */
static void point_make(const projection *p, point *q, cni_contact_block *k, int32_t i, int32_t l, int32_t slow)
{
	cni_contact_row *row = &k->p[i];
	float slop = p->world->settings.slop, excess = -row->s0[l] - CNI_OVERLAP_LEFT * slop;
	q->row = row;
	q->l = l;
	q->ia = k->ia[l];
	q->ib = k->ib[l];
	q->nx = k->nx[l];
	q->ny = k->ny[l];
	q->at = row->at[l];
	q->bt = row->at[l] - k->dt[l];
	q->m = row->nm[l];
	q->s = row->s0[l];
	q->goal = excess <= 0.0f ? excess : slow == 2 ? cni_min(CNI_OVERLAP_PART * excess, slop) : 0.0f;
	q->push = 0.0f;
}

/* Stores the points of a lane, or only counts them. */
static void lane_collect(projection *p, const cni_listed_block *b, int32_t l, int32_t island)
{
	cni_vec2 frame = cni_island_frame(p->world, cni_island_at(p->world, island));
	int32_t slow = cni_motion_is_slow(p->world, b->rows->ia[l], frame) + cni_motion_is_slow(p->world, b->rows->ib[l], frame);
	for (int32_t i = 0; slow > 0 && i < 2; ++i) {
		if (!(b->rows->p[i].nm[l] > 0.0f) || b->rows->p[i].s0[l] > p->world->settings.slop)
			continue;
		if (p->points != NULL) {
			point *q = &p->points[p->count];
			point_make(p, q, b->rows, i, l, slow);
			q->kind = b->kind;
			q->island = island;
			if (is_fixed(p->world, q))
				p->islands[island].before = cni_max(p->islands[island].before, -q->s);
		}
		++p->count;
	}
}

static void points_collect(projection *p)
{
	const cni_listed_block *list = cni_listed_blocks(p->world, 0);
	p->count = 0;
	for (int32_t k = 0; k < p->blocks; ++k)
		for (int32_t l = list[k].begin; l < list[k].lanes; ++l) {
			int32_t island = cni_awake_island(p->world, list[k].rows->ia[l]);
			if (island != CNI_NONE && p->islands[island].state == ISLAND_PROJECTED)
				lane_collect(p, &list[k], l, island);
		}
}

/* Returns 0 if there are none, or no memory. */
static int32_t points_make(projection *p)
{
	points_collect(p);
	if (p->count > 0)
		p->points = (point *)cni_scratch_push(p->world, sizeof(point) * (uint64_t)p->count);
	if (p->points == NULL)
		return 0;
	points_collect(p);
	return 1;
}

/* ---- projection ---- */

/* How much the displacements open it. */
static float point_gain(const cn_world *world, const point *q)
{
	const cni_motion *a = cni_motions(world) + q->ia, *b = cni_motions(world) + q->ib;
	return q->nx * (b->dpx - a->dpx) + q->ny * (b->dpy - a->dpy) + b->theta * q->bt - a->theta * q->at;
}

static void point_solve(const cn_world *world, point *q)
{
	cni_motion *a = cni_motions(world) + q->ia, *b = cni_motions(world) + q->ib;
	float push = cni_max(q->push + q->m * (q->goal - point_gain(world, q)), 0.0f), change = push - q->push;
	q->push = push;
	a->dpx -= a->inv_mass * change * q->nx;
	a->dpy -= a->inv_mass * change * q->ny;
	a->theta -= a->inv_inertia * change * q->at;
	b->dpx += b->inv_mass * change * q->nx;
	b->dpy += b->inv_mass * change * q->ny;
	b->theta += b->inv_inertia * change * q->bt;
}

/* The last sweeps are over points with fixed bodies alone: nothing is pushed into what does not yield, unless it stands between two of them. */
static void sweep(const projection *p)
{
	int32_t left = cni_max_i(cni_min_i(WORK_MOST / p->count, SWEEPS), SWEEPS_LEAST) + SWEEPS_OF_FIXED;
	while (left-- > 0)
		for (int32_t k = 0; k < p->count; ++k)
			if (left >= SWEEPS_OF_FIXED || is_fixed(p->world, &p->points[k]))
				point_solve(p->world, &p->points[k]);
}

/* Impulse of a point's spring at rest, for an effective mass of 1: see point_prepare in contacts/contact_kernel.h. */
static float spring(const cni_contact_pass *pass, float s)
{
	float deep = cni_clamp(pass->deep_from - pass->deep_rate * s, 0.0f, 1.0f);
	float mass_scale = pass->soft.mass_scale + (pass->deep.mass_scale - pass->soft.mass_scale) * deep;
	float bias_scale = pass->soft.bias_scale + (pass->deep.bias_scale - pass->soft.bias_scale) * deep;
	return s < 0.0f ? cni_min(-bias_scale * s, pass->push_speed * mass_scale) / (1.0f - mass_scale) : 0.0f;
}

static void load_take(const projection *p, const point *q)
{
	const cni_contact_pass *pass = &p->s->contact[q->kind];
	float change = q->m * (spring(pass, q->s) - spring(pass, q->s + point_gain(p->world, q)));
	q->row->load[q->l] = cni_clamp(q->row->load[q->l] + change, 0.0f, q->row->jn[q->l]);
}

static void displacement_clear(const cn_world *world, int32_t index)
{
	cni_motion *m = cni_motions(world) + index;
	m->dpx = m->dpy = m->theta = 0.0f;
}

static void solution_take(const projection *p)
{
	for (int32_t k = 0; k < p->count; ++k) {
		const point *q = &p->points[k];
		still_island *i = &p->islands[q->island];
		if (is_fixed(p->world, q))
			i->after = cni_max(i->after, -q->s - point_gain(p->world, q));
	}
	for (int32_t k = 0; k < p->count; ++k) {
		const point *q = &p->points[k];
		if (!(p->islands[q->island].after > cni_max(p->islands[q->island].before, p->world->settings.slop))) {
			load_take(p, q);
			continue;
		}
		displacement_clear(p->world, q->ia);
		displacement_clear(p->world, q->ib);
	}
}

/* The islands, and the points or what cni_pile_is_supported takes. */
uint64_t cni_project_overlaps_bytes(int32_t bodies, int32_t islands, int32_t contacts)
{
	uint64_t points = sizeof(point) * 2u * (uint64_t)contacts + 64u, piles = cni_gravity_preload_bytes(bodies);
	return sizeof(still_island) * (uint64_t)islands + 64u + (points > piles ? points : piles);
}

void cni_stage_project_overlaps(cn_world *world, const cni_solve *s)
{
	projection p = { world, s, NULL, 0, 0, NULL, 0 };
	if (!world->projects && world->step_count % STEPS_A_LOOK != 0)
		return;
	p.blocks = world->colors[CNI_COLORS - 1].listed + world->colors[CNI_COLORS - 1].listed_count;
	islands_find(&p, CNI_OVERLAP_FROM * world->settings.slop);
	world->projects = (uint16_t)p.found;
	if (p.found && points_make(&p)) {
		sweep(&p);
		solution_take(&p);
		cni_arena_pop(&world->arena, p.points);
	}
	cni_arena_pop(&world->arena, p.islands);
}
