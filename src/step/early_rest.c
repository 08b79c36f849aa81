/*
 * step/early_rest.c - islands at rest take one substep instead of all.
 *
 * A body at rest has the same velocity after a substep as before the step: contacts cancel what gravity adds. Further substeps
 * would repeat the first. So after it, an island in which every body is in this state and hardly moves is finished for this
 * step: integration skips its bodies, and blocks that hold only its lanes are removed from the block list. A lane of such an
 * island in a block with active lanes is still solved, without effect.
 *
 * Time slows down for such an island, and nothing else changes: its substeps are the usual ones, and its loads follow as much
 * more slowly, so it is as stable. (Bodies that would glide through the rest of the step are not: a pyramid of base 100 begins
 * to sway.) A creep below CNI_REST_SPEED slows down further; a body about to move gains speed until it is above CNI_REST_SPEED, and then
 * moves normally.
 *
 * The pass skips islands with joints, and moving kinematic bodies.
 *
 * Reads motion, bodies (velocity at the step's beginning), external accelerations, islands; writes the flag
 * CNI_EXTERNAL_FINISHED, the block list, and the done flags of directly solved systems.
 */
#include "step/stages.h"
#include "linear/sparse.h"

#include <string.h>

#define RECORDS_AHEAD 8  /* bodies whose records are asked for */
#define BLOCKS_AHEAD 8
#define BODIES_A_RANGE 128

typedef struct rest {
	cn_world *world;
	cni_team *team;
	uint32_t *moving;   /* by island */
	int32_t *slow;      /* dense indices */
	int32_t slow_count;
	float h;
	float speed_sq, move_sq, residual_sq; /* limits at rest: speed, movement in a substep, residual velocity */
	float residual, solved;
	int32_t carried;    /* > 0: bodies have the flag DEFERRED */
	int32_t done;       /* finished bodies */
	int32_t active;     /* 1: some body is still active */
} rest;

static int32_t is_within(float x, float y, float turn, float most_sq)
{
	return x * x + y * y <= most_sq && turn * turn <= most_sq;
}

/* Only bodies with contacts are solved by passes; neither jointed nor carried bodies may rest. */
static int32_t may_rest(const rest *r, int32_t k)
{
	uint32_t flags = cni_externals(r->world)[k].flags;
	return (flags & (CNI_EXTERNAL_TOUCHED | CNI_EXTERNAL_FREE | CNI_EXTERNAL_FINISHED | CNI_EXTERNAL_JOINTED | CNI_EXTERNAL_DEFERRED)) == CNI_EXTERNAL_TOUCHED;
}

static int32_t stands_still(const cni_motion *m)
{
	return m->vx == 0.0f && m->vy == 0.0f && m->w == 0.0f;
}

/* Slow and without an impact, as far as dense arrays show. */
static int32_t body_is_slow(const rest *r, const cni_motion *m, int32_t k)
{
	if (!may_rest(r, k))
		return 0;
	if (m->inv_mass == 0.0f)
		return stands_still(m);
	return is_within(m->vx, m->vy, 0.0f, r->speed_sq) && cni_starts(r->world)[k].jumped == 0.0f;
}

/* Limit of the velocity that a held body may keep of a substep's forces. */
static float most_left(const rest *r, int32_t k, float extent)
{
	const cni_external *d = cni_externals(r->world) + k;
	int32_t island = cni_awake_island(r->world, k), solved = island != CNI_NONE && cni_island_at(r->world, island)->tier == CNI_TIER_DIRECT;
	float given = r->h * (cni_sqrt(d->ax * d->ax + d->ay * d->ay) + cni_abs(d->alpha) * extent);
	return CNI_REST_HELD_PART * given + (solved ? r->solved : r->residual);
}

/* Does a slow body rest: not pushed out of an overlap, and held, so that contacts cancel a substep's forces? */
static int32_t body_rests(const rest *r, int32_t k)
{
	const cni_motion *m = cni_motions(r->world) + k;
	const cni_external *d = cni_externals(r->world) + k;
	if (m->inv_mass == 0.0f || (d->flags & CNI_EXTERNAL_DEFERRED))
		return !(d->flags & CNI_EXTERNAL_DEFERRED);
	const cni_body *b = cni_body_at(r->world, cni_awake_ids(r->world)[k]);
	if (!is_within(0.0f, 0.0f, m->w * b->extent, r->speed_sq) || !is_within(m->dpx, m->dpy, m->theta * b->extent, r->move_sq))
		return 0;
	float vx = m->vx - b->vx;
	float vy = m->vy - b->vy;
	float turn = (m->w - b->w) * b->extent;
	if (is_within(vx, vy, turn, r->residual_sq))
		return 1;
	float most = most_left(r, k, b->extent);
	return is_within(vx, vy, turn, most * most);
}

/* Marks the bodies that touch a moving kinematic body: it carries them, however slowly. */
static int32_t carried_mark(const rest *r, int32_t index)
{
	int32_t body = cni_awake_ids(r->world)[index], key, count = 0;
	for (key = cni_body_at(r->world, body)->contact_first; key != CNI_NONE; key = cni_contact_of_key(r->world, key)->next[key & 1]) {
		int32_t other = cni_body_at(r->world, cni_contact_of_key(r->world, key)->body[1 - (key & 1)])->awake;
		cni_externals(r->world)[other].flags |= CNI_EXTERNAL_DEFERRED;
		++count;
	}
	return count;
}

static int32_t is_moving(const rest *r, int32_t island)
{
	return island != CNI_NONE && cni_atomic_peek(&r->moving[island]);
}

/* Finds islands that certainly move, and slow bodies of the others, from dense arrays alone. */
static void slow_find(rest *r)
{
	const cni_motion *motions = cni_motions(r->world);
	for (int32_t k = 1; k < r->world->awake_count; ++k) {
		int32_t island = cni_awake_island_number(r->world, k);
		if (motions[k].inv_mass == 0.0f && !stands_still(&motions[k]))
			r->carried += carried_mark(r, k);
		if (is_moving(r, island))
			continue;
		if (body_is_slow(r, &motions[k], k))
			r->slow[r->slow_count++] = k;
		else if (island != CNI_NONE)
			r->moving[island] = 1;
	}
}

static void record_prefetch(const rest *r, int32_t k)
{
	const cni_body *b = cni_body_at(r->world, cni_awake_ids(r->world)[k]);
	if (is_moving(r, cni_awake_island_number(r->world, k)))
		return;
	CNI_PREFETCH(&b->extent);
	CNI_PREFETCH(&b->w);
}

/* Marks islands at their first slow body that does not rest; such bodies without an island are dropped from the list: their index becomes 0. */
static void rests_range(void *context, int32_t begin, int32_t end)
{
	const rest *r = (const rest *)context;
	for (int32_t n = begin; n < end; ++n) {
		int32_t island = cni_awake_island_number(r->world, r->slow[n]);
		if (n + RECORDS_AHEAD < end)
			record_prefetch(r, r->slow[n + RECORDS_AHEAD]);
		if (is_moving(r, island) || body_rests(r, r->slow[n]))
			continue;
		if (island != CNI_NONE)
			cni_atomic_put(&r->moving[island], 1);
		else
			r->slow[n] = 0;
	}
}

/* Checks the slow bodies of islands that may rest, and returns how many rest. Bodies without an island are finished here. */
static int32_t moving_find(rest *r)
{
	int32_t count = 0;
	cni_team_for(r->team, r->slow_count, BODIES_A_RANGE, rests_range, r);
	for (int32_t n = 0; n < r->slow_count; ++n) {
		int32_t k = r->slow[n], island = cni_awake_island_number(r->world, k);
		if (k == 0 || is_moving(r, island))
			continue;
		++count;
		if (island != CNI_NONE)
			continue;
		cni_externals(r->world)[k].flags |= CNI_EXTERNAL_FINISHED;
		++r->done;
	}
	return count;
}

/* After moving_find: finishes the bodies of islands in which nothing moves. */
static void islands_done(rest *r)
{
	cni_external *externals = cni_externals(r->world);
	for (int32_t k = 1; k < r->world->awake_count; ++k) {
		if (externals[k].flags & (CNI_EXTERNAL_FREE | CNI_EXTERNAL_FINISHED))
			continue;
		int32_t island = may_rest(r, k) ? cni_awake_island_number(r->world, k) : CNI_NONE;
		if (island == CNI_NONE || r->moving[island]) {
			r->active = 1;
			continue;
		}
		externals[k].flags |= CNI_EXTERNAL_FINISHED;
		++r->done;
	}
}

static int32_t is_active(const cni_external *externals, int32_t k)
{
	return k != 0 && !(externals[k].flags & CNI_EXTERNAL_FINISHED);
}

static int32_t block_is_active(const cni_external *externals, const cni_listed_block *b)
{
	for (int32_t l = 0; l < b->lanes; ++l)
		if (is_active(externals, b->rows->ia[l]) || is_active(externals, b->rows->ib[l]))
			return 1;
	return 0;
}

static void block_prefetch(const cni_listed_block *b, int32_t active)
{
	CNI_PREFETCH(&b->info->flags);
	if (!active)
		return;
	CNI_PREFETCH(b->rows->ia);
	CNI_PREFETCH(b->rows->ib);
}

/* Keeps the blocks begin .. end - 1 of a colour's list, behind those kept so far, if one is active. Returns how many. */
static int32_t group_unlist(const cni_external *externals, cni_listed_block *list, int32_t begin, int32_t end, int32_t kept, int32_t active)
{
	int32_t is_kept = 0;
	for (int32_t k = begin; k < end && active && !is_kept; ++k)
		is_kept = block_is_active(externals, &list[k]);
	for (int32_t k = begin; k < end; ++k) {
		if (is_kept)
			list[kept + k - begin] = list[k];
		else
			list[k].info->flags |= CNI_BLOCK_RESTED;
	}
	return is_kept ? end - begin : 0;
}

static void blocks_unlist(cn_world *world, int32_t active)
{
	const cni_external *externals = cni_externals(world);
	cni_listed_block *list = (cni_listed_block *)world->block_list.data;
	for (int32_t color = 0; color < CNI_COLORS; ++color) {
		cni_color *c = &world->colors[color];
		int32_t kept = 0;
		for (int32_t k = 0; k < c->listed_count; k += CNI_BLOCKS_A_GROUP) {
			if (k + BLOCKS_AHEAD < c->listed_count)
				block_prefetch(&list[c->listed + k + BLOCKS_AHEAD], active);
			kept += group_unlist(externals, list + c->listed, k, cni_min_i(k + CNI_BLOCKS_A_GROUP, c->listed_count), kept, active);
		}
		c->listed_count = kept;
	}
}

/* A system of contacts is an island or a part of one: its first body decides. */
static void systems_done(const cn_world *world, cni_sparse *direct)
{
	for (int32_t k = 0; direct != NULL && k < direct->component_count; ++k) {
		cni_component *c = &direct->components[k];
		if (c->has_contacts && c->joints == 0 && !is_active(cni_externals(world), direct->bodies[c->body_begin]))
			c->done = 1;
	}
}

static void rest_run(rest *r, const cni_solve *s)
{
	float speed = CNI_REST_SPEED * r->world->settings.length_unit;
	r->h = s->h;
	r->residual = 0.001f * speed;
	r->solved = CNI_REST_SOLVED_PART * speed;
	r->speed_sq = cni_sq(speed);
	r->move_sq = cni_sq(s->h * speed);
	r->residual_sq = cni_sq(r->residual);
	memset(r->moving, 0, sizeof(uint32_t) * (size_t)r->world->step_island_count);
	slow_find(r);
	if (moving_find(r) > 0)
		islands_done(r);
	if (r->done > 0) {
		blocks_unlist(r->world, r->active);
		systems_done(r->world, s->direct);
	}
	for (int32_t k = 0; k < r->world->awake_count && r->carried > 0; ++k)
		cni_externals(r->world)[k].flags &= ~(uint32_t)CNI_EXTERNAL_DEFERRED;
}

void cni_rest_find(cn_world *world, const cni_solve *s)
{
	rest r = { world, s->team, NULL, NULL, 0, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0, 0, 0 };
	if (s->substeps < 2)
		return;
	r.moving = (uint32_t *)cni_scratch_push(world, sizeof(int32_t) * (uint64_t)(world->step_island_count + world->awake_count));
	if (r.moving == NULL)
		return; /* all substeps solve everything */
	r.slow = (int32_t *)(void *)(r.moving + world->step_island_count);
	rest_run(&r, s);
	(void)cni_arena_pop(&world->arena, r.moving);
}
