/*
 * step/sleep.c - stage 10: islands in which every body has rested long enough leave the awake arrays.
 *
 * A step puts only so many bodies to sleep, and whole islands (SLEEP_LEAST): when a large scene comes to rest at once, its bodies leave
 * the awake arrays over some steps instead of in one long one.
 *
 * Runs only when finalize found a body that has. An island that lost links is split first, one a step, so that separate parts
 * may sleep separately. Bodies that touch or are jointed to a moving kinematic body stay awake. So do bodies that a motor moves,
 * and bodies that sag because the direct solver has found no solution for them. A few bodies that rock among many at rest are damped.
 */
#include "step/stages.h"
#include "joints/joint_type.h"
#include "direct/direct.h"

static void keep_touching_awake(cn_world *world, int32_t body)
{
	for (int32_t key = cni_body_at(world, body)->contact_first; key != CNI_NONE; key = cni_contact_of_key(world, key)->next[key & 1]) {
		const cni_contact *c = cni_contact_of_key(world, key);
		if (c->flags & CNI_CONTACT_TOUCHING)
			cni_body_at(world, c->body[1 - (key & 1)])->sleep_time = 0.0f;
	}
	for (int32_t key = cni_body_at(world, body)->joint_first; key != CNI_NONE; key = cni_joint_at(world, key >> 1)->next[key & 1]) {
		const cni_joint *j = cni_joint_at(world, key >> 1);
		int32_t other = j->body[1 - (key & 1)];
		if (other != CNI_NONE && j->awake != CNI_NONE)
			cni_body_at(world, other)->sleep_time = 0.0f;
	}
}

static void keep_near_kinematic_awake(cn_world *world)
{
	const int32_t *ids = cni_awake_ids(world);
	for (int32_t k = 1; k < world->awake_count; ++k) {
		const cni_motion *m = cni_motions(world) + k;
		if (m->inv_mass == 0.0f && (m->vx != 0.0f || m->vy != 0.0f || m->w != 0.0f) && cni_body_at(world, ids[k])->type == CN_BODY_KINEMATIC)
			keep_touching_awake(world, ids[k]);
	}
}

/* Does the joint's motor move it? A stalled motor lets its bodies sleep. */
static int32_t motor_turns(const cn_world *world, const cni_joint *j)
{
	if (!(j->flags & CN_JOINT_MOTOR) || j->type < CN_JOINT_REVOLUTE || j->type > CN_JOINT_WHEEL)
		return 0;
	float target = j->p[CNI_P_MOTOR_SPEED];
	return target != 0.0f && 2.0f * target * cni_joint_speed(world, j) > target * target;
}

/* Bodies that a motor moves are not at rest, however slow its speed. */
static void keep_driven_awake(cn_world *world)
{
	for (int32_t k = 0; k < world->awake_joints.count; ++k) {
		const cni_joint *j = cni_joint_at(world, ((const int32_t *)world->awake_joints.data)[k]);
		if (!motor_turns(world, j))
			continue;
		for (int32_t side = 0; side < 2; ++side)
			if (j->body[side] != CNI_NONE)
				cni_body_at(world, j->body[side])->sleep_time = 0.0f;
	}
}

/* Bodies whose records are asked for: one pass reads them all. */
#define RECORDS_AHEAD 8

/* Result of a pass over all awake bodies. */
typedef struct rests {
	int32_t split;    /* awake island with lost links and the longest resting body, if that rested long enough; CNI_NONE: none */
	float longest;    /* its rest time */
	int32_t alone;    /* 1: a body without an island may sleep */
} rests;

static int32_t rested(const cn_world *world, float time)
{
	return time >= world->settings.sleep_delay && time > 0.0f;
}

/* Bodies that keep an island awake whose others have rested for LONG_DELAYS delays: one of MOVERS_SHARE, or but one, slower than MOVERS_SPEED
   sleep speeds. They are damped with MOVERS_TIME seconds. */
#define LONG_DELAYS 4.0f
#define MOVERS_SHARE 64
#define MOVERS_SPEED 4.0f
#define MOVERS_TIME 1.0f

static int32_t has_long_rested(const cn_world *world, const cni_body *b)
{
	return rested(world, b->sleep_time) && b->sleep_time >= LONG_DELAYS * world->settings.sleep_delay;
}

/* Is the body so slow that it moves by less than the accuracy in a second? */
static int32_t is_still(const cn_world *world, const cni_body *b)
{
	float most = world->settings.accuracy, turn = b->w * b->extent;
	return b->vx * b->vx + b->vy * b->vy <= most * most && turn * turn <= most * most;
}

/* Also computes each awake island's rest_time. */
static rests rests_find(cn_world *world)
{
	const int32_t *ids = cni_awake_ids(world);
	rests r = { CNI_NONE, world->settings.sleep_delay, 0 };
	for (int32_t k = 1; k < world->awake_count; ++k) {
		const cni_body *b = cni_body_at(world, ids[k]);
		if (k + RECORDS_AHEAD < world->awake_count)
			CNI_PREFETCH(&cni_body_at(world, ids[k + RECORDS_AHEAD])->sleep_time);
		if (b->island == CNI_NONE) {
			r.alone |= rested(world, b->sleep_time);
			continue;
		}
		cni_island *i = cni_island_at(world, b->island);
		int32_t first = i->rest_step != world->step_count + 1u, moves = !has_long_rested(world, b);
		i->rest_time = first ? b->sleep_time : cni_min(i->rest_time, b->sleep_time);
		i->movers = first ? moves : i->movers + moves;
		i->rest_step = world->step_count + 1u;
		if (CNI_HAS_DIRECT && cni_island_is_unsolved(i, world->step_count) && !is_still(world, b))
			i->rest_time = 0.0f; /* it sags, and would fall asleep so before the next attempt to solve it */
		if (i->losses == 0 || b->sleep_time < r.longest || b->sleep_time <= 0.0f || (r.split != CNI_NONE && b->sleep_time == r.longest))
			continue;
		r.split = b->island;
		r.longest = b->sleep_time;
	}
	return r;
}

/* An island of all awake bodies is split once in so many steps. */
#define SPLIT_STEPS 8

/*
 * Splits at most one island a step. A large island that comes apart loses links in every step, and its resting bodies are still
 * linked to moving ones: the next split waits in proportion to the size of this one. Returns 1 if an island was split.
 */
static int32_t split_one(cn_world *world, int32_t island)
{
	if (island == CNI_NONE || (int32_t)(world->step_count - world->split_step) < 0)
		return 0;
	world->split_step = world->step_count + 1u + (uint32_t)(SPLIT_STEPS * cni_island_at(world, island)->count / world->awake_count);
	if (!cni_island_split(world, island))
		world->warnings |= CN_WARNING_FRAME_MEMORY;
	return 1;
}

/* 1: the body moves slowly, and only contacts hold it. */
static int32_t may_be_damped(const cn_world *world, const cni_body *b)
{
	float most = MOVERS_SPEED * world->settings.sleep_speed, turn = b->w * b->extent;
	return !has_long_rested(world, b) && (b->flags & CN_BODY_SLEEP) && !(cni_externals(world)[b->awake].flags & CNI_EXTERNAL_JOINTED) &&
		b->vx * b->vx + b->vy * b->vy <= most * most && turn * turn <= most * most;
}

/*
 * A body that rocks in a hollow, rolling to and fro without slip, would keep all of its heap awake: nothing takes its energy, and contacts, which
 * keep the arms of the step's beginning, half a step late, even drive it a little. Where all others have long rested, it is stopped.
 */
static void movers_damp(cn_world *world, const cni_island *i, float dt)
{
	float part = cni_max(1.0f - dt / MOVERS_TIME, 0.0f);
	for (int32_t body = i->first; body != CNI_NONE; body = cni_body_at(world, body)->island_next) {
		cni_body *b = cni_body_at(world, body);
		if (!may_be_damped(world, b))
			continue;
		cn_velocity v = { { part * b->vx, part * b->vy }, part * b->w };
		cni_body_store_velocity(world, b, v);
	}
}

static void islands_damp(cn_world *world, float dt)
{
	for (int32_t k = 0; k < world->island_used; ++k) {
		const cni_island *i = cni_island_at(world, k);
		if (i->rest_step == world->step_count + 1u && i->movers > 0 && i->movers < i->count && i->movers <= cni_max_i(i->count / MOVERS_SHARE, 1))
			movers_damp(world, i, dt);
	}
}

static int32_t island_may_sleep(const cn_world *world, const cni_island *i)
{
	return i->losses == 0 && rested(world, i->rest_time);
}

static int32_t some_island_may_sleep(const cn_world *world)
{
	for (int32_t k = 0; k < world->island_used; ++k) {
		const cni_island *i = cni_island_at(world, k);
		if (i->rest_step == world->step_count + 1u && island_may_sleep(world, i))
			return 1;
	}
	return 0;
}

/* Bodies that may fall asleep in a step: SLEEP_LEAST, some 0.6 ms, or one of SLEEP_SHARE awake ones. */
#define SLEEP_LEAST 1024
#define SLEEP_SHARE 8

void cni_stage_sleep(cn_world *world, float dt)
{
	keep_near_kinematic_awake(world);
	if (CNI_HAS_JOINTS)
		keep_driven_awake(world);
	rests r = rests_find(world);
	islands_damp(world, dt);
	if (split_one(world, r.split))
		r = rests_find(world);
	if (!r.alone && world->island_used <= world->awake_count && !some_island_may_sleep(world)) /* of many islands most sleep */
		return;
	int32_t before = world->awake_count;
	int32_t most = cni_max_i(SLEEP_LEAST, before / SLEEP_SHARE);
	for (int32_t k = world->awake_count - 1; k >= 1; k = cni_min_i(k, world->awake_count) - 1) {
		int32_t body = cni_awake_ids(world)[k];
		const cni_body *b = cni_body_at(world, body);
		if ((b->island == CNI_NONE ? rested(world, b->sleep_time) : island_may_sleep(world, cni_island_at(world, b->island))) && !cni_body_put_to_sleep(world, body))
			world->warnings |= CN_WARNING_FRAME_MEMORY;
		if (before - world->awake_count >= most)
			return;
	}
}
