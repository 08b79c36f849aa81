/*
 * test/stability/structures.c - what stands by friction and by its shape: an arch, card houses, a plank on two points.
 */
#include "scene.h"

#include <math.h>

typedef struct standing_state {
	double sag, fell_s, speed_last_second, tilt;
} standing_state;

/* sag is how far the piece that is watched came down, in metres. */
static void observe_sag(scene_run *run, double sag, double fallen)
{
	standing_state *state = run->state;
	state->sag = scene_greater(state->sag, sag);
	if (state->fell_s == 0.0 && !(sag < fallen * scene_value(run, "size")))
		state->fell_s = run->time_s;
	if ((double)(run->frame_count - run->frame) * run->dt_s < 1.0)
		state->speed_last_second = scene_greater(state->speed_last_second, scene_speed_max(run));
}

static void report_standing(scene_run *run, const char *sag_name)
{
	const standing_state *state = run->state;
	scene_report(run, "stands", state->fell_s == 0.0 ? 1.0 : 0.0);
	if (state->fell_s > 0.0)
		scene_report(run, "t_fall_s", state->fell_s);
	scene_report(run, sag_name, state->sag);
	scene_report(run, "vmax_last1s", state->speed_last_second);
}

static double sag_of(const scene_run *run, int32_t item) { return run->items[item].y - scene_read(run, item).y; }

/* ---- arch: a half circle of wedges without mortar; its thickness is 0.15 of its radius, 0.11 would just stand ---- */

static void arch_build(scene_run *run)
{
	int32_t stones = scene_count(run, "stones"), k, c;
	double inner = scene_value(run, "inner"), outer = scene_value(run, "outer");
	scene_floor(run);
	for (k = 0; k < stones; ++k) {
		double from = SCENE_PI * (double)k / (double)stones, to = SCENE_PI * (double)(k + 1) / (double)stones;
		double x = 0.5 * (inner + outer) * cos(0.5 * (from + to)), y = 0.5 * (inner + outer) * sin(0.5 * (from + to));
		double points[4][2] = { { inner * cos(from), inner * sin(from) }, { outer * cos(from), outer * sin(from) },
			{ outer * cos(to), outer * sin(to) }, { inner * cos(to), inner * sin(to) } };
		for (c = 0; c < 4; ++c) {
			points[c][0] -= x;
			points[c][1] -= y;
		}
		scene_polygon(run, CN_BODY_DYNAMIC, x, y, (const double(*)[2])points, 4);
		run->items[run->item_count - 1].y = scene_read(run, run->item_count - 1).y;
	}
}

static void arch_observe(scene_run *run) { observe_sag(run, sag_of(run, run->item_count / 2), 1.0); }
static void arch_finish(scene_run *run) { report_standing(run, "key_sag_m"); }

/* ---- card_house: pairs of leaning cards, a board over the tops of each floor ---- */

#define CARD_LONG 0.5 /* half sizes, m */
#define CARD_THIN 0.01
#define CARD_LEAN 0.35 /* from upright, rad: friction of 0.37 would just hold it */
#define CARD_SPACING 1.0

static void card_house_build(scene_run *run)
{
	int32_t floors = scene_count(run, "floors"), floor_index, k;
	double c = cos(CARD_LEAN), s = sin(CARD_LEAN);
	double high = CARD_LONG * c + CARD_THIN * s, wide = CARD_LONG * s + CARD_THIN * c, y = 0.0;
	run->friction = scene_value(run, "friction");
	scene_floor(run);
	for (floor_index = 0; floor_index < floors; ++floor_index) {
		int32_t pairs = floors - floor_index;
		double half = 0.5 * CARD_SPACING * (double)(pairs - 1);
		for (k = 0; k < pairs; ++k) {
			double x = CARD_SPACING * (double)k - half;
			scene_box(run, CN_BODY_DYNAMIC, x - wide, y + high, -CARD_LEAN, CARD_THIN, CARD_LONG);
			scene_box(run, CN_BODY_DYNAMIC, x + wide, y + high, CARD_LEAN, CARD_THIN, CARD_LONG);
		}
		y += 2.0 * high;
		if (pairs > 1)
			scene_box(run, CN_BODY_DYNAMIC, 0.0, y + CARD_THIN, 0.0, half + 0.2, CARD_THIN);
		y += 2.0 * CARD_THIN;
	}
}

static void card_house_observe(scene_run *run) { observe_sag(run, sag_of(run, run->item_count - 1), 0.2); }
static void card_house_finish(scene_run *run) { report_standing(run, "top_sag_m"); }

/* ---- plank: 10 m long and 5 cm thick, on two round points ---- */

static void plank_build(scene_run *run)
{
	scene_circle(run, CN_BODY_STATIC, -3.0, -0.1, 0.1);
	scene_circle(run, CN_BODY_STATIC, 3.0, -0.1, 0.1);
	scene_box(run, CN_BODY_DYNAMIC, 0.0, 0.025, 0.0, 5.0, 0.025);
}

static void plank_observe(scene_run *run)
{
	standing_state *state = run->state;
	state->tilt = scene_greater(state->tilt, fabs(scene_read(run, 0).angle));
	observe_sag(run, fabs(sag_of(run, 0)), 0.2);
}

static void plank_finish(scene_run *run)
{
	const standing_state *state = run->state;
	report_standing(run, "height_loss_m");
	scene_report(run, "tilt_max_rad", state->tilt);
	scene_report(run, "drift_x_m", fabs(scene_read(run, 0).x - run->items[0].x));
}

const scene_family structure_families[] = {
	{ "arch", "stones=31 inner=10 outer=11.6 seconds=10", sizeof(standing_state), arch_build, arch_observe, arch_finish },
	{ "card_house", "floors=5 friction=0.7 seconds=30", sizeof(standing_state), card_house_build, card_house_observe, card_house_finish },
	{ "plank", "seconds=10", sizeof(standing_state), plank_build, plank_observe, plank_finish },
};
const int32_t structure_family_count = (int32_t)(sizeof structure_families / sizeof *structure_families);
