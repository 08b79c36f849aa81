/*
 * linear/sparse_planner.h - private to the files of planning: sparse_components.c finds components, sparse_order.c orders
 * those with loops, topology_class.c orders small trees, sparse_plan.c writes the plan.
 */
#ifndef CNI_LINEAR_SPARSE_PLANNER_H
#define CNI_LINEAR_SPARSE_PLANNER_H

#include "linear/sparse.h"

#define CNI_HUB_MOST 64 /* nodes at one body */

/* Nodes that are all neighbours of each other: initially the nodes of one body. */
typedef struct cni_clique {
	int32_t *nodes;              /* in the pool */
	int32_t count;
	int32_t met;                 /* nodes shared with the clique whose degrees are being counted */
} cni_clique;

typedef struct cni_planner {
	cni_arena *arena;
	const cni_system *system;
	cni_sparse *out;
	uint8_t *planned;
	int64_t budget;
	int32_t no_memory;           /* 1: planning fails as a whole */

	/* components: by body and by node */
	int32_t *body_head;          /* list of a body's nodes by key = node << 1 | side */
	int32_t *node_next[2];
	uint8_t *body_reached;
	uint8_t *seen;
	int32_t *member;             /* nodes of the component, in order of discovery */
	int32_t member_count;
	int32_t body_count;          /* moving bodies of the component */
	int32_t ends;                /* of its nodes, at moving bodies */
	int32_t pairs;               /* pairs of nodes that share a body */
	int32_t hub;                 /* largest number of nodes at one body */
	int64_t tree_work;           /* work of the component if it is a tree */

	/* order */
	int32_t *order;              /* planned nodes so far, components one after the other */
	int32_t *position;           /* by node: its index in order */
	cni_clique *clique;          /* by body; that of body 0, which cannot move, is empty */
	int32_t *in[2];              /* by node: bodies of the cliques that contain it; 0: none */
	int32_t **list;              /* by node: its column of L, in the pool */
	int32_t *list_count;
	int32_t *mark;               /* by node: the last node whose column it was added to */
	int32_t *degree, *degree_head, *degree_next, *degree_prev;
	int32_t *pool;               /* the piece of memory that lists are allocated from */
	int32_t pool_left;
	int64_t pool_taken, pool_most; /* sum over all pieces, and its limit */
	int64_t work;
} cni_planner;

/* The body at a side of a node; 0 for a body that cannot move, which connects no nodes. */
static inline int32_t cni_planner_body(const cni_planner *p, int32_t node, int32_t side)
{
	const cni_link *link = &p->system->links[node];
	int32_t body = side ? link->ib : link->ia;
	return cni_motion_can_move(p->system->motions + body) ? body : 0;
}

static inline int32_t cni_planner_next(const cni_planner *p, int32_t key)
{
	return p->node_next[key & 1][key >> 1];
}

/* Number of nodes at a body that can move. */
static inline int32_t cni_planner_nodes_at(const cni_planner *p, int32_t body)
{
	int32_t count = 0;
	for (int32_t key = p->body_head[body]; key != CNI_NONE; key = cni_planner_next(p, key))
		++count;
	return count;
}

/* Frees all scratch that was taken since the arena had `entries` entries. */
static inline void cni_planner_pop_to(cni_arena *arena, int32_t entries)
{
	while (arena->entry_count > entries)
		(void)cni_arena_pop(arena, arena->entries[arena->entry_count - 1].pointer);
}

/* Finds all components and plans those within the limits: their order and all sizes. */
void cni_planner_components(cni_planner *p);
/* Appends the present component's nodes to `order` and writes their columns to `list`. 0: the work exceeds `most`, or there
   is no memory. */
int32_t cni_planner_order(cni_planner *p, int64_t most);
/* The same for a tree of up to CNI_TOPOLOGY_NODES nodes: an order without fill that is equal for isomorphic trees.
   linear/topology_class.c. */
void cni_planner_order_tree(cni_planner *p);

#endif
