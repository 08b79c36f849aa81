/*
 * world/shape_geometry.c - public functions that read geometry back: boxes of shapes and bodies, mass,
 * points, point test. Reads only; points are in the body's local frame as the geometry record holds them.
 */
#include "world/error.h"

#include <string.h>

/* Geometry of a shape, which must be of the given type (any when CNI_NONE); NULL when the call failed. */
static const cni_geometry *geometry_of(cni_call *call, cn_shape shape, int32_t type, const void *out)
{
	const cni_shape *s = cni_check_shape(call, "shape", shape);
	cni_check_pointer(call, "out", out);
	if (call->result == CN_OK && type != CNI_NONE && s->type != type)
		cni_refuse(call, CN_ERROR_STATE, "the shape is of another type");
	return call->result == CN_OK ? cni_shape_geometry(&call->world->blocks, s) : NULL;
}

/* Of the shape's body, or the identity when it has none. */
static cni_transform transform_of(const cn_world *world, cn_shape shape)
{
	int32_t body = cni_shape_at(world, cni_shape_index(world, shape))->body;
	cni_transform identity = { { 1.0f, 0.0f }, { 0.0f, 0.0f } };
	return body == CNI_NONE ? identity : cni_body_transform(cni_body_at(world, body));
}

static void box_store(cni_aabb box, cn_aabb *out)
{
	out->lower_m = cni_v(box.x0, box.y0);
	out->upper_m = cni_v(box.x1, box.y1);
}

cn_result cn_shape_get_aabb(const cn_world *world, cn_shape shape, cn_aabb *out)
{
	cni_call call = cni_enter_const(world);
	const cni_geometry *g = geometry_of(&call, shape, CNI_NONE, out);
	if (g != NULL)
		box_store(cni_geometry_bounds(g, transform_of(world, shape)), out);
	return call.result;
}

cn_result cn_body_get_aabb(const cn_world *world, cn_body body, cn_aabb *out)
{
	cni_call call = cni_enter_const(world);
	const cni_body *b = cni_check_body(&call, "body", body);
	cni_transform x;
	cni_aabb box;
	int32_t shape;
	cni_check_pointer(&call, "out", out);
	if (call.result != CN_OK)
		return call.result;
	x = cni_body_transform(b);
	box.x0 = box.x1 = x.t.x;
	box.y0 = box.y1 = x.t.y;
	for (shape = b->shape_first; shape != CNI_NONE; shape = cni_shape_at(world, shape)->next) {
		cni_aabb next = cni_geometry_bounds(cni_shape_geometry(&world->blocks, cni_shape_at(world, shape)), x);
		box = shape == b->shape_first ? next : cni_aabb_union(&box, &next);
	}
	box_store(box, out);
	return CN_OK;
}

cn_result cn_shape_get_mass_data(const cn_world *world, cn_shape shape, cn_mass_data *out)
{
	cni_call call = cni_enter_const(world);
	const cni_geometry *g = geometry_of(&call, shape, CNI_NONE, out);
	if (g != NULL)
		*out = cni_geometry_mass(g, cni_shape_at(world, cni_shape_index(world, shape))->density);
	return call.result;
}

cn_result cn_shape_get_circle(const cn_world *world, cn_shape shape, cn_circle *out)
{
	cni_call call = cni_enter_const(world);
	const cni_geometry *g = geometry_of(&call, shape, CN_SHAPE_CIRCLE, out);
	if (g == NULL)
		return call.result;
	out->center_m = cni_geometry_points(g)[0];
	out->radius_m = g->radius;
	return CN_OK;
}

cn_result cn_shape_get_capsule(const cn_world *world, cn_shape shape, cn_capsule *out)
{
	cni_call call = cni_enter_const(world);
	const cni_geometry *g = geometry_of(&call, shape, CN_SHAPE_CAPSULE, out);
	if (g == NULL)
		return call.result;
	out->a_m = cni_geometry_points(g)[0];
	out->b_m = cni_geometry_points(g)[1];
	out->radius_m = g->radius;
	return CN_OK;
}

cn_result cn_shape_get_edge(const cn_world *world, cn_shape shape, cn_edge *out)
{
	cni_call call = cni_enter_const(world);
	const cni_geometry *g = geometry_of(&call, shape, CN_SHAPE_EDGE, out);
	if (g == NULL)
		return call.result;
	out->a_m = cni_geometry_points(g)[0];
	out->b_m = cni_geometry_points(g)[1];
	return CN_OK;
}

cn_result cn_shape_get_polygon(const cn_world *world, cn_shape shape, cn_polygon *out)
{
	cni_call call = cni_enter_const(world);
	const cni_geometry *g = geometry_of(&call, shape, CN_SHAPE_POLYGON, out);
	if (g == NULL)
		return call.result;
	memset(out, 0, sizeof *out);
	out->count = g->count;
	out->radius_m = g->radius;
	memcpy(out->points_m, cni_geometry_points(g), (size_t)g->count * sizeof(cn_vec2));
	return CN_OK;
}

cn_result cn_shape_get_chain_points(const cn_world *world, cn_shape shape, cn_vec2 *out, int32_t capacity, int32_t *out_count)
{
	cni_call call = cni_enter_const(world);
	const cni_geometry *g = geometry_of(&call, shape, CN_SHAPE_CHAIN, out_count);
	cni_check_capacity(&call, "out", out, capacity);
	if (call.result != CN_OK)
		return call.result;
	if (capacity > 0)
		memcpy(out, cni_geometry_points(g), (size_t)cni_min_i(capacity, g->count) * sizeof(cn_vec2));
	*out_count = g->count;
	return CN_OK;
}

cn_result cn_shape_test_point(const cn_world *world, cn_shape shape, float point_x_m, float point_y_m, int32_t *out_inside)
{
	cn_vec2 point_m = { point_x_m, point_y_m };
	cni_call call = cni_enter_const(world);
	const cni_geometry *g = geometry_of(&call, shape, CNI_NONE, out_inside);
	const cni_body *b;
	int32_t body;
	cni_check_finite2(&call, "point_m", point_m);
	if (call.result != CN_OK)
		return call.result;
	body = cni_shape_at(world, cni_shape_index(world, shape))->body;
	if (body != CNI_NONE) {
		b = cni_body_at(world, body);
		point_m = cni_sub(cni_sub(point_m, cni_v(b->cx, b->cy)), cni_v(b->cx_low, b->cy_low));
		point_m = cni_add(cni_unrotate(b->q, point_m), b->local_center);
	}
	*out_inside = cni_geometry_contains(g, point_m) != 0;
	return CN_OK;
}
