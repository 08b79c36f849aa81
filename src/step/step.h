/*
 * step/step.h - interface of the folder: one step of a world.
 */
#ifndef CNI_STEP_STEP_H
#define CNI_STEP_STEP_H

#include "model/world.h"

/* dt in seconds, 0 to 1; 0 updates contacts and events and moves nothing. */
void cni_step(cn_world *world, float dt);
/* Bytes of frame memory that the projection of overlaps takes. */
uint64_t cni_project_overlaps_bytes(int32_t bodies, int32_t islands, int32_t contacts);

#endif
