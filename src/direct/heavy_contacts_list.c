/*
 * direct/heavy_contacts_list.c - which contacts direct/heavy_contacts.c solves with the joints of a component: those of its bodies with
 * heavier ones that bear much, or may meet in this step; with bodies of like mass that are pressed deep into them, or are slow and of the same
 * component; with static bodies under extreme loads; those that bounce.
 *
 * Reads contacts, lanes, motion; writes the list of heavy contacts of the step.
 */
#include "contacts/contacts.h"
#include "direct/heavy_contacts.h"

#include <string.h>

/* Newton's law with the speed at which the point meets, as in contacts/restitution.c; 0: it does not meet in this step as fast as bounces do. */
static float bounce_speed(const cn_world *world, const cni_solve *s, int32_t point, const cni_direct_contact *p, float restitution)
{
	const cni_motion *a = cni_motions(world) + p->ia, *b = cni_motions(world) + p->ib;
	const cni_external *ea = cni_externals(world) + p->ia, *eb = cni_externals(world) + p->ib;
	float gap = cni_direct_contact_separation(p, point, a, b), speed = cni_direct_contact_speed(p, point, a, b);
	float closing = p->nx * (ea->ax - eb->ax) + p->ny * (ea->ay - eb->ay); /* acceleration */
	if (p->mass[point] <= 0.0f || speed >= -s->restitution_threshold || -speed * p->mass[point] <= p->j[point] || gap + s->dt * speed >= world->settings.slop)
		return 0.0f;
	return restitution * cni_sqrt(cni_max(speed * speed + 2.0f * closing * gap, 0.0f));
}

static cni_heavy_contact heavy_make(const cn_world *world, const cni_solve *s, int32_t component, int32_t contact)
{
	cni_heavy_contact h;
	memset(&h, 0, sizeof h);
	h.component = component;
	h.contact = contact;
	h.tangent_speed = cni_direct_lane_tangent_speed(world, cni_contact_at(world, contact));
	h.restitution = *cni_heavy_restitution(world, contact);
	if (h.restitution > 0.0f) {
		cni_direct_contact p;
		cni_direct_contact_read(world, cni_contact_at(world, contact), &p);
		h.bounce[0] = bounce_speed(world, s, 0, &p, h.restitution);
		h.bounce[1] = bounce_speed(world, s, 1, &p, h.restitution);
	}
	return h;
}

/* 1: a point of the lane bears more than an impulse that gives its bodies this speed. */
static int32_t bears(const cni_contact_block *block, int32_t lane, float speed)
{
	const cni_contact_row *p = block->p;
	return p[0].jn[lane] > speed * p[0].nm[lane] || p[1].jn[lane] > speed * p[1].nm[lane];
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
	if (bears(block, l, speed))
		return 1;
	for (k = 0; k < 2; ++k)
		idle |= (rows[k].nm[l] > 0.0f && !(rows[k].jn[l] > 0.0f)) << k;
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

/* Which of two bodies of like mass lists their contact: the lighter one. */
static int32_t lists(const cn_world *world, int32_t index, int32_t other)
{
	float own = cni_motions(world)[index].inv_mass, of_other = cni_motions(world)[other].inv_mass;
	return own > of_other || (own == of_other && index < other);
}

/* 1: the contact with a body of like mass, free or jointed, overlaps and bears much. */
static int32_t is_squeezed(const cn_world *world, const cni_solve *s, int32_t contact, int32_t index, int32_t other)
{
	float deep = -CNI_HEAVY_LIKE_SLOPS * world->settings.slop;
	int32_t slot = cni_contact_at(world, contact)->slot, l = slot % CNI_LANES;
	const cni_contact_block *block = cni_block_at(world, slot / CNI_LANES);
	if (!lists(world, index, other) || (block->p[0].s0[l] > deep && block->p[1].s0[l] > deep))
		return 0;
	return bears(block, l, CNI_HEAVY_LIKE_STRESS * cni_length(world->settings.gravity) * s->h);
}

/* 1: nothing holds the body. */
static int32_t is_free(const cn_world *world, int32_t index)
{
	return cni_motion_can_move(cni_motions(world) + index) && !(cni_externals(world)[index].flags & CNI_EXTERNAL_JOINTED);
}

/* A single joint lists free bodies alone: a wheel on a fixed axle against a fixed bed or another such wheel is held from both sides. */
static void body_contacts_list(const cn_world *world, const cni_solve *s, cni_sparse *sparse, int32_t component, int32_t index, float ratio, int32_t most, int32_t slow)
{
	const cni_body *b = cni_body_at(world, cni_awake_ids(world)[index]);
	int32_t key, left = b->lanes, single = cni_component_is_single(&sparse->components[component]);
	for (key = b->contact_first; left > 0 && sparse->heavy_count < most; key = cni_contact_of_key(world, key)->next[key & 1]) {
		const cni_contact *c = cni_contact_of_key(world, key);
		const cni_body *other = cni_body_at(world, c->body[1 - (key & 1)]);
		float inv_mass = cni_motions(world)[other->awake].inv_mass;
		int32_t light = ratio * inv_mass >= cni_motions(world)[index].inv_mass;
		if (!cni_contact_has_lane(c))
			continue;
		--left;
		if (single && (light || !is_free(world, other->awake)))
			continue;
		light = light && !(slow && sparse->component_of[other->awake] == component && lists(world, index, other->awake));
		light = light && (sparse->heavy_count >= CNI_HEAVY_CONTACTS_FREE || !is_squeezed(world, s, key >> 1, index, other->awake));
		if ((light && *cni_heavy_restitution(world, key >> 1) <= 0.0f) || cni_direct_lane_is_locked(world, c))
			continue;
		/* A jointed body that is not heavier is in a component that could list the contact itself. */
		if (light ? (cni_externals(world)[other->awake].flags & CNI_EXTERNAL_JOINTED) != 0 : !is_pressed(world, s, key >> 1, inv_mass == 0.0f, slow))
			continue;
		cni_heavy_contact h = heavy_make(world, s, component, key >> 1);
		h.is_light = (uint8_t)light;
		h.is_of_free = (uint8_t)is_free(world, other->awake);
		if (!light || cni_heavy_bounces(&h))
			sparse->heavies[sparse->heavy_count++] = h;
	}
}

static int32_t blocks_of(const cni_sparse *sparse, const cni_component *c)
{
	return sparse->first[c->end] - sparse->first[c->begin] + c->end - c->begin;
}

int32_t cni_heavy_contacts_most(const cni_sparse *sparse, const cni_component *c)
{
	return cni_min_i(CNI_HEAVY_CONTACT_BLOCKS / cni_max_i(blocks_of(sparse, c), 1), CNI_HEAVY_COMPONENT_MOST);
}

/* 1: one of its joints may break. It bears at most its threshold, which is known after the step only: a ball would bounce off a wall of
   bricks that it should break. */
static int32_t may_break(const cn_world *world, const cni_sparse *sparse, const cni_component *c)
{
	for (int32_t k = c->begin; k < c->end; ++k)
		if (cni_joint_constraints(world)[sparse->nodes[k].owner].flags & CNI_CONSTRAINT_BREAKABLE)
			return 1;
	return 0;
}

int32_t cni_heavy_contacts_list(const cn_world *world, const cni_solve *s, cni_sparse *sparse, int32_t component, int32_t batchable)
{
	const cni_component *c = &sparse->components[component];
	int32_t k, first = sparse->heavy_count, most, slow;
	float ratio;
	if (!CNI_ON(HEAVY_CONTACTS) || !CNI_ON(JOINT_PROJECTION) || c->mass_ratio > CNI_ILL_MASS_RATIO)
		return 0;
	if (c->has_contacts || c->touched == 0 || may_break(world, sparse, c))
		return 0;
	ratio = batchable || cni_component_is_single(c) ? CNI_SELECTION_MASS_RATIO : 1.0f; /* else only bodies that may crush its own: ragdolls would take 4 times as long as soft ones instead of 2.1 times */
	slow = (!batchable || blocks_of(sparse, c) <= CNI_HEAVY_SLOW_BLOCKS) && cni_component_is_slow(world, sparse, c);
	most = cni_min_i(first + cni_heavy_contacts_most(sparse, c), cni_heavy_contacts_room(world->touching_count, world->awake_joints.count));
	for (k = c->body_begin; k < c->body_end; ++k)
		if (cni_externals(world)[sparse->bodies[k]].flags & CNI_EXTERNAL_TOUCHED)
			body_contacts_list(world, s, sparse, component, sparse->bodies[k], ratio, most, slow);
	return sparse->heavy_count > first;
}
