/*
 * direct/rattle_energy.c - the energy of bodies that only joints constrain: the gain of a step beyond the work of external accelerations
 * and moving bases, and the removal of the part beyond the scheme's own error (direct/rattle.c).
 *
 * Reads motion, start, externals, joint constraints; writes motion velocities and the account.
 */
#include "direct/rattle.h"

float cni_rattle_closing_speed(const rattle_step *g)
{
	float most = 0.0f;
	for (int32_t k = g->c->begin; k < g->c->end; ++k)
		for (int32_t i = 0; i < g->sparse->nodes[k].rows; ++i) {
			const cni_row *r = &constraint_of(g, k)->rows[i];
			most = cni_max(most, cni_abs(r->error) * cni_row_length(g->world, r));
		}
	return most > CNI_RATTLE_OLD_GAP * g->closed ? CNI_RATTLE_CLOSING_RATE * most / g->h : 0.0f;
}

rattle_energies cni_rattle_energies(const rattle_step *g, float dt)
{
	rattle_energies e = { 0.0f, 0.0f, 0.0f, 0.0f };
	for (int32_t k = g->c->body_begin; k < g->c->body_end; ++k) {
		const cni_motion *m = g->motions + g->sparse->bodies[k];
		const cni_external *d = cni_externals(g->world) + g->sparse->bodies[k];
		const cni_body *b = cni_body_at(g->world, cni_awake_ids(g->world)[g->sparse->bodies[k]]);
		float mass = cni_inverse_or_zero(m->inv_mass), inertia = cni_inverse_or_zero(m->inv_inertia);
		float way = 4.0f * g->closed + 4.0f * FLT_EPSILON * (cni_abs(b->cx) + cni_abs(b->cy) + b->extent);
		e.kinetic += cni_energy_twice(m, m->vx, m->vy, m->w);
		e.total += mass * (0.5f * (m->vx * m->vx + m->vy * m->vy) - (d->ax * m->dpx + d->ay * m->dpy)) +
		           inertia * (0.5f * m->w * m->w - d->alpha * m->theta);
		e.allowed += 0.5f * mass * (dt * dt * (d->ax * d->ax + d->ay * d->ay) + g->closing * g->closing) +
		             0.5f * inertia * dt * dt * d->alpha * d->alpha;
		e.rounding += mass * way * (cni_abs(d->ax) + cni_abs(d->ay));
	}
	e.kinetic *= 0.5f;
	return e;
}

/*
 * Velocities and positions of the method are those of a motion that conserves T + V + h^2 (sum m a.a / 24 - sum m g.a / 12), to the fourth
 * order of h (backward analysis of the Stoermer-Verlet scheme: Hairer, Lubich and Wanner, "Geometric Numerical Integration", 2006, IX.3,
 * with the joints' forces among the accelerations a). The bound is six times the first term. start: velocities before the last substep, set
 * by last_substep_begins.
 */
float cni_rattle_energy_error(const rattle_step *g, const cni_solve *s)
{
	float sum = 0.0f, last = cni_max(1.0f, s->warm_scale > 0.0f ? 1.0f / s->warm_scale : 1.0f); /* the account was filled at the last step's h */
	for (int32_t k = g->c->body_begin; k < g->c->body_end; ++k) {
		int32_t index = g->sparse->bodies[k];
		const cni_motion *m = g->motions + index;
		const cni_external *d = cni_externals(g->world) + index;
		const cni_velocity_start *start = cni_starts(g->world) + index;
		sum += cni_energy_twice(m, m->vx - start->vx + s->h * d->ax, m->vy - start->vy + s->h * d->ay, m->w - start->w + s->h * d->alpha);
	}
	return sum * last * last / 4.0f;
}

/* In a substep J v = 0, so the row's power on bodies with mass is minus that of the massless ones. */
float cni_rattle_base_work(const rattle_step *g)
{
	float work = 0.0f;
	for (int32_t k = g->c->begin; k < g->c->end; ++k) {
		const cni_node *n = &g->sparse->nodes[k];
		float speed[CNI_NODE_LANES];
		cni_four_store(speed, cni_node_base_speed(n, g->motions));
		for (int32_t i = 0; i < n->rows; ++i)
			work -= n->total[i] * speed[i];
	}
	return work;
}

typedef struct rigid_motion {
	float mass, inertia;
	float x, y, vx, vy, w;
	int32_t fixed;     /* 1: a joint ends at a body without mass: no rigid motion is subtracted */
} rigid_motion;

static cni_vec2 place_of(const rattle_step *g, int32_t index)
{
	const cni_body *b = cni_body_at(g->world, cni_awake_ids(g->world)[index]);
	return cni_v(b->cx + g->motions[index].dpx, b->cy + g->motions[index].dpy);
}

/* The motion of one rigid body with the component's momenta; a body that does not turn keeps it from turning. */
static rigid_motion rigid_of(const rattle_step *g)
{
	rigid_motion r = { 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, g->held };
	float spin = 0.0f;
	int32_t turns = 1;
	for (int32_t k = g->c->body_begin; k < g->c->body_end && !r.fixed; ++k) {
		const cni_motion *m = g->motions + g->sparse->bodies[k];
		float mass = cni_inverse_or_zero(m->inv_mass);
		cni_vec2 p = place_of(g, g->sparse->bodies[k]);
		r.mass += mass;
		r.x += mass * p.x;
		r.y += mass * p.y;
		r.vx += mass * m->vx;
		r.vy += mass * m->vy;
	}
	if (r.fixed || r.mass == 0.0f)
		return r;
	r.x /= r.mass;
	r.y /= r.mass;
	r.vx /= r.mass;
	r.vy /= r.mass;
	for (int32_t k = g->c->body_begin; k < g->c->body_end; ++k) {
		const cni_motion *m = g->motions + g->sparse->bodies[k];
		float mass = cni_inverse_or_zero(m->inv_mass), inertia = cni_inverse_or_zero(m->inv_inertia);
		cni_vec2 p = place_of(g, g->sparse->bodies[k]);
		float x = p.x - r.x, y = p.y - r.y;
		turns &= m->inv_inertia > 0.0f;
		spin += mass * (x * (m->vy - r.vy) - y * (m->vx - r.vx)) + inertia * m->w;
		r.inertia += mass * (x * x + y * y) + inertia;
	}
	r.w = turns && r.inertia > 0.0f ? spin / r.inertia : 0.0f;
	return r;
}

static cni_velocity_start velocity_in(const rattle_step *g, const rigid_motion *r, int32_t index)
{
	cni_velocity_start v = { 0.0f, 0.0f, 0.0f, 0.0f };
	if (r->fixed)
		return v;
	cni_vec2 p = place_of(g, index);
	v.vx = r->vx - r->w * (p.y - r->y);
	v.vy = r->vy + r->w * (p.x - r->x);
	v.w = r->w;
	return v;
}

/* Kinetic energy relative to the rigid motion. */
static float inner_energy(const rattle_step *g, const rigid_motion *r)
{
	float sum = 0.0f;
	for (int32_t k = g->c->body_begin; k < g->c->body_end; ++k) {
		const cni_motion *m = g->motions + g->sparse->bodies[k];
		cni_velocity_start v = velocity_in(g, r, g->sparse->bodies[k]);
		sum += cni_energy_twice(m, m->vx - v.vx, m->vy - v.vy, m->w - v.w);
	}
	return 0.5f * sum;
}

/*
 * Takes this energy out of the component's motion, but at most CNI_RATTLE_ENERGY_PART of it. All velocities relative to the rigid motion
 * of equal momenta are scaled by one factor, which preserves the momenta and J v = 0. Returns the energy removed.
 */
static float energy_remove(const rattle_step *g, float surplus)
{
	rigid_motion r = rigid_of(g);
	float inner = inner_energy(g, &r), part, keep;
	if (!(inner > 0.0f && inner < FLT_MAX))
		return 0.0f;
	part = cni_min(surplus / inner, CNI_RATTLE_ENERGY_PART);
	keep = cni_sqrt(1.0f - part);
	for (int32_t k = g->c->body_begin; k < g->c->body_end; ++k) {
		cni_motion *m = g->motions + g->sparse->bodies[k];
		cni_velocity_start v = velocity_in(g, &r, g->sparse->bodies[k]);
		m->vx = v.vx + keep * (m->vx - v.vx);
		m->vy = v.vy + keep * (m->vy - v.vy);
		m->w = v.w + keep * (m->w - v.w);
	}
	return part * inner;
}

/* Adds the energy gain of a step to the account and takes the excess out of the motion. A step that closed old gaps adds nothing: closing
   moved the bodies, so the gain is not of their motion. */
void cni_rattle_account(const rattle_step *g, const rattle_energies *e, cni_joint_trust *t, float gained)
{
	float most = g->energy_error + CNI_RATTLE_ENERGY_ROUNDING * e->kinetic + e->rounding;
	t->surplus = cni_max(t->surplus + (g->closing > 0.0f ? 0.0f : gained), -most);
	if (!(t->surplus < FLT_MAX)) /* an account that is not finite begins anew */
		t->surplus = 0.0f;
	if (t->surplus > most)
		t->surplus -= energy_remove(g, t->surplus - most);
}
