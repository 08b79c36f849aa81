/*
 * joints/joint_constraint.h - what the solver keeps for an awake joint during a step: its rows are made in joints/joint_constraint.c.
 */
#ifndef CNI_JOINTS_JOINT_CONSTRAINT_H
#define CNI_JOINTS_JOINT_CONSTRAINT_H

#include "joints/joint_type.h"
#include "linear/sparse.h"
#include "model/solve.h"

enum {
	CNI_CONSTRAINT_SPRINGY = 1u << 0,   /* the first rows and violated limits act in the soft pass only */
	CNI_CONSTRAINT_BOUNDED = 1u << 1,   /* force_max or torque_max is set */
	CNI_CONSTRAINT_BREAKABLE = 1u << 2, /* a break threshold is set */
	CNI_CONSTRAINT_GROUNDS = 1u << 3,   /* d and e are seen from points of the world */
	CNI_CONSTRAINT_TURNS = 1u << 4,     /* counts whole turns */
	CNI_CONSTRAINT_DIRECT = 1u << 5,    /* its rigid rows are solved with its neighbours': direct/direct_joints.c */
	CNI_CONSTRAINT_FINISHED = 1u << 6,     /* done with for this step: direct/rattle.c */
	CNI_CONSTRAINT_WIDE = 1u << 7,      /* unless swung it is in a lane: joints/joint_blocks.c; rows are written only if direct, and their impulses are all of the record's */
	CNI_CONSTRAINT_FRESH = 1u << 8,     /* this is its first step */
	CNI_CONSTRAINT_BATCHED = 1u << 9       /* in a lane of a batch, pin and all: direct/batched_trees.c */
};

#define CNI_JOINT_ERROR_RATE 0.3f /* part of its gap that a directly solved joint takes out in a substep */

/* What a joint has that is solved by rows, alone or with others; most are in lanes, and never look at it. */
typedef struct cni_joint_numbers {
	cni_row rows[CNI_JOINT_ROWS];
	float inverse[6];          /* of the first rows' K: 00 01 02 11 12 22 */
	float single_mass[CNI_JOINT_ROWS];
	cni_soft soft;             /* springy: of the first rows and of limits */
	cni_soft spring;           /* of the spring or soft row, if there is one */
	float force_max, torque_max;       /* bounded: most, FLT_MAX without a bound */
	float force_stress, torque_stress; /* breakable: largest reaction of the step so far */
} cni_joint_numbers;

/* Works come one after the other, their numbers behind the last that there is room for. */
typedef struct cni_joint_constraint {
	const cni_joint *record;   /* within a step records do not move */
	cni_joint_rows_fn *make_rows; /* of its type */
	cni_row *rows;             /* its numbers' */
	cni_joint_numbers *numbers;
	int32_t joint;
	int32_t ia, ib;            /* dense body indices, 0: static or the world */
	uint32_t flags;            /* CNI_WORK_* */
	int32_t row_count;
	int32_t rigid_count;       /* the first rows: rigid or drive */
	int32_t next_plain;        /* the next that is solved by rows */
	int32_t inner;             /* which of the rows that are not rigid is solved with them: direct/active_rows.c; 0: none */
	int32_t lane;              /* block * CNI_LANES + lane of a pin, CNI_NONE: solved by rows alone */
	int32_t form;              /* CNI_FORM_*, 0: none. It has no rows here until it is solved directly, or finds no lane: joints/joint_rows.h */
	int32_t row_lane;          /* ... block * CNI_LANES + lane of rows, CNI_NONE */
	cni_joint_frame start;     /* at the beginning of the step */
	int32_t kept_lane;         /* the lane that it was given last */
	uint32_t kept_has;         /* which of CN_JOINT_SPRING, _MOTOR, _LIMIT it had there */
} cni_joint_constraint;

#define CNI_JOINT_CONSTRAINT_BYTES ((int32_t)(sizeof(cni_joint_constraint) + sizeof(cni_joint_numbers)))

static inline cni_joint_constraint *cni_joint_constraints(const cn_world *world)
{
	return (cni_joint_constraint *)world->joint_work.data;
}
/* Those of the work of place k. */
static inline cni_joint_numbers *cni_joint_numbers_of(const cn_world *world, int32_t k)
{
	return (cni_joint_numbers *)(void *)(cni_joint_constraints(world) + world->joint_work.capacity) + k;
}
/* Are there so many that records leave the caches between one loop over all and the next? Then it pays to ask for them early. */
static inline int32_t cni_joints_are_far(const cn_world *world)
{
	return world->awake_joints.count >= 1024;
}
/* All of a record: three cache lines. */
CNI_INLINE void cni_joint_prefetch(const cni_joint *j)
{
	CNI_PREFETCH(j);
	CNI_PREFETCH(j->impulse);
	CNI_PREFETCH(j->p);
}
CNI_INLINE void cni_component_prefetch(const cn_world *world, const cni_sparse *sparse, int32_t component)
{
	const cni_component *c = &sparse->components[component];
	int32_t k;
	for (k = c->begin; k < c->end; ++k)
		if (sparse->nodes[k].owner >= 0)
			cni_joint_prefetch(cni_joint_constraints(world)[sparse->nodes[k].owner].record);
}
static inline cni_lever cni_row_lever(const cni_row *r)
{
	cni_lever l = { r->ax, r->ay, r->aw, r->bx, r->by, r->bw };
	return l;
}
static inline float cni_row_mass(const cni_row *r, const cni_row *q, const cni_motion *a, const cni_motion *b)
{
	return a->inv_mass * (r->ax * q->ax + r->ay * q->ay) + a->inv_inertia * r->aw * q->aw +
	       b->inv_mass * (r->bx * q->bx + r->by * q->by) + b->inv_inertia * r->bw * q->bw;
}
static inline float cni_row_speed(const cni_row *r, const cni_motion *a, const cni_motion *b)
{
	cni_lever l = cni_row_lever(r);
	return cni_lever_speed(&l, a, b);
}
static inline void cni_row_push(const cni_row *r, float impulse, cni_motion *a, cni_motion *b)
{
	cni_lever l = cni_row_lever(r);
	cni_lever_push(&l, impulse, a, b);
}
/* Where the inverse of the first rows' K has its entry for rows i and k. */
static inline int32_t cni_inverse_at(int32_t i, int32_t k)
{
	static const uint8_t at[CNI_JOINT_RIGID_ROWS][CNI_JOINT_RIGID_ROWS] = { { 0, 1, 2 }, { 1, 3, 4 }, { 2, 4, 5 } };
	return at[i][k];
}
/* The island of whichever of a joint's bodies has one. */
static inline int32_t cni_joint_island(const cn_world *world, int32_t ia, int32_t ib)
{
	return cni_awake_island(world, ia != 0 ? ia : ib);
}
/* The work of place k in the awake list, as a step begins, to be solved by rows. */
void cni_joint_constraint_prepare(cn_world *world, const cni_solve *s, int32_t k);
/* What of it does not depend on how it is solved, the frame's angle left out. */
void cni_joint_constraint_begin(cn_world *world, int32_t k, const cni_joint *j);
/* ... then its rows, decoupled, with their impulses. */
void cni_joint_rows_begin(cn_world *world, const cni_solve *s, cni_joint_constraint *w);
/* As a step ends: the rows' impulses to the record, by the type's rows. */
void cni_joint_rows_end(const cn_world *world, const cni_joint_constraint *w, cni_joint *j);
/* The same rows at the bodies' new positions, with the impulses they had; what that changes in the impulses' response goes into start. */
void cni_joint_rows_renew(cn_world *world, cni_joint_constraint *w);
/* Inverse of the symmetric K of one to three rows, as numbers->inverse; a singular direction gives nothing. */
void cni_rows_invert(const cni_row *r, int32_t count, const cni_motion *a, const cni_motion *b, float *inv);
/* Builds all rows at the bodies' present positions, impulses left undefined. */
void cni_joint_constraint_build(cni_joint_constraint *w, const cni_motion *a, const cni_motion *b);
/* The rows as their type gives them, for joints whose rows are all rigid or limits that are far away; turns: rotations
   by the motions' theta. Impulses are left undefined. */
void cni_joint_constraint_rows(cni_joint_constraint *w, const cni_motion *motions, const cni_rot *turns);
/* Errors of the rigid rows after a time at the bodies' present velocities. */
void cni_joint_constraint_ahead(const cni_joint_constraint *w, const cni_motion *motions, float h, float *errors);
/* All rows of a joint with the impulses that they have in this substep, whatever solves it; springy joints' rows are soft.
   row.slot: of the record's impulse, which is that of the step's beginning. joints/joint_impulse.c */
#define CNI_PIN_LANE_ROWS 5
typedef struct cni_joint_impulses {
	cni_row rows[CNI_JOINT_ROWS + CNI_PIN_LANE_ROWS];
	int32_t count;
} cni_joint_impulses;
void cni_joint_impulses_read(const cn_world *world, const cni_joint_constraint *w, cni_joint_impulses *out);
void cni_joint_impulses_write(cn_world *world, cni_joint_constraint *w, const cni_joint_impulses *impulses);
/* Does a row of this kind give energy of its own? */
static inline int32_t cni_row_kind_drives(uint8_t kind)
{
	return kind != CNI_ROW_RIGID && kind != CNI_ROW_LIMIT;
}
/* Keeps the largest reaction of the step. */
void cni_joint_constraint_stress(cni_joint_constraint *w, const cni_motion *b, float inv_h);

/* ---- wide works: joints/joint_blocks.c ---- */

/* A wide work is solved by rows after all; a plain one stays as it is. */
void cni_joint_constraint_narrow(cn_world *world, const cni_solve *s, int32_t k);

struct cni_lanes_look; /* joints/joint_pass.h */
/* The work of place k, as a step begins, if it can be solved in a lane; 0: it cannot. A lane that is kept is filled. Workers may
   look at different works at once. */
int32_t cni_joint_constraint_widen(cn_world *world, const cni_solve *s, struct cni_lanes_look *look, int32_t k);
/* All works have lanes, where they had them in the last step, and then there was nothing to be solved directly; nor is there now. */
int32_t cni_joint_lanes_tell(const cn_world *world);
/* The rows of a component's wide works, with the impulses of their records. */
void cni_joint_constraints_complete(const cn_world *world, const cni_sparse *sparse, const cni_component *c);

#endif
