/*
 * joints/joint_mouse.c - drags anchor b to anchor a, a point of the world, by a spring with bounded force.
 *
 * p: hertz, damping ratio. Impulse slots: 0, 1 point (x, y).
 */
#include "joints/joint_row.h"

static int32_t mouse_rows(const cni_joint *j, const cni_joint_frame *f, cni_row *rows)
{
	cni_rows_point(f, f->ra, f->d, CNI_ROW_DRIVE, rows);
	rows[0].hertz = rows[1].hertz = j->p[CNI_P_HERTZ];
	rows[0].damping_ratio = rows[1].damping_ratio = j->p[CNI_P_DAMPING];
	return 2;
}

static cni_row mouse_speed_row(const cni_joint *j, const cni_joint_frame *f)
{
	float length = cni_length(f->d);
	(void)j;
	return cni_row_along(f, length > 0.0f ? cni_mul(1.0f / length, f->d) : cni_v(0.0f, 0.0f), f->ra, CNI_ROW_DRIVE, 0, 1.0f);
}

const cni_joint_type cni_joint_mouse = { mouse_rows, cni_joint_position_distance, mouse_speed_row, CNI_USES_DRIVE };
