/*
 * stages/sleep.c - stage 10: islands in which every body has rested long enough leave the awake arrays.
 *
 * Runs only when finalize saw a body that has. An island that lost links is split first, one
 * a step, so that what no longer holds together may sleep apart. What touches a moving kinematic body, or is
 * jointed to one, stays awake.
 */
#include "stages/solver.h"

static void keep_touching_awake(cn_world *world, int32_t body)
{
	int32_t key;
	for (key = cni_body_at(world, body)->contact_first; key != CNI_NONE; key = cni_contact_of_key(world, key)->next[key & 1]) {
		const cni_contact *c = cni_contact_of_key(world, key);
		if (c->flags & CNI_CONTACT_TOUCHING)
			cni_body_at(world, c->body[1 - (key & 1)])->sleep_time = 0.0f;
	}
	for (key = cni_body_at(world, body)->joint_first; key != CNI_NONE; key = cni_joint_at(world, key >> 1)->next[key & 1]) {
		const cni_joint *j = cni_joint_at(world, key >> 1);
		int32_t other = j->body[1 - (key & 1)];
		if (other != CNI_NONE && j->awake != CNI_NONE)
			cni_body_at(world, other)->sleep_time = 0.0f;
	}
}

static void keep_near_kinematic_awake(cn_world *world)
{
	const int32_t *ids = cni_awake_ids(world);
	int32_t k;
	for (k = 1; k < world->awake_count; ++k) {
		const cni_body *b = cni_body_at(world, ids[k]);
		const cni_motion *m = cni_motions(world) + k;
		if (b->type == CN_BODY_KINEMATIC && (m->vx != 0.0f || m->vy != 0.0f || m->w != 0.0f))
			keep_touching_awake(world, ids[k]);
	}
}

static void rest_times_collect(cn_world *world)
{
	const int32_t *ids = cni_awake_ids(world);
	int32_t k;
	for (k = 1; k < world->awake_count; ++k) {
		const cni_body *b = cni_body_at(world, ids[k]);
		if (b->island != CNI_NONE)
			cni_island_at(world, b->island)->rest_time = FLT_MAX;
	}
	for (k = 1; k < world->awake_count; ++k) {
		const cni_body *b = cni_body_at(world, ids[k]);
		if (b->island != CNI_NONE) {
			cni_island *i = cni_island_at(world, b->island);
			i->rest_time = cni_min(i->rest_time, b->sleep_time);
		}
	}
}

/* Bodies that may be looked at a step on the average to split islands: hardly a part of what the step costs with as many. */
#define SPLIT_BODIES_A_STEP 1024

/*
 * The awake island that lost links and has a body that has rested longest; at most one a step is split. While a large one
 * comes apart it loses links in every step, and what rests in it hangs on what moves: the next split waits until
 * this one has been paid for.
 */
static void split_one(cn_world *world)
{
	const int32_t *ids = cni_awake_ids(world);
	int32_t k, best = CNI_NONE;
	float longest = world->settings.sleep_delay;
	if ((int32_t)(world->step_count - world->split_step) < 0)
		return;
	for (k = 1; k < world->awake_count; ++k) {
		const cni_body *b = cni_body_at(world, ids[k]);
		if (b->island == CNI_NONE || cni_island_at(world, b->island)->losses == 0 || b->sleep_time < longest || b->sleep_time <= 0.0f)
			continue;
		if (best == CNI_NONE || b->sleep_time > longest) {
			best = b->island;
			longest = b->sleep_time;
		}
	}
	if (best == CNI_NONE)
		return;
	world->split_step = world->step_count + 1u + (uint32_t)(cni_island_at(world, best)->count / SPLIT_BODIES_A_STEP);
	if (!cni_island_split(world, best))
		world->warnings |= CN_WARNING_FRAME_MEMORY;
}

static int32_t may_sleep(const cn_world *world, const cni_body *b)
{
	float delay = world->settings.sleep_delay;
	const cni_island *i;
	if (b->island == CNI_NONE)
		return b->sleep_time >= delay && b->sleep_time > 0.0f;
	i = cni_island_at(world, b->island);
	return i->losses == 0 && i->rest_time >= delay && i->rest_time > 0.0f;
}

void cni_stage_sleep(cn_world *world)
{
	int32_t k;
	keep_near_kinematic_awake(world);
	split_one(world);
	rest_times_collect(world);
	for (k = world->awake_count - 1; k >= 1; k = cni_min_i(k, world->awake_count) - 1) {
		int32_t body = cni_awake_ids(world)[k];
		if (may_sleep(world, cni_body_at(world, body)) && !cni_body_put_to_sleep(world, body))
			world->warnings |= CN_WARNING_FRAME_MEMORY;
	}
}
