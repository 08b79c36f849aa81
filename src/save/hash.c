/*
 * save/hash.c - one number for the state of a world (FNV-1a: Fowler, Noll, Vo, 1991).
 *
 * Values are hashed as little-endian bytes on every machine, so that histories can be compared between
 * machines. Order: bodies, touching contacts, then joints with solver memory (cni_joint_trust, apart), each by slot.
 */
#include "model/world.h"

static uint64_t hash_word(uint64_t hash, uint32_t word)
{
	for (int32_t k = 0; k < 4; ++k)
		hash = (hash ^ (word >> 8 * k & 0xFFu)) * 0x100000001B3u;
	return hash;
}

static uint64_t hash_float(uint64_t hash, float x) { return hash_word(hash, cni_bits_of(x)); }

static uint64_t hash_body(uint64_t hash, const cn_world *world, const cni_body *b)
{
	cn_velocity v = cni_body_velocity(world, b);
	const float numbers[] = { b->cx, b->cy, b->cx_low, b->cy_low, b->q.c, b->q.s, v.linear_mps.x, v.linear_mps.y, v.angular_radps };
	for (uint32_t k = 0; k < sizeof numbers / sizeof numbers[0]; ++k)
		hash = hash_float(hash, numbers[k]);
	return hash_word(hash, b->awake != 0);
}

static uint64_t hash_contact(uint64_t hash, const cn_world *world, int32_t contact)
{
	cn_contact_event e;
	cni_contact_describe(world, contact, 0, &e);
	hash = hash_word(hash, (uint32_t)contact);
	hash = hash_float(hash, e.manifold.friction_impulse_Ns);
	for (int32_t k = 0; k < e.manifold.point_count; ++k)
		hash = hash_float(hash, e.manifold.points[k].normal_impulse_Ns);
	return hash;
}

static uint64_t hash_joint(uint64_t hash, const cn_world *world, int32_t joint)
{
	const cni_joint *j = cni_joint_at(world, joint);
	const cni_joint_trust *t = &j->trust;
	int32_t left = (int32_t)(j->awake != CNI_NONE ? t->until - world->step_count : t->until);
	uint32_t apart = j->apart;
	if (t->surplus == 0.0f && t->span == 0 && !apart)
		return hash;
	hash = hash_word(hash, (uint32_t)joint);
	hash = hash_float(hash, t->surplus);
	hash = hash_word(hash, t->span > 0 && left > 0 ? (uint32_t)left : 0);
	return hash_word(hash, (uint32_t)t->span << 16 | apart << 8 | t->soft);
}

cn_result cn_world_hash(const cn_world *world, uint64_t *out_hash)
{
	uint64_t hash = 0xCBF29CE484222325u;
	if (world == NULL || out_hash == NULL)
		return CN_ERROR_ARGUMENT;
	for (int32_t k = cni_handles_next(&world->body_handles, 0); k != CNI_NONE; k = cni_handles_next(&world->body_handles, k + 1))
		hash = hash_body(hash, world, cni_body_at(world, k));
	for (int32_t k = 0; k < world->contact_used; ++k)
		if (cni_contact_at(world, k)->flags & CNI_CONTACT_TOUCHING)
			hash = hash_contact(hash, world, k);
	for (int32_t k = cni_handles_next(&world->joint_handles, 0); k != CNI_NONE; k = cni_handles_next(&world->joint_handles, k + 1))
		hash = hash_joint(hash, world, k);
	*out_hash = hash;
	return CN_OK;
}
