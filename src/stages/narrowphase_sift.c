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
 * Reads contacts, bodies, boxes; marks bodies that have static ones about them.
 */
#include "stages/narrowphase_sift.h"

/* Contacts of fewer are in the cache anyway. */
#define PREFETCH_FROM 2048

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

/* Worth a pass over all bodies where each has a contact that is apart. */
static cni_sift_body *sift_bodies_make(cn_world *world, int32_t apart, float dt)
{
	int32_t k, count = world->body_handles.slots.count;
	cni_sift_body *bodies;
	if (apart < PREFETCH_FROM || apart < count)
		return NULL;
	bodies = (cni_sift_body *)cni_arena_push(&world->arena, sizeof(cni_sift_body) * (uint64_t)count);
	if (bodies == NULL)
		return NULL;
	for (k = 0; k < count; ++k)
		bodies[k] = sift_body_make(cni_body_at(world, k), dt);
	return bodies;
}

/* Records reach from one line into the next: both ends are asked for. Inlined by force, like those below: compilers take a
   function that only prefetches for one that does nothing. */
CNI_INLINE void record_prefetch(const cni_contact *c)
{
	CNI_PREFETCH(c);
	CNI_PREFETCH(&c->flags);
}

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

CNI_INLINE void sides_prefetch(const cni_sift *s, const cni_contact *c)
{
	int32_t side;
	for (side = 0; side < 2; ++side) {
		CNI_PREFETCH(&cni_proxy_at(s->world, c->proxy[side])->fat);
		if (s->bodies != NULL) {
			CNI_PREFETCH(&s->bodies[c->body[side]]);
		} else {
			CNI_PREFETCH(cni_body_at(s->world, c->body[side]));
			CNI_PREFETCH(&cni_body_at(s->world, c->body[side])->vx);
		}
	}
}

/* Finds the records of the batch at `at`, and asks for their bodies and boxes and for the records of the batch after. */
static void batch_find(cni_sift *s)
{
	int32_t k, end = cni_min_i(s->at + CNI_SIFT_BATCH, s->count), ahead = s->prefetches ? cni_min_i(end + CNI_SIFT_BATCH, s->count) : end;
	for (k = end; k < ahead; ++k)
		record_prefetch(cni_contact_at(s->world, s->contacts[k]));
	for (k = s->at; k < end; ++k) {
		cni_contact *c = s->next[k - s->at] = cni_contact_at(s->world, s->contacts[k]);
		if (s->prefetches)
			sides_prefetch(s, c);
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
static int32_t stays_apart(const cn_world *world, const cni_touch_pair *p, const cni_sift_body *a, const cni_sift_body *b)
{
	const uint32_t looked_at = CNI_CONTACT_SENSING | CNI_CONTACT_PASSING | CNI_CONTACT_CREATED_OWED;
	return circles_apart(a, b, world->settings.contact_margin) & ((p->contact->flags & looked_at) == 0) &
	       boxes_overlap(&p->proxy[0]->fat, &p->proxy[1]->fat);
}

/* Does it have to be looked at? What touches always. */
static int32_t contact_sift(const cni_sift *s, const cni_touch_pair *p, int32_t touches)
{
	cni_sift_body a, b;
	if (s->bodies != NULL) {
		const cni_sift_body *of_a = &s->bodies[p->contact->body[0]], *of_b = &s->bodies[p->contact->body[1]];
		if (of_a->radius <= 0.0f || of_b->radius <= 0.0f)
			cni_contact_mark_static(p->body[0], p->body[1]);
		return touches || !stays_apart(s->world, p, of_a, of_b);
	}
	cni_contact_mark_static(p->body[0], p->body[1]);
	if (touches)
		return 1;
	a = sift_body_make(p->body[0], s->dt);
	b = sift_body_make(p->body[1], s->dt);
	return !stays_apart(s->world, p, &a, &b);
}

void cni_sift_begin(cni_sift *s, cn_world *world, const int32_t *contacts, int32_t apart, int32_t count, float dt)
{
	s->world = world;
	s->contacts = contacts;
	s->apart = apart;
	s->count = count;
	s->dt = dt;
	s->bodies = sift_bodies_make(world, apart, dt);
	s->at = 0;
	s->prefetches = count >= PREFETCH_FROM;
	batch_find(s);
}

void cni_sift_end(cni_sift *s)
{
	cni_arena_pop(&s->world->arena, s->bodies);
}

int32_t cni_sift_batch(cni_sift *s, cni_touch_pair *out)
{
	cni_contact *batch[CNI_SIFT_BATCH];
	int32_t k, from = s->at, size = cni_min_i(CNI_SIFT_BATCH, s->count - from), count = 0;
	if (size <= 0)
		return CNI_NONE;
	for (k = 0; k < size; ++k)
		batch[k] = s->next[k];
	s->at += size;
	batch_find(s);
	for (k = 0; k < size; ++k) {
		cni_touch_pair *p = &out[count];
		*p = cni_touch_pair_of(s->world, batch[k], s->contacts[from + k]);
		if (p->contact->flags & CNI_CONTACT_ENTERED)
			p->contact->flags &= ~(uint32_t)CNI_CONTACT_ENTERED;
		count += contact_sift(s, p, from + k >= s->apart);
		if (s->prefetches)
			pair_prefetch(p);
	}
	return count;
}
