/*
 * model/body.h - the body record, the dense arrays of awake bodies, and the operations on a body.
 *
 * A body's record has a stable slot (the index in its handle). The data of the solver is in dense arrays of awake bodies only,
 * so that a sleeping or static body costs a step nothing:
 *
 *   records  [b0][b1][b2][b3]...                 stable, paged; pose always, velocity between steps
 *   motion   [dummy][b3][b0]...                  cni_motion: velocity, inverse mass, change of pose this step
 *   start    [dummy][b3][b0]...                  cni_velocity_start: velocity right after integration
 *   external [dummy][b3][b0]...                  cni_external: force for this step, then acceleration
 *   awake_id [ -1  ][ 3][ 0]...                  back to the record
 *
 * Dense index 0 is a dummy of infinite mass that never moves: it stands for every static body, for the world in joints, and for
 * padding lanes. body.awake is the dense index, 0 when the body has none.
 *
 * Positions are sums of a high and a low float, so that slow motion far from the origin is not lost; everything relative is
 * computed from differences of both parts.
 */
#ifndef CNI_MODEL_BODY_H
#define CNI_MODEL_BODY_H

#include "base/blocks.h"
#include "base/maths.h"
#include "linear/lever.h"
#include "base/threads.h"
#include "model/tuning.h"

#include <string.h>

/* Internal bits of cni_body.flags, above the public CN_BODY_ ones. */
enum {
	CNI_BODY_KICKED = 1u << 13,        /* is in cn_world.kicked */
	CNI_BODY_MIXED = 1u << 14,         /* its contacts with static bodies are not all at the front of its list: it has had many */
	CNI_BODY_IN_AREA = 1u << 15,       /* an area gave its acceleration in the last step */
	CNI_BODY_MASS_OVERRIDE = 1u << 16, /* mass data was set by the user */
	CNI_BODY_MOVED = 1u << 17,         /* pose changed in the last step */
	CNI_BODY_MARK = 1u << 18,          /* scratch for batch calls and searches; clear outside of them */
	CNI_BODY_SOLVER_SOFT = 1u << 19,   /* the body's own solver; neither bit: CN_SOLVER_AUTO */
	CNI_BODY_SOLVER_DIRECT = 1u << 20,
	CNI_BODY_AT_STATIC = 1u << 21,     /* has had contacts with static bodies, touching or not, since its last pose was set */
	CNI_BODY_AGAIN = 1u << 22,         /* its new pairs may already have a contact: see CNI_PAIRS_MARKED */
	CNI_BODY_SET_DOWN = 1u << 23,      /* a body without an island got a load-bearing contact in this step */
	CNI_BODY_AHEAD = 1u << 24          /* its boxes were checked at the end of the last step and include the way ahead (last step's dt
	                                      times its velocity) plus its room */
};

#define CNI_BODY_OF_A_STEP (CNI_BODY_MOVED | CNI_BODY_IN_AREA) /* cleared at the beginning of a step */

typedef struct cni_body {
	float cx, cy;            /* centre of mass in the world, high part */
	float cx_low, cy_low;    /* low part: the true centre is the sum */
	cni_rot q;
	cni_vec2 local_center;   /* of mass, in the body's frame */
	float extent;            /* farthest surface point from the centre of mass */
	uint32_t flags;          /* CN_BODY_ (AWAKE bit unused) and CNI_BODY_ */
	int32_t awake;           /* dense index, 0: not awake; the fields up to here are read for every contact */
	uint8_t type;            /* CN_BODY_STATIC ... */
	uint8_t turn_reach;      /* how far turning moves its shapes, as a part of extent in CNI_TURN_REACH_UNIT: cni_body_turn_reach */
	uint16_t room;           /* distance by which its boxes enclose its shapes on all sides, at least: cni_body_room */
	float vx, vy, w;         /* between steps; read through cni_body_velocity. The fields up to here are read for pairs that are apart */
	float mass, inertia;     /* of a dynamic body (mass > 0, inertia >= 0, 0 = never rotates); 0 for others */
	float linear_damping, angular_damping;
	float gravity_scale;
	float sleep_speed;       /* CN_DEFAULT: the world's */
	float sleep_time;        /* seconds at rest */
	float gain;              /* metres that changes of speed have moved it by in this time: cni_body_gains; ignored at time 0 */
	float core;              /* smallest inner radius of its shapes: a shorter jump cannot pass through things */
	int32_t island;          /* CNI_NONE: alone */
	int32_t island_next, island_prev;
	int32_t shape_first;     /* shape index, linked by cni_shape.next */
	int32_t joint_first;     /* key = joint << 1 | side */
	int32_t contact_first;   /* key = contact << 1 | side */
	int32_t contact_count;
	uint32_t colors;         /* colours of its contacts, as bits */
	int32_t lanes;           /* touching contacts in lanes */
	cni_ref name;            /* zero-terminated in the world's blocks; 0: none */
	uint64_t user_data;
} cni_body;

/* Times in a row, while it was slow, that it gained too much speed to be at rest: the flags' highest bits. */
#define CNI_BODY_GAINS_SHIFT 25
#define CNI_BODY_GAINS_MOST 127u

/* Resets the rest timer: the body is not slow, or was woken. */
static inline void cni_body_restless(cni_body *b)
{
	b->sleep_time = 0.0f;
	b->flags &= (1u << CNI_BODY_GAINS_SHIFT) - 1u;
}

#define CNI_TURN_REACH_UNIT (1.0f / 255.0f)

/* Resets displacements and velocities that are not finite: the body stays at its pose, at rest. Returns 1 if there were some. */
static inline uint32_t cni_motion_keep_finite(cni_motion *m)
{
	float zero = 0.0f * m->vx + 0.0f * m->vy + 0.0f * m->w + 0.0f * m->dpx + 0.0f * m->dpy + 0.0f * m->theta;
	if (zero == 0.0f)
		return 0;
	m->vx = m->vy = m->w = m->dpx = m->dpy = m->theta = 0.0f;
	return 1;
}

typedef struct cni_velocity_start {
	float vx, vy, w;
	float jumped; /* 1 or more: an impact changed the velocity in this substep, in later sweeps more */
} cni_velocity_start;

static inline void cni_start_add(cni_velocity_start *start, const cni_motion *change, float part)
{
	start->vx += part * change->vx;
	start->vy += part * change->vy;
	start->w += part * change->w;
}

enum {
	CNI_EXTERNAL_FREE = 1u << 0,    /* no contacts, no joints: integrated once, exactly, for the whole step */
	CNI_EXTERNAL_DAMPED = 1u << 1,  /* has damping: factors are in the record */
	CNI_EXTERNAL_LOCK_X = 1u << 2,  /* velocity along x is cleared in every substep */
	CNI_EXTERNAL_LOCK_Y = 1u << 3,
	CNI_EXTERNAL_JOINTED = 1u << 4, /* has joints: positions use end velocities */
	CNI_EXTERNAL_TOUCHED = 1u << 5, /* has contacts in lanes */
	CNI_EXTERNAL_FINISHED = 1u << 6,   /* integrated for the whole step: by its joints alone (direct/rattle.c), or at rest
	                                      (step/early_rest.c) */
	CNI_EXTERNAL_DEFERRED = 1u << 7,   /* scratch of a stage, clear outside: marked by a first loop, which workers may share, for a
	                                      second loop in order */
	CNI_EXTERNAL_SETTLED = 1u << 8, /* slow for CNI_SETTLED_DELAYS */
	CNI_EXTERNAL_COLOR_SHIFT = 9    /* bits 9 .. 31: colours of its joints in this step: joints/joint_blocks.c */
};
typedef struct cni_external {
	float ax, ay, alpha; /* between steps: the user's force and torque for the next one; within a step:
	                        acceleration by gravity, force and torque, locked axes are 0 */
	uint32_t flags;
} cni_external;

/* Pose before the last step of cn_world_update, for interpolation. */
typedef struct cni_previous {
	float x, y, c, s;  /* origin and rotation */
	cn_body body;      /* 0: none */
	uint32_t step;     /* step count at which it is the previous pose */
} cni_previous;

/* Atomic access for the narrowphase, whose workers set CNI_BODY_AT_STATIC concurrently. */
static inline uint32_t cni_body_flags(const cni_body *b) { return cni_atomic_peek(&b->flags); }
static inline void cni_body_mark_static(cni_body *b)
{
	uint32_t flags = cni_body_flags(b);
	if (!(flags & CNI_BODY_AT_STATIC))
		cni_atomic_put(&b->flags, flags | CNI_BODY_AT_STATIC);
}

/* CN_SOLVER_AUTO, _SOFT or _DIRECT. */
static inline int32_t cni_body_solver(const cni_body *b)
{
	return b->flags & CNI_BODY_SOLVER_SOFT ? CN_SOLVER_SOFT : b->flags & CNI_BODY_SOLVER_DIRECT ? CN_SOLVER_DIRECT : CN_SOLVER_AUTO;
}

/* All take a live body index. Those that return cn_result change nothing when they fail. */

void cni_body_set_solver(cn_world *world, cni_body *b, int32_t solver);

static inline cni_vec2 cni_body_origin(const cni_body *b)
{
	cni_vec2 r = cni_rotate(b->q, b->local_center);
	return cni_v(b->cx - r.x + b->cx_low, b->cy - r.y + b->cy_low);
}
/* Maps the body's local frame to the world (high parts only). */
static inline cni_transform cni_body_transform(const cni_body *b)
{
	cni_transform x = { b->q, cni_body_origin(b) };
	return x;
}
static inline cn_pose cni_body_pose(const cni_body *b)
{
	cn_pose pose = { cni_body_origin(b), b->q.c, b->q.s };
	return pose;
}
/* Lever arm from the centre of mass to a world point: high part first, then low, which keeps all digits far from the origin. */
static inline cni_vec2 cni_body_arm(const cni_body *b, cni_vec2 point)
{
	return cni_sub(cni_sub(point, cni_v(b->cx, b->cy)), cni_v(b->cx_low, b->cy_low));
}
/* Points between the world and the body's frame, by the arm. */
static inline cni_vec2 cni_body_to_local(const cni_body *b, cni_vec2 point)
{
	return cni_add(cni_unrotate(b->q, cni_body_arm(b, point)), b->local_center);
}
static inline cni_vec2 cni_body_to_world(const cni_body *b, cni_vec2 local)
{
	cni_vec2 r = cni_rotate(b->q, cni_sub(local, b->local_center));
	return cni_v(b->cx + (r.x + b->cx_low), b->cy + (r.y + b->cy_low));
}
/* Vector from centre a to centre b, without losing digits far from the origin. */
static inline cni_vec2 cni_body_a_to_b(const cni_body *a, const cni_body *b)
{
	return cni_v((b->cx - a->cx) + (b->cx_low - a->cx_low), (b->cy - a->cy) + (b->cy_low - a->cy_low));
}
cn_velocity cni_body_velocity(const cn_world *world, const cni_body *b);
/* ... of its material at a world point. */
cni_vec2 cni_body_velocity_at(const cn_world *world, const cni_body *b, cni_vec2 point);
/* After the velocity was set from outside: the boxes are stretched along it before the next step. */
void cni_body_kick(cn_world *world, int32_t body);
/* The room, in metres; 0: unknown. Stored as the upper half of a float, which rounds down. */
static inline float cni_body_room(const cni_body *b)
{
	return cni_float_of((uint32_t)b->room << 16);
}
static inline void cni_body_set_room(cni_body *b, float room)
{
	b->room = (uint16_t)(cni_bits_of(cni_max(room, 0.0f)) >> 16);
}
/* After shapes or boxes were changed outside of a step. */
static inline void cni_body_forget_room(cni_body *b)
{
	b->room = 0;
	b->flags &= ~(uint32_t)CNI_BODY_AHEAD;
}
/* Turning by a small angle moves the shapes by at most this times the angle: the rounding radius around their points turns in place. 0
   for a wheel. */
static inline float cni_body_turn_reach(const cni_body *b) { return b->extent * ((float)b->turn_reach * CNI_TURN_REACH_UNIT); }
/* Do extent and turn reach span a shape? Of chains and static bodies they are not asked. */
int32_t cni_body_spans(const cn_world *world, const cni_body *b, int32_t shape);
/* What a step's displacement takes from the room: the shapes move by at most this, rounding errors included. */
static inline float cni_body_reach(const cni_body *b, float dpx, float dpy, float theta)
{
	return cni_max(cni_abs(dpx), cni_abs(dpy)) + cni_abs(theta) * cni_body_turn_reach(b) + CNI_BODY_ROUNDING * (cni_abs(b->cx) + cni_abs(b->cy) + b->extent);
}
/* Do the boxes certainly contain the shapes now and after ahead? True for most bodies, which spares reading shapes and boxes. */
static inline int32_t cni_body_has_room(const cni_body *b, cni_vec2 ahead)
{
	return cni_body_room(b) > cni_max(cni_abs(ahead.x), cni_abs(ahead.y));
}
enum { CNI_BOXES_NONE = -1, CNI_BOXES_SEVERAL = -2 };
/* Sets the boxes that do not contain the body's shapes now and after ahead (metres), and tells the broadphase of `tell`. NULL: writes the
   body and its proxies only; then cni_body_boxes_tell must follow with the result, the proxy with a new box or _SEVERAL, unless it is _NONE. */
int32_t cni_body_boxes_set(const cn_world *world, cni_body *b, cni_vec2 ahead, cn_world *tell);
void cni_body_boxes_tell(cn_world *world, const cni_body *b, int32_t set);
/* Does not wake. Locked axes are zeroed. */
void cni_body_store_velocity(cn_world *world, cni_body *b, cn_velocity v);

/* Initialises record `body` (a taken slot) at rest, in no list; pose from the definition. Cannot fail. */
void cni_body_init(cn_world *world, int32_t body, const cn_body_def *def);
/* Reserves memory for extra movable bodies in every array by dense index. */
cn_result cni_body_reserve(cn_world *world, int32_t extra);

/* Adds a non-static, enabled body to the dense arrays or removes it (and updates references to the body that fills its place). Contacts
   and islands are untouched: cni_body_wake and cni_body_put_to_sleep do everything. */
void cni_body_enter_awake(cn_world *world, int32_t body);
void cni_body_leave_awake(cn_world *world, int32_t body);

/* Recomputes mass, centre, inertia and extent from the shapes (or keeps an override), keeps the origin in place and the velocity of the
   material, and updates the dense inverse masses. */
void cni_body_update_mass(cn_world *world, int32_t body);
/*
 * The same after the shape `added` was linked, or (CNI_NONE) one unlinked. A static body may be a level of thousands of tiles: its time is
 * independent of them, and its extent never shrinks until cni_body_update_mass recomputes it. To a moving body of many shapes one is
 * added likewise: its mass, centre and inertia are then off by rounding, its extent is not too small, and the next step recomputes them
 * (cni_body_masses_settle).
 */
void cni_body_shapes_changed(cn_world *world, int32_t body, int32_t added);
/* Before a shape of the body is unlinked or changes. Returns 1 if the body's numbers are those of its other shapes now; otherwise they must be
   computed when the shape has gone or changed. */
int32_t cni_body_shape_leaves(cn_world *world, int32_t body, int32_t shape);
/* After the shape has changed; left: what cni_body_shape_leaves returned before. */
void cni_body_shape_replaced(cn_world *world, int32_t body, int32_t shape, int32_t left);
/* Recomputes all that cni_body_shapes_changed has estimated. */
void cni_body_masses_settle(cn_world *world);
/* Moves the centre of mass within the body: the origin stays, the material keeps its velocity. */
void cni_body_set_center(cn_world *world, cni_body *b, cni_vec2 local_center);
/* Writes inv_mass, inv_inertia (locks, type) to the dense array if awake. */
void cni_body_refresh_motion(cn_world *world, cni_body *b);
/* Sets origin and rotation; updates the broadphase boxes of its shapes. */
void cni_body_set_transform(cn_world *world, int32_t body, cni_vec2 origin, cni_rot q);
/* After a change of pose: moves the fat boxes that no longer contain their shapes. */
void cni_body_refresh_boxes(cn_world *world, int32_t body);

/* A record as floats for kernels, and a zero record for the world and for unused lanes. */
extern const cni_body cni_body_none;

static inline const float *cni_record_floats(const cni_body *b)
{
	return (const float *)(const void *)b;
}

#endif
