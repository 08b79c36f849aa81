/*
 * test/schedule/team.h - the simulated team: what a program chooses, and the clock by which cn_profile measures.
 */
#ifndef CAIRN_TEST_SCHEDULE_TEAM_H
#define CAIRN_TEST_SCHEDULE_TEAM_H

#include <stdint.h>

typedef enum schedule_mode {
	SCHEDULE_OFF,    /* a shared loop is one call; nothing is measured */
	SCHEDULE_SHARED, /* a shared loop takes as long as its last worker */
	SCHEDULE_SERIAL  /* shared loops take no time: the clock shows what stays serial */
} schedule_mode;

typedef struct schedule_choice {
	schedule_mode mode;
	double line_ns; /* from a write of one core until another has the cache line */
} schedule_choice;

extern schedule_choice schedule;

#endif
