/*
 * stages/sparse_plan.c - which nodes belong together, in what order they are eliminated, which blocks that makes.
 *
 * One component at a time: its nodes' neighbours are collected by body, then the node of least degree is
 * eliminated again and again; its neighbours become neighbours of one another (George and Liu, "Computer Solution
 * of Large Sparse Positive Definite Systems", 1981). The lists of eliminated nodes are the columns of L. A
 * component whose work passes the limit is given up as soon as that shows. Ties go to the node that
 * reached its degree last, so the plan depends on the nodes and their order alone.
 *
 * Scratch: one entry of the arena, cut into arrays; the adjacency lists grow in a pool at its end.
 */
#include "stages/sparse.h"

#include <string.h>

typedef struct planner {
	const cni_link *links;
	const cni_motion *motions;
	int32_t count;
	int32_t body_count;
	int64_t work_most, budget;
	cni_sparse *out;
	uint8_t *planned;
	int32_t *body_head;          /* by body: key of a node = node << 1 | side */
	int32_t *node_next[2];
	int32_t *member;             /* nodes of the component, in order of discovery */
	int32_t *seen;
	int32_t *list, *list_count, *list_capacity; /* by node: its neighbours in the pool */
	int32_t *mark;
	int32_t *degree_head, *degree_next, *degree_prev;
	int32_t *order, *position;
	int32_t *pool;
	int32_t pool_used, pool_capacity;
	int32_t below_capacity, coupling_capacity;
	int32_t member_count, work, turn;
} planner;

/* ---- memory ---- */

enum { POOL_EACH = 12, PLAN_ARRAYS = 16, HUB_MOST = 64, COUPLINGS_EACH = 32 };

/* A limit on the work is one on the blocks as well; beyond a thousand a node it bounds work alone. */
static int64_t work_held(int32_t count, int64_t work_most)
{
	int64_t held = (int64_t)count * 1024;
	return work_most < held ? work_most : held;
}

static int32_t pool_capacity_of(int32_t count, int64_t work_most)
{
	return count * POOL_EACH + (int32_t)work_held(count, work_most) + 64;
}

static int32_t below_capacity_of(int32_t count, int64_t work_most)
{
	return count * 2 + (int32_t)(work_held(count, work_most) / 3) + 16;
}

static int32_t coupling_capacity_of(int32_t count, int64_t work_most)
{
	return cni_min_i(below_capacity_of(count, work_most), count * COUPLINGS_EACH);
}

static uint64_t rounded(uint64_t bytes)
{
	return (bytes + 15) & ~(uint64_t)15;
}

static uint64_t scratch_bytes(int32_t count, int32_t body_count, int64_t work_most)
{
	return rounded(4u * (uint64_t)count) * PLAN_ARRAYS + rounded(4u * (uint64_t)body_count) + rounded(4u * (uint64_t)pool_capacity_of(count, work_most));
}

static uint64_t kept_bytes(int32_t count, int64_t work_most)
{
	uint64_t n = (uint64_t)count;
	return rounded(n * sizeof(cni_node)) + rounded(n * sizeof(cni_component)) + rounded(4u * (n + 1)) + rounded(8u * n) +
	       rounded(4u * (uint64_t)below_capacity_of(count, work_most)) + rounded(sizeof(cni_coupling) * (uint64_t)coupling_capacity_of(count, work_most));
}

static uint64_t block_bytes(int32_t count)
{
	return sizeof(float) * CNI_NODE_ROWS * CNI_NODE_ROWS * (uint64_t)count;
}

uint64_t cni_sparse_bytes(int32_t count, int32_t body_count, int64_t work_most)
{
	return scratch_bytes(count, body_count, work_most) + kept_bytes(count, work_most) +
	       block_bytes(count + below_capacity_of(count, work_most)) + 256;
}

/* Takes bytes from the front of a piece of memory. */
static void *cut(uint8_t **at, uint64_t bytes)
{
	void *p = *at;
	*at += rounded(bytes);
	return p;
}

static int32_t *cut_ints(uint8_t **at, int32_t count)
{
	return (int32_t *)cut(at, 4u * (uint64_t)count);
}

static void planner_cut(planner *p, uint8_t *at)
{
	int32_t n = p->count;
	p->body_head = cut_ints(&at, p->body_count);
	p->node_next[0] = cut_ints(&at, n);
	p->node_next[1] = cut_ints(&at, n);
	p->member = cut_ints(&at, n);
	p->seen = cut_ints(&at, n);
	p->list = cut_ints(&at, n);
	p->list_count = cut_ints(&at, n);
	p->list_capacity = cut_ints(&at, n);
	p->mark = cut_ints(&at, n);
	p->degree_head = cut_ints(&at, n);
	p->degree_next = cut_ints(&at, n);
	p->degree_prev = cut_ints(&at, n);
	p->order = cut_ints(&at, n);
	p->position = cut_ints(&at, n);
	p->pool_capacity = pool_capacity_of(n, p->work_most);
	p->pool = cut_ints(&at, p->pool_capacity);
}

static void kept_cut(planner *p, uint8_t *at)
{
	int32_t n = p->count;
	cni_sparse *s = p->out;
	p->below_capacity = below_capacity_of(n, p->work_most);
	p->coupling_capacity = coupling_capacity_of(n, p->work_most);
	s->nodes = (cni_node *)cut(&at, (uint64_t)n * sizeof(cni_node));
	s->components = (cni_component *)cut(&at, (uint64_t)n * sizeof(cni_component));
	s->first = cut_ints(&at, n + 1);
	s->bodies = cut_ints(&at, 2 * n);
	s->below = cut_ints(&at, p->below_capacity);
	s->couplings = (cni_coupling *)cut(&at, sizeof(cni_coupling) * (uint64_t)p->coupling_capacity);
}

/* ---- components ---- */

/* 0: a body that cannot move, by which nodes do not meet. */
static int32_t node_body(const planner *p, int32_t node, int32_t side)
{
	int32_t body = side ? p->links[node].ib : p->links[node].ia;
	return p->motions[body].inv_mass == 0.0f && p->motions[body].inv_inertia == 0.0f ? 0 : body;
}

/* Lists of the nodes at each body. */
static void bodies_collect(planner *p)
{
	int32_t i, side;
	memset(p->body_head, 0xff, sizeof(int32_t) * (size_t)p->body_count);
	for (i = p->count - 1; i >= 0; --i)
		for (side = 1; side >= 0; --side) {
			int32_t body = node_body(p, i, side);
			if (body == 0)
				continue;
			p->node_next[side][i] = p->body_head[body];
			p->body_head[body] = i << 1 | side;
		}
}

static int32_t key_next(const planner *p, int32_t key)
{
	return p->node_next[key & 1][key >> 1];
}

/* The nodes that hang together with `start`, breadth first. */
static void component_collect(planner *p, int32_t start)
{
	int32_t at, side, key;
	p->member_count = 0;
	p->member[p->member_count++] = start;
	p->seen[start] = 1;
	for (at = 0; at < p->member_count; ++at)
		for (side = 0; side < 2; ++side) {
			int32_t body = node_body(p, p->member[at], side);
			for (key = body == 0 ? CNI_NONE : p->body_head[body]; key != CNI_NONE; key = key_next(p, key))
				if (!p->seen[key >> 1]) {
					p->seen[key >> 1] = 1;
					p->member[p->member_count++] = key >> 1;
				}
		}
}

/* ---- neighbours ---- */

static int32_t list_has(const planner *p, int32_t node, int32_t other)
{
	const int32_t *list = p->pool + p->list[node];
	int32_t k;
	for (k = 0; k < p->list_count[node]; ++k)
		if (list[k] == other)
			return 1;
	return 0;
}

/* Room for `count` neighbours of a node; 0: the pool is full. */
static int32_t list_reserve(planner *p, int32_t node, int32_t count)
{
	int32_t capacity = count + count / 2 + 2;
	if (count <= p->list_capacity[node])
		return 1;
	if (capacity > p->pool_capacity - p->pool_used)
		return 0;
	memcpy(p->pool + p->pool_used, p->pool + p->list[node], sizeof(int32_t) * (size_t)p->list_count[node]);
	p->list[node] = p->pool_used;
	p->list_capacity[node] = capacity;
	p->pool_used += capacity;
	return 1;
}

static void list_add(planner *p, int32_t node, int32_t other)
{
	p->pool[p->list[node] + p->list_count[node]++] = other;
}

/* Neighbours of a component's nodes. 0: too many. */
static int32_t neighbours_collect(planner *p)
{
	int32_t k, side, key, nodes_at;
	p->pool_used = 0;
	for (k = 0; k < p->member_count; ++k) {
		int32_t i = p->member[k];
		p->list[i] = p->list_count[i] = p->list_capacity[i] = 0;
		p->mark[i] = CNI_NONE;
	}
	for (k = 0; k < p->member_count; ++k) {
		int32_t i = p->member[k];
		for (side = 0; side < 2; ++side) {
			int32_t body = node_body(p, i, side);
			nodes_at = 0;
			for (key = body == 0 ? CNI_NONE : p->body_head[body]; key != CNI_NONE; key = key_next(p, key)) {
				int32_t other = key >> 1;
				if (++nodes_at > HUB_MOST)
					return 0;
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

static void degree_link(planner *p, int32_t node)
{
	int32_t d = p->list_count[node], head = p->degree_head[d];
	p->degree_next[node] = head;
	p->degree_prev[node] = CNI_NONE;
	if (head != CNI_NONE)
		p->degree_prev[head] = node;
	p->degree_head[d] = node;
}

static void degree_unlink(planner *p, int32_t node)
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
static int32_t neighbour_inherit(planner *p, int32_t u, int32_t v, int32_t turn)
{
	int32_t k, count = p->list_count[v], *list = p->pool + p->list[u];
	for (k = 0; k < p->list_count[u]; ++k) {
		if (list[k] == v)
			list[k--] = list[--p->list_count[u]];
		else
			p->mark[list[k]] = turn;
	}
	p->mark[u] = turn;
	for (k = 0; k < count; ++k) {
		int32_t w = p->pool[p->list[v] + k];
		if (p->mark[w] == turn)
			continue;
		if (!list_reserve(p, u, p->list_count[u] + 1))
			return 0;
		list_add(p, u, w);
	}
	return 1;
}

static int32_t node_eliminate(planner *p, int32_t v)
{
	int32_t k, count = p->list_count[v];
	for (k = 0; k < count; ++k) {
		int32_t u = p->pool[p->list[v] + k];
		degree_unlink(p, u);
		if (!neighbour_inherit(p, u, v, p->turn++))
			return 0;
		degree_link(p, u);
	}
	p->work += 1 + count + count * (count + 1) / 2;
	return 1;
}

static int64_t component_limit(const planner *p)
{
	int32_t k, each = 0;
	for (k = 0; k < p->member_count; ++k)
		each = cni_max_i(each, p->links[p->member[k]].work_most);
	return (int64_t)each * p->member_count + 64;
}

/* 0: above the limit. */
static int32_t order_find(planner *p)
{
	int32_t k, degree = 0;
	int64_t most = component_limit(p) < p->budget ? component_limit(p) : p->budget;
	p->work = p->turn = 0;
	memset(p->degree_head, 0xff, sizeof(int32_t) * (size_t)p->member_count);
	for (k = p->member_count - 1; k >= 0; --k)
		degree_link(p, p->member[k]);
	for (k = 0; k < p->member_count; ++k) {
		int32_t v;
		while (p->degree_head[degree] == CNI_NONE)
			++degree;
		v = p->degree_head[degree];
		degree_unlink(p, v);
		p->order[k] = v;
		p->position[v] = k;
		if (!node_eliminate(p, v) || p->work > most)
			return 0;
		degree = degree > 0 ? degree - 1 : 0;
	}
	return 1;
}

/* ---- the plan ---- */

static void sort_ascending(int32_t *list, int32_t count)
{
	int32_t gap, i, k;
	for (gap = count / 2; gap > 0; gap = gap == 2 ? 1 : gap * 5 / 11)
		for (i = gap; i < count; ++i) {
			int32_t value = list[i];
			for (k = i; k >= gap && list[k - gap] > value; k -= gap)
				list[k] = list[k - gap];
			list[k] = value;
		}
}

static void node_make(cni_node *n, const cni_link *link)
{
	memset(n, 0, sizeof *n);
	n->ia = link->ia;
	n->ib = link->ib;
	n->owner = link->owner;
	n->rows = link->rows;
}

/* The component's nodes and their blocks, after those that are there. 0: no room. */
static int32_t component_emit_blocks(planner *p, int32_t base)
{
	cni_sparse *s = p->out;
	int32_t k, e;
	for (k = 0; k < p->member_count; ++k) {
		int32_t v = p->order[k], count = p->list_count[v];
		if (s->block_count + count > p->below_capacity)
			return 0;
		node_make(&s->nodes[base + k], &p->links[v]);
		for (e = 0; e < count; ++e)
			s->below[s->block_count + e] = base + p->position[p->pool[p->list[v] + e]];
		sort_ascending(s->below + s->block_count, count);
		s->block_count += count;
		s->first[base + k + 1] = s->block_count;
	}
	return 1;
}

static int32_t block_find(const cni_sparse *s, int32_t low, int32_t high)
{
	int32_t lo = s->first[low], hi = s->first[low + 1] - 1;
	while (lo < hi) {
		int32_t mid = (lo + hi) / 2;
		if (s->below[mid] < high)
			lo = mid + 1;
		else
			hi = mid;
	}
	return lo;
}

/* Terms of the blocks: every two nodes at one body. 0: no room. */
static int32_t component_emit_couplings(planner *p, int32_t base)
{
	cni_sparse *s = p->out;
	int32_t k, side, other;
	for (k = 0; k < p->member_count; ++k) {
		int32_t v = p->order[k];
		for (side = 0; side < 2; ++side) {
			int32_t body = node_body(p, v, side);
			for (other = body == 0 ? CNI_NONE : p->body_head[body]; other != CNI_NONE; other = key_next(p, other)) {
				cni_coupling *c;
				int32_t at = p->position[other >> 1];
				if (at <= k)
					continue;
				if (s->coupling_count == p->coupling_capacity)
					return 0;
				c = &s->couplings[s->coupling_count++];
				c->low = base + k;
				c->high = base + at;
				c->low_side = (uint8_t)side;
				c->high_side = (uint8_t)(other & 1);
				c->block = block_find(s, c->low, c->high);
			}
		}
	}
	return 1;
}

/* Every body of the component once, in the order of its nodes; the lists of nodes at bodies are consumed. */
static void component_emit_bodies(planner *p)
{
	int32_t k, side;
	for (k = 0; k < p->member_count; ++k)
		for (side = 0; side < 2; ++side) {
			int32_t body = node_body(p, p->order[k], side);
			if (body == 0 || p->body_head[body] == CNI_NONE)
				continue;
			p->body_head[body] = CNI_NONE;
			p->out->bodies[p->out->body_count++] = body;
		}
}

static int32_t component_width(const planner *p)
{
	int32_t k, width = 2;
	for (k = 0; k < p->member_count; ++k)
		width = cni_max_i(width, p->links[p->member[k]].rows);
	return width;
}

static void component_plan(planner *p)
{
	cni_sparse *s = p->out;
	cni_component c;
	int32_t k, blocks_before = s->block_count;
	c.begin = s->node_count;
	c.coupling_begin = s->coupling_count;
	c.body_begin = s->body_count;
	if (!neighbours_collect(p) || !order_find(p) || !component_emit_blocks(p, c.begin) || !component_emit_couplings(p, c.begin)) {
		s->block_count = blocks_before;
		s->coupling_count = c.coupling_begin;
		return;
	}
	component_emit_bodies(p);
	for (k = 0; k < p->member_count; ++k)
		p->planned[p->member[k]] = 1;
	s->node_count += p->member_count;
	c.end = s->node_count;
	c.coupling_end = s->coupling_count;
	c.body_end = s->body_count;
	c.work = p->work;
	c.dear = p->work > CNI_DEAR_WORK * p->member_count;
	p->budget -= p->work;
	c.loops = p->member_count > c.body_end - c.body_begin;
	c.width = component_width(p);
	c.regular = 0.0f;
	c.swings = c.done = c.presses = c.calm = c.factored = c.joints = 0;
	s->components[s->component_count++] = c;
}

int32_t cni_sparse_plan(cni_arena *arena, const cni_link *links, int32_t count, const cni_motion *motions, int32_t motion_count,
                        int64_t budget, cni_sparse *out, uint8_t *out_planned)
{
	planner p;
	uint8_t *kept, *scratch;
	int32_t i;
	memset(&p, 0, sizeof p);
	p.links = links;
	p.count = count;
	p.motions = motions;
	p.body_count = motion_count;
	for (i = 0; i < count; ++i)
		p.work_most += links[i].work_most;
	p.budget = budget;
	p.out = out;
	p.planned = out_planned;
	memset(out_planned, 0, (size_t)count);
	kept = (uint8_t *)cni_arena_push(arena, kept_bytes(count, p.work_most));
	scratch = kept == NULL ? NULL : (uint8_t *)cni_arena_push(arena, scratch_bytes(count, motion_count, p.work_most));
	if (scratch == NULL) {
		(void)cni_arena_pop(arena, kept);
		return 0;
	}
	kept_cut(&p, kept);
	planner_cut(&p, scratch);
	out->first[0] = 0;
	bodies_collect(&p);
	memset(p.seen, 0, sizeof(int32_t) * (size_t)count);
	for (i = 0; i < count; ++i)
		if (!p.seen[i]) {
			component_collect(&p, i);
			component_plan(&p);
		}
	(void)cni_arena_pop(arena, scratch);
	out->pivots = (float *)cni_arena_push(arena, block_bytes(out->node_count + out->block_count));
	if (out->pivots == NULL) {
		(void)cni_arena_pop(arena, kept);
		memset(out_planned, 0, (size_t)count);
		out->component_count = 0;
		return 0;
	}
	out->blocks = out->pivots + (size_t)out->node_count * (CNI_NODE_ROWS * CNI_NODE_ROWS);
	return 1;
}

void cni_sparse_discard(cni_arena *arena, cni_sparse *sparse)
{
	(void)cni_arena_pop(arena, sparse->pivots);
	(void)cni_arena_pop(arena, sparse->nodes);
	sparse->node_count = sparse->block_count = sparse->coupling_count = sparse->component_count = sparse->body_count = 0;
}
