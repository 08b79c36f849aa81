/*
 * direct/active_rows.c - motors and limits in the system of their joints (direct/direct_joints.c).
 *
 * A motor that is solved in turn with the rigid rows of a linkage meets the two bodies at its joint, and not the mass that
 * the linkage puts behind them; turns between two stiff groups then swing wider in every pass. So such a row is the third of
 * its joint's node: a motor's asks for a speed, a limit's for no more speed than the room that is left allows.
 *
 * Their bounds make it a problem of complementarity, which is solved by an active set: all rows of the set are solved
 * exactly; rows beyond their bound are put to it and leave the set, rows that are out and miss their speed on the side to
 * which they could push come back; solve again. After ROUNDS changes the last set counts as it is. The set is kept
 * from pass to pass, so that one round is what most passes take.
 *
 * A joint has one such row: its limit near it, else its motor. The other is solved in turn, as springs are.
 *
 * Reads works, motion; writes works' rows and inner, nodes' third rows, motion velocities.
 */
#include "direct/direct_system.h"

#include <string.h>
#define ROOM 0.05f             /* metres or radians: a limit that is nearer may be reached */

/* The speed that it asks for, at least if it is a limit. */
static float speed_asked(const cni_row *r, const cni_solve *s, int32_t bias)
{
	if (r->kind == CNI_ROW_MOTOR)
		return r->target;
	if (r->error > 0.0f)
		return -r->error * s->inv_h;
	return bias ? cni_min(-CNI_JOINT_ERROR_RATE * s->inv_h * r->error, s->push_speed) : 0.0f;
}

/* ---- which rows ---- */

static int32_t limit_is_near(const cni_row *r, const cni_motion *a, const cni_motion *b, float dt)
{
	return r->error < ROOM + 2.0f * dt * cni_abs(cni_row_speed(r, a, b));
}

/* Place of the row among the work's, 0: none. */
static int32_t row_choose(const cni_joint_constraint *w, const cni_motion *motions, float dt)
{
	int32_t k, chosen = 0;
	for (k = w->rigid_count; k < w->row_count; ++k) {
		if (w->rows[k].kind == CNI_ROW_MOTOR && w->rows[k].limit > 0.0f)
			chosen = k;
		if (w->rows[k].kind == CNI_ROW_LIMIT && limit_is_near(&w->rows[k], motions + w->ia, motions + w->ib, dt))
			return k;
	}
	return chosen;
}

/* Its impulse is still that of the last step. */
static uint32_t state_begin(const cni_row *r, const cni_solve *s)
{
	float impulse = s->warm_scale * r->impulse, most = cni_active_impulse_most(r, s);
	if (r->kind == CNI_ROW_LIMIT)
		return impulse > 0.0f ? CNI_ROW_IN_SET : 0;
	if (cni_abs(impulse) < 0.999f * most)
		return CNI_ROW_IN_SET;
	return impulse > 0.0f ? CNI_ROW_AT_UPPER : 0;
}

int32_t cni_active_begin(cn_world *world, const cni_solve *s, cni_sparse *sparse, const cni_component *c)
{
	int32_t k, found = 0;
	for (k = c->begin; k < c->end; ++k) {
		cni_node *n = &sparse->nodes[k];
		cni_joint_constraint *w = n->owner >= 0 ? &cni_joint_constraints(world)[n->owner] : NULL;
		int32_t row = w == NULL || n->rows == CNI_NODE_ROWS ? 0 : row_choose(w, cni_motions(world), s->dt);
		if (row == 0)
			continue;
		cni_joint_constraint_narrow(world, s, n->owner);
		w->inner = row;
		n->held = state_begin(&w->rows[row], s);
		found = cni_max_i(found, w->rows[row].kind == CNI_ROW_MOTOR ? 2 : 1);
	}
	return found;
}

/* ---- the system ---- */

void cni_active_clear(const cn_world *world, cni_sparse *sparse, const cni_component *c)
{
	int32_t k;
	for (k = c->begin; k < c->end; ++k)
		if (cni_active_row(world, &sparse->nodes[k]) != NULL)
			memset(&sparse->nodes[k].lever[2], 0, sizeof sparse->nodes[k].lever[2]);
}

void cni_active_levers(const cn_world *world, cni_sparse *sparse, const cni_component *c)
{
	int32_t k;
	for (k = c->begin; k < c->end; ++k) {
		cni_node *n = &sparse->nodes[k];
		const cni_row *r = cni_active_row(world, n);
		if (r == NULL || !(n->held & CNI_ROW_IN_SET))
			continue;
		n->lever[2] = cni_row_lever(r);
		n->compliance[2] = 0.0f;
	}
}

void cni_active_sides(const cn_world *world, const cni_solve *s, cni_sparse *sparse, const cni_component *c, int32_t bias)
{
	const cni_motion *motions = cni_motions(world);
	int32_t k;
	for (k = c->begin; k < c->end; ++k) {
		cni_node *n = &sparse->nodes[k];
		const cni_row *r = cni_active_row(world, n);
		if (r == NULL)
			continue;
		n->wanted = speed_asked(r, s, bias);
		if (n->held & CNI_ROW_IN_SET)
			n->x[2] = n->wanted - cni_lever_speed(&n->lever[2], motions + n->ia, motions + n->ib);
	}
}
