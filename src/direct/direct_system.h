/*
 * direct/direct_system.h - what the files of direct/ share: components of directly solved joints, their motors and limits, batches of
 * equal trees, geometric stiffness.
 */
#ifndef CNI_DIRECT_DIRECT_SYSTEM_H
#define CNI_DIRECT_DIRECT_SYSTEM_H

#include "direct/direct.h"
#include "joints/joint_constraint.h"

/* ---- components of joints that are solved directly: direct/component.c ---- */

/* What is solved directly in this step; the works that are know it. 0: no scratch memory. direct/direct_plan.c */
int32_t cni_direct_plan(cn_world *world, const cni_solve *s, cni_sparse *out);
/* The nodes' levers from their works' rows, and the factors of it. */
void cni_direct_refresh(cn_world *world, cni_sparse *sparse, const cni_component *c);
/* Scratch that planning may take. direct/direct_plan.c */
uint64_t cni_direct_plan_bytes(int32_t solver, int32_t joints, int32_t contacts, int32_t bodies);
/* Each joint of it by itself after all, in this step. */
void cni_component_release(cn_world *world, cni_sparse *sparse, cni_component *c);
/* ... and for some time: `span` steps, or, 0, longer each time it happens. */
void cni_component_leave(cn_world *world, cni_sparse *sparse, cni_component *c, int32_t span);
/* Is the component held by its rigid joints alone in this step? */
int32_t cni_component_uses_rattle(const cn_world *world, const cni_solve *s, const cni_sparse *sparse, const cni_component *c);
/* Levers, dampers and factors of a component for the world's substeps. */
void cni_direct_begin(cn_world *world, const cni_solve *s, cni_sparse *sparse, cni_component *c);
/* Velocities and positions of the component's bodies into sparse->saved, or back (1). */
void cni_direct_motions_keep(const cn_world *world, const cni_sparse *sparse, const cni_component *c, int32_t back);
/* Rotations of the component's bodies since the step began. */
void cni_direct_turns(const cn_world *world, cni_sparse *sparse, const cni_component *c);

/* What the component's rows lack, with errors' bias (1) or without, into its nodes' x. */
void cni_direct_sides(cn_world *world, const cni_solve *s, const cni_component *c, int32_t bias);
/* From there to impulses; or its joints are solved by themselves from now on. direct/active_set.c */
void cni_direct_answer(cn_world *world, const cni_solve *s, cni_component *c);
/* What failed is not tried again for a time that doubles when it fails again soon. Of a joint, or what joints have in common. */
#define CNI_TRUST_LEAST 2      /* steps */
#define CNI_TRUST_MOST 256
static inline void cni_trust_leave(cni_joint_trust *t, uint32_t step, int32_t span, int32_t soft)
{
	t->span = (uint16_t)span;
	t->until = step + t->span;
	t->soft = (uint16_t)soft;
}
static inline void cni_trust_fail(cni_joint_trust *t, uint32_t step, int32_t soft)
{
	int32_t lately = t->span > 0 && (int32_t)(step - t->until) < CNI_TRUST_MOST;
	cni_trust_leave(t, step, !CNI_ON(TRUST) ? 1 : lately ? cni_min_i(2 * t->span, CNI_TRUST_MOST) : CNI_TRUST_LEAST, soft);
}
/* Right sides to impulses; a system that says much twice is checked. 0: there is no good solution, and nothing was done. */
int32_t cni_direct_apply(cn_world *world, cni_sparse *sparse, cni_component *c);
/* Levers, dampers and factors, at the bodies' present turns. */
void cni_direct_system(cn_world *world, const cni_solve *s, cni_sparse *sparse, cni_component *c);
/* Joints that contacts would open by more than this part of the accuracy in a substep are closed before positions move,
   also for arms that turn by more than this angle in it and so leave the tangent. */
#define CNI_PROJECTION_PART CNI_BAD_PART
#define CNI_PROJECTION_TURN_RAD 0.02f
/* A body that turns by more than this in a substep may have to be locked to its neighbours: cni_geometric_stiffness_lock. */
#define CNI_SNAP_RAD 0.1f
/* What contacts may part: direct/joint_projection.c. */
void cni_projection_mark(const cn_world *world, cni_sparse *sparse);

/* ---- motors and limits in the system: direct/active_rows.c ---- */

/* bits of a node's held */
enum { CNI_ROW_IN_SET = 1u, CNI_ROW_AT_UPPER = 2u };

/* The motor or limit that is the third row of a node, NULL: none. */
static inline cni_row *cni_active_row(const cn_world *world, const cni_node *n)
{
	cni_joint_constraint *w = n->owner >= 0 ? &cni_joint_constraints(world)[n->owner] : NULL;
	return w != NULL && w->inner > 0 ? &w->rows[w->inner] : NULL;
}
static inline float cni_active_impulse_most(const cni_row *r, const cni_solve *s)
{
	return r->kind == CNI_ROW_MOTOR ? r->limit * s->h : FLT_MAX;
}
/* Chooses which; their works are solved by rows. Returns 1 when there are any, 2: motors among them. */
int32_t cni_active_begin(cn_world *world, const cni_solve *s, cni_sparse *sparse, const cni_component *c);
/* No third levers of nodes with a motor or limit, before dampers; then those of which it is in the set. */
void cni_active_clear(const cn_world *world, cni_sparse *sparse, const cni_component *c);
void cni_active_levers(const cn_world *world, cni_sparse *sparse, const cni_component *c);
/* Their right sides, after the others'. */
void cni_active_sides(const cn_world *world, const cni_solve *s, cni_sparse *sparse, const cni_component *c, int32_t bias);
/* From right sides to impulses. 0: not finite. */
int32_t cni_active_answer(cn_world *world, const cni_solve *s, cni_sparse *sparse, cni_component *c);

/* ---- trees that are alike: direct/batched_trees.c ---- */

/* Can the component be one of a batch? It is solved directly, and does not swing. */
int32_t cni_component_is_batched(const cn_world *world, const cni_solve *s, cni_sparse *sparse, const cni_component *c);
/* Herds of all that `batches` says so of; those that remain alone are begun by themselves. */
void cni_tree_batches_make(cn_world *world, const cni_solve *s, cni_sparse *sparse);
void cni_tree_batches_warm(cn_world *world, const cni_solve *s);
void cni_tree_batches_solve(cn_world *world, const cni_solve *s);
void cni_tree_batches_relax(cn_world *world, const cni_solve *s);
/* After contacts: what they would part is solved once more. direct/joint_projection.c */
void cni_tree_batches_close(cn_world *world, const cni_solve *s);
/* Scratch that they may take, with so many joints. */
uint64_t cni_tree_batch_bytes(int32_t joints);

/* ---- tension: direct/geometric_stiffness.c ---- */

/* sum(r.f) of every body, after cni_direct_turns, from impulses of substeps of length h. */
void cni_geometric_stiffness_find(const cn_world *world, cni_sparse *sparse, const cni_component *c, float h);
/* The same of pins that have no rows yet, at the beginning of a step. */
void cni_geometric_stiffness_find_pins(const cn_world *world, cni_sparse *sparse, const cni_component *c, float h);
/* The same stiffness of rods, which turn: squared radians a second. Writes over what cni_geometric_stiffness_find found. */
float cni_geometric_stiffness_rods(const cn_world *world, cni_sparse *sparse, const cni_component *c, float h);
/* The largest sum(r.f) / I, after cni_geometric_stiffness_find: squared radians a second. */
float cni_geometric_stiffness_stiffness(const cn_world *world, const cni_sparse *sparse, const cni_component *c);
/* Is that too stiff for substeps of length h, or nearly? */
int32_t cni_geometric_stiffness_needs_dampers(const cn_world *world, const cni_sparse *sparse, const cni_component *c, float h);
/* Sets the third rows of pins in a component of width 3, before its factorization. */
void cni_geometric_stiffness_damp(const cn_world *world, cni_sparse *sparse, const cni_component *c, float h);

/* x of every node to its bodies' velocities and its rows' impulses. */
void cni_direct_push(cn_world *world, const cni_sparse *sparse, const cni_component *c);
/* Makes pins rigid until the next turn of the component, between bodies of which one would turn so far in a substep of length h
   that positions do not follow. Returns 1 when there are any: it must be factored again. */
int32_t cni_geometric_stiffness_lock(const cn_world *world, const cni_sparse *sparse, cni_component *c, float h);

#endif
