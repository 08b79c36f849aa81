/*
 * world/read.c - public bulk functions: lists of all bodies and shapes, poses and velocities of many bodies in one
 * call, the bodies that moved. All handles are checked before the first write.
 */
#include "world/error.h"

#include <string.h>

/* ------------------------------------------------------------------ lists */

static cn_result list_alive(const cn_world *world, const cni_handles *handles, uint32_t *out, int32_t capacity, int32_t *out_count)
{
	cni_call call = cni_enter_const(world);
	cni_list list = cni_list_begin(&call, out, capacity, out_count);
	if (call.result != CN_OK)
		return call.result;
	for (int32_t k = cni_handles_next(handles, 0); k != CNI_NONE && list.count < capacity; k = cni_handles_next(handles, k + 1))
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

/* ------------------------------------------------------------------ many bodies */

/* Iterates over the bodies of a bulk call: those of an array, or every live body by slot. */
typedef struct walk {
	const cn_world *world;
	const cn_body *bodies; /* NULL: every body */
	int32_t slot;          /* where the search for the next live body begins */
	int32_t step;
} walk;

static walk walk_begin(const cn_world *world, const cn_body *bodies)
{
	walk w = { world, bodies, 0, 0 };
	return w;
}

/* Index of the next body. Requires checked handles, or a count of all bodies. */
static int32_t walk_next(walk *w)
{
	if (w->bodies != NULL)
		return cni_body_index(w->world, w->bodies[w->step++]);
	w->slot = cni_handles_next(&w->world->body_handles, w->slot);
	return w->slot++;
}

static void check_bodies(cni_call *call, const cn_body *bodies, int32_t count)
{
	if (call->result == CN_OK && bodies == NULL && count != call->world->body_handles.count)
		cni_refuse_int(call, "count", count, "must be the number of bodies in the world when bodies is NULL");
	if (call->result != CN_OK || bodies == NULL || cni_handles_find_all(&call->world->body_handles, bodies, count))
		return;
	for (int32_t k = 0; k < count && call->result == CN_OK; ++k)
		cni_check_body(call, "bodies", bodies[k]);
}

/* cni_readback_at with the pages in a variable. */
static const cn_body_moved *page_item(uint8_t *const *pages, uint32_t body)
{
	return (const cn_body_moved *)(const void *)pages[body >> CNI_PAGE_READBACK] + (body & ((1u << CNI_PAGE_READBACK) - 1u));
}

/* From the readback. The first two loops need no search; compilers would reload the table's pages after each write to out. */
static void copy_poses(const cn_world *world, const cn_body *bodies, int32_t count, uint8_t *out, size_t stride)
{
	uint8_t *const *pages = world->readback.pages;
	walk w = walk_begin(world, bodies);
	if (bodies != NULL && world->body_handles.aliases.count == 0)
		for (int32_t k = 0; k < count; ++k, out += stride)
			memcpy(out, &page_item(pages, bodies[k] & CNI_HANDLE_INDEX_MASK)->pose, sizeof(cn_pose));
	else if (bodies == NULL && count == cni_handles_used(&world->body_handles))
		for (int32_t k = 0; k < count; ++k, out += stride)
			memcpy(out, &page_item(pages, (uint32_t)k)->pose, sizeof(cn_pose));
	else
		for (int32_t k = 0; k < count; ++k, out += stride)
			memcpy(out, &page_item(pages, (uint32_t)walk_next(&w))->pose, sizeof(cn_pose));
}

cn_result cn_world_read_poses_strided(const cn_world *world, const cn_body *bodies, int32_t count, void *out, int32_t stride_bytes)
{
	size_t stride = stride_bytes != 0 ? (size_t)stride_bytes : sizeof(cn_pose);
	cni_call call = cni_enter_const(world);
	walk w = walk_begin(world, bodies);
	if (stride_bytes != 0 && stride_bytes < (int32_t)sizeof(cn_pose))
		return CN_ERROR_ARGUMENT;
	cni_check_array(&call, "out", out, count);
	check_bodies(&call, bodies, count);
	if (call.result != CN_OK)
		return call.result;
	if (cni_readback_ask(world)) {
		copy_poses(world, bodies, count, (uint8_t *)out, stride);
		return CN_OK;
	}
	for (int32_t k = 0; k < count; ++k) {
		cn_pose pose = cni_body_pose(cni_body_at(world, walk_next(&w)));
		memcpy((uint8_t *)out + (size_t)k * stride, &pose, sizeof pose);
	}
	return CN_OK;
}

cn_result cn_world_read_poses(const cn_world *world, const cn_body *bodies, int32_t count, cn_pose *out)
{
	return cn_world_read_poses_strided(world, bodies, count, out, 0);
}

cn_result cn_world_read_poses_interpolated(const cn_world *world, const cn_body *bodies, int32_t count, float factor, cn_pose *out)
{
	cni_call call = cni_enter_const(world);
	walk w = walk_begin(world, bodies);
	cni_check_array(&call, "out", out, count);
	cni_check_range(&call, "factor", factor, 0.0f, 1.0f);
	check_bodies(&call, bodies, count);
	for (int32_t k = 0; k < count && call.result == CN_OK; ++k)
		out[k] = cni_pose_between(world, walk_next(&w), factor);
	return call.result;
}

cn_result cn_world_read_velocities(const cn_world *world, const cn_body *bodies, int32_t count, cn_velocity *out)
{
	cni_call call = cni_enter_const(world);
	walk w = walk_begin(world, bodies);
	cni_check_array(&call, "out", out, count);
	check_bodies(&call, bodies, count);
	for (int32_t k = 0; k < count && call.result == CN_OK; ++k)
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
	cni_check_array(&call, "velocities", velocities, count);
	check_bodies(&call, bodies, count);
	for (int32_t k = 0; k < count && call.result == CN_OK; ++k) {
		cni_check_finite2(&call, "linear_mps", velocities[k].linear_mps);
		cni_check_finite(&call, "angular_radps", velocities[k].angular_radps);
		if (cni_body_at(world, walk_next(&w))->type == CN_BODY_STATIC && !velocity_is_zero(velocities + k))
			cni_refuse(&call, CN_ERROR_STATE, "one of the bodies is static and its velocity is not zero");
	}
	w = walk_begin(world, bodies);
	for (int32_t k = 0; k < count && call.result == CN_OK; ++k) {
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

static cn_body_moved moved_of(const cn_world *world, int32_t body, uint32_t fell_asleep)
{
	const cni_body *b;
	cn_body_moved m;
	if (world->readback_kept) {
		m = *cni_readback_at(world, body);
	} else {
		b = cni_body_at(world, body);
		m.pose = cni_body_pose(b);
		m.user_data = b->user_data;
		m.body = cni_handles_of(&world->body_handles, body);
	}
	m.fell_asleep = fell_asleep;
	return m;
}

/* Those that fell asleep are marked. */
static void moved_add_asleep(cn_world *world, cni_array *moved)
{
	const cni_array *asleep = &world->events.asleep;
	for (int32_t k = 0; k < asleep->count; ++k) {
		int32_t body = cni_handles_find(&world->body_handles, ((const cn_body *)asleep->data)[k]);
		if (body == CNI_NONE || (cni_body_at(world, body)->flags & CNI_BODY_MARK))
			continue;
		cni_body_at(world, body)->flags |= CNI_BODY_MARK;
		((cn_body_moved *)moved->data)[moved->count++] = moved_of(world, body, 1u);
	}
}

static void moved_add_awake(const cn_world *world, cni_array *moved)
{
	const int32_t *ids = cni_awake_ids(world);
	for (int32_t k = 1; k < world->awake_count; ++k)
		if ((cni_body_at(world, ids[k])->flags & (CNI_BODY_MOVED | CNI_BODY_MARK)) == CNI_BODY_MOVED)
			((cn_body_moved *)moved->data)[moved->count++] = moved_of(world, ids[k], 0u);
}

/* The same where the readback is kept and no body is marked. */
static void moved_copy_awake(const cn_world *world, cni_array *moved)
{
	const int32_t *ids = cni_awake_ids(world);
	cn_body_moved *out = (cn_body_moved *)moved->data + moved->count;
	uint8_t *const *pages = world->readback.pages;
	uint32_t step = world->step_count;
	int32_t count = world->awake_count;
	for (int32_t k = 1; k < count; ++k) {
		*out = *page_item(pages, (uint32_t)ids[k]);
		if (out->fell_asleep == step) {
			out->fell_asleep = 0;
			++out;
		}
	}
	moved->count = (int32_t)(out - (cn_body_moved *)moved->data);
}

/* Bodies that fell asleep come first, then awake ones; a body that woke again is listed once. */
static int32_t moved_build(cn_world *world)
{
	cni_array *moved = &world->events.moved;
	if (!cni_array_reserve(moved, &world->memory, world->awake_count + world->events.asleep.count))
		return 0;
	moved->count = 0;
	moved_add_asleep(world, moved);
	int32_t asleep = moved->count;
	if (world->readback_kept && asleep == 0)
		moved_copy_awake(world, moved);
	else
		moved_add_awake(world, moved);
	for (int32_t k = 0; k < asleep; ++k)
		cni_body_at(world, cni_body_index(world, ((const cn_body_moved *)moved->data)[k].body))->flags &= ~(uint32_t)CNI_BODY_MARK;
	world->events.moved_built = 1;
	return 1;
}

cn_result cn_world_moved(cn_world *world, const cn_body_moved **out_moved, int32_t *out_count)
{
	cni_call call = cni_enter(world, __func__);
	cni_check_pointer(&call, "out_moved", out_moved);
	cni_check_pointer(&call, "out_count", out_count);
	if (call.result == CN_OK)
		(void)cni_readback_ask(world);
	if (call.result == CN_OK && !world->events.moved_built && !moved_build(world))
		cni_refuse(&call, CN_ERROR_MEMORY, "no memory for the list");
	if (call.result != CN_OK)
		return call.result;
	*out_moved = (const cn_body_moved *)world->events.moved.data;
	*out_count = world->events.moved.count;
	return CN_OK;
}
