/*
 * stages/integrate_pass.h - what integrate.c hands to a body kernel: the loops over awake bodies of a substep.
 */
#ifndef CNI_STAGES_INTEGRATE_PASS_H
#define CNI_STAGES_INTEGRATE_PASS_H

#include "stages/solver.h"

typedef struct cni_body_pass {
	const cn_world *world;
	cni_motion *motions;
	cni_velocity_start *starts;
	const cni_drive *drives;
	float h;
	int32_t first; /* of the step's substeps */
} cni_body_pass;

/* Goes through bodies begin to end - 1, and returns the first that is left to be done by itself: end, or the last where they do not
   fill the kernel's vectors. */
typedef int32_t cni_body_kernel_fn(const cni_body_pass *pass, int32_t begin, int32_t end);

typedef struct cni_body_kernel {
	cni_body_kernel_fn *velocities, *positions, *finish;
} cni_body_kernel;

/* Moved for the whole step already. */
#define CNI_DRIVE_DONE ((uint32_t)CNI_DRIVE_FREE | (uint32_t)CNI_DRIVE_SWUNG)
/* Some axis is locked. */
#define CNI_DRIVE_LOCKED ((uint32_t)CNI_DRIVE_LOCK_X | (uint32_t)CNI_DRIVE_LOCK_Y)
/* Their way is not corrected to the trapezoid rule. */
#define CNI_DRIVE_AS_IT_IS ((uint32_t)CNI_DRIVE_JOINTED | (uint32_t)CNI_DRIVE_DAMPED)

extern const cni_body_kernel cni_body_kernel_4; /* SSE2, NEON, WASM SIMD */
extern const cni_body_kernel cni_body_kernel_8; /* AVX2, chosen at run time */

/* The widest that this build and this processor have. NULL: none. */
const cni_body_kernel *cni_body_kernel_choose(void);

#endif
