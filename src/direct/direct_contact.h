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
 * Work of direct/friction_cones.c, in blocks factored of 10 ns. Most that is set aside for it in a step, a pass. An island, a contact: how
 * much it may owe before it is asked again, and what it pays back in a step, which is about what soft constraints take. Of what stands,
 * most need less than this in all: its contacts are found once, and their sets hold from then on. A heap that goes on moving would take
 * as much in every step, and is no better for it than soft constraints make it.
 */
#define CNI_CONE_WORK 50000
#define CNI_CONE_DEBT 12000
#define CNI_CONE_REFILL 24
#define CNI_CONE_FACTORS 30 /* that are set aside for a pass */
#define CNI_CONE_NODE 16 /* blocks: what a contact costs beside one */

static inline int32_t cni_cone_factor_work(const cni_component *c)
{
	return c->work + CNI_CONE_NODE * (c->end - c->begin);
}

#define CNI_SLIDE_CLOSE 0.01f /* part by which a sliding friction may be off its normal force */

enum { CNI_ROW_OPEN = 0, CNI_ROW_HELD = 1, CNI_ROW_SLIDES = 2 };

/* A touching contact taken out of its lane for the step; letters as in model/contact.h. Rows: two points, friction. */
typedef struct cni_direct_contact {
	int32_t block, lane;
	int32_t node;               /* in the sparse system, CNI_NONE: not taken */
	float nx, ny, dn, dt, fa, fb;
	float static_friction, dynamic_friction;
	float at[2], an[2], s0[2];
	float mass[3];              /* nm of the points, tm */
	float j[3];                 /* impulses */
	float load[2];              /* of the points, as the lane had it */
	float first[3];             /* impulses at the beginning of the step */
	float start[3];             /* ... of the pass */
	float room[3];              /* in this pass speeds must be at least -room */
	uint8_t state[3];           /* CNI_ROW_ */
	uint8_t state_kept[3];      /* ... as the pass began */
	uint8_t untouched;          /* 1: j is what the soft solver left in the last step */
	uint8_t reserved;
	float way;                  /* 1 or -1: where friction of a sliding contact points */
	float coefficient, slope;   /* of direct/friction_cones.c, as what follows: of friction; of the sliding lever */
	float lift;                 /* m/s: coefficient times the slip of the round before */
	float cross[4];             /* of the predictor: change of slack times change of multiplier */
	float slack[4], dual[4];    /* normals, m sum - t, m sum + t; their multipliers, m/s */
} cni_direct_contact;

/* Where many impulses bear the same those of least energy are told by what rows give way to them: m/s. */
#define CNI_DIRECT_CONTACT_LEAK 1e-5f
static inline float cni_direct_contact_leak(const cni_direct_contact *p, int32_t row)
{
	return CNI_DIRECT_CONTACT_LEAK * p->j[row] / p->mass[row];
}
/* NULL: the node is a joint. */
static inline cni_direct_contact *cni_direct_contact_of(const cni_sparse *sparse, const cni_node *n)
{
	return n->owner < 0 ? &sparse->presses[-1 - n->owner] : NULL;
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
/* Separation of a point now. */
float cni_direct_contact_separation(const cni_direct_contact *p, int32_t point, const cni_motion *a, const cni_motion *b);

/* The touching contacts of an island, appended to presses; or that there are more than `room`, or one that cannot be
   solved so. */
enum { CNI_DIRECT_CONTACTS_MANY = -1, CNI_DIRECT_CONTACTS_KIND = -2 };
int32_t cni_direct_contacts_collect(const cn_world *world, int32_t island, cni_direct_contact *presses, int32_t room);
/* Takes the planned ones' impulses out of their lanes, and makes the lanes idle. */
void cni_direct_contacts_take(cn_world *world, cni_sparse *sparse);
/* Gives lanes back with the impulses as they are: those of one component, or of all. */
void cni_direct_contacts_give_back(cn_world *world, cni_sparse *sparse, const cni_component *c);
void cni_direct_contacts_give_back_all(cn_world *world, cni_sparse *sparse, float h);
/* One pass over a component with presses. 0: no consistent set was found; impulses and velocities are as if no pass had been. */
int32_t cni_direct_contacts_solve(cn_world *world, const cni_solve *s, cni_sparse *sparse, cni_component *c, int32_t bias);

/* ---- a pass over a component ---- */

typedef struct cni_direct_contact_pass {
	cn_world *world;
	const cni_solve *s;
	cni_sparse *sparse;
	cni_component *c;
	cni_motion *motions;
	cni_island *island;
	float speed_least;
	int32_t bias;
	int32_t warm;          /* 1: from the impulses of the last pass, not from none */
	int32_t rounds;        /* most, of the search for a set */
	int32_t kept;          /* 1: the kept set will do, if nothing better is found */
	float before;          /* twice the kinetic energy before the substep's impulses */
} cni_direct_contact_pass;

/* How fast the points must be at least, and friction that no point bears. */
void cni_direct_contact_rooms_find(const cni_direct_contact_pass *q);
void cni_direct_contact_impulses_forget(const cni_direct_contact_pass *q);
void cni_direct_contact_round_begin(const cni_direct_contact_pass *q);
/* States as they are, kept or put back. */
void cni_direct_contact_states_keep(const cni_direct_contact_pass *q, int32_t back);
/* The linear system of the set as it is. 0: no finite solution. */
int32_t cni_direct_contact_system_solve(const cni_direct_contact_pass *q);
/* By the active set, from that of the pass before; `follow` takes few rounds. 0: none was found. */
int32_t cni_direct_contact_set_find(const cni_direct_contact_pass *q);
int32_t cni_direct_contact_set_follow(const cni_direct_contact_pass *q);
/* By interior points, from presses' start and the impulses that nodes carry. 0: not solved; everything is left as it may be. */
int32_t cni_direct_contacts_cone(const cni_direct_contact_pass *pass, int32_t *out_factors);

#endif
