/*
 * stages/joint_work.h - what the solver keeps for an awake joint during a step.
 */
#ifndef CNI_STAGES_JOINT_WORK_H
#define CNI_STAGES_JOINT_WORK_H

#include "stages/solver.h"

typedef struct cni_joint_work {
	int32_t joint;
	int32_t ia, ib;            /* dense body indices, 0: static or the world */
	int32_t row_count;
	int32_t rigid_count;       /* the first rows */
	cni_joint_frame start;     /* at the beginning of the step */
	float inverse[6];          /* of the rigid rows' K: 00 01 02 11 12 22 */
	float single_mass[CNI_JOINT_ROWS];
	cni_soft spring;           /* of the spring row, if there is one */
	cni_row rows[CNI_JOINT_ROWS];
} cni_joint_work;

#endif
