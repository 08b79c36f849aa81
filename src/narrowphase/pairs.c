/*
 * narrowphase/pairs.c - stage 2: boxes that began to overlap become contacts.
 *
 * Reads proxies and filters through the broadphase, writes contacts. Pairs come sorted, so contacts are made
 * in the same order whatever broadphase found them. A pair that finds no memory is asked for again at
 * the next step (its proxy is touched) and counted.
 */
#include "narrowphase/narrowphase.h"
#include "model/solve.h"

static void pair_lose(cn_world *world, const cni_pair *pair)
{
	world->broadphase_ops->touch(world->broadphase, pair->a);
	world->pairs_may_repeat = CNI_PAIRS_ALL;
	world->warnings |= CN_WARNING_CONTACT_MEMORY;
	++world->pairs_not_added;
}

/* Bodies whose velocity was set from outside since the last step. */
static void kicked_look_ahead(cn_world *world, float dt)
{
	int32_t k;
	for (k = 0; k < world->kicked.count; ++k) {
		int32_t body = cni_handles_find(&world->body_handles, ((const cn_body *)world->kicked.data)[k]);
		cni_body *b = body == CNI_NONE ? NULL : cni_body_at(world, body);
		if (b != NULL && b->awake != 0)
			cni_body_look_ahead(world, b, cni_mul(dt, cni_body_velocity(world, b).linear_mps));
	}
	world->kicked.count = 0;
}

static const cni_body *body_of(const cn_world *world, int32_t proxy)
{
	return cni_body_at(world, cni_shape_at(world, cni_proxy_at(world, proxy)->shape)->body);
}

static int32_t is_marked(const cn_world *world, int32_t proxy)
{
	return (body_of(world, proxy)->flags & CNI_BODY_AGAIN) != 0;
}

/* It fell asleep, maybe with a contact whose boxes had come apart in the step before: that ends when it wakes. */
static int32_t is_asleep(const cn_world *world, int32_t proxy)
{
	const cni_body *b = body_of(world, proxy);
	return b->awake == 0 && b->type != CN_BODY_STATIC;
}

/* Is there a contact of the pair already? Most pairs are of bodies that nothing happened to. */
static int32_t pair_repeats(const cn_world *world, const cni_pair *pair, int32_t may_repeat)
{
	if (may_repeat == CNI_PAIRS_ALL || is_asleep(world, pair->a) || is_asleep(world, pair->b) || (may_repeat && (is_marked(world, pair->a) || is_marked(world, pair->b))))
		return cni_contact_find(world, pair->a, pair->b) != CNI_NONE;
	CNI_ASSERT(cni_contact_find(world, pair->a, pair->b) == CNI_NONE);
	return 0;
}

/* Those that are not awake keep their mark: their pairs are looked for once more than they must. */
static void marks_clear(const cn_world *world)
{
	int32_t k;
	for (k = 1; k < world->awake_count; ++k)
		cni_body_at(world, cni_awake_ids(world)[k])->flags &= ~(uint32_t)CNI_BODY_AGAIN;
}

/* So many pairs ahead each is asked for, when what leads to it has come: shapes, bodies, the heads of their lists of contacts. */
#define SHAPES_AHEAD 12
#define BODIES_AHEAD 8
#define HEADS_AHEAD 4

/* Inlined by force: compilers take a function that only prefetches for one that does nothing. */
CNI_INLINE void body_prefetch(const cni_body *b)
{
	CNI_PREFETCH(&b->flags);
	CNI_PREFETCH(&b->contact_first);
}

CNI_INLINE void head_prefetch(const cn_world *world, const cni_body *b)
{
	if (b->contact_first != CNI_NONE)
		CNI_PREFETCH(cni_contact_of_key(world, b->contact_first)->prev);
}

CNI_INLINE void pairs_prefetch(const cn_world *world, const cni_pair *list, int32_t count, int32_t k)
{
	if (k + SHAPES_AHEAD < count) {
		CNI_PREFETCH(cni_shape_at(world, cni_proxy_at(world, list[k + SHAPES_AHEAD].a)->shape));
		CNI_PREFETCH(cni_shape_at(world, cni_proxy_at(world, list[k + SHAPES_AHEAD].b)->shape));
	}
	if (k + BODIES_AHEAD < count) {
		body_prefetch(body_of(world, list[k + BODIES_AHEAD].a));
		body_prefetch(body_of(world, list[k + BODIES_AHEAD].b));
	}
	if (k + HEADS_AHEAD < count) {
		head_prefetch(world, body_of(world, list[k + HEADS_AHEAD].a));
		head_prefetch(world, body_of(world, list[k + HEADS_AHEAD].b));
	}
}

void cni_stage_pairs(cn_world *world, float dt)
{
	cni_broadphase_pairs *pairs = &world->pairs;
	const cni_pair *list;
	int32_t k, may_repeat = world->pairs_may_repeat;
	world->pairs_may_repeat = 0;
	kicked_look_ahead(world, dt);
	pairs->wanted = world->filter != NULL ? cni_contact_user_allows : NULL;
	pairs->wanted_context = world;
	world->broadphase_ops->update(world->broadphase, cni_contact_possible, world, pairs);
	if (pairs->pairs_lost > 0) {
		world->warnings |= CN_WARNING_CONTACT_MEMORY;
		world->pairs_not_added += pairs->pairs_lost;
		world->pairs_may_repeat = CNI_PAIRS_ALL;
	}
	/* Workers may have found the pairs; the user is asked here, in order, but where the list had no room for all and the
	   broadphase asked. */
	cni_pairs_cull(pairs);
	list = (const cni_pair *)pairs->list.data;
	for (k = 0; k < pairs->list.count; ++k) {
		pairs_prefetch(world, list, pairs->list.count, k);
		if (pair_repeats(world, &list[k], may_repeat))
			continue;
		if (cni_contact_reserve(world, 1) != CN_OK)
			pair_lose(world, &list[k]);
		else
			cni_contact_create(world, list[k].a, list[k].b);
	}
	if (may_repeat)
		marks_clear(world);
}
