/*
 * query_pair_test - promise: two shapes without a world have the distance, the first touch, the time of impact and the manifold that
 * they have, wherever they are; and in a world it is the same.
 *
 * Checked against distances in double precision, and against cn_world_cast_shape and cn_body_get_contacts.
 */
#include "world/fixture.h"
#include "collision/sets.h"

#define PAIRS 3000

static uint32_t seed = 11u;
static float rnd(float lower, float upper) { return fixture_random(&seed, lower, upper); }
static int32_t below(int32_t count) { return (int32_t)rnd(0.0f, (float)count - 0.001f); }

static cn_polygon random_solid(int32_t points)
{
	cn_polygon p;
	cn_vec2 cloud[8];
	int32_t k;
	memset(&p, 0, sizeof p);
	for (k = 0; k < 8; ++k) {
		cloud[k].x = rnd(-1.0f, 1.0f);
		cloud[k].y = rnd(-1.0f, 1.0f);
	}
	if (points > 2)
		must(cn_polygon_make_hull(cloud, 8, 0.0f, &p), NULL, "hull");
	p.count = points > 2 ? p.count : points;
	p.radius_m = points > 1 && below(2) ? 0.0f : rnd(0.05f, 0.5f);
	for (k = 0; k < points && points < 3; ++k)
		p.points_m[k] = cloud[k];
	return p;
}

static cn_pose random_pose(float x, float reach)
{
	cn_pose pose;
	double angle = (double)rnd(-3.0f, 3.0f);
	pose.position_m.x = x + rnd(-reach, reach);
	pose.position_m.y = rnd(-reach, reach);
	pose.cosine = (float)cos(angle);
	pose.sine = (float)sin(angle);
	return pose;
}

static double_set set_at(const cn_polygon *p, const cn_pose *pose)
{
	cni_proxy_points points = { p->points_m, 0, 0.0f };
	cni_transform at;
	points.count = p->count;
	points.radius = p->radius_m;
	at.q.c = pose->cosine;
	at.q.s = pose->sine;
	at.t = pose->position_m;
	return set_of(points, at);
}

/* Near the origin, and 1 km away, where floats tell 0.06 mm. */
static void t_distances(void)
{
	int32_t far_away, k, deep = 0;
	for (far_away = 0; far_away < 2; ++far_away) {
		float x = far_away ? 1000.0f : 0.0f;
		double worst = 0.0, points = 0.0, normal = 0.0, epsilon = far_away ? 5e-4 : 5e-6;
		for (k = 0; k < PAIRS; ++k) {
			cn_polygon a = random_solid(1 + below(3)), b = random_solid(1 + below(3));
			cn_pose pa = random_pose(x, 1.5f), pb = random_pose(x, 1.5f);
			double_set sa = set_at(&a, &pa), sb = set_at(&b, &pb);
			cn_distance d;
			must(cn_polygon_distance(&a, &pa, &b, &pb, &d), NULL, "distance");
			worst = greater(worst, fabs((double)d.distance_m - distance_of(&sa, &sb, 0.0, 0.0)));
			normal = greater(normal, fabs(hypot((double)d.normal.x, (double)d.normal.y) - 1.0));
			points = greater(points, fabs(set_distance_to_point(&sa, (double)d.point_a_m.x, (double)d.point_a_m.y, 0.0, 0.0)));
			points = greater(points, hypot((double)(d.point_b_m.x - d.point_a_m.x - d.distance_m * d.normal.x), (double)(d.point_b_m.y - d.point_a_m.y - d.distance_m * d.normal.y)));
			/* b moved that way just touches. */
			worst = greater(worst, fabs(distance_of(&sa, &sb, -(double)(d.distance_m * d.normal.x), -(double)(d.distance_m * d.normal.y))));
			deep += d.distance_m < 0.0f;
		}
		CHECK_LE("error of the distance", worst, epsilon, "m");
		CHECK_LE("error of the points", points, epsilon, "m");
		CHECK_LE("length of the normal off 1", normal, 1e-6, "");
	}
	CHECK_GE("pairs that overlap", deep, PAIRS / 4, "");
}

static void t_casts_are_those_of_a_world(void)
{
	int32_t k, hits = 0, wrong = 0;
	double worst = 0.0;
	for (k = 0; k < 400; ++k) {
		cn_world *w = fixture_world(0.0f, 1);
		cn_polygon a = random_solid(3), b = random_solid(1), there;
		cn_pose pa = random_pose(0.0f, 1.0f), pb = random_pose(0.0f, 3.0f);
		float angle = (float)atan2((double)pa.sine, (double)pa.cosine), dx = rnd(-4.0f, 4.0f), dy = rnd(-4.0f, 4.0f);
		cn_shape_def sd = fixture_shape_def(fixture_body(w, CN_BODY_STATIC, pa.position_m.x, pa.position_m.y, angle), 0.5f, 0.0f);
		cn_ray_hit alone, in_world;
		int32_t hit;
		must(cn_shape_create_polygon(w, &sd, &a, NULL), w, "polygon");
		there = b;
		there.points_m[0].x = pb.position_m.x + pb.cosine * b.points_m[0].x - pb.sine * b.points_m[0].y;
		there.points_m[0].y = pb.position_m.y + pb.sine * b.points_m[0].x + pb.cosine * b.points_m[0].y;
		must(cn_polygon_cast(&a, &pa, &b, &pb, dx, dy, &alone, &hit), NULL, "cast");
		must(cn_world_cast_shape(w, &there, dx, dy, NULL, &in_world), w, "cast_shape");
		hits += hit;
		wrong += hit != (in_world.shape != 0);
		worst = greater(worst, fabs((double)(alone.fraction - in_world.fraction)));
		worst = greater(worst, fabs((double)(alone.depth_m - in_world.depth_m)));
		if (hit)
			worst = greater(worst, hypot((double)(alone.point_m.x - in_world.point_m.x), (double)(alone.point_m.y - in_world.point_m.y)));
		cn_world_destroy(w);
	}
	CHECK_GE("hits", hits, 80, "");
	CHECK_LE("answers that differ", wrong, 0, "");
	CHECK_LE("greatest difference", worst, 1e-5, "");
}

/* Either way round: the same points, the opposite normal. */
static void t_manifolds(void)
{
	int32_t k, i, touching = 0, swapped_wrong = 0;
	double worst = 0.0;
	for (k = 0; k < PAIRS; ++k) {
		cn_polygon a = random_solid(1 + below(3)), b = random_solid(1 + below(3));
		cn_pose pa = random_pose(500.0f, 1.2f), pb = random_pose(500.0f, 1.2f);
		double_set sa = set_at(&a, &pa), sb = set_at(&b, &pb);
		double distance = distance_of(&sa, &sb, 0.0, 0.0);
		cn_manifold m, n;
		must(cn_polygon_collide(&a, &pa, &b, &pb, 0.05f, &m), NULL, "collide");
		must(cn_polygon_collide(&b, &pb, &a, &pa, 0.05f, &n), NULL, "collide");
		swapped_wrong += (m.point_count > 0) != (n.point_count > 0) && fabs(distance - 0.05) > 1e-3;
		if (m.point_count == 0) {
			swapped_wrong += distance < 0.049;
			continue;
		}
		for (i = 0; i < m.point_count && m.point_count == n.point_count && distance > 1e-3; ++i) {
			/* Features change sides with the shapes, whichever comes first. */
			uint32_t id = m.points[i].feature_id, turned = (id & 255u) << 8 | id >> 8;
			swapped_wrong += turned != n.points[0].feature_id && (n.point_count < 2 || turned != n.points[1].feature_id);
		}
		++touching;
		swapped_wrong += distance > 0.051;
		if (n.point_count > 0 && distance > 1e-3) /* apart there is one normal */
			worst = greater(worst, hypot((double)(m.normal.x + n.normal.x), (double)(m.normal.y + n.normal.y)));
		if (distance > 1e-3)
			worst = greater(worst, fabs(fmin((double)m.points[0].separation_m, m.point_count == 2 ? (double)m.points[1].separation_m : 1.0) - distance));
	}
	CHECK_GE("touching pairs", touching, PAIRS / 4, "");
	CHECK_LE("pairs that touch one way round only, or wrongly", swapped_wrong, 0, "");
	CHECK_LE("error of normals and distances of pairs that are apart", worst, 5e-3, "");
}

/* Two boxes on each other, as a step sees them. */
static void t_a_manifold_is_that_of_a_step(void)
{
	cn_world *w = fixture_world(0.0f, 0);
	cn_body low = fixture_box(w, CN_BODY_STATIC, 100.0f, 0.0f, 0.0f, 1.0f, 0.5f, 0.5f, 0.0f);
	cn_body high = fixture_box(w, CN_BODY_DYNAMIC, 100.3f, 1.0005f, 0.0f, 0.5f, 0.5f, 0.5f, 0.0f);
	cn_polygon a, b;
	cn_pose pa, pb;
	cn_manifold m;
	cn_contact_event e;
	int32_t count, k;
	double worst = 0.0;
	must(cn_polygon_make_box(1.0f, 0.5f, 0.0f, 0.0f, 0.0f, 0.0f, &a), NULL, "box");
	must(cn_polygon_make_box(0.5f, 0.5f, 0.0f, 0.0f, 0.0f, 0.0f, &b), NULL, "box");
	pa = fixture_pose(w, low);
	pb = fixture_pose(w, high);
	must(cn_polygon_collide(&a, &pa, &b, &pb, 0.01f, &m), NULL, "collide");
	fixture_step(w, 1);
	must(cn_body_get_contacts(w, high, &e, 1, &count), w, "contacts");
	REQUIRE(count == 1 && e.manifold.point_count == 2 && m.point_count == 2);
	CHECK(m.normal.x == 0.0f && m.normal.y == 1.0f);
	for (k = 0; k < 2; ++k) {
		int32_t other = fabsf(m.points[k].point_m.x - e.manifold.points[0].point_m.x) < 0.1f ? 0 : 1;
		worst = greater(worst, fabs((double)(m.points[k].separation_m - e.manifold.points[other].separation_m)));
		worst = greater(worst, hypot((double)(m.points[k].point_m.x - e.manifold.points[other].point_m.x), (double)(m.points[k].point_m.y - e.manifold.points[other].point_m.y)));
	}
	CHECK_LE("off the contact of a step", worst, 1e-4, "m");
	cn_world_destroy(w);
}

/* ------------------------------------------------------------------ time of impact */

static cn_pose pose_on(const cn_sweep *s, double t)
{
	double angle = atan2((double)s->start.sine, (double)s->start.cosine) + t * (double)s->turn_rad;
	double c0 = (double)s->start.cosine, s0 = (double)s->start.sine, px = (double)s->center_m.x, py = (double)s->center_m.y;
	double x = (double)s->start.position_m.x + c0 * px - s0 * py + t * (double)s->translation_m.x;
	double y = (double)s->start.position_m.y + s0 * px + c0 * py + t * (double)s->translation_m.y;
	cn_pose pose;
	pose.cosine = (float)cos(angle);
	pose.sine = (float)sin(angle);
	pose.position_m.x = (float)(x - cos(angle) * px + sin(angle) * py);
	pose.position_m.y = (float)(y - sin(angle) * px - cos(angle) * py);
	return pose;
}

static cn_sweep random_sweep(float reach)
{
	cn_sweep s;
	memset(&s, 0, sizeof s);
	s.start = random_pose(0.0f, reach);
	s.center_m.x = rnd(-0.3f, 0.3f);
	s.center_m.y = rnd(-0.3f, 0.3f);
	s.translation_m.x = rnd(-4.0f, 4.0f);
	s.translation_m.y = rnd(-4.0f, 4.0f);
	s.turn_rad = rnd(-3.0f, 3.0f);
	return s;
}

static void t_times_of_impact(void)
{
	int32_t k, i, hits = 0, overlaps = 0, late = 0, failed = 0;
	double worst = 0.0;
	for (k = 0; k < 1000; ++k) {
		cn_polygon a = random_solid(1 + below(3)), b = random_solid(1 + below(3));
		cn_sweep sa = random_sweep(3.0f), sb = random_sweep(3.0f);
		float target = k % 2 ? 0.0f : 0.1f;
		cn_impact hit;
		must(cn_polygon_time_of_impact(&a, &sa, &b, &sb, target, &hit), NULL, "impact");
		hits += hit.state == CN_IMPACT_HIT && hit.fraction > 0.0f;
		overlaps += hit.state == CN_IMPACT_OVERLAP;
		failed += hit.state == CN_IMPACT_FAILED;
		for (i = 0; i < 200 && hit.fraction > 0.0f; ++i) {
			double t = (double)hit.fraction * i / 200.0;
			cn_pose pa = pose_on(&sa, t), pb = pose_on(&sb, t);
			double_set xa = set_at(&a, &pa), xb = set_at(&b, &pb);
			late += distance_of(&xa, &xb, 0.0, 0.0) < (double)target - 1e-4;
		}
		if (hit.state == CN_IMPACT_HIT && hit.fraction > 0.0f) {
			cn_pose pa = pose_on(&sa, (double)hit.fraction), pb = pose_on(&sb, (double)hit.fraction);
			double_set xa = set_at(&a, &pa), xb = set_at(&b, &pb);
			worst = greater(worst, fabs(distance_of(&xa, &xb, 0.0, 0.0) - (double)hit.distance_m));
			worst = greater(worst, fabs((double)hit.distance_m - (double)target));
		}
	}
	printf("  %d hits, %d overlaps at the start, %d failed\n", (int)hits, (int)overlaps, (int)failed);
	CHECK_GE("hits", hits, 100, "");
	CHECK_LE("times at which they were nearer before", late, 0, "");
	CHECK_LE("distance at the hit off the one asked for", worst, 2e-4, "m");
	CHECK_LE("failed", failed, 0, "");
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(t_distances);
	RUN(t_casts_are_those_of_a_world);
	RUN(t_manifolds);
	RUN(t_a_manifold_is_that_of_a_step);
	RUN(t_times_of_impact);
	return test_end();
}
