/*
 * test/broadphase/broadphase_tree_test.c - the tree broadphase: the shared tests (broadphase_scenes.h) and its memory
 * figures.
 */
#include "broadphase_scenes.h"

static void t_empty_is_small(void)
{
	static box_world w;
	REQUIRE(world_open(&w, 8, 0, 0));
	CHECK_LE("memory of an empty broadphase", w.memory.bytes_in_use, 1024, "bytes");
	CHECK(world_add(&w, 0, box_at(0, 0, 1, 1), 0));
	CHECK(world_update(&w) == 0);
	CHECK_LE("memory with one box", broadphase_close(&w), 3584, "bytes"); /* a page of proxies */
	world_close(&w);
}

static void t_memory_a_box(void)
{
	CHECK_LE("dense", bytes_a_box(20000, 200), 60, "bytes a box");
	CHECK_LE("sparse", bytes_a_box(20000, 10000), 60, "bytes a box");
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	tested.ops = &cni_broadphase_tree;
	tested.hash = 0xaac2c707u;
	tested.allocations = 8;
	RUN(t_empty_is_small);
	RUN(t_memory_a_box);
	run_shared_tests();
	return test_end();
}
