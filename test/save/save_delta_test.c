/*
 * test/save/save_delta_test.c - a delta gives its save again byte for byte, takes room for what has changed, and is refused when it is
 * damaged or of another base.
 */
#include "saves.h"

static saved delta_of(const saved *base, const saved *save)
{
	saved d = { NULL, 0 };
	uint64_t wrote = 0;
	must(cn_save_delta_size(base->data, base->bytes, save->data, save->bytes, &d.bytes), NULL, "cn_save_delta_size");
	d.data = malloc((size_t)d.bytes);
	if (d.data == NULL)
		exit(2);
	must(cn_save_delta(base->data, base->bytes, save->data, save->bytes, d.data, d.bytes, &wrote), NULL, "cn_save_delta");
	CHECK(wrote == d.bytes);
	return d;
}

static int32_t applies(const saved *base, const saved *delta, const saved *expected)
{
	uint8_t *out = (uint8_t *)malloc((size_t)expected->bytes);
	uint64_t bytes = 0;
	int32_t good = out != NULL && cn_save_apply(base->data, base->bytes, delta->data, delta->bytes, out, expected->bytes, &bytes) == CN_OK && bytes == expected->bytes &&
	               memcmp(out, expected->data, (size_t)bytes) == 0;
	free(out);
	return good;
}

/* Islands of boxes on the ground, asleep but for the first `awake` of them. */
static cn_world *islands_world(int32_t count, int32_t awake, cn_body *bodies)
{
	cn_world *world = fixture_world(-10.0f, 1);
	int32_t k;
	fixture_box(world, CN_BODY_STATIC, 0.0f, -1.0f, 0.0f, 3000.0f, 1.0f, 0.6f, 0.0f);
	for (k = 0; k < count; ++k)
		bodies[k] = fixture_box(world, CN_BODY_DYNAMIC, 3.0f * (float)(k - count / 2), 0.4f, 0.0f, 0.4f, 0.4f, 0.6f, 0.0f);
	fixture_step(world, 120);
	for (k = 0; k < awake; ++k)
		must(cn_body_set_velocity(world, bodies[k], 0.0f, 3.0f, 1.0f), world, "cn_body_set_velocity");
	fixture_step(world, 2);
	return world;
}

static void t_a_delta_gives_its_save_again(void)
{
	static cn_body bodies[200];
	cn_world *world = islands_world(200, 20, bodies), *other = fixture_world(-10.0f, 1);
	saved base = save_world(world), ring[5];
	int32_t k;
	for (k = 0; k < 5; ++k) { /* moved; fewer; more; the same; as the base */
		saved delta;
		if (k == 1)
			must(cn_body_destroy(world, bodies[7]), world, "cn_body_destroy");
		if (k == 2)
			for (int32_t n = 0; n < 30; ++n)
				fixture_circle(world, CN_BODY_DYNAMIC, 0.3f * (float)n, 5.0f, 0.2f, 0.5f, 0.0f);
		if (k == 4)
			restore_world(world, &base);
		else if (k != 3)
			fixture_step(world, 3);
		ring[k] = save_world(world);
		delta = delta_of(&base, &ring[k]);
		printf("  save %d: %d bytes, delta %d\n", (int)k, (int)ring[k].bytes, (int)delta.bytes);
		CHECK(applies(&base, &delta, &ring[k]) && delta.bytes <= ring[k].bytes + 64);
		CHECK(k != 4 || delta.bytes < 64);
		CHECK(k == 4 || !applies(&ring[k], &delta, &ring[k])); /* of another base */
		saved_free(&delta);
		saved_free(&ring[k]);
	}
	saved_free(&base);
	cn_world_destroy(world);
	cn_world_destroy(other);
}

static void t_sleeping_bodies_take_no_room(void)
{
	static const int32_t awake[] = { 0, 10, 50, 200, 1000 };
	static cn_body bodies[1000];
	uint64_t at_rest = 0;
	size_t k;
	for (k = 0; k < sizeof awake / sizeof awake[0]; ++k) {
		cn_world *world = islands_world(1000, awake[k], bodies);
		saved base = save_world(world), save, delta;
		fixture_step(world, 1);
		save = save_world(world);
		delta = delta_of(&base, &save);
		at_rest = k == 0 ? delta.bytes : at_rest;
		printf("  %4d of 1,000 awake: save %d bytes, delta %d, %.0f for each awake body\n", (int)awake[k], (int)save.bytes, (int)delta.bytes,
			awake[k] > 0 ? (double)(delta.bytes - at_rest) / (double)awake[k] : 0.0);
		CHECK(applies(&base, &delta, &save));
		CHECK_LE("bytes of the delta", delta.bytes, 1000 + 500 * awake[k], "B");
		saved_free(&base);
		saved_free(&save);
		saved_free(&delta);
		cn_world_destroy(world);
	}
}

static void t_damaged_deltas_are_refused(void)
{
	static cn_body bodies[40];
	cn_world *world = islands_world(40, 5, bodies);
	saved base = save_world(world), save, delta;
	uint8_t *out, *bytes;
	uint64_t k;
	int32_t refused = 0;
	fixture_step(world, 3);
	save = save_world(world);
	delta = delta_of(&base, &save);
	out = (uint8_t *)malloc((size_t)save.bytes);
	bytes = (uint8_t *)delta.data;
	for (k = 0; k < delta.bytes; ++k) {
		bytes[k] ^= 8u;
		refused += cn_save_apply(base.data, base.bytes, bytes, delta.bytes, out, save.bytes, NULL) == CN_ERROR_FORMAT;
		bytes[k] ^= 8u;
		refused += cn_save_apply(base.data, base.bytes, bytes, k, out, save.bytes, NULL) == CN_ERROR_FORMAT;
	}
	printf("  %d of %d refused\n", (int)refused, (int)(2 * delta.bytes));
	CHECK(refused == (int32_t)(2 * delta.bytes));
	CHECK(cn_save_apply(base.data, base.bytes, bytes, delta.bytes, out, save.bytes - 1, NULL) == CN_ERROR_CAPACITY);
	CHECK(cn_save_delta(base.data, base.bytes, save.data, save.bytes, out, delta.bytes - 1, NULL) == CN_ERROR_CAPACITY);
	CHECK(cn_save_delta(base.data, base.bytes - 1, save.data, save.bytes, out, save.bytes, NULL) == CN_ERROR_FORMAT);
	free(out);
	saved_free(&base);
	saved_free(&save);
	saved_free(&delta);
	cn_world_destroy(world);
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(t_a_delta_gives_its_save_again);
	RUN(t_sleeping_bodies_take_no_room);
	RUN(t_damaged_deltas_are_refused);
	return test_end();
}
