/*
 * model/joint_gear.c - angle b = ratio * angle a + phase, over whole turns.
 *
 * p: ratio, phase, turns. Impulse slot: 0.
 */
#include "model/joint_row.h"

static int32_t gear_rows(const cni_joint *j, const cni_joint_frame *f, cni_row *rows)
{
	rows[0] = cni_row_angular(CNI_ROW_RIGID, 0, 1.0f, f->ratio);
	rows[0].error = f->angle - j->p[CNI_P_GEAR_PHASE];
	return 1;
}

static float gear_position(const cni_joint *j, const cni_joint_frame *f)
{
	(void)j;
	return f->angle;
}

static cni_row gear_speed_row(const cni_joint *j, const cni_joint_frame *f)
{
	(void)j;
	return cni_row_angular(CNI_ROW_RIGID, 0, 1.0f, f->ratio);
}

const cni_joint_type cni_joint_gear = { gear_rows, gear_position, gear_speed_row, CNI_USES_TURNS | CNI_USES_RATIO };
