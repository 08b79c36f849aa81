/*
 * joints/joint_row.h - row constructors shared by joint types (signs and letters as in joint.h).
 */
#ifndef CNI_JOINTS_JOINT_ROW_H
#define CNI_JOINTS_JOINT_ROW_H

#include "joints/joint_type.h"

#include <string.h>

/* d/dt of sign * (angle b - ratio * angle a). */
static inline cni_row cni_row_angular(uint8_t kind, uint8_t slot, float sign, float ratio)
{
	cni_row r;
	memset(&r, 0, sizeof r);
	r.aw = -sign * ratio;
	r.bw = sign;
	r.kind = kind;
	r.slot = slot;
	r.angular = 1;
	return r;
}

/* d/dt of sign * direction . d; reach is a's lever: ra, or ra + d when the direction turns with a. */
static inline cni_row cni_row_along(const cni_joint_frame *f, cni_vec2 direction, cni_vec2 reach, uint8_t kind, uint8_t slot, float sign)
{
	cni_row r;
	memset(&r, 0, sizeof r);
	r.ax = -sign * direction.x;
	r.ay = -sign * direction.y;
	r.aw = -sign * cni_cross(reach, direction);
	r.bx = sign * direction.x;
	r.by = sign * direction.y;
	r.bw = sign * cni_cross(f->rb, direction);
	r.kind = kind;
	r.slot = slot;
	return r;
}

/* From one point to the other, whose distance is d, and its length; coinciding points have an arbitrary fixed axis. */
static inline cni_vec2 cni_distance_axis(cni_vec2 d, float *out_length)
{
	*out_length = cni_length(d);
	return *out_length > 1e-9f ? cni_mul(1.0f / *out_length, d) : cni_v(1.0f, 0.0f);
}

/* A direction fixed in body a. */
static inline cni_row cni_row_fixed_direction(const cni_joint_frame *f, cni_vec2 direction, uint8_t kind, uint8_t slot, float sign)
{
	return cni_row_along(f, direction, cni_add(f->ra, f->d), kind, slot, sign);
}

/* Turns the two rows of a point of b held at a point of a, seen from the centres of mass at ra and rb. */
static inline void cni_rows_point_turn(cni_row *rows, cni_vec2 ra, cni_vec2 rb, cni_vec2 gap)
{
	rows[0].aw = ra.y;
	rows[0].bw = -rb.y;
	rows[0].error = gap.x;
	rows[1].aw = -ra.x;
	rows[1].bw = rb.x;
	rows[1].error = gap.y;
}

/* These rows; slots 0 and 1. */
static inline void cni_rows_point(const cni_joint_frame *f, cni_vec2 ra, cni_vec2 gap, uint8_t kind, cni_row *rows)
{
	memset(rows, 0, 2 * sizeof *rows);
	rows[0].ax = rows[1].ay = -1.0f;
	rows[0].bx = rows[1].by = 1.0f;
	rows[0].kind = rows[1].kind = kind;
	rows[1].slot = 1;
	cni_rows_point_turn(rows, ra, f->rb, gap);
}

/* Nearer end of lower <= x <= upper: returns 1 or -1, the row's sign, and the remaining gap there. */
static inline float cni_limit_side(float x, float lower, float upper, float *out_room)
{
	float room_lower = x - lower, room_upper = upper - x;
	*out_room = cni_min(room_lower, room_upper);
	return room_lower <= room_upper ? 1.0f : -1.0f;
}

/* The type's axis in world directions. */
static inline cni_vec2 cni_joint_axis(const cni_joint *j, const cni_joint_frame *f)
{
	return cni_rotate(f->qa, cni_v(j->p[CNI_P_AXIS_X], j->p[CNI_P_AXIS_Y]));
}

/* Completes a row as a spring or a motor. */
static inline cni_row cni_row_spring(cni_row r, float error, float hertz, float damping_ratio)
{
	r.error = error;
	r.hertz = hertz;
	r.damping_ratio = damping_ratio;
	return r;
}

/* x: the position that the joint's limits bound, if the motor moves along it. */
static inline cni_row cni_row_motor(cni_row r, const cni_joint *j, float x, uint32_t limited)
{
	r.target = j->p[CNI_P_MOTOR_SPEED];
	r.limit = j->p[CNI_P_MOTOR_MAX];
	r.below = limited ? x - j->p[CNI_P_LOWER] : CNI_NO_LIMIT;
	r.above = limited ? j->p[CNI_P_UPPER] - x : CNI_NO_LIMIT;
	return r;
}

/* A limit of the angle, or of the position along an axis fixed in body a, at the nearer end. */
static inline cni_row cni_row_limit_angle(const cni_joint *j, float angle, uint8_t slot)
{
	float room, sign = cni_limit_side(angle, j->p[CNI_P_LOWER], j->p[CNI_P_UPPER], &room);
	cni_row r = cni_row_angular(CNI_ROW_LIMIT, slot, sign, 1.0f);
	r.error = room;
	return r;
}

static inline cni_row cni_row_limit_axis(const cni_joint *j, const cni_joint_frame *f, cni_vec2 axis, uint8_t slot)
{
	float room, sign = cni_limit_side(cni_dot(axis, f->d), j->p[CNI_P_LOWER], j->p[CNI_P_UPPER], &room);
	cni_row r = cni_row_fixed_direction(f, axis, CNI_ROW_LIMIT, slot, sign);
	r.error = room;
	return r;
}

/* Read-back of position and speed: the angle, the position along the axis, the distance of the anchors. */
cni_joint_position_fn cni_joint_position_angle, cni_joint_position_axis, cni_joint_position_distance;
cni_joint_speed_fn cni_joint_speed_angle, cni_joint_speed_axis;

#endif
