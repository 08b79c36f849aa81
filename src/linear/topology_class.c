/*
 * linear/topology_class.c - which components are alike, so that what is true of one's lists is true of the others'; and an
 * order of small trees that does not depend on what their nodes are called.
 *
 * Joints come and go, and the places of the awake list with them: two ragdolls have their joints there in different orders. So
 * a tree is hung up by the body with most nodes, branches are told apart by what hangs from them (a sum over
 * children of mixed sums, as of Zobrist, 1970), and nodes are taken from the tips to that body. Branches that are the same
 * may change places. Rows of pins keep the order they have: that from one end is as good for all.
 *
 * Two trees are of one kind when their nodes, in the order of elimination, meet at bodies of the same places, and take
 * the same colours: then couplings, columns and blocks are the same from the component's begin on. Bodies are numbered
 * as the nodes come to them, so kinds are compared as they are written down.
 *
 * Most worlds have a few kinds of creatures and many of each. No more than CNI_TOPOLOGY_CLASSES are known at once: where more come,
 * one that was met a single time is forgotten.
 *
 * Reads nodes, bodies and inverse masses; writes components' kinds.
 */
#include "base/bitset.h"
#include "linear/sparse_planner.h"

#include <string.h>

/* ---- order ---- */

/* A tree of bodies, hung up by one: each with the node by which it hangs, breadth first. */
typedef struct hanging {
	int32_t count;
	int32_t body[CNI_TOPOLOGY_NODES + 1];     /* 0: what cannot move */
	int32_t node[CNI_TOPOLOGY_NODES + 1];
	int32_t side[CNI_TOPOLOGY_NODES + 1];     /* of the node, which is above */
	int32_t above[CNI_TOPOLOGY_NODES + 1];
	int32_t first[CNI_TOPOLOGY_NODES + 2];    /* of those that hang from it */
	uint32_t sum[CNI_TOPOLOGY_NODES + 1];     /* over all that hangs from it */
} hanging;

static uint32_t mixed(uint32_t x)
{
	x = (x ^ x >> 16) * 0x7feb352du;
	x = (x ^ x >> 15) * 0x846ca68bu;
	return x ^ x >> 16;
}

static void hang(const cni_planner *p, int32_t root, hanging *t)
{
	int32_t k, key;
	t->count = 1;
	t->body[0] = root;
	t->node[0] = t->above[0] = CNI_NONE;
	t->side[0] = 0;
	for (k = 0; k < t->count; ++k) {
		t->first[k] = t->count;
		t->sum[k] = t->body[k] == 0 ? 1u : 2u;
		for (key = t->body[k] == 0 ? CNI_NONE : p->body_head[t->body[k]]; key != CNI_NONE; key = cni_planner_next(p, key)) {
			int32_t at = t->count;
			if (key >> 1 == t->node[k])
				continue;
			t->body[at] = cni_planner_body(p, key >> 1, 1 - (key & 1));
			t->node[at] = key >> 1;
			t->side[at] = key & 1;
			t->above[at] = k;
			++t->count;
		}
	}
	t->first[t->count] = t->count;
	for (k = t->count - 1; k >= 0; --k) {
		t->sum[k] = mixed(t->sum[k] + (uint32_t)t->side[k]);
		if (k > 0)
			t->sum[t->above[k]] += mixed(t->sum[k]);
	}
}

static int32_t nodes_at(const cni_planner *p, int32_t body)
{
	int32_t key, count = 0;
	for (key = p->body_head[body]; key != CNI_NONE; key = cni_planner_next(p, key))
		++count;
	return count;
}

/* By the body with most nodes; of several, by that of the least sum. */
static void attach_best(const cni_planner *p, hanging *out)
{
	hanging t;
	int32_t k, side;
	out->count = out->body[0] = 0;
	for (k = 0; k < p->member_count; ++k)
		for (side = 0; side < 2; ++side) {
			int32_t body = cni_planner_body(p, p->member[k], side);
			if (body == 0 || nodes_at(p, body) < p->hub || body == out->body[0])
				continue;
			hang(p, body, &t);
			if (out->count == 0 || t.sum[0] < out->sum[0])
				*out = t;
		}
}

void cni_planner_order_tree(cni_planner *p)
{
	hanging t;
	int32_t queue[CNI_TOPOLOGY_NODES + 1], count = 1, at, k, base = p->out->node_count;
	attach_best(p, &t);
	queue[0] = 0;
	for (at = 0; at < count; ++at) {
		int32_t begin = count, v = queue[at];
		for (k = t.first[v]; k < t.first[v + 1]; ++k) {
			int32_t to = count++;
			for (; to > begin && t.sum[queue[to - 1]] > t.sum[k]; --to)
				queue[to] = queue[to - 1];
			queue[to] = k;
		}
	}
	for (k = 1; k < count; ++k) {
		p->order[base + p->member_count - k] = t.node[queue[k]];
		p->position[t.node[queue[k]]] = base + p->member_count - k;
	}
}

/* ---- kinds ---- */

static int32_t can_move(const cni_motion *m)
{
	return m->inv_mass > 0.0f || m->inv_inertia > 0.0f;
}

/* A tree has at most one end that cannot move, unless there are two ways between two of them. */
static int32_t has_kind(const cni_sparse *s, const cni_component *c)
{
	int32_t k, nodes = c->end - c->begin;
	if (!c->tree || c->loops || c->width != 2 || nodes > CNI_TOPOLOGY_NODES || c->coupling_end - c->coupling_begin > CNI_TOPOLOGY_COUPLINGS * nodes)
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

/* As lanes do: the lowest colour that is open. */
static int32_t colors_take(cni_topology *kind)
{
	uint32_t used[CNI_TOPOLOGY_NODES + 2] = { 0 };
	int32_t k, color;
	for (k = 0; k < kind->nodes; ++k) {
		uint32_t open;
		const uint8_t *end = kind->end[k];
		used[kind->bodies] = 0; /* what cannot move is in the way of nobody */
		open = ~(used[end[0]] | used[end[1]]) & ((1u << CNI_JOINT_COLORS) - 1u);
		if (open == 0)
			return 0;
		color = cni_bit_lowest32(open);
		used[end[0]] |= 1u << color;
		used[end[1]] |= 1u << color;
		kind->color[k] = (uint8_t)color;
	}
	return 1;
}

int32_t cni_topology_describe(const cni_sparse *s, const cni_component *c, const cni_motion *motions, cni_topology *out)
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
	return colors_take(out);
}

typedef struct known {
	cni_topology kind[CNI_TOPOLOGY_CLASSES];
	int32_t first[CNI_TOPOLOGY_CLASSES];    /* component */
	int32_t members[CNI_TOPOLOGY_CLASSES];
	int32_t count, next;
} known;

/* A place for one more, at the cost of one with a single member if need be; CNI_NONE: there is none. */
static int32_t place_take(known *n, cni_component *components)
{
	int32_t tries;
	if (n->count < CNI_TOPOLOGY_CLASSES)
		return n->count++;
	for (tries = 0; tries < CNI_TOPOLOGY_CLASSES; ++tries) {
		int32_t k = n->next++ % CNI_TOPOLOGY_CLASSES;
		if (n->members[k] > 1)
			continue;
		components[n->first[k]].kind = CNI_NONE;
		return k;
	}
	return CNI_NONE;
}

static int32_t kind_of(known *n, const cni_topology *kind, cni_component *components, int32_t component)
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

void cni_topology_classes_find(cni_sparse *s, const cni_motion *motions)
{
	known n;
	int32_t k;
	n.count = n.next = 0;
	for (k = 0; k < s->component_count; ++k) {
		cni_topology kind;
		s->components[k].kind = CNI_NONE;
		if (cni_topology_describe(s, &s->components[k], motions, &kind))
			s->components[k].kind = kind_of(&n, &kind, s->components, k);
	}
}
