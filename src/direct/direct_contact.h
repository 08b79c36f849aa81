/*
 * direct/direct_contact.h - contacts that are solved directly with their island's joints: normals and friction in
 * one sparse system with an active set.
 */
#ifndef CNI_DIRECT_DIRECT_CONTACT_H
#define CNI_DIRECT_DIRECT_CONTACT_H

#include "model/solve.h"
#include "linear/sparse.h"

/* Most contacts that are solved directly in a step of CN_SOLVER_AUTO, and most work of a system a node of it. */
#define CNI_DIRECT_CONTACT_MOST 512
#define CNI_DIRECT_CONTACT_WORK 48

/*
 * Work of attempts at exact solutions, in blocks factored of 10 ns: direct/friction_cones.c, searches for sets, retries of direct/rattle.c.
 * Most of all systems in a step, beyond which a search for a set ends with its first round and no interior-point method begins but for a relax pass: 40 arches that are struck took 10.9 ms in their slowest
 * step without it, now 3.1. Most of a pass. An island, a contact: how much it may owe before it is asked again, and what it pays back in a
 * step (CNI_CONE_REFILL), which is about what soft constraints take at rest. Of what stands, most need less than this in all: its contacts
 * are found once, and their sets hold from then on. A heap that was poured would take as much in every step, and is no better for it than
 * soft constraints make it. So what moves owes all that an island may, and a search in vain owes CNI_CONE_FAILED, whatever method it ended
 * with. No pass begins that could not have CNI_CONE_FACTORS_LEAST factorizations. Instructions of 600 steps of poured heaps of 10, 50 and
 * 200 bodies: 58, 125 and 626 M where what moved might spend 500 and only interior points owed, now 25, 77 and 335 M. Arches that boxes
 * fall on stand as often, 95 of 100.
 */
#define CNI_ATTEMPT_WORK 200000
#define CNI_ATTEMPT_WORK_DIRECT 2000000 /* ... with CN_SOLVER_DIRECT, 20 ms: 76 boxes under a crusher took 53 million, now 13 */
#define CNI_ATTEMPT_PASS_WORK 100000 /* most of one pass, but for CNI_CONE_FACTORS_LEAST: large walls take 5 to 20, heaps that settle 40 to 60 */
#define CNI_RATTLE_WORK 50000 /* most of failed attempts of direct/rattle.c: solutions and rows take three times as long as their factorizations */
#define CNI_CONE_DEBT 12000
#define CNI_CONE_FAILED 21000 /* what a failed attempt owes beside its work: 1,500 steps until the next */
#define CNI_CONE_FACTORS 30 /* of a pass: a system is too large where so many exceed CNI_ATTEMPT_WORK */
#define CNI_CONE_NODE 16 /* blocks: what a contact costs beside one */
#define CNI_CONE_SOLUTION 4 /* ... and in a solution without one */

static inline int32_t cni_cone_factor_work(const cni_component *c)
{
	return c->work + CNI_CONE_NODE * (c->end - c->begin);
}

/* Most of all systems in a step, for this one: with CN_SOLVER_DIRECT a large one may have CNI_CONE_FACTORS factorizations. */
static inline int32_t cni_attempt_work_most(const cn_world *world, const cni_component *c)
{
	int64_t large = (int64_t)CNI_CONE_FACTORS * cni_cone_factor_work(c);
	if (world->settings.solver == CN_SOLVER_AUTO)
		return CNI_ATTEMPT_WORK;
	return (int32_t)(large < CNI_ATTEMPT_WORK_DIRECT ? CNI_ATTEMPT_WORK_DIRECT : large < INT32_MAX / 2 ? large : INT32_MAX / 2);
}

/* 1: the systems of this step have spent what they may. A search for a set then ends with its first result. */
static inline int32_t cni_attempt_work_is_spent(const cn_world *world, const cni_component *c)
{
	return world->cone_work + world->set_work >= cni_attempt_work_most(world, c);
}

/* Sets what cni_cone_debt (model/island.h) returns now. */
static inline void cni_cone_debt_set(const cn_world *world, cni_island *i, int32_t debt)
{
	i->cone_spent = debt;
	i->cone_paid_step = world->step_count;
}

enum { CNI_ROW_OPEN = 0, CNI_ROW_ACTIVE = 1, CNI_ROW_SLIDES = 2 };

/* A touching contact taken out of its lane for the step; letters as in model/contact.h. Rows: two points, friction. */
typedef struct cni_direct_contact {
	int32_t block, lane;
	int32_t ia, ib;             /* dense indices of its bodies */
	int32_t node;               /* in the sparse system, CNI_NONE: it is back in its lane */
	float nx, ny, dn, dt, fa, fb;
	float static_friction, dynamic_friction;
	float at[2], an[2], s0[2];
	float mass[3];              /* nm of the points, tm */
	float j[3];                 /* impulses */
	float load[2];              /* of the points, as read from the lane */
	float first[3];             /* impulses at the beginning of the step */
	float start[3];             /* ... of the pass */
	float gap_speed[3];         /* in this pass the speed must be at least -gap_speed */
	uint8_t state[3];           /* CNI_ROW_ */
	uint8_t state_kept[3];      /* ... at the beginning of the pass */
	uint8_t untouched;          /* 1: j is the soft solver's impulse of the last step */
	uint8_t slips;              /* 1: slides faster than CNI_DIRECT_STILL_SPEED at the beginning of the substep */
	float slide_sign;           /* 1 or -1: direction of the friction of a sliding contact */
	float coefficient, slope;   /* this and below: direct/friction_cones.c. Of friction; of the sliding lever */
	float lift;                 /* m/s: coefficient times the slip of the last round */
	float cross[4];             /* of the predictor: change of slack times change of multiplier */
	float slack[4], dual[4];    /* normals, m sum - t, m sum + t; their multipliers, m/s */
} cni_direct_contact;

static inline float cni_direct_contact_leak(const cni_direct_contact *p, int32_t row)
{
	return CNI_DIRECT_LEAK * p->j[row] / p->mass[row];
}
/* The contact of a node; NULL: the node is a joint. */
static inline cni_direct_contact *cni_direct_contact_of(const cni_sparse *sparse, const cni_node *n)
{
	return n->owner < 0 ? &sparse->contacts[-1 - n->owner] : NULL;
}
/* Row 0 and 1: the points; 2: friction. */
static inline cni_lever cni_direct_contact_lever(const cni_direct_contact *p, int32_t row)
{
	float bt = p->at[row & 1] - p->dt;
	cni_lever normal = { -p->nx, -p->ny, -p->at[row & 1], p->nx, p->ny, bt };
	cni_lever friction = { -p->ny, p->nx, p->fa, p->ny, -p->nx, -p->fb };
	return row < 2 ? normal : friction;
}
static inline void cni_direct_contact_push(const cni_direct_contact *p, int32_t row, float impulse, cni_motion *a, cni_motion *b)
{
	cni_lever l = cni_direct_contact_lever(p, row);
	if (impulse != 0.0f)
		cni_lever_push(&l, impulse, a, b);
}
static inline float cni_direct_contact_speed(const cni_direct_contact *p, int32_t row, const cni_motion *a, const cni_motion *b)
{
	cni_lever l = cni_direct_contact_lever(p, row);
	return cni_lever_speed(&l, a, b);
}
/* 1: an axis of one of its bodies is locked. */
int32_t cni_direct_lane_is_locked(const cn_world *world, const cni_contact *c);
/* Of a conveyor. */
float cni_direct_lane_tangent_speed(const cn_world *world, const cni_contact *c);
/* Reads the lane of a contact. */
void cni_direct_contact_read(const cn_world *world, const cni_contact *c, cni_direct_contact *p);
/* Separation of a point now. */
float cni_direct_contact_separation(const cni_direct_contact *p, int32_t point, const cni_motion *a, const cni_motion *b);

/* Lists the touching contacts of an island. Returns their number, or the reason (CN_TIER_REASON_) less than 0 why it stays soft: there are
   more than `room`, one is of an unsupported kind, one bounces. */
enum { CNI_DIRECT_CONTACTS_MANY = -CN_TIER_REASON_CROWDED, CNI_DIRECT_CONTACTS_KIND = -CN_TIER_REASON_KIND, CNI_DIRECT_CONTACTS_BOUNCE = -CN_TIER_REASON_MOVING };
int32_t cni_direct_contacts_collect(const cn_world *world, int32_t island, int32_t *contacts, int32_t room);
/* Takes the impulses of planned contacts out of their lanes and makes the lanes idle. */
void cni_direct_contacts_extract(cn_world *world, cni_sparse *sparse);
/* Writes contacts back to their lanes with the present impulses: those of one component, or all. */
void cni_direct_contacts_restore(cn_world *world, cni_sparse *sparse, const cni_component *c);
void cni_direct_contacts_restore_all(cn_world *world, cni_sparse *sparse, float h);
/* One pass over a component with contacts. 0: no consistent set was found; impulses and velocities are as before the pass. */
int32_t cni_direct_contacts_solve(cn_world *world, const cni_solve *s, cni_sparse *sparse, cni_component *c, int32_t bias);

/* ---- a pass over a component ---- */

typedef struct cni_direct_contact_pass {
	cn_world *world;
	const cni_solve *s;
	cni_sparse *sparse;
	cni_component *c;
	cni_motion *motions;
	cni_direct_contact *first, *end; /* the component's contacts */
	cni_island *island;
	float speed_least;
	int32_t bias;
	int32_t warm;          /* 1: starts from the impulses of the last pass, 0: from none */
	int32_t rounds;        /* limit of the search for a set */
	int32_t smooth;        /* 1: without the friction of contacts that slip */
	int32_t kept;          /* 1: the kept set is acceptable if nothing better is found */
	int32_t denied;        /* 1: other systems have spent what the step may spend */
	int32_t squeezed;      /* 1: no impulses close its points: friction cones are not tried, and it owes nothing */
	float before;          /* twice the kinetic energy before the substep's impulses */
	float smooth_sum;      /* cni_direct_contact_smooth_sum, or more: where no contact slips FLT_MAX */
	cni_vec2 frame;        /* cni_island_frame */
} cni_direct_contact_pass;

/* Sets the least speeds of the points, and opens friction where no point is active. */
void cni_direct_contact_gap_speeds_find(const cni_direct_contact_pass *q);
void cni_direct_contact_impulses_clear(const cni_direct_contact_pass *q);
void cni_direct_contact_round_begin(const cni_direct_contact_pass *q);
/* Saves the states (restore 0) or restores them (1). */
void cni_direct_contact_states_save(const cni_direct_contact_pass *q, int32_t restore);
/* Solves the linear system of the present set. 0: no finite solution. */
int32_t cni_direct_contact_system_solve(const cni_direct_contact_pass *q);
/* Searches for the active set from that of the last pass; set_follow takes few rounds. 0: none was found. */
int32_t cni_direct_contact_set_find(const cni_direct_contact_pass *q);
int32_t cni_direct_contact_set_follow(const cni_direct_contact_pass *q);
/* The largest speed by which the solution contradicts the present set. */
float cni_direct_contact_set_error(const cni_direct_contact_pass *q);
/* Sum of the normal impulses of the solution. */
float cni_direct_contact_normal_sum(const cni_direct_contact_pass *q);
/* ... of the same pass without the friction of contacts that slip; FLT_MAX: no set was found. Changes states, impulses
   and velocities. */
float cni_direct_contact_smooth_sum(const cni_direct_contact_pass *q);
/* Interior-point method, from the contacts' `start` and the impulses in `carried`. 0: not solved; the state is then undefined. */
int32_t cni_direct_contacts_cone(const cni_direct_contact_pass *pass, int32_t *out_factors);

#endif
