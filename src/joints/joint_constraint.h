/*
 * joints/joint_constraint.h - joint constraints: the step's working copies of awake joints. joints/joint_constraint.c makes their rows.
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
	CNI_CONSTRAINT_GROUNDS = 1u << 3,   /* d and e start at points of the world */
	CNI_CONSTRAINT_DIRECT = 1u << 4,    /* its rigid rows are solved with its neighbours': direct/direct_joints.c */
	CNI_CONSTRAINT_FINISHED = 1u << 5,  /* its whole step is done: direct/rattle.c */
	CNI_CONSTRAINT_BATCHED = 1u << 6,   /* in a lane of a batch, with its pin: direct/batched_trees.c */
	CNI_CONSTRAINT_TAUT = 1u << 7,      /* a rope whose limit, or a cylinder whose motor, may be solved with its neighbours' rows: direct/active_rows.c */
	CNI_CONSTRAINT_LOCK_A = 1u << 8,    /* body a has this locked axis: its CN_BODY_LOCK_X and _Y flags from here on */
	CNI_CONSTRAINT_LOCK_B = 1u << 10,
	CNI_CONSTRAINT_LOCKS = 15u << 8,
	CNI_CONSTRAINT_APART = 1u << 13,    /* it was made, put or changed so that a gap is beyond what its rows see: joint_gap_most */
	CNI_CONSTRAINT_TORN = 1u << 14,     /* ... a gap of a rigid row */
	CNI_CONSTRAINT_CENTRED = 1u << 15   /* a pin or weld that acts on both bodies at the middle of its gap */
};

/* Forms of lanes: joints/joint_pass.h. */
enum { CNI_FORM_NONE = 0, CNI_FORM_PIN, CNI_FORM_DISTANCE, CNI_FORMS };
/* Of the parts of a lane, beside CN_JOINT_SPRING, _MOTOR and _LIMIT: its angle or length is rigid. */
#define CNI_PART_HELD (1u << 31)

/* Data of joints that are solved by rows, alone or with others; most joints are in lanes and never read it. */
typedef struct cni_joint_numbers {
	cni_row rows[CNI_JOINT_ROWS];
	float inverse[6];          /* of the first rows' K: 00 01 02 11 12 22 */
	float single_mass[CNI_JOINT_ROWS];
	cni_soft soft;             /* springy: softness of the first rows and of limits */
	cni_soft spring;           /* of the spring or soft row, if there is one */
	float force_max, torque_max;       /* bounded: the bounds, FLT_MAX without one */
	float force_stress, torque_stress; /* breakable: largest reaction of the step so far */
} cni_joint_numbers;

/* Joint constraints are one array; their numbers follow behind its capacity. */
typedef struct cni_joint_constraint {
	const cni_joint *record;   /* records do not move within a step */
	cni_joint_rows_fn *make_rows; /* of its type */
	cni_row *rows;             /* in numbers */
	cni_joint_numbers *numbers;
	int32_t joint;
	int32_t ia, ib;            /* dense body indices, 0: static or the world */
	uint32_t flags;            /* CNI_CONSTRAINT_* */
	int32_t row_count;
	int32_t rigid_count;       /* the first rows: rigid or drive */
	int32_t next_plain;        /* the next joint constraint that is solved by rows */
	int32_t active_row;        /* index of the motor or limit row that is solved with the rigid rows: direct/active_rows.c; CNI_NONE: none */
	int32_t idle_row;          /* ... the motor or limit row along the same coordinate, which keeps its impulse meanwhile; CNI_NONE: none */
	int32_t lane;              /* block * CNI_LANES + lane, CNI_NONE: solved by rows */
	int32_t form;              /* CNI_FORM_*; with one, rows are built only if it is solved directly or gets no lane */
	cni_joint_frame start;     /* at the beginning of the step */
	uint32_t parts;            /* with a form: CN_JOINT_SPRING, _MOTOR, _LIMIT, CNI_PART_HELD */
	uint32_t kept_parts;       /* ... in the last step */
	int32_t kept_lane;         /* lane of the last step */
} cni_joint_constraint;

#define CNI_JOINT_CONSTRAINT_BYTES ((int32_t)(sizeof(cni_joint_constraint) + sizeof(cni_joint_numbers)))

static inline cni_joint_constraint *cni_joint_constraints(const cn_world *world)
{
	return (cni_joint_constraint *)world->joint_work.data;
}
/* 1: a rope, a distance joint with limits alone. */
static inline int32_t cni_joint_is_rope(const cni_joint *j)
{
	return j->type == CN_JOINT_DISTANCE && (j->flags & (CN_JOINT_SPRING | CN_JOINT_MOTOR | CN_JOINT_LIMIT)) == CN_JOINT_LIMIT;
}
/* 1: a cylinder, a distance joint with a motor. */
static inline int32_t cni_joint_is_cylinder(const cni_joint *j)
{
	return j->type == CN_JOINT_DISTANCE && (j->flags & CN_JOINT_MOTOR) && (j->flags & (CN_JOINT_SPRING | CN_JOINT_LIMIT)) && j->p[CNI_P_MOTOR_MAX] > 0.0f;
}
/* Flags a rope that may become taut within this time, and a cylinder. */
void cni_joint_rope_mark(const cn_world *world, cni_joint_constraint *w, float dt);
/* Metres for one unit of a row's error or speed, where it is compared with those of others: a radian counts as a length unit. */
static inline float cni_row_length(const cn_world *world, const cni_row *r)
{
	return r->angular ? world->settings.length_unit : 1.0f;
}
/* Greatest speed at which a row closes its error: that of overlaps. */
static inline float cni_row_push_speed(const cn_world *world, const cni_row *r)
{
	return world->settings.push_speed_max / cni_row_length(world, r);
}
/* Target speed of a motor, which does not pass a limit within the substep: a limit is soft and would give way to a strong motor. Beyond the
   limit it returns with the limit: rate is cni_soft_error_rate. */
static inline float cni_motor_target(const cni_row *r, float inv_h, float rate)
{
	float least = r->below * (r->below > 0.0f ? inv_h : rate), most = r->above * (r->above > 0.0f ? inv_h : rate);
	return cni_min(cni_max(r->target, -least), most);
}
/* Index of the entry for rows i and k in the inverse of the first rows' K. */
static inline int32_t cni_inverse_at(int32_t i, int32_t k)
{
	static const uint8_t at[CNI_JOINT_RIGID_ROWS][CNI_JOINT_RIGID_ROWS] = { { 0, 1, 2 }, { 1, 3, 4 }, { 2, 4, 5 } };
	return at[i][k];
}
/* The island of body a, or of body b if a is static or the world. */
static inline int32_t cni_joint_island(const cn_world *world, int32_t ia, int32_t ib)
{
	return cni_awake_island(world, ia != 0 ? ia : ib);
}
/* Sets up joint constraint k (place in the awake list) at the beginning of a step, to be solved by rows. */
void cni_joint_constraint_prepare(cn_world *world, const cni_solve *s, int32_t k);
/* Sets the fields that do not depend on the solver, except the frame's angle. */
void cni_joint_constraint_begin(cn_world *world, const cni_solve *s, int32_t k, const cni_joint *j);
/* ... then its rows, decoupled, with their impulses, if they have not been built yet. */
void cni_joint_rows_need(cn_world *world, const cni_solve *s, cni_joint_constraint *w);
/* Builds the rows of a pin or weld anew so that their impulses act at the middle of its gap for the rest of the step. */
void cni_joint_rows_centre(cn_world *world, const cni_solve *s, cni_joint_constraint *w);
/* At the end of a step: stores the rows' impulses, for the type's rows, in the record. */
void cni_joint_rows_end(const cn_world *world, const cni_joint_constraint *w, cni_joint *j);
/* Builds the rows at the bodies' new positions with their present impulses; the change of the impulses' response goes into start. */
void cni_joint_rows_renew(cn_world *world, const cni_solve *s, cni_joint_constraint *w);
/* What locked axes and rotations leave of the mobility of a row, or of a direction of a point, counts as none below this; 0: nothing is locked. */
typedef struct cni_mobility {
	float linear, angular; /* 1/kg, 1/(kg m^2) */
} cni_mobility;
cni_mobility cni_mobility_least(const cni_joint_constraint *w, const cni_motion *a, const cni_motion *b);
/* Inverse of the symmetric K of one to three rows, as numbers->inverse; a singular K has the inverse 0, with some mobility `least` only in its
   directions without mobility. Other counts: nothing. */
void cni_rows_invert(const cni_row *r, int32_t count, const cni_motion *a, const cni_motion *b, cni_mobility least, float *inv);
/* The type's rows without decoupling, for joints whose rows were built in this step and whose other rows are limits that cannot act;
   turns: rotations by the motions' theta. Leaves impulses undefined, and the other rows of pins as they were. */
void cni_joint_constraint_rows(cni_joint_constraint *w, const cni_motion *motions, const cni_rot *turns);
/* Predicts the errors of the rigid rows after a time h at the bodies' present velocities. */
void cni_joint_constraint_ahead(const cni_joint_constraint *w, const cni_motion *motions, float h, float *errors);
/* Records the largest reaction of the step. */
void cni_joint_constraint_stress(cni_joint_constraint *w, const cni_motion *motions, float inv_h);

#endif
