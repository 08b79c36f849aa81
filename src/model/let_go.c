/*
 * model/let_go.c - a body that may have held others goes: it is destroyed, disabled or changes its type.
 *
 * What pressed a pile holds contacts that balance each other with impulses of thousands of weights. Without it they would throw the pile in the
 * next substep, which begins with them: a light part that a kinematic body presses into the ground, at 360 m/s. So the contacts of the islands
 * that the body touched, or was jointed to, keep what impulses of weights they may have, and no more.
 *
 * Writes impulses of lanes.
 */
#include "model/world.h"
#include "model/tuning.h"

static void lane_limit(const cn_world *world, int32_t slot, float speed_most)
{
	cni_contact_block *block = cni_block_at(world, slot / CNI_LANES);
	int32_t l = slot % CNI_LANES;
	float inv_mass = cni_max(cni_motions(world)[block->ia[l]].inv_mass, cni_motions(world)[block->ib[l]].inv_mass);
	float speed = inv_mass * (block->p[0].jn[l] + block->p[1].jn[l]);
	if (speed <= speed_most)
		return;
	cni_block_scale_impulses(block, l, speed_most / speed);
}

/* Once a step: islands of thousands of bodies may lose thousands. */
static void island_limit(cn_world *world, cni_island *island)
{
	float speed_most = CNI_SOFT_STRESS * cni_length(world->settings.gravity) * world->step_dt / (float)world->settings.substeps;
	int32_t body, key;
	if (!island->awake || island->limited_step == world->step_count + 1)
		return;
	island->limited_step = world->step_count + 1;
	for (body = island->first; body != CNI_NONE; body = cni_body_at(world, body)->island_next)
		for (key = cni_body_at(world, body)->contact_first; key != CNI_NONE; key = cni_contact_of_key(world, key)->next[key & 1]) {
			const cni_contact *c = cni_contact_of_key(world, key);
			if (cni_contact_has_lane(c) && (body == c->body[0] || !cni_is_dynamic(world, c->body[0])))
				lane_limit(world, c->slot, speed_most);
		}
}

static void neighbour_limit(cn_world *world, int32_t body)
{
	if (cni_is_dynamic(world, body) && cni_body_at(world, body)->island != CNI_NONE)
		island_limit(world, cni_island_at(world, cni_body_at(world, body)->island));
}

void cni_body_let_go(cn_world *world, int32_t body)
{
	int32_t key;
	cni_body_wake_neighbours(world, body);
	neighbour_limit(world, body);
	for (key = cni_body_at(world, body)->contact_first; key != CNI_NONE; key = cni_contact_of_key(world, key)->next[key & 1])
		if (cni_contact_of_key(world, key)->flags & CNI_CONTACT_TOUCHING)
			neighbour_limit(world, cni_contact_of_key(world, key)->body[1 - (key & 1)]);
	for (key = cni_body_at(world, body)->joint_first; key != CNI_NONE; key = cni_joint_at(world, key >> 1)->next[key & 1])
		neighbour_limit(world, cni_joint_at(world, key >> 1)->body[1 - (key & 1)]);
}
