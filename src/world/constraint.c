/*
 * world/constraint.c - public functions on constraints on one body.
 *
 * A constraint is a joint record whose body a is the world (CNI_JOINT_ANGLE, CNI_JOINT_LINE), solved with
 * the joints, before contacts. Only the kind of its handle and its definition differ from a joint's.
 */
#include "joints/joint_type.h"
#include "world/define.h"
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

/* The first fields of both definitions. */
typedef struct constraint_head {
	uint32_t struct_size;
	uint32_t flags;
	cn_body body;
} constraint_head;

static constraint_head check_def(cni_call *call, int32_t type, const void *def)
{
	const cni_joint_kind *kind = cni_joint_kind_of(type);
	constraint_head head = { 0, 0, 0 };
	if (!cni_check_def(call, def, kind->bytes, kind->init))
		return head;
	memcpy(&head, def, sizeof head);
	cni_check_flags(call, "flags", head.flags, CONSTRAINT_FLAGS);
	if (call->result == CN_OK)
		cni_joint_def_check(call, type, def);
	return head;
}

/* ------------------------------------------------------------------ life */

static cn_result constraint_create(cn_world *world, const char *function, int32_t type, const void *def, cn_constraint *out_constraint)
{
	cni_call call = cni_enter(world, function);
	constraint_head head = check_def(&call, type, def);
	const cni_body *b = cni_check_body(&call, "body", head.body);
	int32_t joint;
	cni_check(&call, b == NULL || b->type == CN_BODY_DYNAMIC, CN_ERROR_ARGUMENT, "body; must be dynamic");
	cni_check_pointer(&call, "out_constraint", out_constraint);
	cni_joint_reserve_one(&call, world, 0);
	if (call.result != CN_OK)
		return call.result;
	joint = cni_joint_take(world, type, joint_flags(head.flags) | CN_JOINT_COLLIDE, CNI_NONE, cni_body_index(world, head.body));
	cni_joint_def_store(cni_joint_at(world, joint), type, def);
	cni_joint_turns_begin(world, cni_joint_at(world, joint));
	cni_joint_link(world, joint);
	*out_constraint = cni_joint_handle(world, joint);
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

CNI_DEFINE_IS_VALID(constraint)

/* ------------------------------------------------------------------ reading back and replacing */

static cn_result constraint_get(const cn_world *world, int32_t type, cn_constraint constraint, void *out)
{
	cni_call call = cni_enter_const(world);
	const cni_joint *j = cni_check_joint_of_type(&call, type, constraint);
	constraint_head head;
	cni_check_pointer(&call, "out", out);
	if (call.result != CN_OK)
		return call.result;
	cni_joint_def_init(type, out);
	head.struct_size = (uint32_t)cni_joint_kind_of(type)->bytes;
	head.flags = constraint_flags(j->flags);
	head.body = cni_handles_of(&world->body_handles, j->body[1]);
	memcpy(out, &head, sizeof head);
	cni_joint_def_read(j, type, out);
	return CN_OK;
}

static cn_result constraint_set(cn_world *world, const char *function, int32_t type, cn_constraint constraint, const void *def)
{
	cni_call call = cni_enter(world, function);
	cni_joint *j = cni_check_joint_of_type(&call, type, constraint);
	constraint_head head = check_def(&call, type, def);
	if (call.result != CN_OK)
		return call.result;
	cni_joint_def_store(j, type, def);
	memset(j->impulse, 0, sizeof j->impulse); /* the impulses belong to the old limits */
	cni_joint_change_flags(world, cni_joint_index(world, constraint), joint_flags(head.flags) | CN_JOINT_COLLIDE);
	return CN_OK;
}

/* ------------------------------------------------------------------ by type */

#define DEFINE_ALL(type, name, definition) \
	void definition##_init(definition *def) { cni_joint_def_init(type, def); } \
	cn_result cn_constraint_create_##name(cn_world *world, const definition *def, cn_constraint *out_constraint) \
	{ \
		return constraint_create(world, __func__, type, def, out_constraint); \
	} \
	cn_result cn_constraint_get_##name(const cn_world *world, cn_constraint constraint, definition *out) \
	{ \
		return constraint_get(world, type, constraint, out); \
	} \
	cn_result cn_constraint_set_##name(cn_world *world, cn_constraint constraint, const definition *def) \
	{ \
		return constraint_set(world, __func__, type, constraint, def); \
	}

DEFINE_ALL(CNI_JOINT_ANGLE, angle, cn_angle_constraint_def)
DEFINE_ALL(CNI_JOINT_LINE, line, cn_line_constraint_def)

/* ------------------------------------------------------------------ reading */

CNI_DEFINE_GET(constraint, type, int32_t, record->type - CNI_JOINT_ANGLE)
CNI_DEFINE_GET(constraint, body, cn_body, cni_handles_of(&world->body_handles, record->body[1]))
CNI_DEFINE_GET(constraint, position, float, cni_joint_position(world, record))
CNI_DEFINE_GET2(constraint, reaction, cn_vec2, float, cni_joint_reaction(world, record, out_a, out_b))
CNI_DEFINE_GET2(constraint, error, float, float, cni_joint_error(world, record, out_a, out_b))

cn_result cn_world_get_constraints(const cn_world *world, cn_constraint *out, int32_t capacity, int32_t *out_count)
{
	return cni_list_joints(world, 1, out, capacity, out_count);
}

cn_result cn_body_get_constraints(const cn_world *world, cn_body body, cn_constraint *out, int32_t capacity, int32_t *out_count)
{
	return cni_list_joints_of(world, body, 1, out, capacity, out_count);
}
