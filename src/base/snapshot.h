/*
 * base/snapshot.h - copies persistent state into one piece of memory and back. One traversal serves all modes: owners pass
 * their state to the functions below in a fixed order, and the mode selects the operation.
 *
 *   MEASURE  counts bytes
 *   SAVE     state -> bytes
 *   RESERVE  reserves the memory for the state in the bytes and does not change the present state. May fail
 *   LOAD     bytes -> state; cannot fail after RESERVE
 *   ABANDON  frees the memory of a failed RESERVE; capacities of tables and arrays stay
 *
 * The bytes depend only on the state, never on capacities: loading and saving again gives the same bytes.
 */
#ifndef CNI_BASE_SNAPSHOT_H
#define CNI_BASE_SNAPSHOT_H

#include "base/blocks.h"
#include "base/table.h"

enum { CNI_SNAPSHOT_MEASURE, CNI_SNAPSHOT_SAVE, CNI_SNAPSHOT_RESERVE, CNI_SNAPSHOT_LOAD, CNI_SNAPSHOT_ABANDON };

typedef struct cni_snapshot {
	uint8_t *at;         /* the next byte, NULL in MEASURE; only SAVE writes there */
	uint64_t bytes;      /* number passed so far */
	cni_memory *memory;
	int32_t mode;
	int32_t failed;      /* 1: RESERVE found no memory and reserves nothing further */
} cni_snapshot;

cni_snapshot cni_snapshot_begin(int32_t mode, void *bytes, cni_memory *memory);
/* Copies state of a fixed size. */
void cni_snapshot_state(cni_snapshot *s, void *state, uint64_t bytes);
/* Copies the members of a record that lie from one offset up to another. */
static inline void cni_snapshot_members(cni_snapshot *s, void *record, size_t from, size_t to)
{
	cni_snapshot_state(s, (uint8_t *)record + from, to - from);
}
/* A number that controls the traversal: SAVE writes it; the other modes except MEASURE return the number in the bytes. */
int32_t cni_snapshot_number(cni_snapshot *s, int32_t number);
/* The items below count. */
void cni_snapshot_array(cni_snapshot *s, cni_array *array);
/* Items 0 .. used - 1, where used belongs to the present state. LOAD zeroes the items behind the loaded ones. */
void cni_snapshot_table(cni_snapshot *s, cni_table *table, int32_t used);
/* The whole block allocator with its pieces. */
void cni_snapshot_blocks(cni_snapshot *s, cni_blocks *blocks);

/* Records the result of a reservation; 0: no memory. */
static inline void cni_snapshot_need(cni_snapshot *s, int32_t good) { s->failed |= !good; }
/* 1 when the caller should reserve memory. */
static inline int32_t cni_snapshot_reserves(const cni_snapshot *s) { return s->mode == CNI_SNAPSHOT_RESERVE && !s->failed; }

#endif
