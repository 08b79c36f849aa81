/*
 * step/sequential.c - the sequential solver: the twelve steps of the paper "Custom 2D Physics Library", in its order, over the
 * same tables, narrowphase and events as the soft step. One pass a step, no warm start, no substeps. It is the baseline of the
 * accuracy charts. step.c calls the steps by their numbers.
 *
 * Beyond the paper, the continuous collision of the soft step guards the moves of 2 and 8, and bodies that 8 pushed deep into static ones
 * come out again: neighbours would push bodies through the ground.
 *
 * Its weaknesses are known and kept, so that they can be measured: it solves each contact once and alone, so a load does not
 * pass through a stack in one step (stacks sink and creep), and joints stretch under load.
 *
 * Reads and writes the same data as the stages of the soft step: motion, bodies, lanes (through the narrowphase).
 */
#include "step/stages.h"
#include "narrowphase/narrowphase.h"
#include "joints/joints.h"

/* ---- 1, 2: motion ---- */

void cni_sequential_hold_locked(cn_world *world)
{
	for (int32_t k = 1; k < world->awake_count; ++k) {
		const cni_body *b = cni_body_at(world, cni_awake_ids(world)[k]);
		cni_motion *m = cni_motions(world) + k;
		if (b->flags & CN_BODY_LOCK_X)
			m->vx = m->dpx = cni_starts(world)[k].vx = 0.0f;
		if (b->flags & CN_BODY_LOCK_Y)
			m->vy = m->dpy = cni_starts(world)[k].vy = 0.0f;
	}
}

void cni_sequential_velocities(cn_world *world, const cni_solve *s)
{
	cni_motion *motions = cni_motions(world);
	cni_external_prepare_bound(world, s->dt);
	for (int32_t k = 1; k < world->awake_count; ++k) {
		const cni_body *b = cni_body_at(world, cni_awake_ids(world)[k]);
		const cni_external *d = cni_externals(world) + k;
		cni_velocity_start *start = cni_starts(world) + k;
		cni_motion *m = &motions[k];
		float linear = 1.0f, angular = 1.0f;
		if (b->type == CN_BODY_DYNAMIC) {
			linear = cni_damping_factor(b->linear_damping, s->dt);
			angular = cni_damping_factor(b->angular_damping, s->dt);
		}
		m->vx = linear * (m->vx + s->dt * d->ax);
		m->vy = linear * (m->vy + s->dt * d->ay);
		m->w = angular * (m->w + s->dt * d->alpha);
		start->vx = m->vx;
		start->vy = m->vy;
		start->w = m->w;
		start->jumped = 0.0f;
	}
	cni_sequential_hold_locked(world);
}

/* Neither the motion nor what pushes overlaps apart takes a body through static ones. */
void cni_sequential_guard(cn_world *world)
{
	if (CNI_HAS_CONTINUOUS && (world->settings.flags & CN_WORLD_CONTINUOUS))
		cni_stage_continuous(world);
}

void cni_sequential_positions(cn_world *world, const cni_solve *s)
{
	cni_motion *motions = cni_motions(world);
	for (int32_t k = 1; k < world->awake_count; ++k) {
		motions[k].dpx = s->dt * motions[k].vx;
		motions[k].dpy = s->dt * motions[k].vy;
		motions[k].theta = s->dt * motions[k].w;
	}
	cni_moves_clamp(world, s); /* gravity times its scale may overflow, and so may the sum of many far ways */
	cni_sequential_guard(world);
	cni_poses_take(world);
}

/* ---- 7: velocity response ---- */

typedef struct contact_point {
	cni_motion *a, *b;
	float nx, ny;         /* n, and t = (ny, -nx) */
	float at, bt, an, bn; /* lever arms of the point along t and n */
} contact_point;

static float normal_speed(const contact_point *c)
{
	return c->nx * (c->b->vx - c->a->vx) + c->ny * (c->b->vy - c->a->vy) + c->b->w * c->bt - c->a->w * c->at;
}

static float tangent_speed(const contact_point *c)
{
	return c->ny * (c->b->vx - c->a->vx) - c->nx * (c->b->vy - c->a->vy) - c->b->w * c->bn + c->a->w * c->an;
}

static void impulse_apply(contact_point *c, float jn, float jt)
{
	float px = jn * c->nx + jt * c->ny, py = jn * c->ny - jt * c->nx;
	c->a->vx -= c->a->inv_mass * px;
	c->a->vy -= c->a->inv_mass * py;
	c->a->w -= c->a->inv_inertia * (c->at * jn - c->an * jt);
	c->b->vx += c->b->inv_mass * px;
	c->b->vy += c->b->inv_mass * py;
	c->b->w += c->b->inv_inertia * (c->bt * jn - c->bn * jt);
}

/* Restitution along the normal, then friction bounded by the normal impulse: static, and dynamic beyond its bound. */
static void point_respond(contact_point *c, float restitution, float static_friction, float dynamic_friction, float *out_jn, float *out_jt)
{
	float mass = c->a->inv_mass + c->b->inv_mass, vn = normal_speed(c), kn, kt, jt;
	*out_jn = *out_jt = 0.0f;
	if (vn >= 0.0f)
		return;
	kn = mass + c->a->inv_inertia * c->at * c->at + c->b->inv_inertia * c->bt * c->bt;
	*out_jn = -(1.0f + restitution) * vn / kn;
	impulse_apply(c, *out_jn, 0.0f);
	kt = mass + c->a->inv_inertia * c->an * c->an + c->b->inv_inertia * c->bn * c->bn;
	jt = -tangent_speed(c) / kt;
	if (cni_abs(jt) > static_friction * *out_jn)
		jt = cni_clamp(jt, -dynamic_friction * *out_jn, dynamic_friction * *out_jn);
	*out_jt = jt;
	impulse_apply(c, 0.0f, jt);
}

/* Computes one impulse at the middle of the contact points and divides it equally among them. */
static void lane_respond(cn_world *world, int32_t slot, float threshold)
{
	cni_contact_block *k = cni_block_at(world, slot / CNI_LANES);
	int32_t l = slot % CNI_LANES, points = 0;
	float restitution = cni_block_info_at(world, slot / CNI_LANES)->restitution[l], at = 0.0f, jn;
	int32_t on[2];
	contact_point c;
	for (int32_t p = 0; p < 2; ++p) {
		k->p[p].jn[l] = 0.0f;
		on[p] = k->p[p].nm[l] > 0.0f && k->p[p].s0[l] <= 0.0f;
		at += on[p] ? k->p[p].at[l] : 0.0f;
		points += on[p];
	}
	k->jt[l] = 0.0f;
	if (points == 0)
		return;
	c.a = cni_motions(world) + k->ia[l];
	c.b = cni_motions(world) + k->ib[l];
	c.nx = k->nx[l];
	c.ny = k->ny[l];
	c.at = at / (float)points;
	c.bt = c.at - k->dt[l];
	c.an = k->fa[l];
	c.bn = k->fb[l];
	if (normal_speed(&c) > -threshold)
		restitution = 0.0f;
	point_respond(&c, restitution, k->static_friction[l], k->dynamic_friction[l], &jn, &k->jt[l]);
	for (int32_t p = 0; p < 2; ++p)
		k->p[p].jn[l] = on[p] ? jn / (float)points : 0.0f;
}

/* Visits all lanes in the order of their contacts: the oldest, which are often the lowest of a pile, come first. */
static void lanes_run(cn_world *world, void (*run)(cn_world *world, int32_t slot, float threshold), float threshold)
{
	for (int32_t k = 0; k < world->contact_used; ++k) {
		const cni_contact *c = cni_contact_at(world, k);
		if (cni_contact_has_lane(c))
			run(world, c->slot, threshold);
	}
}

void cni_sequential_velocity_response(cn_world *world, const cni_solve *s)
{
	lanes_run(world, lane_respond, s->restitution_threshold);
}

/* ---- 8: position response ---- */

/* Overlap after the moves so far. */
static float lane_depth(const cn_world *world, int32_t slot)
{
	const cni_contact_block *k = cni_block_at(world, slot / CNI_LANES);
	int32_t l = slot % CNI_LANES;
	const cni_motion *a = cni_motions(world) + k->ia[l], *b = cni_motions(world) + k->ib[l];
	float deepest = cni_min(k->p[0].nm[l] > 0.0f ? k->p[0].s0[l] : 0.0f, k->p[1].nm[l] > 0.0f ? k->p[1].s0[l] : 0.0f);
	float moved = (b->dpx - a->dpx) * k->nx[l] + (b->dpy - a->dpy) * k->ny[l];
	return -(deepest + moved);
}

/* Moves bodies that overlap by more than least out of the overlap along the normal: half each for two dynamic bodies, the whole for one. */
static void lane_separate(cn_world *world, int32_t slot, float least)
{
	const cni_contact_block *k = cni_block_at(world, slot / CNI_LANES);
	int32_t l = slot % CNI_LANES;
	cni_motion *a = cni_motions(world) + k->ia[l], *b = cni_motions(world) + k->ib[l];
	float depth = lane_depth(world, slot), share = b->inv_mass > 0.0f && a->inv_mass > 0.0f ? 0.5f : 1.0f;
	if (depth <= least)
		return;
	if (a->inv_mass > 0.0f) {
		a->dpx -= share * depth * k->nx[l];
		a->dpy -= share * depth * k->ny[l];
	}
	if (b->inv_mass > 0.0f) {
		b->dpx += share * depth * k->nx[l];
		b->dpy += share * depth * k->ny[l];
	}
}

/* No neighbour has the last word over what is static: bodies that were pushed deep into it come out again. Others may give way, as in the
   paper. */
static void lane_hold(cn_world *world, int32_t slot, float unused)
{
	const cni_contact_block *k = cni_block_at(world, slot / CNI_LANES);
	int32_t l = slot % CNI_LANES;
	(void)unused;
	if (k->ib[l] == 0)
		lane_separate(world, slot, CNI_CORE_NEAR_PART * cni_body_at(world, cni_awake_ids(world)[k->ia[l]])->core);
}

void cni_sequential_position_response(cn_world *world)
{
	lanes_run(world, lane_separate, 0.0f);
	lanes_run(world, lane_hold, 0.0f);
}

/* ---- 3, 9: constraints and joints ---- */

/* The records of the others keep their impulses, so both reactions can be read after the step. */
void cni_sequential_joints(cn_world *world, const cni_solve *s, int32_t constraints)
{
	cni_joints_prepare(world, s);
	cni_joints_solve_fresh(world, s, constraints);
	cni_joints_store(world, s);
}
