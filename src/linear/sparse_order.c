/*
 * linear/sparse_order.c - orders the elimination of a component with loops by minimum degree.
 *
 * Nodes that share a body are neighbours of each other: a body is a clique of its nodes, and a node lies in at most two
 * cliques. Eliminating a node makes all its neighbours neighbours of each other (George and Liu, "Computer Solution of
 * Large Sparse Positive Definite Systems", 1981): its two cliques merge into one, without it. So the number of cliques
 * never exceeds the number of bodies, a node's degree follows from the sizes of its two cliques and the number of nodes in
 * both, and the clique that remains after an elimination is the eliminated node's column of L. The total time is
 * proportional to the size of these columns.
 *
 * The ordering of a component stops as soon as its work exceeds the limit. Ties go to the node that reached its degree
 * last, so the order depends only on the nodes and their order.
 *
 * Lists are allocated from pieces of scratch memory, each as large as all before it, and do not move until the plan is
 * written.
 */
#include "linear/sparse_planner.h"

#include <string.h>

#define POOL_PIECE 4096 /* the first piece, in entries */

/* ---- lists ---- */

/* Takes another piece of at least `count` entries. 0: the limit pool_most is reached, or there is no memory. */
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
static int32_t *list_alloc(cni_planner *p, int32_t count)
{
	if (count > p->pool_left && !pool_grow(p, count))
		return NULL;
	int32_t *list = p->pool;
	p->pool += count;
	p->pool_left -= count;
	return list;
}

/* ---- cliques ---- */

/* Makes the clique of a body's nodes. 0: no room. */
static int32_t clique_collect(cni_planner *p, int32_t body)
{
	cni_clique *c = &p->clique[body];
	c->nodes = list_alloc(p, cni_planner_nodes_at(p, body));
	c->count = c->met = 0;
	if (c->nodes == NULL)
		return 0;
	for (int32_t key = p->body_head[body]; key != CNI_NONE; key = cni_planner_next(p, key))
		c->nodes[c->count++] = key >> 1;
	return 1;
}

/* Makes the cliques of all bodies of the component. 0: no room. */
static int32_t cliques_collect(cni_planner *p)
{
	memset(&p->clique[0], 0, sizeof(cni_clique));
	for (int32_t k = 0; k < p->member_count; ++k) {
		int32_t node = p->member[k];
		p->mark[node] = CNI_NONE;
		for (int32_t side = 0; side < 2; ++side) {
			p->in[side][node] = cni_planner_body(p, node, side);
			p->clique[p->in[side][node]].nodes = NULL;
		}
	}
	for (int32_t k = 0; k < p->member_count; ++k)
		for (int32_t side = 0; side < 2; ++side) {
			int32_t body = p->in[side][p->member[k]];
			if (body != 0 && p->clique[body].nodes == NULL && !clique_collect(p, body))
				return 0;
		}
	return 1;
}

/* The other clique of a node in the clique of `body`; 0: none. */
static int32_t clique_other(const cni_planner *p, int32_t node, int32_t body)
{
	return p->in[0][node] == body ? p->in[1][node] : p->in[0][node];
}

/* Appends the nodes of a clique to v's column, except v and nodes that are already there. */
static void column_add(cni_planner *p, int32_t v, const cni_clique *c)
{
	for (int32_t k = 0; k < c->count; ++k) {
		int32_t node = c->nodes[k];
		if (node == v || p->mark[node] == v)
			continue;
		p->mark[node] = v;
		p->list[v][p->list_count[v]++] = node;
	}
}

/* Moves the nodes of clique `part` to clique `body`; a node that was in both is then in `body` alone. */
static void nodes_move(cni_planner *p, int32_t part, int32_t body)
{
	const cni_clique *c = &p->clique[part];
	for (int32_t k = 0; k < c->count; ++k) {
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

/* Degree of a node of clique c: the other nodes of c plus the nodes of its other clique, minus the nodes in both. */
static int32_t degree_in(const cni_planner *p, const cni_clique *c, int32_t other)
{
	return c->count - 1 + (other == 0 ? 0 : p->clique[other].count - p->clique[other].met);
}

/* Adds to `met` of every other clique, `add` for each node that it shares with the clique of `body`. add -1 undoes 1. */
static void shared_count(cni_planner *p, int32_t body, int32_t add)
{
	const cni_clique *c = &p->clique[body];
	for (int32_t k = 0; k < c->count; ++k)
		p->clique[clique_other(p, c->nodes[k], body)].met += add;
}

static void degrees_update(cni_planner *p, int32_t body)
{
	const cni_clique *c = &p->clique[body];
	shared_count(p, body, 1);
	for (int32_t k = 0; k < c->count; ++k) {
		int32_t node = c->nodes[k], degree = degree_in(p, c, clique_other(p, node, body));
		degree_unlink(p, node);
		degree_link(p, node, degree);
	}
	shared_count(p, body, -1);
}

/* Initial degrees. */
static void degrees_begin(cni_planner *p)
{
	for (int32_t k = 0; k < p->member_count; ++k)
		p->degree[p->member[k]] = 0;
	for (int32_t k = 0; k < p->member_count; ++k)
		for (int32_t side = 0; side < 2; ++side) {
			int32_t node = p->member[k], body = p->in[side][node];
			if (body == 0 || p->degree[node] != 0)
				continue;
			shared_count(p, body, 1);
			p->degree[node] = degree_in(p, &p->clique[body], p->in[1 - side][node]);
			shared_count(p, body, -1);
		}
}

/* ---- order ---- */

/* Eliminates v: its two cliques without v merge into one, which is v's column. 0: no room. */
static int32_t node_eliminate(cni_planner *p, int32_t v)
{
	int32_t into = p->in[0][v] != 0 ? 0 : 1, body = p->in[into][v], part = p->in[1 - into][v], count = p->degree[v];
	cni_clique *c = &p->clique[body];
	p->list[v] = list_alloc(p, count);
	p->list_count[v] = 0;
	if (p->list[v] == NULL)
		return 0;
	column_add(p, v, c);
	column_add(p, v, &p->clique[part]);
	CNI_ASSERT(p->list_count[v] == count);
	nodes_move(p, part, body);
	c->nodes = p->list[v];
	c->count = count;
	degrees_update(p, body);
	p->work += 1 + count + (int64_t)count * (count + 1) / 2;
	return 1;
}

int32_t cni_planner_order(cni_planner *p, int64_t most)
{
	int32_t degree = 0, at = p->out->node_count;
	p->work = 0;
	if (!cliques_collect(p))
		return 0;
	degrees_begin(p);
	memset(p->degree_head, 0xff, sizeof(int32_t) * (size_t)p->member_count);
	for (int32_t k = p->member_count - 1; k >= 0; --k)
		degree_link(p, p->member[k], p->degree[p->member[k]]); /* backwards, so that lists begin with the first node */
	for (int32_t k = 0; k < p->member_count; ++k) {
		while (p->degree_head[degree] == CNI_NONE)
			++degree;
		int32_t v = p->degree_head[degree];
		degree_unlink(p, v);
		p->order[at + k] = v;
		p->position[v] = at + k;
		if (!node_eliminate(p, v) || p->work > most)
			return 0;
		degree = degree > 0 ? degree - 1 : 0;
	}
	return 1;
}
