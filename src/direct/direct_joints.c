/*
 * direct/direct_joints.c - solves the rigid rows of connected joints together, exactly (linear/sparse.h): the components of
 * direct/direct_plan.c, from their levers to impulses.
 *
 * Joints outside of the components, and springs, motors and limits, are solved row by row in joints/joint_solve.c before. Contacts come
 * after. Where joints and contacts disagree, they alternate more than once: direct/joint_projection.c.
 *
 * Which components are exact in a step: direct/component_fate.c.
 *
 * Reads joint constraints, motion and inverse masses; writes flags and rigid rows' impulses of joint constraints, motion velocities.
 */
#include "direct/direct.h"
#include "contacts/deep_lanes.h"
#include "direct/direct_contact.h"
#include "direct/direct_system.h"
#include "direct/heavy_contacts.h"

#include <string.h>

#define SHARED_JOINTS 256 /* awake: components of fewer are judged before a worker is awake */

/* ---- the components of a step ---- */

/* Work of a step, in the units of work_budget. */
static int32_t work_planned(const cn_world *world, const cni_sparse *sparse)
{
	int64_t work = 0;
	for (int32_t k = 0; k < sparse->component_count; ++k)
		work += sparse->components[k].done ? 0 : (int64_t)sparse->components[k].work * world->settings.substeps;
	return work < INT32_MAX ? (int32_t)work : INT32_MAX;
}

/* Contacts between two of its bodies are scaled twice. Loads, to which soft contacts do not yield, are forgotten with the impulses alone. */
static void contact_impulses_scale(cn_world *world, const cni_sparse *sparse, const cni_component *c, float part)
{
	for (int32_t k = c->body_begin; k < c->body_end; ++k)
		for (int32_t key = cni_body_at(world, cni_awake_ids(world)[sparse->bodies[k]])->contact_first; key != CNI_NONE; key = cni_contact_of_key(world, key)->next[key & 1]) {
			const cni_contact *contact = cni_contact_of_key(world, key);
			if (!cni_contact_has_lane(contact))
				continue;
			cni_contact_block *block = cni_block_at(world, contact->slot / CNI_LANES);
			cni_block_scale_impulses(block, contact->slot % CNI_LANES, part);
			for (int32_t i = 0; i < 2 && part == 0.0f; ++i)
				block->p[i].load[contact->slot % CNI_LANES] = 0.0f;
		}
}

/* Of its joints, and of the contacts of its bodies. 0: they are forgotten. */
static void impulses_scale(cn_world *world, const cni_sparse *sparse, const cni_component *c, float part)
{
	contact_impulses_scale(world, sparse, c, part);
	for (int32_t k = c->begin; k < c->end; ++k) {
		cni_joint_constraint *w = cni_joint_constraints(world) + sparse->nodes[k].owner;
		float *impulse = cni_joint_at(world, w->joint)->impulse;
		for (int32_t i = 0; i < CNI_JOINT_ROWS; ++i)
			impulse[i] *= part;
		for (int32_t i = 0; i < w->row_count; ++i)
			w->rows[i].impulse *= part;
	}
}

/*
 * A straight loop between fixed ends bears tension of any size without moving, and a singular system answers to rounding with it: rods of a
 * hung net had 1e5 times their weight. Joints and contacts that contradict each other grow likewise. Exact joints cancel it in all bodies; soft
 * ones would throw them. All impulses are scaled by one factor, so that they still cancel.
 */
static void impulses_soften(cn_world *world, const cni_sparse *sparse, const cni_component *c)
{
	float part = 1.0f;
	for (int32_t k = c->begin; k < c->end; ++k) {
		const cni_joint_constraint *w = cni_joint_constraints(world) + sparse->nodes[k].owner;
		float sum = cni_joint_impulse_sum(world, w->record, sparse->nodes[k].rows > 0 ? sparse->nodes[k].rows : CNI_JOINT_ROWS); /* a rope has one */
		part = cni_min(part, cni_direct_soft_part(world, sum, w->ia, w->ib));
	}
	if (part < 1.0f)
		impulses_scale(world, sparse, c, part);
}

static void soften_for(cn_world *world, cni_sparse *sparse, cni_component *c, int32_t span)
{
	impulses_soften(world, sparse, c);
	cni_component_suspend(world, sparse, c, span);
}

/* The passes of a substep; a single joint with the world needs them for heavy contacts alone. */
static void passes_begin(cn_world *world, const cni_solve *s, cni_sparse *sparse, int32_t component, int32_t has_company)
{
	cni_component *c = &sparse->components[component];
	int32_t single = cni_component_is_single(c), has_heavy = single && sparse->nodes[c->begin].rows == 0 ? 0 : cni_heavy_contacts_list(world, s, sparse, component, has_company);
	if (single && !has_heavy) {
		cni_component_release(world, sparse, c);
		return;
	}
	if (c->batches && has_heavy)
		c->batches = cni_component_is_batched(world, s, sparse, c, 1);
	c->pending = !c->batches;
	c->kind = c->batches ? c->kind : CNI_NONE;
}

/* Pins and welds of loops act at the middle of their gaps. At both ends of gaps that stay open, internal tension would turn the whole. */
static void pending_begin(cn_world *world, const cni_solve *s, cni_component *c, int32_t argument)
{
	(void)argument;
	for (int32_t k = c->begin; k < c->end && c->pending && c->loops; ++k)
		if (s->direct->nodes[k].owner >= 0)
			cni_joint_rows_centre(world, s, cni_joint_constraints(world) + s->direct->nodes[k].owner);
	if (c->pending)
		cni_direct_begin(world, s, s->direct, c);
	c->pending = 0;
}

/* The component of each body. */
static void components_number(const cn_world *world, const cni_sparse *sparse)
{
	for (int32_t k = 0; k < world->awake_count; ++k)
		sparse->component_of[k] = CNI_NONE;
	for (int32_t k = 0; k < sparse->component_count; ++k)
		for (int32_t i = sparse->components[k].body_begin; i < sparse->components[k].body_end; ++i)
			sparse->component_of[sparse->bodies[i]] = k;
}

/* Writes the world: contacts, what joints remember of failures, the list of heavy contacts. */
static void component_begin(cn_world *world, const cni_solve *s, cni_sparse *sparse, int32_t component, int32_t has_company)
{
	cni_component *c = &sparse->components[component];
	switch (c->fate) {
	case CNI_FATE_SOFT: soften_for(world, sparse, c, 0); break;
	case CNI_FATE_SOFT_LONG: soften_for(world, sparse, c, CNI_TRUST_MOST); break;
	case CNI_FATE_WITHOUT_IMPULSES:
		impulses_scale(world, sparse, c, 0.0f);
		cni_component_suspend(world, sparse, c, CNI_TRUST_MOST);
		break;
	case CNI_FATE_RELEASED: cni_component_release(world, sparse, c); break;
	case CNI_FATE_PASSES: passes_begin(world, s, sparse, component, has_company); break;
	default: break;
	}
}

/* Trees that batches may take have company where there are others of their class. */
static void components_begin(cn_world *world, const cni_solve *s, cni_sparse *sparse)
{
	int32_t batched[CNI_TOPOLOGY_CLASSES] = { 0 };
	for (int32_t k = 0; k < sparse->component_count; ++k)
		if (!sparse->components[k].done && sparse->components[k].batches)
			++batched[sparse->components[k].kind];
	for (int32_t k = 0; k < sparse->component_count; ++k) {
		const cni_component *c = &sparse->components[k];
		if (!c->done)
			component_begin(world, s, sparse, k, c->batches && batched[c->kind] > 1);
	}
}

void cni_direct_prepare(cn_world *world, cni_solve *s, cni_sparse *out)
{
	cni_team *team = world->awake_joints.count >= SHARED_JOINTS ? world->team : NULL;
	memset(out, 0, sizeof *out);
	if ((world->awake_joints.count == 0 && world->direct_islands.count == 0) || world->settings.solver == CN_SOLVER_SOFT || cni_joint_lanes_need_no_plan(world))
		return;
	if (!cni_direct_plan(world, out)) {
		world->direct_failed = 1;
		world->warnings |= CN_WARNING_FRAME_MEMORY;
		return;
	}
	if (out->component_count == 0)
		return;
	s->direct = out;
	components_number(world, out);
	cni_components_judge(world, s, team);
	components_begin(world, s, out);
	cni_tree_batches_make(world, s, team);
	cni_components_list(out);
	cni_components_run(world, s, cni_components_team(world, out, 1), pending_begin, 0);
	cni_direct_contacts_extract(world, out);
	if (CNI_ON(JOINT_PROJECTION))
		cni_projection_mark(world, out);
	cni_heavy_contacts_find(world, s);
	world->direct_work = work_planned(world, out);
}

/* ---- a substep ---- */

/* No consistent set of contacts was found: contacts are soft until the step ends, and the joints are solved directly without them. Where
   the step had no work left to find one, the island is asked again in the next. */
static void contacts_release(cn_world *world, cni_sparse *sparse, cni_component *c)
{
	cni_direct_contacts_restore(world, sparse, c);
	for (int32_t k = c->begin; k < c->end; ++k)
		for (int32_t i = 0; sparse->nodes[k].owner < 0 && i < CNI_NODE_ROWS; ++i) {
			cni_levers_clear(&sparse->nodes[k].levers, i);
			sparse->nodes[k].x[i] = 0.0f;
		}
	c->has_contacts = 0;
	c->regular = c->loops ? CNI_REGULARIZATION_LOOPS : 0.0f;
	cni_sparse_factor(sparse, c, cni_motions(world));
	if (world->settings.solver == CN_SOLVER_AUTO && !c->denied)
		cni_island_refuse(world, cni_awake_island(world, sparse->bodies[c->body_begin]), CN_TIER_REASON_NO_SET);
}

void cni_direct_warm_start(cn_world *world, const cni_solve *s)
{
	cni_tree_batches_run(world, s, CNI_TREES_WARM);
}

static void component_pass(cn_world *world, const cni_solve *s, cni_component *c, int32_t bias)
{
	if (bias && c->batches)
		cni_tree_lane_lock(world, s, c, CNI_SNAP_RAD);
	if (c->done || c->batches)
		return;
	if (!bias && c->joints > 0)
		cni_direct_system(world, s, s->direct, c);
	if (c->has_contacts && !cni_direct_contacts_solve(world, s, s->direct, c, bias))
		contacts_release(world, s->direct, c);
	if (!c->has_contacts) {
		if (bias)
			cni_component_start(world, s->direct, c);
		cni_direct_right_sides(world, s, c, bias);
		cni_component_solve(world, s, c, bias);
	}
	if (bias && c->kind == CNI_NONE && !c->active) /* not arms at their limits, which would throw what lands on them */
		(void)cni_component_lock(world, s, c, CNI_SNAP_RAD);
}

void cni_direct_solve(cn_world *world, const cni_solve *s, int32_t bias)
{
	if (s->direct == NULL)
		return;
	cni_tree_batches_run(world, s, bias ? CNI_TREES_SOLVE : CNI_TREES_RELAX);
	cni_components_run(world, s, s->team, component_pass, bias);
	cni_components_give_up(world, s);
	cni_heavy_contacts_solve(world, s, bias);
}

void cni_direct_store(cn_world *world, const cni_solve *s)
{
	if (s->direct == NULL)
		return;
	for (cni_component *c = s->direct->components; c < s->direct->components + s->direct->component_count; ++c)
		if (!c->done && c->active == 2 && c->loops && c->regular > CNI_REGULARIZATION_LOOPS) /* its rows contradict each other */
			soften_for(world, s->direct, c, 0);
	cni_heavy_contacts_bounce(world, s);
	cni_direct_contacts_restore_all(world, s->direct, s->h);
}
