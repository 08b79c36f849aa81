/*
 * world/shape_create.c - public functions that create shapes, and that replace the geometry of a shape in place: check the
 * definition and the geometry, build the geometry record in the block allocator, attach the shape if the definition has a body.
 *
 * Creation takes the handle last. Until then the record is prepared in the slot that the next take returns, so that
 * a lack of memory in between costs no generation of the slot.
 *
 * After a replacement the handle, the body and all properties stay. A shape with one box keeps its contacts, which the next step
 * computes anew; those whose boxes no longer overlap end at once. The contacts of a chain end, as its edges are numbered anew.
 * Everything is checked and reserved first, so that a failure changes nothing.
 */
#include "world/error.h"

#include <string.h>

/* ------------------------------------------------------------------ geometry given */

/* Geometry that a user gives (cn_circle ... cn_chain). */
typedef struct shape_source {
	int32_t type;
	int32_t count;      /* points */
	const void *given; /* cn_circle, cn_capsule, ... */
} shape_source;

static shape_source source_make(int32_t type, int32_t count, const void *given)
{
	shape_source s = { type, count, given };
	return s;
}

static shape_source source_circle(cni_call *call, const cn_circle *circle)
{
	cni_check_pointer(call, "circle", circle);
	cni_check(call, CNI_HAS_CIRCLES, CN_ERROR_STATE, "this library was built without circles (CN_NO_CIRCLES)");
	if (call->result == CN_OK) {
		cni_check_finite2(call, "center_m", circle->center_m);
		cni_check_positive(call, "radius_m", circle->radius_m);
		cni_check_complaint(call, cni_check_circle(circle, call->world->settings.thickness_least), &circle->center_m, 1, 0);
	}
	return source_make(CN_SHAPE_CIRCLE, 1, circle);
}

static shape_source source_capsule(cni_call *call, const cn_capsule *capsule)
{
	cni_check_pointer(call, "capsule", capsule);
	if (call->result == CN_OK) {
		const cn_vec2 ends[2] = { capsule->a_m, capsule->b_m };
		cni_check_finite2(call, "a_m", capsule->a_m);
		cni_check_finite2(call, "b_m", capsule->b_m);
		cni_check_positive(call, "radius_m", capsule->radius_m);
		cni_check_complaint(call, cni_check_capsule(capsule, call->world->settings.thickness_least), ends, 2, 0);
	}
	return source_make(CN_SHAPE_CAPSULE, 2, capsule);
}

static shape_source source_edge(cni_call *call, const cn_edge *edge)
{
	cni_check_pointer(call, "edge", edge);
	if (call->result == CN_OK) {
		const cn_vec2 ends[2] = { edge->a_m, edge->b_m };
		cni_check_finite2(call, "a_m", edge->a_m);
		cni_check_finite2(call, "b_m", edge->b_m);
		cni_check_complaint(call, cni_check_edge(edge, call->world->settings.thickness_least), ends, 2, 0);
	}
	return source_make(CN_SHAPE_EDGE, 2, edge);
}

static shape_source source_polygon(cni_call *call, const cn_polygon *polygon)
{
	cni_check_pointer(call, "polygon", polygon);
	if (call->result != CN_OK)
		return source_make(CN_SHAPE_POLYGON, 0, polygon);
	cni_check_range_int(call, "count", polygon->count, 3, CN_POLYGON_MAX_VERTICES);
	cni_check_at_least(call, "radius_m", polygon->radius_m, 0.0f);
	for (int32_t k = 0; k < polygon->count && call->result == CN_OK; ++k)
		cni_check_finite2(call, "points_m", polygon->points_m[k]);
	if (call->result == CN_OK)
		cni_check_complaint(call, cni_check_polygon(polygon, call->world->settings.thickness_least), polygon->points_m, polygon->count, 1);
	return source_make(CN_SHAPE_POLYGON, polygon->count, polygon);
}

static shape_source source_chain(cni_call *call, const cn_chain *chain)
{
	cni_check_pointer(call, "chain", chain);
	cni_check(call, CNI_HAS_CHAINS, CN_ERROR_STATE, "this library was built without chains (CN_NO_CHAINS)");
	if (call->result != CN_OK)
		return source_make(CN_SHAPE_CHAIN, 0, chain);
	cni_check_flags(call, "loop", chain->loop, 1u);
	cni_check_range_int(call, "count", chain->count, chain->loop ? 3 : 2, 65535);
	cni_check_pointer(call, "points_m", chain->points_m);
	for (int32_t k = 0; k < chain->count && call->result == CN_OK; ++k)
		cni_check_finite2(call, "points_m", chain->points_m[k]);
	if (call->result == CN_OK)
		cni_check_complaint(call, cni_check_chain(chain, call->world->settings.thickness_least), chain->points_m, chain->count, (int32_t)chain->loop);
	return source_make(CN_SHAPE_CHAIN, chain->count, chain);
}

/* Writes the stored form into memory of cni_geometry_bytes. */
static void source_build(cni_geometry *out, const shape_source *from, cni_transform offset)
{
	switch (from->type) {
	case CN_SHAPE_CIRCLE: cni_geometry_circle(out, (const cn_circle *)from->given, offset); break;
	case CN_SHAPE_CAPSULE: cni_geometry_capsule(out, (const cn_capsule *)from->given, offset); break;
	case CN_SHAPE_EDGE: cni_geometry_edge(out, (const cn_edge *)from->given, offset); break;
	case CN_SHAPE_POLYGON: cni_geometry_polygon(out, (const cn_polygon *)from->given, offset); break;
	default: cni_geometry_chain(out, (const cn_chain *)from->given, offset); break;
	}
}

/* A piece for a geometry record; 0 when the call fails. */
static cni_ref piece_alloc(cni_call *call, cn_world *world, uint64_t bytes)
{
	cni_ref ref = cni_blocks_alloc(&world->blocks, bytes);
	cni_check(call, ref != 0, CN_ERROR_MEMORY, "no memory for the shape's geometry");
	return ref;
}

/* ------------------------------------------------------------------ creating */

void cn_shape_def_init(cn_shape_def *def)
{
	if (!cni_def_begin(def, sizeof *def))
		return;
	def->density_kgpm2 = 1.0f;
	def->material.static_friction = 0.6f;
	def->material.dynamic_friction = 0.6f;
	def->material.friction_mix = CN_MIX_GEOMETRIC;
	def->material.restitution_mix = CN_MIX_MAXIMUM;
	def->filter.category = 1;
	def->filter.mask = ~(uint64_t)0;
	def->event_mask = (1u << CN_EVENT_ENTER | 1u << CN_EVENT_LEAVE) & CNI_EVENT_MASK;
}

static void check_def(cni_call *call, const cn_shape_def *def)
{
	if (!cni_check_def(call, def, sizeof *def, "cn_shape_def_init"))
		return;
	if (def->body != 0)
		cni_check_body(call, "body", def->body);
	cni_check_position(call, "offset_m", def->offset_m);
	cni_check_angle(call, "angle_rad", def->angle_rad);
	cni_check_at_least(call, "density_kgpm2", def->density_kgpm2, 0.0f);
	cni_check_material(call, &def->material);
	cni_check_flags(call, "flags", def->flags, CNI_SHAPE_FLAGS);
	cni_check_flags(call, "event_mask", def->event_mask, CNI_EVENT_MASK);
}

static void record_fill(cni_call *call, cn_world *world, cni_shape *s, const cn_shape_def *def, const cni_geometry *g, cni_ref ref)
{
	memset(s, 0, sizeof *s);
	s->body = s->next = s->prev = CNI_NONE;
	s->type = (uint8_t)g->type;
	s->geometry = ref;
	if (!cni_is_chain(g->type))
		s->box.proxy = CNI_NONE;
	s->density = def->density_kgpm2;
	cni_check(call, cni_shape_store_material(world, s, &def->material), CN_ERROR_MEMORY, "no memory for the material's user_id");
	s->flags = (uint8_t)def->flags;
	s->category = def->filter.category;
	s->mask = def->filter.mask;
	s->group = def->filter.group;
	s->event_mask = (uint8_t)def->event_mask;
	s->user_data = def->user_data;
}

/* Links the prepared record to its body and creates its boxes. */
static void record_attach(cni_call *call, cn_world *world, int32_t shape, int32_t body)
{
	cni_shape_link(world, shape, body);
	if (!(cni_body_at(world, body)->flags & CN_BODY_ENABLED))
		return;
	cni_check_reserved(call, cni_shape_place(world, shape), "the shape's boxes");
	if (call->result != CN_OK)
		cni_shape_unlink(world, shape);
}

/* Builds the geometry piece and prepares the record in the next slot; 0 if the call failed. */
static cni_ref shape_prepare(cni_call *call, cn_world *world, const cn_shape_def *def, const shape_source *from)
{
	int32_t shape = cni_handles_peek(&world->shape_handles);
	cni_ref ref = piece_alloc(call, world, cni_shape_piece_bytes(world, from->type, from->count));
	cni_transform offset = { cni_sincos(def->angle_rad), def->offset_m };
	if (ref == 0)
		return 0;
	cni_geometry *g = (cni_geometry *)cni_blocks_at(&world->blocks, ref);
	source_build(g, from, offset);
	record_fill(call, world, cni_shape_at(world, shape), def, g, ref);
	cni_check_shape_mass(call, cni_geometry_mass(g, def->density_kgpm2));
	if (call->result == CN_OK && def->body != 0)
		record_attach(call, world, shape, cni_body_index(world, def->body));
	if (call->result == CN_OK)
		return ref;
	cni_shape_free_geometry(world, shape);
	return 0;
}

static cn_result shape_create(cni_call *call, cn_world *world, const cn_shape_def *def, shape_source from, cn_shape *out_shape)
{
	check_def(call, def);
	if (call->result == CN_OK)
		cni_check_reserved(call, cni_slots_reserve(world, &world->shape_handles, &world->shapes, 1), "shapes");
	if (call->result != CN_OK || shape_prepare(call, world, def, &from) == 0)
		return call->result;
	int32_t shape = cni_handles_take(&world->shape_handles);
	if (def->body != 0) {
		cni_body_shapes_changed(world, cni_body_index(world, def->body), shape);
		cni_shape_wake_grown(world, shape);
	}
	if (out_shape != NULL)
		*out_shape = cni_handles_of(&world->shape_handles, shape);
	return CN_OK;
}

/* ------------------------------------------------------------------ replacing the geometry */

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
static cni_shape *check_change(cni_call *call, cn_world *world, cn_shape shape, const shape_source *from)
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
	if (call->result != CN_OK || bytes == cni_shape_piece_bytes(world, s->type, cni_shape_geometry(&world->blocks, s)->count))
		return 0;
	return piece_alloc(call, world, bytes);
}

static cn_result single_change(cni_call *call, cn_world *world, cn_shape shape, shape_source from)
{
	small_geometry fresh;
	const cni_shape *s = check_change(call, world, shape, &from);
	int32_t index = cni_shape_index(world, shape), left;
	if (call->result != CN_OK)
		return call->result;
	source_build(&fresh.head, &from, cni_identity());
	cni_check_shape_mass(call, cni_geometry_mass(&fresh.head, s->density));
	cni_ref ref = piece_reserve(call, world, s, from.count);
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

static cn_result chain_change(cni_call *call, cn_world *world, cn_shape shape, shape_source from)
{
	const cni_shape *s = check_change(call, world, shape, &from);
	int32_t index = cni_shape_index(world, shape);
	if (call->result != CN_OK)
		return call->result;
	uint64_t bytes = cni_shape_piece_bytes(world, CN_SHAPE_CHAIN, from.count);
	cni_ref ref = piece_alloc(call, world, bytes);
	if (ref == 0)
		return call->result;
	source_build((cni_geometry *)cni_blocks_at(&world->blocks, ref), &from, cni_identity());
	cni_check_reserved(call, cni_shape_replace_chain(world, index, ref), "the shape's boxes");
	if (call->result != CN_OK) {
		cni_blocks_free(&world->blocks, ref, bytes);
	} else if (s->body != CNI_NONE) {
		cni_body_wake(world, s->body);
		body_update(world, index, 1); /* a chain has no mass */
	}
	return call->result;
}

/* ------------------------------------------------------------------ by type */

/* Defines cn_shape_create_<name> and cn_shape_set_<name>. */
#define DEFINE_TYPE(name, source, change) \
	cn_result cn_shape_create_##name(cn_world *world, const cn_shape_def *def, const cn_##name *name, cn_shape *out_shape) \
	{ \
		cni_call call = cni_enter(world, __func__); \
		return shape_create(&call, world, def, source(&call, name), out_shape); \
	} \
	cn_result cn_shape_set_##name(cn_world *world, cn_shape shape, const cn_##name *name) \
	{ \
		cni_call call = cni_enter(world, __func__); \
		return change(&call, world, shape, source(&call, name)); \
	}

DEFINE_TYPE(circle, source_circle, single_change)
DEFINE_TYPE(capsule, source_capsule, single_change)
DEFINE_TYPE(edge, source_edge, single_change)
DEFINE_TYPE(polygon, source_polygon, single_change)
DEFINE_TYPE(chain, source_chain, chain_change)

cn_result cn_shape_create_box(cn_world *world, const cn_shape_def *def, float half_width_m, float half_height_m, float radius_m, cn_shape *out_shape)
{
	cni_call call = cni_enter(world, __func__);
	cn_polygon box;
	cni_check_positive(&call, "half_width_m", half_width_m);
	cni_check_positive(&call, "half_height_m", half_height_m);
	cni_check_at_least(&call, "radius_m", radius_m, 0.0f);
	if (call.result != CN_OK)
		return call.result;
	memset(&box, 0, sizeof box);
	box.count = 4;
	box.radius_m = radius_m;
	box.points_m[0] = cni_v(-half_width_m, -half_height_m);
	box.points_m[1] = cni_v(half_width_m, -half_height_m);
	box.points_m[2] = cni_v(half_width_m, half_height_m);
	box.points_m[3] = cni_v(-half_width_m, half_height_m);
	return shape_create(&call, world, def, source_polygon(&call, &box), out_shape);
}
