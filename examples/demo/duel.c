/*
 * examples/demo/duel.c - draws films of several engines beside each other, each by a world of this library whose bodies are put where the
 * film says: nothing is simulated here.
 */
#include "demo/duel.h"
#include "demo/draw.h"
#include "demo/gif.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define PANEL_PX 304
#define GAP_PX 4
#define HEIGHT_MIN_PX 180
#define HEIGHT_MAX_PX 340
#define FRAME_CS 5
#define LINE_BYTES 8192
#define BODIES_MAX 256

static const struct { const char *name, *title; cn_aabb view_m; } scenes[] = {
	{"chain", "A ball of 1,000 times a link's mass swings on 20 links", {{-19.0f, -20.5f}, {19.0f, 3.5f}}},
	{"top", "Ten boxes carry one of 1,000 times their mass", {{-7.0f, -0.6f}, {7.0f, 12.6f}}},
	{"beam", "A beam of ten welded boxes, with 100 times a box's mass at its end", {{-1.5f, -9.0f}, {12.5f, 4.0f}}},
	{"arch", "An arch of 31 stones without mortar", {{-13.5f, -0.6f}, {13.5f, 12.8f}}},
};
static const struct { const char *file, *name; } engines[DUEL_ENGINES] = {{"cairn", "Cairn"}, {"box2d", "Box2D 3.2"}, {"chipmunk", "Chipmunk 7"}};

int32_t duel_count(void) { return (int32_t)(sizeof scenes / sizeof scenes[0]); }

/* ------------------------------------------------------------------ one film */

typedef struct film_reader {
	FILE *file;
	cn_world *world;
	cn_body body;                 /* the last */
	cn_body moving[BODIES_MAX];
	long pose[BODIES_MAX][3];     /* millimetres, milliradians */
	int32_t moving_count;
	int32_t ended;
	double falls_s, gap_m, sag_m; /* metrics; -1: none */
	int32_t stands;               /* 1, 0; -1: no metric */
} film_reader;

static void add_body(film_reader *r, const char *line)
{
	cn_body_def def;
	long at[3];
	int moves = 0;
	cn_body_def_init(&def);
	if (sscanf(line, "body %ld %ld %ld %d", &at[0], &at[1], &at[2], &moves) != 4)
		return;
	def.type = moves ? CN_BODY_DYNAMIC : CN_BODY_STATIC;
	def.position_m.x = 0.001f * (float)at[0];
	def.position_m.y = 0.001f * (float)at[1];
	def.angle_rad = 0.001f * (float)at[2];
	if (cn_body_create(r->world, &def, &r->body) != CN_OK || !moves || r->moving_count == BODIES_MAX)
		return;
	memcpy(r->pose[r->moving_count], at, sizeof at);
	r->moving[r->moving_count++] = r->body;
}

static void add_shape(const film_reader *r, const char *kind, const char *text)
{
	float n[2 * CN_POLYGON_MAX_VERTICES] = {0.0f};
	int32_t count = 0;
	cn_shape_def def;
	cn_shape_def_init(&def);
	def.body = r->body;
	while (count < 2 * CN_POLYGON_MAX_VERTICES) {
		char *end;
		n[count] = strtof(text, &end);
		if (end == text)
			break;
		text = end;
		++count;
	}
	if (strcmp(kind, "box") == 0) {
		cn_shape_create_box(r->world, &def, n[0], n[1], 0.0f, NULL);
	} else if (strcmp(kind, "circle") == 0) {
		cn_circle circle = {{0.0f, 0.0f}, n[0]};
		cn_shape_create_circle(r->world, &def, &circle, NULL);
	} else if (strcmp(kind, "capsule") == 0) {
		cn_capsule capsule = {{n[0], n[1]}, {n[2], n[3]}, n[4]};
		cn_shape_create_capsule(r->world, &def, &capsule, NULL);
	} else if (strcmp(kind, "polygon") == 0) {
		cn_polygon polygon;
		memset(&polygon, 0, sizeof polygon);
		polygon.count = count / 2;
		memcpy(polygon.points_m, n, sizeof n);
		cn_shape_create_polygon(r->world, &def, &polygon, NULL);
	}
}

static void move_bodies(film_reader *r, char *line)
{
	char *word = strtok(line + 5, " \n");
	for (int32_t i = 0; i < r->moving_count && word != NULL; ++i, word = strtok(NULL, " \n")) {
		long d[3];
		if (sscanf(word, "%ld,%ld,%ld", &d[0], &d[1], &d[2]) != 3)
			continue;
		for (int32_t k = 0; k < 3; ++k)
			r->pose[i][k] += d[k];
		cn_body_set_pose(r->world, r->moving[i], 0.001f * (float)r->pose[i][0], 0.001f * (float)r->pose[i][1], 0.001f * (float)r->pose[i][2]);
	}
}

static void take_metric(film_reader *r, const char *name, double value)
{
	if (strcmp(name, "stands") == 0)
		r->stands = value > 0.5;
	else if (strcmp(name, "t_fall_s") == 0)
		r->falls_s = value;
	else if (strcmp(name, "joint_stretch_max_m") == 0)
		r->gap_m = value;
	else if (strcmp(name, "tip_sag_max_m") == 0 || strcmp(name, "key_sag_m") == 0)
		r->sag_m = value;
}

/* Reads up to the end of the next frame. 0 at the end of the film. */
static int32_t next_frame(film_reader *r)
{
	char line[LINE_BYTES], kind[32];
	while (!r->ended && fgets(line, sizeof line, r->file) != NULL) {
		char name[64];
		double value;
		if (sscanf(line, "%31s", kind) != 1)
			continue;
		if (strcmp(kind, "frame") == 0) {
			move_bodies(r, line);
			return 1;
		}
		if (strcmp(kind, "body") == 0)
			add_body(r, line);
		else if (sscanf(line, "metric %63s %lf", name, &value) == 2)
			take_metric(r, name, value);
		else
			add_shape(r, kind, line + strlen(kind));
	}
	r->ended = 1;
	return 0;
}

static int32_t film_reader_open(film_reader *r, const char *films, const char *scene, const char *engine)
{
	char path[512];
	cn_world_def def;
	memset(r, 0, sizeof *r);
	r->stands = -1;
	r->falls_s = r->gap_m = r->sag_m = -1.0;
	snprintf(path, sizeof path, "%s/%s_%s.film", films, scene, engine);
	r->file = fopen(path, "r");
	cn_world_def_init(&def);
	return r->file != NULL && cn_world_create(&def, &r->world) == CN_OK;
}

static void film_reader_close(film_reader *r)
{
	if (r->file != NULL)
		fclose(r->file);
	cn_world_destroy(r->world);
}

/* "0.002 mm", "10.2 m" */
static void write_length(double metres, char *text, size_t bytes)
{
	if (metres < 1e-6)
		snprintf(text, bytes, "less than 1 \302\265m");
	else if (metres < 0.1)
		snprintf(text, bytes, "%.*f mm", metres < 0.001 ? 3 : 1, 1000.0 * metres);
	else
		snprintf(text, bytes, "%.*f m", metres < 1.0 ? 2 : 1, metres);
}

static void write_verdict(const film_reader *r, char *text, size_t bytes)
{
	char length[32];
	write_length(r->sag_m >= 0.0 ? r->sag_m : r->gap_m, length, sizeof length);
	if (r->stands == 0)
		snprintf(text, bytes, "falls after %.1f s", r->falls_s);
	else if (r->stands == 1)
		snprintf(text, bytes, r->sag_m >= 0.0 ? "stands; its keystone sinks by %s" : "stands", length);
	else if (r->gap_m >= 0.0)
		snprintf(text, bytes, r->sag_m >= 0.0 ? "the end sags by %s" : "joints open by %s", length);
}

/* ------------------------------------------------------------------ beside each other */

typedef struct stage {
	film_reader films[DUEL_ENGINES];
	int32_t count;
	canvas panel, whole;
	uint8_t *pixels;
	gif gif;
} stage;

static int32_t draw_frame(stage *s, const cn_aabb *view_m, const palette *colors)
{
	draw_view view = draw_fit(&s->panel, view_m);
	for (int32_t e = 0; e < s->count; ++e) {
		if (!draw_world(&s->panel, &view, s->films[e].world, DRAW_SHOW_BODIES))
			return 0;
		for (int32_t y = 0; y < s->panel.height; ++y)
			memcpy(s->whole.rgb + 3 * (size_t)(y * s->whole.width + e * (PANEL_PX + GAP_PX)), s->panel.rgb + 3 * (size_t)(y * PANEL_PX), 3 * (size_t)PANEL_PX);
	}
	palette_apply(colors, &s->whole, s->pixels);
	gif_add(&s->gif, s->pixels);
	return 1;
}

static int32_t stage_open(stage *s, int32_t index, const char *folder, const palette *colors, duel_figures *out)
{
	const cn_aabb *v = &scenes[index].view_m;
	float height = (float)PANEL_PX * (v->upper_m.y - v->lower_m.y) / (v->upper_m.x - v->lower_m.x);
	char path[512];
	out->height = (int32_t)height / 2 * 2;
	out->height = out->height < HEIGHT_MIN_PX ? HEIGHT_MIN_PX : out->height > HEIGHT_MAX_PX ? HEIGHT_MAX_PX : out->height;
	out->width = s->count * PANEL_PX + (s->count - 1) * GAP_PX;
	snprintf(path, sizeof path, "%s/%s.gif", folder, scenes[index].name);
	if (!canvas_open(&s->panel, PANEL_PX, out->height) || !canvas_open(&s->whole, out->width, out->height))
		return 0;
	canvas_clear(&s->whole, draw_colors[DRAW_OUTLINE]);
	s->pixels = (uint8_t *)malloc((size_t)out->width * (size_t)out->height);
	return s->pixels != NULL && gif_open(&s->gif, path, out->width, out->height, colors->rgb, colors->count, FRAME_CS);
}

static int32_t play(stage *s, int32_t index, const palette *colors)
{
	for (;;) {
		int32_t going = 0;
		for (int32_t e = 0; e < s->count; ++e)
			going |= next_frame(&s->films[e]);
		if (!going)
			return 1;
		if (!draw_frame(s, &scenes[index].view_m, colors))
			return 0;
	}
}

int32_t duel_make(int32_t index, const char *films, const char *folder, const palette *colors, duel_figures *out)
{
	static stage s; /* large */
	int32_t good = 0;
	memset(&s, 0, sizeof s);
	memset(out, 0, sizeof *out);
	out->name = scenes[index].name;
	out->title = scenes[index].title;
	for (int32_t e = 0; e < DUEL_ENGINES; ++e) {
		film_reader *r = &s.films[s.count];
		if (film_reader_open(r, films, scenes[index].name, engines[e].file))
			out->engine[s.count++] = engines[e].name;
		else
			film_reader_close(r);
	}
	out->engines = s.count;
	if (s.count > 0 && strcmp(out->engine[0], engines[0].name) == 0 && stage_open(&s, index, folder, colors, out))
		good = play(&s, index, colors);
	for (int32_t e = 0; e < s.count; ++e) {
		write_verdict(&s.films[e], out->verdict[e], sizeof out->verdict[e]);
		film_reader_close(&s.films[e]);
	}
	if (s.gif.file != NULL && gif_close(&s.gif) < 0)
		good = 0;
	canvas_close(&s.panel);
	canvas_close(&s.whole);
	free(s.pixels);
	return good;
}
