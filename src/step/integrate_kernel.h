/*
 * step/integrate_kernel.h - the body kernel of one vector width: included by integrate_kernel_4.c and integrate_kernel_8.c,
 * which define CNI_WIDTH and CNI_KERNEL. A vector holds the row of one body, or of two consecutive ones, and gives the bits of
 * integrate.c's functions for one body.
 *
 * A row has three components and one float that stays unchanged: the inverse mass beside a velocity, the inverse inertia beside
 * a change of pose, flags beside an external acceleration.
 *
 * The kernel also has the search over dense arrays for displacements beyond the limit (integrate.c), and finalize.c's update of poses.
 */
#include "base/wide.h"
#include "step/integrate_pass.h"

#define ROWS (CNI_WIDTH / 4) /* bodies in a vector */

CNI_INLINE cni_wide4 row_load(const void *row)
{
	return *(const cni_wide4 *)row;
}

#if CNI_WIDTH == 8

/* The rows of consecutive bodies whose records are `bytes` apart. */
CNI_INLINE cni_wide rows_load(const void *row, size_t bytes)
{
	return cni_wide_pair(row_load(row), row_load((const char *)row + bytes));
}

CNI_INLINE void rows_store(void *row, size_t bytes, cni_wide a)
{
	*(cni_wide4 *)row = __builtin_shufflevector(a, a, 0, 1, 2, 3);
	*(cni_wide4 *)(void *)((char *)row + bytes) = cni_wide_high(a);
}

static const cni_mask three = { -1, -1, -1, 0, -1, -1, -1, 0 };

CNI_INLINE cni_wide first_of_row(cni_wide a) { return __builtin_shufflevector(a, a, 0, 0, 0, 0, 4, 4, 4, 4); }
CNI_INLINE cni_wide second_of_row(cni_wide a) { return __builtin_shufflevector(a, a, 1, 1, 1, 1, 5, 5, 5, 5); }
CNI_INLINE cni_wide last_of_row(cni_wide a) { return __builtin_shufflevector(a, a, 3, 3, 3, 3, 7, 7, 7, 7); }

#else

CNI_INLINE cni_wide rows_load(const void *row, size_t bytes)
{
	(void)bytes;
	return row_load(row);
}

CNI_INLINE void rows_store(void *row, size_t bytes, cni_wide a)
{
	(void)bytes;
	*(cni_wide4 *)row = a;
}

static const cni_mask three = { -1, -1, -1, 0 };

CNI_INLINE cni_wide first_of_row(cni_wide a) { return __builtin_shufflevector(a, a, 0, 0, 0, 0); }
CNI_INLINE cni_wide second_of_row(cni_wide a) { return __builtin_shufflevector(a, a, 1, 1, 1, 1); }
CNI_INLINE cni_wide last_of_row(cni_wide a) { return __builtin_shufflevector(a, a, 3, 3, 3, 3); }

#endif

CNI_INLINE cni_wide only_three(cni_wide a)
{
	return (cni_wide)((cni_mask)a & three);
}

/* x^2 + y^2 of each row, in all its components. */
CNI_INLINE cni_wide length_sq_of_row(cni_wide a)
{
	cni_wide sq = a * a;
	return first_of_row(sq) + second_of_row(sq);
}

/* Rows of bodies with none of the flags. */
CNI_INLINE cni_mask rows_without(cni_wide external, uint32_t flags)
{
	return ((cni_mask)last_of_row(external) & ((int32_t)flags - (cni_mask){ 0 })) == (cni_mask){ 0 };
}

/* Has any body of the rows one of the flags? */
CNI_INLINE int32_t any_has(const cni_external *d, uint32_t flags)
{
	return ((d[0].flags | d[ROWS - 1].flags) & flags) != 0;
}

CNI_INLINE int32_t all_have(const cni_external *d, uint32_t flags)
{
	return (d[0].flags & flags) != 0 && (d[ROWS - 1].flags & flags) != 0;
}

/* Correction of the last substep's displacement to the trapezoid rule, as in integrate.c. response: motion.v - start; change: velocity
   change by the external acceleration. */
CNI_INLINE cni_wide trapezoid_correction(cni_wide start, cni_wide response, cni_wide change, float h)
{
	cni_wide jump = response + change;
	if (!CNI_ON(TRAPEZOID))
		return cni_wide_of(0.0f);
	cni_mask calm = ~(length_sq_of_row(jump) > cni_wide_of(4.0f) * length_sq_of_row(change)) & (last_of_row(start) == cni_wide_of(0.0f));
	return (cni_wide)((cni_mask)(cni_wide_of(0.5f * h) * jump) & calm);
}

/* Damping factors of each row's velocities. */
CNI_INLINE cni_wide rows_damping(const cni_body_pass *pass, int32_t k)
{
	cni_wide factors = cni_wide_of(1.0f);
	for (int32_t r = 0; r < ROWS; ++r)
		if (pass->externals[k + r].flags & CNI_EXTERNAL_DAMPED) {
			const cni_body *b = cni_body_at(pass->world, cni_awake_ids(pass->world)[k + r]);
			factors[4 * r] = factors[4 * r + 1] = cni_damping_factor(b->linear_damping, pass->h);
			factors[4 * r + 2] = cni_damping_factor(b->angular_damping, pass->h);
		}
	return factors;
}

/* True for components without a locked axis. */
CNI_INLINE cni_mask rows_unlocked(cni_wide external)
{
#if CNI_WIDTH == 8
	const cni_mask locks = { CNI_EXTERNAL_LOCK_X, CNI_EXTERNAL_LOCK_Y, 0, 0, CNI_EXTERNAL_LOCK_X, CNI_EXTERNAL_LOCK_Y, 0, 0 };
#else
	const cni_mask locks = { CNI_EXTERNAL_LOCK_X, CNI_EXTERNAL_LOCK_Y, 0, 0 };
#endif
	return ((cni_mask)last_of_row(external) & locks) == (cni_mask){ 0 };
}

/* Bodies k to k + ROWS - 1. all: no body has a flag that matters here, else masks select. Likewise below. */
CNI_INLINE void rows_velocities(const cni_body_pass *pass, int32_t k, float h, int32_t first, int32_t all)
{
	cni_motion *m = pass->motions + k;
	float *s = &pass->starts[k].vx;
	cni_wide v = rows_load(&m->vx, sizeof *m), start = cni_wide_load_loose(s), external = cni_wide_load_loose(&pass->externals[k].ax);
	cni_wide change = cni_wide_of(h) * only_three(external), from = v + change, response = { 0 }, correction, v_end;
	if (!first) {
		response = only_three(v - start);
		correction = trapezoid_correction(start, response, change, h);
		if (!all)
			correction = (cni_wide)((cni_mask)correction & rows_without(external, CNI_EXTERNAL_DONE | CNI_EXTERNAL_AS_IT_IS));
		rows_store(&m->dpx, sizeof *m, rows_load(&m->dpx, sizeof *m) - correction);
	}
	if (!all && any_has(&pass->externals[k], CNI_EXTERNAL_DAMPED))
		from = from * rows_damping(pass, k);
	v_end = from + response;
	from = only_three(from);
	if (!all) {
		cni_mask active = rows_without(external, CNI_EXTERNAL_DONE);
		from = cni_wide_select(active, from, start);
		v_end = cni_wide_select(active, v_end, v);
	}
	*(cni_wide_loose *)(void *)s = from;
	rows_store(&m->vx, sizeof *m, v_end);
}

CNI_INLINE int32_t velocities(const cni_body_pass *pass, int32_t begin, int32_t end, int32_t first)
{
	const cni_external *externals = pass->externals;
	const float h = pass->h;
	int32_t k;
	for (k = begin; k + ROWS <= end; k += ROWS)
		if (!any_has(&externals[k], CNI_EXTERNAL_DONE | CNI_EXTERNAL_AS_IT_IS))
			rows_velocities(pass, k, h, first, 1);
		else if (!all_have(&externals[k], CNI_EXTERNAL_DONE))
			rows_velocities(pass, k, h, first, 0);
	return k;
}

static int32_t kernel_velocities(const cni_body_pass *pass, int32_t begin, int32_t end)
{
	return pass->first ? velocities(pass, begin, end, 1) : velocities(pass, begin, end, 0);
}

CNI_INLINE void rows_positions(cni_motion *m, const cni_external *d, float h, int32_t all)
{
	cni_wide before = rows_load(&m->dpx, sizeof *m), v = rows_load(&m->vx, sizeof *m), external, p;
	cni_mask active;
	if (all) {
		p = before + cni_wide_of(h) * only_three(v);
	} else {
		external = cni_wide_load_loose(&d->ax);
		active = rows_without(external, CNI_EXTERNAL_DONE);
		v = (cni_wide)((cni_mask)v & (rows_unlocked(external) | ~active));
		p = cni_wide_select(active, before + cni_wide_of(h) * only_three(v), before);
		rows_store(&m->vx, sizeof *m, v);
	}
	rows_store(&m->dpx, sizeof *m, p);
}

static int32_t kernel_positions(const cni_body_pass *pass, int32_t begin, int32_t end)
{
	cni_motion *motions = pass->motions;
	const cni_external *externals = pass->externals;
	const float h = pass->h;
	int32_t k;
	for (k = begin; k + ROWS <= end; k += ROWS)
		if (!any_has(&externals[k], CNI_EXTERNAL_DONE | CNI_EXTERNAL_LOCKED))
			rows_positions(&motions[k], &externals[k], h, 1);
		else if (!all_have(&externals[k], CNI_EXTERNAL_DONE))
			rows_positions(&motions[k], &externals[k], h, 0);
	return k;
}

CNI_INLINE void rows_finish(cni_motion *m, const cni_velocity_start *s, const cni_external *d, float h, int32_t all)
{
	cni_wide v = rows_load(&m->vx, sizeof *m), start = cni_wide_load_loose(&s->vx), external = cni_wide_load_loose(&d->ax);
	cni_wide correction = trapezoid_correction(start, only_three(v - start), cni_wide_of(h) * only_three(external), h);
	if (!all) {
		correction = (cni_wide)((cni_mask)correction & rows_without(external, CNI_EXTERNAL_FREE | CNI_EXTERNAL_AS_IT_IS));
		rows_store(&m->vx, sizeof *m, (cni_wide)((cni_mask)v & rows_unlocked(external)));
	}
	rows_store(&m->dpx, sizeof *m, rows_load(&m->dpx, sizeof *m) - correction);
}

static int32_t kernel_finish(const cni_body_pass *pass, int32_t begin, int32_t end)
{
	cni_motion *motions = pass->motions;
	const cni_velocity_start *starts = pass->starts;
	const cni_external *externals = pass->externals;
	const float h = pass->h;
	int32_t k;
	for (k = begin; k + ROWS <= end; k += ROWS)
		if (!any_has(&externals[k], CNI_EXTERNAL_FREE | CNI_EXTERNAL_AS_IT_IS | CNI_EXTERNAL_LOCKED))
			rows_finish(&motions[k], &starts[k], &externals[k], h, 1);
		else if (any_has(&externals[k], CNI_EXTERNAL_LOCKED) || !all_have(&externals[k], CNI_EXTERNAL_FREE | CNI_EXTERNAL_AS_IT_IS))
			rows_finish(&motions[k], &starts[k], &externals[k], h, 0);
	return k;
}

static int32_t kernel_near(const cni_body_pass *pass, int32_t begin, int32_t end, float move_sq, float turn)
{
	const int32_t row[8] = { 0, 1, 2, 3, 4, 5, 6, 7 }, stride = (int32_t)(sizeof(cni_motion) / sizeof(float));
	int32_t k;
	for (k = begin; k + CNI_WIDTH <= end; k += CNI_WIDTH) {
		cni_wide x, y, turns, unused;
		cni_wide_gather4(&pass->motions[k].dpx, stride, row, &x, &y, &turns, &unused);
		if (cni_mask_bits((x * x + y * y <= cni_wide_of(move_sq)) & (cni_wide_abs(turns) <= cni_wide_of(turn))) != (1u << CNI_WIDTH) - 1u)
			break;
	}
	return k;
}

#include "step/finalize_kernel.h"

const cni_body_kernel CNI_KERNEL = { kernel_velocities, kernel_positions, kernel_finish, kernel_near, kernel_poses };
