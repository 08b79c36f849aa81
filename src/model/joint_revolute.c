/*
 * model/joint_revolute.c - two bodies share a point; spring, motor and limit act on the angle.
 *
 * p: reference, lower, upper, motor speed, motor torque max, spring target, hertz, damping ratio.
 * Impulse slots: 0, 1 point (x, y); 2 spring; 3 motor; 4 limit. stages/joint_kernel.h solves the same without rows.
 */
#include "model/joint_row.h"

static cni_row limit_row(const cni_joint *j, float angle)
{
	float room, sign = cni_limit_side(angle, j->p[CNI_P_LOWER], j->p[CNI_P_UPPER], &room);
	cni_row r = cni_row_angular(CNI_ROW_LIMIT, CNI_REVOLUTE_LIMIT, sign, 1.0f);
	r.error = room;
	return r;
}

static int32_t revolute_rows(const cni_joint *j, const cni_joint_frame *f, cni_row *rows)
{
	int32_t count = 2;
	cni_rows_point(f, f->ra, f->d, CNI_ROW_RIGID, rows);
	if (j->flags & CN_JOINT_SPRING) {
		cni_row r = cni_row_angular(CNI_ROW_SPRING, CNI_REVOLUTE_SPRING, 1.0f, 1.0f);
		r.error = f->angle - j->p[CNI_P_REVOLUTE_TARGET];
		r.hertz = j->p[CNI_P_REVOLUTE_HERTZ];
		r.damping_ratio = j->p[CNI_P_REVOLUTE_DAMPING];
		rows[count++] = r;
	}
	if (j->flags & CN_JOINT_MOTOR) {
		cni_row r = cni_row_angular(CNI_ROW_MOTOR, CNI_REVOLUTE_MOTOR, 1.0f, 1.0f);
		r.target = j->p[CNI_P_MOTOR_SPEED];
		r.limit = j->p[CNI_P_MOTOR_MAX];
		rows[count++] = r;
	}
	if (j->flags & CN_JOINT_LIMIT)
		rows[count++] = limit_row(j, f->angle);
	return count;
}

static float revolute_position(const cni_joint *j, const cni_joint_frame *f)
{
	(void)j;
	return f->angle;
}

static cni_row revolute_speed_row(const cni_joint *j, const cni_joint_frame *f)
{
	(void)j;
	(void)f;
	return cni_row_angular(CNI_ROW_MOTOR, 3, 1.0f, 1.0f);
}

const cni_joint_type cni_joint_revolute = { revolute_rows, revolute_position, revolute_speed_row, CNI_USES_ANGLE | CNI_USES_REFERENCE };
