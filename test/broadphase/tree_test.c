/*
 * test/broadphase/tree_test.c - the dynamic AABB tree: invariants after every kind of change, searches against brute force,
 * balance for any order of insertion, and quality while all items move.
 *
 * If a test here fails, look in broadphase/tree.c (invariants, balance), tree_settle.c (moved items, rebuilding),
 * tree_search.c (searches).
 */
#include "../test.h"
#include "broadphase/tree.h"

#include <math.h>
#include <stdlib.h>

#define ITEMS 2000

static uint32_t random_state = 1;

static float random_between(float low, float high)
{
	random_state ^= random_state << 13;
	random_state ^= random_state >> 17;
	random_state ^= random_state << 5;
	return low + (high - low) * (float)(random_state >> 8) / 16777216.0f;
}

static cni_aabb box_at(float x, float y, float width, float height)
{
	cni_aabb box;
	box.x0 = x;
	box.y0 = y;
	box.x1 = x + width;
	box.y1 = y + height;
	return box;
}

static cni_aabb random_box(float world, float size)
{
	float x = random_between(-world, world), y = random_between(-world, world);
	float width = random_between(0.0f, size);
	return box_at(x, y, width, random_between(0.0f, size));
}

/* ---- a tree and a plain list as reference ---- */

typedef struct plain {
	cni_memory memory;
	cni_tree tree;
	cni_aabb boxes[ITEMS];
	uint8_t in[ITEMS], moved[ITEMS];
	void *scratch;
} plain;

static plain p;

static void plain_open(void)
{
	memset(&p, 0, sizeof p);
	cni_memory_init_hooks(&p.memory, NULL, NULL, NULL);
	cni_tree_init(&p.tree);
	CHECK(cni_tree_reserve(&p.tree, &p.memory, ITEMS, 1));
	p.scratch = malloc(ITEMS * 24u);
}

static void plain_close(void)
{
	cni_tree_deinit(&p.tree, &p.memory);
	CHECK(p.memory.bytes_in_use == 0);
	free(p.scratch);
}

static void plain_insert(int32_t item, cni_aabb box)
{
	p.boxes[item] = box;
	p.in[item] = 1;
	p.moved[item] = 0;
	cni_tree_insert(&p.tree, item, &box);
}

static void plain_remove(int32_t item)
{
	p.in[item] = p.moved[item] = 0;
	cni_tree_remove(&p.tree, item);
}

typedef struct visits {
	int32_t seen[ITEMS];
	int32_t count;
} visits;

static float visit(void *context, int32_t item, float limit)
{
	visits *v = (visits *)context;
	++v->seen[item];
	++v->count;
	return limit;
}

static int32_t query_differs(cni_aabb box)
{
	static visits v;
	int32_t item, wrong = 0;
	memset(&v, 0, sizeof v);
	cni_tree_query(&p.tree, &box, visit, &v);
	for (item = 0; item < ITEMS; ++item)
		wrong += v.seen[item] != (p.in[item] && cni_aabb_overlap(&p.boxes[item], &box));
	return wrong;
}

/* 1 when the segment crosses the box grown by margin: slab test in doubles. */
static int32_t crosses(cni_vec2 o, cni_vec2 d, const cni_aabb *b, double margin)
{
	double start[2], along[2], low[2], high[2], t0 = 0.0, t1 = 1.0;
	int32_t k;
	start[0] = (double)o.x, start[1] = (double)o.y, along[0] = (double)d.x, along[1] = (double)d.y;
	low[0] = (double)b->x0 - margin, low[1] = (double)b->y0 - margin;
	high[0] = (double)b->x1 + margin, high[1] = (double)b->y1 + margin;
	for (k = 0; k < 2; ++k) {
		double a, c;
		if (low[k] > high[k])
			return 0;
		if (along[k] == 0.0) {
			if (start[k] < low[k] || start[k] > high[k])
				return 0;
			continue;
		}
		a = (low[k] - start[k]) / along[k];
		c = (high[k] - start[k]) / along[k];
		t0 = greater(t0, fmin(a, c));
		t1 = fmin(t1, fmax(a, c));
	}
	return t0 <= t1;
}

static int32_t ray_differs(cni_vec2 o, cni_vec2 d)
{
	static visits v;
	double margin = 4e-6 * (fabs((double)o.x) + fabs((double)o.y) + fabs((double)d.x) + fabs((double)d.y));
	int32_t item, wrong = 0;
	memset(&v, 0, sizeof v);
	cni_tree_ray(&p.tree, o, d, visit, &v);
	for (item = 0; item < ITEMS; ++item) {
		wrong += v.seen[item] > p.in[item];
		wrong += p.in[item] && !v.seen[item] && crosses(o, d, &p.boxes[item], -margin);
		wrong += v.seen[item] && !crosses(o, d, &p.boxes[item], margin);
	}
	return wrong;
}

static uint8_t pair_seen[ITEMS][ITEMS];

static void see_pair(void *context, int32_t a, int32_t b)
{
	++*(int32_t *)context;
	++pair_seen[cni_min_i(a, b)][cni_max_i(a, b)];
}

static int32_t pairs_differ(int32_t *pairs)
{
	int32_t a, b, wrong = 0;
	memset(pair_seen, 0, sizeof pair_seen);
	cni_tree_pairs(&p.tree, see_pair, pairs);
	for (a = 0; a < ITEMS; ++a)
		for (b = a + 1; b < ITEMS; ++b)
			wrong += pair_seen[a][b] != (p.in[a] && p.in[b] && (p.moved[a] || p.moved[b]) && cni_aabb_overlap(&p.boxes[a], &p.boxes[b]));
	return wrong;
}

static void unmark(void *context, int32_t item)
{
	++*(int32_t *)context;
	CHECK(p.moved[item]);
	p.moved[item] = 0;
}

/* ---- invariants and searches ---- */

static void change_something(void)
{
	int32_t item = (int32_t)random_between(0.0f, (float)ITEMS);
	float dice = random_between(0.0f, 1.0f);
	cni_aabb box = random_box(50.0f, dice < 0.05f ? 60.0f : 2.0f);
	if (!p.in[item])
		plain_insert(item, box);
	else if (dice < 0.2f)
		plain_remove(item);
	else if (dice < 0.4f)
		cni_tree_move(&p.tree, item, &box), p.boxes[item] = box;
	else {
		if (dice < 0.8f) /* a little */
			box = box_at(p.boxes[item].x0 + random_between(-0.5f, 0.5f), p.boxes[item].y0, box.x1 - box.x0, box.y1 - box.y0);
		cni_tree_set_box(&p.tree, item, &box);
		cni_tree_mark_moved(&p.tree, item);
		p.boxes[item] = box;
		p.moved[item] = 1;
	}
}

static void t_searches_find_what_brute_force_finds(void)
{
	int32_t round, k, wrong = 0, invalid = 0, pairs = 0, unmarked = 0, left = 0;
	random_state = 7;
	plain_open();
	for (round = 0; round < TEST_MANY(60); ++round) {
		for (k = 0; k < 20 + 40 * (round % 6); ++k) {
			change_something();
			invalid += !cni_tree_validate(&p.tree);
		}
		for (k = 0; k < 20; ++k) {
			float x = random_between(-60.0f, 60.0f), y = random_between(-60.0f, 60.0f);
			float dx = k % 5 == 0 ? 0.0f : random_between(-80.0f, 80.0f), dy = k % 7 == 0 ? 0.0f : random_between(-80.0f, 80.0f);
			wrong += query_differs(random_box(50.0f, 20.0f)) + ray_differs(cni_v(x, y), cni_v(dx, dy));
		}
		wrong += pairs_differ(&pairs);
		if (round % 2)
			cni_tree_unmark_moved(&p.tree, unmark, &unmarked);
		cni_tree_settle(&p.tree, round % 3 ? p.scratch : NULL);
		invalid += !cni_tree_validate(&p.tree) || p.tree.stale != 0;
		wrong += pairs_differ(&pairs) + query_differs(random_box(50.0f, 20.0f));
	}
	for (k = 0; k < ITEMS; ++k)
		left += p.moved[k];
	printf("  %d items, %d pairs, %d unmarked, %d still moved\n", p.tree.count, pairs, unmarked, left);
	CHECK(pairs > TEST_FORM(1000, 1000, 100) && unmarked > TEST_MANY(100) && left == 0);
	CHECK_LE("answers that differ from brute force", wrong, 0, "");
	CHECK_LE("states that are not valid", invalid, 0, "");
	for (k = 0; k < ITEMS; ++k)
		if (p.in[k])
			plain_remove(k);
	CHECK(p.tree.count == 0 && cni_tree_validate(&p.tree) && query_differs(box_at(-99, -99, 198, 198)) == 0);
	plain_close();
}

/* n items need n nodes: insertions and removals lose no node. */
static void t_nodes_are_reused(void)
{
	int32_t k;
	plain_open();
	for (k = 0; k < ITEMS; ++k)
		plain_insert(k, random_box(50.0f, 2.0f));
	for (k = 0; k < 20 * ITEMS; ++k) {
		plain_remove(k * 7 % ITEMS);
		plain_insert(k * 7 % ITEMS, random_box(50.0f, 2.0f));
	}
	CHECK_LE("nodes", p.tree.nodes.count, ITEMS, "");
	CHECK(cni_tree_validate(&p.tree));
	plain_close();
}

/* ---- balance ---- */

static float spread; /* of the boxes in this order */

static cni_aabb ordered_box(int32_t order, int32_t k)
{
	float x = (float)k;
	switch (order) {
	case 0: return box_at(x, 0, 1, 1);                                             /* a row */
	case 1: return box_at(0, 0, 1, 1);                                             /* all equal */
	case 2: return box_at(-x, -x, 2 * x, 2 * x);                                   /* each contains the last */
	case 3: return box_at(-1e30f, -1e30f, 1e30f * (1.0f + x * 1e-3f), 1e30f);      /* huge */
	case 4: spread *= 1.04f; return box_at(spread, 0, 0.1f * spread, 1);           /* each farther away */
	case 5: return box_at(x * x, x, 0, 0);                                         /* points */
	default: return box_at((float)(k % 2) * 1e6f, x, 1, 1);                        /* two far towers */
	}
}

/* Worst height of n items is below 2.5 log2(n) + 2: Fibonacci's argument with a tolerance of 4. */
static double height_bound(int32_t count) { return 2.5 * log2((double)count) + 2.0; }

static void t_any_order_stays_balanced(void)
{
	int32_t order, k, tallest = 0, invalid = 0;
	for (order = 0; order < 7; ++order) {
		plain_open();
		spread = 1.0f;
		for (k = 0; k < ITEMS; ++k) {
			plain_insert(k, ordered_box(order, k));
			invalid += k % 50 == 0 && !cni_tree_validate(&p.tree);
		}
		tallest = cni_max_i(tallest, cni_tree_height(&p.tree));
		printf("  order %d: height %d, cost %.3g\n", order, cni_tree_height(&p.tree), (double)cni_tree_cost(&p.tree));
		for (k = 0; k < ITEMS - 50; ++k) { /* from one end, as queues do */
			plain_remove(k);
			invalid += k % 50 == 0 && !cni_tree_validate(&p.tree);
		}
		CHECK_LE("height of the last 50", cni_tree_height(&p.tree), height_bound(50), "");
		invalid += query_differs(box_at(-10, -10, 1000, 1000));
		plain_close();
	}
	CHECK_LE("height of 2,000 items", tallest, height_bound(ITEMS), "");
	CHECK_LE("states that are not valid", invalid, 0, "");
}

/* Costs in searches must stay finite. */
static void t_huge_boxes(void)
{
	int32_t k, invalid = 0;
	plain_open();
	for (k = 0; k < 400; ++k) {
		float size = k % 3 ? 1e38f : 1.0f;
		plain_insert(k, box_at(-1.5e38f * (float)(k % 2), -1.5e38f * (float)(k % 5 == 0), size, size * ((float)(k % 7) * 0.25f)));
		invalid += !cni_tree_validate(&p.tree);
	}
	invalid += query_differs(box_at(0, 0, 1, 1)) + query_differs(box_at(-1.5e38f, -1.5e38f, 3e38f, 3e38f));
	cni_tree_rebuild(&p.tree, p.scratch);
	invalid += !cni_tree_validate(&p.tree) + query_differs(box_at(0, 0, 1, 1));
	CHECK_LE("states and answers that are wrong", invalid, 0, "");
	plain_close();
}

/* Infinite and invalid boxes among valid ones: searches still find the valid ones. */
static void t_bad_boxes_spoil_nothing(void)
{
	int32_t k, wrong = 0;
	random_state = 11;
	plain_open();
	for (k = 0; k < 600; ++k) {
		float bad = k % 9 == 0 ? NAN : INFINITY;
		plain_insert(k, k % 3 ? random_box(50.0f, 2.0f) : box_at(k % 6 ? bad : 0.0f, 0.0f, bad, k % 5 ? 1.0f : bad));
		wrong += !cni_tree_validate(&p.tree);
	}
	for (k = 0; k < 600; ++k) {
		cni_aabb box = k % 4 ? random_box(50.0f, 2.0f) : box_at(NAN, 0, 1, INFINITY);
		cni_tree_set_box(&p.tree, k, &box);
		p.boxes[k] = box;
		if (k % 50 == 0)
			cni_tree_settle(&p.tree, k % 100 ? p.scratch : NULL);
		wrong += !cni_tree_validate(&p.tree) + query_differs(random_box(50.0f, 20.0f));
	}
	for (k = 0; k < 600; ++k) {
		plain_remove(k);
		wrong += !cni_tree_validate(&p.tree);
	}
	CHECK_LE("states and answers that are wrong", wrong, 0, "");
	plain_close();
}

/* ---- quality ---- */

static void t_rebuilt_tree_is_as_low_as_can_be(void)
{
	int32_t k;
	random_state = 3;
	plain_open();
	for (k = 0; k < ITEMS; ++k)
		plain_insert(k, random_box(50.0f, 2.0f));
	printf("  inserted: height %d, cost %.2f\n", cni_tree_height(&p.tree), (double)cni_tree_cost(&p.tree));
	CHECK_LE("cost by insertion", cni_tree_cost(&p.tree), 5.5, "");
	cni_tree_rebuild(&p.tree, p.scratch);
	CHECK(cni_tree_validate(&p.tree));
	CHECK_LE("height when built anew", cni_tree_height(&p.tree), ceil(log2(ITEMS)), "");
	CHECK_LE("cost when built anew", cni_tree_cost(&p.tree), 5.5, "");
	plain_close();
}

/* Items move through each other; one item in `share` moves in a step. */
static double worst_cost(int32_t share, void *scratch)
{
	double worst = 0.0;
	int32_t step, k;
	for (step = 0; step < TEST_FORM(400, 200, 100); ++step) {
		for (k = 0; k < ITEMS; ++k) {
			cni_aabb box = p.boxes[k];
			float dx = k & 1 ? 0.1f : -0.1f, dy = k & 2 ? 0.1f : -0.1f;
			if ((k + step) % share != 0)
				continue;
			dx = box.x0 + dx > 50.0f || box.x0 + dx < -50.0f ? -50.0f * dx * 20.0f : dx;
			dy = box.y0 + dy > 50.0f || box.y0 + dy < -50.0f ? -50.0f * dy * 20.0f : dy;
			box = box_at(box.x0 + dx, box.y0 + dy, box.x1 - box.x0, box.y1 - box.y0);
			p.boxes[k] = box;
			cni_tree_set_box(&p.tree, k, &box);
		}
		cni_tree_settle(&p.tree, scratch);
		worst = greater(worst, (double)cni_tree_cost(&p.tree));
	}
	CHECK(cni_tree_validate(&p.tree));
	return worst;
}

static void t_moving_keeps_the_tree_good(void)
{
	int32_t k, run;
	for (run = 0; run < 4; ++run) {
		double fresh;
		random_state = 3;
		plain_open();
		for (k = 0; k < ITEMS; ++k)
			plain_insert(k, random_box(50.0f, 2.0f));
		cni_tree_rebuild(&p.tree, p.scratch);
		fresh = (double)cni_tree_cost(&p.tree);
		printf("  %s move, %s\n", run < 2 ? "all" : "one in ten", run % 2 ? "no scratch" : "may be built anew");
		CHECK_LE("worst cost over the fresh tree's", worst_cost(run < 2 ? 1 : 10, run % 2 ? NULL : p.scratch) / fresh, run == 1 ? 2.0 : 1.5, "");
		plain_close();
	}
}

/* ---- rays and memory ---- */

typedef struct nearest {
	cni_vec2 o, d;
	int32_t visited;
	float best;
} nearest;

static float visit_nearest(void *context, int32_t item, float limit)
{
	nearest *n = (nearest *)context;
	float t = (p.boxes[item].x0 - n->o.x) / n->d.x;
	++n->visited;
	n->best = cni_min(n->best, t);
	return cni_min(limit, t);
}

/* A row of boxes along the ray: only the nearest one has to be visited. */
static void t_rays_go_from_near_to_far(void)
{
	nearest n;
	int32_t k;
	plain_open();
	for (k = 0; k < 1000; ++k)
		plain_insert(k, box_at((float)(k * 37 % 1000) * 2.0f, 0, 1, 1));
	n.o = cni_v(-1.0f, 0.5f);
	n.d = cni_v(3000.0f, 0.0f);
	n.visited = 0;
	n.best = 2.0f;
	cni_tree_ray(&p.tree, n.o, n.d, visit_nearest, &n);
	CHECK_LE("boxes visited", n.visited, 2, "");
	CHECK_LE("error of the nearest", fabs((double)n.best - 1.0 / 3000.0), 1e-7, "");
	plain_close();
}

static void *no_memory(uint64_t bytes, uint32_t align, void *user)
{
	(void)bytes, (void)align;
	return --*(int32_t *)user < 0 ? NULL : malloc((size_t)bytes + 64);
}

static void give_back(void *memory, uint64_t bytes, void *user)
{
	(void)bytes, (void)user;
	free(memory);
}

/* A failed reserve leaves a working tree. */
static void t_reserve_fails_cleanly(void)
{
	int32_t calls, k, refused = 0;
	for (calls = 0; calls < 12; ++calls) {
		int32_t left = calls, room = 0;
		cni_memory memory;
		cni_tree tree;
		cni_memory_init_hooks(&memory, no_memory, give_back, &left);
		cni_tree_init(&tree);
		for (k = 0; k < 300; ++k) {
			cni_aabb box = box_at((float)(k % 17), (float)(k % 13), 1, 1);
			if (k >= room && !cni_tree_reserve(&tree, &memory, k + 1, 0)) {
				++refused;
				break;
			}
			cni_tree_insert(&tree, k, &box);
		}
		CHECK(cni_tree_validate(&tree) && tree.count == k);
		cni_tree_deinit(&tree, &memory);
		CHECK(memory.bytes_in_use == 0);
	}
	CHECK(refused > 3);
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(t_searches_find_what_brute_force_finds);
	RUN(t_nodes_are_reused);
	RUN(t_any_order_stays_balanced);
	RUN(t_huge_boxes);
	RUN(t_bad_boxes_spoil_nothing);
	RUN(t_rebuilt_tree_is_as_low_as_can_be);
	RUN(t_moving_keeps_the_tree_good);
	RUN(t_rays_go_from_near_to_far);
	RUN(t_reserve_fails_cleanly);
	return test_end();
}
