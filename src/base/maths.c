/*
 * base/maths.c - sine, cosine and arctangent from IEEE-exact operations only, so that every platform computes the same bits.
 * Pure functions.
 *
 * Reduction to a quarter turn. Up to 1e4 rad after Cody and Waite (Software Manual for the Elementary
 * Functions, 1980): r = ((x - k A) - k B) - k C with pi/2 = A + B + C. A has 8 significant bits and B
 * has 11; k stays below 2^13, so k A and k B are exact, and so are the first two subtractions (operands
 * within a factor of two, or on a common grid that the result fits). Beyond 1e4, after Payne and Hanek
 * (Radian Reduction for Trigonometric Functions, 1983): the integer significand of x times the 96 relevant
 * bits of 2/pi, without the bits that give multiples of whole turns; exact to 2^-60 for every float.
 *
 * Polynomials are minimax fits (Remez exchange) on slightly more than their interval, leading terms
 * fixed: sine to degree 7 (1.8e-9) and cosine to degree 8 (1e-10) on a quarter turn about 0, arctangent
 * to degree 17 on [0, 1] (7.4e-9). The remaining part of the errors stated in maths.h is float rounding.
 */
#include "base/maths.h"

#define REDUCE_SMALL_MAX_RAD 1.0e4f
#define WRAP_SMALL_MAX_RAD 1.0e5f

#define TWO_OVER_PI 0.636619772f
#define ONE_OVER_TWO_PI 0.159154943f
#define QUARTER_A 1.5703125f
#define QUARTER_B 4.83751297e-4f
#define QUARTER_C 7.54978995e-8f
#define TURN_A 6.28125f
#define TURN_B 1.934051513671875e-3f
#define TURN_C 1.25566589e-6f
/* What the nearest floats to pi/2 and pi exceed them by. */
#define HALF_PI 1.57079633f
#define HALF_PI_EXCESS 4.37113883e-8f
#define PI_EXCESS 8.74227766e-8f
/* The largest float below CNI_PI. */
#define PI_BELOW 3.14159250f

/* Nearest whole number, halves away from zero; |x| < 2^22. */
static int32_t round_near(float x)
{
	return (int32_t)(x < 0.0f ? x - 0.5f : x + 0.5f);
}

/* 2/pi as a fixed-point number with 32 bits before the point. */
static const uint32_t two_over_pi_words[8] = {
	0x00000000u, 0xA2F9836Eu, 0x4E441529u, 0xFC2757D1u, 0xF534DDC0u, 0xDB629599u, 0x3C439041u, 0xFE5163ABu
};

static uint64_t two_over_pi_bits(int32_t start)
{
	int32_t word = start >> 5;
	uint64_t both = (uint64_t)two_over_pi_words[word] << 32 | two_over_pi_words[word + 1];
	return both << (start & 31) >> 32;
}

/* (float)x, rounded alike: compilers for processors without doubles convert 64 bits by functions on doubles, 5 kB of code. */
static float float_of(uint64_t x)
{
	float scale = 4294967296.0f;
	if (x == 0)
		return 0.0f;
	for (; x >> 63 == 0; x <<= 1)
		scale *= 0.5f;
	return (float)((uint32_t)(x >> 32) | (uint32_t)((uint32_t)x != 0)) * scale; /* the last bit stands for all below */
}

/* |x| = m 2^e. Skips the bits of 2/pi that contribute whole turns to m 2^e 2/pi. The product's two bits before the point are
   then the quarter, the bits after it the rest. Defined for any bits of x. */
static uint32_t reduce_large(float x, float *rest_rad)
{
	const uint64_t quarter = UINT64_C(1) << 62;
	uint32_t bits = cni_bits_of(x);
	uint64_t m = (bits & 0x7FFFFFu) | 0x800000u;
	int32_t start = (int32_t)(bits >> 23 & 255u) - 150 + 30;
	CNI_ASSERT(start >= 0);
	uint64_t low = m * two_over_pi_bits(start + 64);
	uint64_t middle = m * two_over_pi_bits(start + 32) + (low >> 32);
	uint64_t high = m * two_over_pi_bits(start) + (middle >> 32);
	uint64_t fixed = high << 32 | (middle & 0xFFFFFFFFu);
	uint64_t k = (fixed + quarter / 2) >> 62;
	fixed -= k << 62;
	/* 2^-62 pi/2, on the magnitude of the two's complement rest. */
	float rest = float_of(fixed >> 63 ? 0 - fixed : fixed) * 3.40612158e-19f;
	if (fixed >> 63)
		rest = -rest;
	*rest_rad = bits >> 31 ? -rest : rest;
	return (uint32_t)(bits >> 31 ? 4 - k : k) & 3u;
}

/* x = rest + k pi/2 up to whole turns; |rest| <= pi/4 + 5e-4. Returns k modulo 4. */
static uint32_t reduce_quarter(float x, float *rest_rad)
{
	if (!(cni_abs(x) <= REDUCE_SMALL_MAX_RAD))
		return reduce_large(x, rest_rad);
	int32_t k = round_near(x * TWO_OVER_PI);
	float kf = (float)k;
	*rest_rad = ((x - kf * QUARTER_A) - kf * QUARTER_B) - kf * QUARTER_C;
	return (uint32_t)k & 3u;
}

cni_rot cni_sincos(float angle_rad)
{
	float r, u, s, c;
	cni_rot q = { 1.0f, angle_rad };
	if (cni_abs(angle_rad) <= CNI_TINY_RAD)
		return q;
	uint32_t quarter = reduce_quarter(angle_rad, &r);
	u = r * r;
	s = r + r * u * (CNI_SINE_3 + u * (CNI_SINE_5 + u * CNI_SINE_7));
	c = 1.0f + (u * u * (CNI_COSINE_4 + u * (CNI_COSINE_6 + u * CNI_COSINE_8)) - 0.5f * u);
	q.c = quarter & 1u ? s : c;
	q.s = quarter & 1u ? c : s;
	if (quarter == 1u || quarter == 2u)
		q.c = -q.c;
	if (quarter >= 2u)
		q.s = -q.s;
	return q;
}

/* t in [0, 1]. */
static float atan_unit(float t)
{
	float u = t * t;
	float p = 0.00262224954f;
	p = p * u - 0.0151325585f;
	p = p * u + 0.0411219038f;
	p = p * u - 0.0736671016f;
	p = p * u + 0.10573934f;
	p = p * u - 0.141859755f;
	p = p * u + 0.199903965f;
	p = p * u - 0.333329856f;
	return t + t * u * p;
}

float cni_atan2(float y, float x)
{
	float ax = cni_abs(x);
	float ay = cni_abs(y);
	float larger = cni_max(ax, ay);
	float r, angle;
	if (larger == 0.0f)
		return 0.0f;
	r = atan_unit(cni_min(ax, ay) / larger);
	if (ay > ax)
		angle = x < 0.0f ? HALF_PI + (r - HALF_PI_EXCESS) : HALF_PI - (r + HALF_PI_EXCESS);
	else
		angle = x < 0.0f ? CNI_PI - (r + PI_EXCESS) : r;
	if (!(y < 0.0f))
		return angle;
	/* An angle just above -pi must not round to -pi, which is not in the range. */
	return angle < CNI_PI ? -angle : -PI_BELOW;
}

/* Sine and cosine polynomials are fitted together with the normalisation. The normalisation corrects the length, so the fit
   may trade radial error (the cosine's quadratic term is not 1/2) for angular error. It is weighted to be tight below
   0.25 rad, the range of substeps. Errors: 6.1e-7 up to 0.25, 1.7e-4 at 1; length within 6e-8 before rounding. Normalisation
   to first order: 1/sqrt(n) = (3 - n)/2 about n = 1. */
cni_rot cni_rot_small(float angle_rad)
{
	cni_rot q;
	if (!(cni_abs(angle_rad) <= 1.0f))
		return cni_sincos(angle_rad);
	float u = angle_rad * angle_rad;
	float s = angle_rad + angle_rad * u * (-0.16665473f + u * 0.0081809414f);
	float c = 1.0f + u * (-0.499886758f + u * 0.0404636746f);
	float k = 1.5f - 0.5f * (c * c + s * s);
	q.c = k * c;
	q.s = k * s;
	return q;
}

/* The difference to the nearest multiple of a turn: |result| <= pi + 0.02. Same splitting as for a quarter turn; k < 2^14,
   and both leading parts have 8 bits. */
static float wrap_near(float a)
{
	float k, r;
	if (cni_abs(a) <= WRAP_SMALL_MAX_RAD) {
		k = (float)round_near(a * ONE_OVER_TWO_PI);
		return ((a - k * TURN_A) - k * TURN_B) - k * TURN_C;
	}
	uint32_t quarter = reduce_large(a, &r);
	switch (quarter) {
	case 1: return HALF_PI + (r - HALF_PI_EXCESS);
	case 2: return r > 0.0f ? -CNI_PI + (r + PI_EXCESS) : CNI_PI + (r - PI_EXCESS);
	case 3: return -HALF_PI + (r + HALF_PI_EXCESS);
	default: return r;
	}
}

float cni_wrap_angle(float a)
{
	float r = a > -CNI_PI && a <= CNI_PI ? a : wrap_near(a);
	if (r > CNI_PI)
		r = ((r - TURN_A) - TURN_B) - TURN_C;
	else if (r <= -CNI_PI)
		r = ((r + TURN_A) + TURN_B) + TURN_C;
	return r;
}
