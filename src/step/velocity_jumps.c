/*
 * step/velocity_jumps.c - resets joints after velocity jumps. If a body's velocity changes in a substep by much more than its
 * external acceleration gives, its joints restart from their loads. Warm starting assumes that the next substep needs about the
 * impulses of this one: that is true of loads and false of impacts.
 *
 * Contacts keep their impulses: a crowd under pressure jumps in every substep, and would overlap twice as much if each substep
 * began without them.
 *
 * Reads motion, start, external accelerations, joint constraints; writes start (jumped, and the response without the removed
 * impulses), joint impulses.
 */
#include "step/stages.h"
#include "step/integrate_pass.h"
#include "joints/joint_constraint.h"

#define BODIES_A_RANGE 256 /* about a microsecond each */

typedef struct jump_loop {
	cn_world *world;
	const cni_solve *s;
	uint32_t jumps;
} jump_loop;

/* Marks a body with a velocity jump. start holds v + h a, so the jump is motion.v - start + h a. Returns 1 if it jumped. */
CNI_INLINE uint32_t mark(const cni_motion *m, cni_velocity_start *start, const cni_external *d, float h, float most_sq)
{
	float dx = m->vx - start->vx, dy = m->vy - start->vy, ax, ay, jump_sq = dx * dx + dy * dy;
	if (jump_sq <= most_sq || !(d->flags & CNI_EXTERNAL_TOUCHED)) /* early out for nearly all bodies */
		return 0;
	ax = h * d->ax;
	ay = h * d->ay;
	if (jump_sq <= most_sq + 64.0f * (ax * ax + ay * ay))
		return 0;
	start->jumped = CNI_JUMPED;
	return 1;
}

/* Marks and counts bodies with a jump. The kernel skips slow bodies. */
static void mark_range(void *context, int32_t begin, int32_t end, int32_t worker)
{
	jump_loop *loop = (jump_loop *)context;
	const cni_body_kernel *kernel = loop->s->body_kernel;
	cni_body_pass pass = { loop->world, cni_motions(loop->world), cni_starts(loop->world), cni_externals(loop->world), loop->s->h, 0 };
	float most_sq = loop->s->jump_speed * loop->s->jump_speed;
	uint32_t jumps = 0;
	int32_t k = begin + 1, last;
	(void)worker;
	while (k <= end) {
		if (kernel != NULL)
			k = kernel->calm(&pass, k, end + 1, most_sq);
		for (last = cni_min_i(k + CNI_CALM_MOST - 1, end); k <= last; ++k)
			jumps += mark(&pass.motions[k], &pass.starts[k], &pass.externals[k], pass.h, most_sq);
	}
	if (jumps > 0)
		cni_atomic_add(&loop->jumps, jumps);
}

static void response_remove(cn_world *world, int32_t index, float px, float py, float moment)
{
	const cni_motion *m = cni_motions(world) + index;
	cni_velocity_start *start = cni_starts(world) + index;
	uint32_t flags = cni_externals(world)[index].flags;
	if (!(flags & CNI_EXTERNAL_LOCK_X))
		start->vx += m->inv_mass * px;
	if (!(flags & CNI_EXTERNAL_LOCK_Y))
		start->vy += m->inv_mass * py;
	start->w += m->inv_inertia * moment;
}

/* The part of an impulse in the direction of the load, at most the load. */
static float load_part(float impulse, float load)
{
	return load > 0.0f ? cni_clamp(impulse, 0.0f, load) : cni_clamp(impulse, load, 0.0f);
}

/*
 * Restarts a joint from its loads instead of the impulses of an impact: each row keeps at most its impulse at the start of the
 * step. (With zero impulses, a bridge that is hit would lose the tension that carries it.) Rows of springs and motors are
 * skipped.
 */
static void joint_reset(cn_world *world, cni_joint_constraint *w)
{
	cni_joint_impulses all;
	int32_t r;
	cni_joint_impulses_read(world, w, &all);
	for (r = 0; r < all.count; ++r) {
		cni_row *row = &all.rows[r];
		float kept = load_part(row->impulse, w->record->impulse[row->slot]), j = row->impulse - kept;
		if (cni_row_kind_drives(row->kind))
			continue;
		response_remove(world, w->ia, row->ax * j, row->ay * j, row->aw * j);
		response_remove(world, w->ib, row->bx * j, row->by * j, row->bw * j);
		row->impulse = kept;
	}
	cni_joint_impulses_write(world, w, &all);
}

static void joints_reset(cn_world *world)
{
	int32_t k;
	for (k = 0; k < world->awake_joints.count; ++k) {
		cni_joint_constraint *w = cni_joint_constraints(world) + k;
		if (cni_starts(world)[w->ia].jumped >= CNI_JUMPED || cni_starts(world)[w->ib].jumped >= CNI_JUMPED)
			joint_reset(world, w);
	}
}

uint32_t cni_velocity_jumps_mark(cn_world *world, const cni_solve *s)
{
	jump_loop loop = { world, s, 0 };
	cni_team_for(s->team, world->awake_count - 1, BODIES_A_RANGE, mark_range, &loop);
	return loop.jumps;
}

void cni_velocity_jumps_reset(cn_world *world, const cni_solve *s)
{
	if (world->awake_joints.count > 0 && cni_velocity_jumps_mark(world, s) > 0)
		joints_reset(world);
}
