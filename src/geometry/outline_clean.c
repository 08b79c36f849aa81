/*
 * geometry/outline_clean.c - makes an outline of a user fit for decomposition, or says why it is not.
 *
 * Cleaning removes points nearer than the tolerance to the point kept before, and vertices that rise less than the collinear height
 * above the line through their neighbours, the lowest first. A vertex where the outline turns by more than a right angle is never
 * collinear: a needle stays, and a fold back onto itself is refused. After that all decisions are exact: no two edges share a point
 * other than the vertex between them, so the outline is a simple polygon.
 * O(count^2).
 */
#include "geometry/outline.h"

#define COORDINATE_LEAST 1.0e-12f /* smaller ones become 0: their products would lose bits, and cni_orientation its exactness */

static const char text_few[] = "points must enclose an area: fewer than 3 are left without close and collinear ones";
static const char text_crossing[] = "the outline must not cross or touch itself";

static cni_vec2 point_flush(cni_vec2 p)
{
	return cni_v(cni_abs(p.x) < COORDINATE_LEAST ? 0.0f : p.x, cni_abs(p.y) < COORDINATE_LEAST ? 0.0f : p.y);
}

static int32_t near_remove(const cni_vec2 *points, int32_t count, float tolerance, cni_vec2 *out)
{
	int32_t kept = 0;
	for (int32_t i = 0; i < count; ++i) {
		cni_vec2 p = point_flush(points[i]);
		if (kept == 0 || cni_distance_sq(out[kept - 1], p) >= tolerance * tolerance)
			out[kept++] = p;
	}
	while (kept > 1 && cni_distance_sq(out[kept - 1], out[0]) < tolerance * tolerance)
		--kept;
	return kept;
}

float cni_vertex_height(const cni_vec2 *points, int32_t count, int32_t i)
{
	cni_vec2 before = points[i > 0 ? i - 1 : count - 1];
	cni_vec2 after = points[i + 1 < count ? i + 1 : 0];
	if (!(cni_dot(cni_sub(points[i], before), cni_sub(after, points[i])) > 0.0f))
		return FLT_MAX;
	return cni_abs(cni_cross(cni_sub(points[i], before), cni_normalize(cni_sub(after, before))));
}

static int32_t collinear_remove(cni_vec2 *points, int32_t count, float height_min)
{
	while (count >= 3) {
		int32_t lowest = CNI_NONE;
		float height = height_min;
		for (int32_t i = 0; i < count; ++i) {
			float h = cni_vertex_height(points, count, i);
			if (h <= height && (lowest == CNI_NONE || h < height)) {
				lowest = i;
				height = h;
			}
		}
		if (lowest == CNI_NONE)
			break;
		count = cni_point_remove(points, count, lowest);
	}
	return count;
}

/* 1 if the segments ab and cd have a common point. */
static int32_t segments_meet(cni_vec2 a, cni_vec2 b, cni_vec2 c, cni_vec2 d)
{
	cni_aabb first = cni_aabb_of_segment(a, b), second = cni_aabb_of_segment(c, d);
	if (!cni_aabb_overlap(&first, &second))
		return 0;
	return cni_orientation(a, b, c) * cni_orientation(a, b, d) <= 0 && cni_orientation(c, d, a) * cni_orientation(c, d, b) <= 0;
}

/* A fold back makes an edge meet the one after next; that of three points is removed as collinear. */
static int32_t outline_is_simple(const cni_vec2 *p, int32_t count)
{
	for (int32_t i = 0; i < count; ++i) {
		cni_vec2 a = p[i], b = p[i + 1 < count ? i + 1 : 0];
		for (int32_t j = i + 2; j < count - (i == 0); ++j)
			if (segments_meet(a, b, p[j], p[j + 1 < count ? j + 1 : 0]))
				return 0;
	}
	return 1;
}

/* At the lowest of the leftmost points a simple polygon is convex: 1 counter-clockwise, -1 clockwise, 0 without area. */
static int32_t outline_winding(const cni_vec2 *p, int32_t count)
{
	int32_t first = cni_point_leftmost(p, count);
	return cni_orientation(p[first > 0 ? first - 1 : count - 1], p[first], p[first + 1 < count ? first + 1 : 0]);
}

void cni_points_reverse(cni_vec2 *points, int32_t count)
{
	for (int32_t i = 0, j = count - 1; i < j; ++i, --j) {
		cni_vec2 p = points[i];
		points[i] = points[j];
		points[j] = p;
	}
}

const char *cni_outline_clean(const cni_vec2 *points, int32_t count, float tolerance, cni_vec2 *out, int32_t *out_count)
{
	int32_t kept = near_remove(points, count, tolerance, out);
	kept = collinear_remove(out, kept, cni_collinear_height(out, kept, tolerance));
	if (kept < 3)
		return text_few;
	if (!outline_is_simple(out, kept))
		return text_crossing;
	int32_t winding = outline_winding(out, kept);
	if (winding == 0)
		return text_few;
	if (winding < 0)
		cni_points_reverse(out, kept);
	*out_count = kept;
	return NULL;
}
