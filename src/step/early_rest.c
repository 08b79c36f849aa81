/*
 * step/early_rest.c - islands in which nothing happens take one substep instead of all.
 *
 * A body that stands has after a substep the velocity that it had before the step: what gravity gave it the contacts took.
 * The next substeps would be the same again. So after the first one, islands of which every body is so, and hardly moves,
 * are done with: integration leaves their bodies alone, and blocks that hold only their lanes are jumped off the list of
 * the passes. Where such a lane shares a block with one that goes on it is solved with it, which finds nothing to do.
 *
 * For such an island time passes more slowly, and that is all: its substeps are those of any other, and its loads follow as
 * much more slowly, so it is as stable. (To let bodies glide through what is left of the step is not: a pyramid of base 100 begins to sway.) What creeps at
 * less than REST_SPEED creeps slower still; what is about to move gathers speed until it is above, and then moves as
 * it should.
 *
 * It is not done where joints hold an island, nor for kinematic bodies that move.
 *
 * Reads motion, bodies (velocity as the step began), drives, islands; writes drives' flag SWUNG, the block list, and
 * which directly solved systems are done.
 */
#include "step/stages.h"
#include "model/solve.h"
#include "linear/sparse.h"

#include <string.h>

#define REST_SPEED 1e-4f /* length units a second: a thousandth of what gravity gives in a step */
#define HELD_PART 3e-4f  /* of what forces give in a substep that a body which is held may keep */
#define SOLVED_PART 0.2f /* of REST_SPEED that is left by a direct solution, whose iterations end there */
#define RECORDS_AHEAD 8  /* bodies whose records are asked for */
#define BLOCKS_AHEAD 8
#define BODIES_A_RANGE 128

typedef struct rest {
	cn_world *world;
	cni_team *team;     /* NULL: one worker looks, and no farther than it has to */
	uint8_t *moving;    /* by island */
	int32_t *slow;      /* dense indices */
	int32_t slow_count;
	float h;
	float speed_sq, way_sq, little_sq; /* most that a body which rests has, and moves in a substep; what may be left, whatever was given */
	float little, solved;
	int32_t carried;    /* 1 and more: bodies have the flag LATER */
	int32_t done;       /* bodies that are */
	int32_t going;      /* 1: some body goes on */
} rest;

static int32_t is_within(float x, float y, float turn, float most_sq)
{
	return x * x + y * y <= most_sq && turn * turn <= most_sq;
}

/* Only what touches something is solved by passes; neither jointed nor carried bodies may rest. */
static int32_t may_rest(const rest *r, int32_t k)
{
	uint32_t flags = cni_externals(r->world)[k].flags;
	return (flags & (CNI_EXTERNAL_TOUCHED | CNI_EXTERNAL_FREE | CNI_EXTERNAL_FINISHED | CNI_EXTERNAL_JOINTED | CNI_EXTERNAL_DEFERRED)) == CNI_EXTERNAL_TOUCHED;
}

static int32_t stands_still(const cni_motion *m)
{
	return m->vx == 0.0f && m->vy == 0.0f && m->w == 0.0f;
}

/* Slow now, and not jumped: what can be told without the body's record. */
static int32_t body_is_slow(const rest *r, const cni_motion *m, int32_t k)
{
	if (!may_rest(r, k))
		return 0;
	if (m->inv_mass == 0.0f)
		return stands_still(m);
	return is_within(m->vx, m->vy, 0.0f, r->speed_sq) && cni_starts(r->world)[k].jumped == 0.0f;
}

/* What a body that is held may keep of the speed that a substep gives it. */
static float most_left(const rest *r, int32_t k, float extent)
{
	const cni_external *d = cni_externals(r->world) + k;
	int32_t island = cni_awake_island(r->world, k), solved = island != CNI_NONE && cni_island_at(r->world, island)->tier == CNI_TIER_DIRECT;
	float given = r->h * (cni_sqrt(d->ax * d->ax + d->ay * d->ay) + cni_abs(d->alpha) * extent);
	return HELD_PART * given + (solved ? r->solved : r->little);
}

/* Of a slow one: not pushed out of an overlap, and held: what forces gave it in the substep is gone. */
static int32_t body_rests(const rest *r, int32_t k)
{
	const cni_motion *m = cni_motions(r->world) + k;
	const cni_external *d = cni_externals(r->world) + k;
	const cni_body *b;
	float most, vx, vy, turn;
	if (m->inv_mass == 0.0f || (d->flags & CNI_EXTERNAL_DEFERRED))
		return !(d->flags & CNI_EXTERNAL_DEFERRED);
	b = cni_body_at(r->world, cni_awake_ids(r->world)[k]);
	if (!is_within(0.0f, 0.0f, m->w * b->extent, r->speed_sq) || !is_within(m->dpx, m->dpy, m->theta * b->extent, r->way_sq))
		return 0;
	vx = m->vx - b->vx;
	vy = m->vy - b->vy;
	turn = (m->w - b->w) * b->extent;
	if (is_within(vx, vy, turn, r->little_sq))
		return 1;
	most = most_left(r, k, b->extent);
	return is_within(vx, vy, turn, most * most);
}

/* A moving kinematic body carries along what touches it, however slowly. */
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
	return island != CNI_NONE && r->moving[island];
}

/* Which islands surely move, and which bodies are slow, but for those of islands that were found to move: from dense arrays alone. */
static void slow_find(rest *r)
{
	const cni_motion *motions = cni_motions(r->world);
	int32_t k;
	for (k = 1; k < r->world->awake_count; ++k) {
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

/* Slow bodies that do not rest become negative: a look that workers share goes at all of them, before any island is told. */
static void rests_range(void *context, int32_t begin, int32_t end, int32_t worker)
{
	const rest *r = (const rest *)context;
	int32_t n;
	(void)worker;
	for (n = begin; n < end; ++n) {
		if (n + RECORDS_AHEAD < end)
			record_prefetch(r, r->slow[n + RECORDS_AHEAD]);
		if (!is_moving(r, cni_awake_island_number(r->world, r->slow[n])) && !body_rests(r, r->slow[n]))
			r->slow[n] = -r->slow[n];
	}
}

/* One worker stops at the first of an island that does not rest. */
static int32_t slow_rests(const rest *r, int32_t n)
{
	if (r->team != NULL)
		return r->slow[n] > 0;
	if (n + RECORDS_AHEAD < r->slow_count)
		record_prefetch(r, r->slow[n + RECORDS_AHEAD]);
	return body_rests(r, r->slow[n]);
}

/* The slow ones of islands that may be at rest closely. Returns how many rest. Those without an island are done. */
static int32_t moving_find(rest *r)
{
	cni_external *drives = cni_externals(r->world);
	int32_t n, count = 0;
	if (r->team != NULL)
		cni_team_for(r->team, r->slow_count, BODIES_A_RANGE, rests_range, r);
	for (n = 0; n < r->slow_count; ++n) {
		int32_t k = r->slow[n] < 0 ? -r->slow[n] : r->slow[n], island = cni_awake_island_number(r->world, k);
		if (is_moving(r, island))
			continue;
		if (slow_rests(r, n)) {
			++count;
			if (island != CNI_NONE)
				continue;
			drives[k].flags |= CNI_EXTERNAL_FINISHED;
			++r->done;
		} else if (island != CNI_NONE) {
			r->moving[island] = 1;
		}
	}
	return count;
}

/* After moving_find: those of islands in which nothing moves. */
static void islands_done(rest *r)
{
	cni_external *drives = cni_externals(r->world);
	int32_t k;
	for (k = 1; k < r->world->awake_count; ++k) {
		int32_t island;
		if (drives[k].flags & (CNI_EXTERNAL_FREE | CNI_EXTERNAL_FINISHED))
			continue;
		island = may_rest(r, k) ? cni_awake_island_number(r->world, k) : CNI_NONE;
		if (island == CNI_NONE || r->moving[island]) {
			r->going = 1;
			continue;
		}
		drives[k].flags |= CNI_EXTERNAL_FINISHED;
		++r->done;
	}
}

static void carried_clear(const rest *r)
{
	int32_t k;
	for (k = 0; k < r->world->awake_count && r->carried > 0; ++k)
		cni_externals(r->world)[k].flags &= ~(uint32_t)CNI_EXTERNAL_DEFERRED;
}

static int32_t goes_on(const cni_external *drives, int32_t k)
{
	return k != 0 && !(drives[k].flags & CNI_EXTERNAL_FINISHED);
}

static int32_t block_goes_on(const cni_external *drives, const cni_listed_block *b)
{
	int32_t l;
	for (l = 0; l < b->lanes; ++l)
		if (goes_on(drives, b->rows->ia[l]) || goes_on(drives, b->rows->ib[l]))
			return 1;
	return 0;
}

static void block_prefetch(const cni_listed_block *b, int32_t going)
{
	CNI_PREFETCH(&b->info->flags);
	if (!going)
		return;
	CNI_PREFETCH(b->rows->ia);
	CNI_PREFETCH(b->rows->ib);
}

static void blocks_strike(cn_world *world, int32_t going)
{
	const cni_external *drives = cni_externals(world);
	cni_listed_block *list = (cni_listed_block *)world->block_list.data;
	int32_t color, k;
	for (color = 0; color < CNI_COLORS; ++color) {
		cni_color *c = &world->colors[color];
		int32_t kept = 0;
		for (k = 0; k < c->listed_count; ++k) {
			if (k + BLOCKS_AHEAD < c->listed_count)
				block_prefetch(&list[c->listed + k + BLOCKS_AHEAD], going);
			if (going && block_goes_on(drives, &list[c->listed + k]))
				list[c->listed + kept++] = list[c->listed + k];
			else
				list[c->listed + k].info->flags |= CNI_BLOCK_RESTED;
		}
		c->listed_count = kept;
	}
}

/* A system of contacts is an island or a part of one: its first body tells. */
static void systems_done(const cn_world *world, cni_sparse *direct)
{
	int32_t k;
	for (k = 0; direct != NULL && k < direct->component_count; ++k) {
		cni_component *c = &direct->components[k];
		if (c->presses && c->joints == 0 && !goes_on(cni_externals(world), direct->bodies[c->body_begin]))
			c->done = 1;
	}
}

static float square(float x)
{
	return x * x;
}

static void look_at_all(rest *r, const cni_solve *s)
{
	float speed = REST_SPEED * r->world->settings.length_unit;
	r->h = s->h;
	r->little = 0.001f * speed;
	r->solved = SOLVED_PART * speed;
	r->speed_sq = square(speed);
	r->way_sq = square(s->h * speed);
	r->little_sq = square(r->little);
	memset(r->moving, 0, (size_t)r->world->step_island_count);
	slow_find(r);
	if (moving_find(r) > 0)
		islands_done(r);
	if (r->done > 0) {
		blocks_strike(r->world, r->going);
		systems_done(r->world, s->direct);
	}
	carried_clear(r);
}

void cni_rest_find(cn_world *world, const cni_solve *s)
{
	rest r = { world, s->team, NULL, NULL, 0, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0, 0, 0 };
	if (s->substeps < 2)
		return;
	r.moving = (uint8_t *)cni_arena_push(&world->arena, (uint64_t)cni_max_i(world->step_island_count, 1));
	if (r.moving != NULL)
		r.slow = (int32_t *)cni_arena_push(&world->arena, sizeof(int32_t) * (uint64_t)world->awake_count);
	if (r.slow != NULL) /* else everything is solved in every substep */
		look_at_all(&r, s);
	(void)cni_arena_pop(&world->arena, r.slow);
	(void)cni_arena_pop(&world->arena, r.moving);
}
