/*
 * test/base/allocator_time_test.c - what the library's allocators cost beside malloc: times are printed, none is bounded.
 *
 * Traces are lists of operations: take so many bytes into a slot, or give a slot back. One is recorded from the memory
 * hooks of a world that runs the scene "rain" for 300 steps; one is made of the sizes that the block allocator serves
 * (names, geometry, lists of tiles) in random order; frames push scratch and pop it in reverse. The same trace is
 * replayed by cni_blocks or cni_arena and by malloc. Every piece carries its slot's number while it lives: what is
 * checked is that no two pieces overlap.
 *
 * If a test here fails, look first in: base/blocks.c, base/arena.c.
 */
#include "hooks.h"

#include "base/arena.h"
#include "base/blocks.h"
#include "base/clock.h"
#include "scenes/scenes.h"

#include "../test.h"

enum { SLOTS = 65536, OPERATIONS = 100000, REPEATS = 3 };

typedef struct operation {
	uint32_t slot;
	uint32_t bytes; /* 0: give the slot back */
} operation;

typedef struct trace {
	operation *list;
	int32_t count;
	int32_t failed; /* the recorder ran out of room */
	void *pointers[SLOTS];
	uint32_t bytes[SLOTS];
	uint32_t slot_next; /* where the search for a free slot begins */
} trace;

static trace the_trace;

static void trace_begin(trace *t)
{
	memset(t, 0, sizeof *t);
	t->list = malloc(OPERATIONS * sizeof *t->list);
	t->failed = t->list == NULL;
}

static void trace_note(trace *t, uint32_t slot, uint64_t bytes)
{
	if (t->failed || t->count == OPERATIONS || bytes > 0xFFFFFFFFu) {
		t->failed = 1;
		return;
	}
	t->list[t->count].slot = slot;
	t->list[t->count++].bytes = (uint32_t)bytes;
	t->bytes[slot] = (uint32_t)bytes;
}

/* ---- a recorder between a world and malloc ---- */

static void *record_alloc(uint64_t bytes, uint32_t align, void *user)
{
	trace *t = user;
	uint8_t *raw = malloc((size_t)bytes + align + sizeof raw), *aligned;
	uint32_t k;
	if (raw == NULL)
		return NULL;
	aligned = raw + sizeof raw;
	aligned += align - (uintptr_t)aligned % align;
	memcpy(aligned - sizeof raw, &raw, sizeof raw);
	for (k = 0; k < SLOTS; ++k) {
		uint32_t slot = (t->slot_next + k) % SLOTS;
		if (t->pointers[slot] == NULL) {
			t->pointers[slot] = aligned;
			t->slot_next = slot + 1;
			trace_note(t, slot, bytes);
			return aligned;
		}
	}
	t->failed = 1;
	return aligned;
}

static void record_free(void *memory, uint64_t bytes, void *user)
{
	trace *t = user;
	uint8_t *raw;
	uint32_t slot;
	(void)bytes;
	for (slot = 0; slot < SLOTS && t->pointers[slot] != memory; ++slot)
		;
	if (slot < SLOTS) {
		t->pointers[slot] = NULL;
		trace_note(t, slot, 0);
	}
	memcpy(&raw, (uint8_t *)memory - sizeof raw, sizeof raw);
	free(raw);
}

/* ---- replays: ns in all, pieces found damaged ---- */

static uint64_t replay_blocks(const trace *t, int32_t *out_damaged)
{
	static cni_ref refs[SLOTS];
	static uint32_t bytes[SLOTS];
	cni_memory memory;
	cni_blocks blocks;
	uint64_t begin;
	int32_t k, damaged = 0;
	cni_memory_init_hooks(&memory, NULL, NULL, NULL);
	cni_blocks_init(&blocks, &memory);
	begin = cni_clock_ns();
	for (k = 0; k < t->count; ++k) {
		uint32_t slot = t->list[k].slot, *tag;
		if (t->list[k].bytes != 0) {
			bytes[slot] = t->list[k].bytes;
			refs[slot] = cni_blocks_alloc(&blocks, bytes[slot]);
			if (refs[slot] == 0) {
				++damaged;
				break;
			}
			tag = cni_blocks_at(&blocks, refs[slot]);
			*tag = slot;
		} else {
			tag = cni_blocks_at(&blocks, refs[slot]);
			damaged += *tag != slot;
			cni_blocks_free(&blocks, refs[slot], bytes[slot]);
		}
	}
	begin = cni_clock_ns() - begin;
	cni_blocks_deinit(&blocks);
	*out_damaged += damaged;
	return begin;
}

static uint64_t replay_malloc(const trace *t, int32_t *out_damaged)
{
	static uint32_t *pieces[SLOTS];
	uint64_t begin;
	int32_t k, damaged = 0;
	memset(pieces, 0, sizeof pieces);
	begin = cni_clock_ns();
	for (k = 0; k < t->count; ++k) {
		uint32_t slot = t->list[k].slot;
		if (t->list[k].bytes != 0) {
			pieces[slot] = malloc(t->list[k].bytes);
			if (pieces[slot] == NULL) {
				++damaged;
				break;
			}
			*pieces[slot] = slot;
		} else {
			damaged += *pieces[slot] != slot;
			free(pieces[slot]);
			pieces[slot] = NULL;
		}
	}
	begin = cni_clock_ns() - begin;
	for (k = 0; k < SLOTS; ++k)
		free(pieces[k]);
	*out_damaged += damaged;
	return begin;
}

/* The fastest of some runs: what disturbs only ever adds. */
static void compare(const trace *t, const char *name)
{
	uint64_t best_blocks = UINT64_MAX, best_malloc = UINT64_MAX;
	int32_t run, damaged = 0;
	for (run = 0; run < REPEATS; ++run) {
		uint64_t ns = replay_blocks(t, &damaged);
		best_blocks = ns < best_blocks ? ns : best_blocks;
		ns = replay_malloc(t, &damaged);
		best_malloc = ns < best_malloc ? ns : best_malloc;
	}
	printf("  %s: %d operations, blocks %.1f ns, malloc %.1f ns an operation\n", name, (int)t->count,
	       (double)best_blocks / (double)t->count, (double)best_malloc / (double)t->count);
	CHECK_LE("pieces damaged or missing", damaged, 0, "");
}

/* ---- traces ---- */

static void trace_of_a_world(void)
{
	scene_run run;
	cn_world_def def;
	int32_t step, small = 0, k;
	const scene *rain = scene_find("rain");
	REQUIRE(rain != NULL);
	trace_begin(&the_trace);
	scene_world_def(rain, &def);
	def.alloc = record_alloc;
	def.free = record_free;
	def.allocator_user = &the_trace;
	REQUIRE(scene_open(&run, rain, &def) == CN_OK);
	for (step = 0; step < 300; ++step)
		REQUIRE(scene_step(&run) == CN_OK);
	scene_close(&run);
	for (k = 0; k < the_trace.count; ++k)
		small += the_trace.list[k].bytes > 0 && the_trace.list[k].bytes <= CNI_BLOCK_LARGEST;
	CHECK(!the_trace.failed && the_trace.count > 0);
	printf("  300 steps of rain asked the allocator below %d times and gave back as often; %d pieces fit a size class\n", (int)the_trace.count / 2, (int)small);
	compare(&the_trace, "rain's arrays");
	free(the_trace.list);
}

static void trace_of_small_pieces(void)
{
	/* Names, circles, capsules and boxes, polygons, short chains, lists of a tile that grow by doubling. */
	static const uint32_t sizes[] = { 12, 24, 33, 56, 48, 64, 64, 96, 96, 128, 160, 192, 256, 512, 1024, 2048 };
	static const int32_t live_most[] = { 100, 1000, 10000, 60000 };
	int32_t i, k;
	for (i = 0; i < 4; ++i) {
		char name[40];
		uint32_t state = 2463534242u;
		trace_begin(&the_trace);
		REQUIRE(!the_trace.failed);
		for (k = 0; k < OPERATIONS; ++k) {
			uint32_t slot = random_next(&state) % (uint32_t)live_most[i];
			uint32_t size = sizes[random_next(&state) >> 8 & 15u];
			trace_note(&the_trace, slot, the_trace.bytes[slot] != 0 ? 0 : size);
		}
		CHECK(!the_trace.failed);
		snprintf(name, sizeof name, "small pieces, about %d alive", (int)live_most[i] / 2);
		compare(&the_trace, name);
		free(the_trace.list);
	}
}

/* ---- frames ---- */

enum { FRAMES = 1000, PUSHES = 12 };

static uint64_t frames_arena(const uint32_t *sizes, int32_t *out_damaged)
{
	cni_memory memory;
	static cni_arena arena;
	void *pushed[PUSHES];
	uint64_t begin;
	int32_t frame, k;
	cni_memory_init_hooks(&memory, NULL, NULL, NULL);
	cni_arena_init(&arena, &memory);
	begin = cni_clock_ns();
	for (frame = 0; frame < FRAMES; ++frame) {
		for (k = 0; k < PUSHES; ++k) {
			pushed[k] = cni_arena_push(&arena, sizes[(frame + k) & 31]);
			*(int32_t *)pushed[k] = k;
		}
		for (k = PUSHES; k-- > 0;) {
			*out_damaged += *(int32_t *)pushed[k] != k;
			cni_arena_pop(&arena, pushed[k]);
		}
		cni_arena_reset(&arena);
	}
	begin = cni_clock_ns() - begin;
	cni_arena_deinit(&arena);
	return begin;
}

static uint64_t frames_malloc(const uint32_t *sizes, int32_t *out_damaged)
{
	int32_t *pushed[PUSHES];
	uint64_t begin = cni_clock_ns();
	int32_t frame, k;
	for (frame = 0; frame < FRAMES; ++frame) {
		for (k = 0; k < PUSHES; ++k) {
			pushed[k] = malloc(sizes[(frame + k) & 31]);
			if (pushed[k] != NULL)
				*pushed[k] = k;
		}
		for (k = PUSHES; k-- > 0;) {
			*out_damaged += pushed[k] == NULL || *pushed[k] != k;
			free(pushed[k]);
		}
	}
	return cni_clock_ns() - begin;
}

static void frames_of_scratch(void)
{
	static const uint32_t largest[] = { 1024, 65536, 1048576 };
	static const double operations = 2.0 * (double)FRAMES * (double)PUSHES;
	int32_t i, k, run, damaged = 0;
	for (i = 0; i < 3; ++i) {
		uint32_t state = 88675123u, sizes[32];
		uint64_t best_arena = UINT64_MAX, best_malloc = UINT64_MAX;
		for (k = 0; k < 32; ++k)
			sizes[k] = 16 + random_next(&state) % largest[i];
		for (run = 0; run < REPEATS; ++run) {
			uint64_t ns = frames_arena(sizes, &damaged);
			best_arena = ns < best_arena ? ns : best_arena;
			ns = frames_malloc(sizes, &damaged);
			best_malloc = ns < best_malloc ? ns : best_malloc;
		}
		printf("  frames of %d entries up to %u bytes: arena %.1f ns, malloc %.1f ns an operation\n", (int)PUSHES, (unsigned)largest[i],
		       (double)best_arena / operations, (double)best_malloc / operations);
	}
	CHECK_LE("entries damaged or missing", damaged, 0, "");
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(trace_of_a_world);
	RUN(trace_of_small_pieces);
	RUN(frames_of_scratch);
	return test_end();
}
