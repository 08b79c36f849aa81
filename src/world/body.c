/*
 * world/body.c - public functions on a body's life: creation, destruction, names, user data, lists.
 *
 * Creation reserves everything first (handles, records, dense arrays, names) and then commits, so that a
 * failed call changes nothing. Destruction first reserves memory for the events of the contacts it ends.
 */
#include "world/define.h"

#include <string.h>

#define BODY_FLAGS (CN_BODY_LOCK_X | CN_BODY_LOCK_Y | CN_BODY_LOCK_ROTATION | CN_BODY_BULLET | CN_BODY_ENABLED | CN_BODY_SLEEP | CN_BODY_AWAKE)

/* Size classes of the blocks that names fall into: 16, 32, 48 and 64 bytes. */
#define NAME_CLASSES 4

void cn_body_def_init(cn_body_def *def)
{
	if (!cni_def_begin(def, sizeof *def))
		return;
	def->type = CN_BODY_DYNAMIC;
	def->gravity_scale = 1.0f;
	def->sleep_speed_mps = CN_DEFAULT;
	def->flags = CN_BODY_ENABLED | CN_BODY_SLEEP | CN_BODY_AWAKE;
}

/* ------------------------------------------------------------------ names */

/* Length with the zero, 0 for no name; reads at most CN_NAME_MAX_BYTES + 1 bytes. */
static int32_t name_bytes(const char *name)
{
	int32_t length = 0;
	if (name == NULL || name[0] == '\0')
		return 0;
	while (length <= CN_NAME_MAX_BYTES && name[length] != '\0')
		++length;
	return length + 1;
}

static void check_name(cni_call *call, const char *name)
{
	cni_check(call, name_bytes(name) <= CN_NAME_MAX_BYTES + 1, CN_ERROR_ARGUMENT, "name is too long; it may have at most 63 bytes");
}

/* Bytes of a name's piece in the block allocator, 0 for no name. A fixed world reserves pieces of the greatest size. */
static int32_t name_piece_bytes(const cn_world *world, const char *name)
{
	int32_t bytes = name_bytes(name);
	return bytes > 0 && world->memory.fixed ? CN_NAME_MAX_BYTES + 1 : bytes;
}

static void name_free(cn_world *world, cni_body *b)
{
	if (b->name != 0)
		cni_blocks_free(&world->blocks, b->name, (uint64_t)name_piece_bytes(world, (const char *)cni_blocks_at(&world->blocks, b->name)));
	b->name = 0;
}

/* 0 for no name and without memory. */
static cni_ref name_copy(cn_world *world, const char *name)
{
	int32_t bytes = name_bytes(name);
	cni_ref ref = bytes > 0 ? cni_blocks_alloc(&world->blocks, (uint64_t)name_piece_bytes(world, name)) : 0;
	if (ref != 0)
		memcpy(cni_blocks_at(&world->blocks, ref), name, (size_t)bytes);
	return ref;
}

cn_result cn_body_set_name(cn_world *world, cn_body body, const char *name)
{
	cni_call call = cni_enter(world, __func__);
	cni_body *b = cni_check_body(&call, "body", body);
	check_name(&call, name);
	if (call.result != CN_OK)
		return call.result;
	cni_ref copy = name_copy(world, name);
	if (copy == 0 && name_bytes(name) > 0)
		return cni_refuse(&call, CN_ERROR_MEMORY, "no memory for the name");
	name_free(world, b);
	b->name = copy;
	return CN_OK;
}

CNI_DEFINE_GET(body, name, const char *, record->name != 0 ? (const char *)cni_blocks_at(&world->blocks, record->name) : "")

/* ------------------------------------------------------------------ creating */

static void check_def(cni_call *call, const cn_body_def *def)
{
	if (!cni_check_def(call, def, sizeof *def, "cn_body_def_init"))
		return;
	cni_check_range_int(call, "type", def->type, CN_BODY_STATIC, CN_BODY_DYNAMIC);
	cni_check_position(call, "position_m", def->position_m);
	cni_check_angle(call, "angle_rad", def->angle_rad);
	cni_check_finite2(call, "linear_velocity_mps", def->linear_velocity_mps);
	cni_check_finite(call, "angular_velocity_radps", def->angular_velocity_radps);
	cni_check_at_least(call, "linear_damping_per_s", def->linear_damping_per_s, 0.0f);
	cni_check_at_least(call, "angular_damping_per_s", def->angular_damping_per_s, 0.0f);
	cni_check_finite(call, "gravity_scale", def->gravity_scale);
	cni_check_at_least_or_default(call, "sleep_speed_mps", def->sleep_speed_mps);
	cni_check_flags(call, "flags", def->flags, BODY_FLAGS);
	cni_check_solver(call, def->solver, CN_SOLVER_DIRECT);
	check_name(call, def->name);
}

/* Reserves memory for count bodies, with a piece of the block allocator for each name. */
static void reserve_bodies(cni_call *call, cn_world *world, const cn_body_def *defs, int32_t count)
{
	int32_t names[NAME_CLASSES] = { 0, 0, 0, 0 };
	int32_t movable = 0, k;
	if (call->result != CN_OK)
		return;
	for (k = 0; k < count; ++k) {
		int32_t bytes = name_piece_bytes(world, defs[k].name);
		movable += defs[k].type != CN_BODY_STATIC;
		if (bytes > 0)
			++names[(bytes - 1) / (int32_t)CNI_BLOCK_UNIT];
	}
	cni_check_reserved(call, cni_slots_reserve(world, &world->body_handles, &world->bodies, count), "bodies");
	if (call->result == CN_OK && world->readback_kept)
		world->readback_kept = cni_table_reserve(&world->readback, &world->memory, cni_table_capacity(&world->bodies));
	if (call->result == CN_OK)
		cni_check_reserved(call, cni_body_reserve(world, movable), "movable bodies");
	for (k = 0; k < NAME_CLASSES; ++k)
		if (call->result == CN_OK && names[k] > 0 && !cni_blocks_reserve(&world->blocks, (uint64_t)(k + 1) * CNI_BLOCK_UNIT, names[k]))
			cni_refuse(call, CN_ERROR_MEMORY, "no memory for names");
}

static cn_body body_commit(cn_world *world, const cn_body_def *def)
{
	const uint32_t awake = CN_BODY_AWAKE | CN_BODY_ENABLED;
	int32_t index = cni_handles_take(&world->body_handles);
	cni_body_init(world, index, def);
	cni_body_at(world, index)->name = name_copy(world, def->name);
	if (def->type != CN_BODY_STATIC) {
		++world->movable_count;
		if ((def->flags & awake) == awake)
			cni_body_enter_awake(world, index);
	}
	return cni_handles_of(&world->body_handles, index);
}

cn_result cn_body_create(cn_world *world, const cn_body_def *def, cn_body *out_body)
{
	cni_call call = cni_enter(world, __func__);
	check_def(&call, def);
	cni_check_pointer(&call, "out_body", out_body);
	reserve_bodies(&call, world, def, 1);
	if (call.result == CN_OK)
		*out_body = body_commit(world, def);
	return call.result;
}

cn_result cn_body_create_many(cn_world *world, const cn_body_def *defs, int32_t count, cn_body *out_bodies)
{
	cni_call call = cni_enter(world, __func__);
	cni_check_array(&call, "defs", defs, count);
	cni_check_array(&call, "out_bodies", out_bodies, count);
	for (int32_t k = 0; k < count && call.result == CN_OK; ++k)
		check_def(&call, defs + k);
	reserve_bodies(&call, world, defs, count);
	for (int32_t k = 0; k < count && call.result == CN_OK; ++k)
		out_bodies[k] = body_commit(world, defs + k);
	return call.result;
}

/* ------------------------------------------------------------------ destroying */

static void reserve_end(cni_call *call, cn_world *world, int32_t contacts, int32_t joints)
{
	if (call->result == CN_OK)
		cni_check_reserved(call, cni_contact_reserve_end(world, contacts), "events of contacts");
	if (call->result == CN_OK && !cni_joint_reserve_events(world, joints))
		cni_refuse(call, CN_ERROR_MEMORY, "no memory for events of joints");
}

static void destroy_joints(cn_world *world, const cni_body *b)
{
	while (b->joint_first != CNI_NONE) {
		int32_t joint = b->joint_first >> 1;
		cni_joint_event_log(world, joint, 0.0f, 0.0f, 1);
		cni_joint_destroy(world, joint);
	}
}

static void destroy_shapes(cn_world *world, const cni_body *b)
{
	while (b->shape_first != CNI_NONE) {
		int32_t shape = b->shape_first;
		cni_shape_unplace(world, shape);
		cni_shape_unlink(world, shape);
		cni_shape_free_geometry(world, shape);
		cni_handles_release(&world->shape_handles, shape);
	}
}

/* Requires reserve_end for the body's contacts and joints. */
static void body_destroy(cn_world *world, int32_t body)
{
	cni_body *b = cni_body_at(world, body);
	cni_body_let_go(world, body);
	cni_body_wake(world, body);
	destroy_joints(world, b);
	destroy_shapes(world, b);
	cni_island_remove_body(world, body);
	if (b->awake != 0)
		cni_body_leave_awake(world, body);
	name_free(world, b);
	world->movable_count -= b->type != CN_BODY_STATIC;
	world->events.moved_built = 0;
	cni_handles_release(&world->body_handles, body);
}

cn_result cn_body_destroy(cn_world *world, cn_body body)
{
	cni_call call = cni_enter(world, __func__);
	const cni_body *b = cni_check_body(&call, "body", body);
	if (call.result == CN_OK)
		reserve_end(&call, world, b->contact_count, cni_joint_count(world, cni_body_index(world, body)));
	if (call.result == CN_OK)
		body_destroy(world, cni_body_index(world, body));
	return call.result;
}

/* Checks and marks every body; a body with a mark is a duplicate. Returns the number of marked bodies. */
static int32_t mark_bodies(cni_call *call, const cn_body *bodies, int32_t count, int32_t *out_contacts, int32_t *out_joints)
{
	int32_t k;
	for (k = 0; k < count; ++k) {
		cni_body *b = cni_check_body(call, "bodies", bodies[k]);
		if (b != NULL && (b->flags & CNI_BODY_MARK))
			cni_refuse_int(call, "bodies, number", k, "appears twice");
		if (call->result != CN_OK)
			break;
		b->flags |= CNI_BODY_MARK;
		*out_contacts += b->contact_count;
		*out_joints += cni_joint_count(call->world, cni_body_index(call->world, bodies[k]));
	}
	return k;
}

cn_result cn_body_destroy_many(cn_world *world, const cn_body *bodies, int32_t count)
{
	cni_call call = cni_enter(world, __func__);
	int32_t marked = 0, contacts = 0, joints = 0, k;
	cni_check_array(&call, "bodies", bodies, count);
	if (call.result == CN_OK)
		marked = mark_bodies(&call, bodies, count, &contacts, &joints);
	for (k = 0; k < marked; ++k)
		cni_body_at(world, cni_body_index(world, bodies[k]))->flags &= ~(uint32_t)CNI_BODY_MARK;
	reserve_end(&call, world, contacts, joints);
	for (k = 0; k < count && call.result == CN_OK; ++k)
		body_destroy(world, cni_body_index(world, bodies[k]));
	return call.result;
}

CNI_DEFINE_IS_VALID(body)

/* ------------------------------------------------------------------ user data and lists */

CNI_DEFINE_USER_DATA(body, cni_readback_store(world, cni_body_index(world, body)))

cn_result cn_body_get_shapes(const cn_world *world, cn_body body, cn_shape *out, int32_t capacity, int32_t *out_count)
{
	cni_call call = cni_enter_const(world);
	const cni_body *b = cni_check_body(&call, "body", body);
	cni_list list = cni_list_begin(&call, out, capacity, out_count);
	if (call.result != CN_OK)
		return call.result;
	for (int32_t shape = b->shape_first; shape != CNI_NONE; shape = cni_shape_at(world, shape)->next)
		cni_list_add(&list, cni_handles_of(&world->shape_handles, shape));
	*out_count = list.count;
	return CN_OK;
}
