/*
 * test/collision/distance_test.c - closest points against slow references in double precision.
 */
#include "geometry/shapes.h"
#include "test.h"

static cni_proxy_points set_of(const record *r, cni_vec2 storage[2]) { return cni_geometry_proxy(&r->g, 0, storage); }

static void t_segments(void)
{
	double worst = 0.0, worst_points = 0.0;
	for (int32_t k = 0; k < TEST_SAMPLES(20000); ++k) {
		cni_vec2 p[4];
		for (int32_t i = 0; i < 4; ++i)
			p[i] = random_below(3) ? random_vec(1) : cni_v((float)random_below(3), (float)random_below(3));
		cni_segment_distance s = cni_segment_to_segment(p[0], p[1], p[2], p[3]);
		double d = sqrt((double)s.distance_sq), best = 1e30;
		for (int32_t i = 0; i <= 400; ++i) {
			double t = i / 400.0;
			best = fmin(best, point_segment((double)p[0].x + t * ((double)p[1].x - (double)p[0].x), (double)p[0].y + t * ((double)p[1].y - (double)p[0].y), p[2], p[3]));
		}
		best = fmin(best, points_distance(p, 2, p + 2, 2));
		worst = greater(worst, d - best);
		worst_points = greater(worst_points, fabs((double)cni_length(cni_sub(s.point_b, s.point_a)) - d));
		worst_points = greater(worst_points, point_segment((double)s.point_a.x, (double)s.point_a.y, p[0], p[1]));
		worst_points = greater(worst_points, point_segment((double)s.point_b.x, (double)s.point_b.y, p[2], p[3]));
		CHECK(s.fraction_a >= 0.0f && s.fraction_a <= 1.0f && s.fraction_b >= 0.0f && s.fraction_b <= 1.0f);
	}
	CHECK_LE("farther than the best of 400 samples by", worst, 1e-6, "m");
	CHECK_LE("points off their segments", worst_points, 1e-6, "m");
}

static void t_shapes_apart_and_overlapping(void)
{
	double worst = 0.0, worst_points = 0.0, worst_normal = 0.0;
	int32_t apart = 0, overlapping = 0, wrong = 0;
	for (int32_t k = 0; k < TEST_SAMPLES(60000); ++k) {
		record a, b;
		cni_vec2 storage[2];
		float size = k % 3 == 0 ? 0.01f : k % 3 == 1 ? 1.0f : 50.0f;
		record_random(&a, random_below(4), size);
		record_random(&b, random_below(4), size);
		cni_transform x = transform_make(random_in(-3, 3) * size, random_in(-3, 3) * size, random_below(3) ? random_in(-3, 3) : 1.5707963f);
		cni_closest d = cni_distance(set_of(&a, storage), set_of(&b, storage), x);
		double radii = (double)a.g.radius + (double)b.g.radius;
		double reference = reference_separation(&a.g, &b.g, x);
		if (reference + radii < 1e-5 * (double)size) {
			++overlapping;
			wrong += reference + radii < -1e-5 * (double)size && !(d.distance == 0.0f && d.normal.x == 0.0f && d.normal.y == 0.0f);
			continue;
		}
		++apart;
		worst = greater(worst, fabs((double)d.distance - reference) / (double)size);
		worst_normal = greater(worst_normal, fabs((double)cni_length(d.normal) - 1.0));
		cni_vec2 gap = cni_sub(d.point_b, d.point_a);
		worst_points = greater(worst_points, (double)cni_length(cni_sub(gap, cni_mul(d.distance, d.normal))) / (double)size);
	}
	CHECK_GE("pairs apart", apart, TEST_SAMPLES(10000), "");
	CHECK_GE("pairs overlapping", overlapping, TEST_SAMPLES(1000), "");
	CHECK_LE("overlaps not seen", wrong, 0, "");
	CHECK_LE("distance error over size", worst, 3e-6, "");
	CHECK_LE("normal length error", worst_normal, 1e-6, "");
	CHECK_LE("points do not span the distance, over size", worst_points, 1e-5, "");
}

static void t_radius_and_coincidence(void)
{
	record a, b;
	cni_vec2 storage[2];
	record_circle(&a, 1.0f);
	record_circle(&b, 0.5f);
	cni_closest d = cni_distance(set_of(&a, storage), set_of(&b, storage), transform_make(1.2f, 0, 0));
	CHECK_LE("negative when radii overlap", fabs((double)d.distance + 0.3), 1e-6, "m");
	CHECK(d.normal.x == 1.0f && d.normal.y == 0.0f);
	d = cni_distance(set_of(&a, storage), set_of(&b, storage), transform_none());
	CHECK(d.distance == 0.0f && d.normal.x == 0.0f && d.normal.y == 0.0f);
	record_box(&a, 1, 1, 0, transform_none());
	d = cni_distance(set_of(&a, storage), set_of(&a, storage), transform_none());
	CHECK(d.distance == 0.0f && cni_is_finite2(d.point_a));
	d = cni_distance(set_of(&a, storage), set_of(&a, storage), transform_make(2.0f, 0.0f, 0.0f));
	CHECK_LE("touching boxes", fabs((double)d.distance), 1e-6, "m");
}

static void t_chain_child_points(void)
{
	record r;
	cni_vec2 points[3] = { { 0, 0 }, { 1, 0 }, { 1, 2 } }, storage[2];
	cn_chain chain = { points, 3, 1 };
	cni_geometry_chain(&r.g, &chain, transform_none());
	cni_proxy_points set = cni_geometry_proxy(&r.g, 2, storage);
	CHECK(set.count == 2 && set.radius == 0.0f);
	CHECK(set.points[0].y == 2.0f && set.points[1].x == 0.0f && set.points[1].y == 0.0f);
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(t_segments);
	RUN(t_shapes_apart_and_overlapping);
	RUN(t_radius_and_coincidence);
	RUN(t_chain_child_points);
	return test_end();
}
