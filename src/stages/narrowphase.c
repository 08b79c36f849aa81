/*
 * stages/narrowphase.c - stages 3 and 4: how the shapes of awake contacts touch.
 *
 * Contacts whose bodies have hardly moved are followed (contact_follow.c), those that are certain to stay apart are passed by
 * (narrowphase_sift.c). Every other awake one is looked at on its own: one that goes on touching has its lane rewritten in
 * place; one whose state changes is put on a list. Then the list is worked through in contact order: lanes are taken and
 * freed, islands linked, events logged, ended pairs removed. Only the second part changes shared tables.
 *
 * Contacts are looked at in windows of a few: all of a window are begun, then the manifolds of its pairs
 * of boxes and the like are made side by side, then each is finished in order. So memory is asked for early, and the
 * results are those of one by one.
 *
 * Reads bodies, geometry, proxies; writes contacts, lanes, and through them islands and events; marks
 * bodies that have static ones about them.
 */
#include "geometry/manifold_boxes.h"
#include "stages/narrowphase_sift.h"

#include <string.h>

/* What the second part has to do for a contact. */
enum { CHANGE_NONE = 0, CHANGE_BEGIN = 1, CHANGE_END = 2, CHANGE_OWED = 3 };

static int32_t boxes_overlap(const cn_world *world, const cni_contact *c)
{
	return cni_aabb_overlap(&cni_proxy_at(world, c->proxy[0])->fat, &cni_proxy_at(world, c->proxy[1])->fat);
}

/* ---- one-way platforms ---- */

/* Does the other shape come down on the side that the platform's local +y points to? */
static int32_t lands_on_platform(const cn_world *world, const cni_contact *c, const cni_manifold *m)
{
	int32_t side = cni_shape_at(world, cni_proxy_at(world, c->proxy[0])->shape)->flags & CN_SHAPE_ONE_WAY ? 0 : 1;
	const cni_body *a = cni_body_at(world, c->body[0]), *platform = cni_body_at(world, c->body[side]);
	cni_vec2 up = cni_rotate(platform->q, cni_v(0.0f, 1.0f)), n = cni_rotate(a->q, m->normal);
	float deepest = m->points[0].separation;
	if (side == 1)
		n = cni_neg(n);
	if (m->count == 2)
		deepest = cni_min(deepest, m->points[1].separation);
	return cni_dot(n, up) > 0.7f && deepest > -world->settings.contact_margin;
}

/* A shape that first touches from below or from the side passes until it is out again. */
static void let_pass(const cn_world *world, cni_contact *c, cni_manifold *m)
{
	if (m->count == 0)
		c->flags &= ~(uint32_t)CNI_CONTACT_PASSING;
	else if (!(c->flags & (CNI_CONTACT_TOUCHING | CNI_CONTACT_PASSING)) && !lands_on_platform(world, c, m))
		c->flags |= CNI_CONTACT_PASSING;
	if (c->flags & CNI_CONTACT_PASSING)
		m->count = 0;
}

/* ---- sensors ---- */

static int32_t sensor_update(const cni_touch *t)
{
	int32_t k, overlaps = 0, sensing = (t->contact->flags & CNI_CONTACT_SENSING) != 0;
	for (k = 0; k < t->manifold.count; ++k)
		overlaps |= t->manifold.points[k].separation <= 0.0f;
	if (overlaps)
		return sensing ? CHANGE_NONE : CHANGE_BEGIN;
	return sensing || !t->boxes_overlap ? CHANGE_END : CHANGE_NONE;
}

/* The user may make a touching pair pass through each other for this step. */
static void ask_user(cn_world *world, int32_t contact)
{
	cn_contact_event event;
	int32_t solve;
	if (world->pre_solve == NULL)
		return;
	cni_contact_describe(world, contact, cni_contact_at(world, contact)->flags & CNI_CONTACT_ENTERED ? CN_EVENT_ENTER : CN_EVENT_STAY, &event);
	++world->locked;
	solve = world->pre_solve(world, &event, world->pre_solve_user);
	--world->locked;
	if (!solve)
		cni_contact_write_empty(world, contact);
}

static void write_and_ask(cn_world *world, int32_t contact, const cni_touch *t)
{
	cni_contact_write(world, t->contact, t->a, t->b, &t->manifold, t->gap, t->radius);
	if (t->contact->flags & CNI_CONTACT_PRE_SOLVE)
		ask_user(world, contact);
}

/* What becomes of a contact whose manifold is known: rewrites its lane if it goes on touching. */
static int32_t contact_update(cn_world *world, int32_t contact, cni_touch *t)
{
	cni_contact *c = t->contact;
	int32_t touching = (c->flags & CNI_CONTACT_TOUCHING) != 0;
	if (c->flags & CNI_CONTACT_SENSOR)
		return sensor_update(t);
	if (c->flags & CNI_CONTACT_ONE_WAY)
		let_pass(world, c, &t->manifold);
	if (t->manifold.count > 0 && !touching)
		return CHANGE_BEGIN;
	if (t->manifold.count > 0)
		write_and_ask(world, contact, t);
	else if (touching || !t->boxes_overlap)
		return CHANGE_END;
	return c->flags & (CNI_CONTACT_CREATED_OWED | CNI_CONTACT_ENTER_OWED) ? CHANGE_OWED : CHANGE_NONE;
}

/* Sensors see what overlaps now. */
static float look_ahead(const cni_contact *c, float dt)
{
	return c->flags & CNI_CONTACT_SENSOR ? 0.0f : dt;
}

/* The manifold is computed once more: few contacts begin in a step, and keeping it for all that might
   takes more memory than the contacts themselves. */
static void change_begin(cn_world *world, int32_t contact, float dt)
{
	cni_touch_pair pair = cni_touch_pair_of(world, cni_contact_at(world, contact), contact);
	cni_touch t;
	if (!cni_touch_begin(world, &pair, dt, &t))
		return;
	cni_touch_collide(&t);
	cni_touch_finish(world, dt, &t);
	if (t.manifold.count == 0)
		return;
	if (cni_contact_begin(world, contact, &t.manifold, t.gap, t.radius)) {
		if (cni_contact_at(world, contact)->flags & CNI_CONTACT_PRE_SOLVE)
			ask_user(world, contact);
		return;
	}
	world->warnings |= CN_WARNING_CONTACT_MEMORY;
	++world->pairs_not_added;
}

/* A pair whose boxes are apart ends for good. Without memory for that it stays, and may be found once more. */
static void pair_end(cn_world *world, int32_t contact)
{
	if (!boxes_overlap(world, cni_contact_at(world, contact)) && !cni_contact_destroy(world, contact))
		world->pairs_may_repeat = CNI_PAIRS_ALL;
}

/* Sensor pairs end and begin by themselves: nothing is solved. */
static void sensor_change(cn_world *world, int32_t contact, int32_t change)
{
	if (!cni_contact_sense(world, contact, change == CHANGE_BEGIN))
		world->pairs_may_repeat = CNI_PAIRS_ALL;
	else if (change == CHANGE_END)
		pair_end(world, contact);
}

static void change_apply(cn_world *world, int32_t contact, int32_t change, float dt)
{
	const cni_contact *c = cni_contact_at(world, contact);
	if (c->flags & CNI_CONTACT_SENSOR) {
		sensor_change(world, contact, change);
		return;
	}
	if (change != CHANGE_END || boxes_overlap(world, c)) /* else it goes before it was told of */
		cni_contact_pay_owed(world, contact, CNI_CONTACT_CREATED_OWED, CN_EVENT_CREATED);
	if (change == CHANGE_OWED)
		cni_contact_pay_owed(world, contact, CNI_CONTACT_ENTER_OWED, CN_EVENT_ENTER);
	if (change == CHANGE_BEGIN)
		change_begin(world, contact, dt);
	if (change != CHANGE_END)
		return;
	if ((c->flags & CNI_CONTACT_TOUCHING) && !cni_contact_end(world, contact))
		world->pairs_may_repeat = CNI_PAIRS_ALL;
	else
		pair_end(world, contact);
}

/* ---- windows ---- */

/* Contacts that are looked at together. */
#define WINDOW CNI_BOX_PAIRS

typedef struct window {
	cni_touch_pair pair[WINDOW + CNI_SIFT_BATCH]; /* to be looked at; what is beyond a window waits for the next */
	int32_t count;
	cni_touch touch[WINDOW];
	int32_t column[WINDOW];  /* in boxes, or one of the below */
	cni_box_batch boxes;
	cni_box_kernel_fn *kernel;
	int32_t prefetches;
} window;

enum {
	COLUMN_NONE = -1,   /* not a pair for the batch */
	COLUMN_APART = -2   /* no manifold */
};

/* Returns how many contacts it holds: fewer than a window only where there are no more. */
static int32_t window_fill(window *w, cni_sift *sift)
{
	int32_t more = 0;
	for (; w->count < WINDOW && more != CNI_NONE; w->count += cni_max_i(more, 0))
		more = cni_sift_batch(sift, w->pair + w->count);
	return cni_min_i(w->count, WINDOW);
}

/* Asks for what a lane is written from. Inlined by force: compilers take a function that only prefetches for one that
   does nothing. */
CNI_INLINE void lane_prefetch(const cn_world *world, const cni_touch_pair *p)
{
	const cni_contact_block *block;
	int32_t l = p->contact->slot % CNI_LANES;
	if (!(p->contact->flags & CNI_CONTACT_TOUCHING))
		return;
	block = cni_block_at(world, p->contact->slot / CNI_LANES);
	CNI_PREFETCH(cni_motions(world) + p->body[0]->awake);
	CNI_PREFETCH(cni_motions(world) + p->body[1]->awake);
	CNI_PREFETCH(&block->p[0].jn[l]);
	CNI_PREFETCH(&block->p[1].jn[l]);
}

/* A box takes more than a line. */
CNI_INLINE void geometry_prefetch(const cn_world *world, const cni_proxy *p)
{
	const cni_geometry *g = cni_proxy_geometry(&world->blocks, p);
	CNI_PREFETCH(g);
	CNI_PREFETCH(g + 2);
}

static void window_prefetch(const cn_world *world, const window *w, int32_t count)
{
	int32_t k;
	for (k = 0; k < count; ++k) {
		geometry_prefetch(world, w->pair[k].proxy[0]);
		geometry_prefetch(world, w->pair[k].proxy[1]);
		lane_prefetch(world, &w->pair[k]);
	}
}

static void window_begin(const cn_world *world, window *w, int32_t count, float dt)
{
	int32_t k;
	w->boxes.count = 0;
	if (w->prefetches)
		window_prefetch(world, w, count);
	for (k = 0; k < count; ++k) {
		cni_contact *c = w->pair[k].contact;
		cni_touch *t = &w->touch[k];
		w->column[k] = COLUMN_APART;
		if (!cni_touch_begin(world, &w->pair[k], look_ahead(c, dt), t))
			continue;
		w->column[k] = COLUMN_NONE;
		if (w->kernel != NULL && cni_boxes_take(&t->in))
			w->column[k] = cni_boxes_add(&w->boxes, &t->in, &c->cache);
	}
}

static int32_t window_finish(cn_world *world, window *w, int32_t k, float dt)
{
	cni_touch *t = &w->touch[k];
	if (w->column[k] == COLUMN_NONE)
		cni_touch_collide(t);
	else if (w->column[k] >= 0)
		cni_boxes_read(&w->boxes, w->column[k], &t->in, &t->contact->cache, &t->manifold);
	cni_touch_finish(world, look_ahead(t->contact, dt), t);
	return contact_update(world, w->pair[k].index, t);
}

/* ---- what is to change ---- */

/* Without memory for the list a few changes are made in each step, and the rest is found again in the next. */
#define CHANGES_LEAST 64

typedef struct change_list {
	uint32_t *items;  /* contact << 2 | what */
	int32_t count, room;
	uint32_t few[CHANGES_LEAST];
} change_list;

static void changes_begin(cn_world *world, change_list *list, int32_t contacts)
{
	list->items = (uint32_t *)cni_arena_push(&world->arena, sizeof(uint32_t) * (uint64_t)contacts);
	list->room = list->items != NULL ? contacts : CHANGES_LEAST;
	if (list->items == NULL)
		list->items = list->few;
	list->count = 0;
}

static void change_add(cn_world *world, change_list *list, int32_t contact, int32_t change)
{
	if (change == CHANGE_NONE)
		return;
	if (list->count < list->room) {
		list->items[list->count++] = (uint32_t)contact << 2 | (uint32_t)change;
		return;
	}
	world->warnings |= CN_WARNING_CONTACT_MEMORY;
	world->pairs_may_repeat = CNI_PAIRS_ALL;
	if (cni_contact_at(world, contact)->flags & CNI_CONTACT_TOUCHING)
		cni_contact_write_empty(world, contact);
}

static void changes_apply(cn_world *world, change_list *list, float dt)
{
	int32_t k;
	for (k = 0; k < list->count; ++k)
		change_apply(world, (int32_t)(list->items[k] >> 2), (int32_t)(list->items[k] & 3u), dt);
	if (list->items != list->few)
		cni_arena_pop(&world->arena, list->items);
}

/* Takes the first contacts of the window away. */
static void window_drop(window *w, int32_t count)
{
	w->count -= count;
	if (w->count > 0)
		memmove(w->pair, w->pair + count, sizeof(cni_touch_pair) * (size_t)w->count);
}

static void contacts_look_at(cn_world *world, cni_sift *sift, change_list *changes, float dt)
{
	window w;
	int32_t k, count;
	w.kernel = cni_box_kernel_choose();
	w.prefetches = sift->prefetches;
	w.count = 0;
	while ((count = window_fill(&w, sift)) > 0) {
		window_begin(world, &w, count, dt);
		cni_boxes_run(&w.boxes, w.kernel);
		for (k = 0; k < count; ++k)
			change_add(world, changes, w.pair[k].index, window_finish(world, &w, k, dt));
		window_drop(&w, count);
	}
}

void cni_stage_narrowphase(cn_world *world, float dt)
{
	int32_t *contacts = (int32_t *)world->apart.data, apart = world->apart.count, count;
	change_list changes;
	cni_sift sift;
	if (contacts == NULL)
		return; /* there has never been a contact */
	count = apart + cni_contacts_follow(world, dt, contacts + apart); /* the list has room for every contact */
	changes_begin(world, &changes, count);
	cni_sift_begin(&sift, world, contacts, apart, count, dt);
	contacts_look_at(world, &sift, &changes, dt);
	cni_sift_end(&sift);
	changes_apply(world, &changes, dt);
}
