/*
 * geometry/outline_simplify.c - fewer points within a tolerance (Douglas, Peucker 1973; Ramer 1972).
 *
 * A stretch between two kept points keeps its farthest point from their segment if that is farther than the tolerance, and continues
 * with both halves. The shorter half goes first, so the stack holds at most one stretch for each halving of the count. A closed row
 * begins with two points far apart.
 * O(count * points kept) at worst.
 */
#include "base/bitset.h"
#include "geometry/outline.h"

#include <string.h>

typedef struct stretch { int32_t first, last; } stretch; /* last may be count: point 0 of a closed row */

typedef struct simplifier {
	const cni_vec2 *points;
	int32_t count;
	float tolerance_sq;
	uint64_t kept[CNI_SIMPLIFY_POINTS_MAX / 64]; /* one bit per point */
} simplifier;

static cni_vec2 point_at(const simplifier *s, int32_t i) { return s->points[i < s->count ? i : i - s->count]; }

static float segment_distance_sq(cni_vec2 a, cni_vec2 b, cni_vec2 p)
{
	cni_vec2 along = cni_sub(b, a), d = cni_sub(p, a);
	return cni_length_sq(cni_madd(d, -cni_segment_fraction(p, a, along), along));
}

static int32_t stretch_farthest(const simplifier *s, stretch part)
{
	cni_vec2 a = point_at(s, part.first), b = point_at(s, part.last);
	int32_t farthest = CNI_NONE;
	float most = s->tolerance_sq;
	for (int32_t i = part.first + 1; i < part.last; ++i) {
		float d = segment_distance_sq(a, b, point_at(s, i));
		if (d > most) {
			farthest = i;
			most = d;
		}
	}
	return farthest;
}

static void stretch_simplify(simplifier *s, int32_t first, int32_t last)
{
	stretch stack[32];
	int32_t depth = 0;
	stack[depth].first = first;
	stack[depth++].last = last;
	while (depth > 0) {
		stretch part = stack[--depth];
		int32_t middle = stretch_farthest(s, part);
		if (middle == CNI_NONE)
			continue;
		cni_bit_set(s->kept, middle < s->count ? middle : middle - s->count);
		stretch lower = { part.first, middle }, upper = { middle, part.last };
		int32_t lower_is_longer = middle - part.first > part.last - middle;
		stack[depth++] = lower_is_longer ? lower : upper;
		stack[depth++] = lower_is_longer ? upper : lower;
	}
}

static int32_t kept_write(const simplifier *s, cni_vec2 *out, int32_t capacity)
{
	int32_t written = 0;
	for (int32_t i = 0; i < s->count; ++i) {
		if (!cni_bit_get(s->kept, i))
			continue;
		if (written < capacity)
			out[written] = s->points[i];
		++written;
	}
	return written;
}

int32_t cni_outline_simplify(const cni_vec2 *points, int32_t count, int32_t closed, float tolerance, cni_vec2 *out, int32_t capacity)
{
	simplifier s;
	s.points = points;
	s.count = count;
	s.tolerance_sq = tolerance * tolerance;
	memset(s.kept, 0, sizeof s.kept);
	if (!closed) {
		cni_bit_set(s.kept, 0);
		cni_bit_set(s.kept, count - 1);
		stretch_simplify(&s, 0, count - 1);
		return kept_write(&s, out, capacity);
	}
	int32_t a = cni_point_farthest(points, count, points[0]), b = cni_point_farthest(points, count, points[a]);
	int32_t first = cni_min_i(a, b), last = cni_max_i(a, b);
	cni_bit_set(s.kept, first);
	cni_bit_set(s.kept, last);
	stretch_simplify(&s, first, last);
	stretch_simplify(&s, last, first + count);
	return kept_write(&s, out, 0) >= 3 ? kept_write(&s, out, capacity) : 0;
}
