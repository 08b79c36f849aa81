/*
 * test/world/draw_test.c - debug draw: what is emitted for each kind of thing, and where.
 *
 * If a test here fails, look first in: world/draw.c; for anchors and rows of joints, model/joint_*.c.
 */
#include "fixture.h"

/* ---- a recorder ---- */

enum { POLYGON, CIRCLE, CAPSULE, SEGMENT, POINT, TEXT, KINDS };

typedef struct mark {
	int32_t kind;
	int32_t count;
	cn_vec2 points[CN_POLYGON_MAX_VERTICES];
	float size;
	uint32_t color;
	char text[CN_NAME_MAX_BYTES + 1];
} mark;

typedef struct record {
	int32_t count[KINDS];
	int32_t marks;
	mark mark[256];
} record;

static mark *record_add(void *user, int32_t kind, float size, uint32_t color)
{
	record *r = user;
	mark *m = &r->mark[r->marks < 255 ? r->marks++ : 255];
	memset(m, 0, sizeof *m);
	++r->count[kind];
	m->kind = kind;
	m->size = size;
	m->color = color;
	return m;
}

static void on_polygon(const cn_vec2 *points, int32_t count, float radius, uint32_t color, void *user)
{
	mark *m = record_add(user, POLYGON, radius, color);
	m->count = count;
	memcpy(m->points, points, (size_t)count * sizeof *points);
}

static void on_circle(const cn_vec2 *center, float radius, const cn_vec2 *rim, uint32_t color, void *user)
{
	mark *m = record_add(user, CIRCLE, radius, color);
	m->points[0] = *center;
	m->points[1] = *rim;
}

static void on_capsule(const cn_vec2 *a, const cn_vec2 *b, float radius, uint32_t color, void *user)
{
	mark *m = record_add(user, CAPSULE, radius, color);
	m->points[0] = *a;
	m->points[1] = *b;
}

static void on_segment(const cn_vec2 *a, const cn_vec2 *b, uint32_t color, void *user)
{
	mark *m = record_add(user, SEGMENT, 0.0f, color);
	m->points[0] = *a;
	m->points[1] = *b;
}

static void on_point(const cn_vec2 *point, float size, uint32_t color, void *user)
{
	record_add(user, POINT, size, color)->points[0] = *point;
}

static void on_text(const cn_vec2 *point, const char *text, uint32_t color, void *user)
{
	mark *m = record_add(user, TEXT, 0.0f, color);
	m->points[0] = *point;
	strncpy(m->text, text, CN_NAME_MAX_BYTES);
}

static cn_debug_draw draw_all(record *r, uint32_t flags)
{
	cn_debug_draw d;
	cn_debug_draw_init(&d);
	memset(r, 0, sizeof *r);
	d.flags = flags;
	d.polygon = on_polygon;
	d.circle = on_circle;
	d.capsule = on_capsule;
	d.segment = on_segment;
	d.point = on_point;
	d.text = on_text;
	d.user = r;
	return d;
}

static record drawn; /* of the last draw */

static const record *draw(const cn_world *world, uint32_t flags)
{
	cn_debug_draw d = draw_all(&drawn, flags);
	must(cn_world_draw(world, &d), world, "cn_world_draw");
	return &drawn;
}

static const record *draw_view(const cn_world *world, uint32_t flags, float x0, float y0, float x1, float y1)
{
	cn_debug_draw d = draw_all(&drawn, flags);
	d.view.lower_m.x = x0;
	d.view.lower_m.y = y0;
	d.view.upper_m.x = x1;
	d.view.upper_m.y = y1;
	must(cn_world_draw(world, &d), world, "cn_world_draw");
	return &drawn;
}

static double distance(cn_vec2 p, double x, double y)
{
	return hypot((double)p.x - x, (double)p.y - y);
}

static int counts_are(const record *r, int32_t polygon, int32_t circle, int32_t capsule, int32_t segment, int32_t point, int32_t text)
{
	if (r->count[POLYGON] == polygon && r->count[CIRCLE] == circle && r->count[CAPSULE] == capsule && r->count[SEGMENT] == segment && r->count[POINT] == point && r->count[TEXT] == text)
		return 1;
	printf("  drew %d polygons, %d circles, %d capsules, %d segments, %d points, %d texts\n", (int)r->count[POLYGON], (int)r->count[CIRCLE],
	       (int)r->count[CAPSULE], (int)r->count[SEGMENT], (int)r->count[POINT], (int)r->count[TEXT]);
	return 0;
}

/* ---- shapes ---- */

static cn_shape_def turned(cn_world *world)
{
	return fixture_shape_def(fixture_body(world, CN_BODY_DYNAMIC, 3.0f, 2.0f, 1.57079633f), 0.6f, 0.0f);
}

static void polygons_have_their_corners(void)
{
	cn_world *world = fixture_world(0.0f, 0);
	cn_shape_def def = turned(world);
	const record *r;
	double worst = 0.0;
	int32_t k;
	must(cn_shape_create_box(world, &def, 1.0f, 0.5f, 0.1f, NULL), world, "cn_shape_create_box");
	r = draw(world, CN_DRAW_SHAPES);
	REQUIRE(counts_are(r, 1, 0, 0, 0, 0, 0));
	CHECK(r->mark[0].count == 4 && r->mark[0].size == 0.1f && r->mark[0].color != 0);
	for (k = 0; k < 4; ++k) { /* turned by a quarter: 1 wide, 2 high */
		double dx = fabs((double)r->mark[0].points[k].x - 3.0), dy = fabs((double)r->mark[0].points[k].y - 2.0);
		worst = greater(worst, greater(fabs(dx - 0.5), fabs(dy - 1.0)));
	}
	CHECK_LE("corner error", worst, 1e-5, "m");
	cn_world_destroy(world);
}

static void circles_and_capsules_turn_with_the_body(void)
{
	cn_world *world = fixture_world(0.0f, 0);
	cn_shape_def def = turned(world);
	cn_circle circle = { { 1.0f, 0.0f }, 0.25f };
	cn_capsule capsule = { { -1.0f, 0.0f }, { 0.0f, 2.0f }, 0.5f };
	const record *r;
	int32_t k;
	must(cn_shape_create_circle(world, &def, &circle, NULL), world, "cn_shape_create_circle");
	must(cn_shape_create_capsule(world, &def, &capsule, NULL), world, "cn_shape_create_capsule");
	r = draw(world, CN_DRAW_SHAPES);
	REQUIRE(counts_are(r, 0, 1, 1, 0, 0, 0));
	for (k = 0; k < 2; ++k) {
		const mark *m = &r->mark[k];
		if (m->kind == CIRCLE) {
			CHECK(m->size == 0.25f);
			CHECK_LE("circle's centre", distance(m->points[0], 3.0, 3.0), 1e-5, "m");
			CHECK_LE("point on the rim", distance(m->points[1], 3.0, 3.25), 1e-5, "m");
		} else {
			CHECK(m->size == 0.5f);
			CHECK_LE("capsule's a", distance(m->points[0], 3.0, 1.0), 1e-5, "m");
			CHECK_LE("capsule's b", distance(m->points[1], 1.0, 2.0), 1e-5, "m");
		}
	}
	cn_world_destroy(world);
}

static void edges_and_chains_are_segments(void)
{
	cn_world *world = fixture_world(0.0f, 0);
	cn_shape_def def = fixture_shape_def(fixture_body(world, CN_BODY_STATIC, 0.0f, 10.0f, 0.0f), 0.6f, 0.0f);
	cn_edge edge = { { 0.0f, 0.0f }, { 2.0f, 1.0f } };
	cn_vec2 points[5] = { { 0.0f, 0.0f }, { 4.0f, 0.0f }, { 4.0f, 4.0f }, { 2.0f, 5.0f }, { 0.0f, 4.0f } };
	cn_chain chain = { points, 5, 0 };
	cn_shape shape;
	const record *r;
	must(cn_shape_create_edge(world, &def, &edge, &shape), world, "cn_shape_create_edge");
	r = draw(world, CN_DRAW_SHAPES);
	REQUIRE(counts_are(r, 0, 0, 0, 1, 0, 0));
	CHECK_LE("edge's a", distance(r->mark[0].points[0], 0.0, 10.0), 1e-5, "m");
	CHECK_LE("edge's b", distance(r->mark[0].points[1], 2.0, 11.0), 1e-5, "m");
	must(cn_shape_destroy(world, shape), world, "cn_shape_destroy");
	must(cn_shape_create_chain(world, &def, &chain, &shape), world, "cn_shape_create_chain");
	r = draw(world, CN_DRAW_SHAPES);
	CHECK(counts_are(r, 0, 0, 0, 4, 0, 0));
	must(cn_shape_destroy(world, shape), world, "cn_shape_destroy");
	chain.loop = 1;
	must(cn_shape_create_chain(world, &def, &chain, &shape), world, "cn_shape_create_chain");
	r = draw(world, CN_DRAW_SHAPES);
	REQUIRE(counts_are(r, 0, 0, 0, 5, 0, 0));
	CHECK_LE("last edge ends where the first begins", distance(r->mark[4].points[1], (double)r->mark[0].points[0].x, (double)r->mark[0].points[0].y), 0.0, "m");
	cn_world_destroy(world);
}

static void colours_tell_states_apart(void)
{
	cn_world *world = fixture_world(0.0f, 1);
	cn_body asleep;
	cn_shape_def def;
	cn_circle circle = { { 0.0f, 0.0f }, 0.5f };
	int32_t k, j;
	const record *r;
	fixture_circle(world, CN_BODY_STATIC, 0.0f, 0.0f, 0.5f, 0.6f, 0.0f);
	fixture_circle(world, CN_BODY_KINEMATIC, 5.0f, 0.0f, 0.5f, 0.6f, 0.0f);
	fixture_circle(world, CN_BODY_DYNAMIC, 10.0f, 0.0f, 0.5f, 0.6f, 0.0f);
	asleep = fixture_circle(world, CN_BODY_DYNAMIC, 15.0f, 0.0f, 0.5f, 0.6f, 0.0f);
	must(cn_body_set_awake(world, asleep, 0), world, "cn_body_set_awake");
	def = fixture_shape_def(fixture_body(world, CN_BODY_DYNAMIC, 20.0f, 0.0f, 0.0f), 0.6f, 0.0f);
	def.flags = CN_SHAPE_SENSOR;
	must(cn_shape_create_circle(world, &def, &circle, NULL), world, "cn_shape_create_circle");
	r = draw(world, CN_DRAW_SHAPES);
	REQUIRE(counts_are(r, 0, 5, 0, 0, 0, 0));
	for (k = 0; k < 5; ++k)
		for (j = 0; j < k; ++j)
			CHECK(r->mark[k].color != r->mark[j].color && r->mark[k].color <= 0xFFFFFFu);
	cn_world_destroy(world);
}

static void islands_have_colours_of_their_own(void)
{
	cn_world *world = fixture_world(-10.0f, 0);
	const record *r;
	int32_t k, plain = 0;
	uint32_t color[3];
	fixture_floor(world, 0.6f, 0.0f);
	for (k = 0; k < 2; ++k) { /* two stacks of two */
		fixture_box(world, CN_BODY_DYNAMIC, 5.0f * (float)k, 0.5f, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f);
		fixture_box(world, CN_BODY_DYNAMIC, 5.0f * (float)k, 1.5f, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f);
	}
	fixture_step(world, 5);
	r = draw(world, CN_DRAW_SHAPES | CN_DRAW_ISLANDS);
	REQUIRE(counts_are(r, 5, 0, 0, 0, 0, 0));
	CHECK(r->mark[1].color == r->mark[2].color && r->mark[3].color == r->mark[4].color);
	CHECK(r->mark[1].color != r->mark[3].color && r->mark[1].color <= 0xFFFFFFu);
	color[0] = r->mark[1].color;
	r = draw(world, CN_DRAW_SHAPES);
	for (k = 1; k < 5; ++k)
		plain += r->mark[k].color == r->mark[1].color && r->mark[k].color != color[0];
	CHECK(plain == 4);
	cn_world_destroy(world);
}

/* ---- boxes, centres, names ---- */

static void boxes_and_centres(void)
{
	cn_world *world = fixture_world(0.0f, 0);
	cn_body body = fixture_body(world, CN_BODY_DYNAMIC, 3.0f, 2.0f, 1.57079633f);
	cn_shape_def def = fixture_shape_def(body, 0.6f, 0.0f);
	cn_circle circle = { { 1.0f, 0.0f }, 0.25f };
	const record *r;
	double x0 = 9.0, y0 = 9.0, x1 = -9.0, y1 = -9.0;
	int32_t k;
	must(cn_shape_create_circle(world, &def, &circle, NULL), world, "cn_shape_create_circle");
	r = draw(world, CN_DRAW_AABBS);
	REQUIRE(counts_are(r, 0, 0, 0, 4, 0, 0));
	for (k = 0; k < 4; ++k) {
		x0 = fmin(x0, (double)r->mark[k].points[0].x);
		y0 = fmin(y0, (double)r->mark[k].points[0].y);
		x1 = greater(x1, (double)r->mark[k].points[0].x);
		y1 = greater(y1, (double)r->mark[k].points[0].y);
	}
	CHECK_LE("box error", fabs(x0 - 2.75) + fabs(y0 - 2.75) + fabs(x1 - 3.25) + fabs(y1 - 3.25), 1e-5, "m");
	r = draw(world, CN_DRAW_CENTERS);
	REQUIRE(counts_are(r, 0, 0, 0, 0, 1, 0));
	CHECK_LE("centre of mass", distance(r->mark[0].points[0], 3.0, 3.0), 1e-5, "m");
	must(cn_body_set_name(world, body, "left wheel"), world, "cn_body_set_name");
	r = draw(world, CN_DRAW_CENTERS);
	REQUIRE(counts_are(r, 0, 0, 0, 0, 1, 1));
	CHECK(strcmp(r->mark[1].text, "left wheel") == 0);
	CHECK(counts_are(draw(world, CN_DRAW_SHAPES), 0, 1, 0, 0, 0, 0));
	CHECK(counts_are(draw(world, 0), 0, 0, 0, 0, 0, 0));
	cn_world_destroy(world);
}

/* ---- joints, contacts ---- */

static int has_segment(const record *r, double ax, double ay, double bx, double by)
{
	int32_t k;
	for (k = 0; k < r->marks; ++k)
		if (r->mark[k].kind == SEGMENT && distance(r->mark[k].points[0], ax, ay) < 1e-5 && distance(r->mark[k].points[1], bx, by) < 1e-5)
			return 1;
	return 0;
}

static void joints_show_their_anchors(void)
{
	cn_world *world = fixture_world(0.0f, 0);
	cn_body a = fixture_circle(world, CN_BODY_DYNAMIC, 0.0f, 0.0f, 0.25f, 0.6f, 0.0f);
	cn_body b = fixture_circle(world, CN_BODY_DYNAMIC, 4.0f, 0.0f, 0.25f, 0.6f, 0.0f);
	cn_distance_def def;
	cn_joint joint = 0;
	const record *r;
	cn_distance_def_init(&def);
	def.base.body_a = a;
	def.base.body_b = b;
	def.base.anchor_a_m.y = 0.5f;
	def.base.anchor_b_m.y = -0.5f;
	def.length_m = 4.0f;
	must(cn_joint_create_distance(world, &def, &joint), world, "cn_joint_create_distance");
	r = draw(world, CN_DRAW_JOINTS);
	CHECK(counts_are(r, 0, 0, 0, 3, 2, 0));
	CHECK(has_segment(r, 0.0, 0.0, 0.0, 0.5));
	CHECK(has_segment(r, 4.0, 0.0, 4.0, -0.5));
	CHECK(has_segment(r, 0.0, 0.5, 4.0, -0.5));
	def.base.flags = CN_JOINT_LIMIT | CN_JOINT_SPRING;
	def.base.body_a = 0;
	def.base.anchor_a_m.x = 9.0f;
	def.length_max_m = 8.0f;
	must(cn_joint_create_distance(world, &def, &joint), world, "cn_joint_create_distance");
	r = draw(world, CN_DRAW_JOINTS); /* the world has no centre; one limit is nearer */
	CHECK(counts_are(r, 0, 0, 0, 3 + 3, 4, 0));
	CHECK(has_segment(r, 9.0, 0.5, 4.0, -0.5));
	cn_world_destroy(world);
}

static void constraints_are_drawn_with_joints(void)
{
	cn_world *world = fixture_world(0.0f, 0);
	cn_line_constraint_def def;
	cn_constraint constraint = 0;
	const record *r;
	cn_line_constraint_def_init(&def);
	def.body = fixture_circle(world, CN_BODY_DYNAMIC, 1.0f, 0.0f, 0.25f, 0.6f, 0.0f);
	must(cn_constraint_create_line(world, &def, &constraint), world, "cn_constraint_create_line");
	r = draw(world, CN_DRAW_JOINTS);
	CHECK(r->count[POINT] > 0 && r->count[SEGMENT] > 0 && r->count[CIRCLE] == 0);
	cn_world_destroy(world);
}

static void contacts_are_points_with_normals(void)
{
	cn_world *world = fixture_world(-10.0f, 0);
	const record *r;
	int32_t k, up = 0, left = 0, right = 0;
	fixture_floor(world, 0.6f, 0.0f);
	fixture_box(world, CN_BODY_DYNAMIC, 0.0f, 0.5f, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f);
	fixture_step(world, 30);
	r = draw(world, CN_DRAW_CONTACTS);
	REQUIRE(counts_are(r, 0, 0, 0, 2, 2, 0));
	for (k = 0; k < r->marks; ++k) {
		cn_vec2 p = r->mark[k].points[0], q = r->mark[k].points[1];
		if (r->mark[k].kind == POINT) {
			left += distance(p, -0.5, 0.0) < 0.01;
			right += distance(p, 0.5, 0.0) < 0.01;
		} else {
			up += fabs(fabs((double)q.y - (double)p.y) - 0.2) < 1e-3 && fabs((double)q.x - (double)p.x) < 1e-3;
		}
	}
	CHECK(left == 1 && right == 1 && up == 2);
	cn_world_destroy(world);
}

/* ---- view ---- */

static void only_what_overlaps_the_view_is_drawn(void)
{
	cn_world *world = fixture_world(-10.0f, 0);
	uint32_t all = CN_DRAW_SHAPES | CN_DRAW_JOINTS | CN_DRAW_CONTACTS | CN_DRAW_AABBS | CN_DRAW_CENTERS;
	cn_body ball;
	cn_distance_def def;
	cn_joint joint = 0;
	const record *r;
	int32_t everything;
	fixture_box(world, CN_BODY_STATIC, 0.0f, -1.0f, 0.0f, 2.0f, 1.0f, 0.6f, 0.0f);
	fixture_box(world, CN_BODY_DYNAMIC, 0.0f, 0.5f, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f);
	ball = fixture_circle(world, CN_BODY_DYNAMIC, 20.0f, 0.0f, 0.5f, 0.6f, 0.0f);
	must(cn_body_set_name(world, ball, "far"), world, "cn_body_set_name");
	cn_distance_def_init(&def);
	def.base.body_b = ball;
	def.base.anchor_a_m.x = 20.0f;
	def.base.anchor_a_m.y = 1.0f;
	must(cn_joint_create_distance(world, &def, &joint), world, "cn_joint_create_distance");
	fixture_step(world, 10);
	r = draw(world, all);
	everything = r->marks;
	CHECK(counts_are(r, 2, 1, 0, 4 * 3 + 2 + 2, 2 + 2 + 3, 1));
	r = draw_view(world, all, 18.0f, -3.0f, 22.0f, 3.0f); /* the ball and its rod */
	CHECK(counts_are(r, 0, 1, 0, 4 + 2, 2 + 1, 1));
	r = draw_view(world, all, -0.4f, 0.3f, 0.4f, 0.8f); /* within the box: its sides are not seen, the filled shape and the centre are */
	CHECK(counts_are(r, 1, 0, 0, 0, 1, 0));
	r = draw_view(world, all, 100.0f, 100.0f, 101.0f, 101.0f);
	CHECK_LE("drawn far away from everything", r->marks, 0, "");
	r = draw_view(world, all, -100.0f, -100.0f, 100.0f, 100.0f);
	CHECK(r->marks == everything);
	cn_world_destroy(world);
}

/* ---- robustness ---- */

static cn_world *full_world(void)
{
	cn_world *world = fixture_world(-10.0f, 1);
	cn_revolute_def def;
	cn_joint joint = 0;
	cn_body a = fixture_box(world, CN_BODY_DYNAMIC, 0.0f, 0.5f, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f);
	fixture_floor(world, 0.6f, 0.0f);
	cn_revolute_def_init(&def);
	def.base.body_a = a;
	def.base.body_b = fixture_circle(world, CN_BODY_DYNAMIC, 1.0f, 0.5f, 0.4f, 0.6f, 0.0f);
	def.base.anchor_a_m.x = 1.0f;
	must(cn_joint_create_revolute(world, &def, &joint), world, "cn_joint_create_revolute");
	must(cn_body_set_name(world, a, "a"), world, "cn_body_set_name");
	fixture_step(world, 20);
	return world;
}

static void functions_may_be_missing(void)
{
	cn_world *world = full_world();
	cn_debug_draw d;
	int32_t k;
	cn_debug_draw_init(&d);
	d.flags = 63u;
	CHECK(cn_world_draw(world, &d) == CN_OK); /* none at all */
	for (k = 0; k < KINDS; ++k) {
		int32_t j;
		d = draw_all(&drawn, 63u);
		if (k == POLYGON) d.polygon = NULL;
		if (k == CIRCLE) d.circle = NULL;
		if (k == CAPSULE) d.capsule = NULL;
		if (k == SEGMENT) d.segment = NULL;
		if (k == POINT) d.point = NULL;
		if (k == TEXT) d.text = NULL;
		CHECK(cn_world_draw(world, &d) == CN_OK);
		for (j = 0; j < KINDS; ++j)
			CHECK((drawn.count[j] == 0) == (j == k || j == CAPSULE));
	}
	cn_world_destroy(world);
}

static void bad_input_is_refused(void)
{
	cn_world *world = full_world();
	cn_debug_draw d = draw_all(&drawn, 63u);
	CHECK(cn_world_draw(NULL, &d) == CN_ERROR_ARGUMENT);
	CHECK(cn_world_draw(world, NULL) == CN_ERROR_ARGUMENT);
	d.flags = 1u << 6;
	CHECK(cn_world_draw(world, &d) == CN_ERROR_ARGUMENT);
	d.flags = 63u;
	d.struct_size = 0;
	CHECK(cn_world_draw(world, &d) == CN_ERROR_ARGUMENT);
	d.struct_size = (uint32_t)sizeof d;
	d.view.lower_m.x = NAN;
	CHECK(cn_world_draw(world, &d) == CN_ERROR_ARGUMENT);
	d.view.lower_m.x = 0.0f;
	d.view.upper_m.y = INFINITY;
	CHECK(cn_world_draw(world, &d) == CN_ERROR_ARGUMENT);
	CHECK_LE("drawn by refused calls", drawn.marks, 0, "");
	cn_debug_draw_init(NULL);
	cn_debug_draw_init(&d);
	CHECK(d.flags == (CN_DRAW_SHAPES | CN_DRAW_JOINTS | CN_DRAW_CONTACTS) && d.polygon == NULL && d.text == NULL);
	cn_world_destroy(world);
}

static void drawing_changes_nothing(void)
{
	cn_world *world = full_world(), *twin = full_world();
	uint64_t before = fixture_hash(world);
	int32_t k, different = 0;
	draw(world, 63u);
	CHECK(fixture_hash(world) == before);
	for (k = 0; k < 60; ++k) {
		draw(world, 63u);
		fixture_step(world, 1);
		fixture_step(twin, 1);
		different += fixture_hash(world) != fixture_hash(twin);
	}
	CHECK_LE("steps that differ from a world that is not drawn", different, 0, "");
	cn_world_destroy(world);
	cn_world_destroy(twin);
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(polygons_have_their_corners);
	RUN(circles_and_capsules_turn_with_the_body);
	RUN(edges_and_chains_are_segments);
	RUN(colours_tell_states_apart);
	RUN(islands_have_colours_of_their_own);
	RUN(boxes_and_centres);
	RUN(joints_show_their_anchors);
	RUN(constraints_are_drawn_with_joints);
	RUN(contacts_are_points_with_normals);
	RUN(only_what_overlaps_the_view_is_drawn);
	RUN(functions_may_be_missing);
	RUN(bad_input_is_refused);
	RUN(drawing_changes_nothing);
	return test_end();
}
