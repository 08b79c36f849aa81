/*
 * direct/heavy_contacts.c - contacts of heavy bodies on light ones that exact joints hold, solved with the response of the joints.
 *
 * The contact kernel takes a contact's stiffness and its steps from the masses of its two bodies. A box of a ton that falls on a board of a
 * cantilever sinks by the ratio of their masses: each pass stops a thousandth of it, and the contact yields as if the board bore itself
 * alone. Such a contact has its 3 x 3 inverse effective mass (two normals, friction) with the joints: one solution of their system a row,
 * once a step. Each pass then solves it after the joints, and its impulses go through the joints at once, so velocities stay exact.
 *
 * The levers turn after that solution. A turn by d adds at most d of the free bodies' response, as speeds: rows take the square of the sum
 * of both roots, so that a fast structure approaches the steps of the kernel and no step is too long.
 *
 * The kernel passes still visit these lanes. Their loads equal their impulses, so that the kernel does not let them yield.
 *
 * Reads joints' systems, lanes; writes lanes' impulses and loads, motion velocities, impulses of joint constraints.
 */
#include "direct/direct_contact.h"
#include "direct/direct_system.h"
#include "model/tuning.h"

#define ROUNDS 4 /* between the rows of a contact */

/* ---- which contacts ---- */

static int32_t is_heavy_on(const cni_motion *light, const cni_motion *heavy)
{
	return heavy->inv_mass > 0.0f && light->inv_mass > CNI_SELECTION_MASS_RATIO * heavy->inv_mass;
}

static void body_contacts_find(const cn_world *world, cni_sparse *sparse, int32_t component, int32_t index)
{
	const cni_body *b = cni_body_at(world, cni_awake_ids(world)[index]);
	int32_t key, left = b->lanes;
	for (key = b->contact_first; left > 0; key = cni_contact_of_key(world, key)->next[key & 1]) {
		const cni_contact *c = cni_contact_of_key(world, key);
		cni_heavy_contact *h = &sparse->heavies[sparse->heavy_count];
		if (!(c->flags & CNI_CONTACT_TOUCHING) || c->slot == CNI_NONE)
			continue;
		--left;
		if (sparse->heavy_count == CNI_HEAVY_CONTACTS_MOST || !cni_direct_lane_is_plain(world, c) ||
			!is_heavy_on(cni_motions(world) + index, cni_motions(world) + cni_body_at(world, c->body[1 - (key & 1)])->awake))
			continue;
		h->component = component;
		h->contact = cni_block_info_at(world, c->slot / CNI_LANES)->contact[c->slot % CNI_LANES];
		++sparse->heavy_count;
	}
}

/* ---- the response of the joints ---- */

/* Right sides that take out what an impulse on bodies of the component changes: before it (0), after it (1). */
static void sides_take(const cn_world *world, cni_sparse *sparse, const cni_component *c, int32_t after)
{
	const cni_motion *motions = cni_motions(world);
	int32_t k;
	for (k = c->begin; k < c->end; ++k) {
		cni_node *n = &sparse->nodes[k];
		cni_four speed = cni_levers_speed(&n->levers, motions + n->ia, motions + n->ib);
		cni_four_store(n->x, after ? cni_four_subtract(cni_four_load(n->x), speed) : speed);
	}
}

static void velocities_push(const cn_world *world, const cni_sparse *sparse, const cni_component *c)
{
	int32_t k;
	for (k = c->begin; k < c->end; ++k) {
		const cni_node *n = &sparse->nodes[k];
		cni_levers_push(&n->levers, n->x, cni_motions(world) + n->ia, cni_motions(world) + n->ib, CNI_NODE_ROWS);
	}
}

static float row_speed(const cni_direct_contact *p, int32_t row, const cni_motion *a, const cni_motion *b)
{
	cni_lever l = cni_direct_contact_lever(p, row);
	return cni_lever_speed(&l, a, b);
}

/* Column `row` of the inverse effective mass. Leaves velocities changed. */
static void column_find(const cn_world *world, cni_sparse *sparse, const cni_component *c, const cni_direct_contact *p, int32_t row, cni_heavy_contact *h, cni_motion *a, cni_motion *b)
{
	float before[3];
	int32_t k;
	for (k = 0; k < 3; ++k)
		before[k] = row_speed(p, k, a, b);
	sides_take(world, sparse, c, 0);
	cni_direct_contact_push(p, row, p->mass[row], a, b);
	sides_take(world, sparse, c, 1);
	(void)cni_sparse_solve(sparse, c);
	velocities_push(world, sparse, c);
	for (k = 0; k < 3; ++k)
		h->k[k][row] = p->mass[row] > 0.0f ? (row_speed(p, k, a, b) - before[k]) / p->mass[row] : 0.0f;
}

static void response_find(cn_world *world, cni_sparse *sparse, cni_heavy_contact *h)
{
	const cni_component *c = &sparse->components[h->component];
	const cni_contact *contact = cni_contact_at(world, h->contact);
	const cni_contact_block *block = cni_block_at(world, contact->slot / CNI_LANES);
	cni_motion *a = cni_motions(world) + block->ia[contact->slot % CNI_LANES], *b = cni_motions(world) + block->ib[contact->slot % CNI_LANES];
	cni_motion a_old = *a, b_old = *b;
	cni_direct_contact p;
	int32_t k;
	cni_direct_contact_read(world, contact, &p);
	cni_direct_motions_save(world, sparse, c, 0);
	for (k = 0; k < 3; ++k) {
		column_find(world, sparse, c, &p, k, h, a, b);
		cni_direct_motions_save(world, sparse, c, 1);
		*a = a_old;
		*b = b_old;
	}
}

void cni_heavy_contacts_find(cn_world *world, cni_sparse *sparse)
{
	int32_t k, n;
	for (k = 0; k < sparse->projection_count; ++k) {
		const cni_component *c = &sparse->components[sparse->projections[k].component];
		if (c->done || c->batches || c->active)
			continue;
		for (n = c->body_begin; n < c->body_end; ++n)
			body_contacts_find(world, sparse, sparse->projections[k].component, sparse->bodies[n]);
	}
	for (k = 0; k < sparse->heavy_count; ++k)
		response_find(world, sparse, &sparse->heavies[k]);
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

static float row_mass(const cni_heavy_contact *h, const cni_direct_contact *p, int32_t row, float turn)
{
	float root = cni_sqrt(cni_max(h->k[row][row], 0.0f)) + cni_max(turn, 1e-2f) / cni_sqrt(p->mass[row]);
	return 1.0f / (root * root);
}

/* The soft pass or the rigid one, as in contacts/contact_kernel.h. */
static float normal_target(const cni_solve *s, const cni_direct_contact *p, int32_t row, float m, float speed, float separation, int32_t bias)
{
	const cni_contact_pass *pass = &s->contact[0];
	float push = separation * s->inv_h;
	if (!bias && separation > 0.0f && speed < pass->impact_speed && p->j[row] <= 0.0f)
		return p->j[row];
	if (separation > 0.0f || !bias)
		return p->j[row] - m * (speed + cni_max(push, 0.0f));
	push = cni_max(pass->soft.bias_scale * separation, -s->push_speed * pass->soft.mass_scale);
	return pass->soft.mass_scale * p->j[row] - m * (pass->soft.mass_scale * speed + push);
}

static float friction_target(const cni_direct_contact *p, float m, float speed)
{
	float target = p->j[2] - m * speed, normal = p->j[0] + p->j[1], slide = p->dynamic_friction * normal;
	return cni_abs(target) <= p->static_friction * normal ? target : cni_clamp(target, -slide, slide);
}

/* Impulses of its rows from their speeds u. */
static void rows_solve(const cni_solve *s, const cni_heavy_contact *h, cni_direct_contact *p, const cni_motion *a, const cni_motion *b, float turn, int32_t bias)
{
	float u[3], separation[2];
	int32_t round, row, k;
	for (k = 0; k < 3; ++k)
		u[k] = row_speed(p, k, a, b);
	for (k = 0; k < 2; ++k)
		separation[k] = cni_direct_contact_separation(p, k, a, b);
	for (round = 0; round < ROUNDS; ++round)
		for (row = 0; row < 3; ++row) {
			float m, target;
			if (p->mass[row] <= 0.0f)
				continue;
			m = row_mass(h, p, row, turn);
			target = row < 2 ? cni_max(normal_target(s, p, row, m, u[row], separation[row], bias), 0.0f) : friction_target(p, m, u[row]);
			for (k = 0; k < 3; ++k)
				u[k] += h->k[k][row] * (target - p->j[row]);
			p->j[row] = target;
		}
}

static void contact_solve(cn_world *world, const cni_solve *s, const cni_heavy_contact *h, int32_t bias)
{
	cni_component *c = &s->direct->components[h->component];
	const cni_contact *contact = cni_contact_at(world, h->contact);
	int32_t l = contact->slot % CNI_LANES, k;
	cni_contact_block *block = cni_block_at(world, contact->slot / CNI_LANES);
	cni_motion *a = cni_motions(world) + block->ia[l], *b = cni_motions(world) + block->ib[l];
	cni_direct_contact p;
	if (c->done)
		return;
	cni_direct_contact_read(world, contact, &p);
	rows_solve(s, h, &p, a, b, turn_of(world, s->direct, c), bias);
	sides_take(world, s->direct, c, 0);
	for (k = 0; k < 3; ++k)
		cni_direct_contact_push(&p, k, p.j[k] - p.first[k], a, b);
	sides_take(world, s->direct, c, 1);
	if (!cni_direct_apply(world, s->direct, c))
		cni_component_suspend(world, s->direct, c, 0);
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
