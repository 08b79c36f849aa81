/*
 * direct/component_fate.c - what becomes of each component of joints in a step: exact, by RATTLE or by the passes of the substeps, or soft.
 *
 * Exact joints that are torn, that contradict each other, that something squeezes, or that rounding leaves nothing of, throw bodies. Each of these
 * has a test here that knows it before the step. What shows in a substep alone ends in cni_component_give_up (direct/component.c).
 *
 * Long loops of pins and rods that touch something are left to the soft solver, unless one of their joints asks for CN_SOLVER_DIRECT.
 *
 * Reads joint constraints, contacts, motion and inverse masses; writes the components, rows of their joint constraints, and the systems of those that
 * were looked at for redundance.
 */
#include "direct/direct.h"
#include "contacts/deep_lanes.h"
#include "direct/direct_system.h"
#include "direct/heavy_contacts.h"

/* 1: a joint of the component's island asks for the direct solver. For components with several bodies. */
static int32_t is_requested(const cn_world *world, const cni_sparse *sparse, const cni_component *c)
{
	int32_t island = cni_awake_island(world, sparse->bodies[c->body_begin]);
	return island != CNI_NONE && cni_island_at(world, island)->joints_solver == CN_SOLVER_DIRECT;
}

/* Pins and rods alone, and welds where it is one row of parts between two fixed ends. */
static int32_t may_be_straight(const cn_world *world, const cni_sparse *sparse, const cni_component *c, int32_t fixed)
{
	int32_t is_row = cni_component_is_row(c, fixed);
	for (int32_t k = c->begin; k < c->end; ++k) {
		int32_t type = cni_joint_constraints(world)[sparse->nodes[k].owner].record->type;
		if (sparse->nodes[k].rows != 2 && type != CN_JOINT_DISTANCE && !(is_row && type == CN_JOINT_FIXED))
			return 0;
	}
	return 1;
}

/* How far the two points of a pin, the ends of a rod or a rope, or a point beside its slide are from where they belong. FLT_MAX: a joint with a
   flag of `torn`, whose rows know but a part of its gap. */
static float gap_of(const cni_joint_constraint *w, uint32_t torn)
{
	if (w->flags & torn)
		return FLT_MAX;
	switch (w->record->type) {
	case CN_JOINT_REVOLUTE: case CN_JOINT_FIXED: return cni_length(w->start.d);
	case CN_JOINT_DISTANCE:
		if (cni_joint_is_rope(w->record))
			return cni_max(cni_length(w->start.d) - w->record->p[CNI_P_UPPER], 0.0f);
		return w->rigid_count > 0 ? cni_abs(cni_length(w->start.d) - w->record->p[CNI_P_LENGTH]) : 0.0f;
	default: return w->rigid_count > 0 && !w->rows[0].angular ? cni_abs(w->rows[0].error) : 0.0f;
	}
}

/* The widest gap. A limit that is apart does not tear a loop, whose joints may contradict it: exact limits close at the speed of overlaps. Soft
   ones would press a bridge until it is thrown. */
static float gaps_find(const cn_world *world, const cni_solve *s, const cni_sparse *sparse, cni_component *c)
{
	float most = 0.0f, sum = 0.0f;
	uint32_t torn = c->loops ? CNI_CONSTRAINT_TORN : CNI_CONSTRAINT_APART;
	for (int32_t k = c->begin; k < c->end && !c->has_contacts; ++k) {
		float gap = gap_of(cni_joint_constraints(world) + sparse->nodes[k].owner, torn);
		most = cni_max(most, gap);
		sum += gap;
	}
	c->closes_fast = s->joint_error_rate * sum > s->push_speed;
	return most;
}

static int32_t is_open(const cn_world *world, const cni_solve *s, float gap)
{
	return gap > CNI_LOOP_OPEN * s->joint_h * s->joint_h * world->settings.length_unit;
}

/* 1: in the last step its joints were soft, as they had been given up. */
static int32_t was_soft(const cn_world *world, const cni_sparse *sparse, const cni_component *c)
{
	const cni_joint_trust *t = &cni_joint_constraints(world)[sparse->nodes[c->begin].owner].record->trust;
	return world->joints_soft_step >= world->step_count && t->span > 0 && t->soft && t->until == world->step_count;
}

/*
 * A long row of pins or rods between fixed bodies, such as a bridge between two walls, may be so straight that no force can hold it: rigid
 * joints explode there when contacts, springs, motors or the mouse load it, or when they are to close what soft ones have opened (RATTLE finds
 * that no motion does). Trees have no such configurations, nor have loops with gears. A loop of few bodies stays exact (CNI_LOOP_BODIES), and so
 * does a loop of moving bodies alone, such as a scissor lift, unless most of its bodies touch something, more than contacts can know its joints
 * (direct/heavy_contacts.c): the links of a caterpillar track would be pressed into wheels. Contacts come and go: a loop that closed its joints
 * whenever a body on it bounces would throw the body. So the loop stays soft for the longest span of a trust: of 80 seeds of the family
 * `bridge`, when all bridges were soft, 8 were worse than soft constraints with 32 steps, 3 with 128, 2 with 256.
 */
static int32_t loop_is_better_soft(const cn_world *world, const cni_sparse *sparse, const cni_component *c)
{
	int32_t fixed, bodies = c->body_end - c->body_begin;
	if (!CNI_ON(SOFT_LOOPS) || world->settings.solver != CN_SOLVER_AUTO || !c->loops || c->has_contacts || c->touched == 0 || bodies == 0 ||
	    is_requested(world, sparse, c))
		return 0;
	fixed = cni_component_held(world, sparse, c);
	if (!may_be_straight(world, sparse, c, fixed))
		return 0;
	if (fixed > 1)
		return !cni_component_is_braced(c, fixed);
	return 2 * c->touched > bodies && c->touched > cni_heavy_contacts_most(sparse, c);
}

/* A component with a joint that was torn open, by a body that was put elsewhere or by moving parts that pull it apart: exact joints turn
   its bodies so far while they close the gap that linear systems say nothing of it. It is soft until the gap is closed, for spans in which it is
   not planned: joints that are planned and released in each step are solved one by one, and stretch four times as far as those in lanes. */
static int32_t is_torn(const cni_solve *s, float gap)
{
	return gap > s->joint_gap_most;
}

/* A loop that has opened, as one that was soft, or put together so, or moved by force. To close it exact joints would straighten a row between fixed
   ends that no force can hold then, lift the load of a net whose ropes are too long, or throw what lies on a bridge. Where something loads it, or
   drives it, it stays soft for the longest span of a trust, as joints that are closed to the last millimetre still contradict each other. */
static int32_t is_open_loop(const cn_world *world, const cni_solve *s, const cni_sparse *sparse, const cni_component *c, float gap)
{
	return c->loops && !c->has_contacts && (c->uses_rattle || c->has_ropes || was_soft(world, sparse, c)) && is_open(world, s, gap);
}

/* Is the joint beyond a limit under thousands of weights? */
static int32_t is_forced(const cn_world *world, const cni_joint_constraint *w)
{
	int32_t i, beyond = 0;
	for (i = w->rigid_count; i < w->row_count; ++i)
		beyond |= w->rows[i].kind == CNI_ROW_LIMIT && w->rows[i].error * cni_row_length(world, &w->rows[i]) < -CNI_LIMIT_FORCED * world->settings.length_unit;
	return beyond && cni_direct_soft_part(world, cni_joint_impulse_sum(world, w->record, CNI_JOINT_ROWS), w->ia, w->ib) < 0.1f;
}

/* A component whose joints contradict each other: pins hold a part beyond its limit. Impulses of exact joints would grow in each step, and
   throw it when it is let go. */
static int32_t is_contradictory(const cn_world *world, const cni_sparse *sparse, const cni_component *c)
{
	for (int32_t k = c->begin; k < c->end && !c->has_contacts; ++k)
		if (is_forced(world, cni_joint_constraints(world) + sparse->nodes[k].owner))
			return 1;
	return 0;
}

/* Sums of the normal impulses of those of the body's contacts that overlap bodies that cannot move by more than joints may be beyond a limit. */
static void body_press_find(const cn_world *world, int32_t index, cni_vec2 *sum, float *all)
{
	const cni_body *b = cni_body_at(world, cni_awake_ids(world)[index]);
	for (int32_t key = b->contact_first; key != CNI_NONE; key = cni_contact_of_key(world, key)->next[key & 1]) {
		const cni_contact *contact = cni_contact_of_key(world, key);
		if (!cni_contact_has_lane(contact))
			continue;
		const cni_contact_block *block = cni_block_at(world, contact->slot / CNI_LANES);
		int32_t l = contact->slot % CNI_LANES, is_a = block->ia[l] == index;
		if (cni_motion_can_move(cni_motions(world) + (is_a ? block->ib[l] : block->ia[l])) || cni_lane_overlap(block, l) <= CNI_LIMIT_FORCED * world->settings.length_unit)
			continue;
		float impulse = block->p[0].jn[l] + block->p[1].jn[l];
		*all += impulse;
		*sum = cni_madd(*sum, is_a ? -impulse : impulse, cni_v(block->nx[l], block->ny[l]));
	}
}

/* A component that bodies that cannot move squeeze between them, harder than hundreds of its weights: a press that comes down on it, and the ground.
   Exact joints do not give way, and the press would enter it so deep that contacts hold it there, or drive it into the ground. */
static int32_t is_squeezed(const cn_world *world, const cni_sparse *sparse, const cni_component *c)
{
	cni_vec2 sum = cni_v(0.0f, 0.0f);
	float all = 0.0f;
	for (int32_t k = c->body_begin; k < c->body_end && c->touched > 0 && !c->has_contacts; ++k)
		if (cni_externals(world)[sparse->bodies[k]].flags & CNI_EXTERNAL_TOUCHED)
			body_press_find(world, sparse->bodies[k], &sum, &all);
	return all > 0.0f && all - cni_length(sum) > cni_soft_speed_most(world) * cni_component_mass(world, sparse, c);
}

/* Do some of its rows say nearly the same as others? Begins it for the substeps, and takes that back where they do not. */
static int32_t is_redundant(cn_world *world, const cni_solve *s, cni_sparse *sparse, cni_component *c, float part)
{
	int32_t width = c->width;
	cni_direct_begin(world, s, sparse, c);
	if (cni_sparse_is_redundant(sparse, c, part))
		return 1;
	c->active = 0; /* RATTLE and batches have no active set */
	c->width = width;
	return 0;
}

/* Speed across a rod or rope that its impulse of a substep gives the lighter of its bodies when it has turned by its motion of a substep, as levers
   stay until then. 0: less than the speed that turns it, as where it circles. */
static float speed_across(const cn_world *world, const cni_solve *s, const cni_joint_constraint *w)
{
	const cni_motion *a = cni_motions(world) + w->ia, *b = cni_motions(world) + w->ib;
	float length, part = s->h * s->warm_scale * cni_abs(w->rows[0].impulse) * cni_max(a->inv_mass, b->inv_mass);
	cni_vec2 axis = cni_distance_axis(w->start.d, &length);
	return part > length ? part * cni_abs(cni_cross(axis, cni_joint_velocity_apart(world, w))) / cni_max(length, FLT_MIN) : 0.0f;
}

/*
 * A loop that its own tension throws. A net that obstacles or moving ends stretch until rows of it are straight bears any tension, which turns with
 * its rods: where a substep so adds more across them than there is, each adds more. Trusses bear as much, but do not turn. RATTLE takes shorter
 * substeps.
 */
static int32_t is_overstretched(cn_world *world, const cni_solve *s, const cni_sparse *sparse, const cni_component *c)
{
	float most = CNI_WARM_PUSH_PART * world->settings.push_speed_max;
	if (!c->loops || c->has_contacts || c->uses_rattle)
		return 0;
	cni_component_rows_need(world, s, sparse, c);
	for (int32_t k = c->begin; k < c->end; ++k) {
		const cni_joint_constraint *w = cni_joint_constraints(world) + sparse->nodes[k].owner;
		if (w->record->type == CN_JOINT_DISTANCE && !cni_joint_is_cylinder(w->record) && speed_across(world, s, w) > most)
			return 1;
	}
	return 0;
}

/* 1: the body cannot move, and is not static, which is 0. */
static int32_t is_kinematic(const cn_world *world, int32_t index)
{
	return index > 0 && !cni_motion_can_move(cni_motions(world) + index);
}

static void bodies_look(const cn_world *world, const cni_sparse *sparse, cni_component *c)
{
	float least = FLT_MAX, most = 0.0f;
	c->touched = c->meets_kinematic = c->pending = 0;
	for (int32_t k = c->begin; k < c->end; ++k)
		c->meets_kinematic |= is_kinematic(world, sparse->nodes[k].ia) || is_kinematic(world, sparse->nodes[k].ib);
	for (int32_t k = c->body_begin; k < c->body_end; ++k) {
		float inv_mass = cni_motions(world)[sparse->bodies[k]].inv_mass;
		most = cni_max(most, inv_mass);
		least = inv_mass > 0.0f ? cni_min(least, inv_mass) : least;
		c->touched += (cni_externals(world)[sparse->bodies[k]].flags & CNI_EXTERNAL_TOUCHED) != 0;
	}
	c->heaviest = 1.0f / least;
	c->mass_ratio = most / least;
}

/* A light body between far heavier ones, or on long arms: beside the rows that move it, what the others bear through it is lost in rounding, as
   a pin whose pivot cancels, or as a kick. Soft joints then open, and stay soft until they are closed. */
static int32_t is_ill_scaled(cn_world *world, const cni_solve *s, cni_sparse *sparse, cni_component *c, float gap)
{
	int32_t opened = !c->has_contacts && was_soft(world, sparse, c) && is_open(world, s, gap);
	if (c->has_contacts || (!opened && c->mass_ratio < CNI_ILL_MASS_RATIO))
		return 0;
	return is_redundant(world, s, sparse, c, opened ? CNI_CHECKED_PIVOT : CNI_ILL_PIVOT);
}

/* RATTLE, or the passes of a substep where joints to fixed bodies say nearly the same, as those of coupled wheels on fixed axles, or of a
   straight bridge, whose planks no joint keeps from moving across it by a hair: RATTLE divides by what is left of them. A loop that flies
   freely turns at rest in itself, and stays with RATTLE. */
static void rattle_begin(cn_world *world, const cni_solve *s, cni_sparse *sparse, cni_component *c)
{
	int32_t held = c->loops ? cni_component_held(world, sparse, c) : 0;
	float bodies = cni_component_is_braced(c, held) ? (float)(c->body_end - c->body_begin) : 0.0f;
	if (held > 0 && is_redundant(world, s, sparse, c, CNI_RATTLE_REDUNDANT * cni_max(CNI_RATTLE_BRACED * bodies, 1.0f)))
		c->pending = 1; /* begins anew, with centred rows */
	else
		cni_sparse_clear(sparse, c);
	c->uses_rattle = !c->pending;
}

static int32_t fate_of(cn_world *world, const cni_solve *s, cni_sparse *sparse, cni_component *c)
{
	float gap = gaps_find(world, s, sparse, c);
	c->uses_rattle = c->uses_rattle && (c->loops || !c->closes_fast); /* it closes gaps at once */
	if (is_torn(s, gap))
		return CNI_FATE_SOFT;
	if (is_contradictory(world, sparse, c) || is_squeezed(world, sparse, c))
		return CNI_FATE_WITHOUT_IMPULSES;
	if (loop_is_better_soft(world, sparse, c))
		return CNI_FATE_SOFT_LONG;
	if (is_open_loop(world, s, sparse, c, gap))
		return c->uses_rattle ? CNI_FATE_SOFT : CNI_FATE_SOFT_LONG;
	if (cni_component_is_pulled(world, s, sparse, c) || is_ill_scaled(world, s, sparse, c, gap) || is_overstretched(world, s, sparse, c))
		return CNI_FATE_SOFT;
	return c->body_begin == c->body_end ? CNI_FATE_RELEASED : c->uses_rattle ? CNI_FATE_RATTLE : CNI_FATE_PASSES;
}

/* ---- the judgement ---- */

typedef struct judge_loop {
	cn_world *world;
	const cni_solve *s;
} judge_loop;

/* Writes what belongs to the component alone. */
static void component_judge(cn_world *world, const cni_solve *s, cni_sparse *sparse, cni_component *c)
{
	c->regular = c->has_contacts ? CNI_REGULARIZATION_CONTACTS : c->loops ? CNI_REGULARIZATION_LOOPS : 0.0f;
	c->uses_rattle = CNI_ON(RATTLE) && !c->has_contacts && cni_component_uses_rattle(world, s, sparse, c);
	c->fate = fate_of(world, s, sparse, c);
	if (c->fate == CNI_FATE_RATTLE)
		rattle_begin(world, s, sparse, c);
	c->batches = CNI_NOT_BATCHED;
	if (CNI_ON(TREE_BATCHES) && c->fate == CNI_FATE_PASSES && !cni_component_is_single(c)) /* a single joint is released, or has heavy contacts */
		c->batches = cni_component_is_batched(world, s, sparse, c, 0);
}

/* Those at kinematic bodies, whose rotations they share, are left to one worker. */
static void judge_range(void *context, int32_t begin, int32_t end)
{
	const judge_loop *l = (const judge_loop *)context;
	for (int32_t k = begin; k < end; ++k) {
		cni_component *c = &l->s->direct->components[k];
		if (c->done)
			continue;
		bodies_look(l->world, l->s->direct, c);
		if (!c->meets_kinematic)
			component_judge(l->world, l->s, l->s->direct, c);
	}
}

void cni_components_judge(cn_world *world, const cni_solve *s, cni_team *team)
{
	judge_loop l = { world, s };
	cni_team_for(team, s->direct->component_count, 8, judge_range, &l);
	for (cni_component *c = s->direct->components; c < s->direct->components + s->direct->component_count; ++c)
		if (!c->done && c->meets_kinematic)
			component_judge(world, s, s->direct, c);
}
