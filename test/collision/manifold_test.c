/*
 * test/collision/manifold_test.c - every manifold function except those of chains (chain_test.c), over thousands of random
 * pairs of all sizes, and the special poses of stacks and piles.
 */
#include "geometry/shapes.h"
#include "test.h"

#define MARGIN 0.02f
/* What the axis bias and the face-for-corner tolerance may add up to: 0.1 slop each. */
#define BIAS (0.21 * (double)SLOP)

static const int32_t pair_types[11][2] = { { 0, 0 }, { 0, 1 }, { 0, 2 }, { 0, 3 }, { 1, 1 }, { 1, 2 }, { 1, 3 }, { 2, 2 }, { 2, 3 }, { 3, 3 }, { 2, 2 } };

typedef struct pair {
	record a, b;
	cni_transform b_in_a;
	float size;
} pair;

/* Any two shapes at a distance at which about half of them touch. */
static void pair_random(pair *p, int32_t kind, int32_t k)
{
	static const float sizes[4] = { 0.01f, 0.1f, 1.0f, 50.0f };
	p->size = sizes[k & 3];
	float other = (k & 12) == 0 ? 10.0f * p->size : p->size;
	record_random(&p->a, pair_types[kind][0], p->size);
	record_random(&p->b, pair_types[kind][1], other > 60.0f ? 50.0f : other);
	float angle = random_below(3) == 0 ? 1.57079633f * (float)random_below(4) : random_in(-3.2f, 3.2f);
	float reach = p->a.g.extent + p->b.g.extent;
	float direction = random_in(-3.2f, 3.2f), way = random_in(0.0f, 0.9f) * reach;
	p->b_in_a = transform_make(way * (float)cos((double)direction), way * (float)sin((double)direction), angle);
	/* Half of the pairs are moved along their centroids to within a few margins of contact. */
	if (k & 16) {
		double s = reference_separation(&p->a.g, &p->b.g, p->b_in_a);
		cni_vec2 apart = cni_sub(cni_transform_point(p->b_in_a, p->b.g.centroid), p->a.g.centroid);
		float shift = random_in(-2.0f, 2.0f) * MARGIN - (float)s;
		p->b_in_a.t = cni_madd(p->b_in_a.t, shift, cni_normalize(apart));
	}
}

static cni_transform moved(cni_transform x, float by, cni_vec2 n)
{
	x.t = cni_madd(x.t, by, n);
	return x;
}

static void manifold_check_form(const cni_manifold *m, double *worst_normal, int32_t *wrong)
{
	*wrong += m->count < 0 || m->count > 2;
	if (m->count == 0)
		return;
	*worst_normal = greater(*worst_normal, fabs((double)cni_length(m->normal) - 1.0));
	for (int32_t i = 0; i < m->count; ++i) {
		const cni_manifold_point *p = &m->points[i];
		*wrong += !cni_is_finite2(p->point) || !cni_is_finite(p->separation) || p->id == 0u || p->separation > MARGIN;
		*wrong += (p->id >> 8) == 0u || (p->id & 255u) == 0u || p->id > 0x20ffu || (p->id & 255u) > 32u;
	}
	if (m->count == 2) {
		*wrong += m->points[0].id == m->points[1].id;
		*wrong += cni_dot(cni_left_perp(m->normal), cni_sub(m->points[1].point, m->points[0].point)) <= 0.0f;
	}
}

static void t_form(void)
{
	double worst = 0.0;
	int32_t wrong = 0, touching = 0, double_points = 0;
	for (int32_t k = 0; k < TEST_SAMPLES(60000); ++k) {
		pair p;
		pair_random(&p, k % 11, k / 11);
		cni_manifold m = collide(&p.a.g, &p.b.g, 0, p.b_in_a, MARGIN, NULL);
		manifold_check_form(&m, &worst, &wrong);
		touching += m.count > 0;
		double_points += m.count == 2;
	}
	CHECK_GE("touching", touching, TEST_SAMPLES(20000), "pairs");
	CHECK_GE("with two points", double_points, TEST_SAMPLES(5000), "pairs");
	CHECK_LE("normal length error", worst, 1e-6, "");
	CHECK_LE("broken rules", wrong, 0, "");
}

/* Apart: the exact distance. Overlapping: the least translation. Both up to the bias. */
static void t_separation_is_exact(void)
{
	for (int32_t kind = 0; kind < 11; ++kind) {
		double worst_low = 0.0, worst_high = 0.0;
		int32_t missed = 0, invented = 0, touching = 0;
		for (int32_t k = 0; k < TEST_SAMPLES(8000); ++k) {
			pair p;
			pair_random(&p, kind, k);
			double reference = reference_separation(&p.a.g, &p.b.g, p.b_in_a), noise = 2e-6 * (double)p.size;
			cni_manifold m = collide(&p.a.g, &p.b.g, 0, p.b_in_a, MARGIN, NULL);
			missed += m.count == 0 && reference < (double)MARGIN - BIAS - noise;
			invented += m.count > 0 && reference > (double)MARGIN + BIAS + noise;
			if (m.count == 0)
				continue;
			++touching;
			double error = (double)manifold_depth(&m) - reference;
			worst_low = greater(worst_low, -error - noise);
			worst_high = greater(worst_high, error - noise);
		}
		printf("  types %d and %d: %d touching\n", pair_types[kind][0], pair_types[kind][1], touching);
		CHECK_LE("deeper than the reference", worst_low, BIAS, "m");
		CHECK_LE("shallower than the reference", worst_high, BIAS, "m");
		CHECK_LE("touching pairs missed", missed, 0, "");
		CHECK_LE("contacts invented", invented, 0, "");
	}
}

/* Moving b by the depth along the normal leaves the shapes just touching. */
static void t_normal_resolves(void)
{
	for (int32_t kind = 0; kind < 11; ++kind) {
		double worst_gap = 0.0, worst_overlap = 0.0;
		int32_t count = 0;
		for (int32_t k = 0; k < TEST_SAMPLES(8000); ++k) {
			pair p;
			pair_random(&p, kind, k);
			cni_manifold m = collide(&p.a.g, &p.b.g, 0, p.b_in_a, MARGIN, NULL);
			if (m.count == 0)
				continue;
			++count;
			cni_transform x = moved(p.b_in_a, -manifold_depth(&m), m.normal);
			double after = reference_separation(&p.a.g, &p.b.g, x), noise = 3e-6 * (double)p.size;
			worst_gap = greater(worst_gap, after - noise);
			worst_overlap = greater(worst_overlap, -after - noise);
		}
		printf("  types %d and %d: %d touching\n", pair_types[kind][0], pair_types[kind][1], count);
		CHECK_LE("gap left", worst_gap, BIAS, "m");
		CHECK_LE("overlap left", worst_overlap, BIAS, "m");
	}
}

/* Each point is halfway between the surfaces: within half the separation of both, up to the error of a second, tilted point
   of a rounded shape. */
static void t_points_are_between_the_surfaces(void)
{
	double worst = 0.0;
	for (int32_t k = 0; k < TEST_SAMPLES(40000); ++k) {
		pair p;
		pair_random(&p, k % 11, k / 11);
		cni_manifold m = collide(&p.a.g, &p.b.g, 0, p.b_in_a, MARGIN, NULL);
		for (int32_t i = 0; i < m.count; ++i) {
			if (m.points[i].separation != manifold_depth(&m) || m.points[i].separation < -0.2f * p.size)
				continue;
			cni_vec2 in_b = cni_untransform_point(p.b_in_a, m.points[i].point);
			double da = points_distance(cni_geometry_points(&p.a.g), p.a.g.count, &m.points[i].point, 1) - (double)p.a.g.radius;
			double db = points_distance(cni_geometry_points(&p.b.g), p.b.g.count, &in_b, 1) - (double)p.b.g.radius;
			double half = 0.5 * fabs((double)m.points[i].separation);
			worst = greater(worst, greater(da, db) - half - 2e-6 * (double)p.size);
		}
	}
	CHECK_LE("farther from a surface than half the separation", worst, BIAS, "m");
}

static void t_moving_both_changes_nothing(void)
{
	double worst = 0.0;
	int32_t different = 0, count = 0;
	for (int32_t k = 0; k < TEST_SAMPLES(20000); ++k) {
		/* The same shape built at another offset in its body, with the inverse transform. */
		cn_polygon pa = random_polygon(1.0f), pb = random_polygon(1.0f);
		cni_transform x = random_transform(2, 3);
		cni_transform y = random_transform(1.5f, 3);
		record a0, a1, b;
		cni_geometry_polygon(&a0.g, &pa, transform_none());
		cni_geometry_polygon(&a1.g, &pa, x);
		cni_geometry_polygon(&b.g, &pb, transform_none());
		cni_manifold m0 = collide(&a0.g, &b.g, 0, y, MARGIN, NULL), m1 = collide(&a1.g, &b.g, 0, transform_mul(x, y), MARGIN, NULL);
		count += m0.count > 0;
		if (m0.count != m1.count || (m0.count > 0 && m0.points[0].id != m1.points[0].id)) {
			++different;
			continue;
		}
		if (m0.count == 0)
			continue;
		worst = greater(worst, (double)cni_length(cni_sub(cni_rotate(x.q, m0.normal), m1.normal)));
		for (int32_t i = 0; i < m0.count; ++i) {
			worst = greater(worst, fabs((double)m0.points[i].separation - (double)m1.points[i].separation));
			worst = greater(worst, (double)cni_length(cni_sub(cni_transform_point(x, m0.points[i].point), m1.points[i].point)));
		}
	}
	CHECK_GE("touching", count, TEST_SAMPLES(5000), "pairs");
	CHECK_LE("other features chosen", different, 0.001 * (double)count, "pairs");
	CHECK_LE("difference", worst, 2e-5, "m"); /* rounding of positions up to 4 m away */
}

static uint32_t id_flipped(uint32_t id) { return (id & 255u) << 8 | id >> 8; }

static void t_swapping_roles_gives_the_mirror(void)
{
	static const int32_t same[4] = { 0, 4, 7, 9 };
	double worst = 0.0;
	int32_t count = 0, different = 0;
	for (int32_t k = 0; k < TEST_SAMPLES(20000); ++k) {
		pair p;
		pair_random(&p, same[k & 3], 2 + 4 * (k / 4));
		cni_manifold m = collide(&p.a.g, &p.b.g, 0, p.b_in_a, MARGIN, NULL);
		cni_manifold f = collide(&p.b.g, &p.a.g, 0, transform_inverse(p.b_in_a), MARGIN, NULL);
		count += m.count > 0;
		if (m.count > 0 && f.count > 0)
			worst = greater(worst, fabs((double)manifold_depth(&m) - (double)manifold_depth(&f)));
		int32_t mirrored = m.count == f.count;
		for (int32_t i = 0; i < m.count && mirrored; ++i)
			mirrored = id_flipped(f.points[m.count - 1 - i].id) == m.points[i].id;
		different += !mirrored;
	}
	CHECK_LE("depth differs", worst, BIAS, "m");
	CHECK_LE("not the mirror image", different, 0.02 * (double)count, "pairs");
}

static void t_ids_persist_under_small_motion(void)
{
	int32_t kept = 0, lost = 0;
	for (int32_t k = 0; k < TEST_SAMPLES(20000); ++k) {
		pair p;
		pair_random(&p, k % 11, 2 + 4 * (k / 11));
		cni_manifold_cache cache = { 0, { 0, 0, 0 } };
		cni_manifold m0 = collide(&p.a.g, &p.b.g, 0, p.b_in_a, MARGIN, &cache);
		cni_transform x = p.b_in_a;
		x.t = cni_add(x.t, cni_v(random_in(-1e-4f, 1e-4f), random_in(-1e-4f, 1e-4f)));
		x = transform_mul(x, transform_make(0, 0, random_in(-1e-4f, 1e-4f)));
		cni_manifold m1 = collide(&p.a.g, &p.b.g, 0, x, MARGIN, &cache);
		for (int32_t i = 0; i < m0.count; ++i) {
			int32_t found = 0;
			for (int32_t j = 0; j < m1.count; ++j)
				found |= m1.points[j].id == m0.points[i].id;
			kept += found;
			lost += !found;
		}
	}
	CHECK_LE("ids lost by 0.1 mm of motion", (double)lost / (double)(kept + lost), 1e-3, "share");
}

/* ------------------------------------------------------------------ particular poses */

static void t_box_on_box(void)
{
	float radii[2] = { 0.0f, 0.1f };
	for (int32_t r = 0; r < 2; ++r)
		for (int32_t quarter = 0; quarter < 4; ++quarter)
			for (int32_t side = 0; side < 4; ++side) {
				record box;
				record_box(&box, 0.5f, 0.5f, radii[r], transform_none());
				float way = 1.0f + 2.0f * radii[r];
				cni_vec2 n = cni_v((float)((side == 0) - (side == 1)), (float)((side == 2) - (side == 3)));
				cni_transform x = transform_make(way * n.x, way * n.y, 1.57079633f * (float)quarter);
				cni_manifold m = collide(&box.g, &box.g, 0, x, MARGIN, NULL);
				REQUIRE(m.count == 2);
				CHECK(cni_length(cni_sub(m.normal, n)) < 1e-6f);
				CHECK(cni_abs(m.points[0].separation) < 1e-6f && cni_abs(m.points[1].separation) < 1e-6f);
				CHECK(cni_abs(cni_length(cni_sub(m.points[0].point, m.points[1].point)) - 1.0f) < 1e-5f);
				CHECK(cni_length(cni_sub(cni_lerp(m.points[0].point, m.points[1].point, 0.5f), cni_mul(0.5f * way, n))) < 1e-5f);
			}
}

static void t_jitter_does_not_change_a_stack(void)
{
	int32_t changed = 0, single = 0;
	double tilt = 0.0;
	float radii[2] = { 0.0f, 0.05f };
	for (int32_t k = 0; k < TEST_SAMPLES(2000); ++k) {
		record a, b;
		float radius = radii[k & 1];
		record_box(&a, 0.5f, 0.5f, radius, transform_none());
		/* Equal boxes, a plank on a box, a box on a plank. */
		record_box(&b, k % 3 == 1 ? 4.0f : 0.5f, k % 3 == 2 ? 0.02f : 0.5f, radius, transform_none());
		float way = 0.5f + (k % 3 == 2 ? 0.02f : 0.5f) + 2.0f * radius;
		cni_manifold_cache cache = { 0, { 0, 0, 0 } };
		uint32_t id0 = 0, id1 = 0;
		for (int32_t i = 0; i < 20; ++i) {
			cni_transform x = transform_make(random_in(-2e-4f, 2e-4f), way + random_in(-1.0f, 0.3f) * SLOP, random_in(-1e-3f, 1e-3f));
			cni_manifold m = collide(&a.g, &b.g, 0, x, MARGIN, &cache);
			single += m.count != 2;
			if (i > 0)
				changed += m.points[0].id != id0 || m.points[1].id != id1;
			id0 = m.points[0].id;
			id1 = m.points[1].id;
			tilt = greater(tilt, fabs((double)m.normal.x));
		}
	}
	CHECK_LE("ids changed", changed, 0, "");
	CHECK_LE("manifolds without two points", single, 0, "");
	CHECK_LE("normal tilt", tilt, 1.01e-3, "");
}

static void t_circles_at_one_place(void)
{
	record c;
	record_circle(&c, 0.5f);
	cni_manifold m = collide(&c.g, &c.g, 0, transform_none(), MARGIN, NULL);
	CHECK(m.count == 1 && cni_length(m.normal) == 1.0f && m.points[0].separation == -1.0f);
}

static void t_centres_at_one_place(void)
{
	for (int32_t kind = 0; kind < 11; ++kind)
		for (int32_t k = 0; k < 200; ++k) {
			record a, b;
			double worst = 0.0;
			int32_t wrong = 0;
			record_random(&a, pair_types[kind][0], 1.0f);
			record_random(&b, pair_types[kind][1], 1.0f);
			cni_transform x = transform_make(0, 0, k & 1 ? 0.0f : random_in(-3, 3));
			x.t = cni_sub(a.g.centroid, cni_rotate(x.q, b.g.centroid));
			int32_t itself = (k & 2) && a.g.type == b.g.type;
			cni_manifold m = collide(&a.g, itself ? &a.g : &b.g, 0, itself ? transform_none() : x, MARGIN, NULL);
			manifold_check_form(&m, &worst, &wrong);
			CHECK(wrong == 0);
			CHECK(worst < 1e-6);
			CHECK(m.count > 0);
		}
}

static void t_capsules(void)
{
	record c;
	record_capsule(&c, 1.0f, 0.25f);
	cni_manifold m = collide(&c.g, &c.g, 0, transform_make(0.5f, 0.5f, 0), MARGIN, NULL);
	CHECK(m.count == 2 && cni_length(cni_sub(m.normal, cni_v(0, 1))) < 1e-6f);
	CHECK(cni_abs(m.points[0].separation) < 1e-6f && cni_abs(m.points[1].separation) < 1e-6f);
	CHECK(cni_abs(cni_distance_sq(m.points[0].point, m.points[1].point) - 2.25f) < 1e-5f);
	/* End to end: one point along the line, also when turned around. */
	for (int32_t i = 0; i < 2; ++i) {
		m = collide(&c.g, &c.g, 0, transform_make(2.51f, 0, 3.14159265f * (float)i), MARGIN, NULL);
		CHECK(m.count == 1 && cni_length(cni_sub(m.normal, cni_v(1, 0))) < 1e-5f && cni_abs(m.points[0].separation - 0.01f) < 1e-5f);
		m = collide(&c.g, &c.g, 0, transform_make(3.0f, 0, 3.14159265f * (float)i), MARGIN, NULL);
		CHECK(m.count == 0);
	}
	/* Collinear and overlapping, and crossing in the middle. */
	m = collide(&c.g, &c.g, 0, transform_make(1.0f, 0, 0), MARGIN, NULL);
	CHECK(m.count == 2 && cni_abs(manifold_depth(&m) + 0.5f) < 1e-6f);
	m = collide(&c.g, &c.g, 0, transform_make(0, 0, 1.57079633f), MARGIN, NULL);
	CHECK(m.count >= 1 && cni_abs(manifold_depth(&m) + 1.5f) < 1e-5f);
}

static void t_corner_to_corner_within_the_margin(void)
{
	record box;
	record_box(&box, 0.5f, 0.5f, 0.0f, transform_none());
	cni_manifold m = collide(&box.g, &box.g, 0, transform_make(1.01f, 1.01f, 0), MARGIN, NULL);
	REQUIRE(m.count == 1);
	CHECK_LE("normal error", (double)cni_length(cni_sub(m.normal, cni_v(0.70710678f, 0.70710678f))), 1e-4, "");
	CHECK_LE("separation error", fabs((double)m.points[0].separation - 0.0141421356), 1e-6, "m");
	CHECK(m.points[0].id == (3u << 8 | 1u));
	m = collide(&box.g, &box.g, 0, transform_make(1.015f, 1.015f, 0), MARGIN, NULL);
	CHECK(m.count == 0);
	/* Touching corners of a brick wall: a face normal, one point, no depth. */
	m = collide(&box.g, &box.g, 0, transform_make(1.0f, 1.0f, 0), MARGIN, NULL);
	CHECK(m.count == 1 && cni_abs(m.points[0].separation) < 1e-6f);
}

/* Two needles tip to tip: no face separates them by much, the closest features must. */
static void t_needles_tip_to_tip(void)
{
	cn_polygon left = { 3, 0, { { -2, -0.02f }, { 0, 0 }, { -2, 0.02f } } };
	record a;
	cni_geometry_polygon(&a.g, &left, transform_none());
	cni_manifold m = collide(&a.g, &a.g, 0, transform_make(0.015f, 0, 3.14159265f), MARGIN, NULL);
	REQUIRE(m.count == 1);
	CHECK_LE("separation error", fabs((double)m.points[0].separation - 0.015), 1e-6, "m");
	CHECK(m.normal.x > 0.999f);
	m = collide(&a.g, &a.g, 0, transform_make(0.03f, 0, 3.14159265f), MARGIN, NULL);
	CHECK(m.count == 0);
}

static void t_cache_only_decides_ties(void)
{
	int32_t different = 0;
	double worst = 0.0;
	for (int32_t k = 0; k < TEST_SAMPLES(20000); ++k) {
		pair p;
		pair_random(&p, k % 11, k / 11);
		cni_manifold_cache cache = { (uint8_t)random_below(256), { 0, 0, 0 } };
		cni_manifold m = collide(&p.a.g, &p.b.g, 0, p.b_in_a, MARGIN, NULL), c = collide(&p.a.g, &p.b.g, 0, p.b_in_a, MARGIN, &cache);
		if ((m.count > 0) != (c.count > 0)) {
			/* Only at the margin itself. */
			different += fabs((double)manifold_depth(m.count > 0 ? &m : &c) - (double)MARGIN) > BIAS;
			continue;
		}
		if (m.count > 0)
			worst = greater(worst, fabs((double)manifold_depth(&m) - (double)manifold_depth(&c)) - 2e-6 * (double)p.size);
	}
	CHECK_LE("other answers", different, 0, "");
	CHECK_LE("other depth", worst, BIAS, "m");
}

/* A centre that moves to and fro at equal depth under two faces keeps its cached face, within 0.1 slop. */
static void t_a_deep_circle_keeps_its_face(void)
{
	record circle, box;
	cni_manifold_cache cache = { 0, { 0, 0, 0 } };
	int32_t k, changed = 0;
	float last = 0.0f;
	record_circle(&circle, 0.5f);
	record_box(&box, 1.0f, 1.0f, 0.0f, transform_none());
	for (k = 0; k < 20; ++k) {
		float x = 0.5f + (k % 2 == 0 ? 0.02f : -0.02f) * SLOP; /* its depth in the right face; in the upper one 0.5 */
		cni_manifold m = collide(&circle.g, &box.g, 0, transform_make(-x, -0.5f, 0.0f), MARGIN, &cache);
		REQUIRE(m.count == 1);
		changed += k > 0 && m.normal.x != last;
		last = m.normal.x;
	}
	CHECK_LE("changes of the face", changed, 0, "");
	last = collide(&circle.g, &box.g, 0, transform_make(-0.5f, -0.6f, 0.0f), MARGIN, &cache).normal.x;
	CHECK(last == 0.0f); /* beyond 0.1 slop the face changes */
}

/* Shapes as small and as large as the checks allow, near and far, also chains: results are always finite. */
static void t_extremes_stay_finite(void)
{
	static const float sizes[5] = { 0.006f, 0.1f, 10.0f, 1.0e4f, 9.0e5f };
	double worst = 0.0;
	int32_t wrong = 0, touching = 0;
	for (int32_t k = 0; k < TEST_SAMPLES(60000); ++k) {
		record a, b;
		float size_a = sizes[random_below(5)], size_b = sizes[random_below(5)];
		int32_t type_b = random_below(5), type_a = random_below(type_b < 3 ? type_b + 1 : type_b == 3 ? 4 : 3);
		cni_vec2 points[8];
		cn_chain chain = { points, 8, (uint32_t)random_below(2) };
		record_random(&a, type_a, size_a);
		for (int32_t i = 0; i < 8; ++i)
			points[i] = cni_v(size_b * (float)cos(0.7 * i) * (random_below(2) ? 1.0f : 0.3f), size_b * (float)sin(0.7 * i));
		if (type_b == CN_SHAPE_CHAIN)
			cni_geometry_chain(&b.g, &chain, transform_none());
		else
			record_random(&b, type_b, size_b);
		float reach = random_in(0.0f, 1.0f) * (size_a + size_b);
		cni_transform x = random_transform(reach, 3);
		cni_manifold m = collide(&a.g, &b.g, type_b == CN_SHAPE_CHAIN ? random_below(7) : 0, x, MARGIN, NULL);
		touching += m.count > 0;
		if (m.count > 0)
			worst = greater(worst, fabs((double)cni_length(m.normal) - 1.0));
		for (int32_t i = 0; i < m.count; ++i)
			wrong += !cni_is_finite2(m.points[i].point) || !cni_is_finite(m.points[i].separation) || m.points[i].id == 0u;
	}
	CHECK_GE("touching", touching, TEST_SAMPLES(10000), "");
	CHECK_LE("not finite", wrong, 0, "");
	CHECK_LE("normal length error", worst, 1e-6, "");
}

/* FNV-1a over words of 32 bits, least significant byte first on every machine. */
static uint64_t hash_add(uint64_t hash, const void *data, size_t bytes)
{
	const unsigned char *p = data;
	for (size_t i = 0; i < bytes; i += 4) {
		uint32_t word;
		memcpy(&word, p + i, sizeof word);
		for (int32_t byte = 0; byte < 4; ++byte)
			hash = (hash ^ (word >> 8 * byte & 0xFFu)) * 1099511628211u;
	}
	return hash;
}

/* A rotation from its half-angle tangent: only operations with the same bits everywhere, in a fixed order. */
static cni_transform transform_exact(float reach)
{
	cni_transform x;
	float t = random_in(-1.5f, 1.5f);
	x.t.x = random_in(-reach, reach);
	x.t.y = random_in(-reach, reach);
	x.q.c = (1.0f - t * t) / (1.0f + t * t);
	x.q.s = 2.0f * t / (1.0f + t * t);
	return x;
}

static void record_exact(record *r, int32_t type)
{
	cni_vec2 points[12];
	cn_polygon p;
	float radius = random_in(0.01f, 0.4f);
	int32_t sharp = random_below(2);
	cni_transform offset = transform_exact(0.3f);
	for (int32_t i = 0; i < 12; ++i) {
		points[i].x = random_in(-0.6f, 0.6f);
		points[i].y = random_in(-0.6f, 0.6f);
	}
	cn_circle circle = { points[0], radius };
	cn_capsule capsule = { points[0], { points[0].x + 0.5f, points[1].y }, radius };
	cn_edge edge = { points[0], { points[0].x + 0.5f, points[1].y } };
	cn_chain chain = { points, 12, (uint32_t)sharp };
	if (type == CN_SHAPE_CIRCLE)
		cni_geometry_circle(&r->g, &circle, offset);
	else if (type == CN_SHAPE_CAPSULE)
		cni_geometry_capsule(&r->g, &capsule, offset);
	else if (type == CN_SHAPE_EDGE)
		cni_geometry_edge(&r->g, &edge, offset);
	else if (type == CN_SHAPE_CHAIN)
		cni_geometry_chain(&r->g, &chain, offset);
	else {
		if (cni_hull_make(points, 12, TOLERANCE, &p) != NULL)
			p = box_polygon(0.5f, 0.5f, 0.0f);
		p.radius_m = sharp ? 0.0f : radius;
		cni_geometry_polygon(&r->g, &p, offset);
	}
}

/* The same bits from every compiler and for every processor. The value was computed once with gcc -O2 on
   x86-64 and changes only when a manifold function does. */
static void t_same_bits_everywhere(void)
{
	uint64_t hash = 14695981039346656037u;
	int32_t touching = 0;
	random_state = 12345u;
	for (int32_t k = 0; k < 30000; ++k) {
		record a, b;
		int32_t type_b = random_below(5), type_a = random_below(type_b + 1);
		if (cni_manifold_function(type_a, type_b) == NULL)
			continue;
		record_exact(&a, type_a);
		record_exact(&b, type_b);
		cni_transform x = transform_exact(1.2f);
		cni_manifold m = collide(&a.g, &b.g, type_b == CN_SHAPE_CHAIN ? random_below(11) : 0, x, MARGIN, NULL);
		touching += m.count > 0;
		hash = hash_add(hash, &m.count, 4);
		if (m.count > 0)
			hash = hash_add(hash, &m.normal, 8);
		for (int32_t i = 0; i < m.count; ++i)
			hash = hash_add(hash, &m.points[i], sizeof(cni_manifold_point));
	}
	printf("  %d touching, hash %016llx\n", touching, (unsigned long long)hash);
	CHECK(hash == UINT64_C(0xea4a6366b81c3230));
}

static void t_table(void)
{
	for (int32_t a = 0; a < 5; ++a)
		for (int32_t b = a; b < 5; ++b)
			CHECK((cni_manifold_function(a, b) == NULL) == (a >= 3 && b == 4));
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(t_form);
	RUN(t_separation_is_exact);
	RUN(t_normal_resolves);
	RUN(t_points_are_between_the_surfaces);
	RUN(t_moving_both_changes_nothing);
	RUN(t_swapping_roles_gives_the_mirror);
	RUN(t_ids_persist_under_small_motion);
	RUN(t_box_on_box);
	RUN(t_jitter_does_not_change_a_stack);
	RUN(t_circles_at_one_place);
	RUN(t_centres_at_one_place);
	RUN(t_capsules);
	RUN(t_corner_to_corner_within_the_margin);
	RUN(t_needles_tip_to_tip);
	RUN(t_cache_only_decides_ties);
	RUN(t_a_deep_circle_keeps_its_face);
	RUN(t_extremes_stay_finite);
	RUN(t_same_bits_everywhere);
	RUN(t_table);
	return test_end();
}
