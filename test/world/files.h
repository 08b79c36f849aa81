/*
 * test/world/files.h - what tests of written worlds share: bytes in memory of their own, what goes on of a step that does not depend on
 * the broadphase, and a small world with one of everything.
 */
#ifndef CAIRN_TEST_FILES_H
#define CAIRN_TEST_FILES_H

#include "saves.h"

#define SWEEP CN_BROADPHASE_SWEEP
#define TREE CN_BROADPHASE_TREE

static inline saved write_world(const cn_world *world)
{
	saved f = { NULL, 0 };
	uint64_t wrote = 0;
	must(cn_world_write_size(world, &f.bytes), world, "cn_world_write_size");
	f.data = malloc((size_t)f.bytes);
	if (f.data == NULL)
		exit(2);
	memset(f.data, 0xA5, (size_t)f.bytes);
	must(cn_world_write(world, f.data, f.bytes, &wrote), world, "cn_world_write");
	if (wrote != f.bytes)
		test_fail(__FILE__, __LINE__, "cn_world_write writes what cn_world_write_size says");
	return f;
}

static inline int writes_the_same(const cn_world *world, const saved *f)
{
	saved now = write_world(world);
	int same = now.bytes == f->bytes && memcmp(now.data, f->data, (size_t)f->bytes) == 0;
	saved_free(&now);
	return same;
}

static inline cn_world *read_world(const saved *f)
{
	cn_world *world = NULL;
	must(cn_world_read(NULL, f->data, f->bytes, &world), NULL, "cn_world_read");
	return world;
}

/* Into memory as world_of gives it. */
static inline cn_world *read_into(const saved *f, const setting *s, void **out_block)
{
	cn_world_def def;
	cn_world *world = NULL;
	cn_world_def_init(&def);
	def.solver = s->solver;
	def.worker_count = s->workers;
	*out_block = s->in_block ? block_for(&def) : NULL;
	must(cn_world_read(&def, f->data, f->bytes, &world), NULL, "cn_world_read");
	return world;
}

/* All of digest_step except the counters: those of the broadphase are its own. */
static inline uint64_t digest_events(cn_world *world)
{
	const cn_body_moved *moved;
	const cn_joint_event *broken;
	const cn_sensor_event *sensed;
	const cn_body *asleep;
	uint64_t digest = digest_contact_events(digest_world(0, world), world);
	int32_t count;
	must(cn_world_moved(world, &moved, &count), world, "cn_world_moved");
	digest = digest_bytes(digest, moved, (size_t)count * sizeof *moved);
	must(cn_world_joint_events(world, &broken, &count), world, "cn_world_joint_events");
	digest = digest_bytes(digest, broken, (size_t)count * sizeof *broken);
	must(cn_world_sensor_events(world, &sensed, &count), world, "cn_world_sensor_events");
	digest = digest_bytes(digest, sensed, (size_t)count * sizeof *sensed);
	must(cn_world_fell_asleep(world, &asleep, &count), world, "cn_world_fell_asleep");
	return digest_bytes(digest, asleep, (size_t)count * sizeof *asleep);
}

#endif
