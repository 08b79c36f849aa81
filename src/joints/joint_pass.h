/*
 * joints/joint_pass.h - blocks of revolute joints, and the data that joint_blocks.c passes to a kernel.
 *
 * A block is 16 lanes, structure of arrays, filled anew in every step from revolute joints that nothing bounds, softens or breaks; the
 * assignment of joints to lanes may be kept (joints/joint_blocks.c). Colours are as of contacts: no movable body appears twice in one. When
 * the colours of a body are used up, its further joints are solved by the rows of joints/joint_solve.c.
 *
 *   pin       ra0 rb0 d0   arms and gap at the beginning of the step       ra rb e   as of the last relax pass
 *             j            impulse on body b, all of it: including the pin impulses of springs, motors and limits
 *             induced      (batches) pin impulses of springs, motors and limits in the soft pass
 *   angle     angle0 angle as above; bounds and coefficients; impulses of spring, motor and limit, all
 *             as torques on body b (limit: > 0 the lower one's, < 0 the upper one's)
 *
 * A directly solved lane (bit in `direct`) has its pin solved by direct/direct_joints.c; the two rows of its joint constraint are kept up
 * to date, and the pin's impulse is the lane's plus the rows'. Blocks of a batch (direct/batched_trees.h) are in no colour and have no
 * rows: their pins' impulses are in the lanes.
 */
#ifndef CNI_JOINTS_JOINT_PASS_H
#define CNI_JOINTS_JOINT_PASS_H

#include "joints/joint_rows.h"

typedef struct cni_joint_block {
	int32_t ia[CNI_LANES], ib[CNI_LANES];  /* dense body indices */
	float ai[CNI_LANES], bi[CNI_LANES];    /* inverse inertias */
	float ax0[CNI_LANES], ay0[CNI_LANES], bx0[CNI_LANES], by0[CNI_LANES];
	float dx0[CNI_LANES], dy0[CNI_LANES];
	float ax[CNI_LANES], ay[CNI_LANES], bx[CNI_LANES], by[CNI_LANES];
	float ex[CNI_LANES], ey[CNI_LANES];
	float jx[CNI_LANES], jy[CNI_LANES];
	float induced_x[CNI_LANES], induced_y[CNI_LANES];
	float angle0[CNI_LANES], angle[CNI_LANES];
	float rest[CNI_LANES], spring_mass[CNI_LANES], spring_bias[CNI_LANES], spring_impulse_scale[CNI_LANES], spring_j[CNI_LANES];
	float speed[CNI_LANES], torque[CNI_LANES], motor_j[CNI_LANES];
	float lower[CNI_LANES], upper[CNI_LANES], limit_j[CNI_LANES];
	int32_t constraint[CNI_LANES];         /* index of the joint constraint */
	uint32_t direct;                       /* lanes, as bits */
	uint32_t angular;                      /* CN_JOINT_SPRING, _MOTOR, _LIMIT: some lane has one */
	int32_t next;                          /* next block of the colour */
	int32_t batch;                          /* 1: of a batch */
	uint32_t moves_a, moves_b;             /* lanes, as bits, whose body can move and is written */
	int32_t listed;                        /* (of the n-th block) index of the n-th block of all colours in order */
	int32_t reserved[9];
} cni_joint_block;

/* Byte offset from a body's row of indices to its row of inverse inertias, on either side. */
#define CNI_SIDE_BYTES ((uint32_t)(offsetof(cni_joint_block, ai) - offsetof(cni_joint_block, ia)))

typedef struct cni_joint_pass {
	float h, inv_h;
	float warm_scale;
	cni_soft soft;
} cni_joint_pass;

/* Works on the first lanes of the block, rounded up to whole vectors; the lanes behind are empty. */
typedef void cni_joint_kernel_fn(cni_motion *motions, cni_velocity_start *starts, cni_joint_block *block, const cni_joint_pass *pass, int32_t lanes);

typedef struct cni_joint_kernel {
	cni_joint_kernel_fn *warm;
	cni_joint_kernel_fn *solve;
	cni_joint_kernel_fn *relax;
	cni_row_kernel_fn *rows_begin;  /* builds the first rows, and converts the records' impulses to decoupled rows */
	cni_row_kernel_fn *rows_warm;
	cni_row_kernel_fn *rows_solve;
	cni_row_kernel_fn *rows_relax;
	cni_row_kernel_fn *rows_finish; /* converts the impulses back to those of the type's rows */
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

/* The widest that this build and this processor have. */
const cni_joint_kernel *cni_joint_kernel_choose(void);

/* Empties all lanes at the beginning of a step, and checks whether those of the last step can be kept. */
void cni_joint_blocks_begin(cn_world *world);
void cni_joint_blocks_warm(cn_world *world, const cni_solve *s);
void cni_joint_blocks_solve(cn_world *world, const cni_solve *s);
void cni_joint_blocks_relax(cn_world *world, const cni_solve *s);
/* Appends a cleared block without a colour. Returns its index. */
int32_t cni_joint_block_take(cn_world *world);
/* The last spring and its coefficients: neighbouring joints often have equal springs. */
typedef struct cni_lane_spring {
	float hertz, damping_ratio;
	cni_soft soft;
} cni_lane_spring;
cni_soft cni_lane_spring_soft(cni_lane_spring *spring, float hertz, float damping_ratio, float h);
/* State of a loop that sets up joint constraints: joints/joint_blocks.c. */
struct cni_lane_setup {
	cni_lane_spring spring;
	int32_t kept;    /* 1: lanes of the last step may be filled again */
	int32_t filled;  /* number of lanes filled again */
	int32_t special; /* 1: some of them have bodies locked along an axis, or new joints */
};
/* Takes a colour that neither body uses yet and marks it as used; CNI_NONE: there is none. */
int32_t cni_joint_color_take(cn_world *world, int32_t ia, int32_t ib);
/* Fills an empty lane with joint constraint k. */
void cni_joint_lane_fill(cn_world *world, const cni_solve *s, cni_lane_spring *spring, int32_t k, cni_joint_block *block, int32_t l);
/* 1: both bodies are slow enough for the rotation series of lanes. */
int32_t cni_joint_fits_lane(const cn_world *world, const cni_solve *s, const cni_joint_constraint *w);
/* Stores impulses in the records. */
void cni_joint_blocks_store(cn_world *world, const cni_solve *s);

#endif
