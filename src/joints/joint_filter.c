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

/* Its axis is 0, and so is the speed along it. */
const cni_joint_type cni_joint_filter = { filter_rows, cni_joint_position_angle, cni_joint_speed_axis, 0 };
