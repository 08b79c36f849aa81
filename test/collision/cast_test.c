/*
 * test/collision/cast_test.c - a ray or a moving shape hits a shape exactly at the first contact, reports the outward normal
 * and a point on both surfaces there, and misses only shapes that it does not touch.
 *
 * Checked against sphere tracing in double precision: steps of the remaining distance.
 */
#include "collision/cast.h"
#include "sets.h"
#include "geometry/shapes.h"
#include "test.h"

#include <string.h>

#define EPSILON_RELATIVE 2e-6

/* ------------------------------------------------------------------ the check */

static struct {
	int casts, hits, inside;
	double distance, point_a, point_m, normal, early, missed, way_out, depth;
} seen;

/* Errors are in units of epsilon, the float rounding at the sizes involved. */
static void check_cast(const double_set *a, const double_set *m, cni_vec2 d, int32_t hit, const cni_cast_hit *h, double epsilon)
{
	double dx = (double)d.x, dy = (double)d.y;
	++seen.casts;
	if (!hit) {
		seen.missed += trace(a, m, dx, dy, -epsilon, 2.0) <= 1.0;
		return;
	}
	++seen.hits;
	seen.normal = greater(seen.normal, fabs(hypot((double)h->normal.x, (double)h->normal.y) - 1.0));
	if (h->inside) {
		double out = (double)h->depth, apart = distance_of(a, m, 0.0, 0.0);
		++seen.inside;
		seen.distance = greater(seen.distance, apart / epsilon);
		seen.way_out = greater(seen.way_out, fabs(distance_of(a, m, out * (double)h->normal.x, out * (double)h->normal.y)) / epsilon);
		seen.depth = greater(seen.depth, fabs(out + apart) / epsilon);
		CHECK(h->fraction == 0.0f);
		return;
	}
	CHECK(h->depth == 0.0f);
	double t = (double)h->fraction;
	seen.distance = greater(seen.distance, fabs(distance_of(a, m, t * dx, t * dy)) / epsilon);
	seen.early += trace(a, m, dx, dy, -epsilon, t) < t;
	seen.point_a = greater(seen.point_a, fabs(set_distance_to_point(a, (double)h->point.x, (double)h->point.y, 0.0, 0.0)) / epsilon);
	seen.point_m = greater(seen.point_m, fabs(set_distance_to_point(m, (double)h->point.x, (double)h->point.y, t * dx, t * dy)) / epsilon);
	CHECK(h->fraction >= 0.0f && h->fraction <= 1.0f);
	CHECK((double)h->normal.x * dx + (double)h->normal.y * dy <= 0.0);
	/* A step outward along the normal separates the shapes. */
	CHECK(distance_of(a, m, t * dx + 100.0 * epsilon * (double)h->normal.x, t * dy + 100.0 * epsilon * (double)h->normal.y) > 50.0 * epsilon);
}

static void seen_report(void)
{
	printf("  %d casts: %d hit, %d of them from the start\n", seen.casts, seen.hits, seen.inside);
	CHECK_LE("misses of what is there", seen.missed, 0, "");
	CHECK_LE("hits after the first touch", seen.early, 0, "");
	CHECK_LE("distance of the surfaces at the hit", seen.distance, 1.0, "epsilon");
	CHECK_LE("point off the surface met", seen.point_a, 1.0, "epsilon");
	CHECK_LE("point off the moved surface", seen.point_m, 4.0, "epsilon");
	CHECK_LE("length of the normal off 1", seen.normal, 1e-6, "");
	CHECK_LE("distance after the way out of what was started in", seen.way_out, 1.0, "epsilon");
	CHECK_LE("depth off the shortest way out", seen.depth, 1.0, "epsilon");
}

/* 1 when the ray crosses an edge well between its ends: an edge has no inside, so no distance is negative. */
static int crosses_edge(const double_set *a, const double_set *o, cni_vec2 d, double epsilon)
{
	double ex = a->x[1] - a->x[0], ey = a->y[1] - a->y[0], dx = (double)d.x, dy = (double)d.y;
	double rx = a->x[0] - o->x[0], ry = a->y[0] - o->y[0], c = dx * ey - dy * ex;
	double t = (rx * ey - ry * ex) / c, s = (rx * dy - ry * dx) / c;
	double margin_t = 10.0 * epsilon / hypot(dx, dy), margin_s = 10.0 * epsilon / hypot(ex, ey);
	return fabs(c) > 0.1 * hypot(ex, ey) * hypot(dx, dy) && t > margin_t && t < 1.0 - margin_t && s > margin_s && s < 1.0 - margin_s;
}

static cni_vec2 random_translation(cni_vec2 from, float size)
{
	cni_vec2 target = random_vec(size);
	return cni_mul(random_in(0.3f, 3.0f), cni_sub(target, from));
}

static void random_rays(int32_t count, float size, float distance)
{
	static record a;
	int crossed = 0;
	memset(&seen, 0, sizeof seen);
	for (int32_t k = 0; k < count; ++k) {
		cni_vec2 o = random_vec(distance);
		cni_vec2 d = random_translation(o, size), storage[2], none = { 0.0f, 0.0f };
		cni_proxy_points point = { &none, 1, 0.0f };
		cni_cast_hit h;
		record_random(&a, k % 4, size);
		double_set sa = set_of(cni_geometry_proxy(&a.g, 0, storage), transform_none());
		double_set so = set_of(point, transform_make(o.x, o.y, 0.0f));
		double epsilon = EPSILON_RELATIVE * (double)(size + distance + cni_length(d));
		int32_t hit = cni_cast_ray(&a.g, 0, o, d, &h);
		check_cast(&sa, &so, d, hit, &h, epsilon);
		crossed += a.g.type == CN_SHAPE_EDGE && crosses_edge(&sa, &so, d, epsilon);
		seen.missed += !hit && a.g.type == CN_SHAPE_EDGE && crosses_edge(&sa, &so, d, epsilon);
	}
	printf("  %d edges crossed\n", crossed);
	seen_report();
}

static void t_rays(void)
{
	random_state = 21u;
	random_rays(20000, 1.0f, 3.0f);
	random_rays(4000, 0.01f, 1.0f);
	random_rays(4000, 50.0f, 30.0f);
	random_rays(2000, 1.0f, 3000.0f);
}

static void random_shapes(int32_t count, float size_a, float size_m, float distance)
{
	static record a, b;
	memset(&seen, 0, sizeof seen);
	for (int32_t k = 0; k < count; ++k) {
		cni_vec2 storage[2], storage_m[2];
		record_random(&a, k % 4, size_a);
		record_random(&b, (k / 4) % 3, size_m);
		cni_transform at = random_transform(distance, 3.0f);
		if (k & 16)
			at.q.c = 1.0f, at.q.s = 0.0f;
		cni_vec2 d = random_translation(at.t, size_a + size_m);
		cni_proxy_points moving = cni_geometry_proxy(&b.g, 0, storage_m);
		cni_cast_hit h;
		double_set sa = set_of(cni_geometry_proxy(&a.g, 0, storage), transform_none());
		double_set sm = set_of(moving, at);
		check_cast(&sa, &sm, d, cni_cast_points(&a.g, 0, moving, b.g.centroid, at, d, &h), &h,
			EPSILON_RELATIVE * (double)(size_a + size_m + distance + cni_length(d)));
	}
	seen_report();
}

static void t_moved_shapes(void)
{
	random_state = 22u;
	random_shapes(12000, 1.0f, 1.0f, 3.0f);
	random_shapes(3000, 10.0f, 0.02f, 10.0f);
	random_shapes(3000, 0.05f, 5.0f, 8.0f);
}

/* Equal boxes side by side: parallel faces everywhere. */
static void t_parallel_boxes(void)
{
	static record a, b;
	memset(&seen, 0, sizeof seen);
	random_state = 23u;
	for (int32_t k = 0; k < TEST_SAMPLES(4000); ++k) {
		cni_vec2 storage[2];
		cni_transform at = transform_make((float)(random_below(17) - 8) * 0.5f, (float)(random_below(17) - 8) * 0.5f, 0.0f);
		cni_vec2 d = cni_v((float)(random_below(17) - 8) * 0.5f, (float)(random_below(17) - 8) * 0.5f);
		cni_cast_hit h;
		record_box(&a, 0.5f, 1.0f, k & 1 ? 0.25f : 0.0f, transform_none());
		record_box(&b, 0.5f, 0.5f, k & 2 ? 0.25f : 0.0f, transform_none());
		cni_proxy_points moving = cni_geometry_proxy(&b.g, 0, storage);
		double_set sa = set_of(cni_geometry_proxy(&a.g, 0, storage), transform_none()), sm = set_of(moving, at);
		if (fabs(distance_of(&sa, &sm, 0.0, 0.0)) < 1e-9)
			continue; /* touching at the start may be a hit or not */
		int32_t hit = cni_cast_points(&a.g, 0, moving, b.g.centroid, at, d, &h);
		if (d.x != 0.0f || d.y != 0.0f)
			check_cast(&sa, &sm, d, hit, &h, 2e-5);
	}
	seen_report();
}

/* ------------------------------------------------------------------ closed forms */

static void t_known_answers(void)
{
	static record a;
	cni_cast_hit h;
	cn_edge edge = { { -1.0f, 0.0f }, { 1.0f, 0.0f } };
	record_circle(&a, 1.0f);
	CHECK(cni_cast_ray(&a.g, 0, cni_v(-3.0f, 0.0f), cni_v(4.0f, 0.0f), &h) && h.fraction == 0.5f && h.normal.x == -1.0f && h.point.x == -1.0f);
	CHECK(!cni_cast_ray(&a.g, 0, cni_v(-3.0f, 0.0f), cni_v(1.9f, 0.0f), &h));
	CHECK(!cni_cast_ray(&a.g, 0, cni_v(3.0f, 0.0f), cni_v(4.0f, 0.0f), &h));
	CHECK(cni_cast_ray(&a.g, 0, cni_v(0.5f, 0.0f), cni_v(4.0f, 0.0f), &h) && h.fraction == 0.0f && h.inside && h.normal.x == 1.0f && h.depth == 0.5f);
	/* A translation of 0 hits only shapes that contain the origin. */
	CHECK(cni_cast_ray(&a.g, 0, cni_v(0.5f, 0.0f), cni_v(0.0f, 0.0f), &h) && h.fraction == 0.0f);
	CHECK(!cni_cast_ray(&a.g, 0, cni_v(1.5f, 0.0f), cni_v(0.0f, 0.0f), &h));
	record_box(&a, 1.0f, 1.0f, 0.5f, transform_none());
	CHECK(!cni_cast_ray(&a.g, 0, cni_v(1.4f, 1.4f), cni_v(0.0f, 0.0f), &h)); /* in the corner, outside the rounding */
	CHECK(cni_cast_ray(&a.g, 0, cni_v(1.3f, 1.3f), cni_v(0.0f, 0.0f), &h));
	CHECK(cni_cast_ray(&a.g, 0, cni_v(1.4f, 1.4f), cni_v(-1.0f, -1.0f), &h));
	CHECK_LE("error at the rounded corner", fabs((double)h.fraction - (0.4 - 0.5 / sqrt(2.0))), 1e-6, "");
	/* Along the axis of a capsule: the ray's start is in the planes of both faces. */
	record_capsule(&a, 1.0f, 0.5f);
	CHECK(cni_cast_ray(&a.g, 0, cni_v(-3.5f, 0.0f), cni_v(4.0f, 0.0f), &h) && h.fraction == 0.5f && h.normal.x == -1.0f && h.point.x == -1.5f);
	CHECK(!cni_cast_ray(&a.g, 0, cni_v(-3.5f, 0.0f), cni_v(-4.0f, 0.0f), &h));
	/* An edge is hit from both sides, with its normal against the ray, and never along itself. */
	cni_geometry_edge(&a.g, &edge, transform_none());
	CHECK(cni_cast_ray(&a.g, 0, cni_v(0.0f, 1.0f), cni_v(0.0f, -2.0f), &h) && h.fraction == 0.5f && h.normal.y == 1.0f);
	CHECK(cni_cast_ray(&a.g, 0, cni_v(0.0f, -1.0f), cni_v(0.0f, 2.0f), &h) && h.fraction == 0.5f && h.normal.y == -1.0f);
	CHECK(!cni_cast_ray(&a.g, 0, cni_v(-2.0f, 0.0f), cni_v(4.0f, 0.0f), &h));
	CHECK(!cni_cast_ray(&a.g, 0, cni_v(0.0f, 0.0f), cni_v(0.0f, 0.0f), &h));
}

/* The contact point of two parallel faces is the middle of their overlap. */
static void t_flat_faces_meet_in_their_middle(void)
{
	static record a, b;
	cni_vec2 storage[2];
	cni_cast_hit h;
	record_box(&a, 1.0f, 1.0f, 0.0f, transform_none());
	record_box(&b, 1.0f, 0.5f, 0.0f, transform_none());
	CHECK(cni_cast_points(&a.g, 0, cni_geometry_proxy(&b.g, 0, storage), b.g.centroid, transform_make(1.5f, 3.5f, 0.0f), cni_v(0.0f, -4.0f), &h));
	CHECK_LE("error of the point", fabs((double)h.point.x - 0.75) + fabs((double)h.point.y - 1.0), 1e-6, "m"); /* shared: 0.5 to 1 */
	CHECK(h.fraction == 0.5f && h.normal.y == 1.0f);
}

/* A chain as ground, solid below: rays and shapes hit it from above only. */
static void t_chains_are_one_sided(void)
{
	static record a;
	cn_vec2 points[3] = { { 2.0f, 0.0f }, { 0.0f, 0.0f }, { -2.0f, 1.0f } };
	cn_chain chain = { points, 3, 0 };
	cni_vec2 center = { 0.0f, 0.0f };
	cni_proxy_points ball = { &center, 1, 0.25f };
	cni_vec2 tile[4] = { { 0.0f, 0.0f }, { 1.0f, 0.0f }, { 1.0f, 1.0f }, { 0.0f, 1.0f } };
	cni_cast_hit h;
	cni_geometry_chain(&a.g, &chain, transform_none());
	CHECK(cni_cast_ray(&a.g, 0, cni_v(1.0f, 1.0f), cni_v(0.0f, -4.0f), &h) && h.fraction == 0.25f && h.normal.y == 1.0f);
	CHECK(!cni_cast_ray(&a.g, 0, cni_v(1.0f, -1.0f), cni_v(0.0f, 4.0f), &h));
	CHECK(!cni_cast_ray(&a.g, 1, cni_v(1.0f, 1.0f), cni_v(0.0f, -4.0f), &h));
	CHECK(cni_cast_points(&a.g, 0, ball, center, transform_make(1.0f, 1.25f, 0.0f), cni_v(0.0f, -4.0f), &h) && h.fraction == 0.25f);
	CHECK(!cni_cast_points(&a.g, 0, ball, center, transform_make(1.0f, -1.25f, 0.0f), cni_v(0.0f, 4.0f), &h));
	CHECK(!cni_cast_points(&a.g, 0, ball, center, transform_make(1.0f, 1.25f, 0.0f), cni_v(0.0f, 4.0f), &h));
	CHECK(cni_cast_points(&a.g, 0, ball, center, transform_make(1.0f, 0.2f, 0.0f), cni_v(0.0f, 1.0f), &h) && h.fraction == 0.0f && h.inside && h.normal.y == 1.0f);
	CHECK_LE("error of the depth of a ball in a chain", fabs((double)h.depth - 0.05), 1e-6, "m");
	CHECK(cni_cast_points(&a.g, 0, (cni_proxy_points){ tile, 4, 0.0f }, cni_v(0.5f, 0.5f), transform_make(1.0f, -0.4f, 0.0f), cni_v(0.0f, -1.0f), &h) && h.normal.y == 1.0f && h.depth == 0.4f);
	CHECK(!cni_cast_points(&a.g, 0, ball, center, transform_make(1.0f, -0.2f, 0.0f), cni_v(0.0f, 1.0f), &h));
}

/* Rays aimed exactly at the vertices between the edges of a chain, and anywhere else, never pass. */
static void t_no_ray_slips_between_edges(void)
{
	static record a;
	cn_vec2 points[32];
	cn_chain chain = { points, 32, 0 };
	int slipped = 0;
	random_state = 24u;
	for (int32_t k = 0; k < 400; ++k) {
		for (int32_t i = 0; i < 32; ++i)
			points[i] = cni_v(8.0f - 0.5f * (float)i, random_in(-0.4f, 0.4f));
		cni_geometry_chain(&a.g, &chain, transform_make(random_in(-9.0f, 9.0f), random_in(-9.0f, 9.0f), 0.0f));
		for (int32_t i = 1; i < 31; ++i) {
			cni_vec2 at = cni_geometry_points(&a.g)[i], o = cni_v(at.x + random_in(-0.1f, 0.1f), at.y + 5.0f);
			cni_vec2 d = cni_mul(2.0f, cni_sub(at, o));
			cni_cast_hit h;
			int hits = 0;
			for (int32_t child = 0; child < 31; ++child)
				hits += cni_cast_ray(&a.g, child, o, d, &h);
			slipped += hits == 0;
		}
	}
	CHECK_LE("rays that slipped through", slipped, 0, "of 12000");
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(t_known_answers);
	RUN(t_rays);
	RUN(t_moved_shapes);
	RUN(t_parallel_boxes);
	RUN(t_flat_faces_meet_in_their_middle);
	RUN(t_chains_are_one_sided);
	RUN(t_no_ray_slips_between_edges);
	return test_end();
}
