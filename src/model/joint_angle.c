/*
 * model/joint_angle.c - constraint on one body: its angle, over whole turns, stays within limits.
 *
 * p: lower, upper (equal: locked), turns. Impulse slot: 0.
 */
#include "model/joint_row.h"

static int32_t angle_rows(const cni_joint *j, const cni_joint_frame *f, cni_row *rows)
{
	float room, sign = cni_limit_side(f->angle, j->p[CNI_P_LOWER], j->p[CNI_P_UPPER], &room);
	if (j->p[CNI_P_LOWER] == j->p[CNI_P_UPPER]) {
		rows[0] = cni_row_angular(CNI_ROW_RIGID, 0, 1.0f, 1.0f);
		rows[0].error = f->angle - j->p[CNI_P_LOWER];
	} else {
		rows[0] = cni_row_angular(CNI_ROW_LIMIT, 0, sign, 1.0f);
		rows[0].error = room;
	}
	return 1;
}

static float angle_position(const cni_joint *j, const cni_joint_frame *f)
{
	(void)j;
	return f->angle;
}

static cni_row angle_speed_row(const cni_joint *j, const cni_joint_frame *f)
{
	(void)j;
	(void)f;
	return cni_row_angular(CNI_ROW_RIGID, 0, 1.0f, 1.0f);
}

const cni_joint_type cni_joint_angle = { angle_rows, angle_position, angle_speed_row, CNI_USES_TURNS };
