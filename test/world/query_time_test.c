/*
 * query_time_test - prints what queries cost in a world of 10,000 boxes, with both broadphases.
 */
#include "queries.h"

#include <time.h>

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
	RUN(t_time_in_ten_thousand_boxes);
	return test_end();
}
