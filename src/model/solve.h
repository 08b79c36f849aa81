/*
 * model/solve.h - the numbers of one step, which all stages of the soft step share. The method is TGS soft (Catto, "Solver2D",
 * 2024; Macklin et al., "Small Steps", 2019) with stiffness tied to the substep rate: contacts 1/(8h), joints 1/(4h).
 *
 * Data flow of the substeps, over dense arrays and blocks only:
 *
 *   external --integrate_velocities--> start, motion.v       v = start + response of the last impulses
 *   block.jn, joint.impulse --warm start (first substep)--> motion.v
 *   motion --impacts--> motion.v, start                      contacts that bounce
 *   motion, block --solve--> motion.v, block.jn jt           soft, pushes overlap apart
 *   motion --direct_project--> motion.v, impulses            joints that contacts would open, and those contacts
 *   motion.v --integrate_positions--> motion.dp theta
 *   motion, block --relax--> motion.v, block.jn jt           rigid, removes the push's velocity
 *   motion --direct_settle--> motion.v, impulses             slow trees of joints that contacts would open, and those contacts
 */
#ifndef CNI_MODEL_SOLVE_H
#define CNI_MODEL_SOLVE_H

#include "model/world.h"

/* impulse' = clamp(impulse - m (mass_scale speed + bias_scale error) - impulse_scale impulse). Rigid: 1, 1/h-ish, 0. */
typedef struct cni_soft {
	float mass_scale;
	float bias_scale;    /* mass_scale times the rate (1/s) at which error is removed */
	float impulse_scale;
} cni_soft;

/* The numbers of the passes over contacts of one kind. */
typedef struct cni_contact_pass {
	float inv_h;
	float push_speed;
	float impact_speed;  /* < 0: faster approaches are impacts */
	float warm_scale;
	float load_part;     /* part of its difference to the impulse by which a load changes in this step */
	float load_heavy;    /* limit of that part: this over the square of the speed that the impulse gives, see CNI_LOAD_HEAVY */
	cni_soft soft;
	cni_soft deep;       /* at an overlap of CNI_DEEP_SLOPS slops and more; between that and one slop the coefficients are interpolated */
	float deep_rate;     /* 1/m: the inverse of the length over which they are, */
	float deep_from;     /* the part of this length at which that begins */
	float crush_rate;    /* s/m: the inverse of the speed, given by an impulse, at which a point hardens half */
	int32_t one_sided;   /* lane bodies b are not written */
} cni_contact_pass;

/* Kinds of blocks, as bits. */
enum {
	CNI_CONTACTS_RESTED = 1,    /* one substep a step: loads change slower by the same factor */
	CNI_CONTACTS_ONE_SIDED = 2, /* lane body b cannot move */
	CNI_CONTACTS_KINDS = 4
};

/*
 * CNI_LOAD_RATE and CNI_LOAD_HEAVY: how fast loads follow the impulses that are there, per second; see contacts/contact_kernel.h.
 * A load that follows drives slow swings of a pile, and softness damps them: by a rate of about 0.24 s w^2 at h = 1/240 s, with w^2 falling
 * as the square of the height. So a load must be slower where more is borne: at most
 * CNI_LOAD_HEAVY / (h stress^2), where stress is what a point bears over the lighter body's weight. A pyramid of base 100
 * (stress 25) comes to rest at 0.1, sways on at 0.3, and falls when all its loads follow at 0.6 per second.
 *
 * Between settled bodies they do not rise: in a heap of mixed shapes not every overlap can be taken away, loads that went on rising
 * would press what is wedged until it slips, and 50 bodies crept at 0.7 mm/s for ever, at any of these rates.
 */

struct cni_contact_kernel; /* contacts/contact_pass.h */
struct cni_joint_kernel;   /* joints/joint_pass.h */
struct cni_body_kernel;    /* step/integrate_pass.h */

/* v' = (v + h a) times this: v' = a - damping v, implicit, so that the terminal speed of a fall is exact. */
static inline float cni_damping_factor(float damping, float h)
{
	return 1.0f / (1.0f + damping * h);
}

typedef struct cni_solve {
	float dt, h, inv_h;
	float mean_dt;             /* mean length of the steps so far, this one included */
	float longest_dt;          /* longest of late, this one included */
	float joint_h;             /* its substep */
	float soft_rate;           /* 1/s: rate that softness is tied to; 1 / h if all steps are equal */
	int32_t substeps;
	float warm_scale;          /* factor of stored impulses: length of this substep over the last one's */
	float joint_warm_scale;    /* the same of soft joints: at most 1 */
	float push_speed;
	float pushed_most;        /* metres: a body that corrections of errors move farther in a step does not rest, although its velocity is 0 */
	float restitution_threshold;
	cni_contact_pass contact[CNI_CONTACTS_KINDS];
	cni_soft joint;
	float joint_error_rate;   /* part of its gap that a directly solved joint closes in a second */
	float joint_gap_most;     /* of a joint that was made or put apart, m: what rows see of its gap */
	float joint_turn_most;    /* ... of an angle, rad */
	float restless_speed;     /* joints are relaxed again while that changes a velocity by more */
	const struct cni_contact_kernel *kernel;
	const struct cni_joint_kernel *joint_kernel;
	const struct cni_body_kernel *body_kernel; /* NULL: bodies one by one */
	struct cni_sparse *direct; /* directly solved joints and contacts, NULL: none */
	int32_t relax_sweeps;      /* of the contacts' relax pass in a substep */
	int32_t bounces;           /* some contact has restitution */
	int32_t sums;              /* some contact may report its impulse: contacts/impulse_sums.c */
	uint32_t contact_colors;   /* colours with contacts, as bits */
	int32_t lanes;             /* contacts of all colours */
	cni_team *team;            /* workers of the substeps' loops, NULL: too little work */
} cni_solve;

/* Implicit-Euler soft constraint (Catto, "Soft Constraints", GDC 2011). */
cni_soft cni_soft_implicit(float hertz, float damping_ratio, float h);
/* The same for a spring or a joint with a stiffness: at most 0.125 / h. */
cni_soft cni_soft_row(float hertz, float damping_ratio, float h);
/* Speed with which a soft row closes an error of 1; 0 in the relax pass, where it closes none. */
static inline float cni_soft_error_rate(const cni_soft *soft, int32_t bias)
{
	return bias ? soft->bias_scale / soft->mass_scale : 0.0f;
}
/* Exact discrete spring: a single body on it has the true period and decay at any stiffness. */
cni_soft cni_soft_exact(float hertz, float damping_ratio, float h);

#endif
