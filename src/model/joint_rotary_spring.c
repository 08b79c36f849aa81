/*
 * model/joint_rotary_spring.c - a torque that pulls angle b - angle a to rest, over whole turns.
 *
 * p: rest, hertz, damping ratio, turns. Impulse slot: 0.
 */
#include "model/joint_row.h"

static int32_t rotary_spring_rows(const cni_joint *j, const cni_joint_frame *f, cni_row *rows)
{
	rows[0] = cni_row_angular(CNI_ROW_DRIVE, 0, 1.0f, 1.0f);
	rows[0].error = f->angle - j->p[CNI_P_REST];
	rows[0].hertz = j->p[CNI_P_REST_HERTZ];
	rows[0].damping_ratio = j->p[CNI_P_REST_DAMPING];
	return 1;
}

static float rotary_spring_position(const cni_joint *j, const cni_joint_frame *f)
{
	(void)j;
	return f->angle;
}

static cni_row rotary_spring_speed_row(const cni_joint *j, const cni_joint_frame *f)
{
	(void)j;
	(void)f;
	return cni_row_angular(CNI_ROW_DRIVE, 0, 1.0f, 1.0f);
}

const cni_joint_type cni_joint_rotary_spring = { rotary_spring_rows, rotary_spring_position, rotary_spring_speed_row, CNI_USES_TURNS | CNI_USES_DRIVE };
