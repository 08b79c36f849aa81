/*
 * stages/joint_net.c - large nets of joints: so many loops that factoring them every substep is too dear.
 *
 * A net that begins to bear, or has come apart, is solved in one step by conjugate gradients on K lambda = -J v
 * (Hestenes and Stiefel, 1952; Saad, "Iterative Methods for Sparse Linear Systems", 2003, 9.2), for which its factors,
 * made once with a diagonal that is a little too great, are the preconditioner. Loops say the same twice in thousands of
 * ways, and floats cannot factor that as it is; conjugate gradients ask for no more than products with K and
 * stop when the speeds are closed. The soft solver, which brings no such loads together in years of
 * sweeps, holds them well once they are there; what it cannot see, stages/joint_coarse.h does.
 *
 * Reads works, drives, motion; writes motion, start, works' rows and flags, drive flags.
 */
#include "stages/joint_work.h"

#include <string.h>

#define CLOSED 2e-7f           /* length units or radians that a joint may open in a substep */
#define ITERATIONS 100

typedef struct net {
	cn_world *world;
	const cni_solve *s;
	cni_sparse *sparse;
	const cni_component *c;
	cni_motion *motions;
	cni_motion *change;    /* by dense body: change of velocity by a direction's impulses */
	float *left, *way;     /* by row: what is left of the right hand side; the direction */
} net;

static int32_t row_at(const net *g, int32_t node, int32_t i)
{
	return (node - g->c->begin) * CNI_NODE_ROWS + i;
}

static cni_joint_work *work_of(const net *g, int32_t node)
{
	return &cni_joint_works(g->world)[g->sparse->nodes[node].owner];
}

/* ---- conjugate gradients ---- */

/* change = M^-1 J' way */
static void changes_find(const net *g)
{
	int32_t k, i;
	for (k = g->c->body_begin; k < g->c->body_end; ++k) {
		cni_motion *d = g->change + g->sparse->bodies[k];
		*d = g->motions[g->sparse->bodies[k]];
		d->vx = d->vy = d->w = 0.0f;
	}
	for (k = g->c->begin; k < g->c->end; ++k) {
		const cni_node *n = &g->sparse->nodes[k];
		for (i = 0; i < n->rows; ++i)
			cni_lever_push(&n->lever[i], g->way[row_at(g, k, i)], g->change + n->ia, g->change + n->ib);
	}
}

/* way . K way */
static double stiffness_along(const net *g)
{
	double sum = 0.0;
	int32_t k, i;
	for (k = g->c->begin; k < g->c->end; ++k) {
		const cni_node *n = &g->sparse->nodes[k];
		for (i = 0; i < n->rows; ++i)
			sum += (double)g->way[row_at(g, k, i)] * (double)cni_lever_speed(&n->lever[i], g->change + n->ia, g->change + n->ib);
	}
	return sum;
}

/* A step of this length along the way; returns the largest speed that is left. */
static float step_along(const net *g, float length)
{
	float largest = 0.0f;
	int32_t k, i;
	for (k = g->c->begin; k < g->c->end; ++k) {
		cni_node *n = &g->sparse->nodes[k];
		for (i = 0; i < n->rows; ++i) {
			float *left = &g->left[row_at(g, k, i)];
			n->total[i] += length * g->way[row_at(g, k, i)];
			*left -= length * cni_lever_speed(&n->lever[i], g->change + n->ia, g->change + n->ib);
			largest = cni_max(largest, cni_abs(*left));
		}
	}
	return largest;
}

/* The nodes' x = P^-1 left; returns left . x. */
static double precondition(const net *g)
{
	double sum = 0.0;
	int32_t k, i;
	for (k = g->c->begin; k < g->c->end; ++k)
		for (i = 0; i < CNI_NODE_ROWS; ++i)
			g->sparse->nodes[k].x[i] = i < g->sparse->nodes[k].rows ? g->left[row_at(g, k, i)] : 0.0f;
	if (!cni_sparse_solve(g->sparse, g->c))
		return 0.0;
	for (k = g->c->begin; k < g->c->end; ++k)
		for (i = 0; i < g->sparse->nodes[k].rows; ++i)
			sum += (double)g->left[row_at(g, k, i)] * (double)g->sparse->nodes[k].x[i];
	return sum;
}

/* way = x + part way */
static void way_turn(const net *g, float part)
{
	int32_t k, i;
	for (k = g->c->begin; k < g->c->end; ++k)
		for (i = 0; i < g->sparse->nodes[k].rows; ++i) {
			float *way = &g->way[row_at(g, k, i)];
			*way = g->sparse->nodes[k].x[i] + part * *way;
		}
}

/* From left to the nodes' totals. 0: it does not get there. */
static int32_t conjugate_gradients(const net *g)
{
	double fall = precondition(g);
	float target = CLOSED * g->world->settings.length_unit * g->s->inv_h;
	int32_t k;
	way_turn(g, 0.0f);
	for (k = 0; k < ITERATIONS; ++k) {
		double stiffness, next;
		changes_find(g);
		stiffness = stiffness_along(g);
		if (!(fall > 0.0) || !(stiffness > 0.0))
			return 0;
		if (step_along(g, (float)(fall / stiffness)) <= target)
			return 1;
		next = precondition(g);
		way_turn(g, (float)(next / fall));
		fall = next;
	}
	return 0;
}

/* ---- the step ---- */

/* What the joints' speeds lack; returns the largest. Gaps that are there stay: loops make gaps that cannot all be
   closed, and trying to would ask for impulses without bound. */
static float left_find(const net *g)
{
	float largest = 0.0f;
	int32_t k, i;
	for (k = g->c->begin; k < g->c->end; ++k) {
		cni_node *n = &g->sparse->nodes[k];
		for (i = 0; i < n->rows; ++i) {
			float *left = &g->left[row_at(g, k, i)];
			*left = -cni_lever_speed(&n->lever[i], g->motions + n->ia, g->motions + n->ib);
			n->total[i] = 0.0f;
			largest = cni_max(largest, cni_abs(*left));
		}
	}
	return largest;
}

static void totals_push(const net *g)
{
	int32_t k, i;
	for (k = g->c->begin; k < g->c->end; ++k) {
		const cni_node *n = &g->sparse->nodes[k];
		for (i = 0; i < n->rows; ++i) {
			work_of(g, k)->rows[i].impulse += n->total[i];
			cni_lever_push(&n->lever[i], n->total[i], g->motions + n->ia, g->motions + n->ib);
		}
	}
}

static int32_t speeds_close(const net *g)
{
	float enough = CLOSED * g->world->settings.length_unit * g->s->inv_h;
	if (left_find(g) <= enough)
		return 1;
	if (!conjugate_gradients(g))
		return 0;
	totals_push(g);
	return 1;
}

/* v += h a, and the impulses of the substep before once more. */
static void velocities_begin(const net *g)
{
	int32_t k, i;
	for (k = g->c->body_begin; k < g->c->body_end; ++k) {
		int32_t index = g->sparse->bodies[k];
		const cni_body *b = cni_body_at(g->world, cni_awake_ids(g->world)[index]);
		const cni_drive *d = cni_drives(g->world) + index;
		cni_motion *m = g->motions + index;
		cni_velocity_start *start = cni_starts(g->world) + index;
		float linear = cni_damping_factor(b->linear_damping, g->s->h);
		m->vx = start->vx = linear * (m->vx + g->s->h * d->ax);
		m->vy = start->vy = linear * (m->vy + g->s->h * d->ay);
		m->w = start->w = cni_damping_factor(b->angular_damping, g->s->h) * (m->w + g->s->h * d->alpha);
		start->struck = 0.0f;
	}
	for (k = g->c->begin; k < g->c->end; ++k) {
		const cni_node *n = &g->sparse->nodes[k];
		for (i = 0; i < n->rows; ++i)
			cni_lever_push(&n->lever[i], work_of(g, k)->rows[i].impulse, g->motions + n->ia, g->motions + n->ib);
	}
}

static void positions_follow(const net *g)
{
	int32_t k;
	for (k = g->c->body_begin; k < g->c->body_end; ++k) {
		cni_motion *m = g->motions + g->sparse->bodies[k];
		m->dpx += g->s->h * m->vx;
		m->dpy += g->s->h * m->vy;
		m->theta += g->s->h * m->w;
	}
}

/* Rows and levers at the new positions, impulses kept. */
static void rows_renew(const net *g)
{
	int32_t k, i;
	cni_direct_turns(g->world, g->sparse, g->c);
	for (k = g->c->begin; k < g->c->end; ++k) {
		cni_joint_work *w = work_of(g, k);
		float impulse[CNI_NODE_ROWS] = { 0.0f, 0.0f, 0.0f };
		for (i = 0; i < w->rigid_count; ++i)
			impulse[i] = w->rows[i].impulse;
		cni_joint_work_rows(w, g->motions, g->sparse->turn);
		for (i = 0; i < w->row_count; ++i)
			w->rows[i].impulse = i < w->rigid_count ? impulse[i] : 0.0f;
	}
	(void)cni_direct_levers(g->world, g->sparse, g->c);
}

static int32_t substeps_take(const net *g)
{
	int32_t k;
	for (k = 0; k < g->s->substeps; ++k) {
		velocities_begin(g);
		if (!speeds_close(g))
			return 0;
		positions_follow(g);
		rows_renew(g);
		if (!speeds_close(g))
			return 0;
	}
	return 1;
}

static void bodies_end(const net *g)
{
	int32_t k, i;
	for (k = g->c->body_begin; k < g->c->body_end; ++k)
		cni_drives(g->world)[g->sparse->bodies[k]].flags |= CNI_DRIVE_SWUNG;
	for (k = g->c->begin; k < g->c->end; ++k) {
		cni_joint_work *w = work_of(g, k);
		w->flags |= CNI_WORK_SWUNG;
		w->flags &= ~(uint32_t)CNI_WORK_DIRECT; /* the soft solver's from now on, around these loads */
		for (i = 0; i < w->rigid_count; ++i)
			w->numbers->load[i] = w->rows[i].impulse;
		if (w->flags & CNI_WORK_BREAKABLE)
			cni_joint_work_stress(w, g->motions + w->ib, g->s->inv_h);
	}
}

void cni_net_run(cn_world *world, const cni_solve *s, cni_sparse *sparse, cni_component *c)
{
	uint64_t rows = sizeof(float) * CNI_NODE_ROWS * (uint64_t)(c->end - c->begin);
	net g = { world, s, sparse, c, cni_motions(world), NULL, NULL, NULL };
	int32_t k;
	c->done = 1;
	g.change = (cni_motion *)cni_arena_push(&world->arena, sizeof(cni_motion) * (uint64_t)world->awake_count);
	g.left = g.change == NULL ? NULL : (float *)cni_arena_push(&world->arena, rows);
	g.way = g.left == NULL ? NULL : (float *)cni_arena_push(&world->arena, rows);
	cni_direct_motions_keep(world, sparse, c, 0);
	if (g.way != NULL) {
		memset(g.way, 0, (size_t)rows);
		g.change[0] = g.motions[0];
		(void)cni_direct_levers(world, sparse, c);
		cni_sparse_factor(sparse, c, g.motions);
	}
	if (g.way != NULL && substeps_take(&g)) {
		bodies_end(&g);
	} else {
		cni_direct_motions_keep(world, sparse, c, 1);
		for (k = c->begin; k < c->end; ++k) /* each joint by itself, after all */
			cni_joint_work_prepare(world, s, sparse->nodes[k].owner);
	}
	(void)cni_arena_pop(&world->arena, g.way);
	(void)cni_arena_pop(&world->arena, g.left);
	(void)cni_arena_pop(&world->arena, g.change);
}
