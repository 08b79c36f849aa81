/*
 * examples/demo/draw.c - shapes of bodies, then joints and constraints (draw_joint.c), then contacts, each
 * list read once a picture.
 */
#include "demo/draw_paint.h"
#include <math.h>
#include <stdlib.h>

const canvas_color draw_colors[DRAW_COLORS] = {0xfaf9f5, 0x2d3138, 0xa4a9b0, 0xdfe1e3, 0xa67fd0, 0xf2a33c, 0x8fb4dc, 0xd6263b, 0x1d8a5a, 0x1f66c7, 0xb0459b,
	0xf4b04f, 0x5b9bd5, 0x7cb66b, 0xe2725b, 0xf0cf65, 0x9a86c8, 0x57b5ae, 0xd987a9};

draw_view draw_fit(const canvas *c, const cn_aabb *box_m)
{
	draw_view view;
	view.lower_m = box_m->lower_m;
	view.scale = (float)c->width / (box_m->upper_m.x - box_m->lower_m.x);
	return view;
}

canvas_point draw_to_picture(const painter *p, cn_vec2 point_m)
{
	canvas_point out;
	out.x = (point_m.x - p->view->lower_m.x) * p->view->scale;
	out.y = (float)p->c->height - (point_m.y - p->view->lower_m.y) * p->view->scale;
	return out;
}

static canvas_point local_to_picture(const painter *p, cn_vec2 local_m)
{
	cn_vec2 world_m;
	world_m.x = p->pose.position_m.x + p->pose.cosine * local_m.x - p->pose.sine * local_m.y;
	world_m.y = p->pose.position_m.y + p->pose.sine * local_m.x + p->pose.cosine * local_m.y;
	return draw_to_picture(p, world_m);
}

/* Half of a colour and half of the background. */
static canvas_color pale(canvas_color color) { return ((color & 0xFEFEFEu) >> 1) + ((draw_colors[DRAW_BACKGROUND] & 0xFEFEFEu) >> 1); }

/* Neighbouring numbers get different colours. */
static canvas_color color_of(uint32_t number) { return draw_colors[DRAW_BODY + (number * 2654435761u >> 29)]; }

static canvas_color dynamic_color(const painter *p, cn_body body, int32_t awake)
{
	static const canvas_color tiers[3] = {0xf2a33c, 0x1f66c7, 0xdfe1e3}; /* soft, direct, free */
	if (p->groups != NULL) {
		int32_t group = p->groups[DRAW_SLOT(body)];
		if (group < 0)
			return draw_colors[DRAW_SOLID_SIDE];
		return p->show & DRAW_SHOW_TIERS ? tiers[group % 3] : color_of((uint32_t)group);
	}
	if (p->show & DRAW_SHOW_BODIES)
		return awake ? color_of(DRAW_SLOT(body)) : pale(color_of(DRAW_SLOT(body)));
	return draw_colors[awake ? DRAW_AWAKE : DRAW_ASLEEP];
}

static canvas_color body_color(const painter *p, cn_body body)
{
	int32_t type = CN_BODY_STATIC;
	uint32_t flags = 0;
	cn_body_get_type(p->world, body, &type);
	cn_body_get_flags(p->world, body, &flags);
	if (type == CN_BODY_STATIC)
		return draw_colors[DRAW_STATIC];
	if (type == CN_BODY_KINEMATIC)
		return draw_colors[DRAW_KINEMATIC];
	return dynamic_color(p, body, (flags & CN_BODY_AWAKE) != 0);
}

/* ------------------------------------------------------------------ shapes */

static float outline_for(const painter *p, float size_m)
{
	float px = 0.12f * size_m * p->view->scale;
	return px > 1.1f ? 1.1f : px;
}

static void draw_circle(painter *p, cn_shape shape)
{
	cn_circle circle;
	if (cn_shape_get_circle(p->world, shape, &circle) != CN_OK)
		return;
	float radius = circle.radius_m * p->view->scale, outline = outline_for(p, 2.0f * circle.radius_m);
	cn_vec2 rim = circle.center_m;
	rim.x += 0.85f * circle.radius_m;
	canvas_point center = local_to_picture(p, circle.center_m);
	canvas_disc(p->c, center, radius, p->fill, p->outline, outline);
	canvas_line(p->c, center, local_to_picture(p, rim), outline, p->outline);
}

static void draw_capsule(painter *p, cn_shape shape)
{
	cn_capsule capsule;
	if (cn_shape_get_capsule(p->world, shape, &capsule) != CN_OK)
		return;
	canvas_capsule(p->c, local_to_picture(p, capsule.a_m), local_to_picture(p, capsule.b_m), capsule.radius_m * p->view->scale, p->fill,
		p->outline, outline_for(p, 2.0f * capsule.radius_m));
}

static void draw_polygon(painter *p, cn_shape shape)
{
	cn_polygon polygon;
	canvas_point points[CN_POLYGON_MAX_VERTICES];
	if (cn_shape_get_polygon(p->world, shape, &polygon) != CN_OK)
		return;
	float dx = polygon.points_m[1].x - polygon.points_m[0].x, dy = polygon.points_m[1].y - polygon.points_m[0].y;
	for (int32_t i = 0; i < polygon.count; ++i)
		points[i] = local_to_picture(p, polygon.points_m[i]);
	canvas_polygon(p->c, points, polygon.count, polygon.radius_m * p->view->scale, p->fill, p->outline,
		outline_for(p, sqrtf(dx * dx + dy * dy)));
}

static void draw_edge(painter *p, cn_shape shape)
{
	cn_edge edge;
	if (cn_shape_get_edge(p->world, shape, &edge) == CN_OK)
		canvas_line(p->c, local_to_picture(p, edge.a_m), local_to_picture(p, edge.b_m), 2.0f, draw_colors[DRAW_OUTLINE]);
}

/* The band on the left of the direction of travel, which is the solid side. */
static void draw_solid_side(painter *p, canvas_point a, canvas_point b)
{
	const float depth_px = 7.0f;
	float ex = b.x - a.x, ey = b.y - a.y, length = sqrtf(ex * ex + ey * ey);
	if (length <= 0.0f)
		return;
	float nx = depth_px * ey / length, ny = -depth_px * ex / length;
	canvas_point band[4] = {a, b, {b.x + nx, b.y + ny}, {a.x + nx, a.y + ny}};
	canvas_polygon(p->c, band, 4, 0.0f, draw_colors[DRAW_SOLID_SIDE], 0, 0.0f);
}

static void draw_chain_edges(painter *p, const cn_vec2 *points, int32_t count, int32_t loop)
{
	int32_t edges = loop ? count : count - 1;
	for (int32_t i = 0; i < edges; ++i)
		draw_solid_side(p, local_to_picture(p, points[i]), local_to_picture(p, points[(i + 1) % count]));
	for (int32_t i = 0; i < edges; ++i)
		canvas_line(p->c, local_to_picture(p, points[i]), local_to_picture(p, points[(i + 1) % count]), 1.6f, draw_colors[DRAW_OUTLINE]);
}

/* The API does not say whether a chain is a loop: a loop is drawn when its ends are near each other. */
static int32_t draw_chain(painter *p, cn_shape shape)
{
	int32_t count = 0;
	if (cn_shape_get_chain_points(p->world, shape, NULL, 0, &count) != CN_OK || count < 2)
		return 1;
	cn_vec2 *points = (cn_vec2 *)malloc((size_t)count * sizeof *points);
	if (points == NULL)
		return 0;
	if (cn_shape_get_chain_points(p->world, shape, points, count, &count) == CN_OK) {
		cn_vec2 first = points[0], second = points[1], last = points[count - 1];
		float step = hypotf(second.x - first.x, second.y - first.y), gap = hypotf(last.x - first.x, last.y - first.y);
		draw_chain_edges(p, points, count, count > 2 && gap < 2.0f * step);
	}
	free(points);
	return 1;
}

/* An arrow to the solid side, for a shape that is not turned on its body: its own angle cannot be read back. */
static void draw_one_way(painter *p, cn_shape shape)
{
	cn_mass_data mass;
	if (cn_shape_get_mass_data(p->world, shape, &mass) != CN_OK)
		return;
	const float offsets[4][2] = {{0.0f, -0.12f}, {0.0f, 0.22f}, {-0.08f, 0.12f}, {0.08f, 0.12f}};
	canvas_point points[4];
	for (int32_t i = 0; i < 4; ++i) {
		cn_vec2 point = mass.center_m;
		point.x += offsets[i][0];
		point.y += offsets[i][1];
		points[i] = local_to_picture(p, point);
	}
	canvas_line(p->c, points[0], points[1], 1.2f, draw_colors[DRAW_LIMIT]);
	canvas_line(p->c, points[2], points[1], 1.2f, draw_colors[DRAW_LIMIT]);
	canvas_line(p->c, points[3], points[1], 1.2f, draw_colors[DRAW_LIMIT]);
}

static void draw_box(painter *p, cn_shape shape)
{
	cn_aabb box;
	if (cn_shape_get_aabb(p->world, shape, &box) != CN_OK)
		return;
	for (int32_t i = 0; i < 4; ++i) {
		cn_vec2 a = {i == 0 || i == 3 ? box.lower_m.x : box.upper_m.x, i < 2 ? box.lower_m.y : box.upper_m.y};
		cn_vec2 b = {i < 2 ? box.upper_m.x : box.lower_m.x, i == 1 || i == 2 ? box.upper_m.y : box.lower_m.y};
		canvas_line(p->c, draw_to_picture(p, a), draw_to_picture(p, b), 0.8f, draw_colors[DRAW_LIMIT]);
	}
}

static int32_t draw_shape(painter *p, cn_shape shape)
{
	int32_t type = -1;
	cn_shape_get_type(p->world, shape, &type);
	switch (type) {
	case CN_SHAPE_CIRCLE: draw_circle(p, shape); break;
	case CN_SHAPE_CAPSULE: draw_capsule(p, shape); break;
	case CN_SHAPE_POLYGON: draw_polygon(p, shape); break;
	case CN_SHAPE_EDGE: draw_edge(p, shape); break;
	case CN_SHAPE_CHAIN: return draw_chain(p, shape);
	default: break;
	}
	return 1;
}

/* ------------------------------------------------------------------ lists */

/* Sensors are outlines, drawn first so that they hide nothing. */
static int32_t draw_attached(painter *p, cn_shape shape, int32_t sensors)
{
	cn_body body = 0;
	uint32_t flags = 0;
	if (cn_shape_get_body(p->world, shape, &body) != CN_OK || body == 0)
		return 1;
	cn_shape_get_flags(p->world, shape, &flags);
	if (((flags & CN_SHAPE_SENSOR) != 0) != sensors)
		return 1;
	cn_body_get_pose(p->world, body, &p->pose);
	p->fill = sensors ? draw_colors[DRAW_BACKGROUND] : body_color(p, body);
	p->outline = draw_colors[sensors ? DRAW_SENSOR : DRAW_OUTLINE];
	int32_t good = draw_shape(p, shape);
	if (flags & CN_SHAPE_ONE_WAY)
		draw_one_way(p, shape);
	if (p->show & DRAW_SHOW_BOXES)
		draw_box(p, shape);
	return good;
}

static int32_t draw_shapes(painter *p)
{
	int32_t count = 0, good = 1;
	cn_world_get_shapes(p->world, NULL, 0, &count);
	cn_shape *shapes = (cn_shape *)malloc((size_t)(count + 1) * sizeof *shapes);
	if (shapes == NULL)
		return 0;
	cn_world_get_shapes(p->world, shapes, count, &count);
	for (int32_t i = 0; i < count && good; ++i)
		good = draw_attached(p, shapes[i], 1);
	for (int32_t i = 0; i < count && good; ++i)
		good = draw_attached(p, shapes[i], 0);
	free(shapes);
	return good;
}

float draw_dot_px(const painter *p)
{
	float px = 0.07f * p->view->scale;
	return px < 0.6f ? 0.6f : (px > 1.3f ? 1.3f : px);
}

/* Normals only where there is room for them. */
static void draw_contact(painter *p, const cn_contact_event *contact)
{
	float scale = p->view->scale, dot = draw_dot_px(p), normal_px = scale > 16.0f ? 4.5f : 0.0f;
	for (int32_t i = 0; i < contact->manifold.point_count; ++i) {
		canvas_point at = draw_to_picture(p, contact->manifold.points[i].point_m), tip = at;
		if (contact->manifold.points[i].separation_m > 0.005f)
			continue; /* near, but not touching */
		tip.x += normal_px * contact->manifold.normal.x;
		tip.y -= normal_px * contact->manifold.normal.y;
		if (normal_px > 0.0f)
			canvas_line(p->c, at, tip, 0.8f, draw_colors[DRAW_CONTACT]);
		canvas_disc(p->c, at, dot, draw_colors[DRAW_CONTACT], 0, 0.0f);
	}
}

/* Every contact is in two bodies' lists and drawn from the one of its body a. */
static int32_t draw_body_contacts(painter *p, cn_body body)
{
	int32_t count = 0;
	if (cn_body_get_contacts(p->world, body, NULL, 0, &count) != CN_OK || count == 0)
		return 1;
	cn_contact_event *contacts = (cn_contact_event *)malloc((size_t)count * sizeof *contacts);
	if (contacts == NULL)
		return 0;
	cn_body_get_contacts(p->world, body, contacts, count, &count);
	for (int32_t i = 0; i < count; ++i) {
		if (contacts[i].body_a == body)
			draw_contact(p, &contacts[i]);
	}
	free(contacts);
	return 1;
}

static int32_t draw_contacts(painter *p)
{
	int32_t count = 0, good = 1;
	cn_world_get_bodies(p->world, NULL, 0, &count);
	cn_body *bodies = (cn_body *)malloc((size_t)(count + 1) * sizeof *bodies);
	if (bodies == NULL)
		return 0;
	cn_world_get_bodies(p->world, bodies, count, &count);
	for (int32_t i = 0; i < count && good; ++i)
		good = draw_body_contacts(p, bodies[i]);
	free(bodies);
	return good;
}

int32_t draw_world(canvas *c, const draw_view *view, const cn_world *world, uint32_t show)
{
	painter p = {0};
	p.c = c;
	p.view = view;
	p.world = world;
	p.show = show;
	canvas_clear(c, draw_colors[DRAW_BACKGROUND]);
	int32_t good = !(show & (DRAW_SHOW_ISLANDS | DRAW_SHOW_TIERS)) || draw_find_groups(&p);
	good = good && draw_shapes(&p) && (!(show & DRAW_SHOW_JOINTS) || (draw_joints(&p) && draw_constraints(&p))) &&
		   (!(show & DRAW_SHOW_CONTACTS) || draw_contacts(&p));
	free(p.groups);
	return good;
}
