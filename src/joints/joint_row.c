/*
 * joints/joint_row.c - positions, speeds and impulses of rows that several joint types share.
 */
#include "joints/joint_row.h"

float cni_joint_position_angle(const cni_joint *j, const cni_joint_frame *f)
{
	(void)j;
	return f->angle;
}

cni_row cni_joint_speed_angle(const cni_joint *j, const cni_joint_frame *f)
{
	(void)j;
	return cni_row_angular(CNI_ROW_MOTOR, 0, 1.0f, f->ratio);
}

float cni_joint_position_axis(const cni_joint *j, const cni_joint_frame *f)
{
	return cni_dot(cni_joint_axis(j, f), f->d);
}

cni_row cni_joint_speed_axis(const cni_joint *j, const cni_joint_frame *f)
{
	return cni_row_fixed_direction(f, cni_joint_axis(j, f), CNI_ROW_MOTOR, 0, 1.0f);
}

float cni_joint_position_distance(const cni_joint *j, const cni_joint_frame *f)
{
	(void)j;
	return cni_length(f->d);
}

void cni_rows_impulse(const cni_row *rows, int32_t count, cni_vec2 rb, cni_vec2 *out_linear, float *out_angular)
{
	cni_vec2 linear = { 0.0f, 0.0f };
	float angular = 0.0f;
	int32_t k;
	for (k = 0; k < count; ++k) {
		cni_vec2 b = cni_v(rows[k].bx, rows[k].by);
		linear = cni_madd(linear, rows[k].impulse, b);
		/* The part of the angular Jacobian that is not the force's own moment about the centre. */
		angular += rows[k].impulse * (rows[k].bw - cni_cross(rb, b));
	}
	*out_linear = linear;
	*out_angular = angular;
}
