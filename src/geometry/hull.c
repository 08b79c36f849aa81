/*
 * geometry/hull.c - convex hull of a point cloud with a bounded number of vertices and no memory.
 *
 * Farthest-point insertion (the idea of Quickhull: Eddy 1977; Barber, Dobkin, Huhdanpaa 1996): start with two extreme
 * points; while vertices are left, find for every edge the point farthest outside it and insert the one whose triangle with
 * its edge has the largest area. A farthest point is a hull vertex and belongs between the edge's ends, so the polygon stays
 * convex. Points within the collinear height of an edge count as on it. At the end, coinciding and collinear vertices are
 * removed.
 * O(count * hull size^2).
 */
#include "geometry/shape.h"

typedef struct outsider {
	int32_t point; /* CNI_NONE: no point is outside this edge */
	float height;
	float area_twice;
} outsider;

int32_t cni_point_leftmost(const cni_vec2 *points, int32_t count)
{
	int32_t best = 0;
	for (int32_t i = 1; i < count; ++i)
		if (points[i].x < points[best].x || (points[i].x == points[best].x && points[i].y < points[best].y))
			best = i;
	return best;
}

int32_t cni_point_farthest(const cni_vec2 *points, int32_t count, cni_vec2 from)
{
	int32_t best = 0;
	for (int32_t i = 1; i < count; ++i)
		if (cni_distance_sq(points[i], from) > cni_distance_sq(points[best], from))
			best = i;
	return best;
}

int32_t cni_point_remove(cni_vec2 *points, int32_t count, int32_t at)
{
	for (int32_t i = at; i + 1 < count; ++i)
		points[i] = points[i + 1];
	return count - 1;
}

/* The point farthest to the right of a -> b, if farther than height_min; of equally far points the one nearest b. */
static outsider outsider_find(const cni_vec2 *points, int32_t count, cni_vec2 a, cni_vec2 b, float height_min)
{
	outsider found = { CNI_NONE, height_min, 0.0f };
	cni_vec2 edge = cni_sub(b, a);
	cni_vec2 along = cni_normalize(edge);
	float position = 0.0f;
	for (int32_t i = 0; i < count; ++i) {
		cni_vec2 d = cni_sub(points[i], a);
		float height = cni_cross(d, along);
		if (height < found.height || height <= height_min)
			continue;
		if (height == found.height && cni_dot(d, along) <= position)
			continue;
		found.point = i;
		found.height = height;
		position = cni_dot(d, along);
	}
	found.area_twice = found.point == CNI_NONE ? 0.0f : found.height * cni_length(edge);
	return found;
}

static void vertex_insert(cn_polygon *out, int32_t at, cni_vec2 point)
{
	for (int32_t i = out->count; i > at; --i)
		out->points_m[i] = out->points_m[i - 1];
	out->points_m[at] = point;
	++out->count;
}

static void hull_grow(const cni_vec2 *points, int32_t count, float height_min, cn_polygon *out)
{
	while (out->count < CN_POLYGON_MAX_VERTICES) {
		outsider best = { CNI_NONE, 0.0f, 0.0f };
		int32_t best_edge = 0;
		for (int32_t i = 0; i < out->count; ++i) {
			cni_vec2 next = out->points_m[i + 1 < out->count ? i + 1 : 0];
			outsider o = outsider_find(points, count, out->points_m[i], next, height_min);
			if (o.point != CNI_NONE && o.area_twice > best.area_twice) {
				best = o;
				best_edge = i;
			}
		}
		if (best.point == CNI_NONE)
			return;
		vertex_insert(out, best_edge + 1, points[best.point]);
	}
}

/* Repeatedly removes the lowest vertex that is collinear with its neighbours or too close to one of them. */
static void hull_clean(cn_polygon *out, float tolerance, float height_min)
{
	while (out->count >= 3) {
		int32_t worst = CNI_NONE;
		float worst_height = FLT_MAX;
		for (int32_t i = 0; i < out->count; ++i) {
			cni_vec2 before = out->points_m[i > 0 ? i - 1 : out->count - 1];
			cni_vec2 after = out->points_m[i + 1 < out->count ? i + 1 : 0];
			float height = cni_cross(cni_sub(out->points_m[i], before), cni_normalize(cni_sub(after, before)));
			int32_t close = cni_distance_sq(out->points_m[i], after) <= tolerance * tolerance
				|| cni_distance_sq(out->points_m[i], before) <= tolerance * tolerance;
			if ((close || !(height > height_min)) && height < worst_height) {
				worst = i;
				worst_height = height;
			}
		}
		if (worst == CNI_NONE)
			return;
		out->count = cni_point_remove(out->points_m, out->count, worst);
	}
}

const char *cni_hull_make(const cni_vec2 *points, int32_t count, float tolerance, cn_polygon *out)
{
	cn_polygon hull;
	if (count < 3 || count > 65536)
		return "count must be 3 to 65536";
	for (int32_t i = 0; i < count; ++i)
		if (!(cni_abs(points[i].x) <= CNI_COORDINATE_MAX && cni_abs(points[i].y) <= CNI_COORDINATE_MAX))
			return "coordinates must be finite and within 1e6 m";
	float height_min = cni_collinear_height(points, count, tolerance);
	hull.count = 2;
	hull.radius_m = 0.0f;
	hull.points_m[0] = points[cni_point_leftmost(points, count)];
	hull.points_m[1] = points[cni_point_farthest(points, count, hull.points_m[0])];
	if (cni_distance_sq(hull.points_m[0], hull.points_m[1]) <= tolerance * tolerance)
		return "points must not coincide";
	hull_grow(points, count, height_min, &hull);
	hull_clean(&hull, tolerance, height_min);
	if (hull.count < 3)
		return "points must not be collinear";
	for (int32_t i = hull.count; i < CN_POLYGON_MAX_VERTICES; ++i)
		hull.points_m[i] = cni_v(0.0f, 0.0f);
	const char *wrong = cni_check_polygon(&hull, tolerance);
	if (wrong == NULL)
		*out = hull;
	return wrong;
}
