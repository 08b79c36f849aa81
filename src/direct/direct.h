/*
 * direct/direct.h - what other folders call: which islands are solved directly, and their passes.
 */
#ifndef CNI_DIRECT_DIRECT_H
#define CNI_DIRECT_DIRECT_H

#include "model/solve.h"

/* Stage 5: which islands are solved directly, contacts and all. */
void cni_stage_select_solvers(cn_world *world, float h);
/* The island cannot be solved directly, now and for some time. reason: CN_TIER_REASON_ */
void cni_island_refuse(cn_world *world, int32_t island, int32_t reason);
/* Has it been refused so lately that it is left alone in the step of this count? */
int32_t cni_island_is_refused(const cni_island *i, uint32_t step);
/* Is it soft in that step because no solution was found for it? */
int32_t cni_island_is_unsolved(const cni_island *i, uint32_t step);
/* No island is solved directly any more: the solver changed. */
void cni_solver_selection_reset(cn_world *world);
/* Scratch that directly solving so many joints and contacts may take. */
uint64_t cni_direct_bytes(int32_t solver, int32_t joints, int32_t contacts, int32_t bodies);
/* ... and what of it is kept from step to step. */
uint64_t cni_direct_kept_bytes(int32_t solver, int32_t joints, int32_t contacts);
/* Plans which joints and contacts are solved directly into out, and sets s->direct to it. */
void cni_direct_prepare(cn_world *world, cni_solve *s, struct cni_sparse *out);
/* Impulses of the last step. */
void cni_direct_warm_start(cn_world *world, const cni_solve *s);
/* One pass over them: with errors' bias (1), or rigid at the new positions (0). */
void cni_direct_solve(cn_world *world, const cni_solve *s, int32_t bias);
/* After the contacts: joints that they would part in this substep once more. */
void cni_direct_project(cn_world *world, const cni_solve *s);
/* Gives its contacts back to their lanes. */
void cni_direct_store(cn_world *world, const cni_solve *s);
/* The whole step of bodies that nothing but joints holds. */
void cni_rattle_run(cn_world *world, const cni_solve *s);

#endif
