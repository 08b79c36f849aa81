/*
 * world/shape_source.c - checks the geometry that users give, and builds its stored form.
 */
#include "world/shape_source.h"

static cni_shape_source source_make(int32_t type, int32_t count, const void *given)
{
	cni_shape_source s = { type, count, given };
	return s;
}

void cni_source_build(cni_geometry *out, const cni_shape_source *from, cni_transform offset)
{
	switch (from->type) {
	case CN_SHAPE_CIRCLE: cni_geometry_circle(out, (const cn_circle *)from->given, offset); break;
	case CN_SHAPE_CAPSULE: cni_geometry_capsule(out, (const cn_capsule *)from->given, offset); break;
	case CN_SHAPE_EDGE: cni_geometry_edge(out, (const cn_edge *)from->given, offset); break;
	case CN_SHAPE_POLYGON: cni_geometry_polygon(out, (const cn_polygon *)from->given, offset); break;
	default: cni_geometry_chain(out, (const cn_chain *)from->given, offset); break;
	}
}

cni_shape_source cni_source_circle(cni_call *call, const cn_world *world, const cn_circle *circle)
{
	cni_check_pointer(call, "circle", circle);
	cni_check(call, CNI_HAS_CIRCLES, CN_ERROR_STATE, "this library was built without circles (CN_NO_CIRCLES)");
	if (call->result == CN_OK) {
		cni_check_finite2(call, "center_m", circle->center_m);
		cni_check_positive(call, "radius_m", circle->radius_m);
		cni_check_complaint(call, cni_check_circle(circle, world->settings.thickness_least), &circle->center_m, 1, 0);
	}
	return source_make(CN_SHAPE_CIRCLE, 1, circle);
}

cni_shape_source cni_source_capsule(cni_call *call, const cn_world *world, const cn_capsule *capsule)
{
	cn_vec2 ends[2];
	cni_check_pointer(call, "capsule", capsule);
	if (call->result == CN_OK) {
		cni_check_finite2(call, "a_m", capsule->a_m);
		cni_check_finite2(call, "b_m", capsule->b_m);
		cni_check_positive(call, "radius_m", capsule->radius_m);
		ends[0] = capsule->a_m;
		ends[1] = capsule->b_m;
		cni_check_complaint(call, cni_check_capsule(capsule, world->settings.thickness_least), ends, 2, 0);
	}
	return source_make(CN_SHAPE_CAPSULE, 2, capsule);
}

cni_shape_source cni_source_edge(cni_call *call, const cn_world *world, const cn_edge *edge)
{
	cn_vec2 ends[2];
	cni_check_pointer(call, "edge", edge);
	if (call->result == CN_OK) {
		cni_check_finite2(call, "a_m", edge->a_m);
		cni_check_finite2(call, "b_m", edge->b_m);
		ends[0] = edge->a_m;
		ends[1] = edge->b_m;
		cni_check_complaint(call, cni_check_edge(edge, world->settings.thickness_least), ends, 2, 0);
	}
	return source_make(CN_SHAPE_EDGE, 2, edge);
}

cni_shape_source cni_source_polygon(cni_call *call, const cn_world *world, const cn_polygon *polygon)
{
	int32_t k;
	cni_check_pointer(call, "polygon", polygon);
	if (call->result != CN_OK)
		return source_make(CN_SHAPE_POLYGON, 0, polygon);
	cni_check_range_int(call, "count", polygon->count, 3, CN_POLYGON_MAX_VERTICES);
	cni_check_at_least(call, "radius_m", polygon->radius_m, 0.0f);
	for (k = 0; k < polygon->count && call->result == CN_OK; ++k)
		cni_check_finite2(call, "points_m", polygon->points_m[k]);
	if (call->result == CN_OK)
		cni_check_complaint(call, cni_check_polygon(polygon, world->settings.thickness_least), polygon->points_m, polygon->count, 1);
	return source_make(CN_SHAPE_POLYGON, polygon->count, polygon);
}

cni_shape_source cni_source_chain(cni_call *call, const cn_world *world, const cn_chain *chain)
{
	int32_t k;
	cni_check_pointer(call, "chain", chain);
	cni_check(call, CNI_HAS_CHAINS, CN_ERROR_STATE, "this library was built without chains (CN_NO_CHAINS)");
	if (call->result != CN_OK)
		return source_make(CN_SHAPE_CHAIN, 0, chain);
	cni_check_flags(call, "loop", chain->loop, 1u);
	cni_check_range_int(call, "count", chain->count, chain->loop ? 3 : 2, 65535);
	cni_check_pointer(call, "points_m", chain->points_m);
	for (k = 0; k < chain->count && call->result == CN_OK; ++k)
		cni_check_finite2(call, "points_m", chain->points_m[k]);
	if (call->result == CN_OK)
		cni_check_complaint(call, cni_check_chain(chain, world->settings.thickness_least), chain->points_m, chain->count, (int32_t)chain->loop);
	return source_make(CN_SHAPE_CHAIN, chain->count, chain);
}
