/*
 * narrowphase/narrowphase.h - interface for other folders: pairs, seams, manifolds, continuous collision.
 */
#ifndef CNI_NARROWPHASE_NARROWPHASE_H
#define CNI_NARROWPHASE_NARROWPHASE_H

#include "model/solve.h"

/* Stage 2: creates contacts of new pairs. Writes contacts, proxies' lists, warnings. */
void cni_stage_pairs(cn_world *world, float dt);
/* After stage 2: finds hidden corners between fixed shapes, where such shapes changed. Writes their geometry. */
void cni_stage_seams(cn_world *world);
/* Stages 3 and 4: writes manifolds into lanes; begins and ends touching; destroys ended pairs. Writes contacts,
   lanes, islands, events. */
void cni_stage_narrowphase(cn_world *world, float dt);
/* Stage 8, first part: shortens the motion of fast bodies that would tunnel. Runs before any box moves. */
void cni_stage_continuous(cn_world *world);

#endif
