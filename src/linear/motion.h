/*
 * linear/motion.h - the state of a body that constraint rows read and write: velocity, inverse mass, and change of pose
 * within the step.
 */
#ifndef CNI_LINEAR_MOTION_H
#define CNI_LINEAR_MOTION_H

#include "base/maths.h"

/* Colours of joint lanes: no body that can move appears twice in one. */
#define CNI_JOINT_COLORS 23

/* 32 bytes, aligned: the solver gathers and scatters these. */
typedef struct cni_motion {
	float vx, vy, w, inv_mass;
	float dpx, dpy, theta, inv_inertia; /* change of centre and angle since the step began */
} cni_motion;

static inline int32_t cni_motion_can_move(const cni_motion *m) { return m->inv_mass > 0.0f || m->inv_inertia > 0.0f; }

#endif
