/*
 * test/families/structures.c - masonry and other structures that ought to stand: arches, walls, card houses, towers,
 * pyramids of discs.
 */
#include "families.h"

#include <math.h>

/* Half circle of 5 to 41 wedges, thickness 0.15 to 0.3 of the inner radius of 2 to 10 m (0.11 just stands by itself), joints
   even or moved by up to 30% of a wedge; friction 0.6 to 1; 0 to 4 boxes of 0.2 to 2 times a wedge's mass on the crown. */
static void build_arch(scene *s)
{
	int32_t stones = 2 * pick_int(s, 2, 20) + 1, boxes = pick_int(s, 0, 4), k, c;
	double inner = pick(s, 2.0, 10.0), outer = inner * (1.0 + pick(s, 0.15, 0.3)), uneven = chance(s, 0.5) ? 0.3 : 0.0, from = 0.0;
	double wedge = 0.5 * PI * (outer * outer - inner * inner) / (double)stones, height = outer, size;
	s->friction = pick(s, 0.6, 1.0);
	add_floor(s);
	for (k = 0; k < stones; ++k) {
		double to = k + 1 == stones ? PI : PI * ((double)(k + 1) + pick(s, -0.5, 0.5) * uneven) / (double)stones, middle = 0.5 * (from + to);
		double x = 0.5 * (inner + outer) * cos(middle), y = 0.5 * (inner + outer) * sin(middle);
		double points[4][2] = { { inner * cos(from), inner * sin(from) }, { outer * cos(from), outer * sin(from) }, { outer * cos(to), outer * sin(to) },
			{ inner * cos(to), inner * sin(to) } };
		for (c = 0; c < 4; ++c) {
			points[c][0] -= x;
			points[c][1] -= y;
		}
		add_polygon(s, CN_BODY_DYNAMIC, x, y, 0.0, (const double(*)[2])points, 4);
		from = to;
	}
	size = 0.25 * sqrt(wedge);
	height = outer;
	for (k = 0; k < boxes; ++k) {
		set_mass(s, wedge * pick_log(s, 0.2, 2.0), 4.0 * size * size);
		add_box(s, CN_BODY_DYNAMIC, 0.0, height + size, 0.0, size, size);
		height += 2.0 * size;
	}
	s->seconds = 5.0;
}

/* A wall of 3 to 12 courses of bricks 1 x 0.5 in running bond, 2 to 10 long, or stacks of 3 to 20 boxes; the top may bear 1 to 100
   times a brick. Friction 0.44 to 1. */
static void build_wall(scene *s)
{
	int32_t courses = pick_int(s, 3, 12), length = pick_int(s, 2, 10), stack = chance(s, 0.3), i, k;
	double load = chance(s, 0.5) ? pick_log(s, 1.0, 100.0) : 0.0;
	s->friction = pick(s, 0.44, 1.0);
	add_floor(s);
	if (stack) {
		length = 1;
		courses = pick_int(s, 3, 20);
	}
	for (i = 0; i < courses; ++i) {
		double y = 0.25 + 0.5 * (double)i, aside = !stack && i % 2 == 1 ? 0.5 : 0.0;
		for (k = 0; k < length; ++k) {
			double x = (double)k - 0.5 * (double)(length - 1) + aside, half = 0.5;
			if (aside > 0.0 && k + 1 == length) { /* two half bricks at the ends */
				add_box(s, CN_BODY_DYNAMIC, -0.5 * (double)length + 0.25, y, 0.0, 0.25, 0.25);
				x -= 0.25;
				half = 0.25;
			}
			add_box(s, CN_BODY_DYNAMIC, x + (stack ? pick(s, -0.02, 0.02) : 0.0), y, 0.0, half, 0.25);
		}
	}
	set_mass(s, load * 0.5, 0.5);
	if (load > 0.0)
		add_box(s, CN_BODY_DYNAMIC, 0.0, 0.25 + 0.5 * (double)courses, 0.0, 0.5, 0.25);
}

/* Houses of 2 to 6 floors: pairs of cards 1 x 0.01 to 0.03 that lean at 0.25 to 0.38 rad, a board over the tops of each
   floor; friction from 0.25 above what just holds the lean, at most 1. */
static void build_card_house(scene *s)
{
	int32_t floors = pick_int(s, 2, 6), floor_index, k;
	double lean = pick(s, 0.25, 0.38), thin = pick(s, 0.005, 0.015), half_card = 0.5, y = 0.0;
	double high = half_card * cos(lean) + thin * sin(lean), wide = half_card * sin(lean) + thin * cos(lean), spacing = 2.0 * (wide + half_card * sin(lean)) + 0.1;
	s->friction = pick(s, fmax(0.44, tan(lean) + 0.25), 1.0);
	add_floor(s);
	for (floor_index = 0; floor_index < floors; ++floor_index) {
		int32_t pairs = floors - floor_index;
		double half = 0.5 * spacing * (double)(pairs - 1);
		for (k = 0; k < pairs; ++k) {
			double x = spacing * (double)k - half;
			add_box(s, CN_BODY_DYNAMIC, x - wide, y + high, -lean, thin, half_card);
			add_box(s, CN_BODY_DYNAMIC, x + wide, y + high, lean, thin, half_card);
		}
		y += 2.0 * high;
		if (pairs > 1)
			add_box(s, CN_BODY_DYNAMIC, 0.0, y + thin, 0.0, half + 0.2, thin);
		y += 2.0 * thin;
	}
}

/* A tower of 5 to 20 boxes, each moved to one side by a share of what just stands: the centre of all above a box stays over it.
   The share is 0.3 to 0.95; friction 0.44 to 1. */
static void build_tower(scene *s)
{
	int32_t boxes = pick_int(s, 5, 20), k;
	double half_x = pick(s, 0.3, 1.0), half_y = pick(s, 0.1, 0.4), share = pick(s, 0.3, 0.95), x = 0.0;
	s->friction = pick(s, 0.44, 1.0);
	add_floor(s);
	for (k = 0; k < boxes; ++k) {
		/* From the top down box k may overhang by half_x / k; from the ground up that is box boxes - k. */
		add_box(s, CN_BODY_DYNAMIC, x, half_y * (2.0 * (double)k + 1.0), 0.0, half_x, half_y);
		x += share * half_x / (double)(boxes - k);
	}
}

/* Discs of radius 0.3 to 0.6 in a pyramid of 3 to 12 rows between two stops; friction 0.44 to 1. */
static void build_disc_pyramid(scene *s)
{
	int32_t base = pick_int(s, 3, 12), i, k;
	double radius = pick(s, 0.3, 0.6), edge;
	s->friction = pick(s, 0.44, 1.0);
	add_floor(s);
	edge = radius * (double)base;
	add_box(s, CN_BODY_STATIC, -edge - 0.5, radius, 0.0, 0.5, radius);
	add_box(s, CN_BODY_STATIC, edge + 0.5, radius, 0.0, 0.5, radius);
	for (i = 0; i < base; ++i)
		for (k = 0; k < base - i; ++k)
			add_disc(s, CN_BODY_DYNAMIC, radius * (double)(2 * k + i + 1) - edge, radius * (1.0 + sqrt(3.0) * (double)i), radius);
}

/* 1 to 4 towers of 4 to 14 boxes, whose tops are pushed at 0.1 to 0.6 m/s: they sway, and come to rest. A third of them bounces (restitution
   0.1 to 0.9). 15 s: what sways more and more falls late. */
static void build_pushed_tower(scene *s)
{
	int32_t towers = pick_int(s, 1, 4), kind = pick_int(s, 0, 5), tower, k;
	s->seconds = 15.0;
	s->friction = 0.6;
	s->restitution = kind < 2 ? pick(s, 0.1, 0.9) : 0.0;
	add_floor(s);
	for (tower = 0; tower < towers; ++tower) {
		int32_t boxes = pick_int(s, 4, 14), top = 0;
		double half_x = pick(s, 0.2, 0.45), half_y = half_x * pick(s, 0.5, 1.0), push = pick(s, 0.1, 0.6), y = 0.0;
		for (k = 0; k < boxes; ++k) {
			double lean = pick(s, -0.02, 0.02);
			top = add_box(s, CN_BODY_DYNAMIC, 5.0 * (double)tower + lean, y + half_y, 0.0, half_x, half_y);
			y += 2.0 * half_y;
		}
		set_velocity(s, top, push, 0.0, 0.0);
	}
}

/* Houses of 1 to 4 floors whose cards, 1 x 0.04 to 0.08, stand in the corners of boards that just cover them; they lean at 0.25 to 0.42 rad and
   begin with overlaps of a millimetre. 1 to 5 houses; friction 0.6 to 1. */
static void build_card_houses(scene *s)
{
	int32_t houses = pick_int(s, 1, 5), floors = pick_int(s, 1, 4), house, floor_index, k;
	double thin = pick(s, 0.02, 0.04), lean = pick(s, 0.25, 0.42), half_card = 0.5;
	double high = half_card * cos(lean) + thin * sin(lean), wide = 2.0 * (half_card * sin(lean) + thin * cos(lean));
	s->seconds = 6.0;
	s->friction = pick(s, 0.6, 1.0);
	add_floor(s);
	for (house = 0; house < houses; ++house) {
		double y = 0.0;
		for (floor_index = 0; floor_index < floors; ++floor_index) {
			int32_t pairs = floors - floor_index;
			for (k = 0; k < pairs; ++k) {
				double x = 6.0 * (double)house + 2.0 * wide * ((double)k - 0.5 * (double)(pairs - 1));
				add_box(s, CN_BODY_DYNAMIC, x - 0.501 * wide, y + high, -lean, thin, half_card);
				add_box(s, CN_BODY_DYNAMIC, x + 0.501 * wide, y + high, lean, thin, half_card);
			}
			y += 2.0 * high;
			for (k = 0; k + 1 < pairs; ++k)
				add_box(s, CN_BODY_DYNAMIC, 6.0 * (double)house + 2.0 * wide * ((double)k - 0.5 * (double)(pairs - 2)), y + thin, 0.0, wide, thin);
			y += 2.0 * thin;
		}
	}
}

const family structure_families[] = {
	{ "arch", build_arch, SCENE_STANDS },
	{ "wall", build_wall, SCENE_STANDS },
	{ "card_house", build_card_house, SCENE_STANDS },
	{ "tower", build_tower, SCENE_STANDS },
	{ "disc_pyramid", build_disc_pyramid, SCENE_STANDS },
	{ "pushed_tower", build_pushed_tower, SCENE_STANDS },
	{ "card_houses", build_card_houses, SCENE_STANDS },
};
const int32_t structure_family_count = FAMILY_COUNT(structure_families);
