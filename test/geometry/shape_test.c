/*
 * shape_test.c - promises of geometry/shape.h about building, checking, bounds and point tests.
 */
#include "geometry/shapes.h"
#include "test.h"

static void t_record_layout(void)
{
	record r;
	CHECK(sizeof(cni_geometry) == 40 || sizeof(cni_geometry) == 36 || sizeof(cni_geometry) == 32);
	CHECK(cni_geometry_bytes(CN_SHAPE_CIRCLE, 1) == (int32_t)sizeof(cni_geometry) + 8);
	CHECK(cni_geometry_bytes(CN_SHAPE_POLYGON, 4) == (int32_t)sizeof(cni_geometry) + 64);
	CHECK(cni_geometry_bytes(CN_SHAPE_CHAIN, 10) == (int32_t)sizeof(cni_geometry) + 80);
	cni_vec2 points[4] = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } };
	cn_chain chain = { points, 4, 0 };
	cni_geometry_chain(&r.g, &chain, transform_none());
	CHECK(cni_geometry_children(&r.g) == 3);
	chain.loop = 1;
	cni_geometry_chain(&r.g, &chain, transform_none());
	CHECK(cni_geometry_children(&r.g) == 4);
	record_circle(&r, 1.0f);
	CHECK(cni_geometry_children(&r.g) == 1);
}

static void t_polygon_is_counter_clockwise_with_outward_normals(void)
{
	double worst = 0.0;
	for (int32_t k = 0; k < TEST_SAMPLES(2000); ++k) {
		record r;
		cn_polygon p = random_polygon(1.0f);
		cn_polygon reversed = p;
		for (int32_t i = 0; i < p.count; ++i)
			reversed.points_m[i] = p.points_m[p.count - 1 - i];
		cni_geometry_polygon(&r.g, k & 1 ? &reversed : &p, random_transform(2, 3));
		const cni_vec2 *v = cni_geometry_points(&r.g), *n = cni_geometry_normals(&r.g);
		for (int32_t i = 0; i < r.g.count; ++i) {
			worst = greater(worst, fabs((double)cni_length(n[i]) - 1.0));
			for (int32_t j = 0; j < r.g.count; ++j)
				worst = greater(worst, (double)cni_dot(n[i], cni_sub(v[j], v[i])));
		}
		CHECK(cni_geometry_contains(&r.g, r.g.centroid));
	}
	CHECK_LE("normal length and convexity error", worst, 2e-6, "");
}

static void t_header_measures(void)
{
	record r;
	record_box(&r, 2.0f, 1.0f, 0.25f, transform_make(3.0f, 4.0f, 0.0f));
	CHECK_LE("extent", fabs((double)r.g.extent - (hypot(5.0, 5.0) + 0.25)), 1e-6, "m");
	CHECK_LE("inner radius", fabs((double)r.g.inner_radius - 1.25), 1e-6, "m");
	CHECK_LE("centroid", hypot((double)r.g.centroid.x - 3.0, (double)r.g.centroid.y - 4.0), 1e-6, "m");
	cn_edge e = { { 0.0f, 0.0f }, { 2.0f, 2.0f } };
	cni_geometry_edge(&r.g, &e, transform_none());
	CHECK(r.g.inner_radius == 0.0f && r.g.centroid.x == 1.0f && r.g.centroid.y == 1.0f);
}

static void t_segments_look_away_on_both_sides(void)
{
	double worst = 0.0;
	int32_t wrong = 0;
	for (int32_t k = 0; k < TEST_SAMPLES(1000); ++k) {
		record r;
		record_random(&r, random_below(2) ? CN_SHAPE_CAPSULE : CN_SHAPE_EDGE, 1.0f);
		const cni_vec2 *p = cni_geometry_points(&r.g), *n = cni_geometry_normals(&r.g);
		cni_vec2 along = cni_normalize(cni_sub(p[1], p[0]));
		worst = fmax(worst, hypot((double)n[0].x - (double)along.y, (double)n[0].y + (double)along.x));
		wrong += n[1].x != -n[0].x || n[1].y != -n[0].y;
	}
	CHECK_LE("first normal against right of the segment", worst, 1e-6, "");
	CHECK_LE("second normals that are not its opposite", (double)wrong, 0.0, "");
}

static void t_box_is_tight(void)
{
	double worst = 0.0;
	for (int32_t k = 0; k < TEST_SAMPLES(2000); ++k) {
		record r;
		record_random(&r, random_below(4), 1.0f);
		cni_transform x = random_transform(5, 3);
		cni_aabb box = cni_geometry_aabb(&r.g, 0, x);
		double x0 = 1e30, y0 = 1e30, x1 = -1e30, y1 = -1e30, radius = (double)r.g.radius;
		for (int32_t i = 0; i < r.g.count; ++i) {
			cni_vec2 p = cni_transform_point(x, cni_geometry_points(&r.g)[i]);
			x0 = fmin(x0, (double)p.x - radius);
			y0 = fmin(y0, (double)p.y - radius);
			x1 = greater(x1, (double)p.x + radius);
			y1 = greater(y1, (double)p.y + radius);
		}
		worst = greater(worst, greater(greater(fabs(x0 - (double)box.x0), fabs(y0 - (double)box.y0)), greater(fabs(x1 - (double)box.x1), fabs(y1 - (double)box.y1))));
	}
	CHECK_LE("box error", worst, 1e-6, "m");
}

static void t_chain_box_is_of_the_child(void)
{
	record r;
	cni_vec2 points[3] = { { 0, 0 }, { 1, 0 }, { 1, 2 } };
	cn_chain chain = { points, 3, 1 };
	cni_geometry_chain(&r.g, &chain, transform_none());
	cni_aabb b1 = cni_geometry_aabb(&r.g, 1, transform_none()), b2 = cni_geometry_aabb(&r.g, 2, transform_none());
	CHECK(b1.x0 == 1.0f && b1.x1 == 1.0f && b1.y0 == 0.0f && b1.y1 == 2.0f);
	CHECK(b2.x0 == 0.0f && b2.x1 == 1.0f && b2.y0 == 0.0f && b2.y1 == 2.0f);
}

static void t_contains_agrees_with_distance(void)
{
	int32_t wrong = 0, inside_count = 0;
	for (int32_t k = 0; k < TEST_SAMPLES(20000); ++k) {
		record r;
		record_random(&r, random_below(3), 1.0f);
		cni_vec2 p = random_vec(1.5f);
		const cni_vec2 *v = cni_geometry_points(&r.g);
		double d = points_distance(v, r.g.count, &p, 1), faces = faces_separation(v, r.g.count, &p, 1);
		double signed_distance = (r.g.type == CN_SHAPE_POLYGON && faces < 0.0 ? faces : d) - (double)r.g.radius;
		int32_t inside = cni_geometry_contains(&r.g, p);
		inside_count += inside;
		if (fabs(signed_distance) > 1e-5 && inside != (signed_distance < 0.0))
			++wrong;
	}
	CHECK_GE("points inside", inside_count, TEST_SAMPLES(1000), "");
	CHECK_LE("wrong answers", wrong, 0, "");
	record r;
	cn_edge e = { { 0, 0 }, { 1, 0 } };
	cni_geometry_edge(&r.g, &e, transform_none());
	CHECK(!cni_geometry_contains(&r.g, cni_v(0.5f, 0.0f)));
}

static void t_checks_refuse_bad_numbers(void)
{
	float bad[4] = { (float)NAN, (float)INFINITY, -(float)INFINITY, 1.5e6f };
	for (int32_t i = 0; i < 4; ++i) {
		cn_circle c = { { bad[i], 0 }, 1 }, c2 = { { 0, bad[i] }, 1 }, c3 = { { 0, 0 }, bad[i] };
		CHECK(cni_check_circle(&c, TOLERANCE) && cni_check_circle(&c2, TOLERANCE) && cni_check_circle(&c3, TOLERANCE));
		cn_capsule k = { { bad[i], 0 }, { 1, 0 }, 1 }, k2 = { { 0, 0 }, { 1, bad[i] }, 1 }, k3 = { { 0, 0 }, { 1, 0 }, bad[i] };
		CHECK(cni_check_capsule(&k, TOLERANCE) && cni_check_capsule(&k2, TOLERANCE) && cni_check_capsule(&k3, TOLERANCE));
		cn_edge e = { { bad[i], 0 }, { 1, 0 } }, e2 = { { 0, 0 }, { 1, bad[i] } };
		CHECK(cni_check_edge(&e, TOLERANCE) && cni_check_edge(&e2, TOLERANCE));
		cn_polygon p = box_polygon(1, 1, bad[i]), p2 = box_polygon(1, 1, 0);
		p2.points_m[2].y = bad[i];
		CHECK(cni_check_polygon(&p, TOLERANCE) && cni_check_polygon(&p2, TOLERANCE));
		cni_vec2 points[3] = { { 0, 0 }, { 1, bad[i] }, { 2, 0 } };
		cn_chain chain = { points, 3, 0 };
		CHECK(cni_check_chain(&chain, TOLERANCE) != NULL);
	}
}

static void t_checks_refuse_degenerate_shapes(void)
{
	cn_circle circle = { { 0, 0 }, 0 };
	CHECK(cni_check_circle(&circle, TOLERANCE) != NULL);
	circle.radius_m = -1.0f;
	CHECK(cni_check_circle(&circle, TOLERANCE) != NULL);
	circle.radius_m = 0.001f;
	CHECK(cni_check_circle(&circle, TOLERANCE) == NULL);
	cn_capsule capsule = { { 1, 1 }, { 1, 1.004f }, 1 };
	CHECK(cni_check_capsule(&capsule, TOLERANCE) != NULL);
	capsule.b_m.y = 1.01f;
	CHECK(cni_check_capsule(&capsule, TOLERANCE) == NULL);
	capsule.radius_m = 0.0f;
	CHECK(cni_check_capsule(&capsule, TOLERANCE) != NULL);
	cn_edge edge = { { 1, 1 }, { 1, 1 } };
	CHECK(cni_check_edge(&edge, 0.0f) != NULL);
	edge.b_m.x = 2.0f;
	CHECK(cni_check_edge(&edge, TOLERANCE) == NULL);
	cni_vec2 points[4] = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 0.001f } };
	cn_chain chain = { points, 4, 0 };
	CHECK(cni_check_chain(&chain, TOLERANCE) == NULL);
	chain.loop = 1;
	CHECK(cni_check_chain(&chain, TOLERANCE) != NULL);
	chain.loop = 2;
	CHECK(cni_check_chain(&chain, TOLERANCE) != NULL);
	chain.loop = 0;
	chain.count = 1;
	CHECK(cni_check_chain(&chain, TOLERANCE) != NULL);
	chain.points_m = NULL;
	CHECK(cni_check_chain(&chain, TOLERANCE) != NULL);
	cn_chain pair = { points, 2, 1 };
	CHECK(cni_check_chain(&pair, TOLERANCE) != NULL);
}

static void t_polygon_check_finds_what_is_not_convex(void)
{
	cn_polygon box = box_polygon(1, 1, 0), p = box;
	CHECK(cni_check_polygon(&p, TOLERANCE) == NULL);
	p.count = 2;
	CHECK(cni_check_polygon(&p, TOLERANCE) != NULL);
	p.count = 17;
	CHECK(cni_check_polygon(&p, TOLERANCE) != NULL);
	cn_polygon clockwise = { 3, 0, { { 0, 0 }, { 0, 1 }, { 1, 0 } } };
	CHECK(cni_check_polygon(&clockwise, TOLERANCE) == NULL);
	cn_polygon dart = { 4, 0, { { 0, 0 }, { 2, 0 }, { 0.5f, 0.5f }, { 0, 2 } } };
	CHECK(cni_check_polygon(&dart, TOLERANCE) != NULL);
	cn_polygon bow = { 4, 0, { { 0, 0 }, { 1, 1 }, { 1, 0 }, { 0, 1 } } };
	CHECK(cni_check_polygon(&bow, TOLERANCE) != NULL);
	cn_polygon flat = { 4, 0, { { 0, 0 }, { 1, 0 }, { 2, 0 }, { 1, 1 } } };
	CHECK(cni_check_polygon(&flat, TOLERANCE) != NULL);
	cn_polygon twice = { 4, 0, { { 0, 0 }, { 1, 0 }, { 1, 0.001f }, { 0, 1 } } };
	CHECK(cni_check_polygon(&twice, TOLERANCE) != NULL);
	cn_polygon star = { 5, 0, { { 0, 0 } } };
	for (int32_t i = 0; i < 5; ++i)
		star.points_m[i] = cni_v((float)cos(2.0 * 6.283185307 * i / 5.0), (float)sin(2.0 * 6.283185307 * i / 5.0));
	CHECK(cni_check_polygon(&star, TOLERANCE) != NULL);
	cn_polygon coin = { 16, 0, { { 0, 0 } } };
	for (int32_t i = 0; i < 16; ++i)
		coin.points_m[i] = cni_v(0.05f * (float)cos(6.283185307 * i / 16.0), 0.05f * (float)sin(6.283185307 * i / 16.0));
	CHECK(cni_check_polygon(&coin, TOLERANCE) == NULL);
	cn_polygon tiny = box_polygon(0.005f, 0.005f, 0), plank = box_polygon(50.0f, 0.005f, 0);
	CHECK(cni_check_polygon(&tiny, TOLERANCE) == NULL);
	CHECK(cni_check_polygon(&plank, TOLERANCE) == NULL);
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(t_record_layout);
	RUN(t_polygon_is_counter_clockwise_with_outward_normals);
	RUN(t_header_measures);
	RUN(t_segments_look_away_on_both_sides);
	RUN(t_box_is_tight);
	RUN(t_chain_box_is_of_the_child);
	RUN(t_contains_agrees_with_distance);
	RUN(t_checks_refuse_bad_numbers);
	RUN(t_checks_refuse_degenerate_shapes);
	RUN(t_polygon_check_finds_what_is_not_convex);
	return test_end();
}
