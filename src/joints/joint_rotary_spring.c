/*
 * joints/joint_rotary_spring.c - a torque that pulls angle b - angle a to rest, over whole turns.
 *
 * p: rest, hertz, damping ratio, turns. Impulse slot: 0.
 */
#include "joints/joint_row.h"

static int32_t rotary_spring_rows(const cni_joint *j, const cni_joint_frame *f, cni_row *rows)
{
	cni_row r = cni_row_angular(CNI_ROW_DRIVE, 0, 1.0f, 1.0f);
	rows[0] = cni_row_spring(r, f->angle - j->p[CNI_P_REST], j->p[CNI_P_REST_HERTZ], j->p[CNI_P_REST_DAMPING]);
	return 1;
}

const cni_joint_type cni_joint_rotary_spring = { rotary_spring_rows, cni_joint_position_angle, cni_joint_speed_angle, CNI_USES_TURNS | CNI_USES_DRIVE };
