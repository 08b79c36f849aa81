/*
 * model/joint_groove.c - anchor b slides in a slot of body a, from anchor a to an end.
 *
 * p: lower 0, upper the slot's length, end in a's frame, axis of the slot.
 * Impulse slots: 0 across the slot; 1 the slot's ends.
 */
#include "model/joint_row.h"

static float groove_position(const cni_joint *j, const cni_joint_frame *f)
{
	return cni_dot(cni_joint_axis(j, f), f->d);
}

static int32_t groove_rows(const cni_joint *j, const cni_joint_frame *f, cni_row *rows)
{
	cni_vec2 axis = cni_joint_axis(j, f), across = cni_left_perp(axis);
	float room, sign = cni_limit_side(cni_dot(axis, f->d), j->p[CNI_P_LOWER], j->p[CNI_P_UPPER], &room);
	rows[0] = cni_row_fixed_direction(f, across, CNI_ROW_RIGID, 0, 1.0f);
	rows[0].error = cni_dot(across, f->d);
	rows[1] = cni_row_fixed_direction(f, axis, CNI_ROW_LIMIT, 1, sign);
	rows[1].error = room;
	return 2;
}

static cni_row groove_speed_row(const cni_joint *j, const cni_joint_frame *f)
{
	return cni_row_fixed_direction(f, cni_joint_axis(j, f), CNI_ROW_MOTOR, 1, 1.0f);
}

const cni_joint_type cni_joint_groove = { groove_rows, groove_position, groove_speed_row, 0 };
