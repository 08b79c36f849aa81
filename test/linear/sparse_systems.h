/*
 * test/linear/sparse_systems.h - makes, plans and solves random systems of coupled constraints for the tests of the direct
 * solver: trees, bridges, stars, grids with loops, several joints between the same two bodies, one to three rows, masses of
 * very different sizes.
 */
#ifndef CAIRN_TEST_SPARSE_SYSTEMS_H
#define CAIRN_TEST_SPARSE_SYSTEMS_H

#include "linear/sparse.h"
#include "test.h"

#include <math.h>
#include <stdlib.h>

#define LINKS_MOST 200
#define BODIES_MOST 210
#define ROWS_MOST (LINKS_MOST * CNI_NODE_ROWS)

/* A system in the form of a caller; bodies[0] is the world. */
typedef struct problem {
	cni_link links[LINKS_MOST];
	cni_motion bodies[BODIES_MOST];
	cni_lever lever[LINKS_MOST][CNI_NODE_ROWS];
	float compliance[LINKS_MOST][CNI_NODE_ROWS];
	float side[LINKS_MOST][CNI_NODE_ROWS]; /* right hand side */
	uint8_t planned[LINKS_MOST];
	int32_t link_count, body_count;
	uint32_t random;
	double decades; /* masses from 1 to 10^decades */
	cni_memory memory;
	cni_arena arena;
	cni_array *kept; /* NULL: no plan is reused */
	cni_sparse sparse;
} problem;

static problem shared; /* too large for a stack */

/* xorshift32 (Marsaglia, 2003) */
static inline float pick(problem *p, float lower, float upper)
{
	p->random ^= p->random << 13;
	p->random ^= p->random >> 17;
	p->random ^= p->random << 5;
	return lower + (upper - lower) * (float)(p->random >> 8) / 16777216.0f;
}

static inline int32_t pick_int(problem *p, int32_t count)
{
	return cni_min_i((int32_t)pick(p, 0.0f, (float)count), count - 1);
}

static inline problem *begin(uint32_t seed, double decades)
{
	problem *p = &shared;
	memset(p, 0, sizeof *p);
	p->random = seed * 2654435761u + 1u;
	p->decades = decades;
	p->body_count = 1;
	cni_memory_init_hooks(&p->memory, NULL, NULL, NULL);
	cni_arena_init(&p->arena, &p->memory);
	return p;
}

static inline void end(problem *p)
{
	cni_arena_deinit(&p->arena);
	CHECK(p->memory.bytes_in_use == 0);
}

/* ---- making systems ---- */

static inline int32_t add_fixed(problem *p)
{
	return p->body_count++;
}

static inline int32_t add_body(problem *p)
{
	cni_motion *m = &p->bodies[p->body_count];
	float mass = (float)pow(10.0, p->decades * (double)pick(p, 0.0f, 1.0f));
	m->inv_mass = 1.0f / mass;
	m->inv_inertia = 1.0f / (mass * pick(p, 0.05f, 0.5f));
	return p->body_count++;
}

/* Adds the rows of a rod (1), a hinge (2) or a weld (3), with a random frame and random levers. */
static inline int32_t add_link(problem *p, int32_t a, int32_t b, int32_t rows)
{
	int32_t k = p->link_count++, i;
	float turn = pick(p, 0.0f, 6.28f), ra_x = pick(p, -1.0f, 1.0f), ra_y = pick(p, -1.0f, 1.0f);
	float rb_x = pick(p, -1.0f, 1.0f), rb_y = pick(p, -1.0f, 1.0f);
	p->links[k].ia = a;
	p->links[k].ib = b;
	p->links[k].owner = 1000 + k;
	p->links[k].rows = rows;
	p->links[k].work_most = 1000;
	for (i = 0; i < rows; ++i) {
		float x = (float)cos((double)turn + 1.5707963 * (double)i), y = (float)sin((double)turn + 1.5707963 * (double)i);
		cni_lever linear = { -x, -y, -(ra_x * y - ra_y * x), x, y, rb_x * y - rb_y * x };
		cni_lever angular = { 0.0f, 0.0f, -1.0f, 0.0f, 0.0f, 1.0f };
		p->lever[k][i] = i < 2 ? linear : angular;
		p->side[k][i] = pick(p, -1.0f, 1.0f);
	}
	return k;
}

/* Sets the compliance to a part of the row's own diagonal, or to 1 where the diagonal is zero. */
static inline void soften(problem *p, int32_t k, float part)
{
	const cni_motion *a = &p->bodies[p->links[k].ia], *b = &p->bodies[p->links[k].ib];
	int32_t i;
	for (i = 0; i < p->links[k].rows; ++i) {
		const cni_lever *l = &p->lever[k][i];
		float whole = a->inv_mass * (l->ax * l->ax + l->ay * l->ay) + a->inv_inertia * l->aw * l->aw +
		              b->inv_mass * (l->bx * l->bx + l->by * l->by) + b->inv_inertia * l->bw * l->bw;
		p->compliance[k][i] = whole > 0.0f ? part * whole : 1.0f;
	}
}

/* Adds a chain of bodies, each linked to the previous one, the first to `from`. rows 0: one to three, at random. */
static inline void add_chain(problem *p, int32_t from, int32_t count, int32_t rows)
{
	int32_t k;
	for (k = 0; k < count; ++k) {
		int32_t body = add_body(p);
		add_link(p, from, body, rows ? rows : 1 + pick_int(p, 3));
		from = body;
	}
}

static inline void add_tree(problem *p, int32_t count, int32_t rows)
{
	int32_t first = add_body(p), k;
	for (k = 1; k < count; ++k) {
		int32_t to = first + pick_int(p, k), body = add_body(p);
		if (pick_int(p, 2))
			add_link(p, to, body, rows ? rows : 1 + pick_int(p, 3));
		else
			add_link(p, body, to, rows ? rows : 1 + pick_int(p, 3));
	}
}

static inline void add_bridge(problem *p, int32_t count, int32_t rows)
{
	int32_t last;
	add_chain(p, 0, count, rows);
	last = p->body_count - 1;
	add_link(p, last, add_fixed(p), rows);
}

static inline int32_t add_star(problem *p, int32_t arms, int32_t rows)
{
	int32_t hub = add_body(p), k;
	for (k = 0; k < arms; ++k)
		add_link(p, hub, add_body(p), rows ? rows : 1 + pick_int(p, 3));
	return hub;
}

static inline void add_grid(problem *p, int32_t side, int32_t rows)
{
	int32_t first = p->body_count, x, y;
	for (y = 0; y < side * side; ++y)
		add_body(p);
	for (y = 0; y < side; ++y)
		for (x = 0; x < side; ++x) {
			int32_t body = first + y * side + x;
			if (x + 1 < side)
				add_link(p, body, body + 1, rows);
			if (y + 1 < side)
				add_link(p, body, body + side, rows);
		}
}

/* ---- solving them ---- */

static inline int64_t work_allowed(const problem *p)
{
	int64_t sum = 0;
	int32_t k;
	for (k = 0; k < p->link_count; ++k)
		sum += p->links[k].work_most;
	return sum;
}

static inline uint64_t bytes_promised(const problem *p)
{
	int64_t work = work_allowed(p);
	return cni_sparse_bytes(p->link_count, p->body_count, work) + cni_sparse_kept_bytes(p->link_count, work);
}

static inline int32_t plan_within(problem *p, int64_t budget)
{
	cni_system system = { p->links, p->link_count, p->body_count, p->bodies, budget };
	int32_t k, good = cni_sparse_plan(&p->arena, p->kept, &system, &p->sparse, p->planned);
	for (k = 0; k < p->sparse.component_count; ++k)
		cni_sparse_clear(&p->sparse, &p->sparse.components[k]);
	return good;
}

static inline int32_t plan(problem *p)
{
	return plan_within(p, INT64_MAX);
}

static inline void fill_nodes(problem *p)
{
	int32_t k, i;
	for (k = 0; k < p->sparse.node_count; ++k) {
		cni_node *n = &p->sparse.nodes[k];
		for (i = 0; i < n->rows; ++i) {
			cni_levers_set(&n->levers, i, p->lever[n->owner - 1000][i]);
			n->compliance[i] = p->compliance[n->owner - 1000][i];
			n->x[i] = p->side[n->owner - 1000][i];
		}
	}
}

static inline void solve(problem *p, float regular)
{
	int32_t k;
	fill_nodes(p);
	for (k = 0; k < p->sparse.component_count; ++k) {
		p->sparse.components[k].regular = regular;
		cni_sparse_factor(&p->sparse, &p->sparse.components[k], p->bodies);
		cni_sparse_solve(&p->sparse, &p->sparse.components[k]);
	}
}

/* ---- some systems ---- */

static inline void make_tree(problem *p) { add_tree(p, 60, 0); }
static inline void make_rooted_tree(problem *p) { add_tree(p, 60, 0); add_link(p, 0, 1, 2); }
static inline void make_chain(problem *p) { add_chain(p, 0, 100, 2); }
static inline void make_bridge(problem *p) { add_bridge(p, 40, 2); }
static inline void make_star(problem *p) { add_star(p, 30, 0); }
static inline void make_grid(problem *p) { add_grid(p, 7, 1); }

static inline void make_soft_grid(problem *p)
{
	int32_t k;
	add_grid(p, 6, 3);
	for (k = 0; k < p->link_count; ++k)
		soften(p, k, 0.01f);
}

static inline void make_soft_net(problem *p)
{
	int32_t k;
	add_grid(p, 10, 2);
	for (k = 0; k < p->link_count; ++k)
		soften(p, k, 0.1f);
}

/* Two or three rods between the same two bodies, in either order. */
static inline void make_parallel(problem *p)
{
	int32_t from = add_body(p), k;
	for (k = 0; k < 20; ++k) {
		int32_t body = add_body(p);
		add_link(p, from, body, 1);
		add_link(p, body, from, 1);
		if (pick_int(p, 2))
			add_link(p, from, body, 1);
		from = body;
	}
}

/* Static bodies connect no nodes; bodies that can only rotate or only translate do. */
static inline void make_hindered(problem *p)
{
	int32_t k, count;
	add_tree(p, 40, 1);
	count = p->body_count;
	for (k = 1; k < count; ++k) {
		if (k % 3 == 0)
			p->bodies[k].inv_inertia = 0.0f;
		if (k % 7 == 1)
			p->bodies[k].inv_mass = 0.0f;
		if (k % 5 == 0)
			add_link(p, k, add_fixed(p), 1);
	}
	for (k = 0; k < p->link_count; ++k)
		soften(p, k, 0.01f); /* without compliance a row may act on no body */
}

#endif
