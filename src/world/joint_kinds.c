/*
 * world/joint_kinds.c - tables of the fields of each type of joint and constraint: the place in the public definition and in the
 * record (p[]: table in joint.h), the permitted values, and the default.
 *
 * All fields are checked, whatever the flags are, so that they are valid when a flag is set later.
 */
#include "world/joint_change.h"

#include <stddef.h>
#include <string.h>

#define RATIO_MIN 1e-4f
#define RATIO_MAX 1e4f

/* Permitted values of a field. Fields from VECTORS on have two numbers. */
enum {
	FINITE,
	AT_LEAST_0,
	ABOVE_0,
	ANGLE,
	LOWER,         /* checked with UPPER, the next field */
	UPPER,
	HERTZ,
	HERTZ_ABOVE_0, /* of types that are only a spring */
	HERTZ_OR_RIGID, /* > 0, or CN_DEFAULT, which is stored as 0; so is */
	BREAK,         /* ... this force or threshold */
	DAMPING,
	RATIO,         /* of either sign */
	RATIO_ABOVE_0,
	USER_DATA,
	VECTORS,
	POSITION = VECTORS,
	AXIS           /* stored with length 1 */
};

struct cni_joint_field {
	const char *name;
	size_t in_def, in_joint; /* offsets in bytes */
	int32_t values;
	cn_vec2 initial;         /* x alone for a number */
};

#define P(number) (offsetof(cni_joint, p) + sizeof(float) * (size_t)(number))
#define FIELD(def, name, in_joint, values, initial) { #name, offsetof(def, name), in_joint, values, { initial, 0.0f } }
#define VECTOR(def, name, in_joint, values, x, y) { #name, offsetof(def, name), in_joint, values, { x, y } }
/* What several types have: */
#define LIMITS(def, lower, upper, upper_initial) FIELD(def, lower, P(CNI_P_LOWER), LOWER, 0.0f), FIELD(def, upper, P(CNI_P_UPPER), UPPER, upper_initial)
#define MOTOR(def, speed, most) FIELD(def, speed, P(CNI_P_MOTOR_SPEED), FINITE, 0.0f), FIELD(def, most, P(CNI_P_MOTOR_MAX), AT_LEAST_0, 0.0f)
/* The record has the damping ratio behind the frequency. */
#define SPRING(def, hertz, ratio, in_joint, values, hertz_initial, ratio_initial) \
	FIELD(def, hertz, in_joint, values, hertz_initial), FIELD(def, ratio, (in_joint) + sizeof(float), DAMPING, ratio_initial)

static const cni_joint_field revolute_fields[] = {
	FIELD(cn_revolute_def, reference_angle_rad, P(CNI_P_REFERENCE), ANGLE, 0.0f),
	LIMITS(cn_revolute_def, lower_angle_rad, upper_angle_rad, 0.0f),
	MOTOR(cn_revolute_def, motor_speed_radps, motor_torque_max_Nm),
	FIELD(cn_revolute_def, spring_target_rad, P(CNI_P_TARGET), ANGLE, 0.0f),
	SPRING(cn_revolute_def, spring_hertz, spring_damping_ratio, P(CNI_P_HERTZ), HERTZ, 0.0f, 0.0f)
};
static const cni_joint_field distance_fields[] = {
	FIELD(cn_distance_def, length_m, P(CNI_P_LENGTH), ABOVE_0, 1.0f),
	LIMITS(cn_distance_def, length_min_m, length_max_m, 1.0f),
	MOTOR(cn_distance_def, motor_speed_mps, motor_force_max_N),
	SPRING(cn_distance_def, spring_hertz, spring_damping_ratio, P(CNI_P_DISTANCE_HERTZ), HERTZ, 0.0f, 0.0f)
};
static const cni_joint_field fixed_fields[] = {
	FIELD(cn_fixed_def, reference_angle_rad, P(CNI_P_REFERENCE), ANGLE, 0.0f),
	SPRING(cn_fixed_def, angular_hertz, angular_damping_ratio, P(CNI_P_HERTZ), HERTZ_OR_RIGID, CN_DEFAULT, 0.0f)
};
static const cni_joint_field prismatic_fields[] = {
	VECTOR(cn_prismatic_def, axis, P(CNI_P_AXIS_X), AXIS, 1.0f, 0.0f),
	FIELD(cn_prismatic_def, reference_angle_rad, P(CNI_P_REFERENCE), ANGLE, 0.0f),
	LIMITS(cn_prismatic_def, lower_m, upper_m, 0.0f),
	MOTOR(cn_prismatic_def, motor_speed_mps, motor_force_max_N),
	FIELD(cn_prismatic_def, spring_target_m, P(CNI_P_TARGET), FINITE, 0.0f),
	SPRING(cn_prismatic_def, spring_hertz, spring_damping_ratio, P(CNI_P_HERTZ), HERTZ, 0.0f, 0.0f)
};
static const cni_joint_field wheel_fields[] = {
	VECTOR(cn_wheel_def, axis, P(CNI_P_AXIS_X), AXIS, 0.0f, 1.0f),
	LIMITS(cn_wheel_def, lower_m, upper_m, 0.0f),
	MOTOR(cn_wheel_def, motor_speed_radps, motor_torque_max_Nm),
	SPRING(cn_wheel_def, spring_hertz, spring_damping_ratio, P(CNI_P_HERTZ), HERTZ, 1.0f, 0.7f)
};
static const cni_joint_field motor_fields[] = {
	VECTOR(cn_motor_def, offset_m, P(CNI_P_MOTOR_OFFSET_X), POSITION, 0.0f, 0.0f),
	FIELD(cn_motor_def, angle_rad, P(CNI_P_MOTOR_ANGLE), ANGLE, 0.0f),
	SPRING(cn_motor_def, hertz, damping_ratio, P(CNI_P_HERTZ), HERTZ_ABOVE_0, 5.0f, 1.0f)
};
static const cni_joint_field mouse_fields[] = {
	VECTOR(cn_mouse_def, target_m, offsetof(cni_joint, anchor), POSITION, 0.0f, 0.0f),
	SPRING(cn_mouse_def, hertz, damping_ratio, P(CNI_P_HERTZ), HERTZ_ABOVE_0, 5.0f, 0.7f)
};
static const cni_joint_field gear_fields[] = {
	FIELD(cn_gear_def, ratio, P(CNI_P_GEAR_RATIO), RATIO, 1.0f),
	FIELD(cn_gear_def, phase_rad, P(CNI_P_GEAR_PHASE), ANGLE, 0.0f)
};
static const cni_joint_field pulley_fields[] = {
	VECTOR(cn_pulley_def, ground_a_m, P(CNI_P_PULLEY_GROUND_A), POSITION, 0.0f, 0.0f),
	VECTOR(cn_pulley_def, ground_b_m, P(CNI_P_PULLEY_GROUND_B), POSITION, 0.0f, 0.0f),
	FIELD(cn_pulley_def, ratio, P(CNI_P_PULLEY_RATIO), RATIO_ABOVE_0, 1.0f),
	FIELD(cn_pulley_def, length_m, P(CNI_P_LENGTH), ABOVE_0, 0.0f)
};
static const cni_joint_field ratchet_fields[] = {
	FIELD(cn_ratchet_def, phase_rad, P(CNI_P_RATCHET_PHASE), ANGLE, 0.0f),
	FIELD(cn_ratchet_def, click_rad, P(CNI_P_RATCHET_CLICK), RATIO, 0.0f)
};
static const cni_joint_field rotary_spring_fields[] = {
	FIELD(cn_rotary_spring_def, rest_angle_rad, P(CNI_P_REST), ANGLE, 0.0f),
	SPRING(cn_rotary_spring_def, hertz, damping_ratio, P(CNI_P_REST_HERTZ), HERTZ_ABOVE_0, 1.0f, 0.0f)
};
static const cni_joint_field groove_fields[] = {
	VECTOR(cn_groove_def, end_m, P(CNI_P_GROOVE_END_X), POSITION, 1.0f, 0.0f)
};
static const cni_joint_field angle_fields[] = {
	LIMITS(cn_angle_constraint_def, lower_rad, upper_rad, 0.0f),
	SPRING(cn_angle_constraint_def, hertz, damping_ratio, offsetof(cni_joint, stiffness_hertz), HERTZ_OR_RIGID, CN_DEFAULT, 0.0f),
	FIELD(cn_angle_constraint_def, break_torque_Nm, offsetof(cni_joint, break_torque), BREAK, CN_DEFAULT),
	FIELD(cn_angle_constraint_def, user_data, offsetof(cni_joint, user_data), USER_DATA, 0.0f)
};
static const cni_joint_field line_fields[] = {
	VECTOR(cn_line_constraint_def, anchor_m, offsetof(cni_joint, anchor) + sizeof(cni_vec2), POSITION, 0.0f, 0.0f),
	VECTOR(cn_line_constraint_def, origin_m, offsetof(cni_joint, anchor), POSITION, 0.0f, 0.0f),
	VECTOR(cn_line_constraint_def, axis, P(CNI_P_AXIS_X), AXIS, 1.0f, 0.0f),
	FIELD(cn_line_constraint_def, tolerance_m, P(CNI_P_LINE_TOLERANCE), AT_LEAST_0, 0.0f),
	LIMITS(cn_line_constraint_def, lower_m, upper_m, 0.0f),
	SPRING(cn_line_constraint_def, hertz, damping_ratio, offsetof(cni_joint, stiffness_hertz), HERTZ_OR_RIGID, CN_DEFAULT, 0.0f),
	FIELD(cn_line_constraint_def, break_force_N, offsetof(cni_joint, break_force), BREAK, CN_DEFAULT),
	FIELD(cn_line_constraint_def, user_data, offsetof(cni_joint, user_data), USER_DATA, 0.0f)
};

/* Of all joints: the members of cn_joint_base that say how strong the joint is. */
static const cni_joint_field strength_fields[] = {
	SPRING(cn_joint_base, stiffness_hertz, stiffness_damping_ratio, offsetof(cni_joint, stiffness_hertz), HERTZ_OR_RIGID, CN_DEFAULT, 0.0f),
	FIELD(cn_joint_base, force_max_N, offsetof(cni_joint, force_max), BREAK, CN_DEFAULT),
	FIELD(cn_joint_base, torque_max_Nm, offsetof(cni_joint, torque_max), BREAK, CN_DEFAULT),
	FIELD(cn_joint_base, break_force_N, offsetof(cni_joint, break_force), BREAK, CN_DEFAULT),
	FIELD(cn_joint_base, break_torque_Nm, offsetof(cni_joint, break_torque), BREAK, CN_DEFAULT)
};

#define KIND(def, fields, has) { sizeof(def), #def "_init", fields, (int32_t)(sizeof fields / sizeof fields[0]), has }

const cni_joint_kind *cni_joint_kind_of(int32_t type)
{
	static const cni_joint_kind kinds[CNI_JOINT_STRENGTH + 1] = {
		KIND(cn_revolute_def, revolute_fields, CNI_KIND_HAS_MOTOR | CNI_KIND_HAS_LIMITS),
		KIND(cn_distance_def, distance_fields, CNI_KIND_HAS_MOTOR | CNI_KIND_HAS_LIMITS),
		KIND(cn_fixed_def, fixed_fields, 0),
		KIND(cn_prismatic_def, prismatic_fields, CNI_KIND_HAS_MOTOR | CNI_KIND_HAS_LIMITS),
		KIND(cn_wheel_def, wheel_fields, CNI_KIND_HAS_MOTOR | CNI_KIND_HAS_LIMITS),
		KIND(cn_motor_def, motor_fields, CNI_KIND_NEEDS_FORCE_MAX),
		KIND(cn_mouse_def, mouse_fields, CNI_KIND_NEEDS_FORCE_MAX),
		KIND(cn_gear_def, gear_fields, 0),
		KIND(cn_pulley_def, pulley_fields, 0),
		KIND(cn_ratchet_def, ratchet_fields, 0),
		KIND(cn_rotary_spring_def, rotary_spring_fields, 0),
		KIND(cn_groove_def, groove_fields, 0),
		{ sizeof(cn_filter_joint_def), "cn_filter_joint_def_init", NULL, 0, 0 },
		KIND(cn_angle_constraint_def, angle_fields, 0),
		KIND(cn_line_constraint_def, line_fields, 0),
		KIND(cn_joint_base, strength_fields, 0)
	};
	return kinds + type;
}

/* ------------------------------------------------------------------ checks */

static size_t field_bytes(const cni_joint_field *field)
{
	return field->values >= VECTORS ? sizeof(cn_vec2) : field->values == USER_DATA ? sizeof(uint64_t) : sizeof(float);
}

static int32_t has_default(const cni_joint_field *field) { return field->values == HERTZ_OR_RIGID || field->values == BREAK; }

static void check_ratio(cni_call *call, const char *field, float ratio)
{
	if (!(cni_abs(ratio) >= RATIO_MIN && cni_abs(ratio) <= RATIO_MAX))
		cni_refuse_float(call, field, ratio, "must have a size from 1e-4 to 1e4");
}

static void check_axis(cni_call *call, cn_vec2 axis)
{
	cni_check_finite2(call, "axis", axis);
	cni_check(call, axis.x != 0.0f || axis.y != 0.0f, CN_ERROR_ARGUMENT, "axis (0, 0); must have a length > 0");
}

void cni_check_joint_limits(cni_call *call, int32_t type, float lower, float upper)
{
	if (type == CN_JOINT_REVOLUTE) {
		cni_check_range(call, "lower angle", lower, -CNI_PI, CNI_PI);
		cni_check_range(call, "upper angle", upper, -CNI_PI, CNI_PI);
	} else if (type == CN_JOINT_DISTANCE) {
		cni_check_at_least(call, "least length", lower, 0.0f);
		cni_check_at_least(call, "greatest length", upper, 0.0f);
	} else if (type == CNI_JOINT_ANGLE) {
		cni_check_angle(call, "lower_rad", lower);
		cni_check_angle(call, "upper_rad", upper);
	} else {
		cni_check_finite(call, "lower limit", lower);
		cni_check_finite(call, "upper limit", upper);
	}
	if (lower > upper)
		cni_refuse_float(call, "lower limit", lower, "must not be above the upper one");
}

static void check_number(cni_call *call, int32_t type, const cni_joint_field *field, float value, float before)
{
	switch (field->values) {
	case FINITE: cni_check_finite(call, field->name, value); break;
	case AT_LEAST_0: cni_check_at_least(call, field->name, value, 0.0f); break;
	case ABOVE_0: cni_check_positive(call, field->name, value); break;
	case ANGLE: cni_check_angle(call, field->name, value); break;
	case UPPER: cni_check_joint_limits(call, type, before, value); break;
	case HERTZ_ABOVE_0: cni_check_positive(call, field->name, value); /* fall through */
	case HERTZ: cni_check_range(call, field->name, value, 0.0f, CNI_HERTZ_MAX); break;
	case HERTZ_OR_RIGID: cni_check_above_0_or_default(call, field->name, value, CNI_HERTZ_MAX); break;
	case BREAK: cni_check_positive_or_default(call, field->name, value); break;
	case DAMPING: cni_check_range(call, field->name, value, 0.0f, CNI_DAMPING_RATIO_MAX); break;
	case RATIO: check_ratio(call, field->name, value); break;
	case RATIO_ABOVE_0: cni_check_range(call, field->name, value, RATIO_MIN, RATIO_MAX); break;
	default: break;
	}
}

void cni_joint_def_check(cni_call *call, int32_t type, const void *def)
{
	const cni_joint_kind *kind = cni_joint_kind_of(type);
	float before = 0.0f;
	for (int32_t k = 0; k < kind->field_count; ++k) {
		const cni_joint_field *field = kind->fields + k;
		cn_vec2 value = { 0.0f, 0.0f };
		if (field->values == USER_DATA)
			continue;
		memcpy(&value, (const char *)def + field->in_def, field_bytes(field));
		if (field->values == POSITION)
			cni_check_position(call, field->name, value);
		else if (field->values == AXIS)
			check_axis(call, value);
		else
			check_number(call, type, field, value.x, before);
		before = value.x;
	}
}

/* ------------------------------------------------------------------ definition and record */

static void fields_init(const cni_joint_kind *kind, void *def)
{
	for (int32_t k = 0; k < kind->field_count; ++k)
		if (kind->fields[k].values != USER_DATA)
			memcpy((char *)def + kind->fields[k].in_def, &kind->fields[k].initial, field_bytes(kind->fields + k));
}

void cni_joint_def_init(int32_t type, void *def)
{
	if (!cni_def_begin(def, cni_joint_kind_of(type)->bytes))
		return;
	fields_init(cni_joint_kind_of(type), def);
	if (!cni_joint_is_constraint(type))
		fields_init(cni_joint_kind_of(CNI_JOINT_STRENGTH), def);
}

/* Replaces a number by a function of it. */
static void turn(void *number, float (*function)(float))
{
	float value;
	memcpy(&value, number, sizeof value);
	value = function(value);
	memcpy(number, &value, sizeof value);
}

static void store_axis(cni_joint *j, cn_vec2 axis)
{
	/* Scale by the larger component first: the squares of very long and very short axes would overflow or underflow. */
	float size = cni_max(cni_abs(axis.x), cni_abs(axis.y));
	cni_vec2 unit = cni_normalize(cni_v(axis.x / size, axis.y / size));
	j->p[CNI_P_AXIS_X] = unit.x;
	j->p[CNI_P_AXIS_Y] = unit.y;
}

void cni_joint_def_store(cni_joint *j, int32_t type, const void *def)
{
	const cni_joint_kind *kind = cni_joint_kind_of(type);
	for (int32_t k = 0; k < kind->field_count; ++k) {
		const cni_joint_field *field = kind->fields + k;
		memcpy((char *)j + field->in_joint, (const char *)def + field->in_def, field_bytes(field));
		if (has_default(field))
			turn((char *)j + field->in_joint, cni_zero_of_default);
		if (field->values == AXIS)
			store_axis(j, cni_v(j->p[CNI_P_AXIS_X], j->p[CNI_P_AXIS_Y]));
	}
	if (type == CN_JOINT_GROOVE) {
		cni_vec2 slot = cni_sub(cni_v(j->p[CNI_P_GROOVE_END_X], j->p[CNI_P_GROOVE_END_Y]), j->anchor[0]);
		store_axis(j, slot);
		j->p[CNI_P_UPPER] = cni_length(slot);
	}
}

void cni_joint_def_read(const cni_joint *j, int32_t type, void *def)
{
	const cni_joint_kind *kind = cni_joint_kind_of(type);
	for (int32_t k = 0; k < kind->field_count; ++k) {
		const cni_joint_field *field = kind->fields + k;
		memcpy((char *)def + field->in_def, (const char *)j + field->in_joint, field_bytes(field));
		if (has_default(field))
			turn((char *)def + field->in_def, cni_default_of_zero);
	}
}
