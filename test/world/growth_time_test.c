/*
 * test/world/growth_time_test.c - work that must not grow with what lies beside it: a tile added to a level costs the same
 * whatever the level's size, a shape added to a moving body, removed or changed likewise, a body or joint destroyed in any order, and an edge
 * of a chain that is moved; bodies that sleep cost a step nothing; and a long bridge that is thrown costs little more than one that hangs.
 *
 * Times are printed and have no bounds, as other programs disturb them. test/work.sh runs the functions one by one under
 * valgrind and bounds the instructions they execute.
 *
 * If a test here fails, look first in: model/body_shapes.c (mass of a body of many shapes), step/finalize.c, model/island_sleep.c.
 */
#include "fixture.h"
#include "joints.h"

#include <time.h>

static double cpu_s(void) { return (double)clock() / (double)CLOCKS_PER_SEC; }

static void shuffle(int32_t *order, int32_t count, uint32_t seed)
{
	int32_t k;
	for (k = 0; k < count; ++k)
		order[k] = k;
	for (k = count - 1; k > 0; --k) {
		int32_t other = (int32_t)fixture_random(&seed, 0.0f, (float)k + 0.99f), kept = order[k];
		order[k] = order[other];
		order[other] = kept;
	}
}

/* ---- levels: one static body of many tiles ---- */

#define TILES 8000

/* Every second tile is taken away again. */
static void level(int32_t tiles)
{
	static cn_shape shapes[TILES];
	cn_world *world = fixture_world(-10.0f, 0);
	cn_body body = fixture_body(world, CN_BODY_STATIC, 0.0f, 0.0f, 0.0f);
	double start = cpu_s();
	int32_t k;
	for (k = 0; k < tiles; ++k) {
		cn_shape_def def = fixture_shape_def(body, 0.6f, 0.0f);
		def.offset_m.x = (float)(k % 1000);
		def.offset_m.y = -(float)(k / 1000);
		shapes[k] = fixture_box_shape(world, &def, 0.5f, 0.5f);
	}
	for (k = 0; k < tiles; k += 2)
		must(cn_shape_destroy(world, shapes[k]), world, "cn_shape_destroy");
	printf("  %d tiles: %.3f ms\n", (int)tiles, 1e3 * (cpu_s() - start));
	CHECK(fixture_is_valid(world));
	cn_world_destroy(world);
}

static void level_of_1000_tiles(void) { level(TILES / 8); }
static void level_of_8000_tiles(void) { level(TILES); }

/* ---- a moving body of many shapes ---- */

static void compound(int32_t shapes)
{
	cn_world *world = fixture_world(-10.0f, 0);
	cn_body body = fixture_body(world, CN_BODY_DYNAMIC, 0.0f, 0.0f, 0.0f);
	double start = cpu_s();
	int32_t k;
	for (k = 0; k < shapes; ++k) {
		cn_shape_def def = fixture_shape_def(body, 0.6f, 0.0f);
		def.offset_m.x = (float)(k % 100);
		def.offset_m.y = -(float)(k / 100);
		fixture_box_shape(world, &def, 0.5f, 0.5f);
	}
	printf("  %d shapes added: %.3f ms\n", (int)shapes, 1e3 * (cpu_s() - start));
	cn_world_destroy(world);
}

/* Half of the shapes are changed in a random order, then all are removed in another one; one body sleeps beside. */
static void compound_changed(int32_t shapes)
{
	static cn_shape all[4000];
	static int32_t order[4000];
	cn_world *world = fixture_world(-10.0f, 1);
	cn_body body = fixture_body(world, CN_BODY_DYNAMIC, 0.0f, 0.0f, 0.0f), sleeper = fixture_box(world, CN_BODY_DYNAMIC, -50.0f, 0.0f, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f);
	double start;
	int32_t k;
	for (k = 0; k < shapes; ++k) {
		cn_shape_def def = fixture_shape_def(body, 0.6f, 0.0f);
		def.offset_m = (cn_vec2){ (float)(k % 100), -(float)(k / 100) };
		all[k] = fixture_box_shape(world, &def, 0.5f, 0.5f);
	}
	fixture_step(world, 1);
	must(cn_body_set_awake(world, sleeper, 0), world, "cn_body_set_awake");
	start = cpu_s();
	shuffle(order, shapes, 1u);
	for (k = 0; k < shapes; k += 2) {
		cn_polygon box;
		must(cn_polygon_make_box(0.3f, 0.3f, (float)(order[k] % 100), -(float)(order[k] / 100), 0.0f, 0.0f, &box), NULL, "cn_polygon_make_box");
		must(cn_shape_set_polygon(world, all[order[k]], &box), world, "cn_shape_set_polygon");
		must(cn_shape_set_density(world, all[order[k]], 2.0f), world, "cn_shape_set_density");
	}
	shuffle(order, shapes, 2u);
	for (k = 0; k < shapes; ++k) {
		must(cn_shape_detach(world, all[order[k]]), world, "cn_shape_detach");
		if (k % 2 == 0)
			must(cn_shape_attach(world, all[order[k]], body), world, "cn_shape_attach");
		must(cn_shape_destroy(world, all[order[k]]), world, "cn_shape_destroy");
	}
	printf("  %d shapes changed and removed: %.3f ms\n", (int)shapes, 1e3 * (cpu_s() - start));
	CHECK(fixture_is_valid(world));
	cn_world_destroy(world);
}

static void changed_500_shapes(void) { compound_changed(500); }
static void changed_4000_shapes(void) { compound_changed(4000); }

/* ---- bodies and joints, destroyed in a random order, and everything else of a body that has a setter ---- */

static void body_change(cn_world *world, cn_body body, int32_t k)
{
	cn_pose pose = fixture_pose(world, body);
	must(cn_body_set_pose(world, body, pose.position_m.x, pose.position_m.y + 20.0f, 0.0f), world, "cn_body_set_pose");
	must(cn_body_set_type(world, body, CN_BODY_STATIC), world, "cn_body_set_type");
	must(cn_body_set_type(world, body, k % 2 ? CN_BODY_DYNAMIC : CN_BODY_KINEMATIC), world, "cn_body_set_type");
	must(cn_body_set_name(world, body, "name"), world, "cn_body_set_name");
	must(cn_body_set_awake(world, body, 0), world, "cn_body_set_awake");
	must(cn_body_set_awake(world, body, 1), world, "cn_body_set_awake");
	must(cn_body_set_flags(world, body, CN_BODY_ENABLED | CN_BODY_LOCK_ROTATION), world, "cn_body_set_flags");
}

/* Rows of four boxes on the ground, all hinged in one chain, and every other one to the ground. */
static void bodies_gone(int32_t count)
{
	static cn_body bodies[8000];
	static cn_joint joints[8000];
	static int32_t order[8000];
	cn_world *world = fixture_world(-10.0f, 1);
	cn_body ground = fixture_box(world, CN_BODY_STATIC, 0.0f, -1.0f, 0.0f, 10000.0f, 1.0f, 0.6f, 0.0f);
	double start = cpu_s();
	int32_t k;
	for (k = 0; k < count; ++k) {
		cn_revolute_def def;
		bodies[k] = fixture_box(world, CN_BODY_DYNAMIC, 1.1f * (float)(k / 4), 0.5f + (float)(k % 4), 0.0f, 0.5f, 0.5f, 0.6f, 0.0f);
		cn_revolute_def_init(&def);
		def.base.body_a = k % 2 && k > 0 ? bodies[k - 1] : ground;
		def.base.body_b = bodies[k];
		must(cn_joint_create_revolute(world, &def, &joints[k]), world, "cn_joint_create_revolute");
	}
	fixture_step(world, 1);
	shuffle(order, count, 3u);
	for (k = 0; k < count; k += 2)
		must(cn_joint_destroy(world, joints[order[k]]), world, "cn_joint_destroy");
	for (k = 0; k < count; k += 4)
		body_change(world, bodies[order[k]], k);
	shuffle(order, count, 4u);
	for (k = 0; k < count; ++k)
		must(cn_body_destroy(world, bodies[order[k]]), world, "cn_body_destroy");
	printf("  %d bodies and joints made and destroyed: %.3f ms\n", (int)count, 1e3 * (cpu_s() - start));
	CHECK(fixture_is_valid(world));
	cn_world_destroy(world);
}

static void bodies_gone_1000(void) { bodies_gone(1000); }
static void bodies_gone_8000(void) { bodies_gone(8000); }

/* ---- a chain that is moved ---- */

static void chain_moved(int32_t points, int32_t broadphase)
{
	static cn_vec2 all[48000];
	cn_world_def world_def;
	cn_world *world = NULL;
	cn_shape_def def;
	cn_chain chain;
	cn_body body;
	int32_t k;
	cn_world_def_init(&world_def);
	world_def.broadphase = broadphase;
	must(cn_world_create(&world_def, &world), NULL, "cn_world_create");
	body = fixture_body(world, CN_BODY_STATIC, 0.0f, 0.0f, 0.0f);
	def = fixture_shape_def(body, 0.6f, 0.0f);
	for (k = 0; k < points; ++k)
		all[k] = (cn_vec2){ (float)k, 0.1f * (float)(k % 3) };
	memset(&chain, 0, sizeof chain);
	chain.points_m = all;
	chain.count = points;
	must(cn_shape_create_chain(world, &def, &chain, NULL), world, "cn_shape_create_chain");
	fixture_step(world, 1);
	for (k = 0; k < 3; ++k)
		must(cn_body_set_pose(world, body, 0.3f * (float)k, 0.1f * (float)k, 0.1f * (float)k), world, "cn_body_set_pose");
	fixture_step(world, 1);
	CHECK(fixture_is_valid(world));
	cn_world_destroy(world);
}

static void chain_moved_6000_sweep(void) { chain_moved(6000, CN_BROADPHASE_SWEEP); }
static void chain_moved_48000_sweep(void) { chain_moved(48000, CN_BROADPHASE_SWEEP); }
static void chain_moved_6000_tree(void) { chain_moved(6000, CN_BROADPHASE_TREE); }
static void chain_moved_48000_tree(void) { chain_moved(48000, CN_BROADPHASE_TREE); }

static void compound_of_500_shapes(void) { compound(500); }
static void compound_of_4000_shapes(void) { compound(4000); }

/* ---- steps of a world of pairs of boxes that sleep, and of an empty one ---- */

#define STEPS 200

static void sleepers(int32_t boxes, int32_t steps)
{
	cn_world *world = fixture_world(-10.0f, 1);
	double start;
	int32_t k;
	fixture_box(world, CN_BODY_STATIC, 0.0f, -1.0f, 0.0f, 10000.0f, 1.0f, 0.6f, 0.0f);
	for (k = 0; k < boxes; ++k)
		fixture_box(world, CN_BODY_DYNAMIC, 1.2f * (float)(k / 2) - 3000.0f, 0.5f + (float)(k % 2), 0.0f, 0.5f, 0.5f, 0.6f, 0.0f);
	fixture_step(world, 75);
	CHECK(fixture_counters(world).bodies_awake == 0);
	start = cpu_s();
	fixture_step(world, steps);
	printf("  %d bodies asleep: %.3f us a step\n", (int)boxes, steps > 0 ? 1e6 * (cpu_s() - start) / (double)steps : 0.0);
	cn_world_destroy(world);
}

static void sleepers_made(void) { sleepers(2000, 0); }
static void sleepers_stepped(void) { sleepers(2000, STEPS); }
static void empty_made(void) { sleepers(0, 0); }
static void empty_stepped(void) { sleepers(0, STEPS); }

/* ---- a straight bridge of 300 planks: its joints need more substeps as it falls, and boxes are about to hit it ---- */

static void bridge_falls(int32_t steps)
{
	enum { PLANKS = 300 };
	cn_world *world = fixture_world(-10.0f, 1);
	cn_body last = fixture_box(world, CN_BODY_STATIC, -1.0f, 10.0f, 0.0f, 0.5f, 0.2f, 0.5f, 0.0f), end;
	uint32_t random = 7;
	double start;
	int32_t k;
	for (k = 0; k < PLANKS; ++k) {
		cn_body plank = fixture_box(world, CN_BODY_DYNAMIC, (float)k, 10.0f, 0.0f, 0.48f, 0.1f, 0.6f, 0.0f);
		hinge(world, last, at(0.5f, 0.0f), plank, at(-0.5f, 0.0f));
		last = plank;
	}
	end = fixture_box(world, CN_BODY_STATIC, (float)PLANKS, 10.0f, 0.0f, 0.5f, 0.2f, 0.5f, 0.0f);
	hinge(world, last, at(0.5f, 0.0f), end, at(-0.5f, 0.0f));
	for (k = 0; k < PLANKS / 2; ++k)
		fixture_box(world, CN_BODY_DYNAMIC, fixture_random(&random, 1.0f, (float)(PLANKS - 2)), 11.0f + 0.2f * (float)k, 0.0f, 0.4f, 0.4f, 0.6f, 0.0f);
	start = cpu_s();
	fixture_step(world, steps);
	printf("  %.2f ms a step\n", 1e3 * (cpu_s() - start) / (double)steps);
	cn_world_destroy(world);
}

static void bridge_falls_for_5_steps(void) { bridge_falls(5); }
static void bridge_falls_for_20_steps(void) { bridge_falls(20); }

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(level_of_1000_tiles);
	RUN(level_of_8000_tiles);
	RUN(compound_of_500_shapes);
	RUN(compound_of_4000_shapes);
	RUN(changed_500_shapes);
	RUN(changed_4000_shapes);
	RUN(bodies_gone_1000);
	RUN(bodies_gone_8000);
	RUN(chain_moved_6000_sweep);
	RUN(chain_moved_48000_sweep);
	RUN(chain_moved_6000_tree);
	RUN(chain_moved_48000_tree);
	RUN(sleepers_made);
	RUN(sleepers_stepped);
	RUN(empty_made);
	RUN(empty_stepped);
	RUN(bridge_falls_for_5_steps);
	RUN(bridge_falls_for_20_steps);
	return test_end();
}
