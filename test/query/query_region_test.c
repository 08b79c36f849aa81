/*
 * query_region_test - promise: overlaps list exactly the shapes in a region, each once and in order; a moved
 * shape stops at the first one it meets; the closest point is the closest.
 *
 * Checked against distances to every shape in double precision.
 */
#include "queries.h"

/* ------------------------------------------------------------------ overlaps */

typedef double region_depth_fn(const cni_shape *s, int32_t child, const void *region);

static double box_depth(const cni_shape *s, int32_t child, const void *region)
{
	const cn_aabb *box = (const cn_aabb *)region;
	double_set set = child_set(s, child);
	double x0 = 1e300, y0 = 1e300, x1 = -1e300, y1 = -1e300;
	int32_t i;
	for (i = 0; i < set.count; ++i) {
		x0 = fmin(x0, set.x[i] - set.radius);
		y0 = fmin(y0, set.y[i] - set.radius);
		x1 = greater(x1, set.x[i] + set.radius);
		y1 = greater(y1, set.y[i] + set.radius);
	}
	return fmax(fmax(x0 - (double)box->upper_m.x, (double)box->lower_m.x - x1), fmax(y0 - (double)box->upper_m.y, (double)box->lower_m.y - y1));
}

static double set_depth(const cni_shape *s, int32_t child, const void *region)
{
	double_set set = child_set(s, child);
	return distance_of(&set, (const double_set *)region, 0.0, 0.0);
}

static double point_depth(const cni_shape *s, int32_t child, const void *region)
{
	return s->type == CN_SHAPE_EDGE || s->type == CN_SHAPE_CHAIN ? 1e9 : set_depth(s, child, region);
}

static struct { int lists, shapes, missing, extra, disordered; } lists_seen;

/* A list must hold what is deeper than rounding, may hold what touches, in the order of all shapes. */
static void check_list(const cn_shape *list, int32_t count, const cn_query_filter *filter, region_depth_fn *depth, const void *region, double epsilon)
{
	int32_t k, child, next = 0;
	++lists_seen.lists;
	lists_seen.shapes += count;
	for (k = 0; k < all_count; ++k) {
		const cni_shape *s = record_of(all_shapes[k]);
		double least = 1e300;
		int listed = next < count && list[next] == all_shapes[k];
		next += listed;
		if (seen_by(all_shapes[k], filter))
			for (child = 0; child < cni_shape_children(&w->blocks, s); ++child)
				least = fmin(least, depth(s, child, region));
		lists_seen.missing += !listed && least < -epsilon;
		lists_seen.extra += listed && least > epsilon;
	}
	lists_seen.disordered += next != count;
}

static void check_regions(float center, double epsilon)
{
	static cn_shape list[SHAPES_MAX];
	cn_query_filter filter = random_filter();
	cn_polygon polygon = random_region(center, 1 + below(3));
	cn_circle circle;
	cn_aabb box;
	double_set set = region_set(&polygon);
	int32_t count;
	must(cn_world_overlap_polygon(w, &polygon, &filter, list, SHAPES_MAX, &count), w, "overlap_polygon");
	check_list(list, count, &filter, set_depth, &set, epsilon);
	circle.center_m = polygon.points_m[0];
	circle.radius_m = polygon.radius_m + 0.5f;
	polygon.count = 1;
	polygon.radius_m = circle.radius_m;
	set = region_set(&polygon);
	must(cn_world_overlap_circle(w, &circle, &filter, list, SHAPES_MAX, &count), w, "overlap_circle");
	check_list(list, count, &filter, set_depth, &set, epsilon);
	set.radius = 0.0;
	must(cn_world_overlap_point(w, circle.center_m.x, circle.center_m.y, &filter, list, SHAPES_MAX, &count), w, "overlap_point");
	check_list(list, count, &filter, point_depth, &set, epsilon);
	box.lower_m = box.upper_m = circle.center_m;
	box.upper_m.x += rnd(0.0f, 8.0f);
	box.upper_m.y += rnd(0.0f, 8.0f);
	must(cn_world_overlap_aabb(w, &box, &filter, list, SHAPES_MAX, &count), w, "overlap_aabb");
	check_list(list, count, &filter, box_depth, &box, epsilon);
}

static void lists_report(void)
{
	printf("  %d lists of %d shapes\n", lists_seen.lists, lists_seen.shapes);
	CHECK_LE("missing", lists_seen.missing, 0, "");
	CHECK_LE("listed without overlap", lists_seen.extra, 0, "");
	CHECK_LE("lists with repetitions or out of order", lists_seen.disordered, 0, "");
	CHECK_GE("shapes listed", lists_seen.shapes, lists_seen.lists, "");
}

static void t_overlaps_list_what_is_there(void)
{
	int32_t round, k;
	memset(&lists_seen, 0, sizeof lists_seen);
	for (round = 0; round < 3; ++round) {
		float center = round == 2 ? 3000.0f : 0.0f;
		double epsilon = round == 2 ? 2e-3 : 2e-5;
		random_world(200u + (uint32_t)round, center);
		list_shapes();
		for (k = 0; k < TEST_SAMPLES(150); ++k)
			check_regions(center, epsilon);
		shuffle_bodies(center);
		list_shapes();
		for (k = 0; k < TEST_SAMPLES(150); ++k)
			check_regions(center, epsilon);
		cn_world_destroy(w);
	}
	lists_report();
}

/* More chains in one region than the query remembers, each with several edges in it. */
static void t_many_chains_are_listed_once(void)
{
	static cn_shape list[SHAPES_MAX];
	cn_aabb box = { { -100.0f, -100.0f }, { 100.0f, 100.0f } };
	cn_polygon polygon;
	int32_t k, count;
	seed = 9u;
	w = fixture_world(0.0f, 1);
	for (k = 0; k < 150; ++k) {
		place at = random_place(0.0f, 5.0f);
		cn_shape_def sd = fixture_shape_def(fixture_body(w, CN_BODY_STATIC, at.x, at.y, at.angle), 0.5f, 0.0f);
		random_chain(&sd);
	}
	list_shapes();
	must(cn_world_overlap_aabb(w, &box, NULL, list, SHAPES_MAX, &count), w, "overlap_aabb");
	CHECK_LE("shapes listed", count, 150, "");
	CHECK_GE("shapes listed", count, 150, "");
	memset(&lists_seen, 0, sizeof lists_seen);
	for (k = 0; k < 100; ++k) {
		cn_query_filter filter;
		double_set set;
		cn_query_filter_init(&filter);
		polygon = random_region(0.0f, 3);
		set = region_set(&polygon);
		must(cn_world_overlap_polygon(w, &polygon, NULL, list, SHAPES_MAX, &count), w, "overlap_polygon");
		check_list(list, count, &filter, set_depth, &set, 2e-5);
	}
	lists_report();
	cn_world_destroy(w);
}

/* ------------------------------------------------------------------ moved shapes */

static struct { int casts, hits, late, early, wrong_shape; double distance; } moved_seen;

static void check_moved(float center, double epsilon)
{
	cn_query_filter filter = random_filter();
	cn_polygon polygon = random_region(center, 1 + below(3));
	cn_ray way = random_ray(center);
	double dx = (double)way.translation_m.x, dy = (double)way.translation_m.y, until;
	double_set moving = region_set(&polygon), met;
	cn_ray_hit hit;
	int32_t k, child;
	must(cn_world_cast_shape(w, &polygon, way.translation_m.x, way.translation_m.y, &filter, &hit), w, "cast_shape");
	++moved_seen.casts;
	moved_seen.hits += hit.shape != 0;
	until = (double)hit.fraction;
	for (k = 0; k < all_count; ++k) {
		const cni_shape *s = record_of(all_shapes[k]);
		if (!seen_by(all_shapes[k], &filter) || s->type == CN_SHAPE_CHAIN) /* chains have a test of their own */
			continue;
		for (child = 0; child < cni_shape_children(&w->blocks, s); ++child) {
			double_set set = child_set(s, child);
			moved_seen.late += trace(&set, &moving, dx, dy, -epsilon, until) < until;
		}
	}
	if (hit.shape == 0)
		return;
	moved_seen.wrong_shape += !seen_by(hit.shape, &filter);
	met = child_set(record_of(hit.shape), hit.child);
	moved_seen.distance = greater(moved_seen.distance, distance_of(&met, &moving, until * dx, until * dy));
	if (hit.depth_m > 0.0f) {
		double left = distance_of(&met, &moving, (double)(hit.depth_m * hit.normal.x), (double)(hit.depth_m * hit.normal.y));
		/* The way out of a chain is to its front: there may be a shorter one past an end. */
		moved_seen.distance = greater(moved_seen.distance, record_of(hit.shape)->type == CN_SHAPE_CHAIN ? -fmin(left, 0.0) : fabs(left));
	} else
		moved_seen.distance = greater(moved_seen.distance, fabs(set_distance_to_point(&met, (double)hit.point_m.x, (double)hit.point_m.y, 0.0, 0.0)));
}

static void t_moved_shapes_stop_at_the_first(void)
{
	int32_t k;
	memset(&moved_seen, 0, sizeof moved_seen);
	random_world(300u, 0.0f);
	list_shapes();
	for (k = 0; k < 200; ++k)
		check_moved(0.0f, 2e-4);
	shuffle_bodies(0.0f);
	list_shapes();
	for (k = 0; k < 200; ++k)
		check_moved(0.0f, 2e-4);
	printf("  %d casts, %d hits\n", moved_seen.casts, moved_seen.hits);
	CHECK_LE("casts that went into a shape", moved_seen.late, 0, "");
	CHECK_LE("distance of the shapes, and of the point from the surface", moved_seen.distance, 1e-4, "m");
	CHECK_LE("hits that the filter forbids", moved_seen.wrong_shape, 0, "");
	cn_world_destroy(w);
}

static void t_chains_stop_moved_shapes_from_the_front(void)
{
	cn_vec2 points[3] = { { 10.0f, 0.0f }, { 0.0f, 0.0f }, { -10.0f, 0.0f } };
	cn_chain chain = { points, 3, 0 };
	cn_polygon ball = { 1, 0.5f, { { 3.0f, 5.0f } } };
	cn_ray_hit hit;
	cn_shape_def sd;
	w = fixture_world(0.0f, 1);
	sd = fixture_shape_def(fixture_body(w, CN_BODY_STATIC, 0.0f, 1.0f, 0.0f), 0.5f, 0.0f);
	must(cn_shape_create_chain(w, &sd, &chain, NULL), w, "chain");
	must(cn_world_cast_shape(w, &ball, 0.0f, -7.0f, NULL, &hit), w, "cast_shape");
	CHECK(hit.shape != 0 && hit.child == 0 && hit.fraction == 0.5f && hit.normal.y == 1.0f && hit.point_m.y == 1.0f && hit.point_m.x == 3.0f);
	ball.points_m[0].y = -5.0f;
	must(cn_world_cast_shape(w, &ball, 0.0f, 10.0f, NULL, &hit), w, "cast_shape");
	CHECK(hit.shape == 0 && hit.fraction == 1.0f);
	cn_world_destroy(w);
}

/* ------------------------------------------------------------------ closest point */

static void check_closest(float center, double epsilon, int *wrong, double *worst)
{
	cn_query_filter filter = random_filter();
	float x = center + rnd(-HALF, HALF), y = rnd(-HALF, HALF), most = below(2) ? 1000.0f : rnd(0.0f, 3.0f);
	double_set point = { { (double)x }, { (double)y }, 0.0, 1 };
	double best = 1e300;
	cn_closest found;
	int32_t k, child;
	must(cn_world_closest_point(w, x, y, most, &filter, &found), w, "closest_point");
	for (k = 0; k < all_count; ++k) {
		const cni_shape *s = record_of(all_shapes[k]);
		if (!seen_by(all_shapes[k], &filter))
			continue;
		for (child = 0; child < cni_shape_children(&w->blocks, s); ++child) {
			double_set set = child_set(s, child);
			best = fmin(best, distance_of(&set, &point, 0.0, 0.0));
		}
	}
	if (found.shape == 0) {
		*wrong += best < (double)most - epsilon;
		return;
	}
	double_set met = child_set(record_of(found.shape), found.child);
	*wrong += !seen_by(found.shape, &filter);
	*worst = greater(*worst, fabs((double)found.distance_m - best));
	*worst = greater(*worst, fabs(set_distance_to_point(&met, (double)found.point_m.x, (double)found.point_m.y, 0.0, 0.0)));
	*worst = greater(*worst, fabs((double)found.point_m.x + (double)(found.distance_m * found.normal.x) - (double)x));
	*worst = greater(*worst, fabs((double)found.point_m.y + (double)(found.distance_m * found.normal.y) - (double)y));
}

static void t_closest_point_is_the_closest(void)
{
	int32_t k;
	int wrong = 0;
	double worst = 0.0;
	random_world(400u, 0.0f);
	list_shapes();
	for (k = 0; k < 400; ++k)
		check_closest(0.0f, 2e-5, &wrong, &worst);
	shuffle_bodies(0.0f);
	list_shapes();
	for (k = 0; k < 400; ++k)
		check_closest(0.0f, 2e-5, &wrong, &worst);
	CHECK_LE("wrong answers", wrong, 0, "");
	CHECK_LE("error of distance, point and normal", worst, 2e-5, "m");
	cn_world_destroy(w);
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(t_overlaps_list_what_is_there);
	RUN(t_many_chains_are_listed_once);
	RUN(t_moved_shapes_stop_at_the_first);
	RUN(t_chains_stop_moved_shapes_from_the_front);
	RUN(t_closest_point_is_the_closest);
	return test_end();
}
