/*
 * test/families/contraptions.c - parts joined by every type of joint, some soft or of bounded force, some parts that cannot turn.
 */
#include "families.h"

#include <math.h>

/* ---- contraption: 6 to 60 parts in rows over the ground, hung or falling; each joined to one or two before it ---- */

static int32_t add_part(scene *s, double x, double y, double ratio)
{
	double size = pick(s, 0.2, 0.4), thin = pick(s, 0.08, 0.2), angle = pick(s, -PI, PI);
	int32_t kind = pick_int(s, 0, 2), part;
	s->density = pick_log(s, 1.0, ratio);
	if (kind == 0)
		part = add_disc(s, CN_BODY_DYNAMIC, x, y, size);
	else if (kind == 1)
		part = add_box(s, CN_BODY_DYNAMIC, x, y, angle, size, thin);
	else
		part = add_capsule(s, CN_BODY_DYNAMIC, x, y, angle, 0.6 * size, 0.4 * size);
	if (chance(s, 0.1))
		lock_rotation(s, part);
	return part;
}

/* What needs a pin beside it, as it holds an angle alone. */
static void add_turning(scene *s, int32_t a, int32_t b, double x, double y, int32_t kind)
{
	double hertz = pick_log(s, 0.5, 30.0), ratio = pick_log(s, 0.3, 3.0);
	add_pin(s, a, b, x, y);
	if (kind == 0)
		add_ratchet(s, a, b, chance(s, 0.5) ? 0.3 : -0.3);
	else if (kind == 1)
		add_rotary_spring(s, a, b, hertz, 0.2);
	else
		add_gear(s, a, b, chance(s, 0.5) ? ratio : -ratio);
}

static void add_any_joint(scene *s, int32_t a, int32_t b)
{
	const scene_body p = s->bodies[a], q = s->bodies[b];
	double x = 0.5 * (p.x + q.x), y = 0.5 * (p.y + q.y), ux = q.x - p.x, uy = q.y - p.y, mass = pick_log(s, 1.0, 100.0);
	int32_t kind = pick_int(s, 0, 12);
	if (chance(s, 0.1))
		s->joint_hertz = pick_log(s, 1.0, 60.0);
	else if (chance(s, 0.1))
		s->joint_force = mass * GRAVITY;
	if (chance(s, 0.15)) {
		s->motor_speed = pick(s, -3.0, 3.0);
		s->motor_max = pick_log(s, 0.1, 100.0) * GRAVITY;
	}
	switch (kind) {
	case 0: add_pin(s, a, b, x, y); break;
	case 1: add_pin_limited(s, a, b, x, y, -0.5, 0.5); break;
	case 2: add_rod(s, a, b, p.x, p.y, q.x, q.y); break;
	case 3: add_rope(s, a, b, p.x, p.y, q.x, q.y, 0.1); break;
	case 4: add_spring(s, a, b, p.x, p.y, q.x, q.y, pick_log(s, 1.0, 30.0), 0.2, chance(s, 0.5) ? 0.3 : 0.0); break;
	case 5: add_weld(s, a, b, x, y); break;
	case 6: add_slider(s, a, b, x, y, ux, uy, -0.2, 0.2); break;
	case 7: add_wheel(s, a, b, x, y, ux, uy, pick_log(s, 1.0, 10.0), 0.5, 0.2); break;
	case 8: add_groove(s, a, b, x, y, x + 0.3 * ux, y + 0.3 * uy); break;
	case 9: add_motor_to(s, a, b, x, y, pick_log(s, 1.0, 1000.0) * GRAVITY); break;
	default: add_turning(s, a, b, x, y, kind - 10); break;
	}
	s->joint_hertz = s->joint_force = s->motor_max = 0.0;
}

static void build_contraption(scene *s)
{
	int32_t parts = pick_int_log(s, 6, 60), columns = pick_int(s, 2, 8), k, row[8];
	double ratio = pick_log(s, 1.0, 300.0), loops = pick(s, 0.0, 0.6), y = pick(s, 1.0, 5.0);
	s->friction = pick(s, 0.0, 1.0);
	s->group = chance(s, 0.3) ? -1 : 0;
	s->joint_flags = chance(s, 0.5) ? CN_JOINT_COLLIDE : 0;
	for (k = 0; k < parts; ++k) {
		int32_t column = k % columns, above = k >= columns ? row[column] : WORLD;
		int32_t part = add_part(s, (double)column, y + (double)((parts - 1) / columns - k / columns), ratio);
		if (column > 0 && (above == WORLD || chance(s, loops)))
			add_any_joint(s, row[column - 1], part);
		if (above != WORLD)
			add_any_joint(s, above, part);
		row[column] = part;
	}
	if (chance(s, 0.5))
		add_pin(s, WORLD, 0, s->bodies[0].x, s->bodies[0].y);
	s->group = 0;
	s->density = 1.0;
	add_floor(s);
	s->flags |= SCENE_NO_ENERGY;
}

const family contraption_families[] = {
	{ "contraption", build_contraption, 0 },
};
const int32_t contraption_family_count = FAMILY_COUNT(contraption_families);
