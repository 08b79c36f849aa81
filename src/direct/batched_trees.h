/*
 * direct/batched_trees.h - trees of pins that are alike, solved side by side: what batched_trees.c hands to a kernel.
 *
 * A herd has a tree in each of its lanes, all of one kind (linear/topology_class.c). Node k of all of them is one block of
 * lanes (joints/joint_pass.h), the herd's k-th, so a pass is one over blocks: springs, motors and limits colour by
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

#include "joints/joint_work.h"

struct cni_joint_block; /* joints/joint_pass.h */

typedef struct cni_herd {
	struct cni_joint_block *nodes;
	float *pivots, *blocks;
	const cni_coupling *couplings;         /* of the tree in the first lane; nodes and blocks are counted from these: */
	const int32_t *first, *below;
	int32_t node_first, block_first;
	int32_t coupling_count;
	int32_t lanes, moving;                 /* moving: bodies that do, of each tree */
	uint32_t asked, parting;               /* lanes, as bits, of trees that are: see cni_closer */
	cni_kind kind;
	uint8_t order[CNI_KIND_NODES];         /* nodes by colour */
	uint32_t source[CNI_KIND_NODES + 2];   /* by body: bytes from the nodes on to the row with its index; its inertia is CNI_SIDE_BYTES behind */
	int32_t bodies;                        /* with the one that cannot move, if there is one */
} cni_herd;

#endif
