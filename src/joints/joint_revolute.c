/*
 * joints/joint_revolute.c - two bodies share a point; spring, motor and limit act on the angle.
 *
 * p: reference, lower, upper, motor speed, motor torque max, spring target, hertz, damping ratio.
 * Impulse slots: 0, 1 point (x, y); 2 spring; 3 motor; 4 limit.
 * joints/joint_kernel.h has the same formulas without rows.
 */
#include "joints/joint_row.h"

static int32_t revolute_rows(const cni_joint *j, const cni_joint_frame *f, cni_row *rows)
{
	int32_t count = 2;
	cni_rows_point(f, f->ra, f->d, CNI_ROW_RIGID, rows);
	if (j->flags & CN_JOINT_SPRING)
		rows[count++] = cni_row_spring(cni_row_angular(CNI_ROW_SPRING, 2, 1.0f, 1.0f), f->angle - j->p[CNI_P_TARGET], j->p[CNI_P_HERTZ], j->p[CNI_P_DAMPING]);
	if (j->flags & CN_JOINT_MOTOR)
		rows[count++] = cni_row_motor(cni_row_angular(CNI_ROW_MOTOR, 3, 1.0f, 1.0f), j, f->angle, j->flags & CN_JOINT_LIMIT);
	if (j->flags & CN_JOINT_LIMIT)
		rows[count++] = cni_row_limit_angle(j, f->angle, 4);
	return count;
}

const cni_joint_type cni_joint_revolute = { revolute_rows, cni_joint_position_angle, cni_joint_speed_angle, CNI_USES_ANGLE | CNI_USES_REFERENCE };
