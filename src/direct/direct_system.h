/*
 * direct/direct_system.h - the private interface between the files of direct/: components of directly solved joints, their motors and
 * limits, batches of equal trees, geometric stiffness.
 */
#ifndef CNI_DIRECT_DIRECT_SYSTEM_H
#define CNI_DIRECT_DIRECT_SYSTEM_H

#include "direct/direct.h"
#include "joints/joint_pass.h"

/* ---- components of joints that are solved directly: direct/component.c ---- */

/* Plans the components of this step and flags their joint constraints. 0: no scratch memory, no joint is flagged. direct/direct_plan.c */
int32_t cni_direct_plan(cn_world *world, cni_sparse *out);
/* Reads the nodes' levers from the rows of their joint constraints and factors the system. */
void cni_direct_refresh(cn_world *world, cni_sparse *sparse, const cni_component *c);
/* Number of its joints that end at a body without mass. */
int32_t cni_component_held(const cn_world *world, const cni_sparse *sparse, const cni_component *c);
/* 1: one joint of a body with the world. */
static inline int32_t cni_component_is_single(const cni_component *c)
{
	return !c->has_contacts && c->end - c->begin == 1 && c->body_end - c->body_begin == 1;
}
/* 1: fixed bodies hold it at more than one joint (held: cni_component_held), and its loops have few bodies each: a short bridge, a truss. For
   components without contacts. */
int32_t cni_component_is_braced(const cni_component *c, int32_t held);
/* 1: one row of parts between two fixed ends. */
static inline int32_t cni_component_is_row(const cni_component *c, int32_t held)
{
	return held == 2 && c->end - c->begin == c->body_end - c->body_begin + 1;
}
/* Returns the joints of the component to the soft solver for this step. */
void cni_component_release(cn_world *world, cni_sparse *sparse, cni_component *c);
/* ... and for `span` steps; 0: for a span that doubles with each failure. */
void cni_component_suspend(cn_world *world, cni_sparse *sparse, cni_component *c, int32_t span);
/* Closing speeds of the node's rows by the motion of bodies that cannot be moved alone. */
static inline cni_four cni_node_base_speed(const cni_node *n, const cni_motion *motions)
{
	const cni_motion still = { 0 }, *a = motions + n->ia, *b = motions + n->ib;
	return cni_levers_speed(&n->levers, cni_motion_can_move(a) ? &still : a, cni_motion_can_move(b) ? &still : b);
}
/* Right sides that answer to these speeds, into its nodes' x. Returns the greatest. */
float cni_component_bases_ask(const cn_world *world, cni_sparse *sparse, const cni_component *c);
/* 1: a loop that is so nearly straight between moving ends that some of its bodies would have to be far faster than these. */
int32_t cni_component_is_pulled(cn_world *world, const cni_solve *s, cni_sparse *sparse, const cni_component *c);
/* Velocity of the second body's anchor seen from the first's. */
static inline cni_vec2 cni_joint_velocity_apart(const cn_world *world, const cni_joint_constraint *w)
{
	const cni_motion *a = cni_motions(world) + w->ia, *b = cni_motions(world) + w->ib;
	cni_vec2 ra = w->start.ra, rb = w->start.rb;
	return cni_v(b->vx - b->w * rb.y - a->vx + a->w * ra.y, b->vy + b->w * rb.x - a->vy - a->w * ra.x);
}
/* Builds the rows of its joints that have none yet. */
void cni_component_rows_need(cn_world *world, const cni_solve *s, const cni_sparse *sparse, const cni_component *c);
/* 1: only the component's rigid joints constrain its bodies in this step. */
int32_t cni_component_uses_rattle(cn_world *world, const cni_solve *s, const cni_sparse *sparse, const cni_component *c);
/* Levers, dampers and factors of a component for the world's substeps. */
void cni_direct_begin(cn_world *world, const cni_solve *s, cni_sparse *sparse, cni_component *c);
/* Copies velocities and positions of the component's bodies into sparse->saved (restore 0), or back (1). */
void cni_direct_motions_save(const cn_world *world, const cni_sparse *sparse, const cni_component *c, int32_t restore);
/* Computes the rotations of the component's bodies since the step began. */
void cni_direct_rotations(const cn_world *world, cni_sparse *sparse, const cni_component *c);

/* Right sides: the missing speeds of the component's rows, with error correction (bias 1) or without, into its nodes' x. */
void cni_direct_right_sides(cn_world *world, const cni_solve *s, const cni_component *c, int32_t bias);
/* Adds the impulses x of a joint's node to the rows from which its levers were read. */
static inline void cni_node_impulses_add(const cni_node *n, cni_row *rows, const float *x)
{
	for (int32_t i = 0; i < n->rows; ++i)
		rows[i].impulse += x[i];
	if (n->share[0] != 0.0f || n->share[1] != 0.0f)
		rows[n->rows - 1].impulse += n->share[0] * x[0] + n->share[1] * x[1];
}
/* Twice the kinetic energy of a body at this velocity. */
static inline float cni_energy_twice(const cni_motion *m, float vx, float vy, float w)
{
	return cni_inverse_or_zero(m->inv_mass) * (vx * vx + vy * vy) + cni_inverse_or_zero(m->inv_inertia) * w * w;
}
/* The mass of its bodies that can move. */
float cni_component_mass(const cn_world *world, const cni_sparse *sparse, const cni_component *c);
/* Solves for the impulses and applies them; on failure the joints become soft by cni_component_give_up. */
void cni_component_solve(cn_world *world, const cni_solve *s, cni_component *c, int32_t bias);
/* What a component failed at in a loop that workers share: solutions of its joints, or through them those of contacts alone. */
enum { CNI_FAILED_JOINTS = 1, CNI_FAILED_CONTACTS = 2 };
/* Takes the warm start of its joints back where it would bring far more energy than there is. */
void cni_component_start(cn_world *world, cni_sparse *sparse, const cni_component *c);
/* After the loop: the joints of a component that failed are soft. */
void cni_component_give_up(cn_world *world, cni_sparse *sparse, cni_component *c);

/* ---- what becomes of them: direct/component_fate.c ---- */

/* Soft for a span that doubles with each failure, or for the longest one; soft without impulses; left to the soft solver, as there is no body; RATTLE; the
   passes of a substep. */
enum { CNI_FATE_SOFT, CNI_FATE_SOFT_LONG, CNI_FATE_WITHOUT_IMPULSES, CNI_FATE_RELEASED, CNI_FATE_RATTLE, CNI_FATE_PASSES };

/* Sets the fate of each component that is not done, and whether batches may take it. Workers of the team share the loop. */
void cni_components_judge(cn_world *world, const cni_solve *s, cni_team *team);

/* ---- loops over components: direct/component_loop.c ---- */

typedef void cni_component_fn(cn_world *world, const cni_solve *s, cni_component *c, int32_t argument);
/* Lists those that are solved alone in this step. */
void cni_components_list(cni_sparse *sparse);
/* Calls fn for each of them. fn writes what belongs to the component alone, and `pending` where something is left to do after the loop. */
void cni_components_run(cn_world *world, const cni_solve *s, cni_team *team, cni_component_fn *fn, int32_t argument);
/* cni_component_give_up of each of them. */
void cni_components_give_up(cn_world *world, const cni_solve *s);

static inline void cni_trust_suspend(cn_world *world, cni_joint_trust *t, int32_t span, int32_t soft)
{
	t->span = (uint16_t)span;
	t->until = world->step_count + t->span;
	t->soft = (uint8_t)soft;
	if (soft && t->until > world->joints_soft_step)
		world->joints_soft_step = t->until;
}
static inline void cni_trust_fail(cn_world *world, cni_joint_trust *t, int32_t soft)
{
	int32_t lately = t->span > 0 && (int32_t)(world->step_count - t->until) < CNI_TRUST_MOST;
	cni_trust_suspend(world, t, !CNI_ON(RETRY_DELAY) ? 1 : lately ? cni_min_i(2 * t->span, CNI_TRUST_MOST) : CNI_TRUST_LEAST, soft);
}
/* Part of an impulse between two bodies with which the soft solver may start: cni_soft_speed_most. */
float cni_direct_soft_part(const cn_world *world, float impulse, int32_t ia, int32_t ib);
/* Solves the right sides and applies the impulses; solutions of systems with loops are checked. 0: no acceptable solution; nothing is
   changed. */
int32_t cni_direct_apply(cn_world *world, cni_sparse *sparse, cni_component *c);
/* Levers, dampers and factors at the bodies' present rotations. */
void cni_direct_system(cn_world *world, const cni_solve *s, cni_sparse *sparse, cni_component *c);
/* 1: no body of it moves in the frame of its island faster than CNI_HEAVY_SLOW_SPEED. */
int32_t cni_component_is_slow(const cn_world *world, const cni_sparse *sparse, const cni_component *c);
/* Lists the components that contacts may open: direct/joint_projection.c. */
void cni_projection_mark(const cn_world *world, cni_sparse *sparse);

/* ---- motors and limits in the system: direct/active_rows.c ---- */

/* Bits of the `active` of a joint's node. */
enum { CNI_ROW_IN_SET = 1u, CNI_ROW_AT_UPPER = 2u };

/* 1: the limit may act in a step of this length. */
static inline int32_t cni_limit_is_near(const cn_world *world, const cni_joint_constraint *w, int32_t row, float dt)
{
	const cni_row *r = &w->rows[row];
	float speed = cni_lever_speed(&r->lever, cni_motions(world) + w->ia, cni_motions(world) + w->ib);
	return r->error < CNI_LIMIT_ROOM * world->settings.length_unit / cni_row_length(world, r) + 2.0f * dt * cni_abs(speed);
}
/* Selects the motor and limit rows; their joint constraints leave the lanes. Returns 0 for none, 1 for limits only, 2 with motors. */
int32_t cni_active_begin(cn_world *world, const cni_solve *s, cni_sparse *sparse, cni_component *c);
/* Clears the third levers of nodes with a motor or limit, before the dampers are set; cni_active_levers sets those in the active set. */
void cni_active_clear(cni_sparse *sparse, const cni_component *c);
/* Asks limits in the set what they bear of a contact's impulse, after its solution of right sides that are the speeds after a push. 0: there are none. */
int32_t cni_active_limits_ask(const cn_world *world, cni_sparse *sparse, const cni_component *c, float impulse);
/* Clears the levers of limits that let go by what was asked, and of motors in the set. 0: there are none. */
int32_t cni_active_leave(const cn_world *world, cni_sparse *sparse, const cni_component *c);
void cni_active_levers(const cn_world *world, const cni_solve *s, cni_sparse *sparse, const cni_component *c);
/* Their right sides, after those of the rigid rows. */
void cni_active_right_sides(const cn_world *world, const cni_solve *s, cni_sparse *sparse, const cni_component *c, int32_t bias);
/* After that: the most that the speed of a rope lacks of its target, or (ropes 0) of any limit. */
float cni_active_limit_missing(const cn_world *world, const cni_sparse *sparse, const cni_component *c, int32_t ropes);
/* Rows beyond their bound leave the set, others return. Returns 1 when the set has changed. */
int32_t cni_active_change(const cn_world *world, const cni_solve *s, cni_sparse *sparse, const cni_component *c, int32_t bias);
/* Adds the solution to the impulses of the rows in the set. */
void cni_active_impulses_add(const cn_world *world, const cni_sparse *sparse, const cni_component *c);

/* ---- batched trees: direct/batched_trees.c ---- */

/*
 * A batch has a tree in each of its lanes, all of one topology class (linear/topology_class.c). Node k of all of them is one block of lanes
 * (joints/joint_pass.h), the batch's k-th, so a pass runs over blocks: springs, motors and limits colour by colour, then the pins of
 * every tree as one system (linear/sparse.h).
 *
 *   nodes     [ block of node 0 | block of node 1 | ... ]      in the order of elimination
 *   pivots    3 rows of lanes a node: 00, 01, 11 of the inverse
 *   blocks    4 rows of lanes a coupling
 *
 * A pass reads and writes each body once. A lane whose bit in `direct` is clear had a system without a solution: its pins are solved one by
 * one.
 */
typedef struct cni_tree_batch {
	struct cni_joint_block *nodes;
	float *pivots, *blocks;
	const cni_coupling *couplings;         /* of the tree in the first lane; its nodes and blocks count from node_first and block_first */
	const int32_t *first, *below;
	int32_t node_first, block_first;
	int32_t coupling_count;
	int32_t lanes;
	int32_t node_begin[CNI_LANES];         /* of the tree in the lane */
	uint32_t selected, opening;            /* lanes, as bits, of trees to check and of trees that open: see cni_projection */
	cni_topology tree;
	uint8_t order[CNI_TOPOLOGY_NODES];         /* nodes by colour */
	uint32_t source[CNI_TOPOLOGY_NODES + 2];   /* by body: byte offset of its index in `nodes`; its inertia: + CNI_SIDE_BYTES */
	int32_t bodies;                        /* including the immovable one, if there is one */
} cni_tree_batch;

typedef struct cni_tree_batch_pass {
	cni_motion *motions;
	cni_velocity_start *starts;
	cni_joint_pass joint;
	float rate, push; /* part of a gap that is closed in a second, and the greatest closing speed */
	float opening_speed; /* largest speed of an opening pin after contacts */
	float turn_least; /* radians a second: slower arms stay on the tangent */
} cni_tree_batch_pass;

typedef void cni_tree_batch_fn(cni_tree_batch *batch, const cni_tree_batch_pass *pass);

/* Passes: factors the systems; warm start; with error correction and rigid; after contacts: solves the lanes of batch->selected again that
   contacts would open, and sets batch->opening (direct/joint_projection.c). */
enum { CNI_TREES_BEGIN, CNI_TREES_WARM, CNI_TREES_SOLVE, CNI_TREES_RELAX, CNI_TREES_PROJECT, CNI_TREES_PASSES };
typedef cni_tree_batch_fn *cni_tree_batch_kernel[CNI_TREES_PASSES];

extern const cni_tree_batch_kernel cni_tree_batch_kernel_plain; /* width 1: any compiler */
extern const cni_tree_batch_kernel cni_tree_batch_kernel_4;     /* SSE2, NEON, WASM SIMD */
extern const cni_tree_batch_kernel cni_tree_batch_kernel_8;     /* AVX2, chosen at run time */

/* Whether the component may join a batch (CNI_BATCHED): it is solved directly, and not by RATTLE. has_heavy: it has contacts of direct/heavy_contacts.c. */
int32_t cni_component_is_batched(const cn_world *world, const cni_solve *s, cni_sparse *sparse, const cni_component *c, int32_t has_heavy);
/* Makes batches of all components whose `batches` is set; components without a batch begin as single ones. */
void cni_tree_batches_make(cn_world *world, const cni_solve *s, cni_team *team);
/* One of these passes over all batches. */
void cni_tree_batches_run(cn_world *world, const cni_solve *s, int32_t pass);
/* CNI_TREES_PROJECT: with bias, or rigid, where pins open faster than that. */
void cni_tree_batches_project(cn_world *world, const cni_solve *s, float opening_speed, int32_t bias);
/* Reads levers, gaps and factors of a batched component from its lane, for direct/heavy_contacts.c; then adds the impulses of the nodes to
   the lane. */
void cni_tree_lane_system(const cni_solve *s, cni_component *c);
void cni_tree_lane_add(const cni_solve *s, const cni_component *c);
/* cni_component_lock of a batched component. */
void cni_tree_lane_lock(cn_world *world, const cni_solve *s, cni_component *c, float turn);
/* Bound on the scratch memory of batches for this number of joints. */
uint64_t cni_tree_batch_bytes(int32_t joints);

/* ---- geometric stiffness: direct/geometric_stiffness.c ---- */

/* sum(r.f) of every body from the impulses of substeps of length h, after cni_direct_rotations. */
void cni_geometric_stiffness_find(const cn_world *world, cni_sparse *sparse, const cni_component *c, float h);
/* The same from the joint records, at the beginning of a step, for pins whose rows are not built yet. */
void cni_geometric_stiffness_find_pins(const cn_world *world, cni_sparse *sparse, const cni_component *c, float h);
/* Geometric stiffness of rods, in squared radians a second. Overwrites the result of cni_geometric_stiffness_find. */
float cni_geometric_stiffness_rods(const cn_world *world, cni_sparse *sparse, const cni_component *c, float h);
/* The largest sum(r.f) / I after cni_geometric_stiffness_find, in squared radians a second. */
float cni_geometric_stiffness_largest(const cn_world *world, const cni_sparse *sparse, const cni_component *c);
/* 1: the stiffness is near or beyond the limit of substeps of length h. */
int32_t cni_geometric_stiffness_needs_dampers(const cn_world *world, const cni_sparse *sparse, const cni_component *c, float h);
/* cni_geometric_stiffness_find, and whether the component has dampers in this step: it then has width 3. */
void cni_geometric_stiffness_begin(const cn_world *world, cni_sparse *sparse, cni_component *c, float h);
/* Sets the damping rows (third rows) of pins in a component that has dampers, before its factorization. */
void cni_geometric_stiffness_damp(const cn_world *world, cni_sparse *sparse, const cni_component *c, float h);

/* 1: a pinned body turns faster than `most`, and than its neighbour by half of that. */
int32_t cni_geometric_stiffness_turns(const cn_world *world, const cni_sparse *sparse, const cni_component *c, float most);
/* Locks the relative rotation of pinned bodies, until the next cni_direct_system, where one of them would turn too far in a substep for
   positions to follow: faster than `most`. Returns 1 when it locked any: the component must be factored again. */
int32_t cni_geometric_stiffness_lock(const cn_world *world, const cni_sparse *sparse, cni_component *c, float most);
/* Locks joints of bodies that would turn farther than this in the substep, and solves the component again if there are any.
   Returns 1 then. */
int32_t cni_component_lock(cn_world *world, const cni_solve *s, cni_component *c, float turn);

#endif
