/*
 * contacts/contacts.h - what other folders call: the soft contact solver, restitution, gravity preload.
 */
#ifndef CNI_CONTACTS_CONTACTS_H
#define CNI_CONTACTS_CONTACTS_H

#include "model/solve.h"

/* The blocks of all colours, for the passes of this step; after the narrowphase. Sets s->bounces, contact_colors and lanes. */
void cni_contacts_list(cn_world *world, cni_solve *s);
void cni_contacts_warm_start(cn_world *world, const cni_solve *s);
void cni_contacts_solve(cn_world *world, const cni_solve *s);
void cni_contacts_relax(cn_world *world, const cni_solve *s);
/* One contact of them, in a pass that has been: by its slot. */
void cni_contact_solve_again(cn_world *world, const cni_solve *s, int32_t slot);
void cni_contacts_impact(cn_world *world, const cni_solve *s);
/* Loads of piles that are too large for that, and their impulses when they are new. Before the warm start. */
void cni_gravity_preload(cn_world *world, const cni_solve *s);
/* Is every body of a quiet island held by what is below it? Else things lean on each other. */
int32_t cni_pile_is_supported(cn_world *world, int32_t island, float h);
/* Scratch that either may take. */
uint64_t cni_gravity_preload_bytes(int32_t bodies);
/* Does the lighter of two bodies bear more than a part of what soft contacts can, with this impulse between them in a
   substep h? Such contacts are not left to the soft solver, which would crush them. direct/solver_selection.c. */
int32_t cni_is_stressed(const cn_world *world, int32_t ia, int32_t ib, float impulse, float h, float part);
/* Neither moves nor turns faster than what lies in a pile. */
int32_t cni_body_is_quiet(const cn_world *world, const cni_body *b);
int32_t cni_island_is_quiet(const cn_world *world, const cni_island *i);
int32_t cni_island_has_joints(const cn_world *world, int32_t island);

#endif
