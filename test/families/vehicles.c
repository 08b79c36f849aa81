/*
 * test/families/vehicles.c - vehicles on rough ground, tracks, a trailer.
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
		s->bodies[second].reach = fmax(s->bodies[second].reach, 0.1);
		add_pin(s, first, second, back, 1.3);
	}
	s->group = 0;
	s->seconds = 5.0;
}

/* A tracked vehicle: 20 to 40 plates pinned to a loop around 3 to 5 wheels on fixed axles of a body. */
static void build_tracks(scene *s)
{
	int32_t wheels = pick_int(s, 3, 5), plates, k, first = 0, previous = 0, body, straight;
	double radius = 0.5, spacing = 1.1, half_span = 0.5 * spacing * (double)(wheels - 1), thin = 0.05, loop = radius + thin + 0.02, length, plate;
	double ratio = pick_log(s, 1.0, 30.0), y = 1.0, torque = pick_log(s, 5.0, 100.0), perimeter;
	s->friction = pick(s, 0.5, 2.0);
	add_floor(s);
	for (k = 0; k < 8; ++k)
		add_box(s, CN_BODY_STATIC, 5.0 + 1.5 * (double)k, -0.15, pick(s, -0.25, 0.25), 0.6, 0.2);
	--s->group;
	s->density = ratio;
	body = add_box(s, CN_BODY_DYNAMIC, 0.0, y, 0.0, half_span, 0.2);
	s->density = 1.0;
	for (k = 0; k < wheels; ++k) {
		double x = spacing * (double)k - half_span;
		int32_t wheel;
		s->group = 0;
		wheel = add_disc(s, CN_BODY_DYNAMIC, x, y, radius);
		s->motor_speed = -pick(s, 2.0, 10.0);
		s->motor_max = torque * ratio;
		add_pin(s, body, wheel, x, y);
		s->motor_max = 0.0;
	}
	/* Plates along two straights and two half circles of the same perimeter. */
	perimeter = 4.0 * half_span + 2.0 * PI * loop;
	plates = (int32_t)(perimeter / pick(s, 0.25, 0.4));
	plate = perimeter / (double)plates;
	length = 2.0 * half_span;
	straight = 0;
	(void)straight;
	for (k = 0; k < plates; ++k) {
		double ends[2][2];
		int32_t e, link;
		for (e = 0; e < 2; ++e) {
			double at = fmod(plate * (double)(k + e), perimeter), angle;
			if (at < length) {
				ends[e][0] = -half_span + at;
				ends[e][1] = y - loop;
			} else if (at < length + PI * loop) {
				angle = (at - length) / loop - 0.5 * PI;
				ends[e][0] = half_span + loop * cos(angle);
				ends[e][1] = y + loop * sin(angle);
			} else if (at < 2.0 * length + PI * loop) {
				ends[e][0] = half_span - (at - length - PI * loop);
				ends[e][1] = y + loop;
			} else {
				angle = (at - 2.0 * length - PI * loop) / loop + 0.5 * PI;
				ends[e][0] = -half_span + loop * cos(angle);
				ends[e][1] = y + loop * sin(angle);
			}
		}
		link = add_box(s, CN_BODY_DYNAMIC, 0.5 * (ends[0][0] + ends[1][0]), 0.5 * (ends[0][1] + ends[1][1]), atan2(ends[1][1] - ends[0][1], ends[1][0] - ends[0][0]),
			0.4 * plate, thin);
		if (k == 0)
			first = link;
		else
			add_pin(s, previous, link, ends[0][0], ends[0][1]);
		if (k == plates - 1)
			add_pin(s, link, first, ends[1][0], ends[1][1]);
		previous = link;
	}
}

const family vehicle_families[] = {
	{ "vehicles", build_vehicles, SCENE_NO_ENERGY },
	{ "tracks", build_tracks, SCENE_NO_ENERGY },
};
const int32_t vehicle_family_count = FAMILY_COUNT(vehicle_families);
