/*
 * world/draw.c - debug draw: calls the user's functions for shapes, joints, contacts, boxes and centres. Reads only.
 */
#include "joints/joint_type.h"
#include "world/error.h"


enum {
	COLOR_STATIC = 0x7F9F7F,
	COLOR_KINEMATIC = 0x7F7FE5,
	COLOR_AWAKE = 0xE5B27F,
	COLOR_ASLEEP = 0x999999,
	COLOR_SENSOR = 0x40C0C0,
	COLOR_JOINT = 0x40A0E0,
	COLOR_LIMIT = 0xE04040,
	COLOR_CONTACT = 0xE03030,
	COLOR_NORMAL = 0xF0F0F0,
	COLOR_BOX = 0xC040C0,
	COLOR_CENTER = 0xFFFFFF
};

void cn_debug_draw_init(cn_debug_draw *draw)
{
	if (!cni_def_begin(draw, sizeof *draw))
		return;
	draw->flags = CN_DRAW_SHAPES | CN_DRAW_JOINTS | CN_DRAW_CONTACTS;
	draw->view.lower_m = cni_v(-FLT_MAX, -FLT_MAX);
	draw->view.upper_m = cni_v(FLT_MAX, FLT_MAX);
}

static int32_t in_view(const cn_debug_draw *d, const cni_aabb *box)
{
	cni_aabb view = cni_aabb_of(d->view.lower_m, d->view.upper_m);
	return cni_aabb_overlap(&view, box);
}

static int32_t span_in_view(const cn_debug_draw *d, cni_vec2 a, cni_vec2 b)
{
	cni_aabb box = cni_aabb_of_segment(a, b);
	return in_view(d, &box);
}

static void segment(const cn_debug_draw *d, cni_vec2 a, cni_vec2 b, uint32_t color)
{
	if (d->segment != NULL && span_in_view(d, a, b))
		d->segment(&a, &b, color, d->user);
}

static void point(const cn_debug_draw *d, cni_vec2 p, float size, uint32_t color)
{
	if (d->point != NULL && span_in_view(d, p, p))
		d->point(&p, size, color, d->user);
}

/* ---- shapes ---- */

static uint32_t body_color(const cn_debug_draw *d, const cni_body *b, const cni_shape *s)
{
	if (s->flags & CN_SHAPE_SENSOR)
		return COLOR_SENSOR;
	if (b->type == CN_BODY_STATIC)
		return COLOR_STATIC;
	if (b->awake == 0)
		return COLOR_ASLEEP;
	if ((d->flags & CN_DRAW_ISLANDS) && b->island != CNI_NONE)
		return ((uint32_t)b->island * 2654435761u >> 8 & 0xFFFFFFu) | 0x404040u;
	return b->type == CN_BODY_KINEMATIC ? COLOR_KINEMATIC : COLOR_AWAKE;
}

static void draw_polygon(const cn_debug_draw *d, const cni_geometry *g, cni_transform x, uint32_t color)
{
	cni_vec2 points[CN_POLYGON_MAX_VERTICES];
	if (d->polygon == NULL)
		return;
	for (int32_t k = 0; k < g->count; ++k)
		points[k] = cni_transform_point(x, cni_geometry_points(g)[k]);
	d->polygon(points, g->count, g->radius, color, d->user);
}

static void draw_round(const cn_debug_draw *d, const cni_geometry *g, cni_transform x, uint32_t color)
{
	cni_vec2 a = cni_transform_point(x, cni_geometry_points(g)[0]), b;
	if (g->type == CN_SHAPE_CIRCLE) {
		b = cni_add(a, cni_rotate(x.q, cni_v(g->radius, 0.0f)));
		if (d->circle != NULL)
			d->circle(&a, g->radius, &b, color, d->user);
		return;
	}
	b = cni_transform_point(x, cni_geometry_points(g)[1]);
	if (d->capsule != NULL)
		d->capsule(&a, &b, g->radius, color, d->user);
}

static void draw_edges(const cn_debug_draw *d, const cni_geometry *g, cni_transform x, uint32_t color)
{
	const cni_vec2 *points = cni_geometry_points(g);
	int32_t children = cni_geometry_children(g);
	for (int32_t k = 0; k < children; ++k)
		segment(d, cni_transform_point(x, points[k]), cni_transform_point(x, points[(k + 1) % g->count]), color);
}

static void draw_box(const cn_debug_draw *d, const cni_aabb *box)
{
	segment(d, cni_v(box->x0, box->y0), cni_v(box->x1, box->y0), COLOR_BOX);
	segment(d, cni_v(box->x1, box->y0), cni_v(box->x1, box->y1), COLOR_BOX);
	segment(d, cni_v(box->x1, box->y1), cni_v(box->x0, box->y1), COLOR_BOX);
	segment(d, cni_v(box->x0, box->y1), cni_v(box->x0, box->y0), COLOR_BOX);
}

static void draw_shape(const cn_world *world, const cn_debug_draw *d, const cni_body *b, const cni_shape *s)
{
	const cni_geometry *g = cni_shape_geometry(&world->blocks, s);
	cni_transform x = cni_body_transform(b);
	cni_aabb box = cni_geometry_bounds(g, x);
	uint32_t color = body_color(d, b, s);
	if (!in_view(d, &box))
		return;
	if (d->flags & CN_DRAW_SHAPES) {
		if (g->type == CN_SHAPE_POLYGON)
			draw_polygon(d, g, x, color);
		else if (g->type == CN_SHAPE_CIRCLE || g->type == CN_SHAPE_CAPSULE)
			draw_round(d, g, x, color);
		else
			draw_edges(d, g, x, color);
	}
	if (d->flags & CN_DRAW_AABBS)
		draw_box(d, &box);
}

static void draw_body(const cn_world *world, const cn_debug_draw *d, int32_t body)
{
	const cni_body *b = cni_body_at(world, body);
	cni_vec2 center = cni_v(b->cx, b->cy);
	for (int32_t shape = b->shape_first; shape != CNI_NONE; shape = cni_shape_at(world, shape)->next)
		draw_shape(world, d, b, cni_shape_at(world, shape));
	if (!(d->flags & CN_DRAW_CENTERS))
		return;
	point(d, center, 4.0f, COLOR_CENTER);
	if (d->text != NULL && b->name != 0 && span_in_view(d, center, center))
		d->text(&center, (const char *)cni_blocks_at(&world->blocks, b->name), COLOR_CENTER, d->user);
}

/* ---- joints and contacts ---- */

/* Draws lines from each body's centre to its anchor and between the anchors; the rows give axes and limits. */
static void draw_joint(const cn_world *world, const cn_debug_draw *d, int32_t joint)
{
	const cni_joint *j = cni_joint_at(world, joint);
	cni_joint_frame f = cni_joint_frame_make(world, j);
	cni_row rows[CNI_JOINT_ROWS];
	int32_t count = cni_joint_type_of(j->type)->rows(j, &f, rows);
	cni_vec2 anchor[2];
	cni_joint_anchors(world, j, &anchor[0], &anchor[1]);
	for (int32_t side = 0; side < 2; ++side) {
		point(d, anchor[side], 5.0f, COLOR_JOINT);
		if (j->body[side] != CNI_NONE)
			segment(d, cni_v(cni_body_at(world, j->body[side])->cx, cni_body_at(world, j->body[side])->cy), anchor[side], COLOR_JOINT);
	}
	segment(d, anchor[0], anchor[1], COLOR_JOINT);
	for (int32_t k = 0; k < count; ++k) {
		cni_vec2 along = cni_v(rows[k].lever.bx, rows[k].lever.by);
		if (rows[k].kind == CNI_ROW_LIMIT && !rows[k].angular)
			segment(d, anchor[1], cni_madd(anchor[1], -rows[k].error, along), COLOR_LIMIT);
	}
}

static void draw_contact(const cn_world *world, const cn_debug_draw *d, int32_t contact)
{
	cn_contact_event e;
	cni_contact_describe(world, contact, CN_EVENT_STAY, &e);
	for (int32_t k = 0; k < e.manifold.point_count; ++k) {
		cni_vec2 p = e.manifold.points[k].point_m;
		point(d, p, 4.0f, COLOR_CONTACT);
		segment(d, p, cni_madd(p, 0.2f * world->settings.length_unit, e.manifold.normal), COLOR_NORMAL);
	}
}

cn_result cn_world_draw(const cn_world *world, const cn_debug_draw *draw)
{
	cni_call call = cni_enter_const(world);
	if (cni_check_def(&call, draw, sizeof *draw, "cn_debug_draw_init")) {
		cni_check_flags(&call, "flags", draw->flags, CN_DRAW_SHAPES | CN_DRAW_JOINTS | CN_DRAW_CONTACTS | CN_DRAW_AABBS | CN_DRAW_CENTERS | CN_DRAW_ISLANDS);
		cni_check_finite2(&call, "view.lower_m", draw->view.lower_m);
		cni_check_finite2(&call, "view.upper_m", draw->view.upper_m);
	}
	if (call.result != CN_OK)
		return call.result;
	for (int32_t k = cni_handles_next(&world->body_handles, 0); k != CNI_NONE; k = cni_handles_next(&world->body_handles, k + 1))
		draw_body(world, draw, k);
	for (int32_t k = cni_handles_next(&world->joint_handles, 0); k != CNI_NONE && (draw->flags & CN_DRAW_JOINTS); k = cni_handles_next(&world->joint_handles, k + 1))
		draw_joint(world, draw, k);
	for (int32_t k = 0; k < world->contact_used && (draw->flags & CN_DRAW_CONTACTS); ++k)
		if (cni_contact_at(world, k)->flags & CNI_CONTACT_TOUCHING)
			draw_contact(world, draw, k);
	return CN_OK;
}
