/*
 * stages/narrowphase_sift.c - passes by what stays apart.
 *
 * Most pairs of a heap in motion are only neighbours: their boxes overlap, for boxes look ahead, and circles around the two
 * bodies are apart. Such a contact costs what it takes to fetch its memory. So records are asked for early, where there are
 * many contacts what is needed of bodies is copied to where it takes a part of the lines, and nothing branches on what
 * nobody can guess.
 *
 * Passing by is an early out only: what it passes by would come out apart, and as its boxes overlap it stays a contact.
 *
 * Reads contacts, bodies, boxes; marks bodies that have static ones about them. Writes flags of its own contacts.
 */
#include "stages/narrowphase_sift.h"

/* Contacts of fewer are in the cache anyway. */
#define PREFETCH_FROM 2048

/* Bodies that one worker copies, at least: 10 us of work. */
#define BODIES_A_RANGE 512

/* The high part of a centre is within half a unit of its last place. */
static cni_sift_body sift_body_make(const cni_body *b, float dt)
{
	cni_sift_body s;
	s.x = b->cx;
	s.y = b->cy;
	s.radius = CNI_CIRCLES_APART * (b->extent + dt * cni_abs(b->w) * b->extent) + FLT_EPSILON * (cni_abs(b->cx) + cni_abs(b->cy));
	if (b->awake == 0)
		s.radius = -s.radius;
	s.ahead_x = dt * b->vx;
	s.ahead_y = dt * b->vy;
	return s;
}

static void bodies_range(void *context, int32_t begin, int32_t end, int32_t worker)
{
	const cni_sift_list *list = (const cni_sift_list *)context;
	int32_t k;
	(void)worker;
	for (k = begin; k < end; ++k)
		list->bodies[k] = sift_body_make(cni_body_at(list->world, k), list->dt);
}

/* Worth a pass over all bodies where each has a contact that is apart. */
static void bodies_make(cni_sift_list *list)
{
	cn_world *world = list->world;
	int32_t count = world->body_handles.slots.count;
	if (list->apart < PREFETCH_FROM || list->apart < count)
		return;
	list->bodies = (cni_sift_body *)cni_arena_push(&world->arena, sizeof(cni_sift_body) * (uint64_t)count);
	if (list->bodies != NULL)
		cni_parallel_for(world, count, BODIES_A_RANGE, bodies_range, list);
}

/* Inlined by force, like those below: compilers take a function that only prefetches for one that does nothing. */
CNI_INLINE void pair_prefetch(const cni_touch_pair *p)
{
	int32_t side;
	CNI_PREFETCH(&p->contact->cache);
	for (side = 0; side < 2; ++side) {
		CNI_PREFETCH(p->body[side]);
		CNI_PREFETCH(&p->body[side]->vx);
		CNI_PREFETCH(&p->proxy[side]->geometry);
	}
}

CNI_INLINE void item_prefetch(const cni_sift *s, const cni_sift_item *item)
{
	int32_t side;
	for (side = 0; side < 2; ++side) {
		int32_t body = item->contact->body[side];
		CNI_PREFETCH(&item->proxy[side]->fat);
		if (s->of.bodies != NULL) {
			CNI_PREFETCH(&s->of.bodies[body]);
		} else {
			CNI_PREFETCH(cni_body_at(s->of.world, body));
			CNI_PREFETCH(&cni_body_at(s->of.world, body)->vx);
		}
	}
}

/* Looks up the batch at `at`, whose records were asked for, and asks for its bodies and boxes. */
static void batch_find(cni_sift *s)
{
	int32_t k, size = cni_min_i(CNI_SIFT_BATCH, s->end - s->at);
	cni_sift_item *batch = s->batch[s->side];
	for (k = 0; k < size; ++k) {
		cni_contact *c = s->records[k];
		batch[k].contact = c;
		batch[k].proxy[0] = cni_proxy_at(s->of.world, c->proxy[0]);
		batch[k].proxy[1] = cni_proxy_at(s->of.world, c->proxy[1]);
		if (s->of.prefetches)
			item_prefetch(s, &batch[k]);
	}
}

/* Asks for the records of the batch that begins at a contact. They reach from one line into the next: both ends are asked
   for. */
static void records_find(cni_sift *s, int32_t from)
{
	int32_t k, size = cni_min_i(CNI_SIFT_BATCH, s->end - from);
	for (k = 0; k < size; ++k) {
		cni_contact *c = s->records[k] = cni_contact_at(s->of.world, s->of.contacts[from + k]);
		CNI_PREFETCH(c);
		CNI_PREFETCH(&c->flags);
	}
}

/* Every comparison is made, whatever the others say. */
static int32_t boxes_overlap(const cni_aabb *a, const cni_aabb *b)
{
	return (a->x0 <= b->x1) & (b->x0 <= a->x1) & (a->y0 <= b->y1) & (b->y0 <= a->y1);
}

/* The reach is that of a cni_pair_motion at most, whose sum is taken along other axes. */
static int32_t circles_apart(const cni_sift_body *a, const cni_sift_body *b, float margin)
{
	float dx = b->x - a->x, dy = b->y - a->y, reach;
	reach = cni_max(margin, 1.4143f * (cni_abs(b->ahead_x - a->ahead_x) + cni_abs(b->ahead_y - a->ahead_y)));
	reach = cni_abs(a->radius) + cni_abs(b->radius) + CNI_CIRCLES_APART * reach;
	return dx * dx + dy * dy > reach * reach;
}

/* Contacts of which there is something to tell, or that may have, are looked at. */
static int32_t stays_apart(const cni_sift *s, const cni_sift_item *item, const cni_sift_body *a, const cni_sift_body *b)
{
	const uint32_t looked_at = CNI_CONTACT_SENSING | CNI_CONTACT_PASSING | CNI_CONTACT_CREATED_OWED;
	return circles_apart(a, b, s->of.world->settings.contact_margin) & ((item->contact->flags & looked_at) == 0) &
	       boxes_overlap(&item->proxy[0]->fat, &item->proxy[1]->fat);
}

/* Does it have to be looked at? What touches always. */
static int32_t item_sift(const cni_sift *s, const cni_sift_item *item, int32_t touches)
{
	cni_body *body_a, *body_b;
	const cni_sift_body *of_a, *of_b;
	cni_sift_body a, b;
	if (s->of.bodies != NULL) {
		of_a = &s->of.bodies[item->contact->body[0]];
		of_b = &s->of.bodies[item->contact->body[1]];
		if (of_a->radius <= 0.0f || of_b->radius <= 0.0f)
			cni_contact_mark_static(cni_body_at(s->of.world, item->contact->body[0]), cni_body_at(s->of.world, item->contact->body[1]));
		if (touches)
			return 1;
	} else {
		body_a = cni_body_at(s->of.world, item->contact->body[0]);
		body_b = cni_body_at(s->of.world, item->contact->body[1]);
		cni_contact_mark_static(body_a, body_b);
		if (touches)
			return 1;
		a = sift_body_make(body_a, s->of.dt);
		b = sift_body_make(body_b, s->of.dt);
		of_a = &a;
		of_b = &b;
	}
	return !stays_apart(s, item, of_a, of_b);
}

static cni_touch_pair pair_of(const cni_sift *s, const cni_sift_item *item, int32_t index)
{
	cni_touch_pair p;
	p.contact = item->contact;
	p.body[0] = cni_body_at(s->of.world, item->contact->body[0]);
	p.body[1] = cni_body_at(s->of.world, item->contact->body[1]);
	p.proxy[0] = item->proxy[0];
	p.proxy[1] = item->proxy[1];
	p.index = index;
	return p;
}

void cni_sift_open(cni_sift_list *list, cn_world *world, const int32_t *contacts, int32_t apart, int32_t count, float dt)
{
	list->world = world;
	list->contacts = contacts;
	list->apart = apart;
	list->count = count;
	list->dt = dt;
	list->bodies = NULL;
	list->prefetches = count >= PREFETCH_FROM;
	bodies_make(list);
}

void cni_sift_close(cni_sift_list *list)
{
	cni_arena_pop(&list->world->arena, list->bodies);
}

void cni_sift_begin(cni_sift *s, const cni_sift_list *list, int32_t begin, int32_t end)
{
	s->of = *list;
	s->at = begin;
	s->end = end;
	s->side = 0;
	records_find(s, begin);
	batch_find(s);
	records_find(s, begin + CNI_SIFT_BATCH);
}

/* The batch after is looked up first, so that its memory is on its way. */
int32_t cni_sift_batch(cni_sift *s, cni_touch_pair *out)
{
	const cni_sift_item *batch = s->batch[s->side];
	int32_t looked_at[CNI_SIFT_BATCH], k, from = s->at, size = cni_min_i(CNI_SIFT_BATCH, s->end - from), count = 0;
	if (size <= 0)
		return CNI_NONE;
	s->at += size;
	s->side ^= 1;
	batch_find(s);
	records_find(s, s->at + CNI_SIFT_BATCH);
	for (k = 0; k < size; ++k) {
		if (batch[k].contact->flags & CNI_CONTACT_ENTERED)
			batch[k].contact->flags &= ~(uint32_t)CNI_CONTACT_ENTERED;
		looked_at[count] = k;
		count += item_sift(s, &batch[k], from + k >= s->of.apart);
	}
	for (k = 0; k < count; ++k) {
		out[k] = pair_of(s, &batch[looked_at[k]], s->of.contacts[from + looked_at[k]]);
		if (s->of.prefetches)
			pair_prefetch(&out[k]);
	}
	return count;
}
