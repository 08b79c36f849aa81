/*
 * test/families/areas.c - structures in areas: afloat, in a wind, where gravity is another.
 */
#include "families.h"

#include <math.h>

#define SURFACE_M 6.0 /* height of the water */

/* ---- afloat: 1 to 8 rafts, side by side or chained, with 0 to 6 boxes or discs each, some far heavier; some stand on the ground ---- */

static void add_load(scene *s, double x, double y, double half_x, double heavy)
{
	int32_t count = pick_int(s, 0, 6), kind = pick_int(s, 0, 2), k;
	for (k = 0; k < count; ++k) {
		double half_y = pick(s, 0.1, 0.3), lean = pick(s, -0.05, 0.05);
		s->density = 0.1 * pick_log(s, 1.0, heavy);
		if (kind < 2)
			add_box(s, CN_BODY_DYNAMIC, x + lean, y + half_y, 0.0, kind == 0 ? half_y : 0.6 * half_x, half_y);
		else
			add_disc(s, CN_BODY_DYNAMIC, x + lean, y + half_y, half_y);
		y += 2.0 * half_y;
	}
}

static void build_afloat(scene *s)
{
	int32_t rafts = pick_int(s, 1, 8), chained = chance(s, 0.4), sunk = chance(s, 0.2), k, before = WORLD;
	double half_x = pick(s, 0.5, 1.5), half_y = half_x * pick_log(s, 0.05, 0.5), gap = pick(s, 0.05, 0.5), heavy = pick_log(s, 1.0, 30.0);
	double damping = chance(s, 0.5) ? pick_log(s, 0.1, 10.0) : 0.0, drag = chance(s, 0.5) ? pick_log(s, 0.1, 3.0) : 0.0;
	s->friction = pick(s, 0.1, 1.0);
	for (k = 0; k < rafts; ++k) {
		double x = (double)k * (2.0 * half_x + gap), y = sunk ? half_y : SURFACE_M + half_y * pick(s, -0.5, 1.0);
		int32_t raft;
		s->density = sunk ? 1.5 : pick(s, 0.1, 0.7);
		raft = add_box(s, CN_BODY_DYNAMIC, x, y, 0.0, half_x, half_y);
		if (chained && before != WORLD) {
			if (chance(s, 0.5))
				add_pin(s, before, raft, x - half_x - 0.5 * gap, y);
			else
				add_rod(s, before, raft, x - half_x - gap, s->bodies[before].y, x - half_x, y);
		}
		before = raft;
		add_load(s, x, y + half_y, half_x, heavy);
	}
	s->density = 1.0;
	add_pit(s, 8.0 * (2.0 * half_x + gap) + 1.0);
	add_area(s, 0.0, 0.5 * SURFACE_M, 60.0, 0.5 * SURFACE_M, 1.0, drag, damping, chance(s, 0.3) ? pick(s, -2.0, 2.0) : 0.0, 0.0);
	s->flags |= SCENE_NO_ENERGY;
}

/* ---- windy: towers, walls, cloths and hanging boards in a wind, or where gravity is weaker, or lifts ---- */

static void add_tower(scene *s, double x, double half_x)
{
	int32_t boxes = pick_int(s, 1, 8), k;
	double y = 0.0;
	for (k = 0; k < boxes; ++k) {
		double half_y = half_x * pick(s, 0.3, 1.0);
		add_box(s, CN_BODY_DYNAMIC, x, y + half_y, 0.0, half_x, half_y);
		y += 2.0 * half_y;
	}
}

static void add_banner(scene *s, double x, double y)
{
	int32_t links = pick_int(s, 2, 12), k, before = WORLD;
	for (k = 0; k < links; ++k) {
		int32_t link = add_box(s, CN_BODY_DYNAMIC, x, y - 0.3 - 0.6 * (double)k, 0.0, 0.05, 0.3);
		add_pin(s, before, link, x, y - 0.6 * (double)k);
		before = link;
	}
	if (chance(s, 0.5)) {
		double radius = pick(s, 0.2, 0.6);
		int32_t ball;
		s->density = pick_log(s, 1.0, 100.0);
		ball = add_disc(s, CN_BODY_DYNAMIC, x, y - 0.6 * (double)links - radius, radius);
		add_pin(s, before, ball, x, y - 0.6 * (double)links);
		s->density = 1.0;
	}
}

static void build_windy(scene *s)
{
	int32_t things = pick_int(s, 1, 8), k;
	double wind = pick(s, -20.0, 20.0), drag = pick_log(s, 0.001, 0.3), lift = chance(s, 0.3) ? pick(s, -10.0, 12.0) : 0.0;
	s->friction = pick(s, 0.2, 1.0);
	for (k = 0; k < things; ++k) {
		double half_x = pick(s, 0.2, 0.5);
		if (chance(s, 0.6))
			add_tower(s, 2.5 * (double)k, half_x);
		else
			add_banner(s, 2.5 * (double)k, pick(s, 8.0, 10.0));
	}
	add_floor(s);
	add_area(s, 10.0, 5.0, chance(s, 0.5) ? 40.0 : 8.0, chance(s, 0.5) ? 10.0 : 3.0, 0.0, drag, 0.0, wind, lift);
	s->flags |= SCENE_NO_ENERGY;
}

const family area_families[] = {
	{ "afloat", build_afloat, 0 },
	{ "windy", build_windy, 0 },
};
const int32_t area_family_count = FAMILY_COUNT(area_families);
