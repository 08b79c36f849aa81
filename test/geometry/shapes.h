/*
 * test/geometry/shapes.h - shared by the geometry and collision tests: a local random generator, random records of every
 * type, and slow references in double precision.
 */
#ifndef CAIRN_TEST_SHAPES_H
#define CAIRN_TEST_SHAPES_H

#include "collision/distance.h"
#include "collision/manifold.h"
#include <math.h>
#include <string.h>
#include <stdint.h>

#define SLOP 0.005f
#define TOLERANCE 0.005f
#define CHAIN_MAX 64

typedef struct record {
	cni_geometry g;
	cni_vec2 rest[2 * CHAIN_MAX];
} record;

static uint32_t random_state = 1u;

static inline uint32_t random_bits(void)
{
	random_state ^= random_state << 13;
	random_state ^= random_state >> 17;
	random_state ^= random_state << 5;
	return random_state;
}

static inline float random_in(float low, float high)
{
	return low + (high - low) * (float)(random_bits() >> 8) * (1.0f / 16777216.0f);
}

static inline int32_t random_below(int32_t count) { return (int32_t)(random_bits() >> 4) % count; }

/* Arguments are evaluated in an order that each compiler chooses: numbers of one sequence are not taken in one list of them. */
static inline cni_vec2 random_vec(float reach)
{
	float x = random_in(-reach, reach);
	return cni_v(x, random_in(-reach, reach));
}

static inline cni_transform transform_make(float x, float y, float angle)
{
	cni_transform t;
	t.t = cni_v(x, y);
	t.q.c = (float)cos((double)angle);
	t.q.s = (float)sin((double)angle);
	return t;
}

static inline cni_transform random_transform(float reach, float turn)
{
	cni_vec2 at = random_vec(reach);
	return transform_make(at.x, at.y, random_in(-turn, turn));
}

static inline cni_transform transform_mul(cni_transform a, cni_transform b)
{
	cni_transform x;
	x.q = cni_rot_normalize(cni_rot_mul(a.q, b.q));
	x.t = cni_transform_point(a, b.t);
	return x;
}

static inline cni_transform transform_inverse(cni_transform a)
{
	cni_transform x;
	x.q.c = a.q.c;
	x.q.s = -a.q.s;
	x.t = cni_neg(cni_unrotate(a.q, a.t));
	return x;
}

static inline cni_transform transform_none(void) { return transform_make(0.0f, 0.0f, 0.0f); }

static inline cn_polygon box_polygon(float hx, float hy, float radius)
{
	cn_polygon p = { 4, radius, { { -hx, -hy }, { hx, -hy }, { hx, hy }, { -hx, hy } } };
	return p;
}

static inline void record_box(record *r, float hx, float hy, float radius, cni_transform offset)
{
	cn_polygon p = box_polygon(hx, hy, radius);
	cni_geometry_polygon(&r->g, &p, offset);
}

static inline void record_circle(record *r, float radius)
{
	cn_circle c = { { 0.0f, 0.0f }, radius };
	cni_geometry_circle(&r->g, &c, transform_none());
}

static inline void record_capsule(record *r, float half, float radius)
{
	cn_capsule c = { { -half, 0.0f }, { half, 0.0f }, radius };
	cni_geometry_capsule(&r->g, &c, transform_none());
}

/* A convex polygon inscribed in an ellipse, of random angles far enough apart. */
static inline cn_polygon random_polygon(float size)
{
	cn_polygon p;
	memset(&p, 0, sizeof p);
	float wide = random_in(0.15f, 1.0f) * size, high = random_in(0.15f, 1.0f) * size;
	if (random_below(4) == 0)
		return box_polygon(wide, high, random_below(2) ? 0.0f : 0.2f * size);
	p.count = 3 + random_below(6);
	p.radius_m = random_below(2) ? 0.0f : random_in(0.01f, 0.4f) * size;
	float start = random_in(0.0f, 6.28f);
	for (int32_t i = 0; i < p.count; ++i) {
		float angle = start + 6.2831853f * ((float)i + random_in(-0.3f, 0.3f)) / (float)p.count;
		p.points_m[i] = cni_v(wide * (float)cos((double)angle), high * (float)sin((double)angle));
	}
	return p;
}

/* A record of one of the first four types, of about this size, anywhere in its body. */
static inline void record_random(record *r, int32_t type, float size)
{
	cni_transform offset = random_transform(0.5f * size, 3.0f);
	float length = random_in(0.3f, 1.0f) * size;
	cn_circle circle = { { 0.0f, 0.0f }, random_in(0.2f, 1.0f) * size };
	cn_capsule capsule = { { -length, 0.0f }, { length, 0.0f }, random_in(0.05f, 0.5f) * size };
	cn_edge edge = { { -length, 0.0f }, { length, 0.0f } };
	cn_polygon polygon;
	switch (type) {
	case CN_SHAPE_CIRCLE:
		cni_geometry_circle(&r->g, &circle, offset);
		break;
	case CN_SHAPE_CAPSULE:
		cni_geometry_capsule(&r->g, &capsule, offset);
		break;
	case CN_SHAPE_EDGE:
		cni_geometry_edge(&r->g, &edge, offset);
		break;
	default:
		polygon = random_polygon(size);
		cni_geometry_polygon(&r->g, &polygon, offset);
		break;
	}
}

/* ------------------------------------------------------------------ references in double */

static inline double point_segment(double px, double py, cni_vec2 a, cni_vec2 b)
{
	double ex = (double)b.x - (double)a.x, ey = (double)b.y - (double)a.y;
	double dx = px - (double)a.x, dy = py - (double)a.y;
	double l2 = ex * ex + ey * ey;
	double t = l2 > 0.0 ? (dx * ex + dy * ey) / l2 : 0.0;
	t = t < 0.0 ? 0.0 : t > 1.0 ? 1.0 : t;
	return hypot(dx - t * ex, dy - t * ey);
}

static inline int32_t edge_count(const cni_geometry *g) { return g->count == 2 ? 1 : g->count; }

/* Greatest separation of b's points over the faces of a (both directions for a segment) in double; -1e30
   for a point. */
static inline double faces_separation(const cni_vec2 *a, int32_t na, const cni_vec2 *b, int32_t nb)
{
	double best = -1e30;
	for (int32_t i = 0; i < na && na > 1; ++i) {
		cni_vec2 p = a[i], q = a[(i + 1) % na];
		double nx = (double)q.y - (double)p.y, ny = (double)p.x - (double)q.x, l = hypot(nx, ny), low = 1e30;
		for (int32_t j = 0; j < nb; ++j)
			low = fmin(low, (nx * ((double)b[j].x - (double)p.x) + ny * ((double)b[j].y - (double)p.y)) / l);
		best = fmax(best, low);
	}
	return best;
}

static inline double points_distance(const cni_vec2 *a, int32_t na, const cni_vec2 *b, int32_t nb)
{
	double best = 1e30;
	for (int32_t i = 0; i < na; ++i)
		for (int32_t j = 0; j < nb; ++j) {
			best = fmin(best, point_segment((double)a[i].x, (double)a[i].y, b[j], b[(j + 1) % nb]));
			best = fmin(best, point_segment((double)b[j].x, (double)b[j].y, a[i], a[(i + 1) % na]));
		}
	return best;
}

static inline double turn_double(cni_vec2 a, cni_vec2 b, cni_vec2 c)
{
	return ((double)b.x - (double)a.x) * ((double)c.y - (double)a.y) - ((double)b.y - (double)a.y) * ((double)c.x - (double)a.x);
}

static inline int32_t segments_cross_double(const cni_vec2 p[2], const cni_vec2 q[2])
{
	return turn_double(p[0], p[1], q[0]) * turn_double(p[0], p[1], q[1]) < 0.0
		&& turn_double(q[0], q[1], p[0]) * turn_double(q[0], q[1], p[1]) < 0.0;
}

/* Signed distance of two surfaces: exact when the skeletons are apart, minus the least translation when
   they overlap. */
static inline double reference_separation(const cni_geometry *a, const cni_geometry *b, cni_transform b_in_a)
{
	cni_vec2 pb[CN_POLYGON_MAX_VERTICES];
	const cni_vec2 *pa = cni_geometry_points(a);
	for (int32_t i = 0; i < b->count; ++i)
		pb[i] = cni_transform_point(b_in_a, cni_geometry_points(b)[i]);
	double radii = (double)a->radius + (double)b->radius;
	double faces = fmax(faces_separation(pa, a->count, pb, b->count), faces_separation(pb, b->count, pa, a->count));
	if (faces < 0.0 && faces > -1e29) {
		/* Collinear segments end to end: their faces overlap by rounding only. */
		if (a->count == 2 && b->count == 2 && !segments_cross_double(pa, pb))
			return points_distance(pa, 2, pb, 2) - radii;
		return faces - radii;
	}
	return points_distance(pa, a->count, pb, b->count) - radii;
}

static inline cni_manifold collide(const cni_geometry *a, const cni_geometry *b, int32_t child_b, cni_transform b_in_a, float margin, cni_manifold_cache *cache)
{
	cni_manifold_input in = { a, b, 0, child_b, b_in_a, margin, SLOP };
	cni_manifold_cache none = { 0, { 0, 0, 0 } };
	cni_manifold out = { { 0.0f, 0.0f }, 0, 0, { { { 0.0f, 0.0f }, 0.0f, 0 }, { { 0.0f, 0.0f }, 0.0f, 0 } } };
	cni_manifold_function(a->type, b->type)(&in, cache != NULL ? cache : &none, &out);
	return out;
}

static inline float manifold_depth(const cni_manifold *m)
{
	return m->count == 2 ? cni_min(m->points[0].separation, m->points[1].separation) : m->points[0].separation;
}

#endif
