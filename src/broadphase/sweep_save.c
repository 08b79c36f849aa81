/*
 * broadphase/sweep_save.c - saves and loads the sweep through a snapshot (base/snapshot.h): tiles with their rows, levels,
 * marks and the state of the choice of sizes. Loading rebuilds the table from cells to tiles.
 */
#include "base/snapshot.h"
#include "broadphase/sweep.h"

#include <string.h>

/* Sets of ids: only the words of ids up to id_end are copied, because the number of words depends on the capacity. */
static void bits_pass(cni_snapshot *s, cni_array *bits, int32_t words)
{
	if (s->mode == CNI_SNAPSHOT_LOAD && bits->count > 0)
		memset(bits->data, 0, (size_t)bits->count * sizeof(uint64_t));
	cni_snapshot_state(s, bits->data, (uint64_t)words * sizeof(uint64_t));
}

static void sizes_pass(cni_snapshot *s, cni_sweep *sweep)
{
	cni_snapshot_state(s, &sweep->exponent, sizeof sweep->exponent);
	cni_snapshot_state(s, &sweep->boost, sizeof sweep->boost);
	cni_snapshot_state(s, &sweep->tuned_count, sizeof sweep->tuned_count);
	cni_snapshot_state(s, &sweep->adds, sizeof sweep->adds);
	cni_snapshot_state(s, &sweep->settles, sizeof sweep->settles);
	cni_snapshot_state(s, &sweep->patience, sizeof sweep->patience);
}

static void counts_pass(cni_snapshot *s, cni_sweep *sweep)
{
	cni_snapshot_state(s, &sweep->tile_free, sizeof sweep->tile_free);
	cni_snapshot_state(s, &sweep->id_end, sizeof sweep->id_end);
	cni_snapshot_state(s, &sweep->count, sizeof sweep->count);
	cni_snapshot_state(s, &sweep->moved_count, sizeof sweep->moved_count);
	cni_snapshot_state(s, &sweep->loose_count, sizeof sweep->loose_count);
	cni_snapshot_state(s, &sweep->level_mask, sizeof sweep->level_mask);
	cni_snapshot_state(s, sweep->levels, sizeof sweep->levels);
	cni_snapshot_state(s, &sweep->rows_bytes, sizeof sweep->rows_bytes);
}

/* The caller has reserved the bit sets, after the proxy table has its size. */
void cni_sweep_snapshot(cni_broadphase *broadphase, cni_snapshot *s)
{
	cni_sweep *sweep = (cni_sweep *)(void *)broadphase;
	int32_t words = cni_snapshot_number(s, cni_bit_words(sweep->id_end)), tiles = cni_snapshot_number(s, sweep->tile_count);
	if (cni_snapshot_reserves(s))
		cni_snapshot_need(s, words <= sweep->moved.count && words <= sweep->loose.count && cni_sweep_slots_reserve(sweep, tiles));
	bits_pass(s, &sweep->moved, words);
	bits_pass(s, &sweep->loose, words);
	cni_snapshot_array(s, &sweep->tiles);
	cni_snapshot_blocks(s, &sweep->rows);
	counts_pass(s, sweep);
	sizes_pass(s, sweep);
	if (s->mode == CNI_SNAPSHOT_LOAD) {
		sweep->tile_count = tiles;
		cni_sweep_slots_fill(sweep);
	}
}
