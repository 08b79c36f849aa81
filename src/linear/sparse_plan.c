/*
 * linear/sparse_plan.c - plans of sparse systems: writes the blocks of an order, owns a plan's layout in memory, and
 * decides when a plan is reused.
 *
 * The plan is written when the orders of all components, and so all sizes, are known (linear/sparse_components.c).
 *
 * A plan depends only on the links, on which bodies can move, and on the budget. It is kept together with these and
 * reused while they are the same.
 *
 *   kept   [ head | links | ends that move | planned | order | first | bodies | below | couplings | components ]
 *
 * Scratch: one entry of the arena, split into arrays, and the pool of the order.
 */
#include "linear/sparse_planner.h"

#include <string.h>

/* ---- memory ---- */

enum { POOL_EACH = 2, COUPLINGS_EACH = 32 };
#define KEPT_SPARE 4 /* times what is needed: more is given back */

/* A limit on the work also limits the blocks; memory is reserved for at most 1024 units of work per node. */
static int64_t work_held(int32_t count, int64_t work_most)
{
	int64_t held = (int64_t)count * 1024;
	return work_most < held ? work_most : held;
}

static int64_t pool_most(int32_t count, int64_t work_most)
{
	return (int64_t)count * POOL_EACH + work_held(count, work_most) + 4096;
}

static int32_t below_most(int32_t count, int64_t work_most)
{
	return count * 2 + (int32_t)(work_held(count, work_most) / 3) + 16;
}

static uint64_t rounded(uint64_t bytes)
{
	return (bytes + 15) & ~(uint64_t)15;
}

static uint64_t block_bytes(int32_t count)
{
	return sizeof(float) * CNI_BLOCK_FLOATS * (uint64_t)count;
}

static uint64_t node_bytes(int32_t nodes, int32_t components)
{
	return rounded((uint64_t)nodes * sizeof(cni_node)) + (uint64_t)components * sizeof(cni_component);
}

/* Sizes of a plan and its budget. */
typedef struct kept_head {
	int64_t budget;
	int32_t link_count, node_count, block_count, coupling_count, component_count, body_count;
} kept_head;

/* The arrays of a kept plan. */
typedef struct kept_plan {
	kept_head *head;
	cni_link *links;
	uint8_t *moving;             /* bits: the sides of a link whose bodies can move */
	uint8_t *planned;
	int32_t *order;
	int32_t *first;
	int32_t *bodies;
	int32_t *below;
	cni_coupling *couplings;
	cni_component *components;
} kept_plan;

/* Allocates arrays from the front of a piece of memory; without memory it only counts their bytes. */
typedef struct piece {
	uint8_t *memory;
	uint64_t used;
} piece;

static void *alloc(piece *at, uint64_t bytes)
{
	void *p = at->memory != NULL ? at->memory + at->used : NULL;
	at->used += rounded(bytes);
	return p;
}

static int32_t *alloc_ints(piece *at, int32_t count)
{
	return (int32_t *)alloc(at, 4u * (uint64_t)count);
}

/* The arrays of a kept plan of the size h; the head in memory is not written. Returns their bytes. */
static uint64_t kept_cut(uint8_t *memory, const kept_head *h, kept_plan *k)
{
	piece at = { memory, 0 };
	k->head = (kept_head *)alloc(&at, sizeof *h);
	k->links = (cni_link *)alloc(&at, sizeof(cni_link) * (uint64_t)h->link_count);
	k->moving = (uint8_t *)alloc(&at, (uint64_t)h->link_count);
	k->planned = (uint8_t *)alloc(&at, (uint64_t)h->link_count);
	k->order = alloc_ints(&at, h->node_count);
	k->first = alloc_ints(&at, h->node_count + 1);
	k->bodies = alloc_ints(&at, h->body_count);
	k->below = alloc_ints(&at, h->block_count);
	k->couplings = (cni_coupling *)alloc(&at, sizeof(cni_coupling) * (uint64_t)h->coupling_count);
	k->components = (cni_component *)alloc(&at, sizeof(cni_component) * (uint64_t)h->component_count);
	return at.used;
}

/* The arrays and components of a planner for n links between this number of bodies. Returns their bytes. */
static uint64_t planner_cut(uint8_t *memory, int32_t n, int32_t bodies, cni_planner *p, cni_sparse *out)
{
	piece at = { memory, 0 };
	int32_t **ints[] = { &p->node_next[0], &p->node_next[1], &p->member, &p->list_count, &p->in[0], &p->in[1], &p->mark, &p->degree, &p->degree_head,
		&p->degree_next, &p->degree_prev, &p->order, &p->position };
	p->list = (int32_t **)alloc(&at, sizeof(int32_t *) * (uint64_t)n);
	out->components = (cni_component *)alloc(&at, sizeof(cni_component) * (uint64_t)n);
	p->clique = (cni_clique *)alloc(&at, sizeof(cni_clique) * (uint64_t)bodies);
	p->body_head = alloc_ints(&at, bodies);
	for (size_t k = 0; k < sizeof ints / sizeof ints[0]; ++k)
		*ints[k] = alloc_ints(&at, n);
	p->seen = (uint8_t *)alloc(&at, (uint64_t)n);
	p->body_reached = (uint8_t *)alloc(&at, (uint64_t)bodies);
	return at.used;
}

uint64_t cni_sparse_kept_bytes(int32_t count, int64_t work_most)
{
	kept_head h = { 0, count, count, below_most(count, work_most), cni_min_i(below_most(count, work_most), count * COUPLINGS_EACH), count, 2 * count };
	kept_plan unused;
	return kept_cut(NULL, &h, &unused);
}

uint64_t cni_sparse_bytes(int32_t count, int32_t body_count, int64_t work_most)
{
	cni_planner planner;
	cni_sparse unused;
	return planner_cut(NULL, count, body_count, &planner, &unused) + 4u * (uint64_t)pool_most(count, work_most) +
	       node_bytes(count, count) + block_bytes(count + below_most(count, work_most)) + 1024;
}

/* ---- writing the plan ---- */

static void sort_ascending(int32_t *list, int32_t count)
{
	int32_t k;
	for (int32_t gap = count / 2; gap > 0; gap = gap == 2 ? 1 : gap * 5 / 11)
		for (int32_t i = gap; i < count; ++i) {
			int32_t value = list[i];
			for (k = i; k >= gap && list[k - gap] > value; k -= gap)
				list[k] = list[k - gap];
			list[k] = value;
		}
}

/* Writes node k's couplings with later nodes that share a body, ascending. Returns their end. */
static cni_coupling *couplings_write(const cni_planner *p, int32_t k, cni_coupling *begin)
{
	int32_t v = p->order[k];
	cni_coupling *end = begin, *at;
	for (int32_t side = 0; side < 2; ++side) {
		int32_t body = cni_planner_body(p, v, side);
		for (int32_t key = body == 0 ? CNI_NONE : p->body_head[body]; key != CNI_NONE; key = cni_planner_next(p, key)) {
			int32_t high = p->position[key >> 1];
			if (high <= k)
				continue;
			for (at = end++; at > begin && at[-1].high > high; --at)
				*at = at[-1];
			memset(at, 0, sizeof *at);
			at->low = k;
			at->high = high;
			at->low_side = (uint8_t)side;
			at->high_side = (uint8_t)(key & 1);
		}
	}
	return end;
}

/* Writes node k's column, ascending: its couplings in a tree, else its list. Returns its end. */
static int32_t column_write(const cni_planner *p, const cni_component *c, int32_t k, const cni_coupling *begin, const cni_coupling *end, int32_t *below, int32_t at)
{
	int32_t count = c->tree ? (int32_t)(end - begin) : p->list_count[p->order[k]];
	for (int32_t e = 0; e < count; ++e)
		below[at + e] = c->tree ? begin[e].high : p->position[p->list[p->order[k]][e]];
	if (!c->tree)
		sort_ascending(below + at, count);
	return at + count;
}

static void component_write(const cni_planner *p, const cni_component *c, kept_plan *kept)
{
	cni_coupling *begin = kept->couplings + c->coupling_begin, *end;
	for (int32_t k = c->begin; k < c->end; ++k, begin = end) {
		int32_t e = kept->first[k];
		end = couplings_write(p, k, begin);
		kept->first[k + 1] = column_write(p, c, k, begin, end, kept->below, e);
		for (; begin < end; ++begin) {
			while (kept->below[e] != begin->high)
				++e;
			begin->block = e;
		}
	}
	CNI_ASSERT(begin == kept->couplings + c->coupling_end);
}

/* Writes every body of the component once, in the order of its nodes. */
static void bodies_write(const cni_planner *p, const cni_component *c, int32_t *bodies)
{
	int32_t at = c->body_begin;
	for (int32_t k = c->begin; k < c->end; ++k)
		for (int32_t side = 0; side < 2; ++side) {
			int32_t body = cni_planner_body(p, p->order[k], side);
			if (body == 0 || !p->body_reached[body])
				continue;
			p->body_reached[body] = 0;
			bodies[at++] = body;
		}
	CNI_ASSERT(at == c->body_end);
}

static uint8_t link_moving(const cni_planner *p, int32_t node)
{
	return (uint8_t)((cni_planner_body(p, node, 0) != 0) | (cni_planner_body(p, node, 1) != 0) << 1);
}

static void plan_write(const cni_planner *p, kept_plan *kept)
{
	const cni_system *system = p->system;
	memcpy(kept->links, system->links, sizeof(cni_link) * (size_t)system->link_count);
	memcpy(kept->planned, p->planned, (size_t)system->link_count);
	memcpy(kept->order, p->order, sizeof(int32_t) * (size_t)p->out->node_count);
	memcpy(kept->components, p->out->components, sizeof(cni_component) * (size_t)p->out->component_count);
	for (int32_t k = 0; k < system->link_count; ++k)
		kept->moving[k] = link_moving(p, k);
	kept->first[0] = 0;
	for (int32_t k = 0; k < p->out->component_count; ++k) {
		component_write(p, &kept->components[k], kept);
		bodies_write(p, &kept->components[k], kept->bodies);
	}
	CNI_ASSERT(kept->first[p->out->node_count] == p->out->block_count);
}

/* ---- keeping it ---- */

static kept_head head_of(const cni_planner *p)
{
	const cni_sparse *s = p->out;
	kept_head h = { p->system->budget, p->system->link_count, s->node_count, s->block_count, s->coupling_count, s->component_count, s->body_count };
	return h;
}

/* Memory for a plan of this size: the kept array, which is freed first if it is much too large, or else scratch. A world in
   a caller's block keeps the array that it reserved at creation. */
static uint8_t *kept_reserve(cni_arena *arena, cni_array *kept, uint64_t bytes)
{
	int64_t items = (int64_t)(bytes / CNI_KEPT_BYTES) + 1;
	if (kept == NULL || items > INT32_MAX / CNI_KEPT_BYTES)
		return (uint8_t *)cni_arena_push(arena, bytes);
	kept->count = 0;
	if (!arena->memory->fixed) {
		if (kept->capacity / KEPT_SPARE > items)
			cni_array_deinit(kept, arena->memory);
		(void)cni_array_reserve(kept, arena->memory, (int32_t)items);
	}
	if (kept->capacity < items)
		return (uint8_t *)cni_arena_push(arena, bytes);
	kept->count = (int32_t)items;
	return (uint8_t *)kept->data;
}

/* 1 when the kept plan is the plan of this system. */
static int32_t kept_fits(const cni_planner *p, const kept_plan *kept)
{
	const cni_system *system = p->system;
	if (kept->head->link_count != system->link_count || kept->head->budget != system->budget ||
	    memcmp(kept->links, system->links, sizeof(cni_link) * (size_t)system->link_count) != 0)
		return 0;
	for (int32_t k = 0; k < system->link_count; ++k)
		if (kept->moving[k] != link_moving(p, k))
			return 0;
	return 1;
}

/* Makes a new plan in the kept array or in scratch. 0: no memory. */
static int32_t plan_make(cni_planner *p, cni_array *array, kept_plan *kept)
{
	const int32_t links = p->system->link_count, bodies = p->system->motion_count, before = p->arena->entry_count;
	uint8_t *memory = (uint8_t *)cni_arena_push(p->arena, planner_cut(NULL, links, bodies, p, p->out));
	if (memory == NULL)
		return 0;
	(void)planner_cut(memory, links, bodies, p, p->out);
	cni_planner_components(p);
	kept_head head = head_of(p);
	int32_t after = p->arena->entry_count;
	memory = p->no_memory ? NULL : kept_reserve(p->arena, array, kept_cut(NULL, &head, kept));
	if (memory == NULL)
		return 0;
	(void)kept_cut(memory, &head, kept);
	*kept->head = head;
	plan_write(p, kept);
	if (p->arena->entry_count == after)
		cni_planner_pop_to(p->arena, before);
	return 1;
}

/* ---- using it ---- */

/* Makes the step's working copy: nodes, components, memory for the numbers. */
static int32_t plan_take(const cni_planner *p, const kept_plan *kept)
{
	const kept_head *h = kept->head;
	cni_sparse *s = p->out;
	s->nodes = (cni_node *)cni_arena_push(p->arena, node_bytes(h->node_count, h->component_count));
	s->pivots = (float *)cni_arena_push(p->arena, block_bytes(h->node_count + h->block_count));
	if (s->nodes == NULL || s->pivots == NULL)
		return 0;
	s->components = (cni_component *)(void *)((uint8_t *)s->nodes + rounded((uint64_t)h->node_count * sizeof(cni_node)));
	s->blocks = s->pivots + (size_t)h->node_count * CNI_BLOCK_FLOATS;
	for (int32_t k = 0; k < h->node_count; ++k) {
		const cni_link *link = &kept->links[kept->order[k]];
		s->nodes[k].ia = link->ia;
		s->nodes[k].ib = link->ib;
		s->nodes[k].owner = link->owner;
		s->nodes[k].rows = link->rows;
	}
	memcpy(s->components, kept->components, sizeof(cni_component) * (size_t)h->component_count);
	memcpy(p->planned, kept->planned, (size_t)h->link_count);
	s->first = kept->first;
	s->below = kept->below;
	s->couplings = kept->couplings;
	s->bodies = kept->bodies;
	s->node_count = h->node_count;
	s->block_count = h->block_count;
	s->coupling_count = h->coupling_count;
	s->component_count = h->component_count;
	s->body_count = h->body_count;
	return 1;
}

/* Finds the topology classes of a new plan and keeps them with it. */
static void classes_keep(cni_sparse *s, const cni_motion *motions, kept_plan *kept)
{
	cni_topology_classes_find(s, motions);
	for (int32_t k = 0; k < s->component_count; ++k)
		kept->components[k].kind = s->components[k].kind;
}

int32_t cni_sparse_plan(cni_arena *arena, cni_array *kept, const cni_system *system, cni_sparse *out, uint8_t *out_planned)
{
	cni_planner p;
	kept_plan plan;
	int64_t work_most = 0;
	int32_t reusable = 0;
	memset(&p, 0, sizeof p);
	p.arena = arena;
	p.system = system;
	p.out = out;
	p.planned = out_planned;
	p.budget = system->budget;
	for (int32_t k = 0; k < system->link_count; ++k)
		work_most += system->links[k].work_most;
	p.pool_most = pool_most(system->link_count, work_most);
	out->arena_entries = arena->entry_count;
	if (kept != NULL && kept->count > 0 && CNI_ON(KEPT_PLANS)) {
		(void)kept_cut((uint8_t *)kept->data, (const kept_head *)kept->data, &plan);
		reusable = kept_fits(&p, &plan);
	}
	if (system->link_count > 0)
		memset(out_planned, 0, (size_t)system->link_count);
	if ((reusable || plan_make(&p, kept, &plan)) && plan_take(&p, &plan)) {
		if (!reusable)
			classes_keep(out, system->motions, &plan);
		return 1;
	}
	if (kept != NULL && !reusable)
		kept->count = 0; /* its topology classes are missing */
	memset(out_planned, 0, (uint32_t)system->link_count);
	cni_sparse_discard(arena, out);
	return 0;
}

void cni_sparse_clear(cni_sparse *s, const cni_component *c)
{
	for (int32_t k = c->begin; k < c->end; ++k) {
		cni_node *n = &s->nodes[k];
		memset(&n->active, 0, sizeof *n - offsetof(cni_node, active));
	}
}

void cni_sparse_discard(cni_arena *arena, cni_sparse *sparse)
{
	cni_planner_pop_to(arena, sparse->arena_entries);
	sparse->node_count = sparse->block_count = sparse->coupling_count = sparse->component_count = sparse->body_count = 0;
}
