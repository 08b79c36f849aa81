/*
 * test/families/vehicles.c - vehicles with suspension on rough ground, and tracked ones.
 */
#include "families.h"

#include <math.h>

/* Static boxes of 1 to 3 m, turned by up to 0.3 rad, half sunk; small dynamic stones between. */
static void add_rough_ground(scene *s, double length)
{
	double rough = pick(s, 0.0, 0.3), x = -4.0;
	int32_t stones = pick_int(s, 0, 15), k;
	add_floor(s);
	while (x < length) {
		double half = pick(s, 0.5, 1.5), angle = pick(s, -rough, rough);
		x += 2.0 * half;
		if (x > 5.0)
			add_box(s, CN_BODY_STATIC, x, -0.2, angle, half, 0.2);
	}
	for (k = 0; k < stones; ++k) {
		double size = pick(s, 0.1, 0.25), at = pick(s, 6.0, length);
		add_box(s, CN_BODY_DYNAMIC, at, 0.7 + 0.6 * (double)k, pick(s, 0.0, PI), size, size);
	}
}

static int32_t add_vehicle(scene *s, double x, int32_t wheels, double ratio, double hertz, double damping)
{
	double half = 0.6 * (double)wheels, radius = 0.45, travel = pick(s, 0.1, 0.3), speed = -pick(s, 5.0, 40.0), torque = pick_log(s, 1.0, 50.0);
	int32_t body, k;
	--s->group;
	s->density = ratio;
	body = add_box(s, CN_BODY_DYNAMIC, x, 1.3, 0.0, half, 0.3);
	s->density = 1.0;
	for (k = 0; k < wheels; ++k) {
		double at = x + half * (2.0 * (double)k / (double)(wheels - 1) - 1.0);
		int32_t wheel = add_disc(s, CN_BODY_DYNAMIC, at, 0.5, radius);
		s->motor_speed = speed;
		s->motor_max = k == 0 || wheels > 2 ? torque * ratio : 0.0;
		add_wheel(s, body, wheel, at, 0.5, 0.0, 1.0, hertz, damping, travel);
		s->motor_max = 0.0;
	}
	return body;
}

/* 2 to 6 wheels on springs of 2 to 10 Hz, a body of 1 to 30 times their density; a third pull a trailer on a pin. Friction
   0.3 to 2. */
static void build_vehicles(scene *s)
{
	int32_t wheels = pick_int(s, 2, 6), trailer = chance(s, 0.33), first, second;
	double ratio = pick_log(s, 1.0, 30.0), hertz = pick_log(s, 2.0, 10.0), damping = pick(s, 0.1, 1.0);
	s->friction = pick(s, 0.3, 2.0);
	add_rough_ground(s, 40.0);
	first = add_vehicle(s, 0.0, wheels, ratio, hertz, damping);
	if (trailer) {
		double back = -0.6 * (double)wheels - 0.5;
		second = add_vehicle(s, back - 0.5 - 1.2, 2, ratio, hertz, damping);
		add_pin(s, first, second, back, 1.3);
	}
	s->group = 0;
	s->seconds = 5.0;
}

/* A track: two straights and two half circles, run through counter-clockwise from the left end of the lower straight. */
typedef struct track {
	double half_span, radius, y, perimeter;
} track;

static void track_point(const track *t, double at, double *out)
{
	double length = 2.0 * t->half_span, bend = PI * t->radius, angle;
	at = fmod(at, t->perimeter);
	if (at < length || (at >= length + bend && at < 2.0 * length + bend)) {
		out[0] = at < length ? at - t->half_span : t->half_span - (at - length - bend);
		out[1] = at < length ? t->y - t->radius : t->y + t->radius;
		return;
	}
	angle = (at < length + bend ? at - length : at - 2.0 * length) / t->radius - 0.5 * PI;
	out[0] = (at < length + bend ? t->half_span : -t->half_span) + t->radius * cos(angle);
	out[1] = t->y + t->radius * sin(angle);
}

static void add_plates(scene *s, const track *t, int32_t plates, double thin)
{
	double plate = t->perimeter / (double)plates;
	int32_t k, first = 0, previous = 0;
	for (k = 0; k < plates; ++k) {
		double from[2], to[2];
		int32_t link;
		track_point(t, plate * (double)k, from);
		track_point(t, plate * (double)(k + 1), to);
		link = add_box(s, CN_BODY_DYNAMIC, 0.5 * (from[0] + to[0]), 0.5 * (from[1] + to[1]), atan2(to[1] - from[1], to[0] - from[0]), 0.4 * plate, thin);
		if (k == 0)
			first = link;
		else
			add_pin(s, previous, link, from[0], from[1]);
		previous = link;
	}
	add_pin(s, previous, first, -t->half_span, t->y - t->radius);
}

/* A tracked vehicle: plates of 0.25 to 0.4 m pinned to a loop around 3 to 5 driven wheels on a body of 1 to 30 times their density;
   eight bumps on the floor ahead. Friction 0.5 to 2. */
static void build_tracks(scene *s)
{
	int32_t wheels = pick_int(s, 3, 5), k, body;
	double radius = 0.5, spacing = 1.1, thin = 0.05, y = 1.0, plate = pick(s, 0.25, 0.4), ratio = pick_log(s, 1.0, 30.0), torque = pick_log(s, 5.0, 100.0);
	track t;
	s->friction = pick(s, 0.5, 2.0);
	add_floor(s);
	for (k = 0; k < 8; ++k)
		add_box(s, CN_BODY_STATIC, 5.0 + 1.5 * (double)k, -0.15, pick(s, -0.25, 0.25), 0.6, 0.2);
	t.half_span = 0.5 * spacing * (double)(wheels - 1);
	t.radius = radius + thin + 0.01 + plate * plate / (8.0 * radius); /* clear of the wheels in the middle of a plate */
	t.y = y;
	t.perimeter = 4.0 * t.half_span + 2.0 * PI * t.radius;
	s->group = -1;
	s->density = ratio;
	body = add_box(s, CN_BODY_DYNAMIC, 0.0, y, 0.0, t.half_span, 0.2);
	s->density = 1.0;
	s->group = 0;
	for (k = 0; k < wheels; ++k) {
		double x = spacing * (double)k - t.half_span;
		int32_t wheel = add_disc(s, CN_BODY_DYNAMIC, x, y, radius);
		s->motor_speed = -pick(s, 2.0, 10.0);
		s->motor_max = torque * ratio;
		add_pin(s, body, wheel, x, y);
		s->motor_max = 0.0;
	}
	add_plates(s, &t, (int32_t)(t.perimeter / plate), thin);
}

const family vehicle_families[] = {
	{ "vehicles", build_vehicles, SCENE_NO_ENERGY },
	{ "tracks", build_tracks, SCENE_NO_ENERGY },
};
const int32_t vehicle_family_count = FAMILY_COUNT(vehicle_families);
