/*
 * collision/distance.c - closest points of convex point sets and of segments.
 *
 * Point sets: GJK (Gilbert, Johnson, Keerthi 1988) on the Minkowski difference b - a with barycentric
 * simplex reduction (Catto, GDC 2010). Each iteration adds a support point and so approaches the point of
 * b - a nearest to the origin. An iteration that does not come strictly nearer is undone and ends the
 * search, so rounding cannot make it cycle.
 *
 * Segments: in the plane, two segments either cross or are closest at an end of one of them, so the
 * least of four point-to-segment distances is exact, for parallel segments too.
 *
 * A shape and a point: outside the skeleton, the closest point of the nearest edge, moved out by the radius; inside a polygon, the
 * closest point of the face of least depth.
 */
#include "collision/distance.h"

#define ITERATIONS_MAX 40

typedef struct vertex {
	cni_vec2 w;       /* difference of the support points, b - a */
	float share;      /* barycentric */
	int32_t ia, ib;   /* of the support points */
} vertex;

typedef struct simplex {
	vertex v[3];
	int32_t count;
} simplex;

typedef struct query {
	const cni_vec2 *points_a, *points_b;
	int32_t count_a, count_b;
	cni_transform b_in_a;
} query;

static int32_t support(const cni_vec2 *points, int32_t count, cni_vec2 direction)
{
	int32_t best = 0;
	float most = cni_dot(points[0], direction);
	for (int32_t i = 1; i < count; ++i) {
		float reach = cni_dot(points[i], direction);
		if (reach > most) {
			most = reach;
			best = i;
		}
	}
	return best;
}

static vertex vertex_make(const query *q, int32_t ia, int32_t ib)
{
	vertex v = { cni_sub(cni_transform_point(q->b_in_a, q->points_b[ib]), q->points_a[ia]), 1.0f, ia, ib };
	return v;
}

static void keep1(simplex *s, int32_t i)
{
	s->v[0] = s->v[i];
	s->v[0].share = 1.0f;
	s->count = 1;
}

static void keep2(simplex *s, int32_t i, int32_t j, float share_i, float share_j)
{
	vertex vi = s->v[i];
	vertex vj = s->v[j];
	float scale = 1.0f / (share_i + share_j);
	vi.share = share_i * scale;
	vj.share = share_j * scale;
	s->v[0] = vi;
	s->v[1] = vj;
	s->count = 2;
}

static void reduce2(simplex *s)
{
	cni_vec2 e = cni_sub(s->v[1].w, s->v[0].w);
	float share1 = -cni_dot(s->v[0].w, e);
	float share0 = cni_dot(s->v[1].w, e);
	if (share1 <= 0.0f)
		keep1(s, 0);
	else if (share0 <= 0.0f)
		keep1(s, 1);
	else
		keep2(s, 0, 1, share0, share1);
}

/* Vertex regions first, then edges, then the inside: the Voronoi regions of a triangle. */
static void reduce3(simplex *s)
{
	cni_vec2 w0 = s->v[0].w, w1 = s->v[1].w, w2 = s->v[2].w;
	cni_vec2 e01 = cni_sub(w1, w0), e02 = cni_sub(w2, w0), e12 = cni_sub(w2, w1);
	float d01_1 = -cni_dot(w0, e01), d01_0 = cni_dot(w1, e01);
	float d02_2 = -cni_dot(w0, e02), d02_0 = cni_dot(w2, e02);
	float d12_2 = -cni_dot(w1, e12), d12_1 = cni_dot(w2, e12);
	float area = cni_cross(e01, e02);
	float b0 = area * cni_cross(w1, w2), b1 = area * cni_cross(w2, w0), b2 = area * cni_cross(w0, w1);
	if (d01_1 <= 0.0f && d02_2 <= 0.0f)
		keep1(s, 0);
	else if (d01_0 <= 0.0f && d12_2 <= 0.0f)
		keep1(s, 1);
	else if (d02_0 <= 0.0f && d12_1 <= 0.0f)
		keep1(s, 2);
	else if (d01_0 > 0.0f && d01_1 > 0.0f && b2 <= 0.0f)
		keep2(s, 0, 1, d01_0, d01_1);
	else if (d02_0 > 0.0f && d02_2 > 0.0f && b1 <= 0.0f)
		keep2(s, 0, 2, d02_0, d02_2);
	else if (d12_1 > 0.0f && d12_2 > 0.0f && b0 <= 0.0f)
		keep2(s, 1, 2, d12_1, d12_2);
	else {
		float sum = b0 + b1 + b2;
		float scale = sum > 0.0f ? 1.0f / sum : 0.0f;
		s->v[0].share = sum > 0.0f ? b0 * scale : 1.0f;
		s->v[1].share = b1 * scale;
		s->v[2].share = b2 * scale;
	}
}

/* A vector from the origin towards the simplex, not normalised. For an edge it is the perpendicular, whose direction stays
   exact however close the origin is. */
static cni_vec2 simplex_offset(const simplex *s)
{
	if (s->count == 1)
		return s->v[0].w;
	cni_vec2 side = cni_left_perp(cni_sub(s->v[1].w, s->v[0].w));
	return cni_dot(side, s->v[0].w) < 0.0f ? cni_neg(side) : side;
}

static float simplex_distance(const simplex *s)
{
	if (s->count == 1)
		return cni_length(s->v[0].w);
	return cni_dot(cni_normalize(simplex_offset(s)), s->v[0].w);
}

static int32_t simplex_has(const simplex *s, int32_t ia, int32_t ib)
{
	for (int32_t i = 0; i < s->count; ++i)
		if (s->v[i].ia == ia && s->v[i].ib == ib)
			return 1;
	return 0;
}

/* Finds the simplex nearest to the origin. Three vertices or distance 0: the sets overlap. */
static void simplex_search(const query *q, simplex *s)
{
	s->v[0] = vertex_make(q, 0, 0);
	s->count = 1;
	float nearest = simplex_distance(s);
	for (int32_t iteration = 0; iteration < ITERATIONS_MAX && nearest > 0.0f; ++iteration) {
		cni_vec2 offset = simplex_offset(s);
		int32_t ia = support(q->points_a, q->count_a, offset);
		int32_t ib = support(q->points_b, q->count_b, cni_unrotate(q->b_in_a.q, cni_neg(offset)));
		if (simplex_has(s, ia, ib))
			break;
		simplex next = *s;
		next.v[next.count++] = vertex_make(q, ia, ib);
		if (next.count == 2)
			reduce2(&next);
		else
			reduce3(&next);
		if (next.count == 3) {
			*s = next;
			break;
		}
		float distance = simplex_distance(&next);
		if (distance >= nearest)
			break;
		*s = next;
		nearest = distance;
	}
}

cni_closest cni_closest_find(const cni_vec2 *points_a, int32_t count_a, const cni_vec2 *points_b, int32_t count_b, cni_transform b_in_a)
{
	query q = { points_a, points_b, count_a, count_b, b_in_a };
	simplex s;
	cni_closest out;
	simplex_search(&q, &s);
	out.point_a = cni_v(0.0f, 0.0f);
	out.point_b = cni_v(0.0f, 0.0f);
	for (int32_t i = 0; i < s.count; ++i) {
		out.point_a = cni_madd(out.point_a, s.v[i].share, points_a[s.v[i].ia]);
		out.point_b = cni_madd(out.point_b, s.v[i].share, cni_transform_point(b_in_a, points_b[s.v[i].ib]));
	}
	out.distance = s.count == 3 ? 0.0f : simplex_distance(&s);
	out.normal = out.distance > 0.0f ? cni_normalize(simplex_offset(&s)) : cni_v(0.0f, 0.0f);
	if (!(out.distance > 0.0f))
		out.point_b = out.point_a;
	int32_t last = s.count > 1 ? 1 : 0;
	out.index_a[0] = s.v[0].ia;
	out.index_a[1] = s.v[last].ia;
	out.index_b[0] = s.v[0].ib;
	out.index_b[1] = s.v[last].ib;
	return out;
}

cni_closest cni_distance(cni_proxy_points a, cni_proxy_points b, cni_transform b_in_a)
{
	cni_closest c = cni_closest_find(a.points, a.count, b.points, b.count, b_in_a);
	c.point_a = cni_madd(c.point_a, a.radius, c.normal);
	c.point_b = cni_madd(c.point_b, -b.radius, c.normal);
	c.distance = c.distance > 0.0f ? c.distance - a.radius - b.radius : 0.0f;
	return c;
}

static void segments_try(cni_segment_distance *best, cni_vec2 a, cni_vec2 b, float fraction_a, float fraction_b)
{
	const cni_segment_distance found = { a, b, fraction_a, fraction_b, cni_distance_sq(a, b) };
	if (!(found.distance_sq >= best->distance_sq))
		*best = found;
}

/* A proper crossing; touching ends are found by the end tests. */
static int32_t segments_cross(cni_vec2 p1, cni_vec2 q1, cni_vec2 p2, cni_vec2 q2, cni_segment_distance *out)
{
	cni_vec2 e1 = cni_sub(q1, p1), e2 = cni_sub(q2, p2), r = cni_sub(p2, p1);
	float c = cni_cross(e1, e2);
	float t1 = cni_cross(r, e2), t2 = cni_cross(r, e1);
	if (c < 0.0f) {
		c = -c;
		t1 = -t1;
		t2 = -t2;
	}
	if (!(c > 0.0f && t1 > 0.0f && t1 < c && t2 > 0.0f && t2 < c))
		return 0;
	out->fraction_a = t1 / c;
	out->fraction_b = t2 / c;
	out->point_a = cni_madd(p1, out->fraction_a, e1);
	out->point_b = out->point_a;
	out->distance_sq = 0.0f;
	return 1;
}

cni_segment_distance cni_segment_to_segment(cni_vec2 p1, cni_vec2 q1, cni_vec2 p2, cni_vec2 q2)
{
	cni_segment_distance best = { { 0.0f, 0.0f }, { 0.0f, 0.0f }, 0.0f, 0.0f, FLT_MAX };
	cni_vec2 e1 = cni_sub(q1, p1), e2 = cni_sub(q2, p2);
	if (segments_cross(p1, q1, p2, q2, &best))
		return best;
	float f = cni_segment_fraction(p1, p2, e2);
	segments_try(&best, p1, cni_lerp(p2, q2, f), 0.0f, f);
	f = cni_segment_fraction(q1, p2, e2);
	segments_try(&best, q1, cni_lerp(p2, q2, f), 1.0f, f);
	f = cni_segment_fraction(p2, p1, e1);
	segments_try(&best, cni_lerp(p1, q1, f), p2, f, 0.0f);
	f = cni_segment_fraction(q2, p1, e1);
	segments_try(&best, cni_lerp(p1, q1, f), q2, f, 1.0f);
	return best;
}

/* ------------------------------------------------------------------ a shape and a point */

static cni_nearest nearest_make(cni_vec2 on_skeleton, cni_vec2 normal, float height, float radius)
{
	cni_nearest n = { height - radius, cni_madd(on_skeleton, radius, normal), normal };
	return n;
}

/* 1 when the point is in the polygon's skeleton. */
static int32_t nearest_inside(const cni_geometry *g, cni_vec2 local, cni_nearest *out)
{
	const cni_vec2 *p = cni_geometry_points(g), *normals = cni_geometry_normals(g);
	int32_t best = 0;
	float most = -FLT_MAX;
	for (int32_t i = 0; i < g->count; ++i) {
		float height = cni_dot(normals[i], cni_sub(local, p[i]));
		if (height > 0.0f)
			return 0;
		if (height > most) {
			most = height;
			best = i;
		}
	}
	*out = nearest_make(cni_madd(local, -most, normals[best]), normals[best], most, g->radius);
	return 1;
}

cni_nearest cni_geometry_nearest(const cni_geometry *g, int32_t child, cni_vec2 local)
{
	cni_vec2 storage[2];
	cni_proxy_points set = cni_geometry_proxy(g, child, storage);
	cni_vec2 best = set.points[0], normal = { 1.0f, 0.0f };
	int32_t edges = set.count > 2 ? set.count : set.count - 1;
	cni_nearest inside;
	if (g->type == CN_SHAPE_POLYGON && nearest_inside(g, local, &inside))
		return inside;
	if (set.count == 2)
		normal = cni_normalize(cni_right_perp(cni_sub(set.points[1], set.points[0])));
	for (int32_t i = 0; i < edges; ++i) {
		cni_vec2 a = set.points[i], on = cni_segment_nearest(local, a, cni_sub(set.points[i + 1 < set.count ? i + 1 : 0], a));
		if (i == 0 || cni_distance_sq(local, on) < cni_distance_sq(local, best))
			best = on;
	}
	float distance = cni_length(cni_sub(local, best));
	if (distance > 0.0f)
		normal = cni_normalize(cni_sub(local, best));
	return nearest_make(best, normal, distance, set.radius);
}
