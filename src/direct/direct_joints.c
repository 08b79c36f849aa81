/*
 * direct/direct_joints.c - rigid rows of connected joints solved together, exactly (linear/sparse.h): the components that
 * direct/direct_plan.c found, from their levers to impulses.
 *
 * What is not in them, and springs, motors and limits, are solved row by row in joints/joint_solve.c,
 * before; contacts come after, so joints and contacts alternate, where they disagree more than once: direct/joint_projection.c.
 *
 * Loops of pins and rods that touch something are the soft solver's, unless one of their joints asks for CN_SOLVER_DIRECT.
 *
 * Reads works, motion and inverse masses; writes works' flags and their rigid rows' impulses, motion velocities.
 */
#include "direct/direct_contact.h"
#include "joints/joint_work.h"

#include <string.h>

/* Loops, the two points of a contact, and piles with several ways to bear the same say much twice: their diagonal grows by
   this part. */
#define REGULAR 1e-4f
#define REGULAR_LOOPS 5e-5f /* ... of joints alone, whose solutions are checked */
#define REGULAR_STEP 10.0f /* times: a system that is still as good as singular */
#define REGULAR_MOST 0.05f /* ... until joints are about as soft as soft ones */
#define LEAK 1e-5f         /* ... and their rows give way by this part of it to their whole impulses */

/* ---- components ---- */

void cni_direct_motions_keep(const cn_world *world, const cni_sparse *sparse, const cni_component *c, int32_t back)
{
	int32_t k;
	for (k = c->body_begin; k < c->body_end; ++k) {
		cni_motion *m = cni_motions(world) + sparse->bodies[k], *saved = sparse->saved + k;
		*(back ? m : saved) = *(back ? saved : m);
	}
}

void cni_direct_turns(const cn_world *world, cni_sparse *sparse, const cni_component *c)
{
	int32_t k;
	sparse->turn[0] = cni_rot_small(0.0f);
	for (k = c->begin; k < c->end; ++k) { /* kinematic ones too, which are no bodies of the component */
		const cni_node *n = &sparse->nodes[k];
		if (cni_motions(world)[n->ia].inv_mass == 0.0f)
			sparse->turn[n->ia] = cni_rot_small(cni_motions(world)[n->ia].theta);
		if (cni_motions(world)[n->ib].inv_mass == 0.0f)
			sparse->turn[n->ib] = cni_rot_small(cni_motions(world)[n->ib].theta);
	}
	for (k = c->body_begin; k < c->body_end; ++k)
		sparse->turn[sparse->bodies[k]] = cni_rot_small(cni_motions(world)[sparse->bodies[k]].theta);
}

/* Nothing is solved directly after all. */
static void works_release(cn_world *world)
{
	int32_t k;
	for (k = 0; k < world->awake_joints.count; ++k)
		cni_joint_works(world)[k].flags &= ~(uint32_t)CNI_WORK_DIRECT;
}

/* Each joint by itself after all, in this step. */
static void joints_release(cn_world *world, cni_sparse *sparse, cni_component *c)
{
	int32_t k;
	++sparse->released;
	for (k = c->begin; k < c->end; ++k)
		if (sparse->nodes[k].owner >= 0) {
			cni_joint_works(world)[sparse->nodes[k].owner].flags &= ~(uint32_t)CNI_WORK_DIRECT;
			cni_joint_works(world)[sparse->nodes[k].owner].inner = 0;
		}
	c->swings = 0;
	c->done = 1;
}

/* ... and for some time: `span` steps, or, 0, longer each time it happens. */
static void joints_leave(cn_world *world, cni_sparse *sparse, cni_component *c, int32_t span)
{
	int32_t k;
	for (k = c->begin; k < c->end; ++k) {
		cni_joint_trust *t;
		if (sparse->nodes[k].owner < 0)
			continue;
		t = &cni_joint_at(world, cni_joint_works(world)[sparse->nodes[k].owner].joint)->trust;
		if (span == 0)
			cni_trust_fail(t, world->step_count, 1);
		else
			cni_trust_leave(t, world->step_count, span, 1);
		world->joints_soft_step = t->until > world->joints_soft_step ? t->until : world->joints_soft_step;
	}
	joints_release(world, sparse, c);
}

/* Joints' levers from their rows. Returns how many joints there are. */
static int32_t levers_read(const cn_world *world, cni_sparse *sparse, const cni_component *c)
{
	int32_t k, i, joints = 0;
	for (k = c->begin; k < c->end; ++k) {
		cni_node *n = &sparse->nodes[k];
		const cni_row *rows;
		if (n->owner < 0)
			continue;
		++joints;
		rows = cni_joint_works(world)[n->owner].rows;
		for (i = 0; i < n->rows; ++i)
			n->lever[i] = cni_row_lever(&rows[i]);
	}
	return joints;
}

void cni_direct_refresh(cn_world *world, cni_sparse *sparse, const cni_component *c)
{
	(void)levers_read(world, sparse, c);
	cni_sparse_factor(sparse, c, cni_motions(world));
}

void cni_direct_begin(cn_world *world, const cni_solve *s, cni_sparse *sparse, cni_component *c)
{
	cni_joint_works_complete(world, sparse, c);
	cni_sparse_clear(sparse, c);
	cni_direct_turns(world, sparse, c);
	cni_tension_find(world, sparse, c, s->h);
	c->active = c->presses || c->kind != CNI_NONE || !CNI_ON(ACTIVE) ? 0 : cni_active_begin(world, s, sparse, c);
	if (c->active || cni_tension_needs_dampers(world, sparse, c, s->h))
		c->width = CNI_NODE_ROWS;
	cni_direct_system(world, s, sparse, c);
}

void cni_direct_system(cn_world *world, const cni_solve *s, cni_sparse *sparse, cni_component *c)
{
	if (c->active)
		cni_active_clear(world, sparse, c);
	cni_tension_damp(world, sparse, c, s->h);
	c->joints = levers_read(world, sparse, c);
	if (c->active)
		cni_active_levers(world, sparse, c);
	if (c->presses)
		c->factored = 0;
	else
		cni_sparse_factor(sparse, c, cni_motions(world));
}

/* ---- the step ---- */

static int32_t component_has_presses(const cni_sparse *sparse, const cni_component *c)
{
	int32_t k;
	for (k = c->begin; k < c->end; ++k)
		if (sparse->nodes[k].owner < 0)
			return 1;
	return 0;
}

/* In a step, in the units of work_budget. */
static int32_t work_planned(const cn_world *world, const cni_sparse *sparse)
{
	int64_t work = 0;
	int32_t k;
	for (k = 0; k < sparse->component_count; ++k) {
		const cni_component *c = &sparse->components[k];
		if (!c->done)
			work += (int64_t)c->work * world->settings.substeps;
	}
	return work < INT32_MAX ? (int32_t)work : INT32_MAX;
}

/* Does some joint of it ask to be solved directly? Of components with several bodies. */
static int32_t is_asked_for(const cn_world *world, const cni_sparse *sparse, const cni_component *c)
{
	int32_t island = cni_awake_island(world, sparse->bodies[c->body_begin]);
	return island != CNI_NONE && cni_island_at(world, island)->joints_solver == CN_SOLVER_DIRECT;
}

/*
 * A loop of pins or rods, such as a bridge between two walls, may be so straight that no force can hold it: what is rigid
 * explodes there when contacts load it. Trees have no such places, nor have loops by gears. Contacts come and go: a loop that
 * closed its joints whenever what lies on it bounces would throw it. So it stays soft as long as joints remember anything: of
 * 80 seeds of the family `bridge` 8 are worse than soft constraints with 32 steps, 3 with 128, 2 with 256.
 */
static int32_t is_loop_of_pins_and_rods(const cn_world *world, const cni_sparse *sparse, const cni_component *c)
{
	int32_t k;
	if (world->settings.solver != CN_SOLVER_AUTO || !c->loops || c->presses || c->body_begin == c->body_end)
		return 0;
	for (k = c->begin; k < c->end; ++k)
		if (sparse->nodes[k].rows != 2 && cni_joint_works(world)[sparse->nodes[k].owner].record->type != CN_JOINT_DISTANCE)
			return 0;
	return 1;
}

static int32_t is_touched(const cn_world *world, const cni_sparse *sparse, const cni_component *c)
{
	int32_t k;
	for (k = c->body_begin; k < c->body_end; ++k)
		if (cni_drives(world)[sparse->bodies[k]].flags & CNI_DRIVE_TOUCHED)
			return 1;
	return 0;
}

static int32_t loop_is_better_soft(const cn_world *world, const cni_sparse *sparse, const cni_component *c)
{
	return CNI_ON(SOFT_LOOPS) && is_loop_of_pins_and_rods(world, sparse, c) && !is_asked_for(world, sparse, c) && is_touched(world, sparse, c);
}

/* One joint to the world. */
static int32_t is_better_alone(const cni_component *c)
{
	return !c->swings && !c->presses && c->end - c->begin == 1 && c->body_end - c->body_begin == 1;
}

void cni_direct_prepare(cn_world *world, cni_solve *s, cni_sparse *out)
{
	int32_t k, far = cni_joints_are_far(world);
	memset(out, 0, sizeof *out);
	if ((world->awake_joints.count == 0 && world->direct_islands.count == 0) || world->settings.solver == CN_SOLVER_SOFT || cni_joint_lanes_tell(world))
		return;
	if (!cni_direct_plan(world, s, out)) {
		works_release(world);
		world->direct_failed = 1;
		world->warnings |= CN_WARNING_FRAME_MEMORY;
		return;
	}
	if (out->component_count == 0)
		return;
	s->direct = out;
	for (k = 0; k < out->component_count; ++k) {
		out->components[k].presses = component_has_presses(out, &out->components[k]);
		out->components[k].coned = 0;
	}
	for (k = 0; k < out->component_count; ++k) {
		cni_component *c = &out->components[k];
		if (far && k + 1 < out->component_count)
			cni_component_prefetch(world, out, k + 1);
		c->regular = c->presses ? REGULAR : c->loops ? REGULAR_LOOPS : 0.0f;
		c->swings = CNI_ON(SWINGS) && !c->presses && cni_component_swings(world, s, out, c);
		if (loop_is_better_soft(world, out, c))
			joints_leave(world, out, c, CNI_TRUST_MOST);
		else if (c->body_begin == c->body_end || is_better_alone(c))
			joints_release(world, out, c);
		else if (c->swings)
			cni_sparse_clear(out, c);
		else if (!(c->herds = CNI_ON(HERDS) ? cni_component_herds(world, s, out, c) : 0)) {
			c->kind = CNI_NONE;
			cni_direct_begin(world, s, out, c);
		}
	}
	cni_herds_make(world, s, out);
	cni_presses_take(world, out);
	if (CNI_ON(CLOSE))
		cni_close_mark(world, out);
	world->direct_work = work_planned(world, out);
}

/* ---- impulses ---- */

/* Both bodies are read once and written once: a node's two bodies are never the same. */
CNI_INLINE void nodes_push(cn_world *world, const cni_sparse *sparse, const cni_component *c, int32_t width)
{
	cni_motion *motions = cni_motions(world);
	cni_joint_work *works = cni_joint_works(world);
	int32_t k, i;
	for (k = c->begin; k < c->end; ++k) {
		const cni_node *n = &sparse->nodes[k];
		cni_motion a = motions[n->ia], b = motions[n->ib];
		if (n->owner < 0)
			continue;
		for (i = 0; i < n->rows; ++i)
			works[n->owner].rows[i].impulse += n->x[i];
		for (i = 0; i < width; ++i)
			cni_lever_push(&n->lever[i], n->x[i], &a, &b);
		motions[n->ia] = a;
		motions[n->ib] = b;
	}
}

void cni_direct_push(cn_world *world, const cni_sparse *sparse, const cni_component *c)
{
	if (c->width == 2)
		nodes_push(world, sparse, c, 2);
	else
		nodes_push(world, sparse, c, CNI_NODE_ROWS);
}

CNI_INLINE void speeds_read(const cn_world *world, cni_sparse *sparse, const cni_component *c, float rate, float push, int32_t width)
{
	const cni_motion *motions = cni_motions(world);
	const cni_joint_work *works = cni_joint_works(world);
	int32_t k, i;
	for (k = c->begin; k < c->end; ++k) {
		cni_node *n = &sparse->nodes[k];
		const cni_motion *a = motions + n->ia, *b = motions + n->ib;
		if (n->owner < 0)
			continue;
		for (i = 0; i < width; ++i)
			n->x[i] = -cni_lever_speed(&n->lever[i], a, b) - (i < n->rows ? cni_clamp(rate * works[n->owner].rows[i].error, -push, push) : 0.0f);
	}
}

static void right_sides(const cn_world *world, cni_sparse *sparse, const cni_component *c, float rate, float push)
{
	if (c->width == 2)
		speeds_read(world, sparse, c, rate, push, 2);
	else
		speeds_read(world, sparse, c, rate, push, CNI_NODE_ROWS);
}

/* No consistent set of contacts: they are the soft solver's until the step ends, the joints go on alone. */
static void component_release(cn_world *world, cni_sparse *sparse, cni_component *c)
{
	int32_t k, i;
	cni_presses_give_back(world, sparse, c);
	for (k = c->begin; k < c->end; ++k)
		for (i = 0; sparse->nodes[k].owner < 0 && i < CNI_NODE_ROWS; ++i) {
			memset(&sparse->nodes[k].lever[i], 0, sizeof sparse->nodes[k].lever[i]);
			sparse->nodes[k].x[i] = 0.0f;
		}
	c->presses = 0;
	c->regular = c->loops ? REGULAR_LOOPS : 0.0f;
	cni_sparse_factor(sparse, c, cni_motions(world));
	if (world->settings.solver == CN_SOLVER_AUTO)
		cni_island_refuse(world, cni_awake_island(world, sparse->bodies[c->body_begin]), CN_TIER_REASON_NO_SET);
}

/*
 * Loops give way a little to what they bear. The tension of a bridge between two walls says nothing of its bodies where it
 * is straight: nothing but this keeps it from growing, until whatever turns a joint a little throws all that is near.
 */
static void leaks_add(const cn_world *world, cni_sparse *sparse, const cni_component *c)
{
	const cni_motion *motions = cni_motions(world);
	const cni_joint_work *works = cni_joint_works(world);
	int32_t k, i;
	for (k = c->begin; k < c->end; ++k) {
		cni_node *n = &sparse->nodes[k];
		for (i = 0; i < n->rows && n->owner >= 0; ++i)
			n->x[i] -= LEAK * cni_lever_inverse_mass(&n->lever[i], motions + n->ia, motions + n->ib) * works[n->owner].rows[i].impulse;
	}
}

/* ---- solutions that are checked ---- */

static void impulses_take_back(cn_world *world, const cni_sparse *sparse, const cni_component *c)
{
	int32_t k, i;
	for (k = c->begin; k < c->end; ++k)
		for (i = 0; i < sparse->nodes[k].rows && sparse->nodes[k].owner >= 0; ++i)
			cni_joint_works(world)[sparse->nodes[k].owner].rows[i].impulse -= sparse->nodes[k].x[i];
}

static void sides_keep(cni_sparse *sparse, const cni_component *c, int32_t back)
{
	int32_t k;
	for (k = c->begin; k < c->end; ++k) {
		cni_node *n = &sparse->nodes[k];
		memcpy(back ? n->x : n->carried, back ? n->carried : n->x, sizeof n->x);
	}
}

static float inverse_or_zero(float x)
{
	return x > 0.0f ? 1.0f / x : 0.0f;
}

/*
 * With A = K + C, b the right sides and A x = b, the change of velocity M^-1 J^T x has twice the kinetic energy x K x <= x A x =
 * x b: no solution gives more than its right sides ask for. One that does comes of pivots that were rounding. Nor, but for
 * motors, can joints give more than what stops all motion and has every body close gaps at the greatest speed: one that does
 * closes gaps that say different things.
 */
static int32_t is_bounded(const cn_world *world, const cni_sparse *sparse, const cni_component *c)
{
	float asked = 0.0f, given = 0.0f, all = 0.0f, push = 0.0f;
	int32_t k, i;
	for (k = c->begin; k < c->end; ++k)
		for (i = 0; i < c->width; ++i)
			asked += sparse->nodes[k].carried[i] * sparse->nodes[k].x[i];
	for (k = c->body_begin; k < c->body_end; ++k) {
		const cni_motion *m = cni_motions(world) + sparse->bodies[k], *old = sparse->saved + k;
		float mass = inverse_or_zero(m->inv_mass), inertia = inverse_or_zero(m->inv_inertia);
		float vx = m->vx - old->vx, vy = m->vy - old->vy, w = m->w - old->w;
		given += mass * (vx * vx + vy * vy) + inertia * w * w;
		all += mass * (old->vx * old->vx + old->vy * old->vy) + inertia * old->w * old->w;
		push += mass * world->settings.push_speed_max * world->settings.push_speed_max;
	}
	if (c->active < 2 && !(given <= 2.0f * (all + push))) /* (a + b)^2 <= 2 (a^2 + b^2) */
		return 0;
	return given <= 1.1f * asked + 1e-6f * all; /* and what is not a number is not */
}

/* Loops say much twice, so that their systems may be as good as singular. One whose solution is beyond its bound is solved again
   with a larger diagonal, which it keeps for this step. */
int32_t cni_direct_apply(cn_world *world, cni_sparse *sparse, cni_component *c)
{
	if (!c->loops) {
		if (!cni_sparse_solve(sparse, c))
			return 0;
		cni_direct_push(world, sparse, c);
		return 1;
	}
	sides_keep(sparse, c, 0);
	for (;;) {
		cni_direct_motions_keep(world, sparse, c, 0);
		if (cni_sparse_solve(sparse, c)) {
			cni_direct_push(world, sparse, c);
			if (is_bounded(world, sparse, c))
				return 1;
			cni_direct_motions_keep(world, sparse, c, 1);
			impulses_take_back(world, sparse, c);
		}
		if (c->regular > REGULAR_MOST)
			return 0;
		c->regular *= REGULAR_STEP;
		cni_sparse_factor(sparse, c, cni_motions(world));
		sides_keep(sparse, c, 1);
	}
}

void cni_direct_sides(cn_world *world, const cni_solve *s, const cni_component *c, int32_t bias)
{
	right_sides(world, s->direct, c, bias ? CNI_JOINT_ERROR_RATE * s->inv_h : 0.0f, s->push_speed);
	if (bias && c->loops && !c->presses)
		leaks_add(world, s->direct, c);
	if (c->active)
		cni_active_sides(world, s, s->direct, c, bias);
}

void cni_direct_answer(cn_world *world, const cni_solve *s, cni_component *c)
{
	if (!(c->active ? cni_active_answer(world, s, s->direct, c) : cni_direct_apply(world, s->direct, c)))
		joints_leave(world, s->direct, c, 0);
}

static void joints_solve(cn_world *world, const cni_solve *s, cni_component *c, int32_t bias)
{
	cni_direct_sides(world, s, c, bias);
	cni_direct_answer(world, s, c);
}

/* The same levers at the new positions. */
static void component_turn(cn_world *world, const cni_solve *s, cni_component *c)
{
	cni_direct_turns(world, s->direct, c);
	cni_direct_system(world, s, s->direct, c);
}

/* ---- a substep ---- */

void cni_direct_solve(cn_world *world, const cni_solve *s, int32_t bias)
{
	int32_t k;
	for (k = 0; s->direct != NULL && k < s->direct->component_count; ++k) {
		cni_component *c = &s->direct->components[k];
		if (c->done || c->herds)
			continue;
		if (!bias && c->joints > 0)
			component_turn(world, s, c);
		if (c->presses && !cni_presses_solve(world, s, s->direct, c, bias))
			component_release(world, s->direct, c);
		if (!c->presses)
			joints_solve(world, s, c, bias);
		if (bias && !c->presses && !c->done && !c->active && c->kind == CNI_NONE && cni_tension_lock(world, s->direct, c, s->h)) {
			cni_sparse_factor(s->direct, c, cni_motions(world));
			joints_solve(world, s, c, bias);
		}
	}
}

void cni_direct_store(cn_world *world, const cni_solve *s)
{
	if (s->direct != NULL)
		cni_presses_give_back_all(world, s->direct, s->h);
}
