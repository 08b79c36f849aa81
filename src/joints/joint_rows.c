/*
 * joints/joint_rows.c - lanes of rows (joints/joint_rows.h): selection of joints, filling, storing.
 *
 * These lanes take rods, ties, welds, slides and wheels that nothing else softens, bounds or breaks, and that are not solved directly. They
 * take colours after pins, in the order of the awake list (joints/joint_blocks.c), and a pass over a colour runs these blocks beside those
 * of pins. Lanes of one colour and form fill a block. The number of partly filled blocks is limited, so leftover joints, and joints of
 * scenes with few of them, are solved one by one.
 *
 * Reads joint constraints, records, motion; writes blocks, and after the substeps the records' impulses.
 */
#include "joints/joints.h"
#include "joints/joint_pass.h"
#include "model/tuning.h"

#include <string.h>

#define LANES_LEAST 4 /* in the mean, of blocks that are not full */

/* ---- selection ---- */

int32_t cni_joint_form(const cni_joint *j)
{
	switch (j->type) {
	case CN_JOINT_DISTANCE: return j->flags & (CN_JOINT_SPRING | CN_JOINT_LIMIT) ? CNI_FORM_TIE : CNI_FORM_ROD;
	case CN_JOINT_FIXED: return j->p[CNI_P_HERTZ] > 0.0f ? CNI_FORM_SOFT_WELD : CNI_FORM_WELD;
	case CN_JOINT_PRISMATIC: return CNI_FORM_SLIDE;
	case CN_JOINT_WHEEL: return CNI_FORM_WHEEL;
	default: return CNI_FORM_NONE;
	}
}

/* Flags of the spring, motor and limit that a joint of this form has. */
static uint32_t parts_of(const cni_joint *j, int32_t form)
{
	if (form == CNI_FORM_SOFT_WELD)
		return CN_JOINT_SPRING;
	return form == CNI_FORM_ROD || form == CNI_FORM_WELD ? 0 : j->flags & (CN_JOINT_SPRING | CN_JOINT_MOTOR | CN_JOINT_LIMIT);
}

/* Indices of impulses in a record. */
typedef struct slots {
	uint8_t spring, motor, limit; /* the rigid rows' come first */
} slots;

static slots slots_of(int32_t form)
{
	static const slots of_tie = { 1, 2, 3 }, of_others = { 2, 3, 4 };
	return form == CNI_FORM_TIE ? of_tie : of_others;
}

/* ---- blocks ---- */

static int32_t blocks_for(int32_t joints)
{
	return joints / CNI_LANES + cni_min_i(joints / LANES_LEAST, CNI_JOINT_COLORS);
}

uint64_t cni_row_bytes(int32_t joints)
{
	return sizeof(cni_row_block) * (uint64_t)blocks_for(joints) + 64;
}

void cni_row_blocks_empty(cn_world *world)
{
	world->row_blocks = NULL;
	world->row_block_count = 0;
	memset(world->row_blocks_of, 0, sizeof world->row_blocks_of);
}

/* State while lanes are assigned. */
typedef struct lane_builder {
	cn_world *world;
	const cni_solve *s;
	cni_lane_spring spring;
	int32_t open[CNI_JOINT_COLORS][CNI_FORMS]; /* the last block begun for this colour and form */
	int32_t room;                              /* number of blocks */
} lane_builder;

/* A block with an empty lane; NULL: no block is left. */
static cni_row_block *block_open(lane_builder *t, int32_t color, int32_t form)
{
	cn_world *world = t->world;
	int32_t *open = &t->open[color][form];
	cni_row_block *block;
	if (*open != CNI_NONE && cni_row_blocks(world)[*open].lanes < CNI_LANES)
		return cni_row_blocks(world) + *open;
	if (world->row_block_count == t->room)
		return NULL;
	*open = world->row_block_count++;
	++world->row_blocks_of[color];
	block = cni_row_blocks(world) + *open;
	memset(block, 0, sizeof *block);
	block->form = form;
	block->color = color;
	return block;
}

/* Lists each colour's blocks one after the other, so that workers can share them. */
static void blocks_list(cn_world *world)
{
	cni_row_block *blocks = cni_row_blocks(world);
	int32_t at[CNI_JOINT_COLORS], color, k, count = 0;
	for (color = 0; color < CNI_JOINT_COLORS; ++color) {
		at[color] = count;
		count += world->row_blocks_of[color];
	}
	for (k = 0; k < world->row_block_count; ++k)
		blocks[at[blocks[k].color]++].listed = k;
}

/* ---- passes ---- */

void cni_row_blocks_run(cn_world *world, cni_row_kernel_fn *run, const cni_joint_pass *pass, int32_t begin, int32_t end)
{
	cni_row_block *blocks = cni_row_blocks(world);
	int32_t k;
	for (k = begin; k < end; ++k)
		run(cni_motions(world), cni_starts(world), &blocks[blocks[k].listed], pass);
}

static void all_run(cn_world *world, const cni_solve *s, cni_row_kernel_fn *run)
{
	cni_joint_pass pass = { s->h, s->inv_h, s->warm_scale, s->joint };
	cni_row_blocks_run(world, run, &pass, 0, world->row_block_count);
}

/* ---- lanes ---- */

static void spring_fill(lane_builder *t, const cni_joint *j, cni_row_block *block, int32_t l)
{
	int32_t distance = j->type == CN_JOINT_DISTANCE;
	int32_t hertz_at = CNI_P_HERTZ, damping_at = CNI_P_DAMPING;
	if (distance) {
		hertz_at = CNI_P_DISTANCE_HERTZ;
		damping_at = CNI_P_DISTANCE_DAMPING;
	}
	float hertz = j->p[hertz_at], damping_ratio = j->p[damping_at];
	cni_soft soft = j->type == CN_JOINT_FIXED ? cni_soft_implicit(hertz, damping_ratio, t->s->h) : cni_lane_spring_soft(&t->spring, hertz, damping_ratio, t->s->h);
	block->spring_mass[l] = soft.mass_scale;
	block->spring_bias[l] = soft.bias_scale;
	block->spring_impulse_scale[l] = soft.impulse_scale;
	block->spring_j[l] = j->impulse[slots_of(block->form).spring];
}

static void parts_fill(lane_builder *t, const cni_joint *j, cni_row_block *block, int32_t l)
{
	uint32_t parts = parts_of(j, block->form);
	block->has |= parts;
	block->lower[l] = -CNI_NO_LIMIT;
	block->upper[l] = CNI_NO_LIMIT;
	if (parts & CN_JOINT_SPRING)
		spring_fill(t, j, block, l);
	if (parts & CN_JOINT_MOTOR) {
		block->speed[l] = j->p[CNI_P_MOTOR_SPEED];
		block->most[l] = j->p[CNI_P_MOTOR_MAX];
		block->motor_j[l] = j->impulse[slots_of(block->form).motor];
	}
	if (parts & CN_JOINT_LIMIT) {
		block->lower[l] = j->p[CNI_P_LOWER];
		block->upper[l] = j->p[CNI_P_UPPER];
		block->limit_j[l] = j->impulse[slots_of(block->form).limit];
	}
}

static void frame_fill(const cni_joint_frame *f, cni_row_block *block, int32_t l)
{
	block->ax0[l] = f->ra.x;
	block->ay0[l] = f->ra.y;
	block->bx0[l] = f->rb.x;
	block->by0[l] = f->rb.y;
	block->dx0[l] = f->d.x;
	block->dy0[l] = f->d.y;
	block->qc0[l] = f->qa.c;
	block->qs0[l] = f->qa.s;
	block->angle0[l] = f->angle;
}

/* The number from which the type measures its gap or its spring. */
static float rest_of(const cni_joint *j, int32_t form)
{
	if (form == CNI_FORM_ROD || form == CNI_FORM_TIE)
		return j->p[CNI_P_LENGTH];
	return form == CNI_FORM_SLIDE ? j->p[CNI_P_TARGET] : 0.0f;
}

static void lane_fill(lane_builder *t, cni_joint_constraint *w, int32_t k, cni_row_block *block)
{
	const cni_joint *j = w->record;
	const cni_motion *a = cni_motions(t->world) + w->ia, *b = cni_motions(t->world) + w->ib;
	int32_t l = block->lanes++, r;
	w->row_lane = (int32_t)(block - cni_row_blocks(t->world)) * CNI_LANES + l;
	w->row_count = 0;
	block->constraint[l] = k;
	block->ia[l] = w->ia;
	block->ib[l] = w->ib;
	block->ai[l] = a->inv_inertia;
	block->bi[l] = b->inv_inertia;
	block->moves_a |= (uint32_t)cni_motion_can_move(a) << l;
	block->moves_b |= (uint32_t)cni_motion_can_move(b) << l;
	block->axis_x[l] = j->p[CNI_P_AXIS_X];
	block->axis_y[l] = j->p[CNI_P_AXIS_Y];
	block->rest[l] = rest_of(j, block->form);
	frame_fill(&w->start, block, l);
	parts_fill(t, j, block, l);
	for (r = 0; r < cni_form_rigid_rows(block->form); ++r)
		block->j[r][l] = j->impulse[r];
}

static int32_t lane_take(lane_builder *t, cni_joint_constraint *w, int32_t k)
{
	int32_t color = cni_joint_color_take(t->world, w->ia, w->ib);
	cni_row_block *block = color == CNI_NONE ? NULL : block_open(t, color, w->form);
	if (block == NULL)
		return 0;
	lane_fill(t, w, k, block);
	return 1;
}

static int32_t is_waiting(const cni_joint_constraint *w)
{
	return w->form != CNI_FORM_NONE && !(w->flags & (CNI_CONSTRAINT_DIRECT | CNI_CONSTRAINT_FINISHED));
}

/* Reserves blocks for the waiting joints. Returns the number of blocks; 0: no memory, or too few joints. */
static int32_t blocks_reserve(cn_world *world, int32_t waiting)
{
	int32_t room = CNI_ON(ROW_LANES) ? blocks_for(waiting) : 0;
	if (room == 0)
		return 0;
	world->row_blocks = cni_arena_push(&world->arena, sizeof(cni_row_block) * (uint64_t)room);
	if (world->row_blocks == NULL)
		world->warnings |= CN_WARNING_FRAME_MEMORY;
	return world->row_blocks == NULL ? 0 : room;
}

void cni_row_lanes_gather(cn_world *world, const cni_solve *s)
{
	lane_builder t = { world, s, { 0.0f, 0.0f, { 0.0f, 0.0f, 1.0f } }, { { 0 } }, 0 };
	int32_t k, waiting = 0;
	for (k = 0; k < world->awake_joints.count; ++k)
		waiting += is_waiting(cni_joint_constraints(world) + k);
	if (waiting == 0)
		return;
	memset(t.open, -1, sizeof t.open); /* CNI_NONE */
	t.room = blocks_reserve(world, waiting);
	for (k = 0; k < world->awake_joints.count; ++k) {
		cni_joint_constraint *w = cni_joint_constraints(world) + k;
		if (is_waiting(w) && !(t.room > 0 && lane_take(&t, w, k)) && w->row_count == 0)
			cni_joint_rows_begin(world, s, w);
	}
	blocks_list(world);
	all_run(world, s, s->joint_kernel->rows_begin);
}

/* ---- storing ---- */

static void lane_store(cn_world *world, const cni_row_block *block, int32_t l, const cni_solve *s)
{
	const cni_joint_constraint *w = cni_joint_constraints(world) + block->constraint[l];
	cni_joint *j = cni_joint_at(world, w->joint);
	slots at = slots_of(block->form);
	uint32_t parts = parts_of(j, block->form);
	int32_t rigid = cni_form_rigid_rows(block->form), r;
	memset(j->impulse, 0, sizeof j->impulse);
	for (r = 0; r < rigid; ++r)
		j->impulse[r] = block->whole[r][l];
	if (parts & CN_JOINT_SPRING)
		j->impulse[at.spring] = block->spring_j[l];
	if (parts & CN_JOINT_MOTOR)
		j->impulse[at.motor] = block->motor_j[l];
	if (parts & CN_JOINT_LIMIT)
		j->impulse[at.limit] = block->limit_j[l];
	j->inv_h = s->inv_h;
	cni_joint_keep_finite(j);
}

void cni_row_lanes_store(cn_world *world, const cni_solve *s)
{
	int32_t k, l;
	all_run(world, s, s->joint_kernel->rows_finish);
	for (k = 0; k < world->row_block_count; ++k)
		for (l = 0; l < cni_row_blocks(world)[k].lanes; ++l)
			lane_store(world, &cni_row_blocks(world)[k], l, s);
}

/* ---- the rows of one joint in a lane, for readers within the step ---- */

static cni_row row_read(const cni_lane_row *r, int32_t l, float sign, uint8_t kind, uint8_t slot, float impulse)
{
	cni_row row;
	memset(&row, 0, sizeof row);
	row.ax = -sign * r->nx[l];
	row.ay = -sign * r->ny[l];
	row.aw = sign * r->aw[l];
	row.bx = sign * r->nx[l];
	row.by = sign * r->ny[l];
	row.bw = sign * r->bw[l];
	row.kind = kind;
	row.slot = slot;
	row.impulse = impulse;
	return row;
}

int32_t cni_row_lane_read(const cn_world *world, const cni_joint_constraint *w, cni_row *rows)
{
	const cni_row_block *block = cni_row_blocks(world) + w->row_lane / CNI_LANES;
	int32_t l = w->row_lane % CNI_LANES, count = 0;
	uint32_t parts = parts_of(w->record, block->form);
	slots at = slots_of(block->form);
	for (; count < cni_form_rigid_rows(block->form); ++count)
		rows[count] = row_read(&block->rigid[count], l, 1.0f, CNI_ROW_RIGID, (uint8_t)count, block->j[count][l]);
	if (parts & CN_JOINT_SPRING)
		rows[count++] = row_read(&block->free[0], l, 1.0f, block->form == CNI_FORM_SOFT_WELD ? CNI_ROW_SOFT : CNI_ROW_SPRING, at.spring, block->spring_j[l]);
	if (parts & CN_JOINT_MOTOR)
		rows[count++] = row_read(&block->free[cni_form_motor_row(block->form)], l, 1.0f, CNI_ROW_MOTOR, at.motor, block->motor_j[l]);
	if (parts & CN_JOINT_LIMIT)
		rows[count++] = row_read(&block->free[0], l, block->side[l], CNI_ROW_LIMIT, at.limit, block->limit_j[l]);
	return count;
}

void cni_row_lane_write(cn_world *world, const cni_joint_constraint *w, const cni_row *rows)
{
	cni_row_block *block = cni_row_blocks(world) + w->row_lane / CNI_LANES;
	int32_t l = w->row_lane % CNI_LANES, count = 0;
	uint32_t parts = parts_of(w->record, block->form);
	for (; count < cni_form_rigid_rows(block->form); ++count)
		block->j[count][l] = rows[count].impulse;
	if (parts & CN_JOINT_SPRING)
		block->spring_j[l] = rows[count++].impulse;
	if (parts & CN_JOINT_MOTOR)
		block->motor_j[l] = rows[count++].impulse;
	if (parts & CN_JOINT_LIMIT)
		block->limit_j[l] = rows[count].impulse;
}
