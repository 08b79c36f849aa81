/*
 * model/shape.c - shape records: lists, boxes in the broadphase, filters (layout in shape.h).
 *
 * Invariant: an attached shape of an enabled body has one proxy for each child, all other shapes have none.
 */
#include "model/world.h"

#include <string.h>

uint64_t cni_shape_ids_bytes(const cn_world *world, int32_t children)
{
	uint64_t bytes = (uint64_t)children * sizeof(int32_t);
	if (!world->memory.fixed)
		return bytes;
	if (bytes <= CNI_SHAPE_IDS_BYTES)
		return CNI_SHAPE_IDS_BYTES;
	return cni_shape_piece_bytes(world, CN_SHAPE_CHAIN, 0) > bytes ? cni_shape_piece_bytes(world, CN_SHAPE_CHAIN, 0) : bytes;
}

void cni_shape_free_geometry(cn_world *world, int32_t shape)
{
	const cni_shape *s = cni_shape_at(world, shape);
	cni_blocks_free(&world->blocks, s->geometry, cni_shape_piece_bytes(world, s->type, cni_shape_geometry(&world->blocks, s)->count));
	if (s->extra != 0)
		cni_blocks_free(&world->blocks, s->extra, sizeof(cni_shape_extra));
	if (cni_has_areas(world))
		cni_area_remove(world, shape);
}

static int32_t shape_is_placed(const cni_shape *s)
{
	return cni_is_chain(s->type) ? s->box.proxies != 0 : s->box.proxy != CNI_NONE;
}

static int32_t proxy_take(cn_world *world)
{
	int32_t id = world->proxy_free;
	if (id != CNI_NONE) {
		world->proxy_free = cni_proxy_at(world, id)->shape;
		--world->proxy_free_count;
	} else {
		id = world->proxy_used++;
	}
	++world->proxy_count;
	return id;
}

static void proxy_release(cn_world *world, int32_t id)
{
	cni_proxy *p = cni_proxy_at(world, id);
	p->flags = 0;
	p->shape = world->proxy_free;
	world->proxy_free = id;
	++world->proxy_free_count;
	--world->proxy_count;
}

static int32_t proxy_create(cn_world *world, int32_t shape, int32_t child)
{
	const cni_shape *s = cni_shape_at(world, shape);
	const cni_body *b = cni_body_at(world, s->body);
	int32_t id = proxy_take(world);
	cni_proxy *p = cni_proxy_at(world, id);
	p->fat = cni_geometry_aabb(cni_shape_geometry(&world->blocks, s), child, cni_body_transform(b));
	p->fat = cni_box_fatten(p->fat, cni_box_margin(world, b->type, &p->fat));
	p->shape = shape;
	p->geometry = s->geometry;
	p->flags = (uint32_t)child << CNI_PROXY_CHILD_SHIFT | CNI_PROXY_ALIVE | (b->type == CN_BODY_STATIC ? (uint32_t)CNI_PROXY_STATIC : 0u);
	world->broadphase_ops->add(world->broadphase, id);
	if (b->type != CN_BODY_DYNAMIC)
		cni_seams_change(world, &p->fat);
	return id;
}

/* Places a chain; ids is the piece of its proxy ids. Memory for the proxies must be reserved. */
static void edges_place(cn_world *world, int32_t shape, cni_ref ids)
{
	cni_shape *s = cni_shape_at(world, shape);
	int32_t count = cni_shape_children(&world->blocks, s);
	s->box.proxies = ids;
	for (int32_t child = 0; child < count; ++child)
		((int32_t *)cni_blocks_at(&world->blocks, ids))[child] = proxy_create(world, shape, child);
}

cn_result cni_shape_place(cn_world *world, int32_t shape)
{
	cni_shape *s = cni_shape_at(world, shape);
	cni_ref ids = 0;
	if (shape_is_placed(s))
		return CN_OK;
	if (cni_proxy_reserve(world, cni_shape_children(&world->blocks, s)) != CN_OK)
		return CN_ERROR_MEMORY;
	if (cni_is_chain(s->type) && (ids = cni_blocks_alloc(&world->blocks, cni_shape_ids_bytes(world, cni_shape_children(&world->blocks, s)))) == 0)
		return CN_ERROR_MEMORY;
	cni_body_forget_room(cni_body_at(world, s->body));
	if (ids != 0) {
		edges_place(world, shape, ids);
		return CN_OK;
	}
	s->box.proxy = proxy_create(world, shape, 0);
	if (cni_body_at(world, s->body)->awake != 0)
		cni_body_kick(world, s->body);
	return CN_OK;
}

void cni_shape_unplace(cn_world *world, int32_t shape)
{
	cni_shape *s = cni_shape_at(world, shape);
	if (!shape_is_placed(s))
		return;
	cni_contact_destroy_of_shape(world, shape);
	for (int32_t child = 0; child < cni_shape_children(&world->blocks, s); ++child) {
		int32_t proxy = cni_shape_proxy(world, s, child);
		if (!cni_is_dynamic(world, s->body))
			cni_seams_change(world, &cni_proxy_at(world, proxy)->fat);
		world->broadphase_ops->remove(world->broadphase, proxy);
		proxy_release(world, proxy);
	}
	if (cni_is_chain(s->type)) {
		cni_blocks_free(&world->blocks, s->box.proxies, cni_shape_ids_bytes(world, cni_shape_children(&world->blocks, s)));
		s->box.proxies = 0;
	} else {
		s->box.proxy = CNI_NONE;
	}
}

/* The box of a shape whose geometry has changed. */
static void box_refit(cn_world *world, int32_t shape)
{
	const cni_shape *s = cni_shape_at(world, shape);
	cni_body *b = cni_body_at(world, s->body);
	cni_proxy *p = cni_proxy_at(world, s->box.proxy);
	cni_aabb tight = cni_geometry_aabb(cni_shape_geometry(&world->blocks, s), 0, cni_body_transform(b));
	cni_aabb fat = cni_box_fatten(tight, cni_box_margin(world, b->type, &tight));
	if (b->type != CN_BODY_DYNAMIC) {
		cni_seams_change(world, &p->fat);
		cni_seams_change(world, &fat);
	}
	p->geometry = s->geometry;
	cni_proxy_set_fat(p, &fat);
	world->broadphase_ops->move(world->broadphase, s->box.proxy);
	cni_body_forget_room(b);
	if (b->awake != 0)
		cni_body_kick(world, s->body);
}

void cni_shape_set_piece(cn_world *world, int32_t shape, cni_ref piece, const cni_geometry *g)
{
	cni_shape *s = cni_shape_at(world, shape);
	if (piece != 0) {
		cni_blocks_free(&world->blocks, s->geometry, cni_shape_piece_bytes(world, s->type, cni_shape_geometry(&world->blocks, s)->count));
		s->geometry = piece;
	}
	memcpy(cni_blocks_at(&world->blocks, s->geometry), g, (size_t)cni_geometry_bytes(g->type, g->count));
	if (shape_is_placed(s))
		box_refit(world, shape);
}

cn_result cni_shape_replace_chain(cn_world *world, int32_t shape, cni_ref piece)
{
	cni_shape *s = cni_shape_at(world, shape);
	const cni_geometry *old = cni_shape_geometry(&world->blocks, s);
	int32_t children = cni_geometry_children((const cni_geometry *)cni_blocks_at(&world->blocks, piece)), placed = shape_is_placed(s);
	uint64_t bytes = cni_shape_piece_bytes(world, CN_SHAPE_CHAIN, old->count);
	cni_ref ids = 0;
	if (placed) {
		if (cni_proxy_reserve(world, children) != CN_OK)
			return CN_ERROR_MEMORY;
		ids = cni_blocks_alloc(&world->blocks, cni_shape_ids_bytes(world, children));
		if (ids == 0)
			return CN_ERROR_MEMORY;
		cni_shape_unplace(world, shape);
	}
	cni_blocks_free(&world->blocks, s->geometry, bytes);
	s->geometry = piece;
	if (placed) {
		cni_body_forget_room(cni_body_at(world, s->body));
		edges_place(world, shape, ids);
	}
	return CN_OK;
}

void cni_shape_refilter(cn_world *world, int32_t shape)
{
	cni_shape *s = cni_shape_at(world, shape);
	if (!shape_is_placed(s))
		return;
	for (int32_t child = 0; child < cni_shape_children(&world->blocks, s); ++child) {
		cni_proxy *p = cni_proxy_at(world, cni_shape_proxy(world, s, child));
		uint32_t is_static = cni_body_at(world, s->body)->type == CN_BODY_STATIC ? (uint32_t)CNI_PROXY_STATIC : 0u;
		if (!cni_is_dynamic(world, s->body) || (p->flags & CNI_PROXY_STATIC) || cni_shape_geometry(&world->blocks, s)->seams != 0)
			cni_seams_change(world, &p->fat);
		p->flags = (p->flags & ~(uint32_t)CNI_PROXY_STATIC) | is_static;
		world->broadphase_ops->touch(world->broadphase, cni_shape_proxy(world, s, child));
	}
	cni_body_at(world, s->body)->flags |= CNI_BODY_AGAIN;
	world->pairs_may_repeat |= CNI_PAIRS_MARKED;
}

void cni_shape_link(cn_world *world, int32_t shape, int32_t body)
{
	cni_shape *s = cni_shape_at(world, shape);
	cni_body *b = cni_body_at(world, body);
	s->body = body;
	s->next = CNI_NONE;
	if (b->shape_first == CNI_NONE) {
		b->shape_first = s->prev = shape;
	} else {
		cni_shape *first = cni_shape_at(world, b->shape_first);
		s->prev = first->prev;
		cni_shape_at(world, first->prev)->next = shape;
		first->prev = shape;
	}
}

void cni_shape_unlink(cn_world *world, int32_t shape)
{
	cni_shape *s = cni_shape_at(world, shape);
	cni_body *b = cni_body_at(world, s->body);
	int32_t next = s->next;
	if (b->shape_first == shape)
		b->shape_first = next;
	else
		cni_shape_at(world, s->prev)->next = next;
	if (next != CNI_NONE)
		cni_shape_at(world, next)->prev = s->prev;
	else if (b->shape_first != CNI_NONE)
		cni_shape_at(world, b->shape_first)->prev = s->prev;
	s->body = s->next = s->prev = CNI_NONE;
}
