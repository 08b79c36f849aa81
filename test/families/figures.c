/*
 * test/families/figures.c - ragdolls with limits and motors, soft rings and blobs of springs.
 */
#include "families.h"

#include <math.h>

typedef struct bone {
	double y, half, radius; /* of an upright capsule, m */
	int32_t parent;
	double pin_y, lower, upper; /* limits, rad */
} bone;

/* Hip, torso, head, then two legs and two arms of two bones each. */
static const bone bones[] = {
	{ 0.95, 0.02, 0.095, -1, 0.0, 0.0, 0.0 },
	{ 1.2, 0.135, 0.09, 0, 1.0, -0.8, 0.0 },
	{ 1.475, 0.04, 0.075, 1, 1.4, -0.9, 0.3 },
	{ 0.775, 0.125, 0.06, 0, 0.9, -0.15, 1.2 },
	{ 0.475, 0.14, 0.045, 3, 0.625, -1.5, 0.0 },
	{ 0.775, 0.125, 0.06, 0, 0.9, -0.15, 1.2 },
	{ 0.475, 0.14, 0.045, 5, 0.625, -1.5, 0.0 },
	{ 1.225, 0.125, 0.035, 1, 1.35, -0.3, 2.5 },
	{ 0.975, 0.125, 0.03, 7, 1.1, -0.6, 0.9 },
	{ 1.225, 0.125, 0.035, 1, 1.35, -0.3, 2.5 },
	{ 0.975, 0.125, 0.03, 9, 1.1, -0.6, 0.9 },
};
#define BONES ((int32_t)(sizeof bones / sizeof *bones))

static void add_ragdoll(scene *s, double x, double y, double size, double motor_max)
{
	int32_t made[sizeof bones / sizeof *bones], k;
	--s->group;
	for (k = 0; k < BONES; ++k) {
		const bone *b = &bones[k];
		made[k] = add_capsule(s, CN_BODY_DYNAMIC, x, y + size * b->y, 0.5 * PI, size * b->half, size * b->radius);
		s->motor_max = motor_max;
		s->motor_speed = pick(s, -2.0, 2.0);
		if (b->parent >= 0)
			add_pin_limited(s, made[b->parent], made[k], x, y + size * b->pin_y, b->lower, b->upper);
		s->motor_max = 0.0;
	}
}

/* 2 to 12 figures of 1.2 to 2 m fall into a pit or onto the floor; a third have motors of 0.05 to 1 Nm in all joints. */
static void build_ragdolls(scene *s)
{
	int32_t count = pick_int(s, 2, 12), k;
	double motor_max = chance(s, 0.33) ? pick_log(s, 0.05, 1.0) : 0.0, wide = pick(s, 1.5, 3.0);
	s->friction = pick(s, 0.0, 1.0);
	if (motor_max > 0.0)
		s->flags |= SCENE_NO_ENERGY;
	if (chance(s, 0.6))
		add_pit(s, wide);
	else
		add_floor(s);
	for (k = 0; k < count; ++k) {
		double size = pick(s, 0.75, 1.25), jitter = pick(s, -0.1, 0.1);
		add_ragdoll(s, 0.8 * (double)(k % 3 - 1) + jitter, 0.5 + 2.1 * (double)(k / 3), size, motor_max);
	}
}

/* A ring of 8 to 24 discs joined by rods, pins or springs, with spokes of springs to a hub or without. */
static void add_blob(scene *s, double x, double y, double radius)
{
	int32_t count = pick_int(s, 8, 24), kind = pick_int(s, 0, 2), spokes = chance(s, 0.7), k, node[24], hub = 0;
	double hertz = pick_log(s, 2.0, 15.0), damping = pick(s, 0.0, 1.0), disc = 0.8 * radius * sin(PI / (double)count);
	--s->group;
	if (spokes)
		hub = add_disc(s, CN_BODY_DYNAMIC, x, y, 0.3 * radius);
	for (k = 0; k <= count; ++k) {
		double a = 2.0 * PI * (double)k / (double)count, b = 2.0 * PI * (double)(k - 1) / (double)count;
		double ax = x + radius * cos(a), ay = y + radius * sin(a), bx = x + radius * cos(b), by = y + radius * sin(b);
		int32_t mine = k < count ? (node[k] = add_disc(s, CN_BODY_DYNAMIC, ax, ay, disc)) : node[0];
		if (k > 0 && kind == 0)
			add_rod(s, node[k - 1], mine, bx, by, ax, ay);
		else if (k > 0 && kind == 1)
			add_pin(s, node[k - 1], mine, 0.5 * (ax + bx), 0.5 * (ay + by));
		else if (k > 0)
			add_spring(s, node[k - 1], mine, bx, by, ax, ay, 2.0 * hertz, damping, 0.2);
		if (spokes && k < count)
			add_spring(s, hub, mine, x, y, ax, ay, hertz, damping, 0.0);
	}
}

/* 1 to 6 of them fall onto the floor or into a pit; half with a heavy box on top. */
static void build_blobs(scene *s)
{
	int32_t count = pick_int(s, 1, 6), k;
	s->friction = pick(s, 0.0, 1.0);
	if (chance(s, 0.5))
		add_pit(s, 3.2);
	else
		add_floor(s);
	for (k = 0; k < count; ++k) {
		double radius = pick(s, 0.6, 1.1), jitter = pick(s, -0.1, 0.1);
		add_blob(s, (k % 2 == 0 ? -1.6 : 1.6) + jitter, 1.6 + 3.0 * (double)(k / 2), radius);
	}
	s->group = 0;
	if (chance(s, 0.5)) {
		set_mass(s, pick_log(s, 1.0, 100.0), 1.0);
		add_box(s, CN_BODY_DYNAMIC, 0.0, 0.6 + 3.0 * (double)((count + 1) / 2), 0.0, 0.5, 0.5);
	}
}

const family figure_families[] = {
	{ "ragdolls", build_ragdolls, 0 },
	{ "blobs", build_blobs, SCENE_NO_ENERGY },
};
const int32_t figure_family_count = FAMILY_COUNT(figure_families);
