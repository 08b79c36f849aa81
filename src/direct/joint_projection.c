/*
 * direct/joint_projection.c - hard stops: alternates joints and contacts until they agree.
 *
 * Joints are solved first, then contacts. A body that a contact stopped would separate from its jointed neighbours when positions move, by
 * 4 cm in a substep at 10 m/s. Where joints would open by more than CNI_BAD_PART of the accuracy, also because fast lever arms leave
 * the tangent, their system is solved once more, then the contacts of its bodies, heavy ones first, for a few rounds, joints last. A
 * scene without hard stops costs one check of the joints of touched systems; later rounds only check systems whose bodies have changed. A ball that
 * a wall stops pushes the light chain on which it hangs into itself, and exact joints turn its links by any angle: those that would turn by more than
 * CNI_BUCKLE_RAD in the substep are locked to each other.
 *
 * After the relax passes the same is done with rigid rows for trees of slow bodies. One pass over joints, whose response is that of all bodies, and one
 * over contacts, which know the masses of two, leave some of the speed of the pushes. Exact joints take nothing of it out again, and heaps of
 * ragdolls moved for ever.
 *
 * Reads and writes the data of direct/direct_joints.c and contact_solve.c, between their passes.
 */
#include "direct/direct.h"
#include "contacts/contacts.h"
#include "direct/direct_system.h"
#include "direct/heavy_contacts.h"

#include <string.h>

#define MARKS_LOOKED_AT 16

/* 1: it is to come to rest. Motors drive on, and loops bear tension that more rounds with contacts would change. */
static int32_t may_settle(const cn_world *world, const cni_sparse *sparse, const cni_component *c)
{
	return !c->loops && c->active < 2 && cni_component_is_slow(world, sparse, c);
}

void cni_projection_mark(const cn_world *world, cni_sparse *sparse)
{
	memset(sparse->projections, 0, sizeof(cni_projection) * (size_t)sparse->component_count);
	for (int32_t k = 0; k < sparse->component_count; ++k) {
		const cni_component *c = &sparse->components[k];
		if (c->done || c->has_contacts || c->touched == 0)
			continue;
		sparse->projections[k].listed = 1;
		sparse->projections[k].settles = may_settle(world, sparse, c);
		sparse->settles |= sparse->projections[k].settles;
		sparse->projections[k].mark_begin = CNI_NONE;
		++sparse->projection_count;
	}
}

/* Greatest speed at which contacts may open joints: before positions move (bias 1) CNI_BAD_PART of the accuracy in a substep. */
static float opening_speed(const cn_world *world, const cni_solve *s, int32_t bias)
{
	return bias ? CNI_BAD_PART * world->settings.accuracy * s->inv_h : CNI_SETTLE_PART * world->settings.sleep_speed;
}

/* 1: contacts would open a joint faster. Reads the right sides. */
static int32_t is_opening(const cn_world *world, const cni_solve *s, const cni_component *c, int32_t bias)
{
	float most = opening_speed(world, s, bias);
	for (int32_t k = c->begin; k < c->end; ++k) {
		const cni_node *n = &s->direct->nodes[k];
		for (int32_t i = 0; i < n->rows; ++i)
			if (cni_abs(n->x[i]) * cni_row_length(world, &cni_joint_constraints(world)[n->owner].rows[i]) > most)
				return 1;
	}
	return c->active && (c->has_ropes || !bias) && cni_active_limit_missing(world, s->direct, c, bias) > most;
}

/* Second-order drift of a point at r when its body turns by this angle: its deviation from the tangent, with the bits of the batches
   (turn_series in joints/joint_kernel.h). */
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
	const cni_levers *l = &n->levers;
	cni_vec2 a = drift(cni_v(-l->aw[1], l->aw[0]), s->h * wa), b = drift(cni_v(l->bw[1], -l->bw[0]), s->h * wb);
	n->x[0] -= cni_clamp((b.x - a.x) * s->inv_h, -s->push_speed, s->push_speed);
	n->x[1] -= cni_clamp((b.y - a.y) * s->inv_h, -s->push_speed, s->push_speed);
}

/* Any other joint: its errors ahead, less the part that its speeds explain. */
static void joint_drift(const cn_world *world, const cni_solve *s, cni_node *n)
{
	const cni_motion *motions = cni_motions(world);
	const cni_joint_constraint *w = cni_joint_constraints(world) + n->owner;
	float ahead[CNI_NODE_ROWS], now[CNI_NODE_LANES];
	cni_joint_constraint_ahead(w, motions, s->h, ahead);
	cni_four_store(now, cni_levers_speed(&n->levers, motions + n->ia, motions + n->ib));
	for (int32_t i = n->rows - 1; i >= 0; --i) {
		float most = cni_row_push_speed(world, &w->rows[i]);
		ahead[i] = (ahead[i] - w->rows[i].error) * s->inv_h;
		n->x[i] -= cni_clamp(ahead[i] + (i < n->rows - 1 ? n->share[i] * ahead[n->rows - 1] : 0.0f) - now[i], -most, most);
	}
}

/* Fast lever arms, and rods even between slow bodies, open joints at the second order of the substep: the right sides compensate for it, at
   the speed of pushing at most. Without a limit loaded drums whose ropes are put elsewhere throw them (5 of 12 at 400 m/s). */
static void drifts_add(const cn_world *world, const cni_solve *s, const cni_component *c)
{
	const cni_motion *motions = cni_motions(world);
	float least = CNI_PROJECTION_TURN_RAD * s->inv_h;
	for (int32_t k = c->begin; k < c->end; ++k) {
		cni_node *n = &s->direct->nodes[k];
		float wa = motions[n->ia].w, wb = motions[n->ib].w;
		int32_t turns = cni_abs(wa) > least || cni_abs(wb) > least;
		if (n->owner >= 0 && turns && joint_is(world, n, CN_JOINT_REVOLUTE))
			pin_drift(s, n, wa, wb);
		else if (n->owner >= 0 && (turns || n->rows == 1) && !joint_is(world, n, CN_JOINT_REVOLUTE))
			joint_drift(world, s, n);
	}
}

/* Adds a contact to the marks of a component: to one of the last few of the same block, or as one more. */
static void mark_add(const cn_world *world, cni_sparse *sparse, int32_t component, int32_t slot)
{
	const cni_contact_block *block = cni_block_at(world, slot / CNI_LANES);
	int32_t a = sparse->component_of[block->ia[slot % CNI_LANES]], b = sparse->component_of[block->ib[slot % CNI_LANES]], other = a == component ? b : a;
	cni_marked_lanes *end = sparse->projection_marks + sparse->projection_mark_count, *m = sparse->projection_marks + sparse->projections[component].mark_begin;
	if (other != CNI_NONE && !sparse->projections[other].listed)
		other = CNI_NONE;
	for (m = end - m > MARKS_LOOKED_AT ? end - MARKS_LOOKED_AT : m; m < end && (m->block != slot / CNI_LANES || m->other != other); ++m)
		;
	if (m == end) {
		++sparse->projection_mark_count;
		m->block = slot / CNI_LANES;
		m->lanes = 0;
		m->other = other;
	}
	m->lanes |= 1u << slot % CNI_LANES;
}

static void body_marks_find(const cn_world *world, cni_sparse *sparse, int32_t component, const cni_body *b)
{
	int32_t key, left = b->lanes;
	for (key = b->contact_first; left > 0; key = cni_contact_of_key(world, key)->next[key & 1]) {
		const cni_contact *contact = cni_contact_of_key(world, key);
		if (!(contact->flags & CNI_CONTACT_TOUCHING) || contact->slot == CNI_NONE)
			continue;
		--left;
		mark_add(world, sparse, component, contact->slot);
	}
}

/* Those of the contacts of its bodies: fixed during the substeps. */
static void marks_find(const cn_world *world, cni_sparse *sparse, int32_t component)
{
	const cni_component *c = &sparse->components[component];
	sparse->projections[component].mark_begin = sparse->projection_mark_count;
	for (int32_t k = c->body_begin; k < c->body_end; ++k)
		body_marks_find(world, sparse, component, cni_body_at(world, cni_awake_ids(world)[sparse->bodies[k]]));
	sparse->projections[component].mark_end = sparse->projection_mark_count;
}

/* Marks the contacts of a component's bodies that are in lanes, and what they will change. */
static void contacts_mark(const cn_world *world, cni_sparse *sparse, int32_t component)
{
	cni_projection *projection = &sparse->projections[component];
	if (projection->mark_begin == CNI_NONE)
		marks_find(world, sparse, component);
	for (int32_t k = projection->mark_begin; k < projection->mark_end; ++k) {
		const cni_marked_lanes *m = &sparse->projection_marks[k];
		cni_block_info *info = cni_block_info_at(world, m->block);
		info->again = (cni_lane_bits)(info->again | m->lanes);
		projection->changed = 1;
		if (m->other != CNI_NONE)
			sparse->projections[m->other].changed = 1;
	}
}

/* Selects projections to check: all in the first round, then those that opened in the last round or whose bodies contacts changed. */
static void projections_select(cni_sparse *sparse, int32_t round, int32_t bias)
{
	for (int32_t k = 0; k < sparse->batch_count; ++k)
		sparse->batches[k].selected = 0;
	for (int32_t k = 0; k < sparse->component_count; ++k) {
		cni_projection *p = &sparse->projections[k];
		const cni_component *c = &sparse->components[k];
		p->selected = p->listed && (bias || p->settles) && (round == 0 || p->opening || p->changed);
		p->changed = 0;
		if (p->selected && c->batches)
			sparse->batches[c->batch].selected |= 1u << c->lane;
	}
}

/* Solves it where it is opening. */
static void component_project(cn_world *world, const cni_solve *s, cni_component *c, int32_t bias)
{
	cni_projection *p = &s->direct->projections[c - s->direct->components];
	p->opening = 0;
	if (!p->selected || c->done || c->batches)
		return;
	cni_direct_right_sides(world, s, c, bias);
	if (bias)
		drifts_add(world, s, c);
	p->opening = is_opening(world, s, c, bias);
	if (!p->opening)
		return;
	cni_component_solve(world, s, c, bias);
	if (bias)
		(void)cni_component_lock(world, s, c, CNI_BUCKLE_RAD);
}

/* Returns 1 when some joints were opening, so that their contacts must be solved once more. */
static int32_t projections_run(cn_world *world, const cni_solve *s, int32_t round, int32_t bias)
{
	int32_t k, opening = 0;
	projections_select(s->direct, round, bias);
	cni_tree_batches_project(world, s, opening_speed(world, s, bias), bias);
	cni_components_run(world, s, s->team, component_project, bias);
	cni_components_give_up(world, s);
	for (k = 0; k < s->direct->component_count; ++k) {
		cni_projection *p = &s->direct->projections[k];
		cni_component *c = &s->direct->components[k];
		int32_t solved = p->selected && (c->batches ? (int32_t)(s->direct->batches[c->batch].opening >> c->lane & 1u) : p->opening);
		if (solved && c->batches && bias) {
			cni_tree_lane_lock(world, s, c, CNI_BUCKLE_RAD);
			cni_component_give_up(world, s->direct, c);
		}
		p->opening = solved && round < cni_max_i(1, cni_min_i(c->end - c->begin - 1, CNI_PROJECTION_ROUNDS)); /* an impact travels joint by joint */
		opening |= p->opening;
	}
	return opening;
}

static void contacts_of_opening_mark(const cn_world *world, cni_sparse *sparse)
{
	for (int32_t k = 0; k < sparse->component_count; ++k)
		if (sparse->projections[k].opening)
			contacts_mark(world, sparse, k);
}

void cni_direct_project(cn_world *world, const cni_solve *s)
{
	if (s->direct == NULL || s->direct->projection_count == 0)
		return;
	for (int32_t round = 0; projections_run(world, s, round, 1); ++round) {
		cni_heavy_contacts_project(world, s);
		contacts_of_opening_mark(world, s->direct);
		cni_contacts_pass(world, s, CNI_PASS_AGAIN);
	}
}

void cni_direct_settle(cn_world *world, const cni_solve *s)
{
	const cni_soft exact = { 1.0f, 0.0f, 0.0f };
	cni_solve rigid;
	if (s->direct == NULL || !s->direct->settles)
		return;
	for (int32_t round = 0; round < CNI_SETTLE_ROUNDS && projections_run(world, s, round, 0); ++round) {
		rigid = *s;
		for (int32_t k = 0; k < CNI_CONTACTS_KINDS; ++k)
			rigid.contact[k].soft = rigid.contact[k].deep = exact;
		contacts_of_opening_mark(world, s->direct);
		cni_contacts_pass(world, &rigid, CNI_PASS_AGAIN);
	}
}
