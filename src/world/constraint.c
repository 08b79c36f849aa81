/*
 * world/constraint.c - public functions on constraints on one body.
 *
 * A constraint is a joint record whose body a is the world (CNI_JOINT_ANGLE, CNI_JOINT_LINE), solved with
 * the joints, before contacts. Only its handle, which is of another kind, and its definitions differ.
 */
#include "world/joint_change.h"

#include <string.h>

#define CONSTRAINT_FLAGS (CN_CONSTRAINT_LIMIT | CN_CONSTRAINT_BREAKS)

static uint32_t joint_flags(uint32_t flags)
{
	return ((flags & CN_CONSTRAINT_LIMIT) ? (uint32_t)CN_JOINT_LIMIT : 0u) | ((flags & CN_CONSTRAINT_BREAKS) ? (uint32_t)CN_JOINT_BREAKS : 0u);
}

static uint32_t constraint_flags(uint32_t flags)
{
	return ((flags & CN_JOINT_LIMIT) ? (uint32_t)CN_CONSTRAINT_LIMIT : 0u) | ((flags & CN_JOINT_BREAKS) ? (uint32_t)CN_CONSTRAINT_BREAKS : 0u);
}

/* ------------------------------------------------------------------ definitions */

void cn_angle_constraint_def_init(cn_angle_constraint_def *def)
{
	if (def == NULL)
		return;
	memset(def, 0, sizeof *def);
	def->struct_size = (uint32_t)sizeof *def;
}

void cn_line_constraint_def_init(cn_line_constraint_def *def)
{
	if (def == NULL)
		return;
	memset(def, 0, sizeof *def);
	def->struct_size = (uint32_t)sizeof *def;
	def->axis.x = 1.0f;
}

static void check_order(cni_call *call, float lower, float upper)
{
	if (lower > upper)
		cni_refuse_float(call, "lower limit", lower, "must not be above the upper one");
}

static void check_angle(cni_call *call, const cn_angle_constraint_def *def)
{
	cni_check_struct_size(call, def->struct_size, sizeof *def, "cn_angle_constraint_def_init");
	cni_check_flags(call, "flags", def->flags, CONSTRAINT_FLAGS);
	cni_check_angle(call, "lower_rad", def->lower_rad);
	cni_check_angle(call, "upper_rad", def->upper_rad);
	check_order(call, def->lower_rad, def->upper_rad);
	cni_check_softness(call, "hertz", def->hertz, "damping_ratio", def->damping_ratio);
	cni_check_at_least(call, "break_torque_Nm", def->break_torque_Nm, 0.0f);
}

static void check_line(cni_call *call, const cn_line_constraint_def *def)
{
	cni_check_struct_size(call, def->struct_size, sizeof *def, "cn_line_constraint_def_init");
	cni_check_flags(call, "flags", def->flags, CONSTRAINT_FLAGS);
	cni_check_position(call, "anchor_m", def->anchor_m);
	cni_check_position(call, "origin_m", def->origin_m);
	cni_check_axis(call, def->axis);
	cni_check_at_least(call, "tolerance_m", def->tolerance_m, 0.0f);
	cni_check_finite(call, "lower_m", def->lower_m);
	cni_check_finite(call, "upper_m", def->upper_m);
	check_order(call, def->lower_m, def->upper_m);
	cni_check_softness(call, "hertz", def->hertz, "damping_ratio", def->damping_ratio);
	cni_check_at_least(call, "break_force_N", def->break_force_N, 0.0f);
}

static void store_angle(cni_joint *j, const cn_angle_constraint_def *def)
{
	j->p[CNI_P_LOWER] = def->lower_rad;
	j->p[CNI_P_UPPER] = def->upper_rad;
	j->stiffness_hertz = def->hertz;
	j->stiffness_damping = def->damping_ratio;
	j->break_torque = def->break_torque_Nm;
	j->user_data = def->user_data;
}

static void store_line(cni_joint *j, const cn_line_constraint_def *def)
{
	j->anchor[0] = def->origin_m;
	j->anchor[1] = def->anchor_m;
	cni_joint_store_axis(j, def->axis);
	j->p[CNI_P_LINE_TOLERANCE] = def->tolerance_m;
	j->p[CNI_P_LOWER] = def->lower_m;
	j->p[CNI_P_UPPER] = def->upper_m;
	j->stiffness_hertz = def->hertz;
	j->stiffness_damping = def->damping_ratio;
	j->break_force = def->break_force_N;
	j->user_data = def->user_data;
}

/* ------------------------------------------------------------------ life */

static void check_create(cni_call *call, cn_world *world, cn_body body, const cn_constraint *out_constraint)
{
	const cni_body *b = cni_check_body(call, "body", body);
	if (b != NULL && b->type != CN_BODY_DYNAMIC)
		cni_refuse(call, CN_ERROR_ARGUMENT, "body; must be dynamic");
	cni_check_pointer(call, "out_constraint", out_constraint);
	cni_joint_reserve_one(call, world, 0);
}

/* After check_create: a record that has its definition's numbers still to come. */
static int32_t constraint_take(cn_world *world, int32_t type, uint32_t flags, cn_body body)
{
	return cni_joint_take(world, type, joint_flags(flags) | CN_JOINT_COLLIDE, CNI_NONE, cni_body_index(world, body));
}

static void constraint_finish(cn_world *world, int32_t joint, cn_constraint *out_constraint)
{
	cni_joint_turns_begin(world, cni_joint_at(world, joint));
	cni_joint_link(world, joint);
	*out_constraint = cni_joint_handle(world, joint);
}

cn_result cn_constraint_create_angle(cn_world *world, const cn_angle_constraint_def *def, cn_constraint *out_constraint)
{
	cni_call call = cni_enter(world, __func__);
	int32_t joint;
	cni_check_pointer(&call, "def", def);
	if (call.result != CN_OK)
		return call.result;
	check_angle(&call, def);
	check_create(&call, world, def->body, out_constraint);
	if (call.result != CN_OK)
		return call.result;
	joint = constraint_take(world, CNI_JOINT_ANGLE, def->flags, def->body);
	store_angle(cni_joint_at(world, joint), def);
	constraint_finish(world, joint, out_constraint);
	return CN_OK;
}

cn_result cn_constraint_create_line(cn_world *world, const cn_line_constraint_def *def, cn_constraint *out_constraint)
{
	cni_call call = cni_enter(world, __func__);
	int32_t joint;
	cni_check_pointer(&call, "def", def);
	if (call.result != CN_OK)
		return call.result;
	check_line(&call, def);
	check_create(&call, world, def->body, out_constraint);
	if (call.result != CN_OK)
		return call.result;
	joint = constraint_take(world, CNI_JOINT_LINE, def->flags, def->body);
	store_line(cni_joint_at(world, joint), def);
	constraint_finish(world, joint, out_constraint);
	return CN_OK;
}

cn_result cn_constraint_destroy(cn_world *world, cn_constraint constraint)
{
	cni_call call = cni_enter(world, __func__);
	cni_check_constraint(&call, "constraint", constraint);
	if (call.result == CN_OK)
		cni_joint_destroy(world, cni_joint_index(world, constraint));
	return call.result;
}

int32_t cn_constraint_is_valid(const cn_world *world, cn_constraint constraint)
{
	return world != NULL && cni_joint_find(world, constraint, 1) != CNI_NONE;
}

/* ------------------------------------------------------------------ reading back and replacing */

static cni_joint *check_type(cni_call *call, cn_constraint constraint, int32_t type)
{
	cni_joint *j = cni_check_constraint(call, "constraint", constraint);
	if (j != NULL && j->type != type)
		cni_refuse(call, CN_ERROR_STATE, "the constraint is of another type");
	return j;
}

cn_result cn_constraint_get_angle(const cn_world *world, cn_constraint constraint, cn_angle_constraint_def *out)
{
	cni_call call = cni_enter_const(world);
	const cni_joint *j = check_type(&call, constraint, CNI_JOINT_ANGLE);
	cni_check_pointer(&call, "out", out);
	if (call.result != CN_OK)
		return call.result;
	cn_angle_constraint_def_init(out);
	out->flags = constraint_flags(j->flags);
	out->body = cni_handles_of(&world->body_handles, j->body[1]);
	out->lower_rad = j->p[CNI_P_LOWER];
	out->upper_rad = j->p[CNI_P_UPPER];
	out->hertz = j->stiffness_hertz;
	out->damping_ratio = j->stiffness_damping;
	out->break_torque_Nm = j->break_torque;
	out->user_data = j->user_data;
	return CN_OK;
}

cn_result cn_constraint_get_line(const cn_world *world, cn_constraint constraint, cn_line_constraint_def *out)
{
	cni_call call = cni_enter_const(world);
	const cni_joint *j = check_type(&call, constraint, CNI_JOINT_LINE);
	cni_check_pointer(&call, "out", out);
	if (call.result != CN_OK)
		return call.result;
	cn_line_constraint_def_init(out);
	out->flags = constraint_flags(j->flags);
	out->body = cni_handles_of(&world->body_handles, j->body[1]);
	out->anchor_m = j->anchor[1];
	out->origin_m = j->anchor[0];
	out->axis = cni_v(j->p[CNI_P_AXIS_X], j->p[CNI_P_AXIS_Y]);
	out->tolerance_m = j->p[CNI_P_LINE_TOLERANCE];
	out->lower_m = j->p[CNI_P_LOWER];
	out->upper_m = j->p[CNI_P_UPPER];
	out->hertz = j->stiffness_hertz;
	out->damping_ratio = j->stiffness_damping;
	out->break_force_N = j->break_force;
	out->user_data = j->user_data;
	return CN_OK;
}

/* Impulses belong to the limits that were. */
static void constraint_changed(cn_world *world, int32_t joint, uint32_t flags)
{
	memset(cni_joint_at(world, joint)->impulse, 0, sizeof cni_joint_at(world, joint)->impulse);
	cni_joint_change_flags(world, joint, joint_flags(flags) | CN_JOINT_COLLIDE);
}

cn_result cn_constraint_set_angle(cn_world *world, cn_constraint constraint, const cn_angle_constraint_def *def)
{
	cni_call call = cni_enter(world, __func__);
	cni_joint *j = check_type(&call, constraint, CNI_JOINT_ANGLE);
	cni_check_pointer(&call, "def", def);
	if (call.result == CN_OK)
		check_angle(&call, def);
	if (call.result != CN_OK)
		return call.result;
	store_angle(j, def);
	constraint_changed(world, cni_joint_index(world, constraint), def->flags);
	return CN_OK;
}

cn_result cn_constraint_set_line(cn_world *world, cn_constraint constraint, const cn_line_constraint_def *def)
{
	cni_call call = cni_enter(world, __func__);
	cni_joint *j = check_type(&call, constraint, CNI_JOINT_LINE);
	cni_check_pointer(&call, "def", def);
	if (call.result == CN_OK)
		check_line(&call, def);
	if (call.result != CN_OK)
		return call.result;
	store_line(j, def);
	constraint_changed(world, cni_joint_index(world, constraint), def->flags);
	return CN_OK;
}

/* ------------------------------------------------------------------ reading */

cn_result cn_constraint_get_type(const cn_world *world, cn_constraint constraint, int32_t *out_type)
{
	cni_call call = cni_enter_const(world);
	const cni_joint *j = cni_check_constraint(&call, "constraint", constraint);
	cni_check_pointer(&call, "out_type", out_type);
	if (call.result == CN_OK)
		*out_type = j->type - CNI_JOINT_ANGLE;
	return call.result;
}

cn_result cn_constraint_get_body(const cn_world *world, cn_constraint constraint, cn_body *out_body)
{
	cni_call call = cni_enter_const(world);
	const cni_joint *j = cni_check_constraint(&call, "constraint", constraint);
	cni_check_pointer(&call, "out_body", out_body);
	if (call.result == CN_OK)
		*out_body = cni_handles_of(&world->body_handles, j->body[1]);
	return call.result;
}

cn_result cn_constraint_get_position(const cn_world *world, cn_constraint constraint, float *out_position)
{
	cni_call call = cni_enter_const(world);
	const cni_joint *j = cni_check_constraint(&call, "constraint", constraint);
	cni_check_pointer(&call, "out_position", out_position);
	if (call.result == CN_OK)
		*out_position = cni_joint_position(world, j);
	return call.result;
}

cn_result cn_constraint_get_reaction(const cn_world *world, cn_constraint constraint, cn_vec2 *out_force_N, float *out_torque_Nm)
{
	cni_call call = cni_enter_const(world);
	const cni_joint *j = cni_check_constraint(&call, "constraint", constraint);
	cni_check_pointer(&call, "out_force_N", out_force_N);
	cni_check_pointer(&call, "out_torque_Nm", out_torque_Nm);
	if (call.result == CN_OK)
		cni_joint_reaction(world, j, out_force_N, out_torque_Nm);
	return call.result;
}

cn_result cn_constraint_get_error(const cn_world *world, cn_constraint constraint, float *out_m, float *out_rad)
{
	cni_call call = cni_enter_const(world);
	const cni_joint *j = cni_check_constraint(&call, "constraint", constraint);
	cni_check_pointer(&call, "out_m", out_m);
	cni_check_pointer(&call, "out_rad", out_rad);
	if (call.result == CN_OK)
		cni_joint_error(world, j, out_m, out_rad);
	return call.result;
}

cn_result cn_world_get_constraints(const cn_world *world, cn_constraint *out, int32_t capacity, int32_t *out_count)
{
	return cni_list_joints(world, 1, out, capacity, out_count);
}

cn_result cn_body_get_constraints(const cn_world *world, cn_body body, cn_constraint *out, int32_t capacity, int32_t *out_count)
{
	cni_call call = cni_enter_const(world);
	const cni_body *b = cni_check_body(&call, "body", body);
	cni_list list = cni_list_begin(&call, out, capacity, out_count);
	if (call.result != CN_OK)
		return call.result;
	cni_list_joints_of(world, b, 1, &list);
	*out_count = list.count;
	return CN_OK;
}
