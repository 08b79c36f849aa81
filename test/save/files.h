/*
 * test/save/files.h - what tests of written worlds share: bytes in memory of their own, what goes on of a step that does not depend on
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
	def.worker_count = s->workers > 0 ? s->workers : 1;
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

/* One of every kind of shape, joints, a sensor that is an area, things that are gone, a name, contacts, after some steps. */
static inline cn_world *zoo_world(void)
{
	cn_world *world = fixture_world(-10.0f, 1);
	cn_vec2 points[4] = { { 6.0f, 0.2f }, { 2.0f, -0.1f }, { -2.0f, 0.0f }, { -6.0f, 0.4f } };
	cn_chain chain = { points, 4, 0 };
	cn_capsule capsule = { { -0.3f, 0.0f }, { 0.3f, 0.1f }, 0.2f };
	cn_edge edge = { { -1.0f, 0.0f }, { 1.0f, 0.0f } };
	cn_revolute_def pin;
	cn_line_constraint_def line;
	cn_shape_def def = fixture_shape_def(fixture_body(world, CN_BODY_STATIC, 0.0f, 0.0f, 0.0f), 0.6f, 0.0f);
	cn_body box, ball, pill, gone;
	cn_shape sensor;
	cn_area_def area;
	cn_joint joint;
	cn_constraint rail;
	must(cn_shape_create_chain(world, &def, &chain, NULL), world, "cn_shape_create_chain");
	def.body = fixture_body(world, CN_BODY_KINEMATIC, 4.0f, 0.5f, 0.1f);
	must(cn_shape_create_edge(world, &def, &edge, NULL), world, "cn_shape_create_edge");
	box = fixture_box(world, CN_BODY_DYNAMIC, 0.0f, 0.6f, 0.1f, 0.5f, 0.4f, 0.6f, 0.0f);
	gone = fixture_box(world, CN_BODY_DYNAMIC, 0.0f, 3.6f, 0.1f, 0.5f, 0.4f, 0.6f, 0.0f);
	ball = fixture_circle(world, CN_BODY_DYNAMIC, 0.2f, 1.6f, 0.4f, 0.6f, 0.3f);
	pill = fixture_body(world, CN_BODY_DYNAMIC, -1.5f, 1.0f, 0.3f);
	def = fixture_shape_def(pill, 0.6f, 0.0f);
	def.material.rolling_resistance = 0.01f;
	must(cn_shape_create_capsule(world, &def, &capsule, NULL), world, "cn_shape_create_capsule");
	def.flags = CN_SHAPE_SENSOR;
	def.body = box;
	must(cn_shape_create_box(world, &def, 0.9f, 0.9f, 0.0f, &sensor), world, "cn_shape_create_box");
	cn_area_def_init(&area);
	area.density_kgpm2 = 0.3f;
	area.drag_kgpm2 = area.lift_kgpm2 = area.angular_damping_per_s = 0.1f;
	area.pull_mps2 = 0.2f;
	must(cn_shape_set_area(world, sensor, &area), world, "cn_shape_set_area");
	cn_revolute_def_init(&pin);
	pin.base.body_a = box;
	pin.base.body_b = pill;
	must(cn_joint_create_revolute(world, &pin, &joint), world, "cn_joint_create_revolute");
	cn_line_constraint_def_init(&line);
	line.body = ball;
	must(cn_constraint_create_line(world, &line, &rail), world, "cn_constraint_create_line");
	must(cn_body_set_name(world, ball, "ball"), world, "cn_body_set_name");
	fixture_step(world, 20);
	must(cn_body_destroy(world, gone), world, "cn_body_destroy");
	fixture_step(world, 5);
	return world;
}

#endif
