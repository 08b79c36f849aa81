/*
 * model/joint_list.c - joint records: handles, memory, the list of awake joints, the joints of a body.
 */
#include "model/world.h"

/* Joints and constraints share a table, so their handles differ in the kind bits only. */
#define KIND_BITS ((uint32_t)(CNI_KIND_JOINT ^ CNI_KIND_CONSTRAINT) << 20)

uint32_t cni_joint_handle(const cn_world *world, int32_t joint)
{
	uint32_t handle = cni_handles_of(&world->joint_handles, joint);
	return cni_joint_is_constraint(cni_joint_at(world, joint)->type) ? handle ^ KIND_BITS : handle;
}

int32_t cni_joint_find(const cn_world *world, uint32_t handle, int32_t constraint)
{
	int32_t index = cni_handles_find(&world->joint_handles, constraint ? handle ^ KIND_BITS : handle);
	if (index != CNI_NONE && cni_joint_is_constraint(cni_joint_at(world, index)->type) != constraint)
		return CNI_NONE;
	return index;
}

int32_t cni_joint_blocks_for(int32_t joints)
{
	return joints / CNI_LANES + cni_min_i(joints, 4 * CNI_JOINT_COLORS);
}

cn_result cni_joint_reserve(cn_world *world, int32_t extra)
{
	int32_t used = cni_handles_used(&world->joint_handles) + extra;
	int32_t good = cni_table_reserve(&world->joints, &world->memory, used) &&
	               cni_array_reserve(&world->awake_joints, &world->memory, world->joint_handles.count + extra) &&
	               cni_array_reserve(&world->joint_work, &world->memory, world->joint_handles.count + extra) &&
	               cni_array_reserve(&world->joint_blocks, &world->memory, cni_joint_blocks_for(world->joint_handles.count + extra)) &&
	               cni_island_reserve(world, extra);
	return good ? CN_OK : CN_ERROR_MEMORY;
}

static int32_t side_is_enabled(const cn_world *world, const cni_joint *j, int32_t side)
{
	return j->body[side] == CNI_NONE || (cni_body_at(world, j->body[side])->flags & CN_BODY_ENABLED);
}

int32_t cni_joint_is_enabled(const cn_world *world, const cni_joint *j)
{
	return side_is_enabled(world, j, 0) && side_is_enabled(world, j, 1);
}

void cni_joint_enter_awake_list(cn_world *world, int32_t joint)
{
	cni_joint *j = cni_joint_at(world, joint);
	if (j->awake != CNI_NONE || j->type == CN_JOINT_FILTER || !cni_joint_is_enabled(world, j))
		return;
	j->trust.until = world->step_count + (uint32_t)cni_min_i((int32_t)j->trust.until, CNI_TRUST_MOST);
	if (j->trust.soft && j->trust.until > world->joints_soft_step)
		world->joints_soft_step = j->trust.until;
	j->awake = world->awake_joints.count;
	((int32_t *)world->awake_joints.data)[world->awake_joints.count++] = joint;
}

void cni_joint_leave_awake_list(cn_world *world, int32_t joint)
{
	cni_joint *j = cni_joint_at(world, joint);
	int32_t *list = (int32_t *)world->awake_joints.data;
	if (j->awake == CNI_NONE)
		return;
	j->trust.until -= world->step_count;
	int32_t last = list[--world->awake_joints.count];
	list[j->awake] = last;
	cni_joint_at(world, last)->awake = j->awake;
	j->awake = CNI_NONE;
}

int32_t cni_joint_count(const cn_world *world, int32_t body)
{
	int32_t count = 0;
	for (int32_t key = cni_body_at(world, body)->joint_first; key != CNI_NONE; key = cni_joint_at(world, key >> 1)->next[key & 1])
		++count;
	return count;
}

/* Walks both lists alternately, so that the shorter one ends the search. */
int32_t cni_joint_forbids(const cn_world *world, int32_t body_a, int32_t body_b)
{
	int32_t key[2], other[2] = { body_b, body_a }, side = 0;
	key[0] = cni_body_at(world, body_a)->joint_first;
	key[1] = cni_body_at(world, body_b)->joint_first;
	for (; key[side] != CNI_NONE; side = 1 - side) {
		const cni_joint *j = cni_joint_at(world, key[side] >> 1);
		if (j->body[1 - (key[side] & 1)] == other[side] && !(j->flags & CN_JOINT_COLLIDE))
			return 1;
		key[side] = j->next[key[side] & 1];
	}
	return 0;
}
