/*
 * test/families/compounds.c - bodies of several shapes: heaps of concave parts, crushed ones, chains of hooks, cups with balls, meshing
 * cogs, stirrers; and slabs that fall on columns.
 */
#include "families.h"

#include <math.h>

/* A body of boxes on a grid of `size`, thickness `thin`: kind 0 L, 1 T, 2 U, 3 H, 4 C with lips, 5 plus. */
static int32_t add_part(scene *s, double x, double y, double angle, double size, double thin, int32_t kind)
{
	double arm = size - thin;
	int32_t body = add_box(s, CN_BODY_DYNAMIC, x, y, angle, size, thin);
	if (kind == 0)
		attach_box(s, body, -arm, size, 0.0, thin, arm);
	else if (kind == 1)
		attach_box(s, body, 0.0, size, 0.0, thin, arm);
	else if (kind == 3 || kind == 5)
		attach_box(s, body, kind == 3 ? -arm : 0.0, 0.0, 0.0, thin, size);
	if (kind == 3)
		attach_box(s, body, arm, 0.0, 0.0, thin, size);
	if (kind == 2 || kind == 4) {
		attach_box(s, body, -arm, size, 0.0, thin, arm);
		attach_box(s, body, arm, size, 0.0, thin, arm);
	}
	if (kind == 4)
		attach_box(s, body, -0.5 * arm, 2.0 * arm, 0.0, 0.5 * arm, thin);
	return body;
}

/* Parts in rows of four from y up; returns the height above them. */
static double add_parts(scene *s, int32_t count, double ratio, double y)
{
	int32_t k;
	for (k = 0; k < count; ++k) {
		double size = pick(s, 0.25, 0.5), thin = size * pick(s, 0.12, 0.3), angle = pick(s, -PI, PI), jitter = pick(s, -0.05, 0.05), mass = pick_log(s, 1.0, ratio);
		int32_t kind = pick_int(s, 0, 5);
		set_mass(s, mass, 8.0 * size * thin);
		add_part(s, 1.8 * (double)(k % 4) - 2.7 + jitter, y + 1.8 * (double)(k / 4), angle, size, thin, kind);
	}
	return y + 1.8 * (double)((count + 3) / 4);
}

/* ---- compounds: 8 to 50 parts fall into a pit; masses to 1:2 to 1:100; friction 0 to 1.5 ---- */

static void build_compounds(scene *s)
{
	int32_t count = pick_int_log(s, 8, 50);
	double ratio = pick_log(s, 2.0, 100.0);
	s->friction = pick(s, 0.0, 1.5);
	add_pit(s, 3.8);
	add_parts(s, count, ratio, 1.0);
}

/* ---- crushed: a slab of 10 to 1e4 times their mass falls on 4 to 20 parts ---- */

static void build_crushed(scene *s)
{
	int32_t count = pick_int(s, 4, 20);
	double mass = pick_log(s, 10.0, 1e4), height;
	s->friction = pick(s, 0.0, 1.0);
	add_pit(s, 3.8);
	height = add_parts(s, count, 2.0, 1.0);
	set_mass(s, mass, 3.6 * 2.0 * 0.6);
	add_box(s, CN_BODY_DYNAMIC, 0.0, height + pick(s, 0.5, 4.0), 0.0, 3.6, 0.3);
}

/* ---- anvil: a slab of 10 to 1e4 times a box's mass falls from 0.1 to 10 m on 1 to 4 columns of 1 to 4 boxes, each column one body or loose ---- */

static void build_anvil(scene *s)
{
	int32_t columns = pick_int(s, 1, 4), rows = pick_int(s, 1, 4), whole = chance(s, 0.5), i, k, body = 0;
	double mass = pick_log(s, 10.0, 1e4), drop = pick_log(s, 0.1, 10.0), lean = chance(s, 0.5) ? pick(s, -0.05, 0.05) : 0.0;
	s->friction = pick(s, 0.0, 1.0);
	add_floor(s);
	for (k = 0; k < columns; ++k)
		for (i = 0; i < rows; ++i) {
			double x = 1.2 * (double)k - 0.6 * (double)(columns - 1);
			set_mass(s, 1.0, 0.25);
			if (!whole || i == 0)
				body = add_box(s, CN_BODY_DYNAMIC, x, 0.25 + 0.5 * (double)i, 0.0, 0.25, 0.25);
			else
				attach_box(s, body, 0.0, 0.5 * (double)i, 0.0, 0.25, 0.25);
		}
	set_mass(s, mass, 4.8 * 0.6);
	add_box(s, CN_BODY_DYNAMIC, 0.0, 0.5 * (double)rows + drop + 0.45, lean, 2.4, 0.3);
}

/* ---- hooks: 2 to 10 C-shaped hooks, open to either side in turn, each hung in the one above by contact alone; the last weighs 1 to 1000
   times another ---- */

static void build_hooks(scene *s)
{
	int32_t count = pick_int(s, 2, 10), k;
	double size = 0.4, thin = pick(s, 0.03, 0.06), load = pick_log(s, 1.0, 1000.0), pitch = 0.8, push = pick(s, -2.0, 2.0);
	s->friction = pick(s, 0.1, 1.0);
	add_floor(s);
	add_box(s, CN_BODY_STATIC, 0.0, 1.0 + pitch * (double)(count + 1), 0.0, 0.5 * size, thin);
	for (k = 0; k < count; ++k) {
		double y = 1.0 + pitch * (double)(count - k), side = k % 2 == 0 ? 1.0 : -1.0;
		int32_t body;
		set_mass(s, k == count - 1 ? load : 1.0, 4.0 * thin * (1.5 * size + 0.5 * pitch));
		body = add_box(s, CN_BODY_DYNAMIC, 0.25 * size * side, y, 0.0, 0.75 * size, thin);
		attach_box(s, body, (0.75 * size - thin) * side, 0.5 * pitch + thin, 0.0, thin, 0.5 * pitch);
		attach_box(s, body, 0.0, pitch + 2.0 * thin, 0.0, 0.75 * size, thin);
	}
	if (chance(s, 0.5))
		set_velocity(s, s->body_count - 1, push, 0.0, 0.0);
}

/* ---- cup: a U of 1 to 100 kg with 3 to 30 balls and boxes in it hangs on two rods, stands, or flies into a wall ---- */

static void build_cup(scene *s)
{
	int32_t kind = pick_int(s, 0, 2), count = pick_int_log(s, 3, 30), k, body;
	double wide = 1.0, thin = pick(s, 0.04, 0.12), mass = pick_log(s, 1.0, 100.0), ratio = pick_log(s, 1.0, 100.0), y = 2.0, speed = pick(s, 3.0, 20.0);
	s->friction = pick(s, 0.0, 1.0);
	add_floor(s);
	add_box(s, CN_BODY_STATIC, 4.0, 10.0, 0.0, 0.5, 10.0);
	set_mass(s, mass, 7.0 * thin * wide);
	y = kind == 0 ? 2.0 : thin + 0.001;
	body = add_box(s, CN_BODY_DYNAMIC, 0.0, y, 0.0, wide, thin);
	attach_box(s, body, -wide + thin, wide + thin, 0.0, thin, wide);
	attach_box(s, body, wide - thin, wide + thin, 0.0, thin, wide);
	if (kind == 0) {
		add_rod(s, WORLD, body, -wide, y + 6.0, -wide, y + 2.0 * wide);
		add_rod(s, WORLD, body, wide, y + 6.0, wide, y + 2.0 * wide);
	}
	for (k = 0; k < count; ++k) {
		double r = pick(s, 0.1, 0.17), ball = pick_log(s, 1.0, ratio), px = 0.4 * (double)(k % 4) - 0.6, py = y + thin + 0.2 + 0.4 * (double)(k / 4);
		int32_t lump;
		set_mass(s, ball, 4.0 * r * r);
		lump = chance(s, 0.5) ? add_disc(s, CN_BODY_DYNAMIC, px, py, r) : add_box(s, CN_BODY_DYNAMIC, px, py, 0.0, r, r);
		if (kind > 0)
			set_velocity(s, lump, kind == 1 ? 0.0 : speed, 0.0, 0.0);
	}
	if (kind != 1)
		set_velocity(s, body, kind == 0 ? 0.3 * speed : speed, 0.0, 0.0);
}

/* ---- cogs: 2 to 5 wheels with 8 teeth in a row, meshing by contact, masses to 1:100; the first has a motor, the last may wind up a load ---- */

static int32_t add_cog(scene *s, double x, double y, double radius, double angle)
{
	int32_t k, body = add_disc(s, CN_BODY_DYNAMIC, x, y, radius);
	for (k = 0; k < 8; ++k) {
		double a = angle + 0.25 * PI * (double)k;
		attach_box(s, body, (radius + 0.08) * cos(a), (radius + 0.08) * sin(a), a, 0.1, 0.1);
	}
	add_pin(s, WORLD, body, x, y);
	return body;
}

static void build_cogs(scene *s)
{
	int32_t count = pick_int(s, 2, 5), k, body = 0;
	double radius = 0.6, ratio = pick_log(s, 1.0, 100.0);
	s->friction = pick(s, 0.0, 0.6);
	add_floor(s);
	s->flags |= SCENE_NO_ENERGY;
	s->motor_speed = pick(s, 0.5, 6.0);
	for (k = 0; k < count; ++k) {
		double mass = pick_log(s, 1.0, ratio);
		set_mass(s, mass, PI * radius * radius);
		s->motor_max = k == 0 ? 200.0 * ratio : 0.0;
		body = add_cog(s, (2.0 * radius + 0.2) * (double)k, 3.0, radius, k % 2 == 0 ? 0.0 : 0.125 * PI);
	}
	s->motor_max = 0.0;
	set_mass(s, pick_log(s, 1.0, 10.0), 0.25);
	k = add_box(s, CN_BODY_DYNAMIC, (2.0 * radius + 0.2) * (double)(count - 1), 1.0, 0.0, 0.25, 0.25);
	add_rod(s, body, k, (2.0 * radius + 0.2) * (double)(count - 1) + 0.3, 3.0, (2.0 * radius + 0.2) * (double)(count - 1), 1.25);
}

/* ---- stirrer: a driven cross of 3 to 5 blades turns in a pit of 10 to 60 lumps and parts ---- */

static void build_stirrer(scene *s)
{
	int32_t blades = pick_int(s, 3, 5), count = pick_int_log(s, 10, 40), k, body;
	double ratio = pick_log(s, 1.0, 100.0);
	s->friction = pick(s, 0.0, 1.0);
	s->flags |= SCENE_NO_ENERGY;
	add_pit(s, 3.8);
	set_mass(s, pick_log(s, 1.0, 100.0), 1.0);
	body = add_disc(s, CN_BODY_DYNAMIC, 0.0, 2.6, 0.3);
	for (k = 0; k < blades; ++k) {
		double a = 2.0 * PI * (double)k / (double)blades;
		attach_box(s, body, 1.2 * cos(a), 1.2 * sin(a), a, 1.1, 0.08);
	}
	s->motor_speed = pick(s, 0.5, 5.0);
	s->motor_max = pick_log(s, 1e3, 1e5);
	add_pin(s, WORLD, body, 0.0, 2.6);
	s->motor_max = 0.0;
	add_parts(s, count, ratio, 6.0);
}

const family compound_families[] = {
	{ "compounds", build_compounds, 0 },
	{ "crushed", build_crushed, 0 },
	{ "anvil", build_anvil, 0 },
	{ "hooks", build_hooks, 0 },
	{ "cup", build_cup, 0 },
	{ "cogs", build_cogs, SCENE_NO_ENERGY },
	{ "stirrer", build_stirrer, SCENE_NO_ENERGY },
};
const int32_t compound_family_count = FAMILY_COUNT(compound_families);
