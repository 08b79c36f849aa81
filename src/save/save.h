/*
 * save/save.h - a world's state as bytes: what save/save.c (the calls, what is checked), save/save_state.c (what the
 * state is) and save/save_delta.c (differences) share.
 */
#ifndef CNI_WORLD_SAVE_H
#define CNI_WORLD_SAVE_H

#include "base/snapshot.h"
#include "model/world.h"

/* All state of the world, in the snapshot's mode. SAVE and MEASURE change nothing. */
void cni_world_snapshot(cn_world *world, cni_snapshot *s);
/* A number that changes with what the bytes mean: sizes and places of records, version, order of bytes. */
uint64_t cni_world_layout(void);
/* Does the header say that these bytes are a save of this build? */
int32_t cni_save_is_one(const void *save, uint64_t bytes);
uint64_t cni_save_checksum(const void *bytes, uint64_t count);

#endif
