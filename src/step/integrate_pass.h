/*
 * step/integrate_pass.h - what integrate.c hands to a body kernel: the loops over awake bodies of a substep; and what velocity_jumps.c and
 * finalize.c do.
 */
#ifndef CNI_STEP_INTEGRATE_PASS_H
#define CNI_STEP_INTEGRATE_PASS_H

#include "model/solve.h"

typedef struct cni_body_pass {
	const cn_world *world;
	cni_motion *motions;
	cni_velocity_start *starts;
	const cni_external *drives;
	float h;
	int32_t first; /* of the step's substeps */
} cni_body_pass;

/* Goes through bodies begin to end - 1, and returns the first that is left to be done by itself: end, or the last where they do not
   fill the kernel's vectors. */
typedef int32_t cni_body_kernel_fn(const cni_body_pass *pass, int32_t begin, int32_t end);

/* Goes on while no velocity of a touched body differs from its start by more than that (squared), as many bodies at once as the
   kernel's vectors have floats. Returns the first of those among which one does, or of what is left. */
typedef int32_t cni_body_calm_fn(const cni_body_pass *pass, int32_t begin, int32_t end, float most_sq);
#define CNI_CALM_MOST 8 /* floats in a kernel's vectors, at most */

/* Likewise, while none goes farther (squared) or turns more in the step than that. What is not a number does. */
typedef int32_t cni_body_near_fn(const cni_body_pass *pass, int32_t begin, int32_t end, float way_sq, float turn);

/* Bodies begin, begin + 1, ... as bits, in this order. */
typedef struct cni_poses_taken {
	uint64_t left;    /* nothing was done with them */
	uint64_t no_room; /* in their boxes, for the way ahead */
	uint64_t rest;    /* may rest: their timer and their drive are left */
	uint64_t pushed;  /* ... of those, by errors that are still being corrected: cni_is_pushed */
	uint32_t rested; /* 1: some have rested for long enough */
} cni_poses_taken;
/* What finalize.c does with each of 64 bodies or less. */
typedef cni_poses_taken cni_body_poses_fn(cn_world *world, const cni_solve *s, int32_t begin, int32_t end);

typedef struct cni_body_kernel {
	cni_body_kernel_fn *velocities, *positions, *finish;
	cni_body_calm_fn *calm;
	cni_body_near_fn *near;
	cni_body_poses_fn *poses;
} cni_body_kernel;

/* Moved for the whole step already. */
#define CNI_EXTERNAL_DONE ((uint32_t)CNI_EXTERNAL_FREE | (uint32_t)CNI_EXTERNAL_FINISHED)
/* Some axis is locked. */
#define CNI_EXTERNAL_LOCKED ((uint32_t)CNI_EXTERNAL_LOCK_X | (uint32_t)CNI_EXTERNAL_LOCK_Y)
/* Their way is not corrected to the trapezoid rule. */
#define CNI_EXTERNAL_AS_IT_IS ((uint32_t)CNI_EXTERNAL_JOINTED | (uint32_t)CNI_EXTERNAL_DAMPED)

/* Flags of a body that tell of the way that is taken. */
#define CNI_BODY_OF_THE_WAY ((uint32_t)CNI_BODY_AHEAD | (uint32_t)CNI_BODY_AT_STATIC)

extern const cni_body_kernel cni_body_kernel_4; /* SSE2, NEON, WASM SIMD */
extern const cni_body_kernel cni_body_kernel_8; /* AVX2, chosen at run time */

/*
 * While a body is slow, changes of its speed are summed up: a change dv at time t of the rest timer brings it t dv farther than its
 * speed at the start of the timer would have, so after the time T a steady acceleration a gives a T^2 / 2. Noise and limit cycles of
 * the solver stay below their speed times T, and a steady creep gives nothing. Beyond the sleep delay T is the delay: the sum forgets
 * at this rate. A body that rests gains no more than CNI_STEADY_SPEED times the delay. With the default of 0.5 s this is an acceleration
 * of 4 mm/s^2, 0.04% of gravity; a box on a slope that is 0.5% too steep for a friction of 0.5 has 22 mm/s^2.
 *
 * A steady acceleration adds 2 CNI_STEADY_SPEED or more to the speed each time that it gains so much, and is no longer slow after
 * sleep_speed / (2 CNI_STEADY_SPEED) times. What is slow still swings about a place, and counts as at rest.
 *
 * Changes that a tenth of this acceleration gives in a step are passed by: most bodies of a pile have no others.
 */
#define CNI_STEADY_SPEED 1e-3f /* length units a second */

typedef struct cni_gain_limits {
	float delay, leak; /* leak: dt / delay */
	float most;
	float little_sq;   /* changes of velocity below this are passed by */
	uint32_t times;    /* in a row */
} cni_gain_limits;

static inline cni_gain_limits cni_gain_limits_make(const cn_world *world, float dt)
{
	float delay = world->settings.sleep_delay, steady = CNI_STEADY_SPEED * world->settings.length_unit;
	float leak = dt / cni_max(delay, dt), little = 0.2f * steady * leak, times = world->settings.sleep_speed / (2.0f * steady);
	cni_gain_limits limits = { delay, leak, steady * delay, little * little, (uint32_t)cni_min(times, (float)CNI_BODY_GAINS_MOST) };
	return limits;
}

/* Takes part of a change of velocity (dvx, dvy, dw) to v. Returns 1 when the body has gained more than one at rest does. */
static inline int32_t cni_body_gains(cni_body *b, const cni_motion *v, float dvx, float dvy, float dw, const cni_gain_limits *limits)
{
	float turn = v->w * b->extent, dturn = dw * b->extent, x = v->vx - dvx, y = v->vy - dvy, was = turn - dturn, t, keep;
	if (dvx * dvx + dvy * dvy + dturn * dturn <= limits->little_sq && b->sleep_time > 0.0f)
		return 0;
	t = cni_min(b->sleep_time, limits->delay);
	keep = t <= 0.0f ? 0.0f : t < limits->delay ? 1.0f : 1.0f - limits->leak;
	b->gain = keep * b->gain + t * (cni_sqrt(v->vx * v->vx + v->vy * v->vy + turn * turn) - cni_sqrt(x * x + y * y + was * was));
	if (cni_abs(b->gain) <= limits->most || b->flags >> CNI_BODY_GAINS_SHIFT >= limits->times)
		return 0;
	b->flags += 1u << CNI_BODY_GAINS_SHIFT;
	return 1;
}

/*
 * Overlaps and open joints are corrected by motion that ends with the step and is in no velocity. While that moves a body faster than
 * this, in length units a second, it does not rest, however slow it is: it would fall asleep on the way. What is left of an error at less is
 * corrected during the sleep delay, many times over.
 */
#define CNI_PUSHED_SPEED 0.05f

/* x, y: by how much more than its velocity moves it in dt the step has moved it, metres; turn: the same, times its extent. */
static inline int32_t cni_is_pushed(float x, float y, float turn, float most)
{
	return x * x + y * y > most * most || turn * turn > most * most;
}

/* The sequential solver moves bodies before it corrects them: there the two are not told apart. */
static inline float cni_pushed_most(const cn_world *world, float dt)
{
	return world->settings.solver == CN_SOLVER_SEQUENTIAL ? FLT_MAX : CNI_PUSHED_SPEED * world->settings.length_unit * dt;
}

/* The widest that this build and this processor have. NULL: none. */
const cni_body_kernel *cni_body_kernel_choose(void);

#endif
