/*
 * manifold_boxes_test.c - pairs of boxes in batches have the manifolds of one by one, to the last bit, whatever
 * the width, the cached axis and the company in the batch.
 */
#include "base/cpu.h"
#include "geometry/manifold_boxes.h"
#include "geometry/manifold_table.h"
#include "shapes.h"
#include "test.h"

#define ROUNDS 4000
#define MARGIN 0.02f

typedef struct pair {
	record a, b;
	cni_manifold_input in;
	cni_manifold_cache cache;
} pair;

/* A box of any shape up to ten to one; one in three is rounded, two in three are of one size as in stacks. */
static void box_random(record *out, float size)
{
	float half_x = random_below(3) ? size : size * random_in(0.1f, 1.0f), half_y = random_below(3) ? size : size * random_in(0.1f, 1.0f);
	float radius = random_below(3) == 0 ? 0.1f * size : 0.0f, shift = random_in(-0.1f, 0.1f) * size;
	float turn = random_below(2) ? 0.0f : random_in(-3.0f, 3.0f);
	record_box(out, half_x, half_y, radius, transform_make(shift, 0.0f, turn));
}

/* Half of the pairs are within a few margins of touching, half of those lie flat on each other. */
static void pair_random(pair *p)
{
	float size = random_below(2) ? 0.5f : random_in(0.05f, 5.0f), angle = random_in(-3.2f, 3.2f), way;
	box_random(&p->a, size);
	box_random(&p->b, size);
	if (random_below(2)) {
		angle = 1.57079633f * (float)random_below(4);
		angle += random_below(2) ? random_in(-1e-3f, 1e-3f) : 0.0f;
	}
	way = random_in(-3.2f, 3.2f);
	p->in.b_in_a = transform_make(2.5f * size * (float)cos((double)way), 2.5f * size * (float)sin((double)way), angle);
	if (random_below(4)) {
		double s = reference_separation(&p->a.g, &p->b.g, p->in.b_in_a);
		cni_vec2 apart = cni_sub(cni_transform_point(p->in.b_in_a, p->b.g.centroid), p->a.g.centroid);
		p->in.b_in_a.t = cni_madd(p->in.b_in_a.t, random_in(-2.0f, 2.0f) * MARGIN - (float)s, cni_normalize(apart));
	}
	p->in.a = &p->a.g;
	p->in.b = &p->b.g;
	p->in.child_a = p->in.child_b = 0;
	p->in.margin = random_below(4) ? MARGIN : random_in(0.0f, 0.5f);
	p->in.slop = SLOP;
	memset(&p->cache, 0, sizeof p->cache);
	if (random_below(3)) {
		p->cache.axis = (uint8_t)(1 + random_below(4));
		p->cache.axis = (uint8_t)(p->cache.axis + (random_below(2) ? CN_POLYGON_MAX_VERTICES : 0));
	}
}

static int32_t same_bits(const void *a, const void *b, size_t bytes) { return memcmp(a, b, bytes) == 0; }

/* -0 and 0 count as different. */
static int32_t same_manifold(const cni_manifold *a, const cni_manifold *b)
{
	if (a->count != b->count)
		return 0;
	if (a->count == 0)
		return 1;
	return same_bits(&a->normal, &b->normal, sizeof a->normal) && same_bits(a->points, b->points, (size_t)a->count * sizeof a->points[0]);
}

typedef struct tally {
	int32_t wrong, apart, manifolds, left, pairs;
} tally;

static void batch_compare(pair *pairs, int32_t count, cni_box_kernel_fn *kernel, tally *t)
{
	cni_box_batch batch;
	batch.count = 0;
	for (int32_t k = 0; k < count; ++k)
		cni_boxes_add(&batch, &pairs[k].in, &pairs[k].cache);
	cni_boxes_run(&batch, kernel);
	for (int32_t k = 0; k < count; ++k) {
		cni_manifold_cache cache = pairs[k].cache, cache_one = pairs[k].cache;
		cni_manifold together, one;
		cni_boxes_read(&batch, k, &pairs[k].in, &cache, &together);
		cni_collide_polygons(&pairs[k].in, &cache_one, &one);
		t->wrong += !same_manifold(&together, &one) || cache.axis != cache_one.axis;
		t->apart += batch.state[k] == CNI_BOXES_APART;
		t->manifolds += batch.state[k] == CNI_BOXES_MANIFOLD;
		t->left += batch.state[k] == CNI_BOXES_LEFT;
		++t->pairs;
	}
}

static void kernel_compare(cni_box_kernel_fn *kernel)
{
	static pair pairs[CNI_BOX_PAIRS];
	tally t = { 0, 0, 0, 0, 0 };
	random_state = 20u;
	for (int32_t round = 0; round < ROUNDS; ++round) {
		int32_t count = 1 + random_below(CNI_BOX_PAIRS);
		for (int32_t k = 0; k < count; ++k)
			pair_random(&pairs[k]);
		batch_compare(pairs, count, kernel, &t);
	}
	printf("  of %d pairs: %d apart, %d with a manifold, %d left\n", (int)t.pairs, (int)t.apart, (int)t.manifolds, (int)t.left);
	CHECK_LE("pairs that differ", (double)t.wrong, 0.0, "");
	CHECK_GE("share of pairs with a manifold", (double)t.manifolds / (double)t.pairs, 0.2, "");
	CHECK_GE("share of pairs apart", (double)t.apart / (double)t.pairs, 0.1, "");
	CHECK_GE("pairs left to the general way", (double)t.left, 1.0, "");
}

static void t_widest_kernel_has_the_bits_of_one_by_one(void)
{
	if (cni_box_kernel_choose() == NULL)
		SKIP("no vectors on this target");
	kernel_compare(cni_box_kernel_choose());
}

static void t_four_wide_kernel_has_the_bits_of_one_by_one(void)
{
#if CNI_HAS_WIDE_4
	kernel_compare(cni_box_kernel_4);
#else
	SKIP("no vectors on this target");
#endif
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(t_widest_kernel_has_the_bits_of_one_by_one);
	RUN(t_four_wide_kernel_has_the_bits_of_one_by_one);
	return test_end();
}
