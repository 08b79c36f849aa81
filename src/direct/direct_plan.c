/*
 * direct/direct_plan.c - plans the direct solver's components of a step as links of linear/sparse.h, and bounds its scratch memory.
 *
 * Joints with rigid rows that nothing bounds or softens are nodes, and so are taut ropes and cylinders; those that share bodies form components.
 * CN_SOLVER_AUTO takes trees and components with few loops, whose factorization costs about as much as a pass over their joints; large nets
 * stay soft. CN_SOLVER_DIRECT takes all. Contacts are those of the islands that direct/solver_selection.c chose.
 *
 * Links beyond the limits of work are not planned: such joints are soft, and an island with unplanned contacts is refused; the rest is
 * planned once more without it.
 *
 * Reads joint constraints, motion and the tiers of islands; writes flags of joint constraints, refused islands, and the plans that the
 * world keeps.
 */
#include "contacts/contacts.h"
#include "direct/direct.h"
#include "direct/direct_contact.h"
#include "direct/direct_system.h"
#include "direct/heavy_contacts.h"

/* ---- limits, memory ---- */

/* Most work of a system, for each of its contacts. */
static int32_t contact_work(int32_t solver)
{
	return solver == CN_SOLVER_DIRECT ? 2000 : CNI_DIRECT_CONTACT_WORK;
}

/* Most work of a system, a joint of it: trees take 3 to 6, trusses 8 to 22, nets the more the larger they are. */
#define JOINT_WORK 16
#define JOINT_WORK_BRACED 24
#define JOINT_WORK_DIRECT 4000

static int32_t joint_work(int32_t solver)
{
	return solver == CN_SOLVER_DIRECT ? JOINT_WORK_DIRECT : JOINT_WORK_BRACED;
}

static int32_t contacts_taken(int32_t solver, int32_t contacts)
{
	return solver == CN_SOLVER_DIRECT ? contacts : cni_min_i(contacts, CNI_DIRECT_CONTACT_MOST);
}

static int64_t work_of(int32_t solver, int32_t joints, int32_t contacts)
{
	return (int64_t)joints * joint_work(solver) + (int64_t)contacts * contact_work(solver);
}

uint64_t cni_direct_kept_bytes(int32_t solver, int32_t joints, int32_t contacts)
{
	int32_t taken = contacts_taken(solver, contacts);
	if (joints + taken == 0 || solver == CN_SOLVER_SOFT || solver == CN_SOLVER_SEQUENTIAL)
		return 0;
	return cni_sparse_kept_bytes(joints + taken, work_of(solver, joints, taken)) + CNI_KEPT_BYTES;
}

uint64_t cni_direct_bytes(int32_t solver, int32_t joints, int32_t contacts, int32_t bodies)
{
	int32_t taken = contacts_taken(solver, contacts), links = joints + taken;
	int64_t work = work_of(solver, joints, taken);
	uint64_t link = sizeof(cni_link) + 4 * sizeof(cni_motion) + sizeof(cni_projection) + sizeof(int32_t) + 1;
	if (links == 0 || solver == CN_SOLVER_SOFT || solver == CN_SOLVER_SEQUENTIAL)
		return 0;
	return cni_tree_batch_bytes(joints) + link * (uint64_t)links + (sizeof(cni_direct_contact) + sizeof(int32_t)) * (uint64_t)taken +
	       2 * sizeof(cni_marked_lanes) * (uint64_t)contacts + (sizeof(float) + sizeof(cni_rot) + sizeof(int32_t)) * (uint64_t)(bodies + 1) + 896 + cni_heavy_bytes(contacts, joints) + cni_sparse_bytes(links, bodies + 1, work);
}

/* ---- joints ---- */

/* 1: single islands may take as much work as CN_SOLVER_DIRECT. A world in a caller's block has scratch memory for its own solver only. */
static int32_t full_work_is_allowed(const cn_world *world)
{
	return world->settings.solver == CN_SOLVER_DIRECT || !world->memory.fixed;
}

/* 1: a joint of its island asks for the limits of CN_SOLVER_DIRECT. */
static int32_t joint_has_full_work(const cn_world *world, const cni_joint_constraint *w)
{
	if (!world->overridden || !full_work_is_allowed(world))
		return 0;
	int32_t island = cni_joint_island(world, w->ia, w->ib);
	return island == CNI_NONE ? w->record->solver == CN_SOLVER_DIRECT : cni_island_at(world, island)->joints_solver == CN_SOLVER_DIRECT;
}

/* The flag `overridden` skips a test in worlds in which no joint ever had a solver of its own. */
static int32_t constraint_is_eligible(const cn_world *world, const cni_joint_constraint *w)
{
	int32_t left_soft = world->joints_soft_step > world->step_count && w->record->trust.soft && w->record->trust.until > world->step_count;
	if (!CNI_ON(DIRECT_JOINTS) || (world->overridden && w->record->solver == CN_SOLVER_SOFT))
		return 0;
	return (w->rigid_count > 0 || (w->flags & CNI_CONSTRAINT_TAUT)) && !left_soft && !(w->flags & (CNI_CONSTRAINT_SPRINGY | CNI_CONSTRAINT_BOUNDED));
}

static int32_t joint_links_collect(const cn_world *world, cni_link *links)
{
	int32_t count = 0;
	for (int32_t k = 0; k < world->awake_joints.count; ++k) {
		const cni_joint_constraint *w = cni_joint_constraints(world) + k;
		cni_link *link = &links[count];
		if (!constraint_is_eligible(world, w))
			continue;
		link->ia = w->ia;
		link->ib = w->ib;
		link->owner = k;
		link->rows = w->rigid_count;
		link->work_most = joint_has_full_work(world, w) ? JOINT_WORK_DIRECT : joint_work(world->settings.solver);
		++count;
	}
	return count;
}

/* ---- contacts ---- */

/* Lists the contacts of directly solved islands; refuses islands with too many contacts or with an unsupported kind. Returns their number. */
static int32_t contacts_collect(cn_world *world, int32_t *contacts, int32_t room)
{
	const int32_t *islands = (const int32_t *)world->direct_islands.data;
	int32_t all = 0;
	for (int32_t k = 0; k < world->direct_islands.count; ++k) {
		(void)cni_island_frame(world, cni_island_at(world, islands[k])); /* before forces act: its bodies would seem to move with what comes down on them */
		int32_t count = cni_direct_contacts_collect(world, islands[k], contacts + all, room - all);
		if (count < 0)
			cni_island_refuse(world, islands[k], -count);
		else
			all += count;
	}
	return all;
}

static int32_t island_of(const cn_world *world, const cni_link *link)
{
	return cni_joint_island(world, link->ia, link->ib);
}

static int32_t contact_link_work(const cn_world *world, const cni_link *link)
{
	int32_t most = world->overridden && full_work_is_allowed(world) && cni_island_at(world, island_of(world, link))->solver == CN_SOLVER_DIRECT;
	return contact_work(most ? CN_SOLVER_DIRECT : world->settings.solver);
}

static void contact_links_make(const cn_world *world, const int32_t *contacts, int32_t count, cni_link *links)
{
	for (int32_t k = 0; k < count; ++k) {
		int32_t slot = cni_contact_at(world, contacts[k])->slot;
		cni_link *link = &links[k];
		link->ia = cni_block_at(world, slot / CNI_LANES)->ia[slot % CNI_LANES];
		link->ib = cni_block_at(world, slot / CNI_LANES)->ib[slot % CNI_LANES];
		link->owner = -1 - k;
		link->rows = 3;
		link->work_most = contact_link_work(world, link);
	}
}

/* ---- planned and unplanned links ---- */

/* Refuses islands with unplanned contacts. Returns the number of unplanned contact links. */
static int32_t islands_refuse(cn_world *world, const cni_link *links, int32_t count, const uint8_t *planned)
{
	int32_t refused = 0;
	for (int32_t k = 0; k < count; ++k) {
		int32_t island = planned[k] || links[k].ia + links[k].ib == 0 ? CNI_NONE : island_of(world, &links[k]);
		if (island != CNI_NONE && cni_island_at(world, island)->tier == CNI_TIER_DIRECT)
			cni_island_refuse(world, island, CN_TIER_REASON_WORK);
		refused += !planned[k] && links[k].owner < 0;
	}
	return refused;
}

/* Removes the contacts of refused islands, so that their joints can be planned without them. */
static int32_t links_filter(const cn_world *world, cni_link *links, int32_t count)
{
	int32_t kept = 0;
	for (int32_t k = 0; k < count; ++k)
		if (links[k].owner >= 0 || cni_island_at(world, island_of(world, &links[k]))->tier == CNI_TIER_DIRECT)
			links[kept++] = links[k];
	return kept;
}

/* Rows of redundant joints that were solved directly have opposing impulses of any size, which only their system cancels. Soft constraints
   begin without them where it has become too large. */
static void impulses_forget(cn_world *world, cni_joint_constraint *w)
{
	cni_joint *j = cni_joint_at(world, w->joint);
	if (!j->trust.direct)
		return;
	j->trust.direct = 0;
	memset(j->impulse, 0, sizeof j->impulse);
	for (int32_t i = 0; i < w->row_count; ++i)
		w->rows[i].impulse = 0.0f;
}

/* Flags the joint constraints in the plan. */
static void joints_mark(cn_world *world, const cni_link *links, int32_t count, const uint8_t *planned)
{
	for (int32_t k = 0; k < count; ++k) {
		if (links[k].owner < 0)
			continue;
		if (planned[k])
			cni_joint_constraints(world)[links[k].owner].flags |= CNI_CONSTRAINT_DIRECT;
		else
			impulses_forget(world, cni_joint_constraints(world) + links[k].owner);
	}
}

/* A mechanism with so many loops that exact joints cost more than they are worth: the feet of walkers press what is under them. */
static int32_t is_costly(const cn_world *world, const cni_sparse *sparse, const cni_component *c)
{
	return c->loops && !c->has_contacts && c->work > JOINT_WORK * (c->end - c->begin) + 64 && world->settings.solver == CN_SOLVER_AUTO &&
	       !joint_has_full_work(world, cni_joint_constraints(world) + sparse->nodes[c->begin].owner) && !cni_component_is_braced(c, cni_component_held(world, sparse, c));
}

/* Nodes without rows of their own are ropes or cylinders. */
static int16_t ropes_are_in(const cn_world *world, const cni_sparse *sparse, const cni_component *c)
{
	for (int32_t k = c->begin; k < c->end; ++k)
		if (sparse->nodes[k].owner >= 0 && cni_joint_is_rope(cni_joint_constraints(world)[sparse->nodes[k].owner].record))
			return 1;
	return 0;
}

static void costly_release(cn_world *world, cni_sparse *sparse, cni_component *c)
{
	for (int32_t k = c->begin; k < c->end; ++k)
		impulses_forget(world, cni_joint_constraints(world) + sparse->nodes[k].owner);
	cni_component_release(world, sparse, c);
}

/* Reads the contacts of a component's nodes in their order, and renumbers them. */
static void contacts_read(const cn_world *world, const int32_t *contacts, cni_sparse *out, cni_component *c)
{
	c->contact_begin = out->contact_count;
	for (int32_t k = c->begin; k < c->end && c->has_contacts; ++k) {
		cni_direct_contact *p = &out->contacts[out->contact_count];
		if (out->nodes[k].owner >= 0)
			continue;
		cni_direct_contact_read(world, cni_contact_at(world, contacts[-1 - out->nodes[k].owner]), p);
		p->node = k;
		out->nodes[k].owner = -1 - out->contact_count++;
	}
	c->contact_end = out->contact_count;
}

/* Most contacts that are collected. */
static int32_t contacts_most(const cn_world *world)
{
	int32_t all = world->settings.solver == CN_SOLVER_DIRECT || (world->overridden && full_work_is_allowed(world));
	if (world->direct_islands.count == 0)
		return 0;
	return all ? world->touching_count : cni_min_i(world->touching_count, CNI_DIRECT_CONTACT_MOST);
}

/* again 1: without the refused links. A world in a caller's block has room for one kept plan. */
static int32_t links_plan(cn_world *world, const cni_link *links, int32_t count, int32_t again, cni_sparse *out, uint8_t *planned)
{
	cni_array *kept = &world->direct_plans[again && !world->memory.fixed];
	int32_t budget = world->settings.work_budget; /* of a substep, for one factorization */
	int64_t most = budget == 0 || world->settings.solver == CN_SOLVER_DIRECT ? INT64_MAX : budget / world->settings.substeps;
	cni_system system = { links, count, world->awake_count, cni_motions(world), most };
	return cni_sparse_plan(&world->arena, kept, &system, out, planned);
}

/* ---- the plan ---- */

/* Scratch arrays of the step beside the plan. 0: no scratch memory. contacts: most contacts of the plan. */
static int32_t scratch_take(cn_world *world, cni_sparse *out, int32_t contacts)
{
	cni_arena *arena = &world->arena;
	uint64_t bodies = (uint64_t)world->awake_count;
	out->contacts = (cni_direct_contact *)cni_arena_push(arena, sizeof(cni_direct_contact) * (uint64_t)contacts);
	out->saved = (cni_motion *)cni_arena_push(arena, sizeof(cni_motion) * (uint64_t)out->body_count);
	out->begun = (cni_motion *)cni_arena_push(arena, sizeof(cni_motion) * (uint64_t)out->body_count);
	out->pull = (float *)cni_arena_push(arena, sizeof(float) * bodies);
	out->turn = (cni_rot *)cni_arena_push(arena, sizeof(cni_rot) * bodies);
	out->projections = (cni_projection *)cni_arena_push(arena, sizeof(cni_projection) * (uint64_t)out->component_count);
	out->projection_marks = (cni_marked_lanes *)cni_arena_push(arena, 2 * sizeof(cni_marked_lanes) * (uint64_t)world->touching_count); /* each at two bodies */
	out->component_of = (int32_t *)cni_arena_push(arena, sizeof(int32_t) * bodies);
	out->alone = (int32_t *)cni_arena_push(arena, sizeof(int32_t) * (uint64_t)out->component_count);
	if (out->turn != NULL)
		out->turn[0] = cni_rot_small(0.0f); /* of static bodies */
	out->heavies = (cni_heavy_contact *)cni_arena_push(arena, sizeof(cni_heavy_contact) * (uint64_t)cni_heavy_contacts_room(world->touching_count, world->awake_joints.count));
	return out->contacts != NULL && out->heavies != NULL && out->alone != NULL && out->saved != NULL && out->begun != NULL && out->pull != NULL && out->turn != NULL && out->projections != NULL && out->projection_marks != NULL && out->component_of != NULL;
}

int32_t cni_direct_plan(cn_world *world, cni_sparse *out)
{
	int32_t room = contacts_most(world), joints = world->awake_joints.count, contact_count, count;
	int32_t *contacts = (int32_t *)cni_arena_push(&world->arena, sizeof(int32_t) * (uint64_t)room);
	if (contacts == NULL)
		return 0;
	contact_count = contacts_collect(world, contacts, room);
	cni_link *links = (cni_link *)cni_arena_push(&world->arena, sizeof(cni_link) * (uint64_t)(joints + contact_count));
	uint8_t *planned = links == NULL ? NULL : (uint8_t *)cni_arena_push(&world->arena, (uint64_t)(joints + contact_count));
	if (planned == NULL)
		return 0;
	count = joint_links_collect(world, links);
	contact_links_make(world, contacts, contact_count, links + count);
	count += contact_count;
	if (count == 0)
		return 1;
	if (!links_plan(world, links, count, 0, out, planned))
		return 0;
	if (islands_refuse(world, links, count, planned) > 0) {
		cni_sparse_discard(&world->arena, out);
		count = links_filter(world, links, count);
		if (count == 0)
			return 1;
		if (!links_plan(world, links, count, 1, out, planned))
			return 0;
		(void)islands_refuse(world, links, count, planned); /* joints without their contacts may have taken the budget of others */
	}
	if (!scratch_take(world, out, contact_count))
		return 0;
	joints_mark(world, links, count, planned);
	for (int32_t k = 0; k < out->component_count; ++k) {
		cni_component *c = &out->components[k];
		c->has_contacts = c->joints < c->end - c->begin;
		c->has_ropes = c->has_ropes && ropes_are_in(world, out, c);
		contacts_read(world, contacts, out, c);
		if (is_costly(world, out, c))
			costly_release(world, out, c);
	}
	return 1;
}
