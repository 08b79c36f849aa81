/*
 * direct/heavy_contacts.c - contacts of bodies with lighter ones that exact joints hold, solved with the response of the joints.
 *
 * The contact kernel takes the stiffness and the steps of a contact from the masses of its two bodies. A box that falls on a light board of a
 * cantilever sinks by the ratio of their masses: a pass stops as much of it as the board weighs, and the contact yields as if the board
 * were free. Here such a contact has its 3 x 3 inverse effective mass (two normals, friction) with the joints: one solution of their system
 * for each row, once a step. Each pass solves it after the joints and applies its impulses through the joints, which stay closed.
 *
 * In the substeps the joints turn away from that response. A turn by d changes the square root of a row's inverse mass by at most d times
 * that of the free bodies. Rows take this bound, so no step is too long: it approaches those of the kernel where a structure turns fast.
 *
 * The kernel's passes include these lanes. Their loads equal their impulses, so there they do not yield.
 *
 * Reads systems of joints, lanes; writes impulses and loads of lanes, velocities, impulses of joint constraints.
 */
#include "direct/direct_contact.h"
#include "direct/direct_system.h"
#include "model/tuning.h"

#include <string.h>

static float row_speed(const cni_direct_contact *p, int32_t row, const cni_motion *a, const cni_motion *b)
{
	cni_lever l = cni_direct_contact_lever(p, row);
	return cni_lever_speed(&l, a, b);
}

/* ---- the response of the joints ---- */

/* Changes of velocity of the two bodies of a contact; rest stands for all others. */
typedef struct changes {
	int32_t ia, ib;
	cni_motion a, b, rest;
} changes;

static changes changes_begin(const cn_world *world, const cni_contact *c)
{
	const cni_contact_block *block = cni_block_at(world, c->slot / CNI_LANES);
	changes d;
	memset(&d, 0, sizeof d);
	d.ia = block->ia[c->slot % CNI_LANES];
	d.ib = block->ib[c->slot % CNI_LANES];
	d.a.inv_mass = cni_motions(world)[d.ia].inv_mass;
	d.a.inv_inertia = cni_motions(world)[d.ia].inv_inertia;
	d.b.inv_mass = cni_motions(world)[d.ib].inv_mass;
	d.b.inv_inertia = cni_motions(world)[d.ib].inv_inertia;
	return d;
}

static cni_motion *change_of(changes *d, int32_t index)
{
	return index == d->ia ? &d->a : index == d->ib ? &d->b : &d->rest;
}

/* Right sides of the joints against these changes. */
static void sides_set(const cni_sparse *sparse, const cni_component *c, changes *d)
{
	int32_t k;
	for (k = c->begin; k < c->end; ++k) {
		cni_node *n = &sparse->nodes[k];
		const cni_motion *a = change_of(d, n->ia), *b = change_of(d, n->ib);
		if (a == b) /* rest */
			memset(n->x, 0, sizeof n->x);
		else
			cni_four_store(n->x, cni_four_scale(cni_levers_speed(&n->levers, a, b), -1.0f));
	}
}

/* Adds what the joints do to these changes. */
static void response_add(cni_sparse *sparse, const cni_component *c, changes *d)
{
	int32_t k;
	sides_set(sparse, c, d);
	(void)cni_sparse_solve(sparse, c);
	for (k = c->begin; k < c->end; ++k) {
		const cni_node *n = &sparse->nodes[k];
		if (change_of(d, n->ia) != change_of(d, n->ib))
			cni_levers_push(&n->levers, n->x, change_of(d, n->ia), change_of(d, n->ib), CNI_NODE_ROWS);
	}
}

/* Inverse effective mass of a row if the lighter body were fixed. */
static float heavier_inverse_mass(const cni_direct_contact *p, int32_t row, const changes *d)
{
	cni_lever l = cni_direct_contact_lever(p, row);
	return d->a.inv_mass < d->b.inv_mass ? cni_lever_inverse_mass(&l, &d->a, &d->rest) : cni_lever_inverse_mass(&l, &d->rest, &d->b);
}

static void response_find(const cn_world *world, cni_sparse *sparse, const cni_contact *c, const cni_direct_contact *p, cni_heavy_contact *h)
{
	int32_t row, k;
	for (row = 0; row < 3; ++row) {
		changes d = changes_begin(world, c);
		cni_direct_contact_push(p, row, p->mass[row], &d.a, &d.b);
		response_add(sparse, &sparse->components[h->component], &d);
		for (k = 0; k < 3; ++k)
			h->k[k][row] = p->mass[row] > 0.0f ? row_speed(p, k, &d.a, &d.b) / p->mass[row] : 0.0f;
		h->k[row][row] = cni_max(h->k[row][row], heavier_inverse_mass(p, row, &d));
	}
}

/* ---- which contacts ---- */

/* 1: it bears little, and if it bears nothing, its points will not meet in this step. */
static int32_t is_idle(const cn_world *world, const cni_solve *s, const cni_direct_contact *p, const cni_motion *a, const cni_motion *b)
{
	float speed = CNI_HEAVY_CONTACT_STRESS * cni_length(world->settings.gravity) * s->h;
	int32_t k;
	for (k = 0; k < 2; ++k) {
		if (p->j[k] > speed * p->mass[k])
			return 0;
		if (p->mass[k] > 0.0f && p->j[k] <= 0.0f && cni_direct_contact_separation(p, k, a, b) + s->dt * row_speed(p, k, a, b) < world->settings.slop)
			return 0;
	}
	return 1;
}

static void contact_take(const cn_world *world, const cni_solve *s, cni_sparse *sparse, int32_t component, const cni_contact *c)
{
	cni_heavy_contact *h = &sparse->heavies[sparse->heavy_count];
	const cni_contact_block *block = cni_block_at(world, c->slot / CNI_LANES);
	int32_t l = c->slot % CNI_LANES;
	cni_direct_contact p;
	cni_direct_contact_read(world, c, &p);
	if (is_idle(world, s, &p, cni_motions(world) + block->ia[l], cni_motions(world) + block->ib[l]))
		return;
	h->component = component;
	h->contact = cni_block_info_at(world, p.block)->contact[l];
	response_find(world, sparse, c, &p, h);
	++sparse->heavy_count;
}

static void body_contacts_take(const cn_world *world, const cni_solve *s, cni_sparse *sparse, int32_t component, int32_t index)
{
	const cni_body *b = cni_body_at(world, cni_awake_ids(world)[index]);
	int32_t key, left = b->lanes;
	for (key = b->contact_first; left > 0 && sparse->heavy_count < CNI_HEAVY_CONTACTS_MOST; key = cni_contact_of_key(world, key)->next[key & 1]) {
		const cni_contact *c = cni_contact_of_key(world, key);
		const cni_motion *other = cni_motions(world) + cni_body_at(world, c->body[1 - (key & 1)])->awake;
		if (!cni_contact_has_lane(c))
			continue;
		--left;
		if (other->inv_mass > 0.0f && other->inv_mass < cni_motions(world)[index].inv_mass && cni_direct_lane_is_plain(world, c))
			contact_take(world, s, sparse, component, c);
	}
}

/* Motors and limits may leave the set: the response is without them, or the impulse of a contact would be too large then. */
void cni_heavy_contacts_find(cn_world *world, const cni_solve *s, cni_sparse *sparse)
{
	int32_t k, n;
	for (k = 0; k < sparse->projection_count; ++k) {
		cni_component *c = &sparse->components[sparse->projections[k].component];
		if (c->batches)
			continue;
		if (c->active) {
			cni_active_clear(world, sparse, c);
			cni_sparse_factor(sparse, c, cni_motions(world));
		}
		for (n = c->body_begin; n < c->body_end; ++n)
			body_contacts_take(world, s, sparse, sparse->projections[k].component, sparse->bodies[n]);
		if (c->active)
			cni_direct_system(world, s, sparse, c);
	}
}

/* ---- a pass ---- */

/* The farthest turn of the component's bodies in this step. */
static float turn_of(const cn_world *world, const cni_sparse *sparse, const cni_component *c)
{
	float most = 0.0f;
	int32_t k;
	for (k = c->body_begin; k < c->body_end; ++k)
		most = cni_max(most, cni_abs(cni_motions(world)[sparse->bodies[k]].theta));
	return most;
}

/* Target of a normal impulse: a pass as in contacts/contact_kernel.h, without load and hardening, with the mass m. */
static float normal_target(const cni_solve *s, const cni_direct_contact *p, int32_t row, float m, float speed, float separation, int32_t bias)
{
	const cni_contact_pass *pass = &s->contact[0];
	float soft = pass->soft.mass_scale, push = cni_max(pass->soft.bias_scale * separation, -s->push_speed * soft);
	if (separation > 0.0f && !bias && speed < pass->impact_speed && p->j[row] <= 0.0f)
		return 0.0f;
	if (separation <= 0.0f && bias)
		return cni_max(soft * p->j[row] - m * (soft * speed + push), 0.0f);
	return cni_max(p->j[row] - m * (speed + cni_max(separation * s->inv_h, 0.0f)), 0.0f);
}

static float friction_target(const cni_direct_contact *p, float m, float speed)
{
	float target = p->j[2] - m * speed, normal = p->j[0] + p->j[1], slide = p->dynamic_friction * normal;
	return cni_abs(target) <= p->static_friction * normal ? target : cni_clamp(target, -slide, slide);
}

/* Inverse mass of a row: what its response may have become with this turn. */
static float row_inverse_mass(const cni_heavy_contact *h, const cni_direct_contact *p, int32_t row, float turn)
{
	float root = cni_sqrt(h->k[row][row]) + turn / cni_sqrt(p->mass[row]);
	return root * root;
}

static void rows_solve(const cni_solve *s, const cni_heavy_contact *h, cni_direct_contact *p, const cni_motion *a, const cni_motion *b, float turn, int32_t bias)
{
	float u[3];
	int32_t round, row, k;
	for (k = 0; k < 3; ++k)
		u[k] = row_speed(p, k, a, b);
	for (round = 0; round < CNI_HEAVY_CONTACT_ROUNDS; ++round)
		for (row = 0; row < 3; ++row) {
			float own, target;
			if (p->mass[row] <= 0.0f)
				continue;
			own = row_inverse_mass(h, p, row, turn);
			if (row < 2)
				target = normal_target(s, p, row, 1.0f / own, u[row], cni_direct_contact_separation(p, row, a, b), bias);
			else
				target = friction_target(p, 1.0f / own, u[row]);
			for (k = 0; k < 3; ++k)
				u[k] += (k == row ? own : h->k[k][row]) * (target - p->j[row]);
			p->j[row] = target;
		}
}

static void impulses_apply(cn_world *world, const cni_solve *s, cni_component *c, const cni_direct_contact *p, changes *d)
{
	cni_motion *motions = cni_motions(world);
	int32_t row;
	for (row = 0; row < 3; ++row) {
		cni_direct_contact_push(p, row, p->j[row] - p->first[row], &d->a, &d->b);
		cni_direct_contact_push(p, row, p->j[row] - p->first[row], motions + d->ia, motions + d->ib);
	}
	sides_set(s->direct, c, d);
	if (!cni_direct_apply(world, s->direct, c))
		cni_component_suspend(world, s->direct, c, 0);
	else if (c->active)
		cni_active_impulses_add(world, s->direct, c);
}

static void contact_solve(cn_world *world, const cni_solve *s, const cni_heavy_contact *h, int32_t bias)
{
	cni_component *c = &s->direct->components[h->component];
	const cni_contact *contact = cni_contact_at(world, h->contact);
	cni_contact_block *block = cni_block_at(world, contact->slot / CNI_LANES);
	changes d = changes_begin(world, contact);
	int32_t l = contact->slot % CNI_LANES, k;
	cni_direct_contact p;
	if (c->done)
		return;
	cni_direct_contact_read(world, contact, &p);
	rows_solve(s, h, &p, cni_motions(world) + d.ia, cni_motions(world) + d.ib, turn_of(world, s->direct, c), bias);
	if (p.j[0] != p.first[0] || p.j[1] != p.first[1] || p.j[2] != p.first[2])
		impulses_apply(world, s, c, &p, &d);
	block->jt[l] = p.j[2];
	for (k = 0; k < 2; ++k)
		block->p[k].jn[l] = block->p[k].load[l] = p.j[k];
}

void cni_heavy_contacts_solve(cn_world *world, const cni_solve *s, int32_t bias)
{
	int32_t k;
	for (k = 0; k < s->direct->heavy_count; ++k)
		contact_solve(world, s, &s->direct->heavies[k], bias);
}
