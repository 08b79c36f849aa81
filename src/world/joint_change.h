/*
 * world/joint_change.h - what the public functions on joints share: checking limits and replacing flags.
 */
#ifndef CNI_WORLD_JOINT_CHANGE_H
#define CNI_WORLD_JOINT_CHANGE_H

#include "world/error.h"

#define CNI_JOINT_FLAGS (CN_JOINT_COLLIDE | CN_JOINT_LIMIT | CN_JOINT_MOTOR | CN_JOINT_SPRING)

/* Revolute: -pi <= lower <= upper <= pi. Distance: 0 <= lower <= upper. */
void cni_check_joint_limits(cni_call *call, int32_t type, float lower, float upper);
/* Room for cni_joint_change_flags. */
void cni_joint_change_reserve(cni_call *call, cn_world *world, const cni_joint *j);
/* Replaces the flags, ends or allows contacts between the bodies, forgets impulses of rows that are no
   longer there, and wakes. */
void cni_joint_change_flags(cn_world *world, int32_t joint, uint32_t flags);

#endif
