/*
 * joints/joint_rows.h - lanes of joints that are not pins: rods, ties, welds, slides, wheels.
 *
 * Lanes of pins have formulas of their own; these lanes have the rows of joints/joint_solve.c, in the same order and with the same sums, so
 * a joint has the same result in a lane as by itself. A block is 16 lanes of one form, structure of arrays, made anew in every step.
 *
 *   form        of                         rigid rows            free rows       spring, limit    motor
 *   rod         rigid distance             along
 *   tie         with spring or limit                             along           free[0]          free[0]
 *   weld        fixed                      point x, y, angle
 *   soft weld   fixed with angular spring  point x, y            angle           free[0] (spring)
 *   slide       prismatic                  across, angle         along           free[0]          free[0]
 *   wheel       wheel                      across                along, angle    free[0]          free[1]
 *
 * Every row has equal and opposite linear parts: row . v = n . (vb - va) + aw wa + bw wb. Free rows are stored decoupled from the rigid
 * ones. A lane without a spring, motor or limit has numbers with which it gives no impulse.
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
	/* at the beginning of the step */
	float ax0[CNI_LANES], ay0[CNI_LANES], bx0[CNI_LANES], by0[CNI_LANES], dx0[CNI_LANES], dy0[CNI_LANES];
	float qc0[CNI_LANES], qs0[CNI_LANES], angle0[CNI_LANES];
	/* the joint's parameters */
	float axis_x[CNI_LANES], axis_y[CNI_LANES]; /* in body a's frame */
	float rest[CNI_LANES], spring_mass[CNI_LANES], spring_bias[CNI_LANES], spring_impulse_scale[CNI_LANES];
	float speed[CNI_LANES], most[CNI_LANES];
	float lower[CNI_LANES], upper[CNI_LANES];
	/* as of the last relax pass */
	cni_lane_row rigid[CNI_JOINT_RIGID_ROWS], free[CNI_FREE_ROWS];
	float error[CNI_JOINT_RIGID_ROWS][CNI_LANES], stretch[CNI_LANES];
	float below[CNI_LANES], above[CNI_LANES]; /* the ways to the limits */
	float side[CNI_LANES];                 /* of the limit: 1 the lower end, -1 the upper one */
	float inverse[6][CNI_LANES];           /* of the rigid rows' K: 00 01 02 11 12 22 */
	float free_mass[CNI_FREE_ROWS][CNI_LANES];
	/* impulses: of the rigid rows for decoupled free rows; whole: for the type's rows, at the end of the step */
	float j[CNI_JOINT_RIGID_ROWS][CNI_LANES], spring_j[CNI_LANES], motor_j[CNI_LANES], limit_j[CNI_LANES];
	float whole[CNI_JOINT_RIGID_ROWS][CNI_LANES];
	int32_t constraint[CNI_LANES];         /* index of the joint constraint */
	int32_t form, lanes, color;
	uint32_t has;                          /* CN_JOINT_SPRING, _MOTOR, _LIMIT: some lane has one */
	uint32_t moves_a, moves_b;             /* lanes, as bits, whose body can move and is written */
	int32_t listed;                        /* (of the n-th block) index of the n-th block of all colours in order */
	int32_t reserved[9];
} cni_row_block;

/* Index of the free row of a form's motor. */
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

/* Works on the block's lanes, rounded up to whole vectors; the lanes behind are empty. */
typedef void cni_row_kernel_fn(cni_motion *motions, cni_velocity_start *starts, cni_row_block *block, const struct cni_joint_pass *pass);

/* Form of a joint in a lane of rows; CNI_FORM_NONE: it has none. */
int32_t cni_joint_form(const cni_joint *j);
/* Empties all blocks of rows. */
void cni_row_blocks_empty(cn_world *world);
/* Places joints that have a form and are not solved directly into lanes; builds rows for those without a lane. */
void cni_row_lanes_gather(cn_world *world, const cni_solve *s);
/* A pass over blocks begin to end - 1 of the list of all colours in order. */
void cni_row_blocks_run(cn_world *world, cni_row_kernel_fn *run, const struct cni_joint_pass *pass, int32_t begin, int32_t end);
/* Stores impulses in the records. */
void cni_row_lanes_store(cn_world *world, const cni_solve *s);
/* Reads the rows of a joint constraint in such a lane, as joints/joint_solve.c would have them; writes their impulses back into the
   lane. */
int32_t cni_row_lane_read(const cn_world *world, const cni_joint_constraint *w, cni_row *rows);
void cni_row_lane_write(cn_world *world, const cni_joint_constraint *w, const cni_row *rows);

#endif
