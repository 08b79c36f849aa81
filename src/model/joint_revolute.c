/*
 * model/joint_revolute.c - two bodies share a point; spring, motor and limit act on the angle.
 *
 * p: reference, lower, upper, motor speed, motor torque max, spring target, hertz, damping ratio.
 * Impulse slots: 0, 1 point (x, y); 2 spring; 3 motor; 4 limit.
 */
#include "model/joint.h"

#include <string.h>

static cni_row angle_row(uint8_t kind, uint8_t slot, float sign)
{
	cni_row r;
	memset(&r, 0, sizeof r);
	r.aw = -sign;
	r.bw = sign;
	r.kind = kind;
	r.slot = slot;
	r.angular = 1;
	return r;
}

static cni_row limit_row(const cni_joint *j, float angle)
{
	float room_lower = angle - j->p[CNI_P_LOWER], room_upper = j->p[CNI_P_UPPER] - angle;
	int32_t lower = room_lower <= room_upper;
	cni_row r = angle_row(CNI_ROW_LIMIT, 4, lower ? 1.0f : -1.0f);
	r.error = lower ? room_lower : room_upper;
	return r;
}

static int32_t revolute_rows(const cni_joint *j, const cni_joint_frame *f, cni_row *rows)
{
	int32_t count = 2;
	memset(rows, 0, 2 * sizeof *rows);
	rows[0].ax = -1.0f;
	rows[0].aw = f->ra.y;
	rows[0].bx = 1.0f;
	rows[0].bw = -f->rb.y;
	rows[0].error = f->d.x;
	rows[1].ay = -1.0f;
	rows[1].aw = -f->ra.x;
	rows[1].by = 1.0f;
	rows[1].bw = f->rb.x;
	rows[1].error = f->d.y;
	rows[1].slot = 1;
	if (j->flags & CN_JOINT_SPRING) {
		cni_row r = angle_row(CNI_ROW_SPRING, 2, 1.0f);
		r.error = f->angle - j->p[CNI_P_REVOLUTE_TARGET];
		r.hertz = j->p[CNI_P_REVOLUTE_HERTZ];
		r.damping_ratio = j->p[CNI_P_REVOLUTE_DAMPING];
		rows[count++] = r;
	}
	if (j->flags & CN_JOINT_MOTOR) {
		cni_row r = angle_row(CNI_ROW_MOTOR, 3, 1.0f);
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
	return angle_row(CNI_ROW_MOTOR, 3, 1.0f);
}

const cni_joint_type cni_joint_revolute = { revolute_rows, revolute_position, revolute_speed_row };
