/*
 * direct/batched_trees.h - trees of pins of equal topology, solved side by side: the data that batched_trees.c passes to a kernel.
 *
 * A batch has a tree in each of its lanes, all of one topology class (linear/topology_class.c). Node k of all of them is one block of lanes
 * (joints/joint_pass.h), the batch's k-th, so a pass runs over blocks: springs, motors and limits colour by colour, then the pins of
 * every tree as one system (linear/sparse.h).
 *
 *   nodes     [ block of node 0 | block of node 1 | ... ]      in the order of elimination
 *   pivots    3 rows of lanes a node: 00, 01, 11 of the inverse
 *   blocks    4 rows of lanes a coupling
 *
 * A pass reads and writes each body once. A lane whose bit in `direct` is clear had a system without a solution: its pins are solved one by
 * one.
 */
#ifndef CNI_DIRECT_BATCHED_TREES_H
#define CNI_DIRECT_BATCHED_TREES_H

#include "direct/direct_system.h"
#include "joints/joint_pass.h"

typedef struct cni_tree_batch {
	struct cni_joint_block *nodes;
	float *pivots, *blocks;
	const cni_coupling *couplings;         /* of the tree in the first lane; its nodes and blocks count from node_first and block_first */
	const int32_t *first, *below;
	int32_t node_first, block_first;
	int32_t coupling_count;
	int32_t lanes;
	uint32_t selected, opening;            /* lanes, as bits, of trees to check and of trees that open: see cni_projection */
	cni_topology tree;
	uint8_t order[CNI_TOPOLOGY_NODES];         /* nodes by colour */
	uint32_t source[CNI_TOPOLOGY_NODES + 2];   /* by body: byte offset of its index in `nodes`; its inertia: + CNI_SIDE_BYTES */
	int32_t bodies;                        /* including the immovable one, if there is one */
} cni_tree_batch;

typedef struct cni_tree_batch_pass {
	cni_motion *motions;
	cni_velocity_start *starts;
	cni_joint_pass joint;
	float rate, push; /* part of a gap that is closed in a second, and the greatest closing speed */
	float opening_speed; /* largest speed of an opening pin after contacts */
	float turn_least; /* radians a second: slower arms stay on the tangent */
} cni_tree_batch_pass;

typedef void cni_tree_batch_fn(cni_tree_batch *batch, const cni_tree_batch_pass *pass);

/* By pass: CNI_TREES_ of direct_system.h. */
typedef cni_tree_batch_fn *cni_tree_batch_kernel[CNI_TREES_PASSES];

extern const cni_tree_batch_kernel cni_tree_batch_kernel_plain; /* width 1: any compiler */
extern const cni_tree_batch_kernel cni_tree_batch_kernel_4;     /* SSE2, NEON, WASM SIMD */
extern const cni_tree_batch_kernel cni_tree_batch_kernel_8;     /* AVX2, chosen at run time */

#endif
