/*
 * test/world/heaps.h - heaps of balls, boxes and sticks that fall into a round bowl.
 */
#ifndef CAIRN_TEST_HEAPS_H
#define CAIRN_TEST_HEAPS_H

#include "fixture.h"

#define HEAP_PI 3.14159265358979323846
#define HEAP_BOWL_EDGES 12

static inline void heap_bowl(cn_world *world)
{
	cn_shape_def def = fixture_shape_def(fixture_body(world, CN_BODY_STATIC, 0.0f, 0.0f, 0.0f), 0.6f, 0.0f);
	int32_t k;
	for (k = 0; k < HEAP_BOWL_EDGES; ++k) {
		double from = HEAP_PI * (1.0 + (double)k / HEAP_BOWL_EDGES), to = HEAP_PI * (1.0 + (double)(k + 1) / HEAP_BOWL_EDGES);
		cn_edge edge = { { (float)(5.0 * cos(from)), (float)(5.0 + 5.0 * sin(from)) }, { (float)(5.0 * cos(to)), (float)(5.0 + 5.0 * sin(to)) } };
		must(cn_shape_create_edge(world, &def, &edge, NULL), world, "cn_shape_create_edge");
	}
}

/* Bodies of half a metre, five in a row, each moved aside a little. */
static inline void heap_drop(cn_world *world, uint32_t seed, cn_body *bodies, int32_t count)
{
	static const cn_capsule stick = { { -0.15f, 0.0f }, { 0.15f, 0.0f }, 0.2f };
	uint32_t random = seed * 2654435761u + 1u;
	int32_t k;
	for (k = 0; k < count; ++k) {
		float x = -1.5f + 0.7f * (float)(k % 5) + fixture_random(&random, 0.0f, 0.1f), y = 6.0f + 0.7f * (float)(k / 5);
		if (k % 3 == 0) {
			bodies[k] = fixture_circle(world, CN_BODY_DYNAMIC, x, y, 0.25f, 0.6f, 0.0f);
		} else if (k % 3 == 1) {
			bodies[k] = fixture_box(world, CN_BODY_DYNAMIC, x, y, 0.0f, 0.25f, 0.25f, 0.6f, 0.0f);
		} else {
			cn_shape_def def = fixture_shape_def(bodies[k] = fixture_body(world, CN_BODY_DYNAMIC, x, y, 0.0f), 0.6f, 0.0f);
			must(cn_shape_create_capsule(world, &def, &stick, NULL), world, "cn_shape_create_capsule");
		}
	}
}

static inline double heap_speed(const cn_world *world, const cn_body *bodies, int32_t count)
{
	double most = 0.0;
	int32_t k;
	for (k = 0; k < count; ++k) {
		cn_velocity v = fixture_velocity(world, bodies[k]);
		most = fmax(most, hypot((double)v.linear_mps.x, (double)v.linear_mps.y));
	}
	return most;
}

#endif
