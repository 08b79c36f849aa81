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
	{ "shapes", scene_shapes, 0xc476881e190c61ee },
	{ "joints", scene_joints, 0x73c985e8d962022b },
	{ "direct", scene_direct, 0x3d6072cace7324fb },
	{ "tiers", scene_tiers, 0x97a72d7148268cca },
	{ "sequential", scene_sequential, 0x37028daf8c29bd86 },
	{ "queries", scene_queries, 0x87ec33d6dbf77bec },
	{ "events", scene_events, 0x0ce924d6540a96ef },
	{ "file", scene_file, 0xa155b0bce9dbcc3f },
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
