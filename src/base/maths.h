/*
 * base/maths.h - vectors, rotations and boxes; sine, cosine and arctangent with the same bits on every platform (only
 * IEEE-exact operations: + - * / sqrt). min and max have a fixed operand order: cni_min(a, b) is a < b ? a : b.
 */
#ifndef CNI_BASE_MATHS_H
#define CNI_BASE_MATHS_H

#include "base/config.h"
#include "cairn.h"
#include <math.h>
#include <string.h>

#define CNI_PI 3.14159265358979f

typedef cn_vec2 cni_vec2;
typedef struct cni_rot { float c, s; } cni_rot;

static inline float cni_min(float a, float b) { return a < b ? a : b; }
static inline float cni_max(float a, float b) { return a > b ? a : b; }
static inline float cni_clamp(float x, float lower, float upper) { return x < lower ? lower : (x > upper ? upper : x); }
static inline float cni_abs(float x) { return fabsf(x); }
static inline float cni_sqrt(float x) { return sqrtf(x); }
static inline int32_t cni_min_i(int32_t a, int32_t b) { return a < b ? a : b; }
static inline int32_t cni_max_i(int32_t a, int32_t b) { return a > b ? a : b; }

static inline cni_vec2 cni_v(float x, float y) { cni_vec2 v; v.x = x; v.y = y; return v; }
static inline cni_vec2 cni_add(cni_vec2 a, cni_vec2 b) { return cni_v(a.x + b.x, a.y + b.y); }
static inline cni_vec2 cni_sub(cni_vec2 a, cni_vec2 b) { return cni_v(a.x - b.x, a.y - b.y); }
static inline cni_vec2 cni_neg(cni_vec2 a) { return cni_v(-a.x, -a.y); }
static inline cni_vec2 cni_mul(float s, cni_vec2 a) { return cni_v(s * a.x, s * a.y); }
static inline cni_vec2 cni_madd(cni_vec2 a, float s, cni_vec2 b) { return cni_v(a.x + s * b.x, a.y + s * b.y); }
static inline cni_vec2 cni_lerp(cni_vec2 a, cni_vec2 b, float t) { return cni_v(a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)); }
static inline float cni_dot(cni_vec2 a, cni_vec2 b) { return a.x * b.x + a.y * b.y; }
static inline float cni_cross(cni_vec2 a, cni_vec2 b) { return a.x * b.y - a.y * b.x; }
static inline cni_vec2 cni_left_perp(cni_vec2 a) { return cni_v(-a.y, a.x); }  /* a turned by +90 degrees: cross(1, a) */
static inline cni_vec2 cni_right_perp(cni_vec2 a) { return cni_v(a.y, -a.x); }
static inline float cni_length_sq(cni_vec2 a) { return a.x * a.x + a.y * a.y; }
static inline float cni_length(cni_vec2 a) { return cni_sqrt(cni_length_sq(a)); }
static inline float cni_distance_sq(cni_vec2 a, cni_vec2 b) { return cni_length_sq(cni_sub(b, a)); }
/* (0, 0) stays (0, 0). */
static inline cni_vec2 cni_normalize(cni_vec2 a)
{
	float length = cni_length(a);
	return length > 0.0f ? cni_v(a.x / length, a.y / length) : a;
}

static inline cni_vec2 cni_rotate(cni_rot q, cni_vec2 v) { return cni_v(q.c * v.x - q.s * v.y, q.s * v.x + q.c * v.y); }
static inline cni_vec2 cni_unrotate(cni_rot q, cni_vec2 v) { return cni_v(q.c * v.x + q.s * v.y, q.c * v.y - q.s * v.x); }
/* Rotation by b after a. */
static inline cni_rot cni_rot_mul(cni_rot a, cni_rot b) { cni_rot q; q.c = a.c * b.c - a.s * b.s; q.s = a.s * b.c + a.c * b.s; return q; }
/* b relative to a: inverse(a) * b. */
static inline cni_rot cni_rot_between(cni_rot a, cni_rot b) { cni_rot q; q.c = a.c * b.c + a.s * b.s; q.s = a.c * b.s - a.s * b.c; return q; }
static inline cni_rot cni_rot_normalize(cni_rot q)
{
	float length = cni_sqrt(q.c * q.c + q.s * q.s);
	cni_rot r = { q.c / length, q.s / length };
	return r;
}

/* x = R p + t */
typedef struct cni_transform { cni_rot q; cni_vec2 t; } cni_transform;
static inline cni_vec2 cni_transform_point(cni_transform x, cni_vec2 p) { return cni_add(cni_rotate(x.q, p), x.t); }
static inline cni_vec2 cni_untransform_point(cni_transform x, cni_vec2 p) { return cni_unrotate(x.q, cni_sub(p, x.t)); }
static inline cni_transform cni_identity(void)
{
	cni_transform x = { { 1.0f, 0.0f }, { 0.0f, 0.0f } };
	return x;
}
/* Where on the segment from a along edge the point nearest to p is: 0 at a (also if edge is 0) to 1. */
static inline float cni_segment_fraction(cni_vec2 p, cni_vec2 a, cni_vec2 edge)
{
	float length_sq = cni_length_sq(edge);
	return length_sq > 0.0f ? cni_clamp(cni_dot(cni_sub(p, a), edge) / length_sq, 0.0f, 1.0f) : 0.0f;
}
static inline cni_vec2 cni_segment_nearest(cni_vec2 p, cni_vec2 a, cni_vec2 edge) { return cni_madd(a, cni_segment_fraction(p, a, edge), edge); }

typedef struct cni_aabb { float x0, y0, x1, y1; } cni_aabb;
static inline int32_t cni_aabb_overlap(const cni_aabb *a, const cni_aabb *b)
{
	return a->x0 <= b->x1 && b->x0 <= a->x1 && a->y0 <= b->y1 && b->y0 <= a->y1;
}
/* Without branches, where results are unpredictable. */
static inline int32_t cni_aabb_overlap_branchless(const cni_aabb *a, const cni_aabb *b)
{
	return (a->x0 <= b->x1) & (b->x0 <= a->x1) & (a->y0 <= b->y1) & (b->y0 <= a->y1);
}
static inline int32_t cni_aabb_contains(const cni_aabb *outer, const cni_aabb *inner)
{
	return outer->x0 <= inner->x0 && outer->y0 <= inner->y0 && inner->x1 <= outer->x1 && inner->y1 <= outer->y1;
}
/* The box of the segment from a to b. */
static inline cni_aabb cni_aabb_of_segment(cni_vec2 a, cni_vec2 b)
{
	cni_aabb box = { cni_min(a.x, b.x), cni_min(a.y, b.y), cni_max(a.x, b.x), cni_max(a.y, b.y) };
	return box;
}
static inline cni_aabb cni_aabb_union(const cni_aabb *a, const cni_aabb *b)
{
	cni_aabb u = { cni_min(a->x0, b->x0), cni_min(a->y0, b->y0), cni_max(a->x1, b->x1), cni_max(a->y1, b->y1) };
	return u;
}
static inline cni_aabb cni_aabb_with_point(cni_aabb box, cni_vec2 p)
{
	cni_aabb u = { cni_min(p.x, box.x0), cni_min(p.y, box.y0), cni_max(p.x, box.x1), cni_max(p.y, box.y1) };
	return u;
}
static inline cni_aabb cni_aabb_of(cni_vec2 lower, cni_vec2 upper)
{
	cni_aabb box = { lower.x, lower.y, upper.x, upper.y };
	return box;
}
/* The box with a margin on all sides. */
static inline cni_aabb cni_box_fatten(cni_aabb box, float margin)
{
	cni_aabb fat = { box.x0 - margin, box.y0 - margin, box.x1 + margin, box.y1 + margin };
	return fat;
}
static inline cni_aabb cni_box_moved(cni_aabb box, cni_vec2 by)
{
	cni_aabb moved = { box.x0 + by.x, box.y0 + by.y, box.x1 + by.x, box.y1 + by.y };
	return moved;
}
/* A box that overlaps nothing, also not itself. */
static inline cni_aabb cni_no_box(void)
{
	cni_aabb box = { INFINITY, INFINITY, -INFINITY, -INFINITY };
	return box;
}

/* The bits of a float, and back. */
static inline uint32_t cni_bits_of(float x)
{
	uint32_t bits;
	memcpy(&bits, &x, sizeof bits);
	return bits;
}
static inline float cni_float_of(uint32_t bits)
{
	float x;
	memcpy(&x, &bits, sizeof x);
	return x;
}
static inline float cni_sq(float x) { return x * x; }
static inline float cni_inverse_or_zero(float x) { return x > 0.0f ? 1.0f / x : 0.0f; }
/* 1 when neither NaN nor infinite. */
static inline int32_t cni_is_finite(float x) { return x - x == 0.0f; }
static inline int32_t cni_is_finite2(cni_vec2 v) { return cni_is_finite(v.x) && cni_is_finite(v.y); }
/* Clamps a result to the finite floats; NaN becomes 0. */
static inline float cni_saturate(float x) { return x > FLT_MAX ? FLT_MAX : x < -FLT_MAX ? -FLT_MAX : x == x ? x : 0.0f; }

/* Polynomials of sine and cosine on a quarter turn about 0, and where they are not taken: maths.c. */
#define CNI_SINE_3 (-0.166666508f)
#define CNI_SINE_5 0.00833197497f
#define CNI_SINE_7 (-0.000194951994f)
#define CNI_COSINE_4 0.0416666456f
#define CNI_COSINE_6 (-0.00138873642f)
#define CNI_COSINE_8 2.44379917e-05f
#define CNI_TINY_RAD 2.44140625e-4f /* 2^-12: to here sine and cosine round to x and 1, and below some x their polynomials are subnormal, which is slow */
#define CNI_NEAR_RAD 0.75f          /* to here an angle is its own rest */

/* Any finite angle; absolute error of each component <= 1.5e-7. The result is within 1e-6 of unit length, also for angles that are
   not finite. */
cni_rot cni_sincos(float angle_rad);
/* In (-pi, pi]; error <= 3e-7 rad; (0, 0) gives 0. */
float cni_atan2(float y, float x);
/* Rotation by a small angle without range reduction. |angle| <= 1: error < 2e-4; |angle| <= 0.25: < 1e-6; unit length within 3e-7.
   Larger angles use cni_sincos. */
cni_rot cni_rot_small(float angle_rad);
/* The angle in (-pi, pi] equal to a modulo 2 pi; error <= 3e-7 rad for any finite a. */
float cni_wrap_angle(float a);

#endif
