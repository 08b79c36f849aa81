/*
 * test/world/sleep.h - what tests of sleep and waking share.
 */
#ifndef CAIRN_TEST_SLEEP_H
#define CAIRN_TEST_SLEEP_H

#include "fixture.h"

static inline cn_body unit_box(cn_world *world, float x, float y)
{
	return fixture_box(world, CN_BODY_DYNAMIC, x, y, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f);
}

/* Steps until the body sleeps; -1 when it does not within the given number. */
static inline int32_t steps_to_sleep(cn_world *world, cn_body body, int32_t most)
{
	int32_t k;
	for (k = 1; k <= most; ++k) {
		fixture_step(world, 1);
		if (!fixture_is_awake(world, body))
			return k;
	}
	return -1;
}

static inline int32_t fell_asleep_count(const cn_world *world, cn_body body)
{
	const cn_body *list;
	int32_t count, k, times = 0;
	must(cn_world_fell_asleep(world, &list, &count), world, "cn_world_fell_asleep");
	for (k = 0; k < count; ++k)
		times += list[k] == body || body == 0;
	return times;
}

#endif
