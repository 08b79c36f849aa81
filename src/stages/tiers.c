/*
 * stages/tiers.c - which islands are solved directly in this step, contacts and all.
 *
 * Soft contacts settle from impulse to impulse: exact at rest, but a pile that was just put together sags for
 * seconds while its weight travels down, and much weight on little mass crushes what bears it. A quiet island with a contact that
 * is new or that overlaps by more than a part of the accuracy is solved directly (stages/contact_direct.c) until it has been good for
 * a while; the loads it then has are exact, and the soft solver goes on from them. The stay doubles each time
 * it turns bad again. An island whose system has been refused, for its work, for what it is made of, or because no consistent set was found, is
 * left alone for a time.
 *
 * A scene in which nothing is wrong pays for one look at the separations of its lanes.
 *
 * CN_SOLVER_DIRECT takes every island, quiet or not, and never gives it back.
 *
 * Reads lanes, islands, motion; writes islands' tier fields and world->direct_islands.
 */
#include "stages/contact_direct.h"
#include "stages/solver.h"

#define ISLANDS_MOST 64        /* solved directly at the same time, of CN_SOLVER_AUTO */
#define OVERLAP_PART 0.1f      /* of the accuracy: more is bad */
#define QUIET_SPEED 0.5f       /* length units a second: what moves faster is no pile */
#define STAY_FIRST 15          /* good steps until an island is given back, the first time */
#define STAY_FACTOR 4          /* ... and each time it turned bad again after that */
#define STAY_MOST 100000
#define REFUSED_STEPS 120      /* until a refused island is looked at again */

static int32_t *listed(const cn_world *world)
{
	return (int32_t *)world->direct_islands.data;
}

static int32_t body_is_quiet(const cn_world *world, const cni_body *b)
{
	const cni_motion *m = cni_motions(world) + b->awake;
	float most = QUIET_SPEED * world->settings.length_unit, turn = m->w * b->extent;
	return m->vx * m->vx + m->vy * m->vy <= most * most && turn * turn <= most * most;
}

static int32_t island_is_quiet(const cn_world *world, const cni_island *i)
{
	int32_t body;
	for (body = i->first; body != CNI_NONE; body = cni_body_at(world, body)->island_next)
		if (!body_is_quiet(world, cni_body_at(world, body)))
			return 0;
	return 1;
}

static void island_take(cn_world *world, int32_t island)
{
	cni_island *i = cni_island_at(world, island);
	if (!cni_array_reserve(&world->direct_islands, &world->memory, world->direct_islands.count + 1)) {
		world->warnings |= CN_WARNING_FRAME_MEMORY;
		return;
	}
	i->tier = CNI_TIER_DIRECT;
	i->good_steps = 0;
	listed(world)[world->direct_islands.count++] = island;
}

/* Something is wrong in it. */
static void island_is_bad(cn_world *world, int32_t island)
{
	cni_island *i = cni_island_at(world, island);
	i->good_steps = 0;
	if (i->tier == CNI_TIER_DIRECT || i->looked_step == world->step_count + 1u)
		return;
	i->looked_step = world->step_count + 1u;
	if (i->refused_steps > 0 && world->step_count - i->refused_step < (uint32_t)i->refused_steps)
		return;
	if (world->direct_islands.count < ISLANDS_MOST && 2 * i->count <= CNI_PRESS_MOST && island_is_quiet(world, i))
		island_take(world, island);
}

void cni_island_refuse(cn_world *world, int32_t island)
{
	cni_island *i = cni_island_at(world, island);
	i->tier = CNI_TIER_SOFT;
	i->refused_step = world->step_count;
	i->refused_steps = cni_min_i(i->refused_steps > 0 ? 2 * i->refused_steps : REFUSED_STEPS, 16 * REFUSED_STEPS);
}

/* ---- looking for what is wrong ---- */

static float overlap(const cni_contact_block *k, int32_t l)
{
	return cni_max(k->p[0].nm[l] > 0.0f ? -k->p[0].s0[l] : -FLT_MAX, k->p[1].nm[l] > 0.0f ? -k->p[1].s0[l] : -FLT_MAX);
}

static int32_t lane_is_new(const cni_contact_block *k, int32_t l, float slop)
{
	return k->p[0].jn[l] + k->p[1].jn[l] == 0.0f && overlap(k, l) > -0.1f * slop;
}

static void block_look(cn_world *world, int32_t block, float most)
{
	const cni_contact_block *k = cni_block_at(world, block);
	const cni_block_info *info = cni_block_info_at(world, block);
	int32_t l, fresh = info->fresh_step == world->step_count + 1u;
	for (l = 0; l < CNI_LANES; ++l) {
		int32_t island;
		if (!(k->p[0].s0[l] < -most || k->p[1].s0[l] < -most || fresh) || info->contact[l] == CNI_NONE)
			continue;
		if (overlap(k, l) <= most && !(fresh && lane_is_new(k, l, world->settings.slop)))
			continue;
		island = cni_body_at(world, cni_awake_ids(world)[k->ia[l]])->island;
		if (island != CNI_NONE)
			island_is_bad(world, island);
	}
}

static void lanes_look(cn_world *world)
{
	float most = OVERLAP_PART * world->settings.accuracy;
	int32_t color, block;
	for (color = 0; color < CNI_COLORS; ++color)
		for (block = world->colors[color].first; block != CNI_NONE; block = cni_block_info_at(world, block)->next)
			block_look(world, block, most);
}

/* Islands that have been good for long enough, have fallen asleep, or are no more. */
static void list_update(cn_world *world)
{
	int32_t k, kept = 0;
	for (k = 0; k < world->direct_islands.count; ++k) {
		int32_t island = listed(world)[k];
		cni_island *i = cni_island_at(world, island);
		if (i->first == CNI_NONE || !i->awake || i->tier != CNI_TIER_DIRECT)
			continue;
		if (i->good_steps++ < cni_max_i(i->stay_steps, STAY_FIRST)) {
			listed(world)[kept++] = island;
			continue;
		}
		i->tier = CNI_TIER_SOFT;
		i->stay_steps = cni_min_i(STAY_FACTOR * cni_max_i(i->stay_steps, STAY_FIRST), STAY_MOST);
	}
	world->direct_islands.count = kept;
}

/* Every island that is awake. */
static void list_all(cn_world *world)
{
	int32_t k;
	for (k = 0; k < world->direct_islands.count; ++k)
		cni_island_at(world, listed(world)[k])->tier = CNI_TIER_SOFT;
	world->direct_islands.count = 0;
	for (k = 1; k < world->awake_count; ++k) {
		int32_t island = cni_body_at(world, cni_awake_ids(world)[k])->island;
		if (island != CNI_NONE && cni_island_at(world, island)->tier != CNI_TIER_DIRECT)
			island_take(world, island);
	}
}

void cni_stage_tiers(cn_world *world)
{
	if (world->settings.solver == CN_SOLVER_DIRECT) {
		list_all(world);
	} else if (world->settings.solver == CN_SOLVER_AUTO) {
		list_update(world);
		lanes_look(world);
	}
}
