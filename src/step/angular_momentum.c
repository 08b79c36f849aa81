/*
 * step/angular_momentum.c - angular momentum correction of isolated groups of bodies.
 *
 * Impulses use the lever arms of the step's beginning while bodies move on, and the velocity that moves a body contains the push
 * against overlaps, which the kept velocity does not. Both change the angular momentum of connected bodies a little in each
 * step, and a cluster in free space turns slower or faster. So at the end of the substeps, each group of bodies connected by
 * contacts or joints, under nothing but one uniform acceleration, gets a rigid rotation that restores the loss. r and u are
 * relative to the centre of mass, and I' is the inertia of all bodies about it:
 *   L = sum m r x u + I w
 *   dL = sum m (r x du + dr x u') + I dw     w' -= dL / I'     v' -= dL / I' x r'
 * A rigid rotation changes no relative velocity of touching points. Sums are over differences, so only the changes are rounded.
 *
 * Islands keep bodies that have separated until they sleep: connected groups are found anew each step, and single bodies are
 * skipped. The correction also skips islands that touch or are jointed to immovable bodies, islands with gears and pulleys
 * (which react on the world), groups with locked axes, damping or user forces, and bodies held by soft joints alone: at 100
 * rad/s these tear sooner with their angular momentum kept.
 *
 * Groups are found from lanes and joints over dense indices: of two roots the lower becomes the root of both (union-find, Galler
 * and Fisher, 1964), so a group's root is its first body in any order of contacts.
 *
 * Reads bodies (pose and velocity of the step's beginning), islands, external accelerations, joints, lanes; writes motion.
 */
#include "step/stages.h"
#include "joints/joint_constraint.h"

#include <string.h>

#define RECORDS_AHEAD 8 /* bodies whose records are asked for */

/* Connected bodies, by ascending dense index. */
typedef struct body_group {
	const int32_t *bodies;
	int32_t count;
} body_group;

/* All groups: arrays by dense index, and the bodies sorted by group. */
typedef struct body_groups {
	cn_world *world;
	uint8_t *held;    /* by island */
	int32_t *root;    /* an earlier body of the group, or itself; 0: held, or in no island */
	int32_t *end;     /* of a root: end of its group in bodies */
	int32_t *bodies;
} body_groups;

/* Sums over a group and its correction. */
typedef struct correction {
	float mass;
	cni_vec2 center, moved, speed, change; /* of the centre of mass: position, displacement; velocity, its change */
	float lost;    /* dL */
	float inertia; /* I' */
} correction;

/* Are there joints, or contacts between two movable bodies? */
static int32_t has_pairs(const cn_world *world)
{
	int32_t pairs = world->awake_joints.count + world->colors[CNI_COLOR_OVERFLOW].lanes;
	for (int32_t color = 0; color < CNI_COLOR_STATIC && pairs == 0; ++color)
		pairs += world->colors[color].lanes;
	return pairs > 0;
}

static void island_hold(const body_groups *p, int32_t index)
{
	int32_t island = cni_awake_island_number(p->world, index);
	if (island != CNI_NONE)
		p->held[island] = 1;
}

static void held_by_contacts(const body_groups *p)
{
	const cn_world *world = p->world;
	const cni_motion *motions = cni_motions(world);
	for (int32_t color = CNI_COLOR_STATIC; color < CNI_COLORS; ++color)
		for (int32_t block = world->colors[color].first; block != CNI_NONE; block = cni_block_info_at(world, block)->next) {
			const cni_contact_block *k = cni_block_at(world, block);
			for (int32_t l = 0; l < CNI_LANES; ++l)
				if (k->ia[l] != 0 && motions[k->ib[l]].inv_mass == 0.0f)
					island_hold(p, k->ia[l]);
		}
}

static void held_by_joints(const body_groups *p)
{
	const cni_motion *motions = cni_motions(p->world);
	for (int32_t k = 0; k < p->world->awake_joints.count; ++k) {
		const cni_joint_constraint *w = cni_joint_constraints(p->world) + k;
		if (motions[w->ia].inv_mass > 0.0f && motions[w->ib].inv_mass > 0.0f && w->record->type != CN_JOINT_GEAR && w->record->type != CN_JOINT_PULLEY)
			continue; /* the record, which costs a cache miss, is read last */
		island_hold(p, w->ia);
		island_hold(p, w->ib);
	}
}

/* ---- groups of connected bodies ---- */

/* Makes bodies of islands that are not held their own roots. 0: none of them has contacts or took its whole step with its joints. */
static int32_t roots_begin(const body_groups *p)
{
	const cni_external *externals = cni_externals(p->world);
	int32_t count = 0;
	p->root[0] = 0;
	for (int32_t k = 1; k < p->world->awake_count; ++k) {
		int32_t island = cni_awake_island_number(p->world, k);
		p->root[k] = island != CNI_NONE && !p->held[island] ? k : 0;
		count += p->root[k] != 0 && (externals[k].flags & (CNI_EXTERNAL_TOUCHED | CNI_EXTERNAL_FINISHED));
	}
	return count;
}

/* Finds the root and halves the path to it. */
static int32_t root_of(int32_t *root, int32_t k)
{
	while (root[k] != k) {
		root[k] = root[root[k]];
		k = root[k];
	}
	return k;
}

static void roots_join(int32_t *root, int32_t a, int32_t b)
{
	int32_t ra = root_of(root, a), rb = root_of(root, b), low = cni_min_i(ra, rb);
	root[ra] = root[rb] = low;
}

static void lanes_join(const body_groups *p, const cni_contact_block *k)
{
	for (int32_t l = 0; l < CNI_LANES; ++l)
		if (p->root[k->ia[l]] != 0 && p->root[k->ib[l]] != 0)
			roots_join(p->root, k->ia[l], k->ib[l]);
}

/* Blocks in memory order unless few are in use: blocks of the free list have no lanes. */
static void roots_of_contacts(const body_groups *p)
{
	const cn_world *world = p->world;
	int32_t all = !cni_blocks_are_few(world);
	for (int32_t block = 0; block < world->block_used && all; ++block)
		if (cni_block_info_at(world, block)->color != CNI_NONE)
			lanes_join(p, cni_block_at(world, block));
	for (int32_t color = 0; color < CNI_COLORS && !all; ++color)
		for (int32_t block = world->colors[color].first; block != CNI_NONE; block = cni_block_info_at(world, block)->next)
			lanes_join(p, cni_block_at(world, block));
}

/* Joins bodies that touch or are jointed. A lane's bodies are in one island, or one of them is in none. */
static void roots_find(const body_groups *p)
{
	const cn_world *world = p->world;
	roots_of_contacts(p);
	for (int32_t k = 0; k < world->awake_joints.count; ++k) {
		const cni_joint_constraint *w = cni_joint_constraints(world) + k;
		if (p->root[w->ia] != 0 && p->root[w->ib] != 0 && w->record->linked)
			roots_join(p->root, w->ia, w->ib);
	}
}

/* Sorts bodies by root. A body's root is lower, so its own root is final. */
static void bodies_find(const body_groups *p)
{
	int32_t count = p->world->awake_count, begin = 0;
	memset(p->end, 0, sizeof(int32_t) * (size_t)count);
	for (int32_t k = 1; k < count; ++k) {
		p->root[k] = p->root[p->root[k]];
		++p->end[p->root[k]];
	}
	for (int32_t k = 1; k < count; ++k) {
		int32_t members = p->end[k];
		p->end[k] = begin;
		begin += p->root[k] == k ? members : 0;
	}
	for (int32_t k = 1; k < count; ++k)
		if (p->root[k] != 0)
			p->bodies[p->end[p->root[k]]++] = k;
}

/* Do only contacts and joints within the group and one common acceleration act on it, with at least one contact or finished body? */
static int32_t is_isolated(const cn_world *world, const body_group *p)
{
	const cni_external *externals = cni_externals(world), *of_first = &externals[p->bodies[0]];
	uint32_t flags = 0;
	for (int32_t k = 0; k < p->count; ++k) {
		const cni_external *d = &externals[p->bodies[k]];
		if (d->ax != of_first->ax || d->ay != of_first->ay || d->alpha != 0.0f || cni_motions(world)[p->bodies[k]].inv_inertia == 0.0f)
			return 0;
		flags |= d->flags;
	}
	return !(flags & (CNI_EXTERNAL_DAMPED | CNI_EXTERNAL_LOCK_X | CNI_EXTERNAL_LOCK_Y)) && (flags & (CNI_EXTERNAL_TOUCHED | CNI_EXTERNAL_FINISHED));
}

static const cni_body *body_at(const cn_world *world, int32_t index)
{
	return cni_body_at(world, cni_awake_ids(world)[index]);
}

static void means_find(const cn_world *world, const body_group *p, correction *t)
{
	const cni_body *first = body_at(world, p->bodies[0]);
	for (int32_t k = 0; k < p->count; ++k) {
		const cni_body *b = body_at(world, p->bodies[k]);
		const cni_motion *m = cni_motions(world) + p->bodies[k];
		float mass = 1.0f / m->inv_mass;
		if (k + RECORDS_AHEAD < p->count) {
			CNI_PREFETCH(&body_at(world, p->bodies[k + RECORDS_AHEAD])->cx);
			CNI_PREFETCH(&body_at(world, p->bodies[k + RECORDS_AHEAD])->w);
		}
		t->mass += mass;
		t->center = cni_madd(t->center, mass, cni_body_a_to_b(first, b));
		t->moved = cni_madd(t->moved, mass, cni_v(m->dpx, m->dpy));
		t->speed = cni_madd(t->speed, mass, cni_v(b->vx, b->vy));
		t->change = cni_madd(t->change, mass, cni_v(m->vx - b->vx, m->vy - b->vy));
	}
	t->center = cni_mul(1.0f / t->mass, t->center);
	t->moved = cni_mul(1.0f / t->mass, t->moved);
	t->speed = cni_mul(1.0f / t->mass, t->speed);
	t->change = cni_mul(1.0f / t->mass, t->change);
}

/* Change of a body's position relative to the centre of mass. */
static cni_vec2 arm_change(const correction *t, const cni_motion *m)
{
	return cni_sub(cni_v(m->dpx, m->dpy), t->moved);
}

static void lost_find(const cn_world *world, const body_group *p, correction *t)
{
	const cni_body *first = body_at(world, p->bodies[0]);
	for (int32_t k = 0; k < p->count; ++k) {
		const cni_body *b = body_at(world, p->bodies[k]);
		const cni_motion *m = cni_motions(world) + p->bodies[k];
		float mass = 1.0f / m->inv_mass, inertia = 1.0f / m->inv_inertia;
		cni_vec2 r = cni_sub(cni_body_a_to_b(first, b), t->center), dr = arm_change(t, m);
		cni_vec2 du = cni_sub(cni_v(m->vx - b->vx, m->vy - b->vy), t->change);
		cni_vec2 u = cni_add(cni_sub(cni_v(b->vx, b->vy), t->speed), du);
		t->lost += mass * (cni_cross(r, du) + cni_cross(dr, u)) + inertia * (m->w - b->w);
		t->inertia += mass * cni_length_sq(cni_add(r, dr)) + inertia;
	}
}

static void correction_apply(const cn_world *world, const body_group *p, const correction *t)
{
	const cni_body *first = body_at(world, p->bodies[0]);
	float w = -t->lost / t->inertia;
	for (int32_t k = 0; k < p->count; ++k) {
		const cni_body *b = body_at(world, p->bodies[k]);
		cni_motion *m = cni_motions(world) + p->bodies[k];
		cni_vec2 r = cni_add(cni_sub(cni_body_a_to_b(first, b), t->center), arm_change(t, m));
		m->vx -= w * r.y;
		m->vy += w * r.x;
		m->w += w;
	}
}

static void group_restore(const cn_world *world, const body_group *p)
{
	correction t;
	if (p->count < 2 || !is_isolated(world, p))
		return;
	memset(&t, 0, sizeof t);
	means_find(world, p, &t);
	lost_find(world, p, &t);
	correction_apply(world, p, &t);
}

/* Groups are in the order of their roots. */
static void groups_restore(const body_groups *p)
{
	int32_t begin = 0;
	for (int32_t k = 1; k < p->world->awake_count; ++k) {
		const body_group one = { p->bodies + begin, p->end[k] - begin };
		if (p->root[k] != k)
			continue;
		begin = p->end[k];
		group_restore(p->world, &one);
	}
}

void cni_angular_momentum_restore(cn_world *world)
{
	uint64_t count = (uint64_t)world->awake_count, islands = (uint64_t)world->step_island_count;
	body_groups p = { world, NULL, NULL, NULL, NULL };
	if (islands == 0 || !has_pairs(world))
		return;
	p.root = (int32_t *)cni_scratch_push(world, 3 * sizeof(int32_t) * count + islands);
	if (p.root == NULL)
		return;
	p.end = p.root + count;
	p.bodies = p.end + count;
	p.held = (uint8_t *)(p.bodies + count);
	memset(p.held, 0, (size_t)islands);
	held_by_contacts(&p);
	held_by_joints(&p);
	if (roots_begin(&p) > 0) {
		roots_find(&p);
		bodies_find(&p);
		groups_restore(&p);
	}
	(void)cni_arena_pop(&world->arena, p.root);
}
