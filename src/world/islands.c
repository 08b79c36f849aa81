/*
 * world/islands.c - the report on awake islands: the parts of each, its tier and the reason, and the largest error of its
 * contacts and joints.
 *
 * Everything is computed on request: the step only stores the reason of the tier in each island's record
 * (direct/solver_selection.c). Contacts are collided again at the present poses. Writes nothing.
 */
#include "joints/joint_type.h"
#include "direct/direct.h"
#include "narrowphase/touch.h"
#include "world/error.h"

#include <string.h>

/* ---- parts and errors ---- */

/* Whether the pre-solve callback let the pair pass through each other: both effective masses are then 0. */
static int32_t contact_passes_through(const cn_world *world, const cni_contact *c)
{
	const cni_contact_block *block = cni_block_at(world, c->slot / CNI_LANES);
	int32_t l = c->slot % CNI_LANES;
	return (c->flags & CNI_CONTACT_PRE_SOLVE) && block->p[0].nm[l] == 0.0f && block->p[1].nm[l] == 0.0f;
}

/* Present depth of the overlap of two shapes, 0 without one. */
static float overlap_of(const cn_world *world, int32_t contact)
{
	cni_touch_pair pair = cni_touch_pair_of(world, cni_contact_at(world, contact), contact);
	cni_contact c = *pair.contact; /* a copy: colliding stores hints in the contact */
	cni_touch touch;
	float deepest = 0.0f;
	pair.contact = &c;
	if (contact_passes_through(world, &c) || !cni_touch_begin(world, &pair, 0.0f, &touch))
		return 0.0f;
	cni_touch_collide(&touch);
	for (int32_t k = 0; k < touch.result.manifold.count; ++k)
		deepest = cni_max(deepest, -touch.result.manifold.points[k].separation);
	return deepest;
}

/* Gap of a rigid joint in metres; 0 for joints that may yield. */
static float gap_of(const cn_world *world, const cni_joint *j)
{
	float metres, radians, extent = 0.0f;
	if (j->stiffness_hertz > 0.0f || j->force_max > 0.0f || j->torque_max > 0.0f)
		return 0.0f;
	for (int32_t side = 0; side < 2; ++side)
		if (cni_is_dynamic(world, j->body[side]))
			extent = cni_max(extent, cni_body_at(world, j->body[side])->extent);
	cni_joint_error(world, j, &metres, &radians);
	return cni_max(metres, extent * radians);
}

/* Adds a body. A contact or joint of two dynamic bodies is in both lists and counts with its first body. */
static void report_add_body(const cn_world *world, int32_t body, cn_island_report *out)
{
	const cni_body *b = cni_body_at(world, body);
	++out->bodies;
	for (int32_t key = b->contact_first; key != CNI_NONE; key = cni_contact_of_key(world, key)->next[key & 1]) {
		const cni_contact *c = cni_contact_of_key(world, key);
		if (!(c->flags & CNI_CONTACT_TOUCHING) || ((key & 1) && cni_is_dynamic(world, c->body[0])))
			continue;
		++out->contacts;
		out->residual_m = cni_max(out->residual_m, overlap_of(world, key >> 1));
	}
	for (int32_t key = b->joint_first; key != CNI_NONE; key = cni_joint_at(world, key >> 1)->next[key & 1]) {
		const cni_joint *j = cni_joint_at(world, key >> 1);
		if (j->awake == CNI_NONE || ((key & 1) && cni_is_dynamic(world, j->body[0])))
			continue;
		++out->joints;
		out->residual_m = cni_max(out->residual_m, gap_of(world, j));
	}
}

/* One where the island of a body rests: see step/early_rest.c. Jointed bodies with these flags swing freely. */
static int32_t substeps_of(const cn_world *world, const cni_body *b)
{
	const uint32_t rests = CNI_EXTERNAL_FINISHED | CNI_EXTERNAL_TOUCHED;
	int32_t rested = (cni_externals(world)[b->awake].flags & (rests | CNI_EXTERNAL_JOINTED)) == rests;
	return world->settings.solver == CN_SOLVER_SEQUENTIAL || rested ? 1 : world->settings.substeps;
}

/* ---- tier and reason ---- */

/* The reason in a soft island's record is valid while direct solving is refused, or if the last step found a problem. */
static int32_t soft_reason(const cn_world *world, const cni_island *i)
{
	if (world->settings.solver == CN_SOLVER_SOFT || world->settings.solver == CN_SOLVER_SEQUENTIAL)
		return CN_TIER_REASON_SOLVER;
	if (i->solver == CN_SOLVER_SOFT)
		return CN_TIER_REASON_OVERRIDE;
	if (i->looked_step == world->step_count || cni_island_is_refused(i, world->step_count - 1u))
		return i->reason;
	return CN_TIER_REASON_NONE;
}

/* A problem in the last step sets good_steps to 0. The step stores a reason for every problem except stress. */
static int32_t direct_reason(const cn_world *world, const cni_island *i)
{
	if (world->settings.solver == CN_SOLVER_DIRECT)
		return CN_TIER_REASON_SOLVER;
	if (i->solver == CN_SOLVER_DIRECT)
		return CN_TIER_REASON_OVERRIDE;
	return i->reason == CN_TIER_REASON_SETTLING && i->good_steps == 0 ? CN_TIER_REASON_STRESSED : i->reason;
}

static void report_tier(const cn_world *world, const cni_island *i, cn_island_report *out)
{
	if (out->contacts == 0 && out->joints == 0) {
		out->tier = CN_TIER_FREE;
	} else if (i == NULL) {
		out->reason = CN_TIER_REASON_ALONE;
	} else if (i->tier == CNI_TIER_DIRECT && world->direct_failed) {
		out->reason = CN_TIER_REASON_MEMORY;
	} else if (i->tier == CNI_TIER_DIRECT) {
		out->tier = CN_TIER_DIRECT;
		out->reason = direct_reason(world, i);
	} else {
		out->reason = soft_reason(world, i);
	}
}

/* i: NULL for a body without an island. first: the first body of its list. */
static void report_make(const cn_world *world, const cni_island *i, int32_t first, cn_island_report *out)
{
	int32_t lowest = first;
	memset(out, 0, sizeof *out);
	out->substeps = substeps_of(world, cni_body_at(world, first));
	for (int32_t body = first; body != CNI_NONE; body = cni_body_at(world, body)->island_next) {
		lowest = cni_min_i(lowest, body);
		report_add_body(world, body, out);
	}
	out->body = cni_handles_of(&world->body_handles, lowest);
	report_tier(world, i, out);
}

/* ---- all of them ---- */

static int32_t body_is_awake_alone(const cn_world *world, int32_t body)
{
	const cni_body *b = cni_body_at(world, body);
	return b->type == CN_BODY_DYNAMIC && b->awake != 0 && b->island == CNI_NONE;
}

cn_result cn_world_get_islands(const cn_world *world, cn_island_report *out, int32_t capacity, int32_t *out_count)
{
	cni_call call = cni_enter_const(world);
	int32_t count = 0;
	cni_check_output(&call, out, capacity, out_count);
	if (call.result != CN_OK)
		return call.result;
	for (int32_t k = 0; k < world->island_used; ++k) {
		const cni_island *i = cni_island_at(world, k);
		if (i->first == CNI_NONE || !i->awake)
			continue;
		if (count < capacity)
			report_make(world, i, i->first, &out[count]);
		++count;
	}
	for (int32_t k = cni_handles_next(&world->body_handles, 0); k != CNI_NONE; k = cni_handles_next(&world->body_handles, k + 1)) {
		if (!body_is_awake_alone(world, k))
			continue;
		if (count < capacity)
			report_make(world, NULL, k, &out[count]);
		++count;
	}
	*out_count = count;
	return CN_OK;
}
