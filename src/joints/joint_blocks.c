/*
 * joints/joint_blocks.c - many joints of the soft step at once: colours and passes of all lanes, and lanes of revolute joints.
 *
 * Nearly all joints of most scenes are pins with or without an angular spring, motor and limit. Pins without other features (flag
 * CNI_CONSTRAINT_WIDE) are solved in the lanes of joints/joint_pass.h instead of by the rows of joints/joint_solve.c. Values that do not
 * change within the step are written into the lane once; kernels do the rest.
 *
 * Greedy colouring, first of directly solved joints, then in the order of the awake list: a joint takes the lowest colour that neither of
 * its bodies uses. The colours of a body are bits of the flags of its cni_external, which every step writes anew. Other types take theirs
 * after that (joints/joint_rows.c). Workers may share the blocks of a colour; they synchronize before the next colour.
 *
 * Reads joint constraints, records, motion, externals; writes blocks, colours, the list of joint constraints that are solved by rows, and
 * after the substeps the records' impulses.
 */
#include "joints/joints.h"
#include "base/bitset.h"
#include "base/cpu.h"
#include "joints/joint_pass.h"
#include "joints/joint_row.h"
#include "model/tuning.h"

#include <string.h>

#define BLOCKS_A_RANGE 8      /* a microsecond or two, more than the workers of a team take to meet */
#define STORES_AHEAD 8        /* joints whose records are asked for */
#define STORES_A_RANGE 512

const cni_joint_kernel *cni_joint_kernel_choose(void)
{
#if CNI_HAS_WIDE_8
	if (cni_cpu_has_avx2())
		return &cni_joint_kernel_8;
#endif
#if CNI_HAS_WIDE_4
	return &cni_joint_kernel_4;
#else
	return &cni_joint_kernel_plain;
#endif
}

/* ---- joint constraints ---- */

/* 1: nothing softens, bounds or breaks the joint. */
static int32_t may_use_lane(const cn_world *world, const cni_joint *j)
{
	return CNI_ON(JOINT_LANES) && j->stiffness_hertz <= 0.0f && j->force_max <= 0.0f && j->torque_max <= 0.0f &&
	       j->break_force <= 0.0f && j->break_torque <= 0.0f && world->settings.solver != CN_SOLVER_SEQUENTIAL;
}

/* Sets up a joint for a lane of rows, which it gets if it is not solved directly. */
static int32_t form_begin(cn_world *world, int32_t k, const cni_joint *j, int32_t form)
{
	cni_joint_constraint *w = cni_joint_constraints(world) + k;
	if (form == CNI_FORM_NONE)
		return 0;
	cni_joint_constraint_begin(world, k, j);
	w->start.angle = cni_joint_frame_angle(world, w->record);
	w->form = form;
	w->row_count = 0;
	w->rigid_count = cni_form_rigid_rows(form);
	return 1;
}

void cni_joint_constraints_complete(const cn_world *world, const cni_sparse *sparse, const cni_component *c)
{
	int32_t k, r;
	for (k = c->begin; k < c->end; ++k) {
		cni_joint_constraint *w = sparse->nodes[k].owner >= 0 ? cni_joint_constraints(world) + sparse->nodes[k].owner : NULL;
		if (w == NULL || !(w->flags & CNI_CONSTRAINT_WIDE))
			continue;
		w->row_count = w->make_rows(w->record, &w->start, w->rows);
		for (r = 0; r < w->row_count; ++r)
			w->rows[r].impulse = w->record->impulse[w->rows[r].slot];
	}
}

void cni_joint_constraint_narrow(cn_world *world, const cni_solve *s, int32_t k)
{
	cni_joint_constraint *w = cni_joint_constraints(world) + k;
	if (!(w->flags & CNI_CONSTRAINT_WIDE))
		return;
	w->flags &= ~(uint32_t)CNI_CONSTRAINT_WIDE;
	cni_joint_rows_begin(world, s, w);
}

/* ---- colours ---- */

int32_t cni_joint_block_take(cn_world *world)
{
	int32_t index = world->joint_blocks.count++;
	cni_joint_block *block = cni_joint_blocks(world) + index;
	CNI_ASSERT(world->joint_blocks.count <= world->joint_blocks.capacity);
	memset(block, 0, sizeof *block);
	block->next = CNI_NONE;
	return index;
}

/* Appends an empty block to the colour. */
static cni_joint_block *block_take(cn_world *world, int32_t color)
{
	cni_color *group = &world->joint_colors[color];
	int32_t index = cni_joint_block_take(world);
	if (group->last == CNI_NONE)
		group->first = index;
	else
		cni_joint_blocks(world)[group->last].next = index;
	group->last = index;
	return cni_joint_blocks(world) + index;
}

/* ---- lanes ---- */

static void spring_fill(cni_lane_spring *g, float h, const cni_joint *j, cni_joint_block *block, int32_t l)
{
	cni_soft soft = cni_lane_spring_soft(g, j->p[CNI_P_REVOLUTE_HERTZ], j->p[CNI_P_REVOLUTE_DAMPING], h);
	block->rest[l] = j->p[CNI_P_REVOLUTE_TARGET];
	block->spring_mass[l] = soft.mass_scale;
	block->spring_bias[l] = soft.bias_scale;
	block->spring_impulse_scale[l] = soft.impulse_scale;
	block->spring_j[l] = j->impulse[CNI_REVOLUTE_SPRING];
}

/* 1: the lower end is nearer. */
static float limit_sign(const cni_joint *j, float angle)
{
	return angle - j->p[CNI_P_LOWER] <= j->p[CNI_P_UPPER] - angle ? 1.0f : -1.0f;
}

static uint32_t pin_has(const cni_joint *j)
{
	return j->flags & (CN_JOINT_SPRING | CN_JOINT_MOTOR | CN_JOINT_LIMIT);
}

static void angle_fill(cni_lane_spring *spring, float h, const cni_joint_constraint *w, cni_joint_block *block, int32_t l)
{
	const cni_joint *j = w->record;
	if ((pin_has(j) & ~block->angular) != 0) /* false when a lane is filled again, which other workers may do in the same block */
		block->angular |= pin_has(j);
	block->angle0[l] = block->angle[l] = w->start.angle;
	if (j->flags & CN_JOINT_SPRING)
		spring_fill(spring, h, j, block, l);
	if (j->flags & CN_JOINT_MOTOR) {
		block->speed[l] = j->p[CNI_P_MOTOR_SPEED];
		block->torque[l] = j->p[CNI_P_MOTOR_MAX];
		block->motor_j[l] = j->impulse[CNI_REVOLUTE_MOTOR];
	}
	block->lower[l] = -CNI_NO_LIMIT;
	block->upper[l] = CNI_NO_LIMIT;
	if (j->flags & CN_JOINT_LIMIT) {
		block->lower[l] = j->p[CNI_P_LOWER];
		block->upper[l] = j->p[CNI_P_UPPER];
		block->limit_j[l] = limit_sign(j, w->start.angle) * j->impulse[CNI_REVOLUTE_LIMIT];
	}
}

static void pin_fill(const cn_world *world, cni_joint_constraint *w, cni_joint_block *block, int32_t l)
{
	const cni_joint *j = w->record;
	block->ia[l] = w->ia;
	block->ib[l] = w->ib;
	block->ai[l] = cni_motions(world)[w->ia].inv_inertia;
	block->bi[l] = cni_motions(world)[w->ib].inv_inertia;
	block->ax0[l] = block->ax[l] = w->start.ra.x;
	block->ay0[l] = block->ay[l] = w->start.ra.y;
	block->bx0[l] = block->bx[l] = w->start.rb.x;
	block->by0[l] = block->by[l] = w->start.rb.y;
	block->dx0[l] = block->ex[l] = w->start.d.x;
	block->dy0[l] = block->ey[l] = w->start.d.y;
	if (w->flags & CNI_CONSTRAINT_DIRECT) {
		block->direct |= 1u << l;
		w->row_count = block->batch ? 0 : w->rigid_count; /* the lane has the angle's rows */
		if (!block->batch)
			return;
	}
	block->jx[l] = j->impulse[0];
	block->jy[l] = j->impulse[1];
}

void cni_joint_lane_fill(cn_world *world, const cni_solve *s, cni_lane_spring *spring, int32_t k, cni_joint_block *block, int32_t l)
{
	cni_joint_constraint *w = cni_joint_constraints(world) + k;
	block->constraint[l] = k;
	w->lane = (int32_t)(block - cni_joint_blocks(world)) * CNI_LANES + l;
	pin_fill(world, w, block, l);
	angle_fill(spring, s->h, w, block, l);
}

int32_t cni_joint_fits_lane(const cn_world *world, const cni_solve *s, const cni_joint_constraint *w)
{
	float most = CNI_LANE_TURN_MAX_RAD / s->dt;
	return cni_abs(cni_motions(world)[w->ia].w) <= most && cni_abs(cni_motions(world)[w->ib].w) <= most;
}

/* 0: there is no lane for it. */
static int32_t lane_take(cn_world *world, const cni_solve *s, cni_lane_spring *spring, int32_t k)
{
	const cni_joint_constraint *w = cni_joint_constraints(world) + k;
	int32_t color = cni_joint_fits_lane(world, s, w) ? cni_joint_color_take(world, w->ia, w->ib) : CNI_NONE, l;
	cni_joint_block *block;
	if (color == CNI_NONE)
		return 0;
	l = world->joint_colors[color].lanes++ % CNI_LANES;
	block = l == 0 ? block_take(world, color) : cni_joint_blocks(world) + world->joint_colors[color].last;
	block->moves_a |= (uint32_t)cni_motion_can_move(cni_motions(world) + w->ia) << l;
	block->moves_b |= (uint32_t)cni_motion_can_move(cni_motions(world) + w->ib) << l;
	cni_joint_lane_fill(world, s, spring, k, block, l);
	cni_joint_constraints(world)[k].kept_lane = w->lane;
	cni_joint_constraints(world)[k].kept_has = pin_has(w->record);
	return 1;
}

/* ---- kept lanes ---- */

/* The assignment of joints to lanes follows from their order, their bodies, and which bodies can move. While none of that changes and all
   joints are in lanes of colours, the blocks of the last step are filled again in place, while the records are in the cache, without a new
   colouring. Otherwise lanes are assigned from scratch. */

static int32_t is_locked(const cn_world *world, int32_t body)
{
	return body != CNI_NONE && (cni_body_at(world, body)->flags & (CN_BODY_LOCK_X | CN_BODY_LOCK_Y)) != 0;
}

/* Fills the lane of the last step with joint constraint k. 0: the joint does not belong there any more. Writes only its own lane. */
static int32_t lane_fill_again(cn_world *world, const cni_solve *s, struct cni_lane_setup *setup, int32_t k)
{
	const cni_joint_constraint *w = cni_joint_constraints(world) + k;
	int32_t l = w->kept_lane % CNI_LANES;
	cni_joint_block *block = cni_joint_blocks(world) + w->kept_lane / CNI_LANES;
	if (block->ia[l] != w->ia || block->ib[l] != w->ib || w->kept_has != pin_has(w->record) || !cni_joint_fits_lane(world, s, w) ||
	    (int32_t)(block->moves_a >> l & 1u) != cni_motion_can_move(cni_motions(world) + w->ia) ||
	    (int32_t)(block->moves_b >> l & 1u) != cni_motion_can_move(cni_motions(world) + w->ib))
		return 0;
	if (block->angular)
		block->spring_j[l] = block->motor_j[l] = block->limit_j[l] = 0.0f;
	cni_joint_lane_fill(world, s, &setup->spring, k, block, l);
	setup->special |= is_locked(world, w->record->body[0]) || is_locked(world, w->record->body[1]) ||
	                  (w->flags & CNI_CONSTRAINT_FRESH) != 0;
	++setup->filled;
	return 1;
}

/* The blocks must be those that the last step filled: a step with a solver without blocks leaves none, and a grown array has moved. */
void cni_joint_blocks_begin(cn_world *world)
{
	cni_lanes_kept *kept = &world->joint_lanes;
	if (kept->lanes != world->awake_joints.count || kept->works != world->joint_work.capacity || kept->blocks != world->joint_blocks.count)
		kept->lanes = 0;
	world->joint_blocks.count = 0;
	cni_row_blocks_empty(world);
}

/* 1: every joint is in its lane of the last step. Directly solved joints would take their lanes first. */
static int32_t lanes_are_kept(const cn_world *world, const cni_solve *s)
{
	return world->joint_lanes.lanes > 0 && world->joint_lanes.filled == world->joint_lanes.lanes && (s->direct == NULL || s->direct->node_count == 0);
}

/* 1: the other inputs of planning, which may change while lanes do not, also allow to skip it. */
static int32_t planning_is_needless(const cn_world *world)
{
	return world->settings.solver == CN_SOLVER_AUTO && !world->overridden && !world->joint_lanes.special && world->direct_islands.count == 0 &&
	       world->joints_soft_step <= world->step_count;
}

/* The work budget of one factorization, as in direct/direct_plan.c. */
static int32_t budget_of(const cn_world *world) { return world->settings.work_budget / world->settings.substeps; }

int32_t cni_joint_lanes_need_no_plan(const cn_world *world)
{
	const cni_lanes_kept *kept = &world->joint_lanes;
	return kept->alone && kept->lanes > 0 && kept->filled == kept->lanes && kept->budget == budget_of(world) && planning_is_needless(world);
}

/* Only called for kept lanes: locked bodies are not known for others. */
static void no_plan_record(cn_world *world, const cni_solve *s)
{
	world->joint_lanes.alone = s->direct == NULL && !world->direct_failed && planning_is_needless(world);
	world->joint_lanes.budget = budget_of(world);
}

static void lanes_empty(cn_world *world)
{
	int32_t k;
	for (k = 0; k < world->awake_joints.count && world->joint_lanes.filled > 0; ++k)
		if (!(cni_joint_constraints(world)[k].flags & CNI_CONSTRAINT_BATCHED))
			cni_joint_constraints(world)[k].lane = CNI_NONE;
	for (k = 0; k < CNI_JOINT_COLORS; ++k) {
		world->joint_colors[k].first = world->joint_colors[k].last = CNI_NONE;
		world->joint_colors[k].lanes = 0;
	}
}

/* left: number of joints without a pin's lane. */
static void lanes_keep(cn_world *world, const cni_solve *s, int32_t left)
{
	cni_lanes_kept *kept = &world->joint_lanes;
	kept->lanes = !CNI_ON(KEPT_LANES) || left > 0 || (s->direct != NULL && s->direct->node_count > 0) ? 0 : world->awake_joints.count;
	kept->blocks = world->joint_blocks.count;
	kept->works = world->joint_work.capacity;
}

/* The angle is only computed for a spring or limit. */
int32_t cni_joint_constraint_widen(cn_world *world, const cni_solve *s, struct cni_lane_setup *setup, int32_t k)
{
	cni_joint_constraint *w = cni_joint_constraints(world) + k;
	const cni_joint *j = cni_joint_at(world, ((const int32_t *)world->awake_joints.data)[k]);
	if (!may_use_lane(world, j))
		return 0;
	if (j->type != CN_JOINT_REVOLUTE)
		return form_begin(world, k, j, cni_joint_form(j));
	cni_joint_constraint_begin(world, k, j);
	w->flags |= CNI_CONSTRAINT_WIDE;
	w->row_count = 0;
	w->rigid_count = 2;
	if (w->record->flags & (CN_JOINT_SPRING | CN_JOINT_LIMIT))
		w->start.angle = cni_joint_frame_angle(world, w->record);
	setup->kept = setup->kept && lane_fill_again(world, s, setup, k);
	return 1;
}

/* Joints in one system with contacts are solved by rows: each of its passes begins by removing the effect of the impulses. */
static void contact_joints_narrow(cn_world *world, const cni_solve *s)
{
	int32_t k, n;
	for (k = 0; s->direct != NULL && k < s->direct->component_count; ++k) {
		const cni_component *c = &s->direct->components[k];
		for (n = c->begin; c->has_contacts && n < c->end; ++n)
			if (s->direct->nodes[n].owner >= 0)
				cni_joint_constraint_narrow(world, s, s->direct->nodes[n].owner);
	}
}

/* Directly solved components take their lanes first and in the order of their nodes. So the colours, and with them the order of passes, are
   equal in components of one topology class, and in batches. */
static void components_gather(cn_world *world, const cni_solve *s, cni_lane_spring *spring)
{
	int32_t k;
	for (k = 0; s->direct != NULL && k < s->direct->node_count; ++k) {
		const uint32_t which = CNI_CONSTRAINT_WIDE | CNI_CONSTRAINT_DIRECT | CNI_CONSTRAINT_FINISHED | CNI_CONSTRAINT_BATCHED;
		int32_t owner = s->direct->nodes[k].owner;
		if (owner < 0 || (cni_joint_constraints(world)[owner].flags & which) != (CNI_CONSTRAINT_WIDE | CNI_CONSTRAINT_DIRECT))
			continue; /* a contact, a joint solved by rows, or a finished one */
		if (!lane_take(world, s, spring, owner))
			cni_joint_constraint_narrow(world, s, owner);
	}
}

/* Links joint constraints without a lane in order; left 0: all have one. */
static void plain_link(cn_world *world, int32_t left)
{
	int32_t k, *plain = &world->joint_plain_first;
	for (k = 0; left > 0 && k < world->awake_joints.count; ++k) {
		cni_joint_constraint *w = cni_joint_constraints(world) + k;
		if ((w->flags & CNI_CONSTRAINT_FINISHED) || w->lane != CNI_NONE || w->row_lane != CNI_NONE)
			continue;
		*plain = k;
		plain = &w->next_plain;
	}
	*plain = CNI_NONE;
}

/* Lists each colour's blocks one after the other, so that workers can share them. */
static void blocks_list(cn_world *world)
{
	cni_joint_block *blocks = cni_joint_blocks(world);
	int32_t color, index, count = 0;
	for (color = 0; color < CNI_JOINT_COLORS; ++color)
		for (index = world->joint_colors[color].first; index != CNI_NONE; index = blocks[index].next)
			blocks[count++].listed = index;
}

/* Returns the number of joints without a pin's lane. */
static int32_t lanes_gather(cn_world *world, const cni_solve *s)
{
	cni_lane_spring spring = { 0.0f, 0.0f, { 0.0f, 0.0f, 1.0f } };
	int32_t k, left = 0;
	components_gather(world, s, &spring);
	for (k = 0; k < world->awake_joints.count; ++k) {
		cni_joint_constraint *w = cni_joint_constraints(world) + k;
		if ((w->flags & CNI_CONSTRAINT_FINISHED) || w->lane != CNI_NONE)
			continue;
		if ((w->flags & CNI_CONSTRAINT_WIDE) && lane_take(world, s, &spring, k))
			continue;
		if (w->flags & CNI_CONSTRAINT_WIDE)
			cni_joint_constraint_narrow(world, s, k);
		++left;
	}
	return left;
}

void cni_joint_blocks_gather(cn_world *world, const cni_solve *s)
{
	int32_t left;
	if (lanes_are_kept(world, s)) {
		no_plan_record(world, s);
		world->joint_blocks.count = world->joint_lanes.blocks;
		world->joint_plain_first = CNI_NONE;
		return;
	}
	world->joint_lanes.alone = 0;
	contact_joints_narrow(world, s);
	lanes_empty(world);
	left = lanes_gather(world, s);
	blocks_list(world);
	lanes_keep(world, s, left);
	if (left > 0)
		cni_row_lanes_gather(world, s);
	plain_link(world, left);
	if (s->direct != NULL)
		s->direct->released = 0;
}

/* ---- directly solved pins ---- */

/* The direct solver has released the joint within the step: the lane solves its pin from now on. */
static void lane_release(cni_joint_block *block, int32_t l, cni_joint_constraint *w)
{
	block->jx[l] += w->rows[0].impulse;
	block->jy[l] += w->rows[1].impulse;
	w->rows[0].impulse = w->rows[1].impulse = 0.0f;
	block->direct &= ~(1u << l);
}

static void released_check(cn_world *world, cni_joint_block *block)
{
	uint32_t bits;
	for (bits = block->direct; bits != 0; bits &= bits - 1u) {
		int32_t l = cni_bit_lowest32(bits);
		cni_joint_constraint *w = cni_joint_constraints(world) + block->constraint[l];
		if (!(w->flags & CNI_CONSTRAINT_DIRECT))
			lane_release(block, l, w);
	}
}

/* Moves the rows' impulses to the lanes while arms turn. */
static void rows_to_lanes(cn_world *world, cni_joint_block *block)
{
	uint32_t bits;
	released_check(world, block);
	for (bits = block->direct; bits != 0; bits &= bits - 1u) {
		int32_t l = cni_bit_lowest32(bits);
		const cni_row *rows = cni_joint_constraints(world)[block->constraint[l]].rows;
		block->jx[l] += rows[0].impulse;
		block->jy[l] += rows[1].impulse;
	}
}

/* Moves them back, and updates the rows at the new positions. */
static void lanes_to_rows(cn_world *world, cni_joint_block *block)
{
	uint32_t bits;
	for (bits = block->direct; bits != 0; bits &= bits - 1u) {
		int32_t l = cni_bit_lowest32(bits);
		cni_row *rows = cni_joint_constraints(world)[block->constraint[l]].rows;
		rows[0].impulse = block->jx[l];
		rows[1].impulse = block->jy[l];
		block->jx[l] = block->jy[l] = 0.0f;
		cni_rows_point_turn(rows, cni_v(block->ax[l], block->ay[l]), cni_v(block->bx[l], block->by[l]), cni_v(block->ex[l], block->ey[l]));
	}
}

/* ---- passes ---- */

/* A pass over the blocks of one colour, which share no written body and no joint constraint. Pins come first. */
typedef struct color_pass {
	cn_world *world;
	cni_joint_pass pass;
	cni_joint_kernel_fn *run;
	cni_row_kernel_fn *run_rows;
	int32_t moving;   /* 1: in passes at new positions and in the warm start */
	int32_t released; /* 1: some directly solved lane may have been released */
	int32_t lanes;
	int32_t first, blocks;         /* first block of the colour in the list, and number of its blocks */
	int32_t first_rows;            /* first block of rows */
} color_pass;

/* 1: the direct solver solves all pins of the block, and it has no springs, motors or limits. */
static int32_t nothing_is_left(const cni_joint_block *block, int32_t lanes)
{
	return block->angular == 0 && block->direct == (1u << lanes) - 1u;
}

static void color_pass_run(void *context, int32_t begin, int32_t end, int32_t worker)
{
	const color_pass *c = (const color_pass *)context;
	cn_world *world = c->world;
	int32_t k;
	(void)worker;
	for (k = begin; k < end && k < c->blocks; ++k) {
		cni_joint_block *block = cni_joint_blocks(world) + cni_joint_blocks(world)[c->first + k].listed;
		int32_t lanes = cni_min_i(c->lanes - k * CNI_LANES, CNI_LANES);
		if (block->direct != 0 && c->moving)
			rows_to_lanes(world, block);
		else if (block->direct != 0 && c->released)
			released_check(world, block);
		if (!c->moving && nothing_is_left(block, lanes))
			continue;
		c->run(cni_motions(world), cni_starts(world), block, &c->pass, lanes);
		if (block->direct != 0 && c->moving)
			lanes_to_rows(world, block);
	}
	if (k < end)
		cni_row_blocks_run(world, c->run_rows, &c->pass, c->first_rows + k - c->blocks, c->first_rows + end - c->blocks);
}

static void colors_run(cn_world *world, const cni_solve *s, cni_joint_kernel_fn *run, cni_row_kernel_fn *run_rows, int32_t moving)
{
	color_pass c = { world, { s->h, s->inv_h, s->warm_scale, s->joint }, run, run_rows, moving, 0, 0, 0, 0, 0 };
	int32_t color;
	c.released = s->direct != NULL && s->direct->released > 0;
	for (color = 0; color < CNI_JOINT_COLORS && world->joint_blocks.count + world->row_block_count > 0; ++color) {
		c.lanes = world->joint_colors[color].lanes;
		c.blocks = (c.lanes + CNI_LANES - 1) / CNI_LANES;
		cni_team_for(s->team, c.blocks + world->row_blocks_of[color], BLOCKS_A_RANGE, color_pass_run, &c);
		c.first += c.blocks;
		c.first_rows += world->row_blocks_of[color];
	}
}

void cni_joint_blocks_warm(cn_world *world, const cni_solve *s)
{
	colors_run(world, s, s->joint_kernel->warm, s->joint_kernel->rows_warm, 1);
}

void cni_joint_blocks_solve(cn_world *world, const cni_solve *s)
{
	colors_run(world, s, s->joint_kernel->solve, s->joint_kernel->rows_solve, 0);
}

void cni_joint_blocks_relax(cn_world *world, const cni_solve *s)
{
	colors_run(world, s, s->joint_kernel->relax, s->joint_kernel->rows_relax, 1);
}

/* ---- storing ---- */

static void lane_store(cn_world *world, const cni_joint_constraint *w, const cni_solve *s)
{
	const cni_joint_block *block = cni_joint_block_of(world, w);
	int32_t l = w->lane % CNI_LANES;
	cni_joint *j = cni_joint_at(world, w->joint);
	int32_t has_rows = (block->direct >> l & 1u) && !block->batch;
	j->impulse[0] = block->jx[l] + (has_rows ? w->rows[0].impulse : 0.0f);
	j->impulse[1] = block->jy[l] + (has_rows ? w->rows[1].impulse : 0.0f);
	j->impulse[CNI_REVOLUTE_SPRING] = block->spring_j[l];
	j->impulse[CNI_REVOLUTE_MOTOR] = block->motor_j[l];
	j->impulse[CNI_REVOLUTE_LIMIT] = (j->flags & CN_JOINT_LIMIT) ? cni_max(limit_sign(j, block->angle[l]) * block->limit_j[l], 0.0f) : 0.0f;
	j->inv_h = s->inv_h;
	cni_joint_keep_finite(j);
}

typedef struct store_loop {
	cn_world *world;
	const cni_solve *s;
} store_loop;

/* In the order of the joint constraints, which is nearly that of the records. */
static void store_range(void *context, int32_t begin, int32_t end, int32_t worker)
{
	store_loop *loop = (store_loop *)context;
	cn_world *world = loop->world;
	const cni_joint_constraint *constraints = cni_joint_constraints(world);
	int32_t k, far = cni_joints_are_far(world);
	(void)worker;
	for (k = begin; k < end; ++k) {
		if (far && k + STORES_AHEAD < end && constraints[k + STORES_AHEAD].lane != CNI_NONE) {
			const cni_joint_block *next = cni_joint_block_of(world, &constraints[k + STORES_AHEAD]);
			cni_joint_prefetch(constraints[k + STORES_AHEAD].record);
			CNI_PREFETCH(next->jx);
			CNI_PREFETCH(next->jy);
		}
		if (constraints[k].lane != CNI_NONE)
			lane_store(world, &constraints[k], loop->s);
	}
}

void cni_joint_blocks_store(cn_world *world, const cni_solve *s)
{
	store_loop loop = { world, s };
	cni_parallel_for(world, world->awake_joints.count, STORES_A_RANGE, store_range, &loop);
}
