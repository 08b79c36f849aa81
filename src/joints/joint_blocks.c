/*
 * joints/joint_blocks.c - many joints of the soft step at once: lanes, their colours and passes.
 *
 * Nearly all joints of most scenes are pins with or without an angular spring, motor and limit; nets have rods, springs and welds. Joints of
 * a form of joints/joint_pass.h that are not solved directly are solved in its lanes instead of by the rows of joints/joint_solve.c. Values
 * that do not change within the step are written into the lane once; kernels do the rest.
 *
 * Greedy colouring, in the order of the awake list: a joint takes the lowest colour that neither of its bodies uses. The colours of a body
 * are bits of the flags of its cni_external, which every step writes anew. Workers may share the blocks of a colour; they synchronize
 * before the next colour.
 *
 * Reads joint constraints, records, motion, externals; writes blocks, colours, the list of joint constraints that are solved by rows, and
 * after the substeps the records' impulses.
 */
#include "joints/joints.h"
#include "base/bitset.h"
#include "base/cpu.h"
#include "joints/joint_pass.h"

#include <string.h>

#define BLOCKS_A_RANGE 8      /* a microsecond or two, more than the workers of a team take to meet */
#define STORES_A_RANGE 512

const cni_joint_kernel *cni_joint_kernel_choose(void)
{
	return CNI_WIDEST(&cni_joint_kernel_plain, &cni_joint_kernel_4, &cni_joint_kernel_8);
}

/* ---- forms ---- */

/* 1: nothing softens, bounds or breaks the joint. */
static int32_t may_use_lane(const cn_world *world, const cni_joint *j)
{
	return CNI_ON(JOINT_LANES) && j->stiffness_hertz <= 0.0f && j->force_max <= 0.0f && j->torque_max <= 0.0f &&
	       j->break_force <= 0.0f && j->break_torque <= 0.0f && world->settings.solver != CN_SOLVER_SEQUENTIAL;
}

static int32_t form_of(const cni_joint *j)
{
	if (j->type == CN_JOINT_DISTANCE)
		return CNI_FORM_DISTANCE;
	return j->type == CN_JOINT_REVOLUTE || j->type == CN_JOINT_FIXED ? CNI_FORM_PIN : CNI_FORM_NONE;
}

static uint32_t parts_of(const cni_joint *j)
{
	if (j->type == CN_JOINT_FIXED)
		return j->p[CNI_P_HERTZ] > 0.0f ? CN_JOINT_SPRING : CN_JOINT_SPRING | CNI_PART_HELD;
	if (j->type == CN_JOINT_DISTANCE && !(j->flags & (CN_JOINT_SPRING | CN_JOINT_LIMIT)))
		return CN_JOINT_SPRING | CNI_PART_HELD;
	return j->flags & (CN_JOINT_SPRING | CN_JOINT_MOTOR | CN_JOINT_LIMIT);
}

/* ---- colours ---- */

/* State while lanes are assigned. */
typedef struct lane_builder {
	cn_world *world;
	const cni_solve *s;
	cni_lane_spring spring;
	int32_t open[CNI_JOINT_COLORS][CNI_FORMS][2]; /* the last block begun for this colour, form and `small` */
} lane_builder;

/* Takes a colour that neither body uses yet and marks it as used; CNI_NONE: there is none. */
static int32_t color_take(cn_world *world, int32_t ia, int32_t ib)
{
	cni_external *a = cni_motion_can_move(cni_motions(world) + ia) ? cni_externals(world) + ia : NULL;
	cni_external *b = cni_motion_can_move(cni_motions(world) + ib) ? cni_externals(world) + ib : NULL;
	uint32_t used = (a != NULL ? a->flags : 0) | (b != NULL ? b->flags : 0);
	uint32_t open = ~(used >> CNI_EXTERNAL_COLOR_SHIFT) & ((1u << CNI_JOINT_COLORS) - 1u);
	if (open == 0)
		return CNI_NONE;
	int32_t color = cni_bit_lowest32(open);
	if (a != NULL)
		a->flags |= 1u << (CNI_EXTERNAL_COLOR_SHIFT + color);
	if (b != NULL)
		b->flags |= 1u << (CNI_EXTERNAL_COLOR_SHIFT + color);
	return color;
}

int32_t cni_joint_block_take(cn_world *world)
{
	int32_t index = world->joint_blocks.count++;
	cni_joint_block *block = cni_joint_blocks(world) + index;
	CNI_ASSERT(world->joint_blocks.count <= world->joint_blocks.capacity);
	memset(block, 0, sizeof *block);
	block->form = CNI_FORM_PIN;
	block->color = CNI_NONE;
	return index;
}

/* A block of this colour, form and `small` with an empty lane. */
static cni_joint_block *block_open(lane_builder *t, int32_t color, int32_t form, int32_t small)
{
	cn_world *world = t->world;
	int32_t *open = &t->open[color][form][small];
	if (*open == CNI_NONE || cni_joint_blocks(world)[*open].lanes == CNI_LANES) {
		*open = cni_joint_block_take(world);
		cni_joint_blocks(world)[*open].form = form;
		cni_joint_blocks(world)[*open].color = color;
		cni_joint_blocks(world)[*open].small = small;
		++world->joint_blocks_of[color];
	}
	return cni_joint_blocks(world) + *open;
}

/* Lists each colour's blocks one after the other, so that workers can share them. */
static void blocks_list(cn_world *world)
{
	cni_joint_block *blocks = cni_joint_blocks(world);
	int32_t at[CNI_JOINT_COLORS], count = 0;
	for (int32_t color = 0; color < CNI_JOINT_COLORS; ++color) {
		at[color] = count;
		count += world->joint_blocks_of[color];
	}
	for (int32_t k = 0; k < world->joint_blocks.count; ++k)
		if (blocks[k].color != CNI_NONE)
			blocks[at[blocks[k].color]++].listed = k;
}

/* ---- lanes ---- */

static cni_soft spring_soft(cni_lane_spring *g, float hertz, float damping_ratio, float h)
{
	if (hertz != g->hertz || damping_ratio != g->damping_ratio) {
		g->hertz = hertz;
		g->damping_ratio = damping_ratio;
		g->soft = cni_soft_exact(hertz, damping_ratio, h);
	}
	return g->soft;
}

static void spring_fill(cni_lane_spring *g, const cni_solve *s, const cni_joint_constraint *w, cni_joint_block *block, int32_t l)
{
	const cni_joint *j = w->record;
	int32_t at = j->type == CN_JOINT_DISTANCE ? (int32_t)CNI_P_DISTANCE_HERTZ : (int32_t)CNI_P_HERTZ;
	cni_soft soft = s->joint;
	if (!(w->parts & CNI_PART_HELD))
		soft = j->type == CN_JOINT_FIXED ? cni_soft_row(j->p[at], j->p[at + 1], s->h) : spring_soft(g, j->p[at], j->p[at + 1], s->h);
	else if (!(block->held >> l & 1u)) /* false when a lane is filled again, which other workers may do in the same block */
		block->held |= 1u << l;
	block->rest[l] = j->type == CN_JOINT_DISTANCE ? j->p[CNI_P_LENGTH] : j->type == CN_JOINT_FIXED ? 0.0f : j->p[CNI_P_TARGET];
	block->spring_mass[l] = soft.mass_scale;
	block->spring_bias[l] = soft.bias_scale;
	block->spring_impulse_scale[l] = soft.impulse_scale;
	block->spring_j[l] = j->impulse[cni_lane_spring_slot(w)];
}

/* 1: the lower end is nearer. */
static float limit_sign(const cni_joint *j, float measure)
{
	return measure - j->p[CNI_P_LOWER] <= j->p[CNI_P_UPPER] - measure ? 1.0f : -1.0f;
}

static void parts_fill(cni_lane_spring *spring, const cni_solve *s, const cni_joint_constraint *w, cni_joint_block *block, int32_t l)
{
	const cni_joint *j = w->record;
	if ((w->parts & ~block->parts) != 0) /* as for held lanes */
		block->parts |= w->parts;
	if (w->parts & CN_JOINT_SPRING)
		spring_fill(spring, s, w, block, l);
	if (w->parts & CN_JOINT_MOTOR) {
		block->speed[l] = j->p[CNI_P_MOTOR_SPEED];
		block->most[l] = j->p[CNI_P_MOTOR_MAX];
		block->motor_j[l] = j->impulse[cni_lane_slot(w) + 1];
	}
	block->lower[l] = -CNI_NO_LIMIT;
	block->upper[l] = CNI_NO_LIMIT;
	if (w->parts & CN_JOINT_LIMIT) {
		block->lower[l] = j->p[CNI_P_LOWER];
		block->upper[l] = j->p[CNI_P_UPPER];
		block->limit_j[l] = limit_sign(j, block->measure[l]) * j->impulse[cni_lane_slot(w) + 2];
	}
}

static void frame_fill(const cni_joint_constraint *w, cni_joint_block *block, int32_t l)
{
	cni_vec2 e = w->start.d;
	block->ax0[l] = block->ax[l] = w->start.ra.x;
	block->ay0[l] = block->ay[l] = w->start.ra.y;
	block->bx0[l] = block->bx[l] = w->start.rb.x;
	block->by0[l] = block->by[l] = w->start.rb.y;
	block->dx0[l] = w->start.d.x;
	block->dy0[l] = w->start.d.y;
	block->angle0[l] = block->measure[l] = w->start.angle;
	if (w->form == CNI_FORM_DISTANCE)
		e = cni_distance_axis(w->start.d, &block->measure[l]);
	block->ex[l] = e.x;
	block->ey[l] = e.y;
}

void cni_joint_lane_fill(cn_world *world, const cni_solve *s, cni_lane_spring *spring, int32_t k, cni_joint_block *block, int32_t l)
{
	cni_joint_constraint *w = cni_joint_constraints(world) + k;
	const cni_joint *j = w->record;
	w->lane = (int32_t)(block - cni_joint_blocks(world)) * CNI_LANES + l;
	w->row_count = 0; /* rows that may have been built for the direct solver are not used */
	block->ia[l] = w->ia;
	block->ib[l] = w->ib;
	block->ai[l] = cni_motions(world)[w->ia].inv_inertia;
	block->bi[l] = cni_motions(world)[w->ib].inv_inertia;
	frame_fill(w, block, l);
	if (w->form == CNI_FORM_PIN) {
		block->jx[l] = j->impulse[0];
		block->jy[l] = j->impulse[1];
	}
	parts_fill(spring, s, w, block, l);
}

int32_t cni_joint_fits_lane(const cn_world *world, const cni_solve *s, const cni_joint_constraint *w)
{
	float most = CNI_LANE_TURN_MAX_RAD / s->dt;
	return cni_abs(cni_motions(world)[w->ia].w) <= most && cni_abs(cni_motions(world)[w->ib].w) <= most;
}

/* 0: there is no lane for it. */
static int32_t lane_take(lane_builder *t, int32_t k)
{
	cn_world *world = t->world;
	cni_joint_constraint *w = cni_joint_constraints(world) + k;
	int32_t color = cni_joint_fits_lane(world, t->s, w) ? color_take(world, w->ia, w->ib) : CNI_NONE, l;
	if (color == CNI_NONE)
		return 0;
	cni_joint_block *block = block_open(t, color, w->form, cni_joint_is_of_small(world, w));
	l = block->lanes++;
	block->moves_a |= (uint32_t)cni_motion_can_move(cni_motions(world) + w->ia) << l;
	block->moves_b |= (uint32_t)cni_motion_can_move(cni_motions(world) + w->ib) << l;
	cni_joint_lane_fill(world, t->s, &t->spring, k, block, l);
	w->kept_lane = w->lane;
	w->kept_parts = w->parts;
	return 1;
}

/* ---- kept lanes ---- */

/* The assignment of joints to lanes follows from their order, their bodies, and which bodies can move. While none of that changes and all
   joints are in lanes of colours, the blocks of the last step are filled again in place, while the records are in the cache, without a new
   colouring. Otherwise lanes are assigned from scratch. */

/* Fills the lane of the last step with joint constraint k. 0: the joint does not belong there any more. Writes only its own lane. */
static int32_t lane_fill_again(cn_world *world, const cni_solve *s, struct cni_lane_setup *setup, int32_t k)
{
	const cni_joint_constraint *w = cni_joint_constraints(world) + k;
	int32_t l = w->kept_lane % CNI_LANES, is_new = w->record->inv_h == 0.0f;
	cni_joint_block *block = cni_joint_blocks(world) + w->kept_lane / CNI_LANES;
	if (block->ia[l] != w->ia || block->ib[l] != w->ib || w->kept_parts != w->parts || block->form != w->form ||
	    block->small != cni_joint_is_of_small(world, w) || !cni_joint_fits_lane(world, s, w) ||
	    (int32_t)(block->moves_a >> l & 1u) != cni_motion_can_move(cni_motions(world) + w->ia) ||
	    (int32_t)(block->moves_b >> l & 1u) != cni_motion_can_move(cni_motions(world) + w->ib))
		return 0;
	if (block->parts)
		block->spring_j[l] = block->motor_j[l] = block->limit_j[l] = 0.0f;
	cni_joint_lane_fill(world, s, &setup->spring, k, block, l);
	setup->special |= is_new || (w->flags & CNI_CONSTRAINT_TAUT);
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

static void lanes_empty(cn_world *world)
{
	for (int32_t k = 0; k < world->awake_joints.count && world->joint_lanes.filled > 0; ++k)
		if (!(cni_joint_constraints(world)[k].flags & CNI_CONSTRAINT_BATCHED))
			cni_joint_constraints(world)[k].lane = CNI_NONE;
	memset(world->joint_blocks_of, 0, sizeof world->joint_blocks_of);
}

/* The angle is only computed for a spring or limit. */
int32_t cni_joint_constraint_widen(cn_world *world, const cni_solve *s, struct cni_lane_setup *setup, int32_t k)
{
	cni_joint_constraint *w = cni_joint_constraints(world) + k;
	const cni_joint *j = cni_joint_at(world, ((const int32_t *)world->awake_joints.data)[k]);
	if (form_of(j) == CNI_FORM_NONE || !may_use_lane(world, j))
		return 0;
	cni_joint_constraint_begin(world, s, k, j);
	if (w->flags & (CNI_CONSTRAINT_LOCKS | CNI_CONSTRAINT_APART))
		return 0;
	w->form = form_of(j);
	w->parts = parts_of(j);
	w->row_count = 0;
	w->rigid_count = (w->form == CNI_FORM_PIN ? 2 : 0) + ((w->parts & CNI_PART_HELD) != 0);
	if (w->parts & (CN_JOINT_SPRING | CN_JOINT_LIMIT)) {
		if (w->form == CNI_FORM_PIN)
			w->start.angle = cni_joint_frame_angle(world, j);
		else
			cni_joint_rope_mark(world, w, s->dt);
	}
	setup->kept = setup->kept && lane_fill_again(world, s, setup, k);
	return 1;
}

/* Takes lanes for joints with a form that nothing else solves, and builds rows for those without a lane, which it links in order. Returns
   the number of the latter. */
static int32_t lanes_gather(cn_world *world, const cni_solve *s)
{
	lane_builder t = { world, s, { 0.0f, 0.0f, { 0.0f, 0.0f, 1.0f } }, { { { 0 } } } };
	int32_t left = 0, *plain = &world->joint_plain_first;
	memset(t.open, -1, sizeof t.open); /* CNI_NONE */
	for (int32_t k = 0; k < world->awake_joints.count; ++k) {
		cni_joint_constraint *w = cni_joint_constraints(world) + k;
		if (w->flags & (CNI_CONSTRAINT_FINISHED | CNI_CONSTRAINT_BATCHED))
			continue;
		if (w->form != CNI_FORM_NONE && !(w->flags & CNI_CONSTRAINT_DIRECT) && lane_take(&t, k))
			continue;
		cni_joint_rows_need(world, s, w);
		*plain = k;
		plain = &w->next_plain;
		++left;
	}
	*plain = CNI_NONE;
	return left;
}

void cni_joint_blocks_gather(cn_world *world, const cni_solve *s)
{
	cni_lanes_kept *kept = &world->joint_lanes;
	if (kept->lanes > 0 && kept->filled == kept->lanes && (s->direct == NULL || s->direct->node_count == 0)) {
		/* every joint is in its lane of the last step, of which directly solved ones would have taken theirs first; locked bodies are known for these alone */
		kept->alone = s->direct == NULL && !world->direct_failed && planning_is_needless(world);
		kept->budget = budget_of(world);
		world->joint_blocks.count = kept->blocks;
		world->joint_plain_first = CNI_NONE;
		return;
	}
	lanes_empty(world);
	int32_t left = lanes_gather(world, s);
	kept->alone = 0;
	kept->lanes = !CNI_ON(KEPT_LANES) || left > 0 || (s->direct != NULL && s->direct->node_count > 0) ? 0 : world->awake_joints.count;
	kept->blocks = world->joint_blocks.count;
	kept->works = world->joint_work.capacity;
	blocks_list(world);
}

/* ---- passes ---- */

/* A pass over the blocks of one colour, which share no written body and no joint constraint. */
typedef struct color_pass {
	cn_world *world;
	cni_joint_pass pass;
	cni_joint_kernel_fn *run;
	int32_t first; /* first block of the colour in the list */
	int32_t small; /* 1: blocks of small islands alone */
} color_pass;

static void color_pass_run(void *context, int32_t begin, int32_t end)
{
	const color_pass *c = (const color_pass *)context;
	cni_joint_block *blocks = cni_joint_blocks(c->world);
	for (int32_t k = c->first + begin; k < c->first + end; ++k)
		if (!c->small || blocks[blocks[k].listed].small)
			c->run(cni_motions(c->world), cni_starts(c->world), &blocks[blocks[k].listed], &c->pass);
}

void cni_joint_blocks_run(cn_world *world, const cni_solve *s, cni_joint_kernel_fn *run, int32_t small)
{
	color_pass c = { world, { s->h, s->inv_h, s->joint_warm_scale, s->joint, s->restless_speed }, run, 0, small };
	for (int32_t color = 0; color < CNI_JOINT_COLORS && world->joint_blocks.count > 0; ++color) {
		cni_team_for(s->team, world->joint_blocks_of[color], BLOCKS_A_RANGE, color_pass_run, &c);
		c.first += world->joint_blocks_of[color];
	}
}

int32_t cni_joint_blocks_relax(cn_world *world, const cni_solve *s, int32_t again)
{
	int32_t restless = 0;
	cni_joint_blocks_run(world, s, s->joint_kernel->relax, again);
	for (int32_t k = 0; k < world->joint_blocks.count; ++k)
		restless |= cni_joint_blocks(world)[k].small & cni_joint_blocks(world)[k].restless;
	return restless;
}

/* ---- storing ---- */

static void lane_store(cn_world *world, const cni_joint_constraint *w, const cni_solve *s)
{
	const cni_joint_block *block = cni_joint_block_of(world, w);
	int32_t l = w->lane % CNI_LANES;
	cni_joint *j = cni_joint_at(world, w->joint);
	int32_t first = cni_lane_slot(w);
	memset(j->impulse, 0, sizeof j->impulse);
	if (w->form == CNI_FORM_PIN) {
		j->impulse[0] = block->jx[l];
		j->impulse[1] = block->jy[l];
	}
	if (w->parts != 0) {
		j->impulse[cni_lane_spring_slot(w)] = block->spring_j[l];
		j->impulse[first + 1] = block->motor_j[l];
	}
	if (w->parts & CN_JOINT_LIMIT)
		j->impulse[first + 2] = cni_max(limit_sign(j, block->measure[l]) * block->limit_j[l], 0.0f);
	j->inv_h = s->inv_h;
	cni_joint_keep_finite(j);
}

typedef struct store_loop {
	cn_world *world;
	const cni_solve *s;
} store_loop;

/* In the order of the joint constraints, which is nearly that of the records. */
static void store_range(void *context, int32_t begin, int32_t end)
{
	store_loop *loop = (store_loop *)context;
	cn_world *world = loop->world;
	const cni_joint_constraint *constraints = cni_joint_constraints(world);
	for (int32_t k = begin; k < end; ++k)
		if (constraints[k].lane != CNI_NONE)
			lane_store(world, &constraints[k], loop->s);
}

void cni_joint_blocks_store(cn_world *world, const cni_solve *s)
{
	store_loop loop = { world, s };
	cni_parallel_for(world, world->awake_joints.count, STORES_A_RANGE, store_range, &loop);
}
