/*
 * test/collision/manifold_batch_test.c - pairs in a batch (polygons, capsules, edges) have the same bits
 * as pairs one by one, for any width, any cached axis and any other pairs in the batch.
 */
#include "base/cpu.h"
#include "collision/manifold_batch.h"
#include "geometry/shapes.h"
#include "test.h"

#define ROUNDS TEST_SAMPLES(10000)
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

/* Random, but of few sizes: many pairs are parallel, of equal length, or have coinciding corners. */
static void segment_random(record *out, int32_t type, float size)
{
	float half = random_below(3) ? size : size * random_in(0.001f, 1.0f), turn = random_below(2) ? 0.0f : random_in(-3.0f, 3.0f);
	cni_transform offset = transform_make(random_in(-0.1f, 0.1f) * size, 0.0f, turn);
	cn_capsule capsule = { { -half, 0.0f }, { half, 0.0f }, random_in(0.05f, 0.5f) * size };
	cn_edge edge = { { -half, 0.0f }, { half, 0.0f } };
	if (type == CN_SHAPE_CAPSULE)
		cni_geometry_capsule(&out->g, &capsule, offset);
	else
		cni_geometry_edge(&out->g, &edge, offset);
}

static void triangle_random(record *out, float size)
{
	cn_polygon p = { 3, random_below(3) == 0 ? 0.1f * size : 0.0f, { { -size, -size }, { size, -size }, { random_in(-1.0f, 1.0f) * size, size } } };
	cni_geometry_polygon(&out->g, &p, transform_make(0.0f, 0.0f, random_in(-3.0f, 3.0f)));
}

/* Regular or nearly so: 5 to 8 corners, rarely up to 16. */
static void polygon_random(record *out, float size)
{
	cn_polygon p;
	float turn = random_below(2) ? 0.0f : random_in(-3.0f, 3.0f), unequal = random_below(2) ? 0.0f : 0.3f;
	memset(&p, 0, sizeof p);
	p.count = random_below(8) ? 5 + random_below(4) : 9 + random_below(8);
	p.radius_m = random_below(3) == 0 ? 0.1f * size : 0.0f;
	for (int32_t i = 0; i < p.count; ++i) {
		double angle = 6.283185307179586 * ((double)i + (double)random_in(-unequal, unequal)) / (double)p.count;
		p.points_m[i] = cni_v(size * (float)cos(angle), size * (float)sin(angle));
	}
	cni_geometry_polygon(&out->g, &p, transform_make(0.1f * size, 0.0f, turn));
}

/* few: at most four corners; of these half are boxes. */
static void shape_random(record *out, float size, int32_t few)
{
	if (!few && random_below(2)) {
		polygon_random(out, size);
		return;
	}
	switch (random_below(6)) {
	case 0: segment_random(out, CN_SHAPE_CAPSULE, size); break;
	case 1: segment_random(out, CN_SHAPE_EDGE, size); break;
	case 2: triangle_random(out, size); break;
	default: box_random(out, size); break;
	}
}

/* Half of the pairs are within a few margins of touching, half of those lie flat on each other. */
static void pair_random(pair *p, int32_t few)
{
	float size = random_below(2) ? 0.5f : random_in(0.05f, 5.0f), angle = random_in(-3.2f, 3.2f), way;
	record *first = &p->a, *second = &p->b;
	if (random_below(20) == 0)
		size = random_below(2) ? 1.0e-3f : 1.0e4f;
	shape_random(first, size, few);
	shape_random(second, size, few);
	if (random_below(10) == 0)
		*second = *first;
	if (first->g.type > second->g.type) {
		record other = *first;
		*first = *second;
		*second = other;
	}
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
	if (random_below(30) == 0)
		p->in.b_in_a.t = cni_v(0.0f, 0.0f);
	p->in.a = &p->a.g;
	p->in.b = &p->b.g;
	p->in.child_a = p->in.child_b = 0;
	p->in.margin = random_below(4) ? MARGIN : random_in(0.0f, 0.5f);
	p->in.slop = SLOP;
	memset(&p->cache, 0, sizeof p->cache);
	if (random_below(3)) {
		p->cache.axis = (uint8_t)(1 + random_below(random_below(2) ? 4 : CN_POLYGON_MAX_VERTICES));
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
	int32_t wrong, apart, corners, faces, left, many, pairs; /* many: corners, more than four */
} tally;

static void batch_compare(pair *pairs, int32_t count, cni_batch_kernel_fn *kernel, tally *t)
{
	cni_manifold_batch batch;
	batch.count = 0;
	for (int32_t k = 0; k < count; ++k)
		cni_batch_add(&batch, &pairs[k].in, &pairs[k].cache);
	cni_batch_run(&batch, kernel);
	for (int32_t k = 0; k < count; ++k) {
		cni_manifold_cache cache = pairs[k].cache, cache_one = pairs[k].cache;
		cni_manifold together, one;
		cni_batch_read(&batch, k, &pairs[k].in, &cache, &together);
		cni_manifold_function(pairs[k].a.g.type, pairs[k].b.g.type)(&pairs[k].in, &cache_one, &one);
		t->wrong += !same_manifold(&together, &one) || cache.axis != cache_one.axis;
		t->apart += batch.state[k] == CNI_BATCH_APART;
		t->corners += batch.state[k] == CNI_BATCH_POINT && together.count == 1;
		t->faces += batch.state[k] == CNI_BATCH_POINTS;
		t->left += batch.state[k] == CNI_BATCH_FALLBACK;
		t->many += pairs[k].a.g.count > 4 || pairs[k].b.g.count > 4;
		++t->pairs;
	}
}

static void kernel_compare(cni_batch_kernel_fn *kernel)
{
	static pair pairs[CNI_BATCH_PAIRS];
	tally t = { 0, 0, 0, 0, 0, 0, 0 };
	random_state = 20u;
	for (int32_t round = 0; round < ROUNDS; ++round) {
		int32_t count = 1 + random_below(CNI_BATCH_PAIRS), few = random_below(2); /* groups of few corners have code of their own */
		for (int32_t k = 0; k < count; ++k)
			pair_random(&pairs[k], few || random_below(3) == 0);
		batch_compare(pairs, count, kernel, &t);
	}
	printf("  of %d pairs: %d apart, %d by faces, %d by corners, %d left\n", (int)t.pairs, (int)t.apart, (int)t.faces, (int)t.corners, (int)t.left);
	CHECK_LE("pairs that differ", (double)t.wrong, 0.0, "");
	CHECK_GE("share of pairs by faces", (double)t.faces / (double)t.pairs, 0.2, "");
	CHECK_GE("share of pairs by corners", (double)t.corners / (double)t.pairs, 0.02, "");
	CHECK_GE("share of pairs with more than four corners", (double)t.many / (double)t.pairs, 0.1, "");
	CHECK_GE("share of pairs apart", (double)t.apart / (double)t.pairs, 0.1, "");
	CHECK_GE("pairs left to the general way", (double)t.left, 1.0, "");
}

static void t_widest_kernel_has_the_bits_of_one_by_one(void)
{
	if (cni_batch_kernel_choose() == NULL)
		SKIP("no vectors on this target");
	kernel_compare(cni_batch_kernel_choose());
}

static void t_four_wide_kernel_has_the_bits_of_one_by_one(void)
{
#if CNI_HAS_WIDE_4
	kernel_compare(cni_batch_kernel_4);
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
