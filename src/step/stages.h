/*
 * step/stages.h - the parts of a step that are in this folder, in order; its numbers.
 */
#ifndef CNI_STEP_STAGES_H
#define CNI_STEP_STAGES_H

#include "model/solve.h"

cni_solve cni_solve_make(const cn_world *world, float dt);
/* One substep, nothing kept from the last step. */
cni_solve cni_solve_make_sequential(const cn_world *world, float dt);
/* Stage 6. */
void cni_external_prepare(cn_world *world, const cni_solve *s);           /* drive; free bodies' whole step */
void cni_external_finish(cn_world *world);                                /* ... before islands may change: their dense array is no more */
void cni_external_prepare_bound(cn_world *world);                         /* drive of all bodies, none taken as free */
void cni_integrate_velocities(cn_world *world, const cni_solve *s, int32_t substep);
void cni_integrate_positions(cn_world *world, const cni_solve *s);
void cni_integrate_finish(cn_world *world, const cni_solve *s);
/* Joints of bodies whose velocity jumped in this substep go on from their loads: step/velocity_jumps.c. */
void cni_velocity_jumps_reset(cn_world *world, const cni_solve *s);
/* Marks such bodies, and returns how many there are. */
uint32_t cni_velocity_jumps_mark(cn_world *world, const cni_solve *s);
/* After the first substep: what stands is done with for this step: step/early_rest.c. */
void cni_rest_find(cn_world *world, const cni_solve *s);
/* After the substeps: gives what nothing holds its angular momentum back: step/angular_momentum.c. */
void cni_angular_momentum_restore(cn_world *world);
/* Stage 8: poses, boxes, speed limits, rest timers. Returns 1 when some body has rested long enough to sleep. */
int32_t cni_stage_finalize(cn_world *world, const cni_solve *s);
/* The part of it that moves bodies by their change, and the boxes after them: sequential solver. */
void cni_poses_take(cn_world *world);
/* Stage 9: calls the user's callbacks. */
void cni_stage_events(cn_world *world);
/* Stage 10. */
void cni_stage_sleep(cn_world *world);

#endif
