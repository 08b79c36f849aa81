/*
 * model/island.h - islands: groups of dynamic bodies connected by touching contacts and joints, persistent across steps. An
 * island sleeps as a whole.
 *
 * A single body has no island record (island == CNI_NONE). Linking two bodies relabels the smaller island into the larger.
 * Unlinking only counts a loss; an island with losses is split by a search over contacts and joints when it would otherwise fall
 * asleep, at most one island a step (Catto, "Simulation Islands", 2023, with relabelling in place of union-find).
 */
#ifndef CNI_MODEL_ISLAND_H
#define CNI_MODEL_ISLAND_H

#include "base/config.h"
#include "cairn.h"

typedef struct cni_island {
	int32_t first, last;   /* bodies, linked by island_next/prev; first == CNI_NONE: free record */
	int32_t count;
	int32_t losses;        /* links removed since its creation or last split */
	int32_t awake;         /* 1: its bodies are in the dense arrays */
	int32_t next_free;
	float rest_time;       /* scratch of the sleep stage: least sleep_time of its bodies ... */
	uint32_t rest_step;    /* ... found in this step + 1 */
	int32_t movers;        /* ... and the number of those that have not long rested */
	int32_t number;        /* its number in this step, if numbered */
	uint32_t numbered_step; /* step + 1 of its last numbering */
	uint32_t limited_step; /* step + 1 in which model/let_go.c last limited its impulses */
	int32_t tier;          /* CNI_TIER_; from here on state of direct/solver_selection.c */
	int32_t good_steps;    /* directly solved steps since the last bad one */
	int32_t stay_steps;    /* good steps required before the soft solver takes it back, 0: the minimum */
	uint32_t given_step;   /* step of its last return to the soft solver with exact impulses; 0: none, or they were limited since */
	uint32_t looked_step;  /* step + 1 in which it was last found in need of direct solving */
	uint32_t asked_step;   /* step + 1 in which it was last quiet and in need of direct solving ... */
	int32_t asked_steps;   /* ... and the number of consecutive steps */
	uint32_t refused_step; /* step in which direct solving failed */
	int32_t refused_steps; /* steps for which that counts, 0: never refused */
	int32_t reason;        /* CN_TIER_REASON_ of its tier; of a soft island: why it was not selected when it last needed direct solving */
	uint16_t solver;       /* in the last step: CN_SOLVER_SOFT if a body requests it, else CN_SOLVER_DIRECT if one does */
	uint16_t joints_solver; /* likewise: CN_SOLVER_DIRECT if a joint requests it */
	uint32_t new_step;     /* step + 1 in which a contact last got its first load */
	int32_t new_contacts;  /* number of such contacts then */
	uint32_t unheld_step;  /* step + 1 of its last failed gravity preload */
	uint32_t cone_step;    /* step + 1 of the last direct solution of its contacts by direct/friction_cones.c, or from its result */
	int32_t cone_spent;    /* work per contact spent by that solver; it decays with every step: CNI_CONE_REFILL */
	uint32_t cone_paid_step; /* step of that value */
	uint32_t gives_step;   /* step + 1 in which, solved directly, it last moved at a contact */
	uint32_t projected_step; /* step + 1 in which its overlaps were last projected (step/overlap_projection.c) ... */
	int32_t projected_steps; /* ... and the number of such steps */
	int32_t falls_steps;   /* ... and the number of consecutive steps in which it moved so fast that it falls */
	uint32_t frame_step;   /* step + 1 of ... */
	cni_vec2 frame;        /* ... cni_island_frame */
} cni_island;

enum { CNI_TIER_SOFT = CN_TIER_SOFT, CNI_TIER_DIRECT = CN_TIER_DIRECT };

/* Joins the islands of two dynamic bodies; wakes the sleeping side if the other is awake. After cni_island_reserve(world, 1). */
void cni_island_link(cn_world *world, int32_t body_a, int32_t body_b);
/* Counts one removed link of the body's island. */
void cni_island_unlink(cn_world *world, int32_t body);
/* Removes a body from its island (when destroyed or no longer dynamic). */
void cni_island_remove_body(cn_world *world, int32_t body);
/* Replaces the island by its connected parts. 0: no scratch memory, nothing changed. */
int32_t cni_island_split(cn_world *world, int32_t island);

/* Wakes a body with its whole island and their contacts; resets rest timers. Static or disabled: no effect; awake: only the timer.
   Cannot fail: memory is reserved when bodies and contacts are created. */
void cni_body_wake(cn_world *world, int32_t body);
/* Wakes every dynamic body that touches the body or is jointed to it. */
void cni_body_wake_neighbours(cn_world *world, int32_t body);
/* Limits the contact impulses of an awake island to what soft constraints may start with, once a step. O(contacts). 0: not awake, or done. */
int32_t cni_island_limit_impulses(cn_world *world, cni_island *island);
/* ... once a body moves that contacts press harder than that. */
void cni_island_let_go(cn_world *world, cni_island *island, cni_vec2 frame);
/* Before a body is destroyed, disabled or changes its type: wakes its neighbours and limits the impulses of their islands, of contacts and of joints
   that were solved exactly. */
void cni_body_let_go(cn_world *world, int32_t body);
/* ... before a joint is destroyed: wakes its bodies. */
void cni_joint_let_go(cn_world *world, int32_t joint);
/* Wakes the body, or for a static one the bodies that overlap its boxes: at a new pose it may touch sleeping bodies. O(shapes). */
void cni_body_wake_met(cn_world *world, int32_t body);
/* Wakes the dynamic bodies that overlap a shape's boxes. */
void cni_shape_wake_met(cn_world *world, int32_t shape);
/* A shape was attached to a body: wakes it, unless it has no contacts and joints yet, so that bodies can be created asleep; if the body is
   static, those that overlap the shape's boxes. */
void cni_shape_wake_grown(cn_world *world, int32_t shape);
/* Reserves memory to put this body to sleep, with its island or a part of it. 0: no memory. */
int32_t cni_body_reserve_sleep(cn_world *world, int32_t body);
/* Puts a body and its island to sleep, and logs it. 0: no memory, nothing changed. */
int32_t cni_body_put_to_sleep(cn_world *world, int32_t body);

/* Interior-point work that the island has spent, a contact, less its refill since: direct/direct_contact.h. */
#define CNI_CONE_REFILL 6 /* blocks a contact and step */
int32_t cni_cone_debt(const cn_world *world, const cni_island *i);

#endif
