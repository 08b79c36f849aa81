/*
 * world/joint.c - public functions on joints and constraints of all types: bodies, state, flags, motor, limits, solver, lists, events.
 * Definitions are in joint_create.c, the fields of each type in joint_kinds.c.
 */
#include "joints/joint_type.h"
#include "world/define.h"
#include "world/joint_change.h"

/* ------------------------------------------------------------------ changing */

cni_joint *cni_check_joint_of_type(cni_call *call, int32_t type, uint32_t handle)
{
	int32_t constraint = cni_joint_is_constraint(type);
	cni_joint *j = constraint ? cni_check_constraint(call, "constraint", handle) : cni_check_joint(call, "joint", handle);
	cni_check(call, j == NULL || j->type == type, CN_ERROR_STATE, constraint ? "the constraint is of another type" : "the joint is of another type");
	return j;
}

void cni_joint_change_reserve(cni_call *call, cn_world *world, const cni_joint *j)
{
	int32_t contacts = j->body[0] != CNI_NONE ? cni_body_at(world, j->body[0])->contact_count : 0;
	if (call->result == CN_OK)
		cni_check_reserved(call, cni_contact_reserve_end(world, contacts), "events of contacts");
	if (call->result == CN_OK && !cni_island_reserve(world, 1))
		cni_refuse(call, CN_ERROR_MEMORY, "no memory for islands");
}

/* Clears the impulses of missing rows: a row that returns later starts from 0. */
static void forget_missing_rows(const cn_world *world, cni_joint *j)
{
	cni_joint_frame frame = cni_joint_frame_make(world, j);
	cni_row rows[CNI_JOINT_ROWS];
	int32_t count = cni_joint_type_of(j->type)->rows(j, &frame, rows), k;
	uint32_t present = 0;
	for (k = 0; k < count; ++k)
		present |= 1u << rows[k].slot;
	for (k = 0; k < CNI_JOINT_ROWS; ++k)
		if (!(present >> k & 1u))
			j->impulse[k] = 0.0f;
}

void cni_joint_change_flags(cn_world *world, int32_t joint, uint32_t flags)
{
	cni_joint *j = cni_joint_at(world, joint);
	if ((j->flags ^ flags) & CN_JOINT_COLLIDE) {
		cni_joint_unlink(world, joint);
		j->flags = flags;
		cni_joint_link(world, joint);
	}
	j->flags = flags;
	j->apart = 1;
	forget_missing_rows(world, j);
	cni_joint_wake_bodies(world, j);
}

cn_result cn_joint_set_flags(cn_world *world, cn_joint joint, uint32_t flags)
{
	cni_call call = cni_enter(world, __func__);
	const cni_joint *j = cni_check_joint(&call, "joint", joint);
	cni_check_flags(&call, "flags", flags, CNI_JOINT_FLAGS);
	if (call.result != CN_OK)
		return call.result;
	cni_joint_change_reserve(&call, world, j);
	if (call.result == CN_OK)
		cni_joint_change_flags(world, cni_joint_index(world, joint), flags);
	return call.result;
}

static cni_joint *check_joint_has(cni_call *call, cn_joint joint, uint32_t what, const char *why_not)
{
	cni_joint *j = cni_check_joint(call, "joint", joint);
	cni_check(call, j == NULL || (cni_joint_kind_of(j->type)->has & what) != 0, CN_ERROR_STATE, why_not);
	return j;
}

cn_result cn_joint_set_motor(cn_world *world, cn_joint joint, float speed, float force_or_torque_max)
{
	cni_call call = cni_enter(world, __func__);
	cni_joint *j = check_joint_has(&call, joint, CNI_KIND_HAS_MOTOR, "joints of this type have no motor");
	cni_check_finite(&call, "speed", speed);
	cni_check_at_least(&call, "force_or_torque_max", force_or_torque_max, 0.0f);
	if (call.result != CN_OK)
		return call.result;
	j->p[CNI_P_MOTOR_SPEED] = speed;
	j->p[CNI_P_MOTOR_MAX] = force_or_torque_max;
	cni_joint_wake_bodies(world, j);
	return CN_OK;
}

cn_result cn_joint_set_limits(cn_world *world, cn_joint joint, float lower, float upper)
{
	cni_call call = cni_enter(world, __func__);
	cni_joint *j = check_joint_has(&call, joint, CNI_KIND_HAS_LIMITS, "joints of this type have no limits");
	if (call.result == CN_OK)
		cni_check_joint_limits(&call, j->type, lower, upper);
	if (call.result != CN_OK)
		return call.result;
	j->p[CNI_P_LOWER] = lower;
	j->p[CNI_P_UPPER] = upper;
	j->apart = 1;
	cni_joint_wake_bodies(world, j);
	return CN_OK;
}

cn_result cn_joint_set_target(cn_world *world, cn_joint joint, float target_x_m, float target_y_m)
{
	cni_call call = cni_enter(world, __func__);
	cni_joint *j = cni_check_joint_of_type(&call, CN_JOINT_MOUSE, joint);
	cni_vec2 target = cni_v(target_x_m, target_y_m);
	cni_check_position(&call, "target", target);
	if (call.result != CN_OK)
		return call.result;
	j->anchor[0] = target;
	cni_joint_wake_bodies(world, j);
	return CN_OK;
}

cn_result cn_joint_set_solver(cn_world *world, cn_joint joint, int32_t solver)
{
	cni_call call = cni_enter(world, __func__);
	cni_joint *j = cni_check_joint(&call, "joint", joint);
	cni_check_solver(&call, solver, CN_SOLVER_DIRECT);
	if (call.result != CN_OK)
		return call.result;
	j->solver = solver;
	if (solver != CN_SOLVER_AUTO)
		world->overridden = 1;
	if (solver == CN_SOLVER_DIRECT)
		world->joints_soft_step = 0; /* joints left soft for a time are tried again */
	return CN_OK;
}

/* ------------------------------------------------------------------ reading */

CNI_DEFINE_IS_VALID(joint)
CNI_DEFINE_GET(joint, type, int32_t, record->type)
CNI_DEFINE_GET2(joint, bodies, cn_body, cn_body, (*out_a = cni_handle_or_zero(&world->body_handles, record->body[0]), *out_b = cni_handle_or_zero(&world->body_handles, record->body[1])))
CNI_DEFINE_GET2(joint, anchors, cn_vec2, cn_vec2, cni_joint_anchors(world, record, out_a, out_b))
CNI_DEFINE_GET2(joint, reaction, cn_vec2, float, cni_joint_reaction(world, record, out_a, out_b))
CNI_DEFINE_GET2(joint, error, float, float, cni_joint_error(world, record, out_a, out_b))
CNI_DEFINE_GET(joint, solver, int32_t, record->solver)
CNI_DEFINE_USER_DATA(joint, (void)0)
CNI_DEFINE_GET(joint, flags, uint32_t, record->flags)
CNI_DEFINE_GET(joint, position, float, cni_joint_position(world, record))
CNI_DEFINE_GET(joint, speed, float, cni_joint_speed(world, record))

CNI_DEFINE_IS_VALID(constraint)
CNI_DEFINE_GET(constraint, type, int32_t, record->type - CNI_JOINT_ANGLE)
CNI_DEFINE_GET(constraint, body, cn_body, cni_handles_of(&world->body_handles, record->body[1]))
CNI_DEFINE_GET(constraint, position, float, cni_joint_position(world, record))
CNI_DEFINE_GET2(constraint, reaction, cn_vec2, float, cni_joint_reaction(world, record, out_a, out_b))
CNI_DEFINE_GET2(constraint, error, float, float, cni_joint_error(world, record, out_a, out_b))

/* ------------------------------------------------------------------ lists and events */

/* Joints (constraint 0) or constraints (1) of a body, and below of the world. */
static cn_result list_joints_of(const cn_world *world, cn_body body, int32_t constraint, uint32_t *out, int32_t capacity, int32_t *out_count)
{
	cni_call call = cni_enter_const(world);
	const cni_body *b = cni_check_body(&call, "body", body);
	cni_list list = cni_list_begin(&call, out, capacity, out_count);
	if (call.result != CN_OK)
		return call.result;
	for (int32_t key = b->joint_first; key != CNI_NONE; key = cni_joint_at(world, key >> 1)->next[key & 1])
		if (cni_joint_is_constraint(cni_joint_at(world, key >> 1)->type) == constraint)
			cni_list_add(&list, cni_joint_handle(world, key >> 1));
	*out_count = list.count;
	return CN_OK;
}

static cn_result list_joints(const cn_world *world, int32_t constraint, uint32_t *out, int32_t capacity, int32_t *out_count)
{
	cni_call call = cni_enter_const(world);
	cni_list list = cni_list_begin(&call, out, capacity, out_count);
	if (call.result != CN_OK)
		return call.result;
	for (int32_t k = cni_handles_next(&world->joint_handles, 0); k != CNI_NONE && list.count < capacity; k = cni_handles_next(&world->joint_handles, k + 1))
		if (cni_joint_is_constraint(cni_joint_at(world, k)->type) == constraint)
			cni_list_add(&list, cni_joint_handle(world, k));
	*out_count = constraint ? world->constraint_count : world->joint_handles.count - world->constraint_count;
	return CN_OK;
}

#define DEFINE_LISTS(noun, constraint) \
	cn_result cn_world_get_##noun##s(const cn_world *world, cn_##noun *out, int32_t capacity, int32_t *out_count) \
	{ \
		return list_joints(world, constraint, out, capacity, out_count); \
	} \
	cn_result cn_body_get_##noun##s(const cn_world *world, cn_body body, cn_##noun *out, int32_t capacity, int32_t *out_count) \
	{ \
		return list_joints_of(world, body, constraint, out, capacity, out_count); \
	}

DEFINE_LISTS(joint, 0)
DEFINE_LISTS(constraint, 1)
CNI_DEFINE_EVENTS(joint_events, cn_joint_event, joint_log)
