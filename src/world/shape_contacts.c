/*
 * world/shape_contacts.c - public functions on the contacts of one shape, and on the visitors of a sensor. Both iterate over
 * the contacts of the shape's body.
 */
#include "world/error.h"

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
		if (contact_side(world, c, cni_shape_index(world, shape)) == CNI_NONE)
			continue;
		if (count < capacity)
			cni_contact_describe(world, key >> 1, c->flags & CNI_CONTACT_TOUCHING ? CN_EVENT_STAY : CN_EVENT_CREATED, out + count);
		++count;
	}
	*out_count = count;
	return CN_OK;
}

/* The shape that is in the sensor according to a contact, or CNI_NONE. */
static int32_t visitor_of(const cn_world *world, int32_t key, int32_t sensor)
{
	const cni_contact *c = cni_contact_of_key(world, key);
	int32_t side = contact_side(world, c, sensor);
	return side != CNI_NONE && (c->flags & CNI_CONTACT_SENSING) ? cni_proxy_at(world, c->proxy[!side])->shape : CNI_NONE;
}

/* Whether an earlier contact has the same visitor: chains have a contact for each edge. */
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
	int32_t key, first, visitor, index = cni_shape_index(world, sensor);
	if (call.result == CN_OK && !(s->flags & CN_SHAPE_SENSOR))
		cni_refuse(&call, CN_ERROR_STATE, "the shape is no sensor");
	if (call.result != CN_OK)
		return call.result;
	first = contact_first(world, s);
	for (key = first; key != CNI_NONE; key = cni_contact_of_key(world, key)->next[key & 1]) {
		visitor = visitor_of(world, key, index);
		if (visitor == CNI_NONE)
			continue;
		if ((cni_shape_children(&world->blocks, s) == 1 && cni_shape_children(&world->blocks, cni_shape_at(world, visitor)) == 1) || !is_listed(world, first, key, index, visitor))
			cni_list_add(&list, cni_handles_of(&world->shape_handles, visitor));
	}
	*out_count = list.count;
	return CN_OK;
}
