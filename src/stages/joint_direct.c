/*
 * stages/joint_direct.c - rigid rows of connected joints solved together, exactly (stages/sparse.h).
 *
 * Joints with rigid rows that nothing bounds or softens are nodes; those that share bodies make components.
 * CN_SOLVER_AUTO takes the components whose factorization costs about what a pass over their joints does: all
 * trees, small nets. CN_SOLVER_DIRECT takes all. The rest, and springs, motors and limits, are solved row by row in
 * stages/joint_solve.c, before; contacts come after, so joints and contacts alternate.
 *
 * Reads works, motion and inverse masses; writes works' flags and their rigid rows' impulses, motion velocities.
 */
#include "stages/contact_direct.h"
#include "stages/joint_work.h"

#include <string.h>

#define ERROR_RATE 0.3f        /* part of the error that is taken out in a substep */
#define PRESSES_REGULAR 1e-4f  /* two points of a contact, piles of several ways to bear the same, say much twice */
#define LOOPS_REGULAR 1e-5f    /* loops may say the same twice: their diagonal grows by this part */

/* Most work of a system for each contact of it. */
static int32_t press_work(int32_t solver)
{
	return solver == CN_SOLVER_DIRECT ? 2000 : CNI_PRESS_WORK;
}

/* Most work of a system, a joint of it: trees take 3 to 6. */
#define JOINT_WORK 16
#define JOINT_WORK_DIRECT 2000

static int32_t joint_work(int32_t solver)
{
	return solver == CN_SOLVER_DIRECT ? JOINT_WORK_DIRECT : JOINT_WORK;
}

uint64_t cni_direct_bytes(int32_t solver, int32_t joints, int32_t contacts, int32_t bodies)
{
	int32_t presses = solver == CN_SOLVER_DIRECT ? contacts : cni_min_i(contacts, CNI_PRESS_MOST), links = joints + presses;
	int64_t work = (int64_t)joints * joint_work(solver) + (int64_t)presses * press_work(solver);
	uint64_t joint = 1 + sizeof(float) * CNI_NODE_ROWS + 2 * sizeof(cni_motion), link = sizeof(cni_link) + 2 * sizeof(cni_motion) + 1;
	if (links == 0 || solver == CN_SOLVER_SOFT || solver == CN_SOLVER_SEQUENTIAL)
		return 0;
	return joint * (uint64_t)joints + link * (uint64_t)links + sizeof(cni_press) * (uint64_t)presses +
	       (sizeof(float) + sizeof(cni_rot)) * (uint64_t)(bodies + 1) + 640 + cni_sparse_bytes(links, bodies + 1, work);
}

static int32_t body_is_locked(const cn_world *world, int32_t index)
{
	return (cni_drives(world)[index].flags & (CNI_DRIVE_LOCK_X | CNI_DRIVE_LOCK_Y)) != 0;
}

static int32_t work_is_eligible(const cn_world *world, const cni_joint_work *w)
{
	return w->rigid_count > 0 && !(w->flags & (CNI_WORK_SPRINGY | CNI_WORK_BOUNDED)) &&
	       !(w->ia != 0 && body_is_locked(world, w->ia)) && !(w->ib != 0 && body_is_locked(world, w->ib));
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
		link->work_most = joint_work(world->settings.solver);
		++count;
	}
	return count;
}

/* Contacts of the islands that are solved directly; an island that has too many, or of the wrong kind, is refused. */
static void presses_collect(cn_world *world, cni_press *presses, int32_t room, cni_sparse *out)
{
	const int32_t *islands = (const int32_t *)world->direct_islands.data;
	int32_t k;
	out->presses = presses;
	for (k = 0; k < world->direct_islands.count; ++k) {
		int32_t count = cni_presses_collect(world, islands[k], presses + out->press_count, room - out->press_count);
		if (count < 0)
			cni_island_refuse(world, islands[k]);
		else
			out->press_count += count;
	}
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
		link->work_most = press_work(world->settings.solver);
	}
	return sparse->press_count;
}

static int32_t island_of(const cn_world *world, const cni_link *link)
{
	return cni_body_at(world, cni_awake_ids(world)[link->ia])->island;
}

/* Refuses the islands whose contacts are not in the plan. Returns how many links of them there are. */
static int32_t islands_refuse(cn_world *world, const cni_link *links, int32_t count, const uint8_t *planned)
{
	int32_t k, refused = 0;
	for (k = 0; k < count; ++k)
		if (!planned[k] && links[k].owner < 0) {
			if (cni_island_at(world, island_of(world, &links[k]))->tier == CNI_TIER_DIRECT)
				cni_island_refuse(world, island_of(world, &links[k]));
			++refused;
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
static void owners_tell(cn_world *world, const cni_link *links, int32_t count, const uint8_t *planned, cni_sparse *out)
{
	int32_t k;
	for (k = 0; k < count; ++k)
		if (planned[k] && links[k].owner >= 0)
			cni_joint_works(world)[links[k].owner].flags |= CNI_WORK_DIRECT;
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

/* 0: no scratch memory. */
static int32_t plan(cn_world *world, cni_sparse *out)
{
	int32_t most = world->settings.solver == CN_SOLVER_DIRECT ? world->touching_count : cni_min_i(world->touching_count, CNI_PRESS_MOST);
	int32_t room = world->direct_islands.count == 0 ? 0 : most;
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
	if (!cni_sparse_plan(&world->arena, links, count, cni_motions(world), world->awake_count, budget_of(world), out, planned))
		return 0;
	if (islands_refuse(world, links, count, planned) > 0) {
		cni_sparse_discard(&world->arena, out);
		count = links_keep(world, links, count);
		if (count == 0)
			return 1;
		if (!cni_sparse_plan(&world->arena, links, count, cni_motions(world), world->awake_count, budget_of(world), out, planned))
			return 0;
	}
	owners_tell(world, links, count, planned, out);
	out->saved = (cni_motion *)cni_arena_push(&world->arena, sizeof(cni_motion) * (uint64_t)out->body_count);
	out->pull = (float *)cni_arena_push(&world->arena, sizeof(float) * (uint64_t)world->awake_count);
	out->turn = (cni_rot *)cni_arena_push(&world->arena, sizeof(cni_rot) * (uint64_t)world->awake_count);
	return out->saved != NULL && out->pull != NULL && out->turn != NULL;
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

/* A joint alone is solved as well by itself. */
static void component_drop(cn_world *world, cni_sparse *sparse, int32_t component)
{
	const cni_component *c = &sparse->components[component];
	cni_joint_works(world)[sparse->nodes[c->begin].owner].flags &= ~(uint32_t)CNI_WORK_DIRECT;
	sparse->components[component] = sparse->components[--sparse->component_count];
}

/* Joints' levers from their rows. Returns how many joints there are. */
static int32_t levers_set(const cn_world *world, cni_sparse *sparse, const cni_component *c)
{
	int32_t k, i, joints = 0;
	for (k = c->begin; k < c->end; ++k) {
		cni_node *n = &sparse->nodes[k];
		const cni_row *rows;
		if (n->owner < 0)
			continue;
		++joints;
		rows = cni_joint_works(world)[n->owner].rows;
		for (i = 0; i < n->rows; ++i) {
			cni_lever l = { rows[i].ax, rows[i].ay, rows[i].aw, rows[i].bx, rows[i].by, rows[i].bw };
			n->lever[i] = l;
		}
	}
	return joints;
}

void cni_direct_refresh(cn_world *world, cni_sparse *sparse, const cni_component *c)
{
	(void)levers_set(world, sparse, c);
	cni_sparse_factor(sparse, c, cni_motions(world));
}

static void component_begin(cn_world *world, const cni_solve *s, cni_sparse *sparse, cni_component *c)
{
	cni_direct_turns(world, sparse, c);
	cni_tension_find(world, sparse, c, s->h);
	if (cni_tension_needs_dampers(world, sparse, c, s->h))
		c->width = CNI_NODE_ROWS;
	cni_tension_damp(world, sparse, c, s->h);
	c->joints = levers_set(world, sparse, c);
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

void cni_direct_prepare(cn_world *world, cni_solve *s, cni_sparse *out)
{
	int32_t k;
	memset(out, 0, sizeof *out);
	if ((world->awake_joints.count == 0 && world->direct_islands.count == 0) || world->settings.solver == CN_SOLVER_SOFT)
		return;
	if (!plan(world, out)) {
		works_release(world);
		world->warnings |= CN_WARNING_FRAME_MEMORY;
		return;
	}
	if (out->component_count == 0)
		return;
	s->direct = out;
	for (k = 0; k < out->component_count; ++k) {
		cni_component *c = &out->components[k];
		c->presses = component_has_presses(out, c);
		c->regular = c->presses ? PRESSES_REGULAR : c->loops ? LOOPS_REGULAR : 0.0f;
		c->swings = !c->presses && cni_component_swings(world, s, out, c);
		if (!c->swings && !c->presses && c->end - c->begin == 1)
			component_drop(world, out, k--);
		else if (!c->swings)
			component_begin(world, s, out, c);
	}
	cni_presses_take(world, out);
}

void cni_direct_push(cn_world *world, const cni_sparse *sparse, const cni_component *c)
{
	cni_motion *motions = cni_motions(world);
	int32_t k, i;
	for (k = c->begin; k < c->end; ++k) {
		const cni_node *n = &sparse->nodes[k];
		cni_row *rows;
		if (n->owner < 0)
			continue;
		rows = cni_joint_works(world)[n->owner].rows;
		for (i = 0; i < n->rows; ++i)
			rows[i].impulse += n->x[i];
		for (i = 0; i < CNI_NODE_ROWS; ++i)
			cni_lever_push(&n->lever[i], n->x[i], motions + n->ia, motions + n->ib);
	}
}

static void right_sides(const cn_world *world, cni_sparse *sparse, const cni_component *c, float rate)
{
	const cni_motion *motions = cni_motions(world);
	int32_t k, i;
	for (k = c->begin; k < c->end; ++k) {
		cni_node *n = &sparse->nodes[k];
		const cni_row *rows;
		if (n->owner < 0)
			continue;
		rows = cni_joint_works(world)[n->owner].rows;
		for (i = 0; i < CNI_NODE_ROWS; ++i)
			n->x[i] = -cni_lever_speed(&n->lever[i], motions + n->ia, motions + n->ib) - (i < n->rows ? rate * rows[i].error : 0.0f);
	}
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
	c->regular = c->loops ? LOOPS_REGULAR : 0.0f;
	cni_sparse_factor(sparse, c, cni_motions(world));
	if (world->settings.solver == CN_SOLVER_AUTO)
		cni_island_refuse(world, cni_body_at(world, cni_awake_ids(world)[sparse->bodies[c->body_begin]])->island);
}

static void joints_solve(cn_world *world, const cni_solve *s, const cni_component *c, int32_t bias)
{
	right_sides(world, s->direct, c, bias ? ERROR_RATE * s->inv_h : 0.0f);
	cni_sparse_solve(s->direct, c);
	cni_direct_push(world, s->direct, c);
}

/* The same levers at the new positions. */
static void component_turn(cn_world *world, const cni_solve *s, cni_component *c)
{
	cni_direct_turns(world, s->direct, c);
	cni_tension_damp(world, s->direct, c, s->h);
	if (levers_set(world, s->direct, c) > 0 && !c->presses)
		cni_sparse_factor(s->direct, c, cni_motions(world));
	else if (c->joints)
		c->factored = 0;
}

void cni_direct_solve(cn_world *world, const cni_solve *s, int32_t bias)
{
	int32_t k;
	for (k = 0; s->direct != NULL && k < s->direct->component_count; ++k) {
		cni_component *c = &s->direct->components[k];
		if (c->swings)
			continue;
		if (!bias)
			component_turn(world, s, c);
		if (c->presses && !cni_presses_solve(world, s, s->direct, c, bias))
			component_release(world, s->direct, c);
		if (!c->presses)
			joints_solve(world, s, c, bias);
	}
}

void cni_direct_warm_start(cn_world *world, const cni_solve *s)
{
	if (s->direct != NULL)
		cni_presses_warm_start(world, s->direct, s->warm_scale);
}

void cni_direct_store(cn_world *world, const cni_solve *s)
{
	if (s->direct != NULL)
		cni_presses_give_back_all(world, s->direct, s->h);
}
