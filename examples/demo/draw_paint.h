/*
 * examples/demo/draw_paint.h - what the files that draw a world share: where they paint, and the way
 * from the world to the picture.
 */
#ifndef CAIRN_DEMO_DRAW_PAINT_H
#define CAIRN_DEMO_DRAW_PAINT_H

#include "demo/draw.h"

typedef struct painter {
	canvas *c;
	const draw_view *view;
	const cn_world *world;
	cn_pose pose;        /* of the body that is being drawn */
	canvas_color fill;
	canvas_color outline;
	uint32_t show;
	int32_t *groups;     /* by slot of a body: its island, or its tier; -1 for none. NULL: not shown */
} painter;

#define DRAW_SLOT(body) ((body) & 0xFFFFFu)

canvas_point draw_to_picture(const painter *p, cn_vec2 point_m);
/* Radius in pixels of a dot small enough not to hide what it marks. */
float draw_dot_px(const painter *p);

/* Anchors, axes and limits of all joints, and of constraints on one body. 0 when there is no memory. */
int32_t draw_joints(painter *p);
int32_t draw_constraints(painter *p);

/* Fills p->groups for DRAW_SHOW_ISLANDS or _TIERS; free() it. 0 when there is no memory. */
int32_t draw_find_groups(painter *p);

#endif
