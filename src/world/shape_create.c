/*
 * world/shape_create.c - public functions that create shapes: check the definition and the geometry, build
 * the geometry record in the block allocator, and attach the shape if the definition has a body.
 *
 * The handle is taken last. Until then the record is prepared in the slot that the next take returns, so that
 * a lack of memory in between costs no generation of the slot.
 */
#include "world/error.h"

#include <string.h>

#define EVENT_MASK ((1u << CN_EVENT_KINDS) - 1u)

void cn_shape_def_init(cn_shape_def *def)
{
	if (def == NULL)
		return;
	memset(def, 0, sizeof *def);
	def->struct_size = (uint32_t)sizeof *def;
	def->density_kgpm2 = 1.0f;
	def->material.static_friction = 0.6f;
	def->material.dynamic_friction = 0.6f;
	def->material.friction_mix = CN_MIX_GEOMETRIC;
	def->material.restitution_mix = CN_MIX_MAXIMUM;
	def->filter.category = 1;
	def->filter.mask = ~(uint64_t)0;
	def->event_mask = 1u << CN_EVENT_ENTER | 1u << CN_EVENT_LEAVE;
}

/* Public geometry of a shape, before its record exists. */
typedef struct source {
	int32_t type;
	int32_t count;      /* points */
	const void *public; /* cn_circle, cn_capsule, ... */
} source;

static source source_make(int32_t type, int32_t count, const void *public)
{
	source s;
	s.type = type;
	s.count = count;
	s.public = public;
	return s;
}

static void geometry_build(cni_geometry *out, const source *from, cni_transform offset)
{
	switch (from->type) {
	case CN_SHAPE_CIRCLE: cni_geometry_circle(out, (const cn_circle *)from->public, offset); break;
	case CN_SHAPE_CAPSULE: cni_geometry_capsule(out, (const cn_capsule *)from->public, offset); break;
	case CN_SHAPE_EDGE: cni_geometry_edge(out, (const cn_edge *)from->public, offset); break;
	case CN_SHAPE_POLYGON: cni_geometry_polygon(out, (const cn_polygon *)from->public, offset); break;
	default: cni_geometry_chain(out, (const cn_chain *)from->public, offset); break;
	}
}

static void check_def(cni_call *call, const cn_shape_def *def)
{
	cni_check_pointer(call, "def", def);
	if (call->result != CN_OK)
		return;
	cni_check_struct_size(call, def->struct_size, sizeof *def, "cn_shape_def_init");
	if (call->result != CN_OK)
		return;
	if (def->body != 0)
		cni_check_body(call, "body", def->body);
	cni_check_position(call, "offset_m", def->offset_m);
	cni_check_angle(call, "angle_rad", def->angle_rad);
	cni_check_at_least(call, "density_kgpm2", def->density_kgpm2, 0.0f);
	cni_check_material(call, &def->material);
	cni_check_flags(call, "flags", def->flags, CNI_SHAPE_FLAGS);
	cni_check_flags(call, "event_mask", def->event_mask, EVENT_MASK);
}

static void record_fill(cni_call *call, cn_world *world, cni_shape *s, const cn_shape_def *def, const cni_geometry *g, cni_ref ref)
{
	memset(s, 0, sizeof *s);
	s->body = s->next = s->prev = CNI_NONE;
	s->type = (uint8_t)g->type;
	s->geometry = ref;
	if (g->type != CN_SHAPE_CHAIN)
		s->box.proxy = CNI_NONE;
	s->density = def->density_kgpm2;
	if (!cni_shape_store_material(world, s, &def->material))
		cni_refuse(call, CN_ERROR_MEMORY, "no memory for the material's user_id");
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
static cni_ref shape_prepare(cni_call *call, cn_world *world, const cn_shape_def *def, const source *from)
{
	int32_t shape = cni_handles_peek(&world->shape_handles);
	uint64_t bytes = cni_shape_piece_bytes(world, from->type, from->count);
	cni_ref ref = cni_blocks_alloc(&world->blocks, bytes);
	cni_geometry *g;
	cni_transform offset;
	if (ref == 0) {
		cni_refuse(call, CN_ERROR_MEMORY, "no memory for the shape's geometry");
		return 0;
	}
	offset.q = cni_sincos(def->angle_rad);
	offset.t = def->offset_m;
	g = (cni_geometry *)cni_blocks_at(&world->blocks, ref);
	geometry_build(g, from, offset);
	record_fill(call, world, cni_shape_at(world, shape), def, g, ref);
	cni_check_shape_mass(call, cni_geometry_mass(g, def->density_kgpm2));
	if (call->result == CN_OK && def->body != 0)
		record_attach(call, world, shape, cni_body_index(world, def->body));
	if (call->result == CN_OK)
		return ref;
	cni_shape_free_geometry(world, shape);
	return 0;
}

static cn_result shape_create(cni_call *call, cn_world *world, const cn_shape_def *def, source from, cn_shape *out_shape)
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
		cni_body_wake_grown(world, cni_body_index(world, def->body));
	}
	if (out_shape != NULL)
		*out_shape = cni_handles_of(&world->shape_handles, shape);
	return CN_OK;
}

/* Records the complaint of a geometry check, NULL for none. */
static void check_geometry(cni_call *call, const char *complaint, const cn_vec2 *points, int32_t count, int32_t closed)
{
	if (complaint == cni_points_near)
		cni_refuse_near(call, points, count, closed);
	else if (complaint != NULL)
		cni_refuse(call, CN_ERROR_ARGUMENT, complaint);
}

/* ------------------------------------------------------------------ one function per type */

cn_result cn_shape_create_circle(cn_world *world, const cn_shape_def *def, const cn_circle *circle, cn_shape *out_shape)
{
	cni_call call = cni_enter(world, __func__);
	cni_check_pointer(&call, "circle", circle);
	if (call.result != CN_OK)
		return call.result;
	cni_check_finite2(&call, "center_m", circle->center_m);
	cni_check_positive(&call, "radius_m", circle->radius_m);
	check_geometry(&call, cni_check_circle(circle, world->settings.thickness_least), &circle->center_m, 1, 0);
	return shape_create(&call, world, def, source_make(CN_SHAPE_CIRCLE, 1, circle), out_shape);
}

cn_result cn_shape_create_capsule(cn_world *world, const cn_shape_def *def, const cn_capsule *capsule, cn_shape *out_shape)
{
	cni_call call = cni_enter(world, __func__);
	cn_vec2 ends[2];
	cni_check_pointer(&call, "capsule", capsule);
	if (call.result != CN_OK)
		return call.result;
	cni_check_finite2(&call, "a_m", capsule->a_m);
	cni_check_finite2(&call, "b_m", capsule->b_m);
	cni_check_positive(&call, "radius_m", capsule->radius_m);
	ends[0] = capsule->a_m;
	ends[1] = capsule->b_m;
	check_geometry(&call, cni_check_capsule(capsule, world->settings.thickness_least), ends, 2, 0);
	return shape_create(&call, world, def, source_make(CN_SHAPE_CAPSULE, 2, capsule), out_shape);
}

cn_result cn_shape_create_edge(cn_world *world, const cn_shape_def *def, const cn_edge *edge, cn_shape *out_shape)
{
	cni_call call = cni_enter(world, __func__);
	cn_vec2 ends[2];
	cni_check_pointer(&call, "edge", edge);
	if (call.result != CN_OK)
		return call.result;
	cni_check_finite2(&call, "a_m", edge->a_m);
	cni_check_finite2(&call, "b_m", edge->b_m);
	ends[0] = edge->a_m;
	ends[1] = edge->b_m;
	check_geometry(&call, cni_check_edge(edge, world->settings.thickness_least), ends, 2, 0);
	return shape_create(&call, world, def, source_make(CN_SHAPE_EDGE, 2, edge), out_shape);
}

static cn_result polygon_create(cni_call *call, cn_world *world, const cn_shape_def *def, const cn_polygon *polygon, cn_shape *out_shape)
{
	int32_t k;
	cni_check_range_int(call, "count", polygon->count, 3, CN_POLYGON_MAX_VERTICES);
	cni_check_at_least(call, "radius_m", polygon->radius_m, 0.0f);
	for (k = 0; k < polygon->count && call->result == CN_OK; ++k)
		cni_check_finite2(call, "points_m", polygon->points_m[k]);
	if (call->result == CN_OK)
		check_geometry(call, cni_check_polygon(polygon, world->settings.thickness_least), polygon->points_m, polygon->count, 1);
	return shape_create(call, world, def, source_make(CN_SHAPE_POLYGON, polygon->count, polygon), out_shape);
}

cn_result cn_shape_create_polygon(cn_world *world, const cn_shape_def *def, const cn_polygon *polygon, cn_shape *out_shape)
{
	cni_call call = cni_enter(world, __func__);
	cni_check_pointer(&call, "polygon", polygon);
	if (call.result != CN_OK)
		return call.result;
	return polygon_create(&call, world, def, polygon, out_shape);
}

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
	return polygon_create(&call, world, def, &box, out_shape);
}

cn_result cn_shape_create_chain(cn_world *world, const cn_shape_def *def, const cn_chain *chain, cn_shape *out_shape)
{
	cni_call call = cni_enter(world, __func__);
	int32_t k;
	cni_check_pointer(&call, "chain", chain);
	if (call.result != CN_OK)
		return call.result;
	cni_check_flags(&call, "loop", chain->loop, 1u);
	cni_check_range_int(&call, "count", chain->count, chain->loop ? 3 : 2, 65535);
	cni_check_pointer(&call, "points_m", chain->points_m);
	for (k = 0; k < chain->count && call.result == CN_OK; ++k)
		cni_check_finite2(&call, "points_m", chain->points_m[k]);
	if (call.result == CN_OK)
		check_geometry(&call, cni_check_chain(chain, world->settings.thickness_least), chain->points_m, chain->count, (int32_t)chain->loop);
	return shape_create(&call, world, def, source_make(CN_SHAPE_CHAIN, chain->count, chain), out_shape);
}
