/*
 * examples/demo/draw.h - a world as a picture, through the public API alone.
 *
 * Colours tell static, kinematic, awake and asleep apart, or bodies from each other, or their islands or solver tiers; circles carry a mark that shows their
 * rotation; contact points are dots with their normals, joints are dots with lines from the bodies whose
 * shapes do not reach them, axes and limits are lines and rays with marks at their ends; sensors are outlines,
 * one-way shapes have an arrow to their solid side; the solid side of a chain is shaded.
 */
#ifndef CAIRN_DEMO_DRAW_H
#define CAIRN_DEMO_DRAW_H

#include "cairn.h"
#include "demo/canvas.h"

enum {
	DRAW_BACKGROUND, DRAW_OUTLINE, DRAW_STATIC, DRAW_SOLID_SIDE, DRAW_KINEMATIC, DRAW_AWAKE, DRAW_ASLEEP,
	DRAW_CONTACT, DRAW_JOINT, DRAW_LIMIT, DRAW_SENSOR, DRAW_BODY, DRAW_COLORS = DRAW_BODY + 8
};
extern const canvas_color draw_colors[DRAW_COLORS];

typedef struct draw_view {
	cn_vec2 lower_m; /* world point at the picture's lower left corner */
	float scale;     /* pixels a metre */
} draw_view;

/* The view that shows a box of the world in the whole width of the canvas. */
draw_view draw_fit(const canvas *c, const cn_aabb *box_m);
/* What draw_world shows beside shapes. */
enum {
	DRAW_SHOW_CONTACTS = 1u << 0,
	DRAW_SHOW_JOINTS = 1u << 1,
	DRAW_SHOW_BOXES = 1u << 2,   /* AABBs of shapes */
	DRAW_SHOW_BODIES = 1u << 3,  /* a colour for each body, paler asleep */
	DRAW_SHOW_ISLANDS = 1u << 4, /* for each awake island */
	DRAW_SHOW_TIERS = 1u << 5    /* for each solver tier: CN_TIER_* */
};
/* Clears the canvas and draws. 0 when there is no memory for lists. */
int32_t draw_world(canvas *c, const draw_view *view, const cn_world *world, uint32_t show);

#endif
