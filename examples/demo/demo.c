/*
 * examples/demo/demo.c - runs the demo scenes, prints their figures and writes an animation, a still
 * and a page of all of them.
 *
 *     demo output-folder [scene]
 */
#include "demo/draw.h"
#include "demo/duel.h"
#include "demo/gif.h"
#include "demo/page.h"
#include "demo/palette.h"
#include "demo/png.h"
#include "measure/measure.h"
#include "scenes/scenes.h"
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define PICTURE_AREA_PX 340000
#define PICTURE_WIDTH_MAX_PX 920
#define STEPS_A_FRAME 2
#define FRAME_CS 3
#define REST_SPEED_MPS 0.02f
#define SCENES_MAX 32
#define DUELS_MAX 8

/* ------------------------------------------------------------------ pictures */

typedef struct film {
	canvas canvas;
	uint8_t *pixels;
	const palette *colors;
	uint32_t show; /* DRAW_SHOW_* */
	gif gif;
	cn_aabb view_m;
} film;

/* Joints are what these scenes are about; elsewhere their marks hide the bodies. */
static int32_t shows_joints(const scene *which)
{
	return strcmp(which->name, "machines") == 0 || strcmp(which->name, "constraints") == 0;
}

/* About the same area for every scene, in the proportions of its view. */
static void picture_size(const cn_aabb *view_m, int32_t *out_width, int32_t *out_height)
{
	float proportion = (view_m->upper_m.y - view_m->lower_m.y) / (view_m->upper_m.x - view_m->lower_m.x);
	float width = sqrtf((float)PICTURE_AREA_PX / proportion);
	width = width > (float)PICTURE_WIDTH_MAX_PX ? (float)PICTURE_WIDTH_MAX_PX : width;
	*out_width = (int32_t)width / 2 * 2;
	*out_height = (int32_t)(width * proportion) / 2 * 2;
}

static int32_t film_open(film *f, const scene *which, const palette *colors, const char *folder)
{
	char path[512];
	int32_t width, height;
	memset(f, 0, sizeof *f);
	picture_size(&which->view_m, &width, &height);
	f->colors = colors;
	f->show = DRAW_SHOW_BODIES | (shows_joints(which) ? DRAW_SHOW_JOINTS : 0u);
	f->view_m = which->view_m;
	f->pixels = (uint8_t *)malloc((size_t)width * (size_t)height);
	snprintf(path, sizeof path, "%s/%s.gif", folder, which->name);
	return canvas_open(&f->canvas, width, height) && f->pixels != NULL &&
		   gif_open(&f->gif, path, width, height, colors->rgb, colors->count, FRAME_CS);
}

/* The scene's view, moved sideways to follow its focus. */
static draw_view film_view(const film *f, const canvas *c, const scene_run *run)
{
	draw_view view = draw_fit(c, &f->view_m);
	cn_vec2 center;
	if (run->focus != 0 && cn_body_get_center(run->world, run->focus, &center) == CN_OK)
		view.lower_m.x += center.x - 0.5f * (f->view_m.lower_m.x + f->view_m.upper_m.x);
	return view;
}

static void film_add(film *f, const scene_run *run)
{
	draw_view view = film_view(f, &f->canvas, run);
	if (!draw_world(&f->canvas, &view, run->world, f->show))
		f->gif.failed = 1;
	palette_apply(f->colors, &f->canvas, f->pixels);
	gif_add(&f->gif, f->pixels);
}

/* Half as large again as the animation. */
static int32_t write_still(const film *f, const scene_run *run, const char *folder)
{
	char path[512];
	canvas large;
	int32_t good = 0;
	if (!canvas_open(&large, 3 * f->canvas.width / 2, 3 * f->canvas.height / 2))
		return 0;
	uint8_t *pixels = (uint8_t *)malloc((size_t)large.width * (size_t)large.height);
	draw_view view = film_view(f, &large, run);
	snprintf(path, sizeof path, "%s/%s.png", folder, run->scene->name);
	if (pixels != NULL && draw_world(&large, &view, run->world, f->show)) {
		palette_apply(f->colors, &large, pixels);
		good = png_write(path, large.width, large.height, pixels, f->colors->rgb, f->colors->count);
	}
	free(pixels);
	canvas_close(&large);
	return good;
}

/* Bytes of the animation, -1 on failure. */
static long film_close(film *f)
{
	long bytes = f->gif.file != NULL ? gif_close(&f->gif) : -1;
	canvas_close(&f->canvas);
	free(f->pixels);
	return bytes;
}

/* ------------------------------------------------------------------ figures */

/* Only the step itself is timed, not the drawing nor what the scene adds between steps. */
static cn_result timed_step(scene_run *run, measure_times *times)
{
	scene_before_step(run);
	double start = measure_clock_s();
	cn_result result = run->result == CN_OK ? cn_world_step(run->world, SCENE_STEP_S) : run->result;
	measure_times_add(times, measure_clock_s() - start);
	++run->step_index;
	return result;
}

static void fill_figures(demo_figures *out, const scene_run *run, measure_times *times, const measure_worst *worst, const film *f)
{
	cn_counters counters;
	cn_world_get_counters(run->world, &counters);
	measure_times_sort(times);
	out->name = run->scene->name;
	out->title = run->scene->title;
	out->width = f->canvas.width;
	out->height = f->canvas.height;
	out->steps = run->step_index;
	out->bodies = counters.bodies;
	out->joints = counters.joints;
	out->contacts = counters.contacts_touching;
	out->asleep = measure_bodies_asleep(run->world);
	out->ms_min = measure_times_at(times, 0.0);
	out->ms_median = measure_times_at(times, 0.5);
	out->ms_p99 = measure_times_at(times, 0.99);
	out->rest_overlap_m = measure_rest_overlap(run->world, REST_SPEED_MPS, &out->rest_points);
	out->motion_overlap_m = worst->penetration_m;
	out->joint_error_m = worst->joint_m;
	cn_world_hash(run->world, &out->hash);
}

static int32_t run_steps(scene_run *run, film *f, measure_times *times, measure_worst *worst)
{
	for (int32_t i = 0; i < run->scene->step_count; ++i) {
		if (timed_step(run, times) != CN_OK)
			return 0;
		if (i % STEPS_A_FRAME == 0) {
			measure_errors(worst, run->world);
			film_add(f, run);
		}
	}
	return 1;
}

/* ------------------------------------------------------------------ the run */

static int32_t run_scene(const scene *which, const palette *colors, const char *folder, demo_figures *out)
{
	scene_run run;
	film f;
	measure_times times;
	measure_worst worst = {0};
	int32_t good = 0;
	if (scene_open(&run, which, NULL) != CN_OK) {
		fprintf(stderr, "%s: %s\n", which->name, run.error_text);
		return 0;
	}
	if (film_open(&f, which, colors, folder) && measure_times_open(&times, which->step_count)) {
		good = run_steps(&run, &f, &times, &worst);
		if (good) {
			fill_figures(out, &run, &times, &worst, &f);
			good = write_still(&f, &run, folder);
		} else {
			fprintf(stderr, "%s: step %" PRId32 ": %s\n", which->name, run.step_index, cn_world_error_text(run.world));
		}
		measure_times_close(&times);
	}
	out->gif_bytes = film_close(&f);
	scene_close(&run);
	if (out->gif_bytes < 0)
		fprintf(stderr, "%s: cannot write its pictures to %s\n", which->name, folder);
	return good && out->gif_bytes > 0;
}

static void print_head(void)
{
	printf("%-15s %6s %8s %6s %6s %8s %9s %8s %9s %9s %9s  %-16s %s\n", "scene", "bodies", "contacts", "joints", "asleep", "ms_min",
		"ms_median", "ms_p99", "rest_mm", "motion_mm", "joint_mm", "hash", "gif_kB");
}

static void print_figures(const demo_figures *d)
{
	char rest[16] = "-";
	if (d->rest_points > 0)
		snprintf(rest, sizeof rest, "%.3f", 1000.0 * (double)d->rest_overlap_m);
	printf("%-15s %6" PRId32 " %8" PRId32 " %6" PRId32 " %6" PRId32 " %8.3f %9.3f %8.3f %9s %9.2f %9.2f  %016" PRIx64 " %ld\n", d->name,
		d->bodies, d->contacts, d->joints, d->asleep, d->ms_min, d->ms_median, d->ms_p99, rest, 1000.0 * (double)d->motion_overlap_m,
		1000.0 * (double)d->joint_error_m, d->hash, d->gif_bytes / 1000);
	fflush(stdout);
}

/* The page begins with these; the others follow in the order of the list. */
static const char *const first[] = {"ragdolls", "bridge", "machines", "tumbler_1000"};
#define PASSES ((int32_t)(sizeof first / sizeof first[0]) + 1)

/* Films beside the pictures: films.sh. Without films there is nothing to show. */
static int32_t make_duels(const palette *colors, const char *folder, duel_figures *out)
{
	char films[512];
	int32_t count = 0;
	snprintf(films, sizeof films, "%s/films", folder);
	for (int32_t i = 0; i < duel_count() && count < DUELS_MAX; ++i)
		count += duel_make(i, films, folder, colors, &out[count]);
	for (int32_t i = 0; i < count; ++i)
		for (int32_t e = 0; e < out[i].engines; ++e)
			printf("%-15s %-10s %s\n", e == 0 ? out[i].name : "", out[i].engine[e], out[i].verdict[e]);
	return count;
}

static int32_t in_pass(const scene *which, int32_t pass)
{
	int32_t own = 0;
	while (own < PASSES - 1 && strcmp(which->name, first[own]) != 0)
		++own;
	return which->flags & SCENE_DEMO && own == pass;
}

int main(int argc, char **argv)
{
	static palette colors;
	static demo_figures figures[SCENES_MAX];
	static duel_figures duels[DUELS_MAX];
	int32_t count = 0, failed = 0, duel_total;
	if (argc < 2) {
		fprintf(stderr, "usage: demo output-folder [scene]\n");
		return 2;
	}
	if (argc > 2 && scene_find(argv[2]) == NULL) {
		fprintf(stderr, "there is no scene named %s\n", argv[2]);
		return 2;
	}
	palette_make(&colors, draw_colors, DRAW_COLORS);
	print_head();
	for (int32_t i = 0; i < PASSES * scene_count() && count < SCENES_MAX; ++i) {
		const scene *which = scene_at(i % scene_count());
		if (argc > 2 ? i >= scene_count() || strcmp(which->name, argv[2]) != 0 : !in_pass(which, i / scene_count()))
			continue;
		if (run_scene(which, &colors, argv[1], &figures[count]))
			print_figures(&figures[count++]);
		else
			++failed;
	}
	duel_total = argc > 2 ? 0 : make_duels(&colors, argv[1], duels);
	if (!page_write(argv[1], figures, count, 3, duels, duel_total))
		++failed;
	printf("pictures: %s/index.html\n", argv[1]);
	return failed != 0;
}
