/*
 * test/embedded/refused.c - a build without parts (definitions CN_NO_...) refuses what needs them, and says so by the documented code;
 * nothing of it is a default. test/variants.sh compiles it with the definitions of examples/embedded/run.sh, configuration least.
 */
#include "cairn.h"

#include <stdio.h>
#include <string.h>

static int passed, failed;

static void expect(cn_result result, cn_result wanted, const char *what)
{
	if (result == wanted) {
		++passed;
		return;
	}
	printf("%s: result %d instead of %d\n", what, (int)result, (int)wanted);
	++failed;
}

static void expect_true(int holds, const char *what) { expect(holds ? CN_OK : CN_ERROR_STATE, CN_OK, what); }

static void worlds_refuse(cn_world_def def)
{
	cn_world *world;
	expect_true((def.flags & CN_WORLD_CONTINUOUS) == 0, "continuous collision is no default");
	def.flags |= CN_WORLD_CONTINUOUS;
	expect(cn_world_create(&def, &world), CN_ERROR_ARGUMENT, "continuous collision");
	cn_world_def_init(&def);
	def.solver = CN_SOLVER_DIRECT;
	expect(cn_world_create(&def, &world), CN_ERROR_ARGUMENT, "direct solver");
	def.solver = CN_SOLVER_SEQUENTIAL;
	expect(cn_world_create(&def, &world), CN_ERROR_ARGUMENT, "sequential solver");
}

static void shapes_refuse(cn_world *world, cn_body body)
{
	const cn_circle circle = { { 0.0f, 0.0f }, 0.5f };
	const cn_vec2 corners[3] = { { 0.0f, 0.0f }, { 1.0f, 0.0f }, { 2.0f, 0.0f } };
	cn_shape_def def;
	cn_chain chain;
	cn_shape_def_init(&def);
	def.body = body;
	expect_true(def.event_mask == 0, "events are no default");
	expect(cn_shape_create_circle(world, &def, &circle, NULL), CN_ERROR_STATE, "circle");
	expect_true(strlen(cn_world_error_text(world)) == 0, "a sentence in a build without messages");
	memset(&chain, 0, sizeof chain);
	chain.points_m = corners;
	chain.count = 3;
	expect(cn_shape_create_chain(world, &def, &chain, NULL), CN_ERROR_STATE, "chain");
	def.event_mask = 1u << CN_EVENT_ENTER;
	expect(cn_shape_create_box(world, &def, 0.5f, 0.5f, 0.0f, NULL), CN_ERROR_ARGUMENT, "events");
	def.event_mask = 0;
	def.flags = CN_SHAPE_SENSOR;
	expect(cn_shape_create_box(world, &def, 0.5f, 0.5f, 0.0f, NULL), CN_ERROR_ARGUMENT, "sensor");
	def.flags = CN_SHAPE_PRE_SOLVE;
	expect(cn_shape_create_box(world, &def, 0.5f, 0.5f, 0.0f, NULL), CN_ERROR_ARGUMENT, "pre-solve callback");
	def.flags = 0;
	def.material.restitution = 0.5f;
	expect(cn_shape_create_box(world, &def, 0.5f, 0.5f, 0.0f, NULL), CN_ERROR_ARGUMENT, "restitution");
	def.material.restitution = 0.0f;
	expect(cn_shape_create_box(world, &def, 0.5f, 0.5f, 0.0f, NULL), CN_OK, "box");
}

static void joints_refuse(cn_world *world, cn_body a, cn_body b)
{
	cn_revolute_def def;
	cn_joint joint;
	cn_revolute_def_init(&def);
	def.base.body_a = a;
	def.base.body_b = b;
	expect(cn_joint_create_revolute(world, &def, &joint), CN_ERROR_STATE, "joint");
}

int main(void)
{
	static unsigned char block[1 << 20] __attribute__((aligned(64)));
	cn_world_def def;
	cn_body_def body_def;
	cn_world *world;
	cn_body a, b;
	cn_world_def_init(&def);
	worlds_refuse(def);
	cn_world_def_init(&def);
	def.body_capacity = def.shape_capacity = 4;
	def.contact_capacity = 4;
	def.joint_capacity = 1;
	def.memory = block;
	def.memory_bytes = sizeof block;
	expect(cn_world_create(&def, &world), CN_OK, "world in a block");
	if (failed > 0)
		return 1;
	cn_body_def_init(&body_def);
	expect(cn_body_create(world, &body_def, &a), CN_OK, "body");
	expect(cn_body_create(world, &body_def, &b), CN_OK, "body");
	shapes_refuse(world, a);
	joints_refuse(world, a, b);
	printf("%d passed, %d failed, 0 skipped\n", passed, failed);
	return failed != 0;
}
