/*
 * examples/demo/draw_joint.c - joints and constraints on one body: dots at anchors, lines from bodies
 * whose shapes do not reach them, axes between limits with a mark across each end, rays at the limits
 * of angles. Everything is read back from the world through the public API.
 */
#include "demo/draw_paint.h"
#include <math.h>
#include <stdlib.h>

#define BODY_SHAPES_LOOKED_AT 8
#define ARC_STEPS 10
#define THIN_PX 0.8f
#define RAY_MIN_PX 14.0f /* shorter ones would only blur what they mark */
#define FREE_AXIS_M 0.5f /* shown of an axis without limits, to either side */

static cn_vec2 vec(float x, float y)
{
	cn_vec2 v;
	v.x = x;
	v.y = y;
	return v;
}

static cn_vec2 along(cn_vec2 from_m, cn_vec2 direction, float by_m) { return vec(from_m.x + by_m * direction.x, from_m.y + by_m * direction.y); }

/* ------------------------------------------------------------------ marks */

static void line(painter *p, cn_vec2 a_m, cn_vec2 b_m, int32_t color)
{
	canvas_line(p->c, draw_to_picture(p, a_m), draw_to_picture(p, b_m), THIN_PX, draw_colors[color]);
}

static void dot(painter *p, cn_vec2 at_m) { canvas_disc(p->c, draw_to_picture(p, at_m), draw_dot_px(p), draw_colors[DRAW_JOINT], 0, 0.0f); }

static void cross(painter *p, cn_vec2 at_m)
{
	const float arm_m = 0.09f;
	line(p, vec(at_m.x - arm_m, at_m.y - arm_m), vec(at_m.x + arm_m, at_m.y + arm_m), DRAW_LIMIT);
	line(p, vec(at_m.x - arm_m, at_m.y + arm_m), vec(at_m.x + arm_m, at_m.y - arm_m), DRAW_LIMIT);
}

/* Across a direction of length 1. */
static void end_mark(painter *p, cn_vec2 at_m, cn_vec2 direction)
{
	cn_vec2 across = vec(-direction.y, direction.x);
	line(p, along(at_m, across, -0.1f), along(at_m, across, 0.1f), DRAW_LIMIT);
}

static void axis_line(painter *p, cn_vec2 from_m, cn_vec2 direction, float lower_m, float upper_m, int32_t limited)
{
	cn_vec2 a = along(from_m, direction, limited ? lower_m : -FREE_AXIS_M), b = along(from_m, direction, limited ? upper_m : FREE_AXIS_M);
	line(p, a, b, DRAW_LIMIT);
	if (limited) {
		end_mark(p, a, direction);
		end_mark(p, b, direction);
	}
}

static cn_vec2 ray_end(cn_vec2 center_m, float angle_rad, float length_m)
{
	return vec(center_m.x + length_m * cosf(angle_rad), center_m.y + length_m * sinf(angle_rad));
}

static void arc(painter *p, cn_vec2 center_m, float radius_m, float from_rad, float to_rad)
{
	for (int32_t i = 0; i < ARC_STEPS; ++i) {
		float a = from_rad + (to_rad - from_rad) * (float)i / ARC_STEPS, b = from_rad + (to_rad - from_rad) * (float)(i + 1) / ARC_STEPS;
		line(p, ray_end(center_m, a, radius_m), ray_end(center_m, b, radius_m), DRAW_LIMIT);
	}
}

/* The two limits as rays with an arc between them. */
static void angle_limits(painter *p, cn_vec2 center_m, float length_m, float lower_rad, float upper_rad)
{
	if (length_m * p->view->scale < RAY_MIN_PX)
		return;
	line(p, center_m, ray_end(center_m, lower_rad, length_m), DRAW_LIMIT);
	line(p, center_m, ray_end(center_m, upper_rad, length_m), DRAW_LIMIT);
	if (upper_rad - lower_rad < 6.28f)
		arc(p, center_m, 0.8f * length_m, lower_rad, upper_rad);
}

/* ------------------------------------------------------------------ bodies */

/* Body 0 is the world. */
static cn_pose pose_of(const painter *p, cn_body body)
{
	cn_pose pose = {{0.0f, 0.0f}, 1.0f, 0.0f};
	if (body != 0)
		cn_body_get_pose(p->world, body, &pose);
	return pose;
}

static cn_vec2 direction_to_world(cn_pose pose, cn_vec2 v) { return vec(pose.cosine * v.x - pose.sine * v.y, pose.sine * v.x + pose.cosine * v.y); }

static cn_vec2 point_to_world(cn_pose pose, cn_vec2 v) { return along(pose.position_m, direction_to_world(pose, v), 1.0f); }

static float angle_of(const painter *p, cn_body body)
{
	float angle = 0.0f;
	if (body != 0)
		cn_body_get_angle(p->world, body, &angle);
	return angle;
}

/* Inside of one of the body's shapes, where a line from its centre would say nothing new. */
static int32_t covers_point(const cn_world *world, cn_body body, cn_vec2 point_m)
{
	cn_shape shapes[BODY_SHAPES_LOOKED_AT];
	int32_t count = 0, inside = 0;
	cn_body_get_shapes(world, body, shapes, BODY_SHAPES_LOOKED_AT, &count);
	for (int32_t i = 0; i < count && i < BODY_SHAPES_LOOKED_AT && !inside; ++i)
		cn_shape_test_point(world, shapes[i], point_m.x, point_m.y, &inside);
	return inside;
}

/* A joint with its bodies and, in world coordinates, its anchors. */
typedef struct joint_view {
	cn_joint joint;
	cn_body bodies[2];
	cn_vec2 anchors[2];
} joint_view;

static void draw_links(painter *p, const joint_view *j)
{
	cn_vec2 center;
	for (int32_t i = 0; i < 2; ++i) {
		cn_body body = j->bodies[i];
		if (body != 0 && cn_body_get_center(p->world, body, &center) == CN_OK && !covers_point(p->world, body, j->anchors[i]))
			line(p, center, j->anchors[i], DRAW_JOINT);
	}
}

/* ------------------------------------------------------------------ kinds of joints */

/* Rays in the directions that b's centre, or its x axis if it turns about its centre, has at the limits. */
static void draw_revolute(painter *p, const joint_view *j)
{
	cn_revolute_def def;
	cn_vec2 center = j->anchors[1];
	float angle = 0.0f;
	if (cn_joint_get_revolute(p->world, j->joint, &def) != CN_OK || !(def.base.flags & CN_JOINT_LIMIT) || j->bodies[1] == 0)
		return;
	cn_joint_get_position(p->world, j->joint, &angle);
	cn_body_get_center(p->world, j->bodies[1], &center);
	float x = center.x - j->anchors[1].x, y = center.y - j->anchors[1].y, length = hypotf(x, y);
	float now = length > 0.01f ? atan2f(y, x) : angle_of(p, j->bodies[1]);
	length = length > 0.01f ? length : 0.4f;
	angle_limits(p, j->anchors[0], length, now + def.lower_angle_rad - angle, now + def.upper_angle_rad - angle);
}

/* A spring is a zigzag; lengths that limits allow have marks. */
static void draw_distance(painter *p, const joint_view *j)
{
	cn_distance_def def;
	cn_vec2 a = j->anchors[0], b = j->anchors[1], last = a;
	float length = hypotf(b.x - a.x, b.y - a.y);
	if (cn_joint_get_distance(p->world, j->joint, &def) != CN_OK || length <= 0.01f)
		return;
	cn_vec2 direction = vec((b.x - a.x) / length, (b.y - a.y) / length), across = vec(-direction.y, direction.x);
	int32_t springy = (def.base.flags & CN_JOINT_SPRING) != 0;
	for (int32_t i = 1; springy && i < ARC_STEPS; ++i) {
		cn_vec2 next = along(along(a, direction, length * (float)i / ARC_STEPS), across, i % 2 == 0 ? 0.07f : -0.07f);
		line(p, last, next, DRAW_JOINT);
		last = next;
	}
	line(p, last, b, DRAW_JOINT);
	if (def.base.flags & CN_JOINT_LIMIT) {
		end_mark(p, along(a, direction, def.length_min_m), direction);
		end_mark(p, along(a, direction, def.length_max_m), direction);
	}
}

static void draw_prismatic(painter *p, const joint_view *j)
{
	cn_prismatic_def def;
	if (cn_joint_get_prismatic(p->world, j->joint, &def) == CN_OK)
		axis_line(p, j->anchors[0], direction_to_world(pose_of(p, j->bodies[0]), def.axis), def.lower_m, def.upper_m,
			(def.base.flags & CN_JOINT_LIMIT) != 0);
}

static void draw_wheel(painter *p, const joint_view *j)
{
	cn_wheel_def def;
	if (cn_joint_get_wheel(p->world, j->joint, &def) == CN_OK)
		axis_line(p, j->anchors[0], direction_to_world(pose_of(p, j->bodies[0]), def.axis), def.lower_m, def.upper_m,
			(def.base.flags & CN_JOINT_LIMIT) != 0);
}

static void draw_groove(painter *p, const joint_view *j)
{
	cn_groove_def def;
	if (cn_joint_get_groove(p->world, j->joint, &def) != CN_OK)
		return;
	cn_vec2 a = j->anchors[0], b = point_to_world(pose_of(p, j->bodies[0]), def.end_m);
	float length = hypotf(b.x - a.x, b.y - a.y);
	axis_line(p, a, vec((b.x - a.x) / length, (b.y - a.y) / length), 0.0f, length, 1);
}

/* A cross where the joint pulls to. */
static void draw_motor(painter *p, const joint_view *j)
{
	cn_motor_def def;
	if (cn_joint_get_motor_to(p->world, j->joint, &def) != CN_OK)
		return;
	cn_vec2 target = along(j->anchors[0], direction_to_world(pose_of(p, j->bodies[0]), def.offset_m), 1.0f);
	line(p, j->anchors[1], target, DRAW_JOINT);
	cross(p, target);
}

static void draw_mouse(painter *p, const joint_view *j)
{
	cn_mouse_def def;
	if (cn_joint_get_mouse(p->world, j->joint, &def) != CN_OK)
		return;
	line(p, j->anchors[1], def.target_m, DRAW_JOINT);
	cross(p, def.target_m);
}

static void draw_pulley(painter *p, const joint_view *j)
{
	cn_pulley_def def;
	if (cn_joint_get_pulley(p->world, j->joint, &def) != CN_OK)
		return;
	line(p, j->anchors[0], def.ground_a_m, DRAW_JOINT);
	line(p, def.ground_a_m, def.ground_b_m, DRAW_JOINT);
	line(p, def.ground_b_m, j->anchors[1], DRAW_JOINT);
	dot(p, def.ground_a_m);
	dot(p, def.ground_b_m);
}

/* A mark at every click around b, and a ray that turns with b. */
static void draw_ratchet(painter *p, const joint_view *j)
{
	const float radius_m = 0.45f;
	cn_ratchet_def def;
	cn_vec2 at = j->anchors[1];
	if (cn_joint_get_ratchet(p->world, j->joint, &def) != CN_OK)
		return;
	float click = fabsf(def.click_rad), start = angle_of(p, j->bodies[0]) + def.phase_rad;
	for (int32_t i = 0; i < 72 && (float)i * click < 6.28f; ++i)
		line(p, ray_end(at, start + (float)i * click, 0.8f * radius_m), ray_end(at, start + (float)i * click, radius_m), DRAW_LIMIT);
	line(p, at, ray_end(at, angle_of(p, j->bodies[1]), radius_m), DRAW_JOINT);
}

/* The arc that the spring is wound by. */
static void draw_rotary_spring(painter *p, const joint_view *j)
{
	const float radius_m = 0.45f;
	cn_rotary_spring_def def;
	cn_vec2 at = j->anchors[1];
	float wound = 0.0f, now = angle_of(p, j->bodies[1]);
	if (cn_joint_get_rotary_spring(p->world, j->joint, &def) != CN_OK)
		return;
	cn_joint_get_position(p->world, j->joint, &wound);
	float rest = now - (wound - def.rest_angle_rad);
	line(p, at, ray_end(at, rest, 1.3f * radius_m), DRAW_LIMIT);
	arc(p, at, radius_m, rest, now);
}

static void draw_kind(painter *p, const joint_view *j, int32_t type)
{
	switch (type) {
	case CN_JOINT_REVOLUTE: draw_revolute(p, j); break;
	case CN_JOINT_DISTANCE: draw_distance(p, j); break;
	case CN_JOINT_PRISMATIC: draw_prismatic(p, j); break;
	case CN_JOINT_WHEEL: draw_wheel(p, j); break;
	case CN_JOINT_MOTOR_TO: draw_motor(p, j); break;
	case CN_JOINT_MOUSE: draw_mouse(p, j); break;
	case CN_JOINT_PULLEY: draw_pulley(p, j); break;
	case CN_JOINT_RATCHET: draw_ratchet(p, j); break;
	case CN_JOINT_ROTARY_SPRING: draw_rotary_spring(p, j); break;
	case CN_JOINT_GROOVE: draw_groove(p, j); break;
	default: line(p, j->anchors[0], j->anchors[1], DRAW_JOINT); break;
	}
}

static void draw_joint(painter *p, cn_joint joint)
{
	joint_view j;
	int32_t type = -1;
	j.joint = joint;
	if (cn_joint_get_bodies(p->world, joint, &j.bodies[0], &j.bodies[1]) != CN_OK || cn_joint_get_type(p->world, joint, &type) != CN_OK)
		return;
	cn_joint_get_anchors(p->world, joint, &j.anchors[0], &j.anchors[1]);
	if (type != CN_JOINT_MOUSE)
		draw_links(p, &j);
	draw_kind(p, &j, type);
	dot(p, j.anchors[1]);
	if (type == CN_JOINT_DISTANCE || type == CN_JOINT_PULLEY || type == CN_JOINT_GEAR)
		dot(p, j.anchors[0]);
}

int32_t draw_joints(painter *p)
{
	int32_t count = 0;
	cn_world_get_joints(p->world, NULL, 0, &count);
	cn_joint *joints = (cn_joint *)malloc((size_t)(count + 1) * sizeof *joints);
	if (joints == NULL)
		return 0;
	cn_world_get_joints(p->world, joints, count, &count);
	for (int32_t i = 0; i < count; ++i)
		draw_joint(p, joints[i]);
	free(joints);
	return 1;
}

/* ------------------------------------------------------------------ constraints on one body */

/* Where the body's x axis may point. */
static void draw_angle_constraint(painter *p, cn_constraint constraint)
{
	cn_angle_constraint_def def;
	cn_vec2 center;
	if (cn_constraint_get_angle(p->world, constraint, &def) != CN_OK || cn_body_get_center(p->world, def.body, &center) != CN_OK)
		return;
	angle_limits(p, center, 0.6f, def.lower_rad, def.upper_rad);
	dot(p, center);
}

/* The line, or the band that the tolerance leaves. */
static void draw_line_constraint(painter *p, cn_constraint constraint)
{
	cn_line_constraint_def def;
	if (cn_constraint_get_line(p->world, constraint, &def) != CN_OK)
		return;
	cn_vec2 across = vec(-def.axis.y, def.axis.x);
	int32_t limited = (def.flags & CN_CONSTRAINT_LIMIT) != 0;
	axis_line(p, along(def.origin_m, across, def.tolerance_m), def.axis, def.lower_m, def.upper_m, limited);
	if (def.tolerance_m > 0.0f)
		axis_line(p, along(def.origin_m, across, -def.tolerance_m), def.axis, def.lower_m, def.upper_m, limited);
	dot(p, point_to_world(pose_of(p, def.body), def.anchor_m));
}

int32_t draw_constraints(painter *p)
{
	int32_t count = 0;
	cn_world_get_constraints(p->world, NULL, 0, &count);
	cn_constraint *list = (cn_constraint *)malloc((size_t)(count + 1) * sizeof *list);
	if (list == NULL)
		return 0;
	cn_world_get_constraints(p->world, list, count, &count);
	for (int32_t i = 0; i < count; ++i) {
		int32_t type = -1;
		cn_constraint_get_type(p->world, list[i], &type);
		if (type == CN_CONSTRAINT_ANGLE)
			draw_angle_constraint(p, list[i]);
		else if (type == CN_CONSTRAINT_LINE)
			draw_line_constraint(p, list[i]);
	}
	free(list);
	return 1;
}
