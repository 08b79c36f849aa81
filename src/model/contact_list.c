/*
 * model/contact_list.c - contact records: the list of contacts apart, lookup, gap, invalidation.
 */
#include "model/world.h"

void cni_contact_enter_apart_list(cn_world *world, int32_t contact)
{
	cni_contact *c = cni_contact_at(world, contact);
	if ((c->flags & CNI_CONTACT_TOUCHING) || c->slot != CNI_NONE)
		return;
	c->slot = world->apart.count;
	((int32_t *)world->apart.data)[world->apart.count++] = contact;
}

void cni_contact_leave_apart_list(cn_world *world, int32_t contact)
{
	cni_contact *c = cni_contact_at(world, contact);
	int32_t *list = (int32_t *)world->apart.data;
	if ((c->flags & CNI_CONTACT_TOUCHING) || c->slot == CNI_NONE)
		return;
	int32_t last = list[--world->apart.count];
	list[c->slot] = last;
	cni_contact_at(world, last)->slot = c->slot;
	c->slot = CNI_NONE;
}

int32_t cni_contact_find(const cn_world *world, int32_t proxy_a, int32_t proxy_b)
{
	const cni_body *a = cni_body_at(world, cni_shape_at(world, cni_proxy_at(world, proxy_a)->shape)->body);
	const cni_body *b = cni_body_at(world, cni_shape_at(world, cni_proxy_at(world, proxy_b)->shape)->body);
	int32_t key = a->contact_count <= b->contact_count ? a->contact_first : b->contact_first;
	for (; key != CNI_NONE; key = cni_contact_of_key(world, key)->next[key & 1]) {
		const cni_contact *c = cni_contact_of_key(world, key);
		if ((c->proxy[0] == proxy_a && c->proxy[1] == proxy_b) || (c->proxy[0] == proxy_b && c->proxy[1] == proxy_a))
			return key >> 1;
	}
	return CNI_NONE;
}

cni_block_anchor *cni_contact_free_anchor(const cn_world *world, const cni_contact *c)
{
	if (!cni_contact_has_lane(c) || (cni_block_info_at(world, c->slot / CNI_LANES)->anchored >> c->slot % CNI_LANES & 1u))
		return NULL;
	return cni_block_anchor_at(world, c->slot / CNI_LANES);
}

float cni_contact_gap(const cn_world *world, const cni_contact *c)
{
	const cni_block_anchor *anchor = cni_contact_free_anchor(world, c);
	return anchor != NULL ? anchor->of.fresh.gap[c->slot % CNI_LANES] : 0.0f;
}

static int32_t contact_has_shape(const cn_world *world, const cni_contact *c, int32_t shape)
{
	return cni_proxy_at(world, c->proxy[0])->shape == shape || cni_proxy_at(world, c->proxy[1])->shape == shape;
}

/* First key from key on in the body's contact list whose contact has the shape. */
static int32_t contact_key_of_shape(const cn_world *world, int32_t key, int32_t shape)
{
	while (key != CNI_NONE && !contact_has_shape(world, cni_contact_of_key(world, key), shape))
		key = cni_contact_of_key(world, key)->next[key & 1];
	return key;
}

int32_t cni_contact_first_of_shape(const cn_world *world, int32_t shape)
{
	const cni_shape *s = cni_shape_at(world, shape);
	return s->body == CNI_NONE ? CNI_NONE : contact_key_of_shape(world, cni_body_at(world, s->body)->contact_first, shape);
}

int32_t cni_contact_next_of_shape(const cn_world *world, int32_t key, int32_t shape)
{
	return contact_key_of_shape(world, cni_contact_of_key(world, key)->next[key & 1], shape);
}

void cni_contact_mark_sums(cn_world *world, const cni_contact *c)
{
	const uint32_t kinds = (1u << CN_EVENT_STAY | 1u << CN_EVENT_HIT) << CNI_CONTACT_EVENTS_SHIFT;
	if (CNI_HAS_EVENTS && (c->flags & kinds) && cni_contact_has_lane(c))
		cni_block_info_at(world, c->slot / CNI_LANES)->flags |= CNI_BLOCK_SUMS;
}

void cni_contact_invalidate(cn_world *world, int32_t contact)
{
	const cni_contact *c = cni_contact_at(world, contact);
	if (cni_contact_has_lane(c))
		cni_lane_invalidate(world, c->slot);
}

void cni_contacts_invalidate_body(cn_world *world, const cni_body *b)
{
	for (int32_t key = b->contact_first; key != CNI_NONE; key = cni_contact_of_key(world, key)->next[key & 1])
		cni_contact_invalidate(world, key >> 1);
}

void cni_contact_fix_body(cn_world *world, int32_t body)
{
	int32_t key = cni_body_at(world, body)->contact_first;
	for (; key != CNI_NONE; key = cni_contact_of_key(world, key)->next[key & 1])
		if (cni_contact_has_lane(cni_contact_of_key(world, key)))
			cni_lane_set_bodies(world, cni_contact_of_key(world, key));
}
