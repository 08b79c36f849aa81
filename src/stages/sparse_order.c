/*
 * stages/sparse_order.c - the order of elimination of a component with loops: least degree first.
 *
 * Neighbours are collected by body, then the node of least degree is eliminated again and again; its neighbours
 * become neighbours of one another (George and Liu, "Computer Solution of Large Sparse Positive Definite Systems",
 * 1981). The lists of eliminated nodes are the columns of L. A component whose work passes the limit is given up as
 * soon as that shows. Ties go to the node that reached its degree last, so the order depends on the nodes and their
 * order alone.
 *
 * Lists grow in pieces of scratch memory, each as large as all before it, and stay where they are until the plan is
 * written.
 */
#include "stages/sparse_planner.h"

#include <string.h>

#define POOL_PIECE 4096 /* the first piece, in entries */

/* ---- lists ---- */

static int32_t list_has(const cni_planner *p, int32_t node, int32_t other)
{
	const int32_t *list = p->list[node];
	int32_t k;
	for (k = 0; k < p->list_count[node]; ++k)
		if (list[k] == other)
			return 1;
	return 0;
}

/* Another piece that holds `count` entries at least. 0: all that may be taken is, or there is no memory. */
static int32_t pool_grow(cni_planner *p, int32_t count)
{
	int64_t piece = p->pool_taken > POOL_PIECE ? p->pool_taken : POOL_PIECE;
	if (piece > p->pool_most - p->pool_taken)
		piece = p->pool_most - p->pool_taken;
	if (piece < count)
		return 0;
	p->pool = (int32_t *)(p->system->dear_is_rare ? cni_arena_push_once(p->arena, 4u * (uint64_t)piece) : cni_arena_push(p->arena, 4u * (uint64_t)piece));
	if (p->pool == NULL) {
		p->no_memory = 1;
		p->pool_left = 0;
		return 0;
	}
	p->pool_left = (int32_t)piece;
	p->pool_taken += piece;
	return 1;
}

/* Room for `count` neighbours of a node. */
static int32_t list_reserve(cni_planner *p, int32_t node, int32_t count)
{
	int32_t capacity = count + count / 2 + 2;
	if (count <= p->list_capacity[node])
		return 1;
	if (capacity > p->pool_left && !pool_grow(p, capacity))
		return 0;
	if (p->list_count[node] > 0)
		memcpy(p->pool, p->list[node], sizeof(int32_t) * (size_t)p->list_count[node]);
	p->list[node] = p->pool;
	p->list_capacity[node] = capacity;
	p->pool += capacity;
	p->pool_left -= capacity;
	return 1;
}

static void list_add(cni_planner *p, int32_t node, int32_t other)
{
	p->list[node][p->list_count[node]++] = other;
}

/* ---- neighbours ---- */

/* Of the component's nodes. 0: too many. */
static int32_t neighbours_collect(cni_planner *p)
{
	int32_t k, side, key;
	for (k = 0; k < p->member_count; ++k) {
		int32_t i = p->member[k];
		p->list[i] = NULL;
		p->list_count[i] = p->list_capacity[i] = 0;
		p->mark[i] = CNI_NONE;
	}
	for (k = 0; k < p->member_count; ++k) {
		int32_t i = p->member[k];
		for (side = 0; side < 2; ++side) {
			int32_t body = cni_planner_body(p, i, side);
			for (key = body == 0 ? CNI_NONE : p->body_head[body]; key != CNI_NONE; key = cni_planner_next(p, key)) {
				int32_t other = key >> 1;
				if (other == i || list_has(p, i, other))
					continue;
				if (!list_reserve(p, i, p->list_count[i] + 1))
					return 0;
				list_add(p, i, other);
			}
		}
	}
	return 1;
}

/* ---- order ---- */

static void degree_link(cni_planner *p, int32_t node)
{
	int32_t d = p->list_count[node], head = p->degree_head[d];
	p->degree_next[node] = head;
	p->degree_prev[node] = CNI_NONE;
	if (head != CNI_NONE)
		p->degree_prev[head] = node;
	p->degree_head[d] = node;
}

static void degree_unlink(cni_planner *p, int32_t node)
{
	int32_t next = p->degree_next[node], prev = p->degree_prev[node];
	if (prev != CNI_NONE)
		p->degree_next[prev] = next;
	else
		p->degree_head[p->list_count[node]] = next;
	if (next != CNI_NONE)
		p->degree_prev[next] = prev;
}

/* u forgets v, which is eliminated, and meets v's other neighbours. turn: another number for every call, so that
   mark[] need not be cleared. 0: the pool is full. */
static int32_t neighbour_inherit(cni_planner *p, int32_t u, int32_t v, int32_t turn)
{
	int32_t k, count = p->list_count[v], *list = p->list[u];
	for (k = 0; k < p->list_count[u]; ++k) {
		if (list[k] == v)
			list[k--] = list[--p->list_count[u]];
		else
			p->mark[list[k]] = turn;
	}
	p->mark[u] = turn;
	for (k = 0; k < count; ++k) {
		int32_t w = p->list[v][k];
		if (p->mark[w] == turn)
			continue;
		if (!list_reserve(p, u, p->list_count[u] + 1))
			return 0;
		list_add(p, u, w);
	}
	return 1;
}

static int32_t node_eliminate(cni_planner *p, int32_t v)
{
	int32_t k, count = p->list_count[v];
	for (k = 0; k < count; ++k) {
		int32_t u = p->list[v][k];
		degree_unlink(p, u);
		if (!neighbour_inherit(p, u, v, p->turn++))
			return 0;
		degree_link(p, u);
	}
	p->work += 1 + count + count * (count + 1) / 2;
	return 1;
}

int32_t cni_planner_order(cni_planner *p, int64_t most)
{
	int32_t k, degree = 0, base = p->out->node_count;
	p->work = p->turn = 0;
	if (!neighbours_collect(p))
		return 0;
	memset(p->degree_head, 0xff, sizeof(int32_t) * (size_t)p->member_count);
	for (k = p->member_count - 1; k >= 0; --k)
		degree_link(p, p->member[k]);
	for (k = 0; k < p->member_count; ++k) {
		int32_t v;
		while (p->degree_head[degree] == CNI_NONE)
			++degree;
		v = p->degree_head[degree];
		degree_unlink(p, v);
		p->order[base + k] = v;
		p->position[v] = base + k;
		if (!node_eliminate(p, v) || p->work > most)
			return 0;
		degree = degree > 0 ? degree - 1 : 0;
	}
	return 1;
}
