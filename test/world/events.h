/*
 * test/world/events.h - what tests of contact events share: reading the arrays of events, masks, and churn, a world to
 * which everything happens that can begin or end a contact.
 */
#ifndef CAIRN_TEST_EVENTS_H
#define CAIRN_TEST_EVENTS_H

#include "fixture.h"

enum {
	ALL_EVENTS = (1 << CN_EVENT_KINDS) - 1,
	TOUCH_EVENTS = 1 << CN_EVENT_ENTER | 1 << CN_EVENT_LEAVE,
	BOX_EVENTS = 1 << CN_EVENT_CREATED | 1 << CN_EVENT_DESTROYED
};

static inline int32_t events_of(cn_world *world, int32_t kind, const cn_contact_event **out)
{
	int32_t count = 0;
	must(cn_world_contact_events(world, kind, out, &count), world, "cn_world_contact_events");
	return count;
}

static inline int32_t count_events(cn_world *world, int32_t kind)
{
	const cn_contact_event *events;
	return events_of(world, kind, &events);
}

static inline int32_t count_all_events(cn_world *world)
{
	int32_t kind, count = 0;
	for (kind = 0; kind < CN_EVENT_KINDS; ++kind)
		count += count_events(world, kind);
	return count;
}

static inline void set_mask(cn_world *world, cn_body body, uint32_t mask)
{
	must(cn_shape_set_event_mask(world, fixture_first_shape(world, body), mask), world, "cn_shape_set_event_mask");
}

/* ---- churn: a world to which everything happens ---- */

#define CHURN_BODIES 240
#define CHURN_JOINTS 64
#define CHURN_SPARE 32

typedef struct churn {
	cn_world *world;
	uint32_t seed;
	uint32_t mask;                  /* of new shapes */
	int32_t masks_change;
	cn_body bodies[CHURN_BODIES];   /* 0: gone for now */
	cn_joint joints[CHURN_JOINTS];
	cn_shape spare[CHURN_SPARE];    /* detached shapes */
} churn;

static inline float churn_random(churn *c, float lower, float upper) { return fixture_random(&c->seed, lower, upper); }

static inline int32_t churn_int(churn *c, int32_t count) { return (int32_t)fixture_random(&c->seed, 0.0f, (float)count - 0.001f); }

static inline uint32_t churn_mask(churn *c)
{
	static const uint32_t spans[] = { 0, TOUCH_EVENTS, BOX_EVENTS, TOUCH_EVENTS | BOX_EVENTS };
	return c->masks_change ? spans[churn_int(c, 4)] : c->mask;
}

static inline void churn_shape(churn *c, cn_body body)
{
	cn_shape_def def = fixture_shape_def(body, 0.5f, churn_random(c, -1.0f, 0.5f) > 0.0f ? 0.4f : 0.0f);
	cn_circle circle = { { 0.0f, 0.0f }, 0.3f };
	cn_capsule capsule = { { -0.3f, 0.0f }, { 0.3f, 0.1f }, 0.15f };
	def.event_mask = churn_mask(c);
	def.offset_m.x = churn_random(c, -0.1f, 0.1f);
	switch (churn_int(c, 3)) {
	case 0: must(cn_shape_create_circle(c->world, &def, &circle, NULL), c->world, "circle"); break;
	case 1: must(cn_shape_create_capsule(c->world, &def, &capsule, NULL), c->world, "capsule"); break;
	default: must(cn_shape_create_box(c->world, &def, 0.3f, 0.2f, 0.0f, NULL), c->world, "box");
	}
}

static inline void churn_body(churn *c, int32_t k)
{
	int32_t type = churn_int(c, 12) == 0 ? churn_int(c, 2) : CN_BODY_DYNAMIC;
	float x = churn_random(c, -7.0f, 7.0f), y = churn_random(c, 0.5f, 9.0f), angle = churn_random(c, -3.0f, 3.0f), vx, vy;
	c->bodies[k] = fixture_body(c->world, type, x, y, angle);
	churn_shape(c, c->bodies[k]);
	if (churn_int(c, 4) == 0)
		churn_shape(c, c->bodies[k]);
	if (type == CN_BODY_STATIC)
		return;
	vx = churn_random(c, -3.0f, 3.0f);
	vy = churn_random(c, -3.0f, 3.0f);
	fixture_set_velocity(c->world, c->bodies[k], vx, vy, churn_random(c, -4.0f, 4.0f));
}

/* A valley of one chain, with a box as a lid on what rolls out. */
static inline void churn_ground(churn *c)
{
	static const cn_vec2 points[] = { { 9, 10 }, { 8, 1 }, { 5, 0 }, { 2, 0.3f }, { 0, 0 }, { -2, 0.3f }, { -5, 0 }, { -8, 1 }, { -9, 10 } };
	cn_chain chain;
	cn_shape_def def = fixture_shape_def(fixture_body(c->world, CN_BODY_STATIC, 0.0f, 0.0f, 0.0f), 0.6f, 0.0f);
	chain.points_m = points;
	chain.count = (int32_t)(sizeof points / sizeof *points);
	chain.loop = 0;
	def.event_mask = churn_mask(c);
	must(cn_shape_create_chain(c->world, &def, &chain, NULL), c->world, "chain");
	def.body = fixture_body(c->world, CN_BODY_STATIC, 0.0f, -3.0f, 0.0f);
	fixture_box_shape(c->world, &def, 40.0f, 1.0f);
}

static inline void churn_begin(churn *c, uint32_t seed, uint32_t mask, int32_t masks_change)
{
	int32_t k;
	memset(c, 0, sizeof *c);
	c->world = fixture_world(-10.0f, 1);
	c->seed = seed * 2654435761u + 1u;
	c->mask = mask;
	c->masks_change = masks_change;
	must(cn_world_set_sleep(c->world, 0.2f, 0.1f), c->world, "cn_world_set_sleep"); /* much falls asleep and wakes */
	churn_ground(c);
	for (k = 0; k < CHURN_BODIES; ++k)
		churn_body(c, k);
}

static inline void churn_joint(churn *c, cn_body a, cn_body b)
{
	cn_joint *slot = &c->joints[churn_int(c, CHURN_JOINTS)];
	cn_revolute_def revolute;
	cn_distance_def distance;
	int32_t type_a, type_b;
	if (*slot != 0 && cn_joint_is_valid(c->world, *slot)) {
		if (churn_int(c, 2))
			must(cn_joint_set_flags(c->world, *slot, churn_int(c, 2) ? CN_JOINT_COLLIDE : 0u), c->world, "cn_joint_set_flags");
		else
			must(cn_joint_destroy(c->world, *slot), c->world, "cn_joint_destroy");
		return;
	}
	must(cn_body_get_type(c->world, a, &type_a), c->world, "cn_body_get_type");
	must(cn_body_get_type(c->world, b, &type_b), c->world, "cn_body_get_type");
	if (a == b || (type_a != CN_BODY_DYNAMIC && type_b != CN_BODY_DYNAMIC))
		return;
	cn_revolute_def_init(&revolute);
	cn_distance_def_init(&distance);
	revolute.base.body_a = distance.base.body_a = a;
	revolute.base.body_b = distance.base.body_b = b;
	revolute.base.flags = churn_int(c, 3) == 0 ? CN_JOINT_COLLIDE : 0u;
	distance.length_m = 1.0f;
	if (churn_int(c, 2))
		must(cn_joint_create_revolute(c->world, &revolute, slot), c->world, "cn_joint_create_revolute");
	else
		must(cn_joint_create_distance(c->world, &distance, slot), c->world, "cn_joint_create_distance");
}

/* A body that touches it, for joints that end contacts; else itself. */
static inline cn_body churn_neighbour(churn *c, cn_body body)
{
	cn_contact_event e[8];
	int32_t count, k;
	must(cn_body_get_contacts(c->world, body, e, 8, &count), c->world, "cn_body_get_contacts");
	for (k = 0; k < count && k < 8; ++k)
		if (e[k].body_a != body || e[k].body_b != body)
			return e[k].body_a == body ? e[k].body_b : e[k].body_a;
	return body;
}

static inline void churn_filter(churn *c, cn_body body)
{
	static const cn_filter filters[] = {
		{ 1, ~(uint64_t)0, 0, 0 }, { 1, ~(uint64_t)0, 0, 0 }, { 2, 2, 0, 0 }, { 1, 1, -3, 0 }, { 4, 0, 5, 0 }, { (uint64_t)1 << 63, ~(uint64_t)0, 0, 0 }
	};
	if (fixture_first_shape(c->world, body) != 0)
		must(cn_shape_set_filter(c->world, fixture_first_shape(c->world, body), &filters[churn_int(c, 6)]), c->world, "cn_shape_set_filter");
}

static inline void churn_detach(churn *c, cn_body body)
{
	cn_shape *slot = &c->spare[churn_int(c, CHURN_SPARE)];
	if (*slot != 0) {
		if (churn_int(c, 4) == 0)
			must(cn_shape_destroy(c->world, *slot), c->world, "cn_shape_destroy");
		else
			must(cn_shape_attach(c->world, *slot, body), c->world, "cn_shape_attach");
		*slot = 0;
	} else if ((*slot = fixture_first_shape(c->world, body)) != 0) {
		must(cn_shape_detach(c->world, *slot), c->world, "cn_shape_detach");
	}
}

static inline void churn_world(churn *c)
{
	cn_vec2 gravity = { 0.0f, -10.0f };
	gravity.x = churn_random(c, -1.0f, 1.0f);
	if (churn_int(c, 4) == 0)
		must(cn_world_set_gravity(c->world, gravity.x, gravity.y), c->world, "cn_world_set_gravity");
	else
		must(cn_world_set_flags(c->world, CN_WORLD_WARM_START | (churn_int(c, 3) ? (uint32_t)CN_WORLD_SLEEP : 0u)), c->world, "cn_world_set_flags");
}

static inline void churn_teleport(churn *c, cn_body body)
{
	cn_vec2 to;
	to.x = churn_random(c, -7.0f, 7.0f);
	to.y = churn_random(c, 0.5f, 9.0f);
	must(cn_body_set_pose(c->world, body, to.x, to.y, churn_random(c, -3.0f, 3.0f)), c->world, "cn_body_set_pose");
}

static inline void churn_act(churn *c)
{
	int32_t k = churn_int(c, CHURN_BODIES), what = churn_int(c, 24);
	cn_body body = c->bodies[k], other = c->bodies[churn_int(c, CHURN_BODIES)];
	cn_material material = fixture_shape_def(0, 0.9f, 0.2f).material;
	uint32_t flags;
	if (body == 0) {
		churn_body(c, k);
		return;
	}
	switch (what) {
	case 0: case 1: must(cn_body_destroy(c->world, body), c->world, "cn_body_destroy"); c->bodies[k] = 0; break;
	case 2: case 3: churn_teleport(c, body); break;
	case 4: case 5: churn_filter(c, body); break;
	case 6: case 7:
		if (cn_body_set_type(c->world, body, churn_int(c, 3)) == CN_ERROR_ARGUMENT)
			must(CN_ERROR_ARGUMENT, c->world, "cn_body_set_type");
		break;
	case 8: case 9: case 10:
		must(cn_body_get_flags(c->world, body, &flags), c->world, "cn_body_get_flags");
		must(cn_body_set_flags(c->world, body, flags ^ CN_BODY_ENABLED), c->world, "cn_body_set_flags");
		break;
	case 11: case 12: case 13: churn_detach(c, body); break;
	case 14: case 15: churn_joint(c, body, churn_neighbour(c, body)); break;
	case 16: churn_joint(c, body, other != 0 ? other : body); break;
	case 17: case 18: must(cn_body_set_awake(c->world, body, churn_int(c, 2)), c->world, "cn_body_set_awake"); break;
	case 19: if (churn_int(c, 8) == 0) churn_world(c); break;
	case 20: churn_shape(c, body); break;
	case 21: if (fixture_first_shape(c->world, body) != 0) must(cn_shape_set_material(c->world, fixture_first_shape(c->world, body), &material), c->world, "material"); break;
	case 22: if (fixture_first_shape(c->world, body) != 0) must(cn_shape_set_density(c->world, fixture_first_shape(c->world, body), churn_random(c, 0.5f, 4.0f)), c->world, "density"); break;
	default:
		if (c->masks_change && fixture_first_shape(c->world, body) != 0)
			must(cn_shape_set_event_mask(c->world, fixture_first_shape(c->world, body), churn_mask(c)), c->world, "mask");
	}
}

static inline void churn_calls(churn *c, int32_t calls)
{
	while (calls-- > 0)
		churn_act(c);
}

static inline void churn_step(churn *c, int32_t calls)
{
	churn_calls(c, calls);
	fixture_step(c->world, 1);
}

static inline void churn_end(churn *c)
{
	int32_t k, count;
	cn_body bodies[CHURN_BODIES + 2];
	must(cn_world_get_bodies(c->world, bodies, CHURN_BODIES + 2, &count), c->world, "cn_world_get_bodies");
	for (k = 0; k < count; ++k)
		must(cn_body_destroy(c->world, bodies[k]), c->world, "cn_body_destroy");
	fixture_step(c->world, 1);
}

#endif
