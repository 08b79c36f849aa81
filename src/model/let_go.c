/*
 * model/let_go.c - limits the impulses of an island from which something goes that may have balanced them: a body that is destroyed,
 * disabled or changes its type, a joint that is destroyed, or the exact solution of its contacts.
 *
 * The contacts of a pile that it pressed balance each other with impulses of thousands of weights. The next substep begins with them, and
 * without the body they throw the pile: parts that a kinematic body had pressed into the ground, at 360 m/s. So impulses of contacts in the
 * islands that the body touched, or was jointed to, are limited to what gives the lighter body cni_soft_speed_most; so are those of islands that
 * exact solutions gave up, and of islands that rest on exact impulses once a body of them moves that bears more.
 *
 * Exact joints of a mechanism that is jammed, as by motors that disagree, have opposing impulses of any size, which only their system cancels.
 * Without one of them the next substep began at hundreds to thousands of metres a second, and systems with loops, which yield a little, left some
 * of that. So their impulses are limited alike; one solution finds what they bear without it.
 *
 * Writes impulses of lanes, and of the records of joints.
 */
#include "model/world.h"

static float lane_impulse(const cn_world *world, int32_t slot)
{
	const cni_contact_block *block = cni_block_at(world, slot / CNI_LANES);
	return block->p[0].jn[slot % CNI_LANES] + block->p[1].jn[slot % CNI_LANES];
}

/* Speed that the impulses of a lane give the lighter body. */
static float lane_speed(const cn_world *world, int32_t slot)
{
	const cni_contact_block *block = cni_block_at(world, slot / CNI_LANES);
	int32_t l = slot % CNI_LANES;
	float inv_mass = cni_max(cni_motions(world)[block->ia[l]].inv_mass, cni_motions(world)[block->ib[l]].inv_mass);
	return inv_mass * lane_impulse(world, slot);
}

static void lane_limit(const cn_world *world, int32_t slot, float speed_most)
{
	float speed = lane_speed(world, slot);
	if (speed <= speed_most)
		return;
	cni_block_scale_impulses(cni_block_at(world, slot / CNI_LANES), slot % CNI_LANES, speed_most / speed);
}

int32_t cni_island_limit_impulses(cn_world *world, cni_island *island)
{
	float speed_most = cni_soft_speed_most(world);
	if (!island->awake || island->limited_step == world->step_count + 1)
		return 0;
	island->limited_step = world->step_count + 1;
	for (int32_t body = island->first; body != CNI_NONE; body = cni_body_at(world, body)->island_next)
		for (int32_t key = cni_body_at(world, body)->contact_first; key != CNI_NONE; key = cni_contact_of_key(world, key)->next[key & 1]) {
			const cni_contact *c = cni_contact_of_key(world, key);
			if (cni_contact_has_lane(c) && (body == c->body[0] || !cni_is_dynamic(world, c->body[0])))
				lane_limit(world, c->slot, speed_most);
		}
	return 1;
}

/* 1: a body that contacts press beyond that moves. */
static int32_t pressed_body_moves(const cn_world *world, const cni_island *island, cni_vec2 frame)
{
	float speed_most = cni_soft_speed_most(world), slow = world->settings.sleep_speed;
	for (int32_t body = island->first; body != CNI_NONE; body = cni_body_at(world, body)->island_next) {
		const cni_body *b = cni_body_at(world, body);
		const cni_motion *m = cni_motions(world) + b->awake;
		if (cni_sq(m->vx - frame.x) + cni_sq(m->vy - frame.y) + cni_sq(m->w * b->extent) <= slow * slow)
			continue;
		for (int32_t key = b->contact_first; key != CNI_NONE; key = cni_contact_of_key(world, key)->next[key & 1]) {
			const cni_contact *c = cni_contact_of_key(world, key);
			if (cni_contact_has_lane(c) && m->inv_mass * lane_impulse(world, c->slot) > speed_most)
				return 1;
		}
	}
	return 0;
}

void cni_island_let_go(cn_world *world, cni_island *island, cni_vec2 frame)
{
	if (!pressed_body_moves(world, island, frame))
		return;
	(void)cni_island_limit_impulses(world, island);
	island->given_step = 0;
}

static float inv_mass_of(const cn_world *world, int32_t body)
{
	return body != CNI_NONE ? cni_motions(world)[cni_body_at(world, body)->awake].inv_mass : 0.0f;
}

static float joint_speed(const cn_world *world, const cni_joint *j)
{
	return cni_joint_impulse_sum(world, j, CNI_JOINT_ROWS) * cni_max(inv_mass_of(world, j->body[0]), inv_mass_of(world, j->body[1]));
}

/* Limits its joints that were solved exactly, to what gives the lighter body cni_soft_speed_most. */
static void joints_limit(cn_world *world, const cni_body *b)
{
	float speed_most = cni_soft_speed_most(world);
	for (int32_t key = b->joint_first; key != CNI_NONE; key = cni_joint_at(world, key >> 1)->next[key & 1]) {
		cni_joint *j = cni_joint_at(world, key >> 1);
		float speed = j->trust.direct ? joint_speed(world, j) : 0.0f;
		for (int32_t i = 0; i < CNI_JOINT_ROWS && speed > speed_most; ++i)
			j->impulse[i] *= speed_most / speed;
	}
}

static void neighbour_limit(cn_world *world, int32_t body)
{
	if (body == CNI_NONE || !cni_is_dynamic(world, body))
		return;
	int32_t island = cni_body_at(world, body)->island;
	if (island == CNI_NONE) {
		joints_limit(world, cni_body_at(world, body));
		return;
	}
	cni_island *i = cni_island_at(world, island);
	if (!cni_island_limit_impulses(world, i))
		return;
	for (int32_t k = i->first; k != CNI_NONE; k = cni_body_at(world, k)->island_next)
		joints_limit(world, cni_body_at(world, k));
}

void cni_joint_let_go(cn_world *world, int32_t joint)
{
	const cni_joint *j = cni_joint_at(world, joint);
	cni_joint_wake_bodies(world, j);
	if (joint_speed(world, j) <= cni_soft_speed_most(world))
		return;
	neighbour_limit(world, j->body[0]);
	neighbour_limit(world, j->body[1]);
}

/* Islands are looked at only where the body itself presses or pulls that hard: a brick of a wall does not. */
void cni_body_let_go(cn_world *world, int32_t body)
{
	float speed_most = cni_soft_speed_most(world);
	cni_body_wake_neighbours(world, body);
	for (int32_t key = cni_body_at(world, body)->contact_first; key != CNI_NONE; key = cni_contact_of_key(world, key)->next[key & 1]) {
		const cni_contact *c = cni_contact_of_key(world, key);
		if (cni_contact_has_lane(c) && lane_speed(world, c->slot) > speed_most)
			neighbour_limit(world, c->body[1 - (key & 1)]);
	}
	for (int32_t key = cni_body_at(world, body)->joint_first; key != CNI_NONE; key = cni_joint_at(world, key >> 1)->next[key & 1]) {
		const cni_joint *j = cni_joint_at(world, key >> 1);
		if (joint_speed(world, j) > speed_most)
			neighbour_limit(world, j->body[1 - (key & 1)]);
	}
}
