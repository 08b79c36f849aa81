/*
 * test/collision/toi_test.c - up to the fraction that cni_toi returns no two shapes come closer than the target, for any
 * shapes and any speed of rotation; a hit is within the tolerance of the target; shapes that never come close are reported as
 * separated.
 *
 * Checked against dense sampling of the motion in double precision.
 */
#include "collision/toi.h"
#include "geometry/shapes.h"
#include "test.h"

#include <string.h>

/* ------------------------------------------------------------------ reference */

typedef struct double_path {
	double x0, y0, dx, dy, angle, turn, lx, ly;
} double_path;

static double_path path_of(const cni_path *p)
{
	double_path d;
	d.x0 = (double)p->start.x;
	d.y0 = (double)p->start.y;
	d.dx = (double)p->end.x - d.x0;
	d.dy = (double)p->end.y - d.y0;
	d.angle = atan2((double)p->q.s, (double)p->q.c);
	d.turn = (double)p->turn;
	d.lx = (double)p->local_center.x;
	d.ly = (double)p->local_center.y;
	return d;
}

typedef struct double_points {
	double x[CN_POLYGON_MAX_VERTICES], y[CN_POLYGON_MAX_VERTICES];
	int32_t count;
} double_points;

static double_points points_at(const cni_geometry *g, int32_t child, const double_path *p, double t)
{
	double_points out;
	cni_vec2 storage[2];
	cni_proxy_points set = cni_geometry_proxy(g, child, storage);
	double c = cos(p->angle + p->turn * t), s = sin(p->angle + p->turn * t);
	out.count = set.count;
	for (int32_t i = 0; i < set.count; ++i) {
		double x = (double)set.points[i].x - p->lx, y = (double)set.points[i].y - p->ly;
		out.x[i] = p->x0 + p->dx * t + c * x - s * y;
		out.y[i] = p->y0 + p->dy * t + s * x + c * y;
	}
	return out;
}

static double point_to_edge(double px, double py, double ax, double ay, double bx, double by)
{
	double ex = bx - ax, ey = by - ay, dx = px - ax, dy = py - ay, l2 = ex * ex + ey * ey;
	double t = l2 > 0.0 ? (dx * ex + dy * ey) / l2 : 0.0;
	t = t < 0.0 ? 0.0 : t > 1.0 ? 1.0 : t;
	return hypot(dx - t * ex, dy - t * ey);
}

static double turn_of(const double_points *a, int32_t i, int32_t j, double x, double y)
{
	return (a->x[j] - a->x[i]) * (y - a->y[i]) - (a->y[j] - a->y[i]) * (x - a->x[i]);
}

/* 1 when any two edges cross properly or one set is inside the other. */
static int points_overlap(const double_points *a, const double_points *b)
{
	int inside = a->count > 2;
	for (int32_t i = 0; i < a->count && a->count > 1; ++i) {
		int32_t in = (i + 1) % a->count;
		inside = inside && turn_of(a, i, in, b->x[0], b->y[0]) >= 0.0;
		for (int32_t j = 0; j < b->count && b->count > 1; ++j) {
			int32_t jn = (j + 1) % b->count;
			if (turn_of(a, i, in, b->x[j], b->y[j]) * turn_of(a, i, in, b->x[jn], b->y[jn]) < 0.0 &&
			    turn_of(b, j, jn, a->x[i], a->y[i]) * turn_of(b, j, jn, a->x[in], a->y[in]) < 0.0)
				return 1;
		}
	}
	return inside;
}

/* Distance of the skeletons, 0 when they overlap. */
static double distance_at(const cni_toi_input *in, double t)
{
	double_path pa = path_of(&in->path_a), pb = path_of(&in->path_b);
	double_points a = points_at(in->a, in->child_a, &pa, t), b = points_at(in->b, in->child_b, &pb, t);
	double best = 1e300;
	if (points_overlap(&a, &b) || points_overlap(&b, &a))
		return 0.0;
	for (int32_t i = 0; i < a.count; ++i)
		for (int32_t j = 0; j < b.count; ++j) {
			int32_t in_ = (i + 1) % a.count, jn = (j + 1) % b.count;
			best = fmin(best, point_to_edge(a.x[i], a.y[i], b.x[j], b.y[j], b.x[jn], b.y[jn]));
			best = fmin(best, point_to_edge(b.x[j], b.y[j], a.x[i], a.y[i], a.x[in_], a.y[in_]));
		}
	return best;
}

/* ------------------------------------------------------------------ the check */

static struct {
	int pairs, hits, separated, overlapped, failed, started_near;
	int iterations_most;
	double iterations_sum;
	double breach;   /* largest amount below the target before the fraction, in tolerances */
	double early;    /* largest amount of a hit above target + tolerance, in tolerances */
	double below;    /* largest amount of a hit below the target, in tolerances */
} seen;

static void seen_begin(void) { memset(&seen, 0, sizeof seen); }

static float size_of(const cni_geometry *g, const cni_path *p)
{
	return g->extent + cni_length(p->local_center);
}

/* The value to which the header allows the tolerance to be raised. */
static double tolerance_of(const cni_toi_input *in)
{
	double size = (double)(size_of(in->a, &in->path_a) + size_of(in->b, &in->path_b));
	double dx = (double)(in->path_b.end.x - in->path_b.start.x - in->path_a.end.x + in->path_a.start.x);
	double dy = (double)(in->path_b.end.y - in->path_b.start.y - in->path_a.end.y + in->path_a.start.y);
	double travel = hypot(dx, dy) + fabs((double)in->path_a.turn) * (double)size_of(in->a, &in->path_a) +
		fabs((double)in->path_b.turn) * (double)size_of(in->b, &in->path_b);
	return fmax((double)in->tolerance, 5e-7 * (size + travel));
}

static void check_pair(const cni_toi_input *in, int32_t samples)
{
	cni_toi_result r = cni_toi(in);
	double tolerance = tolerance_of(in);
	double target = fmax((double)in->target + (double)in->a->radius + (double)in->b->radius, 1.0 * (double)in->tolerance);
	double start = distance_at(in, 0.0), least = 1e300;
	++seen.pairs;
	seen.hits += r.state == CNI_TOI_HIT;
	seen.separated += r.state == CNI_TOI_SEPARATED;
	seen.overlapped += r.state == CNI_TOI_OVERLAPPED;
	seen.failed += r.state == CNI_TOI_FAILED;
	seen.iterations_sum += (double)r.iterations;
	if (r.iterations > seen.iterations_most)
		seen.iterations_most = r.iterations;
	if (r.state == CNI_TOI_OVERLAPPED) {
		seen.below = greater(seen.below, start / tolerance);
		return;
	}
	if (r.state == CNI_TOI_HIT) {
		double at = distance_at(in, (double)r.fraction);
		double high = fmax(target, tolerance) + tolerance;
		seen.early = greater(seen.early, (at - high) / tolerance);
		if (r.fraction > 0.0f)
			seen.below = greater(seen.below, (target - at) / tolerance);
		seen.started_near += r.fraction == 0.0f;
	}
	for (int32_t i = 0; i <= samples && r.fraction > 0.0f; ++i)
		least = fmin(least, distance_at(in, (double)r.fraction * (double)i / (double)samples));
	if (r.fraction > 0.0f && (target - least) / tolerance > seen.breach) {
		seen.breach = (target - least) / tolerance;
		if (seen.breach > 1.0)
			printf("  breach: types %d %d, state %d, fraction %g, least %g, target %g\n", (int)in->a->type, (int)in->b->type, (int)r.state,
				(double)r.fraction, least, target);
	}
	if (r.state == CNI_TOI_FAILED)
		printf("  failed: types %d %d, fraction %.9g, %d iterations, distance %g, target %g, tolerance %g\n", (int)in->a->type, (int)in->b->type,
			(double)r.fraction, (int)r.iterations, distance_at(in, (double)r.fraction), target, tolerance);
}

static void seen_report(void)
{
	printf("  %d pairs: %d hit (%d near at the start), %d separated, %d overlapped; iterations %.2f mean, %d most\n", seen.pairs, seen.hits,
		seen.started_near, seen.separated, seen.overlapped, seen.iterations_sum / (double)seen.pairs, seen.iterations_most);
	CHECK_LE("failed", seen.failed, 0, "");
	CHECK_LE("nearer than the target before the fraction", seen.breach, 0.25, "tolerances");
	CHECK_LE("hit too early by", seen.early, 0.25, "tolerances");
	CHECK_LE("hit too late by", seen.below, 0.25, "tolerances");
}

/* ------------------------------------------------------------------ random motion */

static cni_path random_path(float size, float distance, float travel, float turn)
{
	cni_path p;
	float angle = random_in(-3.14f, 3.14f);
	p.start = random_vec(distance);
	p.end = cni_v(p.start.x + random_in(-travel, travel), p.start.y + random_in(-travel, travel));
	p.q.c = (float)cos((double)angle);
	p.q.s = (float)sin((double)angle);
	p.turn = random_below(4) == 0 ? 0.0f : random_in(-turn, turn);
	p.local_center = random_vec(0.3f * size);
	return p;
}

/* Aims b's end at a's. */
static void aim(cni_toi_input *in, float size)
{
	in->path_b.end = cni_v(2.0f * in->path_a.end.x - in->path_b.start.x + random_in(-size, size),
		2.0f * in->path_a.end.y - in->path_b.start.y + random_in(-size, size));
}

static void random_pairs(int32_t count, float size_a, float size_b, float distance, float turn, int32_t samples)
{
	static record a, b;
	seen_begin();
	for (int32_t k = 0; k < count; ++k) {
		cni_toi_input in;
		record_random(&a, k % 4, size_a);
		record_random(&b, (k / 4) % 4, size_b);
		memset(&in, 0, sizeof in);
		in.a = &a.g;
		in.b = &b.g;
		in.path_a = random_path(size_a, distance, distance, turn);
		in.path_b = random_path(size_b, distance, 2.0f * distance, turn);
		if (k & 16)
			aim(&in, size_a + size_b);
		in.tolerance = 0.00125f * cni_max(cni_min(size_a, size_b), 0.01f);
		in.target = (k & 32) ? in.tolerance : -0.5f * (a.g.radius + b.g.radius);
		check_pair(&in, samples);
	}
	seen_report();
}

static void t_random_pairs(void)
{
	random_state = 11u;
	random_pairs(TEST_SAMPLES(4000), 1.0f, 1.0f, 3.0f, 1.5f, 300);
}

static void t_fast_turns(void)
{
	random_state = 12u;
	random_pairs(TEST_SAMPLES(500), 1.0f, 1.0f, 2.0f, 30.0f, 3000);
}

static void t_large_and_tiny(void)
{
	random_state = 13u;
	random_pairs(TEST_SAMPLES(800), 20.0f, 0.05f, 20.0f, 3.0f, 600);
	random_pairs(TEST_SAMPLES(800), 0.02f, 0.02f, 0.5f, 6.0f, 300);
	random_pairs(TEST_SAMPLES(800), 500.0f, 1.0f, 400.0f, 1.0f, 600);
	random_pairs(TEST_SAMPLES(800), 500.0f, 700.0f, 900.0f, 1.0f, 300);
}

/* Bars of 100 to 1, flat boxes and needles, spinning. */
static void t_long_thin_shapes(void)
{
	static record a, b;
	random_state = 14u;
	seen_begin();
	for (int32_t k = 0; k < TEST_SAMPLES(500); ++k) {
		cni_toi_input in;
		memset(&in, 0, sizeof in);
		record_box(&a, random_in(1.0f, 5.0f), random_in(0.01f, 0.05f), k & 1 ? 0.01f : 0.0f, transform_none());
		if (k & 2)
			record_box(&b, random_in(0.02f, 3.0f), 0.02f, 0.0f, transform_make(random_in(-1.0f, 1.0f), 0.0f, random_in(-3.0f, 3.0f)));
		else
			record_capsule(&b, random_in(0.1f, 4.0f), 0.02f);
		in.a = &a.g;
		in.b = &b.g;
		in.path_a = random_path(0.5f, 4.0f, 4.0f, 12.0f);
		in.path_b = random_path(0.5f, 4.0f, 8.0f, k & 4 ? 12.0f : 0.0f);
		in.tolerance = 0.00125f;
		in.target = 0.00125f;
		check_pair(&in, 2000);
	}
	seen_report();
}

/* 400 m/s at 60 Hz against walls 1 cm thick: no bullet passes, spinning or not. */
static void t_bullets_never_pass_walls(void)
{
	static record wall, bullet;
	int passed = 0, missed = 0;
	float past = -1e30f;
	random_state = 15u;
	for (int32_t k = 0; k < TEST_SAMPLES(4000); ++k) {
		cni_toi_input in;
		cni_toi_result r;
		cn_edge edge = { { 0.0f, -50.0f }, { 0.0f, 50.0f } };
		float reach;
		memset(&in, 0, sizeof in);
		if (k & 1)
			record_box(&wall, 0.005f, 50.0f, 0.0f, transform_none());
		else
			cni_geometry_edge(&wall.g, &edge, transform_none());
		record_random(&bullet, k / 2 % 4, random_in(0.01f, 0.5f));
		reach = bullet.g.extent;
		in.a = &wall.g;
		in.b = &bullet.g;
		in.path_a.q.c = 1.0f;
		in.path_b = random_path(0.0f, 1.0f, 1.0f, k & 8 ? 60.0f : 0.0f);
		in.path_b.start = cni_v(-random_in(reach + 0.02f, 3.0f), random_in(-20.0f, 20.0f));
		in.path_b.end = cni_v(in.path_b.start.x + 400.0f / 60.0f, in.path_b.start.y + random_in(-6.0f, 6.0f));
		in.target = in.tolerance = 0.00125f;
		r = cni_toi(&in);
		missed += r.state != CNI_TOI_HIT;
		passed += r.fraction >= 1.0f;
		past = cni_max(past, in.path_b.start.x + r.fraction * 400.0f / 60.0f);
	}
	CHECK_LE("bullets that were not stopped", missed, 0, "");
	CHECK_LE("bullets that passed", passed, 0, "");
	CHECK_LE("farthest centre of a stopped bullet", past, 0.5, "m");
}

/* ------------------------------------------------------------------ closed forms */

static void t_known_answers(void)
{
	static record a, b;
	cni_toi_input in;
	cni_toi_result r;
	memset(&in, 0, sizeof in);
	/* A ball of radius 0.5 falls from 10 onto a box whose top is at 1, through 20 m. */
	record_box(&a, 5.0f, 1.0f, 0.0f, transform_none());
	record_circle(&b, 0.5f);
	in.a = &a.g;
	in.b = &b.g;
	in.path_a.q.c = in.path_b.q.c = 1.0f;
	in.path_b.start = cni_v(0.0f, 10.0f);
	in.path_b.end = cni_v(0.0f, -10.0f);
	in.tolerance = 1e-4f;
	r = cni_toi(&in);
	CHECK(r.state == CNI_TOI_HIT);
	CHECK_LE("error of the fraction", fabs((double)r.fraction - 8.5 / 20.0), 1e-5, "");
	CHECK_LE("error of the normal", fabs((double)r.normal.x) + fabs((double)r.normal.y - 1.0), 1e-6, "");
	CHECK_LE("error of the point", fabs((double)r.point.x) + fabs((double)r.point.y - 1.0), 2e-4, "m");
	CHECK_LE("iterations", r.iterations, 3, "");
	/* A rod of half length 2 turns by 90 degrees and hits a post at 45 degrees. */
	record_box(&a, 2.0f, 1e-2f, 0.0f, transform_none());
	record_circle(&b, 0.1f);
	memset(&in.path_b, 0, sizeof in.path_b);
	in.path_b.q.c = 1.0f;
	in.path_b.start = in.path_b.end = cni_v(1.0f, 1.0f);
	in.path_a.turn = 1.5707963f;
	r = cni_toi(&in);
	CHECK(r.state == CNI_TOI_HIT);
	CHECK_LE("error of the angle", fabs((double)r.fraction * 1.5707963 - (0.78539816 - asin(0.11 / 1.41421356))), 2e-4, "rad");
	printf("  %d iterations\n", (int)r.iterations);
	/* Five rotations, above a floor out of reach and above a floor within reach. */
	in.path_a.turn = 31.4159f;
	in.path_b.start = in.path_b.end = cni_v(0.0f, 2.11f);
	r = cni_toi(&in);
	CHECK(r.state == CNI_TOI_SEPARATED && r.fraction == 1.0f);
	printf("  out of reach: %d iterations\n", (int)r.iterations);
	in.path_b.start = in.path_b.end = cni_v(0.0f, 2.09f);
	r = cni_toi(&in);
	CHECK(r.state == CNI_TOI_HIT);
	/* Overlapping at the start. */
	in.path_b.start = in.path_b.end = cni_v(1.0f, 0.0f);
	CHECK(cni_toi(&in).state == CNI_TOI_OVERLAPPED);
}

/* A chain as ground, solid below, its edge from x = +5 to -5. */
static void t_chains_stop_from_the_front_only(void)
{
	static record a, b;
	cn_vec2 points[2] = { { 5.0f, 0.0f }, { -5.0f, 0.0f } };
	cn_chain chain = { points, 2, 0 };
	cni_toi_input in;
	memset(&in, 0, sizeof in);
	cni_geometry_chain(&a.g, &chain, transform_none());
	record_box(&b, 0.5f, 0.5f, 0.0f, transform_none());
	in.a = &a.g;
	in.b = &b.g;
	in.path_a.q.c = in.path_b.q.c = 1.0f;
	in.path_b.start = cni_v(0.0f, 3.0f);
	in.path_b.end = cni_v(0.0f, -3.0f);
	in.target = in.tolerance = 1e-3f;
	CHECK(cni_toi(&in).state == CNI_TOI_HIT);
	in.path_b.start.y = -3.0f;
	in.path_b.end.y = 3.0f;
	CHECK(cni_toi(&in).state == CNI_TOI_SEPARATED);
	in.a = &b.g;
	in.b = &a.g;
	in.path_a = in.path_b;
	memset(&in.path_b, 0, sizeof in.path_b);
	in.path_b.q.c = 1.0f;
	CHECK(cni_toi(&in).state == CNI_TOI_SEPARATED);
	in.path_a.start.y = 3.0f;
	in.path_a.end.y = -3.0f;
	CHECK(cni_toi(&in).state == CNI_TOI_HIT);
}

/* Swapping the two shapes gives the same time. */
static void t_swapping_changes_little(void)
{
	static record a, b;
	double worst = 0.0;
	int differ = 0;
	random_state = 16u;
	for (int32_t k = 0; k < TEST_SAMPLES(2000); ++k) {
		cni_toi_input in, swapped;
		cni_toi_result r, s;
		record_random(&a, k % 4, 1.0f);
		record_random(&b, (k / 4) % 4, 1.0f);
		memset(&in, 0, sizeof in);
		in.a = &a.g;
		in.b = &b.g;
		in.path_a = random_path(1.0f, 3.0f, 3.0f, 2.0f);
		in.path_b = random_path(1.0f, 3.0f, 6.0f, 2.0f);
		in.target = in.tolerance = 0.001f;
		swapped = in;
		swapped.a = in.b;
		swapped.b = in.a;
		swapped.path_a = in.path_b;
		swapped.path_b = in.path_a;
		r = cni_toi(&in);
		s = cni_toi(&swapped);
		if (r.state == CNI_TOI_HIT && s.state == CNI_TOI_HIT)
			worst = greater(worst, fabs((double)r.fraction - (double)s.fraction));
		else
			differ += r.state != s.state;
	}
	CHECK_LE("difference of fractions", worst, 1e-4, "");
	CHECK_LE("different states (grazing)", differ, 4, "");
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(t_known_answers);
	RUN(t_random_pairs);
	RUN(t_fast_turns);
	RUN(t_large_and_tiny);
	RUN(t_long_thin_shapes);
	RUN(t_bullets_never_pass_walls);
	RUN(t_chains_stop_from_the_front_only);
	RUN(t_swapping_changes_little);
	return test_end();
}
