/*
 * narrowphase/deep_bodies.h - bodies pressed deep into something immovable. Private to narrowphase/.
 */
#ifndef CNI_NARROWPHASE_DEEP_BODIES_H
#define CNI_NARROWPHASE_DEEP_BODIES_H

#include "model/world.h"

/* Sets CNI_EXTERNAL_DEFERRED on bodies whose core may reach what they touch in one slow step. */
void cni_deep_bodies_mark(cn_world *world);

#endif
