/*
 * joints/joint_passes_kernel.h - the passes over blocks of joints and the table of the kernel; included once by each of
 * joint_kernel_4.c, joint_kernel_8.c and joint_kernel_plain.c.
 */
#include "joints/joint_kernel.h"

/* Loops that are compiled alone: most blocks have pins without springs, motors and limits. */
enum { PINS, ANGULAR_PINS, DISTANCES };

static int32_t kind_of(const cni_joint_block *k)
{
	return k->form == CNI_FORM_DISTANCE ? DISTANCES : k->parts != 0 ? ANGULAR_PINS : PINS;
}

CNI_INLINE void sides_gather(const cni_motion *motions, const cni_joint_block *k, int32_t l, side *a, side *b)
{
	side_gather(motions, k->ia + l, k->ai + l, a);
	side_gather(motions, k->ib + l, k->bi + l, b);
}

CNI_INLINE void sides_scatter(cni_motion *motions, const cni_joint_block *k, int32_t l, const side *a, const side *b)
{
	side_scatter(motions, k->ia + l, k->moves_a >> l, a);
	side_scatter(motions, k->ib + l, k->moves_b >> l, b);
}

CNI_INLINE void lane_solve(cni_joint_block *k, int32_t l, side *a, side *b, const arms *r, const cni_joint_pass *pass, int32_t bias, int32_t kind)
{
	cni_wide dx, dy;
	if (kind == DISTANCES) {
		solve_distance(k, l, a, b, r, pass, bias);
		return;
	}
	solve_group(k, l, a, b, r, pass, bias, kind == ANGULAR_PINS, 0, &dx, &dy);
	impulse_add(k->jx + l, dx);
	impulse_add(k->jy + l, dy);
}

CNI_INLINE void solve_lanes(cni_motion *motions, cni_joint_block *k, const cni_joint_pass *pass, int32_t kind)
{
	for (int32_t l = 0; l < k->lanes; l += CNI_WIDTH) {
		arms r = arms_load(k, l);
		side a, b;
		sides_gather(motions, k, l, &a, &b);
		lane_solve(k, l, &a, &b, &r, pass, 1, kind);
		sides_scatter(motions, k, l, &a, &b);
	}
}

static void kernel_solve(cni_motion *motions, cni_velocity_start *starts, cni_joint_block *k, const cni_joint_pass *pass)
{
	(void)starts;
	switch (kind_of(k)) {
	case PINS: solve_lanes(motions, k, pass, PINS); break;
	case ANGULAR_PINS: solve_lanes(motions, k, pass, ANGULAR_PINS); break;
	default: solve_lanes(motions, k, pass, DISTANCES); break;
	}
}

/* Computes the axis and length from the gap in e. Impulses along an axis that reversed its direction are dropped. Returns their sum. */
CNI_INLINE cni_wide axis_renew(cni_joint_block *k, int32_t l, cni_wide old_x, cni_wide old_y)
{
	const cni_wide zero = cni_wide_of(0.0f), one = cni_wide_of(1.0f);
	cni_wide x = cni_wide_load(k->ex + l), y = cni_wide_load(k->ey + l), length = cni_wide_sqrt(x * x + y * y), inverse = 1.0f / length;
	cni_mask apart = length > cni_wide_of(1e-9f), turned;
	x = cni_wide_select(apart, inverse * x, one);
	y = cni_wide_select(apart, inverse * y, zero);
	cni_wide_store(k->ex + l, x);
	cni_wide_store(k->ey + l, y);
	cni_wide_store(k->measure + l, length);
	turned = x * old_x + y * old_y < zero;
	if (cni_mask_bits(turned) != 0) {
		cni_wide_store(k->spring_j + l, cni_wide_select(turned, zero, cni_wide_load(k->spring_j + l)));
		cni_wide_store(k->motor_j + l, cni_wide_select(turned, zero, cni_wide_load(k->motor_j + l)));
		cni_wide_store(k->limit_j + l, cni_wide_select(turned, zero, cni_wide_load(k->limit_j + l)));
	}
	return measure_impulse(k, l);
}

/* An impulse j on body b at the end of arm r. */
typedef struct force {
	cni_wide rx, ry, jx, jy;
} force;

CNI_INLINE force force_of(cni_wide rx, cni_wide ry, cni_wide t, cni_wide nx, cni_wide ny)
{
	force f = { rx, ry, t * nx, t * ny };
	return f;
}

/* The impulse turned from `old` to `now`: the change of one side's velocities goes into start. sign: -1 for body a. */
CNI_INLINE void force_turn(cni_velocity_start *starts, const int32_t *index, uint32_t moves, const side *s, float sign, const force *now, const force *old)
{
	cni_wide m = sign * s->m, i = sign * s->i;
	start_change(starts, index, moves, m * (now->jx - old->jx), m * (now->jy - old->jy),
		i * ((now->rx * now->jy - now->ry * now->jx) - (old->rx * old->jy - old->ry * old->jx)));
}

CNI_INLINE void distance_turn(cni_velocity_start *starts, cni_joint_block *k, int32_t l, const side *a, const side *b, const arms *r, const arms *old, cni_wide nx, cni_wide ny)
{
	cni_wide before = measure_impulse(k, l), t = axis_renew(k, l, nx, ny), x = cni_wide_load(k->ex + l), y = cni_wide_load(k->ey + l);
	force a0 = force_of(old->ax, old->ay, before, nx, ny), a1 = force_of(r->ax, r->ay, t, x, y);
	force b0 = force_of(old->bx, old->by, before, nx, ny), b1 = force_of(r->bx, r->by, t, x, y);
	force_turn(starts, k->ia + l, k->moves_a >> l, a, -1.0f, &a1, &a0);
	force_turn(starts, k->ib + l, k->moves_b >> l, b, 1.0f, &b1, &b0);
}

/* Lanes in which the velocity of a body changes by more than the speed. */
CNI_INLINE cni_mask side_changes(const side *before, const side *after, float speed)
{
	return cni_wide_max(cni_wide_abs(after->vx - before->vx), cni_wide_abs(after->vy - before->vy)) > cni_wide_of(speed);
}

CNI_INLINE void relax_lanes(cni_motion *motions, cni_velocity_start *starts, cni_joint_block *k, const cni_joint_pass *pass, int32_t kind)
{
	const cni_wide zero = cni_wide_of(0.0f);
	k->restless = 0;
	for (int32_t l = 0; l < k->lanes; l += CNI_WIDTH) {
		cni_wide jx = cni_wide_load(k->jx + l), jy = cni_wide_load(k->jy + l), nx = cni_wide_load(k->ex + l), ny = cni_wide_load(k->ey + l);
		place at_a = place_gather(motions, k->ia + l), at_b = place_gather(motions, k->ib + l);
		arms old = arms_load(k, l), r = arms_renew(&at_a, &at_b, k, l, kind == ANGULAR_PINS);
		side a, b, a_before, b_before;
		sides_gather(motions, k, l, &a, &b);
		a_before = a;
		b_before = b;
		if (kind == DISTANCES) {
			distance_turn(starts, k, l, &a, &b, &r, &old, nx, ny);
		} else {
			start_change(starts, k->ia + l, k->moves_a >> l, zero, zero, -(a.i * ((r.ax - old.ax) * jy - (r.ay - old.ay) * jx)));
			start_change(starts, k->ib + l, k->moves_b >> l, zero, zero, b.i * ((r.bx - old.bx) * jy - (r.by - old.by) * jx));
		}
		lane_solve(k, l, &a, &b, &r, pass, 0, kind);
		if (k->small)
			k->restless |= cni_mask_bits(side_changes(&a_before, &a, pass->restless_speed) | side_changes(&b_before, &b, pass->restless_speed)) != 0;
		sides_scatter(motions, k, l, &a, &b);
	}
}

static void kernel_relax(cni_motion *motions, cni_velocity_start *starts, cni_joint_block *k, const cni_joint_pass *pass)
{
	switch (kind_of(k)) {
	case PINS: relax_lanes(motions, starts, k, pass, PINS); break;
	case ANGULAR_PINS: relax_lanes(motions, starts, k, pass, ANGULAR_PINS); break;
	default: relax_lanes(motions, starts, k, pass, DISTANCES); break;
	}
}

static void kernel_warm(cni_motion *motions, cni_velocity_start *starts, cni_joint_block *k, const cni_joint_pass *pass)
{
	(void)starts;
	for (int32_t l = 0; l < k->lanes; l += CNI_WIDTH) {
		arms r = arms_load(k, l);
		cni_wide t = measure_warm(k, l, pass->warm_scale);
		side a, b;
		sides_gather(motions, k, l, &a, &b);
		if (k->form == CNI_FORM_DISTANCE)
			push(&a, &b, &r, t * cni_wide_load(k->ex + l), t * cni_wide_load(k->ey + l), cni_wide_of(0.0f));
		else
			push(&a, &b, &r, impulse_warm(k->jx + l, pass->warm_scale), impulse_warm(k->jy + l, pass->warm_scale), t);
		sides_scatter(motions, k, l, &a, &b);
	}
}

const cni_joint_kernel CNI_KERNEL = { kernel_warm, kernel_solve, kernel_relax };
