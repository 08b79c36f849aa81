/*
 * world/contacts.c - public functions on contacts: the event arrays of the last step, callbacks, a body's
 * contacts, the bodies that fell asleep. Event arrays are built from the logs on the first request.
 */
#include "world/define.h"

cn_result cn_world_contact_events(cn_world *world, int32_t kind, const cn_contact_event **out_events, int32_t *out_count)
{
	cni_call call = cni_enter(world, __func__);
	cni_check_range_int(&call, "kind", kind, 0, CN_EVENT_KINDS - 1);
	cni_check_pointer(&call, "out_events", out_events);
	cni_check_pointer(&call, "out_count", out_count);
	if (call.result == CN_OK)
		cni_check_reserved(&call, cni_events_build(world, kind), "events");
	if (call.result != CN_OK)
		return call.result;
	*out_events = (const cn_contact_event *)world->events.seen[kind].data;
	*out_count = world->events.seen[kind].count;
	return CN_OK;
}

cn_result cn_world_set_contact_callback(cn_world *world, int32_t kind, cn_contact_event_fn *function, void *user)
{
	cni_call call = cni_enter(world, __func__);
	cni_check_range_int(&call, "kind", kind, 0, CN_EVENT_KINDS - 1);
	if (call.result != CN_OK)
		return call.result;
	world->events.callback[kind] = function;
	world->events.callback_user[kind] = user;
	return CN_OK;
}

cn_result cn_body_get_contacts(const cn_world *world, cn_body body, cn_contact_event *out, int32_t capacity, int32_t *out_count)
{
	cni_call call = cni_enter_const(world);
	const cni_body *b = cni_check_body(&call, "body", body);
	int32_t key, count = 0;
	cni_check_capacity(&call, "out", out, capacity);
	cni_check_pointer(&call, "out_count", out_count);
	if (call.result != CN_OK)
		return call.result;
	for (key = b->contact_first; key != CNI_NONE && count < capacity; key = cni_contact_of_key(world, key)->next[key & 1]) {
		uint32_t touching = cni_contact_of_key(world, key)->flags & CNI_CONTACT_TOUCHING;
		cni_contact_describe(world, key >> 1, touching ? CN_EVENT_STAY : CN_EVENT_CREATED, out + count++);
	}
	*out_count = b->contact_count;
	return CN_OK;
}

CNI_DEFINE_EVENTS(fell_asleep, cn_body, asleep)

/* ------------------------------------------------------------------ callbacks and sensors */

#define DEFINE_SET_CALLBACK(name, type) \
	cn_result cn_world_set_##name##_callback(cn_world *world, type *function, void *user) \
	{ \
		cni_call call = cni_enter(world, __func__); \
		if (call.result != CN_OK) \
			return call.result; \
		world->name = function; \
		world->name##_user = user; \
		return CN_OK; \
	}

DEFINE_SET_CALLBACK(filter, cn_filter_fn)
DEFINE_SET_CALLBACK(pre_solve, cn_pre_solve_fn)
DEFINE_SET_CALLBACK(material_mix, cn_material_mix_fn)
CNI_DEFINE_EVENTS(sensor_events, cn_sensor_event, sensor_log)
