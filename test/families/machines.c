/*
 * test/families/machines.c - machines as games build them: scissor lifts, walkers on crank linkages, trebuchets, winches, suspension
 * bridges.
 */
#include "families.h"

#include <math.h>

/* A bar of uniform thickness between two points. */
static int32_t add_beam(scene *s, double ax, double ay, double bx, double by, double radius)
{
	double half = 0.5 * hypot(bx - ax, by - ay);
	return add_capsule(s, CN_BODY_DYNAMIC, 0.5 * (ax + bx), 0.5 * (ay + by), atan2(by - ay, bx - ax), fmax(half - radius, 0.1 * half), radius);
}

/* ---- lift: 2 to 6 stages of crossed bars on a base that stands on the ground or falls on it; the foot of the first is driven along the
   base by a motor of 1e3 to 1e6 N and lifts a platform, on which half of the seeds have a load of 1 to 100 kg ---- */

typedef struct stage {
	int32_t rising, falling; /* bars: from lower left to upper right, from upper left to lower right */
} stage;

static stage add_stage(scene *s, double half, double rise, double y)
{
	stage made;
	made.rising = add_beam(s, -half, y - rise, half, y + rise, 0.08);
	made.falling = add_beam(s, -half, y + rise, half, y - rise, 0.08);
	add_pin(s, made.rising, made.falling, 0.0, y);
	return made;
}

static void build_lift(scene *s)
{
	int32_t stages = pick_int(s, 2, 6), k, base, foot, top, slide;
	double half = pick(s, 1.2, 2.5), rise = pick(s, 0.2, 0.6), speed = pick(s, 0.1, 0.5), force = pick_log(s, 1e3, 1e6);
	double load = pick_log(s, 1.0, 100.0), fall = chance(s, 0.5) ? pick(s, 0.0, 0.2) : 0.0, y = 0.5 + fall;
	stage last = { 0, 0 };
	add_floor(s);
	s->group = -1;
	base = add_box(s, CN_BODY_DYNAMIC, 0.0, 0.2 + fall, 0.0, half + 0.5, 0.2);
	for (k = 0; k < stages; ++k, y += 2.0 * rise) {
		stage next = add_stage(s, half, rise, y + rise);
		if (k == 0) {
			add_pin(s, base, next.rising, -half, y);
			foot = add_box(s, CN_BODY_DYNAMIC, half, y, 0.0, 0.1, 0.1);
			s->motor_speed = -speed;
			s->motor_max = force;
			add_slider(s, base, foot, half, y, 1.0, 0.0, -0.5 * half, 0.1);
			s->motor_max = 0.0;
			add_pin(s, foot, next.falling, half, y);
		} else {
			add_pin(s, last.falling, next.rising, -half, y);
			add_pin(s, last.rising, next.falling, half, y);
		}
		last = next;
	}
	top = add_box(s, CN_BODY_DYNAMIC, 0.0, y + 0.2, 0.0, half + 0.3, 0.15);
	slide = add_box(s, CN_BODY_DYNAMIC, half, y, 0.0, 0.1, 0.1);
	add_pin(s, top, last.falling, -half, y);
	add_slider(s, top, slide, half, y, 1.0, 0.0, 1.0, -1.0);
	add_pin(s, slide, last.rising, half, y);
	s->group = 0;
	set_mass(s, load, 0.64);
	if (chance(s, 0.5))
		add_box(s, CN_BODY_DYNAMIC, 0.0, y + 0.76, 0.0, 0.4, 0.4);
	s->flags |= SCENE_NO_ENERGY;
}

/* ---- walker: Theo Jansen's linkage, two legs on each of three cranks, among discs on the ground ---- */

/* crank: the end of its crank pin; side: -1 or 1. */
static void add_leg(scene *s, int32_t body, int32_t crank, double x, double y, double pin_x, double pin_y, double side)
{
	static const double hip[3][2] = { { 0.0, 0.0 }, { 2.9, 0.7 }, { -0.6, 2.9 } }, foot[3][2] = { { 5.4, -6.1 }, { 7.2, -1.2 }, { 4.3, -1.9 } };
	double points[2][3][2], px = 3.1 * side, py = 0.8;
	int32_t k, upper, lower;
	for (k = 0; k < 3; ++k) {
		int32_t to = side > 0.0 ? k : 2 - k; /* counter-clockwise on either side */
		points[0][to][0] = hip[k][0] * side;
		points[0][to][1] = hip[k][1];
		points[1][to][0] = foot[k][0] * side;
		points[1][to][1] = foot[k][1];
	}
	lower = add_polygon(s, CN_BODY_DYNAMIC, x, y, 0.0, (const double (*)[2])points[1], 3);
	upper = add_polygon(s, CN_BODY_DYNAMIC, x + px, y + py, 0.0, (const double (*)[2])points[0], 3);
	add_rod(s, lower, upper, x + 7.2 * side, y - 1.2, x + 6.0 * side, y + 1.5);
	add_rod(s, lower, upper, x + 4.3 * side, y - 1.9, x + px, y + py);
	add_rod(s, lower, crank, x + 4.3 * side, y - 1.9, pin_x, pin_y);
	add_rod(s, upper, crank, x + 2.5 * side, y + 3.7, pin_x, pin_y);
	add_pin(s, upper, body, x + px, y + py);
}

static void build_walker(scene *s)
{
	double y = 8.5, ratio = pick_log(s, 0.2, 30.0), torque = pick_log(s, 400.0, 4000.0) * (1.0 + ratio);
	int32_t k, body, crank;
	s->friction = 0.9;
	add_floor(s);
	s->group = -1;
	s->density = ratio;
	body = add_box(s, CN_BODY_DYNAMIC, 0.0, y, 0.0, 2.5, 1.0);
	crank = add_disc(s, CN_BODY_DYNAMIC, 0.0, y, 1.6);
	s->density = 1.0;
	s->motor_speed = chance(s, 0.5) ? 2.0 : -2.0;
	s->motor_max = torque;
	add_pin(s, body, crank, 0.0, y);
	s->motor_max = 0.0;
	for (k = 0; k < 3; ++k) { /* all legs hang on the same side of the crank at first: three phases would need turned legs */
		double at = PI * (0.5 + 0.04 * (double)(k - 1));
		add_leg(s, body, crank, 0.0, y, -0.8 * cos(at), y - 0.8 * sin(at), -1.0);
		add_leg(s, body, crank, 0.0, y, -0.8 * cos(at), y - 0.8 * sin(at), 1.0);
	}
	s->group = 0;
	for (k = 0; k < 20; ++k) {
		s->density = pick_log(s, 0.3, 3.0);
		add_disc(s, CN_BODY_DYNAMIC, 2.0 * (double)(k - 10), 0.25, 0.25);
	}
	s->flags |= SCENE_NO_ENERGY;
}

/* ---- trebuchet: an arm of 8 m, a counterweight of 50 to 1000 times its mass, a sling of 3 to 10 links, a stone ---- */

static void build_trebuchet(scene *s)
{
	double weight = pick_log(s, 50.0, 1000.0), stone = pick_log(s, 0.1, 3.0), y = 5.0, link, x = 6.0;
	int32_t links = pick_int(s, 3, 10), k, arm, last;
	add_floor(s);
	s->group = -1;
	arm = add_box(s, CN_BODY_DYNAMIC, 2.0, y, 0.0, 4.0, 0.1);
	add_pin(s, WORLD, arm, 0.0, y);
	set_mass(s, 1.6 * weight, 2.56);
	k = add_box(s, CN_BODY_DYNAMIC, -2.0, 3.5, 0.0, 0.8, 0.8);
	add_pin(s, arm, k, -2.0, y);
	s->density = 1.0;
	link = 3.0 / (double)links;
	for (k = 0, last = arm; k < links; ++k, x -= link) {
		int32_t next = add_beam(s, x, y, x - link, y, 0.04);
		add_pin(s, last, next, x, y);
		last = next;
	}
	set_mass(s, stone, PI * 0.04);
	k = add_disc(s, CN_BODY_DYNAMIC, x, y, 0.2);
	add_pin(s, last, k, x, y);
}

/* ---- winch: a driven drum winds up a chain of 24 links that carries 1 to 1000 times a link's mass ---- */

static void build_winch(scene *s)
{
	double radius = pick(s, 0.4, 0.8), load = pick_log(s, 1.0, 1000.0), y = 10.0, half = 0.125, thin = 0.04, x = -radius - thin;
	int32_t k, drum, last;
	add_floor(s);
	s->density = 5.0;
	s->friction = pick(s, 0.2, 1.0);
	drum = add_disc(s, CN_BODY_DYNAMIC, 0.0, y, radius);
	s->density = 1.0;
	s->motor_speed = chance(s, 0.8) ? -pick(s, 0.3, 2.0) : pick(s, 0.3, 2.0);
	s->motor_max = 1e5;
	add_pin(s, WORLD, drum, 0.0, y);
	s->motor_max = 0.0;
	for (k = 0, last = drum; k < 24; ++k, y -= 2.0 * half) {
		int32_t next = add_beam(s, x, y, x, y - 2.0 * half, thin);
		add_pin(s, last, next, x, y);
		last = next;
	}
	set_mass(s, load * 4.0 * half * thin, 0.36);
	k = add_box(s, CN_BODY_DYNAMIC, x, y - 0.3, 0.0, 0.3, 0.3);
	add_pin(s, last, k, x, y);
	s->flags |= SCENE_NO_ENERGY;
}

/* ---- suspension: a deck of 12 to 30 planks on rods under two pinned cables; boxes of 1 to 200 times a plank's mass fall on it ---- */

static double cable(double x, double half)
{
	return 6.0 + 4.0 * (x / half) * (x / half);
}

static void build_suspension(scene *s)
{
	int32_t planks = pick_int(s, 12, 30), boxes = pick_int(s, 2, 8), k, deck = WORLD, rope = WORLD;
	double half = 0.5 * (double)planks, load = pick_log(s, 1.0, 200.0);
	add_floor(s);
	for (k = 0; k < planks; ++k) {
		double x = (double)k - half;
		int32_t plank = add_box(s, CN_BODY_DYNAMIC, x + 0.5, 5.0, 0.0, 0.48, 0.1), link;
		s->group = -1;
		link = add_beam(s, x, cable(x, half), x + 1.0, cable(x + 1.0, half), 0.04);
		s->group = 0;
		add_pin(s, deck, plank, x, 5.0);
		add_pin(s, rope, link, x, cable(x, half));
		add_rod(s, link, plank, x + 0.5, 0.5 * (cable(x, half) + cable(x + 1.0, half)), x + 0.5, 5.1);
		deck = plank;
		rope = link;
	}
	add_pin(s, WORLD, deck, half, 5.0);
	add_pin(s, WORLD, rope, half, cable(half, half));
	for (k = 0; k < boxes; ++k) {
		set_mass(s, load * 0.192, 0.36);
		s->group = -1; /* they hit the deck alone, not the cables or each other */
		add_box(s, CN_BODY_DYNAMIC, pick(s, -0.8, 0.8) * half, 5.6 + 0.4 * (double)k, 0.0, 0.3, 0.3);
	}
}

const family machine_families[] = {
	{ "lift", build_lift, 0 },
	{ "walker", build_walker, 0 },
	{ "trebuchet", build_trebuchet, 0 },
	{ "winch", build_winch, 0 },
	{ "suspension", build_suspension, 0 },
};
const int32_t machine_family_count = FAMILY_COUNT(machine_families);
