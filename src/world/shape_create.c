/*
 * world/shape_create.c - public functions that create shapes: check the definition and the geometry, build
 * the geometry record in the block allocator, and attach the shape if the definition has a body.
 *
 * The handle is taken last. Until then the record is prepared in the slot that the next take returns, so that
 * a lack of memory in between costs no generation of the slot.
 */
#include "world/shape_source.h"

#include <string.h>

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
static cni_ref shape_prepare(cni_call *call, cn_world *world, const cn_shape_def *def, const cni_shape_source *from)
{
	int32_t shape = cni_handles_peek(&world->shape_handles);
	uint64_t bytes = cni_shape_piece_bytes(world, from->type, from->count);
	cni_ref ref = cni_blocks_alloc(&world->blocks, bytes);
	cni_transform offset = { cni_sincos(def->angle_rad), def->offset_m };
	cni_geometry *g;
	if (ref == 0) {
		cni_refuse(call, CN_ERROR_MEMORY, "no memory for the shape's geometry");
		return 0;
	}
	g = (cni_geometry *)cni_blocks_at(&world->blocks, ref);
	cni_source_build(g, from, offset);
	record_fill(call, world, cni_shape_at(world, shape), def, g, ref);
	cni_check_shape_mass(call, cni_geometry_mass(g, def->density_kgpm2));
	if (call->result == CN_OK && def->body != 0)
		record_attach(call, world, shape, cni_body_index(world, def->body));
	if (call->result == CN_OK)
		return ref;
	cni_shape_free_geometry(world, shape);
	return 0;
}

static cn_result shape_create(cni_call *call, cn_world *world, const cn_shape_def *def, cni_shape_source from, cn_shape *out_shape)
{
	int32_t shape;
	check_def(call, def);
	if (call->result == CN_OK)
		cni_check_reserved(call, cni_slots_reserve(world, &world->shape_handles, &world->shapes, 1), "shapes");
	if (call->result != CN_OK || shape_prepare(call, world, def, &from) == 0)
		return call->result;
	shape = cni_handles_take(&world->shape_handles);
	if (def->body != 0) {
		cni_body_shapes_changed(world, cni_body_index(world, def->body), shape);
		cni_shape_wake_grown(world, shape);
	}
	if (out_shape != NULL)
		*out_shape = cni_handles_of(&world->shape_handles, shape);
	return CN_OK;
}

/* ------------------------------------------------------------------ one function per type */

/* Defines cn_shape_create_<name>. */
#define DEFINE_CREATE(name) \
	cn_result cn_shape_create_##name(cn_world *world, const cn_shape_def *def, const cn_##name *name, cn_shape *out_shape) \
	{ \
		cni_call call = cni_enter(world, __func__); \
		return shape_create(&call, world, def, cni_source_##name(&call, world, name), out_shape); \
	}

DEFINE_CREATE(circle)
DEFINE_CREATE(capsule)
DEFINE_CREATE(edge)
DEFINE_CREATE(polygon)
DEFINE_CREATE(chain)

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
	return shape_create(&call, world, def, cni_source_polygon(&call, world, &box), out_shape);
}
