/*
 * joints/joint_pass.h - blocks of joints, and the data that joint_blocks.c passes to a kernel.
 *
 * A block is 16 lanes of one form, structure of arrays, filled anew in every step from joints that nothing bounds, softens or breaks; the
 * assignment of joints to lanes may be kept (joints/joint_blocks.c). Colours are as of contacts: no movable body appears twice in one. When
 * the colours of a body are used up, its further joints are solved by the rows of joints/joint_solve.c.
 *
 *   form        joints            point         measure, which springs, motors, limits and held lanes act on
 *   pin         revolute, fixed   x and y       angle
 *   distance    distance          -             length along the axis
 *
 *   point     ra0 rb0 d0   arms and gap at the beginning of the step       ra rb e   as of the last relax pass
 *             j            impulse on body b, all of it: including the pin impulses of springs, motors and limits
 *             induced      (batches) pin impulses of springs, motors and limits in the soft pass
 *   axis      ra rb as above; e: the axis, a unit vector from body a's point to body b's
 *   measure   angle0 and measure as above; bounds and coefficients; impulses of spring, motor and limit, all on body b: torques, or forces
 *             along the axis (limit: > 0 the lower one's, < 0 the upper one's)
 *   held      (bits of lanes) the measure is rigid: the angle of a weld, the length of a rod. Its impulse is the spring's, with the
 *             coefficients of rigid joints, and it is solved in the relax pass too
 *
 * Blocks of a batch (direct/batched_trees.c) are in no colour; `direct` has the lanes whose pins the batch solves.
 */
#ifndef CNI_JOINTS_JOINT_PASS_H
#define CNI_JOINTS_JOINT_PASS_H

#include "joints/joint_constraint.h"

typedef struct cni_joint_block {
	int32_t ia[CNI_LANES], ib[CNI_LANES];  /* dense body indices */
	float ai[CNI_LANES], bi[CNI_LANES];    /* inverse inertias */
	float ax0[CNI_LANES], ay0[CNI_LANES], bx0[CNI_LANES], by0[CNI_LANES];
	float dx0[CNI_LANES], dy0[CNI_LANES];
	float ax[CNI_LANES], ay[CNI_LANES], bx[CNI_LANES], by[CNI_LANES];
	float ex[CNI_LANES], ey[CNI_LANES];
	float jx[CNI_LANES], jy[CNI_LANES];
	float induced_x[CNI_LANES], induced_y[CNI_LANES];
	float angle0[CNI_LANES], measure[CNI_LANES];
	float rest[CNI_LANES], spring_mass[CNI_LANES], spring_bias[CNI_LANES], spring_impulse_scale[CNI_LANES], spring_j[CNI_LANES];
	float speed[CNI_LANES], most[CNI_LANES], motor_j[CNI_LANES];
	float lower[CNI_LANES], upper[CNI_LANES], limit_j[CNI_LANES];
	int32_t form, lanes, color;            /* color: CNI_NONE of a batch */
	uint32_t direct, held;                 /* lanes, as bits */
	uint32_t parts;                        /* CN_JOINT_SPRING, _MOTOR, _LIMIT: some lane has one */
	uint32_t moves_a, moves_b;             /* lanes, as bits, whose body can move and is written */
	int32_t listed;                        /* (of the n-th block) index of the n-th block of all colours in order */
	int32_t small;                         /* 1: of small islands, whose joints are relaxed again: joint_solve.c */
	int32_t restless;                      /* 1: the last relax pass changed a velocity by more than restless_speed */
	int32_t reserved[5];
} cni_joint_block;

/* Byte offset from a body's row of indices to its row of inverse inertias, on either side. */
#define CNI_SIDE_BYTES ((uint32_t)(offsetof(cni_joint_block, ai) - offsetof(cni_joint_block, ia)))

typedef struct cni_joint_pass {
	float h, inv_h;
	float warm_scale;
	cni_soft soft;
	float restless_speed;
} cni_joint_pass;

/* Works on the block's lanes, rounded up to whole vectors; the lanes behind are empty. */
typedef void cni_joint_kernel_fn(cni_motion *motions, cni_velocity_start *starts, cni_joint_block *block, const cni_joint_pass *pass);

typedef struct cni_joint_kernel {
	cni_joint_kernel_fn *warm;
	cni_joint_kernel_fn *solve;
	cni_joint_kernel_fn *relax;
} cni_joint_kernel;

extern const cni_joint_kernel cni_joint_kernel_plain; /* width 1: any compiler */
extern const cni_joint_kernel cni_joint_kernel_4;     /* SSE2, NEON, WASM SIMD */
extern const cni_joint_kernel cni_joint_kernel_8;     /* AVX2, chosen at run time */

static inline cni_joint_block *cni_joint_blocks(const cn_world *world)
{
	return (cni_joint_block *)world->joint_blocks.data;
}

/* The block of a joint constraint that is in a lane. */
static inline cni_joint_block *cni_joint_block_of(const cn_world *world, const cni_joint_constraint *w)
{
	return cni_joint_blocks(world) + w->lane / CNI_LANES;
}

/* Indices of a lane's impulses in the joint's record: of its point 0 and 1, of its spring this one, of motor and limit those after
   cni_lane_slot. */
static inline int32_t cni_lane_slot(const cni_joint_constraint *w)
{
	return w->form == CNI_FORM_PIN ? 2 : 1;
}
static inline int32_t cni_lane_spring_slot(const cni_joint_constraint *w)
{
	return w->form == CNI_FORM_DISTANCE && (w->parts & CNI_PART_HELD) ? 0 : cni_lane_slot(w);
}

/* The widest that this build and this processor have. */
const cni_joint_kernel *cni_joint_kernel_choose(void);

/* Empties all lanes at the beginning of a step, and checks whether those of the last step can be kept. */
void cni_joint_blocks_begin(cn_world *world);
/* A pass over the blocks of all colours; small: those of small islands alone. */
void cni_joint_blocks_run(cn_world *world, const cni_solve *s, cni_joint_kernel_fn *run, int32_t small);
/* The relax pass. Returns 1 when a lane of a small island changed a velocity by more than restless_speed. again: lanes of small islands alone. */
int32_t cni_joint_blocks_relax(cn_world *world, const cni_solve *s, int32_t again);
/* 1: the joint's island is so small that its joints are relaxed again: joint_solve.c */
static inline int32_t cni_joint_is_of_small(const cn_world *world, const cni_joint_constraint *w)
{
	int32_t island = w->ib > 0 ? cni_body_at(world, w->record->body[1])->island : CNI_NONE;
	if (island == CNI_NONE && w->ia > 0) /* b is kinematic */
		island = cni_body_at(world, w->record->body[0])->island;
	return island == CNI_NONE || cni_island_at(world, island)->count <= CNI_JOINT_RELAX_BODIES;
}
/* Appends a cleared block of pins without a colour. Returns its index. */
int32_t cni_joint_block_take(cn_world *world);
/* The last spring and its coefficients: neighbouring joints often have equal springs. */
typedef struct cni_lane_spring {
	float hertz, damping_ratio;
	cni_soft soft;
} cni_lane_spring;
/* State of a loop that sets up joint constraints: joints/joint_blocks.c. */
struct cni_lane_setup {
	cni_lane_spring spring;
	int32_t kept;    /* 1: lanes of the last step may be filled again */
	int32_t filled;  /* number of lanes filled again */
	int32_t special; /* 1: some of them have new joints or taut ropes */
};
/* Sets up joint constraint k at the beginning of a step if it can be solved in a lane, and fills its lane of the last step if that is kept;
   0: it cannot. Workers may call this for different k at once. */
int32_t cni_joint_constraint_widen(cn_world *world, const cni_solve *s, struct cni_lane_setup *setup, int32_t k);
/* 1: all joints are in their lanes of the last step, in which nothing was solved directly; so planning can be skipped. */
int32_t cni_joint_lanes_need_no_plan(const cn_world *world);
/* Fills an empty lane with joint constraint k. */
void cni_joint_lane_fill(cn_world *world, const cni_solve *s, cni_lane_spring *spring, int32_t k, cni_joint_block *block, int32_t l);
/* 1: both bodies are slow enough for the rotation series of lanes. */
int32_t cni_joint_fits_lane(const cn_world *world, const cni_solve *s, const cni_joint_constraint *w);
/* Stores impulses in the records. */
void cni_joint_blocks_store(cn_world *world, const cni_solve *s);

#endif
