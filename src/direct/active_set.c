/*
 * direct/active_set.c - solves a component with motors and limits among its rows by an active set (method in direct/active_rows.c).
 */
#include "direct/direct_system.h"
#include "model/tuning.h"

static float impulse_least(const cni_row *r, const cni_solve *s)
{
	return r->kind == CNI_ROW_MOTOR ? -r->limit * s->h : 0.0f;
}

/* Sets the impulse of a row and applies the difference along its present lever. */
static void row_set_impulse(const cn_world *world, const cni_node *n, cni_row *r, float impulse)
{
	cni_row_push(r, impulse - r->impulse, cni_motions(world) + n->ia, cni_motions(world) + n->ib);
	r->impulse = impulse;
}

/* Rows beyond their bound leave the set, others return. Returns 1 when the set has changed. */
static int32_t set_change(const cn_world *world, const cni_solve *s, cni_sparse *sparse, const cni_component *c)
{
	const cni_motion *motions = cni_motions(world);
	int32_t k, changed = 0;
	for (k = c->active_first; k != CNI_NONE; k = sparse->nodes[k].next_active) {
		cni_node *n = &sparse->nodes[k];
		cni_row *r = cni_active_row(world, n);
		float least = impulse_least(r, s), most = cni_active_impulse_most(r, s);
		if (n->active & CNI_ROW_IN_SET) {
			if (r->impulse >= least && r->impulse <= most)
				continue;
			n->active = r->impulse > most ? CNI_ROW_AT_UPPER : 0u;
			row_set_impulse(world, n, r, cni_clamp(r->impulse, least, most));
		} else {
			float missing = n->target - cni_row_speed(r, motions + n->ia, motions + n->ib);
			if (n->active & CNI_ROW_AT_UPPER ? missing >= 0.0f : missing <= 0.0f)
				continue;
			n->active = CNI_ROW_IN_SET;
		}
		changed = 1;
	}
	return changed;
}

void cni_active_impulses_add(const cn_world *world, const cni_sparse *sparse, const cni_component *c)
{
	int32_t k;
	for (k = c->active_first; k != CNI_NONE; k = sparse->nodes[k].next_active)
		if (sparse->nodes[k].active & CNI_ROW_IN_SET)
			cni_active_row(world, &sparse->nodes[k])->impulse += sparse->nodes[k].x[2];
}

/* Right sides of the changed set, from those of the last (carried) and the speeds of then (total; first 1) or the target speeds. */
static void sides_renew(const cn_world *world, cni_sparse *sparse, const cni_component *c, int32_t first)
{
	const cni_motion *motions = cni_motions(world);
	int32_t k, i;
	for (k = c->begin; k < c->end; ++k) {
		cni_node *n = &sparse->nodes[k];
		float speed[CNI_NODE_LANES];
		cni_four_store(speed, cni_levers_speed(&n->levers, motions + n->ia, motions + n->ib));
		for (i = 0; i < CNI_NODE_ROWS; ++i) {
			n->total[i] = i >= n->rows ? 0.0f : first ? n->carried[i] + n->total[i] : n->total[i];
			n->x[i] = n->total[i] - speed[i];
		}
		if (n->active & CNI_ROW_IN_SET)
			n->x[2] += n->target;
	}
}

/* Solves the right sides for impulses with the active set. 0: the solution is not finite. */
static int32_t set_solve(cn_world *world, const cni_solve *s, cni_sparse *sparse, cni_component *c)
{
	int32_t round;
	for (round = 0;; ++round) {
		if (!cni_direct_apply(world, sparse, c))
			return 0;
		cni_active_impulses_add(world, sparse, c);
		if (round == CNI_JOINT_SET_ROUNDS || !set_change(world, s, sparse, c))
			return 1;
		cni_direct_system(world, s, sparse, c);
		sides_renew(world, sparse, c, round == 0);
	}
}

void cni_component_solve(cn_world *world, const cni_solve *s, cni_component *c)
{
	if (!(c->active ? set_solve(world, s, s->direct, c) : cni_direct_apply(world, s->direct, c)))
		cni_component_suspend(world, s->direct, c, 0);
}

int32_t cni_component_lock(cn_world *world, const cni_solve *s, cni_component *c, float turn)
{
	if (c->has_contacts || c->done || c->active || !cni_geometric_stiffness_lock(world, s->direct, c, turn * s->inv_h))
		return 0;
	cni_sparse_factor(s->direct, c, cni_motions(world));
	cni_direct_right_sides(world, s, c, 1);
	cni_component_solve(world, s, c);
	return 1;
}
