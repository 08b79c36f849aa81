/*
 * step/sequential.h - the stages of the sequential solver; see sequential.c.
 */
#ifndef CNI_STEP_SEQUENTIAL_H
#define CNI_STEP_SEQUENTIAL_H

#include "model/solve.h"

void cni_sequential_velocities(cn_world *world, const cni_solve *s);
void cni_sequential_positions(cn_world *world, const cni_solve *s);
/* Before poses move: the continuous collision of the soft step, so that nothing is pushed through static bodies. */
void cni_sequential_guard(cn_world *world);
void cni_sequential_velocity_response(cn_world *world, const cni_solve *s);
void cni_sequential_position_response(cn_world *world);
/* Bodies with a locked axis lose what moves them along it. */
void cni_sequential_hold_locked(cn_world *world);
/* Constraints on a single body (1), before contacts; joints between bodies (0) after them. */
void cni_sequential_joints(cn_world *world, const cni_solve *s, int32_t constraints);

#endif
