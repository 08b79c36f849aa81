/*
 * test/world/random_bodies.h - random shapes, bodies and static ground for tests that draw whole scenes.
 *
 * Ground fills the strip |x| <= GROUND_HALF below y = 0, up to GROUND_DEPTH deep where it has an inside.
 */
#ifndef CAIRN_TEST_RANDOM_BODIES_H
#define CAIRN_TEST_RANDOM_BODIES_H

#include "joints.h"

#define GROUND_HALF 40.0f
#define GROUND_DEPTH 4.0f

enum { GROUND_BOX, GROUND_TILES, GROUND_POLYGON, GROUND_COMPOUND, GROUND_CHAIN, GROUND_HILLS, GROUND_EDGES, GROUND_KINDS };

/* Number of a kind, 0 to count - 1. */
static inline int32_t draw_int(uint32_t *random, int32_t count)
{
	int32_t k = (int32_t)fixture_random(random, 0.0f, (float)count);
	return k < count ? k : count - 1;
}

/* The least width of a polygon across its sides. */
static inline float hull_width(const cn_polygon *hull)
{
	float least = (float)HUGE_VAL;
	int32_t k, i;
	for (k = 0; k < hull->count; ++k) {
		cn_vec2 a = hull->points_m[k], b = hull->points_m[(k + 1) % hull->count];
		float x = b.x - a.x, y = b.y - a.y, most = 0.0f;
		for (i = 0; i < hull->count; ++i)
			most = fmaxf(most, fabsf(x * (hull->points_m[i].y - a.y) - y * (hull->points_m[i].x - a.x)) / hypotf(x, y));
		least = fminf(least, most);
	}
	return least;
}

/* The convex hull of random points, rounded in every third case. A hull that is thinner than a tenth of its size becomes a box. */
static inline void draw_hull(cn_world *world, uint32_t *random, const cn_shape_def *def, float size)
{
	int32_t count = 3 + draw_int(random, 6), k;
	float radius = draw_int(random, 3) == 0 ? 0.1f * size : 0.0f;
	cn_vec2 points[8];
	cn_polygon hull;
	for (k = 0; k < count; ++k) {
		points[k].x = fixture_random(random, -size, size);
		points[k].y = fixture_random(random, -size, size);
	}
	if (cn_polygon_make_hull(points, count, radius, &hull) != CN_OK || hull_width(&hull) < 0.1f * size || cn_shape_create_polygon(world, def, &hull, NULL) != CN_OK)
		fixture_box_shape(world, def, size, 0.5f * size);
}

/* Circle, capsule, box or polygon with a radius of about size. */
static inline void draw_shape(cn_world *world, uint32_t *random, const cn_shape_def *def, float size)
{
	float thin = fixture_random(random, 0.25f, 1.0f);
	cn_circle circle = { { 0.0f, 0.0f }, 0.0f };
	cn_capsule capsule = { { 0.0f, 0.0f }, { 0.0f, 0.0f }, 0.0f };
	switch (draw_int(random, 4)) {
	case 0:
		circle.radius_m = size;
		must(cn_shape_create_circle(world, def, &circle, NULL), world, "cn_shape_create_circle");
		break;
	case 1:
		capsule.b_m.x = size * (1.0f - 0.5f * thin);
		capsule.a_m.x = -capsule.b_m.x;
		capsule.radius_m = 0.5f * size * thin;
		must(cn_shape_create_capsule(world, def, &capsule, NULL), world, "cn_shape_create_capsule");
		break;
	case 2:
		fixture_box_shape(world, def, size, size * thin);
		break;
	default:
		draw_hull(world, random, def, size);
	}
}

/* A dynamic body of one shape or, in one of four, of two or three shapes that overlap. */
static inline cn_body draw_body(cn_world *world, uint32_t *random, float x, float y, float size, float friction, float restitution)
{
	float angle = fixture_random(random, -3.1f, 3.1f);
	cn_body body = fixture_body(world, CN_BODY_DYNAMIC, x, y, angle);
	cn_shape_def def = fixture_shape_def(body, friction, restitution);
	int32_t shapes = draw_int(random, 4) == 0 ? 2 + draw_int(random, 2) : 1, k;
	for (k = 0; k < shapes; ++k) {
		draw_shape(world, random, &def, shapes == 1 ? size : 0.6f * size);
		def.offset_m.x = fixture_random(random, -0.6f, 0.6f) * size;
		def.offset_m.y = fixture_random(random, -0.6f, 0.6f) * size;
	}
	return body;
}

static inline void ground_chain(cn_world *world, uint32_t *random, const cn_shape_def *def, float bump)
{
	cn_vec2 points[33];
	cn_chain chain = { NULL, 33, 0 };
	int32_t k;
	for (k = 0; k < 33; ++k)
		points[k] = at(GROUND_HALF - (float)k * GROUND_HALF / 16.0f, -fixture_random(random, 0.0f, bump));
	chain.points_m = points;
	must(cn_shape_create_chain(world, def, &chain, NULL), world, "cn_shape_create_chain");
}

static inline void ground_edges(cn_world *world, const cn_shape_def *def)
{
	int32_t k;
	for (k = 0; k < 16; ++k) {
		cn_edge edge = { { (float)k * 5.0f - GROUND_HALF, 0.0f }, { (float)(k + 1) * 5.0f - GROUND_HALF, 0.0f } };
		must(cn_shape_create_edge(world, def, &edge, NULL), world, "cn_shape_create_edge");
	}
}

/* Flush tiles, of one body each or of one body. */
static inline void ground_tiles(cn_world *world, float friction, int32_t one_body)
{
	cn_shape_def def = fixture_shape_def(0, friction, 0.0f);
	int32_t k;
	for (k = 0; k < 40; ++k) {
		float x = 2.0f * (float)k - GROUND_HALF + 1.0f;
		if (k == 0 || !one_body)
			def.body = fixture_body(world, CN_BODY_STATIC, one_body ? 0.0f : x, -0.5f * GROUND_DEPTH, 0.0f);
		def.offset_m.x = one_body ? x : 0.0f;
		fixture_box_shape(world, &def, 1.0f, 0.5f * GROUND_DEPTH);
	}
}

static inline void ground_polygon(cn_world *world, const cn_shape_def *def)
{
	static const cn_vec2 points[6] = { { GROUND_HALF, 0.0f }, { -GROUND_HALF, 0.0f }, { -GROUND_HALF - 2.0f, -1.0f }, { -GROUND_HALF, -GROUND_DEPTH },
		{ GROUND_HALF, -GROUND_DEPTH }, { GROUND_HALF + 2.0f, -1.0f } };
	cn_polygon hull;
	must(cn_polygon_make_hull(points, 6, 0.0f, &hull), world, "cn_polygon_make_hull");
	must(cn_shape_create_polygon(world, def, &hull, NULL), world, "cn_shape_create_polygon");
}

/* Static ground of a kind; hills go down to -1 m. */
static inline void draw_ground(cn_world *world, uint32_t *random, int32_t kind, float friction)
{
	cn_shape_def def;
	if (kind == GROUND_TILES || kind == GROUND_COMPOUND) {
		ground_tiles(world, friction, kind == GROUND_COMPOUND);
		return;
	}
	def = fixture_shape_def(fixture_body(world, CN_BODY_STATIC, 0.0f, 0.0f, 0.0f), friction, 0.0f);
	if (kind == GROUND_CHAIN || kind == GROUND_HILLS) {
		ground_chain(world, random, &def, kind == GROUND_HILLS ? 1.0f : 0.0f);
	} else if (kind == GROUND_EDGES) {
		ground_edges(world, &def);
	} else if (kind == GROUND_POLYGON) {
		ground_polygon(world, &def);
	} else {
		def.offset_m.y = -0.5f * GROUND_DEPTH;
		fixture_box_shape(world, &def, GROUND_HALF, 0.5f * GROUND_DEPTH);
	}
}

#endif
