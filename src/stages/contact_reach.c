/*
 * stages/contact_reach.c - contacts of stages/contact_joined.c in a substep: how far their impulses reach through joints, and
 * the impulses.
 *
 * The reach R = Jc A Jc^T is the speed that an impulse on one contact row gives to another,
 * where A is the response of bodies whose joints are held, by half a solution of the factored joints for each row. R is
 * small and dense; projected Gauss-Seidel on it (Jean & Moreau, 1992) has an end for any friction, cannot fail as an active
 * set can, and needs few rounds, because what made it slow is in R. Then the joints are solved once more, so that
 * both hold as positions move (stages/joint_close.c). R serves until bodies have turned.
 *
 * Reads the factored systems of joints, motion; writes the contacts' impulses, motion velocities.
 */
#include "base/cpu.h"
#include "stages/press.h"
#if CNI_HAS_WIDE_4
#define CNI_WIDTH 4
#else
#define CNI_WIDTH 1
#endif
#include "base/wide.h"

#include <string.h>

#define ROW_MOST (3 * CNI_JOINED_CONTACTS)
#define ROUNDS 20
#define TURN_MOST 0.01f        /* radians that bodies may turn until the reach is found anew */
#define PUSH_RATE 0.1f         /* part of an overlap that is taken out in a substep */
#define SPEED_LEAST 3e-3f      /* length units a second that are no motion */
#define STILL_SPEED 1e-3f      /* ... and that need not be solved at all */
#define REACH_LEAST 1e-5f      /* of a row's own: less is rounding, its joints hold it as it is */

/* ---- reach ---- */

typedef struct pass {
	cn_world *world;
	const cni_solve *s;
	cni_sparse *sparse;
	cni_joined *joined;
	cni_motion *motions;
	int32_t bias;
	cni_lever lever[ROW_MOST]; /* zero: no row */
	CNI_ALIGNED(16) float speed[ROW_MOST];
	float room[ROW_MOST]; /* speeds must be at least -room */
	float given[ROW_MOST];
	float mass[ROW_MOST]; /* 1 / reach of a row on itself; 0: nothing moves it */
} pass;

/* What an impulse on a lever changes the speed of another by, where they share a body. */
static float coupling(const pass *q, const cni_lever *p, int32_t pa, int32_t pb, const cni_lever *l, int32_t la, int32_t lb)
{
	float sum = 0.0f;
	const cni_motion *a = q->motions + pa, *b = q->motions + pb;
	if (pa == la)
		sum += a->inv_mass * (p->ax * l->ax + p->ay * l->ay) + a->inv_inertia * p->aw * l->aw;
	if (pa == lb)
		sum += a->inv_mass * (p->ax * l->bx + p->ay * l->by) + a->inv_inertia * p->aw * l->bw;
	if (pb == la)
		sum += b->inv_mass * (p->bx * l->ax + p->by * l->ay) + b->inv_inertia * p->bw * l->aw;
	if (pb == lb)
		sum += b->inv_mass * (p->bx * l->bx + p->by * l->by) + b->inv_inertia * p->bw * l->bw;
	return sum;
}

static int32_t shares(int32_t pa, int32_t pb, int32_t la, int32_t lb)
{
	return pa == la || pa == lb || pb == la || pb == lb;
}

/* Of bodies that no joint holds. */
static void reach_free(const pass *q)
{
	const cni_joined *j = q->joined;
	int32_t k, l, i, m;
	for (k = 0; k < j->count; ++k)
		for (l = 0; l < j->count; ++l) {
			const cni_press *p = &j->presses[k], *o = &j->presses[l];
			for (i = 0; i < 9 && shares(p->ia, p->ib, o->ia, o->ib); ++i) {
				m = i % 3;
				j->reach[(3 * k + i / 3) * j->columns + 3 * l + m] =
					coupling(q, &q->lever[3 * k + i / 3], p->ia, p->ib, &q->lever[3 * l + m], o->ia, o->ib);
			}
		}
}

/* Takes out what the joints of a system hold. */
static void reach_held(const pass *q, const cni_component *c)
{
	const cni_joined *j = q->joined;
	int32_t k, n, i, any = 0;
	memset(j->nodes, 0, sizeof(float) * (size_t)((c->end - c->begin) * CNI_NODE_ROWS * j->columns));
	for (n = c->begin; n < c->end; ++n) {
		const cni_node *node = &q->sparse->nodes[n];
		float *x = j->nodes + (n - c->begin) * CNI_NODE_ROWS * j->columns;
		for (k = 0; k < j->count; ++k) {
			const cni_press *p = &j->presses[k];
			if (!shares(p->ia, p->ib, node->ia, node->ib))
				continue;
			any = 1;
			for (i = 0; i < 3 * c->width; ++i)
				x[i / 3 * j->columns + 3 * k + i % 3] = coupling(q, &q->lever[3 * k + i % 3], p->ia, p->ib, &node->lever[i / 3], node->ia, node->ib);
		}
	}
	if (any)
		cni_sparse_reach(q->sparse, c, j->nodes, j->columns, j->reach);
}

static int32_t reach_find(const pass *q)
{
	const cni_joined *j = q->joined;
	float finite = 0.0f;
	int32_t k, l;
	memset(j->reach, 0, sizeof(float) * (size_t)(j->columns * j->columns));
	reach_free(q);
	for (k = cni_joined_first(q->sparse, j); k != CNI_NONE; k = cni_joined_next(q->sparse, k))
		reach_held(q, &q->sparse->components[k]);
	for (k = 0; k < j->columns; ++k)
		for (l = 0; l < k; ++l)
			j->reach[k * j->columns + l] = j->reach[l * j->columns + k];
	for (k = 0; k < j->columns; ++k)
		finite += 0.0f * j->reach[k * j->columns + k];
	return finite == 0.0f;
}

/* ---- impulses ---- */

static void row_give(pass *q, int32_t row, float impulse)
{
	int32_t columns = q->joined->columns, k;
	const float *reach = q->joined->reach + row * columns;
	for (k = 0; k < columns; k += CNI_WIDTH)
		cni_wide_store(q->speed + k, cni_wide_load(q->speed + k) + impulse * cni_wide_load(reach + k));
	q->given[row] += impulse;
}

/* 1 / reach of a row on itself, 0: nothing moves it. */
static float row_mass_find(const pass *q, int32_t row)
{
	float own = q->joined->reach[row * q->joined->columns + row], mass = q->joined->presses[row / 3].mass[row % 3];
	return own * mass > REACH_LEAST ? 1.0f / own : 0.0f;
}

/* Returns by how much speed it was wrong. */
static float point_solve(pass *q, int32_t row)
{
	cni_press *p = &q->joined->presses[row / 3];
	float wrong = q->speed[row] + q->room[row], mass = q->mass[row], old = p->j[row % 3], dj;
	if (mass == 0.0f)
		return 0.0f;
	p->j[row % 3] = cni_max(old - mass * wrong, 0.0f);
	dj = p->j[row % 3] - old;
	if (dj != 0.0f)
		row_give(q, row, dj);
	return cni_abs(dj) / mass;
}

static float friction_solve(pass *q, int32_t row)
{
	cni_press *p = &q->joined->presses[row / 3];
	float mass = q->mass[row], old = p->j[2], sum = p->j[0] + p->j[1], want, most = p->dynamic_friction * sum;
	if (mass == 0.0f)
		return 0.0f;
	want = old - mass * q->speed[row];
	p->j[2] = cni_abs(want) <= p->static_friction * sum ? want : cni_clamp(want, -most, most);
	if (p->j[2] != old)
		row_give(q, row, p->j[2] - old);
	return cni_abs(p->j[2] - old) / mass;
}

/* Would a row change its impulse by a speed that counts? */
static int32_t row_is_off(const pass *q, int32_t row, float least)
{
	const cni_press *p = &q->joined->presses[row / 3];
	float speed = q->speed[row] + q->room[row], most = p->static_friction * (p->j[0] + p->j[1]), j = p->j[row % 3];
	if (q->mass[row] == 0.0f)
		return 0;
	if (row % 3 < 2)
		return speed < -least || (speed > least && j > 0.0f);
	return cni_abs(speed) > least && (most > 0.0f || j != 0.0f);
}

static int32_t is_off(const pass *q)
{
	float least = STILL_SPEED * q->world->settings.length_unit;
	int32_t row;
	for (row = 0; row < 3 * q->joined->count; ++row)
		if (row_is_off(q, row, least))
			return 1;
	return 0;
}

static void rounds_run(pass *q)
{
	float least = SPEED_LEAST * q->world->settings.length_unit;
	int32_t round, k;
	for (round = 0; round < ROUNDS; ++round) {
		float most = 0.0f;
		for (k = 0; k < q->joined->count; ++k) {
			most = cni_max(most, point_solve(q, 3 * k));
			most = cni_max(most, point_solve(q, 3 * k + 1));
			most = cni_max(most, friction_solve(q, 3 * k + 2));
		}
		if (most <= least)
			break;
	}
}

static void levers_make(pass *q)
{
	int32_t k, i;
	memset(q->lever, 0, sizeof(cni_lever) * (size_t)q->joined->columns);
	memset(q->speed, 0, sizeof(float) * (size_t)q->joined->columns);
	for (k = 0; k < q->joined->count; ++k)
		for (i = 0; i < 3; ++i)
			if (q->joined->presses[k].mass[i] > 0.0f)
				q->lever[3 * k + i] = cni_press_lever(&q->joined->presses[k], i);
}

static void rows_begin(pass *q)
{
	int32_t k, i;
	for (k = 0; k < q->joined->count; ++k) {
		const cni_press *p = &q->joined->presses[k];
		const cni_motion *a = q->motions + p->ia, *b = q->motions + p->ib;
		for (i = 0; i < 3; ++i) {
			float s = i < 2 && p->mass[i] > 0.0f ? cni_press_separation(p, i, a, b) : 0.0f;
			q->room[3 * k + i] = s > 0.0f ? s * q->s->inv_h : q->bias ? cni_max(PUSH_RATE * q->s->inv_h * s, -q->s->push_speed) : 0.0f;
			q->speed[3 * k + i] = cni_lever_speed(&q->lever[3 * k + i], a, b);
			q->given[3 * k + i] = 0.0f;
			q->mass[3 * k + i] = row_mass_find(q, 3 * k + i);
		}
	}
}

/* Impulses of the step before. */
static void rows_warm(pass *q)
{
	int32_t k, i;
	for (k = 0; k < q->joined->count; ++k)
		for (i = 0; i < 3; ++i) {
			float *j = &q->joined->presses[k].j[i];
			*j = q->joined->presses[k].mass[i] > 0.0f ? *j * q->s->warm_scale : 0.0f;
			row_give(q, 3 * k + i, *j);
		}
	q->joined->fresh = 0;
}

/* Masses or arms that floats cannot hold together: contacts let go in this pass. 0: so it is. */
static int32_t given_is_finite(const pass *q)
{
	float finite = 0.0f; /* stays so: 0 times what is finite */
	int32_t row;
	for (row = 0; row < 3 * q->joined->count; ++row)
		finite += 0.0f * q->given[row];
	for (row = 0; row < 3 * q->joined->count && finite != 0.0f; ++row)
		q->joined->presses[row / 3].j[row % 3] = 0.0f;
	return finite == 0.0f;
}

static void given_push(const pass *q)
{
	int32_t row;
	for (row = 0; row < 3 * q->joined->count; ++row) {
		const cni_press *p = &q->joined->presses[row / 3];
		if (q->given[row] != 0.0f)
			cni_lever_push(&q->lever[row], q->given[row], q->motions + p->ia, q->motions + p->ib);
	}
}

/* ---- the pass ---- */

int32_t cni_joined_solve(cn_world *world, const cni_solve *s, cni_joined *joined, int32_t bias)
{
	pass q;
	q.world = world;
	q.s = s;
	q.sparse = s->direct;
	q.joined = joined;
	q.motions = cni_motions(world);
	q.bias = bias;
	if (joined->count == 0)
		return 0;
	levers_make(&q);
	if (joined->turned > TURN_MOST && !reach_find(&q))
		return 0;
	if (joined->turned > TURN_MOST)
		joined->turned = 0.0f;
	rows_begin(&q);
	if (joined->fresh)
		rows_warm(&q);
	else if (!is_off(&q))
		return 0;
	rounds_run(&q);
	if (!given_is_finite(&q))
		return 0;
	given_push(&q);
	return 1;
}
