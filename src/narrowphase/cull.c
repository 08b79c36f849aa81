/*
 * narrowphase/cull.c - skips pairs that stay apart in this step.
 *
 * Most pairs of a moving heap are only neighbours: their boxes, which reach ahead, overlap, and the circles around the two bodies
 * are apart. Such a pair costs mostly memory accesses. So the fields of bodies that the test reads are copied to a dense array
 * once a step; four pairs are tested side by side; long lists are prefetched, a few lines at a time; the test has no
 * unpredictable branches.
 *
 * Culling only skips work: a culled pair would produce no manifold points, and its boxes overlap, so its contact stays.
 *
 * Pairs are tested in every step: in a fast crowd (spinner) bodies travel 0.5 to 0.75 m a step, the mean gap of pairs is 0.5 m and
 * 97% of the bodies get new boxes, so a test by accumulated travel would skip 0.3% of the pairs.
 *
 * Reads contacts, bodies, boxes, geometry; marks bodies with static neighbours. Writes flags of its own contacts.
 */
#include "base/bitset.h"
#include "base/cpu.h"
#include "narrowphase/cull.h"
#if CNI_HAS_WIDE_4
#define CNI_WIDTH 4
#include "base/wide.h"
#endif

/* Shorter lists stay in the cache. */
#define PREFETCH_FROM 2048

/* Prefetch distance of records, and of the bodies and boxes that they name, in contacts. */
#define RECORDS_AHEAD 24
#define MEMBERS_AHEAD 12

/* Least number of bodies that one worker copies: 10 us of work. */
#define BODIES_A_RANGE 512

/* Contacts that have an event to report, or may get one, are not culled. */
#define LOOKED_AT ((uint32_t)CNI_CONTACT_SENSING | (uint32_t)CNI_CONTACT_PASSING | (uint32_t)CNI_CONTACT_CREATED_OWED)
#define ENTERED ((uint32_t)CNI_CONTACT_ENTERED)

/* ---- bodies ---- */

/* The high part of a centre is within half a unit of its last place. */
static cni_cull_body cull_body_make(const cni_body *b, float dt)
{
	float radius = CNI_CIRCLES_APART * b->extent + FLT_EPSILON * (cni_abs(b->cx) + cni_abs(b->cy));
	cni_cull_body s = { b->cx, b->cy, dt * b->vx, dt * b->vy, b->awake == 0 ? -radius : radius };
	return s;
}

static void bodies_range(void *context, int32_t begin, int32_t end)
{
	const cni_cull_list *list = (const cni_cull_list *)context;
	for (int32_t k = begin; k < end; ++k)
		list->bodies[k] = cull_body_make(cni_body_at(list->world, k), list->dt);
}

/* The copy pays where the average body is in a contact that is apart; a contact has two bodies. */
static void bodies_make(cni_cull_list *list)
{
	cn_world *world = list->world;
	int32_t count = world->body_handles.slots.count;
	if (!CNI_CULL_LOOKS_AHEAD || list->apart < count / 2)
		return;
	list->bodies = (cni_cull_body *)cni_arena_push(&world->arena, sizeof(cni_cull_body) * (uint64_t)count);
	if (list->bodies != NULL)
		cni_parallel_for(world, count, BODIES_A_RANGE, bodies_range, list);
}

/* ---- prefetching: inlined by force, as compilers remove calls of functions that only prefetch ---- */

CNI_INLINE void body_prefetch(const cni_body *b)
{
	CNI_PREFETCH(b);
	CNI_PREFETCH(&b->vx);
}

/* A batch begins at a multiple of its size, so its places, and those of four contacts from a multiple of four on, lie side by side. */
typedef char cni_cull_finds_far_enough[!CNI_CULL_LOOKS_AHEAD || (RECORDS_AHEAD % 4 == 0 && MEMBERS_AHEAD % 4 == 0 &&
	CNI_CULL_BATCH + RECORDS_AHEAD <= CNI_CULL_PLACES && MEMBERS_AHEAD + 4 <= CNI_CULL_MEMBERS) ? 1 : -1];

CNI_INLINE int32_t place_of(const cni_cull *s, int32_t k) { return (int32_t)((uint32_t)(k - s->begin) % CNI_CULL_PLACES); }

/* Memory that cni_touch_begin reads. */
CNI_INLINE void pair_prefetch(const cni_touch_pair *p)
{
	CNI_PREFETCH(&p->contact->cache);
	for (int32_t side = 0; side < 2; ++side) {
		CNI_PREFETCH(&p->proxy[side]->fat);
		CNI_PREFETCH(&p->proxy[side]->geometry);
		body_prefetch(p->body[side]);
	}
}

CNI_INLINE void members_prefetch(const cni_cull_list *list, const cni_contact *c, const cni_proxy **proxy)
{
	for (int32_t side = 0; side < 2; ++side) {
		proxy[side] = cni_proxy_at(list->world, c->proxy[side]);
		CNI_PREFETCH(&proxy[side]->fat);
		if (list->bodies != NULL)
			CNI_PREFETCH(&list->bodies[c->body[side]]);
		else
			body_prefetch(cni_body_at(list->world, c->body[side]));
	}
}

/* Prefetches bodies and boxes of contact k at a place, whose record was prefetched earlier. inside: k is in the range and does not touch. */
CNI_INLINE void ask_for_members(cni_cull *s, int32_t k, int32_t place, int32_t inside)
{
	if (!inside && k >= s->end)
		return;
	cni_contact *c = s->record[place];
	if (inside || k < s->of.apart) {
		members_prefetch(&s->of, c, s->proxy[place]);
		return;
	}
	cni_touch_pair *pair = &s->touching[(uint32_t)k % CNI_CULL_MEMBERS];
	*pair = cni_touch_pair_of(s->of.world, c, s->of.contacts[k]);
	pair_prefetch(pair);
}

/* Records span two cache lines. */
CNI_INLINE void ask_for_record(cni_cull *s, int32_t k, int32_t place, int32_t inside)
{
	if (!inside && k >= s->end)
		return;
	cni_contact *c = s->record[place] = cni_contact_at(s->of.world, s->of.contacts[k]);
	CNI_PREFETCH(c);
	CNI_PREFETCH(&c->flags);
}

/* Prefetches for contacts after `at` to at + count - 1, 4 or 1, which are culled now. Finding a record in its table takes five instructions,
   so those found here are kept until they are used. */
CNI_INLINE void prefetch_ahead(cni_cull *s, int32_t at, int32_t count)
{
	int32_t last = at + count - 1 + RECORDS_AHEAD, records = place_of(s, at + RECORDS_AHEAD), members = place_of(s, at + MEMBERS_AHEAD);
	if (last < s->end && last < s->of.apart) {
		for (int32_t l = 0; l < count; ++l) {
			ask_for_record(s, at + RECORDS_AHEAD + l, records + l, 1);
			ask_for_members(s, at + MEMBERS_AHEAD + l, members + l, 1);
		}
		return;
	}
	for (int32_t l = 0; l < count; ++l) {
		ask_for_record(s, at + RECORDS_AHEAD + l, records + l, 0);
		ask_for_members(s, at + MEMBERS_AHEAD + l, members + l, 0);
	}
}

/* ---- one contact ---- */

/*
 * Do the circles stay out of each other's margin while one moves past the other? A body that turns stays in the circle around its centre
 * of mass. The least distance is that of the nearest point of a segment (Ericson, "Real-Time Collision Detection", 2005, 5.1.2).
 */
static int32_t circles_apart(const cni_cull_body *a, const cni_cull_body *b, float margin)
{
	cni_vec2 between = cni_v(b->x - a->x, b->y - a->y), travel = cni_v(b->ahead_x - a->ahead_x, b->ahead_y - a->ahead_y);
	float reach = cni_abs(a->radius) + cni_abs(b->radius) + CNI_CIRCLES_APART * margin;
	float part = -cni_dot(between, travel) / cni_max(cni_length_sq(travel), FLT_MIN);
	return cni_length_sq(cni_madd(between, cni_clamp(part, 0.0f, 1.0f), travel)) > reach * reach;
}

static void contact_mark_static(const cn_world *world, const cni_contact *c)
{
	cni_contact_mark_static(cni_body_at(world, c->body[0]), cni_body_at(world, c->body[1]));
}

/* The contact no longer counts as one that began in the last step. */
static void contact_enters_no_more(cni_contact *c)
{
	if (c->flags & ENTERED)
		c->flags &= ~ENTERED;
}

/* Returns 1 when the pair at a place stays apart for certain. */
static uint32_t one_cull(const cni_cull *s, int32_t place)
{
	cni_contact *c = s->record[place];
	const cni_proxy *const *proxy = s->proxy[place];
	const cni_cull_body *a, *b;
	cni_cull_body made_a, made_b;
	if (cni_cull_bodies(&s->of) != NULL) {
		a = &cni_cull_bodies(&s->of)[c->body[0]];
		b = &cni_cull_bodies(&s->of)[c->body[1]];
	} else {
		made_a = cull_body_make(cni_body_at(s->of.world, c->body[0]), s->of.dt);
		made_b = cull_body_make(cni_body_at(s->of.world, c->body[1]), s->of.dt);
		a = &made_a;
		b = &made_b;
	}
	if (a->radius <= 0.0f || b->radius <= 0.0f)
		contact_mark_static(s->of.world, c);
	contact_enters_no_more(c);
	return (uint32_t)(circles_apart(a, b, s->of.margin) & ((c->flags & LOOKED_AT) == 0) & cni_aabb_overlap_branchless(&proxy[0]->fat, &proxy[1]->fat));
}

/* ---- four side by side ---- */

#if CNI_HAS_WIDE_4

/* Input of four pairs, one row a pair. */
typedef struct cull_rows {
	cni_wide between[4];     /* difference of positions and of their changes in the step */
	cni_mask over[4];        /* the four comparisons of cni_aabb_overlap_branchless */
	uint32_t flags;          /* of all pairs, or-ed */
} cull_rows;

CNI_INLINE void rows_take(cull_rows *r, int32_t l, const cni_cull_body *a, const cni_cull_body *b, const cni_proxy *const *proxy,
	const cni_contact *c)
{
	cni_wide box_a = cni_wide_load_loose(&proxy[0]->fat.x0), box_b = cni_wide_load_loose(&proxy[1]->fat.x0);
	r->between[l] = cni_wide_load_loose(&b->x) - cni_wide_load_loose(&a->x);
	r->over[l] = __builtin_shufflevector(box_a, box_b, 0, 1, 4, 5) <= __builtin_shufflevector(box_b, box_a, 2, 3, 6, 7);
	r->flags |= c->flags;
}

/* Lane l is set where all lanes of mask l are. */
CNI_INLINE cni_mask all_of_each(const cni_mask *m)
{
	cni_mask low = __builtin_shufflevector(m[0], m[1], 0, 4, 1, 5) & __builtin_shufflevector(m[0], m[1], 2, 6, 3, 7);
	cni_mask high = __builtin_shufflevector(m[2], m[3], 0, 4, 1, 5) & __builtin_shufflevector(m[2], m[3], 2, 6, 3, 7);
	return __builtin_shufflevector(low, high, 0, 1, 4, 5) & __builtin_shufflevector(low, high, 2, 3, 6, 7);
}

/* Few contacts have such flags. */
static uint32_t four_by_flags(cni_contact *const *c, uint32_t apart)
{
	for (int32_t l = 0; l < 4; ++l) {
		contact_enters_no_more(c[l]);
		if (c[l]->flags & LOOKED_AT)
			apart &= ~(1u << l);
	}
	return apart;
}

/* one_cull of four pairs, as bits, with the same operations in each lane. */
static uint32_t four_cull(const cni_cull *s, cni_contact *const *c, const cni_proxy *const (*proxy)[2])
{
	const cn_world *world = s->of.world;
	const cni_cull_body *a[4], *b[4];
	const cni_wide zero = cni_wide_of(0.0f), one = cni_wide_of(1.0f), margin = cni_wide_of(CNI_CIRCLES_APART * s->of.margin);
	cni_wide radius_a, radius_b, dx, dy, ahead_x, ahead_y, reach, part;
	cull_rows r;
	r.flags = 0;
	for (int32_t l = 0; l < 4; ++l) {
		a[l] = &cni_cull_bodies(&s->of)[c[l]->body[0]];
		b[l] = &cni_cull_bodies(&s->of)[c[l]->body[1]];
		rows_take(&r, l, a[l], b[l], proxy[l], c[l]);
	}
	radius_a = (cni_wide){ a[0]->radius, a[1]->radius, a[2]->radius, a[3]->radius };
	radius_b = (cni_wide){ b[0]->radius, b[1]->radius, b[2]->radius, b[3]->radius };
	cni_wide_columns(r.between, &dx, &dy, &ahead_x, &ahead_y);
	reach = cni_wide_abs(radius_a) + cni_wide_abs(radius_b) + margin;
	part = -(dx * ahead_x + dy * ahead_y) / cni_wide_max(ahead_x * ahead_x + ahead_y * ahead_y, cni_wide_of(FLT_MIN));
	part = cni_wide_min(cni_wide_max(part, zero), one);
	dx += part * ahead_x;
	dy += part * ahead_y;
	uint32_t apart = cni_mask_bits((dx * dx + dy * dy > reach * reach) & all_of_each(r.over));
	for (uint32_t marks = cni_mask_bits((radius_a <= cni_wide_of(0.0f)) | (radius_b <= cni_wide_of(0.0f))); marks != 0; marks &= marks - 1)
		contact_mark_static(world, c[cni_bit_lowest32(marks)]);
	return r.flags & (LOOKED_AT | ENTERED) ? four_by_flags(c, apart) : apart;
}

#endif

/* ---- batches ---- */

/* Finds the records and the proxies of the next count contacts, where they were not found ahead. */
CNI_INLINE void batch_find(cni_cull *s, int32_t at, int32_t place, int32_t count)
{
	const cn_world *world = s->of.world;
	if (cni_cull_prefetches(&s->of)) {
		prefetch_ahead(s, at, count);
		return;
	}
	for (int32_t l = 0; l < count; ++l) {
		cni_contact *c = s->record[place + l] = cni_contact_at(world, s->of.contacts[at + l]);
		s->proxy[place + l][0] = cni_proxy_at(world, c->proxy[0]);
		s->proxy[place + l][1] = cni_proxy_at(world, c->proxy[1]);
	}
}

/* Pairs of a batch that stay apart, as bits. */
static uint32_t apart_of_batch(cni_cull *s, int32_t from, int32_t size)
{
	uint32_t apart = 0;
	int32_t k = 0, place = place_of(s, from);
#if CNI_HAS_WIDE_4
	for (; cni_cull_bodies(&s->of) != NULL && k + 4 <= size; k += 4) {
		batch_find(s, from + k, place + k, 4);
		apart |= four_cull(s, &s->record[place + k], (const cni_proxy *const (*)[2])&s->proxy[place + k]) << k;
	}
#endif
	for (; k < size; ++k) {
		batch_find(s, from + k, place + k, 1);
		apart |= one_cull(s, place + k) << k;
	}
	return apart;
}

static void batch_cull(cni_cull *s)
{
	int32_t size = cni_min_i(CNI_CULL_BATCH, cni_min_i(s->end, s->of.apart) - s->at);
	s->batch = s->at;
	s->at += size;
	s->left = ~apart_of_batch(s, s->batch, size) & (~0u >> (32 - size));
}

static int32_t take_left(cni_cull *s, cni_touch_pair *out, int32_t most)
{
	const cn_world *world = s->of.world;
	const int32_t *contacts = s->of.contacts + s->batch;
	int32_t count = 0, place = place_of(s, s->batch), prefetches = cni_cull_prefetches(&s->of);
	uint32_t left = s->left;
	for (; left != 0 && count < most; left &= left - 1) {
		int32_t l = cni_bit_lowest32(left);
		cni_touch_pair *p = &out[count++];
		p->contact = s->record[place + l];
		p->proxy[0] = s->proxy[place + l][0];
		p->proxy[1] = s->proxy[place + l][1];
		p->body[0] = cni_body_at(world, p->contact->body[0]);
		p->body[1] = cni_body_at(world, p->contact->body[1]);
		p->index = contacts[l];
		p->place = s->batch + l;
		if (prefetches)
			pair_prefetch(p);
	}
	s->left = left;
	return count;
}

/* Touching contacts are never culled. */
static int32_t take_touching(cni_cull *s, cni_touch_pair *out, int32_t most)
{
	const cn_world *world = s->of.world;
	int32_t at = s->at, count = cni_min_i(most, s->end - at), prefetches = cni_cull_prefetches(&s->of);
	const int32_t *contacts = s->of.contacts + at;
	for (int32_t k = 0; k < count; ++k) {
		if (prefetches) {
			prefetch_ahead(s, at + k, 1);
			out[k] = s->touching[(uint32_t)(at + k) % CNI_CULL_MEMBERS];
		} else {
			out[k] = cni_touch_pair_of(world, cni_contact_at(world, contacts[k]), contacts[k]);
		}
		out[k].place = at + k;
		cni_contact_mark_static(out[k].body[0], out[k].body[1]);
		contact_enters_no_more(out[k].contact);
	}
	s->at = at + count;
	return count;
}

/* ---- */

void cni_cull_open(cni_cull_list *list, cn_world *world, const int32_t *contacts, int32_t apart, int32_t count, float dt)
{
	list->world = world;
	list->contacts = contacts;
	list->apart = CNI_ON(CULLING) ? apart : 0;
	list->count = count;
	list->dt = dt;
	list->margin = world->settings.contact_margin;
	list->bodies = NULL;
	list->prefetches = count >= PREFETCH_FROM;
	bodies_make(list);
}

void cni_cull_close(cni_cull_list *list)
{
	cni_arena_pop(&list->world->arena, list->bodies);
}

void cni_cull_begin(cni_cull *s, const cni_cull_list *list, int32_t begin, int32_t end)
{
	s->of = *list;
	s->begin = s->at = s->batch = begin;
	s->end = end;
	s->left = 0;
	if (!cni_cull_prefetches(list))
		return;
	for (int32_t k = 0; k < RECORDS_AHEAD; ++k)
		ask_for_record(s, begin + k, k, 0);
	for (int32_t k = 0; k < MEMBERS_AHEAD; ++k)
		ask_for_members(s, begin + k, k, 0);
}

int32_t cni_cull_next(cni_cull *s, cni_touch_pair *out, int32_t most)
{
	int32_t count = 0;
	while (count < most && (s->left != 0 || s->at < s->end)) {
		if (s->left != 0)
			count += take_left(s, out + count, most - count);
		else if (CNI_ON(CULLING) && s->at < s->of.apart)
			batch_cull(s);
		else
			count += take_touching(s, out + count, most - count);
	}
	return count;
}

/* ---- a second look ---- */

/*
 * Pairs whose circles meet: does a direction separate the shapes throughout the step? Boxes side by side, the bones of a ragdoll, and a wheel
 * with the next pieces of ground are inside each other's circles and stay apart for many steps. A direction that is fixed in the world
 * separates two shapes for the step if it separates them now by more than the contact margin and what their motion takes: the speed at which
 * the centres approach along it, and the reach of each body's turning. So any direction is right. The good ones are that of the face that
 * separated the pair in its last manifold and, for a circle beside a segment, that of the nearest point.
 */

/* Least height of the shape's corners over its body's centre of mass along n. */
CNI_INLINE float lowest_along(const cni_body *b, const cni_geometry *g, cni_vec2 n)
{
	cni_vec2 m = cni_unrotate(b->q, n);
	return cni_points_lowest(cni_geometry_points(g), g->count, m) - cni_dot(m, b->local_center);
}

/* How far turning moves the surfaces in a second. */
CNI_INLINE float turn_of(const cni_body *a, const cni_body *b)
{
	return cni_abs(a->w) * cni_body_turn_reach(a) + cni_abs(b->w) * cni_body_turn_reach(b);
}

/* The face that separated the pair last: cache.axis is not 0. */
CNI_INLINE int32_t face_separates(const cn_world *world, const cni_touch_pair *p, float dt)
{
	int32_t axis = (int32_t)p->contact->cache.axis - 1, side = axis >= CN_POLYGON_MAX_VERTICES, edge = axis - CN_POLYGON_MAX_VERTICES * side;
	const cni_body *f = p->body[side], *o = p->body[1 - side];
	const cni_geometry *face = cni_proxy_geometry(&world->blocks, p->proxy[side]), *other = cni_proxy_geometry(&world->blocks, p->proxy[1 - side]);
	if (edge >= face->count)
		return 0;
	cni_vec2 normal = cni_geometry_normals(face)[edge];
	cni_vec2 n = cni_rotate(f->q, normal);
	float height = cni_dot(normal, cni_sub(cni_geometry_points(face)[edge], f->local_center));
	float closing = cni_max(cni_dot(n, cni_v(f->vx - o->vx, f->vy - o->vy)), 0.0f);
	return cni_dot(n, cni_body_a_to_b(f, o)) + lowest_along(o, other, n) - height - face->radius - other->radius >
	       world->settings.contact_margin + dt * (closing + turn_of(f, o));
}

/* A circle, and a capsule, an edge or a piece of a chain, but the piece that closes a loop. */
CNI_INLINE int32_t circle_is_far(const cn_world *world, const cni_touch_pair *p, float dt)
{
	const cni_body *a = p->body[0], *b = p->body[1];
	const cni_geometry *circle = cni_proxy_geometry(&world->blocks, p->proxy[0]), *other = cni_proxy_geometry(&world->blocks, p->proxy[1]);
	int32_t child = cni_proxy_child(p->proxy[1]);
	const cni_vec2 *points = cni_geometry_points(other) + child;
	float reach;
	if (circle->count != 1 || (cni_is_chain(other->type) ? child + 1 >= other->count : other->count != 2))
		return 0;
	cni_vec2 center = cni_rotate(a->q, cni_sub(cni_geometry_points(circle)[0], a->local_center));
	cni_vec2 edge = cni_rotate(b->q, cni_sub(points[1], points[0]));
	cni_vec2 start = cni_add(cni_body_a_to_b(a, b), cni_rotate(b->q, cni_sub(points[0], b->local_center)));
	cni_vec2 nearest = cni_segment_nearest(center, start, edge);
	reach = circle->radius + other->radius + world->settings.contact_margin + dt * (cni_length(cni_v(a->vx - b->vx, a->vy - b->vy)) + turn_of(a, b));
	return cni_distance_sq(center, nearest) > reach * reach;
}

int32_t cni_pair_stays_apart(const cn_world *world, const cni_touch_pair *p, float dt)
{
	if (!cni_aabb_overlap(&p->proxy[0]->fat, &p->proxy[1]->fat))
		return 0;
	if (p->contact->cache.axis != 0)
		return face_separates(world, p, dt);
	return CNI_CULL_LOOKS_AHEAD && circle_is_far(world, p, dt);
}
