/*
 * step/integrate_pass.h - interface of the body kernels: the loops over awake bodies of integrate.c and finalize.c; and the sum of
 * speed gains that decides whether a body rests.
 */
#ifndef CNI_STEP_INTEGRATE_PASS_H
#define CNI_STEP_INTEGRATE_PASS_H

#include "model/solve.h"

/* A loop over the awake bodies; each iteration reads and writes one body. */
typedef struct cni_body_pass {
	cn_world *world;
	const cni_solve *s;
	cni_motion *motions;
	cni_velocity_start *starts;
	cni_external *externals;
	float h;
	int32_t first; /* 1: the first substep of the step */
} cni_body_pass;

/* Processes bodies begin to end - 1 in whole vectors, and returns the first that it did not process, or end. */
typedef int32_t cni_body_kernel_fn(const cni_body_pass *pass, int32_t begin, int32_t end);

#define CNI_CALM_MOST 8 /* floats in a kernel's vectors, at most */

/* Skips vectors of bodies while no body moves farther (squared) or turns more in the step than the limits. NaN exceeds them. Returns the first
   body of the vector in which one does, or of the rest. */
typedef int32_t cni_body_near_fn(const cni_body_pass *pass, int32_t begin, int32_t end, float way_sq, float turn);

/* Bodies begin, begin + 1, ... as bits, in this order. */
typedef struct cni_poses_taken {
	uint64_t left;    /* not processed */
	uint64_t no_room; /* boxes too small for the way ahead */
	uint64_t rest;    /* may rest: timer and external acceleration not processed */
	uint64_t pushed;  /* ... of those, by errors that are being corrected: cni_is_pushed */
	uint32_t rested; /* 1: some have rested long enough */
} cni_poses_taken;
/* finalize.c's update of at most 64 bodies. */
typedef cni_poses_taken cni_body_poses_fn(cn_world *world, const cni_solve *s, int32_t begin, int32_t end);

typedef struct cni_body_kernel {
	cni_body_kernel_fn *velocities, *positions, *finish;
	cni_body_near_fn *near;
	cni_body_poses_fn *poses;
} cni_body_kernel;

/* Integrated for the whole step already. */
#define CNI_EXTERNAL_DONE ((uint32_t)CNI_EXTERNAL_FREE | (uint32_t)CNI_EXTERNAL_FINISHED)
/* Some axis is locked. */
#define CNI_EXTERNAL_LOCKED ((uint32_t)CNI_EXTERNAL_LOCK_X | (uint32_t)CNI_EXTERNAL_LOCK_Y)
/* Not corrected to the trapezoid rule. */
#define CNI_EXTERNAL_AS_IT_IS ((uint32_t)CNI_EXTERNAL_JOINTED | (uint32_t)CNI_EXTERNAL_DAMPED)

/* Flags of a body that describe the step that finalize completes. */
#define CNI_BODY_OF_THE_WAY ((uint32_t)CNI_BODY_AHEAD | (uint32_t)CNI_BODY_AT_STATIC)

extern const cni_body_kernel cni_body_kernel_4; /* SSE2, NEON, WASM SIMD */
extern const cni_body_kernel cni_body_kernel_8; /* AVX2, chosen at run time */

/*
 * While a body is slow, changes of its speed are summed up: a change dv at time t of the rest timer brings it t dv farther than its
 * speed at the start of the timer would have, so after the time T a steady acceleration a gives a T^2 / 2. Noise and limit cycles of
 * the solver stay below their speed times T, and a steady creep gives nothing. Beyond the sleep delay T is the delay: the sum forgets
 * at this rate. A body at rest gains no more than an acceleration a of CNI_STEADY_ACCELERATION gives in the delay.
 *
 * Each time that a steady acceleration gains so much, it has added a T or more to the speed. A body that gained as often and is slower
 * than that swings about a place, or comes to rest, and counts as at rest.
 *
 * Changes that a tenth of this acceleration gives are none: most bodies of a pile have no others.
 */

/* m/s^2: CNI_STEADY_ACCELERATION, or less where gravity is less than on earth: slopes too steep, and what creeps in a heap, accelerate in proportion. */
static inline float cni_steady_acceleration(const cn_world *world)
{
	float unit = world->settings.length_unit, gravity = cni_length(world->settings.gravity) / CNI_STANDARD_GRAVITY;
	return CNI_STEADY_ACCELERATION * (gravity > 0.0f ? cni_clamp(gravity, CNI_STEADY_LEAST_PART * unit, unit) : unit);
}

/* The change of velocity in a time to which this is compared, squared. */
static inline float cni_little_change_sq(const cn_world *world, float time)
{
	return cni_sq(0.1f * cni_steady_acceleration(world) * time);
}

typedef struct cni_gain_limits {
	float delay, leak; /* leak: dt / delay */
	float most;
	float little_sq;   /* smaller changes of velocity are skipped */
	float speed;       /* that a steady acceleration adds with each gain, less a rounding */
	float alone;       /* part of these for a body that touches and is joined to no other */
} cni_gain_limits;

static inline cni_gain_limits cni_gain_limits_make(const cn_world *world, float dt)
{
	float delay = world->settings.sleep_delay, steady = cni_steady_acceleration(world);
	float leak = dt / cni_max(delay, dt);
	cni_gain_limits limits = { delay, leak, 0.5f * steady * delay * delay, cni_little_change_sq(world, delay * leak), 0.99f * steady * delay,
		cni_length(world->settings.gravity) > 0.0f ? CNI_STEADY_ALONE_PART : 1.0f };
	return limits;
}

/* Adds the change of velocity (dvx, dvy, dw) that led to v. Returns 1 when the body has gained more than a body at rest does. */
static inline int32_t cni_body_gains(cni_body *b, const cni_motion *v, float dvx, float dvy, float dw, const cni_gain_limits *limits)
{
	float part = b->island == CNI_NONE ? limits->alone : 1.0f;
	float turn = v->w * b->extent, dturn = dw * b->extent, x = v->vx - dvx, y = v->vy - dvy, was = turn - dturn, speed, t, keep;
	uint32_t gains = b->flags >> CNI_BODY_GAINS_SHIFT;
	if (dvx * dvx + dvy * dvy + dturn * dturn <= part * part * limits->little_sq && b->sleep_time > 0.0f)
		return 0;
	t = cni_min(b->sleep_time, limits->delay);
	keep = t <= 0.0f ? 0.0f : t < limits->delay ? 1.0f : 1.0f - limits->leak;
	speed = cni_sqrt(v->vx * v->vx + v->vy * v->vy + turn * turn);
	b->gain = keep * b->gain + t * (speed - cni_sqrt(x * x + y * y + was * was));
	if (cni_abs(b->gain) <= part * limits->most || speed < part * limits->speed * (float)(gains + 1u))
		return 0;
	if (b->gain > 0.0f && gains < CNI_BODY_GAINS_MOST)
		b->flags += 1u << CNI_BODY_GAINS_SHIFT;
	return 1;
}

/* x, y: displacement in the step minus dt times velocity, metres; turn: the same of the angle, times the extent. */
static inline int32_t cni_is_pushed(float x, float y, float turn, float most)
{
	return x * x + y * y > most * most || turn * turn > most * most;
}

/* The widest kernel that this build and this processor support. NULL: none. */
const cni_body_kernel *cni_body_kernel_choose(void);

#endif
