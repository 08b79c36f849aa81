/*
 * model/joint.h - joints: records, lists, events. joints/joint_type.h has the interface of a joint type.
 */
#ifndef CNI_MODEL_JOINT_H
#define CNI_MODEL_JOINT_H

#include "base/maths.h"

#define CNI_JOINT_ROWS 5 /* most rows of a joint */
#define CNI_JOINT_RIGID_ROWS 3 /* most of those that are solved together */
#define CNI_JOINT_NUMBERS 10

/* Types after the public joint types: constraints on one body, which are joints with the world as body a. */
enum {
	CNI_JOINT_ANGLE = CN_JOINT_FILTER + 1,
	CNI_JOINT_LINE,
	CNI_JOINT_TYPES
};
static inline int32_t cni_joint_is_constraint(int32_t type) { return type >= CNI_JOINT_ANGLE; }

/* Memory of failed direct solutions. Joints carry it, not components, so that it survives merging and splitting of islands. */
typedef struct cni_joint_trust {
	float surplus;             /* joules: this joint's share of the energy that steps have gained: direct/rattle.c */
	uint32_t until;            /* the failed solver is not tried again before this step; not in the awake list: counted from when it left */
	uint16_t span;             /* steps from the failure to that step; 0: nothing has failed */
	uint8_t soft;              /* 1: soft until then; 0: may be solved directly, but not by RATTLE */
	uint8_t direct;            /* 1: its rows were solved directly in the last step */
} cni_joint_trust;

typedef struct cni_joint {
	int32_t type;              /* CN_JOINT_REVOLUTE ... CNI_JOINT_LINE */
	uint32_t flags;            /* CN_JOINT_* */
	int32_t body[2];           /* CNI_NONE: the world */
	int32_t next[2], prev[2];  /* keys in the bodies' lists: joint << 1 | side */
	int32_t awake;             /* index in the awake list, CNI_NONE */
	uint16_t linked;           /* 1: links two dynamic bodies' islands */
	uint16_t apart;            /* 1: made, put or changed so that it may have a gap: apart_begin in joints/joint_constraint.c */
	int32_t solver;            /* its own: CN_SOLVER_AUTO, _SOFT or _DIRECT */
	cni_vec2 anchor[2];        /* in the bodies' frames, or the world */
	float impulse[CNI_JOINT_ROWS]; /* accumulated, by row meaning of the type */
	float inv_h;               /* 1 / substep of the last step, to turn impulses into forces */
	float stiffness_hertz, stiffness_damping; /* of rigid rows and limits; 0: as stiff as the substeps allow */
	float force_max, torque_max;      /* of rigid rows and limits; 0: no bound */
	float break_force, break_torque;  /* 0: never */
	float p[CNI_JOINT_NUMBERS]; /* numbers of the type: CNI_P_ */
	cni_joint_trust trust;
	uint64_t user_data;
} cni_joint;

/* Impulses that floats could not hold, among absurd forces, are forgotten: else every step would go on from them. */
static inline void cni_joint_keep_finite(cni_joint *j)
{
	float zero = 0.0f;
	for (int32_t k = 0; k < CNI_JOINT_ROWS; ++k)
		zero += 0.0f * j->impulse[k];
	for (int32_t k = 0; k < CNI_JOINT_ROWS && zero != 0.0f; ++k)
		j->impulse[k] = 0.0f;
}

/* Sum of the first `count` impulses, N s; those of angles are on arms of a length unit. */
float cni_joint_impulse_sum(const cn_world *world, const cni_joint *j, int32_t count);

/* Meaning of p[], 0 where a type does not use it.

     type            0          1        2        3      4    5         6        7        8       9
     revolute        reference  lower    upper    speed  max  target    hertz    damping
     distance        length     min      max      speed  max  hertz     damping
     fixed           reference                                          hertz    damping
     prismatic       reference  lower    upper    speed  max  target    hertz    damping  axis x  axis y
     wheel                      lower    upper    speed  max            hertz    damping  axis x  axis y
     motor           angle      offset x offset y                       hertz    damping
     mouse                                                              hertz    damping
     gear            ratio      phase                                   angle a  turns a  angle b turns b
     pulley          length     ground a x, y     ground b x, y         ratio
     ratchet         phase      click    latch                          angle a  turns a  angle b turns b
     rotary spring   rest       hertz    damping                        angle a  turns a  angle b turns b
     groove                     0        length          end x, y                         axis x  axis y
     angle           reserved   lower    upper                          angle a  turns a  angle b turns b
     line            tolerance  lower    upper                                            axis x  axis y  */
enum { CNI_P_REFERENCE = 0, CNI_P_LENGTH = 0, CNI_P_LOWER = 1, CNI_P_UPPER = 2, CNI_P_MOTOR_SPEED = 3, CNI_P_MOTOR_MAX = 4 };
enum { CNI_P_DISTANCE_HERTZ = 5, CNI_P_DISTANCE_DAMPING = 6 };
enum { CNI_P_TARGET = 5, CNI_P_HERTZ = 6, CNI_P_DAMPING = 7, CNI_P_AXIS_X = 8, CNI_P_AXIS_Y = 9 };
enum { CNI_P_MOTOR_ANGLE = 0, CNI_P_MOTOR_OFFSET_X = 1, CNI_P_MOTOR_OFFSET_Y = 2 };
enum { CNI_P_GEAR_RATIO = 0, CNI_P_GEAR_PHASE = 1 };
enum { CNI_P_PULLEY_GROUND_A = 1, CNI_P_PULLEY_GROUND_B = 3, CNI_P_PULLEY_RATIO = 5 };
enum { CNI_P_RATCHET_PHASE = 0, CNI_P_RATCHET_CLICK = 1, CNI_P_RATCHET_LATCH = 2 };
enum { CNI_P_REST = 0, CNI_P_REST_HERTZ = 1, CNI_P_REST_DAMPING = 2 };
enum { CNI_P_GROOVE_END_X = 4, CNI_P_GROOVE_END_Y = 5 };
enum { CNI_P_LINE_TOLERANCE = 0 };
/* State of types that count whole turns: for side s, the angle in (-pi, pi] at CNI_P_TURN + 2 s and the turns after it. */
enum { CNI_P_TURN = 6 };

/* Lanes of the last step, if all joints were in lanes: joints/joint_blocks.c. */
typedef struct cni_lanes_kept {
	int32_t lanes;   /* 0: nothing to reuse */
	int32_t blocks;
	int32_t works;   /* capacity for joint constraints: another capacity means other memory */
	int32_t filled;  /* filled in this step so far */
	int32_t special; /* 1: some of these are new joints or taut ropes */
	int32_t alone;   /* 1: with this budget, direct solving takes none of them */
	int32_t budget;
} cni_lanes_kept;

/* Public handle, of kind joint or constraint. */
uint32_t cni_joint_handle(const cn_world *world, int32_t joint);
/* Index of a live joint (constraint 0) or constraint (1), or CNI_NONE. Accepts any 32 bits. */
int32_t cni_joint_find(const cn_world *world, uint32_t handle, int32_t constraint);
/* Upper bound of the blocks that so many joints fill: full ones, and a partial block of each form for each colour. */
int32_t cni_joint_blocks_for(int32_t joints);
/* Reserves memory for extra more joints in records and lists. */
cn_result cni_joint_reserve(cn_world *world, int32_t extra);
/* Record `joint` (a taken slot) is complete except for its lists: links it to bodies and islands, wakes them, and ends contacts that it
   forbids (after cni_contact_reserve_end). */
void cni_joint_link(cn_world *world, int32_t joint);
/* Opposite; contacts that it forbade may return in the next step. */
void cni_joint_unlink(cn_world *world, int32_t joint);
/* Unlinks and frees the slot. */
void cni_joint_destroy(cn_world *world, int32_t joint);
/* Number of joints of a body. */
int32_t cni_joint_count(const cn_world *world, int32_t body);
/* Does some joint forbid contacts between these bodies? O(joints of the body with fewer). */
int32_t cni_joint_forbids(const cn_world *world, int32_t body_a, int32_t body_b);
/* Are both of its bodies enabled? */
int32_t cni_joint_is_enabled(const cn_world *world, const cni_joint *j);
void cni_joint_wake_bodies(cn_world *world, const cni_joint *j);
void cni_joint_enter_awake_list(cn_world *world, int32_t joint);
void cni_joint_leave_awake_list(cn_world *world, int32_t joint);

/* ---- events ---- */

/* Reserves memory for the events of destroying this many joints with a body. */
int32_t cni_joint_reserve_events(cn_world *world, int32_t count);
/* Logs that a joint was stressed beyond its threshold or destroyed. */
void cni_joint_event_log(cn_world *world, int32_t joint, float force, float torque, uint32_t destroyed);

#endif
