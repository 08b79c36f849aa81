/*
 * test/query/tree_api_test.c - cn_tree_*: a tree of boxes for the game's own use.
 *
 * If a test here fails, look in query/tree.c (handles, errors, margins), then at broadphase/tree_test.c.
 */
#include "cairn.h"
#include "test.h"

#include <math.h>
#include <stdlib.h>

#define ITEMS 500

/* ---- memory that fails on demand, and counts */

typedef struct hooks {
	int64_t live;
	int32_t allow; /* allocations until they fail; negative: never */
	int32_t calls;
} hooks;

static void *hooks_alloc(uint64_t bytes, uint32_t align, void *user)
{
	hooks *h = (hooks *)user;
	unsigned char *raw, *out;
	++h->calls;
	if (h->allow == 0)
		return NULL;
	h->allow -= h->allow > 0;
	raw = (unsigned char *)malloc((size_t)bytes + align + sizeof(void *));
	out = (unsigned char *)(((uintptr_t)raw + sizeof(void *) + align - 1) & ~(uintptr_t)(align - 1));
	memcpy(out - sizeof(void *), &raw, sizeof raw);
	h->live += (int64_t)bytes;
	return out;
}

static void hooks_free(void *memory, uint64_t bytes, void *user)
{
	void *raw;
	if (memory == NULL)
		return;
	memcpy(&raw, (unsigned char *)memory - sizeof(void *), sizeof raw);
	((hooks *)user)->live -= (int64_t)bytes;
	free(raw);
}

/* ---- boxes */

static uint32_t random_state = 1;

static float random_between(float low, float high)
{
	random_state ^= random_state << 13;
	random_state ^= random_state >> 17;
	random_state ^= random_state << 5;
	return low + (high - low) * (float)(random_state >> 8) / 16777216.0f;
}

static cn_aabb box_at(float x, float y, float width, float height)
{
	cn_aabb box;
	box.lower_m.x = x;
	box.lower_m.y = y;
	box.upper_m.x = x + width;
	box.upper_m.y = y + height;
	return box;
}

static cn_aabb random_box(void)
{
	float x = random_between(-40, 40), y = random_between(-40, 40), width = random_between(0, 3);
	return box_at(x, y, width, random_between(0, 3));
}

static int overlap(const cn_aabb *a, const cn_aabb *b)
{
	return a->lower_m.x <= b->upper_m.x && b->lower_m.x <= a->upper_m.x && a->lower_m.y <= b->upper_m.y && b->lower_m.y <= a->upper_m.y;
}

static int contains(const cn_aabb *outer, const cn_aabb *inner)
{
	return outer->lower_m.x <= inner->lower_m.x && outer->lower_m.y <= inner->lower_m.y && inner->upper_m.x <= outer->upper_m.x &&
	       inner->upper_m.y <= outer->upper_m.y;
}

/* ---- a game's list of things beside the tree: user data is the number of the thing */

typedef struct game {
	cn_tree *tree;
	uint32_t item[ITEMS];
	cn_aabb box[ITEMS];
	int32_t seen[ITEMS];
	int32_t visits, stop_after;
	int32_t faults;
} game;

static game g;

static int32_t see(uint32_t item, uint64_t user_data, void *user)
{
	game *w = (game *)user;
	w->faults += user_data >= ITEMS || w->item[user_data] != item;
	++w->seen[user_data];
	return ++w->visits != w->stop_after;
}

static int32_t query_differs(cn_aabb box)
{
	int32_t k, wrong = 0;
	memset(g.seen, 0, sizeof g.seen);
	CHECK(cn_tree_query(g.tree, &box, see, &g) == CN_OK);
	for (k = 0; k < ITEMS; ++k) {
		cn_aabb fat;
		if (g.item[k] == 0) {
			wrong += g.seen[k];
			continue;
		}
		CHECK(cn_tree_get_box(g.tree, g.item[k], &fat) == CN_OK);
		wrong += g.seen[k] != overlap(&fat, &box) || !contains(&fat, &g.box[k]);
	}
	return wrong;
}

static void t_query_finds_what_is_there(void)
{
	int32_t step, k, wrong = 0, count = 0, items, height;
	memset(&g, 0, sizeof g);
	random_state = 4;
	REQUIRE(cn_tree_create(0.2f, NULL, NULL, NULL, &g.tree) == CN_OK);
	wrong += query_differs(box_at(-100, -100, 200, 200));
	for (step = 0; step < 4000; ++step) {
		k = (int32_t)random_between(0, ITEMS);
		g.box[k] = random_box();
		if (g.item[k] == 0) {
			CHECK(cn_tree_insert(g.tree, &g.box[k], (uint64_t)k, &g.item[k]) == CN_OK && g.item[k] != 0);
			++count;
		} else if (step % 4 == 0) {
			CHECK(cn_tree_remove(g.tree, g.item[k]) == CN_OK);
			g.item[k] = 0;
			--count;
		} else {
			CHECK(cn_tree_move(g.tree, g.item[k], &g.box[k]) == CN_OK);
		}
		if (step % 40 == 0)
			wrong += query_differs(random_box()) + query_differs(box_at(-20, -20, 30, 30));
	}
	CHECK(cn_tree_get_stats(g.tree, &items, &height) == CN_OK && items == count);
	printf("  %d items, height %d, %d visits\n", items, height, g.visits);
	CHECK_LE("height", height, 2.5 * log2((double)items) + 2.0, "");
	CHECK_LE("queries that differ from brute force", wrong, 0, "");
	CHECK_LE("items with another's user data", g.faults, 0, "");
	for (k = 1; k <= 5; ++k) {
		cn_aabb all = box_at(-100, -100, 200, 200);
		g.visits = 0;
		g.stop_after = k;
		CHECK(cn_tree_query(g.tree, &all, see, &g) == CN_OK && g.visits == k);
	}
	cn_tree_destroy(g.tree);
}

/* The margin is what a box may move without any work, and what queries see. */
static void t_margin(void)
{
	cn_tree *tree;
	cn_aabb box = box_at(0, 0, 1, 1), before, after;
	uint32_t item;
	REQUIRE(cn_tree_create(0.5f, NULL, NULL, NULL, &tree) == CN_OK);
	REQUIRE(cn_tree_insert(tree, &box, 0, &item) == CN_OK);
	CHECK(cn_tree_get_box(tree, item, &before) == CN_OK && before.lower_m.x == -0.5f && before.upper_m.y == 1.5f);
	box = box_at(0.5f, -0.5f, 1, 1);
	CHECK(cn_tree_move(tree, item, &box) == CN_OK && cn_tree_get_box(tree, item, &after) == CN_OK);
	CHECK(memcmp(&before, &after, sizeof after) == 0);
	box = box_at(0.75f, -0.5f, 1, 1);
	CHECK(cn_tree_move(tree, item, &box) == CN_OK && cn_tree_get_box(tree, item, &after) == CN_OK);
	CHECK(after.lower_m.x == 0.25f && after.upper_m.x == 2.25f && after.lower_m.y == -1.0f && after.upper_m.y == 1.0f);
	cn_tree_destroy(tree);
}

/* ---- rays */

typedef struct hits {
	float nearest;
	int32_t visits;
	uint64_t first;
} hits;

static float hit_all(uint32_t item, uint64_t user_data, float fraction, void *user)
{
	hits *h = (hits *)user;
	(void)item;
	if (h->visits++ == 0)
		h->first = user_data;
	return fraction;
}

/* Things in a row, one metre apart and as wide; the ray goes 100 m: thing k is entered at k / 50. */
static float hit_nearest(uint32_t item, uint64_t user_data, float fraction, void *user)
{
	hits *h = (hits *)user;
	float entry = (float)user_data * 0.02f;
	(void)item;
	++h->visits;
	if (entry < fraction)
		h->nearest = entry;
	return entry < fraction ? entry : fraction;
}

static float hit_stop(uint32_t item, uint64_t user_data, float fraction, void *user)
{
	(void)item, (void)user_data, (void)fraction;
	++((hits *)user)->visits;
	return 0.0f;
}

static void t_rays(void)
{
	hits h = { 2.0f, 0, 0 };
	cn_ray ray = { { 0.0f, 0.5f }, { 100.0f, 0.0f } };
	uint32_t item;
	int32_t k;
	memset(&g, 0, sizeof g);
	REQUIRE(cn_tree_create(0.0f, NULL, NULL, NULL, &g.tree) == CN_OK);
	for (k = 49; k >= 5; --k) {
		cn_aabb box = box_at(2.0f * (float)k, 0, 1, 1);
		CHECK(cn_tree_insert(g.tree, &box, (uint64_t)k, &item) == CN_OK);
	}
	CHECK(cn_tree_cast_ray(g.tree, &ray, hit_all, &h) == CN_OK);
	CHECK(h.visits == 45 && h.first == 5);
	h.visits = 0;
	CHECK(cn_tree_cast_ray(g.tree, &ray, hit_nearest, &h) == CN_OK);
	CHECK_LE("error of the nearest", fabs((double)h.nearest - 0.1), 1e-6, "");
	CHECK_LE("items visited on the way", h.visits, 2, "");
	h.visits = 0;
	CHECK(cn_tree_cast_ray(g.tree, &ray, hit_stop, &h) == CN_OK && h.visits == 1);
	ray.origin_m.y = 1.5f;
	h.visits = 0;
	CHECK(cn_tree_cast_ray(g.tree, &ray, hit_all, &h) == CN_OK && h.visits == 0);
	ray.origin_m.x = 20.5f;
	ray.origin_m.y = 0.5f;
	ray.translation_m.x = 0.0f;
	CHECK(cn_tree_cast_ray(g.tree, &ray, hit_all, &h) == CN_OK && h.visits == 1 && h.first == 10);
	cn_tree_destroy(g.tree);
}

/* ---- handles and errors */

static void t_bad_arguments_change_nothing(void)
{
	static const float bad[] = { NAN, INFINITY, -INFINITY };
	cn_tree *tree = NULL;
	cn_aabb box = box_at(0, 0, 1, 1), out;
	uint32_t item, other = 77;
	int32_t k, count, height;
	cn_ray ray = { { 0.0f, 0.0f }, { 1.0f, 0.0f } };
	hits h;
	for (k = 0; k < 3; ++k)
		CHECK(cn_tree_create(bad[k], NULL, NULL, NULL, &tree) == CN_ERROR_ARGUMENT && tree == NULL);
	CHECK(cn_tree_create(-0.1f, NULL, NULL, NULL, &tree) == CN_ERROR_ARGUMENT);
	CHECK(cn_tree_create(0, hooks_alloc, NULL, NULL, &tree) == CN_ERROR_ARGUMENT && cn_tree_create(0, NULL, NULL, NULL, NULL) == CN_ERROR_ARGUMENT);
	REQUIRE(cn_tree_create(3e37f, NULL, NULL, NULL, &tree) == CN_OK);
	REQUIRE(cn_tree_insert(tree, &box, 9, &item) == CN_OK);
	for (k = 0; k < 12; ++k) {
		cn_aabb worse = box;
		((float *)&worse)[k % 4] = bad[k / 4];
		CHECK(cn_tree_insert(tree, &worse, 0, &other) == CN_ERROR_ARGUMENT);
		CHECK(cn_tree_move(tree, item, &worse) == CN_ERROR_ARGUMENT);
		CHECK(cn_tree_query(tree, &worse, see, NULL) == CN_ERROR_ARGUMENT);
		((float *)&ray)[k % 4] = bad[k / 4];
		CHECK(cn_tree_cast_ray(tree, &ray, hit_all, &h) == CN_ERROR_ARGUMENT);
		((float *)&ray)[k % 4] = 0.0f;
	}
	box = box_at(1, 1, -2, 1);
	CHECK(cn_tree_insert(tree, &box, 0, &other) == CN_ERROR_ARGUMENT && cn_tree_move(tree, item, &box) == CN_ERROR_ARGUMENT);
	box = box_at(3.3e38f, 0, 0, 1); /* finite, but not with this margin */
	CHECK(cn_tree_insert(tree, &box, 0, &other) == CN_ERROR_ARGUMENT && other == 77);
	CHECK(cn_tree_insert(tree, NULL, 0, &other) == CN_ERROR_ARGUMENT && cn_tree_insert(NULL, &box, 0, &other) == CN_ERROR_ARGUMENT);
	CHECK(cn_tree_get_stats(tree, &count, &height) == CN_OK && count == 1 && height == 0);
	CHECK(cn_tree_get_box(tree, item, &out) == CN_OK && out.lower_m.x == -3e37f);
	CHECK(cn_tree_get_stats(NULL, &count, &height) == CN_ERROR_ARGUMENT);
	cn_tree_destroy(tree);
	cn_tree_destroy(NULL);
}

static void t_stale_items_are_refused(void)
{
	cn_tree *tree;
	cn_aabb box = box_at(0, 0, 1, 1), out;
	uint32_t old, item;
	int32_t k, stale = 0;
	REQUIRE(cn_tree_create(0, NULL, NULL, NULL, &tree) == CN_OK);
	REQUIRE(cn_tree_insert(tree, &box, 0, &old) == CN_OK && cn_tree_remove(tree, old) == CN_OK);
	for (k = 0; k < 3000; ++k) { /* wears a slot out: its generations never come back */
		REQUIRE(cn_tree_insert(tree, &box, 0, &item) == CN_OK);
		stale += cn_tree_get_box(tree, old, &out) == CN_ERROR_HANDLE && cn_tree_remove(tree, old) == CN_ERROR_HANDLE;
		CHECK(cn_tree_remove(tree, item) == CN_OK && cn_tree_remove(tree, item) == CN_ERROR_HANDLE);
	}
	CHECK_GE("refusals of a stale item", stale, 3000, "");
	CHECK(cn_tree_move(tree, 0, &box) == CN_ERROR_HANDLE && cn_tree_remove(tree, 0xFFFFFFFFu) == CN_ERROR_HANDLE);
	cn_tree_destroy(tree);
}

/* ---- memory */

static void t_memory_comes_from_the_hooks(void)
{
	hooks h = { 0, -1, 0 };
	cn_tree *tree;
	uint32_t item;
	int32_t k, calls;
	REQUIRE(cn_tree_create(0.1f, hooks_alloc, hooks_free, &h, &tree) == CN_OK);
	for (k = 0; k < 20000; ++k) {
		cn_aabb box = random_box();
		REQUIRE(cn_tree_insert(tree, &box, 0, &item) == CN_OK);
	}
	CHECK_LE("memory", (double)h.live / 20000.0, 72, "bytes an item");
	calls = h.calls;
	for (k = 0; k < 10000; ++k) {
		cn_aabb box = random_box();
		if (k == 1023) { /* in which a slot wears out its index, and its next one is written down */
			CHECK_LE("allocations by moving and replacing, 1,023 times", h.calls - calls, 2, "");
			calls = h.calls;
		}
		REQUIRE(cn_tree_move(tree, item, &box) == CN_OK);
		REQUIRE(cn_tree_remove(tree, item) == CN_OK && cn_tree_insert(tree, &box, 0, &item) == CN_OK);
	}
	CHECK_LE("... 8,977 times more", h.calls - calls, 0, "");
	cn_tree_destroy(tree);
	CHECK_LE("bytes that are not given back", h.live, 0, "");
}

static void t_failed_insertions_change_nothing(void)
{
	int32_t allow, refused = 0;
	for (allow = 0; allow < 40; ++allow) {
		hooks h = { 0, -1, 0 };
		uint32_t item;
		int32_t k, count = 0, height;
		memset(&g, 0, sizeof g);
		h.allow = allow;
		if (cn_tree_create(0.1f, hooks_alloc, hooks_free, &h, &g.tree) != CN_OK) {
			CHECK(allow == 0 && h.live == 0);
			continue;
		}
		for (k = 0; k < ITEMS; ++k) {
			cn_result result;
			g.box[k] = random_box();
			result = cn_tree_insert(g.tree, &g.box[k], (uint64_t)k, &item);
			CHECK(result == CN_OK || result == CN_ERROR_MEMORY);
			refused += result != CN_OK;
			g.item[k] = result == CN_OK ? item : 0;
			if (k % 100 == 99)
				h.allow = k % 200 == 99 ? -1 : 0;
		}
		for (k = 0; k < ITEMS; ++k)
			count += g.item[k] != 0;
		CHECK(cn_tree_get_stats(g.tree, &k, &height) == CN_OK && k == count);
		CHECK(query_differs(box_at(-20, -20, 40, 40)) == 0 && query_differs(random_box()) == 0);
		cn_tree_destroy(g.tree);
		CHECK(h.live == 0);
	}
	printf("  %d insertions refused\n", refused);
	CHECK(refused > 100);
}

/* ---- a visitor that breaks the rules harms nothing but its own search */

typedef struct rude {
	cn_tree *tree;
	uint32_t items[64];
	int32_t next, visits;
} rude;

static int32_t change_while_searching(uint32_t item, uint64_t user_data, void *user)
{
	rude *r = (rude *)user;
	cn_aabb box = box_at((float)(r->visits % 7), (float)(r->visits % 5), 3, 3);
	uint32_t *slot = &r->items[r->next++ % 64];
	(void)user_data;
	(void)cn_tree_remove(r->tree, r->visits % 3 ? item : *slot);
	(void)cn_tree_insert(r->tree, &box, 0, slot);
	return ++r->visits < 2000;
}

static void t_changing_while_searching_is_survived(void)
{
	rude r;
	cn_aabb all = box_at(-100, -100, 200, 200);
	int32_t k, count, height;
	memset(&r, 0, sizeof r);
	REQUIRE(cn_tree_create(0.1f, NULL, NULL, NULL, &r.tree) == CN_OK);
	for (k = 0; k < 64; ++k) {
		cn_aabb box = box_at((float)k, 0, 2, 2);
		CHECK(cn_tree_insert(r.tree, &box, 0, &r.items[k]) == CN_OK);
	}
	CHECK(cn_tree_query(r.tree, &all, change_while_searching, &r) == CN_OK);
	CHECK(cn_tree_get_stats(r.tree, &count, &height) == CN_OK);
	printf("  %d visits, %d items after\n", r.visits, count);
	CHECK(r.visits > 0 && count > 0);
	cn_tree_destroy(r.tree);
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(t_query_finds_what_is_there);
	RUN(t_margin);
	RUN(t_rays);
	RUN(t_bad_arguments_change_nothing);
	RUN(t_stale_items_are_refused);
	RUN(t_memory_comes_from_the_hooks);
	RUN(t_failed_insertions_change_nothing);
	RUN(t_changing_while_searching_is_survived);
	return test_end();
}
