/*
 * model/joint_wheel.c - a wheel b on the suspension of a: slides along an axis fixed in a, turns freely.
 *
 * p: lower, upper, motor speed, motor torque max, hertz, damping ratio, axis.
 * Impulse slots: 0 across the axis; 2 spring; 3 motor (turns the wheel); 4 limit.
 */
#include "model/joint_row.h"

static float wheel_position(const cni_joint *j, const cni_joint_frame *f)
{
	return cni_dot(cni_joint_axis(j, f), f->d);
}

static int32_t wheel_rows(const cni_joint *j, const cni_joint_frame *f, cni_row *rows)
{
	cni_vec2 axis = cni_joint_axis(j, f), across = cni_left_perp(axis);
	float along = cni_dot(axis, f->d);
	int32_t count = 1;
	rows[0] = cni_row_fixed_direction(f, across, CNI_ROW_RIGID, 0, 1.0f);
	rows[0].error = cni_dot(across, f->d);
	if (j->flags & CN_JOINT_SPRING) {
		rows[count] = cni_row_fixed_direction(f, axis, CNI_ROW_SPRING, 2, 1.0f);
		rows[count].error = along;
		rows[count].hertz = j->p[CNI_P_HERTZ];
		rows[count++].damping_ratio = j->p[CNI_P_DAMPING];
	}
	if (j->flags & CN_JOINT_MOTOR) {
		rows[count] = cni_row_angular(CNI_ROW_MOTOR, 3, 1.0f, 1.0f);
		rows[count].target = j->p[CNI_P_MOTOR_SPEED];
		rows[count++].limit = j->p[CNI_P_MOTOR_MAX];
	}
	if (j->flags & CN_JOINT_LIMIT) {
		float room, sign = cni_limit_side(along, j->p[CNI_P_LOWER], j->p[CNI_P_UPPER], &room);
		rows[count] = cni_row_fixed_direction(f, axis, CNI_ROW_LIMIT, 4, sign);
		rows[count++].error = room;
	}
	return count;
}

static cni_row wheel_speed_row(const cni_joint *j, const cni_joint_frame *f)
{
	(void)j;
	(void)f;
	return cni_row_angular(CNI_ROW_MOTOR, 3, 1.0f, 1.0f);
}

const cni_joint_type cni_joint_wheel = { wheel_rows, wheel_position, wheel_speed_row, 0 };
