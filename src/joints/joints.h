/*
 * joints/joints.h - the interface of joints/ to other folders: the soft joint solver.
 */
#ifndef CNI_JOINTS_JOINTS_H
#define CNI_JOINTS_JOINTS_H

#include "model/solve.h"

void cni_joints_prepare(cn_world *world, const cni_solve *s);
/* Places joints into lanes, once it is known which are solved directly. */
void cni_joint_blocks_gather(cn_world *world, const cni_solve *s);
void cni_joints_warm_start(cn_world *world, const cni_solve *s);
/* Constraints on single bodies (1) or joints between bodies (0), without warm starting: sequential solver. */
void cni_joints_solve_fresh(cn_world *world, const cni_solve *s, int32_t constraints);
void cni_joints_solve(cn_world *world, const cni_solve *s);
void cni_joints_limit_turns(cn_world *world, const cni_solve *s);
void cni_joints_relax(cn_world *world, const cni_solve *s);
/* After all relax passes of a substep: records the largest reaction of breakable joints. */
void cni_joints_stress(cn_world *world, const cni_solve *s);
void cni_joints_store(cn_world *world, const cni_solve *s);
/* After finalize: reports joints whose reaction was beyond their threshold, and destroys those that break. */
void cni_joints_break(cn_world *world);

#endif
