/*
 * joints/joint_lane.c - the shared part of lanes of pins and lanes of rows: colours, coefficients of springs.
 */
#include "base/bitset.h"
#include "joints/joint_pass.h"

int32_t cni_joint_color_take(cn_world *world, int32_t ia, int32_t ib)
{
	cni_external *a = cni_motion_can_move(cni_motions(world) + ia) ? cni_externals(world) + ia : NULL;
	cni_external *b = cni_motion_can_move(cni_motions(world) + ib) ? cni_externals(world) + ib : NULL;
	uint32_t used = (a != NULL ? a->flags : 0) | (b != NULL ? b->flags : 0);
	uint32_t open = ~(used >> CNI_EXTERNAL_COLOR_SHIFT) & ((1u << CNI_JOINT_COLORS) - 1u);
	int32_t color;
	if (open == 0)
		return CNI_NONE;
	color = cni_bit_lowest32(open);
	if (a != NULL)
		a->flags |= 1u << (CNI_EXTERNAL_COLOR_SHIFT + color);
	if (b != NULL)
		b->flags |= 1u << (CNI_EXTERNAL_COLOR_SHIFT + color);
	return color;
}

cni_soft cni_lane_spring_soft(cni_lane_spring *g, float hertz, float damping_ratio, float h)
{
	if (hertz != g->hertz || damping_ratio != g->damping_ratio) {
		g->hertz = hertz;
		g->damping_ratio = damping_ratio;
		g->soft = cni_soft_exact(hertz, damping_ratio, h);
	}
	return g->soft;
}
