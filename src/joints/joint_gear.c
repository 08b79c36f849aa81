/*
 * joints/joint_gear.c - angle b = ratio * angle a + phase, over whole turns.
 *
 * p: ratio, phase, turns. Impulse slot: 0.
 */
#include "joints/joint_row.h"

static int32_t gear_rows(const cni_joint *j, const cni_joint_frame *f, cni_row *rows)
{
	rows[0] = cni_row_angular(CNI_ROW_RIGID, 0, 1.0f, f->ratio);
	rows[0].error = f->angle - j->p[CNI_P_GEAR_PHASE];
	return 1;
}

const cni_joint_type cni_joint_gear = { gear_rows, cni_joint_position_angle, cni_joint_speed_angle, CNI_USES_TURNS | CNI_USES_RATIO };
