/*
 * geometry/shape_build.c - writes geometry records: points in the body's frame, counter-clockwise polygons with their outward
 * normals, and the header's centroid, extent and inner radius.
 */
#include "geometry/shape.h"

int32_t cni_geometry_bytes(int32_t type, int32_t count)
{
	int32_t has_normals = type != CN_SHAPE_CIRCLE && !cni_is_chain(type);
	int32_t vectors = has_normals ? 2 * count : count;
	return (int32_t)sizeof(cni_geometry) + vectors * (int32_t)sizeof(cni_vec2);
}

int32_t cni_geometry_children(const cni_geometry *g)
{
	if (!cni_is_chain(g->type))
		return 1;
	return g->seams ? g->count : g->count - 1;
}

static cni_vec2 *points_write(cni_geometry *g)
{
	return (cni_vec2 *)(void *)(g + 1);
}

static void header_write(cni_geometry *out, int32_t type, int32_t count, float radius)
{
	out->type = type;
	out->count = count;
	out->radius = radius;
	out->seams = 0;
	out->inner_radius = 0.0f;
}

/* Writes centroid (mean of the points) and extent. */
static void header_measure(cni_geometry *out)
{
	const cni_vec2 *p = cni_geometry_points(out);
	float share = 1.0f / (float)out->count;
	cni_vec2 mean = cni_v(0.0f, 0.0f);
	float extent_sq = 0.0f;
	for (int32_t i = 0; i < out->count; ++i) {
		mean = cni_madd(mean, share, p[i]);
		extent_sq = cni_max(extent_sq, cni_length_sq(p[i]));
	}
	out->centroid = mean;
	out->extent = cni_sqrt(extent_sq) + out->radius;
}

/* A segment is a polygon of two corners with two opposite normals. */
static void segment_write(cni_geometry *out, int32_t type, cni_vec2 a, cni_vec2 b, float radius, cni_transform offset)
{
	cni_vec2 *p = points_write(out);
	header_write(out, type, 2, radius);
	p[0] = cni_transform_point(offset, a);
	p[1] = cni_transform_point(offset, b);
	p[2] = cni_normalize(cni_right_perp(cni_sub(p[1], p[0])));
	p[3] = cni_neg(p[2]);
	header_measure(out);
	out->inner_radius = radius;
}

void cni_geometry_circle(cni_geometry *out, const cn_circle *circle, cni_transform offset)
{
	header_write(out, CN_SHAPE_CIRCLE, 1, circle->radius_m);
	points_write(out)[0] = cni_transform_point(offset, circle->center_m);
	header_measure(out);
	out->inner_radius = circle->radius_m;
}

void cni_geometry_capsule(cni_geometry *out, const cn_capsule *capsule, cni_transform offset)
{
	segment_write(out, CN_SHAPE_CAPSULE, capsule->a_m, capsule->b_m, capsule->radius_m, offset);
}

void cni_geometry_edge(cni_geometry *out, const cn_edge *edge, cni_transform offset)
{
	segment_write(out, CN_SHAPE_EDGE, edge->a_m, edge->b_m, 0.0f, offset);
}

/* Twice the signed area, about the first point so that polygons far from the origin keep their digits. */
static float winding(const cni_vec2 *p, int32_t count)
{
	float sum = 0.0f;
	for (int32_t i = 1; i + 1 < count; ++i)
		sum += cni_cross(cni_sub(p[i], p[0]), cni_sub(p[i + 1], p[0]));
	return sum;
}

static void normals_write(cni_geometry *out)
{
	cni_vec2 *p = points_write(out);
	cni_vec2 *normals = p + out->count;
	for (int32_t i = 0; i < out->count; ++i) {
		cni_vec2 edge = cni_sub(p[i + 1 < out->count ? i + 1 : 0], p[i]);
		normals[i] = cni_normalize(cni_right_perp(edge));
	}
}

static float inner_radius(const cni_geometry *g)
{
	const cni_vec2 *p = cni_geometry_points(g);
	const cni_vec2 *normals = cni_geometry_normals(g);
	float least = FLT_MAX;
	for (int32_t i = 0; i < g->count; ++i)
		least = cni_min(least, cni_dot(normals[i], cni_sub(p[i], g->centroid)));
	return cni_max(least, 0.0f) + g->radius;
}

void cni_geometry_polygon(cni_geometry *out, const cn_polygon *polygon, cni_transform offset)
{
	int32_t count = polygon->count;
	int32_t clockwise = winding(polygon->points_m, count) < 0.0f;
	header_write(out, CN_SHAPE_POLYGON, count, polygon->radius_m);
	cni_vec2 *p = points_write(out);
	for (int32_t i = 0; i < count; ++i)
		p[i] = cni_transform_point(offset, polygon->points_m[clockwise ? count - 1 - i : i]);
	normals_write(out);
	header_measure(out);
	out->centroid = cni_geometry_mass(out, 1.0f).center_m;
	out->inner_radius = inner_radius(out);
}

void cni_geometry_chain(cni_geometry *out, const cn_chain *chain, cni_transform offset)
{
	header_write(out, CN_SHAPE_CHAIN, chain->count, 0.0f);
	out->seams = chain->loop;
	cni_vec2 *p = points_write(out);
	for (int32_t i = 0; i < chain->count; ++i)
		p[i] = cni_transform_point(offset, chain->points_m[i]);
	header_measure(out);
}
