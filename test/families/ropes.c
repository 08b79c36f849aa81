/*
 * test/families/ropes.c - ropes over pegs, bridges, loaded chains that swing.
 */
#include "families.h"

#include <math.h>

/* A rope of 10 to 40 capsules of 0.3 m lies over one to three fixed discs; loads of 1 to 2000 times a link's mass hang at
   its ends, the second one 0.1 to 1 times the first. Friction 0 to 2. */
static void build_rope_peg(scene *s)
{
	int32_t links = pick_int(s, 10, 40), pegs = pick_int(s, 1, 3), k, previous = WORLD, first = WORLD;
	double half = 0.15, radius = pick(s, 0.03, 0.08), link_mass, load = pick_log(s, 1.0, 2000.0), other = load * pick(s, 0.1, 1.0);
	double width = 0.6 * (double)(pegs - 1) + 0.5, size = pick(s, 0.2, 0.5);
	double start = -half * (double)links + pick(s, -0.5, 0.5) * half * (double)links;
	s->friction = pick(s, 0.0, 2.0);
	for (k = 0; k < pegs; ++k)
		add_disc(s, CN_BODY_STATIC, width * ((double)k - 0.5 * (double)(pegs - 1)), 12.0, 0.4);
	link_mass = 4.0 * half * radius + PI * radius * radius;
	s->group = chance(s, 0.5) ? -1 : 0; /* links among themselves */
	for (k = 0; k < links; ++k) {
		double x = start + 2.0 * half * (double)k;
		int32_t link;
		s->group = 0;
		link = add_capsule(s, CN_BODY_DYNAMIC, x + half, 12.4 + radius + 0.01, 0.0, half, radius);
		if (k == 0)
			first = link;
		else
			add_pin(s, previous, link, x, 12.4 + radius + 0.01);
		previous = link;
	}
	s->friction = pick(s, 0.0, 1.0);
	set_mass(s, load * link_mass, 4.0 * size * size);
	k = add_box(s, CN_BODY_DYNAMIC, start - size, 12.4 + radius + 0.01, 0.0, size, size);
	add_pin(s, first, k, start, 12.4 + radius + 0.01);
	set_mass(s, other * link_mass, 4.0 * size * size);
	k = add_box(s, CN_BODY_DYNAMIC, start + 2.0 * half * (double)links + size, 12.4 + radius + 0.01, 0.0, size, size);
	add_pin(s, previous, k, start + 2.0 * half * (double)links, 12.4 + radius + 0.01);
	s->density = 1.0;
	add_floor(s);
	s->seconds = 5.0;
}

/* 10 to 60 planks of 1 x 0.1 to 0.3 m, pinned along an arc of 0 to 2 x 0.7 rad; one to five boxes or discs of 1 to 1000 times a
   plank's mass fall on them from 0.2 to 3 m. */
static void build_bridge(scene *s)
{
	int32_t planks = pick_int_log(s, 10, 60), loads = pick_int(s, 1, 5), k, previous = WORLD;
	double half = pick(s, 0.02, 0.7), turn = 2.0 * half / (double)planks, radius = 0.5 / sin(0.5 * turn), thin = pick(s, 0.05, 0.15);
	double base = radius + 3.0, mass = 2.0 * thin * pick_log(s, 1.0, 1000.0), deep = radius * cos(0.5 * turn);
	s->friction = pick(s, 0.2, 1.0);
	for (k = 0; k < planks; ++k) {
		double at = -half + turn * (double)k, middle = at + 0.5 * turn;
		int32_t plank = add_box(s, CN_BODY_DYNAMIC, deep * sin(middle), base - deep * cos(middle), middle, 0.49, thin);
		add_pin(s, previous, plank, radius * sin(at), base - radius * cos(at));
		previous = plank;
	}
	add_pin(s, WORLD, previous, radius * sin(half), base - radius * cos(half));
	for (k = 0; k < loads; ++k) {
		double x = 1.5 * ((double)k - 0.5 * (double)(loads - 1)), y = 4.0 + radius * (1.0 - cos(half)) + pick(s, 0.2, 3.0);
		int round = chance(s, 0.3);
		y = fmin(y, 3.0 + thin + 0.6 + pick(s, 0.2, 3.0));
		y = fmax(y, base - sqrt(fmax(radius * radius - x * x, 0.0)) + thin + 0.8);
		set_mass(s, mass, round ? PI * 0.25 : 1.0);
		if (round)
			add_disc(s, CN_BODY_DYNAMIC, x, y, 0.5);
		else
			add_box(s, CN_BODY_DYNAMIC, x, y, 0.0, 0.5, 0.5);
	}
}

/* 2 to 30 rods of 0.3 to 1 m, pinned in a row to the world, a load of 1 to 2000 times a rod's mass at the end; released level
   or at up to 0.6 rad from it, turning or not. Half of the seeds last 4 s, one in eight 20 s. */
static void build_chain(scene *s)
{
	int32_t links = pick_int_log(s, 2, 30), k, previous = WORLD, load;
	double half = pick(s, 0.15, 0.5), thin = pick(s, 0.02, 0.05), angle = pick(s, -0.6, 0.6), ux = cos(angle), uy = sin(angle), y = 30.0;
	double mass = 4.0 * half * thin * pick_log(s, 1.0, 2000.0), length = 2.0 * half * (double)links, radius = pick(s, 0.1, 0.5);
	int round = chance(s, 0.5);
	s->group = -1;
	for (k = 0; k < links; ++k) {
		double at = 2.0 * half * (double)k;
		int32_t link = add_box(s, CN_BODY_DYNAMIC, (at + half) * ux, y + (at + half) * uy, angle, half, thin);
		add_pin(s, previous, link, at * ux, y + at * uy);
		previous = link;
	}
	set_mass(s, mass, round ? PI * radius * radius : 4.0 * radius * radius);
	if (round)
		load = add_disc(s, CN_BODY_DYNAMIC, length * ux, y + length * uy, radius);
	else
		load = add_box(s, CN_BODY_DYNAMIC, length * ux, y + length * uy, angle, radius, radius);
	add_pin(s, previous, load, length * ux, y + length * uy);
	if (chance(s, 0.5))
		s->seconds = chance(s, 0.25) ? 20.0 : 8.0;
}

const family rope_families[] = {
	{ "rope_peg", build_rope_peg, 0 },
	{ "bridge", build_bridge, 0 },
	{ "chain", build_chain, 0 },
};
const int32_t rope_family_count = FAMILY_COUNT(rope_families);
