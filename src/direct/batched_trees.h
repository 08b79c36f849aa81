/*
 * direct/batched_trees.h - trees of pins that are alike, solved side by side: what batched_trees.c hands to a kernel.
 *
 * A batch has a tree in each of its lanes, all of one kind (linear/topology_class.c). Node k of all of them is one block of
 * lanes (joints/joint_pass.h), the batch's k-th, so a pass is one over blocks: springs, motors and limits colour by
 * colour, then the pins of every tree as one system (linear/sparse.h), all with the bits of one by one.
 *
 *   nodes     [ block of node 0 | block of node 1 | ... ]      in the order of elimination
 *   pivots    3 rows of lanes a node: 00, 01, 11 of the inverse
 *   blocks    4 rows of lanes a coupling
 *
 * Bodies are read once and written once in a pass. A lane whose bit in `direct` is clear has pins that are solved one by
 * one: its system had no solution.
 */
#ifndef CNI_DIRECT_BATCHED_TREES_H
#define CNI_DIRECT_BATCHED_TREES_H

#include "direct/direct_system.h"
#include "joints/joint_pass.h"

typedef struct cni_tree_batch {
	struct cni_joint_block *nodes;
	float *pivots, *blocks;
	const cni_coupling *couplings;         /* of the tree in the first lane; nodes and blocks are counted from these: */
	const int32_t *first, *below;
	int32_t node_first, block_first;
	int32_t coupling_count;
	int32_t lanes, moving;                 /* moving: bodies that do, of each tree */
	uint32_t asked, parting;               /* lanes, as bits, of trees that are: see cni_projection */
	cni_topology kind;
	uint8_t order[CNI_TOPOLOGY_NODES];         /* nodes by colour */
	uint32_t source[CNI_TOPOLOGY_NODES + 2];   /* by body: bytes from the nodes on to the row with its index; its inertia is CNI_SIDE_BYTES behind */
	int32_t bodies;                        /* with the one that cannot move, if there is one */
} cni_tree_batch;

typedef struct cni_tree_batch_pass {
	cni_joint_pass joint;
	float rate, push; /* part of a gap that is closed in a second, and the greatest speed of it */
	float parting;    /* speed of a pin that hard stops may leave */
	float turn_least; /* radians a second: arms that turn slower stay on the tangent */
} cni_tree_batch_pass;

typedef void cni_tree_batch_kernel_fn(cni_motion *motions, cni_velocity_start *starts, cni_tree_batch *batch, const cni_tree_batch_pass *pass);

typedef struct cni_tree_batch_kernel {
	cni_tree_batch_kernel_fn *begin; /* factors of the systems */
	cni_tree_batch_kernel_fn *warm;
	cni_tree_batch_kernel_fn *solve;
	cni_tree_batch_kernel_fn *relax;
	cni_tree_batch_kernel_fn *close; /* after contacts: those of batch->asked that came apart, which become batch->parting */
} cni_tree_batch_kernel;

extern const cni_tree_batch_kernel cni_tree_batch_kernel_plain; /* width 1: any compiler */
extern const cni_tree_batch_kernel cni_tree_batch_kernel_4;     /* SSE2, NEON, WASM SIMD */
extern const cni_tree_batch_kernel cni_tree_batch_kernel_8;     /* AVX2, chosen at run time */

#endif
