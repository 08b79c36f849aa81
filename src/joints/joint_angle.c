/*
 * joints/joint_angle.c - constraint on one body: its angle, over whole turns, stays within limits.
 *
 * p: lower, upper (equal: locked), turns. Impulse slot: 0.
 */
#include "joints/joint_row.h"

static int32_t angle_rows(const cni_joint *j, const cni_joint_frame *f, cni_row *rows)
{
	if (j->p[CNI_P_LOWER] == j->p[CNI_P_UPPER]) {
		rows[0] = cni_row_angular(CNI_ROW_RIGID, 0, 1.0f, 1.0f);
		rows[0].error = f->angle - j->p[CNI_P_LOWER];
	} else {
		rows[0] = cni_row_limit_angle(j, f->angle, 0);
	}
	return 1;
}

const cni_joint_type cni_joint_angle = { angle_rows, cni_joint_position_angle, cni_joint_speed_angle, CNI_USES_TURNS };
