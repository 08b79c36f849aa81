/*
 * stages/integrate.c - motion between constraints: drives, velocities, positions.
 *
 * Reads body records (damping, gravity scale) and the forces in drive, writes drive, start and motion.
 *
 * Bodies that nothing touches are free: their whole step is taken at once and exactly (x += h v + h^2 a/2).
 * Others integrate by substep as x += h v', which is then corrected to the trapezoid rule
 * x += h (v + v')/2 one substep later, when v' is free of the pushing that the soft solve adds; not after
 * an impact, where the velocity jumps, and not for jointed bodies, whose joints hold at v'.
 *
 * start is the velocity right after integration: motion.v - start at the end of a substep is the response
 * to all impulses, so adding it again is the next substep's warm start (exact, because contact anchors
 * are fixed within the step; joints correct for their turning anchors in joint_solve.c).
 */
#include "base/cpu.h"
#include "stages/solver.h"
#if CNI_HAS_WIDE_4
#define CNI_WIDTH 4
#include "base/wide.h"
#endif

#define BODIES_A_RANGE 256 /* about a microsecond */
#define DRIVES_A_RANGE 512 /* about ten: their records are read */

/* Has it a joint that is solved? Filters and joints with a disabled body are not. */
static int32_t body_is_jointed(const cn_world *world, const cni_body *b)
{
	int32_t key;
	for (key = b->joint_first; key != CNI_NONE; key = cni_joint_at(world, key >> 1)->next[key & 1])
		if (cni_joint_at(world, key >> 1)->awake != CNI_NONE)
			return 1;
	return 0;
}

static uint32_t lock_flags(uint32_t body_flags)
{
	return (body_flags & CN_BODY_LOCK_X ? (uint32_t)CNI_DRIVE_LOCK_X : 0u) | (body_flags & CN_BODY_LOCK_Y ? (uint32_t)CNI_DRIVE_LOCK_Y : 0u);
}

CNI_INLINE uint32_t drive_flags(const cn_world *world, const cni_body *b)
{
	uint32_t flags = b->lanes != 0 ? (uint32_t)CNI_DRIVE_TOUCHED : 0u;
	if (b->joint_first != CNI_NONE && body_is_jointed(world, b))
		flags |= CNI_DRIVE_JOINTED;
	if (flags == 0)
		flags = CNI_DRIVE_FREE;
	if (b->linear_damping + b->angular_damping > 0.0f)
		flags |= CNI_DRIVE_DAMPED;
	if (b->flags & (CN_BODY_LOCK_X | CN_BODY_LOCK_Y))
		flags |= lock_flags(b->flags);
	return flags;
}

/* d: the user's force, as it is held between steps, becomes the step's drive. */
CNI_INLINE void drive_make(const cn_world *world, const cni_body *b, const cni_motion *m, cni_drive *d)
{
	uint32_t flags = drive_flags(world, b);
	d->flags = flags;
	if (b->type != CN_BODY_DYNAMIC) {
		d->ax = d->ay = d->alpha = 0.0f;
		return;
	}
	d->ax = b->gravity_scale * world->settings.gravity.x + m->inv_mass * d->ax;
	d->ay = b->gravity_scale * world->settings.gravity.y + m->inv_mass * d->ay;
	d->alpha = m->inv_inertia * d->alpha;
	if (m->inv_mass != 0.0f && !(flags & (CNI_DRIVE_LOCK_X | CNI_DRIVE_LOCK_Y)))
		return;
	if (m->inv_mass == 0.0f || (flags & CNI_DRIVE_LOCK_X))
		d->ax = 0.0f;
	if (m->inv_mass == 0.0f || (flags & CNI_DRIVE_LOCK_Y))
		d->ay = 0.0f;
}

/* Exact flight over time h. */
static void fly(cni_motion *m, const cni_drive *d, float h)
{
	float half = 0.5f * h * h;
	m->dpx += h * m->vx + half * d->ax;
	m->dpy += h * m->vy + half * d->ay;
	m->theta += h * m->w + half * d->alpha;
	m->vx += h * d->ax;
	m->vy += h * d->ay;
	m->w += h * d->alpha;
}

static void fly_damped(cni_motion *m, const cni_drive *d, const cni_body *b, const cni_solve *s)
{
	float linear = cni_damping_factor(b->linear_damping, s->h), angular = cni_damping_factor(b->angular_damping, s->h);
	float half = 0.5f * s->h;
	int32_t k;
	for (k = 0; k < s->substeps; ++k) {
		float vx = linear * (m->vx + s->h * d->ax), vy = linear * (m->vy + s->h * d->ay), w = angular * (m->w + s->h * d->alpha);
		m->dpx += half * (m->vx + vx);
		m->dpy += half * (m->vy + vy);
		m->theta += half * (m->w + w);
		m->vx = vx;
		m->vy = vy;
		m->w = w;
	}
}

/* A loop over the awake bodies, each of which is read and written by itself. */
typedef struct body_loop {
	cn_world *world;
	const cni_solve *s;
	int32_t substep;
} body_loop;

/* run gets the bodies' dense indices. */
static void bodies_run(cni_team *team, int32_t min_range, cni_range_fn *run, cn_world *world, const cni_solve *s, int32_t substep)
{
	body_loop loop;
	loop.world = world;
	loop.s = s;
	loop.substep = substep;
	cni_team_for(team, world->awake_count - 1, min_range, run, &loop);
}

static void drive_range(void *context, int32_t begin, int32_t end, int32_t worker)
{
	const body_loop *loop = (const body_loop *)context;
	const cn_world *world = loop->world;
	cni_motion *motions = cni_motions(world);
	cni_drive *drives = cni_drives(world);
	const int32_t *ids = cni_awake_ids(world);
	int32_t k;
	(void)worker;
	for (k = begin + 1; k <= end; ++k) {
		cni_body *b = cni_body_at(world, ids[k]);
		b->flags &= ~(uint32_t)CNI_BODY_MOVED;
		if (world->awake_islands != NULL)
			world->awake_islands[k] = b->island;
		drive_make(world, b, &motions[k], &drives[k]);
		if (!(drives[k].flags & CNI_DRIVE_FREE))
			continue;
		if (drives[k].flags & CNI_DRIVE_DAMPED)
			fly_damped(&motions[k], &drives[k], b, loop->s);
		else
			fly(&motions[k], &drives[k], loop->s->dt);
	}
}

void cni_drive_prepare(cn_world *world, const cni_solve *s)
{
	if (world->island_count > 0)
		world->awake_islands = (int32_t *)cni_arena_push(&world->arena, sizeof(int32_t) * (uint64_t)world->awake_count);
	if (world->awake_islands != NULL)
		world->awake_islands[0] = CNI_NONE;
	bodies_run(world->team, DRIVES_A_RANGE, drive_range, world, s, 0);
}

/* The arena has it until the end of the step, as what else is pushed between. */
void cni_drive_finish(cn_world *world)
{
	world->awake_islands = NULL;
}

void cni_drive_prepare_bound(cn_world *world)
{
	cni_drive *drives = cni_drives(world);
	int32_t k;
	for (k = 1; k < world->awake_count; ++k) {
		cni_body *b = cni_body_at(world, cni_awake_ids(world)[k]);
		b->flags &= ~(uint32_t)CNI_BODY_MOVED;
		drive_make(world, b, cni_motions(world) + k, &drives[k]);
		drives[k].flags &= ~(uint32_t)CNI_DRIVE_FREE;
	}
}

/* The last substep's x += h v' becomes x += h (v + v')/2 when v' - v is no more than a few times what
   the drive gives: v' - v = motion.v - start + h a. */
static void correct_to_trapezoid(cni_motion *m, const cni_velocity_start *start, const cni_drive *d, float h)
{
	float ax = h * d->ax, ay = h * d->ay, alpha = h * d->alpha;
	float dx = m->vx - start->vx + ax, dy = m->vy - start->vy + ay, dw = m->w - start->w + alpha;
	if (start->struck != 0.0f || dx * dx + dy * dy > 4.0f * (ax * ax + ay * ay))
		return;
	m->dpx -= 0.5f * h * dx;
	m->dpy -= 0.5f * h * dy;
	m->theta -= 0.5f * h * dw;
}

/* Any body: with damping, or where there are no vectors. first: of the step's substeps. */
static void velocity_take(const cn_world *world, int32_t k, float h, int32_t first)
{
	cni_motion *m = cni_motions(world) + k;
	cni_velocity_start *start = cni_starts(world) + k;
	const cni_drive *d = cni_drives(world) + k;
	float rx = 0.0f, ry = 0.0f, rw = 0.0f;
	if (!first) {
		if (!(d->flags & (CNI_DRIVE_JOINTED | CNI_DRIVE_DAMPED)))
			correct_to_trapezoid(m, start, d, h);
		rx = m->vx - start->vx;
		ry = m->vy - start->vy;
		rw = m->w - start->w;
	}
	start->vx = m->vx + h * d->ax;
	start->vy = m->vy + h * d->ay;
	start->w = m->w + h * d->alpha;
	if (d->flags & CNI_DRIVE_DAMPED) {
		const cni_body *b = cni_body_at(world, cni_awake_ids(world)[k]);
		float linear = cni_damping_factor(b->linear_damping, h);
		start->vx *= linear;
		start->vy *= linear;
		start->w *= cni_damping_factor(b->angular_damping, h);
	}
	start->struck = 0.0f;
	m->vx = start->vx + rx;
	m->vy = start->vy + ry;
	m->w = start->w + rw;
}

#if CNI_HAS_WIDE_4

static const cni_mask three = { -1, -1, -1, 0 }; /* components, without the inverse mass or the flags beside them */

static cni_wide only_three(cni_wide a)
{
	return (cni_wide)((cni_mask)a & three);
}

/* With the bits of correct_to_trapezoid. response: motion.v - start; change: what the drive gives. */
static void correct_to_trapezoid_wide(cni_motion *m, const cni_velocity_start *start, cni_wide response, cni_wide change, float h)
{
	cni_wide jump = response + change, jump_sq = jump * jump, change_sq = change * change;
	if (start->struck == 0.0f && !(jump_sq[0] + jump_sq[1] > 4.0f * (change_sq[0] + change_sq[1])))
		cni_wide_store(&m->dpx, cni_wide_load(&m->dpx) - cni_wide_of(0.5f * h) * jump);
}

/* The three components of a body without damping at once, with the bits of velocity_take. */
static void velocity_take_wide(cni_motion *m, cni_velocity_start *start, const cni_drive *d, float h, int32_t first)
{
	cni_wide v = cni_wide_load(&m->vx), change = cni_wide_of(h) * only_three(cni_wide_load(&d->ax)), response = { 0 }, from;
	if (!first) {
		response = only_three(v - cni_wide_load(&start->vx));
		if (!(d->flags & CNI_DRIVE_JOINTED))
			correct_to_trapezoid_wide(m, start, response, change, h);
	}
	from = v + change;
	cni_wide_store(&start->vx, only_three(from));
	cni_wide_store(&m->vx, from + response);
}

static void position_finish(cni_motion *m, const cni_velocity_start *start, const cni_drive *d, float h)
{
	cni_wide response = only_three(cni_wide_load(&m->vx) - cni_wide_load(&start->vx));
	correct_to_trapezoid_wide(m, start, response, cni_wide_of(h) * only_three(cni_wide_load(&d->ax)), h);
}

static void position_take(cni_motion *m, float h)
{
	cni_wide_store(&m->dpx, cni_wide_load(&m->dpx) + cni_wide_of(h) * only_three(cni_wide_load(&m->vx)));
}

#else

static void position_finish(cni_motion *m, const cni_velocity_start *start, const cni_drive *d, float h)
{
	correct_to_trapezoid(m, start, d, h);
}

static void position_take(cni_motion *m, float h)
{
	m->dpx += h * m->vx;
	m->dpy += h * m->vy;
	m->theta += h * m->w;
}

#endif

static void velocity_range(void *context, int32_t begin, int32_t end, int32_t worker)
{
	const body_loop *loop = (const body_loop *)context;
	const cn_world *world = loop->world;
	const cni_drive *drives = cni_drives(world);
	float h = loop->s->h;
	int32_t k, first = loop->substep == 0;
	(void)worker;
	for (k = begin + 1; k <= end; ++k) {
		if (drives[k].flags & (CNI_DRIVE_FREE | CNI_DRIVE_SWUNG))
			continue;
#if CNI_HAS_WIDE_4
		if (!(drives[k].flags & CNI_DRIVE_DAMPED)) {
			velocity_take_wide(cni_motions(world) + k, cni_starts(world) + k, &drives[k], h, first);
			continue;
		}
#endif
		velocity_take(world, k, h, first);
	}
}

void cni_integrate_velocities(cn_world *world, const cni_solve *s, int32_t substep)
{
	bodies_run(s->team, BODIES_A_RANGE, velocity_range, world, s, substep);
}

static void position_range(void *context, int32_t begin, int32_t end, int32_t worker)
{
	const body_loop *loop = (const body_loop *)context;
	cni_motion *motions = cni_motions(loop->world);
	const cni_drive *drives = cni_drives(loop->world);
	float h = loop->s->h;
	int32_t k;
	(void)worker;
	for (k = begin + 1; k <= end; ++k) {
		cni_motion *m = &motions[k];
		if (drives[k].flags & (CNI_DRIVE_FREE | CNI_DRIVE_SWUNG | CNI_DRIVE_LOCK_X | CNI_DRIVE_LOCK_Y)) {
			if (drives[k].flags & (CNI_DRIVE_FREE | CNI_DRIVE_SWUNG))
				continue;
			if (drives[k].flags & CNI_DRIVE_LOCK_X)
				m->vx = 0.0f;
			if (drives[k].flags & CNI_DRIVE_LOCK_Y)
				m->vy = 0.0f;
		}
		position_take(m, h);
	}
}

void cni_integrate_positions(cn_world *world, const cni_solve *s)
{
	bodies_run(s->team, BODIES_A_RANGE, position_range, world, s, 0);
}

static void finish_range(void *context, int32_t begin, int32_t end, int32_t worker)
{
	const body_loop *loop = (const body_loop *)context;
	cni_motion *motions = cni_motions(loop->world);
	const cni_velocity_start *starts = cni_starts(loop->world);
	const cni_drive *drives = cni_drives(loop->world);
	int32_t k;
	(void)worker;
	for (k = begin + 1; k <= end; ++k) {
		if (!(drives[k].flags & (CNI_DRIVE_FREE | CNI_DRIVE_JOINTED | CNI_DRIVE_DAMPED)))
			position_finish(&motions[k], &starts[k], &drives[k], loop->s->h);
		if (!(drives[k].flags & (CNI_DRIVE_LOCK_X | CNI_DRIVE_LOCK_Y)))
			continue;
		if (drives[k].flags & CNI_DRIVE_LOCK_X)
			motions[k].vx = 0.0f;
		if (drives[k].flags & CNI_DRIVE_LOCK_Y)
			motions[k].vy = 0.0f;
	}
}

void cni_integrate_finish(cn_world *world, const cni_solve *s)
{
	bodies_run(s->team, BODIES_A_RANGE, finish_range, world, s, 0);
}
