/*
 * test/world/growth_time_test.c - work that must not grow with what lies beside it: a tile added to a level costs the same
 * whatever the level's size, a shape added to a moving body likewise, and bodies that sleep cost a step nothing.
 *
 * Times are printed and have no bounds, as other programs disturb them. test/work.sh runs the functions one by one under
 * valgrind and bounds the instructions they execute.
 *
 * If a test here fails, look first in: model/body_shapes.c (mass of a body of many shapes), step/finalize.c, model/island_sleep.c.
 */
#include "fixture.h"

#include <time.h>

static double cpu_s(void) { return (double)clock() / (double)CLOCKS_PER_SEC; }

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

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(level_of_1000_tiles);
	RUN(level_of_8000_tiles);
	RUN(compound_of_500_shapes);
	RUN(compound_of_4000_shapes);
	RUN(sleepers_made);
	RUN(sleepers_stepped);
	RUN(empty_made);
	RUN(empty_stepped);
	return test_end();
}
