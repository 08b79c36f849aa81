/*
 * narrowphase/deep_bodies.c - marks slow bodies that are pressed deep into something immovable, for continuous.c (part of stage 8).
 *
 * Continuous collision skips bodies that move by less than a quarter of their inner radius in a step. Neighbours or a kinematic body
 * can press a body through a wall with many such steps. A body that overlaps by at most a quarter of its inner radius keeps its core clear
 * for one more step; deeper ones are marked, and their path is checked like that of fast bodies.
 *
 * Reads lanes, bodies; writes CNI_EXTERNAL_DEFERRED.
 */
#include "narrowphase/touch.h"

/* Overlap at the beginning of the step. Rows of missing points are 0. */
static float lane_depth(const cni_contact_block *k, int32_t l)
{
	return -cni_min(k->p[0].s0[l], k->p[1].s0[l]);
}

/* Body a of the lane is the movable one. */
static void lane_mark(cn_world *world, const cni_contact_block *k, int32_t l)
{
	int32_t index = k->ia[l];
	if (lane_depth(k, l) > CNI_CORE_NEAR_PART * cni_body_at(world, cni_awake_ids(world)[index])->core)
		cni_externals(world)[index].flags |= CNI_EXTERNAL_DEFERRED;
}

/* least: smaller overlaps, which bodies at rest have, are skipped without reading records. */
static void block_mark(cn_world *world, const cni_contact_block *k, int32_t lanes, float least)
{
	const cni_motion *motions = cni_motions(world);
	int32_t l;
	for (l = 0; l < lanes; ++l)
		if (lane_depth(k, l) > least && !(motions[k->ib[l]].inv_mass > 0.0f))
			lane_mark(world, k, l);
}

void cni_deep_bodies_mark(cn_world *world)
{
	float least = CNI_CORE_NEAR_PART * world->settings.slop;
	int32_t color, block, left;
	for (color = CNI_COLOR_STATIC; color < CNI_COLORS; ++color)
		for (left = world->colors[color].lanes, block = world->colors[color].first; left > 0; left -= CNI_LANES) {
			block_mark(world, cni_block_at(world, block), cni_min_i(left, CNI_LANES), least);
			block = cni_block_info_at(world, block)->next;
		}
}
