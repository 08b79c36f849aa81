/*
 * joints/joint_distance.c - keeps the distance of two points: rigid rod, spring, or rope with limits.
 *
 * p: length, min, max, motor speed, motor force max, hertz, damping ratio.
 * Impulse slots: 0 rod; 1 spring; 2 motor; 3 limit.
 * joints/joint_kernel.h has the same formulas without rows.
 */
#include "joints/joint_row.h"

/* d/dt |d| = axis . (vb + wb x rb - va - wa x ra) */
static int32_t distance_rows(const cni_joint *j, const cni_joint_frame *f, cni_row *rows)
{
	int32_t count = 0;
	float length;
	cni_vec2 axis = cni_distance_axis(f->d, &length);
	if (!(j->flags & (CN_JOINT_SPRING | CN_JOINT_LIMIT))) {
		rows[0] = cni_row_along(f, axis, f->ra, CNI_ROW_RIGID, 0, 1.0f);
		rows[0].error = length - j->p[CNI_P_LENGTH];
		return 1;
	}
	if (j->flags & CN_JOINT_SPRING) {
		cni_row r = cni_row_along(f, axis, f->ra, CNI_ROW_SPRING, 1, 1.0f);
		rows[count++] = cni_row_spring(r, length - j->p[CNI_P_LENGTH], j->p[CNI_P_DISTANCE_HERTZ], j->p[CNI_P_DISTANCE_DAMPING]);
	}
	if (j->flags & CN_JOINT_MOTOR)
		rows[count++] = cni_row_motor(cni_row_along(f, axis, f->ra, CNI_ROW_MOTOR, 2, 1.0f), j, length, j->flags & CN_JOINT_LIMIT);
	if (j->flags & CN_JOINT_LIMIT) {
		float room, sign = cni_limit_side(length, j->p[CNI_P_LOWER], j->p[CNI_P_UPPER], &room);
		rows[count] = cni_row_along(f, axis, f->ra, CNI_ROW_LIMIT, 3, sign);
		rows[count++].error = room;
	}
	return count;
}

static cni_row distance_speed_row(const cni_joint *j, const cni_joint_frame *f)
{
	float length;
	(void)j;
	return cni_row_along(f, cni_distance_axis(f->d, &length), f->ra, CNI_ROW_MOTOR, 2, 1.0f);
}

const cni_joint_type cni_joint_distance = { distance_rows, cni_joint_position_distance, distance_speed_row, 0 };
