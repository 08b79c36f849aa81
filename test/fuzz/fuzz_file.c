/*
 * test/fuzz/fuzz_file.c - reading a world from any bytes. The header is put in front and its checksum made to fit, so that the checks behind
 * it are reached. What is read is valid, writes itself again, can be stepped, asked and changed.
 *
 * fuzz_recording.c does the same for recordings.
 */
#include "fuzz.h"

#define HEADER 32

static void header_put(uint8_t *file, uint64_t bytes)
{
	uint64_t hash = 0xCBF29CE484222325u;
	uint64_t k;
	memset(file, 0, HEADER);
	memcpy(file, "CairnWld", 8);
	file[8] = 1;
	for (k = HEADER; k < bytes; ++k)
		hash = (hash ^ file[k]) * 0x100000001B3u;
	for (k = 0; k < 8; ++k) {
		file[16 + k] = (uint8_t)(bytes >> 8 * k);
		file[24 + k] = (uint8_t)(hash >> 8 * k);
	}
}

static void use(cn_world *world)
{
	cn_aabb everywhere = { { -100.0f, -100.0f }, { 100.0f, 100.0f } };
	cn_ray ray = { { -50.0f, 1.0f }, { 100.0f, 0.5f } };
	cn_ray_hit hit;
	cn_shape shapes[16];
	cn_body bodies[64];
	const cn_body_moved *moved;
	const cn_contact_event *events;
	int32_t count, kind, k;
	for (kind = 0; kind < CN_EVENT_KINDS; ++kind)
		FUZZ_REQUIRE(cn_world_contact_events(world, kind, &events, &count) == CN_OK);
	FUZZ_REQUIRE(cn_world_moved(world, &moved, &count) == CN_OK);
	for (k = 0; k < 3; ++k)
		(void)cn_world_step(world, 1.0f / 60.0f);
	(void)cn_world_overlap_aabb(world, &everywhere, NULL, shapes, 16, &count);
	(void)cn_world_cast_ray(world, &ray, NULL, &hit);
	if (cn_world_get_bodies(world, bodies, 64, &count) == CN_OK)
		for (k = 0; k < count && k < 64; k += 2)
			(void)cn_body_destroy(world, bodies[k]);
	(void)cn_world_step(world, 1.0f / 60.0f);
}

/* It writes what it reads: the bytes of a world that was read are the same again. */
static void check_again(cn_world *world)
{
	uint64_t bytes = 0, again_bytes = 0;
	uint8_t *file, *again;
	cn_world *read = NULL;
	FUZZ_REQUIRE(cn_world_write_size(world, &bytes) == CN_OK);
	file = (uint8_t *)malloc((size_t)bytes);
	again = (uint8_t *)malloc((size_t)bytes);
	FUZZ_REQUIRE(file != NULL && again != NULL && cn_world_write(world, file, bytes, NULL) == CN_OK);
	FUZZ_REQUIRE(cn_world_read(NULL, file, bytes, &read) == CN_OK);
	FUZZ_REQUIRE(cn_world_write(read, again, bytes, &again_bytes) == CN_OK && again_bytes == bytes && memcmp(file, again, (size_t)bytes) == 0);
	cn_world_destroy(read);
	free(file);
	free(again);
}

void fuzz_file(const uint8_t *bytes, size_t count)
{
	uint8_t *file = (uint8_t *)malloc(count + HEADER);
	cn_world *world = NULL;
	cn_result result;
	FUZZ_REQUIRE(file != NULL);
	if (count > 0)
		memcpy(file + HEADER, bytes, count);
	header_put(file, count + HEADER);
	result = cn_world_read(NULL, file, count + HEADER, &world);
	FUZZ_REQUIRE(result == CN_ERROR_FORMAT || (result == CN_OK && world != NULL));
	free(file);
	if (result != CN_OK)
		return;
	FUZZ_REQUIRE(cn_world_validate(world, NULL, 0) == CN_OK);
	check_again(world);
	use(world);
	cn_world_destroy(world);
}
