/*
 * world/contacts.c - public functions on contacts: the event arrays of the last step, callbacks, the contacts of a body or a shape,
 * the visitors of a sensor, the bodies that fell asleep. Event arrays are built from the logs on the first request.
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

/* ------------------------------------------------------------------ lists */

/* Those of sensors have events of their own. */
static void contact_read(const cn_world *world, int32_t key, cn_contact_event *out, int32_t capacity, int32_t *count)
{
	uint32_t flags = cni_contact_of_key(world, key)->flags;
	if (flags & CNI_CONTACT_SENSOR)
		return;
	if (*count < capacity)
		cni_contact_describe(world, key >> 1, flags & CNI_CONTACT_TOUCHING ? CN_EVENT_STAY : CN_EVENT_CREATED, out + *count);
	++*count;
}

cn_result cn_body_get_contacts(const cn_world *world, cn_body body, cn_contact_event *out, int32_t capacity, int32_t *out_count)
{
	cni_call call = cni_enter_const(world);
	const cni_body *b = cni_check_body(&call, "body", body);
	int32_t key, count = 0;
	cni_check_output(&call, out, capacity, out_count);
	if (call.result != CN_OK)
		return call.result;
	for (key = b->contact_first; key != CNI_NONE; key = cni_contact_of_key(world, key)->next[key & 1])
		contact_read(world, key, out, capacity, &count);
	*out_count = count;
	return CN_OK;
}

cn_result cn_shape_get_contacts(const cn_world *world, cn_shape shape, cn_contact_event *out, int32_t capacity, int32_t *out_count)
{
	cni_call call = cni_enter_const(world);
	int32_t key, index = cni_shape_index(world, shape), count = 0;
	cni_check_shape(&call, "shape", shape);
	cni_check_output(&call, out, capacity, out_count);
	if (call.result != CN_OK)
		return call.result;
	for (key = cni_contact_first_of_shape(world, index); key != CNI_NONE; key = cni_contact_next_of_shape(world, key, index))
		contact_read(world, key, out, capacity, &count);
	*out_count = count;
	return CN_OK;
}

/* The shape that is in the sensor according to a contact, or CNI_NONE. */
static int32_t visitor_of(const cn_world *world, int32_t key, int32_t sensor)
{
	const cni_contact *c = cni_contact_of_key(world, key);
	int32_t side = cni_proxy_at(world, c->proxy[0])->shape == sensor;
	return c->flags & CNI_CONTACT_SENSING ? cni_proxy_at(world, c->proxy[side])->shape : CNI_NONE;
}

/* Whether an earlier contact has the same visitor: chains have a contact for each edge. */
static int32_t is_listed(const cn_world *world, int32_t until, int32_t sensor, int32_t visitor)
{
	int32_t key = cni_contact_first_of_shape(world, sensor);
	while (key != until && visitor_of(world, key, sensor) != visitor)
		key = cni_contact_next_of_shape(world, key, sensor);
	return key != until;
}

cn_result cn_shape_get_visitors(const cn_world *world, cn_shape sensor, cn_shape *out, int32_t capacity, int32_t *out_count)
{
	cni_call call = cni_enter_const(world);
	const cni_shape *s = cni_check_shape(&call, "sensor", sensor);
	cni_list list = cni_list_begin(&call, out, capacity, out_count);
	int32_t key, visitor, index = cni_shape_index(world, sensor);
	cni_check(&call, s == NULL || (s->flags & CN_SHAPE_SENSOR), CN_ERROR_STATE, "the shape is no sensor");
	if (call.result != CN_OK)
		return call.result;
	for (key = cni_contact_first_of_shape(world, index); key != CNI_NONE; key = cni_contact_next_of_shape(world, key, index)) {
		visitor = visitor_of(world, key, index);
		if (visitor == CNI_NONE)
			continue;
		if ((cni_shape_children(&world->blocks, s) == 1 && cni_shape_children(&world->blocks, cni_shape_at(world, visitor)) == 1) || !is_listed(world, key, index, visitor))
			cni_list_add(&list, cni_handles_of(&world->shape_handles, visitor));
	}
	*out_count = list.count;
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
