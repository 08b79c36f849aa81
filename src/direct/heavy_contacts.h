/*
 * direct/heavy_contacts.h - contacts with lighter bodies that exact joints hold, solved with the response of the joints:
 * direct/heavy_contacts.c; which they are: direct/heavy_contacts_list.c.
 */
#ifndef CNI_DIRECT_HEAVY_CONTACTS_H
#define CNI_DIRECT_HEAVY_CONTACTS_H

#include "direct/direct_contact.h"
#include "direct/direct_system.h"

#define CNI_HEAVY_CONTACTS_FREE 32 /* in a step, and one more for each joint */
#define CNI_HEAVY_ROWS 3  /* of a contact: two points, friction */
#define CNI_HEAVY_LANES 4 /* ... places for them in vectors of speeds, the last zero */

typedef struct cni_heavy_contact {
	int32_t component, contact;
	float mass; /* kg: its bodies and all of the component */
	float load[2]; /* N s: up to these impulses the points do not yield */
	float tangent_speed; /* of a conveyor */
	float bounce[2]; /* m/s: speed of each point after its impact; 0: it does not bounce in this step */
	float restitution; /* of its lane, which has none during the substeps */
	float aside[2][3]; /* velocities of its bodies while motions hold changes */
	uint8_t is_light;  /* 1: listed because it bounces */
	uint8_t is_left;   /* 1: left to the kernel, as joints do not bear its impact */
	uint8_t is_hit;    /* 1: it bore an impulse in this step */
	uint8_t is_of_free; /* 1: nothing holds its other body, which can move */
} cni_heavy_contact;

/* Those of one component: heavies[begin] to heavies[end - 1]. */
typedef struct cni_heavy_group {
	int32_t component, begin, end;
	int32_t next;       /* of the same island, or CNI_NONE */
	float turn_most;    /* rad: farthest turn of the component's bodies in this step until the response is found again */
	int32_t set_changes; /* of the component when the response was found */
	float *response;    /* for each row: speeds of all rows after an impulse of 1 in it */
	cni_direct_contact *points; /* memory at work: CNI_HEAVY_POINT_BYTES of each contact */
	float *halves;              /* ... and while the response is found: cni_heavy_half_floats */
} cni_heavy_group;

#define CNI_HEAVY_POINT_BYTES (sizeof(cni_direct_contact) + CNI_HEAVY_LANES * (sizeof(cni_lever) + 3 * sizeof(float))) /* of a contact at work */

/* Room for them in a step with these touching contacts, of which those of two bodies of components may be listed at both, and joints. */
static inline int32_t cni_heavy_contacts_room(int32_t touching, int32_t joints)
{
	return cni_min_i(touching, (CNI_HEAVY_CONTACTS_FREE + joints) / 2) * 2;
}
/* Floats in which the response of a group is found: y of each row, z of one and where it is not zero (cni_sparse_halves). */
static inline int32_t cni_heavy_half_floats(int32_t contacts, int32_t nodes)
{
	return (CNI_HEAVY_ROWS * contacts + 2) * CNI_NODE_LANES * nodes;
}
/* Bound on their scratch memory with this number of joints: each may be a group, and one group may have CNI_HEAVY_COMPONENT_MOST. Where workers
   solve groups side by side each has memory at work of its own, but not in a world in a caller's block. */
static inline uint64_t cni_heavy_bytes(int32_t touching, int32_t joints)
{
	int32_t room = cni_heavy_contacts_room(touching, joints), most = cni_min_i(CNI_HEAVY_COMPONENT_MOST, room);
	int32_t rows = CNI_HEAVY_ROWS * most * cni_min_i(joints, CNI_HEAVY_CONTACT_BLOCKS / cni_max_i(most, 1) + 1); /* of all halves: nodes are no more than blocks */
	uint64_t halves = sizeof(float) * CNI_NODE_LANES * (uint64_t)(most > 0 ? rows + 2 * joints : 0);
	uint64_t response = CNI_HEAVY_ROWS * CNI_HEAVY_LANES * sizeof(float) * (uint64_t)most;
	return halves + CNI_HEAVY_POINT_BYTES * (uint64_t)most + (sizeof(cni_heavy_contact) + sizeof(cni_heavy_group) + sizeof(int32_t) + response) * (uint64_t)room + 48;
}

static inline int32_t cni_heavy_bounces(const cni_heavy_contact *h) { return h->bounce[0] + h->bounce[1] > 0.0f; }

static inline float *cni_heavy_restitution(const cn_world *world, int32_t contact)
{
	int32_t slot = cni_contact_at(world, contact)->slot;
	return &cni_block_info_at(world, slot / CNI_LANES)->restitution[slot % CNI_LANES];
}

/* As many contacts of a component as there is work for: each of them solves its system several times a step, so the larger the system,
   the fewer. */
int32_t cni_heavy_contacts_most(const cni_sparse *sparse, const cni_component *c);
/* Lists those of a component. batchable 1: without them it is in a batch with others. 0: it has none. */
int32_t cni_heavy_contacts_list(const cn_world *world, const cni_solve *s, cni_sparse *sparse, int32_t component, int32_t batchable);
/* Finds the response of the joints; after cni_projection_mark. */
void cni_heavy_contacts_find(cn_world *world, const cni_solve *s);
/* One pass over them, after the joints. */
void cni_heavy_contacts_solve(cn_world *world, const cni_solve *s, int32_t bias);
/* One more, of the components whose joints contacts have opened: after these, before the contacts of the kernel (direct/joint_projection.c). */
void cni_heavy_contacts_project(cn_world *world, const cni_solve *s);
/* After the substeps: those that were hit bounce. */
void cni_heavy_contacts_bounce(cn_world *world, const cni_solve *s);

#endif
