/*
 * stages/spin.c - what nothing holds keeps its angular momentum.
 *
 * Impulses act at arms of the step's beginning while bodies move on, and the velocity that moves a body differs from the one
 * that it keeps by what pushes overlaps apart. Both change the angular momentum of bodies that hang together a little in
 * each step, and a cluster in free space turns slower or faster. So at the end of the substeps what touches or is joined, and
 * has nothing acting on it but one uniform acceleration, is turned as a whole by what has been lost: with
 * L = sum m r x u + I w, r and u relative to the centre of mass, and I' the inertia of all around it,
 *   dL = sum m (r x du + dr x u') + I dw     w' -= dL / I'     v' -= dL / I' x r'
 * A rigid turn changes no relative velocity of touching points. Sums are of differences, so that rounding is one of changes.
 *
 * Islands keep bodies that have come apart until they sleep: their connected parts are found anew, and what flies alone
 * is left alone. Not for islands that touch or hang on what does not move, with gears and pulleys (which turn against
 * the world), nor for parts with locked axes, damping, or forces of the user's, nor for what soft joints alone hold: at
 * 100 rad/s they tear sooner when their spin is kept.
 *
 * Reads bodies (pose and velocity as the step began), islands, contacts, drives, joints, lanes; writes motion.
 */
#include "stages/solver.h"

#include <string.h>

/* Bodies that hang together. */
typedef struct part {
	int32_t *bodies;
	int32_t count;
} part;

/* What it takes to turn them. */
typedef struct turning {
	float mass;
	cni_vec2 center, moved, speed, change; /* centre of mass as the step began, its way; its velocity then, and the change of that */
	float lost;    /* dL */
	float inertia; /* I' */
} turning;

static cni_vec2 center_of(const cni_body *b, const cni_body *first)
{
	return cni_v((b->cx - first->cx) + (b->cx_low - first->cx_low), (b->cy - first->cy) + (b->cy_low - first->cy_low));
}

/* Joints, or contacts between two bodies that move? */
static int32_t has_pairs(const cn_world *world)
{
	int32_t color, pairs = world->awake_joints.count + world->colors[CNI_COLOR_OVERFLOW].lanes;
	for (color = 0; color < CNI_COLOR_STATIC && pairs == 0; ++color)
		pairs += world->colors[color].lanes;
	return pairs > 0;
}

static void hold(const cn_world *world, uint8_t *held, int32_t index)
{
	int32_t island = cni_awake_island(world, index);
	if (island != CNI_NONE)
		held[island] = 1;
}

static void held_by_contacts(const cn_world *world, uint8_t *held)
{
	const cni_motion *motions = cni_motions(world);
	int32_t color, block, l;
	for (color = CNI_COLOR_STATIC; color < CNI_COLORS; ++color)
		for (block = world->colors[color].first; block != CNI_NONE; block = cni_block_info_at(world, block)->next) {
			const cni_contact_block *k = cni_block_at(world, block);
			for (l = 0; l < CNI_LANES; ++l)
				if (k->ia[l] != 0 && motions[k->ib[l]].inv_mass == 0.0f)
					hold(world, held, k->ia[l]);
		}
}

static void held_by_joints(const cn_world *world, uint8_t *held)
{
	int32_t k, side;
	for (k = 0; k < world->awake_joints.count; ++k) {
		const cni_joint *j = cni_joint_at(world, ((const int32_t *)world->awake_joints.data)[k]);
		int32_t index[2];
		for (side = 0; side < 2; ++side)
			index[side] = j->body[side] != CNI_NONE ? cni_body_at(world, j->body[side])->awake : 0;
		if (j->type != CN_JOINT_GEAR && j->type != CN_JOINT_PULLEY && cni_motions(world)[index[0]].inv_mass > 0.0f && cni_motions(world)[index[1]].inv_mass > 0.0f)
			continue;
		hold(world, held, index[0]);
		hold(world, held, index[1]);
	}
}

/* ---- parts ---- */

static void part_add(const cn_world *world, part *p, int32_t body)
{
	cni_body *b = cni_body_at(world, body);
	if (b->flags & CNI_BODY_MARK)
		return;
	b->flags |= CNI_BODY_MARK;
	p->bodies[p->count++] = body;
}

/* All that hangs together with a body. */
static void part_find(const cn_world *world, part *p, int32_t first)
{
	int32_t k, key;
	p->count = 0;
	part_add(world, p, first);
	for (k = 0; k < p->count; ++k) {
		const cni_body *b = cni_body_at(world, p->bodies[k]);
		for (key = b->contact_first; key != CNI_NONE; key = cni_contact_of_key(world, key)->next[key & 1])
			if (cni_contact_of_key(world, key)->flags & CNI_CONTACT_LINKED)
				part_add(world, p, cni_contact_of_key(world, key)->body[1 - (key & 1)]);
		for (key = b->joint_first; key != CNI_NONE; key = cni_joint_at(world, key >> 1)->next[key & 1])
			if (cni_joint_at(world, key >> 1)->linked)
				part_add(world, p, cni_joint_at(world, key >> 1)->body[1 - (key & 1)]);
	}
}

/* Nothing but an acceleration that all have in common, and each other. */
static int32_t is_alone(const cn_world *world, const part *p)
{
	const cni_drive *drives = cni_drives(world), *of_first = &drives[cni_body_at(world, p->bodies[0])->awake];
	int32_t k;
	for (k = 0; k < p->count; ++k) {
		int32_t index = cni_body_at(world, p->bodies[k])->awake;
		const cni_drive *d = &drives[index];
		if (d->ax != of_first->ax || d->ay != of_first->ay || d->alpha != 0.0f || cni_motions(world)[index].inv_inertia == 0.0f)
			return 0;
		if (d->flags & (CNI_DRIVE_DAMPED | CNI_DRIVE_LOCK_X | CNI_DRIVE_LOCK_Y))
			return 0;
	}
	return 1;
}

static void means_find(const cn_world *world, const part *p, turning *t)
{
	const cni_body *first = cni_body_at(world, p->bodies[0]);
	int32_t k;
	for (k = 0; k < p->count; ++k) {
		const cni_body *b = cni_body_at(world, p->bodies[k]);
		const cni_motion *m = cni_motions(world) + b->awake;
		float mass = 1.0f / m->inv_mass;
		t->mass += mass;
		t->center = cni_madd(t->center, mass, center_of(b, first));
		t->moved = cni_madd(t->moved, mass, cni_v(m->dpx, m->dpy));
		t->speed = cni_madd(t->speed, mass, cni_v(b->vx, b->vy));
		t->change = cni_madd(t->change, mass, cni_v(m->vx - b->vx, m->vy - b->vy));
	}
	t->center = cni_mul(1.0f / t->mass, t->center);
	t->moved = cni_mul(1.0f / t->mass, t->moved);
	t->speed = cni_mul(1.0f / t->mass, t->speed);
	t->change = cni_mul(1.0f / t->mass, t->change);
}

/* Where a body is relative to the centre of mass, then and since; dr is the difference. */
static cni_vec2 arm_change(const turning *t, const cni_motion *m)
{
	return cni_sub(cni_v(m->dpx, m->dpy), t->moved);
}

static void lost_find(const cn_world *world, const part *p, turning *t)
{
	const cni_body *first = cni_body_at(world, p->bodies[0]);
	int32_t k;
	for (k = 0; k < p->count; ++k) {
		const cni_body *b = cni_body_at(world, p->bodies[k]);
		const cni_motion *m = cni_motions(world) + b->awake;
		float mass = 1.0f / m->inv_mass, inertia = 1.0f / m->inv_inertia;
		cni_vec2 r = cni_sub(center_of(b, first), t->center), dr = arm_change(t, m);
		cni_vec2 du = cni_sub(cni_v(m->vx - b->vx, m->vy - b->vy), t->change);
		cni_vec2 u = cni_add(cni_sub(cni_v(b->vx, b->vy), t->speed), du);
		t->lost += mass * (cni_cross(r, du) + cni_cross(dr, u)) + inertia * (m->w - b->w);
		t->inertia += mass * cni_length_sq(cni_add(r, dr)) + inertia;
	}
}

static void turn(const cn_world *world, const part *p, const turning *t)
{
	const cni_body *first = cni_body_at(world, p->bodies[0]);
	float w = -t->lost / t->inertia;
	int32_t k;
	for (k = 0; k < p->count; ++k) {
		const cni_body *b = cni_body_at(world, p->bodies[k]);
		cni_motion *m = cni_motions(world) + b->awake;
		cni_vec2 r = cni_add(cni_sub(center_of(b, first), t->center), arm_change(t, m));
		m->vx -= w * r.y;
		m->vy += w * r.x;
		m->w += w;
	}
}

static void part_hold(const cn_world *world, const part *p)
{
	turning t;
	if (p->count < 2 || !is_alone(world, p))
		return;
	memset(&t, 0, sizeof t);
	means_find(world, p, &t);
	lost_find(world, p, &t);
	turn(world, p, &t);
}

static void island_hold(const cn_world *world, const cni_island *i, part *p)
{
	int32_t body;
	int32_t found = 0;
	for (body = i->first; body != CNI_NONE; body = cni_body_at(world, body)->island_next) {
		const cni_body *b = cni_body_at(world, body);
		if ((b->flags & CNI_BODY_MARK) || !(cni_drives(world)[b->awake].flags & (CNI_DRIVE_TOUCHED | CNI_DRIVE_SWUNG)))
			continue;
		part_find(world, p, body);
		part_hold(world, p);
		found = 1;
	}
	for (body = found ? i->first : CNI_NONE; body != CNI_NONE; body = cni_body_at(world, body)->island_next)
		cni_body_at(world, body)->flags &= ~(uint32_t)CNI_BODY_MARK;
}

void cni_spin_hold(cn_world *world)
{
	uint8_t *held;
	part p = { NULL, 0 };
	int32_t k;
	if (world->island_used == 0 || !has_pairs(world))
		return;
	held = (uint8_t *)cni_arena_push(&world->arena, (uint64_t)world->island_used);
	if (held != NULL)
		p.bodies = (int32_t *)cni_arena_push(&world->arena, sizeof(int32_t) * (uint64_t)world->awake_count);
	if (p.bodies != NULL) { /* else there is no memory to look: the step goes on as it is */
		memset(held, 0, (size_t)world->island_used);
		held_by_contacts(world, held);
		held_by_joints(world, held);
		for (k = 0; k < world->island_used; ++k) {
			const cni_island *i = cni_island_at(world, k);
			if (i->first != CNI_NONE && i->awake && !held[k])
				island_hold(world, i, &p);
		}
	}
	(void)cni_arena_pop(&world->arena, p.bodies);
	(void)cni_arena_pop(&world->arena, held);
}
