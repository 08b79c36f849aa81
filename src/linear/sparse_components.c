/*
 * linear/sparse_components.c - which nodes of a sparse system belong together, and whether they may be planned.
 *
 * One component at a time, breadth first from its first node. A tree needs no search: its nodes are eliminated in the
 * opposite order, in which what is left at a node's body is a clique already, so that nothing fills in (a chain as well
 * from its first node on; a small one with branches as in linear/topology_class.c). Others are ordered by
 * linear/sparse_order.c. What is more work than its links or the budget allow is left out.
 *
 * Reads the system; writes the planner's lists and order, the planned components and sizes.
 */
#include "linear/sparse_planner.h"

#include <string.h>

/* ---- collecting ---- */

/* Lists of the nodes at each body. */
static void bodies_collect(cni_planner *p)
{
	int32_t i, side;
	memset(p->body_head, 0xff, sizeof(int32_t) * (size_t)p->system->motion_count);
	memset(p->body_reached, 0, (size_t)p->system->motion_count);
	memset(p->seen, 0, (size_t)p->system->link_count);
	for (i = p->system->link_count - 1; i >= 0; --i)
		for (side = 1; side >= 0; --side) {
			int32_t body = cni_planner_body(p, i, side);
			if (body == 0)
				continue;
			p->node_next[side][i] = p->body_head[body];
			p->body_head[body] = i << 1 | side;
		}
}

/* All nodes at a body that was not reached before. In a tree the k-th of them has k neighbours that are eliminated after
   it: 1 + k + k (k + 1) / 2 blocks of work. */
static void body_reach(cni_planner *p, int32_t body)
{
	int32_t key, count = 0;
	for (key = p->body_head[body]; key != CNI_NONE; key = cni_planner_next(p, key), ++count)
		if (!p->seen[key >> 1]) {
			p->seen[key >> 1] = 1;
			p->member[p->member_count++] = key >> 1;
		}
	p->body_reached[body] = 1;
	++p->body_count;
	p->hub = cni_max_i(p->hub, count);
	p->pairs += count * (count - 1) / 2;
	p->tree_work += (int64_t)count * (count - 1) / 2 + (int64_t)(count - 1) * count * (count + 1) / 6;
}

/* The nodes that hang together with `start`, breadth first. */
static void component_collect(cni_planner *p, int32_t start)
{
	int32_t at, side;
	p->member_count = p->body_count = p->pairs = p->hub = 0;
	p->tree_work = 0;
	p->member[p->member_count++] = start;
	p->seen[start] = 1;
	for (at = 0; at < p->member_count; ++at)
		for (side = 0; side < 2; ++side) {
			int32_t body = cni_planner_body(p, p->member[at], side);
			if (body != 0 && !p->body_reached[body])
				body_reach(p, body);
		}
	p->tree_work += p->member_count;
}

/* ---- order ---- */

static int64_t component_limit(const cni_planner *p)
{
	int32_t k, each = 0;
	int64_t most;
	for (k = 0; k < p->member_count; ++k)
		each = cni_max_i(each, p->system->links[p->member[k]].work_most);
	most = (int64_t)each * p->member_count + 64;
	most = most < p->budget ? most : p->budget;
	return most < INT32_MAX ? most : INT32_MAX; /* cni_component.work */
}

/* As many ends that move as nodes and bodies that a tree has: no two ways from one body to another. */
static int32_t component_is_tree(const cni_planner *p)
{
	int32_t k, ends = 0;
	for (k = 0; k < p->member_count; ++k)
		ends += (cni_planner_body(p, p->member[k], 0) != 0) + (cni_planner_body(p, p->member[k], 1) != 0);
	return ends == p->member_count + p->body_count - 1;
}

/* Of a tree: no more than two nodes at a body, and the first node is an end of the row. */
static int32_t is_chain_from_its_end(const cni_planner *p)
{
	int32_t side, meets = 0;
	for (side = 0; side < 2; ++side) {
		int32_t body = cni_planner_body(p, p->member[0], side);
		meets += body != 0 && cni_planner_next(p, p->body_head[body]) != CNI_NONE;
	}
	return p->hub <= 2 && meets < 2;
}

static int32_t tree_order(cni_planner *p, int64_t most)
{
	int32_t k, base = p->out->node_count, forward = is_chain_from_its_end(p);
	if (p->tree_work > most)
		return 0;
	p->work = p->tree_work;
	if (p->hub > 2 && p->member_count <= CNI_TOPOLOGY_NODES) {
		cni_planner_order_tree(p);
		return 1;
	}
	for (k = 0; k < p->member_count; ++k) {
		int32_t node = p->member[forward ? k : p->member_count - 1 - k];
		p->order[base + k] = node;
		p->position[node] = base + k;
	}
	return 1;
}

/* A failed order gives its scratch memory back. */
static int32_t loops_order(cni_planner *p, int64_t most)
{
	cni_planner before = *p;
	int32_t entries = p->arena->entry_count;
	if (cni_planner_order(p, most))
		return 1;
	cni_planner_pop_to(p->arena, entries);
	p->pool = before.pool;
	p->pool_left = before.pool_left;
	p->pool_taken = before.pool_taken;
	return 0;
}

/* ---- planning ---- */

static int32_t component_width(const cni_planner *p)
{
	int32_t k, width = 2;
	for (k = 0; k < p->member_count; ++k)
		width = cni_max_i(width, p->system->links[p->member[k]].rows);
	return width;
}

static int32_t columns_length(const cni_planner *p)
{
	int32_t k, sum = 0;
	for (k = 0; k < p->member_count; ++k)
		sum += p->list_count[p->member[k]];
	return sum;
}

/* Finds the component's order, and adds it to what is planned if it may be. */
static void component_plan(cni_planner *p)
{
	cni_sparse *s = p->out;
	cni_component *c = &s->components[s->component_count];
	int32_t k, tree = component_is_tree(p);
	if (p->hub > CNI_HUB_MOST || !(tree ? tree_order(p, component_limit(p)) : loops_order(p, component_limit(p))))
		return;
	memset(c, 0, sizeof *c);
	c->begin = s->node_count;
	c->end = s->node_count += p->member_count;
	c->coupling_begin = s->coupling_count;
	c->coupling_end = s->coupling_count += p->pairs;
	c->body_begin = s->body_count;
	c->body_end = s->body_count += p->body_count;
	s->block_count += tree ? p->pairs : columns_length(p);
	c->work = (int32_t)p->work;
	c->tree = tree;
	c->loops = !tree || p->member_count > p->body_count;
	c->width = component_width(p);
	p->budget -= p->work;
	for (k = 0; k < p->member_count; ++k)
		p->planned[p->member[k]] = 1;
	++s->component_count;
}

void cni_planner_components(cni_planner *p)
{
	int32_t k;
	bodies_collect(p);
	for (k = 0; k < p->system->link_count && !p->no_memory; ++k)
		if (!p->seen[k]) {
			component_collect(p, k);
			component_plan(p);
		}
}
