/*
 * test/stability/film.c - writes what a run looks like, for examples/demo/duel.c, which draws it beside the same run of other engines.
 *
 * A line each:
 *
 *     body x y angle moves            whole millimetres and milliradians; then its shapes in metres:
 *     box hx hy | circle r | polygon x y ... | capsule ax ay bx by r
 *     frame dx,dy,da . ...            every FILM_FRAMES frames, for the moving bodies in order: what was added since the line before; a
 *                                     dot is a body that did not move
 *     metric name value               at the end
 */
#include "scene.h"

#include <math.h>
#include <stdio.h>

#define FILM_FRAMES 3
#define FILM_FAR_M 1e4 /* what has flown farther stays there */

static double clamped(double value) { return value > FILM_FAR_M ? FILM_FAR_M : value < -FILM_FAR_M ? -FILM_FAR_M : value == value ? value : 0.0; }

static long thousandths(double value) { return lround(1000.0 * clamped(value)); }

void scene_film_body(scene_run *run, int32_t type, const cn_body_def *def)
{
	scene_item *item;
	if (run->film == NULL)
		return;
	fprintf(run->film, "body %ld %ld %ld %d\n", thousandths((double)def->position_m.x), thousandths((double)def->position_m.y), thousandths((double)def->angle_rad),
		type == CN_BODY_DYNAMIC);
	if (type != CN_BODY_DYNAMIC)
		return;
	item = &run->items[run->item_count - 1];
	item->film[0] = thousandths((double)def->position_m.x);
	item->film[1] = thousandths((double)def->position_m.y);
	item->film[2] = thousandths((double)def->angle_rad);
}

void scene_film_shape(scene_run *run, const char *kind, const float *numbers, int32_t count)
{
	int32_t k;
	if (run->film == NULL)
		return;
	fprintf(run->film, "%s", kind);
	for (k = 0; k < count; ++k)
		fprintf(run->film, " %.4g", (double)numbers[k]);
	fputc('\n', run->film);
}

void scene_film_metrics(const scene_run *run)
{
	int32_t k;
	for (k = 0; run->film != NULL && k < run->metric_count; ++k)
		fprintf(run->film, "metric %s %.6g\n", run->metrics[k].name, run->metrics[k].value);
}

void scene_film_frame(scene_run *run)
{
	int32_t i, k;
	if (run->film == NULL || run->frame % FILM_FRAMES != 0)
		return;
	fputs("frame", run->film);
	for (i = 0; i < run->item_count; ++i) {
		scene_item *item = &run->items[i];
		cn_pose pose = { { 0.0f, 0.0f }, 1.0f, 0.0f };
		long now[3];
		scene_check(run, cn_body_get_pose(run->world, item->body, &pose));
		now[0] = thousandths((double)pose.position_m.x);
		now[1] = thousandths((double)pose.position_m.y);
		now[2] = thousandths(atan2((double)pose.sine, (double)pose.cosine));
		if (now[0] == item->film[0] && now[1] == item->film[1] && now[2] == item->film[2])
			fputs(" .", run->film);
		else
			fprintf(run->film, " %ld,%ld,%ld", now[0] - item->film[0], now[1] - item->film[1], now[2] - item->film[2]);
		for (k = 0; k < 3; ++k)
			item->film[k] = now[k];
	}
	fputc('\n', run->film);
}
