/*
 * direct/active_rows.c - motors and limits in the linear system of their joints (direct/direct_joints.c): which rows, their active set.
 *
 * A motor solved after the rigid rows of a linkage sees only the two bodies at its joint, and not the mass behind them; the relative
 * rotation of two stiff groups then grows from pass to pass. So the motor or limit is the third row of its joint's node. A motor row has a
 * target speed; a limit row bounds the speed by the remaining gap.
 *
 * The bounds of these rows make a complementarity problem, which an active set solves. All rows of the set are solved exactly. A row beyond
 * its bound is clamped to it and leaves the set. A row outside the set returns if its speed error has the sign to which it can push. Then
 * the system is solved again. After CNI_JOINT_SET_ROUNDS changes the last set is accepted. The set is kept from pass to pass, so most
 * passes take one round.
 *
 * A joint has one such row: its limit when the limit is near, otherwise its motor. Where both act along one coordinate they take turns: the motor,
 * whose target does not pass the limit, and the limit while the motor is at its bound and does not hold it. The other row keeps its impulse
 * meanwhile. A wheel's motor and limit act along two coordinates; there the motor is solved by joints/joint_solve.c, like springs. A rope, which
 * is a distance joint with limits alone, and a cylinder, a distance joint with a motor, have this row and no other. A rope is planned while it may
 * become taut.
 *
 * Reads joint constraints, motion; writes their rows and `active_row`, nodes' third rows, motion velocities.
 */
#include "direct/direct_system.h"

#define MOTOR_YIELD 1e-4f      /* of its speed, at its greatest impulse in a substep */
#define LIMIT_BEARS_LEAST 0.5f /* of what contacts press on a limit: one that bears less lets go */

/* Target speed of the row; for a limit, the least speed. Limits push no faster than overlaps: joints of figures under a slab would stretch
   by a sixth more. */
static float target_speed(const cn_world *world, const cni_row *r, const cni_solve *s, int32_t bias)
{
	if (r->kind == CNI_ROW_MOTOR)
		return cni_motor_target(r, s->inv_h, bias ? s->joint_error_rate : 0.0f);
	if (r->error > 0.0f)
		return -r->error * s->inv_h;
	return bias ? cni_min(-s->joint_error_rate * r->error, cni_row_push_speed(world, r)) : 0.0f;
}

/* The motor or limit row that is the third row of a node in the component's list. */
static cni_row *active_row(const cn_world *world, const cni_node *n)
{
	const cni_joint_constraint *w = cni_joint_constraints(world) + n->owner;
	return &w->rows[w->active_row];
}

static float impulse_most(const cni_row *r, const cni_solve *s)
{
	return r->kind == CNI_ROW_MOTOR ? r->limit * s->h : FLT_MAX;
}

static float missing_speed(const cn_world *world, const cni_node *n, const cni_row *r)
{
	return n->target - cni_lever_speed(&r->lever, cni_motions(world) + n->ia, cni_motions(world) + n->ib);
}

/* ---- which rows ---- */

/* Chooses the rows of the joint constraint: a limit that is near, or a motor; where they act along one coordinate the motor, with the limit beside
   it, unless the limit bore something. */
static void rows_choose(const cn_world *world, cni_joint_constraint *w, float dt)
{
	int32_t k, motor = CNI_NONE, limit = CNI_NONE, paired;
	for (k = w->rigid_count; k < w->row_count; ++k) {
		if (w->rows[k].kind == CNI_ROW_MOTOR && w->rows[k].limit > 0.0f)
			motor = k;
		if (w->rows[k].kind == CNI_ROW_LIMIT && cni_limit_is_near(world, w, k, dt))
			limit = k;
	}
	paired = motor != CNI_NONE && limit != CNI_NONE && w->rows[motor].angular == w->rows[limit].angular;
	w->active_row = limit == CNI_NONE || (paired && w->rows[limit].impulse <= 0.0f) ? motor : limit;
	w->idle_row = !paired ? CNI_NONE : w->active_row == motor ? limit : motor;
}

/* State of a row with this impulse. */
static uint32_t state_of(const cni_row *r, const cni_solve *s, float impulse)
{
	float most = impulse_most(r, s);
	if (r->kind == CNI_ROW_LIMIT)
		return impulse > 0.0f ? CNI_ROW_IN_SET : 0;
	if (cni_abs(impulse) < 0.999f * most)
		return CNI_ROW_IN_SET;
	return impulse > 0.0f ? CNI_ROW_AT_UPPER : 0;
}

int32_t cni_active_begin(cn_world *world, const cni_solve *s, cni_sparse *sparse, cni_component *c)
{
	int32_t k, found = 0, *last = &c->active_first;
	for (k = c->begin; k < c->end; ++k) {
		cni_node *n = &sparse->nodes[k];
		cni_joint_constraint *w = n->owner >= 0 ? &cni_joint_constraints(world)[n->owner] : NULL;
		if (w == NULL || n->rows == CNI_NODE_ROWS)
			continue;
		rows_choose(world, w, s->dt);
		if (w->active_row == CNI_NONE)
			continue;
		n->active = state_of(&w->rows[w->active_row], s, s->warm_scale * w->rows[w->active_row].impulse); /* of the last step */
		found = cni_max_i(found, w->idle_row != CNI_NONE || w->rows[w->active_row].kind == CNI_ROW_MOTOR ? 2 : 1);
		*last = k;
		last = &n->next_active;
	}
	*last = CNI_NONE;
	return found;
}

/* ---- the system ---- */

void cni_active_clear(cni_sparse *sparse, const cni_component *c)
{
	for (int32_t k = c->active_first; k != CNI_NONE; k = sparse->nodes[k].next_active)
		cni_levers_clear(&sparse->nodes[k].levers, 2);
}

static int32_t acts(const cn_world *world, const cni_node *n, int32_t kind)
{
	return (n->active & CNI_ROW_IN_SET) && active_row(world, n)->kind == kind;
}

int32_t cni_active_limits_ask(const cn_world *world, cni_sparse *sparse, const cni_component *c, float impulse)
{
	int32_t found = 0;
	for (int32_t k = c->active_first; k != CNI_NONE; k = sparse->nodes[k].next_active) {
		cni_node *n = &sparse->nodes[k];
		int32_t limit = acts(world, n, CNI_ROW_LIMIT);
		n->total[2] = limit && n->x[2] > 0.0f ? FLT_MAX : n->total[2] - n->x[2] * impulse; /* FLT_MAX: the contact pulls */
		found |= limit;
	}
	return found;
}

int32_t cni_active_leave(const cn_world *world, cni_sparse *sparse, const cni_component *c)
{
	int32_t found = 0;
	for (int32_t k = c->active_first; k != CNI_NONE; k = sparse->nodes[k].next_active) {
		cni_node *n = &sparse->nodes[k];
		if (!acts(world, n, CNI_ROW_MOTOR) && !(acts(world, n, CNI_ROW_LIMIT) && active_row(world, n)->impulse < LIMIT_BEARS_LEAST * n->total[2]))
			continue;
		cni_levers_clear(&n->levers, 2);
		found = 1;
	}
	return found;
}

/* A motor yields a little, so that a mechanism that is stuck is solved with some 1 / MOTOR_YIELD times its greatest impulse and not with what
   rounding makes of an infinite one. Its impulse is bounded afterwards (cni_active_change). */
static float motor_compliance(const cn_world *world, const cni_row *r, const cni_solve *s)
{
	return r->kind == CNI_ROW_MOTOR ? MOTOR_YIELD * (cni_abs(r->target) + cni_row_push_speed(world, r)) / impulse_most(r, s) : 0.0f;
}

void cni_active_levers(const cn_world *world, const cni_solve *s, cni_sparse *sparse, const cni_component *c)
{
	for (int32_t k = c->active_first; k != CNI_NONE; k = sparse->nodes[k].next_active) {
		cni_node *n = &sparse->nodes[k];
		if (!(n->active & CNI_ROW_IN_SET))
			continue;
		cni_levers_set(&n->levers, 2, active_row(world, n)->lever);
		n->compliance[2] = motor_compliance(world, active_row(world, n), s);
	}
}

void cni_active_right_sides(const cn_world *world, const cni_solve *s, cni_sparse *sparse, const cni_component *c, int32_t bias)
{
	for (int32_t k = c->active_first; k != CNI_NONE; k = sparse->nodes[k].next_active) {
		cni_node *n = &sparse->nodes[k];
		const cni_row *r = active_row(world, n);
		n->target = target_speed(world, r, s, bias);
		if (bias && c->loops && n->rows == 0 && r->kind == CNI_ROW_LIMIT) /* a rope has the leak of rows (direct/component.c) */
			n->target -= CNI_DIRECT_LEAK * n->diagonal[2] * r->impulse;
		if (n->active & CNI_ROW_IN_SET)
			n->x[2] = missing_speed(world, n, r);
	}
}

float cni_active_limit_missing(const cn_world *world, const cni_sparse *sparse, const cni_component *c, int32_t ropes)
{
	float most = 0.0f;
	for (int32_t k = c->active_first; k != CNI_NONE; k = sparse->nodes[k].next_active) {
		const cni_row *r = active_row(world, &sparse->nodes[k]);
		if (r->kind == CNI_ROW_LIMIT && (sparse->nodes[k].rows == 0 || !ropes))
			most = cni_max(most, missing_speed(world, &sparse->nodes[k], r) * cni_row_length(world, r));
	}
	return most;
}

/* ---- the set ---- */

/* Does the row leave the set, clamped to its bound, or return? */
static int32_t state_change(const cn_world *world, const cni_solve *s, cni_node *n)
{
	cni_row *r = active_row(world, n);
	float most = impulse_most(r, s), least = r->kind == CNI_ROW_MOTOR ? -most : 0.0f, bounded = cni_clamp(r->impulse, least, most);
	if (n->active & CNI_ROW_IN_SET) {
		if (r->impulse >= least && r->impulse <= most)
			return 0;
		n->active = r->impulse > most ? CNI_ROW_AT_UPPER : 0u;
		cni_lever_push(&r->lever, bounded - r->impulse, cni_motions(world) + n->ia, cni_motions(world) + n->ib);
		r->impulse = bounded;
	} else {
		float missing = missing_speed(world, n, r);
		if (n->active & CNI_ROW_AT_UPPER ? missing >= 0.0f : missing <= 0.0f)
			return 0;
		n->active = CNI_ROW_IN_SET;
	}
	return 1;
}

/* Of a row outside of the set that has one beside it: a limit that let go gives way to its motor, and a motor at its bound to the limit that it does
   not hold. */
static int32_t rows_swap(const cn_world *world, const cni_solve *s, cni_node *n, int32_t bias)
{
	cni_joint_constraint *w = &cni_joint_constraints(world)[n->owner];
	int32_t active = w->active_row;
	const cni_row *idle = w->idle_row == CNI_NONE ? NULL : &w->rows[w->idle_row];
	if (idle == NULL || (n->active & CNI_ROW_IN_SET))
		return 0;
	float target = target_speed(world, idle, s, bias);
	if (idle->kind == CNI_ROW_LIMIT && cni_lever_speed(&idle->lever, cni_motions(world) + n->ia, cni_motions(world) + n->ib) >= target)
		return 0;
	n->active = idle->kind == CNI_ROW_LIMIT ? CNI_ROW_IN_SET : state_of(idle, s, idle->impulse);
	n->target = target;
	w->active_row = w->idle_row;
	w->idle_row = active;
	return 1;
}

int32_t cni_active_change(const cn_world *world, const cni_solve *s, cni_sparse *sparse, const cni_component *c, int32_t bias)
{
	int32_t k, changed = 0;
	for (k = c->active_first; k != CNI_NONE; k = sparse->nodes[k].next_active) {
		changed |= state_change(world, s, &sparse->nodes[k]);
		changed |= rows_swap(world, s, &sparse->nodes[k], bias);
	}
	return changed;
}

void cni_active_impulses_add(const cn_world *world, const cni_sparse *sparse, const cni_component *c)
{
	for (int32_t k = c->active_first; k != CNI_NONE; k = sparse->nodes[k].next_active)
		if (sparse->nodes[k].active & CNI_ROW_IN_SET)
			active_row(world, &sparse->nodes[k])->impulse += sparse->nodes[k].x[2];
}
