/*
 * query_test - promise: rays find exactly what is there, whatever the shapes, filters and history of the world:
 * bodies moved without a step, destroyed, disabled, asleep; sensors only when asked for; from one end of the
 * world to the other; and queries change nothing.
 *
 * Checked against cn_shape_cast_ray on every shape, bit by bit.
 */
#include "queries.h"

static int hit_is_before(const cn_ray_hit *a, const cn_ray_hit *b)
{
	if (a->fraction != b->fraction)
		return a->fraction < b->fraction;
	return (a->shape & 0xFFFFFu) < (b->shape & 0xFFFFFu);
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
	rays_seen.inside += found.depth_m > 0.0f;
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
	CHECK(hit.body == first && hit.fraction == 0.0f && hit.depth_m == 1.0f && fabsf(hit.normal.x + hit.normal.y) == 1.0f);
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

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(t_known_answers);
	RUN(t_rays_find_the_nearest);
	RUN(t_batches_equal_single_rays);
	RUN(t_capacity_keeps_the_first);
	RUN(t_far_and_wide);
	RUN(t_sensors_are_seen_when_asked_for);
	RUN(t_queries_change_nothing);
	return test_end();
}
