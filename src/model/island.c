/*
 * model/island.c - islands: linking, unlinking, merging, splitting (method in island.h).
 *
 * Owns the island table. Invariants: an island has at least two bodies, all dynamic and enabled; all or none of them are in the
 * dense arrays; two dynamic bodies that share a touching contact or a joint are in one island.
 */
#include "model/world.h"

#include <string.h>

static int32_t island_take(cn_world *world)
{
	int32_t island = world->island_free;
	if (island != CNI_NONE)
		world->island_free = cni_island_at(world, island)->next_free;
	else
		island = world->island_used++;
	CNI_ASSERT(island < cni_table_capacity(&world->islands));
	cni_island *i = cni_island_at(world, island);
	memset(i, 0, sizeof *i);
	i->first = i->last = i->next_free = CNI_NONE;
	++world->island_count;
	return island;
}

static void island_release(cn_world *world, int32_t island)
{
	cni_island *i = cni_island_at(world, island);
	i->first = i->last = CNI_NONE;
	i->count = 0;
	i->tier = CNI_TIER_SOFT;
	i->next_free = world->island_free;
	world->island_free = island;
	--world->island_count;
}

/* Of an island that is left with one body. */
static void island_dissolve(cn_world *world, int32_t island)
{
	cni_body *b = cni_body_at(world, cni_island_at(world, island)->first);
	b->island = b->island_next = b->island_prev = CNI_NONE;
	island_release(world, island);
}

static void island_append(cn_world *world, int32_t island, int32_t body)
{
	cni_island *i = cni_island_at(world, island);
	cni_body *b = cni_body_at(world, body);
	b->island = island;
	b->island_next = CNI_NONE;
	b->island_prev = i->last;
	if (i->last != CNI_NONE)
		cni_body_at(world, i->last)->island_next = body;
	else
		i->first = body;
	i->last = body;
	++i->count;
}

/* Steps for which direct solving is still refused: direct/solver_selection.c. */
static int32_t refused_left(const cn_world *world, const cni_island *i)
{
	uint32_t passed = world->step_count - i->refused_step;
	return passed < (uint32_t)i->refused_steps ? i->refused_steps - (int32_t)passed : 0;
}

static uint32_t more_recent(const cn_world *world, uint32_t a, uint32_t b)
{
	return world->step_count - a < world->step_count - b ? a : b;
}

int32_t cni_cone_debt(const cn_world *world, const cni_island *i)
{
	uint32_t passed = world->step_count - i->cone_paid_step;
	return passed <= (uint32_t)(i->cone_spent / CNI_CONE_REFILL) ? i->cone_spent - (int32_t)passed * CNI_CONE_REFILL : 0;
}

/* Merges the solver selection state: a failure of a part holds for the whole. */
static void tier_inherit(const cn_world *world, cni_island *to, const cni_island *from)
{
	if (refused_left(world, from) > refused_left(world, to)) {
		to->refused_step = from->refused_step;
		to->refused_steps = from->refused_steps;
		if (to->tier == CNI_TIER_SOFT && from->tier == CNI_TIER_SOFT)
			to->reason = from->reason;
	}
	if (from->projected_steps > to->projected_steps) {
		to->projected_step = from->projected_step;
		to->projected_steps = from->projected_steps;
	}
	if (from->stay_steps > to->stay_steps || to->given_step == 0)
		to->given_step = from->given_step;
	if (from->tier == CNI_TIER_DIRECT && to->tier != CNI_TIER_DIRECT)
		to->given_step = world->step_count;
	to->stay_steps = cni_max_i(to->stay_steps, from->stay_steps);
	if (from->unheld_step != 0)
		to->unheld_step = to->unheld_step == 0 ? from->unheld_step : more_recent(world, to->unheld_step, from->unheld_step);
	if (CNI_HAS_DIRECT && cni_cone_debt(world, from) > cni_cone_debt(world, to)) {
		to->cone_spent = from->cone_spent;
		to->cone_paid_step = from->cone_paid_step;
	}
	if (from->cone_step != 0)
		to->cone_step = to->cone_step == 0 ? from->cone_step : more_recent(world, to->cone_step, from->cone_step);
}

static void island_merge(cn_world *world, int32_t into, int32_t from)
{
	cni_island *target = cni_island_at(world, into), *source = cni_island_at(world, from);
	for (int32_t body = source->first; body != CNI_NONE; body = cni_body_at(world, body)->island_next)
		cni_body_at(world, body)->island = into;
	cni_body_at(world, target->last)->island_next = source->first;
	cni_body_at(world, source->first)->island_prev = target->last;
	target->last = source->last;
	target->count += source->count;
	target->losses += source->losses;
	tier_inherit(world, target, source);
	island_release(world, from);
}

void cni_island_link(cn_world *world, int32_t body_a, int32_t body_b)
{
	cni_body *a = cni_body_at(world, body_a), *b = cni_body_at(world, body_b);
	if (a->awake != 0 && b->awake == 0)
		cni_body_wake(world, body_b);
	else if (b->awake != 0 && a->awake == 0)
		cni_body_wake(world, body_a);
	if (a->island == CNI_NONE && b->island == CNI_NONE) {
		int32_t island = island_take(world);
		cni_island_at(world, island)->awake = a->awake != 0;
		island_append(world, island, body_a);
		island_append(world, island, body_b);
	} else if (a->island == CNI_NONE) {
		island_append(world, b->island, body_a);
	} else if (b->island == CNI_NONE) {
		island_append(world, a->island, body_b);
	} else if (a->island != b->island) {
		int32_t a_larger = cni_island_at(world, a->island)->count >= cni_island_at(world, b->island)->count;
		island_merge(world, a_larger ? a->island : b->island, a_larger ? b->island : a->island);
	}
}

void cni_island_unlink(cn_world *world, int32_t body)
{
	const cni_body *b = cni_body_at(world, body);
	if (b->island != CNI_NONE)
		++cni_island_at(world, b->island)->losses;
}

void cni_island_remove_body(cn_world *world, int32_t body)
{
	cni_body *b = cni_body_at(world, body);
	int32_t island = b->island;
	if (island == CNI_NONE)
		return;
	cni_island *i = cni_island_at(world, island);
	if (b->island_prev != CNI_NONE)
		cni_body_at(world, b->island_prev)->island_next = b->island_next;
	else
		i->first = b->island_next;
	if (b->island_next != CNI_NONE)
		cni_body_at(world, b->island_next)->island_prev = b->island_prev;
	else
		i->last = b->island_prev;
	b->island = b->island_next = b->island_prev = CNI_NONE;
	++i->losses;
	if (--i->count == 1)
		island_dissolve(world, island);
}

/* ---- splitting ---- */

/* Pushes the unlabelled dynamic bodies that touch this body or share a joint with it. */
static int32_t push_neighbours(const cn_world *world, int32_t body, int32_t *stack, int32_t top)
{
	const cni_body *b = cni_body_at(world, body);
	for (int32_t key = b->contact_first; key != CNI_NONE; key = cni_contact_of_key(world, key)->next[key & 1]) {
		const cni_contact *c = cni_contact_of_key(world, key);
		int32_t other = c->body[1 - (key & 1)];
		if ((c->flags & CNI_CONTACT_LINKED) && cni_body_at(world, other)->island == CNI_NONE) {
			cni_body_at(world, other)->island = b->island;
			stack[top++] = other;
		}
	}
	for (int32_t key = b->joint_first; key != CNI_NONE; key = cni_joint_at(world, key >> 1)->next[key & 1]) {
		const cni_joint *j = cni_joint_at(world, key >> 1);
		int32_t other = j->body[1 - (key & 1)];
		if (j->linked && cni_body_at(world, other)->island == CNI_NONE) {
			cni_body_at(world, other)->island = b->island;
			stack[top++] = other;
		}
	}
	return top;
}

/* Collects the connected part of a former island from a seed; a single body gets no island. */
static void part_collect(cn_world *world, int32_t seed, const cni_island *whole, int32_t *stack)
{
	int32_t island = island_take(world), top = 0;
	cni_island_at(world, island)->awake = whole->awake;
	tier_inherit(world, cni_island_at(world, island), whole);
	cni_body_at(world, seed)->island = island;
	stack[top++] = seed;
	while (top > 0) {
		int32_t body = stack[--top];
		island_append(world, island, body);
		top = push_neighbours(world, body, stack, top);
	}
	if (cni_island_at(world, island)->count == 1)
		island_dissolve(world, island);
}

int32_t cni_island_split(cn_world *world, int32_t island)
{
	const cni_island *i = cni_island_at(world, island), whole = *i;
	int32_t count = i->count, k = 0;
	if (!cni_island_reserve(world, count / 2 + 1))
		return 0;
	int32_t *bodies = (int32_t *)cni_arena_push(&world->arena, (uint64_t)count * 2 * sizeof(int32_t));
	if (bodies == NULL)
		return 0;
	int32_t *stack = bodies + count;
	for (int32_t body = i->first; body != CNI_NONE; body = cni_body_at(world, body)->island_next)
		bodies[k++] = body;
	island_release(world, island);
	for (k = 0; k < count; ++k)
		cni_body_at(world, bodies[k])->island = CNI_NONE;
	/* A single body of an earlier part has island CNI_NONE and no links: a second visit is harmless. */
	for (k = 0; k < count; ++k)
		if (cni_body_at(world, bodies[k])->island == CNI_NONE)
			part_collect(world, bodies[k], &whole, stack);
	cni_arena_pop(&world->arena, bodies);
	return 1;
}
