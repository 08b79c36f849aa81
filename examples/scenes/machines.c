/*
 * examples/scenes/machines.c - one small exhibit for every joint, every constraint on one body and the
 * special surfaces, on a grid of shelves. Everything in an exhibit is placed from the middle of its
 * shelf; what moves from outside (motors that turn back, targets, pushes) is a function of the step
 * index alone.
 */
#include "scenes/build.h"

#define MACHINE_EXHIBITS 12
#define CONSTRAINT_EXHIBITS 10
#define CELL_WIDTH_M 4.6f
#define CELL_HEIGHT_M 3.6f

/* An exhibit's place: its origin is the middle of the top of its shelf. */
typedef struct place {
	scene_run *run;
	float x_m;
	float y_m;
} place;

static cn_vec2 at(const place *p, float x_m, float y_m) { return scene_vec(p->x_m + x_m, p->y_m + y_m); }

/* A shelf of 4.2 m; exhibits run from the upper left to the lower right. */
static place open_exhibit(scene_run *run, int32_t index, int32_t count, int32_t columns)
{
	place p;
	int32_t rows = (count + columns - 1) / columns;
	p.run = run;
	p.x_m = CELL_WIDTH_M * ((float)(index % columns) - 0.5f * (float)(columns - 1));
	p.y_m = CELL_HEIGHT_M * (float)(rows - 1 - index / columns);
	cn_shape_def shelf = scene_surface(scene_body(run, CN_BODY_STATIC, p.x_m, p.y_m - 0.06f), 1.0f, 0.6f, 0.0f);
	scene_box(run, &shelf, 2.1f, 0.06f, 0.0f);
	return p;
}

/* ------------------------------------------------------------------ words of this file */

static cn_body put_box(const place *p, float x_m, float y_m, float half_width_m, float half_height_m)
{
	return scene_simple_box(p->run, p->x_m + x_m, p->y_m + y_m, half_width_m, half_height_m);
}

static cn_body put_ball(const place *p, float x_m, float y_m, float radius_m, float density_kgpm2)
{
	cn_body body = scene_body(p->run, CN_BODY_DYNAMIC, p->x_m + x_m, p->y_m + y_m);
	cn_shape_def def = scene_surface(body, density_kgpm2, 0.6f, 0.0f);
	scene_circle(p->run, &def, radius_m);
	return body;
}

static cn_body put_wall(const place *p, float x_m, float y_m, float half_width_m, float half_height_m)
{
	cn_body body = scene_body(p->run, CN_BODY_STATIC, p->x_m + x_m, p->y_m + y_m);
	cn_shape_def def = scene_surface(body, 1.0f, 0.6f, 0.0f);
	scene_box(p->run, &def, half_width_m, half_height_m, 0.0f);
	return body;
}

static void give_velocity(const place *p, cn_body body, float x_mps, float y_mps, float turn_radps)
{
	scene_check(p->run, cn_body_set_velocity(p->run->world, body, x_mps, y_mps, turn_radps));
}

/* A point of the exhibit in the frame of a body, 0: of the world. */
static cn_vec2 anchor_in(const place *p, cn_body body, float x_m, float y_m)
{
	cn_vec2 point = at(p, x_m, y_m);
	if (body != 0)
		scene_check(p->run, cn_body_get_local_point(p->run->world, body, point.x, point.y, &point));
	return point;
}

/* Two bodies joined at points of the exhibit. */
static void connect(const place *p, cn_joint_base *base, cn_body a, cn_vec2 a_m, cn_body b, cn_vec2 b_m)
{
	base->body_a = a;
	base->body_b = b;
	base->anchor_a_m = anchor_in(p, a, a_m.x, a_m.y);
	base->anchor_b_m = anchor_in(p, b, b_m.x, b_m.y);
}

static void connect_at(const place *p, cn_joint_base *base, cn_body a, cn_body b, float x_m, float y_m)
{
	connect(p, base, a, scene_vec(x_m, y_m), b, scene_vec(x_m, y_m));
}

/* A hinge between a body and the world, with a motor if torque_Nm > 0. */
static cn_joint pin(const place *p, cn_body body, float x_m, float y_m, float speed_radps, float torque_Nm)
{
	cn_revolute_def def;
	cn_revolute_def_init(&def);
	connect_at(p, &def.base, 0, body, x_m, y_m);
	if (torque_Nm > 0.0f)
		def.base.flags |= CN_JOINT_MOTOR;
	def.motor_speed_radps = speed_radps;
	def.motor_torque_max_Nm = torque_Nm;
	return scene_join(p->run, &def);
}

/* ------------------------------------------------------------------ machines: what the steps move */

typedef struct machines {
	cn_joint slider;
	cn_joint wheels[2];
	cn_joint motor;
	cn_joint mouse;
	cn_body mouse_box;
	cn_body pulley_box;
	cn_body ratchet_wheel;
	place motor_place;
	place mouse_place;
} machines;

/* 1 and -1 in turn, each for so many steps. */
static float back_and_forth(int32_t step_index, int32_t steps) { return step_index / steps % 2 == 0 ? 1.0f : -1.0f; }

/* ------------------------------------------------------------------ fixed */

/* Four boxes welded to each other and to the world; angular_hertz CN_DEFAULT: rigid. */
static void add_cantilever(const place *p, float y_m, float angular_hertz)
{
	cn_body last = 0;
	for (int32_t i = 0; i < 4; ++i) {
		float left = -1.8f + 0.9f * (float)i;
		cn_body box = put_box(p, left + 0.45f, y_m, 0.43f, 0.13f);
		cn_fixed_def def;
		cn_joint made;
		cn_fixed_def_init(&def);
		connect_at(p, &def.base, last, box, left, y_m);
		def.angular_hertz = angular_hertz;
		def.angular_damping_ratio = 0.3f;
		if (p->run->result == CN_OK)
			scene_check(p->run, cn_joint_create_fixed(p->run->world, &def, &made));
		last = box;
	}
}

static void add_fixed(const place *p)
{
	put_wall(p, -1.9f, 1.5f, 0.08f, 1.5f);
	add_cantilever(p, 2.7f, CN_DEFAULT);
	add_cantilever(p, 1.7f, 10.0f);
}

/* ------------------------------------------------------------------ distance: rod, spring, rope */

static cn_distance_def distance_between(const place *p, float x_m, float y_m, cn_body body, cn_vec2 body_m, float length_m)
{
	cn_distance_def def;
	cn_distance_def_init(&def);
	connect(p, &def.base, 0, scene_vec(x_m, y_m), body, body_m);
	def.length_m = length_m;
	return def;
}

static void join_distance(const place *p, const cn_distance_def *def)
{
	cn_joint made;
	scene_check(p->run, cn_joint_create_distance(p->run->world, def, &made));
}

static void add_distances(const place *p)
{
	put_wall(p, 0.0f, 3.05f, 2.0f, 0.05f);
	cn_distance_def rod = distance_between(p, -1.3f, 3.0f, put_ball(p, -0.58f, 2.04f, 0.2f, 1.0f), scene_vec(-0.58f, 2.04f), 1.2f);
	join_distance(p, &rod);

	cn_distance_def spring = distance_between(p, 0.15f, 3.0f, put_box(p, 0.15f, 2.1f, 0.25f, 0.2f), scene_vec(0.15f, 2.3f), 1.0f);
	spring.base.flags |= CN_JOINT_SPRING;
	spring.spring_hertz = 0.9f;
	join_distance(p, &spring);

	cn_body ball = put_ball(p, 1.2f, 2.7f, 0.2f, 1.0f);
	cn_distance_def rope = distance_between(p, 1.4f, 3.0f, ball, scene_vec(1.2f, 2.7f), 1.5f);
	rope.base.flags |= CN_JOINT_LIMIT;
	rope.length_min_m = 0.0f;
	rope.length_max_m = 1.5f;
	join_distance(p, &rope);
	give_velocity(p, ball, 0.9f, 0.0f, 0.0f);
}

/* ------------------------------------------------------------------ revolute: limits, motor */

static void add_revolutes(const place *p)
{
	cn_revolute_def def;
	cn_body flap = put_box(p, -1.0f, 2.0f, 0.1f, 0.7f);
	cn_revolute_def_init(&def);
	connect_at(p, &def.base, 0, flap, -1.0f, 2.6f);
	def.base.flags |= CN_JOINT_LIMIT;
	def.lower_angle_rad = -0.6f;
	def.upper_angle_rad = 0.9f;
	scene_join(p->run, &def);
	give_velocity(p, flap, 4.2f, 0.0f, 7.0f);

	pin(p, put_box(p, 1.0f, 1.4f, 0.75f, 0.12f), 1.0f, 1.4f, 2.5f, 40.0f);
}

/* ------------------------------------------------------------------ prismatic: a driven slide, a sprung table */

static cn_joint slide(const place *p, cn_body body, cn_vec2 from_m, cn_vec2 axis, float lower_m, float upper_m, uint32_t flags)
{
	cn_prismatic_def def;
	cn_joint joint = 0;
	cn_prismatic_def_init(&def);
	connect_at(p, &def.base, 0, body, from_m.x, from_m.y);
	def.base.flags |= CN_JOINT_LIMIT | flags;
	def.axis = axis;
	def.lower_m = lower_m;
	def.upper_m = upper_m;
	def.motor_force_max_N = 30.0f;
	def.spring_hertz = 1.5f;
	def.spring_damping_ratio = 0.1f;
	scene_check(p->run, cn_joint_create_prismatic(p->run->world, &def, &joint));
	return joint;
}

static void add_prismatics(const place *p, machines *m)
{
	cn_body driven = put_box(p, -1.5f, 2.3f, 0.25f, 0.2f);
	m->slider = slide(p, driven, scene_vec(-1.5f, 2.3f), scene_vec(3.0f, 0.5f), 0.0f, 3.0f, CN_JOINT_MOTOR);
	cn_body table = put_box(p, 0.0f, 0.7f, 0.8f, 0.1f);
	slide(p, table, scene_vec(0.0f, 0.7f), scene_vec(0.0f, 1.0f), -0.4f, 0.5f, CN_JOINT_SPRING);
	put_ball(p, 0.0f, 1.6f, 0.22f, 1.0f);
}

/* ------------------------------------------------------------------ wheel: a cart on bumps */

static cn_joint add_wheel(const place *p, cn_body cart, float x_m)
{
	cn_wheel_def def;
	cn_joint joint = 0;
	cn_wheel_def_init(&def);
	connect_at(p, &def.base, cart, put_ball(p, x_m, 0.32f, 0.3f, 1.0f), x_m, 0.32f);
	def.base.flags |= CN_JOINT_SPRING | CN_JOINT_LIMIT | CN_JOINT_MOTOR;
	def.axis = scene_vec(0.0f, 1.0f);
	def.lower_m = -0.2f;
	def.upper_m = 0.2f;
	def.motor_torque_max_Nm = 4.0f;
	def.spring_hertz = 3.0f;
	scene_check(p->run, cn_joint_create_wheel(p->run->world, &def, &joint));
	return joint;
}

static void add_cart(const place *p, machines *m)
{
	for (int32_t i = 0; i < 5; ++i)
		put_wall(p, -1.4f + 0.7f * (float)i, 0.0f, 0.1f, 0.05f + 0.01f * (float)i);
	put_wall(p, -2.05f, 0.25f, 0.05f, 0.25f);
	put_wall(p, 2.05f, 0.25f, 0.05f, 0.25f);
	cn_body cart = put_box(p, -0.9f, 0.7f, 0.75f, 0.15f);
	m->wheels[0] = add_wheel(p, cart, -1.4f);
	m->wheels[1] = add_wheel(p, cart, -0.4f);
	put_box(p, -0.9f, 1.05f, 0.2f, 0.2f);
}

/* ------------------------------------------------------------------ motor and mouse */

static void add_motor(const place *p, machines *m)
{
	cn_motor_def def;
	cn_motor_def_init(&def);
	cn_body body = put_box(p, -1.0f, 0.8f, 0.35f, 0.2f);
	connect(p, &def.base, 0, scene_vec(0.0f, 1.6f), body, scene_vec(-1.0f, 0.8f));
	def.base.force_max_N = 60.0f;
	def.base.torque_max_Nm = 20.0f;
	def.offset_m = scene_vec(-1.0f, -0.8f);
	def.hertz = 2.0f;
	scene_check(p->run, cn_joint_create_motor(p->run->world, &def, &m->motor));
	m->motor_place = *p;
}

/* Around the corners of a rectangle, one a second, turned by a quarter of a turn at each. */
static void drive_motor(scene_run *run, const machines *m, int32_t step_index)
{
	static const float corners[4][2] = {{-1.0f, -0.8f}, {1.0f, -0.8f}, {1.0f, 0.8f}, {-1.0f, 0.8f}};
	cn_motor_def def;
	int32_t turn = step_index / 60;
	if (step_index % 60 != 0 || !scene_check(run, cn_joint_get_motor_to(run->world, m->motor, &def)))
		return;
	def.offset_m = scene_vec(corners[turn % 4][0], corners[turn % 4][1]);
	def.angle_rad = 0.5f * SCENE_PI * (float)(turn % 4 == 3 ? -1 : turn % 4);
	scene_check(run, cn_joint_set_motor_to(run->world, m->motor, &def));
}

static cn_vec2 mouse_target(const place *p, int32_t step_index)
{
	double angle = 2.0 * 3.14159265358979323846 * (double)step_index / 150.0;
	return at(p, -1.1f * scene_cosine(angle), 1.6f + 1.1f * scene_sine(angle));
}

static void add_mouse(const place *p, machines *m)
{
	cn_mouse_def def;
	cn_mouse_def_init(&def);
	cn_body body = put_box(p, -0.9f, 1.4f, 0.3f, 0.3f);
	connect_at(p, &def.base, 0, body, -1.15f, 1.65f);
	def.base.force_max_N = 100.0f;
	def.target_m = mouse_target(p, 0);
	def.hertz = 3.0f;
	scene_check(p->run, cn_joint_create_mouse(p->run->world, &def, &m->mouse));
	m->mouse_place = *p;
	put_wall(p, -2.05f, 0.6f, 0.05f, 0.6f);
	put_wall(p, 2.05f, 0.6f, 0.05f, 0.6f);
	for (int32_t i = 0; i < 2; ++i)
		put_box(p, 0.2f, 0.2f + 0.4f * (float)i, 0.2f, 0.2f);
}

/* ------------------------------------------------------------------ gear, pulley, ratchet, rotary spring */

/* The small disc is driven; the large one turns against it at half its speed. */
static void add_gear(const place *p)
{
	cn_gear_def def;
	cn_joint made;
	cn_body small = put_ball(p, -1.0f, 1.6f, 0.5f, 1.0f), large = put_ball(p, 0.55f, 1.6f, 1.0f, 1.0f);
	pin(p, small, -1.0f, 1.6f, 3.0f, 40.0f);
	pin(p, large, 0.55f, 1.6f, 0.0f, 0.0f);
	cn_gear_def_init(&def);
	connect(p, &def.base, small, scene_vec(-1.0f, 1.6f), large, scene_vec(0.55f, 1.6f));
	def.ratio = -0.5f;
	scene_check(p->run, cn_joint_create_gear(p->run->world, &def, &made));
}

static void add_pulley(const place *p, machines *m)
{
	cn_pulley_def def;
	cn_joint made;
	cn_body left = put_box(p, -0.9f, 1.2f, 0.35f, 0.35f), right = put_box(p, 0.9f, 1.2f, 0.35f, 0.35f);
	cn_pulley_def_init(&def);
	connect(p, &def.base, left, scene_vec(-0.9f, 1.55f), right, scene_vec(0.9f, 1.55f));
	def.ground_a_m = at(p, -0.9f, 3.0f);
	def.ground_b_m = at(p, 0.9f, 3.0f);
	def.length_m = 2.9f;
	scene_check(p->run, cn_joint_create_pulley(p->run->world, &def, &made));
	m->pulley_box = left;
}

static void add_ratchet(const place *p, machines *m)
{
	cn_ratchet_def def;
	cn_joint made;
	cn_body wheel = put_ball(p, 0.0f, 1.6f, 0.8f, 1.0f);
	cn_shape_def handle = scene_surface(wheel, 1.0f, 0.6f, 0.0f);
	scene_offset_box(p->run, &handle, scene_vec(1.0f, 0.0f), 0.3f, 0.08f);
	pin(p, wheel, 0.0f, 1.6f, 0.0f, 0.0f);
	cn_ratchet_def_init(&def);
	connect_at(p, &def.base, 0, wheel, 0.0f, 1.6f);
	def.click_rad = SCENE_PI / 6.0f;
	scene_check(p->run, cn_joint_create_ratchet(p->run->world, &def, &made));
	m->ratchet_wheel = wheel;
}

static void add_rotary_spring(const place *p)
{
	cn_rotary_spring_def def;
	cn_joint made;
	cn_body bar = put_box(p, 0.0f, 1.6f, 1.2f, 0.12f);
	pin(p, bar, 0.0f, 1.6f, 0.0f, 0.0f);
	cn_rotary_spring_def_init(&def);
	connect_at(p, &def.base, 0, bar, 0.0f, 1.6f);
	def.hertz = 0.5f;
	def.damping_ratio = 0.02f;
	scene_check(p->run, cn_joint_create_rotary_spring(p->run->world, &def, &made));
	give_velocity(p, bar, 0.0f, 0.0f, 3.5f);
}

/* ------------------------------------------------------------------ groove: a crank moves a slotted lever */

static void add_groove(const place *p)
{
	cn_groove_def def;
	cn_joint made;
	cn_body crank = put_ball(p, 0.0f, 1.1f, 0.65f, 1.0f), lever = put_box(p, 0.0f, 1.75f, 0.14f, 1.35f);
	pin(p, crank, 0.0f, 1.1f, 2.5f, 60.0f);
	pin(p, lever, 0.0f, 3.0f, 0.0f, 0.0f);
	cn_groove_def_init(&def);
	connect(p, &def.base, lever, scene_vec(0.0f, 2.2f), crank, scene_vec(0.0f, 1.6f));
	def.end_m = anchor_in(p, lever, 0.0f, 0.45f);
	scene_check(p->run, cn_joint_create_groove(p->run->world, &def, &made));
}

/* ------------------------------------------------------------------ machines */

void scene_create_machines(scene_run *run)
{
	place p[MACHINE_EXHIBITS];
	machines *m = (machines *)scene_memory(run, sizeof(machines));
	if (m == NULL)
		return;
	for (int32_t i = 0; i < MACHINE_EXHIBITS; ++i)
		p[i] = open_exhibit(run, i, MACHINE_EXHIBITS, 4);
	add_fixed(&p[0]);
	add_distances(&p[1]);
	add_revolutes(&p[2]);
	add_prismatics(&p[3], m);
	add_cart(&p[4], m);
	add_motor(&p[5], m);
	add_mouse(&p[6], m);
	add_gear(&p[7]);
	add_pulley(&p[8], m);
	add_ratchet(&p[9], m);
	add_rotary_spring(&p[10]);
	add_groove(&p[11]);
}

void scene_step_machines(scene_run *run, int32_t step_index)
{
	const machines *m = (const machines *)run->memory;
	cn_vec2 target = mouse_target(&m->mouse_place, step_index);
	drive_motor(run, m, step_index);
	scene_check(run, cn_joint_set_target(run->world, m->mouse, target.x, target.y));
	scene_check(run, cn_joint_set_motor(run->world, m->slider, 1.8f * back_and_forth(step_index, 120), 30.0f));
	for (int32_t i = 0; i < 2; ++i)
		scene_check(run, cn_joint_set_motor(run->world, m->wheels[i], -4.0f * back_and_forth(step_index, 100), 4.0f));
	scene_check(run, cn_body_apply_force(run->world, m->pulley_box, 0.0f, -0.8f * back_and_forth(step_index + 45, 90)));
	scene_check(run, cn_body_apply_torque(run->world, m->ratchet_wheel, 8.0f * back_and_forth(step_index, 25)));
}

/* ------------------------------------------------------------------ constraints: what the steps move */

#define JUMPERS 3
#define BEADS 3
#define PARCELS 3

typedef struct exhibits {
	cn_body jumpers[JUMPERS];
	cn_body seesaw_ball;
	cn_body beads[BEADS];
	cn_body parcels[PARCELS];
	place seesaw_place;
	place conveyor_place;
} exhibits;

/* ------------------------------------------------------------------ filter, breaking joint */

/* Two boxes slide to and fro between walls, through each other. */
static void add_filter(const place *p)
{
	cn_filter_joint_def def;
	cn_joint made;
	cn_body boxes[2];
	for (int32_t i = 0; i < 2; ++i) {
		float side = i == 0 ? -1.0f : 1.0f;
		cn_body wall = scene_body(p->run, CN_BODY_STATIC, p->x_m + 2.05f * side, p->y_m + 0.5f);
		cn_shape_def bouncy = scene_surface(wall, 1.0f, 0.0f, 1.0f);
		scene_box(p->run, &bouncy, 0.05f, 0.5f, 0.0f);
		boxes[i] = scene_body(p->run, CN_BODY_DYNAMIC, p->x_m + 1.2f * side, p->y_m + 0.4f + 0.05f * side);
		cn_shape_def smooth = scene_surface(boxes[i], 1.0f, 0.0f, 0.0f);
		scene_box(p->run, &smooth, 0.4f, 0.4f + 0.05f * side, 0.0f);
		give_velocity(p, boxes[i], -2.0f * side, 0.0f, 0.0f);
	}
	cn_filter_joint_def_init(&def);
	connect(p, &def.base, boxes[0], scene_vec(-1.2f, 0.35f), boxes[1], scene_vec(1.2f, 0.45f));
	scene_check(p->run, cn_joint_create_filter(p->run->world, &def, &made));
}

/* Hinged planks carry a light ball and break under a heavy one. */
static void add_breaking(const place *p)
{
	cn_body last = 0;
	for (int32_t i = 0; i <= 6; ++i) {
		float left = -1.8f + 0.6f * (float)i;
		cn_body plank = i < 6 ? put_box(p, left + 0.3f, 1.5f, 0.28f, 0.07f) : 0;
		cn_revolute_def def;
		cn_revolute_def_init(&def);
		connect_at(p, &def.base, last, plank, left, 1.5f);
		def.base.flags |= CN_JOINT_BREAKS;
		def.base.break_force_N = 60.0f;
		scene_join(p->run, &def);
		last = plank;
	}
	put_wall(p, -1.95f, 0.75f, 0.12f, 0.75f);
	put_wall(p, 1.95f, 0.75f, 0.12f, 0.75f);
	put_ball(p, -0.4f, 1.9f, 0.2f, 1.0f);
	give_velocity(p, put_ball(p, 0.4f, 2.9f, 0.35f, 6.0f), 0.0f, 4.0f, 0.0f);
}

/* ------------------------------------------------------------------ angle and line constraints */

static void limit_angle(const place *p, cn_body body, float lower_rad, float upper_rad)
{
	cn_angle_constraint_def def;
	cn_constraint made;
	cn_angle_constraint_def_init(&def);
	def.body = body;
	def.lower_rad = lower_rad;
	def.upper_rad = upper_rad;
	scene_check(p->run, cn_constraint_create_angle(p->run->world, &def, &made));
}

/* Two balls on slopes: the upper one rolls, the lower one keeps its angle and slides. */
static void add_locked_ball(const place *p)
{
	for (int32_t i = 0; i < 2; ++i) {
		float y = 0.1f + 1.4f * (float)i;
		cn_shape_def slope = scene_surface(scene_body(p->run, CN_BODY_STATIC, p->x_m, p->y_m + y), 1.0f, 0.3f, 0.0f);
		scene_edge(p->run, &slope, scene_vec(-1.9f, 0.9f), scene_vec(1.5f, 0.0f));
		scene_edge(p->run, &slope, scene_vec(1.5f, 0.0f), scene_vec(1.6f, 0.8f));
		cn_body ball = scene_body(p->run, CN_BODY_DYNAMIC, p->x_m - 1.6f, p->y_m + y + 1.2f);
		cn_shape_def def = scene_surface(ball, 1.0f, 0.3f, 0.0f);
		def.material.dynamic_friction = 0.2f;
		scene_circle(p->run, &def, 0.28f);
		if (i == 0)
			limit_angle(p, ball, 0.0f, 0.0f);
	}
}

/* The ball is thrown up again from either side. */
static void add_seesaw(const place *p, exhibits *e)
{
	cn_body bar = put_box(p, 0.0f, 1.2f, 1.7f, 0.08f);
	put_wall(p, 0.0f, 0.5f, 0.08f, 0.5f);
	put_wall(p, -2.05f, 0.6f, 0.05f, 0.6f);
	put_wall(p, 2.05f, 0.6f, 0.05f, 0.6f);
	pin(p, bar, 0.0f, 1.2f, 0.0f, 0.0f);
	limit_angle(p, bar, -0.3f, 0.4f);
	e->seesaw_ball = put_ball(p, -1.2f, 2.8f, 0.2f, 1.0f);
	e->seesaw_place = *p;
}

static cn_body put_bead(const place *p, float y_m, float tolerance_m, float hertz)
{
	cn_line_constraint_def def;
	cn_constraint made;
	cn_line_constraint_def_init(&def);
	def.body = put_ball(p, -1.4f, y_m, 0.2f, 1.0f);
	def.origin_m = at(p, 0.0f, y_m - 0.4f);
	def.axis = scene_vec(3.5f, -1.0f);
	def.flags |= CN_CONSTRAINT_LIMIT;
	def.lower_m = -1.9f;
	def.upper_m = 1.6f;
	def.tolerance_m = tolerance_m;
	def.hertz = hertz;
	def.damping_ratio = 0.05f;
	scene_check(p->run, cn_constraint_create_line(p->run->world, &def, &made));
	return def.body;
}

/* Beads on a rigid line, on one with free play and on a springy one. */
static void add_beads(const place *p, exhibits *e)
{
	e->beads[0] = put_bead(p, 3.0f, 0.0f, CN_DEFAULT);
	e->beads[1] = put_bead(p, 2.1f, 0.12f, CN_DEFAULT);
	e->beads[2] = put_bead(p, 1.2f, 0.0f, 2.0f);
}

/* ------------------------------------------------------------------ surfaces */

/* Positive: the top of the belt moves to +x. */
static void put_belt(const place *p, float x_m, float y_m, float speed_mps)
{
	cn_shape_def belt = scene_surface(scene_body(p->run, CN_BODY_STATIC, p->x_m + x_m, p->y_m + y_m), 1.0f, 0.8f, 0.0f);
	belt.material.tangent_speed_mps = speed_mps;
	scene_capsule(p->run, &belt, scene_vec(-1.1f, 0.0f), scene_vec(1.1f, 0.0f), 0.12f);
}

static void add_conveyor(const place *p, exhibits *e)
{
	put_belt(p, -0.7f, 2.1f, 1.0f);
	put_belt(p, 0.5f, 1.0f, -1.0f);
	put_wall(p, -2.05f, 0.4f, 0.05f, 0.4f);
	for (int32_t i = 0; i < PARCELS; ++i)
		e->parcels[i] = put_box(p, -1.6f + 0.7f * (float)i, 2.4f, 0.2f, 0.15f);
	e->conveyor_place = *p;
}

/* Equal balls at equal speed; each floor's ball has more rolling resistance than the one below. */
static void add_rolling(const place *p)
{
	for (int32_t i = 0; i < 3; ++i) {
		float y = 1.1f * (float)i;
		if (i > 0)
			put_wall(p, 0.0f, y - 0.05f, 2.0f, 0.05f);
		put_wall(p, 1.95f, y + 0.15f, 0.05f, 0.15f);
		cn_body ball = scene_body(p->run, CN_BODY_DYNAMIC, p->x_m - 1.6f, p->y_m + y + 0.25f);
		cn_shape_def def = scene_surface(ball, 1.0f, 0.6f, 0.0f);
		def.material.rolling_resistance = 0.02f * (float)i;
		scene_circle(p->run, &def, 0.25f);
		give_velocity(p, ball, 1.8f, 0.0f, -1.8f / 0.25f);
	}
}

static void add_one_way(const place *p, exhibits *e)
{
	for (int32_t i = 0; i < 2; ++i) {
		cn_body shelf = scene_body(p->run, CN_BODY_STATIC, p->x_m, p->y_m + 1.1f + 1.0f * (float)i);
		cn_shape_def def = scene_surface(shelf, 1.0f, 0.6f, 0.0f);
		def.flags |= CN_SHAPE_ONE_WAY;
		scene_box(p->run, &def, 1.6f - 0.6f * (float)i, 0.05f, 0.0f);
	}
	for (int32_t i = 0; i < JUMPERS; ++i)
		e->jumpers[i] = put_box(p, -0.9f + 0.9f * (float)i, 0.2f, 0.2f, 0.2f);
}

/* What is inside of the region floats up (see lift_what_is_inside). */
static void add_sensor(const place *p)
{
	cn_shape_def def = scene_surface(scene_body(p->run, CN_BODY_STATIC, p->x_m, p->y_m + 0.9f), 1.0f, 0.0f, 0.0f);
	def.flags |= CN_SHAPE_SENSOR;
	scene_box(p->run, &def, 1.6f, 0.6f, 0.0f);
	for (int32_t i = 0; i < 3; ++i)
		put_ball(p, -1.0f + 1.0f * (float)i, 2.0f + 0.35f * (float)i, 0.2f, 1.0f);
}

static void add_bouncing(const place *p)
{
	for (int32_t i = 0; i < 4; ++i) {
		cn_body ball = scene_body(p->run, CN_BODY_DYNAMIC, p->x_m - 1.5f + 1.0f * (float)i, p->y_m + 2.6f);
		cn_shape_def def = scene_surface(ball, 1.0f, 0.6f, 0.3f * (float)i);
		scene_circle(p->run, &def, 0.25f);
	}
}

/* ------------------------------------------------------------------ constraints */

void scene_create_constraints(scene_run *run)
{
	place p[CONSTRAINT_EXHIBITS];
	exhibits *e = (exhibits *)scene_memory(run, sizeof(exhibits));
	if (e == NULL)
		return;
	for (int32_t i = 0; i < CONSTRAINT_EXHIBITS; ++i)
		p[i] = open_exhibit(run, i, CONSTRAINT_EXHIBITS, 5);
	add_filter(&p[0]);
	add_breaking(&p[1]);
	add_locked_ball(&p[2]);
	add_seesaw(&p[3], e);
	add_beads(&p[4], e);
	add_conveyor(&p[5], e);
	add_rolling(&p[6]);
	add_one_way(&p[7], e);
	add_sensor(&p[8]);
	add_bouncing(&p[9]);
}

/* Gravity turns around for bodies in the region. */
static void lift_what_is_inside(scene_run *run)
{
	const cn_sensor_event *events = NULL;
	int32_t count = 0;
	if (!scene_check(run, cn_world_sensor_events(run->world, &events, &count)))
		return;
	for (int32_t i = 0; i < count; ++i) {
		float scale = events[i].kind == CN_EVENT_ENTER ? -0.6f : 1.0f;
		if (events[i].kind == CN_EVENT_ENTER || events[i].kind == CN_EVENT_LEAVE)
			scene_check(run, cn_body_set_gravity_scale(run->world, events[i].visitor_body, scale));
	}
}

/* Puts a body at rest at a point of its exhibit. */
static void put_back(const place *p, cn_body body, float x_m, float y_m)
{
	cn_vec2 start = at(p, x_m, y_m);
	scene_check(p->run, cn_body_set_pose(p->run->world, body, start.x, start.y, 0.0f));
	give_velocity(p, body, 0.0f, 0.0f, 0.0f);
}

void scene_step_constraints(scene_run *run, int32_t step_index)
{
	const exhibits *e = (const exhibits *)run->memory;
	lift_what_is_inside(run);
	if (step_index % 40 == 20)
		scene_check(run, cn_body_set_velocity(run->world, e->jumpers[step_index / 40 % JUMPERS], 0.0f, 5.8f, 0.0f));
	if (step_index % 120 == 0 && step_index > 0)
		put_back(&e->seesaw_place, e->seesaw_ball, step_index / 120 % 2 == 0 ? -1.2f : 1.2f, 2.8f);
	if (step_index % 90 == 0 && step_index >= 270)
		put_back(&e->conveyor_place, e->parcels[(PARCELS - step_index / 90 % PARCELS) % PARCELS], -1.6f, 2.4f);
	for (int32_t i = 0; i < BEADS && step_index % 150 == 149; ++i)
		scene_check(run, cn_body_set_velocity(run->world, e->beads[i], -3.4f, 1.0f, 0.0f));
}
