/*
 * test/query/movers.h - what the mover's tests share: a world, a mover in it, walking, plain ground and tiles.
 */
#ifndef CAIRN_TEST_MOVERS_H
#define CAIRN_TEST_MOVERS_H

#include "world/fixture.h"

#define FEET 0.8 /* of the default capsule below its position */
#define RADIUS 0.3

static cn_world *w;
static cn_mover_def md;
static cn_mover mover;

static inline void begin(float x, float y)
{
	w = fixture_world(-10.0f, 1);
	cn_mover_def_init(&md);
	memset(&mover, 0, sizeof mover);
	mover.position_m.x = x;
	mover.position_m.y = y;
}

static inline void move(void) { must(cn_mover_move(w, &md, FRAME_S, &mover), w, "cn_mover_move"); }

/* Steps of the world and the mover, which wants to walk so fast. */
static inline void walk(float speed, int32_t frames)
{
	int32_t k;
	for (k = 0; k < frames; ++k) {
		fixture_step(w, 1);
		mover.velocity_mps.x = speed;
		move();
	}
}

static inline int on_ground(void) { return (mover.flags & CN_MOVER_ON_GROUND) != 0; }
static inline double feet(void) { return (double)mover.position_m.y - FEET; }

static inline cn_body box(float x, float y, float hx, float hy, float angle)
{
	return fixture_box(w, CN_BODY_STATIC, x, y, angle, hx, hy, 0.6f, 0.0f);
}

static inline void ground(void) { box(0.0f, -1.0f, 100.0f, 1.0f, 0.0f); }

/* 40 m of ground from x = -5: boxes, edges or a chain. */
static inline void tiles(int32_t kind)
{
	cn_vec2 points[41];
	cn_chain chain = { points, 41, 0 };
	cn_shape_def sd;
	int32_t k;
	for (k = 0; k < 40; ++k) {
		float x = (float)k - 5.0f;
		cn_edge edge = { { 0.0f, 0.0f }, { 0.0f, 0.0f } };
		edge.a_m.x = x;
		edge.b_m.x = x + 1.0f;
		points[k].x = 35.0f - (float)k;
		points[k].y = 0.0f;
		if (kind == 0)
			box(x + 0.5f, -0.5f, 0.5f, 0.5f, 0.0f);
		if (kind == 1) {
			sd = fixture_shape_def(fixture_body(w, CN_BODY_STATIC, 0.0f, 0.0f, 0.0f), 0.6f, 0.0f);
			must(cn_shape_create_edge(w, &sd, &edge, NULL), w, "edge");
		}
	}
	points[40].x = -5.0f;
	points[40].y = 0.0f;
	if (kind == 2) {
		sd = fixture_shape_def(fixture_body(w, CN_BODY_STATIC, 0.0f, 0.0f, 0.0f), 0.6f, 0.0f);
		must(cn_shape_create_chain(w, &sd, &chain, NULL), w, "chain");
	}
}

#endif
