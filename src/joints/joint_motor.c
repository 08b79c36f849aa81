/*
 * joints/joint_motor.c - drives b to an offset and angle from a, by a spring with bounded force and torque.
 *
 * p: angle, offset in a's frame from anchor a, hertz, damping ratio.
 * Impulse slots: 0, 1 point (x, y); 2 angle.
 */
#include "joints/joint_row.h"

static int32_t motor_rows(const cni_joint *j, const cni_joint_frame *f, cni_row *rows)
{
	cni_vec2 offset = cni_rotate(f->qa, cni_v(j->p[CNI_P_MOTOR_OFFSET_X], j->p[CNI_P_MOTOR_OFFSET_Y]));
	int32_t k;
	cni_rows_point(f, cni_add(f->ra, offset), cni_sub(f->d, offset), CNI_ROW_DRIVE, rows);
	rows[2] = cni_row_angular(CNI_ROW_DRIVE, 2, 1.0f, 1.0f);
	rows[2].error = f->angle;
	for (k = 0; k < 3; ++k) {
		rows[k].hertz = j->p[CNI_P_HERTZ];
		rows[k].damping_ratio = j->p[CNI_P_DAMPING];
	}
	return 3;
}

static float motor_position(const cni_joint *j, const cni_joint_frame *f)
{
	return f->angle + j->p[CNI_P_MOTOR_ANGLE];
}

const cni_joint_type cni_joint_motor = { motor_rows, motor_position, cni_joint_speed_angle, CNI_USES_ANGLE | CNI_USES_REFERENCE | CNI_USES_DRIVE };
