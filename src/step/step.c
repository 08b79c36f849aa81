/*
 * step/step.c - one step, from beginning to end. Each line of cni_step calls a stage; the file of a stage says what it reads and
 * writes.
 */
#include "step/stages.h"
#include "narrowphase/narrowphase.h"
#include "joints/joints.h"
#include "direct/direct.h"
#include "contacts/contacts.h"
#include "base/clock.h"
#include "linear/sparse.h"
#include "step/step.h"

#include <string.h>

#define SHARED_WORK 1024 /* awake bodies, contacts and joints: fewer are done with before a worker is awake */

/* Adds the time since the last mark to a field of the profile. */
static void profile_mark(cn_world *world, float *field, uint64_t *mark)
{
	if (!CNI_HAS_CLOCK || !(world->settings.flags & CN_WORLD_PROFILE))
		return;
	uint64_t now = cni_clock_ns();
	*field += (float)(now - *mark) * 1e-9f;
	*mark = now;
}

static void step_begin(cn_world *world)
{
	cni_body_masses_settle(world);
	world->warnings = 0;
	world->pairs_not_added = world->events_not_reported = 0;
	world->bodies_stopped = 0;
	memset(&world->profile, 0, sizeof world->profile);
	cni_events_begin_step(&world->events);
	if (cni_has_areas(world))
		cni_areas_wake_moving(world);
	world->events.in_step = 1;
}

/* Does the step have enough work to hold the workers awake for all of it? */
static int32_t team_is_held(const cn_world *world)
{
	int32_t work = world->awake_count + world->awake_joints.count;
	for (int32_t k = 0; world->team != NULL && k < CNI_COLORS; ++k)
		work += world->colors[k].lanes;
	return work >= SHARED_WORK;
}

/* Whether a world has awake joints, and a step direct solving; constants in builds without them. */
static int32_t has_joints(const cn_world *world) { return CNI_HAS_JOINTS && world->awake_joints.count > 0; }
static int32_t has_direct(const cni_solve *s) { return CNI_HAS_DIRECT && s->direct != NULL; }

typedef struct substeps {
	cn_world *world;
	const cni_solve *s;
} substeps;

static void joints_warm_start(cn_world *world, const cni_solve *s)
{
	if (!has_joints(world))
		return;
	cni_joints_warm_start(world, s);
	if (has_direct(s))
		cni_direct_warm_start(world, s);
}

static void joints_solve(cn_world *world, const cni_solve *s)
{
	if (has_joints(world))
		cni_joints_solve(world, s);
	if (has_direct(s))
		cni_direct_solve(world, s, 1);
}

static void joints_relax(cn_world *world, const cni_solve *s)
{
	if (has_joints(world))
		cni_joints_relax(world, s);
	if (has_direct(s))
		cni_direct_solve(world, s, 0);
	if (has_joints(world))
		cni_joints_stress(world, s);
}

static void impulses_sum(cn_world *world, const cni_solve *s)
{
	if (!CNI_HAS_EVENTS || !world->sums_active)
		return;
	if (has_direct(s))
		cni_direct_sum_impulses(world, s->direct);
	cni_impulse_sums_close(world, s);
}

/* A step without motion moves nothing, and has contacts and events, too. */
static void finish_without_motion(cn_world *world)
{
	for (int32_t k = 1; k < world->awake_count; ++k)
		cni_body_at(world, cni_awake_ids(world)[k])->flags &= ~(uint32_t)CNI_BODY_MOVED;
	if (!CNI_HAS_EVENTS)
		return;
	cni_impulse_sums_make(world);
	cni_impulse_sums_report(world);
}

static void substeps_lead(void *context)
{
	cn_world *world = ((const substeps *)context)->world;
	const cni_solve *s = ((const substeps *)context)->s;
	for (int32_t k = 0; k < s->substeps; ++k) {
		cni_integrate_velocities(world, s, k);
		if (CNI_HAS_EVENTS)
			cni_impulse_sums_open(world, s);
		if (k == 0) {
			joints_warm_start(world, s);
			cni_contacts_pass(world, s, CNI_PASS_WARM);
		}
		if (CNI_HAS_RESTITUTION && CNI_ON(IMPACTS))
			cni_contacts_impact(world, s);
		joints_solve(world, s);
		cni_contacts_pass(world, s, CNI_PASS_SOLVE);
		if (has_direct(s))
			cni_direct_project(world, s);
		if (has_joints(world))
			cni_joints_limit_turns(world, s);
		cni_integrate_positions(world, s);
		joints_relax(world, s);
		cni_contacts_pass(world, s, CNI_PASS_RELAX);
		if (has_direct(s))
			cni_direct_settle(world, s);
		impulses_sum(world, s);
		if (k == 0 && CNI_ON(EARLY_REST))
			cni_rest_find(world, s);
	}
	cni_integrate_finish(world, s);
}

/* Workers stay inside one team run over all substeps, passes and colours. */
static void substeps_run(cn_world *world, cni_solve *s)
{
	substeps all = { world, s };
	if (world->awake_count == 1)
		return; /* only the dummy */
	s->team = s->lanes + world->awake_joints.count + world->awake_count >= SHARED_WORK ? world->team : has_direct(s) ? cni_components_team(world, s->direct, s->substeps) : NULL;
	cni_team_run(s->team, substeps_lead, &all);
}

static void step_end(cn_world *world, float dt, int32_t rested)
{
	world->events.in_step = 0;
	if (world->bodies_stopped > 0)
		world->warnings |= CN_WARNING_NOT_FINITE;
	++world->step_count;
	if (dt > 0.0f) {
		world->step_dt = dt;
		world->settled = rested != 0;
	}
	cni_arena_reset(&world->arena);
}

/* The soft step. Returns 1 when some body has rested long enough to sleep. */
static int32_t step_soft(cn_world *world, float dt, uint64_t *mark)
{
	cn_profile *profile = &world->profile;
	cni_solve s = cni_solve_make(world, dt, world->settings.substeps);
	cni_sparse direct;
	cni_stage_pairs(world, dt);
	if (CNI_ON(SEAMS))
		cni_stage_seams(world);
	profile_mark(world, &profile->broadphase_s, mark);
	cni_stage_narrowphase(world, dt);
	profile_mark(world, &profile->narrowphase_s, mark);
	if (dt == 0.0f) {
		finish_without_motion(world);
		return 0;
	}
	world->mean_dt = s.mean_dt;
	world->longest_dt = s.longest_dt;
	cni_external_prepare(world, &s);
	if (has_joints(world))
		cni_joints_prepare(world, &s);
	cni_contacts_list(world, &s);
	if (CNI_HAS_EVENTS && s.sums)
		cni_impulse_sums_make(world);
	if (CNI_HAS_DIRECT)
		cni_stage_select_solvers(world, s.h);
	if (CNI_HAS_DIRECT && (has_joints(world) || world->direct_islands.count > 0))
		cni_direct_prepare(world, &s, &direct);
	if (CNI_HAS_DIRECT && CNI_ON(GRAVITY_PRELOAD))
		cni_gravity_preload(world, &s);
	if (CNI_HAS_DIRECT && CNI_ON(OVERLAP_PROJECTION))
		cni_stage_project_overlaps(world, &s);
	if (has_direct(&s))
		cni_rattle_run(world, &s);
	if (has_joints(world))
		cni_joint_blocks_gather(world, &s);
	profile_mark(world, &profile->prepare_s, mark);
	substeps_run(world, &s);
	if (has_joints(world))
		cni_joints_store(world, &s);
	if (has_direct(&s))
		cni_direct_store(world, &s);
	if (CNI_ON(ANGULAR_MOMENTUM))
		cni_angular_momentum_restore(world);
	cni_external_finish(world);
	profile_mark(world, &profile->substeps_s, mark);
	if (CNI_HAS_CONTINUOUS && (world->settings.flags & CN_WORLD_CONTINUOUS))
		cni_stage_continuous(world);
	int32_t rested = cni_stage_finalize(world, &s);
	if (CNI_HAS_EVENTS)
		cni_impulse_sums_report(world);
	if (has_joints(world))
		cni_joints_break(world);
	profile_mark(world, &profile->finalize_s, mark);
	return rested;
}

/* The paper's twelve steps, numbered as in src/README.md; 12 is in cni_step. */
static int32_t step_sequential(cn_world *world, float dt, uint64_t *mark)
{
	cn_profile *profile = &world->profile;
	cni_solve s = cni_solve_make_sequential(world, dt);
	if (dt > 0.0f) {
		cni_sequential_velocities(world, &s);                  /* 1 */
		cni_sequential_positions(world, &s);                   /* 2 and 4 */
		if (has_joints(world))
			cni_sequential_joints(world, &s, 1);           /* 3 */
	}
	profile_mark(world, &profile->prepare_s, mark);
	cni_stage_pairs(world, dt);                                    /* 5 */
	if (CNI_ON(SEAMS))
		cni_stage_seams(world);
	profile_mark(world, &profile->broadphase_s, mark);
	cni_stage_narrowphase(world, 0.0f);                        /* 6 */
	profile_mark(world, &profile->narrowphase_s, mark);
	if (dt == 0.0f) {
		finish_without_motion(world);
		return 0;
	}
	cni_impulse_sums_make(world);
	cni_impulse_sums_open(world, &s);
	cni_sequential_velocity_response(world, &s);               /* 7 */
	cni_impulse_sums_close(world, &s);
	cni_sequential_position_response(world);                   /* 8 */
	cni_sequential_guard(world);
	if (has_joints(world))
		cni_sequential_joints(world, &s, 0);               /* 9 */
	cni_sequential_hold_locked(world);
	profile_mark(world, &profile->substeps_s, mark);
	int32_t rested = cni_stage_finalize(world, &s);                    /* 10 and 11 */
	cni_impulse_sums_report(world);
	if (has_joints(world))
		cni_joints_break(world);
	profile_mark(world, &profile->finalize_s, mark);
	return rested;
}

void cni_step(cn_world *world, float dt)
{
	cn_profile *profile = &world->profile;
	int32_t rested;
	uint64_t begin, mark;
	step_begin(world);
	cni_team_hold(world->team, team_is_held(world));
	begin = mark = (world->settings.flags & CN_WORLD_PROFILE) ? cni_clock_ns() : 0;
	rested = CNI_HAS_SEQUENTIAL && world->settings.solver == CN_SOLVER_SEQUENTIAL ? step_sequential(world, dt, &mark) : step_soft(world, dt, &mark);
	if (rested && (world->settings.flags & CN_WORLD_SLEEP))
		cni_stage_sleep(world, dt);
	profile_mark(world, &profile->sleep_s, &mark);
	cni_team_hold(world->team, 0);
	if (CNI_HAS_EVENTS)
		cni_stage_events(world); /* last, so that callbacks and later reads of the arrays see the same world */
	profile_mark(world, &profile->events_s, &mark);
	step_end(world, dt, rested);
	profile_mark(world, &profile->step_s, &begin);
}
