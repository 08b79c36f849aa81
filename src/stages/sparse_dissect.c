/*
 * stages/sparse_dissect.c - which nodes of a large net are to be eliminated last: nested dissection.
 *
 * The bodies are parted in two halves with few nodes between them; these come last, and each half is parted again
 * (George, "Nested Dissection of a Regular Finite Element Mesh", 1973). A square net of n bodies has n log n blocks then
 * and n^1.5 of work, a third to a quarter of what least degree makes of it.
 *
 * Halves come from distances, counted in nodes, to three bodies far from one another. The difference of two such distances is a
 * coordinate: in a square net, whose far bodies are three of its corners, it runs along a side or a diagonal. Of the three
 * differences that one is taken whose middle parts the fewest. Nothing but who is joined to whom counts, so that a plan
 * never depends on where bodies are.
 *
 * Reads the planner's component; writes its groups. They are numbered from the outside in: the last is the first to be
 * eliminated.
 */
#include "stages/sparse_planner.h"

#define PIECE_BODIES 32   /* is not parted any more */
#define HALF_LEAST 4      /* a half has no less than this part of its piece */
#define WAITING_MOST 32   /* pieces: each is at least as large as all that came after it */

typedef struct piece {
	int32_t begin, end;   /* in list */
	int32_t label;
} piece;

typedef struct dissection {
	cni_planner *p;
	int32_t *list;        /* bodies, piece by piece */
	int32_t *queue;       /* bodies by distance, or scratch for a piece */
	int32_t *count;       /* by difference of distances: bodies that have it */
	int32_t *label;       /* by body: of its piece */
	int32_t *upper;       /* by body: 1: it is in the upper half */
	int32_t *far[3];      /* by body: distance in its piece, CNI_NONE: not connected */
	int32_t label_count;
	piece waiting[WAITING_MOST];
	int32_t waiting_count;
} dissection;

/* The difference of two distances; what it is less than in the lower half. */
typedef struct coordinate {
	int32_t a, b, limit;
	int32_t parted;       /* nodes between the halves */
} coordinate;

/* ---- distances ---- */

static int32_t other_body(const cni_planner *p, int32_t key)
{
	return cni_planner_body(p, key >> 1, 1 - (key & 1));
}

/* From `start` to all of its piece that it is connected with: in the queue, by distance. Returns how many those are. */
static int32_t distances_find(const dissection *d, const piece *at, int32_t start, int32_t *far)
{
	int32_t k, key, taken, count = 1;
	for (k = at->begin; k < at->end; ++k)
		far[d->list[k]] = CNI_NONE;
	far[start] = 0;
	d->queue[0] = start;
	for (taken = 0; taken < count; ++taken) {
		int32_t body = d->queue[taken];
		for (key = d->p->body_head[body]; key != CNI_NONE; key = cni_planner_next(d->p, key)) {
			int32_t other = other_body(d->p, key);
			if (other == 0 || d->label[other] != at->label || far[other] != CNI_NONE)
				continue;
			far[other] = far[body] + 1;
			d->queue[count++] = other;
		}
	}
	return count;
}

/* Of the bodies in the queue, the first of those that are farthest from the first two, and, again 1, from the third as well:
   bodies between corners are as far from both of the others as the corner is. */
static int32_t third_find(const dissection *d, int32_t count, int32_t again)
{
	int32_t k, found = d->queue[0], most = -1;
	for (k = 0; k < count; ++k) {
		int32_t body = d->queue[k], far = cni_min_i(d->far[0][body], d->far[1][body]) + (again ? d->far[2][body] : 0);
		if (far > most) {
			most = far;
			found = body;
		}
	}
	return found;
}

/* 0: the piece is not connected. */
static int32_t far_find(const dissection *d, const piece *at)
{
	int32_t count = distances_find(d, at, d->list[at->begin], d->far[0]);
	if (count < at->end - at->begin)
		return 0;
	(void)distances_find(d, at, d->queue[count - 1], d->far[0]);
	(void)distances_find(d, at, d->queue[count - 1], d->far[1]);
	(void)distances_find(d, at, third_find(d, count, 0), d->far[2]);
	(void)distances_find(d, at, third_find(d, count, 1), d->far[2]);
	return 1;
}

/* ---- halves ---- */

static int32_t difference(const dissection *d, const coordinate *c, int32_t body)
{
	return d->far[c->a][body] - d->far[c->b][body];
}

static int32_t parted_count(const dissection *d, const piece *at, const coordinate *c)
{
	int32_t k, key, count = 0;
	for (k = at->begin; k < at->end; ++k) {
		int32_t body = d->list[k];
		if (difference(d, c, body) >= c->limit)
			continue;
		for (key = d->p->body_head[body]; key != CNI_NONE; key = cni_planner_next(d->p, key)) {
			int32_t other = other_body(d->p, key);
			count += other != 0 && d->label[other] == at->label && difference(d, c, other) >= c->limit;
		}
	}
	return count;
}

/* lower: how many bodies are in the lower half. */
static void coordinate_try(const dissection *d, const piece *at, int32_t lower, coordinate *c, coordinate *best)
{
	int32_t size = at->end - at->begin;
	if (cni_min_i(lower, size - lower) < size / HALF_LEAST)
		return;
	c->parted = parted_count(d, at, c);
	if (c->parted < best->parted)
		*best = *c;
}

/* Limits on both sides of the bodies in the middle. */
static void middle_try(const dissection *d, const piece *at, int32_t a, int32_t b, coordinate *best)
{
	int32_t size = at->end - at->begin, k, lower = 0, *count = d->count + size;
	coordinate c = { a, b, -size, 0 };
	for (k = -size; k <= size; ++k)
		count[k] = 0;
	for (k = at->begin; k < at->end; ++k)
		++count[difference(d, &c, d->list[k])];
	for (; 2 * (lower + count[c.limit]) < size; ++c.limit)
		lower += count[c.limit];
	coordinate_try(d, at, lower, &c, best);
	lower += count[c.limit++];
	coordinate_try(d, at, lower, &c, best);
}

/* 0: it cannot be parted well. */
static int32_t halves_find(const dissection *d, const piece *at)
{
	coordinate best = { 0, 0, 0, INT32_MAX };
	int32_t k, connected = far_find(d, at);
	if (connected) {
		middle_try(d, at, 0, 1, &best);
		middle_try(d, at, 0, 2, &best);
		middle_try(d, at, 1, 2, &best);
		if (best.parted == INT32_MAX)
			return 0;
	}
	for (k = at->begin; k < at->end; ++k) {
		int32_t body = d->list[k];
		d->upper[body] = connected ? difference(d, &best, body) >= best.limit : d->far[0][body] == CNI_NONE;
	}
	return 1;
}

/* The lower half comes first. Returns where it ends. */
static int32_t halves_sort(const dissection *d, const piece *at)
{
	int32_t k, middle = at->begin, rest = 0;
	for (k = at->begin; k < at->end; ++k) {
		int32_t body = d->list[k];
		if (d->upper[body])
			d->queue[rest++] = body;
		else
			d->list[middle++] = body;
	}
	for (k = 0; k < rest; ++k)
		d->list[middle + k] = d->queue[k];
	return middle;
}

/* ---- groups ---- */

/* Those of the piece's nodes that are in no group, and of which one body, or none, is in `label`. */
static void group_make(const dissection *d, const piece *at, int32_t label)
{
	cni_planner *p = d->p;
	int32_t k, key, group = p->group_count++;
	p->group_head[group] = CNI_NONE;
	for (k = at->begin; k < at->end; ++k)
		for (key = p->body_head[d->list[k]]; key != CNI_NONE; key = cni_planner_next(p, key)) {
			int32_t node = key >> 1, other = other_body(p, key);
			if (p->group[node] != CNI_NONE || (label != CNI_NONE && (other == 0 || d->label[other] != label)))
				continue;
			p->group[node] = group;
			p->group_next[node] = p->group_head[group];
			p->group_head[group] = node;
		}
}

static piece piece_make(dissection *d, int32_t begin, int32_t end)
{
	piece made = { begin, end, d->label_count++ };
	int32_t k;
	for (k = begin; k < end; ++k)
		d->label[d->list[k]] = made.label;
	return made;
}

/* Two pieces of one, and the nodes between. */
static void piece_part(dissection *d, const piece *at)
{
	int32_t middle = halves_sort(d, at);
	piece lower = piece_make(d, at->begin, middle), upper = piece_make(d, middle, at->end);
	int32_t larger = middle - at->begin > at->end - middle;
	group_make(d, &lower, upper.label);
	d->waiting[d->waiting_count++] = larger ? lower : upper;
	d->waiting[d->waiting_count++] = larger ? upper : lower;
}

static void pieces_part(dissection *d)
{
	while (d->waiting_count > 0) {
		piece at = d->waiting[--d->waiting_count];
		if (at.end - at.begin > PIECE_BODIES && halves_find(d, &at))
			piece_part(d, &at);
		else
			group_make(d, &at, CNI_NONE);
	}
}

/* ---- scratch ---- */

static int32_t *ints_cut(int32_t **at, int32_t count)
{
	int32_t *ints = *at;
	*at += count;
	return ints;
}

/* All bodies of the component, by their nodes. */
static void bodies_list(dissection *d)
{
	const cni_planner *p = d->p;
	int32_t k, side, count = 0;
	for (k = 0; k < p->member_count; ++k)
		for (side = 0; side < 2; ++side)
			d->label[cni_planner_body(p, p->member[k], side)] = CNI_NONE;
	for (k = 0; k < p->member_count; ++k)
		for (side = 0; side < 2; ++side) {
			int32_t body = cni_planner_body(p, p->member[k], side);
			if (body == 0 || d->label[body] == 0)
				continue;
			d->label[body] = 0;
			d->list[count++] = body;
		}
	CNI_ASSERT(count == p->body_count);
}

int32_t cni_planner_dissect(cni_planner *p)
{
	int32_t all = p->system->motion_count, k;
	uint64_t bytes = cni_dissect_bytes(p->body_count, all);
	int32_t *scratch = (int32_t *)(p->system->dear_is_rare ? cni_arena_push_once(p->arena, bytes) : cni_arena_push(p->arena, bytes)), *at = scratch;
	dissection d;
	if (scratch == NULL)
		return 0;
	d.p = p;
	d.list = ints_cut(&at, p->body_count);
	d.queue = ints_cut(&at, p->body_count);
	d.count = ints_cut(&at, 2 * p->body_count + 1);
	d.label = ints_cut(&at, all);
	d.upper = ints_cut(&at, all);
	for (k = 0; k < 3; ++k)
		d.far[k] = ints_cut(&at, all);
	bodies_list(&d);
	for (k = 0; k < p->member_count; ++k)
		p->group[p->member[k]] = CNI_NONE;
	p->group_count = d.label_count = d.waiting_count = 0;
	d.waiting[d.waiting_count++] = piece_make(&d, 0, p->body_count);
	pieces_part(&d);
	(void)cni_arena_pop(p->arena, scratch);
	return 1;
}
