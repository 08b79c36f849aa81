/*
 * direct/heavy_response.h - the private interface between direct/heavy_response.c and heavy_contacts.c: a group of contacts at work, and what its
 * component's joints do to changes of velocity.
 */
#ifndef CNI_DIRECT_HEAVY_RESPONSE_H
#define CNI_DIRECT_HEAVY_RESPONSE_H

#include "direct/heavy_contacts.h"

/* A group in one pass, or while its response is found. */
typedef struct cni_heavy_pass {
	cn_world *world;
	const cni_solve *s;
	cni_sparse *sparse;
	cni_heavy_group *g;
	cni_component *c;
	cni_heavy_contact *heavies; /* of the group */
	int32_t count, pass;
	cni_direct_contact *points; /* as in their lanes */
	cni_lever *levers; /* of the rows: place cni_heavy_at(contact, row) */
	float *speed, *mass, *separation; /* ... in a pass; friction has no separation */
	float speed_least; /* m/s: less is rounding */
	float speed_most;  /* m/s: impulses beyond those of all masses at this speed are the kernel's */
	float leaving;     /* m/s: points that part faster keep no load */
} cni_heavy_pass;

/* Place of a row in vectors of speeds. */
static inline int32_t cni_heavy_at(int32_t contact, int32_t row)
{
	return CNI_HEAVY_LANES * contact + row;
}

static inline cni_motion *cni_heavy_body(const cni_heavy_pass *q, int32_t contact, int32_t side)
{
	return cni_motions(q->world) + (side ? q->points[contact].ib : q->points[contact].ia);
}

/* Speeds of all rows after an impulse of 1 in this one. */
static inline float *cni_heavy_column(const cni_heavy_pass *q, int32_t contact, int32_t row)
{
	return q->g->response + (CNI_HEAVY_ROWS * contact + row) * CNI_HEAVY_LANES * q->count;
}

/* 0: it has no such row. */
static inline float cni_heavy_inverse_mass(const cni_heavy_pass *q, int32_t contact, int32_t row)
{
	return q->points[contact].mass[row] > 0.0f ? cni_heavy_column(q, contact, row)[cni_heavy_at(contact, row)] : 0.0f;
}

/* 1: both of its bodies are of the component. */
static inline int32_t cni_heavy_is_inner(const cni_heavy_pass *q, int32_t contact)
{
	return q->sparse->component_of[q->points[contact].ia] == q->sparse->component_of[q->points[contact].ib];
}

/* Reads the lanes of a group's contacts. */
void cni_heavy_pass_open(cni_heavy_pass *q, cn_world *world, const cni_solve *s, cni_sparse *sparse, cni_heavy_group *g);
/* Sets the velocities of the component's bodies, and of those that touch them, aside, so that motions hold changes; adds them to these. */
void cni_heavy_set_aside(const cni_heavy_pass *q);
void cni_heavy_return(const cni_heavy_pass *q);
/* Right sides of the joints against the changes. */
void cni_heavy_sides_set(const cni_heavy_pass *q);
/* Speeds of all rows. */
void cni_heavy_speeds(const cni_heavy_pass *q, float *out);
void cni_heavy_push(const cni_heavy_pass *q, int32_t contact, int32_t row, float impulse);
/* The farthest turn of the component's levers in this step; beyond the group's turn_most its response is found again. */
float cni_heavy_turn(const cni_heavy_pass *q);
void cni_heavy_response_find(const cni_heavy_pass *q);

#endif
