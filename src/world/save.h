/*
 * world/save.h - a world's state as bytes: what world/save.c (the calls, what is checked) and world/save_state.c (what the
 * state is) share.
 */
#ifndef CNI_WORLD_SAVE_H
#define CNI_WORLD_SAVE_H

#include "base/snapshot.h"
#include "model/world.h"

/* All state of the world, in the snapshot's mode. SAVE and MEASURE change nothing. */
void cni_world_snapshot(cn_world *world, cni_snapshot *s);
/* A number that changes with what the bytes mean: sizes and places of records, version, order of bytes. */
uint64_t cni_world_layout(void);
/* 1 when every byte of cn_world is known to be state that is saved, or something else. For tests. */
int32_t cni_world_members_are_known(void);

#endif
