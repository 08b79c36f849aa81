/*
 * test/stability/chart/peer.h - the stability suite with another engine under it.
 *
 * The suite speaks cairn.h. An adapter defines the calls that the suite makes on top of another engine, and is linked
 * with the suite's objects instead of the library: scenes, measurements and clock are the same to the line. A setting
 * that the engine does not have is refused by cn_world_def_check, and the suite counts its cases as skipped.
 *
 * peer.c has what does not depend on the engine; peer_box2d.c, peer_chipmunk.c and peer_rapier.c are the
 * adapters.
 */
#ifndef CAIRN_CHART_PEER_H
#define CAIRN_CHART_PEER_H

#include "cairn.h"

/* Given by each adapter. */
extern const char peer_name[];
extern const int32_t peer_substeps_default;

/* What the engine knows a thing by, under the handle index + 1. */
typedef struct peer_list {
	uint64_t *items;
	int32_t count, capacity;
} peer_list;

/* The new handle. */
uint32_t peer_keep(peer_list *list, uint64_t item);
/* 0 for a handle that is not in the list; nothing that an engine makes is 0. */
uint64_t peer_find(const peer_list *list, uint32_t handle);
/* Keeps the sentence for cn_world_error_text. */
cn_result peer_refuse(const char *sentence);
/* Friction and such are the suite's; where in the body a shape lies must be the origin. */
cn_result peer_check_shape(const cn_shape_def *def);

#endif
