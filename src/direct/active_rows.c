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
#include "joints/joint_work.h"

#include <string.h>

#define ROUNDS 3               /* changes of the set in a pass */
#define ROOM 0.05f             /* metres or radians: a limit that is nearer may be reached */

/* bits of a node's held */
enum { IN_SET = 1u, AT_UPPER = 2u };

static cni_row *inner_row(const cn_world *world, const cni_node *n)
{
	cni_joint_work *w = n->owner >= 0 ? &cni_joint_works(world)[n->owner] : NULL;
	return w != NULL && w->inner > 0 ? &w->rows[w->inner] : NULL;
}

static float impulse_least(const cni_row *r, const cni_solve *s)
{
	return r->kind == CNI_ROW_MOTOR ? -r->limit * s->h : 0.0f;
}

static float impulse_most(const cni_row *r, const cni_solve *s)
{
	return r->kind == CNI_ROW_MOTOR ? r->limit * s->h : FLT_MAX;
}

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
static int32_t row_choose(const cni_joint_work *w, const cni_motion *motions, float dt)
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
	float impulse = s->warm_scale * r->impulse, most = impulse_most(r, s);
	if (r->kind == CNI_ROW_LIMIT)
		return impulse > 0.0f ? IN_SET : 0;
	if (cni_abs(impulse) < 0.999f * most)
		return IN_SET;
	return impulse > 0.0f ? AT_UPPER : 0;
}

int32_t cni_active_begin(cn_world *world, const cni_solve *s, cni_sparse *sparse, const cni_component *c)
{
	int32_t k, found = 0;
	for (k = c->begin; k < c->end; ++k) {
		cni_node *n = &sparse->nodes[k];
		cni_joint_work *w = n->owner >= 0 ? &cni_joint_works(world)[n->owner] : NULL;
		int32_t row = w == NULL || n->rows == CNI_NODE_ROWS ? 0 : row_choose(w, cni_motions(world), s->dt);
		if (row == 0)
			continue;
		cni_joint_work_narrow(world, s, n->owner);
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
		if (inner_row(world, &sparse->nodes[k]) != NULL)
			memset(&sparse->nodes[k].lever[2], 0, sizeof sparse->nodes[k].lever[2]);
}

void cni_active_levers(const cn_world *world, cni_sparse *sparse, const cni_component *c)
{
	int32_t k;
	for (k = c->begin; k < c->end; ++k) {
		cni_node *n = &sparse->nodes[k];
		const cni_row *r = inner_row(world, n);
		if (r == NULL || !(n->held & IN_SET))
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
		const cni_row *r = inner_row(world, n);
		if (r == NULL)
			continue;
		n->wanted = speed_asked(r, s, bias);
		if (n->held & IN_SET)
			n->x[2] = n->wanted - cni_lever_speed(&n->lever[2], motions + n->ia, motions + n->ib);
	}
}

/* Puts a row to an impulse, along its lever as it is. */
static void row_put(const cn_world *world, const cni_node *n, cni_row *r, float impulse)
{
	cni_row_push(r, impulse - r->impulse, cni_motions(world) + n->ia, cni_motions(world) + n->ib);
	r->impulse = impulse;
}

/* Rows that are beyond their bound leave, others come back. Returns 1 when the set has changed. */
static int32_t set_change(const cn_world *world, const cni_solve *s, cni_sparse *sparse, const cni_component *c)
{
	const cni_motion *motions = cni_motions(world);
	int32_t k, changed = 0;
	for (k = c->begin; k < c->end; ++k) {
		cni_node *n = &sparse->nodes[k];
		cni_row *r = inner_row(world, n);
		float least, most;
		if (r == NULL)
			continue;
		least = impulse_least(r, s);
		most = impulse_most(r, s);
		if (n->held & IN_SET) {
			if (r->impulse >= least && r->impulse <= most)
				continue;
			n->held = r->impulse > most ? AT_UPPER : 0;
			row_put(world, n, r, cni_clamp(r->impulse, least, most));
		} else {
			float lacks = n->wanted - cni_row_speed(r, motions + n->ia, motions + n->ib);
			if (n->held & AT_UPPER ? lacks >= 0.0f : lacks <= 0.0f && r->kind == CNI_ROW_MOTOR)
				continue;
			if (r->kind == CNI_ROW_LIMIT && lacks <= 0.0f)
				continue;
			n->held = IN_SET;
		}
		changed = 1;
	}
	return changed;
}

static void impulses_add(const cn_world *world, const cni_sparse *sparse, const cni_component *c)
{
	int32_t k;
	for (k = c->begin; k < c->end; ++k) {
		const cni_node *n = &sparse->nodes[k];
		cni_row *r = inner_row(world, n);
		if (r != NULL && (n->held & IN_SET))
			r->impulse += n->x[2];
	}
}

/* Right sides to speeds that are asked for, so that they can be found again once something has been pushed (-1), or back. */
static void sides_turn(const cn_world *world, cni_sparse *sparse, const cni_component *c, int32_t back)
{
	const cni_motion *motions = cni_motions(world);
	int32_t k, i;
	for (k = c->begin; k < c->end; ++k) {
		cni_node *n = &sparse->nodes[k];
		const cni_row *r = inner_row(world, n);
		for (i = 0; i < n->rows; ++i) {
			float speed = cni_lever_speed(&n->lever[i], motions + n->ia, motions + n->ib);
			if (back)
				n->x[i] = n->total[i] - speed;
			else
				n->total[i] = n->x[i] + speed;
		}
		for (; back && i < CNI_NODE_ROWS; ++i)
			n->x[i] = -cni_lever_speed(&n->lever[i], motions + n->ia, motions + n->ib);
		if (back && r != NULL && (n->held & IN_SET))
			n->x[2] += n->wanted;
	}
}

int32_t cni_active_answer(cn_world *world, const cni_solve *s, cni_sparse *sparse, cni_component *c)
{
	int32_t round;
	sides_turn(world, sparse, c, 0);
	for (round = 0;; ++round) {
		if (!cni_direct_apply(world, sparse, c))
			return 0;
		impulses_add(world, sparse, c);
		if (round == ROUNDS || !set_change(world, s, sparse, c))
			return 1;
		cni_direct_system(world, s, sparse, c);
		sides_turn(world, sparse, c, 1);
	}
}
