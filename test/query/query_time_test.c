/*
 * query_time_test - prints what queries cost in a world of 10,000 boxes, with both broadphases.
 */
#include "queries.h"

#include <time.h>

#define RAYS 4000

static cn_ray rays[RAYS];
static cn_ray_hit hits[RAYS];
static cn_shape list[256];
static int32_t found;

static void batch(void)
{
	int32_t k;
	must(cn_world_cast_rays(w, rays, RAYS, NULL, hits), w, "cast_rays");
	for (k = 0; k < RAYS; ++k)
		found += hits[k].shape != 0;
}

static void one_ray(int32_t k)
{
	must(cn_world_cast_ray(w, &rays[k], NULL, &hits[k]), w, "cast_ray");
	found += hits[k].shape != 0;
}

static void any(int32_t k)
{
	int32_t hit;
	must(cn_world_cast_ray_any(w, &rays[k], NULL, &hit), w, "cast_ray_any");
	found += hit;
}

static void region(int32_t k)
{
	cn_aabb box;
	int32_t count;
	box.lower_m = box.upper_m = rays[k].origin_m;
	box.upper_m.x += 5.0f;
	box.upper_m.y += 5.0f;
	must(cn_world_overlap_aabb(w, &box, NULL, list, 256, &count), w, "overlap_aabb");
	found += count;
}

static void point(int32_t k)
{
	int32_t count;
	must(cn_world_overlap_point(w, rays[k].origin_m.x, rays[k].origin_m.y, NULL, list, 256, &count), w, "overlap_point");
	found += count;
}

static void moved_ball(int32_t k)
{
	cn_polygon ball;
	ball.count = 1;
	ball.radius_m = 0.2f;
	ball.points_m[0] = rays[k].origin_m;
	must(cn_world_cast_shape(w, &ball, rays[k].translation_m.x, rays[k].translation_m.y, NULL, &hits[k]), w, "cast_shape");
	found += hits[k].shape != 0;
}

static void closest(int32_t k)
{
	cn_closest near;
	must(cn_world_closest_point(w, rays[k].origin_m.x, rays[k].origin_m.y, 100.0f, NULL, &near), w, "closest_point");
	found += near.shape != 0;
}

static double now_ns(void) { return 1e9 * (double)clock() / (double)CLOCKS_PER_SEC; }

/* Every call must find something somewhere. */
static void measure(const char *name, void (*each)(int32_t k))
{
	double start = now_ns();
	int32_t k;
	found = 0;
	for (k = 0; k < RAYS && each != NULL; ++k)
		each(k);
	if (each == NULL)
		batch();
	printf(", %s %.0f", name, (now_ns() - start) / (double)RAYS);
	CHECK(found > RAYS / 10);
}

static void make_boxes(void)
{
	int32_t k;
	seed = 77u;
	w = make_world(0.0f);
	for (k = 0; k < 10000; ++k) {
		place at = random_place(0.0f, 0.4f);
		fixture_box(w, CN_BODY_DYNAMIC, 2.0f * (float)(k % 100) + at.x, 2.0f * (float)(k / 100) + at.y, at.angle, 0.5f, 0.5f, 0.5f, 0.0f);
	}
	fixture_step(w, 1);
	for (k = 0; k < RAYS; ++k) {
		rays[k].origin_m.x = rnd(0.0f, 200.0f);
		rays[k].origin_m.y = rnd(0.0f, 200.0f);
		rays[k].translation_m.x = rnd(-60.0f, 60.0f);
		rays[k].translation_m.y = rnd(-60.0f, 60.0f);
	}
}

static void t_time_in_ten_thousand_boxes(void)
{
	static const int32_t kinds[2] = { CN_BROADPHASE_SWEEP, CN_BROADPHASE_TREE };
	int32_t k;
	for (k = 0; k < 2; ++k) {
		broadphase_kind = kinds[k];
		make_boxes();
		printf("  ns each: %s", kinds[k] == CN_BROADPHASE_TREE ? "tree" : "sweep");
		measure("ray", one_ray);
		measure("in a batch", NULL);
		measure("any", any);
		measure("box of 5 m", region);
		measure("point", point);
		measure("moved ball", moved_ball);
		measure("closest", closest);
		printf("\n");
		cn_world_destroy(w);
	}
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(t_time_in_ten_thousand_boxes);
	return test_end();
}
