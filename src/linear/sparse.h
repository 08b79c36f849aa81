/*
 * linear/sparse.h - direct solution of coupled constraints: (J M^-1 J^T + C) x = b by sparse block LDL^T.
 *
 * A node is a joint (or a contact): one to three rows between two bodies. Two nodes are neighbours when they
 * share a body that can move. Nodes are eliminated in the order of least degree, which makes no fill on chains,
 * bridges and stars and little on other trees (2.4% of the blocks of random ones), so these and ragdolls cost O(n)
 * (Baraff, "Linear-Time Dynamics using Lagrange Multipliers", 1996). Loops fill in; a limit on the work leaves out
 * components that fill in too much.
 *
 *   nodes     [0][1][2][3]...            in the order of elimination; components one after the other
 *   first     where node k's blocks begin: one for each later neighbour, fill included
 *   below     which node each block leads to, ascending
 *   block     2 x 2 or 3 x 3 floats, row major: rows of the later node, columns of the earlier one
 *   pivot     inverse of the node's own block after elimination
 *
 * A row that acts on nothing, or that only repeats what others say (a pivot that cancels), gets no impulse.
 * What may change in a step is scratch from the frame arena. The plan itself is kept for the steps after.
 */
#ifndef CNI_LINEAR_SPARSE_H
#define CNI_LINEAR_SPARSE_H

#include "base/ablation.h"
#include "base/arena.h"
#include "base/table.h"
#include "linear/motion.h"

#define CNI_NODE_ROWS 3
#define CNI_PIVOT_LEAST 2e-6f /* a pivot below this part of the diagonal it came from is rounding */
#define CNI_KEPT_BYTES 64

/* One row of J: speed = a . (va, wa) + b . (vb, wb). */
typedef struct cni_lever {
	float ax, ay, aw, bx, by, bw;
} cni_lever;

typedef struct cni_node {
	int32_t ia, ib;                    /* dense indices of its bodies, 0: static or the world */
	int32_t owner;                     /* the caller's */
	int32_t rows;                      /* 1 to 3 */
	uint32_t held;                     /* of a contact: bits of the rows whose levers are set; of a joint: direct/active_rows.c */
	cni_lever lever[CNI_NODE_ROWS];    /* rows beyond `rows` are zero */
	float compliance[CNI_NODE_ROWS];   /* added to the diagonal */
	float cross;                       /* ... and between its first two rows */
	float least[CNI_NODE_ROWS];        /* least pivots: less is rounding */
	float x[CNI_NODE_ROWS];            /* right hand side in, solution out */
	float carried[CNI_NODE_ROWS];      /* impulses that a pass began with */
	float total[CNI_NODE_ROWS];        /* solutions so far, where there are several; of joints with motors: speeds that are asked for */
	float wanted;                      /* ... and that of the third row: direct/active_rows.c */
} cni_node;

/* What is planned: a node's bodies (dense indices, 0: static or the world) and how many rows it has. */
typedef struct cni_link {
	int32_t ia, ib;
	int32_t owner, rows;
	int32_t work_most; /* the limit of its component is the greatest of its links', times their number */
} cni_link;

/* Two nodes that share a body: a term of a block. */
typedef struct cni_coupling {
	int32_t low, high;          /* positions */
	int32_t block;
	uint8_t low_side, high_side; /* which of each one's bodies */
	uint8_t reserved[2];
} cni_coupling;

/* Positions [begin, end) that no other component couples with. */
typedef struct cni_component {
	int32_t begin, end;
	int32_t coupling_begin, coupling_end;
	int32_t body_begin, body_end;  /* in bodies */
	int32_t work;                  /* blocks formed or multiplied in one factorization */
	int32_t loops;                 /* 1: more nodes than a tree has */
	int32_t tree;                  /* 1: its nodes are one: no two ways from one to another */
	int32_t width;                 /* 2 or 3: rows that its nodes are solved with */
	float regular;                 /* added to the diagonal, as a part of it */
	int32_t swings;                /* of direct/rattle.c */
	int32_t done;                  /* 1: nothing more to do for it in this step */
	int32_t presses;               /* 1: with contacts, of direct/direct_contacts.c */
	int32_t coned;                 /* ... in this step direct/friction_cones.c was asked */
	int32_t calm;                  /* ... nothing was pushed in this substep */
	int32_t factored;              /* ... and its pivots are those of the levers */
	int32_t joints;                /* of direct/direct_joints.c: how many of its nodes are joints */
	int32_t active;                /* 1: some have limits in it, 2: motors: direct/active_rows.c */
	int32_t kind;                  /* those of one kind are alike: linear/topology_class.c; CNI_NONE */
	int32_t batches;                 /* 1: solved beside others of its kind: direct/batched_trees.c */
	int32_t batch, lane;            /* ... where */
} cni_component;

/* A component that contacts may part: direct/joint_projection.c. */
typedef struct cni_projection {
	int32_t component;
	int32_t batch, lane;            /* batch CNI_NONE: it is in none */
	int32_t rounds;                /* of contacts, in a substep, at most */
	int32_t asked;                 /* 1: its bodies may have changed since it was looked at */
	int32_t parting;               /* 1: contacts would open some of its joints in this substep */
	int32_t changed;               /* 1: contacts have changed its bodies since then */
	int32_t slot_begin, slot_end;  /* in projection_slots; CNI_NONE: not looked up in this step */
} cni_projection;

/* A tree of nodes of two rows, as what is alike sees it. */
#define CNI_TOPOLOGY_NODES 32
#define CNI_TOPOLOGY_COUPLINGS 3 /* for each node */

typedef struct cni_topology {
	int32_t nodes, bodies;            /* bodies: that move */
	uint8_t end[CNI_TOPOLOGY_NODES][2];   /* by node and side: place of the body among the component's; `bodies`: it cannot move */
	uint8_t color[CNI_TOPOLOGY_NODES];    /* by node: no body has one twice, as of joints/joint_blocks.c */
} cni_topology;

typedef struct cni_sparse {
	cni_node *nodes;
	int32_t node_count;
	int32_t *first;               /* node_count + 1 */
	int32_t *below;
	int32_t block_count;
	float *blocks;                /* 9 a block */
	float *pivots;                /* 9 a node */
	cni_coupling *couplings;
	int32_t coupling_count;
	cni_component *components;
	int32_t component_count;
	int32_t *bodies;              /* dense indices, by component */
	int32_t body_count;
	int32_t arena_entries;        /* before it was planned */
	int32_t released;             /* of direct/direct_joints.c: components given up since lanes were filled */
	struct cni_tree_batch *batches;       /* of direct/batched_trees.c */
	int32_t batch_count;
	struct cni_direct_contact *presses;    /* contacts: nodes whose owner is -1 - press */
	int32_t press_count;
	cni_projection *projections;          /* of direct/joint_projection.c, by component */
	int32_t projection_count;
	int32_t *projection_slots;        /* places in lanes of the contacts of each one's bodies */
	int32_t projection_slot_count;
	int32_t *projection_of;           /* by dense body: its projection, CNI_NONE */
	cni_motion *saved;            /* by place in bodies */
	float *pull;                  /* by dense body: sum(r.f) of its joints; direct/geometric_stiffness.c */
	cni_rot *turn;                /* by dense body: rotation since the step began */
} cni_sparse;

/* What is to be planned. */
typedef struct cni_system {
	const cni_link *links;
	int32_t link_count;
	int32_t motion_count;
	const cni_motion *motions;
	int64_t budget;              /* most work of all components together */
} cni_system;

/* Which of the links make components within the limit of each, and together within the budget, their order and their
   blocks. out_planned[i] says whether link i became a node. Bodies that cannot move do not connect.
   kept (NULL: nothing is) holds the plan of the call before, of items of CNI_KEPT_BYTES; where links, moving bodies and
   budget are those of that call it is used again, else replaced; out points into it. What was pushed to the arena stays there until
   the end of the step. out is zero but for presses; nodes' numbers are not written. 0: not enough memory, nothing planned. */
int32_t cni_sparse_plan(cni_arena *arena, cni_array *kept, const cni_system *system, cni_sparse *out, uint8_t *out_planned);
/* The numbers of a component's nodes become zero: before it is used. */
void cni_sparse_clear(cni_sparse *sparse, const cni_component *c);
/* Takes a plan back: its memory must be the latest of the arena. */
void cni_sparse_discard(cni_arena *arena, cni_sparse *sparse);
/* Scratch, and what is kept, of planning `count` links whose work_most add up to this, at most. */
uint64_t cni_sparse_bytes(int32_t count, int32_t body_count, int64_t work_most);
uint64_t cni_sparse_kept_bytes(int32_t count, int64_t work_most);
/* From the levers of the component's nodes to its pivots and blocks. */
void cni_sparse_factor(cni_sparse *sparse, const cni_component *c, const cni_motion *motions);
/* The nodes' x from right hand sides to solutions. 0: some of it is not finite, for masses or arms that floats cannot
   hold together; nothing must be done with it. */
int32_t cni_sparse_solve(cni_sparse *sparse, const cni_component *c);
/* ---- kinds: linear/topology_class.c ---- */

/* What the component is to those that are like it. 0: it is not of the sort that has a kind. */
int32_t cni_topology_describe(const cni_sparse *sparse, const cni_component *c, const cni_motion *motions, cni_topology *out);
/* Sets every component's kind: a number less than CNI_TOPOLOGY_CLASSES, or CNI_NONE. */
#define CNI_TOPOLOGY_CLASSES 64
void cni_topology_classes_find(cni_sparse *sparse, const cni_motion *motions);

static inline float cni_lever_speed(const cni_lever *l, const cni_motion *a, const cni_motion *b)
{
	return l->ax * a->vx + l->ay * a->vy + l->aw * a->w + l->bx * b->vx + l->by * b->vy + l->bw * b->w;
}

/* Of a row: speed by an impulse of one. */
static inline float cni_lever_inverse_mass(const cni_lever *l, const cni_motion *a, const cni_motion *b)
{
	return a->inv_mass * (l->ax * l->ax + l->ay * l->ay) + a->inv_inertia * l->aw * l->aw +
	       b->inv_mass * (l->bx * l->bx + l->by * l->by) + b->inv_inertia * l->bw * l->bw;
}

static inline void cni_lever_push(const cni_lever *l, float impulse, cni_motion *a, cni_motion *b)
{
	float ma = a->inv_mass * impulse, mb = b->inv_mass * impulse;
	a->vx += ma * l->ax;
	a->vy += ma * l->ay;
	a->w += a->inv_inertia * impulse * l->aw;
	b->vx += mb * l->bx;
	b->vy += mb * l->by;
	b->w += b->inv_inertia * impulse * l->bw;
}

#endif
