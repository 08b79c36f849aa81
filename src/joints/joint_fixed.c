/*
 * joints/joint_fixed.c - two bodies welded together: a point and the angle.
 *
 * p: reference, hertz and damping ratio of the angle alone (0 Hz: as stiff as the point).
 * Impulse slots: 0, 1 point (x, y); 2 angle.
 * joints/joint_kernel.h has the same formulas without rows.
 */
#include "joints/joint_row.h"

static int32_t fixed_rows(const cni_joint *j, const cni_joint_frame *f, cni_row *rows)
{
	int32_t soft = j->p[CNI_P_HERTZ] > 0.0f;
	cni_rows_point(f, f->ra, f->d, CNI_ROW_RIGID, rows);
	rows[2] = cni_row_spring(cni_row_angular(soft ? CNI_ROW_SOFT : CNI_ROW_RIGID, 2, 1.0f, 1.0f), f->angle, j->p[CNI_P_HERTZ], j->p[CNI_P_DAMPING]);
	rows[2].limit = j->torque_max;
	return 3;
}

const cni_joint_type cni_joint_fixed = { fixed_rows, cni_joint_position_angle, cni_joint_speed_angle, CNI_USES_ANGLE | CNI_USES_REFERENCE };
