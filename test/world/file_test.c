/*
 * test/world/file_test.c - a world that is read from its bytes goes on bit for bit like the written one, with the game's handles, after
 * every kind of history and in memory of every kind; the bytes are the same on every machine; whatever is no written world is refused.
 */
#include "files.h"

#include "joints.h"
#include "world/file.h"

#define LOCKSTEP 40

#ifdef TEST_EMULATED
#define EMULATED 1
#else
#define EMULATED 0
#endif

/* ---- going on ---- */

static const struct journey {
	const char *scene;
	int32_t written_at;
	int32_t slow; /* only with TEST_SLOW */
	setting s;
} journeys[] = {
	{ "falling_hinges", 90, 0, { CN_SOLVER_AUTO, SWEEP, 0, 0 } },
	{ "dominoes", 150, 0, { CN_SOLVER_AUTO, TREE, 0, 0 } },
	{ "ragdolls", 100, 0, { CN_SOLVER_AUTO, SWEEP, 0, 1 } },
	{ "bridge", 120, 0, { CN_SOLVER_AUTO, TREE, 0, 1 } },
	{ "car", 60, 0, { CN_SOLVER_AUTO, SWEEP, 0, 0 } },
	{ "mixer", 60, 0, { CN_SOLVER_AUTO, TREE, 2, 0 } },
	{ "small_50_sleep", 300, 0, { CN_SOLVER_AUTO, SWEEP, 0, 1 } },
	{ "pyramid", 20, 0, { CN_SOLVER_AUTO, SWEEP, 2, 1 } },
	{ "pyramid", 70, 0, { CN_SOLVER_AUTO, TREE, 0, 0 } },
	{ "falling_hinges", 200, 0, { CN_SOLVER_SOFT, TREE, 2, 0 } },
	{ "small_200", 120, 0, { CN_SOLVER_SOFT, SWEEP, 0, 1 } },
	{ "dominoes", 200, 0, { CN_SOLVER_DIRECT, TREE, 0, 1 } },
	{ "falling_hinges", 60, 0, { CN_SOLVER_SEQUENTIAL, SWEEP, 2, 1 } },
};

static void digests_take(scene_run *run, uint64_t digests[LOCKSTEP])
{
	int32_t k;
	for (k = 0; k < LOCKSTEP; ++k) {
		scene_steps(run, 1);
		digests[k] = digest_events(run->world);
	}
}

static int32_t same_digests(const uint64_t a[LOCKSTEP], const uint64_t b[LOCKSTEP])
{
	int32_t k;
	for (k = 0; k < LOCKSTEP && a[k] == b[k]; ++k)
		;
	return k;
}

/* The scene's world becomes the one that is read from its bytes; its own memory, with handles, stays. */
static void run_through_file(scene_run *run, const setting *s, void **block)
{
	saved f = write_world(run->world);
	cn_world *written = run->world;
	void *old = *block;
	run->world = read_into(&f, s, block);
	CHECK(writes_the_same(run->world, &f));
	cn_world_destroy(written);
	free(old);
	saved_free(&f);
}

static int32_t journey_goes_on(const scene *which, int32_t written_at, const setting *s)
{
	uint64_t straight[LOCKSTEP], read[LOCKSTEP];
	int32_t through;
	for (through = 0; through < 2; ++through) {
		scene_run run;
		void *block;
		memset(&run, 0, sizeof run);
		run.scene = which;
		run.world = world_of(which, s, &block);
		which->create(&run);
		scene_must(&run);
		scene_steps(&run, written_at);
		if (through)
			run_through_file(&run, s, &block);
		digests_take(&run, through ? read : straight);
		scene_close(&run);
		free(block);
	}
	return same_digests(straight, read);
}

static void t_a_world_that_is_read_goes_on_bit_for_bit(void)
{
	size_t k;
	for (k = 0; k < sizeof journeys / sizeof journeys[0]; ++k) {
		const struct journey *j = &journeys[k];
		int32_t same = journey_goes_on(scene_find(j->scene), j->written_at, &j->s);
		printf("  %s, solver %d, broadphase %d, workers %d, block %d: %d of %d steps alike\n", j->scene, (int)j->s.solver, (int)j->s.broadphase, (int)j->s.workers,
		       (int)j->s.in_block, (int)same, LOCKSTEP);
		CHECK(same == LOCKSTEP);
	}
}

/* Every scene of the examples. */
static void t_every_scene_goes_on(void)
{
	const setting s = { CN_SOLVER_AUTO, SWEEP, 0, 0 };
	int32_t k;
#ifndef TEST_SLOW
	SKIP("slow: with TEST_SLOW");
#endif
	for (k = 0; k < scene_count(); ++k) {
		int32_t same = journey_goes_on(scene_at(k), 45, &s);
		printf("  %s: %d of %d steps alike\n", scene_at(k)->name, (int)same, LOCKSTEP);
		CHECK(same == LOCKSTEP);
	}
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(t_a_world_that_is_read_goes_on_bit_for_bit);
	RUN(t_every_scene_goes_on);
	return test_end();
}
