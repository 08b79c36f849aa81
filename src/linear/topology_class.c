/*
 * linear/topology_class.c - finds components of equal topology, whose couplings, columns and blocks are therefore equal; and
 * orders small trees independently of the numbering of their nodes.
 *
 * Joints are added and removed, and their places in the awake list change: two ragdolls list their joints in different
 * orders. So a tree is rooted at the body with the most nodes, branches are ordered by a hash of their subtree (a sum over
 * children of mixed sums, after Zobrist, 1970), and nodes are eliminated from the leaves to the root. Branches of equal
 * hash may swap places. Chains keep their order from one end, which is the same for all chains.
 *
 * Two trees are of one class when their nodes, in the order of elimination, connect bodies of the same numbers and take the
 * same colours. Then their couplings, columns and blocks are equal relative to the component's begin. Bodies are numbered
 * in the order in which the nodes reach them, so topologies are compared bytewise.
 *
 * Most worlds have a few classes of creatures and many creatures of each. At most CNI_TOPOLOGY_CLASSES classes are stored at
 * once: a new class beyond that replaces one with a single member.
 *
 * Reads nodes, bodies and inverse masses; writes components' `kind`.
 */
#include "base/bitset.h"
#include "linear/sparse_planner.h"

#include <string.h>

/* ---- order ---- */

/* A rooted tree of bodies in breadth-first order, each with the node that connects it to its parent. */
typedef struct rooted_tree {
	int32_t count;
	int32_t body[CNI_TOPOLOGY_NODES + 1];     /* 0: cannot move */
	int32_t node[CNI_TOPOLOGY_NODES + 1];
	int32_t side[CNI_TOPOLOGY_NODES + 1];     /* side of the node at which the parent is */
	int32_t parent[CNI_TOPOLOGY_NODES + 1];
	int32_t first[CNI_TOPOLOGY_NODES + 2];    /* first child */
	uint32_t hash[CNI_TOPOLOGY_NODES + 1];     /* hash of the subtree */
} rooted_tree;

static uint32_t hash_mix(uint32_t x)
{
	x = (x ^ x >> 16) * 0x7feb352du;
	x = (x ^ x >> 15) * 0x846ca68bu;
	return x ^ x >> 16;
}

static void root_at(const cni_planner *p, int32_t root, rooted_tree *t)
{
	t->count = 1;
	t->body[0] = root;
	t->node[0] = t->parent[0] = CNI_NONE;
	t->side[0] = 0;
	for (int32_t k = 0; k < t->count; ++k) {
		t->first[k] = t->count;
		t->hash[k] = t->body[k] == 0 ? 1u : 2u;
		for (int32_t key = t->body[k] == 0 ? CNI_NONE : p->body_head[t->body[k]]; key != CNI_NONE; key = cni_planner_next(p, key)) {
			int32_t at = t->count;
			if (key >> 1 == t->node[k])
				continue;
			t->body[at] = cni_planner_body(p, key >> 1, 1 - (key & 1));
			t->node[at] = key >> 1;
			t->side[at] = key & 1;
			t->parent[at] = k;
			++t->count;
		}
	}
	t->first[t->count] = t->count;
	for (int32_t k = t->count - 1; k >= 0; --k) {
		t->hash[k] = hash_mix(t->hash[k] + (uint32_t)t->side[k]);
		if (k > 0)
			t->hash[t->parent[k]] += hash_mix(t->hash[k]);
	}
}

/* Roots the tree at the body with the most nodes; of several, at the one that gives the least hash. */
static void root_at_best(const cni_planner *p, rooted_tree *out)
{
	rooted_tree t;
	out->count = out->body[0] = 0;
	for (int32_t k = 0; k < p->member_count; ++k)
		for (int32_t side = 0; side < 2; ++side) {
			int32_t body = cni_planner_body(p, p->member[k], side);
			if (body == 0 || cni_planner_nodes_at(p, body) < p->hub || body == out->body[0])
				continue;
			root_at(p, body, &t);
			if (out->count == 0 || t.hash[0] < out->hash[0])
				*out = t;
		}
}

void cni_planner_order_tree(cni_planner *p)
{
	rooted_tree t;
	int32_t queue[CNI_TOPOLOGY_NODES + 1], count = 1, base = p->out->node_count;
	root_at_best(p, &t);
	queue[0] = 0;
	for (int32_t at = 0; at < count; ++at) {
		int32_t begin = count, v = queue[at];
		for (int32_t k = t.first[v]; k < t.first[v + 1]; ++k) {
			int32_t to = count++;
			for (; to > begin && t.hash[queue[to - 1]] > t.hash[k]; --to)
				queue[to] = queue[to - 1];
			queue[to] = k;
		}
	}
	for (int32_t k = 1; k < count; ++k) {
		p->order[base + p->member_count - k] = t.node[queue[k]];
		p->position[t.node[queue[k]]] = base + p->member_count - k;
	}
}

/* ---- classes ---- */

/* Two ends that cannot move would close a loop through the world, so c->loops excludes more than one. */
static int32_t may_have_class(const cni_sparse *s, const cni_component *c)
{
	int32_t nodes = c->end - c->begin;
	if (!c->tree || c->loops || c->width != 2 || nodes > CNI_TOPOLOGY_NODES || c->coupling_end - c->coupling_begin > CNI_TOPOLOGY_COUPLINGS * nodes)
		return 0;
	for (int32_t k = c->begin; k < c->end; ++k)
		if (s->nodes[k].rows != 2 || s->nodes[k].owner < 0)
			return 0;
	return 1;
}

static uint8_t place_of(const cni_sparse *s, const cni_component *c, const cni_motion *motions, int32_t body)
{
	int32_t k = c->body_begin;
	if (!cni_motion_can_move(motions + body))
		return (uint8_t)(c->body_end - c->body_begin);
	while (s->bodies[k] != body)
		++k;
	return (uint8_t)(k - c->body_begin);
}

/* Gives each node the lowest free colour, as joint lanes do. 0: none is free. */
static int32_t colors_take(cni_topology *kind)
{
	uint32_t used[CNI_TOPOLOGY_NODES + 2] = { 0 };
	int32_t color;
	for (int32_t k = 0; k < kind->nodes; ++k) {
		const uint8_t *end = kind->end[k];
		used[kind->bodies] = 0; /* bodies that cannot move exclude no colour */
		uint32_t open = ~(used[end[0]] | used[end[1]]) & ((1u << CNI_JOINT_COLORS) - 1u);
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
	memset(out, 0, sizeof *out);
	if (!may_have_class(s, c))
		return 0;
	out->nodes = c->end - c->begin;
	out->bodies = c->body_end - c->body_begin;
	for (int32_t k = 0; k < out->nodes; ++k) {
		out->end[k][0] = place_of(s, c, motions, s->nodes[c->begin + k].ia);
		out->end[k][1] = place_of(s, c, motions, s->nodes[c->begin + k].ib);
	}
	return colors_take(out);
}

typedef struct class_table {
	cni_topology kind[CNI_TOPOLOGY_CLASSES];
	int32_t first[CNI_TOPOLOGY_CLASSES];    /* component */
	int32_t members[CNI_TOPOLOGY_CLASSES];
	int32_t count, next;
} class_table;

/* An entry for a new class; if all are taken, it replaces a class with a single member. CNI_NONE: there is none. */
static int32_t entry_take(class_table *n, cni_component *components)
{
	if (n->count < CNI_TOPOLOGY_CLASSES)
		return n->count++;
	for (int32_t tries = 0; tries < CNI_TOPOLOGY_CLASSES; ++tries) {
		int32_t k = n->next++ % CNI_TOPOLOGY_CLASSES;
		if (n->members[k] > 1)
			continue;
		components[n->first[k]].kind = CNI_NONE;
		return k;
	}
	return CNI_NONE;
}

static int32_t class_of(class_table *n, const cni_topology *kind, cni_component *components, int32_t component)
{
	int32_t k;
	for (k = 0; k < n->count; ++k)
		if (memcmp(&n->kind[k], kind, sizeof *kind) == 0) {
			++n->members[k];
			return k;
		}
	k = entry_take(n, components);
	if (k == CNI_NONE)
		return CNI_NONE;
	n->kind[k] = *kind;
	n->first[k] = component;
	n->members[k] = 1;
	return k;
}

void cni_topology_classes_find(cni_sparse *s, const cni_motion *motions)
{
	class_table n;
	n.count = n.next = 0;
	for (int32_t k = 0; k < s->component_count; ++k) {
		cni_topology kind;
		s->components[k].kind = CNI_NONE;
		if (cni_topology_describe(s, &s->components[k], motions, &kind))
			s->components[k].kind = class_of(&n, &kind, s->components, k);
	}
}
