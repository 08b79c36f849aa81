/*
 * stages/joint_coarse.h - large nets of pins at rest: motions that span many joints.
 *
 * Passes over joints, one after the other, hardly feel what is the same over many joints. In a net under pressure that
 * is not harmless: turning each body against its neighbours, all over the net, parts no pin and shortens the net, so the
 * pressure does work; only places far away, where the net is held, speak against it. Soft pins hold a net of 100 by 100 balls
 * there no better than rubber would: the turning grows threefold in every step.
 *
 * So bodies are put together to patches of about 25. A patch of pinned bodies has only a few ways to move that part none of
 * its own pins (three at least where it is not held, and four where neighbours can turn against each other): its modes. The part
 * of the bodies' velocities that is made of modes, and parts pins between patches, is what passes do not see. It is taken
 * out by one small system of all the modes, before the pass of each substep:
 *
 *   q = F' M v          F: the modes by columns, with F' M F = 1
 *   (1 + g J'J) q' = q  J: speeds of the pins between patches by q
 *   v += F (q' - q)
 *
 * This is the coarse correction of a two-grid method (aggregation with the patches' null space as in Vanek, Mandel and Brezina,
 * "Algebraic multigrid by smoothed aggregation", 1996, unsmoothed). It takes kinetic energy out, never puts any in, and
 * keeps momentum. What no pin speaks against is a motion that the modes hold exactly, so it passes.
 *
 * What modes do not hold of a patch's motion is left to the passes, from which joints learn what they bear: until it is no
 * more than a hundredth of what gravity gives in a substep. Then it goes too, for patches under great pressure fold within.
 *
 * Modes are those of the arms as they were when the patches were made. Where arms have turned by an angle d since, a motion that
 * all pins allow, such as folding, is off by about d L / r of itself in a net of length L, and that squared of its energy goes in
 * a substep. So a net whose arms have turned by more than TURN_MOST over the square root of its bodies, or are about to,
 * is left to the passes until patches are made anew: at once where that has not been necessary for long, and ever more rarely
 * where it is again and again. Nets that nothing holds have no patches: they may turn and fold for ever.
 *
 * A net that rests is done with after the first substep, as piles are: stages/rest.c. Worlds in a caller's block have no patches:
 * they set nothing aside for them.
 */
#ifndef CNI_STAGES_JOINT_COARSE_H
#define CNI_STAGES_JOINT_COARSE_H

#include "stages/joint_pass.h"

#define CNI_PATCH_BODIES 32 /* most of a patch */
#define CNI_PATCH_MODES 8   /* most of a patch; nets that have more freedom than that are no nets */

/* From the bodies' centres to the middle between the pin's two ends: so loops close, and what turns as one parts no pin, also where
   pins are a little open. */
typedef struct cni_arms {
	float ax, ay, bx, by;
} cni_arms;

static inline cni_arms cni_coarse_arms(const cni_joint_block *k, int32_t l)
{
	cni_arms r;
	r.ax = k->ax[l] + 0.5f * k->ex[l];
	r.ay = k->ay[l] + 0.5f * k->ey[l];
	r.bx = k->bx[l] - 0.5f * k->ex[l];
	r.by = k->by[l] - 0.5f * k->ey[l];
	return r;
}

/* A body of a net. */
typedef struct cni_net_body {
	int32_t body, index;          /* slot; dense index when it was looked up last */
	float inv_mass, inv_inertia;
} cni_net_body;

/* A pin of a net. */
typedef struct cni_net_pin {
	int32_t joint;
	int32_t lane;                 /* block * CNI_LANES + lane when it was looked up last */
	int32_t a, b;                 /* net bodies, CNI_NONE: what cannot move */
	cni_arms arms;                /* when the patches were made */
} cni_net_pin;

typedef struct cni_patch {
	int32_t body_begin, body_end; /* of the net bodies */
	int32_t modes;
	int32_t mode;                 /* number of its first one, and row of the system */
	int32_t part;                 /* place of the first body's parts: x, y, turn of each mode, body by body */
	int32_t column;               /* where its rows of the system begin */
	int64_t entry;                /* place of its first row: each ends with the diagonal, which is kept inverted */
} cni_patch;

/* One that is connected. Ranges of what follows. */
typedef struct cni_net_range {
	int32_t body_begin, body_end;
	int32_t pin_begin, pin_end;
	int32_t patch_begin, patch_end;
	int32_t mode_begin, mode_end;
	int32_t ends;                 /* of its pins on its bodies */
	int32_t dear;                 /* its system is too large, or not to be solved in doubles: it is left to the passes */
	int32_t holds;                /* in this step */
	int32_t rests;                /* ... is done with: stages/rest.c */
} cni_net_range;

/* All nets; kept from step to step, in world->coarse. */
typedef struct cni_coarse {
	uint32_t made_step;           /* in which patches were made, or looked for */
	uint32_t credit;              /* what was left then of the time for doing that again */
	int32_t lanes;                /* pins there were then, in nets or not */
	int32_t fixed;                /* ... of these to what cannot move */
	int32_t net_count, body_count, pin_count, patch_count, mode_count;
	int64_t part_count, entry_count;
} cni_coarse;

/* Where its pieces are. */
typedef struct cni_coarse_view {
	cni_coarse *head;
	cni_net_range *nets;
	cni_net_body *bodies;
	cni_net_pin *pins;
	cni_patch *patches;
	double *entries;              /* Cholesky factors of the systems by rows, from the first that is not 0 */
	double *speeds;               /* by mode: q, then q'; and as many again: q */
	float *parts;
} cni_coarse_view;

#define CNI_COARSE_BYTES 64 /* an item of world->coarse */

/* Cuts a piece off a memory, behind those before it; memory NULL: only how much it takes. */
static inline void *cni_coarse_piece(uint8_t *memory, uint64_t *at, uint64_t bytes)
{
	void *here = memory == NULL ? NULL : memory + *at;
	*at += (bytes + CNI_COARSE_BYTES - 1) / CNI_COARSE_BYTES * CNI_COARSE_BYTES;
	return here;
}

/* Lays out what world->coarse holds, as many of each as the head says. Returns how many bytes that takes; memory NULL: only that. */
uint64_t cni_coarse_lay_out(cni_coarse_view *v, const cni_coarse *head, uint8_t *memory);
cni_coarse_view cni_coarse_view_of(const cn_world *world);
/* How many entries the systems have, and where; patch_of: the patch of each body, is written. */
void cni_coarse_system_size(const cni_coarse_view *v, int32_t *patch_of);
/* Writes and factors them; those that rounding spoils make their nets dear. patch_of_mode is scratch. */
void cni_coarse_system_make(const cni_coarse_view *v, const int32_t *patch_of, int32_t *patch_of_mode);
/* q' in place of q. */
void cni_coarse_system_solve(const cni_coarse_view *v, const cni_net_range *net);
/* Nets among the pins in lanes, their patches and systems. 0: no memory; the old ones stay. */
int32_t cni_coarse_make(cn_world *world, int32_t lanes);
/* Is it a lane that a net may have? */
static inline int32_t cni_coarse_takes(const cni_joint_block *block, int32_t l)
{
	return block->ia[l] != block->ib[l] && !(block->direct >> l & 1u);
}

#endif
