/*
 * direct/rattle.h - the shared part of rattle.c, which steps bodies that only joints constrain, and rattle_energy.c.
 */
#ifndef CNI_DIRECT_RATTLE_H
#define CNI_DIRECT_RATTLE_H

#include "direct/direct_system.h"

/* A node's `carried`: remainders of old gaps after the substep; its `total`: impulses of the substep. */
typedef struct rattle_step {
	cn_world *world;
	cni_sparse *sparse;
	const cni_component *c;
	cni_motion *motions;
	float h;
	float closed;      /* largest negligible joint error */
	float closing;     /* m/s or rad/s: greatest speed at which an old gap closes at first; 0: there is none */
	float warm;        /* 0.5, or 0: part of the last substep's impulse that is the first guess of mu */
	float energy_error; /* h^2 m a^2 / 4 of the last substep: bound on the method's energy error */
	float base_work;   /* work of moving bodies without mass at their joints in this step */
	float elapsed;     /* since the step began */
	int32_t held;      /* 1: joints end at bodies without mass */
} rattle_step;

static inline cni_joint_constraint *constraint_of(const rattle_step *g, int32_t node)
{
	return &cni_joint_constraints(g->world)[g->sparse->nodes[node].owner];
}

typedef struct rattle_energies {
	float kinetic;
	float total;       /* of motion, less the work of external accelerations in this step */
	float allowed;     /* that a step of free fall and of gap closing may add from rest */
	float rounding;    /* work of external accelerations along the position error: the tolerance of closed joints, the rounding of floats */
} rattle_energies;

float cni_rattle_closing_speed(const rattle_step *g);
/* Energies of the component now, in a step of this length. */
rattle_energies cni_rattle_energies(const rattle_step *g, float dt);
float cni_rattle_energy_error(const rattle_step *g, const cni_solve *s);
/* Work of moving bodies without mass at the component's joints in a substep. */
float cni_rattle_base_work(const rattle_step *g);
/* Adds the energy gain of a step to the account and takes the excess out of the motion. */
void cni_rattle_account(const rattle_step *g, const rattle_energies *e, cni_joint_trust *t, float gained);

#endif
