/*
 * bindings/test/hinges.c - what the tests of the bindings must print: the falling-hinges scene, all
 * poses read with one call a frame, and shapes that began to touch counted twice: in the array of
 * events and by a callback.
 *
 * The sum over poses takes each float as its 32 bits w, in order: sum = (31 sum + w) mod 2^32, which
 * every language can compute exactly. With the word times it prints what reading 1,000 poses takes.
 */
#include "scenes/scenes.h"
#include <inttypes.h>
#include <stdio.h>
#include <string.h>
#include <time.h>

#define BODIES_MAX 1000

static uint32_t add_poses(uint32_t sum, const cn_pose *poses, int32_t count)
{
	for (int32_t i = 0; i < count; ++i) {
		uint32_t words[4];
		memcpy(words, &poses[i], sizeof words);
		for (int32_t k = 0; k < 4; ++k)
			sum = 31u * sum + words[k];
	}
	return sum;
}

static void count_call(cn_world *world, const cn_contact_event *event, void *user)
{
	(void)world;
	*(int32_t *)user += event->kind == CN_EVENT_ENTER;
}

/* Nanoseconds per body for reading 1,000 poses into the caller's array: the row of C beside those of the bindings. */
static int times(void)
{
	static cn_pose poses[BODIES_MAX];
	cn_world_def world_def;
	cn_body_def def;
	cn_world *world;
	cn_body body;
	cn_world_def_init(&world_def);
	cn_body_def_init(&def);
	cn_result result = cn_world_create(&world_def, &world);
	if (result != CN_OK)
		return 1;
	for (int32_t i = 0; i < BODIES_MAX && result == CN_OK; ++i)
		result = cn_body_create(world, &def, &body);
	clock_t start = clock();
	for (int32_t i = 0; i < 5000 && result == CN_OK; ++i)
		result = cn_world_read_poses(world, NULL, BODIES_MAX, poses);
	printf("%.2f\n", (double)(clock() - start) * 1e9 / CLOCKS_PER_SEC / 5000.0 / BODIES_MAX);
	cn_world_destroy(world);
	return result != CN_OK;
}

int main(int argument_count, char **arguments)
{
	if (argument_count > 1 && strcmp(arguments[1], "times") == 0)
		return times();
	static cn_pose poses[BODIES_MAX];
	scene_run run;
	const cn_contact_event *events;
	int32_t count = 0, event_count = 0, entered = 0, called = 0;
	uint32_t sum = 0;
	uint64_t hash = 0;
	if (scene_open(&run, scene_find("falling_hinges"), NULL) != CN_OK) {
		puts(run.error_text);
		return 1;
	}
	cn_result result = cn_world_get_bodies(run.world, NULL, 0, &count);
	if (count > BODIES_MAX)
		result = CN_ERROR_CAPACITY;
	if (result == CN_OK)
		result = cn_world_set_contact_callback(run.world, CN_EVENT_ENTER, count_call, &called);
	while (result == CN_OK && run.step_index < run.scene->step_count) {
		result = scene_step(&run);
		if (result == CN_OK)
			result = cn_world_read_poses(run.world, NULL, count, poses);
		if (result == CN_OK)
			result = cn_world_contact_events(run.world, CN_EVENT_ENTER, &events, &event_count);
		sum = add_poses(sum, poses, count);
		entered += event_count;
	}
	if (result == CN_OK)
		result = cn_world_hash(run.world, &hash);
	if (result == CN_OK)
		printf("falling_hinges: %" PRId32 " steps, %" PRId32 " bodies, %" PRId32 " entered, %" PRId32 " called, poses %08" PRIx32 ", hash %016" PRIx64 "\n",
			run.step_index, count, entered, called, sum, hash);
	else
		puts(cn_result_text(result));
	scene_close(&run);
	return result != CN_OK;
}
