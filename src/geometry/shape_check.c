/*
 * geometry/shape_check.c - checks shapes that a user passes in. A check that returns NULL guarantees the preconditions of the
 * builders and the manifolds: finite, bounded coordinates, edges longer than the tolerance, polygons that are strictly
 * convex and wind around once.
 */
#include "geometry/shape.h"

/* Coordinates are stored with a relative error of 2^-24; heights a few times that are noise. */
#define HEIGHT_RELATIVE_MIN 5.0e-7f

static int32_t point_is_valid(cni_vec2 p)
{
	return cni_abs(p.x) <= CNI_COORDINATE_MAX && cni_abs(p.y) <= CNI_COORDINATE_MAX;
}

const char cni_points_near[] = "points must be farther apart";

float cni_least_distance(const cni_vec2 *points, int32_t count, int32_t closed)
{
	float least_sq = FLT_MAX;
	for (int32_t i = 0; i < (closed ? count : count - 1); ++i)
		least_sq = cni_min(least_sq, cni_distance_sq(points[i], points[i + 1 < count ? i + 1 : 0]));
	return cni_sqrt(least_sq);
}

static int32_t points_apart(const cni_vec2 *points, int32_t count, int32_t closed, float tolerance)
{
	float distance = cni_least_distance(points, count, closed);
	return distance > 0.0f && distance >= tolerance * (1.0f - 1.0e-4f); /* accepts distances that round to the tolerance */
}

static const char *const text_points = "coordinates must be finite and within 1e6 m";
static const char *const text_radius = "radius must be finite, > 0 and at most 1e6 m";

const char *cni_check_circle(const cn_circle *circle, float tolerance)
{
	(void)tolerance;
	if (!point_is_valid(circle->center_m))
		return text_points;
	if (!(circle->radius_m > 0.0f && circle->radius_m <= CNI_COORDINATE_MAX))
		return text_radius;
	return NULL;
}

const char *cni_check_edge(const cn_edge *edge, float tolerance)
{
	const cni_vec2 ends[2] = { edge->a_m, edge->b_m };
	if (!point_is_valid(edge->a_m) || !point_is_valid(edge->b_m))
		return text_points;
	return points_apart(ends, 2, 0, tolerance) ? NULL : cni_points_near;
}

const char *cni_check_capsule(const cn_capsule *capsule, float tolerance)
{
	const cn_edge edge = { capsule->a_m, capsule->b_m };
	const char *wrong = cni_check_edge(&edge, tolerance);
	return wrong != text_points && !(capsule->radius_m > 0.0f && capsule->radius_m <= CNI_COORDINATE_MAX) ? text_radius : wrong;
}

float cni_collinear_height(const cni_vec2 *points, int32_t count, float tolerance)
{
	float largest = 0.0f;
	for (int32_t i = 0; i < count; ++i)
		largest = cni_max(largest, cni_max(cni_abs(points[i].x), cni_abs(points[i].y)));
	return cni_max(0.1f * tolerance, HEIGHT_RELATIVE_MIN * largest);
}

/* Signed height of point over the line from a to b, positive on its right. */
static float height_right_of(cni_vec2 a, cni_vec2 b, cni_vec2 point)
{
	cni_vec2 along = cni_normalize(cni_sub(b, a));
	return cni_cross(cni_sub(point, a), along);
}

/* 1 when all other vertices lie on the inner side of the edge. If this holds for every edge, the polygon is convex and winds
   around once. */
static int32_t edge_is_outer(const cn_polygon *polygon, int32_t edge, float sign)
{
	const cni_vec2 *p = polygon->points_m;
	int32_t next = edge + 1 < polygon->count ? edge + 1 : 0;
	for (int32_t i = 0; i < polygon->count; ++i)
		if (i != edge && i != next && !(sign * height_right_of(p[edge], p[next], p[i]) < 0.0f))
			return 0;
	return 1;
}

static const char *polygon_check_convex(const cn_polygon *polygon, float tolerance)
{
	const cni_vec2 *p = polygon->points_m;
	int32_t n = polygon->count;
	float height_min = cni_collinear_height(p, n, tolerance);
	float sign = cni_cross(cni_sub(p[1], p[0]), cni_sub(p[2], p[1])) < 0.0f ? -1.0f : 1.0f;
	for (int32_t i = 0; i < n; ++i) {
		cni_vec2 before = p[i > 0 ? i - 1 : n - 1];
		cni_vec2 after = p[i + 1 < n ? i + 1 : 0];
		if (!(cni_abs(height_right_of(before, after, p[i])) > height_min))
			return "points must not be collinear";
		if (!edge_is_outer(polygon, i, sign))
			return "points must be convex";
	}
	return NULL;
}

const char *cni_check_polygon(const cn_polygon *polygon, float tolerance)
{
	if (polygon->count < 3 || polygon->count > CN_POLYGON_MAX_VERTICES)
		return "count must be 3 to 16";
	if (!(polygon->radius_m >= 0.0f && polygon->radius_m <= CNI_COORDINATE_MAX))
		return "radius must be finite, >= 0 and at most 1e6 m";
	for (int32_t i = 0; i < polygon->count; ++i)
		if (!point_is_valid(polygon->points_m[i]))
			return text_points;
	if (!points_apart(polygon->points_m, polygon->count, 1, tolerance))
		return cni_points_near;
	return polygon_check_convex(polygon, tolerance);
}

const char *cni_check_chain(const cn_chain *chain, float tolerance)
{
	if (chain->points_m == NULL)
		return "points must not be NULL";
	if (chain->loop > 1u)
		return "loop must be 0 or 1";
	if (chain->count < (chain->loop ? 3 : 2) || chain->count > 65535)
		return chain->loop ? "count of a loop must be 3 to 65535" : "count must be 2 to 65535";
	for (int32_t i = 0; i < chain->count; ++i)
		if (!point_is_valid(chain->points_m[i]))
			return text_points;
	return points_apart(chain->points_m, chain->count, (int32_t)chain->loop, tolerance) ? NULL : cni_points_near;
}
