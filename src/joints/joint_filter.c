/*
 * joints/joint_filter.c - the two bodies do not collide. This joint has no rows and is never solved.
 */
#include "joints/joint_row.h"

static int32_t filter_rows(const cni_joint *j, const cni_joint_frame *f, cni_row *rows)
{
	(void)j;
	(void)f;
	(void)rows;
	return 0;
}

static cni_row filter_speed_row(const cni_joint *j, const cni_joint_frame *f)
{
	(void)j;
	(void)f;
	return cni_row_angular(CNI_ROW_MOTOR, 0, 0.0f, 1.0f);
}

const cni_joint_type cni_joint_filter = { filter_rows, cni_joint_position_angle, filter_speed_row, 0 };
