/*
 * contacts/deep_lanes.h - which lanes of a block overlap, and by how much. Scans over all blocks of a step use it.
 */
#ifndef CNI_CONTACTS_DEEP_LANES_H
#define CNI_CONTACTS_DEEP_LANES_H

#include "base/cpu.h"
#include "model/world.h"
#if CNI_HAS_WIDE_4
#define CNI_WIDTH 4
#include "base/wide.h"
#endif

/* Bit l: a point of lane l overlaps by more than most. Lanes without a contact are zeros. */
static inline uint32_t cni_deep_lanes(const cni_contact_block *k, float most)
{
	uint32_t deep = 0;
	int32_t l;
#if CNI_HAS_WIDE_4
	for (l = 0; l < CNI_LANES; l += 4)
		deep |= cni_mask_bits(cni_wide_min(cni_wide_load(&k->p[0].s0[l]), cni_wide_load(&k->p[1].s0[l])) < cni_wide_of(-most)) << l;
#else
	for (l = 0; l < CNI_LANES; ++l)
		deep |= (uint32_t)(cni_min(k->p[0].s0[l], k->p[1].s0[l]) < -most) << l;
#endif
	return deep;
}

/* The deeper overlap of the lane's points, below 0 where they are apart. */
static inline float cni_lane_overlap(const cni_contact_block *k, int32_t l)
{
	return cni_max(k->p[0].nm[l] > 0.0f ? -k->p[0].s0[l] : -FLT_MAX, k->p[1].nm[l] > 0.0f ? -k->p[1].s0[l] : -FLT_MAX);
}

#endif
