/*
 * linear/sparse_planner.h - what the parts of planning share: sparse_components.c finds components, sparse_order.c the order
 * of those with loops, sparse_plan.c writes the plan.
 */
#ifndef CNI_LINEAR_SPARSE_PLANNER_H
#define CNI_LINEAR_SPARSE_PLANNER_H

#include "linear/sparse.h"

#define CNI_HUB_MOST 64 /* nodes at one body */

/* Nodes that are neighbours of one another: those of a body, at first. */
typedef struct cni_clique {
	int32_t *nodes;              /* in the pool */
	int32_t count;
	int32_t met;                 /* of those of another clique, while degrees are counted */
} cni_clique;

typedef struct cni_planner {
	cni_arena *arena;
	const cni_system *system;
	cni_sparse *out;
	uint8_t *planned;
	int64_t budget;
	int32_t no_memory;           /* 1: the whole plan is given up */

	/* components: by body and by node */
	int32_t *body_head;          /* key of a node = node << 1 | side */
	int32_t *node_next[2];
	uint8_t *body_reached;
	uint8_t *seen;
	int32_t *member;             /* nodes of the component, in order of discovery */
	int32_t member_count;
	int32_t body_count;          /* of the component, those that move */
	int32_t pairs;               /* of nodes at one body */
	int32_t hub;                 /* most nodes at one body */
	int64_t tree_work;           /* of the component, if it is a tree */

	/* order */
	int32_t *order;              /* of the planned nodes so far, components one after the other */
	int32_t *position;           /* by node: its place there */
	cni_clique *clique;          /* by body */
	int32_t *in[2];              /* by node: bodies whose cliques it is in; 0: none */
	int32_t **list;              /* by node: its column, in the pool */
	int32_t *list_count;
	int32_t *mark;               /* by node: for whose column it was met last */
	int32_t *degree, *degree_head, *degree_next, *degree_prev;
	int32_t *pool;               /* the piece that lists are cut from */
	int32_t pool_left;
	int64_t pool_taken, pool_most; /* of all pieces */
	int64_t work;
} cni_planner;

/* 0: a body that cannot move, by which nodes do not meet. */
static inline int32_t cni_planner_body(const cni_planner *p, int32_t node, int32_t side)
{
	const cni_link *link = &p->system->links[node];
	int32_t body = side ? link->ib : link->ia;
	const cni_motion *m = p->system->motions + body;
	return m->inv_mass == 0.0f && m->inv_inertia == 0.0f ? 0 : body;
}

static inline int32_t cni_planner_next(const cni_planner *p, int32_t key)
{
	return p->node_next[key & 1][key >> 1];
}

/* Gives scratch back that was taken since there were so many entries. */
static inline void cni_planner_pop_to(cni_arena *arena, int32_t entries)
{
	while (arena->entry_count > entries)
		(void)cni_arena_pop(arena, arena->entries[arena->entry_count - 1].pointer);
}

/* Finds all components and plans those that may be: their order, and how large everything is. */
void cni_planner_components(cni_planner *p);
/* Order of the present component's nodes after those that are there, and their columns in `list`, with no more work than
   `most`. 0: more, or no memory. */
int32_t cni_planner_order(cni_planner *p, int64_t most);
/* The same of a tree of up to CNI_TOPOLOGY_NODES nodes: an order in which no block fills in. Of trees that are alike it is the
   same. linear/topology_class.c. */
void cni_planner_order_tree(cni_planner *p);

#endif
