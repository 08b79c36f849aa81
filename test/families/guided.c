/*
 * test/families/guided.c - bodies with constraints of their own: their angles within limits, points of them on lines in the world.
 */
#include "families.h"

#include <math.h>

/* ---- guided: 2 to 40 parts in columns over the ground, most of them with an angle or a line to keep to, some joined to the one before ---- */

static void add_guide(scene *s, int32_t part)
{
	const scene_body b = s->bodies[part];
	double room = pick(s, 0.0, 0.6), tolerance = chance(s, 0.5) ? pick_log(s, 0.001, 0.2) : 0.0, slope = pick(s, 0.0, PI);
	double upper = chance(s, 0.5) ? pick(s, 0.1, 3.0) : -1.0, off_x = 0.0, off_y = 0.0;
	if (chance(s, 0.1))
		s->joint_hertz = pick_log(s, 1.0, 60.0);
	if (chance(s, 0.5))
		add_angle_constraint(s, part, b.angle - (chance(s, 0.2) ? 0.0 : room), b.angle + room);
	if (chance(s, 0.4)) {
		off_x = pick(s, -0.2, 0.2);
		off_y = pick(s, -0.2, 0.2);
	}
	if (chance(s, 0.3))
		slope = 0.5 * PI;
	else if (chance(s, 0.2))
		slope = 0.0;
	if (chance(s, 0.6))
		add_line_constraint(s, part, b.x + off_x, b.y + off_y, cos(slope), sin(slope), tolerance, upper < 0.0 ? 0.0 : -upper, upper);
	s->joint_hertz = 0.0;
}

static int32_t add_guided(scene *s, double x, double y, double ratio)
{
	double size = pick(s, 0.2, 0.45), thin = pick(s, 0.1, 0.4), angle = chance(s, 0.5) ? 0.0 : pick(s, -PI, PI);
	int32_t kind = pick_int(s, 0, 2);
	s->density = pick_log(s, 1.0, ratio);
	if (kind == 0)
		return add_disc(s, CN_BODY_DYNAMIC, x, y, size);
	if (kind == 1)
		return add_box(s, CN_BODY_DYNAMIC, x, y, angle, size, thin);
	return add_capsule(s, CN_BODY_DYNAMIC, x, y, angle, 0.6 * size, 0.4 * size);
}

static void build_guided(scene *s)
{
	int32_t parts = pick_int_log(s, 2, 40), columns = pick_int(s, 1, 6), k, before = WORLD;
	double ratio = pick_log(s, 1.0, 300.0), joined = chance(s, 0.5) ? pick(s, 0.0, 0.6) : 0.0, guided = pick(s, 0.3, 1.0);
	s->friction = pick(s, 0.0, 1.0);
	s->joint_flags = chance(s, 0.5) ? CN_JOINT_COLLIDE : 0;
	for (k = 0; k < parts; ++k) {
		double x = 1.1 * (double)(k % columns), y = 0.6 + 1.1 * (double)(k / columns);
		int32_t part = add_guided(s, x, y, ratio);
		if (chance(s, guided))
			add_guide(s, part);
		if (before != WORLD && chance(s, joined)) {
			const scene_body b = s->bodies[before];
			if (chance(s, 0.5))
				add_pin(s, before, part, 0.5 * (b.x + x), 0.5 * (b.y + y));
			else
				add_rod(s, before, part, b.x, b.y, x, y);
		}
		before = part;
	}
	s->density = 1.0;
	add_floor(s);
	s->flags |= SCENE_NO_ENERGY;
}

const family guided_families[] = {
	{ "guided", build_guided, 0 },
};
const int32_t guided_family_count = FAMILY_COUNT(guided_families);
