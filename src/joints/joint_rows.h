/*
 * joints/joint_rows.h - lanes of joints that are not pins: rods, ties, welds, slides, wheels.
 *
 * Where a pin's lane has formulas of its own, these have rows as joints/joint_solve.c has them, in the same order and
 * with the same sums, so that a joint does the same in a lane as by itself. A block is 16 lanes of one form, structure of
 * arrays, made anew in every step.
 *
 *   form        of                         rigid rows            free rows       spring, limit    motor
 *   rod         distance that holds        along
 *   tie         distance that gives                              along           free[0]          free[0]
 *   weld        fixed                      point x, y, angle
 *   soft weld   fixed whose angle gives    point x, y            angle           free[0] (spring)
 *   slide       prismatic                  across, angle         along           free[0]          free[0]
 *   wheel       wheel                      across                along, angle    free[0]          free[1]
 *
 * Every row has equal and opposite linear parts: row . v = n . (vb - va) + aw wa + bw wb. Free rows are kept with the rigid
 * ones taken out of them. A lane without a spring, motor or limit has numbers with which it gives no impulse.
 */
#ifndef CNI_JOINTS_JOINT_ROWS_H
#define CNI_JOINTS_JOINT_ROWS_H

#include "joints/joint_constraint.h"

struct cni_joint_pass; /* joints/joint_pass.h */

enum { CNI_FORM_NONE = 0, CNI_FORM_ROD, CNI_FORM_TIE, CNI_FORM_WELD, CNI_FORM_SOFT_WELD, CNI_FORM_SLIDE, CNI_FORM_WHEEL, CNI_FORMS };

#define CNI_FREE_ROWS 2

typedef struct cni_lane_row {
	float nx[CNI_LANES], ny[CNI_LANES], aw[CNI_LANES], bw[CNI_LANES];
} cni_lane_row;

typedef struct cni_row_block {
	int32_t ia[CNI_LANES], ib[CNI_LANES];  /* dense body indices */
	float ai[CNI_LANES], bi[CNI_LANES];    /* inverse inertias */
	/* as the step begins */
	float ax0[CNI_LANES], ay0[CNI_LANES], bx0[CNI_LANES], by0[CNI_LANES], dx0[CNI_LANES], dy0[CNI_LANES];
	float qc0[CNI_LANES], qs0[CNI_LANES], angle0[CNI_LANES];
	/* the joint's numbers */
	float axis_x[CNI_LANES], axis_y[CNI_LANES]; /* in body a's frame */
	float rest[CNI_LANES], spring_mass[CNI_LANES], spring_bias[CNI_LANES], spring_give[CNI_LANES];
	float speed[CNI_LANES], most[CNI_LANES];
	float lower[CNI_LANES], upper[CNI_LANES];
	/* as of the last relaxing pass */
	cni_lane_row rigid[CNI_JOINT_RIGID_ROWS], free[CNI_FREE_ROWS];
	float error[CNI_JOINT_RIGID_ROWS][CNI_LANES], stretch[CNI_LANES], room[CNI_LANES];
	float side[CNI_LANES];                 /* of the limit: 1 the lower end, -1 the upper one */
	float inverse[6][CNI_LANES];           /* of the rigid rows' K: 00 01 02 11 12 22 */
	float free_mass[CNI_FREE_ROWS][CNI_LANES];
	/* impulses: of the rigid rows without what free ones ask of them; whole: with that, when all is done */
	float j[CNI_JOINT_RIGID_ROWS][CNI_LANES], spring_j[CNI_LANES], motor_j[CNI_LANES], limit_j[CNI_LANES];
	float whole[CNI_JOINT_RIGID_ROWS][CNI_LANES];
	int32_t work[CNI_LANES];               /* place in the works */
	int32_t form, lanes, color;
	uint32_t has;                          /* CN_JOINT_SPRING, _MOTOR, _LIMIT: some lane has one */
	uint32_t moves_a, moves_b;             /* lanes, as bits, whose body can move and so is written */
	int32_t listed;                        /* (of the n-th block) which block is the n-th of all colours in order */
	int32_t reserved[9];
} cni_row_block;

/* Which free row a form's motor turns or pushes. */
static inline int32_t cni_form_motor_row(int32_t form) { return form == CNI_FORM_WHEEL; }
static inline int32_t cni_form_rigid_rows(int32_t form)
{
	static const uint8_t count[CNI_FORMS] = { 0, 1, 0, 3, 2, 2, 1 };
	return count[form];
}
static inline int32_t cni_form_free_rows(int32_t form)
{
	static const uint8_t count[CNI_FORMS] = { 0, 0, 1, 0, 1, 1, 2 };
	return count[form];
}

static inline cni_row_block *cni_row_blocks(const cn_world *world)
{
	return (cni_row_block *)world->row_blocks;
}

/* Works on the block's lanes, and on those behind them up to a whole vector, which are empty. */
typedef void cni_row_kernel_fn(cni_motion *motions, cni_velocity_start *starts, cni_row_block *block, const struct cni_joint_pass *pass);

/* How a joint can be solved in a lane of rows; CNI_FORM_NONE: it cannot. */
int32_t cni_joint_form(const cni_joint *j);
/* No joint is in one. */
void cni_row_blocks_empty(cn_world *world);
/* Those that have a form and are not solved directly into lanes; what finds no place gets rows. */
void cni_row_lanes_gather(cn_world *world, const cni_solve *s);
/* A pass over blocks begin to end - 1 of the list of all colours in order. */
void cni_row_blocks_run(cn_world *world, cni_row_kernel_fn *run, const struct cni_joint_pass *pass, int32_t begin, int32_t end);
/* Impulses back to the records. */
void cni_row_lanes_store(cn_world *world, const cni_solve *s);
/* The rows of a work that is in such a lane, as joints/joint_solve.c would have them, and their impulses back into it. */
int32_t cni_row_lane_read(const cn_world *world, const cni_joint_constraint *w, cni_row *rows);
void cni_row_lane_write(cn_world *world, const cni_joint_constraint *w, const cni_row *rows);

#endif
