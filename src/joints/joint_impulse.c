/*
 * joints/joint_impulse.c - the impulses of a joint in the present substep, for every solver path: rows of its own, a lane of rows, a pin in
 * a lane, or the direct solver.
 *
 * Reads and writes joint constraints and their lanes.
 */
#include "joints/joint_pass.h"
#include "joints/joint_constraint.h"

#include <string.h>

/* A row with impulse on body b along (x, y) at the pin's arms and about it (w). */
static cni_row lane_row(const cni_joint_block *k, int32_t l, float x, float y, float w, uint8_t kind, uint8_t slot, float impulse)
{
	cni_row r;
	memset(&r, 0, sizeof r);
	r.ax = -x;
	r.ay = -y;
	r.aw = k->ay[l] * x - k->ax[l] * y - w;
	r.bx = x;
	r.by = y;
	r.bw = k->bx[l] * y - k->by[l] * x + w;
	r.kind = kind;
	r.slot = slot;
	r.impulse = impulse;
	return r;
}

static float limit_side(const cni_joint_block *k, int32_t l)
{
	return k->limit_j[l] < 0.0f ? -1.0f : 1.0f;
}

void cni_joint_impulses_read(const cn_world *world, const cni_joint_constraint *w, cni_joint_impulses *out)
{
	cni_row *r = out->rows;
	int32_t k;
	if (w->row_lane != CNI_NONE)
		r += cni_row_lane_read(world, w, r);
	else
		for (k = 0; k < w->row_count; ++k)
			*r++ = w->rows[k];
	if (w->flags & CNI_CONSTRAINT_SPRINGY)
		for (k = 0; k < (int32_t)(r - out->rows); ++k)
			out->rows[k].kind = CNI_ROW_SOFT;
	if (w->lane != CNI_NONE) {
		const cni_joint_block *block = cni_joint_block_of(world, w);
		int32_t l = w->lane % CNI_LANES;
		*r++ = lane_row(block, l, 1.0f, 0.0f, 0.0f, CNI_ROW_RIGID, 0, block->jx[l]);
		*r++ = lane_row(block, l, 0.0f, 1.0f, 0.0f, CNI_ROW_RIGID, 1, block->jy[l]);
		*r++ = lane_row(block, l, 0.0f, 0.0f, 1.0f, CNI_ROW_SPRING, CNI_REVOLUTE_SPRING, block->spring_j[l]);
		*r++ = lane_row(block, l, 0.0f, 0.0f, 1.0f, CNI_ROW_MOTOR, CNI_REVOLUTE_MOTOR, block->motor_j[l]);
		*r++ = lane_row(block, l, 0.0f, 0.0f, limit_side(block, l), CNI_ROW_LIMIT, CNI_REVOLUTE_LIMIT, cni_abs(block->limit_j[l]));
	}
	out->count = (int32_t)(r - out->rows);
}

void cni_joint_impulses_write(cn_world *world, cni_joint_constraint *w, const cni_joint_impulses *impulses)
{
	const cni_row *r = impulses->rows;
	int32_t k;
	if (w->row_lane != CNI_NONE)
		cni_row_lane_write(world, w, r);
	else
		for (k = 0; k < w->row_count; ++k)
			w->rows[k].impulse = r[k].impulse;
	if (w->lane != CNI_NONE) {
		cni_joint_block *block = cni_joint_block_of(world, w);
		int32_t l = w->lane % CNI_LANES;
		r += impulses->count - CNI_PIN_LANE_ROWS;
		block->jx[l] = r[0].impulse;
		block->jy[l] = r[1].impulse;
		block->spring_j[l] = r[2].impulse;
		block->motor_j[l] = r[3].impulse;
		block->limit_j[l] = limit_side(block, l) * r[4].impulse;
	}
}
