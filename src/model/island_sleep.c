/*
 * model/island_sleep.c - moves bodies with their islands, contacts and joints between awake and asleep.
 *
 * Invariants: a contact is in the awake lists when one of its bodies is in the dense arrays; a touching contact is in the sleep
 * store when its dynamic bodies are asleep, else in a lane; a joint is in the awake list when one of its bodies is in the dense
 * arrays.
 */
#include "model/world.h"

#include <string.h>

/* First body of the body's island, or the body itself. */
static int32_t first_of(const cn_world *world, int32_t body)
{
	int32_t island = cni_body_at(world, body)->island;
	return island == CNI_NONE ? body : cni_island_at(world, island)->first;
}

/* ---- waking ---- */

static int32_t is_held_back(const cni_body *b) { return b->type == CN_BODY_DYNAMIC && b->awake == 0; }

static void wake_links_of(cn_world *world, int32_t body)
{
	const cni_body *b = cni_body_at(world, body);
	for (int32_t key = b->contact_first; key != CNI_NONE; key = cni_contact_of_key(world, key)->next[key & 1]) {
		const cni_contact *c = cni_contact_of_key(world, key);
		cni_body *one = cni_body_at(world, c->body[0]), *other = cni_body_at(world, c->body[1]);
		cni_contact_mark_static(one, other);
		cni_contact_enter_apart_list(world, key >> 1);
		if ((c->flags & CNI_CONTACT_ASLEEP) && !is_held_back(one) && !is_held_back(other))
			cni_contact_sleep_to_lane(world, key >> 1);
	}
	for (int32_t key = b->joint_first; key != CNI_NONE; key = cni_joint_at(world, key >> 1)->next[key & 1])
		cni_joint_enter_awake_list(world, key >> 1);
}

static void wake_island(cn_world *world, int32_t body)
{
	int32_t first = first_of(world, body);
	/* A body that left its fat box in the step that put it to sleep may still have contacts with boxes that are apart. */
	world->pairs_may_repeat |= CNI_PAIRS_MARKED;
	if (cni_body_at(world, body)->island != CNI_NONE) {
		cni_island *i = cni_island_at(world, cni_body_at(world, body)->island);
		i->awake = 1;
		i->solver = i->joints_solver = CN_SOLVER_AUTO;
	}
	for (int32_t k = first; k != CNI_NONE; k = cni_body_at(world, k)->island_next) {
		cni_body_restless(cni_body_at(world, k));
		cni_body_at(world, k)->flags |= CNI_BODY_AGAIN;
		cni_body_enter_awake(world, k);
	}
	for (int32_t k = first; k != CNI_NONE; k = cni_body_at(world, k)->island_next)
		wake_links_of(world, k);
}

void cni_body_wake_neighbours(cn_world *world, int32_t body)
{
	int32_t key = cni_body_at(world, body)->contact_first;
	for (; key != CNI_NONE; key = cni_contact_of_key(world, key)->next[key & 1]) {
		const cni_contact *c = cni_contact_of_key(world, key);
		int32_t other = c->body[1 - (key & 1)];
		if ((c->flags & CNI_CONTACT_TOUCHING) && cni_body_at(world, other)->type == CN_BODY_DYNAMIC)
			cni_body_wake(world, other);
	}
	for (key = cni_body_at(world, body)->joint_first; key != CNI_NONE; key = cni_joint_at(world, key >> 1)->next[key & 1]) {
		int32_t other = cni_joint_at(world, key >> 1)->body[1 - (key & 1)];
		if (cni_is_dynamic(world, other))
			cni_body_wake(world, other);
	}
}

void cni_body_wake(cn_world *world, int32_t body)
{
	cni_body *b = cni_body_at(world, body);
	if (b->type == CN_BODY_STATIC || !(b->flags & CN_BODY_ENABLED))
		return;
	cni_body_restless(b);
	if (b->awake == 0)
		wake_island(world, body);
	if (b->type == CN_BODY_KINEMATIC) /* when it starts to move, it carries along the bodies that touch it */
		cni_body_wake_neighbours(world, body);
}

#define WAKES_AT_ONCE 32

/* Broadphases visit in different orders, and the order of waking decides the order of the awake arrays: bodies wake by index. A
   search takes the lowest ones; if there are more, another search finds those above. */
typedef struct wake_query {
	const cn_world *world;
	const cni_shape *shape;
	int32_t first;                /* bodies below have been woken */
	int32_t count;
	int32_t total;                /* bodies found, also those without a place; a body of several shapes counts several times */
	int32_t bodies[WAKES_AT_ONCE]; /* ascending */
} wake_query;

static void wake_note(wake_query *m, int32_t body)
{
	int32_t k = m->count;
	++m->total;
	while (k > 0 && m->bodies[k - 1] > body)
		--k;
	if (k == WAKES_AT_ONCE || (k > 0 && m->bodies[k - 1] == body))
		return;
	m->count = cni_min_i(m->count + 1, WAKES_AT_ONCE);
	memmove(m->bodies + k + 1, m->bodies + k, (size_t)(m->count - k - 1) * sizeof m->bodies[0]);
	m->bodies[k] = body;
}

static float wake_if_collides(void *context, int32_t proxy, float limit)
{
	wake_query *m = (wake_query *)context;
	const cni_shape *other = cni_shape_at(m->world, cni_proxy_at(m->world, proxy)->shape);
	const cni_body *b = cni_body_at(m->world, other->body);
	if (other->body >= m->first && other->body != m->shape->body && b->type == CN_BODY_DYNAMIC && b->awake == 0 && cni_filter_allows(m->shape, other))
		wake_note(m, other->body);
	(void)limit;
	return 1.0f; /* continue */
}

static void wake_in_box(cn_world *world, int32_t shape, const cni_aabb *box)
{
	wake_query m;
	m.world = world;
	m.shape = cni_shape_at(world, shape);
	m.first = 0;
	do {
		m.count = m.total = 0;
		world->broadphase_ops->query(world->broadphase, box, wake_if_collides, &m);
		for (int32_t k = 0; k < m.count; ++k)
			cni_body_wake(world, m.bodies[k]);
		m.first = m.count > 0 ? m.bodies[m.count - 1] + 1 : 0;
	} while (m.count == WAKES_AT_ONCE && m.total > m.count);
}

void cni_shape_wake_met(cn_world *world, int32_t shape)
{
	const cni_shape *s = cni_shape_at(world, shape);
	if (world->awake_count - 1 == world->movable_count) /* nobody sleeps */
		return;
	world->broadphase_ops->settle(world->broadphase); /* otherwise each of many searches would test each of many moved boxes */
	for (int32_t child = 0; child < cni_shape_children(&world->blocks, s); ++child) {
		int32_t proxy = cni_shape_proxy(world, s, child);
		if (proxy == CNI_NONE)
			return;
		cni_aabb box = cni_proxy_at(world, proxy)->fat;
		wake_in_box(world, shape, &box);
	}
}

void cni_body_wake_met(cn_world *world, int32_t body)
{
	const cni_body *b = cni_body_at(world, body);
	cni_body_wake(world, body);
	if (b->type != CN_BODY_STATIC)
		return;
	world->broadphase_ops->settle(world->broadphase);
	for (int32_t shape = b->shape_first; shape != CNI_NONE; shape = cni_shape_at(world, shape)->next)
		cni_shape_wake_met(world, shape);
}

void cni_shape_wake_grown(cn_world *world, int32_t shape)
{
	int32_t body = cni_shape_at(world, shape)->body;
	const cni_body *b = cni_body_at(world, body);
	if (b->type == CN_BODY_STATIC)
		cni_shape_wake_met(world, shape);
	else if (b->contact_count > 0 || b->joint_first != CNI_NONE)
		cni_body_wake(world, body);
}

/* ---- sleeping ---- */

/* Does this lane go to sleep with the body? Pairs within an island count on their side 0. */
static int32_t lane_is_counted(const cni_contact *c, int32_t key)
{
	if (!cni_contact_has_lane(c))
		return 0;
	return (key & 1) == 0 || !(c->flags & CNI_CONTACT_LINKED);
}

static int32_t lanes_of_island(const cn_world *world, int32_t first)
{
	int32_t lanes = 0;
	for (int32_t k = first; k != CNI_NONE; k = cni_body_at(world, k)->island_next)
		for (int32_t key = cni_body_at(world, k)->contact_first; key != CNI_NONE; key = cni_contact_of_key(world, key)->next[key & 1])
			lanes += lane_is_counted(cni_contact_of_key(world, key), key);
	return lanes;
}

static void sleep_lanes_of(cn_world *world, int32_t body)
{
	int32_t key = cni_body_at(world, body)->contact_first;
	if (cni_body_at(world, body)->type != CN_BODY_DYNAMIC)
		return; /* dynamic bodies on a resting kinematic body stay awake */
	for (; key != CNI_NONE; key = cni_contact_of_key(world, key)->next[key & 1]) {
		const cni_contact *c = cni_contact_of_key(world, key);
		if (cni_contact_has_lane(c))
			cni_contact_lane_to_sleep(world, key >> 1);
	}
}

static void leave_lists_of(cn_world *world, int32_t body)
{
	const cni_body *b = cni_body_at(world, body);
	for (int32_t key = b->contact_first; key != CNI_NONE; key = cni_contact_of_key(world, key)->next[key & 1])
		if (cni_body_at(world, cni_contact_of_key(world, key)->body[1 - (key & 1)])->awake == 0)
			cni_contact_leave_apart_list(world, key >> 1);
	for (int32_t key = b->joint_first; key != CNI_NONE; key = cni_joint_at(world, key >> 1)->next[key & 1]) {
		int32_t other = cni_joint_at(world, key >> 1)->body[1 - (key & 1)];
		if (other == CNI_NONE || cni_body_at(world, other)->awake == 0)
			cni_joint_leave_awake_list(world, key >> 1);
	}
}

int32_t cni_body_reserve_sleep(cn_world *world, int32_t body)
{
	int32_t island = cni_body_at(world, body)->island, count = island == CNI_NONE ? 1 : cni_island_at(world, island)->count;
	cni_array *log = &world->events.asleep;
	return cni_array_reserve(log, &world->memory, log->count + count) &&
	       (CNI_SLEEP_IN_BLOCKS || cni_array_reserve(&world->sleep_lanes, &world->memory, world->sleep_lanes.count + lanes_of_island(world, first_of(world, body))));
}

int32_t cni_body_put_to_sleep(cn_world *world, int32_t body)
{
	int32_t first = first_of(world, body), island = cni_body_at(world, body)->island;
	cni_array *log = &world->events.asleep;
	if (!cni_body_reserve_sleep(world, body))
		return 0;
	if (island != CNI_NONE)
		cni_island_at(world, island)->awake = 0;
	for (int32_t k = first; k != CNI_NONE; k = cni_body_at(world, k)->island_next)
		sleep_lanes_of(world, k);
	for (int32_t k = first; k != CNI_NONE; k = cni_body_at(world, k)->island_next) {
		cni_body *b = cni_body_at(world, k);
		cni_body_leave_awake(world, k);
		b->vx = b->vy = b->w = 0.0f;
		((cn_body *)log->data)[log->count++] = cni_handles_of(&world->body_handles, k);
	}
	for (int32_t k = first; k != CNI_NONE; k = cni_body_at(world, k)->island_next)
		leave_lists_of(world, k);
	return 1;
}
