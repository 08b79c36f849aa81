/*
 * direct/direct.h - the interface of direct/ to other folders: solver selection for islands, and the passes of the direct solver.
 */
#ifndef CNI_DIRECT_DIRECT_H
#define CNI_DIRECT_DIRECT_H

#include "model/solve.h"

/* Stage 5: selects the islands whose joints and contacts are solved directly. */
void cni_stage_select_solvers(cn_world *world, float h);
/* Bars the island from direct solving for a time. reason: CN_TIER_REASON_ */
void cni_island_refuse(cn_world *world, int32_t island, int32_t reason);
/* 1: in step `step` the island is still barred by cni_island_refuse. */
int32_t cni_island_is_refused(const cni_island *i, uint32_t step);
/* 1: the island is soft in step `step` because no direct solution was found for it. */
int32_t cni_island_is_unsolved(const cni_island *i, uint32_t step);
/* Returns all islands to soft contacts: the world's solver changed. */
void cni_solver_selection_reset(cn_world *world);
/* Bound on the scratch memory of direct solving, for this number of joints, contacts and bodies. */
uint64_t cni_direct_bytes(int32_t solver, int32_t joints, int32_t contacts, int32_t bodies);
/* ... and on its memory that persists between steps. */
uint64_t cni_direct_kept_bytes(int32_t solver, int32_t joints, int32_t contacts);
/* Plans which joints and contacts are solved directly into out, and sets s->direct to it. */
void cni_direct_prepare(cn_world *world, cni_solve *s, struct cni_sparse *out);
/* Applies the impulses of the last step. */
void cni_direct_warm_start(cn_world *world, const cni_solve *s);
/* One pass over all components. bias 1: with error correction; 0: rigid, at the new positions. */
void cni_direct_solve(cn_world *world, const cni_solve *s, int32_t bias);
/* After the contact pass: solves joints again that contacts would open in this substep. */
void cni_direct_project(cn_world *world, const cni_solve *s);
/* After the relax passes: repeats them for joints and contacts of slow components while contacts open the joints. */
void cni_direct_settle(cn_world *world, const cni_solve *s);
/* After the substeps: contacts that the joints bear bounce; writes the contacts of the direct solver back to their lanes. */
void cni_direct_store(cn_world *world, const cni_solve *s);
/* At the end of a substep: adds the impulses of directly solved contacts to the sums of those that report them. */
void cni_direct_sum_impulses(cn_world *world, const struct cni_sparse *sparse);
/* The world's workers, where there is enough to do in loops over components that take as long as so many factorizations; NULL: this thread alone. */
cni_team *cni_components_team(const cn_world *world, const struct cni_sparse *sparse, int32_t times);
/* Integrates the whole step of bodies that only joints constrain (RATTLE). */
void cni_rattle_run(cn_world *world, const cni_solve *s);

#endif
