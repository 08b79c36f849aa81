/*
 * manifold_time_test.c - prints what a manifold costs. Not a bound on time: it fails only when the pairs do
 * not touch as they should.
 */
#include "geometry/shapes.h"
#include "test.h"
#include <time.h>

#define PAIRS 1024
#define ROUNDS 400

static record shapes[PAIRS];
static cni_transform poses[PAIRS];
static cni_manifold_cache caches[PAIRS];
static float checksum;

static void measure(const char *what, const cni_geometry *a, float gap, float jitter, int32_t expected)
{
	int32_t points = 0;
	for (int32_t i = 0; i < PAIRS; ++i) {
		poses[i] = transform_make(random_in(-0.3f, 0.3f), 1.0f + gap + random_in(-jitter, jitter), random_in(-0.002f, 0.002f));
		caches[i].axis = 0;
	}
	clock_t start = clock();
	for (int32_t round = 0; round < ROUNDS; ++round)
		for (int32_t i = 0; i < PAIRS; ++i) {
			cni_manifold_input in = { a, &shapes[i].g, 0, 0, poses[i], 0.02f, SLOP };
			cni_manifold m;
			cni_manifold_function(a->type, shapes[i].g.type)(&in, &caches[i], &m);
			points += m.count;
			checksum += m.count > 0 ? m.points[0].separation : 0.0f;
		}
	double ns = 1e9 * (double)(clock() - start) / (double)CLOCKS_PER_SEC / (double)(PAIRS * ROUNDS);
	printf("  %s: %.1f ns\n", what, ns);
	CHECK(points == expected * PAIRS * ROUNDS);
}

static void t_box_on_box(void)
{
	record box;
	record_box(&box, 0.5f, 0.5f, 0.0f, transform_none());
	for (int32_t i = 0; i < PAIRS; ++i)
		record_box(&shapes[i], 0.5f, 0.5f, 0.0f, transform_none());
	measure("box on box, touching", &box.g, -0.004f, 0.001f, 2);
	measure("box over box, apart", &box.g, 0.1f, 0.01f, 0);
	for (int32_t i = 0; i < PAIRS; ++i)
		record_box(&shapes[i], 0.45f, 0.45f, 0.05f, transform_none());
	record_box(&box, 0.45f, 0.45f, 0.05f, transform_none());
	measure("rounded box on rounded box, touching", &box.g, -0.004f, 0.001f, 2);
}

static void t_others(void)
{
	record circle;
	record_circle(&circle, 0.5f);
	for (int32_t i = 0; i < PAIRS; ++i)
		record_circle(&shapes[i], 0.6f);
	measure("circle on circle, touching", &circle.g, -0.1f, 0.001f, 1);
	for (int32_t i = 0; i < PAIRS; ++i)
		record_box(&shapes[i], 0.5f, 0.5f, 0.0f, transform_none());
	measure("circle on box, touching", &circle.g, -0.004f, 0.001f, 1);
	cni_vec2 points[2] = { { 3, -0.5f }, { -3, -0.5f } };
	cn_chain chain = { points, 2, 0 };
	for (int32_t i = 0; i < PAIRS; ++i)
		cni_geometry_chain(&shapes[i].g, &chain, transform_make(0, 0, 3.14159265f));
	record box;
	record_box(&box, 0.5f, 0.5f, 0.0f, transform_none());
	cni_vec2 below[2] = { { 3, -1.5f }, { -3, -1.5f } };
	chain.points_m = below;
	for (int32_t i = 0; i < PAIRS; ++i)
		cni_geometry_chain(&shapes[i].g, &chain, transform_none());
	measure("box on chain edge, touching", &box.g, -0.004f, 0.001f, 2);
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(t_box_on_box);
	RUN(t_others);
	CHECK(checksum == checksum);
	return test_end();
}
