/*
 * world/joint_kinds.c - what is particular to each joint type in its public definition: defaults, checks, and
 * the way into the record's numbers p[] (table in joint.h) and back.
 *
 * All numbers are checked whatever the flags say, so that turning a flag on later finds good ones.
 */
#include "world/joint_change.h"

#include <string.h>

#define RATIO_MIN 1e-4f
#define RATIO_MAX 1e4f

/* ------------------------------------------------------------------ parts */

static void init_base(void *def, size_t bytes)
{
	memset(def, 0, bytes);
	((cn_joint_base *)def)->struct_size = (uint32_t)bytes;
}

static void check_spring(cni_call *call, float hertz, float damping_ratio)
{
	cni_check_softness(call, "spring_hertz", hertz, "spring_damping_ratio", damping_ratio);
}

/* For types that are nothing without their spring. */
static void check_drive(cni_call *call, float hertz, float damping_ratio)
{
	cni_check_positive(call, "hertz", hertz);
	cni_check_softness(call, "hertz", hertz, "damping_ratio", damping_ratio);
}

static void check_ratio(cni_call *call, const char *field, float ratio)
{
	if (!(cni_abs(ratio) >= RATIO_MIN && cni_abs(ratio) <= RATIO_MAX))
		cni_refuse_float(call, field, ratio, "must have a size from 1e-4 to 1e4");
}

void cni_check_axis(cni_call *call, cn_vec2 axis)
{
	cni_check_finite2(call, "axis", axis);
	if (axis.x == 0.0f && axis.y == 0.0f)
		cni_refuse(call, CN_ERROR_ARGUMENT, "axis (0, 0); must have a length > 0");
}

void cni_joint_store_axis(cni_joint *j, cn_vec2 axis)
{
	/* The larger part first: squares of very long and very short axes would leave the range of floats. */
	float size = cni_max(cni_abs(axis.x), cni_abs(axis.y));
	cni_vec2 unit = cni_normalize(cni_v(axis.x / size, axis.y / size));
	j->p[CNI_P_AXIS_X] = unit.x;
	j->p[CNI_P_AXIS_Y] = unit.y;
}

static cn_vec2 read_axis(const cni_joint *j)
{
	return cni_v(j->p[CNI_P_AXIS_X], j->p[CNI_P_AXIS_Y]);
}

/* ------------------------------------------------------------------ revolute */

void cn_revolute_def_init(cn_revolute_def *def)
{
	if (def != NULL)
		init_base(def, sizeof *def);
}

static void check_revolute(cni_call *call, const cn_joint_base *base, const void *from)
{
	const cn_revolute_def *def = (const cn_revolute_def *)from;
	(void)base;
	cni_check_angle(call, "reference_angle_rad", def->reference_angle_rad);
	cni_check_joint_limits(call, CN_JOINT_REVOLUTE, def->lower_angle_rad, def->upper_angle_rad);
	cni_check_finite(call, "motor_speed_radps", def->motor_speed_radps);
	cni_check_at_least(call, "motor_torque_max_Nm", def->motor_torque_max_Nm, 0.0f);
	cni_check_angle(call, "spring_target_rad", def->spring_target_rad);
	check_spring(call, def->spring_hertz, def->spring_damping_ratio);
}

static void store_revolute(cni_joint *j, const void *from)
{
	const cn_revolute_def *def = (const cn_revolute_def *)from;
	j->p[CNI_P_REFERENCE] = def->reference_angle_rad;
	j->p[CNI_P_LOWER] = def->lower_angle_rad;
	j->p[CNI_P_UPPER] = def->upper_angle_rad;
	j->p[CNI_P_MOTOR_SPEED] = def->motor_speed_radps;
	j->p[CNI_P_MOTOR_MAX] = def->motor_torque_max_Nm;
	j->p[CNI_P_REVOLUTE_TARGET] = def->spring_target_rad;
	j->p[CNI_P_REVOLUTE_HERTZ] = def->spring_hertz;
	j->p[CNI_P_REVOLUTE_DAMPING] = def->spring_damping_ratio;
}

static void read_revolute(const cni_joint *j, void *to)
{
	cn_revolute_def *def = (cn_revolute_def *)to;
	def->reference_angle_rad = j->p[CNI_P_REFERENCE];
	def->lower_angle_rad = j->p[CNI_P_LOWER];
	def->upper_angle_rad = j->p[CNI_P_UPPER];
	def->motor_speed_radps = j->p[CNI_P_MOTOR_SPEED];
	def->motor_torque_max_Nm = j->p[CNI_P_MOTOR_MAX];
	def->spring_target_rad = j->p[CNI_P_REVOLUTE_TARGET];
	def->spring_hertz = j->p[CNI_P_REVOLUTE_HERTZ];
	def->spring_damping_ratio = j->p[CNI_P_REVOLUTE_DAMPING];
}

/* ------------------------------------------------------------------ distance */

void cn_distance_def_init(cn_distance_def *def)
{
	if (def == NULL)
		return;
	init_base(def, sizeof *def);
	def->length_m = 1.0f;
	def->length_max_m = 1.0f;
}

static void check_distance(cni_call *call, const cn_joint_base *base, const void *from)
{
	const cn_distance_def *def = (const cn_distance_def *)from;
	(void)base;
	cni_check_positive(call, "length_m", def->length_m);
	cni_check_joint_limits(call, CN_JOINT_DISTANCE, def->length_min_m, def->length_max_m);
	cni_check_finite(call, "motor_speed_mps", def->motor_speed_mps);
	cni_check_at_least(call, "motor_force_max_N", def->motor_force_max_N, 0.0f);
	check_spring(call, def->spring_hertz, def->spring_damping_ratio);
}

static void store_distance(cni_joint *j, const void *from)
{
	const cn_distance_def *def = (const cn_distance_def *)from;
	j->p[CNI_P_LENGTH] = def->length_m;
	j->p[CNI_P_LOWER] = def->length_min_m;
	j->p[CNI_P_UPPER] = def->length_max_m;
	j->p[CNI_P_MOTOR_SPEED] = def->motor_speed_mps;
	j->p[CNI_P_MOTOR_MAX] = def->motor_force_max_N;
	j->p[CNI_P_DISTANCE_HERTZ] = def->spring_hertz;
	j->p[CNI_P_DISTANCE_DAMPING] = def->spring_damping_ratio;
}

static void read_distance(const cni_joint *j, void *to)
{
	cn_distance_def *def = (cn_distance_def *)to;
	def->length_m = j->p[CNI_P_LENGTH];
	def->length_min_m = j->p[CNI_P_LOWER];
	def->length_max_m = j->p[CNI_P_UPPER];
	def->motor_speed_mps = j->p[CNI_P_MOTOR_SPEED];
	def->motor_force_max_N = j->p[CNI_P_MOTOR_MAX];
	def->spring_hertz = j->p[CNI_P_DISTANCE_HERTZ];
	def->spring_damping_ratio = j->p[CNI_P_DISTANCE_DAMPING];
}

/* ------------------------------------------------------------------ fixed */

void cn_fixed_def_init(cn_fixed_def *def)
{
	if (def != NULL)
		init_base(def, sizeof *def);
}

static void check_fixed(cni_call *call, const cn_joint_base *base, const void *from)
{
	const cn_fixed_def *def = (const cn_fixed_def *)from;
	(void)base;
	cni_check_angle(call, "reference_angle_rad", def->reference_angle_rad);
	cni_check_softness(call, "angular_hertz", def->angular_hertz, "angular_damping_ratio", def->angular_damping_ratio);
}

static void store_fixed(cni_joint *j, const void *from)
{
	const cn_fixed_def *def = (const cn_fixed_def *)from;
	j->p[CNI_P_REFERENCE] = def->reference_angle_rad;
	j->p[CNI_P_HERTZ] = def->angular_hertz;
	j->p[CNI_P_DAMPING] = def->angular_damping_ratio;
}

static void read_fixed(const cni_joint *j, void *to)
{
	cn_fixed_def *def = (cn_fixed_def *)to;
	def->reference_angle_rad = j->p[CNI_P_REFERENCE];
	def->angular_hertz = j->p[CNI_P_HERTZ];
	def->angular_damping_ratio = j->p[CNI_P_DAMPING];
}

/* ------------------------------------------------------------------ prismatic */

void cn_prismatic_def_init(cn_prismatic_def *def)
{
	if (def == NULL)
		return;
	init_base(def, sizeof *def);
	def->axis.x = 1.0f;
}

static void check_prismatic(cni_call *call, const cn_joint_base *base, const void *from)
{
	const cn_prismatic_def *def = (const cn_prismatic_def *)from;
	(void)base;
	cni_check_axis(call, def->axis);
	cni_check_angle(call, "reference_angle_rad", def->reference_angle_rad);
	cni_check_joint_limits(call, CN_JOINT_PRISMATIC, def->lower_m, def->upper_m);
	cni_check_finite(call, "motor_speed_mps", def->motor_speed_mps);
	cni_check_at_least(call, "motor_force_max_N", def->motor_force_max_N, 0.0f);
	cni_check_finite(call, "spring_target_m", def->spring_target_m);
	check_spring(call, def->spring_hertz, def->spring_damping_ratio);
}

static void store_prismatic(cni_joint *j, const void *from)
{
	const cn_prismatic_def *def = (const cn_prismatic_def *)from;
	cni_joint_store_axis(j, def->axis);
	j->p[CNI_P_REFERENCE] = def->reference_angle_rad;
	j->p[CNI_P_LOWER] = def->lower_m;
	j->p[CNI_P_UPPER] = def->upper_m;
	j->p[CNI_P_MOTOR_SPEED] = def->motor_speed_mps;
	j->p[CNI_P_MOTOR_MAX] = def->motor_force_max_N;
	j->p[CNI_P_TARGET] = def->spring_target_m;
	j->p[CNI_P_HERTZ] = def->spring_hertz;
	j->p[CNI_P_DAMPING] = def->spring_damping_ratio;
}

static void read_prismatic(const cni_joint *j, void *to)
{
	cn_prismatic_def *def = (cn_prismatic_def *)to;
	def->axis = read_axis(j);
	def->reference_angle_rad = j->p[CNI_P_REFERENCE];
	def->lower_m = j->p[CNI_P_LOWER];
	def->upper_m = j->p[CNI_P_UPPER];
	def->motor_speed_mps = j->p[CNI_P_MOTOR_SPEED];
	def->motor_force_max_N = j->p[CNI_P_MOTOR_MAX];
	def->spring_target_m = j->p[CNI_P_TARGET];
	def->spring_hertz = j->p[CNI_P_HERTZ];
	def->spring_damping_ratio = j->p[CNI_P_DAMPING];
}

/* ------------------------------------------------------------------ wheel */

void cn_wheel_def_init(cn_wheel_def *def)
{
	if (def == NULL)
		return;
	init_base(def, sizeof *def);
	def->axis.y = 1.0f;
	def->spring_hertz = 1.0f;
	def->spring_damping_ratio = 0.7f;
}

static void check_wheel(cni_call *call, const cn_joint_base *base, const void *from)
{
	const cn_wheel_def *def = (const cn_wheel_def *)from;
	(void)base;
	cni_check_axis(call, def->axis);
	cni_check_joint_limits(call, CN_JOINT_WHEEL, def->lower_m, def->upper_m);
	cni_check_finite(call, "motor_speed_radps", def->motor_speed_radps);
	cni_check_at_least(call, "motor_torque_max_Nm", def->motor_torque_max_Nm, 0.0f);
	check_spring(call, def->spring_hertz, def->spring_damping_ratio);
}

static void store_wheel(cni_joint *j, const void *from)
{
	const cn_wheel_def *def = (const cn_wheel_def *)from;
	cni_joint_store_axis(j, def->axis);
	j->p[CNI_P_LOWER] = def->lower_m;
	j->p[CNI_P_UPPER] = def->upper_m;
	j->p[CNI_P_MOTOR_SPEED] = def->motor_speed_radps;
	j->p[CNI_P_MOTOR_MAX] = def->motor_torque_max_Nm;
	j->p[CNI_P_HERTZ] = def->spring_hertz;
	j->p[CNI_P_DAMPING] = def->spring_damping_ratio;
}

static void read_wheel(const cni_joint *j, void *to)
{
	cn_wheel_def *def = (cn_wheel_def *)to;
	def->axis = read_axis(j);
	def->lower_m = j->p[CNI_P_LOWER];
	def->upper_m = j->p[CNI_P_UPPER];
	def->motor_speed_radps = j->p[CNI_P_MOTOR_SPEED];
	def->motor_torque_max_Nm = j->p[CNI_P_MOTOR_MAX];
	def->spring_hertz = j->p[CNI_P_HERTZ];
	def->spring_damping_ratio = j->p[CNI_P_DAMPING];
}

/* ------------------------------------------------------------------ motor */

void cn_motor_def_init(cn_motor_def *def)
{
	if (def == NULL)
		return;
	init_base(def, sizeof *def);
	def->hertz = 5.0f;
	def->damping_ratio = 1.0f;
}

static void check_motor(cni_call *call, const cn_joint_base *base, const void *from)
{
	const cn_motor_def *def = (const cn_motor_def *)from;
	(void)base;
	cni_check_position(call, "offset_m", def->offset_m);
	cni_check_angle(call, "angle_rad", def->angle_rad);
	check_drive(call, def->hertz, def->damping_ratio);
}

static void store_motor(cni_joint *j, const void *from)
{
	const cn_motor_def *def = (const cn_motor_def *)from;
	j->p[CNI_P_MOTOR_ANGLE] = def->angle_rad;
	j->p[CNI_P_MOTOR_OFFSET_X] = def->offset_m.x;
	j->p[CNI_P_MOTOR_OFFSET_Y] = def->offset_m.y;
	j->p[CNI_P_HERTZ] = def->hertz;
	j->p[CNI_P_DAMPING] = def->damping_ratio;
}

static void read_motor(const cni_joint *j, void *to)
{
	cn_motor_def *def = (cn_motor_def *)to;
	def->angle_rad = j->p[CNI_P_MOTOR_ANGLE];
	def->offset_m = cni_v(j->p[CNI_P_MOTOR_OFFSET_X], j->p[CNI_P_MOTOR_OFFSET_Y]);
	def->hertz = j->p[CNI_P_HERTZ];
	def->damping_ratio = j->p[CNI_P_DAMPING];
}

/* ------------------------------------------------------------------ mouse */

void cn_mouse_def_init(cn_mouse_def *def)
{
	if (def == NULL)
		return;
	init_base(def, sizeof *def);
	def->hertz = 5.0f;
	def->damping_ratio = 0.7f;
}

static void check_mouse(cni_call *call, const cn_joint_base *base, const void *from)
{
	const cn_mouse_def *def = (const cn_mouse_def *)from;
	if (base->body_a != 0)
		cni_refuse(call, CN_ERROR_ARGUMENT, "body_a; must be 0 (the world) in this type");
	cni_check_position(call, "target_m", def->target_m);
	check_drive(call, def->hertz, def->damping_ratio);
}

static void store_mouse(cni_joint *j, const void *from)
{
	const cn_mouse_def *def = (const cn_mouse_def *)from;
	j->anchor[0] = def->target_m;
	j->p[CNI_P_HERTZ] = def->hertz;
	j->p[CNI_P_DAMPING] = def->damping_ratio;
}

static void read_mouse(const cni_joint *j, void *to)
{
	cn_mouse_def *def = (cn_mouse_def *)to;
	def->target_m = j->anchor[0];
	def->hertz = j->p[CNI_P_HERTZ];
	def->damping_ratio = j->p[CNI_P_DAMPING];
}

/* ------------------------------------------------------------------ gear */

void cn_gear_def_init(cn_gear_def *def)
{
	if (def == NULL)
		return;
	init_base(def, sizeof *def);
	def->ratio = 1.0f;
}

static void check_gear(cni_call *call, const cn_joint_base *base, const void *from)
{
	const cn_gear_def *def = (const cn_gear_def *)from;
	(void)base;
	check_ratio(call, "ratio", def->ratio);
	cni_check_angle(call, "phase_rad", def->phase_rad);
}

static void store_gear(cni_joint *j, const void *from)
{
	const cn_gear_def *def = (const cn_gear_def *)from;
	j->p[CNI_P_GEAR_RATIO] = def->ratio;
	j->p[CNI_P_GEAR_PHASE] = def->phase_rad;
}

static void read_gear(const cni_joint *j, void *to)
{
	cn_gear_def *def = (cn_gear_def *)to;
	def->ratio = j->p[CNI_P_GEAR_RATIO];
	def->phase_rad = j->p[CNI_P_GEAR_PHASE];
}

/* ------------------------------------------------------------------ pulley */

void cn_pulley_def_init(cn_pulley_def *def)
{
	if (def == NULL)
		return;
	init_base(def, sizeof *def);
	def->ratio = 1.0f;
}

static void check_pulley(cni_call *call, const cn_joint_base *base, const void *from)
{
	const cn_pulley_def *def = (const cn_pulley_def *)from;
	(void)base;
	cni_check_position(call, "ground_a_m", def->ground_a_m);
	cni_check_position(call, "ground_b_m", def->ground_b_m);
	cni_check_range(call, "ratio", def->ratio, RATIO_MIN, RATIO_MAX);
	cni_check_positive(call, "length_m", def->length_m);
}

static void store_pulley(cni_joint *j, const void *from)
{
	const cn_pulley_def *def = (const cn_pulley_def *)from;
	j->p[CNI_P_LENGTH] = def->length_m;
	j->p[CNI_P_PULLEY_GROUND_A] = def->ground_a_m.x;
	j->p[CNI_P_PULLEY_GROUND_A + 1] = def->ground_a_m.y;
	j->p[CNI_P_PULLEY_GROUND_B] = def->ground_b_m.x;
	j->p[CNI_P_PULLEY_GROUND_B + 1] = def->ground_b_m.y;
	j->p[CNI_P_PULLEY_RATIO] = def->ratio;
}

static void read_pulley(const cni_joint *j, void *to)
{
	cn_pulley_def *def = (cn_pulley_def *)to;
	def->length_m = j->p[CNI_P_LENGTH];
	def->ground_a_m = cni_v(j->p[CNI_P_PULLEY_GROUND_A], j->p[CNI_P_PULLEY_GROUND_A + 1]);
	def->ground_b_m = cni_v(j->p[CNI_P_PULLEY_GROUND_B], j->p[CNI_P_PULLEY_GROUND_B + 1]);
	def->ratio = j->p[CNI_P_PULLEY_RATIO];
}

/* ------------------------------------------------------------------ ratchet */

void cn_ratchet_def_init(cn_ratchet_def *def)
{
	if (def != NULL)
		init_base(def, sizeof *def);
}

static void check_ratchet(cni_call *call, const cn_joint_base *base, const void *from)
{
	const cn_ratchet_def *def = (const cn_ratchet_def *)from;
	(void)base;
	cni_check_angle(call, "phase_rad", def->phase_rad);
	check_ratio(call, "click_rad", def->click_rad);
}

static void store_ratchet(cni_joint *j, const void *from)
{
	const cn_ratchet_def *def = (const cn_ratchet_def *)from;
	j->p[CNI_P_RATCHET_PHASE] = def->phase_rad;
	j->p[CNI_P_RATCHET_CLICK] = def->click_rad;
}

static void read_ratchet(const cni_joint *j, void *to)
{
	cn_ratchet_def *def = (cn_ratchet_def *)to;
	def->phase_rad = j->p[CNI_P_RATCHET_PHASE];
	def->click_rad = j->p[CNI_P_RATCHET_CLICK];
}

/* ------------------------------------------------------------------ rotary spring */

void cn_rotary_spring_def_init(cn_rotary_spring_def *def)
{
	if (def == NULL)
		return;
	init_base(def, sizeof *def);
	def->hertz = 1.0f;
}

static void check_rotary_spring(cni_call *call, const cn_joint_base *base, const void *from)
{
	const cn_rotary_spring_def *def = (const cn_rotary_spring_def *)from;
	(void)base;
	cni_check_angle(call, "rest_angle_rad", def->rest_angle_rad);
	check_drive(call, def->hertz, def->damping_ratio);
}

static void store_rotary_spring(cni_joint *j, const void *from)
{
	const cn_rotary_spring_def *def = (const cn_rotary_spring_def *)from;
	j->p[CNI_P_REST] = def->rest_angle_rad;
	j->p[CNI_P_REST_HERTZ] = def->hertz;
	j->p[CNI_P_REST_DAMPING] = def->damping_ratio;
}

static void read_rotary_spring(const cni_joint *j, void *to)
{
	cn_rotary_spring_def *def = (cn_rotary_spring_def *)to;
	def->rest_angle_rad = j->p[CNI_P_REST];
	def->hertz = j->p[CNI_P_REST_HERTZ];
	def->damping_ratio = j->p[CNI_P_REST_DAMPING];
}

/* ------------------------------------------------------------------ groove */

void cn_groove_def_init(cn_groove_def *def)
{
	if (def == NULL)
		return;
	init_base(def, sizeof *def);
	def->end_m.x = 1.0f;
}

static void check_groove(cni_call *call, const cn_joint_base *base, const void *from)
{
	const cn_groove_def *def = (const cn_groove_def *)from;
	cni_check_position(call, "end_m", def->end_m);
	if (call->result == CN_OK && cni_distance_sq(base->anchor_a_m, def->end_m) <= 0.0f)
		cni_refuse(call, CN_ERROR_ARGUMENT, "end_m is anchor_a_m; the slot must have a length > 0");
}

static void store_groove(cni_joint *j, const void *from)
{
	const cn_groove_def *def = (const cn_groove_def *)from;
	cni_vec2 slot = cni_sub(def->end_m, j->anchor[0]);
	cni_joint_store_axis(j, slot);
	j->p[CNI_P_UPPER] = cni_length(slot);
	j->p[CNI_P_GROOVE_END_X] = def->end_m.x;
	j->p[CNI_P_GROOVE_END_Y] = def->end_m.y;
}

static void read_groove(const cni_joint *j, void *to)
{
	cn_groove_def *def = (cn_groove_def *)to;
	def->end_m = cni_v(j->p[CNI_P_GROOVE_END_X], j->p[CNI_P_GROOVE_END_Y]);
}

/* ------------------------------------------------------------------ filter */

void cn_filter_joint_def_init(cn_filter_joint_def *def)
{
	if (def != NULL)
		init_base(def, sizeof *def);
}

static void check_filter(cni_call *call, const cn_joint_base *base, const void *from)
{
	(void)call;
	(void)base;
	(void)from;
}

static void store_filter(cni_joint *j, const void *from)
{
	(void)j;
	(void)from;
}

static void read_filter(const cni_joint *j, void *to)
{
	(void)j;
	(void)to;
}

/* ------------------------------------------------------------------ the table */

const cni_joint_kind *cni_joint_kind_of(int32_t type)
{
	static const cni_joint_kind kinds[] = {
		{ sizeof(cn_revolute_def), "cn_revolute_def_init", check_revolute, store_revolute, read_revolute, CNI_KIND_HAS_MOTOR | CNI_KIND_HAS_LIMITS },
		{ sizeof(cn_distance_def), "cn_distance_def_init", check_distance, store_distance, read_distance, CNI_KIND_HAS_MOTOR | CNI_KIND_HAS_LIMITS },
		{ sizeof(cn_fixed_def), "cn_fixed_def_init", check_fixed, store_fixed, read_fixed, 0 },
		{ sizeof(cn_prismatic_def), "cn_prismatic_def_init", check_prismatic, store_prismatic, read_prismatic, CNI_KIND_HAS_MOTOR | CNI_KIND_HAS_LIMITS },
		{ sizeof(cn_wheel_def), "cn_wheel_def_init", check_wheel, store_wheel, read_wheel, CNI_KIND_HAS_MOTOR | CNI_KIND_HAS_LIMITS },
		{ sizeof(cn_motor_def), "cn_motor_def_init", check_motor, store_motor, read_motor, CNI_KIND_HAS_DRIVE },
		{ sizeof(cn_mouse_def), "cn_mouse_def_init", check_mouse, store_mouse, read_mouse, CNI_KIND_HAS_DRIVE },
		{ sizeof(cn_gear_def), "cn_gear_def_init", check_gear, store_gear, read_gear, 0 },
		{ sizeof(cn_pulley_def), "cn_pulley_def_init", check_pulley, store_pulley, read_pulley, 0 },
		{ sizeof(cn_ratchet_def), "cn_ratchet_def_init", check_ratchet, store_ratchet, read_ratchet, 0 },
		{ sizeof(cn_rotary_spring_def), "cn_rotary_spring_def_init", check_rotary_spring, store_rotary_spring, read_rotary_spring, 0 },
		{ sizeof(cn_groove_def), "cn_groove_def_init", check_groove, store_groove, read_groove, 0 },
		{ sizeof(cn_filter_joint_def), "cn_filter_joint_def_init", check_filter, store_filter, read_filter, 0 }
	};
	return kinds + type;
}
