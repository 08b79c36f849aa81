/*
 * stages/shock.c - impulses of an impact are not carried into the next substep.
 *
 * Warm starting assumes that the next substep needs about the impulses of the last one. That is true of
 * loads and false of impacts: given again, an impact's impulses drive bodies apart, and one sweep of the solver does
 * not take all of that back when light bodies are caught among heavy ones; the energy grows from substep to
 * substep. So where a body's velocity jumped in a substep by much more than its drive gives, the impulses of its
 * contacts start from nothing in the next, and those of its joints from the load they had.
 *
 * Reads motion, start, drive; writes start (struck, and the response that is taken out), block.jn jt,
 * joint impulses.
 */
#include "stages/joint_pass.h"

/* Marks the bodies whose velocity jumped; returns how many. start holds v + h a, so the jump is motion.v - start + h a. */
static int32_t shocks_mark(cn_world *world, const cni_solve *s)
{
	const cni_motion *motions = cni_motions(world);
	const cni_drive *drives = cni_drives(world);
	cni_velocity_start *starts = cni_starts(world);
	float most_sq = s->shock_speed * s->shock_speed;
	int32_t k, shocks = 0;
	for (k = 1; k < world->awake_count; ++k) {
		float dx = motions[k].vx - starts[k].vx, dy = motions[k].vy - starts[k].vy;
		float ax = s->h * drives[k].ax, ay = s->h * drives[k].ay;
		if (!(drives[k].flags & CNI_DRIVE_TOUCHED) || dx * dx + dy * dy <= most_sq + 64.0f * (ax * ax + ay * ay))
			continue;
		starts[k].struck = 2.0f;
		++shocks;
	}
	return shocks;
}

static void response_take_out(cn_world *world, int32_t index, float px, float py, float moment)
{
	const cni_motion *m = cni_motions(world) + index;
	cni_velocity_start *start = cni_starts(world) + index;
	uint32_t flags = cni_drives(world)[index].flags;
	if (!(flags & CNI_DRIVE_LOCK_X))
		start->vx += m->inv_mass * px;
	if (!(flags & CNI_DRIVE_LOCK_Y))
		start->vy += m->inv_mass * py;
	start->w += m->inv_inertia * moment;
}

static void lane_forget(cn_world *world, cni_contact_block *k, int32_t l)
{
	float j0 = k->p[0].jn[l], j1 = k->p[1].jn[l], jt = k->jt[l], jn = j0 + j1;
	float px = jn * k->nx[l] + jt * k->ny[l], py = jn * k->ny[l] - jt * k->nx[l];
	response_take_out(world, k->ia[l], -px, -py, -(k->p[0].at[l] * j0 + k->p[1].at[l] * j1 - k->fa[l] * jt));
	response_take_out(world, k->ib[l], px, py, (k->p[0].at[l] - k->dt[l]) * j0 + (k->p[1].at[l] - k->dt[l]) * j1 - k->fb[l] * jt);
	k->p[0].jn[l] = k->p[1].jn[l] = k->jt[l] = 0.0f;
	k->p[0].load[l] = k->p[1].load[l] = 0.0f;
}

static int32_t shocked(const cn_world *world, int32_t a, int32_t b)
{
	return cni_starts(world)[a].struck == 2.0f || cni_starts(world)[b].struck == 2.0f;
}

static void contacts_forget(cn_world *world)
{
	int32_t color, block, l;
	for (color = 0; color < CNI_COLORS; ++color)
		for (block = world->colors[color].first; block != CNI_NONE; block = cni_block_info_at(world, block)->next) {
			cni_contact_block *k = cni_block_at(world, block);
			for (l = 0; l < CNI_LANES; ++l)
				if (shocked(world, k->ia[l], k->ib[l]))
					lane_forget(world, k, l);
		}
}

/* The part of an impulse that goes the way of the load, and no farther. */
static float load_part(float impulse, float load)
{
	return load > 0.0f ? cni_clamp(impulse, 0.0f, load) : cni_clamp(impulse, load, 0.0f);
}

/*
 * A joint forgets what goes beyond its load at the beginning of the step: without that a bridge which is hit would
 * lose the tension it stands by, jump for that reason, and the shock would run through all of it. Springs
 * are forces that are meant, and their coefficients count on the impulse.
 */
static void joints_forget(cn_world *world)
{
	int32_t k, r;
	for (k = 0; k < world->awake_joints.count; ++k) {
		cni_joint_work *w = (cni_joint_work *)world->joint_work.data + k;
		if (!shocked(world, w->ia, w->ib))
			continue;
		for (r = 0; r < w->row_count; ++r) {
			const cni_row *row = &w->rows[r];
			float load = cni_joint_at(world, w->joint)->impulse[row->slot], kept = load_part(row->impulse, load), j = row->impulse - kept;
			if (row->kind == CNI_ROW_SPRING || row->kind == CNI_ROW_DRIVE)
				continue;
			response_take_out(world, w->ia, row->ax * j, row->ay * j, row->aw * j);
			response_take_out(world, w->ib, row->bx * j, row->by * j, row->bw * j);
			w->rows[r].impulse = kept;
		}
	}
}

static void joint_lane_forget(cn_world *world, cni_joint_block *k, int32_t l)
{
	const cni_joint *j = cni_joint_works(world)[k->work[l]].record;
	float limit = k->limit_j[l] > 0.0f ? j->impulse[CNI_REVOLUTE_LIMIT] : -j->impulse[CNI_REVOLUTE_LIMIT];
	float x = k->jx[l] - load_part(k->jx[l], j->impulse[0]), y = k->jy[l] - load_part(k->jy[l], j->impulse[1]);
	float motor = k->motor_j[l] - load_part(k->motor_j[l], j->impulse[CNI_REVOLUTE_MOTOR]), stop = k->limit_j[l] - load_part(k->limit_j[l], limit);
	response_take_out(world, k->ia[l], -x, -y, k->ay[l] * x - k->ax[l] * y - motor - stop);
	response_take_out(world, k->ib[l], x, y, k->bx[l] * y - k->by[l] * x + motor + stop);
	k->jx[l] -= x;
	k->jy[l] -= y;
	k->motor_j[l] -= motor;
	k->limit_j[l] -= stop;
}

/* The same of those in lanes; pins that are solved directly have their impulses in their works. */
static void joint_lanes_forget(cn_world *world)
{
	int32_t index, l;
	for (index = 0; index < world->joint_blocks.count; ++index) {
		cni_joint_block *k = cni_joint_blocks(world) + index;
		for (l = 0; l < CNI_LANES; ++l)
			if (shocked(world, k->ia[l], k->ib[l]))
				joint_lane_forget(world, k, l);
	}
}

void cni_shocks_forget(cn_world *world, const cni_solve *s)
{
	if (shocks_mark(world, s) == 0)
		return;
	contacts_forget(world);
	joints_forget(world);
	joint_lanes_forget(world);
}
