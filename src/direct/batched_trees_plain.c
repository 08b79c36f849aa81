/*
 * direct/batched_trees_plain.c - the kernel of batched trees in plain C, one lane at a time.
 */
#define CNI_WIDTH 1
#define CNI_KERNEL cni_tree_batch_kernel_plain
#include "direct/batched_trees_kernel.h"
