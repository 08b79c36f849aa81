/*
 * base/ablation.h - switches of `make ablation`: one per mechanism that a textbook engine with soft constraints does not have.
 *
 * Without a mechanism the simulation is complete but weaker or slower. A stage tests CNI_ON(name) before it uses the
 * mechanism. CNI_ON is a constant: 1, or with -DCN_PLAIN_STEP 0 for some. In a build with -DCNI_ABLATION test/ablation/off.c switches
 * off the mechanisms that the environment variable CAIRN_OFF names.
 *
 *     if (CNI_ON(ANGULAR_MOMENTUM))
 *             cni_angular_momentum_restore(world);
 */
#ifndef CNI_BASE_ABLATION_H
#define CNI_BASE_ABLATION_H

#include <stdint.h>

#define CNI_MECHANISMS(X) \
	X(DIRECT_CONTACTS)    /* contacts of quiet piles solved as one system */ \
	X(CONES)              /* ... by an interior point method where no active set is found */ \
	X(DIRECT_JOINTS)      /* joints solved as one system, and all that depends on it */ \
	X(TREE_BATCHES)       /* trees of pins of one topology class solved side by side */ \
	X(RATTLE)             /* RATTLE for bodies that only joints hold */ \
	X(JOINT_PROJECTION)   /* joint projection after contacts */ \
	X(HEAVY_CONTACTS)     /* contacts with light bodies that exact joints hold know these joints */ \
	X(GEOMETRIC_STIFFNESS)/* geometric stiffness: damping of light links under tension */ \
	X(ACTIVE_ROWS)        /* motors and limits in the system of their joints */ \
	X(DIRECT_ROPES)       /* taut ropes in the systems of the joints around them */ \
	X(SOFT_LOOPS)         /* loops of pins and rods that touch something are soft */ \
	X(RETRY_DELAY)        /* delayed retry after a failed direct solution */ \
	X(GRAVITY_PRELOAD)    /* gravity preload of new piles, top-down */ \
	X(OVERLAP_PROJECTION) /* bodies at rest are moved out of overlaps */ \
	X(COMPLIANCE_OFFSETS) /* soft contacts yield around a compliance offset */ \
	X(ANGULAR_MOMENTUM)   /* angular momentum correction of free islands */ \
	X(IMPACTS)            /* restitution; without it nothing bounces */ \
	X(FRESH_ROUNDS)       /* new contacts iterate between normals and friction */ \
	X(NORMAL_LAG)         /* CN_SOLVER_SOFT: lagging normals */ \
	X(SEAMS)              /* no corners between flush faces */ \
	X(SPECULATIVE_MISSES) /* a speculative contact ahead does not stop shapes that pass by */ \
	X(MEETING_POSES)      /* manifolds of fast pairs are computed at the poses where they meet */ \
	X(TRAPEZOID)          /* second-order drift of positions */ \
	X(FLIGHT)             /* free bodies take the whole step at once */ \
	X(EXACT_SPRINGS)      /* springs with the true period and decay */ \
	X(MEAN_STEP)          /* stiffness tied to the mean step */ \
	X(HARDENING)          /* contacts harden with depth */ \
	X(EARLY_REST)         /* early rest: islands at rest take one substep */ \
	X(MANIFOLD_REUSE)     /* manifold reuse: contacts that hardly moved are updated in their lanes */ \
	X(CULLING)            /* culling of separated pairs, four at a time */ \
	X(FAT_BOXES)          /* fat boxes with margins by size, extended along free flight */ \
	X(JOINT_LANES)        /* joints side by side in lanes */ \
	X(KEPT_LANES)         /* ... in the lanes of the last step */ \
	X(BODY_KERNELS)       /* bodies side by side in integration and finalize */ \
	X(MANIFOLD_BATCHES)   /* manifolds of polygons, capsules and edges side by side */ \
	X(KEPT_PLANS)         /* plans of systems are kept from step to step */ \
	X(SWEEP)              /* the tiled sweep; without it the tree */

#define CNI_MECHANISM_ENTRY(name) CNI_MECHANISM_##name,
enum { CNI_MECHANISMS(CNI_MECHANISM_ENTRY) CNI_MECHANISM_COUNT };
#undef CNI_MECHANISM_ENTRY

#ifdef CNI_ABLATION
extern uint64_t cni_ablation_off; /* bits; written before the first step and never while a step runs */
#define CNI_ON(name) ((cni_ablation_off >> CNI_MECHANISM_##name & 1u) == 0)
#elif defined CN_PLAIN_STEP /* without those that a small world can do without: examples/embedded/README.md */
#define CNI_MECHANISM_BIT(name) (UINT64_C(1) << CNI_MECHANISM_##name)
#define CNI_NOT_PLAIN \
	(CNI_MECHANISM_BIT(ANGULAR_MOMENTUM) | CNI_MECHANISM_BIT(SEAMS) | CNI_MECHANISM_BIT(SPECULATIVE_MISSES) | CNI_MECHANISM_BIT(MEETING_POSES) | \
	 CNI_MECHANISM_BIT(EARLY_REST) | CNI_MECHANISM_BIT(MANIFOLD_REUSE) | CNI_MECHANISM_BIT(CULLING) | CNI_MECHANISM_BIT(OVERLAP_PROJECTION))
#define CNI_ON(name) ((CNI_NOT_PLAIN & CNI_MECHANISM_BIT(name)) == 0)
#else
#define CNI_ON(name) 1
#endif

#endif
