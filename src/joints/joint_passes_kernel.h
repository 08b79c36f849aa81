/*
 * joints/joint_passes_kernel.h - the passes over blocks of joints and the table of the kernel; included once by each of
 * joint_kernel_4.c, joint_kernel_8.c and joint_kernel_plain.c.
 */
#include "joints/joint_kernel.h"

CNI_INLINE void solve_lanes(cni_motion *motions, cni_joint_block *k, const cni_joint_pass *pass, int32_t lanes, int32_t angular)
{
	int32_t l;
	for (l = 0; l < lanes; l += CNI_WIDTH) {
		arms r = arms_load(k, l);
		side a, b;
		cni_wide dx, dy;
		side_gather(motions, k->ia + l, k->ai + l, &a);
		side_gather(motions, k->ib + l, k->bi + l, &b);
		solve_group(k, l, &a, &b, &r, pass, 1, angular, 1, &dx, &dy);
		impulse_add(k->jx + l, dx);
		impulse_add(k->jy + l, dy);
		side_scatter(motions, k->ia + l, k->moves_a >> l, &a);
		side_scatter(motions, k->ib + l, k->moves_b >> l, &b);
	}
}

/* Few blocks have springs or motors: the others have a loop of their own. */
static void kernel_solve(cni_motion *motions, cni_velocity_start *starts, cni_joint_block *k, const cni_joint_pass *pass, int32_t lanes)
{
	(void)starts;
	if (k->angular)
		solve_lanes(motions, k, pass, lanes, 1);
	else
		solve_lanes(motions, k, pass, lanes, 0);
}

CNI_INLINE void relax_lanes(cni_motion *motions, cni_velocity_start *starts, cni_joint_block *k, const cni_joint_pass *pass, int32_t lanes, int32_t angular)
{
	int32_t l;
	for (l = 0; l < lanes; l += CNI_WIDTH) {
		cni_wide jx = cni_wide_load(k->jx + l), jy = cni_wide_load(k->jy + l);
		place at_a = place_gather(motions, k->ia + l), at_b = place_gather(motions, k->ib + l);
		arms old = arms_load(k, l), r = arms_renew(&at_a, &at_b, k, l, angular);
		side a, b;
		cni_wide dx, dy;
		side_gather(motions, k->ia + l, k->ai + l, &a);
		side_gather(motions, k->ib + l, k->bi + l, &b);
		start_turn(starts, k->ia + l, k->moves_a >> l, -(a.i * ((r.ax - old.ax) * jy - (r.ay - old.ay) * jx)));
		start_turn(starts, k->ib + l, k->moves_b >> l, b.i * ((r.bx - old.bx) * jy - (r.by - old.by) * jx));
		solve_group(k, l, &a, &b, &r, pass, 0, angular, 1, &dx, &dy);
		impulse_add(k->jx + l, dx);
		impulse_add(k->jy + l, dy);
		side_scatter(motions, k->ia + l, k->moves_a >> l, &a);
		side_scatter(motions, k->ib + l, k->moves_b >> l, &b);
	}
}

static void kernel_relax(cni_motion *motions, cni_velocity_start *starts, cni_joint_block *k, const cni_joint_pass *pass, int32_t lanes)
{
	if (k->angular)
		relax_lanes(motions, starts, k, pass, lanes, 1);
	else
		relax_lanes(motions, starts, k, pass, lanes, 0);
}

static void kernel_warm(cni_motion *motions, cni_velocity_start *starts, cni_joint_block *k, const cni_joint_pass *pass, int32_t lanes)
{
	int32_t l;
	(void)starts;
	for (l = 0; l < lanes; l += CNI_WIDTH) {
		arms r = arms_load(k, l);
		cni_wide jx = impulse_warm(k->jx + l, pass->warm_scale), jy = impulse_warm(k->jy + l, pass->warm_scale), t;
		side a, b;
		t = impulse_warm(k->spring_j + l, pass->warm_scale) + impulse_warm(k->motor_j + l, pass->warm_scale) + impulse_warm(k->limit_j + l, pass->warm_scale);
		side_gather(motions, k->ia + l, k->ai + l, &a);
		side_gather(motions, k->ib + l, k->bi + l, &b);
		push(&a, &b, &r, jx, jy, t);
		side_scatter(motions, k->ia + l, k->moves_a >> l, &a);
		side_scatter(motions, k->ib + l, k->moves_b >> l, &b);
	}
}

#include "joints/joint_rows_kernel.h"

const cni_joint_kernel CNI_KERNEL = { kernel_warm, kernel_solve, kernel_relax,
	row_lanes_begin, row_lanes_warm, row_lanes_solve, row_lanes_relax, row_lanes_finish };
