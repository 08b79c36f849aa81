/*
 * model/island.h - groups of dynamic bodies connected by touching contacts and joints, persistent across
 * steps. They decide what sleeps together.
 *
 * A body alone has no island record (island == CNI_NONE). Linking two bodies relabels the smaller island
 * into the larger. Unlinking only counts a loss; an island with losses is split by a search over contacts
 * and joints when it would otherwise fall asleep, one island a step at most (Catto, "Simulation Islands",
 * 2023, with relabelling in place of union-find).
 */
#ifndef CNI_MODEL_ISLAND_H
#define CNI_MODEL_ISLAND_H

#include "base/config.h"
#include "cairn.h"

typedef struct cni_island {
	int32_t first, last;   /* bodies, linked by island_next/prev; first == CNI_NONE: free record */
	int32_t count;
	int32_t losses;        /* links removed since it was made or split */
	int32_t awake;         /* 1: its bodies are in the dense arrays */
	int32_t next_free;
	float rest_time;       /* scratch of the sleep stage: least sleep_time of its bodies */
	int32_t number;        /* scratch of a step that numbers its islands */
	uint32_t numbered_step; /* step + 1 in which it was numbered last */
	int32_t tier;          /* CNI_TIER_; these are of direct/solver_selection.c */
	int32_t good_steps;    /* directly solved ones since something was wrong */
	int32_t stay_steps;    /* good ones until it is given back to the soft solver, 0: as few as can be */
	uint32_t given_step;   /* in which it was given back last */
	uint32_t looked_step;  /* step + 1 in which something was wrong last */
	uint32_t refused_step; /* in which it could not be solved directly */
	int32_t refused_steps; /* how long that counts, 0: never refused */
	int32_t reason;        /* CN_TIER_REASON_ of its tier; of a soft one: why it was not taken when something was wrong last */
	int32_t solver;        /* in the last step: CN_SOLVER_SOFT if a body asks for that, else CN_SOLVER_DIRECT if one does */
	int32_t joints_solver; /* then: CN_SOLVER_DIRECT if a joint asks for that */
	uint32_t new_step;     /* step + 1 in which a contact began to bear last */
	int32_t new_contacts;  /* how many did then */
	uint32_t unheld_step;  /* step + 1 in which its loads were looked for from the top down, last, and not found */
	uint32_t cone_step;    /* step + 1 in which its contacts were last solved by direct/friction_cones.c, or from there */
	int32_t cone_spent;    /* a contact, by that; what is left of it is less by every step since: CNI_CONE_REFILL */
	uint32_t cone_paid_step; /* the step in which that was so */
	uint32_t gives_step;   /* step + 1 in which, solved directly, it last moved where it touches */
	int32_t falls_steps;   /* ... and in how many without a break so fast that it falls */
} cni_island;

enum { CNI_TIER_SOFT = CN_TIER_SOFT, CNI_TIER_DIRECT = CN_TIER_DIRECT };

cni_island *cni_island_at(const cn_world *world, int32_t island);
/* Makes the next extra links certain to find a record; 0: no memory. */
int32_t cni_island_reserve(cn_world *world, int32_t extra);
/* Joins the islands of two dynamic bodies; wakes the sleeping side if the other is awake. After
   cni_island_reserve(world, 1). */
void cni_island_link(cn_world *world, int32_t body_a, int32_t body_b);
/* One link between them went away. */
void cni_island_unlink(cn_world *world, int32_t body_a, int32_t body_b);
/* Takes a body out of its island (when destroyed or no longer dynamic). */
void cni_island_remove_body(cn_world *world, int32_t body);
/* Replaces the island by its connected parts. 0: no scratch memory, nothing changed. */
int32_t cni_island_split(cn_world *world, int32_t island);

/* Wakes a body with its whole island and their contacts; resets sleep timers. Static, disabled or awake: no-op but
   for the timer. Cannot fail: room for being awake is reserved when bodies and contacts are made. */
void cni_body_wake(cn_world *world, int32_t body);
/* Wakes every body that touches it, and the bodies its joints connect. */
void cni_body_wake_neighbours(cn_world *world, int32_t body);
/* Wakes the body, or for a static one what its boxes meet: where it is now it may touch what sleeps. O(shapes). */
void cni_body_wake_met(cn_world *world, int32_t body);
/* The dynamic bodies that a shape's boxes meet. */
void cni_shape_wake_met(cn_world *world, int32_t shape);
/* It got a new shape: wakes it, unless it has met nothing yet, so that bodies can be made asleep. */
void cni_body_wake_grown(cn_world *world, int32_t body);
/* Makes putting this body to sleep, with its island or with a part of it, certain to succeed. 0: no memory. */
int32_t cni_body_reserve_sleep(cn_world *world, int32_t body);
/* Puts a body and its island to sleep, logging fell-asleep. 0: no memory, nothing changed. */
int32_t cni_body_put_to_sleep(cn_world *world, int32_t body);

#endif
