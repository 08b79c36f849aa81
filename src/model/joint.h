/*
 * model/joint.h - joints: records, lists, events. What a joint type must provide is in joints/joint_type.h.
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

/* What direct solving remembers of a component: its joints carry it, so that islands may merge and split. */
typedef struct cni_joint_trust {
	float surplus;             /* joules: this joint's part of the energy that steps have gained: direct/rattle.c */
	uint32_t until;            /* the step until which what failed is not tried again */
	uint16_t span;             /* ... which was so many steps after the failure; 0: nothing has failed */
	uint16_t soft;             /* 1: it is soft until then; 0: it may be solved directly, but not by RATTLE */
} cni_joint_trust;

typedef struct cni_joint {
	int32_t type;              /* CN_JOINT_REVOLUTE ... CNI_JOINT_LINE */
	uint32_t flags;            /* CN_JOINT_* */
	int32_t body[2];           /* CNI_NONE: the world */
	int32_t next[2], prev[2];  /* keys in the bodies' lists: joint << 1 | side */
	int32_t awake;             /* index in the awake list, CNI_NONE */
	int32_t linked;            /* joins two dynamic bodies' islands */
	int32_t solver;            /* its own: CN_SOLVER_AUTO, _SOFT or _DIRECT */
	cni_vec2 anchor[2];        /* in the bodies' frames, or the world */
	float impulse[CNI_JOINT_ROWS]; /* accumulated, by row meaning of the type */
	float inv_h;               /* 1 / substep of the last step, to turn impulses into forces */
	float stiffness_hertz, stiffness_damping; /* of rigid rows and limits; 0: as stiff as the substeps allow */
	float force_max, torque_max;      /* of the same; 0: no bound */
	float break_force, break_torque;  /* 0: never */
	float p[CNI_JOINT_NUMBERS]; /* the type's own numbers; see the type's file */
	cni_joint_trust trust;
	uint64_t user_data;
} cni_joint;

/* Impulses that floats could not hold, among absurd forces, are forgotten: else every step would go on from them. */
static inline void cni_joint_keep_finite(cni_joint *j)
{
	float zero = 0.0f;
	int32_t k;
	for (k = 0; k < CNI_JOINT_ROWS; ++k)
		zero += 0.0f * j->impulse[k];
	for (k = 0; k < CNI_JOINT_ROWS && zero != 0.0f; ++k)
		j->impulse[k] = 0.0f;
}

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
/* Its impulses after the point's two. */
enum { CNI_REVOLUTE_SPRING = 2, CNI_REVOLUTE_MOTOR = 3, CNI_REVOLUTE_LIMIT = 4 };
enum { CNI_P_REVOLUTE_TARGET = 5, CNI_P_REVOLUTE_HERTZ = 6, CNI_P_REVOLUTE_DAMPING = 7 };
enum { CNI_P_DISTANCE_HERTZ = 5, CNI_P_DISTANCE_DAMPING = 6 };
enum { CNI_P_TARGET = 5, CNI_P_HERTZ = 6, CNI_P_DAMPING = 7, CNI_P_AXIS_X = 8, CNI_P_AXIS_Y = 9 };
enum { CNI_P_MOTOR_ANGLE = 0, CNI_P_MOTOR_OFFSET_X = 1, CNI_P_MOTOR_OFFSET_Y = 2 };
enum { CNI_P_GEAR_RATIO = 0, CNI_P_GEAR_PHASE = 1 };
enum { CNI_P_PULLEY_GROUND_A = 1, CNI_P_PULLEY_GROUND_B = 3, CNI_P_PULLEY_RATIO = 5 };
enum { CNI_P_RATCHET_PHASE = 0, CNI_P_RATCHET_CLICK = 1, CNI_P_RATCHET_LATCH = 2 };
enum { CNI_P_REST = 0, CNI_P_REST_HERTZ = 1, CNI_P_REST_DAMPING = 2 };
enum { CNI_P_GROOVE_END_X = 4, CNI_P_GROOVE_END_Y = 5 };
enum { CNI_P_LINE_TOLERANCE = 0 };
/* State of types that count turns: side s has its angle in (-pi, pi] and its whole turns here and after. */
enum { CNI_P_TURN = 6 };

/* Lanes of the last step, when all joints were in them: joints/joint_blocks.c. */
typedef struct cni_lanes_kept {
	int32_t lanes;   /* 0: nothing is kept */
	int32_t blocks;
	int32_t works;   /* most works there was room for: another number is another piece of memory */
	int32_t filled;  /* in this step so far */
	int32_t special; /* ... 1: some of them with bodies that cannot move along an axis, or new joints */
	int32_t alone;   /* 1: with this budget nothing of them was to be solved directly */
	int32_t budget;
} cni_lanes_kept;

/* Public handle: of kind joint, or constraint. */
uint32_t cni_joint_handle(const cn_world *world, int32_t joint);
/* Index of a live joint (constraint 0) or constraint (1), or CNI_NONE. Any 32 bits may come in. */
int32_t cni_joint_find(const cn_world *world, uint32_t handle, int32_t constraint);
/* Most blocks of lanes that so many joints fill: whole ones, and one begun in each colour. */
int32_t cni_joint_blocks_for(int32_t joints);
/* Room for extra more joints in records and lists. */
cn_result cni_joint_reserve(cn_world *world, int32_t extra);
/* Record `joint` (a taken slot) is filled in but for its lists: links it to bodies and islands, wakes,
   and ends contacts that it forbids (after cni_contact_reserve_end). */
void cni_joint_link(cn_world *world, int32_t joint);
/* Opposite; contacts that it forbade may come back at the next step. */
void cni_joint_unlink(cn_world *world, int32_t joint);
/* Unlinks and gives the slot back. */
void cni_joint_destroy(cn_world *world, int32_t joint);
/* Joints of a body. */
int32_t cni_joint_count(const cn_world *world, int32_t body);
/* Does some joint forbid contacts between these bodies? O(joints of the lesser body). */
int32_t cni_joint_forbids(const cn_world *world, int32_t body_a, int32_t body_b);
/* Neither of its bodies is disabled. */
int32_t cni_joint_is_enabled(const cn_world *world, const cni_joint *j);
void cni_joint_enter_awake_list(cn_world *world, int32_t joint);
void cni_joint_leave_awake_list(cn_world *world, int32_t joint);

/* ---- events ---- */

/* Room for the events of destroying this many joints with a body. */
int32_t cni_joint_reserve_events(cn_world *world, int32_t count);
/* Logs that a joint was stressed beyond its threshold or destroyed; 0 when there is no memory. */
int32_t cni_joint_event_log(cn_world *world, int32_t joint, float force, float torque, uint32_t destroyed);

#endif
