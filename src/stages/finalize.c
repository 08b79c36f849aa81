/*
 * stages/finalize.c - stage 8: the step's changes become poses.
 *
 * For each awake body: speed limits, new pose, rest timer, cleared forces, boxes. Reads and writes bodies,
 * motion, drive, proxies (through the broadphase's move).
 *
 * A body rests while it is slow and does not accelerate: at the apex of a throw the last substep's change of
 * velocity is all of what gravity gives, on the ground it is nearly none of it.
 *
 * Workers may share all of it but for what the broadphase is told: they give proxies their new boxes, and one tells it in
 * the order of the bodies which those are.
 */
#include "base/cpu.h"
#include "stages/solver.h"
#if CNI_HAS_WIDE_4
#define CNI_WIDTH 4
#include "base/wide.h"
#endif

#include <stddef.h>

#define BODIES_A_RANGE 256 /* some ten microseconds: records and shapes are read */
#define BODIES_NEAR 64     /* whose records are still near after a loop over them */

/* What floats could not hold, among absurd speeds, does not become a pose: the body stays where it is, and stands. */
static void keep_finite(cni_motion *m)
{
	float zero = 0.0f * m->vx + 0.0f * m->vy + 0.0f * m->w + 0.0f * m->dpx + 0.0f * m->dpy + 0.0f * m->theta;
	if (zero != 0.0f)
		m->vx = m->vy = m->w = m->dpx = m->dpy = m->theta = 0.0f;
}

/* Written so that what is not a number is looked at too. */
static void limit_speed(cni_motion *m, const cni_settings *set)
{
	float v_sq = m->vx * m->vx + m->vy * m->vy, most = set->linear_speed_max;
	if (!(v_sq <= most * most)) {
		float scale = most / cni_sqrt(v_sq);
		m->vx *= scale;
		m->vy *= scale;
		keep_finite(m);
	}
	if (!(cni_abs(m->w) <= set->angular_speed_max)) {
		m->w = cni_clamp(m->w, -set->angular_speed_max, set->angular_speed_max);
		keep_finite(m);
	}
}

/* high + low += change, keeping what high cannot hold (Dekker, 1971). */
static void sum_exactly(float *high, float *low, float change)
{
	float rest = *low + change, sum = *high + rest;
	*low = rest - (sum - *high);
	*high = sum;
}

/* Rotation by any angle a body can turn in a step. */
static cni_rot rotate_by(cni_rot q, float theta)
{
	return cni_rot_normalize(cni_rot_mul(q, cni_sincos(theta)));
}

/* Flags that tell of the way that is taken. */
#define OF_THE_WAY ((uint32_t)CNI_BODY_AHEAD | (uint32_t)CNI_BODY_AT_STATIC)

/* A change too small to show in the pose only goes into the low part: the body did not move for anyone to see. */
static void take_pose(cni_body *b, cni_motion *m)
{
	cni_vec2 before = cni_body_origin(b), after;
	cni_rot q = b->q;
	b->flags &= ~OF_THE_WAY;
	sum_exactly(&b->cx, &b->cx_low, m->dpx);
	sum_exactly(&b->cy, &b->cy_low, m->dpy);
	if (m->theta != 0.0f)
		b->q = rotate_by(b->q, m->theta);
	after = cni_body_origin(b);
	cni_body_set_room(b, cni_body_room(b) - cni_body_reach(b, m->dpx, m->dpy, m->theta));
	if (before.x != after.x || before.y != after.y || q.c != b->q.c || q.s != b->q.s)
		b->flags |= CNI_BODY_MOVED;
	m->dpx = m->dpy = m->theta = 0.0f;
}

#if CNI_HAS_WIDE_4

static void sum_exactly_wide(cni_wide *high, cni_wide *low, cni_wide change)
{
	cni_wide rest = *low + change, sum = *high + rest;
	*low = rest - (sum - *high);
	*high = sum;
}

/* take_pose of four bodies in a row, with its bits. 0: one turns too far, and nothing was done. */
static int32_t take_poses(cni_body *const *b, cni_motion *m)
{
	const int32_t row[4] = { 0, 1, 2, 3 }, at_center = (int32_t)(offsetof(cni_body, cx) / sizeof(float)), at_rotation = (int32_t)(offsetof(cni_body, q) / sizeof(float));
	float *const records[4] = { (float *)(void *)b[0], (float *)(void *)b[1], (float *)(void *)b[2], (float *)(void *)b[3] };
	cni_wide extent = { b[0]->extent, b[1]->extent, b[2]->extent, b[3]->extent };
	cni_wide dx, dy, turn, inv_inertia, x, y, x_low, y_low, c, s, lx, ly, before_x, before_y, turn_c, turn_s, new_c, new_s, length, reach;
	cni_mask turns, same;
	uint32_t moved;
	int32_t l;
	cni_wide_gather4(&m->dpx, (int32_t)(sizeof *m / sizeof(float)), row, &dx, &dy, &turn, &inv_inertia);
	if (cni_mask_bits(cni_wide_abs(turn) <= cni_wide_of(CNI_NEAR_RAD)) != 15u)
		return 0;
	cni_wide_gather4_from((const float *const *)records, at_center, &x, &y, &x_low, &y_low);
	cni_wide_gather4_from((const float *const *)records, at_rotation, &c, &s, &lx, &ly);
	before_x = x - (c * lx - s * ly) + x_low;
	before_y = y - (s * lx + c * ly) + y_low;
	sum_exactly_wide(&x, &x_low, dx);
	sum_exactly_wide(&y, &y_low, dy);
	cni_wide_sincos_near(turn, &turn_c, &turn_s);
	new_c = c * turn_c - s * turn_s;
	new_s = s * turn_c + c * turn_s;
	length = cni_wide_sqrt(new_c * new_c + new_s * new_s);
	turns = turn != cni_wide_of(0.0f);
	new_c = cni_wide_select(turns, new_c / length, c);
	new_s = cni_wide_select(turns, new_s / length, s);
	same = (before_x == x - (new_c * lx - new_s * ly) + x_low) & (before_y == y - (new_s * lx + new_c * ly) + y_low) & (c == new_c) & (s == new_s);
	moved = ~cni_mask_bits(same);
	reach = cni_wide_max(cni_wide_abs(dx), cni_wide_abs(dy)) + cni_wide_abs(turn) * extent + cni_wide_of(CNI_BODY_ROUNDING) * (cni_wide_abs(x) + cni_wide_abs(y) + extent);
	for (l = 0; l < 4; ++l) {
		cni_body_set_room(b[l], cni_body_room(b[l]) - reach[l]);
		b[l]->flags = (b[l]->flags & ~OF_THE_WAY) | (moved >> l & 1u ? (uint32_t)CNI_BODY_MOVED : 0u);
	}
	cni_wide_scatter4_to(records, at_center, x, y, x_low, y_low);
	cni_wide_scatter4_to(records, at_rotation, new_c, new_s, lx, ly);
	dx = cni_wide_of(0.0f);
	cni_wide_scatter4(&m->dpx, (int32_t)(sizeof *m / sizeof(float)), row, dx, dx, dx, inv_inertia);
	return 1;
}

#else

static int32_t take_poses(cni_body *const *b, cni_motion *m)
{
	(void)b;
	(void)m;
	return 0;
}

#endif

static int32_t body_accelerates(const cni_body *b, const cni_motion *m, const cni_velocity_start *start, const cni_drive *d, float h)
{
	float change = d->flags & CNI_DRIVE_DAMPED ? h * cni_damping_factor(b->linear_damping, h) : h, ax = change * d->ax, ay = change * d->ay, dx, dy;
	if (d->flags & CNI_DRIVE_FREE)
		return ax != 0.0f || ay != 0.0f;
	dx = m->vx - start->vx + ax;
	dy = m->vy - start->vy + ay;
	return dx * dx + dy * dy > 0.01f * (ax * ax + ay * ay);
}

static void rest_update(cn_world *world, cni_body *b, int32_t k, const cni_solve *s)
{
	const cni_motion *m = cni_motions(world) + k;
	float slow = b->sleep_speed > 0.0f ? b->sleep_speed : world->settings.sleep_speed;
	float turn = m->w * b->extent;
	if (m->vx * m->vx + m->vy * m->vy <= slow * slow && turn * turn <= slow * slow && (b->flags & CN_BODY_SLEEP) &&
	    (b->type != CN_BODY_KINEMATIC || (m->vx == 0.0f && m->vy == 0.0f && m->w == 0.0f)) &&
	    !body_accelerates(b, m, cni_starts(world) + k, cni_drives(world) + k, s->h))
		b->sleep_time += s->dt;
	else
		b->sleep_time = 0.0f;
}

void cni_poses_take(cn_world *world)
{
	int32_t k;
	for (k = 1; k < world->awake_count; ++k) {
		cni_body *b = cni_body_at(world, cni_awake_ids(world)[k]);
		cni_motion *m = cni_motions(world) + k;
		take_pose(b, m);
		cni_body_look_ahead(world, b, cni_v(0.0f, 0.0f));
	}
}

enum { MOVED_NONE = -1, MOVED_SEVERAL = -2 };

typedef struct pose_loop {
	cn_world *world;
	const cni_solve *s;
	int32_t *moved; /* of each body: the proxy that has a new box, MOVED_NONE or MOVED_SEVERAL */
	uint32_t rested;
} pose_loop;

/* Everything of a body but its pose and boxes. Returns 1 when it has rested for long enough. */
static uint32_t body_finalize(cn_world *world, const cni_solve *s, cni_body *b, int32_t k)
{
	const cni_motion *m = cni_motions(world) + k;
	cni_drive *d = cni_drives(world) + k;
	b->vx = m->vx;
	b->vy = m->vy;
	b->w = m->w;
	rest_update(world, b, k, s);
	d->ax = d->ay = d->alpha = 0.0f;
	return b->sleep_time >= world->settings.sleep_delay && b->sleep_time > 0.0f;
}

/* The records of four bodies from k on. */
static void bodies_of(const cn_world *world, int32_t k, cni_body **b)
{
	const int32_t *ids = cni_awake_ids(world) + k;
	b[0] = cni_body_at(world, ids[0]);
	b[1] = cni_body_at(world, ids[1]);
	b[2] = cni_body_at(world, ids[2]);
	b[3] = cni_body_at(world, ids[3]);
}

/* Poses of bodies within their speed limits. */
static void poses_range(cn_world *world, int32_t begin, int32_t end)
{
	cni_motion *motions = cni_motions(world);
	const int32_t *ids = cni_awake_ids(world);
	int32_t k;
	cni_body *b[4];
	for (k = begin; k < end; ++k)
		limit_speed(&motions[k], &world->settings);
	for (k = begin; k + 4 <= end; k += 4) {
		bodies_of(world, k, b);
		if (take_poses(b, &motions[k]))
			continue;
		take_pose(b[0], &motions[k]);
		take_pose(b[1], &motions[k + 1]);
		take_pose(b[2], &motions[k + 2]);
		take_pose(b[3], &motions[k + 3]);
	}
	for (; k < end; ++k)
		take_pose(cni_body_at(world, ids[k]), &motions[k]);
}

static cni_vec2 way_ahead(const cn_world *world, const cni_solve *s, int32_t k)
{
	const cni_motion *m = cni_motions(world) + k;
	return cni_v(s->dt * m->vx, s->dt * m->vy);
}

/* Must its boxes be looked at? */
static int32_t body_boxes_may_leave(const cn_world *world, const cni_solve *s, const cni_body *b, int32_t k)
{
	return (b->flags & CNI_BODY_MOVED) && !cni_body_has_room(b, way_ahead(world, s, k));
}

static void boxes_look_ahead(cn_world *world, const cni_solve *s, cni_body *b, int32_t k)
{
	if (cni_body_look_ahead(world, b, way_ahead(world, s, k)))
		b->flags |= CNI_BODY_AHEAD;
}

/* Gives a body's box its new bounds; where there are several, one looks again. */
static int32_t body_boxes_set(cn_world *world, const cni_solve *s, cni_body *b, int32_t k)
{
	cni_box_move move;
	int32_t left = cni_body_boxes_left(world, b, way_ahead(world, s, k), &move);
	if (left > 1)
		return MOVED_SEVERAL;
	if (move.reaches)
		b->flags |= CNI_BODY_AHEAD;
	if (left == 0)
		return MOVED_NONE;
	cni_proxy_set_fat(cni_proxy_at(world, move.proxy), &move.fat);
	return move.proxy;
}

static void pose_range(void *context, int32_t begin, int32_t end, int32_t worker)
{
	pose_loop *loop = (pose_loop *)context;
	cn_world *world = loop->world;
	uint32_t rested = 0;
	int32_t k;
	(void)worker;
	poses_range(world, begin + 1, end + 1);
	for (k = begin + 1; k <= end; ++k) {
		cni_body *b = cni_body_at(world, cni_awake_ids(world)[k]);
		rested |= body_finalize(world, loop->s, b, k);
		loop->moved[k] = body_boxes_may_leave(world, loop->s, b, k) ? body_boxes_set(world, loop->s, b, k) : MOVED_NONE;
	}
	if (rested)
		cni_atomic_add(&loop->rested, 1u);
}

/* Tells the broadphase of one box at a time, in the order of the bodies. Bodies with several look again. */
static void boxes_tell(cn_world *world, const cni_solve *s, const int32_t *moved)
{
	int32_t k;
	for (k = 1; k < world->awake_count; ++k) {
		if (moved[k] >= 0)
			world->broadphase_ops->move(world->broadphase, moved[k]);
		else if (moved[k] == MOVED_SEVERAL)
			boxes_look_ahead(world, s, cni_body_at(world, cni_awake_ids(world)[k]), k);
	}
}

static uint32_t finalize_shared(cn_world *world, const cni_solve *s, int32_t *moved)
{
	pose_loop loop;
	loop.world = world;
	loop.s = s;
	loop.moved = moved;
	loop.rested = 0;
	cni_parallel_for(world, world->awake_count - 1, BODIES_A_RANGE, pose_range, &loop);
	boxes_tell(world, s, moved);
	return loop.rested;
}

static uint32_t finalize_alone(cn_world *world, const cni_solve *s)
{
	uint32_t rested = 0;
	int32_t begin, k, end;
	for (begin = 1; begin < world->awake_count; begin = end) {
		end = cni_min_i(begin + BODIES_NEAR, world->awake_count);
		poses_range(world, begin, end);
		for (k = begin; k < end; ++k) {
			cni_body *b = cni_body_at(world, cni_awake_ids(world)[k]);
			rested |= body_finalize(world, s, b, k);
			if (body_boxes_may_leave(world, s, b, k))
				boxes_look_ahead(world, s, b, k);
		}
	}
	return rested;
}

int32_t cni_stage_finalize(cn_world *world, const cni_solve *s)
{
	int32_t *moved = NULL;
	uint32_t rested;
	if (world->team != NULL && world->awake_count > 2 * BODIES_A_RANGE)
		moved = (int32_t *)cni_arena_push(&world->arena, sizeof(int32_t) * (uint64_t)world->awake_count);
	rested = moved != NULL ? finalize_shared(world, s, moved) : finalize_alone(world, s);
	cni_arena_pop(&world->arena, moved);
	world->broadphase_ops->settle(world->broadphase);
	return rested != 0;
}
