/*
 * test/broadphase/broadphase_scenes.h - tests of broadphase/broadphase.h that every implementation must pass, in the worlds
 * of boxes of broadphase_world.h:
 *
 *   - update reports exactly the pairs that brute force finds, sorted, each once, in every kind of
 *     world, whatever was added, removed, moved or touched;
 *   - queries and rays visit exactly what brute force finds, settled or not;
 *   - no pair is lost when any allocation fails.
 *
 * A test program fills in `tested`, calls run_shared_tests and adds the tests of its own implementation.
 * `make test-times` also prints times of the worst cases (broadphase_times.h).
 */
#ifndef CAIRN_TEST_BROADPHASE_SCENES_H
#define CAIRN_TEST_BROADPHASE_SCENES_H

#include "broadphase_times.h"
#include "broadphase_world.h"

/* ---- scenes ---- */

typedef enum scene_kind {
	SCENE_UNIFORM,
	SCENE_CLUSTERED,
	SCENE_LONG_LEVEL,
	SCENE_TOWER,
	SCENE_MIXED_SIZES,
	SCENE_ONE_SPOT,
	SCENE_HUGE,
	SCENE_LATTICE
} scene_kind;

static cni_aabb long_level_box(int32_t id)
{
	if (id % 4 == 0)
		return box_within((float)id * 5 - 1000, (float)id * 5 - 1000, -3, 0, cni_v(random_between(15, 30), 1));
	return box_within(-1000, 1000, 0, 6, cni_v(random_between(0.3f, 1), 1));
}

static cni_aabb huge_box(int32_t id)
{
	float far = id % 3 == 0 ? 1e9f : (id % 3 == 1 ? 1e6f : 3e8f);
	float high = id & 1 ? far : 10.0f;
	if (id % 10 == 0)
		return box_within(-1e9f, -1e9f, -1e9f, 1e9f, cni_v(2e9f, random_between(0, 1e8f)));
	return box_within(-far, far, -high, high, cni_v(random_between(0.01f, 0.1f) * far, 50.0f));
}

/* Touching edges, equal x0, -0 and 0, boxes without area. */
static cni_aabb lattice_box(void)
{
	uint32_t bits = random_bits();
	return box_at((float)(bits % 40u) - 20.0f, -(float)(bits / 64u % 40u), (float)(bits / 4096u % 3u), (float)(bits / 65536u % 3u));
}

static cni_aabb scene_box(scene_kind kind, int32_t id)
{
	float width;
	switch (kind) {
	case SCENE_UNIFORM: return box_within(-30, 30, -30, 30, size_between(0.5f, 2));
	case SCENE_CLUSTERED: return box_within((float)(id % 5) * 100 - 4, (float)(id % 5) * 100 + 4, -4, 4, cni_v(1, 1));
	case SCENE_LONG_LEVEL: return long_level_box(id);
	case SCENE_TOWER: return box_at((float)(id % 2) * 0.9f, (float)(id / 2) * 0.95f + random_between(0, 0.1f), 1, 1);
	case SCENE_MIXED_SIZES:
		width = random_size(0.01f, 500);
		return box_within(-300, 300, -300, 300, cni_v(width, random_size(0.01f, 500)));
	case SCENE_ONE_SPOT: return box_within(-0.6f, 0.6f, -0.6f, 0.6f, size_between(0.5f, 1));
	case SCENE_HUGE: return huge_box(id);
	case SCENE_LATTICE: return lattice_box();
	}
	return box_at(0, 0, 1, 1);
}

typedef struct scene {
	scene_kind kind;
	int32_t boxes;
	int32_t steps;
	float moving;      /* share of boxes that move in a step */
	float teleporting; /* share of the moving boxes that jump to a random place */
	float speed;       /* of the other moving boxes, per step */
	float churn;       /* share of boxes that are removed or added in a step */
	float statics;
} scene;

static float scene_world_size(const box_world *w)
{
	float size = 1.0f;
	int32_t id;
	for (id = 0; id < w->capacity; ++id)
		if (w->alive[id])
			size = cni_max(size, cni_max(cni_abs(proxy_at(w, id)->fat.x1), cni_abs(proxy_at(w, id)->fat.y1)));
	return size;
}

static int32_t scene_queries(const box_world *w, const scene *s, int32_t count)
{
	float size = scene_world_size(w);
	int32_t i, wrong = 0;
	for (i = 0; i < count; ++i) {
		cni_aabb box = scene_box(s->kind, (int32_t)(random_bits() % 1000u));
		cni_vec2 o = size_between(-size, size);
		cni_vec2 d = size_between(-size, size);
		wrong += query_differs(w, box);
		wrong += query_differs(w, box_at(o.x, o.y, cni_abs(d.x), cni_abs(d.y)));
		if (i % 4 == 1)
			d.x = 0.0f;
		if (i % 4 == 2)
			d.y *= 0.001f;
		if (i % 5 == 4)
			d.y = i % 2 ? 1e-42f : -1e-3f;
		if (i % 4 == 3)
			o = cni_v(box.x0, box.y0), d = cni_v(d.x * 0.01f, d.y * 0.01f);
		wrong += ray_differs(w, o, d);
		if (s->kind != SCENE_HUGE)
			wrong += nearest_error(w, o, d) > 1e-4;
	}
	return wrong;
}

static void scene_move(box_world *w, const scene *s, int32_t id)
{
	cni_aabb box = proxy_at(w, id)->fat;
	float dx = random_between(-s->speed, s->speed), dy = random_between(-s->speed, s->speed);
	if (random_unit() < s->teleporting)
		box = scene_box(s->kind, id);
	else
		box = box_at(box.x0 + dx, box.y0 + dy, box.x1 - box.x0, box.y1 - box.y0);
	world_move(w, id, &box);
}

static void scene_add(box_world *w, const scene *s, int32_t id)
{
	cni_aabb box = scene_box(s->kind, id);
	CHECK(world_add(w, id, box, random_unit() < s->statics));
}

static void scene_step(box_world *w, const scene *s)
{
	int32_t id;
	for (id = 0; id < s->boxes; ++id) {
		if (random_unit() < s->churn) {
			if (w->alive[id])
				world_remove(w, id);
			else
				scene_add(w, s, id);
			if (random_unit() < 0.2f && w->alive[id]) {
				world_remove(w, id);
				CHECK(world_add(w, id, scene_box(s->kind, id), 0));
			}
		}
		if (!w->alive[id])
			continue;
		if (random_unit() < s->moving && !(proxy_at(w, id)->flags & CNI_PROXY_STATIC))
			scene_move(w, s, id);
		if (s->churn > 0.0f && random_unit() < 0.02f)
			world_touch(w, id);
		if (s->churn > 0.0f && random_unit() < 0.01f)
			scene_move(w, s, id);
	}
}

/* Compares pairs, queries and rays of a scene with brute force. */
static void scene_run(const char *name, const scene *s)
{
	static box_world w;
	int32_t id, step, wrong = 0, invalid = 0, wrong_queries = 0;
	random_state = 12345u + (uint32_t)s->kind;
	pairs_seen = 0;
	REQUIRE(world_open(&w, s->boxes, 0, 0));
	for (id = 0; id < s->boxes; ++id) {
		scene_add(&w, s, id);
		invalid += id % 50 == 0 && !cni_broadphase_holds(w.ops, w.broadphase);
	}
	wrong_queries += scene_queries(&w, s, 5);
	for (step = 0; step < s->steps; ++step) {
		wrong += world_update(&w);
		scene_step(&w, s);
		invalid += !cni_broadphase_holds(w.ops, w.broadphase);
		if (step % 3 == 0)
			w.ops->settle(w.broadphase);
		if (step % 20 == 5)
			wrong_queries += scene_queries(&w, s, 4);
		invalid += !cni_broadphase_holds(w.ops, w.broadphase);
	}
	printf("  %s: %lld new pairs, %d filter calls, %d cells for %d boxes\n", name, (long long)pairs_seen, w.filter_calls,
	       w.ops->cells(w.broadphase), s->boxes);
	CHECK(pairs_seen > 0);
	CHECK_LE("pairs that differ from brute force", wrong, 0, "");
	CHECK_LE("queries that differ from brute force", wrong_queries, 0, "");
	CHECK_LE("filter calls for boxes that do not overlap", w.filter_faults, 0, "");
	CHECK_LE("states that are not valid", invalid, 0, "");
	world_close(&w);
}

static scene scene_of(scene_kind kind, int32_t boxes, float moving, float teleporting, float speed, float churn, float statics)
{
	scene s;
	s.kind = kind;
	s.boxes = boxes;
	s.steps = TEST_SAMPLES(200);
	s.moving = moving;
	s.teleporting = teleporting;
	s.speed = speed;
	s.churn = churn;
	s.statics = statics;
	return s;
}

static void run(const char *name, scene_kind kind, int32_t boxes, float moving, float teleporting, float speed, float churn, float statics)
{
	scene s = scene_of(kind, boxes, moving, teleporting, speed, churn, statics);
	scene_run(name, &s);
}

static void t_uniform(void) { run("uniform", SCENE_UNIFORM, 400, 0.5f, 0, 0.5f, 0, 0.1f); }
static void t_uniform_few_moving(void) { run("uniform, 1% moving", SCENE_UNIFORM, 600, 0.01f, 0, 0.5f, 0, 0.1f); }
static void t_uniform_churn(void) { run("uniform, churn", SCENE_UNIFORM, 400, 0.2f, 0.2f, 0.5f, 0.1f, 0.2f); }
static void t_all_teleporting(void) { run("all teleporting", SCENE_UNIFORM, 400, 1, 1, 0, 0, 0); }
static void t_clustered(void) { run("clustered", SCENE_CLUSTERED, 300, 0.3f, 0.05f, 0.2f, 0.01f, 0); }
static void t_long_level(void) { run("long level", SCENE_LONG_LEVEL, 400, 0.3f, 0.02f, 0.5f, 0.02f, 0.3f); }
static void t_tower(void) { run("tower", SCENE_TOWER, 300, 0.3f, 0, 0.05f, 0.01f, 0.05f); }
static void t_mixed_sizes(void) { run("mixed sizes", SCENE_MIXED_SIZES, 400, 0.4f, 0.2f, 2, 0.02f, 0.2f); }
static void t_mixed_sizes_few_moving(void) { run("mixed sizes, 1% moving", SCENE_MIXED_SIZES, 500, 0.01f, 0.1f, 2, 0.002f, 0.2f); }
static void t_one_spot(void) { run("one spot", SCENE_ONE_SPOT, 250, 0.5f, 0.3f, 0.1f, 0.02f, 0.1f); }
static void t_huge_coordinates(void) { run("huge coordinates", SCENE_HUGE, 400, 0.5f, 0.3f, 1e4f, 0.02f, 0.1f); }
static void t_lattice(void) { run("lattice", SCENE_LATTICE, 400, 0.5f, 0.7f, 0, 0.03f, 0.1f); }

static void t_same_body_is_filtered(void)
{
	body_size = 8;
	run("bodies of eight", SCENE_UNIFORM, 400, 0.5f, 0.2f, 0.5f, 0.02f, 0.1f);
	body_size = 0;
}

static float visit_hash(void *context, int32_t id, float limit)
{
	(void)context;
	pairs_hash = pairs_hash * 16777619u ^ (uint32_t)id;
	return limit;
}

/* Pairs, and the order in which queries visit, have the same bits on every compiler and machine. */
static void t_same_results_everywhere(void)
{
	static box_world w;
	scene s = scene_of(SCENE_UNIFORM, 300, 0.5f, 0.2f, 0.5f, 0.05f, 0.1f);
	int32_t id, step;
	random_state = 2024;
	pairs_hash = 0;
	REQUIRE(world_open(&w, s.boxes, 0, 0));
	for (id = 0; id < s.boxes; ++id)
		scene_add(&w, &s, id);
	for (step = 0; step < 40; ++step) {
		cni_aabb region = scene_box(SCENE_UNIFORM, 0);
		scene_step(&w, &s);
		CHECK(world_update(&w) == 0);
		w.ops->query(w.broadphase, &region, visit_hash, NULL);
		w.ops->ray(w.broadphase, cni_v(region.x0, region.y0), size_between(-40, 40), visit_hash, NULL);
	}
	printf("  hash %08x, expected %08x\n", pairs_hash, tested.hash);
	CHECK(pairs_hash == tested.hash);
	world_close(&w);
}

/* 2,000 boxes in a grid on one body, which overlap their neighbours, move together. */
static void t_many_boxes_on_one_body_are_cheap(void)
{
	static box_world w;
	int32_t id, step, first;
	body_size = 2000;
	REQUIRE(world_open(&w, 2000, 0, 0));
	for (id = 0; id < 2000; ++id)
		CHECK(world_add(&w, id, box_at((float)(id % 50), (float)(id / 50), 1.2f, 1.2f), 0));
	w.ops->update(w.broadphase, filter_pair, &w, &w.pairs);
	first = w.filter_calls;
	for (step = 0; step < 50; ++step) {
		for (id = 0; id < 2000; ++id) {
			cni_aabb box = box_at((float)(id % 50) + (float)step * 0.3f, (float)(id / 50), 1.2f, 1.2f);
			world_move(&w, id, &box);
		}
		w.ops->update(w.broadphase, filter_pair, &w, &w.pairs);
		CHECK(w.pairs.list.count == 0);
	}
	CHECK_LE("filter calls a box at first", first / 2000.0, 4, "");
	CHECK_LE("filter calls a box and step then", (w.filter_calls - first) / 2000.0 / 50.0, 0.1, "");
	world_close(&w);
	body_size = 0;
}

static void t_without_scratch_memory(void)
{
	without_scratch = 1;
	run("no scratch, uniform", SCENE_UNIFORM, 300, 0.5f, 0.2f, 0.5f, 0.02f, 0.1f);
	run("no scratch, mixed sizes", SCENE_MIXED_SIZES, 300, 0.2f, 0.2f, 2, 0.02f, 0.1f);
	run("no scratch, lattice", SCENE_LATTICE, 300, 0.5f, 0.7f, 0, 0.03f, 0.1f);
	without_scratch = 0;
}

/* Boxes with changing sizes, number and spread: the structure is rebuilt many times. */
static void t_rebuilding_changes_nothing(void)
{
	static box_world w;
	int32_t phase, step, id, wrong = 0, invalid = 0;
	random_state = 99;
	REQUIRE(world_open(&w, 800, 0, 0));
	for (phase = 0; phase < 8; ++phase) {
		float size = phase % 2 ? 0.05f : 5.0f, spread = phase % 3 ? 40.0f : 400.0f;
		int32_t boxes = phase % 4 == 3 ? 60 : 800;
		for (id = 0; id < 800; ++id) {
			if (w.alive[id] && (id >= boxes || id % 3 == phase % 3))
				world_remove(&w, id);
			if (!w.alive[id] && id < boxes)
				CHECK(world_add(&w, id, box_within(-spread, spread, -spread, spread, cni_v(size, size)), 0));
		}
		for (step = 0; step < TEST_MANY(12); ++step) {
			wrong += world_update(&w);
			invalid += !cni_broadphase_holds(w.ops, w.broadphase);
			for (id = 0; id < 800; ++id)
				if (w.alive[id] && random_unit() < 0.1f) {
					cni_aabb box = box_within(-spread, spread, -spread, spread, cni_v(size, size));
					world_move(&w, id, &box);
				}
		}
	}
	CHECK_LE("pairs that differ from brute force", wrong, 0, "");
	CHECK_LE("states that are not valid", invalid, 0, "");
	world_close(&w);
}

static void t_touch_reports_again(void)
{
	static box_world w;
	REQUIRE(world_open(&w, 8, 0, 0));
	CHECK(world_add(&w, 0, box_at(0, 0, 1, 1), 0));
	CHECK(world_add(&w, 1, box_at(0.5f, 0, 1, 1), 0));
	CHECK(world_add(&w, 2, box_at(1.2f, 0, 1, 1), 1));
	CHECK(world_update(&w) == 0 && w.pairs.list.count == 2);
	CHECK(world_update(&w) == 0 && w.pairs.list.count == 0);
	world_touch(&w, 1);
	CHECK(world_update(&w) == 0 && w.pairs.list.count == 2);
	CHECK(world_update(&w) == 0 && w.pairs.list.count == 0);
	world_touch(&w, 2);
	CHECK(world_update(&w) == 0 && w.pairs.list.count == 1);
	world_close(&w);
}

static void t_queries_stop_when_told(void)
{
	static box_world w;
	static visits v;
	cni_aabb all = box_at(-100, -100, 200, 200);
	int32_t id;
	REQUIRE(world_open(&w, 100, 0, 0));
	for (id = 0; id < 100; ++id)
		CHECK(world_add(&w, id, box_at((float)(id % 10) * 3, (float)(id / 10) * 3, 2, 2), 0));
	for (id = 1; id < 20; ++id) {
		if (id == 10)
			CHECK(world_update(&w) == 0);
		memset(&v, 0, sizeof(v));
		v.stop_after = id;
		w.ops->query(w.broadphase, &all, visit_mark, &v);
		CHECK(v.count == id);
		memset(&v, 0, sizeof(v));
		v.stop_after = 1 + id % 5;
		w.ops->ray(w.broadphase, cni_v(-1, 1), cni_v(100, 0), visit_mark, &v);
		CHECK(v.count == 1 + id % 5);
	}
	world_close(&w);
}

/* Few boxes far apart: a ray crosses more cells than there are boxes. It visits exactly what brute force says, also boxes that moved since
   the last update, and stops when told. */
static void t_long_rays_over_few_boxes(void)
{
	static box_world w;
	static visits v;
	int32_t id, round, i;
	random_state = 9;
	REQUIRE(world_open(&w, 20, 0, 0));
	for (id = 0; id < 20; ++id)
		CHECK(world_add(&w, id, box_at(id % 2 ? 3000.0f : -3000.0f, (float)id * 250.0f, 2, 2), 0));
	CHECK(world_update(&w) == 0);
	for (round = 0; round < 2; ++round) {
		for (i = 0; i < 100; ++i) {
			int32_t from = (int32_t)(random_bits() % 20u), to = (int32_t)(random_bits() % 20u);
			const cni_aabb *a = &proxy_at(&w, from)->fat, *b = &proxy_at(&w, to)->fat;
			cni_vec2 o = cni_v(a->x0 + 1.0f, a->y0 + 0.5f), d = cni_sub(cni_v(b->x0 + 1.0f, b->y0 + 1.5f), o);
			CHECK(ray_differs(&w, o, d) == 0);
			memset(&v, 0, sizeof(v));
			v.stop_after = 1;
			w.ops->ray(w.broadphase, o, d, visit_mark, &v);
			CHECK(v.count == 1);
		}
		for (id = 0; id < 20; id += 3) {
			cni_aabb moved = box_at(id % 2 ? 2000.0f : -2000.0f, (float)id * 300.0f, 2, 2);
			world_move(&w, id, &moved);
		}
	}
	for (i = 1; i < 7; ++i) {
		cni_aabb all = box_at(-4000, -10, 8000, 10000);
		memset(&v, 0, sizeof(v));
		v.stop_after = i;
		w.ops->query(w.broadphase, &all, visit_mark, &v);
		CHECK(v.count == i);
	}
	world_close(&w);
}

/* A ray that stops at its first hit visits few boxes. */
static void t_ray_visits_near_boxes_first(void)
{
	static box_world w;
	nearest n;
	int32_t id, i, visited = 0;
	random_state = 5;
	REQUIRE(world_open(&w, 1000, 0, 0));
	for (id = 0; id < 1000; ++id)
		CHECK(world_add(&w, id, box_within(-40, 40, -40, 40, cni_v(1, 1)), 0));
	CHECK(world_update(&w) == 0);
	memset(&n, 0, sizeof(n));
	n.world = &w;
	for (i = 0; i < 200; ++i) {
		n.o = size_between(-40, 40);
		n.d = size_between(-80, 80);
		n.best = 2.0;
		n.visited = 0;
		w.ops->ray(w.broadphase, n.o, n.d, visit_nearest, &n);
		visited += n.visited;
	}
	CHECK_LE("boxes visited a ray", (double)visited / 200.0, 6, "");
	world_close(&w);
}

/* ---- memory ---- */

static double bytes_a_box(int32_t boxes, float spread)
{
	static box_world w;
	uint64_t bytes;
	int32_t id;
	random_state = 3;
	if (!world_open(&w, boxes, 0, 0))
		return 1e9;
	for (id = 0; id < boxes; ++id)
		CHECK(world_add(&w, id, box_within(0, spread, 0, spread, cni_v(1, 1)), 0));
	for (id = 0; id < 40; ++id)
		w.ops->update(w.broadphase, filter_pair, &w, &w.pairs);
	printf("  %d boxes in %g x %g m: %d cells\n", boxes, (double)spread, (double)spread, w.ops->cells(w.broadphase));
	bytes = broadphase_close(&w);
	CHECK_LE("memory over what fixed-memory worlds reserve", (double)bytes / (double)w.ops->bytes_needed(boxes), 1, "");
	world_close(&w);
	return (double)bytes / boxes;
}

/* ---- failing memory ---- */

#define FAIL_BOXES 90

static uint8_t pair_known[FAIL_BOXES][FAIL_BOXES];

/* Updates the world's set of known pairs (reported and still overlapping). Returns the number of overlapping pairs that are
   unknown, which may only be the pairs that this update counts as lost. */
static int32_t known_after_update(box_world *w)
{
	const cni_pair *found = (const cni_pair *)w->pairs.list.data;
	int32_t a, b, i, unknown = 0;
	for (i = 0; i < w->pairs.list.count; ++i) {
		CHECK(found[i].a < found[i].b);
		CHECK(i == 0 || found[i - 1].a < found[i].a || (found[i - 1].a == found[i].a && found[i - 1].b < found[i].b));
		CHECK(cni_aabb_overlap(&proxy_at(w, found[i].a)->fat, &proxy_at(w, found[i].b)->fat));
		pair_known[found[i].a][found[i].b] = 1;
	}
	for (a = 0; a < FAIL_BOXES; ++a)
		for (b = a + 1; b < FAIL_BOXES; ++b) {
			int32_t overlap = w->alive[a] && w->alive[b] && cni_aabb_overlap(&proxy_at(w, a)->fat, &proxy_at(w, b)->fat);
			if (!overlap)
				pair_known[a][b] = 0;
			else
				unknown += pair_allowed(w, a, b) && !pair_known[a][b];
		}
	return unknown;
}

static void forget_pairs_of(int32_t id)
{
	int32_t i;
	for (i = 0; i < FAIL_BOXES; ++i)
		pair_known[id][i] = pair_known[i][id] = 0;
}

typedef struct fail_sums {
	int32_t lost, missing, invalid, refused, wrong_queries;
} fail_sums;

/* Adds, moves, removes and queries while the allocator's calls fail_first..fail_last fail, or each call with chance
   1 / one_in; returns the number of failed calls. */
static int64_t fail_run(int64_t fail_first, int64_t fail_last, uint32_t one_in, fail_sums *sums)
{
	static box_world w;
	int32_t step, id;
	int64_t failed;
	cni_vec2 from;
	memset(pair_known, 0, sizeof(pair_known));
	random_state = 77;
	if (!world_open(&w, FAIL_BOXES, fail_first, fail_last)) {
		failed = w.flaky.failed;
		world_close(&w);
		return failed;
	}
	w.flaky.one_in = one_in;
	w.flaky.dice = (uint32_t)fail_first;
	for (step = 0; step < 14; ++step) {
		for (id = 0; id < FAIL_BOXES; ++id) {
			cni_aabb box = box_within(-9, 9, -9, 9, cni_v(id % 9 == 0 ? 6.0f : 1.0f, 1));
			uint32_t dice = random_bits() % 8u;
			if (!w.alive[id] && dice < 4)
				sums->refused += !world_add(&w, id, box, id % 7 == 0);
			else if (w.alive[id] && dice == 7) {
				world_remove(&w, id);
				forget_pairs_of(id);
			} else if (w.alive[id] && (dice == 6 || step % 5 == 4))
				world_move(&w, id, &box);
		}
		if (step % 3 == 1)
			w.ops->settle(w.broadphase);
		sums->wrong_queries += query_differs(&w, box_within(-9, 9, -9, 9, cni_v(5, 5)));
		if (step == 12)
			w.flaky.fail_last = w.flaky.one_in = 0;
		w.ops->update(w.broadphase, filter_pair, &w, &w.pairs);
		cni_arena_reset(&w.arena);
		sums->lost += w.pairs.pairs_lost;
		sums->missing += cni_max_i(0, known_after_update(&w) - w.pairs.pairs_lost);
		sums->invalid += !cni_broadphase_holds(w.ops, w.broadphase);
		sums->invalid += step >= 12 && w.pairs.pairs_lost > 0;
		sums->wrong_queries += query_differs(&w, box_within(-9, 9, -9, 9, cni_v(5, 5)));
		from = size_between(-9, 9);
		sums->wrong_queries += ray_differs(&w, from, size_between(-18, 18));
	}
	failed = w.flaky.failed;
	world_close(&w);
	return failed;
}

/* Windows of failures that begin at every call, up to the last call. */
static void fail_windows(int64_t length)
{
	fail_sums sums;
	int64_t n;
	memset(&sums, 0, sizeof(sums));
	for (n = 1; fail_run(n, length > 0 ? n + length - 1 : INT64_MAX, 0, &sums) > 0; ++n)
		;
	printf("  windows of %d: %d runs, %d pairs late, %d additions refused\n", (int)length, (int)n, sums.lost, sums.refused);
	CHECK(n > tested.allocations);
	CHECK(length == 1 || sums.lost > 0);
	CHECK_LE("pairs missing that were not counted as lost", sums.missing, 0, "");
	CHECK_LE("queries that differ from brute force", sums.wrong_queries, 0, "");
	CHECK_LE("states that are not valid", sums.invalid, 0, "");
}

static void t_allocation_fails_once(void) { fail_windows(1); }
static void t_allocations_fail_for_a_while(void) { fail_windows(3), fail_windows(7), fail_windows(16); }
static void t_allocations_fail_from_then_on(void) { fail_windows(0); }

static void t_allocations_fail_by_chance(void)
{
	fail_sums sums;
	int32_t i;
	memset(&sums, 0, sizeof(sums));
	for (i = 0; i < 120; ++i)
		(void)fail_run(1000000 + i, 0, 2 + (uint32_t)i % 3u, &sums);
	(void)fail_run(1000000, 0, 1, &sums);
	printf("  %d pairs late, %d additions refused\n", sums.lost, sums.refused);
	CHECK(sums.lost > 0);
	CHECK_LE("pairs missing that were not counted as lost", sums.missing, 0, "");
	CHECK_LE("queries that differ from brute force", sums.wrong_queries, 0, "");
	CHECK_LE("states that are not valid", sums.invalid, 0, "");
}

static void run_shared_tests(void)
{
	RUN(t_touch_reports_again);
	RUN(t_uniform);
	RUN(t_uniform_few_moving);
	RUN(t_uniform_churn);
	RUN(t_all_teleporting);
	RUN(t_clustered);
	RUN(t_long_level);
	RUN(t_tower);
	RUN(t_mixed_sizes);
	RUN(t_mixed_sizes_few_moving);
	RUN(t_one_spot);
	RUN(t_huge_coordinates);
	RUN(t_lattice);
	RUN(t_same_body_is_filtered);
	RUN(t_same_results_everywhere);
	RUN(t_many_boxes_on_one_body_are_cheap);
	RUN(t_without_scratch_memory);
	RUN(t_rebuilding_changes_nothing);
	RUN(t_queries_stop_when_told);
	RUN(t_long_rays_over_few_boxes);
	RUN(t_ray_visits_near_boxes_first);
	RUN(t_allocation_fails_once);
	RUN(t_allocations_fail_for_a_while);
	RUN(t_allocations_fail_from_then_on);
	RUN(t_allocations_fail_by_chance);
	RUN_WHEN_NAMED(t_times);
}

#endif
