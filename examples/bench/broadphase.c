/*
 * examples/bench/broadphase.c - times the two broadphases alone, behind the interface that worlds use
 * (broadphase/broadphase.h), on boxes that move without physics. The only example that looks inside of the library.
 *
 *     bench broadphase     a step: boxes that left their margin are moved, what is new is inserted, what is
 *                          gone removed, then new pairs are found. us_* are microseconds a step, bytes_per_proxy
 *                          is what the structure holds for itself (both share a table of 48 bytes a proxy).
 *     bench queries        regions of 2 x 2 m; rays of 50 m and of a tenth of the world, through everything
 *                          and to the nearest box; all in thousands a second.
 *
 * Both structures get the same boxes and must find the same numbers of pairs and hits, else the row
 * says so and counts as failed. CAIRN_BENCH_HUGE=1 in the environment adds worlds of a million.
 */
#include "bench/broadphase.h"
#include "measure/measure.h"
#include "broadphase/broadphase.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define STEP_S (1.0f / 60.0f)
#define MARGIN_M 0.1f

/* How the boxes of a world lie and move. */
typedef struct world_kind {
	const char *name;
	int32_t boxes;
	int32_t steps;
	float width_m, height_m;   /* of the world */
	float size_min_m, size_max_m;
	float speed_mps;
	float moving;              /* share of the boxes that move; the others sleep */
	float churn;               /* share that is replaced by new ones in a step */
	float statics;             /* share that is static and long: a level */
	int32_t clusters;          /* 0: spread evenly */
	int32_t power_law;         /* sizes: many small ones, few large ones */
} world_kind;

static const world_kind worlds[] = {
	{"uniform_1e2", 100, 400, 20.0f, 20.0f, 0.5f, 1.5f, 3.0f, 1.0f, 0.0f, 0.0f, 0, 0},
	{"uniform_1e3", 1000, 300, 63.0f, 63.0f, 0.5f, 1.5f, 3.0f, 1.0f, 0.0f, 0.0f, 0, 0},
	{"uniform_1e4", 10000, 200, 200.0f, 200.0f, 0.5f, 1.5f, 3.0f, 1.0f, 0.0f, 0.0f, 0, 0},
	{"uniform_1e5", 100000, 60, 632.0f, 632.0f, 0.5f, 1.5f, 3.0f, 1.0f, 0.0f, 0.0f, 0, 0},
	{"uniform_1e6", 1000000, 20, 2000.0f, 2000.0f, 0.5f, 1.5f, 3.0f, 1.0f, 0.0f, 0.0f, 0, 0},
	{"fast_1e4", 10000, 200, 200.0f, 200.0f, 0.5f, 1.5f, 60.0f, 1.0f, 0.0f, 0.0f, 0, 0},
	{"long_level", 10000, 200, 10000.0f, 8.0f, 0.5f, 1.5f, 5.0f, 1.0f, 0.0f, 0.4f, 0, 0},
	{"tall_tower", 4000, 200, 3.0f, 2000.0f, 0.9f, 1.1f, 0.5f, 1.0f, 0.0f, 0.0f, 0, 0},
	{"clusters", 10000, 200, 2000.0f, 2000.0f, 0.5f, 1.5f, 3.0f, 1.0f, 0.0f, 0.0f, 50, 0},
	{"churn", 10000, 200, 200.0f, 200.0f, 0.5f, 1.5f, 3.0f, 1.0f, 0.05f, 0.0f, 0, 0},
	{"mixed_sizes", 5000, 200, 3000.0f, 3000.0f, 0.05f, 300.0f, 3.0f, 1.0f, 0.0f, 0.0f, 0, 1},
	{"asleep_99", 100000, 200, 632.0f, 632.0f, 0.5f, 1.5f, 3.0f, 0.01f, 0.0f, 0.0f, 0, 0},
};

static const world_kind query_worlds[] = {
	{"uniform_1e3", 1000, 60, 63.0f, 63.0f, 0.5f, 1.5f, 3.0f, 1.0f, 0.0f, 0.0f, 0, 0},
	{"uniform_1e4", 10000, 60, 200.0f, 200.0f, 0.5f, 1.5f, 3.0f, 1.0f, 0.0f, 0.0f, 0, 0},
	{"uniform_1e5", 100000, 60, 632.0f, 632.0f, 0.5f, 1.5f, 3.0f, 1.0f, 0.0f, 0.0f, 0, 0},
	{"sparse_1e4", 10000, 60, 2000.0f, 2000.0f, 0.5f, 1.5f, 3.0f, 1.0f, 0.0f, 0.0f, 0, 0},
	{"long_level", 10000, 60, 10000.0f, 8.0f, 0.5f, 1.5f, 5.0f, 1.0f, 0.0f, 0.4f, 0, 0},
	{"mixed_sizes", 5000, 60, 3000.0f, 3000.0f, 0.05f, 300.0f, 3.0f, 1.0f, 0.0f, 0.0f, 0, 1},
};

static const struct {
	const char *name;
	const cni_broadphase_ops *ops;
} structures[] = {{"sweep", &cni_broadphase_sweep}, {"tree", &cni_broadphase_tree}};

/* ---------------------------------------------------------------- boxes */

typedef struct bench_box {
	float x, y, width, height; /* lower corner and size, without margin */
	float vx, vy;
	int32_t cluster;
	int32_t is_static;
} bench_box;

typedef struct bench_world {
	const world_kind *kind;
	const cni_broadphase_ops *ops;
	cni_broadphase *broadphase;
	cni_memory memory;
	cni_arena arena;
	cni_table proxies;
	cni_broadphase_pairs pairs;
	bench_box *boxes;
	int32_t *left;         /* boxes that left their margin */
	int32_t left_count;
	uint32_t random;
	uint64_t pair_count;
	measure_times times;
} bench_world;

/* xorshift32 (Marsaglia, 2003). */
static float random_to(bench_world *w, float lower, float upper)
{
	w->random ^= w->random << 13;
	w->random ^= w->random >> 17;
	w->random ^= w->random << 5;
	return lower + (upper - lower) * ((float)(w->random >> 8) / 16777216.0f);
}

static cni_proxy *proxy_at(const bench_world *w, int32_t id) { return (cni_proxy *)cni_table_at(&w->proxies, id); }

/* Each time 1.6 as large, a fifth fewer boxes. */
static float random_size(bench_world *w)
{
	const world_kind *k = w->kind;
	float size = k->size_min_m;
	if (!k->power_law)
		return random_to(w, k->size_min_m, k->size_max_m);
	while (size < k->size_max_m / 1.6f && random_to(w, 0.0f, 1.0f) < 0.8f)
		size *= 1.6f;
	return size * random_to(w, 1.0f, 1.6f);
}

static void box_make(bench_world *w, bench_box *b)
{
	const world_kind *k = w->kind;
	b->width = random_size(w);
	b->height = random_size(w);
	b->x = random_to(w, 0.0f, k->width_m);
	b->y = random_to(w, 0.0f, k->height_m);
	b->vx = b->vy = 0.0f;
	b->is_static = random_to(w, 0.0f, 1.0f) < k->statics;
	if (b->is_static) {
		b->width = random_to(w, 2.0f, 8.0f);
		b->y = random_to(w, -1.0f, 0.0f);
	} else if (random_to(w, 0.0f, 1.0f) < k->moving) {
		b->vx = random_to(w, -k->speed_mps, k->speed_mps);
		b->vy = random_to(w, -k->speed_mps, k->speed_mps);
	}
	if (k->clusters > 0) {
		b->cluster = (int32_t)random_to(w, 0.0f, (float)k->clusters);
		b->x = (float)(b->cluster * 7919 % 1000) * 0.001f * k->width_m + random_to(w, -6.0f, 6.0f);
		b->y = (float)(b->cluster * 104729 % 1000) * 0.001f * k->height_m + random_to(w, -6.0f, 6.0f);
	}
}

static cni_aabb box_grown(const bench_box *b, float margin)
{
	cni_aabb box;
	box.x0 = b->x - margin;
	box.y0 = b->y - margin;
	box.x1 = b->x + b->width + margin;
	box.y1 = b->y + b->height + margin;
	return box;
}

/* Goes on, turns round at the edges of the world or now and then in its cluster. */
static void box_advance(bench_world *w, bench_box *b)
{
	const world_kind *k = w->kind;
	b->x += STEP_S * b->vx;
	b->y += STEP_S * b->vy;
	if (k->clusters > 0 && random_to(w, 0.0f, 1.0f) < 0.01f)
		b->vx = -b->vx, b->vy = -b->vy;
	if (k->clusters == 0 && ((b->x < 0.0f && b->vx < 0.0f) || (b->x > k->width_m && b->vx > 0.0f)))
		b->vx = -b->vx;
	if (k->clusters == 0 && ((b->y < 0.0f && b->vy < 0.0f) || (b->y > k->height_m && b->vy > 0.0f)))
		b->vy = -b->vy;
}

/* ---------------------------------------------------------------- a world of boxes */

static int32_t proxy_add(bench_world *w, int32_t id)
{
	cni_proxy *proxy = proxy_at(w, id);
	if (!w->ops->reserve(w->broadphase, 1))
		return 0;
	memset(proxy, 0, sizeof *proxy);
	proxy->fat = box_grown(&w->boxes[id], MARGIN_M);
	proxy->flags = CNI_PROXY_ALIVE | (w->boxes[id].is_static ? CNI_PROXY_STATIC : 0u);
	w->ops->add(w->broadphase, id);
	return 1;
}

static int32_t allow(const void *context, int32_t a, int32_t b)
{
	(void)context;
	return a != b;
}

/* Returns the bytes that the broadphase had. */
static uint64_t broadphase_close(bench_world *w)
{
	uint64_t before = w->memory.bytes_in_use;
	if (w->broadphase != NULL)
		w->ops->destroy(w->broadphase);
	w->broadphase = NULL;
	return before - w->memory.bytes_in_use;
}

static void world_close(bench_world *w)
{
	broadphase_close(w);
	cni_array_deinit(&w->pairs.list, &w->memory);
	cni_table_deinit(&w->proxies, &w->memory);
	cni_arena_deinit(&w->arena);
	measure_times_close(&w->times);
	free(w->boxes);
	free(w->left);
}

/* Everything but what can fail. */
static void world_init(bench_world *w, const world_kind *kind, const cni_broadphase_ops *ops)
{
	memset(w, 0, sizeof *w);
	w->kind = kind;
	w->ops = ops;
	w->random = 12345u;
	cni_memory_init_hooks(&w->memory, NULL, NULL, NULL);
	cni_arena_init(&w->arena, &w->memory);
	cni_table_init(&w->proxies, (int32_t)sizeof(cni_proxy), 6);
	cni_array_init(&w->pairs.list, (int32_t)sizeof(cni_pair));
}

static int32_t world_open(bench_world *w, const world_kind *kind, const cni_broadphase_ops *ops)
{
	cni_broadphase_context context;
	world_init(w, kind, ops);
	w->boxes = (bench_box *)malloc((size_t)kind->boxes * sizeof *w->boxes);
	w->left = (int32_t *)malloc((size_t)kind->boxes * sizeof *w->left);
	memset(&context, 0, sizeof context);
	context.memory = &w->memory;
	context.arena = &w->arena;
	context.proxies = &w->proxies;
	if (w->boxes == NULL || w->left == NULL || !measure_times_open(&w->times, kind->steps) ||
		!cni_table_reserve(&w->proxies, &w->memory, kind->boxes))
		return 0;
	w->broadphase = ops->create(&context, 0);
	if (w->broadphase == NULL)
		return 0;
	for (int32_t id = 0; id < kind->boxes; ++id) {
		box_make(w, &w->boxes[id]);
		if (!proxy_add(w, id))
			return 0;
	}
	ops->settle(w->broadphase);
	ops->update(w->broadphase, allow, NULL, &w->pairs);
	cni_arena_reset(&w->arena);
	return 1;
}

/* Not timed: which boxes leave their margin. */
static void boxes_advance(bench_world *w)
{
	w->left_count = 0;
	for (int32_t id = 0; id < w->kind->boxes; ++id) {
		cni_aabb tight;
		if (w->boxes[id].vx == 0.0f && w->boxes[id].vy == 0.0f)
			continue;
		box_advance(w, &w->boxes[id]);
		tight = box_grown(&w->boxes[id], 0.0f);
		if (!cni_aabb_contains(&proxy_at(w, id)->fat, &tight))
			w->left[w->left_count++] = id;
	}
}

/* Fast boxes get room for a step ahead, as in a world. */
static cni_aabb box_fat(const bench_box *b)
{
	cni_aabb fat = box_grown(b, MARGIN_M);
	float dx = STEP_S * b->vx, dy = STEP_S * b->vy;
	if (cni_abs(dx) > 0.5f * MARGIN_M || cni_abs(dy) > 0.5f * MARGIN_M) {
		fat.x0 += cni_min(dx, 0.0f);
		fat.x1 += cni_max(dx, 0.0f);
		fat.y0 += cni_min(dy, 0.0f);
		fat.y1 += cni_max(dy, 0.0f);
	}
	return fat;
}

static void replace_some(bench_world *w)
{
	int32_t count = (int32_t)(w->kind->churn * (float)w->kind->boxes);
	for (int32_t i = 0; i < count; ++i) {
		int32_t id = (int32_t)random_to(w, 0.0f, (float)w->kind->boxes);
		w->ops->remove(w->broadphase, id);
		box_make(w, &w->boxes[id]);
		(void)proxy_add(w, id);
	}
}

static void world_update(bench_world *w)
{
	for (int32_t i = 0; i < w->left_count; ++i) {
		cni_aabb fat = box_fat(&w->boxes[w->left[i]]);
		cni_proxy_set_fat((cni_proxy *)cni_table_at(&w->proxies, w->left[i]), &fat);
		w->ops->move(w->broadphase, w->left[i]);
	}
	replace_some(w);
	w->ops->settle(w->broadphase);
	w->ops->update(w->broadphase, allow, NULL, &w->pairs);
}

static void world_step(bench_world *w, double (*clock_s)(void))
{
	boxes_advance(w);
	double start = clock_s();
	world_update(w);
	measure_times_add(&w->times, clock_s() - start);
	w->pair_count += (uint64_t)w->pairs.list.count;
	cni_arena_reset(&w->arena);
}

/* ---------------------------------------------------------------- steps */

static int32_t run_world(const world_kind *kind)
{
	uint64_t pairs[2] = {0, 0};
	int32_t failed = 0;
	for (int32_t s = 0; s < 2; ++s) {
		bench_world w;
		if (!world_open(&w, kind, structures[s].ops)) {
			fprintf(stderr, "%s: no memory\n", kind->name);
			world_close(&w);
			return 1;
		}
		for (int32_t i = 0; i < kind->steps; ++i)
			world_step(&w, measure_clock_s);
		measure_times_sort(&w.times);
		pairs[s] = w.pair_count;
		failed += s > 0 && pairs[s] != pairs[0];
		printf("%s,%d,%s,%.1f,%.1f,%.1f,%.1f,%s\n", kind->name, kind->boxes, structures[s].name, 1e3 * measure_times_at(&w.times, 0.5),
			1e3 * measure_times_at(&w.times, 1.0), (double)pairs[s] / kind->steps,
			(double)broadphase_close(&w) / kind->boxes, pairs[s] == pairs[0] ? "same" : "DIFFERENT");
		fflush(stdout);
		world_close(&w);
	}
	return failed;
}

int32_t bench_broadphase(void)
{
	const char *huge = getenv("CAIRN_BENCH_HUGE");
	int32_t failed = 0;
	printf("world,boxes,structure,us_median,us_max,new_pairs_per_step,bytes_per_proxy,pairs\n");
	for (size_t i = 0; i < sizeof worlds / sizeof worlds[0]; ++i)
		if (worlds[i].boxes < 1000000 || (huge != NULL && huge[0] == '1'))
			failed += run_world(&worlds[i]);
	return failed;
}

/* ---------------------------------------------------------------- scale */

int32_t bench_broadphase_scale(const char *structure, int32_t boxes, int32_t warm_steps, int32_t steps, double *out_ms, double *out_pairs)
{
	float side_m = 2.0f * cni_sqrt((float)boxes);
	world_kind kind = {"scale", boxes, warm_steps + steps, side_m, side_m, 0.5f, 1.5f, 3.0f, 0.5f, 0.0f, 0.0f, 0, 0};
	bench_world w;
	int32_t good = world_open(&w, &kind, structures[strcmp(structure, structures[1].name) == 0].ops);
	for (int32_t i = 0; good && i < kind.steps; ++i) {
		if (i == warm_steps)
			w.pair_count = 0;
		world_step(&w, measure_cpu_s);
	}
	for (int32_t i = 0; good && i < steps; ++i)
		out_ms[i] = w.times.ms[warm_steps + i];
	*out_pairs = (double)w.pair_count / steps;
	world_close(&w);
	return good;
}

/* ---------------------------------------------------------------- queries */

enum { QUERY_REGION, QUERY_RAY, QUERY_RAY_NEAREST, QUERY_LONG_RAY, QUERY_LONG_RAY_NEAREST, QUERY_KINDS };

typedef struct query_run {
	const bench_world *world;
	cni_vec2 o, d;
	uint64_t visits;
	double fractions;  /* of the nearest hits */
	float nearest;
} query_run;

static float visit_count(void *context, int32_t id, float limit)
{
	((query_run *)context)->visits += (uint64_t)(id >= 0);
	return limit;
}

/* Where o + t d enters the slab from a to b, at least t0. */
static float slab_entry(float o, float d, float a, float b, float t0, float *t1)
{
	float ta, tb;
	if (d == 0.0f)
		return o < a || o > b ? 2.0f : t0;
	ta = (a - o) / d;
	tb = (b - o) / d;
	*t1 = cni_min(*t1, cni_max(ta, tb));
	return cni_max(t0, cni_min(ta, tb));
}

/* A closest-hit cast, with the boxes as shapes. */
static float visit_nearest(void *context, int32_t id, float limit)
{
	query_run *q = (query_run *)context;
	const cni_aabb *box = &proxy_at(q->world, id)->fat;
	float t1 = 1.0f, t = slab_entry(q->o.x, q->d.x, box->x0, box->x1, 0.0f, &t1);
	t = slab_entry(q->o.y, q->d.y, box->y0, box->y1, t, &t1);
	if (t > t1 || t >= limit)
		return limit;
	q->nearest = t;
	return t;
}

static void query_once(query_run *q, bench_world *w, int32_t kind)
{
	cni_vec2 at, to;
	float reach = kind == QUERY_RAY || kind == QUERY_RAY_NEAREST ? 50.0f : 0.1f * cni_max(w->kind->width_m, w->kind->height_m);
	at.x = random_to(w, 0.0f, w->kind->width_m);
	at.y = random_to(w, 0.0f, w->kind->height_m);
	to.x = random_to(w, -1.0f, 1.0f);
	to.y = random_to(w, -1.0f, 1.0f);
	if (kind == QUERY_REGION) {
		cni_aabb box;
		box.x0 = at.x;
		box.y0 = at.y;
		box.x1 = at.x + 2.0f;
		box.y1 = at.y + 2.0f;
		w->ops->query(w->broadphase, &box, visit_count, q);
		return;
	}
	q->o = at;
	q->d = cni_mul(reach, cni_normalize(to));
	q->nearest = 1.0f;
	w->ops->ray(w->broadphase, q->o, q->d, kind == QUERY_RAY || kind == QUERY_LONG_RAY ? visit_count : visit_nearest, q);
	q->fractions += (double)q->nearest;
}

#define QUERIES 5000
#define QUERY_ROUNDS 12

/* Regions and nearest hits are exact; a ray may visit a box that it only just misses. */
static int32_t answers_differ(const query_run *a, const query_run *b, int32_t kind)
{
	int32_t all_of_ray = kind == QUERY_RAY || kind == QUERY_LONG_RAY;
	uint64_t more = a->visits > b->visits ? a->visits - b->visits : b->visits - a->visits;
	return a->fractions != b->fractions || more > (all_of_ray ? 1 + a->visits / 10000 : 0);
}

/* Thousands a second, in the best of some rounds. */
static double query_rate(bench_world *w, int32_t kind, query_run *q)
{
	double best = 0.0;
	for (int32_t round = 0; round < QUERY_ROUNDS; ++round) {
		memset(q, 0, sizeof *q);
		q->world = w;
		w->random = 777u + (uint32_t)kind;
		double start = measure_clock_s();
		for (int32_t i = 0; i < QUERIES; ++i)
			query_once(q, w, kind);
		double rate = 1e-3 * QUERIES / (measure_clock_s() - start);
		best = rate > best ? rate : best;
	}
	return best;
}

static int32_t query_world(const world_kind *kind)
{
	query_run q[2][QUERY_KINDS];
	int32_t failed = 0;
	for (int32_t s = 0; s < 2; ++s) {
		bench_world w;
		if (!world_open(&w, kind, structures[s].ops)) {
			fprintf(stderr, "%s: no memory\n", kind->name);
			world_close(&w);
			return 1;
		}
		for (int32_t i = 0; i < kind->steps; ++i)
			world_step(&w, measure_clock_s);
		printf("%s,%d,%s", kind->name, kind->boxes, structures[s].name);
		for (int32_t k = 0; k < QUERY_KINDS; ++k) {
			printf(",%.0f", query_rate(&w, k, &q[s][k]));
			failed += answers_differ(&q[0][k], &q[s][k], k);
		}
		printf(",%.2f,%s\n", (double)q[s][QUERY_REGION].visits / QUERIES, failed > 0 ? "DIFFERENT" : "same");
		fflush(stdout);
		world_close(&w);
	}
	return failed;
}

int32_t bench_queries(void)
{
	int32_t failed = 0;
	printf("world,boxes,structure,regions_k_per_s,rays_50m_k_per_s,rays_50m_nearest_k_per_s,"
		   "rays_tenth_k_per_s,rays_tenth_nearest_k_per_s,boxes_per_region,hits\n");
	for (size_t i = 0; i < sizeof query_worlds / sizeof query_worlds[0]; ++i)
		failed += query_world(&query_worlds[i]);
	return failed;
}
