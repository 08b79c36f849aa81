/*
 * model/area.c - the list of areas (layout in area.h), and waking of bodies in them: those that one begins or ceases to act on, and those
 * in areas that move.
 */
#include "model/world.h"

cni_area *cni_area_of_shape(const cn_world *world, int32_t shape)
{
	for (int32_t k = 0; k < world->areas.count; ++k)
		if (cni_areas(world)[k].shape == shape)
			return cni_areas(world) + k;
	return NULL;
}

void cni_area_remove(cn_world *world, int32_t shape)
{
	int32_t kept = 0;
	for (int32_t k = 0; k < world->areas.count; ++k)
		if (cni_areas(world)[k].shape != shape)
			cni_areas(world)[kept++] = cni_areas(world)[k];
	world->areas.count = kept;
}

int32_t cni_area_set(cn_world *world, const cni_area *area)
{
	int32_t k;
	if (!cni_array_reserve(&world->areas, &world->memory, world->areas.count + 1))
		return 0;
	cni_area_remove(world, area->shape);
	for (k = world->areas.count; k > 0; --k) {
		const cni_area *before = cni_areas(world) + k - 1;
		if (cni_area_is_before(before, area))
			break;
		cni_areas(world)[k] = *before;
	}
	cni_areas(world)[k] = *area;
	++world->areas.count;
	return 1;
}

void cni_area_wake(cn_world *world, int32_t shape)
{
	for (int32_t key = cni_contact_first_of_shape(world, shape); key != CNI_NONE; key = cni_contact_next_of_shape(world, key, shape)) {
		const cni_contact *c = cni_contact_of_key(world, key);
		if (c->flags & CNI_CONTACT_SENSING)
			cni_body_wake(world, c->body[1 - (key & 1)]);
	}
}

void cni_areas_wake_moving(cn_world *world)
{
	for (int32_t k = 0; k < world->areas.count; ++k) {
		int32_t shape = cni_areas(world)[k].shape, body = cni_shape_at(world, shape)->body;
		if (body == CNI_NONE || cni_body_at(world, body)->awake == 0)
			continue;
		cn_velocity v = cni_body_velocity(world, cni_body_at(world, body));
		if (v.linear_mps.x != 0.0f || v.linear_mps.y != 0.0f || v.angular_radps != 0.0f)
			cni_area_wake(world, shape);
	}
}

void cni_area_visited(cn_world *world, int32_t contact)
{
	const cni_contact *c = cni_contact_at(world, contact);
	for (int32_t side = 0; side < 2; ++side)
		if (cni_area_of_shape(world, cni_proxy_at(world, c->proxy[side])->shape) != NULL)
			cni_body_wake(world, c->body[1 - side]);
}
