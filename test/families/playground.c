/*
 * test/families/playground.c - what players and teachers build: trusses, bridges on piers, wheels with gondolas, excavators, grippers, flippers, hoppers,
 * dominoes, belts of links, robot arms, mobiles, tensegrity towers, towed sledges.
 */
#include "families.h"

#include <math.h>

static int32_t add_bar(scene *s, double ax, double ay, double bx, double by, double radius)
{
	double half = 0.5 * hypot(bx - ax, by - ay);
	return add_capsule(s, CN_BODY_DYNAMIC, 0.5 * (ax + bx), 0.5 * (ay + by), atan2(by - ay, bx - ax), fmax(half - radius, 0.1 * half), radius);
}

static int32_t add_block(scene *s, double x, double y, double half, double mass)
{
	set_mass(s, mass, 4.0 * half * half);
	return add_box(s, CN_BODY_DYNAMIC, x, y, 0.0, half, half);
}

/* ---- truss: a bridge of 2 to 10 bays, pinned at both ends, or at one and on a slide, or a cantilever; bars that are pinned to each other, or balls
   and rods; some with crossed diagonals or none, some with a row of planks from an end to a further support; boxes of 1 to 500 bars fall on it ---- */

typedef struct truss_node {
	double x, y;
	int32_t body; /* a ball, or the first bar, to which the others are pinned, or WORLD */
} truss_node;

static void truss_bar(scene *s, truss_node *a, truss_node *b, int32_t rods)
{
	truss_node *ends[2];
	int32_t bar, k;
	if (rods) {
		add_rod(s, a->body, b->body, a->x, a->y, b->x, b->y);
		return;
	}
	ends[0] = a;
	ends[1] = b;
	bar = add_bar(s, a->x, a->y, b->x, b->y, 0.05);
	for (k = 0; k < 2; ++k) {
		if (ends[k]->body != WORLD)
			add_pin(s, ends[k]->body, bar, ends[k]->x, ends[k]->y);
		else
			ends[k]->body = bar;
	}
}

static void truss_approach(scene *s, const truss_node *from)
{
	int32_t planks = pick_int(s, 2, 6), k, last = from->body;
	for (k = 0; k < planks; ++k) {
		int32_t plank = add_bar(s, from->x + (double)k, from->y, from->x + (double)(k + 1), from->y, 0.05);
		add_pin(s, last, plank, from->x + (double)k, from->y);
		last = plank;
	}
	add_pin(s, WORLD, last, from->x + (double)planks, from->y);
}

static void build_truss(scene *s)
{
	int32_t bays = pick_int(s, 2, 10), crossed = chance(s, 0.4), straight = chance(s, 0.2), rods = chance(s, 0.4), held = pick_int(s, 0, 2), loads = pick_int(s, 1, 6), k;
	double load = pick_log(s, 1.0, 500.0), height = pick(s, 0.7, 1.5), bar_mass = 0.2;
	truss_node lower[11], upper[11];
	add_floor(s);
	s->group = -1;
	for (k = 0; k <= bays; ++k) {
		lower[k].x = upper[k].x = (double)k - 0.5 * (double)bays;
		lower[k].y = 6.0;
		upper[k].y = 6.0 + height;
		set_mass(s, 2.0 * bar_mass, PI * 0.04);
		lower[k].body = rods ? add_disc(s, CN_BODY_DYNAMIC, lower[k].x, lower[k].y, 0.2) : WORLD;
		upper[k].body = rods ? add_disc(s, CN_BODY_DYNAMIC, upper[k].x, upper[k].y, 0.2) : WORLD;
	}
	s->density = 2.0;
	for (k = 0; k <= bays; ++k) {
		truss_bar(s, &lower[k], &upper[k], rods);
		if (k == bays)
			break;
		truss_bar(s, &lower[k], &lower[k + 1], rods);
		truss_bar(s, &upper[k], &upper[k + 1], rods);
		if (straight)
			continue;
		if (crossed || k < bays / 2)
			truss_bar(s, &upper[k], &lower[k + 1], rods);
		if (crossed || k >= bays / 2)
			truss_bar(s, &lower[k], &upper[k + 1], rods);
	}
	add_pin(s, WORLD, lower[0].body, lower[0].x, lower[0].y);
	if (held == 0) {
		add_pin(s, WORLD, lower[bays].body, lower[bays].x, lower[bays].y);
	} else if (held == 1) {
		int32_t foot = add_block(s, lower[bays].x, lower[bays].y, 0.1, bar_mass);
		add_slider(s, WORLD, foot, lower[bays].x, lower[bays].y, 1.0, 0.0, 1.0, -1.0);
		add_pin(s, foot, lower[bays].body, lower[bays].x, lower[bays].y);
	} else {
		add_pin(s, WORLD, upper[0].body, upper[0].x, upper[0].y);
	}
	s->density = 2.0;
	if (chance(s, 0.3))
		truss_approach(s, &upper[bays]);
	s->group = 0;
	for (k = 0; k < loads; ++k)
		add_block(s, pick(s, -0.4, 0.4) * (double)bays, 6.0 + height + 0.6 + 0.7 * (double)k, 0.3, bar_mass * load);
}

/* ---- piers: a row of 6 to 40 planks between two walls, some pinned to piers, some with a seat on two chains below; 1 to 6 boxes of 1 to 300 planks
   fall on it ---- */

static void hang_seat(scene *s, int32_t left, int32_t right, double x, double y)
{
	int32_t side, k, seat;
	s->group = -1;
	seat = add_bar(s, x - 0.6, y - 2.0, x + 0.6, y - 2.0, 0.06);
	for (side = -1; side <= 1; side += 2) {
		int32_t last = side < 0 ? left : right;
		for (k = 0; k < 4; ++k) {
			int32_t link = add_bar(s, x + 0.5 * (double)side, y - 0.5 * (double)k, x + 0.5 * (double)side, y - 0.5 * (double)(k + 1), 0.03);
			add_pin(s, last, link, x + 0.5 * (double)side, y - 0.5 * (double)k);
			last = link;
		}
		add_pin(s, last, seat, x + 0.5 * (double)side, y - 2.0);
	}
	s->group = 0;
}

static void build_piers(scene *s)
{
	int32_t planks = pick_int_log(s, 6, 40), piers = pick_int(s, 0, 2), seats = pick_int(s, 0, 2), boxes = pick_int(s, 1, 6), k, row[40];
	double load = pick_log(s, 1.0, 300.0), y = 6.0, half = 0.5 * (double)planks;
	add_floor(s);
	for (k = 0; k < planks; ++k) {
		double x = (double)k - half;
		row[k] = add_bar(s, x, y, x + 1.0, y, 0.08);
		add_pin(s, k > 0 ? row[k - 1] : WORLD, row[k], x, y);
	}
	add_pin(s, WORLD, row[planks - 1], half, y);
	for (k = 1; k <= piers; ++k) {
		int32_t at = k * planks / (piers + 1);
		add_pin(s, WORLD, row[at], (double)at - half + 0.5, y);
	}
	for (k = 0; k < seats; ++k) {
		int32_t at = pick_int(s, 1, planks - 2);
		hang_seat(s, row[at], row[at + 1], (double)at + 1.0 - half, y);
	}
	for (k = 0; k < boxes; ++k)
		add_block(s, pick(s, -0.7, 0.7) * half, y + 0.6 + 0.7 * (double)k, 0.3, 0.16 * load);
	s->density = 1.0;
}

/* ---- ferris: a wheel whose rim of 6 to 14 boards hangs on a driven hub by rods, ropes or welded boards; gondolas of 1 to 300 boards, some with
   boxes in them ---- */

static void build_ferris(scene *s)
{
	int32_t count = pick_int(s, 6, 14), kind = pick_int(s, 0, 2), k, hub, first = WORLD, last = WORLD;
	double radius = pick(s, 2.0, 4.0), y = 6.0, load = pick_log(s, 1.0, 300.0), board, step = 2.0 * PI / (double)count;
	s->group = -1;
	s->density = 3.0;
	hub = add_disc(s, CN_BODY_DYNAMIC, 0.0, y, 0.5);
	s->motor_speed = pick(s, -1.0, 1.0);
	s->motor_max = 1e6;
	add_pin(s, WORLD, hub, 0.0, y);
	s->motor_max = 0.0;
	s->density = 1.0;
	board = 0.1 * 2.0 * radius * sin(0.5 * step);
	for (k = 0; k < count; ++k) {
		double at = step * (double)k, to = step * (double)(k + 1), x = radius * cos(at), up = y + radius * sin(at);
		int32_t rim = add_bar(s, x, up, radius * cos(to), y + radius * sin(to), 0.05), gondola;
		if (k > 0)
			add_pin(s, last, rim, x, up);
		else
			first = rim;
		last = rim;
		if (kind == 0) {
			add_rod(s, hub, rim, 0.5 * cos(at), y + 0.5 * sin(at), x, up);
		} else if (kind == 1) { /* two ropes that cross, as the spokes of a bicycle */
			add_rope(s, hub, rim, 0.5 * cos(at + 0.8), y + 0.5 * sin(at + 0.8), x, up, 0.0);
			add_rope(s, hub, rim, 0.5 * cos(at - 0.8), y + 0.5 * sin(at - 0.8), x, up, 0.0);
		} else {
			int32_t spoke = add_bar(s, 0.5 * cos(at), y + 0.5 * sin(at), x, up, 0.05);
			add_weld(s, hub, spoke, 0.5 * cos(at), y + 0.5 * sin(at));
			add_pin(s, spoke, rim, x, up);
		}
		set_mass(s, board * pick_log(s, 1.0, load), 0.1);
		gondola = add_box(s, CN_BODY_DYNAMIC, x, up - 1.0, 0.0, 0.25, 0.1);
		add_pin(s, rim, gondola, x, up);
		if (chance(s, 0.7) && sin(at) < -0.6) { /* above, it would begin in a rim or a spoke */
			s->group = 0;
			add_block(s, x, up - 0.75, 0.15, board * pick_log(s, 1.0, load));
			s->group = -1;
		}
		s->density = 1.0;
	}
	add_pin(s, last, first, radius, y);
	s->flags |= SCENE_NO_ENERGY;
}

/* ---- excavator: a boom, an arm and a bucket with limits and motors of 1 to 30 times the torque that lifts them dig into 15 to 50 lumps ---- */

static void build_excavator(scene *s)
{
	int32_t lumps = pick_int(s, 15, 50), k, base, boom, arm, bucket;
	double power = pick_log(s, 1.0, 30.0), ratio = pick_log(s, 1.0, 30.0);
	add_pit(s, 9.0);
	s->group = -1;
	s->friction = pick(s, 0.2, 0.9);
	s->density = 20.0;
	base = add_box(s, CN_BODY_DYNAMIC, -5.0, 0.6, 0.0, 1.2, 0.6);
	s->density = 4.0;
	boom = add_bar(s, -4.2, 1.2, -1.2, 4.0, 0.15);
	s->motor_max = power * 1500.0;
	s->motor_speed = -0.5;
	add_pin_limited(s, base, boom, -4.2, 1.2, -1.0, 0.3);
	s->density = 2.0;
	arm = add_bar(s, -1.2, 4.0, 1.5, 3.0, 0.12);
	s->motor_max = power * 300.0;
	s->motor_speed = -0.7;
	add_pin_limited(s, boom, arm, -1.2, 4.0, -1.6, 0.5);
	bucket = add_box(s, CN_BODY_DYNAMIC, 1.5, 2.6, 0.0, 0.5, 0.06);
	attach_box(s, bucket, -0.5, 0.25, 0.0, 0.06, 0.3);
	attach_box(s, bucket, 0.5, 0.15, 0.0, 0.06, 0.2);
	s->motor_max = power * 60.0;
	s->motor_speed = -1.0;
	add_pin_limited(s, arm, bucket, 1.5, 3.0, -1.8, 1.0);
	s->motor_max = 0.0;
	s->group = 0;
	for (k = 0; k < lumps; ++k) {
		double half = pick(s, 0.12, 0.3), x = -2.3 + 0.65 * (double)(k % 17), up = 0.4 + 0.7 * (double)(k / 17); /* below the bucket */
		set_mass(s, pick_log(s, 0.3, 0.3 * ratio), 4.0 * half * half);
		if (chance(s, 0.5))
			add_disc(s, CN_BODY_DYNAMIC, x, up, half);
		else
			add_box(s, CN_BODY_DYNAMIC, x, up, 0.0, half, half);
	}
	s->flags |= SCENE_NO_ENERGY;
}

/* ---- gripper: two jaws press one to six boxes from the sides, with 1.3 to 10 times the force that friction needs, and a gantry lifts them ---- */

static void build_gripper(scene *s)
{
	int32_t boxes = pick_int_log(s, 1, 6), k, carriage, jaws[2];
	double friction = pick(s, 0.3, 1.0), mass = pick_log(s, 0.5, 50.0), safety = pick_log(s, 1.3, 10.0), half = 0.3, width = half * (double)boxes, force;
	double jaw = pick_log(s, 0.1, 20.0);
	s->friction = friction;
	add_floor(s);
	s->group = -1;
	set_mass(s, 10.0, 4.0);
	carriage = add_box(s, CN_BODY_DYNAMIC, 0.0, 3.0, 0.0, width + 1.0, 0.25);
	s->motor_speed = pick(s, 0.2, 1.0);
	s->motor_max = 100.0 * (30.0 + 2.0 * jaw + mass * (double)boxes);
	add_slider(s, WORLD, carriage, 0.0, 3.0, 0.0, 1.0, -0.5, pick(s, 1.0, 3.0));
	force = 0.5 * safety * GRAVITY * mass * (double)boxes / friction;
	for (k = 0; k < 2; ++k) {
		double side = k == 0 ? -1.0 : 1.0, x = side * (width + 0.11);
		set_mass(s, jaw, 0.4);
		jaws[k] = add_box(s, CN_BODY_DYNAMIC, x, 1.0, 0.0, 0.1, 1.0);
		s->motor_speed = -side * 0.5;
		s->motor_max = force;
		add_slider(s, carriage, jaws[k], x, 2.0, 1.0, 0.0, -1.0, 1.0);
	}
	s->motor_max = 0.0;
	s->group = 0;
	for (k = 0; k < boxes; ++k)
		add_block(s, half * (double)(2 * k + 1) - width, half, half, mass);
	s->flags |= SCENE_NO_ENERGY;
}

/* ---- flippers: two bats with limits and motors of 5 to 40 rad/s strike 5 to 30 balls of 0.1 to 10 kg in a pit with pegs ---- */

static void build_flippers(scene *s)
{
	int32_t balls = pick_int(s, 5, 30), k;
	double speed = pick(s, 5.0, 40.0), torque = pick_log(s, 50.0, 5000.0), ratio = pick_log(s, 1.0, 10.0);
	s->restitution = pick(s, 0.0, 0.9);
	add_pit(s, 4.0);
	for (k = 0; k < 2; ++k) {
		double side = k == 0 ? -1.0 : 1.0;
		int32_t bat;
		s->density = 5.0;
		bat = add_bar(s, side * 2.2, 2.0, side * 0.5, 1.4, 0.15);
		s->motor_speed = -side * speed;
		s->motor_max = torque;
		add_pin_limited(s, WORLD, bat, side * 2.2, 2.0, side < 0.0 ? -0.2 : -1.0, side < 0.0 ? 1.0 : 0.2);
		s->motor_max = 0.0;
		add_box(s, CN_BODY_STATIC, side * 3.2, 2.5, -side * 0.4, 1.1, 0.1);
	}
	for (k = 0; k < 6; ++k)
		add_disc(s, CN_BODY_STATIC, -2.5 + (double)k, 6.0 + (double)(k % 2), 0.2);
	for (k = 0; k < balls; ++k) {
		set_mass(s, pick_log(s, 1.0 / ratio, ratio), PI * 0.04);
		add_disc(s, CN_BODY_DYNAMIC, -2.0 + 0.8 * (double)(k % 6), 8.5 + 0.8 * (double)(k / 6), 0.2);
	}
	s->flags |= SCENE_NO_ENERGY;
}

/* ---- hopper: 40 to 120 lumps in a funnel, under a lid of 1 to 300 lumps or none, fall through a neck of 1.2 to 5 of their widths ---- */

static void build_hopper(scene *s)
{
	int32_t lumps = pick_int(s, 40, 120), lid = chance(s, 0.5), k;
	double steep = pick(s, 0.5, 1.2), neck = 0.2 * pick(s, 1.2, 5.0), weight = pick_log(s, 1.0, 300.0), half = 3.0;
	s->friction = pick(s, 0.0, 1.0);
	add_pit(s, 6.0);
	for (k = -1; k <= 1; k += 2) {
		double x = (double)k * (neck + half * cos(steep)), y = 4.0 + half * sin(steep);
		add_box(s, CN_BODY_STATIC, x + (double)k * 0.2 * sin(steep), y - 0.2 * cos(steep), (double)k * steep, half, 0.2);
		add_box(s, CN_BODY_STATIC, (double)k * (neck + 2.0 * half * cos(steep) + 0.2), y + half * sin(steep) + 3.0, 0.0, 0.2, 3.5);
	}
	for (k = 0; k < lumps; ++k) {
		double size = pick(s, 0.1, 0.2), x = -1.0 + 0.45 * (double)(k % 6), y = 4.2 + 2.0 * half * sin(steep) + 0.45 * (double)(k / 6) - 2.0;
		if (chance(s, 0.5))
			add_disc(s, CN_BODY_DYNAMIC, x, y, size);
		else
			add_regular(s, CN_BODY_DYNAMIC, x, y, 0.0, size, pick_int(s, 3, 6));
	}
	if (lid) {
		set_mass(s, weight * 0.08, 1.2);
		add_box(s, CN_BODY_DYNAMIC, 0.0, 4.2 + 2.0 * half * sin(steep) + 0.45 * (double)(lumps / 6) - 1.0, 0.0, 1.5, 0.2);
	}
}

/* ---- dominoes: 8 to 40 in a row, or 2 to 6 storeys of them under planks; masses to 1:20; the first is pushed, or a ball hits it ---- */

static void build_dominoes(scene *s)
{
	int32_t storeys = chance(s, 0.5) ? pick_int(s, 2, 6) : 1, count = storeys > 1 ? pick_int(s, 3, 8) : pick_int(s, 8, 40), i, k, first = 0;
	double thick = pick(s, 0.04, 0.12), high = 0.5, space = pick(s, 0.35, 0.8), ratio = pick_log(s, 1.0, 20.0), y = 0.0, push = pick(s, 0.5, 4.0);
	s->friction = pick(s, 0.2, 0.9);
	add_floor(s);
	for (i = 0; i < storeys; ++i) {
		for (k = 0; k < count; ++k) {
			int32_t made;
			set_mass(s, pick_log(s, 1.0, ratio), 4.0 * thick * high);
			made = add_box(s, CN_BODY_DYNAMIC, space * (double)k, y + high, 0.0, thick, high);
			if (i == storeys - 1 && k == 0)
				first = made;
		}
		y += 2.0 * high;
		if (i == storeys - 1)
			break;
		set_mass(s, pick_log(s, 1.0, ratio), 0.1 * space * (double)count);
		add_box(s, CN_BODY_DYNAMIC, 0.5 * space * (double)(count - 1), y + 0.05, 0.0, 0.5 * space * (double)count, 0.05);
		y += 0.1;
	}
	set_velocity(s, first, push, 0.0, 0.0);
}

/* ---- belt: a closed chain of links with ribs around two driven drums, with idlers below; 2 to 12 boxes of 1 to 100 links ride on it ---- */

static void build_belt(scene *s)
{
	int32_t side = pick_int(s, 8, 20), boxes = pick_int(s, 2, 12), ribs = chance(s, 0.5), turn, count, k, first = WORLD, last = WORLD;
	double radius = pick(s, 0.5, 0.9), link = 0.4, length = link * (double)side, y = 4.0, load = pick_log(s, 1.0, 100.0), thin = 0.05, mass;
	double path_x[64], path_y[64];
	s->friction = pick(s, 0.5, 1.2);
	add_floor(s);
	turn = (int32_t)ceil(PI * (radius + thin) / link);
	count = 2 * (side + turn);
	radius = link / (2.0 * sin(0.5 * PI / (double)turn)); /* the links that turn are the sides of a polygon */
	for (k = 0; k < count; ++k) {
		int32_t part = k % (side + turn), back = k >= side + turn;
		double at, x, up;
		if (part < side) {
			x = -0.5 * length + link * (double)part;
			up = radius;
		} else {
			at = PI * (double)(part - side) / (double)turn;
			x = 0.5 * length + radius * sin(at);
			up = radius * cos(at);
		}
		path_x[k] = back ? -x : x;
		path_y[k] = y + (back ? -up : up);
	}
	s->density = 2.0;
	for (k = -1; k <= 1; k += 2) {
		int32_t drum = add_disc(s, CN_BODY_DYNAMIC, 0.5 * (double)k * length, y, radius * cos(0.5 * PI / (double)turn) - thin);
		s->motor_speed = -2.0;
		s->motor_max = 1e4;
		add_pin(s, WORLD, drum, 0.5 * (double)k * length, y);
		s->motor_max = 0.0;
	}
	add_box(s, CN_BODY_STATIC, 0.0, y + radius - thin - 0.06, 0.0, 0.5 * length - 0.5, 0.05); /* a bed, clear of the drums */
	s->density = 1.0;
	for (k = 0; k < count; ++k) {
		int32_t next = (k + 1) % count, made = add_bar(s, path_x[k], path_y[k], path_x[next], path_y[next], thin);
		if (ribs && k % 4 == 0)
			attach_box(s, made, 0.0, 0.2, 0.0, 0.04, 0.16);
		if (k > 0)
			add_pin(s, last, made, path_x[k], path_y[k]);
		else
			first = made;
		last = made;
	}
	add_pin(s, last, first, path_x[0], path_y[0]);
	mass = link * 2.0 * thin;
	for (k = 0; k < boxes; ++k)
		add_block(s, pick(s, -0.4, 0.4) * length, y + radius + 0.8 + 0.6 * (double)k, 0.2, mass * pick_log(s, 1.0, load));
	s->flags |= SCENE_NO_ENERGY;
}

/* ---- robot: an arm of 3 to 7 links that motors hold, with 0.7 to 100 times the torque that is needed, or welds and limits; a load of up to
   200 links at its end, another falls on it ---- */

static void build_robot(scene *s)
{
	int32_t links = pick_int(s, 3, 7), k, last = WORLD;
	double load = pick_log(s, 0.1, 200.0), power = pick_log(s, 0.7, 100.0), mass = 0.2 * 0.8, x = 0.0, y = 4.0, at = pick(s, -0.5, 0.8), torque;
	add_floor(s);
	s->group = -1;
	torque = power * GRAVITY * mass * (0.5 * (double)(links * links) + load * (double)links);
	for (k = 0; k < links; ++k) {
		int32_t made;
		set_mass(s, mass, 0.16);
		made = add_bar(s, x, y, x + cos(at), y + sin(at), 0.08);
		if (chance(s, 0.8)) {
			s->motor_speed = chance(s, 0.5) ? 0.0 : pick(s, -1.0, 1.0);
			s->motor_max = torque;
			add_pin_limited(s, last, made, x, y, -1.5, 1.5);
			s->motor_max = 0.0;
		} else {
			add_weld(s, last, made, x, y);
		}
		x += cos(at);
		y += sin(at);
		at += pick(s, -0.6, 0.6);
		if (y + sin(at) < 0.5) /* above the floor */
			at = -at;
		last = made;
	}
	k = add_block(s, x, y, 0.2, mass * load);
	add_weld(s, last, k, x, y);
	s->group = 0;
	add_block(s, x - pick(s, 0.0, 1.0), y + pick(s, 0.8, 3.0), 0.2, mass * pick_log(s, 0.1, load + 1.0));
	s->flags |= SCENE_NO_ENERGY;
}

/* ---- mobile: 2 to 5 storeys of beams that hang on ropes, rods or chains, each with a weight or a further beam at its ends ---- */

static void hang_mobile(scene *s, int32_t above, double x, double y, int32_t storeys, double half, double ratio)
{
	int32_t kind = pick_int(s, 0, 2), beam, side, at = above;
	double drop = pick(s, 0.4, 0.8), down = y - drop;
	s->density = 1.0;
	beam = add_bar(s, x - half, down, x + half, down, 0.05);
	if (kind == 0)
		add_rod(s, above, beam, x, y, x, down);
	else if (kind == 1)
		add_rope(s, above, beam, x, y, x, down, 0.0);
	else {
		int32_t link = add_bar(s, x, y, x, y - 0.5 * drop, 0.03), next = add_bar(s, x, y - 0.5 * drop, x, down, 0.03);
		add_pin(s, above, link, x, y);
		add_pin(s, link, next, x, y - 0.5 * drop);
		add_pin(s, next, beam, x, down);
	}
	at = beam;
	for (side = -1; side <= 1; side += 2) {
		double end = x + half * (double)side;
		if (storeys > 1 && chance(s, 0.8)) {
			hang_mobile(s, at, end, down, storeys - 1, 0.45 * half, ratio);
		} else {
			int32_t load = add_block(s, end, down - 0.4, 0.12, 0.1 * pick_log(s, 1.0, ratio));
			add_rope(s, at, load, end, down, end, down - 0.3, 0.0);
		}
	}
}

static void build_mobile(scene *s)
{
	int32_t storeys = pick_int(s, 2, 5);
	double ratio = pick_log(s, 1.0, 1000.0);
	add_floor(s);
	s->group = -1;
	hang_mobile(s, WORLD, 0.0, 8.0, storeys, 3.0, ratio);
	s->group = 0;
	if (chance(s, 0.5)) {
		int32_t ball = add_block(s, -6.0, 7.0, 0.2, 0.1 * pick_log(s, 1.0, ratio));
		set_velocity(s, ball, pick(s, 2.0, 10.0), 3.0, 0.0);
	}
}

/* ---- tensegrity: 1 to 5 storeys of two crossed bars, held by ropes, on the floor or falling on it; a box of up to 100 bars on top ---- */

static void build_tensegrity(scene *s)
{
	int32_t storeys = pick_int(s, 1, 5), k, below[2] = { WORLD, WORLD }, springs = chance(s, 0.3);
	double fall = chance(s, 0.5) ? pick(s, 0.05, 1.0) : 0.0, load = pick_log(s, 1.0, 100.0), high = 1.2, wide = 0.6, y = 0.06 + fall;
	add_floor(s);
	s->group = -1;
	for (k = 0; k < storeys; ++k, y += high) {
		int32_t a = add_bar(s, -wide, y, wide, y + high, 0.06), b = add_bar(s, wide, y, -wide, y + high, 0.06), i;
		for (i = 0; i < 4; ++i) { /* lower, upper, left, right */
			double x0 = i == 3 ? wide : -wide, x1 = i == 2 ? -wide : wide, y0 = i == 1 ? y + high : y, y1 = i == 0 ? y : y + high;
			int32_t from = i == 0 || i == 2 ? a : b, to = i == 0 ? b : i == 1 ? a : i == 2 ? b : a;
			if (i == 3)
				from = b;
			if (springs)
				add_spring(s, from, to, x0, y0, x1, y1, 8.0, 0.5, 0.02);
			else
				add_rope(s, from, to, x0, y0, x1, y1, 0.0);
		}
		if (k > 0) {
			add_pin(s, below[1], a, -wide, y);
			add_pin(s, below[0], b, wide, y);
		}
		below[0] = a;
		below[1] = b;
	}
	s->group = 0;
	add_block(s, 0.0, y + 0.4 + pick(s, 0.0, 1.0), 0.3, 0.2 * load);
	if (springs)
		s->flags |= SCENE_NO_ENERGY;
}

/* ---- tow: a cart with driven wheels tows 1 to 6 sledges of 1 to 100 kg, each with a stack of boxes, by slack ropes or chains over bumps ---- */

static void build_tow(scene *s)
{
	int32_t sledges = pick_int(s, 1, 6), chain = chance(s, 0.5), k, last, wheel;
	double ratio = pick_log(s, 1.0, 100.0), slack = pick(s, 0.0, 0.3), x = 0.0, speed = pick(s, 3.0, 20.0);
	s->friction = pick(s, 0.4, 1.0);
	add_floor(s);
	for (k = 0; k < 8; ++k)
		add_disc(s, CN_BODY_STATIC, 4.0 + 2.5 * (double)k, -0.9 + pick(s, 0.0, 0.1), 1.0);
	set_mass(s, 30.0, 1.6);
	last = add_box(s, CN_BODY_DYNAMIC, x, 0.9, 0.0, 1.0, 0.4);
	for (k = -1; k <= 1; k += 2) {
		set_mass(s, 5.0, PI * 0.16);
		wheel = add_disc(s, CN_BODY_DYNAMIC, x + 0.7 * (double)k, 0.4, 0.4);
		s->motor_speed = -speed;
		s->motor_max = 300.0;
		add_pin(s, last, wheel, x + 0.7 * (double)k, 0.4);
		s->motor_max = 0.0;
	}
	for (k = 0; k < sledges; ++k) {
		double hook = k == 0 ? x - 1.2 : x - 0.8, up = k == 0 ? 0.6 : 0.15;
		int32_t boxes = pick_int(s, 0, 3), sledge, i;
		x = hook - 0.8 - 0.8;
		set_mass(s, pick_log(s, 1.0, ratio), 0.48);
		sledge = add_box(s, CN_BODY_DYNAMIC, x, 0.15, 0.0, 0.8, 0.15);
		if (chain) {
			int32_t links = 4, at = last;
			s->density = 2.0;
			s->group = -1;
			for (i = 0; i < links; ++i) {
				double t = (double)i / (double)links, u = (double)(i + 1) / (double)links;
				double ax = hook - 0.8 * t, ay = up + (0.15 - up) * t;
				int32_t link = add_bar(s, ax, ay, hook - 0.8 * u, up + (0.15 - up) * u, 0.04);
				add_pin(s, at, link, ax, ay);
				at = link;
			}
			add_pin(s, at, sledge, x + 0.8, 0.15);
			s->group = 0;
		} else {
			add_rope(s, last, sledge, hook, up, x + 0.8, 0.15, slack);
		}
		for (i = 0; i < boxes; ++i)
			add_block(s, x, 0.3 + 0.25 + 0.5 * (double)i, 0.25, pick_log(s, 1.0, ratio));
		last = sledge;
	}
	s->flags |= SCENE_NO_ENERGY;
}

const family playground_families[] = {
	{ "truss", build_truss, 0 },
	{ "piers", build_piers, 0 },
	{ "ferris", build_ferris, 0 },
	{ "excavator", build_excavator, 0 },
	{ "gripper", build_gripper, 0 },
	{ "flippers", build_flippers, 0 },
	{ "hopper", build_hopper, 0 },
	{ "dominoes", build_dominoes, 0 },
	{ "belt", build_belt, 0 },
	{ "robot", build_robot, 0 },
	{ "mobile", build_mobile, 0 },
	{ "tensegrity", build_tensegrity, 0 },
	{ "tow", build_tow, 0 },
};
const int32_t playground_family_count = FAMILY_COUNT(playground_families);
