/*
 * collision/cast_shape.c - casts a translating convex shape against every type of shape.
 *
 * The moving set M overlaps the shape A after the translation d t exactly when d t lies in A - M, the Minkowski difference.
 * So the result is that of a ray from 0 along d against A - M. Its skeleton is the polygon of all edges of A and -M sorted
 * by angle (at most 32), and its radius is the sum of both radii. Each vertex of A - M is a vertex of A minus a vertex of
 * M; these give the contact point.
 */
#include "collision/cast.h"

typedef struct difference {
	cni_vec2 points[CNI_CAST_POINTS_MAX];
	cni_vec2 normals[CNI_CAST_POINTS_MAX]; /* from the edges themselves: differences of far points lose digits */
	int32_t of_a[CNI_CAST_POINTS_MAX];
	int32_t of_m[CNI_CAST_POINTS_MAX];
	int32_t count;
} difference;

/* Iterates counter-clockwise over a convex set's edges from its lowest point (of several, the leftmost): the edges are in
   order of their angle from 0 to 2 pi. sign -1 iterates over the mirror image. */
typedef struct contour {
	const cni_vec2 *points;
	int32_t count;
	int32_t first;
	int32_t done;   /* edges visited */
	float sign;
} contour;

static contour contour_make(const cni_vec2 *points, int32_t count, float sign)
{
	contour r = { points, count, 0, 0, sign };
	for (int32_t i = 1; i < count; ++i) {
		float dy = sign * (points[i].y - points[r.first].y), dx = sign * (points[i].x - points[r.first].x);
		if (dy < 0.0f || (dy == 0.0f && dx < 0.0f))
			r.first = i;
	}
	return r;
}

static int32_t contour_index(const contour *r, int32_t step)
{
	return (r->first + step) % r->count;
}

static int32_t contour_is_done(const contour *r)
{
	return r->count < 2 || r->done == r->count;
}

static cni_vec2 contour_edge(const contour *r)
{
	return cni_mul(r->sign, cni_sub(r->points[contour_index(r, r->done + 1)], r->points[contour_index(r, r->done)]));
}

/* -1: u has the smaller angle in [0, 2 pi), 1: v has, 0: they are parallel. */
static int32_t angle_order(cni_vec2 u, cni_vec2 v)
{
	int32_t half_u = u.y < 0.0f || (u.y == 0.0f && u.x < 0.0f);
	int32_t half_v = v.y < 0.0f || (v.y == 0.0f && v.x < 0.0f);
	float turn = cni_cross(u, v);
	if (half_u != half_v)
		return half_u < half_v ? -1 : 1;
	return turn > 0.0f ? -1 : turn < 0.0f ? 1 : 0;
}

static void difference_make(difference *out, const cni_vec2 *a, int32_t count_a, const cni_vec2 *m, int32_t count_m)
{
	contour ra = contour_make(a, count_a, 1.0f), rm = contour_make(m, count_m, -1.0f);
	out->count = 0;
	do {
		int32_t ia = contour_index(&ra, ra.done), im = contour_index(&rm, rm.done);
		cni_vec2 edge_a = contour_edge(&ra), edge_m = contour_edge(&rm);
		int32_t order = contour_is_done(&ra) ? 1 : contour_is_done(&rm) ? -1 : angle_order(edge_a, edge_m);
		out->normals[out->count] = cni_normalize(cni_right_perp(order > 0 ? edge_m : edge_a));
		out->points[out->count] = cni_sub(a[ia], m[im]);
		out->of_a[out->count] = ia;
		out->of_m[out->count] = im;
		++out->count;
		if (order <= 0 && !contour_is_done(&ra))
			++ra.done;
		if (order >= 0 && !contour_is_done(&rm))
			++rm.done;
	} while (!contour_is_done(&ra) || !contour_is_done(&rm));
}

/* Contact position of two faces along the tangent: the middle of their overlap. A vertex is a face without length. */
static float shared_middle(float a0, float a1, float m0, float m1)
{
	float lower = cni_max(cni_min(a0, a1), cni_min(m0, m1));
	float upper = cni_min(cni_max(a0, a1), cni_max(m0, m1));
	return 0.5f * (lower + upper);
}

static cni_vec2 touch_point(const difference *d, int32_t feature, const cni_vec2 *a, const cni_vec2 *m, cni_vec2 moved, cni_vec2 normal, float radius_a)
{
	int32_t i = feature < d->count ? feature : feature - d->count;
	int32_t j = i + 1 < d->count ? i + 1 : 0;
	cni_vec2 along = cni_left_perp(normal);
	cni_vec2 a0 = a[d->of_a[i]], a1 = a[d->of_a[j]];
	cni_vec2 m0 = cni_sub(cni_add(m[d->of_m[i]], moved), a0), m1 = cni_sub(cni_add(m[d->of_m[j]], moved), a0);
	float middle = 0.0f;
	if (feature >= d->count)
		middle = shared_middle(0.0f, cni_dot(along, cni_sub(a1, a0)), cni_dot(along, m0), cni_dot(along, m1));
	return cni_madd(cni_madd(a0, middle, along), radius_a, normal);
}

/* Normal and depth of an overlap with a chain's edge at the start. Beyond an end of the edge the shortest way out may lead to
   the front; otherwise the whole moving set must be lifted to the front. */
static void chain_lift(const difference *d, cni_vec2 front, float radius, cni_cast_hit *out, int32_t *out_feature)
{
	cni_vec2 up = cni_normalize(front);
	float most = -FLT_MAX;
	if (out->depth < radius && cni_dot(up, out->normal) > 0.0f)
		return;
	for (int32_t i = 0; i < d->count; ++i) {
		float height = cni_dot(up, d->points[i]);
		if (height > most) {
			most = height;
			*out_feature = i;
		}
	}
	out->normal = up;
	out->depth = most + radius;
}

int32_t cni_cast_points(const cni_geometry *g, int32_t child, cni_proxy_points moving, cni_vec2 centroid, cni_transform moving_in_g,
	cni_vec2 translation, cni_cast_hit *out)
{
	cni_vec2 storage[2], m[CN_POLYGON_MAX_VERTICES];
	cni_proxy_points a = cni_geometry_proxy(g, child, storage);
	cni_vec2 center = cni_transform_point(moving_in_g, centroid);
	cni_vec2 front = { 0.0f, 0.0f };
	difference d;
	int32_t feature;
	if (g->type == CN_SHAPE_CHAIN) {
		front = cni_right_perp(cni_sub(a.points[1], a.points[0]));
		if (cni_dot(front, cni_sub(center, a.points[0])) < 0.0f)
			return 0;
	}
	for (int32_t i = 0; i < moving.count; ++i)
		m[i] = cni_transform_point(moving_in_g, moving.points[i]);
	difference_make(&d, a.points, a.count, m, moving.count);
	cni_faces hull = { d.points, d.normals, d.count, a.radius + moving.radius };
	if (!cni_cast_hull_ray(&hull, cni_v(0.0f, 0.0f), translation, out, &feature))
		return 0;
	if (g->type == CN_SHAPE_CHAIN && out->inside)
		chain_lift(&d, front, hull.radius, out, &feature);
	else if (g->type == CN_SHAPE_CHAIN && !(cni_dot(front, translation) < 0.0f && cni_dot(front, out->normal) >= 0.0f))
		return 0;
	out->point = touch_point(&d, feature, a.points, m, cni_mul(out->fraction, translation), out->normal, a.radius);
	return 1;
}
