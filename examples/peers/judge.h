/*
 * examples/peers/judge.h - one ruler for all engines. A judge is a Cairn world in which nothing moves: it
 * holds the same bodies, shapes and joints as the engine that is timed, is given that engine's poses now and
 * then, and says how deep shapes overlap and how far joints are open. So no engine measures itself, and
 * what an engine holds to be its own error (a slop, a cached manifold) does not matter.
 */
#ifndef CAIRN_PEERS_JUDGE_H
#define CAIRN_PEERS_JUDGE_H

#include "measure/measure.h"
#include "peers/engine.h"

/* world is one of peer_engine_cairn's. 0: the pose is not a place (NaN, or a million metres away). */
int32_t peer_judge_place(void *world, peer_handle body, const peer_pose *pose);
/* Keeps the largest values. */
void peer_judge_errors(void *world, measure_worst *worst);

#endif
