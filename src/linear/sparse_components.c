/*
 * linear/sparse_components.c - finds the connected components of a sparse system and decides which ones are planned.
 *
 * It collects one component at a time, breadth first from its first node. The order of a tree needs no search: its nodes
 * are eliminated in reverse breadth-first order, in which the remaining nodes of a body already form a clique, so there is
 * no fill. A chain that begins at its end may also be eliminated forwards; linear/topology_class.c orders small trees with
 * branches. linear/sparse_order.c orders the other components. Components that exceed the limit of their links or the
 * budget are not planned.
 *
 * Reads the system; writes the planner's lists and order, the planned components and sizes.
 */
#include "linear/sparse_planner.h"

#include <string.h>

/* ---- collecting ---- */

/* Lists the nodes of each body. */
static void bodies_collect(cni_planner *p)
{
	memset(p->body_head, 0xff, sizeof(int32_t) * (size_t)p->system->motion_count);
	memset(p->body_reached, 0, (size_t)p->system->motion_count);
	memset(p->seen, 0, (size_t)p->system->link_count);
	for (int32_t i = p->system->link_count - 1; i >= 0; --i)
		for (int32_t side = 1; side >= 0; --side) {
			int32_t body = cni_planner_body(p, i, side);
			if (body == 0)
				continue;
			p->node_next[side][i] = p->body_head[body];
			p->body_head[body] = i << 1 | side;
		}
}

/* Adds all nodes of a body that is reached for the first time. In a tree the k-th of them has k neighbours that are
   eliminated after it: 1 + k + k (k + 1) / 2 blocks of work. */
static void body_reach(cni_planner *p, int32_t body)
{
	int32_t count = 0;
	for (int32_t key = p->body_head[body]; key != CNI_NONE; key = cni_planner_next(p, key), ++count)
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

/* Collects the nodes connected with `start`, breadth first. */
static void component_collect(cni_planner *p, int32_t start)
{
	p->member_count = p->body_count = p->ends = p->pairs = p->hub = 0;
	p->tree_work = 0;
	p->member[p->member_count++] = start;
	p->seen[start] = 1;
	for (int32_t at = 0; at < p->member_count; ++at)
		for (int32_t side = 0; side < 2; ++side) {
			int32_t body = cni_planner_body(p, p->member[at], side);
			p->ends += body != 0;
			if (body != 0 && !p->body_reached[body])
				body_reach(p, body);
		}
	p->tree_work += p->member_count;
}

/* ---- order ---- */

static int64_t component_limit(const cni_planner *p)
{
	int32_t each = 0;
	for (int32_t k = 0; k < p->member_count; ++k)
		each = cni_max_i(each, p->system->links[p->member[k]].work_most);
	int64_t most = (int64_t)each * p->member_count + 64;
	most = most < p->budget ? most : p->budget;
	return most < INT32_MAX ? most : INT32_MAX; /* cni_component.work */
}

/* For a tree: 1 when no body has more than two nodes and the first node is an end of the chain. */
static int32_t is_chain_from_its_end(const cni_planner *p)
{
	int32_t meets = 0;
	for (int32_t side = 0; side < 2; ++side) {
		int32_t body = cni_planner_body(p, p->member[0], side);
		meets += body != 0 && cni_planner_next(p, p->body_head[body]) != CNI_NONE;
	}
	return p->hub <= 2 && meets < 2;
}

static int32_t tree_order(cni_planner *p, int64_t most)
{
	int32_t base = p->out->node_count, forward = is_chain_from_its_end(p);
	if (p->tree_work > most)
		return 0;
	p->work = p->tree_work;
	if (p->hub > 2 && p->member_count <= CNI_TOPOLOGY_NODES) {
		cni_planner_order_tree(p);
		return 1;
	}
	for (int32_t k = 0; k < p->member_count; ++k) {
		int32_t from = p->member_count - 1 - (forward ? k / 2 : k), node = p->member[forward && k % 2 == 0 ? k / 2 : from];
		p->order[base + k] = node;
		p->position[node] = base + k;
	}
	return 1;
}

/* Frees the scratch of an order that fails. */
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

/* Orders the component and adds it to the plan if it is within its limits. The bipartite graph of its nodes and moving bodies is connected,
   so it is a tree when it has one edge fewer than vertices. */
static void component_plan(cni_planner *p)
{
	cni_sparse *s = p->out;
	cni_component *c = &s->components[s->component_count];
	int32_t tree = p->ends == p->member_count + p->body_count - 1;
	if (p->hub > CNI_HUB_MOST || !(tree ? tree_order(p, component_limit(p)) : loops_order(p, component_limit(p))))
		return;
	memset(c, 0, sizeof *c);
	c->begin = s->node_count;
	c->end = s->node_count += p->member_count;
	c->coupling_begin = s->coupling_count;
	c->coupling_end = s->coupling_count += p->pairs;
	c->body_begin = s->body_count;
	c->body_end = s->body_count += p->body_count;
	s->block_count += tree ? p->pairs : 0;
	c->work = (int32_t)p->work;
	c->tree = (int16_t)tree;
	c->loops = !tree || p->member_count > p->body_count;
	c->width = 2;
	p->budget -= p->work;
	for (int32_t k = 0; k < p->member_count; ++k) {
		const int32_t node = p->member[k];
		p->planned[node] = 1;
		s->block_count += tree ? 0 : p->list_count[node];
		c->width = cni_max_i(c->width, p->system->links[node].rows);
		c->joints += p->system->links[node].owner >= 0;
		if (p->system->links[node].rows == 0)
			c->has_ropes = 1;
	}
	++s->component_count;
}

void cni_planner_components(cni_planner *p)
{
	bodies_collect(p);
	for (int32_t k = 0; k < p->system->link_count && !p->no_memory; ++k)
		if (!p->seen[k]) {
			component_collect(p, k);
			component_plan(p);
		}
}
