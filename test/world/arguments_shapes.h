/*
 * test/world/arguments_shapes.h - entries of arguments_test for shapes and contacts: good and bad calls of each function.
 * Included by arguments_test.c only, after its macros.
 */
#ifndef CAIRN_TEST_ARGUMENTS_SHAPES_H
#define CAIRN_TEST_ARGUMENTS_SHAPES_H

/* ---- shapes */

ENTRY(cn_shape_def_init, (cn_shape_def_init(&sd), CN_OK), cn_shape_def_init(NULL);)

static cn_result call_circle(const cn_shape_def *d) { return cn_shape_create_circle(W, d, &circle, OUT(cn_shape)); }
static cn_result call_capsule(const cn_shape_def *d) { return cn_shape_create_capsule(W, d, &capsule, OUT(cn_shape)); }
static cn_result call_edge(const cn_shape_def *d) { return cn_shape_create_edge(W, d, &edge, OUT(cn_shape)); }
static cn_result call_polygon(const cn_shape_def *d) { return cn_shape_create_polygon(W, d, &polygon, OUT(cn_shape)); }
static cn_result call_box(const cn_shape_def *d) { return cn_shape_create_box(W, d, 1.0f, 2.0f, 0.0f, OUT(cn_shape)); }
static cn_result call_chain(const cn_shape_def *d) { return cn_shape_create_chain(W, d, &chain, OUT(cn_shape)); }

static void bad_shape_defs(cn_result (*call)(const cn_shape_def *), int has_mass)
{
	reset();
	ARG(call(NULL));
	SIZES(x, call(SD(struct_size, x)));
	BODY_BUT_ZERO(h, call(SD(body, h)));
	POSITION(v, call(SD(offset_m, v)));
	ANGLE(x, call(SD(angle_rad, x)));
	NOT_NEGATIVE(x, call(SD(density_kgpm2, x)));
	RANGE(x, -0.1f, 101.0f, call(SD(material.static_friction, x)));
	RANGE(x, -0.1f, 0.61f, call(SD(material.dynamic_friction, x)));
	RANGE(x, -0.1f, 1.1f, call(SD(material.restitution, x)));
	FLAGS(x, CN_EVENT_KINDS, call(SD(event_mask, x)));
	if (has_mass) {
		ARG(call(SD(density_kgpm2, 1e30f)));
		ARG(call(SD(density_kgpm2, 1e-30f)));
	}
}

ENTRY(cn_shape_create_circle, cn_shape_create_circle(W, (reset(), &sd), &circle, NULL),
	bad_shape_defs(call_circle, 1); NOW(cn_shape_create_circle(NULL, &sd, &circle, OUT(cn_shape))); ARG(cn_shape_create_circle(W, &sd, NULL, OUT(cn_shape)));
	VECTOR(v, cn_shape_create_circle(W, &sd, CI(center_m, v), OUT(cn_shape))); POSITIVE(x, cn_shape_create_circle(W, &sd, CI(radius_m, x), OUT(cn_shape)));
	ARG(cn_shape_create_circle(W, &sd, CI(radius_m, 1e7f), OUT(cn_shape)));)
ENTRY(cn_shape_create_capsule, cn_shape_create_capsule(W, (reset(), &sd), &capsule, NULL),
	bad_shape_defs(call_capsule, 1); NOW(cn_shape_create_capsule(NULL, &sd, &capsule, OUT(cn_shape))); ARG(cn_shape_create_capsule(W, &sd, NULL, OUT(cn_shape)));
	VECTOR(v, cn_shape_create_capsule(W, &sd, CA(a_m, v), OUT(cn_shape))); VECTOR(v, cn_shape_create_capsule(W, &sd, CA(b_m, v), OUT(cn_shape)));
	POSITIVE(x, cn_shape_create_capsule(W, &sd, CA(radius_m, x), OUT(cn_shape))); ARG(cn_shape_create_capsule(W, &sd, CA(a_m, v2(0.4997f, 0.0f)), OUT(cn_shape)));)
ENTRY(cn_shape_create_edge, cn_shape_create_edge(W, (reset(), &sd), &edge, NULL),
	bad_shape_defs(call_edge, 0); NOW(cn_shape_create_edge(NULL, &sd, &edge, OUT(cn_shape))); ARG(cn_shape_create_edge(W, &sd, NULL, OUT(cn_shape)));
	VECTOR(v, cn_shape_create_edge(W, &sd, ED(a_m, v), OUT(cn_shape))); VECTOR(v, cn_shape_create_edge(W, &sd, ED(b_m, v), OUT(cn_shape)));
	ARG(cn_shape_create_edge(W, &sd, ED(a_m, v2(0.4997f, 0.0f)), OUT(cn_shape)));)
ENTRY(cn_shape_create_polygon, cn_shape_create_polygon(W, (reset(), &sd), &polygon, NULL),
	bad_shape_defs(call_polygon, 1); NOW(cn_shape_create_polygon(NULL, &sd, &polygon, OUT(cn_shape))); ARG(cn_shape_create_polygon(W, &sd, NULL, OUT(cn_shape)));
	INTEGER(x, 2, 17, cn_shape_create_polygon(W, &sd, PO(count, x), OUT(cn_shape))); NOT_NEGATIVE(x, cn_shape_create_polygon(W, &sd, PO(radius_m, x), OUT(cn_shape)));
	VECTOR(v, cn_shape_create_polygon(W, &sd, PO(points_m[2], v), OUT(cn_shape)));
	ARG(cn_shape_create_polygon(W, &sd, PO(points_m[2], v2(-0.4f, -0.4f)), OUT(cn_shape)));
	ARG(cn_shape_create_polygon(W, &sd, PO(points_m[2], v2(0.5f, -0.4997f)), OUT(cn_shape)));
	ARG(cn_shape_create_polygon(W, &sd, PO(points_m[2], v2(-0.5f, 0.501f)), OUT(cn_shape)));)
ENTRY(cn_shape_create_box, cn_shape_create_box(W, (reset(), &sd), 1.0f, 2.0f, 0.1f, NULL),
	bad_shape_defs(call_box, 1); NOW(cn_shape_create_box(NULL, &sd, 1.0f, 2.0f, 0.1f, OUT(cn_shape))); reset();
	POSITIVE(x, cn_shape_create_box(W, &sd, x, 2.0f, 0.1f, OUT(cn_shape))); POSITIVE(x, cn_shape_create_box(W, &sd, 1.0f, x, 0.1f, OUT(cn_shape)));
	NOT_NEGATIVE(x, cn_shape_create_box(W, &sd, 1.0f, 2.0f, x, OUT(cn_shape))); ARG(cn_shape_create_box(W, &sd, 1e-4f, 2.0f, 0.0f, OUT(cn_shape)));)
static const cn_chain *loop_of_two(void)
{
	reset();
	chain.loop = 1;
	chain.count = 2;
	return &chain;
}

ENTRY(cn_shape_create_chain, cn_shape_create_chain(W, (reset(), &sd), &chain, NULL),
	bad_shape_defs(call_chain, 0); NOW(cn_shape_create_chain(NULL, &sd, &chain, OUT(cn_shape))); ARG(cn_shape_create_chain(W, &sd, NULL, OUT(cn_shape)));
	ARG(cn_shape_create_chain(W, &sd, CH(points_m, NULL), OUT(cn_shape))); FLAGS(x, 1, cn_shape_create_chain(W, &sd, CH(loop, x), OUT(cn_shape)));
	INTEGER(x, 1, 65536, cn_shape_create_chain(W, &sd, CH(count, x), OUT(cn_shape))); VECTOR(v, cn_shape_create_chain(W, &sd, CP(3, v), OUT(cn_shape)));
	ARG(cn_shape_create_chain(W, &sd, CP(2, chain_points[1]), OUT(cn_shape)));
	ARG(cn_shape_create_chain(W, &sd, loop_of_two(), OUT(cn_shape)));)
#define CHANGE(name, shape, other, value, more) ENTRY(name, name(W, shape, (reset(), &value)), \
	reset(); NOW(name(NULL, shape, &value)); SHAPE(h, name(W, h, (reset(), &value))); ARG(name(W, shape, NULL)); STATE(name(W, other, (reset(), &value))); more)
CHANGE(cn_shape_set_circle, f.ball_shape, f.box_shape, circle, POSITIVE(x, cn_shape_set_circle(W, f.ball_shape, CI(radius_m, x)));
	VECTOR(v, cn_shape_set_circle(W, f.ball_shape, CI(center_m, v)));)
CHANGE(cn_shape_set_capsule, f.pill_shape, f.ball_shape, capsule, ARG(cn_shape_set_capsule(W, f.pill_shape, CA(radius_m, 0.0f)));
	VECTOR(v, cn_shape_set_capsule(W, f.pill_shape, CA(b_m, v)));)
CHANGE(cn_shape_set_edge, f.edge, f.chain, edge, VECTOR(v, cn_shape_set_edge(W, f.edge, ED(a_m, v)));)
CHANGE(cn_shape_set_polygon, f.box_shape, f.edge, polygon, INTEGER(x, 2, 17, cn_shape_set_polygon(W, f.box_shape, PO(count, x)));
	NOT_NEGATIVE(x, cn_shape_set_polygon(W, f.box_shape, PO(radius_m, x))); ARG(cn_shape_set_polygon(W, f.box_shape, PO(points_m[2], v2(0.5f, -0.4997f))));)
CHANGE(cn_shape_set_chain, f.chain, f.edge, chain, INTEGER(x, 1, 65536, cn_shape_set_chain(W, f.chain, CH(count, x)));
	VECTOR(v, cn_shape_set_chain(W, f.chain, CP(3, v))); ARG(cn_shape_set_chain(W, f.chain, CP(2, chain_points[1]))); ARG(cn_shape_set_chain(W, f.chain, loop_of_two()));)
ENTRY(cn_shape_attach, cn_shape_attach(W, f.loose, f.pill),
	NOW(cn_shape_attach(NULL, f.loose, f.pill)); SHAPE(h, cn_shape_attach(W, h, f.pill)); BODY(h, cn_shape_attach(W, f.loose, h));
	STATE(cn_shape_attach(W, f.box_shape, f.pill)); STATE(cn_shape_attach(W, f.box_shape, f.box));)
ENTRY(cn_shape_detach, cn_shape_detach(W, f.box_shape),
	NOW(cn_shape_detach(NULL, f.box_shape)); SHAPE(h, cn_shape_detach(W, h)); STATE(cn_shape_detach(W, f.loose));)
ENTRY(cn_shape_destroy, cn_shape_destroy(W, f.ground_shape), NOW(cn_shape_destroy(NULL, f.box_shape)); SHAPE(h, cn_shape_destroy(W, h));)
ENTRY(cn_shape_is_valid, cn_shape_is_valid(W, f.loose) ? CN_OK : -1,
	int k; CHECK(cn_shape_is_valid(NULL, f.loose) == 0); for (k = 0; k < f.bad_shape_count; ++k) CHECK(cn_shape_is_valid(W, f.bad_shapes[k]) == 0);)
GETTER(cn_shape_get_type, SHAPE, f.loose, int32_t)
GETTER(cn_shape_get_body, SHAPE, f.loose, cn_body)
ENTRY(cn_shape_set_material, cn_shape_set_material(W, f.box_shape, (reset(), &material)),
	NOW(cn_shape_set_material(NULL, f.box_shape, &material)); SHAPE(h, cn_shape_set_material(W, h, (reset(), &material)));
	ARG(cn_shape_set_material(W, f.box_shape, NULL)); RANGE(x, -0.1f, 101.0f, cn_shape_set_material(W, f.box_shape, MA(static_friction, x)));
	RANGE(x, -0.1f, 0.51f, cn_shape_set_material(W, f.box_shape, MA(dynamic_friction, x)));
	RANGE(x, -0.1f, 1.1f, cn_shape_set_material(W, f.box_shape, MA(restitution, x)));)
GETTER(cn_shape_get_material, SHAPE, f.box_shape, cn_material)
ENTRY(cn_shape_set_density, cn_shape_set_density(W, f.box_shape, 3.0f),
	NOW(cn_shape_set_density(NULL, f.box_shape, 3.0f)); SHAPE(h, cn_shape_set_density(W, h, 3.0f)); NOT_NEGATIVE(x, cn_shape_set_density(W, f.box_shape, x));
	ARG(cn_shape_set_density(W, f.box_shape, 1e30f)); ARG(cn_shape_set_density(W, f.box_shape, 1e-30f));)
GETTER(cn_shape_get_density, SHAPE, f.box_shape, float)
ENTRY(cn_shape_set_filter, cn_shape_set_filter(W, f.box_shape, (reset(), &filter)),
	NOW(cn_shape_set_filter(NULL, f.box_shape, &filter)); SHAPE(h, cn_shape_set_filter(W, h, (reset(), &filter))); ARG(cn_shape_set_filter(W, f.box_shape, NULL));)
GETTER(cn_shape_get_filter, SHAPE, f.box_shape, cn_filter)
ENTRY(cn_shape_set_event_mask, cn_shape_set_event_mask(W, f.box_shape, 3),
	NOW(cn_shape_set_event_mask(NULL, f.box_shape, 3)); SHAPE(h, cn_shape_set_event_mask(W, h, 3)); FLAGS(x, CN_EVENT_KINDS, cn_shape_set_event_mask(W, f.box_shape, x));)
GETTER(cn_shape_get_event_mask, SHAPE, f.box_shape, uint32_t)
ENTRY(cn_shape_set_user_data, cn_shape_set_user_data(W, f.box_shape, 3), NOW(cn_shape_set_user_data(NULL, f.box_shape, 3)); SHAPE(h, cn_shape_set_user_data(W, h, 3));)
GETTER(cn_shape_get_user_data, SHAPE, f.box_shape, uint64_t)
GETTER(cn_shape_get_aabb, SHAPE, f.box_shape, cn_aabb)
GETTER(cn_shape_get_mass_data, SHAPE, f.box_shape, cn_mass_data)
#define GEOMETRY_GETTER(name, shape, other, T) ENTRY(name, name(W, shape, OUT(T)), \
	NOW(name(NULL, shape, OUT(T))); SHAPE(h, name(W, h, OUT(T))); ARG(name(W, shape, NULL)); STATE(name(W, other, OUT(T)));)
GEOMETRY_GETTER(cn_shape_get_circle, f.ball_shape, f.box_shape, cn_circle)
GEOMETRY_GETTER(cn_shape_get_capsule, f.pill_shape, f.ball_shape, cn_capsule)
GEOMETRY_GETTER(cn_shape_get_edge, f.edge, f.chain, cn_edge)
GEOMETRY_GETTER(cn_shape_get_polygon, f.box_shape, f.edge, cn_polygon)
ENTRY(cn_shape_get_chain_points, cn_shape_get_chain_points(W, f.chain, OUT(cn_vec2) + 4, 3, INT),
	NOW(cn_shape_get_chain_points(NULL, f.chain, OUT(cn_vec2) + 4, 3, INT)); SHAPE(h, cn_shape_get_chain_points(W, h, OUT(cn_vec2) + 4, 3, INT));
	ARG(cn_shape_get_chain_points(W, f.chain, NULL, 3, INT)); ARG(cn_shape_get_chain_points(W, f.chain, OUT(cn_vec2) + 4, -1, INT));
	ARG(cn_shape_get_chain_points(W, f.chain, OUT(cn_vec2) + 4, 3, NULL)); STATE(cn_shape_get_chain_points(W, f.edge, OUT(cn_vec2) + 4, 3, INT));)
ENTRY(cn_shape_test_point, cn_shape_test_point(W, f.box_shape, 0.0f, 0.0f, INT),
	NOW(cn_shape_test_point(NULL, f.box_shape, 0.0f, 0.0f, INT)); SHAPE(h, cn_shape_test_point(W, h, 0.0f, 0.0f, INT));
	VECTOR(v, cn_shape_test_point(W, f.box_shape, v.x, v.y, INT)); ARG(cn_shape_test_point(W, f.box_shape, 0.0f, 0.0f, NULL));)

static const cn_vec2 *hull_points(int kind, cn_vec2 last)
{
	static cn_vec2 p[4];
	p[0] = v2(0.0f, 0.0f);
	p[1] = v2(1.0f, 0.0f);
	p[2] = kind == 1 ? v2(2.0f, 0.0f) : kind == 2 ? p[1] : v2(1.0f, 1.0f);
	p[3] = kind != 0 ? p[0] : last;
	return p;
}
#define GOOD_POINTS hull_points(0, v2(0.0f, 1.0f))
ENTRY(cn_polygon_make_hull, cn_polygon_make_hull(GOOD_POINTS, 4, 0.0f, OUT(cn_polygon)),
	ARG(cn_polygon_make_hull(NULL, 4, 0.0f, OUT(cn_polygon))); ARG(cn_polygon_make_hull(GOOD_POINTS, 4, 0.0f, NULL));
	INTEGER(x, 0, 65537, cn_polygon_make_hull(GOOD_POINTS, x, 0.0f, OUT(cn_polygon))); ARG(cn_polygon_make_hull(GOOD_POINTS, 2, 0.0f, OUT(cn_polygon)));
	NOT_NEGATIVE(x, cn_polygon_make_hull(GOOD_POINTS, 4, x, OUT(cn_polygon))); POSITION(v, cn_polygon_make_hull(hull_points(0, v), 4, 0.0f, OUT(cn_polygon)));
	ARG(cn_polygon_make_hull(hull_points(1, v2(0.0f, 0.0f)), 4, 0.0f, OUT(cn_polygon)));
	ARG(cn_polygon_make_hull(hull_points(2, v2(0.0f, 0.0f)), 4, 0.0f, OUT(cn_polygon)));)
#define DECOMPOSE(points, count) cn_outline_decompose(points, count, 1.0f, OUT(cn_polygon), 2, OUT(int32_t) + 100)
ENTRY(cn_outline_decompose, DECOMPOSE(GOOD_POINTS, 4),
	ARG(DECOMPOSE(NULL, 4)); INTEGER(x, 2, 1025, DECOMPOSE(GOOD_POINTS, x)); POSITION(v, DECOMPOSE(hull_points(0, v), 4));
	ARG(DECOMPOSE(hull_points(1, v2(0.0f, 0.0f)), 4)); ARG(DECOMPOSE(hull_points(0, v2(0.9f, -1.0f)), 4));
	RANGE(x, 0.0f, 1.1e6f, cn_outline_decompose(GOOD_POINTS, 4, x, OUT(cn_polygon), 2, OUT(int32_t) + 100));
	ARG(cn_outline_decompose(GOOD_POINTS, 4, 1.0f, NULL, 2, OUT(int32_t) + 100));
	ARG(cn_outline_decompose(GOOD_POINTS, 4, 1.0f, OUT(cn_polygon), -1, OUT(int32_t) + 100));
	ARG(cn_outline_decompose(GOOD_POINTS, 4, 1.0f, OUT(cn_polygon), 2, NULL));)
#define SIMPLIFY(points, count, closed) cn_outline_simplify(points, count, closed, 0.1f, OUT(cn_vec2), 4, OUT(int32_t) + 100)
ENTRY(cn_outline_simplify, SIMPLIFY(GOOD_POINTS, 4, 1),
	ARG(SIMPLIFY(NULL, 4, 1)); INTEGER(x, 2, 65537, SIMPLIFY(GOOD_POINTS, x, 1)); INTEGER(x, 1, 65537, SIMPLIFY(GOOD_POINTS, x, 0));
	INTEGER(x, -1, 2, SIMPLIFY(GOOD_POINTS, 4, x)); POSITION(v, SIMPLIFY(hull_points(0, v), 4, 1));
	NOT_NEGATIVE(x, cn_outline_simplify(GOOD_POINTS, 4, 1, x, OUT(cn_vec2), 4, OUT(int32_t) + 100));
	ARG(cn_outline_simplify(GOOD_POINTS, 4, 1, 0.1f, NULL, 4, OUT(int32_t) + 100));
	ARG(cn_outline_simplify(GOOD_POINTS, 4, 1, 0.1f, OUT(cn_vec2), -1, OUT(int32_t) + 100));
	ARG(cn_outline_simplify(GOOD_POINTS, 4, 1, 0.1f, OUT(cn_vec2), 4, NULL));)
static const uint8_t good_cells[4] = { 1, 0, 1, 1 };
static cn_result cells_at(int32_t count, int32_t columns, cn_vec2 origin, float side)
{
	return cn_outline_from_cells(good_cells, count, columns, origin.x, origin.y, side, 0, OUT(cn_vec2), 8, OUT(int32_t) + 100);
}
static cn_result cells_to(const uint8_t *cells, int32_t first, cn_vec2 *out, int32_t capacity, int32_t *a)
{
	return cn_outline_from_cells(cells, 4, 2, 0.0f, 0.0f, 1.0f, first, out, capacity, a);
}
ENTRY(cn_outline_from_cells, cells_at(4, 2, v2(0.0f, 0.0f), 1.0f),
	INTEGER(x, 1, 8194, cells_at(x, 2, v2(0.0f, 0.0f), 1.0f)); INTEGER(x, 0, 4097, cells_at(4, x, v2(0.0f, 0.0f), 1.0f));
	ARG(cells_at(4, 3, v2(0.0f, 0.0f), 1.0f)); POSITION(v, cells_at(4, 2, v, 1.0f));
	ARG(cells_at(4, 2, v2(9.9e5f, 0.0f), 1e4f)); ARG(cells_at(4, 2, v2(0.0f, 9.9e5f), 1e4f));
	POSITIVE(x, cells_at(4, 2, v2(0.0f, 0.0f), x)); ARG(cells_at(4, 2, v2(0.0f, 0.0f), 6e5f));
	ARG(cells_to(NULL, 0, OUT(cn_vec2), 8, OUT(int32_t) + 100));
	ARG(cells_to(good_cells, -1, OUT(cn_vec2), 8, OUT(int32_t) + 100));
	ARG(cells_to(good_cells, 0, NULL, 8, OUT(int32_t) + 100));
	ARG(cells_to(good_cells, 0, OUT(cn_vec2), -1, OUT(int32_t) + 100));
	ARG(cells_to(good_cells, 0, OUT(cn_vec2), 8, NULL));)
static const float *field_with(float last)
{
	static float values[4] = { 1.0f, 0.0f, 1.0f, 1.0f };
	values[3] = last;
	return values;
}
static cn_result field_at(const float *values, int32_t count, int32_t columns, float threshold, cn_vec2 origin, float spacing)
{
	return cn_outline_from_field(values, count, columns, threshold, origin.x, origin.y, spacing, 0, OUT(cn_vec2), 8, OUT(int32_t) + 100);
}
static cn_result field_to(int32_t first, cn_vec2 *out, int32_t capacity, int32_t *a)
{
	return cn_outline_from_field(field_with(1.0f), 4, 2, 0.5f, 0.0f, 0.0f, 1.0f, first, out, capacity, a);
}
ENTRY(cn_outline_from_field, field_at(field_with(1.0f), 4, 2, 0.5f, v2(0.0f, 0.0f), 1.0f),
	ARG(field_at(NULL, 4, 2, 0.5f, v2(0.0f, 0.0f), 1.0f)); FLOAT(x, field_at(field_with(x), 4, 2, 0.5f, v2(0.0f, 0.0f), 1.0f));
	INTEGER(x, 2, 8194, field_at(field_with(1.0f), x, 2, 0.5f, v2(0.0f, 0.0f), 1.0f));
	INTEGER(x, 1, 4097, field_at(field_with(1.0f), 4, x, 0.5f, v2(0.0f, 0.0f), 1.0f));
	FLOAT(x, field_at(field_with(1.0f), 4, 2, x, v2(0.0f, 0.0f), 1.0f)); POSITION(v, field_at(field_with(1.0f), 4, 2, 0.5f, v, 1.0f));
	POSITIVE(x, field_at(field_with(1.0f), 4, 2, 0.5f, v2(0.0f, 0.0f), x)); ARG(field_at(field_with(1.0f), 4, 2, 0.5f, v2(0.0f, 0.0f), 6e5f));
	ARG(field_to(-1, OUT(cn_vec2), 8, OUT(int32_t) + 100));
	ARG(field_to(0, NULL, 8, OUT(int32_t) + 100));
	ARG(field_to(0, OUT(cn_vec2), -1, OUT(int32_t) + 100));
	ARG(field_to(0, OUT(cn_vec2), 8, NULL));)
ENTRY(cn_polygon_make_box, cn_polygon_make_box(1.0f, 2.0f, 3.0f, 4.0f, 0.5f, 0.1f, OUT(cn_polygon)),
	POSITIVE(x, cn_polygon_make_box(x, 2.0f, 3.0f, 4.0f, 0.5f, 0.1f, OUT(cn_polygon)));
	POSITIVE(x, cn_polygon_make_box(1.0f, x, 3.0f, 4.0f, 0.5f, 0.1f, OUT(cn_polygon)));
	POSITION(v, cn_polygon_make_box(1.0f, 2.0f, v.x, v.y, 0.5f, 0.1f, OUT(cn_polygon)));
	ANGLE(x, cn_polygon_make_box(1.0f, 2.0f, 3.0f, 4.0f, x, 0.1f, OUT(cn_polygon)));
	NOT_NEGATIVE(x, cn_polygon_make_box(1.0f, 2.0f, 3.0f, 4.0f, 0.5f, x, OUT(cn_polygon)));
	ARG(cn_polygon_make_box(1.0f, 2.0f, 3.0f, 4.0f, 0.5f, 0.1f, NULL));)

/* ---- contacts */

static void ignore_event(cn_world *world, const cn_contact_event *event, void *user)
{
	(void)world;
	(void)event;
	(void)user;
}

#define EVENTS OUT(const cn_contact_event *)
ENTRY(cn_world_contact_events, cn_world_contact_events(W, CN_EVENT_STAY, EVENTS, INT + 8),
	NOW(cn_world_contact_events(NULL, 1, EVENTS, INT + 8)); INTEGER(x, -1, CN_EVENT_KINDS, cn_world_contact_events(W, x, EVENTS, INT + 8));
	ARG(cn_world_contact_events(W, 1, NULL, INT + 8)); ARG(cn_world_contact_events(W, 1, EVENTS, NULL));)
ENTRY(cn_world_set_contact_callback, cn_world_set_contact_callback(W, CN_EVENT_LEAVE, ignore_event, NULL),
	NOW(cn_world_set_contact_callback(NULL, 1, NULL, NULL)); INTEGER(x, -1, CN_EVENT_KINDS, cn_world_set_contact_callback(W, x, ignore_event, NULL));)
HANDLE_LIST(cn_body_get_contacts, BODY, f.box, cn_contact_event)
HANDLE_LIST(cn_shape_get_contacts, SHAPE, f.box_shape, cn_contact_event)
ENTRY(cn_shape_get_visitors, (cn_shape_set_flags(W, f.ball_shape, CN_SHAPE_SENSOR), cn_shape_get_visitors(W, f.ball_shape, OUT(cn_shape) + 4, 8, INT)),
	NOW(cn_shape_get_visitors(NULL, f.ball_shape, OUT(cn_shape) + 4, 8, INT)); SHAPE(h, cn_shape_get_visitors(W, h, OUT(cn_shape) + 4, 8, INT));
	STATE(cn_shape_get_visitors(W, f.ball_shape, OUT(cn_shape) + 4, 8, INT)); ARG(cn_shape_get_visitors(W, f.ball_shape, NULL, 1, INT));
	ARG(cn_shape_get_visitors(W, f.ball_shape, OUT(cn_shape) + 4, -1, INT)); ARG(cn_shape_get_visitors(W, f.ball_shape, OUT(cn_shape) + 4, 8, NULL));)
ARRAY_GETTER(cn_world_fell_asleep, cn_body)

#endif
