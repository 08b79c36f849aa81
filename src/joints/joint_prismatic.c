/*
 * joints/joint_prismatic.c - b slides along an axis fixed in a, without turning.
 *
 * p: reference, lower, upper, motor speed, motor force max, spring target, hertz, damping ratio, axis.
 * Impulse slots: 0 across the axis; 1 angle; 2 spring; 3 motor; 4 limit (the last three along the axis).
 */
#include "joints/joint_row.h"

static int32_t prismatic_rows(const cni_joint *j, const cni_joint_frame *f, cni_row *rows)
{
	cni_vec2 axis = cni_joint_axis(j, f), across = cni_left_perp(axis);
	float along = cni_dot(axis, f->d);
	int32_t count = 2;
	rows[0] = cni_row_fixed_direction(f, across, CNI_ROW_RIGID, 0, 1.0f);
	rows[0].error = cni_dot(across, f->d);
	rows[1] = cni_row_angular(CNI_ROW_RIGID, 1, 1.0f, 1.0f);
	rows[1].error = f->angle;
	if (j->flags & CN_JOINT_SPRING)
		rows[count++] = cni_row_spring(cni_row_fixed_direction(f, axis, CNI_ROW_SPRING, 2, 1.0f), along - j->p[CNI_P_TARGET], j->p[CNI_P_HERTZ], j->p[CNI_P_DAMPING]);
	if (j->flags & CN_JOINT_MOTOR)
		rows[count++] = cni_row_motor(cni_row_fixed_direction(f, axis, CNI_ROW_MOTOR, 3, 1.0f), j, along, j->flags & CN_JOINT_LIMIT);
	if (j->flags & CN_JOINT_LIMIT)
		rows[count++] = cni_row_limit_axis(j, f, axis, 4);
	return count;
}

const cni_joint_type cni_joint_prismatic = { prismatic_rows, cni_joint_position_axis, cni_joint_speed_axis, CNI_USES_ANGLE | CNI_USES_REFERENCE };
