/*
 * examples/replay.c - the tool for recordings (examples/record/): plays one, prints what happens and the first difference, draws a step.
 *
 *     replay game.rec                     plays all of it
 *     replay game.rec -step 300 -o x.png  draws the world after 300 steps
 *     replay -demo game.rec               records a small game: boxes that a ball is thrown at
 */
#include "../bindings/record/cairn_record.h"
#include "record/player.h"
#include "record/record.h"

#include "demo/draw.h"
#include "demo/palette.h"
#include "demo/png.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define WIDTH 960
#define HEIGHT 540

/* ---- a game, recorded: its calls are those of bindings/record/cairn_record.h ---- */

static cn_body demo_box(cn_world *world, int32_t type, float x, float y, float half_width, float half_height)
{
	cn_body_def body_def;
	cn_shape_def shape_def;
	cn_body body = 0;
	cn_body_def_init(&body_def);
	body_def.type = type;
	body_def.position_m.x = x;
	body_def.position_m.y = y;
	body_def.name = type == CN_BODY_STATIC ? "ground" : "box";
	(void)cnr_body_create(world, &body_def, &body);
	cn_shape_def_init(&shape_def);
	shape_def.body = body;
	(void)cnr_shape_create_box(world, &shape_def, half_width, half_height, 0.0f, NULL);
	return body;
}

static int demo(const char *path)
{
	FILE *file = fopen(path, "wb");
	cn_world_def def;
	cn_world *world = NULL;
	cn_body ball;
	int step, k;
	cn_world_def_init(&def);
	if (file == NULL || cn_world_create(&def, &world) != CN_OK || !record_begin(world, NULL, record_to_file, file)) {
		puts("no recording");
		return 1;
	}
	demo_box(world, CN_BODY_STATIC, 0.0f, -1.0f, 20.0f, 1.0f);
	for (k = 0; k < 28; ++k)
		demo_box(world, CN_BODY_DYNAMIC, 0.9f * (float)(k % 4), 0.4f + 0.8f * (float)(k / 4), 0.4f, 0.4f);
	ball = demo_box(world, CN_BODY_DYNAMIC, -9.0f, 2.0f, 0.7f, 0.7f);
	for (step = 0; step < 900; ++step) {
		if (step == 120)
			(void)cnr_body_set_velocity(world, ball, 16.0f, 3.0f, 2.0f);
		if (step % 60 == 30)
			(void)cnr_body_apply_impulse(world, ball, 1.0f, 4.0f);
		(void)cnr_world_step(world, 1.0f / 60.0f);
	}
	cnr_world_destroy(world);
	return fclose(file) != 0;
}

/* ---- drawing ---- */

/* The smallest box around all bodies that move, with a margin. */
static draw_view view_of(const canvas *c, const cn_world *world)
{
	cn_aabb box;
	float x0 = 1e30f, y0 = 1e30f, x1 = -1e30f, y1 = -1e30f;
	int32_t count = 0, k, type;
	cn_body *bodies;
	(void)cn_world_get_bodies(world, NULL, 0, &count);
	bodies = (cn_body *)calloc((size_t)count + 1, sizeof *bodies);
	if (bodies != NULL)
		(void)cn_world_get_bodies(world, bodies, count, &count);
	for (k = 0; k < count && bodies != NULL; ++k) {
		cn_pose pose;
		if (cn_body_get_type(world, bodies[k], &type) != CN_OK || type == CN_BODY_STATIC || cn_body_get_pose(world, bodies[k], &pose) != CN_OK)
			continue;
		x0 = pose.position_m.x < x0 ? pose.position_m.x : x0;
		y0 = pose.position_m.y < y0 ? pose.position_m.y : y0;
		x1 = pose.position_m.x > x1 ? pose.position_m.x : x1;
		y1 = pose.position_m.y > y1 ? pose.position_m.y : y1;
	}
	free(bodies);
	if (x0 > x1) {
		x0 = y0 = -8.0f;
		x1 = y1 = 8.0f;
	}
	box.lower_m.x = x0 - 2.0f;
	box.lower_m.y = y0 - 2.0f;
	box.upper_m.x = x1 + 2.0f;
	box.upper_m.y = y1 + 2.0f;
	if ((box.upper_m.y - box.lower_m.y) * (float)WIDTH > (box.upper_m.x - box.lower_m.x) * (float)HEIGHT) /* draw_fit fits the width */
		box.upper_m.x = box.lower_m.x + (box.upper_m.y - box.lower_m.y) * (float)WIDTH / (float)HEIGHT;
	return draw_fit(c, &box);
}

static int draw(const cn_world *world, const char *path)
{
	static uint8_t pixels[WIDTH * HEIGHT];
	static palette colors;
	draw_view view;
	canvas c;
	int result;
	if (!canvas_open(&c, WIDTH, HEIGHT))
		return 1;
	view = view_of(&c, world);
	canvas_clear(&c, draw_colors[DRAW_BACKGROUND]);
	(void)draw_world(&c, &view, world, DRAW_SHOW_BODIES | DRAW_SHOW_JOINTS);
	palette_make(&colors, draw_colors, DRAW_COLORS);
	palette_apply(&colors, &c, pixels);
	canvas_close(&c);
	result = png_write(path, WIDTH, HEIGHT, pixels, colors.rgb, colors.count) > 0 ? 0 : 1;
	printf("%s: %s\n", path, result == 0 ? "drawn" : "cannot be written");
	return result;
}

/* ---- playing ---- */

static uint8_t *file_read(const char *path, uint64_t *count)
{
	FILE *file = fopen(path, "rb");
	uint8_t *bytes = NULL;
	long size;
	if (file == NULL)
		return NULL;
	if (fseek(file, 0, SEEK_END) == 0 && (size = ftell(file)) >= 0 && fseek(file, 0, SEEK_SET) == 0) {
		bytes = (uint8_t *)malloc((size_t)size + 1);
		*count = bytes != NULL ? fread(bytes, 1, (size_t)size, file) : 0;
	}
	(void)fclose(file);
	return bytes;
}

static int play(const char *path, int64_t step, const char *picture)
{
	uint64_t count = 0, hash = 0;
	uint8_t *bytes = file_read(path, &count);
	int result = 1;
	player p;
	if (bytes == NULL || !player_open(&p, NULL, bytes, count)) {
		printf("%s is no recording\n", path);
		free(bytes);
		return 1;
	}
	if (step >= 0 && !player_seek(&p, (uint64_t)step))
		printf("there is no step %lld\n", (long long)step);
	while (step < 0 && player_step(&p))
		;
	(void)cn_world_hash(p.world, &hash);
	printf("%s: %llu steps, after %llu of them hash %016llx; %d calls and %d checks compared\n", path, (unsigned long long)p.step_count, (unsigned long long)p.step, (unsigned long long)hash,
	       (int)p.calls, (int)p.checks);
	if (p.broken)
		puts("the recording ends within a record");
	printf("%s\n", p.differs ? p.report : "no difference");
	result = p.differs || p.broken;
	if (picture != NULL)
		result |= draw(p.world, picture);
	player_close(&p);
	free(bytes);
	return result;
}

int main(int argc, char **argv)
{
	const char *path = NULL, *picture = NULL;
	int64_t step = -1;
	int k;
	for (k = 1; k < argc; ++k) {
		if (strcmp(argv[k], "-demo") == 0 && k + 1 < argc)
			return demo(argv[k + 1]);
		if (strcmp(argv[k], "-step") == 0 && k + 1 < argc)
			step = strtoll(argv[++k], NULL, 10);
		else if (strcmp(argv[k], "-o") == 0 && k + 1 < argc)
			picture = argv[++k];
		else
			path = argv[k];
	}
	if (path == NULL) {
		puts("usage: replay FILE [-step N] [-o picture.png] | replay -demo FILE");
		return 1;
	}
	return play(path, step, picture);
}
