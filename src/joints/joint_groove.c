/*
 * joints/joint_groove.c - anchor b slides in a slot of body a, from anchor a to an end.
 *
 * p: lower 0, upper the slot's length, end in a's frame, axis of the slot.
 * Impulse slots: 0 across the slot; 1 the slot's ends.
 */
#include "joints/joint_row.h"

static int32_t groove_rows(const cni_joint *j, const cni_joint_frame *f, cni_row *rows)
{
	cni_vec2 axis = cni_joint_axis(j, f), across = cni_left_perp(axis);
	rows[0] = cni_row_fixed_direction(f, across, CNI_ROW_RIGID, 0, 1.0f);
	rows[0].error = cni_dot(across, f->d);
	rows[1] = cni_row_limit_axis(j, f, axis, 1);
	return 2;
}

const cni_joint_type cni_joint_groove = { groove_rows, cni_joint_position_axis, cni_joint_speed_axis, 0 };
