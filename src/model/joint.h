/*
 * model/joint.h - joints: records, lists, and what a joint type must provide.
 *
 * A type describes itself by rows: scalar constraints with a Jacobian, an error and bounds. Warm
 * starting, soft and rigid solving, reactions and error read-back work on rows and know no types, so a
 * new joint is one file with one function that writes rows and two that read it back.
 */
#ifndef CNI_MODEL_JOINT_H
#define CNI_MODEL_JOINT_H

#include "base/maths.h"

#define CNI_JOINT_ROWS 5 /* most rows of a joint */
#define CNI_JOINT_RIGID_ROWS 3 /* most rigid ones */

typedef struct cni_joint {
	int32_t type;              /* CN_JOINT_REVOLUTE ... */
	uint32_t flags;            /* CN_JOINT_* */
	int32_t body[2];           /* CNI_NONE: the world */
	int32_t next[2], prev[2];  /* keys in the bodies' lists: joint << 1 | side */
	int32_t awake;             /* index in the awake list, CNI_NONE */
	int32_t linked;            /* joins two dynamic bodies' islands */
	cni_vec2 anchor[2];        /* in the bodies' frames, or the world */
	float impulse[CNI_JOINT_ROWS]; /* accumulated, by row meaning of the type */
	float inv_h;               /* 1 / substep of the last step, to turn impulses into forces */
	float p[8];                /* the type's own numbers; see the type's file */
	uint64_t user_data;
} cni_joint;

/* Meaning of p[]. Revolute: reference, lower, upper, motor speed, motor torque max, spring target, hertz,
   damping ratio. Distance: length, min, max, motor speed, motor force max, hertz, damping ratio, 0. */
enum { CNI_P_REFERENCE = 0, CNI_P_LENGTH = 0, CNI_P_LOWER = 1, CNI_P_UPPER = 2, CNI_P_MOTOR_SPEED = 3, CNI_P_MOTOR_MAX = 4 };
enum { CNI_P_REVOLUTE_TARGET = 5, CNI_P_REVOLUTE_HERTZ = 6, CNI_P_REVOLUTE_DAMPING = 7 };
enum { CNI_P_DISTANCE_HERTZ = 5, CNI_P_DISTANCE_DAMPING = 6 };

cni_joint *cni_joint_at(const cn_world *world, int32_t joint);
/* Room for extra more joints in records and lists. */
cn_result cni_joint_reserve(cn_world *world, int32_t extra);
/* Record `joint` (a taken slot) is filled in but for its lists: links it to bodies and islands, wakes,
   and ends contacts that it forbids (after cni_contact_reserve_end). */
void cni_joint_link(cn_world *world, int32_t joint);
/* Opposite; contacts that it forbade may come back at the next step. */
void cni_joint_unlink(cn_world *world, int32_t joint);
/* Does some joint forbid contacts between these bodies? O(joints of the lesser body). */
int32_t cni_joint_forbids(const cn_world *world, int32_t body_a, int32_t body_b);
void cni_joint_enter_awake_list(cn_world *world, int32_t joint);
void cni_joint_leave_awake_list(cn_world *world, int32_t joint);

/* ---- rows ---- */

/* Where a joint's bodies are, in world directions. */
typedef struct cni_joint_frame {
	cni_vec2 ra, rb;   /* from the centres of mass to the anchors */
	cni_vec2 d;        /* anchor b - anchor a */
	cni_rot qa;        /* rotation of body a */
	float angle;       /* of b - of a - reference, in (-pi, pi] at the beginning of the step */
} cni_joint_frame;

enum {
	CNI_ROW_RIGID = 0, /* equality; all rigid rows of a joint are solved together and come first */
	CNI_ROW_SPRING = 1,
	CNI_ROW_MOTOR = 2,
	CNI_ROW_LIMIT = 3  /* impulse >= 0; error > 0 is room that is left */
};

/* speed = a . (va, wa) + b . (vb, wb), the rate of change of error. */
typedef struct cni_row {
	float ax, ay, aw;
	float bx, by, bw;
	float error;      /* metres or radians */
	float target;     /* motor: wanted speed */
	float limit;      /* motor: most force or torque; others: unused */
	float hertz, damping_ratio; /* spring */
	float impulse;    /* accumulated */
	uint8_t kind;     /* CNI_ROW_* */
	uint8_t angular;  /* 1: radians */
	uint8_t slot;     /* which of the record's impulses */
	uint8_t reserved;
} cni_row;

/* Writes the joint's rows for this frame, rigid ones first; impulses are not touched. Returns how many. */
typedef int32_t cni_joint_rows_fn(const cni_joint *j, const cni_joint_frame *f, cni_row *rows);
/* The same set of rows in the same order for a record whose numbers do not change (limits choose their
   side by the sign of the error and keep their slot). */
typedef struct cni_joint_type {
	cni_joint_rows_fn *rows;
	float (*position)(const cni_joint *j, const cni_joint_frame *f);
	cni_row (*speed_row)(const cni_joint *j, const cni_joint_frame *f);
} cni_joint_type;
extern const cni_joint_type cni_joint_revolute, cni_joint_distance;
const cni_joint_type *cni_joint_type_of(int32_t type);

/* The frame at the bodies' present poses. */
cni_joint_frame cni_joint_frame_make(const cn_world *world, const cni_joint *j);

/* ---- read-back ---- */

/* World positions of the two anchors. */
void cni_joint_anchors(const cn_world *world, const cni_joint *j, cni_vec2 *out_a, cni_vec2 *out_b);
void cni_joint_error(const cn_world *world, const cni_joint *j, float *out_m, float *out_rad);
float cni_joint_position(const cn_world *world, const cni_joint *j);
float cni_joint_speed(const cn_world *world, const cni_joint *j);
void cni_joint_reaction(const cn_world *world, const cni_joint *j, cn_vec2 *out_force, float *out_torque);

#endif
