/*
 * world/read.c - public bulk functions: lists of everything alive, poses and velocities of many bodies in
 * one call, the bodies that moved. Every handle is checked before anything is written.
 */
#include "world/joint_change.h"

#include <string.h>

/* ------------------------------------------------------------------ lists */

static cn_result list_alive(const cn_world *world, const cni_handles *handles, uint32_t *out, int32_t capacity, int32_t *out_count)
{
	cni_call call = cni_enter_const(world);
	cni_list list = cni_list_begin(&call, out, capacity, out_count);
	int32_t used, k;
	if (call.result != CN_OK)
		return call.result;
	used = cni_handles_used(handles);
	for (k = 0; k < used && list.count < capacity; ++k)
		if (cni_handles_alive(handles, k))
			cni_list_add(&list, cni_handles_of(handles, k));
	*out_count = handles->count;
	return CN_OK;
}

cn_result cn_world_get_bodies(const cn_world *world, cn_body *out, int32_t capacity, int32_t *out_count)
{
	return list_alive(world, world != NULL ? &world->body_handles : NULL, out, capacity, out_count);
}

cn_result cn_world_get_shapes(const cn_world *world, cn_shape *out, int32_t capacity, int32_t *out_count)
{
	return list_alive(world, world != NULL ? &world->shape_handles : NULL, out, capacity, out_count);
}

cn_result cn_world_get_joints(const cn_world *world, cn_joint *out, int32_t capacity, int32_t *out_count)
{
	return cni_list_joints(world, 0, out, capacity, out_count);
}

/* ------------------------------------------------------------------ many bodies */

/* Walks the bodies of a bulk call: those of an array, or every live one by slot. */
typedef struct walk {
	const cn_world *world;
	const cn_body *bodies; /* NULL: every body */
	int32_t slot;          /* where the search for the next live one begins */
	int32_t step;
} walk;

static walk walk_begin(const cn_world *world, const cn_body *bodies)
{
	walk w;
	w.world = world;
	w.bodies = bodies;
	w.slot = w.step = 0;
	return w;
}

/* Index of the next body. The handles have been checked, or the count is that of all bodies. */
static int32_t walk_next(walk *w)
{
	if (w->bodies != NULL)
		return cni_body_index(w->world, w->bodies[w->step++]);
	while (!cni_handles_alive(&w->world->body_handles, w->slot))
		++w->slot;
	return w->slot++;
}

static void check_bodies(cni_call *call, const cn_body *bodies, int32_t count)
{
	int32_t k;
	if (call->result == CN_OK && bodies == NULL && count != call->world->body_handles.count)
		cni_refuse_int(call, "count", count, "must be the number of bodies in the world when bodies is NULL");
	for (k = 0; k < count && bodies != NULL && call->result == CN_OK; ++k)
		cni_check_body(call, "bodies", bodies[k]);
}

static cn_result read_poses(const cn_world *world, const cn_body *bodies, int32_t count, void *out, int32_t stride)
{
	cni_call call = cni_enter_const(world);
	walk w = walk_begin(world, bodies);
	int32_t k;
	cni_check_array(&call, "out", out, count);
	check_bodies(&call, bodies, count);
	for (k = 0; k < count && call.result == CN_OK; ++k) {
		cn_pose pose = cni_body_pose(cni_body_at(world, walk_next(&w)));
		memcpy((uint8_t *)out + (size_t)k * (size_t)stride, &pose, sizeof pose);
	}
	return call.result;
}

cn_result cn_world_read_poses(const cn_world *world, const cn_body *bodies, int32_t count, cn_pose *out)
{
	return read_poses(world, bodies, count, out, (int32_t)sizeof(cn_pose));
}

cn_result cn_world_read_poses_strided(const cn_world *world, const cn_body *bodies, int32_t count, void *out, int32_t stride_bytes)
{
	if (stride_bytes != 0 && stride_bytes < (int32_t)sizeof(cn_pose))
		return CN_ERROR_ARGUMENT;
	return read_poses(world, bodies, count, out, stride_bytes != 0 ? stride_bytes : (int32_t)sizeof(cn_pose));
}

cn_result cn_world_read_poses_interpolated(const cn_world *world, const cn_body *bodies, int32_t count, float factor, cn_pose *out)
{
	cni_call call = cni_enter_const(world);
	walk w = walk_begin(world, bodies);
	int32_t k;
	cni_check_array(&call, "out", out, count);
	cni_check_range(&call, "factor", factor, 0.0f, 1.0f);
	check_bodies(&call, bodies, count);
	for (k = 0; k < count && call.result == CN_OK; ++k)
		out[k] = cni_pose_between(world, walk_next(&w), factor);
	return call.result;
}

cn_result cn_world_read_velocities(const cn_world *world, const cn_body *bodies, int32_t count, cn_velocity *out)
{
	cni_call call = cni_enter_const(world);
	walk w = walk_begin(world, bodies);
	int32_t k;
	cni_check_array(&call, "out", out, count);
	check_bodies(&call, bodies, count);
	for (k = 0; k < count && call.result == CN_OK; ++k)
		out[k] = cni_body_velocity(world, cni_body_at(world, walk_next(&w)));
	return call.result;
}

static int32_t velocity_is_zero(const cn_velocity *v)
{
	return v->linear_mps.x == 0.0f && v->linear_mps.y == 0.0f && v->angular_radps == 0.0f;
}

cn_result cn_world_write_velocities(cn_world *world, const cn_body *bodies, int32_t count, const cn_velocity *velocities)
{
	cni_call call = cni_enter(world, __func__);
	walk w = walk_begin(world, bodies);
	int32_t k;
	cni_check_array(&call, "velocities", velocities, count);
	check_bodies(&call, bodies, count);
	for (k = 0; k < count && call.result == CN_OK; ++k) {
		cni_check_finite2(&call, "linear_mps", velocities[k].linear_mps);
		cni_check_finite(&call, "angular_radps", velocities[k].angular_radps);
		if (cni_body_at(world, walk_next(&w))->type == CN_BODY_STATIC && !velocity_is_zero(velocities + k))
			cni_refuse(&call, CN_ERROR_STATE, "one of the bodies is static and its velocity is not zero");
	}
	w = walk_begin(world, bodies);
	for (k = 0; k < count && call.result == CN_OK; ++k) {
		int32_t body = walk_next(&w);
		if (cni_body_at(world, body)->type == CN_BODY_STATIC)
			continue;
		if (!velocity_is_zero(velocities + k))
			cni_body_wake(world, body);
		cni_body_store_velocity(world, cni_body_at(world, body), velocities[k]);
		cni_body_kick(world, body);
	}
	return call.result;
}

/* ------------------------------------------------------------------ moved */

static void moved_add(cn_world *world, int32_t body, uint32_t fell_asleep)
{
	cni_array *moved = &world->events.moved;
	cn_body_moved *m = (cn_body_moved *)moved->data + moved->count++;
	cni_body *b = cni_body_at(world, body);
	m->pose = cni_body_pose(b);
	m->user_data = b->user_data;
	m->body = cni_handles_of(&world->body_handles, body);
	m->fell_asleep = fell_asleep;
	b->flags |= CNI_BODY_MARK;
}

/* Those that fell asleep first, then the awake ones; a body woken again since is listed once. */
static int32_t moved_build(cn_world *world)
{
	cni_array *moved = &world->events.moved;
	const cni_array *asleep = &world->events.asleep;
	const int32_t *ids = cni_awake_ids(world);
	int32_t k;
	if (!cni_array_reserve(moved, &world->memory, world->awake_count + asleep->count))
		return 0;
	moved->count = 0;
	for (k = 0; k < asleep->count; ++k) {
		int32_t body = cni_handles_find(&world->body_handles, ((const cn_body *)asleep->data)[k]);
		if (body != CNI_NONE && !(cni_body_at(world, body)->flags & CNI_BODY_MARK))
			moved_add(world, body, 1);
	}
	for (k = 1; k < world->awake_count; ++k)
		if ((cni_body_at(world, ids[k])->flags & (CNI_BODY_MOVED | CNI_BODY_MARK)) == CNI_BODY_MOVED)
			moved_add(world, ids[k], 0);
	for (k = 0; k < moved->count; ++k)
		cni_body_at(world, cni_body_index(world, ((const cn_body_moved *)moved->data)[k].body))->flags &= ~(uint32_t)CNI_BODY_MARK;
	world->events.moved_built = 1;
	return 1;
}

cn_result cn_world_moved(cn_world *world, const cn_body_moved **out_moved, int32_t *out_count)
{
	cni_call call = cni_enter(world, __func__);
	cni_check_pointer(&call, "out_moved", out_moved);
	cni_check_pointer(&call, "out_count", out_count);
	if (call.result == CN_OK && !world->events.moved_built && !moved_build(world))
		cni_refuse(&call, CN_ERROR_MEMORY, "no memory for the list");
	if (call.result != CN_OK)
		return call.result;
	*out_moved = (const cn_body_moved *)world->events.moved.data;
	*out_count = world->events.moved.count;
	return CN_OK;
}
