/*
 * test/save/saves.h - what tests of saving and restoring share: saves in memory of their own, scenes in worlds of every kind, and
 * what a player or a game sees of a step as one number.
 */
#ifndef CAIRN_TEST_SAVES_H
#define CAIRN_TEST_SAVES_H

#include "world/workers.h"

#include "scenes/scenes.h"

typedef struct saved {
	void *data;
	uint64_t bytes;
} saved;

static inline saved save_world(const cn_world *world)
{
	saved s = { NULL, 0 };
	uint64_t wrote = 0;
	must(cn_world_save_size(world, &s.bytes), world, "cn_world_save_size");
	s.data = malloc((size_t)s.bytes);
	if (s.data == NULL)
		exit(2);
	memset(s.data, 0xA5, (size_t)s.bytes);
	must(cn_world_save(world, s.data, s.bytes, &wrote), world, "cn_world_save");
	if (wrote != s.bytes)
		test_fail(__FILE__, __LINE__, "cn_world_save writes what cn_world_save_size says");
	return s;
}

static inline void restore_world(cn_world *world, const saved *s)
{
	must(cn_world_restore(world, s->data, s->bytes), world, "cn_world_restore");
}

static inline void saved_free(saved *s)
{
	free(s->data);
	s->data = NULL;
}

/* Does the world save to these very bytes? Frees nothing. */
static inline int saves_the_same(const cn_world *world, const saved *s)
{
	saved now = save_world(world);
	int same = now.bytes == s->bytes && memcmp(now.data, s->data, (size_t)s->bytes) == 0;
	saved_free(&now);
	return same;
}

/* ---- worlds ---- */

typedef struct setting {
	int32_t solver, broadphase, workers, in_block;
} setting;

#define BLOCK_BODIES 700

/* Gives the definition a block with room for a scene; returns what is to be freed. */
static inline void *block_for(cn_world_def *def)
{
	void *block;
	def->body_capacity = BLOCK_BODIES;
	def->shape_capacity = 2 * BLOCK_BODIES;
	def->contact_capacity = 16 * BLOCK_BODIES;
	def->joint_capacity = BLOCK_BODIES;
	must(cn_world_bytes_needed(def, &def->memory_bytes), NULL, "cn_world_bytes_needed");
	block = malloc((size_t)def->memory_bytes + 64);
	if (block == NULL)
		exit(2);
	def->memory = (uint8_t *)block + (64 - (uintptr_t)block % 64);
	return block;
}

static inline cn_world *world_of(const scene *which, const setting *s, void **out_block)
{
	cn_world_def def;
	cn_world *world = NULL;
	scene_world_def(which, &def);
	def.solver = s->solver;
	def.broadphase = s->broadphase;
	def.worker_count = s->workers > 0 ? s->workers : 1;
	*out_block = s->in_block ? block_for(&def) : NULL;
	must(cn_world_create(&def, &world), NULL, "cn_world_create");
	return world;
}

/* ---- what is seen of a step ---- */

static inline uint64_t digest_contact_events(uint64_t digest, cn_world *world)
{
	const cn_contact_event *events;
	int32_t kind, count, k;
	for (kind = 0; kind < CN_EVENT_KINDS; ++kind) {
		must(cn_world_contact_events(world, kind, &events, &count), world, "cn_world_contact_events");
		for (k = 0; k < count; ++k)
			digest = digest_bytes(digest, &events[k], sizeof events[k]);
	}
	return digest;
}

/* Events, what moved, what fell asleep, counters. */
static inline uint64_t digest_step(uint64_t digest, cn_world *world)
{
	const cn_body_moved *moved;
	const cn_joint_event *broken;
	const cn_sensor_event *sensed;
	const cn_body *asleep;
	cn_counters counters = fixture_counters(world);
	int32_t count;
	digest = digest_contact_events(digest_world(digest, world), world);
	must(cn_world_moved(world, &moved, &count), world, "cn_world_moved");
	digest = digest_bytes(digest, moved, (size_t)count * sizeof *moved);
	must(cn_world_joint_events(world, &broken, &count), world, "cn_world_joint_events");
	digest = digest_bytes(digest, broken, (size_t)count * sizeof *broken);
	must(cn_world_sensor_events(world, &sensed, &count), world, "cn_world_sensor_events");
	digest = digest_bytes(digest, sensed, (size_t)count * sizeof *sensed);
	must(cn_world_fell_asleep(world, &asleep, &count), world, "cn_world_fell_asleep");
	digest = digest_bytes(digest, asleep, (size_t)count * sizeof *asleep);
	return digest_bytes(digest, &counters, sizeof counters);
}

static inline void scene_must(const scene_run *run)
{
	if (run->result == CN_OK)
		return;
	printf("  scene %s, step %d: %s\n", run->scene->name, (int)run->step_index, run->error_text);
	exit(2);
}

static inline void scene_steps(scene_run *run, int32_t steps)
{
	int32_t k;
	for (k = 0; k < steps; ++k)
		scene_step(run);
	scene_must(run);
}

#endif
