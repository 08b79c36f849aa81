/*
 * world/joint_create.c - public functions that create and destroy joints and constraints, and read and replace their definitions.
 *
 * The functions here check and store the first fields, which all definitions have; the cni_joint_kind of a type (joint_kinds.c)
 * handles its other fields. A constraint on one body is a joint record whose body a is the world (CNI_JOINT_ANGLE, CNI_JOINT_LINE),
 * solved with the joints, before contacts. Only the kind of its handle and its definition differ from a joint's.
 */
#include "joints/joint_type.h"
#include "world/define.h"
#include "world/joint_change.h"

#include <string.h>

/* ------------------------------------------------------------------ base */

/* NULL for 0 (the world) and for a bad handle (the call has then failed). */
static const cni_body *check_side(cni_call *call, const char *field, cn_body body)
{
	return body != 0 ? cni_check_body(call, field, body) : NULL;
}

static void check_bodies(cni_call *call, const cn_joint_base *base)
{
	const cni_body *a = check_side(call, "body_a", base->body_a);
	const cni_body *b = check_side(call, "body_b", base->body_b);
	int32_t dynamic = (a != NULL && a->type == CN_BODY_DYNAMIC) || (b != NULL && b->type == CN_BODY_DYNAMIC);
	cni_check(call, base->body_a != base->body_b, CN_ERROR_ARGUMENT, "body_a and body_b are the same");
	cni_check(call, dynamic, CN_ERROR_ARGUMENT, "neither body_a nor body_b is dynamic");
	cni_check_position(call, "anchor_a_m", base->anchor_a_m);
	cni_check_position(call, "anchor_b_m", base->anchor_b_m);
}

/* Stiffness, greatest force and torque, and break thresholds of a type. */
static void check_strength(cni_call *call, int32_t type, const cn_joint_base *base)
{
	cni_joint_def_check(call, CNI_JOINT_STRENGTH, base);
	if (cni_joint_kind_of(type)->has & CNI_KIND_NEEDS_FORCE_MAX)
		cni_check_positive(call, "force_max_N of this type", base->force_max_N);
	if (type == CN_JOINT_MOTOR_TO)
		cni_check_positive(call, "torque_max_Nm of this type", base->torque_max_Nm);
}

static cn_joint_base base_of(const cn_world *world, const cni_joint *j)
{
	cn_joint_base base = {
		(uint32_t)cni_joint_kind_of(j->type)->bytes, j->flags, cni_handle_or_zero(&world->body_handles, j->body[0]), cni_handle_or_zero(&world->body_handles, j->body[1]),
		j->anchor[0], j->anchor[1], 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, j->user_data
	};
	cni_joint_def_read(j, CNI_JOINT_STRENGTH, &base);
	return base;
}

/* ------------------------------------------------------------------ the first fields of a constraint's definition */

#define CONSTRAINT_FLAGS (CN_CONSTRAINT_LIMIT | CN_CONSTRAINT_BREAKS)

static uint32_t joint_flags(uint32_t flags)
{
	return ((flags & CN_CONSTRAINT_LIMIT) ? (uint32_t)CN_JOINT_LIMIT : 0u) | ((flags & CN_CONSTRAINT_BREAKS) ? (uint32_t)CN_JOINT_BREAKS : 0u);
}

static uint32_t constraint_flags(uint32_t flags)
{
	return ((flags & CN_JOINT_LIMIT) ? (uint32_t)CN_CONSTRAINT_LIMIT : 0u) | ((flags & CN_JOINT_BREAKS) ? (uint32_t)CN_CONSTRAINT_BREAKS : 0u);
}

typedef struct constraint_head {
	uint32_t struct_size;
	uint32_t flags;
	cn_body body;
} constraint_head;

static constraint_head check_constraint(cni_call *call, int32_t type, const void *def)
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

/* ------------------------------------------------------------------ creating */

/* Reserves memory for one more joint that ends up to this many contacts. */
static void joint_reserve_one(cni_call *call, cn_world *world, int32_t contacts)
{
	cni_check(call, CNI_HAS_JOINTS, CN_ERROR_STATE, "this library was built without joints (CN_NO_JOINTS)");
	if (call->result == CN_OK)
		cni_check_reserved(call, cni_slots_reserve(world, &world->joint_handles, &world->joints, 1), "joints");
	if (call->result == CN_OK)
		cni_check_reserved(call, cni_joint_reserve(world, 1), "joints");
	if (call->result == CN_OK)
		cni_check_reserved(call, cni_contact_reserve_end(world, contacts), "events of contacts");
}

/* Takes a slot after joint_reserve_one; the record is unlinked and 0 except for the arguments. */
static int32_t joint_take(cn_world *world, int32_t type, uint32_t flags, int32_t body_a, int32_t body_b)
{
	int32_t joint = cni_handles_take(&world->joint_handles);
	cni_joint *j = cni_joint_at(world, joint);
	memset(j, 0, sizeof *j);
	j->type = type;
	j->flags = flags;
	j->body[0] = body_a;
	j->body[1] = body_b;
	j->next[0] = j->next[1] = j->prev[0] = j->prev[1] = CNI_NONE;
	j->awake = CNI_NONE;
	world->constraint_count += cni_joint_is_constraint(type);
	return joint;
}

/* base has the joint's bodies and anchors: those of def at creation; a set function ignores those of def. */
static void check_def(cni_call *call, int32_t type, const cn_joint_base *base, const void *def)
{
	const cn_joint_base *given = (const cn_joint_base *)def;
	cni_check_flags(call, "flags", given->flags, CNI_JOINT_FLAGS);
	check_strength(call, type, given);
	cni_joint_def_check(call, type, def);
	cni_check(call, type != CN_JOINT_MOUSE || base->body_a == 0, CN_ERROR_ARGUMENT, "body_a; must be 0 (the world) in this type");
	if (type == CN_JOINT_GROOVE && cni_distance_sq(base->anchor_a_m, ((const cn_groove_def *)def)->end_m) <= 0.0f)
		cni_refuse(call, CN_ERROR_ARGUMENT, "end_m is anchor_a_m; the slot must have a length > 0");
}

static cn_result joint_create(cn_world *world, const char *function, int32_t type, const void *def, cn_joint *out_joint)
{
	cni_call call = cni_enter(world, function);
	const cni_joint_kind *kind = cni_joint_kind_of(type);
	const cn_joint_base *base = (const cn_joint_base *)def;
	int32_t joint;
	cni_check_def(&call, def, kind->bytes, kind->init);
	cni_check_pointer(&call, "out_joint", out_joint);
	if (call.result != CN_OK)
		return call.result;
	check_bodies(&call, base);
	check_def(&call, type, base, def);
	if (call.result == CN_OK)
		joint_reserve_one(&call, world, base->body_a != 0 ? cni_body_at(world, cni_body_index(world, base->body_a))->contact_count : 0);
	if (call.result != CN_OK)
		return call.result;
	joint = joint_take(world, type, base->flags, cni_handles_find(&world->body_handles, base->body_a), cni_handles_find(&world->body_handles, base->body_b));
	cni_joint *j = cni_joint_at(world, joint);
	j->anchor[0] = base->anchor_a_m;
	j->anchor[1] = base->anchor_b_m;
	j->user_data = base->user_data;
	cni_joint_def_store(j, CNI_JOINT_STRENGTH, base);
	cni_joint_def_store(j, type, def);
	cni_joint_turns_begin(world, j);
	cni_joint_link(world, joint);
	*out_joint = cni_joint_handle(world, joint);
	return CN_OK;
}

static cn_result constraint_create(cn_world *world, const char *function, int32_t type, const void *def, cn_constraint *out_constraint)
{
	cni_call call = cni_enter(world, function);
	constraint_head head = check_constraint(&call, type, def);
	const cni_body *b = cni_check_body(&call, "body", head.body);
	cni_check(&call, b == NULL || b->type == CN_BODY_DYNAMIC, CN_ERROR_ARGUMENT, "body; must be dynamic");
	cni_check_pointer(&call, "out_constraint", out_constraint);
	joint_reserve_one(&call, world, 0);
	if (call.result != CN_OK)
		return call.result;
	int32_t joint = joint_take(world, type, joint_flags(head.flags) | CN_JOINT_COLLIDE, CNI_NONE, cni_body_index(world, head.body));
	cni_joint_def_store(cni_joint_at(world, joint), type, def);
	cni_joint_turns_begin(world, cni_joint_at(world, joint));
	cni_joint_link(world, joint);
	*out_constraint = cni_joint_handle(world, joint);
	return CN_OK;
}

#define DEFINE_DESTROY(noun) \
	cn_result cn_##noun##_destroy(cn_world *world, cn_##noun noun) \
	{ \
		cni_call call = cni_enter(world, __func__); \
		cni_check_##noun(&call, #noun, noun); \
		if (call.result == CN_OK) { \
			cni_joint_let_go(world, cni_joint_index(world, noun)); \
			cni_joint_destroy(world, cni_joint_index(world, noun)); \
		} \
		return call.result; \
	}

DEFINE_DESTROY(joint)
DEFINE_DESTROY(constraint)

/* ------------------------------------------------------------------ reading back and replacing */

/* handle: of a joint or a constraint, as the type says. */
static cn_result joint_get(const cn_world *world, int32_t type, uint32_t handle, void *out)
{
	cni_call call = cni_enter_const(world);
	const cni_joint *j = cni_check_joint_of_type(&call, type, handle);
	size_t bytes = cni_joint_kind_of(type)->bytes;
	cni_check_pointer(&call, "out", out);
	if (call.result != CN_OK)
		return call.result;
	memset(out, 0, bytes);
	if (cni_joint_is_constraint(type)) {
		const constraint_head head = { (uint32_t)bytes, constraint_flags(j->flags), cni_handles_of(&world->body_handles, j->body[1]) };
		memcpy(out, &head, sizeof head);
	} else {
		*(cn_joint_base *)out = base_of(world, j);
	}
	cni_joint_def_read(j, type, out);
	return CN_OK;
}

static cn_result joint_set(cn_world *world, const char *function, int32_t type, cn_joint joint, const void *def)
{
	cni_call call = cni_enter(world, function);
	cni_joint *j = cni_check_joint_of_type(&call, type, joint);
	const cn_joint_base *base = (const cn_joint_base *)def;
	cni_check_pointer(&call, "def", def);
	if (call.result != CN_OK)
		return call.result;
	cn_joint_base present = base_of(world, j);
	check_def(&call, type, &present, def);
	cni_joint_change_reserve(&call, world, j);
	if (call.result != CN_OK)
		return call.result;
	float ratio = j->p[CNI_P_GEAR_RATIO];
	cni_joint_def_store(j, CNI_JOINT_STRENGTH, base);
	cni_joint_def_store(j, type, def);
	if (type == CN_JOINT_GEAR && j->p[CNI_P_GEAR_RATIO] != ratio)
		cni_joint_turns_begin(world, j); /* turns counted at another ratio are invalid */
	if (type == CN_JOINT_RATCHET)
		cni_joint_ratchet_begin(world, j);
	j->user_data = base->user_data;
	cni_joint_change_flags(world, cni_joint_index(world, joint), base->flags);
	return CN_OK;
}

static cn_result constraint_set(cn_world *world, const char *function, int32_t type, cn_constraint constraint, const void *def)
{
	cni_call call = cni_enter(world, function);
	cni_joint *j = cni_check_joint_of_type(&call, type, constraint);
	constraint_head head = check_constraint(&call, type, def);
	if (call.result != CN_OK)
		return call.result;
	cni_joint_def_store(j, type, def);
	memset(j->impulse, 0, sizeof j->impulse); /* the impulses belong to the old limits */
	cni_joint_change_flags(world, cni_joint_index(world, constraint), joint_flags(head.flags) | CN_JOINT_COLLIDE);
	return CN_OK;
}

CNI_DEFINE_GET(joint, base, cn_joint_base, base_of(world, record))

cn_result cn_joint_set_base(cn_world *world, cn_joint joint, const cn_joint_base *base)
{
	cni_call call = cni_enter(world, __func__);
	cni_joint *j = cni_check_joint(&call, "joint", joint);
	cni_check_pointer(&call, "base", base);
	if (call.result == CN_OK)
		check_strength(&call, j->type, base);
	if (call.result != CN_OK)
		return call.result;
	cni_joint_def_store(j, CNI_JOINT_STRENGTH, base);
	j->apart = 1;
	cni_joint_wake_bodies(world, j);
	return CN_OK;
}

/* ------------------------------------------------------------------ by type */

/* noun: joint or constraint; create, set: the functions above. */
#define DEFINE_CREATE(noun, create, type, name, definition) \
	void definition##_init(definition *def) { cni_joint_def_init(type, def); } \
	cn_result cn_##noun##_create_##name(cn_world *world, const definition *def, cn_##noun *out_##noun) \
	{ \
		return create(world, __func__, type, def, out_##noun); \
	}
#define DEFINE_GET_AND_SET(noun, set, type, name, definition) \
	cn_result cn_##noun##_get_##name(const cn_world *world, cn_##noun noun, definition *out) { return joint_get(world, type, noun, out); } \
	cn_result cn_##noun##_set_##name(cn_world *world, cn_##noun noun, const definition *def) \
	{ \
		return set(world, __func__, type, noun, def); \
	}
#define DEFINE_JOINT(type, name, definition) \
	DEFINE_CREATE(joint, joint_create, type, name, definition) DEFINE_GET_AND_SET(joint, joint_set, type, name, definition)
#define DEFINE_CONSTRAINT(type, name, definition) \
	DEFINE_CREATE(constraint, constraint_create, type, name, definition) DEFINE_GET_AND_SET(constraint, constraint_set, type, name, definition)

DEFINE_JOINT(CN_JOINT_REVOLUTE, revolute, cn_revolute_def)
DEFINE_JOINT(CN_JOINT_DISTANCE, distance, cn_distance_def)
DEFINE_JOINT(CN_JOINT_FIXED, fixed, cn_fixed_def)
DEFINE_JOINT(CN_JOINT_PRISMATIC, prismatic, cn_prismatic_def)
DEFINE_JOINT(CN_JOINT_WHEEL, wheel, cn_wheel_def)
DEFINE_CREATE(joint, joint_create, CN_JOINT_MOTOR_TO, motor, cn_motor_def)
DEFINE_GET_AND_SET(joint, joint_set, CN_JOINT_MOTOR_TO, motor_to, cn_motor_def)
DEFINE_JOINT(CN_JOINT_MOUSE, mouse, cn_mouse_def)
DEFINE_JOINT(CN_JOINT_GEAR, gear, cn_gear_def)
DEFINE_JOINT(CN_JOINT_PULLEY, pulley, cn_pulley_def)
DEFINE_JOINT(CN_JOINT_RATCHET, ratchet, cn_ratchet_def)
DEFINE_JOINT(CN_JOINT_ROTARY_SPRING, rotary_spring, cn_rotary_spring_def)
DEFINE_JOINT(CN_JOINT_GROOVE, groove, cn_groove_def)
DEFINE_CREATE(joint, joint_create, CN_JOINT_FILTER, filter, cn_filter_joint_def)
DEFINE_CONSTRAINT(CNI_JOINT_ANGLE, angle, cn_angle_constraint_def)
DEFINE_CONSTRAINT(CNI_JOINT_LINE, line, cn_line_constraint_def)
