/*
 * hull_test.c - promises of cni_hull_make against brute force.
 */
#include "geometry/shapes.h"
#include "test.h"

static double outside_most(const cn_polygon *h, const cni_vec2 *points, int32_t count)
{
	double worst = -1e30;
	for (int32_t i = 0; i < count; ++i) {
		double f = faces_separation(h->points_m, h->count, &points[i], 1);
		worst = greater(worst, f);
	}
	return worst;
}

static double area(const cni_vec2 *p, int32_t n)
{
	double sum = 0.0;
	for (int32_t i = 0; i < n; ++i)
		sum += (double)p[i].x * (double)p[(i + 1) % n].y - (double)p[i].y * (double)p[(i + 1) % n].x;
	return 0.5 * sum;
}

static int32_t among(cni_vec2 v, const cni_vec2 *points, int32_t count)
{
	for (int32_t i = 0; i < count; ++i)
		if (points[i].x == v.x && points[i].y == v.y)
			return 1;
	return 0;
}

static void t_random_clouds(void)
{
	double worst = -1e30;
	int32_t foreign = 0, refused = 0, hulls = 0;
	for (int32_t k = 0; k < TEST_SAMPLES(3000); ++k) {
		cni_vec2 points[40];
		int32_t count = 3 + random_below(12);
		for (int32_t i = 0; i < count; ++i)
			points[i] = random_below(2) ? random_vec(1) : cni_v((float)random_below(4), (float)random_below(4));
		cn_polygon h;
		if (cni_hull_make(points, count, TOLERANCE, &h) != NULL)
			continue;
		++hulls;
		refused += cni_check_polygon(&h, TOLERANCE) != NULL;
		CHECK(area(h.points_m, h.count) > 0.0);
		worst = greater(worst, outside_most(&h, points, count));
		for (int32_t i = 0; i < h.count; ++i)
			foreign += !among(h.points_m[i], points, count);
	}
	CHECK_GE("hulls made", hulls, TEST_SAMPLES(2500), "");
	CHECK_LE("farthest point outside", worst, 0.005, "m");
	CHECK_LE("vertices that are no input point", foreign, 0, "");
	CHECK_LE("hulls that the check refuses", refused, 0, "");
}

/* Brute force: i -> j is a hull edge when all points are on its left. */
static double brute_area(const cni_vec2 *p, int32_t n)
{
	double sum = 0.0;
	for (int32_t i = 0; i < n; ++i)
		for (int32_t j = 0; j < n; ++j) {
			int32_t all = i != j;
			for (int32_t k = 0; k < n && all; ++k)
				all = k == i || k == j || ((double)p[j].x - (double)p[i].x) * ((double)p[k].y - (double)p[i].y) - ((double)p[j].y - (double)p[i].y) * ((double)p[k].x - (double)p[i].x) > 0.0;
			if (all)
				sum += (double)p[i].x * (double)p[j].y - (double)p[i].y * (double)p[j].x;
		}
	return 0.5 * sum;
}

static void t_area_of_clouds(void)
{
	double worst = 0.0, worst_many = 0.0;
	for (int32_t k = 0; k < 300; ++k) {
		cni_vec2 points[200];
		int32_t count = 20 + random_below(180);
		for (int32_t i = 0; i < count; ++i) {
			float angle = random_in(0.0f, 6.2831853f), r = (float)sqrt((double)random_in(0.0f, 1.0f));
			points[i] = k & 1 ? random_vec(1) : cni_v(r * (float)cos((double)angle), r * (float)sin((double)angle));
		}
		cn_polygon h;
		REQUIRE(cni_hull_make(points, count, TOLERANCE, &h) == NULL);
		double loss = 1.0 - area(h.points_m, h.count) / brute_area(points, count);
		if (h.count < CN_POLYGON_MAX_VERTICES)
			worst = greater(worst, loss);
		else
			worst_many = greater(worst_many, loss);
	}
	CHECK_LE("area lost, hulls that fit", worst, 0.001, "share");
	CHECK_LE("area lost, hulls of more than 16 vertices", worst_many, 0.02, "share");
}

static void t_simplified_circle(void)
{
	static cni_vec2 points[65536];
	for (int32_t i = 0; i < 65536; ++i)
		points[i] = cni_v((float)cos(6.283185307179586 * i / 65536.0), (float)sin(6.283185307179586 * i / 65536.0));
	cn_polygon h;
	REQUIRE(cni_hull_make(points, 65536, TOLERANCE, &h) == NULL);
	CHECK(h.count == 16);
	/* The best inscribed 16-gon has 97.4% of the disc. */
	CHECK_GE("area share of the disc", area(h.points_m, h.count) / 3.14159265358979, 0.973, "");
	CHECK(cni_hull_make(points, 65537, TOLERANCE, &h) != NULL);
}

static void t_degenerate_clouds(void)
{
	cn_polygon h;
	cni_vec2 same[5] = { { 1, 1 }, { 1, 1 }, { 1, 1 }, { 1, 1 }, { 1, 1 } };
	CHECK(cni_hull_make(same, 5, TOLERANCE, &h) != NULL);
	cni_vec2 line[5] = { { 0, 0 }, { 1, 1 }, { 2, 2 }, { 3, 3 }, { 10, 10 } };
	CHECK(cni_hull_make(line, 5, TOLERANCE, &h) != NULL);
	CHECK(cni_hull_make(line, 2, TOLERANCE, &h) != NULL);
	cni_vec2 bad[4] = { { 0, 0 }, { 1, 0 }, { 0, 1 }, { (float)NAN, 0 } };
	CHECK(cni_hull_make(bad, 4, TOLERANCE, &h) != NULL);
	bad[3].x = (float)INFINITY;
	CHECK(cni_hull_make(bad, 4, TOLERANCE, &h) != NULL);
	cni_vec2 grid[25];
	for (int32_t i = 0; i < 25; ++i)
		grid[i] = cni_v((float)(i % 5), (float)(i / 5));
	REQUIRE(cni_hull_make(grid, 25, TOLERANCE, &h) == NULL);
	CHECK(h.count == 4);
	cni_vec2 near[6] = { { 0, 0 }, { 1, 0 }, { 1.001f, 0.001f }, { 1, 1 }, { 0.5f, 1.0002f }, { 0, 1 } };
	REQUIRE(cni_hull_make(near, 6, TOLERANCE, &h) == NULL);
	CHECK(h.count == 4);
	CHECK(cni_check_polygon(&h, TOLERANCE) == NULL);
}

static void t_far_from_the_origin(void)
{
	int32_t refused = 0;
	for (int32_t k = 0; k < 500; ++k) {
		cni_vec2 points[30];
		for (int32_t i = 0; i < 30; ++i)
			points[i] = cni_v(50000.0f + random_in(-1, 1), -20000.0f + random_in(-1, 1));
		cn_polygon h;
		refused += cni_hull_make(points, 30, TOLERANCE, &h) != NULL;
	}
	CHECK_LE("hulls 50 km away that fail", refused, 0, "");
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(t_random_clouds);
	RUN(t_area_of_clouds);
	RUN(t_simplified_circle);
	RUN(t_degenerate_clouds);
	RUN(t_far_from_the_origin);
	return test_end();
}
