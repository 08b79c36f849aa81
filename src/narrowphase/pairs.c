/*
 * narrowphase/pairs.c - stage 2: creates contacts of pairs whose boxes began to overlap.
 *
 * Reads proxies and filters through the broadphase, writes contacts. Pairs are sorted, so contacts are created in the same order
 * with any broadphase. A pair without memory for its contact is counted, and its proxy touched so that the next step reports it
 * again.
 *
 * Crowds: the broadphase bounds the pairs of one update (broadphase/pair_list.c), this stage all contacts. In a world with more
 * than cni_pairs_limit contacts, a pair of which both bodies have many is left out, but not one with a fixed body (static or
 * kinematic), or a crowd would fall through the ground. In each step one in CROWD_TURNS of the
 * proxies that miss a pair is touched, until nothing is left out; until then their bodies do not fall asleep.
 */
#include "narrowphase/narrowphase.h"

#define CROWD_TURNS 16       /* steps until a proxy that misses a pair has its next turn */
#define CONTACTS_MANY 16     /* of each of two bodies */
#define CONTACTS_FIXED 256   /* with fixed bodies, of a body that meets another one */

static void pair_retry_later(cn_world *world, const cni_pair *pair)
{
	world->broadphase_ops->touch(world->broadphase, pair->a);
	world->pairs_may_repeat |= CNI_PAIRS_ALL;
	world->warnings |= CN_WARNING_CONTACT_MEMORY;
	++world->pairs_not_added;
}

/* Extends the boxes of bodies whose velocity the user set since the last step. */
static void kicked_extend_boxes(cn_world *world, float dt)
{
	for (int32_t k = 0; k < world->kicked.count; ++k) {
		int32_t body = cni_handles_find(&world->body_handles, ((const cn_body *)world->kicked.data)[k]);
		cni_body *b = body == CNI_NONE ? NULL : cni_body_at(world, body);
		if (b == NULL)
			continue;
		b->flags &= ~(uint32_t)CNI_BODY_KICKED;
		if (b->awake != 0)
			(void)cni_body_boxes_set(world, b, cni_mul(dt, cni_body_velocity(world, b).linear_mps), world);
	}
	world->kicked.count = 0;
}

/* A sleeping body may have a contact whose boxes separated in the last step before sleep; that contact ends on waking. */
static int32_t is_asleep(const cni_body *b)
{
	return b->awake == 0 && b->type != CN_BODY_STATIC;
}

/* Does the pair have a contact already? Most pairs need no lookup: only sleep, marks and CNI_PAIRS_ALL can cause repeats. */
static int32_t pair_repeats(const cn_world *world, const cni_pair *pair, const cni_body *a, const cni_body *b, int32_t may_repeat)
{
	if ((may_repeat & CNI_PAIRS_ALL) == CNI_PAIRS_ALL || is_asleep(a) || is_asleep(b) || (may_repeat && ((a->flags | b->flags) & CNI_BODY_AGAIN)))
		return cni_contact_find(world, pair->a, pair->b) != CNI_NONE;
	CNI_ASSERT(cni_contact_find(world, pair->a, pair->b) == CNI_NONE);
	return 0;
}

/* Bodies that are not awake keep their mark, which costs lookups only. */
static void marks_clear(const cn_world *world)
{
	for (int32_t k = 1; k < world->awake_count; ++k)
		cni_body_at(world, cni_awake_ids(world)[k])->flags &= ~(uint32_t)CNI_BODY_AGAIN;
}

/* ---- crowds ---- */

/* Gives the proxies whose turn it is another search, and keeps all that miss a pair awake. Returns CNI_PAIRS_MARKED, as contacts of the
   touched ones are found again, and CNI_PAIRS_CROWDED while others wait. */
static int32_t crowd_turn(cn_world *world)
{
	int32_t found = 0;
	for (int32_t id = 0; id < world->proxy_used; ++id) {
		if ((cni_proxy_at(world, id)->flags & (CNI_PROXY_ALIVE | CNI_PROXY_CROWDED)) != (CNI_PROXY_ALIVE | CNI_PROXY_CROWDED))
			continue;
		cni_body_wake(world, cni_shape_at(world, cni_proxy_at(world, id)->shape)->body);
		if (((uint32_t)id + world->step_count) % CROWD_TURNS != 0) {
			found |= CNI_PAIRS_CROWDED;
			continue;
		}
		cni_proxy_at(world, id)->flags &= ~(uint32_t)CNI_PROXY_CROWDED;
		cni_body_at(world, cni_shape_at(world, cni_proxy_at(world, id)->shape)->body)->flags |= CNI_BODY_AGAIN;
		world->broadphase_ops->touch(world->broadphase, id);
		found |= CNI_PAIRS_MARKED;
	}
	return found;
}

static int32_t is_fixed(const void *context, int32_t proxy)
{
	const cn_world *world = (const cn_world *)context;
	return cni_is_dynamic(world, cni_shape_at(world, cni_proxy_at(world, proxy)->shape)->body) == 0;
}

static int32_t has_fixed(const cni_body *a, const cni_body *b)
{
	return a->type != CN_BODY_DYNAMIC || b->type != CN_BODY_DYNAMIC;
}

/* Has the body CONTACTS_FIXED contacts with fixed bodies? */
static int32_t has_many_fixed(const cn_world *world, const cni_body *b)
{
	int32_t key, next, count = 0;
	for (key = b->contact_count < CONTACTS_FIXED ? CNI_NONE : b->contact_first; key != CNI_NONE && count < CONTACTS_FIXED; key = next) {
		const cni_contact *c = cni_contact_of_key(world, key);
		next = c->next[key & 1];
		count += cni_body_at(world, c->body[1 - (key & 1)])->type != CN_BODY_DYNAMIC;
	}
	return count >= CONTACTS_FIXED;
}

static int32_t crowd_leaves_out(const cn_world *world, const cni_body *a, const cni_body *b)
{
	if (world->contact_count < cni_pairs_limit(world->proxy_count))
		return 0;
	if (has_fixed(a, b))
		return has_many_fixed(world, a->type == CN_BODY_DYNAMIC ? a : b);
	return cni_min_i(a->contact_count, b->contact_count) >= CONTACTS_MANY;
}

static void crowd_note(cn_world *world, int32_t pairs, int32_t with_fixed)
{
	world->pairs_may_repeat |= CNI_PAIRS_CROWDED | (with_fixed ? CNI_PAIRS_CROWDED_FIXED : 0);
	world->pairs_not_added += cni_min_i(pairs, INT32_MAX - world->pairs_not_added);
}

/* ---- contacts of the pairs ---- */

/* So many pairs ahead each is asked for, when what leads to it has come: shapes, bodies, the heads of their lists of contacts. */
#define SHAPES_AHEAD 12
#define BODIES_AHEAD 8
#define HEADS_AHEAD 4
#define MEMBERS_KEPT 16

/* Shapes and bodies of the pairs ahead, each found once: pair k is at k % MEMBERS_KEPT. */
typedef struct pair_members {
	const cni_shape *shape[2];
	cni_body *body[2];
} pair_members;

typedef struct pairs_loop {
	const cn_world *world;
	const cni_pair *list;
	int32_t count;
	pair_members members[MEMBERS_KEPT];
} pairs_loop;

typedef char cni_pairs_finds_far_enough[SHAPES_AHEAD < MEMBERS_KEPT ? 1 : -1];

CNI_INLINE pair_members *members_of(pairs_loop *loop, int32_t k) { return &loop->members[(uint32_t)k % MEMBERS_KEPT]; }

/* These are forced inline: compilers treat a function that only prefetches as having no effect. */
CNI_INLINE void shapes_find(pairs_loop *loop, int32_t k)
{
	pair_members *m = members_of(loop, k);
	if (k >= loop->count)
		return;
	m->shape[0] = cni_shape_at(loop->world, cni_proxy_at(loop->world, loop->list[k].a)->shape);
	m->shape[1] = cni_shape_at(loop->world, cni_proxy_at(loop->world, loop->list[k].b)->shape);
	CNI_PREFETCH(m->shape[0]);
	CNI_PREFETCH(m->shape[1]);
}

CNI_INLINE void bodies_find(pairs_loop *loop, int32_t k)
{
	pair_members *m = members_of(loop, k);
	for (int32_t side = 0; side < 2 && k < loop->count; ++side) {
		m->body[side] = cni_body_at(loop->world, m->shape[side]->body);
		CNI_PREFETCH(&m->body[side]->flags);
		CNI_PREFETCH(&m->body[side]->contact_first);
	}
}

CNI_INLINE void heads_prefetch(pairs_loop *loop, int32_t k)
{
	const pair_members *m = members_of(loop, k);
	for (int32_t side = 0; side < 2 && k < loop->count; ++side)
		if (m->body[side]->contact_first != CNI_NONE)
			CNI_PREFETCH(cni_contact_of_key(loop->world, m->body[side]->contact_first)->prev);
}

static void pair_add(cn_world *world, const cni_pair *pair, const pair_members *m, int32_t may_repeat)
{
	cni_body *a = m->body[0], *b = m->body[1];
	if (pair_repeats(world, pair, a, b, may_repeat))
		return;
	if (crowd_leaves_out(world, a, b)) {
		cni_proxy_at(world, pair->a)->flags |= CNI_PROXY_CROWDED;
		crowd_note(world, 1, has_fixed(a, b));
	} else if (cni_contact_reserve(world, 1) != CN_OK) {
		pair_retry_later(world, pair);
	} else {
		cni_contact_create(world, pair->a, pair->b);
	}
}

static void pairs_add(cn_world *world, int32_t may_repeat)
{
	pairs_loop loop;
	loop.world = world;
	loop.list = (const cni_pair *)world->pairs.list.data;
	loop.count = world->pairs.list.count;
	for (int32_t k = 0; k < SHAPES_AHEAD; ++k)
		shapes_find(&loop, k);
	for (int32_t k = 0; k < BODIES_AHEAD; ++k)
		bodies_find(&loop, k);
	for (int32_t k = 0; k < loop.count; ++k) {
		shapes_find(&loop, k + SHAPES_AHEAD);
		bodies_find(&loop, k + BODIES_AHEAD);
		heads_prefetch(&loop, k + HEADS_AHEAD);
		pair_add(world, &loop.list[k], members_of(&loop, k), may_repeat);
	}
}

void cni_stage_pairs(cn_world *world, float dt)
{
	cni_broadphase_pairs *pairs = &world->pairs;
	int32_t may_repeat = world->pairs_may_repeat;
	world->pairs_may_repeat = 0;
	if (may_repeat & CNI_PAIRS_CROWDED) {
		int32_t crowd = crowd_turn(world);
		world->pairs_may_repeat |= crowd & CNI_PAIRS_CROWDED ? may_repeat & (CNI_PAIRS_CROWDED | CNI_PAIRS_CROWDED_FIXED) : 0;
		may_repeat |= crowd & CNI_PAIRS_MARKED;
	}
	kicked_extend_boxes(world, dt);
	pairs->wanted = world->filter != NULL ? cni_contact_user_allows : NULL;
	pairs->fixed = is_fixed;
	pairs->wanted_context = world;
	pairs->seed = world->step_count;
	world->broadphase_ops->update(world->broadphase, cni_contact_possible, world, pairs);
	if (pairs->pairs_lost > 0) {
		world->warnings |= CN_WARNING_CONTACT_MEMORY;
		world->pairs_not_added += pairs->pairs_lost;
		world->pairs_may_repeat |= CNI_PAIRS_ALL;
	}
	if (pairs->left_out > 0)
		crowd_note(world, pairs->left_out, pairs->left_out_fixed);
	/* Workers may have found the pairs, so the user's filter runs here, in order; where the list had no room for all pairs, the
	   broadphase has run it. */
	cni_pairs_cull(pairs);
	pairs_add(world, may_repeat);
	if (world->pairs_may_repeat & CNI_PAIRS_CROWDED)
		world->warnings |= CN_WARNING_CROWD;
	if (may_repeat & CNI_PAIRS_ALL)
		marks_clear(world);
}
