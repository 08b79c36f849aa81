/*
 * base/ablation.h - switches of `make ablation`, one a mechanism that a textbook engine with soft constraints does not have.
 *
 * A mechanism off leaves a whole simulation that is weaker or slower. CNI_ON(name) stands where a stage would use the mechanism. It is the
 * constant 1, but in a build with -DCNI_ABLATION, where test/ablation/off.c keeps what the environment variable CAIRN_OFF names.
 *
 *     if (CNI_ON(SPIN))
 *             cni_angular_momentum_restore(world);
 */
#ifndef CNI_BASE_ABLATION_H
#define CNI_BASE_ABLATION_H

#include <stdint.h>

#define CNI_MECHANISMS(X) \
	X(DIRECT_CONTACTS)  /* quiet piles as one system */ \
	X(CONES)            /* ... by interior points, where no active set is found */ \
	X(DIRECT_JOINTS)    /* joints as one system, and all that needs it */ \
	X(HERDS)            /* trees of pins that are alike, side by side */ \
	X(SWINGS)           /* RATTLE, for bodies that only joints hold */ \
	X(CLOSE)            /* joints and contacts by turns */ \
	X(TENSION)          /* dampers of light links under tension */ \
	X(ACTIVE)           /* motors and limits in the system of their joints */ \
	X(SOFT_LOOPS)       /* loops of pins and rods that touch are soft */ \
	X(TRUST)            /* a failure is not tried again at once */ \
	X(PILE_LOAD)        /* loads of new piles from the top down */ \
	X(LOADS)            /* soft contacts yield around a load */ \
	X(SHOCKS)           /* joints forget the impulses of blows */ \
	X(SPIN)             /* angular momentum of what nothing holds */ \
	X(IMPACTS)          /* restitution; without it nothing bounces */ \
	X(FRESH_ROUNDS)     /* new contacts iterate between normals and friction */ \
	X(NORMAL_LAG)       /* CN_SOLVER_SOFT: normals that lag */ \
	X(SEAMS)            /* no corners between flush faces */ \
	X(GRAZES)           /* what passes by is not stopped by a contact ahead */ \
	X(MEETINGS)         /* manifolds of fast pairs are those of where they meet */ \
	X(TRAPEZOID)        /* positions of second order */ \
	X(FLIGHT)           /* free bodies take the whole step at once */ \
	X(EXACT_SPRINGS)    /* springs with the true period and decay */ \
	X(MEAN_STEP)        /* stiffness tied to the mean step */ \
	X(REST)             /* islands at rest take one substep */ \
	X(FOLLOW)           /* contacts that hardly moved are brought up to date in their lanes */ \
	X(SIFT)             /* pairs that stay apart are culled four at a time */ \
	X(WIDE_BOXES)       /* boxes with margins by size, and ahead of free flight */ \
	X(JOINT_LANES)      /* joints side by side */ \
	X(ROW_LANES)        /* ... that are not pins */ \
	X(KEPT_LANES)       /* ... in the lanes of the last step */ \
	X(BODY_KERNELS)     /* bodies side by side in integration and finalize */ \
	X(BOX_BATCHES)      /* manifolds of boxes side by side */ \
	X(KEPT_PLANS)       /* plans of systems are kept from step to step */ \
	X(SWEEP)            /* the sweep over tiles; without it the tree */

#define CNI_MECHANISM_ENTRY(name) CNI_MECHANISM_##name,
enum { CNI_MECHANISMS(CNI_MECHANISM_ENTRY) CNI_MECHANISM_COUNT };
#undef CNI_MECHANISM_ENTRY

#ifdef CNI_ABLATION
extern uint64_t cni_ablation_off; /* bits; written before the first step, and by none while a step runs */
#define CNI_ON(name) ((cni_ablation_off >> CNI_MECHANISM_##name & 1u) == 0)
#else
#define CNI_ON(name) 1
#endif

#endif
