/*
 * test/broadphase/broadphase_times.h - prints times of a broadphase's worst cases, without bounds. Included by
 * broadphase_scenes.h.
 */
#ifndef CAIRN_TEST_BROADPHASE_TIMES_H
#define CAIRN_TEST_BROADPHASE_TIMES_H

#include "broadphase_world.h"

static double now_us(void) { return (double)clock() * 1e6 / CLOCKS_PER_SEC; }

static int32_t filter_all(const void *context, int32_t a, int32_t b)
{
	(void)context;
	return a != b;
}

typedef struct bench {
	const char *name;
	int32_t boxes;
	float width, height, spread_x, spread_y;
	float moving;   /* share of boxes that move in a step */
	int32_t teleport;
} bench;

static cni_aabb bench_box(const bench *b)
{
	return box_within(0, b->spread_x, 0, b->spread_y, cni_v(b->width, b->height));
}

static void bench_step(box_world *w, const bench *b)
{
	int32_t moves = (int32_t)((float)b->boxes * b->moving);
	int32_t i;
	for (i = 0; i < moves; ++i) {
		int32_t id = moves == b->boxes ? i : (int32_t)(random_bits() % (uint32_t)b->boxes);
		cni_aabb box = proxy_at(w, id)->fat;
		if (b->teleport)
			box = bench_box(b);
		else
			box = box_within(box.x0 - 0.1f, box.x0 + 0.1f, box.y0 - 0.1f, box.y0 + 0.1f, cni_v(b->width, b->height));
		world_move(w, id, &box);
	}
}

static float visit_count(void *context, int32_t id, float limit)
{
	*(int64_t *)context += id >= 0;
	return limit;
}

/* Small regions, and rays of a tenth of the world's size, in the state after the steps. */
static void bench_queries(const box_world *w, const bench *b)
{
	int32_t i, count = 20000;
	int64_t boxes = 0, crossed = 0;
	double start, query_ns, ray_ns;
	start = now_us();
	for (i = 0; i < count; ++i) {
		cni_aabb box = bench_box(b);
		w->ops->query(w->broadphase, &box, visit_count, &boxes);
	}
	query_ns = (now_us() - start) * 1000.0 / count;
	start = now_us();
	for (i = 0; i < count; ++i) {
		cni_aabb from = bench_box(b), to = bench_box(b);
		cni_vec2 d = cni_v((to.x0 - from.x0) * 0.2f, (to.y0 - from.y0) * 0.2f);
		w->ops->ray(w->broadphase, cni_v(from.x0, from.y0), d, visit_count, &crossed);
	}
	ray_ns = (now_us() - start) * 1000.0 / count;
	printf("  %-34s %8.0f ns a region of %.1f boxes, %.0f ns a ray through %.1f boxes\n", "", query_ns, (double)boxes / count, ray_ns,
	       (double)crossed / count);
}

static void bench_run(const bench *b)
{
	static box_world w;
	double best = 1e30, sum = 0.0, start;
	int64_t pairs = 0;
	int32_t i, steps = 60;
	random_state = 11;
	REQUIRE(world_open(&w, b->boxes, 0, 0));
	for (i = 0; i < b->boxes; ++i)
		(void)world_add(&w, i, bench_box(b), 0);
	for (i = 0; i < steps; ++i) {
		double us;
		bench_step(&w, b);
		start = now_us();
		w.ops->update(w.broadphase, filter_all, NULL, &w.pairs);
		us = now_us() - start;
		cni_arena_reset(&w.arena);
		if (i < 10)
			continue;
		best = us < best ? us : best;
		sum += us;
		pairs += w.pairs.list.count;
	}
	printf("  %-34s %8.0f us a step (mean %.0f), %lld new pairs a step, %d cells\n", b->name, best,
	       sum / (steps - 10), (long long)(pairs / (steps - 10)), w.ops->cells(w.broadphase));
	bench_queries(&w, b);
	printf("  %-34s %8.1f bytes a box\n", b->name, (double)broadphase_close(&w) / b->boxes);
	world_close(&w);
}

/* clock() counts processor time, so a busy machine disturbs little. */
static void t_times(void)
{
	static const bench benches[] = {
		{ "1e4 boxes, all teleporting", 10000, 1.2f, 1.2f, 200, 200, 1, 1 },
		{ "1e4 planks 10 x 0.05, all moving", 10000, 10.2f, 0.25f, 400, 400, 1, 0 },
		{ "1e4 planks 10 x 0.05, teleporting", 10000, 10.2f, 0.25f, 400, 400, 1, 1 },
		{ "1000 boxes in one spot", 1000, 1.2f, 1.2f, 0.5f, 0.5f, 1, 0 },
		{ "1e5 boxes, 1% moving", 100000, 1.2f, 1.2f, 640, 640, 0.01f, 0 },
		{ "1e4 boxes, all moving", 10000, 1.2f, 1.2f, 200, 200, 1, 0 },
		{ "1e4 boxes, half of them moving", 10000, 1.2f, 1.2f, 200, 200, 0.5f, 0 },
		{ "1e3 boxes, sparse, all moving", 1000, 1.2f, 1.2f, 400, 400, 1, 0 },
		{ "1e4 boxes in a heap, all moving", 10000, 1.2f, 1.2f, 100, 100, 1, 0 },
	};
	size_t i;
	for (i = 0; i < sizeof(benches) / sizeof(benches[0]); ++i)
		bench_run(&benches[i]);
}

#endif
