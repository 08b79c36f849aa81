/*
 * examples/demo/canvas.c - signed distances, coverage and blending. Distances after Inigo Quilez,
 * "2D distance functions" (2018): segment and convex polygon, written from their geometry.
 */
#include "demo/canvas.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct primitive {
	int32_t count; /* 1: disc, 2: capsule, more: polygon */
	canvas_point points[CANVAS_POLYGON_MAX];
	canvas_point normals[CANVAS_POLYGON_MAX]; /* outward, polygon only */
	float radius;
} primitive;

int32_t canvas_open(canvas *c, int32_t width, int32_t height)
{
	c->width = width;
	c->height = height;
	c->rgb = (uint8_t *)malloc((size_t)width * (size_t)height * 3);
	return c->rgb != NULL;
}

void canvas_close(canvas *c)
{
	free(c->rgb);
	c->rgb = NULL;
}

void canvas_rect(canvas *c, int32_t x, int32_t y, int32_t width, int32_t height, canvas_color color)
{
	int32_t x0 = x < 0 ? 0 : x, x1 = x + width < c->width ? x + width : c->width;
	int32_t y0 = y < 0 ? 0 : y, y1 = y + height < c->height ? y + height : c->height;
	if (x0 >= x1 || y0 >= y1)
		return;
	const size_t row_bytes = 3 * (size_t)c->width;
	uint8_t *first = c->rgb + row_bytes * (size_t)y0 + 3 * (size_t)x0;
	for (int32_t i = 0; i < x1 - x0; ++i) {
		first[3 * i] = (uint8_t)(color >> 16);
		first[3 * i + 1] = (uint8_t)(color >> 8);
		first[3 * i + 2] = (uint8_t)color;
	}
	for (int32_t row = y0 + 1; row < y1; ++row)
		memcpy(first + row_bytes * (size_t)(row - y0), first, 3 * (size_t)(x1 - x0));
}

void canvas_clear(canvas *c, canvas_color color) { canvas_rect(c, 0, 0, c->width, c->height, color); }

/* ------------------------------------------------------------------ distance */

static float segment_distance(canvas_point p, canvas_point a, canvas_point b)
{
	float ex = b.x - a.x, ey = b.y - a.y, dx = p.x - a.x, dy = p.y - a.y;
	float length_sq = ex * ex + ey * ey;
	float t = length_sq > 0.0f ? (dx * ex + dy * ey) / length_sq : 0.0f;
	t = t < 0.0f ? 0.0f : (t > 1.0f ? 1.0f : t);
	dx -= t * ex;
	dy -= t * ey;
	return sqrtf(dx * dx + dy * dy);
}

static float polygon_distance(const primitive *s, canvas_point p)
{
	float deepest = -1.0e9f;
	for (int32_t i = 0; i < s->count; ++i) {
		float d = (p.x - s->points[i].x) * s->normals[i].x + (p.y - s->points[i].y) * s->normals[i].y;
		deepest = d > deepest ? d : deepest;
	}
	if (deepest <= 0.0f || s->radius <= 0.0f)
		return deepest;
	float nearest = 1.0e9f;
	for (int32_t i = 0; i < s->count; ++i) {
		float d = segment_distance(p, s->points[i], s->points[i + 1 < s->count ? i + 1 : 0]);
		nearest = d < nearest ? d : nearest;
	}
	return nearest;
}

static float primitive_distance(const primitive *s, canvas_point p)
{
	if (s->count > 2)
		return polygon_distance(s, p) - s->radius;
	return segment_distance(p, s->points[0], s->points[s->count - 1]) - s->radius;
}

/* ------------------------------------------------------------------ pixels */

static float unit_clamp(float x) { return x < 0.0f ? 0.0f : (x > 1.0f ? 1.0f : x); }

static void blend_channel(uint8_t *channel, uint32_t value, float cover)
{
	float old = (float)*channel;
	*channel = (uint8_t)(old + cover * ((float)(value & 255u) - old) + 0.5f);
}

static void blend(uint8_t *pixel, canvas_color color, float cover)
{
	blend_channel(pixel, color >> 16, cover);
	blend_channel(pixel + 1, color >> 8, cover);
	blend_channel(pixel + 2, color, cover);
}

typedef struct pixel_box {
	int32_t x0, y0, x1, y1;
} pixel_box;

static int32_t pixel_clamp(float x, int32_t limit) { return x < 0.0f ? 0 : (x > (float)limit ? limit : (int32_t)x); }

static pixel_box primitive_box(const canvas *c, const primitive *s)
{
	float x0 = s->points[0].x, y0 = s->points[0].y, x1 = x0, y1 = y0, grow = s->radius + 1.0f;
	pixel_box box;
	for (int32_t i = 1; i < s->count; ++i) {
		x0 = s->points[i].x < x0 ? s->points[i].x : x0;
		y0 = s->points[i].y < y0 ? s->points[i].y : y0;
		x1 = s->points[i].x > x1 ? s->points[i].x : x1;
		y1 = s->points[i].y > y1 ? s->points[i].y : y1;
	}
	box.x0 = pixel_clamp(x0 - grow, c->width);
	box.y0 = pixel_clamp(y0 - grow, c->height);
	box.x1 = pixel_clamp(x1 + grow + 1.0f, c->width);
	box.y1 = pixel_clamp(y1 + grow + 1.0f, c->height);
	return box;
}

static void draw_primitive(canvas *c, const primitive *s, canvas_color fill, canvas_color outline, float outline_px)
{
	pixel_box box = primitive_box(c, s);
	for (int32_t y = box.y0; y < box.y1; ++y) {
		for (int32_t x = box.x0; x < box.x1; ++x) {
			canvas_point p = {(float)x + 0.5f, (float)y + 0.5f};
			float d = primitive_distance(s, p);
			float cover = unit_clamp(0.5f - d);
			if (cover <= 0.0f)
				continue;
			uint8_t *pixel = c->rgb + 3 * ((size_t)y * (size_t)c->width + (size_t)x);
			float inner = outline_px > 0.0f ? unit_clamp(0.5f - d - outline_px) : cover;
			if (outline_px > 0.0f)
				blend(pixel, outline, cover);
			blend(pixel, fill, inner);
		}
	}
}

/* ------------------------------------------------------------------ primitives */

void canvas_disc(canvas *c, canvas_point center, float radius, canvas_color fill, canvas_color outline, float outline_px)
{
	primitive s;
	s.count = 1;
	s.points[0] = center;
	s.radius = radius;
	draw_primitive(c, &s, fill, outline, outline_px);
}

void canvas_capsule(canvas *c, canvas_point a, canvas_point b, float radius, canvas_color fill, canvas_color outline, float outline_px)
{
	primitive s;
	s.count = 2;
	s.points[0] = a;
	s.points[1] = b;
	s.radius = radius;
	draw_primitive(c, &s, fill, outline, outline_px);
}

void canvas_line(canvas *c, canvas_point a, canvas_point b, float width, canvas_color color)
{
	canvas_capsule(c, a, b, 0.5f * width, color, color, 0.0f);
}

void canvas_polygon(canvas *c, const canvas_point *points, int32_t count, float radius, canvas_color fill, canvas_color outline, float outline_px)
{
	primitive s;
	float area = 0.0f;
	s.count = count < CANVAS_POLYGON_MAX ? count : CANVAS_POLYGON_MAX;
	s.radius = radius;
	for (int32_t i = 0; i < s.count; ++i) {
		canvas_point next = points[i + 1 < s.count ? i + 1 : 0];
		s.points[i] = points[i];
		area += points[i].x * next.y - points[i].y * next.x;
	}
	for (int32_t i = 0; i < s.count; ++i) {
		canvas_point next = s.points[i + 1 < s.count ? i + 1 : 0];
		float ex = next.x - s.points[i].x, ey = next.y - s.points[i].y;
		float length = sqrtf(ex * ex + ey * ey), side = area > 0.0f ? 1.0f : -1.0f;
		s.normals[i].x = length > 0.0f ? side * ey / length : 0.0f;
		s.normals[i].y = length > 0.0f ? -side * ex / length : 0.0f;
	}
	draw_primitive(c, &s, fill, outline, outline_px);
}
