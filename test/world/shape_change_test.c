/*
 * test/world/shape_change_test.c - shapes change in place: the handle stays, and everything else is as if the shape had been created
 * so.
 *
 * If a test here fails, run world/shape first, then look in: world/shape_create.c, model/shape.c (pieces, boxes).
 */
#include "events.h"

static cn_polygon polygon_of(int32_t count, float size)
{
	cn_polygon p;
	int32_t k;
	memset(&p, 0, sizeof p);
	p.count = count;
	p.radius_m = 0.02f;
	for (k = 0; k < count; ++k) {
		p.points_m[k].x = size * (float)cos(6.283185307 * (double)k / (double)count);
		p.points_m[k].y = size * (float)sin(6.283185307 * (double)k / (double)count);
	}
	return p;
}

static cn_chain chain_of(cn_vec2 *points, int32_t count, float height)
{
	cn_chain chain;
	int32_t k;
	for (k = 0; k < count; ++k) {
		points[k].x = 10.0f - 20.0f * (float)k / (float)(count - 1);
		points[k].y = k % 2 ? height : 0.0f;
	}
	chain.points_m = points;
	chain.count = count;
	chain.loop = 0;
	return chain;
}

/* ---- as if created so ---- */

typedef struct geometry {
	int32_t type;
	cn_circle circle;
	cn_capsule capsule;
	cn_edge edge;
	cn_polygon polygon;
	cn_chain chain;
	cn_vec2 points[40];
} geometry;

static void geometry_make(geometry *g, int32_t type, int32_t variant)
{
	float size = 0.5f + 0.25f * (float)variant;
	memset(g, 0, sizeof *g);
	g->type = type;
	g->circle.center_m.x = 0.1f * (float)variant;
	g->circle.radius_m = size;
	g->capsule.a_m.x = -size;
	g->capsule.b_m.x = size;
	g->capsule.b_m.y = 0.1f * (float)variant;
	g->capsule.radius_m = 0.3f * size;
	g->edge.a_m.x = -size;
	g->edge.b_m.x = size;
	g->polygon = polygon_of(3 + 4 * variant, size);
	g->chain = chain_of(g->points, 5 + 11 * variant, 0.2f * size);
}

static cn_shape geometry_create(cn_world *world, cn_body body, const geometry *g)
{
	cn_shape_def def = fixture_shape_def(body, 0.5f, 0.0f);
	cn_shape shape = 0;
	def.event_mask = ALL_EVENTS;
	switch (g->type) {
	case CN_SHAPE_CIRCLE: must(cn_shape_create_circle(world, &def, &g->circle, &shape), world, "circle"); break;
	case CN_SHAPE_CAPSULE: must(cn_shape_create_capsule(world, &def, &g->capsule, &shape), world, "capsule"); break;
	case CN_SHAPE_EDGE: must(cn_shape_create_edge(world, &def, &g->edge, &shape), world, "edge"); break;
	case CN_SHAPE_POLYGON: must(cn_shape_create_polygon(world, &def, &g->polygon, &shape), world, "polygon"); break;
	default: must(cn_shape_create_chain(world, &def, &g->chain, &shape), world, "chain");
	}
	return shape;
}

static cn_result geometry_set(cn_world *world, cn_shape shape, const geometry *g)
{
	switch (g->type) {
	case CN_SHAPE_CIRCLE: return cn_shape_set_circle(world, shape, &g->circle);
	case CN_SHAPE_CAPSULE: return cn_shape_set_capsule(world, shape, &g->capsule);
	case CN_SHAPE_EDGE: return cn_shape_set_edge(world, shape, &g->edge);
	case CN_SHAPE_POLYGON: return cn_shape_set_polygon(world, shape, &g->polygon);
	default: return cn_shape_set_chain(world, shape, &g->chain);
	}
}

/* Mass, boxes and a ray: what others see of the shape. */
static void shapes_agree(cn_world *world, cn_body a, cn_body b, cn_shape sa, cn_shape sb)
{
	cn_mass_data ma, mb;
	cn_aabb ba, bb;
	cn_ray ray = { { 0.03f, 5.0f }, { 0.0f, -10.0f } };
	cn_ray_hit ha, hb;
	int32_t na = 0, nb = 0;
	must(cn_body_get_mass_data(world, a, &ma), world, "mass");
	must(cn_body_get_mass_data(world, b, &mb), world, "mass");
	CHECK(memcmp(&ma, &mb, sizeof ma) == 0);
	must(cn_shape_get_aabb(world, sa, &ba), world, "box");
	must(cn_shape_get_aabb(world, sb, &bb), world, "box");
	CHECK(memcmp(&ba, &bb, sizeof ba) == 0);
	must(cn_shape_cast_ray(world, sa, &ray, &ha), world, "ray");
	must(cn_shape_cast_ray(world, sb, &ray, &hb), world, "ray");
	CHECK(ha.fraction == hb.fraction && ha.normal.x == hb.normal.x);
	if (cn_shape_get_chain_points(world, sa, NULL, 0, &na) == CN_OK)
		must(cn_shape_get_chain_points(world, sb, NULL, 0, &nb), world, "points");
	CHECK(na == nb);
}

static void a_changed_shape_is_as_if_created_so(void)
{
	int32_t type, from, to, is_static;
	for (type = CN_SHAPE_CIRCLE; type <= CN_SHAPE_CHAIN; ++type)
		for (is_static = 0; is_static < 2; ++is_static)
			for (from = 0; from < 3; ++from)
				for (to = 0; to < 3; ++to) {
					cn_world *world = fixture_world(-10.0f, 1);
					int32_t of = is_static ? CN_BODY_STATIC : CN_BODY_DYNAMIC;
					cn_body a = fixture_body(world, of, 0.0f, 0.0f, 0.0f), b = fixture_body(world, of, 0.0f, 0.0f, 0.0f);
					static geometry g, h;
					cn_shape sa, sb;
					geometry_make(&g, type, from);
					geometry_make(&h, type, to);
					sa = geometry_create(world, a, &g);
					sb = geometry_create(world, b, &h);
					must(geometry_set(world, sa, &h), world, "set");
					CHECK(cn_shape_is_valid(world, sa) && fixture_is_valid(world));
					shapes_agree(world, a, b, sa, sb);
					fixture_step(world, 3);
					CHECK(fixture_is_valid(world));
					cn_world_destroy(world);
				}
}

/* ---- contacts ---- */

static void a_ball_that_grows_keeps_its_contact(void)
{
	cn_world *world = fixture_world(-10.0f, 1);
	cn_body ball;
	cn_circle circle = { { 0.0f, 0.0f }, 0.7f };
	cn_contact_event before, after;
	int32_t count;
	cn_mass_data mass;
	fixture_floor(world, 0.5f, 0.0f);
	ball = fixture_circle(world, CN_BODY_DYNAMIC, 0.0f, 0.5f, 0.5f, 0.5f, 0.0f);
	fixture_step(world, 120);
	CHECK(!fixture_is_awake(world, ball));
	must(cn_body_get_contacts(world, ball, &before, 1, &count), world, "contacts");
	must(cn_shape_set_circle(world, fixture_first_shape(world, ball), &circle), world, "cn_shape_set_circle");
	CHECK(fixture_is_awake(world, ball));
	must(cn_body_get_mass_data(world, ball, &mass), world, "mass");
	CHECK_LE("mass / pi r^2 - 1", fabs((double)mass.mass_kg / (3.14159265 * 0.49) - 1.0), ROUNDING, "");
	fixture_step(world, 1);
	CHECK(count_events(world, CN_EVENT_ENTER) == 0 && count_events(world, CN_EVENT_LEAVE) == 0);
	must(cn_body_get_contacts(world, ball, &after, 1, &count), world, "contacts");
	CHECK(count == 1 && after.contact_id == before.contact_id);
	fixture_step(world, 180);
	CHECK_LE("height at rest - new radius", fabs((double)fixture_pose(world, ball).position_m.y - 0.7), SAG_M, "m");
	cn_world_destroy(world);
}

/* A platform shrinks away from under a sleeping box, and a wall grows into another. */
static void sleeping_bodies_notice_the_change(void)
{
	cn_world *world = fixture_world(-10.0f, 1);
	cn_body platform = fixture_box(world, CN_BODY_STATIC, 0.0f, -1.0f, 0.0f, 3.0f, 1.0f, 0.5f, 0.0f), left, right, wall;
	cn_polygon p = { 4, 0.0f, { { -3.0f, -1.0f }, { 0.5f, -1.0f }, { 0.5f, 1.0f }, { -3.0f, 1.0f } } };
	left = fixture_box(world, CN_BODY_DYNAMIC, -2.0f, 0.5f, 0.0f, 0.5f, 0.5f, 0.5f, 0.0f);
	right = fixture_box(world, CN_BODY_DYNAMIC, 2.0f, 0.5f, 0.0f, 0.5f, 0.5f, 0.5f, 0.0f);
	wall = fixture_box(world, CN_BODY_STATIC, -6.0f, 1.0f, 0.0f, 1.0f, 1.0f, 0.5f, 0.0f);
	fixture_step(world, 120);
	REQUIRE(!fixture_is_awake(world, left) && !fixture_is_awake(world, right));
	must(cn_shape_set_polygon(world, fixture_first_shape(world, platform), &p), world, "shrink");
	fixture_step(world, 60);
	CHECK_LE("height of the box without a platform", fixture_pose(world, right).position_m.y, -3.0, "m");
	CHECK_LE("drop of the other", fabs((double)fixture_pose(world, left).position_m.y - 0.5), SAG_M, "m");
	fixture_step(world, 120);
	REQUIRE(!fixture_is_awake(world, left));
	p.points_m[0].x = p.points_m[3].x = -1.0f;
	p.points_m[1].x = p.points_m[2].x = 3.6f; /* to x = -2.4: 0.1 m into the box */
	must(cn_shape_set_polygon(world, fixture_first_shape(world, wall), &p), world, "grow");
	CHECK(fixture_is_awake(world, left));
	fixture_step(world, 60);
	CHECK_GE("way that the wall pushed the box", (double)fixture_pose(world, left).position_m.x + 2.0, 0.1 - 2.0 * SAG_M, "m");
	cn_world_destroy(world);
}

/* ---- everything at once ---- */

/* Random changes of all types in a crowd, on moving and static bodies; every ENTER gets its LEAVE. */
static void random_changes_keep_the_world_valid(void)
{
	enum { BODIES = 40 };
	uint32_t seed;
	for (seed = 1; seed <= 2; ++seed) {
		cn_world *world = fixture_world(-10.0f, 1);
		cn_body bodies[BODIES];
		cn_shape shapes[BODIES];
		uint32_t random = 977u * seed;
		int32_t k, step, touching = 0, changes = 0;
		static geometry g;
		geometry_make(&g, CN_SHAPE_CHAIN, 1);
		bodies[0] = fixture_body(world, CN_BODY_STATIC, 0.0f, 0.0f, 0.0f);
		shapes[0] = geometry_create(world, bodies[0], &g);
		for (k = 1; k < BODIES; ++k) {
			bodies[k] = fixture_body(world, k % 9 == 0 ? CN_BODY_STATIC : CN_BODY_DYNAMIC, fixture_random(&random, -6.0f, 6.0f), 1.0f + 0.4f * (float)k, 0.0f);
			geometry_make(&g, k % 3 == 2 ? CN_SHAPE_POLYGON : k % 3, k % 3);
			shapes[k] = geometry_create(world, bodies[k], &g);
		}
		for (step = 0; step < 240; ++step) {
			k = (int32_t)fixture_random(&random, 0.0f, (float)BODIES - 0.01f);
			geometry_make(&g, k == 0 ? CN_SHAPE_CHAIN : k % 3 == 2 ? CN_SHAPE_POLYGON : k % 3, (int32_t)fixture_random(&random, 0.0f, 2.99f));
			must(geometry_set(world, shapes[k], &g), world, "set");
			++changes;
			CHECK(fixture_is_valid(world));
			fixture_step(world, 1);
			touching += count_events(world, CN_EVENT_ENTER) - count_events(world, CN_EVENT_LEAVE);
		}
		CHECK(fixture_is_valid(world));
		CHECK(touching == fixture_counters(world).contacts_touching);
		CHECK_GE("changes", changes, 240, "");
		cn_world_destroy(world);
	}
}

/* ---- mass between steps ---- */

typedef struct compound {
	cn_world *world;
	cn_body body;
	cn_shape shapes[400];
	int32_t count;
	uint32_t random;
} compound;

static float any(compound *c, float lower, float upper) { return fixture_random(&c->random, lower, upper); }

static void compound_add(compound *c)
{
	cn_shape_def def = fixture_shape_def(c->body, 0.5f, 0.0f);
	def.offset_m.x = any(c, -50.0f, 50.0f);
	def.offset_m.y = any(c, -20.0f, 60.0f);
	def.density_kgpm2 = any(c, 0.01f, 100.0f);
	c->shapes[c->count++] = fixture_box_shape(c->world, &def, any(c, 0.1f, 3.0f), 0.5f);
}

/* Removes, or changes geometry or density. */
static void compound_change(compound *c)
{
	int32_t k = (int32_t)any(c, 0.0f, (float)c->count - 0.01f), what = (int32_t)any(c, 0.0f, 5.99f);
	cn_polygon box;
	if (what == 0) {
		must(cn_shape_set_density(c->world, c->shapes[k], any(c, 0.01f, 100.0f)), c->world, "cn_shape_set_density");
	} else if (what == 1) {
		must(cn_polygon_make_box(any(c, 0.1f, 3.0f), 0.4f, any(c, -50.0f, 50.0f), any(c, -20.0f, 60.0f), 0.0f, 0.0f, &box), NULL, "cn_polygon_make_box");
		must(cn_shape_set_polygon(c->world, c->shapes[k], &box), c->world, "cn_shape_set_polygon");
	} else {
		must(cn_shape_destroy(c->world, c->shapes[k]), c->world, "cn_shape_destroy");
		c->shapes[k] = c->shapes[--c->count];
	}
}

static cn_mass_data mass_of(const compound *c)
{
	cn_mass_data m;
	must(cn_body_get_mass_data(c->world, c->body, &m), c->world, "cn_body_get_mass_data");
	return m;
}

/* Sums are updated shape by shape between steps, and computed from all shapes when a step begins. Without the next step they must be as good. */
static void the_mass_is_that_of_all_shapes_between_steps(void)
{
	static compound c;
	double mass = 0.0, inertia = 0.0, center = 0.0;
	int32_t k;
	memset(&c, 0, sizeof c);
	c.random = 77u;
	c.world = fixture_world(0.0f, 0);
	c.body = fixture_body(c.world, CN_BODY_DYNAMIC, 0.0f, 0.0f, 0.0f);
	for (k = 0; k < 3000; ++k) {
		cn_mass_data before, exact;
		if (c.count < 10 || (c.count < 400 && any(&c, 0.0f, 1.0f) < (k / 500 % 2 ? 0.1f : 0.7f)))
			compound_add(&c);
		else
			compound_change(&c);
		if (k % 50 != 0)
			continue;
		before = mass_of(&c);
		fixture_step(c.world, 1);
		exact = mass_of(&c);
		mass = greater(mass, fabs((double)before.mass_kg / (double)exact.mass_kg - 1.0));
		inertia = greater(inertia, fabs((double)before.inertia_kgm2 / (double)exact.inertia_kgm2 - 1.0));
		center = greater(center, hypot((double)(before.center_m.x - exact.center_m.x), (double)(before.center_m.y - exact.center_m.y)));
	}
	CHECK_LE("relative error of the mass", mass, ROUNDING, "");
	CHECK_LE("relative error of the inertia", inertia, 10.0 * ROUNDING, "");
	CHECK_LE("error of the centre, part of the extent", center / 60.0, ROUNDING, "");
	CHECK(fixture_is_valid(c.world));
	cn_world_destroy(c.world);
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(a_changed_shape_is_as_if_created_so);
	RUN(a_ball_that_grows_keeps_its_contact);
	RUN(sleeping_bodies_notice_the_change);
	RUN(random_changes_keep_the_world_valid);
	RUN(the_mass_is_that_of_all_shapes_between_steps);
	return test_end();
}
