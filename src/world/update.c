/*
 * world/update.c - variable time: elapsed seconds in, fixed steps out, and poses between the last two.
 *
 * Time that is less than a whole step is kept for the next update; steps beyond the cap are dropped, so that a
 * slow frame does not slow down the next one ("Fix Your Timestep", Fiedler, 2004). Before the last step of an
 * update the poses of awake bodies are stored by slot; nothing is stored before the first update.
 */
#include "step/step.h"
#include "world/error.h"

#include <string.h>

#define STEP_LEAST 1e-9f /* seconds: shorter ones move nothing, and floats do not hold the squares of their inverses */

cn_result cn_world_set_fixed_step(cn_world *world, float step_s, int32_t steps_max)
{
	cni_call call = cni_enter(world, __func__);
	cni_check_positive(&call, "step_s", step_s);
	cni_check_range(&call, "step_s", step_s, 0.0f, 1.0f);
	cni_check_range_int(&call, "steps_max", steps_max, 1, 1000);
	if (call.result != CN_OK)
		return call.result;
	world->fixed_step = step_s;
	world->steps_max = steps_max;
	return CN_OK;
}

static cni_previous *previous_of(const cn_world *world)
{
	return (cni_previous *)world->previous.data;
}

static cn_result previous_reserve(cn_world *world)
{
	int32_t used = cni_handles_used(&world->body_handles), old = world->previous.count;
	if (used <= old)
		return CN_OK;
	if (!cni_array_reserve(&world->previous, &world->memory, used))
		return CN_ERROR_MEMORY;
	memset(previous_of(world) + old, 0, (size_t)(used - old) * sizeof(cni_previous));
	world->previous.count = used;
	return CN_OK;
}

static void previous_keep(cn_world *world)
{
	const int32_t *ids = cni_awake_ids(world);
	for (int32_t k = 1; k < world->awake_count; ++k) {
		const cni_body *b = cni_body_at(world, ids[k]);
		cni_vec2 origin = cni_body_origin(b);
		cni_previous now = { origin.x, origin.y, b->q.c, b->q.s, cni_handles_of(&world->body_handles, ids[k]), world->step_count + 1u };
		previous_of(world)[ids[k]] = now;
	}
}

/* Divides the time owed into steps, dropped and kept time. Beyond 2^24 steps a float has no fraction of a step: all time beyond the cap is
   dropped. */
static cn_update_report report_make(const cn_world *world)
{
	float step = world->fixed_step, owed = world->time_owed, whole = owed / step, most = (float)world->steps_max, taken;
	cn_update_report report;
	memset(&report, 0, sizeof report);
	report.steps = whole < most ? (int32_t)whole : world->steps_max;
	taken = (float)report.steps * step;
	if (whole >= 16777216.0f) {
		report.dropped_s = owed - taken;
	} else {
		report.dropped_s = (float)((int32_t)whole - report.steps) * step;
		report.leftover_s = cni_clamp(owed - report.dropped_s - taken, 0.0f, step);
	}
	report.interpolation = cni_min(report.leftover_s / step, 0.99999994f);
	return report;
}

cn_result cn_world_update(cn_world *world, float elapsed_s, cn_update_report *out)
{
	cni_call call = cni_enter(world, __func__);
	cni_check_range(&call, "elapsed_s", elapsed_s, 0.0f, 10.0f);
	if (call.result == CN_OK)
		cni_check_reserved(&call, previous_reserve(world), "the poses of the previous step");
	if (call.result != CN_OK)
		return call.result;
	world->time_owed += elapsed_s;
	cn_update_report report = report_make(world);
	world->time_owed = report.leftover_s;
	for (int32_t k = 0; k < report.steps; ++k) {
		if (k == report.steps - 1)
			previous_keep(world);
		cn_world_step(world, world->fixed_step);
	}
	if (out != NULL)
		*out = report;
	return CN_OK;
}

cn_pose cni_pose_between(const cn_world *world, int32_t body, float factor)
{
	const cni_body *b = cni_body_at(world, body);
	cni_vec2 origin = cni_body_origin(b);
	cni_rot q = b->q;
	cn_pose pose;
	if (body < world->previous.count && factor < 1.0f) {
		const cni_previous *p = previous_of(world) + body;
		if (p->body == cni_handles_of(&world->body_handles, body) && p->step == world->step_count) {
			origin = cni_lerp(cni_v(p->x, p->y), origin, factor);
			q.c = p->c + factor * (q.c - p->c);
			q.s = p->s + factor * (q.s - p->s);
			if (factor > 0.0f)
				q = q.c != 0.0f || q.s != 0.0f ? cni_rot_normalize(q) : b->q;
		}
	}
	pose.position_m = origin;
	pose.cosine = q.c;
	pose.sine = q.s;
	return pose;
}

cn_result cn_world_step(cn_world *world, float dt_s)
{
	cni_call call = cni_enter(world, "cn_world_step");
	cni_check_range(&call, "dt_s", dt_s, 0.0f, 1.0f);
	if (call.result == CN_OK)
		cni_step(world, dt_s < STEP_LEAST ? 0.0f : dt_s);
	return call.result;
}
