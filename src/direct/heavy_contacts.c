/*
 * direct/heavy_contacts.c - contacts with lighter bodies that exact joints hold, solved with the response of the joints.
 *
 * The contact kernel takes the stiffness and the steps of a contact from the masses of its two bodies. A box that falls on a light board of a
 * cantilever sinks by the ratio of their masses: a pass stops as much of it as the board weighs, and the contact yields as if the board
 * were free. Here such a contact has its 3 x 3 inverse effective mass (two normals, friction) with the joints: one solution of their system
 * for each row, once a step. Each pass solves it after the joints and applies its impulses through the joints, which stay closed.
 *
 * No step may be too long, or the impulses grow from pass to pass. The response is therefore found without motors and limits, which may
 * leave the active set. Two bodies of one component have at most the mass of free ones: beside their hinge it would be any. In the substeps
 * the joints turn away from the response: a turn by d changes the square root of a row's inverse mass by at most d times that of the free
 * bodies. Where that may be a large part, the response is found again.
 *
 * The kernel's passes include these lanes. Their loads equal their impulses, so there they do not yield. Rolling resistance is the kernel's.
 *
 * The impacts of contacts/restitution.c are those of free bodies: the joints would stop the board that was hit, and with it the bounce. These
 * contacts bounce once, after the substeps, to the speed of Newton's law, and against the response of the joints. Until then they are
 * inelastic.
 *
 * Reads systems of joints, lanes; writes impulses and loads of lanes, velocities, impulses of joint constraints.
 */
#include "contacts/contacts.h"
#include "direct/direct_contact.h"
#include "direct/direct_system.h"

#include <string.h>

#define INVERSE_MASS_LEAST 1e-4f /* of a row, as a part of that of the free bodies: less is rounding */

/* ---- the response of the joints ---- */

/* A contact as it is in its lane, and changes of velocity of its two bodies; rest stands for all others. */
typedef struct changes {
	cni_direct_contact p;
	cni_contact_block *block;
	cni_motion a, b, rest;
} changes;

static cni_motion at_rest(const cni_motion *m)
{
	cni_motion still = *m;
	still.vx = still.vy = still.w = 0.0f;
	return still;
}

static void changes_clear(const cn_world *world, changes *d)
{
	d->a = at_rest(cni_motions(world) + d->p.ia);
	d->b = at_rest(cni_motions(world) + d->p.ib);
	memset(&d->rest, 0, sizeof d->rest);
}

static changes changes_begin(const cn_world *world, int32_t contact)
{
	changes d;
	cni_direct_contact_read(world, cni_contact_at(world, contact), &d.p);
	d.block = cni_block_at(world, d.p.block);
	changes_clear(world, &d);
	return d;
}

static cni_motion *change_of(changes *d, int32_t index)
{
	return index == d->p.ia ? &d->a : index == d->p.ib ? &d->b : &d->rest;
}

static int32_t is_at(const changes *d, const cni_node *n)
{
	return n->ia == d->p.ia || n->ia == d->p.ib || n->ib == d->p.ia || n->ib == d->p.ib;
}

/* Right sides of the joints against these changes. */
static void sides_set(const cni_sparse *sparse, const cni_component *c, changes *d)
{
	int32_t k;
	for (k = c->begin; k < c->end; ++k) {
		cni_node *n = &sparse->nodes[k];
		if (!is_at(d, n))
			cni_four_store(n->x, cni_four_all(-0.0f));
		else
			cni_four_store(n->x, cni_four_scale(cni_levers_speed(&n->levers, change_of(d, n->ia), change_of(d, n->ib)), -1.0f));
	}
}

/* Adds what the joints do to these changes; nothing where they have no finite solution. */
static void response_add(cni_sparse *sparse, const cni_component *c, changes *d)
{
	int32_t k;
	sides_set(sparse, c, d);
	if (!cni_sparse_solve(sparse, c))
		return;
	for (k = c->begin; k < c->end; ++k) {
		const cni_node *n = &sparse->nodes[k];
		if (is_at(d, n))
			cni_levers_push(&n->levers, n->x, change_of(d, n->ia), change_of(d, n->ib), CNI_NODE_ROWS);
	}
}

/* The farthest turn of the component's bodies in this step. */
static float turn_of(const cn_world *world, const cni_sparse *sparse, const cni_component *c)
{
	float most = 0.0f;
	int32_t k;
	for (k = c->body_begin; k < c->body_end; ++k)
		most = cni_max(most, cni_abs(cni_motions(world)[sparse->bodies[k]].theta));
	return most;
}

/* A contact that is pressed harder than impulse_most is pressed by what cannot give way, and its impulse would grow from pass to pass:
   beyond, the kernel alone raises it, as if the joints were not there. */
static void response_find(const cn_world *world, cni_sparse *sparse, cni_heavy_contact *h, float component_mass)
{
	changes d = changes_begin(world, h->contact);
	const cni_direct_contact *p = &d.p;
	float least = sparse->projection_of[d.p.ia] == sparse->projection_of[d.p.ib] ? 1.0f : INVERSE_MASS_LEAST;
	int32_t row, k;
	h->turn_most = FLT_MAX;
	h->impulse_most = CNI_HEAVY_SPEED_MOST * world->settings.push_speed_max *
		(component_mass + cni_inverse_or_zero(d.a.inv_mass) + cni_inverse_or_zero(d.b.inv_mass));
	for (row = 0; row < 3; ++row) {
		if (p->mass[row] <= 0.0f)
			continue;
		changes_clear(world, &d);
		cni_direct_contact_push(p, row, p->mass[row], &d.a, &d.b);
		response_add(sparse, &sparse->components[h->component], &d);
		for (k = 0; k < 3; ++k)
			h->k[k][row] = cni_direct_contact_speed(p, k, &d.a, &d.b) / p->mass[row];
		h->k[row][row] = cni_max(h->k[row][row], least / p->mass[row]);
		h->turn_most = cni_min(h->turn_most, CNI_HEAVY_TURN_PART * cni_sqrt(p->mass[row] * h->k[row][row]));
	}
	h->turn_most += turn_of(world, sparse, &sparse->components[h->component]);
}

/* Of the contacts begin to end - 1, which are those of one component. */
static void responses_find(cn_world *world, const cni_solve *s, cni_sparse *sparse, int32_t begin, int32_t end)
{
	cni_component *c = &sparse->components[sparse->heavies[begin].component];
	float mass = 0.0f;
	int32_t k;
	if (c->active) {
		cni_active_clear(sparse, c);
		cni_sparse_factor(sparse, c, cni_motions(world));
	}
	for (k = c->body_begin; k < c->body_end; ++k)
		mass += cni_inverse_or_zero(cni_motions(world)[sparse->bodies[k]].inv_mass);
	for (k = begin; k < end; ++k)
		response_find(world, sparse, &sparse->heavies[k], mass);
	if (c->active)
		cni_direct_system(world, s, sparse, c);
}

/* ---- which contacts ---- */

/* Newton's law with the speed at which the point meets, as in contacts/restitution.c; 0: it does not meet in this step as fast as bounces do. */
static float bounce_speed(const cn_world *world, const cni_solve *s, int32_t point, const changes *d, float restitution)
{
	const cni_direct_contact *p = &d->p;
	const cni_motion *a = cni_motions(world) + d->p.ia, *b = cni_motions(world) + d->p.ib;
	const cni_external *ea = cni_externals(world) + d->p.ia, *eb = cni_externals(world) + d->p.ib;
	float gap = cni_direct_contact_separation(p, point, a, b), speed = cni_direct_contact_speed(p, point, a, b);
	float closing = p->nx * (ea->ax - eb->ax) + p->ny * (ea->ay - eb->ay); /* acceleration */
	if (p->mass[point] <= 0.0f || speed >= -s->restitution_threshold || -speed * p->mass[point] <= p->j[point] || gap + s->dt * speed >= world->settings.slop)
		return 0.0f;
	return restitution * cni_sqrt(cni_max(speed * speed + 2.0f * closing * gap, 0.0f));
}

static float *lane_restitution(const cn_world *world, int32_t contact)
{
	int32_t slot = cni_contact_at(world, contact)->slot;
	return &cni_block_info_at(world, slot / CNI_LANES)->restitution[slot % CNI_LANES];
}

static cni_heavy_contact heavy_make(const cn_world *world, const cni_solve *s, int32_t component, int32_t contact)
{
	cni_heavy_contact h;
	memset(&h, 0, sizeof h);
	h.component = component;
	h.contact = contact;
	h.tangent_speed = cni_direct_lane_tangent_speed(world, cni_contact_at(world, contact));
	h.restitution = *lane_restitution(world, contact);
	if (h.restitution > 0.0f) {
		changes d = changes_begin(world, contact);
		h.bounce[0] = bounce_speed(world, s, 0, &d, h.restitution);
		h.bounce[1] = bounce_speed(world, s, 1, &d, h.restitution);
	}
	return h;
}

static int32_t bounces(const cni_heavy_contact *h) { return h->bounce[0] + h->bounce[1] > 0.0f; }

/* Do the joints bear an impact with it? */
static int32_t is_borne(const cn_world *world, const cni_heavy_contact *h)
{
	changes d = changes_begin(world, h->contact);
	int32_t k;
	for (k = 0; k < 2; ++k)
		if (d.p.mass[k] > 0.0f && d.p.mass[k] * h->k[k][k] < CNI_HEAVY_BOUNCE_PART)
			return 1;
	return 0;
}

/* 1: it bears more than a few weights, or it bears nothing and its points may meet in this step. With a static body only extreme loads count,
   as those of a rope that carries 2,000 links over a peg, and impacts: the heavy end of a lever follows when its light arm hits the ground.
   Of a slow component all contacts count alike: it is to come to rest. */
static int32_t is_pressed(const cn_world *world, const cni_solve *s, int32_t contact, int32_t fixed, int32_t slow)
{
	float stress = slow ? CNI_HEAVY_SLOW_STRESS : fixed ? CNI_HEAVY_STATIC_STRESS : CNI_HEAVY_CONTACT_STRESS;
	float speed = stress * cni_length(world->settings.gravity) * s->h;
	int32_t k, slot = cni_contact_at(world, contact)->slot, l = slot % CNI_LANES, idle = 0;
	const cni_contact_block *block = cni_block_at(world, slot / CNI_LANES);
	const cni_contact_row *rows = block->p;
	const cni_motion *a = cni_motions(world) + block->ia[l], *b = cni_motions(world) + block->ib[l];
	cni_direct_contact p;
	for (k = 0; k < 2; ++k) {
		if (rows[k].jn[l] > speed * rows[k].nm[l])
			return 1;
		idle |= (rows[k].nm[l] > 0.0f && !(rows[k].jn[l] > 0.0f)) << k;
	}
	if (idle == 0)
		return 0;
	cni_direct_contact_read(world, cni_contact_at(world, contact), &p);
	for (k = 0; k < 2; ++k) {
		float closing = cni_direct_contact_speed(&p, k, a, b);
		if (!(idle >> k & 1) || !(!fixed || slow || closing < s->contact[0].impact_speed))
			continue;
		if (cni_direct_contact_separation(&p, k, a, b) + s->dt * closing < world->settings.slop)
			return 1;
	}
	return 0;
}

/* 1: the component could be in a batch with others of its class that have no contacts that are solved here. */
static int32_t is_batchable(const cni_sparse *sparse, const cni_component *c)
{
	int32_t k;
	for (k = 0; k < sparse->component_count && c->kind != CNI_NONE; ++k)
		if (sparse->components[k].kind == c->kind && !sparse->components[k].snaps && &sparse->components[k] != c)
			return 1;
	return 0;
}

static void body_contacts_list(const cn_world *world, const cni_solve *s, cni_sparse *sparse, int32_t component, int32_t index, float ratio, int32_t most, int32_t slow)
{
	const cni_body *b = cni_body_at(world, cni_awake_ids(world)[index]);
	int32_t key, left = b->lanes;
	for (key = b->contact_first; left > 0 && sparse->heavy_count < most; key = cni_contact_of_key(world, key)->next[key & 1]) {
		const cni_contact *c = cni_contact_of_key(world, key);
		const cni_body *other = cni_body_at(world, c->body[1 - (key & 1)]);
		float inv_mass = cni_motions(world)[other->awake].inv_mass;
		int32_t light = ratio * inv_mass >= cni_motions(world)[index].inv_mass;
		cni_heavy_contact h;
		if (!cni_contact_has_lane(c))
			continue;
		--left;
		if ((light && *lane_restitution(world, key >> 1) <= 0.0f) || cni_direct_lane_is_locked(world, c))
			continue;
		/* A jointed body that is not heavier is in a component that could list the contact itself. */
		if (light ? (cni_externals(world)[other->awake].flags & CNI_EXTERNAL_JOINTED) != 0 : !is_pressed(world, s, key >> 1, inv_mass == 0.0f, slow))
			continue;
		h = heavy_make(world, s, component, key >> 1);
		h.is_light = (uint8_t)light;
		if (!light || bounces(&h))
			sparse->heavies[sparse->heavy_count++] = h;
	}
}

static int32_t blocks_of(const cni_sparse *sparse, const cni_component *c)
{
	return sparse->first[c->end] - sparse->first[c->begin] + c->end - c->begin;
}

int32_t cni_heavy_contacts_most(const cni_sparse *sparse, const cni_component *c)
{
	return CNI_HEAVY_CONTACT_BLOCKS / cni_max_i(blocks_of(sparse, c), 1);
}

/* 1: one of its joints may break. It bears at most its threshold, which is known after the step only: a ball would bounce off a wall of
   bricks that it should break. */
static int32_t may_break(const cn_world *world, const cni_sparse *sparse, const cni_component *c)
{
	int32_t k;
	for (k = c->begin; k < c->end; ++k)
		if (cni_joint_constraints(world)[sparse->nodes[k].owner].flags & CNI_CONSTRAINT_BREAKABLE)
			return 1;
	return 0;
}

/* 1: no body of the component is faster than CNI_HEAVY_SLOW_SPEED, and it has few blocks or could be in no batch. */
static int32_t is_slow(const cn_world *world, const cni_sparse *sparse, const cni_component *c, int32_t batchable)
{
	float most = CNI_HEAVY_SLOW_SPEED * world->settings.length_unit;
	int32_t k, island = cni_awake_island(world, sparse->bodies[c->body_begin]);
	cni_vec2 frame = { 0.0f, 0.0f };
	if (batchable && blocks_of(sparse, c) > CNI_HEAVY_SLOW_BLOCKS)
		return 0;
	if (island != CNI_NONE)
		frame = cni_island_frame(world, cni_island_at(world, island));
	for (k = c->body_begin; k < c->body_end; ++k) {
		const cni_motion *m = cni_motions(world) + sparse->bodies[k];
		if (cni_sq(m->vx - frame.x) + cni_sq(m->vy - frame.y) > most * most)
			return 0;
	}
	return 1;
}

int32_t cni_heavy_contacts_list(const cn_world *world, const cni_solve *s, cni_sparse *sparse, int32_t component)
{
	const cni_component *c = &sparse->components[component];
	int32_t k, first = sparse->heavy_count, most, slow, batchable;
	float ratio;
	if (!CNI_ON(HEAVY_CONTACTS) || !CNI_ON(JOINT_PROJECTION) || c->mass_ratio > CNI_ILL_MASS_RATIO)
		return 0;
	if (c->has_contacts || c->touched == 0 || may_break(world, sparse, c))
		return 0;
	batchable = is_batchable(sparse, c);
	ratio = batchable ? CNI_SELECTION_MASS_RATIO : 1.0f; /* else only bodies that may crush its own: ragdolls would take 4 times as long as soft ones instead of 2.1 times */
	slow = is_slow(world, sparse, c, batchable);
	most = cni_min_i(first + cni_heavy_contacts_most(sparse, c), CNI_HEAVY_CONTACTS_MOST);
	for (k = c->body_begin; k < c->body_end; ++k)
		if (cni_externals(world)[sparse->bodies[k]].flags & CNI_EXTERNAL_TOUCHED)
			body_contacts_list(world, s, sparse, component, sparse->bodies[k], ratio, most, slow);
	return sparse->heavy_count > first;
}

/* ---- components ---- */

/* Index behind the contacts that are of the same component as contact begin. */
static int32_t end_of(const cni_sparse *sparse, int32_t begin)
{
	int32_t end = begin + 1;
	while (end < sparse->heavy_count && sparse->heavies[end].component == sparse->heavies[begin].component)
		++end;
	return end;
}

void cni_heavy_contacts_find(cn_world *world, const cni_solve *s, cni_sparse *sparse)
{
	int32_t begin, end, k, listed = sparse->heavy_count;
	for (begin = 0; begin < listed; begin = end) {
		cni_component *c = &sparse->components[sparse->heavies[begin].component];
		end = end_of(sparse, begin);
		if (c->batches)
			cni_tree_lane_system(s, c);
		responses_find(world, s, sparse, begin, end);
	}
	sparse->heavy_count = 0;
	for (k = 0; k < listed; ++k) {
		cni_heavy_contact *h = &sparse->heavies[k];
		if (h->is_light && !is_borne(world, h))
			continue;
		*lane_restitution(world, h->contact) = 0.0f;
		sparse->heavies[sparse->heavy_count++] = *h;
	}
}

/* ---- a pass ---- */

/* Passes of a substep are numbered by their bias. */
enum { PASS_BOUNCE = 2 };

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
	float target = p->j[2] - m * speed, normal = p->j[0] + p->j[1], stick = p->static_friction * normal;
	float most = cni_abs(target) <= CNI_STICK_MARGIN * stick ? stick : p->dynamic_friction * normal;
	return cni_clamp(target, -most, most);
}

static float row_target(const cn_world *world, const cni_solve *s, const cni_heavy_contact *h, const cni_direct_contact *p, int32_t row, float speed, float separation, int32_t pass)
{
	float m = 1.0f / h->k[row][row];
	if (row == 2)
		return pass == PASS_BOUNCE ? p->j[2] : friction_target(p, m, speed - h->tangent_speed);
	if (pass == PASS_BOUNCE) /* what touches reaches its speed after the impact */
		return separation > world->settings.slop ? p->j[row] : cni_max(p->j[row] + (h->bounce[row] - speed) / h->k[row][row], 0.0f);
	return cni_min(cni_max(h->impulse_most, p->j[row]), normal_target(s, p, row, m, speed, separation, pass));
}

static void rows_solve(const cn_world *world, const cni_solve *s, const cni_heavy_contact *h, changes *d, int32_t pass)
{
	cni_direct_contact *p = &d->p;
	const cni_motion *a = cni_motions(world) + p->ia, *b = cni_motions(world) + p->ib;
	float u[3], separation[3] = { cni_direct_contact_separation(p, 0, a, b), cni_direct_contact_separation(p, 1, a, b), 0.0f };
	int32_t round, row, k;
	for (k = 0; k < 3; ++k)
		u[k] = cni_direct_contact_speed(p, k, a, b);
	for (round = 0; round < CNI_HEAVY_CONTACT_ROUNDS; ++round)
		for (row = 0; row < 3; ++row) {
			float target;
			if (p->mass[row] <= 0.0f)
				continue;
			target = row_target(world, s, h, p, row, u[row], separation[row], pass);
			for (k = 0; k < 3; ++k)
				u[k] += h->k[k][row] * (target - p->j[row]);
			p->j[row] = target;
		}
}

/* 1: the change of impulse is more than rounding: a contact at rest costs no solution of the joints. */
static int32_t changes_speed(const cn_world *world, const cni_heavy_contact *h, const cni_direct_contact *p)
{
	float least = CNI_DIRECT_SPEED_LEAST * world->settings.length_unit;
	int32_t k;
	for (k = 0; k < 3; ++k)
		if (p->mass[k] > 0.0f && !(cni_abs(p->j[k] - p->first[k]) * h->k[k][k] <= least))
			return 1;
	return 0;
}

static void impulses_apply(cn_world *world, const cni_solve *s, cni_component *c, changes *d)
{
	const cni_direct_contact *p = &d->p;
	cni_motion *motions = cni_motions(world);
	int32_t row;
	for (row = 0; row < 3; ++row) {
		cni_direct_contact_push(p, row, p->j[row] - p->first[row], &d->a, &d->b);
		cni_direct_contact_push(p, row, p->j[row] - p->first[row], motions + d->p.ia, motions + d->p.ib);
	}
	sides_set(s->direct, c, d);
	if (!cni_direct_apply(world, s->direct, c))
		cni_component_suspend(world, s->direct, c, 0);
	else if (c->batches)
		cni_tree_lane_add(s, c);
}

/* Finds the impulses of a pass. Returns 0 where they change nothing, so that they are not applied. */
static int32_t impulses_find(cn_world *world, const cni_solve *s, const cni_heavy_contact *h, changes *d, int32_t pass)
{
	rows_solve(world, s, h, d, pass);
	if (!changes_speed(world, h, &d->p))
		return 0;
	impulses_apply(world, s, &s->direct->components[h->component], d);
	return 1;
}

static void contact_solve(cn_world *world, const cni_solve *s, cni_heavy_contact *h, int32_t bias)
{
	changes d = changes_begin(world, h->contact);
	int32_t k, l = d.p.lane;
	if (s->direct->components[h->component].done)
		return;
	if (!impulses_find(world, s, h, &d, bias))
		memcpy(d.p.j, d.p.first, sizeof d.p.j);
	h->is_hit |= (uint8_t)(d.p.j[0] + d.p.j[1] > 0.0f);
	d.block->jt[l] = d.p.j[2];
	for (k = 0; k < 2; ++k)
		d.block->p[k].jn[l] = d.block->p[k].load[l] = d.p.j[k];
}

/* Contacts begin to end - 1, which are those of one component. */
static void component_solve(cn_world *world, const cni_solve *s, int32_t begin, int32_t end, int32_t bias)
{
	cni_heavy_contact *heavies = s->direct->heavies;
	cni_component *c = &s->direct->components[heavies[begin].component];
	float turn = turn_of(world, s->direct, c);
	int32_t k, stale = 0;
	if (c->batches && !bias)
		cni_tree_lane_system(s, c);
	for (k = begin; k < end && !bias && !c->done; ++k)
		stale |= turn > heavies[k].turn_most;
	if (stale)
		responses_find(world, s, s->direct, begin, end);
	for (k = begin; k < end; ++k)
		contact_solve(world, s, &heavies[k], bias);
}

void cni_heavy_contacts_solve(cn_world *world, const cni_solve *s, int32_t bias)
{
	int32_t begin, end;
	for (begin = 0; begin < s->direct->heavy_count; begin = end) {
		end = end_of(s->direct, begin);
		component_solve(world, s, begin, end, bias);
	}
}

/* ---- bounces ---- */

/* The impulse is no load: it does not stay in the lane. */
static void contact_bounce(cn_world *world, const cni_solve *s, const cni_heavy_contact *h)
{
	changes d = changes_begin(world, h->contact);
	memset(d.p.j, 0, sizeof d.p.j);
	memset(d.p.first, 0, sizeof d.p.first);
	(void)impulses_find(world, s, h, &d, PASS_BOUNCE);
	if (CNI_HAS_EVENTS && world->sums_active)
		cni_impulse_sums_strike(world, h->contact, d.p.j[0] + d.p.j[1], 0.0f, 0.0f, 0.0f);
}

void cni_heavy_contacts_bounce(cn_world *world, const cni_solve *s)
{
	int32_t k;
	for (k = 0; k < s->direct->heavy_count; ++k) {
		const cni_heavy_contact *h = &s->direct->heavies[k];
		*lane_restitution(world, h->contact) = h->restitution;
		if (h->is_hit && bounces(h) && !s->direct->components[h->component].done)
			contact_bounce(world, s, h);
	}
}
