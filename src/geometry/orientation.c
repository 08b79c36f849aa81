/*
 * geometry/orientation.c - exact orientation of three points in single precision (Shewchuk 1997, "Adaptive precision floating-point
 * arithmetic and fast robust geometric predicates").
 *
 * The determinant in plain floats decides when it exceeds its own error bound. Otherwise the six products of coordinates are added up as
 * an expansion: a sum of floats that do not overlap and grow in size, whose last component that is not 0 has the sign of the whole.
 */
#include "geometry/outline.h"

#define EPSILON 5.9604645e-8f /* 2^-24 */
#define ERROR_BOUND ((3.0f + 16.0f * EPSILON) * EPSILON) /* section 4.3 */
#define SPLITTER 4097.0f /* 2^12 + 1 */

typedef struct pair { float high, low; } pair; /* high + low is exact, high is the rounded value */

static pair two_sum(float a, float b)
{
	float sum = a + b, b_virtual = sum - a, a_virtual = sum - b_virtual;
	pair r = { sum, (a - a_virtual) + (b - b_virtual) };
	return r;
}

/* Two halves of 12 bits (Dekker 1971). */
static pair split(float a)
{
	float c = SPLITTER * a, big = c - a, high = c - big;
	pair r = { high, a - high };
	return r;
}

static pair two_product(float a, float b)
{
	pair x = split(a), y = split(b);
	float product = a * b, e = ((product - x.high * y.high) - x.low * y.high) - x.high * y.low;
	pair r = { product, x.low * y.low - e };
	return r;
}

typedef struct expansion {
	float components[12]; /* smallest first */
	int32_t count;
} expansion;

/* GROW-EXPANSION, figure 6 of the paper. */
static void expansion_add(expansion *e, float value)
{
	float sum = value;
	for (int32_t i = 0; i < e->count; ++i) {
		pair r = two_sum(sum, e->components[i]);
		e->components[i] = r.low;
		sum = r.high;
	}
	e->components[e->count++] = sum;
}

static void expansion_add_product(expansion *e, float a, float b)
{
	pair r = two_product(a, b);
	expansion_add(e, r.low);
	expansion_add(e, r.high);
}

static int32_t orientation_exact(cni_vec2 a, cni_vec2 b, cni_vec2 c)
{
	expansion e;
	e.count = 0;
	expansion_add_product(&e, a.x, b.y);
	expansion_add_product(&e, -a.y, b.x);
	expansion_add_product(&e, b.x, c.y);
	expansion_add_product(&e, -b.y, c.x);
	expansion_add_product(&e, c.x, a.y);
	expansion_add_product(&e, -c.y, a.x);
	for (int32_t i = e.count - 1; i >= 0; --i)
		if (e.components[i] != 0.0f)
			return e.components[i] > 0.0f ? 1 : -1;
	return 0;
}

int32_t cni_orientation(cni_vec2 a, cni_vec2 b, cni_vec2 c)
{
	float left = (a.x - c.x) * (b.y - c.y);
	float right = (a.y - c.y) * (b.x - c.x);
	float determinant = left - right;
	if (cni_abs(determinant) > ERROR_BOUND * (cni_abs(left) + cni_abs(right)) && cni_abs(determinant) > 1.0e-30f)
		return determinant > 0.0f ? 1 : -1;
	return orientation_exact(a, b, c);
}
