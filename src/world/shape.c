/*
 * world/shape.c - public functions on a shape's life and properties: attaching, detaching, destroying,
 * material, density, filter, events, user data.
 *
 * Functions that remove a shape's boxes end its contacts and reserve memory for their events first.
 */
#include "world/define.h"

/* ------------------------------------------------------------------ attaching */

cn_result cn_shape_attach(cn_world *world, cn_shape shape, cn_body body)
{
	cni_call call = cni_enter(world, __func__);
	const cni_shape *s = cni_check_shape(&call, "shape", shape);
	const cni_body *b = cni_check_body(&call, "body", body);
	cni_check(&call, s == NULL || s->body == CNI_NONE, CN_ERROR_STATE, "the shape is attached already");
	if (call.result != CN_OK)
		return call.result;
	cni_shape_link(world, cni_shape_index(world, shape), cni_body_index(world, body));
	if (b->flags & CN_BODY_ENABLED)
		cni_check_reserved(&call, cni_shape_place(world, cni_shape_index(world, shape)), "the shape's boxes");
	if (call.result != CN_OK) {
		cni_shape_unlink(world, cni_shape_index(world, shape));
		return call.result;
	}
	cni_body_shapes_changed(world, cni_body_index(world, body), cni_shape_index(world, shape));
	cni_shape_wake_grown(world, cni_shape_index(world, shape));
	return CN_OK;
}

/* Detaches a shape from its body. Requires cni_contact_reserve_end. */
static void shape_leave_body(cn_world *world, int32_t shape)
{
	int32_t body = cni_shape_at(world, shape)->body, left;
	cni_body_wake(world, body);
	cni_shape_unplace(world, shape);
	left = cni_body_shape_leaves(world, body, shape);
	cni_shape_unlink(world, shape);
	if (!left)
		cni_body_shapes_changed(world, body, CNI_NONE);
}

cn_result cn_shape_detach(cn_world *world, cn_shape shape)
{
	cni_call call = cni_enter(world, __func__);
	const cni_shape *s = cni_check_shape(&call, "shape", shape);
	cni_check(&call, s == NULL || s->body != CNI_NONE, CN_ERROR_STATE, "the shape is not attached");
	cni_check_ends_of(&call, world, s != NULL ? s->body : CNI_NONE);
	if (call.result == CN_OK)
		shape_leave_body(world, cni_shape_index(world, shape));
	return call.result;
}

cn_result cn_shape_destroy(cn_world *world, cn_shape shape)
{
	cni_call call = cni_enter(world, __func__);
	const cni_shape *s = cni_check_shape(&call, "shape", shape);
	cni_check_ends_of(&call, world, s != NULL ? s->body : CNI_NONE);
	if (call.result != CN_OK)
		return call.result;
	if (s->body != CNI_NONE)
		shape_leave_body(world, cni_shape_index(world, shape));
	cni_shape_free_geometry(world, cni_shape_index(world, shape));
	cni_handles_release(&world->shape_handles, cni_shape_index(world, shape));
	return CN_OK;
}

CNI_DEFINE_IS_VALID(shape)
CNI_DEFINE_GET(shape, type, int32_t, record->type)
CNI_DEFINE_GET(shape, body, cn_body, cni_handle_or_zero(&world->body_handles, record->body))

/* ------------------------------------------------------------------ contacts of a shape */

/* The shape may collide with more shapes from now on: wakes bodies near it, so that the next step checks their contacts. */
static void wake_met(cn_world *world, int32_t shape)
{
	int32_t body = cni_shape_at(world, shape)->body;
	if (body == CNI_NONE)
		return;
	if (cni_body_at(world, body)->type == CN_BODY_STATIC)
		cni_shape_wake_met(world, shape);
	else
		cni_body_wake(world, body);
}

static void wake_touching(cn_world *world, const cni_contact *c)
{
	if (!(c->flags & CNI_CONTACT_TOUCHING))
		return;
	cni_body_wake(world, c->body[0]);
	cni_body_wake(world, c->body[1]);
}

/* ------------------------------------------------------------------ material and density */

cn_result cn_shape_set_material(cn_world *world, cn_shape shape, const cn_material *material)
{
	cni_call call = cni_enter(world, __func__);
	cni_shape *s = cni_check_shape(&call, "shape", shape);
	int32_t index = cni_shape_index(world, shape), key;
	cni_check_pointer(&call, "material", material);
	if (call.result == CN_OK)
		cni_check_material(&call, material);
	if (call.result == CN_OK && !cni_shape_store_material(world, s, material))
		cni_refuse(&call, CN_ERROR_MEMORY, "no memory for the material's user_id");
	if (call.result != CN_OK)
		return call.result;
	for (key = cni_contact_first_of_shape(world, index); key != CNI_NONE; key = cni_contact_next_of_shape(world, key, index)) {
		cni_contact_of_key(world, key)->flags |= CNI_CONTACT_REFRESH;
		cni_contact_invalidate(world, key >> 1);
		wake_touching(world, cni_contact_of_key(world, key));
	}
	return CN_OK;
}

CNI_DEFINE_GET(shape, material, cn_material, cni_shape_material(world, record))

cn_result cn_shape_set_density(cn_world *world, cn_shape shape, float density_kgpm2)
{
	cni_call call = cni_enter(world, __func__);
	cni_shape *s = cni_check_shape(&call, "shape", shape);
	cni_check_at_least(&call, "density_kgpm2", density_kgpm2, 0.0f);
	if (call.result == CN_OK)
		cni_check_shape_mass(&call, cni_geometry_mass(cni_shape_geometry(&world->blocks, s), density_kgpm2));
	if (call.result != CN_OK)
		return call.result;
	int32_t left = s->body != CNI_NONE && cni_body_shape_leaves(world, s->body, cni_shape_index(world, shape));
	s->density = density_kgpm2;
	if (s->body != CNI_NONE) {
		if (cni_body_at(world, s->body)->type != CN_BODY_STATIC)
			cni_body_shape_replaced(world, s->body, cni_shape_index(world, shape), left);
		cni_body_wake(world, s->body);
	}
	return CN_OK;
}

CNI_DEFINE_GET(shape, density, float, record->density)

/* ------------------------------------------------------------------ filter and events */

static void end_forbidden_contacts(cn_world *world, int32_t shape)
{
	int32_t key = cni_contact_first_of_shape(world, shape);
	while (key != CNI_NONE) {
		const cni_contact *c = cni_contact_of_key(world, key);
		int32_t contact = key >> 1;
		key = cni_contact_next_of_shape(world, key, shape);
		if (cni_filter_allows(cni_shape_at(world, cni_proxy_at(world, c->proxy[0])->shape), cni_shape_at(world, cni_proxy_at(world, c->proxy[1])->shape)))
			continue;
		wake_touching(world, c);
		cni_contact_destroy(world, contact);
	}
}

cn_result cn_shape_set_filter(cn_world *world, cn_shape shape, const cn_filter *filter)
{
	cni_call call = cni_enter(world, __func__);
	cni_shape *s = cni_check_shape(&call, "shape", shape);
	cni_check_pointer(&call, "filter", filter);
	cni_check_ends_of(&call, world, s != NULL ? s->body : CNI_NONE);
	if (call.result != CN_OK)
		return call.result;
	s->category = filter->category;
	s->mask = filter->mask;
	s->group = filter->group;
	end_forbidden_contacts(world, cni_shape_index(world, shape));
	cni_shape_refilter(world, cni_shape_index(world, shape));
	wake_met(world, cni_shape_index(world, shape));
	return CN_OK;
}

static cn_filter filter_of(const cni_shape *s)
{
	cn_filter f = { s->category, s->mask, s->group, 0 };
	return f;
}

CNI_DEFINE_GET(shape, filter, cn_filter, filter_of(record))

/* A contact reports the events that either of its shapes requests. */
static void contact_refresh_mask(cn_world *world, int32_t contact)
{
	const cni_contact *c = cni_contact_at(world, contact);
	const cni_shape *a = cni_shape_at(world, cni_proxy_at(world, c->proxy[0])->shape);
	const cni_shape *b = cni_shape_at(world, cni_proxy_at(world, c->proxy[1])->shape);
	cni_contact_set_events(world, contact, (uint32_t)(a->event_mask | b->event_mask));
}

cn_result cn_shape_set_event_mask(cn_world *world, cn_shape shape, uint32_t event_mask)
{
	cni_call call = cni_enter(world, __func__);
	cni_shape *s = cni_check_shape(&call, "shape", shape);
	int32_t index = cni_shape_index(world, shape), key;
	cni_check_flags(&call, "event_mask", event_mask, CNI_EVENT_MASK);
	cni_check_ends_of(&call, world, s != NULL ? s->body : CNI_NONE);
	if (call.result != CN_OK)
		return call.result;
	s->event_mask = (uint8_t)event_mask;
	for (key = cni_contact_first_of_shape(world, index); key != CNI_NONE; key = cni_contact_next_of_shape(world, key, index))
		contact_refresh_mask(world, key >> 1);
	return CN_OK;
}

CNI_DEFINE_GET(shape, event_mask, uint32_t, record->event_mask)

cn_result cn_shape_set_flags(cn_world *world, cn_shape shape, uint32_t flags)
{
	cni_call call = cni_enter(world, __func__);
	cni_shape *s = cni_check_shape(&call, "shape", shape);
	int32_t index = cni_shape_index(world, shape);
	cni_check_flags(&call, "flags", flags, CNI_SHAPE_FLAGS);
	cni_check_ends_of(&call, world, s != NULL ? s->body : CNI_NONE);
	if (call.result != CN_OK)
		return call.result;
	if (s->body != CNI_NONE)
		cni_contact_destroy_of_shape(world, index);
	s->flags = (uint8_t)flags;
	cni_shape_refilter(world, index);
	wake_met(world, index);
	return CN_OK;
}

CNI_DEFINE_GET(shape, flags, uint32_t, record->flags)

CNI_DEFINE_USER_DATA(shape, (void)0)
