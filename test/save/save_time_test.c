/*
 * test/save/save_time_test.c - prints what saving and restoring cost beside a plain copy of as many bytes, and what a rollback of
 * 8 frames does: restore, then 8 steps, each with a save; and what writing and reading a file cost. Times have no bounds; fails only with the calls themselves.
 */
#include "files.h"

#include "measure/measure.h"

#define ROUNDS 200
#define FRAMES 8

/* A heap of boxes of several sizes between two walls, still settling. */
static cn_world *heap_world(int32_t bodies)
{
	cn_world *world = fixture_world(-10.0f, 0);
	uint32_t random = 1;
	int32_t k;
	fixture_floor(world, 0.6f, 0.0f);
	fixture_box(world, CN_BODY_STATIC, -16.0f, 20.0f, 0.0f, 1.0f, 20.0f, 0.6f, 0.0f);
	fixture_box(world, CN_BODY_STATIC, 16.0f, 20.0f, 0.0f, 1.0f, 20.0f, 0.6f, 0.0f);
	for (k = 0; k < bodies; ++k) {
		float angle = fixture_random(&random, -1.5f, 1.5f), half_x = fixture_random(&random, 0.3f, 0.5f), half_y = fixture_random(&random, 0.3f, 0.5f);
		fixture_box(world, CN_BODY_DYNAMIC, (float)(k % 24) * 1.2f - 13.8f, (float)(k / 24) * 1.2f + 0.6f, angle, half_x, half_y, 0.6f, 0.0f);
	}
	fixture_step(world, 300);
	return world;
}

static double least(double a, double b) { return a < b ? a : b; }

static void t_save_and_restore_of_a_heap(void)
{
	cn_world *world = heap_world(1000);
	saved s = save_world(world), copy = save_world(world);
	double save_s = 1.0, restore_s = 1.0, copy_s = 1.0, begin;
	int32_t k;
	for (k = 0; k < ROUNDS; ++k) {
		begin = measure_clock_s();
		must(cn_world_save(world, s.data, s.bytes, NULL), world, "cn_world_save");
		save_s = least(save_s, measure_clock_s() - begin);
		begin = measure_clock_s();
		restore_world(world, &s);
		restore_s = least(restore_s, measure_clock_s() - begin);
		begin = measure_clock_s();
		memcpy(copy.data, s.data, (size_t)s.bytes);
		copy_s = least(copy_s, measure_clock_s() - begin);
	}
	printf("  1,000 boxes, %d touching contacts, %llu bytes: save %.3f ms, restore %.3f ms, plain copy %.3f ms\n", (int)fixture_counters(world).contacts_touching,
		(unsigned long long)s.bytes, 1e3 * save_s, 1e3 * restore_s, 1e3 * copy_s);
	CHECK(saves_the_same(world, &s));
	saved_free(&s);
	saved_free(&copy);
	cn_world_destroy(world);
}

static void t_write_and_read_of_a_heap(void)
{
	cn_world *world = heap_world(1000);
	saved f = write_world(world);
	double write_s = 1.0, read_s = 1.0, begin;
	int32_t k;
	for (k = 0; k < ROUNDS / 10; ++k) {
		cn_world *read;
		begin = measure_clock_s();
		must(cn_world_write(world, f.data, f.bytes, NULL), world, "cn_world_write");
		write_s = least(write_s, measure_clock_s() - begin);
		begin = measure_clock_s();
		read = read_world(&f);
		read_s = least(read_s, measure_clock_s() - begin);
		cn_world_destroy(read);
	}
	printf("  1,000 boxes, %llu bytes: write %.3f ms, read %.3f ms\n", (unsigned long long)f.bytes, 1e3 * write_s, 1e3 * read_s);
	CHECK(writes_the_same(world, &f));
	saved_free(&f);
	cn_world_destroy(world);
}

static void t_delta_of_a_heap(void)
{
	cn_world *world = heap_world(1000);
	saved base = save_world(world), save, delta = { NULL, 0 }, out = save_world(world);
	double delta_s = 1.0, apply_s = 1.0, begin;
	int32_t k;
	fixture_step(world, 1);
	save = save_world(world);
	must(cn_save_delta_size(base.data, base.bytes, save.data, save.bytes, &delta.bytes), NULL, "cn_save_delta_size");
	delta.data = malloc((size_t)delta.bytes);
	out.data = realloc(out.data, (size_t)save.bytes);
	for (k = 0; k < ROUNDS / 10; ++k) {
		begin = measure_clock_s();
		must(cn_save_delta(base.data, base.bytes, save.data, save.bytes, delta.data, delta.bytes, NULL), NULL, "cn_save_delta");
		delta_s = least(delta_s, measure_clock_s() - begin);
		begin = measure_clock_s();
		must(cn_save_apply(base.data, base.bytes, delta.data, delta.bytes, out.data, save.bytes, NULL), NULL, "cn_save_apply");
		apply_s = least(apply_s, measure_clock_s() - begin);
	}
	printf("  1,000 boxes in a heap, all awake: save %llu bytes, delta %llu, made in %.3f ms, applied in %.3f ms\n", (unsigned long long)save.bytes,
		(unsigned long long)delta.bytes, 1e3 * delta_s, 1e3 * apply_s);
	CHECK(memcmp(out.data, save.data, (size_t)save.bytes) == 0);
	saved_free(&base);
	saved_free(&save);
	saved_free(&delta);
	saved_free(&out);
	cn_world_destroy(world);
}

static void t_rollback_of_eight_frames(void)
{
	cn_world *world = heap_world(500);
	saved ring[FRAMES];
	double rollback_s = 1.0, steps_s = 1.0, begin;
	uint64_t wrote = 0;
	int32_t k, round;
	for (k = 0; k < FRAMES; ++k) {
		ring[k] = save_world(world);
		ring[k].bytes *= 2; /* room to grow */
		free(ring[k].data);
		ring[k].data = malloc((size_t)ring[k].bytes);
	}
	must(cn_world_save(world, ring[0].data, ring[0].bytes, &wrote), world, "cn_world_save");
	for (round = 0; round < 20; ++round) {
		begin = measure_clock_s();
		fixture_step(world, FRAMES);
		steps_s = least(steps_s, measure_clock_s() - begin);
		begin = measure_clock_s();
		must(cn_world_restore(world, ring[0].data, wrote), world, "cn_world_restore");
		for (k = 1; k <= FRAMES; ++k) {
			fixture_step(world, 1);
			must(cn_world_save(world, ring[k % FRAMES].data, ring[k % FRAMES].bytes, k == FRAMES ? &wrote : NULL), world, "cn_world_save");
		}
		rollback_s = least(rollback_s, measure_clock_s() - begin);
	}
	printf("  500 boxes, %d touching contacts: %d frames rolled back in %.2f ms, of which %.2f ms are the steps\n",
		(int)fixture_counters(world).contacts_touching, FRAMES, 1e3 * rollback_s, 1e3 * steps_s);
	CHECK(fixture_is_valid(world));
	for (k = 0; k < FRAMES; ++k)
		saved_free(&ring[k]);
	cn_world_destroy(world);
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(t_save_and_restore_of_a_heap);
	RUN(t_write_and_read_of_a_heap);
	RUN(t_delta_of_a_heap);
	RUN(t_rollback_of_eight_frames);
	return test_end();
}
