/*
 * model/solve.h - what the stages of the soft step share: the numbers of one step and one function a
 * stage. The method is TGS soft (Catto, "Solver2D", 2024; Macklin et al., "Small Steps", 2019) with
 * stiffness tied to the substep rate: contacts 1/(8h), joints 1/(4h).
 *
 * Data flow of the substeps, over dense arrays and blocks only:
 *
 *   drive --integrate_velocities--> start, motion.v          v = start + response of the last impulses
 *   block.jn, joint.impulse --warm start (first substep)--> motion.v
 *   motion --impacts--> motion.v, start                      contacts that bounce
 *   motion, block --solve--> motion.v, block.jn jt           soft, pushes overlap apart
 *   motion --direct_close--> motion.v, impulses              joints that contacts would part, and those contacts
 *   motion.v --integrate_positions--> motion.dp theta
 *   motion, block --relax--> motion.v, block.jn jt           rigid, takes the pushing out again
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
	float load_part;     /* of its way to the impulse that a load goes in this step */
	float load_heavy;    /* ... at most this over the square of the speed that the impulse gives: see CNI_LOAD_HEAVY */
	cni_soft soft;
	int32_t one_sided;   /* lane bodies b are not written */
} cni_contact_pass;

/* Kinds of blocks, as bits. */
enum {
	CNI_CONTACTS_RESTED = 1,    /* time passes more slowly for them: loads follow in its measure */
	CNI_CONTACTS_ONE_SIDED = 2, /* lane body b cannot move */
	CNI_CONTACTS_KINDS = 4
};

/*
 * How fast loads follow the impulses that are there, per second; see contacts/contact_kernel.h. A load that follows drives
 * slow swings of a pile, and softness damps them: by a rate of about 0.24 s w^2 at h = 1/240 s, with w^2 falling as
 * the square of the height. So a load must be slower where more is borne: at most
 * CNI_LOAD_HEAVY / (h stress^2), where stress is what a point bears over the lighter body's weight. A pyramid of base 100
 * (stress 25) comes to rest at 0.1, sways on at 0.3, and falls when all its loads follow at 0.6 per second.
 *
 * Between settled bodies they do not rise: in a heap of mixed shapes not every overlap can be taken away, loads that went on rising
 * would press what is wedged until it slips, and 50 bodies crept at 0.7 mm/s for ever, at any of these rates.
 */
#define CNI_LOAD_RATE 0.6f
#define CNI_LOAD_HEAVY 0.1f

struct cni_contact_kernel; /* contacts/contact_pass.h */
struct cni_joint_kernel;   /* joints/joint_pass.h */
struct cni_body_kernel;    /* step/integrate_pass.h */

/* v' = (v + h a) times this: v' = a - damping v taken implicitly, so that the speed that a fall tends to is exact. */
static inline float cni_damping_factor(float damping, float h)
{
	return 1.0f / (1.0f + damping * h);
}

typedef struct cni_solve {
	float dt, h, inv_h;
	float mean_dt;             /* of the steps so far, this one included */
	float soft_rate;           /* 1/s: that softness is tied to; 1 / h where all steps are equal */
	int32_t substeps;
	float warm_scale;          /* of stored impulses: this substep over the last one's */
	float push_speed;
	float restitution_threshold;
	float shock_speed;         /* a jump of a body's velocity in one substep that is an impact */
	cni_contact_pass contact[CNI_CONTACTS_KINDS];
	cni_soft joint;
	const struct cni_contact_kernel *kernel;
	const struct cni_joint_kernel *joint_kernel;
	const struct cni_body_kernel *body_kernel; /* NULL: bodies one by one */
	struct cni_sparse *direct; /* joints that are solved directly, NULL: none */
	int32_t bounces;           /* some contact has restitution */
	uint32_t contact_colors;   /* those that have contacts, as bits */
	int32_t lanes;             /* contacts of all colours */
	cni_team *team;            /* who share the loops of the substeps, NULL: not worth it */
} cni_solve;

cni_solve cni_solve_make(const cn_world *world, float dt);
/* One substep, nothing kept from the last step. */
cni_solve cni_solve_make_sequential(const cn_world *world, float dt);
/* Implicit-Euler soft constraint (Catto, "Soft Constraints", GDC 2011). */
cni_soft cni_soft_implicit(float hertz, float damping_ratio, float h);
/* Exact discrete spring: a single body on it keeps the true period and decay at any stiffness. */
cni_soft cni_soft_exact(float hertz, float damping_ratio, float h);

/* Stage 2: new pairs become contacts. Writes contacts, proxies' lists, warnings. */
void cni_stage_pairs(cn_world *world, float dt);
/* After stage 2: hidden corners between fixed shapes, where such shapes changed. Writes their geometry. */
void cni_stage_seams(cn_world *world);
/* What of stage 3 needs no manifold: lanes whose bodies have hardly moved are brought up to date. The contacts of all
   others go to left, which has room for every lane; returns how many. dt 0: none is followed. */
int32_t cni_contacts_follow(cn_world *world, float dt, int32_t *left);
/* Stage 3 and 4: manifolds into lanes; begins and ends of touching, ended pairs. Writes contacts,
   lanes, islands, events. */
void cni_stage_narrowphase(cn_world *world, float dt);

/* Stage 6. */
void cni_drive_prepare(cn_world *world, const cni_solve *s);           /* drive; free bodies' whole step */
void cni_drive_finish(cn_world *world);                                /* ... before islands may change: their dense array is no more */
void cni_drive_prepare_bound(cn_world *world);                         /* drive of all bodies, none taken as free */
void cni_integrate_velocities(cn_world *world, const cni_solve *s, int32_t substep);
void cni_integrate_positions(cn_world *world, const cni_solve *s);
void cni_integrate_finish(cn_world *world, const cni_solve *s);
/* The blocks of all colours, for the passes of this step; after the narrowphase. Sets s->bounces, contact_colors and lanes. */
void cni_contacts_list(cn_world *world, cni_solve *s);
void cni_contacts_warm_start(cn_world *world, const cni_solve *s);
void cni_contacts_solve(cn_world *world, const cni_solve *s);
void cni_contacts_relax(cn_world *world, const cni_solve *s);
/* One contact of them, in a pass that has been: by its slot. */
void cni_contact_solve_again(cn_world *world, const cni_solve *s, int32_t slot);
/* Joints of bodies whose velocity jumped in this substep go on from their loads: step/velocity_jumps.c. */
void cni_shocks_forget(cn_world *world, const cni_solve *s);
/* Marks such bodies, and returns how many there are. */
uint32_t cni_shocks_mark(cn_world *world, const cni_solve *s);
/* After the first substep: what stands is done with for this step: step/early_rest.c. */
void cni_rest_find(cn_world *world, const cni_solve *s);
/* After the substeps: gives what nothing holds its angular momentum back: step/angular_momentum.c. */
void cni_spin_hold(cn_world *world);
void cni_contacts_impact(cn_world *world, const cni_solve *s);
void cni_joints_prepare(cn_world *world, const cni_solve *s);
/* Those that are solved wide into their lanes, once it is known which are solved directly. */
void cni_joint_blocks_gather(cn_world *world, const cni_solve *s);
void cni_joints_warm_start(cn_world *world, const cni_solve *s);
void cni_joints_solve(cn_world *world, const cni_solve *s);
/* Stage 5: which islands are solved directly, contacts and all. */
void cni_stage_tiers(cn_world *world, float h);
/* An overlap or gap of more than this part of the accuracy is bad. */
#define CNI_BAD_PART 0.1f
/* Does the lighter of two bodies bear more than a part of what soft contacts can, with this impulse between them in a
   substep h? Such contacts are not left to the soft solver, which would crush them. direct/solver_selection.c. */
int32_t cni_is_stressed(const cn_world *world, int32_t ia, int32_t ib, float impulse, float h, float part);
/* Neither moves nor turns faster than what lies in a pile. */
int32_t cni_body_is_quiet(const cn_world *world, const cni_body *b);
int32_t cni_island_is_quiet(const cn_world *world, const cni_island *i);
int32_t cni_island_has_joints(const cn_world *world, int32_t island);
/* The island cannot be solved directly, now and for some time. reason: CN_TIER_REASON_ */
void cni_island_refuse(cn_world *world, int32_t island, int32_t reason);
/* Has it been refused so lately that it is left alone in the step of this count? */
int32_t cni_island_is_refused(const cni_island *i, uint32_t step);
/* Is it soft in that step because no solution was found for it? */
int32_t cni_island_is_unsolved(const cni_island *i, uint32_t step);
/* No island is solved directly any more: the solver changed. */
void cni_tiers_forget(cn_world *world);
/* Scratch that lanes of joints which are not pins may take. */
uint64_t cni_row_bytes(int32_t joints);
/* Scratch that directly solving so many joints and contacts may take. */
uint64_t cni_direct_bytes(int32_t solver, int32_t joints, int32_t contacts, int32_t bodies);
/* ... and what of it is kept from step to step. */
uint64_t cni_direct_kept_bytes(int32_t solver, int32_t joints, int32_t contacts);
/* Loads of piles that are too large for that, and their impulses when they are new. Before the warm start. */
void cni_piles_load(cn_world *world, const cni_solve *s);
/* Is every body of a quiet island held by what is below it? Else things lean on each other. */
int32_t cni_pile_stands(cn_world *world, int32_t island, float h);
/* Scratch that either may take. */
uint64_t cni_pile_bytes(int32_t bodies);
/* Plans which joints and contacts are solved directly into out, and sets s->direct to it. */
void cni_direct_prepare(cn_world *world, cni_solve *s, struct cni_sparse *out);
/* One pass over them: with errors' bias (1), or rigid at the new positions (0). */
void cni_direct_solve(cn_world *world, const cni_solve *s, int32_t bias);
/* After the contacts: joints that they would part in this substep once more. */
void cni_direct_close(cn_world *world, const cni_solve *s);
/* Gives its contacts back to their lanes. */
void cni_direct_store(cn_world *world, const cni_solve *s);
/* The whole step of bodies that nothing but joints holds. */
void cni_swings_run(cn_world *world, const cni_solve *s);
/* Constraints on single bodies (1) or joints between bodies (0), from no impulse: sequential solver. */
void cni_joints_solve_fresh(cn_world *world, const cni_solve *s, int32_t constraints);
void cni_joints_relax(cn_world *world, const cni_solve *s);
void cni_joints_store(cn_world *world, const cni_solve *s);
/* After finalize: reports joints that were stressed beyond their threshold, and destroys those that break. */
void cni_joints_break(cn_world *world);

/* Stage 8, first part: shortens the changes of fast bodies that would pass through things. Before any box moves. */
void cni_stage_continuous(cn_world *world);
/* Stage 8: poses, boxes, speed limits, rest timers. Returns 1 when some body has rested long enough to sleep. */
int32_t cni_stage_finalize(cn_world *world, const cni_solve *s);
/* The part of it that moves bodies by their change, and the boxes after them: sequential solver. */
void cni_poses_take(cn_world *world);
/* Stage 9: calls the user's callbacks. */
void cni_stage_events(cn_world *world);
/* Stage 10. */
void cni_stage_sleep(cn_world *world);

#endif
