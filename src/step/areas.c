/*
 * step/areas.c - what areas do to the bodies in them: gravity, damping, buoyancy, drag and lift become one acceleration for the step.
 *
 * For each body the areas act in their order. Gravity, and damping where there is no medium, act on bodies whose centre of mass is in the
 * area, the medium on the parts of shapes in it. An area with CN_AREA_REPLACE that has the centre discards what came before.
 *
 * Fields are evaluated in the middle of the step, at the pose after half of it: x' = x + dt (v + v') / 2, v' = v + dt a(x + dt v / 2) is
 * the leapfrog scheme (drift, kick, drift), so orbits and floating bodies keep their energy. Damping and the medium's resistance are
 * implicit (geometry/medium.h), with gravity and the user's forces in the same equation, so that terminal speeds are exact.
 *
 * Reads areas, contacts of their shapes, bodies, motion, and forces in external; writes the acceleration to start, which is free until
 * the first substep, and marks the body in external.
 */
#include "step/stages.h"
#include "base/sort.h"
#include "geometry/medium.h"

#include <string.h>

/* key: dense index of the body << 40 | area << 20 | shape of the body */
typedef struct visits {
	cn_world *world;
	uint64_t *keys;   /* NULL: count only */
	int32_t count;
	float dt;
} visits;

static int32_t visit_body(uint64_t key) { return (int32_t)(key >> 40); }
static const cni_area *visit_area(const visits *v, int32_t k) { return cni_areas(v->world) + (v->keys[k] >> 20 & 0xFFFFFu); }
static int32_t visit_shape(uint64_t key) { return (int32_t)(key & 0xFFFFFu); }

static void visits_of_area(visits *v, int32_t area)
{
	cn_world *world = v->world;
	int32_t shape = cni_areas(world)[area].shape;
	for (int32_t key = cni_contact_first_of_shape(world, shape); key != CNI_NONE; key = cni_contact_next_of_shape(world, key, shape)) {
		const cni_contact *c = cni_contact_of_key(world, key);
		const cni_body *b = cni_body_at(world, c->body[1 - (key & 1)]);
		if (!(c->flags & CNI_CONTACT_SENSING) || b->type != CN_BODY_DYNAMIC || b->awake == 0)
			continue;
		if (v->keys != NULL)
			v->keys[v->count] = (uint64_t)(uint32_t)b->awake << 40 | (uint64_t)(uint32_t)area << 20 | (uint32_t)cni_proxy_at(world, c->proxy[1 - (key & 1)])->shape;
		++v->count;
	}
}

static void visits_find(visits *v, uint64_t *keys)
{
	v->keys = keys;
	v->count = 0;
	for (int32_t k = 0; k < v->world->areas.count; ++k)
		visits_of_area(v, k);
}

/* ---- one body in one area, in the middle of the step ---- */

typedef struct place {
	const cni_geometry *geometry; /* of the area */
	const cni_body *sensor;
	cni_vec2 center;              /* of the body, in the frame of the sensor's body */
	cni_vec2 velocity;            /* of the sensor's material there */
} place;

static place place_make(const visits *v, const cni_body *b, const cni_motion *m, const cni_area *a)
{
	const cn_world *world = v->world;
	const cni_shape *s = cni_shape_at(world, a->shape);
	place p;
	p.sensor = cni_body_at(world, s->body);
	p.geometry = cni_shape_geometry(&world->blocks, s);
	cn_velocity carry = cni_body_velocity(world, p.sensor);
	cni_vec2 between = cni_body_a_to_b(p.sensor, b);
	p.velocity = cni_madd(carry.linear_mps, carry.angular_radps, cni_left_perp(between));
	between = cni_madd(between, 0.5f * v->dt, cni_sub(cni_v(m->vx, m->vy), p.velocity));
	p.center = cni_add(cni_unrotate(p.sensor->q, between), p.sensor->local_center);
	return p;
}

/* Towards a point: g r / R within the distance R, as in a homogeneous ball, g (R / r)^2 outside; R = 0: g. */
static cni_vec2 pull_at(const cni_area *a, const place *p)
{
	cni_vec2 to = cni_rotate(p->sensor->q, cni_sub(a->def.center_m, p->center));
	float r = cni_length(to), R = a->def.pull_distance_m;
	if (r == 0.0f)
		return to;
	if (R == 0.0f)
		return cni_mul(a->def.pull_mps2 / r, to);
	return cni_mul(r <= R ? a->def.pull_mps2 / R : a->def.pull_mps2 * (R / r) * (R / r) / r, to);
}

/* ---- one body ---- */

typedef struct field {
	cni_vec2 gravity;
	cni_medium_force force;
	int32_t first;     /* visit of the last area that replaces the earlier ones, or the first visit */
} field;

/* Damping towards the velocity of the medium. */
static void damping_add(cni_medium_force *f, const cni_body *b, const cni_motion *m, const cni_area *a, cni_vec2 flow)
{
	float linear = b->mass * a->def.linear_damping_per_s, angular = b->inertia * a->def.angular_damping_per_s;
	f->drag[0] += linear * (flow.x - m->vx);
	f->drag[1] += linear * (flow.y - m->vy);
	f->drag[2] -= angular * m->w;
	f->resist[0][0] += linear;
	f->resist[1][1] += linear;
	f->resist[2][2] += angular;
}

/* Gravity, and damping without a medium: areas that have the centre. */
static void field_of_center(field *f, const visits *v, int32_t begin, int32_t end, const cni_body *b, const cni_motion *m)
{
	f->first = begin;
	f->gravity = v->world->settings.gravity;
	memset(&f->force, 0, sizeof f->force);
	for (int32_t k = begin; k < end; ++k) {
		const cni_area *a = visit_area(v, k);
		if (k > begin && v->keys[k] >> 20 == v->keys[k - 1] >> 20)
			continue; /* the same area */
		place p = place_make(v, b, m, a);
		if (!cni_geometry_contains(p.geometry, p.center))
			continue;
		if (a->def.flags & CN_AREA_REPLACE) {
			f->gravity = cni_v(0.0f, 0.0f);
			memset(&f->force, 0, sizeof f->force);
			f->first = k;
		}
		f->gravity = cni_add(f->gravity, cni_add(a->def.gravity_mps2, pull_at(a, &p)));
		if (a->def.density_kgpm2 == 0.0f)
			damping_add(&f->force, b, m, a, cni_add(p.velocity, a->def.flow_mps));
	}
}

static cni_vec2 up_of(const field *f)
{
	float g = cni_length(f->gravity);
	return g > 0.0f ? cni_mul(-1.0f / g, f->gravity) : cni_v(0.0f, 1.0f);
}

static void medium_of_area(field *f, const visits *v, int32_t k, cni_in_medium *in, const cni_body *b, const cni_motion *m)
{
	const cni_area *a = visit_area(v, k);
	place p = place_make(v, b, m, a);
	cni_medium medium;
	cni_medium_region region;
	medium.up = up_of(f);
	medium.buoyancy = a->def.density_kgpm2 * cni_length(f->gravity);
	medium.drag = a->def.drag_kgpm2;
	medium.lift = a->def.lift_kgpm2;
	medium.damping = a->def.density_kgpm2 * a->def.linear_damping_per_s;
	medium.turn_damping = a->def.density_kgpm2 * a->def.angular_damping_per_s * b->inertia / b->mass;
	medium.flow = cni_add(p.velocity, a->def.flow_mps);
	in->geometry = cni_shape_geometry(&v->world->blocks, cni_shape_at(v->world, visit_shape(v->keys[k])));
	cni_medium_region_make(&region, p.geometry, p.center, p.sensor->q);
	cni_medium_add(&f->force, &medium, &region, in);
}

/* The medium: parts of shapes. A shape of several edges has several equal keys. */
static void field_of_parts(field *f, const visits *v, int32_t end, const cni_body *b, const cni_motion *m)
{
	cni_in_medium in;
	in.center = b->local_center;
	in.q = cni_rot_mul(b->q, cni_rot_small(0.5f * v->dt * m->w));
	in.velocity = cni_v(m->vx, m->vy);
	in.spin = m->w;
	for (int32_t k = f->first; k < end; ++k) {
		const cni_area *a = visit_area(v, k);
		if ((a->def.density_kgpm2 != 0.0f || a->def.drag_kgpm2 != 0.0f || a->def.lift_kgpm2 != 0.0f) && (k == f->first || v->keys[k] != v->keys[k - 1]))
			medium_of_area(f, v, k, &in, b, m);
	}
}

/*
 * Leapfrog is stable up to w dt = 2. Stiffer buoyancy (a float of small draught) gets the resistance that makes its spring implicit, as in
 * backward Euler, which damps it: (m + dt r) dv = dt (F - r v) with r = dt k / 2 - m / dt. Others, up to the square root of 2, get none.
 */
static void stiffness_soften(cni_medium_force *f, cni_medium_force *soft, const cni_body *b, const cni_motion *m, cni_vec2 up, float dt)
{
	float stiff = f->heave / b->mass + (m->inv_inertia > 0.0f ? f->roll / b->inertia : 0.0f), excess = (0.5f * dt * dt * stiff - 1.0f) / dt, r, speed;
	memset(soft, 0, sizeof *soft);
	if (excess <= 0.0f)
		return;
	r = excess * b->mass;
	speed = (f->heave > 0.0f ? f->heave_flow / f->heave : 0.0f) - (up.x * m->vx + up.y * m->vy);
	soft->resist[0][0] = r * up.x * up.x;
	soft->resist[0][1] = soft->resist[1][0] = r * up.x * up.y;
	soft->resist[1][1] = r * up.y * up.y;
	soft->resist[2][2] = excess * b->inertia;
	f->drag[0] += r * speed * up.x;
	f->drag[1] += r * speed * up.y;
	f->drag[2] -= excess * b->inertia * m->w;
	for (int32_t i = 0; i < 3; ++i)
		for (int32_t j = 0; j < 3; ++j)
			f->resist[i][j] += soft->resist[i][j];
}

/*
 * A body without contacts and joints takes all forces in one implicit step. In others the forces meet those of contacts and joints, which
 * are not known here: what floats at rest under a load is not slowed by its damping, so only drag is implicit in its own change.
 */
static void body_solve(const visits *v, const cni_body *b, cni_medium_force *f, const cni_medium_force *soft, const float mass[3], float change[3])
{
	cni_medium_force forces = *soft;
	float of_forces[3];
	if (b->lanes == 0 && b->joint_first == CNI_NONE) {
		cni_medium_solve(f, mass, v->dt, change);
		return;
	}
	for (int32_t k = 0; k < 3; ++k) {
		forces.force[k] = f->force[k];
		forces.drag[k] = f->force[k] = 0.0f;
	}
	cni_medium_solve(&forces, mass, v->dt, of_forces);
	cni_medium_solve(f, mass, v->dt, change);
	for (int32_t k = 0; k < 3; ++k)
		change[k] += of_forces[k];
}

static void body_accelerate(const visits *v, int32_t begin, int32_t end)
{
	cn_world *world = v->world;
	int32_t index = visit_body(v->keys[begin]);
	const cni_body *b = cni_body_at(world, cni_awake_ids(world)[index]);
	const cni_motion *m = cni_motions(world) + index;
	cni_external *d = cni_externals(world) + index;
	cni_velocity_start *start = cni_starts(world) + index;
	cni_medium_force soft;
	float mass[3], change[3];
	field f;
	field_of_center(&f, v, begin, end, b, m);
	f.gravity = cni_mul(b->gravity_scale, f.gravity);
	field_of_parts(&f, v, end, b, m);
	f.force.force[0] += b->mass * f.gravity.x + d->ax;
	f.force.force[1] += b->mass * f.gravity.y + d->ay;
	f.force.force[2] += d->alpha;
	stiffness_soften(&f.force, &soft, b, m, up_of(&f), v->dt);
	mass[0] = m->inv_mass > 0.0f && !(b->flags & CN_BODY_LOCK_X) ? b->mass : 0.0f;
	mass[1] = m->inv_mass > 0.0f && !(b->flags & CN_BODY_LOCK_Y) ? b->mass : 0.0f;
	mass[2] = m->inv_inertia > 0.0f ? b->inertia : 0.0f;
	body_solve(v, b, &f.force, &soft, mass, change);
	start->vx = change[0] / v->dt;
	start->vy = change[1] / v->dt;
	start->w = change[2] / v->dt;
	d->flags |= CNI_EXTERNAL_DEFERRED;
}

void cni_areas_accelerate(cn_world *world, float dt)
{
	visits v = { world, NULL, 0, dt };
	int32_t begin = 0;
	visits_find(&v, NULL);
	if (v.count == 0)
		return;
	uint64_t *keys = (uint64_t *)cni_scratch_push(world, sizeof(uint64_t) * 2u * (uint64_t)v.count);
	if (keys == NULL)
		return;
	visits_find(&v, keys);
	cni_sort_keys(keys, keys + v.count, v.count);
	for (int32_t k = 1; k <= v.count; ++k) {
		if (k < v.count && visit_body(keys[k]) == visit_body(keys[begin]))
			continue;
		body_accelerate(&v, begin, k);
		begin = k;
	}
	cni_arena_pop(&world->arena, keys);
}
