/*
 * joints/joint_impulse.c - the impulses of a joint in the present substep, for every solver path: rows of its own, a lane, or the
 * direct solver.
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

/* Rows of a lane: of its point, then of its measure. */
static int32_t lane_read(const cn_world *world, const cni_joint_constraint *w, cni_row *r)
{
	const cni_joint_block *k = cni_joint_block_of(world, w);
	uint8_t slot = (uint8_t)cni_lane_slot(w);
	uint8_t kind = w->parts & CNI_PART_HELD ? CNI_ROW_RIGID : w->record->type == CN_JOINT_FIXED ? CNI_ROW_SOFT : CNI_ROW_SPRING;
	int32_t l = w->lane % CNI_LANES, count = 0;
	float x = 0.0f, y = 0.0f, turn = 1.0f, side = limit_side(k, l);
	if (w->form == CNI_FORM_PIN) {
		r[count++] = lane_row(k, l, 1.0f, 0.0f, 0.0f, CNI_ROW_RIGID, 0, k->jx[l]);
		r[count++] = lane_row(k, l, 0.0f, 1.0f, 0.0f, CNI_ROW_RIGID, 1, k->jy[l]);
	} else {
		x = k->ex[l];
		y = k->ey[l];
		turn = 0.0f;
	}
	r[count++] = lane_row(k, l, x, y, turn, kind, (uint8_t)cni_lane_spring_slot(w), k->spring_j[l]);
	r[count++] = lane_row(k, l, x, y, turn, CNI_ROW_MOTOR, (uint8_t)(slot + 1), k->motor_j[l]);
	r[count++] = lane_row(k, l, side * x, side * y, side * turn, CNI_ROW_LIMIT, (uint8_t)(slot + 2), cni_abs(k->limit_j[l]));
	return count;
}

static void lane_write(const cn_world *world, const cni_joint_constraint *w, const cni_row *r)
{
	cni_joint_block *k = cni_joint_block_of(world, w);
	int32_t l = w->lane % CNI_LANES;
	if (w->form == CNI_FORM_PIN) {
		k->jx[l] = r++->impulse;
		k->jy[l] = r++->impulse;
	}
	k->spring_j[l] = r[0].impulse;
	k->motor_j[l] = r[1].impulse;
	k->limit_j[l] = limit_side(k, l) * r[2].impulse;
}

void cni_joint_impulses_read(const cn_world *world, const cni_joint_constraint *w, cni_joint_impulses *out)
{
	int32_t k;
	if (w->lane != CNI_NONE) {
		out->count = lane_read(world, w, out->rows);
		return;
	}
	out->count = w->row_count;
	for (k = 0; k < w->row_count; ++k) {
		out->rows[k] = w->rows[k];
		if (w->flags & CNI_CONSTRAINT_SPRINGY)
			out->rows[k].kind = CNI_ROW_SOFT;
	}
}

void cni_joint_impulses_write(cn_world *world, cni_joint_constraint *w, const cni_joint_impulses *impulses)
{
	int32_t k;
	if (w->lane != CNI_NONE)
		lane_write(world, w, impulses->rows);
	else
		for (k = 0; k < w->row_count; ++k)
			w->rows[k].impulse = impulses->rows[k].impulse;
}
