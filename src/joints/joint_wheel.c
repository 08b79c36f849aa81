/*
 * joints/joint_wheel.c - a wheel b on the suspension of a: slides along an axis fixed in a, turns freely.
 *
 * p: lower, upper, motor speed, motor torque max, hertz, damping ratio, axis.
 * Impulse slots: 0 across the axis; 2 spring; 3 motor (turns the wheel); 4 limit.
 */
#include "joints/joint_row.h"

static int32_t wheel_rows(const cni_joint *j, const cni_joint_frame *f, cni_row *rows)
{
	cni_vec2 axis = cni_joint_axis(j, f), across = cni_left_perp(axis);
	float along = cni_dot(axis, f->d);
	int32_t count = 1;
	rows[0] = cni_row_fixed_direction(f, across, CNI_ROW_RIGID, 0, 1.0f);
	rows[0].error = cni_dot(across, f->d);
	if (j->flags & CN_JOINT_SPRING)
		rows[count++] = cni_row_spring(cni_row_fixed_direction(f, axis, CNI_ROW_SPRING, 2, 1.0f), along, j->p[CNI_P_HERTZ], j->p[CNI_P_DAMPING]);
	if (j->flags & CN_JOINT_MOTOR)
		rows[count++] = cni_row_motor(cni_row_angular(CNI_ROW_MOTOR, 3, 1.0f, 1.0f), j, 0.0f, 0);
	if (j->flags & CN_JOINT_LIMIT)
		rows[count++] = cni_row_limit_axis(j, f, axis, 4);
	return count;
}

const cni_joint_type cni_joint_wheel = { wheel_rows, cni_joint_position_axis, cni_joint_speed_angle, 0 };
