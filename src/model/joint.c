/*
 * model/joint.c - joint records: lists, islands, events.
 *
 * Owns the joint table and the awake list. Invariant: a joint is in the lists of its bodies while it lives,
 * and in the awake list when one of its bodies is in the dense arrays and none is disabled; a filter joint
 * has nothing to solve and is in no awake list and no island.
 */
#include "model/world.h"

#include <string.h>

/* ---- impulses ---- */

/* Bits of the slots whose impulses are of angles. */
static uint32_t slots_of_angles(int32_t type)
{
	switch (type) {
	case CN_JOINT_REVOLUTE: return 1u << 2 | 1u << 3 | 1u << 4;
	case CN_JOINT_FIXED: case CN_JOINT_MOTOR_TO: return 1u << 2;
	case CN_JOINT_PRISMATIC: return 1u << 1;
	case CN_JOINT_WHEEL: return 1u << 3;
	case CN_JOINT_GEAR: case CN_JOINT_RATCHET: case CN_JOINT_ROTARY_SPRING: case CNI_JOINT_ANGLE: return 1u << 0;
	default: return 0;
	}
}

float cni_joint_impulse_sum(const cn_world *world, const cni_joint *j, int32_t count)
{
	uint32_t of_angles = slots_of_angles(j->type);
	float sum = 0.0f;
	for (int32_t k = 0; k < count; ++k)
		sum += cni_abs(j->impulse[k]) / (of_angles >> k & 1u ? world->settings.length_unit : 1.0f);
	return sum;
}

/* ---- lists ---- */

static void list_link(cn_world *world, int32_t joint, int32_t side)
{
	cni_joint *j = cni_joint_at(world, joint);
	int32_t key = joint << 1 | side;
	j->prev[side] = j->next[side] = CNI_NONE;
	if (j->body[side] == CNI_NONE)
		return;
	cni_body *b = cni_body_at(world, j->body[side]);
	j->next[side] = b->joint_first;
	if (b->joint_first != CNI_NONE)
		cni_joint_at(world, b->joint_first >> 1)->prev[b->joint_first & 1] = key;
	b->joint_first = key;
}

static void list_unlink(cn_world *world, int32_t joint, int32_t side)
{
	cni_joint *j = cni_joint_at(world, joint);
	int32_t next = j->next[side], prev = j->prev[side];
	if (j->body[side] == CNI_NONE)
		return;
	if (prev != CNI_NONE)
		cni_joint_at(world, prev >> 1)->next[prev & 1] = next;
	else
		cni_body_at(world, j->body[side])->joint_first = next;
	if (next != CNI_NONE)
		cni_joint_at(world, next >> 1)->prev[next & 1] = prev;
}

static int32_t side_is_awake(const cn_world *world, const cni_joint *j, int32_t side)
{
	return j->body[side] != CNI_NONE && cni_body_at(world, j->body[side])->awake != 0;
}

void cni_joint_wake_bodies(cn_world *world, const cni_joint *j)
{
	for (int32_t side = 0; side < 2; ++side)
		if (j->body[side] != CNI_NONE)
			cni_body_wake(world, j->body[side]);
}

/* Ends the contacts between two bodies that a joint now forbids. */
static void end_contacts_between(cn_world *world, int32_t body_a, int32_t body_b)
{
	int32_t key = cni_body_at(world, body_a)->contact_first;
	while (key != CNI_NONE) {
		const cni_contact *c = cni_contact_of_key(world, key);
		int32_t contact = key >> 1, other = c->body[1 - (key & 1)];
		key = c->next[key & 1];
		if (other == body_b)
			cni_contact_destroy(world, contact);
	}
}

/* First shape of the body with fewer shapes: its list ends first. */
static int32_t first_shape_of_lesser(const cn_world *world, const cni_joint *j)
{
	int32_t first_a = cni_body_at(world, j->body[0])->shape_first, first_b = cni_body_at(world, j->body[1])->shape_first;
	int32_t a = first_a, b = first_b;
	while (a != CNI_NONE && b != CNI_NONE) {
		a = cni_shape_at(world, a)->next;
		b = cni_shape_at(world, b)->next;
	}
	return a == CNI_NONE ? first_a : first_b;
}

void cni_joint_link(cn_world *world, int32_t joint)
{
	cni_joint *j = cni_joint_at(world, joint);
	int32_t enabled = cni_joint_is_enabled(world, j);
	j->awake = CNI_NONE;
	j->apart = 1;
	list_link(world, joint, 0);
	list_link(world, joint, 1);
	cni_joint_wake_bodies(world, j);
	j->linked = enabled && j->type != CN_JOINT_FILTER && cni_is_dynamic(world, j->body[0]) && cni_is_dynamic(world, j->body[1]);
	if (j->linked)
		cni_island_link(world, j->body[0], j->body[1]);
	if (side_is_awake(world, j, 0) || side_is_awake(world, j, 1))
		cni_joint_enter_awake_list(world, joint);
	if (!(j->flags & CN_JOINT_COLLIDE) && j->body[0] != CNI_NONE && j->body[1] != CNI_NONE)
		end_contacts_between(world, j->body[0], j->body[1]);
}

void cni_joint_unlink(cn_world *world, int32_t joint)
{
	cni_joint *j = cni_joint_at(world, joint);
	cni_joint_wake_bodies(world, j);
	cni_joint_leave_awake_list(world, joint);
	list_unlink(world, joint, 0);
	list_unlink(world, joint, 1);
	if (j->linked)
		cni_island_unlink(world, j->body[0]);
	j->linked = 0;
	if (!(j->flags & CN_JOINT_COLLIDE) && j->body[0] != CNI_NONE && j->body[1] != CNI_NONE)
		for (int32_t shape = first_shape_of_lesser(world, j); shape != CNI_NONE; shape = cni_shape_at(world, shape)->next)
			cni_shape_refilter(world, shape);
}

void cni_joint_destroy(cn_world *world, int32_t joint)
{
	world->constraint_count -= cni_joint_is_constraint(cni_joint_at(world, joint)->type);
	cni_joint_unlink(world, joint);
	cni_handles_release(&world->joint_handles, joint);
}

/* ---- events ---- */

static cni_array *event_log(cn_world *world)
{
	return world->events.in_step ? &world->events.joint_log : &world->events.joint_pending;
}

int32_t cni_joint_reserve_events(cn_world *world, int32_t count)
{
	cni_array *log = event_log(world);
	return cni_array_reserve(log, &world->memory, log->count + count);
}

void cni_joint_event_log(cn_world *world, int32_t joint, float force, float torque, uint32_t destroyed)
{
	const cni_joint *j = cni_joint_at(world, joint);
	int32_t constraint = cni_joint_is_constraint(j->type);
	cn_joint_event *e = (cn_joint_event *)cni_event_add(world, event_log(world));
	if (e == NULL)
		return;
	memset(e, 0, sizeof *e);
	e->joint = constraint ? 0 : cni_joint_handle(world, joint);
	e->constraint = constraint ? cni_joint_handle(world, joint) : 0;
	for (int32_t side = 0; side < 2; ++side)
		*(side == 0 ? &e->body_a : &e->body_b) = j->body[side] == CNI_NONE ? 0 : cni_handles_of(&world->body_handles, j->body[side]);
	e->destroyed = destroyed;
	e->force_N = force;
	e->torque_Nm = torque;
	e->user_data = j->user_data;
}
