/*
 * direct/friction_cones.c - contacts of a directly solved island by an interior-point method, for problems that the active set of
 * direct/direct_contacts.c cannot solve.
 *
 * The impulses l of a contact, two normals p and one friction t, lie in the cone A l >= 0:
 *
 *   p0 >= 0, p1 >= 0, m (p0 + p1) - t >= 0, m (p0 + p1) + t >= 0
 *
 * The impulses of least energy in these cones are a convex problem (Anitescu, "Optimization-based simulation of nonsmooth rigid multibody
 * dynamics", 2006): if any impulses hold the island still, its solution does. It would lift a sliding contact by m times its slip; that
 * speed is subtracted from the normal rows with the slip of the iteration before, so that the fixed point is Coulomb's law (De Saxce; Acary
 * and Cadoux, "Applications of an existence result for the Coulomb friction problem", 2013).
 *
 * With slacks s = A l and their multipliers z, each iteration is a Newton step towards s z = tau, with a decreasing tau (Wright,
 * "Primal-dual interior-point methods", 1997, chapter 5):
 *
 *   (K + A' (Z/S) A) dl = A' tau/s - w,  dz = tau/s - z - (Z/S) A dl
 *
 * K + A' (Z/S) A has the pattern of K, so the plan of the island's system serves. For a contact that slides one of the four entries of Z/S
 * is very great. The substitution u = t - g m (p0 + p1), g = (d2 - d3) / (d2 + d3), leaves no large terms in A' (Z/S) A that cancel in
 * floats: d0, d1 and 4 d2 d3 / (d2 + d3) m^2 on the normals, d2 + d3 on u.
 *
 * Among redundant sets of impulses, the solution is the analytic centre: it changes little when the island does, and needs no search for a
 * set.
 *
 * Reads direct contacts and motion velocities; writes impulses and states of direct contacts, nodes' total, motion velocities.
 */
#include "direct/direct_contact.h"
#include "direct/direct_system.h"

#include <string.h>

typedef struct cone {
	const cni_direct_contact_pass *pass;
	int32_t count;         /* number of existing slacks */
	int32_t factors, factors_most;
	float tau;
	float residual;        /* m/s: the largest residual of a row */
	float violation;       /* m/s: the largest complementarity violation */
} cone;

/* 1: the row exists: of the two normals and the friction. */
static int32_t row_exists(const cni_direct_contact *p, int32_t row)
{
	return p->mass[row] > 0.0f && (row < 2 || p->coefficient > 0.0f);
}

static int32_t slack_exists(const cni_direct_contact *p, int32_t i)
{
	return row_exists(p, i < 2 ? i : 2);
}

static void slacks_of(const cni_direct_contact *p, const float l[3], float out[4])
{
	float sum = p->coefficient * (l[0] + l[1]);
	out[0] = l[0];
	out[1] = l[1];
	out[2] = sum - l[2];
	out[3] = sum + l[2];
}

static float slack_mass(const cni_direct_contact *p, int32_t i)
{
	return p->mass[i < 2 ? i : 2];
}

/* ---- the beginning ---- */

static void rows_push(const cone *q, const cni_direct_contact *p, const float change[3])
{
	for (int32_t i = 0; i < 3; ++i)
		cni_direct_contact_push(p, i, change[i], q->pass->motions + p->ia, q->pass->motions + p->ib);
}

/* Residual speeds of the rows. */
static void speeds_of(const cone *q, const cni_direct_contact *p, float out[3])
{
	const cni_motion *a = q->pass->motions + p->ia, *b = q->pass->motions + p->ib;
	for (int32_t i = 0; i < 3; ++i)
		out[i] = row_exists(p, i) ? cni_direct_contact_speed(p, i, a, b) + (i < 2 ? p->gap_speed[i] + p->lift : 0.0f) + cni_direct_contact_leak(p, i) : 0.0f;
}

/* Starts from the impulses of the last pass. */
static void contact_warm_start(const cone *q, cni_direct_contact *p)
{
	float change[3];
	for (int32_t i = 0; i < 3; ++i) {
		p->j[i] = q->pass->sparse->nodes[p->node].carried[i];
		change[i] = p->j[i] - p->start[i];
	}
	rows_push(q, p, change);
	p->coefficient = p->state[2] == CNI_ROW_SLIDES ? p->dynamic_friction : p->static_friction;
	p->coefficient = p->coefficient > CNI_CONE_FRICTION_LEAST ? p->coefficient : 0.0f;
	p->lift = 0.0f;
}

static void warm_start(cone *q)
{
	const cni_direct_contact_pass *pass = q->pass;
	for (int32_t k = pass->c->begin; k < pass->c->end; ++k)
		memset(pass->sparse->nodes[k].total, 0, sizeof pass->sparse->nodes[k].total);
	for (cni_direct_contact *p = pass->first; p < pass->end; ++p) {
		contact_warm_start(q, p);
		for (int32_t i = 0; i < 4; ++i)
			q->count += slack_exists(p, i);
	}
}

/* Moves the impulses inside of the cones, with equal products of slacks and multipliers; the changes go into start. A separated point has
   three multipliers that must add up to its speed. */
static void contact_center(const cone *q, cni_direct_contact *p, float speed)
{
	float speeds[3], most;
	speeds_of(q, p, speeds);
	for (int32_t i = 0; i < 3; ++i)
		p->start[i] = -p->j[i];
	for (int32_t i = 0; i < 2; ++i)
		p->j[i] = row_exists(p, i) ? cni_max(p->j[i], 3.0f * q->tau * p->mass[i] / cni_max(speed, speeds[i])) : 0.0f;
	most = CNI_CONE_INSIDE_PART * p->coefficient * (p->j[0] + p->j[1]);
	p->j[2] = row_exists(p, 2) ? cni_clamp(p->j[2], -most, most) : 0.0f;
	for (int32_t i = 0; i < 3; ++i)
		p->start[i] += p->j[i];
	slacks_of(p, p->j, p->slack);
	memset(p->cross, 0, sizeof p->cross);
	for (int32_t i = 0; i < 4; ++i)
		p->dual[i] = slack_exists(p, i) ? q->tau * slack_mass(p, i) / p->slack[i] : 0.0f;
}

static void center(cone *q)
{
	float speed = q->pass->speed_least;
	for (cni_direct_contact *p = q->pass->first; p < q->pass->end; ++p) {
		float speeds[3];
		speeds_of(q, p, speeds);
		speed = cni_max(speed, cni_max(cni_max(-speeds[0], -speeds[1]), cni_abs(speeds[2])));
	}
	q->tau = speed * speed;
	for (cni_direct_contact *p = q->pass->first; p < q->pass->end; ++p)
		contact_center(q, p, speed);
	for (cni_direct_contact *p = q->pass->first; p < q->pass->end; ++p)
		rows_push(q, p, p->start);
}

/* ---- a step ---- */

static float stiffness_of(const cni_direct_contact *p, int32_t i)
{
	return slack_exists(p, i) ? cni_min(p->dual[i] / p->slack[i], CNI_CONE_STIFF_MAX / slack_mass(p, i)) : 0.0f;
}

/* Updates the residual: the rows' speeds less their multipliers; and the complementarity violation. */
static void contact_residuals(cone *q, const cni_direct_contact *p, const float speeds[3])
{
	for (int32_t i = 0; i < 2; ++i)
		q->residual = cni_max(q->residual, row_exists(p, i) ? cni_abs(speeds[i] - p->dual[i] - p->coefficient * (p->dual[2] + p->dual[3])) : 0.0f);
	q->residual = cni_max(q->residual, row_exists(p, 2) ? cni_abs(speeds[2] + p->dual[2] - p->dual[3]) : 0.0f);
	for (int32_t i = 0; i < 4; ++i)
		if (slack_exists(p, i))
			q->violation = cni_max(q->violation, cni_min(p->dual[i], p->slack[i] / slack_mass(p, i)));
}

/* Levers, diagonal and right side of a contact's Newton step. */
static void contact_newton(cone *q, cni_direct_contact *p)
{
	cni_node *n = &q->pass->sparse->nodes[p->node];
	float d2 = stiffness_of(p, 2), d3 = stiffness_of(p, 3), speeds[3], push[4], both, lift;
	cni_lever friction = cni_direct_contact_lever(p, 2);
	speeds_of(q, p, speeds);
	contact_residuals(q, p, speeds);
	for (int32_t i = 0; i < 4; ++i)
		push[i] = slack_exists(p, i) ? (q->tau * slack_mass(p, i) - p->cross[i]) / p->slack[i] : 0.0f;
	lift = p->coefficient * (push[2] + push[3]);
	p->slope = d2 + d3 > 0.0f ? p->coefficient * (d2 - d3) / (d2 + d3) : 0.0f;
	both = d2 + d3 > 0.0f ? p->coefficient * p->coefficient * 4.0f * d2 * (d3 / (d2 + d3)) : 0.0f;
	memset(&n->levers, 0, sizeof n->levers);
	n->x[2] = row_exists(p, 2) ? push[3] - push[2] - speeds[2] : 0.0f;
	n->compliance[2] = d2 + d3;
	for (int32_t i = 0; i < 2; ++i) {
		n->x[i] = row_exists(p, i) ? push[i] + lift - speeds[i] + p->slope * n->x[2] : 0.0f;
		n->compliance[i] = row_exists(p, i) ? stiffness_of(p, i) + both : 0.0f;
		if (row_exists(p, i)) {
			cni_lever l = cni_direct_contact_lever(p, i);
			if (row_exists(p, 2))
				cni_lever_add(&l, p->slope, &friction);
			cni_levers_set(&n->levers, i, l);
		}
	}
	n->cross = row_exists(p, 1) ? both : 0.0f;
	if (row_exists(p, 2))
		cni_levers_set(&n->levers, 2, friction);
}

static void joint_newton(const cone *q, cni_node *n)
{
	const cni_row *rows = cni_joint_constraints(q->pass->world)[n->owner].rows;
	float rate = q->pass->bias ? q->pass->s->joint_error_rate : 0.0f;
	float speed[CNI_NODE_LANES];
	cni_four_store(speed, cni_levers_speed(&n->levers, q->pass->motions + n->ia, q->pass->motions + n->ib));
	for (int32_t i = 0; i < CNI_NODE_ROWS; ++i)
		n->x[i] = -speed[i] - (i < n->rows ? rate * rows[i].error : 0.0f);
}

/* Changes of slack and multiplier by a whole step. */
static void changes_of(const cone *q, const cni_direct_contact *p, const cni_node *n, float slack[4], float dual[4])
{
	slacks_of(p, n->x, slack);
	for (int32_t i = 0; i < 4; ++i)
		dual[i] = slack_exists(p, i) ? (q->tau * slack_mass(p, i) - p->cross[i]) / p->slack[i] - stiffness_of(p, i) * slack[i] - p->dual[i] : 0.0f;
}

static float distance_to(float from, float change)
{
	return change < 0.0f ? -from / change : FLT_MAX;
}

/* Step length. */
static float step_length(const cone *q)
{
	float most = FLT_MAX;
	for (const cni_direct_contact *p = q->pass->first; p < q->pass->end; ++p) {
		cni_node *n = &q->pass->sparse->nodes[p->node];
		float slack[4], dual[4];
		n->x[2] += p->slope * (n->x[0] + n->x[1]);
		changes_of(q, p, n, slack, dual);
		for (int32_t i = 0; i < 4; ++i)
			if (slack_exists(p, i))
				most = cni_min(most, cni_min(distance_to(p->slack[i], slack[i]), distance_to(p->dual[i], dual[i])));
	}
	return cni_min(1.0f, CNI_CONE_STEP_PART * most);
}

/* Applies the step. Returns the mean of slack times multiplier after it. */
static float step_apply(const cone *q, float length)
{
	float sum = 0.0f;
	for (int32_t k = q->pass->c->begin; k < q->pass->c->end; ++k) {
		cni_node *n = &q->pass->sparse->nodes[k];
		cni_direct_contact *p = cni_direct_contact_of(q->pass->sparse, n);
		float slack[4], dual[4];
		if (p != NULL)
			changes_of(q, p, n, slack, dual);
		for (int32_t i = 0; i < CNI_NODE_ROWS; ++i)
			n->x[i] *= length;
		if (p == NULL) {
			for (int32_t i = 0; i < CNI_NODE_ROWS; ++i)
				n->total[i] += n->x[i];
			cni_levers_push(&n->levers, n->x, q->pass->motions + n->ia, q->pass->motions + n->ib, CNI_NODE_ROWS);
			continue;
		}
		rows_push(q, p, n->x);
		for (int32_t i = 0; i < 3; ++i)
			p->j[i] += n->x[i];
		for (int32_t i = 0; i < 4; ++i) {
			p->slack[i] += length * slack[i];
			p->dual[i] += length * dual[i];
			p->cross[i] = 0.0f;
			sum += slack_exists(p, i) ? p->slack[i] * p->dual[i] / slack_mass(p, i) : 0.0f;
		}
	}
	return sum / (float)cni_max_i(q->count, 1);
}

/* Stores the second-order terms of the predictor step in `cross`, for the right sides that follow. Returns the mean of slack times
   multiplier that the predictor would reach. */
static float predictor_store(cone *q, float length)
{
	float sum = 0.0f;
	for (cni_direct_contact *p = q->pass->first; p < q->pass->end; ++p) {
		float slack[4], dual[4];
		changes_of(q, p, &q->pass->sparse->nodes[p->node], slack, dual);
		for (int32_t i = 0; i < 4; ++i) {
			p->cross[i] = slack[i] * dual[i];
			sum += slack_exists(p, i) ? (p->slack[i] + length * slack[i]) * (p->dual[i] + length * dual[i]) / slack_mass(p, i) : 0.0f;
		}
	}
	return sum / (float)cni_max_i(q->count, 1);
}

static void newton_set(cone *q)
{
	const cni_direct_contact_pass *pass = q->pass;
	q->residual = q->violation = 0.0f;
	for (cni_direct_contact *p = pass->first; p < pass->end; ++p)
		contact_newton(q, p);
	for (int32_t k = pass->c->begin; k < pass->c->end && pass->c->joints > 0; ++k)
		if (pass->sparse->nodes[k].owner >= 0)
			joint_newton(q, &pass->sparse->nodes[k]);
}

/* ---- the end ---- */

/* Sets the states for the set that the next pass begins with. Open rows get no impulse. */
static void contact_finish(const cone *q, cni_direct_contact *p)
{
	cni_node *n = &q->pass->sparse->nodes[p->node];
	float change[3] = { 0.0f, 0.0f, 0.0f };
	int32_t i;
	for (i = 0; i < 2; ++i) {
		p->state[i] = row_exists(p, i) && p->slack[i] > p->dual[i] * p->mass[i] ? CNI_ROW_ACTIVE : CNI_ROW_OPEN;
		change[i] = p->state[i] == CNI_ROW_OPEN ? -p->j[i] : 0.0f;
	}
	p->slide_sign = p->slack[2] < p->slack[3] ? 1.0f : -1.0f;
	i = p->slide_sign > 0.0f ? 2 : 3;
	p->state[2] = row_exists(p, 2) && p->dual[i] > q->pass->speed_least && p->slack[i] < p->dual[i] * p->mass[2] ? CNI_ROW_SLIDES : CNI_ROW_ACTIVE;
	if (p->state[0] != CNI_ROW_ACTIVE && p->state[1] != CNI_ROW_ACTIVE) {
		p->state[2] = CNI_ROW_OPEN;
		change[2] = -p->j[2];
	}
	rows_push(q, p, change);
	for (i = 0; i < 3; ++i)
		p->j[i] += change[i];
	memset(&n->levers, 0, sizeof n->levers);
	memset(n->compliance, 0, sizeof n->compliance);
	n->cross = 0.0f;
	n->active = 0;
}

static int32_t iterate(cone *q)
{
	float mean = q->tau;
	for (;;) {
		q->tau = 0.0f;
		newton_set(q);
		if (q->residual <= q->pass->speed_least && q->violation <= q->pass->speed_least)
			return 1;
		if (q->factors == q->factors_most)
			return 0;
		++q->factors;
		cni_sparse_factor(q->pass->sparse, q->pass->c, q->pass->motions);
		if (!cni_sparse_solve(q->pass->sparse, q->pass->c))
			return 0;
		float length = step_length(q);
		float predicted = predictor_store(q, length);
		float part = predicted / mean;
		q->tau = cni_max(mean * part * part * part, cni_sq(CNI_CONE_PATH_SPEED * cni_max(q->residual, q->pass->speed_least)));
		newton_set(q);
		if (!cni_sparse_solve(q->pass->sparse, q->pass->c))
			return 0;
		length = step_length(q);
		mean = step_apply(q, length);
	}
}

/* Updates lift speeds and dynamic friction from the slips, for the next round. Returns the largest change of lift. */
static float slips_find(const cone *q)
{
	float most = 0.0f;
	for (cni_direct_contact *p = q->pass->first; p < q->pass->end; ++p) {
		if (p->coefficient == 0.0f)
			continue;
		float slip = cni_abs(p->dual[2] - p->dual[3]);
		float was = p->lift;
		if (slip > q->pass->speed_least && p->dynamic_friction < p->coefficient) {
			p->coefficient = cni_max(p->dynamic_friction, CNI_CONE_FRICTION_LEAST);
			most = FLT_MAX;
		}
		p->lift = p->coefficient * slip;
		most = cni_max(most, cni_abs(p->lift - was));
	}
	return most;
}

static int32_t factors_most(const cni_direct_contact_pass *pass)
{
	const cn_world *world = pass->world;
	int32_t credit = cni_max_i(CNI_CONE_DEBT - cni_cone_debt(world, pass->island), 0) * (pass->c->end - pass->c->begin);
	int32_t most = CNI_CONE_FACTORS_MAX, work = cni_min_i(CNI_ATTEMPT_PASS_WORK, credit);
	if (world->settings.solver == CN_SOLVER_DIRECT) {
		most = CNI_CONE_FACTORS_DIRECT;
		work = cni_attempt_work_most(world, pass->c) - world->cone_work - world->set_work;
	}
	return cni_max_i(cni_min_i(most, work / cni_cone_factor_work(pass->c)), CNI_CONE_FACTORS_LEAST);
}

int32_t cni_direct_contacts_cone(const cni_direct_contact_pass *pass, int32_t *out_factors)
{
	cone q = { pass, 0, 0, factors_most(pass), 0.0f, 0.0f, 0.0f };
	int32_t good = 1;
	float change = FLT_MAX;
	pass->c->regular = CNI_REGULARIZATION_CONTACTS;
	warm_start(&q);
	for (int32_t round = 0; good && round < CNI_CONE_SLIP_ROUNDS && change > CNI_CONE_SLIP_CLOSE * pass->speed_least; ++round) {
		center(&q);
		good = iterate(&q);
		change = slips_find(&q);
	}
	for (cni_direct_contact *p = pass->first; p < pass->end; ++p)
		contact_finish(&q, p);
	pass->c->factored = 0;
	*out_factors = q.factors;
	return good;
}
