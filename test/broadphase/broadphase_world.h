/*
 * test/broadphase/broadphase_world.h - a world of boxes that compares pairs, queries and rays of the broadphase under test
 * with brute force, and memory that fails on demand. Included by broadphase_scenes.h.
 */
#ifndef CAIRN_TEST_BROADPHASE_WORLD_H
#define CAIRN_TEST_BROADPHASE_WORLD_H

#include "../test.h"
#include "broadphase/broadphase.h"

#include <stdlib.h>
#include <time.h>

static struct {
	const cni_broadphase_ops *ops;
	uint32_t hash;        /* expected by t_same_results_everywhere */
	int32_t allocations;  /* least number of allocations that must fail one by one */
} tested;

/* ---- random numbers ---- */

static uint32_t random_state = 1;

static uint32_t random_bits(void)
{
	random_state ^= random_state << 13;
	random_state ^= random_state >> 17;
	random_state ^= random_state << 5;
	return random_state;
}

static float random_unit(void) { return (float)(random_bits() >> 8) * (1.0f / 16777216.0f); }
static float random_between(float low, float high) { return low + (high - low) * random_unit(); }

/* ---- memory that fails on demand ---- */

typedef struct flaky {
	int64_t calls;
	int64_t fail_first, fail_last; /* calls that fail, counted from 1 */
	int64_t failed;
	uint32_t dice, one_in;         /* one_in > 0: each call fails with this chance */
} flaky;

static void *flaky_alloc(uint64_t bytes, uint32_t align, void *user)
{
	flaky *f = (flaky *)user;
	uint8_t *piece, *pointer;
	++f->calls;
	f->dice = f->dice * 1664525u + 1013904223u;
	if ((f->calls >= f->fail_first && f->calls <= f->fail_last) || (f->one_in > 0 && (f->dice >> 8) % f->one_in == 0)) {
		++f->failed;
		return NULL;
	}
	piece = (uint8_t *)malloc((size_t)bytes + align + sizeof(piece));
	if (piece == NULL)
		return NULL;
	pointer = piece + sizeof(piece);
	pointer += (align - (uintptr_t)pointer % align) % align;
	memcpy(pointer - sizeof(piece), &piece, sizeof(piece));
	return pointer;
}

static void flaky_free(void *pointer, uint64_t bytes, void *user)
{
	void *piece;
	(void)bytes;
	(void)user;
	if (pointer == NULL)
		return;
	memcpy(&piece, (uint8_t *)pointer - sizeof(piece), sizeof(piece));
	free(piece);
}

/* ---- a world of boxes, with a brute force reference ---- */

#define BOXES_MOST 1000

typedef struct box_world {
	flaky flaky, arena_flaky;
	cni_memory memory, arena_memory;
	cni_memory table_memory;
	cni_arena arena;
	cni_table proxies;
	const cni_broadphase_ops *ops;
	cni_broadphase *broadphase;
	cni_broadphase_pairs pairs;
	int32_t capacity;
	/* the reference's record of present and old boxes */
	uint8_t alive[BOXES_MOST], known[BOXES_MOST];
	cni_aabb old[BOXES_MOST];
	int32_t filter_calls, filter_faults;
} box_world;

static cni_proxy *proxy_at(const box_world *w, int32_t id) { return (cni_proxy *)cni_table_at(&w->proxies, id); }

/* Consecutive ids that form one body, whose boxes never collide; 0: none do. */
static int32_t body_size;

static int32_t same_body(int32_t a, int32_t b) { return body_size > 0 && a / body_size == b / body_size; }

static int32_t filter_pair(const void *context, int32_t a, int32_t b)
{
	box_world *w = (box_world *)(uintptr_t)context;
	const cni_proxy *pa = proxy_at(w, a), *pb = proxy_at(w, b);
	++w->filter_calls;
	if (!cni_aabb_overlap(&pa->fat, &pb->fat) || a == b)
		++w->filter_faults;
	return !same_body(a, b);
}

/* The arena has no memory at all. */
static int32_t without_scratch;

static int32_t world_open(box_world *w, int32_t capacity, int64_t fail_first, int64_t fail_last)
{
	cni_broadphase_context context;
	memset(w, 0, sizeof(*w));
	w->flaky.fail_first = fail_first;
	w->flaky.fail_last = fail_last;
	w->capacity = capacity;
	w->ops = tested.ops;
	cni_memory_init_hooks(&w->memory, flaky_alloc, flaky_free, &w->flaky);
	cni_memory_init_hooks(&w->table_memory, NULL, NULL, NULL);
	if (without_scratch)
		w->arena_flaky.fail_last = INT64_MAX;
	cni_memory_init_hooks(&w->arena_memory, flaky_alloc, flaky_free, &w->arena_flaky);
	cni_arena_init(&w->arena, without_scratch ? &w->arena_memory : &w->memory);
	cni_table_init(&w->proxies, (int32_t)sizeof(cni_proxy), 6);
	cni_array_init(&w->pairs.list, (int32_t)sizeof(cni_pair));
	if (!cni_table_reserve(&w->proxies, &w->table_memory, capacity))
		abort();
	memset(&context, 0, sizeof(context));
	context.memory = &w->memory;
	context.arena = &w->arena;
	context.proxies = &w->proxies;
	w->broadphase = w->ops->create(&context, 0);
	return w->broadphase != NULL;
}

/* Destroys the broadphase; returns the bytes that it had. */
static uint64_t broadphase_close(box_world *w)
{
	uint64_t before = w->memory.bytes_in_use;
	w->ops->destroy(w->broadphase);
	w->broadphase = NULL;
	return before - w->memory.bytes_in_use;
}

static void world_close(box_world *w)
{
	if (w->broadphase != NULL)
		w->ops->destroy(w->broadphase);
	cni_array_deinit(&w->pairs.list, &w->memory);
	cni_arena_deinit(&w->arena);
	cni_table_deinit(&w->proxies, &w->table_memory);
	CHECK(w->memory.bytes_in_use == 0);
}

static int32_t world_add(box_world *w, int32_t id, cni_aabb box, int32_t is_static)
{
	cni_proxy *p = proxy_at(w, id);
	if (!w->ops->reserve(w->broadphase, 1))
		return 0;
	p->fat = box;
	p->old.x0 = p->old.y0 = 1.0f;
	p->old.x1 = p->old.y1 = -1.0f;
	p->flags = CNI_PROXY_ALIVE | (is_static ? CNI_PROXY_STATIC : 0u);
	w->ops->add(w->broadphase, id);
	if (id < BOXES_MOST) {
		w->alive[id] = 1;
		w->known[id] = 0;
	}
	return 1;
}

static void world_move(box_world *w, int32_t id, const cni_aabb *box)
{
	cni_proxy_set_fat(proxy_at(w, id), box);
	w->ops->move(w->broadphase, id);
}

static void world_remove(box_world *w, int32_t id)
{
	w->ops->remove(w->broadphase, id);
	proxy_at(w, id)->flags = 0;
	w->alive[id] = 0;
}

static void world_touch(box_world *w, int32_t id)
{
	w->ops->touch(w->broadphase, id);
	w->known[id] = 0;
}

static int32_t pair_allowed(const box_world *w, int32_t a, int32_t b)
{
	if (proxy_at(w, a)->flags & proxy_at(w, b)->flags & CNI_PROXY_STATIC)
		return 0;
	return !same_body(a, b);
}

/* Pairs by brute force, in the specified order; then makes the present boxes the old ones. */
static int32_t reference_pairs(box_world *w, cni_pair *out, int32_t room)
{
	int32_t a, b, count = 0;
	for (a = 0; a < w->capacity; ++a) {
		for (b = a + 1; w->alive[a] && b < w->capacity; ++b) {
			int32_t was = w->known[a] && w->known[b] && cni_aabb_overlap(&w->old[a], &w->old[b]);
			if (!w->alive[b] || was || !cni_aabb_overlap(&proxy_at(w, a)->fat, &proxy_at(w, b)->fat) || !pair_allowed(w, a, b))
				continue;
			if (count < room) {
				out[count].a = a;
				out[count].b = b;
			}
			++count;
		}
	}
	for (a = 0; a < w->capacity; ++a) {
		w->known[a] = w->alive[a];
		if (w->alive[a])
			w->old[a] = proxy_at(w, a)->fat;
	}
	return count;
}

static cni_pair expected[BOXES_MOST * (BOXES_MOST - 1) / 2];

/* One update compared with brute force; returns the number of differences. */
static int64_t pairs_seen;
static uint32_t pairs_hash;

static int32_t world_update(box_world *w)
{
	int32_t count = reference_pairs(w, expected, BOXES_MOST * (BOXES_MOST - 1) / 2);
	const cni_pair *found;
	int32_t i, wrong;
	w->ops->update(w->broadphase, filter_pair, w, &w->pairs);
	cni_arena_reset(&w->arena);
	found = (const cni_pair *)w->pairs.list.data;
	wrong = w->pairs.list.count != count || w->pairs.pairs_lost != 0;
	for (i = 0; i < count && i < w->pairs.list.count; ++i)
		wrong += found[i].a != expected[i].a || found[i].b != expected[i].b;
	for (i = 0; i < w->capacity; ++i)
		if (w->alive[i])
			wrong += (proxy_at(w, i)->flags & CNI_PROXY_MOVED) != 0 || memcmp(&proxy_at(w, i)->old, &proxy_at(w, i)->fat, sizeof(cni_aabb)) != 0;
	for (i = 0; i < w->pairs.list.count; ++i)
		pairs_hash = (pairs_hash * 16777619u ^ (uint32_t)found[i].a) * 16777619u ^ (uint32_t)found[i].b;
	pairs_seen += count;
	return wrong;
}

/* ---- queries against brute force ---- */

static double least(double a, double b) { return a < b ? a : b; }
static double most(double a, double b) { return a > b ? a : b; }
static double size_of(double a) { return a < 0.0 ? -a : a; }

typedef struct visits {
	uint8_t seen[BOXES_MOST];
	int32_t twice;
	int32_t stop_after;
	int32_t count;
} visits;

static float visit_mark(void *context, int32_t id, float limit)
{
	visits *v = (visits *)context;
	v->twice += v->seen[id];
	v->seen[id] = 1;
	return ++v->count == v->stop_after ? 0.0f : limit;
}

static int32_t query_differs(const box_world *w, cni_aabb box)
{
	static visits v;
	int32_t id, wrong;
	memset(&v, 0, sizeof(v));
	w->ops->query(w->broadphase, &box, visit_mark, &v);
	wrong = v.twice;
	for (id = 0; id < w->capacity; ++id)
		wrong += v.seen[id] != (w->alive[id] && cni_aabb_overlap(&proxy_at(w, id)->fat, &box));
	return wrong;
}

/* 1 when the segment crosses the box grown by margin, in doubles: certain for a margin below 0. */
static int32_t segment_crosses(cni_vec2 o, cni_vec2 d, double limit, const cni_aabb *b, double margin)
{
	double low[2], high[2], start[2], along[2], t0 = 0.0, t1 = limit;
	int32_t i;
	low[0] = (double)b->x0 - margin, low[1] = (double)b->y0 - margin;
	high[0] = (double)b->x1 + margin, high[1] = (double)b->y1 + margin;
	start[0] = (double)o.x, start[1] = (double)o.y;
	along[0] = (double)d.x, along[1] = (double)d.y;
	if (low[0] > high[0] || low[1] > high[1])
		return 0;
	for (i = 0; i < 2; ++i) {
		double ta, tb;
		if (along[i] == 0.0) {
			if (start[i] < low[i] || start[i] > high[i])
				return 0;
			continue;
		}
		ta = (low[i] - start[i]) / along[i];
		tb = (high[i] - start[i]) / along[i];
		t0 = most(t0, least(ta, tb));
		t1 = least(t1, most(ta, tb));
	}
	return t0 <= t1;
}

static int32_t ray_differs(const box_world *w, cni_vec2 o, cni_vec2 d)
{
	static visits v;
	double reach = size_of((double)o.x) + size_of((double)o.y) + size_of((double)d.x) + size_of((double)d.y);
	double margin = 4e-6 * reach;
	int32_t id, wrong;
	memset(&v, 0, sizeof(v));
	w->ops->ray(w->broadphase, o, d, visit_mark, &v);
	wrong = v.twice;
	for (id = 0; id < w->capacity; ++id) {
		const cni_aabb *fat = &proxy_at(w, id)->fat;
		if (!w->alive[id]) {
			wrong += v.seen[id];
			continue;
		}
		wrong += !v.seen[id] && segment_crosses(o, d, 1.0, fat, -margin);
		wrong += v.seen[id] && !segment_crosses(o, d, 1.0, fat, margin);
	}
	return wrong;
}

/* A closest-hit cast: the visitor shortens the ray to its entry into the box. */
typedef struct nearest {
	const box_world *world;
	cni_vec2 o, d;
	double best;
	int32_t visited;
} nearest;

static double segment_entry(cni_vec2 o, cni_vec2 d, const cni_aabb *b)
{
	double low = 0.0, high = 1.0;
	int32_t i;
	if (!segment_crosses(o, d, 1.0, b, 0.0))
		return 2.0;
	for (i = 0; i < 50; ++i) {
		double middle = 0.5 * (low + high);
		if (segment_crosses(o, d, middle, b, 0.0))
			high = middle;
		else
			low = middle;
	}
	return high;
}

static float visit_nearest(void *context, int32_t id, float limit)
{
	nearest *n = (nearest *)context;
	double t = segment_entry(n->o, n->d, &proxy_at(n->world, id)->fat);
	++n->visited;
	if (t < n->best)
		n->best = t;
	return (float)n->best < limit ? (float)n->best : limit;
}

/* The fraction by which the hit found is later than the true first hit. */
static double nearest_error(const box_world *w, cni_vec2 o, cni_vec2 d)
{
	nearest n;
	double best = 2.0;
	int32_t id;
	n.world = w;
	n.o = o;
	n.d = d;
	n.best = 2.0;
	n.visited = 0;
	w->ops->ray(w->broadphase, o, d, visit_nearest, &n);
	for (id = 0; id < w->capacity; ++id)
		if (w->alive[id])
			best = least(best, segment_entry(o, d, &proxy_at(w, id)->fat));
	return size_of(n.best - best);
}

/* ---- boxes ---- */

static cni_aabb box_at(float x, float y, float width, float height)
{
	cni_aabb box;
	box.x0 = x;
	box.y0 = y;
	box.x1 = x + width;
	box.y1 = y + height;
	return box;
}

/* 10^u, u uniform. */
static float random_size(float low, float high)
{
	float u = random_unit(), size = low;
	while (size < high && u > 0.06f) {
		size *= 1.9f;
		u = random_unit();
	}
	return size < high ? size * random_between(1.0f, 1.9f) : high;
}

/* A box of this size with its lower corner in a range. Draws x before y explicitly: the order of evaluation of arguments is
   unspecified. */
static cni_aabb box_within(float x_low, float x_high, float y_low, float y_high, cni_vec2 size)
{
	float x = random_between(x_low, x_high);
	float y = random_between(y_low, y_high);
	return box_at(x, y, size.x, size.y);
}

static cni_vec2 size_between(float low, float high)
{
	float width = random_between(low, high);
	return cni_v(width, random_between(low, high));
}

#endif
