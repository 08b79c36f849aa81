/*
 * test/stability/piles.c - stacks, with a heavy top or without, and pyramids of boxes of 1 m.
 */
#include "scene.h"

#include <math.h>

/* A box of 1 m has fallen when it is that far aside, or that far down and a share of its height more. */
#define FELL 0.5
#define FELL_SHARE 0.02

typedef struct pile_state {
	double penetration, displacement, fell_s;
	double loud_s[2]; /* last time at which something was faster than 0.05 and 0.005 m/s */
	double speed_last_second;
} pile_state;

static int has_fallen(const scene_run *run)
{
	double most = FELL * scene_value(run, "size");
	int32_t k;
	for (k = 0; k < run->item_count; ++k) {
		scene_motion m = scene_read(run, k);
		if (!(fabs(m.x - run->items[k].x) < most && run->items[k].y - m.y < most + FELL_SHARE * run->items[k].y))
			return 1;
	}
	return 0;
}

static void observe_pile(scene_run *run)
{
	static const double loud[2] = { 0.05, 0.005 };
	pile_state *state = run->state;
	double displacement = scene_displacement(run), speed = scene_speed_max(run);
	int32_t k;
	state->displacement = scene_greater(state->displacement, displacement);
	if (state->fell_s == 0.0 && has_fallen(run))
		state->fell_s = run->time_s;
	for (k = 0; k < 2; ++k)
		if (!(speed < loud[k]))
			state->loud_s[k] = run->time_s;
	if ((double)(run->frame_count - run->frame) * run->dt_s < 1.0)
		state->speed_last_second = scene_greater(state->speed_last_second, speed);
}

static void report_standing(scene_run *run)
{
	const pile_state *state = run->state;
	scene_report(run, "stands", state->fell_s == 0.0 ? 1.0 : 0.0);
	if (state->fell_s > 0.0)
		scene_report(run, "t_fall_s", state->fell_s);
}

/* ---- stack: boxes on each other, every second one moved aside a little; the last may be dense ---- */

static void stack_build(scene_run *run)
{
	int32_t boxes = scene_count(run, "boxes"), k;
	double offset = scene_value(run, "offset"), top = scene_value(run, "top");
	scene_floor(run);
	for (k = 0; k < boxes; ++k)
		scene_box(run, CN_BODY_DYNAMIC, k % 2 == 0 ? offset : -offset, (double)k + 0.5, 0.0, 0.5, 0.5);
	run->density = top;
	if (top > 0.0)
		scene_box(run, CN_BODY_DYNAMIC, 0.0, (double)boxes + 0.5, 0.0, 0.5, 0.5);
}

static void stack_observe(scene_run *run)
{
	pile_state *state = run->state;
	observe_pile(run);
	if (state->fell_s == 0.0)
		state->penetration = scene_greater(state->penetration, scene_penetration(run));
}

static void stack_finish(scene_run *run)
{
	const pile_state *state = run->state;
	int32_t k, top = run->item_count - 1;
	double drift = 0.0;
	for (k = 0; k <= top; ++k)
		drift = scene_greater(drift, fabs(scene_read(run, k).x - run->items[k].x));
	report_standing(run);
	scene_report(run, "pen_max_m", state->penetration);
	scene_report(run, "pen_end_m", scene_penetration(run));
	scene_report(run, "drift_x_m", drift);
	scene_report(run, "vmax_last1s", state->speed_last_second);
	scene_report(run, "height_loss_m", run->items[top].y - scene_read(run, top).y);
}

/* ---- pyramid; push: speed aside of the top, and of the others by their height ---- */

static void pyramid_build(scene_run *run)
{
	int32_t base = scene_count(run, "base"), i, j;
	double push = scene_value(run, "push");
	scene_floor(run);
	for (i = 0; i < base; ++i)
		for (j = i; j < base; ++j) {
			cn_body body = scene_box(run, CN_BODY_DYNAMIC, 0.5 * (double)(i + 1) + (double)(j - i) - 0.5 * (double)base, (double)i + 0.5, 0.0, 0.5, 0.5);
			if (push != 0.0)
				scene_set_velocity(run, body, push * (double)(i + 1) / (double)base, 0.0, 0.0);
		}
}

static void pyramid_finish(scene_run *run)
{
	const pile_state *state = run->state;
	int32_t top = run->item_count - 1;
	report_standing(run);
	scene_report(run, "disp_max_m", state->displacement);
	scene_report(run, "settle_0.05_s", state->loud_s[0]);
	scene_report(run, "settle_0.005_s", state->loud_s[1]);
	scene_report(run, "v_end", scene_speed_max(run));
	scene_report(run, "pen_end_m", scene_penetration(run));
	scene_report(run, "top_sag_m", run->items[top].y - scene_read(run, top).y);
}

const scene_family pile_families[] = {
	{ "stack", "boxes=10 top=0 offset=0.001 seconds=10", sizeof(pile_state), stack_build, stack_observe, stack_finish },
	{ "pyramid", "base=20 push=0 seconds=10", sizeof(pile_state), pyramid_build, observe_pile, pyramid_finish },
};
const int32_t pile_family_count = (int32_t)(sizeof pile_families / sizeof *pile_families);
