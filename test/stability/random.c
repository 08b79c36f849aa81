/*
 * test/stability/random.c - random scenes in a closed room. No motors, springs or moving walls: energy can only fall,
 * every number stays finite and every body stays inside.
 *
 * Bodies start in cells that do not overlap; some neighbours are pinned to each other half way.
 */
#include "scene.h"

#include <math.h>

#define ROOM_HALF 8.0 /* floor at y = 0, ceiling at 2 ROOM_HALF */
#define WALL_HALF 1.0
#define CELL 2.2
#define COLUMNS 6

typedef struct random_state {
	uint32_t random;
	double energy_start, energy_most, outside;
	int32_t broken;
} random_state;

/* xorshift32 (Marsaglia, 2003). */
static double pick(scene_run *run, double lower, double upper)
{
	random_state *state = run->state;
	state->random ^= state->random << 13;
	state->random ^= state->random >> 17;
	state->random ^= state->random << 5;
	return lower + (upper - lower) * (double)state->random / 4294967296.0;
}

static void make_room(scene_run *run)
{
	double r = ROOM_HALF, h = WALL_HALF;
	scene_box(run, CN_BODY_STATIC, 0.0, -h, 0.0, r + 2.0 * h, h);
	scene_box(run, CN_BODY_STATIC, 0.0, 2.0 * r + h, 0.0, r + 2.0 * h, h);
	scene_box(run, CN_BODY_STATIC, -r - h, r, 0.0, h, r + 2.0 * h);
	scene_box(run, CN_BODY_STATIC, r + h, r, 0.0, h, r + 2.0 * h);
}

static cn_body make_body(scene_run *run, double x, double y)
{
	double kind = pick(run, 0.0, 3.0), big = pick(run, 0.2, 0.6), angle = pick(run, -SCENE_PI, SCENE_PI);
	cn_body body;
	run->density = pow(10.0, pick(run, -1.0, 1.0));
	run->friction = pick(run, 0.0, 1.0);
	run->restitution = pick(run, 0.0, 1.0);
	if (kind < 1.0)
		return scene_circle(run, CN_BODY_DYNAMIC, x, y, big);
	if (kind < 2.0)
		return scene_box(run, CN_BODY_DYNAMIC, x, y, angle, big, pick(run, 0.1, 0.6));
	body = scene_body(run, CN_BODY_DYNAMIC, x, y, angle);
	scene_capsule_shape(run, body, -0.6 * big, 0.0, 0.6 * big, 0.0, 0.4 * big);
	return body;
}

static void random_build(scene_run *run)
{
	random_state *state = run->state;
	int32_t bodies = scene_count(run, "bodies"), k;
	double speed = scene_value(run, "speed"), joints = scene_value(run, "joints");
	cn_body previous = 0;
	state->random = (uint32_t)scene_count(run, "seed") * 2654435761u + 1u;
	make_room(run);
	for (k = 0; k < bodies; ++k) {
		double x = CELL * ((double)(k % COLUMNS) - 0.5 * (double)(COLUMNS - 1)), y = 1.5 + CELL * (double)(k / COLUMNS);
		cn_body body = make_body(run, x, y);
		/* One number a statement: the order of arguments is the compiler's. */
		double vx = pick(run, -speed, speed), vy = pick(run, -speed, speed), w = pick(run, -speed, speed);
		scene_set_velocity(run, body, vx, vy, w);
		if (k % COLUMNS > 0 && pick(run, 0.0, 1.0) < joints)
			scene_pin(run, previous, body, x - 0.5 * CELL, y);
		previous = body;
	}
	state->energy_start = state->energy_most = scene_energy(run);
}

static void random_observe(scene_run *run)
{
	random_state *state = run->state;
	double reach = ROOM_HALF * scene_value(run, "size");
	int32_t k;
	state->energy_most = scene_greater(state->energy_most, scene_energy(run));
	state->broken += scene_broken_count(run);
	for (k = 0; k < run->item_count; ++k) {
		scene_motion m = scene_read(run, k);
		state->outside = scene_greater(state->outside, fmax(fabs(m.x), fabs(m.y - reach)) - reach);
	}
}

/* lost: bodies whose centre is in a wall or beyond at the end. */
static void random_finish(scene_run *run)
{
	const random_state *state = run->state;
	double reach = ROOM_HALF * scene_value(run, "size");
	int32_t k, lost = 0;
	for (k = 0; k < run->item_count; ++k) {
		scene_motion m = scene_read(run, k);
		lost += !(fabs(m.x) < reach && m.y > 0.0 && m.y < 2.0 * reach);
	}
	scene_report(run, "energy_max_over_E0", state->energy_most / state->energy_start);
	scene_report(run, "not_finite", (double)state->broken);
	scene_report(run, "lost", (double)lost);
	scene_report(run, "outside_max_m", state->outside);
}

const scene_family random_families[] = {
	{ "random", "seed=1 bodies=30 speed=5 joints=0.4 seconds=5", sizeof(random_state), random_build, random_observe, random_finish },
};
const int32_t random_family_count = (int32_t)(sizeof random_families / sizeof *random_families);
