/*
 * direct/heavy_response.c - what the joints of a component do to changes of velocity that its contacts make (direct/heavy_contacts.c): the inverse
 * effective mass of all their rows, a dense matrix.
 *
 * The response is found with the limits of the active set into which all contacts press, and again when the set changes: without them a heavy box
 * that lands on a light arm at its limit sinks in as far as the arm is light, and is thrown up again. Limits that a contact pulls, or that bear
 * less than it presses, are no part of it, as they let go, nor are motors, which bear no more than their torque. Two bodies of one component have
 * at most the mass of free ones: beside their hinge it would be any. In the substeps the joints turn away from the response: a turn by d changes
 * the square root of a row's inverse mass by at most d times that of the free bodies. Where that may be a large part, the response is found again.
 *
 * Reads systems of joints, lanes; writes responses, and velocities for as long as they are changes.
 */
#include "direct/heavy_response.h"

#include <string.h>

#define INVERSE_MASS_LEAST 1e-4f /* of a row, as a part of that of the free bodies: less is rounding */

void cni_heavy_pass_open(cni_heavy_pass *q, cn_world *world, const cni_solve *s, cni_sparse *sparse, cni_heavy_group *g)
{
	q->world = world;
	q->s = s;
	q->sparse = sparse;
	q->g = g;
	q->c = &sparse->components[g->component];
	q->heavies = sparse->heavies + g->begin;
	q->count = g->end - g->begin;
	q->speed_least = CNI_DIRECT_SPEED_LEAST * world->settings.length_unit;
	q->speed_most = CNI_HEAVY_SPEED_MOST * world->settings.push_speed_max;
	q->leaving = CNI_HEAVY_SLOW_STRESS * cni_length(world->settings.gravity) * s->h;
	q->points = g->points;
	q->levers = (cni_lever *)(void *)(q->points + q->count);
	q->speed = (float *)(void *)(q->levers + CNI_HEAVY_LANES * q->count);
	q->mass = q->speed + CNI_HEAVY_LANES * q->count;
	q->separation = q->mass + CNI_HEAVY_LANES * q->count;
	for (int32_t i = 0; i < q->count; ++i) {
		cni_direct_contact_read(world, cni_contact_at(world, q->heavies[i].contact), &q->points[i]);
		for (int32_t k = 0; k < CNI_HEAVY_ROWS; ++k)
			q->levers[cni_heavy_at(i, k)] = cni_direct_contact_lever(&q->points[i], k);
	}
}

/* ---- changes of velocity ---- */

static void velocity_clear(cni_motion *m)
{
	m->vx = m->vy = m->w = 0.0f;
}

static void velocity_add(cni_motion *m, const float *velocity)
{
	m->vx += velocity[0];
	m->vy += velocity[1];
	m->w += velocity[2];
}

/* A body that several contacts have leaves its velocity with the first; one that cannot move keeps it (change_of). */
void cni_heavy_set_aside(const cni_heavy_pass *q)
{
	cni_direct_motions_save(q->world, q->sparse, q->c, 0);
	for (int32_t k = q->c->body_begin; k < q->c->body_end; ++k)
		velocity_clear(cni_motions(q->world) + q->sparse->bodies[k]);
	for (int32_t k = 0; k < 2 * q->count; ++k) {
		cni_motion *m = cni_heavy_body(q, k >> 1, k & 1);
		float *aside = q->heavies[k >> 1].aside[k & 1];
		if (!cni_motion_can_move(m))
			continue;
		aside[0] = m->vx;
		aside[1] = m->vy;
		aside[2] = m->w;
		velocity_clear(m);
	}
}

void cni_heavy_return(const cni_heavy_pass *q)
{
	for (int32_t k = q->c->body_begin; k < q->c->body_end; ++k)
		velocity_add(cni_motions(q->world) + q->sparse->bodies[k], &q->sparse->saved[k].vx);
	for (int32_t k = 0; k < 2 * q->count; ++k)
		if (cni_motion_can_move(cni_heavy_body(q, k >> 1, k & 1)))
			velocity_add(cni_heavy_body(q, k >> 1, k & 1), q->heavies[k >> 1].aside[k & 1]);
}

/* The change of a body's velocity; a kinematic one keeps its velocity in motions, and has none. */
static const cni_motion *change_of(const cni_heavy_pass *q, int32_t index)
{
	const cni_motion *m = cni_motions(q->world) + index;
	return cni_motion_can_move(m) ? m : cni_motions(q->world); /* index 0 never moves */
}

void cni_heavy_sides_set(const cni_heavy_pass *q)
{
	for (int32_t k = q->c->begin; k < q->c->end; ++k) {
		cni_node *n = &q->sparse->nodes[k];
		cni_four_store(n->x, cni_four_scale(cni_levers_speed(&n->levers, change_of(q, n->ia), change_of(q, n->ib)), -1.0f));
	}
}

void cni_heavy_speeds(const cni_heavy_pass *q, float *out)
{
	for (int32_t i = 0; i < q->count; ++i)
		for (int32_t k = 0; k < CNI_HEAVY_LANES; ++k)
			out[cni_heavy_at(i, k)] = k < CNI_HEAVY_ROWS ? cni_lever_speed(&q->levers[cni_heavy_at(i, k)], cni_heavy_body(q, i, 0), cni_heavy_body(q, i, 1)) : 0.0f;
}

void cni_heavy_push(const cni_heavy_pass *q, int32_t contact, int32_t row, float impulse)
{
	if (impulse != 0.0f)
		cni_lever_push(&q->levers[cni_heavy_at(contact, row)], impulse, cni_heavy_body(q, contact, 0), cni_heavy_body(q, contact, 1));
}

/* ---- the response of the joints ---- */

/* The larger of `most` and how far the body's turn moves the levers of a joint at this arm. That is at most the turn itself; of pins in the part that
   the arm has of the radius of gyration: a wheel that spins about its centre moves none. */
static float levers_turn(const cni_motion *m, cni_vec2 arm, int32_t pins, float most)
{
	float turn = cni_abs(m->theta);
	if (turn <= most || !pins || !(m->inv_mass > 0.0f))
		return cni_max(turn, most);
	return cni_max(turn * cni_min(cni_length(arm) * cni_sqrt(m->inv_inertia / m->inv_mass), 1.0f), most);
}

float cni_heavy_turn(const cni_heavy_pass *q)
{
	float most = 0.0f;
	for (int32_t k = q->c->begin; k < q->c->end; ++k) {
		const cni_joint_constraint *w = cni_joint_constraints(q->world) + q->sparse->nodes[k].owner;
		int32_t type = w->record->type, pins = type == CN_JOINT_REVOLUTE || type == CN_JOINT_FIXED;
		most = levers_turn(cni_motions(q->world) + w->ia, w->start.ra, pins, most);
		most = levers_turn(cni_motions(q->world) + w->ib, w->start.rb, pins || type == CN_JOINT_WHEEL, most);
	}
	return most;
}

/* An impulse of 1 in one row of a contact: the changes of its two bodies. */
typedef struct unit_impulse {
	int32_t ia, ib;
	cni_motion a, b;
} unit_impulse;

static unit_impulse unit_impulse_make(const cni_heavy_pass *q, int32_t contact, int32_t row)
{
	unit_impulse u;
	u.ia = q->points[contact].ia;
	u.ib = q->points[contact].ib;
	u.a = *cni_heavy_body(q, contact, 0);
	u.b = *cni_heavy_body(q, contact, 1);
	velocity_clear(&u.a);
	velocity_clear(&u.b);
	cni_lever_push(&q->levers[cni_heavy_at(contact, row)], 1.0f, &u.a, &u.b);
	return u;
}

/* The change of a body; NULL: none. */
static const cni_motion *unit_change_of(const unit_impulse *u, int32_t index)
{
	return index == u->ia ? &u->a : index == u->ib ? &u->b : NULL;
}

/* Right sides of the joints against it: of those of its two bodies. */
static void unit_sides_set(const cni_heavy_pass *q, const unit_impulse *u)
{
	const cni_motion *still = cni_motions(q->world); /* index 0 never moves */
	for (int32_t k = q->c->begin; k < q->c->end; ++k) {
		cni_node *n = &q->sparse->nodes[k];
		const cni_motion *a = unit_change_of(u, n->ia), *b = unit_change_of(u, n->ib);
		cni_four_store(n->x, a != NULL || b != NULL ? cni_levers_speed(&n->levers, a != NULL ? a : still, b != NULL ? b : still) : cni_four_all(0.0f));
	}
}

/* Speed of a row after it, without joints. */
static float free_speed(const cni_heavy_pass *q, const unit_impulse *u, int32_t contact, int32_t row)
{
	const cni_motion *still = cni_motions(q->world);
	const cni_motion *a = unit_change_of(u, q->points[contact].ia), *b = unit_change_of(u, q->points[contact].ib);
	return a != NULL || b != NULL ? cni_lever_speed(&q->levers[cni_heavy_at(contact, row)], a != NULL ? a : still, b != NULL ? b : still) : 0.0f;
}

/* The sum, over the nodes where z is not zero, of y of one row times z of another: what the joints take from a speed. 0 where they have no finite
   solution. */
static float joints_take(const float *y, const float *z, const int32_t *at, int32_t count)
{
	cni_four sum = cni_four_all(0.0f);
	for (int32_t k = 0; k < count; ++k)
		sum = cni_four_add(sum, cni_four_times(cni_four_load(y + at[k]), cni_four_load(z + at[k])));
	float taken = cni_four_sum(sum);
	return cni_is_finite(taken) ? taken : 0.0f;
}

/* Speeds of this row and of all before it after an impulse of 1 in it, J (M^-1 - M^-1 J^T K^-1 J M^-1) J^T: symmetric. */
static void column_find(const cni_heavy_pass *q, int32_t contact, int32_t row)
{
	int32_t floats = CNI_NODE_LANES * (q->c->end - q->c->begin), last = CNI_HEAVY_ROWS * contact + row, count, k;
	float *halves = q->g->halves, *z = halves + (size_t)(CNI_HEAVY_ROWS * q->count) * (size_t)floats;
	int32_t *at = (int32_t *)(void *)(z + floats);
	float *own = &cni_heavy_column(q, contact, row)[cni_heavy_at(contact, row)], mass = q->points[contact].mass[row];
	unit_impulse u = unit_impulse_make(q, contact, row);
	unit_sides_set(q, &u);
	count = cni_sparse_halves(q->sparse, q->c, halves + (size_t)last * (size_t)floats, z, at);
	for (k = 0; k <= last; ++k) {
		int32_t i = k / CNI_HEAVY_ROWS, r = k % CNI_HEAVY_ROWS;
		if (q->points[i].mass[r] > 0.0f)
			cni_heavy_column(q, contact, row)[cni_heavy_at(i, r)] = cni_heavy_column(q, i, r)[cni_heavy_at(contact, row)] =
				free_speed(q, &u, i, r) - joints_take(halves + (size_t)k * (size_t)floats, z, at, count);
	}
	*own = cni_max(*own, (cni_heavy_is_inner(q, contact) ? 1.0f : INVERSE_MASS_LEAST) / mass);
	q->g->turn_most = cni_min(q->g->turn_most, CNI_HEAVY_TURN_PART * cni_sqrt(mass * *own));
}

/* Takes motors, and limits that let go, out of the system. Returns 0 if there are none. */
static int32_t rows_leave(const cni_heavy_pass *q)
{
	int32_t k, limits = 1;
	for (k = q->c->active_first; k != CNI_NONE; k = q->sparse->nodes[k].next_active)
		q->sparse->nodes[k].total[2] = 0.0f;
	for (k = 0; k < 2 * q->count && limits; ++k)
		if (q->points[k >> 1].mass[k & 1] > 0.0f) {
			unit_impulse u = unit_impulse_make(q, k >> 1, k & 1);
			unit_sides_set(q, &u);
			if (cni_sparse_solve(q->sparse, q->c))
				limits = cni_active_limits_ask(q->world, q->sparse, q->c, q->points[k >> 1].j[k & 1]);
		}
	return cni_active_leave(q->world, q->sparse, q->c);
}

void cni_heavy_response_find(const cni_heavy_pass *q)
{
	int32_t k, left = q->c->active && rows_leave(q);
	q->g->set_changes = q->c->set_changes;
	if (left)
		cni_sparse_factor(q->sparse, q->c, cni_motions(q->world));
	q->g->turn_most = FLT_MAX;
	memset(q->g->response, 0, sizeof(float) * (size_t)(CNI_HEAVY_ROWS * q->count) * (size_t)(CNI_HEAVY_LANES * q->count));
	for (k = 0; k < CNI_HEAVY_ROWS * q->count; ++k)
		if (q->points[k / CNI_HEAVY_ROWS].mass[k % CNI_HEAVY_ROWS] > 0.0f)
			column_find(q, k / CNI_HEAVY_ROWS, k % CNI_HEAVY_ROWS);
	q->g->turn_most += cni_heavy_turn(q);
	if (left)
		cni_direct_system(q->world, q->s, q->sparse, q->c);
}
