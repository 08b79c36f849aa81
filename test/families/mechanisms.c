/*
 * test/families/mechanisms.c - random mechanisms, closed linkages, gears and pulleys in loops.
 */
#include "families.h"

#include <math.h>

#define SIDE_MAX 20

/* ---- mechanism: 30 to 400 bodies in a jittered grid of 1 m ---- */

static int32_t random_part(scene *s, double x, double y, double ratio)
{
	int32_t kind = pick_int(s, 0, 2);
	double size = pick(s, 0.2, 0.4), thin = pick(s, 0.08, 0.3), angle = pick(s, -PI, PI);
	s->density = pick_log(s, 1.0, ratio);
	if (kind == 0)
		return add_disc(s, CN_BODY_DYNAMIC, x, y, size);
	if (kind == 1)
		return add_box(s, CN_BODY_DYNAMIC, x, y, angle, size, thin);
	return add_capsule(s, CN_BODY_DYNAMIC, x, y, angle, 0.6 * size, 0.4 * size);
}

static void random_joint(scene *s, int32_t a, int32_t b)
{
	const scene_body *p = &s->bodies[a], *q = &s->bodies[b];
	double x = 0.5 * (p->x + q->x), y = 0.5 * (p->y + q->y), kind = pick(s, 0.0, 1.0);
	if (kind < 0.45)
		add_pin(s, a, b, x, y);
	else if (kind < 0.75)
		add_rod(s, a, b, p->x, p->y, q->x, q->y);
	else if (kind < 0.9)
		add_weld(s, a, b, x, y);
	else
		add_slider(s, a, b, x, y, q->x - p->x, q->y - p->y, -0.2, 0.2);
}

/* Joints between neighbours with a probability of 0.3 to 1: pins, rods, welds, sliders with 0.2 m of travel. Densities to
   1:100; joined bodies collide in half of them, all others too, but for a quarter; hung from its upper corners. */
static void build_mechanism(scene *s)
{
	int32_t parts = pick_int_log(s, 30, 400), columns = (int32_t)lround(sqrt((double)parts) * pick(s, 0.8, 1.25)), rows, i, k;
	double share = pick(s, 0.3, 1.0), jitter = pick(s, 0.0, 0.15), ratio = pick_log(s, 1.0, 100.0);
	int32_t at[SIDE_MAX + 6][SIDE_MAX + 6];
	columns = columns > SIDE_MAX + 5 ? SIDE_MAX + 5 : columns;
	rows = parts / columns > SIDE_MAX + 5 ? SIDE_MAX + 5 : parts / columns;
	s->friction = pick(s, 0.0, 1.0);
	s->group = chance(s, 0.25) ? -1 : 0;
	s->joint_flags = chance(s, 0.5) ? CN_JOINT_COLLIDE : 0;
	for (i = 0; i < rows; ++i)
		for (k = 0; k < columns; ++k) {
			double x = (double)k - 0.5 * (double)columns + pick(s, -jitter, jitter), y = 3.0 + (double)(rows - i) + pick(s, -jitter, jitter);
			at[i][k] = random_part(s, x, y, ratio);
			if (k > 0 && chance(s, share))
				random_joint(s, at[i][k - 1], at[i][k]);
			if (i > 0 && chance(s, share))
				random_joint(s, at[i - 1][k], at[i][k]);
		}
	add_pin(s, WORLD, at[0][0], s->bodies[at[0][0]].x, s->bodies[at[0][0]].y);
	if (chance(s, 0.8))
		add_pin(s, WORLD, at[0][columns - 1], s->bodies[at[0][columns - 1]].x, s->bodies[at[0][columns - 1]].y);
	s->group = 0;
	s->density = 1.0;
	add_floor(s);
}

/* ---- linkage: closed loops ---- */

static int32_t add_bar(scene *s, double ax, double ay, double bx, double by)
{
	return add_box(s, CN_BODY_DYNAMIC, 0.5 * (ax + bx), 0.5 * (ay + by), atan2(by - ay, bx - ax), 0.5 * hypot(bx - ax, by - ay), 0.05);
}

/* Ground link 2 to 4 m, crank 1 m, coupler and rocker such that the crank can turn; heavy ones to 1:100. */
static void four_bar(scene *s)
{
	double ground = pick(s, 2.0, 4.0), rocker = pick(s, 1.5, 3.0), coupler = ground + pick(s, 0.0, 1.0), ratio = pick_log(s, 1.0, 100.0);
	double angle = pick(s, 0.3, 1.2), x = cos(angle), y = 5.0 + sin(angle), gap, along, across, px, py;
	int32_t crank, rod, follower;
	if (rocker < 1.0 + coupler - ground + 0.1) /* the crank must clear its flat positions */
		rocker = 1.1 + coupler - ground;
	gap = hypot(ground - x, 5.0 - y);
	along = (coupler * coupler - rocker * rocker + gap * gap) / (2.0 * gap);
	across = sqrt(fmax(coupler * coupler - along * along, 0.01));
	px = x + (along * (ground - x) - across * (5.0 - y)) / gap;
	py = y + (along * (5.0 - y) + across * (ground - x)) / gap;
	s->group = -1;
	crank = add_bar(s, 0.0, 5.0, x, y);
	s->density = ratio;
	rod = add_bar(s, x, y, px, py);
	s->density = 1.0;
	follower = add_bar(s, px, py, ground, 5.0);
	s->motor_speed = 5.0;
	s->motor_max = chance(s, 0.5) ? pick_log(s, 100.0, 1e5) : 0.0;
	if (s->motor_max > 0.0)
		s->flags |= SCENE_NO_ENERGY;
	add_pin(s, WORLD, crank, 0.0, 5.0);
	s->motor_max = 0.0;
	add_pin(s, crank, rod, x, y);
	add_pin(s, rod, follower, px, py);
	add_pin(s, WORLD, follower, ground, 5.0);
}

/* Crank 1 m, rod 3 m, slider 1 to 300 kg, motor 5 rad/s with 1 to 400 times the torque that the slider needs. */
static void slider_crank(scene *s)
{
	double angle = pick(s, 0.0, 2.0 * PI), x = cos(angle), y = 5.0 + sin(angle), end = x + sqrt(9.0 - (y - 5.0) * (y - 5.0));
	double mass = pick_log(s, 1.0, 300.0);
	int32_t crank, rod, slider;
	s->group = -1;
	crank = add_bar(s, 0.0, 5.0, x, y);
	rod = add_bar(s, x, y, end, 5.0);
	set_mass(s, mass, 0.25);
	slider = add_box(s, CN_BODY_DYNAMIC, end, 5.0, 0.0, 0.25, 0.25);
	s->motor_speed = 5.0;
	s->motor_max = 25.0 * mass * 1.0 * pick_log(s, 1.0, 400.0);
	add_pin(s, WORLD, crank, 0.0, 5.0);
	s->motor_max = 0.0;
	add_pin(s, crank, rod, x, y);
	add_pin(s, rod, slider, end, 5.0);
	add_slider(s, WORLD, slider, end, 5.0, 1.0, 0.0, 1.0, -1.0);
	s->flags |= SCENE_NO_ENERGY;
}

/* A platform of 1 to 1000 kg on three legs, each of two boxes that slide in each other by 0.5 m and are pinned at both ends. */
static void platform(scene *s)
{
	double mass = pick_log(s, 1.0, 1000.0), height = 3.0;
	int32_t top, k;
	s->group = -1;
	set_mass(s, mass, 3.0 * 0.4);
	top = add_box(s, CN_BODY_DYNAMIC, 0.0, height, 0.0, 1.5, 0.2);
	s->density = 1.0;
	for (k = 0; k < 3; ++k) {
		double ax = 1.5 * (double)(k - 1) + pick(s, -0.5, 0.5), bx = (double)(k - 1), dx = bx - ax, dy = height - 0.5;
		int32_t lower = add_bar(s, ax, 0.5, ax + 0.6 * dx, 0.5 + 0.6 * dy), upper = add_bar(s, ax + 0.4 * dx, 0.5 + 0.4 * dy, bx, height);
		add_pin(s, WORLD, lower, ax, 0.5);
		s->motor_speed = pick(s, -0.5, 0.5);
		s->motor_max = chance(s, 0.5) ? mass * 20.0 : 0.0;
		add_slider(s, lower, upper, ax + 0.5 * dx, 0.5 + 0.5 * dy, dx, dy, -0.5, 0.5);
		s->motor_max = 0.0;
		add_pin(s, upper, top, bx, height);
	}
	s->flags |= SCENE_NO_ENERGY;
}

/* A closed ring of 4 to 24 bars, held at one or two joints, with a load of 1 to 300 kg at one. */
static void ring(scene *s)
{
	int32_t bars = pick_int(s, 4, 24), k, first = 0, previous = 0;
	double radius = 0.5 / sin(PI / (double)bars), mass = pick_log(s, 1.0, 300.0);
	s->group = -1;
	for (k = 0; k < bars; ++k) {
		double a = 2.0 * PI * (double)k / (double)bars, b = 2.0 * PI * (double)(k + 1) / (double)bars;
		double ax = radius * sin(a), ay = 8.0 + radius * cos(a);
		int32_t bar = add_bar(s, ax, ay, radius * sin(b), 8.0 + radius * cos(b));
		if (k == 0) {
			first = bar;
			add_pin(s, WORLD, bar, ax, ay);
		} else {
			add_pin(s, previous, bar, ax, ay);
		}
		previous = bar;
	}
	add_pin(s, previous, first, 0.0, 8.0 + radius);
	set_mass(s, mass, PI * 0.09);
	k = add_disc(s, CN_BODY_DYNAMIC, s->bodies[bars / 2].x, s->bodies[bars / 2].y, 0.3);
	add_pin(s, bars / 2, k, s->bodies[bars / 2].x, s->bodies[bars / 2].y);
}

/* A four-bar linkage, a slider-crank, a platform on three sliding legs, or a closed ring of bars. */
static void build_linkage(scene *s)
{
	int32_t kind = pick_int(s, 0, 3);
	if (kind == 0)
		four_bar(s);
	else if (kind == 1)
		slider_crank(s);
	else if (kind == 2)
		platform(s);
	else
		ring(s);
}

/* ---- gears: wheels geared in a row or a closed ring, and weights on pulleys ---- */

/* 3 to 12 wheels of radius 0.3 to 0.8 m on fixed axles; the first is driven, or one is turned by a weight of 1 to 100 kg.
   Every second seed closes the row to a ring of an even number of wheels. */
static void gear_row(scene *s)
{
	int32_t wheels = 2 * pick_int(s, 2, 6), closed = chance(s, 0.5), k, wheel[12];
	double radius[12], x = 0.0, ratio = pick_log(s, 1.0, 100.0);
	s->group = -1;
	for (k = 0; k < wheels; ++k) {
		radius[k] = pick(s, 0.3, 0.8);
		s->density = pick_log(s, 1.0, ratio);
		wheel[k] = add_disc(s, CN_BODY_DYNAMIC, x, 5.0, radius[k]);
		s->motor_speed = pick(s, 1.0, 10.0);
		s->motor_max = k == 0 ? pick_log(s, 10.0, 1000.0) : 0.0;
		add_pin(s, WORLD, wheel[k], x, 5.0);
		s->motor_max = 0.0;
		if (k > 0)
			add_gear(s, wheel[k - 1], wheel[k], -radius[k - 1] / radius[k]);
		x += 2.0;
	}
	if (closed)
		add_gear(s, wheel[wheels - 1], wheel[0], -radius[wheels - 1] / radius[0]);
	s->flags |= SCENE_NO_ENERGY;
}

/* 2 to 6 weights of 1 to 100 kg hang in a row, each on a rope over two points with the next, ratio 0.5 to 2; every second
   seed also joins the last with the first. */
static void pulley_row(scene *s)
{
	int32_t weights = pick_int(s, 2, 6), closed = weights > 2 && chance(s, 0.5), k, weight[6];
	double top = 10.0;
	for (k = 0; k < weights; ++k) {
		set_mass(s, pick_log(s, 1.0, 100.0), 0.36);
		weight[k] = add_box(s, CN_BODY_DYNAMIC, 1.5 * (double)k, 5.0, 0.0, 0.3, 0.3);
		if (k > 0)
			add_pulley(s, weight[k - 1], weight[k], 1.5 * (double)(k - 1), top, 1.5 * (double)k, top, pick(s, 0.5, 2.0));
	}
	if (closed)
		add_pulley(s, weight[weights - 1], weight[0], 1.5 * (double)(weights - 1), top, 0.0, top, 1.0);
	s->density = 1.0;
	add_floor(s);
}

static void build_gears(scene *s)
{
	if (chance(s, 0.5))
		gear_row(s);
	else
		pulley_row(s);
}

/* 4 to 16 boards of 0.6 to 1.2 x 0.1 to 0.3 m, welded in a row to the world; one to three boxes of 1 to 1000 times a board's mass fall on
   the outer half from 0.1 to 3 m and lie there or slide off. Friction 0.3 to 1. */
static void build_cantilever(scene *s)
{
	int32_t boards = pick_int(s, 4, 16), boxes = pick_int(s, 1, 3), k, previous = WORLD;
	double half = pick(s, 0.3, 0.6), thin = pick(s, 0.05, 0.15), y = 8.0, length = 2.0 * half * (double)boards;
	s->friction = pick(s, 0.3, 1.0);
	for (k = 0; k < boards; ++k) {
		double x = 2.0 * half * (double)k;
		int32_t board = add_box(s, CN_BODY_DYNAMIC, x + half, y, 0.0, half, thin);
		add_weld(s, previous, board, x, y);
		previous = board;
	}
	for (k = 0, y += thin; k < boxes; ++k) {
		double size = pick(s, 0.2, 0.6), x = pick(s, 0.5, 1.0) * length, fall = pick(s, 0.1, 3.0);
		set_mass(s, 4.0 * half * thin * pick_log(s, 1.0, 1000.0), 4.0 * size * size);
		y += fall + size;
		add_box(s, CN_BODY_DYNAMIC, x, y, 0.0, size, size);
		y += size;
	}
	s->density = 1.0;
	add_floor(s);
}

/* 3 to 12 boxes of 0.3 to 0.8 m on each other, the hinge of each pair at a corner or in the middle, its angle within 0 to 0.8 rad;
   masses to 1:30; the tower begins to lean with 0 to 1 rad/s and falls over. Friction 0.2 to 1. */
static void build_hinged_tower(scene *s)
{
	int32_t boxes = pick_int(s, 3, 12), k, previous = 0;
	double half = pick(s, 0.15, 0.4), ratio = pick_log(s, 1.0, 30.0), spin = pick(s, 0.0, 1.0);
	s->friction = pick(s, 0.2, 1.0);
	add_floor(s);
	for (k = 0; k < boxes; ++k) {
		double y = half * (2.0 * (double)k + 1.0), give = pick(s, 0.05, 0.8), side = (double)pick_int(s, -1, 1);
		int32_t box;
		s->joint_flags = chance(s, 0.5) ? CN_JOINT_COLLIDE : 0;
		s->density = pick_log(s, 1.0, ratio);
		box = add_box(s, CN_BODY_DYNAMIC, 0.0, y, 0.0, half, half);
		if (k > 0)
			add_pin_limited(s, previous, box, side * half, y - half, -give, give);
		set_velocity(s, box, -spin * y, 0.0, spin);
		previous = box;
	}
}

const family mechanism_families[] = {
	{ "mechanism", build_mechanism, 0 },
	{ "linkage", build_linkage, 0 },
	{ "gears", build_gears, 0 },
	{ "cantilever", build_cantilever, 0 },
	{ "hinged_tower", build_hinged_tower, 0 },
};
const int32_t mechanism_family_count = FAMILY_COUNT(mechanism_families);
