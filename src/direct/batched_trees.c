/*
 * direct/batched_trees.c - trees of pins of equal topology, solved side by side: their selection, lanes and passes.
 *
 * Many scenes have hundreds of small mechanisms of a few kinds: ragdolls, pieces of chain. Solving one is a long sequence of small
 * dependent sums through lists of indices. Sixteen trees of a class share the lists (linear/topology_class.c), and each sum becomes a
 * vector sum. A tree has the same bits in any batch, also in one of its own. Which trees are in batches depends on their number alone and
 * not on the memory that a world has.
 *
 * A batch takes all of a tree's joints, which are lane joints with two rows: no dampers, no loops, no contacts in the system, no gaps whose
 * closing is bounded (closings_bound in component.c), and no RATTLE. Trees of a class that remain after full batches form one more batch. The
 * joints of other components have rows. A tree that is locked, or has contacts of direct/heavy_contacts.c, takes its levers and factors from
 * its lane as a component of its own.
 *
 * Reads joint constraints, records, motion, the plan; writes batches, blocks of lanes, flags of joint constraints.
 */
#include "base/cpu.h"
#include "direct/direct_system.h"

#include <string.h>

/* ---- which components ---- */

/* 1: the motor may turn the two bodies at its joint out of the tangent in a substep; alternated with the pins it would open them. It then
   becomes a row of their system: direct/active_rows.c. */
static int32_t motor_is_strong(const cn_world *world, const cni_solve *s, const cni_joint_constraint *w)
{
	float free = cni_motions(world)[w->ia].inv_inertia + cni_motions(world)[w->ib].inv_inertia;
	return (w->record->flags & CN_JOINT_MOTOR) && w->record->p[CNI_P_MOTOR_MAX] * s->h * s->h * free > CNI_PROJECTION_TURN_RAD;
}

/* 1: the joint may have to be locked in this step: cni_tree_lane_lock. */
static int32_t turns_fast(const cn_world *world, const cni_solve *s, const cni_joint_constraint *w)
{
	float most = CNI_SNAP_RAD * s->inv_h;
	return cni_abs(cni_motions(world)[w->ia].w) > most || cni_abs(cni_motions(world)[w->ib].w) > most;
}

/* 1: bodies that were struck part so fast at the pin that its impulse will turn them as far. A batch, which solves limits one by one before its pins,
   would throw them. */
static int32_t is_struck(const cn_world *world, const cni_solve *s, const cni_joint_constraint *w)
{
	float arm_sq = cni_max(cni_length_sq(w->start.ra), cni_length_sq(w->start.rb));
	return cni_length_sq(cni_joint_velocity_apart(world, w)) > cni_sq(CNI_SNAP_RAD * s->inv_h) * arm_sq;
}

/* 1: the pin is of a light body on a long arm, beside a heavy one: solutions of batches are not checked. */
static int32_t may_lose_digits(const cn_world *world, const cni_component *c, const cni_joint_constraint *w)
{
	const cni_motion *a = cni_motions(world) + w->ia, *b = cni_motions(world) + w->ib;
	float most = a->inv_mass + a->inv_inertia * cni_length_sq(w->start.ra) + b->inv_mass + b->inv_inertia * cni_length_sq(w->start.rb);
	return most * c->heaviest > CNI_BATCH_MASS_RATIO;
}

int32_t cni_component_is_batched(const cn_world *world, const cni_solve *s, cni_sparse *sparse, const cni_component *c, int32_t has_heavy)
{
	uint32_t parts = 0;
	int32_t k, fast = has_heavy, struck = 0;
	if (c->kind == CNI_NONE || c->has_contacts || c->closes_fast)
		return 0;
	for (k = c->begin; k < c->end; ++k) {
		const cni_joint_constraint *w = &cni_joint_constraints(world)[sparse->nodes[k].owner];
		if (w->form != CNI_FORM_PIN || motor_is_strong(world, s, w) || !cni_joint_fits_lane(world, s, w))
			return 0;
		if (has_heavy && (w->parts != 0 || may_lose_digits(world, c, w))) /* towers with springs would open three times as far */
			return 0;
		parts |= w->parts;
		fast |= turns_fast(world, s, w);
		struck |= is_struck(world, s, w);
	}
	if (parts != 0 && struck)
		return 0;
	cni_geometric_stiffness_find_pins(world, sparse, c, s->h);
	return cni_geometric_stiffness_needs_dampers(world, sparse, c, s->h) ? CNI_NOT_BATCHED : fast && parts == 0 ? CNI_BATCHED_MAY_LOCK : CNI_BATCHED;
}

/* ---- building batches ---- */

typedef struct batch_builder {
	cn_world *world;
	cni_sparse *sparse;
	int32_t waiting[CNI_TOPOLOGY_CLASSES];    /* components of the class that are to be in batches */
	int32_t example[CNI_TOPOLOGY_CLASSES];    /* one of them */
	int32_t others;                           /* joints that may get lanes outside of batches */
	cni_tree_batch *open[CNI_TOPOLOGY_CLASSES];     /* the class's batch that is being filled */
	float *numbers;                /* memory for the factors of batches to come */
} batch_builder;

static int32_t nodes_of(const cni_component *c)
{
	return c->end - c->begin;
}

static int32_t numbers_of(const cni_component *c)
{
	return (3 * nodes_of(c) + 4 * (c->coupling_end - c->coupling_begin)) * CNI_LANES;
}

/* Batches take no more blocks than all joints in lanes would. */
uint64_t cni_tree_batch_bytes(int32_t joints)
{
	uint64_t block = sizeof(float) * CNI_LANES * (3 + 4 * CNI_TOPOLOGY_COUPLINGS) + sizeof(cni_tree_batch) / 2;
	return block * (uint64_t)cni_joint_blocks_for(joints) + 64;
}

static void waiting_count(batch_builder *m)
{
	memset(m->waiting, 0, sizeof m->waiting);
	m->others = m->world->awake_joints.count;
	for (int32_t k = 0; k < m->sparse->component_count; ++k) {
		const cni_component *c = &m->sparse->components[k];
		if (!c->done && !c->uses_rattle)
			m->others -= c->joints;
		if (c->batches) {
			++m->waiting[c->kind];
			m->example[c->kind] = k;
		}
	}
}

/* Number of batches of a class. Trees beyond full batches make one more if its blocks and those of joints that are not
   solved directly are no more than all joints would take in lanes. */
static int32_t batches_count(batch_builder *m, int32_t class_index, int32_t *blocks)
{
	int32_t nodes = nodes_of(&m->sparse->components[m->example[class_index]]);
	int32_t full = m->waiting[class_index] / CNI_LANES, rest = m->waiting[class_index] % CNI_LANES;
	*blocks += full * nodes;
	if (rest == 0 || *blocks + nodes + cni_joint_blocks_for(m->others) > cni_joint_blocks_for(m->world->awake_joints.count)) {
		m->waiting[class_index] -= rest;
		return full;
	}
	*blocks += nodes;
	return full + 1;
}

/* Reserves the memory of all batches and selects their components; without memory there are none. */
static void batches_reserve(batch_builder *m)
{
	int32_t class_index, batches = 0, numbers = 0, blocks = 0;
	for (class_index = 0; class_index < CNI_TOPOLOGY_CLASSES; ++class_index)
		if (m->waiting[class_index] > 0) {
			int32_t count = batches_count(m, class_index, &blocks);
			batches += count;
			numbers += count * numbers_of(&m->sparse->components[m->example[class_index]]);
		}
	if (batches == 0)
		return;
	m->numbers = (float *)cni_scratch_push(m->world, sizeof(float) * (uint64_t)numbers + sizeof(cni_tree_batch) * (uint64_t)batches);
	if (m->numbers == NULL) {
		memset(m->waiting, 0, sizeof m->waiting);
		return;
	}
	m->sparse->batches = (cni_tree_batch *)(void *)(m->numbers + numbers);
}

static void order_by_color(cni_tree_batch *batch)
{
	int32_t color, k, count = 0;
	for (color = 0; count < batch->tree.nodes; ++color)
		for (k = 0; k < batch->tree.nodes; ++k)
			if (batch->tree.color[k] == color)
				batch->order[count++] = (uint8_t)k;
}

static void sources_find(cni_tree_batch *batch)
{
	batch->bodies = batch->tree.bodies;
	for (int32_t k = 2 * batch->tree.nodes - 1; k >= 0; --k) {
		int32_t body = batch->tree.end[k >> 1][k & 1];
		batch->source[body] = (uint32_t)((size_t)(k >> 1) * sizeof(cni_joint_block) + (k & 1 ? offsetof(cni_joint_block, ib) : offsetof(cni_joint_block, ia)));
		batch->bodies = cni_max_i(batch->bodies, body + 1);
	}
}

static void blocks_take(cn_world *world, cni_tree_batch *batch)
{
	int32_t k, first = world->joint_blocks.count;
	for (k = 0; k < batch->tree.nodes; ++k)
		(void)cni_joint_block_take(world);
	batch->nodes = cni_joint_blocks(world) + first;
}

/* An empty batch of the component's class. */
static cni_tree_batch *batch_open(batch_builder *m, const cni_component *c)
{
	cni_sparse *sparse = m->sparse;
	cni_tree_batch *batch = &sparse->batches[sparse->batch_count++];
	(void)cni_topology_describe(sparse, c, cni_motions(m->world), &batch->tree);
	order_by_color(batch);
	sources_find(batch);
	blocks_take(m->world, batch);
	batch->lanes = 0;
	batch->selected = batch->opening = 0;
	batch->couplings = sparse->couplings + c->coupling_begin;
	batch->coupling_count = c->coupling_end - c->coupling_begin;
	batch->first = sparse->first + c->begin;
	batch->below = sparse->below;
	batch->node_first = c->begin;
	batch->block_first = sparse->first[c->begin];
	batch->pivots = m->numbers;
	batch->blocks = m->numbers + 3 * CNI_LANES * batch->tree.nodes;
	m->numbers += numbers_of(c);
	return batch;
}

static void component_place(batch_builder *m, cni_component *c)
{
	cni_tree_batch **open = &m->open[c->kind];
	if (m->waiting[c->kind] == 0) {
		c->batches = 0;
		c->pending = 1;
		return;
	}
	--m->waiting[c->kind];
	if (*open == NULL)
		*open = batch_open(m, c);
	c->batch = (int32_t)(*open - m->sparse->batches);
	c->lane = (*open)->lanes++;
	(*open)->node_begin[c->lane] = c->begin;
	if ((*open)->lanes == CNI_LANES)
		*open = NULL;
}

/* ---- passes ---- */

typedef struct batch_loop {
	cni_tree_batch *batches;
	cni_tree_batch_fn *run;
	cni_tree_batch_pass pass;
} batch_loop;

/* Batches share no movable body. */
static void batch_range(void *context, int32_t begin, int32_t end)
{
	batch_loop *loop = (batch_loop *)context;
	for (int32_t k = begin; k < end; ++k)
		loop->run(&loop->batches[k], &loop->pass);
}

/* By the widest kernel that this build and this processor have. */
static void batches_run(cn_world *world, const cni_solve *s, cni_team *team, int32_t pass, float rate, float opening_speed, float turn_least)
{
	const cni_tree_batch_kernel *kernel = CNI_WIDEST(&cni_tree_batch_kernel_plain, &cni_tree_batch_kernel_4, &cni_tree_batch_kernel_8);
	batch_loop loop = { NULL, (*kernel)[pass], { cni_motions(world), cni_starts(world), { s->h, s->inv_h, s->warm_scale, s->joint, s->restless_speed }, rate, s->push_speed, opening_speed, turn_least } };
	if (s->direct == NULL || s->direct->batch_count == 0)
		return;
	loop.batches = s->direct->batches;
	cni_team_for(team, s->direct->batch_count, 1, batch_range, &loop);
}

void cni_tree_batches_run(cn_world *world, const cni_solve *s, int32_t pass)
{
	batches_run(world, s, s->team, pass, s->joint_error_rate, 0.0f, 0.0f);
}

void cni_tree_batches_project(cn_world *world, const cni_solve *s, float opening_speed, int32_t bias)
{
	batches_run(world, s, s->team, CNI_TREES_PROJECT, bias ? s->joint_error_rate : 0.0f, opening_speed, bias ? CNI_PROJECTION_TURN_RAD * s->inv_h : FLT_MAX);
}

typedef struct fill_loop {
	cn_world *world;
	const cni_solve *s;
} fill_loop;

static void lane_fill(const fill_loop *f, cni_lane_spring *spring, cni_tree_batch *batch, int32_t lane)
{
	for (int32_t k = 0; k < batch->tree.nodes; ++k) {
		int32_t owner = f->s->direct->nodes[batch->node_begin[lane] + k].owner;
		cni_joint_constraints(f->world)[owner].flags |= CNI_CONSTRAINT_BATCHED;
		cni_joint_lane_fill(f->world, f->s, spring, owner, &batch->nodes[k], lane);
		batch->nodes[k].direct |= 1u << lane;
	}
}

static void fill_range(void *context, int32_t begin, int32_t end)
{
	const fill_loop *f = (const fill_loop *)context;
	cni_lane_spring spring = { 0.0f, 0.0f, { 0.0f, 0.0f, 1.0f } };
	for (int32_t k = begin; k < end; ++k)
		for (int32_t l = 0; l < f->s->direct->batches[k].lanes; ++l)
			lane_fill(f, &spring, &f->s->direct->batches[k], l);
}

void cni_tree_batches_make(cn_world *world, const cni_solve *s, cni_team *team)
{
	batch_builder m = { world, s->direct, { 0 }, { 0 }, 0, { NULL }, NULL };
	cni_sparse *sparse = s->direct;
	fill_loop f = { world, s };
	waiting_count(&m);
	batches_reserve(&m);
	for (int32_t k = 0; k < sparse->component_count; ++k)
		if (sparse->components[k].batches)
			component_place(&m, &sparse->components[k]);
	cni_team_for(team, sparse->batch_count, 1, fill_range, &f);
	batches_run(world, s, team, CNI_TREES_BEGIN, s->joint_error_rate, 0.0f, 0.0f);
}

/* ---- a lane as a component of its own ---- */

static void lane_read(const cni_solve *s, cni_component *c)
{
	const cni_joint_block *block = s->direct->batches[c->batch].nodes;
	float rate = s->joint_error_rate;
	int32_t k, l = c->lane;
	cni_sparse_clear(s->direct, c);
	c->active = c->damps = 0;
	c->width = 2;
	for (k = c->begin; k < c->end; ++k, ++block) {
		cni_node *n = &s->direct->nodes[k];
		const cni_lever x = { -1.0f, 0.0f, block->ay[l], 1.0f, 0.0f, -block->by[l] }, y = { 0.0f, -1.0f, -block->ax[l], 0.0f, 1.0f, block->bx[l] };
		cni_levers_set(&n->levers, 0, x);
		cni_levers_set(&n->levers, 1, y);
		n->closing[0] = cni_clamp(rate * block->ex[l], -s->push_speed, s->push_speed);
		n->closing[1] = cni_clamp(rate * block->ey[l], -s->push_speed, s->push_speed);
	}
}

void cni_tree_lane_system(const cni_solve *s, cni_component *c)
{
	const cni_tree_batch *batch = &s->direct->batches[c->batch];
	lane_read(s, c);
	cni_sparse_take(s->direct, c, batch->pivots + c->lane, batch->blocks + c->lane, CNI_LANES);
}

void cni_tree_lane_add(const cni_solve *s, const cni_component *c)
{
	cni_joint_block *block = s->direct->batches[c->batch].nodes;
	for (int32_t k = c->begin; k < c->end; ++k, ++block) {
		block->jx[c->lane] += s->direct->nodes[k].x[0];
		block->jy[c->lane] += s->direct->nodes[k].x[1];
	}
}

void cni_tree_lane_lock(cn_world *world, const cni_solve *s, cni_component *c, float turn)
{
	if (!cni_geometric_stiffness_turns(world, s->direct, c, turn * s->inv_h))
		return;
	lane_read(s, c);
	if (cni_component_lock(world, s, c, turn))
		cni_tree_lane_add(s, c);
}
