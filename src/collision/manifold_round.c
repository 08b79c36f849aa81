/*
 * collision/manifold_round.c - manifolds of a circle (shape a) with a circle, a segment or a polygon: finds the closest
 * point of b's skeleton to the centre, in b's frame. One point, one normal. Where the centre lies on the skeleton, a face
 * normal (or, for two circles, +y) replaces the undefined direction, so the normal is always unit.
 */
#include "collision/manifold_faces.h"

/* Below this length in metres a direction is not taken from a difference of points. */
#define LENGTH_MIN 1.0e-12f

/* The centre's position relative to b's skeleton, in b's frame. */
typedef struct nearest {
	cni_vec2 normal;  /* unit, from b's skeleton to the centre */
	float distance;   /* negative inside */
	int32_t feature;
} nearest;

void cni_circle_manifold(const cni_manifold_input *in, cni_vec2 outward, float separation, int32_t feature, cni_manifold *out)
{
	out->count = separation <= in->margin;
	if (separation > in->margin)
		return;
	out->normal = cni_neg(outward);
	out->points[0].point = cni_madd(cni_geometry_points(in->a)[0], in->a->radius + 0.5f * separation, out->normal);
	out->points[0].separation = separation;
	out->points[0].id = cni_manifold_id(0, feature);
}

static void nearest_emit(const nearest *near, const cni_manifold_input *in, cni_manifold *out)
{
	cni_circle_manifold(in, cni_rotate(in->b_in_a.q, near->normal), near->distance - in->a->radius - in->b->radius, near->feature, out);
}

static nearest nearest_to_point(cni_vec2 center, cni_vec2 point, cni_vec2 fallback, int32_t feature)
{
	cni_vec2 d = cni_sub(center, point);
	float distance = cni_length(d);
	nearest near = { distance > LENGTH_MIN ? cni_mul(1.0f / distance, d) : fallback, distance, feature };
	return near;
}

static nearest nearest_on_segment(cni_vec2 center, const cni_geometry *segment)
{
	nearest near;
	const cni_vec2 *p = cni_geometry_points(segment);
	cni_vec2 edge = cni_sub(p[1], p[0]);
	float length_sq = cni_length_sq(edge);
	float at = cni_dot(cni_sub(center, p[0]), edge);
	cni_vec2 side = cni_geometry_normals(segment)[1]; /* left of the edge */
	if (at <= 0.0f)
		return nearest_to_point(center, p[0], side, 0);
	if (at >= length_sq)
		return nearest_to_point(center, p[1], side, 1);
	float height = cni_dot(side, cni_sub(center, p[0]));
	near.normal = height < 0.0f ? cni_neg(side) : side;
	near.distance = cni_abs(height);
	near.feature = CNI_FEATURE_EDGE;
	return near;
}

void cni_collide_circle_round(const cni_manifold_input *in, cni_manifold_cache *cache, cni_manifold *out)
{
	(void)cache;
	cni_vec2 center = cni_untransform_point(in->b_in_a, cni_geometry_points(in->a)[0]);
	nearest near = in->b->count > 1 ? nearest_on_segment(center, in->b) : nearest_to_point(center, cni_geometry_points(in->b)[0], cni_v(0.0f, 1.0f), 0);
	nearest_emit(&near, in, out);
}

static float face_height(const cni_geometry *g, int32_t edge, cni_vec2 point)
{
	return cni_dot(cni_geometry_normals(g)[edge], cni_sub(point, cni_geometry_points(g)[edge]));
}

/* The face of greatest height under the centre. Inside, the cached face is preferred, so that a centre deep in the middle
   does not jump between faces. */
static int32_t face_find(const cni_geometry *g, cni_vec2 center, int32_t cached, float touch, float *out_height)
{
	int32_t best = 0;
	float height = face_height(g, 0, center);
	for (int32_t i = 1; i < g->count; ++i) {
		float h = face_height(g, i, center);
		best = h > height ? i : best;
		height = cni_max(h, height);
	}
	if (height < 0.0f && cached > CN_POLYGON_MAX_VERTICES && cached <= CN_POLYGON_MAX_VERTICES + g->count) {
		int32_t edge = cached - CN_POLYGON_MAX_VERTICES - 1;
		float h = face_height(g, edge, center);
		if (h >= height - touch) {
			best = edge;
			height = h;
		}
	}
	*out_height = height;
	return best;
}

/* Outside a convex polygon the nearest feature is the best face or one of its two ends. */
static nearest nearest_on_face(const cni_geometry *g, int32_t edge, float height, cni_vec2 center)
{
	const cni_vec2 *p = cni_geometry_points(g);
	int32_t next = edge + 1 < g->count ? edge + 1 : 0;
	nearest near = { cni_geometry_normals(g)[edge], height, CNI_FEATURE_EDGE + edge };
	if (height <= 0.0f)
		return near;
	cni_vec2 along = cni_sub(p[next], p[edge]);
	if (cni_dot(along, cni_sub(center, p[edge])) < 0.0f)
		return nearest_to_point(center, p[edge], near.normal, edge);
	if (cni_dot(along, cni_sub(center, p[next])) > 0.0f)
		return nearest_to_point(center, p[next], near.normal, next);
	return near;
}

void cni_collide_circle_polygon(const cni_manifold_input *in, cni_manifold_cache *cache, cni_manifold *out)
{
	float height;
	cni_vec2 center = cni_untransform_point(in->b_in_a, cni_geometry_points(in->a)[0]);
	int32_t edge = face_find(in->b, center, cache->axis, CNI_TOUCH_PER_SLOP * in->slop, &height);
	cache->axis = (uint8_t)(CN_POLYGON_MAX_VERTICES + 1 + edge);
	out->count = 0;
	if (height - in->a->radius - in->b->radius > in->margin)
		return;
	nearest near = nearest_on_face(in->b, edge, height, center);
	nearest_emit(&near, in, out);
}
