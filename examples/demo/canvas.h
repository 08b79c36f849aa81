/*
 * examples/demo/canvas.h - a small anti-aliased software rasteriser for convex shapes.
 *
 * Every primitive is a signed distance d to its border in pixels, negative inside; a pixel is covered
 * by clamp(1/2 - d, 0, 1) of it, which is exact for a straight border through a pixel along an axis and
 * close for the rest. Filling, outlining and rounding all come from the same distance.
 */
#ifndef CAIRN_DEMO_CANVAS_H
#define CAIRN_DEMO_CANVAS_H

#include <stdint.h>

#define CANVAS_POLYGON_MAX 16

/* 0xRRGGBB */
typedef uint32_t canvas_color;

typedef struct canvas_point {
	float x, y; /* pixels, y down, (0, 0) is the corner of the first pixel */
} canvas_point;

typedef struct canvas {
	int32_t width;
	int32_t height;
	uint8_t *rgb; /* width * height * 3, rows from the top */
} canvas;

/* 0 when there is no memory. */
int32_t canvas_open(canvas *c, int32_t width, int32_t height);
void canvas_close(canvas *c);
void canvas_clear(canvas *c, canvas_color color);
/* Whole pixels, y down; what lies outside is left out. */
void canvas_rect(canvas *c, int32_t x, int32_t y, int32_t width, int32_t height, canvas_color color);
/* outline_px is the width of a border of outline color inside of the shape, 0 for none. */
void canvas_disc(canvas *c, canvas_point center, float radius, canvas_color fill, canvas_color outline, float outline_px);
/* A segment with round ends. */
void canvas_capsule(canvas *c, canvas_point a, canvas_point b, float radius, canvas_color fill, canvas_color outline, float outline_px);
/* Convex, either winding, 3 to CANVAS_POLYGON_MAX points, grown by radius on all sides. */
void canvas_polygon(canvas *c, const canvas_point *points, int32_t count, float radius, canvas_color fill, canvas_color outline, float outline_px);
void canvas_line(canvas *c, canvas_point a, canvas_point b, float width, canvas_color color);

#endif
