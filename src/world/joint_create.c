/*
 * world/joint_create.c - public functions on a joint's life and numbers by type: definitions, creating,
 * destroying, reading back and replacing everything particular to a type.
 *
 * Each type has a pair of functions between its public definition and the record's numbers p[]; all
 * checks of numbers are made whatever the flags say, so that turning a flag on later finds good numbers.
 */
#include "world/error.h"
#include "world/joint_change.h"

#include <string.h>

#define HERTZ_MAX 1e6f
#define DAMPING_RATIO_MAX 1e6f

/* ------------------------------------------------------------------ definitions */

void cn_revolute_def_init(cn_revolute_def *def)
{
	if (def == NULL)
		return;
	memset(def, 0, sizeof *def);
	def->base.struct_size = (uint32_t)sizeof *def;
}

void cn_distance_def_init(cn_distance_def *def)
{
	if (def == NULL)
		return;
	memset(def, 0, sizeof *def);
	def->base.struct_size = (uint32_t)sizeof *def;
	def->length_m = 1.0f;
	def->length_max_m = 1.0f;
}

static void check_spring(cni_call *call, float hertz, float damping_ratio)
{
	cni_check_range(call, "spring_hertz", hertz, 0.0f, HERTZ_MAX);
	cni_check_range(call, "spring_damping_ratio", damping_ratio, 0.0f, DAMPING_RATIO_MAX);
}

static void check_revolute(cni_call *call, const cn_revolute_def *def)
{
	cni_check_flags(call, "flags", def->base.flags, CNI_JOINT_FLAGS);
	cni_check_angle(call, "reference_angle_rad", def->reference_angle_rad);
	cni_check_joint_limits(call, CN_JOINT_REVOLUTE, def->lower_angle_rad, def->upper_angle_rad);
	cni_check_finite(call, "motor_speed_radps", def->motor_speed_radps);
	cni_check_at_least(call, "motor_torque_max_Nm", def->motor_torque_max_Nm, 0.0f);
	cni_check_angle(call, "spring_target_rad", def->spring_target_rad);
	check_spring(call, def->spring_hertz, def->spring_damping_ratio);
}

static void check_distance(cni_call *call, const cn_distance_def *def)
{
	cni_check_flags(call, "flags", def->base.flags, CNI_JOINT_FLAGS);
	cni_check_positive(call, "length_m", def->length_m);
	cni_check_joint_limits(call, CN_JOINT_DISTANCE, def->length_min_m, def->length_max_m);
	cni_check_finite(call, "motor_speed_mps", def->motor_speed_mps);
	cni_check_at_least(call, "motor_force_max_N", def->motor_force_max_N, 0.0f);
	check_spring(call, def->spring_hertz, def->spring_damping_ratio);
}

static void store_revolute(cni_joint *j, const cn_revolute_def *def)
{
	j->p[CNI_P_REFERENCE] = def->reference_angle_rad;
	j->p[CNI_P_LOWER] = def->lower_angle_rad;
	j->p[CNI_P_UPPER] = def->upper_angle_rad;
	j->p[CNI_P_MOTOR_SPEED] = def->motor_speed_radps;
	j->p[CNI_P_MOTOR_MAX] = def->motor_torque_max_Nm;
	j->p[CNI_P_REVOLUTE_TARGET] = def->spring_target_rad;
	j->p[CNI_P_REVOLUTE_HERTZ] = def->spring_hertz;
	j->p[CNI_P_REVOLUTE_DAMPING] = def->spring_damping_ratio;
}

static void store_distance(cni_joint *j, const cn_distance_def *def)
{
	j->p[CNI_P_LENGTH] = def->length_m;
	j->p[CNI_P_LOWER] = def->length_min_m;
	j->p[CNI_P_UPPER] = def->length_max_m;
	j->p[CNI_P_MOTOR_SPEED] = def->motor_speed_mps;
	j->p[CNI_P_MOTOR_MAX] = def->motor_force_max_N;
	j->p[CNI_P_DISTANCE_HERTZ] = def->spring_hertz;
	j->p[CNI_P_DISTANCE_DAMPING] = def->spring_damping_ratio;
}

/* ------------------------------------------------------------------ creating */

/* 0 is the world and gives NULL, as does a bad handle (the call has then failed). */
static const cni_body *check_side(cni_call *call, const char *field, cn_body body)
{
	return body != 0 ? cni_check_body(call, field, body) : NULL;
}

static void check_base(cni_call *call, const cn_joint_base *base)
{
	const cni_body *a = check_side(call, "body_a", base->body_a);
	const cni_body *b = check_side(call, "body_b", base->body_b);
	if (call->result == CN_OK && base->body_a == base->body_b)
		cni_refuse(call, CN_ERROR_ARGUMENT, "body_a and body_b are the same");
	if (call->result == CN_OK && !(a != NULL && a->type == CN_BODY_DYNAMIC) && !(b != NULL && b->type == CN_BODY_DYNAMIC))
		cni_refuse(call, CN_ERROR_ARGUMENT, "neither body_a nor body_b is dynamic");
	cni_check_position(call, "anchor_a_m", base->anchor_a_m);
	cni_check_position(call, "anchor_b_m", base->anchor_b_m);
}

static void reserve_joint(cni_call *call, cn_world *world, const cn_joint_base *base)
{
	if (call->result == CN_OK)
		cni_check_reserved(call, cni_slots_reserve(world, &world->joint_handles, &world->joints, 1), "joints");
	if (call->result == CN_OK)
		cni_check_reserved(call, cni_joint_reserve(world, 1), "joints");
	if (call->result == CN_OK && base->body_a != 0)
		cni_check_reserved(call, cni_contact_reserve_end(world, cni_body_at(world, cni_index_of(base->body_a))->contact_count), "events of contacts");
}

static int32_t side_index(cn_body body)
{
	return body != 0 ? cni_index_of(body) : CNI_NONE;
}

/* Takes a slot and fills in all but the type's numbers. */
static int32_t joint_take(cn_world *world, const cn_joint_base *base, int32_t type)
{
	int32_t joint = cni_handles_take(&world->joint_handles);
	cni_joint *j = cni_joint_at(world, joint);
	memset(j, 0, sizeof *j);
	j->type = type;
	j->flags = base->flags;
	j->body[0] = side_index(base->body_a);
	j->body[1] = side_index(base->body_b);
	j->next[0] = j->next[1] = j->prev[0] = j->prev[1] = CNI_NONE;
	j->awake = CNI_NONE;
	j->anchor[0] = base->anchor_a_m;
	j->anchor[1] = base->anchor_b_m;
	j->user_data = base->user_data;
	return joint;
}

static void joint_finish(cn_world *world, int32_t joint, cn_joint *out_joint)
{
	cni_joint_link(world, joint);
	*out_joint = cni_handles_of(&world->joint_handles, joint);
}

cn_result cn_joint_create_revolute(cn_world *world, const cn_revolute_def *def, cn_joint *out_joint)
{
	cni_call call = cni_enter(world, __func__);
	int32_t joint;
	cni_check_pointer(&call, "def", def);
	cni_check_pointer(&call, "out_joint", out_joint);
	if (call.result == CN_OK)
		cni_check_struct_size(&call, def->base.struct_size, sizeof *def, "cn_revolute_def_init");
	if (call.result != CN_OK)
		return call.result;
	check_base(&call, &def->base);
	check_revolute(&call, def);
	reserve_joint(&call, world, &def->base);
	if (call.result != CN_OK)
		return call.result;
	joint = joint_take(world, &def->base, CN_JOINT_REVOLUTE);
	store_revolute(cni_joint_at(world, joint), def);
	joint_finish(world, joint, out_joint);
	return CN_OK;
}

cn_result cn_joint_create_distance(cn_world *world, const cn_distance_def *def, cn_joint *out_joint)
{
	cni_call call = cni_enter(world, __func__);
	int32_t joint;
	cni_check_pointer(&call, "def", def);
	cni_check_pointer(&call, "out_joint", out_joint);
	if (call.result == CN_OK)
		cni_check_struct_size(&call, def->base.struct_size, sizeof *def, "cn_distance_def_init");
	if (call.result != CN_OK)
		return call.result;
	check_base(&call, &def->base);
	check_distance(&call, def);
	reserve_joint(&call, world, &def->base);
	if (call.result != CN_OK)
		return call.result;
	joint = joint_take(world, &def->base, CN_JOINT_DISTANCE);
	store_distance(cni_joint_at(world, joint), def);
	joint_finish(world, joint, out_joint);
	return CN_OK;
}

cn_result cn_joint_destroy(cn_world *world, cn_joint joint)
{
	cni_call call = cni_enter(world, __func__);
	cni_check_joint(&call, "joint", joint);
	if (call.result != CN_OK)
		return call.result;
	cni_joint_unlink(world, cni_index_of(joint));
	cni_handles_release(&world->joint_handles, cni_index_of(joint));
	return CN_OK;
}

/* ------------------------------------------------------------------ numbers by type */

static cni_joint *check_joint_type(cni_call *call, cn_joint joint, int32_t type)
{
	cni_joint *j = cni_check_joint(call, "joint", joint);
	if (j != NULL && j->type != type)
		cni_refuse(call, CN_ERROR_STATE, "the joint is of another type");
	return j;
}

static void base_read(const cn_world *world, const cni_joint *j, cn_joint_base *out)
{
	out->flags = j->flags;
	out->body_a = cni_handle_or_zero(&world->body_handles, j->body[0]);
	out->body_b = cni_handle_or_zero(&world->body_handles, j->body[1]);
	out->anchor_a_m = j->anchor[0];
	out->anchor_b_m = j->anchor[1];
	out->user_data = j->user_data;
}

cn_result cn_joint_get_revolute(const cn_world *world, cn_joint joint, cn_revolute_def *out)
{
	cni_call call = cni_enter_const(world);
	const cni_joint *j = check_joint_type(&call, joint, CN_JOINT_REVOLUTE);
	cni_check_pointer(&call, "out", out);
	if (call.result != CN_OK)
		return call.result;
	cn_revolute_def_init(out);
	base_read(world, j, &out->base);
	out->reference_angle_rad = j->p[CNI_P_REFERENCE];
	out->lower_angle_rad = j->p[CNI_P_LOWER];
	out->upper_angle_rad = j->p[CNI_P_UPPER];
	out->motor_speed_radps = j->p[CNI_P_MOTOR_SPEED];
	out->motor_torque_max_Nm = j->p[CNI_P_MOTOR_MAX];
	out->spring_target_rad = j->p[CNI_P_REVOLUTE_TARGET];
	out->spring_hertz = j->p[CNI_P_REVOLUTE_HERTZ];
	out->spring_damping_ratio = j->p[CNI_P_REVOLUTE_DAMPING];
	return CN_OK;
}

cn_result cn_joint_get_distance(const cn_world *world, cn_joint joint, cn_distance_def *out)
{
	cni_call call = cni_enter_const(world);
	const cni_joint *j = check_joint_type(&call, joint, CN_JOINT_DISTANCE);
	cni_check_pointer(&call, "out", out);
	if (call.result != CN_OK)
		return call.result;
	cn_distance_def_init(out);
	base_read(world, j, &out->base);
	out->length_m = j->p[CNI_P_LENGTH];
	out->length_min_m = j->p[CNI_P_LOWER];
	out->length_max_m = j->p[CNI_P_UPPER];
	out->motor_speed_mps = j->p[CNI_P_MOTOR_SPEED];
	out->motor_force_max_N = j->p[CNI_P_MOTOR_MAX];
	out->spring_hertz = j->p[CNI_P_DISTANCE_HERTZ];
	out->spring_damping_ratio = j->p[CNI_P_DISTANCE_DAMPING];
	return CN_OK;
}

cn_result cn_joint_set_revolute(cn_world *world, cn_joint joint, const cn_revolute_def *def)
{
	cni_call call = cni_enter(world, __func__);
	cni_joint *j = check_joint_type(&call, joint, CN_JOINT_REVOLUTE);
	cni_check_pointer(&call, "def", def);
	if (call.result != CN_OK)
		return call.result;
	check_revolute(&call, def);
	cni_joint_change_reserve(&call, world, j);
	if (call.result != CN_OK)
		return call.result;
	store_revolute(j, def);
	j->user_data = def->base.user_data;
	cni_joint_change_flags(world, cni_index_of(joint), def->base.flags);
	return CN_OK;
}

cn_result cn_joint_set_distance(cn_world *world, cn_joint joint, const cn_distance_def *def)
{
	cni_call call = cni_enter(world, __func__);
	cni_joint *j = check_joint_type(&call, joint, CN_JOINT_DISTANCE);
	cni_check_pointer(&call, "def", def);
	if (call.result != CN_OK)
		return call.result;
	check_distance(&call, def);
	cni_joint_change_reserve(&call, world, j);
	if (call.result != CN_OK)
		return call.result;
	store_distance(j, def);
	j->user_data = def->base.user_data;
	cni_joint_change_flags(world, cni_index_of(joint), def->base.flags);
	return CN_OK;
}
