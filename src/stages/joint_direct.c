/*
 * stages/joint_direct.c - rigid rows of connected joints solved together, exactly (stages/sparse.h).
 *
 * Joints with rigid rows that nothing bounds or softens are nodes; those that share bodies make components.
 * CN_SOLVER_AUTO takes trees, whose factorization costs about what a pass over their joints does, and large nets once
 * (stages/joint_net.c).
 * CN_SOLVER_DIRECT takes all. The rest, and springs, motors and limits, are solved row by row in stages/joint_solve.c,
 * before; contacts come after, so joints and contacts alternate, where they disagree more than once: stages/joint_close.c.
 *
 * Loops of pins, and what they carry, are the soft solver's until they come apart by more than is good; then they are
 * solved with their contacts, those of them that are few: stages/contact_joined.c.
 *
 * Reads works, motion and inverse masses; writes works' flags and their rigid rows' impulses, motion velocities.
 */
#include "stages/press.h"
#include "stages/joint_work.h"

#include <string.h>

/* Loops, the two points of a contact, and piles with several ways to bear the same say much twice: their diagonal grows by
   this part. */
#define REGULAR 1e-4f

/* Most work of a system for each contact of it. */
static int32_t press_work(int32_t solver)
{
	return solver == CN_SOLVER_DIRECT ? 2000 : CNI_PRESS_WORK;
}

/* Most work of a system, a joint of it: trees take 3 to 6. */
#define JOINT_WORK 16
#define JOINT_WORK_DIRECT 4000
/* A dear system is solved once, in one substep, and then not again for so long that it is no more work than this a step
   for each of its nodes, in the mean. */
#define DEAR_SPREAD 8

static int32_t joint_work(int32_t solver)
{
	return solver == CN_SOLVER_DIRECT ? JOINT_WORK_DIRECT : JOINT_WORK;
}

static int32_t presses_of(int32_t solver, int32_t contacts)
{
	return solver == CN_SOLVER_DIRECT ? contacts : cni_min_i(contacts, CNI_PRESS_MOST);
}

static int64_t work_of(int32_t solver, int32_t joints, int32_t presses)
{
	return (int64_t)joints * joint_work(solver) + (int64_t)presses * press_work(solver);
}

uint64_t cni_direct_kept_bytes(int32_t solver, int32_t joints, int32_t contacts)
{
	int32_t presses = presses_of(solver, contacts);
	if (joints + presses == 0 || solver == CN_SOLVER_SOFT || solver == CN_SOLVER_SEQUENTIAL)
		return 0;
	return cni_sparse_kept_bytes(joints + presses, work_of(solver, joints, presses)) + CNI_KEPT_BYTES;
}

uint64_t cni_direct_bytes(int32_t solver, int32_t joints, int32_t contacts, int32_t bodies)
{
	int32_t presses = presses_of(solver, contacts), links = joints + presses;
	int64_t work = work_of(solver, joints, presses);
	uint64_t joint = 1 + sizeof(float) * CNI_NODE_ROWS, link = sizeof(cni_link) + 2 * sizeof(cni_motion) + sizeof(cni_closer) + 1;
	if (links == 0 || solver == CN_SOLVER_SOFT || solver == CN_SOLVER_SEQUENTIAL)
		return 0;
	return cni_joined_bytes(joints, contacts) + joint * (uint64_t)joints + link * (uint64_t)links + sizeof(cni_press) * (uint64_t)presses +
	       2 * sizeof(int32_t) * (uint64_t)contacts + (sizeof(float) + sizeof(cni_rot) + sizeof(int32_t)) * (uint64_t)(bodies + 1) + 832 + cni_herd_bytes(joints) + cni_sparse_bytes(links, bodies + 1, work);
}

static int32_t body_is_locked(const cn_world *world, int32_t index)
{
	return (cni_drives(world)[index].flags & (CNI_DRIVE_LOCK_X | CNI_DRIVE_LOCK_Y)) != 0;
}

/* May what asks for it take as much as CN_SOLVER_DIRECT? A world in a caller's block has scratch memory for its own solver only. */
static int32_t may_take_most(const cn_world *world)
{
	return world->settings.solver == CN_SOLVER_DIRECT || !world->memory.fixed;
}

/* Worlds in which no joint ever had a solver of its own do not look. */
static int32_t joint_stays_soft(const cn_world *world, const cni_joint_work *w)
{
	return world->overridden && w->record->solver == CN_SOLVER_SOFT;
}

/* Does some joint of its island ask for all that CN_SOLVER_DIRECT allows? */
static int32_t joint_may_take_most(const cn_world *world, const cni_joint_work *w)
{
	int32_t island;
	if (!world->overridden || !may_take_most(world))
		return 0;
	island = cni_joint_island(world, w->ia, w->ib);
	return island == CNI_NONE ? w->record->solver == CN_SOLVER_DIRECT : cni_island_at(world, island)->joints_solver == CN_SOLVER_DIRECT;
}

static int32_t is_left_soft(const cn_world *world, const cni_joint_work *w)
{
	int32_t island;
	if (world->joints_soft_step <= world->step_count)
		return 0;
	island = cni_joint_island(world, w->ia, w->ib);
	return island != CNI_NONE && cni_island_at(world, island)->joints_soft_step > world->step_count;
}

static int32_t work_is_eligible(const cn_world *world, const cni_joint_work *w)
{
	if (joint_stays_soft(world, w))
		return 0;
	return w->rigid_count > 0 && !is_left_soft(world, w) && !(w->flags & (CNI_WORK_SPRINGY | CNI_WORK_BOUNDED)) &&
	       !(w->ia != 0 && body_is_locked(world, w->ia)) && !(w->ib != 0 && body_is_locked(world, w->ib));
}

static int32_t is_in_direct_island(const cn_world *world, const cni_joint_work *w)
{
	int32_t island;
	if (world->direct_islands.count == 0)
		return 0;
	island = cni_joint_island(world, w->ia, w->ib);
	return island != CNI_NONE && cni_island_at(world, island)->tier == CNI_TIER_DIRECT;
}

static int32_t joint_links_collect(const cn_world *world, cni_link *links)
{
	int32_t k, count = 0;
	for (k = 0; k < world->awake_joints.count; ++k) {
		const cni_joint_work *w = cni_joint_works(world) + k;
		cni_link *link = &links[count];
		if (!work_is_eligible(world, w))
			continue;
		link->ia = w->ia;
		link->ib = w->ib;
		link->owner = k;
		link->rows = w->rigid_count;
		link->work_most = is_in_direct_island(world, w) || joint_may_take_most(world, w) ? JOINT_WORK_DIRECT : joint_work(world->settings.solver);
		++count;
	}
	return count;
}

/* A net, which is solved directly for its joints' sake. */
static int32_t takes_joints_alone(const cn_world *world, int32_t island)
{
	return cni_island_at(world, island)->solver != CN_SOLVER_DIRECT && cni_island_has_joints(world, island);
}

/* Contacts of the islands that are solved directly; an island that has too many, or of the wrong kind, is refused. */
static void presses_collect(cn_world *world, cni_press *presses, int32_t room, cni_sparse *out)
{
	const int32_t *islands = (const int32_t *)world->direct_islands.data;
	int32_t k;
	out->presses = presses;
	for (k = 0; k < world->direct_islands.count; ++k) {
		int32_t count;
		if (takes_joints_alone(world, islands[k]))
			continue;
		count = cni_presses_collect(world, islands[k], presses + out->press_count, room - out->press_count);
		if (count < 0)
			cni_island_refuse(world, islands[k], count == CNI_PRESSES_MANY ? CN_TIER_REASON_CROWDED : CN_TIER_REASON_KIND);
		else
			out->press_count += count;
	}
}

static int32_t island_of(const cn_world *world, const cni_link *link)
{
	return cni_joint_island(world, link->ia, link->ib);
}

static int32_t press_link_work(const cn_world *world, const cni_link *link)
{
	int32_t most = world->overridden && may_take_most(world) && cni_island_at(world, island_of(world, link))->solver == CN_SOLVER_DIRECT;
	return press_work(most ? CN_SOLVER_DIRECT : world->settings.solver);
}

static int32_t press_links_collect(const cn_world *world, const cni_sparse *sparse, cni_link *links)
{
	int32_t k;
	for (k = 0; k < sparse->press_count; ++k) {
		const cni_press *p = &sparse->presses[k];
		cni_link *link = &links[k];
		link->ia = cni_block_at(world, p->block)->ia[p->lane];
		link->ib = cni_block_at(world, p->block)->ib[p->lane];
		link->owner = -1 - k;
		link->rows = 3;
		link->work_most = press_link_work(world, link);
	}
	return sparse->press_count;
}

/* Refuses the islands whose contacts are not in the plan. Returns how many links of them there are. */
static int32_t islands_refuse(cn_world *world, const cni_link *links, int32_t count, const uint8_t *planned)
{
	int32_t k, refused = 0;
	for (k = 0; k < count; ++k) {
		int32_t island = planned[k] || links[k].ia + links[k].ib == 0 ? CNI_NONE : island_of(world, &links[k]);
		if (island != CNI_NONE && cni_island_at(world, island)->tier == CNI_TIER_DIRECT)
			cni_island_refuse(world, island, CN_TIER_REASON_WORK);
		refused += !planned[k] && links[k].owner < 0;
	}
	return refused;
}

/* Takes out the contacts of refused islands, so that their joints can be planned without them. */
static int32_t links_keep(const cn_world *world, cni_link *links, int32_t count)
{
	int32_t k, kept = 0;
	for (k = 0; k < count; ++k)
		if (links[k].owner >= 0 || cni_island_at(world, island_of(world, &links[k]))->tier == CNI_TIER_DIRECT)
			links[kept++] = links[k];
	return kept;
}

/* Who is in the plan knows it. */
static void owners_tell(cn_world *world, const cni_solve *s, const cni_link *links, int32_t count, const uint8_t *planned, cni_sparse *out)
{
	int32_t k;
	for (k = 0; k < count; ++k)
		if (planned[k] && links[k].owner >= 0) {
			cni_joint_work *w = cni_joint_works(world) + links[k].owner;
			w->flags |= CNI_WORK_DIRECT;
			if (w->form != 0)
				cni_joint_rows_begin(world, s, w);
		}
	for (k = 0; k < out->node_count; ++k)
		if (out->nodes[k].owner < 0)
			out->presses[-1 - out->nodes[k].owner].node = k;
}

/* One factorization a substep. */
static int64_t budget_of(const cn_world *world)
{
	int32_t budget = world->settings.work_budget;
	return budget == 0 || world->settings.solver == CN_SOLVER_DIRECT ? INT64_MAX : budget / world->settings.substeps;
}

/* Most contacts that are looked at. */
static int32_t presses_most(const cn_world *world)
{
	int32_t all = world->settings.solver == CN_SOLVER_DIRECT || (world->overridden && may_take_most(world));
	if (world->direct_islands.count == 0)
		return 0;
	return all ? world->touching_count : cni_min_i(world->touching_count, CNI_PRESS_MOST);
}

/* again: without what was refused. A world in a caller's block has set aside room for one kept plan. */
static int32_t links_plan(cn_world *world, const cni_link *links, int32_t count, int32_t again, cni_sparse *out, uint8_t *planned)
{
	cni_array *kept = &world->direct_plans[again && !world->memory.fixed];
	cni_system system = { links, count, world->awake_count, cni_motions(world), budget_of(world), world->settings.solver == CN_SOLVER_AUTO, 0 };
	return cni_sparse_plan(&world->arena, kept, &system, out, planned);
}

/* Nets that were not planned for their work, and have new joints: they begin to bear in this step, and are best solved
   before anything has come apart. Returns how many links may now take the work. */
static int32_t nets_take(cn_world *world, cni_link *links, int32_t count, const uint8_t *planned)
{
	int32_t k, taken = 0;
	for (k = 0; k < count && world->settings.solver == CN_SOLVER_AUTO; ++k) {
		const cni_joint_work *w;
		if (planned[k] || links[k].owner < 0)
			continue;
		w = cni_joint_works(world) + links[k].owner;
		if ((w->flags & CNI_WORK_FRESH) && island_of(world, &links[k]) != CNI_NONE && !is_in_direct_island(world, w))
			cni_island_joints_part(world, island_of(world, &links[k]));
		if (is_in_direct_island(world, w)) {
			links[k].work_most = JOINT_WORK_DIRECT;
			++taken;
		}
	}
	return taken;
}

/* What is of the step beside the plan. 0: no scratch memory. */
static int32_t lists_take(cn_world *world, cni_sparse *out)
{
	cni_arena *arena = &world->arena;
	uint64_t bodies = (uint64_t)world->awake_count;
	out->saved = (cni_motion *)cni_arena_push(arena, sizeof(cni_motion) * (uint64_t)out->body_count);
	out->pull = (float *)cni_arena_push(arena, sizeof(float) * bodies);
	out->turn = (cni_rot *)cni_arena_push(arena, sizeof(cni_rot) * bodies);
	out->closers = (cni_closer *)cni_arena_push(arena, sizeof(cni_closer) * (uint64_t)out->component_count);
	out->closer_slots = (int32_t *)cni_arena_push(arena, 2 * sizeof(int32_t) * (uint64_t)world->touching_count); /* each at two bodies */
	out->closer_of = (int32_t *)cni_arena_push(arena, sizeof(int32_t) * bodies);
	return out->saved != NULL && out->pull != NULL && out->turn != NULL && out->closers != NULL && out->closer_slots != NULL && out->closer_of != NULL;
}

/* 0: no scratch memory. */
static int32_t plan(cn_world *world, const cni_solve *s, cni_sparse *out)
{
	int32_t room = presses_most(world);
	int32_t joints = world->awake_joints.count, count;
	cni_press *presses = (cni_press *)cni_arena_push(&world->arena, sizeof(cni_press) * (uint64_t)room);
	cni_link *links;
	uint8_t *planned;
	if (presses == NULL)
		return 0;
	presses_collect(world, presses, room, out);
	links = (cni_link *)cni_arena_push(&world->arena, sizeof(cni_link) * (uint64_t)(joints + out->press_count));
	planned = links == NULL ? NULL : (uint8_t *)cni_arena_push(&world->arena, (uint64_t)(joints + out->press_count));
	if (planned == NULL)
		return 0;
	count = joint_links_collect(world, links);
	count += press_links_collect(world, out, links + count);
	if (count == 0)
		return 1;
	if (!links_plan(world, links, count, 0, out, planned))
		return 0;
	if (islands_refuse(world, links, count, planned) > 0 || nets_take(world, links, count, planned) > 0) {
		cni_sparse_discard(&world->arena, out);
		count = links_keep(world, links, count);
		if (count == 0)
			return 1;
		if (!links_plan(world, links, count, 1, out, planned))
			return 0;
		(void)islands_refuse(world, links, count, planned); /* joints that are alone now may have spent the budget before them */
	}
	owners_tell(world, s, links, count, planned, out);
	return lists_take(world, out);
}

void cni_direct_motions_keep(const cn_world *world, const cni_sparse *sparse, const cni_component *c, int32_t back)
{
	int32_t k;
	for (k = c->body_begin; k < c->body_end; ++k) {
		cni_motion *m = cni_motions(world) + sparse->bodies[k], *saved = sparse->saved + k;
		*(back ? m : saved) = *(back ? saved : m);
	}
}

void cni_direct_turns(const cn_world *world, cni_sparse *sparse, const cni_component *c)
{
	int32_t k;
	sparse->turn[0] = cni_rot_small(0.0f);
	for (k = c->begin; k < c->end; ++k) { /* kinematic ones too, which are no bodies of the component */
		const cni_node *n = &sparse->nodes[k];
		if (cni_motions(world)[n->ia].inv_mass == 0.0f)
			sparse->turn[n->ia] = cni_rot_small(cni_motions(world)[n->ia].theta);
		if (cni_motions(world)[n->ib].inv_mass == 0.0f)
			sparse->turn[n->ib] = cni_rot_small(cni_motions(world)[n->ib].theta);
	}
	for (k = c->body_begin; k < c->body_end; ++k)
		sparse->turn[sparse->bodies[k]] = cni_rot_small(cni_motions(world)[sparse->bodies[k]].theta);
}

/* Nothing is solved directly after all. */
static void works_release(cn_world *world)
{
	int32_t k;
	for (k = 0; k < world->awake_joints.count; ++k)
		cni_joint_works(world)[k].flags &= ~(uint32_t)CNI_WORK_DIRECT;
}

/* Each joint by itself after all, in this step. */
static void joints_release(cn_world *world, cni_sparse *sparse, cni_component *c)
{
	int32_t k;
	++sparse->released;
	for (k = c->begin; k < c->end; ++k)
		if (sparse->nodes[k].owner >= 0)
			cni_joint_works(world)[sparse->nodes[k].owner].flags &= ~(uint32_t)CNI_WORK_DIRECT;
	c->swings = 0;
	c->done = 1;
}

int32_t cni_direct_levers(const cn_world *world, cni_sparse *sparse, const cni_component *c)
{
	int32_t k, i, joints = 0;
	for (k = c->begin; k < c->end; ++k) {
		cni_node *n = &sparse->nodes[k];
		const cni_row *rows;
		if (n->owner < 0)
			continue;
		++joints;
		rows = cni_joint_works(world)[n->owner].rows;
		for (i = 0; i < n->rows; ++i)
			n->lever[i] = cni_row_lever(&rows[i]);
	}
	return joints;
}

void cni_direct_refresh(cn_world *world, cni_sparse *sparse, const cni_component *c)
{
	(void)cni_direct_levers(world, sparse, c);
	cni_sparse_factor(sparse, c, cni_motions(world));
}

void cni_direct_begin(cn_world *world, const cni_solve *s, cni_sparse *sparse, cni_component *c)
{
	cni_joint_works_complete(world, s, sparse, c);
	cni_sparse_clear(sparse, c);
	cni_direct_turns(world, sparse, c);
	cni_tension_find(world, sparse, c, s->h);
	if (cni_tension_needs_dampers(world, sparse, c, s->h))
		c->width = CNI_NODE_ROWS;
	cni_tension_damp(world, sparse, c, s->h);
	c->joints = cni_direct_levers(world, sparse, c);
	if (!c->presses)
		cni_sparse_factor(sparse, c, cni_motions(world));
}

static int32_t component_has_presses(const cni_sparse *sparse, const cni_component *c)
{
	int32_t k;
	for (k = c->begin; k < c->end; ++k)
		if (sparse->nodes[k].owner < 0)
			return 1;
	return 0;
}

/* In a step, in the units of work_budget. */
static int32_t work_planned(const cn_world *world, const cni_sparse *sparse)
{
	int64_t work = 0;
	int32_t k;
	for (k = 0; k < sparse->component_count; ++k) {
		const cni_component *c = &sparse->components[k];
		if (!c->done)
			work += (int64_t)c->work * (c->dear && c->swings ? 1 : world->settings.substeps);
	}
	return work < INT32_MAX ? (int32_t)work : INT32_MAX;
}

/* Does some joint of it ask to be solved directly? Of components with several bodies. */
static int32_t is_asked_for(const cn_world *world, const cni_sparse *sparse, const cni_component *c)
{
	int32_t island = cni_awake_island(world, sparse->bodies[c->body_begin]);
	return island != CNI_NONE && cni_island_at(world, island)->joints_solver == CN_SOLVER_DIRECT;
}

/*
 * A loop of pins, such as a bridge between two walls, may be so straight that no force can hold it: what is rigid
 * explodes there, and what gives way a little stands. Trees have no such places, nor have loops by gears.
 */
static int32_t loop_is_better_soft(const cn_world *world, const cni_sparse *sparse, const cni_component *c)
{
	int32_t k;
	if (c->body_begin == c->body_end)
		return 1; /* of bodies that cannot move */
	if (world->settings.solver != CN_SOLVER_AUTO || !c->loops || c->dear || c->presses || is_asked_for(world, sparse, c) || cni_component_is_joined(world, sparse, c))
		return 0;
	for (k = c->begin; k < c->end; ++k)
		if (sparse->nodes[k].rows != 2)
			return 0;
	return 1;
}

/* Joints to the world alone, and large nets that other things hold too. */
static int32_t is_better_alone(const cni_component *c)
{
	return !c->swings && !c->presses && (c->dear || (c->end - c->begin == 1 && c->body_end - c->body_begin == 1));
}

static void prepare(cn_world *world, cni_solve *s, cni_sparse *out)
{
	int32_t k, far = cni_joints_are_far(world);
	memset(out, 0, sizeof *out);
	if ((world->awake_joints.count == 0 && world->direct_islands.count == 0) || world->settings.solver == CN_SOLVER_SOFT)
		return;
	if (!plan(world, s, out)) {
		works_release(world);
		world->direct_failed = 1;
		world->warnings |= CN_WARNING_FRAME_MEMORY;
		return;
	}
	if (out->component_count == 0)
		return;
	s->direct = out;
	if (!cni_joined_collect(world, out))
		world->warnings |= CN_WARNING_FRAME_MEMORY;
	for (k = 0; k < out->component_count; ++k) {
		cni_component *c = &out->components[k];
		if (far && k + 1 < out->component_count)
			cni_component_prefetch(world, out, k + 1);
		c->presses = component_has_presses(out, c);
		if (c->dear && world->settings.solver == CN_SOLVER_AUTO)
			cni_island_once(world, cni_awake_island(world, out->bodies[c->body_begin]), c->work / (DEAR_SPREAD * (c->end - c->begin)));
		c->regular = c->presses || c->loops ? REGULAR : 0.0f;
		c->swings = !c->presses && !(c->loops && cni_component_is_joined(world, out, c)) && cni_component_swings(world, s, out, c);
		if (loop_is_better_soft(world, out, c) || is_better_alone(c))
			joints_release(world, out, c);
		else if (c->swings)
			cni_sparse_clear(out, c);
		else if (!(c->herds = !cni_component_is_joined(world, out, c) && cni_component_herds(world, s, out, c)))
			cni_direct_begin(world, s, out, c);
	}
	cni_herds_make(world, s, out);
	cni_presses_take(world, out);
	cni_joined_take(world, out);
	cni_close_mark(world, out);
	world->direct_work = work_planned(world, out);
}

void cni_direct_prepare(cn_world *world, cni_solve *s, cni_sparse *out)
{
	prepare(world, s, out);
	cni_joined_let_go(world);
}

/* Both bodies are read once and written once: a node's two bodies are never the same. */
CNI_INLINE void nodes_push(cn_world *world, const cni_sparse *sparse, const cni_component *c, int32_t width)
{
	cni_motion *motions = cni_motions(world);
	cni_joint_work *works = cni_joint_works(world);
	int32_t k, i;
	for (k = c->begin; k < c->end; ++k) {
		const cni_node *n = &sparse->nodes[k];
		cni_motion a = motions[n->ia], b = motions[n->ib];
		if (n->owner < 0)
			continue;
		for (i = 0; i < n->rows; ++i)
			works[n->owner].rows[i].impulse += n->x[i];
		for (i = 0; i < width; ++i)
			cni_lever_push(&n->lever[i], n->x[i], &a, &b);
		motions[n->ia] = a;
		motions[n->ib] = b;
	}
}

void cni_direct_push(cn_world *world, const cni_sparse *sparse, const cni_component *c)
{
	if (c->width == 2)
		nodes_push(world, sparse, c, 2);
	else
		nodes_push(world, sparse, c, CNI_NODE_ROWS);
}

CNI_INLINE void speeds_read(const cn_world *world, cni_sparse *sparse, const cni_component *c, float rate, float push, int32_t width)
{
	const cni_motion *motions = cni_motions(world);
	const cni_joint_work *works = cni_joint_works(world);
	int32_t k, i;
	for (k = c->begin; k < c->end; ++k) {
		cni_node *n = &sparse->nodes[k];
		const cni_motion *a = motions + n->ia, *b = motions + n->ib;
		if (n->owner < 0)
			continue;
		for (i = 0; i < width; ++i)
			n->x[i] = -cni_lever_speed(&n->lever[i], a, b) - (i < n->rows ? cni_clamp(rate * works[n->owner].rows[i].error, -push, push) : 0.0f);
	}
}

static void right_sides(const cn_world *world, cni_sparse *sparse, const cni_component *c, float rate, float push)
{
	if (c->width == 2)
		speeds_read(world, sparse, c, rate, push, 2);
	else
		speeds_read(world, sparse, c, rate, push, CNI_NODE_ROWS);
}

/* No consistent set of contacts: they are the soft solver's until the step ends, the joints go on alone. */
static void component_release(cn_world *world, cni_sparse *sparse, cni_component *c)
{
	int32_t k, i;
	cni_presses_give_back(world, sparse, c);
	for (k = c->begin; k < c->end; ++k)
		for (i = 0; sparse->nodes[k].owner < 0 && i < CNI_NODE_ROWS; ++i) {
			memset(&sparse->nodes[k].lever[i], 0, sizeof sparse->nodes[k].lever[i]);
			sparse->nodes[k].x[i] = 0.0f;
		}
	c->presses = 0;
	c->regular = c->loops ? REGULAR : 0.0f;
	cni_sparse_factor(sparse, c, cni_motions(world));
	if (world->settings.solver == CN_SOLVER_AUTO)
		cni_island_refuse(world, cni_awake_island(world, sparse->bodies[c->body_begin]), CN_TIER_REASON_NO_SET);
}

void cni_direct_sides(cn_world *world, const cni_solve *s, const cni_component *c, int32_t bias)
{
	right_sides(world, s->direct, c, bias ? CNI_JOINT_ERROR_RATE * s->inv_h : 0.0f, s->push_speed);
}

void cni_direct_answer(cn_world *world, const cni_solve *s, cni_component *c)
{
	if (cni_sparse_solve(s->direct, c))
		cni_direct_push(world, s->direct, c);
	else
		joints_release(world, s->direct, c);
}

void cni_direct_joints(cn_world *world, const cni_solve *s, cni_component *c, int32_t bias)
{
	cni_direct_sides(world, s, c, bias);
	cni_direct_answer(world, s, c);
}

/* The same levers at the new positions. */
static void component_turn(cn_world *world, const cni_solve *s, cni_component *c)
{
	cni_direct_turns(world, s->direct, c);
	cni_tension_damp(world, s->direct, c, s->h);
	(void)cni_direct_levers(world, s->direct, c);
	if (c->presses)
		c->factored = 0;
	else
		cni_sparse_factor(s->direct, c, cni_motions(world));
}

void cni_direct_solve(cn_world *world, const cni_solve *s, int32_t bias)
{
	int32_t k;
	for (k = 0; s->direct != NULL && k < s->direct->component_count; ++k) {
		cni_component *c = &s->direct->components[k];
		if (c->done || c->herds)
			continue;
		if (!bias && c->joints > 0)
			component_turn(world, s, c);
		if (c->presses && !cni_presses_solve(world, s, s->direct, c, bias))
			component_release(world, s->direct, c);
		if (!c->presses)
			cni_direct_joints(world, s, c, bias);
	}
	for (k = 0; s->direct != NULL && k < s->direct->joined_count; ++k)
		cni_joined_round(world, s, &s->direct->joined[k], bias);
}

void cni_direct_store(cn_world *world, const cni_solve *s)
{
	if (s->direct == NULL)
		return;
	cni_presses_give_back_all(world, s->direct, s->h);
	cni_joined_look(world, s);
	cni_joined_give_back(world, s->direct);
}
