/*
 * base/snapshot.h - persistent state into one piece of memory and back. One walk over the state does all of it: owners pass
 * what they own to the functions below, in a fixed order, and the mode says what becomes of it.
 *
 *   MEASURE  counts bytes
 *   SAVE     state -> bytes
 *   RESERVE  makes the room that the state in the bytes needs; the state stays as it is. May fail
 *   LOAD     bytes -> state; cannot fail after RESERVE
 *   ABANDON  gives back what a RESERVE that failed has set aside; room in tables and arrays stays
 *
 * What is copied depends on the state alone, never on capacities: a state that is loaded and saved again gives the same
 * bytes.
 */
#ifndef CNI_BASE_SNAPSHOT_H
#define CNI_BASE_SNAPSHOT_H

#include "base/blocks.h"
#include "base/table.h"

enum { CNI_SNAPSHOT_MEASURE, CNI_SNAPSHOT_SAVE, CNI_SNAPSHOT_RESERVE, CNI_SNAPSHOT_LOAD, CNI_SNAPSHOT_ABANDON };

typedef struct cni_snapshot {
	uint8_t *at;         /* the next byte, NULL in MEASURE; only SAVE writes there */
	uint64_t bytes;      /* passed so far */
	cni_memory *memory;
	int32_t mode;
	int32_t failed;      /* 1: RESERVE found no memory, and does nothing from then on */
} cni_snapshot;

cni_snapshot cni_snapshot_begin(int32_t mode, void *bytes, cni_memory *memory);
/* Copies state of a fixed size. */
void cni_snapshot_state(cni_snapshot *s, void *state, uint64_t bytes);
/* A number of the walk itself: the given one is saved; the one to go on with is returned. */
int32_t cni_snapshot_number(cni_snapshot *s, int32_t number);
/* The items that count. */
void cni_snapshot_array(cni_snapshot *s, cni_array *array);
/* Items 0 .. used - 1; used is that of the state that is there now. Items behind those that are loaded are zero. */
void cni_snapshot_table(cni_snapshot *s, cni_table *table, int32_t used);
/* Everything about the pieces. */
void cni_snapshot_blocks(cni_snapshot *s, cni_blocks *blocks);

/* RESERVE notes that something had no memory. */
static inline void cni_snapshot_need(cni_snapshot *s, int32_t good) { s->failed |= !good; }
/* Is there room to be made? */
static inline int32_t cni_snapshot_reserves(const cni_snapshot *s) { return s->mode == CNI_SNAPSHOT_RESERVE && !s->failed; }

#endif
