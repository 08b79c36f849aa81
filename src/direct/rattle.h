/*
 * direct/rattle.h - what rattle.c, which steps bodies that only joints hold, and rattle_energy.c share.
 */
#ifndef CNI_DIRECT_RATTLE_H
#define CNI_DIRECT_RATTLE_H

#include "direct/direct_system.h"

#define GAP_OLD 100.0f          /* times CLOSED: a gap that this step has not made */
#define ENERGY_GAIN 0.01f      /* part of the kinetic energy that a step may take out: more is a step that failed */

typedef struct swing {
	cn_world *world;
	cni_sparse *sparse;
	const cni_component *c;
	cni_motion *motions;
	float h;
	float closed;      /* errors below it do not matter */
	float closing;     /* most that is closed of an old gap in a substep */
	float *left;       /* by row: what of an old gap is to be left after the substep */
	float warm;        /* 0.5, or 0: what of the last substep's impulse mu starts from */
	float speeding;    /* h^2 m a^2 / 4 of the last substep: how far the method's energy may be off */
	float base_work;   /* that moving bodies without mass have done at their joints in this step */
	int32_t mends;     /* 1: the step began with gaps that it closes */
} swing;

static inline cni_joint_constraint *work_of(const swing *g, int32_t node)
{
	return &cni_joint_constraints(g->world)[g->sparse->nodes[node].owner];
}

/* Are there old gaps, which are closed with some speed? */
int32_t cni_rattle_mends(const swing *g);
/* Has the component joints to what cannot move? */
int32_t cni_rattle_is_fixed(const swing *g);
float cni_rattle_kinetic(const swing *g);
/* Of motion, less the work that drives have done in this step. */
float cni_rattle_energy(const swing *g);
/* What a step of free fall, and of closing gaps, may give from rest. */
float cni_rattle_energy_allowed(const swing *g, float dt);
/* h^2 m a^2 / 4 of the last substep: how far the method's energy may be off. */
float cni_rattle_speeding(const swing *g, const cni_solve *s);
/* What moving bodies without mass did at the component's joints in a substep. */
float cni_rattle_base_work(const swing *g);
/* What a step gained goes to the account, and what is too much for it out of the motion. */
void cni_rattle_account(const swing *g, cni_joint_trust *t, float gained);

#endif
