/*
 * examples/record/record.h - recording a world: what it is at the beginning, every call that changes it, and from time to time what it has
 * become, so that a replay finds the first difference. A bug report becomes one file.
 *
 *     #include "../bindings/record/cairn_record.h"      in the game, instead of cairn.h: its calls are recorded
 *     #include "record/record.h"
 *
 *     record_begin(world, NULL, record_to_file, file);
 *     ... the game ...                                  record/player.h reads what record_to_file has written
 *     record_end(world);
 *
 * A call is written before it is made and its result afterwards, so that a recording that ends in a crash ends with the call that
 * crashed. Calls from callbacks, which the library refuses, are not recorded. Worlds of one thread only: the list of recorded worlds is
 * not locked. User callbacks are not recorded: a replay of a game whose callbacks change the motion differs.
 *
 * A recording is a header of 8 bytes, "CairnRec", and records: kind (1), bytes (8), then
 *
 *   KEY      step (8), a written world (cn_world_write)
 *   CALL     index of its name (2), arguments (record/coding.h)
 *   RESULT   code (4), handles
 *   CHECK    step (8), hash (8), bodies (4), for each: handle, x, y, cosine, sine, velocity (3), awake: 9 words
 *   JUMP     step (8): the world was restored from a save; the KEY that follows is its state
 *   NAMES    count (2), for each function its name's length (1) and letters: so another version finds its calls
 */
#ifndef CAIRN_EXAMPLES_RECORD_H
#define CAIRN_EXAMPLES_RECORD_H

#include "record/coding.h"

#include <stdio.h>

enum { RECORD_KEY = 1, RECORD_CALL, RECORD_RESULT, RECORD_CHECK, RECORD_NAMES, RECORD_JUMP };
#define RECORD_BODY_WORDS 9

typedef void record_sink(const void *bytes, uint64_t count, void *user);

typedef struct record_options {
	int32_t check_steps; /* steps between checks; default 30 */
	int32_t key_steps;   /* ... between written worlds, where a seek may begin; default 600 */
} record_options;

/* Begins: writes the world. options NULL: defaults. 0: no memory, or too many worlds. */
int32_t record_begin(cn_world *world, const record_options *options, record_sink *sink, void *user);
/* Ends with a check. Of a world that is not recorded: nothing. */
void record_end(cn_world *world);
/* user is a FILE. */
void record_to_file(const void *bytes, uint64_t count, void *user);
/* user is a coding_out. */
void record_to_memory(const void *bytes, uint64_t count, void *user);

/* Makes a call of the table, and records it if the world is recorded. */
cn_result record_call(cn_world *world, int32_t call, call_value *v);
/* The bytes of a check. */
void record_put_check(coding_out *out, const cn_world *world, uint64_t step);

#endif
