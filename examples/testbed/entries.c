/* examples/testbed/entries.c - all scenes of the testbed: those of examples/scenes that do not only measure memory, then examples. */
#include "testbed/entries.h"
#include "testbed/testbed.h"
#include <string.h>

static const testbed_entry examples[] = {
	{&entry_ragdoll, 1.0f},
	{&entry_car, 1.0f},
	{&entry_billiards, 0.05f},
	{&entry_breakable_wall, 1.0f},
	{&entry_conveyor, 1.0f},
	{&entry_mouse, 1.0f},
	{&entry_wind, 1.0f},
	{&entry_areas, 1.0f},
	{&entry_destructible_terrain, 1.0f},
	{&entry_platformer, 1.0f},
};
#define EXAMPLES ((int32_t)(sizeof examples / sizeof examples[0]))

static int32_t is_shown(const scene *s) { return strncmp(s->name, "memory_", 7) != 0; }

/* Scenes of the list that are shown, before the first that is not. */
static int32_t listed(void)
{
	int32_t count = 0;
	while (count < scene_count() && is_shown(scene_at(count)))
		++count;
	return count;
}

int32_t testbed_count(void) { return listed() + EXAMPLES; }

testbed_entry testbed_at(int32_t index)
{
	testbed_entry entry = {scene_at(index), 1.0f};
	return index >= listed() ? examples[index - listed()] : entry;
}

int32_t testbed_find(const char *name)
{
	for (int32_t i = 0; i < testbed_count(); ++i) {
		if (strcmp(testbed_at(i).scene->name, name) == 0)
			return i;
	}
	return -1;
}
