/*
 * contacts/contacts.h - interface of the folder: the soft contact solver, restitution, gravity preload, quiet and stressed
 * piles.
 */
#ifndef CNI_CONTACTS_CONTACTS_H
#define CNI_CONTACTS_CONTACTS_H

#include "model/solve.h"

/* Lists the blocks of all colours for the passes of this step. Runs after the narrowphase. Sets s->bounces, sums, contact_colors and
   lanes. */
void cni_contacts_list(cn_world *world, cni_solve *s);
/* Passes over the listed contacts: warm start, soft, rigid, and soft for marked lanes only, which clears the marks. */
enum { CNI_PASS_WARM, CNI_PASS_SOLVE, CNI_PASS_RELAX, CNI_PASS_AGAIN, CNI_PASSES };
void cni_contacts_pass(cn_world *world, const cni_solve *s, int32_t which);
void cni_contacts_impact(cn_world *world, const cni_solve *s);
/* Impulses of a step, for contacts that report them. Makes world.sums if some contact does. */
void cni_impulse_sums_make(cn_world *world);
/* At the beginning of a substep, after integration: closing speeds. At its end: impulses. Nothing without sums. */
void cni_impulse_sums_open(cn_world *world, const cni_solve *s);
void cni_impulse_sums_close(cn_world *world, const cni_solve *s);
/* Takes the impulses of a contact in a substep that are not in its lane: of its points, and of friction. */
void cni_impulse_sums_take(cn_world *world, int32_t contact, float first, float second, float friction);
/* Takes an impact: impulses, and how fast the points that met closed. */
void cni_impulse_sums_strike(cn_world *world, int32_t contact, float normal, float friction, float first_closing, float second_closing);
/* At the end of a step, after finalize: logs STAY and HIT, completes the log of ENTER. */
void cni_impulse_sums_report(cn_world *world);
/* Sets impulses and loads of new piles that are too large for the direct solver. Runs before the warm start. */
void cni_gravity_preload(cn_world *world, const cni_solve *s);
/* 1: without a locked axis, a conveyor or, where a single point may roll, rolling resistance. */
int32_t cni_lane_is_plain(const cn_world *world, int32_t block, int32_t l);
/* Returns 1 if every body of a quiet island is held by bodies below it, 0 if bodies lean on each other or bear far from the middle of their
   supports. */
int32_t cni_pile_is_supported(cn_world *world, int32_t island, float h);
/* Bytes of frame memory that cni_gravity_preload or cni_pile_is_supported may take. */
uint64_t cni_gravity_preload_bytes(int32_t bodies);
/* Does this impulse, in a substep h, load the lighter of two bodies by more than a part of what soft contacts can bear? The soft solver
   would crush such a contact: direct/solver_selection.c solves it directly. */
int32_t cni_is_stressed(const cn_world *world, int32_t ia, int32_t ib, float impulse, float h, float part);
/* Velocity of what carries the island as it was when first asked in this step: of a kinematic body that its bodies touch or are jointed to,
   that hardly turns, and with which they move; zero if there is none. In this frame a pile on a lift is at rest. */
cni_vec2 cni_island_frame(const cn_world *world, cni_island *i);
/* Do the awake island's bodies move in its frame, and their farthest points turn, at this speed at most? */
int32_t cni_island_is_slower(const cn_world *world, cni_island *i, float most);
/* Does the centre of an awake body move in this frame no faster than that of one that may sleep? */
static inline int32_t cni_motion_is_slow(const cn_world *world, int32_t index, cni_vec2 frame)
{
	const cni_motion *m = cni_motions(world) + index;
	return cni_sq(m->vx - frame.x) + cni_sq(m->vy - frame.y) <= cni_sq(world->settings.sleep_speed);
}
/* Do the awake island's bodies move in its frame no faster than bodies in a pile do? */
int32_t cni_island_is_quiet(const cn_world *world, cni_island *i);
/* The same of a body without an island. */
int32_t cni_body_is_quiet(const cn_world *world, const cni_body *b);
/* Has the awake body a joint that is solved in this step? After cni_external_prepare. */
int32_t cni_body_is_jointed(const cn_world *world, const cni_body *b);
int32_t cni_island_has_joints(const cn_world *world, int32_t island);

#endif
