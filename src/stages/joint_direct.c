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
#include "stages/joint_work.h"

#define ERROR_RATE 0.3f        /* part of the error that is taken out in a substep */
#define LOOPS_REGULAR 1e-5f    /* loops may say the same twice: their diagonal grows by this part */

static cni_sparse_limit limit_of(int32_t solver)
{
	static const cni_sparse_limit cheap = { 64, 16 }, any = { 1 << 20, 2000 };
	return solver == CN_SOLVER_DIRECT ? any : cheap;
}

uint64_t cni_direct_bytes(int32_t solver, int32_t joints, int32_t bodies)
{
	uint64_t mine = (sizeof(cni_link) + 1 + sizeof(float) * CNI_NODE_ROWS + 2 * sizeof(cni_motion)) * (uint64_t)joints + (sizeof(float) + sizeof(cni_rot)) * (uint64_t)(bodies + 1) + 320;
	if (joints == 0 || solver == CN_SOLVER_SOFT || solver == CN_SOLVER_SEQUENTIAL)
		return 0;
	return mine + cni_sparse_bytes(joints, bodies + 1, limit_of(solver));
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

static int32_t links_collect(const cn_world *world, cni_link *links)
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
		++count;
	}
	return count;
}

/* 0: no scratch memory. */
static int32_t plan(cn_world *world, cni_sparse *out)
{
	cni_link *links = (cni_link *)cni_arena_push(&world->arena, sizeof(cni_link) * (uint64_t)world->awake_joints.count);
	uint8_t *planned = (uint8_t *)cni_arena_push(&world->arena, (uint64_t)world->awake_joints.count);
	int32_t count, k;
	if (links == NULL || planned == NULL)
		return 0;
	count = links_collect(world, links);
	if (count == 0)
		return 1;
	if (!cni_sparse_plan(&world->arena, links, count, cni_motions(world), world->awake_count, limit_of(world->settings.solver), out, planned))
		return 0;
	for (k = 0; k < count; ++k)
		if (planned[k])
			cni_joint_works(world)[links[k].owner].flags |= CNI_WORK_DIRECT;
	out->pull = (float *)cni_arena_push(&world->arena, sizeof(float) * (uint64_t)world->awake_count);
	out->turn = (cni_rot *)cni_arena_push(&world->arena, sizeof(cni_rot) * (uint64_t)world->awake_count);
	return out->pull != NULL && out->turn != NULL;
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

static void component_begin(cn_world *world, const cni_solve *s, cni_sparse *sparse, cni_component *c)
{
	cni_direct_turns(world, sparse, c);
	cni_tension_find(world, sparse, c, s->h);
	if (cni_tension_needs_dampers(world, sparse, c, s->h))
		c->width = CNI_NODE_ROWS;
	cni_tension_damp(world, sparse, c, s->h);
	cni_direct_refresh(world, sparse, c);
}

void cni_direct_prepare(cn_world *world, cni_solve *s, cni_sparse *out)
{
	int32_t k;
	out->component_count = 0;
	if (world->awake_joints.count == 0 || world->settings.solver == CN_SOLVER_SOFT)
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
		c->regular = c->loops ? LOOPS_REGULAR : 0.0f;
		c->swings = cni_component_swings(world, s, out, c);
		if (!c->swings && c->end - c->begin == 1)
			component_drop(world, out, k--);
		else if (!c->swings)
			component_begin(world, s, out, c);
	}
}

void cni_direct_refresh(cn_world *world, cni_sparse *sparse, const cni_component *c)
{
	int32_t k, i;
	for (k = c->begin; k < c->end; ++k) {
		cni_node *n = &sparse->nodes[k];
		const cni_row *rows = cni_joint_works(world)[n->owner].rows;
		for (i = 0; i < n->rows; ++i) {
			cni_lever l = { rows[i].ax, rows[i].ay, rows[i].aw, rows[i].bx, rows[i].by, rows[i].bw };
			n->lever[i] = l;
		}
	}
	cni_sparse_factor(sparse, c, cni_motions(world));
}

void cni_direct_push(cn_world *world, const cni_sparse *sparse, const cni_component *c)
{
	cni_motion *motions = cni_motions(world);
	int32_t k, i;
	for (k = c->begin; k < c->end; ++k) {
		const cni_node *n = &sparse->nodes[k];
		cni_row *rows = cni_joint_works(world)[n->owner].rows;
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
		const cni_row *rows = cni_joint_works(world)[n->owner].rows;
		for (i = 0; i < CNI_NODE_ROWS; ++i)
			n->x[i] = -cni_lever_speed(&n->lever[i], motions + n->ia, motions + n->ib) - (i < n->rows ? rate * rows[i].error : 0.0f);
	}
}

void cni_direct_solve(cn_world *world, const cni_solve *s, int32_t bias)
{
	int32_t k;
	if (s->direct == NULL)
		return;
	for (k = 0; k < s->direct->component_count; ++k) {
		const cni_component *c = &s->direct->components[k];
		if (c->swings)
			continue;
		if (!bias) {
			cni_direct_turns(world, s->direct, c);
			cni_tension_damp(world, s->direct, c, s->h);
			cni_direct_refresh(world, s->direct, c);
		}
		right_sides(world, s->direct, c, bias ? ERROR_RATE * s->inv_h : 0.0f);
		cni_sparse_solve(s->direct, c);
		cni_direct_push(world, s->direct, c);
	}
}
