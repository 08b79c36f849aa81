/*
 * examples/record/player.h - plays a recording: the recorded calls again, each result and each check compared with what was recorded.
 *
 *     player p;
 *     if (player_open(&p, NULL, bytes, count)) {
 *         while (player_step(&p)) draw(p.world);
 *         if (p.differs) puts(p.report);
 *     }
 *     player_close(&p);
 *
 * player_seek goes to the last written world at or before a step and plays on from there. Playing through a written world compares and does
 * not read it, so that a difference is not hidden.
 */
#ifndef CAIRN_EXAMPLES_PLAYER_H
#define CAIRN_EXAMPLES_PLAYER_H

#include "record/coding.h"

typedef struct player {
	cn_world *world;
	const uint8_t *bytes;
	uint64_t count;
	uint64_t at;         /* of the next record */
	uint64_t step;       /* taken so far */
	uint64_t step_count; /* steps in the recording */
	int32_t calls;       /* made so far */
	int32_t checks;      /* compared so far */
	int32_t differs;     /* 1: at report_step something was found to differ */
	int32_t broken;      /* 1: the recording ends within a record, or is none */
	uint64_t report_step;
	char report[256];    /* the first difference: body and field, or call */
	const cn_world_def *def;
	int32_t calls_here[256]; /* index here of each function of the recording, -1: unknown */
} player;

/* bytes stay the caller's and must live as long as the player. def: memory and workers, NULL: defaults. 0: no recording. */
int32_t player_open(player *p, const cn_world_def *def, const void *bytes, uint64_t count);
void player_close(player *p);
/* Plays until one more step is taken. 0: the end. */
int32_t player_step(player *p);
/* To the state after so many steps, also back. 0: there is no such step. */
int32_t player_seek(player *p, uint64_t step);

#endif
