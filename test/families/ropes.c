/*
 * test/families/ropes.c - ropes over pegs, bridges, loaded chains that swing, loaded chains that fall in a heap, ropes that are
 * distance limits.
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

/* ---- ropes that are distance limits ---- */

static int32_t add_bead(scene *s, int32_t round, double x, double y, double size)
{
	return round ? add_disc(s, CN_BODY_DYNAMIC, x, y, size) : add_box(s, CN_BODY_DYNAMIC, x, y, 0.0, size, size);
}

/* Beads of 1 kg on ropes of 0.3 to 1 m, from `from` at (x, y) on in the direction of angle; the last one weighs `load`. Ropes end in the
   middles of the beads, or at their rims. */
static void rope_row(scene *s, int32_t from, double x, double y, int32_t links, double angle, double load, double slack)
{
	double length = pick(s, 0.3, 1.0), size = 0.2 * length, ux = cos(angle), uy = sin(angle), rim;
	int32_t round = chance(s, 0.5), centred = chance(s, 0.5), k, bead;
	rim = centred ? 0.0 : size;
	for (k = 0; k < links; ++k) {
		double at = length * (double)(k + 1), out = from < 0 || k == 0 ? 0.0 : rim;
		set_mass(s, k == links - 1 ? load : 1.0, round ? PI * size * size : 4.0 * size * size);
		bead = add_bead(s, round, x + at * ux, y + at * uy, size);
		add_rope(s, from, bead, x + (at - length + out) * ux, y + (at - length + out) * uy, x + (at - rim) * ux, y + (at - rim) * uy, slack);
		from = bead;
	}
	s->density = 1.0;
}

static void rope_chain(scene *s, double slack)
{
	int32_t links = pick_int_log(s, 3, 30);
	double load = pick_log(s, 1.0, 2000.0), angle = pick(s, -0.5 * PI, 0.6);
	s->group = -1;
	rope_row(s, WORLD, 0.0, 40.0, links, angle, load, slack);
	s->group = 0;
}

/* Loads on two ropes each, one below the other or in a row. */
static void rope_cradle(scene *s)
{
	int32_t count = pick_int(s, 2, 8), nested = chance(s, 0.5), k, above = WORLD;
	double ratio = pick_log(s, 0.05, 20.0), mass = 10.0, half = pick(s, 0.5, 1.0), drop = pick(s, 0.5, 2.0), push = pick(s, 0.0, 5.0);
	for (k = 0; k < count; ++k, mass *= ratio) {
		double x = nested ? 0.0 : 2.2 * half * (double)k, y = 40.0 - (nested ? (drop + 0.4) * (double)(k + 1) : drop + 0.4);
		int32_t load;
		mass = fmin(fmax(mass, 0.1), 2000.0);
		set_mass(s, mass, 0.8 * half);
		load = add_box(s, CN_BODY_DYNAMIC, x, y, 0.0, half, 0.2);
		add_rope(s, above, load, x - half, y + 0.2 + drop, x - half, y + 0.2, 0.0);
		add_rope(s, above, load, x + half, y + 0.2 + drop, x + half, y + 0.2, 0.0);
		set_velocity(s, load, push, 0.0, 0.0);
		above = nested ? load : WORLD;
	}
	s->density = 1.0;
}

/* A driven dolly, a hook on one to three ropes one after the other, a load pinned to it or on two ropes. */
static void rope_crane(scene *s)
{
	int32_t ropes = pick_int(s, 1, 3), dolly, hook, load, k;
	double mass = pick_log(s, 1.0, 2000.0), y = 20.0, slack = chance(s, 0.3) ? pick(s, 0.0, 0.1) : 0.0;
	dolly = add_box(s, CN_BODY_DYNAMIC, 0.0, y, 0.0, 1.0, 0.5);
	s->motor_speed = pick(s, -6.0, 6.0);
	s->motor_max = 20.0 * mass;
	add_slider(s, WORLD, dolly, 0.0, y, 1.0, 0.0, -15.0, 15.0);
	s->motor_max = 0.0;
	hook = dolly;
	for (k = 0; k < ropes; ++k, y -= 3.0) {
		int32_t next;
		set_mass(s, 1.0, PI * 0.09);
		next = add_disc(s, CN_BODY_DYNAMIC, 0.0, y - 3.0, 0.3);
		add_rope(s, hook, next, 0.0, y, 0.0, y - 3.0, slack);
		hook = next;
	}
	set_mass(s, mass, 4.0);
	load = add_box(s, CN_BODY_DYNAMIC, 0.0, y - 2.0, 0.0, 1.0, 1.0);
	if (chance(s, 0.5)) {
		add_pin(s, hook, load, 0.0, y - 0.9);
	} else {
		add_rope(s, hook, load, 0.0, y, -1.0, y - 1.0, slack);
		add_rope(s, hook, load, 0.0, y, 1.0, y - 1.0, slack);
	}
	s->density = 1.0;
	s->flags |= SCENE_NO_ENERGY;
}

/* Planks whose ends are tied by ropes of 0.1 m, between two fixed points; boxes fall on them. */
static void rope_bridge(scene *s)
{
	int32_t planks = pick_int_log(s, 4, 30), loads = pick_int(s, 1, 4), k, previous = WORLD;
	double slack = pick(s, 0.0, 1.0), mass = 0.2 * pick_log(s, 1.0, 300.0), left = -0.55 * (double)planks;
	s->group = -1;
	for (k = 0; k < planks; ++k) {
		double x = left + 1.1 * (double)k;
		int32_t plank = add_box(s, CN_BODY_DYNAMIC, x + 0.6, 10.0, 0.0, 0.5, 0.1);
		add_rope(s, previous, plank, x, 10.0, x + 0.1, 10.0, slack);
		previous = plank;
	}
	add_rope(s, WORLD, previous, left + 1.1 * (double)planks + 0.2, 10.0, left + 1.1 * (double)planks, 10.0, slack);
	s->group = 0;
	set_mass(s, mass, 1.0);
	for (k = 0; k < loads; ++k)
		add_box(s, CN_BODY_DYNAMIC, 1.2 * (double)k - 0.6 * (double)loads, 11.0 + (double)k, 0.0, 0.5, 0.5);
	s->density = 1.0;
	add_floor(s);
}

/* Beads on ropes over a fixed disc, with a load at either end. */
static void rope_over_peg(scene *s)
{
	int32_t beads = pick_int(s, 10, 30), k, previous = WORLD;
	double load = pick_log(s, 1.0, 500.0), other = load * pick(s, 0.2, 1.0), size = 0.12, step = 0.3, half = 0.5 * step * (double)(beads - 1);
	s->friction = pick(s, 0.0, 1.0);
	add_disc(s, CN_BODY_STATIC, 0.0, 12.0, 0.5);
	for (k = 0; k < beads; ++k) {
		double x = step * (double)k - half, y = 12.5 + size, mass = k == 0 ? load : k == beads - 1 ? other : 1.0;
		int32_t bead;
		set_mass(s, mass, PI * size * size);
		bead = add_disc(s, CN_BODY_DYNAMIC, x, y, size);
		if (previous != WORLD)
			add_rope(s, previous, bead, x - step, y, x, y, 0.0);
		previous = bead;
	}
	s->density = 1.0;
	add_floor(s);
}

/* Loads in a row below each other, each on a rope and a spring beside it. */
static void rope_springs(scene *s)
{
	int32_t count = pick_int(s, 1, 8), k, above = WORLD;
	double ratio = pick_log(s, 0.1, 10.0), hertz = pick_log(s, 0.5, 20.0), slack = pick(s, 0.0, 0.2), mass = 10.0;
	for (k = 0; k < count; ++k, mass = fmin(fmax(mass * ratio, 0.1), 1000.0)) {
		double y = 40.0 - 1.5 * (double)(k + 1);
		int32_t load;
		set_mass(s, mass, 0.25);
		load = add_box(s, CN_BODY_DYNAMIC, 0.0, y, 0.0, 0.25, 0.25);
		add_rope(s, above, load, -0.1, y + 1.25, -0.1, y + 0.25, slack);
		add_spring(s, above, load, 0.1, y + 1.25, 0.1, y + 0.25, hertz, 0.1, 0.0);
		above = load;
	}
	s->density = 1.0;
	s->flags |= SCENE_NO_ENERGY;
}

static int32_t add_car(scene *s, double x, double mass, double torque)
{
	int32_t body, k;
	set_mass(s, mass, 1.6);
	s->group = -1;
	body = add_box(s, CN_BODY_DYNAMIC, x, 0.8, 0.0, 1.0, 0.4);
	for (k = -1; k <= 1; k += 2) {
		int32_t wheel;
		set_mass(s, 0.1 * mass, PI * 0.16);
		wheel = add_disc(s, CN_BODY_DYNAMIC, x + 0.7 * (double)k, 0.4, 0.4);
		s->motor_speed = -15.0;
		s->motor_max = torque;
		if (torque > 0.0)
			add_wheel(s, body, wheel, x + 0.7 * (double)k, 0.4, 0.0, 1.0, 5.0, 0.7, 0.2);
		else
			add_pin(s, body, wheel, x + 0.7 * (double)k, 0.4);
		s->motor_max = 0.0;
	}
	s->group = 0;
	s->density = 1.0;
	return body;
}

/* A car tows one to four others on slack ropes. */
static void rope_tow(scene *s)
{
	int32_t count = pick_int(s, 1, 4), k, front;
	double mass = 100.0 * pick_log(s, 0.1, 10.0), slack = pick(s, 0.0, 1.0);
	s->friction = 1.0;
	add_floor(s);
	front = add_car(s, 0.0, 200.0, pick(s, 200.0, 2000.0));
	for (k = 0; k < count; ++k) {
		double x = -4.0 * (double)(k + 1);
		int32_t car = add_car(s, x, mass, 0.0);
		add_rope(s, front, car, x + 3.0, 0.8, x + 1.0, 0.8, slack);
		front = car;
	}
	s->flags |= SCENE_NO_ENERGY;
}

/* A row of ropes with a load on a kinematic body that moves and turns. */
static void rope_driver(scene *s)
{
	int32_t links = pick_int_log(s, 1, 15), driver;
	double load = pick_log(s, 1.0, 500.0), slack = chance(s, 0.5) ? pick(s, 0.0, 0.3) : 0.0, vx = pick(s, -4.0, 4.0), vy = pick(s, -2.0, 2.0), w = pick(s, -3.0, 3.0);
	s->group = -1;
	driver = add_box(s, CN_BODY_KINEMATIC, 0.0, 40.0, 0.0, 1.0, 0.2);
	set_velocity(s, driver, vx, vy, w);
	rope_row(s, driver, 1.0, 40.0, links, -0.5 * PI, load, slack);
	s->group = 0;
	s->flags |= SCENE_NO_ENERGY;
}

/* A net of ropes, its upper edge fixed, one heavier bead. */
static void rope_net(scene *s)
{
	int32_t columns = pick_int(s, 3, 12), rows = pick_int(s, 2, 12), i, k, net[12][12];
	double load = pick_log(s, 1.0, 300.0), slack = pick(s, 0.0, 0.2);
	s->group = -1;
	for (k = 0; k < rows; ++k)
		for (i = 0; i < columns; ++i) {
			double x = 0.5 * (double)i, y = 40.0 - 0.5 * (double)k;
			int32_t up = k == 0 ? WORLD : net[k - 1][i];
			set_mass(s, k == rows - 1 && i == columns / 2 ? load : 1.0, PI * 0.01);
			net[k][i] = add_disc(s, CN_BODY_DYNAMIC, x, y, 0.1);
			add_rope(s, up, net[k][i], x, y + 0.5, x, y, slack);
			if (i > 0)
				add_rope(s, net[k][i - 1], net[k][i], x - 0.5, y, x, y, slack);
		}
	s->group = 0;
	s->density = 1.0;
}

/* Booms one on the other, each pinned at its foot, its tip on a rope, with a load on the last. */
static void rope_stays(scene *s)
{
	int32_t count = pick_int(s, 1, 5), k, mast = WORLD;
	double load = pick_log(s, 0.1, 300.0), slack = chance(s, 0.5) ? pick(s, 0.0, 0.1) : 0.0, x = 0.0;
	s->group = -1;
	for (k = 0; k < count; ++k, x += 2.0) {
		int32_t boom;
		set_mass(s, 10.0, 0.4);
		boom = add_box(s, CN_BODY_DYNAMIC, x + 1.0, 20.0, 0.0, 1.0, 0.05);
		add_pin(s, mast, boom, x, 20.0);
		add_rope(s, WORLD, boom, 0.0, 23.0, x + 2.0, 20.0, slack);
		mast = boom;
	}
	set_mass(s, 10.0 * load, 1.0);
	k = add_box(s, CN_BODY_DYNAMIC, x, 18.0, 0.0, 0.5, 0.5);
	add_rope(s, mast, k, x, 20.0, x, 18.5, slack);
	s->group = 0;
	s->density = 1.0;
}

/* Ropes that are distance limits: rows of 3 to 30 beads with loads of 1 to 2000 times a bead's mass, taut or slack; cradles; cranes; bridges;
   rows over a peg; with springs beside them; tow ropes; on kinematic bodies; nets; stays of booms. */
static void build_rope_limits(scene *s)
{
	switch (pick_int(s, 0, 10)) {
	case 0: rope_chain(s, 0.0); break;
	case 1: rope_chain(s, pick(s, 0.0, 0.5)); break;
	case 2: rope_cradle(s); break;
	case 3: rope_crane(s); break;
	case 4: rope_bridge(s); break;
	case 5: rope_over_peg(s); break;
	case 6: rope_springs(s); break;
	case 7: rope_tow(s); break;
	case 8: rope_driver(s); break;
	case 9: rope_net(s); break;
	default: rope_stays(s); break;
	}
	s->seconds = 5.0;
}

const family rope_families[] = {
	{ "rope_peg", build_rope_peg, 0 },
	{ "bridge", build_bridge, 0 },
	{ "taut_bridge", build_taut_bridge, 0 },
	{ "chain", build_chain, 0 },
	{ "chain_heap", build_chain_heap, 0 },
	{ "rope_limits", build_rope_limits, 0 },
};
const int32_t rope_family_count = FAMILY_COUNT(rope_families);
