/*
 * test/collision/chain_test.c - chains are one-sided, and shapes never catch on inner vertices.
 */
#include "geometry/shapes.h"
#include "test.h"

#define MARGIN 0.02f
#define PI_F 3.14159265f

static void chain_build(record *r, const cni_vec2 *points, int32_t count, uint32_t loop)
{
	cn_chain chain = { points, count, loop };
	cni_geometry_chain(&r->g, &chain, transform_none());
}

/* Ground along x, solid below: points run from +x to -x. */
static void chain_flat(record *r, float length, int32_t edges)
{
	cni_vec2 points[CHAIN_MAX];
	for (int32_t i = 0; i <= edges; ++i)
		points[i] = cni_v(0.5f * length - length * (float)i / (float)edges, 0.0f);
	chain_build(r, points, edges + 1, 0);
}

static void shape_random(record *r, int32_t kind, float size)
{
	cn_polygon p;
	switch (kind % 4) {
	case 0:
		record_circle(r, random_in(0.2f, 1.0f) * size);
		break;
	case 1:
		record_capsule(r, random_in(0.3f, 1.0f) * size, random_in(0.1f, 0.4f) * size);
		break;
	case 2:
		record_box(r, random_in(0.3f, 1.0f) * size, random_in(0.3f, 1.0f) * size, random_below(2) ? 0.0f : 0.1f * size, transform_none());
		break;
	default:
		p = random_polygon(size);
		cni_geometry_polygon(&r->g, &p, transform_none());
		break;
	}
}

/* Lowest surface point of the shape at angle, relative to its origin. */
static float shape_bottom(const record *r, float angle)
{
	return cni_geometry_aabb(&r->g, 0, transform_make(0, 0, angle)).y0;
}

typedef struct placed {
	cni_transform pose;    /* of the shape in the world */
	cni_transform ground;  /* of the chain in the shape's frame */
} placed;

static placed place(cni_transform chain, float x, float y, float angle)
{
	placed p;
	p.pose = transform_mul(chain, transform_make(x, y, angle));
	p.ground = transform_mul(transform_inverse(p.pose), chain);
	return p;
}

/* Any shape at any pose over a chain of collinear edges, up to 10 slop deep: every normal is the ground's, and the deepest
   contact has the depth of a plane (except a needle's tip deep under the next edge, which that edge does not reach). */
static void t_flat_chain_never_catches(void)
{
	double worst_normal = 0.0, worst_depth = 0.0;
	int32_t contacts = 0, bare = 0, count = 0;
	for (int32_t k = 0; k < TEST_SAMPLES(60000); ++k) {
		record ground, shape;
		float size = k % 5 == 0 ? 0.2f : 1.0f;
		chain_flat(&ground, 12.0f, 1 + random_below(40));
		shape_random(&shape, k, size);
		float angle = random_below(2) ? 0.5f * PI_F * (float)random_below(4) + random_in(-0.01f, 0.01f) * (float)random_below(2) : random_in(-3.1f, 3.1f);
		float depth = random_in(-1.0f, 10.0f) * SLOP, bottom = shape_bottom(&shape, angle);
		if (-bottom - depth <= 0.0f)
			continue;
		/* Includes vertices exactly under a joint. */
		float x = random_below(2) ? random_in(-4, 4) : 12.0f * (float)random_below(10) / 40.0f;
		cni_transform chain = random_transform(5, 3.1f);
		placed p = place(chain, x, -bottom - depth, angle);
		cni_vec2 up = cni_unrotate(p.pose.q, cni_rotate(chain.q, cni_v(0, 1)));
		/* Shapes whose centroid is below ground do not count. */
		if (cni_dot(up, cni_sub(shape.g.centroid, p.ground.t)) < 1e-4f)
			continue;
		++count;
		float deepest = 1.0f;
		for (int32_t child = 0; child < cni_geometry_children(&ground.g); ++child) {
			cni_manifold m = collide(&shape.g, &ground.g, child, p.ground, MARGIN, NULL);
			contacts += m.count;
			for (int32_t i = 0; i < m.count; ++i) {
				deepest = cni_min(deepest, m.points[i].separation);
				worst_normal = greater(worst_normal, (double)cni_length(cni_add(m.normal, up)));
			}
		}
		if (deepest == 1.0f)
			++bare;
		else
			worst_depth = greater(worst_depth, fabs((double)deepest + (double)depth));
	}
	CHECK_GE("placements", count, TEST_SAMPLES(50000), "");
	CHECK_GE("contact points", contacts, TEST_SAMPLES(60000), "");
	CHECK_LE("placements without any contact", bare, 0, "");
	CHECK_LE("normal error", worst_normal, 1e-5, "");
	CHECK_LE("depth error", worst_depth, 0.5 * (double)SLOP, "m");
}

/* A shape behind the ground does not collide. */
static void t_one_sided(void)
{
	int32_t wrong = 0;
	for (int32_t k = 0; k < TEST_SAMPLES(5000); ++k) {
		record ground, shape;
		chain_flat(&ground, 12.0f, 1 + random_below(20));
		shape_random(&shape, k, 1.0f);
		placed p = place(transform_none(), random_in(-8, 8), 0, random_in(-3, 3));
		cni_vec2 center = cni_transform_point(p.pose, shape.g.centroid);
		p = place(transform_none(), p.pose.t.x, -center.y - random_in(0.001f, 1.0f), 0.0f);
		p.pose.q.c = 1.0f;
		center = cni_transform_point(p.pose, shape.g.centroid);
		if (center.y >= 0.0f)
			continue;
		for (int32_t child = 0; child < cni_geometry_children(&ground.g); ++child)
			wrong += collide(&shape.g, &ground.g, child, p.ground, MARGIN, NULL).count != 0;
	}
	CHECK_LE("contacts from behind", wrong, 0, "");
}

/* In a valley only the slopes' own normals push a shape. */
static void t_concave_corner(void)
{
	int32_t wrong = 0, contacts = 0;
	for (int32_t k = 0; k < TEST_SAMPLES(20000); ++k) {
		record ground, shape;
		float left = random_in(0.05f, 1.4f), right = random_in(0.05f, 1.4f);
		cni_vec2 points[3] = { { 6.0f * (float)cos((double)right), 6.0f * (float)sin((double)right) }, { 0, 0 }, { -6.0f * (float)cos((double)left), 6.0f * (float)sin((double)left) } };
		chain_build(&ground, points, 3, 0);
		shape_random(&shape, k, 0.5f);
		placed p = place(transform_none(), random_in(-1, 1), random_in(0, 1.5f), random_in(-3, 3));
		for (int32_t child = 0; child < 2; ++child) {
			cni_manifold m = collide(&shape.g, &ground.g, child, p.ground, MARGIN, NULL);
			cni_vec2 up = cni_unrotate(p.pose.q, child ? cni_v((float)sin((double)left), (float)cos((double)left)) : cni_v(-(float)sin((double)right), (float)cos((double)right)));
			contacts += m.count > 0;
			wrong += m.count > 0 && cni_length(cni_add(m.normal, up)) > 1e-5f;
		}
	}
	CHECK_GE("contacts", contacts, TEST_SAMPLES(5000), "");
	CHECK_LE("normals that are not a slope's", wrong, 0, "");
}

/* No shape in front of a valley's floor can be deep in it without a contact. */
static void t_concave_corner_holds(void)
{
	int32_t bare = 0, count = 0;
	for (int32_t k = 0; k < TEST_SAMPLES(20000); ++k) {
		record ground, shape;
		float left = random_in(0.05f, 1.2f), right = random_in(0.05f, 1.2f);
		cni_vec2 points[3] = { { 6.0f * (float)cos((double)right), 6.0f * (float)sin((double)right) }, { 0, 0 }, { -6.0f * (float)cos((double)left), 6.0f * (float)sin((double)left) } };
		chain_build(&ground, points, 3, 0);
		shape_random(&shape, k, 0.5f);
		placed p = place(transform_none(), random_in(-0.2f, 0.2f), random_in(0.1f, 0.8f), random_in(-3, 3));
		cni_vec2 c = cni_transform_point(p.pose, shape.g.centroid), storage[2];
		if (c.y < 0.01f + fabsf(c.x) * (c.x > 0.0f ? (float)tan((double)right) : (float)tan((double)left)))
			continue;
		/* The exact distance says that the shape touches one of the two edges. */
		float least = 1.0f;
		for (int32_t child = 0; child < 2; ++child) {
			cni_proxy_points a = cni_geometry_proxy(&shape.g, 0, storage), b = { &points[child], 2, 0.0f };
			least = cni_min(least, cni_distance(a, b, p.ground).distance);
		}
		if (least > -1e-3f && !(least == 0.0f && shape.g.type == CN_SHAPE_POLYGON))
			continue;
		++count;
		int32_t found = 0;
		for (int32_t child = 0; child < 2; ++child)
			found += collide(&shape.g, &ground.g, child, p.ground, MARGIN, NULL).count;
		bare += found == 0;
	}
	CHECK_GE("touching placements", count, TEST_SAMPLES(4000), "");
	CHECK_LE("placements without a contact", bare, 0, "");
}

/* Around a convex loop every touching shape gets a contact, normals point outwards, and the deepest contact is about the
   least translation. */
static void t_convex_loop_is_closed(void)
{
	int32_t bare = 0, count = 0, inward = 0;
	double worst = 0.0;
	for (int32_t k = 0; k < TEST_SAMPLES(40000); ++k) {
		record ground, shape, solid;
		cn_polygon wheel;
		wheel.count = 3 + random_below(10);
		wheel.radius_m = 0.0f;
		for (int32_t i = 0; i < wheel.count; ++i) {
			double angle = 6.283185307 * (double)i / (double)wheel.count;
			wheel.points_m[i] = cni_v((float)(2.0 * cos(angle)), (float)(2.0 * sin(angle)));
		}
		chain_build(&ground, wheel.points_m, wheel.count, 1);
		cni_geometry_polygon(&solid.g, &wheel, transform_none());
		shape_random(&shape, k, 0.7f);
		placed p = place(transform_none(), random_in(-3, 3), random_in(-3, 3), random_in(-3, 3));
		double reference = reference_separation(&shape.g, &solid.g, p.ground);
		cni_vec2 center = cni_transform_point(p.pose, shape.g.centroid);
		float shift = -random_in(0.0f, 11.0f) * SLOP - (float)reference;
		p.pose.t = cni_madd(p.pose.t, shift, cni_normalize(center));
		p.ground = transform_inverse(p.pose);
		center = cni_transform_point(p.pose, shape.g.centroid);
		reference = reference_separation(&shape.g, &solid.g, p.ground);
		if (cni_geometry_contains(&solid.g, center) || reference > 0.0 || reference < -10.0 * (double)SLOP)
			continue;
		++count;
		float deepest = 1.0f;
		for (int32_t child = 0; child < wheel.count; ++child) {
			cni_manifold m = collide(&shape.g, &ground.g, child, p.ground, MARGIN, NULL);
			for (int32_t i = 0; i < m.count; ++i) {
				deepest = cni_min(deepest, m.points[i].separation);
				inward += cni_dot(cni_rotate(p.pose.q, m.normal), cni_sub(cni_v(0, 0), center)) < 0.0f;
			}
		}
		bare += deepest == 1.0f;
		if (deepest < 1.0f)
			worst = greater(worst, fabs((double)deepest - reference));
	}
	CHECK_GE("touching placements", count, TEST_SAMPLES(20000), "");
	CHECK_LE("placements without a contact", bare, 0, "");
	CHECK_LE("normals that pull inwards", inward, 0, "");
	CHECK_LE("depth against the solid polygon's", worst, 0.3 * (double)SLOP, "m");
}

/* A box at rest that overhangs a ledge, tilted slightly either way: the wall below it does not push. */
static void t_ledge_does_not_push(void)
{
	double worst = 0.0;
	int32_t contacts = 0;
	for (int32_t k = 0; k < TEST_SAMPLES(20000); ++k) {
		record ground, shape;
		/* Top from the ledge at x = 0 to the left, a wall down, travelling upwards then left. */
		cni_vec2 points[4] = { { 0.5f, -4 }, { 0, -3 }, { 0, 0 }, { -6, 0 } };
		chain_build(&ground, points, 4, 0);
		record_box(&shape, 0.5f, 0.5f, k & 1 ? 0.1f : 0.0f, transform_none());
		float angle = random_in(-0.02f, 0.02f), depth = random_in(-0.5f, 4.0f) * SLOP;
		placed p = place(transform_none(), random_in(-0.5f, 0.45f), 0, 0);
		p = place(transform_none(), p.pose.t.x, -shape_bottom(&shape, angle) - depth, angle);
		for (int32_t child = 0; child < 3; ++child) {
			cni_manifold m = collide(&shape.g, &ground.g, child, p.ground, MARGIN, NULL);
			contacts += m.count > 0;
			if (m.count > 0)
				worst = greater(worst, fabs((double)cni_rotate(p.pose.q, m.normal).x));
		}
	}
	CHECK_GE("contacts", contacts, TEST_SAMPLES(20000), "");
	CHECK_LE("sideways part of a normal", worst, 0.021, "");
}

static void t_open_ends(void)
{
	record ground, circle, box;
	chain_flat(&ground, 2.0f, 1);
	record_circle(&circle, 0.5f);
	/* Beyond the end by 0.3, up by 0.4: exactly touching, straight from the end to the centre. */
	placed p = place(transform_none(), 1.3f, 0.4f, 0);
	cni_manifold m = collide(&circle.g, &ground.g, 0, p.ground, MARGIN, NULL);
	REQUIRE(m.count == 1);
	CHECK(cni_abs(m.points[0].separation) < 1e-6f && cni_length(cni_sub(m.normal, cni_v(-0.6f, -0.8f))) < 1e-5f);
	record_box(&box, 0.5f, 0.5f, 0, transform_none());
	p = place(transform_none(), 1.2f, 0.499f, 0);
	m = collide(&box.g, &ground.g, 0, p.ground, MARGIN, NULL);
	REQUIRE(m.count == 2);
	CHECK(m.normal.y < -0.999f);
	/* Next to the end. */
	p = place(transform_none(), 1.499f, 0.1f, 0);
	m = collide(&box.g, &ground.g, 0, p.ground, MARGIN, NULL);
	REQUIRE(m.count >= 1);
	CHECK(m.normal.x < -0.999f && cni_abs(manifold_depth(&m) + 0.001f) < 1e-5f);
}

/* A box slides along flat ground of short edges: the depth never jumps. */
static void t_sliding_is_smooth(void)
{
	float radii[2] = { 0.0f, 0.1f };
	double worst = 0.0;
	int32_t few = 0;
	for (int32_t r = 0; r < 2; ++r) {
		record ground, box;
		chain_flat(&ground, 12.0f, 48);
		record_box(&box, 0.5f, 0.5f, radii[r], transform_none());
		for (int32_t step = 0; step < 4000; ++step) {
			placed p = place(transform_none(), -4.0f + 0.002f * (float)step, 0.5f + radii[r] - SLOP, 0);
			float low = 10.0f, high = -10.0f;
			for (int32_t child = 0; child < 48; ++child) {
				cni_manifold m = collide(&box.g, &ground.g, child, p.ground, MARGIN, NULL);
				for (int32_t i = 0; i < m.count; ++i) {
					worst = greater(worst, fabs((double)m.points[i].separation + (double)SLOP));
					low = cni_min(low, m.points[i].point.x);
					high = cni_max(high, m.points[i].point.x);
				}
			}
			few += !(low < -0.499f && high > 0.499f);
		}
	}
	CHECK_LE("separation error", worst, 1e-6, "m");
	CHECK_LE("steps in which the box is not held at both corners", few, 0, "");
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(t_flat_chain_never_catches);
	RUN(t_one_sided);
	RUN(t_concave_corner);
	RUN(t_concave_corner_holds);
	RUN(t_convex_loop_is_closed);
	RUN(t_ledge_does_not_push);
	RUN(t_open_ends);
	RUN(t_sliding_is_smooth);
	return test_end();
}
