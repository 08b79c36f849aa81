/*
 * test/families/ropes.c - ropes over pegs, bridges, loaded chains that swing, loaded chains that fall in a heap.
 */
#include "families.h"

#include <math.h>

static void hang_load(scene *s, int32_t link, double x, double y, double side, double size, double mass)
{
	int32_t load;
	set_mass(s, mass, 4.0 * size * size);
	load = add_box(s, CN_BODY_DYNAMIC, x + side * size, y, 0.0, size, size);
	add_pin(s, link, load, x, y);
}

/* A rope of 12 to 40 capsules of 0.3 m lies level over one to three fixed discs; loads of 1 to 2000 times a link's mass hang at its
   ends, the second one 0.1 to 1 times the first. Friction of the rope 0 to 2. */
static void build_rope_peg(scene *s)
{
	int32_t pegs = pick_int(s, 1, 3), links, k, previous = 0, first = 0;
	double half = 0.15, radius = pick(s, 0.03, 0.08), width = 1.1 * (double)(pegs - 1), size = pick(s, 0.2, 0.5), y = 12.41 + radius;
	double load = pick_log(s, 1.0, 2000.0), other = load * pick(s, 0.1, 1.0), mass = 4.0 * half * radius + PI * radius * radius, room, start;
	links = pick_int(s, 12 + 4 * (pegs - 1), 40);
	room = half * (double)links - 0.5 * width - 0.5; /* that the rope's middle may be aside */
	start = -half * (double)links + pick(s, -0.8, 0.8) * room;
	s->friction = pick(s, 0.0, 2.0);
	for (k = 0; k < pegs; ++k)
		add_disc(s, CN_BODY_STATIC, 1.1 * (double)k - 0.5 * width, 12.0, 0.4);
	for (k = 0; k < links; ++k) {
		double x = start + 2.0 * half * (double)k;
		int32_t link = add_capsule(s, CN_BODY_DYNAMIC, x + half, y, 0.0, half, radius);
		if (k == 0)
			first = link;
		else
			add_pin(s, previous, link, x, y);
		previous = link;
	}
	s->friction = pick(s, 0.0, 1.0);
	hang_load(s, first, start, y, -1.0, size, load * mass);
	hang_load(s, previous, start + 2.0 * half * (double)links, y, 1.0, size, other * mass);
	s->density = 1.0;
	add_floor(s);
	s->seconds = 5.0;
}

/* 10 to 60 planks of 1 x 0.1 to 0.3 m, pinned along an arc of 0 to 2 x 0.7 rad; one to five boxes or discs of 1 to 1000 times a
   plank's mass fall on them from 0.2 to 3 m; the lowest plank is 3 m over the floor. Friction 0.2 to 1. */
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
		double x = 1.5 * ((double)k - 0.5 * (double)(loads - 1)), y = base - sqrt(fmax(radius * radius - x * x, 0.0)) + thin + pick(s, 0.9, 3.7);
		int round = chance(s, 0.3);
		set_mass(s, mass, round ? PI * 0.25 : 1.0);
		if (round)
			add_disc(s, CN_BODY_DYNAMIC, x, y, 0.5);
		else
			add_box(s, CN_BODY_DYNAMIC, x, y, 0.0, 0.5, 0.5);
	}
	s->density = 1.0;
	add_floor(s);
}

/* 15 to 100 planks of 1 x 0.25 m in a straight row between two walls, or two kinematic bodies; pins plain, with friction (a motor of speed 0),
   driven, with limits, or every third a weld; one to eight discs of 0.5 to 5 times a plank's mass fall on them. Half of the seeds last 8 s, others 20 s:
   what touches it is gone then, and some rest on it. */
static void build_taut_bridge(scene *s)
{
	int32_t planks = pick_int_log(s, 15, 100), loads = pick_int(s, 1, 8), kind = pick_int(s, 0, 4), ends = chance(s, 0.3), k, previous = WORLD, last = WORLD;
	double left = -0.5 * (double)planks, mass = 0.25 * pick_log(s, 0.5, 5.0), torque = pick_log(s, 1.0, 2000.0);
	s->friction = pick(s, 0.2, 1.0);
	s->motor_speed = kind == 2 ? pick(s, -0.3, 0.3) : 0.0;
	s->flags |= kind == 1 || kind == 2 ? (uint32_t)SCENE_NO_ENERGY : 0u;
	if (ends) {
		previous = add_box(s, CN_BODY_KINEMATIC, left - 0.6, 20.0, 0.0, 0.5, 0.5);
		last = add_box(s, CN_BODY_KINEMATIC, -left + 0.6, 20.0, 0.0, 0.5, 0.5);
	}
	for (k = 0; k <= planks; ++k) {
		int32_t next = k < planks ? add_box(s, CN_BODY_DYNAMIC, left + (double)k + 0.5, 20.0, 0.0, 0.49, 0.125) : previous, a = k < planks ? previous : last;
		s->motor_max = kind == 1 || kind == 2 ? 0.01 * torque : 0.0;
		if (kind == 4 && k % 3 == 1)
			add_weld(s, a, next, left + (double)k, 20.0);
		else if (kind == 3)
			add_pin_limited(s, a, next, left + (double)k, 20.0, -0.5, 0.5);
		else
			add_pin(s, a, next, left + (double)k, 20.0);
		s->motor_max = 0.0;
		previous = next;
	}
	set_mass(s, mass, PI * 0.25);
	for (k = 0; k < loads; ++k)
		add_disc(s, CN_BODY_DYNAMIC, left + (double)planks * (0.2 + 0.6 * (double)k / (double)loads), 22.0 + 2.0 * (double)k, 0.5);
	s->density = 1.0;
	add_floor(s);
	s->seconds = chance(s, 0.5) ? 8.0 : 20.0;
}

/* 2 to 30 rods of 0.3 to 1 m, pinned in a row to the world, a load of 1 to 2000 times a rod's mass at the end; released level
   or at up to 0.6 rad from it, and let go. Half of the seeds last 4 s, others 8, 20 and 60 s. */
static void build_chain(scene *s)
{
	int32_t links = pick_int_log(s, 2, 30), k, previous = WORLD, load;
	double half = pick(s, 0.15, 0.5), thin = pick(s, 0.02, 0.05), angle = pick(s, -0.6, 0.6), ux = cos(angle), uy = sin(angle), y = 30.0;
	double mass = 4.0 * half * thin * pick_log(s, 1.0, 2000.0), length = 2.0 * half * (double)links, radius = pick(s, 0.1, 0.5);
	int round = chance(s, 0.5), lasting = pick_int(s, 0, 19);
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
	s->seconds = lasting == 0 ? 60.0 : lasting < 4 ? 20.0 : lasting < 10 ? 8.0 : 4.0;
}

static void add_dropped_chain(scene *s, double x, double y, int32_t links, double ratio)
{
	double half = pick(s, 0.1, 0.25), thin = pick(s, 0.04, 0.08), angle = pick(s, -0.6, 0.6), ux = cos(angle), uy = sin(angle), size = pick(s, 0.12, 0.3);
	double mass = 4.0 * half * thin * ratio, end = 2.0 * half * (double)links;
	int32_t round = chance(s, 0.5), k, previous = 0, load;
	s->density = 1.0;
	for (k = 0; k < links; ++k) {
		double at = 2.0 * half * (double)k - 0.5 * end;
		int32_t link = add_box(s, CN_BODY_DYNAMIC, x + (at + half) * ux, y + (at + half) * uy, angle, half, thin);
		if (k > 0)
			add_pin(s, previous, link, x + at * ux, y + at * uy);
		previous = link;
	}
	set_mass(s, mass, round ? PI * size * size : 4.0 * size * size);
	x += 0.5 * end * ux;
	y += 0.5 * end * uy;
	load = round ? add_disc(s, CN_BODY_DYNAMIC, x + size * ux, y + size * uy, size) : add_box(s, CN_BODY_DYNAMIC, x + size * ux, y + size * uy, angle, size, size);
	add_pin(s, previous, load, x, y);
}

/* 2 to 10 chains of 4 to 12 rods of 0.2 to 0.5 m, each with a load of 1 to 100 times a rod's mass at one end, fall on each other:
   onto the floor or into a pit; friction 0 to 1. */
static void build_chain_heap(scene *s)
{
	int32_t chains = pick_int(s, 2, 10), links = pick_int(s, 4, 12), k;
	double ratio = pick_log(s, 1.0, 100.0);
	s->friction = pick(s, 0.0, 1.0);
	if (chance(s, 0.5))
		add_pit(s, 4.0);
	else
		add_floor(s);
	for (k = 0; k < chains; ++k) {
		double jitter = pick(s, -0.5, 0.5);
		add_dropped_chain(s, jitter, 3.0 + 4.5 * (double)k, links, ratio);
	}
	s->seconds = 4.0;
}

const family rope_families[] = {
	{ "rope_peg", build_rope_peg, 0 },
	{ "bridge", build_bridge, 0 },
	{ "taut_bridge", build_taut_bridge, 0 },
	{ "chain", build_chain, 0 },
	{ "chain_heap", build_chain_heap, 0 },
};
const int32_t rope_family_count = FAMILY_COUNT(rope_families);
