/*
 * test/arch/scenes.h - eight small worlds with everything that computes: every shape, joint, solver, tier, query, event, and the bytes of a
 * file; a number for each (digest.h), and what every processor, compiler and option must give. They need cairn.h only, so that they also
 * run without an operating system (board.c).
 */
#ifndef CAIRN_TEST_ARCH_SCENES_H
#define CAIRN_TEST_ARCH_SCENES_H

#include "events.h"
#include "motion.h"
#include "queries.h"

typedef struct arch_scene {
	const char *name;
	void (*run)(void);
	uint64_t expected;
} arch_scene;

#define ARCH_SCENES 8
static const arch_scene arch_scenes[ARCH_SCENES] = {
	{ "shapes", scene_shapes, 0x4cbfae011f1d3379 },
	{ "joints", scene_joints, 0xf556e3847e4d26db },
	{ "direct", scene_direct, 0xf6743000c1d47189 },
	{ "tiers", scene_tiers, 0x2726bcc5a63e53d7 },
	{ "sequential", scene_sequential, 0x8420c332fa1de2a4 },
	{ "queries", scene_queries, 0xb79cb4644a093b1c },
	{ "events", scene_events, 0xb0fd62ae431861ac },
	{ "file", scene_file, 0xf37363360846a9b0 },
};

/* The number of a scene; 0 if a call failed: arch_failed_line. */
static uint64_t arch_number(const arch_scene *scene)
{
	arch_failed_line = 0;
	arch_digest = 0xCBF29CE484222325u;
	scene->run();
	return arch_failed_line == 0 ? arch_digest : 0;
}

#endif
