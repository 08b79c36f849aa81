/*
 * stages/joint_work.h - what the solver keeps for an awake joint during a step.
 */
#ifndef CNI_STAGES_JOINT_WORK_H
#define CNI_STAGES_JOINT_WORK_H

#include "stages/solver.h"

enum {
	CNI_WORK_SPRINGY = 1u << 0,   /* the first rows and violated limits act in the soft pass only */
	CNI_WORK_BOUNDED = 1u << 1,   /* force_max or torque_max is set */
	CNI_WORK_BREAKABLE = 1u << 2, /* a break threshold is set */
	CNI_WORK_GROUNDS = 1u << 3,   /* d and e are seen from points of the world */
	CNI_WORK_TURNS = 1u << 4      /* counts whole turns */
};

/* What every pass over plain joints touches comes first and together. */
typedef struct cni_joint_work {
	const cni_joint *record;   /* within a step records do not move */
	cni_joint_rows_fn *make_rows; /* of its type */
	int32_t joint;
	int32_t ia, ib;            /* dense body indices, 0: static or the world */
	int32_t row_count;
	int32_t rigid_count;       /* the first rows: rigid or drive */
	uint32_t flags;            /* CNI_WORK_* */
	cni_joint_frame start;     /* at the beginning of the step */
	float inverse[6];          /* of the first rows' K: 00 01 02 11 12 22 */
	cni_row rows[CNI_JOINT_ROWS];
	float single_mass[CNI_JOINT_ROWS];
	cni_soft soft;             /* springy: of the first rows and of limits */
	cni_soft spring;           /* of the spring or soft row, if there is one */
	float force_max, torque_max;       /* bounded: most, FLT_MAX without a bound */
	float force_stress, torque_stress; /* breakable: largest reaction of the step so far */
} cni_joint_work;

#endif
