/*
 * narrowphase/narrowphase.c - stages 3 and 4: manifolds of awake contacts, begin and end of touching.
 *
 * Manifold reuse (manifold_reuse.c) updates contacts whose bodies have moved little against each other; culling (cull.c) skips
 * contacts that cannot touch. The first part computes the manifold of every other awake contact: if the contact keeps touching, its lane is rewritten
 * in place; if its state changes, it is listed. The second part applies the list in contact order: it takes and frees lanes,
 * links islands, logs events and removes ended pairs. Only the second part changes shared tables.
 *
 * So the world's workers share the first part: a range of contacts writes its own records, lanes and changes. Contacts that would
 * allocate or call the user are deferred and processed in order between the two parts.
 *
 * Contacts are processed in small windows: all contacts of a window begin, then one batch computes the manifolds of its
 * pairs of polygons, capsules and edges, then the contacts finish in order. This prefetches memory early and gives the
 * same results as one contact at a time.
 *
 * Reads bodies, geometry, proxies; writes contacts, lanes, and through them islands and events; marks
 * bodies near static ones.
 */
#include "narrowphase/narrowphase.h"
#include "base/cpu.h"
#include "collision/distance.h"
#include "collision/manifold_batch.h"
#include "narrowphase/cull.h"

#include <string.h>

/* Action of the second part for a contact. EVENTS: only sends events that are due. DEFERRED: not yet processed. BEGIN_KEPT: begins
   with a manifold that was kept. */
enum { CHANGE_NONE = 0, CHANGE_BEGIN = 1, CHANGE_END = 2, CHANGE_EVENTS = 3, CHANGE_DEFERRED = 4, CHANGE_BEGIN_KEPT = 5 };

static int32_t boxes_overlap(const cn_world *world, const cni_contact *c)
{
	return cni_aabb_overlap(&cni_proxy_at(world, c->proxy[0])->fat, &cni_proxy_at(world, c->proxy[1])->fat);
}

/* ---- sensors ---- */

/* A chain has manifolds on its front only, but is a line with two sides here. */
static int32_t shapes_overlap(const cni_touch *t)
{
	cni_vec2 a[2], b[2];
	int32_t overlaps = 0;
	if (CNI_HAS_CHAINS && t->boxes_overlap && t->in.b->type == CN_SHAPE_CHAIN)
		return cni_distance(cni_geometry_proxy(t->in.a, 0, a), cni_geometry_proxy(t->in.b, t->in.child_b, b), t->in.b_in_a).distance <= 0.0f;
	for (int32_t k = 0; k < t->result.manifold.count; ++k)
		overlaps |= t->result.manifold.points[k].separation <= 0.0f;
	return overlaps;
}

static int32_t sensor_update(const cni_touch *t)
{
	int32_t sensing = (t->contact->flags & CNI_CONTACT_SENSING) != 0;
	if (shapes_overlap(t))
		return sensing ? CHANGE_NONE : CHANGE_BEGIN;
	return sensing || !t->boxes_overlap ? CHANGE_END : CHANGE_NONE;
}

/* The pre-solve callback may disable a touching contact for this step. */
static void call_pre_solve(cn_world *world, int32_t contact)
{
	cn_contact_event event;
	if (world->pre_solve == NULL)
		return;
	cni_contact_describe(world, contact, cni_contact_at(world, contact)->flags & CNI_CONTACT_ENTERED ? CN_EVENT_ENTER : CN_EVENT_STAY, &event);
	++world->locked;
	int32_t solve = world->pre_solve(world, &event, world->pre_solve_user);
	--world->locked;
	if (!solve)
		cni_contact_write_empty(world, contact);
}

static void write_and_notify(cn_world *world, int32_t contact, const cni_touch *t)
{
	cni_contact_write(world, t->contact, t->a, t->b, &t->result);
	if (t->contact->flags & CNI_CONTACT_PRE_SOLVE)
		call_pre_solve(world, contact);
}

/* Processes a contact with a finished manifold: rewrites its lane if it keeps touching, else returns its change. */
static int32_t contact_update(cn_world *world, int32_t contact, cni_touch *t)
{
	cni_contact *c = t->contact;
	int32_t touching = (c->flags & CNI_CONTACT_TOUCHING) != 0;
	if (c->flags & CNI_CONTACT_SENSOR)
		return sensor_update(t);
	if (c->flags & CNI_CONTACT_ONE_WAY)
		cni_touch_filter_one_way(world, c, &t->result.manifold);
	if (t->result.manifold.count > 0 && !touching)
		return CHANGE_BEGIN;
	if (t->result.manifold.count > 0)
		write_and_notify(world, contact, t);
	else if (touching || !t->boxes_overlap)
		return CHANGE_END;
	return c->flags & (CNI_CONTACT_CREATED_OWED | CNI_CONTACT_ENTER_OWED) ? CHANGE_EVENTS : CHANGE_NONE;
}

/* Time over which motion is anticipated; sensors report present overlap only. */
static float motion_time(const cni_contact *c, float dt)
{
	return c->flags & CNI_CONTACT_SENSOR ? 0.0f : dt;
}

static void change_begin(cn_world *world, int32_t contact, const cni_touch_result *b)
{
	if (b->manifold.count == 0)
		return;
	if (cni_contact_begin(world, contact, b)) {
		if (cni_contact_at(world, contact)->flags & CNI_CONTACT_PRE_SOLVE)
			call_pre_solve(world, contact);
		return;
	}
	world->warnings |= CN_WARNING_CONTACT_MEMORY;
	++world->pairs_not_added;
}

/* Destroys a pair whose boxes are apart. Without memory for that the pair stays, and the broadphase may report it again. */
static void pair_end(cn_world *world, int32_t contact)
{
	if (!boxes_overlap(world, cni_contact_at(world, contact)) && !cni_contact_destroy(world, contact))
		world->pairs_may_repeat |= CNI_PAIRS_ALL;
}

/* Sensor pairs have no lane and no island link. */
static void sensor_change(cn_world *world, int32_t contact, int32_t change)
{
	if (!cni_contact_update_sensor(world, contact, change == CHANGE_BEGIN))
		world->pairs_may_repeat |= CNI_PAIRS_ALL;
	else if (change == CHANGE_END)
		pair_end(world, contact);
}

static void change_apply(cn_world *world, int32_t contact, int32_t change, cni_begun_store *store, float dt)
{
	const cni_contact *c = cni_contact_at(world, contact);
	if (c->flags & CNI_CONTACT_SENSOR) {
		sensor_change(world, contact, change);
		return;
	}
	if ((c->flags & CNI_CONTACT_CREATED_OWED) && (change != CHANGE_END || boxes_overlap(world, c))) /* else the pair is destroyed unreported */
		cni_contact_send_deferred_events(world, contact, CNI_CONTACT_CREATED_OWED, CN_EVENT_CREATED);
	if (change == CHANGE_EVENTS)
		cni_contact_send_deferred_events(world, contact, CNI_CONTACT_ENTER_OWED, CN_EVENT_ENTER);
	if (change == CHANGE_BEGIN_KEPT) {
		change_begin(world, contact, cni_begun_take(store));
	} else if (change == CHANGE_BEGIN) {
		cni_touch_result again = cni_begun_again(world, contact, dt);
		change_begin(world, contact, &again);
	}
	if (change != CHANGE_END)
		return;
	if ((c->flags & CNI_CONTACT_TOUCHING) && !cni_contact_end(world, contact))
		world->pairs_may_repeat |= CNI_PAIRS_ALL;
	else
		pair_end(world, contact);
}

/* ---- windows ---- */

/* Contacts per window. */
#define WINDOW CNI_BATCH_PAIRS

typedef struct window {
	cni_touch_pair pair[WINDOW];
	int32_t count;
	cni_touch touch[WINDOW];
	int32_t column[WINDOW];  /* in boxes, or COLUMN_* */
	int32_t change[WINDOW];  /* CHANGE_* */
	cni_manifold_batch batch;
	cni_batch_kernel_fn *kernel;
	int32_t prefetches;
	cni_begun_store *store;  /* NULL: manifolds of contacts that begin are not kept */
	uint32_t deferred_flags, deferred_locks; /* flags of touching contacts, flags of their bodies: these contacts are deferred */
} window;

enum {
	COLUMN_NONE = -1,   /* not a pair for the batch */
	COLUMN_APART = -2,  /* no manifold */
	COLUMN_DONE = -3    /* deferred; or stays apart, and has nothing to report */
};

/* Serial: defers nothing. Otherwise defers contacts that would allocate or call the user. */
static void window_init(window *w, cn_world *world, int32_t serial)
{
	int32_t extra_rows = cni_table_capacity(&world->blocks_extra) >= cni_table_capacity(&world->blocks_hot);
	w->kernel = CNI_HAS_WIDE_4 && CNI_ON(MANIFOLD_BATCHES) ? cni_batch_kernel_choose() : NULL;
	w->count = w->prefetches = 0;
	w->store = NULL;
	w->deferred_flags = serial ? 0 : CNI_CONTACT_REFRESH | CNI_CONTACT_PRE_SOLVE;
	w->deferred_locks = serial || extra_rows ? 0 : CN_BODY_LOCK_X | CN_BODY_LOCK_Y;
}

/* A constant in builds without vectors. */
static int32_t has_kernel(const window *w) { return CNI_HAS_WIDE_4 && w->kernel != NULL; }

static int32_t is_deferred(const window *w, const cni_touch_pair *p)
{
	if (!(p->contact->flags & CNI_CONTACT_TOUCHING))
		return 0;
	return (p->contact->flags & w->deferred_flags) || ((cni_body_flags(p->body[0]) | cni_body_flags(p->body[1])) & w->deferred_locks);
}

/* Prefetches the data that writing a lane needs. Forced inline: compilers treat a function that only prefetches as having no
   effect. */
CNI_INLINE void lane_prefetch(const cn_world *world, const cni_touch_pair *p)
{
	int32_t l = p->contact->slot % CNI_LANES;
	if (!(p->contact->flags & CNI_CONTACT_TOUCHING))
		return;
	const cni_contact_block *block = cni_block_at(world, p->contact->slot / CNI_LANES);
	CNI_PREFETCH(cni_motions(world) + p->body[0]->awake);
	CNI_PREFETCH(cni_motions(world) + p->body[1]->awake);
	CNI_PREFETCH(&block->p[0].jn[l]);
	CNI_PREFETCH(&block->p[1].jn[l]);
}

/* The geometry of a box spans more than one cache line. */
CNI_INLINE void geometry_prefetch(const cn_world *world, const cni_proxy *p)
{
	const cni_geometry *g = cni_proxy_geometry(&world->blocks, p);
	CNI_PREFETCH(g);
	CNI_PREFETCH(g + 2);
}

static void window_prefetch(const cn_world *world, const window *w, int32_t count)
{
	for (int32_t k = 0; k < count; ++k) {
		geometry_prefetch(world, w->pair[k].proxy[0]);
		geometry_prefetch(world, w->pair[k].proxy[1]);
		lane_prefetch(world, &w->pair[k]);
	}
}

/* Contacts that touch or have something to report are not culled. */
static int32_t is_culled(const cn_world *world, const cni_touch_pair *p, float dt)
{
	const uint32_t looked_at = CNI_CONTACT_TOUCHING | CNI_CONTACT_SENSOR | CNI_CONTACT_PASSING | CNI_CONTACT_CREATED_OWED;
	return CNI_ON(CULLING) && !(p->contact->flags & looked_at) && cni_pair_stays_apart(world, p, dt);
}

static void window_begin(const cn_world *world, window *w, int32_t count, float dt)
{
	w->batch.count = 0;
	if (w->prefetches)
		window_prefetch(world, w, count);
	for (int32_t k = 0; k < count; ++k) {
		cni_contact *c = w->pair[k].contact;
		cni_touch *t = &w->touch[k];
		w->column[k] = COLUMN_DONE;
		w->change[k] = is_deferred(w, &w->pair[k]) ? CHANGE_DEFERRED : CHANGE_NONE;
		if (w->change[k] == CHANGE_DEFERRED || is_culled(world, &w->pair[k], dt))
			continue;
		w->column[k] = cni_touch_begin(world, &w->pair[k], motion_time(c, dt), t) ? COLUMN_NONE : COLUMN_APART;
		if (w->column[k] == COLUMN_NONE && has_kernel(w) && cni_batch_take(&t->in))
			w->column[k] = cni_batch_add(&w->batch, &t->in, &c->cache);
	}
}

static int32_t window_finish(cn_world *world, window *w, int32_t k, float dt)
{
	cni_touch *t = &w->touch[k];
	if (w->column[k] == COLUMN_DONE)
		return w->change[k];
	if (w->column[k] == COLUMN_NONE)
		cni_touch_collide(t);
	else if (has_kernel(w) && w->column[k] >= 0)
		cni_batch_read(&w->batch, w->column[k], &t->in, &t->contact->cache, &t->result.manifold);
	cni_touch_finish(world, motion_time(t->contact, dt), t);
	int32_t change = contact_update(world, w->pair[k].index, t);
	if (change == CHANGE_BEGIN && w->store != NULL && !(t->contact->flags & CNI_CONTACT_SENSOR) && cni_begun_keep(w->store, t))
		return CHANGE_BEGIN_KEPT;
	return change;
}

static void window_collide(cn_world *world, window *w, int32_t count, float dt)
{
	window_begin(world, w, count, dt);
	if (has_kernel(w))
		cni_batch_run(&w->batch, w->kernel);
	for (int32_t k = 0; k < count; ++k)
		w->change[k] = window_finish(world, w, k, dt);
}

/* ---- changes ---- */

/* Without memory for the list a few changes are made in each step, and the rest is found again in the next. */
#define CHANGES_LEAST 64

/* So many changes ahead records are asked for, and when these have come their neighbours. */
#define RECORDS_AHEAD 16
#define NEIGHBOURS_AHEAD 8

/* So many contacts there must be for looking at them to be worth sharing. */
#define SHARED_CONTACTS 1024

typedef struct change_list {
	uint32_t *items;  /* contact << 3 | CHANGE_* */
	int32_t count, capacity;
} change_list;

static void change_add(cn_world *world, change_list *list, int32_t contact, int32_t change)
{
	if (list->count < list->capacity) {
		list->items[list->count++] = (uint32_t)contact << 3 | (uint32_t)change;
		return;
	}
	world->warnings |= CN_WARNING_CONTACT_MEMORY;
	world->pairs_may_repeat |= CNI_PAIRS_ALL;
	if (cni_contact_at(world, contact)->flags & CNI_CONTACT_TOUCHING)
		cni_contact_write_empty(world, contact);
}

/* Prefetches what linking and unlinking a contact writes: its neighbours in its bodies' lists. Its record was prefetched before. */
CNI_INLINE void neighbours_prefetch(const cn_world *world, const cni_contact *c)
{
	for (int32_t side = 0; side < 2; ++side) {
		CNI_PREFETCH(&cni_body_at(world, c->body[side])->contact_first);
		if (c->next[side] != CNI_NONE)
			CNI_PREFETCH(cni_contact_of_key(world, c->next[side])->prev);
		if (c->prev[side] != CNI_NONE)
			CNI_PREFETCH(cni_contact_of_key(world, c->prev[side])->next);
	}
}

CNI_INLINE void changes_prefetch(const cn_world *world, const change_list *list, int32_t k)
{
	if (k + RECORDS_AHEAD < list->count) {
		const cni_contact *c = cni_contact_at(world, (int32_t)(list->items[k + RECORDS_AHEAD] >> 3));
		CNI_PREFETCH(c);
		CNI_PREFETCH(&c->cache);
	}
	if (k + NEIGHBOURS_AHEAD < list->count)
		neighbours_prefetch(world, cni_contact_at(world, (int32_t)(list->items[k + NEIGHBOURS_AHEAD] >> 3)));
}

static void changes_apply(cn_world *world, const change_list *list, cni_begun_store *store, float dt)
{
	for (int32_t k = 0; k < list->count; ++k) {
		changes_prefetch(world, list, k);
		if ((list->items[k] & 7u) != CHANGE_NONE)
			change_apply(world, (int32_t)(list->items[k] >> 3), (int32_t)(list->items[k] & 7u), store, dt);
	}
}

/* ---- first part: collide ---- */

typedef struct collide_loop {
	cni_cull_list list;
	cni_begun_store store;
	uint8_t *changes;      /* CHANGE_* of each contact of the list; NULL: no memory, */
	change_list *listed;   /* and one worker adds them to this list at once, without deferring any */
	uint32_t change_count;
} collide_loop;

/* First contact of a range that nominally begins at a group. Lanes of a block share words, so one range takes all contacts of a block. */
static int32_t range_begin(const cni_cull_list *list, int32_t group)
{
	int32_t k = cni_min_i(group * CNI_BEGUN_GROUP, list->count);
	if (k <= list->apart)
		return k;
	while (k < list->count && cni_contact_at(list->world, list->contacts[k])->slot / CNI_LANES ==
	                              cni_contact_at(list->world, list->contacts[k - 1])->slot / CNI_LANES)
		++k;
	return k;
}

/* Groups begin to end - 1. Writes only contacts and lanes of the range, marks of bodies, and the range's changes and manifolds. */
static void collide_range(void *context, int32_t begin, int32_t end)
{
	collide_loop *loop = (collide_loop *)context;
	cn_world *world = loop->list.world;
	uint32_t changed = 0;
	int32_t count;
	cni_cull cull;
	window w;
	window_init(&w, world, loop->changes == NULL);
	w.store = loop->changes == NULL ? NULL : &loop->store;
	w.prefetches = loop->list.prefetches;
	cni_cull_begin(&cull, &loop->list, range_begin(&loop->list, begin), range_begin(&loop->list, end));
	while ((count = cni_cull_next(&cull, w.pair, WINDOW)) > 0) {
		window_collide(world, &w, count, loop->list.dt);
		for (int32_t k = 0; k < count; ++k) {
			if (loop->changes != NULL)
				loop->changes[w.pair[k].place] = (uint8_t)w.change[k];
			else if (w.change[k] != CHANGE_NONE)
				change_add(world, loop->listed, w.pair[k].index, w.change[k]);
			changed += w.change[k] != CHANGE_NONE;
		}
	}
	if (changed > 0)
		(void)cni_atomic_add(&loop->change_count, changed);
}

/* Kept manifolds are taken in order, so none is where the list has no room for all changes. */
static void mark_list(const collide_loop *loop, change_list *changes, int32_t k)
{
	int32_t change = loop->changes[k];
	if (change == CHANGE_BEGIN_KEPT && changes->capacity < (int32_t)loop->change_count)
		change = CHANGE_BEGIN;
	if (change != CHANGE_NONE)
		change_add(loop->list.world, changes, loop->list.contacts[k], change);
}

/* Lists the changes. Few contacts have one. */
static void changes_list(const collide_loop *loop, change_list *changes)
{
	int32_t count = loop->list.count, k = 0;
	uint64_t eight;
	for (; k + 8 <= count; k += 8) {
		memcpy(&eight, loop->changes + k, 8);
		for (int32_t l = k; l < k + 8 && eight != 0; ++l)
			mark_list(loop, changes, l);
	}
	for (; k < count; ++k)
		mark_list(loop, changes, k);
}

/* Collides the window, whose contacts are those of the given items, and stores their changes in the items. */
static void items_collide(cn_world *world, window *w, const int32_t *items, const change_list *changes, float dt)
{
	window_collide(world, w, w->count, dt);
	for (int32_t k = 0; k < w->count; ++k)
		changes->items[items[k]] = (uint32_t)w->pair[k].index << 3 | (uint32_t)w->change[k];
	w->count = 0;
}

static void deferred_collide(cn_world *world, const change_list *changes, float dt)
{
	window w;
	int32_t items[WINDOW];
	window_init(&w, world, 1);
	for (int32_t k = 0; k < changes->count; ++k) {
		int32_t contact = (int32_t)(changes->items[k] >> 3);
		if ((changes->items[k] & 7u) != CHANGE_DEFERRED)
			continue;
		items[w.count] = k;
		w.pair[w.count++] = cni_touch_pair_of(world, cni_contact_at(world, contact), contact);
		if (w.count == WINDOW)
			items_collide(world, &w, items, changes, dt);
	}
	items_collide(world, &w, items, changes, dt);
}

/* Both parts. Without memory CHANGES_LEAST changes are listed. */
static void collide(cn_world *world, collide_loop *loop)
{
	uint32_t few[CHANGES_LEAST], *items = NULL;
	change_list changes = { few, 0, CHANGES_LEAST };
	int32_t count = loop->list.count;
	loop->listed = &changes;
	loop->change_count = 0;
	if (loop->changes != NULL)
		memset(loop->changes, 0, (size_t)count);
	cni_team_for(loop->changes == NULL || count < SHARED_CONTACTS ? NULL : world->team, count / CNI_BEGUN_GROUP + 1, 1, collide_range, loop);
	cni_cull_close(&loop->list);
	if (loop->changes != NULL && loop->change_count > CHANGES_LEAST)
		items = (uint32_t *)cni_arena_push(&world->arena, sizeof(uint32_t) * (uint64_t)loop->change_count);
	if (items != NULL) {
		changes.items = items;
		changes.capacity = (int32_t)loop->change_count;
	}
	if (loop->changes != NULL)
		changes_list(loop, &changes);
	deferred_collide(world, &changes, loop->list.dt);
	changes_apply(world, &changes, &loop->store, loop->list.dt);
	cni_arena_pop(&world->arena, items);
}

void cni_stage_narrowphase(cn_world *world, float dt)
{
	int32_t *contacts = (int32_t *)world->apart.data, apart = world->apart.count, count;
	collide_loop loop;
	if (contacts == NULL)
		return; /* there has never been a contact */
	count = apart + cni_manifolds_reuse(world, dt, contacts + apart); /* the list has room for every contact */
	loop.changes = (uint8_t *)cni_arena_push(&world->arena, (uint64_t)count);
	cni_begun_open(&loop.store, world, apart, cni_min_i(world->pairs.list.count, apart));
	cni_cull_open(&loop.list, world, contacts, apart, count, dt);
	collide(world, &loop);
	cni_begun_close(&loop.store, world);
	cni_arena_pop(&world->arena, loop.changes);
}
