/*
 * direct/heavy_response.c - what the joints of a component do to changes of velocity that its contacts make (direct/heavy_contacts.c): the inverse
 * effective mass of all their rows, a dense matrix.
 *
 * The response is found without motors and limits, which may leave the active set. Two bodies of one component have at most the mass of free
 * ones: beside their hinge it would be any. In the substeps the joints turn away from the response: a turn by d changes the square root of a
 * row's inverse mass by at most d times that of the free bodies. Where that may be a large part, the response is found again.
 *
 * Reads systems of joints, lanes; writes responses, and velocities for as long as they are changes.
 */
#include "direct/heavy_response.h"

#define INVERSE_MASS_LEAST 1e-4f /* of a row, as a part of that of the free bodies: less is rounding */

void cni_heavy_pass_open(cni_heavy_pass *q, cn_world *world, const cni_solve *s, cni_sparse *sparse, cni_heavy_group *g)
{
	int32_t i, k;
	q->world = world;
	q->s = s;
	q->sparse = sparse;
	q->g = g;
	q->c = &sparse->components[g->component];
	q->heavies = sparse->heavies + g->begin;
	q->count = g->end - g->begin;
	q->points = sparse->heavy_points;
	q->levers = (cni_lever *)(void *)(q->points + q->count);
	q->speed = (float *)(void *)(q->levers + CNI_HEAVY_LANES * q->count);
	q->mass = q->speed + CNI_HEAVY_LANES * q->count;
	q->separation = q->mass + CNI_HEAVY_LANES * q->count;
	for (i = 0; i < q->count; ++i) {
		cni_direct_contact_read(world, cni_contact_at(world, q->heavies[i].contact), &q->points[i]);
		for (k = 0; k < CNI_HEAVY_ROWS; ++k)
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

static void velocities_clear(const cni_heavy_pass *q)
{
	int32_t k;
	for (k = q->c->body_begin; k < q->c->body_end; ++k)
		velocity_clear(cni_motions(q->world) + q->sparse->bodies[k]);
	for (k = 0; k < 2 * q->count; ++k)
		velocity_clear(cni_heavy_body(q, k >> 1, k & 1));
}

/* A body that several contacts have leaves its velocity with the first. */
void cni_heavy_set_aside(const cni_heavy_pass *q)
{
	int32_t k;
	cni_direct_motions_save(q->world, q->sparse, q->c, 0);
	for (k = q->c->body_begin; k < q->c->body_end; ++k)
		velocity_clear(cni_motions(q->world) + q->sparse->bodies[k]);
	for (k = 0; k < 2 * q->count; ++k) {
		cni_motion *m = cni_heavy_body(q, k >> 1, k & 1);
		float *aside = q->heavies[k >> 1].aside[k & 1];
		aside[0] = m->vx;
		aside[1] = m->vy;
		aside[2] = m->w;
		velocity_clear(m);
	}
}

void cni_heavy_return(const cni_heavy_pass *q)
{
	int32_t k;
	for (k = q->c->body_begin; k < q->c->body_end; ++k)
		velocity_add(cni_motions(q->world) + q->sparse->bodies[k], &q->sparse->saved[k].vx);
	for (k = 0; k < 2 * q->count; ++k)
		velocity_add(cni_heavy_body(q, k >> 1, k & 1), q->heavies[k >> 1].aside[k & 1]);
}

/* The change of a body's velocity; a kinematic body of a joint keeps its velocity in motions, and has none. */
static const cni_motion *change_of(const cni_heavy_pass *q, int32_t index)
{
	const cni_motion *m = cni_motions(q->world) + index;
	return cni_motion_can_move(m) ? m : cni_motions(q->world); /* index 0 never moves */
}

void cni_heavy_sides_set(const cni_heavy_pass *q)
{
	int32_t k;
	for (k = q->c->begin; k < q->c->end; ++k) {
		cni_node *n = &q->sparse->nodes[k];
		cni_four_store(n->x, cni_four_scale(cni_levers_speed(&n->levers, change_of(q, n->ia), change_of(q, n->ib)), -1.0f));
	}
}

/* Adds what the joints do to the changes; nothing where they have no finite solution. */
static void joints_answer(const cni_heavy_pass *q)
{
	int32_t k;
	cni_heavy_sides_set(q);
	if (!cni_sparse_solve(q->sparse, q->c))
		return;
	for (k = q->c->begin; k < q->c->end; ++k) {
		const cni_node *n = &q->sparse->nodes[k];
		cni_levers_push(&n->levers, n->x, cni_motions(q->world) + n->ia, cni_motions(q->world) + n->ib, q->c->width);
	}
}

void cni_heavy_speeds(const cni_heavy_pass *q, float part, float *out)
{
	int32_t i, k;
	for (i = 0; i < q->count; ++i)
		for (k = 0; k < CNI_HEAVY_LANES; ++k)
			out[cni_heavy_at(i, k)] = k < CNI_HEAVY_ROWS ? part * cni_lever_speed(&q->levers[cni_heavy_at(i, k)], cni_heavy_body(q, i, 0), cni_heavy_body(q, i, 1)) : 0.0f;
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
	int32_t k;
	for (k = q->c->begin; k < q->c->end; ++k) {
		const cni_joint_constraint *w = cni_joint_constraints(q->world) + q->sparse->nodes[k].owner;
		int32_t type = w->record->type, pins = type == CN_JOINT_REVOLUTE || type == CN_JOINT_FIXED;
		most = levers_turn(cni_motions(q->world) + w->ia, w->start.ra, pins, most);
		most = levers_turn(cni_motions(q->world) + w->ib, w->start.rb, pins || type == CN_JOINT_WHEEL, most);
	}
	return most;
}

static void column_find(const cni_heavy_pass *q, int32_t contact, int32_t row)
{
	const cni_direct_contact *p = &q->points[contact];
	float *column = cni_heavy_column(q, contact, row), *own = &column[cni_heavy_at(contact, row)], mass = p->mass[row];
	float least = cni_heavy_is_inner(q, contact) ? 1.0f : INVERSE_MASS_LEAST;
	velocities_clear(q);
	cni_heavy_push(q, contact, row, mass);
	joints_answer(q);
	cni_heavy_speeds(q, 1.0f / mass, column);
	*own = cni_max(*own, least / mass);
	q->g->turn_most = cni_min(q->g->turn_most, CNI_HEAVY_TURN_PART * cni_sqrt(mass * *own));
}

void cni_heavy_response_find(const cni_heavy_pass *q)
{
	int32_t k, active = q->c->active;
	if (active) {
		cni_active_clear(q->sparse, q->c);
		cni_sparse_factor(q->sparse, q->c, cni_motions(q->world));
	}
	q->g->turn_most = FLT_MAX;
	cni_heavy_set_aside(q);
	for (k = 0; k < CNI_HEAVY_ROWS * q->count; ++k)
		if (q->points[k / CNI_HEAVY_ROWS].mass[k % CNI_HEAVY_ROWS] > 0.0f)
			column_find(q, k / CNI_HEAVY_ROWS, k % CNI_HEAVY_ROWS);
	velocities_clear(q);
	cni_heavy_return(q);
	q->g->turn_most += cni_heavy_turn(q);
	if (active)
		cni_direct_system(q->world, q->s, q->sparse, q->c);
}
