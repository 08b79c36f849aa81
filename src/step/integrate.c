/*
 * step/integrate.c - motion between constraints: external accelerations, velocities, positions.
 *
 * Reads body records (damping, gravity scale) and the user's forces in external; writes external, start and motion.
 *
 * Bodies without contacts and joints are free: their whole step is integrated at once and exactly (x += h v + h^2 a/2). Others
 * integrate by substep as x += h v'. One substep later, when v' no longer contains the push of the soft solve, this is corrected
 * to the trapezoid rule x += h (v + v')/2. There is no correction after an impact, where the velocity jumps, and for jointed
 * bodies, whose joints hold at v'.
 *
 * start is the velocity right after integration. motion.v - start at the end of a substep is the response to all impulses, so
 * adding it again is the next substep's warm start (exact, because contact anchors are fixed within the step; joints correct for
 * their turning anchors in joint_solve.c).
 */
#include "step/stages.h"
#include "base/cpu.h"
#include "step/integrate_pass.h"

#define BODIES_A_RANGE 256 /* about a microsecond */
#define DRIVES_A_RANGE 512 /* about ten: their records are read */

/* More islands than this part of the awake bodies: what is kept for each island of a step is kept for those that are awake. */
#define FEW_ISLANDS_PART 4

/* Has the body a joint that is solved? Filters and joints to a disabled body are not. */
static int32_t body_is_jointed(const cn_world *world, const cni_body *b)
{
	for (int32_t key = b->joint_first; key != CNI_NONE; key = cni_joint_at(world, key >> 1)->next[key & 1])
		if (cni_joint_at(world, key >> 1)->awake != CNI_NONE)
			return 1;
	return 0;
}

CNI_INLINE uint32_t external_flags(const cn_world *world, const cni_body *b)
{
	uint32_t flags = b->lanes != 0 ? (uint32_t)CNI_EXTERNAL_TOUCHED : 0u;
	if (b->joint_first != CNI_NONE && body_is_jointed(world, b))
		flags |= CNI_EXTERNAL_JOINTED;
	if (flags == 0 && CNI_ON(FLIGHT))
		flags = CNI_EXTERNAL_FREE;
	if (b->linear_damping + b->angular_damping > 0.0f && b->type == CN_BODY_DYNAMIC)
		flags |= CNI_EXTERNAL_DAMPED;
	if (b->sleep_time > 0.0f && b->sleep_time >= CNI_SETTLED_DELAYS * world->settings.sleep_delay)
		flags |= CNI_EXTERNAL_SETTLED;
	if (b->flags & (CN_BODY_LOCK_X | CN_BODY_LOCK_Y))
		flags |= (b->flags & CN_BODY_LOCK_X ? (uint32_t)CNI_EXTERNAL_LOCK_X : 0u) | (b->flags & CN_BODY_LOCK_Y ? (uint32_t)CNI_EXTERNAL_LOCK_Y : 0u);
	return flags;
}

/* Turns the user's force in d, stored between steps, into the step's external acceleration. */
CNI_INLINE void external_make(const cn_world *world, const cni_body *b, const cni_motion *m, cni_external *d)
{
	uint32_t flags = external_flags(world, b);
	d->flags = flags;
	if (b->type != CN_BODY_DYNAMIC) {
		d->ax = d->ay = d->alpha = 0.0f;
		return;
	}
	d->ax = b->gravity_scale * world->settings.gravity.x + m->inv_mass * d->ax;
	d->ay = b->gravity_scale * world->settings.gravity.y + m->inv_mass * d->ay;
	d->alpha = m->inv_inertia * d->alpha;
	if (m->inv_mass != 0.0f && !(flags & (CNI_EXTERNAL_LOCK_X | CNI_EXTERNAL_LOCK_Y)))
		return;
	if (m->inv_mass == 0.0f || (flags & CNI_EXTERNAL_LOCK_X))
		d->ax = 0.0f;
	if (m->inv_mass == 0.0f || (flags & CNI_EXTERNAL_LOCK_Y))
		d->ay = 0.0f;
}

/* Exact flight over time h. */
CNI_INLINE void fly(cni_motion *m, const cni_external *d, float h)
{
	float half = 0.5f * h * h;
	m->dpx += h * m->vx + half * d->ax;
	m->dpy += h * m->vy + half * d->ay;
	m->theta += h * m->w + half * d->alpha;
	m->vx += h * d->ax;
	m->vy += h * d->ay;
	m->w += h * d->alpha;
}

static void fly_damped(cni_motion *m, const cni_external *d, const cni_body *b, const cni_solve *s)
{
	float linear = cni_damping_factor(b->linear_damping, s->h), angular = cni_damping_factor(b->angular_damping, s->h);
	float half = 0.5f * s->h;
	for (int32_t k = 0; k < s->substeps; ++k) {
		float vx = linear * (m->vx + s->h * d->ax), vy = linear * (m->vy + s->h * d->ay), w = angular * (m->w + s->h * d->alpha);
		m->dpx += half * (m->vx + vx);
		m->dpy += half * (m->vy + vy);
		m->theta += half * (m->w + w);
		m->vx = vx;
		m->vy = vy;
		m->w = w;
	}
}

/* In a world with areas: takes the acceleration of a body in one (step/areas.c). */
static void external_make_in_area(const cn_world *world, cni_body *b, const cni_velocity_start *start, cni_external *d)
{
	d->flags = external_flags(world, b);
	d->ax = start->vx;
	d->ay = start->vy;
	d->alpha = start->w;
	b->flags |= CNI_BODY_IN_AREA;
}

static cni_body_pass body_pass_make(cn_world *world, const cni_solve *s, int32_t substep)
{
	cni_body_pass pass = { world, s, cni_motions(world), cni_starts(world), cni_externals(world), s->h, substep == 0 };
	return pass;
}

/* run receives the bodies' dense indices, less one. */
static void bodies_run(cni_team *team, int32_t min_range, cni_range_fn *run, cn_world *world, const cni_solve *s, int32_t substep)
{
	cni_body_pass pass = body_pass_make(world, s, substep);
	cni_team_for(team, world->awake_count - 1, min_range, run, &pass);
}

/* The external acceleration of one body. */
CNI_INLINE cni_body *body_external_make(const cn_world *world, int32_t k, int32_t in_areas)
{
	cni_external *d = cni_externals(world) + k;
	cni_body *b = cni_body_at(world, cni_awake_ids(world)[k]);
	b->flags &= ~(uint32_t)CNI_BODY_OF_A_STEP;
	if (in_areas && (d->flags & CNI_EXTERNAL_DEFERRED))
		external_make_in_area(world, b, cni_starts(world) + k, d);
	else
		external_make(world, b, cni_motions(world) + k, d);
	return b;
}

static void external_range(void *context, int32_t begin, int32_t end)
{
	const cni_body_pass *pass = (const cni_body_pass *)context;
	const cn_world *world = pass->world;
	cni_motion *motions = cni_motions(world);
	cni_external *externals = cni_externals(world);
	int32_t *islands = world->awake_islands, in_areas = cni_has_areas(world);
	for (int32_t k = begin + 1; k <= end; ++k) {
		const cni_body *b = body_external_make(world, k, in_areas);
		if (islands != NULL)
			islands[k] = b->island;
		if (!(externals[k].flags & CNI_EXTERNAL_FREE))
			continue;
		if (externals[k].flags & CNI_EXTERNAL_DAMPED)
			fly_damped(&motions[k], &externals[k], b, pass->s);
		else
			fly(&motions[k], &externals[k], pass->s->dt);
	}
}

/* If few islands are awake, numbers them in the order of their first bodies. */
static void islands_number(cn_world *world)
{
	int32_t *islands = world->awake_islands;
	world->step_island_count = 0;
	for (int32_t k = 1; k < world->awake_count; ++k) {
		if (islands[k] == CNI_NONE)
			continue;
		cni_island *i = cni_island_at(world, islands[k]);
		if (i->numbered_step != world->step_count + 1u) {
			i->numbered_step = world->step_count + 1u;
			i->number = world->step_island_count++;
			world->step_islands[i->number] = islands[k];
		}
		islands[k] = i->number;
	}
}

void cni_external_prepare(cn_world *world, const cni_solve *s)
{
	int32_t some = world->island_count > 0 && world->awake_count > 1;
	if (some)
		world->awake_islands = (int32_t *)cni_arena_push(&world->arena, sizeof(int32_t) * (uint64_t)world->awake_count);
	if (world->awake_islands != NULL)
		world->awake_islands[0] = CNI_NONE;
	if (cni_has_areas(world))
		cni_areas_accelerate(world, s->dt);
	bodies_run(world->team, DRIVES_A_RANGE, external_range, world, s, 0);
	if (world->awake_islands != NULL && world->island_used > world->awake_count / FEW_ISLANDS_PART) /* awake ones have two bodies or more */
		world->step_islands = (int32_t *)cni_arena_push(&world->arena, sizeof(int32_t) * (uint64_t)world->awake_count / 2);
	world->step_island_count = some ? world->island_used : 0;
	if (world->step_islands != NULL)
		islands_number(world);
}

/* The arena keeps the memory until the end of the step, as later pushes lie behind it. */
void cni_external_finish(cn_world *world)
{
	world->awake_islands = world->step_islands = NULL;
	world->step_island_count = 0;
}

void cni_external_prepare_bound(cn_world *world, float dt)
{
	if (cni_has_areas(world))
		cni_areas_accelerate(world, dt);
	for (int32_t k = 1; k < world->awake_count; ++k) {
		(void)body_external_make(world, k, cni_has_areas(world));
		cni_externals(world)[k].flags &= ~(uint32_t)CNI_EXTERNAL_FREE;
	}
}

/* v' - v = motion.v - start + h a. If it is at most twice what the external acceleration gives, corrects the last substep's x += h v'
   to x += h (v + v')/2. */
static void correct_to_trapezoid(cni_motion *m, const cni_velocity_start *start, const cni_external *d, float h)
{
	float ax = h * d->ax, ay = h * d->ay, alpha = h * d->alpha;
	float dx = m->vx - start->vx + ax, dy = m->vy - start->vy + ay, dw = m->w - start->w + alpha;
	if (!CNI_ON(TRAPEZOID) || start->jumped != 0.0f || dx * dx + dy * dy > 4.0f * (ax * ax + ay * ay))
		return;
	m->dpx -= 0.5f * h * dx;
	m->dpy -= 0.5f * h * dy;
	m->theta -= 0.5f * h * dw;
}

/* One body: the rest that a kernel's vectors do not cover, and all bodies without a kernel. */
static void velocity_step(const cn_world *world, int32_t k, float h, int32_t first)
{
	cni_motion *m = cni_motions(world) + k;
	cni_velocity_start *start = cni_starts(world) + k;
	const cni_external *d = cni_externals(world) + k;
	float rx = 0.0f, ry = 0.0f, rw = 0.0f;
	if (d->flags & CNI_EXTERNAL_DONE)
		return;
	if (!first) {
		if (!(d->flags & CNI_EXTERNAL_AS_IT_IS))
			correct_to_trapezoid(m, start, d, h);
		rx = m->vx - start->vx;
		ry = m->vy - start->vy;
		rw = m->w - start->w;
	}
	start->vx = m->vx + h * d->ax;
	start->vy = m->vy + h * d->ay;
	start->w = m->w + h * d->alpha;
	if (d->flags & CNI_EXTERNAL_DAMPED) {
		const cni_body *b = cni_body_at(world, cni_awake_ids(world)[k]);
		float linear = cni_damping_factor(b->linear_damping, h);
		start->vx *= linear;
		start->vy *= linear;
		start->w *= cni_damping_factor(b->angular_damping, h);
	}
	start->jumped = 0.0f;
	m->vx = start->vx + rx;
	m->vy = start->vy + ry;
	m->w = start->w + rw;
}

static void axes_lock(cni_motion *m, uint32_t flags)
{
	if (flags & CNI_EXTERNAL_LOCK_X)
		m->vx = 0.0f;
	if (flags & CNI_EXTERNAL_LOCK_Y)
		m->vy = 0.0f;
}

static void position_step(const cn_world *world, int32_t k, float h)
{
	cni_motion *m = cni_motions(world) + k;
	uint32_t flags = cni_externals(world)[k].flags;
	if (flags & CNI_EXTERNAL_DONE)
		return;
	axes_lock(m, flags);
	m->dpx += h * m->vx;
	m->dpy += h * m->vy;
	m->theta += h * m->w;
}

static void position_finish(const cn_world *world, int32_t k, float h)
{
	cni_motion *m = cni_motions(world) + k;
	const cni_external *d = cni_externals(world) + k;
	if (!(d->flags & (CNI_EXTERNAL_FREE | CNI_EXTERNAL_AS_IT_IS)))
		correct_to_trapezoid(m, cni_starts(world) + k, d, h);
	axes_lock(m, d->flags);
}

const cni_body_kernel *cni_body_kernel_choose(void)
{
	return CNI_ON(BODY_KERNELS) ? CNI_WIDEST(NULL, &cni_body_kernel_4, &cni_body_kernel_8) : NULL;
}

static void velocity_range(void *context, int32_t begin, int32_t end)
{
	const cni_body_pass *pass = (const cni_body_pass *)context;
	const cni_body_kernel *kernel = pass->s->body_kernel;
	int32_t k = kernel == NULL ? begin + 1 : kernel->velocities(pass, begin + 1, end + 1);
	for (; k <= end; ++k)
		velocity_step(pass->world, k, pass->h, pass->first);
}

void cni_integrate_velocities(cn_world *world, const cni_solve *s, int32_t substep)
{
	bodies_run(s->team, BODIES_A_RANGE, velocity_range, world, s, substep);
}

static void position_range(void *context, int32_t begin, int32_t end)
{
	const cni_body_pass *pass = (const cni_body_pass *)context;
	const cni_body_kernel *kernel = pass->s->body_kernel;
	int32_t k = kernel == NULL ? begin + 1 : kernel->positions(pass, begin + 1, end + 1);
	for (; k <= end; ++k)
		position_step(pass->world, k, pass->h);
}

void cni_integrate_positions(cn_world *world, const cni_solve *s)
{
	bodies_run(s->team, BODIES_A_RANGE, position_range, world, s, 0);
}

/* Limits of a body's displacement and rotation in a step: finite, and the square of the displacement too. */
typedef struct move_limit {
	float way, turn;
} move_limit;

static move_limit move_limit_make(const cn_world *world, float dt)
{
	const float finite = 1e18f, rounding = 1.0001f;
	move_limit limit = { cni_min(rounding * dt * world->settings.linear_speed_max, finite), cni_min(rounding * dt * world->settings.angular_speed_max, finite) };
	return limit;
}

/* Clamps the displacement of a step: velocities may be absurd between substeps, among joints that are torn far apart. The condition
   also catches NaN. A body within the limit is unchanged, whatever its neighbours in the vector. Returns 1 for a body that is stopped. */
static uint32_t move_clamp(cni_motion *m, const move_limit *limit)
{
	float move_sq = m->dpx * m->dpx + m->dpy * m->dpy;
	if (move_sq <= limit->way * limit->way && cni_abs(m->theta) <= limit->turn)
		return 0;
	uint32_t stopped = cni_motion_keep_finite(m);
	if (move_sq > limit->way * limit->way) {
		float scale = limit->way / cni_sqrt(move_sq);
		m->dpx *= scale;
		m->dpy *= scale;
	}
	m->theta = cni_clamp(m->theta, -limit->turn, limit->turn);
	return stopped;
}

/* Applies speed limits to displacements before other stages read them. The kernel skips bodies within the limit, which are nearly all. */
static void moves_clamp(const cni_body_pass *pass, int32_t begin, int32_t end)
{
	const cni_body_kernel *kernel = pass->s->body_kernel;
	move_limit limit = move_limit_make(pass->world, pass->s->dt);
	uint32_t stopped = 0;
	int32_t k = begin;
	while (k < end) {
		if (kernel != NULL)
			k = kernel->near(pass, k, end, limit.way * limit.way, limit.turn);
		for (int32_t last = cni_min_i(k + CNI_CALM_MOST, end); k < last; ++k)
			stopped += move_clamp(&pass->motions[k], &limit);
	}
	if (stopped > 0)
		(void)cni_atomic_add(&pass->world->bodies_stopped, stopped);
}

void cni_moves_clamp(cn_world *world, const cni_solve *s)
{
	const cni_body_pass pass = body_pass_make(world, s, 0);
	moves_clamp(&pass, 1, world->awake_count);
}

static void finish_range(void *context, int32_t begin, int32_t end)
{
	const cni_body_pass *pass = (const cni_body_pass *)context;
	const cni_body_kernel *kernel = pass->s->body_kernel;
	int32_t k = kernel == NULL ? begin + 1 : kernel->finish(pass, begin + 1, end + 1);
	for (; k <= end; ++k)
		position_finish(pass->world, k, pass->h);
	moves_clamp(pass, begin + 1, end + 1);
}

void cni_integrate_finish(cn_world *world, const cni_solve *s)
{
	bodies_run(s->team, BODIES_A_RANGE, finish_range, world, s, 0);
}
