/*
 * contacts/pile_state.c - tests of piles: is a body or an island quiet, has an island joints, does a contact bear more than soft
 * constraints can?
 */
#include "contacts/contacts.h"
#include "model/tuning.h"

int32_t cni_body_is_slower(const cn_world *world, const cni_body *b, float most)
{
	const cni_motion *m = cni_motions(world) + b->awake;
	float turn = m->w * b->extent;
	return m->vx * m->vx + m->vy * m->vy <= most * most && turn * turn <= most * most;
}

int32_t cni_body_is_quiet(const cn_world *world, const cni_body *b)
{
	return cni_body_is_slower(world, b, CNI_PILE_QUIET_SPEED * world->settings.length_unit);
}

int32_t cni_island_is_quiet(const cn_world *world, const cni_island *i)
{
	int32_t body;
	for (body = i->first; body != CNI_NONE; body = cni_body_at(world, body)->island_next)
		if (!cni_body_is_quiet(world, cni_body_at(world, body)))
			return 0;
	return 1;
}

int32_t cni_island_has_joints(const cn_world *world, int32_t island)
{
	int32_t body;
	for (body = cni_island_at(world, island)->first; body != CNI_NONE; body = cni_body_at(world, body)->island_next)
		if (cni_body_at(world, body)->joint_first != CNI_NONE)
			return 1;
	return 0;
}

/*
 * Soft contacts yield by about g h^2 per carried weight, so a column of s bodies shortens by s^2 g h^2. When that is not small
 * against its width, the column tilts faster than the solver rights it: small bodies sooner than large ones.
 */
int32_t cni_is_stressed(const cn_world *world, int32_t ia, int32_t ib, float impulse, float h, float part)
{
	float g = cni_length(world->settings.gravity), inv_a = cni_motions(world)[ia].inv_mass, inv_b = cni_motions(world)[ib].inv_mass;
	float stress = g > 0.0f ? impulse * cni_max(inv_a, inv_b) / (part * h * g) : 0.0f;
	float size = cni_body_at(world, cni_awake_ids(world)[inv_b > inv_a ? ib : ia])->extent;
	return stress > CNI_PILE_STRESS_MAX || stress * stress * g * h * h > CNI_PILE_BUCKLING_PART * size;
}
