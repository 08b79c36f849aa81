/*
 * test/broadphase/sweep_test.c - the tiled sweep: the promises of every broadphase (broadphase_scenes.h) and its
 * own figures of memory.
 */
#include "broadphase_scenes.h"

static void t_empty_is_small(void)
{
	static box_world w;
	uint64_t in_use;
	REQUIRE(world_open(&w, 8, 0, 0));
	in_use = w.memory.bytes_in_use;
	CHECK_LE("memory of an empty broadphase", in_use, 3072, "bytes");
	CHECK(in_use >= w.ops->bytes(w.broadphase));
	CHECK(world_add(&w, 0, box_at(0, 0, 1, 1), 0));
	CHECK(world_update(&w) == 0);
	printf("  one box: %llu bytes\n", (unsigned long long)w.ops->bytes(w.broadphase));
	CHECK_LE("memory with one box", w.ops->bytes(w.broadphase), 3072, "bytes");
	world_close(&w);
}

static void t_memory_a_box(void)
{
	CHECK_LE("dense", bytes_a_box(20000, 200), 48, "bytes a box");
	CHECK_LE("thin", bytes_a_box(20000, 1000), 64, "bytes a box");
	CHECK_LE("sparse", bytes_a_box(20000, 10000), 160, "bytes a box");
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	tested.ops = &cni_broadphase_sweep;
	tested.hash = 0x7a6b19d5u; /* depends on how S0 is chosen */
	tested.allocations = 20;
	RUN(t_empty_is_small);
	RUN(t_memory_a_box);
	run_shared_tests();
	return test_end();
}
