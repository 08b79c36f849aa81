/*
 * test/world/direct.h - what tests of directly solved joints and contacts share: a world with its bodies and joints in
 * order of making, chains of links, and a watch over every step.
 */
#ifndef CAIRN_TEST_DIRECT_H
#define CAIRN_TEST_DIRECT_H

#include "joints.h"

#define PARTS_MOST 128

/* A world, its bodies and its joints in order of making. */
typedef struct scene {
	cn_world *world;
	cn_body bodies[PARTS_MOST];
	cn_joint joints[PARTS_MOST];
	int32_t body_count, joint_count;
} scene;

static inline scene scene_open(double gravity, int32_t sleep, int32_t solver)
{
	scene s;
	cn_world_def def;
	memset(&s, 0, sizeof s);
	cn_world_def_init(&def);
	def.gravity_mps2 = at(0.0f, (float)-gravity);
	def.solver = solver;
	if (!sleep)
		def.flags &= ~(uint32_t)CN_WORLD_SLEEP;
	must(cn_world_create(&def, &s.world), NULL, "cn_world_create");
	return s;
}

static inline void scene_close(scene *s)
{
	CHECK(fixture_is_valid(s->world));
	cn_world_destroy(s->world);
}

static inline cn_body keep(scene *s, cn_body body)
{
	s->bodies[s->body_count++] = body;
	return body;
}

static inline void set_mass(const scene *s, cn_body body, float mass, float inertia)
{
	cn_mass_data m = mass_of(s->world, body);
	m.mass_kg = mass;
	m.inertia_kgm2 = inertia;
	must(cn_body_set_mass_data(s->world, body, &m), s->world, "cn_body_set_mass_data");
}

static inline void weigh(const scene *s, cn_body body, float factor)
{
	cn_mass_data m = mass_of(s->world, body);
	set_mass(s, body, m.mass_kg * factor, m.inertia_kgm2 * factor);
}

/* The scene keeps the joint. */
static inline cn_joint pin(scene *s, cn_body a, cn_vec2 anchor_a, cn_body b, cn_vec2 anchor_b)
{
	s->joints[s->joint_count] = hinge(s->world, a, anchor_a, b, anchor_b);
	return s->joints[s->joint_count++];
}

#define LINK 0.25f /* half length of a link */
#define THIN 0.05f

/* It collides with others, not with other links. */
static inline cn_body add_link(const scene *s, float x, float y, float angle)
{
	cn_body link = fixture_body(s->world, CN_BODY_DYNAMIC, x, y, angle);
	cn_shape_def def = fixture_shape_def(link, 0.5f, 0.0f);
	def.filter.group = -1;
	fixture_box_shape(s->world, &def, LINK, THIN);
	return link;
}

/* Links from (x, y) along the direction of `angle`, pinned to one another; `first` is what the first one hangs on. */
static inline void add_chain(scene *s, cn_body first, cn_vec2 first_anchor, float x, float y, float angle, int32_t count)
{
	float c = (float)cos((double)angle), n = (float)sin((double)angle);
	int32_t k;
	for (k = 0; k < count; ++k) {
		float along = LINK * (float)(2 * k + 1);
		cn_body link = add_link(s, x + along * c, y + along * n, angle);
		if (k > 0)
			pin(s, s->bodies[s->body_count - 1], at(LINK, 0.0f), link, at(-LINK, 0.0f));
		else if (first != 0 || first_anchor.x > -1e6f)
			pin(s, first, first_anchor, link, at(-LINK, 0.0f));
		keep(s, link);
	}
}

static inline void weld(scene *s, cn_body a, cn_vec2 anchor_a, cn_body b, cn_vec2 anchor_b)
{
	cn_fixed_def def;
	cn_fixed_def_init(&def);
	connect(&def.base, a, anchor_a, b, anchor_b);
	s->joints[s->joint_count++] = make_fixed(s->world, &def);
}

static inline cn_vec2 nowhere(void)
{
	return at(-2e6f, 0.0f);
}

static inline cn_body last_body(const scene *s)
{
	return s->bodies[s->body_count - 1];
}

/* ---- reading ---- */

static inline double anchors_apart(const scene *s)
{
	double worst = 0.0;
	int32_t k;
	for (k = 0; k < s->joint_count; ++k) {
		float m = 0.0f, rad = 0.0f;
		if (!cn_joint_is_valid(s->world, s->joints[k]))
			continue;
		must(cn_joint_get_error(s->world, s->joints[k], &m, &rad), s->world, "cn_joint_get_error");
		if (!((double)m <= worst))
			worst = (double)m;
	}
	return worst;
}

static inline totals totals_in(const scene *s)
{
	return totals_of(s->world, s->bodies, s->body_count);
}

static inline double energy_in(const scene *s)
{
	totals t = totals_in(s);
	return t.kinetic + t.potential;
}

/* The worst of every step. */
typedef struct watch {
	double apart, energy, energy_least, energy_start, speed, spin;
} watch;

static inline watch watch_begin(const scene *s)
{
	watch w = { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 };
	w.energy = w.energy_least = w.energy_start = energy_in(s);
	return w;
}

static inline void watch_steps(watch *w, scene *s, int32_t steps)
{
	int32_t k;
	for (k = 0; k < steps; ++k) {
		totals t;
		fixture_step(s->world, 1);
		t = totals_in(s);
		w->apart = greater(w->apart, anchors_apart(s));
		w->energy = greater(w->energy, t.kinetic + t.potential);
		w->energy_least = fmin(w->energy_least, t.kinetic + t.potential);
		w->speed = greater(w->speed, t.speed_most);
		w->spin = greater(w->spin, t.turn_most);
	}
}

static inline cn_body weighing(scene *s, cn_body body, float mass)
{
	weigh(s, body, mass / mass_of(s->world, body).mass_kg);
	return keep(s, body);
}

/* Collides with nothing. */
static inline cn_body ball(scene *s, float x, float radius, float mass)
{
	cn_body body = fixture_body(s->world, CN_BODY_DYNAMIC, x, 0.0f, 0.0f);
	cn_shape_def def = fixture_shape_def(body, 0.5f, 0.0f);
	cn_circle circle = { { 0.0f, 0.0f }, 0.0f };
	circle.radius_m = radius;
	def.filter.group = -1;
	must(cn_shape_create_circle(s->world, &def, &circle, NULL), s->world, "cn_shape_create_circle");
	return weighing(s, body, mass);
}

/* Beams do not collide with each other. */
static inline cn_body beam(scene *s, float x, float y, float angle, float half_x, float half_y)
{
	cn_body body = fixture_body(s->world, CN_BODY_DYNAMIC, x, y, angle);
	cn_shape_def def = fixture_shape_def(body, 0.6f, 0.0f);
	def.filter.group = -1;
	fixture_box_shape(s->world, &def, half_x, half_y);
	return keep(s, body);
}

static inline void pin_at(scene *s, cn_body a, cn_body b, float x, float y)
{
	cn_vec2 local_a, local_b;
	must(cn_body_get_local_point(s->world, a, x, y, &local_a), s->world, "cn_body_get_local_point");
	must(cn_body_get_local_point(s->world, b, x, y, &local_b), s->world, "cn_body_get_local_point");
	(void)hinge(s->world, a, local_a, b, local_b);
}

static inline double fastest_of(const scene *s, const cn_body *bodies, int32_t count)
{
	double fastest = 0.0;
	int32_t k;
	for (k = 0; k < count; ++k) {
		cn_velocity v;
		must(cn_body_get_velocity(s->world, bodies[k], &v), s->world, "cn_body_get_velocity");
		fastest = fmax(fastest, hypot((double)v.linear_mps.x, (double)v.linear_mps.y));
	}
	return fastest;
}

#endif
