/*
 * test/stability/build.c - short forms of the calls that scenes are built with. Lengths are multiplied by the
 * parameter size, x is moved by the parameter far; both happen here and nowhere else.
 */
#include "scene.h"

#include <stdio.h>
#include <stdlib.h>

static void *grown(void *memory, int32_t count, int32_t *capacity, size_t bytes)
{
	if (count < *capacity)
		return memory;
	*capacity = *capacity > 0 ? 2 * *capacity : 64;
	memory = realloc(memory, (size_t)*capacity * bytes);
	if (memory == NULL) {
		fprintf(stderr, "stability: out of memory\n");
		exit(2);
	}
	return memory;
}

static void keep_item(scene_run *run, cn_body body, double x, double y)
{
	scene_item item = { 0, 0.0, 0.0, 0.0, 0.0, { 0, 0, 0 } };
	item.body = body;
	item.x = x;
	item.y = y;
	run->items = grown(run->items, run->item_count, &run->item_capacity, sizeof *run->items);
	run->items[run->item_count++] = item;
}

void scene_keep_joint(scene_run *run, cn_joint joint)
{
	run->joints = grown(run->joints, run->joint_count, &run->joint_capacity, sizeof *run->joints);
	run->joints[run->joint_count++] = joint;
}

static double far_x(const scene_run *run, double x) { return x * scene_value(run, "size") + run->far_m; }

cn_body scene_body(scene_run *run, int32_t type, double x, double y, double angle)
{
	double size = scene_value(run, "size");
	cn_body_def def;
	cn_body body = 0;
	if (run->refusal[0] != '\0')
		return 0;
	cn_body_def_init(&def);
	def.type = type;
	def.flags |= run->body_flags;
	def.position_m.x = (float)far_x(run, x);
	def.position_m.y = (float)(y * size);
	def.angle_rad = (float)angle;
	if (scene_check(run, cn_body_create(run->world, &def, &body)) && type == CN_BODY_DYNAMIC)
		keep_item(run, body, (double)def.position_m.x - run->far_m, (double)def.position_m.y);
	scene_film_body(run, type, &def);
	return body;
}

static cn_shape_def surface(const scene_run *run, cn_body body)
{
	cn_shape_def def;
	cn_shape_def_init(&def);
	def.body = body;
	def.density_kgpm2 = (float)run->density;
	def.material.static_friction = def.material.dynamic_friction = (float)run->friction;
	def.material.restitution = (float)run->restitution;
	def.filter.group = run->group;
	def.event_mask = 0;
	return def;
}

static void keep_half_sizes(scene_run *run, cn_body body, int32_t type, double half_x, double half_y)
{
	scene_item *item = NULL;
	if (type == CN_BODY_DYNAMIC)
		item = &run->items[run->item_count - 1];
	else if (run->ground_count < SCENE_GROUND_MAX)
		item = &run->ground[run->ground_count++];
	if (item == NULL)
		return;
	item->body = body;
	item->half_x = half_x;
	item->half_y = half_y;
}

cn_body scene_box(scene_run *run, int32_t type, double x, double y, double angle, double half_x, double half_y)
{
	cn_body body = scene_body(run, type, x, y, angle);
	cn_shape_def def = surface(run, body);
	double size = scene_value(run, "size");
	float hx = (float)(half_x * size), hy = (float)(half_y * size), halves[2];
	halves[0] = hx;
	halves[1] = hy;
	scene_film_shape(run, "box", halves, 2);
	if (body != 0 && scene_check(run, cn_shape_create_box(run->world, &def, hx, hy, 0.0f, NULL)))
		keep_half_sizes(run, body, type, (double)hx, (double)hy);
	return body;
}

cn_body scene_circle(scene_run *run, int32_t type, double x, double y, double radius)
{
	cn_body body = scene_body(run, type, x, y, 0.0);
	cn_shape_def def = surface(run, body);
	cn_circle circle = { { 0.0f, 0.0f }, 0.0f };
	circle.radius_m = (float)(radius * scene_value(run, "size"));
	scene_film_shape(run, "circle", &circle.radius_m, 1);
	if (body != 0)
		scene_check(run, cn_shape_create_circle(run->world, &def, &circle, NULL));
	return body;
}

/* Points are relative to (x, y), counter-clockwise. */
cn_body scene_polygon(scene_run *run, int32_t type, double x, double y, const double (*points)[2], int32_t count)
{
	cn_body body = scene_body(run, type, x, y, 0.0);
	cn_shape_def def = surface(run, body);
	double size = scene_value(run, "size");
	cn_polygon polygon = { 0, 0.0f, { { 0.0f, 0.0f } } };
	int32_t k;
	polygon.count = count;
	for (k = 0; k < count; ++k) {
		polygon.points_m[k].x = (float)(points[k][0] * size);
		polygon.points_m[k].y = (float)(points[k][1] * size);
	}
	scene_film_shape(run, "polygon", &polygon.points_m[0].x, 2 * count);
	if (body != 0)
		scene_check(run, cn_shape_create_polygon(run->world, &def, &polygon, NULL));
	return body;
}

void scene_capsule_shape(scene_run *run, cn_body body, double ax, double ay, double bx, double by, double radius)
{
	cn_shape_def def = surface(run, body);
	double size = scene_value(run, "size");
	cn_capsule capsule;
	capsule.a_m.x = (float)(ax * size);
	capsule.a_m.y = (float)(ay * size);
	capsule.b_m.x = (float)(bx * size);
	capsule.b_m.y = (float)(by * size);
	capsule.radius_m = (float)(radius * size);
	scene_film_shape(run, "capsule", &capsule.a_m.x, 5);
	if (body != 0)
		scene_check(run, cn_shape_create_capsule(run->world, &def, &capsule, NULL));
}

/* Top at y = 0. */
void scene_floor(scene_run *run)
{
	scene_box(run, CN_BODY_STATIC, 0.0, -1.0, 0.0, 200.0, 1.0);
}

void scene_set_velocity(scene_run *run, cn_body body, double vx, double vy, double w)
{
	if (body != 0)
		scene_check(run, cn_body_set_velocity(run->world, body, (float)vx, (float)vy, (float)w));
}

/* ---- joints ---- */

static void set_anchor(scene_run *run, cn_body body, double x, double y, cn_vec2 *out)
{
	out->x = (float)far_x(run, x);
	out->y = (float)(y * scene_value(run, "size"));
	if (body != 0)
		scene_check(run, cn_body_get_local_point(run->world, body, out->x, out->y, out));
}

static void set_base(scene_run *run, cn_joint_base *base, cn_body body_a, cn_body body_b, double x, double y)
{
	base->body_a = body_a;
	base->body_b = body_b;
	set_anchor(run, body_a, x, y, &base->anchor_a_m);
	set_anchor(run, body_b, x, y, &base->anchor_b_m);
}

static float reference_angle(scene_run *run, cn_body body_a, cn_body body_b)
{
	float a = 0.0f, b = 0.0f;
	if (body_a != 0)
		scene_check(run, cn_body_get_angle(run->world, body_a, &a));
	scene_check(run, cn_body_get_angle(run->world, body_b, &b));
	return b - a;
}

static void pin(scene_run *run, cn_body body_a, cn_body body_b, double x, double y, uint32_t flags, double lower, double upper)
{
	cn_revolute_def def;
	cn_joint joint = 0;
	if (run->refusal[0] != '\0')
		return;
	cn_revolute_def_init(&def);
	set_base(run, &def.base, body_a, body_b, x, y);
	def.base.flags |= flags;
	def.reference_angle_rad = reference_angle(run, body_a, body_b);
	def.lower_angle_rad = (float)lower;
	def.upper_angle_rad = (float)upper;
	if (scene_check(run, cn_joint_create_revolute(run->world, &def, &joint)))
		scene_keep_joint(run, joint);
}

void scene_pin(scene_run *run, cn_body body_a, cn_body body_b, double x, double y)
{
	pin(run, body_a, body_b, x, y, 0, 0.0, 0.0);
}

void scene_pin_limited(scene_run *run, cn_body body_a, cn_body body_b, double x, double y, double lower, double upper)
{
	pin(run, body_a, body_b, x, y, CN_JOINT_LIMIT, lower, upper);
}

void scene_weld(scene_run *run, cn_body body_a, cn_body body_b, double x, double y)
{
	cn_fixed_def def;
	cn_joint joint = 0;
	if (run->refusal[0] != '\0')
		return;
	cn_fixed_def_init(&def);
	set_base(run, &def.base, body_a, body_b, x, y);
	def.reference_angle_rad = reference_angle(run, body_a, body_b);
	if (scene_check(run, cn_joint_create_fixed(run->world, &def, &joint)))
		scene_keep_joint(run, joint);
}
