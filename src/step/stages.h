/*
 * step/stages.h - the stages of this folder, in step order, and the constructors of a step's numbers.
 */
#ifndef CNI_STEP_STAGES_H
#define CNI_STEP_STAGES_H

#include "model/solve.h"

cni_solve cni_solve_make(const cn_world *world, float dt, int32_t substeps);
/* One substep, no warm start. */
cni_solve cni_solve_make_sequential(const cn_world *world, float dt);
/* Stage 6. */
void cni_external_prepare(cn_world *world, const cni_solve *s);           /* external accelerations; the whole step of free bodies */
void cni_external_finish(cn_world *world);                                /* before islands may change: frees their numbers */
void cni_external_prepare_bound(cn_world *world, float dt);               /* external accelerations; treats no body as free */
/* Before external accelerations: those of bodies in areas. */
void cni_areas_accelerate(cn_world *world, float dt);
void cni_integrate_velocities(cn_world *world, const cni_solve *s, int32_t substep);
void cni_integrate_positions(cn_world *world, const cni_solve *s);
void cni_integrate_finish(cn_world *world, const cni_solve *s);
/* Applies speed limits to the displacements of a step; bodies whose motion is not finite stay where they are. */
void cni_moves_clamp(cn_world *world, const cni_solve *s);
/* After the first substep: bodies at rest are finished for this step: step/early_rest.c. */
void cni_rest_find(cn_world *world, const cni_solve *s);
/* After the substeps: restores the angular momentum of isolated groups of bodies: step/angular_momentum.c. */
void cni_angular_momentum_restore(cn_world *world);
/* Stage 8: poses, boxes, speed limits, rest timers. Returns 1 when some body has rested long enough to sleep. */
int32_t cni_stage_finalize(cn_world *world, const cni_solve *s);
/* The part of stage 8 that updates poses and boxes: sequential solver. */
void cni_poses_take(cn_world *world);
/* Moves still bodies out of their overlaps. Runs before the warm start, at the poses of the step's beginning. */
void cni_stage_project_overlaps(cn_world *world, const cni_solve *s);
/* Stage 9: calls the user's callbacks. */
void cni_stage_events(cn_world *world);
/* Stage 10. */
void cni_stage_sleep(cn_world *world, float dt);

/* ---- the sequential solver: sequential.c ---- */

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
