/*
 * stages/sparse_kind.c - which components are alike, so that what is true of one's lists is true of the others'.
 *
 * Two trees are of one kind when their nodes, in the order of elimination, meet at bodies of the same places, and take
 * the same colours: then couplings, columns and blocks are the same from the component's begin on. Bodies are numbered
 * as the nodes come to them, so kinds are compared as they are written down.
 *
 * Most worlds have a few kinds of creatures and many of each. No more than CNI_KINDS are known at once: where more come,
 * one that was met a single time is forgotten.
 *
 * Reads nodes, bodies and inverse masses; writes components' kinds.
 */
#include "base/bitset.h"
#include "stages/sparse.h"

#include <string.h>

static int32_t can_move(const cni_motion *m)
{
	return m->inv_mass > 0.0f || m->inv_inertia > 0.0f;
}

/* A tree has at most one end that cannot move, unless there are two ways between two of them. */
static int32_t has_kind(const cni_sparse *s, const cni_component *c)
{
	int32_t k, nodes = c->end - c->begin;
	if (!c->tree || c->loops || c->width != 2 || nodes < 2 || nodes > CNI_KIND_NODES || c->coupling_end - c->coupling_begin > CNI_KIND_COUPLINGS * nodes)
		return 0;
	for (k = c->begin; k < c->end; ++k)
		if (s->nodes[k].rows != 2 || s->nodes[k].owner < 0)
			return 0;
	return 1;
}

static uint8_t place_of(const cni_sparse *s, const cni_component *c, const cni_motion *motions, int32_t body)
{
	int32_t k = c->body_begin;
	if (!can_move(motions + body))
		return (uint8_t)(c->body_end - c->body_begin);
	while (s->bodies[k] != body)
		++k;
	return (uint8_t)(k - c->body_begin);
}

/* The node whose owner comes next after `owner`. */
static int32_t next_of(const cni_sparse *s, const cni_component *c, int32_t owner)
{
	int32_t k, next = CNI_NONE;
	for (k = c->begin; k < c->end; ++k)
		if (s->nodes[k].owner > owner && (next == CNI_NONE || s->nodes[k].owner < s->nodes[next].owner))
			next = k;
	return next;
}

/* As lanes do: the lowest colour that is open, in the order of the awake list. */
static int32_t colors_take(const cni_sparse *s, const cni_component *c, cni_kind *kind)
{
	uint32_t used[CNI_KIND_NODES + 2] = { 0 };
	int32_t k, node = next_of(s, c, CNI_NONE);
	for (; node != CNI_NONE; node = next_of(s, c, s->nodes[node].owner)) {
		uint32_t open, bit;
		const uint8_t *end = kind->end[node - c->begin];
		used[kind->bodies] = 0; /* what cannot move is in the way of nobody */
		open = ~(used[end[0]] | used[end[1]]) & ((1u << CNI_JOINT_COLORS) - 1u);
		if (open == 0)
			return 0;
		k = cni_bit_lowest32(open);
		bit = 1u << k;
		used[end[0]] |= bit;
		used[end[1]] |= bit;
		kind->color[node - c->begin] = (uint8_t)k;
	}
	return 1;
}

int32_t cni_kind_describe(const cni_sparse *s, const cni_component *c, const cni_motion *motions, cni_kind *out)
{
	int32_t k;
	memset(out, 0, sizeof *out);
	if (!has_kind(s, c))
		return 0;
	out->nodes = c->end - c->begin;
	out->bodies = c->body_end - c->body_begin;
	for (k = 0; k < out->nodes; ++k) {
		out->end[k][0] = place_of(s, c, motions, s->nodes[c->begin + k].ia);
		out->end[k][1] = place_of(s, c, motions, s->nodes[c->begin + k].ib);
	}
	return colors_take(s, c, out);
}

typedef struct known {
	cni_kind kind[CNI_KINDS];
	int32_t first[CNI_KINDS];    /* component */
	int32_t members[CNI_KINDS];
	int32_t count, next;
} known;

/* A place for one more, at the cost of one with a single member if need be; CNI_NONE: there is none. */
static int32_t place_take(known *n, cni_component *components)
{
	int32_t tries;
	if (n->count < CNI_KINDS)
		return n->count++;
	for (tries = 0; tries < CNI_KINDS; ++tries) {
		int32_t k = n->next++ % CNI_KINDS;
		if (n->members[k] > 1)
			continue;
		components[n->first[k]].kind = CNI_NONE;
		return k;
	}
	return CNI_NONE;
}

static int32_t kind_of(known *n, const cni_kind *kind, cni_component *components, int32_t component)
{
	int32_t k;
	for (k = 0; k < n->count; ++k)
		if (memcmp(&n->kind[k], kind, sizeof *kind) == 0) {
			++n->members[k];
			return k;
		}
	k = place_take(n, components);
	if (k == CNI_NONE)
		return CNI_NONE;
	n->kind[k] = *kind;
	n->first[k] = component;
	n->members[k] = 1;
	return k;
}

void cni_kinds_find(cni_sparse *s, const cni_motion *motions)
{
	known n;
	int32_t k;
	n.count = n.next = 0;
	for (k = 0; k < s->component_count; ++k) {
		cni_kind kind;
		s->components[k].kind = CNI_NONE;
		if (cni_kind_describe(s, &s->components[k], motions, &kind))
			s->components[k].kind = kind_of(&n, &kind, s->components, k);
	}
}
