/* Promises of base/maths.h: errors against the C library's double functions, ranges, special values. */
#include "hooks.h"

#include "base/cpu.h"
#include "base/maths.h"
#if CNI_HAS_WIDE_4
#define CNI_WIDTH 4
#else
#define CNI_WIDTH 1
#endif
#include "base/wide.h"

#include "../test.h"

#include <math.h>

#define PI_D 3.14159265358979323846

static float random_in(uint32_t *state, float lower, float upper)
{
	return lower + (upper - lower) * ((float)(random_next(state) >> 8) * (1.0f / 16777216.0f));
}

static float float_of(uint32_t bits)
{
	float x;

	memcpy(&x, &bits, sizeof x);
	return x;
}

typedef struct worst {
	double component;
	double length;
} worst;

static void sincos_measure(worst *w, float x)
{
	cni_rot q = cni_sincos(x);
	double c = (double)q.c, s = (double)q.s;

	w->component = greater(w->component, greater(fabs(c - cos((double)x)), fabs(s - sin((double)x))));
	w->length = greater(w->length, fabs(sqrt(c * c + s * s) - 1));
	if (!(c == c && s == s))
		w->component = 1;
}

/* Every multiple of a quarter turn (and of its half) with the floats around it: the worst cancellation. */
static void sincos_measure_axes(worst *w, int32_t last)
{
	int32_t k, d;

	for (k = -last; k <= last; ++k) {
		float x = (float)(k * (PI_D / 4));

		for (d = 0; d < 3; ++d)
			x = nextafterf(x, -1e9f);
		for (d = 0; d < 6; ++d, x = nextafterf(x, 1e9f))
			sincos_measure(w, x);
	}
}

static void t_sincos_within_1e4(void)
{
	worst w = {0, 0};
	uint32_t state = 1;
	int32_t i;

	for (i = 0; i < TEST_SAMPLES(1000000); ++i)
		sincos_measure(&w, random_in(&state, -1e4f, 1e4f));
	for (i = 0; i < TEST_SAMPLES(600000); ++i)
		sincos_measure(&w, random_in(&state, -7.0f, 7.0f));
	/* All magnitudes down to denormals. */
	for (i = 0; i < TEST_SAMPLES(400000); ++i) {
		float x = float_of(random_next(&state));

		if (fabsf(x) <= 1e4f)
			sincos_measure(&w, x);
	}
	sincos_measure_axes(&w, 12732);
	sincos_measure(&w, 1e4f);
	sincos_measure(&w, -1e4f);
	CHECK_LE("sine, cosine error, |x| <= 1e4", w.component, 1.5e-7, "");
	CHECK_LE("distance from unit length", w.length, 1e-6, "");
}

static void t_sincos_any_finite(void)
{
	worst w = {0, 0};
	uint32_t state = 2;
	int32_t i;

	for (i = 0; i < TEST_SAMPLES(500000); ++i) {
		float x = float_of((random_next(&state) & 0x80FFFFFFu) | ((0x46u + random_next(&state) % 0x3Au) << 24));

		if (isfinite(x) && fabsf(x) > 1e4f)
			sincos_measure(&w, x);
	}
	for (i = 0; i < TEST_SAMPLES(300000); ++i)
		sincos_measure(&w, random_in(&state, -1e6f, 1e6f));
	sincos_measure(&w, FLT_MAX);
	sincos_measure(&w, -FLT_MAX);
	sincos_measure(&w, nextafterf(1e4f, 1e9f));
	sincos_measure(&w, 16367173.0f * 4722366482869645213696.0f); /* very near a multiple of pi/2 */
	CHECK_LE("sine, cosine error, any finite x", w.component, 1.5e-7, "");
	CHECK_LE("distance from unit length", w.length, 1e-6, "");
}

static void t_sincos_axes_and_garbage(void)
{
	cni_rot q = cni_sincos(0.0f);

	CHECK(q.c == 1.0f && q.s == 0.0f && !signbit(q.s));
	q = cni_sincos(-0.0f);
	CHECK(q.c == 1.0f && q.s == 0.0f);
	q = cni_sincos(1e-30f);
	CHECK(q.c == 1.0f && q.s == 1e-30f);
	q = cni_sincos(INFINITY);
	CHECK_LE("length for infinity", fabsf(sqrtf(q.c * q.c + q.s * q.s) - 1.0f), 1e-6, "from 1");
	q = cni_sincos(NAN);
	CHECK_LE("length for NaN", fabsf(sqrtf(q.c * q.c + q.s * q.s) - 1.0f), 1e-6, "from 1");
}

/* Odd and even symmetry hold bit for bit: mirrored scenes stay mirrored. */
static void t_sincos_is_symmetric(void)
{
	uint32_t state = 3;
	int32_t i, wrong = 0;

	for (i = 0; i < 100000; ++i) {
		float x = random_in(&state, 0.0f, i & 1 ? 10.0f : 1e7f);
		cni_rot a = cni_sincos(x), b = cni_sincos(-x);

		wrong += a.c != b.c || a.s != -b.s;
		wrong += cni_wrap_angle(x) != -cni_wrap_angle(-x) && fabsf(cni_wrap_angle(x)) < CNI_PI;
		a = cni_rot_small(x);
		b = cni_rot_small(-x);
		wrong += a.c != b.c || a.s != -b.s;
	}
	CHECK_LE("angles that are not mirrored", wrong, 0, "");
}

static double atan2_error(float y, float x)
{
	float a = cni_atan2(y, x);

	if (!(a > -CNI_PI && a <= CNI_PI))
		return 10;
	return fabs((double)a - atan2((double)y, (double)x));
}

/* To where polynomials take over sine and cosine are the nearest floats. */
static void t_sincos_of_little_is_exact(void)
{
	float x;
	int wrong = 0, count = 0;
	for (x = 2.6e-4f; x > 1e-38f; x *= x > 2.3e-4f ? 0.99999f : 0.97f, ++count) {
		cni_rot q = cni_sincos(x), back = cni_sincos(-x);
		wrong += q.s != (float)sin((double)x) || q.c != (float)cos((double)x) || back.s != -q.s || back.c != q.c;
	}
	CHECK_GE("angles", count, 10000, "");
	CHECK(wrong == 0);
}

static void t_atan2_error(void)
{
	double w = 0;
	uint32_t state = 4;
	int32_t i;

	for (i = 0; i < TEST_SAMPLES(1000000); ++i)
		w = greater(w, atan2_error(random_in(&state, -1.0f, 1.0f), random_in(&state, -1.0f, 1.0f)));
	for (i = 0; i < TEST_SAMPLES(500000); ++i) {
		double turn = (i - 250000) * (PI_D / 250000.0);

		w = greater(w, i == 0 ? 0 : atan2_error((float)(3 * sin(turn)), (float)(3 * cos(turn))));
	}
	for (i = 0; i < TEST_SAMPLES(500000); ++i) {
		float y = float_of(random_next(&state)), x = float_of(random_next(&state));

		/* A negative y that vanishes beside x still lies above -pi; a y of -0 counts as 0. */
		if (isfinite(x) && isfinite(y))
			w = greater(w, atan2_error(y, x));
	}
	CHECK_LE("atan2 error", w, 3e-7, "rad");
}

static void t_atan2_axes(void)
{
	CHECK(cni_atan2(0.0f, 0.0f) == 0.0f && cni_atan2(-0.0f, -0.0f) == 0.0f);
	CHECK(cni_atan2(0.0f, 2.0f) == 0.0f && cni_atan2(-0.0f, 2.0f) == 0.0f);
	CHECK(cni_atan2(0.0f, -2.0f) == CNI_PI && cni_atan2(-0.0f, -2.0f) == CNI_PI);
	CHECK(cni_atan2(3.0f, 0.0f) == (float)(PI_D / 2) && cni_atan2(3.0f, -0.0f) == (float)(PI_D / 2));
	CHECK(cni_atan2(-3.0f, 0.0f) == -(float)(PI_D / 2));
	CHECK(cni_atan2(-1e-30f, -1.0f) > -CNI_PI && cni_atan2(-1e-45f, -FLT_MAX) > -CNI_PI);
	CHECK_LE("45 degrees", fabs((double)cni_atan2(FLT_MAX, FLT_MAX) - PI_D / 4), 6e-8, "rad");
	CHECK_LE("135 degrees of denormals", fabs((double)cni_atan2(1e-45f, -1e-45f) - 3 * PI_D / 4), 1.2e-7, "rad");
}

static void rot_small_measure(worst *w, float x)
{
	cni_rot q = cni_rot_small(x);
	double c = (double)q.c, s = (double)q.s;

	w->component = greater(w->component, greater(fabs(c - cos((double)x)), fabs(s - sin((double)x))));
	w->length = greater(w->length, fabs(sqrt(c * c + s * s) - 1));
}

static void t_rot_small_error(void)
{
	static const float limits[4] = {0.0625f, 0.25f, 1.0f, 100.0f};
	static const double bounds[4] = {1.5e-7, 1e-6, 2e-4, 2e-4};
	static const char *names[4] = {"error, |a| <= 1/16", "error, |a| <= 1/4", "error, |a| <= 1", "error, |a| <= 100"};
	int32_t i, k;

	for (k = 0; k < 4; ++k) {
		worst w = {0, 0};

		for (i = -TEST_SAMPLES(200000); i <= TEST_SAMPLES(200000); ++i)
			rot_small_measure(&w, limits[k] * ((float)i / TEST_SAMPLES(200000.0f)));
		CHECK_LE(names[k], w.component, bounds[k], "");
		CHECK_LE("distance from unit length", w.length, 3e-7, "");
	}
	CHECK(cni_rot_small(0.0f).c == 1.0f && cni_rot_small(0.0f).s == 0.0f);
}

static double wrap_error(float a)
{
	float r = cni_wrap_angle(a);
	/* Compared through sine and cosine in double, which know about whole turns. */
	double s = sin((double)a), c = cos((double)a);
	double rs = sin((double)r), rc = cos((double)r);

	if (!(r > -CNI_PI && r <= CNI_PI))
		return 10;
	return fabs(atan2(rs * c - rc * s, rc * c + rs * s));
}

static void t_wrap_angle(void)
{
	double w = 0, beyond = 0;
	uint32_t state = 6;
	int32_t i, changed = 0, d;

	for (i = 0; i < TEST_SAMPLES(500000); ++i) {
		float a = random_in(&state, -CNI_PI, CNI_PI);

		w = greater(w, wrap_error(random_in(&state, -1e5f, 1e5f)));
		w = greater(w, wrap_error(random_in(&state, -20.0f, 20.0f)));
		beyond = greater(beyond, wrap_error(random_in(&state, -1e8f, 1e8f)));
		changed += a > -CNI_PI && cni_wrap_angle(a) != a;
	}
	/* Around every odd multiple of pi, where the ends of the range are. */
	for (i = -31829; i <= 31829; i += 2) {
		float a = (float)(i * PI_D);

		for (d = 0; d < 3; ++d)
			a = nextafterf(a, -1e9f);
		for (d = 0; d < 6; ++d, a = nextafterf(a, 1e9f))
			w = greater(w, wrap_error(a));
	}
	CHECK_LE("wrap error, |a| <= 1e5", w, 3e-7, "rad");
	CHECK_LE("wrap error, |a| <= 1e8", beyond, 3e-7, "rad");
	CHECK_LE("wrap error, FLT_MAX", greater(wrap_error(FLT_MAX), wrap_error(-FLT_MAX)), 3e-7, "rad");
	CHECK_LE("angles in range that changed", changed, 0, "");
	CHECK(cni_wrap_angle(CNI_PI) == CNI_PI && cni_wrap_angle(-CNI_PI) > 3.14159f);
}

/* FNV-1a over the bits of many results: one number that must be the same on every compiler and CPU. */
static void t_same_bits_everywhere(void)
{
	uint64_t hash = UINT64_C(14695981039346656037);
	uint32_t state = 2024;
	int32_t i, k;

	for (i = 0; i < 200000; ++i) {
		float x = float_of(random_next(&state)), y = float_of(random_next(&state));
		float small = random_in(&state, -10.0f, 10.0f);
		uint32_t bits[8];
		float results[8];
		cni_rot q;

		if (!isfinite(x) || !isfinite(y))
			continue;
		q = cni_sincos(x);
		results[0] = q.c;
		results[1] = q.s;
		q = cni_sincos(small);
		results[2] = q.c;
		results[3] = q.s;
		q = cni_rot_small(small * 0.1f);
		results[4] = q.c;
		results[5] = q.s;
		results[6] = cni_atan2(y, x);
		results[7] = cni_wrap_angle(x);
		memcpy(bits, results, sizeof bits);
		for (k = 0; k < 8; ++k)
			hash = (hash ^ bits[k]) * UINT64_C(1099511628211);
	}
	printf("       hash of all results: %08x%08x\n", (unsigned)(hash >> 32), (unsigned)hash);
	CHECK(hash == UINT64_C(0x7ac348c6d2a920db));
}

static void t_small_helpers(void)
{
	cni_transform x;
	cni_vec2 p = cni_v(0.3f, -2.0f), r;
	cni_rot a = cni_sincos(0.7f), b = cni_sincos(-2.1f), m;
	cni_aabb box = {0, 0, 2, 2}, inner = {0.5f, 0, 1, 2}, apart = {2.1f, 0, 3, 1}, both;

	CHECK(cni_min(NAN, 1.0f) == 1.0f && isnan(cni_min(1.0f, NAN)));
	CHECK(cni_max(NAN, 1.0f) == 1.0f && isnan(cni_max(1.0f, NAN)));
	CHECK(cni_clamp(5.0f, 0.0f, 1.0f) == 1.0f && cni_clamp(-5.0f, 0.0f, 1.0f) == 0.0f);
	CHECK(cni_is_finite(FLT_MAX) && !cni_is_finite(INFINITY) && !cni_is_finite(NAN) && !cni_is_finite(-INFINITY));
	CHECK(cni_normalize(cni_v(0, 0)).x == 0.0f);
	x.q = a;
	x.t = cni_v(4.0f, 5.0f);
	r = cni_untransform_point(x, cni_transform_point(x, p));
	CHECK_LE("transform and back", cni_length(cni_sub(r, p)), 1e-6, "m");
	m = cni_rot_mul(a, cni_rot_between(a, b));
	CHECK_LE("a * between(a, b) - b", greater((double)fabsf(m.c - b.c), (double)fabsf(m.s - b.s)), 2e-7, "");
	CHECK_LE("angle of a product", fabsf(cni_atan2(cni_rot_mul(a, b).s, cni_rot_mul(a, b).c) + 1.4f), 4e-7, "rad");
	CHECK(cni_cross(cni_v(1, 0), cni_left_perp(cni_v(1, 0))) == 1.0f);
	CHECK(cni_aabb_overlap(&box, &inner) && !cni_aabb_overlap(&box, &apart));
	CHECK(cni_aabb_contains(&box, &inner) && !cni_aabb_contains(&inner, &box));
	both = cni_aabb_union(&box, &apart);
	CHECK(both.x0 == 0.0f && both.x1 == 3.0f && both.y1 == 2.0f);
}

/* Tiny, zero and negative angles side by side: every lane has its own. */
static void t_sincos_of_lanes_has_the_same_bits(void)
{
	CNI_ALIGNED(16) float angles[CNI_WIDTH], c[CNI_WIDTH], s[CNI_WIDTH];
	uint32_t state = 11;
	int32_t i, l, wrong = 0, tiny = 0;
	for (i = 0; i < TEST_SAMPLES(400000); ++i) {
		cni_wide cosine, sine;
		for (l = 0; l < CNI_WIDTH; ++l) {
			float x = i & 1 ? float_of(random_next(&state)) : random_in(&state, -CNI_NEAR_RAD, CNI_NEAR_RAD);
			angles[l] = fabsf(x) <= CNI_NEAR_RAD ? x : i & 2 ? 0.0f : CNI_NEAR_RAD;
			tiny += fabsf(angles[l]) <= CNI_TINY_RAD;
		}
		cni_wide_sincos_near(cni_wide_load(angles), &cosine, &sine);
		cni_wide_store(c, cosine);
		cni_wide_store(s, sine);
		for (l = 0; l < CNI_WIDTH; ++l) {
			cni_rot q = cni_sincos(angles[l]);
			wrong += memcmp(&q.c, &c[l], sizeof q.c) != 0 || memcmp(&q.s, &s[l], sizeof q.s) != 0;
		}
	}
	CHECK_LE("lanes that differ", wrong, 0, "");
	CHECK_GE("tiny angles", tiny, 1000, "");
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(t_sincos_within_1e4);
	RUN(t_sincos_any_finite);
	RUN(t_sincos_axes_and_garbage);
	RUN(t_sincos_is_symmetric);
	RUN(t_sincos_of_little_is_exact);
	RUN(t_sincos_of_lanes_has_the_same_bits);
	RUN(t_atan2_error);
	RUN(t_atan2_axes);
	RUN(t_rot_small_error);
	RUN(t_wrap_angle);
	RUN(t_same_bits_everywhere);
	RUN(t_small_helpers);
	return test_end();
}
