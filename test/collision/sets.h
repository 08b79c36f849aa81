/*
 * test/collision/sets.h - slow reference answers in double precision on convex point sets with a radius:
 * distance, and where one that moves first comes near another one by sphere tracing (steps of the
 * distance that is left).
 */
#ifndef CAIRN_TEST_SETS_H
#define CAIRN_TEST_SETS_H

#include "collision/distance.h"
#include <math.h>

typedef struct double_set {
	double x[CN_POLYGON_MAX_VERTICES], y[CN_POLYGON_MAX_VERTICES];
	double radius;
	int32_t count;
} double_set;

static inline double_set set_of(cni_proxy_points points, cni_transform at)
{
	double_set s;
	s.count = points.count;
	s.radius = (double)points.radius;
	for (int32_t i = 0; i < points.count; ++i) {
		double x = (double)points.points[i].x, y = (double)points.points[i].y;
		s.x[i] = (double)at.q.c * x - (double)at.q.s * y + (double)at.t.x;
		s.y[i] = (double)at.q.s * x + (double)at.q.c * y + (double)at.t.y;
	}
	return s;
}

static inline double to_edge(double px, double py, const double_set *s, int32_t i, double dx, double dy)
{
	int32_t j = (i + 1) % s->count;
	double ax = s->x[i] + dx, ay = s->y[i] + dy, ex = s->x[j] - s->x[i], ey = s->y[j] - s->y[i], l2 = ex * ex + ey * ey;
	double t = l2 > 0.0 ? ((px - ax) * ex + (py - ay) * ey) / l2 : 0.0;
	t = t < 0.0 ? 0.0 : t > 1.0 ? 1.0 : t;
	return hypot(px - ax - t * ex, py - ay - t * ey);
}

static inline double side(const double_set *s, int32_t i, double x, double y)
{
	int32_t j = (i + 1) % s->count;
	return (s->x[j] - s->x[i]) * (y - s->y[i]) - (s->y[j] - s->y[i]) * (x - s->x[i]);
}

static inline int has_inside(const double_set *s, double x, double y)
{
	for (int32_t i = 0; i < s->count; ++i)
		if (side(s, i, x, y) < 0.0)
			return 0;
	return s->count > 2;
}

static inline int edges_cross(const double_set *a, const double_set *b, double dx, double dy)
{
	for (int32_t i = 0; i < a->count && a->count > 1; ++i)
		for (int32_t j = 0; j < b->count && b->count > 1; ++j) {
			int32_t in = (i + 1) % a->count, jn = (j + 1) % b->count;
			if (side(a, i, b->x[j] + dx, b->y[j] + dy) * side(a, i, b->x[jn] + dx, b->y[jn] + dy) < 0.0 &&
			    side(b, j, a->x[i] - dx, a->y[i] - dy) * side(b, j, a->x[in] - dx, a->y[in] - dy) < 0.0)
				return 1;
		}
	return 0;
}

/* Greatest separation over a's faces of b moved by (dx, dy). */
static inline double separation_by(const double_set *a, const double_set *b, double dx, double dy)
{
	double best = -1e300;
	for (int32_t i = 0; i < a->count && a->count > 1; ++i) {
		int32_t j, in = (i + 1) % a->count;
		double low = 1e300;
		for (j = 0; j < b->count; ++j)
			low = fmin(low, -side(a, i, b->x[j] + dx, b->y[j] + dy) / hypot(a->x[in] - a->x[i], a->y[in] - a->y[i]));
		best = fmax(best, low);
	}
	return best;
}

/* Distance of the surfaces with b moved by (dx, dy); minus the depth when the skeletons overlap. */
static inline double distance_of(const double_set *a, const double_set *b, double dx, double dy)
{
	double best = 1e300;
	if (has_inside(a, b->x[0] + dx, b->y[0] + dy) || has_inside(b, a->x[0] - dx, a->y[0] - dy) || edges_cross(a, b, dx, dy))
		return fmax(separation_by(a, b, dx, dy), separation_by(b, a, -dx, -dy)) - a->radius - b->radius;
	for (int32_t i = 0; i < a->count; ++i)
		for (int32_t j = 0; j < b->count; ++j) {
			best = fmin(best, to_edge(a->x[i], a->y[i], b, j, dx, dy));
			best = fmin(best, to_edge(b->x[j] + dx, b->y[j] + dy, a, i, 0.0, 0.0));
		}
	return best - a->radius - b->radius;
}

/* First fraction at which the distance is below `near`, or `until` if it never is. */
static inline double trace(const double_set *a, const double_set *b, double dx, double dy, double near, double until)
{
	double length = hypot(dx, dy), t = 0.0;
	for (int k = 0; k < 100000 && t < until; ++k) {
		double left = distance_of(a, b, t * dx, t * dy) - near;
		if (left < 0.0)
			return t;
		t += fmax(left, 1e-9 * length) / length;
	}
	return until;
}

static inline double set_distance_to_point(const double_set *s, double x, double y, double dx, double dy)
{
	double_set p = { { x }, { y }, 0.0, 1 };
	return distance_of(s, &p, -dx, -dy);
}

#endif
