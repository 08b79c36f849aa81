/*
 * joints/joint_line.c - constraint on one body: one of its points stays on a line in the world, within a tolerance to either side, and
 * optionally between limits along it.
 *
 * p: tolerance, lower, upper, axis. Impulse slots: 0 across the line; 1 along it.
 */
#include "joints/joint_row.h"

static cni_row across_row(const cni_joint *j, const cni_joint_frame *f, cni_vec2 across)
{
	float x = cni_dot(across, f->d), tolerance = j->p[CNI_P_LINE_TOLERANCE], room = x;
	float sign = tolerance != 0.0f ? cni_limit_side(x, -tolerance, tolerance, &room) : 1.0f;
	cni_row r = cni_row_fixed_direction(f, across, tolerance != 0.0f ? CNI_ROW_LIMIT : CNI_ROW_RIGID, 0, sign);
	r.error = room;
	return r;
}

static int32_t line_rows(const cni_joint *j, const cni_joint_frame *f, cni_row *rows)
{
	cni_vec2 axis = cni_joint_axis(j, f);
	rows[0] = across_row(j, f, cni_left_perp(axis));
	if (!(j->flags & CN_JOINT_LIMIT))
		return 1;
	rows[1] = cni_row_limit_axis(j, f, axis, 1);
	return 2;
}

const cni_joint_type cni_joint_line = { line_rows, cni_joint_position_axis, cni_joint_speed_axis, 0 };
