/*
 * query_test - promise: every query finds exactly what is there, whatever the shapes, filters and history of
 * the world: bodies moved without a step, destroyed, disabled, asleep; sensors only when asked for; in an
 * order that does not depend on the broadphase; and queries change nothing.
 *
 * Checked against looking at every shape: rays by cn_shape_cast_ray (bit by bit), the others by distances
 * in double precision.
 */
#include "fixture.h"
#include "geometry/nearest.h"
#include "geometry/sets.h"
#include "model/world.h"

#include <time.h>

#define BODIES 220
#define SHAPES_MAX 1024
#define HALF 24.0f

static cn_world *w;
static cn_body bodies[BODIES];
static uint32_t seed;
static int32_t broadphase_kind = CN_BROADPHASE_SWEEP;

static float rnd(float lower, float upper) { return fixture_random(&seed, lower, upper); }
static int32_t below(int32_t count) { return (int32_t)rnd(0.0f, (float)count - 0.001f); }

/* Where a body is put; one call a number, in a fixed order on every compiler. */
typedef struct place { float x, y, angle; } place;

static place random_place(float center, float half)
{
	place p;
	p.x = center + rnd(-half, half);
	p.y = rnd(-half, half);
	p.angle = rnd(-3.0f, 3.0f);
	return p;
}

/* ------------------------------------------------------------------ random worlds */

static void random_chain(const cn_shape_def *sd)
{
	cn_vec2 points[24];
	cn_chain chain = { points, 0, 0 };
	int32_t k;
	chain.loop = below(2) ? 1u : 0u;
	chain.count = chain.loop ? 3 + below(10) : 2 + below(22);
	for (k = 0; k < chain.count; ++k) {
		double angle = 6.2831853 * (double)k / (double)chain.count;
		points[k].x = chain.loop ? 2.0f * (float)cos(angle) : 0.7f * (float)(chain.count / 2 - k);
		points[k].y = chain.loop ? 1.5f * (float)sin(angle) : rnd(-0.4f, 0.4f);
	}
	must(cn_shape_create_chain(w, sd, &chain, NULL), w, "chain");
}

static void random_shape(cn_body body, int32_t type)
{
	cn_shape_def sd = fixture_shape_def(body, 0.5f, 0.0f);
	cn_circle circle = { { 0.0f, 0.0f }, 0.0f };
	cn_capsule capsule = { { 0.0f, 0.0f }, { 0.0f, 0.0f }, 0.0f };
	cn_edge edge = { { -1.0f, 0.0f }, { 1.0f, 0.2f } };
	cn_vec2 cloud[12];
	cn_polygon hull;
	int32_t k;
	sd.offset_m.x = rnd(-0.5f, 0.5f);
	sd.offset_m.y = rnd(-0.5f, 0.5f);
	sd.angle_rad = rnd(-3.0f, 3.0f);
	sd.filter.category = 1ull << below(4);
	sd.filter.mask = below(4) ? ~0ull : 1ull << below(4);
	sd.flags = below(8) ? 0u : CN_SHAPE_SENSOR | (below(2) ? (uint32_t)CN_SHAPE_SENSOR_SEEN : 0u);
	circle.radius_m = rnd(0.1f, 1.0f);
	capsule.a_m.x = -rnd(0.2f, 1.0f);
	capsule.b_m.x = -capsule.a_m.x;
	capsule.radius_m = rnd(0.1f, 0.5f);
	switch (type) {
	case CN_SHAPE_CIRCLE: must(cn_shape_create_circle(w, &sd, &circle, NULL), w, "circle"); break;
	case CN_SHAPE_CAPSULE: must(cn_shape_create_capsule(w, &sd, &capsule, NULL), w, "capsule"); break;
	case CN_SHAPE_EDGE: must(cn_shape_create_edge(w, &sd, &edge, NULL), w, "edge"); break;
	case CN_SHAPE_CHAIN: random_chain(&sd); break;
	default:
		for (k = 0; k < 12; ++k) {
			cloud[k].x = rnd(-1.0f, 1.0f);
			cloud[k].y = rnd(-0.8f, 0.8f);
		}
		must(cn_polygon_make_hull(cloud, 12, below(2) ? 0.0f : rnd(0.02f, 0.3f), &hull), NULL, "hull");
		must(cn_shape_create_polygon(w, &sd, &hull, NULL), w, "polygon");
	}
}

static cn_world *make_world(float gravity)
{
	cn_world_def def;
	cn_world *world = NULL;
	cn_world_def_init(&def);
	def.gravity_mps2.y = gravity;
	def.broadphase = broadphase_kind;
	must(cn_world_create(&def, &world), NULL, "cn_world_create");
	return world;
}

static void random_world(uint32_t with_seed, float center)
{
	int32_t k, n;
	seed = with_seed;
	w = make_world(-10.0f);
	fixture_box(w, CN_BODY_STATIC, center, -HALF - 1.0f, 0.0f, 2.0f * HALF, 1.0f, 0.6f, 0.0f);
	for (k = 0; k < BODIES; ++k) {
		int32_t type = below(3);
		place at = random_place(center, HALF);
		bodies[k] = fixture_body(w, type, at.x, at.y, at.angle);
		for (n = 1 + below(3); n > 0; --n)
			random_shape(bodies[k], type == CN_BODY_DYNAMIC ? below(3) : below(5));
	}
	fixture_step(w, 40);
}

/* What games do between two steps. */
static void shuffle_bodies(float center)
{
	cn_shape shapes[8];
	place at;
	int32_t k, count;
	for (k = 0; k < BODIES; ++k) {
		if (!cn_body_is_valid(w, bodies[k]))
			continue;
		switch (below(12)) {
		case 0:
		case 1:
		case 2:
			at = random_place(center, HALF);
			must(cn_body_set_pose(w, bodies[k], at.x, at.y, at.angle), w, "set_pose");
			break;
		case 3: must(cn_body_destroy(w, bodies[k]), w, "destroy"); break;
		case 4: must(cn_body_set_flags(w, bodies[k], below(2) ? CN_BODY_SLEEP : CN_BODY_SLEEP | CN_BODY_ENABLED), w, "set_flags"); break;
		case 5: must(cn_body_set_awake(w, bodies[k], 0), w, "set_awake"); break;
		case 6:
			must(cn_body_get_shapes(w, bodies[k], shapes, 8, &count), w, "get_shapes");
			if (count > 1)
				must(cn_shape_detach(w, shapes[0]), w, "detach");
			break;
		default: break;
		}
	}
}

static cn_query_filter random_filter(void)
{
	cn_query_filter f;
	cn_query_filter_init(&f);
	if (below(3) == 0)
		f.mask = 1ull << below(4);
	if (below(3) == 0)
		f.category = 1ull << below(4);
	return f;
}

/* ------------------------------------------------------------------ reference */

static cn_shape all_shapes[SHAPES_MAX];
static int32_t all_count;

/* By the public API alone. */
static int seen_by(cn_shape shape, const cn_query_filter *filter)
{
	cn_body body = 0;
	cn_filter f;
	uint32_t flags = 0, body_flags = 0;
	must(cn_shape_get_body(w, shape, &body), w, "get_body");
	must(cn_shape_get_filter(w, shape, &f), w, "get_filter");
	must(cn_shape_get_flags(w, shape, &flags), w, "get_flags");
	if (body == 0)
		return 0;
	must(cn_body_get_flags(w, body, &body_flags), w, "body_get_flags");
	if (!(body_flags & CN_BODY_ENABLED) || ((flags & CN_SHAPE_SENSOR) && !(flags & CN_SHAPE_SENSOR_SEEN)))
		return 0;
	return (f.category & filter->mask) != 0 && (f.mask & filter->category) != 0;
}

static void list_shapes(void)
{
	must(cn_world_get_shapes(w, all_shapes, SHAPES_MAX, &all_count), w, "get_shapes");
}

static const cni_shape *record_of(cn_shape shape) { return cni_shape_at(w, (int32_t)(shape & 0xFFFFFu)); }

static double_set child_set(const cni_shape *s, int32_t child)
{
	cni_vec2 storage[2];
	return set_of(cni_geometry_proxy(cni_shape_geometry(&w->blocks, s), child, storage), cni_body_transform(cni_body_at(w, s->body)));
}

static int same(const void *a, const void *b, size_t bytes) { return memcmp(a, b, bytes) == 0; }

static int hit_is_before(const cn_ray_hit *a, const cn_ray_hit *b)
{
	if (a->fraction != b->fraction)
		return a->fraction < b->fraction;
	return (a->shape & 0xFFFFFu) < (b->shape & 0xFFFFFu);
}

static cn_ray random_ray(float center)
{
	cn_ray ray;
	ray.origin_m.x = center + rnd(-HALF, HALF);
	ray.origin_m.y = rnd(-HALF, HALF);
	ray.translation_m.x = rnd(-1.0f, 1.0f) * (below(2) ? 50.0f : 5.0f);
	ray.translation_m.y = rnd(-1.0f, 1.0f) * (below(2) ? 50.0f : 5.0f);
	if (below(12) == 0)
		ray.translation_m.x = 0.0f;
	if (below(12) == 0)
		ray.translation_m.y = 0.0f;
	return ray;
}

/* ------------------------------------------------------------------ rays */

static struct { int rays, hits, wrong, any_wrong, all_wrong, inside; } rays_seen;

static void check_ray(const cn_ray *ray, const cn_query_filter *filter)
{
	cn_ray_hit best, hit, found, list[256];
	int32_t k, any = -1, count = -1, hits = 0;
	memset(&best, 0, sizeof best);
	best.fraction = 1.0f;
	for (k = 0; k < all_count; ++k) {
		if (!seen_by(all_shapes[k], filter))
			continue;
		must(cn_shape_cast_ray(w, all_shapes[k], ray, &hit), w, "shape_cast_ray");
		hits += hit.shape != 0;
		if (hit.shape != 0 && (best.shape == 0 || hit_is_before(&hit, &best)))
			best = hit;
	}
	must(cn_world_cast_ray(w, ray, filter, &found), w, "cast_ray");
	must(cn_world_cast_ray_any(w, ray, filter, &any), w, "cast_ray_any");
	must(cn_world_cast_ray_all(w, ray, filter, list, 256, &count), w, "cast_ray_all");
	++rays_seen.rays;
	rays_seen.hits += found.shape != 0;
	rays_seen.inside += found.shape != 0 && found.normal.x == 0.0f && found.normal.y == 0.0f;
	rays_seen.wrong += !same(&found, &best, sizeof best);
	rays_seen.any_wrong += any != (hits > 0);
	/* Chains are in the list once an edge, so there may be more. */
	rays_seen.all_wrong += count < hits || (count > 0 && !same(&list[0], &best, sizeof best));
	for (k = 1; k < count; ++k)
		rays_seen.all_wrong += list[k].fraction < list[k - 1].fraction;
}

static void ray_phase(float center, int32_t rays)
{
	int32_t k;
	list_shapes();
	for (k = 0; k < rays; ++k) {
		cn_ray ray = random_ray(center);
		cn_query_filter filter = random_filter();
		check_ray(&ray, &filter);
	}
}

static void rays_report(void)
{
	printf("  %d rays: %d hit, %d of them from inside\n", rays_seen.rays, rays_seen.hits, rays_seen.inside);
	CHECK_LE("wrong nearest hits", rays_seen.wrong, 0, "");
	CHECK_LE("wrong answers whether anything is hit", rays_seen.any_wrong, 0, "");
	CHECK_LE("wrong lists of hits", rays_seen.all_wrong, 0, "");
	CHECK_GE("hits", rays_seen.hits, rays_seen.rays / 3, "");
}

static void t_rays_find_the_nearest(void)
{
	int32_t round;
	memset(&rays_seen, 0, sizeof rays_seen);
	for (round = 0; round < 4; ++round) {
		float center = round >= 2 ? 3000.0f : 0.0f;
		broadphase_kind = round & 1 ? CN_BROADPHASE_TREE : CN_BROADPHASE_SWEEP;
		random_world(100u + (uint32_t)round, center);
		ray_phase(center, 400);
		shuffle_bodies(center);
		ray_phase(center, 400);
		fixture_step(w, 20);
		ray_phase(center, 200);
		CHECK(fixture_is_valid(w));
		cn_world_destroy(w);
	}
	broadphase_kind = CN_BROADPHASE_SWEEP;
	rays_report();
}

static void t_batches_equal_single_rays(void)
{
	static cn_ray rays[500];
	static cn_ray_hit many[500];
	cn_query_filter filter;
	int32_t k, different = 0;
	random_world(7u, 0.0f);
	filter = random_filter();
	for (k = 0; k < 500; ++k)
		rays[k] = random_ray(0.0f);
	must(cn_world_cast_rays(w, rays, 500, &filter, many), w, "cast_rays");
	for (k = 0; k < 500; ++k) {
		cn_ray_hit one;
		must(cn_world_cast_ray(w, &rays[k], &filter, &one), w, "cast_ray");
		different += !same(&one, &many[k], sizeof one);
	}
	CHECK_LE("hits of the batch that differ from single ones", different, 0, "");
	CHECK(cn_world_cast_rays(w, NULL, 0, NULL, NULL) == CN_OK);
	cn_world_destroy(w);
}

/* Any capacity gives the first of the full list and the full count. */
static void t_capacity_keeps_the_first(void)
{
	cn_ray ray = { { -HALF, 1.0f }, { 2.0f * HALF, -3.0f } };
	cn_aabb box = { { -HALF, -HALF }, { HALF, HALF } };
	static cn_ray_hit hits[256], some[256];
	static cn_shape shapes[SHAPES_MAX], few[SHAPES_MAX];
	int32_t count, again, capacity, wrong = 0;
	random_world(8u, 0.0f);
	must(cn_world_cast_ray_all(w, &ray, NULL, hits, 256, &count), w, "cast_ray_all");
	CHECK_GE("hits along the ray", count, 5, "");
	for (capacity = 0; capacity <= count; ++capacity) {
		must(cn_world_cast_ray_all(w, &ray, NULL, capacity > 0 ? some : NULL, capacity, &again), w, "cast_ray_all");
		wrong += again != count || !same(some, hits, (size_t)capacity * sizeof *hits);
	}
	must(cn_world_overlap_aabb(w, &box, NULL, shapes, SHAPES_MAX, &count), w, "overlap_aabb");
	CHECK_GE("shapes in the box", count, 100, "");
	for (capacity = 0; capacity <= count; capacity += 7) {
		must(cn_world_overlap_aabb(w, &box, NULL, capacity > 0 ? few : NULL, capacity, &again), w, "overlap_aabb");
		wrong += again != count || !same(few, shapes, (size_t)capacity * sizeof *shapes);
	}
	CHECK_LE("wrong lists", wrong, 0, "");
	cn_world_destroy(w);
}

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
		x1 = fmax(x1, set.x[i] + set.radius);
		y1 = fmax(y1, set.y[i] + set.radius);
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
			for (child = 0; child < s->children; ++child)
				least = fmin(least, depth(s, child, region));
		lists_seen.missing += !listed && least < -epsilon;
		lists_seen.extra += listed && least > epsilon;
	}
	lists_seen.disordered += next != count;
}

static cn_polygon random_region(float center, int32_t points)
{
	cn_polygon p;
	cn_vec2 cloud[10];
	float x = center + rnd(-HALF, HALF), y = rnd(-HALF, HALF), size = below(3) ? rnd(0.2f, 2.0f) : rnd(3.0f, 10.0f);
	int32_t k;
	for (k = 0; k < 10; ++k) {
		cloud[k].x = x + rnd(-size, size);
		cloud[k].y = y + rnd(-size, size);
	}
	if (points > 2) {
		must(cn_polygon_make_hull(cloud, 10, 0.0f, &p), NULL, "hull");
	} else {
		memset(&p, 0, sizeof p);
		p.count = points;
		p.points_m[0] = cloud[0];
		p.points_m[1] = cloud[1];
	}
	p.radius_m = points > 2 && below(2) ? 0.0f : rnd(0.05f, 1.0f);
	if (points > 2 && below(3) == 0)
		for (k = 0; k < p.count / 2; ++k) { /* clockwise is as good */
			cn_vec2 kept = p.points_m[k];
			p.points_m[k] = p.points_m[p.count - 1 - k];
			p.points_m[p.count - 1 - k] = kept;
		}
	return p;
}

static double_set region_set(const cn_polygon *p)
{
	cni_transform none = { { 1.0f, 0.0f }, { 0.0f, 0.0f } };
	cni_vec2 points[CN_POLYGON_MAX_VERTICES];
	cni_proxy_points set;
	int32_t k;
	set.points = points;
	set.count = p->count;
	set.radius = p->radius_m;
	memcpy(points, p->points_m, sizeof points);
	if (p->count > 2 && (points[1].x - points[0].x) * (points[2].y - points[0].y) < (points[1].y - points[0].y) * (points[2].x - points[0].x))
		for (k = 0; k < p->count; ++k)
			points[k] = p->points_m[p->count - 1 - k];
	return set_of(set, none);
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
		for (k = 0; k < 150; ++k)
			check_regions(center, epsilon);
		shuffle_bodies(center);
		list_shapes();
		for (k = 0; k < 150; ++k)
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
		for (child = 0; child < s->children; ++child) {
			double_set set = child_set(s, child);
			moved_seen.late += trace(&set, &moving, dx, dy, -epsilon, until) < until;
		}
	}
	if (hit.shape == 0)
		return;
	moved_seen.wrong_shape += !seen_by(hit.shape, &filter);
	met = child_set(record_of(hit.shape), hit.child);
	moved_seen.distance = fmax(moved_seen.distance, distance_of(&met, &moving, until * dx, until * dy));
	if (hit.normal.x != 0.0f || hit.normal.y != 0.0f)
		moved_seen.distance = fmax(moved_seen.distance, fabs(set_distance_to_point(&met, (double)hit.point_m.x, (double)hit.point_m.y, 0.0, 0.0)));
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
		for (child = 0; child < s->children; ++child) {
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
	*worst = fmax(*worst, fabs((double)found.distance_m - best));
	*worst = fmax(*worst, fabs(set_distance_to_point(&met, (double)found.point_m.x, (double)found.point_m.y, 0.0, 0.0)));
	*worst = fmax(*worst, fabs((double)found.point_m.x + (double)(found.distance_m * found.normal.x) - (double)x));
	*worst = fmax(*worst, fabs((double)found.point_m.y + (double)(found.distance_m * found.normal.y) - (double)y));
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

/* ------------------------------------------------------------------ order of visits */

/* A broadphase that finds the same boxes in another order. */
static void backward_query(const cni_broadphase *broadphase, const cni_aabb *box, cni_query_fn *visit, void *context)
{
	int32_t id;
	(void)broadphase;
	for (id = w->proxy_used - 1; id >= 0; --id)
		if ((cni_proxy_at(w, id)->flags & CNI_PROXY_ALIVE) && cni_aabb_overlap(&cni_proxy_at(w, id)->fat, box) && visit(context, id, 1.0f) == 0.0f)
			return;
}

static void backward_ray(const cni_broadphase *broadphase, cni_vec2 origin, cni_vec2 translation, cni_query_fn *visit, void *context)
{
	int32_t id;
	float limit = 1.0f;
	(void)broadphase;
	(void)origin;
	(void)translation;
	for (id = w->proxy_used - 1; id >= 0 && limit > 0.0f; --id)
		if (cni_proxy_at(w, id)->flags & CNI_PROXY_ALIVE)
			limit = visit(context, id, limit);
}

typedef struct answers {
	cn_ray_hit hit, moved, list[8];
	cn_closest closest;
	cn_shape shapes[3][16];
	int32_t counts[4];
} answers;

static void answer(answers *a, const cn_ray *ray, const cn_polygon *polygon, const cn_query_filter *filter)
{
	cn_aabb box;
	memset(a, 0, sizeof *a);
	box.lower_m = ray->origin_m;
	box.upper_m.x = ray->origin_m.x + 8.0f;
	box.upper_m.y = ray->origin_m.y + 8.0f;
	must(cn_world_cast_ray(w, ray, filter, &a->hit), w, "cast_ray");
	must(cn_world_cast_ray_all(w, ray, filter, a->list, 8, &a->counts[0]), w, "cast_ray_all");
	must(cn_world_cast_shape(w, polygon, ray->translation_m.x, ray->translation_m.y, filter, &a->moved), w, "cast_shape");
	must(cn_world_overlap_aabb(w, &box, filter, a->shapes[0], 16, &a->counts[1]), w, "overlap_aabb");
	must(cn_world_overlap_polygon(w, polygon, filter, a->shapes[1], 16, &a->counts[2]), w, "overlap_polygon");
	must(cn_world_overlap_point(w, ray->origin_m.x, ray->origin_m.y, filter, a->shapes[2], 16, &a->counts[3]), w, "overlap_point");
	must(cn_world_closest_point(w, ray->origin_m.x, ray->origin_m.y, 20.0f, filter, &a->closest), w, "closest_point");
}

/* Also where many answers are equal: shapes on top of each other. */
static void t_answers_do_not_depend_on_the_broadphase(void)
{
	cni_broadphase_ops backward;
	const cni_broadphase_ops *forward;
	int32_t k, different = 0;
	random_world(500u, 0.0f);
	for (k = 0; k < 60; ++k)
		fixture_box(w, CN_BODY_STATIC, (float)(k / 5), 0.0f, 0.0f, 0.5f, 0.5f, 0.5f, 0.0f);
	shuffle_bodies(0.0f);
	forward = w->broadphase_ops;
	backward = *forward;
	backward.query = backward_query;
	backward.ray = backward_ray;
	for (k = 0; k < 1500; ++k) {
		cn_ray ray = random_ray(0.0f);
		cn_polygon polygon = random_region(0.0f, 1 + below(3));
		cn_query_filter filter = random_filter();
		static answers a, b;
		if (k % 3 == 0) {
			ray.origin_m.x = (float)below(12);
			ray.origin_m.y = (float)(below(3) - 1) * 2.0f;
			ray.translation_m.x = 0.0f;
			ray.translation_m.y = -2.0f * ray.origin_m.y;
		}
		answer(&a, &ray, &polygon, &filter);
		w->broadphase_ops = &backward;
		answer(&b, &ray, &polygon, &filter);
		w->broadphase_ops = forward;
		different += !same(&a, &b, sizeof a);
	}
	CHECK_LE("different answers", different, 0, "of 1500");
	cn_world_destroy(w);
}

static uint64_t fnv(uint64_t hash, const void *bytes, size_t count)
{
	size_t k;
	for (k = 0; k < count; ++k)
		hash = (hash ^ ((const uint8_t *)bytes)[k]) * 1099511628211ull;
	return hash;
}

/* Everything that a session of stepping, moving and asking is told. */
static uint64_t session(int32_t with_broadphase)
{
	static answers a;
	uint64_t hash = 14695981039346656037ull;
	int32_t round, k;
	broadphase_kind = with_broadphase;
	random_world(700u, 0.0f);
	for (round = 0; round < 3; ++round) {
		for (k = 0; k < 200; ++k) {
			cn_ray ray = random_ray(0.0f);
			cn_polygon polygon = random_region(0.0f, 1 + below(3));
			cn_query_filter filter = random_filter();
			answer(&a, &ray, &polygon, &filter);
			hash = fnv(hash, &a, sizeof a);
		}
		shuffle_bodies(0.0f);
		fixture_step(w, round);
	}
	cn_world_destroy(w);
	broadphase_kind = CN_BROADPHASE_SWEEP;
	return hash;
}

static void t_sweep_and_tree_tell_the_same(void)
{
	uint64_t sweep = session(CN_BROADPHASE_SWEEP), tree = session(CN_BROADPHASE_TREE);
	printf("  hashes of all answers %016llx and %016llx\n", (unsigned long long)sweep, (unsigned long long)tree);
	CHECK(sweep == tree);
}

/* ------------------------------------------------------------------ particular promises */

/* From one end of the world to the other, and with nothing near. */
static void t_far_and_wide(void)
{
	static const int32_t kinds[2] = { CN_BROADPHASE_SWEEP, CN_BROADPHASE_TREE };
	int32_t k, count;
	for (k = 0; k < 2; ++k) {
		cn_ray along = { { -1e6f, 3.0f }, { 2e6f, 0.0f } }, across = { { 1e6f, 1e6f }, { -2e6f, -2e6f } }, still = { { -9e5f, 0.0f }, { 0.0f, 0.0f } };
		cn_aabb everything = { { -1e6f, -1e6f }, { 1e6f, 1e6f } };
		cn_polygon ball = { 1, 1.0f, { { 1e6f, 0.5f } } };
		cn_shape list[4];
		cn_ray_hit hit;
		cn_closest closest;
		cn_body box;
		broadphase_kind = kinds[k];
		w = make_world(0.0f);
		must(cn_world_cast_ray(w, &along, NULL, &hit), w, "cast_ray");
		must(cn_world_closest_point(w, 0.0f, 0.0f, 4e6f, NULL, &closest), w, "closest_point");
		CHECK(hit.shape == 0 && closest.shape == 0);
		box = fixture_box(w, CN_BODY_STATIC, -9e5f, 0.0f, 0.0f, 5.0f, 5.0f, 0.5f, 0.0f);
		must(cn_world_cast_ray(w, &along, NULL, &hit), w, "cast_ray");
		CHECK(hit.body == box && hit.point_m.x == -900005.0f && hit.point_m.y == 3.0f);
		must(cn_world_cast_ray(w, &across, NULL, &hit), w, "cast_ray");
		CHECK(hit.shape == 0);
		must(cn_world_cast_ray(w, &still, NULL, &hit), w, "cast_ray");
		CHECK(hit.body == box && hit.fraction == 0.0f);
		must(cn_world_cast_shape(w, &ball, -2e6f, 0.0f, NULL, &hit), w, "cast_shape");
		CHECK(hit.body == box && hit.point_m.x == -899995.0f);
		must(cn_world_closest_point(w, 9e5f, 0.0f, 4e6f, NULL, &closest), w, "closest_point");
		CHECK(closest.body == box && closest.point_m.x == -899995.0f);
		must(cn_world_overlap_aabb(w, &everything, NULL, list, 4, &count), w, "overlap_aabb");
		CHECK(count == 1);
		cn_world_destroy(w);
	}
	broadphase_kind = CN_BROADPHASE_SWEEP;
}

static void t_queries_change_nothing(void)
{
	cn_memory_stats before, after;
	uint64_t hash;
	int32_t k;
	static answers a;
	random_world(600u, 0.0f);
	hash = fixture_hash(w);
	must(cn_world_get_memory_stats(w, &before), w, "memory_stats");
	for (k = 0; k < 200; ++k) {
		cn_ray ray = random_ray(0.0f);
		cn_polygon polygon = random_region(0.0f, 1 + below(3));
		answer(&a, &ray, &polygon, NULL);
	}
	must(cn_world_get_memory_stats(w, &after), w, "memory_stats");
	CHECK(fixture_hash(w) == hash);
	CHECK(same(&before, &after, sizeof before));
	cn_world_destroy(w);
}

static void t_sensors_are_seen_when_asked_for(void)
{
	cn_shape_def sd;
	cn_circle circle = { { 0.0f, 0.0f }, 1.0f };
	cn_shape shape, list[4];
	cn_ray ray = { { -5.0f, 0.0f }, { 10.0f, 0.0f } };
	cn_ray_hit hit;
	int32_t count;
	w = fixture_world(0.0f, 1);
	sd = fixture_shape_def(fixture_body(w, CN_BODY_STATIC, 0.0f, 0.0f, 0.0f), 0.5f, 0.0f);
	sd.flags = CN_SHAPE_SENSOR;
	must(cn_shape_create_circle(w, &sd, &circle, &shape), w, "circle");
	must(cn_world_cast_ray(w, &ray, NULL, &hit), w, "cast_ray");
	must(cn_world_overlap_point(w, 0.0f, 0.0f, NULL, list, 4, &count), w, "overlap_point");
	CHECK(hit.shape == 0 && count == 0);
	must(cn_shape_cast_ray(w, shape, &ray, &hit), w, "shape_cast_ray");
	CHECK(hit.shape == shape);
	must(cn_shape_set_flags(w, shape, CN_SHAPE_SENSOR | CN_SHAPE_SENSOR_SEEN), w, "set_flags");
	must(cn_world_cast_ray(w, &ray, NULL, &hit), w, "cast_ray");
	must(cn_world_overlap_point(w, 0.0f, 0.0f, NULL, list, 4, &count), w, "overlap_point");
	CHECK(hit.shape == shape && count == 1 && list[0] == shape);
	cn_world_destroy(w);
}

/* A row of three boxes: what exactly comes back. */
static void t_known_answers(void)
{
	cn_ray ray = { { -10.0f, 0.0f }, { 20.0f, 0.0f } };
	cn_polygon box = { 4, 0.0f, { { -10.5f, -0.5f }, { -9.5f, -0.5f }, { -9.5f, 0.5f }, { -10.5f, 0.5f } } };
	cn_ray_hit hit, hits[4];
	cn_closest closest;
	cn_body first, loose;
	cn_shape_def sd;
	cn_shape free_shape;
	int32_t count;
	w = fixture_world(0.0f, 1);
	first = fixture_box(w, CN_BODY_DYNAMIC, -4.0f, 0.0f, 0.0f, 1.0f, 1.0f, 0.5f, 0.0f);
	fixture_box(w, CN_BODY_STATIC, 0.0f, 0.0f, 0.0f, 1.0f, 1.0f, 0.5f, 0.0f);
	fixture_box(w, CN_BODY_KINEMATIC, 4.0f, 0.0f, 0.0f, 1.0f, 1.0f, 0.5f, 0.0f);
	must(cn_world_cast_ray(w, &ray, NULL, &hit), w, "cast_ray");
	CHECK(hit.body == first && hit.fraction == 0.25f && hit.point_m.x == -5.0f && hit.point_m.y == 0.0f && hit.normal.x == -1.0f);
	must(cn_world_cast_ray_all(w, &ray, NULL, hits, 4, &count), w, "cast_ray_all");
	CHECK(count == 3 && hits[0].fraction == 0.25f && hits[1].fraction == 0.45f && hits[2].fraction == 0.65f);
	must(cn_world_cast_shape(w, &box, 20.0f, 0.0f, NULL, &hit), w, "cast_shape");
	CHECK(hit.body == first && hit.fraction == 0.225f && hit.normal.x == -1.0f && hit.point_m.x == -5.0f);
	must(cn_world_closest_point(w, -4.25f, 3.0f, 5.0f, NULL, &closest), w, "closest_point");
	CHECK(closest.body == first && closest.distance_m == 2.0f && closest.point_m.x == -4.25f && closest.point_m.y == 1.0f && closest.normal.y == 1.0f);
	must(cn_world_closest_point(w, -4.25f, 0.5f, 5.0f, NULL, &closest), w, "closest_point");
	CHECK(closest.body == first && closest.distance_m == -0.5f && closest.point_m.y == 1.0f && closest.normal.y == 1.0f);
	must(cn_world_closest_point(w, -4.0f, 3.0f, 1.9f, NULL, &closest), w, "closest_point");
	CHECK(closest.shape == 0);
	ray.origin_m.x = -4.0f;
	must(cn_world_cast_ray(w, &ray, NULL, &hit), w, "cast_ray");
	CHECK(hit.body == first && hit.fraction == 0.0f && hit.normal.x == 0.0f && hit.normal.y == 0.0f);
	/* An unattached shape: its own space is the world. */
	loose = fixture_body(w, CN_BODY_STATIC, 50.0f, 50.0f, 1.0f);
	sd = fixture_shape_def(loose, 0.5f, 0.0f);
	free_shape = fixture_box_shape(w, &sd, 1.0f, 1.0f);
	must(cn_shape_detach(w, free_shape), w, "detach");
	ray.origin_m.x = -10.0f;
	must(cn_shape_cast_ray(w, free_shape, &ray, &hit), w, "shape_cast_ray");
	CHECK(hit.shape == free_shape && hit.body == 0 && hit.fraction == 0.45f);
	cn_world_destroy(w);
}

/* ------------------------------------------------------------------ time */

static double now_ns(void) { return 1e9 * (double)clock() / (double)CLOCKS_PER_SEC; }

static void time_in_ten_thousand_boxes(void)
{
	static cn_ray rays[4000];
	static cn_ray_hit hits[4000];
	static cn_shape list[256];
	double start, single, batch, any, regions, points, moved, closest;
	int32_t k, count, total = 0;
	cn_ray_hit hit;
	cn_closest near;
	seed = 77u;
	w = make_world(0.0f);
	for (k = 0; k < 10000; ++k) {
		place at = random_place(0.0f, 0.4f);
		fixture_box(w, CN_BODY_DYNAMIC, 2.0f * (float)(k % 100) + at.x, 2.0f * (float)(k / 100) + at.y, at.angle, 0.5f, 0.5f, 0.5f, 0.0f);
	}
	fixture_step(w, 1);
	for (k = 0; k < 4000; ++k) {
		rays[k].origin_m.x = rnd(0.0f, 200.0f);
		rays[k].origin_m.y = rnd(0.0f, 200.0f);
		rays[k].translation_m.x = rnd(-60.0f, 60.0f);
		rays[k].translation_m.y = rnd(-60.0f, 60.0f);
	}
	start = now_ns();
	must(cn_world_cast_rays(w, rays, 4000, NULL, hits), w, "cast_rays");
	batch = now_ns() - start;
	start = now_ns();
	for (k = 0; k < 4000; ++k) {
		must(cn_world_cast_ray(w, &rays[k], NULL, &hit), w, "cast_ray");
		total += hit.shape != 0;
	}
	single = now_ns() - start;
	start = now_ns();
	for (k = 0; k < 4000; ++k)
		must(cn_world_cast_ray_any(w, &rays[k], NULL, &count), w, "cast_ray_any");
	any = now_ns() - start;
	start = now_ns();
	for (k = 0; k < 4000; ++k) {
		cn_aabb box;
		box.lower_m = box.upper_m = rays[k].origin_m;
		box.upper_m.x += 5.0f;
		box.upper_m.y += 5.0f;
		must(cn_world_overlap_aabb(w, &box, NULL, list, 256, &count), w, "overlap_aabb");
		total += count;
	}
	regions = now_ns() - start;
	start = now_ns();
	for (k = 0; k < 4000; ++k)
		must(cn_world_overlap_point(w, rays[k].origin_m.x, rays[k].origin_m.y, NULL, list, 256, &count), w, "overlap_point");
	points = now_ns() - start;
	start = now_ns();
	for (k = 0; k < 4000; ++k) {
		cn_polygon ball;
		ball.count = 1;
		ball.radius_m = 0.2f;
		ball.points_m[0] = rays[k].origin_m;
		must(cn_world_cast_shape(w, &ball, rays[k].translation_m.x, rays[k].translation_m.y, NULL, &hit), w, "cast_shape");
	}
	moved = now_ns() - start;
	start = now_ns();
	for (k = 0; k < 4000; ++k)
		must(cn_world_closest_point(w, rays[k].origin_m.x, rays[k].origin_m.y, 100.0f, NULL, &near), w, "closest_point");
	closest = now_ns() - start;
	CHECK_GE("found", total, 4000, "");
	printf("  %s, ns each: ray %.0f, in a batch %.0f, any %.0f, box of 5 m %.0f, point %.0f, moved ball %.0f, closest %.0f\n",
		broadphase_kind == CN_BROADPHASE_TREE ? "tree" : "sweep", single / 4000.0, batch / 4000.0,
		any / 4000.0, regions / 4000.0, points / 4000.0, moved / 4000.0, closest / 4000.0);
	cn_world_destroy(w);
}

static void t_time_in_ten_thousand_boxes(void)
{
	time_in_ten_thousand_boxes();
	broadphase_kind = CN_BROADPHASE_TREE;
	time_in_ten_thousand_boxes();
	broadphase_kind = CN_BROADPHASE_SWEEP;
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(t_known_answers);
	RUN(t_rays_find_the_nearest);
	RUN(t_batches_equal_single_rays);
	RUN(t_capacity_keeps_the_first);
	RUN(t_overlaps_list_what_is_there);
	RUN(t_many_chains_are_listed_once);
	RUN(t_moved_shapes_stop_at_the_first);
	RUN(t_chains_stop_moved_shapes_from_the_front);
	RUN(t_closest_point_is_the_closest);
	RUN(t_answers_do_not_depend_on_the_broadphase);
	RUN(t_sweep_and_tree_tell_the_same);
	RUN(t_far_and_wide);
	RUN(t_sensors_are_seen_when_asked_for);
	RUN(t_queries_change_nothing);
	RUN(t_time_in_ten_thousand_boxes);
	return test_end();
}
