/*
 * test/families/build.c - random numbers, bodies and joints of a scene; everything made is recorded for measure.c.
 */
#include "families.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- random numbers: xorshift32 (Marsaglia, 2003) ---- */

static double next(uint32_t *random)
{
	*random ^= *random << 13;
	*random ^= *random >> 17;
	*random ^= *random << 5;
	return (double)*random / 4294967296.0;
}

double pick(scene *s, double lower, double upper) { return lower + (upper - lower) * next(&s->random); }
double pick_log(scene *s, double lower, double upper) { return exp(pick(s, log(lower), log(upper))); }
int chance(scene *s, double probability) { return next(&s->random) < probability; }
int32_t pick_int(scene *s, int32_t lower, int32_t upper) { return lower + (int32_t)floor(next(&s->random) * (double)(upper - lower + 1)); }
int32_t pick_int_log(scene *s, int32_t lower, int32_t upper) { return (int32_t)floor(pick_log(s, (double)lower, (double)upper + 0.999)); }

/* ---- records ---- */

static void *grown(void *memory, int32_t count, int32_t *capacity, size_t bytes)
{
	if (count < *capacity)
		return memory;
	*capacity = 2 * *capacity + 64;
	memory = realloc(memory, (size_t)*capacity * bytes);
	if (memory == NULL) {
		fprintf(stderr, "families: out of memory\n");
		exit(2);
	}
	return memory;
}

static void check(scene *s, cn_result result)
{
	if (result != CN_OK && s->refusal[0] == '\0')
		snprintf(s->refusal, sizeof s->refusal, "%s", cn_world_error_text(s->world));
}

/* ---- bodies ---- */

static int32_t add_body(scene *s, int32_t type, double x, double y, double angle)
{
	cn_body_def def;
	scene_body body;
	memset(&body, 0, sizeof body);
	cn_body_def_init(&def);
	def.type = type == CN_BODY_STATIC && s->drift_mps != 0.0 ? CN_BODY_KINEMATIC : type;
	if (def.type != CN_BODY_STATIC)
		def.linear_velocity_mps.x = (float)s->drift_mps;
	if (type == CN_BODY_DYNAMIC && s->noise_m > 0.0) {
		x += s->noise_m * (2.0 * next(&s->noise_random) - 1.0);
		y += s->noise_m * (2.0 * next(&s->noise_random) - 1.0);
	}
	def.position_m.x = (float)x;
	def.position_m.y = (float)y;
	def.angle_rad = (float)angle;
	check(s, cn_body_create(s->world, &def, &body.handle));
	body.dynamic = type == CN_BODY_DYNAMIC;
	body.x = (double)def.position_m.x;
	body.y = (double)def.position_m.y;
	body.angle = body.turned = (double)def.angle_rad;
	s->bodies = grown(s->bodies, s->body_count, &s->body_capacity, sizeof *s->bodies);
	s->bodies[s->body_count] = body;
	return s->body_count++;
}

static cn_shape_def surface(const scene *s, int32_t body)
{
	cn_shape_def def;
	cn_shape_def_init(&def);
	def.body = s->bodies[body].handle;
	def.density_kgpm2 = (float)s->density;
	def.material.static_friction = def.material.dynamic_friction = (float)s->friction;
	def.material.restitution = (float)s->restitution;
	switch (s->surface) {
	case SURFACE_BOUNCES: def.material.restitution = 0.5f; break;
	case SURFACE_ROLLS: def.material.rolling_resistance = 0.05f; break;
	case SURFACE_BELTS: def.material.tangent_speed_mps = s->bodies[body].dynamic ? 0.0f : 1.0f; break;
	case SURFACE_SLIPS: def.material.static_friction = def.material.dynamic_friction = 0.0f; break;
	case SURFACE_STICKS: def.material.static_friction *= 2.0f; break;
	default: break;
	}
	def.filter.group = s->group;
	def.event_mask = 0;
	return def;
}

static void keep_shape(scene *s, int32_t body, const double (*points)[2], int32_t count, double radius)
{
	scene_shape shape;
	int32_t k;
	memset(&shape, 0, sizeof shape);
	shape.body = body;
	shape.count = count;
	shape.group = s->group;
	shape.radius = radius;
	for (k = 0; k < count; ++k) {
		double reach = hypot(points[k][0], points[k][1]) + radius;
		memcpy(shape.points[k], points[k], sizeof shape.points[k]);
		s->bodies[body].reach = fmax(s->bodies[body].reach, reach);
	}
	s->shapes = grown(s->shapes, s->shape_count, &s->shape_capacity, sizeof *s->shapes);
	s->shapes[s->shape_count++] = shape;
}

int32_t add_box(scene *s, int32_t type, double x, double y, double angle, double half_x, double half_y)
{
	int32_t body = add_body(s, type, x, y, angle);
	cn_shape_def def = surface(s, body);
	double points[4][2];
	points[0][0] = points[3][0] = -half_x;
	points[1][0] = points[2][0] = half_x;
	points[0][1] = points[1][1] = -half_y;
	points[2][1] = points[3][1] = half_y;
	check(s, cn_shape_create_box(s->world, &def, (float)half_x, (float)half_y, 0.0f, NULL));
	keep_shape(s, body, (const double(*)[2])points, 4, 0.0);
	return body;
}

void attach_box(scene *s, int32_t body, double x, double y, double angle, double half_x, double half_y)
{
	cn_shape_def def = surface(s, body);
	cn_polygon polygon = { 4, 0.0f, { { 0.0f, 0.0f } } };
	double points[4][2], c = cos(angle), sine = sin(angle);
	int32_t k;
	for (k = 0; k < 4; ++k) {
		double px = k == 1 || k == 2 ? half_x : -half_x, py = k >= 2 ? half_y : -half_y;
		points[k][0] = x + c * px - sine * py;
		points[k][1] = y + sine * px + c * py;
		polygon.points_m[k].x = (float)points[k][0];
		polygon.points_m[k].y = (float)points[k][1];
	}
	check(s, cn_shape_create_polygon(s->world, &def, &polygon, NULL));
	keep_shape(s, body, (const double(*)[2])points, 4, 0.0);
}

int32_t add_disc(scene *s, int32_t type, double x, double y, double radius)
{
	int32_t body = add_body(s, type, x, y, 0.0);
	cn_shape_def def = surface(s, body);
	cn_circle circle = { { 0.0f, 0.0f }, 0.0f };
	static const double center[1][2] = { { 0.0, 0.0 } };
	circle.radius_m = (float)radius;
	check(s, cn_shape_create_circle(s->world, &def, &circle, NULL));
	keep_shape(s, body, center, 1, radius);
	return body;
}

int32_t add_capsule(scene *s, int32_t type, double x, double y, double angle, double half_length, double radius)
{
	int32_t body = add_body(s, type, x, y, angle);
	cn_shape_def def = surface(s, body);
	cn_capsule capsule = { { 0.0f, 0.0f }, { 0.0f, 0.0f }, 0.0f };
	double points[2][2] = { { 0.0, 0.0 }, { 0.0, 0.0 } };
	capsule.a_m.x = -(float)half_length;
	capsule.b_m.x = (float)half_length;
	capsule.radius_m = (float)radius;
	points[0][0] = -half_length;
	points[1][0] = half_length;
	check(s, cn_shape_create_capsule(s->world, &def, &capsule, NULL));
	keep_shape(s, body, (const double(*)[2])points, 2, radius);
	return body;
}

int32_t add_polygon(scene *s, int32_t type, double x, double y, double angle, const double (*points)[2], int32_t count)
{
	int32_t body = add_body(s, type, x, y, angle), k;
	cn_shape_def def = surface(s, body);
	cn_polygon polygon = { 0, 0.0f, { { 0.0f, 0.0f } } };
	polygon.count = count;
	for (k = 0; k < count; ++k) {
		polygon.points_m[k].x = (float)points[k][0];
		polygon.points_m[k].y = (float)points[k][1];
	}
	check(s, cn_shape_create_polygon(s->world, &def, &polygon, NULL));
	keep_shape(s, body, points, count, 0.0);
	return body;
}

int32_t add_regular(scene *s, int32_t type, double x, double y, double angle, double radius, int32_t count)
{
	double points[POINTS_MAX][2];
	int32_t k;
	for (k = 0; k < count; ++k) {
		points[k][0] = radius * cos(2.0 * PI * (double)k / (double)count);
		points[k][1] = radius * sin(2.0 * PI * (double)k / (double)count);
	}
	return add_polygon(s, type, x, y, angle, (const double(*)[2])points, count);
}

int32_t add_floor(scene *s) { return add_box(s, CN_BODY_STATIC, 0.0, -1.0, 0.0, 200.0, 1.0); }

void add_pit(scene *s, double half_width)
{
	add_floor(s);
	add_box(s, CN_BODY_STATIC, -half_width - 1.0, 19.0, 0.0, 1.0, 21.0);
	add_box(s, CN_BODY_STATIC, half_width + 1.0, 19.0, 0.0, 1.0, 21.0);
}

void add_area(scene *s, double x, double y, double half_x, double half_y, double density, double drag, double damping, double flow_x, double lift)
{
	cn_body_def body;
	cn_shape_def def;
	cn_area_def area;
	cn_shape shape = 0;
	cn_body_def_init(&body);
	body.type = s->drift_mps != 0.0 ? CN_BODY_KINEMATIC : CN_BODY_STATIC;
	body.linear_velocity_mps.x = (float)s->drift_mps;
	body.position_m.x = (float)x;
	body.position_m.y = (float)y;
	cn_shape_def_init(&def);
	check(s, cn_body_create(s->world, &body, &def.body));
	def.flags |= CN_SHAPE_SENSOR;
	check(s, cn_shape_create_box(s->world, &def, (float)half_x, (float)half_y, 0.0f, &shape));
	cn_area_def_init(&area);
	area.density_kgpm2 = (float)density;
	area.drag_kgpm2 = (float)drag;
	area.linear_damping_per_s = area.angular_damping_per_s = (float)damping;
	area.flow_mps.x = (float)flow_x;
	area.gravity_mps2.y = (float)lift;
	check(s, cn_shape_set_area(s->world, shape, &area));
}

void set_velocity(scene *s, int32_t body, double vx, double vy, double w)
{
	check(s, cn_body_set_velocity(s->world, s->bodies[body].handle, (float)(vx + s->drift_mps), (float)vy, (float)w));
}

void set_mass(scene *s, double mass_kg, double area_m2) { s->density = mass_kg / area_m2; }

/* ---- joints ---- */

static double angle_of(const scene *s, int32_t body) { return body == WORLD ? 0.0 : s->bodies[body].angle; }

static void to_local(const scene *s, int32_t body, double x, double y, double *out_x, double *out_y)
{
	const scene_body *b;
	double dx, dy, c, sine;
	*out_x = x;
	*out_y = y;
	if (body == WORLD)
		return;
	b = &s->bodies[body];
	dx = x - b->x;
	dy = y - b->y;
	c = cos(b->angle);
	sine = sin(b->angle);
	*out_x = c * dx + sine * dy;
	*out_y = c * dy - sine * dx;
}

static double arm_of(const scene *s, int32_t a, int32_t b)
{
	double of_b = s->bodies[b].reach;
	return a == WORLD || !s->bodies[a].dynamic ? of_b : fmin(s->bodies[a].reach, of_b);
}

static scene_joint begin_joint(const scene *s, int32_t type, int32_t a, int32_t b, double ax, double ay, double bx, double by)
{
	scene_joint joint;
	memset(&joint, 0, sizeof joint);
	joint.type = type;
	joint.a = a;
	joint.b = b;
	to_local(s, a, ax, ay, &joint.ax, &joint.ay);
	to_local(s, b, bx, by, &joint.bx, &joint.by);
	joint.reference = angle_of(s, b) - angle_of(s, a);
	joint.lower = 1.0;
	joint.upper = -1.0;
	joint.arm = arm_of(s, a, b);
	return joint;
}

static void set_base(const scene *s, cn_joint_base *base, const scene_joint *joint)
{
	base->flags = s->joint_flags;
	base->body_a = joint->a == WORLD ? s->frame : s->bodies[joint->a].handle;
	base->body_b = s->bodies[joint->b].handle;
	base->anchor_a_m.x = (float)joint->ax;
	base->anchor_a_m.y = (float)joint->ay;
	base->anchor_b_m.x = (float)joint->bx;
	base->anchor_b_m.y = (float)joint->by;
	if (joint->lower <= joint->upper)
		base->flags |= CN_JOINT_LIMIT;
	if (s->motor_max > 0.0)
		base->flags |= CN_JOINT_MOTOR;
	if (s->joint_hertz > 0.0) {
		base->stiffness_hertz = (float)s->joint_hertz;
		base->stiffness_damping_ratio = 0.5f;
	}
	if (s->joint_force > 0.0)
		base->force_max_N = base->torque_max_Nm = (float)s->joint_force;
}

static void keep_joint(scene *s, const scene_joint *joint, cn_result result)
{
	check(s, result);
	s->joints = grown(s->joints, s->joint_count, &s->joint_capacity, sizeof *s->joints);
	s->joints[s->joint_count] = *joint;
	if (s->joint_hertz > 0.0 || s->joint_force > 0.0)
		s->joints[s->joint_count].type = -1; /* may open */
	++s->joint_count;
	if (joint->a != WORLD && (s->joint_flags & CN_JOINT_COLLIDE) == 0) {
		uint32_t a = (uint32_t)(joint->a < joint->b ? joint->a : joint->b), b = (uint32_t)(joint->a < joint->b ? joint->b : joint->a);
		s->apart = grown(s->apart, s->apart_count, &s->apart_capacity, sizeof *s->apart);
		s->apart[s->apart_count++] = a << 16 | b;
	}
}

void lock_rotation(scene *s, int32_t body)
{
	check(s, cn_body_set_flags(s->world, s->bodies[body].handle, (uint32_t)CN_BODY_ENABLED | (uint32_t)CN_BODY_SLEEP | (uint32_t)CN_BODY_LOCK_ROTATION));
}

void add_pin_limited(scene *s, int32_t a, int32_t b, double x, double y, double lower, double upper)
{
	scene_joint joint = begin_joint(s, CN_JOINT_REVOLUTE, a, b, x, y, x, y);
	cn_revolute_def def;
	joint.lower = lower;
	joint.upper = upper;
	cn_revolute_def_init(&def);
	set_base(s, &def.base, &joint);
	def.reference_angle_rad = (float)joint.reference;
	if (lower <= upper) {
		def.lower_angle_rad = (float)lower;
		def.upper_angle_rad = (float)upper;
	}
	def.motor_speed_radps = (float)s->motor_speed;
	def.motor_torque_max_Nm = (float)s->motor_max;
	keep_joint(s, &joint, cn_joint_create_revolute(s->world, &def, &joint.handle));
}

void add_pin(scene *s, int32_t a, int32_t b, double x, double y) { add_pin_limited(s, a, b, x, y, 1.0, -1.0); }

void add_weld(scene *s, int32_t a, int32_t b, double x, double y)
{
	scene_joint joint = begin_joint(s, CN_JOINT_FIXED, a, b, x, y, x, y);
	cn_fixed_def def;
	cn_fixed_def_init(&def);
	set_base(s, &def.base, &joint);
	def.reference_angle_rad = (float)joint.reference;
	keep_joint(s, &joint, cn_joint_create_fixed(s->world, &def, &joint.handle));
}

static void add_distance(scene *s, scene_joint *joint, double length, double hertz, double damping)
{
	cn_distance_def def;
	cn_distance_def_init(&def);
	set_base(s, &def.base, joint);
	def.length_m = (float)length;
	if (joint->lower <= joint->upper) {
		def.length_min_m = (float)joint->lower;
		def.length_max_m = (float)joint->upper;
	}
	if (hertz > 0.0) {
		def.base.flags |= CN_JOINT_SPRING;
		def.spring_hertz = (float)hertz;
		def.spring_damping_ratio = (float)damping;
	} else if (joint->lower == joint->upper) {
		def.base.flags &= ~(uint32_t)CN_JOINT_LIMIT;
	}
	keep_joint(s, joint, cn_joint_create_distance(s->world, &def, &joint->handle));
}

void add_rod(scene *s, int32_t a, int32_t b, double ax, double ay, double bx, double by)
{
	scene_joint joint = begin_joint(s, CN_JOINT_DISTANCE, a, b, ax, ay, bx, by);
	joint.lower = joint.upper = hypot(bx - ax, by - ay);
	add_distance(s, &joint, joint.lower, 0.0, 0.0);
}

void add_rope(scene *s, int32_t a, int32_t b, double ax, double ay, double bx, double by, double slack)
{
	scene_joint joint = begin_joint(s, CN_JOINT_DISTANCE, a, b, ax, ay, bx, by);
	joint.lower = 0.0;
	joint.upper = hypot(bx - ax, by - ay) * (1.0 + slack);
	add_distance(s, &joint, joint.upper, 0.0, 0.0);
}

void add_spring(scene *s, int32_t a, int32_t b, double ax, double ay, double bx, double by, double hertz, double damping, double give)
{
	scene_joint joint = begin_joint(s, CN_JOINT_DISTANCE, a, b, ax, ay, bx, by);
	double length = hypot(bx - ax, by - ay);
	if (give > 0.0) {
		joint.lower = length * (1.0 - give);
		joint.upper = length * (1.0 + give);
	}
	add_distance(s, &joint, length, hertz, damping);
}

static void set_axis(const scene *s, scene_joint *joint, double axis_x, double axis_y)
{
	double angle = angle_of(s, joint->a), length = hypot(axis_x, axis_y);
	joint->axis_x = (cos(angle) * axis_x + sin(angle) * axis_y) / length;
	joint->axis_y = (cos(angle) * axis_y - sin(angle) * axis_x) / length;
}

void add_slider(scene *s, int32_t a, int32_t b, double x, double y, double axis_x, double axis_y, double lower, double upper)
{
	scene_joint joint = begin_joint(s, CN_JOINT_PRISMATIC, a, b, x, y, x, y);
	cn_prismatic_def def;
	set_axis(s, &joint, axis_x, axis_y);
	joint.lower = lower;
	joint.upper = upper;
	cn_prismatic_def_init(&def);
	set_base(s, &def.base, &joint);
	def.axis.x = (float)joint.axis_x;
	def.axis.y = (float)joint.axis_y;
	def.reference_angle_rad = (float)joint.reference;
	if (lower <= upper) {
		def.lower_m = (float)lower;
		def.upper_m = (float)upper;
	}
	def.motor_speed_mps = (float)s->motor_speed;
	def.motor_force_max_N = (float)s->motor_max;
	keep_joint(s, &joint, cn_joint_create_prismatic(s->world, &def, &joint.handle));
}

void add_wheel(scene *s, int32_t a, int32_t b, double x, double y, double axis_x, double axis_y, double hertz, double damping, double travel)
{
	scene_joint joint = begin_joint(s, CN_JOINT_WHEEL, a, b, x, y, x, y);
	cn_wheel_def def;
	set_axis(s, &joint, axis_x, axis_y);
	joint.lower = -travel;
	joint.upper = travel;
	cn_wheel_def_init(&def);
	set_base(s, &def.base, &joint);
	def.base.flags |= CN_JOINT_SPRING;
	def.axis.x = (float)joint.axis_x;
	def.axis.y = (float)joint.axis_y;
	def.lower_m = (float)-travel;
	def.upper_m = (float)travel;
	def.motor_speed_radps = (float)s->motor_speed;
	def.motor_torque_max_Nm = (float)s->motor_max;
	def.spring_hertz = (float)hertz;
	def.spring_damping_ratio = (float)damping;
	keep_joint(s, &joint, cn_joint_create_wheel(s->world, &def, &joint.handle));
}

void add_gear(scene *s, int32_t a, int32_t b, double ratio)
{
	scene_joint joint = begin_joint(s, CN_JOINT_GEAR, a, b, 0.0, 0.0, 0.0, 0.0);
	cn_gear_def def;
	joint.ratio = ratio;
	joint.arm = s->bodies[b].reach;
	cn_gear_def_init(&def);
	set_base(s, &def.base, &joint);
	def.ratio = (float)ratio;
	def.phase_rad = (float)(s->bodies[b].angle - ratio * s->bodies[a].angle);
	joint.reference = (double)def.phase_rad;
	keep_joint(s, &joint, cn_joint_create_gear(s->world, &def, &joint.handle));
}

void add_pulley(scene *s, int32_t a, int32_t b, double gax, double gay, double gbx, double gby, double ratio)
{
	const scene_body *from = &s->bodies[a], *to = &s->bodies[b];
	scene_joint joint = begin_joint(s, CN_JOINT_PULLEY, a, b, from->x, from->y, to->x, to->y);
	cn_pulley_def def;
	if (s->drift_mps != 0.0)
		snprintf(s->refusal, sizeof s->refusal, "a pulley hangs in the world, which does not drift");
	joint.ground[0] = gax;
	joint.ground[1] = gay;
	joint.ground[2] = gbx;
	joint.ground[3] = gby;
	joint.ratio = ratio;
	joint.length = hypot(from->x - gax, from->y - gay) + ratio * hypot(to->x - gbx, to->y - gby);
	cn_pulley_def_init(&def);
	set_base(s, &def.base, &joint);
	def.ground_a_m.x = (float)gax;
	def.ground_a_m.y = (float)gay;
	def.ground_b_m.x = (float)gbx;
	def.ground_b_m.y = (float)gby;
	def.ratio = (float)ratio;
	def.length_m = (float)joint.length;
	keep_joint(s, &joint, cn_joint_create_pulley(s->world, &def, &joint.handle));
}

void add_groove(scene *s, int32_t a, int32_t b, double x, double y, double end_x, double end_y)
{
	scene_joint joint = begin_joint(s, CN_JOINT_GROOVE, a, b, x, y, x, y);
	cn_groove_def def;
	set_axis(s, &joint, end_x - x, end_y - y);
	cn_groove_def_init(&def);
	set_base(s, &def.base, &joint);
	joint.lower = 0.0;
	joint.upper = hypot(end_x - x, end_y - y);
	def.end_m.x = (float)(joint.ax + joint.upper * joint.axis_x);
	def.end_m.y = (float)(joint.ay + joint.upper * joint.axis_y);
	keep_joint(s, &joint, cn_joint_create_groove(s->world, &def, &joint.handle));
}

void add_ratchet(scene *s, int32_t a, int32_t b, double click)
{
	scene_joint joint = begin_joint(s, CN_JOINT_RATCHET, a, b, 0.0, 0.0, 0.0, 0.0);
	cn_ratchet_def def;
	cn_ratchet_def_init(&def);
	set_base(s, &def.base, &joint);
	def.click_rad = (float)click;
	keep_joint(s, &joint, cn_joint_create_ratchet(s->world, &def, &joint.handle));
}

void add_rotary_spring(scene *s, int32_t a, int32_t b, double hertz, double damping)
{
	scene_joint joint = begin_joint(s, CN_JOINT_ROTARY_SPRING, a, b, 0.0, 0.0, 0.0, 0.0);
	cn_rotary_spring_def def;
	cn_rotary_spring_def_init(&def);
	set_base(s, &def.base, &joint);
	def.rest_angle_rad = (float)joint.reference;
	def.hertz = (float)hertz;
	def.damping_ratio = (float)damping;
	keep_joint(s, &joint, cn_joint_create_rotary_spring(s->world, &def, &joint.handle));
}

void add_motor_to(scene *s, int32_t a, int32_t b, double x, double y, double force)
{
	scene_joint joint = begin_joint(s, CN_JOINT_MOTOR_TO, a, b, x, y, x, y);
	cn_motor_def def;
	cn_motor_def_init(&def);
	set_base(s, &def.base, &joint);
	def.base.force_max_N = def.base.torque_max_Nm = (float)force;
	def.angle_rad = (float)joint.reference;
	keep_joint(s, &joint, cn_joint_create_motor(s->world, &def, &joint.handle));
}

/* ---- constraints on one body ---- */

static void set_constraint_spring(const scene *s, float *hertz, float *damping_ratio)
{
	if (s->joint_hertz <= 0.0)
		return;
	*hertz = (float)s->joint_hertz;
	*damping_ratio = 0.5f;
}

void add_angle_constraint(scene *s, int32_t body, double lower, double upper)
{
	scene_joint joint = begin_joint(s, ANGLE_CONSTRAINT, WORLD, body, 0.0, 0.0, 0.0, 0.0);
	cn_angle_constraint_def def;
	cn_constraint constraint;
	if (s->drift_mps != 0.0)
		return;
	cn_angle_constraint_def_init(&def);
	def.body = s->bodies[body].handle;
	joint.lower = lower;
	joint.upper = upper;
	def.lower_rad = (float)lower;
	def.upper_rad = (float)upper;
	set_constraint_spring(s, &def.hertz, &def.damping_ratio);
	keep_joint(s, &joint, cn_constraint_create_angle(s->world, &def, &constraint));
}

void add_line_constraint(scene *s, int32_t body, double x, double y, double axis_x, double axis_y, double tolerance, double lower, double upper)
{
	scene_joint joint = begin_joint(s, LINE_CONSTRAINT, WORLD, body, x, y, x, y);
	cn_line_constraint_def def;
	cn_constraint constraint;
	if (s->drift_mps != 0.0)
		return;
	cn_line_constraint_def_init(&def);
	def.body = s->bodies[body].handle;
	set_axis(s, &joint, axis_x, axis_y);
	joint.tolerance = tolerance;
	joint.lower = lower;
	joint.upper = upper;
	def.anchor_m.x = (float)joint.bx;
	def.anchor_m.y = (float)joint.by;
	def.origin_m.x = (float)x;
	def.origin_m.y = (float)y;
	def.axis.x = (float)joint.axis_x;
	def.axis.y = (float)joint.axis_y;
	def.tolerance_m = (float)tolerance;
	if (lower <= upper) {
		def.flags |= CN_CONSTRAINT_LIMIT;
		def.lower_m = (float)lower;
		def.upper_m = (float)upper;
	}
	set_constraint_spring(s, &def.hertz, &def.damping_ratio);
	keep_joint(s, &joint, cn_constraint_create_line(s->world, &def, &constraint));
}
