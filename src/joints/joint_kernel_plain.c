/*
 * joints/joint_kernel_plain.c - the kernel of joints in plain C, one lane at a time.
 */
#define CNI_WIDTH 1
#define CNI_KERNEL cni_joint_kernel_plain
#include "joints/joint_passes_kernel.h"
