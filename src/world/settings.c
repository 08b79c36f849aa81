/*
 * world/settings.c - public functions on a world's settings, counters, profile and memory statistics.
 * Writes world->settings and user_data; wakes bodies where a setting requires it.
 */
#include "direct/direct.h"
#include "world/error.h"

#include <string.h>

static void wake_all(cn_world *world)
{
	for (int32_t body = cni_handles_next(&world->body_handles, 0); body != CNI_NONE; body = cni_handles_next(&world->body_handles, body + 1))
		cni_body_wake(world, body);
}

/* Defines cn_world_get_<what>, which reads one value of the world. */
#define WORLD_GET(what, type, value) \
	cn_result cn_world_get_##what(const cn_world *world, type *out) \
	{ \
		if (world == NULL || out == NULL) \
			return CN_ERROR_ARGUMENT; \
		*out = value; \
		return CN_OK; \
	}

/* Defines cn_world_set_<what>, which stores one value after a check. */
#define WORLD_SET(what, type, value, check, place) \
	cn_result cn_world_set_##what(cn_world *world, type value) \
	{ \
		cni_call call = cni_enter(world, __func__); \
		check; \
		if (call.result == CN_OK) \
			place = value; \
		return call.result; \
	}

cn_result cn_world_set_gravity(cn_world *world, float gravity_x_mps2, float gravity_y_mps2)
{
	cn_vec2 gravity_mps2 = { gravity_x_mps2, gravity_y_mps2 };
	cni_call call = cni_enter(world, __func__);
	cni_check_finite2(&call, "gravity_mps2", gravity_mps2);
	if (call.result != CN_OK)
		return call.result;
	if (gravity_mps2.x != world->settings.gravity.x || gravity_mps2.y != world->settings.gravity.y)
		wake_all(world);
	world->settings.gravity = gravity_mps2;
	return CN_OK;
}

WORLD_GET(gravity, cn_vec2, world->settings.gravity)

WORLD_SET(substep_count, int32_t, count, cni_check_range_int(&call, "count", count, 1, 64), world->settings.substeps)
WORLD_GET(substep_count, int32_t, world->settings.substeps)

cn_result cn_world_set_solver(cn_world *world, int32_t solver)
{
	cni_call call = cni_enter(world, __func__);
	cni_check_solver(&call, solver, CN_SOLVER_SEQUENTIAL);
	if (call.result != CN_OK || solver == world->settings.solver)
		return call.result;
	world->settings.solver = solver;
	if (CNI_HAS_DIRECT)
		cni_solver_selection_reset(world);
	return CN_OK;
}

WORLD_GET(solver, int32_t, world->settings.solver)

cn_result cn_world_set_accuracy(cn_world *world, float accuracy_m, int32_t work_budget)
{
	cni_call call = cni_enter(world, __func__);
	cni_check_at_least_or_default(&call, "accuracy_m", accuracy_m);
	cni_check_work_budget(&call, work_budget);
	if (call.result != CN_OK)
		return call.result;
	world->settings.accuracy = accuracy_m == (float)CN_DEFAULT ? world->settings.slop : accuracy_m;
	world->settings.work_budget = work_budget == CN_DEFAULT ? 0 : work_budget;
	return CN_OK;
}

cn_result cn_world_get_accuracy(const cn_world *world, float *out_accuracy_m, int32_t *out_work_budget)
{
	if (world == NULL || out_accuracy_m == NULL || out_work_budget == NULL)
		return CN_ERROR_ARGUMENT;
	*out_accuracy_m = world->settings.accuracy;
	*out_work_budget = world->settings.work_budget == 0 ? CN_DEFAULT : world->settings.work_budget;
	return CN_OK;
}

cn_result cn_world_set_flags(cn_world *world, uint32_t flags)
{
	cni_call call = cni_enter(world, __func__);
	cni_check_flags(&call, "flags", flags, CNI_WORLD_FLAGS);
	if (call.result != CN_OK)
		return call.result;
	if ((world->settings.flags & CN_WORLD_SLEEP) && !(flags & CN_WORLD_SLEEP))
		wake_all(world);
	world->settings.flags = flags;
	return CN_OK;
}

WORLD_GET(worker_count, int32_t, cni_team_workers(world->team))
WORLD_GET(flags, uint32_t, world->settings.flags)

WORLD_SET(restitution_threshold, float, speed_mps, cni_check_at_least(&call, "speed_mps", speed_mps, 0.0f), world->settings.restitution_threshold)
WORLD_SET(hit_speed, float, speed_mps, cni_check_at_least(&call, "speed_mps", speed_mps, 0.0f), world->settings.hit_speed)

cn_result cn_world_set_speed_limits(cn_world *world, float linear_mps, float angular_radps)
{
	cni_call call = cni_enter(world, __func__);
	cni_check_positive(&call, "linear_mps", linear_mps);
	cni_check_positive(&call, "angular_radps", angular_radps);
	if (call.result != CN_OK)
		return call.result;
	world->settings.linear_speed_max = linear_mps;
	world->settings.angular_speed_max = angular_radps;
	return CN_OK;
}

cn_result cn_world_set_sleep(cn_world *world, float speed_mps, float delay_s)
{
	cni_call call = cni_enter(world, __func__);
	cni_check_at_least(&call, "speed_mps", speed_mps, 0.0f);
	cni_check_at_least(&call, "delay_s", delay_s, 0.0f);
	if (call.result != CN_OK)
		return call.result;
	world->settings.sleep_speed = speed_mps;
	world->settings.sleep_delay = delay_s;
	return CN_OK;
}

WORLD_SET(user_data, uint64_t, user_data, (void)0, world->user_data)
WORLD_GET(user_data, uint64_t, world->user_data)

/* ------------------------------------------------------------------ counters */

/* Only islands of two or more bodies have records; a single dynamic body is an island too. */
static void count_islands(const cn_world *world, cn_counters *out)
{
	for (int32_t k = cni_handles_next(&world->body_handles, 0); k != CNI_NONE; k = cni_handles_next(&world->body_handles, k + 1)) {
		const cni_body *b = cni_body_at(world, k);
		if (b->type != CN_BODY_DYNAMIC || !(b->flags & CN_BODY_ENABLED) || b->island != CNI_NONE)
			continue;
		++out->islands;
		out->islands_awake += b->awake != 0;
	}
	out->islands += world->island_count;
	for (int32_t k = 0; k < world->island_used; ++k) {
		const cni_island *island = cni_island_at(world, k);
		out->islands_awake += island->first != CNI_NONE && island->awake;
		out->islands_direct += island->first != CNI_NONE && island->awake && island->tier == CNI_TIER_DIRECT && !world->direct_failed;
		out->islands_unsolved += island->first != CNI_NONE && island->awake && CNI_HAS_DIRECT && cni_island_is_unsolved(island, world->step_count - 1u);
	}
}

static void count_contacts(const cn_world *world, cn_counters *out)
{
	out->contacts = world->contact_count;
	out->contacts_awake = world->apart.count;
	out->contacts_touching = world->touching_count;
	for (int32_t color = 0; color < CNI_COLORS; ++color)
		out->contacts_awake += world->colors[color].lanes;
	for (int32_t color = 0; color < CNI_COLOR_OVERFLOW; ++color)
		out->colors_used += world->colors[color].lanes > 0;
	out->overflow_contacts = world->colors[CNI_COLOR_OVERFLOW].lanes;
}

static cn_counters counters_of(const cn_world *world)
{
	cn_counters c;
	memset(&c, 0, sizeof c);
	c.bodies = world->body_handles.count;
	c.bodies_awake = world->awake_count - 1;
	c.shapes = world->shape_handles.count;
	c.proxies = world->proxy_count;
	count_contacts(world, &c);
	c.joints = world->joint_handles.count;
	c.joints_awake = world->awake_joints.count;
	count_islands(world, &c);
	c.broadphase_tiles = world->broadphase_ops->cells(world->broadphase);
	c.steps = world->step_count;
	c.warnings = world->warnings;
	c.pairs_not_added = world->pairs_not_added;
	c.events_not_reported = world->events_not_reported;
	c.direct_work = world->direct_work;
	return c;
}

static cn_memory_stats memory_stats_of(const cn_world *world)
{
	const cni_memory *memory = &world->memory;
	const cni_arena *arena = &world->arena;
	const cni_blocks *blocks = &world->blocks;
	const cn_memory_stats stats = {
		memory->bytes_in_use, memory->bytes_peak, memory->calls, arena->capacity, arena->high_water, arena->fallbacks, blocks->bytes_in_chunks, blocks->bytes_in_use, blocks->bytes_large
	};
	return stats;
}

WORLD_GET(counters, cn_counters, counters_of(world))
WORLD_GET(profile, cn_profile, world->profile)
WORLD_GET(memory_stats, cn_memory_stats, memory_stats_of(world))
