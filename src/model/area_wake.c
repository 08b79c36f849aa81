/*
 * model/area_wake.c - waking of bodies in areas: those that one begins or ceases to act on, and those in areas that move.
 */
#include "model/world.h"

void cni_area_wake(cn_world *world, int32_t shape)
{
	int32_t key;
	for (key = cni_contact_first_of_shape(world, shape); key != CNI_NONE; key = cni_contact_next_of_shape(world, key, shape)) {
		const cni_contact *c = cni_contact_of_key(world, key);
		if (c->flags & CNI_CONTACT_SENSING)
			cni_body_wake(world, c->body[1 - (key & 1)]);
	}
}

void cni_areas_wake_moving(cn_world *world)
{
	int32_t k;
	for (k = 0; k < world->areas.count; ++k) {
		int32_t shape = cni_areas(world)[k].shape, body = cni_shape_at(world, shape)->body;
		cn_velocity v;
		if (body == CNI_NONE || cni_body_at(world, body)->awake == 0)
			continue;
		v = cni_body_velocity(world, cni_body_at(world, body));
		if (v.linear_mps.x != 0.0f || v.linear_mps.y != 0.0f || v.angular_radps != 0.0f)
			cni_area_wake(world, shape);
	}
}

void cni_area_visited(cn_world *world, int32_t contact)
{
	const cni_contact *c = cni_contact_at(world, contact);
	int32_t side;
	for (side = 0; side < 2; ++side)
		if (cni_area_of_shape(world, cni_proxy_at(world, c->proxy[side])->shape) != NULL)
			cni_body_wake(world, c->body[1 - side]);
}
