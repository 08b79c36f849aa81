/*
 * world/shape_geometry.c - public functions that read geometry: boxes of shapes and bodies, mass, points,
 * point test. Reads only; points are in the body's local frame, as in the geometry record.
 */
#include "world/define.h"

#include <string.h>

/* Geometry of a shape of the given type (CNI_NONE: any); NULL if the call failed. */
static const cni_geometry *geometry_of(cni_call *call, cn_shape shape, int32_t type, const void *out)
{
	const cni_shape *s = cni_check_shape(call, "shape", shape);
	cni_check_pointer(call, "out", out);
	cni_check(call, s == NULL || type == CNI_NONE || s->type == type, CN_ERROR_STATE, "the shape is of another type");
	return call->result == CN_OK ? cni_shape_geometry(&call->world->blocks, s) : NULL;
}

/* Transform of the shape's body, the identity without a body. */
static cni_transform transform_of(const cn_world *world, cn_shape shape)
{
	int32_t body = cni_shape_at(world, cni_shape_index(world, shape))->body;
	return body == CNI_NONE ? cni_identity() : cni_body_transform(cni_body_at(world, body));
}

static cn_aabb box_of(cni_aabb box)
{
	cn_aabb b = { { box.x0, box.y0 }, { box.x1, box.y1 } };
	return b;
}

/* The origin of a body without shapes. */
static cni_aabb box_of_body(const cn_world *world, const cni_body *b)
{
	cni_transform x = cni_body_transform(b);
	cni_aabb box = cni_aabb_of(x.t, x.t);
	for (int32_t shape = b->shape_first; shape != CNI_NONE; shape = cni_shape_at(world, shape)->next) {
		cni_aabb next = cni_geometry_bounds(cni_shape_geometry(&world->blocks, cni_shape_at(world, shape)), x);
		box = shape == b->shape_first ? next : cni_aabb_union(&box, &next);
	}
	return box;
}

CNI_DEFINE_GET(body, aabb, cn_aabb, box_of(box_of_body(world, record)))

/* ---- by shape ---- */

static cn_circle circle_of(const cni_geometry *g)
{
	cn_circle c = { cni_geometry_points(g)[0], g->radius };
	return c;
}

static cn_capsule capsule_of(const cni_geometry *g)
{
	cn_capsule c = { cni_geometry_points(g)[0], cni_geometry_points(g)[1], g->radius };
	return c;
}

static cn_edge edge_of(const cni_geometry *g)
{
	cn_edge e = { cni_geometry_points(g)[0], cni_geometry_points(g)[1] };
	return e;
}

static cn_polygon polygon_of(const cni_geometry *g)
{
	cn_polygon p;
	memset(&p, 0, sizeof p);
	p.count = g->count;
	p.radius_m = g->radius;
	memcpy(p.points_m, cni_geometry_points(g), (size_t)g->count * sizeof(cn_vec2));
	return p;
}

/* Defines cn_shape_get_<what> for shapes of a type: value is an expression of `g`, `world` and `shape`. */
#define GEOMETRY_GET(what, shape_type, type, value) \
	cn_result cn_shape_get_##what(const cn_world *world, cn_shape shape, type *out) \
	{ \
		cni_call call = cni_enter_const(world); \
		const cni_geometry *g = geometry_of(&call, shape, shape_type, out); \
		if (g != NULL) \
			*out = value; \
		return call.result; \
	}

GEOMETRY_GET(aabb, CNI_NONE, cn_aabb, box_of(cni_geometry_bounds(g, transform_of(world, shape))))
GEOMETRY_GET(mass_data, CNI_NONE, cn_mass_data, cni_geometry_mass(g, cni_shape_at(world, cni_shape_index(world, shape))->density))
GEOMETRY_GET(circle, CN_SHAPE_CIRCLE, cn_circle, circle_of(g))
GEOMETRY_GET(capsule, CN_SHAPE_CAPSULE, cn_capsule, capsule_of(g))
GEOMETRY_GET(edge, CN_SHAPE_EDGE, cn_edge, edge_of(g))
GEOMETRY_GET(polygon, CN_SHAPE_POLYGON, cn_polygon, polygon_of(g))

cn_result cn_shape_get_chain_points(const cn_world *world, cn_shape shape, cn_vec2 *out, int32_t capacity, int32_t *out_count)
{
	cni_call call = cni_enter_const(world);
	const cni_geometry *g = geometry_of(&call, shape, CN_SHAPE_CHAIN, out_count);
	cni_check_array(&call, "out", out, capacity);
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
	cni_check_finite2(&call, "point_m", point_m);
	if (call.result != CN_OK)
		return call.result;
	int32_t body = cni_shape_at(world, cni_shape_index(world, shape))->body;
	*out_inside = cni_geometry_contains(g, body != CNI_NONE ? cni_body_to_local(cni_body_at(world, body), point_m) : point_m) != 0;
	return CN_OK;
}
