/*
 * test/families/workshop.c - structures under load as people put them together: welded frames, wrecking balls, drums, hoists, mattresses,
 * roller conveyors, trains on bridges, rows of pendulums, balances, wedge presses.
 */
#include "families.h"

#include <math.h>

static int32_t add_link(scene *s, double ax, double ay, double bx, double by, double radius)
{
	double half = 0.5 * hypot(bx - ax, by - ay);
	return add_capsule(s, CN_BODY_DYNAMIC, 0.5 * (ax + bx), 0.5 * (ay + by), atan2(by - ay, bx - ax), fmax(half - radius, 0.1 * half), radius);
}

/* A chain of pinned links from a body at (ax, ay) to (bx, by); returns the last link. */
static int32_t add_chain(scene *s, int32_t from, double ax, double ay, double bx, double by, int32_t links, double radius)
{
	int32_t k;
	for (k = 0; k < links; ++k) {
		double t = (double)k / (double)links, u = (double)(k + 1) / (double)links;
		double x = ax + t * (bx - ax), y = ay + t * (by - ay);
		int32_t link = add_link(s, x, y, ax + u * (bx - ax), ay + u * (by - ay), radius);
		add_pin(s, from, link, x, y);
		from = link;
	}
	return from;
}

static int32_t add_load(scene *s, double x, double y, double half, double mass)
{
	set_mass(s, mass, 4.0 * half * half);
	return add_box(s, CN_BODY_DYNAMIC, x, y, 0.0, half, half);
}

/* Boxes on each other from y up, each 0.1 to 10 times the one before, within 1 to `ratio` kg. */
static double add_stack(scene *s, double x, double y, double half, int32_t count, double ratio)
{
	int32_t k;
	for (k = 0; k < count; ++k, y += 2.0 * half)
		add_load(s, x, y + half, half, pick_log(s, 1.0, ratio));
	s->density = 1.0;
	return y;
}

/* ---- frame: columns of 2 to 5 boards by 1 to 3 bays, all joints welded, on the floor or welded to it; a disc of 0.1 to 1000 times a
   board's mass strikes it at 3 to 30 m/s, or boxes of up to 100 boards fall on it ---- */

static void build_frame(scene *s)
{
	int32_t floors = pick_int(s, 2, 5), bays = pick_int(s, 1, 3), fixed = chance(s, 0.5), struck = chance(s, 0.5), i, k, shot;
	double thin = pick(s, 0.06, 0.12), mass = 0.4 * pick_log(s, 0.1, 1000.0), speed = pick(s, 3.0, 30.0), height = 0.0;
	int32_t columns[4] = { 0, 0, 0, 0 };
	add_floor(s);
	for (i = 0; i < floors; ++i) {
		int32_t beams[3];
		double foot = height;
		for (k = 0; k <= bays; ++k) {
			int32_t column = add_box(s, CN_BODY_DYNAMIC, 2.0 * (double)(k) - (double)bays, foot + 1.0, 0.0, thin, 1.0);
			if (i > 0)
				add_weld(s, columns[k], column, 2.0 * (double)k - (double)bays, foot);
			else if (fixed)
				add_weld(s, WORLD, column, 2.0 * (double)k - (double)bays, foot);
			columns[k] = column;
		}
		height = foot + 2.0;
		for (k = 0; k < bays; ++k) {
			double x = 2.0 * (double)k - (double)bays + 1.0;
			beams[k] = add_box(s, CN_BODY_DYNAMIC, x, height - thin, 0.0, 1.0 - thin, thin);
			add_weld(s, columns[k], beams[k], x - 1.0, height - thin);
			add_weld(s, columns[k + 1], beams[k], x + 1.0, height - thin);
		}
	}
	if (struck) {
		set_mass(s, mass, PI * 0.09);
		shot = add_disc(s, CN_BODY_DYNAMIC, -(double)bays - 3.0, pick(s, 0.5, height - 0.2), 0.3);
		set_velocity(s, shot, speed, 1.0, 0.0);
		return;
	}
	for (k = 0; k < 4; ++k)
		add_load(s, pick(s, -0.9, 0.9) * (double)bays, height + 1.0 + 0.9 * (double)k, 0.35, fmin(mass, 40.0));
}

/* ---- wrecking: a ball of 5 to 1000 times a link's mass on a chain of 4 to 16 links swings into a wall of boxes at 2 to 12 m/s ---- */

static void build_wrecking(scene *s)
{
	int32_t links = pick_int(s, 4, 16), rows = pick_int(s, 3, 9), columns = pick_int(s, 1, 4), i, k, last, ball;
	double length = pick(s, 4.0, 7.0), angle = pick(s, 0.1, 0.3), radius = 0.5, x = -length * sin(angle), y = length + 1.5;
	double density = pick_log(s, 0.2, 20.0), mass = pick_log(s, 5.0, 1000.0) * 0.1 * length / (double)links, spin = pick(s, 2.0, 12.0) / length;
	s->friction = pick(s, 0.3, 0.9);
	add_floor(s);
	s->group = -1;
	last = add_chain(s, WORLD, 0.0, y, x, y - length * cos(angle), links, 0.05);
	s->group = 0;
	set_mass(s, mass, PI * radius * radius);
	ball = add_disc(s, CN_BODY_DYNAMIC, x - radius * sin(angle), y - (length + radius) * cos(angle), radius);
	add_pin(s, last, ball, x, y - length * cos(angle));
	for (k = 1; k <= ball; ++k)
		set_velocity(s, k, spin * (y - s->bodies[k].y), spin * s->bodies[k].x, spin);
	s->density = density;
	for (i = 0; i < rows; ++i)
		for (k = 0; k < columns; ++k)
			add_box(s, CN_BODY_DYNAMIC, 0.9 + 0.6 * (double)k, 0.3 + 0.6 * (double)i, 0.0, 0.3, 0.3);
}

/* ---- drum: 10 to 16 boards welded into a ring on a driven axle; in it 5 to 20 boxes of 0.1 to 30 kg and one to three chains ---- */

static void build_drum(scene *s)
{
	int32_t boards = pick_int(s, 10, 16), boxes = pick_int(s, 5, 20), chains = pick_int(s, 1, 3), k, first = 0, last = 0;
	double radius = 3.0, y = 4.0, half = radius * tan(PI / (double)boards), ratio = pick_log(s, 1.0, 30.0);
	s->friction = pick(s, 0.3, 1.2);
	s->density = 5.0;
	for (k = 0; k < boards; ++k) {
		double angle = 2.0 * PI * (double)k / (double)boards, edge = angle - PI / (double)boards;
		int32_t board = add_box(s, CN_BODY_DYNAMIC, (radius + 0.1) * cos(angle), y + (radius + 0.1) * sin(angle), angle, 0.1, half);
		if (k == 0)
			first = board;
		else
			add_weld(s, last, board, radius / cos(PI / (double)boards) * cos(edge), y + radius / cos(PI / (double)boards) * sin(edge));
		last = board;
	}
	add_weld(s, last, first, radius, y - half);
	s->motor_speed = pick(s, -2.0, 2.0);
	s->motor_max = 1e5;
	add_pin(s, WORLD, first, 0.0, y);
	s->motor_max = 0.0;
	for (k = 0; k < boxes; ++k)
		add_load(s, 0.6 * (double)(k % 5 - 2), y - 1.5 + 0.6 * (double)(k / 5), 0.24, pick_log(s, 0.1, ratio));
	s->density = 1.0;
	for (k = 0; k < chains; ++k) {
		double at = y + 1.2 + 0.3 * (double)k;
		set_mass(s, 1.0, 0.04);
		last = add_box(s, CN_BODY_DYNAMIC, 1.2, at, 0.0, 0.1, 0.1);
		s->density = 1.0;
		add_chain(s, last, 1.2, at, -1.0, at, 8, 0.05);
	}
}

/* ---- hoist: a cage on a slider, driven against its upper limit or hung by a pulley from a counterweight, carries a stack of 2 to 8 boxes
   of 1 to 1000 kg ---- */

static void build_hoist(scene *s)
{
	int32_t boxes = pick_int(s, 2, 8), driven = chance(s, 0.5), cage, weight;
	double ratio = pick_log(s, 1.0, 1000.0), force = pick_log(s, 300.0, 1e5), travel = pick(s, 0.5, 3.0), speed = pick(s, 0.3, 3.0);
	add_floor(s);
	set_mass(s, pick_log(s, 1.0, 100.0), 0.8);
	cage = add_box(s, CN_BODY_DYNAMIC, 0.0, 2.0, 0.0, 1.0, 0.2);
	s->motor_speed = chance(s, 0.7) ? speed : -speed;
	s->motor_max = driven ? force : 0.0;
	add_slider(s, WORLD, cage, 0.0, 2.0, 0.0, 1.0, -1.5, travel);
	s->motor_max = 0.0;
	if (!driven) {
		set_mass(s, pick_log(s, 1.0, 1000.0), 1.0);
		weight = add_box(s, CN_BODY_DYNAMIC, 4.0, 5.0, 0.0, 0.5, 0.5);
		add_slider(s, WORLD, weight, 4.0, 5.0, 0.0, 1.0, -4.4, 4.0);
		add_pulley(s, cage, weight, 0.0, 12.0, 4.0, 12.0, 1.0);
	}
	add_stack(s, 0.0, 2.2, pick(s, 0.2, 0.4), boxes, ratio);
	s->flags |= driven ? SCENE_NO_ENERGY : 0;
}

/* ---- mattress: 6 to 16 slats pinned end to end, each on two springs of 2 to 12 Hz over the floor; one to four boxes of up to 100 slats
   fall on it ---- */

static void build_mattress(scene *s)
{
	int32_t slats = pick_int(s, 6, 16), loads = pick_int(s, 1, 4), k, last = WORLD;
	double hertz = pick(s, 2.0, 12.0), damping = pick(s, 0.0, 1.0), load = 0.2 * pick_log(s, 1.0, 100.0), half = 0.5 * (double)slats;
	int32_t base = add_floor(s);
	for (k = 0; k < slats; ++k) {
		double x = (double)k + 0.5 - half;
		int32_t slat = add_box(s, CN_BODY_DYNAMIC, x, 1.5, 0.0, 0.48, 0.1);
		add_spring(s, base, slat, x - 0.4, 0.0, x - 0.4, 1.4, hertz, damping, 0.8);
		add_spring(s, base, slat, x + 0.4, 0.0, x + 0.4, 1.4, hertz, damping, 0.8);
		if (k > 0)
			add_pin(s, last, slat, x - 0.5, 1.5);
		last = slat;
	}
	for (k = 0; k < loads; ++k) {
		double x = pick(s, -0.7, 0.7) * half, size = pick(s, 0.25, 0.5);
		add_load(s, x, 2.2 + 1.1 * (double)k, size, load);
	}
	s->flags |= SCENE_NO_ENERGY;
}

/* ---- rollers: 6 to 14 driven discs on fixed axles or on a pinned frame carry a heap of 4 to 20 boxes of 0.1 to 30 kg against a stop ---- */

static void build_rollers(scene *s)
{
	int32_t rollers = pick_int(s, 6, 14), boxes = pick_int(s, 4, 20), framed = chance(s, 0.5), k, frame = WORLD;
	double ratio = pick_log(s, 1.0, 30.0), speed = -pick(s, 1.0, 15.0), torque = pick_log(s, 1.0, 1000.0), half = 0.3 * (double)rollers;
	s->friction = pick(s, 0.2, 1.5);
	add_floor(s);
	add_box(s, CN_BODY_STATIC, half + 1.0, 3.0, 0.0, 0.5, 3.0);
	s->group = -1;
	if (framed) {
		s->density = pick_log(s, 1.0, 30.0);
		frame = add_box(s, CN_BODY_DYNAMIC, 0.0, 2.0, 0.0, half, 0.1);
		add_pin(s, WORLD, frame, -half, 2.0);
		add_rod(s, WORLD, frame, half, 6.0, half, 2.0);
	}
	s->density = 1.0;
	for (k = 0; k < rollers; ++k) {
		double x = 0.6 * (double)k + 0.3 - half;
		int32_t roller = add_disc(s, CN_BODY_DYNAMIC, x, 2.0, 0.27);
		s->motor_speed = speed;
		s->motor_max = torque;
		add_pin(s, frame, roller, x, 2.0);
		s->motor_max = 0.0;
	}
	s->group = 0;
	for (k = 0; k < boxes; ++k)
		add_load(s, -0.5 * half + 0.62 * (double)(k % 5), 2.65 + 0.65 * (double)(k / 5), 0.3, pick_log(s, 0.1, ratio));
	s->flags |= SCENE_NO_ENERGY;
}

/* ---- train: an engine and one to four wagons on pinned wheels, coupled by bars, drive over a bridge of 8 to 20 pinned planks; the wagons
   carry boxes; wagons of 1 to 100 planks ---- */

static int32_t add_wagon(scene *s, double x, double mass, double torque, double speed)
{
	int32_t body, k;
	set_mass(s, mass, 1.2);
	body = add_box(s, CN_BODY_DYNAMIC, x, 5.9, 0.0, 1.0, 0.15);
	for (k = -1; k <= 1; k += 2) {
		int32_t wheel;
		set_mass(s, 0.2 * mass, PI * 0.09);
		wheel = add_disc(s, CN_BODY_DYNAMIC, x + 0.7 * (double)k, 5.42, 0.3);
		s->motor_speed = speed;
		s->motor_max = torque;
		if (chance(s, 0.5))
			add_pin(s, body, wheel, x + 0.7 * (double)k, 5.42);
		else
			add_wheel(s, body, wheel, x + 0.7 * (double)k, 5.42, 0.0, 1.0, 4.0, 0.7, 0.15);
		s->motor_max = 0.0;
	}
	return body;
}

static void build_train(scene *s)
{
	int32_t planks = pick_int(s, 8, 20), wagons = pick_int(s, 1, 4), k, last = WORLD, body;
	double mass = 0.2 * pick_log(s, 1.0, 100.0), half = 0.5 * (double)planks, x = -half - 2.0;
	s->friction = 1.0;
	add_floor(s);
	add_box(s, CN_BODY_STATIC, -half - 15.0, 4.0, 0.0, 15.0, 1.1);
	add_box(s, CN_BODY_STATIC, half + 15.0, 4.0, 0.0, 15.0, 1.1);
	for (k = 0; k < planks; ++k) {
		int32_t plank = add_box(s, CN_BODY_DYNAMIC, (double)k + 0.5 - half, 5.0, 0.0, 0.5, 0.1);
		add_pin(s, last, plank, (double)k - half, 5.0);
		last = plank;
	}
	add_pin(s, WORLD, last, half, 5.0);
	body = add_wagon(s, x, mass, 20.0 * mass, -pick(s, 3.0, 15.0));
	for (k = 0; k < wagons; ++k, x -= 2.6) {
		int32_t next = add_wagon(s, x - 2.6, mass * pick_log(s, 0.3, 3.0), 0.0, 0.0);
		if (chance(s, 0.5))
			add_rod(s, body, next, x - 0.95, 5.9, x - 1.65, 5.9);
		else
			add_pin(s, body, next, x - 1.3, 5.9);
		add_load(s, x - 2.6, 6.05 + 0.3, 0.3, mass * pick_log(s, 0.1, 3.0));
		body = next;
	}
	s->density = 1.0;
	s->flags |= SCENE_NO_ENERGY;
}

/* ---- cradle: 3 to 8 balls of 1 to 1000 kg on rods or chains side by side, the first drawn aside; restitution 0 to 1 ---- */

static void build_cradle(scene *s)
{
	int32_t balls = pick_int(s, 3, 8), rods = chance(s, 0.5), k;
	double ratio = pick_log(s, 1.0, 1000.0), angle = pick(s, 0.3, 1.4), bounce = pick(s, 0.0, 1.0), length = 3.0;
	add_floor(s);
	s->restitution = bounce;
	for (k = 0; k < balls; ++k) {
		double x = 0.801 * (double)k, side = k == 0 ? angle : 0.0, bx = x - length * sin(side), by = 4.0 - length * cos(side);
		double mass = pick_log(s, 1.0, ratio);
		int32_t ball, link;
		set_mass(s, mass, PI * 0.16);
		ball = add_disc(s, CN_BODY_DYNAMIC, bx - 0.4 * sin(side), by - 0.4 * cos(side), 0.4);
		if (rods) {
			add_rod(s, WORLD, ball, x, 4.0, bx, by);
			continue;
		}
		s->group = -1;
		s->density = 1.0;
		link = add_chain(s, WORLD, x, 4.0, bx, by, 6, 0.04);
		add_pin(s, link, ball, bx, by);
		s->group = 0;
	}
}

/* ---- balance: a beam on a pin with a pan on two chains at either end; stacks of 1 to 6 boxes of 1 to 300 kg in the pans ---- */

static void build_balance(scene *s)
{
	int32_t links = pick_int(s, 2, 6), beam, side;
	double ratio = pick_log(s, 1.0, 300.0), y = 6.0, half = pick(s, 2.0, 3.5), pan_half = 0.8, drop = chance(s, 0.5) ? pick(s, 0.1, 0.5) : 0.01;
	add_floor(s);
	s->density = 3.0;
	beam = add_box(s, CN_BODY_DYNAMIC, 0.0, y, 0.0, half, 0.1);
	add_pin(s, WORLD, beam, 0.0, y + 0.05);
	s->density = 1.0;
	for (side = -1; side <= 1; side += 2) {
		double x = half * (double)side;
		int32_t boxes = pick_int(s, 1, 5), pan = add_box(s, CN_BODY_DYNAMIC, x, y - 2.5, 0.0, pan_half, 0.08), k;
		s->group = -1;
		for (k = -1; k <= 1; k += 2) {
			int32_t link = add_chain(s, beam, x, y, x + pan_half * (double)k, y - 2.5, links, 0.03);
			add_pin(s, link, pan, x + pan_half * (double)k, y - 2.5);
		}
		s->group = 0;
		add_stack(s, x, y - 2.42 + drop, 0.12, boxes, ratio);
	}
}

/* ---- wedge: a wedge of 0.3 to 1 rad, driven down by a spring or a motor of up to 1000 weights, parts two blocks that springs press
   together or that press on stacks; friction 0 to 0.8 ---- */

static void build_wedge(scene *s)
{
	int32_t driven = chance(s, 0.5), stacks = chance(s, 0.5), side, wedge;
	double half_angle = pick(s, 0.15, 0.5), mass = pick_log(s, 1.0, 100.0), force = mass * GRAVITY * pick_log(s, 1.0, 1000.0), block = pick_log(s, 0.3, 100.0);
	double high = 2.0, wide = high * tan(half_angle), points[3][2] = { { 0.0, -1.3333 }, { 0.0, 0.6667 }, { 0.0, 0.6667 } };
	s->friction = pick(s, 0.0, 0.8);
	add_floor(s);
	points[1][0] = wide;
	points[2][0] = -wide;
	set_mass(s, mass, wide * high);
	wedge = add_polygon(s, CN_BODY_DYNAMIC, 0.0, 2.35, 0.0, (const double (*)[2])points, 3);
	s->motor_speed = -1.0;
	s->motor_max = driven ? force : 0.0;
	add_slider(s, WORLD, wedge, 0.0, 2.35, 0.0, 1.0, -1.3, 1.0);
	s->motor_max = 0.0;
	if (!driven)
		add_spring(s, WORLD, wedge, 0.0, 8.0, 0.0, 2.35, pick(s, 1.0, 8.0), 0.2, 0.0);
	for (side = -1; side <= 1; side += 2) {
		/* Above its knee the face to the wedge leans as the wedge does. */
		double slope = tan(half_angle), d = (double)side, x = d * 0.8, inner = 0.02 * d - x;
		double corner[5][2] = { { 0.0, -0.75 }, { 0.5, -0.75 }, { 0.5, 0.75 }, { 0.0, 0.75 }, { 0.0, 0.25 } };
		double mirrored[5][2];
		int32_t body, k;
		corner[0][0] = corner[4][0] = d * inner;
		corner[3][0] = d * inner + 0.5 * slope;
		for (k = 0; k < 5; ++k) {
			mirrored[k][0] = d * corner[side > 0 ? k : 4 - k][0];
			mirrored[k][1] = corner[side > 0 ? k : 4 - k][1];
		}
		set_mass(s, block, 1.5);
		body = add_polygon(s, CN_BODY_DYNAMIC, x, 0.76, 0.0, (const double (*)[2])mirrored, 5);
		if (stacks) {
			add_box(s, CN_BODY_STATIC, d * 6.0, 2.0, 0.0, 1.0, 2.0);
			s->density = pick_log(s, 0.3, 30.0);
			add_box(s, CN_BODY_DYNAMIC, d * 3.2, 0.31, 0.0, 0.3, 0.3);
			add_box(s, CN_BODY_DYNAMIC, d * 3.2, 0.92, 0.0, 0.3, 0.3);
			add_box(s, CN_BODY_DYNAMIC, d * 4.2, 0.31, 0.0, 0.3, 0.3);
		} else {
			add_spring(s, WORLD, body, d * 6.0, 0.76, x, 0.76, pick(s, 1.0, 10.0), 0.3, 0.0);
		}
	}
	s->flags |= SCENE_NO_ENERGY;
}

const family workshop_families[] = {
	{ "frame", build_frame, 0 },
	{ "wrecking", build_wrecking, 0 },
	{ "drum", build_drum, SCENE_NO_ENERGY },
	{ "hoist", build_hoist, 0 },
	{ "mattress", build_mattress, 0 },
	{ "rollers", build_rollers, 0 },
	{ "train", build_train, 0 },
	{ "cradle", build_cradle, 0 },
	{ "balance", build_balance, 0 },
	{ "wedge", build_wedge, 0 },
};
const int32_t workshop_family_count = FAMILY_COUNT(workshop_families);
