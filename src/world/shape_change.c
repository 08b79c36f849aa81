/*
 * world/shape_change.c - public functions that replace the geometry of a shape in place: the handle, the body and all properties stay.
 *
 * A shape with one box keeps its contacts, which the next step computes anew; those whose boxes no longer overlap end at once. The
 * contacts of a chain end, as its edges are numbered anew. Everything is checked and reserved first, so that a failure changes nothing.
 */
#include "world/shape_source.h"

#include <string.h>

/* The stored form of any shape but a chain. */
typedef union small_geometry {
	cni_geometry head;
	uint8_t bytes[sizeof(cni_geometry) + 2u * CN_POLYGON_MAX_VERTICES * sizeof(cni_vec2)];
} small_geometry;

static void wake_all(cn_world *world, int32_t shape)
{
	int32_t body = cni_shape_at(world, shape)->body, key = cni_contact_first_of_shape(world, shape);
	for (; key != CNI_NONE; key = cni_contact_next_of_shape(world, key, shape))
		if (cni_contact_of_key(world, key)->flags & CNI_CONTACT_TOUCHING)
			cni_body_wake(world, cni_contact_of_key(world, key)->body[1 - (key & 1)]);
	cni_body_wake(world, body);
}

/* After the new geometry is in place: mass, waking. left: see cni_body_shape_replaced. */
static void body_update(cn_world *world, int32_t shape, int32_t left)
{
	int32_t body = cni_shape_at(world, shape)->body;
	cni_body_shape_replaced(world, body, shape, left);
	cni_shape_wake_met(world, shape);
	cni_body_at(world, body)->flags |= CNI_BODY_AGAIN;
	world->pairs_may_repeat |= CNI_PAIRS_MARKED;
}

/* Contacts whose boxes no longer overlap end, the others are computed anew. Requires cni_contact_reserve_end. */
static void contacts_update(cn_world *world, int32_t shape)
{
	int32_t key = cni_contact_first_of_shape(world, shape);
	while (key != CNI_NONE) {
		cni_contact *c = cni_contact_of_key(world, key);
		int32_t contact = key >> 1, proxy = c->proxy[key & 1];
		key = cni_contact_next_of_shape(world, key, shape);
		memset(&c->cache, 0, sizeof c->cache);
		cni_contact_invalidate(world, contact);
		if (cni_aabb_overlap(&cni_proxy_at(world, c->proxy[0])->fat, &cni_proxy_at(world, c->proxy[1])->fat))
			continue;
		cni_contact_destroy(world, contact);
		world->broadphase_ops->touch(world->broadphase, proxy);
	}
}

/* The shape, or NULL when the call has failed. */
static cni_shape *check_change(cni_call *call, cn_world *world, cn_shape shape, const cni_shape_source *from)
{
	cni_shape *s = cni_check_shape(call, "shape", shape);
	cni_check(call, s == NULL || s->type == from->type, CN_ERROR_STATE, "the shape is of another type");
	cni_check_ends_of(call, world, s != NULL ? s->body : CNI_NONE);
	return s;
}

/* A new piece where its size differs; else 0, and the old piece takes the new form. */
static cni_ref piece_reserve(cni_call *call, cn_world *world, const cni_shape *s, int32_t count)
{
	uint64_t bytes = cni_shape_piece_bytes(world, s->type, count);
	cni_ref ref = 0;
	if (call->result != CN_OK || bytes == cni_shape_piece_bytes(world, s->type, cni_shape_geometry(&world->blocks, s)->count))
		return 0;
	ref = cni_blocks_alloc(&world->blocks, bytes);
	if (ref == 0)
		cni_refuse(call, CN_ERROR_MEMORY, "no memory for the shape's geometry");
	return ref;
}

static cn_result single_change(cni_call *call, cn_world *world, cn_shape shape, cni_shape_source from)
{
	small_geometry fresh;
	const cni_shape *s = check_change(call, world, shape, &from);
	int32_t index = cni_shape_index(world, shape), left;
	cni_ref ref;
	if (call->result != CN_OK)
		return call->result;
	cni_source_build(&fresh.head, &from, cni_identity());
	cni_check_shape_mass(call, cni_geometry_mass(&fresh.head, s->density));
	ref = piece_reserve(call, world, s, from.count);
	if (call->result != CN_OK)
		return call->result;
	if (s->body != CNI_NONE)
		wake_all(world, index);
	left = s->body != CNI_NONE && cni_body_shape_leaves(world, s->body, index);
	cni_shape_set_piece(world, index, ref, &fresh.head);
	if (s->body == CNI_NONE)
		return CN_OK;
	contacts_update(world, index);
	body_update(world, index, left);
	return CN_OK;
}

static cn_result chain_change(cni_call *call, cn_world *world, cn_shape shape, cni_shape_source from)
{
	const cni_shape *s = check_change(call, world, shape, &from);
	int32_t index = cni_shape_index(world, shape);
	uint64_t bytes;
	cni_ref ref;
	if (call->result != CN_OK)
		return call->result;
	bytes = cni_shape_piece_bytes(world, CN_SHAPE_CHAIN, from.count);
	ref = cni_blocks_alloc(&world->blocks, bytes);
	if (ref == 0)
		return cni_refuse(call, CN_ERROR_MEMORY, "no memory for the shape's geometry");
	cni_source_build((cni_geometry *)cni_blocks_at(&world->blocks, ref), &from, cni_identity());
	cni_check_reserved(call, cni_shape_replace_chain(world, index, ref), "the shape's boxes");
	if (call->result != CN_OK) {
		cni_blocks_free(&world->blocks, ref, bytes);
	} else if (s->body != CNI_NONE) {
		cni_body_wake(world, s->body);
		body_update(world, index, 1); /* a chain has no mass */
	}
	return call->result;
}

/* Defines cn_shape_set_<name>. */
#define DEFINE_CHANGE(name, change) \
	cn_result cn_shape_set_##name(cn_world *world, cn_shape shape, const cn_##name *name) \
	{ \
		cni_call call = cni_enter(world, __func__); \
		return change(&call, world, shape, cni_source_##name(&call, world, name)); \
	}

DEFINE_CHANGE(circle, single_change)
DEFINE_CHANGE(capsule, single_change)
DEFINE_CHANGE(edge, single_change)
DEFINE_CHANGE(polygon, single_change)
DEFINE_CHANGE(chain, chain_change)
