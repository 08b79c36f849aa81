/*
 * direct/geometric_stiffness.c - geometric stiffness: the effect of joint tension on the rotation of bodies, and damping where the substeps
 * are too long for it.
 *
 * A joint that pulls a body outwards by f at the end of an arm r turns it back as a spring would, with a frequency of sqrt(sum(r.f) / I):
 * chains of light links with heavy loads, taut bridges. A velocity solver does not see that spring: it acts from one substep to the next,
 * and when Xi = h^2 sum(r.f) / I is much above one it gains energy and everything explodes. Beyond CNI_STIFFNESS_XI_MAX a third row damps
 * the relative rotation of bodies that are pinned to each other, (w_b - w_a) + lambda / c = 0 with c = h^2 sum(r.f) -
 * CNI_STIFFNESS_XI_MAX I: between bodies, so that it conserves momentum, and with c = 0 where the substeps are short enough.
 *
 * Bodies that turn too far in a substep for positions to follow are locked to each other during it (direct/joint_projection.c).
 *
 * Reads joint constraints, motion, the sparse system's turn; writes its pull and the third rows of its nodes.
 */
#include "direct/direct_system.h"

static void pulls_clear(cni_sparse *sparse, const cni_component *c)
{
	for (int32_t k = c->body_begin; k < c->body_end; ++k)
		sparse->pull[sparse->bodies[k]] = 0.0f;
}

/* Adds numbers of a joint to those of its bodies that move. */
CNI_INLINE void pull_add(const cn_world *world, cni_sparse *sparse, const cni_joint_constraint *w, float of_a, float of_b)
{
	if (cni_motion_can_move(cni_motions(world) + w->ia))
		sparse->pull[w->ia] += of_a;
	if (cni_motion_can_move(cni_motions(world) + w->ib))
		sparse->pull[w->ib] += of_b;
}

void cni_geometric_stiffness_find_pins(const cn_world *world, cni_sparse *sparse, const cni_component *c, float h)
{
	float inv_h = 1.0f / h;
	pulls_clear(sparse, c);
	for (int32_t k = c->begin; k < c->end; ++k) {
		const cni_joint_constraint *w = &cni_joint_constraints(world)[sparse->nodes[k].owner];
		cni_vec2 f = cni_mul(inv_h, cni_v(w->record->impulse[0], w->record->impulse[1]));
		pull_add(world, sparse, w, cni_dot(w->start.ra, cni_neg(f)), cni_dot(w->start.rb, f));
	}
}

/* From the rows' impulses of a substep of length h. */
void cni_geometric_stiffness_find(const cn_world *world, cni_sparse *sparse, const cni_component *c, float h)
{
	float inv_h = 1.0f / h;
	pulls_clear(sparse, c);
	for (int32_t k = c->begin; k < c->end; ++k) {
		cni_vec2 fa = cni_v(0.0f, 0.0f), fb = fa;
		if (sparse->nodes[k].owner < 0)
			continue; /* a contact */
		const cni_joint_constraint *w = &cni_joint_constraints(world)[sparse->nodes[k].owner];
		for (int32_t i = 0; i < (w->rigid_count > 0 ? w->rigid_count : w->row_count); ++i) { /* a rope has its limit alone */
			const cni_row *r = &w->rows[i];
			fa = cni_madd(fa, r->impulse * inv_h, cni_v(r->lever.ax, r->lever.ay));
			fb = cni_madd(fb, r->impulse * inv_h, cni_v(r->lever.bx, r->lever.by));
		}
		pull_add(world, sparse, w, cni_dot(cni_rotate(sparse->turn[w->ia], w->start.ra), fa), cni_dot(cni_rotate(sparse->turn[w->ib], w->start.rb), fb));
	}
}

/* Rods between bodies: f / l against a body's mass. The squared frequency of a chain of them is at most twice the sum at a body. */
float cni_geometric_stiffness_rods(const cn_world *world, cni_sparse *sparse, const cni_component *c, float h)
{
	float inv_h = 1.0f / h, most = 0.0f;
	pulls_clear(sparse, c);
	for (int32_t k = c->begin; k < c->end; ++k) {
		const cni_joint_constraint *w = &cni_joint_constraints(world)[sparse->nodes[k].owner];
		float stiffness, length = w->record->p[cni_joint_is_rope(w->record) ? CNI_P_UPPER : CNI_P_LENGTH];
		if (w->record->type != CN_JOINT_DISTANCE || length <= 0.0f)
			continue;
		stiffness = cni_abs(w->rows[0].impulse) * inv_h / length;
		pull_add(world, sparse, w, stiffness, stiffness);
	}
	for (int32_t k = c->body_begin; k < c->body_end; ++k)
		most = cni_max(most, sparse->pull[sparse->bodies[k]] * cni_motions(world)[sparse->bodies[k]].inv_mass);
	return 2.0f * most;
}

float cni_geometric_stiffness_largest(const cn_world *world, const cni_sparse *sparse, const cni_component *c)
{
	float most = 0.0f;
	for (int32_t k = c->body_begin; k < c->body_end; ++k)
		most = cni_max(most, sparse->pull[sparse->bodies[k]] * cni_motions(world)[sparse->bodies[k]].inv_inertia);
	return most;
}

int32_t cni_geometric_stiffness_needs_dampers(const cn_world *world, const cni_sparse *sparse, const cni_component *c, float h)
{
	return CNI_ON(GEOMETRIC_STIFFNESS) && h * h * cni_geometric_stiffness_largest(world, sparse, c) > 0.5f * CNI_STIFFNESS_XI_MAX;
}

void cni_geometric_stiffness_begin(const cn_world *world, cni_sparse *sparse, cni_component *c, float h)
{
	cni_geometric_stiffness_find(world, sparse, c, h);
	c->damps = cni_geometric_stiffness_needs_dampers(world, sparse, c, h);
	c->width = c->damps ? CNI_NODE_ROWS : c->width;
}

/* c of a body: the part of h^2 sum(r.f) that a substep does not resolve. */
static float excess(const cn_world *world, const cni_sparse *sparse, int32_t index, float h)
{
	float inv_inertia = cni_motions(world)[index].inv_inertia;
	return inv_inertia > 0.0f ? h * h * sparse->pull[index] - CNI_STIFFNESS_XI_MAX / inv_inertia : 0.0f;
}

static int32_t both_move(const cn_world *world, const cni_node *n)
{
	return cni_motion_can_move(cni_motions(world) + n->ia) && cni_motion_can_move(cni_motions(world) + n->ib);
}

void cni_geometric_stiffness_damp(const cn_world *world, cni_sparse *sparse, const cni_component *c, float h)
{
	if (!c->damps)
		return;
	cni_geometric_stiffness_find(world, sparse, c, h);
	for (int32_t k = c->begin; k < c->end; ++k) {
		cni_node *n = &sparse->nodes[k];
		if (n->rows != 2 || !both_move(world, n))
			continue;
		float most = cni_max(excess(world, sparse, n->ia, h), excess(world, sparse, n->ib, h));
		n->levers.aw[2] = most > 0.0f ? -1.0f : 0.0f;
		n->levers.bw[2] = most > 0.0f ? 1.0f : 0.0f;
		n->compliance[2] = most > 0.0f ? 1.0f / most : 0.0f;
	}
}

static int32_t turns_far(const cn_world *world, const cni_node *n, float most)
{
	const cni_motion *a = cni_motions(world) + n->ia, *b = cni_motions(world) + n->ib;
	if ((cni_abs(a->w) <= most && cni_abs(b->w) <= most) || cni_abs(b->w - a->w) <= 0.5f * most)
		return 0;
	return n->rows == 2 && cni_joint_constraints(world)[n->owner].active_row == CNI_NONE && both_move(world, n);
}

int32_t cni_geometric_stiffness_turns(const cn_world *world, const cni_sparse *sparse, const cni_component *c, float most)
{
	for (int32_t k = c->begin; k < c->end && CNI_ON(GEOMETRIC_STIFFNESS); ++k)
		if (turns_far(world, &sparse->nodes[k], most))
			return 1;
	return 0;
}

int32_t cni_geometric_stiffness_lock(const cn_world *world, const cni_sparse *sparse, cni_component *c, float most)
{
	if (!cni_geometric_stiffness_turns(world, sparse, c, most))
		return 0;
	for (int32_t k = c->begin; k < c->end; ++k) {
		cni_node *n = &sparse->nodes[k];
		if (!turns_far(world, n, most))
			continue;
		n->levers.aw[2] = -1.0f;
		n->levers.bw[2] = 1.0f;
		n->compliance[2] = 0.0f;
	}
	c->width = CNI_NODE_ROWS;
	c->damps = 1;
	return 1;
}
