/*
 * test/arch/motion.h - scenes that move: shapes, joints, direct solving, tiers, the sequential solver.
 */
#ifndef CAIRN_TEST_ARCH_MOTION_H
#define CAIRN_TEST_ARCH_MOTION_H

#include "joints.h"

static void scene_shapes(void)
{
	cn_world *world = world_of(CN_SOLVER_SOFT, CN_BROADPHASE_TREE);
	cn_body mill;
	add_ground(world);
	mill = box_at(world, CN_BODY_KINEMATIC, 1.0f, 0.8f, 0.0f, 0.8f, 0.1f, 1.0f);
	MUST(cn_body_set_velocity(world, mill, 0.0f, 0.0f, 3.0f));
	add_rain(world, 40);
	steps(world, 150);
	cn_world_destroy(world);
}

static void scene_joints(void)
{
	cn_world *world = world_of(CN_SOLVER_SOFT, CN_BROADPHASE_SWEEP);
	int32_t type;
	add_ground(world);
	add_every_joint(world);
	steps(world, 120);
	for (type = 0; type <= CN_JOINT_FILTER; ++type) {
		cn_vec2 force;
		float torque, position;
		MUST(cn_joint_get_reaction(world, arch_joints[type], &force, &torque));
		mix_vec2(force);
		mix_float(torque);
		if (type != CN_JOINT_FILTER) {
			MUST(cn_joint_get_position(world, arch_joints[type], &position));
			mix_float(position);
		}
	}
	cn_world_destroy(world);
}

static void scene_direct(void)
{
	cn_world *world = world_of(CN_SOLVER_DIRECT, CN_BROADPHASE_SWEEP);
	add_ground(world);
	add_every_joint(world);
	add_chain_and_trees(world);
	steps(world, 60);
	cn_world_destroy(world);
}

static void mix_islands(const cn_world *world)
{
	cn_island_report reports[64];
	int32_t count = 0, k;
	MUST(cn_world_get_islands(world, reports, 64, &count));
	mix((uint32_t)count);
	for (k = 0; k < count && k < 64; ++k) {
		see(SEEN_TIER + reports[k].tier);
		mix((uint32_t)reports[k].tier);
		mix((uint32_t)reports[k].reason);
		mix((uint32_t)reports[k].substeps);
		mix_float(reports[k].residual_m);
	}
}

/* A leaning stack, a loaded pile, an arch of stones, a loaded bridge, figures in the air. */
static void scene_tiers(void)
{
	cn_world *world = world_of(CN_SOLVER_AUTO, CN_BROADPHASE_SWEEP);
	cn_body last = 0;
	int32_t k;
	box_at(world, CN_BODY_STATIC, 0.0f, -0.5f, 0.0f, 30.0f, 0.5f, 1.0f);
	for (k = 0; k < 8; ++k)
		box_at(world, CN_BODY_DYNAMIC, -10.0f + 0.06f * (float)k, 0.25f + 0.5f * (float)k, 0.0f, 0.25f, 0.25f, 1.0f);
	for (k = 0; k < 4; ++k)
		box_at(world, CN_BODY_DYNAMIC, -7.0f, 0.25f + 0.5f * (float)k, 0.0f, 0.25f, 0.25f, 1.0f);
	box_at(world, CN_BODY_DYNAMIC, -7.0f, 2.6f, 0.0f, 0.6f, 0.6f, 100.0f);
	for (k = 0; k < 12; ++k) {
		cn_body plank = box_at(world, CN_BODY_DYNAMIC, 0.5f * (float)k - 2.75f, 4.0f, 0.0f, 0.25f, 0.08f, 2.0f);
		hinge(world, last, last == 0 ? -3.0f : 0.25f, last == 0 ? 4.0f : 0.0f, plank, -0.25f, 0.0f);
		last = plank;
	}
	hinge(world, 0, 3.0f, 4.0f, last, 0.25f, 0.0f);
	for (k = 0; k < 6; ++k)
		box_at(world, CN_BODY_DYNAMIC, 0.7f * (float)k - 1.75f, 4.5f, 0.0f, 0.25f, 0.25f, 3.0f);
	add_chain_and_trees(world);
	for (k = 0; k < 12; ++k) {
		steps(world, 10);
		mix_islands(world);
	}
	cn_world_destroy(world);
}

static void scene_sequential(void)
{
	cn_world *world = world_of(CN_SOLVER_SEQUENTIAL, CN_BROADPHASE_SWEEP);
	add_ground(world);
	add_every_joint(world);
	add_rain(world, 20);
	steps(world, 100);
	cn_world_destroy(world);
}

#endif
