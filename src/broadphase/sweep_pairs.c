/*
 * broadphase/sweep_pairs.c - finds the pairs whose boxes overlap now and did not at the last
 * update.
 *
 * Reads proxies and settled tiles; writes the pair list and, for the running pass only, the marks
 * `touched`, `dense` and `previous` of tiles. No set of pairs is stored: the boxes of the last update tell whether a pair
 * existed.
 *
 * A tile is dense when many of its entries moved: its old boxes are gathered into scratch rows beside the present ones.
 * Other tiles need none: an unmoved entry's old box equals its present one.
 * Each pair is found exactly once:
 *
 *   both in dense tiles      by a sweep of the tile with itself, or of the two tiles; the tile of the finer level sweeps,
 *                            or of one level the tile with the lower number
 *   dense tile, unmoved      by a sweep of the dense tile with the other tile, whose moved entries are skipped
 *   moved in a tile that     by a search of that single entry in all tiles; of two such entries, the search of the
 *   is not dense             one with the lower id
 *   loose (no memory)        by a slow search of the loose proxy
 *
 * Workers may share the first three kinds, job by job: a job is a dense tile or a single entry. Each job writes its pairs
 * to its own range of scratch; they are added to the list afterwards in the order of the jobs, so that the list and its
 * order, and the pairs lost when memory runs out, are the same as with one thread. A job that finds more pairs than its
 * range holds is run again by one thread, into the list.
 */
#include "broadphase/sweep.h"

#include <string.h>

#define RANGE_LEAST 128    /* entries, some ten microseconds */
#define SHARED_LEAST 1024  /* entries for which it pays to wake others */
#define SINGLE_ENTRIES 8   /* what one that searches for itself counts for */
#define PAIRS_AN_ENTRY 4   /* room; a crowd in its first step has fewer */

/* ---- moved proxies ---- */

static void count_moved(cni_sweep_pass *pass)
{
	cni_sweep_walk walk = cni_sweep_walk_bits(pass->sweep, &pass->sweep->moved, pass->sweep->moved_count);
	int32_t id;
	while ((id = cni_sweep_walk_next(&walk)) != CNI_NONE) {
		int32_t cell = cni_sweep_proxy(pass->sweep, id)->cell;
		if (cell == CNI_NONE)
			continue;
		++pass->single_count;
		if (cni_sweep_tile_at(pass->sweep, cell)->touched++ == 0 && pass->touched != NULL)
			pass->touched[pass->touched_count++] = cell;
	}
}

/* 1 when all old boxes are empty, as in the first step: they need not be gathered. */
static int32_t all_are_new(const cni_sweep *sweep, const cni_sweep_tile *tile)
{
	const int32_t *ids = cni_sweep_rows_of(sweep, tile).id;
	int32_t k = 0;
	while (k < tile->count && !(cni_sweep_proxy(sweep, ids[k])->old.x0 <= cni_sweep_proxy(sweep, ids[k])->old.x1))
		++k;
	return k == tile->count;
}

/* Marks dense tiles and moves them to the front of `touched`. */
static void choose_dense(cni_sweep_pass *pass)
{
	for (int32_t i = 0; i < pass->touched_count; ++i) {
		int32_t index = pass->touched[i];
		cni_sweep_tile *tile = cni_sweep_tile_at(pass->sweep, index);
		if (!cni_sweep_many_touched(tile))
			continue;
		tile->dense = 1;
		tile->previous = CNI_NONE;
		pass->single_count -= tile->touched;
		if (all_are_new(pass->sweep, tile)) {
			pass->new_entries = cni_max_i(pass->new_entries, (tile->capacity + CNI_SWEEP_LANES - 1) & ~(CNI_SWEEP_LANES - 1));
		} else {
			tile->previous = 4 * pass->dense_entries;
			pass->dense_entries += tile->capacity;
		}
		pass->touched[i] = pass->touched[pass->dense_count];
		pass->touched[pass->dense_count++] = index;
	}
}

static void forget_dense(cni_sweep_pass *pass)
{
	for (int32_t i = 0; i < pass->dense_count; ++i) {
		cni_sweep_tile *tile = cni_sweep_tile_at(pass->sweep, pass->touched[i]);
		tile->dense = 0;
		pass->single_count += tile->touched;
	}
	pass->dense_count = 0;
}

/* Gathers the old boxes of a dense tile into scratch. */
static void gather_previous(const cni_sweep_pass *pass, int32_t dense)
{
	const cni_sweep_tile *tile = cni_sweep_tile_at(pass->sweep, pass->touched[dense]);
	cni_sweep_rows rows = cni_sweep_rows_of(pass->sweep, tile), olds = cni_sweep_old_boxes(pass, tile);
	if (tile->previous == CNI_NONE)
		return;
	for (int32_t k = 0; k < tile->count; ++k)
		cni_sweep_box_set(&olds, k, &cni_sweep_proxy(pass->sweep, rows.id[k])->old);
}

/* Takes scratch for old boxes; without it there are no dense tiles. */
static void open_dense(cni_sweep_pass *pass)
{
	uint64_t floats = 4 * (uint64_t)pass->dense_entries + 2 * (uint64_t)pass->new_entries;
	pass->scratch = (float *)cni_arena_push(pass->sweep->context.arena, sizeof(float) * floats);
	if (pass->scratch == NULL)
		forget_dense(pass);
	for (int32_t i = 0; i < pass->new_entries && pass->scratch != NULL; ++i) {
		pass->scratch[i] = INFINITY;
		pass->scratch[pass->new_entries + i] = -INFINITY;
	}
}

/* The next moved entry that is not in a dense tile. There must be one. */
static int32_t next_single(const cni_sweep_pass *pass, cni_sweep_walk *walk)
{
	for (;;) {
		int32_t id = cni_sweep_walk_next(walk), cell = cni_sweep_proxy(pass->sweep, id)->cell;
		if (cell != CNI_NONE && !cni_sweep_tile_at(pass->sweep, cell)->dense)
			return id;
	}
}

static void search_entries(cni_sweep_pass *pass)
{
	cni_sweep_walk walk = cni_sweep_walk_bits(pass->sweep, &pass->sweep->moved, pass->sweep->moved_count);
	for (int32_t k = 0; k < pass->single_count; ++k)
		cni_sweep_search_entry(pass, next_single(pass, &walk));
}

static void find_alone(cni_sweep_pass *pass)
{
	for (int32_t i = 0; i < pass->dense_count; ++i)
		gather_previous(pass, i);
	for (int32_t i = 0; i < pass->dense_count; ++i)
		cni_sweep_search_tile(pass, pass->touched[i]);
	search_entries(pass);
}

/* ---- the same with workers ---- */

/* Jobs: the dense tiles, then the single entries. */
typedef struct pair_loop {
	const cni_sweep_pass *pass;
	int32_t job_count;
	int32_t *begins;  /* job_count + 1 prefix sums of the jobs' entries: job k writes to slots from PAIRS_AN_ENTRY * begins[k] on */
	int32_t *found;   /* pairs found by each job */
	int32_t *singles; /* ids of the single entries */
	cni_pair *slots;  /* PAIRS_AN_ENTRY per entry */
} pair_loop;

/* The job's range of slots; returns its capacity. */
static int32_t job_room(const pair_loop *loop, int32_t job, cni_pair **slots)
{
	*slots = loop->slots + (int64_t)PAIRS_AN_ENTRY * loop->begins[job];
	return PAIRS_AN_ENTRY * (loop->begins[job + 1] - loop->begins[job]);
}

static void job_run(const pair_loop *loop, int32_t job, cni_sweep_pass *pass)
{
	if (job < pass->dense_count)
		cni_sweep_search_tile(pass, pass->touched[job]);
	else
		cni_sweep_search_entry(pass, loop->singles[job - pass->dense_count]);
}

/* The first job that begins at or after an entry. */
static int32_t first_job_at(const pair_loop *loop, int32_t entry)
{
	int32_t low = 0, count = loop->job_count;
	while (low < count) {
		int32_t middle = (low + count) / 2;
		if (loop->begins[middle] < entry)
			low = middle + 1;
		else
			count = middle;
	}
	return low;
}

static void gather_range(void *context, int32_t begin, int32_t end)
{
	const pair_loop *loop = (const pair_loop *)context;
	int32_t job = first_job_at(loop, begin);
	for (; job < loop->pass->dense_count && loop->begins[job] < end; ++job)
		gather_previous(loop->pass, job);
}

static void find_range(void *context, int32_t begin, int32_t end)
{
	const pair_loop *loop = (const pair_loop *)context;
	cni_sweep_pass own = *loop->pass;
	int32_t job = first_job_at(loop, begin);
	for (; job < loop->job_count && loop->begins[job] < end; ++job) {
		own.slot_room = job_room(loop, job, &own.slots);
		own.slot_count = 0;
		job_run(loop, job, &own);
		loop->found[job] = own.slot_count;
	}
}

static void find_lead(void *context)
{
	pair_loop *loop = (pair_loop *)context;
	cni_team *team = cni_sweep_team(loop->pass->sweep);
	int32_t entries = loop->begins[loop->job_count];
	cni_team_for(team, entries, RANGE_LEAST, gather_range, loop);
	cni_team_for(team, entries, RANGE_LEAST, find_range, loop);
}

/* Adds the jobs' pairs to the list, in the order of the jobs. */
static void jobs_list(const pair_loop *loop, cni_sweep_pass *pass)
{
	for (int32_t job = 0; job < loop->job_count; ++job) {
		cni_pair *slots;
		if (loop->found[job] > job_room(loop, job, &slots)) {
			job_run(loop, job, pass);
			continue;
		}
		for (int32_t k = 0; k < loop->found[job]; ++k)
			cni_sweep_pair_list(pass, slots[k].a, slots[k].b);
	}
}

static void jobs_fill(const pair_loop *loop, const cni_sweep_pass *pass)
{
	cni_sweep_walk walk = cni_sweep_walk_bits(pass->sweep, &pass->sweep->moved, pass->sweep->moved_count);
	int32_t job, entries = 0;
	for (job = 0; job < loop->job_count; ++job) {
		loop->begins[job] = entries;
		entries += job < pass->dense_count ? cni_sweep_tile_at(pass->sweep, pass->touched[job])->count : SINGLE_ENTRIES;
		if (job >= pass->dense_count)
			loop->singles[job - pass->dense_count] = next_single(pass, &walk);
	}
	loop->begins[job] = entries;
}

static int32_t entries_to_do(const cni_sweep_pass *pass)
{
	int32_t entries = SINGLE_ENTRIES * pass->single_count;
	for (int32_t i = 0; i < pass->dense_count; ++i)
		entries += cni_sweep_tile_at(pass->sweep, pass->touched[i])->count;
	return entries;
}

/* Takes scratch for jobs with this total of entries; 0 when there is no memory. */
static int32_t jobs_open(pair_loop *loop, cni_sweep_pass *pass, int32_t entries)
{
	uint64_t jobs = (uint64_t)pass->dense_count + (uint64_t)pass->single_count;
	uint64_t numbers = 2u * jobs + 1u + (uint64_t)pass->single_count, slots = PAIRS_AN_ENTRY * (uint64_t)entries;
	loop->slots = (cni_pair *)cni_arena_push(pass->sweep->context.arena, sizeof(cni_pair) * slots + sizeof(int32_t) * numbers);
	if (loop->slots == NULL)
		return 0;
	loop->pass = pass;
	loop->job_count = (int32_t)jobs;
	loop->begins = (int32_t *)(void *)(loop->slots + slots);
	loop->found = loop->begins + jobs + 1;
	loop->singles = loop->found + jobs;
	jobs_fill(loop, pass);
	return 1;
}

/* Searches with the team. Returns 0, having done nothing, when there is too little work or no memory. */
static int32_t find_shared(cni_sweep_pass *pass)
{
	cni_team *team = cni_sweep_team(pass->sweep);
	int32_t entries = team == NULL ? 0 : entries_to_do(pass);
	pair_loop loop;
	if (entries < SHARED_LEAST || !jobs_open(&loop, pass, entries))
		return 0;
	cni_team_run(team, find_lead, &loop);
	jobs_list(&loop, pass);
	(void)cni_arena_pop(pass->sweep->context.arena, loop.slots);
	return 1;
}

/* Clears the marks of the pass; no tile has moved in the array since they were set. */
static void clear_marks(const cni_sweep_pass *pass)
{
	int32_t count = pass->touched != NULL ? pass->touched_count : pass->sweep->tiles.count;
	for (int32_t i = 0; i < count; ++i) {
		cni_sweep_tile *tile = cni_sweep_tile_at(pass->sweep, pass->touched != NULL ? pass->touched[i] : i);
		tile->touched = 0;
		tile->dense = 0;
	}
}

void cni_sweep_find_pairs(cni_sweep *sweep, cni_pair_filter_fn *filter, const void *filter_context, cni_broadphase_pairs *out)
{
	int32_t touched = cni_min_i(sweep->moved_count, sweep->tile_count);
	cni_sweep_pass pass = { sweep, filter, filter_context, out, cni_sweep_find_new_choose(), NULL, 0, 0, 0, 0, 0, 0, 0, NULL, NULL };
	pass.touched = (int32_t *)cni_arena_push(sweep->context.arena, sizeof(int32_t) * (uint64_t)touched);
	count_moved(&pass);
	choose_dense(&pass);
	open_dense(&pass);
	if (out->mode != CNI_PAIRS_MODE_LIST || !find_shared(&pass))
		find_alone(&pass);
	cni_sweep_search_loose(&pass);
	clear_marks(&pass);
	(void)cni_arena_pop(sweep->context.arena, pass.scratch);
	(void)cni_arena_pop(sweep->context.arena, pass.touched);
}
