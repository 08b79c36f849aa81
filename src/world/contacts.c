/*
 * world/contacts.c - public functions on contacts: the event arrays of the last step, callbacks, a body's
 * contacts, the bodies that fell asleep. Event arrays are built from the logs on the first request.
 */
#include "world/error.h"

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

static int32_t contact_side(const cn_world *world, const cni_contact *c, int32_t shape)
{
	return cni_proxy_at(world, c->proxy[0])->shape == shape ? 0 : cni_proxy_at(world, c->proxy[1])->shape == shape ? 1 : CNI_NONE;
}

/* First key of the contacts of a shape's body. */
static int32_t contact_first(const cn_world *world, const cni_shape *s)
{
	return s->body != CNI_NONE ? cni_body_at(world, s->body)->contact_first : CNI_NONE;
}

cn_result cn_shape_get_contacts(const cn_world *world, cn_shape shape, cn_contact_event *out, int32_t capacity, int32_t *out_count)
{
	cni_call call = cni_enter_const(world);
	const cni_shape *s = cni_check_shape(&call, "shape", shape);
	int32_t key, count = 0;
	cni_check_capacity(&call, "out", out, capacity);
	cni_check_pointer(&call, "out_count", out_count);
	if (call.result != CN_OK)
		return call.result;
	for (key = contact_first(world, s); key != CNI_NONE; key = cni_contact_of_key(world, key)->next[key & 1]) {
		const cni_contact *c = cni_contact_of_key(world, key);
		if (contact_side(world, c, cni_index_of(shape)) == CNI_NONE)
			continue;
		if (count < capacity)
			cni_contact_describe(world, key >> 1, c->flags & CNI_CONTACT_TOUCHING ? CN_EVENT_STAY : CN_EVENT_CREATED, out + count);
		++count;
	}
	*out_count = count;
	return CN_OK;
}

/* The shape that a contact says is in the sensor, or CNI_NONE. */
static int32_t visitor_of(const cn_world *world, int32_t key, int32_t sensor)
{
	const cni_contact *c = cni_contact_of_key(world, key);
	int32_t side = contact_side(world, c, sensor);
	return side != CNI_NONE && (c->flags & CNI_CONTACT_SENSING) ? cni_proxy_at(world, c->proxy[!side])->shape : CNI_NONE;
}

/* An edge of a chain that comes earlier in the list says the same. */
static int32_t is_listed(const cn_world *world, int32_t first, int32_t until, int32_t sensor, int32_t visitor)
{
	int32_t key;
	for (key = first; key != until; key = cni_contact_of_key(world, key)->next[key & 1])
		if (visitor_of(world, key, sensor) == visitor)
			return 1;
	return 0;
}

cn_result cn_shape_get_visitors(const cn_world *world, cn_shape sensor, cn_shape *out, int32_t capacity, int32_t *out_count)
{
	cni_call call = cni_enter_const(world);
	const cni_shape *s = cni_check_shape(&call, "sensor", sensor);
	cni_list list = cni_list_begin(&call, out, capacity, out_count);
	int32_t key, first, visitor, index = cni_index_of(sensor);
	if (call.result == CN_OK && !(s->flags & CN_SHAPE_SENSOR))
		cni_refuse(&call, CN_ERROR_STATE, "the shape is no sensor");
	if (call.result != CN_OK)
		return call.result;
	first = contact_first(world, s);
	for (key = first; key != CNI_NONE; key = cni_contact_of_key(world, key)->next[key & 1]) {
		visitor = visitor_of(world, key, index);
		if (visitor == CNI_NONE)
			continue;
		if ((s->children == 1 && cni_shape_at(world, visitor)->children == 1) || !is_listed(world, first, key, index, visitor))
			cni_list_add(&list, cni_handles_of(&world->shape_handles, visitor));
	}
	*out_count = list.count;
	return CN_OK;
}

cn_result cn_world_fell_asleep(const cn_world *world, const cn_body **out_bodies, int32_t *out_count)
{
	cni_call call = cni_enter_const(world);
	cni_check_pointer(&call, "out_bodies", out_bodies);
	cni_check_pointer(&call, "out_count", out_count);
	if (call.result != CN_OK)
		return call.result;
	*out_bodies = (const cn_body *)world->events.asleep.data;
	*out_count = world->events.asleep.count;
	return CN_OK;
}

/* ------------------------------------------------------------------ callbacks and sensors */

cn_result cn_world_set_filter_callback(cn_world *world, cn_filter_fn *function, void *user)
{
	cni_call call = cni_enter(world, __func__);
	if (call.result != CN_OK)
		return call.result;
	world->filter = function;
	world->filter_user = user;
	return CN_OK;
}

cn_result cn_world_set_pre_solve_callback(cn_world *world, cn_pre_solve_fn *function, void *user)
{
	cni_call call = cni_enter(world, __func__);
	if (call.result != CN_OK)
		return call.result;
	world->pre_solve = function;
	world->pre_solve_user = user;
	return CN_OK;
}

cn_result cn_world_set_material_mix_callback(cn_world *world, cn_material_mix_fn *function, void *user)
{
	cni_call call = cni_enter(world, __func__);
	if (call.result != CN_OK)
		return call.result;
	world->material_mix = function;
	world->material_mix_user = user;
	return CN_OK;
}

cn_result cn_world_sensor_events(const cn_world *world, const cn_sensor_event **out_events, int32_t *out_count)
{
	cni_call call = cni_enter_const(world);
	cni_check_pointer(&call, "out_events", out_events);
	cni_check_pointer(&call, "out_count", out_count);
	if (call.result != CN_OK)
		return call.result;
	*out_events = (const cn_sensor_event *)world->events.sensor_log.data;
	*out_count = world->events.sensor_log.count;
	return CN_OK;
}
