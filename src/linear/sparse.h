/*
 * linear/sparse.h - direct solution of coupled constraints: (J M^-1 J^T + C) x = b by sparse block LDL^T.
 *
 * A node is a joint (or a contact): one to three rows between two bodies. Two nodes are neighbours when they share a body
 * that can move. Nodes are eliminated by minimum degree, which creates no fill on chains, bridges and stars and little on
 * other trees (2.4% of the blocks of random ones), so these and ragdolls cost O(n) (Baraff, "Linear-Time Dynamics using
 * Lagrange Multipliers", 1996). Loops create fill; a limit on the work excludes components with too much of it.
 *
 *   nodes     [0][1][2][3]...            in the order of elimination; components one after the other
 *   first     index of node k's first block; it has one for each later neighbour, fill included
 *   below     the later node of each block, ascending
 *   block     2 x 2 floats or 3 columns of 4, column major: rows of the later node, columns of the earlier one
 *   pivot     inverse of the node's own block after elimination
 *
 * A row that acts on no body, or that depends on other rows (its pivot cancels), gets no impulse.
 * Data that changes within a step is scratch from the frame arena. The plan itself is kept for later steps.
 */
#ifndef CNI_LINEAR_SPARSE_H
#define CNI_LINEAR_SPARSE_H

#include "base/ablation.h"
#include "base/arena.h"
#include "base/table.h"
#include "linear/lever.h"

#define CNI_BLOCK_FLOATS (CNI_NODE_ROWS * CNI_NODE_LANES)
#define CNI_PIVOT_LEAST 2e-6f /* a pivot below this part of the diagonal it came from is rounding */
#define CNI_KEPT_BYTES 64

typedef struct cni_node {
	int32_t ia, ib;                    /* dense indices of its bodies, 0: static or the world */
	int32_t owner;                     /* set by the caller; below 0: no joint */
	int32_t rows;                      /* 1 to 3; a rope has none but a third one: direct/active_rows.c */
	uint32_t active;                   /* of a contact: bits of the rows whose levers are set; of a joint: direct/active_rows.c */
	cni_levers levers;
	float share[2];                    /* of the angle, the last row, in each row before it: direct/component.c */
	float compliance[CNI_NODE_ROWS];   /* added to the diagonal */
	float cross;                       /* ... and to the element between the first two rows */
	float diagonal[CNI_NODE_ROWS];     /* of the present system */
	float closing[CNI_NODE_LANES];     /* of a joint: speeds that correct errors are their negatives; in projections (direct/rattle.c) the solution */
	float x[CNI_NODE_LANES];           /* right hand side in, solution out; the last is zero */
	float carried[CNI_NODE_LANES];     /* impulses at the begin of a pass */
	float begun[CNI_NODE_LANES];       /* ... of a joint: impulses before its active set was solved: direct/component.c */
	float total[CNI_NODE_LANES];       /* sum of the solutions so far, where there are several; without contacts: speeds of the rows, then targets */
	float target;                      /* ... target speed of the third row: direct/active_rows.c */
	int32_t next_active;               /* ... the next node with a motor or limit, CNI_NONE */
} cni_node;

/* A node before planning: its bodies (dense indices, 0: static or the world) and its number of rows. */
typedef struct cni_link {
	int32_t ia, ib;
	int32_t owner, rows;
	int32_t work_most; /* the work limit of a component is the largest work_most of its links times their number */
} cni_link;

/* Two nodes that share a body: one term of a block. */
typedef struct cni_coupling {
	int32_t low, high;          /* positions of the nodes, low < high */
	int32_t block;
	uint8_t low_side, high_side; /* side of the shared body in each node */
	uint8_t reserved[2];
} cni_coupling;

/* Of a component that is in no batch, in one, or in one while its joints may have to be locked in this step. */
enum { CNI_NOT_BATCHED, CNI_BATCHED, CNI_BATCHED_MAY_LOCK };

/* A connected component: positions [begin, end) have no coupling to other positions. */
typedef struct cni_component {
	int32_t begin, end;
	int32_t coupling_begin, coupling_end;
	int32_t body_begin, body_end;  /* in bodies */
	int32_t work;                  /* blocks formed or multiplied in one factorization */
	int32_t loops;                 /* 1: more nodes than a tree on these bodies has */
	int16_t tree;                  /* 1: the graph of moving bodies and nodes has no cycle */
	int16_t has_ropes;             /* 1: some nodes have no rows of their own */
	int32_t width;                 /* 2 or 3: rows per node in the solution */
	int32_t touched;               /* number of its bodies that have contacts in lanes */
	float heaviest;                /* greatest mass of a body, kg */
	float mass_ratio;              /* ... over the least */
	int32_t closes_fast;           /* 1: closing all gaps may move a body faster than overlaps are pushed apart: cni_direct_system bounds it */
	int32_t checked;               /* 1: its solutions are checked */
	float regular;                 /* regularization: this fraction of the diagonal is added to it */
	int32_t uses_rattle;           /* 1: direct/rattle.c takes the bodies' whole step */
	int32_t done;                  /* 1: finished for this step */
	int32_t fate;                  /* CNI_FATE_: direct/component_fate.c */
	int32_t meets_kinematic;       /* 1: one of its joints ends at a body that cannot move and is not static */
	int32_t pending;               /* not 0: what is left to do after a loop that workers share */
	int32_t has_contacts;          /* 1: with contacts, see direct/direct_contacts.c */
	int32_t contact_begin, contact_end; /* ... in contacts */
	int32_t cone_pushed;           /* ... 1: direct/friction_cones.c ran in the pass with bias of this substep */
	int32_t denied;                /* ... 1: ... did not run, for the work of other components in this step */
	int32_t nothing_pushed;        /* ... 1: no contact was pushed in this substep */
	int32_t factored;              /* ... 1: the pivots belong to the present levers */
	int32_t joints;                /* number of nodes that are joints */
	int32_t active;                /* 1: the active set has limits, 2: also motors: direct/active_rows.c */
	int32_t active_first;          /* ... its first node, in ascending order */
	int32_t set_changes;           /* ... how often it changed in this step */
	int32_t damps;                 /* 1: its pins may have dampers or locks in this step: direct/geometric_stiffness.c */
	int32_t kind;                  /* topology class or CNI_NONE: linear/topology_class.c */
	int32_t batches;                 /* CNI_BATCHED: solved side by side with others of its class: direct/batched_trees.c */
	int32_t batch, lane;            /* ... where */
} cni_component;

/* Of a component whose joints contacts may open: direct/joint_projection.c. */
typedef struct cni_projection {
	int32_t listed;                /* 1: they may */
	int32_t settles;               /* 1: also after the relax passes */
	int32_t selected;              /* 1: to be checked, because its bodies may have changed since the last check */
	int32_t opening;               /* 1: contacts would open some of its joints in this substep */
	int32_t changed;               /* 1: contacts have changed its bodies since the last check */
	int32_t mark_begin, mark_end;  /* in projection_marks; CNI_NONE: not looked up in this step */
} cni_projection;

/* Contacts of a projection's bodies that are lanes of one block. */
typedef struct cni_marked_lanes {
	int32_t block;
	uint32_t lanes;
	int32_t other; /* component of their other bodies, if contacts may open it, or CNI_NONE */
} cni_marked_lanes;

/* The topology of a tree of nodes of two rows: components are of one class when their topologies are equal. */
#define CNI_TOPOLOGY_NODES 32
#define CNI_TOPOLOGY_COUPLINGS 3 /* for each node */

typedef struct cni_topology {
	int32_t nodes, bodies;            /* bodies: those that move */
	uint8_t end[CNI_TOPOLOGY_NODES][2];   /* by node and side: index of the body in the component; `bodies`: it cannot move */
	uint8_t color[CNI_TOPOLOGY_NODES];    /* by node: the nodes of a body have different colours, as in joints/joint_blocks.c */
} cni_topology;

typedef struct cni_sparse {
	cni_node *nodes;
	int32_t node_count;
	int32_t *first;               /* node_count + 1 */
	int32_t *below;
	int32_t block_count;
	float *blocks;                /* CNI_BLOCK_FLOATS per block */
	float *pivots;                /* ... per node */
	cni_coupling *couplings;
	int32_t coupling_count;
	cni_component *components;
	int32_t component_count;
	int32_t *alone;               /* components without a batch that are not done, or whose lane may have to be locked: direct/component_loop.c */
	int32_t alone_count, shared_count; /* ... of which workers share the first */
	int64_t alone_work;           /* ... the work of all */
	int32_t *bodies;              /* dense indices, by component */
	int32_t body_count;
	int32_t arena_entries;        /* entries of the arena before planning */
	struct cni_tree_batch *batches;       /* direct/batched_trees.c */
	int32_t batch_count;
	struct cni_direct_contact *contacts;   /* direct contacts in the order of their nodes: the owner of contact i's node is -1 - i */
	int32_t contact_count;
	cni_projection *projections;          /* direct/joint_projection.c, by component */
	int32_t settles;                      /* 1: a projection has settles */
	int32_t projection_count;             /* components of which it is used */
	cni_marked_lanes *projection_marks; /* the contacts of each projection's bodies */
	int32_t projection_mark_count;
	int32_t *component_of;            /* by dense body: its component, or CNI_NONE */
	struct cni_heavy_contact *heavies;   /* direct/heavy_contacts.c */
	int32_t heavy_count;
	struct cni_heavy_group *heavy_groups;  /* ... by component */
	int32_t heavy_group_count;
	int32_t *heavy_chains;                 /* ... the first group of each island */
	int32_t heavy_chain_count, heavy_shared_count; /* ... of which workers share the first */
	cni_motion *saved;            /* by index in bodies */
	cni_motion *begun;            /* ... before an active set was solved */
	float *pull;                  /* by dense body: sum(r.f) of its joints; direct/geometric_stiffness.c */
	cni_rot *turn;                /* by dense body: rotation since the step began */
} cni_sparse;

/* The input of planning. */
typedef struct cni_system {
	const cni_link *links;
	int32_t link_count;
	int32_t motion_count;
	const cni_motion *motions;
	int64_t budget;              /* limit of the work of all components together */
} cni_system;

/* Plans the links: chooses the components whose work is within their limits and together within the budget, and writes
   their order and blocks. out_planned[i]: 1 when link i became a node. Bodies that cannot move do not connect nodes.
   kept (NULL: keep nothing) holds the plan of the previous call in items of CNI_KEPT_BYTES. The plan is reused when links,
   moving bodies and budget equal those of that call, else it is replaced; out points into it. Entries pushed to the arena
   stay until the end of the step. The caller passes out zeroed; the nodes' numbers are not written.
   0: not enough memory, nothing planned. */
int32_t cni_sparse_plan(cni_arena *arena, cni_array *kept, const cni_system *system, cni_sparse *out, uint8_t *out_planned);
/* Zeroes the numbers of a component's nodes, before their first use. */
void cni_sparse_clear(cni_sparse *sparse, const cni_component *c);
/* Undoes a plan; its memory must be the latest in the arena. */
void cni_sparse_discard(cni_arena *arena, cni_sparse *sparse);
/* Upper bounds of the scratch and of the kept memory for planning `count` links whose work_most sum to work_most. */
uint64_t cni_sparse_bytes(int32_t count, int32_t body_count, int64_t work_most);
uint64_t cni_sparse_kept_bytes(int32_t count, int64_t work_most);
/* Computes pivots and blocks from the levers of the component's nodes. */
void cni_sparse_factor(cni_sparse *sparse, const cni_component *c, const cni_motion *motions);
/* Takes factors of width 2 that have lanes of `stride` floats: of pivots 00, 01, 11, of blocks 00, 01, 10, 11. */
void cni_sparse_take(cni_sparse *s, const cni_component *c, const float *pivots, const float *blocks, int32_t stride);
/* After it: 1 if elimination has left of some row no more than this part of its diagonal, so that others nearly say the same. */
int32_t cni_sparse_is_redundant(const cni_sparse *s, const cni_component *c, float part);
/* Replaces the right hand sides in the nodes' x by the solution. 0: some x is not finite, because floats cannot hold these
   masses or lever arms together; the caller must discard the solution. */
int32_t cni_sparse_solve(cni_sparse *sparse, const cni_component *c);
/* Of right hand sides b in the nodes' x: y = L^-1 b and z = D^-1 y, CNI_NODE_LANES floats a node. So K^-1 between two of them is the sum of
   y of one times z of the other, and takes half of a solution each. Returns the number of nodes where they are not zero, and where these begin. */
int32_t cni_sparse_halves(cni_sparse *sparse, const cni_component *c, float *y, float *z, int32_t *out_at);
/* ---- topology classes: linear/topology_class.c ---- */

/* Writes the component's topology. 0: the component cannot have a class. */
int32_t cni_topology_describe(const cni_sparse *sparse, const cni_component *c, const cni_motion *motions, cni_topology *out);
/* Sets every component's kind: a class below CNI_TOPOLOGY_CLASSES, or CNI_NONE. */
#define CNI_TOPOLOGY_CLASSES 64
void cni_topology_classes_find(cni_sparse *sparse, const cni_motion *motions);

#endif
