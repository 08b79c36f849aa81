/*
 * direct/joint_projection.c - hard stops: joints and contacts by turns, until they agree.
 *
 * Joints are solved first, then contacts. What contacts stopped would come apart from its neighbours as positions
 * move, by 4 cm in a substep at 10 m/s. So where a joint would open by more than is good, also because arms that turn
 * fast leave the tangent, its system is solved once more, then the contacts of its bodies, and so on for a few rounds, joints
 * last. A scene without hard stops pays for one look at the joints of touched systems; in later rounds only those are
 * looked at whose bodies have changed.
 *
 * Reads and writes what direct/direct_joints.c and contact_solve.c do, between their passes.
 */
#include "direct/direct.h"
#include "contacts/contacts.h"
#include "direct/batched_trees.h"
#include "direct/direct_contact.h"

#define CLOSE_ROUNDS 4       /* of joints and the contacts that part them, in a substep, at most */

static int32_t may_close(const cn_world *world, const cni_sparse *sparse, const cni_component *c)
{
	int32_t n;
	if (c->done || c->presses)
		return 0;
	for (n = c->body_begin; n < c->body_end; ++n)
		if (cni_externals(world)[sparse->bodies[n]].flags & CNI_EXTERNAL_TOUCHED)
			return 1;
	return 0;
}

/* Rounds of contacts for which a system asks in a substep: a blow goes on through a tree joint by joint. */
static int32_t rounds_of(const cni_component *c)
{
	return cni_max_i(1, cni_min_i(c->end - c->begin - 1, CLOSE_ROUNDS));
}

static void projection_add(cni_sparse *sparse, int32_t component)
{
	const cni_component *c = &sparse->components[component];
	cni_projection *projection = &sparse->projections[sparse->projection_count];
	int32_t k;
	projection->component = component;
	projection->batch = c->batches ? c->batch : CNI_NONE;
	projection->lane = c->lane;
	projection->rounds = rounds_of(c);
	projection->asked = projection->parting = projection->changed = 0;
	projection->slot_begin = CNI_NONE;
	for (k = c->body_begin; k < c->body_end; ++k)
		sparse->projection_of[sparse->bodies[k]] = sparse->projection_count;
	++sparse->projection_count;
}

/* What contacts may part. */
void cni_projection_mark(const cn_world *world, cni_sparse *sparse)
{
	int32_t k;
	for (k = 0; k < world->awake_count; ++k)
		sparse->projection_of[k] = CNI_NONE;
	for (k = 0; k < sparse->component_count; ++k)
		if (may_close(world, sparse, &sparse->components[k]))
			projection_add(sparse, k);
}

/* Do contacts, which came after, part joints by more in this substep than is good? Reads the right sides. */
static int32_t is_parting(const cn_world *world, const cni_solve *s, const cni_component *c)
{
	float most = CNI_PROJECTION_PART * world->settings.accuracy * s->inv_h;
	int32_t k, i;
	for (k = c->begin; k < c->end; ++k)
		for (i = 0; i < s->direct->nodes[k].rows; ++i)
			if (cni_abs(s->direct->nodes[k].x[i]) > most)
				return 1;
	return 0;
}

/* How a point at r leaves the tangent when its body turns by this angle, with the bits of batches: turn_series in
   joints/joint_kernel.h. */
static cni_vec2 drift(cni_vec2 r, float turn)
{
	float half = cni_clamp(0.5f * turn, -1.5f, 1.5f), u = half * half, s, c1, c2;
	s = half * (1.0f - u * (1.0f / 6.0f - u * (1.0f / 120.0f - u * (1.0f / 5040.0f))));
	c1 = -u * (0.5f - u * (1.0f / 24.0f - u * (1.0f / 720.0f)));
	c2 = -2.0f * (s * s);
	s = 2.0f * (s + s * c1);
	return cni_v(c2 * r.x - (s - turn) * r.y, c2 * r.y + (s - turn) * r.x);
}

static int32_t joint_is(const cn_world *world, const cni_node *n, int32_t type)
{
	return cni_joint_constraints(world)[n->owner].record->type == type;
}

static void pin_drift(const cni_solve *s, cni_node *n, float wa, float wb)
{
	const cni_lever *x = &n->lever[0], *y = &n->lever[1];
	cni_vec2 a = drift(cni_v(-y->aw, x->aw), s->h * wa), b = drift(cni_v(y->bw, -x->bw), s->h * wb);
	n->x[0] -= cni_clamp((b.x - a.x) * s->inv_h, -s->push_speed, s->push_speed);
	n->x[1] -= cni_clamp((b.y - a.y) * s->inv_h, -s->push_speed, s->push_speed);
}

/* Any other joint: what its errors will be, less what their speeds tell. */
static void joint_drift(const cn_world *world, const cni_solve *s, cni_node *n)
{
	const cni_motion *motions = cni_motions(world);
	const cni_joint_constraint *w = cni_joint_constraints(world) + n->owner;
	float ahead[CNI_NODE_ROWS];
	int32_t i;
	cni_joint_constraint_ahead(w, motions, s->h, ahead);
	for (i = 0; i < n->rows; ++i) {
		float speed = (ahead[i] - w->rows[i].error) * s->inv_h - cni_lever_speed(&n->lever[i], motions + n->ia, motions + n->ib);
		n->x[i] -= cni_clamp(speed, -s->push_speed, s->push_speed);
	}
}

/* Arms that turn fast, and rods, whose bodies need not, carry joints apart at the second order of the substep: their speeds
   shall make up for it. */
static void drifts_add(const cn_world *world, const cni_solve *s, const cni_component *c)
{
	const cni_motion *motions = cni_motions(world);
	float least = CNI_PROJECTION_TURN_RAD * s->inv_h;
	int32_t k;
	for (k = c->begin; k < c->end; ++k) {
		cni_node *n = &s->direct->nodes[k];
		float wa = motions[n->ia].w, wb = motions[n->ib].w;
		int32_t turns = cni_abs(wa) > least || cni_abs(wb) > least;
		if (n->owner >= 0 && turns && joint_is(world, n, CN_JOINT_REVOLUTE))
			pin_drift(s, n, wa, wb);
		else if (n->owner >= 0 && (turns || n->rows == 1) && !joint_is(world, n, CN_JOINT_REVOLUTE))
			joint_drift(world, s, n);
	}
}

/* Whose bodies have changed since it was looked at; index: dense. */
static void change_tell(cni_sparse *sparse, int32_t index)
{
	if (sparse->projection_of[index] != CNI_NONE)
		sparse->projections[sparse->projection_of[index]].changed = 1;
}

static void body_slots_find(const cn_world *world, cni_sparse *sparse, const cni_body *b)
{
	int32_t key, left = b->lanes;
	for (key = b->contact_first; left > 0; key = cni_contact_of_key(world, key)->next[key & 1]) {
		const cni_contact *contact = cni_contact_of_key(world, key);
		if (!(contact->flags & CNI_CONTACT_TOUCHING) || contact->slot == CNI_NONE)
			continue;
		--left;
		sparse->projection_slots[sparse->projection_slot_count++] = contact->slot;
	}
}

/* Where the contacts of its bodies are in lanes: the same all through the substeps. */
static void slots_find(const cn_world *world, cni_sparse *sparse, cni_projection *projection)
{
	const cni_component *c = &sparse->components[projection->component];
	int32_t k;
	projection->slot_begin = sparse->projection_slot_count;
	for (k = c->body_begin; k < c->body_end; ++k)
		body_slots_find(world, sparse, cni_body_at(world, cni_awake_ids(world)[sparse->bodies[k]]));
	projection->slot_end = sparse->projection_slot_count;
}

/* What is in lanes of the contacts of its bodies, once more. */
static void contacts_again(cn_world *world, const cni_solve *s, cni_projection *projection)
{
	int32_t k;
	if (projection->slot_begin == CNI_NONE)
		slots_find(world, s->direct, projection);
	for (k = projection->slot_begin; k < projection->slot_end; ++k) {
		int32_t slot = s->direct->projection_slots[k];
		const cni_contact_block *block = cni_block_at(world, slot / CNI_LANES);
		cni_contact_solve_again(world, s, slot);
		change_tell(s->direct, block->ia[slot % CNI_LANES]);
		change_tell(s->direct, block->ib[slot % CNI_LANES]);
	}
}

/* Which are to be looked at: all, or those that parted in the last round, and whose bodies its contacts changed. */
static void projections_ask(cni_sparse *sparse, int32_t round)
{
	int32_t k;
	for (k = 0; k < sparse->batch_count; ++k)
		sparse->batches[k].asked = 0;
	for (k = 0; k < sparse->projection_count; ++k) {
		cni_projection *c = &sparse->projections[k];
		c->asked = round == 0 || c->parting || c->changed;
		c->changed = 0;
		if (c->asked && c->batch != CNI_NONE)
			sparse->batches[c->batch].asked |= 1u << c->lane;
	}
}

/* Returns 1 when it had to. */
static int32_t component_close(cn_world *world, const cni_solve *s, cni_component *c)
{
	if (c->done)
		return 0;
	cni_direct_sides(world, s, c, 1);
	drifts_add(world, s, c);
	if (!is_parting(world, s, c))
		return 0;
	cni_direct_answer(world, s, c);
	return 1;
}

static int32_t projection_run(cn_world *world, const cni_solve *s, const cni_projection *c)
{
	if (!c->asked)
		return 0;
	if (c->batch != CNI_NONE)
		return (int32_t)(s->direct->batches[c->batch].parting >> c->lane & 1u);
	return component_close(world, s, &s->direct->components[c->component]);
}

/* Returns 1 when contacts of some are to come once more: they are parting. */
static int32_t projections_run(cn_world *world, const cni_solve *s, int32_t round)
{
	int32_t k, closed = 0;
	projections_ask(s->direct, round);
	cni_tree_batches_close(world, s);
	for (k = 0; k < s->direct->projection_count; ++k) {
		cni_projection *c = &s->direct->projections[k];
		c->parting = projection_run(world, s, c) && round < c->rounds;
		closed |= c->parting;
	}
	return closed;
}

void cni_direct_project(cn_world *world, const cni_solve *s)
{
	int32_t k, round;
	if (s->direct == NULL || s->direct->projection_count == 0)
		return;
	for (round = 0; projections_run(world, s, round); ++round)
		for (k = 0; k < s->direct->projection_count; ++k)
			if (s->direct->projections[k].parting)
				contacts_again(world, s, &s->direct->projections[k]);
}
