/*
 * linear/sparse_order.c - the order of elimination of a component with loops: least degree first.
 *
 * Nodes that share a body are neighbours of one another: a body is a clique of its nodes, and a node lies in two cliques
 * at most. To eliminate a node makes neighbours of all its neighbours (George and Liu, "Computer Solution of Large Sparse
 * Positive Definite Systems", 1981): its two cliques become one, without it. So there are never more cliques than there were
 * bodies, a node's degree follows from the sizes of two of them and from how many nodes lie in both, and the list of the
 * clique that an eliminated node leaves is its column of L. All of it takes no longer than writing these columns down.
 *
 * A component whose work passes the limit is given up as soon as that shows. Ties go to the node that reached its degree
 * last, so the order depends on the nodes and their order alone.
 *
 * Lists are cut from pieces of scratch memory, each as large as all before it, and stay where they are until the plan is
 * written.
 */
#include "linear/sparse_planner.h"

#include <string.h>

#define POOL_PIECE 4096 /* the first piece, in entries */

/* ---- lists ---- */

/* Another piece that holds `count` entries at least. 0: all that may be taken is, or there is no memory. */
static int32_t pool_grow(cni_planner *p, int32_t count)
{
	int64_t piece = p->pool_taken > POOL_PIECE ? p->pool_taken : POOL_PIECE;
	if (piece > p->pool_most - p->pool_taken)
		piece = p->pool_most - p->pool_taken;
	if (piece < count)
		return 0;
	p->pool = (int32_t *)cni_arena_push(p->arena, 4u * (uint64_t)piece);
	if (p->pool == NULL) {
		p->no_memory = 1;
		p->pool_left = 0;
		return 0;
	}
	p->pool_left = (int32_t)piece;
	p->pool_taken += piece;
	return 1;
}

/* An empty list for `count` nodes. NULL: no room. */
static int32_t *list_cut(cni_planner *p, int32_t count)
{
	int32_t *list;
	if (count > p->pool_left && !pool_grow(p, count))
		return NULL;
	list = p->pool;
	p->pool += count;
	p->pool_left -= count;
	return list;
}

/* ---- cliques ---- */

/* Body 0 cannot move: its clique is empty. */
static cni_clique *clique_at(const cni_planner *p, int32_t body) { return &p->clique[body]; }

/* Of a body's nodes. 0: no room. */
static int32_t clique_collect(cni_planner *p, int32_t body)
{
	cni_clique *c = clique_at(p, body);
	int32_t key, count = 0;
	for (key = p->body_head[body]; key != CNI_NONE; key = cni_planner_next(p, key))
		++count;
	c->nodes = list_cut(p, count);
	c->count = c->met = 0;
	if (c->nodes == NULL)
		return 0;
	for (key = p->body_head[body]; key != CNI_NONE; key = cni_planner_next(p, key))
		c->nodes[c->count++] = key >> 1;
	return 1;
}

/* Of all bodies of the component. 0: no room. */
static int32_t cliques_collect(cni_planner *p)
{
	int32_t k, side;
	memset(clique_at(p, 0), 0, sizeof(cni_clique));
	for (k = 0; k < p->member_count; ++k) {
		int32_t node = p->member[k];
		p->mark[node] = CNI_NONE;
		for (side = 0; side < 2; ++side) {
			p->in[side][node] = cni_planner_body(p, node, side);
			clique_at(p, p->in[side][node])->nodes = NULL;
		}
	}
	for (k = 0; k < p->member_count; ++k)
		for (side = 0; side < 2; ++side) {
			int32_t body = p->in[side][p->member[k]];
			if (body != 0 && clique_at(p, body)->nodes == NULL && !clique_collect(p, body))
				return 0;
		}
	return 1;
}

/* The clique that a node of `body` lies in beside it; 0: none. */
static int32_t clique_beside(const cni_planner *p, int32_t node, int32_t body)
{
	return p->in[0][node] == body ? p->in[1][node] : p->in[0][node];
}

/* The nodes of a clique but v, and but those that v has marked, at the end of its column. */
static void column_add(cni_planner *p, int32_t v, const cni_clique *c)
{
	int32_t k;
	for (k = 0; k < c->count; ++k) {
		int32_t node = c->nodes[k];
		if (node == v || p->mark[node] == v)
			continue;
		p->mark[node] = v;
		p->list[v][p->list_count[v]++] = node;
	}
}

/* Nodes of a clique that has become part of another; those that were in both are in that alone. */
static void nodes_rename(cni_planner *p, int32_t part, int32_t body)
{
	const cni_clique *c = clique_at(p, part);
	int32_t k;
	for (k = 0; k < c->count; ++k) {
		int32_t node = c->nodes[k], side = p->in[1][node] == part;
		p->in[side][node] = p->in[1 - side][node] == body ? 0 : body;
	}
}

/* ---- degrees ---- */

static void degree_link(cni_planner *p, int32_t node, int32_t degree)
{
	int32_t head = p->degree_head[degree];
	p->degree[node] = degree;
	p->degree_next[node] = head;
	p->degree_prev[node] = CNI_NONE;
	if (head != CNI_NONE)
		p->degree_prev[head] = node;
	p->degree_head[degree] = node;
}

static void degree_unlink(cni_planner *p, int32_t node)
{
	int32_t next = p->degree_next[node], prev = p->degree_prev[node];
	if (prev != CNI_NONE)
		p->degree_next[prev] = next;
	else
		p->degree_head[p->degree[node]] = next;
	if (next != CNI_NONE)
		p->degree_prev[next] = prev;
}

/* Neighbours of a node in a clique: those in it and those in the one beside it, less those that are in both. */
static int32_t degree_beside(const cni_planner *p, const cni_clique *c, int32_t beside)
{
	return c->count - 1 + (beside == 0 ? 0 : clique_at(p, beside)->count - clique_at(p, beside)->met);
}

/* How many of its nodes are in each of the cliques beside it as well: add 1; it is forgotten: -1. */
static void beside_count(cni_planner *p, int32_t body, int32_t add)
{
	const cni_clique *c = clique_at(p, body);
	int32_t k;
	for (k = 0; k < c->count; ++k)
		clique_at(p, clique_beside(p, c->nodes[k], body))->met += add;
}

static void degrees_renew(cni_planner *p, int32_t body)
{
	const cni_clique *c = clique_at(p, body);
	int32_t k;
	beside_count(p, body, 1);
	for (k = 0; k < c->count; ++k) {
		int32_t node = c->nodes[k], degree = degree_beside(p, c, clique_beside(p, node, body));
		degree_unlink(p, node);
		degree_link(p, node, degree);
	}
	beside_count(p, body, -1);
}

/* For the first time. */
static void degrees_begin(cni_planner *p)
{
	int32_t k, side;
	for (k = 0; k < p->member_count; ++k)
		p->degree[p->member[k]] = 0;
	for (k = 0; k < p->member_count; ++k)
		for (side = 0; side < 2; ++side) {
			int32_t node = p->member[k], body = p->in[side][node];
			if (body == 0 || p->degree[node] != 0)
				continue;
			beside_count(p, body, 1);
			p->degree[node] = degree_beside(p, clique_at(p, body), p->in[1 - side][node]);
			beside_count(p, body, -1);
		}
}

/* ---- order ---- */

/* Takes v out: what is left of its two cliques is one, and v's column. 0: no room. */
static int32_t node_eliminate(cni_planner *p, int32_t v)
{
	int32_t into = p->in[0][v] != 0 ? 0 : 1, body = p->in[into][v], part = p->in[1 - into][v], count = p->degree[v];
	cni_clique *c = clique_at(p, body);
	p->list[v] = list_cut(p, count);
	p->list_count[v] = 0;
	if (p->list[v] == NULL)
		return 0;
	column_add(p, v, c);
	column_add(p, v, clique_at(p, part));
	CNI_ASSERT(p->list_count[v] == count);
	nodes_rename(p, part, body);
	c->nodes = p->list[v];
	c->count = count;
	degrees_renew(p, body);
	p->work += 1 + count + (int64_t)count * (count + 1) / 2;
	return 1;
}

int32_t cni_planner_order(cni_planner *p, int64_t most)
{
	int32_t k, degree = 0, at = p->out->node_count;
	p->work = 0;
	if (!cliques_collect(p))
		return 0;
	degrees_begin(p);
	memset(p->degree_head, 0xff, sizeof(int32_t) * (size_t)p->member_count);
	for (k = p->member_count - 1; k >= 0; --k)
		degree_link(p, p->member[k], p->degree[p->member[k]]); /* the first node is the first of its degree */
	for (k = 0; k < p->member_count; ++k) {
		int32_t v;
		while (p->degree_head[degree] == CNI_NONE)
			++degree;
		v = p->degree_head[degree];
		degree_unlink(p, v);
		p->order[at + k] = v;
		p->position[v] = at + k;
		if (!node_eliminate(p, v) || p->work > most)
			return 0;
		degree = degree > 0 ? degree - 1 : 0;
	}
	return 1;
}
