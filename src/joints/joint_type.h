/*
 * joints/joint_type.h - the interface of a joint type, and read-back of a joint's state.
 *
 * A type describes itself by rows: scalar constraints with a Jacobian, an error and bounds. Warm starting, soft and rigid solving,
 * reactions and error read-back work on rows and do not depend on the type, so a new joint is a function that writes rows and two that read
 * it back. Most revolute, fixed and distance joints are solved without rows: joints/joint_blocks.c.
 */
#ifndef CNI_JOINTS_JOINT_TYPE_H
#define CNI_JOINTS_JOINT_TYPE_H

#include "model/world.h"

/* ---- rows ---- */

/* Relative placement of a joint's bodies, in world directions. */
typedef struct cni_joint_frame {
	cni_vec2 ra, rb;   /* from the centres of mass to the anchors */
	cni_vec2 d;        /* anchor b - anchor a; pulley: anchor a - ground a */
	cni_vec2 e;        /* pulley only: anchor b - ground b */
	cni_rot qa;        /* rotation of body a */
	float angle;       /* of b - ratio * of a - reference; (-pi, pi] at the beginning of the step unless turns count */
	float ratio;       /* 1, or a gear's */
} cni_joint_frame;

enum {
	CNI_ROW_RIGID = 0, /* equality; a joint's rigid and drive rows come first and are solved together */
	CNI_ROW_SPRING = 1, /* true period and decay */
	CNI_ROW_MOTOR = 2,
	CNI_ROW_LIMIT = 3, /* impulse >= 0; error > 0 is the remaining gap */
	CNI_ROW_SOFT = 4,  /* true deflection, stable at any stiffness; bounded by limit if that is > 0 */
	CNI_ROW_DRIVE = 5  /* a spring among the first rows; a joint has either rigid or drive rows */
};

typedef struct cni_row {
	cni_lever lever;  /* speed along it: the rate of change of error */
	float error;      /* metres or radians */
	float target;     /* motor: target speed */
	float limit;      /* motor: most force or torque; soft: the same, 0: no bound */
	float below, above; /* motor: the ways to the limits of its coordinate */
	float hertz, damping_ratio; /* spring, soft, drive */
	float impulse;    /* accumulated */
	uint8_t kind;     /* CNI_ROW_* */
	uint8_t angular;  /* 1: radians */
	uint8_t slot;     /* index among the record's impulses */
	uint8_t reserved;
} cni_row;

/* Writes the joint's rows for this frame, rigid or drive ones first, and leaves impulses unchanged. Returns the number of rows. */
typedef int32_t cni_joint_rows_fn(const cni_joint *j, const cni_joint_frame *f, cni_row *rows);

/* The joint's position for users, and a row along which its speed is measured (its kind and slot have no meaning). */
typedef float cni_joint_position_fn(const cni_joint *j, const cni_joint_frame *f);
typedef cni_row cni_joint_speed_fn(const cni_joint *j, const cni_joint_frame *f);

/* Optional parts of a type's frame; the others are not computed. */
enum {
	CNI_USES_ANGLE = 1u << 0,     /* angle, wrapped at the beginning of the step */
	CNI_USES_REFERENCE = 1u << 1, /* p[CNI_P_REFERENCE] is subtracted from angle */
	CNI_USES_TURNS = 1u << 2,     /* angle counts whole turns: CNI_P_TURN */
	CNI_USES_RATIO = 1u << 3,     /* ratio is p[CNI_P_GEAR_RATIO] */
	CNI_USES_GROUNDS = 1u << 4,   /* d and e start at two points of the world */
	CNI_USES_DRIVE = 1u << 5      /* (for the solver) its first rows are drive rows */
};

/* The rows are the same in the same order for a record whose numbers do not change (limits choose their side by the sign of the error and
   keep their slot). */
typedef struct cni_joint_type {
	cni_joint_rows_fn *rows;
	cni_joint_position_fn *position;
	cni_joint_speed_fn *speed_row;
	uint32_t uses;
} cni_joint_type;
extern const cni_joint_type cni_joint_types[CNI_JOINT_TYPES];
static inline const cni_joint_type *cni_joint_type_of(int32_t type) { return &cni_joint_types[type]; }
/* Those of revolute joints. */
cni_joint_rows_fn cni_joint_revolute_rows;

/* From one point to the other, whose distance is d, and its length; coinciding points have an arbitrary fixed axis. */
static inline cni_vec2 cni_distance_axis(cni_vec2 d, float *out_length)
{
	*out_length = cni_length(d);
	return *out_length > 1e-9f ? cni_mul(1.0f / *out_length, d) : cni_v(1.0f, 0.0f);
}
/* Turns the two rows of a point of b held at a point of a, seen from the centres of mass at ra and rb. */
static inline void cni_rows_point_turn(cni_row *rows, cni_vec2 ra, cni_vec2 rb, cni_vec2 gap)
{
	rows[0].lever.aw = ra.y;
	rows[0].lever.bw = -rb.y;
	rows[0].error = gap.x;
	rows[1].lever.aw = -ra.x;
	rows[1].lever.bw = rb.x;
	rows[1].error = gap.y;
}

/* ... whose impulses act on both bodies at the middle of the gap, so that they turn nothing that holds together. */
static inline void cni_rows_point_centre(cni_row *rows, cni_vec2 gap)
{
	rows[0].lever.aw += 0.5f * gap.y;
	rows[0].lever.bw += 0.5f * gap.y;
	rows[1].lever.aw -= 0.5f * gap.x;
	rows[1].lever.bw -= 0.5f * gap.x;
}

/* Rotation of the body on a side; of the world, none. */
static inline cni_rot cni_joint_side_rotation(const cn_world *world, const cni_joint *j, int32_t side)
{
	cni_rot none = { 1.0f, 0.0f };
	return j->body[side] == CNI_NONE ? none : cni_body_at(world, j->body[side])->q;
}
/* The frame at the bodies' present poses, with angle 0. */
cni_joint_frame cni_joint_frame_place(const cn_world *world, const cni_joint *j);
/* The angle at the bodies' present poses. */
float cni_joint_frame_angle(const cn_world *world, const cni_joint *j);
/* Both. */
cni_joint_frame cni_joint_frame_make(const cn_world *world, const cni_joint *j);

/* ---- turns ---- */

/* Starts counting at the bodies' present angles in (-pi, pi]; sets the latch of a ratchet. */
void cni_joint_turns_begin(const cn_world *world, cni_joint *j);
/* Sets the latch of a ratchet at the present angle. */
void cni_joint_ratchet_begin(const cn_world *world, cni_joint *j);
/* At the end of a step, before poses are updated: counts the bodies' rotation in it, and moves a ratchet's latch. */
void cni_joint_turns_advance(const cn_world *world, cni_joint *j, float theta_a, float theta_b);
/* angle b - ratio * angle a over whole turns, at these rotations. */
float cni_joint_turned(const cni_joint *j, cni_rot qa, cni_rot qb, float ratio);

/* ---- read-back ---- */

/* World positions of the two anchors. */
void cni_joint_anchors(const cn_world *world, const cni_joint *j, cni_vec2 *out_a, cni_vec2 *out_b);
void cni_joint_error(const cn_world *world, const cni_joint *j, float *out_m, float *out_rad);
float cni_joint_position(const cn_world *world, const cni_joint *j);
float cni_joint_speed(const cn_world *world, const cni_joint *j);
void cni_joint_reaction(const cn_world *world, const cni_joint *j, cn_vec2 *out_force, float *out_torque);
/* Sum of the rows' impulses on body b: along x and y, and about its anchor. */
void cni_rows_impulse(const cni_row *rows, int32_t count, cni_vec2 rb, cni_vec2 *out_linear, float *out_angular);

#endif
