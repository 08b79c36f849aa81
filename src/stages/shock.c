/*
 * stages/shock.c - where a body's velocity jumped in a substep, by much more than its drive gives, solves may fail.
 *
 * Warm starting assumes that the next substep needs about the impulses of the last one. That is true of
 * loads and false of impacts: given again, an impact's impulses drive bodies apart, and one sweep of the solver does
 * not take all of that back when light bodies are caught among heavy ones; the energy may grow from substep to
 * substep. So energy.c holds it, in the islands of such bodies. Their contacts keep their impulses: a crowd that is
 * pressed together jumps in every substep, and would begin each without what holds it apart (it overlaps up to
 * twice as much then, and more bodies touch). But where the energy is not held, among what kinematic bodies and conveyors
 * push, the impulses of their contacts start from nothing in the next substep. Those of joints start from the load
 * they had, everywhere.
 *
 * Reads motion, start, drive; writes start (struck, and the response that is taken out), block.jn jt,
 * joint impulses.
 */
#include "base/bitset.h"
#include "stages/integrate_pass.h"
#include "stages/joint_pass.h"

#define BODIES_A_RANGE 256 /* about a microsecond each */
#define BLOCKS_A_RANGE 16
#define BLOCKS_AHEAD 4     /* whose bodies are asked for */
#define BLOCKS_AT_ONCE 8   /* whose rows are */

typedef struct shock_loop {
	cn_world *world;
	const cni_solve *s;
	const cni_listed_block *blocks; /* of one colour */
	int32_t one_sided;              /* lane bodies b cannot move, and other lanes have them too: they are not written */
	uint32_t shocks;
} shock_loop;

/* Marks a body whose velocity jumped. start holds v + h a, so the jump is motion.v - start + h a. Returns 1 when it did. */
CNI_INLINE uint32_t mark(const cni_motion *m, cni_velocity_start *start, const cni_drive *d, float h, float most_sq)
{
	float dx = m->vx - start->vx, dy = m->vy - start->vy, ax, ay, jump_sq = dx * dx + dy * dy;
	if (jump_sq <= most_sq || !(d->flags & CNI_DRIVE_TOUCHED)) /* nearly all are slower, whatever their drive */
		return 0;
	ax = h * d->ax;
	ay = h * d->ay;
	if (jump_sq <= most_sq + 64.0f * (ax * ax + ay * ay))
		return 0;
	start->struck = CNI_SHOCKED;
	return 1;
}

/* Marks and counts them. A kernel passes by those that are slow. */
static void mark_range(void *context, int32_t begin, int32_t end, int32_t worker)
{
	shock_loop *loop = (shock_loop *)context;
	const cni_body_kernel *kernel = loop->s->body_kernel;
	cni_body_pass pass = { loop->world, cni_motions(loop->world), cni_starts(loop->world), cni_drives(loop->world), loop->s->h, 0 };
	float most_sq = loop->s->shock_speed * loop->s->shock_speed;
	uint32_t shocks = 0;
	int32_t k = begin + 1, last;
	(void)worker;
	while (k <= end) {
		if (kernel != NULL)
			k = kernel->calm(&pass, k, end + 1, most_sq);
		for (last = cni_min_i(k + CNI_CALM_MOST - 1, end); k <= last; ++k)
			shocks += mark(&pass.motions[k], &pass.starts[k], &pass.drives[k], pass.h, most_sq);
	}
	if (shocks > 0)
		cni_atomic_add(&loop->shocks, shocks);
}

int32_t cni_shocked_next(const cn_world *world, int32_t index)
{
	const cni_velocity_start *s = cni_starts(world);
	int32_t k, count = world->awake_count;
	for (k = index; k < count; ++k) {
		while (k + 4 <= count && s[k].struck + s[k + 1].struck + s[k + 2].struck + s[k + 3].struck < CNI_SHOCKED)
			k += 4;
		if (k >= count || s[k].struck >= CNI_SHOCKED)
			break;
	}
	return k;
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

static void lane_forget(cn_world *world, cni_contact_block *k, int32_t l, int32_t one_sided)
{
	float j0 = k->p[0].jn[l], j1 = k->p[1].jn[l], jt = k->jt[l], jn = j0 + j1;
	float px = jn * k->nx[l] + jt * k->ny[l], py = jn * k->ny[l] - jt * k->nx[l];
	response_take_out(world, k->ia[l], -px, -py, -(k->p[0].at[l] * j0 + k->p[1].at[l] * j1 - k->fa[l] * jt));
	if (!one_sided)
		response_take_out(world, k->ib[l], px, py, (k->p[0].at[l] - k->dt[l]) * j0 + (k->p[1].at[l] - k->dt[l]) * j1 - k->fb[l] * jt);
	k->p[0].jn[l] = k->p[1].jn[l] = k->jt[l] = 0.0f;
	k->p[0].load[l] = k->p[1].load[l] = 0.0f;
}

/* Lanes with a body whose energy is not held, as bits: few have one, and looking for them without a branch takes the same
   time for all. */
static uint32_t lanes_unheld(const cn_world *world, const cni_contact_block *k, int32_t lanes)
{
	const cni_velocity_start *starts = cni_starts(world);
	uint32_t bits = 0;
	int32_t l;
	for (l = 0; l < lanes; ++l)
		bits |= (uint32_t)((starts[k->ia[l]].struck == CNI_UNHELD) | (starts[k->ib[l]].struck == CNI_UNHELD)) << l;
	return bits;
}

CNI_INLINE void indices_prefetch(const cni_contact_block *k)
{
	CNI_PREFETCH(k->ia);
	CNI_PREFETCH(k->ib);
}

/* What lane_forget reads and writes. Inlined by force: compilers take a function that only prefetches for one that does
   nothing. */
CNI_INLINE void rows_prefetch(const cni_contact_block *k)
{
	int32_t point;
	CNI_PREFETCH(k->nx);
	CNI_PREFETCH(k->ny);
	CNI_PREFETCH(k->dt);
	CNI_PREFETCH(k->fa);
	CNI_PREFETCH(k->fb);
	CNI_PREFETCH(k->jt);
	for (point = 0; point < 2; ++point) {
		CNI_PREFETCH(k->p[point].at);
		CNI_PREFETCH(k->p[point].jn);
		CNI_PREFETCH(k->p[point].load);
	}
}

/* Some blocks at once: the rows of those with such a lane come while the others are looked at. */
static void forget_range(void *context, int32_t begin, int32_t end, int32_t worker)
{
	const shock_loop *loop = (const shock_loop *)context;
	uint32_t lanes[BLOCKS_AT_ONCE];
	int32_t first, last, k;
	(void)worker;
	for (first = begin; first < end; first = last) {
		last = cni_min_i(first + BLOCKS_AT_ONCE, end);
		for (k = first; k < last; ++k) {
			if (k + BLOCKS_AHEAD < end)
				indices_prefetch(loop->blocks[k + BLOCKS_AHEAD].rows);
			lanes[k - first] = lanes_unheld(loop->world, loop->blocks[k].rows, loop->blocks[k].lanes);
			if (lanes[k - first] != 0)
				rows_prefetch(loop->blocks[k].rows);
		}
		for (k = first; k < last; ++k)
			for (; lanes[k - first] != 0; lanes[k - first] &= lanes[k - first] - 1)
				lane_forget(loop->world, loop->blocks[k].rows, cni_bit_lowest32(lanes[k - first]), loop->one_sided);
	}
}

static int32_t color_is_one_sided(int32_t color)
{
	return color >= CNI_COLOR_STATIC && color != CNI_COLOR_OVERFLOW;
}

static void color_forget(cn_world *world, shock_loop *loop, int32_t color)
{
	loop->blocks = cni_listed_blocks(world, color);
	loop->one_sided = color_is_one_sided(color);
	cni_team_for(color == CNI_COLOR_OVERFLOW ? NULL : loop->s->team, world->colors[color].listed_count, BLOCKS_A_RANGE, forget_range, loop);
}

static void contacts_forget(cn_world *world, shock_loop *loop)
{
	int32_t color;
	for (color = 0; color < CNI_COLORS; ++color)
		color_forget(world, loop, color);
}

/* The part of an impulse that goes the way of the load, and no farther. */
static float load_part(float impulse, float load)
{
	return load > 0.0f ? cni_clamp(impulse, 0.0f, load) : cni_clamp(impulse, load, 0.0f);
}

static void row_forget(cn_world *world, const cni_joint_work *w, const cni_lever *row, int32_t slot, float *impulse)
{
	float kept, j;
	CNI_ASSERT(slot < CNI_JOINT_ROWS);
	kept = load_part(*impulse, w->record->impulse[slot]);
	j = *impulse - kept;
	response_take_out(world, w->ia, row->ax * j, row->ay * j, row->aw * j);
	response_take_out(world, w->ib, row->bx * j, row->by * j, row->bw * j);
	*impulse = kept;
}

/* A pin that its herd solves directly, as if it had rows. */
static void pin_forget(cn_world *world, const cni_joint_work *w, cni_joint_block *k, int32_t l)
{
	cni_lever x = { -1.0f, 0.0f, k->ay[l], 1.0f, 0.0f, -k->by[l] }, y = { 0.0f, -1.0f, -k->ax[l], 0.0f, 1.0f, k->bx[l] };
	if (!k->herd || !(k->direct >> l & 1u))
		return;
	row_forget(world, w, &x, 0, &k->jx[l]);
	row_forget(world, w, &y, 1, &k->jy[l]);
}

/* Those in lanes; pins that are solved directly have their impulses in rows, or as if they had. */
static void joint_lane_forget(cn_world *world, const cni_joint *j, cni_joint_block *k, int32_t l)
{
	int32_t apart = k->herd && (k->direct >> l & 1u);
	float limit = k->limit_j[l] > 0.0f ? j->impulse[CNI_REVOLUTE_LIMIT] : -j->impulse[CNI_REVOLUTE_LIMIT];
	float x = apart ? 0.0f : k->jx[l] - load_part(k->jx[l], j->impulse[0]), y = apart ? 0.0f : k->jy[l] - load_part(k->jy[l], j->impulse[1]);
	float motor = k->motor_j[l] - load_part(k->motor_j[l], j->impulse[CNI_REVOLUTE_MOTOR]), stop = k->limit_j[l] - load_part(k->limit_j[l], limit);
	response_take_out(world, k->ia[l], -x, -y, k->ay[l] * x - k->ax[l] * y - motor - stop);
	response_take_out(world, k->ib[l], x, y, k->bx[l] * y - k->by[l] * x + motor + stop);
	k->jx[l] -= x;
	k->jy[l] -= y;
	k->motor_j[l] -= motor;
	k->limit_j[l] -= stop;
}

static void rows_forget(cn_world *world, const cni_joint_work *w, cni_row *rows, int32_t count)
{
	int32_t r;
	for (r = 0; r < count; ++r) {
		cni_lever lever = cni_row_lever(&rows[r]);
		if (rows[r].kind != CNI_ROW_SPRING && rows[r].kind != CNI_ROW_DRIVE)
			row_forget(world, w, &lever, rows[r].slot, &rows[r].impulse);
	}
}

static void row_lane_forget(cn_world *world, const cni_joint_work *w)
{
	cni_row rows[CNI_JOINT_ROWS];
	rows_forget(world, w, rows, cni_row_lane_read(world, w, rows));
	cni_row_lane_write(world, w, rows);
}

/*
 * A joint forgets what goes beyond its load at the beginning of the step: without that a bridge which is hit would
 * lose the tension it stands by, jump for that reason, and the shock would run through all of it. Springs
 * are forces that are meant, and their coefficients count on the impulse.
 */
static void joints_forget(cn_world *world)
{
	int32_t k;
	for (k = 0; k < world->awake_joints.count; ++k) {
		cni_joint_work *w = (cni_joint_work *)world->joint_work.data + k;
		if (cni_starts(world)[w->ia].struck < CNI_SHOCKED && cni_starts(world)[w->ib].struck < CNI_SHOCKED)
			continue;
		if (w->lane != CNI_NONE)
			pin_forget(world, w, cni_joint_block_of(world, w), w->lane % CNI_LANES);
		rows_forget(world, w, w->rows, w->row_count);
		if (w->row_lane != CNI_NONE)
			row_lane_forget(world, w);
		if (w->lane != CNI_NONE)
			joint_lane_forget(world, w->record, cni_joint_block_of(world, w), w->lane % CNI_LANES);
	}
}

void cni_shocks_forget(cn_world *world, const cni_solve *s)
{
	shock_loop loop;
	loop.world = world;
	loop.s = s;
	loop.shocks = 0;
	cni_team_for(s->team, world->awake_count - 1, BODIES_A_RANGE, mark_range, &loop);
	if (loop.shocks == 0)
		return;
	if (cni_energy_hold(world) > 0)
		contacts_forget(world, &loop);
	joints_forget(world);
}
