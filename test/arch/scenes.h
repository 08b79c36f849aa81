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
	{ "shapes", scene_shapes, 0x3f7d38d5bb1f176e },
	{ "joints", scene_joints, 0x75e2e32bb67b4458 },
	{ "direct", scene_direct, 0x743ce6e29992720b },
	{ "tiers", scene_tiers, 0x953d7f569fe88894 },
	{ "sequential", scene_sequential, 0x08c4cf8f2876c0a2 },
	{ "queries", scene_queries, 0x31daf40cc57fdb5f },
	{ "events", scene_events, 0x5f507a070c112fa6 },
	{ "file", scene_file, 0xcdafdf00117cee1a },
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
