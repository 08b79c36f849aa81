/*
 * step/finalize.c - stage 8: the step's displacements become poses.
 *
 * For each awake body: speed limits, new pose, rest timer, cleared forces, boxes. Reads and writes bodies, motion, external,
 * proxies (through the broadphase's move).
 *
 * A body rests while it is slow and does not accelerate: at the apex of a throw the last substep's change of velocity is all of
 * what gravity gives, on the ground it is almost zero. A slow acceleration, as on a slightly too steep slope, cannot be
 * separated from the noise of one substep, but it adds up over the sleep delay: see cni_body_gains. A body does not rest either while an overlap or a joint
 * error is being corrected, which is motion without velocity: see pushed_most of cni_solve.
 *
 * Workers may share all of it except the calls of the broadphase: workers write new boxes into proxies, and one thread reports
 * them to the broadphase in the order of the bodies.
 */
#include "step/stages.h"
#include "base/bitset.h"
#include "step/integrate_pass.h"

#include <stddef.h>
#include <string.h>

#define BODIES_A_RANGE 256 /* some ten microseconds: records and shapes are read */
#define READBACK_STEPS 64u
#define BODIES_MANY 4096   /* whose shapes and boxes are not near anyway */
#define BODIES_NEAR 64     /* whose records are still near after a loop over them; bits of a word */

/* The conditions also catch NaN. Returns 1 for a body that is stopped. */
static uint32_t limit_speed(cni_motion *m, const cni_settings *set)
{
	uint32_t stopped = 0;
	float v_sq = m->vx * m->vx + m->vy * m->vy, most = set->linear_speed_max;
	if (!(v_sq <= most * most)) {
		float scale = most / cni_sqrt(v_sq);
		m->vx *= scale;
		m->vy *= scale;
		stopped = cni_motion_keep_finite(m);
	}
	if (!(cni_abs(m->w) <= set->angular_speed_max)) {
		m->w = cni_clamp(m->w, -set->angular_speed_max, set->angular_speed_max);
		stopped |= cni_motion_keep_finite(m);
	}
	return stopped;
}

/* high + low += change, keeping what high cannot hold (Dekker, 1971). */
static void sum_exactly(float *high, float *low, float change)
{
	float rest = *low + change, sum = *high + rest;
	*low = rest - (sum - *high);
	*high = sum;
}

/* A change too small for the pose only enters the low part: the body does not count as moved. */
static void take_pose(cn_world *world, int32_t body, cni_motion *m)
{
	cni_body *b = cni_body_at(world, body);
	cn_pose before = cni_body_pose(b), after;
	cn_body_moved *shown;
	b->flags &= ~CNI_BODY_OF_THE_WAY;
	sum_exactly(&b->cx, &b->cx_low, m->dpx);
	sum_exactly(&b->cy, &b->cy_low, m->dpy);
	if (m->theta != 0.0f)
		b->q = cni_rot_normalize(cni_rot_mul(b->q, cni_sincos(m->theta)));
	after = cni_body_pose(b);
	cni_body_set_room(b, cni_body_room(b) - cni_body_reach(b, m->dpx, m->dpy, m->theta));
	if (before.position_m.x != after.position_m.x || before.position_m.y != after.position_m.y || before.cosine != after.cosine ||
	    before.sine != after.sine)
		b->flags |= CNI_BODY_MOVED;
	if (world->readback_kept) {
		shown = cni_readback_at(world, body);
		shown->pose = after;
		shown->fell_asleep = b->flags & CNI_BODY_MOVED ? world->step_count + 1u : 0u;
	}
	m->dpx = m->dpy = m->theta = 0.0f;
}

static int32_t body_accelerates(const cn_world *world, const cni_body *b, const cni_motion *m, const cni_velocity_start *start, const cni_external *d, float h)
{
	float change = d->flags & CNI_EXTERNAL_DAMPED ? h * cni_damping_factor(b->linear_damping, h) : h, ax = change * d->ax, ay = change * d->ay, dx, dy;
	if (d->flags & CNI_EXTERNAL_FREE) /* floats are held by areas, up to rounding */
		return !(b->flags & CNI_BODY_IN_AREA) && (ax != 0.0f || ay != 0.0f);
	dx = m->vx - start->vx + ax;
	dy = m->vy - start->vy + ay;
	return dx * dx + dy * dy > CNI_REST_CHANGE_PART * CNI_REST_CHANGE_PART * (ax * ax + ay * ay) + cni_little_change_sq(world, h);
}

/* Sum of speed gains without the effect of damping: damping brings a body to rest and never reverses it. */
static int32_t body_gains(const cn_world *world, cni_body *b, const cni_motion *m, uint32_t drive_flags, float dt)
{
	float damped = drive_flags & CNI_EXTERNAL_DAMPED ? dt : 0.0f, linear = damped * b->linear_damping, angular = damped * b->angular_damping;
	cni_gain_limits limits = cni_gain_limits_make(world, dt);
	return cni_body_gains(b, m, m->vx - b->vx + linear * m->vx, m->vy - b->vy + linear * m->vy, m->w - b->w + angular * m->w, &limits);
}

/* Does the step move the body by more than its velocity? The sequential solver has moved it by its velocity at the start already. */
static int32_t body_is_pushed(const cn_world *world, const cni_solve *s, const cni_body *b, int32_t k)
{
	static const cni_velocity_start none = { 0.0f, 0.0f, 0.0f, 0.0f };
	const cni_motion *m = cni_motions(world) + k;
	const cni_velocity_start *moved = world->settings.solver == CN_SOLVER_SEQUENTIAL ? cni_starts(world) + k : &none;
	return cni_is_pushed(m->dpx + s->dt * (moved->vx - m->vx), m->dpy + s->dt * (moved->vy - m->vy), (m->theta + s->dt * (moved->w - m->w)) * b->extent, s->pushed_most);
}

/* Stores velocity and rest timer, and clears the forces. Returns 1 when the body has rested long enough. */
static uint32_t body_rest(cn_world *world, cni_body *b, int32_t k, const cni_solve *s, int32_t pushed)
{
	const cni_motion *m = cni_motions(world) + k;
	cni_external *d = cni_externals(world) + k;
	float slow = b->sleep_speed >= 0.0f ? b->sleep_speed : world->settings.sleep_speed;
	float turn = m->w * b->extent;
	if (pushed || !(m->vx * m->vx + m->vy * m->vy <= slow * slow && turn * turn <= slow * slow && (b->flags & CN_BODY_SLEEP) &&
	      (b->type != CN_BODY_KINEMATIC || (m->vx == 0.0f && m->vy == 0.0f && m->w == 0.0f))))
		cni_body_restless(b);
	else if (body_accelerates(world, b, m, cni_starts(world) + k, d, s->h) || body_gains(world, b, m, d->flags, s->dt))
		b->sleep_time = 0.0f;
	else
		b->sleep_time += s->dt;
	memcpy(&b->vx, &m->vx, 3 * sizeof(float));
	d->ax = d->ay = d->alpha = 0.0f;
	return b->sleep_time >= world->settings.sleep_delay && b->sleep_time > 0.0f;
}

void cni_poses_take(cn_world *world)
{
	for (int32_t k = 1; k < world->awake_count; ++k) {
		take_pose(world, cni_awake_ids(world)[k], cni_motions(world) + k);
		(void)cni_body_boxes_set(world, cni_body_at(world, cni_awake_ids(world)[k]), cni_v(0.0f, 0.0f), world);
	}
}

static cni_vec2 way_ahead(const cn_world *world, const cni_solve *s, int32_t k)
{
	const cni_motion *m = cni_motions(world) + k;
	return cni_v(s->dt * m->vx, s->dt * m->vy);
}

/* Updates all of a body except its boxes. Returns 1 if these have no room for the way ahead. */
static uint32_t body_take(cn_world *world, const cni_solve *s, int32_t k, uint32_t *rested)
{
	cni_motion *m = cni_motions(world) + k;
	cni_body *b = cni_body_at(world, cni_awake_ids(world)[k]);
	if (limit_speed(m, &world->settings))
		(void)cni_atomic_add(&world->bodies_stopped, 1u);
	int32_t pushed = body_is_pushed(world, s, b, k);
	take_pose(world, cni_awake_ids(world)[k], m);
	*rested |= body_rest(world, b, k, s, pushed);
	return !cni_body_has_room(b, way_ahead(world, s, k));
}

static int32_t bit_take(uint64_t *bits)
{
	int32_t bit = cni_bit_lowest64(*bits);
	*bits &= *bits - 1u;
	return bit;
}

/* The same for at most BODIES_NEAR bodies. Bit k: the boxes of body begin + k have no room for its way ahead. */
static uint64_t bodies_take(cn_world *world, const cni_solve *s, int32_t begin, int32_t end, uint32_t *rested)
{
	cni_poses_taken taken = { ~(uint64_t)0 >> (BODIES_NEAR - (end - begin)), 0, 0, 0, 0 };
	int32_t k;
	if (s->body_kernel != NULL)
		taken = s->body_kernel->poses(world, s, begin, end);
	*rested |= taken.rested;
	while (taken.rest != 0) {
		k = begin + bit_take(&taken.rest);
		*rested |= body_rest(world, cni_body_at(world, cni_awake_ids(world)[k]), k, s, (int32_t)(taken.pushed >> (k - begin) & 1u));
	}
	while (taken.left != 0) {
		k = begin + bit_take(&taken.left);
		taken.no_room |= (uint64_t)body_take(world, s, k, rested) << (k - begin);
	}
	return taken.no_room;
}

typedef struct pose_loop {
	cn_world *world;
	const cni_solve *s;
	int32_t *set;    /* cni_body_boxes_set of each body. NULL: one worker, which tells the broadphase at once */
	uint32_t rested;
} pose_loop;

static void body_boxes_follow(const pose_loop *loop, int32_t k, int32_t no_room)
{
	cni_body *b = cni_body_at(loop->world, cni_awake_ids(loop->world)[k]);
	int32_t set = CNI_BOXES_NONE;
	if (no_room && (b->flags & CNI_BODY_MOVED))
		set = cni_body_boxes_set(loop->world, b, way_ahead(loop->world, loop->s, k), loop->set == NULL ? loop->world : NULL);
	if (loop->set != NULL)
		loop->set[k] = set;
}

/* Asks for what checking the boxes of some near bodies (bits from begin on) reads: first all shapes, then all that these lead to. */
CNI_INLINE void boxes_prefetch(const cn_world *world, int32_t begin, uint64_t bodies)
{
	for (uint64_t left = bodies; left != 0; ) {
		const cni_shape *s = cni_shape_at(world, cni_max_i(cni_body_at(world, cni_awake_ids(world)[begin + bit_take(&left)])->shape_first, 0));
		CNI_PREFETCH(s);
		CNI_PREFETCH((const char *)(s + 1) - 1);
	}
	for (uint64_t left = bodies; left != 0; ) {
		int32_t shape = cni_body_at(world, cni_awake_ids(world)[begin + bit_take(&left)])->shape_first;
		const cni_shape *s = shape != CNI_NONE ? cni_shape_at(world, shape) : NULL;
		if (s == NULL || s->type == CN_SHAPE_CHAIN || s->box.proxy == CNI_NONE)
			continue;
		CNI_PREFETCH(&cni_proxy_at(world, s->box.proxy)->fat);
		CNI_PREFETCH(cni_shape_geometry(&world->blocks, s));
		CNI_PREFETCH((const char *)cni_shape_geometry(&world->blocks, s) + 64);
	}
}

static void pose_range(void *context, int32_t begin, int32_t end)
{
	pose_loop *loop = (pose_loop *)context;
	uint32_t rested = 0;
	int32_t last;
	for (int32_t first = begin + 1; first <= end; first = last) {
		last = cni_min_i(first + BODIES_NEAR, end + 1);
		uint64_t no_room = bodies_take(loop->world, loop->s, first, last, &rested);
		if (loop->world->awake_count >= BODIES_MANY)
			boxes_prefetch(loop->world, first, no_room);
		for (int32_t k = first; k < last && (no_room != 0 || loop->set != NULL); ++k, no_room >>= 1)
			body_boxes_follow(loop, k, (int32_t)(no_room & 1u));
	}
	if (rested)
		cni_atomic_add(&loop->rested, 1u);
}

static void boxes_tell(cn_world *world, const int32_t *set)
{
	for (int32_t k = 1; k < world->awake_count; ++k)
		if (set[k] != CNI_BOXES_NONE)
			cni_body_boxes_tell(world, cni_body_at(world, cni_awake_ids(world)[k]), set[k]);
}

/* The readback is kept from the first step after it was asked for until some time after it was last asked for. */
static void readback_begin(cn_world *world)
{
	int32_t used = cni_handles_used(&world->body_handles), k, was_kept = world->readback_kept;
	world->readback_kept = world->readback_asked != 0 && world->step_count + 1u - world->readback_asked < READBACK_STEPS &&
		cni_table_reserve(&world->readback, &world->memory, used);
	for (k = cni_handles_next(&world->body_handles, 0); k != CNI_NONE && world->readback_kept && !was_kept; k = cni_handles_next(&world->body_handles, k + 1))
		cni_readback_store(world, k);
}

int32_t cni_stage_finalize(cn_world *world, const cni_solve *s)
{
	pose_loop loop = { world, s, NULL, 0 };
	cni_dummy_stand(world);
	readback_begin(world);
	if (world->team != NULL && world->awake_count > 2 * BODIES_A_RANGE)
		loop.set = (int32_t *)cni_arena_push(&world->arena, sizeof(int32_t) * (uint64_t)world->awake_count);
	if (loop.set != NULL) {
		cni_parallel_for(world, world->awake_count - 1, BODIES_A_RANGE, pose_range, &loop);
		boxes_tell(world, loop.set);
	} else {
		pose_range(&loop, 0, world->awake_count - 1);
	}
	cni_arena_pop(&world->arena, loop.set);
	world->broadphase_ops->settle(world->broadphase);
	return loop.rested != 0;
}
