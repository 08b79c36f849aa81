/*
 * narrowphase/narrowphase.h - what other folders call: pairs, seams, manifolds, continuous collision.
 */
#ifndef CNI_NARROWPHASE_NARROWPHASE_H
#define CNI_NARROWPHASE_NARROWPHASE_H

#include "model/solve.h"

/* Stage 2: new pairs become contacts. Writes contacts, proxies' lists, warnings. */
void cni_stage_pairs(cn_world *world, float dt);
/* After stage 2: hidden corners between fixed shapes, where such shapes changed. Writes their geometry. */
void cni_stage_seams(cn_world *world);
/* Stage 3 and 4: manifolds into lanes; begins and ends of touching, ended pairs. Writes contacts,
   lanes, islands, events. */
void cni_stage_narrowphase(cn_world *world, float dt);
/* Stage 8, first part: shortens the changes of fast bodies that would pass through things. Before any box moves. */
void cni_stage_continuous(cn_world *world);

#endif
