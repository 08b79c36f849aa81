/*
 * test/families/heaps.c - heaps of thin and of mixed bodies, see-saws and crushers, bodies thrown at walls and piles.
 */
#include "families.h"

#include <math.h>

static double add_thin(scene *s, double x, double y, double half, double aspect, double angle)
{
	double thin = fmax(half / aspect, 0.003), high = half * fabs(sin(angle)) + thin;
	if (chance(s, 0.5))
		add_box(s, CN_BODY_DYNAMIC, x, y + high, angle, half, thin);
	else
		add_capsule(s, CN_BODY_DYNAMIC, x, y + high, angle, half - thin, thin);
	return 2.0 * high;
}

/* 15 to 60 boxes and capsules of 0.5 to 2.8 m with an aspect of 1:4 to 1:200 fall into a pit in pairs, two thirds of them nearly
   level; friction 0 to 2. */
static void build_thin_heap(scene *s)
{
	int32_t count = pick_int_log(s, 15, 60), k;
	double aspect_max = pick_log(s, 8.0, 200.0), y = 0.5, next_y = 0.5;
	s->friction = pick(s, 0.0, 2.0);
	add_pit(s, 3.0);
	for (k = 0; k < count; ++k) {
		double half = pick(s, 0.25, 1.4), aspect = pick_log(s, 4.0, aspect_max), angle = chance(s, 0.67) ? pick(s, -0.1, 0.1) : pick(s, -PI, PI), jitter = pick(s, -0.05, 0.05);
		double high = add_thin(s, (k % 2 == 0 ? -1.5 : 1.5) + jitter, y, half, aspect, angle);
		next_y = fmax(next_y, y + high + 0.02);
		if (k % 2 == 1)
			y = next_y;
	}
}

static void add_lump(scene *s, double x, double y, double size, double mass)
{
	int32_t kind = pick_int(s, 0, 2), corners = pick_int(s, 3, 8);
	double angle = pick(s, -PI, PI);
	if (kind == 0) {
		set_mass(s, mass, 4.0 * size * size * 0.7);
		add_box(s, CN_BODY_DYNAMIC, x, y, angle, size, 0.7 * size);
	} else if (kind == 1) {
		set_mass(s, mass, PI * size * size);
		add_disc(s, CN_BODY_DYNAMIC, x, y, size);
	} else {
		set_mass(s, mass, 0.5 * (double)corners * size * size * sin(2.0 * PI / (double)corners));
		add_regular(s, CN_BODY_DYNAMIC, x, y, angle, size, corners);
	}
}

/* 15 to 80 boxes, discs and polygons of 0.15 to 0.5 m fall into a pit; masses up to 1:2 to 1:1e6, drawn by their logarithm;
   friction 0 to 2. */
static void build_mixed_heap(scene *s)
{
	int32_t count = pick_int_log(s, 15, 80), k;
	double ratio = pick_log(s, 2.0, 1e6);
	s->friction = pick(s, 0.0, 2.0);
	add_pit(s, 3.4);
	for (k = 0; k < count; ++k) {
		double size = pick(s, 0.15, 0.5), jitter = pick(s, -0.05, 0.05), mass = pick_log(s, 1.0, ratio);
		add_lump(s, 1.35 * (double)(k % 5 - 2) + jitter, 0.8 + 1.3 * (double)(k / 5), size, mass);
	}
}

/* A plank of 4 to 8 m on a pin; 1 to 6 boxes lie on one end, and a body of 1 to 1000 times their mass lands on the other from
   1 to 8 m. */
static void see_saw(scene *s)
{
	double half = pick(s, 2.0, 4.0), height = pick(s, 0.5, 1.0), mass = pick_log(s, 1.0, 1000.0), drop = pick(s, 1.0, 8.0);
	double lean = asin((height - 0.05) / half), c = cos(lean), sine = sin(lean);
	int32_t boxes = pick_int(s, 1, 6), k, plank;
	add_floor(s);
	plank = add_box(s, CN_BODY_DYNAMIC, 0.0, height + 0.02, lean, half, 0.05);
	add_pin(s, WORLD, plank, 0.0, height + 0.02);
	for (k = 0; k < boxes; ++k) {
		double along = -half + 0.35 + 0.6 * (double)(k % 2), out = 0.3 + 0.5 * (double)(k / 2);
		add_box(s, CN_BODY_DYNAMIC, along * c - out * sine, height + 0.03 + along * sine + out * c, lean, 0.24, 0.24);
	}
	set_mass(s, mass * 0.23 * (double)boxes, 1.0);
	add_box(s, CN_BODY_DYNAMIC, half - 0.5, 2.0 * height + 0.6 + drop, pick(s, -0.5, 0.5), 0.5, 0.5);
}

static int32_t add_member(scene *s, double x, double y, double size, double mass)
{
	if (chance(s, 0.5)) {
		set_mass(s, mass, PI * size * size);
		return add_disc(s, CN_BODY_DYNAMIC, x, y, size);
	}
	set_mass(s, mass, 3.2 * size * size);
	return add_box(s, CN_BODY_DYNAMIC, x, y, 0.0, size, 0.8 * size);
}

/* Rows of two to six discs and boxes of 0.05 to 1.2 m, joined by pins, welds, rods or any of these, fall into a pit: a single row or three
   to ten; masses up to 1:2 to 1:1e7, drawn by their logarithm, in a third of the seeds heavy and light in turn. */
static void build_joined_masses(scene *s)
{
	int32_t rows = chance(s, 0.3) ? 1 : pick_int(s, 3, 10), kind = pick_int(s, 0, 3), turns = chance(s, 0.33), row, k;
	double ratio = pick_log(s, 2.0, 1e7), least = 10.0 / sqrt(ratio), y = 1.0;
	s->friction = pick(s, 0.0, 1.0);
	add_pit(s, 12.0);
	for (row = 0; row < rows; ++row) {
		int32_t count = pick_int(s, 2, 6), last = WORLD;
		double x = -9.0 + pick(s, 0.0, 4.0), size = 0.0;
		y += 1.2;
		for (k = 0; k < count; ++k) {
			double next = pick_log(s, 0.05, 1.2), mass = least * (turns ? k % 2 ? 1.0 : ratio : pick_log(s, 1.0, ratio)), before = x;
			int32_t joint = kind < 3 ? kind : pick_int(s, 0, 2), member;
			x += k ? 1.02 * (size + next) : 0.0;
			if (x > 10.5)
				break;
			member = add_member(s, x, y, next, mass);
			if (k && joint == 0)
				add_pin(s, last, member, before + 1.01 * size, y);
			else if (k && joint == 1)
				add_weld(s, last, member, before + 1.01 * size, y);
			else if (k)
				add_rod(s, last, member, before, y, x, y);
			last = member;
			size = next;
		}
		y += 1.3;
	}
	s->seconds = 12.0;
}

/* A slab on a slider with a motor of 10 to 1000 times the weight presses a heap of 5 to 25 lumps against the floor at
   0.2 to 2 m/s; or a slab of 10 to 1e5 times their mass falls on them. */
static void crusher(scene *s)
{
	int32_t lumps = pick_int(s, 5, 25), driven = chance(s, 0.5), k, slab;
	double height = 1.5 + 1.05 * (double)(lumps / 5), mass = pick_log(s, 10.0, driven ? 1000.0 : 1e5) * 0.5 * (double)lumps;
	add_pit(s, 2.8);
	for (k = 0; k < lumps; ++k) {
		double jitter = pick(s, -0.05, 0.05), size = pick(s, 0.2, 0.38);
		add_lump(s, 1.05 * (double)(k % 5 - 2) + jitter, 0.55 + 1.05 * (double)(k / 5), size, 0.5);
	}
	set_mass(s, mass, 2.7 * 2.0 * 0.6);
	slab = add_box(s, CN_BODY_DYNAMIC, 0.0, height + 0.5, 0.0, 2.7, 0.3);
	s->motor_speed = -pick(s, 0.2, 2.0);
	s->motor_max = driven ? mass * GRAVITY * 2.0 : 0.0;
	add_slider(s, WORLD, slab, 0.0, height + 0.5, 0.0, 1.0, 1.0, -1.0);
	if (driven)
		s->flags |= SCENE_NO_ENERGY;
	s->motor_max = 0.0;
}

/* See-saws with a body that lands on them, and crushers; friction 0.1 to 1.5. */
static void build_press(scene *s)
{
	s->friction = pick(s, 0.1, 1.5);
	if (chance(s, 0.5))
		see_saw(s);
	else
		crusher(s);
}

/* Walls of 3 to 10 courses of boxes of 0.5 m, 1 to 6 wide, or heaps of 10 to 40 lumps; one to three bodies of 0.1 to 1000 times a
   box's mass fly into them at 5 to 60 m/s. Restitution 0 to 0.5. */
static void build_thrown(scene *s)
{
	int32_t rows = pick_int(s, 3, 10), columns = pick_int(s, 1, 6), heap = chance(s, 0.4), count = pick_int(s, 10, 40), shots = pick_int(s, 1, 3), i, k;
	s->friction = pick(s, 0.2, 1.0);
	add_floor(s);
	for (k = 0; heap && k < count; ++k) {
		double size = pick(s, 0.15, 0.3), mass = pick_log(s, 0.1, 2.0);
		add_lump(s, 0.75 * (double)(k % 6), 0.38 + 0.75 * (double)(k / 6), size, mass);
	}
	s->density = 1.0;
	for (i = 0; !heap && i < rows; ++i)
		for (k = 0; k < columns; ++k)
			add_box(s, CN_BODY_DYNAMIC, 0.5 * (double)k, 0.25 + 0.5 * (double)i, 0.0, 0.25, 0.25);
	s->restitution = pick(s, 0.0, 0.5);
	for (k = 0; k < shots; ++k) {
		double size = pick(s, 0.15, 0.4), mass = 0.25 * pick_log(s, 0.1, 1000.0), speed = pick_log(s, 5.0, 60.0), y = pick(s, 0.5, 0.4 * (double)rows + 0.5);
		int32_t shot;
		set_mass(s, mass, PI * size * size);
		shot = add_disc(s, CN_BODY_DYNAMIC, -2.0 - 1.5 * (double)k, y, size);
		set_velocity(s, shot, speed, pick(s, 0.0, 2.0), 0.0);
	}
}

const family heap_families[] = {
	{ "thin_heap", build_thin_heap, 0 },
	{ "mixed_heap", build_mixed_heap, 0 },
	{ "joined_masses", build_joined_masses, 0 },
	{ "press", build_press, 0 },
	{ "thrown", build_thrown, 0 },
};
const int32_t heap_family_count = FAMILY_COUNT(heap_families);
